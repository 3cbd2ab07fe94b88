// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particles_impl.h"

#include "particles/bodies.h"

static const double pi = 3.14159265358979323846;

static void constants(void **state)
{
    (void)state;
    // Eq. 23 with k = E / (3 (1 - 2 nu)), nu = 1/4: 18 k / (pi d^4).
    CHECK_NEAR(pdmc_brittle_micromodulus(3, PDMC_PLANE_STRAIN, 3.0, 2.0, 1.0), 18.0 * 2.0 / (pi * 16.0), 1e-14);
    // Isotropic stretch s in the plane: pi c d^3 t s^2 / 6 = E s^2 / (1 - nu), nu = 1/3; in plane strain E s^2 / ((1 + nu)(1 - 2 nu)).
    const double stress = pdmc_brittle_micromodulus(2, PDMC_PLANE_STRESS, 3.0, 2.0, 0.5);
    CHECK_NEAR(pi * stress * 8.0 * 0.5 / 6.0, 3.0 / (1.0 - 1.0 / 3.0), 1e-14);
    const double strain = pdmc_brittle_micromodulus(2, PDMC_PLANE_STRAIN, 3.0, 2.0, 0.5);
    CHECK_NEAR(pi * strain * 8.0 * 0.5 / 6.0, 3.0 / (1.25 * 0.5), 1e-14);
    // Eq. 27: sqrt(5 G_0 / (9 k d)).
    CHECK_NEAR(pdmc_brittle_critical_stretch(3, 0.7, 36.0 / (pi * 16.0), 2.0, 1.0), sqrt(5.0 * 0.7 / (9.0 * 2.0 * 2.0)),
               1e-14);
    // Work to break all bonds across a line, on a unit of its length and thickness: c t s_0^2 d^4 / 4.
    const double s_0 = pdmc_brittle_critical_stretch(2, 0.7, stress, 2.0, 0.5);
    CHECK_NEAR(stress * 0.5 * s_0 * s_0 * 16.0 / 4.0, 0.7, 1e-14);
}

/// By definition: the sum over a whole family, node by node.
static void stable_step(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){9, 9, 9});
    double sum = 0.0;
    for (int x = -3; x <= 3; x++)
        for (int y = -3; y <= 3; y++)
            for (int z = -3; z <= 3; z++) {
                const int square = x * x + y * y + z * z;
                if (square > 0 && square <= 9) sum += s.material.micromodulus / sqrt(square);
            }
    pdmc_particles *p = create(&s);
    CHECK_NEAR(pdmc_particles_stable_step(p), sqrt(2.0 / sum), 1e-14);
    CHECK_NEAR(pdmc_particles_step_size(p), 0.5 * sqrt(2.0 / sum), 1e-14);
    pdmc_particles_destroy(p);
}

