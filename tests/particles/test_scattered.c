// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/scattered.h"

#include "particles/bisection.h"
#include "particles/bodies.h"
#include "particles/particles_impl.h"

/// Of a grid of 8 x 16 x 8 points in any order, every group of eight is a cube of neighbours, and every point is in one.
static void groups_are_cubes(void **state)
{
    (void)state;
    enum { COUNT = 8 * 16 * 8 };
    double at[PDMC_AXES][COUNT];
    int order[COUNT];
    bool found[COUNT] = {false};
    for (int k = 0; k < COUNT; k++) {
        const int point = k * 389 % COUNT; // 389 and 1024 have no divisor in common
        at[0][k] = point % 8, at[1][k] = point / 8 % 16, at[2][k] = point / 128;
        order[k] = k;
    }
    CHECK_OK(pdmc_bisect((const double *const[]){at[0], at[1], at[2]}, COUNT, 8, order));
    for (int k = 0; k < COUNT; k++) {
        assert_false(found[order[k]]);
        found[order[k]] = true;
        for (int a = 0; a < PDMC_AXES; a++) CHECK_NEAR(at[a][order[k]], at[a][order[k - k % 8]], 1.0);
    }
}

/// A notched plate that a sphere hits and that a layer holds, with everything that the engine knows.
typedef struct {
    specimen s;
    pdmc_layer_condition held;
    pdmc_planar_crack crack;
    pdmc_rigid_sphere sphere;
} impact;

static const int wide[] = {22, 21, 4};

static void make_impact(impact *i)
{
    make_box(&i->s, 3, wide);
    i->s.material.critical_stretch = 0.03;
    i->s.material.strengthening = 0.25;
    i->s.options.volume_rule = PDMC_VOLUME_PARTIAL;
    i->s.options.contact_distance = 0.95;
    i->s.options.contact_stiffness = 15.0;
    i->s.options.step = 0.4; // the stable one is that of a whole family on a grid, and of the nodes' own off it
    i->held = (pdmc_layer_condition){.region = {.kind = PDMC_SHAPE_BOX, .to = {1, 20, 3}}, .along = {true, true, true}};
    i->crack = (pdmc_planar_crack){.kind = PDMC_CRACK_DISC, .centre = {14.1, 9, 0}, .normal = {1, 0, 0.2}, .radius = 4};
    i->sphere = (pdmc_rigid_sphere){
        .radius = 6.0, .centre = {12.3, 9.1, 9.05}, .velocity = {0, 0, -0.5}, .mass = 300.0, .stiffness = 0.1};
    i->s.options.condition_count = i->s.options.crack_count = i->s.options.sphere_count = 1;
    i->s.options.conditions = &i->held;
    i->s.options.cracks = &i->crack;
    i->s.options.spheres = &i->sphere;
}

/// The nodes of the grid, given one by one, move as those of the grid do: to rounding, that of positions of 20 in 40 steps with
/// what breaking bonds make of it; and the same bonds break.
static void nodes_of_a_grid_move_as_the_grid(void **state)
{
    (void)state;
    enum { NODES = 22 * 21 * 4 };
    static double u[2][3 * NODES], v[2][3 * NODES], damage[2][NODES];
    pdmc_particles_sums sums[2];
    impact i;
    unsigned seed = 1;
    make_impact(&i);
    pdmc_node *nodes = NULL;
    for (int scattered = 0; scattered < 2; scattered++) {
        if (scattered) nodes = scatter_box(&i.s, wide, 0.0, &seed);
        pdmc_particles *p = create(&i.s);
        assert_int_equal(pdmc_particles_count(p), NODES);
        CHECK_OK(pdmc_particles_advance(p, 40));
        pdmc_particles_state(p, u[scattered], v[scattered], damage[scattered]);
        sums[scattered] = pdmc_particles_sum(p);
        pdmc_particles_destroy(p);
    }
    free(nodes);
    assert_true(sums[0].broken > 5000 && sums[0].contact > 1e-6);
    assert_int_equal(sums[0].broken, sums[1].broken);
    assert_memory_equal(damage[0], damage[1], sizeof damage[0]);
    for (int k = 0; k < 3 * NODES; k++) {
        CHECK_NEAR(u[1][k], u[0][k], 1e-10);
        CHECK_NEAR(v[1][k], v[0][k], 1e-10);
    }
    CHECK_NEAR(sums[1].elastic, sums[0].elastic, 1e-10 * sums[0].elastic);
    CHECK_NEAR(sums[1].fracture, sums[0].fracture, 1e-10 * sums[0].fracture);
    CHECK_NEAR(sums[1].contact, sums[0].contact, 1e-10 * sums[0].contact);
    CHECK_NEAR(sums[1].work, sums[0].work, 1e-10 * fabs(sums[0].work) + 1e-12);
}

