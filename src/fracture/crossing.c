// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/fracture.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { POSITIONS = 8, ANGLES = 16 }; // Gauss points in lambda and theta: G_E to 2e-5 ahead of the tip

static bool inside(const pdmc_plate *plate, const double x[2])
{
    return fabs(x[0]) <= 0.5 * plate->width && fabs(x[1]) <= 0.5 * plate->height;
}

static bool is_whole(const pdmc_problem *problem, const pdmc_crossing_bond *bond)
{
    if (!inside(&problem->plate, bond->start) || !inside(&problem->plate, bond->end)) return false;
    for (int c = 0; c < problem->crack_count; c++)
        if (pdmc_segments_cross(bond->start, bond->end, problem->cracks[c].from, problem->cracks[c].to)) return false;
    return true;
}

pdmc_status pdmc_crossing_bonds(const pdmc_problem *problem, const double x_t[2], double phi,
                                const pdmc_ring_rule *rings, int *count, pdmc_crossing_bond bonds[])
{
    PDMC_REQUIRE(rings->rings <= PDMC_CROSSING_RINGS, "%d rings: at most %d", rings->rings, PDMC_CROSSING_RINGS);
    double lambda[POSITIONS], lambda_weight[POSITIONS], theta[ANGLES], theta_weight[ANGLES];
    pdmc_status status = pdmc_gauss_legendre(POSITIONS, 0.0, 1.0, lambda, lambda_weight);
    if (status == PDMC_OK) status = pdmc_gauss_legendre(ANGLES, 0.0, M_PI, theta, theta_weight);
    if (status != PDMC_OK) return status;
    *count = 0;
    for (int q = 0; q < rings->rings; q++) {
        const double r = rings->radius[q];
        for (int j = 0; j < ANGLES; j++) {
            const double e[2] = {cos(phi + theta[j]), sin(phi + theta[j])};
            for (int i = 0; i < POSITIONS; i++) {
                pdmc_crossing_bond *bond = &bonds[*count];
                *bond = (pdmc_crossing_bond){
                    .start = {x_t[0] - lambda[i] * r * e[0], x_t[1] - lambda[i] * r * e[1]},
                    .end = {x_t[0] + (1.0 - lambda[i]) * r * e[0], x_t[1] + (1.0 - lambda[i]) * r * e[1]},
                    .direction = {e[0], e[1]},
                    .weight = sin(theta[j]) * theta_weight[j] * lambda_weight[i],
                    .ring = q,
                };
                *count += is_whole(problem, bond);
            }
        }
    }
    return PDMC_OK;
}
