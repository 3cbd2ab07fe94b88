// SPDX-License-Identifier: GPL-3.0-or-later

/// The estimate of the cost counts what the run then has. Seconds and bytes depend on the machine, so only their order
/// is checked here: an estimate that lost a part, or a factor of a thousand, is seen.

#include "run/studies.h"

// What one thread is said to need, and what it then does.
static void estimate(const char *sampling, pdmc_cost *cost, pdmc_results *results)
{
    pdmc_study study;
    const pdmc_run_options options = {.threads = 1};
    read_study(ONE_CRACK, BOTH, sampling, &study);
    *cost = pdmc_run_cost(&study.problem, 1);
    CHECK_OK(pdmc_run(&study, &options, results));
    pdmc_study_clear(&study);
}

static void counts(void **state)
{
    (void)state;
    pdmc_cost cost;
    pdmc_results results;
    estimate("samples = 10;", &cost, &results);
    assert_int_equal(cost.nodes, results.solver.nodes);
    assert_int_equal(cost.unknowns, results.solver.unknowns);
    CHECK_NEAR(cost.rows, results.solver.rows, 0.2 * results.solver.rows); // points near tips and outside are left out
    pdmc_results_clear(&results);
}

static void seconds_and_bytes(void **state)
{
    (void)state;
    const char *samplings[] = {"samples = 2000;", "samples = 128; inverse = \"direct\";"};
    for (int i = 0; i < 2; i++) {
        pdmc_cost cost;
        pdmc_results results;
        estimate(samplings[i], &cost, &results);
        const double times = results.runtime.total / cost.seconds; // sanitizers and loaded machines are slow
        if (!(0.2 < times && times < 50.0)) fail_msg("%s took %g times the estimate", samplings[i], times);
        if (!(20e6 < cost.bytes && cost.bytes < 200e6)) fail_msg("%s: %g bytes", samplings[i], cost.bytes);
        pdmc_results_clear(&results);
    }
}

static void more_costs_more(void **state)
{
    (void)state;
    pdmc_study study;
    read_study(ONE_CRACK, BOTH, "samples = 128; inverse = \"direct\";", &study);
    const pdmc_cost base = pdmc_run_cost(&study.problem, 1), shared = pdmc_run_cost(&study.problem, 2);
    assert_true(shared.seconds < base.seconds && shared.bytes > base.bytes);
    study.problem.sampling.samples *= 100;
    const pdmc_cost longer = pdmc_run_cost(&study.problem, 1);
    assert_true(50.0 * base.seconds < longer.seconds && longer.seconds < 100.0 * base.seconds);
    assert_true(longer.bytes > base.bytes);
    study.problem.sampling.inverse = PDMC_INVERSE_NEUMANN;
    assert_true(pdmc_run_cost(&study.problem, 1).seconds < 0.5 * longer.seconds);
    pdmc_study_clear(&study);
}

// What comes besides the samples: points of rare growth and sensitivities, a control, and the most samples of a target.
static void all_that_is_asked_for_costs(void **state)
{
    (void)state;
    pdmc_study study;
    read_study(ONE_CRACK, BOTH, "samples = 1000; target = \"mean\"; most_samples = 100000;", &study);
    pdmc_problem *p = &study.problem;
    const pdmc_cost base = pdmc_run_cost(p, 1);
    p->sampling.samples = 100000;
    CHECK_NEAR(base.most_seconds, pdmc_run_cost(p, 1).seconds, 1e-9 * base.most_seconds);
    assert_true(base.most_seconds > 1.5 * base.seconds);
    p->sampling.samples = 1000;
    p->sampling.target = PDMC_TARGET_NONE;
    CHECK_NEAR(pdmc_run_cost(p, 1).most_seconds, base.seconds, 0.0);
    p->reliability = (pdmc_reliability_request){PDMC_RARE_SUBSET, 0.001, 100000, 0};
    const pdmc_cost rare = pdmc_run_cost(p, 1); // at the cap, as many points as those samples
    CHECK_NEAR(rare.seconds - base.seconds, base.most_seconds - base.seconds, 0.5 * (base.most_seconds - base.seconds));
    p->reliability.method = PDMC_RARE_BOTH;
    p->reliability.sensitivity = 50000;
    assert_true(pdmc_run_cost(p, 1).seconds > rare.seconds + 2.0 * (rare.seconds - base.seconds));
    p->reliability = (pdmc_reliability_request){PDMC_RARE_NONE, 0.05, 100000, 0};
    p->control.samples = 100000;
    p->control.solver = p->solver;
    const pdmc_cost controlled = pdmc_run_cost(p, 1);
    assert_true(controlled.seconds > base.most_seconds && controlled.bytes > base.bytes);
    pdmc_study_clear(&study);
}

// A basis for a random stiffness by bonds is dear, the more so the more modes it has.
static void a_basis_costs(void **state)
{
    (void)state;
    pdmc_study study;
    read_study(ONE_CRACK, "{ quantity = \"stiffness\"; correlation_length = 1; modes = 200; variation = 0.1; }",
               "samples = 64;", &study);
    pdmc_problem *p = &study.problem;
    p->solver.method = PDMC_METHOD_BOND;
    p->solver.horizon = 4.0 * (p->solver.spacing = 0.1);
    const double full = pdmc_run_cost(p, 1).seconds;
    p->sampling.inverse = PDMC_INVERSE_REDUCED;
    const double reduced = pdmc_run_cost(p, 1).seconds;
    assert_true(reduced > 5.0 * full);
    p->uncertainties[0].modes = 20;
    assert_true(pdmc_run_cost(p, 1).seconds < 0.5 * reduced);
    pdmc_study_clear(&study);
}

static void a_plate_for_every_sample(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_results results;
    const pdmc_run_options options = {.threads = 1};
    read_study(ONE_CRACK, "{ quantity = \"crack_length\"; variation = 0.1; }", "samples = 16;", &study);
    const pdmc_cost base = pdmc_run_cost(&study.problem, 1), shared = pdmc_run_cost(&study.problem, 2);
    CHECK_OK(pdmc_run(&study, &options, &results));
    const double times = results.runtime.total / base.seconds; // as above
    if (!(0.2 < times && times < 50.0)) fail_msg("took %g times the estimate", times);
    assert_true(shared.bytes > base.bytes);
    study.problem.sampling.samples *= 100;
    const pdmc_cost longer = pdmc_run_cost(&study.problem, 1);
    assert_true(50.0 * base.seconds < longer.seconds && longer.seconds < 100.0 * base.seconds);
    study.problem.solver.method = PDMC_METHOD_BOND;
    study.problem.solver.horizon = 3.0 * (study.problem.solver.spacing = 0.1);
    const pdmc_cost moved = pdmc_run_cost(&study.problem, 1);
    study.problem.uncertainty_count = 0;
    assert_true(50.0 * pdmc_run_cost(&study.problem, 1).seconds < moved.seconds);
    pdmc_results_clear(&results);
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts),
        cmocka_unit_test(seconds_and_bytes),
        cmocka_unit_test(more_costs_more),
        cmocka_unit_test(all_that_is_asked_for_costs),
        cmocka_unit_test(a_basis_costs),
        cmocka_unit_test(a_plate_for_every_sample),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
