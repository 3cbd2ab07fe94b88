// SPDX-License-Identifier: GPL-3.0-or-later

/// Explicit studies with random quantities: what is drawn, against its law; samples against studies that say the same in
/// figures; the bits of threads, prefixes and early stops; outcomes and paths of damage made up; failures.

#include "run/studies.h"

#include "pdmc/results.h"
#include "pdmc/statistics.h"
#include "run/draws.h"
#include "run/outcome.h"
#include "run/tips.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>

// A plate with a crack whose upper and lower strips are torn apart, then held; two tips of which either may stop anywhere.
#define PLATE                                                                                                          \
    "grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; thickness = 0.25; };\n"                               \
    "bodies = ( { from = [-12, -12]; to = [12, 12]; } );\n"                                                            \
    "cracks = ( { name = \"c\"; from = [-4, 0]; to = [4, 0]; } );\n"
#define LAYERS(speed)                                                                                                  \
    "conditions = ( { from = [-12, 9]; to = [12, 12]; y = " speed "; times = [12, 12]; factors = [1, 0]; },\n"         \
    "               { from = [-12, -12]; to = [12, -9]; y = -" speed "; times = [12, 12]; factors = [1, 0]; } );\n"
#define BY_STRETCH "materials = ( { density = 2.0; youngs_modulus = 3.0; critical_stretch = 0.02; } );\n"
#define TIMES "time = { duration = 30; }; record = { interval = 1; speed_window = 4; };\n"
#define FIELD                                                                                                          \
    "{ quantity = \"fracture_energy\"; distribution = \"weibull\"; variation = 0.4; correlation_length = 6.0; }"

static void read_torn(const char *settings, const char *random, int samples, pdmc_study *study)
{
    char text[4096];
    snprintf(text, sizeof text, "kind = \"explicit\"; seed = 5;\n%s" TIMES "%s%s%s sampling = { samples = %d; };\n",
             settings, *random ? "random = ( " : "", random, *random ? " );" : "", samples);
    CHECK_OK(read_text(text, study));
}

static void run_torn(const char *settings, const char *random, int samples, const pdmc_run_options *options,
                     pdmc_results *results)
{
    pdmc_study study;
    read_torn(settings, random, samples, &study);
    CHECK_OK(pdmc_run(&study, options, results));
    pdmc_study_clear(&study);
}

