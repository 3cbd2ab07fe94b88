// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/cracked.h"
#include "visible/nodes.h"

static void make_plate(plate *p, pdmc_cuts *cuts)
{
    cracked_make(p, 5.0, 0.3, 4);
    plate_crack(p, -0.6, 0.1, 0.5, 0.4);
    plate_crack(p, 1.1, 0.3, 0.3, -1.2);
    CHECK_OK(pdmc_cuts_create(&p->problem, cuts));
}

static double nearest_other(const pdmc_visible_nodes *nodes, int i)
{
    const pdmc_visible_node *node = &nodes->node[i];
    double least = INFINITY;
    for (int k = 0; k < nodes->count; k++) {
        const pdmc_visible_node *other = &nodes->node[k];
        const bool is_twin = node->view.crack >= 0 && other->view.crack == node->view.crack; // the other face, too
        if (k != i && !(is_twin && other->view.side != node->view.side))
            least = fmin(least, hypot(other->view.x[0] - node->view.x[0], other->view.x[1] - node->view.x[1]));
    }
    return least;
}

// Nodes keep their distance from one another and from cracks, lie inside but for the ghosts, and come in pairs on
// faces.
static void nodes_keep_their_distance(void **state)
{
    (void)state;
    plate p;
    pdmc_cuts cuts;
    pdmc_visible_nodes nodes;
    int sides[2] = {0, 0}, ghosts = 0, on_edge = 0;
    make_plate(&p, &cuts);
    CHECK_OK(pdmc_visible_nodes_create(&p.problem, &cuts, true, true, &nodes));
    assert_int_equal(nodes.count, nodes.grid.count);
    for (int i = 0; i < nodes.count; i++) {
        const pdmc_visible_node *node = &nodes.node[i];
        const bool is_inside = fabs(node->view.x[0]) <= 2.5 && fabs(node->view.x[1]) <= 2.5;
        assert_true(is_inside == (node->edge < 0));
        assert_true(nearest_other(&nodes, i) > 0.5 * node->spacing);
        if (node->view.crack < 0) assert_true(pdmc_cuts_distance(&cuts, node->view.x) > 0.4 * node->spacing);
        else sides[node->view.side > 0]++;
        ghosts += node->ring == 1;
        on_edge += node->edge < 0 && (fabs(node->view.x[0]) == 2.5 || fabs(node->view.x[1]) == 2.5);
    }
    assert_true(sides[0] == sides[1] && sides[0] >= 20);
    assert_true(ghosts == on_edge && ghosts >= 80); // 20 a side, more where a crack is near
    pdmc_visible_nodes_clear(&nodes);
    pdmc_cuts_clear(&cuts);
}

// Every point of the plate has a node within reach; corners have none, so that it is not quite one spacing.
static void nodes_leave_no_holes(void **state)
{
    (void)state;
    plate p;
    pdmc_cuts cuts;
    pdmc_visible_nodes nodes;
    double worst = 0.0;
    make_plate(&p, &cuts);
    CHECK_OK(pdmc_visible_nodes_create(&p.problem, &cuts, true, false, &nodes));
    for (int k = 0; k < 100 * 100; k++) {
        const double x[2] = {(k % 100 - 49.5) * 0.05, (k / 100 - 49.5) * 0.05};
        int found;
        double distance;
        assert_int_equal(pdmc_grid_nearest(&nodes.grid, x, 1, NULL, NULL, &found, &distance), 1);
        worst = fmax(worst, sqrt(distance) / nodes.node[found].spacing);
    }
    printf("  largest hole: %.2f spacings from its nearest node\n", worst);
    assert_true(worst < 1.2);
    pdmc_visible_nodes_clear(&nodes);
    pdmc_cuts_clear(&cuts);
}

static bool is_even(const void *context, int point)
{
    (void)context;
    return point % 2 == 0;
}

// Against a search of all points, from inside and outside the region.
static void the_grid_finds_the_nearest(void **state)
{
    (void)state;
    enum { POINTS = 300, WANTED = 7 };
    const double half[2] = {1.0, 0.5};
    pdmc_grid grid;
    CHECK_OK(pdmc_grid_create(half, 0.11, POINTS, &grid));
    for (int i = 0; i < POINTS; i++) {
        const double x[2] = {2.2 * fmod(0.7548776662 * i, 1.0) - 1.1, 1.1 * fmod(0.5698402910 * i, 1.0) - 0.55};
        pdmc_grid_add(&grid, x);
    }
    const double from[4][2] = {{0.0, 0.0}, {0.93, -0.2}, {1.6, 0.9}, {-0.4, 0.49}};
    for (int q = 0; q < 4; q++) {
        int found[WANTED];
        double distance[WANTED];
        assert_int_equal(pdmc_grid_nearest(&grid, from[q], WANTED, is_even, NULL, found, distance), WANTED);
        int nearer = 0;
        for (int i = 0; i < POINTS; i += 2) {
            const double dx = grid.x[2 * i] - from[q][0], dy = grid.x[2 * i + 1] - from[q][1];
            nearer += dx * dx + dy * dy < distance[WANTED - 1];
        }
        assert_int_equal(nearer, WANTED - 1);
        for (int k = 0; k < WANTED; k++) assert_true(found[k] % 2 == 0 && (k == 0 || distance[k] >= distance[k - 1]));
    }
    pdmc_grid_clear(&grid);
}

static void every_refused_allocation_is_reported(void **state)
{
    (void)state;
    plate p;
    pdmc_cuts cuts;
    pdmc_visible_nodes nodes;
    make_plate(&p, &cuts);
    p.problem.solver.spacing = 1.0;
    p.problem.solver.refinement = 2;
    CHECK_FAILS_CLEANLY(pdmc_visible_nodes_create(&p.problem, &cuts, true, true, &nodes),
                        pdmc_visible_nodes_clear(&nodes));
    pdmc_cuts_clear(&cuts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_keep_their_distance),
        cmocka_unit_test(nodes_leave_no_holes),
        cmocka_unit_test(the_grid_finds_the_nearest),
        cmocka_unit_test(every_refused_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
