// SPDX-License-Identifier: GPL-3.0-or-later

/// How often the intervals of a whole study hold the truth: 1000 studies that differ in their seeds, of a toy whose energy
/// and toughness are lognormal, so that every truth has a closed form.

#include "stochastic/toy.h"

#include <gsl/gsl_cdf.h>

enum { QUANTITIES = 3, SAMPLES = 1024 };

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
enum { STUDIES = 100 };
#else
enum { STUDIES = 1000 };
#endif

static const double load_deviation = 0.15, modulus_deviation = 0.1, toughness_deviation = 0.2; // of the logarithms
static const double growth = 0.05;                                                             // its probability

/// G = load^2 / E with median 1, of one direction.
typedef struct {
    toy base;
    pdmc_uncertainty quantities[QUANTITIES];
} lognormal_toy;

static double energy_deviation(void)
{
    return sqrt(4.0 * load_deviation * load_deviation + modulus_deviation * modulus_deviation);
}

static double toughness_location(void)
{
    return gsl_cdf_ugaussian_Qinv(growth) * hypot(energy_deviation(), toughness_deviation);
}

static void lognormal_toy_make(lognormal_toy *t, pdmc_design_kind design)
{
    toy_make(&t->base, 0.0, 0.0);
    t->quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_LOGNORMAL, 0.0, load_deviation);
    t->quantities[1] = toy_scalar(PDMC_QUANTITY_YOUNGS_MODULUS, PDMC_LOGNORMAL, 0.0, modulus_deviation);
    t->quantities[2] =
        toy_scalar(PDMC_QUANTITY_FRACTURE_ENERGY, PDMC_LOGNORMAL, toughness_location(), toughness_deviation);
    t->base.problem.uncertainties = t->quantities;
    t->base.problem.uncertainty_count = QUANTITIES;
    t->base.problem.energy.measure = PDMC_MEASURE_GRIFFITH;
    t->base.problem.sampling.samples = SAMPLES;
    t->base.problem.sampling.design = design;
    t->base.problem.sampling.replicates = PDMC_DESIGN_REPLICATES;
    t->base.model.angles = t->base.problem.energy.angles = 1;
}

typedef struct {
    const char *name;
    double truth;
    double least, most; // of the share of studies whose interval holds it
    int held, below;    // studies; of those that miss, those whose interval is below the truth
} covered;

enum { MEAN, QUANTILE, COUNT, CONDITIONAL, ESTIMATES };

static void note(covered *c, pdmc_estimate estimate)
{
    c->held += estimate.lower <= c->truth && c->truth <= estimate.upper;
    c->below += estimate.upper < c->truth;
}

static void repeat(pdmc_design_kind design, covered estimates[ESTIMATES])
{
    lognormal_toy t;
    lognormal_toy_make(&t, design);
    for (int k = 0; k < STUDIES; k++) {
        pdmc_results r;
        t.base.problem.sampling.seed = (uint64_t)k + 1;
        CHECK_OK(toy_run(&t.base, &one_thread, &r));
        const pdmc_energy_statistics *griffith = &r.statistics[PDMC_MEASURE_GRIFFITH];
        note(&estimates[MEAN], griffith->mean[0]);
        note(&estimates[QUANTILE], griffith->quantiles[PDMC_QUANTILES - 1]);
        note(&estimates[COUNT], r.probability[0]);
        note(&estimates[CONDITIONAL], r.conditional_probability[0]);
        pdmc_results_clear(&r);
    }
}

/// The share of `STUDIES` is known to four of its deviations beyond the bounds.
static void check(const char *design, const covered estimates[ESTIMATES])
{
    const double chance = STUDIES < 1000 ? 4.0 * sqrt(0.05 * 0.95 / STUDIES) : 0.0;
    for (int e = 0; e < ESTIMATES; e++) {
        const covered *c = &estimates[e];
        const double held = (double)c->held / STUDIES;
        printf("  %-16s %-24s held %.3f, below %.3f\n", design, c->name, held, (double)c->below / STUDIES);
        if (held < c->least - chance || held > c->most + chance)
            fail_msg("%s of %s held in %.3f, not in [%g, %g]", c->name, design, held, c->least, c->most);
    }
}

static void intervals_hold(const char *name, pdmc_design_kind design)
{
    const double spread = energy_deviation(), ninety_five = gsl_cdf_ugaussian_Pinv(0.95);
    covered estimates[ESTIMATES] = {
        [MEAN] = {"mean", exp(0.5 * spread * spread), 0.93, 0.97, 0, 0},
        [QUANTILE] = {"95 % quantile", exp(ninety_five * spread), 0.93, 0.97, 0, 0},
        [COUNT] = {"P of growth", growth, 0.93, 0.97, 0, 0},
        [CONDITIONAL] = {"P, load integrated", growth, 0.93, 0.97, 0, 0},
    };
    repeat(design, estimates);
    check(name, estimates);
}

static void of_independent_samples(void **state)
{
    (void)state;
    intervals_hold("independent", PDMC_DESIGN_MONTE_CARLO);
}

static void of_latin_hypercubes(void **state)
{
    (void)state;
    intervals_hold("Latin hypercube", PDMC_DESIGN_LATIN_HYPERCUBE);
}

static void of_sobol_sequences(void **state)
{
    (void)state;
    intervals_hold("Sobol'", PDMC_DESIGN_SOBOL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_independent_samples),
        cmocka_unit_test(of_latin_hypercubes),
        cmocka_unit_test(of_sobol_sequences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
