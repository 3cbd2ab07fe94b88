// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem of bodies of bonds, in motion or brought to rest load by load, what acts on them, and what is recorded. Plain
/// data in the study's own units; see pdmc/particles.h for what is computed.

#include "pdmc/mesh.h"
#include "pdmc/particles.h"

/// A material as it is given: one modulus, and nothing, the fracture energy or the critical stretch.
typedef struct {
    char name[PDMC_NAME_SIZE];
    double density; // mass / length^3, the mass in force time^2 / length
    bool has_youngs_modulus, has_bulk_modulus, has_micromodulus;
    double youngs_modulus, bulk_modulus;            // force / length^2
    double micromodulus;                            // force / length^6
    bool has_fracture_energy, has_critical_stretch; // neither: bonds never break
    double fracture_energy;                         // force / length
    double critical_stretch;
    double strengthening;
    double fibre[PDMC_AXES]; // zero: none
    double fibre_ratio;
} pdmc_explicit_material;

typedef struct {
    pdmc_body body;     // its nodes belong to the study
    pdmc_share volumes; // of the nodes of a mesh
    char *file;     // of these nodes as the study names it; NULL where they are those of the grid in a shape
} pdmc_explicit_body;

typedef enum { PDMC_BETWEEN_MATERIALS, PDMC_BETWEEN_BODIES } pdmc_between;

/// What bonds between two materials are, or between two bodies: with a modulus and a strength of their own, or those of the
/// materials; see pdmc_interface.
typedef struct {
    pdmc_between between;
    int first_material, second_material, first_body, second_body;
    pdmc_explicit_material bonds; // no density, nor what has a direction
} pdmc_explicit_interface;

/// What is prescribed in a layer; its history has no points where the value is constant.
typedef struct {
    pdmc_layer_condition layer;
    int factor_count; // as the study gives them; that of layer.history is the number of times
} pdmc_explicit_condition;

typedef struct {
    pdmc_rigid_sphere sphere;
    double displacement[PDMC_AXES]; // at the last load of a quasi-static study
    bool has_mass; // otherwise it keeps its velocity
} pdmc_explicit_sphere;

/// Of bonds: by their length as it is, or to first order in the displacement.
typedef enum { PDMC_STRETCH_FULL, PDMC_STRETCH_LINEAR } pdmc_stretch_kind;

typedef struct {
    int dimension; // 2 or 3
    double spacing, offset[PDMC_AXES];
    bool has_horizon, has_horizon_ratio; // a study that was read has its horizon
    double horizon, horizon_ratio;
    pdmc_volume_rule volume_rule;
    pdmc_stretch_kind stretch;
    pdmc_precision precision;
    double thickness;           // in two dimensions
    pdmc_assumption assumption; // ... too
    int material_count, body_count, crack_count, condition_count, sphere_count, no_fail_count, interface_count;
    pdmc_explicit_material *materials;
    pdmc_explicit_body *bodies;
    char mesh_generator[PDMC_GENERATOR_SIZE]; // what read the meshes of bodies; "" without
    pdmc_planar_crack *cracks;
    pdmc_explicit_condition *conditions;
    pdmc_explicit_sphere *spheres;
    pdmc_shape *no_fail; // inside which no bond breaks
    pdmc_explicit_interface *interfaces;
    double contact_distance, contact_stiffness;
    double damping, bond_damping; // force time / length^4, time / length
    int load_steps;            // of a quasi-static problem; 0 of one in motion
    double load_ends[2];       // 0, and the last load
    double rest_tolerance;     // of the residual
    int most_relaxation_steps; // of a relaxation
    double duration;
    bool has_step; // otherwise `safety` times the stable one
    double step, safety;
    bool has_interval, has_speed_window; // a study that was read has both
    double interval;                     // of time, from record to record
    int snapshots;                       // states of all nodes that are kept
    double tip_damage;                   // damage of a node that a crack has reached
    double speed_window;                 // of time, over which the speed of a tip is taken
} pdmc_explicit;

/// Frees what the problem owns and sets it to zero; a zeroed one is allowed.
PDMC_API void pdmc_explicit_clear(pdmc_explicit *problem);

/// The law of a material's bonds: its micromodulus, from Young's or the bulk modulus where these are given,
/// E = 3 k (1 - 2 nu), and its critical stretch, from the fracture energy, or infinite.
PDMC_API pdmc_brittle_material pdmc_explicit_law(const pdmc_explicit *problem, const pdmc_explicit_material *material);

/// Area or volume of a shape.
PDMC_API double pdmc_explicit_extent(const pdmc_explicit *problem, const pdmc_shape *shape);

/// The nodes that a body has, or about as many as the grid has in its shape; a part has its host's.
PDMC_API double pdmc_explicit_nodes(const pdmc_explicit *problem, const pdmc_body *body);

/// Whether there are bonds between bodies.
PDMC_API bool pdmc_explicit_has_joints(const pdmc_explicit *problem);

/// The largest stable step of bodies on a grid, as the engine has it without random quantities; a lower bound where there are bonds
/// between bodies.
PDMC_API double pdmc_explicit_stable_step(const pdmc_explicit *problem);

/// What a problem amounts to, before its nodes are placed: bodies as if they did not overlap, whole neighbourhoods at
/// their surfaces, and so upper bounds of bonds and steps.
typedef struct {
    double nodes, bonds, steps;
} pdmc_explicit_amounts;
PDMC_API pdmc_explicit_amounts pdmc_explicit_count(const pdmc_explicit *problem);

/// A sample of a problem with random quantities: factors on what the problem says.
typedef struct {
    double load;                            // on all conditions
    double velocity;                        // on what bodies and spheres start with
    double youngs_modulus, fracture_energy; // on those of all materials
    int node_count;
    const double *stiffness, *strength; // [node_count] on c and s_0 at the nodes; NULL: 1
    const double *bond_strengths;       // [PDMC_STRENGTH_CLASSES] on s_0 of single bonds; NULL: 1
    uint64_t seed, sample;              // of these
} pdmc_explicit_sample;

/// Places the nodes of a sample. A fracture energy's factor acts on s_0 by its root. With another E a material that is given by
/// its fracture energy keeps that, and one that is given by its critical stretch keeps that.
/// @param[out] particles  to be destroyed by the caller; NULL on failure
/// @return as pdmc_explicit_particles(); PDMC_ERR_CONFIG also where a factor is not allowed or the study's step is not stable
PDMC_API PDMC_NODISCARD pdmc_status pdmc_explicit_sample_particles(const pdmc_explicit *problem,
                                                                   const pdmc_explicit_sample *sample, int threads,
                                                                   pdmc_particles **particles);

/// Places the nodes of the problem.
/// @param[out] particles  to be destroyed by the caller; NULL on failure
/// @return PDMC_OK, PDMC_ERR_CONFIG with what pdmc_particles_create() refuses, by the names of the study's settings, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_explicit_particles(const pdmc_explicit *problem, int threads,
                                                            pdmc_particles **particles);
