// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate.h"

#include "base/base_impl.h"
#include "discretisation/rigid.h"
#include "galerkin/plate_mesh.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

// The elements round each node, by counting.
static pdmc_status find_around(const pdmc_mesh *mesh, pdmc_node_elements *around)
{
    pdmc_status status = PDMC_OK;
    const int corners = 3 * mesh->element_count;
    PDMC_NEW(around->start, mesh->node_count + 2);
    PDMC_NEW(around->element, corners);
    int *next = around->start + 1; // of each node; its end, the start of the one behind it, once all are placed
    for (int k = 0; k < corners; k++) next[mesh->corner[k] + 1]++;
    for (int n = 0; n < mesh->node_count; n++) {
        if (next[n + 1] > around->most) around->most = next[n + 1];
        next[n + 1] += next[n];
    }
    for (int k = 0; k < corners; k++) around->element[next[mesh->corner[k]]++] = k / 3;
done:
    return status;
}

static int planes_of(const pdmc_problem *problem)
{
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    return !noise ? 1 : noise->bins < PDMC_PLATE_PLANES ? noise->bins : PDMC_PLATE_PLANES;
}

static pdmc_status make_plate(pdmc_plate_elements *plate)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = plate->problem;
    PDMC_TRY(pdmc_plate_mesh(problem, &plate->mesh));
    PDMC_TRY(pdmc_space_create(&plate->mesh, problem->solver.space, &plate->space));
    PDMC_TRY(pdmc_mesh_locator_create(&plate->mesh, &plate->locator));
    PDMC_TRY(find_around(&plate->mesh, &plate->around));
    plate->unknowns = 2 * plate->space.count;
    PDMC_TRY(pdmc_plate_hold(plate));
    PDMC_TRY(pdmc_load_cases_create(problem, &plate->loads));
    PDMC_TRY(pdmc_plate_load(plate));
    PDMC_TRY(pdmc_plate_form_create(problem, &plate->space, problem->solver.outer_parts, planes_of(problem),
                                    plate->threads, &plate->form));
done:
    return status;
}

static pdmc_status factor_mean(pdmc_plate_elements *plate, const double weight[])
{
    pdmc_status status = PDMC_OK;
    pdmc_sparse_matrix matrix = {0};
    PDMC_TRY(pdmc_plate_form_matrix(&plate->form, weight, plate->held, &matrix));
    PDMC_TRY(pdmc_sparse_factor_create(&matrix, NULL, NULL, &plate->factor));
done:
    pdmc_sparse_matrix_clear(&matrix);
    return status;
}

static bool is_held(const pdmc_plate_elements *plate, int unknown)
{
    return plate->held[unknown / 2] & (1U << (unknown % 2));
}

pdmc_status pdmc_plate_elements_solve(const pdmc_plate_elements *plate, const pdmc_sparse_factor *factor,
                                      const double weight[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const int n = plate->unknowns;
    double *force = NULL; // that the prescribed displacements put on the free unknowns
    PDMC_NEW(force, n);
    pdmc_plate_form_multiply(&plate->form, weight, plate->prescribed, force);
    for (int k = 0; k < n; k++) x[k] = scale[0] * (is_held(plate, k) ? plate->prescribed[k] : -force[k]);
    for (int l = 0; l < plate->loads.count; l++)
        cblas_daxpy(n, scale[1 + l], &plate->load[(size_t)l * (size_t)n], 1, x, 1);
    PDMC_TRY(pdmc_sparse_factor_solve(factor, 1, x, x));
done:
    pdmc_free(force);
    return status;
}

static bool is_at_edge(const pdmc_plate *plate, const double x[2])
{
    return fabs(x[0]) >= 0.5 * plate->width * (1.0 - 1e-9) || fabs(x[1]) >= 0.5 * plate->height * (1.0 - 1e-9);
}

static pdmc_status take_out_rigid_motions(pdmc_plate_elements *plate)
{
    pdmc_status status = PDMC_OK;
    const int count = plate->space.count;
    uint8_t *at_edge = NULL;
    PDMC_NEW(at_edge, count);
    for (int k = 0; k < count; k++) at_edge[k] = is_at_edge(&plate->problem->plate, &plate->space.x[2 * (size_t)k]);
    PDMC_TRY(pdmc_rigid_take_out(plate->problem, count, plate->space.x, at_edge, plate->mean));
done:
    pdmc_free(at_edge);
    return status;
}

static pdmc_status solve_mean(pdmc_plate_elements *plate, const double weight[])
{
    pdmc_status status = PDMC_OK;
    const int n = plate->unknowns, cases = plate->loads.count;
    double *scale = NULL, *force = NULL;
    PDMC_NEW(scale, 1 + cases);
    PDMC_NEW(force, n);
    PDMC_NEW(plate->mean, n);
    PDMC_NEW(plate->solution, (1 + (size_t)cases) * (size_t)n);
    for (int l = 0; l <= cases; l++) {
        memset(scale, 0, (1 + (size_t)cases) * sizeof *scale);
        scale[l] = 1.0;
        PDMC_TRY(
            pdmc_plate_elements_solve(plate, plate->factor, weight, scale, &plate->solution[(size_t)l * (size_t)n]));
    }
    for (size_t l = 0; l < 2; l++) cblas_daxpy(n, 1.0, &plate->solution[l * (size_t)n], 1, plate->mean, 1);
    PDMC_TRY(take_out_rigid_motions(plate));
    pdmc_plate_form_multiply(&plate->form, weight, plate->mean, force);
    for (int k = 0; k < n; k++)
        if (!is_held(plate, k))
            plate->residual = fmax(plate->residual, fabs(force[k] - plate->load[k]) / plate->problem->solver.spacing);
done:
    pdmc_free(scale);
    pdmc_free(force);
    return status;
}

pdmc_status pdmc_plate_elements_create(const pdmc_problem *problem, int threads, pdmc_plate_elements **plate)
{
    PDMC_REQUIRE(threads >= 1, "%d threads: at least one is needed", threads);
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    double weight[PDMC_PLATE_PLANES];
    pdmc_plate_elements *made = NULL;
    pdmc_blas_prepare();
    for (int p = 0; p < PDMC_PLATE_PLANES; p++) weight[p] = 1.0;
    PDMC_TRY(pdmc_problem_check_equilibrium(problem));
    PDMC_NEW(made, 1);
    made->problem = problem;
    made->threads = threads;
    PDMC_TRY(make_plate(made));
    const double assembled = pdmc_seconds();
    PDMC_TRY(factor_mean(made, weight));
    PDMC_TRY(solve_mean(made, weight));
    made->assembly_seconds = assembled - start;
    made->factorisation_seconds = pdmc_seconds() - assembled;
    *plate = made;
    made = NULL;
done:
    pdmc_plate_elements_destroy(&made);
    return status;
}

void pdmc_plate_elements_destroy(pdmc_plate_elements **plate)
{
    pdmc_plate_elements *old = *plate;
    if (!old) return;
    pdmc_sparse_factor_destroy(&old->factor);
    pdmc_plate_form_clear(&old->form);
    pdmc_load_cases_clear(&old->loads);
    pdmc_mesh_locator_clear(&old->locator);
    pdmc_space_clear(&old->space);
    pdmc_mesh_clear(&old->mesh);
    pdmc_free(old->around.start);
    pdmc_free(old->around.element);
    pdmc_free(old->held);
    pdmc_free(old->prescribed);
    pdmc_free(old->load);
    pdmc_free(old->solution);
    pdmc_free(old->mean);
    pdmc_free(old);
    *plate = NULL;
}
