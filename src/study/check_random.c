// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include "base/base_impl.h"

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

// A fracture energy is a field where the study says anything of its correlation.
static bool needs_covariance(const pdmc_uncertainty *u)
{
    switch (u->quantity) {
    case PDMC_QUANTITY_MICROMODULUS: return u->model == PDMC_RADIAL_PROCESS;
    case PDMC_QUANTITY_FRACTURE_ENERGY:
        return u->has_length || u->has_smoothness || u->covariance.kind != PDMC_COVARIANCE_EXPONENTIAL;
    default: return u->quantity < PDMC_FIRST_SCALAR;
    }
}

static pdmc_status check_covariance(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const bool needs = needs_covariance(u);
    const bool has_smoothness = needs && u->covariance.kind == PDMC_COVARIANCE_MATERN;
    if (needs && !u->has_length)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "correlation_length"},
                                 "is missing, must be a real > 0");
    if (!needs && u->has_length)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "correlation_length"},
                                 "is no setting of the model \"radial_noise\"");
    if (u->has_smoothness && !has_smoothness)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "smoothness"},
                                 "is a setting of the covariance \"matern\" alone");
    if (has_smoothness && !u->has_smoothness)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "smoothness"},
                                 "is missing, must be a real from 0.05 to 20 with covariance = \"matern\"");
    return PDMC_OK;
}

// The rows of a collocation hold the gradient of the stiffness, which a rough field does not have, and are 7 % wrong for a
// wave of four half lengths of the crack. Energies hold the stiffness alone: those of bonds, and the weak form.
static pdmc_status check_stiffness(const pdmc_study_reader *reader, int index)
{
    const pdmc_solver_options *solver = &reader->problem->solver;
    const bool has_energy = solver->method == PDMC_METHOD_BOND ||
                            (solver->method == PDMC_METHOD_KANSA && solver->crack_model == PDMC_CRACKS_ANALYTIC);
    if (reader->problem->uncertainties[index].quantity != PDMC_QUANTITY_STIFFNESS || has_energy) return PDMC_OK;
    if (solver->method == PDMC_METHOD_GALERKIN)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "quantity"},
                                 "\"stiffness\" is not known to method = \"galerkin\" yet, must be with method = \"bond\" or "
                                 "crack_model = \"analytic\"");
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "quantity"},
                             "a stiffness that varies in space has no gradient for the rows of a collocation, and needs an "
                             "energy, must be with method = \"bond\" or crack_model = \"analytic\"");
}

// c(r), the stiffness, and noise along a side: functions with a variation at every point.
static pdmc_status check_function(const pdmc_study_reader *reader, int index)
{
    pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    if (!u->given.has[PDMC_PARAMETER_VARIATION]) u->given.value[PDMC_PARAMETER_VARIATION] = 0.20;
    u->given.has[PDMC_PARAMETER_VARIATION] = true;
    u->variation = u->given.value[PDMC_PARAMETER_VARIATION];
    if (u->distribution != PDMC_NORMAL && u->distribution != PDMC_LOGNORMAL)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"},
                                 "of a field must be \"normal\" or \"lognormal\"");
    warn_of_negative_bins(reader, index);
    const pdmc_status status = check_stiffness(reader, index);
    return status == PDMC_OK ? check_covariance(reader, index) : status;
}

// What a random load of one side asks of the plate; shorter waves than the method's points have it cannot see.
static pdmc_status check_load(const pdmc_study_reader *reader, int index)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_uncertainty *u = &p->uncertainties[index];
    const pdmc_study_address at = {SECTION_RANDOM, index, "quantity"};
    const pdmc_status status = pdmc_problem_check_random_load(p, u->quantity);
    if (status == PDMC_ERR_CONFIG) return pdmc_study_refuse(reader, at, "%s", pdmc_last_error());
    if (status != PDMC_OK) return status;
    if (pdmc_is_of_sides(u->quantity, PDMC_QUANTITY_LOAD_NOISE_LEFT) && u->covariance.length < p->solver.spacing)
        pdmc_study_warn(reader, (pdmc_study_address){SECTION_RANDOM, index, "correlation_length"},
                        "%g is below the spacing %g, in which the load is constant: noise that is shorter counts too much",
                        u->covariance.length, p->solver.spacing);
    return PDMC_OK;
}

