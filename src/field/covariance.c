// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "field/field_impl.h"

#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_gamma.h>
#include <math.h>

static double matern(double nu, double s)
{
    const double log_value = log(2.0) * (1.0 - nu) - gsl_sf_lngamma(nu) + nu * log(s) + gsl_sf_bessel_lnKnu(nu, s);
    return fmin(exp(log_value), 1.0);
}

double pdmc_covariance_at(const pdmc_covariance *covariance, double r)
{
    const double nu = covariance->smoothness, s = r / covariance->length;
    if (r == 0.0) return 1.0;
    switch (covariance->kind) {
    case PDMC_COVARIANCE_EXPONENTIAL: return exp(-s);
    case PDMC_COVARIANCE_GAUSSIAN: return exp(-s * s);
    case PDMC_COVARIANCE_MATERN: return matern(nu, sqrt(2.0 * nu) * s);
    }
    return NAN;
}

pdmc_status pdmc_covariance_check(const pdmc_covariance *covariance)
{
    const bool matern_kind = covariance->kind == PDMC_COVARIANCE_MATERN;
    PDMC_REQUIRE(covariance->kind <= PDMC_COVARIANCE_MATERN, "no covariance of kind %d", (int)covariance->kind);
    PDMC_REQUIRE(covariance->length > 0.0 && isfinite(covariance->length), "a correlation length of %g",
                 covariance->length);
    PDMC_REQUIRE(!matern_kind || (covariance->smoothness > 0.0 && isfinite(covariance->smoothness)),
                 "a smoothness of %g", covariance->smoothness);
    return PDMC_OK;
}
