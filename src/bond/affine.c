// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/bond.h"
#include "bond/crossing.h"
#include "bond/near_rows.h"
#include "bond/nodal.h"
#include "bond/varying.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

static const pdmc_bond *bond_of(const pdmc_affine *model)
{
    return ((const pdmc_bond_operator *)model->discretisation)->bond;
}

static const pdmc_bond_stiffness *stiffness_of(const pdmc_affine *model)
{
    return ((const pdmc_bond_operator *)model->discretisation)->stiffness;
}

// The deviation of a shell in a sample.
static double shell_deviation(const pdmc_affine *model, const double xi[], int shell)
{
    return model->radial_terms > 0 ? xi[shell] : 0.0;
}

static pdmc_status multiply_shells(const pdmc_affine *model, double mean, const double xi[], const double x[],
                                   double y[])
{
    pdmc_status status = PDMC_OK;
    const int shells = bond_of(model)->plate.horizon.shells;
    double *factor = NULL;
    PDMC_NEW(factor, B * shells);
    for (int s = 0; s < B; s++)
        for (int m = 0; m < shells; m++)
            factor[s * shells + m] = mean + shell_deviation(model, &xi[s * model->terms], m);
    PDMC_TRY(pdmc_bond_multiply(&bond_of(model)->plate, bond_of(model)->threads, factor, x, y));
done:
    pdmc_free(factor);
    return status;
}

static pdmc_status multiply_nodes(const pdmc_affine *model, double mean, const double xi[], const double x[],
                                  double y[])
{
    const pdmc_bond *bond = bond_of(model);
    const pdmc_bond_stiffness *stiffness = stiffness_of(model);
    return pdmc_bond_nodal_multiply(&bond->plate, bond->threads, stiffness->terms, stiffness->value, mean, model->terms,
                                    xi + model->radial_terms, x, y);
}

static pdmc_status multiply(const pdmc_affine *model, double mean, const double xi[], const double x[], double y[])
{
    pdmc_status status = PDMC_OK;
    const size_t values = (size_t)B * (size_t)model->unknowns;
    double *radial = NULL;
    if (!stiffness_of(model)) return multiply_shells(model, mean, xi, x, y);
    if (model->radial_terms == 0) return multiply_nodes(model, mean, xi, x, y);
    PDMC_NEW(radial, values);
    PDMC_TRY(multiply_shells(model, 0.0, xi, x, radial));
    PDMC_TRY(multiply_nodes(model, mean, xi, x, y));
    for (size_t k = 0; k < values; k++) y[k] += radial[k];
done:
    pdmc_free(radial);
    return status;
}

// pdmc_sparse_factor_solve() or its like, on halves of the columns side by side where there are threads, but always on
// halves, since the last bits depend on the width.
typedef pdmc_status by_factor(const pdmc_sparse_factor *factor, int columns, const double b[], double x[]);

static pdmc_status in_halves(by_factor *solve_columns, const pdmc_affine *model, int count, const double b[],
                             double x[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond *bond = bond_of(model);
    const int half = (count + 1) / 2;
#pragma omp parallel for num_threads(bond->threads)
    for (int first = 0; first < count; first += half) {
        const size_t at = (size_t)first * (size_t)model->unknowns;
        const pdmc_status mine =
            solve_columns(bond->factor, first + half <= count ? half : count - first, &b[at], &x[at]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_bond_in_halves)
            status = mine;
        }
    }
    return status;
}

static pdmc_status precondition(const pdmc_affine *model, int count, const double r[], double z[])
{
    return in_halves(pdmc_sparse_factor_solve, model, count, r, z);
}

static pdmc_status color(const pdmc_affine *model, const double g[], double z[])
{
    const pdmc_bond_grid *grid = &bond_of(model)->plate.grid;
    const pdmc_status status = in_halves(pdmc_sparse_factor_color, model, B, g, z);
    for (int k = 0; k < model->unknowns && status == PDMC_OK; k++)
        if (grid->held[k / 2] & (1U << (k % 2)))
            for (int s = 0; s < B; s++) z[(size_t)s * (size_t)model->unknowns + (size_t)k] = 0.0;
    return status;
}

