// SPDX-License-Identifier: GPL-3.0-or-later

/// Bonds between bodies: chains in series and waves in closed form; a body in parts is the body; what interfaces bear and what
/// they release.

#include "particles/particles_impl.h"

#include "particles/bodies.h"

/// A body and another one, or a part of it, with an interface between them.
typedef struct {
    specimen s;
    pdmc_brittle_material materials[2];
    pdmc_body bodies[2];
    pdmc_interface interface;
    pdmc_layer_condition conditions[2];
} composite;

/// A box whose nodes from x = first on are a part of it, or another body, of a second material that is as the first.
static void make_composite(composite *c, int dimension, const int count[], double first, bool is_part)
{
    make_box(&c->s, dimension, count);
    c->materials[0] = c->materials[1] = c->s.material;
    c->bodies[0] = c->bodies[1] = c->s.body;
    c->bodies[1].shape.from[0] = first;
    c->bodies[1].material = 1;
    c->bodies[1].is_part = is_part;
    if (!is_part) c->bodies[0].shape.to[0] = first - 1.0;
    c->interface = (pdmc_interface){.of_bodies = true, .first = 1, .second = 0};
    c->s.options.materials = c->materials, c->s.options.material_count = 2;
    c->s.options.bodies = c->bodies, c->s.options.body_count = 2;
    c->s.options.interfaces = &c->interface, c->s.options.interface_count = 1;
}

/// Bonds to the nodes beside alone, of nodes in a row: springs of the stiffness c, since all volumes and distances are 1.
static void make_chain(composite *c, int nodes, double first)
{
    make_composite(c, 2, (int[]){nodes, 1, 1}, first, true);
    c->s.options.horizon = 1.0;
    c->s.options.volume_rule = PDMC_VOLUME_WHOLE;
    c->s.options.linear_stretch = true;
    c->materials[0].micromodulus = 2.0;
    c->materials[1].micromodulus = 0.5;
}

/// What a chain of `nodes` grows by that is held at one end and pulled at the other.
static double stretched_by(composite *c, int nodes, double force)
{
    static const double ramp[] = {0.0, 1.0};
    c->conditions[0] = (pdmc_layer_condition){.kind = PDMC_CONDITION_DISPLACEMENT, .along = {true, true}};
    c->conditions[1] = (pdmc_layer_condition){.kind = PDMC_CONDITION_FORCE,
                                              .region = {.from = {nodes - 1.0}, .to = {nodes - 1.0}},
                                              .along = {true},
                                              .value = {force},
                                              .history = {2, ramp, ramp}};
    c->s.options.condition_count = 2;
    c->s.options.conditions = c->conditions;
    pdmc_particles *p = create(&c->s);
    pdmc_rest rest;
    const pdmc_rest_options options = {.tolerance = 1e-9, .most_steps = 20000, .damping = -1.0};
    CHECK_OK(pdmc_particles_come_to_rest(p, 1.0, &options, &rest));
    double *u = malloc(3 * (size_t)nodes * sizeof *u);
    pdmc_particles_state(p, u, NULL, NULL);
    const double grown = u[3 * (nodes - 1)], work = pdmc_particles_sum(p).work, elastic = pdmc_particles_sum(p).elastic;
    CHECK_NEAR(work, 0.5 * force * grown, 1e-12 * work);
    CHECK_NEAR(elastic, work, 1e-7 * work);
    free(u);
    pdmc_particles_destroy(p);
    return grown;
}

/// Springs in series: 7 of c = 2, one of the interface, 8 of c = 1/2. By default that one is two halves of a bond in series.
static void compliances_add_up(void **state)
{
    (void)state;
    const double force = 1e-3, inside = 7.0 / 2.0 + 8.0 / 0.5;
    composite c;
    make_chain(&c, 17, 8.0);
    CHECK_NEAR(stretched_by(&c, 17, force), force * (inside + 0.5 / 2.0 + 0.5 / 0.5), 1e-6 * force);
    c.interface.micromodulus = 0.1;
    CHECK_NEAR(stretched_by(&c, 17, force), force * (inside + 10.0), 1e-6 * force);
    c.interface = (pdmc_interface){.first = 0, .second = 1, .micromodulus = 0.2};
    CHECK_NEAR(stretched_by(&c, 17, force), force * (inside + 5.0), 1e-6 * force);
}

