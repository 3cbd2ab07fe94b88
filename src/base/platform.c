// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"

#include <cblas.h>
#include <omp.h>
#include <time.h>

void pdmc_blas_prepare(void)
{
    const int threads = omp_get_max_threads(); // of the caller, which OpenBLAS sets as well
    openblas_set_num_threads(1);
    omp_set_num_threads(threads);
}

double pdmc_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
