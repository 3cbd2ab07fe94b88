// SPDX-License-Identifier: GPL-3.0-or-later

/// A fracture energy that varies in space: what the tips see of it, and what growth of any of them then is.

#include "stochastic/controlled.h"
#include "stochastic/growth.h"
#include "stochastic/toughness.h"
#include "stochastic/two_tips.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_randist.h>

static const double load_deviation = 0.1, toughness_deviation = 0.15; // of the logarithms
static const double median_toughness = 1.5;

/// Both tips have G = S^2, S lognormal; the fracture energy is lognormal, or another, with a covariance of the distance 1.
typedef struct {
    two_tips base;
    pdmc_uncertainty quantities[4];
    pdmc_correlation correlation;
} tough_tips;

static void tough_tips_make(tough_tips *t, double correlation_length)
{
    two_tips_make(&t->base);
    t->quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_LOGNORMAL, 0.0, load_deviation);
    t->quantities[1] =
        toy_scalar(PDMC_QUANTITY_FRACTURE_ENERGY, PDMC_LOGNORMAL, log(median_toughness), toughness_deviation);
    t->quantities[1].has_length = correlation_length > 0.0;
    t->quantities[1].covariance.length = correlation_length;
    t->quantities[2] = toy_scalar(PDMC_QUANTITY_YOUNGS_MODULUS, PDMC_LOGNORMAL, 0.0, 0.1);
    t->base.base.problem.uncertainties = t->quantities;
    t->base.base.problem.uncertainty_count = 2;
}

static pdmc_problem *problem_of(tough_tips *t)
{
    return &t->base.base.problem;
}

// The factor's square is the covariance of the distances, less 1e-12 for each of three tips.
static void the_factor_has_the_kernel_of_the_distances(void **state)
{
    (void)state;
    const double length = 0.7, x[3][2] = {{-0.5, 0.0}, {0.5, 0.0}, {0.3, 1.1}}, none[PDMC_SCALARS] = {0.0};
    double factor[9];
    pdmc_crack cracks[2] = {{"a", {-0.5, 0.0}, {0.5, 0.0}}, {"b", {0.3, 1.1}, {2.0, 2.0}}};
    int tips[3] = {0, 1, 2};
    tough_tips t;
    for (int kind = 0; kind < 3; kind++) {
        tough_tips_make(&t, length);
        t.quantities[1].covariance.kind = (pdmc_covariance_kind)kind;
        t.quantities[1].covariance.smoothness = 1.5;
        problem_of(&t)->cracks = cracks;
        problem_of(&t)->crack_count = 2;
        problem_of(&t)->energy.tips = tips;
        problem_of(&t)->energy.tip_count = 3;
        CHECK_OK(pdmc_toughness_factor(problem_of(&t), none, factor));
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const double r = hypot(x[i][0] - x[j][0], x[i][1] - x[j][1]), s = sqrt(3.0) * r / length;
                const double kernels[3] = {exp(-r / length), exp(-r * r / (length * length)), (1.0 + s) * exp(-s)};
                double product = 0.0;
                for (int k = 0; k < 3; k++) product += factor[3 * i + k] * factor[3 * j + k];
                CHECK_NEAR(product, kernels[kind], 4e-12);
                if (j > i) assert_true(factor[3 * i + j] == 0.0);
            }
    }
}

// Tips that are close to nothing apart: the matrix is singular to rounding.
static void tips_at_one_place_have_one_value(void **state)
{
    (void)state;
    const double none[PDMC_SCALARS] = {0.0};
    double factor[4];
    tough_tips t;
    tough_tips_make(&t, 1e9);
    t.quantities[1].covariance.kind = PDMC_COVARIANCE_GAUSSIAN;
    CHECK_OK(pdmc_toughness_factor(problem_of(&t), none, factor));
    CHECK_NEAR(factor[0], 1.0, 0.0);
    CHECK_NEAR(factor[2], 1.0, 3e-12);
    CHECK_NEAR(factor[3], 0.0, 3e-6); // the root of what correlations are lowered by, twice
}

// The normal variable behind a lognormal fracture energy.
static double normal_of(double toughness)
{
    return log(toughness / median_toughness) / toughness_deviation;
}

