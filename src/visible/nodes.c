// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/nodes.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double growth = 0.12;    // of the spacing with the distance from a crack
static const double accepted = 0.80;  // distance of two nodes of the inside in spacings, before the repulsion
static const double clearance = 0.75; // ... of one from those on sides and faces
static const double away = 0.5;       // the least distance from cracks and sides in spacings, afterwards

enum { REPULSIONS = 5, NEIGHBOURS = 9 };

// What the making of nodes needs.
typedef struct {
    const pdmc_problem *problem;
    const pdmc_cuts *cuts;
    double half[2]; // of the plate
    double finest;
    int capacity;
    pdmc_visible_nodes *nodes;
} maker;

static double spacing_at(const maker *m, const double x[2])
{
    const pdmc_solver_options *options = &m->problem->solver;
    const double flat = fmax(0.5 * options->horizon, 3.0 * m->finest);
    const double beyond = fmax(pdmc_cuts_distance(m->cuts, x) - flat, 0.0);
    return m->cuts->count > 0 ? fmin(options->spacing, m->finest + growth * beyond) : options->spacing;
}

static pdmc_status add_node(maker *m, const pdmc_visible_node *node)
{
    pdmc_visible_nodes *nodes = m->nodes;
    if (nodes->count == m->capacity)
        return pdmc_raise(PDMC_ERR_CONFIG,
                          "the plate needs more than %d nodes: take a larger horizon or a smaller refinement",
                          m->capacity);
    nodes->node[nodes->count++] = *node;
    pdmc_grid_add(&nodes->grid, node->view.x);
    return PDMC_OK;
}

static pdmc_status add_faces(maker *m, int c)
{
    const pdmc_cut *cut = &m->cuts->cut[c];
    const int count = (int)fmax(round((cut->high - cut->low) / m->finest), 4.0);
    const double step = (cut->high - cut->low) / count;
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < 2 * count && status == PDMC_OK; i++) {
        pdmc_visible_node node = {.view = {{0.0, 0.0}, c, i % 2 ? -1 : 1}, .spacing = step, .edge = -1};
        pdmc_cut_global(cut, cut->low + (i / 2 + 0.5) * step, 0.0, node.view.x);
        status = add_node(m, &node);
    }
    return status;
}

// Two rings round a tip, symmetric to the crack: the opening of the whole crack is sensitive to the stencils there, and
// they must not depend on chance (0.1 % instead of 0.4 % at refinement 6).
static pdmc_status add_tip(maker *m, int c, int end)
{
    static const struct {
        double radius, step; // in finest spacings, between neighbours in rad
        int pairs;
    } rings[2] = {{1.0, 2.0 * M_PI / 7.0, 3}, {1.9, M_PI / 6.0, 5}};
    const pdmc_cut *cut = &m->cuts->cut[c];
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2 * rings[i].pairs && status == PDMC_OK; j++) {
            const double r = rings[i].radius * m->finest, t = rings[i].step * (j / 2 + 0.5) * (j % 2 ? -1.0 : 1.0);
            pdmc_visible_node node = {.view = {{0.0, 0.0}, -1, 0}, .spacing = m->finest, .edge = -1};
            pdmc_cut_global(cut, end * (cut->half_length + r * cos(t)), end * r * sin(t), node.view.x);
            status = add_node(m, &node);
        }
    }
    return status;
}

// A point of a side, at a fraction of its length.
static void point_of_side(const maker *m, int side, double fraction, double x[2])
{
    const int normal = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT ? 0 : 1;
    const bool is_low = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_BOTTOM;
    x[normal] = is_low ? -m->half[normal] : m->half[normal];
    x[1 - normal] = (2.0 * fraction - 1.0) * m->half[1 - normal];
}