/// The same bits whatever the number of threads.
static void threads_change_no_bit(void **state)
{
    (void)state;
    enum { NODES = 22 * 21 * 4 };
    static double values[3][7 * NODES];
    pdmc_particles_sums sums[3];
    impact i;
    unsigned seed = 1;
    make_impact(&i);
    pdmc_node *nodes = scatter_box(&i.s, wide, 0.2, &seed);
    for (int threads = 1; threads <= 3; threads++) {
        double *now = values[threads - 1];
        i.s.options.threads = threads;
        pdmc_particles *p = create(&i.s);
        CHECK_OK(pdmc_particles_advance(p, 40));
        pdmc_particles_state(p, now, &now[3 * NODES], &now[6 * NODES]);
        sums[threads - 1] = pdmc_particles_sum(p);
        pdmc_particles_destroy(p);
    }
    free(nodes);
    assert_true(sums[0].broken > 5000);
    for (int k = 1; k < 3; k++) {
        assert_memory_equal(values[0], values[k], sizeof values[0]);
        assert_memory_equal(&sums[0], &sums[k], sizeof sums[0]);
    }
}

/// Without anything that holds the plate: momentum to rounding of 1848 nodes in 60 steps, while bonds break.
static void momentum_is_kept(void **state)
{
    (void)state;
    impact i;
    unsigned seed = 1;
    make_impact(&i);
    i.s.options.condition_count = 0;
    pdmc_node *nodes = scatter_box(&i.s, wide, 0.2, &seed);
    pdmc_particles *p = create(&i.s);
    const pdmc_particles_sums first = pdmc_particles_sum(p);
    CHECK_OK(pdmc_particles_advance(p, 60));
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    assert_true(sums.broken > first.broken + 2000);
    for (int a = 0; a < PDMC_AXES; a++) CHECK_NEAR(sums.momentum[a], first.momentum[a], 1e-11);
    pdmc_particles_destroy(p);
    free(nodes);
}

/// The error of the energy at a time at which the sphere is deep in the plate, without breaking.
static double energy_error(double step)
{
    impact i;
    unsigned seed = 1;
    make_impact(&i);
    i.s.options.step = step;
    i.s.material.critical_stretch = INFINITY;
    pdmc_node *nodes = scatter_box(&i.s, wide, 0.2, &seed);
    pdmc_particles *p = create(&i.s);
    CHECK_OK(pdmc_particles_advance(p, (int)round(8.0 / step)));
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    assert_true(sums.elastic > 0.1 * sums.first && sums.contact > 0.01 * sums.first);
    pdmc_particles_destroy(p);
    free(nodes);
    return (sums.kinetic + sums.elastic + sums.contact - sums.work) / sums.first - 1.0;
}

/// Of second order in the step, with volumes that differ.
static void energy_balance(void **state)
{
    (void)state;
    const double coarse = energy_error(0.4), fine = energy_error(0.2);
    print_message("  energy off by %.1e, by %.1e with half the step\n", coarse, fine);
    CHECK_NEAR(fine / coarse, 0.25, 0.1);
}

/// A body that turns by a right angle: bonds are as long as before.
static void rotation_stretches_nothing(void **state)
{
    (void)state;
    specimen s;
    unsigned seed = 5;
    make_box(&s, 3, (int[]){9, 7, 5});
    pdmc_node *nodes = scatter_box(&s, (int[]){9, 7, 5}, 0.3, &seed);
    pdmc_particles *p = create(&s);
    for (size_t c = 0; c < p->nodes.cells; c++) {
        const double x = p->position[0][c];
        p->position[0][c] = -p->position[1][c];
        p->position[1][c] = x;
    }
    // About 30,000 bonds of energy c s^2 / 4, with a stretch of a few roundings each.
    CHECK_NEAR(pdmc_particles_sum(p).elastic, 0.0, 3e4 * s.material.micromodulus * 1e-30);
    pdmc_particles_destroy(p);
    free(nodes);
}

