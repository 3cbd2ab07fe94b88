// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/certify.h"

#include "pdmc/fracture.h"

#include <math.h>

// The spectral norm of a 2 x 2 matrix with the columns a and b.
static double norm_of(const double a[2], const double b[2])
{
    const double sum = a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1], det = a[0] * b[1] - a[1] * b[0];
    return sqrt(0.5 * (sum + sqrt(fmax(sum * sum - 4.0 * det * det, 0.0))));
}

static double largest_kink_norm(const pdmc_results *results, int tip)
{
    const double mode_1[2] = {1.0, 0.0}, mode_2[2] = {0.0, 1.0};
    double largest = 0.0, a[2], b[2];
    for (int i = 0; i < results->angle_count; i++) {
        const double kink = results->angles[i] - results->tips[tip].direction;
        pdmc_kinked_stress_intensity(kink, mode_1, a);
        pdmc_kinked_stress_intensity(kink, mode_2, b);
        largest = fmax(largest, norm_of(a, b));
    }
    return largest;
}

// |e| in the energy of the mean operator, of which that of the sample is at least the smallest share of a term.
static double error_at_mean(const pdmc_affine *reduced, const pdmc_draw *draw, double error)
{
    double least = 0.0;
    for (int m = 0; m < reduced->terms; m++) least = fmin(least, draw->xi[m]);
    return error / sqrt(1.0 + least);
}

static double largest_stiffness(const pdmc_results *results, const pdmc_draw *draw)
{
    double largest = 0.0;
    for (int d = 0; d < results->tip_count * results->angle_count; d++)
        largest = fmax(largest, draw->direction_modulus[d]);
    return largest;
}

double pdmc_certify_root_energy(const pdmc_problem *problem, const pdmc_affine *reduced, const pdmc_results *results,
                                const pdmc_draw *draw, pdmc_measure measure, double error)
{
    if (!isfinite(error)) return INFINITY;
    if (measure == PDMC_MEASURE_BOND) return reduced->crossing_bound * error * sqrt(largest_stiffness(results, draw));
    // G = |F E_s K|^2 / (E_s E') with E_s the sample's modulus over the mean's
    const double plane_modulus = draw->effective_modulus * pdmc_plane_modulus(&problem->material);
    double largest = 0.0;
    for (int t = 0; t < results->tip_count; t++) {
        const double *bound = &reduced->intensity_bound[2 * t];
        largest = fmax(largest, largest_kink_norm(results, t) * hypot(bound[0], bound[1]));
    }
    return draw->effective_modulus * largest * error_at_mean(reduced, draw, error) / sqrt(plane_modulus);
}

static double largest_energy(const pdmc_results *results, pdmc_measure measure, int sample, int tip)
{
    return fmax(results->largest_energy[measure][(size_t)sample * (size_t)results->tip_count + (size_t)tip], 0.0);
}

double pdmc_certify_relative(const pdmc_results *results, pdmc_measure measure, int sample, double delta)
{
    double worst = 0.0;
    for (int t = 0; t < results->tip_count; t++) {
        const double ratio = delta / sqrt(largest_energy(results, measure, sample, t));
        worst = fmax(worst, 2.0 * ratio + ratio * ratio);
    }
    return worst;
}

bool pdmc_certify_is_in_doubt(const pdmc_results *results, int sample, double delta)
{
    for (int t = 0; t < results->tip_count; t++) {
        const double root = sqrt(largest_energy(results, results->measure, sample, t));
        if (fabs(root - sqrt(results->sample_fracture_energy[sample])) <= delta) return true;
    }
    return false;
}
