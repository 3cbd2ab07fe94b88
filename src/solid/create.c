// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>

static pdmc_status check(const pdmc_solid_options *o)
{
    for (int k = 0; k < 3; k++) PDMC_REQUIRE(o->nodes[k] >= 1, "a body needs a node along each direction");
    PDMC_REQUIRE(o->spacing > 0.0 && isfinite(o->spacing), "spacing must be positive");
    PDMC_REQUIRE(o->horizon >= o->spacing && isfinite(o->horizon), "the horizon must not be below the spacing");
    PDMC_REQUIRE(o->youngs_modulus > 0.0 && isfinite(o->youngs_modulus), "Young's modulus must be positive");
    PDMC_REQUIRE(o->rule == PDMC_SOLID_CUBIC_CELL || (o->gauss_points >= 2 && o->gauss_points <= 4),
                 "2 to 4 Gauss points a side");
    PDMC_REQUIRE(o->threads >= 1, "threads must be at least 1");
    for (int face = 0; face < PDMC_SOLID_FACES; face++)
        PDMC_REQUIRE(o->layers[face] >= 0, "layers must not be negative");
    return PDMC_OK;
}

/// Marks the layers of nodes at faces whose displacement is prescribed.
static void prescribe(pdmc_solid *solid)
{
    for (size_t i = 0; i < solid->nodes; i++) {
        int index[3];
        solid_indices(solid, i, index);
        for (int k = 0; k < 3; k++) {
            if (index[k] < solid->options.layers[2 * k]) solid->prescribed[i] = 1;
            if (solid->options.nodes[k] - 1 - index[k] < solid->options.layers[2 * k + 1]) solid->prescribed[i] = 1;
        }
    }
}

/// Half of a row lies in the columns of the other points, half in the node's own.
static void sum_rows(pdmc_solid *solid)
{
    for (size_t i = 0; i < solid->nodes; i++) {
        int index[3];
        solid_indices(solid, i, index);
        for (int b = 0; b < solid->stencil.count; b++) {
            const solid_bond *bond = &solid->stencil.bond[b];
            if (!solid_inside(solid, index, bond->shift)) continue;
            const int other[3] = {index[0] + bond->shift[0], index[1] + bond->shift[1], index[2] + bond->shift[2]};
            const double beta = solid->compensation[i] + solid->compensation[solid_node(solid, other)];
            const double lengths = fabs(bond->xi[0]) + fabs(bond->xi[1]) + fabs(bond->xi[2]);
            for (size_t k = 0; k < 3; k++)
                solid->row_sum[k * solid->nodes + i] += beta * bond->stiffness * fabs(bond->xi[k]) * lengths;
        }
    }
}

/// Gauss points are displaced by the nodes about them; the body of cubic cells corrects towards their equilibrium.
static pdmc_status interpolate(pdmc_solid *solid)
{
    pdmc_status status = PDMC_OK;
    pdmc_solid_options cells = solid->options;
    if (solid->options.rule != PDMC_SOLID_GAUSS) return PDMC_OK;
    PDMC_TRY(solid_interpolation_create(&solid->options, &solid->stencil, &solid->interpolation));
    PDMC_NEW(solid->points, 3 * solid->nodes * (size_t)solid->stencil.points);
    cells.rule = PDMC_SOLID_CUBIC_CELL;
    if (cells.compensation == PDMC_COMPENSATION_NONE) cells.compensation = PDMC_COMPENSATION_EXACT;
    for (int face = 0; face < PDMC_SOLID_FACES; face++) cells.load[face] = (pdmc_solid_load){0};
    PDMC_TRY(pdmc_solid_create(&cells, &solid->cells));
done:
    return status;
}

pdmc_status pdmc_solid_create(const pdmc_solid_options *options, pdmc_solid **out)
{
    pdmc_status status = PDMC_OK;
    pdmc_solid *solid = NULL;
    *out = NULL;
    PDMC_TRY(check(options));
    pdmc_blas_prepare();
    PDMC_NEW(solid, 1);
    solid->options = *options;
    solid->nodes = (size_t)options->nodes[0] * (size_t)options->nodes[1] * (size_t)options->nodes[2];
    solid->micromodulus = 12.0 * options->youngs_modulus / (M_PI * gsl_pow_4(options->horizon));
    PDMC_TRY(solid_stencil_create(options, solid->micromodulus, &solid->stencil));
    PDMC_NEW(solid->compensation, solid->nodes);
    PDMC_NEW(solid->prescribed, solid->nodes);
    PDMC_NEW(solid->traction, 3 * solid->nodes);
    PDMC_NEW(solid->row_sum, 3 * solid->nodes);
    for (int face = 0; face < PDMC_SOLID_FACES; face++) {
        const double *t = options->load[face].traction;
        solid->loaded[face] = t[0] != 0.0 || t[1] != 0.0 || t[2] != 0.0;
    }
    solid_compensate(solid);
    prescribe(solid);
    sum_rows(solid);
    PDMC_TRY(solid_add_tractions(solid));
    PDMC_TRY(interpolate(solid));
    *out = solid;
    solid = NULL;
done:
    pdmc_solid_destroy(solid);
    return status;
}

void pdmc_solid_destroy(pdmc_solid *solid)
{
    if (!solid) return;
    solid_stencil_clear(&solid->stencil);
    solid_interpolation_clear(&solid->interpolation);
    pdmc_free(solid->points);
    pdmc_solid_destroy(solid->cells);
    pdmc_free(solid->compensation);
    pdmc_free(solid->prescribed);
    pdmc_free(solid->traction);
    pdmc_free(solid->row_sum);
    pdmc_free(solid);
}

size_t pdmc_solid_nodes(const pdmc_solid *solid)
{
    return solid->nodes;
}

void pdmc_solid_position(const pdmc_solid *solid, size_t node, double x[3])
{
    int index[3];
    solid_indices(solid, node, index);
    for (int k = 0; k < 3; k++) x[k] = (index[k] - 0.5 * (solid->options.nodes[k] - 1)) * solid->options.spacing;
}

const double *pdmc_solid_compensation_factors(const pdmc_solid *solid)
{
    return solid->compensation;
}

const double *pdmc_solid_traction_force(const pdmc_solid *solid)
{
    return solid->traction;
}

void pdmc_solid_start(const pdmc_solid *solid, double u[])
{
    for (size_t i = 0; i < solid->nodes; i++) {
        double x[3];
        pdmc_solid_position(solid, i, x);
        for (size_t k = 0; k < 3; k++) {
            const double *row = solid->options.strain[k];
            u[k * solid->nodes + i] = solid->prescribed[i] ? row[0] * x[0] + row[1] * x[1] + row[2] * x[2] : 0.0;
        }
    }
}
