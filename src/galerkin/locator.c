// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/element.h"
#include "mesh/locate.h"

#include <math.h>

struct pdmc_locator {
    pdmc_mesh_locator elements;
};

pdmc_status pdmc_locator_create(const pdmc_mesh *mesh, pdmc_locator **locator)
{
    pdmc_status status = PDMC_OK;
    pdmc_locator *made = NULL;
    *locator = NULL;
    PDMC_NEW(made, 1);
    PDMC_TRY(pdmc_mesh_locator_create(mesh, &made->elements));
    *locator = made;
    made = NULL;
done:
    pdmc_locator_destroy(&made);
    return status;
}

void pdmc_locator_destroy(pdmc_locator **locator)
{
    if (!*locator) return;
    pdmc_mesh_locator_clear(&(*locator)->elements);
    pdmc_free(*locator);
    *locator = NULL;
}

double pdmc_locator_value(const pdmc_locator *locator, const pdmc_space *space, const double u[], const double x[])
{
    const double rounding = 1e-10; // of barycentric coordinates
    const pdmc_mesh *mesh = locator->elements.mesh;
    const int corners = mesh->dimension + 1;
    double depth, at[PDMC_CORNERS], value = 0.0;
    const int e = pdmc_mesh_locate(&locator->elements, x, &depth);
    if (e < 0 || depth < -rounding) return NAN;
    const pdmc_element element = pdmc_element_of(mesh, e);
    pdmc_element_coordinates(&element, mesh->dimension, x, at);
    for (int a = 0; a < corners; a++) value += at[a] * u[space->value[corners * e + a]];
    return value;
}
