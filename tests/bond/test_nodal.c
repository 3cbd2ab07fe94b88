// SPDX-License-Identifier: GPL-3.0-or-later

/// A stiffness that varies from node to node: products, matrices and projections against the bonds' definition.

#include "bond/bond_plate.h"
#include "bond/nodal.h"
#include "pdmc/affine.h"

#include <stdlib.h>

enum { B = PDMC_BLOCK, TERMS = 3 };

static double draw(void)
{
    static uint64_t sequence = 11;
    sequence = sequence * 6364136223846793005u + 1442695040888963407u;
    return (double)(sequence >> 11) * 0x1p-53;
}

static double *draw_many(size_t count, double low, double high)
{
    double *x = test_malloc(count * sizeof *x);
    for (size_t k = 0; k < count; k++) x[k] = low + (high - low) * draw();
    return x;
}

typedef struct {
    bond_plate p;
    size_t nodes, n;
    double *psi, *xi, *x, *y; // [nodes, TERMS], [B, TERMS], [B, n], [B, n]
} varying;

// Oblique cracks, sides that are held in one direction or both, correction, part cells.
static void varying_make(varying *v, int kind)
{
    bond_plate_describe(&v->p, 11, 8, 2.6);
    v->p.problem.solver.area = (pdmc_bond_area)kind;
    v->p.problem.solver.surface_correction = kind % 2 ? PDMC_ON : PDMC_OFF;
    bond_plate_crack(&v->p, -0.25, -0.1, 0.2, 0.13);
    bond_plate_crack(&v->p, 0.3, 0.3, 0.35, -0.2);
    bond_plate_hold(&v->p, PDMC_SIDE_LEFT, 0, 0.1);
    bond_plate_hold(&v->p, PDMC_SIDE_TOP, 1, 0.2);
    bond_plate_make(&v->p, 5);
    v->nodes = (size_t)v->p.made.grid.nodes;
    v->n = 2 * v->nodes;
    v->psi = draw_many(v->nodes * TERMS, -0.3, 0.3);
    v->xi = draw_many(B * TERMS, -1.0, 1.0);
    v->x = draw_many(B * v->n, -1.0, 1.0);
    v->y = draw_many(B * v->n, -1.0, 1.0);
}

static void varying_clear(varying *v)
{
    test_free(v->psi);
    test_free(v->xi);
    test_free(v->x);
    test_free(v->y);
    bond_plate_clear(&v->p);
}

static bool is_held(const varying *v, size_t unknown)
{
    return v->p.made.grid.held[unknown / 2] & (1U << (unknown % 2));
}

static void release_held(const varying *v, double x[])
{
    for (size_t k = 0; k < B * v->n; k++)
        if (is_held(v, k % v->n)) x[k] = 0.0;
}

static double factor_at(const varying *v, double mean, int column, int node)
{
    double factor = mean;
    for (int k = 0; k < TERMS; k++) factor += v->psi[node * TERMS + k] * v->xi[column * TERMS + k];
    return factor;
}

static void the_product_is_the_sum_of_bond_forces(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        varying v;
        varying_make(&v, kind);
        const pdmc_bond_plate *plate = &v.p.made;
        const double area = plate->grid.spacing * plate->grid.spacing;
        CHECK_OK(pdmc_bond_nodal_multiply(plate, 2, TERMS, v.psi, 1.0, TERMS, v.xi, v.x, v.y));
        for (int column = 0; column < B; column += 7)
            for (int node = 0; node < plate->grid.nodes; node++) {
                const double *u = &v.x[(size_t)column * v.n];
                double force[2] = {0.0, 0.0}, size = 0.0;
                for (size_t b = plate->families.start[node]; b < plate->families.start[node + 1]; b++) {
                    const int other = plate->families.partner[b];
                    const pdmc_bond_neighbour *n = &plate->horizon.neighbour[plate->families.neighbour[b]];
                    const double correction = 0.5 * (plate->families.scale[node] + plate->families.scale[other]);
                    const double f =
                        0.5 * (factor_at(&v, 1.0, column, node) + factor_at(&v, 1.0, column, other)) * correction;
                    double elongation = 0.0;
                    for (int i = 0; i < 2; i++) elongation += n->direction[i] * (u[2 * node + i] - u[2 * other + i]);
                    for (int i = 0; i < 2; i++) force[i] += area * n->stiffness * f * elongation * n->direction[i];
                    size += fabs(area * n->stiffness * f * elongation);
                }
                for (size_t i = 0; i < 2; i++) {
                    const size_t unknown = 2 * (size_t)node + i;
                    const double got = v.y[(size_t)column * v.n + unknown];
                    CHECK_NEAR(got, is_held(&v, unknown) ? 0.0 : force[i], 1e-14 * size);
                }
            }
        varying_clear(&v);
    }
}

