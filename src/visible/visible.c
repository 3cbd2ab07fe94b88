// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/visible.h"

#include "base/base_impl.h"
#include "visible/edge.h"
#include "visible/system.h"

#include <math.h>

static pdmc_status prepare(pdmc_visible *visible)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = visible->problem;
    PDMC_TRY(pdmc_cuts_create(problem, &visible->cuts));
    PDMC_TRY(pdmc_visible_nodes_create(problem, &visible->cuts, !visible->data.is_blind, !visible->data.outside,
                                       &visible->nodes));
    const bool is_cubic = problem->solver.stencil == PDMC_STENCIL_POLYHARMONIC;
    visible->field = (pdmc_stencil_field){visible->data.is_blind ? &visible->none : &visible->cuts, &visible->nodes,
                                          is_cubic, false};
    const bool is_random = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS) != NULL;
    visible->terms = is_random ? PDMC_VISIBLE_DEGREE + 1 : 0;
    visible->micromodulus = pdmc_micromodulus(&problem->material, problem->solver.horizon);
    visible->unknowns = 2 * visible->nodes.count;
    if (!visible->data.outside) PDMC_TRY(pdmc_problem_free_motions(problem, &visible->motions, visible->motion));
    PDMC_NEW(visible->stencils, visible->nodes.count);
    PDMC_NEW(visible->rows, visible->nodes.count);
    PDMC_TRY(pdmc_load_cases_create(problem, &visible->loads));
    visible->cases = 1 + visible->loads.count;
    PDMC_NEW(visible->load, visible->cases * visible->unknowns);
    PDMC_NEW(visible->solution, visible->cases * visible->unknowns);
    PDMC_NEW(visible->mean, visible->unknowns);
done:
    return status;
}

static pdmc_status make_stencils(pdmc_visible *visible)
{
    pdmc_status status = PDMC_OK;
#pragma omp parallel for schedule(dynamic, 16) num_threads(visible->threads)
    for (int i = 0; i < visible->nodes.count; i++) {
        const pdmc_status mine = pdmc_stencil_create(&visible->field, i, &visible->stencils[i]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_visible)
            status = mine;
        }
    }
    return status;
}

static pdmc_status make_row(pdmc_visible *visible, pdmc_disc_sum *sum, int i)
{
    double *held = &visible->load[2 * i];
    const int ring = visible->nodes.node[i].ring;
    if (ring > 1) return pdmc_visible_extension_row(visible, i, &visible->rows[i]);
    if (ring == 1) {
        for (int l = 1; l < visible->cases; l++)
            pdmc_visible_edge_load(visible, i, l - 1, &visible->load[l * visible->unknowns + 2 * i]);
        return pdmc_visible_edge_row(visible, i, &visible->rows[i], held);
    }
    return pdmc_visible_force_row(sum, i, &visible->rows[i], held);
}

static pdmc_status make_rows(pdmc_visible *visible)
{
    pdmc_status status = PDMC_OK;
#pragma omp parallel num_threads(visible->threads)
    {
        pdmc_disc_sum sum;
        pdmc_status mine = pdmc_disc_sum_create(visible, visible->terms + 1, false, &sum);
#pragma omp for schedule(dynamic, 16)
        for (int i = 0; i < visible->nodes.count; i++)
            if (mine == PDMC_OK) mine = make_row(visible, &sum, i);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_visible)
            status = mine;
        }
        pdmc_disc_sum_clear(&sum);
    }
    return status;
}

static pdmc_status solve_mean(pdmc_visible *visible)
{
    pdmc_status status = PDMC_OK;
    const int n = visible->unknowns;
    double *product = NULL;
    PDMC_NEW(product, n);
    for (int l = 0; l < visible->cases; l++)
        PDMC_TRY(pdmc_visible_solve(visible, &visible->factor, &visible->load[l * n], &visible->solution[l * n]));
    for (int i = 0; i < n; i++) visible->mean[i] = visible->solution[i] + visible->solution[n + i];
    pdmc_visible_product(visible, 0, visible->mean, product);
    for (int i = 0; i < n; i++)
        visible->residual = fmax(visible->residual, fabs(product[i] - visible->load[i] - visible->load[n + i]));
done:
    pdmc_free(product);
    return status;
}

pdmc_status pdmc_visible_create(const pdmc_problem *problem, const pdmc_visible_data *data, int threads,
                                pdmc_visible **visible)
{
    const int refinement = problem->solver.refinement;
    PDMC_REQUIRE(threads >= 1, "%d threads: at least one is needed", threads);
    PDMC_REQUIRE(2 <= refinement && refinement <= 16, "refinement %d is not in [2, 16]", refinement);
    pdmc_status status = PDMC_OK;
    pdmc_visible *made = NULL;
    const double start = pdmc_seconds();
    pdmc_blas_prepare();
    if (!data || !data->outside) PDMC_TRY(pdmc_problem_check_equilibrium(problem));
    PDMC_NEW(made, 1);
    made->problem = problem;
    made->threads = threads;
    if (data) made->data = *data;
    PDMC_TRY(prepare(made));
    PDMC_TRY(make_stencils(made));
    PDMC_TRY(make_rows(made));
    const double assembled = pdmc_seconds();
    PDMC_TRY(pdmc_visible_factor(made, NULL, &made->factor));
    PDMC_TRY(solve_mean(made));
    made->assembly_seconds = assembled - start;
    made->factorisation_seconds = pdmc_seconds() - assembled;
    *visible = made;
    made = NULL;
done:
    pdmc_visible_destroy(&made);
    return status;
}

void pdmc_visible_destroy(pdmc_visible **visible)
{
    pdmc_visible *old = *visible;
    if (!old) return;
    for (int i = 0; i < old->nodes.count; i++) {
        if (old->stencils) pdmc_stencil_clear(&old->stencils[i]);
        if (old->rows) pdmc_block_row_clear(&old->rows[i]);
    }
    pdmc_free(old->stencils);
    pdmc_free(old->rows);
    pdmc_load_cases_clear(&old->loads);
    pdmc_free(old->load);
    pdmc_free(old->solution);
    pdmc_free(old->mean);
    pdmc_factor_clear(&old->factor);
    pdmc_visible_nodes_clear(&old->nodes);
    pdmc_cuts_clear(&old->cuts);
    pdmc_free(old);
    *visible = NULL;
}
