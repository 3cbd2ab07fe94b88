// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/toy.h"

#include "pdmc/fracture.h"

// Order k of the expansion of S / (1 + xi) is S sum (-xi)^j: the sign that eq. 52 lacks in print. The energy in
// direction d is 1/2 c_0 g (d x)^2 with g = c / c_0 times the ring's weight.
static void the_expansion_alternates(void **state)
{
    (void)state;
    for (int order = 0; order <= 8; order++) {
        toy t;
        pdmc_results r;
        toy_make(&t, 0.2, 0.1);
        t.problem.sampling.order = order;
        t.problem.sampling.samples = 100;
        CHECK_OK(toy_run(&t, &one_thread, &r));
        for (int s = 0; s < 100; s++) {
            const double c = r.micromodulus[s], xi = c - 1.0;
            double x = 0.0;
            for (int j = order; j >= 0; j--) x = 1.0 - xi * x;
            const double ring = t.ring_weight;
            for (int d = 0; d < ANGLES; d++) {
                const double exact = c * ring * pow(d * r.load_factor[s] * x, 2); // c_0 / 2 = 1
                CHECK_NEAR(r.energy[PDMC_MEASURE_BOND][s * ANGLES + d], exact, 1e-13 * fabs(exact));
            }
            if (order > 0) CHECK_NEAR(r.contraction[s], fabs(xi), 1e-13);
            else assert_true(isnan(r.contraction[s]));
        }
        pdmc_results_clear(&r);
    }
}

static void direct_solves_need_no_expansion(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.2, 0.1);
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    for (int s = 0; s < r.sample_count; s++) {
        const double x = r.load_factor[s] / r.micromodulus[s];
        const double exact = r.micromodulus[s] * t.ring_weight * x * x;
        CHECK_NEAR(r.energy[PDMC_MEASURE_BOND][s * ANGLES + 1], exact, 1e-13 * exact);
        assert_true(isnan(r.contraction[s]));
    }
    pdmc_results_clear(&r);
}

// Samples of a wide distribution whose expansion does not contract have the answer that it stands for.
static void a_sample_that_does_not_contract_falls_back(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.5, 0.1);
    CHECK_OK(toy_run(&t, &one_thread, &r));
    int fallen = 0;
    for (int s = 0; s < r.sample_count; s++) {
        const double c = r.micromodulus[s], x = r.load_factor[s] / c;
        const bool contracts = fabs(c - 1.0) < 1.0;
        assert_int_equal(r.sample_solver[s], contracts ? PDMC_SOLVED_AS_ASKED : PDMC_SOLVED_IN_SPACE);
        assert_int_equal(r.failure[s], PDMC_SAMPLE_OK);
        fallen += !contracts;
        if (contracts) continue;
        const double exact = c * t.ring_weight * x * x;
        CHECK_NEAR(r.energy[PDMC_MEASURE_BOND][s * ANGLES + 1], exact, 1e-13 * fabs(exact));
    }
    assert_true(fallen > 20 && fallen < 100); // 4.6 % of 1000, four deviations of 6.6 either way
    pdmc_results_clear(&r);
}

// Samples that cannot be solved are marked, counted and without result, and widen the bounds of the probability; the
// others are as they would be without them.
static void a_bad_sample_is_counted_not_fatal(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.5, 0.1);
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    int failed = 0, hits = 0;
    for (int s = 0; s < r.sample_count; s++) {
        const bool is_singular = fabs(r.micromodulus[s]) < 0.05;
        assert_int_equal(r.failure[s], is_singular ? PDMC_SAMPLE_SINGULAR : PDMC_SAMPLE_OK);
        assert_int_equal(is_singular, isnan(r.energy[PDMC_MEASURE_BOND][s * ANGLES + 3]) != 0);
        failed += is_singular;
        hits += !is_singular && r.energy[PDMC_MEASURE_BOND][s * ANGLES + 3] > 1.0;
    }
    assert_true(failed > 0 && failed < 40); // 1.1 % of 1000
    assert_int_equal(r.failed_count, failed);
    const size_t n = (size_t)r.sample_count;
    CHECK_NEAR(r.probability[0].lower, pdmc_statistics_proportion((size_t)hits, n, 0.95).lower, 0.0);
    CHECK_NEAR(r.probability[0].value, hits / (1000.0 - failed), 1e-15);
    CHECK_NEAR(r.probability[0].upper, pdmc_statistics_proportion((size_t)(hits + failed), n, 0.95).upper, 0.0);
    pdmc_results_clear(&r);
}

