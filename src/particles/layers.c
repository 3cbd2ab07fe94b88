// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/layers.h"

#include "base/base_impl.h"

#include <string.h>

static const double slack = 1e-9; // of the spacing

static bool holds(const pdmc_layer_condition *condition, const pdmc_nodes *g, size_t cell)
{
    double x[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) x[a] = g->reference[a][cell];
    return pdmc_shape_holds(&condition->region, x, slack * g->spacing);
}

/// Of all blocks' nodes, those in the layer. Counts them where there is no room yet.
static void find_nodes(const pdmc_nodes *g, const double density[], pdmc_layer *layer)
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

pdmc_status pdmc_layer_create(const pdmc_layer_condition *condition, const pdmc_nodes *g, const double density[],
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

bool pdmc_layer_holds(const pdmc_layer *layer)
{
    return layer->condition.kind != PDMC_CONDITION_FORCE;
}

double pdmc_layer_factor(const pdmc_layer *layer, double time)
{
    return layer->condition.history.count > 0 ? pdmc_history_at(&layer->condition.history, time) : 1.0;
}

double pdmc_layer_value(const pdmc_layer *layer, const pdmc_nodes *g, int k, int axis, double factor)
{
    const double *gradient = layer->condition.gradient[axis];
    double value = layer->condition.value[axis];
    for (int a = 0; a < PDMC_AXES; a++) value += gradient[a] * g->reference[a][layer->cell[k]];
    return value * factor;
}

void pdmc_layer_push(pdmc_layer *layer, const pdmc_nodes *g, const pdmc_layer_motion *m)
{
    const double factor = pdmc_layer_factor(layer, m->time);
    for (int a = 0; a < PDMC_AXES; a++) {
        layer->exerted[a] = 0.0;
        for (int k = 0; layer->condition.along[a] && k < layer->count; k++) {
            const double value = pdmc_layer_value(layer, g, k, a, factor);
            m->force[a][layer->cell[k]] += value;
            layer->exerted[a] += value * g->volume[layer->cell[k]];
        }
    }
}

/// The velocity half a step after the time.
static double velocity_after(const pdmc_layer *layer, const pdmc_nodes *g, const pdmc_layer_motion *m, int k, int axis,
                             double factor)
{
    const double value = pdmc_layer_value(layer, g, k, axis, factor);
    if (layer->condition.kind == PDMC_CONDITION_VELOCITY) return value;
    const size_t c = layer->cell[k];
    return (value - (m->position[axis][c] - g->reference[axis][c])) / m->step;
}

/// What holds a node to a motion gives it the kinetic energy of that motion, which is counted as it is, whatever its
/// velocity jumps by; the rest is against the other forces on it.
static pdmc_step_work work_of_holding(const pdmc_layer_motion *m, double density, double others, double before,
                                      double after)
{
    const double mean = 0.5 * (before + after), half = 0.5 * m->step;
    return (pdmc_step_work){0.5 * density * (mean * mean - before * before) - half * before * others,
                            0.5 * density * (after * after - mean * mean) - half * after * others};
}

static void add_work(pdmc_step_work part, double volume, pdmc_step_work *sum)
{
    sum->before += part.before * volume;
    sum->after += part.after * volume;
}

pdmc_step_work pdmc_layer_hold(pdmc_layer *layer, const pdmc_nodes *g, const pdmc_layer_motion *m)
{
    const bool by_velocity = layer->condition.kind == PDMC_CONDITION_VELOCITY;
    const double factor = pdmc_layer_factor(layer, m->time + (by_velocity ? 0.5 : 1.0) * m->step);
    pdmc_step_work work = {0.0, 0.0};
    for (int a = 0; a < PDMC_AXES; a++) {
        layer->exerted[a] = 0.0;
        for (int k = 0; layer->condition.along[a] && k < layer->count; k++) {
            const size_t c = layer->cell[k];
            const double before = m->velocity[a][c], after = velocity_after(layer, g, m, k, a, factor);
            pdmc_damping_correct(m->damping, c, a, layer->density[k], m->step, before, after, &m->force[a][c]);
            const double others = m->force[a][c], acting = layer->density[k] / m->step * (after - before) - others;
            m->force[a][c] += acting;
            layer->exerted[a] += acting * g->volume[c];
            add_work(work_of_holding(m, layer->density[k], others, before, after), g->volume[c], &work);
        }
    }
    return work;
}

pdmc_step_work pdmc_layer_work(const pdmc_layer *layer, const pdmc_nodes *g, const pdmc_layer_motion *m)
{
    const double factor = pdmc_layer_factor(layer, m->time);
    pdmc_step_work work = {0.0, 0.0};
    for (int a = 0; a < PDMC_AXES; a++) {
        for (int k = 0; layer->condition.along[a] && k < layer->count; k++) {
            const size_t c = layer->cell[k];
            const double before = m->velocity[a][c], after = before + m->force[a][c] * m->step / layer->density[k];
            const double impulse = 0.5 * m->step * pdmc_layer_value(layer, g, k, a, factor);
            add_work((pdmc_step_work){impulse * before, impulse * after}, g->volume[c], &work);
        }
    }
    return work;
}
