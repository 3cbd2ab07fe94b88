// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/basis.h"
#include "kansa/points.h"
#include "kansa/rows.h"
#include "pdmc/kansa.h"
#include "pdmc/load_cases.h"
#include "pdmc/quadrature.h"

/// The assembled and factored mean system A_0 x = F, A_0 [rows, unknowns], A_0 = Q R.
struct pdmc_kansa {
    const pdmc_problem *problem;
    int threads;
    double spacing;
    pdmc_basis basis;
    pdmc_collocation points;
    pdmc_ring_rule rings;
    int rows, unknowns, rank;
    double *ring_rows;            // [rings, 2 interior, unknowns] c_0 spacing F(r_q), without the ring's weight
    bool *is_traction;            // [2 boundary] row scales with the effective modulus
    double share[PDMC_MAX_RINGS]; // E_eff / E = sum_q w_q share_q for weights w of the rings
    double *q;                    // [unknowns columns of rows] orthonormal
    double *r;                    // [unknowns, unknowns] column-major, upper triangle
    pdmc_load_cases loads;
    int cases;                    // 1 + those of the loads
    double *load;                 // [cases, rows] F_l
    double *whitened;             // [cases, unknowns] Q^T F_l
    double *coefficients;         // [unknowns] of the basis, at the mean loads
    double condition, residual;
    double assembly_seconds, factorisation_seconds;
};

/// Turns rows of functionals of the basis' coefficients into functionals of y = R x, in place.
/// @param[in,out] row  [count, unknowns]
void pdmc_kansa_whiten(const pdmc_kansa *kansa, int count, double row[]);

/// The basis' coefficients that belong to vectors y, in place.
/// @param[in,out] v  [count, unknowns]
void pdmc_kansa_unwhiten(const pdmc_kansa *kansa, int count, double v[]);

/// K_I and K_II of a tip as functionals of the basis' coefficients, at the mean effective modulus.
/// @param[out] row_1, row_2  [unknowns] zero on entry
void pdmc_kansa_stress_intensity_rows(const pdmc_kansa *kansa, int tip, double row_1[], double row_2[]);
