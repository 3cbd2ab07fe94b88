// SPDX-License-Identifier: GPL-3.0-or-later

/// The table of settings. Everything about a setting is said here and nowhere else: it is read, checked, defaulted,
/// written into the resolved study and described from its line.

#include "study/schema.h"

#include <math.h>

#define CHOICES(...) (const char *const[]) { __VA_ARGS__, NULL }
#define IN_PROBLEM(field) offsetof(pdmc_problem, field)
#define IN_MOTION(field) offsetof(pdmc_explicit, field)
#define IN_SCALAR(field) offsetof(pdmc_scalar, field)
#define IN_QUADRATURE(field) offsetof(pdmc_horizon_study, field)
#define FOR(bits) .solvers = (bits)
#define ANALYTIC ONLY(SOLVER_ANALYTIC)
#define PAPER ONLY(SOLVER_PAPER)
#define VISIBLE ONLY(SOLVER_VISIBLE)
#define BOND ONLY(SOLVER_BOND)
#define GALERKIN ONLY(SOLVER_GALERKIN)
#define WHERE(key, bits) .of = (key), .values = (bits)
#define PLANE ONLY(2)
#define BOX ONLY(PDMC_SHAPE_BOX)
#define CYLINDER ONLY(PDMC_SHAPE_CYLINDER)
#define BALL ONLY(PDMC_SHAPE_BALL)
#define NODES ONLY(PDMC_SHAPE_NODES)
#define MESH ONLY(PDMC_SHAPE_MESH)
#define SEGMENT ONLY(PDMC_CRACK_SEGMENT)
#define DISC ONLY(PDMC_CRACK_DISC)
#define RECTANGLE ONLY(PDMC_CRACK_RECTANGLE)
// Where a body is, or a condition acts.
#define SHAPE_OF(section, place, allowed, others)                                                                      \
    {section, "shape", KIND_CHOICE, .offset = place(kind), .choices = allowed, .fallback = "box",                      \
     .doc = "a box along the axes, a cylinder along one, a ball, which is a disc in the plane" others},                \
    {section, "from", KIND_VECTOR, UNIT_LENGTH, ANY, place(from), WHERE("shape", BOX | CYLINDER),                      \
     .doc = "lowest corner of a box, middle of one end of a cylinder"},                                                \
    {section, "to", KIND_VECTOR, UNIT_LENGTH, ANY, place(to), WHERE("shape", BOX | CYLINDER),                          \
     .doc = "highest corner of a box, middle of the other end of a cylinder"},                                         \
    {section, "centre", KIND_VECTOR, UNIT_LENGTH, ANY, place(centre), WHERE("shape", BALL), .doc = "of a ball"},       \
    {section, "radius", KIND_REAL, UNIT_LENGTH, POSITIVE, place(radius), WHERE("shape", CYLINDER | BALL),              \
     .doc = "of a cylinder or a ball"}
#define OF_BODY(field) offsetof(pdmc_explicit_body, body.shape.field)
#define OF_ZONE(field) offsetof(pdmc_shape, field)
#define OF_LAYER(field) offsetof(pdmc_explicit_condition, layer.region.field)
#define COMPONENT(key, axis)                                                                                           \
    {SECTION_CONDITIONS, key, KIND_OPTIONAL, .range = ANY,                                                             \
     .offset = offsetof(pdmc_explicit_condition, layer.value[axis]),                                                   \
     .flag = offsetof(pdmc_explicit_condition, layer.along[axis]), .fallback = "free",                                 \
     .doc = "component in " key ", a velocity, a force on a unit of volume, or a displacement"}
#define GRADIENT(key, axis)                                                                                            \
    {SECTION_CONDITIONS, key "_gradient", KIND_VECTOR, .range = ANY,                                                   \
     .offset = offsetof(pdmc_explicit_condition, layer.gradient[axis]), .fallback = "zero",                            \
     .doc = "by which the component in " key " grows with the node's position, from the origin on"}
#define STRESS ONLY(PDMC_INTEGRAL_STRESS)
#define STRESS_COMPONENT(key, component)                                                                               \
    {SECTION_QUADRATURE, key, KIND_REAL, UNIT_STRESS, ANY, IN_QUADRATURE(stress[component]), .fallback = "0.0",          \
     WHERE("integral", STRESS), .doc = "component of the stress in the infinite body"}
