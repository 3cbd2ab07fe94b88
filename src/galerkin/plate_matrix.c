// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate_form.h"

#include "base/base_impl.h"

#include <string.h>

static void sum_planes(const pdmc_plate_form *form, const double weight[], int64_t entry, double block[3])
{
    const double *value = &form->value[(size_t)entry * (size_t)form->planes * 3];
    for (int k = 0; k < 3; k++) block[k] = 0.0;
    for (int p = 0; p < form->planes; p++)
        for (int k = 0; k < 3; k++) block[k] += weight[p] * value[3 * p + k];
}

static void add_block_product(const double block[3], const double x[2], double y[2])
{
    y[0] += block[0] * x[0] + block[1] * x[1];
    y[1] += block[1] * x[0] + block[2] * x[1];
}

void pdmc_plate_form_multiply(const pdmc_plate_form *form, const double weight[], const double x[], double y[])
{
    memset(y, 0, 2 * (size_t)form->count * sizeof *y);
    for (int j = 0; j < form->count; j++)
        for (int64_t k = form->start[j]; k < form->start[j + 1]; k++) {
            const int64_t i = form->row[k];
            double block[3];
            sum_planes(form, weight, k, block);
            add_block_product(block, &x[2 * (size_t)j], &y[2 * i]);
            if (i != j) add_block_product(block, &x[2 * i], &y[2 * (size_t)j]);
        }
}

// Column `component` of value j, from the diagonal down; counts only where there is no matrix.
static int64_t visit_column(const pdmc_plate_form *form, const double weight[], const uint8_t held[], int j,
                            int component, int64_t at, pdmc_sparse_matrix *matrix)
{
    const bool is_held = held[j] & (1U << component);
    for (int64_t k = form->start[j]; k < form->start[j + 1]; k++) {
        const int64_t i = form->row[k];
        double block[3] = {1.0, 0.0, 1.0};
        if (is_held && i > j) break;
        if (matrix && !is_held) sum_planes(form, weight, k, block);
        for (int c = i == j ? component : 0; c < 2; c++) {
            if (c != component || i != j)
                if (is_held || held[i] & (1U << c)) continue;
            if (matrix) {
                matrix->row[at] = 2 * i + c;
                matrix->value[at] = block[c + component];
            }
            at++;
        }
    }
    return at;
}

pdmc_status pdmc_plate_form_matrix(const pdmc_plate_form *form, const double weight[], const uint8_t held[],
                                   pdmc_sparse_matrix *matrix)
{
    pdmc_status status = PDMC_OK;
    pdmc_sparse_matrix made = {.unknowns = 2 * form->count};
    *matrix = (pdmc_sparse_matrix){0};
    PDMC_NEW(made.start, made.unknowns + 1);
    for (int k = 0; k < made.unknowns; k++)
        made.start[k + 1] = visit_column(form, weight, held, k / 2, k % 2, made.start[k], NULL);
    PDMC_NEW(made.row, made.start[made.unknowns]);
    PDMC_NEW(made.value, made.start[made.unknowns]);
    for (int k = 0; k < made.unknowns; k++) visit_column(form, weight, held, k / 2, k % 2, made.start[k], &made);
    *matrix = made;
    made = (pdmc_sparse_matrix){0};
done:
    pdmc_sparse_matrix_clear(&made);
    return status;
}
