// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A random micromodulus c(r) = c_0 (1 + eta(r)) for operators whose integrands are not smooth in r: eta, constant in
/// each of equal bins of [0, delta], expanded in P_p(2 r / delta - 1), p < terms.

#include "pdmc/affine.h"

/// P_0(s) .. P_(count - 1)(s), count >= 1.
void pdmc_radial_legendre(int count, double s, double value[]);

/// Makes the model's term_weight, the Legendre coefficients xi_p = (2 p + 1) / 2 int_-1^1 eta P_p ds of the bins, and
/// its modulus_weight, E_eff = (pi / 3) int c r^2 dr. Needs model->bins and terms.
PDMC_NODISCARD pdmc_status pdmc_radial_weights(pdmc_affine *model);

/// The size that is to be expected of each coefficient: five standard deviations.
/// @param[in]  variation  coefficient of variation of c in a bin
/// @param[out] size       [terms]
void pdmc_radial_sizes(const pdmc_affine *model, double variation, double size[]);
