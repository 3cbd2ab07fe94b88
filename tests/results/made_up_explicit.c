// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/made_up.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ACROSS = 8, UP = 4, DEEP = 3, RECORDS = 21, SNAPSHOTS = 3, TIPS = 2, SPHERES = 2, BODIES = 2, CONDITIONS = 2, INTERFACES = 2 };

static const double spacing = 0.5, interval = 0.1;

#define NEW(pointer, count)                                                                                            \
    do {                                                                                                               \
        (pointer) = pdmc_calloc((size_t)(count), sizeof *(pointer));                                                   \
        if (!(pointer)) abort();                                                                                       \
    } while (0)

static void make_texts(pdmc_results *r)
{
    r->title = pdmc_strdup("A made-up impact");
    r->length_unit = pdmc_strdup("mm");
    r->force_unit = pdmc_strdup("kN");
    r->time_unit = pdmc_strdup("ms");
    r->input = pdmc_strdup("kind = \"explicit\";\n");
    r->resolved = pdmc_strdup("kind = \"explicit\"; # resolved\n");
    r->date_and_time = pdmc_strdup("2024-05-17T09:30:00Z");
    r->pdmc_version = pdmc_strdup("0.1.0");
    r->git_sha1 = pdmc_strdup("0123456789abcdef0123456789abcdef01234567");
    r->particles.kernel = pdmc_strdup("portable");
    r->confidence = 0.95;
    r->runtime = (pdmc_runtime){.motion = 1.25, .output = 0.05, .total = 1.5, .peak_memory = 8.1e7, .threads = 2};
}

// In space single precision makes differences that grow to 5e-6, a 2^22nd a record.
static void make_precision(pdmc_explicit_record *p)
{
    if (p->dimension < 3) return;
    p->compared_count = RECORDS;
    NEW(p->force_error, RECORDS);
    for (int i = 0; i < RECORDS; i++) p->force_error[i] = i / 4194304.0;
}

// Half of the work is elastic, a quarter kinetic, an eighth of contact, and a sixteenth each is of fracture and damping.
static void make_energies(pdmc_explicit_record *p)
{
    NEW(p->time, RECORDS);
    NEW(p->kinetic, RECORDS);
    NEW(p->elastic, RECORDS);
    NEW(p->contact, RECORDS);
    NEW(p->fracture, RECORDS);
    NEW(p->work, RECORDS);
    NEW(p->dissipated, RECORDS);
    NEW(p->momentum, 3 * RECORDS);
    NEW(p->mean_damage, RECORDS);
    NEW(p->broken, RECORDS);
    NEW(p->fragments, RECORDS);
    NEW(p->loose_nodes, RECORDS);
    NEW(p->largest_fragment, RECORDS);
    p->first = 2.0;
    for (int i = 0; i < RECORDS; i++) {
        const double t = p->time[i] = i * interval, all = p->first + t;
        p->work[i] = t;
        p->elastic[i] = 0.5 * all;
        p->kinetic[i] = 0.25 * all;
        p->contact[i] = 0.125 * all;
        p->fracture[i] = p->dissipated[i] = 0.0625 * all;
        p->momentum[3 * i + 1] = -t;
        p->mean_damage[i] = 0.01 * i;
        p->broken[i] = 10.0 * i;
        p->fragments[i] = 1.0 + i / 10;
        p->loose_nodes[i] = i / 20;
        p->largest_fragment[i] = 0.25 * (40 - i);
    }
}

// The second tip grows by 3 mm between the times 0.4 and 1.4.
static void make_tips(pdmc_explicit_record *p)
{
    NEW(p->tips, TIPS);
    NEW(p->tip_advance, TIPS * RECORDS);
    NEW(p->tip_speed, TIPS * RECORDS);
    for (int t = 0; t < TIPS; t++) {
        snprintf(p->tips[t].name, sizeof p->tips[t].name, "centre.%s", t ? "to" : "from");
        p->tips[t].position[0] = t ? 1.0 : -1.0;
        p->tips[t].direction[0] = t ? 1.0 : -1.0;
    }
    for (int i = 0; i < RECORDS; i++) {
        p->tip_advance[TIPS * i + 1] = 3.0 * fmin(1.0, fmax(0.0, 0.1 * (i - 4)));
        p->tip_speed[TIPS * i + 1] = i > 4 && i < 14 ? 3.0 : 0.0;
    }
}

