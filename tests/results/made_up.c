// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/made_up.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

const made_up_size made_up_small = {
    .cracks = 1, .angles = 8, .samples = 40, .failed = 2, .radial_bins = 5, .histogram_bins = 6};
const made_up_size made_up_motion = {.cracks = 1, .times = 201, .probes = 2};
const made_up_size made_up_paper = {
    .cracks = 1, .angles = 72, .samples = 6000, .failed = 0, .radial_bins = 100, .histogram_bins = 60};

enum { TIPS_A_CRACK = 2, GRID = 17, FACE_POINTS = 41 };
static const double half_width = 2.5, half_crack = 0.5;

static void *make(size_t count, size_t size)
{
    void *memory = pdmc_calloc(count, size);
    if (!memory) abort();
    return memory;
}
#define NEW(count, type) ((type *)make((size_t)(count), sizeof(type)))

/// splitmix64, and the sum of twelve uniforms: good enough for a picture.
static double uniform(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static double normal(uint64_t *state)
{
    double sum = -6.0;
    for (int i = 0; i < 12; i++) sum += uniform(state);
    return sum;
}

static void make_study(pdmc_results *r)
{
    r->title = pdmc_strdup("Centre crack under uncertain tension");
    r->length_unit = pdmc_strdup("cm");
    r->force_unit = pdmc_strdup("N");
    r->time_unit = pdmc_strdup("ms");
    r->input = pdmc_strdup("title = \"Centre crack under uncertain tension\";\n");
    r->resolved = pdmc_strdup("title = \"Centre crack under uncertain tension\"; # resolved\n");
    r->date_and_time = pdmc_strdup("2024-05-17T09:30:00Z");
    r->pdmc_version = pdmc_strdup("0.1.0");
    r->git_sha1 = pdmc_strdup("0123456789abcdef0123456789abcdef01234567");
    r->seed = 20110614;
    r->status = PDMC_RUN_COMPLETE;
    r->confidence = 0.95;
    r->plate_width = r->plate_height = 2.0 * half_width;
    r->fracture_energy = 0.2;
    r->extension = 0.02;
    r->energy_horizon = 0.1;
    r->measure = PDMC_MEASURE_GRIFFITH;
    r->bonds = PDMC_BONDS_TENSILE;
    r->solver = (pdmc_solver_report){.nodes = 289,
                                     .unknowns = 650,
                                     .rows = 1391,
                                     .rank = 650,
                                     .condition = 4.7e10,
                                     .residual = 2.3e-4,
                                     .horizon = 0.1,
                                     .spacing = 0.3125};
    r->runtime = (pdmc_runtime){.assembly = 0.41,
                                .factorisation = 0.22,
                                .operators = 1.3,
                                .energy_rows = 0.35,
                                .sampling = 3.8,
                                .energy = 1.2,
                                .statistics = 0.6,
                                .output = 0.05,
                                .total = 6.7,
                                .peak_memory = 8.1e7,
                                .threads = 2};
}

static void make_tips(pdmc_results *r)
{
    r->cracks = NEW(4 * r->crack_count, double);
    r->tips = NEW(r->tip_count, pdmc_tip);
    for (int c = 0; c < r->crack_count; c++) {
        const double y = 1.2 * c;
        double *crack = &r->cracks[4 * c];
        crack[0] = -half_crack, crack[1] = y, crack[2] = half_crack, crack[3] = y;
        for (int end = 0; end < TIPS_A_CRACK && r->tip_count > 0; end++) {
            pdmc_tip *tip = &r->tips[TIPS_A_CRACK * c + end];
            snprintf(tip->name, sizeof tip->name, "%s.%s", c ? "upper" : "center", end ? "to" : "from");
            tip->position[0] = crack[2 * end], tip->position[1] = y;
            tip->direction = end ? 0.0 : pi;
            tip->stress_intensity[0] = 1.3229 - 0.08 * c, tip->stress_intensity[1] = end ? 0.021 : -0.021;
            tip->stress_intensity_error[0] = 4.1e-4, tip->stress_intensity_error[1] = 2.0e-5;
            tip->t_stress = -1.04, tip->t_stress_error = 0.003;
        }
    }
}

/// Energy over its largest value at an angle from straight ahead.
static double shape(double angle, pdmc_measure measure)
{
    return pow((1.0 + cos(angle)) / 2.0, measure == PDMC_MEASURE_BOND ? 1.53 : 2.1) + 0.02;
}

static void make_nominal(pdmc_results *r)
{
    const size_t size = (size_t)r->tip_count * (size_t)r->angle_count;
    r->angles = NEW(r->angle_count, double);
    r->nominal_bond_energy = NEW(size, double);
    r->nominal_bond_energy_tensile = NEW(size, double);
    r->nominal_griffith_energy = NEW(size, double);
    for (int k = 0; k < r->angle_count; k++) r->angles[k] = 2.0 * pi * k / r->angle_count;
    for (size_t i = 0; i < size; i++) {
        const double angle = r->angles[(int)i % r->angle_count] - r->tips[(int)i / r->angle_count].direction;
        r->nominal_bond_energy[i] = 0.13 * shape(angle, PDMC_MEASURE_BOND);
        r->nominal_bond_energy_tensile[i] = 0.94 * r->nominal_bond_energy[i];
        r->nominal_griffith_energy[i] = 0.175 * shape(angle, PDMC_MEASURE_GRIFFITH);
    }
}

/// Tension along y with Poisson's contraction, and a crack that opens as an ellipse.
static void make_field(pdmc_results *r)
{
    pdmc_displacement_field *field = &r->field;
    field->node_count = GRID * GRID;
    field->face_points = FACE_POINTS;
    field->node_position = NEW(2 * GRID * GRID, double);
    field->node_displacement = NEW(2 * GRID * GRID, double);
    field->face_position = NEW(2 * FACE_POINTS * r->crack_count, double);
    field->face_displacement = NEW(4 * FACE_POINTS * r->crack_count, double);
    for (int i = 0; i < GRID * GRID; i++) {
        const double x = half_width * (2.0 * (i % GRID) / (GRID - 1) - 1.0);
        const double y = half_width * (2.0 * (i / GRID) / (GRID - 1) - 1.0);
        field->node_position[2 * i] = x, field->node_position[2 * i + 1] = y;
        field->node_displacement[2 * i] = -1.0 / 3.0 * x;
        field->node_displacement[2 * i + 1] = y + 0.4 * copysign(exp(-2.0 * (x * x + y * y)), y) * (y != 0.0);
    }
    for (int i = 0; i < FACE_POINTS * r->crack_count; i++) {
        const double *crack = &r->cracks[i / FACE_POINTS * 4];
        const double s = -cos(pi * (i % FACE_POINTS) / (FACE_POINTS - 1)), x = half_crack * s,
                     opening = sqrt(1.0 - s * s);
        field->face_position[2 * i] = x, field->face_position[2 * i + 1] = crack[1];
        for (int side = 0; side < 2; side++) {
            field->face_displacement[4 * i + 2 * side] = -1.0 / 3.0 * x;
            field->face_displacement[4 * i + 2 * side + 1] = crack[1] + (side ? -1.0 : 1.0) * opening;
        }
    }
}

static double largest_of(const pdmc_results *r, int measure, int sample, int tip)
{
    double largest = NAN;
    for (int k = 0; k < r->angle_count; k++)
        largest = fmax(largest, r->energy[measure][(sample * r->tip_count + tip) * r->angle_count + k]);
    return largest;
}

static void make_sample(pdmc_results *r, int s, uint64_t *state)
{
    double modulus = 1.0;
    for (int b = 0; b < r->bin_count; b++) {
        const double z = normal(state), radius = (b + 0.5) / r->bin_count;
        r->micromodulus[s * r->bin_count + b] = 1.0 + 0.2 * z;
        modulus += 0.2 * z * 3.0 * radius * radius / r->bin_count;
    }
    r->load_factor[s] = 1.0 + 0.2 * normal(state);
    r->effective_modulus[s] = modulus;
    r->contraction[s] = 0.05 * uniform(state);
    const bool failed = s < r->failed_count;
    r->failure[s] = failed ? PDMC_SAMPLE_DIVERGED : PDMC_SAMPLE_OK;
    for (int t = 0; t < r->tip_count; t++) {
        const double kink = 0.12 * normal(state), scale = r->load_factor[s] * r->load_factor[s] / modulus;
        for (int mode = 0; mode < 2; mode++)
            r->stress_intensity[(s * r->tip_count + t) * 2 + mode] =
                failed ? NAN : r->load_factor[s] * r->tips[t].stress_intensity[mode];
        for (int k = 0; k < r->angle_count; k++) {
            const double angle = r->angles[k] - r->tips[t].direction + kink;
            const size_t i = ((size_t)s * (size_t)r->tip_count + (size_t)t) * (size_t)r->angle_count + (size_t)k;
            for (int m = 0; m < PDMC_MEASURES; m++)
                r->energy[m][i] = failed ? NAN : (m ? 0.175 : 0.13) * scale * shape(angle, (pdmc_measure)m);
        }
        for (int m = 0; m < PDMC_MEASURES; m++) r->largest_energy[m][s * r->tip_count + t] = largest_of(r, m, s, t);
        r->sample_fracture_energy[s * r->tip_count + t] = r->fracture_energy;
    }
}

static void make_samples(pdmc_results *r)
{
    const size_t samples = (size_t)r->sample_count, tips = (size_t)r->tip_count;
    uint64_t state = r->seed;
    r->load_factor = NEW(samples, double);
    r->micromodulus = NEW(samples * (size_t)r->bin_count, double);
    r->effective_modulus = NEW(samples, double);
    r->sample_fracture_energy = NEW(samples * tips, double);
    r->sample_solver = NEW(samples, uint8_t);
    r->contraction = NEW(samples, double);
    r->failure = NEW(samples, uint8_t);
    r->stress_intensity = NEW(samples * tips * 2, double);
    for (int m = 0; m < PDMC_MEASURES; m++) {
        r->energy[m] = NEW(samples * tips * (size_t)r->angle_count, double);
        r->largest_energy[m] = NEW(samples * tips, double);
    }
    for (int s = 0; s < r->sample_count; s++) make_sample(r, s, &state);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static pdmc_estimate about(double value, double error)
{
    return (pdmc_estimate){value, value - error, value + error};
}

static void make_moments(int n, const double x[], pdmc_estimate *mean, pdmc_estimate *deviation)
{
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < n; i++) sum += x[i];
    for (int i = 0; i < n; i++) squares += (x[i] - sum / n) * (x[i] - sum / n);
    const double s = n > 1 ? sqrt(squares / (n - 1)) : NAN;
    *mean = about(n > 0 ? sum / n : NAN, 1.96 * s / sqrt(n));
    *deviation = about(s, 1.96 * s / sqrt(2.0 * n));
}

static pdmc_estimate order_statistic(int n, const double sorted[], double p)
{
    const double half = 1.96 * sqrt(n * p * (1.0 - p));
    const int at = (int)ceil(n * p) - 1, low = (int)floor(n * p - half), high = (int)ceil(n * p + half);
    return (pdmc_estimate){n > 0 ? sorted[at] : NAN, low < 0 ? -INFINITY : sorted[low],
                           high >= n ? INFINITY : sorted[high]};
}

static void make_histogram(int n, const double sorted[], int bins, double edges[], int64_t counts[],
                           pdmc_estimate density[])
{
    const double low = n > 0 ? sorted[n / 1000] : 0.0, high = n > 0 ? sorted[n - 1 - n / 1000] : 1.0;
    const double width = (high - low) / bins;
    for (int b = 0; b <= bins; b++) edges[b] = low + b * width;
    for (int i = 0; i < n; i++) {
        int place = 0;
        while (place <= bins && sorted[i] >= edges[place]) place++;
        counts[place]++;
    }
    for (int b = 0; b < bins; b++) {
        const double count = (double)counts[b + 1];
        density[b] = about(count / (n * width), 1.96 * sqrt(count + 1.0) / (n * width));
        density[b].lower = fmax(density[b].lower, 0.0);
    }
}

/// Statistics at tip and angle number `i` of T * A, from the n samples that did not fail.
static void make_statistics_at(pdmc_results *r, int m, size_t i, int n, double x[])
{
    pdmc_energy_statistics *to = &r->statistics[m];
    const size_t bins = (size_t)r->histogram_bins, stride = (size_t)r->tip_count * (size_t)r->angle_count;
    for (int s = 0; s < n; s++) x[s] = r->energy[m][(size_t)(s + r->failed_count) * stride + i];
    make_moments(n, x, &to->mean[i], &to->standard_deviation[i]);
    qsort(x, (size_t)n, sizeof *x, ascending);
    for (size_t q = 0; q < PDMC_QUANTILES; q++)
        to->quantiles[i * PDMC_QUANTILES + q] = order_statistic(n, x, pdmc_quantile_levels[q]);
    make_histogram(n, x, r->histogram_bins, &to->histogram_edges[i * (bins + 1)], &to->histogram_counts[i * (bins + 2)],
                   &to->density[i * bins]);
}

static void make_statistics(pdmc_results *r)
{
    const size_t places = (size_t)r->tip_count * (size_t)r->angle_count, bins = (size_t)r->histogram_bins;
    const int n = r->sample_count - r->failed_count;
    double *x = NEW(n, double);
    for (int m = 0; m < PDMC_MEASURES; m++) {
        pdmc_energy_statistics *to = &r->statistics[m];
        to->mean = NEW(places, pdmc_estimate);
        to->standard_deviation = NEW(places, pdmc_estimate);
        to->quantiles = NEW(places * PDMC_QUANTILES, pdmc_estimate);
        to->histogram_edges = NEW(places * (bins + 1), double);
        to->histogram_counts = NEW(places * (bins + 2), int64_t);
        to->density = NEW(places * bins, pdmc_estimate);
        for (size_t i = 0; i < places; i++) make_statistics_at(r, m, i, n, x);
    }
    pdmc_free(x);
}

/// The share of the largest at each angle, and of those above the fracture energy.
static void make_probabilities(pdmc_results *r)
{
    const int n = r->sample_count - r->failed_count;
    r->direction = NEW(r->tip_count * r->angle_count, pdmc_estimate);
    r->probability = NEW(r->tip_count, pdmc_estimate);
    for (int t = 0; t < r->tip_count; t++) {
        for (int s = r->failed_count; s < r->sample_count; s++) {
            const double *g = &r->energy[r->measure][(s * r->tip_count + t) * r->angle_count];
            int best = 0;
            for (int k = 1; k < r->angle_count; k++)
                if (g[k] > g[best]) best = k;
            r->direction[t * r->angle_count + best].value += 1.0 / n;
            r->probability[t].value += (g[best] > r->fracture_energy) / (double)r->sample_count;
        }
        for (int k = 0; k < r->angle_count; k++) {
            const double p = r->direction[t * r->angle_count + k].value, error = 1.96 * sqrt((p + 0.3 / n) / n);
            r->direction[t * r->angle_count + k] = (pdmc_estimate){p, fmax(0.0, p - error), fmin(1.0, p + error)};
        }
        const double p = r->probability[t].value;
        r->probability[t] =
            (pdmc_estimate){p, fmax(0.0, p - 0.02), p + 0.02 + r->failed_count / (double)r->sample_count};
    }
}

static void make_record(pdmc_reliability_record *record, const char *name, double p, double evaluations)
{
    snprintf(record->name, sizeof record->name, "%s", name);
    record->found = (pdmc_reliability){.probability = {p, 0.9 * p, 1.1 * p},
                                       .index = {3.7, 3.6, 3.8},
                                       .variation = 0.047,
                                       .effective_samples = 0.2 * evaluations,
                                       .largest_share = 0.003};
    record->evaluations = evaluations;
    record->complete = 1;
}

static void make_group(pdmc_reliability_group *group, const char *name, int variables, double share)
{
    snprintf(group->name, sizeof group->name, "%s", name);
    group->variables = variables;
    group->importance = share;
    group->first = about(share, 0.02);
    group->total = about(share + 0.01, 0.02);
}

/// Rare growth by both methods, from a load and a c(r); the samples that failed have no part in it.
static void make_reliability(pdmc_results *r)
{
    pdmc_reliability_results *to = &r->reliability;
    r->growth_given_rest = NEW(r->sample_count * r->tip_count, double);
    r->conditional_probability = NEW(r->tip_count, pdmc_estimate);
    for (int i = 0; i < r->sample_count * r->tip_count; i++)
        r->growth_given_rest[i] = i < r->failed_count * r->tip_count ? NAN : 0.31 / (i + 1);
    for (int t = 0; t < r->tip_count; t++) r->conditional_probability[t] = about(0.31, 0.007);
    to->record_count = to->group_count = 2;
    to->records = NEW(2, pdmc_reliability_record);
    to->groups = NEW(2, pdmc_reliability_group);
    make_record(&to->records[0], "importance sampling", 1.014e-4, 4000.0);
    make_record(&to->records[1], "subset simulation", 1.045e-4, 153160.0);
    make_group(&to->groups[0], "load", 1, 0.95);
    make_group(&to->groups[1], "micromodulus", r->bin_count, 0.05);
    to->records[1].failed = r->failed_count;
    to->variable_count = 1 + r->bin_count;
    to->design_point = NEW(to->variable_count, double);
    to->design_point[0] = 3.61;
    to->first_order_index = 3.719;
    to->first_order_probability = 1e-4;
    to->first_order_evaluations = 22.0;
    r->runtime.reliability = 0.83;
}

/// A cheaper method, of whose samples none has failed.
static void make_control(pdmc_results *r)
{
    pdmc_control_results *to = &r->control;
    const int directions = r->tip_count * r->angle_count;
    *to = (pdmc_control_results){
        .tip_count = r->tip_count, .samples = 100000.0, .failed = 0.0, .advised_samples = 51050.4};
    to->mean = NEW(directions, pdmc_estimate);
    to->correlation = NEW(directions, double);
    to->mean_gain = NEW(directions, double);
    to->probability = NEW(r->tip_count, pdmc_estimate);
    to->probability_gain = NEW(r->tip_count, double);
    for (int i = 0; i < directions; i++) {
        to->mean[i] = about(0.21 + 0.01 * i, 0.002);
        to->correlation[i] = 0.999 - 0.01 * i;
        to->mean_gain[i] = 87.5 - i;
    }
    for (int t = 0; t < r->tip_count; t++) {
        to->probability[t] = about(0.35 + 0.01 * t, 0.02);
        to->probability_gain[t] = 3.2 + t;
    }
    r->runtime.control = 1.52;
}

/// A plate on a spring of damping 0.3, mass and stiffness 1 that is loaded suddenly.
static void make_motion(pdmc_results *r, int times)
{
    pdmc_motion_record *m = &r->motion;
    const double d = 0.3, w = sqrt(1.0 - 0.25 * d * d);
    double **const histories[] = {&m->time, &m->load_factor, &m->kinetic, &m->elastic, &m->dissipated, &m->work};
    for (size_t i = 0; i < sizeof histories / sizeof histories[0]; i++) *histories[i] = NEW(times, double);
    m->probes = NEW(m->probe_count, pdmc_probe_record);
    m->displacement = NEW(2 * times * m->probe_count, double);
    for (int p = 0; p < m->probe_count; p++) {
        snprintf(m->probes[p].name, sizeof m->probes[p].name, "probe%d", p + 1);
        m->probes[p].position[1] = 2.5 * p;
        m->probes[p].face = p ? PDMC_FACE_NONE : PDMC_FACE_LEFT;
    }
    for (int i = 0; i < times; i++) {
        const double t = 0.15 * i, fall = exp(-0.5 * d * t);
        const double x = 1.0 - fall * (cos(w * t) + 0.5 * d / w * sin(w * t)), v = fall * sin(w * t) / w;
        m->time[i] = t;
        m->load_factor[i] = i > 0;
        m->work[i] = x;
        m->kinetic[i] = 0.5 * v * v;
        m->elastic[i] = 0.5 * x * x;
        m->dissipated[i] = m->work[i] - m->kinetic[i] - m->elastic[i];
        for (int p = 0; p < m->probe_count; p++) m->displacement[2 * (i * m->probe_count + p) + 1] = (p + 1) * x;
    }
}

pdmc_results made_up_results(made_up_size size)
{
    pdmc_results r = {.crack_count = size.cracks,
                      .kind = size.times > 0 ? PDMC_DYNAMIC : PDMC_STATIC,
                      .tip_count = size.times > 0 ? 0 : TIPS_A_CRACK * size.cracks,
                      .angle_count = size.angles,
                      .sample_count = size.samples,
                      .kept_count = size.samples,
                      .failed_count = size.failed,
                      .bin_count = size.radial_bins,
                      .histogram_bins = size.histogram_bins,
                      .motion = {.time_count = size.times, .probe_count = size.probes}};
    make_study(&r);
    make_tips(&r);
    make_nominal(&r);
    make_field(&r);
    make_samples(&r);
    make_statistics(&r);
    make_probabilities(&r);
    if (r.kind == PDMC_STATIC) make_reliability(&r);
    if (r.kind == PDMC_STATIC) make_control(&r);
    if (r.kind == PDMC_DYNAMIC) make_motion(&r, size.times);
    return r;
}