// As in the count, a sample without an answer may have been either in the bounds of the probability with the load integrated.
static void a_bad_sample_widens_the_integrated_load(void **state)
{
    (void)state;
    enum { SAMPLES = 1000 };
    toy t;
    pdmc_results r;
    double x[3][SAMPLES];
    size_t solved = 0;
    toy_make(&t, 0.5, 0.1);
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    for (int s = 0; s < SAMPLES; s++) {
        const bool failed = r.failure[s] != PDMC_SAMPLE_OK;
        if (!failed) x[0][solved++] = r.growth_given_rest[s];
        x[1][s] = failed ? 0.0 : r.growth_given_rest[s];
        x[2][s] = failed ? 1.0 : r.growth_given_rest[s];
    }
    assert_true(solved < SAMPLES);
    CHECK_NEAR(r.conditional_probability[0].value, pdmc_statistics_bounded_mean(solved, x[0], 0.95).value, 0.0);
    CHECK_NEAR(r.conditional_probability[0].lower, pdmc_statistics_bounded_mean(SAMPLES, x[1], 0.95).lower, 0.0);
    CHECK_NEAR(r.conditional_probability[0].upper, pdmc_statistics_bounded_mean(SAMPLES, x[2], 0.95).upper, 0.0);
    pdmc_results_clear(&r);
}

static void check_same_samples(const pdmc_results *a, const pdmc_results *b, int count)
{
    const size_t n = (size_t)count * sizeof(double);
    assert_memory_equal(a->load_factor, b->load_factor, n);
    assert_memory_equal(a->micromodulus, b->micromodulus, n);
    assert_memory_equal(a->contraction, b->contraction, n);
    assert_memory_equal(a->stress_intensity, b->stress_intensity, 2 * n);
    for (int m = 0; m < PDMC_MEASURES; m++) assert_memory_equal(a->energy[m], b->energy[m], ANGLES * n);
}

static void samples_do_not_depend_on_threads_or_number(void **state)
{
    (void)state;
    toy t;
    pdmc_results first;
    toy_make(&t, 0.2, 0.1);
    CHECK_OK(toy_run(&t, &one_thread, &first));
    for (int threads = 1; threads <= 3; threads++) {
        const pdmc_run_options options = {.threads = threads};
        pdmc_results other;
        t.problem.sampling.samples = threads == 1 ? 333 : 1000;
        CHECK_OK(toy_run(&t, &options, &other));
        check_same_samples(&first, &other, other.sample_count);
        pdmc_results_clear(&other);
    }
    pdmc_results reseeded;
    t.problem.sampling.seed = 8;
    CHECK_OK(toy_run(&t, &one_thread, &reseeded));
    assert_true(first.load_factor[0] != reseeded.load_factor[0]);
    assert_true(first.micromodulus[0] != reseeded.micromodulus[0]);
    pdmc_results_clear(&reseeded);
    pdmc_results_clear(&first);
}

static bool stop_after_300(void *context, int done, int total)
{
    (void)context;
    (void)total;
    return done < 300;
}

static void an_early_stop_keeps_what_is_done(void **state)
{
    (void)state;
    toy t;
    pdmc_results whole, stopped;
    toy_make(&t, 0.2, 0.1);
    CHECK_OK(toy_run(&t, &one_thread, &whole));
    const pdmc_run_options options = {.threads = 2, .progress = stop_after_300};
    CHECK_OK(toy_run(&t, &options, &stopped));
    assert_int_equal(whole.status, PDMC_RUN_COMPLETE);
    assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
    assert_true(stopped.sample_count >= 192 && stopped.sample_count < 1000); // two blocks may be under way
    check_same_samples(&whole, &stopped, stopped.sample_count);
    pdmc_results_clear(&stopped);
    pdmc_results_clear(&whole);
}

// Load alone: G = S^2 G_0 with S normal, whose coefficient of variation is sqrt(4 v^2 + 2 v^4) / (1 + v^2) = 0.3884 for
// v = 0.2; that of 20,000 samples is known to 0.5 % of itself (one deviation, from the eighth moment: 0.0021).
static void the_load_scatters_the_energy_by_its_square(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.0, 0.2);
    t.problem.sampling.samples = 20000;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    const double v = 0.2, exact = sqrt(4 * v * v + 2 * pow(v, 4)) / (1 + v * v);
    const pdmc_energy_statistics *bond = &r.statistics[PDMC_MEASURE_BOND];
    const double variation = bond->standard_deviation[1].value / bond->mean[1].value;
    printf("  coefficient of variation of G from a load of 20 %%: %.4f, exact %.4f\n", variation, exact);
    CHECK_NEAR(variation, exact, 4 * 0.0021);
    CHECK_NEAR(bond->mean[1].value / r.nominal_bond_energy[1], 1.04, 4 * 0.404 / sqrt(20000.0));
    assert_true(bond->mean[1].lower < bond->mean[1].value && bond->mean[1].value < bond->mean[1].upper);
    pdmc_results_clear(&r);
}

