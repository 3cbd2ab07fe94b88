// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/fracture.h"

#include <gsl/gsl_math.h>
#include <math.h>

// F_ij = sum_k coefficient[k] m^(2 k + parity), Amestoy & Leblond 1992, table of section 4.
enum { TERMS = 11 };

static const double even_11[TERMS] = {
    1.0,
    -3.0 * M_PI *M_PI / 8.0,
    M_PI *M_PI - 5.0 * M_PI *M_PI *M_PI *M_PI / 128.0,
    M_PI *M_PI / 9.0 - 11.0 * M_PI *M_PI *M_PI *M_PI / 72.0 + 119.0 * M_PI *M_PI *M_PI *M_PI *M_PI *M_PI / 15360.0,
    5.07790,
    -2.88312,
    -0.0925,
    2.996,
    -4.059,
    1.63,
    4.1,
};

static const double odd_12[TERMS] = {
    -3.0 * M_PI / 2.0,
    10.0 * M_PI / 3.0 + M_PI *M_PI *M_PI / 16.0,
    -2.0 * M_PI - 133.0 * M_PI *M_PI *M_PI / 180.0 + 59.0 * M_PI *M_PI *M_PI *M_PI *M_PI / 1280.0,
    12.313906,
    -7.32433,
    1.5793,
    4.0216,
    -6.915,
    4.21,
    4.56,
    0.0,
};

static const double odd_21[TERMS] = {
    M_PI / 2.0,
    -4.0 * M_PI / 3.0 - M_PI *M_PI *M_PI / 48.0,
    -2.0 * M_PI / 3.0 + 13.0 * M_PI *M_PI *M_PI / 30.0 - 59.0 * M_PI *M_PI *M_PI *M_PI *M_PI / 3840.0,
    -6.176023,
    4.44112,
    -1.5340,
    -2.0700,
    4.684,
    -3.95,
    -1.32,
    0.0,
};

static const double even_22[TERMS] = {
    1.0,
    -4.0 - 3.0 * M_PI *M_PI / 8.0,
    8.0 / 3.0 + 29.0 * M_PI *M_PI / 18.0 - 5.0 * M_PI *M_PI *M_PI *M_PI / 128.0,
    -32.0 / 15.0 - 4.0 * M_PI *M_PI / 9.0 - 1159.0 * M_PI *M_PI *M_PI *M_PI / 7200.0 +
        119.0 * M_PI *M_PI *M_PI *M_PI *M_PI *M_PI / 15360.0,
    10.58254,
    -4.78511,
    -1.8804,
    7.280,
    -7.591,
    0.25,
    12.5,
};

static double expansion(const double coefficient[TERMS], double m)
{
    double sum = 0.0;
    for (int k = TERMS - 1; k >= 0; k--) sum = sum * m * m + coefficient[k];
    return sum;
}

static void amestoy_leblond(double kink, double F[4])
{
    const double m = kink / M_PI;
    F[0] = expansion(even_11, m);
    F[1] = m * expansion(odd_12, m);
    F[2] = m * expansion(odd_21, m);
    F[3] = expansion(even_22, m);
}

static void nuismer(double kink, double F[4])
{
    const double c = cos(0.5 * kink), s = sin(0.5 * kink);
    F[0] = c * c * c;
    F[1] = -3.0 * s * c * c;
    F[2] = s * c * c;
    F[3] = c * (1.0 - 3.0 * s * s);
}

void pdmc_kink_factors(double kink, double F[4])
{
    const double angle = remainder(kink, 2.0 * M_PI), limit = copysign(2.0 * M_PI / 3.0, angle);
    double exact[4], near[4];
    if (fabs(angle) <= fabs(limit)) {
        amestoy_leblond(angle, F);
        return;
    }
    amestoy_leblond(limit, exact);
    nuismer(limit, near);
    nuismer(angle, F);
    for (int i = 0; i < 4; i++) F[i] *= exact[i] / near[i];
}

void pdmc_kinked_stress_intensity(double kink, const double K[2], double k[2])
{
    double F[4];
    pdmc_kink_factors(kink, F);
    k[0] = F[0] * K[0] + F[1] * K[1];
    k[1] = F[2] * K[0] + F[3] * K[1];
}

double pdmc_griffith_energy(double kink, const double K[2], double plane_modulus)
{
    double k[2];
    pdmc_kinked_stress_intensity(kink, K, k);
    const double opening = fmax(k[0], 0.0);
    return (opening * opening + k[1] * k[1]) / plane_modulus;
}

double pdmc_tangential_stress_direction(const double K[2])
{
    const double root = sqrt(K[0] * K[0] + 8.0 * K[1] * K[1]);
    return root > 0.0 ? -2.0 * atan2(2.0 * K[1], K[0] + root) : 0.0;
}
