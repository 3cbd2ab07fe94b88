// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/distribution.h"
#include "pdmc/random.h"
#include "pdmc/statistics.h"

#include "check.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

/// The cdf magnifies a relative error of z by z phi(z) / Phi(z) <= 1 + z^2; the 16 leaves room for the rounding of both
/// of GSL's functions.
static double rounding(double z)
{
    return 16.0 * DBL_EPSILON * (1.0 + z * z);
}

static void the_normal_quantile_inverts_the_cdf_in_both_tails(void **state)
{
    (void)state;
    for (int k = 1; k <= 53; k++) {
        const double u = ldexp(1.0, -k);
        const double low = pdmc_normal_quantile(u), high = pdmc_normal_quantile(1.0 - u);
        CHECK_NEAR(gsl_cdf_ugaussian_P(low) / u, 1.0, rounding(low));
        CHECK_NEAR(gsl_cdf_ugaussian_Q(high) / u, 1.0, rounding(high));
    }
    for (int k = 1; k < 1000; k++) {
        const double z = pdmc_normal_quantile(k / 1000.0);
        CHECK_NEAR(gsl_cdf_ugaussian_P(z), k / 1000.0, rounding(z));
    }
}

static void the_normal_quantile_is_odd_and_increasing(void **state)
{
    (void)state;
    assert_true(pdmc_normal_quantile(0.5) == 0.0);
    double previous = -INFINITY;
    for (int k = 1; k < 4096; k++) {
        const double u = k / 4096.0; // 1 - u is exact
        const double z = pdmc_normal_quantile(u);
        CHECK_NEAR(pdmc_normal_quantile(1.0 - u), -z, 0.0);
        assert_true(z > previous);
        previous = z;
    }
}

/// 30-digit arithmetic at the doubles nearest to 0.975, 0.9999 and 1e-10.
static void known_normal_quantiles(void **state)
{
    (void)state;
    CHECK_NEAR(pdmc_normal_quantile(0.975), 1.959963984540054, 4 * DBL_EPSILON);
    CHECK_NEAR(pdmc_normal_quantile(0.9999), 3.7190164854557084, 8 * DBL_EPSILON);
    CHECK_NEAR(pdmc_normal_quantile(1e-10), -6.361340902404056, 16 * DBL_EPSILON);
}

/// The mean of n values of a variable with mean 1 has standard deviation v / sqrt(n). Theirs is v (1 + e) with
/// var e = (kurtosis - 1) / (4 n). Both within 5 standard deviations.
static void check_moments(pdmc_distribution_kind kind, double variation, double kurtosis)
{
    enum { N = 200000 };
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < N; i++) {
        double u;
        pdmc_random_uniform(7, PDMC_STREAM_LOAD, (uint64_t)i, 0, 1, &u);
        const double deviation = pdmc_unit_mean_quantile(kind, variation, u) - 1.0;
        sum += deviation;
        squares += deviation * deviation;
    }
    CHECK_NEAR(sum / N, 0.0, 5.0 * variation / sqrt(N));
    CHECK_NEAR(sqrt(squares / N) / variation, 1.0, 5.0 * sqrt((kurtosis - 1.0) / (4.0 * N)));
}

static void mean_is_one_and_variation_as_asked(void **state)
{
    (void)state;
    static const double variations[] = {0.01, 0.1, 0.3, 0.5};
    for (int k = 0; k < 4; k++) {
        const double v = variations[k], w = 1.0 + v * v;
        check_moments(PDMC_NORMAL, v, 3.0);
        check_moments(PDMC_LOGNORMAL, v, pow(w, 4) + 2.0 * pow(w, 3) + 3.0 * w * w - 3.0);
    }
}

/// With w = 1 + v^2: the median is w^-1/2, and the quantiles at u and 1 - u are in proportion to it as q and 1/q.
static void lognormal_quantiles_have_their_closed_form(void **state)
{
    (void)state;
    for (int k = 1; k < 512; k++) {
        const double u = k / 1024.0, v = 0.3, median = 1.0 / sqrt(1.0 + v * v);
        const double low = pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, u);
        const double high = pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, 1.0 - u);
        CHECK_NEAR(low * high / (median * median), 1.0, 16 * DBL_EPSILON);
        CHECK_NEAR(gsl_cdf_lognormal_P(low, log(median), sqrt(log(1.0 + v * v))), u, 64 * DBL_EPSILON);
    }
    CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_LOGNORMAL, 1.0, 0.5), sqrt(0.5), 4 * DBL_EPSILON);
}

