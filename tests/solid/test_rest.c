// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/solid.h"

#include "check.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

/// A quarter of the column's section in each direction: enough for three layers about free nodes.
static const pdmc_solid_options COLUMN = {
    .nodes = {8, 16, 8},
    .spacing = 2.0,
    .horizon = 6.0,
    .youngs_modulus = 1e5,
    .threads = 1,
    .strain = {{-2.5e-5, 0.0, 0.0}, {0.0, 1e-4, 0.0}, {0.0, 0.0, -2.5e-5}},
};

enum { PULLED = 3 }; // the upper face along y

static double *vector(size_t count)
{
    double *v = calloc(count, sizeof *v);
    assert_non_null(v);
    return v;
}

/// Free nodes with all of their horizon within the body follow a uniform strain that is prescribed about them: every rule
/// is symmetric. The tolerance is that of the iteration, times its 60 steps.
static void uniform_strain(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    pdmc_solid_solution solution;
    for (int face = 0; face < PDMC_SOLID_FACES; face++) options.layers[face] = 3;
    options.strain[0][1] = options.strain[1][0] = 7e-5;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const size_t n = pdmc_solid_nodes(solid);
    double *u = vector(3 * n);
    pdmc_solid_start(solid, u);
    CHECK_OK(pdmc_solid_rest(solid, 1e-12, u, &solution));
    for (size_t i = 0; i < n; i++) {
        double x[3];
        pdmc_solid_position(solid, i, x);
        CHECK_NEAR(u[i], -2.5e-5 * x[0] + 7e-5 * x[1], 1e-13);
        CHECK_NEAR(u[n + i], 7e-5 * x[0] + 1e-4 * x[1], 1e-13);
        CHECK_NEAR(u[2 * n + i], -2.5e-5 * x[2], 1e-13);
    }
    free(u);
    pdmc_solid_destroy(solid);
}

/// Forces are those of an energy: none under rigid motions, and the sum of the nodes' energies is -1/2 u f.
static void forces_have_an_energy(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    options.compensation = PDMC_COMPENSATION_SUM;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const size_t n = pdmc_solid_nodes(solid);
    double *u = vector(3 * n), *f = vector(3 * n), *w = vector(n), work = 0.0, energy = 0.0, x[3];
    for (size_t i = 0; i < n; i++) {
        pdmc_solid_position(solid, i, x);
        u[i] = 1e-3 - 2e-4 * x[1];
        u[n + i] = 2e-4 * x[0] - 1e-4 * x[2];
        u[2 * n + i] = 1e-4 * x[1];
    }
    pdmc_solid_force(solid, u, f, w);
    for (size_t i = 0; i < 3 * n; i++) CHECK_NEAR(f[i], 0.0, 1e-11); // against 1e5 x 1e-4 of a strain of that size
    for (size_t i = 0; i < n; i++) {
        pdmc_solid_position(solid, i, x);
        u[i] = 1e-4 * sin(0.3 * x[1]);
        u[n + i] = 1e-4 * x[0] * x[1];
    }
    pdmc_solid_force(solid, u, f, w);
    for (size_t i = 0; i < 3 * n; i++) work -= 0.5 * u[i] * f[i];
    for (size_t i = 0; i < n; i++) energy += w[i];
    CHECK_NEAR(energy, work, 1e-13 * energy);
    free(u), free(f), free(w);
    pdmc_solid_destroy(solid);
}

