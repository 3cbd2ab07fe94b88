// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate.h"

#include "base/base_impl.h"
#include "galerkin/element.h"

#include <math.h>
#include <string.h>

enum { MOST_CORNERS = 7 }; // of a triangle that two pairs of parallel lines cut

typedef struct {
    int corners;
    double corner[MOST_CORNERS][2];
} polygon;

// What of a polygon has sign * x[axis] <= limit.
static void clip(polygon *p, int axis, double sign, double limit)
{
    const polygon in = *p;
    p->corners = 0;
    for (int i = 0; i < in.corners; i++) {
        const double *a = in.corner[i], *b = in.corner[(i + 1) % in.corners];
        const double inside[2] = {limit - sign * a[axis], limit - sign * b[axis]};
        if (inside[0] >= 0.0) memcpy(p->corner[p->corners++], a, 2 * sizeof *a);
        if ((inside[0] > 0.0 && inside[1] < 0.0) || (inside[0] < 0.0 && inside[1] > 0.0)) {
            const double t = inside[0] / (inside[0] - inside[1]);
            for (int d = 0; d < 2; d++) p->corner[p->corners][d] = a[d] + t * (b[d] - a[d]);
            p->corners++;
        }
    }
}

typedef struct {
    const pdmc_plate_elements *plate;
    pdmc_element_rule rule;
    pdmc_side side;
    int axis;    // across the side
    double sign; // of the coordinates there
} loader;

// The force on one triangle of a layer, in an element: a body force t / depth.
static void add_triangle(const loader *l, const int value[3], const pdmc_element *element, const double corner[3][2])
{
    const pdmc_plate_elements *plate = l->plate;
    const double area = 0.5 * fabs((corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
                                   (corner[1][1] - corner[0][1]) * (corner[2][0] - corner[0][0]));
    for (int p = 0; p < l->rule.count; p++) {
        const double *at = &l->rule.at[PDMC_CORNERS * p],
                     weight = area * l->rule.weight[p] / plate->problem->solver.load_layer;
        double x[2] = {0.0, 0.0}, share[PDMC_CORNERS], traction[2];
        for (int a = 0; a < 3; a++)
            for (int d = 0; d < 2; d++) x[d] += at[a] * corner[a][d];
        pdmc_element_coordinates(element, 2, x, share);
        for (int c = 0; c < plate->loads.count; c++) {
            double *load = &plate->load[(size_t)c * (size_t)plate->unknowns];
            pdmc_load_traction(&plate->loads, c, l->side, x, traction);
            for (int a = 0; a < 3; a++)
                for (int d = 0; d < 2; d++) load[2 * value[a] + d] += weight * share[a] * traction[d];
        }
    }
}

// The part of an element in the layer that its side's tractions act on, and inside the plate.
static void add_element(const loader *l, int e)
{
    const pdmc_problem *problem = l->plate->problem;
    const double half[2] = {0.5 * problem->plate.width, 0.5 * problem->plate.height};
    const pdmc_element element = pdmc_element_of(&l->plate->mesh, e);
    polygon part = {.corners = 3};
    memcpy(part.corner, element.corner, 3 * sizeof element.corner[0]);
    clip(&part, l->axis, -l->sign, problem->solver.load_layer - half[l->axis]);
    clip(&part, l->axis, l->sign, half[l->axis]);
    clip(&part, 1 - l->axis, 1.0, half[1 - l->axis]);
    clip(&part, 1 - l->axis, -1.0, half[1 - l->axis]);
    for (int k = 1; k + 1 < part.corners; k++) {
        const double corner[3][2] = {{part.corner[0][0], part.corner[0][1]},
                                     {part.corner[k][0], part.corner[k][1]},
                                     {part.corner[k + 1][0], part.corner[k + 1][1]}};
        add_triangle(l, &l->plate->space.value[3 * (size_t)e], &element, corner);
    }
}

static bool is_loaded(const pdmc_problem *problem, pdmc_side side)
{
    bool any = false;
    for (int k = 0; k < problem->load_count; k++) any = any || problem->loads[k].side == side;
    return any;
}

pdmc_status pdmc_plate_load(pdmc_plate_elements *plate)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)plate->unknowns;
    loader l = {.plate = plate};
    PDMC_NEW(plate->load, (size_t)plate->loads.count * n);
    PDMC_TRY(pdmc_element_rule_smooth(2, &l.rule));
    for (int side = 0; side < PDMC_SIDES; side++) {
        l.side = (pdmc_side)side;
        l.axis = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT ? 0 : 1;
        l.sign = side == PDMC_SIDE_RIGHT || side == PDMC_SIDE_TOP ? 1.0 : -1.0;
        for (int e = 0; e < plate->mesh.element_count && is_loaded(plate->problem, l.side); e++) add_element(&l, e);
    }
    for (size_t k = 0; k < (size_t)plate->loads.count * n; k++)
        if (plate->held[(k % n) / 2] & (1U << (k % n % 2))) plate->load[k] = 0.0;
done:
    pdmc_element_rule_clear(&l.rule);
    return status;
}
