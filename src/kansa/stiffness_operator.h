// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/stiffness_form.h"

/// Functions of the plate in which the stiffness is expanded, M(x) = 1 + sum_k xi_k psi_k(x).
typedef struct {
    int terms;
    const void *context;
    /// @param[in]  x      [points, 2]
    /// @param[out] value  [points, terms] psi
    pdmc_status (*at)(const void *context, int points, const double x[], double value[]);
} pdmc_stiffness_terms;

/// The terms of a random field, which must outlive them.
pdmc_stiffness_terms pdmc_stiffness_terms_of(const pdmc_field *field);

/// The affine model of a stiffness of any terms; the form must outlive it. The model's field is not set.
/// @param[out] model  free with pdmc_affine_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_kansa_form_affine(const pdmc_kansa_form *form, const pdmc_stiffness_terms *terms,
                                                  pdmc_affine *model);

/// Sets the model's unknowns, terms, verbs and discretisation.
PDMC_NODISCARD pdmc_status pdmc_stiffness_operator_create(const pdmc_kansa_form *form,
                                                          const pdmc_stiffness_terms *terms, pdmc_affine *model);

/// Fills the model's crossings, in what displacements near the tips observe of the coordinates, and their bound.
PDMC_NODISCARD pdmc_status pdmc_kansa_form_crossings(const pdmc_kansa_form *form, pdmc_affine *model);
