// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "particles/particles_impl.h"
#include "particles/sphere.h"

#include <math.h>

enum { PASS = 64 }; // blocks that one thread takes at a time: few enough for the threads to end together

/// The end of a pass that begins at a block.
static int end_of(const pdmc_particles *p, int block)
{
    return block + PASS < p->nodes.block_count ? block + PASS : p->nodes.block_count;
}

/// Calls the kernel for shares of the blocks that have about as many bonds.
static void run_kernel(const pdmc_particles *p, pdmc_forces_kernel *kernel, const pdmc_forces *forces)
{
#pragma omp parallel for num_threads(p->threads) schedule(dynamic)
    for (int b = 0; b < p->nodes.block_count; b += PASS) kernel(forces, b, end_of(p, b));
}

static pdmc_forces forces_of(const pdmc_particles *p)
{
    pdmc_forces forces = {.nodes = &p->nodes,
                          .laws = p->laws,
                          .joints = &p->variation.joints,
                          .single = &p->single,
                          .repulsion = p->repulsion,
                          .step = p->step,
                          .linear = p->linear,
                          .by_node = p->variation.first_strength,
                          .stiffness = p->variation.stiffness,
                          .first_strength = p->variation.first_strength,
                          .relative_strength = p->variation.relative_strength,
                          .strength = p->strength,
                          .next_strength = p->next_strength,
                          .key = p->variation.key,
                          .fracture = p->fracture,
                          .elastic = p->elastic,
                          .contact = p->contact_energy};
    for (int a = 0; a < PDMC_AXES; a++) {
        forces.position[a] = p->position[a];
        forces.velocity[a] = p->velocity[a];
        forces.force[a] = p->force[a];
    }
    return forces;
}

void pdmc_particles_find_energies(const pdmc_particles *p)
{
    pdmc_forces forces = forces_of(p);
    forces.energies = true;
    run_kernel(p, p->kernels.in_double, &forces);
}

static void meet_spheres(pdmc_particles *p)
{
    for (int s = 0; s < p->sphere_count; s++)
        p->sphere_energy[s] = pdmc_sphere_push(&p->spheres[s], &p->nodes, p->position, p->threads, p->force, p->share,
                                               &p->sphere_force[PDMC_AXES * s]);
}

static void strengthen(pdmc_particles *p)
{
    double *strength = p->strength;
    p->strength = p->next_strength;
    p->next_strength = strength;
}

void pdmc_particles_find_bond_forces(pdmc_particles *p, bool unbreakable)
{
    pdmc_forces forces = forces_of(p);
    forces.unbreakable = unbreakable;
    run_kernel(p, p->is_single ? p->kernels.in_single : p->kernels.in_double, &forces);
    if (p->is_single) pdmc_single_strengthen(&p->single);
    else strengthen(p);
}

void pdmc_particles_find_forces_in(const pdmc_particles *p, pdmc_precision precision, double *const force[PDMC_AXES])
{
    pdmc_forces forces = forces_of(p);
    forces.unbreakable = true;
    for (int a = 0; a < PDMC_AXES; a++) forces.force[a] = force[a];
    run_kernel(p, precision == PDMC_PRECISION_SINGLE ? p->kernels.in_single : p->kernels.in_double, &forces);
}

/// y += factor x for a block's nodes. Empty cells hold zeros in x, so that they need no care where no other body is.
static void add_to(const pdmc_block *block, double factor, const double x[], double y[])
{
    const bool alone = block->nodes == block->occupied;
    for (int k = 0; k < PDMC_LANES; k++)
        if (alone || block->nodes >> k & 1) y[k] += factor * x[k];
}

PDMC_VECTORS("avx2", "avx512f")
static void move_blocks(pdmc_particles *p, int first, int last, double step)
{
    for (int b = first; b < last; b++) {
        const pdmc_block *block = &p->nodes.blocks[b];
        for (int a = 0; a < PDMC_AXES; a++)
            add_to(block, step, &p->velocity[a][block->cell], &p->position[a][block->cell]);
        if (p->is_single) pdmc_single_follow(&p->single, &p->nodes, block, p->position);
    }
}

static void move(pdmc_particles *p, double step)
{
#pragma omp parallel for num_threads(p->threads) schedule(static)
    for (int b = 0; b < p->nodes.block_count; b += PASS) move_blocks(p, b, end_of(p, b), step);
    pdmc_contact_pass(&p->contact, sqrt((double)PDMC_AXES) * p->fastest * step);
    for (int s = 0; s < p->sphere_count; s++)
        for (int a = 0; a < PDMC_AXES; a++) p->spheres[s].centre[a] += step * p->spheres[s].velocity[a];
}

/// No node moves by more than the horizon in a step, unless the step is far too large. NaN does not either.
static bool is_lost(const pdmc_particles *p, double velocity)
{
    return !(fabs(velocity) * p->step <= p->nodes.reach);
}

