// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <math.h>

/// Two samples with their means and deviations, in a unit of their own size, so that no square overflows.
typedef struct {
    size_t n, m;
    const double *x, *y;
    bool paired;
    double unit, mean[2], deviation[2];
} two_samples;

/// Variances and covariance of the mean of x and of the mean of e = y - theta x, and the degrees of freedom of the
/// latter's.
typedef struct {
    double xx, xe, ee, freedom;
} scatter;

static scatter scatter_of_pairs(const two_samples *s, double theta)
{
    const double n = (double)s->n, mean = s->mean[1] - theta * s->mean[0];
    scatter v = {.freedom = n - 1.0};
    for (size_t i = 0; i < s->n; i++) {
        const double x = s->x[i] / s->unit - s->mean[0], e = (s->y[i] - theta * s->x[i]) / s->unit - mean;
        v.xx += x * x / (n * (n - 1.0));
        v.xe += x * e / (n * (n - 1.0));
        v.ee += e * e / (n * (n - 1.0));
    }
    return v;
}

/// Welch's degrees of freedom, where the samples are independent.
static scatter scatter_of(const two_samples *s, double theta)
{
    const double n = (double)s->n, m = (double)s->m;
    const double xx = gsl_pow_2(s->deviation[0]) / n, yy = gsl_pow_2(s->deviation[1]) / m, part = theta * theta * xx;
    scatter v = {.xx = xx, .xe = -theta * xx, .ee = yy + part, .freedom = n + m - 2.0};
    if (s->paired) return scatter_of_pairs(s, theta);
    if (v.ee > 0.0) v.freedom = gsl_pow_2(v.ee) / (gsl_pow_2(yy) / (m - 1.0) + gsl_pow_2(part) / (n - 1.0));
    return v;
}

static double student(const scatter *v, double confidence)
{
    return gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), v->freedom);
}

/// Fieller: the ratios theta + d at which the mean of y - (theta + d) x may be zero,
/// d^2 mean_x^2 <= t^2 (ee - 2 d xe + d^2 xx).
static pdmc_estimate ratio_of_means(const two_samples *s, double confidence)
{
    const double theta = s->mean[1] / s->mean[0];
    pdmc_estimate ratio = {theta, -INFINITY, INFINITY};
    if (!isfinite(theta)) return ratio;
    const scatter v = scatter_of(s, theta);
    const double t = student(&v, confidence), square = s->mean[0] * s->mean[0] - t * t * v.xx;
    if (!(square > 0.0)) return ratio; // the mean of x itself may be zero
    const double middle = -t * t * v.xe / square, width = sqrt(middle * middle + t * t * v.ee / square);
    ratio.lower = theta + middle - width;
    ratio.upper = theta + middle + width;
    return ratio;
}

void pdmc_statistics_means(size_t n, const double x[], size_t m, const double y[], bool paired, double confidence,
                           pdmc_estimate *difference, pdmc_estimate *ratio)
{
    pdmc_estimate mean[2], deviation[2];
    *difference = *ratio = (pdmc_estimate){NAN, NAN, NAN};
    if (n < 2 || m < 2 || (paired && n != m)) return;
    pdmc_statistics_moments(n, x, confidence, &mean[0], &deviation[0]);
    pdmc_statistics_moments(m, y, confidence, &mean[1], &deviation[1]);
    two_samples s = {.n = n, .m = m, .x = x, .y = y, .paired = paired};
    for (int k = 0; k < 2; k++) s.unit = fmax(s.unit, fmax(fabs(mean[k].value), deviation[k].value));
    if (s.unit == 0.0) s.unit = 1.0; // nothing but zeros
    for (int k = 0; k < 2; k++) s.mean[k] = mean[k].value / s.unit, s.deviation[k] = deviation[k].value / s.unit;
    const scatter v = scatter_of(&s, 1.0);
    const double centre = s.mean[1] - s.mean[0], half_width = student(&v, confidence) * sqrt(v.ee);
    *difference = (pdmc_estimate){s.unit * centre, s.unit * (centre - half_width), s.unit * (centre + half_width)};
    *ratio = ratio_of_means(&s, confidence);
}
