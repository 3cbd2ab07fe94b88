// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/wave.h"

typedef struct {
    setting at;
    pdmc_form form, mass;
    double largest, error;
} moving;

static void moving_create(const steady *s, moving *m)
{
    setting_create(s, &m->at);
    CHECK_OK(pdmc_form_peridynamic(&m->at.space, &m->at.kernel, &s->rule, 2, &m->form));
    CHECK_OK(pdmc_form_mass(&m->at.space, &m->mass));
    CHECK_OK(pdmc_form_largest_eigenvalue(&m->form, &m->mass, &m->largest, &m->error));
}

static void moving_clear(moving *m)
{
    pdmc_form_clear(&m->form);
    pdmc_form_clear(&m->mass);
    setting_clear(&m->at);
}

// Classical elements of length h between fixed ends: (6 / h^2) (1 - cos a) / (2 + cos a) with a = pi (n - 1) / n.
static void the_largest_eigenvalue_of_classical_elements_is_known(void **state)
{
    (void)state;
    enum { N = 12 };
    const steady s = {1, N, 0.1, 1.0, PDMC_SPACE_CONTINUOUS, {PDMC_OUTER_EXACT, PDMC_INNER_EXACT, 1}};
    setting at;
    pdmc_form gradient, mass;
    double largest, error;
    setting_create(&s, &at);
    CHECK_OK(pdmc_form_gradient(&at.space, &gradient));
    CHECK_OK(pdmc_form_mass(&at.space, &mass));
    CHECK_OK(pdmc_form_largest_eigenvalue(&gradient, &mass, &largest, &error));
    const double a = M_PI * (N - 1) / N;
    CHECK_NEAR(largest, 6.0 * N * N * (1.0 - cos(a)) / (2.0 + cos(a)), 1e-10 * largest);
    assert_true(error < 1e-8 * largest);
    CHECK_FAILS_CLEANLY(pdmc_form_largest_eigenvalue(&gradient, &mass, &largest, &error), );
    pdmc_form_clear(&gradient);
    pdmc_form_clear(&mass);
    setting_clear(&at);
}

// The largest of what is left after many steps from a jagged start that has some of every mode.
static double amplitude(const moving *m, double factor)
{
    double *u = pdmc_calloc((size_t)m->at.space.count, sizeof *u), most = 0.0;
    for (int i = 0; i < m->at.space.free_count; i++) u[i] = (i * 7 % 11) / 11.0 - 0.5;
    CHECK_OK(
        pdmc_form_march(&m->form, &m->mass, m->at.space.count, NULL, factor * pdmc_stable_step(m->largest), 1000, 0.0, u));
    for (int i = 0; i < m->at.space.free_count; i++) most = fmax(most, fabs(u[i]));
    pdmc_free(u);
    return most;
}

// dt^2 lambda < 4, four times what the notes have. An unstable mode grows by e^(2 sqrt(factor^2 - 1)) in each step: of
// a factor of 1.01 to more than e^280 in 1000 steps.
static void central_differences_are_stable_up_to_the_step_of_the_largest_eigenvalue(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int space = PDMC_SPACE_CONTINUOUS; space <= PDMC_SPACE_DISCONTINUOUS; space++) {
            const steady s = {dimension, dimension == 1 ? 12 : 4, 0.2,
                              1.0,       (pdmc_space_kind)space,  {PDMC_OUTER_GAUSS, PDMC_INNER_EXACT, 1}};
            moving m;
            moving_create(&s, &m);
            assert_true(m.error <= 1e-8 * m.largest);
            assert_true(amplitude(&m, 0.999) < 1e3);
            assert_true(!(amplitude(&m, 1.01) < 1e60));
            moving_clear(&m);
        }
}

// A standing wave with the frequency of the analytic dispersion, whose layer moves with it, after three quarters of a
// period and a bit.
static double standing_wave_error(const steady *s, double share_of_stable_step)
{
    double lambda, error;
    moving m;
    moving_create(s, &m);
    const size_t d = (size_t)s->dimension;
    wave w = wave_of(s->dimension);
    CHECK_OK(pdmc_scalar_dispersion(&m.at.kernel, 5.0, &lambda));
    const double duration = 5.3 / sqrt(lambda);
    const int steps = (int)ceil(duration / (share_of_stable_step * pdmc_stable_step(m.largest)));
    double *u = pdmc_calloc((size_t)m.at.space.count, sizeof *u);
    for (int i = 0; i < m.at.space.count; i++) u[i] = wave_at(&w, &m.at.space.x[d * (size_t)i]);
    CHECK_OK(pdmc_form_march(&m.form, &m.mass, m.at.space.count, NULL, duration / steps, steps, sqrt(lambda), u));
    w.factor = cos(5.3);
    CHECK_OK(pdmc_space_distance(&m.at.space, u, wave_at, &w, &error));
    pdmc_free(u);
    moving_clear(&m);
    return error;
}

// The stable step hardly depends on the elements, as the kernel's integral bounds all frequencies: so it is cut with their
// size, for an error of the second order in both.
static void waves_follow_the_analytic_dispersion(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int space = PDMC_SPACE_CONTINUOUS; space <= PDMC_SPACE_MIXED; space++) {
            steady s = {dimension, dimension == 1 ? 10 : 4, 0.23,
                        1.0,       (pdmc_space_kind)space,  {PDMC_OUTER_GAUSS, PDMC_INNER_EXACT, 1}};
            const double coarse = standing_wave_error(&s, 0.2);
            s.cells *= 2;
            const double fine = standing_wave_error(&s, 0.1);
            print_message("  %dD space %d: %.2e %.2e (%.2f)\n", dimension, space, coarse, fine, log2(coarse / fine));
            CHECK_NEAR(log2(coarse / fine), 2.0, 0.3);
        }
}

static void steps_that_cannot_be_are_refused(void **state)
{
    (void)state;
    const steady s = {1, 4, 0.3, 1.0, PDMC_SPACE_CONTINUOUS, {PDMC_OUTER_GAUSS, PDMC_INNER_EXACT, 1}};
    moving m;
    moving_create(&s, &m);
    double u[16] = {0};
    CHECK_STATUS(pdmc_form_march(&m.form, &m.mass, m.at.space.count, NULL, 0.0, 1, 0.0, u), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_form_march(&m.form, &m.mass, m.at.space.count, NULL, 0.1, 0, 0.0, u), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_form_march(&m.form, &m.mass, m.at.space.count, NULL, 0.1, 1, 0.0, u), );
    moving_clear(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_largest_eigenvalue_of_classical_elements_is_known),
        cmocka_unit_test(central_differences_are_stable_up_to_the_step_of_the_largest_eigenvalue),
        cmocka_unit_test(waves_follow_the_analytic_dispersion),
        cmocka_unit_test(steps_that_cannot_be_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
