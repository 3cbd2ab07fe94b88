// SPDX-License-Identifier: GPL-3.0-or-later

/// Damping against the closed forms of a body that glides and of two nodes that swing; motion prescribed by displacements
/// and gradients.

#include "particles/particles_impl.h"

#include "particles/bodies.h"

static const double pi = 3.14159265358979323846;

/// The largest error of the velocity over three times 1 / rate of a body that glides, of exp(-C t / rho) v_0.
static double glide_error(double safety)
{
    specimen s;
    make_box(&s, 3, (int[]){3, 3, 3});
    const double rate = 0.2, first = 0.01;
    s.material.density = 2.0;
    s.body.velocity[1] = first;
    s.options.damping = rate * s.material.density;
    s.options.safety = safety;
    pdmc_particles *p = create(&s);
    double v[3 * 27], error = 0.0;
    while (pdmc_particles_time(p) < 3.0 / rate) {
        CHECK_OK(pdmc_particles_advance(p, 1));
        pdmc_particles_state(p, NULL, v, NULL);
        error = fmax(error, fabs(v[3 * 13 + 1] / first - exp(-rate * pdmc_particles_time(p))));
    }
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    // Velocities and work are those of the middle of steps: an error of the second order.
    CHECK_NEAR((sums.kinetic + sums.dissipated) / sums.first, 1.0, 0.1 * safety * safety);
    pdmc_particles_destroy(p);
    return error;
}

static void a_body_that_glides_slows_down(void **state)
{
    (void)state;
    const double coarse = glide_error(0.8), fine = glide_error(0.4);
    print_message("  error of the velocity %.2e, %.2e with half the step\n", coarse, fine);
    assert_true(coarse < 1e-2);
    CHECK_NEAR(fine / coarse, 0.25, 0.03);
}

/// Two nodes of the distance 1 that swing towards each other, by x = 1 + (v / w) sin(w t) exp(-q t) each, or twice that in
/// their distance, from a velocity v so small that the bond is linear. The bond is six times as stiff as the others where
/// that is wanted, by factors at its nodes and by fibres. @return the largest error of x over its amplitude
static double swing_error(double damping, double bond_damping, double decay, double safety, bool stiffer)
{
    specimen s;
    make_box(&s, 2, (int[]){2, 1, 1});
    s.options.safety = safety;
    s.options.damping = damping;
    s.options.bond_damping = bond_damping;
    const double factors[] = {1.0, 3.0}, square = 2.0 * s.material.micromodulus;
    pdmc_particles *p = create(&s);
    const double dt = pdmc_particles_step_size(p);
    s.options.step = dt; // with factors it would be that of the bond, here it is that of a family
    if (stiffer) {
        pdmc_particles_destroy(p);
        s.material.micromodulus /= 6.0;
        s.material.fibre[0] = 1.0, s.material.fibre_ratio = 3.0;
        s.options.factor_count = 2, s.options.stiffness_factors = factors;
        p = create(&s);
    }
    const double v = 1e-7, w = sqrt(square - decay * decay);
    const pdmc_nodes *g = &p->nodes;
    for (int k = 0; k < 2; k++) // the velocity half a step after the start
        p->velocity[0][g->cell[k]] = (k ? v : -v) * (1.0 - decay * dt);
    double u[6], error = 0.0;
    while (pdmc_particles_time(p) < 2.0 * pi / w) {
        CHECK_OK(pdmc_particles_advance(p, 1));
        pdmc_particles_state(p, u, NULL, NULL);
        const double t = pdmc_particles_time(p);
        error = fmax(error, fabs(0.5 * (u[3] - u[0]) / v * w - sin(w * t) * exp(-decay * t)));
    }
    pdmc_particles_destroy(p);
    return error;
}

/// rho x'' = -2 c V x / |xi| - C x' - 2 c c_v V x': both decay by their own rate. A node's own damping is of the second order
/// in the step, that of bonds of the first.
static void a_mode_decays(void **state)
{
    (void)state;
    const double micromodulus = pdmc_brittle_micromodulus(2, PDMC_PLANE_STRESS, 1.0, 3.0, 1.0);
    const double decay = 0.05 * sqrt(2.0 * micromodulus);
    double error[2][2], of_stiffer[2];
    for (int k = 0; k < 2; k++) {
        error[0][k] = swing_error(2.0 * decay, 0.0, decay, k ? 0.02 : 0.04, false);
        error[1][k] = swing_error(0.0, decay / micromodulus, decay, k ? 0.02 : 0.04, false);
        of_stiffer[k] = swing_error(0.0, decay / micromodulus, decay, k ? 0.02 : 0.04, true);
        print_message("  error of the swing %.2e by a node's own damping, %.2e by that of its bond\n", error[0][k],
                      error[1][k]);
    }
    assert_true(error[0][1] < 2e-3 && error[1][1] < 2e-3);
    for (int k = 0; k < 2; k++) CHECK_NEAR(of_stiffer[k], error[1][k], 1e-3 * error[1][k]); // rounding: x is 1e-7 of 1
    CHECK_NEAR(error[0][1] / error[0][0], 0.25, 0.1);
    CHECK_NEAR(error[1][1] / error[1][0], 0.5, 0.1);
}

