// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL pdmc_forces_avx512_single
#define KERNEL_OF_TWO pdmc_forces_avx512_single_two
#include "particles/lanes_avx512_single.h"

#include "particles/by_displacement.h"
#include "particles/forces_kernel.h"
