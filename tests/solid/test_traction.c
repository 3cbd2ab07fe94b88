// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"
#include "pdmc/solid.h"

#include "check.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

static const double STRAIN[3][3] = {{1.0, 0.3, -0.2}, {0.3, -0.4, 0.7}, {-0.2, 0.7, 0.5}};
enum { POINTS = 24 };

/// The closed form against Gauss' rule along the line.
static void closed_form(void **state)
{
    (void)state;
    double at[POINTS], weight[POINTS];
    const double horizon = 2.0, places[4][3] = {{0.3, 0.4, 0.2}, {0.1, -1.2, 0.9}, {0.0, 0.0, 0.7}, {1.5, 1.4, 0.1}};
    for (int p = 0; p < 4; p++) {
        const double *across = places[p], depth = places[p][2];
        const double end = sqrt(fmax(0.0, horizon * horizon - gsl_pow_2(across[0]) - gsl_pow_2(across[1])));
        double want[3] = {0.0, 0.0, 0.0}, got[3];
        if (end > depth) CHECK_OK(pdmc_gauss_legendre(POINTS, depth, end, at, weight));
        for (int i = 0; i < POINTS && end > depth; i++) {
            const double xi[3] = {across[0], across[1], at[i]};
            double pull = 0.0;
            for (int j = 0; j < 3; j++)
                for (int k = 0; k < 3; k++) pull += xi[j] * STRAIN[j][k] * xi[k];
            const double r = sqrt(gsl_pow_2(xi[0]) + gsl_pow_2(xi[1]) + gsl_pow_2(xi[2]));
            for (int k = 0; k < 3; k++) want[k] += weight[i] * pull * xi[k] / gsl_pow_3(r);
        }
        pdmc_line_to_point_force(STRAIN, horizon, depth, across, got);
        for (int k = 0; k < 3; k++) CHECK_NEAR(got[k], want[k], 1e-12);
    }
}

/// The areal force density of eq. 4.9, int over depths and the face, is the stress of Hooke's law with nu = 1/4,
/// 2 E / 5 (tr(strain) n + 2 strain n), E = pi horizon^4 / 12 for a micromodulus of one (eq. 3.68, 4.14).
static void areal_force_density(void **state)
{
    (void)state;
    const double horizon = 2.0, modulus = M_PI * gsl_pow_4(horizon) / 12.0;
    double depth[POINTS], depth_weight[POINTS], at[POINTS], weight[POINTS], got[3] = {0.0, 0.0, 0.0};
    CHECK_OK(pdmc_gauss_legendre(POINTS, 0.0, 1.0, depth, depth_weight));
    CHECK_OK(pdmc_gauss_legendre(POINTS, 0.0, 1.0, at, weight));
    for (int i = 0; i < POINTS; i++) {
        const double h = horizon * depth[i] * depth[i], disc = sqrt(horizon * horizon - h * h);
        for (int j = 0; j < POINTS; j++)
            for (int k = 0; k < POINTS; k++) { // angles: the integrand is a polynomial of low degree in them
                const double r = disc * at[j], angle = 2.0 * M_PI * k / POINTS;
                const double across[2] = {r * cos(angle), r * sin(angle)};
                double force[3];
                pdmc_line_to_point_force(STRAIN, horizon, h, across, force);
                for (int m = 0; m < 3; m++)
                    got[m] += 2.0 * horizon * depth[i] * depth_weight[i] * weight[j] * disc * r * 2.0 * M_PI / POINTS *
                              force[m];
            }
    }
    const double trace = STRAIN[0][0] + STRAIN[1][1] + STRAIN[2][2];
    for (int m = 0; m < 3; m++) // Gauss' rule in the radius, where the integrand falls as log r for small depths
        CHECK_NEAR(got[m], 0.4 * modulus * (2.0 * STRAIN[m][2] + (m == 2 ? trace : 0.0)), 1e-4 * modulus);
}

static const pdmc_solid_options BLOCK = {
    .nodes = {9, 8, 10}, .spacing = 0.5, .horizon = 1.5, .youngs_modulus = 3.0, .threads = 1};

