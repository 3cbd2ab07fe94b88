// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The interpolant of the displacement near one node, from the nodes that it sees:
///     s(x) = sum_k a_k phi(|x - x_k| / L) + sum_j b_j p_j((x - x_0) / L),   sum_k a_k p_j = 0,
/// L the stencil's radius, phi the inverse multiquadric with psi = 0.7 L or r^3, p_j the monomials of degree <= 4, and
/// near a tip the functions cos t, sin t, t, cos 2t, sin 2t of the angle about it, cut along the crack: close to a tip
/// the field depends on the angle alone.

#include "visible/nodes.h"

enum { PDMC_STENCIL_NODES = 50, PDMC_STENCIL_MONOMIALS = 15, PDMC_STENCIL_ANGLES = 5 };
enum { PDMC_STENCIL_FUNCTIONS = PDMC_STENCIL_NODES + PDMC_STENCIL_MONOMIALS + PDMC_STENCIL_ANGLES };

typedef struct {
    int count;     // of nodes, <= PDMC_STENCIL_NODES
    int functions; // count, monomials, and the functions of the angle where there is a tip
    int node[PDMC_STENCIL_NODES];
    double place[2 * PDMC_STENCIL_NODES]; // [count, 2] (x_k - x_0) / L
    double centre[2], radius;             // x_0, L
    bool is_cubic;                        // phi = r^3
    const pdmc_cut *tip;                  // the crack whose tip is near, or NULL
    int end;                              // 1 its "to", -1 its "from"
    double *weights;                      // [count, functions] values of the functions at x to weights of the nodes
} pdmc_stencil;

/// What stencils are made of.
typedef struct {
    const pdmc_cuts *cuts; // that bound the view
    const pdmc_visible_nodes *nodes;
    bool is_cubic;
    bool without_ghosts; // of nodes of the plate alone
} pdmc_stencil_field;

/// @param[in]  node     round which
/// @param[out] stencil  free with pdmc_stencil_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_stencil_create(const pdmc_stencil_field *field, int node, pdmc_stencil *stencil);
void pdmc_stencil_clear(pdmc_stencil *stencil);

/// s(x) = sum_k weight_k u_k.
/// @param[out] weight  [count]
void pdmc_stencil_evaluate(const pdmc_stencil *stencil, const double x[2], double weight[PDMC_STENCIL_NODES]);

/// The derivatives of s.
/// @param[out] by_x, by_y  [count]
void pdmc_stencil_gradient(const pdmc_stencil *stencil, const double x[2], double by_x[PDMC_STENCIL_NODES],
                           double by_y[PDMC_STENCIL_NODES]);

/// The node nearest to a point among those that it sees; -1 if it sees none.
int pdmc_stencil_owner(const pdmc_stencil_field *field, const pdmc_view *from);
