// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/system.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

void pdmc_visible_product(const pdmc_visible *visible, int plane, const double u[], double out[])
{
    for (int i = 0; i < visible->nodes.count; i++) {
        const pdmc_block_row *row = &visible->rows[i];
        const double *value = &row->value[(size_t)plane * (size_t)row->count * 4];
        double sum[2] = {0.0, 0.0};
        for (int k = 0; k < row->count; k++) {
            const double *v = &u[2 * row->column[k]], *block = &value[4 * k];
            sum[0] += block[0] * v[0] + block[1] * v[1];
            sum[1] += block[2] * v[0] + block[3] * v[1];
        }
        out[2 * i] = sum[0];
        out[2 * i + 1] = sum[1];
    }
}

static void add_row(const pdmc_visible *visible, const double xi[], int i, pdmc_triplets *triplets)
{
    const pdmc_block_row *row = &visible->rows[i];
    const size_t plane = (size_t)row->count * 4;
    for (int k = 0; k < 4 * row->count; k++) {
        double value = row->value[k];
        for (int p = 0; xi && p < visible->terms; p++) value += xi[p] * row->value[(size_t)(p + 1) * plane + (size_t)k];
        if (value != 0.0) pdmc_triplets_add(triplets, 2 * i + k % 4 / 2, 2 * row->column[k / 4] + k % 2, value);
    }
}

// E / L times the motion: in the row at the ghosts, in the column at the nodes of the plate, by spacing as the
// equations.
static void add_motion(const pdmc_visible *visible, int m, pdmc_triplets *triplets)
{
    const pdmc_problem *problem = visible->problem;
    const double size = fmax(problem->plate.width, problem->plate.height), *motion = visible->motion[m];
    for (int i = 0; i < visible->nodes.count; i++) {
        const pdmc_visible_node *node = &visible->nodes.node[i];
        const double u[2] = {motion[0] - motion[2] * node->view.x[1], motion[1] + motion[2] * node->view.x[0]};
        const double scale = problem->material.youngs_modulus / size * node->spacing / size;
        for (int k = 0; k < 2; k++) {
            const int own = 2 * i + k, multiplier = visible->unknowns + m;
            if (node->edge >= 0) pdmc_triplets_add(triplets, multiplier, own, scale * u[k]);
            else pdmc_triplets_add(triplets, own, multiplier, scale * u[k]);
        }
    }
}

pdmc_status pdmc_visible_factor(const pdmc_visible *visible, const double xi[], pdmc_factor *factor)
{
    pdmc_status status = PDMC_OK;
    pdmc_triplets triplets = {0};
    int count = 2 * visible->motions * visible->unknowns;
    for (int i = 0; i < visible->nodes.count; i++) count += 4 * visible->rows[i].count;
    PDMC_TRY(pdmc_triplets_create(visible->unknowns + visible->motions, count, &triplets));
    for (int i = 0; i < visible->nodes.count; i++) add_row(visible, xi, i, &triplets);
    for (int m = 0; m < visible->motions; m++) add_motion(visible, m, &triplets);
    PDMC_TRY(pdmc_factor_create(&triplets, factor));
done:
    pdmc_triplets_clear(&triplets);
    return status;
}

pdmc_status pdmc_visible_solve(const pdmc_visible *visible, const pdmc_factor *factor, const double load[], double u[])
{
    pdmc_status status = PDMC_OK;
    double *b = NULL, *x = NULL;
    PDMC_NEW(b, factor->size);
    PDMC_NEW(x, factor->size);
    memcpy(b, load, (size_t)visible->unknowns * sizeof *b);
    PDMC_TRY(pdmc_factor_solve(factor, b, x));
    memcpy(u, x, (size_t)visible->unknowns * sizeof *u);
done:
    pdmc_free(b);
    pdmc_free(x);
    return status;
}
