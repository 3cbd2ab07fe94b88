// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Rows of the collocation system: linear functionals of the displacement, as coefficients of the basis' unknowns.

#include "kansa/basis.h"

/// Scratch for building rows; one for each thread.
typedef struct {
    const pdmc_basis *basis;
    pdmc_basis_values here, there; // at the centre and at a bond's end, or by x and by y
    double *xx, *xy, *yy;          // [scalars]
} pdmc_row_builder;

PDMC_NODISCARD pdmc_status pdmc_row_builder_create(const pdmc_basis *basis, pdmc_row_builder *builder);
void pdmc_row_builder_clear(pdmc_row_builder *builder);

/// The bonds of one length: F(r) = int_0^{2 pi} e e^T [u(x) - u(x + r e)] dtheta, with the crack fields continued
/// analytically, so that the trapezoidal rule converges geometrically.
/// @param[in]  clearance  distance from x to the nearest tip, > r
/// @param[out] row_x, row_y  [unknowns] the components of F
void pdmc_ring_rows(pdmc_row_builder *builder, const double x[2], double r, double clearance, double row_x[],
                    double row_y[]);

/// The local traction sigma(u) n with sigma_x = mu (3 u_x + v_y), sigma_y = mu (u_x + 3 v_y), tau = mu (u_y + v_x),
/// which is Hooke's law of a bond-based material (lambda = mu) in both plane assumptions.
void pdmc_traction_rows(pdmc_row_builder *builder, const double x[2], const double anchor[2], const double normal[2],
                        double row_x[], double row_y[]);

/// The displacement u, v.
void pdmc_displacement_rows(pdmc_row_builder *builder, const double x[2], const double anchor[2], double row_x[],
                            double row_y[]);
