// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/kernel.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>

double pdmc_kernel_radius(const pdmc_scalar_kernel *kernel, int bin)
{
    return bin + 1 == kernel->bins ? kernel->horizon : kernel->horizon * (bin + 1) / kernel->bins;
}

static double weight_of(const pdmc_scalar_kernel *kernel, int bin)
{
    return bin < kernel->bins ? kernel->weight[bin] : 0.0;
}

double pdmc_kernel_constant(const pdmc_scalar_kernel *kernel, int bin, int m)
{
    const double q = m + kernel->dimension - kernel->power;
    double sum = 0.0;
    for (int i = 0; i < bin; i++)
        sum += (weight_of(kernel, i) - weight_of(kernel, i + 1)) * pow(pdmc_kernel_radius(kernel, i), q);
    return kernel->scale * sum / q;
}

pdmc_status pdmc_scalar_kernel_create(int dimension, double horizon, double power, int bins, const double weight[],
                                      pdmc_scalar_kernel *kernel)
{
    pdmc_scalar_kernel made = {.dimension = dimension, .horizon = horizon, .power = power, .scale = 1.0, .bins = bins};
    double sum = 0.0;
    PDMC_REQUIRE(dimension == 1 || dimension == 2, "a dimension of %d is neither 1 nor 2", dimension);
    PDMC_REQUIRE(horizon > 0.0 && isfinite(horizon), "a horizon of %g is not > 0", horizon);
    PDMC_REQUIRE(0.0 <= power && power < 2.0, "a power of %g is not in [0, 2)", power);
    PDMC_REQUIRE(1 <= bins && bins <= PDMC_KERNEL_BINS, "%d bins are not from 1 to %d", bins, PDMC_KERNEL_BINS);
    for (int i = 0; i < bins; i++) {
        made.weight[i] = weight ? weight[i] : 1.0;
        PDMC_REQUIRE(made.weight[i] >= 0.0 && isfinite(made.weight[i]), "a weight of %g is not >= 0", made.weight[i]);
        sum += made.weight[i];
    }
    PDMC_REQUIRE(sum > 0.0, "all weights of the kernel are zero");
    // int c |xi|^2 over all directions, and 2 for each dimension
    made.scale = dimension / (pdmc_kernel_constant(&made, bins, 2) * (dimension == 1 ? 1.0 : M_PI));
    for (int bin = 0; bin <= bins; bin++)
        for (int m = 0; m < 3; m++)
            if (m + dimension > power) made.constant[bin][m] = pdmc_kernel_constant(&made, bin, m);
    *kernel = made;
    return PDMC_OK;
}

double pdmc_scalar_kernel_at(const pdmc_scalar_kernel *kernel, double r)
{
    if (r >= kernel->horizon) return 0.0;
    const int bin = (int)(r / kernel->horizon * kernel->bins);
    return kernel->scale * kernel->weight[bin] * (kernel->power == 1.0 ? 1.0 / r : pow(r, -kernel->power));
}

enum { PANEL_POINTS = 16 };

// r^-power (1 - cos kr) in one dimension, or pi r times its mean over all directions in two.
static double wave_integrand(const pdmc_scalar_kernel *kernel, double wave_number, double r)
{
    const double kr = wave_number * r, q = 0.25 * kr * kr;
    if (kernel->dimension == 1) return 2.0 * pow(r, -kernel->power) * gsl_pow_2(sin(0.5 * kr));
    // the series where the difference to 1 would lose its digits
    const double rest =
        kr < 0.1 ? q * (1.0 - q / 4.0 * (1.0 - q / 9.0 * (1.0 - q / 16.0))) : 1.0 - gsl_sf_bessel_J0(kr);
    return M_PI * pow(r, 1.0 - kernel->power) * rest;
}

// Panels that halve towards the centre, where the integrand goes with a power of r, and are no longer than half a wave;
// the part that is left goes with the distance from the centre at least.
static double integrate_bin(const pdmc_scalar_kernel *kernel, double wave_number, int bin, const double x[],
                            const double w[])
{
    const double from = bin > 0 ? pdmc_kernel_radius(kernel, bin - 1) : 0.0;
    double sum = 0.0, upper = pdmc_kernel_radius(kernel, bin);
    while (upper > from && upper > 1e-14 * kernel->horizon) {
        const double lower = fmax(from, fmax(0.5 * upper, upper - M_PI / wave_number));
        for (int i = 0; i < PANEL_POINTS; i++)
            sum += (upper - lower) * w[i] * wave_integrand(kernel, wave_number, lower + (upper - lower) * x[i]);
        upper = lower;
    }
    return sum;
}

pdmc_status pdmc_scalar_dispersion(const pdmc_scalar_kernel *kernel, double wave_number, double *lambda)
{
    const double k = fabs(wave_number);
    double x[PANEL_POINTS], w[PANEL_POINTS], sum = 0.0;
    const pdmc_status status = pdmc_gauss_legendre(PANEL_POINTS, 0.0, 1.0, x, w);
    if (status != PDMC_OK) return status;
    for (int bin = 0; bin < kernel->bins && k > 0.0; bin++)
        sum += kernel->weight[bin] * integrate_bin(kernel, k, bin, x, w);
    *lambda = 2.0 * kernel->scale * sum;
    return PDMC_OK;
}
