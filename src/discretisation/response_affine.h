// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The affine model of a method whose unknowns are displacements of nodes, u_0, v_0, u_1, v_1, ..: its coordinates y are those of
/// the response space, u = basis^T y.

#include "pdmc/affine.h"
#include "pdmc/problem.h"

enum { PDMC_POINT_NODES = 64 }; // of which the displacement at a point is made, at most

/// What a method gives: its operators K_0 and K_q, its loads F_l, and its mean solutions. It must outlive the model.
typedef struct {
    const pdmc_problem *problem;
    int unknowns, cases, threads;
    const double *solution; // [cases, unknowns] K_0^-1 F_l
    const void *method;
    /// out = K_0^-1 K_q v; called by several threads at once.
    pdmc_status (*apply)(const void *method, int q, const double v[], double out[]);
    /// u = (K_0 + sum_q xi_q K_q)^-1 sum_l scale_l F_l
    pdmc_status (*solve)(const void *method, const double xi[], const double scale[], double u[]);
    /// Adds the rows of K_I and K_II of a tip, [unknowns] each.
    pdmc_status (*intensity)(const void *method, int tip, double row_1[], double row_2[]);
    /// The displacement at a point that is on no crack, sum_k weight[k] u_node[k]; returns how many nodes it has.
    int (*point)(const void *method, const double x[2], int node[PDMC_POINT_NODES], double weight[PDMC_POINT_NODES]);
} pdmc_nodal_method;

/// Fills a model whose tips, angles, bins, terms and weights are known.
/// @param[in]     size   [terms] of the coefficients that are to be expected
/// @param[in,out] model  what was made is freed by pdmc_affine_clear(), after a failure as well
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or the failure of the method
PDMC_NODISCARD pdmc_status pdmc_response_affine(const pdmc_nodal_method *nodal, const double size[],
                                                pdmc_affine *model);