static pdmc_status perturb(const pdmc_affine *model, const double xi[], const double x[], double y[])
{
    const pdmc_status status = multiply(model, 0.0, xi, x, y);
    return status == PDMC_OK ? precondition(model, B, y, y) : status;
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond *bond = bond_of(model);
    const pdmc_bond_stiffness *stiffness = stiffness_of(model);
    const int shells = bond->plate.horizon.shells, nodes = bond->plate.grid.nodes;
    pdmc_sparse_matrix matrix = {0};
    pdmc_sparse_factor *factor = NULL;
    double *shell = NULL, *node = NULL;
    PDMC_NEW(shell, shells);
    for (int m = 0; m < shells; m++) shell[m] = 1.0 + shell_deviation(model, xi, m);
    if (stiffness) PDMC_NEW(node, nodes);
    if (stiffness)
        cblas_dgemv(CblasRowMajor, CblasNoTrans, nodes, stiffness->terms, 1.0, stiffness->value, stiffness->terms,
                    xi + model->radial_terms, 1, 0.0, node, 1);
    const pdmc_bond_moduli moduli = {shell, node};
    PDMC_TRY(pdmc_bond_matrix_create(&bond->plate, &moduli, &matrix));
    PDMC_TRY(pdmc_sparse_factor_create(&matrix, bond->factor, NULL, &factor));
    PDMC_TRY(pdmc_bond_solve(bond, factor, &moduli, scale, x));
done:
    pdmc_sparse_factor_destroy(&factor);
    pdmc_sparse_matrix_clear(&matrix);
    pdmc_free(shell);
    pdmc_free(node);
    return status;
}

static pdmc_status project(const pdmc_affine *model, int u_count, const double u[], int v_count, const double v[],
                           double out[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond *bond = bond_of(model);
    const pdmc_bond_stiffness *stiffness = stiffness_of(model);
    const size_t radial = (size_t)model->radial_terms * (size_t)u_count * (size_t)v_count;
    if (radial > 0) PDMC_TRY(pdmc_bond_shell_project(&bond->plate, bond->threads, u_count, u, v_count, v, out));
    if (stiffness)
        PDMC_TRY(pdmc_bond_nodal_project(&bond->plate, bond->threads, stiffness->terms, stiffness->value, u_count, u,
                                         v_count, v, &out[radial]));
done:
    return status;
}

// E_eff is proportional to the energy of an isotropic stretch, sum_k c_k area_k |xi_k|.
static void fill_modulus_weight(const pdmc_bond_horizon *horizon, double weight[])
{
    double sum = 0.0;
    for (int k = 0; k < horizon->count; k++) {
        const pdmc_bond_neighbour *n = &horizon->neighbour[k];
        const double energy = n->stiffness * n->length * n->length;
        sum += energy;
        for (int b = 0; b < horizon->bins; b++) weight[b] += energy * horizon->share[b * horizon->shells + n->shell];
    }
    for (int b = 0; b < horizon->bins; b++) weight[b] /= sum;
}

static pdmc_status fill_weights(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond_horizon *horizon = &bond->plate.horizon;
    const size_t shares = (size_t)horizon->bins * (size_t)horizon->shells;
    model->bins = horizon->bins;
    model->rings = horizon->shells;
    model->radial_terms = pdmc_problem_uncertainty(bond->problem, PDMC_QUANTITY_MICROMODULUS) ? horizon->shells : 0;
    model->terms = model->radial_terms + (stiffness ? stiffness->terms : 0);
    PDMC_NEW(model->term_weight, shares);
    PDMC_NEW(model->ring_weight, shares);
    PDMC_NEW(model->modulus_weight, horizon->bins);
    memcpy(model->term_weight, horizon->share, shares * sizeof *horizon->share);
    memcpy(model->ring_weight, horizon->share, shares * sizeof *horizon->share);
    fill_modulus_weight(horizon, model->modulus_weight);
done:
    return status;
}

// The model only refers to the plate.
static pdmc_status create_operator(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness, pdmc_affine *model)
{
    static const pdmc_affine_verbs uniform = {.perturb = perturb,
                                              .solve = solve,
                                              .multiply = multiply,
                                              .precondition = precondition,
                                              .color = color,
                                              .project = project,
                                              .destroy = pdmc_free};
    static const pdmc_affine_verbs varying = {.perturb = perturb,
                                              .solve = solve,
                                              .multiply = multiply,
                                              .precondition = precondition,
                                              .color = color,
                                              .project = project,
                                              .coercivity = pdmc_bond_coercivity,
                                              .destroy = pdmc_free};
    pdmc_status status = PDMC_OK;
    pdmc_bond_operator *made = NULL;
    PDMC_NEW(made, 1);
    *made = (pdmc_bond_operator){bond, stiffness};
    model->discretisation = made;
    model->verbs = stiffness ? &varying : &uniform;
done:
    return status;
}

static pdmc_status fill_solutions(const pdmc_bond *bond, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)bond->unknowns;
    model->unknowns = bond->unknowns;
    model->micromodulus = pdmc_micromodulus(&bond->problem->material, bond->problem->solver.horizon);
    model->cases = 1 + bond->loads.count;
    PDMC_NEW(model->solution, (size_t)model->cases * n);
    memcpy(model->solution, bond->solution, (size_t)model->cases * n * sizeof(double));
done:
    return status;
}

