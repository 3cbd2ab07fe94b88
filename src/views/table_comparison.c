// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "views/comparison.h"
#include "views/table.h"

#include <math.h>

enum { COLUMN = 39 }; // width of what is said of one of the two, with a space

typedef char cell[160];

static void print_row(FILE *stream, const char *name, const char *first, const char *second)
{
    char text[PDMC_COMPARED][PDMC_LINE_SIZE];
    fprintf(stream, "  %-19.19s %-*.*s %.*s\n", name, COLUMN - 1, COLUMN - 1, pdmc_one_line(text[0], first), COLUMN - 1,
            pdmc_one_line(text[1], second));
}

static void put_estimate(cell text, const pdmc_estimate *e)
{
    char n[3][PDMC_BRIEF_SIZE];
    snprintf(text, sizeof(cell), "%s [%s, %s]", pdmc_brief(n[0], e->value), pdmc_brief(n[1], e->lower),
             pdmc_brief(n[2], e->upper));
}

static void put_error(cell text, double value, double error)
{
    char n[2][PDMC_BRIEF_SIZE];
    if (isnan(value)) snprintf(text, sizeof(cell), "-");
    else snprintf(text, sizeof(cell), "%s +- %s", pdmc_brief(n[0], value), pdmc_brief(n[1], error));
}

static void print_studies(const pdmc_comparison *c, FILE *stream)
{
    cell file[PDMC_COMPARED], title[PDMC_COMPARED], method[PDMC_COMPARED], samples[PDMC_COMPARED],
        solver[PDMC_COMPARED];
    char unit[PDMC_LINE_SIZE];
    for (int i = 0; i < PDMC_COMPARED; i++) {
        const pdmc_results *r = c->results[i];
        snprintf(file[i], sizeof file[i], "%.150s", c->labels[i]);
        snprintf(title[i], sizeof title[i], "%.150s", r->title);
        snprintf(method[i], sizeof method[i], "%s", *c->method[i] ? c->method[i] : "-");
        snprintf(samples[i], sizeof samples[i], "%d, %d failed%s, seed %llu", r->sample_count, r->failed_count,
                 r->status == PDMC_RUN_INTERRUPTED ? ", INTERRUPTED" : "", (unsigned long long)r->seed);
        snprintf(solver[i], sizeof solver[i], "%d, spacing %.4g, horizon %.4g %.8s", r->solver.nodes, r->solver.spacing,
                 r->solver.horizon, pdmc_one_line(unit, r->length_unit));
    }
    print_row(stream, "file", file[0], file[1]);
    print_row(stream, "title", title[0], title[1]);
    print_row(stream, "method", method[0], method[1]);
    print_row(stream, "nodes", solver[0], solver[1]);
    if (c->results[0]->kind == PDMC_STATIC) print_row(stream, "samples", samples[0], samples[1]);
}

static void print_tip(const pdmc_comparison *c, const pdmc_compared_tip *tip, FILE *stream)
{
    cell mode_1[PDMC_COMPARED], mode_2[PDMC_COMPARED], stress[PDMC_COMPARED], griffith[PDMC_COMPARED];
    cell probability[PDMC_COMPARED], direction[PDMC_COMPARED] = {"-", "-"};
    char name[PDMC_LINE_SIZE];
    for (int i = 0; i < PDMC_COMPARED; i++) {
        const pdmc_results *r = c->results[i];
        const pdmc_tip *t = &r->tips[tip->number[i]];
        const int best = pdmc_compared_direction(c, tip, i);
        double value, error;
        pdmc_compared_griffith(c, tip, i, &value, &error);
        put_error(mode_1[i], t->stress_intensity[0], t->stress_intensity_error[0]);
        put_error(mode_2[i], t->stress_intensity[1], t->stress_intensity_error[1]);
        put_error(stress[i], t->t_stress, t->t_stress_error);
        put_error(griffith[i], value, error);
        put_estimate(probability[i], &r->probability[tip->number[i]]);
        if (best < 0) continue;
        const pdmc_estimate *share = &r->direction[pdmc_place(r, tip->number[i], best)];
        snprintf(direction[i], sizeof direction[i], "%.4g deg %.1f %% [%.1f, %.1f]", r->angles[best] * pdmc_degrees,
                 100.0 * share->value, 100.0 * share->lower, 100.0 * share->upper);
    }
    fprintf(stream, "\n%.40s at the mean, in %.10s and %.10s\n", pdmc_one_line(name, pdmc_compared_name(c, tip)),
            c->results[0]->force_unit, c->results[0]->length_unit);
    print_row(stream, "K_I", mode_1[0], mode_1[1]);
    print_row(stream, "K_II", mode_2[0], mode_2[1]);
    print_row(stream, "T", stress[0], stress[1]);
    print_row(stream, "G straight ahead", griffith[0], griffith[1]);
    print_row(stream, "P(G > G_c)", probability[0], probability[1]);
    print_row(stream, "most likely", direction[0], direction[1]);
}