// What must be positive is seldom otherwise.
static bool may_be_negative(pdmc_quantity quantity)
{
    return quantity == PDMC_QUANTITY_LOAD || quantity >= PDMC_QUANTITY_LOAD_LEFT; // all of loads and of cracks
}

static void warn_of_negative_values(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const double harmless = 1e-6, probability = pdmc_distribution_lower_tail(&u->law, 0.0);
    if (may_be_negative(u->quantity) || probability <= harmless) return;
    pdmc_study_warn(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"},
                    "has values that are not positive with probability %.3g", probability);
}

static void warn_of_short_cracks(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const double harmless = 1e-6, least = 2.0 * pdmc_problem_least_half_crack(reader->problem);
    const double probability = pdmc_distribution_lower_tail(&u->law, least);
    if (u->quantity == PDMC_QUANTITY_CRACK_LENGTH && probability > harmless)
        pdmc_study_warn(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"},
                        "is below %g, too short for the solver, with probability %.3g: such samples fail", least,
                        probability);
}

// An end on an edge leaves it with the next sample, and is then another tip.
static void warn_of_mouths(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    const pdmc_plate *plate = &reader->problem->plate;
    const pdmc_crack *crack = &reader->problem->cracks[u->crack];
    for (int end = 0; end < 2; end++) {
        const double *x = end ? crack->to : crack->from;
        if (fabs(x[0]) != 0.5 * plate->width && fabs(x[1]) != 0.5 * plate->height) continue;
        pdmc_study_warn(
            reader, (pdmc_study_address){SECTION_RANDOM, index, "quantity"},
            "moves the end of \"%s\" that is on an edge: samples in which it is inside the plate fail, an end "
            "well beyond the edge stays outside",
            crack->name);
        return;
    }
}

static bool is_first_of_cracks(const pdmc_problem *p, int index)
{
    for (int i = 0; i < index; i++)
        if (p->uncertainties[i].quantity >= PDMC_FIRST_OF_CRACK) return false;
    return true;
}

// What a crack that moves asks of the solver.
static pdmc_status check_crack(const pdmc_study_reader *reader, int index)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_study_address at = {SECTION_RANDOM, index, "quantity"};
    if (p->solver.method == PDMC_METHOD_KANSA && p->solver.crack_model == PDMC_CRACKS_PAPER)
        return pdmc_study_refuse(reader, at,
                                 "needs a solution that converges, must not be with crack_model = \"paper\"");
    if (pdmc_problem_uncertainty(p, PDMC_QUANTITY_STIFFNESS))
        return pdmc_study_refuse(
            reader, at,
            "makes another plate of every sample, with other modes of the stiffness: one of the two "
            "must go");
    if (p->solver.method == PDMC_METHOD_GALERKIN && p->solver.mesh == PDMC_PLATE_CELLS &&
        p->uncertainties[index].quantity == PDMC_QUANTITY_CRACK_ANGLE)
        return pdmc_study_refuse(reader, at,
                                 "turns a crack, and the elements of method = \"galerkin\" need it parallel to a side");
    if (p->solver.method == PDMC_METHOD_GALERKIN && p->solver.mesh == PDMC_PLATE_TRIANGLES)
        return pdmc_study_refuse(reader, at, "makes another mesh of every sample, which mesh = \"triangles\" does not yet");
    if (p->solver.method == PDMC_METHOD_BOND && is_first_of_cracks(p, index))
        pdmc_study_warn(reader, at,
                        "moves the crack between the nodes of a grid: energies jump by the bonds that it cuts, so that "
                        "design points and small changes are those of the grid");
    warn_of_short_cracks(reader, index);
    warn_of_mouths(reader, index);
    return PDMC_OK;
}

// Of bonds it is drawn in classes, all of which must be positive.
static pdmc_status check_strength(const pdmc_study_reader *reader, int index)
{
    const pdmc_uncertainty *u = &reader->problem->uncertainties[index];
    double strengths[PDMC_STRENGTH_CLASSES];
    if (u->quantity != PDMC_QUANTITY_BOND_STRENGTH || pdmc_brittle_strengths(&u->law, strengths) == PDMC_OK)
        return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, index, "distribution"}, "%s",
                             pdmc_last_error());
}

static pdmc_status check_scalar(const pdmc_study_reader *reader, int index)
{
    pdmc_status status = pdmc_study_make_law(reader, index);
    if (status == PDMC_OK) status = check_strength(reader, index);
    if (status != PDMC_OK) return status;
    warn_of_negative_values(reader, index);
    return check_covariance(reader, index);
}

