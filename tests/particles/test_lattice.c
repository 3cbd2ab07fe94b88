// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/lattice.h"

#include "particles/bodies.h"

static double distance(const double a[], const double b[])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/// Whether the lattice holds the bond from node i to node j, by the bits of i's block.
static bool is_bonded(const pdmc_nodes *g, size_t i, size_t j)
{
    for (int b = 0; b < g->block_count; b++) {
        const pdmc_block *block = &g->blocks[b];
        if (i < block->cell || i >= block->cell + PDMC_LANES || !(block->nodes >> (i - block->cell) & 1)) continue;
        for (int n = 0; n < block->listed; n++)
            if ((ptrdiff_t)i + g->neighbours[g->lists[block->list + n]].shift == (ptrdiff_t)j)
                return g->bonds[block->bonds + (size_t)n] >> (i - block->cell) & 1;
    }
    return false;
}

static void node_at(const pdmc_nodes *g, size_t cell, double x[])
{
    for (int a = 0; a < PDMC_AXES; a++) x[a] = g->reference[a][cell];
}

/// Two bodies that touch, a ball and a bar across its side: bonds are those between nodes of one body within the horizon, for
/// every pair of nodes, and in both directions.
static void bonds_are_those_within_the_horizon(void **state)
{
    (void)state;
    const pdmc_body bodies[] = {
        {.shape = {.kind = PDMC_SHAPE_BALL, .centre = {0.2, -0.1, 0.3}, .radius = 3.9}},
        {.shape = {.kind = PDMC_SHAPE_CYLINDER, .from = {6.0, -5.0, 0.0}, .to = {6.0, 6.0, 0.0}, .radius = 1.5}},
    };
    specimen s;
    make_box(&s, 3, (int[]){1, 1, 1});
    s.options.body_count = 2;
    s.options.bodies = bodies;
    pdmc_nodes g;
    CHECK_OK(pdmc_lattice_create(&s.options, &(pdmc_joints){0}, &g));
    for (int i = 0; i < g.node_count; i++) {
        int family = 0;
        for (int j = 0; j < g.node_count; j++) {
            double x[PDMC_AXES], y[PDMC_AXES];
            node_at(&g, g.cell[i], x);
            node_at(&g, g.cell[j], y);
            const bool same =
                pdmc_shape_holds(&bodies[1].shape, x, 1e-9) == pdmc_shape_holds(&bodies[1].shape, y, 1e-9);
            const bool wanted = i != j && same && distance(x, y) <= 3.0;
            assert_int_equal(is_bonded(&g, g.cell[i], g.cell[j]), wanted);
            family += wanted;
        }
        assert_int_equal(g.family[g.cell[i]], family);
    }
    pdmc_nodes_clear(&g);
}

/// Nodes of a region, counted by their coordinates.
static void nodes_fill_the_region(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){1, 1, 1});
    s.body.shape = (pdmc_shape){.kind = PDMC_SHAPE_CYLINDER, .from = {0, 0, -2.5}, .to = {0, 0, 2.5}, .radius = 10.0};
    s.options.offset[2] = 0.5;
    int wanted = 0;
    for (int x = -10; x <= 10; x++)
        for (int y = -10; y <= 10; y++) wanted += 6 * (x * x + y * y <= 100);
    pdmc_nodes g;
    CHECK_OK(pdmc_lattice_create(&s.options, &(pdmc_joints){0}, &g));
    assert_int_equal(g.node_count, wanted);
    assert_true(g.bond_bytes < (size_t)wanted * 122);
    pdmc_nodes_clear(&g);
}

static bool crosses_disc(const double x[], const double y[], const double radius)
{
    if ((x[2] < 0.5) == (y[2] < 0.5)) return false;
    const double share = (0.5 - x[2]) / (y[2] - x[2]);
    return hypot(x[0] + share * (y[0] - x[0]) - 4.5, x[1] + share * (y[1] - x[1]) - 4.5) <= radius;
}

