// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include "base/base_impl.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <math.h>

/// A point of [0, 1] by its distances from both ends, of which the smaller has all its digits.
typedef struct {
    double left, right;
} position;

static pdmc_tails standard_tails(double alpha, double beta, position at)
{
    if (at.left <= at.right)
        return (pdmc_tails){gsl_cdf_beta_P(at.left, alpha, beta), gsl_cdf_beta_Q(at.left, alpha, beta)};
    return (pdmc_tails){gsl_cdf_beta_Q(at.right, beta, alpha), gsl_cdf_beta_P(at.right, beta, alpha)};
}

static double standard_density(double alpha, double beta, position at)
{
    return at.left <= at.right ? gsl_ran_beta_pdf(at.left, alpha, beta) : gsl_ran_beta_pdf(at.right, beta, alpha);
}

/// The point where log(left / right) = log(alpha / beta) + y.
static position at_logit(const pdmc_distribution *distribution, double y)
{
    // exp(-|y|) does not overflow
    const double far = exp(-fabs(y));
    const double left = distribution->alpha * (y < 0.0 ? far : 1.0), right = distribution->beta * (y < 0.0 ? 1.0 : far);
    return (position){left / (left + right), right / (left + right)};
}

/// In y the density is proportional to left^alpha right^beta: log-concave with its mode at 0.
static double tail_of_logit(const pdmc_distribution *distribution, double y, int side, double *slope)
{
    const position at = at_logit(distribution, y);
    const pdmc_tails tails = standard_tails(distribution->alpha, distribution->beta, at);
    *slope = at.left * at.right * standard_density(distribution->alpha, distribution->beta, at);
    return side > 0 ? tails.lower : tails.upper;
}

static double beta_value(const pdmc_distribution *distribution, double z)
{
    const int side = z < 0.0 ? 1 : -1;
    const double target = gsl_cdf_ugaussian_P(-fabs(z));
    const double guess = z * sqrt(1.0 / distribution->alpha + 1.0 / distribution->beta);
    const position at =
        at_logit(distribution, pdmc_log_concave_quantile(tail_of_logit, distribution, target, side, guess));
    const double width = distribution->upper - distribution->lower;
    return at.left <= at.right ? distribution->lower + width * at.left : distribution->upper - width * at.right;
}

static pdmc_tails beta_tails(const pdmc_distribution *distribution, double x)
{
    const double width = distribution->upper - distribution->lower;
    const position at = {(x - distribution->lower) / width, (distribution->upper - x) / width};
    return standard_tails(distribution->alpha, distribution->beta, at);
}

static void beta_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    const double alpha = distribution->alpha, beta = distribution->beta, sum = alpha + beta;
    const double width = distribution->upper - distribution->lower;
    *mean = distribution->lower + width * (alpha / sum);
    *deviation = width * sqrt(alpha / sum * (beta / sum) / (sum + 1.0));
}

static const double least_exponent = 0.1, greatest_exponent = 1e4;

static bool is_exponent(double value)
{
    return least_exponent <= value && value <= greatest_exponent;
}

static pdmc_status beta_check(const pdmc_distribution *distribution)
{
    PDMC_REQUIRE(is_exponent(distribution->alpha) && is_exponent(distribution->beta),
                 "alpha = %g and beta = %g of a beta distribution must be in [%g, %g]", distribution->alpha,
                 distribution->beta, least_exponent, greatest_exponent);
    return PDMC_OK;
}

const pdmc_family pdmc_family_beta = {
    .name = "beta",
    .bounded = true,
    .value = beta_value,
    .tails = beta_tails,
    .moments = beta_moments,
    .check = beta_check,
};
