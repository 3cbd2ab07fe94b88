// SPDX-License-Identifier: GPL-3.0-or-later

/// Bodies at rest that touch each other or a rigid sphere: single nodes in closed form, the balance of energy, two blocks and a
/// sphere; what is refused.

#include "particles/bodies.h"

#include <math.h>

static const double ramp[] = {0.0, 1.0};

static pdmc_status try_rest(pdmc_particles *p, double load, double tolerance, pdmc_rest *rest)
{
    const pdmc_rest_options options = {.tolerance = tolerance, .most_steps = 20000, .damping = -1.0};
    return pdmc_particles_come_to_rest(p, load, &options, rest);
}

static pdmc_rest rest_at(pdmc_particles *p, double load, double tolerance)
{
    pdmc_rest rest;
    CHECK_OK(try_rest(p, load, tolerance, &rest));
    return rest;
}

/// A layer of a box [from, to] in y that is held, or moved along y by `value` at the load 1.
static pdmc_layer_condition make_layer(double from, double to, double value)
{
    return (pdmc_layer_condition){
        .kind = PDMC_CONDITION_DISPLACEMENT,
        .region = {.kind = PDMC_SHAPE_BOX, .from = {-100, from, -100}, .to = {100, to, 100}},
        .along = {true, true, true},
        .value = {0.0, value, 0.0},
        .history = {2, ramp, ramp},
    };
}

/// Keeps all nodes on their line: what pushes a single node pushes it aside as well.
static pdmc_layer_condition make_rails(void)
{
    pdmc_layer_condition rails = make_layer(-100.0, 100.0, 0.0);
    rails.along[1] = false;
    return rails;
}

/// A node on top of one that is held, and a sphere that comes down on it: c u = k (depth - u)^2, whole volumes of 1.
typedef struct {
    specimen s;
    pdmc_layer_condition layers[2];
    pdmc_rigid_sphere sphere;
} pile;

static void make_pile(pile *t)
{
    make_box(&t->s, 2, (int[]){1, 2, 1});
    t->layers[0] = make_layer(0.0, 0.0, 0.0);
    t->layers[1] = make_rails();
    t->sphere = (pdmc_rigid_sphere){
        .radius = 5.0, .centre = {0, 6.1, 0}, .velocity = {0, -0.4, 0}, .mass = INFINITY, .stiffness = 0.5};
    t->s.options.linear_stretch = true;
    t->s.options.condition_count = 2;
    t->s.options.conditions = t->layers;
    t->s.options.sphere_count = 1;
    t->s.options.spheres = &t->sphere;
}

/// @return the work that is not in the bond or between sphere and node
static double press_pile(const pile *t, int loads)
{
    double u[6], force[3], off = 0.0;
    const double c = t->s.material.micromodulus, k = t->sphere.stiffness, tolerance = 1e-9;
    pdmc_particles *p = create(&t->s);
    for (int i = 0; i <= loads; i++) {
        rest_at(p, (double)i / loads, tolerance);
        pdmc_particles_state(p, u, NULL, NULL);
        pdmc_particles_sphere_forces(p, force);
        const double depth = fmax(0.0, 0.4 * i / loads - 0.1); // how far the sphere is below the node's first place
        const double b = 2.0 * depth + c / k, moved = 0.5 * (b - sqrt(b * b - 4.0 * depth * depth));
        CHECK_NEAR(-u[4], moved, 1e-8);
        CHECK_NEAR(force[1], c * moved, 1e-8 * c);
        const pdmc_particles_sums sums = pdmc_particles_sum(p);
        CHECK_NEAR(sums.elastic, 0.5 * c * moved * moved, 1e-8 * c);
        CHECK_NEAR(sums.contact, k * pow(depth - moved, 3.0) / 3.0, 1e-8 * c);
        off = sums.work - sums.elastic - sums.contact;
    }
    pdmc_particles_destroy(p);
    return off;
}

static void a_sphere_on_a_node_in_closed_form(void **state)
{
    (void)state;
    pile t;
    make_pile(&t);
    const double coarse = press_pile(&t, 8), fine = press_pile(&t, 16);
    print_message("  work off by %.2e and %.2e\n", coarse, fine);
    CHECK_NEAR(fine / coarse, 0.25, 0.02); // the trapezoidal rule's
}

/// Two nodes, the lower held, and the node of another body that comes down from y = 3 by 1.08: it repels the one at y = 1 below
/// a distance of 1, (c + r) u = 0.08 r with r = 15 c / horizon, whether they are within the horizon at the start or not.
static void press_by_a_body(double horizon)
{
    specimen s;
    double u[9], force[9], displacement[9];
    make_box(&s, 2, (int[]){1, 2, 1});
    s.options.horizon = horizon;
    s.options.linear_stretch = true;
    s.options.contact_distance = 1.0;
    s.options.contact_stiffness = 15.0;
    pdmc_body bodies[2] = {s.body, s.body};
    bodies[1].shape.from[1] = bodies[1].shape.to[1] = 3.0;
    const pdmc_layer_condition layers[3] = {make_layer(0.0, 0.0, 0.0), make_layer(3.0, 3.0, -1.08), make_rails()};
    s.options.body_count = 2;
    s.options.condition_count = 3;
    s.options.bodies = bodies;
    s.options.conditions = layers;
    pdmc_particles *p = create(&s);
    const double c = s.material.micromodulus, repulsion = 15.0 * c / horizon;
    for (int i = 0; i <= 3; i++) {
        rest_at(p, i / 3.0, 1e-9);
        const double overlap = i < 3 ? 0.0 : 0.08, moved = overlap * repulsion / (c + repulsion);
        pdmc_particles_state(p, u, NULL, NULL);
        pdmc_particles_conditions(p, force, displacement);
        CHECK_NEAR(-u[4], moved, 1e-8);
        CHECK_NEAR(force[4], -c * moved, 1e-8 * c);
        CHECK_NEAR(force[1], c * moved, 1e-8 * c);
        const pdmc_particles_sums sums = pdmc_particles_sum(p);
        CHECK_NEAR(sums.elastic, 0.5 * c * moved * moved, 1e-8 * c);
        CHECK_NEAR(sums.contact, 0.5 * repulsion * pow(overlap - moved, 2.0), 1e-8 * c);
    }
    pdmc_particles_destroy(p);
}

