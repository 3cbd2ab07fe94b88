// SPDX-License-Identifier: GPL-3.0-or-later

/// The reduced model of a cracked grid against the iteration in full.

#include "bond/cracked.h"
#include "stochastic/krylov.h"
#include "stochastic/reduced.h"
#include "support/drawn_block.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

// sqrt(e' K(xi) e) of the error of a reduced displacement.
static void true_errors(const cracked *c, const pdmc_affine *reduced, const double xi[], const double y[],
                        double error[B])
{
    const int n = c->model.unknowns;
    double residual[B], *x = pdmc_calloc((size_t)B * (size_t)n, sizeof *x),
                        *Kx = pdmc_calloc((size_t)B * (size_t)n, sizeof *Kx);
    for (int s = 0; s < B; s++) memcpy(&x[s * n], pdmc_affine_solution(&c->model, 1), (size_t)n * sizeof *x);
    CHECK_OK(pdmc_krylov_solve(&c->model, xi, 1e-12, x, residual));
    CHECK_OK(c->model.verbs->multiply(&c->model, 1.0, xi, x, Kx));
    // Galerkin: e' K e = x' K x - y' V' F, and V' F = V' K_0 x_0 are the coordinates of the mean's answer.
    for (int s = 0; s < B; s++) {
        const double work = cblas_ddot(n, &x[s * n], 1, &Kx[s * n], 1);
        double reduced_work = 0.0;
        for (int j = 0; j < reduced->unknowns; j++)
            reduced_work += y[s * reduced->unknowns + j] * pdmc_affine_solution(reduced, 1)[j];
        error[s] = sqrt(fmax(work - reduced_work, 0.0));
    }
    pdmc_free(x);
    pdmc_free(Kx);
}

// Probes overestimate by the root of 64 over a chi-square quantile of some 15, about 2, and the share of the softest term
// by less than 1.6: measured 1.7 to 3.7. Training blocks stop at the tolerance; another block may be somewhat worse.
static void the_bound_holds(void **state)
{
    (void)state;
    cracked c;
    describe(&c, 100, 0.2);
    c.problem.solver.micromodulus = PDMC_MICROMODULUS_AT_NODES;
    make(&c);
    drawn_block drawn;
    const double *xi = drawn_block_begin(&drawn, &c.problem, &c.model, B)->drawn.xi;
    const double tolerances[3] = {3e-2, 3e-3, 3e-4};
    double size = 0.0;
    for (int i = 0; i < 3; i++) {
        pdmc_affine reduced;
        pdmc_reduced_bound bound;
        const pdmc_reduced_goal goal = {.error = tolerances[i]};
        double error[B], least = INFINITY, most = 0.0, worst = 0.0;
        CHECK_OK(pdmc_reduced_create(&drawn.variables, &goal, 2, &reduced));
        double *y = pdmc_calloc((size_t)B * (size_t)reduced.unknowns, sizeof *y);
        bound.intensity = pdmc_calloc(B * 2 * TIPS, sizeof(double));
        CHECK_OK(pdmc_reduced_solve(&reduced, xi, NULL, y, &bound));
        true_errors(&c, &reduced, xi, y, error);
        for (int s = 0; s < B; s++) {
            size = fmax(size, cblas_dnrm2(reduced.unknowns, &y[s * reduced.unknowns], 1));
            least = fmin(least, bound.error[s] / error[s]);
            most = fmax(most, bound.error[s] / error[s]);
            worst = fmax(worst, bound.error[s]);
        }
        print_message("tolerance %g: %d unknowns, largest bound %.2e, bound / error from %.2f to %.2f; size %.2f\n",
                      tolerances[i], reduced.unknowns, worst, least, most, size);
        assert_true(least >= 1.0);
        assert_true(most < 6.0);
        assert_true(worst < 2.0 * tolerances[i]);
        pdmc_free(y);
        pdmc_free(bound.intensity);
        pdmc_affine_clear(&reduced);
    }
    drawn_block_end(&drawn);
    clear(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bound_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