// Nodes in the middles of cells of equal int ds / h, between two fractions of the side's length.
static pdmc_status add_piece(maker *m, int side, double from, double to)
{
    enum { STEPS = 4000 };
    const double length = 2.0 * m->half[side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT ? 1 : 0];
    const double part = (to - from) / STEPS;
    double x[2], cells = 0.0, passed = 0.0;
    for (int i = 0; i < STEPS; i++) {
        point_of_side(m, side, from + (i + 0.5) * part, x);
        cells += length * part / spacing_at(m, x);
    }
    const double share = cells / fmax(round(cells), 2.0);
    double next = 0.5 * share;
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < STEPS && status == PDMC_OK; i++) {
        point_of_side(m, side, from + (i + 0.5) * part, x);
        const double step = length * part / spacing_at(m, x);
        if (passed + step >= next) {
            point_of_side(m, side, from + (i + (next - passed) / step) * part, x);
            const pdmc_visible_node node = {.view = {{x[0], x[1]}, -1, 0}, .spacing = spacing_at(m, x), .edge = -1};
            status = add_node(m, &node);
            next += share;
        }
        passed += step;
    }
    return status;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Where cracks go through a side, as ascending fractions of its length, between its two ends.
static int find_mouths(const maker *m, int side, double fraction[])
{
    const int normal = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT ? 0 : 1;
    double corner[2];
    int count = 0;
    point_of_side(m, side, 0.0, corner);
    fraction[count++] = 0.0;
    for (int t = 0; t < 2 * m->cuts->count; t++) {
        const pdmc_cut *cut = &m->cuts->cut[t / 2];
        double x[2];
        if (cut->has_tip[t % 2]) continue;
        pdmc_cut_global(cut, t % 2 ? cut->high : cut->low, 0.0, x);
        if (fabs(x[normal] - corner[normal]) < 1e-9 * m->half[normal])
            fraction[count++] = 0.5 + 0.5 * x[1 - normal] / m->half[1 - normal];
    }
    fraction[count++] = 1.0;
    qsort(fraction, (size_t)count, sizeof *fraction, compare);
    return count;
}

// The pieces of a side between corners and mouths, at which there are no nodes.
static pdmc_status add_side(maker *m, int side)
{
    pdmc_status status = PDMC_OK;
    double *fraction = NULL;
    PDMC_NEW(fraction, 2 + 2 * m->cuts->count);
    const int count = find_mouths(m, side, fraction);
    for (int k = 0; k + 1 < count; k++)
        if (fraction[k + 1] - fraction[k] > 1e-9) PDMC_TRY(add_piece(m, side, fraction[k], fraction[k + 1]));
done:
    pdmc_free(fraction);
    return status;
}

static bool is_clear(const maker *m, const double x[2], double h)
{
    const double to_edge = fmin(m->half[0] - fabs(x[0]), m->half[1] - fabs(x[1]));
    return to_edge >= away * h && pdmc_cuts_distance(m->cuts, x) >= away * h;
}

// Offers a sequence of low discrepancy (Roberts' R2, multiples of 1 / g and 1 / g^2 with g^3 = g + 1) of density
// 1 / (0.35 h)^2, where h is the spacing within a factor; a point stays where it is far enough from those before it.
static pdmc_status fill_level(maker *m, int fixed, double h)
{
    const double a = 0.7548776662466927, b = 0.5698402909980532;
    const double count = 4.0 * m->half[0] * m->half[1] / (0.1225 * h * h);
    pdmc_status status = PDMC_OK;
    for (double i = 1.0; i <= count && status == PDMC_OK; i++) {
        const double x[2] = {(2.0 * fmod(a * i, 1.0) - 1.0) * m->half[0], (2.0 * fmod(b * i, 1.0) - 1.0) * m->half[1]};
        const double here = spacing_at(m, x);
        if (here < 0.7 * h || here >= 1.4 * h || !is_clear(m, x, here)) continue;
        int nearest;
        double distance;
        const int found = pdmc_grid_nearest(&m->nodes->grid, x, 1, NULL, NULL, &nearest, &distance);
        const double least = (found && nearest < fixed ? clearance : accepted) * here;
        if (found && distance < least * least) continue;
        const pdmc_visible_node node = {.view = {{x[0], x[1]}, -1, 0}, .spacing = here, .edge = -1};
        status = add_node(m, &node);
    }
    return status;
}

