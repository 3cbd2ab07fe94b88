// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/rows.h"

#include "base/base_impl.h"
#include "discretisation/radial.h"

#include <math.h>
#include <string.h>

enum { RADIAL = 4, ANGULAR = 2, FINE_RADIAL = 8, FINE_ANGULAR = 4 };

pdmc_status pdmc_disc_sum_create(const pdmc_visible *visible, int planes, bool fine, pdmc_disc_sum *sum)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = visible->problem;
    const int nodes = visible->nodes.count;
    *sum = (pdmc_disc_sum){.visible = visible, .planes = planes};
    PDMC_NEW(sum->place, nodes);
    PDMC_NEW(sum->list, nodes);
    PDMC_NEW(sum->sum, (size_t)nodes * 3 * (size_t)planes);
    PDMC_NEW(sum->diagonal, 3 * planes);
    PDMC_TRY(pdmc_disc_rule_create(&visible->cuts, visible->data.outside ? &problem->plate : NULL,
                                   problem->solver.horizon, fine || planes > 1 ? FINE_RADIAL : RADIAL,
                                   fine ? FINE_ANGULAR : ANGULAR, &sum->rule));
done:
    if (status != PDMC_OK) pdmc_disc_sum_clear(sum);
    return status;
}

void pdmc_disc_sum_clear(pdmc_disc_sum *sum)
{
    pdmc_disc_rule_clear(&sum->rule);
    pdmc_free(sum->place);
    pdmc_free(sum->list);
    pdmc_free(sum->sum);
    pdmc_free(sum->diagonal);
    *sum = (pdmc_disc_sum){0};
}

static void empty(pdmc_disc_sum *sum)
{
    const size_t width = 3 * (size_t)sum->planes;
    for (int k = 0; k < sum->count; k++) sum->place[sum->list[k]] = 0;
    memset(sum->sum, 0, (size_t)sum->count * width * sizeof(double));
    memset(sum->diagonal, 0, width * sizeof(double));
    sum->known[0] = sum->known[1] = 0.0;
    sum->count = 0;
    sum->status = PDMC_OK;
}

static double *place_of(pdmc_disc_sum *sum, int node)
{
    if (sum->place[node] == 0) {
        sum->list[sum->count++] = node;
        sum->place[node] = sum->count;
    }
    return &sum->sum[(size_t)(sum->place[node] - 1) * 3 * (size_t)sum->planes];
}

static bool is_outside(const pdmc_problem *problem, const double x[2])
{
    return fabs(x[0]) > 0.5 * problem->plate.width || fabs(x[1]) > 0.5 * problem->plate.height;
}

static void add_known(pdmc_disc_sum *sum, const pdmc_disc_point *point)
{
    double u[2];
    sum->visible->data.outside(point->y, u);
    const double along = point->weight * (point->cosine * u[0] + point->sine * u[1]);
    sum->known[0] += point->cosine * along;
    sum->known[1] += point->sine * along;
}

static void add_point(void *context, const pdmc_disc_point *point)
{
    pdmc_disc_sum *sum = context;
    const pdmc_visible *visible = sum->visible;
    double factor[PDMC_VISIBLE_DEGREE + 2], f[3 * (PDMC_VISIBLE_DEGREE + 2)], weight[PDMC_STENCIL_NODES];
    const double c = point->cosine, s = point->sine;
    factor[0] = 1.0;
    if (sum->planes > 1) pdmc_radial_legendre(sum->planes - 1, 2.0 * point->r / sum->rule.radius - 1.0, factor + 1);
    for (int p = 0; p < sum->planes; p++) {
        f[3 * p] = point->weight * factor[p] * c * c;
        f[3 * p + 1] = point->weight * factor[p] * c * s;
        f[3 * p + 2] = point->weight * factor[p] * s * s;
    }
    for (int i = 0; i < 3 * sum->planes; i++) sum->diagonal[i] += f[i];
    if (visible->data.outside && is_outside(visible->problem, point->y)) {
        add_known(sum, point);
        return;
    }
    const pdmc_view view = {{point->y[0], point->y[1]}, -1, 0};
    const int owner = pdmc_stencil_owner(&visible->field, &view);
    if (owner < 0) {
        sum->status = pdmc_raise(PDMC_ERR_SINGULAR, "no node is visible from (%g, %g)", point->y[0], point->y[1]);
        return;
    }
    const pdmc_stencil *stencil = &visible->stencils[owner];
    pdmc_stencil_evaluate(stencil, point->y, weight);
    for (int k = 0; k < stencil->count; k++) {
        double *b = place_of(sum, stencil->node[k]);
        for (int i = 0; i < 3 * sum->planes; i++) b[i] += weight[k] * f[i];
    }
}

pdmc_status pdmc_disc_sum_take(pdmc_disc_sum *sum, const pdmc_view *centre)
{
    empty(sum);
    pdmc_disc_visit(&sum->rule, centre, add_point, sum);
    return sum->status;
}

pdmc_status pdmc_block_row_create(int planes, int count, pdmc_block_row *row)
{
    pdmc_status status = PDMC_OK;
    *row = (pdmc_block_row){.count = count};
    PDMC_NEW(row->column, count);
    PDMC_NEW(row->value, (size_t)planes * (size_t)count * 4);
done:
    return status;
}

void pdmc_block_row_clear(pdmc_block_row *row)
{
    pdmc_free(row->column);
    pdmc_free(row->value);
    *row = (pdmc_block_row){0};
}

// Adds factor times a symmetric block.
static void add_block(double factor, const double symmetric[3], double block[4])
{
    block[0] += factor * symmetric[0];
    block[1] += factor * symmetric[1];
    block[2] += factor * symmetric[1];
    block[3] += factor * symmetric[2];
}

pdmc_status pdmc_visible_force_row(pdmc_disc_sum *sum, int node, pdmc_block_row *row, double load[2])
{
    const pdmc_visible *visible = sum->visible;
    const pdmc_visible_node *here = &visible->nodes.node[node];
    const double scale = visible->micromodulus * here->spacing;
    pdmc_status status = pdmc_disc_sum_take(sum, &here->view);
    if (status != PDMC_OK) return status;
    place_of(sum, node);
    status = pdmc_block_row_create(sum->planes, sum->count, row);
    if (status != PDMC_OK) return status;
    const int own = sum->place[node] - 1;
    memcpy(row->column, sum->list, (size_t)sum->count * sizeof *row->column);
    for (int p = 0; p < sum->planes; p++) {
        double *plane = &row->value[(size_t)p * (size_t)sum->count * 4];
        for (int k = 0; k < sum->count; k++) add_block(-scale, &sum->sum[(k * sum->planes + p) * 3], &plane[4 * k]);
        add_block(scale, &sum->diagonal[3 * p], &plane[4 * own]);
    }
    for (int k = 0; k < 2; k++) load[k] = scale * sum->known[k];
    return PDMC_OK;
}