/// @return the largest velocity along any axis, infinite where a node is lost
PDMC_VECTORS("avx2", "avx512f")
static double accelerate_blocks(pdmc_particles *p, int first, int last, double step)
{
    double fastest[PDMC_LANES] = {0.0}, of_all = 0.0;
    for (int b = first; b < last; b++) {
        const pdmc_block *block = &p->nodes.blocks[b];
        for (int a = 0; a < PDMC_AXES; a++) {
            double *velocity = &p->velocity[a][block->cell];
            add_to(block, step / p->density[block->material], &p->force[a][block->cell], velocity);
            for (int k = 0; k < PDMC_LANES; k++) {
                const double speed = is_lost(p, velocity[k]) ? INFINITY : fabs(velocity[k]);
                fastest[k] = speed > fastest[k] ? speed : fastest[k];
            }
        }
    }
    for (int k = 0; k < PDMC_LANES; k++) of_all = fastest[k] > of_all ? fastest[k] : of_all;
    return of_all;
}

/// @return whether no node is lost
static bool accelerate(pdmc_particles *p, double step)
{
    double fastest = 0.0; // of whichever node, so that the order is all the same
#pragma omp parallel for num_threads(p->threads) schedule(static) reduction(max : fastest)
    for (int b = 0; b < p->nodes.block_count; b += PASS) {
        const double of_pass = accelerate_blocks(p, b, end_of(p, b), step);
        fastest = of_pass > fastest ? of_pass : fastest;
    }
    p->fastest = fastest;
    return isfinite(fastest);
}

static void accelerate_spheres(pdmc_particles *p, double step)
{
    for (int s = 0; s < p->sphere_count; s++) {
        pdmc_rigid_sphere *sphere = &p->spheres[s];
        for (int a = 0; a < PDMC_AXES; a++) {
            const double force = p->sphere_force[PDMC_AXES * s + a];
            if (isfinite(sphere->mass)) sphere->velocity[a] += step * force / sphere->mass;
        }
    }
}

/// Of what keeps spheres at their velocity.
static pdmc_step_work work_of_spheres(const pdmc_particles *p)
{
    double power = 0.0;
    for (int s = 0; s < p->sphere_count; s++)
        for (int a = 0; a < PDMC_AXES && isinf(p->spheres[s].mass); a++)
            power -= p->sphere_force[PDMC_AXES * s + a] * p->spheres[s].velocity[a];
    return (pdmc_step_work){0.5 * p->step * power, 0.5 * p->step * power};
}

/// Takes the last acceleration back where it can be, so that the state is finite.
static void restore(pdmc_particles *p, const pdmc_block *block, int k)
{
    for (int a = 0; a < PDMC_AXES; a++) {
        const size_t c = block->cell + (size_t)k;
        const double before = p->velocity[a][c] - p->step / p->density[block->material] * p->force[a][c];
        p->velocity[a][c] = isfinite(before) ? before : 0.0;
        p->force[a][c] = 0.0;
    }
}

static bool is_node_lost(const pdmc_particles *p, size_t c)
{
    return is_lost(p, p->velocity[0][c]) || is_lost(p, p->velocity[1][c]) || is_lost(p, p->velocity[2][c]);
}

static const char *why_lost(const pdmc_particles *p, size_t c)
{
    for (int a = 0; a < PDMC_AXES; a++)
        if (isnan(p->velocity[a][c])) return "has a velocity that is not a number: forces are too large";
    return "would move by more than the horizon in a step: the step is not stable, or forces are too large";
}

static pdmc_status report_lost(pdmc_particles *p)
{
    const pdmc_nodes *g = &p->nodes;
    const char *why = NULL;
    double x[PDMC_AXES] = {0.0};
    for (int b = 0; b < g->block_count; b++) {
        for (unsigned left = g->blocks[b].nodes; left; left &= left - 1) {
            const int k = __builtin_ctz(left);
            const size_t c = g->blocks[b].cell + (size_t)k;
            if (!is_node_lost(p, c)) continue;
            for (int a = 0; a < PDMC_AXES && !why; a++) x[a] = g->reference[a][c];
            if (!why) why = why_lost(p, c);
            restore(p, &g->blocks[b], k);
        }
    }
    return pdmc_raise(PDMC_ERR_SINGULAR, "step %d, time %g: the node at (%g, %g, %g) %s", p->steps,
                      pdmc_particles_time(p), x[0], x[1], x[2], why);
}

static pdmc_motion_of_nodes motion_of(const pdmc_particles *p)
{
    pdmc_motion_of_nodes motion = {
        .nodes = &p->nodes, .laws = p->laws, .variation = &p->variation, .density = p->density, .threads = p->threads};
    for (int a = 0; a < PDMC_AXES; a++) {
        motion.position[a] = p->position[a];
        motion.velocity[a] = p->velocity[a];
    }
    return motion;
}

