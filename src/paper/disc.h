// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The disc of a point's bonds: as far as the horizon, but no further than the first crack or the plate's edge
/// (Evangelatos & Spanos 2011, section 4.2, figure 4 and appendix A).
///
/// Between the directions of two tips a bond ends where it meets the crack, at r(theta) = d / sin(theta - alpha), d the
/// distance to the crack's line and alpha its angle. Eq. A.8 finds the same curve as a sum over steps along the crack,
/// which has this for its limit. The directions where r(theta) has a corner or jumps (tips, corners of the plate, the
/// crossings of the circle with cracks and edges) part the panels, so that Gauss points see a smooth function.

#include "pdmc/problem.h"

typedef struct {
    double length;
    double direction[2];
    double weight; // of dr dtheta
} pdmc_paper_bond;

typedef struct {
    const pdmc_problem *problem;
    double horizon;
    double *part;          // [most_parts] directions that part the panels
    pdmc_paper_bond *bond; // [count] of the point that was cut last
    int count, most_bonds;
} pdmc_paper_disc;

/// @param[out] disc  free with pdmc_paper_disc_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_paper_disc_create(const pdmc_problem *problem, double horizon, pdmc_paper_disc *disc);
void pdmc_paper_disc_clear(pdmc_paper_disc *disc);

/// Fills disc->bond with the points of a quadrature over the bonds of x.
PDMC_NODISCARD pdmc_status pdmc_paper_disc_cut(pdmc_paper_disc *disc, const double x[2]);

/// The length of the longest bond of x in a direction.
double pdmc_paper_reach(const pdmc_problem *problem, double horizon, const double x[2], const double direction[2]);
