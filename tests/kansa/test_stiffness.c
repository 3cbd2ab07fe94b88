// SPDX-License-Identifier: GPL-3.0-or-later

/// A stiffness that varies in space: the operator of the weak form, and its verbs against one another.

#include "kansa/boundary_collocation.h"
#include "kansa/stiff_plate.h"
#include "pdmc/fracture.h"
#include "support/drawn_block.h"

#include <cblas.h>

enum { B = PDMC_BLOCK };

static const wave_modulus waves[3] = {{0.3, 2.0, {0.7, 0.4}}, {0.2, 1.0, {0.1, 2.4}}, {0.25, 4.0, {1.7, 0.9}}};
static const given_moduli three_waves = {3, wave_modulus_at, {&waves[0], &waves[1], &waves[2]}};
static const linear_modulus constant = {{0.0, 0.0}};

static double twice(const void *context, const double x[2])
{
    (void)context;
    (void)x;
    return 2.0;
}
static const given_moduli uniform = {1, twice, {&constant}};

static void fill_random(size_t count, uint64_t stream, double value[])
{
    pdmc_random_uniform(7, PDMC_STREAM_PROBES, stream, 0, count, value);
    for (size_t i = 0; i < count; i++) value[i] -= 0.5;
}

static void the_mean_agrees_with_boundary_collocation(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        stiff_plate s;
        pdmc_affine model;
        reference exact = {0};
        const double angle = k * acos(-1.0) / 6.0, none = 0.0;
        double K[2];
        stiff_plate_make(&s, 10, angle, 2);
        stiff_plate_model(&s, &uniform, &model);
        reference_solve(&exact, 5.0, 0.5, angle);
        for (int tip = 0; tip < 2; tip++) {
            energy_release_rate(&model, tip, &none, pdmc_affine_solution(&model, 1), K);
            printf("  angle %.2f: K_I %+.1e, K_II %+.1e of K\n", angle, (K[0] - exact.K[0]) / exact.K[0],
                   (K[1] - exact.K[1]) / exact.K[0]);
            CHECK_NEAR(K[0] / exact.K[0], 1.0, 5e-4);
            CHECK_NEAR((K[1] - exact.K[1]) / exact.K[0], 0.0, 5e-4);
        }
        pdmc_affine_clear(&model);
        stiff_plate_clear(&s);
    }
}

// With psi = 1 the term is the identity but for three rigid motions: a projection. The Cholesky factor of a matrix of
// condition 1e9 leaves 1e-7 of rounding.
static void the_mean_operator_is_the_identity(void **state)
{
    (void)state;
    stiff_plate s;
    pdmc_affine model;
    stiff_plate_make(&s, 6, 0.3, 2);
    stiff_plate_model(&s, &uniform, &model);
    const int n = model.unknowns;
    const size_t values = (size_t)B * (size_t)n;
    double *xi = new_values(B), *x = new_values(values), *y = new_values(values), *z = new_values(values);
    for (int c = 0; c < B; c++) xi[c] = 1.0;
    fill_random(values, 1, x);
    CHECK_OK(model.verbs->multiply(&model, 0.0, xi, x, y));
    CHECK_OK(model.verbs->multiply(&model, 0.0, xi, y, z));
    for (size_t i = 0; i < values; i++) CHECK_NEAR(z[i], y[i], 1e-6);
    // What is left of x has three directions: the fourth singular value of the block is rounding.
    double gram[B * B], eigenvalue[B];
    for (size_t i = 0; i < values; i++) y[i] = x[i] - y[i];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, B, B, n, 1.0, y, n, y, n, 0.0, gram, B);
    assert_int_equal(LAPACKE_dsyev(LAPACK_COL_MAJOR, 'N', 'L', B, gram, B, eigenvalue), 0);
    assert_true(eigenvalue[B - 3] > 0.1 && eigenvalue[B - 4] < 1e-10);
    CHECK_OK(model.verbs->precondition(&model, B, x, y));
    for (size_t i = 0; i < values; i++) assert_true(y[i] == x[i]);
    free(xi);
    free(x);
    free(y);
    free(z);
    pdmc_affine_clear(&model);
    stiff_plate_clear(&s);
}

