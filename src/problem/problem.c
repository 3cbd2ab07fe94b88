// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/problem.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <gsl/gsl_math.h>
#include <math.h>

void pdmc_problem_clear(pdmc_problem *problem)
{
    pdmc_free(problem->title);
    pdmc_free(problem->length_unit);
    pdmc_free(problem->force_unit);
    pdmc_free(problem->time_unit);
    pdmc_free(problem->cracks);
    pdmc_free(problem->loads);
    pdmc_free(problem->supports);
    pdmc_free(problem->history);
    pdmc_free(problem->probes);
    for (int i = 0; problem->uncertainties && i < problem->uncertainty_count; i++) {
        pdmc_free(problem->uncertainties[i].values);
        pdmc_free(problem->uncertainties[i].law.values);
    }
    pdmc_free(problem->uncertainties);
    pdmc_free(problem->correlations);
    pdmc_free(problem->energy.tips);
    *problem = (pdmc_problem){0};
}

const pdmc_uncertainty *pdmc_problem_uncertainty(const pdmc_problem *problem, pdmc_quantity quantity)
{
    for (int i = 0; i < problem->uncertainty_count; i++)
        if (problem->uncertainties[i].quantity == quantity) return &problem->uncertainties[i];
    return NULL;
}

double pdmc_problem_nominal(const pdmc_problem *problem, pdmc_quantity quantity)
{
    const pdmc_uncertainty *uncertainty = pdmc_problem_uncertainty(problem, quantity);
    const pdmc_crack *crack = uncertainty && problem->cracks ? &problem->cracks[uncertainty->crack] : NULL;
    if (pdmc_is_of_bodies(problem->kind)) return 1.0;
    switch (quantity) {
    case PDMC_QUANTITY_CRACK_LENGTH:
        return crack ? hypot(crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]) : 0.0;
    case PDMC_QUANTITY_LOAD_DIRECTION_LEFT:
    case PDMC_QUANTITY_LOAD_DIRECTION_RIGHT:
    case PDMC_QUANTITY_LOAD_DIRECTION_BOTTOM:
    case PDMC_QUANTITY_LOAD_DIRECTION_TOP:
    case PDMC_QUANTITY_CRACK_ANGLE:
    case PDMC_QUANTITY_CRACK_X:
    case PDMC_QUANTITY_CRACK_Y: return 0.0;
    case PDMC_QUANTITY_YOUNGS_MODULUS: return problem->material.youngs_modulus;
    case PDMC_QUANTITY_FRACTURE_ENERGY: return problem->material.fracture_energy;
    case PDMC_QUANTITY_THICKNESS: return problem->plate.thickness;
    default: return 1.0;
    }
}

bool pdmc_problem_varies_toughness(const pdmc_problem *problem)
{
    const pdmc_uncertainty *uncertainty = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_FRACTURE_ENERGY);
    return uncertainty && uncertainty->has_length;
}

bool pdmc_problem_moves_sides(const pdmc_problem *problem)
{
    for (int s = 0; s < problem->support_count; s++)
        if (problem->supports[s].displacement[0] != 0.0 || problem->supports[s].displacement[1] != 0.0) return true;
    return false;
}

void pdmc_problem_correlation(const pdmc_problem *problem, double matrix[])
{
    for (int i = 0; i < PDMC_SCALARS; i++)
        for (int j = 0; j < PDMC_SCALARS; j++) matrix[i * PDMC_SCALARS + j] = i == j;
    for (int k = 0; k < problem->correlation_count; k++) {
        const pdmc_correlation *pair = &problem->correlations[k];
        const int i = (int)pair->first - PDMC_FIRST_SCALAR, j = (int)pair->second - PDMC_FIRST_SCALAR;
        matrix[i * PDMC_SCALARS + j] = matrix[j * PDMC_SCALARS + i] = pair->correlation;
    }
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

int pdmc_problem_kept(const pdmc_problem *problem)
{
    const pdmc_sampling *sampling = &problem->sampling;
    const bool is_all = sampling->design != PDMC_DESIGN_MONTE_CARLO || sampling->samples < sampling->keep;
    return is_all ? sampling->samples : sampling->keep;
}

int pdmc_problem_steps(const pdmc_problem *problem)
{
    const double steps = problem->dynamics.duration / problem->dynamics.step;
    return (int)ceil(steps * (1.0 - 1e-9)); // a whole number of steps that were written in decimals stays whole
}

int pdmc_problem_crack_at(const pdmc_problem *problem, const double x[2])
{
    const double near = 1e-9 * (problem->plate.width + problem->plate.height);
    for (int c = 0; c < problem->crack_count; c++)
        if (pdmc_point_segment_distance(x, problem->cracks[c].from, problem->cracks[c].to) <= near) return c;
    return -1;
}

double pdmc_wave_speed(const pdmc_material *material, double density)
{
    const double shear_modulus = 0.5 * material->youngs_modulus / (1.0 + pdmc_poissons_ratio(material->assumption));
    return sqrt(3.0 * shear_modulus / density);
}

bool pdmc_problem_is_tip(const pdmc_problem *problem, int tip)
{
    const double *end = pdmc_crack_end(problem->cracks, tip);
    return fabs(end[0]) < 0.5 * problem->plate.width && fabs(end[1]) < 0.5 * problem->plate.height;
}

void pdmc_problem_crack_inside(const pdmc_problem *problem, int crack, double ends[2][2])
{
    const double *from = problem->cracks[crack].from, *to = problem->cracks[crack].to;
    const double half[2] = {0.5 * problem->plate.width, 0.5 * problem->plate.height};
    double share[2] = {0.0, 1.0}; // of the way from `from` to `to`
    for (int k = 0; k < 2; k++) {
        const double step = to[k] - from[k];
        if (step == 0.0) continue;
        const double a = (-half[k] - from[k]) / step, b = (half[k] - from[k]) / step;
        share[0] = fmax(share[0], fmin(a, b));
        share[1] = fmin(share[1], fmax(a, b));
    }
    for (int end = 0; end < 2; end++)
        for (int k = 0; k < 2; k++) ends[end][k] = from[k] + share[end] * (to[k] - from[k]);
    for (int k = 0; k < 2; k++) // without rounding
        if (share[1] == 1.0) ends[1][k] = to[k];
}

pdmc_mesh_plate pdmc_problem_mesh_plate(const pdmc_problem *problem, pdmc_slit slits[])
{
    for (int c = 0; c < problem->crack_count; c++)
        for (int i = 0; i < 2; i++) {
            slits[c].from[i] = problem->cracks[c].from[i];
            slits[c].to[i] = problem->cracks[c].to[i];
        }
    return (pdmc_mesh_plate){.width = problem->plate.width,
                             .height = problem->plate.height,
                             .spacing = problem->solver.spacing,
                             .fine_spacing = problem->solver.spacing,
                             .slit_count = problem->crack_count,
                             .slits = slits};
}
