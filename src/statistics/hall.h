// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The T of which Hall's T + a T^2 / 3 + a^2 T^3 / 27 + a / 6 is y: this function of Student's T is nearly free of its
/// skewness (Hall 1992).
/// @param[in] a  skewness of the mean: of the sample, over sqrt(n)
double pdmc_hall_inverse(double a, double y);
