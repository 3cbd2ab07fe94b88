// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/law_bonds.h"
#include "galerkin/solve.h"

#include <math.h>
#include <string.h>

// The force of all bonds on the free values, and their energy where it is known.
typedef void force_function(const void *context, const double u[], double force[], double *energy);

typedef struct {
    force_function *bonds;
    const void *context;
    const double *load; // [free_count], NULL for none
    const pdmc_form *mass;
    const pdmc_sparse_factor *factor; // of the mass
    int free_count, count;
    double frequency;
    double *start;                       // [count] values at the start, of which the prescribed ones are used
    double *now, *before, *acceleration; // [count]
    double *force, *inertia;             // [free_count]
    double potential;                    // of bonds and load
} marcher;

static void prescribe(marcher *m, double time)
{
    const double cosine = cos(m->frequency * time);
    for (int i = m->free_count; i < m->count; i++) {
        m->now[i] = cosine * m->start[i];
        m->acceleration[i] = -m->frequency * m->frequency * m->now[i];
    }
}

// M a = load - F(u) - what the prescribed accelerations take.
static pdmc_status accelerate(marcher *m)
{
    memset(m->acceleration, 0, (size_t)m->free_count * sizeof *m->acceleration);
    m->bonds(m->context, m->now, m->force, &m->potential);
    pdmc_form_multiply(m->mass, m->acceleration, m->inertia);
    for (int i = 0; i < m->free_count; i++) {
        const double load = m->load ? m->load[i] : 0.0;
        m->potential -= load * m->now[i];
        m->force[i] = load - m->force[i] - m->inertia[i];
    }
    return pdmc_sparse_factor_solve(m->factor, 1, m->force, m->acceleration);
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

static void march_clear(marcher *m)
{
    pdmc_free(m->start);
    pdmc_free(m->before);
    pdmc_free(m->acceleration);
    pdmc_free(m->force);
    pdmc_free(m->inertia);
}

static pdmc_status march_allocate(marcher *m)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(m->start, m->count);
    PDMC_NEW(m->before, m->count);
    PDMC_NEW(m->acceleration, m->count);
    PDMC_NEW(m->force, m->free_count);
    PDMC_NEW(m->inertia, m->free_count);
    memcpy(m->start, m->now, (size_t)m->count * sizeof *m->now);
done:
    return status;
}

static pdmc_status check_steps(double step, int steps)
{
    PDMC_REQUIRE(step > 0.0 && isfinite(step), "a step of %g is not > 0", step);
    PDMC_REQUIRE(steps >= 1, "%d steps are not 1 or more", steps);
    return PDMC_OK;
}

static void force_of_form(const void *context, const double u[], double force[], double *energy)
{
    *energy = NAN;
    pdmc_form_multiply(context, u, force);
}

pdmc_status pdmc_form_march(const pdmc_form *form, const pdmc_form *mass, int count, const double load[], double step,
                            int steps, double frequency, double u[])
{
    pdmc_status status = PDMC_OK;
    pdmc_sparse_factor *factor = NULL;
    marcher m = {.bonds = force_of_form,
                 .context = form,
                 .load = load,
                 .mass = mass,
                 .free_count = form->free_count,
                 .count = count,
                 .frequency = frequency,
                 .now = u};
    PDMC_TRY(check_steps(step, steps));
    PDMC_TRY(march_allocate(&m));
    PDMC_TRY(pdmc_form_factor(mass, &factor));
    m.factor = factor;
    for (int done = 0; done < steps; done++) PDMC_TRY(step_once(&m, step, done));
    prescribe(&m, steps * step);
done:
    pdmc_sparse_factor_destroy(&factor);
    march_clear(&m);
    return status;
}

static void force_of_bonds(const void *context, const double u[], double force[], double *energy)
{
    pdmc_law_bonds_force(context, u, force, energy);
}

// Of the velocity between two states; with what is prescribed at rest the mass has free rows alone.
static double kinetic_energy(const marcher *m, const double velocity[])
{
    double twice = 0.0;
    pdmc_form_multiply(m->mass, velocity, m->inertia);
    for (int i = 0; i < m->free_count; i++) twice += velocity[i] * m->inertia[i];
    return 0.5 * twice;
}

typedef struct {
    double start, drift, kinetic; // of energy: at the start; the largest difference to it; the largest kinetic one
} balance;

// At the state before the step that was just taken, by the states on either side of it: `earlier` becomes that state.
static void weigh(const marcher *m, double step, int done, double earlier[], double velocity[], balance *b)
{
    for (int i = 0; i < m->free_count; i++) {
        velocity[i] = done > 0 ? (m->now[i] - earlier[i]) / (2.0 * step) : 0.0;
        earlier[i] = m->before[i];
    }
    const double kinetic = kinetic_energy(m, velocity);
    if (done == 0) b->start = m->potential;
    b->kinetic = fmax(b->kinetic, kinetic);
    b->drift = fmax(b->drift, fabs(kinetic + m->potential - b->start));
}

pdmc_status pdmc_law_bonds_march(const pdmc_law_bonds *bonds, const pdmc_form *mass, const double load[], double step,
                                 int steps, double u[], double *drift)
{
    pdmc_status status = PDMC_OK;
    pdmc_sparse_factor *factor = NULL;
    double *earlier = NULL, *velocity = NULL;
    balance b = {0};
    const pdmc_space *space = bonds->assembly.space;
    marcher m = {.bonds = force_of_bonds,
                 .context = bonds,
                 .load = load,
                 .mass = mass,
                 .free_count = space->free_count,
                 .count = space->count,
                 .now = u};
    PDMC_TRY(check_steps(step, steps));
    PDMC_TRY(march_allocate(&m));
    PDMC_NEW(earlier, space->free_count);
    PDMC_NEW(velocity, space->count);
    PDMC_TRY(pdmc_form_factor(mass, &factor));
    m.factor = factor;
    for (int done = 0; done < steps; done++) {
        PDMC_TRY(step_once(&m, step, done));
        weigh(&m, step, done, earlier, velocity, &b);
    }
    *drift = b.kinetic > 0.0 ? b.drift / b.kinetic : 0.0;
done:
    pdmc_sparse_factor_destroy(&factor);
    march_clear(&m);
    pdmc_free(earlier);
    pdmc_free(velocity);
    return status;
}
