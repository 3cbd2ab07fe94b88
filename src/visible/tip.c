// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/tip.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

enum { CONTOUR_POINTS = 48 };

// A tip's frame: x straight ahead.
typedef struct {
    double position[2], cosine, sine, half_length;
} tip_frame;

static tip_frame frame_of(const pdmc_visible *visible, int tip)
{
    const pdmc_cut *cut = &visible->cuts.cut[tip / 2];
    const double end = tip % 2 ? 1.0 : -1.0;
    tip_frame frame = {{0.0, 0.0}, end * cut->cosine, end * cut->sine, cut->half_length};
    pdmc_cut_global(cut, end * cut->half_length, 0.0, frame.position);
    return frame;
}

// Hooke's law, lambda = mu; gradient and stress row-major.
static void stress_of(double mu, const double gradient[4], double stress[4])
{
    stress[0] = mu * (3.0 * gradient[0] + gradient[3]);
    stress[1] = stress[2] = mu * (gradient[1] + gradient[2]);
    stress[3] = mu * (gradient[0] + 3.0 * gradient[3]);
}

// The gradient of the displacement of a crack in an infinite plane with K_I = 1 (mode 0) or K_II = 1; kappa = 2 in both
// plane assumptions.
static void unit_field(double mu, int mode, double r, double theta, double gradient[4])
{
    const double c = cos(theta), s = sin(theta), ch = cos(0.5 * theta), sh = sin(0.5 * theta);
    const double f[2] = {mode == 0 ? ch * (2.0 - c) : sh * (4.0 + c), mode == 0 ? sh * (2.0 - c) : -ch * c};
    const double slope[2] = {mode == 0 ? ch * s - 0.5 * sh * (2.0 - c) : 0.5 * ch * (4.0 + c) - sh * s,
                             mode == 0 ? 0.5 * ch * (2.0 - c) + sh * s : 0.5 * sh * c + ch * s};
    const double scale = 1.0 / (2.0 * mu * sqrt(2.0 * M_PI * r));
    for (int i = 0; i < 2; i++) {
        gradient[2 * i] = scale * (0.5 * c * f[i] - s * slope[i]);
        gradient[2 * i + 1] = scale * (0.5 * s * f[i] + c * slope[i]);
    }
}

// The integrand of the interaction integral, sigma : grad a n_x - (sigma n) . a_x - (tau n) . u_x, for fields u and a.
static double interaction(double mu, const double u[4], const double a[4], const double n[2])
{
    double sigma[4], tau[4], sum = 0.0;
    stress_of(mu, u, sigma);
    stress_of(mu, a, tau);
    for (int k = 0; k < 4; k++) sum += n[0] * sigma[k] * a[k];
    for (int i = 0; i < 2; i++) {
        sum -= (sigma[2 * i] * n[0] + sigma[2 * i + 1] * n[1]) * a[2 * i];
        sum -= (tau[2 * i] * n[0] + tau[2 * i + 1] * n[1]) * u[2 * i];
    }
    return sum;
}

// What multiplies the gradient of u in the integrand, turned from the tip's frame into the plate's.
static void integrand(double mu, const tip_frame *frame, const double a[4], const double n[2], double factor[4])
{
    const double R[2][2] = {{frame->cosine, -frame->sine}, {frame->sine, frame->cosine}};
    double local[4];
    for (int k = 0; k < 4; k++) {
        const double unit[4] = {k == 0, k == 1, k == 2, k == 3};
        local[k] = interaction(mu, unit, a, n);
        factor[k] = 0.0;
    }
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            for (int k = 0; k < 4; k++) factor[2 * i + j] += R[i][k / 2] * R[j][k % 2] * local[k];
}

// The radius of the contour: beyond the horizon, where the field is that of local elasticity, but clear of other cracks
// and of the sides.
static double contour_radius(const pdmc_visible *visible, const tip_frame *frame, int crack)
{
    const pdmc_plate *plate = &visible->problem->plate;
    double room = fmin(0.5 * plate->width - fabs(frame->position[0]), 0.5 * plate->height - fabs(frame->position[1]));
    for (int c = 0; c < visible->cuts.count; c++) {
        const pdmc_cuts other = {1, &visible->cuts.cut[c]};
        if (c != crack) room = fmin(room, pdmc_cuts_distance(&other, frame->position));
    }
    const double wanted = fmax(frame->half_length, 2.0 * visible->problem->kansa.horizon);
    return fmin(wanted, 0.8 * fmin(room, 2.0 * frame->half_length));
}

