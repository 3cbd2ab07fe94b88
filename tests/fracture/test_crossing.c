// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/fracture.h"

#include "check.h"

#include "pdmc/geometry.h"

typedef void (*field)(const double x[2], double u[2]);

// G_E of a displacement field by the definition, c constant.
static double bond_energy(const pdmc_problem *problem, const double x_t[2], double phi, double horizon,
                          field displacement)
{
    static pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    pdmc_ring_rule rings;
    int count;
    CHECK_OK(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, 1, 3, horizon, &rings));
    CHECK_OK(pdmc_crossing_bonds(problem, x_t, phi, &rings, &count, bonds));
    double sum = 0.0;
    for (int b = 0; b < count; b++) {
        double start[2], end[2];
        displacement(bonds[b].start, start);
        displacement(bonds[b].end, end);
        const double stretch =
            bonds[b].direction[0] * (end[0] - start[0]) + bonds[b].direction[1] * (end[1] - start[1]);
        sum += rings.mean[bonds[b].ring] * bonds[b].weight * stretch * stretch;
    }
    pdmc_ring_rule_clear(&rings);
    return 0.5 * pdmc_micromodulus(&problem->material, horizon) * sum;
}

static void isotropic(const double x[2], double u[2])
{
    u[0] = 0.01 * x[0];
    u[1] = 0.01 * x[1];
}

static void rotation(const double x[2], double u[2])
{
    u[0] = -0.01 * x[1];
    u[1] = 0.01 * x[0];
}

static void uniaxial(const double x[2], double u[2])
{
    u[0] = 0.0;
    u[1] = 0.01 * x[1];
}

static const pdmc_problem whole = {.plate = {2.0, 2.0, 1.0}, .material = {3.0, PDMC_PLANE_STRESS, 1.0}};

// G_0 = c s^2 delta^4 / 4 in every direction (errata of eq. 42), whatever the point.
static void a_uniform_stretch_gives_the_fracture_energy(void **state)
{
    (void)state;
    const double horizon = 0.2, x_t[2] = {0.3, -0.1};
    const double exact = pdmc_micromodulus(&whole.material, horizon) * 1e-4 * pow(horizon, 4) / 4.0;
    for (int k = 0; k < 12; k++) {
        CHECK_NEAR(bond_energy(&whole, x_t, 0.5 * k, horizon, isotropic) / exact, 1.0, 1e-12);
        CHECK_NEAR(bond_energy(&whole, x_t, 0.5 * k, horizon, rotation) / exact, 0.0, 1e-24);
    }
}

// A strain e_y: the stretch of a bond is e_y sin^2(angle), so G / (c e_y^2 delta^4 / 4) = int sin(t) sin^4(phi + t) dt
// / 2 over 0 .. pi, which is 8/15 along x and 1/5 along y.
static void a_uniaxial_strain_is_felt_by_direction(void **state)
{
    (void)state;
    const double horizon = 0.2, x_t[2] = {0.0, 0.0};
    const double unit = pdmc_micromodulus(&whole.material, horizon) * 1e-4 * pow(horizon, 4) / 4.0;
    CHECK_NEAR(bond_energy(&whole, x_t, 0.0, horizon, uniaxial) / unit, 8.0 / 15.0, 1e-10);
    CHECK_NEAR(bond_energy(&whole, x_t, acos(-1.0) / 2.0, horizon, uniaxial) / unit, 1.0 / 5.0, 1e-10);
}

// Every bond meets the line through the point, at the point.
static void bonds_cross_at_the_point(void **state)
{
    (void)state;
    static pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    const double x_t[2] = {0.2, 0.1}, phi = 0.7;
    pdmc_ring_rule rings;
    int count;
    CHECK_OK(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, 1, 3, 0.1, &rings));
    CHECK_OK(pdmc_crossing_bonds(&whole, x_t, phi, &rings, &count, bonds));
    assert_int_equal(count, PDMC_CROSSING_BONDS);
    double weight = 0.0;
    for (int b = 0; b < count; b++) {
        CHECK_NEAR(pdmc_point_segment_distance(x_t, bonds[b].start, bonds[b].end), 0.0, 1e-16);
        const double length = hypot(bonds[b].end[0] - bonds[b].start[0], bonds[b].end[1] - bonds[b].start[1]);
        CHECK_NEAR(length, rings.radius[bonds[b].ring], 1e-15);
        weight += bonds[b].weight;
    }
    CHECK_NEAR(weight, 2.0 * PDMC_CROSSING_RINGS, 1e-12); // int sin = 2 for each ring
    pdmc_ring_rule_clear(&rings);
}

// A line of points on a crack crosses only bonds that the crack has cut; beside a crack the far half is cut; and the
// plate ends at its edges.
static void cut_bonds_are_left_out(void **state)
{
    (void)state;
    pdmc_crack crack = {"c", {-0.5, 0.0}, {0.5, 0.0}};
    pdmc_problem cracked = whole;
    cracked.cracks = &crack;
    cracked.crack_count = 1;
    const double on[2] = {0.0, 0.0}, beside[2] = {0.0, 0.05}, edge[2] = {0.99, 0.0}, ahead[2] = {0.8, 0.0};
    assert_true(bond_energy(&cracked, on, 0.0, 0.1, isotropic) == 0.0);
    const double all = bond_energy(&whole, on, 0.0, 0.1, isotropic);
    const double part = bond_energy(&cracked, beside, 0.0, 0.1, isotropic) / all;
    assert_true(0.5 < part && part < 0.95);
    CHECK_NEAR(bond_energy(&cracked, ahead, 0.0, 0.1, isotropic) / all, 1.0, 1e-14);
    assert_true(bond_energy(&cracked, edge, 0.0, 0.1, isotropic) < 0.8 * all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_uniform_stretch_gives_the_fracture_energy),
        cmocka_unit_test(a_uniaxial_strain_is_felt_by_direction),
        cmocka_unit_test(bonds_cross_at_the_point),
        cmocka_unit_test(cut_bonds_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