// Half again the stiffness is two thirds of the displacement, and under tractions the same K.
static void a_uniform_stiffness_scales_the_answer(void **state)
{
    (void)state;
    stiff_plate s;
    pdmc_affine model;
    stiff_plate_make(&s, 6, 0.3, 2);
    stiff_plate_model(&s, &uniform, &model);
    const double xi = 0.5, none = 0.0, scale[2] = {1.0, 1.0};
    double *x = new_values((size_t)model.unknowns), K[2], mean[2];
    CHECK_OK(model.verbs->solve(&model, &xi, scale, x));
    for (int i = 0; i < model.unknowns; i++) CHECK_NEAR(1.5 * x[i], pdmc_affine_solution(&model, 1)[i], 1e-6);
    for (int tip = 0; tip < 2; tip++) {
        const double G = energy_release_rate(&model, tip, &xi, x, K);
        const double G_0 = energy_release_rate(&model, tip, &none, pdmc_affine_solution(&model, 1), mean);
        for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], mean[k], 1e-6);
        CHECK_NEAR(G * 1.5 / G_0, 1.0, 1e-6);
    }
    free(x);
    pdmc_affine_clear(&model);
    stiff_plate_clear(&s);
}

static void the_verbs_agree(void **state)
{
    (void)state;
    stiff_plate s;
    pdmc_affine model;
    stiff_plate_make(&s, 6, 0.3, 2);
    stiff_plate_model(&s, &three_waves, &model);
    const int n = model.unknowns, T = model.terms;
    const size_t values = (size_t)B * (size_t)n;
    const double scale[2] = {0.0, 2.0};
    double *xi = new_values((size_t)(B * T)), *x = new_values(values), *y = new_values(values), *z = new_values(values);
    double *terms = new_values((size_t)(T * B * B)), *mirrored = new_values((size_t)(T * B * B));
    fill_random((size_t)(B * T), 2, xi);
    for (int c = 0; c < B; c++) CHECK_OK(model.verbs->solve(&model, &xi[c * T], scale, &x[(size_t)c * (size_t)n]));
    CHECK_OK(model.verbs->multiply(&model, 1.0, xi, x, y));
    for (size_t i = 0; i < values; i++) CHECK_NEAR(y[i], 2.0 * pdmc_affine_solution(&model, 1)[i % (size_t)n], 1e-11);
    CHECK_OK(model.verbs->perturb(&model, xi, x, z));
    for (size_t i = 0; i < values; i++) CHECK_NEAR(x[i] + z[i], y[i], 1e-12);
    fill_random(values, 3, z);
    CHECK_OK(model.verbs->multiply(&model, 0.0, xi, x, y));
    CHECK_OK(model.verbs->project(&model, B, z, B, x, terms));
    CHECK_OK(model.verbs->project(&model, B, x, B, z, mirrored));
    for (int i = 0; i < B; i++)
        for (int c = 0; c < B; c++) {
            double sum = 0.0;
            for (int m = 0; m < T; m++) {
                sum += xi[c * T + m] * terms[(m * B + i) * B + c];
                CHECK_NEAR(terms[(m * B + i) * B + c], mirrored[(m * B + c) * B + i], 1e-11);
            }
            CHECK_NEAR(sum, inner(n, &z[(size_t)i * (size_t)n], &y[(size_t)c * (size_t)n]), 1e-11);
        }
    free(xi);
    free(x);
    free(y);
    free(z);
    free(terms);
    free(mirrored);
    pdmc_affine_clear(&model);
    stiff_plate_clear(&s);
}

// alpha is the smallest M at a point of the rule, and so at least the smallest of all; Rayleigh's quotient is at least alpha.
static void the_coercivity_is_a_bound(void **state)
{
    (void)state;
    stiff_plate s;
    pdmc_affine model;
    stiff_plate_make(&s, 6, 0.3, 2);
    stiff_plate_model(&s, &three_waves, &model);
    const int n = model.unknowns;
    const size_t values = (size_t)B * (size_t)n;
    double *xi = new_values(B * 3), *x = new_values(values), *y = new_values(values), alpha[B];
    for (int c = 0; c < B; c++) xi[3 * c] = c / (double)B; // 1 +- 0.3 xi
    fill_random(values, 4, x);
    CHECK_OK(model.verbs->coercivity(&model, xi, alpha));
    CHECK_OK(model.verbs->multiply(&model, 1.0, xi, x, y));
    for (int c = 0; c < B; c++) {
        const double *column = &x[(size_t)c * (size_t)n];
        assert_true(inner(n, column, &y[(size_t)c * (size_t)n]) >= alpha[c] * inner(n, column, column));
        CHECK_NEAR(alpha[c], 1.0 - 0.3 * xi[3 * c], 0.01 * xi[3 * c]);
    }
    free(xi);
    free(x);
    free(y);
    pdmc_affine_clear(&model);
    stiff_plate_clear(&s);
}

