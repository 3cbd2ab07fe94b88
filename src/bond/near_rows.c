// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/near_rows.h"

#include "discretisation/interaction.h"

#include <cblas.h>
#include <math.h>

enum { MODES = 2 };

// A state of each mode: body forces that pull the plate apart across the tip's crack, and shear it, outside of the circle
// by which the stress intensities are known, and a horizon more. u: [MODES, unknowns]
static pdmc_status solve_states(const pdmc_bond *bond, int tip, double u[])
{
    const pdmc_tip_frame frame = pdmc_tip_frame_of(bond->problem, tip);
    const double tangent[2] = {frame.cosine, frame.sine}, normal[2] = {-frame.sine, frame.cosine};
    const double clear = pdmc_bond_interaction_radius(bond->problem, tip) + bond->problem->solver.horizon;
    for (int node = 0; node < bond->plate.grid.nodes; node++) {
        double x[2];
        pdmc_bond_grid_node(&bond->plate.grid, node, x);
        for (int i = 0; i < 2; i++) x[i] -= frame.position[i];
        if (hypot(x[0], x[1]) <= clear) continue;
        const double along = cblas_ddot(2, x, 1, tangent, 1), left = cblas_ddot(2, x, 1, normal, 1);
        for (int i = 0; i < 2; i++) {
            if (bond->plate.grid.held[node] & (1U << i)) continue;
            u[2 * node + i] = left * normal[i];
            u[bond->unknowns + 2 * node + i] = left * tangent[i] + along * normal[i];
        }
    }
    return pdmc_sparse_factor_solve(bond->factor, MODES, u, u);
}

// K [row, state]
static void measure(int n, const double row[], const double u[], double K[MODES * MODES])
{
    for (int k = 0; k < MODES * MODES; k++) K[k] = cblas_ddot(n, &row[k / MODES * n], 1, &u[k % MODES * n], 1);
}

// row = A row with A the matrix that turns what the rows measure into what they should.
static pdmc_status calibrate(int n, const double want[MODES * MODES], const double got[MODES * MODES], double row[])
{
    const double det = got[0] * got[3] - got[1] * got[2];
    if (det == 0.0) return pdmc_raise(PDMC_ERR_SINGULAR, "no forces open and shear a crack near its tip");
    const double inverse[MODES * MODES] = {got[3] / det, -got[1] / det, -got[2] / det, got[0] / det};
    double A[MODES * MODES];
    for (int i = 0; i < MODES; i++)
        for (int j = 0; j < MODES; j++)
            A[MODES * i + j] = want[MODES * i] * inverse[j] + want[MODES * i + 1] * inverse[MODES + j];
    for (int k = 0; k < n; k++) {
        const double first = row[k], second = row[n + k];
        row[k] = A[0] * first + A[1] * second;
        row[n + k] = A[2] * first + A[3] * second;
    }
    return PDMC_OK;
}

// The mean keeps its energy to rounding: between the two states and it there is some 0.2 % of the intensity.
static void keep_mean(const pdmc_bond *bond, const double far[], double near[])
{
    const int n = bond->unknowns;
    const double want = hypot(cblas_ddot(n, far, 1, bond->mean, 1), cblas_ddot(n, &far[n], 1, bond->mean, 1));
    const double got = hypot(cblas_ddot(n, near, 1, bond->mean, 1), cblas_ddot(n, &near[n], 1, bond->mean, 1));
    if (got > 0.0) cblas_dscal(MODES * n, want / got, near, 1);
}

pdmc_status pdmc_bond_near_rows(const pdmc_bond *bond, int tip, const double far[], double near[])
{
    pdmc_status status = PDMC_OK;
    const int n = bond->unknowns;
    const double wanted = fmax(0.5 * bond->problem->solver.horizon, 2.5 * bond->plate.grid.spacing);
    double *u = NULL, want[MODES * MODES], got[MODES * MODES];
    PDMC_NEW(u, MODES * (size_t)n);
    const double radius = pdmc_interaction_radius(bond->problem, tip, wanted);
    PDMC_TRY(pdmc_bond_interaction_rows(bond, tip, radius, near, near + n));
    PDMC_TRY(solve_states(bond, tip, u));
    measure(n, far, u, want);
    measure(n, near, u, got);
    PDMC_TRY(calibrate(n, want, got, near));
    keep_mean(bond, far, near);
done:
    pdmc_free(u);
    return status;
}
