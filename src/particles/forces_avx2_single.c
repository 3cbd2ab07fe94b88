// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL pdmc_forces_avx2_single
#include "particles/lanes_avx2_single.h"

#include "particles/by_displacement.h"
#include "particles/forces_kernel.h"
