// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/dynamics.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

void pdmc_motion_model_clear(pdmc_motion_model *model)
{
    if (model->method) model->destroy(model->method);
    *model = (pdmc_motion_model){0};
}

double pdmc_history_at(const pdmc_history *history, double time)
{
    const int last = history->count - 1;
    if (time <= history->time[0]) return history->factor[0];
    for (int i = 1; i <= last; i++) {
        if (time > history->time[i]) continue;
        const double share = (time - history->time[i - 1]) / (history->time[i] - history->time[i - 1]);
        return history->factor[i - 1] + share * (history->factor[i] - history->factor[i - 1]);
    }
    return history->factor[last];
}

double pdmc_motion_inertia(const pdmc_motion_options *options)
{
    return options->density * (1.0 + 0.5 * options->damping * options->step) * 4.0 / (options->step * options->step);
}

// x, v and a at the end of the last step, x before it, and the state about which inertia acts.
typedef struct {
    const pdmc_motion_model *model;
    const pdmc_motion_options *options;
    double *x, *v, *a, *before, *mean, *predicted;
    pdmc_motion_state state;
} motion;

static pdmc_status motion_create(const pdmc_motion_model *model, const pdmc_motion_options *options, motion *m)
{
    pdmc_status status = PDMC_OK;
    const int n = model->unknowns;
    *m = (motion){.model = model, .options = options};
    PDMC_NEW(m->x, 6 * n);
    m->v = m->x + n;
    m->a = m->v + n;
    m->before = m->a + n;
    m->mean = m->before + n;
    m->predicted = m->mean + n;
    m->state.x = m->x;
    m->state.velocity = m->v;
    m->state.acceleration = m->a;
done:
    return status;
}

// Energies at the end of a step from `before` to x. Over a step of average acceleration the velocity that does work is
// the mean one, (x - before) / dt, and the load and the damping force are the means of both ends.
static void account(motion *m, double time, double factor, double factor_before)
{
    const pdmc_motion_model *model = m->model;
    const double density = m->options->density, dt = time - m->state.time;
    for (int i = 0; i < model->unknowns; i++) m->mean[i] = (m->x[i] - m->before[i]) / dt;
    m->state.work += dt * 0.5 * (factor + factor_before) * model->work(model->method, m->mean);
    m->state.dissipated += dt * density * m->options->damping * model->mass(model->method, m->mean, m->mean);
    m->state.kinetic = 0.5 * density * model->mass(model->method, m->v, m->v);
    m->state.elastic = 0.5 * model->stiffness(model->method, m->x, m->x);
    m->state.time = time;
}

// x = x* + dt^2/4 a, v = v* + dt/2 a with x*, v* from the last step; the damping force of v* joins the state about
// which inertia acts.
static pdmc_status advance(motion *m, double factor)
{
    const int n = m->model->unknowns;
    const double dt = m->options->step, d = m->options->damping;
    const double stiffness = 4.0 / (dt * dt), shift = d / (stiffness * (1.0 + 0.5 * d * dt));
    memcpy(m->before, m->x, (size_t)n * sizeof *m->x);
    for (int i = 0; i < n; i++) {
        m->mean[i] = m->x[i] + dt * m->v[i] + 0.25 * dt * dt * m->a[i];
        m->v[i] += 0.5 * dt * m->a[i];
        m->predicted[i] = m->mean[i] - shift * m->v[i];
    }
    const pdmc_status status = m->model->solve(m->model->method, m->predicted, factor, m->x);
    if (status != PDMC_OK) return status;
    for (int i = 0; i < n; i++) {
        m->a[i] = stiffness * (m->x[i] - m->mean[i]);
        m->v[i] += 0.5 * dt * m->a[i];
    }
    return PDMC_OK;
}

pdmc_status pdmc_motion_run(const pdmc_motion_model *model, const pdmc_motion_options *options,
                            bool (*observe)(void *context, const pdmc_motion_state *state), void *context)
{
    PDMC_REQUIRE(options->step > 0.0 && isfinite(options->step), "time step %g is not positive", options->step);
    PDMC_REQUIRE(options->density > 0.0, "density %g is not positive", options->density);
    PDMC_REQUIRE(options->damping >= 0.0, "damping %g is negative", options->damping);
    PDMC_REQUIRE(options->history.count >= 1, "the load has no history");
    pdmc_status status = PDMC_OK;
    motion m = {0};
    PDMC_TRY(motion_create(model, options, &m));
    double factor = 0.0; // at the start, whatever the history says: nothing is in motion yet
    bool go_on = !observe || observe(context, &m.state);
    for (int k = 1; k <= options->steps && go_on; k++) {
        const double before = factor, time = k * options->step;
        factor = pdmc_history_at(&options->history, time);
        PDMC_TRY(advance(&m, factor));
        account(&m, time, factor, before);
        go_on = !observe || observe(context, &m.state);
    }
done:
    pdmc_free(m.x);
    return status;
}
