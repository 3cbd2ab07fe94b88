// SPDX-License-Identifier: GPL-3.0-or-later

/// What a study file says about random quantities: each distribution in each of its ways, and what is said of mistakes.

#include "study/folder.h"

#include <gsl/gsl_sf_gamma.h>

/// The law of a load by the settings that follow its quantity.
static void read_load(const char *settings, pdmc_study *study)
{
    char line[512];
    snprintf(line, sizeof line, "random = ( { quantity = \"load\"; %s } );", settings);
    CHECK_OK(read_with(LINE_RANDOM, line, study));
    assert_int_equal(study->problem.uncertainty_count, 1);
}

static void check_moments(const char *settings, double want_mean, double want_deviation)
{
    pdmc_study study;
    double mean, deviation;
    read_load(settings, &study);
    pdmc_distribution_moments(&study.problem.uncertainties[0].law, &mean, &deviation);
    if (fabs(mean - want_mean) > 1e-10 * fabs(want_mean) || fabs(deviation - want_deviation) > 1e-10 * want_deviation)
        fail_msg("%s: %.15g, %.15g, want %.15g, %.15g", settings, mean, deviation, want_mean, want_deviation);
    pdmc_study_clear(&study);
}

static void by_mean_and_variation(void **state)
{
    (void)state;
    static const char *const kinds[] = {"normal", "lognormal", "weibull", "gumbel", "gamma", "uniform"};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        char settings[128];
        snprintf(settings, sizeof settings, "distribution = \"%s\"; mean = 3; variation = 0.15;", kinds[k]);
        check_moments(settings, 3.0, 0.45);
        snprintf(settings, sizeof settings, "distribution = \"%s\"; variation = 0.15;", kinds[k]);
        check_moments(settings, 1.0, 0.15);
        snprintf(settings, sizeof settings, "distribution = \"%s\"; mean = 3;", kinds[k]);
        check_moments(settings, 3.0, 0.6);
        snprintf(settings, sizeof settings, "distribution = \"%s\";", kinds[k]);
        check_moments(settings, 1.0, 0.2);
    }
    check_moments("", 1.0, 0.2);
}

// Means and deviations in closed form.
static void by_their_own_parameters(void **state)
{
    (void)state;
    const double euler = 0.57721566490153286, pi = 3.14159265358979324;
    const double one = gsl_sf_gamma(1.0 + 1.0 / 5.0), two = gsl_sf_gamma(1.0 + 2.0 / 5.0);
    check_moments("distribution = \"normal\"; location = 2; scale = 0.3;", 2.0, 0.3);
    check_moments("distribution = \"lognormal\"; median = 2; log_deviation = 0.3;", 2.0 * exp(0.045),
                  2.0 * exp(0.045) * sqrt(expm1(0.09)));
    check_moments("distribution = \"weibull\"; scale = 2; shape = 5;", 2.0 * one, 2.0 * sqrt(two - one * one));
    check_moments("distribution = \"gumbel\"; location = 2; scale = 0.3;", 2.0 + 0.3 * euler, 0.3 * pi / sqrt(6.0));
    check_moments("distribution = \"gamma\"; scale = 0.5; shape = 4;", 2.0, 1.0);
    check_moments("distribution = \"beta\"; lower = 1; upper = 3; alpha = 2; beta = 6;", 1.5,
                  2.0 * sqrt(2.0 * 6.0 / (64.0 * 9.0)));
    check_moments("distribution = \"uniform\"; lower = 1; upper = 3;", 2.0, 1.0 / sqrt(3.0));
    check_moments("distribution = \"triangular\"; lower = 0; mode = 1; upper = 2;", 1.0, 1.0 / sqrt(6.0));
    // linear from 1 to 3, in any order of the values
    check_moments("distribution = \"empirical\"; values = [3.0, 1.0, 2.0];", 2.0, 1.0 / sqrt(3.0));
    // half of a normal distribution: sqrt(2 / pi) and 1 - 2 / pi
    check_moments("distribution = \"normal\"; location = 0; scale = 1; least = 0;", sqrt(2.0 / pi),
                  sqrt(1.0 - 2.0 / pi));
    check_moments("distribution = \"uniform\"; lower = 0; upper = 4; least = 1; most = 3;", 2.0, 1.0 / sqrt(3.0));
}