/// A wave that meets the interface leaves the nodes there displaced by 2 Z_1 / (Z_1 + Z_2) of what it would without, and takes
/// 4 Z_1 Z_2 / (Z_1 + Z_2)^2 of its energy through, Z = sqrt(E rho), E = c of a chain.
static void waves_are_reflected_by_impedances(void **state)
{
    (void)state;
    enum { NODES = 700, FIRST = 350, POINTS = 41 };
    const double v = 1e-4, duration = 120.0; // a pulse of 85 nodes in the first material
    double time[POINTS], factor[POINTS], pushed = 0.0;
    composite c;
    make_chain(&c, NODES, FIRST);
    c.materials[0].density = 4.0;
    c.materials[1].density = 1.0;
    for (int k = 0; k < POINTS; k++) {
        time[k] = duration * k / (POINTS - 1);
        factor[k] = 0.5 - 0.5 * cos(2.0 * 3.14159265358979323846 * k / (POINTS - 1));
        pushed += v * factor[k] * duration / (POINTS - 1);
    }
    c.conditions[0] = (pdmc_layer_condition){.along = {true, true}, .value = {v}, .history = {POINTS, time, factor}};
    c.s.options.condition_count = 1;
    c.s.options.conditions = c.conditions;
    c.s.options.safety = 0.9;
    pdmc_particles *p = create(&c.s);
    static double u[3 * NODES], velocity[3 * NODES];
    while (pdmc_particles_time(p) < 120.0 + FIRST / sqrt(0.5) + 100.0) CHECK_OK(pdmc_particles_advance(p, 1));
    pdmc_particles_state(p, u, velocity, NULL);
    const double first = sqrt(2.0 * 4.0), second = sqrt(0.5 * 1.0);
    double kinetic[2] = {0.0, 0.0};
    for (int k = 0; k < NODES; k++)
        kinetic[k >= FIRST] += 0.5 * (k < FIRST ? 4.0 : 1.0) * velocity[3 * k] * velocity[3 * k];
    const double share = kinetic[1] / (kinetic[0] + kinetic[1]);
    const double expected = 4.0 * first * second / ((first + second) * (first + second));
    print_message("  %.5f of the energy is through, %.5f expected; displaced by %.6f, %.6f expected\n", share, expected,
                  u[3 * FIRST] / pushed, 2.0 * first / (first + second));
    // The lattice's dispersion: (wave number times spacing)^2 / 12 of the longest part of the pulse is 5e-4.
    CHECK_NEAR(u[3 * FIRST] / pushed, 2.0 * first / (first + second), 5e-4);
    CHECK_NEAR(share, expected, 5e-4);
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    CHECK_NEAR(sums.kinetic + sums.elastic, sums.work, 1e-9 * sums.work); // stretches of 1e-5 at positions up to 700
    pdmc_particles_destroy(p);
}

enum { LONG = 24, HIGH = 8, DEEP = 3, NODES = LONG * HIGH * DEEP };

/// Pulls the ends of a box apart until bonds break all over. @param[out] values  displacements, damage
static pdmc_particles_sums tear(specimen *s, double values[])
{
    static const double factors[] = {0.0, 1.0}, times[] = {0.0, 20.0};
    const pdmc_layer_condition ends[] = {
        {.region = {.to = {1, HIGH, DEEP}}, .along = {true}, .value = {-0.04}, .history = {2, times, factors}},
        {.region = {.from = {LONG - 2.5}, .to = {LONG, HIGH, DEEP}},
         .along = {true},
         .value = {0.04},
         .history = {2, times, factors}}};
    s->options.condition_count = 2;
    s->options.conditions = ends;
    pdmc_particles *p = create(s);
    assert_int_equal(pdmc_particles_count(p), NODES);
    while (pdmc_particles_time(p) < 20.0) CHECK_OK(pdmc_particles_advance(p, 1));
    pdmc_particles_state(p, values, NULL, &values[3 * NODES]);
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    pdmc_particles_destroy(p);
    return sums;
}

static void make_brittle(pdmc_brittle_material *material)
{
    material->critical_stretch = 0.015;
    material->strengthening = 0.25;
    material->fibre[0] = 1.0;
    material->fibre[1] = 0.5;
    material->fibre_ratio = 1.5;
}

