// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

/// Adds one bond of every node of a row: to the point in the row of cells that the bond's shift leads to.
static void add_bond(const pdmc_solid *solid, const solid_bond *bond, size_t row, size_t other, const double u[],
                     const double points[], double force[], double energy[])
{
    const size_t n = solid->nodes;
    const int length = solid->options.nodes[0], shift = bond->shift[0];
    const int first = shift < 0 ? -shift : 0, end = shift > 0 ? length - shift : length;
    const double *at = points + (size_t)bond->point * 3 * n + other, *beta = solid->compensation;
    const double x = bond->xi[0], y = bond->xi[1], z = bond->xi[2], half = 0.5 * bond->stiffness;
    for (int i = first; i < end; i++) {
        const size_t here = row + (size_t)i, there = (size_t)(i + shift);
        const double longer =
            x * (at[there] - u[here]) + y * (at[n + there] - u[n + here]) + z * (at[2 * n + there] - u[2 * n + here]);
        const double pull = half * (beta[here] + beta[other + there]) * longer;
        force[here] += pull * x;
        force[n + here] += pull * y;
        force[2 * n + here] += pull * z;
        if (energy) energy[here] += 0.25 * pull * longer;
    }
}

/// All bonds of the nodes of one row along the first direction, in the order of the stencil: no sum depends on the
/// number of threads.
static void add_row(const pdmc_solid *solid, int line, const double u[], const double points[], double force[],
                    double energy[])
{
    const int *n = solid->options.nodes, index[3] = {0, line % n[1], line / n[1]};
    const size_t row = solid_node(solid, index);
    for (int b = 0; b < solid->stencil.count; b++) {
        const solid_bond *bond = &solid->stencil.bond[b];
        const int other[3] = {0, index[1] + bond->shift[1], index[2] + bond->shift[2]};
        if (other[1] < 0 || other[1] >= n[1] || other[2] < 0 || other[2] >= n[2]) continue;
        add_bond(solid, bond, row, solid_node(solid, other), u, points, force, energy);
    }
}

void solid_add_bond_forces(const pdmc_solid *solid, const double u[], const double points[], double force[],
                           double energy[])
{
    const int lines = solid->options.nodes[1] * solid->options.nodes[2];
    if (energy) memset(energy, 0, solid->nodes * sizeof *energy);
#pragma omp parallel for schedule(static) num_threads(solid->options.threads)
    for (int line = 0; line < lines; line++) add_row(solid, line, u, points, force, energy);
}

void pdmc_solid_force(const pdmc_solid *solid, const double u[], double force[], double energy[])
{
    memcpy(force, solid->traction, 3 * solid->nodes * sizeof *force);
    if (solid->points) solid_interpolate(&solid->interpolation, solid->options.threads, solid->nodes, u, solid->points);
    solid_add_bond_forces(solid, u, solid->points ? solid->points : u, force, energy);
}
