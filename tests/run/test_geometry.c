// SPDX-License-Identifier: GPL-3.0-or-later

/// Cracks whose length, angle and place are random: every sample against the plate that has its crack there, against
/// closed forms of a small crack, and where it cannot be.

#include "run/studies.h"

#include "base/base_impl.h"
#include "pdmc/discretisation.h"
#include "pdmc/fracture.h"
#include "pdmc/random.h"
#include "run/family.h"
#include "stochastic/growth.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>

#define CRACK "cracks = ( { name = \"c\"; from = [-0.25, 0.0]; to = [0.25, 0.0]; } ); energy = { angles = 8; };"
#define SLANTED "cracks = ( { name = \"c\"; from = [-0.1, -0.2]; to = [0.3, 0.1]; } ); energy = { angles = 8; };"
#define LENGTH "{ quantity = \"crack_length\"; distribution = \"uniform\"; lower = 0.3; upper = 0.7; }"
#define ANGLE "{ quantity = \"crack_angle\"; location = 5; scale = 30; }"
#define X "{ quantity = \"crack_x\"; location = 0; scale = 0.3; }"
#define Y "{ quantity = \"crack_y\"; distribution = \"triangular\"; lower = -0.5; mode = 0; upper = 0.2; }"
#define ALL LENGTH ", " ANGLE ", " X ", " Y

static void run_with(const char *top, const char *random, const char *sampling, int threads, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = threads};
    run_study(top, random, sampling, &options, results);
}

// A sample's value of a quantity, from its stream and its distribution.
static double value_of(const pdmc_problem *problem, pdmc_quantity quantity, pdmc_stream stream, int sample)
{
    double u;
    pdmc_random_uniform(problem->sampling.seed, stream, (uint64_t)sample, 0, 1, &u);
    return pdmc_distribution_value(&pdmc_problem_uncertainty(problem, quantity)->law, pdmc_normal_quantile(u));
}

// The crack of a sample, about the middle and from the angle of the study's.
static pdmc_crack crack_of(const pdmc_problem *p, int sample)
{
    const double half = 0.5 * value_of(p, PDMC_QUANTITY_CRACK_LENGTH, PDMC_STREAM_CRACK_LENGTH, sample);
    const pdmc_crack *c = &p->cracks[0];
    const double angle = atan2(c->to[1] - c->from[1], c->to[0] - c->from[0]) +
                         M_PI / 180.0 * value_of(p, PDMC_QUANTITY_CRACK_ANGLE, PDMC_STREAM_CRACK_ANGLE, sample);
    const double x = 0.5 * (c->from[0] + c->to[0]) + value_of(p, PDMC_QUANTITY_CRACK_X, PDMC_STREAM_CRACK_X, sample);
    const double y = 0.5 * (c->from[1] + c->to[1]) + value_of(p, PDMC_QUANTITY_CRACK_Y, PDMC_STREAM_CRACK_Y, sample);
    return (pdmc_crack){.name = "c",
                        .from = {x - half * cos(angle), y - half * sin(angle)},
                        .to = {x + half * cos(angle), y + half * sin(angle)}};
}

// The same study, with that crack and nothing random.
static void run_with_crack(pdmc_study *study, const pdmc_crack *crack, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = 1};
    const pdmc_crack before = study->problem.cracks[0];
    const int count = study->problem.uncertainty_count;
    study->problem.cracks[0] = *crack;
    study->problem.uncertainty_count = 0;
    CHECK_OK(pdmc_run(study, &options, results));
    study->problem.cracks[0] = before;
    study->problem.uncertainty_count = count;
}

// Every sample against the plate that has its crack: K goes with the load, and G with its square.
static void check_samples(pdmc_study *study, double tolerance)
{
    const pdmc_run_options options = {.threads = 2};
    pdmc_results all, one;
    CHECK_OK(pdmc_run(study, &options, &all));
    const int directions = all.tip_count * all.angle_count;
    for (int s = 0; s < all.sample_count; s++) {
        const pdmc_crack crack = crack_of(&study->problem, s);
        run_with_crack(study, &crack, &one);
        const double load = all.load_factor[s], square = load * load;
        assert_int_equal(all.failure[s], PDMC_SAMPLE_OK);
        for (int k = 0; k < 4; k++)
            CHECK_NEAR(all.stress_intensity[4 * s + k], load * one.tips[k / 2].stress_intensity[k % 2], tolerance);
        for (int d = 0; d < directions; d++) {
            const int place = directions * s + d;
            CHECK_NEAR(all.energy[PDMC_MEASURE_BOND][place], square * one.nominal_bond_energy[d], tolerance);
            CHECK_NEAR(all.energy[PDMC_MEASURE_GRIFFITH][place], square * one.nominal_griffith_energy[d], tolerance);
        }
        pdmc_results_clear(&one);
    }
    pdmc_results_clear(&all);
}

