// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/field.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

typedef pdmc_status displacement_fn(const void *method, const double x[2], const double anchor[2], double u[2]);

enum { FACE_POINTS = 101 };

// Chebyshev points from tip to tip, or to the edge of the plate. The anchors lie a little to the left and to the right of
// the crack.
static pdmc_status fill_faces(const pdmc_problem *problem, int crack, displacement_fn *displacement, const void *method,
                              double position[], double moved[])
{
    double ends[2][2];
    pdmc_problem_crack_inside(problem, crack, ends);
    const double along[2] = {ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]};
    for (int i = 0; i < FACE_POINTS; i++) {
        const double share = 0.5 - 0.5 * cos(M_PI * i / (FACE_POINTS - 1)) * (1.0 - 1e-12);
        double *x = &position[2 * i];
        for (int k = 0; k < 2; k++) x[k] = ends[0][k] + share * along[k];
        for (int face = 0; face < 2; face++) {
            const double offset = face == 0 ? 5e-4 : -5e-4;
            const double anchor[2] = {x[0] - offset * along[1], x[1] + offset * along[0]};
            const pdmc_status status = displacement(method, x, anchor, &moved[4 * i + 2 * face]);
            if (status != PDMC_OK) return status;
        }
    }
    return PDMC_OK;
}

pdmc_status pdmc_field_fill(const pdmc_problem *problem, int count, const double nodes[], displacement_fn *displacement,
                            const void *method, pdmc_displacement_field *field)
{
    pdmc_status status = PDMC_OK;
    *field = (pdmc_displacement_field){.node_count = count, .face_points = FACE_POINTS};
    PDMC_NEW(field->node_position, 2 * count);
    PDMC_NEW(field->node_displacement, 2 * count);
    PDMC_NEW(field->face_position, 2 * FACE_POINTS * problem->crack_count);
    PDMC_NEW(field->face_displacement, 4 * FACE_POINTS * problem->crack_count);
    memcpy(field->node_position, nodes, 2 * (size_t)count * sizeof *nodes);
    for (int k = 0; k < count; k++)
        PDMC_TRY(displacement(method, &nodes[2 * k], &nodes[2 * k], &field->node_displacement[2 * k]));
    for (int c = 0; c < problem->crack_count; c++)
        PDMC_TRY(fill_faces(problem, c, displacement, method, &field->face_position[2 * FACE_POINTS * c],
                            &field->face_displacement[4 * FACE_POINTS * c]));
done:
    if (status != PDMC_OK) {
        pdmc_free(field->node_position);
        pdmc_free(field->node_displacement);
        pdmc_free(field->face_position);
        pdmc_free(field->face_displacement);
        *field = (pdmc_displacement_field){0};
    }
    return status;
}