// The distance that counts is that of the sample's own cracks.
static void cracks_that_move_have_their_own_distance(void **state)
{
    (void)state;
    const double length = 0.8, z[4] = {0.3, -0.7, 1.1, 0.9};
    tough_tips t;
    pdmc_variables variables;
    pdmc_draws draws;
    tough_tips_make(&t, length);
    t.quantities[2] = toy_scalar(PDMC_QUANTITY_CRACK_LENGTH, PDMC_NORMAL, 1.0, 0.2);
    problem_of(&t)->uncertainty_count = 3;
    CHECK_OK(pdmc_variables_create(problem_of(&t), &t.base.base.model, &variables));
    CHECK_OK(pdmc_draws_create(&variables, &draws));
    assert_int_equal(variables.count, 4);
    CHECK_OK(pdmc_variables_draw(&variables, 1, z, draws.draw));
    const double kernel = exp(-(1.0 + 0.2 * z[3]) / length);
    CHECK_NEAR(normal_of(draws.draw[0].fracture_energy[0]), z[1], 1e-13);
    CHECK_NEAR(normal_of(draws.draw[0].fracture_energy[1]), kernel * z[1] + sqrt(1.0 - kernel * kernel) * z[2], 1e-11);
    pdmc_draws_clear(&draws);
    pdmc_variables_clear(&variables);
}

// What log E shares with the fracture energy, 0.6, it shares with that of both tips, which have 0.36 + 0.64 kernel in common;
// the load has nothing. Covariances of 1 = rho^2 by the coefficients of the variables, to rounding.
static void a_modulus_may_depend_on_the_whole_field(void **state)
{
    (void)state;
    enum { VARIABLES = 4 };
    const double length = 0.8, rho = 0.6, kernel = exp(-1.0 / length);
    double row[4][VARIABLES]; // of load, E, and the fracture energy of either tip
    tough_tips t;
    pdmc_variables variables;
    pdmc_draws draws;
    tough_tips_make(&t, length);
    problem_of(&t)->uncertainty_count = 3;
    t.correlation = (pdmc_correlation){PDMC_QUANTITY_FRACTURE_ENERGY, PDMC_QUANTITY_YOUNGS_MODULUS, rho};
    problem_of(&t)->correlations = &t.correlation;
    problem_of(&t)->correlation_count = 1;
    CHECK_OK(pdmc_variables_create(problem_of(&t), &t.base.base.model, &variables));
    CHECK_OK(pdmc_draws_create(&variables, &draws));
    assert_int_equal(variables.count, VARIABLES);
    for (int k = 0; k < VARIABLES; k++) {
        double z[VARIABLES] = {0.0};
        z[k] = 1.0;
        CHECK_OK(pdmc_variables_draw(&variables, 1, z, draws.draw));
        row[0][k] = log(draws.draw[0].value[PDMC_QUANTITY_LOAD - PDMC_FIRST_SCALAR]) / load_deviation;
        row[1][k] = log(draws.draw[0].value[PDMC_QUANTITY_YOUNGS_MODULUS - PDMC_FIRST_SCALAR]) / 0.1;
        for (int tip = 0; tip < 2; tip++) row[2 + tip][k] = normal_of(draws.draw[0].fracture_energy[tip]);
    }
    const double shared = rho * rho + (1.0 - rho * rho) * kernel;
    const double want[4][4] = {{1, 0, 0, 0}, {0, 1, rho, rho}, {0, rho, 1, shared}, {0, rho, shared, 1}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            double covariance = 0.0;
            for (int k = 0; k < VARIABLES; k++) covariance += row[i][k] * row[j][k];
            CHECK_NEAR(covariance, want[i][j], 1e-11);
        }
    pdmc_draws_clear(&draws);
    pdmc_variables_clear(&variables);
}

// Kolmogorov's distance of n values from their distribution is above 1.95 / sqrt(n) once in a thousand.
static void check_law(const pdmc_distribution *law, size_t n, const double x[])
{
    double worst = 0.0;
    for (size_t i = 0; i < n; i++) {
        size_t below = 0;
        for (size_t j = 0; j < n; j++) below += x[j] <= x[i];
        const double p = pdmc_distribution_lower_tail(law, x[i]);
        worst = fmax(worst, fmax(fabs(p - (double)below / (double)n), fabs(p - ((double)below - 1.0) / (double)n)));
    }
    CHECK_NEAR(worst, 0.0, 1.95 / sqrt((double)n));
}

