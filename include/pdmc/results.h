// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The results of a study: what the solver found, every sample, and their statistics; one HDF5 file.

#include "pdmc/reliability.h"
#include "pdmc/study.h"

typedef enum {
    PDMC_RUN_COMPLETE,
    PDMC_RUN_INTERRUPTED,
    PDMC_RUN_TARGET_MET, // complete, with the precision that was asked for
    PDMC_RUN_SAMPLE_CAP, // complete, but the most samples allowed did not reach it
    PDMC_RUN_NOT_FINITE, // an explicit study stopped where a position would not have been finite
    PDMC_RUN_NO_REST,    // a quasi-static study stopped where bodies did not come to rest
} pdmc_run_status;
enum { PDMC_RUN_STATUSES = 6 };
PDMC_API extern const char *const pdmc_run_status_names[PDMC_RUN_STATUSES]; // "complete", "interrupted", ...

/// Why a sample has no result. Failed samples are counted and listed, never dropped.
typedef enum {
    PDMC_SAMPLE_OK = 0,
    PDMC_SAMPLE_DIVERGED = 1, // the Neumann expansion of this sample does not contract
    PDMC_SAMPLE_SINGULAR = 2, // the sample's own system is rank deficient
    PDMC_SAMPLE_SOFT = 3,     // the sample's effective modulus, or its thickness, is not positive
    PDMC_SAMPLE_GEOMETRY = 4, // the sample's cracks leave the plate, come too near, or cannot be discretised
} pdmc_sample_failure;

/// How a sample was solved in the end.
typedef enum {
    PDMC_SOLVED_AS_ASKED = 0,
    PDMC_SOLVED_BY_KRYLOV = 1, // its expansion does not contract, or the reduced model could not tell it from G_c
    PDMC_SOLVED_IN_SPACE = 2,  // its expansion does not contract: what it stands for, in the space of its terms
    PDMC_SOLVED_DIRECTLY = 3,  // nor did conjugate gradients converge: its own factorisation
} pdmc_sample_solver;

enum { PDMC_LONG_NAME_SIZE = PDMC_NAME_SIZE + 8 }; // of a crack and its end, with the terminating zero

/// A tip, with the solution at the mean of all uncertain quantities.
typedef struct {
    char name[PDMC_LONG_NAME_SIZE]; // "<crack>.from" or "<crack>.to"
    double position[2];            // length
    double direction;              // angle of straight-ahead growth, rad
    double stress_intensity[2];    // K_I, K_II, force / length^(3/2)
    double t_stress;               // force / length^2
    double stress_intensity_error[2], t_stress_error; // differences to a solution with 1.25 times the spacing
} pdmc_tip;

/// Figures that say how far the discretisation can be trusted.
typedef struct {
    int nodes, unknowns, rows, rank;
    double condition;    // of the column-scaled mean operator
    double residual;     // largest row residual at the mean, force / length^2
    double horizon, spacing;
} pdmc_solver_report;

/// Statistics of one measure of the energy release rate; T tips, A angles, B bins, Q = 3 quantiles.
/// All energies are in force / length; intervals are at `confidence`.
enum { PDMC_QUANTILES = 3 };
extern PDMC_API const double pdmc_quantile_levels[PDMC_QUANTILES]; // 0.05, 0.50, 0.95

typedef struct {
    pdmc_estimate *mean;               // [T, A]
    pdmc_estimate *standard_deviation; // [T, A]
    pdmc_estimate *quantiles;          // [T, A, Q]
    double *histogram_edges;           // [T, A, B + 1]
    int64_t *histogram_counts;         // [T, A, B + 2] with underflow first and overflow last
    pdmc_estimate *density;            // [T, A, B] probability density, length / force
} pdmc_energy_statistics;

