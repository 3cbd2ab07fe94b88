// SPDX-License-Identifier: GPL-3.0-or-later

/// Conjugate gradients on a chain of springs.

#include "stochastic/chain.h"
#include "stochastic/krylov.h"

#include <math.h>

static const pdmc_affine_verbs verbs = {.multiply = chain_multiply, .precondition = chain_precondition};
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
    assert_int_equal(chain_precondition(&chain, PDMC_BLOCK, f, x), PDMC_OK);
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
        chain_solve(&xi[s * TERMS], &f[s * N], exact);
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
