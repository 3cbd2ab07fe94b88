// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

/// Three translations and three rotations about the origin.
static void motion(const pdmc_solid *solid, int mode, double v[])
{
    const size_t n = solid->nodes;
    const size_t a = (size_t)(mode + 1) % 3, b = (size_t)(mode + 2) % 3;
    memset(v, 0, 3 * n * sizeof *v);
    for (size_t i = 0; i < n; i++) {
        double x[3];
        pdmc_solid_position(solid, i, x);
        if (mode < 3) {
            v[(size_t)mode * n + i] = 1.0;
        } else {
            v[a * n + i] = -x[b];
            v[b * n + i] = x[a];
        }
    }
}

pdmc_status solid_rigid_create(const pdmc_solid *solid, solid_rigid *rigid)
{
    pdmc_status status = PDMC_OK;
    const size_t size = 3 * solid->nodes;
    *rigid = (solid_rigid){.size = size};
    for (size_t i = 0; i < solid->nodes; i++)
        if (solid->prescribed[i]) return PDMC_OK;
    PDMC_NEW(rigid->mode, 6 * size);
    for (int mode = 0; mode < 6; mode++) {
        double *v = rigid->mode + (size_t)rigid->count * size;
        motion(solid, mode, v);
        const double first = solid_norm(size, v);
        solid_rigid_remove(rigid, v);
        const double length = solid_norm(size, v);
        if (length <= 1e-12 * first) continue; // a line of nodes has no rotation about itself
        for (size_t i = 0; i < size; i++) v[i] /= length;
        rigid->count++;
    }
done:
    return status;
}

void solid_rigid_remove(const solid_rigid *rigid, double v[])
{
    for (int m = 0; m < rigid->count; m++) {
        const double *mode = rigid->mode + (size_t)m * rigid->size, part = solid_dot(rigid->size, mode, v);
        for (size_t i = 0; i < rigid->size; i++) v[i] -= part * mode[i];
    }
}

void solid_rigid_clear(solid_rigid *rigid)
{
    pdmc_free(rigid->mode);
    *rigid = (solid_rigid){0};
}
