// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL pdmc_forces_avx2
#include "particles/lanes_avx2.h"

#include "particles/by_position.h"
#include "particles/forces_kernel.h"
