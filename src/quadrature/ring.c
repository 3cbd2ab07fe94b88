// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "base/base_impl.h"

#include <gsl/gsl_integration.h>
#include <math.h>

// Gauss-Jacobi points of the weight r^power dr = s^((power - 1) / 2) ds / 2 in s = (r / radius)^2.
static pdmc_status gauss_radii(int rings, int power, double radius, double r[])
{
    gsl_integration_fixed_workspace *rule =
        gsl_integration_fixed_alloc(gsl_integration_fixed_jacobi, (size_t)rings, 0.0, 1.0, 0.0, 0.5 * (power - 1));
    if (!rule) return pdmc_raise(PDMC_ERR_NOMEM, "out of memory: Gauss rule of %d rings", rings);
    const double *s = gsl_integration_fixed_nodes(rule);
    for (int q = 0; q < rings; q++) r[q] = radius * sqrt(s[q]);
    gsl_integration_fixed_free(rule);
    return PDMC_OK;
}

// The Lagrange polynomial in r^2 that is 1 at radius q and 0 at the others.
static double lagrange(const pdmc_ring_rule *rule, int q, double r)
{
    double product = 1.0;
    const double rq = rule->radius[q];
    for (int k = 0; k < rule->rings; k++) {
        const double rk = rule->radius[k];
        if (k != q) product *= (r - rk) * (r + rk) / ((rq - rk) * (rq + rk));
    }
    return product;
}

// r^(power - 2) r^2 / r_q^2 lagrange_q has degree power + 2 (rings - 1) in r, which these Gauss points integrate
// exactly.
static pdmc_status fill_weights(pdmc_ring_rule *rule, int power, double radius)
{
    enum { MAX_POINTS = PDMC_MAX_RINGS + 8 };
    double x[MAX_POINTS], w[MAX_POINTS];
    const int points = rule->rings + (power + 1) / 2;
    for (int b = 0; b < rule->bins; b++) {
        pdmc_status status = pdmc_gauss_legendre(points, radius * b / rule->bins, radius * (b + 1) / rule->bins, x, w);
        if (status != PDMC_OK) return status;
        double *weight = &rule->weight[(size_t)b * (size_t)rule->rings];
        for (int q = 0; q < rule->rings; q++) {
            const double rq2 = rule->radius[q] * rule->radius[q];
            for (int i = 0; i < points; i++) weight[q] += w[i] * pow(x[i], power) / rq2 * lagrange(rule, q, x[i]);
            rule->mean[q] += weight[q];
        }
    }
    return PDMC_OK;
}

pdmc_status pdmc_ring_rule_create(int rings, int bins, int power, double radius, pdmc_ring_rule *rule)
{
    *rule = (pdmc_ring_rule){0};
    PDMC_REQUIRE(1 <= rings && rings <= PDMC_MAX_RINGS, "%d rings are not in [1, %d]", rings, PDMC_MAX_RINGS);
    PDMC_REQUIRE(bins >= 1, "%d bins: at least one is needed", bins);
    PDMC_REQUIRE(2 <= power && power <= 8, "power %d is not in [2, 8]", power);
    PDMC_REQUIRE(radius > 0.0, "radius %g is not positive", radius);

    pdmc_status status = PDMC_OK;
    rule->rings = rings;
    rule->bins = bins;
    PDMC_NEW(rule->weight, rings * bins);
    PDMC_TRY(gauss_radii(rings, power, radius, rule->radius));
    PDMC_TRY(fill_weights(rule, power, radius));
done:
    if (status != PDMC_OK) pdmc_ring_rule_clear(rule);
    return status;
}

void pdmc_ring_rule_clear(pdmc_ring_rule *rule)
{
    pdmc_free(rule->weight);
    *rule = (pdmc_ring_rule){0};
}
