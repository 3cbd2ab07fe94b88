// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/relaxation.h"

#include "base/base_impl.h"

#include <math.h>

typedef struct {
    const pdmc_relaxation_model *model;
    const pdmc_relaxation_options *options;
    double *x;                           // the caller's
    double *velocity, *force, *previous; // velocity in the middle of steps
} relaxation;

static pdmc_status check(const pdmc_relaxation_model *model, const pdmc_relaxation_options *options)
{
    PDMC_REQUIRE(options->tolerance > 0.0 && options->scale > 0.0, "the tolerance of relaxation must be positive");
    PDMC_REQUIRE(options->damping < 2.0, "a damping of %g or more stops the motion of relaxation", 2.0);
    for (size_t i = 0; i < model->unknowns; i++)
        PDMC_REQUIRE(model->mass[i] > 0.0, "fictitious masses must be positive");
    return PDMC_OK;
}

static double residual_of(const relaxation *r)
{
    double sum = 0.0;
    for (size_t i = 0; i < r->model->unknowns; i++)
        if (isfinite(r->model->mass[i])) sum += r->force[i] * r->force[i];
    return sqrt(sum) / r->options->scale;
}

/// Eight tenths of the critical damping of the mode in which the body moves, by Rayleigh's quotient: damped a little less
/// than critically, and begun anew where it swings back, a motion comes to rest sooner. A quotient that is negative,
/// where bonds have broken, gives none.
static double adaptive_damping(const relaxation *r)
{
    double stiffness = 0.0, inertia = 0.0;
    for (size_t i = 0; i < r->model->unknowns; i++) {
        if (!isfinite(r->model->mass[i])) continue;
        stiffness += r->velocity[i] * (r->previous[i] - r->force[i]);
        inertia += r->velocity[i] * r->velocity[i] * r->model->mass[i];
    }
    if (!(stiffness > 0.0)) return 0.0;
    return fmin(1.9, 0.8 * 2.0 * sqrt(stiffness / inertia));
}

/// Whether the body moves against its forces.
static bool swings_back(const relaxation *r)
{
    double power = 0.0;
    for (size_t i = 0; i < r->model->unknowns; i++)
        if (isfinite(r->model->mass[i])) power += r->velocity[i] * r->force[i];
    return power < 0.0;
}

static bool is_adaptive(const relaxation *r)
{
    return r->options->damping < 0.0;
}

/// Eq. 4.58, from rest with a step of 1: a half of it, since a whole one from rest to rest can overshoot by more and more.
static void begin(relaxation *r)
{
    for (size_t i = 0; i < r->model->unknowns; i++) {
        r->velocity[i] = 0.5 * r->force[i] / r->model->mass[i];
        r->x[i] += r->velocity[i];
    }
}

/// Eq. 4.55 and 4.56 with a step of 1.
static void move(relaxation *r, double damping)
{
    for (size_t i = 0; i < r->model->unknowns; i++) {
        const double push = r->force[i] / r->model->mass[i];
        r->velocity[i] = ((2.0 - damping) * r->velocity[i] + 2.0 * push) / (2.0 + damping);
        r->x[i] += r->velocity[i];
    }
}

static pdmc_status find_forces(relaxation *r)
{
    double *oldest = r->previous;
    r->previous = r->force;
    r->force = oldest;
    return r->model->force(r->model->context, r->x, r->force);
}

static pdmc_status run(relaxation *r, bool (*observe)(void *, const pdmc_relaxation_state *), void *context,
                       pdmc_relaxation_state *state)
{
    pdmc_status status = PDMC_OK;
    const pdmc_relaxation_options *o = r->options;
    for (state->steps = 0;; state->steps++) {
        PDMC_TRY(find_forces(r));
        state->residual = residual_of(r);
        if (observe && !observe(context, state)) PDMC_FAIL(PDMC_ERR_INTERRUPTED, "relaxation stopped");
        if (state->residual <= o->tolerance) break;
        if (!isfinite(state->residual) || state->steps == o->max_steps)
            PDMC_FAIL(PDMC_ERR_SINGULAR, "no rest after %d steps of relaxation: residual %g, wanted %g", state->steps,
                      state->residual, o->tolerance);
        const bool from_rest = state->steps == 0 || (is_adaptive(r) && swings_back(r));
        state->damping = !is_adaptive(r) ? o->damping : from_rest ? 0.0 : adaptive_damping(r);
        if (from_rest) begin(r);
        else move(r, state->damping);
    }
done:
    return status;
}

pdmc_status pdmc_relax(const pdmc_relaxation_model *model, const pdmc_relaxation_options *options, double x[],
                       bool (*observe)(void *context, const pdmc_relaxation_state *state), void *context,
                       pdmc_relaxation_state *state)
{
    pdmc_status status = PDMC_OK;
    relaxation r = {.model = model, .options = options, .x = x};
    double *memory = NULL;
    *state = (pdmc_relaxation_state){0};
    PDMC_TRY(check(model, options));
    PDMC_NEW(memory, 3 * model->unknowns);
    r.velocity = memory;
    r.force = r.velocity + model->unknowns;
    r.previous = r.force + model->unknowns;
    PDMC_TRY(run(&r, observe, context, state));
done:
    pdmc_free(memory);
    return status;
}
