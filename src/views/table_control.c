// SPDX-License-Identifier: GPL-3.0-or-later

/// In the table: what a cheaper method's samples say of a tip, and what they took.

#include "views/table.h"

#include <math.h>

static int largest_mean(const pdmc_results *r, int tip)
{
    const pdmc_estimate *mean = &r->control.mean[pdmc_place(r, tip, 0)];
    int best = 0;
    for (int k = 1; k < r->angle_count; k++)
        if (mean[k].value > mean[best].value) best = k;
    return best;
}

static void print_estimate(const pdmc_estimate *e, double samples, FILE *stream)
{
    char n[4][PDMC_BRIEF_SIZE];
    fprintf(stream, "%s [%s, %s], worth %s samples", pdmc_brief(n[0], e->value), pdmc_brief(n[1], e->lower),
            pdmc_brief(n[2], e->upper), pdmc_brief(n[3], samples));
}

void pdmc_table_controlled_tip(const pdmc_results *r, int tip, FILE *stream)
{
    char n[PDMC_BRIEF_SIZE];
    const pdmc_control_results *c = &r->control;
    if (c->tip_count == 0 || r->angle_count == 0) return;
    const int angle = largest_mean(r, tip);
    const size_t at = pdmc_place(r, tip, angle);
    fprintf(stream, "  P(G > G_c) = ");
    print_estimate(&c->probability[tip], r->sample_count * c->probability_gain[tip], stream);
    fprintf(stream, " with the control\n  mean %s at %.4g deg = ", pdmc_measure_title(r->measure),
            r->angles[angle] * pdmc_degrees);
    print_estimate(&c->mean[at], r->sample_count * c->mean_gain[at], stream);
    fprintf(stream, " (R %s)\n", pdmc_brief(n, c->correlation[at]));
}

void pdmc_table_control(const pdmc_results *r, FILE *stream)
{
    const pdmc_control_results *c = &r->control;
    if (c->tip_count == 0) return;
    fprintf(stream, "control  %.0f samples of a cheaper method, %.0f failed, %.2f s\n", c->samples, c->failed,
            r->runtime.control);
    if (isfinite(c->advised_samples))
        fprintf(stream, "         means would be known best for the time with some %.2g of them\n", c->advised_samples);
}
