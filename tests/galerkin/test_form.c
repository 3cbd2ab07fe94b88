// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/wave.h"

#include <string.h>

static const pdmc_form_rule exact = {.outer = PDMC_OUTER_EXACT, .parts = 1};
static const pdmc_form_rule gauss = {.outer = PDMC_OUTER_GAUSS, .inner = PDMC_INNER_EXACT, .parts = 1};
static const pdmc_form_rule edges = {.outer = PDMC_OUTER_EDGES, .inner = PDMC_INNER_EXACT, .parts = 1};

static pdmc_form form_of(const setting *s, const pdmc_form_rule *rule, int threads)
{
    pdmc_form form;
    CHECK_OK(pdmc_form_peridynamic(&s->space, &s->kernel, rule, threads, &form));
    return form;
}

static double largest(int count, const double x[])
{
    double most = 0.0;
    for (int i = 0; i < count; i++) most = fmax(most, fabs(x[i]));
    return most;
}

// No bond of a constant is stretched, whatever the rule; and whatever the rule, no function has less than no energy.
static void constants_have_no_energy(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int space = PDMC_SPACE_CONTINUOUS; space <= PDMC_SPACE_MIXED; space++)
            for (int which = dimension == 1 ? 0 : 1; which < 5; which++) {
                const pdmc_form_rule rules[5] = {exact,
                                                 gauss,
                                                 edges,
                                                 {PDMC_OUTER_GAUSS, PDMC_INNER_POLYNOMIAL, 2},
                                                 {PDMC_OUTER_GAUSS, PDMC_INNER_CARELESS, 1}};
                const steady s = {dimension, 5, 0.27, 0.8, (pdmc_space_kind)space, rules[which]};
                setting at;
                setting_create(&s, &at);
                pdmc_form form = form_of(&at, &rules[which], 1);
                double *one = pdmc_calloc((size_t)at.space.count, sizeof *one);
                double *force = pdmc_calloc((size_t)at.space.free_count, sizeof *force);
                for (int i = 0; i < at.space.count; i++) one[i] = 1.0;
                pdmc_form_multiply(&form, one, force);
                CHECK_NEAR(largest(at.space.free_count, force), 0.0, 1e-12);
                for (int j = 0; j < form.free_count; j++) assert_true(form.value[form.start[j]] > 0.0); // the diagonal
                pdmc_free(one);
                pdmc_free(force);
                pdmc_form_clear(&form);
                setting_clear(&at);
            }
}

// L x = 0: a linear function is in balance, exactly where both integrals are.
static void linear_functions_are_in_balance(void **state)
{
    (void)state;
    for (double power = 0.0; power < 1.9; power += 0.6) {
        const steady s = {1, 7, 0.31, power, PDMC_SPACE_DISCONTINUOUS, exact};
        setting at;
        setting_create(&s, &at);
        pdmc_form form = form_of(&at, &exact, 1);
        double *force = pdmc_calloc((size_t)at.space.free_count, sizeof *force);
        pdmc_form_multiply(&form, at.space.x, force);
        CHECK_NEAR(largest(at.space.free_count, force), 0.0, 1e-11); // of entries of 1e2
        pdmc_free(force);
        pdmc_form_clear(&form);
        setting_clear(&at);
    }
}

// A unit jump at one node: all bonds across it have a stretch of 1, int_0^delta r c dr = 2 / delta with power 1, and
// with any power 2 (3 - p) / (2 (2 - p)) ... (3 - p) / (2 - p) / delta.
static void a_jump_has_its_energy_in_closed_form(void **state)
{
    (void)state;
    for (double power = 0.0; power < 1.9; power += 0.6) {
        const steady s = {1, 8, 0.3, power, PDMC_SPACE_DISCONTINUOUS, exact};
        setting at;
        setting_create(&s, &at);
        pdmc_form form = form_of(&at, &exact, 1);
        double *jump = pdmc_calloc((size_t)at.space.count, sizeof *jump), energy = 0.0;
        double *force = pdmc_calloc((size_t)at.space.free_count, sizeof *force);
        for (int e = 0; e < at.mesh.element_count; e++)
            for (int a = 0; a < 2; a++)
                jump[at.space.value[2 * e + a]] = at.mesh.x[at.mesh.corner[2 * e]] > -1e-9 ? 1.0 : 0.0;
        pdmc_form_multiply(&form, jump,
                           force); // bonds across the jump end in the body: the layer is beyond the horizon
        for (int i = 0; i < at.space.free_count; i++) energy += force[i] * jump[i];
        CHECK_NEAR(energy, (3.0 - power) / (2.0 - power) / 0.3, 1e-12);
        pdmc_free(jump);
        pdmc_free(force);
        pdmc_form_clear(&form);
        setting_clear(&at);
    }
}

