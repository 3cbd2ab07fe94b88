// SPDX-License-Identifier: GPL-3.0-or-later

/// Rare growth in the table: what each method says of its probability, and the quantities that the margin comes from.

#include "views/table.h"

#include <math.h>

static void print_record(const pdmc_reliability_record *record, FILE *stream)
{
    char n[7][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    const pdmc_estimate *p = &record->found.probability, *index = &record->found.index;
    fprintf(stream, "  %-20.20s P = %s [%s, %s], index %s [%s, %s]\n", pdmc_one_line(text, record->name),
            pdmc_brief(n[0], p->value), pdmc_brief(n[1], p->lower), pdmc_brief(n[2], p->upper),
            pdmc_brief(n[3], index->value), pdmc_brief(n[4], index->lower), pdmc_brief(n[5], index->upper));
    fprintf(stream, "  %-20s coefficient of variation %s after %.0f points%s", "",
            pdmc_brief(n[6], record->found.variation), record->evaluations, record->complete ? "" : ", NOT CONVERGED");
    if (record->failed > 0.0) fprintf(stream, ", %.0f failed", record->failed);
    fputc('\n', stream);
}

static void print_index(const pdmc_estimate *index, int width, FILE *stream)
{
    char bounds[2 * PDMC_BRIEF_SIZE + 4];
    snprintf(bounds, sizeof bounds, "[%.3g, %.3g]", index->lower, index->upper);
    fprintf(stream, "  %9.3g %-*s", index->value, width, bounds);
}

static void print_groups(const pdmc_reliability_results *r, FILE *stream)
{
    char n[PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    const bool has_indices = isfinite(r->groups[0].total.value);
    const int width = 20;
    fprintf(stream, "  %-18s importance%s\n", "comes from",
            has_indices ? "      first [Sobol' index]          total [Sobol' index]" : "");
    for (int g = 0; g < r->group_count; g++) {
        fprintf(stream, "  %-18.18s %10s", pdmc_one_line(text, r->groups[g].name),
                pdmc_brief(n, r->groups[g].importance));
        if (has_indices) print_index(&r->groups[g].first, width, stream);
        if (has_indices) print_index(&r->groups[g].total, 0, stream);
        fputc('\n', stream);
    }
}

static void print_first_order(const pdmc_reliability_results *r, FILE *stream)
{
    char n[2][PDMC_BRIEF_SIZE];
    if (isfinite(r->first_order_index))
        fprintf(stream, "  %-20s P = %s, index %s after %.0f points; no error known\n", "first order",
                pdmc_brief(n[0], r->first_order_probability), pdmc_brief(n[1], r->first_order_index),
                r->first_order_evaluations);
    else if (isfinite(r->first_order_evaluations))
        fprintf(stream, "  %-20s no design point found after %.0f points\n", "first order", r->first_order_evaluations);
}

// What one design point misses shows in this alone.
static void print_contradiction(const pdmc_reliability_results *r, FILE *stream)
{
    if (r->record_count < 2) return;
    const pdmc_estimate *a = &r->records[0].found.probability, *b = &r->records[1].found.probability;
    if (a->upper < b->lower || b->upper < a->lower)
        fprintf(stream, "  THE INTERVALS ARE APART: growth may have another design point, which sampling missed\n");
}

void pdmc_table_reliability(const pdmc_results *results, FILE *stream)
{
    const pdmc_reliability_results *r = &results->reliability;
    if (r->group_count == 0) return;
    fprintf(stream, "\ngrowth of any tip, and the margin log G / G_c\n");
    print_first_order(r, stream);
    for (int i = 0; i < r->record_count; i++) print_record(&r->records[i], stream);
    print_contradiction(r, stream);
    print_groups(r, stream);
    if (r->solved_in_full > 0.0) fprintf(stream, "  %.0f points solved in full\n", r->solved_in_full);
}
