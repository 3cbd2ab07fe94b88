// SPDX-License-Identifier: GPL-3.0-or-later

/// Pieces of bodies: by hand where a crack parts them, and against labels that are passed from node to node.

#include "particles/particles_impl.h"

#include "particles/bodies.h"

typedef struct {
    int nodes, count;
    int *of_node;
    pdmc_fragment *list;
} pieces;

static pieces find(const pdmc_particles *p)
{
    pieces found = {.nodes = pdmc_particles_count(p)};
    found.of_node = malloc((size_t)found.nodes * sizeof *found.of_node);
    CHECK_OK(pdmc_particles_find_fragments(p, found.of_node, &found.count));
    found.list = malloc((size_t)found.count * sizeof *found.list);
    pdmc_particles_fragments(p, found.of_node, found.count, found.list);
    return found;
}

static void drop(pieces *found)
{
    free(found->of_node);
    free(found->list);
}

/// A crack leaves 12 of 20 columns on its right; beside them is a body of 2 nodes that are twice as heavy.
static void a_crack_parts_a_body(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){20, 6, 1});
    const pdmc_brittle_material materials[2] = {s.material,
                                                {.density = 2.0, .micromodulus = 1.0, .critical_stretch = 1.0}};
    const pdmc_body bodies[2] = {s.body,
                                 {.shape = {.from = {-3.0}, .to = {-2.0}}, .material = 1, .velocity = {0.0, 0.5}}};
    const pdmc_planar_crack crack = {.from = {7.5, -1.0}, .to = {7.5, 6.0}};
    s.options.material_count = s.options.body_count = 2;
    s.options.materials = materials;
    s.options.bodies = bodies;
    s.options.crack_count = 1;
    s.options.cracks = &crack;
    pdmc_particles *p = create(&s);
    pieces found = find(p);
    assert_int_equal(found.count, 3);
    assert_int_equal(found.list[0].nodes, 72);
    assert_int_equal(found.list[1].nodes, 48);
    assert_int_equal(found.list[2].nodes, 2);
    CHECK_NEAR(found.list[0].mass, 72.0, 0.0);
    CHECK_NEAR(found.list[2].mass, 4.0, 0.0);
    CHECK_NEAR(found.list[0].centre[0], 13.5, 1e-13);
    CHECK_NEAR(found.list[0].centre[1], 2.5, 1e-13);
    CHECK_NEAR(found.list[2].velocity[1], 0.5, 1e-14);
    assert_int_equal(found.of_node[0], 2); // of the first row: the other body, the left piece, the right one
    assert_int_equal(found.of_node[2], 1);
    assert_int_equal(found.of_node[21], 0);
    drop(&found);
    pdmc_particles_destroy(p);
}

/// Sends the number of every node to those it has bonds with, in both directions, until nothing changes.
static void pass_labels(const pdmc_particles *p, size_t label[])
{
    const pdmc_nodes *g = &p->nodes;
    for (bool changes = true; changes;) {
        changes = false;
        for (int b = 0; b < g->block_count; b++)
            for (int k = 0; k < g->blocks[b].listed; k++)
                for (int lane = 0; lane < PDMC_LANES; lane++) {
                    const size_t here = g->blocks[b].cell + (size_t)lane;
                    if (!(g->bonds[g->blocks[b].bonds + (size_t)k] >> lane & 1)) continue;
                    size_t *there = &label[pdmc_nodes_neighbour(g, &g->blocks[b], k, lane)];
                    if (label[here] >= *there) continue;
                    *there = label[here];
                    changes = true;
                }
    }
}

/// A sphere through a plate: the pieces are those of the labels, and have the mass and the momentum of the nodes.
static void pieces_of_a_plate_that_was_hit(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 3, (int[]){23, 21, 3});
    s.material.critical_stretch = 0.05;
    const pdmc_rigid_sphere sphere = {
        .radius = 5.0, .centre = {11.0, 10.0, 7.5}, .velocity = {0.0, 0.0, -1.0}, .mass = INFINITY, .stiffness = 0.5};
    s.options.sphere_count = 1;
    s.options.spheres = &sphere;
    pdmc_particles *p = create(&s);
    CHECK_OK(pdmc_particles_advance(p, 60));
    const pdmc_nodes *g = &p->nodes;
    size_t *label = malloc(g->cells * sizeof *label);
    for (size_t c = 0; c < g->cells; c++) label[c] = c;
    pass_labels(p, label);
    pieces found = find(p);
    assert_in_range(found.count, 10, found.nodes / 2); // otherwise the plate shows nothing
    int roots = 0, nodes = 0;
    double mass = 0.0, momentum = 0.0;
    for (int k = 0; k < found.nodes; k++) {
        roots += label[g->cell[k]] == g->cell[k];
        for (int other = 0; other < k; other++)
            if ((label[g->cell[k]] == label[g->cell[other]]) != (found.of_node[k] == found.of_node[other]))
                fail_msg("nodes %d and %d", k, other);
    }
    assert_int_equal(found.count, roots);
    for (int i = 0; i < found.count; i++) {
        nodes += found.list[i].nodes;
        mass += found.list[i].mass;
        momentum += found.list[i].mass * found.list[i].velocity[2];
        if (i > 0) assert_true(found.list[i].mass <= found.list[i - 1].mass);
    }
    assert_int_equal(nodes, found.nodes);
    CHECK_NEAR(mass, found.nodes, 1e-9);
    CHECK_NEAR(momentum, pdmc_particles_sum(p).momentum[2], 1e-12 * found.nodes); // rounding of so many terms near 1
    drop(&found);
    free(label);
    pdmc_particles_destroy(p);
}

static void without_memory(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){4, 3, 1});
    pdmc_particles *p = create(&s);
    int of_node[12], count;
    CHECK_FAILS_CLEANLY(pdmc_particles_find_fragments(p, of_node, &count), (void)0);
    assert_int_equal(count, 1);
    pdmc_particles_destroy(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_crack_parts_a_body),
        cmocka_unit_test(pieces_of_a_plate_that_was_hit),
        cmocka_unit_test(without_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
