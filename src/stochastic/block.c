// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/block.h"

#include "base/base_impl.h"
#include "pdmc/fracture.h"
#include "stochastic/fall_back.h"
#include "stochastic/forms.h"
#include "stochastic/krylov.h"
#include "stochastic/own_plate.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

static int most_bonds(const pdmc_affine *model)
{
    int most = 0;
    for (int d = 0; d < model->tips * model->angles; d++)
        if (model->crossings[d].bonds > most) most = model->crossings[d].bonds;
    return most;
}

static pdmc_status allocate(pdmc_block *block)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *model = block->model;
    const size_t unknowns = (size_t)model->unknowns;
    PDMC_TRY(pdmc_draws_create(block->variables, &block->drawn));
    PDMC_NEW(block->x, B * unknowns);
    PDMC_NEW(block->term, B * unknowns);
    PDMC_NEW(block->next, B * unknowns);
    PDMC_NEW(block->scale, model->cases);
    PDMC_NEW(block->stretch, B * (size_t)most_bonds(model));
    PDMC_NEW(block->ring_sum, B * (size_t)model->rings);
    PDMC_NEW(block->observed, B * (size_t)model->observed);
    PDMC_TRY(pdmc_near_create(model, &block->near));
    PDMC_NEW(block->intensity, B * 2 * (size_t)model->tips);
    PDMC_NEW(block->bound.intensity, B * 2 * (size_t)model->tips);
    PDMC_NEW(block->energy, PDMC_MEASURES * B * (size_t)(model->tips * model->angles));
    block->griffith = &block->energy[B * (size_t)(model->tips * model->angles)];
done:
    return status;
}

int pdmc_block_threads(const pdmc_affine *model, int threads)
{
    return model->family ? 1 : threads;
}

pdmc_status pdmc_block_create(const pdmc_variables *variables, const pdmc_affine *model, pdmc_block **block)
{
    pdmc_status status = PDMC_OK;
    pdmc_block *made = NULL;
    PDMC_NEW(made, 1);
    made->problem = variables->problem;
    made->variables = variables;
    made->model = model;
    made->lone_load = pdmc_variables_lone_load(variables);
    PDMC_TRY(allocate(made));
    *block = made;
    made = NULL;
done:
    pdmc_block_destroy(&made);
    return status;
}

void pdmc_block_destroy(pdmc_block **block)
{
    pdmc_block *old = *block;
    if (!old) return;
    pdmc_draws_clear(&old->drawn);
    pdmc_free(old->x);
    pdmc_free(old->term);
    pdmc_free(old->next);
    pdmc_free(old->scale);
    pdmc_free(old->stretch);
    pdmc_free(old->ring_sum);
    pdmc_free(old->observed);
    pdmc_near_clear(&old->near);
    pdmc_free(old->intensity);
    pdmc_free(old->bound.intensity);
    pdmc_free(old->energy);
    pdmc_free(old->feature);
    pdmc_free(old);
    *block = NULL;
}

static bool is_plate(const pdmc_block *block, const pdmc_draw *draw)
{
    const double thickness = draw->value[PDMC_QUANTITY_THICKNESS - PDMC_FIRST_SCALAR];
    bool is_positive = draw->effective_modulus > 0.0 && thickness > 0.0;
    for (int t = 0; t < block->model->tips; t++) is_positive = is_positive && draw->tip_modulus[t] > 0.0;
    return is_positive;
}

pdmc_status pdmc_block_draw_points(pdmc_block *block, const double z[], int count)
{
    const pdmc_status status = pdmc_variables_draw(block->variables, count, z, block->drawn.draw);
    block->has_own_plates = false;
    memmove(block->drawn.z, z, (size_t)count * (size_t)block->variables->count * sizeof *z);
    for (int s = 0; s < B && status == PDMC_OK; s++) {
        if (s >= count) pdmc_draw_mean(block->problem, block->variables->model, &block->drawn.draw[s]);
        if (s >= count) block->sample[s] = -1;
        block->failure[s] = is_plate(block, &block->drawn.draw[s]) ? PDMC_SAMPLE_OK : PDMC_SAMPLE_SOFT;
        block->solver[s] = PDMC_SOLVED_AS_ASKED;
        block->contraction[s] = block->residual[s] = block->bound.error[s] = NAN;
    }
    return status;
}

