// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/point.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

static pdmc_status row_create(int count, const int column[], pdmc_block_row *row)
{
    pdmc_status status = PDMC_OK;
    *row = (pdmc_block_row){.count = count};
    PDMC_NEW(row->column, count);
    PDMC_NEW(row->value, 4 * count);
    memcpy(row->column, column, (size_t)count * sizeof *column);
done:
    if (status != PDMC_OK) pdmc_block_row_clear(row);
    return status;
}

static pdmc_status by_stencil(const pdmc_visible *visible, const pdmc_view *view, pdmc_block_row *row)
{
    const int owner = pdmc_stencil_owner(&visible->field, view);
    if (owner < 0) return pdmc_raise(PDMC_ERR_SINGULAR, "no node is visible from (%g, %g)", view->x[0], view->x[1]);
    const pdmc_stencil *stencil = &visible->stencils[owner];
    double weight[PDMC_STENCIL_NODES];
    const pdmc_status status = row_create(stencil->count, stencil->node, row);
    if (status != PDMC_OK) return status;
    pdmc_stencil_evaluate(stencil, view->x, weight);
    for (int k = 0; k < row->count; k++) row->value[4 * k] = row->value[4 * k + 3] = weight[k];
    return PDMC_OK;
}

// D^-1 B_k of a face's half disc.
static pdmc_status by_equation(pdmc_disc_sum *sum, const pdmc_view *view, pdmc_block_row *row, double known[2])
{
    pdmc_status status = pdmc_disc_sum_take(sum, view);
    if (status == PDMC_OK) status = row_create(sum->count, sum->list, row);
    if (status != PDMC_OK) return status;
    const double *d = sum->diagonal, determinant = d[0] * d[2] - d[1] * d[1];
    const double xx = d[2] / determinant, xy = -d[1] / determinant, yy = d[0] / determinant;
    for (int k = 0; k < row->count; k++) {
        const double *b = &sum->sum[3 * k];
        double *block = &row->value[4 * k];
        block[0] = xx * b[0] + xy * b[1];
        block[1] = xx * b[1] + xy * b[2];
        block[2] = xy * b[0] + yy * b[1];
        block[3] = xy * b[1] + yy * b[2];
    }
    known[0] = xx * sum->known[0] + xy * sum->known[1];
    known[1] = xy * sum->known[0] + yy * sum->known[1];
    return PDMC_OK;
}

pdmc_status pdmc_visible_point(pdmc_disc_sum *sum, const pdmc_view *view, pdmc_block_row *row, double known[2])
{
    *row = (pdmc_block_row){0};
    known[0] = known[1] = 0.0;
    return view->crack < 0 ? by_stencil(sum->visible, view, row) : by_equation(sum, view, row, known);
}

void pdmc_block_row_apply(const pdmc_block_row *row, const double u[], double value[2])
{
    for (int k = 0; k < row->count; k++) {
        const double *block = &row->value[4 * k], *v = &u[2 * row->column[k]];
        value[0] += block[0] * v[0] + block[1] * v[1];
        value[1] += block[2] * v[0] + block[3] * v[1];
    }
}