// K_f = 1/2 (f K + K f + E), E_i = sum_j k_ij (f_j - f_i) e e' in 2 x 2 blocks: nothing of it uses K_f.
static void the_product_is_that_of_the_mean_and_diagonals(void **state)
{
    (void)state;
    varying v;
    varying_make(&v, 3);
    const pdmc_bond_plate *plate = &v.p.made;
    const size_t n = v.n, shells = (size_t)plate->horizon.shells;
    const double area = plate->grid.spacing * plate->grid.spacing;
    double *one = draw_many(B * shells, 1.0, 1.0), *scaled = draw_many(B * n, 0.0, 0.0);
    double *Kx = draw_many(B * n, 0.0, 0.0), *Kfx = draw_many(B * n, 0.0, 0.0);
    for (size_t k = 0; k < B * n; k++) scaled[k] = factor_at(&v, 0.0, (int)(k / n), (int)(k % n / 2)) * v.x[k];
    CHECK_OK(pdmc_bond_multiply(plate, 1, one, v.x, Kx));
    CHECK_OK(pdmc_bond_multiply(plate, 1, one, scaled, Kfx));
    CHECK_OK(pdmc_bond_nodal_multiply(plate, 1, TERMS, v.psi, 0.0, TERMS, v.xi, v.x, v.y));
    for (int column = 0; column < B; column += 9)
        for (int node = 0; node < plate->grid.nodes; node++) {
            const size_t at = (size_t)column * n + 2 * (size_t)node;
            const double f = factor_at(&v, 0.0, column, node);
            double E[3] = {0.0, 0.0, 0.0};
            for (size_t b = plate->families.start[node]; b < plate->families.start[node + 1]; b++) {
                const int other = plate->families.partner[b];
                const pdmc_bond_neighbour *neighbour = &plate->horizon.neighbour[plate->families.neighbour[b]];
                const double *e = neighbour->direction,
                             correction = plate->families.scale[node] + plate->families.scale[other];
                const double k =
                    0.5 * area * neighbour->stiffness * correction * (factor_at(&v, 0.0, column, other) - f);
                E[0] += k * e[0] * e[0];
                E[1] += k * e[0] * e[1];
                E[2] += k * e[1] * e[1];
            }
            for (size_t i = 0; i < 2; i++) {
                const double want = 0.5 * (f * Kx[at + i] + Kfx[at + i] + E[i] * v.x[at] + E[i + 1] * v.x[at + 1]);
                // some thirty bonds of stiffness 1
                CHECK_NEAR(v.y[at + i], is_held(&v, 2 * (size_t)node + i) ? 0.0 : want, 1e-13);
            }
        }
    test_free(one);
    test_free(scaled);
    test_free(Kx);
    test_free(Kfx);
    varying_clear(&v);
}

