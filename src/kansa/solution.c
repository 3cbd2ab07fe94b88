// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "kansa/kansa_impl.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

pdmc_solver_report pdmc_kansa_report(const pdmc_kansa *kansa)
{
    return (pdmc_solver_report){
        .nodes = kansa->points.columns * kansa->points.rows,
        .unknowns = kansa->unknowns,
        .rows = kansa->rows,
        .rank = kansa->rank,
        .condition = kansa->condition,
        .residual = kansa->residual,
        .horizon = kansa->problem->solver.horizon,
        .spacing = kansa->spacing,
    };
}

void pdmc_kansa_runtime(const pdmc_kansa *kansa, double *assembly, double *factorisation)
{
    *assembly = kansa->assembly_seconds;
    *factorisation = kansa->factorisation_seconds;
}

// Applies a pair of rows at the mean solution. The builder is made anew, so that the model stays constant.
typedef void (*row_maker)(pdmc_row_builder *, const double[2], const double[2], double[], double[]);

static pdmc_status apply_rows(const pdmc_kansa *kansa, row_maker rows, const double x[2], const double anchor[2],
                              double value[2])
{
    pdmc_status status = PDMC_OK;
    const int n = kansa->unknowns;
    pdmc_row_builder builder = {0};
    double *row = NULL;
    PDMC_TRY(pdmc_row_builder_create(&kansa->basis, &builder));
    PDMC_NEW(row, 2 * n);
    rows(&builder, x, anchor, row, row + n);
    for (int k = 0; k < 2; k++) value[k] = cblas_ddot(n, row + k * n, 1, kansa->coefficients, 1);
done:
    pdmc_free(row);
    pdmc_row_builder_clear(&builder);
    return status;
}

pdmc_status pdmc_kansa_displacement(const pdmc_kansa *kansa, const double x[2], const double anchor[2], double u[2])
{
    return apply_rows(kansa, pdmc_displacement_rows, x, anchor, u);
}

static void traction_on_x(pdmc_row_builder *builder, const double x[2], const double anchor[2], double row_x[],
                          double row_y[])
{
    pdmc_traction_rows(builder, x, anchor, (const double[2]){1.0, 0.0}, row_x, row_y);
}

static void traction_on_y(pdmc_row_builder *builder, const double x[2], const double anchor[2], double row_x[],
                          double row_y[])
{
    pdmc_traction_rows(builder, x, anchor, (const double[2]){0.0, 1.0}, row_x, row_y);
}

pdmc_status pdmc_kansa_stress(const pdmc_kansa *kansa, const double x[2], const double anchor[2], double stress[3])
{
    double on_x[2], on_y[2];
    pdmc_status status = apply_rows(kansa, traction_on_x, x, anchor, on_x);
    if (status == PDMC_OK) status = apply_rows(kansa, traction_on_y, x, anchor, on_y);
    if (status != PDMC_OK) return status;
    stress[0] = on_x[0];
    stress[1] = on_y[1];
    stress[2] = on_x[1];
    return PDMC_OK;
}

void pdmc_kansa_stress_intensity_rows(const pdmc_kansa *kansa, int tip, double row_1[], double row_2[])
{
    const pdmc_basis *basis = &kansa->basis;
    const int crack = tip / 2, first = 2 * basis->scalars + 4 * basis->orders * crack;
    const bool is_to = tip % 2 == 1;
    const double factor = -2.0 * sqrt(M_PI / basis->cracks[crack].half_length);
    for (int m = 1; m <= basis->orders; m++) {
        const double value = factor * m * (is_to || m % 2 == 1 ? 1.0 : -1.0);
        row_1[first + 4 * (m - 1)] = value;
        row_2[first + 4 * (m - 1) + 1] = -value;
        if (m > basis->moments) continue;
        const int moment = 2 * basis->scalars + pdmc_basis_moment(basis, crack, m);
        const double x = is_to ? 1.0 : -1.0; // of the tip, over a
        row_1[moment] = x * value;
        row_2[moment + 1] = -x * value;
    }
}

// The stress along the crack, averaged over the two faces, at a distance from the tip.
static pdmc_status mean_face_stress(const pdmc_kansa *kansa, int tip, double distance, double *stress)
{
    const pdmc_crack_frame *crack = &kansa->basis.cracks[tip / 2];
    const double c = crack->cosine, s = crack->sine, a = crack->half_length;
    const double along = (tip % 2 ? 1.0 : -1.0) * (a - distance);
    const double x[2] = {crack->centre[0] + along * c, crack->centre[1] + along * s};
    *stress = 0.0;
    for (int face = 1; face >= -1; face -= 2) {
        const double offset = 1e-3 * a * face, anchor[2] = {x[0] - offset * s, x[1] + offset * c};
        double value[3];
        const pdmc_status status = pdmc_kansa_stress(kansa, x, anchor, value);
        if (status != PDMC_OK) return status;
        *stress += 0.5 * (value[0] * c * c + value[1] * s * s + 2.0 * value[2] * c * s);
    }
    return PDMC_OK;
}

pdmc_status pdmc_kansa_tip(const pdmc_kansa *kansa, int tip, pdmc_tip *out)
{
    const pdmc_problem *problem = kansa->problem;
    PDMC_REQUIRE(0 <= tip && tip < 2 * problem->crack_count, "tip %d: there are %d", tip, 2 * problem->crack_count);
    pdmc_status status = PDMC_OK;
    const pdmc_crack *crack = &problem->cracks[tip / 2];
    const int n = kansa->unknowns;
    double *row = NULL;
    PDMC_NEW(row, 2 * n);
    pdmc_kansa_stress_intensity_rows(kansa, tip, row, row + n);
    const double *from = tip % 2 ? crack->from : crack->to, *to = tip % 2 ? crack->to : crack->from;
    snprintf(out->name, sizeof out->name, "%s.%s", crack->name, tip % 2 ? "to" : "from");
    for (int k = 0; k < 2; k++) {
        out->position[k] = to[k];
        out->stress_intensity[k] = cblas_ddot(n, row + k * n, 1, kansa->coefficients, 1);
    }
    out->direction = atan2(to[1] - from[1], to[0] - from[0]);
    // The mean over the faces is analytic in the distance: linear extrapolation from 2 and 4 % of a.
    const double distance = 0.02 * kansa->basis.cracks[tip / 2].half_length;
    double near, far;
    PDMC_TRY(mean_face_stress(kansa, tip, distance, &near));
    PDMC_TRY(mean_face_stress(kansa, tip, 2.0 * distance, &far));
    out->t_stress = 2.0 * near - far;
done:
    pdmc_free(row);
    return status;
}