static void means_are_those_of_plate_and_material(void **state)
{
    (void)state;
    pdmc_study study;
    const double means[] = {1.0, 2.0, 0.5, 0.7};
    CHECK_OK(
        read_text("plate = { width = 6.0; height = 4.0; thickness = 0.7; };\n"
                  "material = { youngs_modulus = 2.0; fracture_energy = 0.5; };\n"
                  "cracks = ( { from = [-0.5, 0.0]; to = [0.5, 0.0]; } );\n"
                  "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n"
                  "random = ( { quantity = \"load\"; }, { quantity = \"youngs_modulus\"; },\n"
                  "           { quantity = \"fracture_energy\"; }, { quantity = \"thickness\"; } );\n",
                  &study));
    for (int i = 0; i < 4; i++) {
        double mean, deviation;
        pdmc_distribution_moments(&study.problem.uncertainties[i].law, &mean, &deviation);
        CHECK_NEAR(mean, means[i], 1e-15);
        CHECK_NEAR(deviation, 0.2 * means[i], 1e-15);
    }
    pdmc_study_clear(&study);
}

static void expect_refusals(const char *const mistakes[][2], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        pdmc_study study;
        CHECK_STATUS(read_with(LINE_RANDOM, mistakes[i][0], &study), PDMC_ERR_CONFIG);
        char message[512];
        snprintf(message, sizeof message, "study.cfg:8: %s", mistakes[i][1]);
        assert_string_equal(pdmc_last_error(), message);
    }
}

#define EXPECT_REFUSALS(mistakes) expect_refusals((mistakes), sizeof(mistakes) / sizeof *(mistakes))
#define LOAD(settings) "random = ( { quantity = \"load\"; " settings " } );"
#define TOUGHNESS(settings) "random = ( { quantity = \"fracture_energy\"; " settings " } );"
#define STIFFNESS(settings) "random = ( { quantity = \"stiffness\"; " settings " } );"

static void parameters_that_make_no_distribution(void **state)
{
    (void)state;
    static const char *const mistakes[][2] = {
        {LOAD("distribution = \"lognormal\"; mean = 1; scale = 0.1;"),
         "random[0].distribution: \"lognormal\" with mean, scale is not allowed, must have mean and variation, or "
         "median "
         "and log_deviation"},
        {LOAD("distribution = \"weibull\"; scale = 0.1;"), "random[0].distribution: \"weibull\" with scale is not "
                                                           "allowed, must have mean and variation, or scale and shape"},
        {LOAD("distribution = \"beta\"; variation = 0.1; most = 3;"),
         "random[0].distribution: \"beta\" with variation is not allowed, must have lower, upper, alpha and beta"},
        {LOAD("distribution = \"triangular\";"),
         "random[0].distribution: \"triangular\" with no parameters is not allowed, must have lower, mode and upper"},
        {LOAD("distribution = \"empirical\"; mean = 1;"),
         "random[0].distribution: \"empirical\" with mean is not allowed, must have values"},
        {LOAD("values = [1.0, 2.0];"),
         "random[0].distribution: \"normal\" with values is not allowed, must have mean and variation, or location and "
         "scale"},
        {LOAD("distribution = \"empirical\"; values = [1.0];"),
         "random[0].values: an array of 1 is not allowed, must be an array of 2 reals or more, [x1, x2, ...]"},
        {LOAD("distribution = \"empirical\"; values = [1.0, 1.0];"),
         "random[0].distribution: the values of an empirical distribution are all 1"},
        {LOAD("distribution = \"lognormal\"; mean = -1;"),
         "random[0].distribution: the mean of a lognormal distribution is -1: it must be positive"},
        {LOAD("distribution = \"uniform\"; lower = 2; upper = 1;"),
         "random[0].distribution: the lower end of a uniform distribution is 2: it must not be above the upper, 1"},
        {LOAD("distribution = \"triangular\"; lower = 0; mode = 3; upper = 1;"),
         "random[0].distribution: the mode of a triangular distribution is 3: it must be in [0, 1]"},
        {LOAD("distribution = \"weibull\"; scale = 1; shape = 0;"), "random[0].shape: 0 is not allowed, must be > 0"},
        {LOAD("least = 2; most = 1;"),
         "random[0].distribution: a distribution is cut off below 2 and above 1: it needs least < most"},
        {LOAD("distribution = \"uniform\"; lower = 0; upper = 1; least = 2;"),
         "random[0].distribution: a uniform distribution has no probability between 2 and inf, where it is cut off"},
    };
    EXPECT_REFUSALS(mistakes);
}