// Whatever the distribution, both tips have it, and the normal variables behind them the kernel's correlation, whose estimate
// has the deviation (1 - rho^2) / sqrt(n).
static void every_tip_has_the_law_and_both_the_correlation(void **state)
{
    (void)state;
    enum { SAMPLES = 2000 };
    const double length = 1.5, rho = exp(-1.0 / length);
    const pdmc_distribution laws[] = {
        {PDMC_WEIBULL, .scale = 2.0, .shape = 4.0, .least = -INFINITY, .most = INFINITY},
        {PDMC_GUMBEL, .location = 3.0, .scale = 0.4, .least = -INFINITY, .most = INFINITY},
        {PDMC_UNIFORM, .lower = 1.0, .upper = 2.0, .least = -INFINITY, .most = INFINITY},
        {PDMC_NORMAL, .location = 3.0, .scale = 0.5, .least = 2.5, .most = INFINITY},
    };
    for (size_t k = 0; k < sizeof laws / sizeof laws[0]; k++) {
        double toughness[2][SAMPLES], products = 0.0, squares[2] = {0.0, 0.0};
        tough_tips t;
        pdmc_results r;
        tough_tips_make(&t, length);
        t.quantities[1].law = laws[k];
        problem_of(&t)->sampling.samples = SAMPLES;
        CHECK_OK(toy_run(&t.base.base, &one_thread, &r));
        for (int s = 0; s < SAMPLES; s++) {
            double z[2];
            for (int tip = 0; tip < 2; tip++) {
                toughness[tip][s] = r.sample_fracture_energy[2 * s + tip];
                z[tip] = gsl_cdf_ugaussian_Pinv(pdmc_distribution_lower_tail(&laws[k], toughness[tip][s]));
                squares[tip] += z[tip] * z[tip];
            }
            products += z[0] * z[1];
        }
        for (int tip = 0; tip < 2; tip++) check_law(&laws[k], SAMPLES, toughness[tip]);
        CHECK_NEAR(products / sqrt(squares[0] * squares[1]), rho, 4.0 * (1.0 - rho * rho) / sqrt(SAMPLES));
        pdmc_results_clear(&r);
    }
}

// Without a length both tips have the same fracture energy, the first of the field; a field that hardly varies comes to it, by
// the root of what correlations are lowered by.
static void full_correlation_is_one_fracture_energy(void **state)
{
    (void)state;
    tough_tips t;
    pdmc_results scalar, field, wide;
    tough_tips_make(&t, 0.0);
    CHECK_OK(toy_run(&t.base.base, &one_thread, &scalar));
    tough_tips_make(&t, 0.5);
    CHECK_OK(toy_run(&t.base.base, &one_thread, &field));
    tough_tips_make(&t, 1e13);
    CHECK_OK(toy_run(&t.base.base, &one_thread, &wide));
    for (int s = 0; s < scalar.sample_count; s++) {
        const double *one = &scalar.sample_fracture_energy[2 * s], *own = &field.sample_fracture_energy[2 * s];
        assert_true(one[0] == one[1] && own[0] == one[0] && fabs(normal_of(own[1]) - normal_of(one[1])) > 1e-4);
        CHECK_NEAR(normal_of(wide.sample_fracture_energy[2 * s + 1]), normal_of(one[1]), 3e-6 * 4.0); // |z| < 4
    }
    pdmc_results_clear(&scalar);
    pdmc_results_clear(&field);
    pdmc_results_clear(&wide);
}

typedef struct {
    double index, correlation;
} pair;

// Of the density of one to exceed the index, given which the other does.
static double both_density(double x, void *parameters)
{
    const pair *p = parameters;
    return gsl_ran_ugaussian_pdf(x) *
           gsl_cdf_ugaussian_Q((p->index - p->correlation * x) / sqrt(1.0 - p->correlation * p->correlation));
}

