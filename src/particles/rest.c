// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/rest.h"

#include "base/base_impl.h"
#include "particles/masses.h"
#include "particles/particles_impl.h"
#include "pdmc/relaxation.h"

#include <float.h>
#include <math.h>
#include <string.h>

// What is brought to rest at a load. Unknowns are the coordinates of the nodes, node by node.
typedef struct {
    pdmc_particles *particles;
    const pdmc_rest_options *options;
    pdmc_rest *rest;
    double load;
    size_t unknowns;
    double *x;        // [unknowns]
    double *mass;     // [unknowns]
    double *mass_at;  // [unknowns] coordinates for which the masses were found
    double reach;     // how far nodes may be from them
    double *force;    // [unknowns]
    double *external; // [unknowns] as in the memory
    double rounding;  // norm of the forces that the rounding of positions alone makes
    int steps_before; // of earlier relaxations
} resting;

void pdmc_rest_clear(pdmc_rest_memory *memory)
{
    for (int k = 0; k < 2; k++) pdmc_free(memory->at_rest[k]);
    pdmc_free(memory->external);
    pdmc_free(memory->sphere_start);
    pdmc_free(memory->sphere_centre);
    pdmc_free(memory->sphere_force);
    *memory = (pdmc_rest_memory){0};
}

static size_t unknown_of(const pdmc_particles *p, size_t cell, int axis)
{
    return (size_t)p->nodes.node[cell] * (size_t)p->nodes.dimension + (size_t)axis;
}

static void gather(const pdmc_particles *p, double *const cells[PDMC_AXES], double x[])
{
    const int dimension = p->nodes.dimension;
    for (int k = 0; k < p->nodes.node_count; k++)
        for (int a = 0; a < dimension; a++) x[k * dimension + a] = cells[a][p->nodes.cell[k]];
}

static void place(pdmc_particles *p, const double x[])
{
    const int dimension = p->nodes.dimension;
    for (int k = 0; k < p->nodes.node_count; k++)
        for (int a = 0; a < dimension; a++) p->position[a][p->nodes.cell[k]] = x[k * dimension + a];
    pdmc_contact_pass(&p->contact, INFINITY);
}

static pdmc_status find_masses(resting *r, const double x[])
{
    pdmc_particles *p = r->particles;
    place(p, x);
    const pdmc_status status = pdmc_contact_update(&p->contact, &p->nodes, p->position, p->threads);
    if (status != PDMC_OK) return status;
    pdmc_masses_find(p, r->mass);
    memcpy(r->mass_at, x, r->unknowns * sizeof *x);
    return PDMC_OK;
}

/// Whether what touches may not be in the masses: two nodes that move by a quarter of their reach along each axis come
/// nearer by at most 0.87 of it. Masses may change in the middle of a relaxation, which goes on.
static bool has_moved(const resting *r, const double x[])
{
    bool moved = false;
    for (size_t i = 0; isfinite(r->reach) && i < r->unknowns; i++)
        moved |= fabs(x[i] - r->mass_at[i]) > 0.25 * r->reach;
    return moved;
}

/// Whole forces on the nodes, prescribed ones included.
static pdmc_status find_forces(void *context, const double x[], double force[])
{
    resting *r = context;
    pdmc_particles *p = r->particles;
    const pdmc_nodes *g = &p->nodes;
    pdmc_status status = has_moved(r, x) ? find_masses(r, x) : PDMC_OK;
    if (status != PDMC_OK) return status;
    place(p, x);
    status = pdmc_particles_find_inner_forces(p, true);
    if (status != PDMC_OK) return status;
    pdmc_layer_motion motion = {.time = r->load};
    for (int a = 0; a < PDMC_AXES; a++) motion.force[a] = p->force[a];
    for (int k = 0; k < p->layer_count; k++)
        if (!pdmc_layer_holds(&p->layers[k])) pdmc_layer_push(&p->layers[k], g, &motion);
    gather(p, p->force, force);
    for (int k = 0; k < g->node_count; k++)
        for (int a = 0; a < g->dimension; a++) force[k * g->dimension + a] *= g->volume[g->cell[k]];
    return PDMC_OK;
}

static bool go_on(void *context, const pdmc_relaxation_state *state)
{
    resting *r = context;
    r->rest->steps = r->steps_before + state->steps;
    return state->steps % 16 > 0 || !r->options->go_on || r->options->go_on(r->options->context, r->rest->steps);
}

/// A quarter of a row of the stiffness, the mass, times what positions cannot tell.
static void find_rounding(resting *r)
{
    double sum = 0.0;
    for (size_t i = 0; i < r->unknowns; i++)
        if (isfinite(r->mass[i])) sum += r->mass[i] * r->mass[i] * r->x[i] * r->x[i];
    r->rounding = 4.0 * DBL_EPSILON * sqrt(sum);
}

