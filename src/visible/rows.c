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
    if (sum->planes > 1) pdmc_legendre(sum->planes - 1, 2.0 * point->r / sum->rule.radius - 1.0, factor + 1);
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

static pdmc_status row_create(int planes, int count, pdmc_block_row *row)
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
    status = row_create(sum->planes, sum->count, row);
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

static const pdmc_support *support_of(const pdmc_problem *problem, int side, int component)
{
    for (int s = 0; s < problem->support_count; s++)
        if ((int)problem->supports[s].side == side && problem->supports[s].held[component])
            return &problem->supports[s];
    return NULL;
}

static double traction_on(const pdmc_problem *problem, int side, int component)
{
    double sum = 0.0;
    for (int l = 0; l < problem->load_count; l++)
        if ((int)problem->loads[l].side == side) sum += problem->loads[l].traction[component];
    return sum;
}

static void outward(int side, double normal[2])
{
    normal[0] = side == PDMC_SIDE_LEFT ? -1.0 : side == PDMC_SIDE_RIGHT ? 1.0 : 0.0;
    normal[1] = side == PDMC_SIDE_BOTTOM ? -1.0 : side == PDMC_SIDE_TOP ? 1.0 : 0.0;
}

double pdmc_visible_share(int p)
{
    static const double share[3] = {1.0, 0.5, 0.1};
    return p < 3 ? share[p] : 0.0;
}

// sigma(u) n with sigma_x = mu (3 u_x + v_y), sigma_y = mu (u_x + 3 v_y), tau = mu (u_y + v_x): Hooke's law of a
// bond-based material, lambda = mu, in both plane assumptions. One row of the block from the gradient's coefficients.
static void traction_row(const pdmc_visible *visible, const double normal[2], int component, double gx, double gy,
                         double row[2])
{
    const pdmc_material *material = &visible->problem->material;
    const double mu = 0.5 * material->youngs_modulus / (1.0 + pdmc_poissons_ratio(material->assumption));
    const double nx = mu * normal[0], ny = mu * normal[1];
    row[0] = component == 0 ? 3.0 * nx * gx + ny * gy : nx * gy + ny * gx;
    row[1] = component == 0 ? nx * gy + ny * gx : nx * gx + 3.0 * ny * gy;
}

static void edge_component(const pdmc_visible *visible, int ghost, int component,
                           const double gradient[2][PDMC_STENCIL_NODES], const double weight[], pdmc_block_row *row)
{
    const pdmc_problem *problem = visible->problem;
    const pdmc_visible_node *node = &visible->nodes.node[ghost];
    const bool is_held = support_of(problem, node->edge, component) != NULL;
    const double stiffness = problem->material.youngs_modulus / node->spacing;
    double normal[2];
    outward(node->edge, normal);
    for (int p = 0; p <= visible->terms; p++) {
        const double share = p == 0 ? 1.0 : is_held ? 0.0 : pdmc_visible_share(p - 1);
        for (int k = 0; k < row->count; k++) {
            double *block = &row->value[((size_t)p * (size_t)row->count + (size_t)k) * 4 + 2 * (size_t)component];
            if (is_held) block[component] = share * stiffness * weight[k];
            else traction_row(visible, normal, component, share * gradient[0][k], share * gradient[1][k], block);
        }
    }
}

pdmc_status pdmc_visible_edge_row(const pdmc_visible *visible, int ghost, pdmc_block_row *row, double held[2],
                                  double load[2])
{
    const pdmc_visible_node *node = &visible->nodes.node[ghost];
    const pdmc_view view = {{node->foot[0], node->foot[1]}, -1, 0};
    const int owner = pdmc_stencil_owner(&visible->field, &view);
    if (owner < 0) return pdmc_raise(PDMC_ERR_SINGULAR, "no node is visible from (%g, %g)", view.x[0], view.x[1]);
    const pdmc_stencil *stencil = &visible->stencils[owner];
    double weight[PDMC_STENCIL_NODES], gradient[2][PDMC_STENCIL_NODES];
    const pdmc_status status = row_create(visible->terms + 1, stencil->count, row);
    if (status != PDMC_OK) return status;
    memcpy(row->column, stencil->node, (size_t)stencil->count * sizeof *row->column);
    pdmc_stencil_evaluate(stencil, node->foot, weight);
    pdmc_stencil_gradient(stencil, node->foot, gradient[0], gradient[1]);
    for (int component = 0; component < 2; component++) {
        const pdmc_support *support = support_of(visible->problem, node->edge, component);
        const double stiffness = visible->problem->material.youngs_modulus / node->spacing;
        held[component] = support ? stiffness * support->displacement[component] : 0.0;
        load[component] = support ? 0.0 : traction_on(visible->problem, node->edge, component);
        edge_component(visible, ghost, component, (const double(*)[PDMC_STENCIL_NODES])gradient, weight, row);
    }
    return PDMC_OK;
}
