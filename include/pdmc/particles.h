// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Motion and fracture of bodies that are held together by bonds (Silling & Askari, Computers & Structures 83 (2005)
/// 1526-1535): nodes on a regular grid in two or three dimensions, the prototype microelastic brittle material, cracks,
/// contact, and rigid spheres. All quantities in one consistent set of units; in two dimensions z is zero everywhere, a
/// node's volume is spacing^2 thickness.

#include "pdmc/distribution.h"
#include "pdmc/dynamics.h"
#include "pdmc/problem.h"

enum { PDMC_AXES = 3, PDMC_STRENGTH_CLASSES = 1024 };

/// How a material resists: c and s_0 of its bonds. Bonds do not fail in compression.
typedef struct {
    char name[PDMC_NAME_SIZE];
    double density;      // rho, mass / length^3
    double micromodulus; // c, force / length^6 (the same unit in two dimensions, where the volume has the thickness)
    double critical_stretch; // s_00; infinite: bonds never break
    double strengthening;    // alpha: s_0 = s_00 - alpha s_min, s_min the least stretch of all bonds of a node (eq. 28)
    double fibre[PDMC_AXES]; // direction of fibres, of any length; zero: none
    double fibre_ratio; // c along it over that across; else beta^2 c_fibre + (1 - beta^2) c, beta the cosine (eq. 10)
    const double
        *strengths; // [PDMC_STRENGTH_CLASSES] factors of s_0, each as likely for a bond as the others; NULL: all 1
} pdmc_brittle_material;

/// How much of a neighbour's volume counts where the horizon's edge may cut it: all if its node is inside; a share that falls
/// linearly from 1 at horizon - spacing / 2 to 0 at horizon + spacing / 2 (the only one of the three whose sums come to the
/// integrals as the spacing falls); or that share, but nothing beyond the horizon, as others do it.
typedef enum { PDMC_VOLUME_WHOLE, PDMC_VOLUME_PARTIAL, PDMC_VOLUME_TAPERED } pdmc_volume_rule;

/// In which bonds are computed. Single: from displacements that are rounded to it, with forces of that precision; positions,
/// velocities, what acts on nodes, and all energies but those of bonds as they break stay in double precision.
typedef enum { PDMC_PRECISION_DOUBLE, PDMC_PRECISION_SINGLE } pdmc_precision;

/// Nodes, mesh: the body has nodes of its own, wherever they are, listed or those of a mesh.
typedef enum {
    PDMC_SHAPE_BOX,
    PDMC_SHAPE_CYLINDER,
    PDMC_SHAPE_BALL,
    PDMC_SHAPE_NODES,
    PDMC_SHAPE_MESH
} pdmc_shape_kind;

/// Whether it has no region of the grid.
static inline bool pdmc_shape_has_nodes(pdmc_shape_kind kind)
{
    return kind == PDMC_SHAPE_NODES || kind == PDMC_SHAPE_MESH;
}

/// A region of space; nodes on its edge are inside, to 1e-9 of the spacing.
typedef struct {
    pdmc_shape_kind kind;
    double from[PDMC_AXES], to[PDMC_AXES]; // corners of a box; middles of a cylinder's ends, along one of the axes
    double centre[PDMC_AXES];              // of a ball
    double radius;                         // of a cylinder or a ball
} pdmc_shape;

/// A node that need not be on the grid.
typedef struct {
    double x[PDMC_AXES], volume; // z = 0 in two dimensions; length^3 in both
} pdmc_node;

/// Nodes of one material that start with one velocity. Bonds connect nodes of one body, of a body with its parts, of these
/// with one another, and of bodies with an interface between them; other bodies only touch.
typedef struct {
    char name[PDMC_NAME_SIZE];
    pdmc_shape shape; // of which no node is in another body, unless it is a part of that
    int node_count;
    const pdmc_node *nodes; // [node_count] of shapes that have nodes
    int material;
    double velocity[PDMC_AXES]; // of a part that of its host
    bool is_part; // it has those of the host's nodes that its shape holds; of two parts the later one has them
    int host;     // an earlier body that is no part itself
} pdmc_body;

/// What bonds are between nodes of two bodies, or of two materials wherever their bodies have bonds; bodies that are named have
/// bonds by that. An interface of bodies goes before one of materials, an earlier one before a later.
typedef struct {
    char name[PDMC_NAME_SIZE];
    bool of_bodies; // or of materials, which may be the same
    int first, second;
    double micromodulus;     // 0: the harmonic mean of both materials', that of two halves of a bond in series
    double critical_stretch; // without strengthening; 0: that of the weaker node
} pdmc_interface;

