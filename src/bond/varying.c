// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/varying.h"

#include "bond/release.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK, CHUNK = 256 }; // nodes of one matrix product

static const pdmc_bond_operator *operator_of(const pdmc_affine *model)
{
    return model->discretisation;
}

// alpha = min(alpha, M) over the nodes of a chunk.
static void lower_by_chunk(int terms, int count, const double psi[], int stride, const double xi[], double alpha[B])
{
    double deviation[CHUNK * B];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, B, terms, 1.0, psi, terms, xi, stride, 0.0, deviation,
                B);
    for (int node = 0; node < count; node++)
        for (int s = 0; s < B; s++) alpha[s] = fmin(alpha[s], 1.0 + deviation[node * B + s]);
}

pdmc_status pdmc_bond_coercivity(const pdmc_affine *model, const double xi[], double alpha[])
{
    const pdmc_bond_stiffness *stiffness = operator_of(model)->stiffness;
    const int nodes = operator_of(model)->bond->plate.grid.nodes, terms = stiffness->terms;
    const int radial = model->radial_terms, stride = model->terms;
    for (int s = 0; s < B; s++) alpha[s] = INFINITY;
    for (int first = 0; first < nodes; first += CHUNK)
        lower_by_chunk(terms, nodes - first < CHUNK ? nodes - first : CHUNK,
                       &stiffness->value[(size_t)first * (size_t)terms], stride, xi + radial, alpha);
    for (int s = 0; s < B && radial > 0; s++) {
        double least = xi[s * stride];
        for (int m = 1; m < radial; m++) least = fmin(least, xi[s * stride + m]);
        alpha[s] += least;
    }
    return PDMC_OK;
}

static pdmc_status fill_tip(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness, int t, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)bond->unknowns, nodes = (size_t)bond->plate.grid.nodes;
    double *weight = NULL;
    PDMC_NEW(weight, nodes);
    PDMC_TRY(pdmc_bond_tip_weights(bond, &stiffness->release[(size_t)t * nodes],
                                   &model->stress_intensity[2 * (size_t)t * n], weight));
    cblas_dgemv(CblasRowMajor, CblasTrans, (int)nodes, stiffness->terms, 1.0, stiffness->value, stiffness->terms,
                weight, 1, 0.0, &model->tip_stiffness[t * stiffness->terms], 1);
done:
    pdmc_free(weight);
    return status;
}

static void fill_direction(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness, const pdmc_crossing *crossing,
                           double average[])
{
    const int terms = stiffness->terms;
    double sum = 0.0;
    for (int b = 0; b < crossing->bonds; b++) {
        const double *row = &crossing->row[b * PDMC_BOND_ENDS];
        const int *column = &crossing->column[b * PDMC_BOND_ENDS];
        double stretch = 0.0;
        for (int k = 0; k < PDMC_BOND_ENDS; k++) stretch += row[k] * bond->mean[column[k]];
        sum += stretch * stretch;
        for (int k = 0; k < PDMC_BOND_ENDS; k += 2) // the two nodes
            cblas_daxpy(terms, 0.5 * stretch * stretch, &stiffness->value[(size_t)(column[k] / 2) * (size_t)terms], 1,
                        average, 1);
    }
    if (sum > 0.0) cblas_dscal(terms, 1.0 / sum, average, 1);
}

pdmc_status pdmc_bond_fill_local_stiffness(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness,
                                           pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int directions = model->tips * model->angles;
    PDMC_NEW(model->tip_stiffness, model->tips * stiffness->terms);
    PDMC_NEW(model->direction_stiffness, directions * stiffness->terms);
    for (int t = 0; t < model->tips; t++) PDMC_TRY(fill_tip(bond, stiffness, t, model));
    for (int d = 0; d < directions; d++)
        fill_direction(bond, stiffness, &model->crossings[d], &model->direction_stiffness[d * stiffness->terms]);
done:
    return status;
}
