// SPDX-License-Identifier: GPL-3.0-or-later

/// Studies by bonds, from the file to the results.

#include "run/studies.h"

#include "kansa/boundary_collocation.h"

static void read_bond_study(const char *sampling, pdmc_study *study)
{
    char text[2048];
    snprintf(text, sizeof text,
             "plate = { width = 4.0; height = 4.0; };\n"
             "material = { youngs_modulus = 1.5; fracture_energy = 1.25; };\n" // near the median
             "cracks = ( { name = \"c\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );\n"
             "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n"
             "solver = { method = \"bond\"; spacing = 0.1; horizon_ratio = 3; };\n"
             "random = ( " BOTH " );\nsampling = { %s };\nenergy = { angles = 8; extension = 0.1; };\n",
             sampling);
    CHECK_OK(read_text(text, study));
}

static void run_bond_study(const char *sampling, int threads, pdmc_results *results)
{
    pdmc_study study;
    const pdmc_run_options options = {.threads = threads};
    read_bond_study(sampling, &study);
    CHECK_OK(pdmc_run(&study, &options, results));
    pdmc_study_clear(&study);
}

static void threads_change_nothing(void **state)
{
    (void)state;
    const char *samplings[] = {"samples = 150; inverse = \"neumann\";", "samples = 150; inverse = \"krylov\";",
                               "samples = 150; inverse = \"reduced\";", "samples = 20; inverse = \"direct\";"};
    for (int i = 0; i < 4; i++) {
        pdmc_results one, more;
        run_bond_study(samplings[i], 1, &one);
        for (int threads = 2; threads <= 3; threads++) {
            run_bond_study(samplings[i], threads, &more);
            assert_same_samples(&one, &more, one.sample_count);
            pdmc_results_clear(&more);
        }
        pdmc_results_clear(&one);
    }
}

// The mean of the largest energy, by which the model's errors are divided.
static double mean_of_largest(const pdmc_results *r, int measure, int tip)
{
    double sum = 0.0;
    for (int s = 0; s < r->sample_count; s++) sum += r->largest_energy[measure][s * r->tip_count + tip];
    return sum / r->sample_count;
}

// A statistic of the two runs, in every direction: the largest difference, as a part of what it is said to be at most. The
// iteration's own error is below a millionth of that.
static double share_of_promise(const pdmc_results *full, const pdmc_results *reduced, int measure, int stride, int which,
                               double promise)
{
    const pdmc_energy_statistics *a = &full->statistics[measure], *b = &reduced->statistics[measure];
    const pdmc_estimate *first = which < 0 ? a->mean : &a->quantiles[which];
    const pdmc_estimate *second = which < 0 ? b->mean : &b->quantiles[which];
    double worst = 0.0;
    for (int t = 0; t < full->tip_count; t++) {
        const double most = promise * mean_of_largest(reduced, measure, t);
        for (int d = t * full->angle_count; d < (t + 1) * full->angle_count; d++)
            worst = fmax(worst, fabs(first[d * stride].value - second[d * stride].value) / most);
    }
    return worst;
}

static void check_statistics(const pdmc_results *full, const pdmc_results *reduced, int measure)
{
    const pdmc_sample_accuracy *accuracy = &reduced->accuracy;
    const double mean = share_of_promise(full, reduced, measure, 1, -1, accuracy->mean_error[measure]);
    print_message("  mean: said to be off by %.1e at most, %.2g of it\n", accuracy->mean_error[measure], mean);
    assert_true(mean > 0.0 && mean <= 1.0);
    assert_true(accuracy->mean_error[measure] <= accuracy->energy_error[measure]);
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        const double promise = accuracy->quantile_error[measure][q];
        const double share = share_of_promise(full, reduced, measure, PDMC_QUANTILES, q, promise);
        print_message("  %g %% quantile: %.1e, %.2g of it\n", 100.0 * pdmc_quantile_levels[q], promise, share);
        assert_true(share > 0.0 && share <= 1.0);
    }
}

