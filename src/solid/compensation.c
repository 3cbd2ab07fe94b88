// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "pdmc/quadrature.h"

#include <gsl/gsl_math.h>

/// Distances from a node to the faces beyond which there is nothing, the body ending half a spacing beyond its outermost
/// nodes. Beyond a face with a traction lies what pulls there, as f_L.
static void distances(const pdmc_solid *solid, const int index[3], double below[3], double above[3])
{
    for (int k = 0; k < 3; k++) {
        below[k] = solid->loaded[2 * k] ? INFINITY : (index[k] + 0.5) * solid->options.spacing;
        above[k] =
            solid->loaded[2 * k + 1] ? INFINITY : (solid->options.nodes[k] - index[k] - 0.5) * solid->options.spacing;
    }
}

/// int |xi| dV, which is W / (c e^2 / 4) of an isotropic strain e, by the stencil's points.
static double summed(const pdmc_solid *solid, const int index[3])
{
    double below[3], above[3], sum = 0.0;
    distances(solid, index, below, above);
    for (int b = 0; b < solid->stencil.count; b++) {
        const solid_bond *bond = &solid->stencil.bond[b];
        double squared = 0.0;
        bool inside = true;
        for (int k = 0; k < 3; k++) {
            const double shift = bond->shift[k] * solid->options.spacing;
            if (-shift > below[k] || shift > above[k]) inside = false;
            squared += bond->xi[k] * bond->xi[k];
        }
        if (inside) sum += bond->stiffness / solid->micromodulus * squared * squared;
    }
    return sum;
}

double solid_horizon_share(const pdmc_solid *solid, const int index[3])
{
    double below[3], above[3];
    distances(solid, index, below, above);
    return pdmc_integrate_distance_in_box(solid->options.horizon, below, above) /
           (M_PI * gsl_pow_4(solid->options.horizon));
}

void solid_compensate(pdmc_solid *solid)
{
    const double whole = M_PI * gsl_pow_4(solid->options.horizon);
    for (size_t i = 0; i < solid->nodes; i++) {
        int index[3];
        solid_indices(solid, i, index);
        switch (solid->options.compensation) {
        case PDMC_COMPENSATION_NONE: solid->compensation[i] = 1.0; break;
        case PDMC_COMPENSATION_SUM: solid->compensation[i] = whole / summed(solid, index); break;
        case PDMC_COMPENSATION_EXACT: solid->compensation[i] = 1.0 / solid_horizon_share(solid, index); break;
        }
    }
}
