// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"

#include <math.h>

double pdmc_solid_step(const pdmc_solid *solid, const pdmc_solid_motion *motion)
{
    const double bulk_modulus = solid->options.youngs_modulus / 1.5;
    return motion->safety * solid->options.spacing * sqrt(motion->density / bulk_modulus);
}

static pdmc_status check(const pdmc_solid *solid, const pdmc_solid_motion *motion)
{
    PDMC_REQUIRE(motion->density > 0.0 && motion->damping >= 0.0 && motion->steps >= 0,
                 "motion: bad density, damping or steps");
    PDMC_REQUIRE(motion->safety > 0.0 && motion->safety <= 1.0, "motion: the step's safety must be in (0, 1]");
    const double shrink = motion->damping * pdmc_solid_step(solid, motion) / motion->density;
    PDMC_REQUIRE(shrink < 2.0, "a damping of %g makes velocities grow; it must be below %g", motion->damping,
                 2.0 * motion->damping / shrink);
    return PDMC_OK;
}

/// One step of all free nodes; gives twice the kinetic energy density, summed.
static double advance(const pdmc_solid *solid, const pdmc_solid_motion *motion, double step, const double force[],
                      double velocity[], double u[])
{
    double sum = 0.0;
    for (size_t k = 0; k < 3; k++)
        for (size_t i = k * solid->nodes; i < (k + 1) * solid->nodes; i++) {
            if (solid->prescribed[i - k * solid->nodes]) continue;
            velocity[i] += step / motion->density * (force[i] - motion->damping * velocity[i]);
            u[i] += step * velocity[i];
            sum += motion->density * velocity[i] * velocity[i];
        }
    return sum;
}

static double total(const pdmc_solid *solid, const double density[])
{
    double sum = 0.0;
    for (size_t i = 0; i < solid->nodes; i++) sum += density[i];
    return sum;
}

pdmc_status pdmc_solid_move(const pdmc_solid *solid, const pdmc_solid_motion *motion, double u[], double kinetic[],
                            double elastic[])
{
    pdmc_status status = PDMC_OK;
    const double h = solid->options.spacing, volume = h * h * h;
    double *force = NULL, *velocity = NULL, *energy = NULL;
    PDMC_TRY(check(solid, motion));
    const double step = pdmc_solid_step(solid, motion);
    PDMC_NEW(force, 3 * solid->nodes);
    PDMC_NEW(velocity, 3 * solid->nodes);
    PDMC_NEW(energy, solid->nodes);
    kinetic[0] = 0.0;
    for (int n = 0;; n++) {
        pdmc_solid_force(solid, u, force, energy);
        elastic[n] = volume * total(solid, energy);
        if (!isfinite(elastic[n]) || !isfinite(kinetic[n]))
            PDMC_FAIL(PDMC_ERR_SINGULAR, "the motion grows past all bounds at step %d: take a smaller safety", n);
        if (n == motion->steps) break;
        kinetic[n + 1] = 0.5 * volume * advance(solid, motion, step, force, velocity, u);
    }
done:
    pdmc_free(force);
    pdmc_free(velocity);
    pdmc_free(energy);
    return status;
}
