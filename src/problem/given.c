// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/given.h"

#include "base/base_impl.h"
#include "problem/columns.h"

#include <gsl/gsl_interp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- values ----

// By degree, and in one degree from x^n to y^n.
static double polynomial_at(const pdmc_given *g, int dimension, const double x[])
{
    double sum = 0.0;
    int degree = 0, of_y = 0;
    for (int k = 0; k < g->coefficient_count; k++) {
        sum += g->coefficients[k] * pow(x[0], degree - of_y) * (dimension == 2 ? pow(x[1], of_y) : 1.0);
        if (dimension == 1 || of_y == degree) {
            degree++;
            of_y = 0;
        } else {
            of_y++;
        }
    }
    return sum;
}

// The point before a place, and how far on the way to the next one it is.
static size_t place_in(int count, const double at[], double x, double *share)
{
    const size_t i = gsl_interp_bsearch(at, x, 0, (size_t)count - 1);
    *share = fmin(1.0, fmax(0.0, (x - at[i]) / (at[i + 1] - at[i])));
    return i;
}

static double along_row(const pdmc_given *g, size_t row, size_t column, double share)
{
    const double *value = &g->table[row * (size_t)g->columns + column];
    return (1.0 - share) * value[0] + share * value[1];
}

static double table_at(const pdmc_given *g, const double x[])
{
    double across, up;
    const size_t column = place_in(g->columns, g->x, x[0], &across);
    if (g->rows == 1) return along_row(g, 0, column, across);
    const size_t row = place_in(g->rows, g->y, x[1], &up);
    return (1.0 - up) * along_row(g, row, column, across) + up * along_row(g, row + 1, column, across);
}

double pdmc_given_at(const pdmc_given *given, int dimension, const double x[])
{
    switch (given->kind) {
    case PDMC_GIVEN_CONSTANT: break;
    case PDMC_GIVEN_POLYNOMIAL: return polynomial_at(given, dimension, x);
    case PDMC_GIVEN_TABLE: return table_at(given, x);
    }
    return given->value;
}

// ---- tables ----

typedef struct {
    double y, x, value;
    int line;
} entry;

static int by_place(const void *a, const void *b)
{
    const entry *p = a, *q = b;
    if (p->y != q->y) return p->y < q->y ? -1 : 1;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    return (p->line > q->line) - (p->line < q->line);
}

// The entries in order are the rows of the grid, each with the x of the first one.
static pdmc_status check_grid(const char *path, int dimension, int count, const entry entries[], int *columns)
{
    int n = 1;
    while (n < count && entries[n].y == entries[0].y) n++;
    for (int k = 0; k < count; k++) {
        const entry *e = &entries[k], *before = e - 1;
        if (k > 0 && e->x == before->x && e->y == before->y)
            return pdmc_raise(PDMC_ERR_DATA, "%s:%d: the point is in the place of that of line %d", path, e->line,
                              before->line);
        if (e->x != entries[k % n].x || e->y != entries[k - k % n].y)
            return pdmc_raise(PDMC_ERR_DATA, "%s:%d: the points are no grid: each row must have the same x", path,
                              e->line);
    }
    if (count % n != 0 || n < 2 || (dimension == 2 && count / n < 2))
        return pdmc_raise(PDMC_ERR_DATA, "%s: %d points are no grid of two or more %s", path, count,
                          dimension == 1 ? "points" : "columns and rows");
    *columns = n;
    return PDMC_OK;
}

static pdmc_status fill(int count, const entry entries[], int columns, pdmc_given *given)
{
    pdmc_status status = PDMC_OK;
    given->columns = columns;
    given->rows = count / columns;
    PDMC_NEW(given->x, columns);
    PDMC_NEW(given->y, given->rows);
    PDMC_NEW(given->table, count);
    for (int k = 0; k < columns; k++) given->x[k] = entries[k].x;
    for (int k = 0; k < given->rows; k++) given->y[k] = entries[k * columns].y;
    for (int k = 0; k < count; k++) given->table[k] = entries[k].value;
done:
    return status;
}

pdmc_status pdmc_given_read(const char *path, int dimension, pdmc_given *given)
{
    pdmc_status status = PDMC_OK;
    pdmc_columns lines = {0};
    entry *entries = NULL;
    int columns = 0;
    PDMC_TRY(pdmc_columns_read(path, dimension + 1, "point",
                               dimension == 1 ? "two numbers, x value" : "three numbers, x y value", &lines));
    PDMC_NEW(entries, lines.count);
    for (int k = 0; k < lines.count; k++) {
        const double *numbers = &lines.number[(size_t)k * (size_t)lines.columns];
        entries[k] =
            (entry){dimension == 2 ? numbers[1] : 0.0, numbers[0], numbers[dimension], lines.line[k]};
    }
    qsort(entries, (size_t)lines.count, sizeof *entries, by_place);
    PDMC_TRY(check_grid(path, dimension, lines.count, entries, &columns));
    PDMC_TRY(fill(lines.count, entries, columns, given));
done:
    pdmc_free(entries);
    pdmc_columns_clear(&lines);
    return status;
}

void pdmc_given_clear(pdmc_given *given)
{
    pdmc_free(given->coefficients);
    pdmc_free(given->file);
    pdmc_free(given->x);
    pdmc_free(given->y);
    pdmc_free(given->table);
    *given = (pdmc_given){0};
}
