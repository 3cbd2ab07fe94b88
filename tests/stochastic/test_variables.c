// SPDX-License-Identifier: GPL-3.0-or-later

/// From (seed, sample) to the random quantities of a sample.

#include "pdmc/random.h"
#include "stochastic/toy.h"
#include "stochastic/variables.h"

#include <stdlib.h>

enum { QUANTITIES = 5, BINS = 3 };

/// The toy with several quantities, of which the first `count` are random, and a c(r) in three bins.
typedef struct {
    toy base;
    pdmc_uncertainty quantities[QUANTITIES];
    pdmc_correlation correlation;
    double weights[BINS], ring_weights[BINS];
} many;

static void many_make(many *m, int count)
{
    toy_make(&m->base, 0.0, 0.0);
    m->quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_LOGNORMAL, 0.1, 0.2);
    m->quantities[1] = toy_scalar(PDMC_QUANTITY_FRACTURE_ENERGY, PDMC_GUMBEL, 3.0, 0.4);
    m->quantities[2] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = BINS, .variation = 0.3};
    m->quantities[3] = toy_scalar(PDMC_QUANTITY_YOUNGS_MODULUS, PDMC_NORMAL, 1.5, 0.1);
    m->quantities[4] = toy_scalar(PDMC_QUANTITY_THICKNESS, PDMC_NORMAL, 2.0, 0.05);
    m->base.problem.uncertainties = m->quantities;
    m->base.problem.uncertainty_count = count;
    m->base.problem.sampling.replicates = 16;
    for (int b = 0; b < BINS; b++) m->weights[b] = m->ring_weights[b] = 1.0 / BINS;
    m->base.model.bins = BINS;
    m->base.model.term_weight = m->base.model.modulus_weight = m->weights;
    m->base.model.ring_weight = m->ring_weights;
}

static void correlate(many *m, pdmc_quantity first, pdmc_quantity second, double correlation)
{
    m->correlation = (pdmc_correlation){first, second, correlation};
    m->base.problem.correlations = &m->correlation;
    m->base.problem.correlation_count = 1;
}

static void open_variables(const many *m, pdmc_variables *variables, pdmc_draws *draws)
{
    CHECK_OK(pdmc_variables_create(&m->base.problem, &m->base.model, variables));
    CHECK_OK(pdmc_draws_create(variables, draws));
}

static void close_variables(pdmc_variables *variables, pdmc_draws *draws)
{
    pdmc_draws_clear(draws);
    pdmc_variables_clear(variables);
}

static const pdmc_draw *draw_one(const pdmc_variables *variables, pdmc_draws *draws, uint64_t sample)
{
    pdmc_variables_sample(variables, sample, draws->z);
    CHECK_OK(pdmc_variables_draw(variables, 1, draws->z, draws->draw));
    return &draws->draw[0];
}

static double value_of(const pdmc_draw *draw, pdmc_quantity quantity)
{
    return draw->value[quantity - PDMC_FIRST_SCALAR];
}

// Every quantity is the quantile of its own stream's number, whatever else is random.
static void a_quantity_more_leaves_the_others_as_they_are(void **state)
{
    (void)state;
    static const pdmc_stream streams[QUANTITIES] = {PDMC_STREAM_LOAD, PDMC_STREAM_FRACTURE_ENERGY,
                                                    PDMC_STREAM_MICROMODULUS, PDMC_STREAM_YOUNGS_MODULUS,
                                                    PDMC_STREAM_THICKNESS};
    for (int count = 1; count <= QUANTITIES; count++) {
        many m;
        pdmc_variables variables;
        pdmc_draws draws;
        many_make(&m, count);
        open_variables(&m, &variables, &draws);
        assert_int_equal(variables.count, count < 3 ? count : count - 1 + BINS);
        for (uint64_t sample = 0; sample < 5; sample++) {
            const pdmc_draw *draw = draw_one(&variables, &draws, sample);
            for (int q = 0; q < count; q++) {
                double u[BINS];
                pdmc_random_uniform(7, streams[q], sample, 0, BINS, u);
                const pdmc_uncertainty *quantity = &m.quantities[q];
                if (quantity->quantity == PDMC_QUANTITY_MICROMODULUS) {
                    for (int b = 0; b < BINS; b++)
                        CHECK_NEAR(draw->micromodulus[b], 1.0 + 0.3 * pdmc_normal_quantile(u[b]), 0.0);
                } else {
                    const double z = pdmc_normal_quantile(u[0]);
                    CHECK_NEAR(value_of(draw, quantity->quantity), pdmc_distribution_value(&quantity->law, z), 0.0);
                }
            }
        }
        close_variables(&variables, &draws);
    }
}

