// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/bond_plate.h"

#include "bond/cut_exactly.h"

#include <stdlib.h>

// In half spacings from the plate's middle, where a node is at odd numbers if there is an even number of cells.
static lattice_point lattice(const double x[2])
{
    return (lattice_point){llround(x[0] / 0.05), llround(x[1] / 0.05)};
}

static bool is_cut_exactly(const bond_plate *p, const double a[2], const double b[2])
{
    for (int c = 0; c < p->problem.crack_count; c++)
        if (cut_exactly(lattice(p->cracks[c].from), lattice(p->cracks[c].to), lattice(a), lattice(b))) return true;
    return false;
}

// Every pair of nodes looked at.
static void compare_with_all_pairs(const bond_plate *p)
{
    const pdmc_bond_plate *made = &p->made;
    const pdmc_bond_families *families = &made->families;
    const int columns = made->grid.columns, nodes = made->grid.nodes;
    size_t at = 0, directed_cuts = 0;
    for (int node = 0; node < nodes; node++) {
        assert_true(families->start[node] == at);
        for (int other = 0; other < nodes; other++) { // ascending as the neighbours are, by row, then column
            double a[2], b[2];
            int k = 0;
            while (k < made->horizon.count && !(made->horizon.neighbour[k].column == other % columns - node % columns &&
                                                made->horizon.neighbour[k].row == other / columns - node / columns))
                k++;
            if (k == made->horizon.count) continue;
            pdmc_bond_grid_node(&made->grid, node, a);
            pdmc_bond_grid_node(&made->grid, other, b);
            if (is_cut_exactly(p, a, b)) {
                directed_cuts++;
                continue;
            }
            assert_true(at < families->start[nodes]);
            assert_true(families->partner[at] == other && families->neighbour[at] == k);
            at++;
        }
    }
    assert_true(families->start[nodes] == at);
    assert_true(families->cut == directed_cuts / 2 && directed_cuts % 2 == 0);
}

static double draw_half_spacings(int most)
{
    static uint64_t sequence = 3;
    sequence = sequence * 6364136223846793005u + 1442695040888963407u;
    return ((int)((sequence >> 33) % (uint64_t)(2 * most + 1)) - most) * 0.05;
}

// Cracks between points of the half lattice: between rows of nodes, through nodes, tips at nodes and between.
static void all_pairs_agree(void **state)
{
    (void)state;
    size_t cut = 0;
    for (int k = 0; k < 60; k++) {
        bond_plate p;
        bond_plate_describe(&p, 14, 10, k % 2 ? 3.0 : 2.5);
        p.problem.solver.area = (pdmc_bond_area)(k % 4);
        for (int c = 0; c <= k % 3; c++) {
            const double x0 = draw_half_spacings(13), y0 = draw_half_spacings(9);
            const double x1 = draw_half_spacings(13), y1 = draw_half_spacings(9);
            if (x0 != x1 || y0 != y1) bond_plate_crack(&p, x0, y0, x1, y1);
        }
        if (k % 5 == 0) bond_plate_hold(&p, PDMC_SIDE_TOP, 1, 0.1);
        bond_plate_make(&p, 1);
        compare_with_all_pairs(&p);
        cut += p.made.families.cut;
        bond_plate_clear(&p);
    }
    assert_true(cut > 3000);
}

// Left holds u, bottom v, the top u and v; nothing on the right.
static void layers_hold_what_their_side_does(void **state)
{
    (void)state;
    bond_plate p;
    bond_plate_describe(&p, 8, 6, 2.0);
    bond_plate_hold(&p, PDMC_SIDE_LEFT, 0, 0.5);
    bond_plate_hold(&p, PDMC_SIDE_BOTTOM, 1, -0.25);
    bond_plate_hold(&p, PDMC_SIDE_TOP, 0, 0.7);
    bond_plate_hold(&p, PDMC_SIDE_TOP, 1, 2.0);
    bond_plate_make(&p, 1);
    const pdmc_bond_grid *g = &p.made.grid;
    assert_int_equal(g->columns, 8 + 2);
    assert_int_equal(g->rows, 6 + 2 + 2);
    for (int node = 0; node < g->nodes; node++) {
        double x[2], u = 0.0, v = 0.0;
        pdmc_bond_grid_node(g, node, x);
        const bool left = x[0] < -0.4, bottom = x[1]<-0.3, top = x[1]> 0.3;
        if (left && top) u = 0.6;
        else if (left) u = 0.5;
        else if (top) u = 0.7;
        if (bottom) v = -0.25;
        if (top) v = 2.0;
        assert_int_equal(g->held[node], (left || top ? 1 : 0) + (bottom || top ? 2 : 0));
        const double *prescribed = &g->prescribed[2 * (size_t)node];
        CHECK_NEAR(prescribed[0], u, 1e-15);
        CHECK_NEAR(prescribed[1], v, 0.0);
    }
    double first[2], last[2];
    pdmc_bond_grid_node(g, 0, first);
    pdmc_bond_grid_node(g, g->nodes - 1, last);
    CHECK_NEAR(first[0], -0.55, 1e-15);
    CHECK_NEAR(first[1], -0.45, 1e-15);
    CHECK_NEAR(last[0], 0.35, 1e-15);
    CHECK_NEAR(last[1], 0.45, 1e-15);
    bond_plate_clear(&p);
}