/// The speed of the longest wave along a free bar of plane stress, in units of sqrt(E / rho), from its period of vibration: ends
/// that are pulled apart evenly at first swing back after L / v.
static double bar_speed(int length, int height)
{
    specimen s;
    make_box(&s, 2, (int[]){length, height, 1});
    s.options.safety = 0.8;
    s.options.volume_rule = PDMC_VOLUME_PARTIAL;
    s.options.threads = 2;
    pdmc_layer_condition kick = {.kind = PDMC_CONDITION_FORCE, .region = s.body.shape, .along = {true}};
    enum { SLICES = 40 };
    pdmc_layer_condition slices[SLICES];
    const double when[] = {0.0, 1e-6}, how[] = {1.0, 0.0}; // a blow, over before the first step ends
    for (int k = 0; k < SLICES; k++) {
        slices[k] = kick;
        slices[k].region.from[0] = (length - 1.0) * k / SLICES + 1e-6;
        slices[k].region.to[0] = (length - 1.0) * (k + 1) / SLICES + 1e-6;
        if (k == 0) slices[k].region.from[0] = 0.0;
        slices[k].value[0] = -1e-6 * cos(pi * (k + 0.5) / SLICES);
        slices[k].history = (pdmc_history){2, when, how};
    }
    s.options.condition_count = SLICES;
    s.options.conditions = slices;
    pdmc_particles *p = create(&s);
    const int nodes = pdmc_particles_count(p);
    double *x = malloc(sizeof(double) * 3 * (size_t)nodes), *v = malloc(sizeof(double) * 3 * (size_t)nodes);
    pdmc_particles_reference(p, x, NULL);
    double before = 0.0, crossing = 0.0;
    int crossings = 0;
    for (int step = 0; crossings < 2 && step < 100000; step++) {
        double amplitude = 0.0;
        pdmc_particles_state(p, NULL, v, NULL);
        for (int k = 0; k < nodes; k++) amplitude -= v[3 * k] * cos(pi * (x[3 * k] + 0.5) / length);
        if ((before > 0.0) != (amplitude > 0.0) && step > 1) {
            const double at = pdmc_particles_time(p) - pdmc_particles_step_size(p) * amplitude / (amplitude - before);
            crossings++;
            crossing = crossings == 1 ? at : 2.0 * (at - crossing); // a whole period
        }
        before = amplitude;
        CHECK_OK(pdmc_particles_advance(p, 1));
    }
    pdmc_particles_destroy(p);
    free(x);
    free(v);
    return 2.0 * length / crossing;
}

/// The speed in an endless bar of this lattice, from the sums that stand for the integrals over the horizon: c_ijkl =
/// 1/2 sum_p c V_p xi_i xi_j xi_k xi_l / |xi|^3, E = c_11 - c_12^2 / c_11 where the sides are free.
static double lattice_speed(double horizon)
{
    const double c = pdmc_brittle_micromodulus(2, PDMC_PLANE_STRESS, 1.0, horizon, 1.0);
    const int reach = (int)horizon + 1;
    double along = 0.0, across = 0.0;
    for (int x = -reach; x <= reach; x++) {
        for (int y = -reach; y <= reach; y++) {
            const double length = hypot(x, y), share = fmin(1.0, 0.5 + horizon - length);
            if (length == 0.0 || share <= 0.0) continue;
            along += 0.5 * c * share * pow(x, 4) / pow(length, 3);
            across += 0.5 * c * share * x * x * y * y / pow(length, 3);
        }
    }
    return sqrt(along - across * across / along);
}

/// Bonds are missing along the sides and at the ends, in a share of the bar that falls with the horizon over its size: the
/// difference to an endless lattice halves where both are doubled. The lattice's own difference to the continuum falls with the
/// spacing over the horizon.
static void wave_speed_converges_to_that_of_a_bar(void **state)
{
    (void)state;
    enum { LEVELS = 3 - FINEST_LEFT_OUT };
    double error[LEVELS];
    for (int k = 0; k < LEVELS; k++) {
        error[k] = bar_speed(100 << k, 10 << k) / lattice_speed(3.0) - 1.0;
        print_message("  %d x %d nodes: speed of the longest wave %+.4f of an endless lattice's\n", 100 << k, 10 << k,
                      error[k]);
    }
    for (int k = 1; k < LEVELS; k++) CHECK_NEAR(error[k] / error[k - 1], 0.5, 0.1);
    CHECK_NEAR(2.0 * error[LEVELS - 1] - error[LEVELS - 2], 0.0, 0.002); // extrapolated
    for (int horizon = 3; horizon <= 12; horizon *= 2)
        print_message("  horizon of %d spacings: an endless lattice's speed %+.4f of sqrt(E / rho)\n", horizon,
                      lattice_speed(horizon) - 1.0);
    CHECK_NEAR(lattice_speed(6.0), 1.0, 0.01);
    CHECK_NEAR(lattice_speed(12.0), 1.0, 0.0025);
}

