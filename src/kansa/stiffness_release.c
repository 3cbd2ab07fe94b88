// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/stiffness_release.h"

#include "base/base_impl.h"
#include "kansa/release_rule.h"
#include "kansa/weak_form.h"
#include "kansa/weak_rows.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// Of the room that the tip has: the difference is off by its square, and rounding by 1e-10 over it.
static const double step = 1e-3;

static pdmc_status move_tip(const pdmc_problem *problem, int tip, double distance, pdmc_problem *moved)
{
    pdmc_status status = PDMC_OK;
    const int number = problem->energy.tips[tip];
    pdmc_crack *cracks = NULL;
    PDMC_NEW(cracks, problem->crack_count);
    memcpy(cracks, problem->cracks, (size_t)problem->crack_count * sizeof *cracks);
    *moved = *problem;
    moved->cracks = cracks;
    double *end = number % 2 ? cracks[number / 2].to : cracks[number / 2].from;
    const double *other = number % 2 ? cracks[number / 2].from : cracks[number / 2].to;
    const double along[2] = {end[0] - other[0], end[1] - other[1]}, length = hypot(along[0], along[1]);
    for (int k = 0; k < 2; k++) end[k] += distance * along[k] / length;
done:
    return status;
}

// epsilon : C : epsilon of a plate at its mean loads.
static pdmc_status energy_density(const pdmc_kansa *kansa, const double x[2], double *energy)
{
    double s[3];
    const pdmc_material *material = &kansa->problem->material;
    const double nu = pdmc_poissons_ratio(material->assumption);
    const double plane_nu = material->assumption == PDMC_PLANE_STRESS ? nu : nu / (1.0 - nu);
    const pdmc_status status = pdmc_kansa_stress(kansa, x, x, s);
    *energy = (s[0] * s[0] + s[1] * s[1] - 2.0 * plane_nu * s[0] * s[1] + 2.0 * (1.0 + plane_nu) * s[2] * s[2]) /
              pdmc_plane_modulus(material);
    return status;
}

static double griffith(const pdmc_problem *problem, const pdmc_tip *tip)
{
    const double *K = tip->stress_intensity;
    return (K[0] * K[0] + K[1] * K[1]) / pdmc_plane_modulus(&problem->material);
}

// Replaces the mean solution by that of the weak form, whose energy is the least, and so right to second order.
static pdmc_status solve_weakly(pdmc_kansa *kansa)
{
    pdmc_status status = PDMC_OK;
    const int n = kansa->unknowns;
    pdmc_weak_form form = {0};
    PDMC_TRY(pdmc_weak_form_create(kansa, &form));
    PDMC_TRY(pdmc_kansa_form_add_gauge(kansa, form.stiffness));
    cblas_daxpy(n, 1.0, form.fixed, 1, form.load, 1);
    const int info = LAPACKE_dposv(LAPACK_COL_MAJOR, 'L', n, 1, form.stiffness, n, form.load, n);
    if (info != 0) PDMC_FAIL(PDMC_ERR_SINGULAR, "the energy of the trial functions is not positive (row %d)", info);
    pdmc_kansa_unwhiten(kansa, 1, form.load);
    memcpy(kansa->coefficients, form.load, (size_t)n * sizeof(double));
done:
    pdmc_weak_form_clear(&form);
    return status;
}

// The points of the plate whose tip is moved by `side` steps, and their weights, over the points of the rule that move.
static pdmc_status add_plate(const pdmc_problem *problem, int tip, int side, double factor, int threads,
                             const pdmc_area_rule *rule, double x[], double weight[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_moving_tip moving = pdmc_moving_tip_of(problem, tip);
    const double h = step * moving.room;
    pdmc_problem moved = {0};
    pdmc_kansa *kansa = NULL;
    PDMC_TRY(move_tip(problem, tip, side * h, &moved));
    PDMC_TRY(pdmc_kansa_create(&moved, NULL, threads, &kansa));
    PDMC_TRY(solve_weakly(kansa));
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int p = 0; p < rule->count; p++) {
        double slope, energy;
        const double q = pdmc_moving_tip_velocity(&moving, &rule->x[2 * p], &slope);
        for (int k = 0; k < 2; k++) x[2 * p + k] = rule->x[2 * p + k] + side * h * q * moving.along[k];
        const pdmc_status mine = energy_density(kansa, &x[2 * p], &energy);
        weight[p] = side * factor * rule->weight[p] * (1.0 + side * h * slope) * energy;
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_kansa_release)
            status = mine;
        }
    }
