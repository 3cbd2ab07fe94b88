// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/layout.h"

#include <string.h>

#define MOTION "/motion/" // the group that only dynamic studies have
#define EXPLICIT "/explicit/" // ... and that only explicit and quasi-static ones have
#define REST EXPLICIT "rest/" // ... and only the latter
#define SPHERE_FORCE EXPLICIT "spheres/force"
#define INTERFACES EXPLICIT "interfaces/"
#define GENERATOR "mesh_generator"
#define CONDITION_KIND "conditions/kind"
#define SAMPLE_FORCE REST "samples/largest_force"
#define SCALAR "/scalar/" // ... and scalar ones
#define ELASTIC "/elastic/" // ... and elastic ones
#define QUADRATURE "/quadrature/" // ... and those of quadrature
#define PEAK_MEMORY "/runtime/peak_memory"
#define REPLICATES "/statistics/replicates"
#define FORCE_ERROR EXPLICIT "records/force_error"
#define GIVEN_REST "/samples/growth_given_rest"
#define CONDITIONAL "/statistics/conditional_probability"
#define FRACTURE_ENERGY "/samples/tip_fracture_energy"
#define SOLVER "/samples/solver"
#define LARGEST "/samples/largest_"
#define ACCURACY "/solver/samples/"
#define MEMBER(name) offsetof(pdmc_results, name)
#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

// clang-format off
// A row for each kind of place where numbers lie.
#define NUMBER(path, kind, name, unit, text)                                                                           \
    {path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(name), 0, 0, 1, {0}}
#define ARRAY(path, kind, type, name, unit, text, ...)                                                                 \
    {path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(name), sizeof(type), 0, 1, {__VA_ARGS__}}
#define REALS(path, name, unit, text, ...) ARRAY(path, REAL, double, name, unit, text, __VA_ARGS__)
#define TIPS(path, kind, name, unit, text, width, ...)                                                                 \
    {path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(tips), sizeof(pdmc_tip), offsetof(pdmc_tip, name),         \
     width, {PDMC_DIM_TIP, __VA_ARGS__}}
#define PROBES(path, kind, name, unit, text, width, ...)                                                               \
    {path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(motion.probes), sizeof(pdmc_probe_record),                 \
     offsetof(pdmc_probe_record, name), width, {PDMC_DIM_PROBE, __VA_ARGS__}}
#define HISTORY(name, unit, text) REALS(MOTION #name, motion.name, unit, text, PDMC_DIM_TIME)
#define ESTIMATES(path, name, unit, text, ...)                                                                         \
    {path, text, PDMC_KIND_REAL, PDMC_UNIT_##unit, MEMBER(name), sizeof(pdmc_estimate),                                \
     offsetof(pdmc_estimate, value), 1, {__VA_ARGS__}},                                                                \
    {path "_interval", "lower and upper bound at the file's confidence: " text, PDMC_KIND_REAL, PDMC_UNIT_##unit,      \
     MEMBER(name), sizeof(pdmc_estimate), offsetof(pdmc_estimate, lower), 2, {__VA_ARGS__, PDMC_DIM_BOUND}}
#define ENERGY_STATISTICS(group, which)                                                                                \
    ESTIMATES(group "/mean", statistics[which].mean, ENERGY, "mean", PDMC_DIM_TIP, PDMC_DIM_ANGLE),                    \
    ESTIMATES(group "/standard_deviation", statistics[which].standard_deviation, ENERGY, "standard deviation",         \
              PDMC_DIM_TIP, PDMC_DIM_ANGLE),                                                                           \
    ESTIMATES(group "/quantiles", statistics[which].quantiles, ENERGY,                                                 \
              "quantiles at the levels of /statistics", PDMC_DIM_TIP, PDMC_DIM_ANGLE, PDMC_DIM_QUANTILE),              \
    REALS(group "/histogram_edges", statistics[which].histogram_edges, ENERGY, "edges of the histogram's bins",        \
          PDMC_DIM_TIP, PDMC_DIM_ANGLE, PDMC_DIM_EDGE),                                                                \
    ARRAY(group "/histogram_counts", INT64, int64_t, statistics[which].histogram_counts, NONE,                         \
          "samples below the first edge, in each bin, and above the last edge", PDMC_DIM_TIP, PDMC_DIM_ANGLE,          \
          PDMC_DIM_BIN_AND_OUTSIDE),                                                                                   \
    ESTIMATES(group "/density", statistics[which].density, DENSITY, "probability density in each bin", PDMC_DIM_TIP,   \
              PDMC_DIM_ANGLE, PDMC_DIM_BIN)
#define MODEL_ERROR(name, member, what)                                                                                \
    NUMBER(ACCURACY name, REAL, accuracy.member, NONE,                                                                 \
           "largest shift of the " what " in any direction by the reduced model, over the mean of the largest energy")
#define MODEL_ERRORS(measure, which)                                                                                   \
    MODEL_ERROR(measure "_mean_error", mean_error[which], "mean"),                                                     \
    MODEL_ERROR(measure "_low_quantile_error", quantile_error[which][0], "5 % quantile"),                              \
    MODEL_ERROR(measure "_median_error", quantile_error[which][1], "median"),                                          \
    MODEL_ERROR(measure "_high_quantile_error", quantile_error[which][2], "95 % quantile")
#define CONTROL "/control/"
#define RELIABILITY "/reliability/"
#define METHOD(path, kind, name, unit, text, width, ...)                                                               \
    {RELIABILITY "methods/" path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(reliability.records),               \
     sizeof(pdmc_reliability_record), offsetof(pdmc_reliability_record, name), width, {PDMC_DIM_METHOD, __VA_ARGS__}}
#define GROUP(path, kind, name, unit, text, width, ...)                                                                \
    {RELIABILITY "quantities/" path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(reliability.groups),             \
     sizeof(pdmc_reliability_group), offsetof(pdmc_reliability_group, name), width, {PDMC_DIM_GROUP, __VA_ARGS__}}
#define RECORD(name, unit, text) REALS(EXPLICIT "records/" #name, particles.name, unit, text, PDMC_DIM_RECORD)
#define OF_LIST(path, kind, list, type, name, unit, text, width, dimension, ...)                                       \
    {EXPLICIT path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(particles.list), sizeof(type),                    \
     offsetof(type, name), width, {dimension, __VA_ARGS__}}
#define FOLLOWED(path, kind, name, unit, text, width, ...)                                                             \
    OF_LIST("tips/" path, kind, tips, pdmc_followed_tip, name, unit, text, width, PDMC_DIM_FOLLOWED_TIP, __VA_ARGS__)
#define SPHERE(path, kind, name, unit, text)                                                                           \
    OF_LIST("spheres/" path, kind, spheres, pdmc_sphere_record, name, unit, text, 1, PDMC_DIM_SPHERE, PDMC_DIM_END)
#define FRAGMENT(path, kind, name, unit, text, width, ...)                                                             \
    OF_LIST("fragments/" path, kind, fragment_list, pdmc_fragment, name, unit, text, width, PDMC_DIM_FRAGMENT, __VA_ARGS__)
