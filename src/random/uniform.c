// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "random/random_impl.h"

#include <Random123/philox.h>

double pdmc_random_open_interval(uint64_t word)
{
    return ((double)(word >> 12) + 0.5) * 0x1p-52;
}

pdmc_random_block pdmc_random_words(uint64_t seed, pdmc_stream stream, const uint64_t counter[4])
{
    const philox4x64_key_t key = {{seed, (uint64_t)stream}};
    const philox4x64_ctr_t place = {{counter[0], counter[1], counter[2], counter[3]}};
    const philox4x64_ctr_t block = philox4x64(place, key);
    return (pdmc_random_block){{block.v[0], block.v[1], block.v[2], block.v[3]}};
}

void pdmc_random_uniform(uint64_t seed, pdmc_stream stream, uint64_t sample, uint64_t first, size_t count, double u[])
{
    for (size_t i = 0; i < count; i++)
        u[i] =
            pdmc_random_open_interval(pdmc_random_words(seed, stream, (uint64_t[4]){sample, first + i, 0, 0}).word[0]);
}
