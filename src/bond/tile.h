// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Columns of a block that are worked on at a time, node by node, so that one instruction does the same for all of them.

#include "pdmc/affine.h"

enum { PDMC_BOND_TILE = 8 };

typedef double pdmc_bond_tile __attribute__((vector_size(PDMC_BOND_TILE * sizeof(double))));

// A version for processors with vectors as long as a tile, chosen when the library is loaded: twice as fast. It does
// the same operations in the same order, without contraction, so that the results do not depend on it. None for AVX2:
// gcc 12 splits tiles into its vectors through memory, which is slower than SSE2.
#if defined(__x86_64__) && defined(__gnu_linux__)
#define PDMC_BOND_LONGEST_VECTORS __attribute__((target_clones("default", "avx512f")))
#else
#define PDMC_BOND_LONGEST_VECTORS
#endif