// d ln G by central differences of solutions; their third derivatives leave some 1e-6.
static void the_sensitivity_is_the_derivative(void **state)
{
    (void)state;
    stiff_plate s;
    pdmc_affine model;
    stiff_plate_make(&s, 6, 0.3, 2);
    stiff_plate_model(&s, &three_waves, &model);
    const pdmc_field_functional *sensitivity = pdmc_kansa_field_sensitivity(s.form);
    for (int tip = 0; tip < 2; tip++) {
        double sum = 0.0;
        for (int j = 0; j < sensitivity[tip].points; j++) sum += sensitivity[tip].weight[j];
        CHECK_NEAR(sum, -1.0, 1e-6); // the uniform stiffness again
        for (int k = 0; k < 3; k++) {
            const double step = 1e-3;
            double more[3] = {0.0}, less[3] = {0.0}, slope = 0.0;
            more[k] = step;
            less[k] = -step;
            for (int j = 0; j < sensitivity[tip].points; j++)
                slope += sensitivity[tip].weight[j] * (wave_modulus_at(&waves[k], &sensitivity[tip].x[2 * j]) - 1.0);
            const double difference = log(solved_energy(&model, tip, more) / solved_energy(&model, tip, less));
            CHECK_NEAR(difference / (2.0 * step), slope, 1e-6);
        }
    }
    pdmc_affine_clear(&model);
    stiff_plate_clear(&s);
}

static double energy_by_definition(const stiff_plate *s, const double solution[], const double x_t[2], double phi)
{
    static pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    const pdmc_problem *problem = &s->p.problem;
    const int n = s->form->unknowns;
    pdmc_ring_rule rings;
    pdmc_row_builder builder;
    int count;
    double sum = 0.0, *row = new_values(4 * (size_t)n);
    CHECK_OK(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, 1, 3, problem->energy.horizon, &rings));
    CHECK_OK(pdmc_crossing_bonds(problem, x_t, phi, &rings, &count, bonds));
    CHECK_OK(pdmc_row_builder_create(&s->kansa->basis, &builder));
    for (int b = 0; b < count; b++) {
        pdmc_displacement_rows(&builder, bonds[b].start, bonds[b].start, row, row + n);
        pdmc_displacement_rows(&builder, bonds[b].end, bonds[b].end, row + 2 * n, row + 3 * n);
        pdmc_kansa_whiten(s->kansa, 4, row);
        pdmc_kansa_form_transform(s->form, 4, row);
        double stretch = 0.0;
        for (int k = 0; k < 2; k++)
            stretch +=
                bonds[b].direction[k] * (inner(n, row + (2 + k) * n, solution) - inner(n, row + k * n, solution));
        sum += rings.mean[bonds[b].ring] * bonds[b].weight * stretch * stretch;
    }
    pdmc_row_builder_clear(&builder);
    pdmc_ring_rule_clear(&rings);
    free(row);
    return 0.5 * pdmc_micromodulus(&problem->material, problem->energy.horizon) * sum;
}

