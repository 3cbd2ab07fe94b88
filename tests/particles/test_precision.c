// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particles_impl.h"

#include "particles/bodies.h"

#include <math.h>

static const double rounding = 0x1p-24; // of a number in single precision, relative to it

static double *zeros(const pdmc_particles *p)
{
    double *x = pdmc_calloc(p->nodes.cells + PDMC_LANES, sizeof *x);
    assert_non_null(x);
    return x;
}

/// Gives the nodes the places X -> A X + b, in single precision too.
static void place(pdmc_particles *p, double A[3][3], const double b[3])
{
    for (int k = 0; k < p->nodes.node_count; k++) {
        const size_t c = p->nodes.cell[k];
        for (int i = 0; i < 3; i++) {
            p->position[i][c] = b[i];
            for (int j = 0; j < 3; j++) p->position[i][c] += A[i][j] * p->nodes.reference[j][c];
        }
    }
    for (int k = 0; k < p->nodes.block_count; k++)
        pdmc_single_follow(&p->single, &p->nodes, &p->nodes.blocks[k], p->position);
}

static double largest_force(const pdmc_particles *p, pdmc_precision precision)
{
    double *force[] = {zeros(p), zeros(p), zeros(p)}, largest = 0.0;
    pdmc_particles_find_forces_in(p, precision, force);
    for (size_t c = 0; c < p->nodes.cells; c++)
        for (int a = 0; a < 3; a++) largest = fmax(largest, fabs(force[a][c]));
    for (int a = 0; a < 3; a++) pdmc_free(force[a]);
    return largest;
}