/// How well the samples were solved; NaN where the inverse has no such figure, and in files that do not hold them.
typedef struct {
    double iteration_residual;           // largest relative residual of conjugate gradients
    double reduced_unknowns;             // of the reduced model
    double energy_error[PDMC_MEASURES];  // largest bound of the relative error of a sample's largest energy
    double typical_error[PDMC_MEASURES]; // the median of those bounds
    double solved_in_full;               // samples whose energy was too near to G_c for the reduced model
    double mean_error[PDMC_MEASURES];    // by which the reduced model may shift a mean in any direction, over that of the
                                         // largest energy
    double quantile_error[PDMC_MEASURES][PDMC_QUANTILES]; // the same of quantiles
} pdmc_sample_accuracy;
extern PDMC_API const pdmc_sample_accuracy pdmc_no_accuracy; // NaN throughout

/// What one method says of the probability that any tip grows.
typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    pdmc_reliability found;
    double evaluations, failed; // as numbers of the file
    int complete;               // whether the variation that was asked for was met
} pdmc_reliability_record;

/// A random quantity's part in the margin log G / G_c.
typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    int variables;              // normal variables behind it
    double importance;          // sum of alpha_i^2 at the design point; NaN without one
    pdmc_estimate first, total; // Sobol' indices; NaN where they were not asked for
} pdmc_reliability_group;

typedef struct {
    int record_count;
    pdmc_reliability_record *records; // [record_count]
    int group_count;
    pdmc_reliability_group *groups; // [group_count]
    int variable_count;
    double *design_point; // [variable_count] z, or 0 where it was not searched
    double first_order_index, first_order_probability, first_order_evaluations; // NaN where there is no design point
    double solved_in_full; // points too near to G_c for the reduced model
} pdmc_reliability_results;

/// What samples of a cheaper method say of the study's own, by control variates.
typedef struct {
    int tip_count;              // T, or 0 where there are none
    double samples, failed;     // of the cheaper method
    double advised_samples;     // that would give the narrowest intervals of means for the time these have taken
    pdmc_estimate *mean;        // [T, A] of the measure that decides; NaN where samples failed, as the others
    double *correlation;        // [T, A] of the energies of both methods
    double *mean_gain;          // [T, A] variance of the plain mean over that of this one
    pdmc_estimate *probability; // [T] P(max over angles of `measure` > fracture energy)
    double *probability_gain;   // [T] squared ratio of the plain interval's width to this one's
} pdmc_control_results;

/// The plate as it was discretised, and its displacement at the mean.
typedef struct {
    int node_count;
    double *node_position;     // [node_count, 2]
    double *node_displacement; // [node_count, 2]
    int face_points;           // points along each crack
    double *face_position;     // [crack_count, face_points, 2] from "from" to "to"
    double *face_displacement; // [crack_count, face_points, 2 (left, right of from -> to), 2]
} pdmc_displacement_field;

/// A point whose displacement a dynamic study records.
typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    double position[2]; // length
    int face;           // pdmc_face
} pdmc_probe_record;

/// The motion of a dynamic study at N times, of which the first is the start; P probes. Energies are those of the whole
/// plate, in force length; without rounding, work = kinetic + elastic + dissipated.
typedef struct {
    int time_count;                                // N
    double *time, *load_factor;                    // [N]
    double *kinetic, *elastic, *dissipated, *work; // [N]
    int probe_count;                               // P
    pdmc_probe_record *probes;                     // [P]
    double *displacement;                          // [N, P, 2] length
} pdmc_motion_record;

/// An end of a crack, as an explicit study follows it.
typedef struct {
    char name[PDMC_LONG_NAME_SIZE]; // "<crack>.from" or "<crack>.to"
    double position[2];             // at the start, length
    double direction[2];            // of straight-ahead growth, a unit vector
} pdmc_followed_tip;

typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    double radius, mass; // infinite: it keeps its velocity
} pdmc_sphere_record;

typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
} pdmc_body_record;

typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    int kind; // pdmc_condition_kind
} pdmc_condition_record;

typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    double bonds; // at the start, without cracks
} pdmc_interface_record;

