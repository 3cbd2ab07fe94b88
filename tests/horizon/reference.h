// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random cells, and what the thesis prints (Yu 2011).

#include "pdmc/horizon.h"
#include "pdmc/random.h"

enum { PRINTED_ROWS = 10 };
static const double printed_radius = 18.0;

// Tables 2.2 and 2.3: delta / dx, errors of the adaptive and the cubic rule in %, distance of the adaptive rule's
// points.
static const struct {
    int ratio;
    double adaptive, cubic, distance;
} printed_volumes[PRINTED_ROWS] = {{3, 0.050, 7.992, 1.708},  {4, 0.029, 10.525, 1.457}, {5, 0.025, 7.966, 1.239},
                                   {6, 0.017, 4.891, 1.121},  {8, 0.011, 5.367, 0.887},  {9, 0.009, 3.773, 0.817},
                                   {10, 0.007, 3.862, 0.755}, {15, 0.003, 2.415, 0.535}, {20, 0.002, 2.028, 0.415},
                                   {30, 0.001, 1.251, 0.286}};

// Table 2.3, the cubic rule: delta / dx, error in %, distance.
static const struct {
    int ratio;
    double error, distance;
} printed_cubic[PRINTED_ROWS] = {{11, 3.317, 1.636}, {13, 3.056, 1.386}, {15, 2.415, 1.200}, {16, 2.531, 1.127},
                                 {20, 2.028, 0.901}, {22, 1.833, 0.819}, {24, 1.635, 0.751}, {33, 1.120, 0.545},
                                 {44, 0.873, 0.409}, {63, 0.595, 0.286}};

/// Uniform in (0, 1): number `variable` of draw `draw`.
static inline double uniform(uint64_t draw, uint64_t variable)
{
    double u;
    pdmc_random_uniform(1, 0, draw, variable, 1, &u);
    return u;
}
