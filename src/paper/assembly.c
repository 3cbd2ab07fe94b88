// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "discretisation/radial.h"
#include "paper/disc.h"
#include "paper/paper_impl.h"

#include <cblas.h>
#include <math.h>

// Scratch of one thread.
typedef struct {
    pdmc_paper_disc disc;
    double *own;        // [scalars] values at the node
    double *difference; // [bonds, scalars] of the values at the node and at the bond's other end: G_k, Q_j of eq. 29
    double *weight;     // [3 terms, bonds] of xx, xy, yy of the micromodulus tensor (eq. 31)
    double *block;      // [3 terms, scalars] their product
} workspace;

static pdmc_status workspace_create(const pdmc_paper *paper, workspace **work)
{
    pdmc_status status = PDMC_OK;
    const size_t scalars = (size_t)paper->basis.scalars, terms = (size_t)paper->terms;
    PDMC_NEW(*work, 1);
    PDMC_TRY(pdmc_paper_disc_create(paper->problem, paper->problem->solver.horizon, &(*work)->disc));
    const size_t bonds = (size_t)(*work)->disc.most_bonds;
    PDMC_NEW((*work)->own, scalars);
    PDMC_NEW((*work)->difference, bonds * scalars);
    PDMC_NEW((*work)->weight, 3 * terms * bonds);
    PDMC_NEW((*work)->block, 3 * terms * scalars);
done:
    return status;
}

static void workspace_destroy(workspace *work)
{
    if (!work) return;
    pdmc_paper_disc_clear(&work->disc);
    pdmc_free(work->own);
    pdmc_free(work->difference);
    pdmc_free(work->weight);
    pdmc_free(work->block);
    pdmc_free(work);
}

static void fill_weights(const pdmc_paper *paper, workspace *work)
{
    const double horizon = work->disc.horizon;
    const double c = horizon * pdmc_micromodulus(&paper->problem->material, horizon);
    const int bonds = work->disc.count;
    for (int b = 0; b < bonds; b++) {
        const pdmc_paper_bond *bond = &work->disc.bond[b];
        const double *e = bond->direction, tensor[3] = {e[0] * e[0], e[0] * e[1], e[1] * e[1]};
        double polynomial[PDMC_PAPER_TERMS];
        pdmc_radial_legendre(paper->terms, 2.0 * bond->length / horizon - 1.0, polynomial);
        for (int p = 0; p < paper->terms; p++)
            for (int k = 0; k < 3; k++)
                work->weight[(3 * p + k) * bonds + b] = c * bond->weight * polynomial[p] * tensor[k];
    }
}

static void fill_differences(const pdmc_paper *paper, workspace *work, const double x[2])
{
    const int scalars = paper->basis.scalars;
    pdmc_paper_values(&paper->basis, x, x, work->own);
    for (int b = 0; b < work->disc.count; b++) {
        const pdmc_paper_bond *bond = &work->disc.bond[b];
        const double y[2] = {x[0] + bond->length * bond->direction[0], x[1] + bond->length * bond->direction[1]};
        double *row = &work->difference[(size_t)b * (size_t)scalars];
        pdmc_paper_values(&paper->basis, y, y, row);
        for (int k = 0; k < scalars; k++) row[k] = work->own[k] - row[k];
    }
}

static void copy_scaled(int count, double factor, const double from[], double to[])
{
    for (int k = 0; k < count; k++) to[k] = factor * from[k];
}

static const pdmc_support *support_of(const pdmc_problem *problem, const double x[2], int component)
{
    for (int s = 0; s < problem->support_count; s++) {
        const pdmc_support *support = &problem->supports[s];
        if (support->held[component] && pdmc_paper_on_side(&problem->plate, support->side, x)) return support;
    }
    return NULL;
}

static double force_density(const pdmc_paper *paper, int index, const double x[2], int component)
{
    double sum = 0.0, traction[2];
    for (int side = 0; side < PDMC_SIDES; side++) {
        if (!pdmc_paper_on_side(&paper->problem->plate, (pdmc_side)side, x)) continue;
        pdmc_load_traction(&paper->loads, index, (pdmc_side)side, x, traction);
        sum += traction[component];
    }
    return sum / paper->problem->solver.edge_layer;
}

static void hold(pdmc_paper *paper, const workspace *work, const pdmc_support *support, int component, int row)
{
    const int scalars = paper->basis.scalars;
    const double weight = paper->problem->material.youngs_modulus / paper->basis.scale;
    double *values = &paper->matrix[(size_t)row * (size_t)paper->unknowns];
    copy_scaled(scalars, weight, work->own, &values[component * scalars]);
    paper->load[row] = weight * support->displacement[component];
}

