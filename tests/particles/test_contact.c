// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/contact.h"

#include "particles/bodies.h"
#include "particles/lattice.h"
#include "particles/particles_impl.h"

/// Nodes that were strangers, scattered so that many are near: the listed pairs are all those within reach, and no other.
static void check_pairs(double amplitude, double offset, int least)
{
    specimen s;
    unsigned seed = 3;
    make_box(&s, 3, (int[]){14, 10, 8});
    s.options.contact_distance = 1.35;
    pdmc_nodes g;
    pdmc_contact contact;
    CHECK_OK(pdmc_lattice_create(&s.options, &(pdmc_joints){0}, &g));
    CHECK_OK(pdmc_contact_create(&s.options, &g, 1.0, &contact));
    double *position[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) {
        position[a] = pdmc_calloc(g.cells, sizeof(double));
        for (int k = 0; k < g.node_count; k++)
            position[a][g.cell[k]] = g.reference[a][g.cell[k]] + amplitude * scatter(&seed);
    }
    // One half folded onto the other, and a node far away.
    for (int k = 0; k < g.node_count; k++)
        if (g.reference[0][g.cell[k]] > 6.5) position[0][g.cell[k]] -= offset;
    position[1][g.cell[17]] = 1e4;
    CHECK_OK(pdmc_contact_update(&contact, &g, position, 2));
    const double reach = contact.distance + contact.skin;
    int pairs = 0;
    for (int i = 0; i < g.node_count; i++) {
        for (int j = 0; j < g.node_count; j++) {
            double near = 0.0, first = 0.0;
            for (int a = 0; a < PDMC_AXES; a++) {
                near += pow(position[a][g.cell[i]] - position[a][g.cell[j]], 2);
                first += pow(g.reference[a][g.cell[i]] - g.reference[a][g.cell[j]], 2);
            }
            const bool wanted = near <= reach * reach && first > 9.0;
            bool found = false;
            for (size_t p = contact.start[i]; p < contact.start[i + 1]; p++) found |= contact.partner[p] == j;
            assert_int_equal(found, wanted);
            pairs += found;
        }
    }
    assert_true(pairs == (int)contact.start[g.node_count]); // none twice
    assert_true(least > 0 ? pairs > least : pairs == 0);
    for (int a = 0; a < PDMC_AXES; a++) pdmc_free(position[a]);
    pdmc_contact_clear(&contact);
    pdmc_nodes_clear(&g);
}

static void pairs_are_those_within_reach(void **state)
{
    (void)state;
    check_pairs(0.2, 0.0, 0);
    check_pairs(0.8, 0.0, 100); // near the least that brings strangers together
    check_pairs(2.0, 0.0, 1000);
    check_pairs(0.1, 5.7, 1000);
}

typedef struct {
    specimen s;
    pdmc_body bodies[2];
} collision;

/// Two cubes on a way towards each other, `gap` apart.
static void make_collision(collision *c, double gap, double speed)
{
    make_box(&c->s, 3, (int[]){1, 1, 1});
    c->bodies[0] = (pdmc_body){.shape = {.kind = PDMC_SHAPE_BOX, .to = {7, 7, 7}}, .velocity = {speed, 0, 0}};
    c->bodies[1] = (pdmc_body){.shape = {.kind = PDMC_SHAPE_BOX, .from = {8 + gap, 0, 0}, .to = {15 + gap, 7, 7}},
                               .velocity = {-speed, 0, 0}};
    c->s.options.body_count = 2;
    c->s.options.bodies = c->bodies;
    c->s.options.contact_distance = 0.9;
    c->s.options.contact_stiffness = 15.0;
    c->s.options.safety = 0.2;
}