// Ends are rounded otherwise than those of the study, and a system of condition 1e10 makes that larger.
static const double rounding = 1e-5;

static void samples_are_plates_with_their_cracks(void **state)
{
    (void)state;
    pdmc_study study;
    read_study(SLANTED, ALL ", " LOAD, "samples = 4;", &study);
    check_samples(&study, rounding);
    pdmc_study_clear(&study);
}

static void visible_cracks_move(void **state)
{
    (void)state;
    pdmc_study study;
    read_study(CRACK, ALL, "samples = 1;", &study);
    study.problem.solver.crack_model = PDMC_CRACKS_VISIBLE;
    study.problem.solver.refinement = 2;
    study.problem.solver.horizon = 0.1;
    check_samples(&study, rounding);
    pdmc_study_clear(&study);
}

// So large that METIS orders it.
static void read_grid(const char *random, const char *sampling, pdmc_study *study)
{
    pdmc_solver_options *solver = &study->problem.solver;
    read_study(CRACK, random, sampling, study);
    solver->method = PDMC_METHOD_BOND;
    solver->spacing = solver->load_layer = study->problem.energy.extension = 0.0625;
    solver->horizon = study->problem.energy.horizon = 0.25;
    solver->area = PDMC_AREA_EXACT;
}

static void cracks_move_through_a_grid(void **state)
{
    (void)state;
    pdmc_study study;
    read_grid(ALL, "samples = 2;", &study);
    check_samples(&study, rounding);
    pdmc_study_clear(&study);
}

static void orderings_at_a_time_change_nothing(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_results one, many;
    const pdmc_run_options alone = {.threads = 1}, together = {.threads = 3};
    read_grid(ALL, "samples = 3;", &study);
    CHECK_OK(pdmc_run(&study, &alone, &one));
    CHECK_OK(pdmc_run(&study, &together, &many));
    assert_same_samples(&one, &many, 3);
    pdmc_results_clear(&one);
    pdmc_results_clear(&many);
    pdmc_study_clear(&study);
}

