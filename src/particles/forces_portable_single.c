// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL pdmc_forces_portable_single
#include "particles/lanes_portable_single.h"

#include "particles/by_displacement.h"
#include "particles/forces_kernel.h"
