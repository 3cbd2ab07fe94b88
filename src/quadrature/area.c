// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CORNERS = 32, RADIAL = 8, ANGULAR = 4 };

typedef struct {
    int corners;
    double x[MOST_CORNERS][2];
} cell;

typedef struct {
    double x[3][2];
} triangle;

// Cells and triangles that are still to be done.
typedef struct {
    int cracks;
    const double *segment;
    double size;
    int cell_count, cell_room;
    cell *cells;
    int triangle_count, triangle_room;
    triangle *triangles;
    int point_room;
    pdmc_area_rule rule;
} mesh;

static pdmc_status grow(void **array, int count, int *room, size_t size)
{
    if (count < *room) return PDMC_OK;
    const int larger = *room > 0 ? 2 * *room : 64;
    void *moved = pdmc_calloc((size_t)larger, size);
    if (!moved) return PDMC_ERR_NOMEM;
    if (*array) memcpy(moved, *array, (size_t)count * size);
    pdmc_free(*array);
    *array = moved;
    *room = larger;
    return PDMC_OK;
}

static pdmc_status add_cell(mesh *m, const cell *c)
{
    pdmc_status status = grow((void **)&m->cells, m->cell_count, &m->cell_room, sizeof *c);
    if (status == PDMC_OK) m->cells[m->cell_count++] = *c;
    return status;
}

static pdmc_status add_triangle(mesh *m, const double a[2], const double b[2], const double c[2])
{
    const pdmc_status status = grow((void **)&m->triangles, m->triangle_count, &m->triangle_room, sizeof *m->triangles);
    if (status != PDMC_OK) return status;
    triangle *t = &m->triangles[m->triangle_count++];
    memcpy(t->x[0], a, sizeof t->x[0]);
    memcpy(t->x[1], b, sizeof t->x[1]);
    memcpy(t->x[2], c, sizeof t->x[2]);
    return PDMC_OK;
}

static double side_of(const double origin[2], const double along[2], const double x[2])
{
    return along[0] * (x[1] - origin[1]) - along[1] * (x[0] - origin[0]);
}

static void add_corner(cell *c, const double x[2])
{
    if (c->corners < MOST_CORNERS) memcpy(c->x[c->corners++], x, sizeof c->x[0]);
}

// The parts of a convex cell on the left and on the right of a line; `slack` is the distance that counts as on it.
static void split(const cell *whole, const double origin[2], const double along[2], double slack, cell *left,
                  cell *right)
{
    left->corners = right->corners = 0;
    for (int i = 0; i < whole->corners; i++) {
        const double *x = whole->x[i], *next = whole->x[(i + 1) % whole->corners];
        const double s = side_of(origin, along, x), t = side_of(origin, along, next);
        if (s >= -slack) add_corner(left, x);
        if (s <= slack) add_corner(right, x);
        if ((s > slack && t < -slack) || (s < -slack && t > slack)) {
            const double share = s / (s - t);
            const double at[2] = {x[0] + share * (next[0] - x[0]), x[1] + share * (next[1] - x[1])};
            add_corner(left, at);
            add_corner(right, at);
        }
    }
}

// Whether a point lies in the closed cell.
static bool holds(const cell *c, const double x[2], double slack)
{
    for (int i = 0; i < c->corners; i++) {
        const double *a = c->x[i], *b = c->x[(i + 1) % c->corners];
        const double along[2] = {b[0] - a[0], b[1] - a[1]};
        if (side_of(a, along, x) < -slack * hypot(along[0], along[1])) return false;
    }
    return true;
}

static bool meets(const cell *c, const double from[2], const double to[2], double slack)
{
    if (holds(c, from, slack) || holds(c, to, slack)) return true;
    for (int i = 0; i < c->corners; i++)
        if (pdmc_segments_cross(from, to, c->x[i], c->x[(i + 1) % c->corners])) return true;
    return false;
}

// Splits the cells that meet the segment from - to along a line through `from`.
static pdmc_status split_cells(mesh *m, const double from[2], const double to[2], const double along[2], double slack)
{
    for (int i = m->cell_count - 1; i >= 0; i--) {
        if (!meets(&m->cells[i], from, to, slack)) continue;
        cell left, right;
        split(&m->cells[i], from, along, slack, &left, &right);
        if (left.corners < 3 || right.corners < 3) continue;
        m->cells[i] = left;
        const pdmc_status status = add_cell(m, &right);
        if (status != PDMC_OK) return status;
    }
    return PDMC_OK;
}

static pdmc_status cut_by_crack(mesh *m, const double from[2], const double to[2], double slack)
{
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    const double along[2] = {(to[0] - from[0]) / length, (to[1] - from[1]) / length}, across[2] = {-along[1], along[0]};
    pdmc_status status = split_cells(m, from, to, along, slack);
    if (status == PDMC_OK) status = split_cells(m, from, from, across, slack);
    if (status == PDMC_OK) status = split_cells(m, to, to, across, slack);
    return status;
}

// A fan from the middle, whose triangles keep the cell's corners.
static pdmc_status fan(mesh *m, const cell *c)
{
    double middle[2] = {0.0, 0.0};
    for (int i = 0; i < c->corners; i++)
        for (int k = 0; k < 2; k++) middle[k] += c->x[i][k] / c->corners;
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < c->corners && status == PDMC_OK; i++)
        status = add_triangle(m, middle, c->x[i], c->x[(i + 1) % c->corners]);
    return status;
}

