// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "galerkin/assembly.h"

struct pdmc_law_bonds {
    pdmc_bond_law law;
    pdmc_scalar_kernel kernel;
    pdmc_assembly assembly;
};