// What can be random depends on what a study computes.
static pdmc_status check_kind(const pdmc_study_reader *reader, int index)
{
    const pdmc_quantity quantity = reader->problem->uncertainties[index].quantity;
    const bool is_of_bodies = pdmc_is_of_bodies(reader->problem->kind);
    const bool is_of_bonds = quantity == PDMC_QUANTITY_VELOCITY || quantity == PDMC_QUANTITY_BOND_STRENGTH;
    const bool is_of_both = quantity == PDMC_QUANTITY_STIFFNESS || quantity == PDMC_QUANTITY_LOAD ||
                            quantity == PDMC_QUANTITY_YOUNGS_MODULUS || quantity == PDMC_QUANTITY_FRACTURE_ENERGY;
    const pdmc_study_address at = {SECTION_RANDOM, index, "quantity"};
    if (reader->problem->kind == PDMC_QUASI_STATIC && quantity == PDMC_QUANTITY_VELOCITY)
        return pdmc_study_refuse(reader, at, "is of what moves, a quasi-static study has none");
    if (is_of_bodies ? is_of_bonds || is_of_both : !is_of_bonds) return PDMC_OK;
    return pdmc_study_refuse(reader, at,
                             is_of_bodies ? "is not known of bodies of bonds, must be \"stiffness\", \"youngs_modulus\", "
                                            "\"fracture_energy\", \"bond_strength\", \"load\" or \"velocity\""
                                          : "is of bodies of bonds alone");
}

pdmc_status pdmc_study_check_random(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *p = reader->problem;
    for (int i = 0; i < p->uncertainty_count; i++) {
        const bool is_scalar = p->uncertainties[i].quantity >= PDMC_FIRST_SCALAR;
        PDMC_TRY(check_kind(reader, i));
        for (int j = 0; j < i; j++)
            if (p->uncertainties[j].quantity == p->uncertainties[i].quantity)
                return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RANDOM, i, "quantity"},
                                         "there already, must be once for each quantity");
        PDMC_TRY(is_scalar ? check_scalar(reader, i) : check_function(reader, i));
        PDMC_TRY(check_load(reader, i));
        if (p->uncertainties[i].quantity >= PDMC_FIRST_OF_CRACK) PDMC_TRY(check_crack(reader, i));
    }
done:
    return status;
}

// Of bodies of bonds, which draw such quantities for every node or bond.
static bool differs_in_space(const pdmc_problem *p, pdmc_quantity quantity)
{
    if (!pdmc_is_of_bodies(p->kind)) return false;
    return quantity == PDMC_QUANTITY_BOND_STRENGTH ||
           (quantity == PDMC_QUANTITY_FRACTURE_ENERGY && pdmc_problem_varies_toughness(p));
}

static pdmc_status check_pair(const pdmc_study_reader *reader, int index)
{
    const pdmc_correlation *pair = &reader->problem->correlations[index];
    const pdmc_study_address at = {SECTION_CORRELATIONS, index, "second"};
    const pdmc_quantity both[2] = {pair->first, pair->second};
    for (int k = 0; k < 2; k++)
        if (both[k] < PDMC_FIRST_SCALAR || !pdmc_problem_uncertainty(reader->problem, both[k]))
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CORRELATIONS, index, k ? "second" : "first"},
                                     "is no quantity of random with a distribution of its own, must be one");
    for (int k = 0; k < 2; k++)
        if (differs_in_space(reader->problem, both[k]))
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CORRELATIONS, index, k ? "second" : "first"},
                                     "differs from place to place, must have one value a sample in a study of bodies of bonds");
    if (pair->first == pair->second) return pdmc_study_refuse(reader, at, "must be another quantity than first");
    for (int j = 0; j < index; j++) {
        const pdmc_correlation *other = &reader->problem->correlations[j];
        if ((other->first == pair->first && other->second == pair->second) ||
            (other->first == pair->second && other->second == pair->first))
            return pdmc_study_refuse(reader, at, "there already, must be once for each pair");
    }
    return PDMC_OK;
}

