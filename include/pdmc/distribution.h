// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Distributions of one real variable, as functions of a standard normal one: x(z) = F^-1(Phi(z)). What is random in a
/// study becomes independent standard normal variables by these functions, and correlated ones by a Gaussian copula.

#include "pdmc/base.h"

typedef enum {
    PDMC_NORMAL,     // location (mean), scale (standard deviation)
    PDMC_LOGNORMAL,  // location (log of the median), scale (standard deviation of the logarithm)
    PDMC_WEIBULL,    // of minima: scale, shape
    PDMC_GUMBEL,     // of maxima: location (mode), scale
    PDMC_GAMMA,      // scale, shape
    PDMC_BETA,       // lower, upper, alpha, beta
    PDMC_UNIFORM,    // lower, upper
    PDMC_TRIANGULAR, // lower, mode, upper
    PDMC_EMPIRICAL,  // values, each as likely, linear in between
    PDMC_DISTRIBUTIONS
} pdmc_distribution_kind;

/// A distribution by its own parameters; those that its kind does not name are 0.
typedef struct {
    pdmc_distribution_kind kind;
    double location, scale, shape; // scale > 0, shape > 0
    double lower, upper;           // the ends of a beta, uniform or triangular distribution
    double mode, alpha, beta;
    double least, most; // where it is cut off, -inf and inf where it is not: X given least < X < most
    int count;
    double *values; // [count] ascending, of an empirical one; owned by whoever made it
} pdmc_distribution;

/// Sets the parameters that have this mean and this coefficient of variation (the standard deviation over |mean|), of a
/// normal, lognormal, Weibull, Gumbel, gamma or uniform distribution, not cut off.
/// @return PDMC_OK, or PDMC_ERR_ARG where there is none: a lognormal, Weibull or gamma mean <= 0, a kind of another sort
PDMC_API PDMC_NODISCARD pdmc_status pdmc_distribution_by_moments(pdmc_distribution_kind kind, double mean,
                                                                 double variation, pdmc_distribution *distribution);

/// Says what is wrong with the parameters.
/// @return PDMC_OK or PDMC_ERR_ARG
PDMC_API PDMC_NODISCARD pdmc_status pdmc_distribution_check(const pdmc_distribution *distribution);

/// x(z), accurate in both tails; the same z gives the same quantile to every kind. A distribution without spread
/// (scale 0) is its location.
/// @param[in] z  finite
PDMC_API double pdmc_distribution_value(const pdmc_distribution *distribution, double z);

/// P(X <= x) and P(X > x), each without cancellation.
PDMC_API double pdmc_distribution_lower_tail(const pdmc_distribution *distribution, double x);
PDMC_API double pdmc_distribution_upper_tail(const pdmc_distribution *distribution, double x);

/// Mean and standard deviation, in closed form, or by quadrature over z where it is cut off.
PDMC_API void pdmc_distribution_moments(const pdmc_distribution *distribution, double *mean, double *deviation);

/// The Cholesky factor of the correlation matrix of a Gaussian copula, with which z = L w makes correlated standard normal
/// variables of independent ones.
/// @param[in]  n            number of variables
/// @param[in]  correlation  [n, n] symmetric, of the normal variables (not of the quantities themselves), 1 on the diagonal
/// @param[out] factor       [n, n] L, lower triangle, 0 above
/// @return PDMC_OK, or PDMC_ERR_ARG where the matrix is not positive definite
PDMC_API PDMC_NODISCARD pdmc_status pdmc_copula_factor(int n, const double correlation[], double factor[]);
