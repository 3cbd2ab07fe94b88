// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/basis.h"

#include "base/base_impl.h"

#include <complex.h>
#include <math.h>
#include <string.h>

static const double kappa = 2.0; // (3 - nu) / (1 + nu) with nu = 1/3, and 3 - 4 nu with nu = 1/4

pdmc_status pdmc_basis_complete(pdmc_basis *basis, int crack_count, const pdmc_crack cracks[])
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(basis->cracks, crack_count);
    basis->crack_count = crack_count;
    for (int c = 0; c < crack_count; c++) {
        const double dx = cracks[c].to[0] - cracks[c].from[0], dy = cracks[c].to[1] - cracks[c].from[1];
        const double length = hypot(dx, dy);
        basis->cracks[c] = (pdmc_crack_frame){
            .centre = {0.5 * (cracks[c].from[0] + cracks[c].to[0]), 0.5 * (cracks[c].from[1] + cracks[c].to[1])},
            .half_length = 0.5 * length,
            .cosine = dx / length,
            .sine = dy / length,
        };
    }
    basis->monomials = (basis->degree + 1) * (basis->degree + 2) / 2;
    basis->scalars = basis->node_count + basis->monomials;
    basis->fields = 4 * (basis->orders + basis->moments) * crack_count;
    basis->unknowns = 2 * basis->scalars + basis->fields;
done:
    return status;
}

void pdmc_basis_clear(pdmc_basis *basis)
{
    pdmc_free(basis->node_x);
    pdmc_free(basis->node_y);
    pdmc_free(basis->cracks);
    *basis = (pdmc_basis){0};
}

pdmc_status pdmc_basis_values_create(const pdmc_basis *basis, pdmc_basis_values *values)
{
    pdmc_status status = PDMC_OK;
    *values = (pdmc_basis_values){0};
    PDMC_NEW(values->scalar, basis->scalars + 2 * basis->fields);
    values->u = values->scalar + basis->scalars;
    values->v = values->u + basis->fields;
done:
    return status;
}

void pdmc_basis_values_clear(pdmc_basis_values *values)
{
    pdmc_free(values->scalar);
    *values = (pdmc_basis_values){0};
}

static double power(double x, int n)
{
    double product = 1.0;
    for (int i = 0; i < n; i++) product *= x;
    return product;
}

static void evaluate_scalars(const pdmc_basis *basis, const double x[2], double value[])
{
    const double psi = basis->shape;
    for (int k = 0; k < basis->node_count; k++) {
        const double dx = x[0] - basis->node_x[k], dy = x[1] - basis->node_y[k];
        value[k] = psi / sqrt(dx * dx + dy * dy + psi * psi);
    }
    const double s = x[0] / basis->scale, t = x[1] / basis->scale;
    int k = basis->node_count;
    for (int degree = 0; degree <= basis->degree; degree++)
        for (int j = 0; j <= degree; j++) value[k++] = power(s, degree - j) * power(t, j);
}

static void differentiate_scalars(const pdmc_basis *basis, const double x[2], double by_x[], double by_y[])
{
    const double psi = basis->shape;
    for (int k = 0; k < basis->node_count; k++) {
        const double dx = x[0] - basis->node_x[k], dy = x[1] - basis->node_y[k];
        const double d2 = dx * dx + dy * dy + psi * psi, slope = -psi / (d2 * sqrt(d2));
        by_x[k] = slope * dx;
        by_y[k] = slope * dy;
    }
    const double s = x[0] / basis->scale, t = x[1] / basis->scale;
    int k = basis->node_count;
    for (int degree = 0; degree <= basis->degree; degree++) {
        for (int j = 0; j <= degree; j++, k++) {
            const int i = degree - j;
            by_x[k] = i ? i * power(s, i - 1) * power(t, j) / basis->scale : 0.0;
            by_y[k] = j ? j * power(s, i) * power(t, j - 1) / basis->scale : 0.0;
        }
    }
}

static double complex local(const pdmc_crack_frame *crack, const double x[2])
{
    const double dx = x[0] - crack->centre[0], dy = x[1] - crack->centre[1];
    return CMPLX(crack->cosine * dx + crack->sine * dy, crack->cosine * dy - crack->sine * dx);
}

// What the fields of one crack need at a point: z, X = sqrt(z - a) sqrt(z + a) on the anchor's sheet, w = (z - X) / a.
typedef struct {
    double complex z, root, w;
} crack_point;

static crack_point continue_from(const pdmc_crack_frame *crack, const double x[2], const double anchor[2])
{
    const double a = crack->half_length;
    const double complex z = local(crack, x);
    double complex root;
    if (x[0] == anchor[0] && x[1] == anchor[1]) {
        root = csqrt(z - a) * csqrt(z + a);
    } else {
        // Within a disc about the anchor that holds no tip both quotients stay right of the imaginary axis, or nearly
        // so, and the principal root is the analytic one.
        const double complex z0 = local(crack, anchor);
        root = csqrt(z0 - a) * csqrt(z0 + a) * csqrt((z - a) / (z0 - a)) * csqrt((z + a) / (z0 + a));
    }
    // (z - X)(z + X) = a^2: take the form that does not cancel.
    const double complex sum = z + root, difference = z - root;
    return (crack_point){z, root, cabs(sum) >= cabs(difference) ? a / sum : difference / a};
}

