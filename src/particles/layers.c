// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/layers.h"

#include "base/base_impl.h"

#include <string.h>

static const double slack = 1e-9; // of the spacing

static bool holds(const pdmc_layer_condition *condition, const pdmc_lattice *g, size_t cell)
{
    double x[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) x[a] = g->reference[a][cell];
    return pdmc_shape_holds(&condition->region, x, slack * g->spacing);
}

/// Of all blocks' nodes, those in the layer. Counts them where there is no room yet.
static void find_nodes(const pdmc_lattice *g, const double density[], pdmc_layer *layer)
{
    layer->count = 0;
    for (int b = 0; b < g->block_count; b++) {
        const pdmc_block *block = &g->blocks[b];
        for (unsigned left = block->nodes; left; left &= left - 1) {
            const size_t cell = block->cell + (size_t)__builtin_ctz(left);
            if (!holds(&layer->condition, g, cell)) continue;
            if (layer->cell) layer->cell[layer->count] = cell;
            if (layer->density) layer->density[layer->count] = density[block->material];
            layer->count++;
        }
    }
}

pdmc_status pdmc_layer_create(const pdmc_layer_condition *condition, const pdmc_lattice *g, const double density[],
                              pdmc_layer *layer)
{
    pdmc_status status = PDMC_OK;
    const size_t points = (size_t)condition->history.count;
    *layer = (pdmc_layer){.condition = *condition};
    PDMC_NEW(layer->time, points);
    PDMC_NEW(layer->factor, points);
    if (points > 0) {
        memcpy(layer->time, condition->history.time, points * sizeof *layer->time);
        memcpy(layer->factor, condition->history.factor, points * sizeof *layer->factor);
    }
    layer->condition.history = (pdmc_history){condition->history.count, layer->time, layer->factor};
    find_nodes(g, density, layer);
    if (layer->count == 0) PDMC_FAIL(PDMC_ERR_ARG, "a layer with a condition holds no node");
    PDMC_NEW(layer->cell, layer->count);
    PDMC_NEW(layer->density, layer->count);
    find_nodes(g, density, layer);
done:
    return status;
}

void pdmc_layer_clear(pdmc_layer *layer)
{
    pdmc_free(layer->time);
    pdmc_free(layer->factor);
    pdmc_free(layer->cell);
    pdmc_free(layer->density);
    *layer = (pdmc_layer){0};
}

static double factor_at(const pdmc_layer *layer, double time)
{
    return layer->condition.history.count > 0 ? pdmc_history_at(&layer->condition.history, time) : 1.0;
}

double pdmc_layer_act(const pdmc_layer *layer, double time, double step, double volume,
                      double *const velocity[PDMC_AXES], double *const force[PDMC_AXES])
{
    const pdmc_layer_condition *condition = &layer->condition;
    const bool moves = condition->kind == PDMC_CONDITION_VELOCITY;
    const double factor = factor_at(layer, moves ? time + 0.5 * step : time);
    double work = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        if (!condition->along[a]) continue;
        const double value = condition->value[a] * factor;
        for (int k = 0; k < layer->count; k++) {
            const size_t c = layer->cell[k];
            const double by_step = layer->density[k] / step;
            const double acting = moves ? by_step * (value - velocity[a][c]) - force[a][c] : value;
            force[a][c] += acting;
            const double after = moves ? value : velocity[a][c] + force[a][c] / by_step;
            work += acting * 0.5 * (velocity[a][c] + after) * step * volume;
        }
    }
    return work;
}