/// The damping of bonds leaves a body's glide and its momentum alone, and that of a turn; and what is lost is counted.
static void bonds_do_not_hold_a_body_back(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){12, 6, 6});
    const double time[] = {0.0, 4.0, 8.0}, factor[] = {0.0, 1.0, 0.0};
    const pdmc_layer_condition pull = {.kind = PDMC_CONDITION_FORCE,
                                       .region = {.kind = PDMC_SHAPE_BOX, .to = {2, 5, 5}},
                                       .along = {true, true, false},
                                       .value = {-0.01, 0.002, 0.0},
                                       .history = {3, time, factor}};
    s.options.condition_count = 1;
    s.options.conditions = &pull;
    s.options.bond_damping = 0.5;
    pdmc_particles *p = create(&s);
    while (pdmc_particles_time(p) < 8.0) CHECK_OK(pdmc_particles_advance(p, 1));
    const pdmc_particles_sums first = pdmc_particles_sum(p);
    while (pdmc_particles_time(p) < 60.0) CHECK_OK(pdmc_particles_advance(p, 1));
    const pdmc_particles_sums last = pdmc_particles_sum(p);
    print_message("  elastic %.3g, dissipated %.3g, then %.3g, %.3g\n", first.elastic, first.dissipated, last.elastic,
                  last.dissipated);
    for (int a = 0; a < PDMC_AXES; a++) CHECK_NEAR(last.momentum[a], first.momentum[a], 1e-13);
    assert_true(last.elastic < 0.1 * first.elastic);
    assert_true(last.dissipated > first.dissipated && first.dissipated > 0.0);
    CHECK_NEAR(last.kinetic + last.elastic + last.dissipated, last.work, 2e-3 * last.work);
    pdmc_particles_destroy(p);
}

/// With the damping of bonds the largest stable step is smaller: just below it a stiff vibration dies out, and at the step of
/// eq. 46 it would not.
static void damped_bonds_ask_for_smaller_steps(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){9, 9, 1});
    pdmc_particles *undamped = create(&s);
    double stiffness = 0.0, weight = 0.0;
    for (int n = 0; n < undamped->nodes.neighbour_count; n++) {
        stiffness += 2.0 * s.material.micromodulus * undamped->nodes.neighbours[n].stiffness;
        weight += 2.0 * s.material.micromodulus * undamped->nodes.neighbours[n].weight;
    }
    s.options.bond_damping = 0.7;
    s.options.safety = 1.0;
    pdmc_particles *p = create(&s);
    const double dt = pdmc_particles_stable_step(p);
    CHECK_NEAR(stiffness * dt * dt + 2.0 * 0.7 * weight * dt, 4.0, 1e-13);
    for (int k = 0; k < 81; k++) p->velocity[0][p->nodes.cell[k]] = (k + k / 9) % 2 ? 1e-6 : -1e-6;
    CHECK_OK(pdmc_particles_advance(p, 200));
    assert_true(pdmc_particles_sum(p).kinetic < 81 * 1e-13);
    pdmc_particles_destroy(p);

    double factors[81];
    for (int k = 0; k < 81; k++) factors[k] = 2.0;
    s.material.micromodulus *= 0.5;
    s.options.factor_count = 81, s.options.stiffness_factors = factors;
    p = create(&s);
    CHECK_NEAR(pdmc_particles_stable_step(p), dt, 1e-14);
    pdmc_particles_destroy(p);

    s.options.step = pdmc_particles_stable_step(undamped);
    CHECK_STATUS(pdmc_particles_create(&s.options, &p), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "the largest stable one"));
    pdmc_particles_destroy(undamped);
}