/// The motion of an explicit study, or the states of rest of a quasi-static one: N records, T tips, S spheres, C conditions, I interfaces, n nodes, K snapshots. Without errors of the
/// second order in the step, kinetic + elastic + fracture + contact + dissipated = first + work.
typedef struct {
    int dimension;
    double spacing, horizon, step, stable_step, steps, bonds; // bonds: pairs at the start, without cracks
    double tip_damage, speed_window;
    char *kernel; // that computed the forces
    char *stop;   // why it stopped, where the status is PDMC_RUN_NOT_FINITE or _NO_REST; "" or NULL otherwise

    int record_count;                                                    // N
    double *time, *kinetic, *elastic, *contact, *fracture, *work;        // [N]
    double *dissipated;                                                  // [N] by damping, or where bonds broke at rest
    double *residual, *relaxation_steps, *breakages; // [N] of the loads of a quasi-static study, whose `time` is the load
    int compared_count;  // N in single precision, 0 in double precision
    double *force_error; // [compared_count] largest difference to forces in double precision, over the largest force
    double *momentum;                                                    // [N, 3] force time
    double *mean_damage, *broken;                                        // [N] broken: bonds, as numbers of the file
    double *fragments, *loose_nodes;                                     // [N] pieces of two nodes or more; single nodes
    double *largest_fragment;                                            // [N] mass
    double first;                                                        // kinetic energy at the start
    int tip_count;                                                       // T
    pdmc_followed_tip *tips;                                             // [T]
    double *tip_advance;                                                 // [N, T] length, beyond where it was at the start
    double *tip_speed;                                                   // [N, T] by central differences over the window
    int sphere_count;                                                    // S
    pdmc_sphere_record *spheres;                                         // [S]
    double *sphere_centre, *sphere_velocity;                             // [N, S, 3]
    double *sphere_force;                                                // [N, S, 3] of the nodes on it

    int condition_count;              // C
    pdmc_condition_record *conditions; // [C]
    double *condition_force;          // [N, C, 3] on all of its nodes
    double *condition_displacement;   // [N, C, 3] mean of its nodes

    int interface_count;               // I
    pdmc_interface_record *interfaces; // [I]
    double *interface_broken;          // [N, I] bonds, those cut by cracks included

    int body_count;
    pdmc_body_record *bodies; // [body_count]
    int node_count;           // n
    double *node_position;    // [n, 3] in the reference configuration
    int *node_body;           // [n]
    int snapshot_count;       // K
    double *snapshot_time;    // [K]
    int state_count;          // K n
    double *displacement, *velocity; // [K n, 3]
    double *damage;                  // [K n]
    int *fragment;                   // [K n] number of the piece that the node is in, from 0 by falling mass
    int fragment_count;              // F
    pdmc_fragment *fragment_list;    // [F] the pieces of the last snapshot
} pdmc_explicit_record;

/// What becomes of a tip: it never grows; it has stopped; it still grows when the time is over; or it has come through to the
/// edge of its body, within a horizon.
typedef enum {
    PDMC_OUTCOME_STILL,
    PDMC_OUTCOME_ARRESTED,
    PDMC_OUTCOME_RUNNING,
    PDMC_OUTCOME_THROUGH
} pdmc_outcome;
enum { PDMC_OUTCOMES = 4 };
extern PDMC_API const char *const pdmc_outcome_names[PDMC_OUTCOMES]; // "still", ...

