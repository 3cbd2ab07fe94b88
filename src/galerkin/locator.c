// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/element_bins.h"
#include "galerkin/element.h"

#include <math.h>

struct pdmc_locator {
    const pdmc_mesh *mesh;
    pdmc_element_bins bins;
};

pdmc_status pdmc_locator_create(const pdmc_mesh *mesh, pdmc_locator **locator)
{
    pdmc_status status = PDMC_OK;
    pdmc_locator *made = NULL;
    *locator = NULL;
    PDMC_NEW(made, 1);
    made->mesh = mesh;
    PDMC_TRY(pdmc_element_bins_create(mesh, 0.0, &made->bins));
    *locator = made;
    made = NULL;
done:
    pdmc_locator_destroy(&made);
    return status;
}

void pdmc_locator_destroy(pdmc_locator **locator)
{
    if (!*locator) return;
    pdmc_element_bins_clear(&(*locator)->bins);
    pdmc_free(*locator);
    *locator = NULL;
}

static bool contains(const pdmc_mesh *mesh, int e, const double x[2], double at[PDMC_CORNERS])
{
    const double rounding = 1e-10; // of barycentric coordinates, so that no point falls between two elements
    const pdmc_element element = pdmc_element_of(mesh, e);
    bool is_in = true;
    pdmc_element_coordinates(&element, mesh->dimension, x, at);
    for (int a = 0; a <= mesh->dimension; a++) is_in = is_in && at[a] >= -rounding;
    return is_in;
}

double pdmc_locator_value(const pdmc_locator *locator, const pdmc_space *space, const double u[], const double x[])
{
    const pdmc_element_bins *b = &locator->bins;
    const int n = locator->mesh->dimension + 1;
    const double place[2] = {x[0], n == 3 ? x[1] : 0.0};
    const int i = pdmc_element_bin(b, 0, place[0]), j = pdmc_element_bin(b, 1, place[1]);
    double at[PDMC_CORNERS], value = 0.0;
    for (int q = j > 0 ? j - 1 : 0; q <= j + 1 && q < b->count[1]; q++)
        for (int p = i > 0 ? i - 1 : 0; p <= i + 1 && p < b->count[0]; p++)
            for (int e = b->first[q * b->count[0] + p]; e >= 0; e = b->next[e]) {
                if (hypot(b->middle[e][0] - place[0], b->middle[e][1] - place[1]) > 1.0001 * b->radius[e]) continue;
                if (!contains(locator->mesh, e, place, at)) continue;
                for (int a = 0; a < n; a++) value += at[a] * u[space->value[n * e + a]];
                return value;
            }
    return NAN;
}