// Log G / G_c of the tips are normal, with the deviation hypot(2 s_S, s_c) and the covariance 4 s_S^2 + rho s_c^2.
static double probability_of_either(double rho)
{
    const double of_load = 4.0 * load_deviation * load_deviation, of_law = toughness_deviation * toughness_deviation;
    pair p = {log(median_toughness) / sqrt(of_load + of_law), (of_load + rho * of_law) / (of_load + of_law)};
    double both, error;
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(100);
    const int failed =
        gsl_integration_qagiu(&(gsl_function){both_density, &p}, p.index, 1e-14, 1e-9, 100, workspace, &both, &error);
    gsl_integration_workspace_free(workspace);
    assert_int_equal(failed, 0);
    return 2.0 * gsl_cdf_ugaussian_Q(p.index) - both;
}

static bool tip_grows(const pdmc_results *r, int sample, int tip)
{
    return r->largest_energy[PDMC_MEASURE_GRIFFITH][2 * sample + tip] > r->sample_fracture_energy[2 * sample + tip];
}

static double share_of_growth(const pdmc_results *r)
{
    int hits = 0;
    for (int s = 0; s < r->sample_count; s++) hits += tip_grows(r, s, 0) || tip_grows(r, s, 1);
    return (double)hits / r->sample_count;
}

// Growth of any tip against the probability of a bivariate normal vector: samples, importance sampling, and subset simulation.
static void growth_of_any_tip_is_bivariate_normal(void **state)
{
    (void)state;
    enum { SAMPLES = 40000 };
    const double lengths[] = {0.2, 1.5, 0.0};
    for (int k = 0; k < 3; k++) {
        tough_tips t;
        pdmc_results r;
        tough_tips_make(&t, lengths[k]);
        problem_of(&t)->sampling.samples = SAMPLES;
        problem_of(&t)->reliability = (pdmc_reliability_request){PDMC_RARE_BOTH, 0.03, 1000000, 0};
        CHECK_OK(toy_run(&t.base.base, &one_thread, &r));
        const double rho = lengths[k] > 0.0 ? exp(-1.0 / lengths[k]) : 1.0 - 1e-12;
        const double exact = probability_of_either(rho), share = share_of_growth(&r);
        print_message("correlation %.3f: exact %.5f, counted %.5f", rho, exact, share);
        CHECK_NEAR(share, exact, 4.0 * sqrt(exact / SAMPLES));
        for (int m = 0; m < 2; m++) {
            const pdmc_reliability *found = &r.reliability.records[m].found;
            print_message(", %.5f [%.5f, %.5f]", found->probability.value, found->probability.lower,
                          found->probability.upper);
            CHECK_NEAR(found->probability.value, exact, 4.0 * found->variation * exact);
        }
        print_message("\n");
        assert_int_equal(r.reliability.groups[1].variables, lengths[k] > 0.0 ? 2 : 1);
        pdmc_results_clear(&r);
    }
}

// The share of each tip's own growth; with more samples of the same method as control, which knows every event, theirs.
static void each_tip_has_its_probability(void **state)
{
    (void)state;
    enum { OWN = 500, MORE = 2000 };
    tough_tips t;
    pdmc_results r, more;
    tough_tips_make(&t, 0.5);
    problem_of(&t)->sampling.samples = OWN;
    CHECK_OK(toy_run(&t.base.base, &one_thread, &r));
    problem_of(&t)->sampling.samples = MORE;
    CHECK_OK(toy_run(&t.base.base, &one_thread, &more));
    CHECK_OK(pdmc_control_samples(&more, NULL, &r));
    for (int tip = 0; tip < 2; tip++) {
        int hits[2] = {0};
        for (int s = 0; s < MORE; s++) {
            hits[0] += s < OWN && tip_grows(&more, s, tip);
            hits[1] += tip_grows(&more, s, tip);
        }
        CHECK_NEAR(r.probability[tip].value, (double)hits[0] / OWN, 1e-15);
        CHECK_NEAR(r.control.probability[tip].value, (double)hits[1] / MORE, 1e-15);
    }
    assert_true(r.probability[0].value != r.probability[1].value);
    pdmc_results_clear(&r);
    pdmc_results_clear(&more);
}

