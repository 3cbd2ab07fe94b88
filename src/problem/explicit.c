// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/explicit.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

void pdmc_explicit_clear(pdmc_explicit *problem)
{
    for (int i = 0; problem->conditions && i < problem->condition_count; i++) {
        pdmc_free((void *)problem->conditions[i].layer.history.time);
        pdmc_free((void *)problem->conditions[i].layer.history.factor);
    }
    for (int i = 0; problem->bodies && i < problem->body_count; i++) {
        pdmc_free(problem->bodies[i].file);
        pdmc_free((void *)problem->bodies[i].body.nodes);
    }
    pdmc_free(problem->materials);
    pdmc_free(problem->bodies);
    pdmc_free(problem->cracks);
    pdmc_free(problem->conditions);
    pdmc_free(problem->spheres);
    pdmc_free(problem->no_fail);
    pdmc_free(problem->interfaces);
    *problem = (pdmc_explicit){0};
}

double pdmc_explicit_extent(const pdmc_explicit *problem, const pdmc_shape *shape)
{
    const int dimension = problem->dimension;
    const double r = shape->radius;
    double sides = 1.0, length = 0.0;
    for (int k = 0; k < dimension; k++) {
        sides *= shape->to[k] - shape->from[k];
        length += fabs(shape->to[k] - shape->from[k]); // of a cylinder, along one axis
    }
    switch (shape->kind) {
    case PDMC_SHAPE_BOX: return sides;
    case PDMC_SHAPE_CYLINDER: return M_PI * r * r * length;
    case PDMC_SHAPE_BALL: return dimension == 2 ? M_PI * r * r : 4.0 / 3.0 * M_PI * r * r * r;
    case PDMC_SHAPE_NODES:
    case PDMC_SHAPE_MESH: break;
    }
    return 0.0;
}

double pdmc_explicit_nodes(const pdmc_explicit *problem, const pdmc_body *body)
{
    if (body->is_part) return 0.0;
    if (pdmc_shape_has_nodes(body->shape.kind)) return body->node_count;
    return pdmc_explicit_extent(problem, &body->shape) / pow(problem->spacing, problem->dimension);
}
