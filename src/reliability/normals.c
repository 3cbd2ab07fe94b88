// SPDX-License-Identifier: GPL-3.0-or-later
#include "reliability/normals.h"

void pdmc_random_normal(uint64_t seed, pdmc_stream stream, uint64_t sample, uint64_t first, int count, double z[])
{
    pdmc_random_uniform(seed, stream, sample, first, (size_t)count, z);
    for (int i = 0; i < count; i++) z[i] = pdmc_normal_quantile(z[i]);
}