// The exact form of intervals against the other way to compute it, points with exact inner integrals, in ever more
// parts: for a continuous space, whose integrand has no more than kinks.
static void points_in_many_parts_approach_the_exact_form(void **state)
{
    (void)state;
    const double weight[2] = {1.0, 3.0};
    const steady s = {1, 4, 0.33, 1.0, PDMC_SPACE_CONTINUOUS, exact};
    double error[2] = {0.0, 0.0};
    setting at;
    setting_create(&s, &at);
    CHECK_OK(pdmc_scalar_kernel_create(1, 0.33, 1.4, 2, weight, &at.kernel));
    pdmc_form want = form_of(&at, &exact, 1);
    for (int fine = 0; fine < 2; fine++) {
        const pdmc_form_rule rule = {PDMC_OUTER_GAUSS, PDMC_INNER_EXACT, fine ? 256 : 64};
        pdmc_form got = form_of(&at, &rule, 2);
        for (int64_t k = 0; k < want.start[want.free_count]; k++) {
            assert_int_equal(got.row[k], want.row[k]);
            error[fine] = fmax(error[fine], fabs(got.value[k] - want.value[k]));
        }
        pdmc_form_clear(&got);
    }
    print_message("entries to %.2g, then %.2g of %.2g\n", error[0], error[1], want.value[0]);
    CHECK_NEAR(error[1], 0.0, 1e-4 * want.value[0]);
    assert_true(error[1] < 0.3 * error[0]);
    pdmc_form_clear(&want);
    setting_clear(&at);
}

static void forms_have_the_same_bits_on_any_number_of_threads(void **state)
{
    (void)state;
    const steady s = {2, 12, 0.2, 1.0, PDMC_SPACE_MIXED, gauss};
    setting at;
    setting_create(&s, &at);
    pdmc_form one = form_of(&at, &gauss, 1), three = form_of(&at, &gauss, 3);
    assert_memory_equal(one.value, three.value, (size_t)one.start[one.free_count] * sizeof *one.value);
    pdmc_form_clear(&one);
    pdmc_form_clear(&three);
    setting_clear(&at);
}

static double energy_of(const setting *s, const pdmc_form *form, const double u[], const double v[])
{
    double *force = pdmc_calloc((size_t)s->space.free_count, sizeof *force), energy = 0.0;
    pdmc_form_multiply(form, u, force);
    for (int i = 0; i < s->space.free_count; i++) energy += force[i] * v[i];
    pdmc_free(force);
    return energy;
}

// With discontinuous values all of the body's are free: int 1, int x^2 + y^2, and the gradient of a linear function.
static void mass_and_gradient_are_those_of_the_body(void **state)
{
    (void)state;
    const steady s = {2, 5, 0.1, 1.0, PDMC_SPACE_DISCONTINUOUS, edges};
    setting at;
    pdmc_form mass, gradient;
    setting_create(&s, &at);
    CHECK_OK(pdmc_form_mass(&at.space, &mass));
    CHECK_OK(pdmc_form_gradient(&at.space, &gradient));
    double *u = pdmc_calloc(2 * (size_t)at.space.count, sizeof *u), *one = &u[at.space.count];
    for (int i = 0; i < at.space.count; i++) {
        one[i] = 1.0;
        u[i] = 2.0 * at.space.x[2 * i] - 3.0 * at.space.x[2 * i + 1];
    }
    CHECK_NEAR(energy_of(&at, &mass, one, one), 1.0, 1e-13);
    CHECK_NEAR(energy_of(&at, &mass, u, u), 13.0 / 12.0, 1e-13);
    CHECK_NEAR(energy_of(&at, &gradient, u, u), 13.0, 1e-12);
    CHECK_NEAR(energy_of(&at, &gradient, u, one), 0.0, 1e-12);
    double distance;
    CHECK_OK(pdmc_space_distance(&at.space, u, NULL, NULL, &distance));
    CHECK_NEAR(distance, sqrt(13.0 / 12.0), 1e-13);
    pdmc_free(u);
    pdmc_form_clear(&mass);
    pdmc_form_clear(&gradient);
    setting_clear(&at);
}

