// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/lanes_avx512_two.h"

#include "particles/by_displacement.h"
#include "particles/forces_sum.h"

pdmc_alarms pdmc_forces_avx512_single_two(const pdmc_forces *f, int b, bool by_node, bool varied)
{
    if (varied) return find_forces(f, b, (bond_kind){.by_node = true, .varied = true});
    if (by_node) return find_forces(f, b, (bond_kind){.by_node = true});
    return find_forces(f, b, (bond_kind){0});
}