// Over samples the factor of a node has the law's distribution, by Kolmogorov's test, and the normal variables behind two nodes
// are correlated as the kernel says, but for what the modes that are left out take away.
static void a_field_has_its_law_at_every_node(void **state)
{
    (void)state;
    enum { SAMPLES = 2000, NODES = 576 };
    const int watched[3] = {0, 12 * 24 + 12, 12 * 24 + 15}; // a corner, the middle, three spacings from it
    const double level = 2.2;                               // passed by chance in 1.3e-4 of all cases
    static double stiffness[NODES], strength[NODES], value[3][SAMPLES], normal[3][SAMPLES];
    pdmc_study study;
    pdmc_results r;
    pdmc_ensemble_draws draws;
    read_torn(
        PLATE BY_STRETCH LAYERS("0.0"),
        "{ quantity = \"fracture_energy\"; distribution = \"weibull\"; variation = 0.4; covariance = \"gaussian\"; "
        "correlation_length = 6.0; }",
        1, &study);
    CHECK_OK(pdmc_run(&study, &(pdmc_run_options){.threads = 1}, &r));
    CHECK_OK(pdmc_ensemble_draws_create(&study, &r.particles, 1, &draws));
    const pdmc_distribution *law = &study.problem.uncertainties[0].law;
    for (int i = 0; i < NODES; i++) { // the normal variable has variance 1 everywhere, whatever the modes leave out
        const double *row = &draws.toughness.function[i * draws.toughness.modes];
        double variance = 0.0;
        for (int k = 0; k < draws.toughness.modes; k++) variance += row[k] * row[k];
        CHECK_NEAR(variance, 1.0, 1e-13);
    }
    for (int i = 0; i < SAMPLES; i++) {
        pdmc_explicit_sample sample;
        assert_true(pdmc_ensemble_draws_sample(&draws, (uint64_t)i, stiffness, strength, &sample));
        for (int k = 0; k < 3; k++) {
            value[k][i] = strength[watched[k]] * strength[watched[k]]; // s_0 goes with the root
            normal[k][i] = pdmc_normal_quantile(pdmc_distribution_lower_tail(law, value[k][i]));
        }
    }
    for (int k = 0; k < 3; k++) {
        double distance = 0.0, sorted[SAMPLES];
        memcpy(sorted, value[k], sizeof sorted);
        gsl_sort(sorted, 1, SAMPLES);
        for (int i = 0; i < SAMPLES; i++)
            distance = fmax(distance, fabs(pdmc_distribution_lower_tail(law, sorted[i]) - (i + 0.5) / SAMPLES));
        if (sqrt(SAMPLES) * distance > level) fail_msg("node %d: distance %g", watched[k], distance);
    }
    // 90 % of the variance are kept at least, and so all but 0.1 of a correlation; 0.02 is the error of 2000 samples.
    const double found = gsl_stats_correlation(normal[1], 1, normal[2], 1, SAMPLES);
    CHECK_NEAR(found, exp(-9.0 / 36.0), 0.1 + 3.0 * 0.02);
    assert_true(fabs(gsl_stats_correlation(normal[0], 1, normal[1], 1, SAMPLES)) < 0.1); // 17 spacings apart: 3e-4
    pdmc_ensemble_draws_clear(&draws);
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

// A sample of scalar factors is the study whose figures are multiplied by them.
static void a_sample_is_a_study_with_its_factors(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results r, own;
    run_torn(PLATE
             "materials = ( { density = 2.0; youngs_modulus = 3.0; fracture_energy = 0.0025; } );\n" LAYERS("0.02"),
             "{ quantity = \"load\"; distribution = \"normal\"; variation = 0.2; }, "
             "{ quantity = \"youngs_modulus\"; distribution = \"lognormal\"; variation = 0.3; }, "
             "{ quantity = \"fracture_energy\"; distribution = \"gamma\"; variation = 0.5; }",
             2, &options, &r);
    const pdmc_ensemble_results *e = &r.ensemble;
    assert_int_equal(e->sample_count, 2);
    for (int s = 0; s < 2; s++) {
        char text[2048], speed[32];
        snprintf(speed, sizeof speed, "%.17g", 0.02 * e->load[s]);
        snprintf(
            text, sizeof text,
            PLATE
            "materials = ( { density = 2.0; youngs_modulus = %.17g; fracture_energy = %.17g; } );\n"
            "conditions = ( { from = [-12, 9]; to = [12, 12]; y = %s; times = [12, 12]; factors = [1, 0]; },\n"
            "               { from = [-12, -12]; to = [12, -9]; y = -%s; times = [12, 12]; factors = [1, 0]; } );\n",
            3.0 * e->youngs_modulus[s], 0.0025 * e->fracture_energy[s], speed, speed);
        run_torn(text, "", 1, &options, &own);
        const pdmc_explicit_record *p = &own.particles;
        assert_int_equal(own.ensemble.sample_count, 0);
        // factors of c and s_0 are rounded otherwise
        CHECK_NEAR(e->fracture[s], p->fracture[p->record_count - 1], 1e-9 * e->fracture[s]);
        for (int t = 0; t < 2; t++) {
            CHECK_NEAR(e->growth[2 * s + t], pdmc_results_growth(p, t).growth, 1e-12);
            CHECK_NEAR(e->end[2 * (2 * s + t)], p->tips[t].position[0] + p->tips[t].direction[0] * e->growth[2 * s + t],
                       1.0 + 1e-9); // the tip was half a spacing or a whole one behind the crack's end at the start
        }
        pdmc_results_clear(&own);
    }
    assert_true(e->fracture[0] != e->fracture[1] && e->growth[0] > 0.0 && e->growth[2] > 0.0);
    pdmc_results_clear(&r);
}

static void check_same(const pdmc_ensemble_results *a, const pdmc_ensemble_results *b, int samples)
{
    const size_t n = (size_t)samples * sizeof(double), tips = (size_t)a->tip_count;
    assert_int_equal(a->tip_count, b->tip_count);
    assert_int_equal(a->station_count, b->station_count);
    assert_same("failure", a->failure, b->failure, (size_t)samples);
    assert_same("fracture", a->fracture, b->fracture, n);
    assert_same("outcome", a->outcome, b->outcome, (size_t)samples * tips);
    assert_same("growth", a->growth, b->growth, n * tips);
    assert_same("end", a->end, b->end, 2 * n * tips);
    assert_same("path", a->path, b->path, n * tips * (size_t)a->station_count);
}

typedef struct {
    int most, calls;
} patience;

static bool stop_after(void *context, int done, int total)
{
    patience *p = context;
    assert_true(done <= total && total == 5);
    p->calls++;
    return done < p->most;
}

static void samples_do_not_depend_on_threads_or_on_their_number(void **state)
{
    (void)state;
    static const char settings[] = PLATE BY_STRETCH LAYERS("0.02");
    static const char random[] =
        FIELD ", { quantity = \"bond_strength\"; distribution = \"weibull\"; variation = 0.1; }, "
              "{ quantity = \"stiffness\"; distribution = \"lognormal\"; variation = 0.1; correlation_length = 8.0; "
              "modes = 10; }";
    pdmc_results all, other;
    run_torn(settings, random, 5, &(pdmc_run_options){.threads = 1}, &all);
    assert_int_equal(all.ensemble.sample_count, 5);
    assert_int_equal(all.ensemble.failed_count, 0);
    run_torn(settings, random, 5, &(pdmc_run_options){.threads = 2}, &other);
    check_same(&all.ensemble, &other.ensemble, 5);
    assert_same("share", all.ensemble.share, other.ensemble.share, 8 * sizeof(pdmc_estimate));
    pdmc_results_clear(&other);
    run_torn(settings, random, 2, &(pdmc_run_options){.threads = 3},
             &other); // fewer than threads: each has all of them
    check_same(&all.ensemble, &other.ensemble, 2);
    pdmc_results_clear(&other);
    patience p = {.most = 2};
    run_torn(settings, random, 5, &(pdmc_run_options){.threads = 1, .progress = stop_after, .context = &p}, &other);
    assert_int_equal(other.status, PDMC_RUN_INTERRUPTED);
    assert_int_equal(other.ensemble.sample_count, 2);
    check_same(&all.ensemble, &other.ensemble, 2);
    CHECK_OK(pdmc_results_write(&other, "stopped.h5", true)); // arrays longer than the counts
    pdmc_results_clear(&other);
    CHECK_OK(pdmc_results_read("stopped.h5", &other));
    check_same(&all.ensemble, &other.ensemble, 2);
    assert_same("edges", all.ensemble.station, other.ensemble.station,
                (size_t)all.ensemble.station_count * sizeof(double));
    pdmc_results_clear(&other);
    pdmc_results_clear(&all);
}

// The nodes of PLATE, one a line and in its order.
static void write_nodes_of_plate(const char *path)
{
    char text[24 * 24 * 24] = "", *end = text;
    for (int y = 0; y < 24; y++)
        for (int x = 0; x < 24; x++) end += sprintf(end, "%.1f %.1f 0.25\n", x - 11.5, y - 11.5);
    write_text(path, text);
}

#define OF_NODES                                                                                                       \
    "grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; thickness = 0.25; };\n"                               \
    "bodies = ( { name = \"body1\"; shape = \"nodes\"; file = \"plate.nodes\"; } );\n"                                  \
    "cracks = ( { name = \"c\"; from = [-4, 0]; to = [4, 0]; } );\n"
#define IN_TWO(body)                                                                                                   \
    "grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; thickness = 0.25; };\n"                               \
    "bodies = ( { " body " }, { inside = \"body1\"; from = [3, -12]; to = [12, 12]; material = \"soft\"; } );\n"         \
    "cracks = ( { name = \"c\"; from = [-4, 0]; to = [4, 0]; } );\n"                                                   \
    "materials = ( { name = \"hard\"; density = 2.0; youngs_modulus = 3.0; critical_stretch = 0.02; },\n"               \
    "              { name = \"soft\"; density = 1.0; youngs_modulus = 1.0; fracture_energy = 0.002; } );\n"               \
    "interfaces = ( { first_material = \"hard\"; second_material = \"soft\"; fracture_energy = 5e-4; } );\n"
#define ALL_FACTORS                                                                                                    \
    FIELD ", { quantity = \"load\"; distribution = \"normal\"; variation = 0.1; }, "                                   \
          "{ quantity = \"youngs_modulus\"; distribution = \"lognormal\"; variation = 0.1; }, "                         \
          "{ quantity = \"stiffness\"; distribution = \"lognormal\"; variation = 0.1; correlation_length = 8.0; modes = 10; }"

// The nodes of a grid, given one by one, draw what they draw on it, and move by it as they do there, to rounding; of one material
// and of two with an interface between them.
static void samples_off_the_grid_are_those_on_it(void **state)
{
    (void)state;
    static const char *const settings[2][2] = {
        {PLATE BY_STRETCH LAYERS("0.02"), OF_NODES BY_STRETCH LAYERS("0.02")},
        {IN_TWO("from = [-12, -12]; to = [12, 12];") LAYERS("0.02"),
         IN_TWO("shape = \"nodes\"; file = \"plate.nodes\";") LAYERS("0.02")}};
    write_nodes_of_plate("plate.nodes");
    for (int k = 0; k < 2; k++) {
        pdmc_results on, off;
        run_torn(settings[k][0], ALL_FACTORS, 2, &(pdmc_run_options){.threads = 1}, &on);
        run_torn(settings[k][1], ALL_FACTORS, 2, &(pdmc_run_options){.threads = 1}, &off);
        const pdmc_ensemble_results *a = &on.ensemble, *b = &off.ensemble;
        assert_int_equal(b->failed_count, 0);
        for (int s = 0; s < 2; s++) {
            assert_true(a->fracture[s] > 0.0);
            CHECK_NEAR(b->load[s], a->load[s], 0.0);
            // The steps differ, by the surface's nodes, and so what bonds have beyond s_0 when they break.
            CHECK_NEAR(b->fracture[s], a->fracture[s], 1e-9 * a->fracture[s]);
            for (int t = 0; t < 2; t++) CHECK_NEAR(b->growth[2 * s + t], a->growth[2 * s + t], 1e-9);
        }
        assert_true(a->fracture[0] != a->fracture[1]);
        pdmc_results_clear(&on);
        pdmc_results_clear(&off);
    }
}

// Bonds off the grid have strengths of their own too, whatever the threads.
static void strengths_off_the_grid_are_those_of_their_bonds(void **state)
{
    (void)state;
    static const char strengths[] = "{ quantity = \"bond_strength\"; distribution = \"weibull\"; variation = 0.2; }";
    write_nodes_of_plate("plate.nodes");
    pdmc_results one, two;
    run_torn(OF_NODES BY_STRETCH LAYERS("0.02"), strengths, 3, &(pdmc_run_options){.threads = 1}, &one);
    run_torn(OF_NODES BY_STRETCH LAYERS("0.02"), strengths, 3, &(pdmc_run_options){.threads = 2}, &two);
    check_same(&one.ensemble, &two.ensemble, 3);
    assert_true(one.ensemble.fracture[0] != one.ensemble.fracture[1]);
    assert_true(one.ensemble.fracture[1] != one.ensemble.fracture[2]);
    assert_int_equal(one.ensemble.failed_count, 0);
    pdmc_results_clear(&one);
    pdmc_results_clear(&two);
}

// Counted again from the samples, by the functions of the statistics room.
static void statistics_are_of_the_samples(void **state)
{
    (void)state;
    enum { S = 12 };
    pdmc_results r;
    run_torn(PLATE BY_STRETCH LAYERS("0.02"), FIELD ", { quantity = \"load\"; variation = 0.3; }", S,
             &(pdmc_run_options){.threads = 2}, &r);
    const pdmc_ensemble_results *e = &r.ensemble;
    assert_int_equal(e->sample_count, S);
    for (int t = 0; t < 2; t++) {
        double growth[S];
        pdmc_estimate mean, deviation;
        for (int k = 0; k < PDMC_OUTCOMES; k++) {
            size_t hits = 0;
            for (int s = 0; s < S; s++) hits += e->outcome[2 * s + t] == k;
            const pdmc_estimate want = pdmc_statistics_proportion(hits, S, 0.95);
            assert_memory_equal(&e->share[t * PDMC_OUTCOMES + k], &want, sizeof want);
        }
        for (int s = 0; s < S; s++) growth[s] = e->growth[2 * s + t];
        pdmc_statistics_moments(S, growth, 0.95, &mean, &deviation);
        assert_memory_equal(&e->mean_growth[t], &mean, sizeof mean);
        gsl_sort(growth, 1, S);
        CHECK_NEAR(e->growth_quantiles[3 * t + 1].value, growth[S / 2 - 1], 0.0);
        assert_true(growth[0] < growth[S - 1]);
        for (int j = 0; j < e->station_count; j++) {
            int reached = 0;
            double sum = 0.0;
            for (int s = 0; s < S; s++) {
                const double left = e->path[(2 * s + t) * e->station_count + j];
                if (isnan(left)) continue;
                reached++;
                sum += left;
            }
            const int place = t * e->station_count + j;
            CHECK_NEAR(e->path_samples[place], reached, 0.0);
            if (reached > 0) CHECK_NEAR(e->path_mean[place].value, sum / reached, 1e-13);
        }
    }
    pdmc_results_clear(&r);
}

// A step that is just stable for the mean is not for a stiffer sample: those fail, and the bounds count them as both.
static void a_sample_that_cannot_move_fails(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_particles *particles;
    pdmc_results r;
    read_torn(PLATE BY_STRETCH LAYERS("0.02"), "{ quantity = \"youngs_modulus\"; variation = 0.2; }", 6, &study);
    CHECK_OK(pdmc_explicit_particles(&study.motion, 1, &particles));
    study.motion.has_step = true;
    study.motion.step = pdmc_particles_stable_step(particles);
    pdmc_particles_destroy(particles);
    CHECK_OK(pdmc_run(&study, &(pdmc_run_options){.threads = 2}, &r));
    const pdmc_ensemble_results *e = &r.ensemble;
    size_t failed = 0;
    for (int s = 0; s < 6; s++) {
        assert_int_equal(e->failure[s], e->youngs_modulus[s] > 1.0 ? PDMC_SAMPLE_DIVERGED : PDMC_SAMPLE_OK);
        assert_int_equal(isnan(e->growth[2 * s]), e->failure[s] != PDMC_SAMPLE_OK);
        failed += e->failure[s] != PDMC_SAMPLE_OK;
    }
    assert_int_equal(e->failed_count, failed);
    assert_in_range(failed, 1, 5);
    for (int k = 0; k < PDMC_OUTCOMES; k++) {
        size_t hits = 0;
        for (int s = 0; s < 6; s++) hits += e->failure[s] == PDMC_SAMPLE_OK && e->outcome[2 * s] == k;
        CHECK_NEAR(e->share[k].value, (double)hits / (double)(6 - failed), 1e-15);
        CHECK_NEAR(e->share[k].lower, pdmc_statistics_proportion(hits, 6, 0.95).lower, 1e-15);
        CHECK_NEAR(e->share[k].upper, pdmc_statistics_proportion(hits + failed, 6, 0.95).upper, 1e-15);
    }
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

// Damage along y = 0.5 x^2 / 10 ahead of a tip at the origin, two nodes wide, and a spot elsewhere.
static void a_path_follows_the_damage(void **state)
{
    (void)state;
    enum { N = 40 };
    const pdmc_explicit study = {.horizon = 1.5, .tip_damage = 0.3};
    const pdmc_followed_tip tip = {.direction = {1.0, 0.0}};
    double x[PDMC_AXES * N] = {0}, damage[N], offset[12];
    for (int i = 0; i < N; i++) { // x 0 .. 9, two nodes above and two below the line
        const double at = i / 4, middle = 0.05 * at * at;
        x[PDMC_AXES * i] = at;
        x[PDMC_AXES * i + 1] = middle + (i % 4 - 1.5) * 0.4;
        damage[i] = at > 7.0 ? 0.2 : i % 4 == 1 || i % 4 == 2 ? 0.8 : 0.1;
    }
    damage[39] = 1.0; // beyond a gap
    const pdmc_explicit_record record = {.spacing = 1.0, .node_count = N, .node_position = x};
    assert_int_equal(pdmc_tip_path(&study, &record, &tip, damage, 12, offset), 8);
    for (int j = 0; j < 8; j++) CHECK_NEAR(offset[j], 0.05 * j * j, 1e-14);
    assert_true(isnan(offset[8]) && isnan(offset[11]));
    damage[1] = 0.4; // below at the first station: (0.4 * -0.2 + 0.8 * 0.2) / 1.2
    pdmc_tip_path(&study, &record, &tip, damage, 12, offset);
    CHECK_NEAR(offset[0], 0.2 / 3.0, 1e-14);
    CHECK_NEAR(pdmc_tip_reach(&study, &tip, N, x), 8.0, 0.0); // those at 9 are more than two horizons aside
}

static void outcomes_are_of_the_last_window(void **state)
{
    (void)state;
    enum { N = 11 };
    double time[N], advance[4 * N] = {0}, speed[4 * N] = {0};
    for (int i = 0; i < N; i++) {
        time[i] = i;
        advance[4 * i + 1] = fmin(i, 5);
        advance[4 * i + 2] = i < 9 ? 0 : 1;
        advance[4 * i + 3] = fmin(i, 5);
    }
    const pdmc_explicit study = {.horizon = 1.5, .speed_window = 2.0};
    const pdmc_explicit_record r = {
        .record_count = N, .tip_count = 4, .time = time, .tip_advance = advance, .tip_speed = speed};
    assert_int_equal(pdmc_tip_outcome(&study, &r, 0, 20.0, 0.0), PDMC_OUTCOME_STILL);
    assert_int_equal(pdmc_tip_outcome(&study, &r, 1, 20.0, 5.0), PDMC_OUTCOME_ARRESTED);
    assert_int_equal(pdmc_tip_outcome(&study, &r, 2, 20.0, 1.0), PDMC_OUTCOME_RUNNING);
    assert_int_equal(pdmc_tip_outcome(&study, &r, 3, 6.4, 5.0), PDMC_OUTCOME_THROUGH);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_field_has_its_law_at_every_node),
        cmocka_unit_test(a_sample_is_a_study_with_its_factors),
        cmocka_unit_test(samples_do_not_depend_on_threads_or_on_their_number),
        cmocka_unit_test(samples_off_the_grid_are_those_on_it),
        cmocka_unit_test(strengths_off_the_grid_are_those_of_their_bonds),
        cmocka_unit_test(statistics_are_of_the_samples),
        cmocka_unit_test(a_sample_that_cannot_move_fails),
        cmocka_unit_test(a_path_follows_the_damage),
        cmocka_unit_test(outcomes_are_of_the_last_window),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
