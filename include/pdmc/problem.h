// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem: a cracked plate, what is uncertain about it, and what is asked. Plain data, the same for every
/// discretisation; no module behind it reads a configuration. Lengths and forces are in the study's own units, angles
/// in radians, counter-clockwise from the x axis. The plate is centred at the origin.

#include "pdmc/design.h"
#include "pdmc/field.h"
#include "pdmc/mesh.h"

enum { PDMC_NAME_SIZE = 64 }; // with the terminating zero

/// Of a study of bodies, a scalar or an elastic one or one of quadrature this struct has the kind, the title and the units; the rest is in
/// pdmc/explicit.h, pdmc/scalar.h, pdmc/elastic.h or pdmc/horizon_study.h.
typedef enum {
    PDMC_STATIC,
    PDMC_DYNAMIC,
    PDMC_EXPLICIT,
    PDMC_QUASI_STATIC,
    PDMC_SCALAR,
    PDMC_ELASTIC,
    PDMC_QUADRATURE
} pdmc_problem_kind;

/// Whether a study is of bodies of bonds, see pdmc/explicit.h, and not of a plate.
static inline bool pdmc_is_of_bodies(pdmc_problem_kind kind)
{
    return kind == PDMC_EXPLICIT || kind == PDMC_QUASI_STATIC;
}

static inline bool pdmc_is_of_plate(pdmc_problem_kind kind)
{
    return kind == PDMC_STATIC || kind == PDMC_DYNAMIC;
}
typedef enum { PDMC_PLANE_STRESS, PDMC_PLANE_STRAIN } pdmc_assumption;
typedef enum { PDMC_SIDE_LEFT, PDMC_SIDE_RIGHT, PDMC_SIDE_BOTTOM, PDMC_SIDE_TOP } pdmc_side;

typedef struct {
    double width, height, thickness; // length
} pdmc_plate;

typedef struct {
    double youngs_modulus; // E, force / length^2
    pdmc_assumption assumption;
    double fracture_energy; // G_c, force / length
} pdmc_material;

/// A straight crack; its tips are called "<name>.from" and "<name>.to".
typedef struct {
    char name[PDMC_NAME_SIZE];
    double from[2], to[2]; // length
} pdmc_crack;

/// A uniform traction on a whole side of the plate.
typedef struct {
    pdmc_side side;
    double traction[2]; // force / length^2
} pdmc_load;

/// Displacements prescribed on a whole side; a component that is not held is free of traction, or loaded.
typedef struct {
    pdmc_side side;
    bool held[2];
    double displacement[2]; // length; 0 where not held
} pdmc_support;

/// What may be random. The scalars have a distribution of their own; the others, which come first, are functions. In an
/// explicit study, which may have several materials, a load, E and G_c are factors of mean 1.
typedef enum {
    PDMC_QUANTITY_MICROMODULUS,    // c(r), the same everywhere
    PDMC_QUANTITY_STIFFNESS,       // M(x) of mean 1, a factor on E
    PDMC_QUANTITY_LOAD_NOISE_LEFT, // 1 + v g(s), a factor on the traction along a side; others in the order of pdmc_side
    PDMC_QUANTITY_LOAD_NOISE_RIGHT,
    PDMC_QUANTITY_LOAD_NOISE_BOTTOM,
    PDMC_QUANTITY_LOAD_NOISE_TOP,
    PDMC_QUANTITY_LOAD,            // one factor on all tractions
    PDMC_QUANTITY_YOUNGS_MODULUS,  // E, force / length^2
    PDMC_QUANTITY_FRACTURE_ENERGY, // G_c, force / length
    PDMC_QUANTITY_THICKNESS,       // length; the forces on the sides stay, so that the tractions go with its inverse
    PDMC_QUANTITY_VELOCITY,        // of an explicit study: a factor on what bodies and spheres start with
    PDMC_QUANTITY_BOND_STRENGTH,   // of an explicit study: a factor on s_0, for every bond by itself
    PDMC_QUANTITY_LOAD_LEFT,       // a factor on the traction of one side; others in the order of pdmc_side
    PDMC_QUANTITY_LOAD_RIGHT,
    PDMC_QUANTITY_LOAD_BOTTOM,
    PDMC_QUANTITY_LOAD_TOP,
    PDMC_QUANTITY_LOAD_DIRECTION_LEFT, // by which it is turned, degrees, counter-clockwise; others in the same order
    PDMC_QUANTITY_LOAD_DIRECTION_RIGHT,
    PDMC_QUANTITY_LOAD_DIRECTION_BOTTOM,
    PDMC_QUANTITY_LOAD_DIRECTION_TOP,
    PDMC_QUANTITY_CRACK_LENGTH,    // length of a crack from end to end, about its middle
    PDMC_QUANTITY_CRACK_ANGLE,     // by which it is turned about its middle, degrees, counter-clockwise
    PDMC_QUANTITY_CRACK_X,         // by which its middle is shifted, length
    PDMC_QUANTITY_CRACK_Y,         // ... length
    PDMC_QUANTITIES,
    PDMC_FIRST_SCALAR = PDMC_QUANTITY_LOAD,
    PDMC_FIRST_OF_CRACK = PDMC_QUANTITY_CRACK_LENGTH
} pdmc_quantity;
enum { PDMC_SIDES = 4, PDMC_SCALARS = PDMC_QUANTITIES - PDMC_FIRST_SCALAR };

