// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "particles/particles_impl.h"

#include <float.h>
#include <math.h>

static double length_of(double *const v[PDMC_AXES], double *const other[PDMC_AXES], size_t cell)
{
    double square = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        const double part = v[a][cell] - (other ? other[a][cell] : 0.0);
        square += part * part;
    }
    return sqrt(square);
}

/// The forces of a node whose bonds are all stretched by a rounding: where none is larger, all that there is is rounding.
static double rounding_of(const pdmc_particles *p)
{
    double most = 0.0;
    for (int m = 0; m < p->material_count; m++) most = fmax(most, p->laws[m].micromodulus);
    return 0.5 * (double)FLT_EPSILON * most * p->nodes.heaviest;
}

pdmc_status pdmc_particles_precision(pdmc_particles *p, double *difference)
{
    pdmc_status status = PDMC_OK;
    double *in_single[PDMC_AXES] = {NULL}, *in_double[PDMC_AXES] = {NULL};
    double largest = rounding_of(p), farthest = 0.0;
    *difference = 0.0;
    if (!p->is_single) return PDMC_OK;
    for (int a = 0; a < PDMC_AXES; a++) {
        PDMC_NEW(in_single[a], p->nodes.cells + PDMC_LANES);
        PDMC_NEW(in_double[a], p->nodes.cells + PDMC_LANES);
    }
    pdmc_particles_find_forces_in(p, PDMC_PRECISION_SINGLE, in_single);
    pdmc_particles_find_forces_in(p, PDMC_PRECISION_DOUBLE, in_double);
    for (int k = 0; k < p->nodes.node_count; k++) {
        farthest = fmax(farthest, length_of(in_single, in_double, p->nodes.cell[k]));
        largest = fmax(largest, length_of(in_double, NULL, p->nodes.cell[k]));
    }
    *difference = farthest / largest;
done:
    for (int a = 0; a < PDMC_AXES; a++) {
        pdmc_free(in_single[a]);
        pdmc_free(in_double[a]);
    }
    return status;
}
