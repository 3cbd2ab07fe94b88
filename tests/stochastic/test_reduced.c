// SPDX-License-Identifier: GPL-3.0-or-later

/// Bounds of the errors of rows by adjoint problems, on a chain of springs with two rows for its tip.

#include "stochastic/chain.h"
#include "stochastic/reduced.h"

#include <cblas.h>
#include <math.h>

enum { B = PDMC_BLOCK, ROWS = 2 };

// Z = L^-T G, K_0 = L L'.
static pdmc_status color(const pdmc_affine *model, const double g[], double z[])
{
    (void)model;
    const double none[TERMS] = {0.0, 0.0};
    double K[N * N];
    chain_matrix(none, K);
    memcpy(z, g, B * N * sizeof *z);
    assert_int_equal(LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', N, K, N), 0);
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit, N, B, 1.0, K, N, z, N);
    for (int s = 0; s < B; s++) z[s * N] = 0.0;
    return PDMC_OK;
}

static const pdmc_affine_verbs verbs = {.multiply = chain_multiply, .precondition = chain_precondition, .color = color};

typedef struct {
    double load[N], solution[2 * N], row[ROWS * N], xi[B * TERMS];
    double bound[B * ROWS], by_norm[B * ROWS], error[B * ROWS]; // of the rows
} fixture;

static void fixture_make(fixture *f, double load, const double row[ROWS], double phase)
{
    const double none[TERMS] = {0.0, 0.0};
    *f = (fixture){0};
    for (int k = 1; k < N; k++) f->load[k] = load * sin(0.7 * k);
    for (int i = 0; i < ROWS * N; i++) f->row[i] = i % N > 0 ? row[i / N] * cos(0.3 * (i % N) + phase * (i / N)) : 0.0;
    for (int i = 0; i < B * TERMS; i++) f->xi[i] = 0.5 * sin(1.7 * i);
    chain_solve(none, f->load, &f->solution[N]);
}

// Bounds and errors of a reduced model whose rows may be off by `goal`.
static void solve(fixture *f, double goal)
{
    double identity[TERMS * TERMS] = {1.0, 0.0, 0.0, 1.0}, nothing[TERMS] = {0.0, 0.0};
    pdmc_uncertainty noise = {PDMC_QUANTITY_MICROMODULUS, .bins = TERMS, .variation = 0.3};
    const pdmc_problem problem = {.plate = {1, 1, 1},
                                  .material = {1.0, PDMC_PLANE_STRESS, 1.0},
                                  .uncertainty_count = 1,
                                  .uncertainties = &noise,
                                  .sampling = {.seed = 7, .samples = B}};
    const pdmc_affine chain = {.unknowns = N,
                               .terms = TERMS,
                               .radial_terms = TERMS,
                               .bins = TERMS,
                               .term_weight = identity,
                               .modulus_weight = nothing,
                               .cases = 2,
                               .solution = f->solution,
                               .tips = 1,
                               .stress_intensity = f->row,
                               .verbs = &verbs};
    const pdmc_reduced_goal asked = {.intensity = &goal};
    pdmc_variables variables;
    pdmc_affine reduced;
    pdmc_reduced_bound bound = {.intensity = f->bound};
    double y[B * N], x[N];
    CHECK_OK(pdmc_variables_create(&problem, &chain, &variables));
    CHECK_OK(pdmc_reduced_create(&variables, &asked, 1, &reduced));
    const int r = reduced.unknowns;
    assert_true(r < N - 1);
    CHECK_OK(pdmc_reduced_solve(&reduced, f->xi, NULL, y, &bound));
    for (int s = 0; s < B; s++) {
        chain_solve(&f->xi[s * TERMS], f->load, x);
        for (int k = 0; k < ROWS; k++) {
            const double found = cblas_ddot(r, &reduced.stress_intensity[k * r], 1, &y[s * r], 1);
            f->error[s * ROWS + k] = fabs(cblas_ddot(N, &f->row[k * N], 1, x, 1) - found);
            f->by_norm[s * ROWS + k] = bound.error[s] * reduced.intensity_bound[k] / sqrt(bound.coercivity[s]);
        }
    }
    pdmc_affine_clear(&reduced);
    pdmc_variables_clear(&variables);
}

static void errors_are_within_the_product_of_both_bounds(void **state)
{
    (void)state;
    fixture f;
    double worst = 0.0;
    fixture_make(&f, 1.0, (const double[ROWS]){1.0, 1.0}, 1.0);
    solve(&f, 3e-2);
    for (int i = 0; i < B * ROWS; i++) {
        assert_true(f.error[i] <= f.bound[i]);
        assert_true(f.bound[i] < 0.5 * f.by_norm[i]);
        worst = fmax(worst, f.error[i] / f.bound[i]);
    }
    print_message("the largest error is %.3f of its bound\n", worst);
    assert_true(worst > 0.01);
}

// A bound goes with the load, and with its own row; both problems are then the same but for their units. To a part of the
// rounding of 1e-10 beyond which directions are left out.
static void bounds_go_with_load_and_row(void **state)
{
    (void)state;
    const double units[2][1 + ROWS] = {{8.0, 1.0, 1.0}, {1.0, 8.0, 8.0}};
    fixture plain, scaled;
    fixture_make(&plain, 1.0, (const double[ROWS]){1.0, 1.0}, 1.0);
    solve(&plain, 3e-2);
    for (int u = 0; u < 2; u++) {
        fixture_make(&scaled, units[u][0], &units[u][1], 1.0);
        solve(&scaled, 8.0 * 3e-2);
        for (int i = 0; i < B * ROWS; i++) CHECK_NEAR(scaled.bound[i] / plain.bound[i], 8.0, 8e-6);
    }
}

static void a_row_has_its_own_bound(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f, 1.0, (const double[ROWS]){1.0, 8.0}, 0.0);
    solve(&f, 3e-1);
    for (int s = 0; s < B; s++) CHECK_NEAR(f.bound[ROWS * s + 1] / f.bound[ROWS * s], 8.0, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_within_the_product_of_both_bounds),
        cmocka_unit_test(bounds_go_with_load_and_row),
        cmocka_unit_test(a_row_has_its_own_bound),
    };
    pdmc_blas_prepare();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
