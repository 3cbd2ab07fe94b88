// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/sphere.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

enum { SHARE = PDMC_AXES + 1 }; // of a block: the force on the sphere, and the energy
enum { PASS = 64 };             // blocks that one thread takes at a time

static void push_node(const pdmc_rigid_sphere *sphere, const double volume[], double *const position[], size_t c,
                      double *const force[], double share[])
{
    double out[PDMC_AXES], square = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        out[a] = position[a][c] - sphere->centre[a];
        square += out[a] * out[a];
    }
    if (square >= sphere->radius * sphere->radius || square == 0.0) return;
    const double distance = sqrt(square), depth = sphere->radius - distance;
    const double push = sphere->stiffness * depth * depth / distance;
    for (int a = 0; a < PDMC_AXES; a++) {
        force[a][c] += push * out[a];
        share[a] -= push * out[a] * volume[c];
    }
    share[PDMC_AXES] += sphere->stiffness * depth * depth * depth / 3.0 * volume[c];
}

/// Which of a block's cells are inside the sphere, so that most blocks are done with at once.
static unsigned inside(const pdmc_rigid_sphere *sphere, double *const position[], const pdmc_block *block)
{
    double square[PDMC_LANES] = {0.0};
    unsigned bits = 0;
    for (int a = 0; a < PDMC_AXES; a++) {
        const double *x = &position[a][block->cell];
        for (int k = 0; k < PDMC_LANES; k++) square[k] += (x[k] - sphere->centre[a]) * (x[k] - sphere->centre[a]);
    }
    for (int k = 0; k < PDMC_LANES; k++) bits |= (unsigned)(square[k] < sphere->radius * sphere->radius) << k;
    return bits & block->nodes;
}

PDMC_VECTORS("avx2", "avx512f")
static void push_blocks(const pdmc_rigid_sphere *sphere, const pdmc_nodes *g, int first, int last,
                        double *const position[PDMC_AXES], double *const force[PDMC_AXES], double reaction[])
{
    memset(&reaction[SHARE * (size_t)first], 0, SHARE * (size_t)(last - first) * sizeof *reaction);
    for (int b = first; b < last; b++)
        for (unsigned left = inside(sphere, position, &g->blocks[b]); left; left &= left - 1)
            push_node(sphere, g->volume, position, g->blocks[b].cell + (size_t)__builtin_ctz(left), force,
                      &reaction[SHARE * (size_t)b]);
}

double pdmc_sphere_push(const pdmc_rigid_sphere *sphere, const pdmc_nodes *g, double *const position[PDMC_AXES],
                        int threads, double *const force[PDMC_AXES], double reaction[], double total[PDMC_AXES])
{
    double energy = 0.0;
    memset(total, 0, PDMC_AXES * sizeof *total);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int b = 0; b < g->block_count; b += PASS)
        push_blocks(sphere, g, b, b + PASS < g->block_count ? b + PASS : g->block_count, position, force, reaction);
    for (int b = 0; b < g->block_count; b++) {
        const double *share = &reaction[SHARE * (size_t)b];
        for (int a = 0; a < PDMC_AXES; a++) total[a] += share[a];
        energy += share[PDMC_AXES];
    }
    return energy;
}
