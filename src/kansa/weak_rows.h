// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// What integrals over the plate are made of: rows at the points of a rule, as functionals of y = R x. A point's weight is
/// in its rows, so that the form is the sum of their squares.

enum {
    PDMC_STRAIN_ROWS = 3,       // squares add to sigma : epsilon
    PDMC_DISPLACEMENT_ROWS = 2, // squares add to u . u
};

/// A rule that resolves the trial functions, graded to the tips.
/// @param[out] rule  free with pdmc_area_rule_clear()
PDMC_NODISCARD pdmc_status pdmc_weak_rule(const pdmc_kansa *kansa, pdmc_area_rule *rule);

/// Rows of the rule's points first .. first + count - 1.
/// @param[out] strain        [count, PDMC_STRAIN_ROWS, unknowns]
/// @param[out] displacement  [count, PDMC_DISPLACEMENT_ROWS, unknowns], or NULL
PDMC_NODISCARD pdmc_status pdmc_weak_fill_rows(const pdmc_kansa *kansa, const pdmc_area_rule *rule, int first,
                                               int count, double strain[], double displacement[]);

/// gram += rows^T rows, by panels of columns.
/// @param[in]     rows  [count, unknowns]
/// @param[in,out] gram  [unknowns, unknowns]
void pdmc_weak_add_gram(const pdmc_kansa *kansa, int count, const double rows[], double gram[]);
