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

static const char *print_rate(char text[PDMC_BRIEF_SIZE], const double values[], int level)
{
    snprintf(text, PDMC_BRIEF_SIZE, level > 0 ? "%.2f" : "-", pdmc_rate_of(values, level));
    return text;
}

static void print_errors(const pdmc_results *r, FILE *stream)
{
    const pdmc_scalar_record *s = &r->scalar;
    char n[7][PDMC_BRIEF_SIZE], unit[PDMC_LINE_SIZE];
    fprintf(stream, "\nlevels, lengths in %.20s; error: root of the mean square difference\n",
            pdmc_one_line(unit, r->length_unit));
    fprintf(stream, "  %10s %10s %9s %9s %11s %6s", "spacing", "horizon", "elements", "unknowns", "to the wave",
            "rate");
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
    fprintf(stream, "\nmotion, the wave standing; the longest stable step by the largest eigenvalue\n");
    fprintf(stream, "  %10s %12s %10s %9s %11s %6s\n", "spacing", "stable step", "+-", "steps", "to the wave", "rate");
    for (int i = 0; i < s->level_count; i++)
        fprintf(stream, "  %10s %12.8g %10.1e %9.0f %11s %6s\n", pdmc_brief(n[0], s->spacing[i]), s->stable_step[i],
                s->stable_step_error[i], s->steps[i], pdmc_brief(n[1], s->motion_error[i]),
                print_rate(n[2], s->motion_error, i));
}

void pdmc_table_scalar(const pdmc_results *r, FILE *stream)
{
    const pdmc_scalar_record *s = &r->scalar;
    char n[2][PDMC_BRIEF_SIZE], unit[PDMC_LINE_SIZE];
    fprintf(stream, "  scalar field in %s, kernel r^-%s, wave number %s 1/%.20s\n",
            s->dimension == 1 ? "one dimension" : "the plane", pdmc_brief(n[0], s->power),
            pdmc_brief(n[1], s->wave_number), pdmc_one_line(unit, r->length_unit));
    if (r->mesh_generator && *r->mesh_generator)
        fprintf(stream, "  mesh by %s\n", pdmc_one_line(unit, r->mesh_generator));
    print_errors(r, stream);
    print_motion(s, stream);
    fprintf(stream, "\nkept     %d values of the last level\n", s->value_count);
}