pdmc_status pdmc_study_check_correlations(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *p = reader->problem;
    double matrix[PDMC_SCALARS * PDMC_SCALARS], factor[PDMC_SCALARS * PDMC_SCALARS];
    for (int i = 0; i < p->correlation_count; i++) PDMC_TRY(check_pair(reader, i));
    pdmc_problem_correlation(p, matrix);
    if (pdmc_copula_factor(PDMC_SCALARS, matrix, factor) != PDMC_OK)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CORRELATIONS, -1, NULL},
                                 "they contradict each other: no quantities can have all of them");
done:
    return status;
}

// What the symmetric matrices are of: bonds, and the weak form of the collocation.
static pdmc_status check_inverse(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_study_address at = {SECTION_SAMPLING, -1, "inverse"};
    const bool has_field = pdmc_problem_uncertainty(p, PDMC_QUANTITY_STIFFNESS) != NULL;
    const bool is_reduced = p->sampling.inverse == PDMC_INVERSE_REDUCED;
    if (is_reduced && pdmc_problem_moves_cracks(p))
        return pdmc_study_refuse(
            reader, at,
            "\"reduced\" has one model for all samples, and cracks that move have one each, must be "
            "\"direct\", \"neumann\" or \"krylov\"");
    if (p->sampling.inverse != PDMC_INVERSE_KRYLOV && !is_reduced) return PDMC_OK;
    if (p->solver.method != PDMC_METHOD_BOND && !has_field)
        return pdmc_study_refuse(reader, at,
                                 "\"%s\" needs a symmetric matrix, as of method = \"bond\" or of a random stiffness, "
                                 "must be \"direct\" or \"neumann\"",
                                 is_reduced ? "reduced" : "krylov");
    if (is_reduced && pdmc_problem_moves_sides(p))
        return pdmc_study_refuse(reader, at,
                                 "\"reduced\" has no prescribed displacements but 0 yet, must be "
                                 "\"direct\", \"neumann\" or \"krylov\"");
    return PDMC_OK;
}

static pdmc_status check_target(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_sampling *sampling = &p->sampling;
    const pdmc_study_address target = {SECTION_SAMPLING, -1, "target"}, most = {SECTION_SAMPLING, -1, "most_samples"};
    if (sampling->target == PDMC_TARGET_NONE) return PDMC_OK;
    if (sampling->design == PDMC_DESIGN_LATIN_HYPERCUBE)
        return pdmc_study_refuse(reader, target,
                                 "a Latin hypercube's points depend on their number, which a target leaves open, must have "
                                 "design = \"monte_carlo\" or \"sobol\"");
    if (sampling->most_samples < sampling->samples)
        return pdmc_study_refuse(reader, most, "%d is not allowed, must be at least the %d samples", sampling->most_samples,
                                 sampling->samples);
    if (sampling->design != PDMC_DESIGN_MONTE_CARLO && sampling->most_samples % sampling->replicates != 0)
        return pdmc_study_refuse(reader, most, "%d is not allowed, must be a multiple of the %d replicates of the design",
                                 sampling->most_samples, sampling->replicates);
    return PDMC_OK;
}

// Without anything random there is one sample.
static pdmc_status check_samples_of_bodies(const pdmc_study_reader *reader)
{
    if (reader->problem->uncertainty_count == 0) reader->problem->sampling.samples = 1;
    return PDMC_OK;
}

pdmc_status pdmc_study_check_sampling(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const int samples = p->sampling.samples, replicates = p->sampling.replicates;
    if (pdmc_is_of_bodies(p->kind)) return check_samples_of_bodies(reader);
    if (p->sampling.design != PDMC_DESIGN_MONTE_CARLO && samples % replicates != 0)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SAMPLING, -1, "samples"},
                                 "%d is not allowed, must be a multiple of the %d replicates of the design, such as %d",
                                 samples, replicates, (samples / replicates + 1) * replicates);
    const pdmc_status status = check_target(reader);
    return status == PDMC_OK ? check_inverse(reader) : status;
}

pdmc_status pdmc_study_check_reliability(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_reliability_request *request = &p->reliability;
    const bool is_asked = request->method != PDMC_RARE_NONE;
    if (request->sensitivity == 1)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RELIABILITY, -1, "sensitivity"},
                                 "1 is not allowed, must be 0 or from 2 to 10000000");
    if ((is_asked || request->sensitivity > 0) && p->uncertainty_count == 0)
        return pdmc_study_refuse(reader,
                                 (pdmc_study_address){SECTION_RELIABILITY, -1, is_asked ? "method" : "sensitivity"},
                                 "nothing is random, must have a list of random quantities");
    return PDMC_OK;
}
