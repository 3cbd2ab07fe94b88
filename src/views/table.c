// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/table.h"
#include "base/base_impl.h"

#include <ctype.h>
#include <math.h>

const char *pdmc_brief(char text[PDMC_BRIEF_SIZE], double x)
{
    snprintf(text, PDMC_BRIEF_SIZE, isnan(x) ? "-" : "%.4g", x);
    return text;
}

const char *pdmc_one_line(char text[PDMC_LINE_SIZE], const char *from)
{
    snprintf(text, PDMC_LINE_SIZE, "%.*s", PDMC_LINE_SIZE - 1, from);
    for (char *c = text; *c; c++)
        if (iscntrl((unsigned char)*c)) *c = ' ';
    return text;
}

// Of the samples: their range where it is random, and whether tips have their own.
static void print_toughness(const pdmc_results *r, FILE *stream)
{
    double least = INFINITY, most = -INFINITY;
    bool is_own = false;
    for (size_t s = 0; s < (size_t)r->sample_count && r->sample_fracture_energy; s++) {
        const double *toughness = &r->sample_fracture_energy[s * (size_t)r->tip_count];
        for (int t = 0; t < r->tip_count; t++) {
            least = fmin(least, toughness[t]);
            most = fmax(most, toughness[t]);
            is_own = is_own || toughness[t] < toughness[0] || toughness[t] > toughness[0];
        }
    }
    if (least < most) fprintf(stream, "%sfrom %.4g to %.4g", is_own ? "of each tip " : "", least, most);
    else fprintf(stream, "= %.6g", r->fracture_energy);
}