pdmc_status pdmc_block_draw_samples(pdmc_block *block, const int sample[], int count)
{
    for (int s = 0; s < count; s++) {
        block->sample[s] = sample[s];
        pdmc_variables_sample(block->variables, (uint64_t)sample[s], &block->drawn.z[s * block->variables->count]);
    }
    return pdmc_block_draw_points(block, block->drawn.z, count);
}

pdmc_status pdmc_block_draw(pdmc_block *block, int first, int count)
{
    int sample[B] = {0};
    for (int s = 0; s < count; s++) sample[s] = first + s;
    return pdmc_block_draw_samples(block, sample, count);
}

// K_0^-1 F: the mean operator's answer to each sample's loads.
static void start(pdmc_block *block)
{
    const size_t n = (size_t)block->model->unknowns;
    for (size_t s = 0; s < B; s++) {
        double *x = &block->x[s * n];
        memcpy(x, pdmc_affine_solution(block->model, 0), n * sizeof *x);
        for (int l = 1; l < block->model->cases; l++)
            cblas_daxpy((int)n, pdmc_draw_scale(&block->drawn.draw[s], l), pdmc_affine_solution(block->model, l), 1, x, 1);
    }
}

// The norm is that of the mean operator's response, |K_0 x|, in coordinates in which K_0 is orthogonal.
static void add_term(pdmc_block *block)
{
    const int n = block->model->unknowns;
    for (int s = 0; s < B; s++) {
        double *term = &block->next[s * n];
        cblas_dscal(n, -1.0, term, 1);
        const double before = cblas_dnrm2(n, &block->term[s * n], 1), after = cblas_dnrm2(n, term, 1);
        block->contraction[s] = after > 0.0 ? after / before : 0.0;
        cblas_daxpy(n, 1.0, term, 1, &block->x[s * n], 1);
    }
}

static pdmc_status expand(pdmc_block *block)
{
    const pdmc_affine *model = block->model;
    memcpy(block->term, block->x, B * (size_t)model->unknowns * sizeof(double));
    for (int j = 1; j <= block->problem->sampling.order && model->terms > 0; j++) {
        const pdmc_status status = model->verbs->perturb(model, block->drawn.xi, block->term, block->next);
        if (status != PDMC_OK) return status;
        add_term(block);
        double *swap = block->term;
        block->term = block->next;
        block->next = swap;
    }
    for (int s = 0; s < B; s++)
        if (block->contraction[s] >= 1.0 && block->failure[s] == PDMC_SAMPLE_OK)
            block->failure[s] = PDMC_SAMPLE_DIVERGED;
    return PDMC_OK;
}

static pdmc_status solve_one_directly(pdmc_block *block, int s)
{
    const pdmc_affine *model = block->model;
    for (int l = 0; l < model->cases; l++) block->scale[l] = pdmc_draw_scale(&block->drawn.draw[s], l);
    const pdmc_status status =
        model->verbs->solve(model, block->drawn.draw[s].xi, block->scale, &block->x[s * model->unknowns]);
    if (status != PDMC_ERR_SINGULAR) return status;
    block->failure[s] = PDMC_SAMPLE_SINGULAR;
    return PDMC_OK;
}

pdmc_status pdmc_block_solve_directly(pdmc_block *block, int s)
{
    block->failure[s] = PDMC_SAMPLE_OK;
    block->solver[s] = PDMC_SOLVED_DIRECTLY;
    return solve_one_directly(block, s);
}

static pdmc_status solve_directly(pdmc_block *block, int count)
{
    pdmc_status status = PDMC_OK;
    for (int s = 0; s < count && block->model->terms > 0 && status == PDMC_OK; s++)
        status = solve_one_directly(block, s);
    return status;
}

static pdmc_status iterate(pdmc_block *block)
{
    const double tolerance = block->problem->sampling.tolerance;
    const pdmc_affine *model = block->model;
    if (model->terms == 0) return PDMC_OK;
    const pdmc_status status = pdmc_krylov_solve(model, block->drawn.xi, tolerance, block->x, block->residual);
    for (int s = 0; s < B && status == PDMC_OK; s++) {
        if (block->failure[s] != PDMC_SAMPLE_OK) continue;
        if (isnan(block->residual[s])) block->failure[s] = PDMC_SAMPLE_SINGULAR;
        else if (block->residual[s] > tolerance) block->failure[s] = PDMC_SAMPLE_DIVERGED;
    }
    return status;
}

