// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/rest.h"

#include "base/base_impl.h"
#include "particles/particles_impl.h"
#include "pdmc/relaxation.h"

#include <float.h>
#include <math.h>
#include <string.h>

// Underwood: masses of a step of 1.1 are used with one of 1.
static const double mass_margin = 1.21;

// What is brought to rest at a load. Unknowns are the coordinates of the nodes, node by node.
typedef struct {
    pdmc_particles *particles;
    const pdmc_rest_options *options;
    pdmc_rest *rest;
    double load;
    size_t unknowns;
    double *x;        // [unknowns]
    double *mass;     // [unknowns]
    double *force;    // [unknowns]
    double *external; // [unknowns] as in the memory
    double rounding;  // norm of the forces that the rounding of positions alone makes
    int steps_before; // of earlier relaxations
} resting;

void pdmc_rest_clear(pdmc_rest_memory *memory)
{
    for (int k = 0; k < 2; k++) pdmc_free(memory->at_rest[k]);
    pdmc_free(memory->external);
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
}

/// Whole forces on the nodes, prescribed ones included.
static pdmc_status find_forces(void *context, const double x[], double force[])
{
    const resting *r = context;
    pdmc_particles *p = r->particles;
    const pdmc_nodes *g = &p->nodes;
    place(p, x);
    pdmc_particles_find_bond_forces(p, true);
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

/// Adds k |e_a| sum_b |e_b| of a bond's stiffness k, twice: in the node's own place of the row and in its neighbour's.
static void add_row(const pdmc_particles *p, const pdmc_bond_law *law, size_t c, size_t other, double row[PDMC_AXES])
{
    const pdmc_nodes *g = &p->nodes;
    double *const *x = p->linear ? p->nodes.reference : p->position;
    double e[PDMC_AXES], square = 0.0, sum = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        e[a] = fabs(x[a][other] - x[a][c]);
        square += e[a] * e[a];
        sum += e[a];
    }
    const double stiffness = pdmc_variation_micromodulus(&p->variation, g, law, c, other) *
                             pdmc_nodes_weight(g, c, other) * g->volume[c] / pdmc_nodes_length(g, c, other);
    for (int a = 0; a < PDMC_AXES; a++) row[a] += 2.0 * stiffness * e[a] * sum / square;
}

/// A quarter of the largest row sum of a node's |k_ij| (Gerschgorin; Yu 2011, eq. 4.59 and 4.67, whose sum leaves the
/// node's own place out), and the margin.
static double mass_of(const pdmc_particles *p, const pdmc_block *block, int lane)
{
    const size_t c = block->cell + (size_t)lane;
    double row[PDMC_AXES] = {0.0};
    for (int k = 0; k < block->listed; k++)
        if (p->nodes.bonds[block->bonds + (size_t)k] >> lane & 1)
            add_row(p, &p->laws[block->material], c, pdmc_nodes_neighbour(&p->nodes, block, k, lane), row);
    return 0.25 * mass_margin * fmax(row[0], fmax(row[1], row[2]));
}

/// Fictitious masses; infinite where positions are prescribed, and where a node has no bonds left.
static void find_masses(resting *r)
{
    const pdmc_particles *p = r->particles;
    const pdmc_nodes *g = &p->nodes;
#pragma omp parallel for num_threads(p->threads) schedule(static)
    for (int b = 0; b < g->block_count; b++)
        for (unsigned left = g->blocks[b].nodes; left; left &= left - 1) {
            const int lane = __builtin_ctz(left);
            const double mass = mass_of(p, &g->blocks[b], lane);
            for (int a = 0; a < g->dimension; a++)
                r->mass[unknown_of(p, g->blocks[b].cell + (size_t)lane, a)] = mass > 0.0 ? mass : INFINITY;
        }
    for (int k = 0; k < p->layer_count; k++)
        for (int a = 0; a < g->dimension; a++)
            for (int i = 0;
                 pdmc_layer_holds(&p->layers[k]) && p->layers[k].condition.along[a] && i < p->layers[k].count; i++)
                r->mass[unknown_of(p, p->layers[k].cell[i], a)] = INFINITY;
}

/// A quarter of a row of the stiffness, the mass, times what positions cannot tell.
static void find_rounding(resting *r)
{
    double sum = 0.0;
    for (size_t i = 0; i < r->unknowns; i++)
        if (isfinite(r->mass[i])) sum += r->mass[i] * r->mass[i] * r->x[i] * r->x[i];
    r->rounding = 4.0 * DBL_EPSILON * sqrt(sum);
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

/// The external forces: what is prescribed, and what holds nodes whose position is. @return their norm
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

/// The forces at x, their external part, and the residual.
static pdmc_status look(resting *r)
{
    double norm = 0.0;
    pdmc_status status = find_forces(r, r->x, r->force);
    if (status != PDMC_OK) return status;
    const double scale = scale_of(r);
    status = find_unbalanced(r, &norm);
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
    find_masses(r);
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
        if (status == PDMC_ERR_SINGULAR)
            PDMC_FAIL(status, "load %g: not at rest after %d steps of relaxation, the residual is %g, wanted %g",
                      r->load, state.steps, state.residual, r->options->tolerance);
        if (status != PDMC_OK) goto done;
        PDMC_TRY(look(r));
    }
done:
    return status;
}

static double elastic_energy(const pdmc_particles *p)
{
    double sum = 0.0;
    pdmc_particles_find_energies(p);
    for (int b = 0; b < p->nodes.block_count; b++) sum += p->elastic[b];
    return sum;
}

static double fracture_energy(const pdmc_particles *p)
{
    double sum = 0.0;
    for (int b = 0; b < p->nodes.block_count; b++) sum += p->fracture[b];
    return sum;
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
    return work;
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
    double elastic = elastic_energy(p), fracture = fracture_energy(p);
    while (break_bonds(p)) {
        r->rest->breakages++;
        PDMC_TRY(relax(r));
        const double work = remember(r), elastic_now = elastic_energy(p), fracture_now = fracture_energy(p);
        p->work += work;
        p->rest.dissipated += work - (elastic_now - elastic) - (fracture_now - fracture);
        elastic = elastic_now;
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
    PDMC_NEW(m->external, r->unknowns);
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
    PDMC_REQUIRE(p->sphere_count == 0 && !isfinite(p->nodes.touching), "rest: there are spheres, or nodes that touch");
    PDMC_REQUIRE(!p->is_single, "rest: bonds are computed in single precision");
    for (int k = 0; k < p->layer_count; k++)
        PDMC_REQUIRE(p->layers[k].condition.kind != PDMC_CONDITION_VELOCITY, "rest: conditions[%d] is a velocity", k);
    return PDMC_OK;
}

static void drop(resting *r)
{
    pdmc_free(r->x);
    pdmc_free(r->mass);
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
                 .unknowns = (size_t)p->nodes.node_count * (size_t)p->nodes.dimension};
    pdmc_rest_memory *m = &p->rest;
    double *last = NULL;
    *rest = (pdmc_rest){0};
    PDMC_NEW(r.x, r.unknowns);
    PDMC_NEW(r.mass, r.unknowns);
    PDMC_NEW(r.force, r.unknowns);
    PDMC_NEW(r.external, r.unknowns);
    PDMC_NEW(last, r.unknowns);
    if (!m->external) PDMC_TRY(start(&r));
    memcpy(last, m->at_rest[0], r.unknowns * sizeof *last);
    guess(&r);
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