/// The samples of an explicit study with random quantities, S of them; T tips, as in its record, which is of the study with
/// every quantity at its mean; X stations, Q = 3 quantiles, B bins. A sample that failed has NaN. Statistics are of those that
/// did not.
typedef struct {
    int sample_count, failed_count;
    int tip_count;                                              // T, or 0 where there are no samples
    uint8_t *failure;                                           // [S] pdmc_sample_failure
    double *load, *velocity, *youngs_modulus, *fracture_energy; // [S] factors that are the same everywhere
    double *fracture;                                           // [S] energy in the bonds at the moment they broke
    uint8_t *outcome;                                           // [S, T] pdmc_outcome
    double *growth, *begin, *mean_speed, *most_speed;           // [S, T] as pdmc_tip_growth
    double *end;                                                // [S, T, 2] where the path ends
    int station_count;                                          // X
    double *station; // [X] distances ahead of the end of the crack, along its direction
    double *path;    // [S, T, X] how far to the left of that the damage is, NaN beyond its end
    int condition_count;                  // C of a quasi-static study, 0 of one in motion
    double *largest_force, *load_of_force; // [S, C] of a condition, by its norm, and the load at which it is

    pdmc_estimate *share;                     // [T, 4] probability of each outcome; bounds count failed samples as both
    pdmc_estimate *mean_growth, *deviation;   // [T]
    pdmc_estimate *growth_quantiles;          // [T, Q]
    double *growth_edges;                     // [T, B + 1]
    int64_t *growth_counts;                   // [T, B + 2]
    pdmc_estimate *growth_density;            // [T, B]
    double *path_samples;                     // [T, X] samples whose path reaches the station
    pdmc_estimate *path_mean;                 // [T, X] over these
    pdmc_estimate *path_quantiles;            // [T, X, Q]
    pdmc_estimate *mean_force, *force_deviation; // [C] of the largest force
    pdmc_estimate *force_quantiles;              // [C, Q]
} pdmc_ensemble_results;
/// A scalar study's levels, N of them, each with half the spacing or half the horizon of the one before; and the field of
/// the last one, n values. The field has no unit. Roots of means of squares over the body.
typedef struct {
    int dimension;
    double power, wave_number; // of c(r) ~ r^-power; 1 / length, NaN where the study has loads of its own, and no wave
    int level_count;           // N
    double *spacing, *horizon;              // [N] length; spacing: the longest edge of an element
    double *elements, *unknowns, *entries;  // [N] as numbers of the file; entries: of the form
    double *error;          // [N] difference to the wave; without one to the level before, NaN at the first
    double *classical;      // [N] difference to classical elements on the same mesh; NaN where the spacing varies
    double *stable_step;    // [N] of central differences, length; NaN where nothing moves, as the next two
    double *stable_step_error; // [N] length, by the residual of the largest eigenvalue
    double *motion_error;   // [N] difference to the standing wave at the end, or to the level before
    double *drift;          // [N] of the energy over the largest kinetic one; NaN where no bonds with a law move
    double *iterations, *residual; // [N] of Newton's method, and what it left; NaN where bonds are linear
    double *steps;          // [N]
    double *seconds;        // [N] wall time
    int value_count;        // n
    double *position;       // [n, 2] length
    double *value, *wave;   // [n] the field; the wave, NaN where there is none
    double *moved;          // [n] at the end of the motion, NaN where nothing moves
} pdmc_scalar_record;
/// A rule for integrals over the horizon, with the slopes of the logarithm of its error: NaN where errors are rounding.
typedef struct {
    char name[PDMC_LONG_NAME_SIZE];
    double spacing_order, distance_order; // over the spacing, and over the distance of its points
} pdmc_rule_record;

/// What a study of quadrature has: R rules at K spacings.
typedef struct {
    int dimension;
    double horizon; // length
    int rule_count; // R
    pdmc_rule_record *rules; // [R]
    int ratio_count; // K
    double *ratio;   // [K] horizon / spacing
    double *error;   // [R, K] of the volume, over it; or of the stress, over its largest component
    double *points, *distance, *seconds; // [R, K] points, as numbers of the file; their distance, length; wall time
    double *stress;  // [R, K, 3, 3] force / length^2; NaN of a volume
    int state_count;      // 1 where the integral is a stress, 0 where it is the volume of the horizon
    double *exact_stress; // [state_count, 3, 3]
} pdmc_quadrature_record;

/// The rest of an elastic study: n nodes, L nodes on a line, E energies of damped motion.
typedef struct {
    double spacing, horizon, step; // step: of time, 0 without motion
    int axis;                      // of the line: 0, 1, 2
    int iterations;
    double residual; // norm of the free nodes' forces over that at the start; 0 of damped motion
    double energy;   // elastic, at the end
    int node_count;
    double *position, *displacement; // [n, 3] length
    double *compensation;            // [n] factor of a node's bonds
    int line_count;
    double *line_position, *line_displacement; // [L] length, along the longest direction next to the middle
    double *line_strain;                       // [L] to the node before; NaN at the first
    double *face_displacement, *face_force;    // [6, 3] mean of the outermost nodes; the whole force that holds or pulls
    int energy_count;
    double *time, *kinetic, *elastic; // [E]
} pdmc_elastic_record;

