// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/energy.h"

#include "base/base_impl.h"
#include "discretisation/crossings.h"

static pdmc_status open_rows(const void *method, void **context)
{
    pdmc_status status = PDMC_OK;
    const pdmc_kansa *kansa = method;
    pdmc_row_builder *builder = NULL;
    PDMC_NEW(builder, 1);
    *context = builder;
    PDMC_TRY(pdmc_row_builder_create(&kansa->basis, builder));
done:
    return status;
}

static void displacement_rows(void *context, const double x[2], double row_u[], double row_v[])
{
    pdmc_displacement_rows(context, x, x, row_u, row_v);
}

static void close_rows(void *context)
{
    if (context) pdmc_row_builder_clear(context);
    pdmc_free(context);
}

pdmc_status pdmc_kansa_energy(const pdmc_kansa *kansa, const double coefficients[], pdmc_affine *model)
{
    const pdmc_displacement_functional displacement = {kansa->unknowns, kansa, open_rows, displacement_rows,
                                                       close_rows};
    return pdmc_affine_fill_crossings(kansa->problem, &displacement, coefficients, kansa->threads, model);
}
