// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Statistics of a sample, each with its interval of confidence. Sums are taken in the order of the samples, so that a
/// result does not depend on threads.

#include "pdmc/base.h"

typedef struct {
    double value, lower, upper;
} pdmc_estimate;

/// Mean and standard deviation (with n - 1), each with its interval.
///
/// The mean's interval is Student's, value +- t s / sqrt(n), exact for a normal sample. The standard deviation's does
/// not assume a normal sample: the jackknife of log s^2 with Student's t (Miller 1968), whose bounds are positive. Both
/// cover too seldom where a small sample is skewed; src/statistics/README.md has figures. A sample without spread has
/// intervals of no width. Bounds that do not exist are NaN: of the mean with n < 2, of the deviation with n < 3; so
/// are the deviation with n < 2 and the mean with n = 0.
/// @param[in]  n           number of samples
/// @param[in]  x           [n] samples, finite
/// @param[in]  confidence  in (0, 1), e.g. 0.95
/// @param[out] mean, deviation
PDMC_API void pdmc_statistics_moments(size_t n, const double x[], double confidence, pdmc_estimate *mean,
                                      pdmc_estimate *deviation);

/// The quantile at p, as the order statistic x_(k), k = ceil(n p), with the distribution-free interval: the tightest
/// pair of order statistics that misses on each side with probability <= (1 - confidence) / 2, from the binomial
/// distribution (David & Nagaraja, Order Statistics, section 7.1). A bound that no order statistic reaches is -inf or
/// +inf.
/// @param[in] n       number of samples, >= 1
/// @param[in] sorted  [n] ascending
/// @param[in] p       in [0, 1]
PDMC_API pdmc_estimate pdmc_statistics_quantile(size_t n, const double sorted[], double p, double confidence);

/// The probability of an event seen `hits` times in `n` trials: hits / n with the Clopper-Pearson interval, which is
/// [0, upper] where nothing was seen and [lower, 1] where everything was. Both sides are at (1 - confidence) / 2 there
/// too: after 0 of n, upper = 1 - ((1 - confidence) / 2)^(1/n), at 95 % about 3.7 / n and not the one-sided 3 / n.
/// Without trials the value is NaN in [0, 1].
/// @param[in] hits  <= n
PDMC_API pdmc_estimate pdmc_statistics_proportion(size_t hits, size_t n, double confidence);

/// The mean of values in [0, 1], such as probabilities given a part of what is random, with an interval for skewed
/// samples: that of Student's T made symmetric by T + a T^2 / 3 + a^2 T^3 / 27 + a / 6, a = skewness / sqrt(n) (Hall
/// 1992), cut to [0, 1]. Its misses are more even on both sides than those of Student's interval, and fewer; figures
/// are in src/statistics/README.md. Of zeros alone the upper bound is that of pdmc_statistics_proportion(), since the
/// mean is no more than the probability of a value above 0. Without spread else, the interval has no width.
/// @param[in] n  number of samples; NaN is what too few cannot tell, as in pdmc_statistics_moments()
/// @param[in] x  [n] in [0, 1]
PDMC_API pdmc_estimate pdmc_statistics_bounded_mean(size_t n, const double x[], double confidence);

/// A histogram of equal bins from the 0.1 % to the 99.9 % quantile q, wider by a half-bin on each side: their width is
/// (q_99.9 - q_0.1) / (bins - 1), and twice that distance for a single bin.
///
/// A sample without spread, that is with bins below 1e-12 of its value, gets bins of 1e-3 of its value about it (of 1
/// where the value is 0). Bin b holds edges[b] <= x < edges[b + 1]; every sample is in one count. density[b] = count /
/// (n width), with the Clopper-Pearson interval of count of n divided by the width.
/// @param[in]  n       number of samples, >= 1
/// @param[in]  sorted  [n] ascending, finite
/// @param[in]  bins    number of bins, >= 1
/// @param[out] edges   [bins + 1] ascending
/// @param[out] counts  [bins + 2] underflow, the bins, overflow
/// @param[out] density [bins] per unit of x
PDMC_API void pdmc_statistics_histogram(size_t n, const double sorted[], int bins, double confidence, double edges[],
                                        int64_t counts[], pdmc_estimate density[]);

/// The bandwidth of a Gaussian kernel by Silverman's rule, 0.9 min(s, IQR / 1.34) n^(-1/5), with s alone where half of
/// the sample is equal. A sample without spread has 1e-3 of its value (1 where that is 0).
/// @param[in] n       number of samples, >= 1
/// @param[in] sorted  [n] ascending, finite
PDMC_API double pdmc_statistics_bandwidth(size_t n, const double sorted[]);