typedef struct {
    double assembly, factorisation, operators, energy_rows, sampling, energy, statistics, output, total; // wall seconds
    double reliability; // of rare growth and sensitivities; NaN in files that do not hold it
    double control;     // of the cheaper method's samples; NaN in files that do not hold it
    double motion; // of a dynamic study: the weak form and the time steps; of an explicit one the steps; of quadrature all rules
    double peak_memory; // largest resident memory of the process until then, bytes; NaN in files that do not hold it
    int threads;
} pdmc_runtime;

typedef struct {
    // the study
    pdmc_problem_kind kind; // a dynamic study has no tips, angles and samples; a static one has no motion; an explicit one, a
                            // scalar one and one of quadrature have nothing but texts, runtime and their own record
    char *title, *length_unit, *force_unit, *time_unit, *input, *resolved;
    uint64_t seed;
    char *date_and_time; // ISO 8601, UTC
    char *pdmc_version, *git_sha1; // of the program that computed the results
    char *mesh_generator; // what made or read the meshes, "Gmsh 4.8.4"; "" without
    pdmc_run_status status;
    double confidence; // level of every interval, 0.95
    double plate_width, plate_height, fracture_energy, extension, energy_horizon;
    pdmc_measure measure; // what direction and probability are computed from
    pdmc_bonds bonds;

    // the solution at the mean
    int crack_count;
    double *cracks; // [crack_count, 4] from x, y, to x, y
    int tip_count;  // T
    pdmc_tip *tips; // [T]
    int angle_count; // A
    double *angles;  // [A] rad
    double *nominal_bond_energy;         // [T, A] all bonds
    double *nominal_bond_energy_tensile; // [T, A] bonds in tension only
    double *nominal_griffith_energy;     // [T, A]
    pdmc_solver_report solver;
    pdmc_displacement_field field;

    pdmc_motion_record motion; // of a dynamic study
    pdmc_explicit_record particles; // of an explicit study
    pdmc_ensemble_results ensemble; // ... and of its samples, where it has random quantities
    pdmc_elastic_record elastic; // of an elastic study
    pdmc_scalar_record scalar;      // of a scalar study
    pdmc_quadrature_record quadrature; // of a study of quadrature

    // the samples
    int sample_count; // S
    int kept_count;   // N <= S, the first samples, of which c(r) and all energies are kept
    int failed_count;
    int bin_count;              // R, of c(r); 0 where the micromodulus is certain
    double *load_factor;        // [S]
    double *micromodulus;       // [N, R] c(r) / c_0 in each bin
    double *effective_modulus;  // [S] E_eff / E
    double *contraction;        // [S] measured factor of the Neumann expansion; NaN with direct solves
    pdmc_sample_accuracy accuracy;
    double *growth_given_rest;      // [S, T] P(the tip grows | all but the load); NaN where it is not known
    double *sample_fracture_energy; // [S, T] force / length
    uint8_t *failure;           // [S] pdmc_sample_failure
    uint8_t *sample_solver;     // [S] pdmc_sample_solver
    double *stress_intensity;   // [S, T, 2] K_I, K_II
    double *largest_energy[PDMC_MEASURES]; // each [S, T], by pdmc_measure; NaN where the sample failed
    double *energy[PDMC_MEASURES];         // each [N, T, A]

    // their statistics, over the samples that did not fail
    double replicates;  // of the design of samples, whose spread gives the intervals; 0 where samples are independent
    int histogram_bins; // B
    pdmc_energy_statistics statistics[PDMC_MEASURES];
    pdmc_estimate *direction;   // [T, A] share of the samples whose `measure` is largest at that angle
    pdmc_estimate *conditional_probability; // [T] the same with the load integrated analytically; NaN where it cannot be
    pdmc_reliability_results reliability;
    pdmc_control_results control;
    pdmc_estimate *probability; // [T] P(max over angles of `measure` > fracture_energy); bounds count failed samples
                                // as both, m / N and (m + failed) / N

    pdmc_runtime runtime;
} pdmc_results;