/// Eq. 46 by definition, over every node's bonds.
static void stable_step(void **state)
{
    (void)state;
    specimen s;
    unsigned seed = 5;
    double largest = 0.0;
    make_box(&s, 2, (int[]){12, 9, 1});
    pdmc_node *nodes = scatter_box(&s, (int[]){12, 9, 1}, 0.3, &seed);
    for (int i = 0; i < s.body.node_count; i++) {
        double sum = 0.0;
        for (int j = 0; j < s.body.node_count; j++) {
            const double length = hypot(nodes[i].x[0] - nodes[j].x[0], nodes[i].x[1] - nodes[j].x[1]);
            if (i != j && length <= 3.0) sum += nodes[j].volume * s.material.micromodulus / length;
        }
        largest = fmax(largest, sum);
    }
    pdmc_particles *p = create(&s);
    CHECK_NEAR(pdmc_particles_stable_step(p), sqrt(2.0 / largest), 1e-13);
    pdmc_particles_destroy(p);
    free(nodes);
}

/// Six times the volume of a tetrahedron, with its sign.
static double orientation(const double a[], const double b[], const double c[], const double d[])
{
    double u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) u[k] = b[k] - a[k], v[k] = c[k] - a[k], w[k] = d[k] - a[k];
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// By signs of volumes alone: without a point of intersection.
static bool crosses_triangle(const double p[], const double q[], const double a[], const double b[], const double c[])
{
    if ((orientation(a, b, c, p) > 0.0) == (orientation(a, b, c, q) > 0.0)) return false;
    const bool first = orientation(p, q, a, b) > 0.0;
    return first == (orientation(p, q, b, c) > 0.0) && first == (orientation(p, q, c, a) > 0.0);
}

/// A rectangle as two triangles, a segment through all z as a tall rectangle.
static bool crosses(const pdmc_planar_crack *crack, const double p[], const double q[])
{
    double corner[4][3];
    const double sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++) {
            corner[k][a] = crack->centre[a] + sign[k][0] * crack->side[0][a] + sign[k][1] * crack->side[1][a];
            if (crack->kind == PDMC_CRACK_SEGMENT)
                corner[k][a] = a == 2 ? 100.0 * sign[k][1] : sign[k][0] < 0.0 ? crack->from[a] : crack->to[a];
        }
    return crosses_triangle(p, q, corner[0], corner[1], corner[2]) ||
           crosses_triangle(p, q, corner[0], corner[2], corner[3]);
}

/// Every pair within the horizon, by brute force: the bonds that are left of each node are those that do not cross.
static void check_crack(const pdmc_planar_crack *crack)
{
    specimen s;
    unsigned seed = 11;
    make_box(&s, 3, (int[]){10, 9, 6});
    pdmc_node *nodes = scatter_box(&s, (int[]){10, 9, 6}, 0.4, &seed);
    s.options.crack_count = 1;
    s.options.cracks = crack;
    pdmc_particles *p = create(&s);
    const pdmc_nodes *g = &p->nodes;
    int cut = 0;
    for (int b = 0; b < g->block_count; b++) {
        int whole[PDMC_LANES];
        pdmc_nodes_whole(g, &g->blocks[b], whole);
        for (int k = 0; k < PDMC_LANES && (g->blocks[b].nodes >> k & 1); k++) {
            const int i = g->node[g->blocks[b].cell + (size_t)k];
            int near = 0, crossing = 0;
            for (int j = 0; j < s.body.node_count; j++) {
                double square = 0.0;
                for (int a = 0; a < PDMC_AXES; a++) square += pow(nodes[i].x[a] - nodes[j].x[a], 2);
                if (i == j || square > 9.0) continue;
                near++;
                crossing += crosses(crack, nodes[i].x, nodes[j].x);
            }
            assert_int_equal(g->family[g->cell[i]], near);
            assert_int_equal(whole[k], near - crossing);
            cut += crossing;
        }
    }
    assert_true(cut > 1000);
    assert_int_equal(pdmc_particles_sum(p).broken, cut / 2);
    pdmc_particles_destroy(p);
    free(nodes);
}

static void cracks_cut_what_crosses_them(void **state)
{
    (void)state;
    const pdmc_planar_crack rectangle = {
        .kind = PDMC_CRACK_RECTANGLE, .centre = {4.1, 4.2, 2.3}, .side = {{3.0, 0.5, 0.0}, {-0.3, 1.8, 1.5}}};
    const pdmc_planar_crack segment = {.kind = PDMC_CRACK_SEGMENT, .from = {1.3, 2.2}, .to = {6.4, 5.7}};
    check_crack(&rectangle);
    check_crack(&segment);
}

