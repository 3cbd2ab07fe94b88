// SPDX-License-Identifier: GPL-3.0-or-later

/// The two problems of section 2.5: the volume of the horizon, and the stress at a node of an infinite body.

#include "pdmc/horizon_study.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static const struct {
    pdmc_horizon_kind kind;
    int gauss_points;
} rules[PDMC_HORIZON_RULES] = {{PDMC_RULE_CUBIC, 1}, {PDMC_RULE_GAUSS, 2}, {PDMC_RULE_GAUSS, 3},
                               {PDMC_RULE_GAUSS, 4}, {PDMC_RULE_EXACT, 1}, {PDMC_RULE_ADAPTIVE, 1}};
const char *const pdmc_horizon_rule_names[PDMC_HORIZON_RULES] = {"cubic",  "gauss2", "gauss3",
                                                                 "gauss4", "exact",  "adaptive"};

void pdmc_horizon_study_clear(pdmc_horizon_study *study)
{
    pdmc_free(study->ratios);
    *study = (pdmc_horizon_study){0};
}

pdmc_horizon_options pdmc_horizon_study_options(const pdmc_horizon_study *study, int rule, double ratio)
{
    pdmc_horizon_options o =
        pdmc_horizon_options_default(rules[rule].kind, study->dimension, study->horizon, study->horizon / ratio);
    o.gauss_points = rules[rule].gauss_points;
    o.adaptive =
        (pdmc_adaptive){study->accuracy, study->threshold, study->start, study->most, study->extrapolates != 0};
    return o;
}

static double volume_of(const pdmc_horizon_study *study)
{
    const double square = study->horizon * study->horizon;
    return study->dimension == 3 ? 4.0 / 3.0 * pi * square * study->horizon : pi * square;
}

static double distance(const pdmc_horizon_study *study, double volume, double points)
{
    return pow(volume / points, 1.0 / study->dimension);
}

static pdmc_status measure_volume(const pdmc_horizon_study *study, const pdmc_horizon_options *options,
                                  pdmc_horizon_outcome *outcome)
{
    pdmc_horizon_rule rule;
    const pdmc_status status = pdmc_horizon_rule_create(options, &rule);
    if (status != PDMC_OK) return status;
    outcome->error = pdmc_horizon_rule_volume(&rule) / volume_of(study) - 1.0;
    outcome->points = rule.point_count;
    outcome->distance = distance(study, volume_of(study), rule.point_count);
    for (int i = 0; i < 9; i++) outcome->stress[i] = NAN;
    pdmc_horizon_rule_clear(&rule);
    return PDMC_OK;
}

void pdmc_horizon_study_stress(const pdmc_horizon_study *study, double stress[9])
{
    static const int place[] = {0, 4, 8, 5, 2, 1}, mirrored[] = {0, 4, 8, 7, 6, 3};
    for (int c = 0; c < PDMC_STRESS_COMPONENTS; c++) stress[place[c]] = stress[mirrored[c]] = study->stress[c];
}

/// u = e x of the infinite body, e [3, 3].
static void displacement(void *context, const double x[3], double u[3])
{
    const double *e = context;
    for (int i = 0; i < 3; i++) u[i] = e[3 * i] * x[0] + e[3 * i + 1] * x[1] + e[3 * i + 2] * x[2];
}

/// Poisson's ratio is 1/4 in space and 1/3 in plane stress; what a plate does along its thickness is not a bond's
/// concern.
static void strain_of(const pdmc_horizon_study *study, const double stress[9], double strain[9])
{
    const double ratio = study->dimension == 3 ? 0.25 : 1.0 / 3.0, trace = stress[0] + stress[4] + stress[8];
    for (int i = 0; i < 9; i++)
        strain[i] = ((1.0 + ratio) * stress[i] - (i % 4 == 0 ? ratio * trace : 0.0)) / study->youngs_modulus;
    if (study->dimension == 2) strain[8] = 0.0;
}

static pdmc_status measure_stress(const pdmc_horizon_study *study, const pdmc_horizon_options *options,
                                  pdmc_horizon_outcome *outcome)
{
    double exact[9], strain[9], largest = 0.0, error = 0.0;
    const double cube = study->horizon * study->horizon * study->horizon, node[3] = {0.0};
    const double c = study->dimension == 3 ? 12.0 / (pi * cube * study->horizon) : 9.0 / (pi * cube); // over E
    pdmc_stress_effort effort;
    pdmc_horizon_study_stress(study, exact);
    strain_of(study, exact, strain);
    const pdmc_bonded_body body = {c * study->youngs_modulus, study->profile, study->stretch == PDMC_BOND_STRETCH_LINEAR,
                                   displacement, strain};
    const pdmc_status status = pdmc_horizon_stress(options, &body, node, outcome->stress, &effort);
    if (status != PDMC_OK) return status;
    for (int i = 0; i < 9; i++) {
        error = fmax(error, fabs(outcome->stress[i] - exact[i]));
        largest = fmax(largest, fabs(exact[i]));
    }
    outcome->error = error / largest;
    outcome->points = effort.half_points;
    outcome->distance = distance(study, 0.5 * volume_of(study), effort.half_points);
    return PDMC_OK;
}

pdmc_status pdmc_horizon_study_measure(const pdmc_horizon_study *study, int rule, double ratio,
                                       pdmc_horizon_outcome *outcome)
{
    PDMC_REQUIRE(0 <= rule && rule < PDMC_HORIZON_RULES, "rule = %d not in [0, %d)", rule, PDMC_HORIZON_RULES);
    const pdmc_horizon_options options = pdmc_horizon_study_options(study, rule, ratio);
    return (study->integral == PDMC_INTEGRAL_VOLUME ? measure_volume : measure_stress)(study, &options, outcome);
}
