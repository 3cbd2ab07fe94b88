// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/pattern.h"

#include "base/base_impl.h"

#include <stdlib.h>
#include <string.h>

// The elements of each free value.
typedef struct {
    int *start;   // [free_count + 1]
    int *element; // [start[free_count]]
} owners;

static pdmc_status owners_create(const pdmc_space *space, owners *o)
{
    pdmc_status status = PDMC_OK;
    const int n = space->mesh->dimension + 1, corners = space->mesh->element_count * n, free_count = space->free_count;
    PDMC_NEW(o->start, free_count + 2);
    PDMC_NEW(o->element, corners);
    int *next = o->start + 1; // becomes start[i + 1] once all are placed
    for (int k = 0; k < corners; k++)
        if (space->value[k] < free_count) next[space->value[k] + 1]++;
    for (int i = 0; i < free_count; i++) next[i + 1] += next[i];
    for (int k = 0; k < corners; k++)
        if (space->value[k] < free_count) o->element[next[space->value[k]]++] = k / n;
done:
    return status;
}

typedef struct {
    const pdmc_space *space;
    const pdmc_neighbours *neighbours;
    owners of;
    int *seen; // [count] 1 + the last column in which the value was found
} finder;

// The rows of a column, not sorted; counts only where there is no room given.
static int64_t find_rows(finder *f, int column, int mark, int64_t rows[])
{
    const int n = f->space->mesh->dimension + 1;
    int64_t count = 0;
    for (int o = f->of.start[column]; o < f->of.start[column + 1]; o++) {
        const int e = f->of.element[o];
        for (int64_t k = f->neighbours->start[e]; k < f->neighbours->start[e + 1]; k++)
            for (int a = 0; a < n; a++) {
                const int row = f->space->value[n * f->neighbours->element[k] + a];
                if (row < column || f->seen[row] == mark) continue;
                f->seen[row] = mark;
                if (rows) rows[count] = row;
                count++;
            }
    }
    return count;
}

static int compare(const void *a, const void *b)
{
    const int64_t i = *(const int64_t *)a, j = *(const int64_t *)b;
    return (i > j) - (i < j);
}

pdmc_status pdmc_form_pattern(const pdmc_space *space, const pdmc_neighbours *neighbours, pdmc_form *form)
{
    pdmc_status status = PDMC_OK;
    const int n = space->free_count;
    finder f = {.space = space, .neighbours = neighbours};
    pdmc_form made = {.free_count = n};
    *form = (pdmc_form){0};
    PDMC_TRY(owners_create(space, &f.of));
    PDMC_NEW(f.seen, space->count);
    PDMC_NEW(made.start, n + 1);
    for (int j = 0; j < n; j++) made.start[j + 1] = made.start[j] + find_rows(&f, j, j + 1, NULL);
    PDMC_NEW(made.row, made.start[n]);
    PDMC_NEW(made.value, made.start[n]);
    for (int j = 0; j < n; j++) {
        int64_t *rows = &made.row[made.start[j]];
        qsort(rows, (size_t)find_rows(&f, j, -j - 1, rows), sizeof *rows, compare);
    }
    *form = made;
    made = (pdmc_form){0};
done:
    pdmc_free(f.of.start);
    pdmc_free(f.of.element);
    pdmc_free(f.seen);
    pdmc_form_clear(&made);
    return status;
}

void pdmc_form_add(pdmc_form *form, int i, int j, double value)
{
    const int column = i < j ? i : j, row = i < j ? j : i;
    if (column >= form->free_count) return;
    int64_t low = form->start[column], high = form->start[column + 1] - 1;
    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (form->row[middle] < row) low = middle + 1;
        else high = middle;
    }
    form->value[low] += value;
}

void pdmc_form_clear(pdmc_form *form)
{
    pdmc_free(form->start);
    pdmc_free(form->row);
    pdmc_free(form->value);
    *form = (pdmc_form){0};
}

void pdmc_form_multiply(const pdmc_form *form, const double x[], double y[])
{
    const int n = form->free_count;
    memset(y, 0, (size_t)n * sizeof *y);
    for (int j = 0; j < n; j++)
        for (int64_t k = form->start[j]; k < form->start[j + 1]; k++) {
            const int64_t i = form->row[k];
            y[j] += form->value[k] * x[i];
            if (i != j && i < n) y[i] += form->value[k] * x[j];
        }
}
