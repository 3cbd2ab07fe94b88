// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/edge.h"

#include "base/base_impl.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

static const pdmc_support *support_of(const pdmc_problem *problem, int side, int component)
{
    for (int s = 0; s < problem->support_count; s++)
        if ((int)problem->supports[s].side == side && problem->supports[s].held[component])
            return &problem->supports[s];
    return NULL;
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

// The stencil of a node from nodes of the plate alone.
static pdmc_status inner_stencil(const pdmc_visible *visible, int node, pdmc_stencil *stencil)
{
    pdmc_stencil_field field = visible->field;
    field.without_ghosts = true;
    return pdmc_stencil_create(&field, node, stencil);
}

enum { CUBIC = 10, LEAST_FITTED = 24, MOST_FITTED = 200 };

typedef struct {
    int count;
    int node[MOST_FITTED];
    double weight[MOST_FITTED];
} slope;

typedef struct {
    const pdmc_visible *visible;
    const pdmc_view *from;
} viewer;

static bool is_of_plate(const void *context, int node)
{
    const viewer *v = context;
    const pdmc_visible_node *other = &v->visible->nodes.node[node];
    return other->edge < 0 && pdmc_view_sees(&v->visible->cuts, v->from, &other->view);
}

// The derivative along the side at a ghost's foot: of the cubic that fits the nodes within 1.5 horizons best. Its
// weights are the shortest that give the derivatives of all cubics.
static pdmc_status find_slope(const pdmc_visible *visible, int ghost, const double tangent[2], slope *along)
{
    pdmc_status status = PDMC_OK;
    const pdmc_visible_node *nodes = visible->nodes.node, *node = &nodes[ghost];
    const pdmc_view view = {{node->foot[0], node->foot[1]}, -1, 0};
    const viewer v = {visible, &view};
    const double reach = fmax(1.5 * visible->problem->solver.horizon, 2.5 * node->spacing);
    double distance[MOST_FITTED], right[MOST_FITTED] = {0.0}, *matrix = NULL;
    int count = pdmc_grid_nearest(&visible->nodes.grid, view.x, MOST_FITTED, is_of_plate, &v, along->node, distance);
    while (count > LEAST_FITTED && distance[count - 1] > reach * reach) count--;
    if (count < LEAST_FITTED)
        PDMC_FAIL(PDMC_ERR_SINGULAR, "only %d nodes are seen from (%g, %g): take a smaller spacing", count, view.x[0],
                  view.x[1]);
    const double L = sqrt(distance[count - 1]);
    PDMC_NEW(matrix, CUBIC * count);
    for (int k = 0; k < count; k++) {
        const double x = (nodes[along->node[k]].view.x[0] - view.x[0]) / L;
        const double y = (nodes[along->node[k]].view.x[1] - view.x[1]) / L;
        const double row[CUBIC] = {1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
        memcpy(&matrix[CUBIC * k], row, sizeof row);
    }
    for (int d = 0; d < 2; d++) right[1 + d] = tangent[d] / L;
    const int info = LAPACKE_dgels(LAPACK_ROW_MAJOR, 'T', count, CUBIC, 1, matrix, CUBIC, right, 1);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgels returned %d", info);
    along->count = count;
    memcpy(along->weight, right, (size_t)count * sizeof *right);
done:
    pdmc_free(matrix);
    return status;
}

// The gradient at a foot, and its displacement, over the columns of a row: the nodes of the stencil, the ghost, the
// nodes of the slope.
enum { MOST_COLUMNS = PDMC_STENCIL_NODES + 1 + MOST_FITTED };

typedef struct {
    int count;
    int column[MOST_COLUMNS];
    double by_x[MOST_COLUMNS], by_y[MOST_COLUMNS], value[MOST_COLUMNS];
} foot_gradient;

static void add_column(foot_gradient *g, int column, double by_x, double by_y, double value)
{
    const int k = g->count++;
    g->column[k] = column;
    g->by_x[k] = by_x;
    g->by_y[k] = by_y;
    g->value[k] = value;
}

static void assemble_gradient(const pdmc_visible_node *node, int ghost, const pdmc_stencil *stencil, const slope *along,
                              const double normal[2], foot_gradient *g)
{
    const double tangent[2] = {-normal[1], normal[0]};
    double value[3][PDMC_STENCIL_NODES], step[2]; // at the foot, one and two steps inside
    for (int d = 0; d < 2; d++) step[d] = node->view.x[d] - node->foot[d];
    for (int k = 0; k < 3; k++) {
        const double x[2] = {node->foot[0] - k * step[0], node->foot[1] - k * step[1]};
        pdmc_stencil_evaluate(stencil, x, value[k]);
    }
    const double h = step[0] * normal[0] + step[1] * normal[1];
    const double lean = (step[0] * tangent[0] + step[1] * tangent[1]) / h; // d = h (n + lean t)
    g->count = 0;
    for (int k = 0; k < stencil->count; k++) {
        const double out = (3.0 * value[0][k] - 6.0 * value[1][k] + value[2][k]) / (6.0 * h);
        add_column(g, stencil->node[k], normal[0] * out, normal[1] * out, value[0][k]);
    }
    add_column(g, ghost, normal[0] / (3.0 * h), normal[1] / (3.0 * h), 0.0);
    for (int k = 0; k < along->count; k++)
        add_column(g, along->node[k], (tangent[0] - lean * normal[0]) * along->weight[k],
                   (tangent[1] - lean * normal[1]) * along->weight[k], 0.0);
}

static pdmc_status find_gradient(const pdmc_visible *visible, int ghost, foot_gradient *g)
{
    pdmc_status status = PDMC_OK;
    const pdmc_visible_node *node = &visible->nodes.node[ghost];
    pdmc_stencil stencil = {0};
    slope *along = NULL;
    double normal[2];
    outward(node->edge, normal);
    const double tangent[2] = {-normal[1], normal[0]};
    PDMC_NEW(along, 1);
    PDMC_TRY(find_slope(visible, ghost, tangent, along));
    PDMC_TRY(inner_stencil(visible, node->inward, &stencil));
    assemble_gradient(node, ghost, &stencil, along, normal, g);
done:
    pdmc_stencil_clear(&stencil);
    pdmc_free(along);
    return status;
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

static void edge_component(const pdmc_visible *visible, int ghost, int component, const foot_gradient *g,
                           pdmc_block_row *row)
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
            if (is_held) block[component] = share * stiffness * g->value[k];
            else traction_row(visible, normal, component, share * g->by_x[k], share * g->by_y[k], block);
        }
    }
}

