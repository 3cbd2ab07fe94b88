// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/damping.h"

#include "base/base_impl.h"

#include <math.h>

bool pdmc_damping_is_on(const pdmc_damping *damping)
{
    return damping->absolute > 0.0 || damping->relative > 0.0;
}

pdmc_status pdmc_damping_create(const pdmc_particles_options *options, const pdmc_nodes *g, pdmc_damping *damping)
{
    pdmc_status status = PDMC_OK;
    *damping = (pdmc_damping){.absolute = options->damping, .relative = options->bond_damping};
    if (!pdmc_damping_is_on(damping)) return PDMC_OK;
    for (int a = 0; a < PDMC_AXES; a++) PDMC_NEW(damping->force[a], g->cells + PDMC_LANES);
    PDMC_NEW(damping->share, g->block_count);
done:
    return status;
}

void pdmc_damping_clear(pdmc_damping *damping)
{
    for (int a = 0; a < PDMC_AXES; a++) pdmc_free(damping->force[a]);
    pdmc_free(damping->share);
    *damping = (pdmc_damping){0};
}

/// Adds c c_v e (e . dv) of the whole bonds to a neighbour of the list to the sums of a block's nodes, at c_v = 1.
static void resist_neighbour(const pdmc_motion_of_nodes *m, const pdmc_block *block, int listed,
                             double sum[PDMC_AXES][PDMC_LANES])
{
    const pdmc_nodes *g = m->nodes;
    for (unsigned left = g->bonds[block->bonds + (size_t)listed]; left; left &= left - 1) {
        const int k = __builtin_ctz(left);
        const size_t c = block->cell + (size_t)k, other = pdmc_nodes_neighbour(g, block, listed, k);
        const double stiffness = pdmc_nodes_weight(g, c, other) *
                                 pdmc_variation_micromodulus(m->variation, g, &m->laws[block->material], c, other);
        double apart[PDMC_AXES], square = 0.0, parting = 0.0;
        for (int a = 0; a < PDMC_AXES; a++) {
            apart[a] = m->position[a][other] - m->position[a][c];
            square += apart[a] * apart[a];
            parting += apart[a] * (m->velocity[a][other] - m->velocity[a][c]);
        }
        for (int a = 0; a < PDMC_AXES; a++) sum[a][k] += stiffness * parting / square * apart[a];
    }
}

static void resist_bonds(const pdmc_damping *damping, const pdmc_motion_of_nodes *m, const pdmc_block *block)
{
    double sum[PDMC_AXES][PDMC_LANES] = {{0.0}};
    for (int k = 0; k < block->listed; k++) resist_neighbour(m, block, k, sum);
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const int k = __builtin_ctz(left);
        for (int a = 0; a < PDMC_AXES; a++) damping->force[a][block->cell + (size_t)k] = damping->relative * sum[a][k];
    }
}

/// With d the damping force: d = -C (v + t (f + d) / rho).
static void resist_nodes(const pdmc_damping *damping, const pdmc_motion_of_nodes *m, const pdmc_block *block,
                         double *const force[PDMC_AXES], double duration)
{
    const double by_density = duration / m->density[block->material];
    const double factor = -damping->absolute / (1.0 + damping->absolute * by_density);
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const size_t c = block->cell + (size_t)__builtin_ctz(left);
        for (int a = 0; a < PDMC_AXES; a++) {
            double *of_bonds = &damping->force[a][c];
            *of_bonds += factor * (m->velocity[a][c] + by_density * (force[a][c] + *of_bonds));
        }
    }
}

void pdmc_damping_find(const pdmc_damping *damping, const pdmc_motion_of_nodes *m, double *const force[PDMC_AXES],
                       double duration)
{
#pragma omp parallel for num_threads(m->threads) schedule(static)
    for (int b = 0; b < m->nodes->block_count; b++) {
        resist_bonds(damping, m, &m->nodes->blocks[b]);
        resist_nodes(damping, m, &m->nodes->blocks[b], force, duration);
    }
}

void pdmc_damping_add(const pdmc_damping *damping, const pdmc_motion_of_nodes *m, double sign,
                      double *const force[PDMC_AXES])
{
    const pdmc_nodes *g = m->nodes;
    for (int k = 0; k < g->node_count; k++)
        for (int a = 0; a < PDMC_AXES; a++) force[a][g->cell[k]] += sign * damping->force[a][g->cell[k]];
}

void pdmc_damping_correct(const pdmc_damping *damping, size_t cell, int axis, double density, double step,
                          double before, double after, double *force)
{
    if (damping->absolute == 0.0) return;
    const double by_density = 0.5 * step / density;
    const double factor = -damping->absolute / (1.0 + damping->absolute * by_density); // as in resist_nodes()
    const double others = (*force - factor * before) / (1.0 + factor * by_density);
    const double correct = others - damping->absolute * 0.5 * (before + after);
    damping->force[axis][cell] += correct - *force;
    *force = correct;
}

/// The power of a block's damping forces, at velocities that are older by the duration, or as they are.
static double power_of(const pdmc_damping *damping, const pdmc_motion_of_nodes *m, const pdmc_block *block,
                       double *const force[PDMC_AXES], double duration)
{
    const double by_density = duration / m->density[block->material];
    double power = 0.0;
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const size_t c = block->cell + (size_t)__builtin_ctz(left);
        for (int a = 0; a < PDMC_AXES; a++)
            power += m->nodes->volume[c] * damping->force[a][c] * (m->velocity[a][c] + by_density * force[a][c]);
    }
    return power;
}

static double whole_power(const pdmc_damping *damping, const pdmc_motion_of_nodes *m, double *const force[PDMC_AXES],
                          double duration)
{
    const pdmc_nodes *g = m->nodes;
    double power = 0.0;
#pragma omp parallel for num_threads(m->threads) schedule(static)
    for (int b = 0; b < g->block_count; b++) damping->share[b] = power_of(damping, m, &g->blocks[b], force, duration);
    for (int b = 0; b < g->block_count; b++) power += damping->share[b];
    return power;
}

void pdmc_damping_count(pdmc_damping *damping, const pdmc_motion_of_nodes *m, double *const force[PDMC_AXES],
                        double step)
{
    damping->after = -0.5 * step * whole_power(damping, m, force, step);
    damping->dissipated += damping->after - 0.5 * step * whole_power(damping, m, force, 0.0);
}

double pdmc_damping_stable_step(double undamped, double rate)
{
    const double square = 4.0 / (undamped * undamped); // A
    return rate > 0.0 ? (sqrt(rate * rate + 4.0 * square) - rate) / square : undamped;
}