// The answer to the given loads and what is added to them, times the load that all have in common.
static pdmc_status reduce(pdmc_block *block)
{
    pdmc_status status = PDMC_OK;
    const int n = block->model->unknowns, rows = 2 * block->model->tips, added = block->model->cases - 2;
    double *share = NULL;
    PDMC_NEW(share, B * added);
    for (int s = 0; s < B; s++)
        for (int l = 0; l < added; l++) share[s * added + l] = block->drawn.draw[s].load_pattern[2 + l];
    PDMC_TRY(pdmc_reduced_solve(block->model, block->drawn.xi, share, block->x, &block->bound));
    for (int s = 0; s < B; s++) {
        const double load = block->drawn.draw[s].load_share;
        cblas_dscal(n, load, &block->x[s * n], 1);
        block->bound.error[s] *= fabs(load);
        for (int k = 0; k < rows; k++) block->bound.intensity[s * rows + k] *= fabs(load);
    }
done:
    pdmc_free(share);
    return status;
}

pdmc_status pdmc_block_solve_by(pdmc_block *block, pdmc_inverse inverse, int count)
{
    const double begin = pdmc_seconds();
    pdmc_status status = PDMC_OK;
    start(block);
    switch (inverse) {
    case PDMC_INVERSE_DIRECT: status = solve_directly(block, count); break;
    case PDMC_INVERSE_NEUMANN: status = expand(block); break;
    case PDMC_INVERSE_KRYLOV: status = iterate(block); break;
    case PDMC_INVERSE_REDUCED: status = reduce(block); break;
    }
    block->solve_seconds += pdmc_seconds() - begin;
    return status;
}

pdmc_status pdmc_block_solve(pdmc_block *block, int count)
{
    const pdmc_inverse inverse = block->problem->sampling.inverse;
    if (block->model->family) return pdmc_block_solve_own_plates(block, count);
    const pdmc_status status = pdmc_block_solve_by(block, inverse, count);
    const bool may_fall_back = inverse == PDMC_INVERSE_NEUMANN || inverse == PDMC_INVERSE_KRYLOV;
    return status == PDMC_OK && may_fall_back ? pdmc_block_fall_back(block, count) : status;
}

static void full_stretches(pdmc_block *block, const pdmc_crossing *crossing)
{
    const bool is_observed = block->model->observed > 0;
    const int n = is_observed ? block->model->observed : block->model->unknowns;
    if (crossing->bonds > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, crossing->bonds, B, n, 1.0, crossing->row, n,
                    is_observed ? block->observed : block->x, n, 0.0, block->stretch, B);
}

// Sums the squared stretches over each ring's bonds, in their order, and weights the rings by each sample's c(r).
static void sum_rings(const pdmc_block *block, int direction, pdmc_bonds bonds, const bool wanted[B], double energy[])
{
    const pdmc_crossing *crossing = &block->model->crossings[direction];
    const int rings = block->model->rings;
    memset(block->ring_sum, 0, (size_t)rings * B * sizeof *block->ring_sum);
    for (int b = 0; b < crossing->bonds; b++) {
        const double *stretch = &block->stretch[(size_t)b * B];
        double *sum = &block->ring_sum[crossing->ring[b] * B];
        if (bonds == PDMC_BONDS_ALL) {
            for (int s = 0; s < B; s++) sum[s] += stretch[s] * stretch[s];
        } else {
            for (int s = 0; s < B; s++) sum[s] += stretch[s] > 0.0 ? stretch[s] * stretch[s] : 0.0;
        }
    }
    for (int s = 0; s < B; s++) {
        double sum = 0.0;
        if (!wanted[s]) continue;
        for (int q = 0; q < rings; q++) sum += block->drawn.draw[s].ring_weight[q] * block->ring_sum[q * B + s];
        energy[s] = 0.5 * block->model->micromodulus * block->drawn.draw[s].direction_modulus[direction] * sum;
    }
}

static void measure_intensities(pdmc_block *block)
{
    const pdmc_affine *model = block->model;
    const int n = model->unknowns;
    if (model->tips > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, 2 * model->tips, B, n, 1.0, model->stress_intensity, n,
                    block->x, n, 0.0, block->intensity, B);
}

