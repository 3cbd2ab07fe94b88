// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/legendre.h"

void pdmc_paper_legendre(int count, double s, double value[])
{
    value[0] = 1.0;
    if (count > 1) value[1] = s;
    for (int p = 2; p < count; p++) value[p] = ((2 * p - 1) * s * value[p - 1] - (p - 1) * value[p - 2]) / p;
}
