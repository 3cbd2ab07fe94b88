// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/scalar.h"

#include "base/base_impl.h"
#include "run/scalar_mesh.h"

#include <gsl/gsl_math.h>
#include <math.h>

typedef struct {
    int dimension;
    double number[2], phase, factor; // radians, 1 / length
} wave;

static double wave_at(const void *context, const double x[])
{
    const wave *w = context;
    double angle = w->phase;
    for (int d = 0; d < w->dimension; d++) angle += w->number[d] * x[d];
    return w->factor * sin(angle);
}

static wave wave_of(const pdmc_scalar *study)
{
    const double number = 2.0 * M_PI / study->wave_length, radian = M_PI / 180.0;
    return (wave){.dimension = study->dimension,
                  .number = {number * cos(study->angle * radian), number * sin(study->angle * radian)},
                  .phase = study->phase * radian,
                  .factor = 1.0};
}

// One level, while it is solved.
typedef struct {
    const pdmc_scalar *study;
    int number, threads;
    wave wave;
    double lambda; // of the kernel, or of the classical wave where the horizon varies
    const pdmc_mesh *mesh;
    pdmc_space space;
    pdmc_scalar_kernel kernel;
    pdmc_form form;
    double *load, *u; // [count], all values
} level;

static void level_clear(level *l)
{
    pdmc_form_clear(&l->form);
    pdmc_space_clear(&l->space);
    pdmc_free(l->load);
    pdmc_free(l->u);
}

static pdmc_status make_form(level *l)
{
    pdmc_status status = PDMC_OK;
    const pdmc_scalar *s = l->study;
    const pdmc_form_rule rule = {s->outer, s->inner, s->parts};
    const double horizon = pdmc_scalar_level_of(s, l->number).horizon;
    PDMC_TRY(pdmc_space_create(l->mesh, s->space, &l->space));
    PDMC_TRY(pdmc_scalar_kernel_create(s->dimension, horizon, s->power, s->weight_count > 0 ? s->weight_count : 1,
                                       s->weights, &l->kernel));
    PDMC_TRY(pdmc_form_peridynamic(&l->space, &l->kernel, &rule, l->threads, &l->form));
done:
    return status;
}

static void set_wave(const pdmc_space *space, const wave *w, int first, double u[])
{
    const size_t d = (size_t)space->mesh->dimension;
    for (int i = first; i < space->count; i++) u[i] = wave_at(w, &space->x[d * (size_t)i]);
}

static pdmc_status solve_steady(level *l)
{
    pdmc_status status = PDMC_OK;
    const double number = 2.0 * M_PI / l->study->wave_length;
    wave source = l->wave;
    l->lambda = number * number;
    if (l->study->vary == PDMC_VARY_SPACING) PDMC_TRY(pdmc_scalar_dispersion(&l->kernel, number, &l->lambda));
    source.factor = l->lambda;
    PDMC_NEW(l->load, l->space.count);
    PDMC_NEW(l->u, l->space.count);
    PDMC_TRY(pdmc_space_load(&l->space, wave_at, &source, l->load));
    set_wave(&l->space, &l->wave, l->space.free_count, l->u);
    PDMC_TRY(pdmc_form_solve(&l->form, l->load, l->u));
done:
    return status;
}

// u as it is in each element less v, which is continuous: as values of the space of u.
static void subtract(const pdmc_space *of_u, const pdmc_space *of_v, const double u[], const double v[], double out[])
{
    const int corners = of_u->mesh->element_count * (of_u->mesh->dimension + 1);
    for (int k = 0; k < corners; k++) out[of_u->value[k]] = u[of_u->value[k]] - v[of_v->value[k]];
}

// The difference to classical elements on the same mesh, with the same source and the same values in the layer.
static pdmc_status compare_to_classical(level *l, double *difference)
{
    pdmc_status status = PDMC_OK;
    pdmc_space space = {0};
    pdmc_form gradient = {0};
    double *v = NULL, *load = NULL, *rest = NULL;
    wave source = l->wave;
    source.factor = l->lambda;
    PDMC_TRY(pdmc_space_create(l->mesh, PDMC_SPACE_CONTINUOUS, &space));
    PDMC_TRY(pdmc_form_gradient(&space, &gradient));
    PDMC_NEW(load, space.free_count);
    PDMC_NEW(v, space.count);
    PDMC_NEW(rest, l->space.count);
    PDMC_TRY(pdmc_space_load(&space, wave_at, &source, load));
    set_wave(&space, &l->wave, space.free_count, v);
    PDMC_TRY(pdmc_form_solve(&gradient, load, v));
    subtract(&l->space, &space, l->u, v, rest);
    PDMC_TRY(pdmc_space_distance(&l->space, rest, NULL, NULL, difference));
done:
    pdmc_space_clear(&space);
    pdmc_form_clear(&gradient);
    pdmc_free(v);
    pdmc_free(load);
    pdmc_free(rest);
    return status;
}

