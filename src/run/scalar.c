// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/scalar.h"

#include "base/base_impl.h"
#include "run/scalar_load.h"
#include "run/scalar_mesh.h"

#include <gsl/gsl_math.h>
#include <math.h>

// One level, while it is solved, and until the next one was compared with it.
typedef struct level {
    const pdmc_scalar *study;
    int number, threads;
    pdmc_mesh mesh;
    pdmc_space space;
    pdmc_scalar_kernel kernel;
    pdmc_scalar_load given; // what holds the field and pulls at it
    pdmc_form form;        // linear bonds; with a law at rest their tangent
    pdmc_law_bonds *bonds; // NULL where they are linear
    pdmc_newton newton;
    double *load, *u, *moved;    // [count], all values; moved: at the end of the motion
    const struct level *coarser; // the level before, NULL at the first
} level;

static void level_clear(level *l)
{
    pdmc_law_bonds_destroy(&l->bonds);
    pdmc_scalar_load_clear(&l->given);
    pdmc_form_clear(&l->form);
    pdmc_space_clear(&l->space);
    pdmc_mesh_clear(&l->mesh);
    pdmc_free(l->load);
    pdmc_free(l->u);
    pdmc_free(l->moved);
    *l = (level){0};
}

static bool has_law(const level *l)
{
    return l->study->law.kind != PDMC_LAW_LINEAR;
}

static pdmc_status make_form(level *l)
{
    pdmc_status status = PDMC_OK;
    const pdmc_scalar *s = l->study;
    const pdmc_form_rule rule = {s->outer, s->inner, s->parts};
    const double horizon = pdmc_scalar_level_of(s, l->number).horizon;
    PDMC_TRY(pdmc_space_create(&l->mesh, s->space, &l->space));
    PDMC_TRY(pdmc_scalar_kernel_create(s->dimension, horizon, s->power, s->weight_count > 0 ? s->weight_count : 1,
                                       s->weights, &l->kernel));
    PDMC_TRY(pdmc_scalar_load_create(s, &l->kernel, &l->given));
    if (has_law(l))
        PDMC_TRY(pdmc_law_bonds_create(&l->space, &l->kernel, &s->law, &rule, l->threads, &l->bonds));
    else PDMC_TRY(pdmc_form_peridynamic(&l->space, &l->kernel, &rule, l->threads, &l->form));
done:
    return status;
}

static pdmc_status solve_steady(level *l)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(l->load, l->space.count);
    PDMC_NEW(l->u, l->space.count);
    PDMC_TRY(pdmc_scalar_load_add(&l->given, &l->space, l->kernel.horizon, l->load));
    pdmc_scalar_load_prescribe(&l->given, &l->space, l->u);
    if (!has_law(l)) PDMC_TRY(pdmc_form_solve(&l->form, l->load, l->u));
    else PDMC_TRY(pdmc_law_bonds_solve(l->bonds, l->load, l->u, &l->newton));
done:
    return status;
}

// ---- differences ----

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
    PDMC_TRY(pdmc_space_create(&l->mesh, PDMC_SPACE_CONTINUOUS, &space));
    PDMC_TRY(pdmc_form_gradient(&space, &gradient));
    PDMC_NEW(load, space.free_count);
    PDMC_NEW(v, space.count);
    PDMC_NEW(rest, l->space.count);
    PDMC_TRY(pdmc_scalar_load_add(&l->given, &space, 0.0, load));
    pdmc_scalar_load_prescribe(&l->given, &space, v);
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

typedef struct {
    pdmc_locator *locator;
    const pdmc_space *space;
    const double *u;
} coarser_field;

static double coarser_at(const void *context, const double x[])
{
    const coarser_field *c = context;
    return pdmc_locator_value(c->locator, c->space, c->u, x);
}