static double distance(const double a[2], const double b[2])
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

// The vertex at a tip, or -1; and the distance of the nearest tip from the triangle's vertices.
static int tip_vertex(const mesh *m, const triangle *t, double slack, double *nearest)
{
    int vertex = -1;
    *nearest = INFINITY;
    for (int i = 0; i < 2 * m->cracks; i++) {
        for (int v = 0; v < 3; v++) {
            const double d = distance(t->x[v], &m->segment[2 * i]);
            if (d <= slack) vertex = v;
            *nearest = fmin(*nearest, d);
        }
    }
    return vertex;
}

static pdmc_status add_rule(mesh *m, const triangle *t, int first, const double s[], const double ws[],
                            const double a[], const double wa[])
{
    const double *o = t->x[first], *p = t->x[(first + 1) % 3], *q = t->x[(first + 2) % 3];
    const double area2 = fabs((p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]));
    while (m->rule.count + RADIAL * ANGULAR > m->point_room) {
        int room = m->point_room;
        pdmc_status status = grow((void **)&m->rule.x, room, &m->point_room, 2 * sizeof(double));
        if (status == PDMC_OK) status = grow((void **)&m->rule.weight, room, &room, sizeof(double));
        if (status != PDMC_OK) return status;
    }
    for (int i = 0; i < RADIAL; i++) {
        for (int j = 0; j < ANGULAR; j++) {
            const double r = s[i] * s[i]; // share of the way from the first vertex
            double *x = &m->rule.x[2 * m->rule.count];
            for (int k = 0; k < 2; k++) x[k] = o[k] + r * ((1.0 - a[j]) * (p[k] - o[k]) + a[j] * (q[k] - o[k]));
            m->rule.weight[m->rule.count++] = area2 * r * 2.0 * s[i] * ws[i] * wa[j];
        }
    }
    return PDMC_OK;
}

static int longest_side(const triangle *t, double *length)
{
    int longest = 0;
    *length = 0.0;
    for (int v = 0; v < 3; v++) {
        const double d = distance(t->x[v], t->x[(v + 1) % 3]);
        if (d > *length) {
            *length = d;
            longest = v;
        }
    }
    return longest;
}

// Bisects triangles at their longest side until they are small enough, and gives each its rule.
static pdmc_status fill(mesh *m, double slack)
{
    pdmc_status status = PDMC_OK;
    double s[RADIAL], ws[RADIAL], a[ANGULAR], wa[ANGULAR];
    PDMC_TRY(pdmc_gauss_legendre(RADIAL, 0.0, 1.0, s, ws));
    PDMC_TRY(pdmc_gauss_legendre(ANGULAR, 0.0, 1.0, a, wa));
    while (m->triangle_count > 0) {
        const triangle t = m->triangles[--m->triangle_count];
        double length, nearest, shortest_crack = INFINITY;
        const int v = longest_side(&t, &length), tip = tip_vertex(m, &t, slack, &nearest);
        for (int c = 0; c < m->cracks; c++)
            shortest_crack = fmin(shortest_crack, distance(&m->segment[4 * c], &m->segment[4 * c + 2]));
        const double limit = fmin(m->size, tip >= 0 ? 0.25 * shortest_crack : 1.5 * nearest);
        if (length <= limit) {
            PDMC_TRY(add_rule(m, &t, tip >= 0 ? tip : 0, s, ws, a, wa));
            continue;
        }
        const double *p = t.x[v], *q = t.x[(v + 1) % 3], *o = t.x[(v + 2) % 3];
        const double middle[2] = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
        PDMC_TRY(add_triangle(m, p, middle, o));
        PDMC_TRY(add_triangle(m, middle, q, o));
    }
done:
    return status;
}

pdmc_status pdmc_area_rule_create(double width, double height, int cracks, const double segment[], double size,
                                  pdmc_area_rule *rule)
{
    PDMC_REQUIRE(width > 0.0 && height > 0.0, "a rectangle of %g x %g", width, height);
    PDMC_REQUIRE(size > 0.0, "triangles of size %g", size);
    pdmc_status status = PDMC_OK;
    mesh m = {.cracks = cracks, .segment = segment, .size = size};
    const double w = 0.5 * width, h = 0.5 * height, slack = 1e-12 * fmax(width, height);
    const cell whole = {4, {{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
    PDMC_TRY(add_cell(&m, &whole));
    for (int c = 0; c < cracks; c++) PDMC_TRY(cut_by_crack(&m, &segment[4 * c], &segment[4 * c + 2], slack));
    for (int i = 0; i < m.cell_count; i++) PDMC_TRY(fan(&m, &m.cells[i]));
    PDMC_TRY(fill(&m, slack));
done:
    pdmc_free(m.cells);
    pdmc_free(m.triangles);
    if (status != PDMC_OK) pdmc_area_rule_clear(&m.rule);
    *rule = m.rule;
    return status;
}

void pdmc_area_rule_clear(pdmc_area_rule *rule)
{
    pdmc_free(rule->x);
    pdmc_free(rule->weight);
    *rule = (pdmc_area_rule){0};
}
