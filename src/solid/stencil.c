// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"
#include "pdmc/horizon.h"
#include "pdmc/quadrature.h"

#include <math.h>

enum { MAX_SIDE = 4 };

static int points_a_side(const pdmc_solid_options *options)
{
    return options->rule == PDMC_SOLID_GAUSS ? options->gauss_points : 1;
}

/// Positions of a cell's points from its node, the first direction fastest.
static pdmc_status place_points(const pdmc_solid_options *options, solid_stencil *stencil)
{
    pdmc_status status = PDMC_OK;
    const int side = points_a_side(options);
    double at[MAX_SIDE], weight[MAX_SIDE];
    stencil->points = side * side * side;
    PDMC_NEW(stencil->at, stencil->points);
    PDMC_TRY(pdmc_gauss_legendre(side, -0.5 * options->spacing, 0.5 * options->spacing, at, weight));
    for (int p = 0; p < stencil->points; p++) {
        const int along[3] = {p % side, p / side % side, p / (side * side)};
        for (int k = 0; k < 3; k++) stencil->at[p][k] = at[along[k]];
    }
done:
    return status;
}

/// Which of a cell's points stands at `offset` from its node: Gauss' abscissas lie one in each of as many equal parts.
static int point_at(const pdmc_solid_options *options, const double offset[3])
{
    const int side = points_a_side(options);
    int along[3];
    for (int k = 0; k < 3; k++) along[k] = (int)floor((offset[k] / options->spacing + 0.5) * side);
    return (along[2] * side + along[1]) * side + along[0];
}

static void add_bond(const pdmc_solid_options *options, double micromodulus, const int cell[3], const double xi[3],
                     double volume, solid_stencil *stencil)
{
    solid_bond bond = {.shift = {cell[0], cell[1], cell[2]}, .xi = {xi[0], xi[1], xi[2]}};
    double offset[3], squared = 0.0;
    for (int k = 0; k < 3; k++) {
        offset[k] = xi[k] - cell[k] * options->spacing;
        squared += xi[k] * xi[k];
    }
    if (squared == 0.0) return;
    bond.point = point_at(options, offset);
    bond.stiffness = volume * micromodulus / (squared * sqrt(squared));
    stencil->bond[stencil->count++] = bond;
}

pdmc_status solid_stencil_create(const pdmc_solid_options *options, double micromodulus, solid_stencil *stencil)
{
    pdmc_status status = PDMC_OK;
    const pdmc_horizon_kind kind = options->rule == PDMC_SOLID_GAUSS ? PDMC_RULE_GAUSS : PDMC_RULE_CUBIC;
    pdmc_horizon_options rule_options = pdmc_horizon_options_default(kind, 3, options->horizon, options->spacing);
    pdmc_horizon_rule rule = {0};
    *stencil = (solid_stencil){0};
    rule_options.gauss_points = points_a_side(options);
    PDMC_TRY(place_points(options, stencil));
    PDMC_TRY(pdmc_horizon_rule_create(&rule_options, &rule));
    PDMC_NEW(stencil->bond, rule.point_count);
    for (int cell = 0; cell < rule.cell_count; cell++)
        for (int p = rule.first[cell]; p < rule.first[cell + 1]; p++)
            add_bond(options, micromodulus, &rule.cell[3 * cell], &rule.position[3 * p], rule.weight[p], stencil);
done:
    pdmc_horizon_rule_clear(&rule);
    if (status != PDMC_OK) solid_stencil_clear(stencil);
    return status;
}

void solid_stencil_clear(solid_stencil *stencil)
{
    pdmc_free(stencil->at);
    pdmc_free(stencil->bond);
    *stencil = (solid_stencil){0};
}