static void observe(pdmc_block *block)
{
    const pdmc_affine *model = block->model;
    const int n = model->unknowns;
    if (model->observed > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, B, model->observed, n, 1.0, block->x, n, model->observe, n,
                    0.0, block->observed, model->observed);
}

static void sum_bonds(pdmc_block *block, pdmc_bonds bonds, const bool wanted[B])
{
    const bool is_observed = block->model->observed > 0;
    pdmc_near_take(&block->near, is_observed ? block->model->observed : block->model->unknowns,
                   is_observed ? block->observed : block->x);
    for (int d = 0; d < block->model->tips * block->model->angles; d++) {
        const pdmc_crossing *crossing = &block->model->crossings[d];
        if (crossing->column) pdmc_near_stretch(&block->near, crossing, block->stretch);
        else full_stretches(block, crossing);
        sum_rings(block, d, bonds, wanted, &block->energy[d * B]);
    }
}

static void measure_bonds(pdmc_block *block, pdmc_bonds bonds)
{
    const pdmc_energy_forms *forms = bonds == PDMC_BONDS_ALL ? block->forms : NULL;
    const double *y = block->model->observed > 0 ? block->observed : block->x;
    bool wanted[B], any = false;
    observe(block);
    if (forms) pdmc_energy_forms_evaluate(forms, block->drawn.draw, y, block->feature, block->energy);
    for (int s = 0; s < B; s++) {
        wanted[s] =
            !forms || (block->failure[s] == PDMC_SAMPLE_OK && !pdmc_energy_forms_hold(forms, &y[s * forms->width]));
        any = any || wanted[s];
    }
    if (any) sum_bonds(block, bonds, wanted);
}

void pdmc_block_energies(pdmc_block *block, pdmc_bonds bonds)
{
    const double begin = pdmc_seconds();
    if (block->has_own_plates) return;
    measure_intensities(block);
    measure_bonds(block, bonds);
    block->energy_seconds += pdmc_seconds() - begin;
}

pdmc_status pdmc_block_use_forms(pdmc_block *block, const pdmc_energy_forms *forms)
{
    pdmc_status status = PDMC_OK;
    if (!forms) return PDMC_OK;
    PDMC_NEW(block->feature, pdmc_energy_forms_scratch(forms));
    block->forms = forms;
done:
    return status;
}

// The solved pilots, one behind the other.
static int gather_pilots(const pdmc_block *block, int width, double y[])
{
    const double *from = block->model->observed > 0 ? block->observed : block->x;
    int count = 0;
    for (int s = 0; s < B; s++)
        if (block->failure[s] == PDMC_SAMPLE_OK)
            memcpy(&y[width * count++], &from[s * width], (size_t)width * sizeof *y);
    return count;
}

// Whether the pilots have the same energies by the forms as by their bonds, which hold in the block.
static bool agree(const pdmc_block *block, const double energy[])
{
    const double rounding = 1e-13;
    for (int k = 0; k < block->model->tips * block->model->angles * B; k++)
        if (block->failure[k % B] == PDMC_SAMPLE_OK &&
            !(fabs(energy[k] - block->energy[k]) <= rounding * block->energy[k]))
            return false;
    return true;
}

// Forms of a block that is solved and measured, or NULL.
static pdmc_status make_forms(const pdmc_block *block, pdmc_energy_forms **forms)
{
    pdmc_status status = PDMC_OK;
    const int width = block->model->observed > 0 ? block->model->observed : block->model->unknowns;
    double *y = NULL, *energy = NULL, *scratch = NULL;
    PDMC_NEW(y, B * width);
    PDMC_NEW(energy, B * block->model->tips * block->model->angles);
    const int pilots = gather_pilots(block, width, y);
    if (pilots > 0) PDMC_TRY(pdmc_energy_forms_create(block->model, pilots, y, forms));
    if (!*forms) goto done;
    PDMC_NEW(scratch, pdmc_energy_forms_scratch(*forms));
    pdmc_energy_forms_evaluate(*forms, block->drawn.draw, block->model->observed > 0 ? block->observed : block->x,
                               scratch, energy);
    if (!agree(block, energy)) pdmc_energy_forms_destroy(forms);
done:
    pdmc_free(y);
    pdmc_free(energy);
    pdmc_free(scratch);
    if (status != PDMC_OK) pdmc_energy_forms_destroy(forms);
    return status;
}

