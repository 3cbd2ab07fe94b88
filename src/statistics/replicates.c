// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/hall.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <math.h>

/// With fewer events, or fewer samples without, the replicates' counts are too small for what their spread would tell.
enum { FEWEST = 5 };

/// Sample i belongs to replicate i % replicates.
typedef struct {
    size_t n, replicates;
    double confidence;
} plan;

typedef double term_fn(const void *data, size_t i);

static double student(const plan *p)
{
    if (p->replicates < 2) return NAN;
    return gsl_cdf_tdist_Qinv(0.5 * (1.0 - p->confidence), (double)p->replicates - 1.0);
}

static double mean_of(const plan *p, term_fn *term, const void *data)
{
    double sum = 0.0;
    for (size_t i = 0; i < p->n; i++) sum += term(data, i);
    return sum / (double)p->n;
}

static double replicate_mean(const plan *p, term_fn *term, const void *data, size_t replicate)
{
    double sum = 0.0, count = 0.0;
    for (size_t i = replicate; i < p->n; i += p->replicates, count++) sum += term(data, i);
    return sum / count;
}

/// The variance of the mean of all samples from the spread of the replicates' means about it, and the skewness of their
/// mean; NaN where replicates are too few.
typedef struct {
    double variance, skewness;
} spread;

static spread spread_of(const plan *p, term_fn *term, const void *data, double mean)
{
    const double r = (double)p->replicates;
    double squares = 0.0, cubes = 0.0;
    if (p->replicates < 2 || p->n < p->replicates) return (spread){NAN, NAN};
    for (size_t k = 0; k < p->replicates; k++) {
        const double d = replicate_mean(p, term, data, k) - mean;
        squares += d * d;
        cubes += d * d * d;
    }
    const double variance = squares / (r * (r - 1.0)), third = cubes / (r * (r - 1.0) * (r - 2.0));
    return (spread){variance, third / (variance * sqrt(variance))};
}

/// How far the interval of a mean reaches to either side: on each the farther of Student's and Hall's bounds.
typedef struct {
    double below, above;
} reach;

static reach reach_of(const plan *p, spread s)
{
    const double t = student(p), error = sqrt(s.variance);
    return (reach){error * fmax(t, pdmc_hall_inverse(s.skewness, t)),
                   error * fmax(t, -pdmc_hall_inverse(s.skewness, -t))};
}

/// Samples in units of `unit` about `centre`.
typedef struct {
    const double *x;
    double centre, unit;
} scaled;

static double deviation_term(const void *data, size_t i)
{
    const scaled *s = data;
    return (s->x[i] - s->centre) / s->unit;
}

static double square_term(const void *data, size_t i)
{
    return gsl_pow_2(deviation_term(data, i));
}

/// sigma^2 = E (x - m)^2 - (E x - m)^2 + var m, of which the second is 0 for the m of all samples.
static pdmc_estimate deviation_of(const plan *p, const scaled *s, double variance_of_m)
{
    const double square = mean_of(p, square_term, s);
    const double variance = square + (isfinite(variance_of_m) ? variance_of_m : square / ((double)p->n - 1.0));
    const reach r = reach_of(p, spread_of(p, square_term, s, square));
    const double value = s->unit * sqrt(variance);
    return (pdmc_estimate){value, value * exp(-0.5 * r.below / variance), value * exp(0.5 * r.above / variance)};
}

static double largest_deviation(const plan *p, const double x[], double centre)
{
    double largest = 0.0;
    for (size_t i = 0; i < p->n; i++) largest = fmax(largest, fabs(x[i] - centre));
    return largest;
}