static void expect_warnings(const char *text, const char *warnings)
{
    pdmc_study study;
    CHECK_OK(read_with(LINE_RANDOM, text, &study));
    assert_string_equal(study.warnings, warnings);
    pdmc_study_clear(&study);
}

// A fracture energy in space has any distribution, and one value where it has no length.
static void fracture_energies_in_space(void **state)
{
    (void)state;
    static const char *const mistakes[][2] = {
        {TOUGHNESS("covariance = \"gaussian\";"), "random[0].correlation_length: is missing, must be a real > 0"},
        {TOUGHNESS("smoothness = 2;"), "random[0].correlation_length: is missing, must be a real > 0"},
        {TOUGHNESS("correlation_length = 1; covariance = \"matern\";"),
         "random[0].smoothness: is missing, must be a real from 0.05 to 20 with covariance = \"matern\""},
        {TOUGHNESS("correlation_length = 1; smoothness = 2;"),
         "random[0].smoothness: is a setting of the covariance \"matern\" alone"},
        {TOUGHNESS("correlation_length = 0;"), "random[0].correlation_length: 0 is not allowed, must be > 0"},
        {TOUGHNESS("correlation_length = 1; modes = 3;"),
         "random[0].modes: is no setting of the quantity \"fracture_energy\""},
        {LOAD("correlation_length = 1;"), "random[0].correlation_length: is no setting of the quantity \"load\""},
    };
    EXPECT_REFUSALS(mistakes);
    pdmc_study study;
    CHECK_OK(read_with(LINE_RANDOM, TOUGHNESS("distribution = \"gumbel\"; correlation_length = 0.3;"), &study));
    assert_true(pdmc_problem_varies_toughness(&study.problem));
    assert_int_equal(study.problem.uncertainties[0].law.kind, PDMC_GUMBEL);
    CHECK_NEAR(study.problem.uncertainties[0].covariance.length, 0.3, 0.0);
    assert_string_equal(study.warnings, "");
    pdmc_study_clear(&study);
    CHECK_OK(read_with(LINE_RANDOM, TOUGHNESS("distribution = \"gumbel\";"), &study));
    assert_false(pdmc_problem_varies_toughness(&study.problem));
    pdmc_study_clear(&study);
    expect_warnings(TOUGHNESS("correlation_length = 1;") " energy = { tips = [\"a.to\"]; };",
                    "study.cfg:8: warning: random[0].correlation_length: changes nothing where energies are asked for "
                    "at a single tip\n");
}

static void fields_and_processes(void **state)
{
    (void)state;
    static const char *const mistakes[][2] = {
        {STIFFNESS(""), "random[0].correlation_length: is missing, must be a real > 0"},
        {STIFFNESS("correlation_length = 1; distribution = \"gamma\";"),
         "random[0].distribution: of a field must be \"normal\" or \"lognormal\""},
        {STIFFNESS("correlation_length = 1; covariance = \"matern\";"),
         "random[0].smoothness: is missing, must be a real from 0.05 to 20 with covariance = \"matern\""},
        {STIFFNESS("correlation_length = 1; smoothness = 2;"),
         "random[0].smoothness: is a setting of the covariance \"matern\" alone"},
        {STIFFNESS("correlation_length = 1;") " solver = { crack_model = \"visible\"; };",
         "random[0].quantity: a stiffness that varies in space has no gradient for the rows of a collocation, and needs "
         "an energy, must be with method = \"bond\" or crack_model = \"analytic\""},
        {STIFFNESS("correlation_length = 1; mean = 2;"), "random[0].mean: is no setting of the quantity \"stiffness\""},
        {"random = ( { quantity = \"micromodulus\"; model = \"radial_process\"; } );",
         "random[0].correlation_length: is missing, must be a real > 0"},
        {"random = ( { quantity = \"micromodulus\"; correlation_length = 1; } );",
         "random[0].correlation_length: is no setting of the model \"radial_noise\""},
    };
    EXPECT_REFUSALS(mistakes);
}

#define ONE(settings) "random = ( { " settings " } );"

// A plate that is held at the bottom and loaded at the top.
static pdmc_status read_held(const char *support, const char *random, pdmc_study *study)
{
    char text[1024];
    snprintf(text, sizeof text,
             "plate = { width = 6.0; height = 4.0; }; material = { youngs_modulus = 2.0; fracture_energy = 0.5; };\n"
             "cracks = ( { name = \"a\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );\n"
             "loads = ( { side = \"top\"; traction = [0, 1]; } ); supports = ( { side = \"bottom\"; %s } );\n%s",
             support, random);
    return read_text(text, study);
}