static pdmc_status compare_to_coarser(const level *l, const double u[], const double coarser_u[], double *difference)
{
    pdmc_status status = PDMC_OK;
    coarser_field c = {.u = coarser_u};
    *difference = NAN;
    if (!l->coarser) return PDMC_OK;
    c.space = &l->coarser->space;
    PDMC_TRY(pdmc_locator_create(&l->coarser->mesh, &c.locator));
    PDMC_TRY(pdmc_space_distance(&l->space, u, coarser_at, &c, difference));
done:
    pdmc_locator_destroy(&c.locator);
    return status;
}

// ---- motion ----

// Of linear bonds; with a law of those of the field at rest or of no field, whichever has the shorter step.
static pdmc_status find_stable_step(level *l, const pdmc_form *mass, double *step, double *error)
{
    pdmc_status status = PDMC_OK;
    double largest = 0.0, largest_error = 0.0;
    for (int state = 0; state < (has_law(l) ? 2 : 1); state++) {
        double value, its_error;
        if (has_law(l)) {
            pdmc_form_clear(&l->form);
            PDMC_TRY(pdmc_law_bonds_tangent(l->bonds, state == 0 ? l->moved : l->u, &l->form));
        }
        PDMC_TRY(pdmc_form_largest_eigenvalue(&l->form, mass, &value, &its_error));
        if (value < largest) continue;
        largest = value;
        largest_error = its_error;
    }
    *step = pdmc_stable_step(largest);
    *error = *step * 0.5 * largest_error / largest;
done:
    return status;
}

// The wave, standing, from rest, and its layer with it; or what the study gives, from rest at 0. The step is halved with the
// spacing.
static pdmc_status move(level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int at = l->number;
    const double duration = l->study->duration, frequency = sqrt(l->given.lambda);
    pdmc_form mass = {0};
    const pdmc_wave end = pdmc_wave_times(&l->given.wave, cos(frequency * duration));
    PDMC_NEW(l->moved, l->space.count); // zero
    PDMC_TRY(pdmc_form_mass(&l->space, &mass));
    PDMC_TRY(find_stable_step(l, &mass, &record->stable_step[at], &record->stable_step_error[at]));
    record->steps[at] = ceil(duration / ldexp(l->study->safety * record->stable_step[at], -at));
    if (record->steps[at] > INT32_MAX) PDMC_FAIL(PDMC_ERR_CONFIG, "%.3g steps are too many", record->steps[at]);
    const int steps = (int)record->steps[at];
    if (l->study->has_wave) {
        pdmc_wave_fill(&l->given.wave, &l->space, l->moved);
        PDMC_TRY(pdmc_form_march(&l->form, &mass, l->space.count, NULL, duration / steps, steps, frequency, l->moved));
        PDMC_TRY(pdmc_space_distance(&l->space, l->moved, pdmc_wave_at, &end, &record->motion_error[at]));
        goto done;
    }
    pdmc_scalar_load_prescribe(&l->given, &l->space, l->moved);
    if (has_law(l))
        PDMC_TRY(pdmc_law_bonds_march(l->bonds, &mass, l->load, duration / steps, steps, l->moved, &record->drift[at]));
    else PDMC_TRY(pdmc_form_march(&l->form, &mass, l->space.count, l->load, duration / steps, steps, 0.0, l->moved));
    PDMC_TRY(compare_to_coarser(l, l->moved, l->coarser ? l->coarser->moved : NULL, &record->motion_error[at]));
done:
    pdmc_form_clear(&mass);
    return status;
}

// ---- records ----

static pdmc_status record_level(level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int at = l->number;
    record->spacing[at] = pdmc_mesh_spacing(&l->mesh);
    record->horizon[at] = l->kernel.horizon;
    record->elements[at] = l->mesh.element_count;
    record->unknowns[at] = l->space.free_count;
    record->entries[at] = record->iterations[at] = record->residual[at] = NAN;
    if (has_law(l)) {
        record->iterations[at] = l->newton.iterations;
        record->residual[at] = l->newton.residual[l->newton.iterations];
    } else {
        record->entries[at] = (double)l->form.start[l->form.free_count];
    }
    record->classical[at] = record->stable_step[at] = record->stable_step_error[at] = NAN;
    record->motion_error[at] = record->steps[at] = record->drift[at] = NAN;
    if (l->study->has_wave)
        PDMC_TRY(pdmc_space_distance(&l->space, l->u, pdmc_wave_at, &l->given.wave, &record->error[at]));
    else PDMC_TRY(compare_to_coarser(l, l->u, l->coarser ? l->coarser->u : NULL, &record->error[at]));
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
    pdmc_free(record->moved);
    record->position = record->value = record->wave = record->moved = NULL;
    record->value_count = 0;
}

