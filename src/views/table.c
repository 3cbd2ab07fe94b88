// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "views/views_impl.h"

#include <ctype.h>
#include <math.h>

enum { NUMBER_SIZE = 32 };

/// A number short enough for a column; a dash where there is none.
static const char *brief(char text[NUMBER_SIZE], double x)
{
    snprintf(text, NUMBER_SIZE, isnan(x) ? "-" : "%.4g", x);
    return text;
}

enum { LINE_SIZE = 99 };

/// A text of the results as part of one line: what would move the cursor of a terminal becomes a space.
static const char *line(char text[LINE_SIZE], const char *from)
{
    snprintf(text, LINE_SIZE, "%.*s", LINE_SIZE - 1, from);
    for (char *c = text; *c; c++)
        if (iscntrl((unsigned char)*c)) *c = ' ';
    return text;
}

static void print_head(const pdmc_results *r, FILE *stream)
{
    char unit[PDMC_UNIT_SIZE], text[3][LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    fprintf(stream, "%s\n", line(text[0], r->title));
    fprintf(stream, "  computed %.20s by pdmc %.16s (%.10s), %d threads, %.1f s\n", line(text[0], r->date_and_time),
            line(text[1], r->pdmc_version), line(text[2], r->git_sha1), r->runtime.threads, r->runtime.total);
    if (r->status == PDMC_RUN_INTERRUPTED)
        fprintf(stream, "  INTERRUPTED: these are the samples that were done until then\n");
    fprintf(stream, "  %d samples from seed %llu, %d failed; [intervals] at %g %% confidence\n", r->sample_count,
            (unsigned long long)r->seed, r->failed_count, 100.0 * r->confidence);
    fprintf(stream, "  the %s energy decides P(G > G_c) and the direction; G_c = %.6g %.20s\n",
            pdmc_measure_title(r->measure), r->fracture_energy, line(text[0], unit));
    fprintf(stream, "  bond energies count %s\n", r->bonds == PDMC_BONDS_ALL ? "all bonds" : "bonds in tension only");
}

static void print_tip(const pdmc_results *r, const pdmc_tip *tip, FILE *stream)
{
    char unit[PDMC_UNIT_SIZE], stress[PDMC_UNIT_SIZE], n[6][NUMBER_SIZE], text[2][LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_STRESS_INTENSITY, sizeof unit, unit);
    pdmc_results_unit(r, PDMC_UNIT_STRESS, sizeof stress, stress);
    fprintf(stream, "\n%.40s at (%.6g, %.6g) %.8s, straight ahead %.4g deg\n", line(text[0], tip->name),
            tip->position[0], tip->position[1], line(text[1], r->length_unit), tip->direction * pdmc_degrees);
    fprintf(stream, "  at the mean  K_I = %s +- %s, K_II = %s +- %s %.20s\n", brief(n[0], tip->stress_intensity[0]),
            brief(n[1], tip->stress_intensity_error[0]), brief(n[2], tip->stress_intensity[1]),
            brief(n[3], tip->stress_intensity_error[1]), line(text[0], unit));
    fprintf(stream, "               T = %s +- %s %.20s\n", brief(n[4], tip->t_stress), brief(n[5], tip->t_stress_error),
            line(text[0], stress));
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
    char n[8][NUMBER_SIZE], bounds[2 * NUMBER_SIZE + 4];
    const double *bond = r->bonds == PDMC_BONDS_ALL ? r->nominal_bond_energy : r->nominal_bond_energy_tensile;
    const double *nominal = measure == PDMC_MEASURE_BOND ? bond : r->nominal_griffith_energy;
    const int angle = pdmc_nearest_angle(r, r->tips[tip].direction + turn / pdmc_degrees);
    const size_t at = pdmc_place(r, tip, angle);
    const pdmc_estimate *mean = &r->statistics[measure].mean[at];
    const pdmc_estimate *quantiles = &r->statistics[measure].quantiles[at * PDMC_QUANTILES];
    snprintf(bounds, sizeof bounds, "[%s, %s]", brief(n[0], mean->lower / scale), brief(n[1], mean->upper / scale));
    fprintf(stream, "  %-9s %+4.0f %6.1f %8s %8s %-21s %8s %8s %8s %8s\n", pdmc_measure_title(measure), turn,
            r->angles[angle] * pdmc_degrees, brief(n[2], nominal[at] / scale), brief(n[3], mean->value / scale), bounds,
            brief(n[4], r->statistics[measure].standard_deviation[at].value / scale),
            brief(n[5], quantiles[0].value / scale), brief(n[6], quantiles[1].value / scale),
            brief(n[7], quantiles[2].value / scale));
}

static void print_energies(const pdmc_results *r, int tip, FILE *stream)
{
    static const double turns[] = {0.0, 45.0, -45.0, 90.0, -90.0}; // from straight ahead, degrees
    char unit[PDMC_UNIT_SIZE], scaled[PDMC_UNIT_SIZE + NUMBER_SIZE], text[LINE_SIZE], n[3][NUMBER_SIZE];
    const pdmc_estimate *p = &r->probability[tip];
    const double scale = energy_scale(r);
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    if (scale == 1.0) snprintf(scaled, sizeof scaled, "%s", unit);
    else snprintf(scaled, sizeof scaled, "%.0e %s", scale, unit);
    fprintf(stream, "  P(G > G_c) = %s [%s, %s]\n", brief(n[0], p->value), brief(n[1], p->lower),
            brief(n[2], p->upper));
    if (r->angle_count == 0) return;
    print_directions(r, tip, stream);
    fprintf(stream, "  %-9.9s turn  angle  nominal     mean %21s       sd      5 %%     50 %%     95 %%\n",
            line(text, scaled), "");
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (size_t i = 0; i < sizeof turns / sizeof turns[0]; i++)
            print_energy(r, (pdmc_measure)m, tip, turns[i], stream);
}

static void print_foot(const pdmc_results *r, FILE *stream)
{
    const pdmc_solver_report *s = &r->solver;
    const pdmc_runtime *t = &r->runtime;
    char unit[PDMC_UNIT_SIZE], text[2][LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_STRESS, sizeof unit, unit);
    fprintf(stream, "\nsolver   %d nodes, %d unknowns, %d equations, rank %d%s\n", s->nodes, s->unknowns, s->rows,
            s->rank, s->rank < s->unknowns ? " (DEFICIENT)" : "");
    fprintf(stream, "         condition %.3g, largest residual %.3g %.20s, horizon %.4g, spacing %.4g %.8s\n",
            s->condition, s->residual, line(text[0], unit), s->horizon, s->spacing, line(text[1], r->length_unit));
    fprintf(stream, "seconds  assembly %.2f, factorisation %.2f, operators %.2f, energy rows %.2f,\n", t->assembly,
            t->factorisation, t->operators, t->energy_rows);
    fprintf(stream, "         sampling %.2f, energy %.2f, statistics %.2f, output %.2f\n", t->sampling, t->energy,
            t->statistics, t->output);
}

pdmc_status pdmc_view_table(const pdmc_results *results, FILE *stream)
{
    pdmc_locale locale;
    const pdmc_status status = pdmc_locale_plain(&locale);
    if (status != PDMC_OK) return status;
    print_head(results, stream);
    for (int t = 0; t < results->tip_count; t++) {
        print_tip(results, &results->tips[t], stream);
        print_energies(results, t, stream);
    }
    print_foot(results, stream);
    pdmc_locale_restore(&locale);
    if (fflush(stream) != 0 || ferror(stream)) return pdmc_raise(PDMC_ERR_IO, "the table cannot be written");
    return PDMC_OK;
}
