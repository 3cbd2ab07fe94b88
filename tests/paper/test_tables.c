// SPDX-License-Identifier: GPL-3.0-or-later

/// Tables 1 and 2 of Evangelatos & Spanos 2011 beside what this library computes: ctest -R paper.tables -V

#include "kansa/boundary_collocation.h"
#include "paper/plate.h"
#include "pdmc/discretisation.h"

#include <gsl/gsl_math.h>

enum { CORNERS = 4 };

static void displacements(const plate *p, const double origin[2], const double x[CORNERS][2], double u[CORNERS][2])
{
    pdmc_discretisation made;
    double zero[2];
    CHECK_OK(pdmc_discretise(&p->problem, 2, &made));
    CHECK_OK(made.verbs->displacement(made.method, origin, origin, zero));
    for (int i = 0; i < CORNERS; i++) {
        CHECK_OK(made.verbs->displacement(made.method, x[i], x[i], u[i]));
        for (int k = 0; k < 2; k++) u[i][k] -= zero[k];
    }
    pdmc_discretisation_clear(&made);
}

static void print_row(const char *name, double u[CORNERS][2])
{
    printf("  %-38s", name);
    for (int i = 0; i < CORNERS; i++) printf(" %7.4f %7.4f |", u[i][0], u[i][1]);
    printf("\n");
}

static void make_square(plate *p, int cells, double horizon)
{
    plate_make(p, 1.0, cells, horizon);
    p->problem.material.youngs_modulus = 1.5; // bulk modulus 1 and Poisson's ratio 1/4 in three dimensions
    plate_load(p, PDMC_SIDE_TOP, 0.0, 1.0);
    plate_load(p, PDMC_SIDE_BOTTOM, 0.0, -1.0);
}

static void make_paper(plate *p, int cells)
{
    make_square(p, cells, 1.0); // "the horizon that has been used in both examples"
    p->problem.solver.shape = 0.16 / cells;
    paper_settings(p, true);
}

static void strains(double u[CORNERS][2], double strain[2])
{
    strain[0] = 0.5 * (u[1][0] - u[0][0] + u[3][0] - u[2][0]);
    strain[1] = 0.5 * (u[2][1] - u[0][1] + u[3][1] - u[1][1]);
}

static void print_strains(const char *name, const double strain[2])
{
    printf("  %-38s %8.4f %8.4f %7.3f\n", name, strain[0], strain[1], -strain[0] / strain[1]);
}

// Nodes 1 to 4 are the corners, left to right and from the bottom up. Displacements depend on how the plate is held, which
// the paper does not say; the strains do not.
static void table_1(void **state)
{
    (void)state;
    const double x[CORNERS][2] = {{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}}, origin[2] = {0.0, 0.0};
    double printed[CORNERS][2] = {{-0.027, 0.112}, {-0.187, 0.112}, {-0.026, 0.787}, {-0.187, 0.787}};
    double fem[CORNERS][2] = {{0, 0}, {-0.167, 0}, {0, 0.667}, {-0.167, 0.667}};
    double strain[2], u[CORNERS][2];
    plate p;
    printf("  table 1: 1 cm x 1 cm, E = 1.5 N/cm^2, tension 1 N/cm^2   e_x      e_y    -e_x/e_y\n");
    strains(printed, strain);
    print_strains("printed, Kansa", strain);
    strains(fem, strain);
    print_strains("printed, finite elements", strain);
    print_strains("exact, plane stress, nu = 1/3", (const double[2]){-1.0 / 4.5, 1.0 / 1.5});
    make_square(&p, 8, 0.02);
    displacements(&p, origin, x, u);
    strains(u, strain);
    print_strains("pdmc, analytic, 81 nodes", strain);
    CHECK_NEAR(strain[0], -1.0 / 4.5, 1e-9);
    CHECK_NEAR(strain[1], 1.0 / 1.5, 1e-9);
    const int cells[3] = {1, 4, 10};
    for (int k = 0; k < 3; k++) {
        char name[64];
        make_paper(&p, cells[k]);
        displacements(&p, origin, x, u);
        strains(u, strain);
        snprintf(name, sizeof name, "pdmc, paper, %d nodes", (cells[k] + 1) * (cells[k] + 1));
        print_strains(name, strain);
        if (cells[k] == 1) CHECK_NEAR(strain[1], 20.0 * M_PI / 9.0 / 1.5, 1e-9);
    }
}