// The same wave, standing, from rest; its layer moves with it. The step is halved with the spacing.
static pdmc_status move(level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int at = l->number;
    const double frequency = sqrt(l->lambda), duration = l->study->duration;
    pdmc_form mass = {0};
    double *u = NULL, largest, error;
    wave end = l->wave;
    PDMC_TRY(pdmc_form_mass(&l->space, &mass));
    PDMC_TRY(pdmc_form_largest_eigenvalue(&l->form, &mass, &largest, &error));
    record->stable_step[at] = pdmc_stable_step(largest);
    record->stable_step_error[at] = record->stable_step[at] * 0.5 * error / largest;
    record->steps[at] = ceil(duration / ldexp(l->study->safety * record->stable_step[at], -at));
    if (record->steps[at] > INT32_MAX) PDMC_FAIL(PDMC_ERR_CONFIG, "%.3g steps are too many", record->steps[at]);
    PDMC_NEW(u, l->space.count);
    set_wave(&l->space, &l->wave, 0, u);
    PDMC_TRY(pdmc_form_march(&l->form, &mass, l->space.count, NULL, duration / record->steps[at], (int)record->steps[at],
                             frequency, u));
    end.factor = cos(frequency * duration);
    PDMC_TRY(pdmc_space_distance(&l->space, u, wave_at, &end, &record->motion_error[at]));
done:
    pdmc_form_clear(&mass);
    pdmc_free(u);
    return status;
}

static pdmc_status record_level(level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int at = l->number;
    record->spacing[at] = pdmc_mesh_spacing(l->mesh);
    record->horizon[at] = l->kernel.horizon;
    record->elements[at] = l->mesh->element_count;
    record->unknowns[at] = l->space.free_count;
    record->entries[at] = (double)l->form.start[l->form.free_count];
    record->classical[at] = record->stable_step[at] = record->stable_step_error[at] = NAN;
    record->motion_error[at] = record->steps[at] = NAN;
    PDMC_TRY(pdmc_space_distance(&l->space, l->u, wave_at, &l->wave, &record->error[at]));
    if (l->study->vary == PDMC_VARY_HORIZON) PDMC_TRY(compare_to_classical(l, &record->classical[at]));
    if (l->study->has_duration) PDMC_TRY(move(l, record));
done:
    return status;
}

static void drop_field(pdmc_scalar_record *record)
{
    pdmc_free(record->position);
    pdmc_free(record->value);
    pdmc_free(record->wave);
    record->position = record->value = record->wave = NULL;
    record->value_count = 0;
}

// In place of that of the level before.
static pdmc_status record_field(const level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int n = l->space.count, d = l->mesh->dimension;
    drop_field(record);
    PDMC_NEW(record->position, 2 * (size_t)n);
    PDMC_NEW(record->value, n);
    PDMC_NEW(record->wave, n);
    record->value_count = n;
    set_wave(&l->space, &l->wave, 0, record->wave);
    for (int i = 0; i < n; i++) {
        record->value[i] = l->u[i];
        for (int k = 0; k < d; k++) record->position[2 * i + k] = l->space.x[d * i + k];
    }
done:
    return status;
}

static pdmc_status run_level(const pdmc_scalar *study, int number, int threads, pdmc_mesh *mesh,
                             pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    level l = {.study = study, .number = number, .threads = threads, .wave = wave_of(study), .mesh = mesh};
    PDMC_TRY(pdmc_run_next_mesh(study, number, mesh));
    PDMC_TRY(make_form(&l));
    PDMC_TRY(solve_steady(&l));
    PDMC_TRY(record_level(&l, record));
    PDMC_TRY(record_field(&l, record));
    record->seconds[number] = pdmc_seconds() - start;
    record->level_count = number + 1;
done:
    level_clear(&l);
    return status == PDMC_ERR_ARG ? pdmc_raise(PDMC_ERR_CONFIG, "level %d: %s", number + 1, pdmc_last_error()) : status;
}

static pdmc_status prepare(const pdmc_scalar *study, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int n = study->levels;
    record->dimension = study->dimension;
    record->power = study->power;
    record->wave_number = 2.0 * M_PI / study->wave_length;
    PDMC_NEW(record->spacing, n);
    PDMC_NEW(record->horizon, n);
    PDMC_NEW(record->elements, n);
    PDMC_NEW(record->unknowns, n);
    PDMC_NEW(record->entries, n);
    PDMC_NEW(record->error, n);
    PDMC_NEW(record->classical, n);
    PDMC_NEW(record->stable_step, n);
    PDMC_NEW(record->stable_step_error, n);
    PDMC_NEW(record->motion_error, n);
    PDMC_NEW(record->steps, n);
    PDMC_NEW(record->seconds, n);
done:
    return status;
}

pdmc_status pdmc_run_scalar(const pdmc_scalar *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_scalar_record *record = &results->scalar;
    pdmc_mesh mesh = {0};
    bool goes_on = true;
    PDMC_TRY(prepare(study, record));
    for (int i = 0; i < study->levels && goes_on; i++) {
        goes_on = !options->progress || options->progress(options->context, i, study->levels);
        if (goes_on) PDMC_TRY(run_level(study, i, options->threads, &mesh, record));
    }
    if (record->level_count == 0)
        PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before the first level: there is nothing to save");
    if (!goes_on) results->status = PDMC_RUN_INTERRUPTED;
    else if (options->progress) options->progress(options->context, study->levels, study->levels);
    results->runtime.threads = options->threads;
    results->mesh_generator = pdmc_strdup(mesh.generator);
    if (!results->mesh_generator) status = PDMC_ERR_NOMEM;
done:
    pdmc_mesh_clear(&mesh);
    return status;
}