typedef enum { PDMC_CRACK_SEGMENT, PDMC_CRACK_DISC, PDMC_CRACK_RECTANGLE } pdmc_planar_crack_kind;

/// A surface whose crossing bonds are broken before the start: a straight segment in the plane (through all z), a disc, or a
/// rectangle of centre +- side[0] +- side[1].
typedef struct {
    char name[PDMC_NAME_SIZE];
    pdmc_planar_crack_kind kind;
    double from[2], to[2];            // of a segment
    double centre[PDMC_AXES];         // of a disc or a rectangle
    double normal[PDMC_AXES], radius; // of a disc; the normal of any length
    double side[2][PDMC_AXES];        // of a rectangle: from the centre to the middles of two edges
} pdmc_planar_crack;

typedef enum { PDMC_CONDITION_VELOCITY, PDMC_CONDITION_FORCE, PDMC_CONDITION_DISPLACEMENT } pdmc_condition_kind;

/// What is prescribed in a layer of nodes: components of the velocity or the displacement, or a force on a unit of volume. At
/// the node X of the reference configuration it is (value + gradient X) times the history's factor.
typedef struct {
    char name[PDMC_NAME_SIZE];
    pdmc_condition_kind kind;
    pdmc_shape region; // in the reference configuration
    bool along[PDMC_AXES];
    double value[PDMC_AXES];               // length / time, force / length^3, or length
    double gradient[PDMC_AXES][PDMC_AXES]; // ... over length; row by row of the components
    pdmc_history history;
} pdmc_layer_condition;

/// A rigid sphere without friction: a node at the distance r < radius of its centre is pushed out by the force
/// stiffness (radius - r)^2 on a unit of its volume.
typedef struct {
    char name[PDMC_NAME_SIZE];
    double radius, centre[PDMC_AXES], velocity[PDMC_AXES];
    double mass;      // infinite: it keeps its velocity
    double stiffness; // force / length^5
} pdmc_rigid_sphere;

typedef struct {
    int dimension;  // 2 or 3
    double spacing; // of the grid, which has nodes at whole multiples of it plus `offset`
    double offset[PDMC_AXES];
    double thickness; // in two dimensions
    double horizon;
    int no_fail_count;         // zones inside which no bond breaks: both of its nodes lie in them
    const pdmc_shape *no_fail; // [no_fail_count]
    bool linear_stretch;       // s = eta . xi / |xi|^2, along the bond as it was, and the force too: for small motions
    pdmc_volume_rule volume_rule;
    double
        contact_distance; // d_c over spacing: nodes repel each other below min(0.9 of their first distance, d_c); 0: never
    double contact_stiffness; // of the repulsion, over that of a bond as long as the horizon: 15 by convention
    int material_count, body_count, crack_count, condition_count, sphere_count;
    const pdmc_brittle_material *materials; // the caller's, as are the other lists; needed by create() alone
    const pdmc_body *bodies;
    const pdmc_planar_crack *cracks;
    const pdmc_layer_condition *conditions;
    const pdmc_rigid_sphere *spheres;
    int interface_count;
    const pdmc_interface *interfaces;
    int factor_count;                // of nodes, in their order, where there are factors:
    const double *stiffness_factors; // [factor_count] of c, > 0; that of a bond is the mean of its nodes'; NULL: all 1
    const double *strength_factors;  // [factor_count] of s_00, > 0; a bond has the s_0 of the weaker node; NULL: all 1
    uint64_t seed, sample;           // of the bonds' own strengths: counter based, in the stream PDMC_STREAM_BONDS
    double damping;                  // C of a force -C v on a unit of volume (Yu 2011, eq. 3.63)
    double
        bond_damping; // c_v of a bond's force c (s + c_v ds), ds the rate by which its ends part (eq. 3.64, along the bond)
    double step;      // of time; 0: `safety` times the stable one
    double safety;
    pdmc_precision precision;
    int threads; // no result depends on them
} pdmc_particles_options;