/// For small v the lognormal is 1 + v z + O(v^2): a log(1 + v^2) that loses v^2 would give 1.
static void a_small_variation_is_not_lost(void **state)
{
    (void)state;
    const double v = 1e-9, z = pdmc_normal_quantile(0.9);
    CHECK_NEAR((pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, 0.9) - 1.0) / v, z, 2.0 * DBL_EPSILON / v);
    CHECK_NEAR((pdmc_unit_mean_quantile(PDMC_NORMAL, v, 0.9) - 1.0) / v, z, 2.0 * DBL_EPSILON / v);
}

static void without_variation_there_is_exactly_one(void **state)
{
    (void)state;
    for (int k = 1; k < 16; k++) {
        CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_NORMAL, 0.0, k / 16.0), 1.0, 0.0);
        CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_LOGNORMAL, 0.0, k / 16.0), 1.0, 0.0);
    }
}

/// Studies of old are repeated to the bit.
static void the_formulas_of_unit_mean_are_kept_to_the_bit(void **state)
{
    (void)state;
    for (int k = 1; k < 512; k++) {
        const double u = k / 512.0, z = pdmc_normal_quantile(u), v = 0.1 + k / 1000.0, variance = log1p(v * v);
        CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_NORMAL, v, u), 1.0 + v * z, 0.0);
        CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, u), exp(sqrt(variance) * z - 0.5 * variance), 0.0);
    }
}

/// P(X <= x) and P(X > x) of another hand.
typedef struct {
    double lower, upper;
} reference;

typedef struct {
    pdmc_distribution distribution;
    reference (*tails)(const pdmc_distribution *, double x);
    double accuracy; // relative, of a tail probability
} known_distribution;

static reference normal_reference(const pdmc_distribution *d, double x)
{
    return (reference){gsl_cdf_gaussian_P(x - d->location, d->scale), gsl_cdf_gaussian_Q(x - d->location, d->scale)};
}

static reference lognormal_reference(const pdmc_distribution *d, double x)
{
    return (reference){gsl_cdf_lognormal_P(x, d->location, d->scale), gsl_cdf_lognormal_Q(x, d->location, d->scale)};
}

static reference weibull_reference(const pdmc_distribution *d, double x)
{
    return (reference){gsl_cdf_weibull_P(x - d->location, d->scale, d->shape),
                       gsl_cdf_weibull_Q(x - d->location, d->scale, d->shape)};
}

static reference gumbel_reference(const pdmc_distribution *d, double x)
{
    const double rate = 1.0 / d->scale;
    return (reference){gsl_cdf_gumbel1_P(x - d->location, rate, 1.0), gsl_cdf_gumbel1_Q(x - d->location, rate, 1.0)};
}

/// Of whole shapes: a gamma variable is above x where a Poisson one of mean x is below the shape.
static reference gamma_reference(const pdmc_distribution *d, double x)
{
    reference sum = {0.0, 0.0};
    double term = exp(-x / d->scale);
    for (int k = 0; k < 1000; k++) {
        *(k < d->shape ? &sum.upper : &sum.lower) += term;
        term *= x / d->scale / (k + 1);
    }
    return sum;
}

/// Of alpha = 2, beta = 3: a beta variable is below x where 2 or more of 4 uniform ones are.
static reference beta_reference(const pdmc_distribution *d, double x)
{
    const double width = d->upper - d->lower, p = (x - d->lower) / width, q = (d->upper - x) / width;
    return (reference){6.0 * p * p * q * q + 4.0 * gsl_pow_3(p) * q + gsl_pow_4(p),
                       gsl_pow_4(q) + 4.0 * p * gsl_pow_3(q)};
}

static reference uniform_reference(const pdmc_distribution *d, double x)
{
    return (reference){gsl_cdf_flat_P(x, d->lower, d->upper), gsl_cdf_flat_Q(x, d->lower, d->upper)};
}

/// Areas of triangles.
static reference triangular_reference(const pdmc_distribution *d, double x)
{
    const double width = d->upper - d->lower;
    const double left = gsl_pow_2(x - d->lower) / (width * (d->mode - d->lower));
    const double right = gsl_pow_2(d->upper - x) / (width * (d->upper - d->mode));
    return x < d->mode ? (reference){left, 1.0 - left} : (reference){1.0 - right, right};
}

static double measured[] = {-1.0, 0.0, 0.5, 2.0, 7.0};

