// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/distribution.h"

#include "base/base_impl.h"

#include <lapacke.h>
#include <string.h>

static pdmc_status check_correlation(int n, const double correlation[])
{
    PDMC_REQUIRE(n >= 1, "a copula needs at least one variable, not %d", n);
    for (int i = 0; i < n; i++) {
        PDMC_REQUIRE(correlation[i * n + i] == 1.0, "the correlation of variable %d with itself is %g, not 1", i,
                     correlation[i * n + i]);
        for (int j = 0; j < i; j++)
            PDMC_REQUIRE(correlation[i * n + j] == correlation[j * n + i],
                         "the correlation of variables %d and %d is %g one way and %g the other", j, i,
                         correlation[j * n + i], correlation[i * n + j]);
    }
    return PDMC_OK;
}

pdmc_status pdmc_copula_factor(int n, const double correlation[], double factor[])
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(check_correlation(n, correlation));
    pdmc_blas_prepare();
    memcpy(factor, correlation, (size_t)n * (size_t)n * sizeof *factor);
    // The upper triangle of a matrix stored by columns is the lower one of ours, stored by rows.
    const int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', n, factor, n);
    if (info != 0)
        PDMC_FAIL(PDMC_ERR_ARG,
                  "the correlations contradict each other: those of the first %d of %d variables make no "
                  "positive definite matrix",
                  info, n);
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) factor[i * n + j] = 0.0;
done:
    return status;
}