/// The middle of an end face sees one surface alone, the sides being farther than the horizon: eq. 4.51, its sign mended.
static void one_surface(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    const double d = 6.0, h = 1.0; // the outermost node is half a spacing below the surface
    int found = 0;
    options.nodes[0] = options.nodes[2] = 13;
    options.compensation = PDMC_COMPENSATION_EXACT;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const double *beta = pdmc_solid_compensation_factors(solid);
    for (size_t i = 0; i < pdmc_solid_nodes(solid); i++) {
        double x[3];
        pdmc_solid_position(solid, i, x);
        if (x[0] != 0.0 || x[1] != 15.0 || x[2] != 0.0) continue;
        CHECK_NEAR(beta[i], 6.0 * gsl_pow_4(d) / (3.0 * gsl_pow_4(d) + 4.0 * gsl_pow_3(d) * h - gsl_pow_4(h)), 1e-13);
        found++;
    }
    assert_int_equal(found, 1);
    pdmc_solid_destroy(solid);
    options.load[PULLED].traction[1] = 1.0; // beyond a face that is pulled there is what pulls
    CHECK_OK(pdmc_solid_create(&options, &solid));
    beta = pdmc_solid_compensation_factors(solid);
    for (size_t i = 0; i < pdmc_solid_nodes(solid); i++) {
        double x[3];
        pdmc_solid_position(solid, i, x);
        if (x[0] == 0.0 && x[1] == 15.0 && x[2] == 0.0) CHECK_NEAR(beta[i], 1.0, 1e-13);
    }
    pdmc_solid_destroy(solid);
}

/// A body that nothing holds comes to rest under loads in balance: shear on four faces, each pair with a moment of its
/// own. Mean shear strain 1/2 t / mu, mu = 2 E / 5, but for surfaces; one pair alone would turn it.
static void free_body(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    pdmc_solid_solution solution;
    options.nodes[1] = 8;
    for (int face = 0; face < 4; face++) options.load[face].traction[face < 2 ? 1 : 0] = face % 2 ? 1.0 : -1.0;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    double *u = vector(3 * pdmc_solid_nodes(solid));
    CHECK_OK(pdmc_solid_rest(solid, 1e-8, u, &solution));
    assert_true(solution.iterations > 0 && u[8 * 8 * 4 + 7 * 8 + 4] > u[8 * 8 * 4 + 4]); // u_x grows with y
    pdmc_solid_destroy(solid);
    options.load[0].traction[1] = options.load[1].traction[1] = 0.0;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    CHECK_STATUS(pdmc_solid_rest(solid, 1e-8, u, &solution), PDMC_ERR_ARG);
    free(u);
    pdmc_solid_destroy(solid);
}

/// The bonds' factor is the mean of two, so the sum over the body is that of the nodes' factors: 3 E e^2 a node.
static void sums_are_compensated(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    options.compensation = PDMC_COMPENSATION_SUM;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const size_t n = pdmc_solid_nodes(solid);
    double *u = vector(3 * n), *f = vector(3 * n), *w = vector(n), energy = 0.0, x[3];
    for (size_t i = 0; i < n; i++) {
        pdmc_solid_position(solid, i, x);
        for (size_t k = 0; k < 3; k++) u[k * n + i] = 1e-4 * x[k];
    }
    pdmc_solid_force(solid, u, f, w);
    for (size_t i = 0; i < n; i++) energy += w[i];
    CHECK_NEAR(energy, (double)n * 3.0 * 1e5 * 1e-8, 1e-13 * energy);
    free(u), free(f), free(w);
    pdmc_solid_destroy(solid);
}

/// Three ways to rest end in one place.
static void three_ways(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    pdmc_solid_solution solution;
    pdmc_relaxation_state relaxed;
    options.layers[2] = options.layers[3] = 1;
    options.compensation = PDMC_COMPENSATION_SUM;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const size_t n = pdmc_solid_nodes(solid);
    double *u = vector(3 * n), *v = vector(3 * n), kinetic[301], elastic[301];
    pdmc_solid_start(solid, u);
    CHECK_OK(pdmc_solid_rest(solid, 1e-12, u, &solution));
    pdmc_solid_start(solid, v);
    CHECK_OK(pdmc_solid_relax(solid, 1e-10, 2000, -1.0, v, &relaxed));
    for (size_t i = 0; i < 3 * n; i++) CHECK_NEAR(v[i], u[i], 1e-8 * 1.5e-3);
    const pdmc_solid_motion motion = {2e-6, 0.2, 0.8, 300};
    CHECK_NEAR(pdmc_solid_step(solid, &motion), 8.7635e-6, 1e-10); // as Yu (2011), section 3.4.2, prints it
    pdmc_solid_start(solid, v);
    CHECK_OK(pdmc_solid_move(solid, &motion, v, kinetic, elastic));
    for (size_t i = 0; i < 3 * n; i++) CHECK_NEAR(v[i], u[i], 1e-5 * 1.5e-3);
    assert_true(kinetic[300] < 1e-10 * elastic[300] && elastic[300] < elastic[0]);
    free(u), free(v);
    pdmc_solid_destroy(solid);
}

