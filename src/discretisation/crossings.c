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

// Points on the line of growth where bonds cross, as shares of the extension, and their weights.
static pdmc_status line_points(pdmc_energy_line line, int *count, double share[], double weight[])
{
    *count = line == PDMC_LINE_POINT ? 1 : PDMC_LINE_POINTS;
    share[0] = weight[0] = 1.0;
    return line == PDMC_LINE_POINT ? PDMC_OK : pdmc_gauss_legendre(PDMC_LINE_POINTS, 0.0, 1.0, share, weight);
}

// Appends the bonds that cross at one point; weight: of the point.
static pdmc_status append_point(const pdmc_problem *problem, const pdmc_displacement_functional *displacement,
                                const double coefficients[], const pdmc_ring_rule *rings, workspace *work, int unknowns,
                                const double x_t[2], double phi, double weight, pdmc_crossing *crossing)
{
    int count;
    const int n = displacement->unknowns, first = crossing->bonds;
    const pdmc_status status = pdmc_crossing_bonds(problem, x_t, phi, rings, &count, work->bonds);
    if (status != PDMC_OK) return status;
    for (int b = 0; b < count; b++) {
        crossing->ring[first + b] = work->bonds[b].ring;
        work->bonds[b].weight *= weight;
    }
    stretch_rows(displacement, work, count);
    if (count > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, unknowns, n, 1.0, work->stretch, n, coefficients, n,
                    0.0, &crossing->row[(size_t)first * (size_t)unknowns], unknowns);
    crossing->bonds += count;
    return PDMC_OK;
}

static pdmc_status fill_crossing(const pdmc_problem *problem, const pdmc_displacement_functional *displacement,
                                 const double coefficients[], const pdmc_affine *model, const pdmc_ring_rule *rings,
                                 workspace *work, int direction, pdmc_crossing *crossing)
{
    pdmc_status status = PDMC_OK;
    const int tip = problem->energy.tips[direction / model->angles];
    const pdmc_crack *crack = &problem->cracks[tip / 2];
    const double *position = tip % 2 ? crack->to : crack->from;
    const double phi = 2.0 * M_PI * (direction % model->angles) / model->angles;
    int points;
    double share[PDMC_LINE_POINTS], weight[PDMC_LINE_POINTS];
    PDMC_TRY(line_points(problem->energy.line, &points, share, weight));
    PDMC_NEW(crossing->row, (size_t)(points * PDMC_CROSSING_BONDS) * (size_t)model->unknowns);
    PDMC_NEW(crossing->ring, points * PDMC_CROSSING_BONDS);
    for (int p = 0; p < points; p++) {
        const double distance = share[p] * problem->energy.extension;
        const double x_t[2] = {position[0] + distance * cos(phi), position[1] + distance * sin(phi)};
        PDMC_TRY(append_point(problem, displacement, coefficients, rings, work, model->unknowns, x_t, phi, weight[p],
                              crossing));
    }
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
    if (problem->energy.measure_alone && problem->energy.measure == PDMC_MEASURE_GRIFFITH) return PDMC_OK;
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
