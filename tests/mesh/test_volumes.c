// SPDX-License-Identifier: GPL-3.0-or-later
#include "cube.h"

#include <gsl/gsl_math.h>
#include <string.h>

static const double rounding = 1e-12; // of sums of some thousand parts

static double sum_of(int count, const double x[])
{
    double sum = 0.0;
    for (int i = 0; i < count; i++) sum += x[i];
    return sum;
}

static void cells_of_a_grid_are_halved_by_its_surface(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    cube_create(3, &mesh);
    double *volume = pdmc_calloc((size_t)mesh.node_count, sizeof *volume);
    CHECK_OK(pdmc_mesh_node_volumes(&mesh, PDMC_SHARE_VORONOI, volume));
    for (int i = 0; i < mesh.node_count; i++) {
        double want = 1.0;
        for (int a = 0; a < 3; a++) want *= mesh.x[3 * i + a] == 0.0 || mesh.x[3 * i + a] == 3.0 ? 0.5 : 1.0;
        CHECK_NEAR(volume[i], want, rounding);
    }
    pdmc_free(volume);
    pdmc_mesh_clear(&mesh);
}

// Corners of elements: those of the diagonal have all six of a cell.
static void elements_are_shared_by_their_corners(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    double volume[8];
    cube_create(1, &mesh);
    CHECK_OK(pdmc_mesh_node_volumes(&mesh, PDMC_SHARE_ELEMENTS, volume));
    for (int i = 0; i < 8; i++) CHECK_NEAR(volume[i], i == 0 || i == 7 ? 0.25 : 1.0 / 12.0, 1e-15);
    pdmc_mesh_clear(&mesh);
}

static int nearest(const pdmc_mesh *mesh, const double x[])
{
    int best = 0;
    double least = INFINITY;
    for (int i = 0; i < mesh->node_count; i++) {
        const double distance = pdmc_mesh_distance(mesh->dimension, x, &mesh->x[mesh->dimension * i]);
        if (distance < least) least = distance, best = i;
    }
    return best;
}

// Counts the points of a lattice that are nearest to each node. A cell of the lattice can only be counted wrongly where the
// surface of a Voronoi cell runs through it: those within half a diagonal of it, on either side.
static void check_by_counting(pdmc_mesh *mesh, const double low[], const double high[], int points, double surface)
{
    const int d = mesh->dimension;
    double cell = 1.0, diagonal = 0.0, total = 1.0, x[PDMC_MESH_AXES];
    double *volume = pdmc_calloc((size_t)mesh->node_count, sizeof *volume);
    double *counted = pdmc_calloc((size_t)mesh->node_count, sizeof *counted);
    int lattice = 1;
    for (int a = 0; a < d; a++) {
        const double step = (high[a] - low[a]) / points;
        cell *= step, diagonal += step * step, total *= high[a] - low[a], lattice *= points;
    }
    CHECK_OK(pdmc_mesh_node_volumes(mesh, PDMC_SHARE_VORONOI, volume));
    CHECK_NEAR(sum_of(mesh->node_count, volume), total, rounding * total);
    for (int i = 0; i < lattice; i++) {
        for (int a = 0, rest = i; a < d; a++, rest /= points)
            x[a] = low[a] + (rest % points + 0.5) * (high[a] - low[a]) / points;
        counted[nearest(mesh, x)] += cell;
    }
    for (int i = 0; i < mesh->node_count; i++) {
        // errors of both signs: they were 0.06 of the bound at most
        CHECK_NEAR(volume[i], counted[i], 0.1 * sqrt(diagonal) * surface);
    }
    pdmc_free(volume);
    pdmc_free(counted);
}

static void voronoi_cells_are_those_that_counting_finds(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    const double low[3] = {-0.7, -0.7, 0.0}, high[3] = {0.7, 0.7, 0.0}, zero[3] = {0.0, 0.0, 0.0},
                 three[3] = {3.0, 3.0, 3.0};
    CHECK_OK(pdmc_mesh_box(2, (double[]){1.0, 1.0}, (int[]){5, 5}, 0.2, &mesh));
    shake(&mesh, 0.09, low, high);
    check_by_counting(&mesh, low, high, 500, 4.0 * 0.36); // no cell is wider than 0.36
    pdmc_mesh_clear(&mesh);
    cube_create(3, &mesh);
    shake(&mesh, 0.3, zero, three);
    check_by_counting(&mesh, zero, three, 60, 6.0 * 1.6 * 1.6);
    pdmc_mesh_clear(&mesh);
}

// A hole: what is beyond it is another side of the body, but space is cut as if it were none.
static void shares_of_a_plate_with_a_hole_add_up(void **state)
{
    (void)state;
    const pdmc_hole hole = {{0.1, 0.0}, 0.2};
    const pdmc_mesh_plate plate = {
        .width = 1.0, .height = 1.0, .spacing = 0.1, .fine_spacing = 0.02, .hole_count = 1, .holes = &hole};
    pdmc_mesh mesh;
    CHECK_OK(pdmc_mesh_triangles(&plate, &mesh));
    double area = 0.0, *volume = pdmc_calloc((size_t)mesh.node_count, sizeof *volume);
    for (int e = 0; e < mesh.element_count; e++) area += pdmc_mesh_extent(&mesh, e);
    for (int share = PDMC_SHARE_ELEMENTS; share <= PDMC_SHARE_VORONOI; share++) {
        CHECK_OK(pdmc_mesh_node_volumes(&mesh, (pdmc_share)share, volume));
        CHECK_NEAR(sum_of(mesh.node_count, volume), area, rounding);
        for (int i = 0; i < mesh.node_count; i++) assert_true(volume[i] > 0.0);
    }
    pdmc_free(volume);
    pdmc_mesh_clear(&mesh);
}

static void what_cannot_be_shared_is_refused(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    double volume[8];
    CHECK_OK(pdmc_mesh_box(1, (double[]){1.0}, (int[]){2}, 0.5, &mesh));
    CHECK_STATUS(pdmc_mesh_node_volumes(&mesh, PDMC_SHARE_ELEMENTS, volume), PDMC_ERR_ARG);
    pdmc_mesh_clear(&mesh);
    cube_create(1, &mesh);
    CHECK_FAILS_CLEANLY(pdmc_mesh_node_volumes(&mesh, PDMC_SHARE_VORONOI, volume), );
    pdmc_mesh_clear(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_of_a_grid_are_halved_by_its_surface),
        cmocka_unit_test(elements_are_shared_by_their_corners),
        cmocka_unit_test(voronoi_cells_are_those_that_counting_finds),
        cmocka_unit_test(shares_of_a_plate_with_a_hole_add_up),
        cmocka_unit_test(what_cannot_be_shared_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
