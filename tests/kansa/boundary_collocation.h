// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A second method for a central straight crack in a rectangular plate under tractions: Muskhelishvili's potentials
///     phi = X sum p_m (z/R)^m + sum q_m R (z/R)^(m+1),  omega = X sum p_m (z/R)^m - sum q_m R (z/R)^(m+1),
/// X = sqrt(z - a) sqrt(z + a), which leave the crack free of traction exactly; the coefficients by least squares from
/// the tractions at Chebyshev points of the four sides. No basis, no point and no line of code in common with the
/// library.

#include "check.h"

#include <complex.h>
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

enum { REFERENCE_ORDERS = 24, REFERENCE_POINTS = 100 };

typedef struct {
    double half_length, angle, radius;
    double coefficients[4 * REFERENCE_ORDERS];
    double K[2], residual;
} reference;

// sigma_x, sigma_y, tau of the unit potential k at z (in the crack's frame), turned into the plate's frame.
static void reference_stress(const reference *r, int k, double complex zg, double stress[3])
{
    const int part = k / REFERENCE_ORDERS, m = k % REFERENCE_ORDERS;
    const double complex unit = part % 2 ? I : 1.0, z = zg * cexp(-I * r->angle), zc = conj(z);
    double complex Phi = 0, dPhi = 0, Omega = 0;
    const double R = r->radius, a = r->half_length;
    for (int at = 0; at < 2; at++) { // derivatives of phi at z, of omega at the conjugate point
        const double complex s = at ? zc : z, X = csqrt(s - a) * csqrt(s + a);
        const double complex g = cpow(s / R, m), dg = m ? m / R * cpow(s / R, m - 1) : 0.0;
        const double complex ddg = m > 1 ? m * (m - 1) / (R * R) * cpow(s / R, m - 2) : 0.0;
        double complex d, dd;
        if (part < 2) {
            d = s / X * g + X * dg;
            dd = (1.0 / X - s * s / (X * X * X)) * g + 2.0 * s / X * dg + X * ddg;
        } else {
            d = (m + 1) * g;
            dd = (m + 1) * dg;
        }
        if (at) {
            Omega = (part < 2 ? 1.0 : -1.0) * unit * d;
        } else {
            Phi = unit * d;
            dPhi = unit * dd;
        }
    }
    const double sum = 4.0 * creal(Phi);
    const double complex T = Phi + Omega + (z - zc) * conj(dPhi); // sigma_y - i tau
    const double sy = creal(T), tau = -cimag(T), sx = sum - sy, c = cos(r->angle), n = sin(r->angle);
    stress[0] = sx * c * c + sy * n * n - 2.0 * tau * n * c;
    stress[1] = sx * n * n + sy * c * c + 2.0 * tau * n * c;
    stress[2] = (sx - sy) * n * c + tau * (c * c - n * n);
}

/// Unit tension along y on a plate of the given size; K_I and K_II of both tips, equal by symmetry.
static inline void reference_solve(reference *r, double size, double half_length, double angle)
{
    enum { ROWS = 8 * REFERENCE_POINTS, COLUMNS = 4 * REFERENCE_ORDERS };
    double *A = calloc((size_t)ROWS * COLUMNS, sizeof *A), *F = calloc(ROWS, sizeof *F);
    double *A0 = calloc((size_t)ROWS * COLUMNS, sizeof *A0), *F0 = calloc(ROWS, sizeof *F0);
    assert_true(A && F && A0 && F0);
    *r = (reference){.half_length = half_length, .angle = angle, .radius = size / sqrt(2.0)};
    int row = 0;
    for (int side = 0; side < 4; side++) {
        const double nx = side == 0 ? 1 : side == 1 ? -1 : 0, ny = side == 2 ? 1 : side == 3 ? -1 : 0;
        for (int i = 0; i < REFERENCE_POINTS; i++, row += 2) {
            const double t = 0.5 * size * cos(acos(-1.0) * (i + 0.5) / REFERENCE_POINTS);
            const double complex z = CMPLX(nx != 0 ? nx * size / 2 : t, ny != 0 ? ny * size / 2 : t);
            for (int k = 0; k < COLUMNS; k++) {
                double s[3];
                reference_stress(r, k, z, s);
                A[k * ROWS + row] = s[0] * nx + s[2] * ny;
                A[k * ROWS + row + 1] = s[2] * nx + s[1] * ny;
            }
            F[row + 1] = ny;
        }
    }
    memcpy(A0, A, (size_t)ROWS * COLUMNS * sizeof *A);
    memcpy(F0, F, ROWS * sizeof *F);
    double singular[COLUMNS];
    int rank;
    assert_int_equal(LAPACKE_dgelsd(LAPACK_COL_MAJOR, ROWS, COLUMNS, 1, A, ROWS, F, ROWS, singular, 1e-14, &rank), 0);
    memcpy(r->coefficients, F, sizeof r->coefficients);
    for (int i = 0; i < ROWS; i++) {
        double sum = -F0[i];
        for (int k = 0; k < COLUMNS; k++) sum += A0[k * ROWS + i] * F[k];
        r->residual = fmax(r->residual, fabs(sum));
    }
    double complex f = 0.0;
    for (int m = 0; m < REFERENCE_ORDERS; m++)
        f += CMPLX(F[m], F[REFERENCE_ORDERS + m]) * pow(half_length / r->radius, m);
    const double complex K = 2.0 * sqrt(acos(-1.0) * half_length) * f;
    r->K[0] = creal(K);
    r->K[1] = -cimag(K);
    free(A);
    free(F);
    free(A0);
    free(F0);
}