static void expect_held(int line, const char *support, const char *random, const char *refusal)
{
    pdmc_study study;
    char message[512];
    CHECK_STATUS(read_held(support, random, &study), PDMC_ERR_CONFIG);
    snprintf(message, sizeof message, "study.cfg:%d: %s", line, refusal);
    assert_string_equal(pdmc_last_error(), message);
}

// Loads of one side.
static void loads_of_a_side(void **state)
{
    (void)state;
    static const char *const free_plate[][2] = {
        {ONE("quantity = \"load_top\";"),
         "random[0].quantity: changes the load of one side of a plate that is free to follow, so that samples are not in "
         "equilibrium; hold the plate by supports"},
        {ONE("quantity = \"load_left\";"),
         "random[0].quantity: is of a side without a load, must be of one that has a traction"},
        {ONE("quantity = \"load_direction_top\";"),
         "random[0].distribution: has the mean 0, of which there is no variation, must have location and scale"},
        {ONE("quantity = \"load_noise_top\";"), "random[0].correlation_length: is missing, must be a real > 0"},
        {ONE("quantity = \"load_noise_top\"; correlation_length = 1; distribution = \"normal\";"),
         "random[0].distribution: is no setting of the quantity \"load_noise_top\""},
        {ONE("quantity = \"load_top\"; modes = 3;"), "random[0].modes: is no setting of the quantity \"load_top\""},
    };
    EXPECT_REFUSALS(free_plate);
    const char *noise = ONE("quantity = \"load_noise_top\"; correlation_length = 2; variation = 0.1; modes = 7;");
    const char *both = "random = ( { quantity = \"load_noise_top\"; correlation_length = 2; },\n"
                       "{ quantity = \"load_direction_top\"; location = 0; scale = 5; } );";
    const char *turned = ONE("quantity = \"load_direction_top\"; location = 0; scale = 5;");
    expect_held(5, "x = 0; y = 0;", both,
                "random[1].quantity: turns a load that has noise along its side, one of the two must go");
    expect_held(4, "y = 0;", turned,
                "random[0].quantity: changes the load of one side of a plate that is free to follow, so that samples are not in "
                "equilibrium; hold the plate by supports");
    pdmc_study study;
    CHECK_OK(read_held("y = 0;", noise, &study));
    const pdmc_uncertainty *u = pdmc_problem_uncertainty(&study.problem, PDMC_QUANTITY_LOAD_NOISE_TOP);
    assert_int_equal(u->modes, 7);
    CHECK_NEAR(u->variation, 0.1, 0.0);
    CHECK_NEAR(u->covariance.length, 2.0, 0.0);
    assert_string_equal(study.warnings, "");
    pdmc_study_clear(&study);
    CHECK_OK(read_held("x = 0; y = 0;", turned, &study));
    pdmc_study_clear(&study);
    CHECK_OK(read_held("y = 0;", ONE("quantity = \"load_noise_top\"; correlation_length = 0.001;"), &study));
    assert_non_null(strstr(study.warnings, "random[0].correlation_length: 0.001 is below the spacing"));
    pdmc_study_clear(&study);
    CHECK_OK(read_held("y = 0;", ONE("quantity = \"load_top\"; variation = 0.9;"), &study)); // of any sign
    assert_string_equal(study.warnings, "");
    pdmc_study_clear(&study);
}

#define PAIR "random = ( { quantity = \"load\"; }, { quantity = \"thickness\"; } ); "

static void correlations_of_what_is_not_there(void **state)
{
    (void)state;
    static const char *const mistakes[][2] = {
        {PAIR "correlations = ( { first = \"load\"; second = \"youngs_modulus\"; correlation = 0.1; } );",
         "correlations[0].second: is no quantity of random with a distribution of its own, must be one"},
        {PAIR "correlations = ( { first = \"load\"; second = \"load\"; correlation = 0.1; } );",
         "correlations[0].second: must be another quantity than first"},
        {PAIR "correlations = ( { first = \"load\"; second = \"thickness\"; correlation = 1; } );",
         "correlations[0].correlation: 1 is not allowed, must be > -1 and < 1"},
        {PAIR "correlations = ( { first = \"load\"; second = \"thickness\"; correlation = 0.1; },"
              " { first = \"thickness\"; second = \"load\"; correlation = 0.1; } );",
         "correlations[1].second: there already, must be once for each pair"},
        {"random = ( { quantity = \"load\"; }, { quantity = \"thickness\"; }, { quantity = \"youngs_modulus\"; } ); "
         "correlations = ( { first = \"load\"; second = \"thickness\"; correlation = 0.9; },"
         " { first = \"load\"; second = \"youngs_modulus\"; correlation = 0.9; },"
         " { first = \"thickness\"; second = \"youngs_modulus\"; correlation = -0.9; } );",
         "correlations: they contradict each other: no quantities can have all of them"},
    };
    EXPECT_REFUSALS(mistakes);
}

