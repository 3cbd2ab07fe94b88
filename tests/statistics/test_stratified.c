// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

/// x and c are above thresholds in normal variables with a correlation: their four probabilities.
typedef struct {
    double both, only_x, only_c, neither;
} cells;

static cells cells_of(double x, double c, double agreement)
{
    const double both = agreement * fmin(x, c) + (1.0 - agreement) * x * c;
    return (cells){both, x - both, c - both, 1.0 - x - c + both};
}

static void draw_counts(gsl_rng *rng, const cells *p, unsigned n, unsigned count[4])
{
    const double probability[4] = {p->both, p->only_x, p->only_c, p->neither};
    gsl_ran_multinomial(rng, 4, n, probability, count);
}

typedef struct {
    double coverage, mean, error,
        narrower; // share held, mean and error of value / P, mean width over that of the plain
} outcome;

static outcome repeat(gsl_rng *rng, double x, double c, double agreement, unsigned n, unsigned more, int repetitions)
{
    const cells p = cells_of(x, c, agreement);
    outcome found = {0};
    double squares = 0.0;
    for (int r = 0; r < repetitions; r++) {
        unsigned first[4], rest[4];
        draw_counts(rng, &p, n, first);
        draw_counts(rng, &p, more - n, rest);
        const size_t hits[2] = {first[1], first[0]}, trials[2] = {first[1] + first[3], first[0] + first[2]};
        const size_t known = trials[1] + rest[0] + rest[2];
        const pdmc_estimate got = pdmc_statistics_stratified_proportion(hits, trials, known, more, 0.95);
        const pdmc_estimate plain = pdmc_statistics_proportion(hits[0] + hits[1], n, 0.95);
        assert_true(got.lower <= got.value && got.value <= got.upper && got.lower >= 0.0 && got.upper <= 1.0);
        found.coverage += (got.lower <= x && x <= got.upper) / (double)repetitions;
        found.mean += got.value / x / repetitions;
        found.narrower += (got.upper - got.lower) / (plain.upper - plain.lower) / repetitions;
        squares += pow(got.value / x, 2) / repetitions;
    }
    found.error = sqrt((squares - found.mean * found.mean) / repetitions);
    return found;
}

/// Of rare and of frequent events, controls that agree always, mostly and not at all, and that are biased. The estimate is a
/// ratio: its bias is of the order of 1 / n.
static void intervals_hold_and_are_narrower(void **state)
{
    (void)state;
    enum { REPETITIONS = 1000, SAMPLES = 400, MORE = 20000 };
    static const struct {
        double x, c, agreement, narrower;
    } cases[] = {{0.3, 0.3, 0.95, 0.5},   {0.1, 0.13, 0.9, 0.75}, {0.1, 0.1, 1.0, 0.35}, {0.03, 0.02, 0.9, 1.0},
                 {0.01, 0.01, 0.95, 1.1}, {0.5, 0.5, 0.0, 1.2},   {0.97, 0.95, 0.9, 0.9}};
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const outcome got = repeat(rng, cases[k].x, cases[k].c, cases[k].agreement, SAMPLES, MORE, REPETITIONS);
        print_message("P = %g, control %g, agreement %g: held %.3f, mean %.4f +- %.4f, width %.2f\n", cases[k].x,
                      cases[k].c, cases[k].agreement, got.coverage, got.mean, got.error, got.narrower);
        assert_true(got.coverage >= 0.95 - repetition_error(0.95, REPETITIONS));
        CHECK_NEAR(got.mean, 1.0, 4.0 * got.error + 2.0 / SAMPLES);
        assert_true(got.narrower < cases[k].narrower);
    }
    gsl_rng_free(rng);
}

/// With w = 1/4, p_1 = 1/2 and p_0 = 1/10 the value is 0.2; each bound moves by its part alone.
static void shares_are_weighed(void **state)
{
    (void)state;
    const size_t hits[2] = {8, 10}, trials[2] = {80, 20};
    const pdmc_estimate got = pdmc_statistics_stratified_proportion(hits, trials, 2500, 10000, 0.95);
    const pdmc_estimate p0 = pdmc_statistics_proportion(8, 80, 0.95), p1 = pdmc_statistics_proportion(10, 20, 0.95);
    const pdmc_estimate w = pdmc_statistics_proportion(2500, 10000, 0.95);
    CHECK_NEAR(got.value, 0.2, 1e-15);
    CHECK_NEAR(pow(got.upper - 0.2, 2),
               pow(0.25 * (p1.upper - 0.5), 2) + pow(0.75 * (p0.upper - 0.1), 2) + pow(0.4 * (w.upper - 0.25), 2),
               1e-15);
    CHECK_NEAR(pow(0.2 - got.lower, 2),
               pow(0.25 * (0.5 - p1.lower), 2) + pow(0.75 * (0.1 - p0.lower), 2) + pow(0.4 * (0.25 - w.lower), 2),
               1e-15);
}

/// A control that is there where x is not: the bounds of its share change sides.
static void a_control_of_the_opposite(void **state)
{
    (void)state;
    const size_t hits[2] = {40, 0}, trials[2] = {40, 60}, same_hits[2] = {0, 40}, same_trials[2] = {60, 40};
    const pdmc_estimate got = pdmc_statistics_stratified_proportion(hits, trials, 6100, 10000, 0.95);
    const pdmc_estimate same = pdmc_statistics_stratified_proportion(same_hits, same_trials, 3900, 10000, 0.95);
    CHECK_NEAR(got.value, 0.39, 1e-15);
    CHECK_NEAR(got.lower, same.lower, 1e-12);
    CHECK_NEAR(got.upper, same.upper, 1e-12);
}

static void one_stratum_is_no_control(void **state)
{
    (void)state;
    const size_t hits[2] = {3, 0}, trials[2] = {100, 0};
    const pdmc_estimate got = pdmc_statistics_stratified_proportion(hits, trials, 5, 10000, 0.95);
    const pdmc_estimate plain = pdmc_statistics_proportion(3, 100, 0.95);
    assert_memory_equal(&got, &plain, sizeof got);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intervals_hold_and_are_narrower),
        cmocka_unit_test(shares_are_weighed),
        cmocka_unit_test(a_control_of_the_opposite),
        cmocka_unit_test(one_stratum_is_no_control),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