/// They push each other back, keep momentum to rounding and energy to the step's error, and no bond joins them. Far apart at
/// first, their contact is found by the search; near, by the neighbours.
static void cubes_rebound(void **state)
{
    (void)state;
    for (int gap = 0; gap <= 6; gap += 6) {
        collision c;
        make_collision(&c, gap, 0.05);
        pdmc_particles *p = create(&c.s);
        const double step = pdmc_particles_step_size(p);
        const pdmc_particles_sums first = pdmc_particles_sum(p);
        double contact = 0.0, balance = 0.0, momentum = 0.0;
        for (double time = 0.0; time < (gap + 3.0) / 0.1 + 60.0; time += 5 * step) {
            CHECK_OK(pdmc_particles_advance(p, 5));
            const pdmc_particles_sums now = pdmc_particles_sum(p);
            contact = fmax(contact, now.contact);
            balance = fmax(balance, fabs(now.kinetic + now.elastic + now.contact - first.kinetic));
            for (int a = 0; a < PDMC_AXES; a++) momentum = fmax(momentum, fabs(now.momentum[a]));
        }
        double x[3 * 1024], v[3 * 1024], mean = 0.0;
        int body[1024];
        pdmc_particles_reference(p, x, body);
        pdmc_particles_state(p, NULL, v, NULL);
        for (int k = 0; k < 1024; k++) mean += body[k] == 0 ? v[3 * k] / 512.0 : 0.0;
        print_message("  gap %d: mean velocity %+.4f after %+.4f; balance of energy %.1e, momentum %.1e of it\n", gap,
                      mean, 0.05, balance / first.kinetic, momentum);
        assert_true(mean < -0.025); // the rest is vibration
        assert_true(contact > 0.05 * first.kinetic);
        assert_true(balance < 0.002 * first.kinetic);
        assert_true(momentum < 1e-12);
        pdmc_particles_destroy(p);
    }
}

/// A sphere that meets a block in free flight: momentum and energy are those of both.
static void sphere_rebounds(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){15, 15, 8});
    s.options.safety = 0.2;
    const pdmc_rigid_sphere sphere = {
        .radius = 6.0, .centre = {7.1, 6.9, 14.2}, .velocity = {0, 0, -0.05}, .mass = 200.0, .stiffness = 0.02};
    s.options.sphere_count = 1;
    s.options.spheres = &sphere;
    pdmc_particles *p = create(&s);
    const pdmc_particles_sums first = pdmc_particles_sum(p);
    CHECK_NEAR(first.kinetic, 0.5 * 200.0 * 0.05 * 0.05, 1e-14);
    double balance = 0.0, contact = 0.0;
    pdmc_particles_sums now = first;
    for (double time = 0.0; time < 150.0; time += 5.0 * pdmc_particles_step_size(p)) {
        CHECK_OK(pdmc_particles_advance(p, 5));
        now = pdmc_particles_sum(p);
        contact = fmax(contact, now.contact);
        balance = fmax(balance, fabs(now.kinetic + now.elastic + now.contact - first.kinetic));
    }
    pdmc_rigid_sphere after;
    pdmc_particles_spheres(p, &after);
    print_message("  sphere: velocity %+.4f after %+.4f, balance of energy %.1e\n", after.velocity[2], -0.05,
                  balance / first.kinetic);
    assert_true(after.velocity[2] > 0.01);
    assert_true(contact > 0.2 * first.kinetic);
    assert_true(balance < 1e-3 * first.kinetic);
    CHECK_NEAR(now.momentum[2], -200.0 * 0.05, 1e-10);
    pdmc_particles_destroy(p);
}

/// A sphere that keeps its velocity does work.
static void driven_sphere_works(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){30, 12, 1});
    s.options.safety = 0.2;
    const pdmc_rigid_sphere sphere = {
        .radius = 6.0, .centre = {14.6, 17.2, 0}, .velocity = {0, -0.02, 0}, .mass = INFINITY, .stiffness = 0.05};
    s.options.sphere_count = 1;
    s.options.spheres = &sphere;
    pdmc_particles *p = create(&s);
    double balance = 0.0;
    pdmc_particles_sums now = {0};
    for (int k = 0; k < 100; k++) {
        CHECK_OK(pdmc_particles_advance(p, 5));
        now = pdmc_particles_sum(p);
        balance = fmax(balance, fabs(now.kinetic + now.elastic + now.contact - now.work));
    }
    assert_true(now.work > 0.0);
    assert_true(balance < 1e-3 * now.work);
    pdmc_particles_destroy(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_are_those_within_reach),
        cmocka_unit_test(cubes_rebound),
        cmocka_unit_test(sphere_rebounds),
        cmocka_unit_test(driven_sphere_works),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
