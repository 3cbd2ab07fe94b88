// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdint.h>

static pdmc_status force_of(void *context, const double x[], double force[])
{
    pdmc_solid_force(context, x, force, NULL);
    return PDMC_OK;
}

pdmc_status pdmc_solid_relax(const pdmc_solid *solid, double tolerance, int max_steps, double damping, double u[],
                             pdmc_relaxation_state *state)
{
    pdmc_status status = PDMC_OK;
    const size_t n = 3 * solid->nodes;
    double *mass = NULL, *force = NULL, squared = 0.0;
    PDMC_NEW(mass, n);
    PDMC_NEW(force, n);
    pdmc_solid_force(solid, u, force, NULL);
    for (size_t i = 0; i < n; i++) {
        const bool held = solid->prescribed[i % solid->nodes];
        mass[i] = held ? INFINITY : 0.25 * 1.1 * 1.1 * solid->row_sum[i];
        if (!held) squared += force[i] * force[i];
    }
    const pdmc_relaxation_model model = {n, force_of, (void *)(uintptr_t)solid, mass};
    const pdmc_relaxation_options options = {squared > 0.0 ? sqrt(squared) : 1.0, tolerance, max_steps, damping};
    PDMC_TRY(pdmc_relax(&model, &options, u, NULL, NULL, state));
done:
    pdmc_free(mass);
    pdmc_free(force);
    return status;
}
