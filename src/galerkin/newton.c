// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/law_bonds.h"
#include "galerkin/solve.h"

#include <math.h>
#include <string.h>

enum { MOST_HALVINGS = 12 };

static const double tolerance = 1e-11; // of the residual; rounding leaves 1e-14 or so of the sums over bonds

typedef struct {
    const pdmc_law_bonds *bonds;
    const double *load;
    int free_count;
    double *u;        // [count] the caller's
    double *trial;    // [count]
    double *residual; // [free_count] load - F
    double *step;     // [free_count]
    double scale;     // of residuals
} newton;

static double norm(int n, const double x[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += x[i] * x[i];
    return sqrt(sum);
}

static double find_residual(const newton *n, const double u[], double residual[])
{
    double energy;
    pdmc_law_bonds_force(n->bonds, u, residual, &energy);
    for (int i = 0; i < n->free_count; i++) residual[i] = n->load[i] - residual[i];
    return norm(n->free_count, residual);
}

// From where linear bonds would be at rest, so that no bond of the start is stretched by a jump at the layer.
static pdmc_status start(newton *n)
{
    pdmc_status status = PDMC_OK;
    pdmc_form form = {0};
    const pdmc_assembly *a = &n->bonds->assembly;
    PDMC_TRY(pdmc_form_pattern(a->space, &a->neighbours, &form));
    pdmc_assembly_add(a, NULL, NULL, &(pdmc_assembled){.form = &form});
    memset(n->u, 0, (size_t)n->free_count * sizeof *n->u);
    pdmc_form_multiply(&form, n->u, n->residual);
    for (int i = 0; i < n->free_count; i++) n->residual[i] = n->load[i] - n->residual[i];
    n->scale = norm(n->free_count, n->residual);
    PDMC_TRY(pdmc_form_solve(&form, n->load, n->u));
done:
    pdmc_form_clear(&form);
    return status;
}

static pdmc_status find_step(newton *n, int iteration)
{
    pdmc_status status = PDMC_OK;
    pdmc_form tangent = {0};
    pdmc_sparse_factor *factor = NULL;
    PDMC_TRY(pdmc_law_bonds_tangent(n->bonds, n->u, &tangent));
    status = pdmc_form_factor(&tangent, &factor);
    if (status == PDMC_ERR_SINGULAR)
        PDMC_FAIL(status,
                  "iteration %d: the tangent is not positive definite: bonds give way under this load, or nothing holds "
                  "the elements",
                  iteration + 1);
    PDMC_TRY(status);
    PDMC_TRY(pdmc_sparse_factor_solve(factor, 1, n->residual, n->step));
done:
    pdmc_sparse_factor_destroy(&factor);
    pdmc_form_clear(&tangent);
    return status;
}

// Halves the step until it lessens the residual.
static pdmc_status go(newton *n, double before, pdmc_newton *report)
{
    const double least = 1e-4; // of what the linear model promises; the usual choice
    double share = 1.0;
    for (int halvings = 0; halvings <= MOST_HALVINGS; halvings++, share *= 0.5) {
        for (int i = 0; i < n->free_count; i++) n->trial[i] = n->u[i] + share * n->step[i];
        const double after = find_residual(n, n->trial, n->residual);
        if (!(after <= (1.0 - least * share) * before)) continue;
        memcpy(n->u, n->trial, (size_t)n->free_count * sizeof *n->u);
        report->halvings += halvings;
        report->residual[++report->iterations] = after / n->scale;
        return PDMC_OK;
    }
    return pdmc_raise(PDMC_ERR_SINGULAR,
                      "iteration %d: no step lessens the residual of %.3g: the bonds find no rest under this load",
                      report->iterations + 1, before / n->scale);
}

pdmc_status pdmc_law_bonds_solve(const pdmc_law_bonds *bonds, const double load[], double u[], pdmc_newton *report)
{
    pdmc_status status = PDMC_OK;
    const pdmc_space *space = bonds->assembly.space;
    newton n = {.bonds = bonds, .load = load, .free_count = space->free_count, .u = u};
    *report = (pdmc_newton){0};
    PDMC_NEW(n.trial, space->count);
    PDMC_NEW(n.residual, space->free_count);
    PDMC_NEW(n.step, space->free_count);
    PDMC_TRY(start(&n));
    if (n.scale == 0.0) goto done;
    memcpy(n.trial, u, (size_t)space->count * sizeof *u);
    report->residual[0] = find_residual(&n, u, n.residual) / n.scale;
    while (report->residual[report->iterations] > tolerance) {
        if (report->iterations == PDMC_NEWTON_MOST)
            PDMC_FAIL(PDMC_ERR_SINGULAR, "%d iterations leave a residual of %.3g", PDMC_NEWTON_MOST,
                      report->residual[PDMC_NEWTON_MOST]);
        PDMC_TRY(find_step(&n, report->iterations));
        PDMC_TRY(go(&n, n.scale * report->residual[report->iterations], report));
    }
done:
    pdmc_free(n.trial);
    pdmc_free(n.residual);
    pdmc_free(n.step);
    return status;
}