/// By hand: the four intervals have the probability 1/4 each.
static reference empirical_reference(const pdmc_distribution *d, double x)
{
    (void)d;
    const double lower = x < 0.0   ? 0.25 * (x + 1.0)
                         : x < 0.5 ? 0.25 + 0.5 * x
                         : x < 2.0 ? 0.5 + (x - 0.5) / 6.0
                                   : 0.75 + 0.05 * (x - 2.0);
    return (reference){lower, x < 2.0 ? 1.0 - lower : 0.05 * (7.0 - x)};
}

#define UNCUT .least = -INFINITY, .most = INFINITY

// The tails of the bounded ones are resolved near an end that is 0; of the others x is rounded too coarsely.
static const known_distribution known[] = {
    {{.kind = PDMC_NORMAL, .location = 2.0, .scale = 3.0, UNCUT}, normal_reference, 1e-13},
    {{.kind = PDMC_LOGNORMAL, .location = 0.3, .scale = 0.5, UNCUT}, lognormal_reference, 1e-13},
    {{.kind = PDMC_WEIBULL, .scale = 3.0, .shape = 10.0, UNCUT}, weibull_reference, 1e-13},
    {{.kind = PDMC_WEIBULL, .scale = 0.1, .shape = 0.7, UNCUT}, weibull_reference, 1e-13},
    {{.kind = PDMC_GUMBEL, .location = 5.0, .scale = 0.5, UNCUT}, gumbel_reference, 1e-13},
    {{.kind = PDMC_GAMMA, .scale = 0.2, .shape = 1.0, UNCUT}, gamma_reference, 1e-13},
    {{.kind = PDMC_GAMMA, .scale = 2.0, .shape = 3.0, UNCUT}, gamma_reference, 1e-13},
    {{.kind = PDMC_GAMMA, .scale = 0.01, .shape = 100.0, UNCUT}, gamma_reference, 1e-12},
    {{.kind = PDMC_BETA, .lower = 0.0, .upper = 2.0, .alpha = 2.0, .beta = 3.0, UNCUT}, beta_reference, 1e-13},
    {{.kind = PDMC_UNIFORM, .lower = 0.0, .upper = 4.0, UNCUT}, uniform_reference, 1e-14},
    {{.kind = PDMC_TRIANGULAR, .lower = 0.0, .mode = 1.0, .upper = 4.0, UNCUT}, triangular_reference, 1e-14},
    {{.kind = PDMC_EMPIRICAL, .count = 5, .values = measured, UNCUT}, empirical_reference, 1e-14},
};
enum { KNOWN = sizeof known / sizeof known[0] };

/// What the rounding of x to a double makes of a tail, as a part of it: the change of the reference over 4 spacings.
static double rounding_of_x(const known_distribution *one, double x, double size, double tail, bool lower)
{
    const reference a = one->tails(&one->distribution, x - 2.0 * DBL_EPSILON * size);
    const reference b = one->tails(&one->distribution, x + 2.0 * DBL_EPSILON * size);
    return (lower ? b.lower - a.lower : a.upper - b.upper) / tail;
}

/// The largest number in the arithmetic of x: an upper end for x below it.
static double size_of(const pdmc_distribution *d, double x)
{
    return d->kind == PDMC_EMPIRICAL ? 7.0 : x > 0.5 * d->upper ? fmax(fabs(x), d->upper) : fabs(x);
}

static void check_round_trip(const known_distribution *one, double z)
{
    const pdmc_distribution *d = &one->distribution;
    const bool low = z < 0.0;
    const double x = pdmc_distribution_value(d, z), want = gsl_cdf_ugaussian_P(-fabs(z));
    const reference other = one->tails(d, x);
    const double tolerance = one->accuracy + rounding_of_x(one, x, size_of(d, x), want, low);
    CHECK_NEAR((low ? other.lower : other.upper) / want, 1.0, tolerance);
    CHECK_NEAR((low ? pdmc_distribution_lower_tail(d, x) : pdmc_distribution_upper_tail(d, x)) / want, 1.0, tolerance);
    CHECK_NEAR(pdmc_distribution_lower_tail(d, x) + pdmc_distribution_upper_tail(d, x), 1.0, 1e-13);
}

static void values_have_the_tails_of_their_normal_scores(void **state)
{
    (void)state;
    for (int i = 0; i < KNOWN; i++) {
        CHECK_OK(pdmc_distribution_check(&known[i].distribution));
        for (int k = -64; k <= 64; k++) check_round_trip(&known[i], k / 8.0);
    }
}