void pdmc_statistics_replicates_moments(size_t n, const double x[], size_t replicates, double confidence,
                                        pdmc_estimate *mean, pdmc_estimate *deviation)
{
    const plan p = {n, replicates, confidence};
    pdmc_statistics_moments(n, x, confidence, mean, deviation); // where there is no spread, all there is to say
    if (n < 2 || !(deviation->value > 0.0)) return;
    const scaled s = {x, mean->value, largest_deviation(&p, x, mean->value)};
    const spread means = spread_of(&p, deviation_term, &s, 0.0);
    const reach r = reach_of(&p, means);
    *mean = (pdmc_estimate){mean->value, mean->value - s.unit * r.below, mean->value + s.unit * r.above};
    *deviation = deviation_of(&p, &s, means.variance);
}

static double event_term(const void *data, size_t i)
{
    return ((const bool *)data)[i] ? 1.0 : 0.0;
}

static double below_term(const void *data, size_t i)
{
    const scaled *s = data;
    return s->x[i] <= s->centre ? 1.0 : 0.0;
}

/// Whether the replicates can tell how far the share of an event spreads.
static bool has_spread(const plan *p, double share)
{
    const double n = (double)p->n;
    return p->replicates > 1 && p->n >= p->replicates && n * fmin(share, 1.0 - share) > FEWEST - 0.5;
}

/// t^2 times the variance of the share, in units of share (1 - share): about t^2 / n of independent samples.
static double relative_variance(const plan *p, term_fn *event, const void *data, double share)
{
    return gsl_pow_2(student(p)) * spread_of(p, event, data, share).variance / (share * (1.0 - share));
}

/// Replicates that all count the same number of events do not know its mean from one that differs by what R trials
/// without a hit leave possible.
static double least_half_width(const plan *p)
{
    const double r = (double)p->replicates;
    return (1.0 - pow(0.5 * (1.0 - p->confidence), 1.0 / r)) * r / (double)p->n;
}

/// The p with (share - p)^2 <= c p (1 - p): Wilson's interval, of a variance that the replicates have told.
static pdmc_estimate wilson(double share, double c, double least)
{
    const double middle = (share + 0.5 * c) / (1.0 + c);
    const double half_width = sqrt(c * share * (1.0 - share) + 0.25 * c * c) / (1.0 + c);
    return (pdmc_estimate){share, fmax(0.0, fmin(middle - half_width, share - least)),
                           fmin(1.0, fmax(middle + half_width, share + least))};
}

pdmc_estimate pdmc_statistics_replicates_proportion(size_t n, const bool event[], size_t replicates, double confidence)
{
    const plan p = {n, replicates, confidence};
    const double share = mean_of(&p, event_term, event);
    if (!has_spread(&p, share)) return pdmc_statistics_proportion((size_t)lround(share * (double)n), n, confidence);
    return wilson(share, relative_variance(&p, event_term, event, share), least_half_width(&p));
}

/// The order statistics between which the count of samples below the quantile lies where it is within half_width of p.
static pdmc_estimate between_ranks(size_t n, const double sorted[], double value, double p, double half_width)
{
    const double lower = ceil((double)n * (p - half_width)), upper = floor((double)n * (p + half_width)) + 1.0;
    return (pdmc_estimate){.value = value,
                           .lower = lower >= 1.0 ? fmin(value, sorted[(size_t)lower - 1]) : -INFINITY,
                           .upper = upper <= (double)n ? fmax(value, sorted[(size_t)upper - 1]) : INFINITY};
}

pdmc_estimate pdmc_statistics_replicates_quantile(size_t n, const double x[], const double sorted[], size_t replicates,
                                                  double p, double confidence)
{
    const plan design = {n, replicates, confidence};
    const pdmc_estimate pooled = pdmc_statistics_quantile(n, sorted, p, confidence);
    const scaled s = {x, pooled.value, 1.0};
    const double share = mean_of(&design, below_term, &s);
    if (!has_spread(&design, share) || !has_spread(&design, p)) return pooled;
    const double c = relative_variance(&design, below_term, &s, share);
    return between_ranks(n, sorted, pooled.value, p, fmax(sqrt(c * p * (1.0 - p)), least_half_width(&design)));
}
