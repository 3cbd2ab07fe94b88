// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bodies that the tests of this room share.

#include "check.h"
#include "pdmc/particles.h"

#include <stdlib.h>
#include <string.h>

/// Of unit stiffness E = 1 and density 1 in units of the spacing: horizon 3, in three dimensions or in plane stress.
typedef struct {
    pdmc_brittle_material material;
    pdmc_body body;
    pdmc_particles_options options;
} specimen;

/// A box of count[] nodes from the origin on. `s` must stay where it is: the options point into it.
static inline void make_box(specimen *s, int dimension, const int count[])
{
    const double horizon = 3.0;
    *s = (specimen){.body = {.shape = {.kind = PDMC_SHAPE_BOX}}};
    for (int a = 0; a < dimension; a++) s->body.shape.to[a] = count[a] - 1.0;
    s->material = (pdmc_brittle_material){
        .density = 1.0,
        .micromodulus = pdmc_brittle_micromodulus(dimension, PDMC_PLANE_STRESS, 1.0, horizon, 1.0),
        .critical_stretch = INFINITY,
    };
    s->options = (pdmc_particles_options){
        .dimension = dimension,
        .spacing = 1.0,
        .thickness = 1.0,
        .horizon = horizon,
        .material_count = 1,
        .materials = &s->material,
        .body_count = 1,
        .bodies = &s->body,
        .safety = 0.5,
        .threads = 1,
    };
}

/// In (-1, 1), the same in every run.
static inline double scatter(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state / 2147483648.0 - 1.0;
}

/// Gives the body of make_box() nodes of its own: those of the grid, each moved along every axis by at most `amplitude` and its
/// volume changed by at most that share. @return to be freed by the caller
static inline pdmc_node *scatter_box(specimen *s, const int count[], double amplitude, unsigned *seed)
{
    const int deep = s->options.dimension < 3 ? 1 : count[2];
    pdmc_node *nodes = calloc((size_t)(count[0] * count[1] * deep), sizeof *nodes), *node = nodes;
    for (int z = 0; z < deep; z++)
        for (int y = 0; y < count[1]; y++)
            for (int x = 0; x < count[0]; x++, node++) {
                *node = (pdmc_node){{x, y, z}, 1.0 + amplitude * scatter(seed)};
                for (int a = 0; a < s->options.dimension; a++) node->x[a] += amplitude * scatter(seed);
            }
    s->body.shape.kind = PDMC_SHAPE_NODES;
    s->body.nodes = nodes;
    s->body.node_count = (int)(node - nodes);
    return nodes;
}

static inline pdmc_particles *create(const specimen *s)
{
    pdmc_particles *particles = NULL;
    CHECK_OK(pdmc_particles_create(&s->options, &particles));
    return particles;
}