/// c(r) in equal bins of [0, horizon]: independent, or correlated over the radius.
typedef enum { PDMC_RADIAL_NOISE, PDMC_RADIAL_PROCESS } pdmc_radial_model;

/// The ways in which a study may name a distribution.
typedef enum {
    PDMC_PARAMETER_MEAN,
    PDMC_PARAMETER_VARIATION,
    PDMC_PARAMETER_MEDIAN,
    PDMC_PARAMETER_LOG_DEVIATION,
    PDMC_PARAMETER_LOCATION,
    PDMC_PARAMETER_SCALE,
    PDMC_PARAMETER_SHAPE,
    PDMC_PARAMETER_LOWER,
    PDMC_PARAMETER_MODE,
    PDMC_PARAMETER_UPPER,
    PDMC_PARAMETER_ALPHA,
    PDMC_PARAMETER_BETA,
    PDMC_PARAMETER_LEAST,
    PDMC_PARAMETER_MOST,
    PDMC_PARAMETERS
} pdmc_parameter;

typedef struct {
    bool has[PDMC_PARAMETERS];
    double value[PDMC_PARAMETERS];
} pdmc_parameters;

/// An uncertain quantity.
/// Micromodulus, "radial noise": c(r) = c_0 (1 + variation * Z_b) with independent standard normal Z_b in each of
/// `bins` equal bins of [0, horizon] (Evangelatos & Spanos 2011, eq. 51 and section 6.3). The number of bins is a
/// physical input: the scatter of the effective modulus falls as 1 / sqrt(bins). "Radial process": the Z_b are correlated.
/// Stiffness: a random field with the covariance and the variation.
/// Noise of a load: a stationary normal process along the side with the covariance and the variation.
/// Fracture energy with a correlation length: a field in space, of which every tip sees its own value. It has the law at every
/// point, and the normal variables behind two points have the covariance's correlation at their distance; what other scalars
/// share with it they share with the whole field, and the covariance is that of the rest.
typedef struct {
    pdmc_quantity quantity;
    pdmc_distribution_kind distribution;
    pdmc_parameters given;      // of a scalar: the parameters as the study gives them
    int value_count;            // of an empirical distribution
    double *values;             // [value_count] as the study gives them
    pdmc_distribution law;      // of a scalar, in its own unit; a load's is a factor
    pdmc_radial_model model;    // of the micromodulus
    int bins;                   // of the micromodulus, >= 1
    double variation;           // of a function: coefficient of variation at a point, >= 0
    pdmc_covariance covariance; // of a stiffness, the noise of a load, a radial process, and a fracture energy with a length
    bool has_length, has_smoothness;
    int modes; // of their expansion
    int crack; // that a length, an angle or a shift is of
} pdmc_uncertainty;

/// Of the normal variables behind two scalar quantities, in a Gaussian copula.
typedef struct {
    pdmc_quantity first, second;
    double correlation;
} pdmc_correlation;

/// How the collocation treats cracks: analytic fields (the local limit), stencils over visible nodes with bonds that
/// are really cut, or the paper's own recipe.
typedef enum { PDMC_CRACKS_ANALYTIC, PDMC_CRACKS_PAPER, PDMC_CRACKS_VISIBLE } pdmc_crack_model;

typedef enum { PDMC_OFF, PDMC_ON } pdmc_switch;

/// The radial function of the stencils over visible nodes: an inverse multiquadric, or r^3.
typedef enum { PDMC_STENCIL_IMQ, PDMC_STENCIL_POLYHARMONIC } pdmc_stencil_kind;

typedef enum { PDMC_METHOD_KANSA, PDMC_METHOD_BOND, PDMC_METHOD_GALERKIN } pdmc_method;

