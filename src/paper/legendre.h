// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// P_0(s) .. P_(count - 1)(s), count >= 1.
void pdmc_paper_legendre(int count, double s, double value[]);
