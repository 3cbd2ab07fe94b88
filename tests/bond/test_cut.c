// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/grid.h"

#include "bond/cut_exactly.h"
#include "check.h"

static const double unit = 0.1; // of the lattice; not a binary fraction, so that points are on lines but for rounding

static uint64_t sequence = 7;

static lattice_point draw_point(void)
{
    enum { HALF = 8 };
    sequence = sequence * 6364136223846793005u + 1442695040888963407u;
    const int64_t r = (int64_t)(sequence >> 33);
    return (lattice_point){r % (2 * HALF + 1) - HALF, r / (2 * HALF + 1) % (2 * HALF + 1) - HALF};
}

static void to_plane(lattice_point p, double x[2])
{
    x[0] = (double)p.x * unit;
    x[1] = (double)p.y * unit;
}

static pdmc_crack crack_between(lattice_point from, lattice_point to)
{
    pdmc_crack crack = {0};
    to_plane(from, crack.from);
    to_plane(to, crack.to);
    return crack;
}

static bool is_cut(lattice_point from, lattice_point to, lattice_point p, lattice_point q)
{
    const pdmc_crack crack = crack_between(from, to);
    double a[2], b[2];
    to_plane(p, a);
    to_plane(q, b);
    const bool there = pdmc_bond_is_cut(&crack, unit, a, b), back = pdmc_bond_is_cut(&crack, unit, b, a);
    assert_true(there == back);
    return there;
}

// Among them bonds through tips, to tips, to points on the crack and along it: counted, so that they are there.
static void whole_numbers_agree(void **state)
{
    (void)state;
    int cut = 0, on_line = 0, through_tip = 0, along = 0;
    for (int k = 0; k < 1000000; k++) {
        const lattice_point from = draw_point(), to = draw_point(), a = draw_point(), b = draw_point();
        if (from.x == to.x && from.y == to.y) continue;
        const bool want = cut_exactly(from, to, a, b), is_on = lattice_left(from, to, a) == 0;
        if (is_cut(from, to, a, b) != want)
            fail_msg("crack (%d, %d) (%d, %d), bond (%d, %d) (%d, %d): want %d", (int)from.x, (int)from.y, (int)to.x,
                     (int)to.y, (int)a.x, (int)a.y, (int)b.x, (int)b.y, want);
        cut += want;
        on_line += is_on;
        along += is_on && lattice_left(from, to, b) == 0;
        through_tip += want && (lattice_left(a, b, from) == 0 || lattice_left(a, b, to) == 0);
    }
    printf("  %d cut, %d from the line, %d along it, %d through a tip\n", cut, on_line, along, through_tip);
    assert_true(cut > 100000 && on_line > 10000 && along > 300 && through_tip > 3000);
}

// A crack (0, 0) -> (4, 0): its left is above.
static void the_line_belongs_to_the_left_face(void **state)
{
    (void)state;
    const lattice_point from = {0, 0}, to = {4, 0};
    const struct {
        lattice_point a, b;
        bool want;
    } cases[] = {
        {{2, 1}, {2, -1}, true},   {{2, 0}, {2, -1}, true},  {{2, 0}, {2, 1}, false},  {{1, 0}, {3, 0}, false},
        {{-1, 0}, {2, 0}, false},  {{0, 1}, {0, -1}, true},  {{4, 0}, {4, -1}, true},  {{4, 0}, {5, 1}, false},
        {{-1, 1}, {1, -1}, true},  {{5, 1}, {3, -1}, true},  {{5, 1}, {5, -1}, false}, {{-1, 0}, {-1, -1}, false},
        {{-1, 2}, {0, -1}, false}, {{-3, 1}, {3, -1}, true},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        assert_true(is_cut(from, to, cases[k].a, cases[k].b) == cases[k].want);
        assert_true(cut_exactly(from, to, cases[k].a, cases[k].b) == cases[k].want);
    }
}

// Within 1e-9 of the spacing a point is on the line, and a bond through a tip meets it; at 1e-8 no longer.
static void points_are_on_the_line_within_a_slack(void **state)
{
    (void)state;
    const pdmc_crack crack = {.from = {0.0, 0.0}, .to = {4.0, 0.0}};
    const double below[2] = {2.0, -1.0}, above[2] = {2.0, 1.0};
    for (int sign = -1; sign <= 1; sign += 2) {
        const double near[2] = {2.0, sign * 0.9e-9}, far[2] = {2.0, sign * 1e-8};
        assert_true(pdmc_bond_is_cut(&crack, 1.0, near, below));
        assert_false(pdmc_bond_is_cut(&crack, 1.0, near, above));
        assert_true(pdmc_bond_is_cut(&crack, 1.0, far, sign > 0 ? below : above));
        assert_false(pdmc_bond_is_cut(&crack, 1.0, far, sign > 0 ? above : below));
    }
    const double over[2] = {4.0 + 0.9e-9, 1.0}, under[2] = {4.0 + 0.9e-9, -1.0};
    const double past_over[2] = {4.0 + 1e-8, 1.0}, past_under[2] = {4.0 + 1e-8, -1.0};
    assert_true(pdmc_bond_is_cut(&crack, 1.0, over, under));
    assert_false(pdmc_bond_is_cut(&crack, 1.0, past_over, past_under));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_numbers_agree),
        cmocka_unit_test(the_line_belongs_to_the_left_face),
        cmocka_unit_test(points_are_on_the_line_within_a_slack),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