static void make_spheres(pdmc_explicit_record *p)
{
    NEW(p->spheres, SPHERES);
    NEW(p->sphere_centre, 3 * SPHERES * RECORDS);
    NEW(p->sphere_velocity, 3 * SPHERES * RECORDS);
    NEW(p->sphere_force, 3 * SPHERES * RECORDS);
    for (int s = 0; s < SPHERES; s++) {
        snprintf(p->spheres[s].name, sizeof p->spheres[s].name, "sphere%d", s + 1);
        p->spheres[s].radius = s + 1.0;
        p->spheres[s].mass = s ? INFINITY : 4.16;
    }
    for (int i = 0; i < 3 * SPHERES * RECORDS; i++) {
        p->sphere_centre[i] = 0.25 * i;
        p->sphere_velocity[i] = -0.5 * i;
        p->sphere_force[i] = 7.0 * i;
    }
}

static void make_conditions(pdmc_explicit_record *p)
{
    NEW(p->conditions, CONDITIONS);
    NEW(p->condition_force, 3 * CONDITIONS * RECORDS);
    NEW(p->condition_displacement, 3 * CONDITIONS * RECORDS);
    for (int c = 0; c < CONDITIONS; c++) snprintf(p->conditions[c].name, sizeof p->conditions[c].name, "end%d", c + 1);
    for (int i = 0; i < 3 * CONDITIONS * RECORDS; i++) {
        p->condition_force[i] = 3.0 * i;
        p->condition_displacement[i] = -1e-3 * i;
    }
}

static void make_interfaces(pdmc_explicit_record *p)
{
    NEW(p->interfaces, INTERFACES);
    NEW(p->interface_broken, INTERFACES * RECORDS);
    for (int k = 0; k < INTERFACES; k++) {
        snprintf(p->interfaces[k].name, sizeof p->interfaces[k].name, "glue%d", k + 1);
        p->interfaces[k].bonds = 100.0 + k;
    }
    for (int i = 0; i < INTERFACES * RECORDS; i++) p->interface_broken[i] = 1.5 * i;
}

static void make_nodes(pdmc_explicit_record *p)
{
    const int layers = p->dimension == 3 ? DEEP : 1, n = ACROSS * UP * layers;
    NEW(p->node_position, 3 * n);
    NEW(p->node_body, n);
    NEW(p->bodies, BODIES);
    p->node_count = n;
    for (int b = 0; b < BODIES; b++) snprintf(p->bodies[b].name, sizeof p->bodies[b].name, "body%d", b + 1);
    for (int i = 0; i < n; i++) {
        p->node_position[3 * i] = spacing * (i % ACROSS);
        p->node_position[3 * i + 1] = spacing * (i / ACROSS % UP);
        p->node_position[3 * i + 2] = spacing * (i / ACROSS / UP);
        p->node_body[i] = i % ACROSS >= ACROSS / 2;
    }
}

static void make_snapshots(pdmc_explicit_record *p)
{
    p->snapshot_count = SNAPSHOTS;
    p->state_count = SNAPSHOTS * p->node_count;
    NEW(p->snapshot_time, SNAPSHOTS);
    NEW(p->displacement, 3 * p->state_count);
    NEW(p->velocity, 3 * p->state_count);
    NEW(p->damage, p->state_count);
    for (int s = 0; s < SNAPSHOTS; s++) p->snapshot_time[s] = (s + 1) * interval * (RECORDS - 1) / SNAPSHOTS;
    for (int i = 0; i < 3 * p->state_count; i++) {
        p->displacement[i] = 1e-3 * i;
        p->velocity[i] = 1.0 / (i + 1);
    }
    for (int i = 0; i < p->state_count; i++) p->damage[i] = (double)(i + 1) / p->state_count;
}

// In the last snapshot, of nodes of mass 0.25: the last node by itself, the two before it, and all others.
static void make_fragments(pdmc_explicit_record *p)
{
    const int n = p->node_count, nodes[] = {n - 3, 2, 1};
    NEW(p->fragment, p->state_count);
    NEW(p->fragment_list, 3);
    p->fragment_count = 3;
    for (int k = 0; k < 3; k++) {
        p->fragment[p->state_count - 1 - k] = k == 0 ? 2 : 1;
        p->fragment_list[k] = (pdmc_fragment){nodes[k], 0.25 * nodes[k], {k, 1.5, 0.0}, {0.0, -k, 2.0}};
    }
}