// The four fields of an order, 2 mu U = kappa p f - q conj(f) - 2 i y conj(p f'), (p, q) in {(1,0), (i,0), (0,1),
// (0,i)}, turned by the crack's angle.
static void store_fields(const double complex field[4], double complex turn, double u[4], double v[4])
{
    for (int k = 0; k < 4; k++) {
        const double complex value = turn * field[k];
        u[k] = creal(value);
        v[k] = cimag(value);
    }
}

static void evaluate_crack(const pdmc_basis *basis, const pdmc_crack_frame *crack, int orders, const double x[2],
                           const double anchor[2], double u[], double v[])
{
    const crack_point at = continue_from(crack, x, anchor);
    const double complex turn = CMPLX(crack->cosine, crack->sine) / (2.0 * basis->shear_modulus);
    const double y = cimag(at.z);
    double complex f = 1.0;
    for (int m = 1; m <= orders; m++) {
        f *= at.w;
        // At a tip f' is infinite, but y f' is 0.
        const double complex d = at.root == 0.0 ? 0.0 : conj(-m * f / at.root), g = conj(f);
        const double complex field[4] = {kappa * f - 2.0 * I * y * d, I * kappa * f - 2.0 * y * d, -g, -I * g};
        store_fields(field, turn, &u[4 * (m - 1)], &v[4 * (m - 1)]);
    }
}

static void differentiate_crack(const pdmc_basis *basis, const pdmc_crack_frame *crack, const double x[2],
                                const double anchor[2], pdmc_basis_values *by_x, pdmc_basis_values *by_y, int first)
{
    const crack_point at = continue_from(crack, x, anchor);
    const double complex turn = CMPLX(crack->cosine, crack->sine) / (2.0 * basis->shear_modulus);
    const double y = cimag(at.z);
    double complex f = 1.0;
    for (int m = 1; m <= basis->orders; m++) {
        f *= at.w;
        const double complex d = -m * f / at.root;
        const double complex dd = (m * (double)m + m * at.z / at.root) * f / (at.root * at.root);
        const double complex cd = conj(d), cdd = conj(dd);
        const double complex along[4] = {kappa * d - 2.0 * I * y * cdd, I * kappa * d - 2.0 * y * cdd, -cd, -I * cd};
        const double complex across[4] = {
            I * kappa * d - 2.0 * I * cd - 2.0 * y * cdd,
            -kappa * d - 2.0 * cd + 2.0 * I * y * cdd,
            I * cd,
            -cd,
        };
        double complex dx[4], dy[4];
        for (int k = 0; k < 4; k++) {
            dx[k] = crack->cosine * along[k] - crack->sine * across[k];
            dy[k] = crack->sine * along[k] + crack->cosine * across[k];
        }
        const int k = first + 4 * (m - 1);
        store_fields(dx, turn, &by_x->u[k], &by_x->v[k]);
        store_fields(dy, turn, &by_y->u[k], &by_y->v[k]);
    }
}

static void evaluate_moments(const pdmc_basis *basis, const pdmc_crack_frame *crack, const double x[2], int first,
                             int moment, pdmc_basis_values *values)
{
    const double factor = creal(local(crack, x)) / crack->half_length;
    for (int k = 0; k < 4 * basis->moments; k++) {
        values->u[moment + k] = factor * values->u[first + k];
        values->v[moment + k] = factor * values->v[first + k];
    }
}

static void differentiate_moments(const pdmc_basis *basis, const pdmc_crack_frame *crack, const double x[2],
                                  const double anchor[2], int first, int moment, pdmc_basis_values *by_x,
                                  pdmc_basis_values *by_y)
{
    const double a = crack->half_length, factor = creal(local(crack, x)) / a;
    double u[4 * PDMC_MOST_MOMENTS], v[4 * PDMC_MOST_MOMENTS];
    evaluate_crack(basis, crack, basis->moments, x, anchor, u, v);
    for (int k = 0; k < 4 * basis->moments; k++) {
        by_x->u[moment + k] = factor * by_x->u[first + k] + crack->cosine / a * u[k];
        by_x->v[moment + k] = factor * by_x->v[first + k] + crack->cosine / a * v[k];
        by_y->u[moment + k] = factor * by_y->u[first + k] + crack->sine / a * u[k];
        by_y->v[moment + k] = factor * by_y->v[first + k] + crack->sine / a * v[k];
    }
}

int pdmc_basis_moment(const pdmc_basis *basis, int crack, int order)
{
    return 4 * (basis->orders * basis->crack_count + basis->moments * crack + order - 1);
}

void pdmc_basis_evaluate(const pdmc_basis *basis, const double x[2], const double anchor[2], pdmc_basis_values *values)
{
    evaluate_scalars(basis, x, values->scalar);
    for (int c = 0; c < basis->crack_count; c++) {
        const int first = 4 * basis->orders * c;
        evaluate_crack(basis, &basis->cracks[c], basis->orders, x, anchor, &values->u[first], &values->v[first]);
        evaluate_moments(basis, &basis->cracks[c], x, first, pdmc_basis_moment(basis, c, 1), values);
    }
}

void pdmc_basis_gradient(const pdmc_basis *basis, const double x[2], const double anchor[2], pdmc_basis_values *by_x,
                         pdmc_basis_values *by_y)
{
    differentiate_scalars(basis, x, by_x->scalar, by_y->scalar);
    for (int c = 0; c < basis->crack_count; c++) {
        const int first = 4 * basis->orders * c;
        differentiate_crack(basis, &basis->cracks[c], x, anchor, by_x, by_y, first);
        differentiate_moments(basis, &basis->cracks[c], x, anchor, first, pdmc_basis_moment(basis, c, 1), by_x, by_y);
    }
}