static void designs_and_rare_events(void **state)
{
    (void)state;
    static const char *const mistakes[][2] = {
        {LOAD("") " sampling = { design = \"sobol\"; samples = 1000; };",
         "sampling.samples: 1000 is not allowed, must be a multiple of the 16 replicates of the design, such as 1008"},
        {LOAD("") " sampling = { design = \"latin_hypercube\"; samples = 96; target = \"mean\"; };",
         "sampling.target: a Latin hypercube's points depend on their number, which a target leaves open, must have "
         "design = \"monte_carlo\" or \"sobol\""},
        {LOAD("") " sampling = { replicates = 8; };", "sampling.replicates: is no setting of the design \"monte_carlo\""},
        {LOAD("") " sampling = { relative_error = 0.1; };",
         "sampling.relative_error: is no setting of the target \"none\""},
        {LOAD("") " sampling = { most_samples = 5000; };",
         "sampling.most_samples: is no setting of the target \"none\""},
        {LOAD("") " sampling = { samples = 100; most_samples = 99; target = \"mean\"; };",
         "sampling.most_samples: 99 is not allowed, must be at least the 100 samples"},
        {LOAD("") " sampling = { design = \"sobol\"; samples = 96; most_samples = 1000; target = \"mean\"; };",
         "sampling.most_samples: 1000 is not allowed, must be a multiple of the 16 replicates of the design"},
        {LOAD("") " energy = { tips = []; }; sampling = { target = \"mean\"; };",
         "sampling.target: there is no tip whose energy could be known, must be \"none\""},
        {LOAD("") " reliability = { variation = 0; };",
         "reliability.variation: 0 is not allowed, must be > 0 and <= 1"},
        {LOAD("") " reliability = { sensitivity = 1; };",
         "reliability.sensitivity: 1 is not allowed, must be 0 or from 2 to 10000000"},
        {"reliability = { method = \"both\"; };",
         "reliability.method: nothing is random, must have a list of random quantities"},
        {"reliability = { sensitivity = 100; };",
         "reliability.sensitivity: nothing is random, must have a list of random quantities"},
    };
    EXPECT_REFUSALS(mistakes);
    pdmc_study study;
    CHECK_OK(read_with(
        LINE_RANDOM, LOAD("") " sampling = { design = \"latin_hypercube\"; samples = 90; replicates = 9; };", &study));
    assert_int_equal(study.problem.sampling.design, PDMC_DESIGN_LATIN_HYPERCUBE);
    assert_int_equal(study.problem.sampling.replicates, 9);
    pdmc_study_clear(&study);
}

// Phi(-2) = 0.0228 of a normal with half of its mean for a deviation; a load may have any sign.
static void values_that_are_not_positive(void **state)
{
    (void)state;
    expect_warnings("random = ( { quantity = \"thickness\"; variation = 0.5; } );",
                    "study.cfg:8: warning: random[0].distribution: has values that are not positive with probability "
                    "0.0228\n");
    expect_warnings("random = ( { quantity = \"thickness\"; variation = 0.5; least = 0; } );", "");
    expect_warnings("random = ( { quantity = \"fracture_energy\"; variation = 0.2; } );", "");
    expect_warnings("random = ( { quantity = \"fracture_energy\"; variation = 0.9; distribution = \"lognormal\"; } );",
                    "");
    expect_warnings(LOAD("variation = 0.5;"), "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_mean_and_variation),
        cmocka_unit_test(by_their_own_parameters),
        cmocka_unit_test(means_are_those_of_plate_and_material),
        cmocka_unit_test(parameters_that_make_no_distribution),
        cmocka_unit_test(fracture_energies_in_space),
        cmocka_unit_test(fields_and_processes),
        cmocka_unit_test(loads_of_a_side),
        cmocka_unit_test(correlations_of_what_is_not_there),
        cmocka_unit_test(designs_and_rare_events),
        cmocka_unit_test(values_that_are_not_positive),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
