// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/grid.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_CELLS_A_SIDE = 512 };

pdmc_status pdmc_grid_create(const double half[2], double cell, int capacity, pdmc_grid *grid)
{
    pdmc_status status = PDMC_OK;
    const double size = fmax(cell, 2.0 * fmax(half[0], half[1]) / MOST_CELLS_A_SIDE);
    *grid = (pdmc_grid){.origin = {-half[0], -half[1]}, .cell = size, .capacity = capacity};
    grid->columns = (int)ceil(2.0 * half[0] / size);
    grid->rows = (int)ceil(2.0 * half[1] / size);
    PDMC_NEW(grid->head, grid->columns * grid->rows);
    PDMC_NEW(grid->next, capacity);
    PDMC_NEW(grid->x, 2 * capacity);
    pdmc_grid_empty(grid);
done:
    if (status != PDMC_OK) pdmc_grid_clear(grid);
    return status;
}

void pdmc_grid_clear(pdmc_grid *grid)
{
    pdmc_free(grid->head);
    pdmc_free(grid->next);
    pdmc_free(grid->x);
    *grid = (pdmc_grid){0};
}

void pdmc_grid_empty(pdmc_grid *grid)
{
    for (int i = 0; i < grid->columns * grid->rows; i++) grid->head[i] = -1;
    grid->count = 0;
}

static void cell_of(const pdmc_grid *grid, const double x[2], int at[2])
{
    const int most[2] = {grid->columns - 1, grid->rows - 1};
    for (int k = 0; k < 2; k++) at[k] = (int)fmin(fmax(floor((x[k] - grid->origin[k]) / grid->cell), 0.0), most[k]);
}

void pdmc_grid_add(pdmc_grid *grid, const double x[2])
{
    int at[2];
    cell_of(grid, x, at);
    int *head = &grid->head[at[1] * grid->columns + at[0]];
    const int point = grid->count++;
    grid->x[2 * point] = x[0];
    grid->x[2 * point + 1] = x[1];
    grid->next[point] = *head;
    *head = point;
}

typedef struct {
    const pdmc_grid *grid;
    const double *x;
    int wanted, count;
    pdmc_grid_accept accept;
    const void *context;
    int *found;
    double *distance;
} search;

// Equal distances are kept in the order of the points, whatever the order of the cells.
static bool comes_before(const search *s, double distance, int point, int k)
{
    return distance < s->distance[k] || (distance == s->distance[k] && point < s->found[k]);
}

static void offer(search *s, int point)
{
    const double dx = s->grid->x[2 * point] - s->x[0], dy = s->grid->x[2 * point + 1] - s->x[1];
    const double distance = dx * dx + dy * dy;
    if (s->count == s->wanted && !comes_before(s, distance, point, s->count - 1)) return;
    if (s->accept && !s->accept(s->context, point)) return;
    int k = s->count < s->wanted ? s->count++ : s->count - 1;
    for (; k > 0 && comes_before(s, distance, point, k - 1); k--) {
        s->found[k] = s->found[k - 1];
        s->distance[k] = s->distance[k - 1];
    }
    s->found[k] = point;
    s->distance[k] = distance;
}

static void scan_cell(search *s, int column, int row)
{
    const pdmc_grid *grid = s->grid;
    if (column < 0 || column >= grid->columns || row < 0 || row >= grid->rows) return;
    for (int p = grid->head[row * grid->columns + column]; p >= 0; p = grid->next[p]) offer(s, p);
}

// The cells at a distance of `ring` cells.
static void scan_ring(search *s, const int at[2], int ring)
{
    for (int j = -ring; j <= ring; j++) {
        const int step = abs(j) == ring || ring == 0 ? 1 : 2 * ring;
        for (int i = -ring; i <= ring; i += step) scan_cell(s, at[0] + i, at[1] + j);
    }
}

int pdmc_grid_nearest(const pdmc_grid *grid, const double x[2], int wanted, pdmc_grid_accept accept,
                      const void *context, int found[], double distance[])
{
    search s = {grid, x, wanted, 0, accept, context, found, distance};
    int at[2];
    cell_of(grid, x, at);
    const int rings = grid->columns > grid->rows ? grid->columns : grid->rows;
    for (int ring = 0; ring <= rings; ring++) {
        scan_ring(&s, at, ring);
        const double seen = ring * grid->cell; // all points nearer than this have been offered
        if (s.count == wanted && distance[wanted - 1] < seen * seen) break;
    }
    return s.count;
}