static void values_rise_and_stay_finite(void **state)
{
    (void)state;
    for (int i = 0; i < KNOWN; i++) {
        double previous = -INFINITY;
        for (int k = -300; k <= 300; k++) {
            const double x = pdmc_distribution_value(&known[i].distribution, k / 10.0);
            assert_true(isfinite(x) && x >= previous);
            if (abs(k) <= 30) assert_true(x > previous);
            previous = x;
        }
    }
}

/// mpmath, 40 digits: bisection of its regularised gammainc() and betainc() for ncdf(z).
static void quantiles_of_broken_shapes(void **state)
{
    (void)state;
    static const double z[] = {-8.0, -3.0, 1.0, 5.0};
    static const struct {
        double alpha, beta, want[4];
    } shapes[] = {
        {0.3, 0.0, {1.4330425546782638e-51, 1.8955597168699258e-10, 0.59293814139210513, 12.167826303911259}},
        {2.5, 0.0, {1.3371299879271377e-6, 0.11897555644568772, 3.9781971476579232, 19.29691490862739}},
        {40.5, 0.0, {8.1810689690180306, 24.038924407214134, 46.83793933076382, 80.656329590142285}},
        {0.5, 1.5, {2.3872321830580594e-31, 1.1240402259948575e-6, 0.53756043933161114, 0.99992302135020241}},
        {7.5, 2.25, {0.0066716834152233346, 0.31031856767193827, 0.89867341413788597, 0.9997686442042298}},
    };
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
        const pdmc_distribution d = {.kind = shapes[i].beta > 0.0 ? PDMC_BETA : PDMC_GAMMA,
                                     .scale = 1.0,
                                     .upper = 1.0,
                                     .shape = shapes[i].alpha,
                                     .alpha = shapes[i].alpha,
                                     .beta = shapes[i].beta,
                                     UNCUT};
        for (int k = 0; k < 4; k++) CHECK_NEAR(pdmc_distribution_value(&d, z[k]) / shapes[i].want[k], 1.0, 1e-12);
    }
}

/// The trapezoidal rule converges faster than any power for what dies off like the normal density. The kinks
/// of the triangular and the empirical ones leave h^2 of them, some 1e-6.
static void moments_are_the_integrals_over_z(void **state)
{
    (void)state;
    enum { STEPS = 2000 };
    for (int i = 0; i < KNOWN; i++) {
        const pdmc_distribution *d = &known[i].distribution;
        double mean, deviation, first = 0.0, second = 0.0;
        pdmc_distribution_moments(d, &mean, &deviation);
        for (int k = -STEPS; k <= STEPS; k++) {
            const double h = 14.0 / STEPS, z = k * h, x = (pdmc_distribution_value(d, z) - mean) / deviation;
            const double weight = h * exp(-0.5 * z * z) / sqrt(2.0 * M_PI);
            first += weight * x;
            second += weight * x * x;
        }
        const bool kinks = d->kind == PDMC_TRIANGULAR || d->kind == PDMC_EMPIRICAL;
        CHECK_NEAR(first, 0.0, kinks ? 1e-5 : 1e-12);
        CHECK_NEAR(second, 1.0, kinks ? 1e-5 : 1e-12);
    }
}

static void parameters_by_moments_have_these_moments(void **state)
{
    (void)state;
    static const pdmc_distribution_kind kinds[] = {PDMC_NORMAL, PDMC_LOGNORMAL, PDMC_WEIBULL,
                                                   PDMC_GUMBEL, PDMC_GAMMA,     PDMC_UNIFORM};
    static const double variations[] = {0.01, 0.1, 0.5, 1.0, 2.5};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 5; k++) {
            pdmc_distribution d;
            double mean, deviation;
            CHECK_OK(pdmc_distribution_by_moments(kinds[i], 70e9, variations[k], &d));
            pdmc_distribution_moments(&d, &mean, &deviation);
            CHECK_NEAR(mean / 70e9, 1.0, 1e-14);
            // log(1 + v^2) of a Weibull variable is a difference of logarithms of the size of v: their rounding, of some
            // hundred DBL_EPSILON in GSL, is that over v of it.
            CHECK_NEAR(deviation / mean / variations[k], 1.0, 256 * DBL_EPSILON / variations[k]);
        }
    }
}