static pdmc_status add_contour_point(const pdmc_visible *visible, const tip_frame *frame, double r, double theta,
                                     double weight, double row[2][2 * PDMC_STENCIL_NODES], const pdmc_stencil **at)
{
    const pdmc_material *material = &visible->problem->material;
    const double mu = 0.5 * material->youngs_modulus / (1.0 + pdmc_poissons_ratio(material->assumption));
    const double n[2] = {cos(theta), sin(theta)};
    const pdmc_view view = {{frame->position[0] + r * (frame->cosine * n[0] - frame->sine * n[1]),
                             frame->position[1] + r * (frame->sine * n[0] + frame->cosine * n[1])},
                            -1,
                            0};
    const int owner = pdmc_stencil_owner(&visible->field, &view);
    if (owner < 0) return pdmc_raise(PDMC_ERR_SINGULAR, "no node is visible from (%g, %g)", view.x[0], view.x[1]);
    const pdmc_stencil *stencil = *at = &visible->stencils[owner];
    double by_x[PDMC_STENCIL_NODES], by_y[PDMC_STENCIL_NODES], a[4], factor[4];
    pdmc_stencil_gradient(stencil, view.x, by_x, by_y);
    for (int mode = 0; mode < 2; mode++) {
        unit_field(mu, mode, r, theta, a);
        integrand(mu, frame, a, n, factor);
        for (int k = 0; k < stencil->count; k++)
            for (int i = 0; i < 2; i++)
                row[mode][2 * k + i] = weight * (factor[2 * i] * by_x[k] + factor[2 * i + 1] * by_y[k]);
    }
    return PDMC_OK;
}

pdmc_status pdmc_visible_stress_intensity_rows(const pdmc_visible *visible, int tip, double row_1[], double row_2[])
{
    const tip_frame frame = frame_of(visible, tip);
    const double r = contour_radius(visible, &frame, tip / 2);
    const double scale = 0.5 * pdmc_plane_modulus(&visible->problem->material) * r;
    double theta[CONTOUR_POINTS], weight[CONTOUR_POINTS], row[2][2 * PDMC_STENCIL_NODES];
    pdmc_status status = pdmc_gauss_legendre(CONTOUR_POINTS, -M_PI, M_PI, theta, weight);
    for (int i = 0; i < CONTOUR_POINTS && status == PDMC_OK; i++) {
        const pdmc_stencil *stencil = NULL;
        status = add_contour_point(visible, &frame, r, theta[i], scale * weight[i], row, &stencil);
        for (int k = 0; status == PDMC_OK && k < 2 * stencil->count; k++) {
            row_1[2 * stencil->node[k / 2] + k % 2] += row[0][k];
            row_2[2 * stencil->node[k / 2] + k % 2] += row[1][k];
        }
    }
    return status;
}

pdmc_status pdmc_visible_tip(const pdmc_visible *visible, int tip, pdmc_tip *out)
{
    const pdmc_problem *problem = visible->problem;
    PDMC_REQUIRE(0 <= tip && tip < 2 * problem->crack_count, "tip %d: there are %d", tip, 2 * problem->crack_count);
    pdmc_status status = PDMC_OK;
    const int n = visible->unknowns;
    const tip_frame frame = frame_of(visible, tip);
    double *row = NULL;
    PDMC_NEW(row, 2 * n);
    PDMC_TRY(pdmc_visible_stress_intensity_rows(visible, tip, row, row + n));
    snprintf(out->name, sizeof out->name, "%s.%s", problem->cracks[tip / 2].name, tip % 2 ? "to" : "from");
    for (int k = 0; k < 2; k++) {
        out->position[k] = frame.position[k];
        out->stress_intensity[k] = cblas_ddot(n, row + k * n, 1, visible->mean, 1);
    }
    out->direction = atan2(frame.sine + 0.0, frame.cosine); // no -0, which would be -pi
    out->t_stress = NAN;
done:
    pdmc_free(row);
    return status;
}