/// Sums over all nodes. Energy: kinetic + elastic + fracture + contact + dissipated = first + work: of small motions to rounding,
/// else but for errors of the second order in the step.
typedef struct {
    double kinetic; // rho v_- . v_+ / 2, of half a step before and after; where a motion is prescribed rho v . v / 2
    double elastic, contact;
    double dissipated; // by damping, or where bonds break between states of rest
    double fracture;   // in the bonds at the moment they broke
    double work;       // of conditions and of spheres that keep their velocity
    double first;      // kinetic, at the start
    double momentum[PDMC_AXES];
    double mean_damage;
    uint64_t broken; // bonds, those cut by cracks included
} pdmc_particles_sums;

/// Bodies in motion.
typedef struct pdmc_particles pdmc_particles;

/// The micromodulus of an isotropic material (Silling & Askari 2005, eq. 23; in two dimensions from the strain energy of
/// an isotropic stretch): 12 E / (pi horizon^4) in three dimensions (Poisson's ratio 1/4), 9 E / (pi horizon^3 t) in plane
/// stress (1/3), 48 E / (5 pi horizon^3 t) in plane strain (1/4).
/// @param[in] thickness  t, in two dimensions
PDMC_API double pdmc_brittle_micromodulus(int dimension, pdmc_assumption assumption, double youngs_modulus,
                                          double horizon, double thickness);

/// s_0 from the fracture energy: sqrt(10 G_0 / (pi c horizon^5)) (eq. 27), in two dimensions sqrt(4 G_0 / (c t horizon^4)).
PDMC_API double pdmc_brittle_critical_stretch(int dimension, double fracture_energy, double micromodulus,
                                              double horizon, double thickness);

/// Factors of the strengths of single bonds: the quantiles of a distribution at (k + 1/2) / PDMC_STRENGTH_CLASSES. A bond draws
/// one of them by a hash of its nodes, the seed and the sample, so that nothing of it is kept in memory.
/// @param[in]  distribution  of positive quantities, see pdmc/distribution.h; its mean should be 1
/// @param[out] strengths     [PDMC_STRENGTH_CLASSES] ascending
/// @return PDMC_OK, or PDMC_ERR_ARG where it is no distribution or the least factor is not > 0
PDMC_API PDMC_NODISCARD pdmc_status pdmc_brittle_strengths(const pdmc_distribution *distribution, double strengths[]);

/// Places the nodes, cuts the cracks, and starts at time 0.
/// @param[out] particles  to be destroyed by the caller; NULL on failure
/// @return PDMC_OK; PDMC_ERR_ARG with the reason where there is no node, bodies overlap, a step is not stable, a crack
///         crosses no bond or isolates a node, or an interface joins nothing; a message about an element of a list begins
///         with it, as in "cracks[2]: "; PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_particles_create(const pdmc_particles_options *options,
                                                          pdmc_particles **particles);
PDMC_API void pdmc_particles_destroy(pdmc_particles *particles);

/// The largest step that is stable for small strain, sqrt(2 rho / sum_p V_p |C_p|), C = c / |xi| (eq. 46), over all nodes. With
/// the damping of bonds, whose velocities are those of half a step before, the root of A dt^2 + 2 B dt = 4, A = 2 sum_p V_p
/// |C_p| / rho, B = 2 c c_v sum_p V_p / rho.
PDMC_API double pdmc_particles_stable_step(const pdmc_particles *particles);
PDMC_API double pdmc_particles_step_size(const pdmc_particles *particles);

/// The name of the kernel in use: "avx512", "avx2" or "portable". Their results agree to rounding, not to the bit.
PDMC_API const char *pdmc_particles_kernel(const pdmc_particles *particles);

/// Takes steps of the central difference formula (eq. 32).
/// @return PDMC_OK; PDMC_ERR_SINGULAR with the step and the node that would move by more than the horizon in the next one: the
///         state is then that of this step, and finite; PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_particles_advance(pdmc_particles *particles, int steps);

/// How bodies are brought to rest.
typedef struct {
    double
        tolerance;  // > 0, of the residual: the norm of the forces out of balance, over the largest one of the external
                    // forces (prescribed ones and reactions) at rest so far, this load's included
    int most_steps; // of a relaxation, after which it has failed
    double damping; // of the relaxation, constant, in [0, 2) as in pdmc/relaxation.h; negative: adaptive
    bool (*go_on)(void *context, int steps); // asked now and then; NULL is allowed
    void *context;
} pdmc_rest_options;

/// How they came to rest.
typedef struct {
    double residual;
    int steps;     // of relaxation, all together
    int breakages; // times that bonds broke, all that were stretched too far at once, and the rest was relaxed again
} pdmc_rest;

