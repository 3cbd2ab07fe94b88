// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "discretisation/tip.h"
#include "paper/paper_impl.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double beside = 1e-6; // of the half length: where the anchors of a crack's faces lie

pdmc_status pdmc_paper_displacement(const pdmc_paper *paper, const double x[2], const double anchor[2], double u[2])
{
    pdmc_status status = PDMC_OK;
    const int scalars = paper->basis.scalars;
    double *value = NULL;
    PDMC_NEW(value, scalars);
    pdmc_paper_values(&paper->basis, x, anchor, value);
    for (int k = 0; k < 2; k++) u[k] = cblas_ddot(scalars, value, 1, &paper->coefficients[k * scalars], 1);
done:
    pdmc_free(value);
    return status;
}

// A point of a crack at `share` of the way from "from" to "to", with an anchor to the left (side = 1) or right (-1) of it.
static void face_point(const pdmc_crack *crack, double share, int side, double x[2], double anchor[2])
{
    const double d[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]};
    for (int k = 0; k < 2; k++) x[k] = crack->from[k] + share * d[k];
    anchor[0] = x[0] - 0.5 * beside * side * d[1];
    anchor[1] = x[1] + 0.5 * beside * side * d[0];
}

// The values to the left less those to the right of a crack.
static void jump_values(const pdmc_paper_basis *basis, const pdmc_crack *crack, double share, double right[],
                        double jump[])
{
    double x[2], anchor[2];
    face_point(crack, share, 1, x, anchor);
    pdmc_paper_values(basis, x, anchor, jump);
    face_point(crack, share, -1, x, anchor);
    pdmc_paper_values(basis, x, anchor, right);
    cblas_daxpy(basis->scalars, -1.0, right, 1, jump, 1);
}

enum { OPENINGS = 19 };

// The intercept of a straight line fitted to values at these points is their sum with these weights.
static void intercept_weights(double r[OPENINGS], double weight[OPENINGS])
{
    const double first = 0.02, last = 0.2, mean = 0.5 * (first + last);
    double squares = 0.0;
    for (int i = 0; i < OPENINGS; i++) {
        r[i] = first + (last - first) * i / (OPENINGS - 1);
        squares += (r[i] - mean) * (r[i] - mean);
    }
    for (int i = 0; i < OPENINGS; i++) weight[i] = 1.0 / OPENINGS - mean * (r[i] - mean) / squares;
}

pdmc_status pdmc_paper_stress_intensity_rows(const pdmc_paper *paper, int tip, double row_1[], double row_2[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_paper_basis *basis = &paper->basis;
    const pdmc_crack *crack = &paper->problem->cracks[tip / 2];
    const double d[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]}, length = hypot(d[0], d[1]);
    const double t[2] = {d[0] / length, d[1] / length};
    const int scalars = basis->scalars;
    double r[OPENINGS], weight[OPENINGS], *right = NULL, *jump = NULL;
    PDMC_NEW(right, scalars);
    PDMC_NEW(jump, scalars);
    intercept_weights(r, weight);
    for (int i = 0; i < OPENINGS; i++) {
        jump_values(basis, crack, tip % 2 ? 1.0 - 0.5 * r[i] : 0.5 * r[i], right, jump);
        const double factor =
            weight[i] * pdmc_plane_modulus(&paper->problem->material) / 8.0 * sqrt(2.0 * M_PI / (0.5 * length * r[i]));
        cblas_daxpy(scalars, -factor * t[1], jump, 1, row_1, 1);
        cblas_daxpy(scalars, factor * t[0], jump, 1, row_1 + scalars, 1);
        cblas_daxpy(scalars, factor * t[0], jump, 1, row_2, 1);
        cblas_daxpy(scalars, factor * t[1], jump, 1, row_2 + scalars, 1);
    }
done:
    pdmc_free(right);
    pdmc_free(jump);
    return status;
}

static pdmc_status tip_rows(const void *method, int tip, double row_1[], double row_2[])
{
    return pdmc_paper_stress_intensity_rows(method, tip, row_1, row_2);
}

pdmc_status pdmc_paper_tip(const pdmc_paper *paper, int tip, pdmc_tip *out)
{
    return pdmc_tip_of(paper->problem, tip, paper->unknowns, paper->coefficients, tip_rows, paper, out);
}
