// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/bond_plate.h"
#include "pdmc/affine.h"

#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

static double draw(void)
{
    static uint64_t sequence = 5;
    sequence = sequence * 6364136223846793005u + 1442695040888963407u;
    return (double)(sequence >> 11) * 0x1p-53;
}

static double *draw_many(size_t count, double low, double high)
{
    double *x = test_malloc(count * sizeof *x);
    for (size_t k = 0; k < count; k++) x[k] = low + (high - low) * draw();
    return x;
}

// The full matrix, both triangles. [n, n]
static double *dense(const pdmc_bond_plate *plate, const double factor[])
{
    pdmc_sparse_matrix matrix;
    CHECK_OK(pdmc_bond_matrix_create(plate, &(pdmc_bond_moduli){.shell = factor}, &matrix));
    const size_t n = (size_t)matrix.unknowns;
    double *full = test_calloc(n * n, sizeof *full);
    for (size_t column = 0; column < n; column++) {
        assert_true(matrix.row[matrix.start[column]] == (int64_t)column);
        for (int64_t k = matrix.start[column]; k < matrix.start[column + 1]; k++) {
            const size_t row = (size_t)matrix.row[k];
            if (k > matrix.start[column]) assert_true(matrix.row[k] > matrix.row[k - 1]);
            assert_true(row < n);
            full[row * n + column] = full[column * n + row] = matrix.value[k];
        }
    }
    pdmc_sparse_matrix_clear(&matrix);
    return full;
}

// Oblique cracks, sides that are held in one direction or both, correction, every kind of area.
static void describe_rich(bond_plate *p, int kind)
{
    bond_plate_describe(p, 11, 8, 2.6);
    p->problem.solver.area = (pdmc_bond_area)kind;
    p->problem.solver.surface_correction = kind % 2 ? PDMC_ON : PDMC_OFF;
    bond_plate_crack(p, -0.25, -0.1, 0.2, 0.13);
    bond_plate_crack(p, 0.3, 0.3, 0.35, -0.2);
    bond_plate_hold(p, PDMC_SIDE_LEFT, 0, 0.1);
    bond_plate_hold(p, PDMC_SIDE_TOP, 1, 0.2);
    if (kind >= 2) bond_plate_hold(p, PDMC_SIDE_TOP, 0, 0.0);
}

static bool is_held(const pdmc_bond_plate *plate, size_t unknown)
{
    return plate->grid.held[unknown / 2] & (1U << (unknown % 2));
}

// With what is held at 0 the product is the matrix'; each column has its own factors.
static void the_product_is_that_of_the_matrix(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        bond_plate p;
        describe_rich(&p, kind);
        bond_plate_make(&p, 5);
        const size_t n = 2 * (size_t)p.made.grid.nodes, shells = (size_t)p.made.horizon.shells;
        double *x = draw_many(PDMC_BLOCK * n, -1.0, 1.0), *factor = draw_many(PDMC_BLOCK * shells, 0.5, 1.5);
        double *y = test_malloc(PDMC_BLOCK * n * sizeof *y);
        for (size_t k = 0; k < PDMC_BLOCK * n; k++)
            if (is_held(&p.made, k % n)) x[k] = 0.0;
        CHECK_OK(pdmc_bond_multiply(&p.made, 1, factor, x, y));
        for (size_t column = 0; column < PDMC_BLOCK; column += 7) {
            double *K = dense(&p.made, &factor[column * shells]);
            for (size_t i = 0; i < n; i++) {
                double want = 0.0, scale = 0.0;
                for (size_t j = 0; j < n; j++) {
                    want += K[i * n + j] * x[column * n + j];
                    scale += fabs(K[i * n + j] * x[column * n + j]);
                    if (is_held(&p.made, i)) CHECK_NEAR(K[i * n + j], i == j ? 1.0 : 0.0, 0.0);
                }
                CHECK_NEAR(y[column * n + i], want, 1e-14 * scale);
            }
            test_free(K);
        }
        test_free(y);
        test_free(factor);
        test_free(x);
        bond_plate_clear(&p);
    }
}