/// A body that turns: by a right angle, bonds are as long as before.
static void rotation_stretches_nothing(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){9, 7, 5});
    s.body.velocity[0] = 1.0;
    pdmc_particles *p = create(&s);
    for (int k = 0; k < p->nodes.node_count; k++) {
        const size_t c = p->nodes.cell[k];
        const double x = p->position[0][c];
        p->position[0][c] = -p->position[1][c];
        p->position[1][c] = x;
    }
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    // About 30,000 bonds of energy c s^2 / 4, with a stretch of a few roundings each.
    CHECK_NEAR(sums.elastic, 0.0, 3e4 * s.material.micromodulus * 1e-30);
    pdmc_particles_destroy(p);
}

typedef struct {
    double balance; // of energies, over the largest sum of kinetic and elastic
    double momentum;
    pdmc_particles_sums sums;
} record;

static record follow(pdmc_particles *p, int steps)
{
    record r = {0};
    double most = 0.0;
    const pdmc_particles_sums first = pdmc_particles_sum(p);
    for (int k = 0; k < steps; k += 5) {
        CHECK_OK(pdmc_particles_advance(p, 5));
        const pdmc_particles_sums now = r.sums = pdmc_particles_sum(p);
        most = fmax(most, now.kinetic + now.elastic);
        r.balance =
            fmax(r.balance, fabs(now.kinetic + now.elastic + now.fracture + now.contact - now.first - now.work));
        for (int a = 0; a < PDMC_AXES; a++) r.momentum = fmax(r.momentum, fabs(now.momentum[a] - first.momentum[a]));
    }
    r.balance /= most;
    return r;
}

/// A block that is pulled at one end, and pushed by a force at the other: nothing breaks.
static record pull(double safety)
{
    specimen s;
    make_box(&s, 3, (int[]){24, 8, 8});
    const double time[] = {0.0, 20.0, 40.0}, factor[] = {0.0, 1.0, 0.0};
    const pdmc_layer_condition conditions[] = {
        {.kind = PDMC_CONDITION_VELOCITY,
         .region = {.kind = PDMC_SHAPE_BOX, .to = {2, 7, 7}},
         .along = {true, false, false},
         .value = {-0.01},
         .history = {3, time, factor}},
        {.kind = PDMC_CONDITION_FORCE,
         .region = {.kind = PDMC_SHAPE_BOX, .from = {21, 0, 0}, .to = {23, 7, 7}},
         .along = {true, true, false},
         .value = {0.001, 0.0005},
         .history = {3, time, factor}},
    };
    s.options.condition_count = 2;
    s.options.conditions = conditions;
    s.options.safety = safety;
    pdmc_particles *p = create(&s);
    const record r = follow(p, (int)(40.0 / pdmc_particles_step_size(p)));
    pdmc_particles_destroy(p);
    return r;
}

/// Of small motions the sum of energies is that of a linear system; what is left is the bonds' turning, of second order in the step.
static void energy_balance(void **state)
{
    (void)state;
    const record coarse = pull(0.8), fine = pull(0.4);
    print_message("  energy balance %.2e of the energy, %.2e with half the step\n", coarse.balance, fine.balance);
    assert_true(coarse.balance < 1e-5);
    CHECK_NEAR(fine.balance / coarse.balance, 0.25, 0.1);
}

/// A body with a strip along an end, or the whole of it, that moves from the start on and turns back on a step.
static pdmc_particles *jerk(int strip)
{
    specimen s;
    make_box(&s, 3, (int[]){24, 6, 6});
    const double step = 0.25, time[] = {40 * step, 40 * step}, factor[] = {1.0, -1.0};
    const pdmc_layer_condition condition = {.kind = PDMC_CONDITION_VELOCITY,
                                            .region = {.kind = PDMC_SHAPE_BOX, .to = {strip - 1, 5, 5}},
                                            .along = {true, true, true},
                                            .value = {0.0, 0.01, 0.0},
                                            .history = {2, time, factor}};
    s.options.condition_count = 1;
    s.options.conditions = &condition;
    s.options.step = step;
    return create(&s);
}