/// A right angle about an axis off the nodes: stretches, and so forces, are those of rounded displacements. A displacement of
/// at most 16 is wrong by at most 16 roundings, eta by twice that and by its own, which is a stretch of three times as much where
/// |xi| = 1; c times the volume of all neighbours is the sum of the bonds' stiffness.
static void rotation_stretches_nothing(void **state)
{
    (void)state;
    for (int scattered = 0; scattered < 2; scattered++) {
        specimen s;
        unsigned seed = 5;
        make_box(&s, 3, (int[]){9, 7, 5});
        s.options.offset[0] = 0.3;
        s.body.shape.to[0] += 0.3;
        s.options.precision = PDMC_PRECISION_SINGLE;
        pdmc_node *nodes = scattered ? scatter_box(&s, (int[]){9, 7, 5}, 0.2, &seed) : NULL;
        pdmc_particles *p = create(&s);
        place(p, (double[3][3]){{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, (double[3]){0.4, 0.1, 0.7});
        const double allowed = 3.0 * 16.0 * rounding * s.material.micromodulus * p->nodes.heaviest;
        const double in_single = largest_force(p, PDMC_PRECISION_SINGLE);
        print_message("  turned by a right angle: forces up to %.2g, allowed %.2g\n", in_single, allowed);
        assert_true(in_single > 0.0 && in_single < allowed);
        pdmc_particles_destroy(p);
        free(nodes);
    }
}

/// An even stretch, of which only the nodes at the surface have forces, as it lies and after a long way: what is said is
/// what displacements are rounded by, over the stretch.
static void the_difference_is_said(void **state)
{
    (void)state;
    const double stretch = 1e-3, way[] = {0.0, 1e3};
    double difference[2];
    specimen s;
    make_box(&s, 3, (int[]){9, 7, 5});
    s.options.precision = PDMC_PRECISION_SINGLE;
    pdmc_particles *p = create(&s);
    CHECK_OK(pdmc_particles_precision(p, &difference[0]));
    assert_true(difference[0] < 1e-4); // before anything moves: 2^-38 over 2^-24
    for (int k = 0; k < 2; k++) {
        place(p, (double[3][3]){{1 + stretch, 0, 0}, {0, 1 + stretch, 0}, {0, 0, 1 + stretch}},
              (double[3]){way[k], 0, 0});
        CHECK_OK(pdmc_particles_precision(p, &difference[k]));
    }
    print_message("  stretch of %g: forces differ by %.2g, after %g spacings by %.2g\n", stretch, difference[0], way[1],
                  difference[1]);
    assert_true(difference[0] > 0.1 * rounding && difference[0] < 100.0 * rounding);
    assert_true(difference[1] > 0.1 * way[1] * rounding / stretch &&
                difference[1] < 10.0 * way[1] * rounding / stretch);
    pdmc_particles_destroy(p);

    s.options.precision = PDMC_PRECISION_DOUBLE;
    p = create(&s);
    CHECK_OK(pdmc_particles_precision(p, &difference[0]));
    CHECK_NEAR(difference[0], 0.0, 0.0);
    pdmc_particles_destroy(p);
}

enum { NODES = 22 * 21 * 4 };

typedef struct {
    specimen s;
    pdmc_layer_condition held;
    pdmc_planar_crack crack;
    pdmc_rigid_sphere sphere;
    pdmc_node *nodes; // NULL: those of the grid
} impact;

/// A plate with a crack and a held edge under a heavy sphere: bonds break, nodes touch.
static void make_impact(impact *i, bool scattered)
{
    const int size[] = {22, 21, 4};
    unsigned seed = 1;
    *i = (impact){0};
    make_box(&i->s, 3, size);
    i->s.material.critical_stretch = 0.03;
    i->s.material.strengthening = 0.25;
    i->s.options.volume_rule = PDMC_VOLUME_PARTIAL;
    i->s.options.contact_distance = 0.95;
    i->s.options.contact_stiffness = 15.0;
    i->held = (pdmc_layer_condition){.region = {.kind = PDMC_SHAPE_BOX, .to = {1, 20, 3}}, .along = {true, true, true}};
    i->crack = (pdmc_planar_crack){.kind = PDMC_CRACK_DISC, .centre = {14.1, 9, 0}, .normal = {1, 0, 0.2}, .radius = 4};
    i->sphere = (pdmc_rigid_sphere){
        .radius = 6.0, .centre = {12.3, 9.1, 9.05}, .velocity = {0, 0, -0.5}, .mass = 300.0, .stiffness = 0.1};
    i->s.options.condition_count = i->s.options.crack_count = i->s.options.sphere_count = 1;
    i->s.options.conditions = &i->held;
    i->s.options.cracks = &i->crack;
    i->s.options.spheres = &i->sphere;
    if (scattered) i->nodes = scatter_box(&i->s, size, 0.2, &seed);
}

typedef struct {
    double values[7 * NODES], difference;
    pdmc_particles_sums sums;
} outcome;

static void run(impact *i, pdmc_precision precision, int threads, outcome *o)
{
    i->s.options.precision = precision;
    i->s.options.threads = threads;
    pdmc_particles *p = create(&i->s);
    CHECK_OK(pdmc_particles_advance(p, 40));
    pdmc_particles_state(p, o->values, &o->values[3 * NODES], &o->values[6 * NODES]);
    o->sums = pdmc_particles_sum(p);
    CHECK_OK(pdmc_particles_precision(p, &o->difference));
    pdmc_particles_destroy(p);
}

/// Bonds break alike but for those that are stretched to s_0 within the rounding, which is 1e-5 of it: of 6000 that break
/// within 40 steps hardly one. A bond that breaks a step later moves its nodes by 1e-4 of the largest displacement.
static void both_precisions_break_alike(void **state)
{
    (void)state;
    static outcome in_double, in_single;
    for (int scattered = 0; scattered < 2; scattered++) {
        impact i;
        make_impact(&i, scattered);
        run(&i, PDMC_PRECISION_DOUBLE, 1, &in_double);
        run(&i, PDMC_PRECISION_SINGLE, 1, &in_single);
        double farthest = 0.0, most = 0.0;
        for (int k = 0; k < 3 * NODES; k++) {
            farthest = fmax(farthest, fabs(in_single.values[k] - in_double.values[k]));
            most = fmax(most, fabs(in_double.values[k]));
        }
        print_message("  forces differ by %.2g, displacements by %.2g, elastic energy by %.2g; %d and %d bonds broke\n",
                      in_single.difference, farthest / most, in_single.sums.elastic / in_double.sums.elastic - 1.0,
                      (int)in_double.sums.broken, (int)in_single.sums.broken);
        assert_true(in_double.sums.broken > 5000 && in_double.sums.contact > 0.0);
        assert_true(in_single.difference > 0.1 * rounding && in_single.difference < 1e-5);
        CHECK_NEAR((double)in_single.sums.broken, (double)in_double.sums.broken, 2.0);
        CHECK_NEAR(in_single.sums.elastic / in_double.sums.elastic, 1.0, 1e-4);
        assert_true(farthest > 0.0 && farthest < 1e-3 * most);
        free(i.nodes);
    }
}

/// The same bits whatever the number of threads.
static void threads_change_no_bit(void **state)
{
    (void)state;
    static outcome one, three;
    for (int scattered = 0; scattered < 2; scattered++) {
        impact i;
        make_impact(&i, scattered);
        run(&i, PDMC_PRECISION_SINGLE, 1, &one);
        run(&i, PDMC_PRECISION_SINGLE, 3, &three);
        assert_memory_equal(one.values, three.values, sizeof one.values);
        assert_memory_equal(&one.sums, &three.sums, sizeof one.sums);
        free(i.nodes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotation_stretches_nothing),
        cmocka_unit_test(the_difference_is_said),
        cmocka_unit_test(both_precisions_break_alike),
        cmocka_unit_test(threads_change_no_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