static void an_exponential_variable_is_weibull_and_gamma(void **state)
{
    (void)state;
    pdmc_distribution weibull, gamma;
    CHECK_OK(pdmc_distribution_by_moments(PDMC_WEIBULL, 3.0, 1.0, &weibull));
    CHECK_OK(pdmc_distribution_by_moments(PDMC_GAMMA, 3.0, 1.0, &gamma));
    CHECK_NEAR(weibull.shape, 1.0, 1e-14);
    CHECK_NEAR(weibull.scale, 3.0, 1e-13);
    CHECK_NEAR(gamma.shape, 1.0, 0.0);
    CHECK_NEAR(gamma.scale, 3.0, 0.0);
}

static void negative_means_keep_their_sign(void **state)
{
    (void)state;
    pdmc_distribution d;
    double mean, deviation;
    CHECK_OK(pdmc_distribution_by_moments(PDMC_GUMBEL, -2.0, 0.25, &d));
    pdmc_distribution_moments(&d, &mean, &deviation);
    CHECK_NEAR(mean, -2.0, 1e-15);
    CHECK_NEAR(deviation, 0.5, 1e-15);
}

static void without_spread_every_kind_is_its_mean(void **state)
{
    (void)state;
    static const pdmc_distribution_kind kinds[] = {PDMC_NORMAL, PDMC_LOGNORMAL, PDMC_WEIBULL,
                                                   PDMC_GUMBEL, PDMC_GAMMA,     PDMC_UNIFORM};
    for (int i = 0; i < 6; i++) {
        pdmc_distribution d;
        double mean, deviation;
        CHECK_OK(pdmc_distribution_by_moments(kinds[i], 2.0, 0.0, &d));
        pdmc_distribution_moments(&d, &mean, &deviation);
        CHECK_NEAR(mean, 2.0, DBL_EPSILON);
        CHECK_NEAR(deviation, 0.0, 0.0);
        for (int z = -8; z <= 8; z++) CHECK_NEAR(pdmc_distribution_value(&d, z), mean, 0.0);
        CHECK_NEAR(pdmc_distribution_lower_tail(&d, 1.9), 0.0, 0.0);
        CHECK_NEAR(pdmc_distribution_upper_tail(&d, 2.1), 0.0, 0.0);
    }
}

static void an_empirical_distribution_has_the_quantiles_of_its_values(void **state)
{
    (void)state;
    static double values[] = {-2.0, -1.5, 3.0, 3.0, 4.0, 10.0, 10.5};
    const pdmc_distribution d = {.kind = PDMC_EMPIRICAL, .count = 7, .values = values, UNCUT};
    for (int k = 1; k < 100; k++) {
        const double want = gsl_stats_quantile_from_sorted_data(values, 1, 7, k / 100.0);
        CHECK_NEAR(pdmc_distribution_value(&d, gsl_cdf_ugaussian_Pinv(k / 100.0)), want, 1e-12);
    }
    CHECK_NEAR(pdmc_distribution_lower_tail(&d, 2.999999999), 1.0 / 3.0, 1e-9);
    CHECK_NEAR(pdmc_distribution_lower_tail(&d, 3.0), 0.5, 1e-15);
    CHECK_NEAR(pdmc_distribution_upper_tail(&d, 10.5), 0.0, 0.0);
    CHECK_NEAR(pdmc_distribution_lower_tail(&d, -2.0), 0.0, 0.0);
}

/// Kolmogorov's p of a right sampler is below 1e-4 once in 10^4.
static void samples_have_the_distribution_asked_for(void **state)
{
    (void)state;
    enum { N = 100000 };
    static double x[N];
    for (int i = 0; i < KNOWN; i++) {
        for (int k = 0; k < N; k++) {
            double u;
            pdmc_random_uniform(2011, PDMC_STREAM_LOAD, (uint64_t)k, (uint64_t)i, 1, &u);
            x[k] = pdmc_distribution_value(&known[i].distribution, pdmc_normal_quantile(u));
        }
        gsl_sort(x, 1, N);
        double distance = 0.0;
        for (int k = 0; k < N; k++) {
            const double p = known[i].tails(&known[i].distribution, x[k]).lower;
            distance = fmax(distance, fmax((k + 1.0) / N - p, p - (double)k / N));
        }
        const double p = pdmc_statistics_kolmogorov(sqrt(N) * distance);
        if (!(p > 1e-4)) fail_msg("distribution %d: p = %g", i, p);
    }
}