static void balance(pdmc_paper *paper, const double x[2], int component, int row)
{
    double *values = &paper->matrix[(size_t)row * (size_t)paper->unknowns] + 2 * paper->basis.scalars;
    for (int m = 0; m < paper->motions; m++) {
        const double *t = paper->motion[m];
        values[m] = component == 0 ? t[0] - t[2] * x[1] : t[1] + t[2] * x[0];
    }
}

static void equate(pdmc_paper *paper, const workspace *work, const double x[2], int component, int row)
{
    const size_t n = (size_t)paper->unknowns, scalars = (size_t)paper->basis.scalars, r = (size_t)row;
    // xx, xy of a term, and xy, yy, follow one another: the rows of x and of y
    copy_scaled(2 * (int)scalars, 1.0, &work->block[(size_t)component * scalars], &paper->matrix[r * n]);
    for (size_t p = 0; paper->term && p < (size_t)paper->terms; p++)
        copy_scaled(2 * (int)scalars, 1.0, &work->block[(3 * p + (size_t)component) * scalars],
                    &paper->term[(p * (size_t)paper->rows_of_nodes + r) * n]);
    balance(paper, x, component, row);
    for (int l = 0; l < paper->loads.count; l++)
        paper->load[(size_t)(1 + l) * n + r] =
            paper->problem->solver.horizon * force_density(paper, l, x, component);
}

static pdmc_status assemble_node(pdmc_paper *paper, workspace *work, int i)
{
    const double *x = &paper->basis.nodes.x[2 * i];
    const int scalars = paper->basis.scalars;
    const pdmc_status status = pdmc_paper_disc_cut(&work->disc, x);
    if (status != PDMC_OK) return status;
    const int bonds = work->disc.count;
    fill_weights(paper, work);
    fill_differences(paper, work, x);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, 3 * paper->terms, scalars, bonds, 1.0, work->weight, bonds,
                work->difference, scalars, 0.0, work->block, scalars);
    for (int component = 0; component < 2; component++) {
        const pdmc_support *support = support_of(paper->problem, x, component);
        if (support) hold(paper, work, support, component, 2 * i + component);
        else equate(paper, work, x, component, 2 * i + component);
    }
    return PDMC_OK;
}

static pdmc_status assemble_nodes(pdmc_paper *paper)
{
    pdmc_status status = PDMC_OK;
#pragma omp parallel num_threads(paper->threads)
    {
        workspace *work = NULL;
        pdmc_status mine = workspace_create(paper, &work);
#pragma omp for schedule(dynamic, 4)
        for (int i = 0; i < paper->basis.nodes.count; i++)
            if (mine == PDMC_OK) mine = assemble_node(paper, work, i);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_paper)
            status = mine;
        }
        workspace_destroy(work);
    }
    return status;
}

// The rows below those of the nodes: side conditions of u and of v, and no rigid motion.
static pdmc_status assemble_conditions(pdmc_paper *paper)
{
    pdmc_status status = PDMC_OK;
    const pdmc_paper_basis *basis = &paper->basis;
    const int nodes = basis->nodes.count, scalars = basis->scalars, functions = scalars - nodes;
    const double weight = paper->problem->material.youngs_modulus / (basis->scale * nodes);
    const size_t n = (size_t)paper->unknowns, first = (size_t)paper->rows_of_nodes;
    double *value = NULL;
    PDMC_NEW(value, scalars);
    for (int k = 0; k < nodes; k++) {
        const double *x = &basis->nodes.x[2 * k];
        pdmc_paper_values(basis, x, x, value);
        for (int j = 0; j < functions; j++) {
            const double q = weight * value[nodes + j];
            paper->matrix[(first + (size_t)j) * n + (size_t)k] = q;
            paper->matrix[(first + (size_t)(functions + j)) * n + (size_t)(scalars + k)] = q;
        }
        for (int m = 0; m < paper->motions; m++) {
            const double *t = paper->motion[m];
            double *row = &paper->matrix[(first + (size_t)(2 * functions + m)) * n];
            cblas_daxpy(scalars, weight * (t[0] - t[2] * x[1]), value, 1, row, 1);
            cblas_daxpy(scalars, weight * (t[1] + t[2] * x[0]), value, 1, row + scalars, 1);
        }
    }
done:
    pdmc_free(value);
    return status;
}

pdmc_status pdmc_paper_assemble(pdmc_paper *paper)
{
    const pdmc_status status = assemble_nodes(paper);
    return status == PDMC_OK ? assemble_conditions(paper) : status;
}
