// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/results.h"

#include <math.h>

int pdmc_results_largest_force(const pdmc_explicit_record *r, int condition, double *force)
{
    int at = 0;
    double largest = 0.0;
    for (int i = 0; i < r->record_count; i++) {
        const double *f = &r->condition_force[PDMC_AXES * ((size_t)i * (size_t)r->condition_count + (size_t)condition)];
        const double norm = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
        if (norm > largest) at = i, largest = norm;
    }
    if (force) *force = largest;
    return at;
}