pdmc_results made_up_explicit(int dimension)
{
    pdmc_results r = {.kind = PDMC_EXPLICIT,
                      .particles = {.dimension = dimension,
                                    .spacing = spacing,
                                    .horizon = 1.5,
                                    .step = 0.01,
                                    .stable_step = 0.0125,
                                    .steps = 200,
                                    .bonds = 321,
                                    .tip_damage = 0.3,
                                    .speed_window = 1.0,
                                    .record_count = RECORDS,
                                    .tip_count = TIPS,
                                    .sphere_count = SPHERES,
                                    .condition_count = CONDITIONS,
                                    .interface_count = INTERFACES,
                                    .body_count = BODIES}};
    make_texts(&r);
    make_energies(&r.particles);
    make_precision(&r.particles);
    make_tips(&r.particles);
    make_spheres(&r.particles);
    make_conditions(&r.particles);
    make_interfaces(&r.particles);
    make_nodes(&r.particles);
    make_snapshots(&r.particles);
    make_fragments(&r.particles);
    return r;
}

enum { DRAWS = 4, STATIONS = 3, BINS = 5 };

static void fill(int count, double values[], double first)
{
    for (int i = 0; i < count; i++) values[i] = first + 0.125 * i;
}

static void fill_estimates(int count, pdmc_estimate values[], double first)
{
    for (int i = 0; i < count; i++) values[i] = (pdmc_estimate){first + i, first + i - 0.25, first + i + 0.25};
}

static void make_draws(pdmc_ensemble_results *e)
{
    double **const of_samples[] = {&e->load, &e->velocity, &e->youngs_modulus, &e->fracture_energy, &e->fracture};
    double **const of_tips[] = {&e->growth, &e->begin, &e->mean_speed, &e->most_speed};
    NEW(e->failure, DRAWS);
    NEW(e->outcome, DRAWS * TIPS);
    NEW(e->end, 2 * DRAWS * TIPS);
    NEW(e->station, STATIONS);
    NEW(e->path, DRAWS * TIPS * STATIONS);
    for (int k = 0; k < 5; k++) {
        NEW(*of_samples[k], DRAWS);
        fill(DRAWS, *of_samples[k], 1.0 + k);
    }
    for (int k = 0; k < 4; k++) {
        NEW(*of_tips[k], DRAWS * TIPS);
        fill(DRAWS * TIPS, *of_tips[k], 10.0 * (k + 1));
    }
    for (int i = 0; i < DRAWS * TIPS; i++) e->outcome[i] = (uint8_t)(i % PDMC_OUTCOMES);
    fill(2 * DRAWS * TIPS, e->end, -1.0);
    fill(STATIONS, e->station, 0.0);
    fill(DRAWS * TIPS * STATIONS, e->path, -0.5);
    e->failure[DRAWS - 1] = PDMC_SAMPLE_DIVERGED;
    e->growth[(DRAWS - 1) * TIPS] = e->path[STATIONS - 1] = NAN;
}

void made_up_samples(pdmc_results *results)
{
    pdmc_ensemble_results *e = &results->ensemble;
    results->histogram_bins = BINS;
    e->sample_count = DRAWS;
    e->failed_count = 1;
    e->tip_count = TIPS;
    e->station_count = STATIONS;
    make_draws(e);
    NEW(e->share, TIPS * PDMC_OUTCOMES);
    NEW(e->mean_growth, TIPS);
    NEW(e->deviation, TIPS);
    NEW(e->growth_quantiles, TIPS * PDMC_QUANTILES);
    NEW(e->growth_edges, TIPS * (BINS + 1));
    NEW(e->growth_counts, TIPS * (BINS + 2));
    NEW(e->growth_density, TIPS * BINS);
    NEW(e->path_samples, TIPS * STATIONS);
    NEW(e->path_mean, TIPS * STATIONS);
    NEW(e->path_quantiles, TIPS * STATIONS * PDMC_QUANTILES);
    fill_estimates(TIPS * PDMC_OUTCOMES, e->share, 0.5);
    fill_estimates(TIPS, e->mean_growth, 20.0);
    fill_estimates(TIPS, e->deviation, 30.0);
    fill_estimates(TIPS * PDMC_QUANTILES, e->growth_quantiles, 40.0);
    fill(TIPS * (BINS + 1), e->growth_edges, 1.0);
    for (int i = 0; i < TIPS * (BINS + 2); i++) e->growth_counts[i] = i;
    fill_estimates(TIPS * BINS, e->growth_density, 2.0);
    fill(TIPS * STATIONS, e->path_samples, 3.0);
    fill_estimates(TIPS * STATIONS, e->path_mean, 50.0);
    fill_estimates(TIPS * STATIONS * PDMC_QUANTILES, e->path_quantiles, 60.0);
}
