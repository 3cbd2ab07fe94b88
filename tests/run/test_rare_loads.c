// SPDX-License-Identifier: GPL-3.0-or-later

/// Rare growth under loads that vary side by side: a plane of two lognormal loads, whose limit is found by superposition.

#include "run/studies.h"

#include "pdmc/fracture.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

enum { DIRECTIONS = 12, MODES = 2 };

static const double top_deviation = 0.15, right_deviation = 0.4; // of the logarithms; medians 1 and 0.5
static const double fracture_energy = 3.5, modulus = 1.5;

// An inclined crack; the bottom and the left side hold what the others pull.
static void read_loaded(const char *loads, const char *random, pdmc_study *study)
{
    char text[2048];
    snprintf(text, sizeof text,
             "plate = { width = 4.0; height = 4.0; };\n"
             "material = { youngs_modulus = %g; fracture_energy = %g; };\n"
             "cracks = ( { name = \"c\"; from = [-0.4, -0.3]; to = [0.4, 0.3]; } );\n"
             "supports = ( { side = \"bottom\"; y = 0.0; }, { side = \"left\"; x = 0.0; } );\n"
             "solver = { spacing = 0.5; };\n"
             "energy = { tips = [\"c.to\"]; angles = %d; measure = \"griffith\"; };\n"
             "loads = ( %s );\n%s\n",
             modulus, fracture_energy, DIRECTIONS, loads, random);
    CHECK_OK(read_text(text, study));
}

#define TOP "{ side = \"top\"; traction = [0.0, 1.0]; }"
#define RIGHT "{ side = \"right\"; traction = [0.5, 0.0]; }"

static void intensities_of(const char *load, double K[MODES], double *direction)
{
    pdmc_study study;
    pdmc_results r;
    read_loaded(load, "sampling = { samples = 1; };", &study);
    CHECK_OK(pdmc_run(&study, &(pdmc_run_options){.threads = 1}, &r));
    memcpy(K, r.tips[0].stress_intensity, MODES * sizeof *K);
    *direction = r.tips[0].direction;
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

typedef struct {
    double top[MODES], right[MODES], direction; // K of each load alone, and straight ahead
} plate;

// The largest of Griffith's energies of a kink over the fracture energy.
static double growth_of(const plate *p, double top, double right)
{
    double largest = 0.0, kinked[MODES];
    const double K[MODES] = {top * p->top[0] + right * p->right[0], top * p->top[1] + right * p->right[1]};
    for (int a = 0; a < DIRECTIONS; a++) {
        pdmc_kinked_stress_intensity(2.0 * M_PI * a / DIRECTIONS - p->direction, K, kinked);
        largest = fmax(largest, (pow(fmax(kinked[0], 0.0), 2.0) + kinked[1] * kinked[1]) / modulus);
    }
    return largest / fracture_energy;
}

// The normal variable of the top load at which growth begins; more load is more growth.
static double limit_of(const plate *p, double right)
{
    double low = -10.0, high = 20.0;
    for (int k = 0; k < 60; k++) {
        const double middle = 0.5 * (low + high);
        *(growth_of(p, exp(top_deviation * middle), right) > 1.0 ? &high : &low) = middle;
    }
    return high;
}

// The trapezoidal rule, which is exact to rounding for what is smooth and falls off on either side; the limit has kinks where
// another direction becomes the largest, so that it is exact to 1e-6.
static double probability_of(const plate *p)
{
    const double h = 0.02;
    double sum = 0.0;
    for (int k = -400; k <= 400; k++)
        sum += h * gsl_ran_ugaussian_pdf(k * h) * gsl_cdf_ugaussian_Q(limit_of(p, exp(right_deviation * k * h)));
    return sum;
}

static void both_methods_have_the_integral(void **state)
{
    (void)state;
    plate p;
    pdmc_study study;
    pdmc_results r;
    intensities_of(TOP, p.top, &p.direction);
    intensities_of(RIGHT, p.right, &p.direction);
    read_loaded(
        TOP ", " RIGHT,
        "random = ( { quantity = \"load_top\"; distribution = \"lognormal\"; median = 1; log_deviation = 0.15; },\n"
        "           { quantity = \"load_right\"; distribution = \"lognormal\"; median = 1; log_deviation = 0.4; } );\n"
        "sampling = { samples = 64; };\n"
        "reliability = { method = \"both\"; variation = 0.08; };",
        &study);
    CHECK_OK(pdmc_run(&study, &(pdmc_run_options){.threads = 2}, &r));
    for (int s = 0; s < r.sample_count; s++) {
        const double *K = &r.stress_intensity[MODES * s];
        const double det = p.top[0] * p.right[1] - p.top[1] * p.right[0];
        const double top = (K[0] * p.right[1] - K[1] * p.right[0]) / det,
                     right = (p.top[0] * K[1] - p.top[1] * K[0]) / det;
        CHECK_NEAR(r.largest_energy[PDMC_MEASURE_GRIFFITH][s] / fracture_energy, growth_of(&p, top, right), 1e-9);
    }
    const double exact = probability_of(&p);
    assert_int_equal(r.reliability.record_count, 2);
    for (int m = 0; m < 2; m++) {
        const pdmc_reliability_record *record = &r.reliability.records[m];
        print_message("%s: %.4e [%.4e, %.4e], exact %.4e, %.0f points\n", record->name, record->found.probability.value,
                      record->found.probability.lower, record->found.probability.upper, exact, record->evaluations);
        assert_true(record->complete);
        CHECK_NEAR(record->found.probability.value, exact, 4.0 * record->found.variation * exact);
    }
    assert_true(exact < 1e-3);
    assert_string_equal(r.reliability.groups[0].name, "load_right");
    assert_string_equal(r.reliability.groups[1].name, "load_top");
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_methods_have_the_integral),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
