// SPDX-License-Identifier: GPL-3.0-or-later

/// Conjugate gradients on a chain of springs, x_k to x_(k+1), of two materials; its first node is held.

#include "check.h"
#include "stochastic/krylov.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { N = 30, TERMS = 2 };

static int material(int spring)
{
    return spring % 3 == 0;
}

// y = sum of springs' forces; 0 where held.
static void forces(const double stiffness[TERMS], const double x[], double y[])
{
    for (int k = 0; k < N; k++) y[k] = 0.0;
    for (int k = 0; k + 1 < N; k++) {
        const double f = stiffness[material(k)] * (k + 1.0) * (x[k + 1] - x[k]);
        y[k] -= f;
        y[k + 1] += f;
    }
    y[0] = 0.0;
}

static pdmc_status multiply(const pdmc_affine *model, double mean, const double xi[], const double x[], double y[])
{
    (void)model;
    for (int s = 0; s < PDMC_BLOCK; s++) {
        const double stiffness[TERMS] = {mean + xi[s * TERMS], mean + xi[s * TERMS + 1]};
        forces(stiffness, &x[s * N], &y[s * N]);
    }
    return PDMC_OK;
}

static void solve_one(const double xi[], const double f[], double x[])
{
    double K[N * N] = {0.0};
    const double stiffness[TERMS] = {1.0 + xi[0], 1.0 + xi[1]};
    for (int k = 0; k < N; k++) {
        double unit[N] = {0.0};
        unit[k] = k > 0;
        forces(stiffness, unit, &K[k * N]);
    }
    K[0] = 1.0;
    memcpy(x, f, N * sizeof *x);
    lapack_int pivot[N];
    assert_int_equal(LAPACKE_dgesv(LAPACK_COL_MAJOR, N, 1, K, N, pivot, x, N), 0);
}

static pdmc_status precondition(const pdmc_affine *model, int count, const double r[], double z[])
{
    (void)model;
    const double none[TERMS] = {0.0, 0.0};
    for (int s = 0; s < count; s++) solve_one(none, &r[s * N], &z[s * N]);
    return PDMC_OK;
}

static const pdmc_affine_verbs verbs = {.multiply = multiply, .precondition = precondition};
static const pdmc_affine chain = {.unknowns = N, .terms = TERMS, .verbs = &verbs};

static double xi[PDMC_BLOCK * TERMS], f[PDMC_BLOCK * N], x[PDMC_BLOCK * N];

// Loads and deviations that differ from column to column; the last column has no load.
static void make_block(void)
{
    for (int s = 0; s < PDMC_BLOCK; s++) {
        xi[s * TERMS] = 0.5 * sin(s);
        xi[s * TERMS + 1] = 0.5 * cos(3.0 * s);
        for (int k = 0; k < N; k++) f[s * N + k] = k > 0 && s + 1 < PDMC_BLOCK ? sin(0.7 * k + s) : 0.0;
    }
    assert_int_equal(precondition(&chain, PDMC_BLOCK, f, x), PDMC_OK);
}

// An error of 1e-10 in the energy norm, relative to the load's, at a smallest eigenvalue of 0.5 of the preconditioned
// operator: 2e-10 of the norm of x, with a condition of some 1e3 between the norms.
static void the_exact_solution_is_found(void **state)
{
    (void)state;
    double residual[PDMC_BLOCK], exact[N];
    make_block();
    CHECK_OK(pdmc_krylov_solve(&chain, xi, 1e-10, x, residual));
    for (int s = 0; s < PDMC_BLOCK; s++) {
        double size = 0.0, error = 0.0;
        solve_one(&xi[s * TERMS], &f[s * N], exact);
        for (int k = 0; k < N; k++) {
            size = fmax(size, fabs(exact[k]));
            error = fmax(error, fabs(x[s * N + k] - exact[k]));
        }
        assert_true(error <= 2e-7 * size);
        assert_true(residual[s] <= 1e-10);
    }
}

static void columns_do_not_see_each_other(void **state)
{
    (void)state;
    static double alone[PDMC_BLOCK * N];
    double residual[PDMC_BLOCK];
    make_block();
    CHECK_OK(pdmc_krylov_solve(&chain, xi, 1e-8, x, residual));
    memcpy(alone, x, sizeof alone);
    const double kept[TERMS] = {xi[5 * TERMS], xi[5 * TERMS + 1]};
    make_block();
    for (int k = 0; k < PDMC_BLOCK * TERMS; k++) xi[k] *= -0.9;
    memcpy(&xi[5 * TERMS], kept, sizeof kept);
    CHECK_OK(pdmc_krylov_solve(&chain, xi, 1e-8, x, residual));
    assert_memory_equal(&alone[5 * N], &x[5 * N], N * sizeof(double));
}

static void an_indefinite_matrix_is_seen(void **state)
{
    (void)state;
    double residual[PDMC_BLOCK];
    make_block();
    xi[2 * TERMS] = -1.5;
    CHECK_OK(pdmc_krylov_solve(&chain, xi, 1e-8, x, residual));
    assert_true(isnan(residual[2]));
    assert_true(residual[1] <= 1e-8 && residual[3] <= 1e-8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_exact_solution_is_found),
        cmocka_unit_test(columns_do_not_see_each_other),
        cmocka_unit_test(an_indefinite_matrix_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
