// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/problem.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

void pdmc_problem_clear(pdmc_problem *problem)
{
    pdmc_free(problem->title);
    pdmc_free(problem->length_unit);
    pdmc_free(problem->force_unit);
    pdmc_free(problem->cracks);
    pdmc_free(problem->loads);
    pdmc_free(problem->supports);
    pdmc_free(problem->uncertainties);
    pdmc_free(problem->energy.tips);
    *problem = (pdmc_problem){0};
}

const pdmc_uncertainty *pdmc_problem_uncertainty(const pdmc_problem *problem, pdmc_quantity quantity)
{
    for (int i = 0; i < problem->uncertainty_count; i++)
        if (problem->uncertainties[i].quantity == quantity) return &problem->uncertainties[i];
    return NULL;
}

double pdmc_poissons_ratio(pdmc_assumption assumption)
{
    return assumption == PDMC_PLANE_STRESS ? 1.0 / 3.0 : 0.25;
}

double pdmc_plane_modulus(const pdmc_material *material)
{
    if (material->assumption == PDMC_PLANE_STRESS) return material->youngs_modulus;
    const double nu = pdmc_poissons_ratio(PDMC_PLANE_STRAIN);
    return material->youngs_modulus / (1.0 - nu * nu);
}

double pdmc_micromodulus(const pdmc_material *material, double horizon)
{
    const double factor = material->assumption == PDMC_PLANE_STRESS ? 9.0 : 48.0 / 5.0;
    return factor * material->youngs_modulus / (M_PI * pow(horizon, 3));
}