#define DRAWN(name, unit, text) REALS(EXPLICIT "samples/" #name, ensemble.name, unit, text, PDMC_DIM_DRAW)
#define OF_TIP(name, unit, text, ...)                                                                                  \
    REALS(EXPLICIT "samples/" #name, ensemble.name, unit, text, PDMC_DIM_DRAW, PDMC_DIM_DRAWN_TIP, __VA_ARGS__)
#define SUMMARY(name, unit, text, ...)                                                                                 \
    ESTIMATES(EXPLICIT "statistics/" #name, ensemble.name, unit, text, PDMC_DIM_DRAWN_TIP, __VA_ARGS__)
#define LEVEL(name, unit, text) REALS(SCALAR "levels/" #name, scalar.name, unit, text, PDMC_DIM_LEVEL)
#define RULE(path, kind, name, unit, text)                                                                             \
    {QUADRATURE "rules/" path, text, PDMC_KIND_##kind, PDMC_UNIT_##unit, MEMBER(quadrature.rules),                     \
     sizeof(pdmc_rule_record), offsetof(pdmc_rule_record, name), 1, {PDMC_DIM_RULE, PDMC_DIM_END}}
#define OF_RULES(name, unit, text)                                                                                     \
    REALS(QUADRATURE #name, quadrature.name, unit, text, PDMC_DIM_RULE, PDMC_DIM_RATIO)
#define SECONDS(name, text) NUMBER("/runtime/" #name, REAL, runtime.name, TIME, "wall time of " text)

// An axis is sized by the first dataset that has it, so each count comes with an array that holds little else.
const pdmc_dataset pdmc_datasets[] = {
    NUMBER("/plate/width", REAL, plate_width, LENGTH, "width of the plate, centred at the origin"),
    NUMBER("/plate/height", REAL, plate_height, LENGTH, "height of the plate, centred at the origin"),
    NUMBER("/plate/fracture_energy", REAL, fracture_energy, ENERGY, "fracture energy G_c of the material"),
    NUMBER("/plate/extension", REAL, extension, LENGTH, "distance from a tip to where bonds are counted"),
    NUMBER("/plate/energy_horizon", REAL, energy_horizon, LENGTH, "radius of the bonds that are counted"),
    REALS("/cracks", cracks, LENGTH, "from x, from y, to x, to y of each crack", PDMC_DIM_CRACK, PDMC_DIM_END_POINT),

    TIPS("/tips/name", NAME, name, NONE, "crack and end", 1, PDMC_DIM_END),
    TIPS("/tips/position", REAL, position, LENGTH, "position", 2, PDMC_DIM_COORDINATE),
    TIPS("/tips/direction", REAL, direction, ANGLE, "angle of straight-ahead growth", 1, PDMC_DIM_END),
    TIPS("/tips/stress_intensity", REAL, stress_intensity, STRESS_INTENSITY, "K_I and K_II at the mean", 2,
         PDMC_DIM_MODE),
    TIPS("/tips/t_stress", REAL, t_stress, STRESS, "T-stress at the mean", 1, PDMC_DIM_END),
    TIPS("/tips/stress_intensity_error", REAL, stress_intensity_error, STRESS_INTENSITY,
         "differences of K_I and K_II to a solution with 1.25 times the spacing", 2, PDMC_DIM_MODE),
    TIPS("/tips/t_stress_error", REAL, t_stress_error, STRESS,
         "difference of the T-stress to a solution with 1.25 times the spacing", 1, PDMC_DIM_END),
    REALS("/angles", angles, ANGLE, "directions of growth, from the x axis", PDMC_DIM_ANGLE),

    REALS("/nominal/bond_energy", nominal_bond_energy, ENERGY, "bond energy release rate at the mean, all bonds",
          PDMC_DIM_TIP, PDMC_DIM_ANGLE),
    REALS("/nominal/bond_energy_tensile", nominal_bond_energy_tensile, ENERGY,
          "bond energy release rate at the mean, bonds in tension only", PDMC_DIM_TIP, PDMC_DIM_ANGLE),
    REALS("/nominal/griffith_energy", nominal_griffith_energy, ENERGY,
          "Griffith energy release rate of a small kink at the mean", PDMC_DIM_TIP, PDMC_DIM_ANGLE),

    NUMBER("/solver/nodes", INT, solver.nodes, NONE, "collocation nodes"),
    NUMBER("/solver/unknowns", INT, solver.unknowns, NONE, "unknowns"),
    NUMBER("/solver/rows", INT, solver.rows, NONE, "equations"),
    NUMBER("/solver/rank", INT, solver.rank, NONE, "numerical rank"),
    NUMBER("/solver/condition", REAL, solver.condition, NONE, "condition of the column-scaled mean operator"),
    NUMBER("/solver/residual", REAL, solver.residual, STRESS, "largest residual of an equation at the mean"),
    NUMBER("/solver/horizon", REAL, solver.horizon, LENGTH, "peridynamic horizon"),
    NUMBER("/solver/spacing", REAL, solver.spacing, LENGTH, "spacing of the nodes"),

    REALS("/field/node_position", field.node_position, LENGTH, "nodes", PDMC_DIM_NODE, PDMC_DIM_COORDINATE),
    REALS("/field/node_displacement", field.node_displacement, LENGTH, "displacement of the nodes at the mean",
          PDMC_DIM_NODE, PDMC_DIM_COORDINATE),
    REALS("/field/face_position", field.face_position, LENGTH, "points along each crack", PDMC_DIM_CRACK,
          PDMC_DIM_FACE_POINT, PDMC_DIM_COORDINATE),
    REALS("/field/face_displacement", field.face_displacement, LENGTH,
          "displacement at the mean of the faces to the left and right of each crack", PDMC_DIM_CRACK,
          PDMC_DIM_FACE_POINT, PDMC_DIM_FACE, PDMC_DIM_COORDINATE),

    HISTORY(time, STUDY_TIME, "times, the first is the start"),
    HISTORY(load_factor, NONE, "factor on the tractions"),
    HISTORY(kinetic, WORK, "kinetic energy of the plate"),
    HISTORY(elastic, WORK, "elastic energy of the plate"),
    HISTORY(dissipated, WORK, "energy that damping has taken"),
    HISTORY(work, WORK, "work that the tractions have done"),
    PROBES(MOTION "probe_name", NAME, name, NONE, "points that are watched", 1, PDMC_DIM_END),
    PROBES(MOTION "probe_position", REAL, position, LENGTH, "where they are at rest", 2, PDMC_DIM_COORDINATE),
    PROBES(MOTION "probe_face", INT, face, NONE, "of a crack: 0 none, 1 left, 2 right of from -> to", 1, PDMC_DIM_END),
    NUMBER(MOTION "seconds", REAL, runtime.motion, TIME, "wall time of the weak form and the time steps"),
    REALS(MOTION "displacement", motion.displacement, LENGTH, "displacement of the probes", PDMC_DIM_TIME,
          PDMC_DIM_PROBE, PDMC_DIM_COORDINATE),

    NUMBER(EXPLICIT "dimension", INT, particles.dimension, NONE, "of space"),
    NUMBER(EXPLICIT "spacing", REAL, particles.spacing, LENGTH, "spacing of the nodes"),
    NUMBER(EXPLICIT "horizon", REAL, particles.horizon, LENGTH, "length of the longest bond"),
    NUMBER(EXPLICIT "step", REAL, particles.step, STUDY_TIME, "step of time"),
    NUMBER(EXPLICIT "stable_step", REAL, particles.stable_step, STUDY_TIME, "largest stable step of small strain"),
    NUMBER(EXPLICIT "steps", REAL, particles.steps, NONE, "steps that were taken"),
    NUMBER(EXPLICIT "bonds", REAL, particles.bonds, NONE, "bonds at the start, those that cracks cut included"),
    NUMBER(EXPLICIT "tip_damage", REAL, particles.tip_damage, NONE, "damage of a node that a crack has reached"),
    NUMBER(EXPLICIT "speed_window", REAL, particles.speed_window, STUDY_TIME, "over which speeds of tips are taken"),
    NUMBER(EXPLICIT "seconds", REAL, runtime.motion, TIME, "wall time of the steps"),
    RECORD(time, STUDY_TIME, "time"),
    RECORD(kinetic, WORK, "kinetic energy"),
    RECORD(elastic, WORK, "energy of the bonds that hold"),
    RECORD(contact, WORK, "energy of contact"),
    RECORD(fracture, WORK, "energy of the bonds that broke, at that moment"),
    RECORD(work, WORK, "work of conditions and of spheres that keep their velocity"),
    RECORD(dissipated, WORK, "energy that damping took, or that was lost where bonds broke at rest"),
    RECORD(mean_damage, NONE, "mean over the nodes of the share of bonds that are broken"),
    RECORD(broken, NONE, "bonds that are broken, those that cracks cut included"),
    RECORD(fragments, NONE, "pieces of two nodes or more that bonds hold together"),
    RECORD(loose_nodes, NONE, "nodes without bonds"),
    RECORD(largest_fragment, MASS, "mass of the largest piece"),
    REALS(EXPLICIT "records/momentum", particles.momentum, MOMENTUM, "momentum of all nodes", PDMC_DIM_RECORD,
          PDMC_DIM_AXIS),
    REALS(FORCE_ERROR, particles.force_error, NONE,
          "of single precision: largest difference to forces in double precision, over the largest force", PDMC_DIM_COMPARED),
    REALS(REST "residual", particles.residual, NONE, "forces out of balance over the largest external ones, as norms",
          PDMC_DIM_RECORD),
    REALS(REST "relaxation_steps", particles.relaxation_steps, NONE, "steps of dynamic relaxation", PDMC_DIM_RECORD),
    REALS(REST "breakages", particles.breakages, NONE, "times that bonds broke before all was at rest", PDMC_DIM_RECORD),
    NUMBER(EXPLICIT "records/first_kinetic", REAL, particles.first, WORK, "kinetic energy at the start"),
    FOLLOWED("name", NAME, name, NONE, "crack and end", 1, PDMC_DIM_END),
    FOLLOWED("position", REAL, position, LENGTH, "where the crack ends at the start", 2, PDMC_DIM_COORDINATE),
    FOLLOWED("direction", REAL, direction, NONE, "of straight-ahead growth", 2, PDMC_DIM_COORDINATE),
    REALS(EXPLICIT "tips/advance", particles.tip_advance, LENGTH,
          "how much farther the tip is, along its direction, than at the start", PDMC_DIM_RECORD, PDMC_DIM_FOLLOWED_TIP),
    REALS(EXPLICIT "tips/speed", particles.tip_speed, VELOCITY, "by central differences over the window",
          PDMC_DIM_RECORD, PDMC_DIM_FOLLOWED_TIP),
    SPHERE("name", NAME, name, NONE, "rigid sphere"),
    SPHERE("radius", REAL, radius, LENGTH, "radius"),
    SPHERE("mass", REAL, mass, MASS, "mass, infinite where it keeps its velocity"),
    REALS(EXPLICIT "spheres/centre", particles.sphere_centre, LENGTH, "centre", PDMC_DIM_RECORD, PDMC_DIM_SPHERE,
          PDMC_DIM_AXIS),
    REALS(EXPLICIT "spheres/velocity", particles.sphere_velocity, VELOCITY, "velocity", PDMC_DIM_RECORD,
          PDMC_DIM_SPHERE, PDMC_DIM_AXIS),
    REALS(SPHERE_FORCE, particles.sphere_force, FORCE, "by which the nodes push it", PDMC_DIM_RECORD, PDMC_DIM_SPHERE,
          PDMC_DIM_AXIS),
    OF_LIST("conditions/name", NAME, conditions, pdmc_condition_record, name, NONE, "condition", 1, PDMC_DIM_CONDITION,
            PDMC_DIM_END),
    OF_LIST(CONDITION_KIND, INT, conditions, pdmc_condition_record, kind, NONE,
            "what is prescribed: 0 a velocity, 1 a force, 2 a displacement", 1, PDMC_DIM_CONDITION, PDMC_DIM_END),
    REALS(EXPLICIT "conditions/force", particles.condition_force, FORCE, "the whole force on its nodes", PDMC_DIM_RECORD,
          PDMC_DIM_CONDITION, PDMC_DIM_AXIS),
    REALS(EXPLICIT "conditions/displacement", particles.condition_displacement, LENGTH, "mean of its nodes",
          PDMC_DIM_RECORD, PDMC_DIM_CONDITION, PDMC_DIM_AXIS),
    OF_LIST("interfaces/name", NAME, interfaces, pdmc_interface_record, name, NONE, "interface", 1, PDMC_DIM_INTERFACE,
            PDMC_DIM_END),
    OF_LIST("interfaces/bonds", REAL, interfaces, pdmc_interface_record, bonds, NONE,
            "its bonds at the start, those that cracks cut included", 1, PDMC_DIM_INTERFACE, PDMC_DIM_END),
    REALS(INTERFACES "broken", particles.interface_broken, NONE, "its bonds that are broken", PDMC_DIM_RECORD,
          PDMC_DIM_INTERFACE),
    OF_LIST("bodies/name", NAME, bodies, pdmc_body_record, name, NONE, "body", 1, PDMC_DIM_BODY, PDMC_DIM_END),
    REALS(EXPLICIT "nodes/position", particles.node_position, LENGTH, "nodes in the reference configuration",
          PDMC_DIM_PARTICLE, PDMC_DIM_AXIS),
    ARRAY(EXPLICIT "nodes/body", INT, int, particles.node_body, NONE, "number of the body", PDMC_DIM_PARTICLE),
    REALS(EXPLICIT "snapshots/time", particles.snapshot_time, STUDY_TIME, "time", PDMC_DIM_SNAPSHOT),
    REALS(EXPLICIT "snapshots/damage", particles.damage, NONE,
          "share of the node's bonds that are broken; snapshot by snapshot all nodes", PDMC_DIM_STATE),
    REALS(EXPLICIT "snapshots/displacement", particles.displacement, LENGTH, "displacement, in the same order",
          PDMC_DIM_STATE, PDMC_DIM_AXIS),
    REALS(EXPLICIT "snapshots/velocity", particles.velocity, VELOCITY, "velocity, in the same order", PDMC_DIM_STATE,
          PDMC_DIM_AXIS),
    ARRAY(EXPLICIT "snapshots/fragment", INT, int, particles.fragment, NONE,
          "number of the piece the node is in, from 0 by falling mass, in the same order", PDMC_DIM_STATE),
    FRAGMENT("nodes", INT, nodes, NONE, "nodes of each piece of the last snapshot", 1, PDMC_DIM_END),
    FRAGMENT("mass", REAL, mass, MASS, "mass", 1, PDMC_DIM_END),
    FRAGMENT("centre", REAL, centre, LENGTH, "centre of mass", 3, PDMC_DIM_AXIS),
    FRAGMENT("velocity", REAL, velocity, VELOCITY, "velocity of the centre of mass", 3, PDMC_DIM_AXIS),

    ARRAY(EXPLICIT "samples/failure", BYTE, uint8_t, ensemble.failure, NONE,
          "0 where the sample is solved, 1 where a step could not be taken or no rest was found, 3 where a factor is not positive", PDMC_DIM_DRAW),
    DRAWN(load, NONE, "factor on all conditions"),
    DRAWN(velocity, NONE, "factor on the velocities at the start"),
    DRAWN(youngs_modulus, NONE, "factor on Young's modulus everywhere"),
    DRAWN(fracture_energy, NONE, "factor on the fracture energy everywhere"),
    DRAWN(fracture, WORK, "energy of the bonds that broke"),
    ARRAY(EXPLICIT "samples/outcome", BYTE, uint8_t, ensemble.outcome, NONE,
          "0 the tip never grew, 1 it has stopped, 2 it still grows, 3 it has come through", PDMC_DIM_DRAW,
          PDMC_DIM_DRAWN_TIP),
    OF_TIP(growth, LENGTH, "how much farther the tip is at the end than at the start", PDMC_DIM_END),
    OF_TIP(begin, STUDY_TIME, "first record with growth, NaN without any", PDMC_DIM_END),
    OF_TIP(mean_speed, VELOCITY, "from then to the first record with all of it, NaN without growth", PDMC_DIM_END),
    OF_TIP(most_speed, VELOCITY, "largest speed by central differences over the window", PDMC_DIM_END),
    OF_TIP(end, LENGTH, "where the path ends", PDMC_DIM_COORDINATE),
    REALS(EXPLICIT "statistics/station", ensemble.station, LENGTH, "distance ahead of the end of the crack",
          PDMC_DIM_STATION),
    OF_TIP(path, LENGTH, "how far to the left of the crack's line the damage is, NaN beyond its end", PDMC_DIM_STATION),
    SUMMARY(share, NONE, "probability of each outcome", PDMC_DIM_OUTCOME),
    ESTIMATES(EXPLICIT "statistics/mean_growth", ensemble.mean_growth, LENGTH, "mean growth", PDMC_DIM_DRAWN_TIP),
    ESTIMATES(EXPLICIT "statistics/deviation", ensemble.deviation, LENGTH, "standard deviation of the growth",
              PDMC_DIM_DRAWN_TIP),
    SUMMARY(growth_quantiles, LENGTH, "5, 50 and 95 % quantiles of the growth", PDMC_DIM_QUANTILE),
    REALS(EXPLICIT "statistics/growth_edges", ensemble.growth_edges, LENGTH, "edges of the histogram's bins",
          PDMC_DIM_DRAWN_TIP, PDMC_DIM_EDGE),
    ARRAY(EXPLICIT "statistics/growth_counts", INT64, int64_t, ensemble.growth_counts, NONE,
          "samples below the first edge, in each bin, and above the last edge", PDMC_DIM_DRAWN_TIP,
          PDMC_DIM_BIN_AND_OUTSIDE),
    SUMMARY(growth_density, PER_LENGTH, "probability density of the growth in each bin", PDMC_DIM_BIN),
    REALS(EXPLICIT "statistics/path_samples", ensemble.path_samples, NONE, "samples whose path reaches the station",
          PDMC_DIM_DRAWN_TIP, PDMC_DIM_STATION),
    SUMMARY(path_mean, LENGTH, "mean of these paths", PDMC_DIM_STATION),
    SUMMARY(path_quantiles, LENGTH, "5, 50 and 95 % quantiles of these paths", PDMC_DIM_STATION, PDMC_DIM_QUANTILE),
    REALS(SAMPLE_FORCE, ensemble.largest_force, FORCE, "largest force of each condition over the loads, as a norm",
          PDMC_DIM_DRAW, PDMC_DIM_DRAWN_CONDITION),
    REALS(SAMPLE_FORCE "_load", ensemble.load_of_force, NONE, "load at which it is", PDMC_DIM_DRAW, PDMC_DIM_DRAWN_CONDITION),
    ESTIMATES(SAMPLE_FORCE "_mean", ensemble.mean_force, FORCE, "mean of the largest force", PDMC_DIM_DRAWN_CONDITION),
    ESTIMATES(SAMPLE_FORCE "_deviation", ensemble.force_deviation, FORCE, "standard deviation of the largest force",
              PDMC_DIM_DRAWN_CONDITION),
    ESTIMATES(SAMPLE_FORCE "_quantiles", ensemble.force_quantiles, FORCE, "5, 50 and 95 % quantiles of the largest force",
              PDMC_DIM_DRAWN_CONDITION, PDMC_DIM_QUANTILE),
    NUMBER(SCALAR "dimension", INT, scalar.dimension, NONE, "of space"),
    NUMBER(SCALAR "power", REAL, scalar.power, NONE, "p of the kernel c(r) ~ r^-p"),
    NUMBER(SCALAR "wave_number", REAL, scalar.wave_number, NONE, "|k| of the wave, 1 / length, NaN without a wave"),
    LEVEL(spacing, LENGTH, "longest edge of an element"),
    LEVEL(horizon, LENGTH, "length of the longest bond"),
    LEVEL(elements, NONE, "elements, those of the layer included"),
    LEVEL(unknowns, NONE, "values that are free"),
    LEVEL(entries, NONE, "entries of the form, NaN where bonds have a law"),
    LEVEL(error, NONE, "root of the mean square difference to the wave, or without one to the level before"),
    LEVEL(classical, NONE, "... to classical elements on the same mesh, NaN where the spacing varies"),
    LEVEL(stable_step, LENGTH, "longest stable step of central differences, NaN where nothing moves"),
    LEVEL(stable_step_error, LENGTH, "... its error by the residual of the largest eigenvalue"),
    LEVEL(motion_error, NONE, "the same difference to the standing wave, or to the level before, at the end of the motion"),
    LEVEL(drift, NONE, "largest change of the energy over the largest kinetic one, NaN where no bonds with a law move"),
    LEVEL(iterations, NONE, "iterations of Newton's method, NaN where bonds are linear"),
    LEVEL(residual, NONE, "... and the residual that it left, over that of linear bonds at 0"),
    LEVEL(steps, NONE, "steps of the motion, NaN where nothing moves"),
    LEVEL(seconds, TIME, "wall time of the level"),
    REALS(SCALAR "values/position", scalar.position, LENGTH, "where each value of the last level is", PDMC_DIM_VALUE,
          PDMC_DIM_COORDINATE),
    REALS(SCALAR "values/field", scalar.value, NONE, "the steady field", PDMC_DIM_VALUE),
    REALS(SCALAR "values/wave", scalar.wave, NONE, "the wave, NaN without", PDMC_DIM_VALUE),
    REALS(SCALAR "values/moved", scalar.moved, NONE, "the field at the end of the motion, NaN without", PDMC_DIM_VALUE),

    NUMBER(ELASTIC "spacing", REAL, elastic.spacing, LENGTH, "spacing of the nodes"),
    NUMBER(ELASTIC "horizon", REAL, elastic.horizon, LENGTH, "length of the longest bond"),
    NUMBER(ELASTIC "step", REAL, elastic.step, STUDY_TIME, "step of time of damped motion, 0 without"),
    NUMBER(ELASTIC "iterations", INT, elastic.iterations, NONE, "iterations or steps to rest"),
    NUMBER(ELASTIC "residual", REAL, elastic.residual, NONE, "norm of the free nodes' forces over that at the start"),
    NUMBER(ELASTIC "seconds", REAL, runtime.motion, TIME, "wall time to rest"),
    NUMBER(ELASTIC "energy", REAL, elastic.energy, WORK, "elastic energy"),
    REALS(ELASTIC "nodes/position", elastic.position, LENGTH, "nodes in the reference configuration", PDMC_DIM_SOLID_NODE,
          PDMC_DIM_AXIS),
    REALS(ELASTIC "nodes/displacement", elastic.displacement, LENGTH, "displacement", PDMC_DIM_SOLID_NODE, PDMC_DIM_AXIS),
    REALS(ELASTIC "nodes/compensation", elastic.compensation, NONE, "factor of the node's bonds", PDMC_DIM_SOLID_NODE),
    NUMBER(ELASTIC "line/axis", INT, elastic.axis, NONE, "direction of the line, 0 for x"),
    REALS(ELASTIC "line/position", elastic.line_position, LENGTH, "along the line through the middle", PDMC_DIM_LINE),
    REALS(ELASTIC "line/displacement", elastic.line_displacement, LENGTH, "along the line", PDMC_DIM_LINE),
    REALS(ELASTIC "line/strain", elastic.line_strain, NONE, "to the node before", PDMC_DIM_LINE),
    REALS(ELASTIC "faces/displacement", elastic.face_displacement, LENGTH, "mean of the outermost nodes",
          PDMC_DIM_SOLID_FACE, PDMC_DIM_AXIS),
    REALS(ELASTIC "faces/force", elastic.face_force, FORCE, "the whole force that holds or pulls", PDMC_DIM_SOLID_FACE,
          PDMC_DIM_AXIS),
    REALS(ELASTIC "energies/time", elastic.time, STUDY_TIME, "time", PDMC_DIM_STEP),
    REALS(ELASTIC "energies/kinetic", elastic.kinetic, WORK, "in the middle of the step before", PDMC_DIM_STEP),
    REALS(ELASTIC "energies/elastic", elastic.elastic, WORK, "elastic energy", PDMC_DIM_STEP),

    REALS("/samples/load_factor", load_factor, NONE, "factor on the loads", PDMC_DIM_SAMPLE),
    REALS("/samples/micromodulus", micromodulus, NONE, "c(r) / c_0 in equal bins of [0, horizon]", PDMC_DIM_KEPT,
          PDMC_DIM_RADIAL_BIN),
    REALS("/samples/effective_modulus", effective_modulus, NONE, "effective over mean Young's modulus",
          PDMC_DIM_SAMPLE),
    REALS("/samples/contraction", contraction, NONE, "measured factor of the Neumann expansion, NaN with direct solves",
          PDMC_DIM_SAMPLE),
    NUMBER(ACCURACY "iteration_residual", REAL, accuracy.iteration_residual, NONE,
           "largest relative residual of conjugate gradients"),
    NUMBER(ACCURACY "reduced_unknowns", REAL, accuracy.reduced_unknowns, NONE, "unknowns of the reduced model"),
    NUMBER(ACCURACY "bond_energy_error", REAL, accuracy.energy_error[PDMC_MEASURE_BOND], NONE,
           "largest bound of the relative error of a sample's largest bond energy"),
    NUMBER(ACCURACY "bond_energy_typical_error", REAL, accuracy.typical_error[PDMC_MEASURE_BOND], NONE,
           "median of those bounds"),
    NUMBER(ACCURACY "griffith_energy_error", REAL, accuracy.energy_error[PDMC_MEASURE_GRIFFITH], NONE,
           "largest bound of the relative error of a sample's largest Griffith energy"),
    NUMBER(ACCURACY "griffith_energy_typical_error", REAL, accuracy.typical_error[PDMC_MEASURE_GRIFFITH], NONE,
           "median of those bounds"),
    NUMBER(ACCURACY "solved_in_full", REAL, accuracy.solved_in_full, NONE,
           "samples whose energy was too near to G_c for the reduced model"),
    MODEL_ERRORS("bond_energy", PDMC_MEASURE_BOND),
    MODEL_ERRORS("griffith_energy", PDMC_MEASURE_GRIFFITH),
    REALS(GIVEN_REST, growth_given_rest, NONE, "probability of growth given all but the load, NaN where it is not known",
          PDMC_DIM_SAMPLE, PDMC_DIM_TIP),
    REALS(FRACTURE_ENERGY, sample_fracture_energy, ENERGY, "fracture energy G_c", PDMC_DIM_SAMPLE, PDMC_DIM_TIP),
    ARRAY(SOLVER, BYTE, uint8_t, sample_solver, NONE,
          "0 as asked, 1 by conjugate gradients, 2 what the expansion stands for, 3 by its own factorisation",
          PDMC_DIM_SAMPLE),
    ARRAY("/samples/failure", BYTE, uint8_t, failure, NONE,
          "0 none, 1 the expansion does not contract, 2 singular system, 3 modulus or thickness not positive, 4 cracks that "
          "leave the plate, come too near, or cannot be discretised",
          PDMC_DIM_SAMPLE),
    REALS("/samples/stress_intensity", stress_intensity, STRESS_INTENSITY, "K_I and K_II", PDMC_DIM_SAMPLE,
          PDMC_DIM_TIP, PDMC_DIM_MODE),
    REALS(LARGEST "bond_energy", largest_energy[PDMC_MEASURE_BOND], ENERGY,
          "largest bond energy release rate, NaN where it failed", PDMC_DIM_SAMPLE, PDMC_DIM_TIP),
    REALS(LARGEST "griffith_energy", largest_energy[PDMC_MEASURE_GRIFFITH], ENERGY,
          "largest Griffith energy release rate of a small kink, NaN where it failed", PDMC_DIM_SAMPLE, PDMC_DIM_TIP),
    REALS("/samples/bond_energy", energy[PDMC_MEASURE_BOND], ENERGY, "bond energy release rate, NaN where it failed",
          PDMC_DIM_KEPT, PDMC_DIM_TIP, PDMC_DIM_ANGLE),
    REALS("/samples/griffith_energy", energy[PDMC_MEASURE_GRIFFITH], ENERGY,
          "Griffith energy release rate of a small kink, NaN where it failed", PDMC_DIM_KEPT, PDMC_DIM_TIP,
          PDMC_DIM_ANGLE),

    ENERGY_STATISTICS("/statistics/bond_energy", PDMC_MEASURE_BOND),
    ENERGY_STATISTICS("/statistics/griffith_energy", PDMC_MEASURE_GRIFFITH),
    ESTIMATES("/statistics/direction", direction, NONE, "share of samples whose energy is largest at the angle",
              PDMC_DIM_TIP, PDMC_DIM_ANGLE),
    ESTIMATES("/statistics/probability", probability, NONE, "probability that the largest energy exceeds G_c",
              PDMC_DIM_TIP),

    NUMBER(REPLICATES, REAL, replicates, NONE, "of the design of samples, 0 where samples are independent"),
    ESTIMATES(CONDITIONAL, conditional_probability, NONE,
              "the same with the load integrated analytically, NaN where it cannot be", PDMC_DIM_TIP),

    METHOD("name", NAME, name, NONE, "how the probability that any tip grows was found", 1, PDMC_DIM_END),
    METHOD("probability", REAL, found.probability.value, NONE, "probability that any tip grows", 1, PDMC_DIM_END),
    METHOD("probability_interval", REAL, found.probability.lower, NONE, "lower and upper bound at the file's confidence",
           2, PDMC_DIM_BOUND),
    METHOD("index", REAL, found.index.value, NONE, "reliability index -Phi^-1(P)", 1, PDMC_DIM_END),
    METHOD("index_interval", REAL, found.index.lower, NONE, "lower and upper bound at the file's confidence", 2,
           PDMC_DIM_BOUND),
    METHOD("variation", REAL, found.variation, NONE, "coefficient of variation of the probability", 1, PDMC_DIM_END),
    METHOD("effective_samples", REAL, found.effective_samples, NONE, "(sum x)^2 / sum x^2 of what is averaged", 1,
           PDMC_DIM_END),
    METHOD("largest_share", REAL, found.largest_share, NONE, "of a single weight or run", 1, PDMC_DIM_END),
    METHOD("evaluations", REAL, evaluations, NONE, "points that were solved", 1, PDMC_DIM_END),
    METHOD("failed", REAL, failed, NONE, "points that could not be solved", 1, PDMC_DIM_END),
    METHOD("complete", INT, complete, NONE, "1 where the variation that was asked for was met", 1, PDMC_DIM_END),
    GROUP("name", NAME, name, NONE, "random quantity", 1, PDMC_DIM_END),
    GROUP("variables", INT, variables, NONE, "normal variables behind it", 1, PDMC_DIM_END),
    GROUP("importance", REAL, importance, NONE, "its share of the squared direction to the design point", 1,
          PDMC_DIM_END),
    GROUP("first_index", REAL, first.value, NONE, "Sobol' index of the first order of log G / G_c", 1, PDMC_DIM_END),
    GROUP("first_index_interval", REAL, first.lower, NONE, "lower and upper bound at the file's confidence", 2,
          PDMC_DIM_BOUND),
    GROUP("total_index", REAL, total.value, NONE, "total Sobol' index of log G / G_c", 1, PDMC_DIM_END),
    GROUP("total_index_interval", REAL, total.lower, NONE, "lower and upper bound at the file's confidence", 2,
          PDMC_DIM_BOUND),
    REALS(RELIABILITY "design_point", reliability.design_point, NONE,
          "the normal variables, in the order of the quantities, where growth is likeliest", PDMC_DIM_VARIABLE),
    NUMBER(RELIABILITY "first_order_index", REAL, reliability.first_order_index, NONE, "distance of the design point"),
    NUMBER(RELIABILITY "first_order_probability", REAL, reliability.first_order_probability, NONE,
           "Phi of minus that distance"),
    NUMBER(RELIABILITY "first_order_evaluations", REAL, reliability.first_order_evaluations, NONE,
           "points that its search took"),
    NUMBER(RELIABILITY "solved_in_full", REAL, reliability.solved_in_full, NONE,
           "points too near to G_c for the reduced model"),
    NUMBER(RELIABILITY "seconds", REAL, runtime.reliability, TIME, "wall time of rare growth and sensitivities"),

    ESTIMATES(CONTROL "probability", control.probability, NONE,
              "probability that the largest energy exceeds G_c, with a cheaper method's samples as control",
              PDMC_DIM_CONTROLLED_TIP),
    REALS(CONTROL "probability_gain", control.probability_gain, NONE,
          "squared ratio of the interval's width without the control to that with it", PDMC_DIM_CONTROLLED_TIP),
    ESTIMATES(CONTROL "mean", control.mean, ENERGY,
              "mean of the energy that decides, with a cheaper method's samples as control", PDMC_DIM_CONTROLLED_TIP,
              PDMC_DIM_ANGLE),
    REALS(CONTROL "mean_gain", control.mean_gain, NONE, "variance of the mean without the control over that with it",
          PDMC_DIM_CONTROLLED_TIP, PDMC_DIM_ANGLE),
    REALS(CONTROL "correlation", control.correlation, NONE, "of the energies of both methods", PDMC_DIM_CONTROLLED_TIP,
          PDMC_DIM_ANGLE),
    NUMBER(CONTROL "samples", REAL, control.samples, NONE, "samples of the cheaper method"),
    NUMBER(CONTROL "failed", REAL, control.failed, NONE, "of these, samples that could not be solved"),
    NUMBER(CONTROL "advised_samples", REAL, control.advised_samples, NONE,
           "samples of the cheaper method that would give the narrowest intervals of means for the time"),
    NUMBER(CONTROL "seconds", REAL, runtime.control, TIME, "wall time of the cheaper method's samples"),

    NUMBER(QUADRATURE "dimension", INT, quadrature.dimension, NONE, "of space"),
    NUMBER(QUADRATURE "horizon", REAL, quadrature.horizon, LENGTH, "radius of the sphere or disc"),
    NUMBER(QUADRATURE "wall_time", REAL, runtime.motion, TIME, "wall time of all rules"),
    RULE("name", NAME, name, NONE, "rules for integrals over the horizon"),
    RULE("spacing_order", REAL, spacing_order, NONE, "slope of log error over log spacing"),
    RULE("distance_order", REAL, distance_order, NONE, "slope of log error over log distance of the points"),
    REALS(QUADRATURE "ratio", quadrature.ratio, NONE, "horizon over spacing", PDMC_DIM_RATIO),
    OF_RULES(error, NONE, "of the volume, over it, or of the stress, over its largest component"),
    OF_RULES(points, NONE, "integration points in the horizon, or in the half of it beyond a plane through the node"),
    OF_RULES(distance, LENGTH, "average distance between these points"),
    OF_RULES(seconds, TIME, "wall time"),
    REALS(QUADRATURE "stress", quadrature.stress, STRESS, "stress at the node", PDMC_DIM_RULE, PDMC_DIM_RATIO,
          PDMC_DIM_AXIS, PDMC_DIM_AXIS),
    REALS(QUADRATURE "exact_stress", quadrature.exact_stress, STRESS, "stress of the body",
          PDMC_DIM_STRESS_STATE, PDMC_DIM_AXIS, PDMC_DIM_AXIS),

    SECONDS(assembly, "the assembly of the mean operator"),
    SECONDS(factorisation, "its factorisation"),
    SECONDS(operators, "the operators of the uncertain micromodulus"),
    SECONDS(energy_rows, "the rows of the energy"),
    SECONDS(sampling, "the solutions of the samples"),
    SECONDS(energy, "the energies of the samples"),
    SECONDS(statistics, "the statistics"),
    SECONDS(output, "the output"),
    SECONDS(total, "the whole study"),
    NUMBER(PEAK_MEMORY, REAL, runtime.peak_memory, BYTE, "largest resident memory of the process that ran the study"),
};
const size_t pdmc_dataset_count = COUNT(pdmc_datasets);

const char *const pdmc_run_status_names[] = {
    [PDMC_RUN_COMPLETE] = "complete", [PDMC_RUN_INTERRUPTED] = "interrupted",
    [PDMC_RUN_TARGET_MET] = "target_met", [PDMC_RUN_SAMPLE_CAP] = "sample_cap",
    [PDMC_RUN_NOT_FINITE] = "not_finite", [PDMC_RUN_NO_REST] = "no_rest"};
static const char *const kind_names[] = {
    [PDMC_STATIC] = "static", [PDMC_DYNAMIC] = "dynamic", [PDMC_EXPLICIT] = "explicit",
    [PDMC_QUASI_STATIC] = "quasi_static", [PDMC_SCALAR] = "scalar", [PDMC_ELASTIC] = "elastic",
    [PDMC_QUADRATURE] = "quadrature"};
static const char *const bond_names[] = {[PDMC_BONDS_ALL] = "all", [PDMC_BONDS_TENSILE] = "tensile"};

#define ATTRIBUTE(object, kind, name, member) {object, name, PDMC_ATTRIBUTE_##kind, MEMBER(member), NULL, 0}
#define CHOICE(object, name, names) {object, #name, PDMC_ATTRIBUTE_CHOICE, MEMBER(name), names, (int)COUNT(names)}

const pdmc_attribute pdmc_attributes[] = {
    CHOICE("/", kind, kind_names),
    ATTRIBUTE("/", TEXT, "git_sha1", git_sha1),
    ATTRIBUTE("/", TEXT, "date_and_time", date_and_time),
    ATTRIBUTE("/", TEXT, "title", title),
    ATTRIBUTE("/", TEXT, GENERATOR, mesh_generator),
    ATTRIBUTE("/", DOCUMENT, "input", input),
    ATTRIBUTE("/", DOCUMENT, "resolved", resolved),
    ATTRIBUTE("/", TEXT, "length_unit", length_unit),
    ATTRIBUTE("/", TEXT, "force_unit", force_unit),
    ATTRIBUTE("/", TEXT, "time_unit", time_unit),
    ATTRIBUTE("/", SEED, "seed", seed),
    ATTRIBUTE("/", REAL, "confidence", confidence),
    ATTRIBUTE("/", INT, "threads", runtime.threads),
    ATTRIBUTE("/samples", INT, "failed_count", failed_count),
    CHOICE("/", status, pdmc_run_status_names),
    CHOICE("/plate", measure, pdmc_measure_names),
    CHOICE("/plate", bonds, bond_names),
    ATTRIBUTE(EXPLICIT, TEXT, "kernel", particles.kernel),
    ATTRIBUTE(EXPLICIT, TEXT, "stop", particles.stop),
    ATTRIBUTE(EXPLICIT, INT, "failed_count", ensemble.failed_count),
};
const size_t pdmc_attribute_count = COUNT(pdmc_attributes);
_Static_assert(sizeof(pdmc_run_status) == sizeof(int) && sizeof(pdmc_measure) == sizeof(int) &&
                   sizeof(pdmc_bonds) == sizeof(int) && sizeof(pdmc_problem_kind) == sizeof(int),
               "choices are read and written as int");

static const struct {
    const char *label;
    size_t member; // of a counted axis
    bool counted;
    int more; // a counted axis is this much longer than its field; a fixed one has this size
} dimensions[] = {
    [PDMC_DIM_CRACK] = {"crack", MEMBER(crack_count), true, 0},
    [PDMC_DIM_TIP] = {"tip", MEMBER(tip_count), true, 0},
    [PDMC_DIM_ANGLE] = {"angle", MEMBER(angle_count), true, 0},
    [PDMC_DIM_SAMPLE] = {"sample", MEMBER(sample_count), true, 0},
    [PDMC_DIM_KEPT] = {"kept sample", MEMBER(kept_count), true, 0},
    [PDMC_DIM_RADIAL_BIN] = {"radial bin", MEMBER(bin_count), true, 0},
    [PDMC_DIM_NODE] = {"node", MEMBER(field.node_count), true, 0},
    [PDMC_DIM_FACE_POINT] = {"point along the crack", MEMBER(field.face_points), true, 0},
    [PDMC_DIM_EDGE] = {"edge", MEMBER(histogram_bins), true, 1},
    [PDMC_DIM_BIN] = {"bin", MEMBER(histogram_bins), true, 0},
    [PDMC_DIM_BIN_AND_OUTSIDE] = {"underflow, bins, overflow", MEMBER(histogram_bins), true, 2},
    [PDMC_DIM_TIME] = {"time", MEMBER(motion.time_count), true, 0},
    [PDMC_DIM_PROBE] = {"probe", MEMBER(motion.probe_count), true, 0},
    [PDMC_DIM_METHOD] = {"method", MEMBER(reliability.record_count), true, 0},
    [PDMC_DIM_GROUP] = {"random quantity", MEMBER(reliability.group_count), true, 0},
    [PDMC_DIM_VARIABLE] = {"normal variable", MEMBER(reliability.variable_count), true, 0},
    [PDMC_DIM_RECORD] = {"record", MEMBER(particles.record_count), true, 0},
    [PDMC_DIM_COMPARED] = {"record", MEMBER(particles.compared_count), true, 0},
    [PDMC_DIM_FOLLOWED_TIP] = {"tip", MEMBER(particles.tip_count), true, 0},
    [PDMC_DIM_SPHERE] = {"sphere", MEMBER(particles.sphere_count), true, 0},
    [PDMC_DIM_CONDITION] = {"condition", MEMBER(particles.condition_count), true, 0},
    [PDMC_DIM_INTERFACE] = {"interface", MEMBER(particles.interface_count), true, 0},
    [PDMC_DIM_BODY] = {"body", MEMBER(particles.body_count), true, 0},
    [PDMC_DIM_PARTICLE] = {"node", MEMBER(particles.node_count), true, 0},
    [PDMC_DIM_SNAPSHOT] = {"snapshot", MEMBER(particles.snapshot_count), true, 0},
    [PDMC_DIM_STATE] = {"node of a snapshot", MEMBER(particles.state_count), true, 0},
    [PDMC_DIM_FRAGMENT] = {"piece", MEMBER(particles.fragment_count), true, 0},
    [PDMC_DIM_DRAW] = {"sample", MEMBER(ensemble.sample_count), true, 0},
    [PDMC_DIM_DRAWN_TIP] = {"tip", MEMBER(ensemble.tip_count), true, 0},
    [PDMC_DIM_DRAWN_CONDITION] = {"condition", MEMBER(ensemble.condition_count), true, 0},
    [PDMC_DIM_STATION] = {"station", MEMBER(ensemble.station_count), true, 0},
    [PDMC_DIM_OUTCOME] = {"still, arrested, running, through", 0, false, PDMC_OUTCOMES},
    [PDMC_DIM_LEVEL] = {"level", MEMBER(scalar.level_count), true, 0},
    [PDMC_DIM_VALUE] = {"value", MEMBER(scalar.value_count), true, 0},
    [PDMC_DIM_SOLID_NODE] = {"node", MEMBER(elastic.node_count), true, 0},
    [PDMC_DIM_LINE] = {"node of the line", MEMBER(elastic.line_count), true, 0},
    [PDMC_DIM_SOLID_FACE] = {"face: low and high in x, y, z", 0, false, 6},
    [PDMC_DIM_STEP] = {"step", MEMBER(elastic.energy_count), true, 0},
    [PDMC_DIM_RULE] = {"rule", MEMBER(quadrature.rule_count), true, 0},
    [PDMC_DIM_RATIO] = {"spacing", MEMBER(quadrature.ratio_count), true, 0},
    [PDMC_DIM_STRESS_STATE] = {"state of stress", MEMBER(quadrature.state_count), true, 0},
    [PDMC_DIM_AXIS] = {"x, y, z", 0, false, PDMC_AXES},
    [PDMC_DIM_CONTROLLED_TIP] = {"tip with a control", MEMBER(control.tip_count), true, 0},
    [PDMC_DIM_QUANTILE] = {"quantile level", 0, false, PDMC_QUANTILES},
    [PDMC_DIM_COORDINATE] = {"x, y", 0, false, 2},
    [PDMC_DIM_END_POINT] = {"from x, from y, to x, to y", 0, false, 4},
    [PDMC_DIM_MODE] = {"K_I, K_II", 0, false, 2},
    [PDMC_DIM_FACE] = {"left, right face", 0, false, 2},
    [PDMC_DIM_BOUND] = {"lower, upper", 0, false, 2},
};

// clang-format on

const char *pdmc_dimension_label(pdmc_dimension dimension)
{
    return dimensions[dimension].label;
}

int *pdmc_dimension_field(pdmc_results *results, pdmc_dimension dimension, int *more)
{
    *more = dimensions[dimension].more;
    return dimensions[dimension].counted ? (int *)((char *)results + dimensions[dimension].member) : NULL;
}

size_t pdmc_dimension_size(const pdmc_results *results, pdmc_dimension dimension)
{
    int count = 0;
    if (dimensions[dimension].counted)
        memcpy(&count, (const char *)results + dimensions[dimension].member, sizeof count);
    return (size_t)count + (size_t)dimensions[dimension].more;
}

static bool is_in(const char *path, const char *group)
{
    return strncmp(path, group, strlen(group)) == 0;
}

// The group that studies of a kind have instead of a plate's; NULL for those of plates.
static const char *group_of(pdmc_problem_kind kind)
{
    static const char *const groups[] = {[PDMC_EXPLICIT] = EXPLICIT, [PDMC_QUASI_STATIC] = EXPLICIT,
                                         [PDMC_SCALAR] = SCALAR, [PDMC_ELASTIC] = ELASTIC,
                                         [PDMC_QUADRATURE] = QUADRATURE};
    return groups[kind];
}

static bool is_of_plates(const char *path)
{
    return !is_in(path, EXPLICIT) && !is_in(path, SCALAR) && !is_in(path, ELASTIC) &&
           !is_in(path, QUADRATURE);
}

bool pdmc_dataset_belongs(const pdmc_results *results, const pdmc_dataset *dataset)
{
    if (is_in(dataset->path, REST) && results->kind != PDMC_QUASI_STATIC) return false;
    const char *group = group_of(results->kind);
    if (group) return is_in(dataset->path, group) || is_in(dataset->path, "/runtime/");
    return is_of_plates(dataset->path) && (results->kind == PDMC_DYNAMIC || !is_in(dataset->path, MOTION));
}

bool pdmc_attribute_belongs(const pdmc_results *results, const pdmc_attribute *attribute)
{
    if (strcmp(attribute->object, "/") == 0) return true;
    const char *group = group_of(results->kind);
    return group ? is_in(attribute->object, group) : is_of_plates(attribute->object);
}

bool pdmc_dataset_may_be_missing(const pdmc_dataset *dataset)
{
    // What files of earlier versions do not hold.
    static const char *const later[] = {PEAK_MEMORY, ACCURACY, FRACTURE_ENERGY, SOLVER, LARGEST, GIVEN_REST, SPHERE_FORCE, SAMPLE_FORCE, EXPLICIT CONDITION_KIND, CONDITIONAL, REPLICATES, CONTROL, RELIABILITY, FORCE_ERROR,
                                        INTERFACES};
    for (size_t i = 0; i < COUNT(later); i++)
        if (strncmp(dataset->path, later[i], strlen(later[i])) == 0) return true;
    return false;
}

bool pdmc_attribute_may_be_missing(const pdmc_attribute *attribute)
{
    return strcmp(attribute->name, GENERATOR) == 0;
}

size_t pdmc_dataset_rank(const pdmc_dataset *dataset)
{
    size_t rank = 0;
    while (dataset->axes[rank] != PDMC_DIM_END) rank++;
    return rank;
}

size_t pdmc_dataset_size(const pdmc_results *results, const pdmc_dataset *dataset)
{
    size_t size = 1;
    for (const pdmc_dimension *axis = dataset->axes; *axis != PDMC_DIM_END; axis++)
        size *= pdmc_dimension_size(results, *axis);
    return size;
}

size_t pdmc_kind_size(pdmc_kind kind)
{
    static const size_t sizes[] = {
        [PDMC_KIND_REAL] = sizeof(double),  [PDMC_KIND_INT] = sizeof(int),          [PDMC_KIND_INT64] = sizeof(int64_t),
        [PDMC_KIND_BYTE] = sizeof(uint8_t), [PDMC_KIND_NAME] = PDMC_LONG_NAME_SIZE,
    };
    return sizes[kind];
}

bool pdmc_dataset_is_packed(const pdmc_dataset *dataset)
{
    return dataset->stride == 0 || dataset->stride == dataset->width * pdmc_kind_size(dataset->kind);
}

void *pdmc_dataset_memory(const pdmc_results *results, const pdmc_dataset *dataset)
{
    char *place = (char *)results + dataset->member;
    if (dataset->stride == 0) return place;
    void *memory; // by memcpy, since the pointers have different types
    memcpy(&memory, place, sizeof memory);
    return memory;
}

void pdmc_dataset_set_memory(pdmc_results *results, const pdmc_dataset *dataset, void *memory)
{
    memcpy((char *)results + dataset->member, &memory, sizeof memory);
}

void pdmc_dataset_gather(const pdmc_dataset *dataset, size_t size, const void *structures, void *packed)
{
    const size_t bytes = dataset->width * pdmc_kind_size(dataset->kind);
    for (size_t i = 0; i < size / dataset->width; i++)
        memcpy((char *)packed + i * bytes, (const char *)structures + i * dataset->stride + dataset->column, bytes);
}

void pdmc_dataset_scatter(const pdmc_dataset *dataset, size_t size, const void *packed, void *structures)
{
    const size_t bytes = dataset->width * pdmc_kind_size(dataset->kind);
    for (size_t i = 0; i < size / dataset->width; i++)
        memcpy((char *)structures + i * dataset->stride + dataset->column, (const char *)packed + i * bytes, bytes);
}

char **pdmc_attribute_text(pdmc_results *results, const pdmc_attribute *attribute)
{
    const bool is_text = attribute->kind == PDMC_ATTRIBUTE_TEXT || attribute->kind == PDMC_ATTRIBUTE_DOCUMENT;
    return is_text ? (char **)((char *)results + attribute->member) : NULL;
}