/// A body, the body with a part of the same material, and two bodies that are bonded are the same, on the grid and off it, but for
/// the order in which a node's bonds are summed off the grid. @param[in] zone  whether a part of the body cannot fail
static void compare_with_whole(bool scattered, bool zone)
{
    static double whole[4 * NODES], parted[4 * NODES];
    const pdmc_shape spared = {.to = {4, HIGH, DEEP}};
    unsigned seed = 5;
    composite c;
    make_composite(&c, 3, (int[]){LONG, HIGH, DEEP}, 11.5, true);
    specimen *s = &c.s;
    pdmc_node *nodes = scattered ? scatter_box(s, (int[]){LONG, HIGH, DEEP}, 0.1, &seed) : NULL;
    const pdmc_body body = s->body;
    if (scattered) c.bodies[0] = body;
    make_brittle(&c.materials[0]);
    c.bodies[1].material = 0;
    c.bodies[0].velocity[1] = 1e-3; // that of the part, which does not say any
    s->options.step = 0.2;
    s->options.bond_damping = 0.01;
    s->options.no_fail_count = zone;
    s->options.no_fail = &spared;
    s->options.body_count = 1, s->options.interface_count = 0;
    const pdmc_particles_sums sums = tear(s, whole);
    assert_true(sums.broken > 500);
    s->options.body_count = 2;
    const pdmc_particles_sums with_part = tear(s, parted);
    for (int k = 0; k < 4 * NODES; k++) CHECK_NEAR(parted[k], whole[k], 1e-11);
    assert_int_equal(with_part.broken, sums.broken);
    CHECK_NEAR(with_part.fracture, sums.fracture, 1e-11 * sums.fracture);
    CHECK_NEAR(with_part.elastic, sums.elastic, 1e-11 * sums.elastic);
    if (!scattered) {
        c.bodies[0].shape.to[0] = 11.0, c.bodies[1].is_part = false;
        c.bodies[1].velocity[1] = 1e-3;
        s->options.interface_count = 1;
        tear(s, parted);
        for (int k = 0; k < 4 * NODES; k++) CHECK_NEAR(parted[k], whole[k], 1e-11);
    }
    free(nodes);
}

static void a_body_in_parts_is_the_body(void **state)
{
    (void)state;
    compare_with_whole(false, false);
    compare_with_whole(true, true);
}

/// Evenly stretched between the two strengths, the interface's bonds break and no other; by factors at the nodes its weaker node
/// tells. Off the grid too.
static void an_interface_breaks_at_its_own_stretch(void **state)
{
    (void)state;
    for (int scattered = 0; scattered < 2; scattered++) {
        unsigned seed = 4;
        double factors[10 * 8];
        composite c;
        make_composite(&c, 2, (int[]){10, 8, 1}, 4.5, true);
        pdmc_node *nodes = scattered ? scatter_box(&c.s, (int[]){10, 8, 1}, 0.1, &seed) : NULL;
        if (scattered) c.bodies[0] = c.s.body;
        c.interface.critical_stretch = 0.01;
        c.materials[0].critical_stretch = c.materials[1].critical_stretch = 0.02;
        for (int k = 0; k < 80; k++) factors[k] = 1.0;
        c.s.options.factor_count = 80, c.s.options.strength_factors = factors;
        uint64_t between = 0;
        for (int at = 0; at < 3; at++) {
            static const double stretches[] = {0.009, 0.011, 0.0215};
            pdmc_particles *p = create(&c.s);
            for (int k = 0; k < p->nodes.node_count; k++)
                for (int a = 0; a < 2; a++)
                    p->position[a][p->nodes.cell[k]] = (1.0 + stretches[at]) * p->nodes.reference[a][p->nodes.cell[k]];
            int of_node[80], pieces;
            for (int i = 0; i < 80 && at == 0; i++)
                for (int j = 0; j < i; j++) {
                    const size_t a = p->nodes.cell[i], b = p->nodes.cell[j];
                    between += pdmc_nodes_are_near(&p->nodes, a, b) && p->nodes.body[a] != p->nodes.body[b];
                }
            CHECK_OK(pdmc_particles_advance(p, 1));
            CHECK_OK(pdmc_particles_find_fragments(p, of_node, &pieces));
            assert_int_equal(pdmc_particles_sum(p).broken, at == 0 ? 0 : at == 1 ? between : pdmc_particles_bonds(p));
            assert_int_equal(pieces, at == 0 ? 1 : at == 1 ? 2 : 80);
            uint64_t bonds, broken;
            pdmc_particles_interfaces(p, &bonds, &broken);
            assert_int_equal(bonds, between);
            assert_int_equal(broken, at == 0 ? 0 : between);
            pdmc_particles_destroy(p);
            // A weak node has weak bonds to the other side, and no weak body.
            if (at == 1)
                for (int k = 0; k < 80; k++) factors[k] = 1.05;
        }
        assert_true(between > 50);
        free(nodes);
    }
}

