// SPDX-License-Identifier: GPL-3.0-or-later
#include <pdmc/base.h>
#include <pdmc/random.h>

#include <stdio.h>

int main(void)
{
    double u;
    pdmc_random_uniform(0, PDMC_STREAM_LOAD, 0, 0, 1, &u);
    return printf("%s\n", pdmc_version()) > 0 && 0.0 < u && u < 1.0 ? 0 : 1;
}