/// The density f(x) = sum_i K((x - x_i) / h) / (n h) with the standard normal K, which integrates to 1.
///
/// Samples within h / 16 of each other count as so many of their mean, which changes the kernel's variance by less than
/// 1 / 3000 of itself. For a quantity that is positive the kernel is reflected at 0; below 0 the density is 0.
///
/// The interval is pointwise: the variance of f(x) is about f (R / h - f) / n, R = 1 / (2 sqrt(pi)), with the
/// reflection (1 + exp(-(x / h)^2)) R, and the interval is that of the root of f, whose lower bound is not below 0. It
/// holds for the density smoothed by the kernel, not for the bias, about h^2 f'' / 2, which at Silverman's bandwidth is
/// as large where f is most curved: a smaller bandwidth has less of it.
/// @param[in]  n          number of samples, >= 1
/// @param[in]  sorted     [n] ascending, finite
/// @param[in]  bandwidth  h > 0, usually pdmc_statistics_bandwidth()
/// @param[in]  positive   x >= 0, with a boundary at 0
/// @param[in]  at         [points] where, in any order
/// @param[out] density    [points] per unit of x
/// @return PDMC_OK, PDMC_ERR_ARG or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_statistics_kernel_density(size_t n, const double sorted[], double bandwidth,
                                                                   bool positive, double confidence, size_t points,
                                                                   const double at[], pdmc_estimate density[]);

/// The probability that sqrt(n) sup |F_n - F| passes `distance` for a continuous F and many samples, Kolmogorov's
/// distribution: 2 sum_k (-1)^(k-1) exp(-2 k^2 distance^2), k = 1, 2, ... It is so too for two samples of n and m, with
/// sqrt(n m / (n + m)) sup |F_n - G_m|, where they have the same distribution.
PDMC_API double pdmc_statistics_kolmogorov(double distance);

/// Mean and standard deviation of a design of independent replicates, sample i in replicate i % R, as pdmc/design.h has
/// them; within a replicate the samples may depend on each other.
///
/// The mean's interval comes from the R means of the replicates and reaches, on each side, to the farther of Student's
/// bound and Hall's (1992), which corrects Student's for their skewness. The deviation is sqrt(sum (x_i - m)^2 / n +
/// var m), with var m from the spread of the means, so that its square has no bias whatever the design; its interval is
/// the same of the mean of (x_i - m)^2, by way of its logarithm. Bounds are NaN with R < 2 or n < R; a sample without
/// spread has intervals of no width.
/// @param[in] n           number of samples; a multiple of R but for a small rest
/// @param[in] x           [n] finite, in the order of the samples
/// @param[in] replicates  R
PDMC_API void pdmc_statistics_replicates_moments(size_t n, const double x[], size_t replicates, double confidence,
                                                 pdmc_estimate *mean, pdmc_estimate *deviation);

/// The probability of an event from such a design: its share p in all samples, with Wilson's interval, |p - P| <=
/// t sqrt(D P (1 - P) / n), t with R - 1 degrees of freedom. D is how much more the replicates' shares spread than
/// those of independent samples. The interval is no narrower than what R trials leave open that all have the same
/// outcome, p +- (1 - ((1 - confidence) / 2)^(1 / R)) R / n. Where fewer than 5 samples have the event, or fewer than 5
/// have it not, or R < 2, it is pdmc_statistics_proportion() of all samples, which for a design that beats independent
/// samples is wider than need be.
/// @param[in] n      number of samples; without any, NaN in [0, 1]
/// @param[in] event  [n] in the order of the samples
PDMC_API pdmc_estimate pdmc_statistics_replicates_proportion(size_t n, const bool event[], size_t replicates,
                                                             double confidence);

/// The quantile at p from such a design, x_(k) of all samples with k = ceil(n p). The interval is Woodruff's (1952),
/// between the order statistics at p +- h, h = t sqrt(D p (1 - p) / n), with D and the least h as above, of the event
/// x <= x_(k). Where fewer than 5 samples are expected or found on one side, it is that of pdmc_statistics_quantile().
/// @param[in] n       number of samples, >= 1
/// @param[in] x       [n] in the order of the samples
/// @param[in] sorted  [n] the same, ascending
PDMC_API pdmc_estimate pdmc_statistics_replicates_quantile(size_t n, const double x[], const double sorted[],
                                                           size_t replicates, double p, double confidence);

/// How far two distributions are apart, by two norms of the difference of their distribution functions.
typedef struct {
    pdmc_estimate kolmogorov_smirnov; // D = sup |F - G|, in [0, 1]
    double p_value;                   // how likely as large a D is where F = G
    pdmc_estimate wasserstein;        // W = integral of |F - G|, in the unit of x: how far mass is moved on average
} pdmc_distances;

