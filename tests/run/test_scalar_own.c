// SPDX-License-Identifier: GPL-3.0-or-later

/// Scalar studies under a source of their own, with open sides and bonds with a law: against solutions in closed form, and
/// against each other.

#include "run/studies.h"

#include "pdmc/results.h"

#include <gsl/gsl_math.h>

static const pdmc_run_options options = {.threads = 2};

static pdmc_results results_of(const char *text, const pdmc_run_options *how)
{
    pdmc_study study;
    pdmc_results results;
    CHECK_OK(read_text(text, &study));
    CHECK_OK(pdmc_run(&study, how, &results));
    pdmc_study_clear(&study);
    return results;
}

static double rate(const double values[], int level)
{
    return log2(values[level - 1] / values[level]);
}

#define PLANE                                                                                                          \
    "kind = \"scalar\"; domain = { dimension = 2; width = 1; height = 0.75; }; kernel = { horizon = 0.23; };\n"        \
    "elements = { cells = 4; }; convergence = { levels = 3; };\n"

// int c xi^2 = 2 in each direction: L of a quadratic function is its Laplacian, at any horizon.
static void quadratic_functions_have_the_source_of_the_laplacian(void **state)
{
    (void)state;
    static const char *const studies[] = {
        "kind = \"scalar\"; domain = { dimension = 1; width = 1; }; kernel = { horizon = 0.13; };\n"
        "elements = { cells = 10; outer = \"exact\"; }; convergence = { levels = 3; };\n"
        "source = { value = -2; }; prescribed = { kind = \"polynomial\"; coefficients = [0.5, -1.0, 1.0]; };",
        PLANE "source = { value = -3; };\n"
              "prescribed = { kind = \"polynomial\"; coefficients = [0.5, -1.0, 2.0, 1.0, 0.7, 0.5]; };"};
    for (int i = 0; i < 2; i++) {
        pdmc_results r = results_of(studies[i], &options);
        const pdmc_scalar_record *s = &r.scalar;
        assert_true(isnan(s->wave_number) && isnan(s->wave[0]) && isnan(s->error[0]));
        CHECK_NEAR(rate(s->error, 2), 2.0, 0.35);
        double squares = 0.0;
        for (int k = 0; k < s->value_count; k++) {
            const double x = s->position[2 * k], y = s->position[2 * k + 1];
            const double want = i == 0 ? 0.5 - x + x * x : 0.5 - x + 2.0 * y + x * x + 0.7 * x * y + 0.5 * y * y;
            squares += gsl_pow_2(s->value[k] - want) / s->value_count;
        }
        assert_true(sqrt(squares) < s->error[2]); // what the last level says of the one before is three times its own error
        pdmc_results_clear(&r);
    }
}

// A bilinear function in a table, its points in any order, is that function.
static void tables_are_what_they_hold(void **state)
{
    (void)state;
    FILE *file = fopen("plane.txt", "w");
    fputs("# x y value\n", file);
    for (int i = 3; i >= 0; i--)
        for (int j = 0; j < 3; j++) {
            const double x = -1.0 + 0.5 * i * i * 0.5, y = -1.0 + j;
            fprintf(file, "%.17g %.17g %.17g # a point\n", x, y, 1.0 + 2.0 * x - y + 0.25 * x * y);
        }
    fclose(file);
    pdmc_results table = results_of(PLANE "prescribed = { kind = \"table\"; file = \"plane.txt\"; };\n"
                                          "source = { kind = \"table\"; file = \"plane.txt\"; };",
                                    &options);
    pdmc_results polynomial =
        results_of(PLANE "prescribed = { kind = \"polynomial\"; coefficients = [1.0, 2.0, -1.0, 0.0, 0.25]; };\n"
                         "source = { kind = \"polynomial\"; coefficients = [1.0, 2.0, -1.0, 0.0, 0.25]; };",
                   &options);
    for (int i = 0; i < table.scalar.value_count; i++)
        CHECK_NEAR(table.scalar.value[i], polynomial.scalar.value[i], 1e-12);
    pdmc_results_clear(&table);
    pdmc_results_clear(&polynomial);
}

// An open side with a flux, as the horizon vanishes: u = 0.7 (x + 1/2) and u = -0.4 (y - 3/8) are the classical solutions.
static void fluxes_become_those_of_the_classical_problem(void **state)
{
    (void)state;
    static const char *const studies[] = {
        "kind = \"scalar\"; domain = { dimension = 1; width = 1; }; kernel = { horizon = 0.08; };\n"
        "elements = { cells = 8; outer = \"exact\"; }; convergence = { vary = \"horizon\"; levels = 6; };\n"
        "open_sides = ( { side = \"right\"; flux = 0.7; } );",
        "kind = \"scalar\"; domain = { dimension = 2; width = 1; height = 0.75; }; kernel = { horizon = 0.032; };\n"
        "elements = { cells = 4; }; convergence = { vary = \"horizon\"; levels = 6; };\n"
        "open_sides = ( { side = \"bottom\"; flux = 0.4; }, { side = \"left\"; }, { side = \"right\"; } );"};
    for (int i = 0; i < 2; i++) {
        pdmc_results r = results_of(studies[i], &options);
        const pdmc_scalar_record *s = &r.scalar;
        print_message("  %dD: %.2e, %.2e, rate %.2f\n", s->dimension, s->classical[4], s->classical[5],
                      rate(s->classical, 5));
        CHECK_NEAR(rate(s->classical, 5), 1.0, 0.1);
        for (int k = 0; k < s->value_count; k++) {
            const double x = s->position[2 * k], y = s->position[2 * k + 1];
            const bool is_held = i == 0 ? x < -0.5 : y > 0.375;
            const double want = is_held ? 0.0 : i == 0 ? 0.7 * (x + 0.5) : -0.4 * (y - 0.375);
            CHECK_NEAR(s->value[k], want, 2.0 * s->horizon[5]); // the first order in the horizon
        }
        pdmc_results_clear(&r);
    }
}