done:
    pdmc_kansa_destroy(&kansa);
    pdmc_free(moved.cracks);
    return status;
}

// Points that do not move are in both plates, and count once.
static int merge(int points, double x[], double weight[])
{
    int count = points;
    for (int p = 0; p < points; p++) {
        const int other = points + p;
        if (x[2 * p] == x[2 * other] && x[2 * p + 1] == x[2 * other + 1]) {
            weight[p] += weight[other];
            continue;
        }
        memmove(&x[2 * count], &x[2 * other], 2 * sizeof *x);
        weight[count++] = weight[other];
    }
    return count;
}

pdmc_status pdmc_kansa_release_sensitivity(const pdmc_kansa *kansa, int tip, double length,
                                           pdmc_field_functional *functional)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = kansa->problem;
    const pdmc_moving_tip moving = pdmc_moving_tip_of(problem, tip);
    pdmc_area_rule rule = {0};
    double *x = NULL, *weight = NULL;
    pdmc_tip mean;
    *functional = (pdmc_field_functional){0};
    PDMC_TRY(pdmc_kansa_tip(kansa, problem->energy.tips[tip], &mean));
    const double G = griffith(problem, &mean);
    if (G == 0.0) return PDMC_OK;
    PDMC_TRY(pdmc_release_rule(kansa, &moving, length, &rule));
    PDMC_NEW(x, 4 * rule.count);
    PDMC_NEW(weight, 2 * rule.count);
    const double factor = -1.0 / (4.0 * step * moving.room * G);
    PDMC_TRY(add_plate(problem, tip, -1, factor, kansa->threads, &rule, x, weight));
    PDMC_TRY(add_plate(problem, tip, 1, factor, kansa->threads, &rule, &x[2 * rule.count], &weight[rule.count]));
    *functional = (pdmc_field_functional){merge(rule.count, x, weight), x, weight};
    x = weight = NULL;
done:
    pdmc_area_rule_clear(&rule);
    pdmc_free(x);
    pdmc_free(weight);
    return status;
}

// psi at many points, by chunks.
static pdmc_status evaluate(const pdmc_stiffness_terms *terms, int threads, int points, const double x[],
                            double value[])
{
    enum { CHUNK = 64 };
    pdmc_status status = PDMC_OK;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int first = 0; first < points; first += CHUNK) {
        const int count = points - first < CHUNK ? points - first : CHUNK;
        const pdmc_status mine =
            terms->at(terms->context, count, &x[2 * first], &value[(size_t)first * (size_t)terms->terms]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_kansa_release)
            status = mine;
        }
    }
    return status;
}

// sum += factor sum_j weight_j psi_k(x_j)
static pdmc_status add_functional(const pdmc_stiffness_terms *terms, int threads,
                                  const pdmc_field_functional *functional, double factor, double sum[])
{
    pdmc_status status = PDMC_OK;
    const int count = terms->terms;
    double *value = NULL;
    if (functional->points == 0) return PDMC_OK;
    PDMC_NEW(value, (size_t)functional->points * (size_t)count);
    PDMC_TRY(evaluate(terms, threads, functional->points, functional->x, value));
    cblas_dgemv(CblasRowMajor, CblasTrans, functional->points, count, factor, value, count, functional->weight, 1, 1.0,
                sum, 1);
done:
    pdmc_free(value);
    return status;
}

pdmc_status pdmc_kansa_correct_tips(const pdmc_kansa_form *form, const pdmc_stiffness_terms *terms,
                                    const pdmc_field_functional release[], pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int threads = form->kansa->threads;
    for (int t = 0; t < model->tips; t++) {
        double *stiffness = &model->tip_stiffness[t * terms->terms];
        if (release[t].points == 0) continue;
        PDMC_TRY(add_functional(terms, threads, &release[t], 1.0, stiffness));
        PDMC_TRY(add_functional(terms, threads, &form->sensitivity[t], -1.0, stiffness));
    }
done:
    return status;
}