pdmc_status pdmc_block_make_forms(pdmc_block *block, pdmc_energy_forms **forms)
{
    const uint64_t first = UINT64_C(1) << 62; // far from the samples of any study
    const bool is_of_use = block->problem->energy.bonds == PDMC_BONDS_ALL &&
                           block->problem->sampling.inverse != PDMC_INVERSE_DIRECT; // which takes far longer anyway
    pdmc_status status = PDMC_OK;
    *forms = NULL;
    if (!is_of_use || block->model->tips == 0 || block->model->family) return PDMC_OK;
    for (uint64_t s = 0; s < B; s++)
        pdmc_variables_sample(block->variables, first + s, &block->drawn.z[(int)s * block->variables->count]);
    PDMC_TRY(pdmc_block_draw_points(block, block->drawn.z, B));
    PDMC_TRY(pdmc_block_solve(block, B));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    PDMC_TRY(make_forms(block, forms));
    block->solve_seconds = block->energy_seconds = 0.0;
done:
    return status;
}

void pdmc_block_measure(pdmc_block *block)
{
    const pdmc_energy_request *energy = &block->problem->energy;
    if (block->has_own_plates) return;
    if (energy->measure == PDMC_MEASURE_GRIFFITH) measure_intensities(block);
    else measure_bonds(block, energy->bonds);
}

// K_I or K_II of one tip of one sample: the rows give them at the mean modulus, and a stress is proportional to the modulus.
static double find_intensity(const pdmc_block *block, int s, int t, int mode)
{
    return block->drawn.draw[s].tip_modulus[t] * block->intensity[(2 * t + mode) * B + s];
}

// Straight ahead, of the sample's own tip.
static double direction_of(const pdmc_block *block, int s, int t, const pdmc_results *results)
{
    const double turn = block->model->family ? pdmc_problem_turn(block->problem, block->problem->energy.tips[t] / 2,
                                                                 block->drawn.draw[s].value)
                                             : 0.0;
    return results->tips[t].direction + turn;
}

// Of all samples at one tip, in all directions: pdmc_griffith_energy() with the factors of a kink found once for all samples
// that share the tip's direction.
static void griffith_of_tip(const pdmc_block *block, int t, const pdmc_results *results, double energy[])
{
    const double plane_modulus = pdmc_plane_modulus(&block->problem->material);
    const int angles = block->model->angles, sharing = block->model->family ? 1 : B;
    double first[B], second[B], modulus[B], F[4];
    for (int s = 0; s < B; s++) {
        first[s] = find_intensity(block, s, t, 0);
        second[s] = find_intensity(block, s, t, 1);
        modulus[s] = block->drawn.draw[s].tip_modulus[t] * plane_modulus;
    }
    for (int i = 0; i < angles * B; i += sharing) {
        pdmc_kink_factors(results->angles[i / B] - direction_of(block, i % B, t, results), F);
        for (int s = i % B; s < i % B + sharing; s++) {
            const double k_1 = F[0] * first[s] + F[1] * second[s], k_2 = F[2] * first[s] + F[3] * second[s];
            const double opening = k_1 > 0.0 ? k_1 : 0.0;
            energy[i / B * B + s] = (opening * opening + k_2 * k_2) / modulus[s];
        }
    }
}

void pdmc_block_griffith(pdmc_block *block, const pdmc_results *results)
{
    const double begin = pdmc_seconds();
    for (int t = 0; t < block->model->tips; t++)
        griffith_of_tip(block, t, results, &block->griffith[t * block->model->angles * B]);
    block->energy_seconds += pdmc_seconds() - begin;
}

static const double *energies_of(const pdmc_block *block, pdmc_measure measure)
{
    return measure == PDMC_MEASURE_GRIFFITH ? block->griffith : block->energy;
}

double pdmc_block_largest_energy(const pdmc_block *block, int s, int tip)
{
    const int angles = block->model->angles;
    const double *energy = &energies_of(block, block->problem->energy.measure)[tip * angles * B + s];
    double largest = 0.0;
    for (int a = 0; a < angles; a++) largest = fmax(largest, energy[a * B]);
    return largest;
}