// The force of each bond by its definition, held displacements included.
static void the_product_is_the_sum_of_bond_forces(void **state)
{
    (void)state;
    bond_plate p;
    describe_rich(&p, 3);
    bond_plate_make(&p, 5);
    const pdmc_bond_families *families = &p.made.families;
    const size_t n = 2 * (size_t)p.made.grid.nodes, shells = (size_t)p.made.horizon.shells;
    double *x = draw_many(PDMC_BLOCK * n, -1.0, 1.0), *factor = draw_many(PDMC_BLOCK * shells, 0.5, 1.5);
    double *y = test_malloc(PDMC_BLOCK * n * sizeof *y);
    CHECK_OK(pdmc_bond_multiply(&p.made, 1, factor, x, y));
    for (size_t column = 0; column < PDMC_BLOCK; column++) {
        const double *u = &x[column * n];
        for (size_t node = 0; node < n / 2; node++) {
            double force[2] = {0.0, 0.0};
            for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
                const pdmc_bond_neighbour *m = &p.made.horizon.neighbour[families->neighbour[b]];
                const size_t other = (size_t)families->partner[b];
                const double elongation = m->direction[0] * (u[2 * node] - u[2 * other]) +
                                          m->direction[1] * (u[2 * node + 1] - u[2 * other + 1]);
                const double scale = 0.5 * (families->scale[node] + families->scale[other]);
                const double share = factor[column * shells + (size_t)m->shell] * scale;
                for (int i = 0; i < 2; i++) force[i] += 0.01 * share * m->stiffness * elongation * m->direction[i];
            }
            for (size_t i = 0; i < 2; i++)
                CHECK_NEAR(y[column * n + 2 * node + i], is_held(&p.made, 2 * node + i) ? 0.0 : force[i], 1e-12);
        }
    }
    test_free(y);
    test_free(factor);
    test_free(x);
    bond_plate_clear(&p);
}

// A column's result does not depend on what is in the others, nor on its place.
static void columns_are_independent(void **state)
{
    (void)state;
    bond_plate p;
    describe_rich(&p, 1);
    bond_plate_make(&p, 5);
    const size_t n = 2 * (size_t)p.made.grid.nodes, shells = (size_t)p.made.horizon.shells;
    double *x = draw_many(PDMC_BLOCK * n, -1.0, 1.0), *factor = draw_many(PDMC_BLOCK * shells, 0.5, 1.5);
    double *y = test_malloc(PDMC_BLOCK * n * sizeof *y), *z = test_malloc(PDMC_BLOCK * n * sizeof *z);
    CHECK_OK(pdmc_bond_multiply(&p.made, 1, factor, x, y));
    for (size_t column = 0; column < PDMC_BLOCK; column++) {
        memcpy(&x[column * n], &x[37 * n], n * sizeof *x);
        memcpy(&factor[column * shells], &factor[37 * shells], shells * sizeof *factor);
    }
    CHECK_OK(pdmc_bond_multiply(&p.made, 1, factor, x, z));
    for (size_t column = 0; column < PDMC_BLOCK; column++)
        assert_memory_equal(&z[column * n], &y[37 * n], n * sizeof *z);
    test_free(z);
    test_free(y);
    test_free(factor);
    test_free(x);
    bond_plate_clear(&p);
}

static double *ones(const pdmc_bond_plate *plate)
{
    return draw_many((size_t)plate->horizon.shells, 1.0, 1.0);
}

// Three eigenvalues are 0, those of rigid motions, with a crack between the rows of nodes, through them, or none; the
// others lie above 1e-4 of the largest.
static void only_rigid_motions_cost_nothing(void **state)
{
    (void)state;
    for (int k = 0; k < 3 * 4; k++) {
        bond_plate p;
        bond_plate_describe(&p, 9, 7, 3.0);
        p.problem.solver.area = (pdmc_bond_area)(k / 3);
        p.problem.solver.surface_correction = k % 2 ? PDMC_ON : PDMC_OFF;
        if (k % 3 == 1) bond_plate_crack(&p, -0.3, 0.0, 0.1, 0.0);
        if (k % 3 == 2) bond_plate_crack(&p, -0.2, -0.15, 0.25, 0.1);
        bond_plate_make(&p, 1);
        const int n = 2 * p.made.grid.nodes;
        double *factor = ones(&p.made), *K = dense(&p.made, factor), *value = test_malloc((size_t)n * sizeof *value);
        assert_int_equal(LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'L', n, K, n, value), 0);
        const double most = value[n - 1];
        for (int i = 0; i < 3; i++) CHECK_NEAR(value[i] / most, 0.0, 1e-14);
        if (k < 3)
            printf("  eigenvalues: %.2e %.2e %.2e %.3e ... %.3e\n", value[0], value[1], value[2], value[3], most);
        assert_true(value[3] > 1e-4 * most);
        test_free(value);
        test_free(K);
        test_free(factor);
        bond_plate_clear(&p);
    }
}

