// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The recipe of Evangelatos & Spanos (2011), sections 3 to 5 with appendices A and B, for the record. It does not
/// converge; README.md says what was measured.
///
/// Square system, rows in units of stress (force densities times the horizon):
///     horizon K x = horizon b   at every node, two rows (eq. 30, 33, 34 over the cut disc; b = traction / e on loaded sides)
///     sum_k q_j(x_k) a_1k = 0   and the same for d_1k, for every q_j (eq. B.2, corrected)
///     sum_k motion . u(x_k) = 0 for every rigid motion that nothing holds
/// A displacement that is held takes the place of its node's row. The last unknowns are as many: uniform force densities and
/// a torque that take up what the collocation leaves out of balance, without which the square system with free rigid motions
/// has no solution. They are zero where symmetry balances the loads, and are the model's residual elsewhere.
/// Unknowns: a_1k, a_2j (u), d_1k, d_2j (v), balance.

#include "paper/basis.h"
#include "pdmc/discretisation.h"
#include "pdmc/load_cases.h"

enum { PDMC_PAPER_TERMS = 11 }; // Legendre polynomials of the radius that a random c(r) is expanded in

typedef struct {
    const pdmc_problem *problem;
    int threads;
    pdmc_paper_basis basis;
    int motions;
    double motion[3][3];
    int unknowns, rows_of_nodes; // rows_of_nodes = 2 nodes
    int terms;                   // PDMC_PAPER_TERMS with a random c(r), else 1
    double *matrix;              // [unknowns, unknowns] of the mean
    double *term; // [terms, rows_of_nodes, unknowns] K_p: rows weighted by P_p(2 r / horizon - 1); NULL if c is certain
    double *factor;       // [unknowns, unknowns] LU of the transposed matrix with scaled rows, column-major
    int *pivot;           // [unknowns]
    double *scale;        // [unknowns] of the unknowns in the factor
    pdmc_load_cases loads;
    int cases;            // 1 + those of the loads
    double *load;         // [cases, unknowns] F_l
    double *coefficients; // [unknowns] at the mean
    double condition, residual;
    double assembly_seconds, factorisation_seconds;
} pdmc_paper;

/// Fills matrix, term and load.
PDMC_NODISCARD pdmc_status pdmc_paper_assemble(pdmc_paper *paper);

/// Replaces right-hand sides by the solutions of the mean system.
/// @param[in,out] v  [count, unknowns]
PDMC_NODISCARD pdmc_status pdmc_paper_solve(const pdmc_paper *paper, int count, double v[]);

/// Discretises a problem and solves for its mean loads.
/// @param[in]  problem  kept by reference: it must outlive the model
/// @param[out] paper    destroy with pdmc_paper_destroy()
/// @return PDMC_OK, PDMC_ERR_CONFIG (loads out of equilibrium), PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_paper_create(const pdmc_problem *problem, int threads, pdmc_paper **paper);

/// NULL is allowed; sets the pointer to NULL.
void pdmc_paper_destroy(pdmc_paper **paper);

/// The mean displacement at x; see pdmc_discretisation_verbs.
PDMC_NODISCARD pdmc_status pdmc_paper_displacement(const pdmc_paper *paper, const double x[2], const double anchor[2],
                                                   double u[2]);

/// K_I and K_II of a tip as functionals of the unknowns, from the opening of the crack: the intercept of
/// E' / 8 sqrt(2 pi / r) [u] over r, fitted by a straight line to 19 points from 0.02 to 0.2 of the half length.
/// @param[out] row_1, row_2  [unknowns] zero on entry
PDMC_NODISCARD pdmc_status pdmc_paper_stress_intensity_rows(const pdmc_paper *paper, int tip, double row_1[],
                                                            double row_2[]);

/// Name, position, direction, K_I and K_II of a tip; T is NaN: the model has no stress.
PDMC_NODISCARD pdmc_status pdmc_paper_tip(const pdmc_paper *paper, int tip, pdmc_tip *out);

/// The affine model of the problem's uncertain quantities: c(r) = c_0 (1 + sum_p xi_p P_p(2 r / horizon - 1)), xi_p the
/// Legendre coefficients of the deviation in its bins. Of many bins only what PDMC_PAPER_TERMS polynomials hold is seen.
/// @param[in]  paper  must outlive the model
/// @param[out] model  free with pdmc_affine_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_paper_affine(const pdmc_paper *paper, pdmc_affine *model);
