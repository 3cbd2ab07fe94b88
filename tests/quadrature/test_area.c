// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "check.h"

#include <complex.h>
#include <gsl/gsl_integration.h>

static const double pi = 3.14159265358979323846;

static const double cracks[12] = {-0.5, 0.0, 0.5, 0.0, 0.9, -0.8, 1.3, 0.4, -1.2, 1.1, -0.4, 1.6};

static double integrate(const pdmc_area_rule *rule, double (*f)(const double x[2]))
{
    double sum = 0.0;
    for (int i = 0; i < rule->count; i++) sum += rule->weight[i] * f(&rule->x[2 * i]);
    return sum;
}

static double one(const double x[2])
{
    (void)x;
    return 1.0;
}

static double polynomial(const double x[2])
{
    return x[0] * x[0] * x[0] * x[0] * x[1] * x[1];
}

static double left_of_second(const double x[2])
{
    return (cracks[6] - cracks[4]) * (x[1] - cracks[5]) - (cracks[7] - cracks[5]) * (x[0] - cracks[4]);
}

// No cell lies on both sides of a crack.
static void cells_end_at_the_cracks(void **state)
{
    (void)state;
    pdmc_area_rule rule;
    for (int n = 0; n <= 3; n++) {
        CHECK_OK(pdmc_area_rule_create(4.0, 5.0, n, cracks, 0.5, &rule));
        CHECK_NEAR(integrate(&rule, one), 20.0, 1e-11);
        CHECK_NEAR(integrate(&rule, polynomial), (2 * 32.0 / 5.0) * (2 * 15.625 / 3.0), 1e-8);
        for (int i = 0; i < rule.count; i++) assert_true(rule.weight[i] > 0.0);
        pdmc_area_rule_clear(&rule);
    }
    // the jump of a crack field: sign(y) sqrt(a^2 - x^2) near the first crack is held exactly on either side
    CHECK_OK(pdmc_area_rule_create(4.0, 5.0, 1, &cracks[4], 0.5, &rule));
    double jump = 0.0;
    const double d[2] = {cracks[6] - cracks[4], cracks[7] - cracks[5]}, l2 = d[0] * d[0] + d[1] * d[1];
    for (int i = 0; i < rule.count; i++) {
        const double *x = &rule.x[2 * i];
        const double t = ((x[0] - cracks[4]) * d[0] + (x[1] - cracks[5]) * d[1]) / l2;
        const double away = left_of_second(x) / sqrt(l2);
        if (t > 0.0 && t < 1.0 && fabs(away) < 0.2) jump += rule.weight[i] * (away > 0 ? 1.0 : 0.0);
    }
    CHECK_NEAR(jump, 0.2 * sqrt(l2), 0.03); // a strip whose outer edge cuts through triangles
    pdmc_area_rule_clear(&rule);
}

// |z / sqrt(z^2 - a^2)|^2, the energy of a crack's field, over the plate: by the rule, and in confocal coordinates
// z = a cosh(mu + i eta) where it is |cosh|^2 a^2 and the plate's edge is at mu(eta).
static double energy(const double x[2])
{
    const double complex z = CMPLX(x[0], x[1]);
    return pow(cabs(z), 2) / cabs(z * z - 0.25);
}

static double edge_energy(double eta, void *context)
{
    (void)context;
    const double a = 0.5; // the largest mu inside |x| <= 2, |y| <= 2.5
    const double to_x = fabs(cos(eta)) > 1e-12 ? acosh(fmax(1.0, 2.0 / (a * fabs(cos(eta))))) : INFINITY;
    const double to_y = fabs(sin(eta)) > 1e-12 ? asinh(2.5 / (a * fabs(sin(eta)))) : INFINITY;
    const double mu = fmin(to_x, to_y);
    return a * a * (0.25 * sinh(2.0 * mu) + 0.5 * mu * cos(2.0 * eta)); // int |cosh(mu + i eta)|^2 dmu
}

static void the_energy_at_a_tip_is_integrated(void **state)
{
    (void)state;
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(1000);
    const gsl_function f = {edge_energy, NULL};
    double exact, error;
    const double corner = atan2(2.5, 2.0); // a kink of the edge lies somewhere near; adaptive integration finds it
    double quarter[2];
    gsl_integration_qags(&f, 0.0, corner, 0.0, 1e-11, 1000, work, &quarter[0], &error);
    gsl_integration_qags(&f, corner, 0.5 * pi, 0.0, 1e-11, 1000, work, &quarter[1], &error);
    exact = 4.0 * (quarter[0] + quarter[1]);
    gsl_integration_workspace_free(work);
    const double bound[2] = {1e-6, 5e-7}; // four points in the angle; smaller triangles elsewhere hardly help
    for (int k = 0; k < 2; k++) {
        pdmc_area_rule rule;
        CHECK_OK(pdmc_area_rule_create(4.0, 5.0, 1, cracks, k ? 0.4 : 1.0, &rule));
        const double off = fabs(integrate(&rule, energy) / exact - 1.0);
        printf("  energy of a crack's field by %d points: off by %.1e\n", rule.count, off);
        assert_true(off < bound[k]);
        pdmc_area_rule_clear(&rule);
    }
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    pdmc_area_rule rule;
    CHECK_STATUS(pdmc_area_rule_create(0.0, 1.0, 0, NULL, 0.1, &rule), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_area_rule_create(1.0, 1.0, 0, NULL, 0.0, &rule), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_area_rule_create(4.0, 5.0, 2, cracks, 2.0, &rule), pdmc_area_rule_clear(&rule));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_end_at_the_cracks),
        cmocka_unit_test(the_energy_at_a_tip_is_integrated),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