// In place of that of the level before.
static pdmc_status record_field(const level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int n = l->space.count, d = l->mesh.dimension;
    drop_field(record);
    PDMC_NEW(record->position, 2 * (size_t)n);
    PDMC_NEW(record->value, n);
    PDMC_NEW(record->wave, n);
    PDMC_NEW(record->moved, n);
    record->value_count = n;
    if (l->study->has_wave) pdmc_wave_fill(&l->given.wave, &l->space, record->wave);
    for (int i = 0; i < n; i++) {
        record->value[i] = l->u[i];
        record->moved[i] = l->moved ? l->moved[i] : NAN;
        if (!l->study->has_wave) record->wave[i] = NAN;
        for (int k = 0; k < d; k++) record->position[2 * i + k] = l->space.x[d * i + k];
    }
done:
    return status;
}

static pdmc_status run_level(level *l, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    PDMC_TRY(pdmc_run_mesh(l->study, l->number, l->coarser ? &l->coarser->mesh : NULL, &l->mesh));
    PDMC_TRY(make_form(l));
    PDMC_TRY(solve_steady(l));
    PDMC_TRY(record_level(l, record));
    PDMC_TRY(record_field(l, record));
    record->seconds[l->number] = pdmc_seconds() - start;
    record->level_count = l->number + 1;
done:
    pdmc_form_clear(&l->form); // the next level needs values alone
    return status == PDMC_ERR_ARG ? pdmc_raise(PDMC_ERR_CONFIG, "level %d: %s", l->number + 1, pdmc_last_error())
                                  : status;
}

static pdmc_status prepare(const pdmc_scalar *study, pdmc_scalar_record *record)
{
    pdmc_status status = PDMC_OK;
    const int n = study->levels;
    record->dimension = study->dimension;
    record->power = study->power;
    record->wave_number = study->has_wave ? 2.0 * M_PI / study->wave_length : NAN;
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
    PDMC_NEW(record->drift, n);
    PDMC_NEW(record->iterations, n);
    PDMC_NEW(record->residual, n);
    PDMC_NEW(record->seconds, n);
done:
    return status;
}

pdmc_status pdmc_run_scalar(const pdmc_scalar *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_scalar_record *record = &results->scalar;
    level levels[2] = {{0}}; // one and the one before, in turn
    bool goes_on = true;
    PDMC_TRY(prepare(study, record));
    for (int i = 0; i < study->levels && goes_on; i++) {
        goes_on = !options->progress || options->progress(options->context, i, study->levels);
        if (!goes_on) break;
        level_clear(&levels[i % 2]);
        levels[i % 2] = (level){.study = study, .number = i, .threads = options->threads,
                                .coarser = i > 0 ? &levels[(i + 1) % 2] : NULL};
        PDMC_TRY(run_level(&levels[i % 2], record));
    }
    if (record->level_count == 0)
        PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before the first level: there is nothing to save");
    if (!goes_on) results->status = PDMC_RUN_INTERRUPTED;
    else if (options->progress) options->progress(options->context, study->levels, study->levels);
    results->runtime.threads = options->threads;
    pdmc_free(results->mesh_generator);
    results->mesh_generator = pdmc_strdup(levels[(record->level_count - 1) % 2].mesh.generator);
    if (!results->mesh_generator) status = PDMC_ERR_NOMEM;
done:
    for (int i = 0; i < 2; i++) level_clear(&levels[i]);
    return status;
}
