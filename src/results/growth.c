// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/results.h"

#include <math.h>

static double of_tip(const pdmc_explicit_record *r, const double values[], int at, int tip)
{
    return values[(size_t)at * (size_t)r->tip_count + (size_t)tip];
}

pdmc_tip_growth pdmc_results_growth(const pdmc_explicit_record *r, int tip)
{
    pdmc_tip_growth g = {.begin = NAN, .end = NAN, .mean_speed = NAN, .most_speed = NAN};
    if (r->record_count == 0) return g;
    g.growth = of_tip(r, r->tip_advance, r->record_count - 1, tip);
    double first = 0.0;
    for (int i = r->record_count - 1; i >= 0; i--) { // backwards, so that the first that fits is kept
        const double advance = of_tip(r, r->tip_advance, i, tip);
        if (advance > 0.0) g.begin = r->time[i], first = advance;
        if (advance >= g.growth && g.growth > 0.0) g.end = r->time[i];
        g.most_speed = fmax(g.most_speed, of_tip(r, r->tip_speed, i, tip));
    }
    if (g.end > g.begin) g.mean_speed = (g.growth - first) / (g.end - g.begin);
    return g;
}