/// u = t (a + G X) of every node is reached at every step, whether by displacements or by velocities.
static void layers_follow_gradients(void **state)
{
    (void)state;
    for (int by_velocity = 0; by_velocity < 2; by_velocity++) {
        specimen s;
        make_box(&s, 2, (int[]){6, 5, 1});
        const double time[] = {0.0, 100.0}, ramp[] = {0.0, 100.0}, constant[] = {1.0, 1.0};
        const pdmc_layer_condition all = {.kind = by_velocity ? PDMC_CONDITION_VELOCITY : PDMC_CONDITION_DISPLACEMENT,
                                          .region = s.body.shape,
                                          .along = {true, true, false},
                                          .value = {0.001, 0.0, 0.0},
                                          .gradient = {{2e-4, 1e-4, 0.0}, {0.0, -3e-4, 0.0}},
                                          .history = {2, time, by_velocity ? constant : ramp}};
        s.options.condition_count = 1;
        s.options.conditions = &all;
        pdmc_particles *p = create(&s);
        CHECK_OK(pdmc_particles_advance(p, 10));
        const double t = pdmc_particles_time(p);
        double x[3 * 30], u[3 * 30], v[3 * 30];
        pdmc_particles_reference(p, x, NULL);
        pdmc_particles_state(p, u, v, NULL);
        for (int k = 0; k < 30; k++) {
            CHECK_NEAR(u[3 * k], t * (0.001 + 2e-4 * x[3 * k] + 1e-4 * x[3 * k + 1]), 1e-14);
            CHECK_NEAR(u[3 * k + 1], t * -3e-4 * x[3 * k + 1], 1e-14);
            CHECK_NEAR(v[3 * k + 1], -3e-4 * x[3 * k + 1], 1e-14);
        }
        pdmc_particles_destroy(p);
    }
}

/// A free body under a force that grows along x, and acts from the start on: its centre moves by F t^2 / (2 m), which the
/// central difference formula has to rounding, and its momentum is F t.
static void forces_have_gradients(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){6, 4, 1});
    const pdmc_layer_condition all = {.kind = PDMC_CONDITION_FORCE,
                                      .region = s.body.shape,
                                      .along = {false, true, false},
                                      .value = {0.0, 1e-4, 0.0},
                                      .gradient = {{0.0}, {1e-4, 0.0, 0.0}}};
    s.options.condition_count = 1;
    s.options.conditions = &all;
    pdmc_particles *p = create(&s);
    const double force = 1e-4 * 4 * (1 + 2 + 3 + 4 + 5 + 6);
    CHECK_NEAR(pdmc_particles_sum(p).momentum[1], 0.0, 1e-17);
    CHECK_OK(pdmc_particles_advance(p, 7));
    const double time = 7.0 * pdmc_particles_step_size(p);
    double whole[PDMC_AXES], mean[PDMC_AXES];
    pdmc_particles_conditions(p, whole, mean);
    CHECK_NEAR(whole[1], force, 1e-15);
    CHECK_NEAR(pdmc_particles_sum(p).momentum[1], force * time, 1e-14);
    CHECK_NEAR(mean[1], 0.5 * force / 24.0 * time * time, 1e-14);
    pdmc_particles_destroy(p);
}

/// A plate in motion with both kinds of damping and every kind of condition, on one thread to three.
static void threads_change_no_bit(void **state)
{
    (void)state;
    enum { NODES = 40 * 30 };
    double values[3][6 * NODES];
    pdmc_particles_sums sums[3];
    for (int threads = 1; threads <= 3; threads++) {
        specimen s;
        make_box(&s, 2, (int[]){40, 30, 1});
        const double time[] = {0.0, 10.0}, factor[] = {0.0, 1.0};
        const pdmc_layer_condition end = {.kind = PDMC_CONDITION_DISPLACEMENT,
                                          .region = {.kind = PDMC_SHAPE_BOX, .to = {2, 29, 0}},
                                          .along = {true, false, false},
                                          .value = {-0.5},
                                          .history = {2, time, factor}};
        s.material.critical_stretch = 0.02;
        s.options.damping = 0.01;
        s.options.bond_damping = 0.1;
        s.options.condition_count = 1;
        s.options.conditions = &end;
        s.options.threads = threads;
        pdmc_particles *p = create(&s);
        CHECK_OK(pdmc_particles_advance(p, 60));
        pdmc_particles_state(p, values[threads - 1], &values[threads - 1][3 * NODES], NULL);
        sums[threads - 1] = pdmc_particles_sum(p);
        pdmc_particles_destroy(p);
    }
    assert_true(sums[0].broken > 100 && sums[0].dissipated > 0.0);
    for (int k = 1; k < 3; k++) {
        assert_memory_equal(values[0], values[k], sizeof values[0]);
        assert_memory_equal(&sums[0], &sums[k], sizeof sums[0]);
    }
}

static void no_memory_is_said(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){4, 4, 1});
    s.options.damping = 0.1;
    pdmc_particles *p = NULL;
    CHECK_FAILS_CLEANLY(pdmc_particles_create(&s.options, &p), pdmc_particles_destroy(p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_body_that_glides_slows_down), cmocka_unit_test(a_mode_decays),
        cmocka_unit_test(bonds_do_not_hold_a_body_back), cmocka_unit_test(damped_bonds_ask_for_smaller_steps),
        cmocka_unit_test(layers_follow_gradients),       cmocka_unit_test(forces_have_gradients),
        cmocka_unit_test(threads_change_no_bit),         cmocka_unit_test(no_memory_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
