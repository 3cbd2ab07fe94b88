// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/distribution.h"

/// P(X <= x) and P(X > x): whichever is the smaller has all its digits.
typedef struct {
    double lower, upper;
} pdmc_tails;

/// What is particular to a kind of distribution. The functions know nothing of cutting off, nor of x that is
/// infinite or beyond the ends.
typedef struct {
    const char *name;
    bool scaled, shaped, bounded, positive; // which parameters it has, and whether its mean must be positive
    double (*value)(const pdmc_distribution *distribution, double z);
    pdmc_tails (*tails)(const pdmc_distribution *distribution, double x);
    void (*moments)(const pdmc_distribution *distribution, double *mean, double *deviation);
    /// NULL where mean and deviation are not enough.
    void (*by_moments)(double mean, double deviation, pdmc_distribution *distribution);
    /// What else its parameters must fulfil; may be NULL.
    pdmc_status (*check)(const pdmc_distribution *distribution);
    /// The tails at the points between its ends where its density is not smooth, ascending, and their number; or NULL.
    int (*kinks)(const pdmc_distribution *distribution);
    pdmc_tails (*kink)(const pdmc_distribution *distribution, int index);
} pdmc_family;

extern const pdmc_family pdmc_family_normal, pdmc_family_lognormal, pdmc_family_weibull, pdmc_family_gumbel,
    pdmc_family_gamma, pdmc_family_beta, pdmc_family_uniform, pdmc_family_triangular, pdmc_family_empirical;

const pdmc_family *pdmc_family_of(const pdmc_distribution *distribution);

/// The tails at any x, infinite ones and distributions without spread included; not cut off.
pdmc_tails pdmc_distribution_uncut_tails(const pdmc_distribution *distribution, double x);

/// The tails of a standard normal variable at z, and the z that has these tails, from the smaller one.
pdmc_tails pdmc_normal_tails(double z);
double pdmc_normal_score(pdmc_tails tails);

/// log(1 - Phi(z)), with all digits on either side.
double pdmc_normal_log_upper(double z);

bool pdmc_distribution_is_cut(const pdmc_distribution *distribution);

/// The z at which the uncut distribution has the quantile that the cut one has at z.
double pdmc_cut_score(const pdmc_distribution *distribution, double z);

/// The tails of the cut distribution where the uncut one has the given ones.
pdmc_tails pdmc_cut_tails(const pdmc_distribution *distribution, pdmc_tails uncut);

/// The probability of the interval that is left.
double pdmc_cut_mass(const pdmc_distribution *distribution);

/// Mean and deviation of any distribution by quadrature over z.
void pdmc_distribution_moments_by_quadrature(const pdmc_distribution *distribution, double *mean, double *deviation);

/// The lower tail at y (side = 1) or the upper one (side = -1) and, in *slope, the density there.
typedef double pdmc_log_concave_tail(const pdmc_distribution *distribution, double y, int side, double *slope);

/// Solves tail(y) = target for a density that is log-concave in y, with its mode at 0.
///
/// Then the logarithm of either tail is concave, and Newton's method on it converges from wherever the tail is not 0:
/// after its first step it comes from the outside, where its steps are too short, and turns back by rounding alone.
/// @param[in] guess  a first y; 0 is taken where the tail there is no normal double
double pdmc_log_concave_quantile(pdmc_log_concave_tail *tail, const pdmc_distribution *distribution, double target,
                                 int side, double guess);
