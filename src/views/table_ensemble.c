// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/table.h"

#include <string.h>

enum { ESTIMATE_SIZE = 3 * PDMC_BRIEF_SIZE };

/// "value [lower, upper]".
static const char *with_interval(char text[ESTIMATE_SIZE], const pdmc_estimate *e)
{
    char n[3][PDMC_BRIEF_SIZE];
    snprintf(text, ESTIMATE_SIZE, "%s [%s, %s]", pdmc_brief(n[0], e->value), pdmc_brief(n[1], e->lower),
             pdmc_brief(n[2], e->upper));
    return text;
}

static void print_tip(const pdmc_results *r, int t, FILE *stream)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    char text[ESTIMATE_SIZE], name[PDMC_LINE_SIZE];
    fprintf(stream, "\n  %.60s\n", pdmc_one_line(name, r->particles.tips[t].name));
    for (int k = 0; k < PDMC_OUTCOMES; k++)
        fprintf(stream, "    P(%s)%*s %s\n", pdmc_outcome_names[k], 12 - (int)strlen(pdmc_outcome_names[k]), "",
                with_interval(text, &e->share[t * PDMC_OUTCOMES + k]));
    fprintf(stream, "    mean growth     %s\n", with_interval(text, &e->mean_growth[t]));
    fprintf(stream, "    deviation       %s\n", with_interval(text, &e->deviation[t]));
    for (int q = 0; q < PDMC_QUANTILES; q++)
        fprintf(stream, "    %2.0f %% quantile   %s\n", 100.0 * pdmc_quantile_levels[q],
                with_interval(text, &e->growth_quantiles[t * PDMC_QUANTILES + q]));
}

static void print_force(const pdmc_results *r, int c, FILE *stream)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    char text[ESTIMATE_SIZE], name[PDMC_LINE_SIZE], unit[PDMC_LINE_SIZE];
    fprintf(stream, "\n  %.60s, largest force, %.20s\n", pdmc_one_line(name, r->particles.conditions[c].name),
            pdmc_one_line(unit, r->force_unit));
    fprintf(stream, "    mean            %s\n", with_interval(text, &e->mean_force[c]));
    fprintf(stream, "    deviation       %s\n", with_interval(text, &e->force_deviation[c]));
    for (int q = 0; q < PDMC_QUANTILES; q++)
        fprintf(stream, "    %2.0f %% quantile   %s\n", 100.0 * pdmc_quantile_levels[q],
                with_interval(text, &e->force_quantiles[c * PDMC_QUANTILES + q]));
}

void pdmc_table_ensemble(const pdmc_results *r, FILE *stream)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    char length[PDMC_LINE_SIZE];
    if (e->sample_count == 0) return;
    fprintf(stream,
            "\n%d samples of seed %llu, %d failed; in %.20s, with intervals at %.3g; above is the study at its means\n",
            e->sample_count, (unsigned long long)r->seed, e->failed_count, pdmc_one_line(length, r->length_unit),
            r->confidence);
    for (int t = 0; t < e->tip_count; t++) print_tip(r, t, stream);
    for (int c = 0; c < e->condition_count; c++) print_force(r, c, stream);
    fprintf(stream, "\nseconds  samples %.2f\n", r->runtime.sampling);
}
