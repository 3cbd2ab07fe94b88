// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "galerkin/neighbours.h"

/// The zero form whose entries are those of values in the corners of neighbours.
/// @param[out] form  free with pdmc_form_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_form_pattern(const pdmc_space *space, const pdmc_neighbours *neighbours,
                                             pdmc_form *form);

/// Adds to the product of two values, unless both are prescribed; a product of two different ones is added once.
void pdmc_form_add(pdmc_form *form, int i, int j, double value);
