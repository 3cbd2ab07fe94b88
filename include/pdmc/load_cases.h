// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The loads of a problem by cases, of which every sample has a linear combination: the tractions as the problem gives them,
/// and, only where a side's load varies by itself, what is added to them. On a side with the traction t, a factor f, turned
/// by theta, and with the noise sum_k z_k psi_k along it, the traction is
///     t + (f cos theta - 1) t + f sin theta R t + sum_k f z_k psi_k t,
/// R a quarter turn counter-clockwise.

#include "pdmc/problem.h"

typedef enum {
    PDMC_LOAD_GIVEN,  // all tractions: t
    PDMC_LOAD_SIDE,   // of one side: t
    PDMC_LOAD_TURNED, // of one side: R t
    PDMC_LOAD_NOISE   // of one side: psi_k t
} pdmc_load_kind;

typedef struct {
    pdmc_load_kind kind;
    pdmc_side side;
    int mode; // k of the noise
} pdmc_load_case;

typedef struct {
    const pdmc_problem *problem;
    int count;                       // >= 1; the first is PDMC_LOAD_GIVEN
    pdmc_load_case *list;            // [count]
    pdmc_process *noise[PDMC_SIDES]; // with v in psi; NULL where there is none
} pdmc_load_cases;

/// How many cases a problem has.
PDMC_API int pdmc_load_case_count(const pdmc_problem *problem);

/// @param[out] list  [pdmc_load_case_count()]
PDMC_API void pdmc_load_case_list(const pdmc_problem *problem, pdmc_load_case list[]);

/// @param[in]  problem  kept by reference
/// @param[out] cases    free with pdmc_load_cases_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG (for more modes than can be resolved), PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_load_cases_create(const pdmc_problem *problem, pdmc_load_cases *cases);

/// A zeroed list is allowed.
PDMC_API void pdmc_load_cases_clear(pdmc_load_cases *cases);

/// The traction of a case at a point of a side; force / length^2.
/// @param[in] x  of which the coordinate along the side counts
PDMC_API void pdmc_load_traction(const pdmc_load_cases *cases, int index, pdmc_side side, const double x[2],
                                 double traction[2]);
