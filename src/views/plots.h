// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The drawings: each writes what is to be drawn into an open figure.

#include "views/figure.h"

/// Probability densities of an energy straight ahead of a tip and 45 degrees off: those of the bins, of all samples, and
/// smooth ones, of the samples that are kept.
pdmc_status pdmc_draw_density(const pdmc_results *r, int tip, pdmc_measure measure, const pdmc_figure *figure);

/// The data block $density<block>: energy, density and its bounds, as steps from edge to edge, two points a bin, and
/// down to zero at both ends.
void pdmc_draw_steps(const pdmc_results *r, pdmc_measure measure, size_t at, int block, FILE *script);

/// Quantiles of an energy round a tip.
void pdmc_draw_quantiles(const pdmc_results *r, int tip, pdmc_measure measure, const pdmc_figure *figure);

/// The probability that an energy is largest in each direction.
void pdmc_draw_direction(const pdmc_results *r, int tip, const pdmc_figure *figure);

/// The micromodulus of the first sample over the length of a bond.
void pdmc_draw_micromodulus(const pdmc_results *r, const pdmc_figure *figure);

/// Work, elastic, kinetic and dissipated energy over time.
void pdmc_draw_motion_energies(const pdmc_results *r, const pdmc_figure *figure);

/// The displacements of the probes over time.
void pdmc_draw_motion_displacements(const pdmc_results *r, const pdmc_figure *figure);

/// Displacement and strain along the body of an elastic study, and the energies of its damped motion.
void pdmc_draw_elastic_displacement(const pdmc_results *r, const pdmc_figure *figure);
void pdmc_draw_elastic_strain(const pdmc_results *r, const pdmc_figure *figure);
void pdmc_draw_elastic_energies(const pdmc_results *r, const pdmc_figure *figure);

/// The errors of a scalar study's levels, and its last field along the line of the wave.
void pdmc_draw_scalar_convergence(const pdmc_results *r, const pdmc_figure *figure);
void pdmc_draw_scalar_field(const pdmc_results *r, const pdmc_figure *figure);

/// What came in and what it has become, growth of the tips, both over time, of an explicit study.
void pdmc_draw_explicit_energies(const pdmc_results *r, const pdmc_figure *figure);
/// The forces of conditions over their displacements, of those that move, and of spheres over their way, of a quasi-static study.
void pdmc_draw_load_displacement(const pdmc_results *r, const pdmc_figure *figure);
void pdmc_draw_explicit_tips(const pdmc_results *r, const pdmc_figure *figure);

/// The damage of the last snapshot, on the nodes as they lay: in the plane all of it; in space from above, and on a section
/// through the middle.
pdmc_status pdmc_draw_explicit_damage(const pdmc_results *r, pdmc_figure *figure);

/// The pieces in the same way: the largest grey, single nodes black, all others in colours that repeat.
pdmc_status pdmc_draw_explicit_fragments(const pdmc_results *r, pdmc_figure *figure);

/// Of its samples: the density of the growth of a tip, and the paths of all tips.
void pdmc_draw_growth(const pdmc_results *r, int tip, const pdmc_figure *figure);
void pdmc_draw_paths(const pdmc_results *r, const pdmc_figure *figure);

/// Of those of a quasi-static one: the distribution of a condition's largest force.
pdmc_status pdmc_draw_forces(const pdmc_results *r, int condition, const pdmc_figure *figure);

/// How many pieces are at least as heavy as any mass.
void pdmc_draw_explicit_masses(const pdmc_results *r, const pdmc_figure *figure);

/// Errors of rules for integrals over the horizon, over their points and over their time.
void pdmc_draw_quadrature_points(const pdmc_results *r, const pdmc_figure *figure);
void pdmc_draw_quadrature_time(const pdmc_results *r, const pdmc_figure *figure);

/// The plate, its cracks, and its displaced nodes and crack faces.
void pdmc_draw_plate(const pdmc_results *r, const pdmc_figure *figure);
