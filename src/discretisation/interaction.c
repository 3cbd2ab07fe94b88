// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/interaction.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"
#include "pdmc/quadrature.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { CONTOUR_POINTS = 48, MODES = 2 };

pdmc_tip_frame pdmc_tip_frame_of(const pdmc_problem *problem, int tip)
{
    const pdmc_crack *crack = &problem->cracks[tip / 2];
    const double *end = tip % 2 ? crack->to : crack->from, *other = tip % 2 ? crack->from : crack->to;
    const double length = hypot(end[0] - other[0], end[1] - other[1]);
    return (pdmc_tip_frame){{end[0], end[1]}, (end[0] - other[0]) / length, (end[1] - other[1]) / length};
}

double pdmc_interaction_radius(const pdmc_problem *problem, int tip, double wanted)
{
    const pdmc_crack *own = &problem->cracks[tip / 2];
    const double *x = tip % 2 ? own->to : own->from;
    double room = hypot(own->to[0] - own->from[0], own->to[1] - own->from[1]);
    room = fmin(room, fmin(0.5 * problem->plate.width - fabs(x[0]), 0.5 * problem->plate.height - fabs(x[1])));
    for (int c = 0; c < problem->crack_count; c++) {
        const pdmc_crack *crack = &problem->cracks[c];
        if (crack != own) room = fmin(room, pdmc_point_segment_distance(x, crack->from, crack->to));
    }
    return fmin(wanted, 0.8 * room);
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
static void integrand(double mu, const pdmc_tip_frame *frame, const double a[4], const double n[2], double factor[4])
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

// The nodes of one point of the circle.
typedef struct {
    int count;
    int *node;           // [most_nodes]
    double *by_x, *by_y; // [most_nodes]
} point_nodes;

static void point_clear(point_nodes *point)
{
    pdmc_free(point->node);
    pdmc_free(point->by_x);
    pdmc_free(point->by_y);
}

static pdmc_status point_create(int most_nodes, point_nodes *point)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(point->node, most_nodes);
    PDMC_NEW(point->by_x, most_nodes);
    PDMC_NEW(point->by_y, most_nodes);
done:
    return status;
}

static void add_point(double mu, const pdmc_tip_frame *frame, const double polar[2], double weight,
                      const point_nodes *point, double *row[MODES])
{
    const double n[2] = {cos(polar[1]), sin(polar[1])};
    for (int mode = 0; mode < MODES; mode++) {
        double a[4], factor[4];
        unit_field(mu, mode, polar[0], polar[1], a);
        integrand(mu, frame, a, n, factor);
        for (int k = 0; k < point->count; k++)
            for (int i = 0; i < 2; i++)
                row[mode][2 * point->node[k] + i] +=
                    weight * (factor[2 * i] * point->by_x[k] + factor[2 * i + 1] * point->by_y[k]);
    }
}

pdmc_status pdmc_interaction_rows(const pdmc_problem *problem, int tip, double radius,
                                  const pdmc_gradient_functional *functional, double row_1[], double row_2[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_tip_frame frame = pdmc_tip_frame_of(problem, tip);
    const pdmc_material *material = &problem->material;
    const double mu = 0.5 * material->youngs_modulus / (1.0 + pdmc_poissons_ratio(material->assumption));
    const double scale = 0.5 * pdmc_plane_modulus(material) * radius;
    double theta[CONTOUR_POINTS], weight[CONTOUR_POINTS], *row[MODES] = {row_1, row_2};
    point_nodes point = {0};
    PDMC_TRY(point_create(functional->most_nodes, &point));
    PDMC_TRY(pdmc_gauss_legendre(CONTOUR_POINTS, -M_PI, M_PI, theta, weight));
    for (int i = 0; i < CONTOUR_POINTS; i++) {
        const double polar[2] = {radius, theta[i]}, along = radius * cos(theta[i]), across = radius * sin(theta[i]);
        const double x[2] = {frame.position[0] + frame.cosine * along - frame.sine * across,
                             frame.position[1] + frame.sine * along + frame.cosine * across};
        PDMC_TRY(functional->gradient(functional->method, x, &point.count, point.node, point.by_x, point.by_y));
        add_point(mu, &frame, polar, scale * weight[i], &point, row);
    }
done:
    point_clear(&point);
    return status;
}
