// SPDX-License-Identifier: GPL-3.0-or-later

/// The operator itself, of functions that are known everywhere: what finite elements are held against.

#include "base/base_impl.h"
#include "galerkin/kernel.h"

#include <gsl/gsl_integration.h>
#include <math.h>

enum { RADII = 16, DIRECTIONS = 24 };

// The sum of opposite bonds goes with r, so that with c r r^(dimension - 1) the integrand is r^(dimension + 1 - power) times
// an even function: the weight of the first bin. In the others all is analytic.
static pdmc_status radii_of_bin(const pdmc_scalar_kernel *kernel, int bin, double r[RADII], double weight[RADII])
{
    const int d = kernel->dimension;
    const double from = bin > 0 ? pdmc_kernel_radius(kernel, bin - 1) : 0.0, to = pdmc_kernel_radius(kernel, bin);
    const double power = bin > 0 ? 0.0 : d + 1.0 - kernel->power;
    gsl_integration_fixed_workspace *gauss =
        gsl_integration_fixed_alloc(gsl_integration_fixed_jacobi, RADII, from, to, 0.0, power);
    if (!gauss) return pdmc_raise(PDMC_ERR_NOMEM, "no memory for %d radii", RADII);
    for (int i = 0; i < RADII; i++) {
        r[i] = gsl_integration_fixed_nodes(gauss)[i];
        weight[i] = kernel->scale * kernel->weight[bin] * gsl_integration_fixed_weights(gauss)[i] *
                    pow(r[i], bin > 0 ? d - kernel->power : -1.0);
    }
    gsl_integration_fixed_free(gauss);
    return PDMC_OK;
}

pdmc_status pdmc_horizon_points(const pdmc_scalar_kernel *kernel, pdmc_area_rule *points)
{
    pdmc_status status = PDMC_OK;
    const int directions = kernel->dimension == 1 ? 1 : DIRECTIONS;
    pdmc_area_rule made = {0};
    *points = made;
    PDMC_NEW(made.x, 2 * kernel->bins * RADII * directions);
    PDMC_NEW(made.weight, kernel->bins * RADII * directions);
    for (int bin = 0; bin < kernel->bins; bin++) {
        double r[RADII], weight[RADII];
        PDMC_TRY(radii_of_bin(kernel, bin, r, weight));
        for (int i = 0; i < RADII; i++)
            for (int k = 0; k < directions; k++) {
                const double angle = M_PI * k / directions;
                made.x[2 * made.count] = r[i] * cos(angle);
                made.x[2 * made.count + 1] = kernel->dimension == 1 ? 0.0 : r[i] * sin(angle);
                made.weight[made.count++] = weight[i] * (kernel->dimension == 1 ? 1.0 : M_PI / directions);
            }
    }
    *points = made;
    made = (pdmc_area_rule){0};
done:
    pdmc_area_rule_clear(&made);
    return status;
}

double pdmc_law_operator(const pdmc_area_rule *points, const pdmc_bond_law *law, pdmc_scalar_function *u,
                     const void *context, const double x[])
{
    double sum = 0.0;
    const double here = u(context, x);
    for (int p = 0; p < points->count; p++) {
        const double *xi = &points->x[2 * p], r = hypot(xi[0], xi[1]);
        const double ahead = u(context, (double[2]){x[0] + xi[0], x[1] + xi[1]});
        const double behind = u(context, (double[2]){x[0] - xi[0], x[1] - xi[1]});
        sum += points->weight[p] *
               (pdmc_law_at(law, (ahead - here) / r).force + pdmc_law_at(law, (behind - here) / r).force);
    }
    return sum;
}
