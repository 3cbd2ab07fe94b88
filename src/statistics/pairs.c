// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/random.h"
#include "pdmc/statistics.h"

#include <math.h>

/// Fisher's: atanh of a correlation is nearly normal with the deviation 1 / sqrt(n - 3).
static pdmc_estimate correlation(size_t n, const double x[], const double y[], double confidence)
{
    pdmc_estimate mean[2], deviation[2], r = {NAN, NAN, NAN};
    pdmc_statistics_moments(n, x, confidence, &mean[0], &deviation[0]);
    pdmc_statistics_moments(n, y, confidence, &mean[1], &deviation[1]);
    if (!(deviation[0].value > 0.0 && deviation[1].value > 0.0)) return r;
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        sum += (x[i] - mean[0].value) / deviation[0].value * ((y[i] - mean[1].value) / deviation[1].value);
    r.value = fmax(-1.0, fmin(sum / (double)(n - 1), 1.0));
    if (n <= 3) return r;
    const double width = pdmc_normal_quantile(0.5 + 0.5 * confidence) / sqrt((double)n - 3.0), z = atanh(r.value);
    r.lower = tanh(z - width);
    r.upper = tanh(z + width);
    return r;
}

static double relative_difference(double x, double y)
{
    const double size = 0.5 * fabs(x) + 0.5 * fabs(y);
    return size > 0.0 ? (y - x) / size : 0.0;
}

pdmc_status pdmc_statistics_pairs(size_t n, const double x[], const double y[], double confidence, pdmc_pairs *pairs)
{
    pdmc_status status = PDMC_OK;
    pdmc_estimate spread;
    double *d = NULL;
    *pairs = (pdmc_pairs){.count = n};
    PDMC_NEW(d, n);
    for (size_t i = 0; i < n; i++) {
        d[i] = relative_difference(x[i], y[i]);
        if (fabs(d[i]) > fabs(d[pairs->largest_at])) pairs->largest_at = i;
    }
    pdmc_statistics_moments(n, d, confidence, &pairs->difference, &spread);
    pairs->largest_difference = n > 0 ? d[pairs->largest_at] : NAN;
    pairs->correlation = correlation(n, x, y, confidence);

done:
    pdmc_free(d);
    return status;
}
