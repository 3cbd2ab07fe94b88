// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Steady problems with a plane wave as their solution, in a box of length 1: L u + b = 0 with b = lambda u.

#include "pdmc/galerkin.h"

#include "check.h"

#include <gsl/gsl_math.h>

typedef struct {
    int dimension;
    double number[2], phase, factor;
} wave;

static inline double wave_at(const void *context, const double x[])
{
    const wave *w = context;
    double angle = w->phase;
    for (int d = 0; d < w->dimension; d++) angle += w->number[d] * x[d];
    return w->factor * sin(angle);
}

static inline wave wave_of(int dimension)
{
    return (wave){.dimension = dimension, .number = {dimension == 1 ? 5.0 : 3.0, 4.0}, .phase = 0.7, .factor = 1.0};
}

typedef struct {
    int dimension, cells;
    double horizon, power;
    pdmc_space_kind space;
    pdmc_form_rule rule;
} steady;

typedef struct {
    pdmc_mesh mesh;
    pdmc_space space;
    pdmc_scalar_kernel kernel;
} setting;

static inline void setting_create(const steady *s, setting *out)
{
    const double size[2] = {1.0, 1.0}, from[2] = {-0.21, -0.21}, to[2] = {0.21, 0.21};
    const int cells[2] = {s->cells, s->cells};
    CHECK_OK(pdmc_mesh_box(s->dimension, size, cells, s->horizon, &out->mesh));
    pdmc_mesh_mark_rough(&out->mesh, from, to);
    CHECK_OK(pdmc_space_create(&out->mesh, s->space, &out->space));
    CHECK_OK(pdmc_scalar_kernel_create(s->dimension, s->horizon, s->power, 1, NULL, &out->kernel));
}

static inline void setting_clear(setting *s)
{
    pdmc_space_clear(&s->space);
    pdmc_mesh_clear(&s->mesh);
}

/// Solves form u = factor (w, v) with the wave in the layer; u [count], to be freed.
static inline pdmc_status wave_solve(const setting *s, const pdmc_form *form, const wave *w, double factor, double **u)
{
    const size_t d = (size_t)s->mesh.dimension;
    double *load = pdmc_calloc((size_t)s->space.free_count, sizeof *load);
    wave force = *w;
    force.factor *= factor;
    *u = pdmc_calloc((size_t)s->space.count, sizeof **u);
    CHECK_OK(pdmc_space_load(&s->space, wave_at, &force, load));
    for (int i = s->space.free_count; i < s->space.count; i++) (*u)[i] = wave_at(w, &s->space.x[d * (size_t)i]);
    const pdmc_status status = pdmc_form_solve(form, load, *u);
    pdmc_free(load);
    return status;
}

/// The error of the steady wave, root of its mean square.
static inline double wave_error(const steady *s)
{
    setting at;
    pdmc_form form;
    double lambda, error, *u;
    const wave w = wave_of(s->dimension);
    setting_create(s, &at);
    CHECK_OK(pdmc_form_peridynamic(&at.space, &at.kernel, &s->rule, 2, &form));
    CHECK_OK(pdmc_scalar_dispersion(&at.kernel, 5.0, &lambda));
    CHECK_OK(wave_solve(&at, &form, &w, lambda, &u));
    CHECK_OK(pdmc_space_distance(&at.space, u, wave_at, &w, &error));
    pdmc_free(u);
    pdmc_form_clear(&form);
    setting_clear(&at);
    return error;
}
