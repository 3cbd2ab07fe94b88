// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plates for the tests of the visible crack model: those of the analytic one with nodes graded to the cracks.

#include "kansa/plate.h"
#include "visible/visible.h"

#include <complex.h>

/// A plate without cracks and loads, nodes delta / refinement apart near the cracks that are to come.
static inline void cracked_make(plate *p, double size, double horizon, int refinement)
{
    plate_make(p, size, 20, horizon);
    p->problem.solver.crack_model = PDMC_CRACKS_VISIBLE;
    p->problem.solver.refinement = refinement;
}

/// Uniform stress s_x, s_y, tau on all sides.
static inline void cracked_load(plate *p, const double s[3])
{
    plate_load(p, PDMC_SIDE_RIGHT, s[0], s[2]);
    plate_load(p, PDMC_SIDE_LEFT, -s[0], -s[2]);
    plate_load(p, PDMC_SIDE_TOP, s[2], s[1]);
    plate_load(p, PDMC_SIDE_BOTTOM, -s[2], -s[1]);
}

/// A crack of half length a along x in an infinite plane of E = 1 under unit tension across it, in the local limit.
static inline void cracked_in_plane(const double middle[2], double a, const double x[2], double u[2])
{
    const double E = 1.0, nu = 1.0 / 3.0, mu = 0.5 * E / (1.0 + nu), kappa = (3.0 - nu) / (1.0 + nu);
    const double complex z = x[0] - middle[0] + I * (x[1] - middle[1]), root = csqrt(z - a) * csqrt(z + a);
    const double complex biaxial = 0.5 * (kappa * root - conj(root) - (z - conj(z)) * conj(z / root)) / (2.0 * mu);
    u[0] = creal(biaxial) - creal(z) / E;
    u[1] = cimag(biaxial) + nu * cimag(z) / E;
}

typedef pdmc_status (*cracked_displacement)(const void *model, const double x[2], const double anchor[2], double u[2]);

/// The jump of the displacement over a crack through the origin, `along` from it, in the crack's frame.
static inline void cracked_jump(cracked_displacement displacement, const void *model, double angle, double along,
                                double jump[2])
{
    const double c = cos(angle), s = sin(angle), x[2] = {along * c, along * s};
    const double left[2] = {x[0] - 1e-3 * s, x[1] + 1e-3 * c}, right[2] = {x[0] + 1e-3 * s, x[1] - 1e-3 * c};
    double u[2], v[2];
    CHECK_OK(displacement(model, x, left, u));
    CHECK_OK(displacement(model, x, right, v));
    jump[0] = c * (u[0] - v[0]) + s * (u[1] - v[1]);
    jump[1] = c * (u[1] - v[1]) - s * (u[0] - v[0]);
}

static inline pdmc_status cracked_visible(const void *model, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_visible_displacement(model, x, anchor, u);
}

static inline pdmc_status cracked_analytic(const void *model, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_kansa_displacement(model, x, anchor, u);
}