// x, y -> -y, x: sides, supports and cracks.
static void describe_turned(bond_plate *p, bool is_turned)
{
    const double cracks[2][4] = {{-0.2, -0.1, 0.15, 0.05}, {0.05, 0.25, 0.25, 0.25}}; // the second through nodes
    bond_plate_describe(p, is_turned ? 7 : 10, is_turned ? 10 : 7, 3.0);
    p->problem.solver.surface_correction = PDMC_ON;
    for (int c = 0; c < 2; c++) {
        const double *x = cracks[c];
        if (is_turned) bond_plate_crack(p, -x[1], x[0], -x[3], x[2]);
        else bond_plate_crack(p, x[0], x[1], x[2], x[3]);
    }
    bond_plate_hold(p, is_turned ? PDMC_SIDE_TOP : PDMC_SIDE_RIGHT, is_turned ? 1 : 0, 0.1);
    bond_plate_hold(p, is_turned ? PDMC_SIDE_LEFT : PDMC_SIDE_TOP, is_turned ? 0 : 1, 0.1);
}

static int node_at(const pdmc_bond_grid *grid, double x, double y)
{
    const int column = (int)lround((x - grid->origin[0]) / grid->spacing);
    const int row = (int)lround((y - grid->origin[1]) / grid->spacing);
    return row * grid->columns + column;
}

static void a_quarter_turn_changes_nothing(void **state)
{
    (void)state;
    bond_plate p, q;
    describe_turned(&p, false);
    describe_turned(&q, true);
    bond_plate_make(&p, 1);
    bond_plate_make(&q, 1);
    assert_true(p.made.families.cut > 50 && p.made.families.cut == q.made.families.cut);
    const int n = 2 * p.made.grid.nodes;
    assert_int_equal(n, 2 * q.made.grid.nodes);
    double *factor = ones(&p.made), *K = dense(&p.made, factor), *L = dense(&q.made, factor);
    int *to = test_malloc((size_t)n * sizeof *to);
    for (int k = 0; k < n; k++) {
        double x[2];
        pdmc_bond_grid_node(&p.made.grid, k / 2, x);
        const int node = node_at(&q.made.grid, -x[1], x[0]);
        to[k] = 2 * node + 1 - k % 2; // u becomes v, v becomes -u
    }
    double most = 0.0;
    for (int i = 0; i < n * n; i++) most = fmax(most, fabs(K[i]));
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            const double sign = i % 2 == j % 2 ? 1.0 : -1.0, *row = &L[(size_t)n * (size_t)to[i]];
            CHECK_NEAR(sign * row[to[j]], K[(size_t)n * (size_t)i + (size_t)j], 1e-14 * most);
        }
    }
    test_free(to);
    test_free(L);
    test_free(K);
    test_free(factor);
    bond_plate_clear(&q);
    bond_plate_clear(&p);
}