static void what_is_certain_has_its_nominal_value(void **state)
{
    (void)state;
    many m;
    pdmc_variables variables;
    pdmc_draws draws;
    many_make(&m, 1);
    m.base.problem.plate.thickness = 0.7;
    m.base.problem.material.youngs_modulus = 2.5;
    m.base.problem.material.fracture_energy = 0.4;
    open_variables(&m, &variables, &draws);
    const pdmc_draw *draw = draw_one(&variables, &draws, 3);
    CHECK_NEAR(value_of(draw, PDMC_QUANTITY_THICKNESS), 0.7, 0.0);
    CHECK_NEAR(value_of(draw, PDMC_QUANTITY_YOUNGS_MODULUS), 2.5, 0.0);
    CHECK_NEAR(draw->fracture_energy[0], 0.4, 0.0);
    for (int b = 0; b < BINS; b++) CHECK_NEAR(draw->micromodulus[b], 1.0, 0.0);
    CHECK_NEAR(draw->load_factor, value_of(draw, PDMC_QUANTITY_LOAD), 0.0);
    pdmc_draw_mean(&m.base.problem, &m.base.model, &draws.draw[1]);
    CHECK_NEAR(value_of(&draws.draw[1], PDMC_QUANTITY_LOAD), 1.0, 0.0);
    CHECK_NEAR(draws.draw[1].load_share, 1.0, 0.0);
    CHECK_NEAR(draws.draw[1].effective_modulus, 1.0, 0.0);
    CHECK_NEAR(draws.draw[1].xi[0], 0.0, 0.0);
    close_variables(&variables, &draws);
}

// The sample correlation of n pairs of normal variables has the deviation (1 - rho^2) / sqrt(n).
static void the_copula_correlates_what_is_drawn(void **state)
{
    (void)state;
    enum { SAMPLES = 40000 };
    const double rho = -0.6;
    many m;
    pdmc_variables variables;
    pdmc_draws draws;
    many_make(&m, QUANTITIES);
    correlate(&m, PDMC_QUANTITY_THICKNESS, PDMC_QUANTITY_LOAD, rho);
    open_variables(&m, &variables, &draws);
    double products = 0.0, squares[2] = {0.0, 0.0}, others = 0.0;
    for (uint64_t sample = 0; sample < SAMPLES; sample++) {
        const pdmc_draw *draw = draw_one(&variables, &draws, sample);
        const double load = (log(value_of(draw, PDMC_QUANTITY_LOAD)) - 0.1) / 0.2;
        const double thickness = (value_of(draw, PDMC_QUANTITY_THICKNESS) - 2.0) / 0.05;
        products += load * thickness;
        squares[0] += load * load;
        squares[1] += thickness * thickness;
        others += thickness * (value_of(draw, PDMC_QUANTITY_YOUNGS_MODULUS) - 1.5) / 0.1;
    }
    CHECK_NEAR(products / sqrt(squares[0] * squares[1]), rho, 4.0 * (1.0 - rho * rho) / sqrt(SAMPLES));
    for (int k = 0; k < 2; k++) CHECK_NEAR(squares[k] / SAMPLES, 1.0, 4.0 * sqrt(2.0 / SAMPLES));
    CHECK_NEAR(others / SAMPLES, 0.0, 4.0 / sqrt(SAMPLES));
    close_variables(&variables, &draws);
}

