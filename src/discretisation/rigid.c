// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/rigid.h"

#include <cblas.h>
#include <math.h>

// Displacement of an unknown in a rigid motion (t_x, t_y, omega).
static double rigid(const double x[], const double motion[3], int unknown)
{
    const double *at = &x[2 * (size_t)(unknown / 2)];
    return unknown % 2 == 0 ? motion[0] - motion[2] * at[1] : motion[1] + motion[2] * at[0];
}

enum { CANDIDATES = 2 * PDMC_RIGID_CANDIDATES }; // unknowns

// Takes out of the other motions what moves an unknown.
static void eliminate(int count, double value[3][CANDIDATES], int pivot, int column)
{
    for (int m = pivot + 1; m < count; m++) {
        const double ratio = value[m][column] / value[pivot][column];
        for (int c = 0; c < CANDIDATES; c++) value[m][c] -= ratio * value[pivot][c];
    }
}

pdmc_status pdmc_rigid_hold(const pdmc_problem *problem, const double x[], const int candidate[PDMC_RIGID_CANDIDATES],
                            uint8_t held[])
{
    int count;
    double motion[3][3], value[3][CANDIDATES];
    const pdmc_status status = pdmc_problem_free_motions(problem, &count, motion);
    if (status != PDMC_OK) return status;
    for (int m = 0; m < count; m++)
        for (int c = 0; c < CANDIDATES; c++) value[m][c] = rigid(x, motion[m], 2 * candidate[c / 2] + c % 2);
    for (int m = 0; m < count; m++) {
        const int best = (int)cblas_idamax(CANDIDATES, value[m], 1);
        held[candidate[best / 2]] |= (uint8_t)(1U << (best % 2));
        eliminate(count, value, m, best);
    }
    return PDMC_OK;
}

// The sum over some points of the product of two fields, one of them a rigid motion.
static double product(int points, const double x[], const uint8_t some[], const double motion[3], const double u[],
                      const double other[3])
{
    double sum = 0.0;
    for (int k = 0; k < 2 * points; k++)
        if (some[k / 2]) sum += rigid(x, motion, k) * (u ? u[k] : rigid(x, other, k));
    return sum;
}

pdmc_status pdmc_rigid_take_out(const pdmc_problem *problem, int points, const double x[], const uint8_t some[],
                                double u[])
{
    int count;
    double motion[3][3];
    const pdmc_status status = pdmc_problem_free_motions(problem, &count, motion);
    if (status != PDMC_OK) return status;
    for (int m = 0; m < count; m++) {
        for (int j = 0; j < m; j++) { // Gram & Schmidt
            const double share = product(points, x, some, motion[j], NULL, motion[m]);
            for (int i = 0; i < 3; i++) motion[m][i] -= share * motion[j][i];
        }
        const double size = sqrt(product(points, x, some, motion[m], NULL, motion[m]));
        for (int i = 0; i < 3; i++) motion[m][i] /= size;
        const double part = product(points, x, some, motion[m], u, NULL);
        for (int k = 0; k < 2 * points; k++) u[k] -= part * rigid(x, motion[m], k);
    }
    return PDMC_OK;
}
