// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <math.h>

enum { MAX_POINTS = 4 };

/// The share of a cube of size `size` about a point at distance r that lies within the horizon (Yu 2011, eq. 2.16, 3.14).
static double share_within(double r, double horizon, double size)
{
    return fmax(0.0, fmin(1.0, (horizon + 0.5 * size - r) / size));
}

typedef struct {
    int along;                                 // points along each direction
    double at[MAX_POINTS], weight[MAX_POINTS]; // in a cell of size 1
} cell_rule;

static pdmc_status cell_rule_create(const pdmc_solid_options *options, cell_rule *rule)
{
    if (options->rule == PDMC_SOLID_CUBIC_CELL) {
        *rule = (cell_rule){1, {0.0}, {1.0}};
        return PDMC_OK;
    }
    rule->along = options->gauss_points;
    return pdmc_gauss_legendre(rule->along, -0.5, 0.5, rule->at, rule->weight);
}

/// Volume of a point that counts in a node's horizon. A cell of one point counts while its node is within the horizon, as
/// the tables of Yu (2011) were made; Gauss points count by their share.
static double volume_within(const pdmc_solid_options *options, double r, double volume)
{
    if (options->rule == PDMC_SOLID_CUBIC_CELL && r > options->horizon * (1.0 + 1e-12)) return 0.0;
    return volume * share_within(r, options->horizon, cbrt(volume));
}

static void add_cell(const pdmc_solid_options *options, double micromodulus, const cell_rule *rule, const int shift[3],
                     solid_stencil *stencil)
{
    const double h = options->spacing;
    for (int point = 0; point < stencil->points; point++) {
        const int n = rule->along, along[3] = {point % n, point / n % n, point / (n * n)};
        double volume = 1.0, squared = 0.0;
        solid_bond bond = {{shift[0], shift[1], shift[2]}, point, {0.0}, 0.0};
        for (int k = 0; k < 3; k++) {
            stencil->at[point][k] = rule->at[along[k]] * h;
            bond.xi[k] = shift[k] * h + stencil->at[point][k];
            squared += bond.xi[k] * bond.xi[k];
            volume *= rule->weight[along[k]] * h;
        }
        const double r = sqrt(squared);
        if (r == 0.0) continue;
        bond.stiffness = volume_within(options, r, volume) * micromodulus / (r * squared);
        if (bond.stiffness > 0.0) stencil->bond[stencil->count++] = bond;
    }
}

pdmc_status solid_stencil_create(const pdmc_solid_options *options, double micromodulus, solid_stencil *stencil)
{
    pdmc_status status = PDMC_OK;
    const int reach = (int)ceil(options->horizon / options->spacing + 0.5), side = 2 * reach + 1;
    cell_rule rule;
    *stencil = (solid_stencil){0};
    PDMC_TRY(cell_rule_create(options, &rule));
    stencil->points = rule.along * rule.along * rule.along;
    PDMC_NEW(stencil->at, stencil->points);
    PDMC_NEW(stencil->bond, (size_t)stencil->points * (size_t)(side * side * side));
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++)
                add_cell(options, micromodulus, &rule, (const int[]){x, y, z}, stencil);
done:
    if (status != PDMC_OK) solid_stencil_clear(stencil);
    return status;
}

void solid_stencil_clear(solid_stencil *stencil)
{
    pdmc_free(stencil->at);
    pdmc_free(stencil->bond);
    *stencil = (solid_stencil){0};
}