/// A number near 1, to two digits of the width of its interval, so that it is not "1 [1, 1]".
static void put_near_one(cell text, const pdmc_estimate *e)
{
    const double width = e->upper - e->lower;
    if (!isfinite(width) || fabs(e->value) > 1e3) {
        put_estimate(text, e);
        return;
    }
    const int digits = width > 0.0 ? (int)fmin(fmax(1.0 - floor(log10(width)), 2.0), 15.0) : 2;
    snprintf(text, sizeof(cell), "%.*f [%.*f, %.*f]", digits, e->value, digits, e->lower, digits, e->upper);
}

/// A probability that only a limit is known of where it is small: of pairs that of 999 resamples, else the asymptotic
/// distribution's.
static void put_chance(cell text, double p, bool paired)
{
    const double least = paired ? 1e-3 : 1e-6;
    char n[PDMC_BRIEF_SIZE];
    if (p <= least) snprintf(text, sizeof(cell), "p <= %g", least);
    else snprintf(text, sizeof(cell), "p = %s", pdmc_brief(n, p));
}

static void print_pairs(const pdmc_compared_angle *angle, FILE *stream)
{
    const pdmc_pairs *p = &angle->pairs;
    char n[4][PDMC_BRIEF_SIZE];
    cell text;
    put_near_one(text, &p->correlation);
    fprintf(stream, "  %-19s %s\n", "pairs, correlation", text);
    fprintf(stream, "  %-19s %s %% on average [%s, %s]", "pairs, B - A", pdmc_brief(n[0], 100.0 * p->difference.value),
            pdmc_brief(n[1], 100.0 * p->difference.lower), pdmc_brief(n[2], 100.0 * p->difference.upper));
    if (p->count > 0)
        fprintf(stream, ", at most %s %% in sample %d", pdmc_brief(n[3], 100.0 * p->largest_difference),
                angle->largest_sample);
    fputc('\n', stream);
}

static void print_distances(const pdmc_comparison *c, const pdmc_compared_angle *angle, double mean, FILE *stream)
{
    const pdmc_distances *d = &angle->distances;
    char n[PDMC_BRIEF_SIZE];
    cell text, chance;
    put_estimate(text, &angle->difference);
    fprintf(stream, "  %-19s %s\n", "means, B - A", text);
    put_near_one(text, &angle->ratio);
    fprintf(stream, "  %-19s %s\n", "means, B / A", text);
    put_estimate(text, &d->kolmogorov_smirnov);
    put_chance(chance, d->p_value, c->paired);
    fprintf(stream, "  %-19s %s, %s\n", "Kolmogorov-Smirnov", text, chance);
    put_estimate(text, &d->wasserstein);
    fprintf(stream, "  %-19s %s, %s %% of A's mean\n", "Wasserstein", text,
            pdmc_brief(n, 100.0 * d->wasserstein.value / mean));
    if (c->paired) print_pairs(angle, stream);
}

static void print_angle(const pdmc_comparison *c, const pdmc_compared_tip *tip, const pdmc_compared_angle *angle,
                        FILE *stream)
{
    cell nominal[PDMC_COMPARED], mean[PDMC_COMPARED], deviation[PDMC_COMPARED], variation[PDMC_COMPARED];
    char unit[PDMC_UNIT_SIZE], n[PDMC_BRIEF_SIZE], text[2][PDMC_LINE_SIZE];
    const pdmc_energy_statistics *s[PDMC_COMPARED];
    pdmc_results_unit(c->results[0], PDMC_UNIT_ENERGY, sizeof unit, unit);
    for (int i = 0; i < PDMC_COMPARED; i++) {
        s[i] = &c->results[i]->statistics[c->measure];
        const pdmc_estimate *m = &s[i]->mean[angle->place[i]], *d = &s[i]->standard_deviation[angle->place[i]];
        snprintf(nominal[i], sizeof nominal[i], "%s", pdmc_brief(n, pdmc_compared_nominal(c, angle, i)));
        snprintf(variation[i], sizeof variation[i], "%s %%", pdmc_brief(n, 100.0 * d->value / m->value));
        put_estimate(mean[i], m);
        put_estimate(deviation[i], d);
    }
    fprintf(stream, "\n%.40s, %s energy at %.4g deg, %.20s\n", pdmc_one_line(text[0], pdmc_compared_name(c, tip)),
            pdmc_measure_title(c->measure), angle->angle * pdmc_degrees, pdmc_one_line(text[1], unit));
    print_row(stream, "nominal", nominal[0], nominal[1]);
    print_row(stream, "mean", mean[0], mean[1]);
    print_row(stream, "standard deviation", deviation[0], deviation[1]);
    print_row(stream, "variation", variation[0], variation[1]);
    print_distances(c, angle, s[0]->mean[angle->place[0]].value, stream);
}

