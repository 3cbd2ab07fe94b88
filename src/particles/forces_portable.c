// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL pdmc_forces_portable
#include "particles/lanes_portable.h"

#include "particles/by_position.h"
#include "particles/forces_kernel.h"