/// What an interface of fracture energy G_0 releases when two rigid halves are drawn apart, each bond broken at the first step at
/// which it is beyond s_0.
static double released(double horizon, int width, double fracture_energy)
{
    enum { STEPS = 1000 };
    const int half = (int)horizon + 1;
    composite c;
    make_composite(&c, 2, (int[]){2 * half, width, 1}, half, false);
    c.s.options.horizon = horizon;
    c.s.options.volume_rule = PDMC_VOLUME_PARTIAL;
    c.interface.micromodulus = pdmc_brittle_micromodulus(2, PDMC_PLANE_STRESS, 0.3, horizon, 1.0);
    c.interface.critical_stretch =
        pdmc_brittle_critical_stretch(2, fracture_energy, c.interface.micromodulus, horizon, 1.0);
    // The last bonds to break have the length horizon + 1/2 and a step of 1 across the interface: s = opening / length^2.
    const double apart = 1.05 * c.interface.critical_stretch * (horizon + 0.5) * (horizon + 0.5);
    c.s.options.step = 0.05;
    for (int k = 0; k < 2; k++)
        c.conditions[k] = (pdmc_layer_condition){.region = c.bodies[k].shape,
                                                 .along = {true, true},
                                                 .value = {(k - 0.5) * apart / (STEPS * c.s.options.step)}};
    c.s.options.condition_count = 2;
    c.s.options.conditions = c.conditions;
    pdmc_particles *p = create(&c.s);
    CHECK_OK(pdmc_particles_advance(p, STEPS));
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    CHECK_NEAR(sums.elastic, 0.0, 1e-3 * sums.fracture);
    CHECK_NEAR(sums.kinetic + sums.fracture, sums.work, 2e-3 * sums.work);
    pdmc_particles_destroy(p);
    return sums.fracture;
}

/// The lattice's sum for G_0 of a unit of area over the integral that s_0 is made of, c s_0^2 / 2 times |xi| of all bonds that cross
/// it: as many as their step across for each place along it.
static double lattice_share(double horizon)
{
    const int reach = (int)horizon + 1;
    double sum = 0.0;
    for (int x = 1; x <= reach; x++)
        for (int y = -reach; y <= reach; y++)
            sum += x * hypot(x, y) * fmax(0.0, fmin(1.0, 0.5 + horizon - hypot(x, y)));
    return 2.0 * sum / pow(horizon, 4);
}

/// Without the ends of the interface: from the difference of a wider one and a narrower one.
static void an_interface_releases_its_fracture_energy(void **state)
{
    (void)state;
    const double fracture_energy = 1e-6;
    for (int k = 0; k < 2; k++) {
        const double horizon = k ? 6.0 : 3.0;
        const double wide = released(horizon, 9, fracture_energy), narrow = released(horizon, 7, fracture_energy);
        const double share = (wide - narrow) / 2.0 / fracture_energy;
        print_message("  energy of a unit of the interface %.4f of G_0, %.4f by the lattice's sum\n", share,
                      lattice_share(horizon));
        // A step opens by a thousandth of (horizon + 1/2)^2 s_0, a bond of |xi| = 1 by as much of its length, and breaks half a step late.
        const double late = (horizon + 0.5) * (horizon + 0.5) / 1000.0;
        CHECK_NEAR(share, lattice_share(horizon), late);
    }
    CHECK_NEAR(lattice_share(12.0), 1.0, 0.005);
}

/// A stiff body with a soft part that hangs on by a weak interface is torn apart: energies balance, momentum is kept, and
/// threads change no bit.
static void energies_balance_and_threads_change_no_bit(void **state)
{
    (void)state;
    static double values[3][4 * NODES];
    pdmc_particles_sums sums[3];
    for (int threads = 1; threads <= 3; threads++) {
        composite c;
        make_composite(&c, 3, (int[]){LONG, HIGH, DEEP}, 11.5, true);
        make_brittle(&c.materials[0]);
        c.materials[1].micromodulus *= 0.3;
        c.materials[1].density = 0.7;
        c.interface.critical_stretch = 0.01;
        c.s.options.safety = 0.4;
        c.s.options.threads = threads;
        sums[threads - 1] = tear(&c.s, values[threads - 1]);
    }
    const pdmc_particles_sums *s = &sums[0];
    const double balance = s->kinetic + s->elastic + s->fracture - s->work;
    print_message("  %llu bonds broken, energy balance %.1e of the work\n", (unsigned long long)s->broken,
                  balance / s->work);
    assert_true(s->broken > 500);
    CHECK_NEAR(balance, 0.0, 3e-3 * s->work);
    for (int k = 1; k < 3; k++) {
        assert_memory_equal(values[0], values[k], sizeof values[0]);
        assert_memory_equal(&sums[0], &sums[k], sizeof sums[0]);
    }
}

