// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stochastic/draw.h"

/// Bond energies as quadratic forms of what full rows look at, y: the unknowns, or what is observed of them,
///     G_d = 1/2 c_0 M_d sum_q g_q y' A_dq y,   A_dq = sum of row_b row_b' over the bonds of ring q,
/// so that those of a block in all directions are one matrix product, of the forms and the features g_q y_i y_j. All bonds
/// count, in tension or not.
///
/// Pairs (i, j) that do not matter are left out: with m_i four times the largest |y_i| / |y| of pilot samples, they add at most
/// 1e-14 of the energy to any direction, in all, at the mean c(r) and as long as |y_i| <= m_i |y|.
typedef struct {
    int width, directions, rings, pairs; // width: of y
    int *first, *second;                 // [pairs] i and j
    double *most;                        // [width] m_i
    double *form;                        // [directions, pairs, rings]; twice A_dq where i and j differ
    double micromodulus;                 // c_0
} pdmc_energy_forms;

/// @param[in]  pilots  number of samples, >= 1
/// @param[in]  y       [pilots, width] of the model's unknowns, or of what it observes
/// @param[out] forms   NULL where there is nothing to gain: the rows are sparse, or the forms have more numbers than they
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_energy_forms_create(const pdmc_affine *model, int pilots, const double y[],
                                                    pdmc_energy_forms **forms);
void pdmc_energy_forms_destroy(pdmc_energy_forms **forms);

/// Numbers of scratch that the energies of a block take.
size_t pdmc_energy_forms_scratch(const pdmc_energy_forms *forms);

/// Whether the pairs that are left out do not matter to a sample.
/// @param[in] y  [width]
bool pdmc_energy_forms_hold(const pdmc_energy_forms *forms, const double y[]);

/// The energies of a block, force / length.
/// @param[in]  draw     [PDMC_BLOCK]
/// @param[in]  y        [PDMC_BLOCK, width]
/// @param      scratch  [pdmc_energy_forms_scratch()]
/// @param[out] energy   [directions, PDMC_BLOCK]
void pdmc_energy_forms_evaluate(const pdmc_energy_forms *forms, const pdmc_draw draw[], const double y[],
                                double scratch[], double energy[]);