/// Every face and component: the forces along it add up to the traction's times the area, and a gradient makes
/// its moment: that of the nodes' tractions, to the rounding of the sums over depths.
static void forces_add_up(void **state)
{
    (void)state;
    for (int face = 0; face < PDMC_SOLID_FACES; face += FINEST_LEFT_OUT ? 5 : 1) {
        pdmc_solid_options options = BLOCK;
        pdmc_solid *solid;
        const int along = (face / 2 + 1) % 3, component = (face + 1) % 3;
        double area = gsl_pow_2(options.spacing), sum = 0.0, moment = 0.0, x[3];
        for (int k = 0; k < 3; k++)
            if (k != face / 2) area *= options.nodes[k];
        options.load[face].traction[component] = 2.0;
        options.load[face].gradient[along] = 0.1;
        CHECK_OK(pdmc_solid_create(&options, &solid));
        const size_t n = pdmc_solid_nodes(solid);
        const double *f = pdmc_solid_traction_force(solid) + (size_t)component * n;
        for (size_t i = 0; i < n; i++) {
            pdmc_solid_position(solid, i, x);
            sum += f[i] * gsl_pow_3(options.spacing);
            moment += x[along] * f[i] * gsl_pow_3(options.spacing);
        }
        CHECK_NEAR(sum, 2.0 * area, 1e-12 * area);
        const double width = gsl_pow_2(options.nodes[along]) - 1.0; // of equal steps between the outermost nodes
        CHECK_NEAR(moment, 2.0 * 0.1 * area * gsl_pow_2(options.spacing) * width / 12.0, 1e-12 * area);
        pdmc_solid_destroy(solid);
    }
}

/// Under the middle of a face, farther than the horizon from its sides, each layer of cells feels the mean over its depths
/// of f_L integrated over the whole disc: the normal strain of a uniform bar.
static void each_layer_has_its_share(void **state)
{
    (void)state;
    pdmc_solid_options options = BLOCK;
    pdmc_solid *solid;
    const double horizon = options.horizon, h = options.spacing, e = 2.0 / options.youngs_modulus;
    const double strain[3][3] = {{-0.25 * e, 0.0, 0.0}, {0.0, -0.25 * e, 0.0}, {0.0, 0.0, e}};
    const double micromodulus = 12.0 * options.youngs_modulus / (M_PI * gsl_pow_4(horizon));
    double depth[POINTS], depth_weight[POINTS], at[POINTS], weight[POINTS];
    options.nodes[1] = 9;
    options.load[5].traction[2] = 2.0;
    CHECK_OK(pdmc_solid_create(&options, &solid));
    const size_t n = pdmc_solid_nodes(solid);
    const double *f = pdmc_solid_traction_force(solid) + 2 * n;
    CHECK_OK(pdmc_gauss_legendre(POINTS, 0.0, 1.0, at, weight));
    for (int layer = 0; layer < 4; layer++) {
        double want = 0.0;
        if (layer < 3) CHECK_OK(pdmc_gauss_legendre(POINTS, layer * h, (layer + 1) * h, depth, depth_weight));
        for (int i = 0; i < POINTS && layer < 3; i++) {
            const double disc = sqrt(horizon * horizon - depth[i] * depth[i]);
            for (int j = 0; j < POINTS; j++) { // the normal part does not depend on the angle
                double force[3];
                pdmc_line_to_point_force(strain, horizon, depth[i], (double[]){disc * at[j], 0.0}, force);
                want += depth_weight[i] / h * weight[j] * disc * 2.0 * M_PI * disc * at[j] * micromodulus * force[2];
            }
        }
        const size_t node = ((size_t)(options.nodes[2] - 1 - layer) * 9 + 4) * 9 + 4;
        CHECK_NEAR(f[node], want, 1e-3 * 2.0 / h); // 4 and 12 Gauss points against 24, where f_L falls as log r
    }
    pdmc_solid_destroy(solid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(closed_form), cmocka_unit_test(areal_force_density),
                                       cmocka_unit_test(forces_add_up), cmocka_unit_test(each_layer_has_its_share)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
