// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/dissection.h"

#include "bond/bond_plate.h"

#include <stdlib.h>

static void every_unknown_has_its_place(void **state)
{
    (void)state;
    const int sizes[][2] = {{1, 1}, {7, 7}, {31, 20}, {20, 45}};
    for (int k = 0; k < 4; k++) {
        bond_plate p;
        bond_plate_describe(&p, sizes[k][0], sizes[k][1], 3.0);
        bond_plate_make(&p, 1);
        const int unknowns = 2 * sizes[k][0] * sizes[k][1];
        int64_t *order = calloc((size_t)unknowns, sizeof *order);
        bool *seen = calloc((size_t)unknowns, sizeof *seen);
        pdmc_bond_dissection(&p.made, order);
        for (int i = 0; i < unknowns; i++) {
            assert_in_range(order[i], 0, unknowns - 1);
            assert_false(seen[order[i]]);
            seen[order[i]] = true;
        }
        free(seen);
        free(order);
        bond_plate_clear(&p);
    }
}

/// The last nodes are a strip, and no bond connects the two parts before it.
static void the_strip_separates(void **state)
{
    (void)state;
    enum { COLUMNS = 41, ROWS = 20, NODES = COLUMNS * ROWS, REACH = 4 };
    bond_plate p;
    bond_plate_describe(&p, COLUMNS, ROWS, 3.6); // exact areas: cells whose nodes are outside count in part
    bond_plate_make(&p, 1);
    int64_t order[2 * NODES];
    int part[NODES];
    pdmc_bond_dissection(&p.made, order);
    const int before = (COLUMNS - REACH) / 2 * ROWS, strip = NODES - REACH * ROWS;
    for (int i = 0; i < NODES; i++) part[order[2 * i] / 2] = i < before ? 0 : i < strip ? 1 : 2;
    int crossing = 0;
    for (int i = 0; i < NODES; i++) {
        for (size_t b = p.made.families.start[i]; b < p.made.families.start[i + 1]; b++) {
            const int j = p.made.families.partner[b];
            assert_true(part[i] == part[j] || part[i] == 2 || part[j] == 2);
            crossing += part[i] != part[j];
        }
    }
    assert_true(crossing > 0);
    bond_plate_clear(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_unknown_has_its_place),
        cmocka_unit_test(the_strip_separates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
