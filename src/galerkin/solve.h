// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/galerkin.h"
#include "sparse/factor.h"

/// The factor of a form for the free values.
/// @param[out] factor  destroy with pdmc_sparse_factor_destroy()
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_form_factor(const pdmc_form *form, pdmc_sparse_factor **factor);
