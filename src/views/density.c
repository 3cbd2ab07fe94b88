// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/density.h"

#include "base/base_impl.h"
#include "pdmc/statistics.h"
#include "views/views_impl.h"

#include <gsl/gsl_sort.h>
#include <math.h>

// A result file may come from anybody: what is not finite is left out.
static size_t gather(const pdmc_results *r, pdmc_measure measure, size_t at, double x[])
{
    const size_t stride = pdmc_place(r, r->tip_count, 0);
    size_t count = 0;
    for (size_t s = 0; s < (size_t)r->kept_count; s++) {
        const double energy = r->energy[measure][s * stride + at];
        if (r->failure[s] == PDMC_SAMPLE_OK && isfinite(energy)) x[count++] = energy;
    }
    return count;
}

pdmc_status pdmc_view_density(const pdmc_results *r, pdmc_measure measure, size_t at, size_t points,
                              const double energy[], pdmc_estimate density[])
{
    pdmc_status status = PDMC_OK;
    double *x = NULL;
    for (size_t i = 0; i < points; i++) density[i] = (pdmc_estimate){NAN, NAN, NAN};
    PDMC_NEW(x, r->kept_count);
    const size_t count = gather(r, measure, at, x);
    if (count == 0) goto done;
    gsl_sort(x, 1, count);
    const double bandwidth = pdmc_statistics_bandwidth(count, x);
    if (!(bandwidth > 0.0 && isfinite(bandwidth))) goto done;
    PDMC_TRY(pdmc_statistics_kernel_density(count, x, bandwidth, x[0] >= 0.0, r->confidence, points, energy, density));

done:
    pdmc_free(x);
    return status;
}