/// Finite elements of a plate: cells between lines, to which cracks must be parallel, or triangles by Gmsh.
typedef enum { PDMC_PLATE_CELLS, PDMC_PLATE_TRIANGLES } pdmc_plate_elements_kind;

enum { PDMC_GALERKIN_CRACKS = 24 }; // at most, of a plate by finite elements

/// The area by which a node's bond counts, of a cell that the edge of the horizon may cut: the whole cell if its middle
/// is inside; a share that falls linearly over the last half cells (partial volume); the exact area of the cell inside;
/// or that, with the bond to its centroid.
typedef enum { PDMC_AREA_FULL, PDMC_AREA_PARTIAL, PDMC_AREA_EXACT, PDMC_AREA_CENTROID } pdmc_bond_area;

/// What a random c(r) means for the bond to a cell: its average over the part of the cell inside the horizon, or its
/// value at the middle.
typedef enum { PDMC_MICROMODULUS_AVERAGED, PDMC_MICROMODULUS_AT_NODES } pdmc_bond_micromodulus;

/// Settings of the solver; which belong to which method and crack model is said in the table of settings.
typedef struct {
    pdmc_method method;
    pdmc_crack_model crack_model;
    double horizon; // delta, length
    double spacing; // h of the nodes, length
    bool has_horizon_ratio;
    double horizon_ratio;      // delta / h, where the study gives it
    double shape;              // psi of the inverse multiquadric, length
    int polynomial_degree;     // of the appended monomials
    int crack_orders;          // M, orders w^1 .. w^M of the analytic crack fields
    int radial_points;         // rings on which the operator is sampled for a random c(r)
    pdmc_switch tip_functions; // of the paper's crack model: eq. 38 at every tip
    double edge_layer;         // of the paper's crack model: e, the thickness of the layer that loads act on, length
    int refinement;            // nodes a horizon near the cracks, of the visible crack model
    pdmc_stencil_kind stencil; // ... and the radial function of its stencils
    pdmc_bond_area area;       // of the bond method, as are the rest
    pdmc_switch surface_correction; // bonds near an edge stiffened by the energy that the missing ones would hold
    pdmc_bond_micromodulus micromodulus;
    double load_layer; // thickness of the layer that a traction is spread over, length; of finite elements too
    pdmc_space_kind space; // of finite elements, as is the rest
    int outer_parts;       // of each side of an element, with points of the outer integral in every one
    pdmc_plate_elements_kind mesh;
} pdmc_solver_options;

typedef enum { PDMC_INVERSE_DIRECT, PDMC_INVERSE_NEUMANN, PDMC_INVERSE_KRYLOV, PDMC_INVERSE_REDUCED } pdmc_inverse;

/// What must be known well before sampling stops: nothing, or at every tip the mean or the 95 % quantile of the energy in
/// the direction where the mean plate has its largest, or P(G > G_c).
typedef enum { PDMC_TARGET_NONE, PDMC_TARGET_MEAN, PDMC_TARGET_QUANTILE, PDMC_TARGET_PROBABILITY } pdmc_target;

typedef struct {
    uint64_t seed;
    int samples; // at least, where there is a target
    pdmc_target target;
    double relative_error; // of the target: half the width of its interval over its value
    int most_samples;      // at which sampling stops without it
    int keep; // of so many of the first independent samples, c(r) and all energies are kept
    pdmc_design_kind design;
    int replicates; // of a design that is not plain Monte Carlo
    pdmc_inverse inverse;
    int order;               // of the Neumann expansion
    double tolerance;        // of the relative residual of Krylov's iteration
    double energy_tolerance; // of a sample's largest energy, relative, by the reduced model
} pdmc_sampling;

/// How the probability of a rare growth is found, besides counting samples.
typedef enum { PDMC_RARE_NONE, PDMC_RARE_IMPORTANCE, PDMC_RARE_SUBSET, PDMC_RARE_BOTH } pdmc_rare_method;

/// The event is that the largest energy of any of the tips exceeds G_c.
typedef struct {
    pdmc_rare_method method;
    double variation; // coefficient of variation of P that is asked for
    int evaluations;  // at most, of each method
    int sensitivity;  // rows of the designs for Sobol' indices; 0: none
} pdmc_reliability_request;

/// A cheaper method whose samples, drawn with the same random numbers, are controls of the study's own.
typedef struct {
    int samples;                // of the cheaper method, more than the study's own; 0: none
    pdmc_solver_options solver; // the study's horizon, and the method's defaults but for the spacing
} pdmc_control_request;

