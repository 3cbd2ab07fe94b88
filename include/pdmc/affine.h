// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// An affine model, what every discretisation gives to the stochastic solvers:
///     K(xi) x = sum_l s_l F_l,   K(xi) = K_0 + sum_m xi_m K_m,
/// F_0 the held displacements, F_1 the loads as the problem gives them, the others what may be added to these where loads
/// vary by themselves; x in coordinates of the discretisation's choice. The first coefficients xi, the
/// effective modulus and the weights of the energy are linear in the relative deviations eta_b = c_b / c_0 - 1 of the
/// micromodulus in its bins; the other coefficients are those of a stiffness that varies in space.

#include "pdmc/field.h"

typedef struct pdmc_affine pdmc_affine;

/// How the models of other plates are made, for samples whose cracks have a place of their own. Each is made on the
/// thread that asks for it.
typedef struct {
    int threads; // that samples are shared out to, >= 1
    const void *context;
    /// @param[in]  value  of the scalar quantities, as many as the problem has
    /// @param[in]  measure_alone  whether the model may leave out what the problem's measure does not need
    /// @param[out] model  of that plate, without a family
    /// @param[out] plate  what the model needs; both are freed by release(), whatever is returned
    /// @return PDMC_OK, PDMC_ERR_NOMEM, or another status where there is no such plate or no model of it
    pdmc_status (*make)(const void *context, const double value[], bool measure_alone, pdmc_affine *model,
                        void **plate);
    void (*release)(pdmc_affine *model, void *plate);
} pdmc_affine_family;

/// Columns of every block that the verbs work on. A constant: the order of summation inside a matrix product depends on
/// the shape of the block, and so would the last bits of the results.
enum { PDMC_BLOCK = 64 };

/// The verbs of a discretisation. They may be called from several threads at once.
typedef struct {
    /// Y = K_0^-1 (sum_m xi_m K_m) X, column by column.
    /// @param[in]  xi  [PDMC_BLOCK, terms]
    /// @param[in]  x   [PDMC_BLOCK, unknowns]
    /// @param[out] y   [PDMC_BLOCK, unknowns]
    pdmc_status (*perturb)(const pdmc_affine *model, const double xi[], const double x[], double y[]);

    /// Solves K(xi) x = sum_l s_l F_l by its own factorisation.
    /// @param[in]  scale  [cases] s
    /// @param[out] x      [unknowns]
    /// @return PDMC_OK, PDMC_ERR_SINGULAR, or PDMC_ERR_NOMEM
    pdmc_status (*solve)(const pdmc_affine *model, const double xi[], const double scale[], double x[]);

    /// Y = (mean K_0 + sum_m xi_m K_m) X and Z = K_0^-1 R, column by column, where K is symmetric positive definite on the
    /// unknowns that are not held; NULL elsewhere. Held unknowns of Y are 0, and so are those of Z where R has a 0. The last
    /// bits of Z may depend on its number of columns.
    /// @param[in]  mean    1, or 0 for the terms alone
    /// @param[in]  xi      [PDMC_BLOCK, terms]
    /// @param[in]  count   columns of R and Z, 1 <= count <= PDMC_BLOCK
    /// @param      x y     [PDMC_BLOCK, unknowns], not overlapping
    /// @param      r z     [count, unknowns], not overlapping
    pdmc_status (*multiply)(const pdmc_affine *model, double mean, const double xi[], const double x[], double y[]);
    pdmc_status (*precondition)(const pdmc_affine *model, int count, const double r[], double z[]);

    /// Z = K_0^-1/2 G, a root for which the covariance of Z is K_0^-1 where that of G is the identity; on the unknowns that
    /// are not held, 0 on those.
    /// @param[in]  g  [PDMC_BLOCK, unknowns]
    /// @param[out] z  [PDMC_BLOCK, unknowns]
    pdmc_status (*color)(const pdmc_affine *model, const double g[], double z[]);

    /// u_i' K_m v_j for every term m, where that is cheaper for all terms at once than multiply; NULL elsewhere.
    /// @param[in]  u    [u_count, unknowns]
    /// @param[in]  v    [v_count, unknowns]
    /// @param[out] out  [terms, u_count, v_count]
    pdmc_status (*project)(const pdmc_affine *model, int u_count, const double u[], int v_count, const double v[],
                           double out[]);

    /// alpha of each column for which K(xi) >= alpha K_0, K symmetric; NULL where every K_m is positive semi-definite and
    /// their sum at most K_0, so that the smallest of 1 and 1 + xi_m is one.
    /// @param[in]  xi     [PDMC_BLOCK, terms]
    /// @param[out] alpha  [PDMC_BLOCK]
    pdmc_status (*coercivity)(const pdmc_affine *model, const double xi[], double alpha[]);

    /// Frees `discretisation`.
    void (*destroy)(void *discretisation);
} pdmc_affine_verbs;

