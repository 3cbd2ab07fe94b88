// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "random/random_impl.h"

#include <Random123/philox.h>

double pdmc_random_open_interval(uint64_t word)
{
    return ((double)(word >> 12) + 0.5) * 0x1p-52;
}

void pdmc_random_uniform(uint64_t seed, pdmc_stream stream, uint64_t sample, uint64_t first, size_t count, double u[])
{
    const philox4x64_key_t key = {{seed, (uint64_t)stream}};
    for (size_t i = 0; i < count; i++) {
        const philox4x64_ctr_t counter = {{sample, first + i, 0, 0}};
        u[i] = pdmc_random_open_interval(philox4x64(counter, key).v[0]);
    }
}
