// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Distributions of one real variable, as functions of a standard normal one: x(z) = F^-1(Phi(z)). What is random in a
/// study becomes independent standard normal variables by these functions, and correlated ones by a Gaussian copula.

#include "pdmc/base.h"

typedef enum {
    PDMC_NORMAL,     // location (mean), scale (standard deviation)
    PDMC_LOGNORMAL,  // location (log of the median), scale (standard deviation of the logarithm)
    PDMC_WEIBULL,    // of minima: scale, shape, location (the least value, 0 of the two-parameter distribution)
    PDMC_GUMBEL,     // of maxima: location (mode), scale
    PDMC_GAMMA,      // scale, shape in [0.1, 1e5], location (the least value)
    PDMC_BETA,       // lower, upper, alpha and beta in [0.1, 1e4]
    PDMC_UNIFORM,    // lower, upper
    PDMC_TRIANGULAR, // lower, mode, upper
    PDMC_EMPIRICAL,  // values: F rises linearly from each to the next, by 1 / (count - 1); equal ones are an atom
    PDMC_DISTRIBUTIONS
} pdmc_distribution_kind;

/// A distribution by its own parameters; those that its kind does not name are 0.
typedef struct {
    pdmc_distribution_kind kind;
    double location, scale, shape; // scale >= 0, shape > 0
    double lower, upper;           // the ends of a beta, uniform or triangular distribution
    double mode, alpha, beta;
    double least, most; // where it is cut off, -inf and inf where it is not: X given least < X < most
    int count;
    double *values; // [count] ascending, of an empirical one; owned by whoever made it
} pdmc_distribution;

/// Sets the parameters that have this mean and this coefficient of variation (the standard deviation over |mean|), of a
/// normal, lognormal, Weibull, Gumbel, gamma or uniform distribution, not cut off.
/// @param[in] variation  >= 0; 0 makes a distribution without spread
/// @return PDMC_OK, or PDMC_ERR_ARG where there is none: a lognormal, Weibull or gamma mean <= 0, a mean of 0 with a
///         variation, a gamma variation outside [1 / sqrt(1e5), sqrt(10)], a kind of another sort
PDMC_API PDMC_NODISCARD pdmc_status pdmc_distribution_by_moments(pdmc_distribution_kind kind, double mean,
                                                                 double variation, pdmc_distribution *distribution);

/// Says what is wrong with the parameters.
/// @return PDMC_OK or PDMC_ERR_ARG
PDMC_API PDMC_NODISCARD pdmc_status pdmc_distribution_check(const pdmc_distribution *distribution);

/// x(z), accurate in both tails; the same z gives the same quantile to every kind. A distribution without spread
/// (scale 0) is its location, the logarithm's of a lognormal one. src/random/README.md has figures of accuracy.
/// @param[in] distribution  that passes the check, as everywhere below
/// @param[in] z             in [-37, 37], where both tails are normal doubles
PDMC_API double pdmc_distribution_value(const pdmc_distribution *distribution, double z);

/// P(X <= x) and P(X > x), each without cancellation; of a cut distribution up to rounding of the uncut probabilities.
PDMC_API double pdmc_distribution_lower_tail(const pdmc_distribution *distribution, double x);
PDMC_API double pdmc_distribution_upper_tail(const pdmc_distribution *distribution, double x);

/// Mean and standard deviation, in closed form, or by quadrature over z where it is cut off (relative error 1e-12, or
/// that of the values).
PDMC_API void pdmc_distribution_moments(const pdmc_distribution *distribution, double *mean, double *deviation);

/// The Cholesky factor of the correlation matrix of a Gaussian copula, with which z = L w makes correlated standard
/// normal variables of independent ones.
/// @param[in]  n            number of variables
/// @param[in]  correlation  [n, n] exactly symmetric, of the normal variables (not of the quantities themselves), 1 on
///                          the diagonal
/// @param[out] factor       [n, n] L, lower triangle, 0 above
/// @return PDMC_OK, or PDMC_ERR_ARG where the matrix is not such or not positive definite
PDMC_API PDMC_NODISCARD pdmc_status pdmc_copula_factor(int n, const double correlation[], double factor[]);