// At the middle of a straight side at depth d < delta the scale is 1 / (1 - missing part), in the continuum
// (1/3) / (1/3 - missing), missing = 1 / (2 pi delta^3) 2 int_d^delta acos(d / r) r^2 dr.
static double continuum_scale(double depth, double horizon)
{
    enum { STEPS = 20000 };
    double missing = 0.0;
    for (int i = 0; i < STEPS; i++) {
        const double r = depth + (horizon - depth) * (i + 0.5) / STEPS;
        missing += 2.0 * acos(depth / r) * r * r * (horizon - depth) / STEPS;
    }
    const double whole = 2.0 * 3.14159265358979 * horizon * horizon * horizon / 3.0;
    return whole / (whole - missing);
}

static void nodes_near_a_side_are_corrected(void **state)
{
    (void)state;
    bond_plate p;
    bond_plate_describe(&p, 61, 61, 10.0);
    p.problem.solver.surface_correction = PDMC_ON;
    bond_plate_crack(&p, -1.0, 0.0, 1.0, 0.01); // cut bonds do not count
    bond_plate_make(&p, 1);
    const double *scale = p.made.families.scale;
    for (int depth = 0; depth <= 30; depth++) { // cells below the node in the middle column
        const double got = scale[depth * 61 + 30], edge = (depth + 0.5) * 0.1;
        if (depth % 3 == 0 && depth < 12)
            printf("  depth %.2f delta: scale %.4f, continuum %.4f\n", edge, got, continuum_scale(edge, 1.0));
        if (depth >= 11) CHECK_NEAR(got, 1.0, 0.0);
        else CHECK_NEAR(got, edge < 1.0 ? continuum_scale(edge, 1.0) : 1.0, 0.01); // of second order in 1/10
        CHECK_NEAR(scale[30 * 61 + depth], got, 1e-13);                            // the other sides
        CHECK_NEAR(scale[30 * 61 + 60 - depth], got, 1e-13);
        CHECK_NEAR(scale[(60 - depth) * 61 + 30], got, 1e-13);
    }
    bond_plate_clear(&p);
    bond_plate_describe(&p, 9, 9, 3.0);
    bond_plate_make(&p, 1);
    for (int node = 0; node < 81; node++) CHECK_NEAR(p.made.families.scale[node], 1.0, 0.0); // not asked for
    bond_plate_clear(&p);
}

static void a_million_nodes_are_quick(void **state)
{
    (void)state;
    bond_plate p;
    bond_plate_describe(&p, 1000, 1000, 3.0);
    p.problem.solver.area = PDMC_AREA_FULL;
    bond_plate_crack(&p, -20.0, 0.0, 20.0, 0.0);
    const double start = pdmc_seconds();
    bond_plate_make(&p, 1);
    printf("  %zu directed bonds in %.2f s, %zu cut\n", p.made.families.start[1000000], pdmc_seconds() - start,
           p.made.families.cut);
    size_t want = 0, cut = 0;
    for (int k = 0; k < p.made.horizon.count; k++) {
        const pdmc_bond_neighbour *n = &p.made.horizon.neighbour[k];
        want += (size_t)(1000 - abs(n->column)) * (size_t)(1000 - abs(n->row));
        for (int i = 0; i < 3 * 1000; i++) { // upwards from the three rows below the crack
            const lattice_point a = {2 * (i % 1000) - 999, -2 * (i / 1000) - 1};
            const lattice_point b = {a.x + INT64_C(2) * n->column, a.y + INT64_C(2) * n->row};
            cut += n->row > 0 && cut_exactly((lattice_point){-400, 0}, (lattice_point){400, 0}, a, b);
        }
    }
    assert_true(p.made.families.cut == cut);
    assert_true(p.made.families.start[1000000] == want - 2 * cut);
    bond_plate_clear(&p);
}

static void failures_are_clean(void **state)
{
    (void)state;
    bond_plate p;
    bond_plate_describe(&p, 6, 6, 2.0);
    bond_plate_crack(&p, -0.2, 0.0, 0.2, 0.0);
    bond_plate_make(&p, 1);
    pdmc_bond_grid grid;
    pdmc_bond_families families;
    CHECK_FAILS_CLEANLY(pdmc_bond_grid_create(&p.problem, &grid), pdmc_bond_grid_clear(&grid));
    CHECK_FAILS_CLEANLY(pdmc_bond_families_create(&p.problem, &p.made.grid, &p.made.horizon, &families),
                        pdmc_bond_families_clear(&families));
    bond_plate_clear(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_pairs_agree),
        cmocka_unit_test(layers_hold_what_their_side_does),
        cmocka_unit_test(nodes_near_a_side_are_corrected),
        cmocka_unit_test(a_million_nodes_are_quick),
        cmocka_unit_test(failures_are_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
