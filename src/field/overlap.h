// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/base.h"

/// A rule for double integrals over an interval of length L, of polynomials and a kernel that is even in x - x':
///     integral integral k(x - x') p_m(x) p_m'(x') dx dx' = integral over [0, L] of k(r) o_mm'(r) dr,
///     o_mm'(r) = integral over [-L / 2, L / 2 - r] of p_m(x) p_m'(x + r) + p_m'(x) p_m(x + r) dx.
/// By reflection the two products have the same integral where m + m' is even, and opposite ones where it is odd: o
/// vanishes there; the rest is kept apart for even and odd m.
typedef struct {
    int degree, count;
    double *r;          // [count] separations, ascending in (0, L)
    double *overlap[2]; // of parity e: [n, n, count], n = (degree - e) / 2 + 1, o_mm' times the weight, m = e + 2 i
} pdmc_overlap;

/// The rule is composed of Gauss rules on panels that shrink geometrically towards r = 0, where a kernel may have a kink,
/// down to `finest`; away from it they are short enough for polynomials of this degree.
/// @param[out] overlap  free with pdmc_overlap_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_overlap_create(double length, int degree, double finest, pdmc_overlap *overlap);

/// A zeroed one is allowed.
void pdmc_overlap_clear(pdmc_overlap *overlap);

/// How many polynomials of this parity there are up to the degree.
int pdmc_parity_count(int degree, int parity);
