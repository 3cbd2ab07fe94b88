// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The trial functions of Evangelatos & Spanos 2011, the same for u and v:
///  - psi g_k, g_k the inverse multiquadric of node k (eq. 25), zero where the node is not visible (section 5, fig. B.2),
///  - q = 1, x, y, xy (eq. A.10), lengths in units of half the plate's shorter side L,
///  - q_5 .. q_8 of eq. 38, sqrt(r / L) times cos(t/2), sin(t/2), sin(t/2) sin t, cos(t/2) sin t, for every tip in its own
///    polar frame, t = 0 straight ahead. q_6 jumps at t = +-pi: on the crack, as it must, and on the continuation of the
///    crack beyond its other tip, where nothing ends it.

#include "paper/nodes.h"

enum { PDMC_PAPER_MONOMIALS = 4, PDMC_PAPER_TIP_FUNCTIONS = 4 };

typedef struct {
    double position[2];
    double cosine, sine; // of the direction straight ahead
} pdmc_paper_tip_frame;

typedef struct {
    const pdmc_problem *problem;
    pdmc_paper_nodes nodes;
    int tip_count;             // of tips with functions of their own
    pdmc_paper_tip_frame *tip; // [tip_count]
    double scale;              // L
    int scalars;               // functions of u, and of v
} pdmc_paper_basis;

/// @param[out] basis  free with pdmc_paper_basis_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_paper_basis_create(const pdmc_problem *problem, pdmc_paper_basis *basis);
void pdmc_paper_basis_clear(pdmc_paper_basis *basis);

/// True unless a crack lies between two points; one that is touched at its tip does not.
bool pdmc_paper_visible(const pdmc_problem *problem, const double p[2], const double q[2]);

/// Values at x. On a crack the side is chosen by `anchor`, a point close by; elsewhere anchor = x.
/// @param[out] value  [scalars] nodes, monomials, tip functions
void pdmc_paper_values(const pdmc_paper_basis *basis, const double x[2], const double anchor[2], double value[]);

/// The functions q alone: monomials and tip functions.
/// @param[out] value  [scalars - nodes]
void pdmc_paper_q_values(const pdmc_paper_basis *basis, const double x[2], const double anchor[2], double value[]);