static void refuse(specimen *s, const char *words)
{
    pdmc_particles *p = NULL;
    CHECK_STATUS(pdmc_particles_create(&s->options, &p), PDMC_ERR_ARG);
    if (!strstr(pdmc_last_error(), words)) fail_msg("\"%s\" is not in \"%s\"", words, pdmc_last_error());
}

static void bad_nodes_are_refused(void **state)
{
    (void)state;
    specimen s;
    unsigned seed = 5;
    make_box(&s, 3, (int[]){5, 4, 3});
    pdmc_node *nodes = scatter_box(&s, (int[]){5, 4, 3}, 0.3, &seed), good = nodes[17];
    nodes[17].x[1] = NAN;
    refuse(&s, "node 17");
    nodes[17] = good, nodes[17].volume = 0.0;
    refuse(&s, "node 17 has the volume 0");
    nodes[17] = nodes[41];
    refuse(&s, "in the same place");
    nodes[17] = good, nodes[17].x[2] = 20.0;
    refuse(&s, "has no other to be bonded with within 3");
    nodes[17] = good, s.body.node_count = 0;
    refuse(&s, "no node");
    free(nodes);
}

static void memory_that_runs_out_is_said(void **state)
{
    (void)state;
    specimen s;
    unsigned seed = 5;
    pdmc_particles *p = NULL;
    make_box(&s, 2, (int[]){7, 6, 1});
    pdmc_node *nodes = scatter_box(&s, (int[]){7, 6, 1}, 0.2, &seed);
    const pdmc_body bodies[] = {s.body, {.shape = {.kind = PDMC_SHAPE_BOX, .from = {8, 0, 0}, .to = {12, 5, 0}}}};
    s.options.bodies = bodies;
    s.options.body_count = 2;
    CHECK_FAILS_CLEANLY(pdmc_particles_create(&s.options, &p), pdmc_particles_destroy(p));
    free(nodes);
}

/// Two bodies, one of the grid and one with nodes of its own: no bonds between them, and they push each other back.
static void bodies_of_both_kinds_meet(void **state)
{
    (void)state;
    specimen s;
    unsigned seed = 5;
    make_box(&s, 3, (int[]){6, 6, 6});
    pdmc_node *nodes = scatter_box(&s, (int[]){6, 6, 6}, 0.2, &seed);
    pdmc_body bodies[2] = {s.body, s.body};
    bodies[0].velocity[0] = 0.02;
    bodies[1] = (pdmc_body){.shape = {.kind = PDMC_SHAPE_BOX, .from = {7, 0, 0}, .to = {12, 5, 5}}};
    s.options.bodies = bodies;
    s.options.body_count = 2;
    s.options.contact_distance = 0.9;
    s.options.contact_stiffness = 15.0;
    pdmc_particles *p = create(&s);
    int body[2 * 216];
    double x[3 * 2 * 216], v[3 * 2 * 216], velocity[2] = {0.0};
    assert_int_equal(pdmc_particles_count(p), 2 * 216);
    pdmc_particles_reference(p, x, body);
    CHECK_NEAR(x[3 * 215], 12.0, 0.0);                // those of the grid first
    CHECK_NEAR(x[3 * (216 + 7)], nodes[7].x[0], 0.0); // then the others as they were given
    for (int k = 0; k < 2 * 216; k++) assert_int_equal(body[k], k < 216);
    const uint64_t bonds = pdmc_particles_bonds(p);
    CHECK_OK(pdmc_particles_advance(p, 1000));
    pdmc_particles_state(p, NULL, v, NULL);
    for (int k = 0; k < 2 * 216; k++) velocity[body[k]] += v[3 * k] / 216.0;
    assert_true(velocity[1] > 0.01 && velocity[0] < 0.01); // body 0 has pushed body 1
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    double momentum = 0.0;
    for (int k = 0; k < 216; k++) momentum += 0.02 * nodes[k].volume;
    CHECK_NEAR(sums.momentum[0], momentum, 1e-11);
    assert_int_equal(sums.broken, 0);
    assert_int_equal(pdmc_particles_bonds(p), bonds);
    pdmc_particles_destroy(p);
    free(nodes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_are_cubes),
        cmocka_unit_test(nodes_of_a_grid_move_as_the_grid),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(momentum_is_kept),
        cmocka_unit_test(energy_balance),
        cmocka_unit_test(rotation_stretches_nothing),
        cmocka_unit_test(stable_step),
        cmocka_unit_test(cracks_cut_what_crosses_them),
        cmocka_unit_test(bad_nodes_are_refused),
        cmocka_unit_test(memory_that_runs_out_is_said),
        cmocka_unit_test(bodies_of_both_kinds_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