/// Without damping the energy stays: elastic at a step and the mean of the kinetic energies about it, to the second order
/// in the step. (The product of the velocities about it would be exact; the mean is above it by the step's square.)
static void energy_stays(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    double off[2], kinetic[401], elastic[401];
    options.layers[2] = options.layers[3] = 3;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const size_t n = pdmc_solid_nodes(solid);
    double *u = vector(3 * n), x[3];
    for (int k = 0; k < 2; k++) {
        const pdmc_solid_motion motion = {2e-6, 0.0, k ? 0.1 : 0.2, k ? 100 : 50};
        memset(u, 0, 3 * n * sizeof *u);
        for (size_t i = 0; i < n; i++) {
            pdmc_solid_position(solid, i, x);
            if (fabs(x[1]) < 10.0) u[n + i] = 1e-4 * cos(M_PI * x[1] / 20.0); // the lowest mode, nearly
        }
        CHECK_OK(pdmc_solid_move(solid, &motion, u, kinetic, elastic));
        off[k] = 0.0;
        for (int i = 1; i < motion.steps; i++)
            off[k] = fmax(off[k], fabs(elastic[i] + 0.5 * (kinetic[i] + kinetic[i + 1]) - elastic[0]) / elastic[0]);
    }
    print_message("energy off by %.2e and %.2e\n", off[0], off[1]);
    assert_true(off[0] < 0.01 && off[1] < off[0] / 3.5);
    free(u);
    pdmc_solid_destroy(solid);
}

/// Sums are taken in one order whatever the number of threads.
static void threads(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    double *u = NULL, *force[2] = {NULL, NULL};
    size_t n = 0;
    for (int k = 0; k < 2; k++) {
        pdmc_solid *solid;
        options.threads = k ? 3 : 1;
        CHECK_OK(pdmc_solid_create(&options, &solid));
        n = pdmc_solid_nodes(solid);
        if (k == 0) u = vector(3 * n);
        force[k] = vector(3 * n);
        for (size_t i = 0; i < 3 * n; i++) u[i] = 1e-4 * sin((double)(i * i));
        pdmc_solid_force(solid, u, force[k], NULL);
        pdmc_solid_destroy(solid);
    }
    assert_memory_equal(force[0], force[1], 3 * n * sizeof *u);
    free(u), free(force[0]), free(force[1]);
}

static void refusals(void **state)
{
    (void)state;
    pdmc_solid_options options = COLUMN;
    pdmc_solid *solid;
    pdmc_solid_solution solution;
    options.horizon = 1.0;
    CHECK_STATUS(pdmc_solid_create(&options, &solid), PDMC_ERR_ARG);
    options = COLUMN;
    options.load[3].traction[1] = 10.0;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    double *u = vector(3 * pdmc_solid_nodes(solid)), energy[2];
    CHECK_STATUS(pdmc_solid_rest(solid, 1e-8, u, &solution), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "not in balance"));
    const pdmc_solid_motion motion = {2e-6, 0.5, 0.8, 1};
    CHECK_STATUS(pdmc_solid_move(solid, &motion, u, energy, energy), PDMC_ERR_ARG);
    free(u);
    pdmc_solid_destroy(solid);
    options.load[3].traction[1] = 0.0;
    CHECK_FAILS_CLEANLY(pdmc_solid_create(&options, &solid), pdmc_solid_destroy(solid));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uniform_strain),
        cmocka_unit_test(forces_have_an_energy),
        cmocka_unit_test(one_surface),
        cmocka_unit_test(free_body),
        cmocka_unit_test(sums_are_compensated),
        cmocka_unit_test(three_ways),
        cmocka_unit_test(energy_stays),
        cmocka_unit_test(threads),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