/// Nodes in two parts are those of the later one, and nodes that are outside the host are nobody's.
static void the_later_part_has_the_nodes(void **state)
{
    (void)state;
    composite c;
    make_composite(&c, 2, (int[]){10, 4, 1}, 3.0, true);
    const pdmc_body bodies[] = {c.bodies[0],
                                {.shape = {.from = {3, 0, 0}, .to = {6, 9, 0}}, .is_part = true},
                                {.shape = {.from = {5, 2, 0}, .to = {30, 9, 0}}, .is_part = true}};
    c.s.options.bodies = bodies, c.s.options.body_count = 3;
    c.s.options.interface_count = 0;
    pdmc_particles *p = create(&c.s);
    double x[3 * 40];
    int body[40];
    assert_int_equal(pdmc_particles_count(p), 40);
    pdmc_particles_reference(p, x, body);
    for (int k = 0; k < 40; k++) {
        const bool in_second = x[3 * k] >= 5.0 && x[3 * k + 1] >= 2.0, in_first = x[3 * k] >= 3.0 && x[3 * k] <= 6.0;
        assert_int_equal(body[k], in_second ? 2 : in_first ? 1 : 0);
    }
    pdmc_particles_destroy(p);
}

/// The stable step is that of a light body's node behind a stiff interface, by definition.
static void the_step_is_that_of_the_stiffest_joint(void **state)
{
    (void)state;
    composite c;
    make_chain(&c, 10, 5.0);
    c.interface.micromodulus = 30.0;
    c.materials[1].density = 0.1;
    pdmc_particles *p = create(&c.s);
    CHECK_NEAR(pdmc_particles_stable_step(p), sqrt(2.0 * 0.1 / (30.0 + 0.5)), 1e-14);
    pdmc_particles_destroy(p);
}

static void refuse(const specimen *s, const char *message)
{
    pdmc_particles *p = NULL;
    CHECK_STATUS(pdmc_particles_create(&s->options, &p), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), message);
}

static void what_cannot_be(void **state)
{
    (void)state;
    composite c;
    make_composite(&c, 2, (int[]){10, 6, 1}, 7.0, true);
    c.bodies[1].shape.from[0] = c.bodies[1].shape.to[0] = 30.0;
    refuse(&c.s, "bodies[1]: holds no node of bodies[0]");
    c.bodies[1].is_part = false;
    c.interface.second = 1;
    refuse(&c.s, "interfaces[0]: it is between a body and itself");
    c.interface.second = 2;
    refuse(&c.s, "interfaces[0]: it is between 1 and 2, there are 2");
    c.interface.second = 0;
    refuse(&c.s, "interfaces[0]: no bond is between the two");
    c.bodies[0].is_part = true;
    refuse(&c.s, "bodies[0]: its host needs to be an earlier body that is no part of another");
    make_composite(&c, 2, (int[]){10, 6, 1}, 7.0, true);
    const double strengths[PDMC_STRENGTH_CLASSES] = {0.0};
    c.materials[1].strengths = strengths;
    refuse(&c.s, "materials[1]: where bodies have bonds, all materials need the same strengths");
    c.materials[1].strengths = NULL;
    double factors[60];
    for (int k = 0; k < 60; k++) factors[k] = 1.0;
    c.s.options.factor_count = 60, c.s.options.strength_factors = factors;
    pdmc_particles *p = NULL;
    CHECK_FAILS_CLEANLY(pdmc_particles_create(&c.s.options, &p), pdmc_particles_destroy(p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(compliances_add_up),
        cmocka_unit_test(waves_are_reflected_by_impedances),
        cmocka_unit_test(a_body_in_parts_is_the_body),
        cmocka_unit_test(an_interface_breaks_at_its_own_stretch),
        cmocka_unit_test(an_interface_releases_its_fracture_energy),
        cmocka_unit_test(energies_balance_and_threads_change_no_bit),
        cmocka_unit_test(the_later_part_has_the_nodes),
        cmocka_unit_test(the_step_is_that_of_the_stiffest_joint),
        cmocka_unit_test(what_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
