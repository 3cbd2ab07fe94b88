// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/nodes.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <math.h>

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[], const double b[], double out[])
{
    for (int k = 0; k < PDMC_AXES; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/// Where the segment pq crosses the plane through a point; a plane that holds an end belongs to the side of its normal.
static bool cross_plane(const double point[], const double normal[], const double p[], const double q[], double at[])
{
    double from[PDMC_AXES], to[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) from[a] = p[a] - point[a], to[a] = q[a] - point[a];
    const double below = dot(from, normal), above = dot(to, normal);
    if ((below < 0.0) == (above < 0.0)) return false;
    const double share = below / (below - above);
    for (int a = 0; a < PDMC_AXES; a++) at[a] = from[a] + share * (to[a] - from[a]);
    return true;
}

// A bond that goes exactly through the edge of a crack is cut, whatever rounding says, so that a crack in the middle of a
// body has two like tips.
static const double with_rounding = 1.0 + 1e-9;

static bool crosses_segment(const pdmc_planar_crack *crack, const double p[], const double q[])
{
    double from[2], to[2];
    for (int a = 0; a < 2; a++) {
        from[a] = crack->to[a] + with_rounding * (crack->from[a] - crack->to[a]);
        to[a] = crack->from[a] + with_rounding * (crack->to[a] - crack->from[a]);
    }
    return pdmc_segments_cross(p, q, from, to);
}

static bool crosses(const pdmc_planar_crack *crack, const double p[], const double q[])
{
    double at[PDMC_AXES], normal[PDMC_AXES];
    switch (crack->kind) {
    case PDMC_CRACK_SEGMENT: return crosses_segment(crack, p, q);
    case PDMC_CRACK_DISC:
        return cross_plane(crack->centre, crack->normal, p, q, at) &&
               dot(at, at) <= with_rounding * crack->radius * crack->radius;
    case PDMC_CRACK_RECTANGLE:
        cross(crack->side[0], crack->side[1], normal);
        if (!cross_plane(crack->centre, normal, p, q, at)) return false;
        return fabs(dot(at, crack->side[0])) <= with_rounding * dot(crack->side[0], crack->side[0]) &&
               fabs(dot(at, crack->side[1])) <= with_rounding * dot(crack->side[1], crack->side[1]);
    }
    return false;
}

/// Both directions of a bond are asked in the same order of its ends, so that they agree.
static bool is_cut(const pdmc_nodes *g, const pdmc_planar_crack *crack, size_t i, size_t j)
{
    double p[PDMC_AXES], q[PDMC_AXES];
    const size_t first = i < j ? i : j, second = i < j ? j : i;
    for (int a = 0; a < PDMC_AXES; a++) p[a] = g->reference[a][first], q[a] = g->reference[a][second];
    return crosses(crack, p, q);
}

/// @return whether any was
static bool cut_bonds(pdmc_nodes *g, const pdmc_block *block, const pdmc_planar_crack *crack)
{
    bool any = false;
    for (int n = 0; n < block->listed; n++) {
        uint8_t *bonds = &g->bonds[block->bonds + (size_t)n];
        for (unsigned left = *bonds; left; left &= left - 1) {
            const int lane = __builtin_ctz(left);
            const size_t i = block->cell + (size_t)lane;
            if (!is_cut(g, crack, i, pdmc_nodes_neighbour(g, block, n, lane))) continue;
            *bonds &= (uint8_t) ~(1u << lane);
            any = true;
        }
    }
    return any;
}

/// A node that had bonds, and has none.
static pdmc_status find_isolated(const pdmc_nodes *g, int crack)
{
    for (int b = 0; b < g->block_count; b++) {
        int whole[PDMC_LANES];
        pdmc_nodes_whole(g, &g->blocks[b], whole);
        for (unsigned left = g->blocks[b].nodes; left; left &= left - 1) {
            const int k = __builtin_ctz(left);
            const size_t c = g->blocks[b].cell + (size_t)k;
            PDMC_REQUIRE(g->family[c] == 0 || whole[k] > 0,
                         "cracks[%d]: cuts all bonds of the node at (%g, %g, %g) that are left", crack,
                         g->reference[0][c], g->reference[1][c], g->reference[2][c]);
        }
    }
    return PDMC_OK;
}

pdmc_status pdmc_nodes_cut(pdmc_nodes *g, int count, const pdmc_planar_crack cracks[])
{
    for (int c = 0; c < count; c++) {
        bool any = false;
        for (int b = 0; b < g->block_count; b++) any |= cut_bonds(g, &g->blocks[b], &cracks[c]);
        PDMC_REQUIRE(any, "cracks[%d]: crosses no bond, or none that those before it have left", c);
        const pdmc_status status = find_isolated(g, c);
        if (status != PDMC_OK) return status;
    }
    return PDMC_OK;
}
