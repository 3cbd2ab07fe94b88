// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scalar.h"
#include "views/table.h"

#include <math.h>

static bool has_motion(const pdmc_scalar_record *s)
{
    return s->level_count > 0 && !isnan(s->stable_step[0]);
}

static bool has_classical(const pdmc_scalar_record *s)
{
    return s->level_count > 0 && !isnan(s->classical[0]);
}

static const char *compared_with(const pdmc_scalar_record *s)
{
    return isnan(s->wave_number) ? "to coarser" : "to the wave";
}

static const char *print_rate(char text[PDMC_BRIEF_SIZE], const double values[], int level)
{
    const double rate = pdmc_rate_of(values, level);
    snprintf(text, PDMC_BRIEF_SIZE, isnan(rate) ? "-" : "%.2f", rate);
    return text;
}

static void print_errors(const pdmc_results *r, FILE *stream)
{
    const pdmc_scalar_record *s = &r->scalar;
    char n[7][PDMC_BRIEF_SIZE], unit[PDMC_LINE_SIZE];
    fprintf(stream, "\nlevels, lengths in %.20s; error: root of the mean square difference\n",
            pdmc_one_line(unit, r->length_unit));
    fprintf(stream, "  %10s %10s %9s %9s %11s %6s", "spacing", "horizon", "elements", "unknowns",
            compared_with(s), "rate");
    fprintf(stream, has_classical(s) ? " %12s %6s %8s\n" : "%.0s%.0s %8s\n", "to classical", "rate", "seconds");
    for (int i = 0; i < s->level_count; i++) {
        fprintf(stream, "  %10s %10s %9.0f %9.0f %11s %6s", pdmc_brief(n[0], s->spacing[i]),
                pdmc_brief(n[1], s->horizon[i]), s->elements[i], s->unknowns[i], pdmc_brief(n[2], s->error[i]),
                print_rate(n[3], s->error, i));
        if (has_classical(s))
            fprintf(stream, " %12s %6s", pdmc_brief(n[4], s->classical[i]), print_rate(n[5], s->classical, i));
        fprintf(stream, " %8.2f\n", s->seconds[i]);
    }
}

static void print_motion(const pdmc_scalar_record *s, FILE *stream)
{
    char n[4][PDMC_BRIEF_SIZE];
    if (!has_motion(s)) return;
    const bool has_drift = !isnan(s->drift[0]);
    fprintf(stream, "\nmotion, %s; the longest stable step by the largest eigenvalue\n",
            isnan(s->wave_number) ? "from rest at 0 under a sudden source" : "the wave standing");
    fprintf(stream, "  %10s %12s %10s %9s %11s %6s%s\n", "spacing", "stable step", "+-", "steps", compared_with(s), "rate",
            has_drift ? "  drift of energy" : "");
    for (int i = 0; i < s->level_count; i++) {
        fprintf(stream, "  %10s %12.8g %10.1e %9.0f %11s %6s", pdmc_brief(n[0], s->spacing[i]), s->stable_step[i],
                s->stable_step_error[i], s->steps[i], pdmc_brief(n[1], s->motion_error[i]),
                print_rate(n[2], s->motion_error, i));
        if (has_drift) fprintf(stream, " %16.1e", s->drift[i]);
        fputc('\n', stream);
    }
}

static void print_rest(const pdmc_scalar_record *s, FILE *stream)
{
    char n[PDMC_BRIEF_SIZE];
    if (s->level_count == 0 || isnan(s->iterations[0])) return;
    fprintf(stream, "\nrest of bonds with a law, by Newton's method\n  %10s %10s %14s\n", "spacing", "iterations",
            "residual left");
    for (int i = 0; i < s->level_count; i++)
        fprintf(stream, "  %10s %10.0f %14.1e\n", pdmc_brief(n, s->spacing[i]), s->iterations[i], s->residual[i]);
}

void pdmc_table_scalar(const pdmc_results *r, FILE *stream)
{
    const pdmc_scalar_record *s = &r->scalar;
    char n[2][PDMC_BRIEF_SIZE], unit[PDMC_LINE_SIZE];
    fprintf(stream, "  scalar field in %s, kernel r^-%s, ", s->dimension == 1 ? "one dimension" : "the plane",
            pdmc_brief(n[0], s->power));
    if (isnan(s->wave_number)) fputs("under the study's own source\n", stream);
    else
        fprintf(stream, "wave number %s 1/%.20s\n", pdmc_brief(n[1], s->wave_number), pdmc_one_line(unit, r->length_unit));
    print_errors(r, stream);
    print_rest(s, stream);
    print_motion(s, stream);
    fprintf(stream, "\nkept     %d values of the last level\n", s->value_count);
}