PDMC_API extern const char *const pdmc_measure_names[PDMC_MEASURES]; // "bond_energy", "griffith_energy"

/// How a tip has grown. Times are those of records.
typedef struct {
    double growth;                 // at the end
    double begin, end;             // the first record with any growth, and the first with all of it; NaN without growth
    double mean_speed, most_speed; // the former from begin to end: a tip moves by whole spacings; NaN without growth
} pdmc_tip_growth;

/// Reads it off the records.
PDMC_API pdmc_tip_growth pdmc_results_growth(const pdmc_explicit_record *record, int tip);

/// The record at which the force of a condition is largest, by its norm; 0 without records. @param[out] force  that norm, or
/// NULL
PDMC_API int pdmc_results_largest_force(const pdmc_explicit_record *record, int condition, double *force);

/// A bound of the force of a condition whose displacement is prescribed, between the loads too: the largest of F_i u_(i+1) / u_i.
/// Bonds that break make a body softer, so that from the state of rest i on the force is below the straight line through the
/// origin; of small displacements in proportion to one another. NaN of other conditions, and of one that does not move.
PDMC_API double pdmc_results_force_between(const pdmc_explicit_record *record, int condition);

/// What a number of the results is measured in, and so what its unit is made of.
typedef enum {
    PDMC_UNIT_NONE,             // 1
    PDMC_UNIT_ANGLE,            // rad
    PDMC_UNIT_TIME,             // s
    PDMC_UNIT_LENGTH,           // length
    PDMC_UNIT_STRESS,           // force / length^2
    PDMC_UNIT_STRESS_INTENSITY, // force / length^(3/2)
    PDMC_UNIT_ENERGY,           // force / length
    PDMC_UNIT_DENSITY,          // length / force, the probability density of an energy
    PDMC_UNIT_STUDY_TIME,       // time, in the study's unit
    PDMC_UNIT_WORK,             // force length
    PDMC_UNIT_BYTE,             // byte
    PDMC_UNIT_VELOCITY,         // length / time
    PDMC_UNIT_MASS,             // force time^2 / length
    PDMC_UNIT_MOMENTUM,         // force time
    PDMC_UNIT_FORCE,            // force
    PDMC_UNIT_PER_LENGTH,       // 1 / length
} pdmc_unit;
enum { PDMC_UNIT_SIZE = 160 }; // enough for any unit of a study whose own units have at most 64 characters

/// Writes a unit in the study's own units, e.g. "N/cm"; cut short at `size`, which counts the terminating zero.
PDMC_API void pdmc_results_unit(const pdmc_results *results, pdmc_unit unit, size_t size, char text[]);

/// Frees what the results own and sets them to zero; zeroed results are allowed.
PDMC_API void pdmc_results_clear(pdmc_results *results);

/// Writes a result file. It appears under its name only when it is whole: it is written to a temporary file in the same
/// folder, synced and renamed. The file is made in memory first. As HDF5 is built without threads, one thread at a time
/// may write or read.
/// Where results->runtime.output is NaN, the time that the making of the file took is written in its place.
/// @param[in] overwrite  false: an existing file is left alone and refused
/// @return PDMC_OK, PDMC_ERR_ARG (a missing array, counts that contradict each other), PDMC_ERR_CREATE (no permission,
/// no folder, it exists), PDMC_ERR_IO (disk full, ...), PDMC_ERR_EXTERN, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_results_write(const pdmc_results *results, const char *path, bool overwrite);

/// Reads a result file.
/// @param[out] results  free with pdmc_results_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_NO_INPUT, PDMC_ERR_DATA (not a result file, another major version, incomplete), or
/// PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_results_read(const char *path, pdmc_results *results);