/// A disc and a rectangle in the plane z = 1/2, a segment in the plane: cut are the bonds that cross them, and no other.
static void cracks_cut_what_crosses_them(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){10, 10, 4});
    const pdmc_planar_crack disc = {
        .kind = PDMC_CRACK_DISC, .centre = {4.5, 4.5, 0.5}, .normal = {0, 0, 2}, .radius = 3.3};
    const pdmc_planar_crack square = {
        .kind = PDMC_CRACK_RECTANGLE, .centre = {4.5, 4.5, 0.5}, .side = {{2.2, 0, 0}, {0, 3.2, 0}}};
    pdmc_nodes g;
    for (int kind = 0; kind < 2; kind++) {
        CHECK_OK(pdmc_lattice_create(&s.options, &(pdmc_joints){0}, &g));
        CHECK_OK(pdmc_nodes_cut(&g, 1, kind == 0 ? &disc : &square));
        int cut = 0;
        for (int i = 0; i < g.node_count; i++) {
            for (int j = 0; j < g.node_count; j++) {
                double x[PDMC_AXES], y[PDMC_AXES];
                node_at(&g, g.cell[i], x);
                node_at(&g, g.cell[j], y);
                if (i == j || distance(x, y) > 3.0) continue;
                bool wanted = crosses_disc(x, y, 3.3);
                if (kind == 1 && (x[2] < 0.5) != (y[2] < 0.5)) {
                    const double share = (0.5 - x[2]) / (y[2] - x[2]);
                    wanted = fabs(x[0] + share * (y[0] - x[0]) - 4.5) <= 2.2 &&
                             fabs(x[1] + share * (y[1] - x[1]) - 4.5) <= 3.2;
                }
                assert_int_equal(is_bonded(&g, g.cell[i], g.cell[j]), !wanted);
                cut += wanted;
            }
        }
        assert_true(cut > 100);
        pdmc_nodes_clear(&g);
    }
}

static void refusals(void **state)
{
    (void)state;
    specimen s;
    pdmc_particles *particles = NULL;
    make_box(&s, 2, (int[]){5, 5, 1});
    s.body.shape.from[0] = s.body.shape.to[0] = 0.5;
    CHECK_STATUS(pdmc_particles_create(&s.options, &particles), PDMC_ERR_ARG);
    make_box(&s, 2, (int[]){5, 5, 1});
    s.options.step = 100.0;
    CHECK_STATUS(pdmc_particles_create(&s.options, &particles), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "step: 100 is too large, must be at most"));
    make_box(&s, 2, (int[]){2, 1, 1});
    const pdmc_planar_crack crack = {.kind = PDMC_CRACK_SEGMENT, .from = {0.5, -1}, .to = {0.5, 1}};
    s.options.crack_count = 1;
    s.options.cracks = &crack;
    CHECK_STATUS(pdmc_particles_create(&s.options, &particles), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "cracks[0]: cuts all bonds of the node at (0, 0, 0)"));
    make_box(&s, 2, (int[]){5, 5, 1});
    const pdmc_planar_crack beside = {.kind = PDMC_CRACK_SEGMENT, .from = {5.5, -1}, .to = {5.5, 1}};
    s.options.crack_count = 1;
    s.options.cracks = &beside;
    CHECK_STATUS(pdmc_particles_create(&s.options, &particles), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "cracks[0]: crosses no bond"));
    make_box(&s, 2, (int[]){5, 5, 1});
    const pdmc_body bodies[] = {s.body, {.shape = {.kind = PDMC_SHAPE_BOX, .from = {4, 3, 0}, .to = {9, 9, 0}}}};
    s.options.body_count = 2;
    s.options.bodies = bodies;
    CHECK_STATUS(pdmc_particles_create(&s.options, &particles), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "bodies[1]: overlaps bodies[0], both have the node at (4, 3, 0)"));
    assert_null(particles);
}

static void no_memory(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){8, 8, 1});
    s.options.contact_distance = 0.9;
    s.options.contact_stiffness = 1.0;
    const double time[] = {0.0, 1.0}, factor[] = {0.0, 1.0};
    const pdmc_layer_condition condition = {.region = {.kind = PDMC_SHAPE_BOX, .to = {7, 1, 0}},
                                            .along = {false, true},
                                            .value = {0, 1},
                                            .history = {2, time, factor}};
    s.options.condition_count = 1;
    s.options.conditions = &condition;
    pdmc_particles *particles = NULL;
    CHECK_FAILS_CLEANLY(pdmc_particles_create(&s.options, &particles), pdmc_particles_destroy(particles));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bonds_are_those_within_the_horizon),
        cmocka_unit_test(nodes_fill_the_region),
        cmocka_unit_test(cracks_cut_what_crosses_them),
        cmocka_unit_test(refusals),
        cmocka_unit_test(no_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
