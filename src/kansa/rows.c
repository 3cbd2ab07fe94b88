// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/rows.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

pdmc_status pdmc_row_builder_create(const pdmc_basis *basis, pdmc_row_builder *builder)
{
    pdmc_status status = PDMC_OK;
    *builder = (pdmc_row_builder){.basis = basis};
    PDMC_TRY(pdmc_basis_values_create(basis, &builder->here));
    PDMC_TRY(pdmc_basis_values_create(basis, &builder->there));
    PDMC_NEW(builder->xx, 3 * basis->scalars);
    builder->xy = builder->xx + basis->scalars;
    builder->yy = builder->xy + basis->scalars;
done:
    if (status != PDMC_OK) pdmc_row_builder_clear(builder);
    return status;
}

void pdmc_row_builder_clear(pdmc_row_builder *builder)
{
    pdmc_basis_values_clear(&builder->here);
    pdmc_basis_values_clear(&builder->there);
    pdmc_free(builder->xx);
    *builder = (pdmc_row_builder){0};
}

// The trapezoidal rule of an analytic integrand on a circle errs by rho^-n, rho the ratio of the radius of the nearest
// singularity to that of the circle: a tip, or the complex poles of the multiquadric. The 4 is for e e^T.
static int ring_angles(double r, double clearance, double shape)
{
    const double rho = fmin(clearance / r, (sqrt(r * r + shape * shape) + shape) / r);
    const double digits = 13.0;
    const double wanted = 4.0 + digits * log(10.0) / log(fmax(rho, 1.05));
    return (int)fmin(fmax(ceil(wanted), 12.0), 160.0);
}

static void add_bond(pdmc_row_builder *builder, double cosine, double sine, double weight, double row_x[],
                     double row_y[])
{
    const pdmc_basis *basis = builder->basis;
    const double *here = builder->here.scalar, *there = builder->there.scalar;
    const double wxx = weight * cosine * cosine, wxy = weight * cosine * sine, wyy = weight * sine * sine;
    for (int k = 0; k < basis->scalars; k++) {
        const double difference = here[k] - there[k];
        builder->xx[k] += wxx * difference;
        builder->xy[k] += wxy * difference;
        builder->yy[k] += wyy * difference;
    }
    double *field_x = &row_x[2 * basis->scalars], *field_y = &row_y[2 * basis->scalars];
    for (int l = 0; l < basis->fields; l++) {
        const double along =
            cosine * (builder->here.u[l] - builder->there.u[l]) + sine * (builder->here.v[l] - builder->there.v[l]);
        field_x[l] += weight * cosine * along;
        field_y[l] += weight * sine * along;
    }
}

void pdmc_ring_rows(pdmc_row_builder *builder, const double x[2], double r, double clearance, double row_x[],
                    double row_y[])
{
    const pdmc_basis *basis = builder->basis;
    const size_t scalars = (size_t)basis->scalars;
    memset(builder->xx, 0, 3 * scalars * sizeof(double));
    memset(row_x, 0, (size_t)basis->unknowns * sizeof(double));
    memset(row_y, 0, (size_t)basis->unknowns * sizeof(double));

    pdmc_basis_evaluate(basis, x, x, &builder->here);
    const int angles = ring_angles(r, clearance, basis->shape);
    for (int i = 0; i < angles; i++) {
        const double theta = 2.0 * M_PI * (i + 0.5) / angles, cosine = cos(theta), sine = sin(theta);
        const double end[2] = {x[0] + r * cosine, x[1] + r * sine};
        pdmc_basis_evaluate(basis, end, x, &builder->there);
        add_bond(builder, cosine, sine, 2.0 * M_PI / angles, row_x, row_y);
    }
    memcpy(row_x, builder->xx, scalars * sizeof(double));
    memcpy(row_x + scalars, builder->xy, scalars * sizeof(double));
    memcpy(row_y, builder->xy, scalars * sizeof(double));
    memcpy(row_y + scalars, builder->yy, scalars * sizeof(double));
}

// Coefficients of one traction component: ux_x * u_x + vy_y * v_y and so on, for scalars and fields alike.
static void traction_row(const pdmc_basis *basis, const pdmc_basis_values *by_x, const pdmc_basis_values *by_y,
                         double ux, double uy, double vx, double vy, double row[])
{
    const int n = basis->scalars;
    for (int k = 0; k < n; k++) {
        row[k] = ux * by_x->scalar[k] + uy * by_y->scalar[k];
        row[n + k] = vx * by_x->scalar[k] + vy * by_y->scalar[k];
    }
    for (int l = 0; l < basis->fields; l++)
        row[2 * n + l] = ux * by_x->u[l] + uy * by_y->u[l] + vx * by_x->v[l] + vy * by_y->v[l];
}

void pdmc_traction_rows(pdmc_row_builder *builder, const double x[2], const double anchor[2], const double normal[2],
                        double row_x[], double row_y[])
{
    const pdmc_basis *basis = builder->basis;
    const double mu = basis->shear_modulus, nx = mu * normal[0], ny = mu * normal[1];
    pdmc_basis_gradient(basis, x, anchor, &builder->here, &builder->there);
    traction_row(basis, &builder->here, &builder->there, 3.0 * nx, ny, ny, nx, row_x);
    traction_row(basis, &builder->here, &builder->there, ny, nx, nx, 3.0 * ny, row_y);
}

void pdmc_displacement_rows(pdmc_row_builder *builder, const double x[2], const double anchor[2], double row_x[],
                            double row_y[])
{
    const pdmc_basis *basis = builder->basis;
    const size_t n = (size_t)basis->scalars, fields = (size_t)basis->fields;
    pdmc_basis_evaluate(basis, x, anchor, &builder->here);
    memset(row_x, 0, (size_t)basis->unknowns * sizeof(double));
    memset(row_y, 0, (size_t)basis->unknowns * sizeof(double));
    memcpy(row_x, builder->here.scalar, n * sizeof(double));
    memcpy(row_y + n, builder->here.scalar, n * sizeof(double));
    memcpy(row_x + 2 * n, builder->here.u, fields * sizeof(double));
    memcpy(row_y + 2 * n, builder->here.v, fields * sizeof(double));
}
