// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/overlap.h"

#include "base/base_impl.h"
#include "field/polynomials.h"
#include "pdmc/quadrature.h"

#include <cblas.h>
#include <math.h>

enum { POINTS = 12 }; // of a Gauss rule for the kernel on a panel whose ends are as 1 to 2

int pdmc_parity_count(int degree, int parity)
{
    return (degree - parity) / 2 + 1;
}

/// The least of the numbers of points, not below the one that is needed, of which GSL has the Gauss rule to full accuracy;
/// others it finds to 1e-10 only.
static int tabulated(int needed)
{
    static const int known[] = {8, 12, 16, 20, 32, 64, 96, 128, 256, 512};
    int i = 0;
    while (known[i] < needed) i++;
    return known[i];
}

/// The rule of each panel, [0, finest], [finest, 2 finest], ... [length / 2, length], whose points grow with the part of the
/// polynomials' waves that lies in it: the last, where they oscillate towards the end, integrates o itself exactly.
/// @param[out] r, weight  the separations and their weights, or NULL to count them only
static pdmc_status place_separations(double length, int degree, double finest, int *count, double r[], double weight[])
{
    const int halvings = (int)fmax(ceil(log2(length / finest)), 0.0);
    double lower = 0.0;
    *count = 0;
    for (int h = halvings; h >= 0; h--) {
        const double upper = ldexp(length, -h);
        const int points = tabulated(POINTS + (int)ldexp(degree, -h));
        if (r) {
            const pdmc_status status = pdmc_gauss_legendre(points, lower, upper, &r[*count], &weight[*count]);
            if (status) return status;
        }
        *count += points;
        lower = upper;
    }
    return PDMC_OK;
}

/// o_mm'(r) / 2 [degree + 1, degree + 1], by a Gauss rule on [0, 1] of more than `degree` points, which is exact.
static void overlap_at(double length, int degree, double r, int points, const double point[],
                       const double point_weight[], double near_values[], double far_values[], double product[])
{
    const int n = degree + 1;
    for (int i = 0; i < points; i++) {
        const double x = -0.5 * length + (length - r) * point[i];
        pdmc_legendre(degree, length, x, &near_values[i * n]);
        pdmc_legendre(degree, length, x + r, &far_values[i * n]);
        cblas_dscal(n, (length - r) * point_weight[i], &near_values[i * n], 1);
    }
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, points, 1.0, near_values, n, far_values, n, 0.0, product,
                n);
}

static void scatter(pdmc_overlap *overlap, int separation, double weight, const double product[])
{
    const int all = overlap->degree + 1;
    for (int e = 0; e <= 1; e++) {
        const int n = pdmc_parity_count(overlap->degree, e);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                const int p = e + 2 * i, q = e + 2 * j;
                overlap->overlap[e][(size_t)(i * n + j) * (size_t)overlap->count + (size_t)separation] =
                    2.0 * weight * product[p * all + q];
            }
    }
}

pdmc_status pdmc_overlap_create(double length, int degree, double finest, pdmc_overlap *overlap)
{
    pdmc_status status = PDMC_OK;
    const int n = degree + 1, points = tabulated(n);
    int count;
    double *weight = NULL, *point = NULL, *product = NULL, *near_values = NULL, *far_values = NULL;
    PDMC_TRY(place_separations(length, degree, finest, &count, NULL, NULL));
    *overlap = (pdmc_overlap){.degree = degree, .count = count};
    PDMC_NEW(weight, count);
    PDMC_NEW(point, 2 * points);
    PDMC_NEW(product, n * n);
    PDMC_NEW(near_values, points * n);
    PDMC_NEW(far_values, points * n);
    PDMC_NEW(overlap->r, count);
    for (int e = 0; e <= 1; e++) {
        const size_t pairs = (size_t)pdmc_parity_count(degree, e) * (size_t)pdmc_parity_count(degree, e);
        PDMC_NEW(overlap->overlap[e], pairs * (size_t)count);
    }

    PDMC_TRY(place_separations(length, degree, finest, &count, overlap->r, weight));
    PDMC_TRY(pdmc_gauss_legendre(points, 0.0, 1.0, point, point + points));
    for (int i = 0; i < count; i++) {
        overlap_at(length, degree, overlap->r[i], points, point, point + points, near_values, far_values, product);
        scatter(overlap, i, weight[i], product);
    }

done:
    pdmc_free(far_values);
    pdmc_free(near_values);
    pdmc_free(product);
    pdmc_free(point);
    pdmc_free(weight);
    if (status) pdmc_overlap_clear(overlap);
    return status;
}

void pdmc_overlap_clear(pdmc_overlap *overlap)
{
    pdmc_free(overlap->r);
    pdmc_free(overlap->overlap[0]);
    pdmc_free(overlap->overlap[1]);
    *overlap = (pdmc_overlap){0};
}
