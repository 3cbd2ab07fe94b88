// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL pdmc_forces_avx512
#include "particles/lanes_avx512.h"

#include "particles/by_position.h"
#include "particles/forces_kernel.h"
