// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/horizon.h"

#include "bond/cell.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

// The neighbours are numbered by 16 bits where they are stored for every bond: 31,700 at this reach.
enum { MOST_SPACINGS = 100 };

// A middle at the edge of the horizon counts as inside, one at the edge of a bin as in the next, a sliver of a cell as
// nothing, within these.
static const double edge_slack = 1e-9, least_share = 1e-14;

// The area of a cell as it counts, and the length that the energy of its bond has.
static double counted_area(const pdmc_solver_options *solver, const double middle[2], double *energy_length)
{
    const double h = solver->spacing, full = h * h, r = hypot(middle[0], middle[1]);
    *energy_length = r;
    if (solver->area == PDMC_AREA_FULL) return r <= solver->horizon * (1.0 + edge_slack) ? full : 0.0;
    if (solver->area == PDMC_AREA_PARTIAL) return full * fmin(fmax((solver->horizon - r) / h + 0.5, 0.0), 1.0);
    const pdmc_cell_part part = pdmc_cell_in_disc(middle, h, solver->horizon);
    if (solver->area == PDMC_AREA_CENTROID && part.area > least_share * full)
        *energy_length = hypot(part.moment[0], part.moment[1]) / part.area;
    return part.area;
}

// Of the eight neighbours that symmetry makes equal, the one with column >= row >= 0 stands for the shell.
static bool make_bond(const pdmc_problem *problem, int column, int row, pdmc_bond_neighbour *bond)
{
    const double h = problem->solver.spacing, middle[2] = {column * h, row * h}, r = hypot(middle[0], middle[1]);
    double energy_length;
    const double area = counted_area(&problem->solver, middle, &energy_length);
    if (area <= least_share * h * h) return false;
    *bond = (pdmc_bond_neighbour){.column = column, .row = row, .length = r, .area = area};
    for (int i = 0; i < 2; i++) bond->direction[i] = middle[i] / r;
    bond->stiffness = pdmc_micromodulus(&problem->material, problem->solver.horizon) * area * energy_length / (r * r);
    return true;
}

static int by_length(const void *a, const void *b)
{
    const pdmc_bond_neighbour *p = a, *q = b;
    if (p->length != q->length) return p->length < q->length ? -1 : 1;
    return p->column - q->column;
}

static int make_shells(const pdmc_problem *problem, int reach, pdmc_bond_neighbour shells[])
{
    int count = 0;
    for (int column = 1; column <= reach; column++)
        for (int row = 0; row <= column; row++)
            if (make_bond(problem, column, row, &shells[count])) count++;
    qsort(shells, (size_t)count, sizeof *shells, by_length);
    for (int s = 0; s < count; s++) shells[s].shell = s;
    return count;
}

static int sign(int i)
{
    return (i > 0) - (i < 0);
}

static pdmc_bond_neighbour mirrored(const pdmc_bond_neighbour *shell, int column, int row)
{
    const bool is_swapped = abs(row) > abs(column);
    pdmc_bond_neighbour bond = *shell;
    bond.column = column;
    bond.row = row;
    bond.direction[0] = sign(column) * shell->direction[is_swapped ? 1 : 0];
    bond.direction[1] = sign(row) * shell->direction[is_swapped ? 0 : 1];
    return bond;
}

// shell_of [reach + 1, reach + 1] by the larger, then the smaller offset; -1 for none
static pdmc_status make_neighbours(int reach, const pdmc_bond_neighbour shells[], const int shell_of[],
                                   pdmc_bond_horizon *out)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(out->neighbour, (2 * reach + 1) * (2 * reach + 1));
    for (int row = -reach; row <= reach; row++) {
        for (int column = -reach; column <= reach; column++) {
            const int larger = abs(row) > abs(column) ? abs(row) : abs(column),
                      smaller = abs(row) + abs(column) - larger;
            const int shell = shell_of[larger * (reach + 1) + smaller];
            if (shell >= 0) out->neighbour[out->count++] = mirrored(&shells[shell], column, row);
        }
    }
