// SPDX-License-Identifier: GPL-3.0-or-later

/// Scalar studies on triangles of all shapes: they converge as equal cells do, and say what made them.

#include "run/studies.h"

#include "pdmc/results.h"

#define PROBLEM "kind = \"scalar\"; kernel = { horizon = 0.3; }; wave = { length = 1.25; angle = 53; phase = 40; };\n"
#define SQUARE "domain = { dimension = 2; width = 1; height = 1; };\n"
#define HOLE "holes = ( { centre = [0.1, 0.05]; radius = 0.2; } );\n"

static void run_scalar(const char *text, int threads, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = threads};
    pdmc_study study;
    CHECK_OK(read_text(text, &study));
    CHECK_OK(pdmc_run(&study, &options, results));
    pdmc_study_clear(&study);
}

static double rate(const double values[], int level)
{
    return log2(values[level - 1] / values[level]);
}

// Second order, as cells have it. The first level has few values, so that its rate is a little off.
static void triangles_converge_with_the_second_order(void **state)
{
    (void)state;
    static const char *const settings[] = {
        PROBLEM SQUARE HOLE "elements = { mesh = \"triangles\"; spacing = 0.25; hole_spacing = 0.2; };\n"
                            "convergence = { levels = 2; };",
        PROBLEM SQUARE HOLE "elements = { mesh = \"triangles\"; spacing = 0.3; space = \"discontinuous\"; };\n"
                            "convergence = { levels = 2; };"};
    for (int i = 0; i < 2; i++) {
        pdmc_results r;
        run_scalar(settings[i], 2, &r);
        const pdmc_scalar_record *s = &r.scalar;
        const int last = s->level_count - 1;
        CHECK_NEAR(rate(s->error, last), 2.0, 0.2);
        CHECK_NEAR(s->spacing[last], ldexp(s->spacing[0], -last), 1e-12);
        CHECK_NEAR(s->elements[last], ldexp(s->elements[0], 2 * last), 0.0);
        assert_memory_equal(r.mesh_generator, "Gmsh ", 5);
        pdmc_results_clear(&r);
    }
}

static void threads_change_no_bit_and_the_file_keeps_the_generator(void **state)
{
    (void)state;
    static const char text[] = PROBLEM SQUARE HOLE "elements = { mesh = \"triangles\"; spacing = 0.3; };\n"
                                                   "convergence = { vary = \"horizon\"; levels = 2; };";
    pdmc_results a, b;
    run_scalar(text, 1, &a);
    run_scalar(text, 3, &b);
    assert_int_equal(a.scalar.value_count, b.scalar.value_count);
    assert_memory_equal(a.scalar.value, b.scalar.value, (size_t)a.scalar.value_count * sizeof(double));
    CHECK_NEAR(a.scalar.spacing[1], a.scalar.spacing[0], 0.0); // the horizon varies on one mesh
    CHECK_NEAR(a.scalar.horizon[1], 0.15, 1e-15);
    pdmc_results_clear(&b);
    CHECK_OK(pdmc_results_write(&a, "a.h5", true));
    CHECK_OK(pdmc_results_read("a.h5", &b));
    assert_string_equal(a.mesh_generator, b.mesh_generator);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_converge_with_the_second_order),
        cmocka_unit_test(threads_change_no_bit_and_the_file_keeps_the_generator),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