typedef enum { PDMC_BONDS_ALL, PDMC_BONDS_TENSILE } pdmc_bonds;
typedef enum { PDMC_MEASURE_BOND, PDMC_MEASURE_GRIFFITH } pdmc_measure;
enum { PDMC_MEASURES = 2 };

/// Where the bonds of G_E cross the line of growth: at the point x_t, or anywhere between the tip and x_t, averaged.
typedef enum { PDMC_LINE_POINT, PDMC_LINE_SEGMENT } pdmc_energy_line;

/// Which energy release rates are asked for.
typedef struct {
    int tip_count;
    int *tips;             // [tip_count] tip numbers: 2 * crack for its "from", 2 * crack + 1 for its "to"
    int angles;            // directions phi_k = 2 pi k / angles
    double extension;      // delta_alpha, distance from the tip to the point where bonds cross, length
    double horizon;        // radius of the bonds that are counted, length
    pdmc_energy_line line; // of the collocation; a grid of bonds has segments
    pdmc_bonds bonds;      // bonds in tension only, or all
    pdmc_measure measure;  // what P(G > G_c) and the direction are computed from
    bool measure_alone;    // models may leave out what the other measure needs
} pdmc_energy_request;

/// Of a dynamic problem: the plate is at rest until time 0, and the loads follow a history.
typedef struct {
    double density;  // rho, mass / length^3, the mass in force time^2 / length
    double damping;  // d, 1 / time: a force -rho d u' on every point
    double step;     // of time
    double duration; // of time, reached by whole steps
} pdmc_dynamics;

/// The factor on all tractions at a time; linear in between, constant before the first point and after the last.
typedef struct {
    double time, factor;
} pdmc_history_point;

typedef enum { PDMC_FACE_NONE, PDMC_FACE_LEFT, PDMC_FACE_RIGHT } pdmc_face;

/// A point whose displacement is recorded. On a crack it belongs to one of the faces, left or right of from -> to.
typedef struct {
    char name[PDMC_NAME_SIZE];
    double at[2]; // length
    pdmc_face face;
} pdmc_probe;

typedef struct {
    pdmc_problem_kind kind;
    char *title;
    char *length_unit, *force_unit, *time_unit;
    pdmc_plate plate;
    pdmc_material material;
    int crack_count;
    pdmc_crack *cracks; // [crack_count]
    int load_count;
    pdmc_load *loads; // [load_count]
    int support_count;
    pdmc_support *supports; // [support_count]
    pdmc_dynamics dynamics; // zero in a static problem, as are the history and the probes
    int history_count;
    pdmc_history_point *history; // [history_count], ascending in time
    int probe_count;
    pdmc_probe *probes; // [probe_count]
    int uncertainty_count;
    pdmc_uncertainty *uncertainties; // [uncertainty_count], each quantity at most once
    int correlation_count;
    pdmc_correlation *correlations; // [correlation_count]
    pdmc_solver_options solver;
    pdmc_sampling sampling;
    pdmc_reliability_request reliability;
    pdmc_control_request control;
    pdmc_energy_request energy;
} pdmc_problem;

/// Frees what the problem owns and sets it to zero; a zeroed problem is allowed.
PDMC_API void pdmc_problem_clear(pdmc_problem *problem);

/// The entry for a quantity, or NULL where the quantity is certain.
PDMC_API const pdmc_uncertainty *pdmc_problem_uncertainty(const pdmc_problem *problem, pdmc_quantity quantity);

/// Whether a quantity is one of those of the four sides that begin with `first`, that of the left.
static inline bool pdmc_is_of_sides(pdmc_quantity quantity, pdmc_quantity first)
{
    return first <= quantity && (int)quantity < (int)first + PDMC_SIDES;
}

/// The mean of a scalar quantity where the study does not give it: 1 in an explicit study and for loads, the material's, the plate's, the length of
/// the crack, 0 for its angle and shift and for the direction of a load.
PDMC_API double pdmc_problem_nominal(const pdmc_problem *problem, pdmc_quantity quantity);

/// Whether the fracture energy varies in space, so that every tip has one of its own.
PDMC_API bool pdmc_problem_varies_toughness(const pdmc_problem *problem);

/// Whether the place of a crack is random, so that every sample has a plate of its own.
PDMC_API bool pdmc_problem_moves_cracks(const pdmc_problem *problem);

/// Where a tip is, by its number; [2], a part of `cracks`.
static inline const double *pdmc_crack_end(const pdmc_crack cracks[], int tip)
{
    return tip % 2 ? cracks[tip / 2].to : cracks[tip / 2].from;
}

