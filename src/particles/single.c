// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/single.h"

#include "base/base_impl.h"

#include <math.h>

// In spacings. Its square, and that of a distance to it, are still far from the largest number.
static const float far_away = 1e12f;

static pdmc_single_neighbour in_single(const pdmc_neighbour *n, double length_unit, double volume_unit)
{
    const double length = n->length / length_unit, weight = n->weight / volume_unit;
    pdmc_single_neighbour single = {.shift = n->shift,
                                    .weight = (float)weight,
                                    .length = (float)length,
                                    .minus_stiffness = (float)(-weight / length),
                                    .inverse_square = (float)(1.0 / (length * length)),
                                    .touching = (float)(n->touching * length_unit)};
    for (int a = 0; a < PDMC_AXES; a++) {
        single.step[a] = (float)n->step[a];
        single.slope[a] = (float)(n->step[a] / (length * length));
        single.twice_slope[a] = 2.0f * single.slope[a];
    }
    return single;
}

static pdmc_status copy_neighbours(const pdmc_nodes *g, pdmc_single *s)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(s->neighbours, g->neighbour_count);
    for (int k = 0; k < g->neighbour_count; k++) s->neighbours[k] = in_single(&g->neighbours[k], s->length, s->volume);
done:
    return status;
}

/// Nodes off the grid are moved to where a number of single precision is.
static pdmc_status copy_places(const pdmc_nodes *g, pdmc_single *s)
{
    pdmc_status status = PDMC_OK;
    for (int a = 0; a < PDMC_AXES; a++) {
        PDMC_NEW(s->reference[a], g->cells + PDMC_LANES);
        for (size_t c = 0; c < g->cells + PDMC_LANES; c++)
            s->reference[a][c] = g->volume[c] > 0.0 ? (float)(g->reference[a][c] / s->length) : far_away;
    }
done:
    return status;
}

static pdmc_status copy_nodes(const pdmc_nodes *g, const double stiffness[], pdmc_single *s)
{
    pdmc_status status = PDMC_OK;
    const size_t cells = g->cells + PDMC_LANES;
    for (int a = 0; a < PDMC_AXES; a++) PDMC_NEW(s->displacement[a], cells);
    PDMC_NEW(s->strength, cells);
    PDMC_NEW(s->next_strength, cells);
    PDMC_NEW(s->node_volume, cells);
    if (stiffness) PDMC_NEW(s->stiffness, cells);
    for (size_t c = 0; c < cells; c++) {
        s->node_volume[c] = (float)(g->volume[c] / s->volume);
        if (stiffness) s->stiffness[c] = (float)stiffness[c];
        for (int a = 0; a < PDMC_AXES; a++) s->displacement[a][c] = g->volume[c] > 0.0 ? 0.0f : far_away;
    }
done:
    return status;
}

pdmc_status pdmc_single_create(const pdmc_nodes *g, const double stiffness[], pdmc_single *s)
{
    pdmc_status status = PDMC_OK;
    *s = (pdmc_single){.length = g->spacing, .volume = g->spacing * g->spacing * g->spacing};
    PDMC_TRY(g->partner ? copy_places(g, s) : copy_neighbours(g, s));
    PDMC_TRY(copy_nodes(g, stiffness, s));
done:
    return status;
}

void pdmc_single_clear(pdmc_single *s)
{
    for (int a = 0; a < PDMC_AXES; a++) {
        pdmc_free(s->displacement[a]);
        pdmc_free(s->reference[a]);
    }
    pdmc_free(s->neighbours);
    pdmc_free(s->node_volume);
    pdmc_free(s->stiffness);
    pdmc_free(s->strength);
    pdmc_free(s->next_strength);
    *s = (pdmc_single){0};
}

void pdmc_single_strengthen(pdmc_single *s)
{
    float *strength = s->strength;
    s->strength = s->next_strength;
    s->next_strength = strength;
}
