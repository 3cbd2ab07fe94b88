// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// The weak form in the trial functions of the collocation, in coordinates y = R x. Matrices are [unknowns, unknowns],
/// symmetric, both triangles.
typedef struct {
    double *mass;      // int u . u at density 1
    double *stiffness; // int sigma : epsilon, plus the penalty on prescribed displacements
    double *fixed;     // [unknowns] what prescribed displacements do
    double *load;      // [cases of the loads, unknowns] int over the sides t . u
} pdmc_weak_form;

/// The plate and its sides.
PDMC_NODISCARD pdmc_status pdmc_weak_form_create(const pdmc_kansa *kansa, pdmc_weak_form *form);

/// Adds what happens on the sides: the penalty to the stiffness, prescribed displacements, and tractions.
PDMC_NODISCARD pdmc_status pdmc_weak_form_add_sides(const pdmc_kansa *kansa, pdmc_weak_form *form);

void pdmc_weak_form_clear(pdmc_weak_form *form);