// Tension on the ends of a plate or on all its sides, each spread over three nodes: the mean strain along x, corners
// and load layers aside, over that of Hooke's law.
static double strain_ratio(const int cells[2], pdmc_bond_area kind, pdmc_switch correction, bool is_biaxial)
{
    enum { LAYER = 3 };
    const int columns = cells[0], rows = cells[1], middle = rows / 2 * columns, from = columns / 4, to = 3 * from;
    bond_plate p;
    bond_plate_describe(&p, columns, rows, 3.0);
    p.problem.solver.area = kind;
    p.problem.solver.surface_correction = correction;
    bond_plate_make(&p, 1);
    p.made.grid.held[middle] = 3; // rigid motions only: in the middle of both ends
    p.made.grid.held[middle + columns - 1] = 2;
    const int n = 2 * p.made.grid.nodes;
    double *factor = ones(&p.made), *K = dense(&p.made, factor), *u = test_calloc((size_t)n, sizeof *u), sum = 0.0;
    for (int k = 0; k < n; k++) {
        const int node = k / 2, at = k % 2 ? node / columns : node % columns, last = cells[k % 2] - 1;
        if ((k % 2 && !is_biaxial) || is_held(&p.made, (size_t)k)) continue;
        u[k] = ((at > last - LAYER) - (at < LAYER)) * 0.1 / LAYER;
    }
    assert_int_equal(LAPACKE_dposv(LAPACK_ROW_MAJOR, 'L', n, 1, K, n, u, 1), 0);
    for (int row = 0; row < rows; row++) {
        const double *line = &u[2 * (size_t)(row * columns)];
        sum += (line[2 * (size_t)to] - line[2 * (size_t)from]) / rows;
    }
    test_free(u);
    test_free(K);
    test_free(factor);
    bond_plate_clear(&p);
    return sum / (0.1 * (to - from)) / (is_biaxial ? 2.0 / 3.0 : 1.0);
}

// The energy density of the stretch u = x.
static double stretch_energy(const pdmc_bond_horizon *horizon)
{
    double density = 0.0;
    for (int k = 0; k < horizon->count; k++) {
        const pdmc_bond_neighbour *n = &horizon->neighbour[k];
        density += 0.25 * n->stiffness * n->length * n->length;
    }
    return density;
}

// All corrections together give a plate in isotropic stretch the energy that it has inside: sum over the bonds of
// (s_i + s_j) / 2 w_ij = sum over the nodes of s_i w_i.
static void the_correction_restores_the_energy_of_a_stretch(void **state)
{
    (void)state;
    bond_plate p;
    bond_plate_describe(&p, 12, 9, 3.0);
    p.problem.solver.surface_correction = PDMC_ON;
    bond_plate_make(&p, 1);
    const size_t n = 2 * (size_t)p.made.grid.nodes;
    double *factor = ones(&p.made), *K = dense(&p.made, factor), *u = test_malloc(n * sizeof *u), energy = 0.0;
    for (size_t k = 0; k < n / 2; k++) pdmc_bond_grid_node(&p.made.grid, (int)k, &u[2 * k]);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) energy += 0.5 * u[i] * K[i * n + j] * u[j];
    CHECK_NEAR(energy / (stretch_energy(&p.made.horizon) * 0.01 * 12 * 9), 1.0, 1e-12);
    test_free(u);
    test_free(K);
    test_free(factor);
    bond_plate_clear(&p);
}

// The correction is made for an isotropic stretch: with it a square under tension on all sides stretches within 1 % as
// the bonds inside do, 5 % more without. Along a free side the missing bonds lie across the tension, where they would
// hold little energy, and so it does too much: a strip 6.7 horizons wide is 8 % stiffer with it, and 5 % too stiff.
static void strains_under_tension(void **state)
{
    (void)state;
    const char *const names[4] = {"full", "partial", "exact", "centroid"};
    const int strip[2] = {60, 20}, square[2] = {32, 32};
    for (int kind = 0; kind < 4; kind++) {
        const pdmc_bond_area area = (pdmc_bond_area)kind;
        const double plain = strain_ratio(strip, area, PDMC_OFF, false);
        const double corrected = strain_ratio(strip, area, PDMC_ON, false);
        const double both = strain_ratio(square, area, PDMC_OFF, true);
        const double both_corrected = strain_ratio(square, area, PDMC_ON, true);
        pdmc_bond_horizon horizon;
        bond_plate p;
        bond_plate_describe(&p, 1, 1, 3.0);
        p.problem.solver.area = area;
        CHECK_OK(pdmc_bond_horizon_create(&p.problem, 1, &horizon));
        const double inside = 1.5 / stretch_energy(&horizon); // of Hooke's energy, E / (1 - nu)
        pdmc_bond_horizon_clear(&horizon);
        CHECK_NEAR(both / inside, 1.05, 0.01);
        CHECK_NEAR(both_corrected / inside, 1.005, 0.005);
        CHECK_NEAR(corrected / plain, 0.917, 0.003);
        printf("  %-8s: strip in tension %.4f, corrected %.4f; square on all sides %.4f, corrected %.4f\n", names[kind],
               plain, corrected, both, both_corrected);
    }
}