#define BENT                                                                                                           \
    "kind = \"scalar\"; domain = { dimension = 1; width = 1; };\n"                                                     \
    "kernel = { horizon = 0.23; law = \"stiffening\"; stretch = 0.5; };\n"                                             \
    "elements = { cells = 8; inner = \"polynomial\"; }; source = { value = 2; }; convergence = { levels = 3; };\n"

static void bonds_with_a_law_rest_and_move(void **state)
{
    (void)state;
    const pdmc_run_options one = {.threads = 1}, three = {.threads = 3};
    pdmc_results a = results_of(BENT "motion = { duration = 0.4; };", &one),
                 b = results_of(BENT "motion = { duration = 0.4; };", &three);
    const pdmc_scalar_record *s = &a.scalar;
    assert_true(s->error[2] < s->error[1] && s->motion_error[2] < s->motion_error[1]); // slowly: the field jumps at held sides
    const double order = log(s->drift[1] / s->drift[2]) / log(s->steps[2] / s->steps[1]); // in the step
    CHECK_NEAR(order, 2.0, 0.2);
    for (int i = 0; i < 3; i++) assert_true(s->iterations[i] >= 2 && s->residual[i] <= 1e-11);
    assert_memory_equal(s->value, b.scalar.value, (size_t)s->value_count * sizeof *s->value);
    assert_memory_equal(s->moved, b.scalar.moved, (size_t)s->value_count * sizeof *s->moved);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

// Bonds whose law bends only far beyond the stretches that they have are linear: under the same source, to the square of
// stretch over the law's.
static void a_law_that_is_not_felt_is_linear(void **state)
{
    (void)state;
    static const char linear[] =
        "kind = \"scalar\"; domain = { dimension = 1; width = 1; }; kernel = { horizon = 0.23; };\n"
        "elements = { cells = 8; inner = \"polynomial\"; }; source = { value = 2; }; convergence = { levels = 2; };\n"
        "motion = { duration = 0.4; };";
    static const char slight[] =
        "kind = \"scalar\"; domain = { dimension = 1; width = 1; };\n"
        "kernel = { horizon = 0.23; law = \"softening\"; stretch = 1e5; };\n"
        "elements = { cells = 8; inner = \"polynomial\"; }; source = { value = 2; }; convergence = { levels = 2; };\n"
        "motion = { duration = 0.4; };";
    pdmc_results a = results_of(linear, &options), b = results_of(slight, &options);
    for (int i = 0; i < a.scalar.value_count; i++) {
        CHECK_NEAR(a.scalar.value[i], b.scalar.value[i], 1e-8);
        CHECK_NEAR(a.scalar.moved[i], b.scalar.moved[i], 1e-8);
    }
    assert_true(isnan(a.scalar.drift[0]) && b.scalar.drift[1] < 0.01);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

// The wave with the source of the law's own operator.
static void waves_of_bonds_with_a_law_converge(void **state)
{
    (void)state;
    pdmc_results r = results_of(
        "kind = \"scalar\"; domain = { dimension = 1; width = 1; };\n"
        "kernel = { horizon = 0.13; law = \"saturating\"; stretch = 4; }; elements = { cells = 10; inner = \"polynomial\"; };\n"
        "wave = { length = 1.25; phase = 40; }; convergence = { levels = 3; };",
        &options);
    CHECK_NEAR(rate(r.scalar.error, 2), 2.0, 0.3);
    CHECK_NEAR(r.scalar.iterations[2], 5.0, 3.0);
    pdmc_results_clear(&r);
}

static void memory_that_is_refused_is_told(void **state)
{
    (void)state;
    pdmc_results r;
    pdmc_study study;
    CHECK_OK(read_text("kind = \"scalar\"; domain = { dimension = 1; width = 1; };\n"
                       "kernel = { horizon = 0.3; law = \"stiffening\"; stretch = 1; };\n"
                       "elements = { cells = 3; inner = \"polynomial\"; }; convergence = { levels = 2; };\n"
                       "source = { value = 1; }; open_sides = ( { side = \"left\"; } ); motion = { duration = 0.01; };",
                       &study));
    const pdmc_run_options one = {.threads = 1};
    CHECK_FAILS_CLEANLY(pdmc_run(&study, &one, &r), pdmc_results_clear(&r));
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quadratic_functions_have_the_source_of_the_laplacian),
        cmocka_unit_test(tables_are_what_they_hold),
        cmocka_unit_test(fluxes_become_those_of_the_classical_problem),
        cmocka_unit_test(bonds_with_a_law_rest_and_move),
        cmocka_unit_test(a_law_that_is_not_felt_is_linear),
        cmocka_unit_test(waves_of_bonds_with_a_law_converge),
        cmocka_unit_test(memory_that_is_refused_is_told),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