/// A sphere's velocity is what it moves by in a unit of the load.
static void place_spheres(resting *r)
{
    pdmc_particles *p = r->particles;
    for (int s = 0; s < p->sphere_count; s++)
        for (int a = 0; a < PDMC_AXES; a++)
            p->spheres[s].centre[a] = p->rest.sphere_start[PDMC_AXES * s + a] + r->load * p->spheres[s].velocity[a];
}

/// On from the last two states of rest in a straight line; then all prescribed positions.
static void guess(resting *r)
{
    const pdmc_particles *p = r->particles;
    const pdmc_rest_memory *m = &p->rest;
    const double interval = m->load[0] - m->load[1], on = (r->load - m->load[0]) / interval;
    gather(p, p->position, r->x);
    for (size_t i = 0; m->count >= 2 && interval > 0.0 && i < r->unknowns; i++)
        r->x[i] += on * (m->at_rest[0][i] - m->at_rest[1][i]);
    for (int k = 0; k < p->layer_count; k++) {
        const pdmc_layer *layer = &p->layers[k];
        const double factor = pdmc_layer_factor(layer, r->load);
        for (int a = 0; a < p->nodes.dimension; a++)
            for (int i = 0; pdmc_layer_holds(layer) && layer->condition.along[a] && i < layer->count; i++)
                r->x[unknown_of(p, layer->cell[i], a)] =
                    p->nodes.reference[a][layer->cell[i]] + pdmc_layer_value(layer, &p->nodes, i, a, factor);
    }
}

/// The external forces: what is prescribed, what holds nodes whose position is, and what holds spheres. @return their norm
static double find_external(resting *r)
{
    const pdmc_particles *p = r->particles;
    double sum = 0.0;
    memset(r->external, 0, r->unknowns * sizeof *r->external);
    for (int k = 0; k < p->layer_count; k++) {
        const pdmc_layer *layer = &p->layers[k];
        const double factor = pdmc_layer_factor(layer, r->load);
        for (int a = 0; a < p->nodes.dimension; a++)
            for (int i = 0; layer->condition.along[a] && i < layer->count; i++) {
                const size_t at = unknown_of(p, layer->cell[i], a);
                if (pdmc_layer_holds(layer)) r->external[at] = -r->force[at];
                else
                    r->external[at] +=
                        pdmc_layer_value(layer, &p->nodes, i, a, factor) * p->nodes.volume[layer->cell[i]];
            }
    }
    for (size_t i = 0; i < r->unknowns; i++) sum += r->external[i] * r->external[i];
    for (int i = 0; i < PDMC_AXES * p->sphere_count; i++) sum += p->sphere_force[i] * p->sphere_force[i];
    return sqrt(sum);
}

/// To what the residual is relative: the largest external forces, but not so little that rounding is out of balance.
static double scale_of(resting *r)
{
    return fmax(fmax(r->particles->rest.largest, find_external(r)), r->rounding / r->options->tolerance);
}

/// The norm of what is out of balance. Where a position is prescribed the external force is the reaction; a node without
/// bonds has none, and cannot carry any force.
static pdmc_status find_unbalanced(const resting *r, double *norm)
{
    double sum = 0.0;
    for (size_t i = 0; i < r->unknowns; i++) {
        if (isfinite(r->mass[i])) sum += r->force[i] * r->force[i];
        else if (r->force[i] + r->external[i] != 0.0)
            return pdmc_raise(PDMC_ERR_SINGULAR, "load %g: a force acts on a node that no bond holds", r->load);
    }
    *norm = sqrt(sum);
    return PDMC_OK;
}

/// Forces whose norm would be no finite number, or that are none themselves, must not pass for rest.
static pdmc_status check_finite(const resting *r)
{
    const pdmc_nodes *g = &r->particles->nodes;
    const double most = sqrt(DBL_MAX / (double)r->unknowns);
    for (size_t i = 0; i < r->unknowns; i++) {
        if (fabs(r->force[i]) < most && fabs(r->external[i]) < most) continue;
        const size_t c = g->cell[i / (size_t)g->dimension];
        return pdmc_raise(PDMC_ERR_SINGULAR,
                          "load %g: the force on the node at (%g, %g, %g) is too large or not a number", r->load,
                          g->reference[0][c], g->reference[1][c], g->reference[2][c]);
    }
    return PDMC_OK;
}

