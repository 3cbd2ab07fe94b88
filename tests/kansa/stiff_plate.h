// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The cracked plate of the other tests, half length 0.5, and its weak form; stiffnesses that vary by given functions.

#include "kansa/plate.h"
#include "kansa/stiffness_operator.h"
#include "support/modulus_fields.h"

#include <stdlib.h>

typedef struct {
    plate p;
    pdmc_kansa *kansa;
    pdmc_kansa_form *form;
} stiff_plate;

static inline void stiff_plate_make(stiff_plate *s, int cells, double angle, int threads)
{
    plate_make_cracked(&s->p, 0.5, angle, cells);
    s->p.uncertainties[0] = (pdmc_uncertainty){.quantity = PDMC_QUANTITY_STIFFNESS};
    s->p.problem.uncertainty_count = 1;
    s->kansa = NULL;
    s->form = NULL;
    CHECK_OK(pdmc_kansa_create(&s->p.problem, NULL, threads, &s->kansa));
    CHECK_OK(pdmc_kansa_form_create(s->kansa, &s->form));
}

static inline void stiff_plate_clear(stiff_plate *s)
{
    pdmc_kansa_form_destroy(&s->form);
    pdmc_kansa_destroy(&s->kansa);
}

/// psi_k = M_k - 1 of factors M_k on Young's modulus.
typedef struct {
    int count;
    double (*modulus)(const void *context, const double x[2]);
    const void *context[4];
} given_moduli;

static inline pdmc_status given_moduli_at(const void *context, int points, const double x[], double value[])
{
    const given_moduli *given = context;
    for (int p = 0; p < points; p++)
        for (int k = 0; k < given->count; k++)
            value[p * given->count + k] = given->modulus(given->context[k], &x[2 * p]) - 1.0;
    return PDMC_OK;
}

static inline void stiff_plate_model(const stiff_plate *s, const given_moduli *given, pdmc_affine *model)
{
    const pdmc_stiffness_terms terms = {given->count, given, given_moduli_at};
    CHECK_OK(pdmc_kansa_form_affine(s->form, &terms, model));
}

static inline double *new_values(size_t count)
{
    double *values = calloc(count, sizeof *values);
    assert_non_null(values);
    return values;
}

static inline double inner(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/// K_I and K_II of a tip of a solution, and G.
static inline double energy_release_rate(const pdmc_affine *model, int tip, const double xi[], const double x[],
                                         double K[2])
{
    double stiffness = 1.0;
    for (int k = 0; k < model->terms; k++) stiffness += xi[k] * model->tip_stiffness[tip * model->terms + k];
    for (int k = 0; k < 2; k++)
        K[k] = stiffness * inner(model->unknowns, &model->stress_intensity[(2 * tip + k) * model->unknowns], x);
    return (K[0] * K[0] + K[1] * K[1]) / stiffness; // E = 1, plane stress
}

static inline double solved_energy(const pdmc_affine *model, int tip, const double xi[])
{
    const double scale[2] = {1.0, 1.0};
    double K[2], *x = new_values((size_t)model->unknowns);
    CHECK_OK(model->verbs->solve(model, xi, scale, x));
    const double G = energy_release_rate(model, tip, xi, x, K);
    free(x);
    return G;
}
