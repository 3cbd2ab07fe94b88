// SPDX-License-Identifier: GPL-3.0-or-later

/// Loads along the sides of a body: in a layer of some depth, and on the side itself.

#include "galerkin/element.h"

#include <math.h>
#include <string.h>

// A constant force in a part of an element: test functions are linear, so that the middle of an interval or a triangle
// stands for all of it.
static void add_part(const pdmc_space *space, int e, const double middle[2], double force, double load[])
{
    const int dimension = space->mesh->dimension, *value = &space->value[(dimension + 1) * e];
    const pdmc_element element = pdmc_element_of(space->mesh, e);
    double at[PDMC_CORNERS];
    pdmc_element_coordinates(&element, dimension, middle, at);
    for (int a = 0; a <= dimension; a++)
        if (value[a] < space->free_count) load[value[a]] += force * at[a];
}

static void add_interval(const pdmc_space *space, int e, double from, double to, double force, double load[])
{
    const pdmc_element element = pdmc_element_of(space->mesh, e);
    const double lower = fmax(from, element.corner[0][0]), upper = fmin(to, element.corner[1][0]);
    const double middle[2] = {0.5 * (lower + upper), 0.0};
    if (lower < upper) add_part(space, e, middle, force * (upper - lower), load);
}

enum { MOST_CORNERS = 5 }; // of a triangle between two parallel lines

typedef struct {
    int count;
    double x[MOST_CORNERS][2];
} polygon;

static void add_corner(polygon *p, double x, double y)
{
    p->x[p->count][0] = x;
    p->x[p->count++][1] = y;
}

// What lies where sign (x[axis] - place) >= 0.
static polygon cut_off(const polygon *p, int axis, double sign, double place)
{
    polygon rest = {0};
    for (int i = 0; i < p->count; i++) {
        const double *a = p->x[i], *b = p->x[(i + 1) % p->count];
        const double here = sign * (a[axis] - place), next = sign * (b[axis] - place);
        if (here >= 0.0) add_corner(&rest, a[0], a[1]);
        if ((here > 0.0 && next < 0.0) || (here < 0.0 && next > 0.0)) {
            const double share = here / (here - next);
            add_corner(&rest, a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]));
        }
    }
    return rest;
}

// The fan of triangles from the first corner.
static void add_triangle(const pdmc_space *space, int e, int axis, double from, double to, double force, double load[])
{
    const pdmc_element element = pdmc_element_of(space->mesh, e);
    polygon p = {.count = PDMC_CORNERS};
    memcpy(p.x, element.corner, sizeof element.corner);
    p = cut_off(&p, axis, 1.0, from);
    p = cut_off(&p, axis, -1.0, to);
    for (int i = 1; i + 1 < p.count; i++) {
        const double *a = p.x[0], *b = p.x[i], *c = p.x[i + 1];
        const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        const double middle[2] = {(a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0};
        add_part(space, e, middle, force * area, load);
    }
}

void pdmc_space_add_layer(const pdmc_space *space, int axis, double from, double to, double force, double load[])
{
    for (int e = 0; e < space->mesh->element_count; e++) {
        if (space->mesh->layer[e]) continue;
        if (space->mesh->dimension == 1) add_interval(space, e, from, to, force, load);
        else add_triangle(space, e, axis, from, to, force, load);
    }
}

// Where the corners of an element lie on the side, but for one, it has a face there: an end, or an edge.
void pdmc_space_add_flux(const pdmc_space *space, int axis, double place, double flux, double load[])
{
    const pdmc_mesh *mesh = space->mesh;
    const int n = mesh->dimension + 1;
    for (int e = 0; e < mesh->element_count; e++) {
        const pdmc_element element = pdmc_element_of(mesh, e);
        double face = 1.0;
        int on[PDMC_CORNERS], count = 0;
        for (int a = 0; a < n; a++)
            if (fabs(element.corner[a][axis] - place) <= 1e-9 * element.radius) on[count++] = a;
        if (mesh->layer[e] || count != n - 1) continue;
        if (n == 3) face = fabs(element.corner[on[1]][1 - axis] - element.corner[on[0]][1 - axis]);
        for (int k = 0; k < count; k++) {
            const int value = space->value[n * e + on[k]];
            if (value < space->free_count) load[value] += flux * face / count;
        }
    }
}
