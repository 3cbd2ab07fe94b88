// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/solve.h"

#include <math.h>
#include <string.h>

typedef struct {
    const pdmc_form *form, *mass;
    const pdmc_bond_factor *factor; // of the mass
    int free_count, count;
    double frequency;
    double *start;                       // [count] values at the start, of which the prescribed ones are used
    double *now, *before, *acceleration; // [count]
    double *force, *inertia;             // [free_count]
} marcher;

static void prescribe(marcher *m, double time)
{
    const double cosine = cos(m->frequency * time);
    for (int i = m->free_count; i < m->count; i++) {
        m->now[i] = cosine * m->start[i];
        m->acceleration[i] = -m->frequency * m->frequency * m->now[i];
    }
}

// M a = -A u - what the prescribed accelerations take.
static pdmc_status accelerate(marcher *m)
{
    memset(m->acceleration, 0, (size_t)m->free_count * sizeof *m->acceleration);
    pdmc_form_multiply(m->form, m->now, m->force);
    pdmc_form_multiply(m->mass, m->acceleration, m->inertia);
    for (int i = 0; i < m->free_count; i++) m->force[i] = -m->force[i] - m->inertia[i];
    return pdmc_bond_factor_solve(m->factor, 1, m->force, m->acceleration);
}

// u(t + dt) = 2 u - u(t - dt) + dt^2 a; from rest the state before the first is that after it.
static pdmc_status step_once(marcher *m, double step, int done)
{
    prescribe(m, done * step);
    const pdmc_status status = accelerate(m);
    for (int i = 0; i < m->free_count && status == PDMC_OK; i++) {
        const double turn = step * step * m->acceleration[i], now = m->now[i];
        m->now[i] = done == 0 ? now + 0.5 * turn : 2.0 * now - m->before[i] + turn;
        m->before[i] = now;
    }
    return status;
}

pdmc_status pdmc_form_march(const pdmc_form *form, const pdmc_form *mass, int count, double step, int steps,
                            double frequency, double u[])
{
    pdmc_status status = PDMC_OK;
    const size_t bytes = (size_t)count * sizeof *u;
    pdmc_bond_factor *factor = NULL;
    marcher m = {
        .form = form, .mass = mass, .free_count = form->free_count, .count = count, .frequency = frequency, .now = u};
    PDMC_REQUIRE(step > 0.0 && isfinite(step), "a step of %g is not > 0", step);
    PDMC_REQUIRE(steps >= 1, "%d steps are not 1 or more", steps);
    PDMC_NEW(m.start, count);
    PDMC_NEW(m.before, count);
    PDMC_NEW(m.acceleration, count);
    PDMC_NEW(m.force, form->free_count);
    PDMC_NEW(m.inertia, form->free_count);
    PDMC_TRY(pdmc_form_factor(mass, &factor));
    m.factor = factor;
    memcpy(m.start, u, bytes);
    for (int done = 0; done < steps; done++) PDMC_TRY(step_once(&m, step, done));
    prescribe(&m, steps * step);
done:
    pdmc_bond_factor_destroy(&factor);
    pdmc_free(m.start);
    pdmc_free(m.before);
    pdmc_free(m.acceleration);
    pdmc_free(m.force);
    pdmc_free(m.inertia);
    return status;
}
