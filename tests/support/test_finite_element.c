// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/boundary_collocation.h"
#include "support/finite_element.h"

static finite_element_plate tension(double size, double half_length)
{
    return (finite_element_plate){
        .width = size,
        .height = size,
        .tip = {-half_length, half_length},
        .youngs_modulus = 1.0,
        .traction = {[PDMC_SIDE_BOTTOM] = {0.0, -1.0}, [PDMC_SIDE_TOP] = {0.0, 1.0}},
        .refinement = FINITE_ELEMENT_FINE,
    };
}

static void uniform(void **state)
{
    (void)state;
    const double sizes[2] = {5.0, 2.0};
    for (int k = 0; k < 2; k++) {
        reference exact = {0};
        reference_solve(&exact, sizes[k], 0.5, 0.0);
        const double G = exact.K[0] * exact.K[0];
        printf("residual %g\n", exact.residual);
        for (int n = 4; n <= 24; n += 4) {
            finite_element_plate plate = tension(sizes[k], 0.5);
            plate.refinement = n;
            finite_element_result r;
            const double start = pdmc_seconds();
            CHECK_OK(finite_element_evaluate(&plate, &r));
            printf("%2d %.3f s: G %+.2e %+.2e, K_I %+.2e %+.2e, K_II %.1e\n", n, pdmc_seconds() - start,
                   r.energy_release_rate[0] / G - 1.0, r.energy_release_rate[1] / G - 1.0,
                   r.stress_intensity[0][0] / exact.K[0] - 1.0, r.stress_intensity[1][0] / exact.K[0] - 1.0,
                   r.stress_intensity[1][1]);
            if (n == FINITE_ELEMENT_FINE) CHECK_NEAR(r.energy_release_rate[1] / G, 1.0, 5e-4);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(uniform)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
