// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/results.h"

#include <math.h>

static double norm_of(const pdmc_explicit_record *r, const double values[], int at, int condition)
{
    const double *x = &values[PDMC_AXES * ((size_t)at * (size_t)r->condition_count + (size_t)condition)];
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

int pdmc_results_largest_force(const pdmc_explicit_record *r, int condition, double *force)
{
    int at = 0;
    double largest = 0.0;
    for (int i = 0; i < r->record_count; i++) {
        const double norm = norm_of(r, r->condition_force, i, condition);
        if (norm > largest) at = i, largest = norm;
    }
    if (force) *force = largest;
    return at;
}

double pdmc_results_force_between(const pdmc_explicit_record *r, int condition)
{
    double most = NAN;
    if (r->conditions[condition].kind != PDMC_CONDITION_DISPLACEMENT) return most;
    for (int i = 0; i < r->record_count; i++) {
        const double force = norm_of(r, r->condition_force, i, condition);
        const double here = norm_of(r, r->condition_displacement, i, condition);
        const double next = i + 1 < r->record_count ? norm_of(r, r->condition_displacement, i + 1, condition) : here;
        if (here > 0.0) most = fmax(most, force * fmax(1.0, next / here));
    }
    return most;
}
