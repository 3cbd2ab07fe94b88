// SPDX-License-Identifier: GPL-3.0-or-later

/// Loads along sides, and values anywhere in a mesh: against closed forms.

#include "galerkin/wave.h"

// Sums of load times a linear function, which is the integral of force times that function.
static double moment(const pdmc_space *space, const double load[], double a, double b, double c)
{
    double sum = 0.0;
    const int d = space->mesh->dimension;
    for (int i = 0; i < space->free_count; i++)
        sum += load[i] * (a + b * space->x[d * i] + (d == 2 ? c * space->x[d * i + 1] : 0.0));
    return sum;
}

// All values of a box that is open all round are free; of one element size and depths from a part of it to several.
static void layers_have_the_force_and_the_place_that_they_should(void **state)
{
    (void)state;
    const bool open[4] = {false, false, false, false};
    const double size[2] = {1.0, 0.5};
    const int cells[2] = {7, 3};
    for (int dimension = 1; dimension <= 2; dimension++)
        for (double depth = 0.03; depth < 0.4; depth *= 1.7) {
            pdmc_mesh mesh;
            pdmc_space space;
            CHECK_OK(pdmc_mesh_open_box(dimension, size, cells, 0.1, open, &mesh));
            CHECK_OK(pdmc_space_create(&mesh, PDMC_SPACE_DISCONTINUOUS, &space));
            assert_int_equal(space.free_count, space.count);
            double *load = pdmc_calloc((size_t)space.count, sizeof *load);
            const double width = dimension == 2 ? 0.5 : 1.0, force = 3.0 * depth * width;
            pdmc_space_add_layer(&space, 0, 0.5 - depth, 0.5, 3.0, load);
            CHECK_NEAR(moment(&space, load, 1.0, 0.0, 0.0), force, 1e-14);
            CHECK_NEAR(moment(&space, load, 0.0, 1.0, 0.0), force * (0.5 - 0.5 * depth), 1e-14);
            CHECK_NEAR(moment(&space, load, 0.0, 0.0, 1.0), 0.0, 1e-14);
            for (int i = 0; i < space.count; i++) load[i] = 0.0;
            pdmc_space_add_flux(&space, 0, -0.5, 2.0, load);
            CHECK_NEAR(moment(&space, load, 1.0, 1.0, 4.0), 2.0 * width * 0.5, 1e-14);
            pdmc_free(load);
            pdmc_space_clear(&space);
            pdmc_mesh_clear(&mesh);
        }
}

static void other_sides_are_loaded_as_well(void **state)
{
    (void)state;
    const bool has_layer[4] = {true, true, true, false};
    const int cells[2] = {4, 3};
    pdmc_mesh mesh;
    pdmc_space space;
    CHECK_OK(pdmc_mesh_open_box(2, (double[2]){1.0, 0.5}, cells, 0.1, has_layer, &mesh));
    CHECK_OK(pdmc_space_create(&mesh, PDMC_SPACE_DISCONTINUOUS, &space));
    double *load = pdmc_calloc((size_t)space.count, sizeof *load);
    pdmc_space_add_layer(&space, 1, 0.21, 0.25, 5.0, load); // of the body alone
    CHECK_NEAR(moment(&space, load, 1.0, 0.0, 0.0), 5.0 * 0.04, 1e-14);
    pdmc_space_add_flux(&space, 1, 0.25, 1.0, load);
    CHECK_NEAR(moment(&space, load, 0.0, 0.0, 1.0), 0.2 * 0.23 + 0.25, 1e-14);
    pdmc_free(load);
    pdmc_space_clear(&space);
    pdmc_mesh_clear(&mesh);
}

static double tilted(const double x[], int dimension)
{
    return 1.5 - 2.0 * x[0] + (dimension == 2 ? 0.5 * x[1] : 0.0);
}

static void linear_functions_are_found_everywhere(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++) {
        const steady s = {dimension, 9, 0.2, 1.0, PDMC_SPACE_MIXED, {0}};
        setting at;
        pdmc_locator *locator;
        setting_create(&s, &at);
        CHECK_OK(pdmc_locator_create(&at.mesh, &locator));
        double *u = pdmc_calloc((size_t)at.space.count, sizeof *u);
        for (int i = 0; i < at.space.count; i++) u[i] = tilted(&at.space.x[dimension * i], dimension);
        for (int i = 0; i < at.mesh.node_count; i++) { // nodes too, which several elements have
            const double *x = &at.mesh.x[dimension * i];
            CHECK_NEAR(pdmc_locator_value(locator, &at.space, u, x), tilted(x, dimension), 1e-13);
        }
        for (int i = 0; i < 200; i++) {
            const double x[2] = {0.69 * sin(37.0 * i), 0.69 * cos(91.0 * i)};
            CHECK_NEAR(pdmc_locator_value(locator, &at.space, u, x), tilted(x, dimension), 1e-13);
        }
        assert_true(isnan(pdmc_locator_value(locator, &at.space, u, (double[2]){0.71, 0.0})));
        pdmc_free(u);
        pdmc_locator_destroy(&locator);
        CHECK_FAILS_CLEANLY(pdmc_locator_create(&at.mesh, &locator), pdmc_locator_destroy(&locator));
        setting_clear(&at);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_have_the_force_and_the_place_that_they_should),
        cmocka_unit_test(other_sides_are_loaded_as_well),
        cmocka_unit_test(linear_functions_are_found_everywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