/// By how much a crack is turned; radians.
/// @param[in] value  [PDMC_SCALARS] of the scalar quantities
PDMC_API double pdmc_problem_turn(const pdmc_problem *problem, int crack, const double value[]);

/// The cracks as the scalar quantities place them.
/// @param[in]  value   [PDMC_SCALARS] of the scalar quantities
/// @param[out] cracks  [crack_count]
PDMC_API void pdmc_problem_place_cracks(const pdmc_problem *problem, const double value[], pdmc_crack cracks[]);

/// Half the length of the shortest crack whose tips the method knows at its horizon.
PDMC_API double pdmc_problem_least_half_crack(const pdmc_problem *problem);

/// Whether cracks can be in the place of the problem's own: with the same tips inside the plate, none too short for the
/// horizon, and none nearer to an edge or to another crack than the horizon, the spacing, or the problem's own.
/// @param[in] cracks  [crack_count]
PDMC_API bool pdmc_problem_cracks_fit(const pdmc_problem *problem, const pdmc_crack cracks[]);

/// The correlation of the normal variables behind the scalar quantities, in the order of pdmc_quantity; 1 on the diagonal,
/// 0 where the study says nothing.
/// @param[out] matrix  [PDMC_SCALARS, PDMC_SCALARS]
PDMC_API void pdmc_problem_correlation(const pdmc_problem *problem, double matrix[]);

/// Whether a displacement other than 0 is prescribed: the solution is then no multiple of the load.
PDMC_API bool pdmc_problem_moves_sides(const pdmc_problem *problem);

/// Poisson's ratio of the bond-based model: 1/3 in plane stress, 1/4 in plane strain.
PDMC_API double pdmc_poissons_ratio(pdmc_assumption assumption);

/// The modulus E' of plane problems, K^2 / G: E in plane stress, E / (1 - nu^2) in plane strain.
PDMC_API double pdmc_plane_modulus(const pdmc_material *material);

/// The mean micromodulus c of the bond force c s / |xi| per unit thickness: 9 E / (pi delta^3) in plane stress,
/// 48 E / (5 pi delta^3) in plane strain, force / length^5 (eq. 16 of Evangelatos & Spanos 2011 is half of this in
/// print).
PDMC_API double pdmc_micromodulus(const pdmc_material *material, double horizon);

/// Of how many samples c(r) and all energies are kept: all of a design, whose intervals need them.
PDMC_API int pdmc_problem_kept(const pdmc_problem *problem);

/// The number of time steps of a dynamic problem: duration / step, rounded up.
PDMC_API int pdmc_problem_steps(const pdmc_problem *problem);

/// The crack that a point lies on, within 1e-9 of the plate's size, or -1.
PDMC_API int pdmc_problem_crack_at(const pdmc_problem *problem, const double x[2]);

/// Whether a crack's end is inside the plate, and so a tip; not on its edge or beyond.
PDMC_API bool pdmc_problem_is_tip(const pdmc_problem *problem, int tip);

/// The part of a crack that is inside the plate: `from` and `to`, or where the crack goes through an edge.
/// @param[out] ends  from and to, length
PDMC_API void pdmc_problem_crack_inside(const pdmc_problem *problem, int crack, double ends[2][2]);

/// The speed of plane pressure waves, sqrt(3 mu / rho) with lambda = mu, length / time.
PDMC_API double pdmc_wave_speed(const pdmc_material *material, double density);

/// The rigid motions that the supports leave free.
/// @param[out] count    0 to 3
/// @param[out] motions  [count, 3] t_x, t_y, omega: u = t_x - omega y, v = t_y + omega x
/// @return PDMC_OK or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_problem_free_motions(const pdmc_problem *problem, int *count,
                                                              double motions[3][3]);

/// Refuses what a random load of one side cannot be: of a side without a load, turned where it has noise or where a support
/// holds the side, or doing work on a rigid motion which nothing holds: then samples would not be in equilibrium.
/// @return PDMC_OK (also for other quantities), PDMC_ERR_CONFIG, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_problem_check_random_load(const pdmc_problem *problem, pdmc_quantity quantity);

/// Refuses tractions, as they are given or as they vary, that do work on a rigid motion which nothing holds.
/// @return PDMC_OK, PDMC_ERR_CONFIG, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_problem_check_equilibrium(const pdmc_problem *problem);

/// What Gmsh is to make of a plate with finite elements.
/// @param[out] slits  [crack_count] its cracks, which must outlive what is returned
PDMC_API pdmc_mesh_plate pdmc_problem_mesh_plate(const pdmc_problem *problem, pdmc_slit slits[]);