/// Distances between the distributions F and G behind two samples.
///
/// The estimates are those between the empirical distributions, and so never 0 where F = G: it is the interval that
/// then begins with 0. It is value +- c, cut at what is possible, with c the quantile at `confidence` of the same norm
/// of (F* - G*) - (F_n - G_m), of 999 resamples with replacement. By the triangle inequality no estimate is off by more
/// than this norm of its error, so that the interval covers at F = G, and away from it somewhat too often; of pairs
/// that hardly differ that of W covers 90 % where it says 95 %, see src/statistics/README.md.
///
/// p is Kolmogorov's for independent samples, and of pairs (x_i, y_i) the share of resamples with a norm of at least D,
/// no less than 1 / 1000. Pairs are resampled as pairs. The resamples are always the same.
/// @param[in] n, m    numbers of samples; without any, all is NaN
/// @param[in] x, y    [n], [m] finite, in any order
/// @param[in] paired  n = m, and x_i and y_i depend on each other, as in two studies with the same seed
/// @return PDMC_OK, PDMC_ERR_ARG (pairs of n != m), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_statistics_distances(size_t n, const double x[], size_t m, const double y[],
                                                              bool paired, double confidence,
                                                              pdmc_distances *distances);

/// Difference mean_y - mean_x and ratio mean_y / mean_x, each with its interval.
///
/// Of independent samples, Welch's interval of the difference; of pairs, Student's of y_i - x_i. The ratio's is
/// Fieller's: the r for which mean_y - r mean_x = 0 is not refused by the same test. Where mean_x is not told from zero
/// its bounds are -inf and inf. With n < 2 or m < 2, or pairs of n != m, all is NaN.
/// @param[in] paired  as in pdmc_statistics_distances()
PDMC_API void pdmc_statistics_means(size_t n, const double x[], size_t m, const double y[], bool paired,
                                    double confidence, pdmc_estimate *difference, pdmc_estimate *ratio);

/// Pairs (x_i, y_i), compared one by one. The relative difference of a pair is (y - x) / ((|x| + |y|) / 2), in [-2, 2]
/// and 0 where both are 0.
typedef struct {
    size_t count;
    pdmc_estimate correlation; // Pearson's, with Fisher's interval; NaN without spread
    pdmc_estimate difference;  // mean of the relative differences, with Student's interval
    double largest_difference; // of the largest magnitude, with its sign
    size_t largest_at;         // and its index
} pdmc_pairs;

/// @param[in] n     number of pairs; NaN is what too few cannot tell, as in pdmc_statistics_moments()
/// @param[in] x, y  [n] finite
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_statistics_pairs(size_t n, const double x[], const double y[],
                                                          double confidence, pdmc_pairs *pairs);

/// A mean found with control variates.
typedef struct {
    pdmc_estimate mean;
    double correlation; // of x and its regression on the controls, the multiple correlation R
    double reduction; // variance of the plain mean over that of this one: how many times the samples it is worth
    size_t controls;  // how many were used
} pdmc_controlled;

/// The mean of x from its linear regression on controls c of known mean mu: that of x - b'(c - mu), b by least squares.
///
/// The interval is the regression's, Student's with n - 1 - controls degrees of freedom: exact where x given c is
/// normal and linear in c, else for many samples (Lavenberg & Welch 1981). For many samples the reduction is 1 / (1 -
/// R^2). Controls without spread, and combinations of controls that are linear in others, are left out.
///
/// Where mu is itself the mean of N samples, of which these are the first n, the variance is that of the two phases,
/// s^2 ((1 - R^2) / n + R^2 / N) for many samples (Cochran, Sampling Techniques, section 12.6).
/// @param[in] n         number of samples, from controls + 2 to INT_MAX
/// @param[in] x         [n] finite
/// @param[in] c         [n, controls] finite
/// @param[in] mean      [controls] of the controls
/// @param[in] known_by  N >= n, the samples whose mean that is; INFINITY where it is exact
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_statistics_control(size_t n, const double x[], size_t controls,
                                                            const double c[], const double mean[], double known_by,
                                                            double confidence, pdmc_controlled *controlled);

/// The probability of an event x from n samples, with a control event c that is also known of N samples, these the first:
/// post-stratification, P = w p_1 + (1 - w) p_0, with p_k the share of x where c is k among the n, and w that of c among
/// the N. It is the regression on c, for events.
///
/// The interval adds the distances of Clopper and Pearson's bounds of p_1, p_0 and w, weighed, in squares on either side
/// (Zou & Donner, Statistics in Medicine 27 (2008) 1693-1702). Like theirs it holds at least as often as it says, for few
/// events too, and where x and c have always agreed. Where all of the n have c, or none has, it is
/// pdmc_statistics_proportion() of the n alone.
/// @param[in] hits        [2] samples of the n with x, where c is not and where it is
/// @param[in] trials      [2] samples of the n where c is not and where it is
/// @param[in] known_hits  samples of the N with c
/// @param[in] known_by    N >= n
PDMC_API pdmc_estimate pdmc_statistics_stratified_proportion(const size_t hits[2], const size_t trials[2],
                                                             size_t known_hits, size_t known_by, double confidence);
