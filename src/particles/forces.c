// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/forces.h"

pdmc_forces_kernels pdmc_forces_choose(void)
{
#ifdef PDMC_HAVE_X86
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return (pdmc_forces_kernels){"avx512", pdmc_forces_avx512, pdmc_forces_avx512_single};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return (pdmc_forces_kernels){"avx2", pdmc_forces_avx2, pdmc_forces_avx2_single};
#endif
    return (pdmc_forces_kernels){"portable", pdmc_forces_portable, pdmc_forces_portable_single};
}