// Every sample of the reduced model is as near to that of the iteration as its bound says, and the probability is the same.
static void the_reduced_model_keeps_its_promise(void **state)
{
    (void)state;
    pdmc_results full, reduced;
    run_bond_study("samples = 200; inverse = \"krylov\"; tolerance = 1e-12;", 2, &full);
    run_bond_study("samples = 200; inverse = \"reduced\"; energy_tolerance = 0.1;", 2, &reduced);
    const int directions = full.tip_count * full.angle_count;
    for (int m = 0; m < PDMC_MEASURES; m++) {
        double worst = 0.0;
        for (int s = 0; s < 200; s++)
            for (int t = 0; t < full.tip_count; t++) {
                double largest[2] = {0.0, 0.0};
                for (int a = 0; a < full.angle_count; a++) {
                    const int at = s * directions + t * full.angle_count + a;
                    largest[0] = fmax(largest[0], full.energy[m][at]);
                    largest[1] = fmax(largest[1], reduced.energy[m][at]);
                }
                worst = fmax(worst, fabs(largest[1] / largest[0] - 1.0));
            }
        print_message("%s: error at most %.1e, said to be %.1e at most, %.1e typically\n", pdmc_measure_names[m], worst,
                      reduced.accuracy.energy_error[m], reduced.accuracy.typical_error[m]);
        assert_true(worst <= reduced.accuracy.energy_error[m]);
        check_statistics(&full, &reduced, m);
    }
    assert_true(reduced.accuracy.energy_error[PDMC_MEASURE_GRIFFITH] < 0.1); // the measure that decides
    assert_true(reduced.accuracy.solved_in_full > 0.0); // Griffith's energies near G_c
    for (int t = 0; t < full.tip_count; t++) CHECK_NEAR(reduced.probability[t].value, full.probability[t].value, 0.0);
    pdmc_results_clear(&full);
    pdmc_results_clear(&reduced);
}

// The numbers behind sample i are those of any other method with the same seed.
static void samples_are_those_of_the_collocation(void **state)
{
    (void)state;
    pdmc_results bonds, kansa;
    const pdmc_run_options options = {.threads = 1};
    run_bond_study("samples = 20;", 1, &bonds);
    run_study(ONE_CRACK, BOTH, "samples = 20;", &options, &kansa);
    assert_same("load_factor", bonds.load_factor, kansa.load_factor, 20 * sizeof(double));
    assert_same("micromodulus", bonds.micromodulus, kansa.micromodulus, 20 * 100 * sizeof(double));
    pdmc_results_clear(&bonds);
    pdmc_results_clear(&kansa);
}

static void the_cost_counts_the_nodes(void **state)
{
    (void)state;
    pdmc_study study;
    read_bond_study("samples = 100;", &study);
    const pdmc_cost cost = pdmc_run_cost(&study.problem, 1);
    assert_int_equal(cost.nodes, 1600);
    assert_int_equal(cost.unknowns, 3200);
    study.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    assert_true(pdmc_run_cost(&study.problem, 1).seconds > cost.seconds);
    assert_true(pdmc_run_cost(&study.problem, 2).seconds < pdmc_run_cost(&study.problem, 1).seconds);
    pdmc_study_clear(&study);
}

// 10 cells a crack, 3 spacings a horizon, and edges that lack bonds: K within 3 % of the local limit, as measured, and
// its error said to be of that size.
static void stress_intensity_is_near_the_local_limit(void **state)
{
    (void)state;
    pdmc_results results;
    reference local;
    reference_solve(&local, 4.0, 0.5, 0.0);
    run_bond_study("samples = 1;", 1, &results);
    for (int t = 0; t < 2; t++) {
        const pdmc_tip *tip = &results.tips[t];
        print_message("K_I %.4f +- %.4f, local limit %.4f\n", tip->stress_intensity[0], tip->stress_intensity_error[0],
                      local.K[0]);
        CHECK_NEAR(tip->stress_intensity[0], local.K[0], 0.03 * local.K[0]);
        CHECK_NEAR(tip->stress_intensity[1], 0.0, 1e-6);
        assert_true(tip->stress_intensity_error[0] < 0.05);
    }
    pdmc_results_clear(&results);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(the_reduced_model_keeps_its_promise),
        cmocka_unit_test(samples_are_those_of_the_collocation),
        cmocka_unit_test(the_cost_counts_the_nodes),
        cmocka_unit_test(stress_intensity_is_near_the_local_limit),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
