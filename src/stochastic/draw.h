// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/affine.h"
#include "pdmc/problem.h"

/// The random quantities of one sample and what follows from them. With s the effective modulus of the sample's c(r) over
/// the mean's, K(c) = s K(c / s): the terms hold what is left of c(r) when it is divided by s, which is small whatever s
/// is, and the answer is x = K(xi)^-1 (F_0 + load_share sum_l load_pattern_l F_l), l >= 1.
typedef struct {
    double value[PDMC_SCALARS]; // of the scalar quantities, each in its unit; of a field that of the first tip
    double load_factor;         // on the tractions
    double load_share;          // load_factor over the modulus that was divided out
    double effective_modulus;   // E_eff / E, of c(r) and of E together
    double energy_factor;       // E / mean E, by which bonds are stiffer beyond their c(r)
    double *load_pattern;       // [model's cases] 0 for F_0, 1 for the loads as the problem gives them, then what is added
    double *micromodulus;       // [bins] c_b / c_0
    double *xi;                 // [terms]
    double *ring_weight;        // [energy rings] g_q
    double *tip_modulus;        // [tips] E_eff at the tip over the mean E
    double *direction_modulus;  // [tips, angles] of the bonds that cross there, beyond c(r), over the mean
    double *fracture_energy;    // [tips] force / length
} pdmc_draw;

/// s_l of the sample's right-hand side sum_l s_l F_l.
static inline double pdmc_draw_scale(const pdmc_draw *draw, int l)
{
    return l == 0 ? 1.0 : draw->load_share * draw->load_pattern[l];
}

/// Fills what follows from the scalars, c(r), and the field's coefficients, which are the terms beyond the radial ones.
/// @param[in,out] draw  value, fracture_energy, load_pattern, micromodulus and the field's xi are set; its arrays are the
///                      caller's
void pdmc_draw_complete(const pdmc_problem *problem, const pdmc_affine *model, pdmc_draw *draw);

/// The sample at which every quantity has its nominal value, and every function its mean.
void pdmc_draw_mean(const pdmc_problem *problem, const pdmc_affine *model, pdmc_draw *draw);