/// @param[in] duration  from the velocities to the time
static void damp(const pdmc_particles *p, double duration)
{
    if (!pdmc_damping_is_on(&p->damping)) return;
    const pdmc_motion_of_nodes motion = motion_of(p);
    pdmc_damping_find(&p->damping, &motion, p->force, duration);
    pdmc_damping_add(&p->damping, &motion, 1.0, p->force);
}

static void undamp(const pdmc_particles *p)
{
    if (!pdmc_damping_is_on(&p->damping)) return;
    const pdmc_motion_of_nodes motion = motion_of(p);
    pdmc_damping_add(&p->damping, &motion, -1.0, p->force);
}

static void count_damping(pdmc_particles *p)
{
    if (!pdmc_damping_is_on(&p->damping)) return;
    const pdmc_motion_of_nodes motion = motion_of(p);
    pdmc_damping_count(&p->damping, &motion, p->force, p->step);
}

static void count_work(pdmc_particles *p, pdmc_step_work part)
{
    p->work += part.before + part.after;
    p->work_after += part.after;
}

static pdmc_layer_motion motion_of_layers(const pdmc_particles *p)
{
    pdmc_layer_motion motion = {.time = pdmc_particles_time(p), .step = p->step, .damping = &p->damping};
    for (int a = 0; a < PDMC_AXES; a++) {
        motion.position[a] = p->position[a];
        motion.velocity[a] = p->velocity[a];
        motion.force[a] = p->force[a];
    }
    return motion;
}

pdmc_status pdmc_particles_find_inner_forces(pdmc_particles *p, bool unbreakable)
{
    pdmc_particles_find_bond_forces(p, unbreakable);
    const pdmc_status status = pdmc_contact_update(&p->contact, &p->nodes, p->position, p->threads);
    if (status != PDMC_OK) return status;
    pdmc_contact_add(&p->contact, &p->nodes, p->position, p->threads, p->force);
    meet_spheres(p);
    return PDMC_OK;
}

/// All forces at the time but those of damping and of what holds nodes.
static pdmc_status find_forces(pdmc_particles *p)
{
    const pdmc_status status = pdmc_particles_find_inner_forces(p, false);
    if (status != PDMC_OK) return status;
    const pdmc_layer_motion motion = motion_of_layers(p);
    for (int k = 0; k < p->layer_count; k++)
        if (!pdmc_layer_holds(&p->layers[k])) pdmc_layer_push(&p->layers[k], &p->nodes, &motion);
    return PDMC_OK;
}

/// Adds the forces of damping, by what all others make of the velocities; then what holds the nodes whose motion is
/// prescribed.
static void act(pdmc_particles *p)
{
    const pdmc_nodes *g = &p->nodes;
    const pdmc_layer_motion motion = motion_of_layers(p);
    damp(p, 0.5 * p->step);
    for (int k = 0; k < p->layer_count; k++)
        if (pdmc_layer_holds(&p->layers[k])) count_work(p, pdmc_layer_hold(&p->layers[k], g, &motion));
    for (int k = 0; k < p->layer_count; k++)
        if (!pdmc_layer_holds(&p->layers[k])) count_work(p, pdmc_layer_work(&p->layers[k], g, &motion));
    count_damping(p);
}

/// From half a step before the time to half a step after it; what is lost in it has done no work.
static pdmc_status kick(pdmc_particles *p)
{
    const double work = p->work, dissipated = p->damping.dissipated;
    p->work_after = 0.0;
    act(p);
    count_work(p, work_of_spheres(p));
    accelerate_spheres(p, p->step);
    if (accelerate(p, p->step)) return PDMC_OK;
    p->work = work, p->work_after = 0.0;
    p->damping.dissipated = dissipated, p->damping.after = 0.0;
    return report_lost(p);
}

pdmc_status pdmc_particles_start(pdmc_particles *p)
{
    p->first = pdmc_particles_sum(p).kinetic;
    const pdmc_status status = find_forces(p);
    if (status != PDMC_OK) return status;
    damp(p, 0.0);
    accelerate(p, -0.5 * p->step);
    undamp(p);
    accelerate_spheres(p, -0.5 * p->step);
    const pdmc_status kicked = kick(p);
    p->damping.dissipated = p->damping.after; // the rest was before the start
    p->work = p->work_after;
    p->work += pdmc_particles_sum(p).kinetic - p->first; // of velocities that jump at the start
    return kicked;
}

pdmc_status pdmc_particles_advance(pdmc_particles *p, int steps)
{
    for (int k = 0; k < steps; k++) {
        move(p, p->step);
        p->steps++;
        pdmc_status status = find_forces(p);
        if (status == PDMC_OK) status = kick(p);
        if (status != PDMC_OK) return status;
    }
    return PDMC_OK;
}