static void a_body_on_a_node_in_closed_form(void **state)
{
    (void)state;
    press_by_a_body(1.5);
    press_by_a_body(3.0);
}

typedef struct {
    double u[3 * 96], force[3];
    int steps;
} pressed;

/// A block on a block, with a sphere that comes down on the upper one by a spacing, off its middle.
static void press_blocks(int threads, pressed *result)
{
    specimen s;
    memset(result, 0, sizeof *result);
    make_box(&s, 3, (int[]){4, 3, 4});
    s.options.horizon = 2.0;
    s.options.contact_distance = 1.35;
    s.options.contact_stiffness = 15.0;
    s.options.threads = threads;
    pdmc_body bodies[2] = {s.body, s.body};
    for (int k = 0; k < 2; k++) bodies[k].shape.from[1] = 3.0 * k, bodies[k].shape.to[1] = 3.0 * k + 2.0;
    const pdmc_layer_condition floor = make_layer(0.0, 0.0, 0.0);
    const pdmc_rigid_sphere sphere = {
        .radius = 6.0, .centre = {1.4, 11.0, 1.6}, .velocity = {0, -1.0, 0}, .mass = INFINITY, .stiffness = 1.0};
    s.options.body_count = 2;
    s.options.bodies = bodies;
    s.options.condition_count = s.options.sphere_count = 1;
    s.options.conditions = &floor;
    s.options.spheres = &sphere;
    pdmc_particles *p = create(&s);
    double floor_force[3], displacement[3];
    for (int i = 0; i <= 2; i++) { result->steps += rest_at(p, 0.5 * i, 1e-5).steps; }
    pdmc_particles_state(p, result->u, NULL, NULL);
    pdmc_particles_sphere_forces(p, result->force);
    pdmc_particles_conditions(p, floor_force, displacement);
    // what is out of balance, 1e-5 of the external forces, may have one sign at all 96 nodes
    for (int a = 0; a < 3; a++) CHECK_NEAR(floor_force[a], result->force[a], 1e-4 * result->force[1]);
    pdmc_particles_destroy(p);
}

/// What the sphere presses with the floor holds, through two bodies that only touch.
static void blocks_and_a_sphere_at_rest(void **state)
{
    (void)state;
    pressed result[3];
    for (int k = 0; k < 3; k++) press_blocks(k + 1, &result[k]);
    print_message("  force %g, %d steps\n", result->force[1], result->steps);
    assert_true(result->force[1] > 0.0);
    assert_memory_equal(&result[0], &result[1], sizeof result[0]);
    assert_memory_equal(&result[0], &result[2], sizeof result[0]);
}

/// A sphere between the nodes of the pile lifts the upper one until the bond breaks: then nothing holds that, it leaves the sphere,
/// and what was in the bond and the contact is in the fracture and dissipated.
static void a_sphere_breaks_a_bond(void **state)
{
    (void)state;
    pile t;
    make_pile(&t);
    t.s.material.critical_stretch = 0.05;
    t.sphere.radius = 0.3;
    t.sphere.centre[1] = 0.6;
    t.sphere.velocity[1] = 0.5;
    pdmc_particles *p = create(&t.s);
    const double c = t.s.material.micromodulus, broken = 0.5 * c * 0.05 * 0.05;
    for (int i = 0; i <= 50; i++) rest_at(p, i / 50.0, 1e-6);
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    assert_int_equal(sums.broken, 1);
    CHECK_NEAR(sums.elastic + sums.contact, 0.0, 0.0);
    // a step of the sphere is 0.01, by which the depth of 0.1 and the stretch may be too large; the work is the trapezoidal rule's
    CHECK_NEAR(sums.fracture, 1.15 * broken, 0.15 * broken);
    assert_true(sums.dissipated > 0.5 * t.sphere.stiffness * pow(0.1, 3.0) / 3.0);
    CHECK_NEAR(sums.fracture + sums.dissipated, sums.work, 0.01 * sums.work);
    pdmc_particles_destroy(p);
}

static void what_has_a_mass_is_refused(void **state)
{
    (void)state;
    pile t;
    pdmc_rest rest;
    make_pile(&t);
    t.sphere.mass = 1.0;
    pdmc_particles *p = create(&t.s);
    CHECK_STATUS(try_rest(p, 0.0, 1e-6, &rest), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), "rest: spheres[0] has a mass, only one that is moved has a place at rest");
    pdmc_particles_destroy(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_on_a_node_in_closed_form),
        cmocka_unit_test(a_body_on_a_node_in_closed_form),
        cmocka_unit_test(blocks_and_a_sphere_at_rest),
        cmocka_unit_test(a_sphere_breaks_a_bond),
        cmocka_unit_test(what_has_a_mass_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
