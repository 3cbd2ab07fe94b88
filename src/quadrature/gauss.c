// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "base/base_impl.h"

#include <gsl/gsl_integration.h>

pdmc_status pdmc_gauss_legendre(int n, double lower, double upper, double x[], double w[])
{
    PDMC_REQUIRE(n >= 1, "a Gauss rule needs at least one point, not %d", n);
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc((size_t)n);
    if (!table) return pdmc_raise(PDMC_ERR_NOMEM, "out of memory: Gauss rule of %d points", n);
    for (int i = 0; i < n; i++) gsl_integration_glfixed_point(lower, upper, (size_t)i, &x[i], &w[i], table);
    gsl_integration_glfixed_table_free(table);
    return PDMC_OK;
}