// 2 mu (u + i v) = kappa phi(z) - omega(z') - (z - z') conj(phi'(z)), z' the conjugate of z, for the potentials of the
// reference, whose crack lies along x.
static void exact_displacement(const reference *r, double young, double nu, const double x[2], double u[2])
{
    const double kappa = (3.0 - nu) / (1.0 + nu), two_mu = young / (1.0 + nu), R = r->radius, a = r->half_length;
    const double complex z = CMPLX(x[0], x[1]), zc = conj(z), X = csqrt(z - a) * csqrt(z + a);
    const double complex Xc = csqrt(zc - a) * csqrt(zc + a);
    double complex phi = 0.0, dphi = 0.0, omega = 0.0;
    for (int m = 0; m < REFERENCE_ORDERS; m++) {
        const double *c = &r->coefficients[m];
        const double complex pm = CMPLX(c[0], c[REFERENCE_ORDERS]);
        const double complex qm = CMPLX(c[2 * REFERENCE_ORDERS], c[3 * REFERENCE_ORDERS]);
        const double complex g = cpow(z / R, m), gc = cpow(zc / R, m);
        const double complex dg = m > 0 ? m / R * cpow(z / R, m - 1) : 0.0;
        phi += pm * X * g + qm * z * g;
        dphi += pm * (z / X * g + X * dg) + qm * (m + 1) * g;
        omega += pm * Xc * gc - qm * zc * gc;
    }
    const double complex w = (kappa * phi - omega - (z - zc) * conj(dphi)) / two_mu;
    u[0] = creal(w);
    u[1] = cimag(w);
}

// Eq. 37 with the squares of sin and cos, K = sigma sqrt(pi a).
static void near_tip(double a, double young, double nu, double r, double t, double u[2])
{
    const double kappa = (3.0 - nu) / (1.0 + nu), two_mu = young / (1.0 + nu);
    const double factor = sqrt(M_PI * a) / two_mu * sqrt(r / (2.0 * M_PI)), c = cos(0.5 * t), s = sin(0.5 * t);
    u[0] = factor * c * (kappa - 1.0 + 2.0 * s * s);
    u[1] = factor * s * (kappa + 1.0 - 2.0 * c * c);
}

static void table_2(void **state)
{
    (void)state;
    const double a = 0.3, side = 0.1, tip[2] = {a + 1e-12, 0.0}; // the fields' derivatives have a pole at the tip
    const double x[CORNERS][2] = {{a - side, -side}, {a + side, -side}, {a + side, side}, {a - side, side}};
    double kansa[CORNERS][2] = {{0.128, -0.31}, {0.179, -0.078}, {0.178, 0.079}, {0.126, 0.31}};
    double theory[CORNERS][2] = {{0.1354, -0.3269}, {0.1706, -0.0707}, {0.1706, 0.0707}, {0.1354, 0.3269}};
    double u[CORNERS][2], exact[CORNERS][2], at_tip[2];
    plate p;
    printf(
        "  table 2: crack of half length 0.3 cm in the middle of 1 cm x 1 cm; u and v at nodes 1 to 4, from the tip\n");
    print_row("printed, Kansa", kansa);
    print_row("printed, theory", theory);
    for (int i = 0; i < CORNERS; i++) {
        near_tip(a, 1.5, 0.23, M_SQRT2 * side, atan2(x[i][1], x[i][0] - a), u[i]);
        for (int k = 0; k < 2; k++) CHECK_NEAR(u[i][k], theory[i][k], 5e-4); // nu and a fitted to two digits
    }
    print_row("eq. 37 with squares, nu = 0.23", u);
    reference r;
    reference_solve(&r, 1.0, a, 0.0);
    exact_displacement(&r, 1.5, 1.0 / 3.0, tip, at_tip);
    for (int i = 0; i < CORNERS; i++) {
        exact_displacement(&r, 1.5, 1.0 / 3.0, x[i], exact[i]);
        for (int k = 0; k < 2; k++) exact[i][k] -= at_tip[k];
    }
    print_row("exact, plane stress, nu = 1/3", exact);
    printf("  (K_I %.4f exact, %.4f in eq. 37)\n", r.K[0], sqrt(M_PI * a));
    make_square(&p, 20, 0.02);
    plate_crack(&p, 0.0, 0.0, a, 0.0);
    displacements(&p, tip, x, u);
    print_row("pdmc, analytic, 441 nodes", u);
    for (int i = 0; i < CORNERS; i++)
        for (int k = 0; k < 2; k++) CHECK_NEAR(u[i][k], exact[i][k], 0.004);
    for (int cells = 5; cells <= 20; cells += 5) { // odd and even: without nodes on the crack, and with them
        char name[64];
        make_paper(&p, cells);
        plate_crack(&p, 0.0, 0.0, a, 0.0);
        displacements(&p, tip, x, u);
        snprintf(name, sizeof name, "pdmc, paper, %d nodes", (cells + 1) * (cells + 1));
        print_row(name, u);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(table_1),
        cmocka_unit_test(table_2),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
