// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bodies in motion: what the files of this room share.

#include "particles/contact.h"
#include "particles/damping.h"
#include "particles/forces.h"
#include "particles/layers.h"
#include "particles/rest.h"
#include "particles/variation.h"

struct pdmc_particles {
    pdmc_nodes nodes;
    int threads, material_count;
    bool linear;         // stretch
    double *density;     // [materials]
    pdmc_brittle_law *laws; // [materials]
    pdmc_variation variation;
    pdmc_forces_kernels kernels;
    bool is_single;     // whether bonds are computed in single precision
    pdmc_single single; // ... from these
    double *position[PDMC_AXES], *force[PDMC_AXES]; // [cells] at the time
    double *velocity[PDMC_AXES];                    // [cells] half a step after it
    double *strength, *next_strength;               // [cells] s_0
    double *fracture, *elastic, *contact_energy;    // [blocks]
    double *share;                                  // [blocks, 4] room for sums
    double repulsion;
    pdmc_contact contact;
    pdmc_damping damping;
    pdmc_rest_memory rest;
    int layer_count, sphere_count, interface_count;
    uint64_t *interface_bonds; // [interfaces] at the start, without cracks
    pdmc_layer *layers;
    pdmc_rigid_sphere *spheres; // at the time, with their velocities half a step after it
    double *sphere_force;       // [spheres, 3] of the nodes
    double *sphere_energy;      // [spheres]
    double stable_step, step, first;
    double fastest; // velocity of any node along any axis, after the last acceleration
    double work, work_after; // until half a step after the time; what is after the time of it
    uint8_t *held;           // [cells] axes along which a node's motion is prescribed, as bits
    int steps;
};

/// From the state at time 0 to velocities half a step after it.
PDMC_NODISCARD pdmc_status pdmc_particles_start(pdmc_particles *particles);

/// The forces of bonds and of neighbours' repulsion. @param[in] unbreakable  whether no bond breaks now
void pdmc_particles_find_bond_forces(pdmc_particles *particles, bool unbreakable);

/// The forces of bonds, of contact and of spheres. @param[in] unbreakable  as above
PDMC_NODISCARD pdmc_status pdmc_particles_find_inner_forces(pdmc_particles *particles, bool unbreakable);

/// The forces of bonds and of neighbours' repulsion alone, without breaking bonds. @param[in] force  [cells] to which they are written
void pdmc_particles_find_forces_in(const pdmc_particles *particles, pdmc_precision precision,
                                   double *const force[PDMC_AXES]);

/// A node's velocity at the time, between the half steps: v - step / 2 times the acceleration.
double pdmc_particles_velocity_at(const pdmc_particles *particles, const pdmc_block *block, int axis, size_t cell);

/// Elastic and contact energies of the blocks, as they are.
void pdmc_particles_find_energies(const pdmc_particles *particles);