/// All of the work of a velocity that jumps is counted, at the start too: the whole body has its kinetic energy from it, to
/// rounding; with a strip alone the rest is waves. On the jump the velocity is the mean of both.
static void a_jump_does_its_work(void **state)
{
    (void)state;
    const double full = 0.5 * 24.0 * 36.0 * 1e-4;
    pdmc_particles *all = jerk(24), *strip = jerk(3);
    for (int k = 0; k < 80; k++) {
        const pdmc_particles_sums a = pdmc_particles_sum(all), s = pdmc_particles_sum(strip);
        const double share = k == 0 ? 0.25 : k == 40 ? 0.0 : 1.0;
        CHECK_NEAR(a.kinetic, share * full, 1e-13 * full);
        CHECK_NEAR(a.work, share * full, 1e-13 * full);
        CHECK_NEAR(s.kinetic + s.elastic, s.work, 1e-4 * full);
        if (k == 1) assert_true(s.work > 0.125 * full); // the mass of the strip, an eighth, and the first wave
        CHECK_OK(pdmc_particles_advance(all, 1));
        CHECK_OK(pdmc_particles_advance(strip, 1));
    }
    pdmc_particles_destroy(all);
    pdmc_particles_destroy(strip);
}

/// Nodes follow a velocity that grows evenly, to rounding.
static void layers_follow_their_history(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){8, 8, 8});
    const double time[] = {0.0, 100.0}, factor[] = {1.0, 3.0};
    const pdmc_layer_condition all = {.kind = PDMC_CONDITION_VELOCITY,
                                      .region = s.body.shape,
                                      .along = {true, true, true},
                                      .value = {0.0, 0.02, 0.0},
                                      .history = {2, time, factor}};
    s.options.condition_count = 1;
    s.options.conditions = &all;
    pdmc_particles *p = create(&s);
    CHECK_OK(pdmc_particles_advance(p, 20));
    const double t = pdmc_particles_time(p), velocity = 0.02 * (1.0 + 0.02 * t);
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    double u[3 * 512];
    pdmc_particles_state(p, u, NULL, NULL);
    for (int k = 0; k < 512; k++) CHECK_NEAR(u[3 * k + 1], 0.02 * (t + 0.01 * t * t), 1e-14);
    CHECK_NEAR(sums.kinetic, 0.5 * 512.0 * velocity * velocity, 1e-12);
    pdmc_particles_destroy(p);
}

/// A notched bar that is torn apart: momentum, with every bond that breaks in both directions, and the energy of those bonds.
static void fracture_keeps_the_balance(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){24, 8, 8});
    s.material.critical_stretch = 0.02;
    s.material.strengthening = 0.25;
    s.options.safety = 0.2;
    const pdmc_planar_crack crack = {
        .kind = PDMC_CRACK_RECTANGLE, .centre = {11.5, 0.0, 3.5}, .side = {{0, 3.2, 0}, {0, 0, 5}}};
    const double time[] = {0.0, 10.0, 20.0}, factor[] = {0.0, 1.0, 0.0};
    const pdmc_layer_condition ends[] = {
        {.kind = PDMC_CONDITION_FORCE,
         .region = {.kind = PDMC_SHAPE_BOX, .to = {2, 7, 7}},
         .along = {true},
         .value = {-0.02},
         .history = {3, time, factor}},
        {.kind = PDMC_CONDITION_FORCE,
         .region = {.kind = PDMC_SHAPE_BOX, .from = {21, 0, 0}, .to = {23, 7, 7}},
         .along = {true},
         .value = {0.02},
         .history = {3, time, factor}},
    };
    s.options.crack_count = 1;
    s.options.cracks = &crack;
    s.options.condition_count = 2;
    s.options.conditions = ends;
    pdmc_particles *p = create(&s);
    const uint64_t cut = pdmc_particles_sum(p).broken;
    const record r = follow(p, (int)(60.0 / pdmc_particles_step_size(p)));
    print_message("  %d bonds cut, %d broken; energy balance %.2e, momentum %.1e\n", (int)cut,
                  (int)(r.sums.broken - cut), r.balance, r.momentum);
    assert_true(cut > 300 && r.sums.broken > cut + 300);
    assert_true(r.sums.fracture > 0.05 * r.sums.work);
    assert_true(r.balance < 1e-3);   // 4e-3 without the half step in which broken bonds still act
    assert_true(r.momentum < 1e-12); // 1536 nodes, forces up to 0.02, 1500 steps
    pdmc_particles_destroy(p);
}

