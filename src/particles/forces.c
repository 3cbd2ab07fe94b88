// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/forces.h"

pdmc_forces_kernel *pdmc_forces_choose(const char **name)
{
#ifdef PDMC_HAVE_X86
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
        *name = "avx512";
        return pdmc_forces_avx512;
    }
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        *name = "avx2";
        return pdmc_forces_avx2;
    }
#endif
    *name = "portable";
    return pdmc_forces_portable;
}
