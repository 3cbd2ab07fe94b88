// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

/// The probability that a sample of c(r) has at least one negative bin, 1 - (1 - Phi(-1/v))^bins, without cancellation;
/// 0 for v = 0, Phi(-inf).
static double negative_probability(const pdmc_uncertainty *u)
{
    return -expm1(u->bins * log1p(-gsl_cdf_ugaussian_P(-1.0 / u->variation)));
}

static void warn_of_negative_bins(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const double harmless = 1e-6;
    if (u->quantity != PDMC_QUANTITY_MICROMODULUS) return;
    const double probability = negative_probability(u);
    if (probability > harmless)
        pdmc_study_warn(reader, (pdmc_study_address){SECTION_RANDOM, index, "variation"},
                        "%g in %d bins makes c(r) negative somewhere with probability %.3g a sample", u->variation,
                        u->bins, probability);
}

pdmc_status pdmc_study_check_random(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    for (int i = 0; i < p->uncertainty_count; i++) {
        for (int j = 0; j < i; j++)
            if (p->uncertainties[j].quantity == p->uncertainties[i].quantity)
                return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, i, "quantity"},
                                         "there already, must be once for each quantity");
        warn_of_negative_bins(reader, i);
    }
    return PDMC_OK;
}

pdmc_status pdmc_study_check_sampling(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_study_address at = {SECTION_SAMPLING, -1, "inverse"};
    const bool is_reduced = p->sampling.inverse == PDMC_INVERSE_REDUCED;
    if (p->sampling.inverse != PDMC_INVERSE_KRYLOV && !is_reduced) return PDMC_OK;
    if (p->solver.method != PDMC_METHOD_BOND)
        return pdmc_study_refuse(reader, at,
                                 "\"%s\" needs the symmetric matrix of method = \"bond\", must be "
                                 "\"direct\" or \"neumann\"",
                                 is_reduced ? "reduced" : "krylov");
    for (int s = 0; s < p->support_count && is_reduced; s++)
        if (p->supports[s].displacement[0] != 0.0 || p->supports[s].displacement[1] != 0.0)
            return pdmc_study_refuse(reader, at,
                                     "\"reduced\" has no prescribed displacements but 0 yet, must be "
                                     "\"direct\", \"neumann\" or \"krylov\"");
    return PDMC_OK;
}
