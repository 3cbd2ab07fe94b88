// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How bonds of one law differ: by factors at their nodes, by strengths of their own, and where they are between bodies.

#include "particles/forces.h"

typedef struct {
    double *stiffness;         // [cells] factors of c; NULL: all 1
    double *first_strength;    // [cells] s_00; NULL: those of the laws
    double *relative_strength; // [cells] s_00 over that of the law, where bodies have bonds; NULL: all 1
    pdmc_joints joints;        // of bodies
    double *strengths;         // [materials, PDMC_STRENGTH_CLASSES] to which the laws point; NULL: none has any
    pdmc_hash_key key;         // of their hash
} pdmc_variation;

/// @param[in,out] laws       [materials] that get their strengths, which belong to the variation
/// @param[in,out] variation  that has the joints; clear with pdmc_variation_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_ARG where factors are of another number of nodes, or not positive; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_variation_create(const pdmc_particles_options *options, const pdmc_nodes *nodes,
                                                 pdmc_brittle_law laws[], pdmc_variation *variation);
void pdmc_variation_clear(pdmc_variation *variation);

/// c of the bond between two cells: that of the law or of the bodies' joint, by the mean of the nodes' factors, and larger along
/// fibres. @param[in] law  of the first cell's node
double pdmc_variation_micromodulus(const pdmc_variation *variation, const pdmc_nodes *nodes, const pdmc_brittle_law *law,
                                   size_t cell, size_t other);
