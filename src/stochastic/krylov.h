// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/affine.h"

/// Solves K(xi) x = f for a block by conjugate gradients (Hestenes & Stiefel 1952), preconditioned by the mean operator
/// and begun at the mean's answer. Each column stops by itself, so that its result does not depend on its neighbours in
/// the block: when its residual r, in the norm r' K_0^-1 r, is below `tolerance` times the larger of that of the first
/// residual and that of the load; or after 200 steps; or where K turns out not to be positive (p' K p <= 0).
/// @param[in]     xi        [PDMC_BLOCK, terms]
/// @param[in,out] x         [PDMC_BLOCK, unknowns] K_0^-1 f, then the solution
/// @param[out]    residual  [PDMC_BLOCK] relative to the same, as it was reached; NaN where K is not positive
/// @return PDMC_OK, PDMC_ERR_NOMEM, or the failure of a verb
PDMC_NODISCARD pdmc_status pdmc_krylov_solve(const pdmc_affine *model, const double xi[], double tolerance, double x[],
                                             double residual[PDMC_BLOCK]);