/// The energy release rate at one point of a circle round a tip in factored form:
///     G = 1/2 c_0 sum_q g_q sum_{bonds b of ring q} (row_b . x)^2,   g_q = sum_bins (c_bin / c_0)
/// ring_weight[bin][q]. The sign of row_b . x is that of the bond's stretch. The rows are full, over the unknowns or over
/// what is observed of them, or have PDMC_BOND_ENDS values each: the displacements of the two nodes that a bond connects,
/// among the unknowns or among the observed displacements.
typedef struct {
    int bonds;
    double *row; // [bonds, observed or unknowns], or [bonds, PDMC_BOND_ENDS] where there are columns
    int *column; // [bonds, PDMC_BOND_ENDS], or NULL
    int *ring;   // [bonds]
} pdmc_crossing;

enum { PDMC_BOND_ENDS = 4 };

struct pdmc_affine {
    const pdmc_affine_family *family; // the caller's; NULL where every sample has the model's own plate
    int unknowns, terms, bins;
    int cases; // of the loads, >= 2
    /// The first of the terms are those of c(r). Where the model has none although there are bins, c(r) acts by the
    /// effective modulus alone: K(xi) = (E_eff / E) (K_0 + sum_m xi_m K_m).
    int radial_terms;
    double *term_weight;    // [bins, radial_terms] xi_m = sum_b eta_b term_weight[b][m]
    double *modulus_weight; // [bins] E_eff / E = 1 + sum_b eta_b modulus_weight[b]
    double *solution;       // [cases, unknowns] K_0^-1 F_l

    /// The stiffness in space, whose coefficients are the other terms; NULL where it is the same everywhere. It belongs to
    /// the discretisation.
    const pdmc_field *field;
    double *tip_stiffness;       // [tips, field terms] psi_k at the tip
    double *direction_stiffness; // [tips, angles, field terms] psi_k where the energy's bonds cross

    int tips, angles;
    double *stress_intensity; // [2 tips, unknowns] rows of K_I, K_II of each tip at E_eff = E
    double micromodulus;      // c_0 at the horizon of the energy, force / length^5
    int rings;
    double *ring_weight;      // [bins, rings]
    pdmc_crossing *crossings; // [tips, angles]
    /// |sqrt G(x + e) - sqrt G(x)| <= crossing_bound |e|, |e|^2 = e' K(xi) e, in every direction; 0 where that is not known.
    /// Where there is a field, |e|^2 = e' K_0 e, at stiffness 1 and the mean c(r).
    double crossing_bound;
    double *intensity_bound; // [2 tips] |row e| <= intensity_bound sqrt(e' K_0 e) of the stress intensities, or NULL
    int observed;            // number of displacements that the crossings look at; 0: they look at the unknowns
    double *observe;         // [observed, unknowns]

    const pdmc_affine_verbs *verbs;
    void *discretisation;
    double operator_seconds, energy_seconds; // wall time of making the operators and the crossings
};

/// K_0^-1 F_l.
static inline const double *pdmc_affine_solution(const pdmc_affine *model, int l)
{
    return &model->solution[(size_t)l * (size_t)model->unknowns];
}

/// A zeroed model is allowed.
PDMC_API void pdmc_affine_clear(pdmc_affine *model);
