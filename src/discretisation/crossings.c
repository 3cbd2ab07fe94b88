// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/crossings.h"

#include "base/base_impl.h"
#include "pdmc/fracture.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <math.h>

// Scratch of one thread.
typedef struct {
    void *context; // of the displacement
    pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    double *stretch; // [PDMC_CROSSING_BONDS, unknowns]
    double *ends;    // [4, unknowns] displacement rows of a bond's two ends
} workspace;

static pdmc_status workspace_create(const pdmc_displacement_functional *displacement, workspace **work)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)displacement->unknowns;
    PDMC_NEW(*work, 1);
    PDMC_TRY(displacement->open(displacement->method, &(*work)->context));
    PDMC_NEW((*work)->stretch, PDMC_CROSSING_BONDS * n);
    PDMC_NEW((*work)->ends, 4 * n);
done:
    return status;
}

static void workspace_destroy(const pdmc_displacement_functional *displacement, workspace *work)
{
    if (!work) return;
    displacement->close(work->context);
    pdmc_free(work->stretch);
    pdmc_free(work->ends);
    pdmc_free(work);
}

// Rows of e . (u(end) - u(start)), times the square root of the quadrature weight.
static void stretch_rows(const pdmc_displacement_functional *displacement, workspace *work, int count)
{
    const int n = displacement->unknowns;
    for (int b = 0; b < count; b++) {
        const pdmc_crossing_bond *bond = &work->bonds[b];
        double *start = work->ends, *end = work->ends + 2 * n, *row = &work->stretch[(size_t)b * (size_t)n];
        displacement->rows(work->context, bond->start, start, start + n);
        displacement->rows(work->context, bond->end, end, end + n);
        const double scale = sqrt(bond->weight), c = scale * bond->direction[0], s = scale * bond->direction[1];
        for (int k = 0; k < n; k++) row[k] = c * (end[k] - start[k]) + s * (end[n + k] - start[n + k]);
    }
}

static pdmc_status fill_crossing(const pdmc_problem *problem, const pdmc_displacement_functional *displacement,
                                 const double coefficients[], const pdmc_affine *model, const pdmc_ring_rule *rings,
                                 workspace *work, int direction, pdmc_crossing *crossing)
{
    pdmc_status status = PDMC_OK;
    const int tip = problem->energy.tips[direction / model->angles], n = displacement->unknowns, r = model->unknowns;
    const pdmc_crack *crack = &problem->cracks[tip / 2];
    const double *position = tip % 2 ? crack->to : crack->from;
    const double phi = 2.0 * M_PI * (direction % model->angles) / model->angles;
    const double x_t[2] = {position[0] + problem->energy.extension * cos(phi),
                           position[1] + problem->energy.extension * sin(phi)};
    PDMC_TRY(pdmc_crossing_bonds(problem, x_t, phi, rings, &crossing->bonds, work->bonds));
    PDMC_NEW(crossing->row, crossing->bonds * r);
    PDMC_NEW(crossing->ring, crossing->bonds);
    for (int b = 0; b < crossing->bonds; b++) crossing->ring[b] = work->bonds[b].ring;
    stretch_rows(displacement, work, crossing->bonds);
    if (crossing->bonds > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, crossing->bonds, r, n, 1.0, work->stretch, n, coefficients,
                    n, 0.0, crossing->row, r);
done:
    return status;
}

pdmc_status pdmc_affine_fill_crossings(const pdmc_problem *problem, const pdmc_displacement_functional *displacement,
                                       const double coefficients[], int threads, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int directions = model->tips * model->angles;
    pdmc_ring_rule rings = {0};
    PDMC_NEW(model->crossings, directions);
    model->micromodulus = pdmc_micromodulus(&problem->material, problem->energy.horizon);
    PDMC_TRY(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, model->bins, 3, problem->energy.horizon, &rings));
    model->rings = rings.rings;
    model->ring_weight = rings.weight; // the model's from here on
#pragma omp parallel num_threads(threads)
    {
        workspace *work = NULL;
        pdmc_status mine = workspace_create(displacement, &work);
#pragma omp for schedule(dynamic)
        for (int d = 0; d < directions; d++)
            if (mine == PDMC_OK)
                mine = fill_crossing(problem, displacement, coefficients, model, &rings, work, d, &model->crossings[d]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_crossings)
            status = mine;
        }
        workspace_destroy(displacement, work);
    }
done:
    return status;
}