#define MODULUS(key, field, its_unit, text)                                                                            \
    {SECTION_PARTICLE_MATERIALS, key, KIND_OPTIONAL, its_unit, POSITIVE, offsetof(pdmc_explicit_material, field),      \
     .flag = offsetof(pdmc_explicit_material, has_##field), .fallback = "none", .doc = text}
#define OF_INTERFACE(key, field, its_unit, text)                                                                       \
    {SECTION_INTERFACES, key, KIND_OPTIONAL, its_unit, POSITIVE, offsetof(pdmc_explicit_interface, bonds.field),       \
     .flag = offsetof(pdmc_explicit_interface, bonds.has_##field), .fallback = "none", .doc = text}
#define SIDE(key, field, its_kind, bits)                                                                               \
    {SECTION_INTERFACES, key, its_kind, .offset = offsetof(pdmc_explicit_interface, field), WHERE("between", bits),    \
     .doc = "on one side"}
#define MATERIALS ONLY(PDMC_BETWEEN_MATERIALS)
#define BODIES ONLY(PDMC_BETWEEN_BODIES)
#define MICROMODULUS ONLY(PDMC_QUANTITY_MICROMODULUS)
#define STIFFNESS ONLY(PDMC_QUANTITY_STIFFNESS)
#define NOISE (15U * ONLY(PDMC_QUANTITY_LOAD_NOISE_LEFT)) // of the four sides
#define FUNCTION (MICROMODULUS | STIFFNESS | NOISE)
#define SCALAR (~FUNCTION)
#define CORRELATED (FUNCTION | ONLY(PDMC_QUANTITY_FRACTURE_ENERGY)) // in space
#define OF_CRACK (~(ONLY(PDMC_FIRST_OF_CRACK) - 1U))
#define OF_LAW(key, id, allowed, text)                                                                                 \
    {SECTION_RANDOM, key, KIND_OPTIONAL, .range = allowed, .offset = offsetof(pdmc_uncertainty, given.value[id]),       \
     .flag = offsetof(pdmc_uncertainty, given.has[id]), .quantities = SCALAR, .fallback = "none", .doc = text}
#define ANY {-INFINITY, INFINITY, false, false}
#define POSITIVE {0.0, INFINITY, true, false}
#define NOT_NEGATIVE {0.0, INFINITY, false, false}
#define FROM_TO(low, high) {(low), (high), false, false}
#define ABOVE_TO(low, high) {(low), (high), true, false}

// In the order of the enumerations in pdmc/problem.h.
#define STUDY_KINDS CHOICES("static", "dynamic", "explicit", "quasi_static", "scalar", "elastic", "quadrature")
#define ASSUMPTIONS CHOICES("plane_stress", "plane_strain")
#define SIDES CHOICES("left", "right", "bottom", "top")
#define FACES CHOICES("none", "left", "right")
#define QUANTITIES                                                                                                     \
    CHOICES("micromodulus", "stiffness", "load_noise_left", "load_noise_right", "load_noise_bottom", "load_noise_top",     \
            "load", "youngs_modulus", "fracture_energy", "thickness", "velocity", "bond_strength", "load_left",             \
            "load_right", "load_bottom", "load_top", "load_direction_left", "load_direction_right", "load_direction_bottom", "load_direction_top",      \
            "crack_length", "crack_angle", "crack_x", "crack_y")
#define RADIAL_MODELS CHOICES("radial_noise", "radial_process")
#define COVARIANCES CHOICES("exponential", "gaussian", "matern")
#define DISTRIBUTIONS                                                                                                  \
    CHOICES("normal", "lognormal", "weibull", "gumbel", "gamma", "beta", "uniform", "triangular", "empirical")
#define METHODS CHOICES("kansa", "bond", "galerkin")
#define AREAS CHOICES("full", "partial", "exact", "centroid")
#define MICROMODULI CHOICES("averaged", "at_nodes")
#define SWITCH CHOICES("off", "on")
#define STENCILS CHOICES("imq", "polyharmonic")
#define INVERSES CHOICES("direct", "neumann", "krylov", "reduced")
#define DESIGNS CHOICES("monte_carlo", "latin_hypercube", "sobol")
#define TARGETS CHOICES("none", "mean", "quantile", "probability")
#define RARE_METHODS CHOICES("none", "importance", "subset", "both")
#define LINES CHOICES("point", "segment")
#define BONDS CHOICES("all", "tensile")
#define MEASURES CHOICES("bond", "griffith")
#define VOLUMES CHOICES("whole", "partial", "tapered")
#define STRETCHES CHOICES("full", "linear")
#define PRECISIONS CHOICES("double", "single")
#define SHARES CHOICES("elements", "voronoi")
#define SHAPES CHOICES("box", "cylinder", "ball")
#define BODY_SHAPES CHOICES("box", "cylinder", "ball", "nodes", "mesh")
#define BETWEEN CHOICES("materials", "bodies")
#define PLANAR_CRACKS CHOICES("segment", "disc", "rectangle")
#define SPACES CHOICES("continuous", "discontinuous", "mixed")
#define MIXED ONLY(PDMC_SPACE_MIXED)
#define ELEMENT_MESHES CHOICES("cells", "triangles", "file")
#define CELLS ONLY(PDMC_ELEMENTS_CELLS)
#define TRIANGLES ONLY(PDMC_ELEMENTS_TRIANGLES)
#define MESH_FILE ONLY(PDMC_ELEMENTS_FILE)
#define LAWS CHOICES("linear", "saturating", "stiffening", "softening")
#define BENT (ONLY(PDMC_LAW_SATURATING) | ONLY(PDMC_LAW_STIFFENING) | ONLY(PDMC_LAW_SOFTENING))
#define GIVENS CHOICES("constant", "polynomial", "table")
#define GIVEN(section, field)                                                                                          \
    {section, "kind", KIND_CHOICE, .offset = IN_SCALAR(field.kind), .choices = GIVENS, .fallback = "constant",         \
     .doc = "of function; a table is linear or bilinear between its points"},                                          \
    {section, "value", KIND_REAL, .range = ANY, .offset = IN_SCALAR(field.value),                                      \
     WHERE("kind", ONLY(PDMC_GIVEN_CONSTANT)), .fallback = "0.0", .doc = "of a constant"},                             \
    {section, "coefficients", KIND_REALS, .range = ANY, .offset = IN_SCALAR(field.coefficients),                       \
     .flag = IN_SCALAR(field.coefficient_count), WHERE("kind", ONLY(PDMC_GIVEN_POLYNOMIAL)),                           \
     .doc = "of 1, x, x^2, ... in one dimension, of 1, x, y, x^2, x y, y^2, x^3, ... in two"},                         \
    {section, "file", KIND_TEXT, .offset = IN_SCALAR(field.file), WHERE("kind", ONLY(PDMC_GIVEN_TABLE)),               \
     .doc = "of lines \"x value\", or \"x y value\" of a grid; beside the study file unless its path is absolute"}
#define OUTER_RULES CHOICES("exact", "gauss", "edges")
#define INNER_RULES CHOICES("exact", "polynomial", "careless")
#define SOLID_RULES CHOICES("cubic_cell", "gauss")
#define GAUSS ONLY(PDMC_SOLID_GAUSS)
#define COMPENSATIONS CHOICES("none", "sum", "exact")
#define SOLID_FACES CHOICES("x_low", "x_high", "y_low", "y_high", "z_low", "z_high")
#define WAYS_TO_REST CHOICES("static", "relaxation", "damped")
#define DAMPED ONLY(PDMC_ELASTIC_DAMPED)
#define RELAXATION ONLY(PDMC_ELASTIC_RELAXATION)
#define STRAIN(key, k, text)                                                                                           \
    {SECTION_STRAIN, key, KIND_REAL, .range = ANY, .offset = IN_ELASTIC(strain[k]), .fallback = "0.0", .doc = text}
#define PULL(direction, k)                                                                                             \
    {SECTION_FACES, "traction_" direction, KIND_REAL, UNIT_STRESS, ANY,                                                \
     offsetof(pdmc_elastic_condition, load.traction[k]), .fallback = "0.0",                                            \
     .doc = "force in " direction " on a unit of the face"},                                                           \
    {SECTION_FACES, "gradient_" direction, KIND_REAL, UNIT_PER_LENGTH, ANY,                                            \
     offsetof(pdmc_elastic_condition, load.gradient[k]), .fallback = "0.0",                                            \
     .doc = "the traction times 1 + gradient . position, along the face"}
#define INTEGRALS CHOICES("volume", "stress")
#define PROFILES CHOICES("constant", "cone", "bell")
#define CONDITIONS CHOICES("velocity", "force", "displacement")

const pdmc_study_setting pdmc_study_settings[] = {
    {SECTION_TOP, "kind", KIND_CHOICE, .offset = IN_PROBLEM(kind), .choices = STUDY_KINDS, .fallback = "static",
     .doc = "equilibrium and energy release rates; motion under a history of the load; motion with growing cracks, "
            "impact and contact; growing cracks under loads so slow that bodies are at rest; a scalar field by finite "
            "elements, refined from level to level; the rest of an elastic box in space; "
            "or a comparison of rules for integrals over the horizon"},
    {SECTION_TOP, "title", KIND_TEXT, .offset = IN_PROBLEM(title), .fallback = "untitled",
     .doc = "what the study is about, for headings"},
    {SECTION_TOP, "seed", KIND_SEED, .range = NOT_NEGATIVE, .offset = IN_PROBLEM(sampling.seed), .fallback = "1",
     .doc = "of the random numbers; the same seed gives the same samples"},

    {SECTION_UNITS, "length", KIND_TEXT, .offset = IN_PROBLEM(length_unit), .fallback = "m", .doc = "name of the unit"},
    {SECTION_UNITS, "force", KIND_TEXT, .offset = IN_PROBLEM(force_unit), .fallback = "N", .doc = "name of the unit"},
    {SECTION_UNITS, "time", KIND_TEXT, .offset = IN_PROBLEM(time_unit), .fallback = "s",
     .doc = "name of the unit, of dynamic and explicit studies"},

    {SECTION_PLATE, "width", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(plate.width), .doc = "extent in x"},
    {SECTION_PLATE, "height", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(plate.height), .doc = "extent in y"},
    {SECTION_PLATE, "thickness", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(plate.thickness), .fallback = "1.0",
     .doc = "extent out of the plane"},

    {SECTION_MATERIAL, "youngs_modulus", KIND_REAL, UNIT_STRESS, POSITIVE, IN_PROBLEM(material.youngs_modulus),
     .doc = "Young's modulus E"},
    {SECTION_MATERIAL, "assumption", KIND_CHOICE, .offset = IN_PROBLEM(material.assumption), .choices = ASSUMPTIONS,
     .fallback = "plane_stress", .doc = "Poisson's ratio is 1/3 in plane stress, 1/4 in plane strain"},
    {SECTION_MATERIAL, "fracture_energy", KIND_REAL, UNIT_LINE_FORCE, POSITIVE, IN_PROBLEM(material.fracture_energy),
     .doc = "critical energy release rate G_c"},

    {SECTION_CRACKS, "name", KIND_NAME, .offset = offsetof(pdmc_crack, name), .fallback = "crack1, crack2, ...",
     .doc = "each name once"},
    {SECTION_CRACKS, "from", KIND_PAIR, UNIT_LENGTH, ANY, offsetof(pdmc_crack, from), .doc = "one tip, [x, y]"},
    {SECTION_CRACKS, "to", KIND_PAIR, UNIT_LENGTH, ANY, offsetof(pdmc_crack, to), .doc = "the other tip, [x, y]"},

    {SECTION_LOADS, "side", KIND_CHOICE, .offset = offsetof(pdmc_load, side), .choices = SIDES,
     .doc = "each side once"},
    {SECTION_LOADS, "traction", KIND_PAIR, UNIT_STRESS, ANY, offsetof(pdmc_load, traction),
     .doc = "force on an area of the side, [x, y]"},

    {SECTION_SUPPORTS, "side", KIND_CHOICE, .offset = offsetof(pdmc_support, side), .choices = SIDES,
     .doc = "each component of a side once"},
    {SECTION_SUPPORTS, "x", KIND_OPTIONAL, UNIT_LENGTH, ANY, offsetof(pdmc_support, displacement[0]),
     .flag = offsetof(pdmc_support, held[0]), .fallback = "free", .doc = "prescribed displacement in x"},
    {SECTION_SUPPORTS, "y", KIND_OPTIONAL, UNIT_LENGTH, ANY, offsetof(pdmc_support, displacement[1]),
     .flag = offsetof(pdmc_support, held[1]), .fallback = "free", .doc = "prescribed displacement in y"},

    {SECTION_SOLVER, "method", KIND_CHOICE, .offset = IN_PROBLEM(solver.method), .choices = METHODS,
     .fallback = "kansa", .doc = "collocation, a grid of nodes and their bonds, or finite elements of bonds that cracks cut exactly"},
    {SECTION_SOLVER, "crack_model", KIND_CHOICE, .offset = IN_PROBLEM(solver.crack_model),
     .choices = CHOICES("analytic", "paper", "visible"), .fallback = "analytic", FOR(ANALYTIC | PAPER | VISIBLE),
     .doc = "analytic fields, the local limit; the recipe of Evangelatos & Spanos, which does not converge; or visible "
            "nodes, bonds of the horizon that cracks cut"},
    {SECTION_SOLVER, "spacing", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(solver.spacing),
     .derive = pdmc_study_default_spacing, .fallback = "min(width, height) / 20, / 100 of the bond method, / 80 of finite elements",
     .doc = "h of the nodes, of finite elements the longest side of a cell; unknowns grow as 1/h^2, the cost of the dense collocation as 1/h^6"},
    {SECTION_SOLVER, "horizon_ratio", KIND_OPTIONAL, .range = FROM_TO(1.0, 100.0),
     .offset = IN_PROBLEM(solver.horizon_ratio), .flag = IN_PROBLEM(solver.has_horizon_ratio), .fallback = "none",
     FOR(BOND | GALERKIN), .doc = "the horizon in spacings, instead of its length"},
    {SECTION_SOLVER, "horizon", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(solver.horizon),
     .derive = pdmc_study_default_horizon, .fallback = "min(a / 5, width / 50, height / 50), 5 spacing of the bond method, 4 spacing of finite elements",
     .doc = "length of the longest bond; a: half of the shortest crack"},
    {SECTION_SOLVER, "shape", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(solver.shape),
     .derive = pdmc_study_default_shape, .fallback = "6 spacing, 0.16 spacing of the paper's cracks", FOR(ANALYTIC | PAPER),
     .doc = "psi of the inverse multiquadric"},
    {SECTION_SOLVER, "polynomial_degree", KIND_INT, .range = FROM_TO(0, 6),
     .offset = IN_PROBLEM(solver.polynomial_degree), .fallback = "3", FOR(ANALYTIC), .doc = "of the appended monomials"},
    {SECTION_SOLVER, "crack_orders", KIND_INT, .range = FROM_TO(1, 20), .offset = IN_PROBLEM(solver.crack_orders),
     .fallback = "6", FOR(ANALYTIC), .doc = "orders of the analytic crack fields"},
    {SECTION_SOLVER, "radial_points", KIND_INT, .range = FROM_TO(3, 12), .offset = IN_PROBLEM(solver.radial_points),
     .fallback = "6", FOR(ANALYTIC), .doc = "rings on which the operator is sampled for a random c(r)"},
    {SECTION_SOLVER, "tip_functions", KIND_CHOICE, .offset = IN_PROBLEM(solver.tip_functions), .choices = SWITCH,
     .fallback = "on", FOR(PAPER), .doc = "the four functions of eq. 38 at every tip"},
    {SECTION_SOLVER, "edge_layer", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(solver.edge_layer),
     .derive = pdmc_study_default_edge_layer, .fallback = "horizon / 5", FOR(PAPER),
     .doc = "thickness e of the layer that tractions act on, as forces sigma / e"},
    {SECTION_SOLVER, "refinement", KIND_INT, .range = FROM_TO(2, 16), .offset = IN_PROBLEM(solver.refinement),
     .fallback = "6", FOR(VISIBLE), .doc = "nodes a horizon near cracks"},
    {SECTION_SOLVER, "stencil", KIND_CHOICE, .offset = IN_PROBLEM(solver.stencil), .choices = STENCILS, .fallback = "imq",
     FOR(VISIBLE), .doc = "radial function between visible nodes: inverse multiquadric, or r^3"},
    {SECTION_SOLVER, "area", KIND_CHOICE, .offset = IN_PROBLEM(solver.area), .choices = AREAS, .fallback = "exact",
     FOR(BOND), .doc = "of a cell that the edge of the horizon cuts: all of it if its middle is inside, a linear share, "
                       "the exact area, or that with the bond to its centroid"},
    {SECTION_SOLVER, "surface_correction", KIND_CHOICE, .offset = IN_PROBLEM(solver.surface_correction),
     .choices = SWITCH, .fallback = "off", FOR(BOND),
     .doc = "stiffer bonds near edges, by the isotropic energy of those missing there; too stiff in uniaxial tension"},
    {SECTION_SOLVER, "micromodulus", KIND_CHOICE, .offset = IN_PROBLEM(solver.micromodulus), .choices = MICROMODULI,
     .fallback = "averaged", FOR(BOND),
     .doc = "a random c(r) of a bond to a cell: averaged over the cell, or at its node"},
    {SECTION_SOLVER, "load_layer", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(solver.load_layer),
     .derive = pdmc_study_default_load_layer, .fallback = "spacing, of finite elements the horizon", FOR(BOND | GALERKIN),
     .doc = "thickness of the layer, inside the plate, that a traction is spread over"},
    {SECTION_SOLVER, "space", KIND_CHOICE, .offset = IN_PROBLEM(solver.space), .choices = SPACES, .fallback = "continuous",
     FOR(GALERKIN), .doc = "linear triangles, continuous but for cracks; each with values of its own; or so within a horizon of cracks"},
    {SECTION_SOLVER, "mesh", KIND_CHOICE, .offset = IN_PROBLEM(solver.mesh), .choices = CHOICES("cells", "triangles"),
     .fallback = "cells", FOR(GALERKIN),
     .doc = "two triangles a cell, between lines to which cracks are parallel; or triangles by Gmsh, for cracks at any angle"},
    {SECTION_SOLVER, "outer_parts", KIND_INT, .range = FROM_TO(1, 8), .offset = IN_PROBLEM(solver.outer_parts),
     .fallback = "1", FOR(GALERKIN), .doc = "of each side of an element, with seven points of the outer integral in every one"},

    {SECTION_DYNAMICS, "density", KIND_REAL, UNIT_MASS_DENSITY, POSITIVE, IN_PROBLEM(dynamics.density),
     .doc = "mass of a unit of volume"},
    {SECTION_DYNAMICS, "damping", KIND_REAL, UNIT_RATE, NOT_NEGATIVE, IN_PROBLEM(dynamics.damping), .fallback = "0.0",
     .doc = "d of a force -density d u' on every point"},
    {SECTION_DYNAMICS, "step", KIND_REAL, UNIT_TIME, POSITIVE, IN_PROBLEM(dynamics.step),
     .derive = pdmc_study_default_step, .fallback = "spacing / (4 c), c of pressure waves",
     .doc = "of time; any is stable, the error falls as its square"},
    {SECTION_DYNAMICS, "duration", KIND_REAL, UNIT_TIME, POSITIVE, IN_PROBLEM(dynamics.duration),
     .doc = "reached by whole steps"},

    {SECTION_HISTORY, "time", KIND_REAL, UNIT_TIME, NOT_NEGATIVE, offsetof(pdmc_history_point, time),
     .doc = "ascending"},
    {SECTION_HISTORY, "factor", KIND_REAL, .range = ANY, .offset = offsetof(pdmc_history_point, factor),
     .doc = "on all tractions from then on, linear to the next"},

    {SECTION_PROBES, "name", KIND_NAME, .offset = offsetof(pdmc_probe, name), .fallback = "probe1, probe2, ...",
     .doc = "each name once"},
    {SECTION_PROBES, "at", KIND_PAIR, UNIT_LENGTH, ANY, offsetof(pdmc_probe, at), .doc = "point of the plate, [x, y]"},
    {SECTION_PROBES, "side", KIND_CHOICE, .offset = offsetof(pdmc_probe, face), .choices = FACES, .fallback = "none",
     .doc = "of a point on a crack: the face left or right of from -> to"},

    {SECTION_RANDOM, "quantity", KIND_CHOICE, .offset = offsetof(pdmc_uncertainty, quantity), .choices = QUANTITIES,
     .doc = "what is uncertain, each quantity once; the load is one factor on all tractions, load_top one on that of a side, "
            "load_direction_top turns that by degrees, counter-clockwise, load_noise_top is a normal process along the side by "
            "which it varies; stiffness is a field in space, and with a correlation_length so is the fracture_energy, of which every tip sees its own "
            "value; a crack is as long as crack_length, turned about its middle by crack_angle in degrees, and shifted by crack_x "
            "and crack_y: every sample is then discretised anew; of bodies of bonds there are stiffness, fracture_energy "
            "(with a correlation_length a field of x and y), youngs_modulus, load (on all conditions, and on the way of spheres at rest), velocity (of bodies and "
            "spheres at the start of an explicit study) and bond_strength (of every bond by itself), all of them factors of mean 1"},
    {SECTION_RANDOM, "crack", KIND_CRACK, .offset = offsetof(pdmc_uncertainty, crack), .quantities = OF_CRACK,
     .fallback = "the first crack", .doc = "that a length, an angle or a shift is of"},
    {SECTION_RANDOM, "model", KIND_CHOICE, .offset = offsetof(pdmc_uncertainty, model), .choices = RADIAL_MODELS,
     .quantities = MICROMODULUS, .fallback = "radial_noise",
     .doc = "normal c(r) in each bin of [0, horizon], independent or correlated over r"},
    {SECTION_RANDOM, "bins", KIND_INT, .range = FROM_TO(1, 10000), .offset = offsetof(pdmc_uncertainty, bins),
     .quantities = MICROMODULUS, .fallback = "100",
     .doc = "a physical input: the scatter of the effective modulus falls as 1/sqrt(bins)"},
    {SECTION_RANDOM, "distribution", KIND_CHOICE, .offset = offsetof(pdmc_uncertainty, distribution),
     .choices = DISTRIBUTIONS, .quantities = SCALAR | STIFFNESS, .fallback = "normal",
     .doc = "of the quantity; of a stiffness normal or lognormal at every point"},
    {SECTION_RANDOM, "covariance", KIND_CHOICE, .offset = offsetof(pdmc_uncertainty, covariance.kind),
     .choices = COVARIANCES, .quantities = CORRELATED, .fallback = "exponential",
     .doc = "exp(-r/l), exp(-r^2/l^2), or Matern's, of a field, of noise along a side, or of a radial process; that of a fracture "
            "energy is of the normal variables behind it, and of what it does not share with correlated quantities"},
    {SECTION_RANDOM, "correlation_length", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE,
     offsetof(pdmc_uncertainty, covariance.length), offsetof(pdmc_uncertainty, has_length),
     .quantities = CORRELATED, .fallback = "none",
     .doc = "l of the covariance; without it a fracture energy is the same at all tips"},
    {SECTION_RANDOM, "smoothness", KIND_OPTIONAL, .range = FROM_TO(0.05, 20.0),
     .offset = offsetof(pdmc_uncertainty, covariance.smoothness), .flag = offsetof(pdmc_uncertainty, has_smoothness),
     .quantities = CORRELATED, .fallback = "none", .doc = "nu of Matern's covariance"},
    {SECTION_RANDOM, "modes", KIND_INT, .range = FROM_TO(1, 2000), .offset = offsetof(pdmc_uncertainty, modes),
     .quantities = FUNCTION, .fallback = "50",
     .doc = "normal variables of the expansion of a field, of noise along a side, or of a radial process"},
    {SECTION_RANDOM, "variation", KIND_OPTIONAL, .range = NOT_NEGATIVE,
     .offset = offsetof(pdmc_uncertainty, given.value[PDMC_PARAMETER_VARIATION]),
     .flag = offsetof(pdmc_uncertainty, given.has[PDMC_PARAMETER_VARIATION]),
     .fallback = "0.20 where no other parameter is given",
     .doc = "coefficient of variation; of a function at a point"},
    OF_LAW("mean", PDMC_PARAMETER_MEAN, ANY, "in the quantity's unit; default that of plate, material, crack; 1 of loads"),
    OF_LAW("median", PDMC_PARAMETER_MEDIAN, POSITIVE, "of a lognormal, with log_deviation"),
    OF_LAW("log_deviation", PDMC_PARAMETER_LOG_DEVIATION, NOT_NEGATIVE, "standard deviation of a lognormal's logarithm"),
    OF_LAW("location", PDMC_PARAMETER_LOCATION, ANY, "of a normal its mean, of a Gumbel its mode"),
    OF_LAW("scale", PDMC_PARAMETER_SCALE, NOT_NEGATIVE, "of a normal its standard deviation; Weibull, Gumbel, gamma"),
    OF_LAW("shape", PDMC_PARAMETER_SHAPE, POSITIVE, "of a Weibull or gamma"),
    OF_LAW("lower", PDMC_PARAMETER_LOWER, ANY, "end of a beta, uniform or triangular"),
    OF_LAW("mode", PDMC_PARAMETER_MODE, ANY, "of a triangular"),
    OF_LAW("upper", PDMC_PARAMETER_UPPER, ANY, "end of a beta, uniform or triangular"),
    OF_LAW("alpha", PDMC_PARAMETER_ALPHA, POSITIVE, "of a beta"),
    OF_LAW("beta", PDMC_PARAMETER_BETA, POSITIVE, "of a beta"),
    OF_LAW("least", PDMC_PARAMETER_LEAST, ANY, "cuts the distribution off below"),
    OF_LAW("most", PDMC_PARAMETER_MOST, ANY, "cuts the distribution off above"),
    {SECTION_RANDOM, "values", KIND_REALS, .range = ANY, .offset = offsetof(pdmc_uncertainty, values),
     .flag = offsetof(pdmc_uncertainty, value_count), .quantities = SCALAR, .fallback = "none",
     .doc = "[x1, x2, ...] of an empirical distribution, each as likely"},

    {SECTION_CORRELATIONS, "first", KIND_CHOICE, .offset = offsetof(pdmc_correlation, first), .choices = QUANTITIES,
     .doc = "a scalar quantity of random"},
    {SECTION_CORRELATIONS, "second", KIND_CHOICE, .offset = offsetof(pdmc_correlation, second), .choices = QUANTITIES,
     .doc = "another one"},
    {SECTION_CORRELATIONS, "correlation", KIND_REAL, .range = {-1.0, 1.0, true, true},
     .offset = offsetof(pdmc_correlation, correlation), .doc = "of the normal variables behind the two"},

    {SECTION_SAMPLING, "samples", KIND_INT, .range = FROM_TO(1, 100000000), .offset = IN_PROBLEM(sampling.samples),
     .fallback = "1000", .doc = "a smaller number is a prefix of a larger one, but for a Latin hypercube; the least, with a target"},
    {SECTION_SAMPLING, "target", KIND_CHOICE, OF(PDMC_STATIC), .offset = IN_PROBLEM(sampling.target), .choices = TARGETS, .fallback = "none",
     .doc = "what sampling goes on for until it is known at every tip: the mean or the 95 % quantile of the energy where the "
            "mean plate has its largest, or P(G > G_c)"},
    {SECTION_SAMPLING, "relative_error", KIND_REAL, OF(PDMC_STATIC), .range = ABOVE_TO(0.0, 1.0), .offset = IN_PROBLEM(sampling.relative_error),
     .fallback = "0.05", WHERE("target", ~ONLY(PDMC_TARGET_NONE)), .doc = "of the target: half the width of its interval over its value"},
    {SECTION_SAMPLING, "most_samples", KIND_INT, OF(PDMC_STATIC), .range = FROM_TO(1, 100000000), .offset = IN_PROBLEM(sampling.most_samples),
     .fallback = "1000000", WHERE("target", ~ONLY(PDMC_TARGET_NONE)), .doc = "at which sampling stops without it"},
    {SECTION_SAMPLING, "keep", KIND_INT, OF(PDMC_STATIC), .range = FROM_TO(1, 100000000), .offset = IN_PROBLEM(sampling.keep),
     .fallback = "20000",
     .doc = "independent samples of which the file has c(r) and the energies at every angle; the statistics are of all"},
    {SECTION_SAMPLING, "design", KIND_CHOICE, OF(PDMC_STATIC), .offset = IN_PROBLEM(sampling.design), .choices = DESIGNS,
     .fallback = "monte_carlo",
     .doc = "independent samples, or replicates of a Latin hypercube or of a scrambled Sobol' sequence, which need fewer"},
    {SECTION_SAMPLING, "replicates", KIND_INT, OF(PDMC_STATIC), .range = FROM_TO(3, 1024), .offset = IN_PROBLEM(sampling.replicates),
     .fallback = "16", WHERE("design", ~ONLY(PDMC_DESIGN_MONTE_CARLO)), .doc = "independent parts of a design, whose spread gives the intervals"},
    {SECTION_SAMPLING, "inverse", KIND_CHOICE, OF(PDMC_STATIC), .offset = IN_PROBLEM(sampling.inverse), .choices = INVERSES,
     .fallback = "neumann",
     .doc = "how each sample is solved: by its own factorisation; round that of the mean by the Neumann expansion or by "
            "conjugate gradients; or by a reduced model with a bound of its error"},
    {SECTION_SAMPLING, "order", KIND_INT, OF(PDMC_STATIC), .range = FROM_TO(0, 8), .offset = IN_PROBLEM(sampling.order), .fallback = "4",
     .doc = "of the Neumann expansion"},
    {SECTION_SAMPLING, "tolerance", KIND_REAL, OF(PDMC_STATIC), .range = ABOVE_TO(0.0, 0.1), .offset = IN_PROBLEM(sampling.tolerance),
     .fallback = "1e-8", .doc = "of the relative residual of inverse = \"krylov\""},
    {SECTION_SAMPLING, "energy_tolerance", KIND_REAL, OF(PDMC_STATIC), .range = ABOVE_TO(0.0, 0.1),
     .offset = IN_PROBLEM(sampling.energy_tolerance), .fallback = "1e-3",
     .doc = "of the relative error of a sample's largest energy, of inverse = \"reduced\""},

    {SECTION_RELIABILITY, "method", KIND_CHOICE, .offset = IN_PROBLEM(reliability.method), .choices = RARE_METHODS,
     .fallback = "none",
     .doc = "importance sampling at the design point, which is found first; subset simulation; or both, to compare"},
    {SECTION_RELIABILITY, "variation", KIND_REAL, .range = ABOVE_TO(0.0, 1.0), .offset = IN_PROBLEM(reliability.variation),
     .fallback = "0.05", .doc = "coefficient of variation of the probability at which sampling stops"},
    {SECTION_RELIABILITY, "evaluations", KIND_INT, .range = FROM_TO(1000, 1000000000),
     .offset = IN_PROBLEM(reliability.evaluations), .fallback = "1000000",
     .doc = "samples solved at most, of each method; but subset simulation takes some 8000 at least"},
    {SECTION_RELIABILITY, "sensitivity", KIND_INT, .range = FROM_TO(0, 10000000),
     .offset = IN_PROBLEM(reliability.sensitivity), .fallback = "0",
     .doc = "samples of the Sobol' indices of log G / G_c, each solved twice and once more for every quantity; 0 for none"},

    {SECTION_ENERGY, "tips", KIND_TIPS, .offset = NOT_STORED, .fallback = "all tips",
     .doc = "[\"<crack>.from\", \"<crack>.to\", ...]"},
    {SECTION_ENERGY, "angles", KIND_INT, .range = FROM_TO(4, 3600), .offset = IN_PROBLEM(energy.angles),
     .fallback = "72", .doc = "directions phi_k = 2 pi k / angles"},
    {SECTION_ENERGY, "horizon", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(energy.horizon),
     .derive = pdmc_study_default_energy_horizon, .fallback = "solver.horizon",
     .doc = "longest bond that is counted"},
    {SECTION_ENERGY, "extension", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(energy.extension),
     .derive = pdmc_study_default_extension, .fallback = "0.25 energy.horizon",
     .doc = "distance from the tip to the point where bonds cross"},
    {SECTION_ENERGY, "line", KIND_CHOICE, .offset = IN_PROBLEM(energy.line), .choices = LINES, .fallback = "point",
     FOR(ANALYTIC | PAPER | VISIBLE | GALERKIN),
     .doc = "bonds are counted that cross at the extension, or anywhere up to it, averaged as method = \"bond\" does"},
    {SECTION_ENERGY, "bonds", KIND_CHOICE, .offset = IN_PROBLEM(energy.bonds), .choices = BONDS, .fallback = "all",
     .doc = "whether bonds in compression count"},
    {SECTION_ENERGY, "measure", KIND_CHOICE, .offset = IN_PROBLEM(energy.measure), .choices = MEASURES,
     .fallback = "griffith", .doc = "what P(G > G_c) and the direction are computed from"},

    {SECTION_CONTROL, "samples", KIND_INT, .range = FROM_TO(0, 100000000), .offset = IN_PROBLEM(control.samples),
     .fallback = "0", .doc = "of the cheaper method, more than the study's own, which are the first of them; 0 for none"},
    {SECTION_CONTROL, "method", KIND_CHOICE, .offset = IN_PROBLEM(control.solver.method), .choices = METHODS,
     .fallback = "kansa", .doc = "the cheaper method, with the defaults of its solver, solved by the Neumann expansion"},
    {SECTION_CONTROL, "spacing", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_PROBLEM(control.solver.spacing),
     .derive = pdmc_study_default_control_spacing, .fallback = "that of the method, 2 solver.spacing if it is the study's own",
     .doc = "h of its nodes"},

    {SECTION_PARTICLE_GRID, "dimension", KIND_INT, .range = FROM_TO(2, 3), .offset = IN_MOTION(dimension),
     .doc = "of space"},
    {SECTION_PARTICLE_GRID, "spacing", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_MOTION(spacing),
     .doc = "of the nodes, which lie at whole multiples of it plus the offset"},
    {SECTION_PARTICLE_GRID, "offset", KIND_VECTOR, UNIT_LENGTH, ANY, IN_MOTION(offset), .fallback = "zero",
     .doc = "of the nodes; half a spacing puts them into the middles of cells that begin at the origin"},
    {SECTION_PARTICLE_GRID, "horizon_ratio", KIND_OPTIONAL, .range = FROM_TO(1.0, 20.0),
     .offset = IN_MOTION(horizon_ratio), .flag = IN_MOTION(has_horizon_ratio), .fallback = "3.0 without a horizon",
     .doc = "the horizon in spacings, instead of its length"},
    {SECTION_PARTICLE_GRID, "horizon", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_MOTION(horizon),
     .flag = IN_MOTION(has_horizon), .fallback = "horizon_ratio spacings", .doc = "length of the longest bond"},
    {SECTION_PARTICLE_GRID, "volume", KIND_CHOICE, .offset = IN_MOTION(volume_rule), .choices = VOLUMES,
     .fallback = "partial",
     .doc = "of a neighbour: whole inside the horizon; a share that falls from 1 to 0 over the spacing round it, whose sums "
            "converge; or that share with nothing beyond the horizon, as LAMMPS has it"},
    {SECTION_PARTICLE_GRID, "stretch", KIND_CHOICE, .offset = IN_MOTION(stretch), .choices = STRETCHES, .fallback = "full",
     .doc = "of bonds: by their length as it is, or eta . xi / |xi|^2 along the direction that they had at first, for small "
            "motions without turning"},
    {SECTION_PARTICLE_GRID, "precision", KIND_CHOICE, .offset = IN_MOTION(precision), .choices = PRECISIONS,
     .fallback = "double",
     .doc = "in which the forces of bonds are computed: single is faster, from displacements of 7 digits, and the results say by "
            "how much the forces differ; not in a quasi-static study"},
    {SECTION_PARTICLE_GRID, "thickness", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_MOTION(thickness), .fallback = "1.0",
     WHERE("dimension", PLANE), .doc = "extent out of the plane"},
    {SECTION_PARTICLE_GRID, "assumption", KIND_CHOICE, .offset = IN_MOTION(assumption), .choices = ASSUMPTIONS,
     .fallback = "plane_stress", WHERE("dimension", PLANE),
     .doc = "Poisson's ratio is 1/3 in plane stress, 1/4 in plane strain and in space"},

    {SECTION_PARTICLE_MATERIALS, "name", KIND_NAME, .offset = offsetof(pdmc_explicit_material, name),
     .fallback = "material1, material2, ...", .doc = "each name once"},
    {SECTION_PARTICLE_MATERIALS, "density", KIND_REAL, UNIT_MASS_DENSITY, POSITIVE,
     offsetof(pdmc_explicit_material, density), .doc = "mass of a unit of volume"},
    MODULUS("youngs_modulus", youngs_modulus, UNIT_STRESS, "Young's modulus E"),
    MODULUS("bulk_modulus", bulk_modulus, UNIT_STRESS, "k = E / (3 (1 - 2 nu)), instead of E"),
    MODULUS("micromodulus", micromodulus, UNIT_MICROMODULUS, "c of the bond force c s, instead of E"),
    MODULUS("fracture_energy", fracture_energy, UNIT_LINE_FORCE, "G_0; without it and s_0 bonds never break"),
    MODULUS("critical_stretch", critical_stretch, UNIT_NONE, "s_0 at which bonds break, instead of G_0"),
    {SECTION_PARTICLE_MATERIALS, "strengthening", KIND_REAL, .range = NOT_NEGATIVE,
     .offset = offsetof(pdmc_explicit_material, strengthening), .fallback = "0.0",
     .doc = "alpha of s_0 - alpha s_min, by which bonds of compressed nodes hold more"},
    {SECTION_PARTICLE_MATERIALS, "fibre", KIND_VECTOR, .range = ANY, .offset = offsetof(pdmc_explicit_material, fibre),
     .fallback = "zero", .doc = "direction of fibres, of any length; zero for none"},
    {SECTION_PARTICLE_MATERIALS, "fibre_ratio", KIND_REAL, .range = NOT_NEGATIVE,
     .offset = offsetof(pdmc_explicit_material, fibre_ratio), .fallback = "1.0",
     .doc = "c of bonds along the fibres over that of bonds across them, which the moduli give; in between by cos^2"},

    {SECTION_BODIES, "name", KIND_NAME, .offset = offsetof(pdmc_explicit_body, body.name), .fallback = "body1, body2, ...",
     .doc = "each name once"},
    SHAPE_OF(SECTION_BODIES, OF_BODY, BODY_SHAPES, "; or nodes of its own, listed or those of a mesh"),
    {SECTION_BODIES, "file", KIND_TEXT, .offset = offsetof(pdmc_explicit_body, file), WHERE("shape", NODES | MESH),
     .doc = "beside the study: of its nodes, x y volume, in space x y z volume, one node a line; or .msh, of triangles, in space "
            "tetrahedra, whose corners are its nodes; the grid's spacing is about theirs"},
    {SECTION_BODIES, "volumes", KIND_CHOICE, .offset = offsetof(pdmc_explicit_body, volumes), .choices = SHARES,
     .fallback = "elements", WHERE("shape", MESH),
     .doc = "of the nodes of a mesh: each element shared equally among its corners, or Voronoi cells that end at the surface of the "
            "body; both add up to the body's"},
    {SECTION_BODIES, "material", KIND_MATERIAL, .offset = offsetof(pdmc_explicit_body, body.material),
     .fallback = "the first material", .doc = "what it is made of"},
    {SECTION_BODIES, "velocity", KIND_VECTOR, UNIT_VELOCITY, ANY, offsetof(pdmc_explicit_body, body.velocity), .fallback = "zero",
     .doc = "at the start; of a body inside another that of the other"},
    {SECTION_BODIES, "inside", KIND_BODY, .offset = offsetof(pdmc_explicit_body, body.host),
     .flag = offsetof(pdmc_explicit_body, body.is_part), .fallback = "none",
     .doc = "another body, whose nodes in this one's shape are this one's, bonded with the rest and with its other parts as "
            "interfaces say; of two parts the later one has them"},

    {SECTION_INTERFACES, "name", KIND_NAME, .offset = offsetof(pdmc_explicit_interface, bonds.name),
     .fallback = "interface1, interface2, ...", .doc = "each name once"},
    {SECTION_INTERFACES, "between", KIND_CHOICE, .offset = offsetof(pdmc_explicit_interface, between), .choices = BETWEEN,
     .fallback = "materials",
     .doc = "wherever nodes of two materials are bonded, which may be the same in two parts; or between two bodies, which are "
            "bonded by it"},
    SIDE("first_material", first_material, KIND_MATERIAL, MATERIALS),
    SIDE("second_material", second_material, KIND_MATERIAL, MATERIALS),
    SIDE("first_body", first_body, KIND_BODY, BODIES),
    SIDE("second_body", second_body, KIND_BODY, BODIES),
    OF_INTERFACE("youngs_modulus", youngs_modulus, UNIT_STRESS,
                 "E of its bonds; without it and c the harmonic mean of both materials' c, that of two halves of a bond in series"),
    OF_INTERFACE("micromodulus", micromodulus, UNIT_MICROMODULUS, "c of the bond force c s, instead of E"),
    OF_INTERFACE("fracture_energy", fracture_energy, UNIT_LINE_FORCE,
                 "G_0; without it and s_0 a bond has the s_0 of its weaker node"),
    OF_INTERFACE("critical_stretch", critical_stretch, UNIT_NONE,
                 "s_0 at which its bonds break, instead of G_0; without strengthening"),

    {SECTION_PLANAR_CRACKS, "name", KIND_NAME, .offset = offsetof(pdmc_planar_crack, name),
     .fallback = "crack1, crack2, ...", .doc = "each name once"},
    {SECTION_PLANAR_CRACKS, "shape", KIND_CHOICE, .offset = offsetof(pdmc_planar_crack, kind), .choices = PLANAR_CRACKS,
     .fallback = "segment", .doc = "a segment in the plane, through all z; or a disc or a rectangle in space"},
    {SECTION_PLANAR_CRACKS, "from", KIND_PAIR, UNIT_LENGTH, ANY, offsetof(pdmc_planar_crack, from),
     WHERE("shape", SEGMENT), .doc = "one end, [x, y]"},
    {SECTION_PLANAR_CRACKS, "to", KIND_PAIR, UNIT_LENGTH, ANY, offsetof(pdmc_planar_crack, to),
     WHERE("shape", SEGMENT), .doc = "the other end, [x, y]"},
    {SECTION_PLANAR_CRACKS, "centre", KIND_VECTOR, UNIT_LENGTH, ANY, offsetof(pdmc_planar_crack, centre),
     WHERE("shape", DISC | RECTANGLE), .doc = "of a disc or a rectangle"},
    {SECTION_PLANAR_CRACKS, "normal", KIND_VECTOR, .range = ANY, .offset = offsetof(pdmc_planar_crack, normal),
     WHERE("shape", DISC), .doc = "of a disc, of any length"},
    {SECTION_PLANAR_CRACKS, "radius", KIND_REAL, UNIT_LENGTH, POSITIVE, offsetof(pdmc_planar_crack, radius),
     WHERE("shape", DISC), .doc = "of a disc"},
    {SECTION_PLANAR_CRACKS, "first_side", KIND_VECTOR, UNIT_LENGTH, ANY, offsetof(pdmc_planar_crack, side[0]),
     WHERE("shape", RECTANGLE), .doc = "from the centre of a rectangle to the middle of an edge"},
    {SECTION_PLANAR_CRACKS, "second_side", KIND_VECTOR, UNIT_LENGTH, ANY, offsetof(pdmc_planar_crack, side[1]),
     WHERE("shape", RECTANGLE), .doc = "... of the next edge"},

    {SECTION_CONDITIONS, "name", KIND_NAME, .offset = offsetof(pdmc_explicit_condition, layer.name),
     .fallback = "condition1, condition2, ...", .doc = "each name once"},
    {SECTION_CONDITIONS, "prescribed", KIND_CHOICE, .offset = offsetof(pdmc_explicit_condition, layer.kind),
     .choices = CONDITIONS, .fallback = "velocity", .doc = "the velocity of the nodes, a force on a unit of volume, or the displacement"},
    SHAPE_OF(SECTION_CONDITIONS, OF_LAYER, SHAPES, ""),
    COMPONENT("x", 0),
    COMPONENT("y", 1),
    COMPONENT("z", 2),
    GRADIENT("x", 0),
    GRADIENT("y", 1),
    GRADIENT("z", 2),
    {SECTION_CONDITIONS, "times", KIND_REALS, UNIT_TIME, NOT_NEGATIVE,
     offsetof(pdmc_explicit_condition, layer.history.time),
     .flag = offsetof(pdmc_explicit_condition, layer.history.count), .fallback = "none",
     .doc = "[t1, t2, ...] ascending, of the factors; two that are equal are a jump; loads in a quasi-static study"},
    {SECTION_CONDITIONS, "factors", KIND_REALS, .range = ANY,
     .offset = offsetof(pdmc_explicit_condition, layer.history.factor),
     .flag = offsetof(pdmc_explicit_condition, factor_count), .fallback = "none",
     .doc = "[f1, f2, ...] on the components at these times, linear in between, constant outside; without any 1, and from 0 "
            "to 1 at the last load in a quasi-static study"},

    {SECTION_SPHERES, "name", KIND_NAME, .offset = offsetof(pdmc_explicit_sphere, sphere.name),
     .fallback = "sphere1, sphere2, ...", .doc = "each name once"},
    {SECTION_SPHERES, "radius", KIND_REAL, UNIT_LENGTH, POSITIVE, offsetof(pdmc_explicit_sphere, sphere.radius),
     .doc = "nodes are pushed out of it"},
    {SECTION_SPHERES, "centre", KIND_VECTOR, UNIT_LENGTH, ANY, offsetof(pdmc_explicit_sphere, sphere.centre),
     .doc = "at the start"},
    {SECTION_SPHERES, "velocity", KIND_VECTOR, UNIT_VELOCITY, ANY, offsetof(pdmc_explicit_sphere, sphere.velocity),
     OF(PDMC_EXPLICIT), .fallback = "zero", .doc = "at the start"},
    {SECTION_SPHERES, "displacement", KIND_VECTOR, UNIT_LENGTH, ANY, offsetof(pdmc_explicit_sphere, displacement),
     OF(PDMC_QUASI_STATIC), .fallback = "zero", .doc = "of its centre at the last load; in between it grows evenly with the load"},
    {SECTION_SPHERES, "mass", KIND_OPTIONAL, UNIT_MASS, POSITIVE, offsetof(pdmc_explicit_sphere, sphere.mass),
     OF(PDMC_EXPLICIT), .flag = offsetof(pdmc_explicit_sphere, has_mass), .fallback = "none",
     .doc = "without it the sphere keeps its velocity"},
    {SECTION_SPHERES, "stiffness", KIND_REAL, UNIT_PENALTY, POSITIVE, offsetof(pdmc_explicit_sphere, sphere.stiffness),
     .doc = "of the force stiffness (radius - r)^2 on a unit of the volume of a node inside"},

    SHAPE_OF(SECTION_NO_FAIL, OF_ZONE, SHAPES, ""),

    {SECTION_CONTACT, "distance", KIND_REAL, .range = NOT_NEGATIVE, .offset = IN_MOTION(contact_distance),
     .fallback = "1.35",
     .doc = "in spacings, below which nodes repel each other, but not above 0.9 of their first distance; 0 for never"},
    {SECTION_CONTACT, "stiffness", KIND_REAL, .range = POSITIVE, .offset = IN_MOTION(contact_stiffness),
     .fallback = "15.0", .doc = "of the repulsion, over that of a bond as long as the horizon"},

    {SECTION_DAMPING, "absolute", KIND_REAL, UNIT_DAMPING, NOT_NEGATIVE, IN_MOTION(damping), .fallback = "0.0",
     .doc = "C of a force -C v on a unit of volume, which slows bodies as a whole too"},
    {SECTION_DAMPING, "relative", KIND_REAL, UNIT_SLOWNESS, NOT_NEGATIVE, IN_MOTION(bond_damping), .fallback = "0.0",
     .doc = "c_v of a bond's force c (s + c_v w), w the velocity by which its ends part; the stable step falls with it"},

    {SECTION_TIME, "duration", KIND_REAL, UNIT_TIME, POSITIVE, IN_MOTION(duration), .doc = "reached by whole steps"},
    {SECTION_TIME, "step", KIND_OPTIONAL, UNIT_TIME, POSITIVE, IN_MOTION(step), .flag = IN_MOTION(has_step),
     .fallback = "safety times the largest stable one", .doc = "of time"},
    {SECTION_TIME, "safety", KIND_REAL, .range = ABOVE_TO(0.0, 1.0), .offset = IN_MOTION(safety), .fallback = "0.8",
     .doc = "the step over the largest stable one"},

    {SECTION_LOADING, "steps", KIND_INT, .range = FROM_TO(1, 1000000), .offset = IN_MOTION(load_steps), .fallback = "20",
     .doc = "loads, evenly spread; a crack grows at each until no bond breaks"},
    {SECTION_LOADING, "end", KIND_REAL, .range = POSITIVE, .offset = IN_MOTION(load_ends[1]), .fallback = "1.0",
     .doc = "the last load, a number that the conditions' times are of"},
    {SECTION_LOADING, "tolerance", KIND_REAL, .range = {0.0, 0.1, true, false}, .offset = IN_MOTION(rest_tolerance),
     .fallback = "1e-4", .doc = "of the forces out of balance, over the largest external ones so far, as norms"},
    {SECTION_LOADING, "most_steps", KIND_INT, .range = FROM_TO(1, 1000000000), .offset = IN_MOTION(most_relaxation_steps),
     .fallback = "100000", .doc = "of a relaxation, after which the run stops"},

    {SECTION_RECORD, "interval", KIND_OPTIONAL, UNIT_TIME, POSITIVE, IN_MOTION(interval),
     .flag = IN_MOTION(has_interval), .fallback = "duration / 100",
     .doc = "from record to record of energies, tips and spheres, in whole steps"},
    {SECTION_RECORD, "snapshots", KIND_INT, .range = FROM_TO(1, 100000), .offset = IN_MOTION(snapshots),
     .fallback = "10", .doc = "of displacement, velocity and damage of all nodes, evenly over the records or loads, the end included"},
    {SECTION_RECORD, "tip_damage", KIND_REAL, .range = {0.0, 1.0, true, true}, .offset = IN_MOTION(tip_damage),
     .fallback = "0.3", .doc = "damage of a node that a crack has reached"},
    {SECTION_RECORD, "speed_window", KIND_OPTIONAL, UNIT_TIME, POSITIVE, IN_MOTION(speed_window),
     .flag = IN_MOTION(has_speed_window), .fallback = "10 intervals",
     .doc = "of time, over which the speed of a tip is taken by central differences, and in which a tip that has been arrested does "
            "not move"},

    {SECTION_DOMAIN, "dimension", KIND_INT, .range = FROM_TO(1, 2), .offset = IN_SCALAR(dimension), .doc = "of space"},
    {SECTION_DOMAIN, "width", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(width), IN_SCALAR(has_width),
     .fallback = "that of elements.file", .doc = "extent in x; must be given without a file"},
    {SECTION_DOMAIN, "height", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(height), IN_SCALAR(has_height),
     WHERE("dimension", PLANE), .fallback = "that of elements.file", .doc = "extent in y; must be given without a file"},

    {SECTION_KERNEL, "horizon", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(horizon),
     .doc = "delta, length of the longest bond, at the first level"},
    {SECTION_KERNEL, "power", KIND_REAL, .range = {0.0, 2.0, false, true}, .offset = IN_SCALAR(power), .fallback = "1.0",
     .doc = "p of c(r) ~ r^-p; 1 is 2 / (delta^2 r) in one dimension and 6 / (pi delta^3 r) in two"},
    {SECTION_KERNEL, "weights", KIND_REALS, .range = NOT_NEGATIVE, .offset = IN_SCALAR(weights),
     .flag = IN_SCALAR(weight_count), .fallback = "none",
     .doc = "[w1, w2, ...] on r^-p in equal bins of [0, horizon]; 1 throughout without any"},
    {SECTION_KERNEL, "law", KIND_CHOICE, .offset = IN_SCALAR(law.kind), .choices = LAWS, .fallback = "linear",
     .doc = "g(s) of the stretch s = (u' - u) / r of a bond, whose force is c r g: s, S tanh(s / S), s (1 + (s / S)^2), or "
            "s exp(-(s / S)^2), a bond that breaks smoothly"},
    {SECTION_KERNEL, "stretch", KIND_REAL, .range = POSITIVE, .offset = IN_SCALAR(law.stretch), WHERE("law", BENT),
     .doc = "S of the law"},

    {SECTION_HOLES, "centre", KIND_PAIR, UNIT_LENGTH, ANY, offsetof(pdmc_hole, centre), .doc = "[x, y]"},
    {SECTION_HOLES, "radius", KIND_REAL, UNIT_LENGTH, POSITIVE, offsetof(pdmc_hole, radius),
     .doc = "of the circle, which becomes a polygon"},

    {SECTION_ELEMENTS, "space", KIND_CHOICE, .offset = IN_SCALAR(space), .choices = SPACES, .fallback = "continuous",
     .doc = "of functions that are linear in each element; mixed is discontinuous between rough_from and rough_to"},
    {SECTION_ELEMENTS, "mesh", KIND_CHOICE, .offset = IN_SCALAR(mesh), .choices = ELEMENT_MESHES, .fallback = "cells",
     .doc = "equal cells; in two dimensions also triangles by Gmsh, or those of a file of Gmsh"},
    {SECTION_ELEMENTS, "cells", KIND_INT, .range = FROM_TO(2, 100000), .offset = IN_SCALAR(cells), WHERE("mesh", CELLS),
     .doc = "along the width, at the first level; in two dimensions two triangles each"},
    {SECTION_ELEMENTS, "spacing", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(spacing), WHERE("mesh", TRIANGLES),
     .doc = "of the nodes of triangles, at the first level, about"},
    {SECTION_ELEMENTS, "hole_spacing", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(hole_spacing),
     IN_SCALAR(has_hole_spacing), WHERE("mesh", TRIANGLES), .fallback = "spacing",
     .doc = "... up to the distance `near` from holes, from where it grows by a quarter of the way"},
    {SECTION_ELEMENTS, "near", KIND_REAL, UNIT_LENGTH, NOT_NEGATIVE, IN_SCALAR(near), WHERE("mesh", TRIANGLES),
     .fallback = "0.0", .doc = "distance from holes up to which the spacing is hole_spacing"},
    {SECTION_ELEMENTS, "file", KIND_TEXT, .offset = IN_SCALAR(file), WHERE("mesh", MESH_FILE),
     .doc = "beside the study, .msh, of triangles; its physical group \"layer\" is where the field is prescribed, without one "
            "what is nearer to the edge than the horizon"},
    {SECTION_ELEMENTS, "outer", KIND_CHOICE, .offset = IN_SCALAR(outer), .choices = OUTER_RULES, .fallback = "gauss",
     .doc = "integral: exact, in one dimension only; by Gauss points inside the elements, of degree 5; or by points on their "
            "edges"},
    {SECTION_ELEMENTS, "inner", KIND_CHOICE, .offset = IN_SCALAR(inner), .choices = INNER_RULES, .fallback = "exact",
     .doc = "integral from an outer point: exact over the part of an element in the horizon; there by a rule for "
            "polynomials; or careless, by points of the whole element"},
    {SECTION_ELEMENTS, "parts", KIND_INT, .range = FROM_TO(1, 64), .offset = IN_SCALAR(parts), .fallback = "1",
     .doc = "of each side of an element, every one with the outer rule"},
    {SECTION_ELEMENTS, "rough_from", KIND_REAL, UNIT_LENGTH, ANY, IN_SCALAR(rough_from), WHERE("space", MIXED),
     .doc = "least x of the middles of rough elements"},
    {SECTION_ELEMENTS, "rough_to", KIND_REAL, UNIT_LENGTH, ANY, IN_SCALAR(rough_to), WHERE("space", MIXED),
     .doc = "largest x of the middles of rough elements"},

    {SECTION_WAVE, "length", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(wave_length), .flag = IN_SCALAR(has_wave),
     .fallback = "none", .doc = "2 pi / |k|; without it the study has a source, prescribed values and open sides of its own"},
    {SECTION_WAVE, "angle", KIND_REAL, .range = ANY, .offset = IN_SCALAR(angle), .fallback = "0.0",
     .doc = "of k from the x axis, in degrees; 0 in one dimension"},
    {SECTION_WAVE, "phase", KIND_REAL, .range = ANY, .offset = IN_SCALAR(phase), .fallback = "30.0",
     .doc = "in degrees; other than 0 and 90 there is no symmetry that hides errors"},

    GIVEN(SECTION_SOURCE, source),
    GIVEN(SECTION_PRESCRIBED, prescribed),
    {SECTION_OPEN, "side", KIND_CHOICE, .offset = offsetof(pdmc_open_side, side), .choices = SIDES,
     .doc = "where the body ends and nothing is prescribed"},
    {SECTION_OPEN, "flux", KIND_REAL, UNIT_PER_LENGTH, ANY, offsetof(pdmc_open_side, flux), .fallback = "0.0",
     .doc = "du/dn of the classical problem: a source flux / horizon in a layer of the body as deep as the horizon"},

    {SECTION_CONVERGENCE, "vary", KIND_CHOICE, .offset = IN_SCALAR(vary), .choices = CHOICES("spacing", "horizon"),
     .fallback = "spacing",
     .doc = "the spacing at a fixed horizon, to the nonlocal wave or else to the level before; or the horizon on a fixed mesh, "
            "to classical elements"},
    {SECTION_CONVERGENCE, "levels", KIND_INT, .range = FROM_TO(2, 12), .offset = IN_SCALAR(levels), .fallback = "4",
     .doc = "each with half of the one before"},

    {SECTION_MARCH, "duration", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_SCALAR(duration),
     .flag = IN_SCALAR(has_duration), .fallback = "none", .doc = "of the motion, a length since waves have speed 1; none without it"},
    {SECTION_MARCH, "safety", KIND_REAL, .range = ABOVE_TO(0.0, 1.0), .offset = IN_SCALAR(safety), .fallback = "0.2",
     .doc = "the step over the longest stable one at the first level, halved with the spacing"},

    {SECTION_SOLID, "nodes_x", KIND_INT, .range = FROM_TO(1, 10000), .offset = IN_ELASTIC(nodes[0]), .doc = "along x"},
    {SECTION_SOLID, "nodes_y", KIND_INT, .range = FROM_TO(1, 10000), .offset = IN_ELASTIC(nodes[1]), .doc = "along y"},
    {SECTION_SOLID, "nodes_z", KIND_INT, .range = FROM_TO(1, 10000), .offset = IN_ELASTIC(nodes[2]), .doc = "along z"},
    {SECTION_SOLID, "spacing", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_ELASTIC(spacing), .doc = "of the nodes"},
    {SECTION_SOLID, "horizon", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_ELASTIC(horizon), .doc = "length of the longest bond"},
    {SECTION_SOLID, "youngs_modulus", KIND_REAL, UNIT_STRESS, POSITIVE, IN_ELASTIC(youngs_modulus), .doc = "E"},

    {SECTION_INTEGRATION, "rule", KIND_CHOICE, .offset = IN_ELASTIC(rule), .choices = SOLID_RULES,
     .fallback = "cubic_cell",
     .doc = "one point a cell, its node; or Gauss points in every cell, displaced by moving least squares"},
    {SECTION_INTEGRATION, "gauss_points", KIND_INT, .range = FROM_TO(2, 4), .offset = IN_ELASTIC(gauss_points),
     .fallback = "2", WHERE("rule", GAUSS), .doc = "along each side of a cell"},
    {SECTION_INTEGRATION, "support", KIND_OPTIONAL, UNIT_LENGTH, POSITIVE, IN_ELASTIC(support),
     .flag = IN_ELASTIC(has_support), .fallback = "3 spacings", WHERE("rule", GAUSS),
     .doc = "radius of moving least squares"},
    {SECTION_INTEGRATION, "compensation", KIND_CHOICE, .offset = IN_ELASTIC(compensation), .choices = COMPENSATIONS,
     .fallback = "none",
     .doc = "of bonds that surfaces lack: by the energies of an isotropic strain, from the rule's own points, which mends "
            "the rule as well, or in closed form for faces, edges and corners"},

    STRAIN("xx", 0, "along x"),
    STRAIN("yy", 1, "along y"),
    STRAIN("zz", 2, "along z"),
    STRAIN("yz", 3, "half the angle between y and z"),
    STRAIN("zx", 4, "half the angle between z and x"),
    STRAIN("xy", 5, "half the angle between x and y"),

    {SECTION_FACES, "face", KIND_CHOICE, .offset = offsetof(pdmc_elastic_condition, face), .choices = SOLID_FACES,
     .doc = "each once"},
    {SECTION_FACES, "layers", KIND_INT, .range = FROM_TO(0, 10000), .offset = offsetof(pdmc_elastic_condition, layers),
     .fallback = "0", .doc = "of nodes with the displacement of the strain"},
    PULL("x", 0),
    PULL("y", 1),
    PULL("z", 2),

    {SECTION_REST, "method", KIND_CHOICE, .offset = IN_ELASTIC(method), .choices = WAYS_TO_REST, .fallback = "static",
     .doc = "conjugate gradients; dynamic relaxation, its damping found from the motion; or damped motion for a number of "
            "steps"},
    {SECTION_REST, "tolerance", KIND_REAL, .range = ABOVE_TO(0.0, 0.1), .offset = IN_ELASTIC(tolerance),
     .fallback = "1e-9", WHERE("method", ONLY(PDMC_ELASTIC_STATIC) | RELAXATION),
     .doc = "of the free nodes' forces, over those at the start"},
    {SECTION_REST, "most_steps", KIND_INT, .range = FROM_TO(1, 1000000), .offset = IN_ELASTIC(most_steps),
     .fallback = "10000", WHERE("method", RELAXATION), .doc = "after which relaxation is given up"},
    {SECTION_REST, "constant_damping", KIND_OPTIONAL, .range = {0.0, 2.0, false, true},
     .offset = IN_ELASTIC(constant_damping), .flag = IN_ELASTIC(has_constant_damping), .fallback = "none",
     WHERE("method", RELAXATION), .doc = "of relaxation in a step of 1, instead of the adaptive one"},
    {SECTION_REST, "density", KIND_REAL, UNIT_MASS_DENSITY, POSITIVE, IN_ELASTIC(density), WHERE("method", DAMPED),
     .doc = "mass of a unit of volume"},
    {SECTION_REST, "damping", KIND_REAL, UNIT_DAMPING, NOT_NEGATIVE, IN_ELASTIC(damping), .fallback = "0.0",
     WHERE("method", DAMPED), .doc = "c_v of the force -c_v v on a unit of volume"},
    {SECTION_REST, "safety", KIND_REAL, .range = ABOVE_TO(0.0, 1.0), .offset = IN_ELASTIC(safety), .fallback = "0.8",
     WHERE("method", DAMPED), .doc = "the step over spacing / sqrt(K / density)"},
    {SECTION_REST, "steps", KIND_INT, .range = FROM_TO(1, 1000000), .offset = IN_ELASTIC(steps), .fallback = "300",
     WHERE("method", DAMPED), .doc = "of the motion"},

    {SECTION_QUADRATURE, "integral", KIND_CHOICE, .offset = IN_QUADRATURE(integral), .choices = INTEGRALS,
     .fallback = "volume", .doc = "of the horizon itself, or of the forces that make the stress at a node of an infinite body"},
    {SECTION_QUADRATURE, "dimension", KIND_INT, .range = FROM_TO(2, 3), .offset = IN_QUADRATURE(dimension),
     .fallback = "3", .doc = "of space; a plane is in plane stress"},
    {SECTION_QUADRATURE, "horizon", KIND_REAL, UNIT_LENGTH, POSITIVE, IN_QUADRATURE(horizon),
     .doc = "radius of the sphere or disc"},
    {SECTION_QUADRATURE, "ratios", KIND_REALS, .range = FROM_TO(1.0, 100.0), .offset = IN_QUADRATURE(ratios),
     .flag = IN_QUADRATURE(ratio_count), .fallback = "[3.0, 4.0, 5.0, 6.0, 8.0, 10.0]",
     .doc = "of the horizon to the spacing, ascending; time grows as their third power, that of a stress as the fourth"},
    {SECTION_QUADRATURE, "accuracy", KIND_REAL, .range = ABOVE_TO(0.0, 1.0), .offset = IN_QUADRATURE(accuracy),
     .fallback = "5e-4", .doc = "EPS of the adaptive rule: what one index more may change of the integral over a cell"},
    {SECTION_QUADRATURE, "threshold", KIND_REAL, .range = FROM_TO(0.0, 1.0), .offset = IN_QUADRATURE(threshold),
     .fallback = "1e-4", .doc = "TOL of the adaptive rule, in cells: below it EPS is a share of a whole cell"},
    {SECTION_QUADRATURE, "start", KIND_INT, .range = FROM_TO(0, 8), .offset = IN_QUADRATURE(start),
     .fallback = "0, 2 of a stress",
     .doc = "the smallest index of the adaptive rule: n has 2^(n - 1) intervals, 0 a point in the middle"},
    {SECTION_QUADRATURE, "most", KIND_INT, .range = FROM_TO(0, 10), .offset = IN_QUADRATURE(most), .fallback = "8",
     .doc = "the largest index of the adaptive rule"},
    {SECTION_QUADRATURE, "extrapolation", KIND_CHOICE, .offset = IN_QUADRATURE(extrapolates), .choices = SWITCH,
     .fallback = "on", .doc = "of two successive trapezoidal rules to Simpson's; off as printed by Yu"},
    {SECTION_QUADRATURE, "youngs_modulus", KIND_REAL, UNIT_STRESS, POSITIVE, IN_QUADRATURE(youngs_modulus),
     WHERE("integral", STRESS), .doc = "Young's modulus E of the infinite body"},
    STRESS_COMPONENT("xx", 0),
    STRESS_COMPONENT("yy", 1),
    STRESS_COMPONENT("zz", 2),
    STRESS_COMPONENT("yz", 3),
    STRESS_COMPONENT("zx", 4),
    STRESS_COMPONENT("xy", 5),
    {SECTION_QUADRATURE, "profile", KIND_CHOICE, .offset = IN_QUADRATURE(profile), .choices = PROFILES,
     .fallback = "constant", WHERE("integral", STRESS),
     .doc = "of the micromodulus over the length of a bond: constant, falling as a cone, or as the bell (1 - r^2 / delta^2)^2"},
    {SECTION_QUADRATURE, "stretch", KIND_CHOICE, .offset = IN_QUADRATURE(stretch), .choices = STRETCHES,
     .fallback = "linear", WHERE("integral", STRESS),
     .doc = "of the bonds: in full, or to first order in the displacements, which makes a difference of the order of the strain"},
    {.key = NULL},
};

// A choice is stored as an int.
_Static_assert(sizeof(pdmc_assumption) == sizeof(int) && sizeof(pdmc_side) == sizeof(int) &&
                   sizeof(pdmc_quantity) == sizeof(int) && sizeof(pdmc_distribution_kind) == sizeof(int) &&
                   sizeof(pdmc_inverse) == sizeof(int) && sizeof(pdmc_switch) == sizeof(int) &&
                   sizeof(pdmc_stencil_kind) == sizeof(int) && sizeof(pdmc_bonds) == sizeof(int) &&
                   sizeof(pdmc_measure) == sizeof(int) && sizeof(pdmc_problem_kind) == sizeof(int) &&
                   sizeof(pdmc_face) == sizeof(int) && sizeof(pdmc_method) == sizeof(int) &&
                   sizeof(pdmc_bond_area) == sizeof(int) && sizeof(pdmc_bond_micromodulus) == sizeof(int) &&
                   sizeof(pdmc_energy_line) == sizeof(int) && sizeof(pdmc_radial_model) == sizeof(int) &&
                   sizeof(pdmc_covariance_kind) == sizeof(int) && sizeof(pdmc_design_kind) == sizeof(int) &&
                   sizeof(pdmc_rare_method) == sizeof(int) && sizeof(pdmc_target) == sizeof(int) &&
                   sizeof(pdmc_volume_rule) == sizeof(int) && sizeof(pdmc_stretch_kind) == sizeof(int) &&
                   sizeof(pdmc_precision) == sizeof(int) &&
                   sizeof(pdmc_shape_kind) == sizeof(int) &&
                   sizeof(pdmc_planar_crack_kind) == sizeof(int) && sizeof(pdmc_vary) == sizeof(int) &&
                   sizeof(pdmc_space_kind) == sizeof(int) && sizeof(pdmc_elements_kind) == sizeof(int) && sizeof(pdmc_plate_elements_kind) == sizeof(int) && sizeof(pdmc_share) == sizeof(int) && sizeof(pdmc_outer_rule) == sizeof(int) &&
                   sizeof(pdmc_inner_rule) == sizeof(int) && sizeof(pdmc_solid_rule) == sizeof(int) &&
                   sizeof(pdmc_solid_compensation) == sizeof(int) && sizeof(pdmc_elastic_face) == sizeof(int) &&
                   sizeof(pdmc_elastic_method) == sizeof(int) && sizeof(pdmc_condition_kind) == sizeof(int) &&
                   sizeof(pdmc_integral) == sizeof(int) && sizeof(pdmc_profile) == sizeof(int) &&
                   sizeof(pdmc_bond_stretch) == sizeof(int),
               "enumerations of another size");