// Griffith's energy of K_I = S E_eff / E: the toy's modulus is certain, so G = S^2 / E straight ahead.
static void griffith_follows_the_stress_intensity(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.0, 0.2);
    t.problem.sampling.samples = 10;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    for (int s = 0; s < 10; s++) {
        CHECK_NEAR(r.stress_intensity[2 * s], r.load_factor[s], 1e-15);
        CHECK_NEAR(r.energy[PDMC_MEASURE_GRIFFITH][s * ANGLES], pow(r.load_factor[s], 2), 1e-14);
        CHECK_NEAR(r.energy[PDMC_MEASURE_GRIFFITH][s * ANGLES + 1],
                   pdmc_griffith_energy(r.angles[1], &r.stress_intensity[2 * s], 1.0), 0.0);
    }
    pdmc_results_clear(&r);
}

// With an effective modulus that follows c, K = modulus x is S whatever c is, as in every plate under tractions, and G = K^2
// over the sample's own modulus.
static void stresses_and_energies_take_the_modulus_of_the_sample(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.2, 0.1);
    t.modulus = 1.0;
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    t.problem.sampling.samples = 50;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    for (int s = 0; s < 50; s++) {
        CHECK_NEAR(r.effective_modulus[s], r.micromodulus[s], 1e-15);
        CHECK_NEAR(r.stress_intensity[2 * s], r.load_factor[s], 1e-14);
        CHECK_NEAR(r.energy[PDMC_MEASURE_GRIFFITH][s * ANGLES], pow(r.load_factor[s], 2) / r.micromodulus[s], 1e-13);
    }
    pdmc_results_clear(&r);
}

// The bond energy is largest in the last direction; a tie is shared.
static void the_direction_of_the_largest_energy_is_counted(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.1, 0.1);
    CHECK_OK(toy_run(&t, &one_thread, &r));
    CHECK_NEAR(r.direction[3].value, 1.0, 0.0);
    CHECK_NEAR(r.direction[2].value, 0.0, 0.0);
    pdmc_results_clear(&r);
    t.row[1] = -3.0;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    CHECK_NEAR(r.direction[1].value, 0.5, 1e-12);
    CHECK_NEAR(r.direction[3].value, 0.5, 1e-12);
    pdmc_results_clear(&r);
}

static void tensile_bonds_alone_can_be_counted(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.1, 0.1);
    t.row[1] = -1.0;
    t.problem.energy.bonds = PDMC_BONDS_TENSILE;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    assert_true(r.nominal_bond_energy[1] > 0.0 && r.nominal_bond_energy_tensile[1] == 0.0);
    assert_true(r.nominal_bond_energy[2] == r.nominal_bond_energy_tensile[2]);
    for (int s = 0; s < r.sample_count; s++) assert_true(r.energy[PDMC_MEASURE_BOND][s * ANGLES + 1] == 0.0);
    pdmc_results_clear(&r);
}

static void samples_that_all_failed_say_why(void **state)
{
    (void)state;
    uint8_t failure[6] = {PDMC_SAMPLE_SOFT,     PDMC_SAMPLE_DIVERGED, PDMC_SAMPLE_SINGULAR,
                          PDMC_SAMPLE_DIVERGED, PDMC_SAMPLE_GEOMETRY, PDMC_SAMPLE_DIVERGED};
    pdmc_results r = {.sample_count = 6, .failed_count = 6, .failure = failure};
    CHECK_STATUS(pdmc_summarise(&one_thread, NULL, &r), PDMC_ERR_DATA);
    assert_string_equal(
        pdmc_last_error(),
        "all 6 samples failed, there is nothing to summarise: in 3 the expansion does not contract, in 1 the system is "
        "singular, in 1 the modulus or the thickness is not positive, in 1 cracks leave the plate, are too short, come "
        "too near, or cannot be discretised");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_expansion_alternates),
        cmocka_unit_test(direct_solves_need_no_expansion),
        cmocka_unit_test(a_bad_sample_is_counted_not_fatal),
        cmocka_unit_test(a_bad_sample_widens_the_integrated_load),
        cmocka_unit_test(a_sample_that_does_not_contract_falls_back),
        cmocka_unit_test(samples_do_not_depend_on_threads_or_number),
        cmocka_unit_test(an_early_stop_keeps_what_is_done),
        cmocka_unit_test(the_load_scatters_the_energy_by_its_square),
        cmocka_unit_test(griffith_follows_the_stress_intensity),
        cmocka_unit_test(stresses_and_energies_take_the_modulus_of_the_sample),
        cmocka_unit_test(the_direction_of_the_largest_energy_is_counted),
        cmocka_unit_test(tensile_bonds_alone_can_be_counted),
        cmocka_unit_test(samples_that_all_failed_say_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
