// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"

#include <cblas.h>
#include <time.h>

void pdmc_blas_prepare(void)
{
    openblas_set_num_threads(1);
}

double pdmc_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