static pdmc_status fill_inside(maker *m)
{
    const int fixed = m->nodes->count;
    pdmc_status status = PDMC_OK;
    for (double h = m->finest; h < 2.0 * m->problem->solver.spacing && status == PDMC_OK; h *= 2.0)
        status = fill_level(m, fixed, h);
    return status;
}

// A step away from the neighbours, which push as 1 / distance^4; at most 0.08 h and smaller with every pass. Distances
// are measured in the mean spacing of the two nodes, or all would drift from where nodes are dense. A few passes only:
// the more regular the nodes, the larger the errors of the stencils (0.4 % of an opening after 5, 1.1 % after 60).
static void repel(const maker *m, int i, double fade, double moved[2])
{
    const pdmc_visible_node *node = &m->nodes->node[i];
    const double *x = node->view.x, h = node->spacing;
    int neighbour[NEIGHBOURS];
    double distance[NEIGHBOURS], force[2] = {0.0, 0.0};
    const int found = pdmc_grid_nearest(&m->nodes->grid, x, NEIGHBOURS, NULL, NULL, neighbour, distance);
    for (int k = 0; k < found; k++) {
        if (neighbour[k] == i) continue;
        const pdmc_visible_node *other = &m->nodes->node[neighbour[k]];
        const double r = sqrt(distance[k]), push = pow(0.5 * (h + other->spacing) / r, 4) / r;
        for (int d = 0; d < 2; d++) force[d] += push * (x[d] - other->view.x[d]);
    }
    const double size = hypot(force[0], force[1]), step = 0.08 * h * fade * fmin(1.0, 1.0 / fmax(size, 1e-12));
    const double to[2] = {x[0] + step * force[0], x[1] + step * force[1]};
    const pdmc_view target = {{to[0], to[1]}, -1, 0};
    const bool allowed = is_clear(m, to, spacing_at(m, to)) && pdmc_view_sees(m->cuts, &node->view, &target);
    for (int d = 0; d < 2; d++) moved[d] = allowed ? to[d] : x[d];
}

static pdmc_status relax(maker *m, int fixed)
{
    pdmc_status status = PDMC_OK;
    pdmc_visible_nodes *nodes = m->nodes;
    double *moved = NULL;
    PDMC_NEW(moved, 2 * nodes->count);
    for (int pass = 0; pass < REPULSIONS; pass++) {
        for (int i = fixed; i < nodes->count; i++) repel(m, i, 1.0 - 0.8 * pass / REPULSIONS, &moved[2 * i]);
        pdmc_grid_empty(&nodes->grid);
        for (int i = 0; i < nodes->count; i++) {
            pdmc_visible_node *node = &nodes->node[i];
            if (i >= fixed) {
                memcpy(node->view.x, &moved[2 * i], sizeof node->view.x);
                node->spacing = spacing_at(m, node->view.x);
            }
            pdmc_grid_add(&nodes->grid, node->view.x);
        }
    }
done:
    pdmc_free(moved);
    return status;
}

// The side on which a point lies, or -1.
static int side_at(const maker *m, const double x[2])
{
    for (int k = 0; k < 2; k++)
        if (fabs(x[k]) == m->half[k])
            return k == 0 ? (x[0] < 0.0 ? PDMC_SIDE_LEFT : PDMC_SIDE_RIGHT)
                          : (x[1] < 0.0 ? PDMC_SIDE_BOTTOM : PDMC_SIDE_TOP);
    return -1;
}