/// The same bits whatever the number of threads.
static void threads_change_no_bit(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){30, 30, 5});
    s.material.critical_stretch = 0.01;
    s.material.strengthening = 0.25;
    s.options.contact_distance = 0.95;
    s.options.contact_stiffness = 15.0;
    const pdmc_rigid_sphere sphere = {
        .radius = 8.0, .centre = {14.3, 15.1, 12.05}, .velocity = {0, 0, -0.5}, .mass = 500.0, .stiffness = 0.05};
    s.options.sphere_count = 1;
    s.options.spheres = &sphere;
    enum { NODES = 30 * 30 * 5 };
    double *state_of[3];
    pdmc_particles_sums sums[3];
    for (int threads = 1; threads <= 3; threads++) {
        s.options.threads = threads;
        pdmc_particles *p = create(&s);
        double *values = state_of[threads - 1] = malloc(sizeof(double) * 7 * NODES);
        CHECK_OK(pdmc_particles_advance(p, 120));
        pdmc_particles_state(p, values, &values[3 * NODES], &values[6 * NODES]);
        sums[threads - 1] = pdmc_particles_sum(p);
        pdmc_particles_destroy(p);
    }
    assert_true(sums[0].broken > 5000 && sums[0].contact > 0.0);
    for (int k = 1; k < 3; k++) {
        assert_memory_equal(state_of[0], state_of[k], sizeof(double) * 7 * NODES);
        assert_memory_equal(&sums[0], &sums[k], sizeof sums[0]);
    }
    for (int k = 0; k < 3; k++) free(state_of[k]);
}

/// Forces that tear nodes off within a step: the step and the node are named, and the state is finite.
static void too_much_is_said(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){12, 12, 1});
    const double time[] = {0.0, 5.0}, factor[] = {0.0, 1e300};
    const pdmc_layer_condition condition = {.kind = PDMC_CONDITION_FORCE,
                                            .region = {.kind = PDMC_SHAPE_BOX, .from = {3, 4, 0}, .to = {3, 4, 0}},
                                            .along = {false, true},
                                            .value = {0, 1e10},
                                            .history = {2, time, factor}};
    s.options.condition_count = 1;
    s.options.conditions = &condition;
    pdmc_particles *p = create(&s);
    CHECK_STATUS(pdmc_particles_advance(p, 100), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "step 1,"));
    assert_non_null(strstr(pdmc_last_error(), "the node at (3, 4, 0)"));
    double u[3 * 144], v[3 * 144];
    pdmc_particles_state(p, u, v, NULL);
    for (int k = 0; k < 3 * 144; k++) assert_true(isfinite(u[k]) && isfinite(v[k]));
    pdmc_particles_destroy(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants),
        cmocka_unit_test(stable_step),
        cmocka_unit_test(wave_speed_converges_to_that_of_a_bar),
        cmocka_unit_test(rotation_stretches_nothing),
        cmocka_unit_test(energy_balance),
        cmocka_unit_test(a_jump_does_its_work),
        cmocka_unit_test(layers_follow_their_history),
        cmocka_unit_test(fracture_keeps_the_balance),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(too_much_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
