// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/scalar_load.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

// ---- waves ----

double pdmc_wave_at(const void *context, const double x[])
{
    const pdmc_wave *w = context;
    double angle = w->phase;
    for (int d = 0; d < w->dimension; d++) angle += w->number[d] * x[d];
    return w->factor * sin(angle);
}

pdmc_wave pdmc_wave_times(const pdmc_wave *wave, double factor)
{
    pdmc_wave product = *wave;
    product.factor *= factor;
    return product;
}

void pdmc_wave_fill(const pdmc_wave *wave, const pdmc_space *space, double u[])
{
    const size_t d = (size_t)space->mesh->dimension;
    for (int i = 0; i < space->count; i++) u[i] = pdmc_wave_at(wave, &space->x[d * (size_t)i]);
}

static pdmc_wave wave_of(const pdmc_scalar *study)
{
    const double number = 2.0 * M_PI / study->wave_length, radian = M_PI / 180.0;
    return (pdmc_wave){.dimension = study->dimension,
                       .number = {number * cos(study->angle * radian), number * sin(study->angle * radian)},
                       .phase = study->phase * radian,
                       .factor = 1.0};
}

// ---- loads ----

pdmc_status pdmc_scalar_load_create(const pdmc_scalar *study, const pdmc_scalar_kernel *kernel, pdmc_scalar_load *load)
{
    pdmc_status status = PDMC_OK;
    pdmc_scalar_load made = {.study = study};
    *load = (pdmc_scalar_load){0};
    if (study->has_wave) {
        const double number = 2.0 * M_PI / study->wave_length;
        made.wave = wave_of(study);
        made.lambda = number * number;
        if (study->vary == PDMC_VARY_SPACING) PDMC_TRY(pdmc_scalar_dispersion(kernel, number, &made.lambda));
        if (study->law.kind != PDMC_LAW_LINEAR) PDMC_TRY(pdmc_horizon_points(kernel, &made.half));
    }
    *load = made;
done:
    return status;
}

void pdmc_scalar_load_clear(pdmc_scalar_load *load)
{
    pdmc_area_rule_clear(&load->half);
    *load = (pdmc_scalar_load){0};
}

// The source of the wave where bonds have a law: -L u.
static double source_of_law(const void *context, const double x[])
{
    const pdmc_scalar_load *load = context;
    const double place[2] = {x[0], load->study->dimension == 2 ? x[1] : 0.0};
    return -pdmc_law_operator(&load->half, &load->study->law, pdmc_wave_at, &load->wave, place);
}

static double source_of_study(const void *context, const double x[])
{
    const pdmc_scalar_load *load = context;
    return pdmc_given_at(&load->study->source, load->study->dimension, x);
}

static void add_side(const pdmc_scalar *study, const pdmc_open_side *open, const pdmc_space *space, double depth,
                     double out[])
{
    const int axis = open->side / 2;
    const double sign = open->side % 2 ? 1.0 : -1.0, end = 0.5 * sign * (axis == 0 ? study->width : study->height);
    const double inner = end - sign * depth;
    if (depth == 0.0) pdmc_space_add_flux(space, axis, end, open->flux, out);
    else pdmc_space_add_layer(space, axis, fmin(inner, end), fmax(inner, end), open->flux / depth, out);
}

pdmc_status pdmc_scalar_load_add(const pdmc_scalar_load *load, const pdmc_space *space, double depth, double out[])
{
    const pdmc_scalar *study = load->study;
    const pdmc_wave source = pdmc_wave_times(&load->wave, load->lambda);
    if (study->has_wave && study->law.kind == PDMC_LAW_LINEAR) return pdmc_space_load(space, pdmc_wave_at, &source, out);
    if (study->has_wave) return pdmc_space_load(space, source_of_law, load, out);
    const pdmc_status status = pdmc_space_load(space, source_of_study, load, out);
    for (int i = 0; i < study->open_count && status == PDMC_OK; i++)
        add_side(study, &study->open[i], space, depth, out);
    return status;
}

void pdmc_scalar_load_prescribe(const pdmc_scalar_load *load, const pdmc_space *space, double u[])
{
    const int d = space->mesh->dimension;
    for (int i = space->free_count; i < space->count; i++) {
        const double *x = &space->x[(size_t)d * (size_t)i];
        u[i] = load->study->has_wave ? pdmc_wave_at(&load->wave, x) : pdmc_given_at(&load->study->prescribed, d, x);
    }
}
