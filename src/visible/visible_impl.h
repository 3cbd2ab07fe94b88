// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/load_cases.h"
#include "visible/disc.h"
#include "visible/factor.h"
#include "visible/stencil.h"
#include "visible/visible.h"

/// The two equations of a node: blocks of 2 x 2, row-major, at the nodes in `column`.
typedef struct {
    int count;
    int *column;   // [count]
    double *value; // [planes, count, 4]
} pdmc_block_row;

/// K(xi) x = F for x = (u of the nodes, multipliers of the rigid motions), K = plane 0 + sum_p xi_p plane 1 + p.
struct pdmc_visible {
    const pdmc_problem *problem;
    pdmc_visible_data data;
    int threads;
    pdmc_cuts cuts;
    pdmc_cuts none; // what blind stencils see
    pdmc_visible_nodes nodes;
    pdmc_stencil_field field;
    pdmc_stencil *stencils; // [nodes]
    int terms;              // of a random micromodulus: planes - 1
    double micromodulus;    // c_0
    pdmc_block_row *rows;   // [nodes] in units of stress
    int motions;
    double motion[3][3];
    int unknowns;        // 2 nodes
    pdmc_factor factor;  // of K_0
    pdmc_load_cases loads;
    int cases;           // 1 + those of the loads
    double *load;        // [cases, unknowns] F_l
    double *solution;    // [cases, unknowns] K_0^-1 F_l
    double *mean;        // [unknowns] their sum
    double residual;
    double assembly_seconds, factorisation_seconds;
};