static void correlations_that_contradict_each_other_are_refused(void **state)
{
    (void)state;
    many m;
    pdmc_variables variables;
    pdmc_correlation three[] = {{PDMC_QUANTITY_LOAD, PDMC_QUANTITY_THICKNESS, 0.9},
                                {PDMC_QUANTITY_LOAD, PDMC_QUANTITY_YOUNGS_MODULUS, 0.9},
                                {PDMC_QUANTITY_THICKNESS, PDMC_QUANTITY_YOUNGS_MODULUS, -0.9}};
    many_make(&m, QUANTITIES);
    m.base.problem.correlations = three;
    m.base.problem.correlation_count = 3;
    CHECK_STATUS(pdmc_variables_create(&m.base.problem, &m.base.model, &variables), PDMC_ERR_ARG);
    assert_null(variables.design);
}

static int ascending(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

// In each replicate of a Latin hypercube every variable has one sample in each of its equally likely intervals; what lies
// beyond the design's samples is drawn by the streams.
static void a_design_fills_the_variables(void **state)
{
    (void)state;
    enum { SAMPLES = 160, REPLICATES = 16, EACH = SAMPLES / REPLICATES };
    many m, plain;
    pdmc_variables variables, streams;
    pdmc_draws draws;
    double z[QUANTITIES + BINS], other[QUANTITIES + BINS];
    many_make(&m, QUANTITIES);
    many_make(&plain, QUANTITIES);
    m.base.problem.sampling.samples = SAMPLES;
    m.base.problem.sampling.design = PDMC_DESIGN_LATIN_HYPERCUBE;
    open_variables(&m, &variables, &draws);
    CHECK_OK(pdmc_variables_create(&plain.base.problem, &plain.base.model, &streams));
    for (int v = 0; v < variables.count; v++)
        for (uint64_t r = 0; r < REPLICATES; r++) {
            int place[EACH];
            for (uint64_t i = 0; i < EACH; i++) {
                pdmc_variables_sample(&variables, i * REPLICATES + r, z);
                place[i] = (int)(EACH * 0.5 * erfc(-z[v] / sqrt(2.0)));
            }
            qsort(place, EACH, sizeof *place, ascending);
            for (int i = 0; i < EACH; i++) assert_int_equal(place[i], i);
        }
    for (uint64_t sample = SAMPLES; sample < SAMPLES + 3; sample++) {
        pdmc_variables_sample(&variables, sample, z);
        pdmc_variables_sample(&streams, sample, other);
        assert_memory_equal(z, other, (size_t)variables.count * sizeof *z);
    }
    close_variables(&variables, &draws);
    pdmc_variables_clear(&streams);
}

static bool has_lone_load(const many *m)
{
    pdmc_variables variables;
    CHECK_OK(pdmc_variables_create(&m->base.problem, &m->base.model, &variables));
    const pdmc_distribution *law = pdmc_variables_lone_load(&variables);
    assert_true(!law || law == &m->quantities[0].law);
    pdmc_variables_clear(&variables);
    return law;
}

static void a_load_is_integrated_where_it_is_alone_and_positive(void **state)
{
    (void)state;
    many m;
    many_make(&m, QUANTITIES);
    assert_true(has_lone_load(&m));
    correlate(&m, PDMC_QUANTITY_THICKNESS, PDMC_QUANTITY_YOUNGS_MODULUS, 0.5);
    assert_true(has_lone_load(&m));
    correlate(&m, PDMC_QUANTITY_THICKNESS, PDMC_QUANTITY_LOAD, 0.5);
    assert_false(has_lone_load(&m));
    many_make(&m, QUANTITIES);
    m.quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_NORMAL, 1.0, 0.2); // negative in one of 3.5 million
    assert_false(has_lone_load(&m));
    m.quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_NORMAL, 1.0, 0.1);
    assert_true(has_lone_load(&m));
    pdmc_support moved = {PDMC_SIDE_LEFT, {true, false}, {0.1, 0.0}};
    m.base.problem.supports = &moved;
    m.base.problem.support_count = 1;
    assert_false(has_lone_load(&m));
    many_make(&m, QUANTITIES);
    m.quantities[0] = toy_scalar(PDMC_QUANTITY_YOUNGS_MODULUS, PDMC_NORMAL, 1.0, 0.1);
    m.base.problem.uncertainty_count = 1;
    assert_false(has_lone_load(&m));
}