// Shells and nodes together, with what is held at 0.
static void the_matrix_is_that_of_the_products(void **state)
{
    (void)state;
    varying v;
    varying_make(&v, 3);
    const pdmc_bond_plate *plate = &v.p.made;
    const size_t n = v.n, shells = (size_t)plate->horizon.shells;
    double *factor = draw_many(B * shells, 0.5, 1.5), *both = draw_many(B * n, 0.0, 0.0),
           *node = draw_many(v.nodes, 0.0, 0.0);
    pdmc_sparse_matrix matrix;
    release_held(&v, v.x);
    for (int i = 0; i < plate->grid.nodes; i++) node[i] = factor_at(&v, 0.0, 0, i);
    CHECK_OK(pdmc_bond_matrix_create(plate, &(pdmc_bond_moduli){factor, node}, &matrix));
    CHECK_OK(pdmc_bond_multiply(plate, 1, factor, v.x, both));
    CHECK_OK(pdmc_bond_nodal_multiply(plate, 1, TERMS, v.psi, 0.0, TERMS, v.xi, v.x, v.y));
    double *product = test_calloc(n, sizeof *product);
    for (size_t column = 0; column < n; column++)
        for (int64_t k = matrix.start[column]; k < matrix.start[column + 1]; k++) {
            const size_t row = (size_t)matrix.row[k];
            product[row] += matrix.value[k] * v.x[column];
            if (row != column) product[column] += matrix.value[k] * v.x[row];
        }
    for (size_t i = 0; i < n; i++) CHECK_NEAR(product[i], both[i] + v.y[i], 1e-13);
    test_free(product);
    test_free(factor);
    test_free(both);
    test_free(node);
    pdmc_sparse_matrix_clear(&matrix);
    varying_clear(&v);
}

// u' (K_k v) of every term by the product, with what is held at 0; the vectors fill no whole number of tiles.
static void projections_are_those_of_the_products(void **state)
{
    (void)state;
    enum { U = 11, V = 21 };
    varying v;
    varying_make(&v, 1);
    const pdmc_bond_plate *plate = &v.p.made;
    const size_t n = v.n;
    double *u = draw_many(B * n, -1.0, 1.0), *out = draw_many(TERMS * U * V, 0.0, 0.0);
    double *energy = draw_many(v.nodes, 0.0, 0.0);
    release_held(&v, v.x);
    release_held(&v, u);
    CHECK_OK(pdmc_bond_nodal_project(plate, 2, TERMS, v.psi, U, u, V, v.x, out));
    pdmc_bond_nodal_energy(plate, u, v.x, energy);
    for (int m = 0; m < TERMS; m++) {
        double by_nodes = 0.0;
        for (int k = 0; k < B * TERMS; k++) v.xi[k] = k % TERMS == m;
        CHECK_OK(pdmc_bond_nodal_multiply(plate, 1, TERMS, v.psi, 0.0, TERMS, v.xi, v.x, v.y));
        for (int i = 0; i < U; i++)
            for (int j = 0; j < V; j++) {
                double want = 0.0;
                for (size_t k = 0; k < n; k++) want += u[(size_t)i * n + k] * v.y[(size_t)j * n + k];
                CHECK_NEAR(out[(m * U + i) * V + j], want, 1e-12); // sums of some 200 forces of size 1
            }
        for (size_t i = 0; i < v.nodes; i++) by_nodes += v.psi[i * TERMS + (size_t)m] * energy[i];
        CHECK_NEAR(out[m * U * V], by_nodes, 1e-12);
    }
    test_free(u);
    test_free(out);
    test_free(energy);
    varying_clear(&v);
}

static void every_allocation_may_be_refused(void **state)
{
    (void)state;
    varying v;
    double out[TERMS];
    varying_make(&v, 0);
    CHECK_FAILS_CLEANLY(pdmc_bond_nodal_multiply(&v.p.made, 1, TERMS, v.psi, 1.0, TERMS, v.xi, v.x, v.y), (void)0);
    CHECK_FAILS_CLEANLY(pdmc_bond_nodal_project(&v.p.made, 1, TERMS, v.psi, 1, v.x, 1, v.x, out), (void)0);
    varying_clear(&v);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_product_is_the_sum_of_bond_forces),
        cmocka_unit_test(the_product_is_that_of_the_mean_and_diagonals),
        cmocka_unit_test(the_matrix_is_that_of_the_products),
        cmocka_unit_test(projections_are_those_of_the_products),
        cmocka_unit_test(every_allocation_may_be_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
