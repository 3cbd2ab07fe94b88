// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// The weak form of the plate in coordinates z in which the mean's is the identity: y = R x, K_0 = L L' in y, z = L' y.
/// K_0 holds the strain energy, the penalty on prescribed displacements, and the mean of each rigid motion that nothing
/// holds; of these the strain energy alone is proportional to the stiffness.
struct pdmc_kansa_form {
    const pdmc_kansa *kansa;
    int unknowns, points;
    double *x;         // [points, 2] of a rule over the plate
    double *strain;    // [points, PDMC_STRAIN_ROWS, unknowns] in z; squares add to w sigma : epsilon
    double *root;      // [unknowns, unknowns] L, column-major, lower triangle
    double *fixed;     // [unknowns] of prescribed displacements, in z: K_0^-1 F is the same
    double *load;      // [cases of the loads, unknowns] of tractions, in z
    double *intensity; // [2 tips, unknowns] rows of K_I and K_II of the problem's tips, where the stiffness is E
    pdmc_field_functional *sensitivity; // [tips]
};

/// Turns rows of functionals of y into functionals of z, in place, by fixed panels of rows.
/// @param[in,out] row  [count, unknowns]
void pdmc_kansa_form_transform(const pdmc_kansa_form *form, int count, double row[]);

/// e = strain rows of `points` points from `first` on times `count` vectors.
/// @param[in]  v  [count, unknowns]
/// @param[out] e  [points, PDMC_STRAIN_ROWS, count]
void pdmc_kansa_form_strains(const pdmc_kansa_form *form, int first, int points, int count, const double v[],
                             double e[]);

/// Adds to the lower triangle of a stiffness the mean of each rigid motion that nothing holds.
PDMC_NODISCARD pdmc_status pdmc_kansa_form_add_gauge(const pdmc_kansa *kansa, double stiffness[]);

/// What d ln G of each of the problem's tips is of d ln M.
PDMC_NODISCARD pdmc_status pdmc_kansa_form_find_sensitivity(pdmc_kansa_form *form);
