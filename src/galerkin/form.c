// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/assembly.h"

pdmc_status pdmc_form_peridynamic(const pdmc_space *space, const pdmc_scalar_kernel *kernel, const pdmc_form_rule *rule,
                                  int threads, pdmc_form *form)
{
    pdmc_status status = PDMC_OK;
    pdmc_assembly assembly = {0};
    *form = (pdmc_form){0};
    PDMC_TRY(pdmc_assembly_create(space, kernel, rule, threads, &assembly));
    PDMC_TRY(pdmc_form_pattern(space, &assembly.neighbours, form));
    pdmc_assembly_add(&assembly, NULL, NULL, &(pdmc_assembled){.form = form});
done:
    pdmc_assembly_clear(&assembly);
    return status;
}

// ---- forms within elements ----

typedef double local_product(const pdmc_element *element, int corners, int a, int b);

static double mass_product(const pdmc_element *element, int corners, int a, int b)
{
    return element->size * (a == b ? 2.0 : 1.0) / (corners * (corners + 1.0));
}

static double gradient_product(const pdmc_element *element, int corners, int a, int b)
{
    (void)corners;
    const double *g = element->gradient[a], *h = element->gradient[b];
    return element->size * (g[0] * h[0] + g[1] * h[1]);
}

static pdmc_status form_local(const pdmc_space *space, local_product *product, pdmc_form *form)
{
    pdmc_status status = PDMC_OK;
    const pdmc_mesh *mesh = space->mesh;
    const int n = mesh->dimension + 1;
    pdmc_neighbours selves = {0};
    *form = (pdmc_form){0};
    PDMC_TRY(pdmc_neighbours_create(mesh, 0.0, &selves));
    PDMC_TRY(pdmc_form_pattern(space, &selves, form));
    for (int e = 0; e < mesh->element_count; e++) {
        const pdmc_element element = pdmc_element_of(mesh, e);
        const int *value = &space->value[n * e];
        for (int a = 0; a < n && !mesh->layer[e]; a++)
            for (int b = 0; b <= a; b++) pdmc_form_add(form, value[a], value[b], product(&element, n, a, b));
    }
done:
    pdmc_neighbours_clear(&selves);
    return status;
}

pdmc_status pdmc_form_mass(const pdmc_space *space, pdmc_form *form)
{
    return form_local(space, mass_product, form);
}

pdmc_status pdmc_form_gradient(const pdmc_space *space, pdmc_form *form)
{
    return form_local(space, gradient_product, form);
}
