// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particles_impl.h"

#include <math.h>
#include <string.h>

double pdmc_particles_stable_step(const pdmc_particles *p)
{
    return p->stable_step;
}
double pdmc_particles_step_size(const pdmc_particles *p)
{
    return p->step;
}
const char *pdmc_particles_kernel(const pdmc_particles *p)
{
    return p->kernels.name;
}
int pdmc_particles_count(const pdmc_particles *p)
{
    return p->nodes.node_count;
}
size_t pdmc_particles_bond_bytes(const pdmc_particles *p)
{
    return p->nodes.bond_bytes * (p->nodes.partner ? 2 + sizeof *p->nodes.partner : 1);
}
double pdmc_particles_time(const pdmc_particles *p)
{
    return p->rest.count > 0 ? p->rest.load[0] : p->steps * p->step;
}
int pdmc_particles_steps(const pdmc_particles *p)
{
    return p->steps;
}

uint64_t pdmc_particles_bonds(const pdmc_particles *p)
{
    uint64_t directions = 0;
    for (int k = 0; k < p->nodes.node_count; k++) directions += p->nodes.family[p->nodes.cell[k]];
    return directions / 2;
}

double pdmc_particles_velocity_at(const pdmc_particles *p, const pdmc_block *block, int axis, size_t c)
{
    return p->velocity[axis][c] - 0.5 * p->step / p->density[block->material] * p->force[axis][c];
}

static void add_motion(const pdmc_particles *p, const pdmc_block *block, pdmc_particles_sums *sums)
{
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const size_t c = block->cell + (size_t)__builtin_ctz(left);
        const double mass = p->density[block->material] * p->nodes.volume[c];
        for (int a = 0; a < PDMC_AXES; a++) {
            const double v = pdmc_particles_velocity_at(p, block, a, c);
            const double after = p->velocity[a][c], before = 2.0 * v - after;
            sums->kinetic += 0.5 * mass * (p->held[c] >> a & 1 ? v * v : before * after);
            sums->momentum[a] += mass * v;
        }
    }
}

static void add_damage(const pdmc_particles *p, const pdmc_block *block, pdmc_particles_sums *sums)
{
    int whole[PDMC_LANES];
    pdmc_nodes_whole(&p->nodes, block, whole);
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const int k = __builtin_ctz(left);
        const int family = p->nodes.family[block->cell + (size_t)k];
        sums->broken += (uint64_t)(family - whole[k]);
        if (family > 0) sums->mean_damage += 1.0 - (double)whole[k] / family;
    }
}

static void add_spheres(const pdmc_particles *p, pdmc_particles_sums *sums)
{
    for (int s = 0; s < p->sphere_count; s++) {
        const pdmc_rigid_sphere *sphere = &p->spheres[s];
        sums->contact += p->sphere_energy[s];
        if (isinf(sphere->mass)) continue;
        for (int a = 0; a < PDMC_AXES; a++) {
            const double v = sphere->velocity[a] - 0.5 * p->step * p->sphere_force[PDMC_AXES * s + a] / sphere->mass;
            sums->kinetic += 0.5 * sphere->mass * sphere->velocity[a] * (2.0 * v - sphere->velocity[a]);
            sums->momentum[a] += sphere->mass * v;
        }
    }
}

pdmc_particles_sums pdmc_particles_sum(const pdmc_particles *p)
{
    pdmc_particles_sums sums = {.work = p->work - p->work_after,
                                .dissipated = p->damping.dissipated - p->damping.after + p->rest.dissipated,
                                .first = p->first};
    pdmc_particles_find_energies(p);
    for (int b = 0; b < p->nodes.block_count; b++) {
        sums.elastic += p->elastic[b];
        sums.contact += p->contact_energy[b];
        sums.fracture += p->fracture[b];
        add_motion(p, &p->nodes.blocks[b], &sums);
        add_damage(p, &p->nodes.blocks[b], &sums);
    }
    sums.contact += pdmc_contact_energy(&p->contact, &p->nodes, p->position);
    sums.mean_damage /= p->nodes.node_count;
    sums.broken /= 2;
    add_spheres(p, &sums);
    return sums;
}

void pdmc_particles_reference(const pdmc_particles *p, double x[], int body[])
{
    for (int k = 0; k < p->nodes.node_count; k++) {
        for (int a = 0; a < PDMC_AXES; a++) x[PDMC_AXES * k + a] = p->nodes.reference[a][p->nodes.cell[k]];
        if (body) body[k] = p->nodes.body[p->nodes.cell[k]];
    }
}

void pdmc_particles_state(const pdmc_particles *p, double u[], double velocity[], double damage[])
{
    const pdmc_nodes *g = &p->nodes;
    for (int b = 0; b < g->block_count; b++) {
        const pdmc_block *block = &g->blocks[b];
        int whole[PDMC_LANES];
        pdmc_nodes_whole(g, block, whole);
        for (unsigned left = block->nodes; left; left &= left - 1) {
            const int k = __builtin_ctz(left);
            const size_t c = block->cell + (size_t)k;
            const int node = g->node[c];
            for (int a = 0; a < PDMC_AXES; a++) {
                if (u) u[PDMC_AXES * node + a] = p->position[a][c] - g->reference[a][c];
                if (velocity) velocity[PDMC_AXES * node + a] = pdmc_particles_velocity_at(p, block, a, c);
            }
            if (damage) damage[node] = g->family[c] > 0 ? 1.0 - (double)whole[k] / g->family[c] : 0.0;
        }
    }
}

void pdmc_particles_conditions(const pdmc_particles *p, double force[], double displacement[])
{
    for (int k = 0; k < p->layer_count; k++) {
        const pdmc_layer *layer = &p->layers[k];
        for (int a = 0; a < PDMC_AXES; a++) {
            double sum = 0.0;
            for (int i = 0; i < layer->count; i++)
                sum += p->position[a][layer->cell[i]] - p->nodes.reference[a][layer->cell[i]];
            force[PDMC_AXES * k + a] = layer->exerted[a];
            displacement[PDMC_AXES * k + a] = sum / layer->count;
        }
    }
}

void pdmc_particles_interfaces(const pdmc_particles *p, uint64_t bonds[], uint64_t broken[])
{
    pdmc_joints_count(&p->variation.joints, &p->nodes, p->interface_count, broken);
    for (int i = 0; i < p->interface_count; i++) {
        bonds[i] = p->interface_bonds[i];
        broken[i] = bonds[i] - broken[i];
    }
}

void pdmc_particles_spheres(const pdmc_particles *p, pdmc_rigid_sphere spheres[])
{
    for (int s = 0; s < p->sphere_count; s++) {
        spheres[s] = p->spheres[s];
        if (p->rest.count > 0) memset(spheres[s].velocity, 0, sizeof spheres[s].velocity);
        if (isinf(spheres[s].mass)) continue;
        for (int a = 0; a < PDMC_AXES; a++)
            spheres[s].velocity[a] -= 0.5 * p->step * p->sphere_force[PDMC_AXES * s + a] / spheres[s].mass;
    }
}

void pdmc_particles_sphere_forces(const pdmc_particles *p, double force[])
{
    for (int i = 0; i < PDMC_AXES * p->sphere_count; i++) force[i] = p->sphere_force[i];
}
