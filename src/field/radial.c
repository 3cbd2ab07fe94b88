// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "base/base_impl.h"
#include "field/field_impl.h"

#include <lapacke.h>
#include <math.h>

static void fill_correlation(const pdmc_covariance *covariance, double width, int bins, double correlation[])
{
    for (int i = 0; i < bins; i++)
        for (int j = 0; j < bins; j++)
            correlation[i * bins + j] = pdmc_covariance_at(covariance, width * fabs((double)(i - j)));
}

pdmc_status pdmc_radial_modes(const pdmc_covariance *covariance, double radius, int bins, int modes, double factor[],
                              double *retained)
{
    pdmc_status status = pdmc_covariance_check(covariance);
    if (status) return status;
    PDMC_REQUIRE(radius > 0.0 && isfinite(radius), "a radius of %g", radius);
    PDMC_REQUIRE(1 <= bins && 1 <= modes && modes <= bins, "%d modes of %d bins", modes, bins);

    pdmc_blas_prepare();
    double *vector = NULL, *value = NULL;
    PDMC_NEW(vector, (size_t)bins * (size_t)bins); // the correlation, then its eigenvectors, one a row
    PDMC_NEW(value, bins);                         // ascending
    fill_correlation(covariance, radius / bins, bins, vector);
    const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', bins, vector, bins, value);
    if (info) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyevd returned %d", info);

    double kept = 0.0;
    for (int k = 0; k < modes; k++) {
        const double *mode = &vector[(bins - 1 - k) * bins], lambda = fmax(value[bins - 1 - k], 0.0);
        const double scale = sqrt(lambda) * pdmc_field_sign(bins, mode);
        for (int i = 0; i < bins; i++) factor[i * modes + k] = scale * mode[i];
        kept += lambda;
    }
    *retained = kept / bins;

done:
    pdmc_free(value);
    pdmc_free(vector);
    return status;
}
