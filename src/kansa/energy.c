// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/energy.h"

#include "base/base_impl.h"
#include "pdmc/fracture.h"

#include <cblas.h>
#include <math.h>

// Scratch of one thread.
typedef struct {
    pdmc_row_builder builder;
    pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    double *stretch; // [PDMC_CROSSING_BONDS, unknowns]
    double *ends;    // [4, unknowns] displacement rows of a bond's two ends
} workspace;

static pdmc_status workspace_create(const pdmc_kansa *kansa, workspace **work)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    PDMC_NEW(*work, 1);
    PDMC_TRY(pdmc_row_builder_create(&kansa->basis, &(*work)->builder));
    PDMC_NEW((*work)->stretch, PDMC_CROSSING_BONDS * n);
    PDMC_NEW((*work)->ends, 4 * n);
done:
    return status;
}

static void workspace_destroy(workspace *work)
{
    if (!work) return;
    pdmc_row_builder_clear(&work->builder);
    pdmc_free(work->stretch);
    pdmc_free(work->ends);
    pdmc_free(work);
}

// Rows of e . (u(end) - u(start)), times the square root of the quadrature weight.
static void stretch_rows(const pdmc_kansa *kansa, workspace *work, int count)
{
    const int n = kansa->unknowns;
    for (int b = 0; b < count; b++) {
        const pdmc_crossing_bond *bond = &work->bonds[b];
        double *start = work->ends, *end = work->ends + 2 * n, *row = &work->stretch[(size_t)b * (size_t)n];
        pdmc_displacement_rows(&work->builder, bond->start, bond->start, start, start + n);
        pdmc_displacement_rows(&work->builder, bond->end, bond->end, end, end + n);
        const double scale = sqrt(bond->weight), c = scale * bond->direction[0], s = scale * bond->direction[1];
        for (int k = 0; k < n; k++) row[k] = c * (end[k] - start[k]) + s * (end[n + k] - start[n + k]);
    }
}

static pdmc_status fill_crossing(const pdmc_kansa *kansa, const double coefficients[], const pdmc_affine *model,
                                 workspace *work, int direction, pdmc_crossing *crossing)
{
    pdmc_status status = PDMC_OK;
    const double pi = 3.14159265358979323846;
    const pdmc_problem *problem = kansa->problem;
    const int tip = problem->energy.tips[direction / model->angles], n = kansa->unknowns, r = model->unknowns;
    const pdmc_crack *crack = &problem->cracks[tip / 2];
    const double *position = tip % 2 ? crack->to : crack->from;
    const double phi = 2.0 * pi * (direction % model->angles) / model->angles;
    const double x_t[2] = {position[0] + problem->energy.extension * cos(phi),
                           position[1] + problem->energy.extension * sin(phi)};
    PDMC_TRY(pdmc_crossing_bonds(problem, x_t, phi, &model->energy_rings, &crossing->bonds, work->bonds));
    PDMC_NEW(crossing->row, crossing->bonds * r);
    PDMC_NEW(crossing->ring, crossing->bonds);
    for (int b = 0; b < crossing->bonds; b++) crossing->ring[b] = work->bonds[b].ring;
    stretch_rows(kansa, work, crossing->bonds);
    if (crossing->bonds > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, crossing->bonds, r, n, 1.0, work->stretch, n,
                    coefficients, n, 0.0, crossing->row, r);
done:
    return status;
}

static pdmc_status fill_crossings(const pdmc_kansa *kansa, const double coefficients[], pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int directions = model->tips * model->angles;
#pragma omp parallel num_threads(kansa->threads)
    {
        workspace *work = NULL;
        pdmc_status mine = workspace_create(kansa, &work);
#pragma omp for schedule(dynamic)
        for (int d = 0; d < directions; d++)
            if (mine == PDMC_OK) mine = fill_crossing(kansa, coefficients, model, work, d, &model->crossings[d]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_energy)
            status = mine;
        }
        workspace_destroy(work);
    }
    return status;
}

pdmc_status pdmc_kansa_energy(const pdmc_kansa *kansa, const double coefficients[], pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = kansa->problem;
    PDMC_NEW(model->crossings, model->tips * model->angles);
    model->micromodulus = pdmc_micromodulus(&problem->material, problem->energy.horizon);
    PDMC_TRY(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, model->bins, 3, problem->energy.horizon, &model->energy_rings));
    PDMC_TRY(fill_crossings(kansa, coefficients, model));
done:
    return status;
}
