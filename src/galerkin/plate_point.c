// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate.h"

#include "base/base_impl.h"
#include "discretisation/interaction.h"
#include "discretisation/tip.h"
#include "galerkin/element.h"

#include <math.h>
#include <string.h>

pdmc_plate_point pdmc_plate_point_at(const pdmc_plate_elements *plate, const double x[2], const double anchor[2])
{
    const double share = 1e-3; // of the way to the anchor: on the face that is meant, and in the element next to x
    const double beside[2] = {x[0] + share * (anchor[0] - x[0]), x[1] + share * (anchor[1] - x[1])};
    const int e = pdmc_mesh_locate(&plate->locator, beside, NULL);
    const pdmc_element element = pdmc_element_of(&plate->mesh, e);
    pdmc_plate_point point;
    memcpy(point.value, &plate->space.value[3 * (size_t)e], sizeof point.value);
    pdmc_element_coordinates(&element, 2, x, point.weight);
    return point;
}

void pdmc_plate_displacement(const pdmc_plate_elements *plate, const double x[2], const double anchor[2], double u[2])
{
    const pdmc_plate_point point = pdmc_plate_point_at(plate, x, anchor);
    u[0] = u[1] = 0.0;
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++) u[i] += point.weight[a] * plate->mean[2 * (size_t)point.value[a] + (size_t)i];
}

// Appends a share of the mean gradient of the elements round a node, by their areas.
static void append_node(const pdmc_plate_elements *plate, int node, double share, int *count, int value[],
                        double by_x[], double by_y[])
{
    const pdmc_node_elements *around = &plate->around;
    double area = 0.0;
    for (int k = around->start[node]; k < around->start[node + 1]; k++)
        area += pdmc_element_of(&plate->mesh, around->element[k]).size;
    for (int k = around->start[node]; k < around->start[node + 1]; k++) {
        const pdmc_element element = pdmc_element_of(&plate->mesh, around->element[k]);
        for (int a = 0; a < 3; a++) {
            value[*count] = plate->space.value[3 * around->element[k] + a];
            by_x[*count] = share * element.size / area * element.gradient[a][0];
            by_y[*count] = share * element.size / area * element.gradient[a][1];
            ++*count;
        }
    }
}

static pdmc_status gradient_at(const void *method, const double x[2], int *count, int value[], double by_x[],
                               double by_y[])
{
    const pdmc_plate_elements *plate = method;
    const int e = pdmc_mesh_locate(&plate->locator, x, NULL);
    const pdmc_element element = pdmc_element_of(&plate->mesh, e);
    double share[PDMC_CORNERS];
    pdmc_element_coordinates(&element, 2, x, share);
    *count = 0;
    for (int a = 0; a < 3; a++) append_node(plate, plate->mesh.corner[3 * e + a], share[a], count, value, by_x, by_y);
    return PDMC_OK;
}

pdmc_status pdmc_plate_intensity_rows(const pdmc_plate_elements *plate, int tip, double row_1[], double row_2[])
{
    const pdmc_problem *problem = plate->problem;
    const pdmc_gradient_functional functional = {9 * plate->around.most, plate, gradient_at};
    const double wanted = fmax(pdmc_tip_half_length(problem, tip), 2.0 * problem->solver.horizon);
    return pdmc_interaction_rows(problem, tip, pdmc_interaction_radius(problem, tip, wanted), &functional, row_1,
                                 row_2);
}

static pdmc_status tip_rows(const void *method, int tip, double row_1[], double row_2[])
{
    return pdmc_plate_intensity_rows(method, tip, row_1, row_2);
}

pdmc_status pdmc_plate_tip(const pdmc_plate_elements *plate, int tip, pdmc_tip *out)
{
    return pdmc_tip_of(plate->problem, tip, plate->unknowns, plate->mean, tip_rows, plate, out);
}
