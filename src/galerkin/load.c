// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/element.h"

#include <math.h>
#include <string.h>

pdmc_status pdmc_space_load(const pdmc_space *space, pdmc_scalar_function *b, const void *context, double load[])
{
    const pdmc_mesh *mesh = space->mesh;
    const int n = mesh->dimension + 1;
    pdmc_element_rule rule;
    const pdmc_status status = pdmc_element_rule_smooth(mesh->dimension, &rule);
    if (status != PDMC_OK) return status;
    memset(load, 0, (size_t)space->free_count * sizeof *load);
    for (int e = 0; e < mesh->element_count; e++) {
        if (mesh->layer[e]) continue;
        const pdmc_element element = pdmc_element_of(mesh, e);
        for (int p = 0; p < rule.count; p++) {
            const double *at = &rule.at[PDMC_CORNERS * p];
            double x[2];
            pdmc_element_point(&element, mesh->dimension, at, x);
            const double force = element.size * rule.weight[p] * b(context, x);
            for (int a = 0; a < n; a++)
                if (space->value[n * e + a] < space->free_count) load[space->value[n * e + a]] += force * at[a];
        }
    }
    pdmc_element_rule_clear(&rule);
    return status;
}

pdmc_status pdmc_space_distance(const pdmc_space *space, const double u[], pdmc_scalar_function *f, const void *context,
                                double *distance)
{
    const pdmc_mesh *mesh = space->mesh;
    const int n = mesh->dimension + 1;
    double sum = 0.0, size = 0.0;
    pdmc_element_rule rule;
    const pdmc_status status = pdmc_element_rule_smooth(mesh->dimension, &rule);
    if (status != PDMC_OK) return status;
    for (int e = 0; e < mesh->element_count; e++) {
        if (mesh->layer[e]) continue;
        const pdmc_element element = pdmc_element_of(mesh, e);
        size += element.size;
        for (int p = 0; p < rule.count; p++) {
            const double *at = &rule.at[PDMC_CORNERS * p];
            double x[2];
            pdmc_element_point(&element, mesh->dimension, at, x);
            double difference = f ? -f(context, x) : 0.0;
            for (int a = 0; a < n; a++) difference += at[a] * u[space->value[n * e + a]];
            sum += element.size * rule.weight[p] * difference * difference;
        }
    }
    *distance = sqrt(sum / size);
    pdmc_element_rule_clear(&rule);
    return status;
}