static void print_sampling(const pdmc_results *r, FILE *stream)
{
    char unit[PDMC_UNIT_SIZE], text[PDMC_LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    fprintf(stream, "  %d samples from seed %llu, %d failed; [intervals] at %g %% confidence\n", r->sample_count,
            (unsigned long long)r->seed, r->failed_count, 100.0 * r->confidence);
    if (r->kept_count < r->sample_count)
        fprintf(stream, "  every energy is kept of the first %d samples; the statistics are of all\n", r->kept_count);
    fprintf(stream, "  the %s energy decides P(G > G_c) and the direction; G_c ", pdmc_measure_title(r->measure));
    print_toughness(r, stream);
    fprintf(stream, " %.20s\n", pdmc_one_line(text, unit));
    fprintf(stream, "  bond energies count %s\n", r->bonds == PDMC_BONDS_ALL ? "all bonds" : "bonds in tension only");
}

static void print_head(const pdmc_results *r, FILE *stream)
{
    char text[3][PDMC_LINE_SIZE];
    const char *counted = r->kind == PDMC_QUASI_STATIC ? "loads" : r->kind == PDMC_SCALAR ? "levels" : "steps";
    fprintf(stream, "%s\n", pdmc_one_line(text[0], r->title));
    fprintf(stream, "  computed %.20s by pdmc %.16s (%.10s), %d threads, %.1f s\n",
            pdmc_one_line(text[0], r->date_and_time), pdmc_one_line(text[1], r->pdmc_version),
            pdmc_one_line(text[2], r->git_sha1), r->runtime.threads, r->runtime.total);
    if (r->mesh_generator && *r->mesh_generator)
        fprintf(stream, "  mesh by %.40s\n", pdmc_one_line(text[0], r->mesh_generator));
    if (r->status == PDMC_RUN_INTERRUPTED && r->reliability.group_count > 0)
        fprintf(stream, "  INTERRUPTED: all samples were done, rare growth was not\n");
    else if (r->status == PDMC_RUN_INTERRUPTED)
        fprintf(stream, "  INTERRUPTED: these are the %s that were done until then\n",
                r->kind == PDMC_STATIC ? "samples" : counted);
    else if (r->status == PDMC_RUN_NOT_FINITE || r->status == PDMC_RUN_NO_REST)
        fprintf(stream, "  STOPPED, these are the %s until then: %s\n", counted,
                pdmc_one_line(text[0], r->particles.stop));
    else if (r->status == PDMC_RUN_TARGET_MET) fprintf(stream, "  the precision that was asked for is reached\n");
    else if (r->status == PDMC_RUN_SAMPLE_CAP)
        fprintf(stream, "  STOPPED AT THE CAP: the most samples allowed do not give the precision that was asked for\n");
}

static void print_tip(const pdmc_results *r, const pdmc_tip *tip, FILE *stream)
{
    char unit[PDMC_UNIT_SIZE], stress[PDMC_UNIT_SIZE], n[6][PDMC_BRIEF_SIZE], text[2][PDMC_LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_STRESS_INTENSITY, sizeof unit, unit);
    pdmc_results_unit(r, PDMC_UNIT_STRESS, sizeof stress, stress);
    fprintf(stream, "\n%.40s at (%.6g, %.6g) %.8s, straight ahead %.4g deg\n", pdmc_one_line(text[0], tip->name),
            tip->position[0], tip->position[1], pdmc_one_line(text[1], r->length_unit), tip->direction * pdmc_degrees);
    fprintf(stream, "  at the mean  K_I = %s +- %s, K_II = %s +- %s %.20s\n",
            pdmc_brief(n[0], tip->stress_intensity[0]), pdmc_brief(n[1], tip->stress_intensity_error[0]),
            pdmc_brief(n[2], tip->stress_intensity[1]), pdmc_brief(n[3], tip->stress_intensity_error[1]),
            pdmc_one_line(text[0], unit));
    if (isnan(tip->t_stress)) fprintf(stream, "               T is not known to this crack model\n");
    else
        fprintf(stream, "               T = %s +- %s %.20s\n", pdmc_brief(n[4], tip->t_stress),
                pdmc_brief(n[5], tip->t_stress_error), pdmc_one_line(text[0], stress));
}

/// The largest shares, as many as fit a line and matter.
static void print_directions(const pdmc_results *r, int tip, FILE *stream)
{
    enum { SHOWN = 3 };
    const double least = 0.005;
    double limit = INFINITY;
    fprintf(stream, "  most likely direction");
    for (int shown = 0, last = -1; shown < SHOWN; shown++) {
        int best = -1;
        for (int k = 0; k < r->angle_count; k++) {
            const double share = r->direction[pdmc_place(r, tip, k)].value;
            const bool is_next = share < limit || (share == limit && k > last);
            if (is_next && (best < 0 || share > r->direction[pdmc_place(r, tip, best)].value)) best = k;
        }
        if (best < 0 || !(r->direction[pdmc_place(r, tip, best)].value > least)) break;
        const pdmc_estimate *share = &r->direction[pdmc_place(r, tip, best)];
        fprintf(stream, "%s %.4g deg %.1f %%", shown ? "," : "", r->angles[best] * pdmc_degrees, 100.0 * share->value);
        if (shown == 0) fprintf(stream, " [%.1f, %.1f]", 100.0 * share->lower, 100.0 * share->upper);
        limit = share->value;
        last = best;
    }
    fprintf(stream, "\n");
}

/// The power of ten that energies are shown in, so that a unit which makes them tiny or huge does not burst the
/// columns.
static double energy_scale(const pdmc_results *r)
{
    double largest = 0.0;
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (size_t i = 0; i < pdmc_place(r, r->tip_count, 0); i++) {
            const double mean = fabs(r->statistics[m].mean[i].value);
            if (isfinite(mean)) largest = fmax(largest, mean);
        }
    if (largest == 0.0 || (0.01 <= largest && largest < 10000.0)) return 1.0;
    return pow(10.0, 3.0 * floor(log10(largest) / 3.0));
}

static void print_energy(const pdmc_results *r, pdmc_measure measure, int tip, double turn, FILE *stream)
{
    const double scale = energy_scale(r);
    char n[8][PDMC_BRIEF_SIZE], bounds[2 * PDMC_BRIEF_SIZE + 4];
    const double *bond = r->bonds == PDMC_BONDS_ALL ? r->nominal_bond_energy : r->nominal_bond_energy_tensile;
    const double *nominal = measure == PDMC_MEASURE_BOND ? bond : r->nominal_griffith_energy;
    const int angle = pdmc_nearest_angle(r, r->tips[tip].direction + turn / pdmc_degrees);
    const size_t at = pdmc_place(r, tip, angle);
    const pdmc_estimate *mean = &r->statistics[measure].mean[at];
    const pdmc_estimate *quantiles = &r->statistics[measure].quantiles[at * PDMC_QUANTILES];
    snprintf(bounds, sizeof bounds, "[%s, %s]", pdmc_brief(n[0], mean->lower / scale),
             pdmc_brief(n[1], mean->upper / scale));
    fprintf(stream, "  %-9s %+4.0f %6.1f %8s %8s %-21s %8s %8s %8s %8s\n", pdmc_measure_title(measure), turn,
            r->angles[angle] * pdmc_degrees, pdmc_brief(n[2], nominal[at] / scale),
            pdmc_brief(n[3], mean->value / scale), bounds,
            pdmc_brief(n[4], r->statistics[measure].standard_deviation[at].value / scale),
            pdmc_brief(n[5], quantiles[0].value / scale), pdmc_brief(n[6], quantiles[1].value / scale),
            pdmc_brief(n[7], quantiles[2].value / scale));
}

// The same samples with the load integrated: a narrower interval where growth is rare.
static void print_conditional(const pdmc_results *r, int tip, FILE *stream)
{
    char n[3][PDMC_BRIEF_SIZE];
    if (!r->conditional_probability || isnan(r->conditional_probability[tip].value)) return;
    const pdmc_estimate *p = &r->conditional_probability[tip];
    fprintf(stream, "  P(G > G_c) = %s [%s, %s] with the load integrated analytically\n", pdmc_brief(n[0], p->value),
            pdmc_brief(n[1], p->lower), pdmc_brief(n[2], p->upper));
}

static void print_energies(const pdmc_results *r, int tip, FILE *stream)
{
    static const double turns[] = {0.0, 45.0, -45.0, 90.0, -90.0}; // from straight ahead, degrees
    char unit[PDMC_UNIT_SIZE], scaled[PDMC_UNIT_SIZE + PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE], n[3][PDMC_BRIEF_SIZE];
    const pdmc_estimate *p = &r->probability[tip];
    const double scale = energy_scale(r);
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    if (scale == 1.0) snprintf(scaled, sizeof scaled, "%s", unit);
    else snprintf(scaled, sizeof scaled, "%.0e %s", scale, unit);
    fprintf(stream, "  P(G > G_c) = %s [%s, %s]\n", pdmc_brief(n[0], p->value), pdmc_brief(n[1], p->lower),
            pdmc_brief(n[2], p->upper));
    print_conditional(r, tip, stream);
    pdmc_table_controlled_tip(r, tip, stream);
    if (r->angle_count == 0) return;
    print_directions(r, tip, stream);
    fprintf(stream, "  %-9.9s turn  angle  nominal     mean %21s       sd      5 %%     50 %%     95 %%\n",
            pdmc_one_line(text, scaled), "");
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (size_t i = 0; i < sizeof turns / sizeof turns[0]; i++)
            print_energy(r, (pdmc_measure)m, tip, turns[i], stream);
}

static void print_memory(double bytes, FILE *stream)
{
    if (isfinite(bytes)) fprintf(stream, "memory   %.4g MB at most\n", bytes / 1e6);
}

/// Beside the sampling error of the intervals; older files do not have it.
static void print_model_error(const pdmc_sample_accuracy *a, FILE *stream)
{
    if (isnan(a->mean_error[PDMC_MEASURE_GRIFFITH])) return;
    fprintf(stream, "         model error beside the intervals, over the mean of the largest energy, at most:\n");
    for (int m = 0; m < PDMC_MEASURES; m++)
        fprintf(stream, "         %-8s  mean %.2g, 5 %% %.2g, 50 %% %.2g, 95 %% %.2g\n",
                pdmc_measure_title((pdmc_measure)m), a->mean_error[m], a->quantile_error[m][0], a->quantile_error[m][1],
                a->quantile_error[m][2]);
    fprintf(stream, "         none in the share of G > G_c: samples that it could change are solved in full\n");
}

static void print_accuracy(const pdmc_sample_accuracy *a, FILE *stream)
{
    if (isfinite(a->iteration_residual))
        fprintf(stream, "samples  largest relative residual of the iteration %.2g\n", a->iteration_residual);
    if (isfinite(a->reduced_unknowns))
        fprintf(stream,
                "samples  reduced model of %.0f unknowns; relative error of the largest energy at most\n"
                "         %.2g bond (median %.2g), %.2g Griffith (%.2g); %.0f samples solved in full\n",
                a->reduced_unknowns, a->energy_error[PDMC_MEASURE_BOND], a->typical_error[PDMC_MEASURE_BOND],
                a->energy_error[PDMC_MEASURE_GRIFFITH], a->typical_error[PDMC_MEASURE_GRIFFITH], a->solved_in_full);
    print_model_error(a, stream);
}

static void print_foot(const pdmc_results *r, FILE *stream)
{
    const pdmc_solver_report *s = &r->solver;
    const pdmc_runtime *t = &r->runtime;
    char unit[PDMC_UNIT_SIZE], text[2][PDMC_LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_STRESS, sizeof unit, unit);
    fprintf(stream, "\nsolver   %d nodes, %d unknowns, %d equations, rank %d%s\n", s->nodes, s->unknowns, s->rows,
            s->rank, s->rank < s->unknowns ? " (DEFICIENT)" : "");
    fprintf(stream, "         condition %.3g, largest residual %.3g %.20s, horizon %.4g, spacing %.4g %.8s\n",
            s->condition, s->residual, pdmc_one_line(text[0], unit), s->horizon, s->spacing,
            pdmc_one_line(text[1], r->length_unit));
    print_accuracy(&r->accuracy, stream);
    pdmc_table_control(r, stream);
    fprintf(stream, "seconds  assembly %.2f, factorisation %.2f, operators %.2f, energy rows %.2f,\n", t->assembly,
            t->factorisation, t->operators, t->energy_rows);
    if (r->kind == PDMC_DYNAMIC) {
        fprintf(stream, "         motion %.2f, output %.2f\n", t->motion, t->output);
    } else {
        fprintf(stream, "         sampling %.2f, energy %.2f, statistics %.2f, ", t->sampling, t->energy,
                t->statistics);
        if (r->reliability.group_count > 0) fprintf(stream, "rare growth %.2f, ", t->reliability);
        fprintf(stream, "output %.2f\n", t->output);
    }
    print_memory(t->peak_memory, stream);
}

static void print_plate(const pdmc_results *r, FILE *stream)
{
    (r->kind == PDMC_DYNAMIC ? pdmc_table_motion : print_sampling)(r, stream);
    for (int t = 0; t < r->tip_count; t++) {
        print_tip(r, &r->tips[t], stream);
        print_energies(r, t, stream);
    }
    pdmc_table_reliability(r, stream);
    print_foot(r, stream);
}

static void print_explicit(const pdmc_results *r, FILE *stream)
{
    pdmc_table_explicit(r, stream);
    pdmc_table_ensemble(r, stream);
    print_memory(r->runtime.peak_memory, stream);
}

static void print_elastic(const pdmc_results *r, FILE *stream)
{
    pdmc_table_elastic(r, stream);
    print_memory(r->runtime.peak_memory, stream);
}

static void print_scalar(const pdmc_results *r, FILE *stream)
{
    pdmc_table_scalar(r, stream);
    print_memory(r->runtime.peak_memory, stream);
}

static void print_quadrature(const pdmc_results *r, FILE *stream)
{
    pdmc_table_quadrature(r, stream);
    print_memory(r->runtime.peak_memory, stream);
}

pdmc_status pdmc_view_table(const pdmc_results *results, FILE *stream)
{
    pdmc_locale locale;
    const pdmc_status status = pdmc_locale_plain(&locale);
    if (status != PDMC_OK) return status;
    print_head(results, stream);
    if (pdmc_is_of_bodies(results->kind)) print_explicit(results, stream);
    else if (results->kind == PDMC_ELASTIC) print_elastic(results, stream);
    else if (results->kind == PDMC_SCALAR) print_scalar(results, stream);
    else if (results->kind == PDMC_QUADRATURE) print_quadrature(results, stream);
    else print_plate(results, stream);
    pdmc_locale_restore(&locale);
    if (fflush(stream) != 0 || ferror(stream)) return pdmc_raise(PDMC_ERR_IO, "the table cannot be written");
    return PDMC_OK;
}
