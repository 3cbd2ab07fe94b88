// SPDX-License-Identifier: GPL-3.0-or-later

/// The distribution of a scalar, from the parameters that the file gives: mean and variation, or the distribution's own.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

#define BIT(parameter) (1U << (PDMC_PARAMETER_##parameter))
#define MOMENTS (BIT(MEAN) | BIT(VARIATION))
#define CUTS (BIT(LEAST) | BIT(MOST))

static const double default_variation = 0.20;

static const struct {
    const char *name;
    bool by_moments;
    unsigned own;           // its own parameters, all of which are needed
    const char *parameters; // what they are called
} families[PDMC_DISTRIBUTIONS] = {
    [PDMC_NORMAL] = {"normal", true, BIT(LOCATION) | BIT(SCALE), "location and scale"},
    [PDMC_LOGNORMAL] = {"lognormal", true, BIT(MEDIAN) | BIT(LOG_DEVIATION), "median and log_deviation"},
    [PDMC_WEIBULL] = {"weibull", true, BIT(SCALE) | BIT(SHAPE), "scale and shape"},
    [PDMC_GUMBEL] = {"gumbel", true, BIT(LOCATION) | BIT(SCALE), "location and scale"},
    [PDMC_GAMMA] = {"gamma", true, BIT(SCALE) | BIT(SHAPE), "scale and shape"},
    [PDMC_BETA] = {"beta", false, BIT(LOWER) | BIT(UPPER) | BIT(ALPHA) | BIT(BETA), "lower, upper, alpha and beta"},
    [PDMC_UNIFORM] = {"uniform", true, BIT(LOWER) | BIT(UPPER), "lower and upper"},
    [PDMC_TRIANGULAR] = {"triangular", false, BIT(LOWER) | BIT(MODE) | BIT(UPPER), "lower, mode and upper"},
    [PDMC_EMPIRICAL] = {"empirical", false, 0, "values"},
};

static unsigned given_bits(const pdmc_parameters *given)
{
    unsigned bits = 0;
    for (unsigned k = 0; k < PDMC_PARAMETERS; k++)
        if (given->has[k]) bits |= 1U << k;
    return bits & ~CUTS;
}

// The keys of a distribution that the file gives: "mean, scale".
static void print_given(FILE *out, const pdmc_uncertainty *u)
{
    const size_t first = offsetof(pdmc_uncertainty, given.has);
    int count = 0;
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++) {
        if (s->section != SECTION_RANDOM) continue;
        const bool is_values = s->kind == KIND_REALS && u->value_count > 0;
        const bool is_parameter = first <= s->flag && s->flag < first + PDMC_PARAMETERS;
        if (is_values || (is_parameter && given_bits(&u->given) & 1U << (s->flag - first)))
            fprintf(out, "%s%s", count++ ? ", " : "", s->key);
    }
    if (count == 0) fputs("no parameters", out);
}

static pdmc_status refuse_parameters(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    pdmc_study_text message;
    const pdmc_status status =
        pdmc_study_refusal_begin(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"}, &message);
    if (status != PDMC_OK) return status;
    fprintf(message.out, "\"%s\" with ", families[u->distribution].name);
    print_given(message.out, u);
    fprintf(message.out, " is not allowed, must have %s%s",
            families[u->distribution].by_moments ? "mean and variation, or " : "",
            families[u->distribution].parameters);
    return pdmc_study_refusal_end(&message);
}

static double parameter(const pdmc_uncertainty *u, pdmc_parameter which, double otherwise)
{
    return u->given.has[which] ? u->given.value[which] : otherwise;
}

static pdmc_status law_by_moments(const pdmc_study_reader *reader, int index)
{
    pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const double mean = parameter(u, PDMC_PARAMETER_MEAN, pdmc_problem_nominal(reader->problem, u->quantity));
    if (!u->given.has[PDMC_PARAMETER_VARIATION]) {
        u->given.has[PDMC_PARAMETER_VARIATION] = true;
        u->given.value[PDMC_PARAMETER_VARIATION] = default_variation;
    }
    if (mean == 0.0 && u->given.value[PDMC_PARAMETER_VARIATION] != 0.0)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"},
                                 "has the mean 0, of which there is no variation, must have %s",
                                 families[u->distribution].parameters);
    const pdmc_status status =
        pdmc_distribution_by_moments(u->distribution, mean, u->given.value[PDMC_PARAMETER_VARIATION], &u->law);
    if (status == PDMC_OK) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"}, "%s",
                             pdmc_last_error());
}

static void law_by_parameters(pdmc_uncertainty *u)
{
    u->law = (pdmc_distribution){
        .kind = u->distribution,
        .location = parameter(u, PDMC_PARAMETER_LOCATION, 0.0),
        .scale = parameter(u, PDMC_PARAMETER_SCALE, 0.0),
        .shape = parameter(u, PDMC_PARAMETER_SHAPE, 0.0),
        .lower = parameter(u, PDMC_PARAMETER_LOWER, 0.0),
        .upper = parameter(u, PDMC_PARAMETER_UPPER, 0.0),
        .mode = parameter(u, PDMC_PARAMETER_MODE, 0.0),
        .alpha = parameter(u, PDMC_PARAMETER_ALPHA, 0.0),
        .beta = parameter(u, PDMC_PARAMETER_BETA, 0.0),
    };
    if (u->distribution != PDMC_LOGNORMAL) return;
    u->law.location = log(u->given.value[PDMC_PARAMETER_MEDIAN]);
    u->law.scale = u->given.value[PDMC_PARAMETER_LOG_DEVIATION];
}

static pdmc_status sort_values(pdmc_uncertainty *u)
{
    u->law = (pdmc_distribution){.kind = PDMC_EMPIRICAL, .count = u->value_count};
    u->law.values = pdmc_calloc((size_t)u->value_count, sizeof *u->values);
    if (!u->law.values) return PDMC_ERR_NOMEM;
    memcpy(u->law.values, u->values, (size_t)u->value_count * sizeof *u->values);
    gsl_sort(u->law.values, 1, (size_t)u->value_count);
    return PDMC_OK;
}

pdmc_status pdmc_study_make_law(const pdmc_study_reader *reader, int index)
{
    pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const unsigned given = given_bits(&u->given), own = families[u->distribution].own;
    const bool is_empirical = u->distribution == PDMC_EMPIRICAL;
    const bool by_moments = families[u->distribution].by_moments && (given & ~MOMENTS) == 0;
    if (is_empirical != (u->value_count > 0) || (!by_moments && given != own)) return refuse_parameters(reader, index);
    pdmc_status status = PDMC_OK;
    if (is_empirical) status = sort_values(u);
    else if (by_moments) status = law_by_moments(reader, index);
    else law_by_parameters(u);
    if (status != PDMC_OK) return status;
    u->law.least = parameter(u, PDMC_PARAMETER_LEAST, -INFINITY);
    u->law.most = parameter(u, PDMC_PARAMETER_MOST, INFINITY);
    if (pdmc_distribution_check(&u->law) == PDMC_OK) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"}, "%s",
                             pdmc_last_error());
}