// Isida's table (Murakami, Stress Intensity Factors Handbook, 1987): F = 1.014 at a / W = 0.1 of a square plate, and
// 1.055 at 0.2, which is 1 + 1.38 (a / W)^2 within its digits.
static void longer_cracks_have_larger_intensities(void **state)
{
    (void)state;
    enum { SAMPLES = 8 };
    const double half_width = 2.5, digits = 5e-4, solver = 1e-3; // as K_I of the nominal plate is off, relative
    pdmc_study study;
    pdmc_results r;
    read_study(CRACK, LENGTH, "samples = 8;", &study);
    run_with(CRACK, LENGTH, "samples = 8;", 2, &r);
    for (int s = 0; s < SAMPLES; s++) {
        const double a = 0.5 * value_of(&study.problem, PDMC_QUANTITY_CRACK_LENGTH, PDMC_STREAM_CRACK_LENGTH, s);
        const double want = sqrt(M_PI * a) * (1.0 + 1.38 * gsl_pow_2(a / half_width));
        for (int t = 0; t < 2; t++) {
            CHECK_NEAR(r.stress_intensity[4 * s + 2 * t], want, (digits + solver) * want);
            CHECK_NEAR(r.stress_intensity[4 * s + 2 * t + 1], 0.0, solver * want);
        }
    }
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

// A small crack under tension: K_I = sqrt(pi a) cos^2, K_II = sqrt(pi a) sin cos of its angle. The tips turn with it:
// the directions of growth, which are those of the plate, are seen from the crack as it lies.
static void turned_cracks_have_turned_tips(void **state)
{
    (void)state;
    enum { SAMPLES = 8, ANGLES = 8 };
    const double width = 0.006; // of the plate, (a / W)^2 1.38 with some room
    const char *top =
        "cracks = ( { name = \"c\"; from = [-0.15, 0.0]; to = [0.15, 0.0]; } ); energy = { angles = 8; };";
    const char *turned = "{ quantity = \"crack_angle\"; distribution = \"uniform\"; lower = -50; upper = 50; }";
    const double size = sqrt(M_PI * 0.15);
    pdmc_study study;
    pdmc_results r;
    bool seen[2] = {false};
    read_study(top, turned, "samples = 8;", &study);
    run_with(top, turned, "samples = 8;", 2, &r);
    for (int s = 0; s < SAMPLES; s++) {
        const double angle =
            M_PI / 180.0 * value_of(&study.problem, PDMC_QUANTITY_CRACK_ANGLE, PDMC_STREAM_CRACK_ANGLE, s);
        seen[angle > 0.0] = true;
        for (int t = 0; t < 2; t++) {
            const double *K = &r.stress_intensity[4 * s + 2 * t], ahead = angle + (t ? 0.0 : M_PI);
            CHECK_NEAR(K[0], size * cos(angle) * cos(angle), width * size);
            CHECK_NEAR(K[1], size * sin(angle) * cos(angle), width * size);
            for (int a = 0; a < ANGLES; a++)
                CHECK_NEAR(r.energy[PDMC_MEASURE_GRIFFITH][(2 * s + t) * ANGLES + a],
                           pdmc_griffith_energy(2.0 * M_PI * a / ANGLES - ahead, K, 1.5), 1e-12);
        }
    }
    assert_true(seen[0] && seen[1]);
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

static void the_bits_are_those_of_one_thread(const char *top, const char *random, const char *sampling)
{
    pdmc_results one, many;
    run_with(top, random, sampling, 1, &one);
    for (int threads = 2; threads <= 3; threads++) {
        run_with(top, random, sampling, threads, &many);
        assert_same_samples(&one, &many, one.sample_count);
        pdmc_results_clear(&many);
    }
    pdmc_results_clear(&one);
}

static void threads_change_nothing(void **state)
{
    (void)state;
    the_bits_are_those_of_one_thread(CRACK, ALL ", " BOTH, "samples = 5;");
    the_bits_are_those_of_one_thread(CRACK, ALL ", " BOTH, "samples = 3; inverse = \"direct\";");
}

// One that leaves the plate, comes too near to an edge or to the other crack, or is too short: the clearance is a
// spacing, and the least length four horizons.
static void a_crack_that_cannot_be_is_counted(void **state)
{
    (void)state;
    enum { SAMPLES = 24, DIRECTIONS = 32 };
    const double clearance = 0.5, other = 0.9;
    const char *top = "cracks = ( { name = \"c\"; from = [-0.25, 0.0]; to = [0.25, 0.0]; }, "
                      "{ name = \"d\"; from = [0.9, -0.6]; to = [0.9, 0.6]; } ); energy = { angles = 8; };";
    const char *random = "{ quantity = \"crack_length\"; distribution = \"uniform\"; lower = 0.1; upper = 0.6; }, "
                         "{ quantity = \"crack_x\"; location = 0; scale = 1.5; }";
    pdmc_study study;
    pdmc_results r;
    int failed = 0, reasons[3] = {0};
    read_study(top, random, "samples = 24;", &study);
    run_with(top, random, "samples = 24;", 2, &r);
    for (int s = 0; s < SAMPLES; s++) {
        const double half = 0.5 * value_of(&study.problem, PDMC_QUANTITY_CRACK_LENGTH, PDMC_STREAM_CRACK_LENGTH, s);
        const double x = value_of(&study.problem, PDMC_QUANTITY_CRACK_X, PDMC_STREAM_CRACK_X, s);
        const bool short_of[3] = {half<2.0 * study.problem.solver.horizon, fabs(x) + half> 2.5 - clearance,
                                  fabs(x - other) - half < clearance};
        const bool fails = short_of[0] || short_of[1] || short_of[2];
        for (int k = 0; k < 3; k++) reasons[k] += short_of[k];
        failed += fails;
        assert_int_equal(r.failure[s], fails ? PDMC_SAMPLE_GEOMETRY : PDMC_SAMPLE_OK);
        assert_int_equal(isnan(r.stress_intensity[8 * s]), fails);
        assert_int_equal(isnan(r.energy[PDMC_MEASURE_BOND][DIRECTIONS * s]), fails);
    }
    assert_true(failed < SAMPLES && reasons[0] > 0 && reasons[1] > 0 && reasons[2] > 0);
    assert_int_equal(r.failed_count, failed);
    assert_true(r.probability[0].upper > (double)failed / SAMPLES); // a failed one may have grown
    CHECK_OK(pdmc_results_write(&r, "failed.h5", true));
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

// A crack that no sample has inside the plate: the run says why there is nothing.
static void cracks_that_never_can_be_are_named(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_results r;
    read_study(CRACK, "{ quantity = \"crack_x\"; location = 10; scale = 0.1; }", "samples = 5;", &study);
    CHECK_STATUS(pdmc_run(&study, &(pdmc_run_options){.threads = 1}, &r), PDMC_ERR_DATA);
    assert_string_equal(pdmc_last_error(),
                        "all 5 samples failed, there is nothing to summarise: in 5 cracks leave the plate, are too "
                        "short, come too near, or cannot be discretised");
    pdmc_study_clear(&study);
}

// A crack that goes through an edge keeps its mouth.
static void a_mouth_stays_outside(void **state)
{
    (void)state;
    const pdmc_crack edge = {.name = "e", .from = {-3.0, 0.0}, .to = {-2.0, 0.0}};
    pdmc_crack moved = edge, cracks[1] = {edge};
    const pdmc_problem problem = {.plate = {5.0, 5.0, 1.0},
                                  .solver = {.method = PDMC_METHOD_BOND, .spacing = 0.1, .horizon = 0.3},
                                  .crack_count = 1,
                                  .cracks = cracks};
    assert_true(pdmc_problem_cracks_fit(&problem, &moved));
    moved.from[0] = -2.4;
    assert_false(pdmc_problem_cracks_fit(&problem, &moved));
    moved = edge;
    moved.to[0] = -2.6; // no tip is left
    assert_false(pdmc_problem_cracks_fit(&problem, &moved));
    moved.to[0] = -2.25; // nearer than a horizon
    assert_false(pdmc_problem_cracks_fit(&problem, &moved));
    cracks[0].to[0] = -2.25; // as it was drawn
    assert_true(pdmc_problem_cracks_fit(&problem, &moved));
}

// G of a crack of that length, on a plate of its own.
static double energy_of(const pdmc_problem *problem, double length)
{
    pdmc_problem own = *problem;
    pdmc_crack crack = {.name = "c", .from = {-0.5 * length, 0.0}, .to = {0.5 * length, 0.0}};
    pdmc_discretisation plate;
    pdmc_tip tip;
    own.cracks = &crack;
    own.uncertainty_count = 0;
    CHECK_OK(pdmc_discretise(&own, 1, &plate));
    CHECK_OK(plate.verbs->tip(plate.method, 1, &tip));
    pdmc_discretisation_clear(&plate);
    return tip.stress_intensity[0] * tip.stress_intensity[0] / problem->material.youngs_modulus;
}

static double critical_length(const pdmc_problem *problem, double lower, double upper)
{
    for (int k = 0; k < 20; k++) {
        const double middle = 0.5 * (lower + upper);
        *(energy_of(problem, middle) > problem->material.fracture_energy ? &upper : &lower) = middle;
    }
    return 0.5 * (lower + upper);
}

// G grows with the length: P(growth) = P(length > critical length), and a plane through the design point is exact.
static void growth_of_a_random_length(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_discretisation plate;
    pdmc_affine model;
    pdmc_variables variables;
    pdmc_growth growth;
    pdmc_first_order point;
    pdmc_tip tips[2];
    double angles[8];
    const pdmc_run_options options = {.threads = 2};
    const pdmc_first_order_options search = pdmc_first_order_options_default();
    read_study(CRACK, "{ quantity = \"crack_length\"; distribution = \"lognormal\"; variation = 0.1; }", "", &study);
    pdmc_problem *problem = &study.problem;
    problem->material.fracture_energy = 0.7;
    const double critical = critical_length(problem, 0.5, 0.8);
    const double want = pdmc_distribution_upper_tail(&problem->uncertainties[0].law, critical);
    assert_true(0.001 < want && want < 0.1);

    const pdmc_affine_family family = pdmc_plate_family(problem, 2);
    pdmc_results results = {.tip_count = 2, .tips = tips, .angle_count = 8, .angles = angles};
    CHECK_OK(pdmc_discretise(problem, 1, &plate));
    CHECK_OK(plate.verbs->affine(plate.method, &model));
    model.family = &family;
    for (int t = 0; t < 2; t++) CHECK_OK(plate.verbs->tip(plate.method, t, &tips[t]));
    for (int a = 0; a < 8; a++) angles[a] = 2.0 * M_PI * a / 8;
    CHECK_OK(pdmc_variables_create(problem, &model, &variables));
    CHECK_OK(pdmc_growth_create(&variables, &model, &model, &options, &results, &growth));
    const pdmc_limit_state limit = pdmc_growth_limit(&growth);
    CHECK_OK(pdmc_first_order_find(&limit, &search, &point));
    assert_true(point.converged);
    CHECK_NEAR(point.index, -gsl_cdf_ugaussian_Pinv(want), 2.0 * search.tolerance);

    double z[2] = {point.index + 0.01, -30.0}, g[2]; // just past it; and a length below four horizons, which fails
    CHECK_OK(limit.evaluate(limit.context, 2, z, g));
    assert_true(g[0] > 0.0 && isnan(g[1]));
    pdmc_first_order_clear(&point);
    pdmc_growth_clear(&growth);
    pdmc_variables_clear(&variables);
    pdmc_affine_clear(&model);
    pdmc_discretisation_clear(&plate);
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_are_plates_with_their_cracks),
        cmocka_unit_test(visible_cracks_move),
        cmocka_unit_test(cracks_move_through_a_grid),
        cmocka_unit_test(orderings_at_a_time_change_nothing),
        cmocka_unit_test(longer_cracks_have_larger_intensities),
        cmocka_unit_test(turned_cracks_have_turned_tips),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(a_crack_that_cannot_be_is_counted),
        cmocka_unit_test(cracks_that_never_can_be_are_named),
        cmocka_unit_test(a_mouth_stays_outside),
        cmocka_unit_test(growth_of_a_random_length),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
