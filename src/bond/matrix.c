// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/stiffness.h"

static bool is_held(const pdmc_bond_plate *plate, int node, int component)
{
    return plate->grid.held[node] & (1U << component);
}

// Column `component` of a node has the node itself from the diagonal down, and the partners behind it: the order of the
// families is that of the nodes.
static int64_t count_column(const pdmc_bond_plate *plate, int node, int component)
{
    const pdmc_bond_families *families = &plate->families;
    int64_t count = 1;
    if (is_held(plate, node, component)) return count;
    if (component == 0 && !is_held(plate, node, 1)) count++;
    for (size_t b = families->start[node]; b < families->start[node + 1]; b++)
        if (families->partner[b] > node)
            for (int i = 0; i < 2; i++) count += !is_held(plate, families->partner[b], i);
    return count;
}

// k e_i e_j h^2 of a bond: xx, xy, yy
static void bond_block(const pdmc_bond_plate *plate, const pdmc_bond_moduli *moduli, int node, size_t b,
                       double block[3])
{
    const pdmc_bond_families *families = &plate->families;
    const pdmc_bond_neighbour *n = &plate->horizon.neighbour[families->neighbour[b]];
    const double *e = n->direction, scale = 0.5 * (families->scale[node] + families->scale[families->partner[b]]);
    double factor = moduli->shell[n->shell];
    if (moduli->node) factor += 0.5 * (moduli->node[node] + moduli->node[families->partner[b]]);
    const double k = plate->grid.spacing * plate->grid.spacing * n->stiffness * factor * scale;
    block[0] = k * e[0] * e[0];
    block[1] = k * e[0] * e[1];
    block[2] = k * e[1] * e[1];
}

static void fill_column(const pdmc_bond_plate *plate, const pdmc_bond_moduli *moduli, int node, int component,
                        pdmc_sparse_matrix *matrix)
{
    const pdmc_bond_families *families = &plate->families;
    const int64_t first = matrix->start[2 * (size_t)node + (size_t)component];
    const bool has_coupling = component == 0 && !is_held(plate, node, 1);
    int64_t at = first;
    matrix->row[at] = 2 * (int64_t)node + component;
    matrix->value[at++] = 1.0;
    if (is_held(plate, node, component)) return;
    matrix->value[first] = 0.0;
    if (has_coupling) {
        matrix->row[at] = 2 * (int64_t)node + 1;
        matrix->value[at++] = 0.0;
    }
    for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
        const int partner = families->partner[b];
        double block[3];
        bond_block(plate, moduli, node, b, block);
        matrix->value[first] += block[component == 0 ? 0 : 2];
        if (has_coupling) matrix->value[first + 1] += block[1];
        for (int i = 0; i < 2; i++) {
            if (partner < node || is_held(plate, partner, i)) continue;
            matrix->row[at] = 2 * (int64_t)partner + i;
            matrix->value[at++] = -block[component + i];
        }
    }
}

void pdmc_bond_matrix_fill(const pdmc_bond_plate *plate, const pdmc_bond_moduli *moduli, pdmc_sparse_matrix *matrix)
{
    for (int unknown = 0; unknown < matrix->unknowns; unknown++)
        fill_column(plate, moduli, unknown / 2, unknown % 2, matrix);
}

pdmc_status pdmc_bond_matrix_create(const pdmc_bond_plate *plate, const pdmc_bond_moduli *moduli,
                                    pdmc_sparse_matrix *out)
{
    pdmc_status status = PDMC_OK;
    *out = (pdmc_sparse_matrix){.unknowns = 2 * plate->grid.nodes};
    PDMC_NEW(out->start, out->unknowns + 1);
    for (int unknown = 0; unknown < out->unknowns; unknown++)
        out->start[unknown + 1] = out->start[unknown] + count_column(plate, unknown / 2, unknown % 2);
    PDMC_NEW(out->row, out->start[out->unknowns]);
    PDMC_NEW(out->value, out->start[out->unknowns]);
    pdmc_bond_matrix_fill(plate, moduli, out);
done:
    if (status != PDMC_OK) pdmc_sparse_matrix_clear(out);
    return status;
}