/// Brings the bodies to rest under their conditions at a load, instead of moving them: dynamic relaxation while no bond breaks;
/// then all that are stretched beyond s_0 break, and so on until none does. Displacements and forces are those of their
/// histories at the time `load`; a rigid sphere is where its velocity would have brought it by then. Work is that of external
/// forces between states of rest, by the trapezoidal rule; what is lost where bonds break at a load is dissipated, and the
/// rest of the work is elastic, in contact, or in the bonds that broke: a balance of the second order in the loads' steps.
/// @param[in]  load  the first is best one without force; pdmc_particles_time() is the last one
/// @param[out] rest  also of a failure
/// @return PDMC_OK; PDMC_ERR_ARG where bodies have moved, a velocity is prescribed, or a sphere has a mass; PDMC_ERR_SINGULAR with
///         load and residual where a relaxation does not end, or a force acts on a node without bonds; PDMC_ERR_INTERRUPTED;
///         PDMC_ERR_NOMEM. After a failure the state is that of an unfinished relaxation.
PDMC_API PDMC_NODISCARD pdmc_status pdmc_particles_come_to_rest(pdmc_particles *particles, double load,
                                                                const pdmc_rest_options *options, pdmc_rest *rest);

PDMC_API int pdmc_particles_count(const pdmc_particles *particles);         // nodes
PDMC_API uint64_t pdmc_particles_bonds(const pdmc_particles *particles);    // pairs, at the start without cracks
PDMC_API size_t pdmc_particles_bond_bytes(const pdmc_particles *particles); // of memory beyond the nodes' own
PDMC_API double pdmc_particles_time(const pdmc_particles *particles);
PDMC_API int pdmc_particles_steps(const pdmc_particles *particles);
PDMC_API pdmc_particles_sums pdmc_particles_sum(const pdmc_particles *particles);

/// What single precision does to the forces: those of bonds and of neighbours' repulsion in the present state, in both precisions.
/// @param[out] difference  the largest of a node, over the largest force of a node in double precision, or that of bonds which are
///                         all stretched by 6e-8 where nothing is larger; 0 in double precision
/// @return PDMC_OK; PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_particles_precision(pdmc_particles *particles, double *difference);

/// Values at the nodes, in the order x fastest, then y, then z.
/// @param[out] x          [count, 3] in the reference configuration
/// @param[out] u velocity [count, 3] or NULL
/// @param[out] damage     [count] (eq. 21), or NULL
/// @param[out] body       [count], or NULL
PDMC_API void pdmc_particles_reference(const pdmc_particles *particles, double x[], int body[]);
PDMC_API void pdmc_particles_state(const pdmc_particles *particles, double u[], double velocity[], double damage[]);

/// A piece of the bodies: nodes that bonds hold together, directly or by way of others. A node without bonds is a piece.
typedef struct {
    int nodes;
    double mass;
    double centre[PDMC_AXES], velocity[PDMC_AXES]; // of its centre of mass, as it is now
} pdmc_fragment;

/// Finds the pieces, numbered from 0 by falling mass, of equal ones by their first node.
/// @param[out] of_node  [count] the number of each node's piece
/// @param[out] count    of the pieces
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_particles_find_fragments(const pdmc_particles *particles, int of_node[],
                                                                  int *count);

/// What the pieces are. @param[in] of_node, count  as found @param[out] fragments  [count]
PDMC_API void pdmc_particles_fragments(const pdmc_particles *particles, const int of_node[], int count,
                                       pdmc_fragment fragments[]);

/// The conditions as they are now: the whole force on the nodes, which is the reaction where the motion is prescribed, and
/// the mean of the nodes' displacements. @param[out] force displacement  [condition_count, 3]
PDMC_API void pdmc_particles_conditions(const pdmc_particles *particles, double force[], double displacement[]);

/// The bonds of interfaces. @param[out] bonds  [interface_count] at the start, without cracks @param[out] broken  [interface_count] as
/// it is now, those cut by cracks included
PDMC_API void pdmc_particles_interfaces(const pdmc_particles *particles, uint64_t bonds[], uint64_t broken[]);

/// The rigid spheres as they are now; their velocities at rest are zero. @param[out] spheres  [sphere_count]
PDMC_API void pdmc_particles_spheres(const pdmc_particles *particles, pdmc_rigid_sphere spheres[]);

/// By which the nodes push the spheres. @param[out] force  [sphere_count, 3]
PDMC_API void pdmc_particles_sphere_forces(const pdmc_particles *particles, double force[]);
