// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points in square cells, to find the nearest ones.

#include "pdmc/base.h"

typedef struct {
    double origin[2], cell; // length
    int columns, rows;
    int count, capacity;
    int *head; // [rows, columns] first point of a cell, -1 if none
    int *next; // [capacity]
    double *x; // [capacity, 2]
} pdmc_grid;

/// @param[in]  half  [2] half the extent of the region round the origin; points may lie outside
/// @param[out] grid  free with pdmc_grid_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_grid_create(const double half[2], double cell, int capacity, pdmc_grid *grid);
void pdmc_grid_clear(pdmc_grid *grid);

/// Forgets all points.
void pdmc_grid_empty(pdmc_grid *grid);

/// Adds a point; its index is the number of points before it.
void pdmc_grid_add(pdmc_grid *grid, const double x[2]);

/// Whether a point counts; NULL for all.
typedef bool (*pdmc_grid_accept)(const void *context, int point);

/// The points nearest to x, nearest first.
/// @param[out] found     [wanted]
/// @param[out] distance  [wanted] squared
/// @return how many there are, <= wanted
int pdmc_grid_nearest(const pdmc_grid *grid, const double x[2], int wanted, pdmc_grid_accept accept,
                      const void *context, int found[], double distance[]);
