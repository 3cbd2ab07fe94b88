// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/law_bonds.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

pdmc_status pdmc_law_bonds_create(const pdmc_space *space, const pdmc_scalar_kernel *kernel, const pdmc_bond_law *law,
                              const pdmc_form_rule *rule, int threads, pdmc_law_bonds **bonds)
{
    pdmc_status status = PDMC_OK;
    pdmc_law_bonds *made = NULL;
    *bonds = NULL;
    PDMC_REQUIRE(rule->outer != PDMC_OUTER_EXACT && rule->inner != PDMC_INNER_EXACT,
                 "integrals over bonds with a law cannot be exact");
    PDMC_REQUIRE(law->kind == PDMC_LAW_LINEAR || (law->stretch > 0.0 && isfinite(law->stretch)),
                 "a stretch of %g of the law is not > 0", law->stretch);
    PDMC_NEW(made, 1);
    made->law = *law;
    made->kernel = *kernel;
    PDMC_TRY(pdmc_assembly_create(space, &made->kernel, rule, threads, &made->assembly));
    *bonds = made;
    made = NULL;
done:
    pdmc_law_bonds_destroy(&made);
    return status;
}

void pdmc_law_bonds_destroy(pdmc_law_bonds **bonds)
{
    if (!*bonds) return;
    pdmc_assembly_clear(&(*bonds)->assembly);
    pdmc_free(*bonds);
    *bonds = NULL;
}

void pdmc_law_bonds_force(const pdmc_law_bonds *bonds, const double u[], double force[], double *energy)
{
    *energy = 0.0;
    memset(force, 0, (size_t)bonds->assembly.space->free_count * sizeof *force);
    pdmc_assembly_add(&bonds->assembly, &bonds->law, u, &(pdmc_assembled){.force = force, .energy = energy});
}

pdmc_status pdmc_law_bonds_tangent(const pdmc_law_bonds *bonds, const double u[], pdmc_form *form)
{
    const pdmc_assembly *a = &bonds->assembly;
    const pdmc_status status = pdmc_form_pattern(a->space, &a->neighbours, form);
    if (status == PDMC_OK) pdmc_assembly_add(a, &bonds->law, u, &(pdmc_assembled){.form = form});
    return status;
}
