// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/nodes.h"

#include <math.h>

static bool in_cylinder(const pdmc_shape *shape, const double x[], double slack)
{
    double off_axis = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        if (shape->from[a] != shape->to[a]) {
            const double low = fmin(shape->from[a], shape->to[a]), high = fmax(shape->from[a], shape->to[a]);
            if (x[a] < low - slack || x[a] > high + slack) return false;
        } else {
            off_axis += (x[a] - shape->from[a]) * (x[a] - shape->from[a]);
        }
    }
    return sqrt(off_axis) <= shape->radius + slack;
}

bool pdmc_shape_holds(const pdmc_shape *shape, const double x[PDMC_AXES], double slack)
{
    double distance = 0.0;
    switch (shape->kind) {
    case PDMC_SHAPE_BOX:
        for (int a = 0; a < PDMC_AXES; a++)
            if (x[a] < shape->from[a] - slack || x[a] > shape->to[a] + slack) return false;
        return true;
    case PDMC_SHAPE_CYLINDER: return in_cylinder(shape, x, slack);
    case PDMC_SHAPE_BALL:
        for (int a = 0; a < PDMC_AXES; a++) distance += (x[a] - shape->centre[a]) * (x[a] - shape->centre[a]);
        return sqrt(distance) <= shape->radius + slack;
    case PDMC_SHAPE_NODES:
    case PDMC_SHAPE_MESH: break;
    }
    return false;
}
