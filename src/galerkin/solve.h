// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/factor.h"
#include "pdmc/galerkin.h"

/// The factor of a form for the free values.
/// @param[out] factor  destroy with pdmc_bond_factor_destroy()
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_form_factor(const pdmc_form *form, pdmc_bond_factor **factor);