// At every point the largest of the tips' log G / G_c, by their own fracture energies, and of one tip its own; the probability
// given all but the load too.
static void each_tip_grows_by_its_own_fracture_energy(void **state)
{
    (void)state;
    enum { COUNT = 70, VARIABLES = 3 };
    const double kernel = exp(-1.0 / 0.6);
    tough_tips t;
    pdmc_variables variables;
    pdmc_growth growth;
    pdmc_results r;
    double z[COUNT * VARIABLES], g[3][COUNT];
    tough_tips_make(&t, 0.6);
    CHECK_OK(toy_run(&t.base.base, &one_thread, &r));
    CHECK_OK(pdmc_variables_create(problem_of(&t), &t.base.base.model, &variables));
    CHECK_OK(pdmc_growth_create(&variables, &t.base.base.model, &t.base.base.model, &one_thread, &r, &growth));
    const pdmc_limit_state limit = pdmc_growth_limit(&growth);
    assert_int_equal(limit.dimension, VARIABLES);
    for (int k = 0; k < COUNT * VARIABLES; k++) z[k] = 2.0 * sin(k);
    for (growth.tip = -1; growth.tip < 2; growth.tip++)
        CHECK_OK(limit.evaluate(limit.context, COUNT, z, g[1 + growth.tip]));
    for (int k = 0; k < COUNT; k++) {
        const double *w = &z[VARIABLES * k + 1];
        const double behind[2] = {w[0], kernel * w[0] + sqrt(1.0 - kernel * kernel) * w[1]};
        double margin[2];
        for (int tip = 0; tip < 2; tip++) {
            margin[tip] = 2.0 * load_deviation * w[-1] - log(median_toughness) - toughness_deviation * behind[tip];
            CHECK_NEAR(g[1 + tip][k], margin[tip], 1e-12);
        }
        CHECK_NEAR(g[0][k], fmax(margin[0], margin[1]), 1e-12);
    }
    for (int k = 0; k < 2 * r.sample_count; k++)
        CHECK_NEAR(r.growth_given_rest[k], gsl_cdf_ugaussian_Q(0.5 * log(r.sample_fracture_energy[k]) / load_deviation),
                   1e-12);
    pdmc_growth_clear(&growth);
    pdmc_variables_clear(&variables);
    pdmc_results_clear(&r);
}

static pdmc_status draw_and_clear(tough_tips *t)
{
    const double z[4] = {0.0};
    pdmc_variables variables;
    pdmc_draws draws = {0};
    pdmc_status status = pdmc_variables_create(problem_of(t), &t->base.base.model, &variables);
    if (status == PDMC_OK) status = pdmc_draws_create(&variables, &draws);
    if (status == PDMC_OK) status = pdmc_variables_draw(&variables, 1, z, draws.draw);
    pdmc_draws_clear(&draws);
    pdmc_variables_clear(&variables);
    return status;
}

static void memory_that_is_missing_is_reported(void **state)
{
    (void)state;
    tough_tips t;
    tough_tips_make(&t, 1.0);
    CHECK_FAILS_CLEANLY(draw_and_clear(&t), (void)0);
    t.quantities[2] = toy_scalar(PDMC_QUANTITY_CRACK_LENGTH, PDMC_NORMAL, 1.0, 0.2);
    problem_of(&t)->uncertainty_count = 3;
    CHECK_FAILS_CLEANLY(draw_and_clear(&t), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_factor_has_the_kernel_of_the_distances),
        cmocka_unit_test(tips_at_one_place_have_one_value),
        cmocka_unit_test(cracks_that_move_have_their_own_distance),
        cmocka_unit_test(a_modulus_may_depend_on_the_whole_field),
        cmocka_unit_test(every_tip_has_the_law_and_both_the_correlation),
        cmocka_unit_test(full_correlation_is_one_fracture_energy),
        cmocka_unit_test(growth_of_any_tip_is_bivariate_normal),
        cmocka_unit_test(each_tip_has_its_probability),
        cmocka_unit_test(each_tip_grows_by_its_own_fracture_energy),
        cmocka_unit_test(memory_that_is_missing_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