void pdmc_block_largest_energies(const pdmc_block *block, pdmc_measure measure, int tip, double largest[B])
{
    const int angles = block->model->angles;
    const double *energy = &energies_of(block, measure)[tip * angles * B];
    for (int s = 0; s < B; s++) largest[s] = 0.0;
    for (int a = 0; a < angles; a++)
        for (int s = 0; s < B; s++) largest[s] = energy[a * B + s] > largest[s] ? energy[a * B + s] : largest[s];
}

// P(the tip grows | all but the load): G goes with the square of the load, so that growth begins at one value of it.
static double growth_given_rest(const pdmc_block *block, int s, int t, double largest)
{
    const pdmc_draw *draw = &block->drawn.draw[s];
    const pdmc_distribution *law = block->lone_load;
    if (!law || block->failure[s] != PDMC_SAMPLE_OK) return NAN;
    const double load = draw->value[PDMC_QUANTITY_LOAD - PDMC_FIRST_SCALAR];
    const double toughness = fmax(draw->fracture_energy[t], 0.0);
    return largest > 0.0 ? pdmc_distribution_upper_tail(law, load * sqrt(toughness / largest)) : 0.0;
}

static void store_tip(const pdmc_block *block, int count, int t, pdmc_results *results)
{
    double largest[PDMC_MEASURES][B];
    for (int m = 0; m < PDMC_MEASURES; m++) pdmc_block_largest_energies(block, (pdmc_measure)m, t, largest[m]);
    for (int s = 0; s < count; s++) {
        const size_t place = (size_t)block->sample[s] * (size_t)results->tip_count + (size_t)t;
        const bool is_known = block->failure[s] == PDMC_SAMPLE_OK;
        for (int k = 0; k < 2; k++)
            results->stress_intensity[2 * place + (size_t)k] = is_known ? find_intensity(block, s, t, k) : NAN;
        for (int m = 0; m < PDMC_MEASURES; m++) results->largest_energy[m][place] = is_known ? largest[m][s] : NAN;
        results->growth_given_rest[place] = growth_given_rest(block, s, t, largest[block->problem->energy.measure][s]);
        results->sample_fracture_energy[place] = block->drawn.draw[s].fracture_energy[t];
    }
}

// What is kept of the first samples alone.
static void store_details(const pdmc_block *block, int s, pdmc_results *results)
{
    const size_t sample = (size_t)block->sample[s], bins = (size_t)results->bin_count;
    const size_t directions = (size_t)(results->tip_count * results->angle_count);
    if (bins > 0)
        memcpy(&results->micromodulus[sample * bins], block->drawn.draw[s].micromodulus, bins * sizeof(double));
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (size_t d = 0; d < directions; d++)
            results->energy[m][sample * directions + d] =
                block->failure[s] == PDMC_SAMPLE_OK ? energies_of(block, (pdmc_measure)m)[d * B + (size_t)s] : NAN;
}

void pdmc_block_store(const pdmc_block *block, int count, pdmc_results *results)
{
    for (int s = 0; s < count; s++) {
        const int sample = block->sample[s];
        results->load_factor[sample] = block->drawn.draw[s].load_factor;
        results->effective_modulus[sample] = block->drawn.draw[s].effective_modulus;
        results->contraction[sample] = block->contraction[s];
        results->failure[sample] = (uint8_t)block->failure[s];
        results->sample_solver[sample] = (uint8_t)block->solver[s];
        if (sample < results->kept_count) store_details(block, s, results);
    }
    for (int t = 0; t < results->tip_count; t++) store_tip(block, count, t, results);
}

pdmc_status pdmc_block_nominal(pdmc_block *block, pdmc_results *results)
{
    const int directions = results->tip_count * results->angle_count;
    const pdmc_status status = pdmc_block_draw(block, 0, 0);
    if (status != PDMC_OK) return status;
    start(block);
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    pdmc_block_griffith(block, results);
    for (int d = 0; d < directions; d++) results->nominal_bond_energy[d] = block->energy[d * B];
    for (int d = 0; d < directions; d++) results->nominal_griffith_energy[d] = block->griffith[d * B];
    pdmc_block_energies(block, PDMC_BONDS_TENSILE);
    for (int d = 0; d < directions; d++) results->nominal_bond_energy_tensile[d] = block->energy[d * B];
    block->energy_seconds = 0.0;
    return PDMC_OK;
}
