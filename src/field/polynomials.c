// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/polynomials.h"

#include "base/base_impl.h"

#include <math.h>

int pdmc_polynomials_count(const pdmc_polynomials *space)
{
    return (space->degree[0] + 1) * (space->degree[1] + 1);
}

void pdmc_legendre(int degree, double length, double x, double value[])
{
    const double t = 2.0 * x / length;
    value[0] = 1.0;
    if (degree > 0) value[1] = t;
    for (int m = 1; m < degree; m++) value[m + 1] = ((2 * m + 1) * t * value[m] - m * value[m - 1]) / (m + 1);
    for (int m = 0; m <= degree; m++) value[m] *= sqrt((2 * m + 1) / length);
}

void pdmc_polynomials_at(const pdmc_polynomials *space, int points, const double x[], double value[])
{
    const int along_x = space->degree[0] + 1, along_y = space->degree[1] + 1;
    double px[PDMC_HIGHEST_DEGREE + 1], py[PDMC_HIGHEST_DEGREE + 1];
    for (int i = 0; i < points; i++) {
        double *row = &value[(size_t)i * (size_t)(along_x * along_y)];
        pdmc_legendre(along_x - 1, space->size[0], x[2 * i], px);
        pdmc_legendre(along_y - 1, space->size[1], x[2 * i + 1], py);
        for (int m = 0; m < along_x; m++)
            for (int n = 0; n < along_y; n++) row[m * along_y + n] = px[m] * py[n];
    }
}

pdmc_status pdmc_polynomials_rule(const pdmc_polynomials *space, pdmc_area_rule *rule)
{
    pdmc_status status = PDMC_OK;
    const int along[2] = {space->degree[0] + 1, space->degree[1] + 1};
    double *x[2] = {NULL, NULL}, *weight[2] = {NULL, NULL};
    *rule = (pdmc_area_rule){.count = along[0] * along[1]};
    PDMC_NEW(rule->x, 2 * rule->count);
    PDMC_NEW(rule->weight, rule->count);
    for (int d = 0; d < 2; d++) {
        PDMC_NEW(x[d], along[d]);
        PDMC_NEW(weight[d], along[d]);
        PDMC_TRY(pdmc_gauss_legendre(along[d], -0.5 * space->size[d], 0.5 * space->size[d], x[d], weight[d]));
    }
    for (int i = 0; i < rule->count; i++) {
        const int m = i / along[1], n = i % along[1];
        rule->x[2 * i] = x[0][m];
        rule->x[2 * i + 1] = x[1][n];
        rule->weight[i] = weight[0][m] * weight[1][n];
    }
done:
    for (int d = 0; d < 2; d++) {
        pdmc_free(x[d]);
        pdmc_free(weight[d]);
    }
    if (status) pdmc_area_rule_clear(rule);
    return status;
}