/// What the intervals are, and whether they are those of pairs.
static void print_pairing(const pdmc_comparison *c, FILE *stream)
{
    fprintf(stream, "\n[intervals] at %g %% confidence; A and B are taken as %s\n", 100.0 * c->results[0]->confidence,
            c->paired ? "pairs, drawn with the same random numbers:" : "independent samples");
    if (!c->paired) return;
    fprintf(stream, "  the load factors are %s, the stiffness of the bonds is %s\n",
            c->same_load ? "the same" : "others", c->same_micromodulus ? "the same" : "another");
}

typedef struct {
    const char *name;
    size_t member; // of pdmc_runtime
} phase;

static double phase_of(const pdmc_comparison *c, int which, const phase *p)
{
    return *(const double *)((const char *)&c->results[which]->runtime + p->member);
}

static void print_runtime(const pdmc_comparison *c, FILE *stream)
{
    static const phase phases[] = {
        {"assembly", offsetof(pdmc_runtime, assembly)},     {"factorisation", offsetof(pdmc_runtime, factorisation)},
        {"operators", offsetof(pdmc_runtime, operators)},   {"energy rows", offsetof(pdmc_runtime, energy_rows)},
        {"sampling", offsetof(pdmc_runtime, sampling)},     {"energy", offsetof(pdmc_runtime, energy)},
        {"statistics", offsetof(pdmc_runtime, statistics)}, {"motion", offsetof(pdmc_runtime, motion)},
        {"output", offsetof(pdmc_runtime, output)},         {"total", offsetof(pdmc_runtime, total)},
    };
    char n[PDMC_BRIEF_SIZE];
    cell cells[PDMC_COMPARED];
    fputs("\nseconds\n", stream);
    for (size_t k = 0; k < sizeof phases / sizeof phases[0]; k++) {
        if (phase_of(c, 0, &phases[k]) == 0.0 && phase_of(c, 1, &phases[k]) == 0.0)
            continue; // not of this kind of study
        for (int i = 0; i < PDMC_COMPARED; i++) snprintf(cells[i], sizeof cells[i], "%.2f", phase_of(c, i, &phases[k]));
        print_row(stream, phases[k].name, cells[0], cells[1]);
    }
    for (int i = 0; i < PDMC_COMPARED; i++) snprintf(cells[i], sizeof cells[i], "%d", c->results[i]->runtime.threads);
    print_row(stream, "threads", cells[0], cells[1]);
    for (int i = 0; i < PDMC_COMPARED; i++)
        snprintf(cells[i], sizeof cells[i], "%s", pdmc_brief(n, c->results[i]->runtime.peak_memory / 1e6));
    print_row(stream, "peak memory, MB", cells[0], cells[1]);
}

pdmc_status pdmc_view_comparison_table(const pdmc_comparison *c, FILE *stream)
{
    pdmc_locale locale;
    const pdmc_status status = pdmc_locale_plain(&locale);
    if (status != PDMC_OK) return status;
    print_row(stream, "", "A", "B");
    print_studies(c, stream);
    for (int t = 0; t < c->tip_count; t++) print_tip(c, &c->tips[t], stream);
    if (c->results[0]->kind == PDMC_STATIC) print_pairing(c, stream);
    for (int t = 0; t < c->tip_count; t++)
        for (int k = 0; k < c->tips[t].angle_count; k++) print_angle(c, &c->tips[t], &c->tips[t].angles[k], stream);
    print_runtime(c, stream);
    pdmc_locale_restore(&locale);
    if (fflush(stream) != 0 || ferror(stream)) return pdmc_raise(PDMC_ERR_IO, "the table cannot be written");
    return PDMC_OK;
}