done:
    return status;
}

// The share of each bin in the part of the cell inside the horizon. A cell that counts in full although its middle is
// near the edge has the part beyond it in the last bin.
static void average_over_cell(const pdmc_solver_options *solver, const pdmc_bond_neighbour *shell, int shells, int bins,
                              double share[])
{
    const double h = solver->spacing, width = solver->horizon / bins, middle[2] = {shell->column * h, shell->row * h};
    const bool is_full = solver->area == PDMC_AREA_FULL;
    const double whole = is_full ? h * h : pdmc_cell_in_disc(middle, h, solver->horizon).area;
    const double distance = hypot(middle[0], middle[1]);
    const int first = (int)fmin(fmax(floor((distance - M_SQRT1_2 * h) / width), 0.0), bins - 1);
    double below = 0.0; // of the cell's area
    for (int bin = first; bin < bins && below < whole; bin++) {
        const bool is_last = bin == bins - 1;
        const double above = is_last ? whole : fmin(pdmc_cell_in_disc(middle, h, (bin + 1) * width).area, whole);
        share[(size_t)bin * (size_t)shells] = fmax(above - below, 0.0) / whole;
        below = fmax(above, below);
    }
}

static void share_bins(const pdmc_solver_options *solver, const pdmc_bond_neighbour shells[], pdmc_bond_horizon *out)
{
    for (int s = 0; s < out->shells; s++) {
        if (solver->micromodulus == PDMC_MICROMODULUS_AVERAGED) {
            average_over_cell(solver, &shells[s], out->shells, out->bins, &out->share[s]);
        } else {
            const double at = hypot(shells[s].column, shells[s].row) * solver->spacing / solver->horizon * out->bins;
            const int bin = (int)fmin(floor(at + edge_slack), out->bins - 1);
            out->share[(size_t)bin * (size_t)out->shells + (size_t)s] = 1.0;
        }
    }
}

pdmc_status pdmc_bond_horizon_create(const pdmc_problem *problem, int bins, pdmc_bond_horizon *out)
{
    const double spacings = problem->solver.horizon / problem->solver.spacing;
    *out = (pdmc_bond_horizon){.bins = bins};
    PDMC_REQUIRE(bins >= 1, "%d bins of the micromodulus", bins);
    PDMC_REQUIRE(spacings <= MOST_SPACINGS, "a horizon of %g spacings is more than %d", spacings, MOST_SPACINGS);

    pdmc_status status = PDMC_OK;
    const int reach = (int)spacings + 2;
    pdmc_bond_neighbour *shells = NULL;
    int *shell_of = NULL;
    PDMC_NEW(shells, (reach + 1) * (reach + 2) / 2);
    PDMC_NEW(shell_of, (reach + 1) * (reach + 1));
    out->shells = make_shells(problem, reach, shells);
    for (int k = 0; k < (reach + 1) * (reach + 1); k++) shell_of[k] = -1;
    for (int s = 0; s < out->shells; s++) shell_of[shells[s].column * (reach + 1) + shells[s].row] = s;
    PDMC_TRY(make_neighbours(reach, shells, shell_of, out));
    PDMC_NEW(out->shell_length, out->shells);
    for (int s = 0; s < out->shells; s++) out->shell_length[s] = shells[s].length;
    PDMC_NEW(out->share, (size_t)bins * (size_t)out->shells);
    share_bins(&problem->solver, shells, out);
done:
    if (status != PDMC_OK) pdmc_bond_horizon_clear(out);
    pdmc_free(shell_of);
    pdmc_free(shells);
    return status;
}

void pdmc_bond_horizon_clear(pdmc_bond_horizon *horizon)
{
    pdmc_free(horizon->neighbour);
    pdmc_free(horizon->shell_length);
    pdmc_free(horizon->share);
    *horizon = (pdmc_bond_horizon){0};
}
