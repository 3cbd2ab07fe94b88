// SPDX-License-Identifier: GPL-3.0-or-later

/// The groups and lists of a study file, in the order of reading: to which kinds of study they belong, where lists are
/// kept, and what checks them as a whole.

#include "study/schema.h"

#define LIST(type, field, length)                                                                                      \
    .size = sizeof(type), .items = offsetof(pdmc_problem, field), .count = offsetof(pdmc_problem, length)
#define PARTICLE_LIST(type, field, length)                                                                             \
    .size = sizeof(type), .items = offsetof(pdmc_explicit, field), .count = offsetof(pdmc_explicit, length)
#define OF_SAMPLES .kinds = ONLY(PDMC_STATIC) | ONLY(PDMC_EXPLICIT) | ONLY(PDMC_QUASI_STATIC)
#define OF_PLATES .kinds = ONLY(PDMC_STATIC) | ONLY(PDMC_DYNAMIC)
#define OF_BODIES .kinds = ONLY(PDMC_EXPLICIT) | ONLY(PDMC_QUASI_STATIC)

const pdmc_study_section pdmc_study_sections[SECTIONS] = {
    [SECTION_TOP] = {.name = "", .doc = "the study as a whole"},
    [SECTION_UNITS] = {.name = "units", .doc = "of every number in the file, carried to all results"},
    [SECTION_PLATE] = {.name = "plate", .doc = "the rectangle, its middle at the origin", OF_PLATES},
    [SECTION_MATERIAL] = {.name = "material", .doc = "linear elastic; Poisson's ratio follows from the assumption",
                          OF_PLATES},
    [SECTION_CRACKS] = {.name = "cracks", .doc = "list of straight cracks inside the plate; tips are <name>.from, .to",
                        OF_PLATES, LIST(pdmc_crack, cracks, crack_count), .check = pdmc_study_check_cracks},
    [SECTION_LOADS] = {.name = "loads", .doc = "list of tractions on whole sides", OF_PLATES,
                       LIST(pdmc_load, loads, load_count)},
    [SECTION_SUPPORTS] = {.name = "supports", .doc = "list of sides with prescribed displacements", OF_PLATES,
                          LIST(pdmc_support, supports, support_count), .check = pdmc_study_check_loads},
    [SECTION_SOLVER] = {.name = "solver", .doc = "how the field is computed", OF_PLATES, .check = pdmc_study_check_solver},
    [SECTION_DYNAMICS] = {.name = "dynamics", .doc = "inertia, damping and time of a dynamic study", OF(PDMC_DYNAMIC),
                          .check = pdmc_study_check_dynamics},
    [SECTION_HISTORY] = {.name = "history", OF(PDMC_DYNAMIC),
                         .doc = "list of factors on all tractions of a dynamic study, linear in between; without it a "
                                "load that rises within the first step and stays",
                         LIST(pdmc_history_point, history, history_count), .check = pdmc_study_check_history},
    [SECTION_PROBES] = {.name = "probes", .doc = "list of points whose displacement a dynamic study records",
                        OF(PDMC_DYNAMIC), LIST(pdmc_probe, probes, probe_count), .check = pdmc_study_check_probes},
    [SECTION_RANDOM] = {.name = "random", .doc = "list of uncertain quantities; without it the study is deterministic",
                        LIST(pdmc_uncertainty, uncertainties, uncertainty_count), .check = pdmc_study_check_random,
                        OF_SAMPLES, .instead = "a dynamic study is deterministic for now"},
    [SECTION_CORRELATIONS] = {.name = "correlations", OF_SAMPLES,
                              .doc = "list of pairs of scalar quantities that depend on each other, by a Gaussian copula",
                              LIST(pdmc_correlation, correlations, correlation_count),
                              .check = pdmc_study_check_correlations},
    [SECTION_SAMPLING] = {.name = "sampling", .doc = "the Monte Carlo simulation", OF_SAMPLES,
                          .check = pdmc_study_check_sampling},
    [SECTION_RELIABILITY] = {.name = "reliability", OF(PDMC_STATIC), .check = pdmc_study_check_reliability,
                             .doc = "the probability that any tip grows, where it is rare, and what it comes from"},
    [SECTION_ENERGY] = {.name = "energy", .doc = "the energy release rates that are asked for",
                        OF(PDMC_STATIC), .check = pdmc_study_check_energy},
    [SECTION_CONTROL] = {.name = "control", OF(PDMC_STATIC), .check = pdmc_study_check_control,
                         .doc = "samples of a cheaper method with the same random numbers, by which those of the study know "
                                "means and P(G > G_c) better"},
    [SECTION_PARTICLE_GRID] = {.name = "grid", .doc = "of bodies of bonds: its nodes and how far their bonds reach",
                               OF_BODIES, .check = pdmc_study_check_particle_grid},
    [SECTION_PARTICLE_MATERIALS] = {.name = "materials", OF_BODIES,
                                    .doc = "of bodies of bonds: list of the bonds' laws, each with one of the moduli",
                                    PARTICLE_LIST(pdmc_explicit_material, materials, material_count),
                                    .check = pdmc_study_check_particle_materials},
    [SECTION_BODIES] = {.name = "bodies", OF_BODIES,
                        .doc = "of bodies of bonds: list of what is held together by bonds; they may touch, but not "
                               "overlap, and one that is inside another is a part of that",
                        PARTICLE_LIST(pdmc_explicit_body, bodies, body_count), .check = pdmc_study_check_bodies},
    [SECTION_INTERFACES] = {.name = "interfaces", OF_BODIES, .check = pdmc_study_check_interfaces,
                            .doc = "of bodies of bonds: list of bonds between two materials of a body with its parts, or between "
                                   "two bodies, which without it have none; one of bodies goes before one of materials",
                            PARTICLE_LIST(pdmc_explicit_interface, interfaces, interface_count)},
    [SECTION_PLANAR_CRACKS] = {.name = "cracks", OF_BODIES,
                               .doc = "of bodies of bonds: list of surfaces whose bonds are broken at the start; the "
                                      "tips of a segment, <name>.from and .to, are followed",
                               PARTICLE_LIST(pdmc_planar_crack, cracks, crack_count),
                               .check = pdmc_study_check_planar_cracks},
    [SECTION_CONDITIONS] = {.name = "conditions", OF_BODIES,
                            .doc = "of bodies of bonds: list of velocities, forces or displacements prescribed in layers "
                                   "of nodes",
                            PARTICLE_LIST(pdmc_explicit_condition, conditions, condition_count),
                            .check = pdmc_study_check_conditions},
    [SECTION_SPHERES] = {.name = "spheres", OF_BODIES,
                         .doc = "of bodies of bonds: list of rigid spheres without friction, discs in the plane",
                         PARTICLE_LIST(pdmc_explicit_sphere, spheres, sphere_count),
                         .check = pdmc_study_check_spheres},
    [SECTION_NO_FAIL] = {.name = "no_fail", OF_BODIES, .check = pdmc_study_check_no_fail,
                         .doc = "of bodies of bonds: list of zones; a bond whose nodes both lie in them never breaks",
                         PARTICLE_LIST(pdmc_shape, no_fail, no_fail_count)},
    [SECTION_CONTACT] = {.name = "contact", .doc = "of bodies of bonds: how nodes repel each other", OF_BODIES},
    [SECTION_DAMPING] = {.name = "damping", .doc = "of an explicit study: linear and viscous", OF(PDMC_EXPLICIT)},
    [SECTION_TIME] = {.name = "time", .doc = "of an explicit study: how long, in which steps", OF(PDMC_EXPLICIT),
                      .check = pdmc_study_check_time},
    [SECTION_LOADING] = {.name = "loading", OF(PDMC_QUASI_STATIC), .check = pdmc_study_check_loading,
                         .doc = "of a quasi-static study: loads from 0 on, each brought to rest by dynamic relaxation"},
    [SECTION_RECORD] = {.name = "record", .doc = "of bodies of bonds: what is kept", OF_BODIES,
                        .check = pdmc_study_check_record},
    [SECTION_DOMAIN] = {.name = "domain", OF(PDMC_SCALAR),
                        .doc = "of a scalar study: an interval or a rectangle, its middle at the origin, or the body of a "
                               "mesh; the field is prescribed in a layer round it as wide as the horizon, but for open sides"},
    [SECTION_KERNEL] = {.name = "kernel", OF(PDMC_SCALAR), .check = pdmc_study_check_kernel,
                        .doc = "of a scalar study: c(r) of L u = int c (u' - u), scaled so that long waves see the "
                               "Laplacian"},
    [SECTION_HOLES] = {.name = "holes", OF(PDMC_SCALAR), .size = sizeof(pdmc_hole), .items = offsetof(pdmc_scalar, holes),
                       .count = offsetof(pdmc_scalar, hole_count),
                       .doc = "of a scalar study: list of round holes in the rectangle, in which the field is prescribed"},
    [SECTION_ELEMENTS] = {.name = "elements", OF(PDMC_SCALAR), .check = pdmc_study_check_elements,
                          .doc = "of a scalar study: linear finite elements, intervals or triangles"},
    [SECTION_WAVE] = {.name = "wave", OF(PDMC_SCALAR), .check = pdmc_study_check_wave,
                      .doc = "of a scalar study: the solution sin(k.x + phase), whose source and values in the layer are given; or none"},
    [SECTION_SOURCE] = {.name = "source", OF(PDMC_SCALAR), .check = pdmc_study_check_source,
                        .doc = "of a scalar study without a wave: b in the body"},
    [SECTION_PRESCRIBED] = {.name = "prescribed", OF(PDMC_SCALAR), .check = pdmc_study_check_prescribed,
                            .doc = "of a scalar study without a wave: u in the layer"},
    [SECTION_OPEN] = {.name = "open_sides", OF(PDMC_SCALAR), .check = pdmc_study_check_open,
                      .doc = "of a scalar study without a wave: list of sides that have no layer",
                      .size = sizeof(pdmc_open_side), .items = offsetof(pdmc_scalar, open),
                      .count = offsetof(pdmc_scalar, open_count)},
    [SECTION_CONVERGENCE] = {.name = "convergence", OF(PDMC_SCALAR), .check = pdmc_study_check_convergence,
                             .doc = "of a scalar study: what is halved from level to level"},
    [SECTION_MARCH] = {.name = "motion", OF(PDMC_SCALAR), .check = pdmc_study_check_march,
                       .doc = "of a scalar study, by central differences: the wave standing and swinging; or from rest at 0 under a "
                            "sudden source"},
    [SECTION_SOLID] = {.name = "solid", OF(PDMC_ELASTIC), .check = pdmc_study_check_solid,
                       .doc = "of an elastic study: a box of nodes on a cubic grid, its middle at the origin; Poisson's ratio "
                              "is 1/4"},
    [SECTION_INTEGRATION] = {.name = "integration", OF(PDMC_ELASTIC), .check = pdmc_study_check_integration,
                             .doc = "of an elastic study: the integral over a node's horizon"},
    [SECTION_STRAIN] = {.name = "strain", OF(PDMC_ELASTIC),
                        .doc = "of an elastic study: the uniform strain whose displacement is prescribed in layers"},
    [SECTION_FACES] = {.name = "faces", OF(PDMC_ELASTIC),
                       .doc = "of an elastic study: list of faces that are held or pulled; the others are free",
                       .size = sizeof(pdmc_elastic_condition), .items = IN_ELASTIC(conditions),
                       .count = IN_ELASTIC(condition_count), .check = pdmc_study_check_faces_of_solid},
    [SECTION_REST] = {.name = "rest", OF(PDMC_ELASTIC), .doc = "of an elastic study: how it comes to rest"},
    [SECTION_QUADRATURE] = {.name = "quadrature", OF(PDMC_QUADRATURE), .check = pdmc_study_check_quadrature,
                            .doc = "what rules for integrals over the horizon of a node cost and give: cubic cells, 2, 3 and 4 "
                                   "Gauss points a side, exact volumes, and adaptive trapezoidal rules"},
};