/// The forces at x, their external part, and the residual.
static pdmc_status look(resting *r)
{
    double norm = 0.0;
    pdmc_status status = find_forces(r, r->x, r->force);
    if (status != PDMC_OK) return status;
    const double scale = scale_of(r);
    status = check_finite(r);
    if (status == PDMC_OK) status = find_unbalanced(r, &norm);
    r->rest->residual = norm > 0.0 ? norm / scale : 0.0;
    return status;
}

/// The scale of the residual is that of the forces at rest, which are not known before: where nodes were moved by force they
/// are smaller than at the start, and the tolerance is met in a second run or a third.
static pdmc_status relax(resting *r)
{
    pdmc_status status = PDMC_OK;
    enum { MOST_RUNS = 100 };
    const pdmc_relaxation_model model = {r->unknowns, find_forces, r, r->mass};
    pdmc_relaxation_state state;
    PDMC_TRY(find_masses(r, r->x));
    find_rounding(r);
    PDMC_TRY(look(r));
    for (int run = 0; r->rest->residual > r->options->tolerance && run < MOST_RUNS; run++) {
        const pdmc_relaxation_options options = {.scale = scale_of(r),
                                                 .tolerance = 0.9 * r->options->tolerance,
                                                 .max_steps = r->options->most_steps,
                                                 .damping = r->options->damping};
        r->steps_before = r->rest->steps;
        status = pdmc_relax(&model, &options, r->x, go_on, r, &state);
        r->rest->residual = state.residual;
        if (status == PDMC_ERR_SINGULAR && !isfinite(state.residual) && look(r) != PDMC_OK) goto done; // it says where
        if (status == PDMC_ERR_SINGULAR)
            PDMC_FAIL(status, "load %g: not at rest after %d steps of relaxation, the residual is %g, wanted %g",
                      r->load, state.steps, state.residual, r->options->tolerance);
        if (status != PDMC_OK) goto done;
        PDMC_TRY(look(r));
    }
done:
    return status;
}

/// In bonds and in what touches.
static double stored_energy(const pdmc_particles *p)
{
    double sum = pdmc_contact_energy(&p->contact, &p->nodes, p->position);
    pdmc_particles_find_energies(p);
    for (int b = 0; b < p->nodes.block_count; b++) sum += p->elastic[b] + p->contact_energy[b];
    for (int s = 0; s < p->sphere_count; s++) sum += p->sphere_energy[s];
    return sum;
}

static double fracture_energy(const pdmc_particles *p)
{
    double sum = 0.0;
    for (int b = 0; b < p->nodes.block_count; b++) sum += p->fracture[b];
    return sum;
}

/// As remember(), of the spheres: what holds them acts against the nodes.
static double remember_spheres(pdmc_particles *p)
{
    pdmc_rest_memory *m = &p->rest;
    double work = 0.0;
    for (int s = 0; s < p->sphere_count; s++)
        for (int a = 0; a < PDMC_AXES; a++) {
            const int i = PDMC_AXES * s + a;
            work -= 0.5 * (m->sphere_force[i] + p->sphere_force[i]) * (p->spheres[s].centre[a] - m->sphere_centre[i]);
            m->sphere_force[i] = p->sphere_force[i];
            m->sphere_centre[i] = p->spheres[s].centre[a];
        }
    return work;
}

/// What is at rest now is remembered. @return the work of the external forces since the state of rest before, by the
/// trapezoidal rule
static double remember(resting *r)
{
    pdmc_rest_memory *m = &r->particles->rest;
    double work = 0.0;
    const double norm = find_external(r);
    for (size_t i = 0; i < r->unknowns; i++) {
        work += 0.5 * (m->external[i] + r->external[i]) * (r->x[i] - m->at_rest[0][i]);
        m->external[i] = r->external[i];
    }
    m->largest = fmax(m->largest, norm);
    memcpy(m->at_rest[0], r->x, r->unknowns * sizeof *r->x);
    return work + remember_spheres(r->particles);
}

/// Breaks what is stretched too far. @return whether there was any
static bool break_bonds(pdmc_particles *p)
{
    const double before = fracture_energy(p);
    pdmc_particles_find_bond_forces(p, false);
    return fracture_energy(p) > before;
}

/// Rest at the load, and then after each time that bonds have broken, until none breaks.
static pdmc_status settle(resting *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_particles *p = r->particles;
    PDMC_TRY(relax(r));
    p->work += remember(r);
    double stored = stored_energy(p), fracture = fracture_energy(p);
    while (break_bonds(p)) {
        r->rest->breakages++;
        PDMC_TRY(relax(r));
        const double work = remember(r), stored_now = stored_energy(p), fracture_now = fracture_energy(p);
        p->work += work;
        p->rest.dissipated += work - (stored_now - stored) - (fracture_now - fracture);
        stored = stored_now;
        fracture = fracture_now;
    }
done:
    return status;
}