// How far a ghost is moved along its side for each unit outwards: near the mouth of an oblique crack as much as the
// crack's cut, so that the ghosts stay on their side of it and at their distance; farther away less and less.
static double lean_of(const maker *m, const pdmc_visible_node *foot, int normal)
{
    double lean = 0.0;
    for (int t = 0; t < 2 * m->cuts->count; t++) {
        const pdmc_cut *cut = &m->cuts->cut[t / 2];
        const double direction[2] = {cut->cosine, cut->sine};
        double mouth[2];
        if (cut->has_tip[t % 2]) continue;
        pdmc_cut_global(cut, t % 2 ? cut->high : cut->low, 0.0, mouth);
        const double distance = hypot(mouth[0] - foot->view.x[0], mouth[1] - foot->view.x[1]) / foot->spacing;
        if (distance < 6.0)
            lean += copysign(1.0, foot->view.x[normal]) * direction[1 - normal] / direction[normal] *
                    fmin(2.0 - distance / 3.0, 1.0);
    }
    return lean;
}

// The ghosts of one node on a side: one ring takes up the side's conditions, more where the horizon reaches farther
// than half a spacing beyond it.
static pdmc_status add_column(maker *m, int foot)
{
    pdmc_visible_node ghost = m->nodes->node[foot];
    const double h = ghost.spacing;
    const int rings = (int)fmax(ceil(m->problem->solver.horizon / h - 0.5), 1.0);
    const int normal = ghost.edge == PDMC_SIDE_LEFT || ghost.edge == PDMC_SIDE_RIGHT ? 0 : 1;
    const double lean = lean_of(m, &ghost, normal), out = copysign(h, ghost.view.x[normal]);
    pdmc_status status = PDMC_OK;
    memcpy(ghost.foot, ghost.view.x, sizeof ghost.foot);
    ghost.inward = foot;
    for (ghost.ring = 1; ghost.ring <= rings && status == PDMC_OK; ghost.ring++) {
        ghost.view.x[1 - normal] += h * lean;
        ghost.view.x[normal] += out;
        status = add_node(m, &ghost);
        ghost.inward = m->nodes->count - 1;
    }
    return status;
}

static pdmc_status add_ghosts(maker *m)
{
    const int count = m->nodes->count;
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < count && status == PDMC_OK; i++) {
        pdmc_visible_node *node = &m->nodes->node[i];
        node->edge = side_at(m, node->view.x);
        if (node->edge >= 0) status = add_column(m, i);
        node->edge = -1;
    }
    return status;
}

pdmc_status pdmc_visible_nodes_create(const pdmc_problem *problem, const pdmc_cuts *cuts, bool faces, bool ghosts,
                                      pdmc_visible_nodes *nodes)
{
    enum { MOST_NODES = 50000 };
    pdmc_status status = PDMC_OK;
    const pdmc_solver_options *options = &problem->solver;
    maker m = {problem, cuts, {0.5 * problem->plate.width, 0.5 * problem->plate.height}, 0.0, MOST_NODES, nodes};
    m.finest = cuts->count > 0 ? fmin(options->horizon / options->refinement, options->spacing) : options->spacing;
    *nodes = (pdmc_visible_nodes){.finest = m.finest};
    PDMC_NEW(nodes->node, MOST_NODES);
    PDMC_TRY(pdmc_grid_create(m.half, 2.0 * m.finest, MOST_NODES, &nodes->grid));
    for (int c = 0; c < cuts->count; c++) {
        if (faces) PDMC_TRY(add_faces(&m, c));
        for (int t = 0; t < 2; t++)
            if (cuts->cut[c].has_tip[t]) PDMC_TRY(add_tip(&m, c, 2 * t - 1));
    }
    for (int side = PDMC_SIDE_LEFT; side <= PDMC_SIDE_TOP; side++) PDMC_TRY(add_side(&m, side));
    const int fixed = nodes->count;
    PDMC_TRY(fill_inside(&m));
    PDMC_TRY(relax(&m, fixed));
    if (ghosts) PDMC_TRY(add_ghosts(&m));
done:
    if (status != PDMC_OK) pdmc_visible_nodes_clear(nodes);
    return status;
}

void pdmc_visible_nodes_clear(pdmc_visible_nodes *nodes)
{
    pdmc_free(nodes->node);
    pdmc_grid_clear(&nodes->grid);
    *nodes = (pdmc_visible_nodes){0};
}
