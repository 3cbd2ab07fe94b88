// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

enum { MAX_ITERATIONS = 5000, MAX_CORRECTIONS = 200 };
static const double BALANCE = 1e-4; // of loads that nothing holds, of their size: the traction's rule leaves 1e-6

double solid_dot(size_t count, const double a[], const double b[])
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) sum += a[i] * b[i];
    return sum;
}

double solid_norm(size_t count, const double a[])
{
    return sqrt(solid_dot(count, a, a));
}

/// The forces that bring free nodes to rest: those of prescribed nodes are reactions, and a body that nothing holds does
/// not feel its rigid motions.
static void keep_free(const pdmc_solid *solid, const solid_rigid *rigid, double v[])
{
    for (size_t i = 0; i < solid->nodes; i++)
        if (solid->prescribed[i]) v[i] = v[solid->nodes + i] = v[2 * solid->nodes + i] = 0.0;
    solid_rigid_remove(rigid, v);
}

/// Reduces `residual`, the force of the bonds about u, by conjugate gradients scaled by the rows.
static pdmc_status conjugate_gradients(const pdmc_solid *solid, const solid_rigid *rigid, double tolerance,
                                       double residual[], double u[], pdmc_solid_solution *solution)
{
    pdmc_status status = PDMC_OK;
    const size_t n = 3 * solid->nodes;
    double *search = NULL, *answer = NULL, *scaled = NULL;
    PDMC_NEW(search, n);
    PDMC_NEW(answer, n);
    PDMC_NEW(scaled, n);
    const double first = solid_norm(n, residual);
    double before = 0.0;
    for (solution->iterations = 0; solution->iterations < MAX_ITERATIONS; solution->iterations++) {
        solution->residual = first > 0.0 ? solid_norm(n, residual) / first : 0.0;
        if (solution->residual <= tolerance) goto done;
        for (size_t i = 0; i < n; i++) scaled[i] = residual[i] / solid->row_sum[i];
        solid_rigid_remove(rigid, scaled);
        const double now = solid_dot(n, residual, scaled), share = solution->iterations ? now / before : 0.0;
        for (size_t i = 0; i < n; i++) search[i] = scaled[i] + share * search[i];
        memset(answer, 0, n * sizeof *answer);
        solid_add_bond_forces(solid, search, search, answer, NULL);
        keep_free(solid, rigid, answer);
        const double stiffness = -solid_dot(n, search, answer);
        if (!(stiffness > 0.0)) PDMC_FAIL(PDMC_ERR_SINGULAR, "nothing holds the body");
        for (size_t i = 0; i < n; i++) {
            u[i] += now / stiffness * search[i];
            residual[i] += now / stiffness * answer[i];
        }
        before = now;
    }
    PDMC_FAIL(PDMC_ERR_SINGULAR, "no equilibrium after %d iterations: residual %g, wanted %g", MAX_ITERATIONS,
              solution->residual, tolerance);
done:
    pdmc_free(search);
    pdmc_free(answer);
    pdmc_free(scaled);
    return status;
}

/// Corrections by the body of cubic cells, whose bonds are nearly those of the body, until the body's own forces are small.
static pdmc_status correct(const pdmc_solid *solid, const solid_rigid *rigid, double tolerance, double residual[],
                           double u[], pdmc_solid_solution *solution)
{
    pdmc_status status = PDMC_OK;
    const size_t n = 3 * solid->nodes;
    const double first = solid_norm(n, residual);
    double *step = NULL;
    PDMC_NEW(step, n);
    for (int round = 0;; round++) {
        pdmc_solid_solution inner;
        solution->residual = first > 0.0 ? solid_norm(n, residual) / first : 0.0;
        if (solution->residual <= tolerance) break;
        if (round == MAX_CORRECTIONS || !(solution->residual < 1e3))
            PDMC_FAIL(PDMC_ERR_SINGULAR, "no equilibrium after %d corrections: residual %g, wanted %g", round,
                      solution->residual, tolerance);
        memset(step, 0, n * sizeof *step);
        PDMC_TRY(conjugate_gradients(solid->cells, rigid, 0.03, residual, step, &inner));
        solution->iterations += inner.iterations;
        for (size_t i = 0; i < n; i++) u[i] += step[i];
        pdmc_solid_force(solid, u, residual, NULL);
        keep_free(solid, rigid, residual);
    }
done:
    pdmc_free(step);
    return status;
}

pdmc_status pdmc_solid_rest(const pdmc_solid *solid, double tolerance, double u[], pdmc_solid_solution *solution)
{
    pdmc_status status = PDMC_OK;
    const size_t n = 3 * solid->nodes;
    solid_rigid rigid = {0};
    double *residual = NULL;
    *solution = (pdmc_solid_solution){0};
    PDMC_REQUIRE(tolerance > 0.0, "the tolerance of equilibrium must be positive");
    PDMC_TRY(solid_rigid_create(solid, &rigid));
    PDMC_NEW(residual, n);
    pdmc_solid_force(solid, u, residual, NULL);
    if (rigid.count && solid->cells)
        PDMC_FAIL(PDMC_ERR_ARG, "Gauss points need a body that is held: their forces are not in balance by themselves");
    if (rigid.count) {
        const double all = solid_norm(n, residual);
        solid_rigid_remove(&rigid, residual);
        const double kept = solid_norm(n, residual);
        if (all * all - kept * kept > BALANCE * BALANCE * all * all)
            PDMC_FAIL(PDMC_ERR_ARG, "nothing holds the body, and its loads are not in balance");
    }
    keep_free(solid, &rigid, residual);
    PDMC_TRY((solid->cells ? correct : conjugate_gradients)(solid, &rigid, tolerance, residual, u, solution));
done:
    solid_rigid_clear(&rigid);
    pdmc_free(residual);
    return status;
}