/// The whole forces of the conditions.
static void find_exerted(const resting *r)
{
    pdmc_particles *p = r->particles;
    for (int k = 0; k < p->layer_count; k++) {
        pdmc_layer *layer = &p->layers[k];
        for (int a = 0; a < p->nodes.dimension && pdmc_layer_holds(layer); a++) {
            layer->exerted[a] = 0.0;
            for (int i = 0; layer->condition.along[a] && i < layer->count; i++)
                layer->exerted[a] += r->external[unknown_of(p, layer->cell[i], a)];
        }
    }
}

/// Before the first load: bodies are where they lie, and nothing has acted on them.
static pdmc_status start(resting *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_particles *p = r->particles;
    pdmc_rest_memory *m = &p->rest;
    for (int k = 0; k < 2; k++) PDMC_NEW(m->at_rest[k], r->unknowns);
    PDMC_NEW(m->sphere_start, PDMC_AXES * p->sphere_count);
    PDMC_NEW(m->sphere_centre, PDMC_AXES * p->sphere_count);
    PDMC_NEW(m->sphere_force, PDMC_AXES * p->sphere_count);
    for (int i = 0; i < PDMC_AXES * p->sphere_count; i++)
        m->sphere_start[i] = m->sphere_centre[i] = p->spheres[i / PDMC_AXES].centre[i % PDMC_AXES];
    PDMC_NEW(m->external, r->unknowns); // last: there is one where all else is
    gather(p, p->position, m->at_rest[0]);
    p->work = p->work_after = p->damping.dissipated = p->damping.after = 0.0;
done:
    return status;
}

/// At rest nothing acts and nothing moves.
static void stand_still(pdmc_particles *p)
{
    for (int a = 0; a < PDMC_AXES; a++) {
        memset(p->velocity[a], 0, (p->nodes.cells + PDMC_LANES) * sizeof *p->velocity[a]);
        memset(p->force[a], 0, (p->nodes.cells + PDMC_LANES) * sizeof *p->force[a]);
    }
}

static pdmc_status check(const pdmc_particles *p, const pdmc_rest_options *options)
{
    PDMC_REQUIRE(options->tolerance > 0.0 && options->most_steps > 0, "rest: tolerance and steps need to be > 0");
    PDMC_REQUIRE(p->steps == 0, "rest: the bodies have moved already");
    for (int s = 0; s < p->sphere_count; s++)
        PDMC_REQUIRE(isinf(p->spheres[s].mass),
                     "rest: spheres[%d] has a mass, only one that is moved has a place at rest", s);
    PDMC_REQUIRE(!p->is_single, "rest: bonds are computed in single precision");
    for (int k = 0; k < p->layer_count; k++)
        PDMC_REQUIRE(p->layers[k].condition.kind != PDMC_CONDITION_VELOCITY, "rest: conditions[%d] is a velocity", k);
    return PDMC_OK;
}

static void drop(resting *r)
{
    pdmc_free(r->x);
    pdmc_free(r->mass);
    pdmc_free(r->mass_at);
    pdmc_free(r->force);
    pdmc_free(r->external);
}

pdmc_status pdmc_particles_come_to_rest(pdmc_particles *p, double load, const pdmc_rest_options *options,
                                        pdmc_rest *rest)
{
    pdmc_status status = check(p, options);
    if (status != PDMC_OK) return status;
    resting r = {.particles = p,
                 .options = options,
                 .rest = rest,
                 .load = load,
                 .reach = pdmc_masses_reach(p),
                 .unknowns = (size_t)p->nodes.node_count * (size_t)p->nodes.dimension};
    pdmc_rest_memory *m = &p->rest;
    double *last = NULL;
    *rest = (pdmc_rest){0};
    PDMC_NEW(r.x, r.unknowns);
    PDMC_NEW(r.mass, r.unknowns);
    PDMC_NEW(r.mass_at, r.unknowns);
    PDMC_NEW(r.force, r.unknowns);
    PDMC_NEW(r.external, r.unknowns);
    PDMC_NEW(last, r.unknowns);
    if (!m->external) PDMC_TRY(start(&r));
    memcpy(last, m->at_rest[0], r.unknowns * sizeof *last);
    guess(&r);
    place_spheres(&r);
    PDMC_TRY(settle(&r));
    memcpy(m->at_rest[1], last, r.unknowns * sizeof *last);
    m->load[1] = m->load[0];
    m->load[0] = load;
    m->count++;
    find_exerted(&r);
done:
    stand_still(p);
    drop(&r);
    pdmc_free(last);
    return status;
}