static void what_is_no_distribution_is_refused(void **state)
{
    (void)state;
    static double descending[] = {1.0, 0.0}, alike[] = {1.0, 1.0}, missing[] = {1.0, NAN};
    const pdmc_distribution wrong[] = {
        {.kind = PDMC_DISTRIBUTIONS, .scale = 1.0, UNCUT},
        {.kind = (pdmc_distribution_kind)-1, .scale = 1.0, UNCUT},
        {.kind = PDMC_NORMAL, .scale = -1.0, UNCUT},
        {.kind = PDMC_NORMAL, .scale = NAN, UNCUT},
        {.kind = PDMC_LOGNORMAL, .location = INFINITY, .scale = 1.0, UNCUT},
        {.kind = PDMC_WEIBULL, .scale = 1.0, .shape = 0.0, UNCUT},
        {.kind = PDMC_GAMMA, .scale = 1.0, .shape = 0.01, UNCUT},
        {.kind = PDMC_GAMMA, .scale = 1.0, .shape = 1e6, UNCUT},
        {.kind = PDMC_BETA, .lower = 0.0, .upper = 1.0, .alpha = 0.0, .beta = 1.0, UNCUT},
        {.kind = PDMC_BETA, .lower = 0.0, .upper = 1.0, .alpha = 1.0, .beta = NAN, UNCUT},
        {.kind = PDMC_UNIFORM, .lower = 1.0, .upper = 0.0, UNCUT},
        {.kind = PDMC_TRIANGULAR, .lower = 0.0, .mode = 2.0, .upper = 1.0, UNCUT},
        {.kind = PDMC_EMPIRICAL, .count = 1, .values = descending, UNCUT},
        {.kind = PDMC_EMPIRICAL, .count = 2, UNCUT},
        {.kind = PDMC_EMPIRICAL, .count = 2, .values = descending, UNCUT},
        {.kind = PDMC_EMPIRICAL, .count = 2, .values = alike, UNCUT},
        {.kind = PDMC_EMPIRICAL, .count = 2, .values = missing, UNCUT},
        {.kind = PDMC_NORMAL, .scale = 1.0, .least = 1.0, .most = 1.0},
        {.kind = PDMC_NORMAL, .scale = 1.0, .least = NAN, .most = 1.0},
        {.kind = PDMC_NORMAL, .scale = 1.0, .least = 50.0, .most = INFINITY},
        {.kind = PDMC_UNIFORM, .lower = 0.0, .upper = 1.0, .least = 2.0, .most = INFINITY},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        CHECK_STATUS(pdmc_distribution_check(&wrong[i]), PDMC_ERR_ARG);
}

static void moments_that_no_distribution_has_are_refused(void **state)
{
    (void)state;
    pdmc_distribution d;
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_LOGNORMAL, 0.0, 0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_WEIBULL, -1.0, 0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_GAMMA, 1.0, 1e-3, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_NORMAL, 0.0, 0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_NORMAL, 1.0, -0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_NORMAL, NAN, 0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_BETA, 1.0, 0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_EMPIRICAL, 1.0, 0.1, &d), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_distribution_by_moments(PDMC_DISTRIBUTIONS, 1.0, 0.1, &d), PDMC_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_normal_quantile_inverts_the_cdf_in_both_tails),
        cmocka_unit_test(the_normal_quantile_is_odd_and_increasing),
        cmocka_unit_test(known_normal_quantiles),
        cmocka_unit_test(mean_is_one_and_variation_as_asked),
        cmocka_unit_test(lognormal_quantiles_have_their_closed_form),
        cmocka_unit_test(a_small_variation_is_not_lost),
        cmocka_unit_test(without_variation_there_is_exactly_one),
        cmocka_unit_test(the_formulas_of_unit_mean_are_kept_to_the_bit),
        cmocka_unit_test(values_have_the_tails_of_their_normal_scores),
        cmocka_unit_test(values_rise_and_stay_finite),
        cmocka_unit_test(quantiles_of_broken_shapes),
        cmocka_unit_test(moments_are_the_integrals_over_z),
        cmocka_unit_test(parameters_by_moments_have_these_moments),
        cmocka_unit_test(an_exponential_variable_is_weibull_and_gamma),
        cmocka_unit_test(negative_means_keep_their_sign),
        cmocka_unit_test(without_spread_every_kind_is_its_mean),
        cmocka_unit_test(an_empirical_distribution_has_the_quantiles_of_its_values),
        cmocka_unit_test(samples_have_the_distribution_asked_for),
        cmocka_unit_test(what_is_no_distribution_is_refused),
        cmocka_unit_test(moments_that_no_distribution_has_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