static void failures_are_clean(void **state)
{
    (void)state;
    bond_plate p;
    pdmc_sparse_matrix matrix;
    bond_plate_describe(&p, 4, 4, 2.0);
    bond_plate_make(&p, 1);
    const size_t n = 2 * (size_t)p.made.grid.nodes, shells = (size_t)p.made.horizon.shells;
    double *x = draw_many(PDMC_BLOCK * n, 0.0, 1.0), *y = draw_many(PDMC_BLOCK * n, 0.0, 1.0);
    double *factor = draw_many(PDMC_BLOCK * shells, 1.0, 1.0);
    CHECK_FAILS_CLEANLY(pdmc_bond_multiply(&p.made, 1, factor, x, y), (void)0);
    CHECK_FAILS_CLEANLY(pdmc_bond_shell_project(&p.made, 1, 1, x, 1, x, y), (void)0);
    const pdmc_bond_moduli moduli = {.shell = factor};
    CHECK_FAILS_CLEANLY(pdmc_bond_matrix_create(&p.made, &moduli, &matrix), pdmc_sparse_matrix_clear(&matrix));
    test_free(factor);
    test_free(y);
    test_free(x);
    bond_plate_clear(&p);
}

// u' K_m v of every shell by the product; the vectors fill no whole number of tiles, the nodes none of chunks. What is held
// counts in u.
static void projections_are_those_of_the_products(void **state)
{
    (void)state;
    enum { U = 11, V = 5 };
    bond_plate p;
    bond_plate_describe(&p, 31, 23, 2.6);
    p.problem.solver.surface_correction = PDMC_ON;
    bond_plate_crack(&p, -0.25, -0.1, 0.2, 0.13);
    bond_plate_hold(&p, PDMC_SIDE_LEFT, 0, 0.1);
    bond_plate_hold(&p, PDMC_SIDE_TOP, 1, 0.2);
    bond_plate_make(&p, 5);
    const size_t n = 2 * (size_t)p.made.grid.nodes, shells = (size_t)p.made.horizon.shells;
    double *u = draw_many(PDMC_BLOCK * n, -1.0, 1.0), *v = draw_many(V * n, -1.0, 1.0);
    double *Ku = draw_many(PDMC_BLOCK * n, 0.0, 0.0), *factor = draw_many(PDMC_BLOCK * shells, 0.0, 0.0);
    double *out = draw_many(shells * U * V, 0.0, 0.0);
    CHECK_OK(pdmc_bond_shell_project(&p.made, 2, U, u, V, v, out));
    for (size_t m = 0; m < shells; m++) {
        for (size_t k = 0; k < PDMC_BLOCK * shells; k++) factor[k] = k % shells == m;
        CHECK_OK(pdmc_bond_multiply(&p.made, 1, factor, u, Ku));
        for (size_t k = 0; k < U * V; k++) {
            double want = 0.0, size = 0.0;
            for (size_t i = 0; i < n; i++) {
                want += v[k % V * n + i] * Ku[k / V * n + i];
                size += fabs(v[k % V * n + i] * Ku[k / V * n + i]);
            }
            CHECK_NEAR(out[m * U * V + k], want, 1e-13 * size);
        }
    }
    test_free(u);
    test_free(v);
    test_free(Ku);
    test_free(factor);
    test_free(out);
    bond_plate_clear(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_product_is_that_of_the_matrix),
        cmocka_unit_test(the_product_is_the_sum_of_bond_forces),
        cmocka_unit_test(columns_are_independent),
        cmocka_unit_test(only_rigid_motions_cost_nothing),
        cmocka_unit_test(a_quarter_turn_changes_nothing),
        cmocka_unit_test(the_correction_restores_the_energy_of_a_stretch),
        cmocka_unit_test(strains_under_tension),
        cmocka_unit_test(projections_are_those_of_the_products),
        cmocka_unit_test(failures_are_clean),
    };
    pdmc_blas_prepare();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
