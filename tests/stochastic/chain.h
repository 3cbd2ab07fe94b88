// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A chain of springs, x_k to x_(k+1) and to x_(k+2), of two materials, the stiffness of each a term; its first node is held.
/// It is redundant: by springs between neighbours alone, six vectors would hold all answers to a load and two rows.

#include "check.h"
#include "pdmc/affine.h"

#include <lapacke.h>
#include <string.h>

enum { N = 30, TERMS = 2 };

static inline void chain_pull(const double stiffness[TERMS], const double x[], int k, int span, double y[])
{
    const double f = stiffness[k % (2 + span) == 0] * (k + 1.0) * (x[k + span] - x[k]);
    y[k] -= f;
    y[k + span] += f;
}

// y = sum of springs' forces; 0 where held.
static inline void chain_forces(const double stiffness[TERMS], const double x[], double y[])
{
    for (int k = 0; k < N; k++) y[k] = 0.0;
    for (int k = 0; k + 1 < N; k++) chain_pull(stiffness, x, k, 1, y);
    for (int k = 0; k + 2 < N; k++) chain_pull(stiffness, x, k, 2, y);
    y[0] = 0.0;
}

static inline pdmc_status chain_multiply(const pdmc_affine *model, double mean, const double xi[], const double x[],
                                         double y[])
{
    (void)model;
    for (int s = 0; s < PDMC_BLOCK; s++) {
        const double stiffness[TERMS] = {mean + xi[s * TERMS], mean + xi[s * TERMS + 1]};
        chain_forces(stiffness, &x[s * N], &y[s * N]);
    }
    return PDMC_OK;
}

// K(xi), with a 1 where it is held.
static inline void chain_matrix(const double xi[], double K[N * N])
{
    const double stiffness[TERMS] = {1.0 + xi[0], 1.0 + xi[1]};
    for (int k = 0; k < N; k++) {
        double unit[N] = {0.0};
        unit[k] = k > 0;
        chain_forces(stiffness, unit, &K[k * N]);
    }
    K[0] = 1.0;
}

static inline void chain_solve(const double xi[], const double f[], double x[])
{
    double K[N * N];
    lapack_int pivot[N];
    chain_matrix(xi, K);
    memcpy(x, f, N * sizeof *x);
    assert_int_equal(LAPACKE_dgesv(LAPACK_COL_MAJOR, N, 1, K, N, pivot, x, N), 0);
}

static inline pdmc_status chain_precondition(const pdmc_affine *model, int count, const double r[], double z[])
{
    (void)model;
    const double none[TERMS] = {0.0, 0.0};
    for (int s = 0; s < count; s++) chain_solve(none, &r[s * N], &z[s * N]);
    return PDMC_OK;
}
