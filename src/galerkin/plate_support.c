// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate.h"

#include "base/base_impl.h"
#include "discretisation/rigid.h"
#include "galerkin/element.h"

#include <math.h>

// How far a point lies beyond a side.
static double beyond(const pdmc_plate *plate, pdmc_side side, const double x[2])
{
    switch (side) {
    case PDMC_SIDE_LEFT: return -0.5 * plate->width - x[0];
    case PDMC_SIDE_RIGHT: return x[0] - 0.5 * plate->width;
    case PDMC_SIDE_BOTTOM: return -0.5 * plate->height - x[1];
    case PDMC_SIDE_TOP: break;
    }
    return x[1] - 0.5 * plate->height;
}

// The mean over the supports of the sides that a value lies on or beyond.
static void hold(pdmc_plate_elements *plate, int value)
{
    const pdmc_problem *problem = plate->problem;
    const double tiny = 1e-9 * fmax(problem->plate.width, problem->plate.height);
    double sum[2] = {0.0, 0.0};
    int count[2] = {0, 0};
    for (int s = 0; s < problem->support_count; s++) {
        const pdmc_support *support = &problem->supports[s];
        if (beyond(&problem->plate, support->side, &plate->space.x[2 * (size_t)value]) < -tiny) continue;
        for (int i = 0; i < 2; i++) {
            sum[i] += support->held[i] ? support->displacement[i] : 0.0;
            count[i] += support->held[i];
        }
    }
    for (int i = 0; i < 2; i++) {
        if (count[i] == 0) continue;
        plate->held[value] |= (uint8_t)(1U << i);
        plate->prescribed[2 * (size_t)value + (size_t)i] = sum[i] / count[i];
    }
}

// The value nearest to a corner of the plate: 0 and 1 at the bottom.
static int nearest_to_corner(const pdmc_plate_elements *plate, int corner)
{
    const double at[2] = {(corner % 2 - 0.5) * plate->problem->plate.width,
                          (corner / 2 - 0.5) * plate->problem->plate.height};
    int best = 0;
    double least = INFINITY;
    for (int k = 0; k < plate->space.count; k++) {
        const double *x = &plate->space.x[2 * (size_t)k], distance = hypot(x[0] - at[0], x[1] - at[1]);
        if (distance >= least) continue;
        least = distance;
        best = k;
    }
    return best;
}

pdmc_status pdmc_plate_hold(pdmc_plate_elements *plate)
{
    pdmc_status status = PDMC_OK;
    int corner[PDMC_RIGID_CANDIDATES];
    PDMC_NEW(plate->held, plate->space.count);
    PDMC_NEW(plate->prescribed, plate->unknowns);
    for (int e = 0; e < plate->mesh.element_count; e++) {
        const pdmc_element element = pdmc_element_of(&plate->mesh, e);
        bool is_outside = false;
        for (int side = 0; side < PDMC_SIDES; side++)
            is_outside = is_outside || beyond(&plate->problem->plate, (pdmc_side)side, element.middle) > 0.0;
        for (int k = 3 * e; k < 3 * e + 3 && is_outside; k++) hold(plate, plate->space.value[k]);
    }
    for (int c = 0; c < PDMC_RIGID_CANDIDATES; c++) corner[c] = nearest_to_corner(plate, c);
    PDMC_TRY(pdmc_rigid_hold(plate->problem, plate->space.x, corner, plate->held));
done:
    return status;
}
