// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/stiffness_form.h"

#include "base/base_impl.h"
#include "kansa/weak_form.h"
#include "kansa/weak_rows.h"

#include <cblas.h>
#include <lapacke.h>
#include <string.h>

enum {
    CHUNK = 256, // points whose rows are made at a time
    PANEL = 64,  // rows of a task, the same for any number of threads
};

void pdmc_kansa_form_transform(const pdmc_kansa_form *form, int count, double row[])
{
    const int n = form->unknowns;
#pragma omp parallel for schedule(dynamic) num_threads(form->kansa->threads)
    for (int first = 0; first < count; first += PANEL)
        cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n,
                    count - first < PANEL ? count - first : PANEL, 1.0, form->root, n, &row[(size_t)first * (size_t)n],
                    n);
}

void pdmc_kansa_form_strains(const pdmc_kansa_form *form, int first, int points, int count, const double v[],
                             double e[])
{
    const int n = form->unknowns;
    const double *strain = &form->strain[PDMC_STRAIN_ROWS * (size_t)first * (size_t)n];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, PDMC_STRAIN_ROWS * points, count, n, 1.0, strain, n, v, n, 0.0,
                e, count);
}

// The strain rows in y, and their energy.
static pdmc_status integrate_plate(pdmc_kansa_form *form, const pdmc_area_rule *rule, double stiffness[])
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)form->unknowns;
    form->points = rule->count;
    PDMC_NEW(form->x, 2 * rule->count);
    memcpy(form->x, rule->x, 2 * (size_t)rule->count * sizeof(double));
    PDMC_NEW(form->strain, PDMC_STRAIN_ROWS * (size_t)rule->count * n);
    for (int first = 0; first < rule->count; first += CHUNK) {
        const int count = rule->count - first < CHUNK ? rule->count - first : CHUNK;
        double *strain = &form->strain[PDMC_STRAIN_ROWS * (size_t)first * n];
        PDMC_TRY(pdmc_weak_fill_rows(form->kansa, rule, first, count, strain, NULL));
        pdmc_weak_add_gram(form->kansa, PDMC_STRAIN_ROWS * count, strain, stiffness);
    }
done:
    return status;
}

// The collocation's own rows of the rigid motions that nothing holds, which are those of Q after the boundary's.
pdmc_status pdmc_kansa_form_add_gauge(const pdmc_kansa *kansa, double stiffness[])
{
    int motions;
    double motion[3][3];
    const int n = kansa->unknowns, first = 2 * (kansa->points.interior_count + kansa->points.boundary_count);
    const pdmc_status status = pdmc_problem_free_motions(kansa->problem, &motions, motion);
    // the rows are stresses, the form is an energy
    const double scale =
        kansa->problem->plate.width * kansa->problem->plate.height / kansa->problem->material.youngs_modulus;
    for (int m = 0; m < motions && status == PDMC_OK; m++)
        cblas_dsyr(CblasColMajor, CblasLower, n, scale, &kansa->q[first + m], kansa->rows, stiffness, n);
    return status;
}

static pdmc_status factor(pdmc_kansa_form *form)
{
    const int n = form->unknowns, info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, form->root, n);
    if (info < 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dpotrf returned %d", info);
    if (info > 0)
        return pdmc_raise(PDMC_ERR_SINGULAR,
                          "the energy of the trial functions is not positive (function %d of %d): take a smaller "
                          "solver.shape or a larger solver.spacing",
                          info, n);
    pdmc_kansa_form_transform(form, PDMC_STRAIN_ROWS * form->points, form->strain);
    pdmc_kansa_form_transform(form, 1, form->fixed);
    pdmc_kansa_form_transform(form, form->kansa->loads.count, form->load);
    return PDMC_OK;
}

static pdmc_status fill_intensity(pdmc_kansa_form *form)
{
    pdmc_status status = PDMC_OK;
    const pdmc_energy_request *energy = &form->kansa->problem->energy;
    const size_t n = (size_t)form->unknowns;
    PDMC_NEW(form->intensity, 2 * (size_t)energy->tip_count * n);
    for (int t = 0; t < energy->tip_count; t++) {
        double *row = &form->intensity[2 * (size_t)t * n];
        pdmc_kansa_stress_intensity_rows(form->kansa, energy->tips[t], row, row + n);
    }
    if (energy->tip_count > 0) pdmc_kansa_whiten(form->kansa, 2 * energy->tip_count, form->intensity);
    pdmc_kansa_form_transform(form, 2 * energy->tip_count, form->intensity);
done:
    return status;
}

static pdmc_status assemble(pdmc_kansa_form *form)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)form->unknowns;
    pdmc_area_rule rule = {0};
    pdmc_weak_form weak = {0};
    PDMC_NEW(weak.stiffness, n * n);
    PDMC_NEW(weak.fixed, n);
    PDMC_NEW(weak.load, (size_t)form->kansa->loads.count * n);
    PDMC_TRY(pdmc_weak_rule(form->kansa, &rule));
    PDMC_TRY(integrate_plate(form, &rule, weak.stiffness));
    PDMC_TRY(pdmc_weak_form_add_sides(form->kansa, &weak));
    PDMC_TRY(pdmc_kansa_form_add_gauge(form->kansa, weak.stiffness));
    form->root = weak.stiffness;
    form->fixed = weak.fixed;
    form->load = weak.load;
    weak = (pdmc_weak_form){0};
    PDMC_TRY(factor(form));
    PDMC_TRY(fill_intensity(form));
    PDMC_TRY(pdmc_kansa_form_find_sensitivity(form));
done:
    pdmc_weak_form_clear(&weak);
    pdmc_area_rule_clear(&rule);
    return status;
}

pdmc_status pdmc_kansa_form_create(const pdmc_kansa *kansa, pdmc_kansa_form **form)
{
    pdmc_status status = PDMC_OK;
    pdmc_kansa_form *made = NULL;
    PDMC_NEW(made, 1);
    made->kansa = kansa;
    made->unknowns = kansa->unknowns;
    PDMC_TRY(assemble(made));
    *form = made;
    made = NULL;
done:
    pdmc_kansa_form_destroy(&made);
    return status;
}

void pdmc_kansa_form_destroy(pdmc_kansa_form **form)
{
    pdmc_kansa_form *old = *form;
    if (!old) return;
    for (int t = 0; old->sensitivity && t < old->kansa->problem->energy.tip_count; t++) {
        pdmc_free((double *)old->sensitivity[t].x);
        pdmc_free((double *)old->sensitivity[t].weight);
    }
    pdmc_free(old->sensitivity);
    pdmc_free(old->x);
    pdmc_free(old->strain);
    pdmc_free(old->root);
    pdmc_free(old->fixed);
    pdmc_free(old->load);
    pdmc_free(old->intensity);
    pdmc_free(old);
    *form = NULL;
}
