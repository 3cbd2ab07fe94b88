// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/nodes.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

static const double slack = 1e-9; // of the spacing, where the horizon runs through nodes

/// The horizon, or what the volume rule adds to it.
static double reach_of(const pdmc_particles_options *options)
{
    const double h = options->spacing;
    return options->volume_rule == PDMC_VOLUME_PARTIAL ? options->horizon + (0.5 - slack) * h
                                                       : options->horizon + slack * h;
}

pdmc_nodes pdmc_nodes_none(const pdmc_particles_options *options)
{
    const double h = options->spacing;
    const bool is_whole = options->volume_rule == PDMC_VOLUME_WHOLE;
    return (pdmc_nodes){.dimension = options->dimension,
                        .spacing = h,
                        .reach = reach_of(options),
                        .contact_distance = options->contact_distance * h,
                        .share_start = is_whole ? 1.0 : 0.5 + options->horizon / h,
                        .share_slope = is_whole ? 0.0 : 1.0 / h};
}

static double square_between(const pdmc_nodes *g, size_t i, size_t j)
{
    double square = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        const double step = g->reference[a][i] - g->reference[a][j];
        square += step * step;
    }
    return square;
}

bool pdmc_nodes_are_near(const pdmc_nodes *g, size_t i, size_t j)
{
    return square_between(g, i, j) <= g->reach * g->reach;
}

double pdmc_nodes_length(const pdmc_nodes *g, size_t i, size_t j)
{
    return sqrt(square_between(g, i, j));
}

double pdmc_nodes_weight(const pdmc_nodes *g, size_t i, size_t j)
{
    return g->volume[j] * fmin(1.0, g->share_start - g->share_slope * pdmc_nodes_length(g, i, j));
}

void pdmc_nodes_clear(pdmc_nodes *g)
{
    for (int a = 0; a < PDMC_AXES; a++) pdmc_free(g->reference[a]);
    pdmc_free(g->neighbours);
    pdmc_free(g->body);
    pdmc_free(g->cell);
    pdmc_free(g->node);
    pdmc_free(g->volume);
    pdmc_free(g->lists);
    pdmc_free(g->blocks);
    pdmc_free(g->bonds);
    pdmc_free(g->partner);
    pdmc_free(g->near);
    pdmc_free(g->family);
    *g = (pdmc_nodes){0};
}

void pdmc_nodes_whole(const pdmc_nodes *g, const pdmc_block *block, int whole[])
{
    memset(whole, 0, PDMC_LANES * sizeof *whole);
    for (int n = 0; n < block->listed; n++)
        for (int k = 0; k < PDMC_LANES; k++) whole[k] += g->bonds[block->bonds + (size_t)n] >> k & 1;
}
