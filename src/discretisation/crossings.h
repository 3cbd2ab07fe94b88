// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/affine.h"
#include "pdmc/problem.h"

/// The displacement of a discretisation as rows over its unknowns.
typedef struct {
    int unknowns;
    const void *method;
    /// Makes the scratch of one thread; close() takes NULL and what a failed open() has left.
    pdmc_status (*open)(const void *method, void **context);
    /// Writes every entry of the rows of u(x) and v(x), [unknowns] each.
    void (*rows)(void *context, const double x[2], double row_u[], double row_v[]);
    void (*close)(void *context);
} pdmc_displacement_functional;

/// Fills the model's micromodulus, rings and crossings: the stretch of every bond that crosses a potential
/// fracture line, as a functional of the model's coordinates; none where Griffith's measure alone is wanted. Needs
/// model->unknowns, bins, tips and angles.
/// @param[in]     coefficients  [model->unknowns, displacement->unknowns] the field of each coordinate
/// @param[in,out] model         what was made is freed by pdmc_affine_clear(), after a failure as well
/// @return PDMC_OK, PDMC_ERR_NOMEM, or the failure of open()
PDMC_NODISCARD pdmc_status pdmc_affine_fill_crossings(const pdmc_problem *problem,
                                                      const pdmc_displacement_functional *displacement,
                                                      const double coefficients[], int threads, pdmc_affine *model);