pdmc_status pdmc_visible_edge_row(const pdmc_visible *visible, int ghost, pdmc_block_row *row, double held[2])
{
    pdmc_status status = PDMC_OK;
    const pdmc_visible_node *node = &visible->nodes.node[ghost];
    const double stiffness = visible->problem->material.youngs_modulus / node->spacing;
    foot_gradient *g = NULL;
    PDMC_NEW(g, 1);
    PDMC_TRY(find_gradient(visible, ghost, g));
    PDMC_TRY(pdmc_block_row_create(visible->terms + 1, g->count, row));
    memcpy(row->column, g->column, (size_t)g->count * sizeof *row->column);
    for (int component = 0; component < 2; component++) {
        const pdmc_support *support = support_of(visible->problem, node->edge, component);
        held[component] = support ? stiffness * support->displacement[component] : 0.0;
        edge_component(visible, ghost, component, g, row);
    }
done:
    pdmc_free(g);
    return status;
}

void pdmc_visible_edge_load(const pdmc_visible *visible, int ghost, int index, double load[2])
{
    const pdmc_visible_node *node = &visible->nodes.node[ghost];
    pdmc_load_traction(&visible->loads, index, (pdmc_side)node->edge, node->foot, load);
    for (int k = 0; k < 2; k++)
        if (support_of(visible->problem, node->edge, k)) load[k] = 0.0;
}

static void set_block(pdmc_block_row *row, int k, int column, double value)
{
    row->column[k] = column;
    row->value[4 * k] = row->value[4 * k + 3] = value;
}

// u_k = u_0 + k (u_1 - u_0)
static pdmc_status linear_row(int ghost, int ring, int first, int foot, double scale, int planes, pdmc_block_row *row)
{
    const pdmc_status status = pdmc_block_row_create(planes, 3, row);
    if (status != PDMC_OK) return status;
    set_block(row, 0, ghost, scale);
    set_block(row, 1, first, -scale * ring);
    set_block(row, 2, foot, scale * (ring - 1));
    return PDMC_OK;
}

// u_k = u_-k + k (u_1 - u_-1), u_-k by the stencil `far`, u_-1 by `near`.
static pdmc_status even_row(const pdmc_visible_node *node, int ghost, int first, const double step[2],
                            const pdmc_stencil *far, const pdmc_stencil *near, double scale, int planes,
                            pdmc_block_row *row)
{
    const int k = node->ring;
    const double x_far[2] = {node->foot[0] - k * step[0], node->foot[1] - k * step[1]};
    const double x_near[2] = {node->foot[0] - step[0], node->foot[1] - step[1]};
    double weight[PDMC_STENCIL_NODES];
    int n = 0;
    const pdmc_status status = pdmc_block_row_create(planes, 2 + far->count + near->count, row);
    if (status != PDMC_OK) return status;
    set_block(row, n++, ghost, scale);
    set_block(row, n++, first, -scale * k);
    pdmc_stencil_evaluate(far, x_far, weight);
    for (int i = 0; i < far->count; i++) set_block(row, n++, far->node[i], -scale * weight[i]);
    pdmc_stencil_evaluate(near, x_near, weight);
    for (int i = 0; i < near->count; i++) set_block(row, n++, near->node[i], scale * k * weight[i]);
    return PDMC_OK;
}

pdmc_status pdmc_visible_extension_row(const pdmc_visible *visible, int ghost, pdmc_block_row *row)
{
    pdmc_status status = PDMC_OK;
    const pdmc_visible_node *nodes = visible->nodes.node, *node = &nodes[ghost];
    const double scale = visible->problem->material.youngs_modulus / node->spacing;
    int first = ghost;
    while (nodes[first].ring > 1) first = nodes[first].inward;
    const int foot = nodes[first].inward, planes = visible->terms + 1;
    const double step[2] = {nodes[first].view.x[0] - node->foot[0], nodes[first].view.x[1] - node->foot[1]};
    const pdmc_view inside = {{node->foot[0] - node->ring * step[0], node->foot[1] - node->ring * step[1]}, -1, 0};
    pdmc_stencil far = {0}, near = {0};
    pdmc_stencil_field field = visible->field;
    field.without_ghosts = true;
    const int owner = pdmc_stencil_owner(&field, &inside);
    if (owner < 0 || !pdmc_view_sees(&visible->cuts, &nodes[foot].view, &inside)) {
        status = linear_row(ghost, node->ring, first, foot, scale, planes, row);
    } else {
        PDMC_TRY(inner_stencil(visible, owner, &far));
        PDMC_TRY(inner_stencil(visible, foot, &near));
        PDMC_TRY(even_row(node, ghost, first, step, &far, &near, scale, planes, row));
    }
done:
    pdmc_stencil_clear(&far);
    pdmc_stencil_clear(&near);
    return status;
}