static pdmc_status fill_intensities(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)bond->unknowns;
    double *far = NULL;
    PDMC_NEW(far, 2 * (size_t)model->tips * n);
    for (int t = 0; t < model->tips; t++) {
        double *row = &far[2 * (size_t)t * n];
        PDMC_TRY(pdmc_bond_stress_intensity_rows(bond, bond->problem->energy.tips[t], row, row + n));
    }
    if (stiffness) PDMC_NEW(model->stress_intensity, 2 * (size_t)model->tips * n);
    for (int t = 0; t < model->tips && stiffness; t++)
        PDMC_TRY(pdmc_bond_near_rows(bond, bond->problem->energy.tips[t], &far[2 * (size_t)t * n],
                                     &model->stress_intensity[2 * (size_t)t * n]));
    if (!stiffness) {
        model->stress_intensity = far;
        far = NULL;
    }
done:
    pdmc_free(far);
    return status;
}

static pdmc_status fill_crossings(const pdmc_bond *bond, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int directions = model->tips * model->angles;
    PDMC_NEW(model->crossings, directions);
#pragma omp parallel for schedule(dynamic) num_threads(bond->threads)
    for (int d = 0; d < directions; d++) {
        const double phi = 2.0 * M_PI * (d % model->angles) / model->angles;
        const int tip = bond->problem->energy.tips[d / model->angles];
        const pdmc_status mine = pdmc_bond_crossing_create(bond, tip, phi, &model->crossings[d]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_bond_crossings)
            status = mine;
        }
    }
done:
    return status;
}

// The bonds that cross a line are a part of all, each with a weight of at most 1: G <= 1/2 e' K e / (delta_alpha R).
static double bound_of_crossings(const pdmc_bond *bond)
{
    const pdmc_problem *problem = bond->problem;
    double smallest = INFINITY;
    for (int a = 0; a < problem->energy.angles; a++) {
        const double phi = 2.0 * M_PI * a / problem->energy.angles;
        smallest = fmin(smallest, pdmc_bond_crossing_bias(problem, &bond->plate.horizon, phi));
    }
    return 1.0 / sqrt(2.0 * problem->energy.extension * smallest);
}

pdmc_status pdmc_bond_affine(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    const pdmc_energy_request *energy = &bond->problem->energy;
    *model = (pdmc_affine){.tips = energy->tip_count, .angles = energy->angles};
    PDMC_TRY(fill_weights(bond, stiffness, model));
    PDMC_TRY(create_operator(bond, stiffness, model));
    PDMC_TRY(fill_solutions(bond, model));
    PDMC_TRY(fill_intensities(bond, stiffness, model));
    const double made = pdmc_seconds();
    PDMC_TRY(fill_crossings(bond, model));
    if (stiffness) PDMC_TRY(pdmc_bond_fill_local_stiffness(bond, stiffness, model));
    model->crossing_bound = bound_of_crossings(bond);
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
