// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/stable.h"

#include "particles/damping.h"

#include <math.h>

/// Over a node's bonds: of V_p c / |xi|, and of V_p c.
typedef struct {
    double stiffness, weight;
} bond_sums;

static double step_of(bond_sums sums, double density, double bond_damping)
{
    return pdmc_damping_stable_step(sqrt(2.0 * density / sums.stiffness), 2.0 * bond_damping * sums.weight / density);
}

/// On a grid, where no axis is before another, beta^2 is 1 / dimension in the mean over a family.
static bond_sums whole_family(const pdmc_nodes *g, const pdmc_brittle_law *law)
{
    const double c = law->micromodulus * fmax(1.0, 1.0 + law->fibre_excess / g->dimension);
    return (bond_sums){c * g->stiffest, c * g->heaviest};
}

static void add_neighbour(const pdmc_nodes *g, const pdmc_variation *v, const pdmc_brittle_law *law,
                          const pdmc_block *block, int listed, bond_sums sums[])
{
    for (unsigned left = g->bonds[block->bonds + (size_t)listed]; left; left &= left - 1) {
        const int k = __builtin_ctz(left);
        const size_t i = block->cell + (size_t)k, j = pdmc_nodes_neighbour(g, block, listed, k);
        const double weight = pdmc_variation_micromodulus(v, g, law, i, j) * pdmc_nodes_weight(g, i, j);
        sums[k].stiffness += weight / pdmc_nodes_length(g, i, j);
        sums[k].weight += weight;
    }
}

static double step_of_block(const pdmc_nodes *g, const pdmc_variation *v, const pdmc_brittle_law laws[],
                            const double density[], double bond_damping, const pdmc_block *block)
{
    bond_sums sums[PDMC_LANES] = {{0.0, 0.0}};
    double least = INFINITY;
    for (int n = 0; n < block->listed; n++) add_neighbour(g, v, &laws[block->material], block, n, sums);
    for (unsigned left = block->nodes; left; left &= left - 1)
        least = fmin(least, step_of(sums[__builtin_ctz(left)], density[block->material], bond_damping));
    return least;
}

static bool are_alike(const pdmc_nodes *g, const pdmc_variation *v, const pdmc_brittle_law *law)
{
    return !v->stiffness && (law->fibre_excess == 0.0 || !g->partner);
}

double pdmc_bonds_stable_step(const pdmc_nodes *g, const pdmc_variation *v, int materials,
                              const pdmc_brittle_law laws[], const double density[], double bond_damping)
{
    double least = INFINITY;
    for (int m = 0; m < materials; m++)
        if (are_alike(g, v, &laws[m]))
            least = fmin(least, step_of(whole_family(g, &laws[m]), density[m], bond_damping));
    for (int b = 0; b < g->block_count; b++)
        if (g->blocks[b].joined || !are_alike(g, v, &laws[g->blocks[b].material]))
            least = fmin(least, step_of_block(g, v, laws, density, bond_damping, &g->blocks[b]));
    return least;
}
