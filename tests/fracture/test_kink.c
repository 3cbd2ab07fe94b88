// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/fracture.h"

#include "check.h"

static const double pi = 3.14159265358979323846;
static const double degree = 0.017453292519943295;

static void a_straight_crack_keeps_its_stress_intensity(void **state)
{
    (void)state;
    const double K[2] = {1.3, -0.4};
    double k[2];
    pdmc_kinked_stress_intensity(0.0, K, k);
    for (int i = 0; i < 2; i++) CHECK_NEAR(k[i], K[i], 0.0);
    CHECK_NEAR(pdmc_griffith_energy(0.0, K, 2.0), (1.69 + 0.16) / 2.0, 1e-15);
    pdmc_kinked_stress_intensity(2.0 * pi, K, k); // a full turn is none
    for (int i = 0; i < 2; i++) CHECK_NEAR(k[i], K[i], 1e-14);
}

// The first powers of the kink follow from the stress about the tip: k_I = K_I - 3/2 phi K_II, k_II = K_II + phi K_I /
// 2.
static void small_kinks_see_the_tip_field(void **state)
{
    (void)state;
    const double phi = 1e-4, I[2] = {1.0, 0.0}, II[2] = {0.0, 1.0};
    double k[2];
    pdmc_kinked_stress_intensity(phi, I, k);
    CHECK_NEAR((1.0 - k[0]) / (phi * phi), 0.375, 1e-6); // cos^3(phi / 2), exact to this order
    CHECK_NEAR(k[1] / phi, 0.5, 1e-6);
    pdmc_kinked_stress_intensity(phi, II, k);
    CHECK_NEAR(k[0] / phi, -1.5, 1e-6);
}

// A mirrored load turns the kink to the other side.
static void a_mirrored_load_mirrors_the_kink(void **state)
{
    (void)state;
    const double K[2] = {1.0, 0.7}, mirrored[2] = {1.0, -0.7};
    for (int angle = -175; angle <= 175; angle += 25) {
        double k[2], m[2];
        pdmc_kinked_stress_intensity(angle * degree, K, k);
        pdmc_kinked_stress_intensity(-angle * degree, mirrored, m);
        CHECK_NEAR(m[0], k[0], 1e-14);
        CHECK_NEAR(m[1], -k[1], 1e-14);
    }
}

// Known figures of a pure mode II: growth at the angle of k_II = 0, -77.3 degrees, and of the largest energy, -75.6
// degrees (Amestoy & Leblond 1992).
static void pure_mode_two_turns_by_77_degrees(void **state)
{
    (void)state;
    const double II[2] = {0.0, 1.0};
    double low = -1.5, high = -1.2, k[2];
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        pdmc_kinked_stress_intensity(middle, II, k);
        if (k[1] < 0.0) low = middle;
        else high = middle;
    }
    CHECK_NEAR(low / degree, -77.3, 0.1);
    double best = 0.0, largest = 0.0;
    for (double angle = -90.0; angle < 0.0; angle += 0.05) {
        const double G = pdmc_griffith_energy(angle * degree, II, 1.0);
        if (G > largest) {
            largest = G;
            best = angle;
        }
    }
    CHECK_NEAR(best, -75.6, 0.3);
    printf("  pure mode II: largest G %.4f of straight growth's, at %.2f degrees\n", largest, best);
    CHECK_NEAR(pdmc_tangential_stress_direction(II) / degree, -70.53, 0.01); // acos(1/3)
}

static void the_energy_is_continuous_and_ends_at_zero(void **state)
{
    (void)state;
    const double K[2] = {1.0, 0.3};
    double previous = pdmc_griffith_energy(-pi, K, 1.0);
    CHECK_NEAR(previous, 0.0, 1e-12);
    for (int i = -1799; i <= 1800; i++) {
        const double G = pdmc_griffith_energy(0.1 * i * degree, K, 1.0);
        CHECK_NEAR(G, previous, 0.01); // a step of 0.1 degrees
        previous = G;
    }
    CHECK_NEAR(previous, 0.0, 1e-12);
}

static void a_closed_kink_releases_no_mode_one_energy(void **state)
{
    (void)state;
    const double pressed[2] = {-1.0, 0.0};
    CHECK_NEAR(pdmc_griffith_energy(0.0, pressed, 1.0), 0.0, 0.0);
    CHECK_NEAR(pdmc_tangential_stress_direction((const double[2]){0.0, 0.0}), 0.0, 0.0);
    CHECK_NEAR(pdmc_tangential_stress_direction((const double[2]){2.0, 0.0}), 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_crack_keeps_its_stress_intensity),
        cmocka_unit_test(small_kinks_see_the_tip_field),
        cmocka_unit_test(a_mirrored_load_mirrors_the_kink),
        cmocka_unit_test(pure_mode_two_turns_by_77_degrees),
        cmocka_unit_test(the_energy_is_continuous_and_ends_at_zero),
        cmocka_unit_test(a_closed_kink_releases_no_mode_one_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
