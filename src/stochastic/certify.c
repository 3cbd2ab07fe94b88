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

static double largest_stiffness(const pdmc_results *results, const pdmc_draw *draw)
{
    double largest = 0.0;
    for (int d = 0; d < results->tip_count * results->angle_count; d++)
        largest = fmax(largest, draw->direction_modulus[d]);
    return largest;
}

// The largest c(r) of the rings of the energy over the mean.
static double largest_ring(const pdmc_affine *full, const pdmc_draw *draw)
{
    double largest = 0.0;
    for (int q = 0; q < full->rings; q++) {
        double mean = 0.0;
        for (int b = 0; b < full->bins; b++) mean += full->ring_weight[b * full->rings + q];
        if (mean > 0.0) largest = fmax(largest, draw->ring_weight[q] / mean);
    }
    return largest;
}

// With a field the bound is in the energy of the mean; without it in that of the sample's c(r), which is the effective
// modulus that was divided out times that of K(xi).
static double bond_root_energy(const pdmc_block *block, int s, const pdmc_results *results)
{
    const pdmc_affine *full = block->variables->model;
    const pdmc_draw *draw = &block->drawn.draw[s];
    const double error = full->crossing_bound * block->bound.error[s];
    if (!(full->crossing_bound > 0.0)) return INFINITY;
    if (!full->field) return error * sqrt(draw->effective_modulus);
    const double stiffness = largest_stiffness(results, draw) * largest_ring(full, draw);
    return error * sqrt(stiffness / block->bound.coercivity[s]);
}

// G = |F m K|^2 / (m E'), m the sample's modulus at the tip over the mean's
static void griffith_root_energies(const pdmc_block *block, int count, const pdmc_results *results, double delta[])
{
    const double plane_modulus = pdmc_plane_modulus(&block->problem->material);
    for (int s = 0; s < count; s++) delta[s] = 0.0;
    for (int t = 0; t < results->tip_count; t++) {
        const double norm = largest_kink_norm(results, t);
        for (int s = 0; s < count; s++) {
            const double *error = &block->bound.intensity[2 * (s * results->tip_count + t)];
            const double scale = sqrt(block->drawn.draw[s].tip_modulus[t] / plane_modulus);
            delta[s] = fmax(delta[s], scale * norm * hypot(error[0], error[1]));
        }
    }
}

void pdmc_certify_root_energies(const pdmc_block *block, int count, const pdmc_results *results, pdmc_measure measure,
                                double delta[])
{
    if (measure == PDMC_MEASURE_GRIFFITH) griffith_root_energies(block, count, results, delta);
    for (int s = 0; s < count; s++) {
        if (measure == PDMC_MEASURE_BOND) delta[s] = bond_root_energy(block, s, results);
        if (!isfinite(block->bound.error[s])) delta[s] = INFINITY;
        if (block->failure[s] != PDMC_SAMPLE_OK) delta[s] = 0.0;
    }
}

static double nominal_root(const pdmc_results *results, const double energy[], int tip)
{
    double largest = 0.0;
    for (int a = 0; a < results->angle_count; a++) largest = fmax(largest, energy[tip * results->angle_count + a]);
    return sqrt(largest);
}

void pdmc_certify_goal(const pdmc_variables *variables, const pdmc_results *results, double intensity[],
                       pdmc_reduced_goal *goal)
{
    const double margin = 0.75; // a sample may have less energy than the mean
    const double relative = margin * 0.5 * variables->problem->sampling.energy_tolerance;
    const double plane_modulus = pdmc_plane_modulus(&variables->problem->material);
    const bool is_griffith = variables->problem->energy.measure == PDMC_MEASURE_GRIFFITH;
    double least = INFINITY;
    for (int t = 0; t < results->tip_count; t++) {
        least = fmin(least, nominal_root(results, results->nominal_bond_energy, t));
        intensity[t] = relative * nominal_root(results, results->nominal_griffith_energy, t) * sqrt(plane_modulus) /
                       largest_kink_norm(results, t);
    }
    *goal = (pdmc_reduced_goal){.error = relative * least / variables->model->crossing_bound,
                                .intensity = is_griffith ? intensity : NULL};
}

static size_t place_of(const pdmc_results *results, int sample, int tip)
{
    return (size_t)sample * (size_t)results->tip_count + (size_t)tip;
}

static double largest_energy(const pdmc_results *results, pdmc_measure measure, int sample, int tip)
{
    return fmax(results->largest_energy[measure][place_of(results, sample, tip)], 0.0);
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
        const double toughness = results->sample_fracture_energy[place_of(results, sample, t)];
        if (fabs(root - sqrt(toughness)) <= delta) return true;
    }
    return false;
}