// ... and of a triangle: a corner's form, which the rule of one part has to 1e-3 already.
static void parts_of_triangles_add_up(void **state)
{
    (void)state;
    const steady s = {2, 6, 0.3, 1.0, PDMC_SPACE_CONTINUOUS, gauss};
    const pdmc_form_rule three = {PDMC_OUTER_GAUSS, PDMC_INNER_EXACT, 3};
    setting at;
    setting_create(&s, &at);
    pdmc_form one = form_of(&at, &gauss, 2), parts = form_of(&at, &three, 2);
    for (int j = 0; j < one.free_count; j++)
        CHECK_NEAR(parts.value[parts.start[j]] / one.value[one.start[j]], 1.0, 1e-3);
    pdmc_form_clear(&one);
    pdmc_form_clear(&parts);
    setting_clear(&at);
}

static pdmc_status make_all(void)
{
    pdmc_status status = PDMC_OK;
    const double size[2] = {1.0, 1.0};
    const int cells[2] = {2, 2};
    pdmc_mesh mesh = {0};
    pdmc_space space = {0};
    pdmc_form form = {0};
    pdmc_scalar_kernel kernel;
    PDMC_TRY(pdmc_mesh_box(2, size, cells, 0.3, &mesh));
    PDMC_TRY(pdmc_space_create(&mesh, PDMC_SPACE_MIXED, &space));
    PDMC_TRY(pdmc_scalar_kernel_create(2, 0.3, 1.0, 1, NULL, &kernel));
    PDMC_TRY(pdmc_form_peridynamic(&space, &kernel, &gauss, 1, &form));
done:
    pdmc_form_clear(&form);
    pdmc_space_clear(&space);
    pdmc_mesh_clear(&mesh);
    return status;
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    const steady flat = {2, 3, 0.2, 1.0, PDMC_SPACE_CONTINUOUS, gauss},
                 line = {1, 3, 0.2, 1.0, PDMC_SPACE_CONTINUOUS, gauss};
    setting at;
    pdmc_form form;
    pdmc_mesh mesh;
    setting_create(&flat, &at);
    CHECK_STATUS(pdmc_form_peridynamic(&at.space, &at.kernel, &exact, 1, &form), PDMC_ERR_ARG);
    setting_clear(&at);
    setting_create(&line, &at); // the integral from the end of an interval of a kernel of power 1
    CHECK_STATUS(pdmc_form_peridynamic(&at.space, &at.kernel, &edges, 1, &form), PDMC_ERR_ARG);
    setting_clear(&at);
    CHECK_STATUS(pdmc_mesh_box(1, (double[1]){1.0}, (int[1]){0}, 0.1, &mesh), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_mesh_box(1, (double[1]){-1.0}, (int[1]){1}, 0.1, &mesh), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_mesh_box(1, (double[1]){1.0}, (int[1]){1}, 0.0, &mesh), PDMC_ERR_ARG);
    CHECK_OK(pdmc_mesh_box(1, (double[1]){1.0}, (int[1]){1}, 0.1, &mesh));
    CHECK_STATUS(pdmc_space_create(&mesh, PDMC_SPACE_CONTINUOUS, &at.space), PDMC_ERR_ARG); // nothing is free
    pdmc_mesh_clear(&mesh);
    CHECK_FAILS_CLEANLY(make_all(), );
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_have_no_energy),
        cmocka_unit_test(linear_functions_are_in_balance),
        cmocka_unit_test(a_jump_has_its_energy_in_closed_form),
        cmocka_unit_test(points_in_many_parts_approach_the_exact_form),
        cmocka_unit_test(forms_have_the_same_bits_on_any_number_of_threads),
        cmocka_unit_test(mass_and_gradient_are_those_of_the_body),
        cmocka_unit_test(parts_of_triangles_add_up),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