static void the_energy_is_that_of_the_definition(void **state)
{
    (void)state;
    stiff_plate s;
    pdmc_affine model;
    stiff_plate_make(&s, 6, 0.0, 2);
    stiff_plate_model(&s, &three_waves, &model);
    const double xi[3] = {0.5, -0.5, 0.3}, scale[2] = {1.0, 1.0}, extension = s.p.problem.energy.extension;
    const int n = model.unknowns, m = model.observed;
    double *x = new_values((size_t)n), *observed = new_values((size_t)m);
    CHECK_OK(model.verbs->solve(&model, xi, scale, x));
    cblas_dgemv(CblasRowMajor, CblasNoTrans, m, n, 1.0, model.observe, n, x, 1, 0.0, observed, 1);
    printf("  %d of %d directions are observed\n", m, n);
    for (int a = 0; a < 8; a += 3) {
        const double phi = 2.0 * acos(-1.0) * a / 8.0;
        const double x_t[2] = {0.5 + extension * cos(phi), extension * sin(phi)};
        const pdmc_crossing *crossing = &model.crossings[8 + a];
        double energy = 0.0;
        for (int b = 0; b < crossing->bonds; b++)
            energy += 0.5 * model.micromodulus * model.ring_weight[crossing->ring[b]] *
                      pow(inner(m, &crossing->row[b * m], observed), 2);
        const double error = energy / energy_by_definition(&s, x, x_t, phi) - 1.0;
        printf("  direction %d: energy off its definition by %.1e, its root is %.4f of the bound\n", a, error,
               sqrt(energy) / (model.crossing_bound * sqrt(inner(n, x, x))));
        CHECK_NEAR(error, 0.0, 1e-5); // measured some 1e-6
        assert_true(sqrt(energy) <= model.crossing_bound * sqrt(inner(n, x, x)));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(model.direction_stiffness[(8 + a) * 3 + k], wave_modulus_at(&waves[k], x_t) - 1.0, 1e-14);
    }
    free(x);
    free(observed);
    pdmc_affine_clear(&model);
    stiff_plate_clear(&s);
}

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    double *y[2], *terms[2], *x[2], xi[B * 3];
    size_t values = 0;
    fill_random(B * 3, 5, xi);
    for (int k = 0; k < 2; k++) {
        stiff_plate s;
        pdmc_affine model;
        const double scale[2] = {1.0, 1.0};
        stiff_plate_make(&s, 6, 0.3, 1 + 2 * k);
        stiff_plate_model(&s, &three_waves, &model);
        values = (size_t)B * (size_t)model.unknowns;
        double *v = new_values(values);
        fill_random(values, 6, v);
        y[k] = new_values(values);
        terms[k] = new_values(3 * 5 * B);
        x[k] = new_values(values / B);
        CHECK_OK(model.verbs->multiply(&model, 1.0, xi, v, y[k]));
        CHECK_OK(model.verbs->project(&model, 5, v, B, y[k], terms[k]));
        CHECK_OK(model.verbs->solve(&model, xi, scale, x[k]));
        free(v);
        pdmc_affine_clear(&model);
        stiff_plate_clear(&s);
    }
    assert_memory_equal(y[0], y[1], values * sizeof(double));
    assert_memory_equal(terms[0], terms[1], 3 * 5 * B * sizeof(double));
    assert_memory_equal(x[0], x[1], values / B * sizeof(double));
    for (int k = 0; k < 2; k++) {
        free(y[k]);
        free(terms[k]);
        free(x[k]);
    }
}

static void refused_allocations_are_reported(void **state)
{
    (void)state;
    plate p;
    pdmc_kansa *kansa = NULL;
    pdmc_kansa_form *form = NULL;
    pdmc_affine model;
    const pdmc_stiffness_terms terms = {3, &three_waves, given_moduli_at};
    const double scale[2] = {1.0, 1.0};
    double xi[B * 3] = {0.0}, alpha[B];
    plate_make_cracked(&p, 0.5, 0.0, 4);
    p.problem.solver.crack_orders = 2;
    p.problem.energy.angles = 2;
    p.problem.energy.tip_count = 1;
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 1, &kansa));
    CHECK_FAILS_CLEANLY(pdmc_kansa_form_create(kansa, &form), (void)0);
    CHECK_FAILS_CLEANLY(pdmc_kansa_form_affine(form, &terms, &model), (void)0);
    double *x = new_values((size_t)B * (size_t)model.unknowns), *y = new_values((size_t)B * (size_t)model.unknowns);
    CHECK_FAILS_CLEANLY(model.verbs->multiply(&model, 1.0, xi, x, y), (void)0);
    CHECK_FAILS_CLEANLY(model.verbs->solve(&model, xi, scale, x), (void)0);
    CHECK_FAILS_CLEANLY(model.verbs->project(&model, 1, x, 1, x, y), (void)0);
    CHECK_FAILS_CLEANLY(model.verbs->coercivity(&model, xi, alpha), (void)0);
    free(x);
    free(y);
    pdmc_affine_clear(&model);
    pdmc_kansa_form_destroy(&form);
    pdmc_kansa_destroy(&kansa);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_mean_agrees_with_boundary_collocation),
        cmocka_unit_test(the_mean_operator_is_the_identity),
        cmocka_unit_test(a_uniform_stiffness_scales_the_answer),
        cmocka_unit_test(the_verbs_agree),
        cmocka_unit_test(the_coercivity_is_a_bound),
        cmocka_unit_test(the_sensitivity_is_the_derivative),
        cmocka_unit_test(the_energy_is_that_of_the_definition),
        cmocka_unit_test(threads_do_not_change_a_bit),
        cmocka_unit_test(refused_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
