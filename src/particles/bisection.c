// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/bisection.h"

#include "base/base_impl.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>

typedef struct {
    const double *const *x;
    int size;
    double *value; // [count] of the points along an axis
    int *upper;    // [count] room
} bisection;

static int longest_axis(const bisection *b, int count, const int order[])
{
    double longest = -1.0;
    int axis = 0;
    for (int a = 0; a < PDMC_AXES; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k < count; k++) {
            low = fmin(low, b->x[a][order[k]]);
            high = fmax(high, b->x[a][order[k]]);
        }
        if (high - low > longest) longest = high - low, axis = a;
    }
    return axis;
}

/// The `lower` points that are lowest along an axis come first. Points keep their order otherwise.
static void split(const bisection *b, const double x[], int count, int lower, int order[])
{
    int below = 0, kept = 0, moved = 0;
    for (int k = 0; k < count; k++) b->value[k] = x[order[k]];
    const double middle = gsl_stats_select(b->value, 1, (size_t)count, (size_t)lower);
    for (int k = 0; k < count; k++) below += x[order[k]] < middle;
    for (int k = 0, level = lower - below; k < count; k++) {
        const bool is_level = x[order[k]] == middle;
        if (x[order[k]] < middle || (is_level && level > 0)) order[kept++] = order[k];
        else b->upper[moved++] = order[k];
        level -= is_level;
    }
    memcpy(&order[kept], b->upper, (size_t)moved * sizeof *order);
}

static void bisect(const bisection *b, int count, int order[])
{
    const int groups = (count + b->size - 1) / b->size, lower = groups / 2 * b->size;
    if (groups < 2) return;
    split(b, b->x[longest_axis(b, count, order)], count, lower, order);
    bisect(b, lower, order);
    bisect(b, count - lower, &order[lower]);
}

pdmc_status pdmc_bisect(const double *const x[PDMC_AXES], int count, int size, int order[])
{
    pdmc_status status = PDMC_OK;
    bisection b = {.x = x, .size = size};
    PDMC_NEW(b.value, count);
    PDMC_NEW(b.upper, count);
    bisect(&b, count, order);
done:
    pdmc_free(b.value);
    pdmc_free(b.upper);
    return status;
}
