// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/cracked.h"
#include "visible/visible_impl.h"

#include <cblas.h>
#include <lapacke.h>

static void at_rest(const double x[2], double u[2])
{
    (void)x;
    u[0] = u[1] = 0.0;
}

// Nodes of the plate first, ghosts after them: their numbers in the matrix.
static int order_nodes(const pdmc_visible *visible, int place[])
{
    int count = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0, last = visible->nodes.count, next = count; i < last; i++)
            if ((visible->nodes.node[i].edge >= 0) == (pass == 1)) {
                place[i] = next++;
                if (pass == 0) count = next;
            }
    return count;
}

// The mean matrix, its equations divided by the spacing to be those of a force per area, [2 nodes, 2 nodes].
static double *dense_matrix(const pdmc_visible *visible, const int place[])
{
    const size_t n = 2 * (size_t)visible->nodes.count;
    double *matrix = test_calloc(n * n, sizeof *matrix);
    for (int i = 0; i < visible->nodes.count; i++) {
        const pdmc_block_row *row = &visible->rows[i];
        for (int k = 0; k < 4 * row->count; k++) {
            const size_t r = (size_t)(2 * place[i] + k % 4 / 2), c = (size_t)(2 * place[row->column[k / 4]] + k % 2);
            matrix[r * n + c] += row->value[k] / visible->nodes.node[i].spacing;
        }
    }
    return matrix;
}

// The ghosts eliminated: A <- A_pp - A_pg A_gg^-1 A_gp in the first p rows and columns.
static void eliminate(int n, int p, double matrix[])
{
    const int g = n - p;
    if (g == 0) return;
    int *pivot = test_calloc((size_t)g, sizeof *pivot);
    double *corner = &matrix[(size_t)p * (size_t)n + (size_t)p], *left = &matrix[(size_t)p * (size_t)n];
    assert_int_equal(LAPACKE_dgesv(LAPACK_ROW_MAJOR, g, p, corner, n, pivot, left, n), 0);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, p, p, g, -1.0, &matrix[p], n, left, n, 1.0, matrix, n);
    test_free(pivot);
}

// The smallest real part among the eigenvalues, over the largest, when those that are zero are left out and counted.
static double smallest_share(const pdmc_visible *visible, int *zeros)
{
    const int n = 2 * visible->nodes.count;
    int *place = test_calloc((size_t)visible->nodes.count, sizeof *place);
    const int p = 2 * order_nodes(visible, place);
    double *matrix = dense_matrix(visible, place), *real = test_calloc((size_t)p, sizeof *real),
           *imaginary = test_calloc((size_t)p, sizeof *imaginary), least = INFINITY, most = 0.0;
    eliminate(n, p, matrix);
    assert_int_equal(LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', p, matrix, n, real, imaginary, NULL, 1, NULL, 1), 0);
    for (int i = 0; i < p; i++) most = fmax(most, real[i]);
    *zeros = 0;
    for (int i = 0; i < p; i++) {
        if (hypot(real[i], imaginary[i]) < 1e-9 * most) (*zeros)++;
        else least = fmin(least, real[i]);
    }
    test_free(imaginary);
    test_free(real);
    test_free(matrix);
    test_free(place);
    printf("  %d eigenvalues, %d zero, real parts of the others from %.2e to %.3g\n", p, *zeros, least, most);
    return least / most;
}

// All eigenvalues lie in the right half plane, but for the rigid motions of a plate that nothing holds: with known
// displacements outside and with tractions on the sides, with nodes finer than the horizon there and with a mouth.
static void eigenvalues_lie_in_the_right_half_plane(void **state)
{
    (void)state;
    const pdmc_visible_data known = {.outside = at_rest};
    const double tension[3] = {0.0, 1.0, 0.0};
    const struct {
        bool is_known;
        double horizon, spacing, from[2], to[2];
    } cases[5] = {{true, 0.2, 0.2, {-0.4, 0.0}, {0.4, 0.0}},
                  {false, 0.2, 0.2, {-0.4, 0.0}, {0.4, 0.1}},
                  {false, 0.3, 0.1, {-0.4, 0.0}, {0.4, 0.1}},
                  {false, 0.2, 0.2, {0.1, 0.0}, {0.85, 0.0}},
                  {false, 0.2, 0.2, {-1.1, 0.3}, {-0.3, 0.0}}};
    for (int i = 0; i < 5; i++) {
        plate p;
        pdmc_visible *visible = NULL;
        int zeros;
        cracked_make(&p, 2.0, cases[i].horizon, 4);
        p.problem.solver.spacing = cases[i].spacing;
        if (!cases[i].is_known) cracked_load(&p, tension);
        plate_crack(&p, 0.0, 0.0, 0.4, 0.0);
        for (int d = 0; d < 2; d++) {
            p.cracks[0].from[d] = cases[i].from[d];
            p.cracks[0].to[d] = cases[i].to[d];
        }
        CHECK_OK(pdmc_visible_create(&p.problem, cases[i].is_known ? &known : NULL, 2, &visible));
        assert_true(smallest_share(visible, &zeros) > 1e-5);
        assert_int_equal(zeros, cases[i].is_known ? 0 : 3);
        pdmc_visible_destroy(&visible);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(eigenvalues_lie_in_the_right_half_plane)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