// c(r) is linear in the variables of a radial process; with as many modes as bins its covariance is that of the bins'
// middles, exp(-|r - r'| / l), and with fewer it has that many variables.
static void a_radial_process_is_correlated_over_the_radius(void **state)
{
    (void)state;
    const double horizon = 1.2, length = 0.5, variation = 0.3;
    many m;
    pdmc_variables variables;
    pdmc_draws draws;
    double columns[BINS][BINS];
    many_make(&m, 3);
    m.base.problem.solver.horizon = horizon;
    m.quantities[2].model = PDMC_RADIAL_PROCESS;
    m.quantities[2].covariance = (pdmc_covariance){.kind = PDMC_COVARIANCE_EXPONENTIAL, .length = length};
    m.quantities[2].modes = 50;
    open_variables(&m, &variables, &draws);
    assert_int_equal(variables.count, 2 + BINS);
    for (int k = 0; k < BINS; k++) {
        double z[2 + BINS] = {0};
        z[pdmc_variables_group(&variables, PDMC_QUANTITY_MICROMODULUS)->first + k] = 1.0;
        CHECK_OK(pdmc_variables_draw(&variables, 1, z, draws.draw));
        for (int b = 0; b < BINS; b++) columns[k][b] = (draws.draw[0].micromodulus[b] - 1.0) / variation;
    }
    for (int b = 0; b < BINS; b++)
        for (int c = 0; c < BINS; c++) {
            double covariance = 0.0;
            for (int k = 0; k < BINS; k++) covariance += columns[k][b] * columns[k][c];
            CHECK_NEAR(covariance, exp(-abs(b - c) * horizon / BINS / length), 1e-13);
        }
    close_variables(&variables, &draws);
    m.quantities[2].modes = 2;
    open_variables(&m, &variables, &draws);
    assert_int_equal(variables.count, 2 + 2);
    close_variables(&variables, &draws);
}

static pdmc_status open_and_close(const many *m)
{
    pdmc_variables variables;
    pdmc_draws draws = {0};
    pdmc_status status = pdmc_variables_create(&m->base.problem, &m->base.model, &variables);
    if (status == PDMC_OK) status = pdmc_draws_create(&variables, &draws);
    close_variables(&variables, &draws);
    return status;
}

static void memory_that_is_missing_is_reported(void **state)
{
    (void)state;
    many m;
    many_make(&m, QUANTITIES);
    m.base.problem.sampling.samples = 160;
    m.base.problem.sampling.design = PDMC_DESIGN_LATIN_HYPERCUBE;
    m.base.problem.solver.horizon = 1.0;
    m.quantities[2].model = PDMC_RADIAL_PROCESS;
    m.quantities[2].covariance = (pdmc_covariance){.kind = PDMC_COVARIANCE_EXPONENTIAL, .length = 1.0};
    m.quantities[2].modes = BINS;
    CHECK_FAILS_CLEANLY(open_and_close(&m), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_quantity_more_leaves_the_others_as_they_are),
        cmocka_unit_test(what_is_certain_has_its_nominal_value),
        cmocka_unit_test(the_copula_correlates_what_is_drawn),
        cmocka_unit_test(correlations_that_contradict_each_other_are_refused),
        cmocka_unit_test(a_design_fills_the_variables),
        cmocka_unit_test(a_load_is_integrated_where_it_is_alone_and_positive),
        cmocka_unit_test(a_radial_process_is_correlated_over_the_radius),
        cmocka_unit_test(memory_that_is_missing_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
