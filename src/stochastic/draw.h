// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/affine.h"
#include "pdmc/problem.h"

/// The random quantities of one sample and what is linear in them.
typedef struct {
    double load_factor, effective_modulus;
    double *micromodulus; // [bins] c_b / c_0
    double *xi;           // [terms]
    double *ring_weight;  // [energy rings] g_q
} pdmc_draw;

/// @param[in,out] draw  its arrays are the caller's
void pdmc_draw_sample(const pdmc_problem *problem, const pdmc_affine *model, uint64_t sample, pdmc_draw *draw);

/// The sample at which every quantity has its mean.
void pdmc_draw_mean(const pdmc_affine *model, pdmc_draw *draw);
