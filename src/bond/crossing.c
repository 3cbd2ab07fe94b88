// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/crossing.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

double pdmc_bond_crossing_bias(const pdmc_problem *problem, const pdmc_bond_horizon *horizon, double phi)
{
    const double h = problem->solver.spacing, delta = problem->solver.horizon;
    double sum = 0.0; // over both ends of every bond
    for (int k = 0; k < horizon->count; k++) {
        const pdmc_bond_neighbour *n = &horizon->neighbour[k];
        const double across = h * fabs(n->row * cos(phi) - n->column * sin(phi)); // bonds on a unit of the line: / h^2
        sum += 0.5 * across / (h * h) * 0.5 * n->stiffness * h * h * n->length * n->length;
    }
    return sum / (0.25 * pdmc_micromodulus(&problem->material, delta) * gsl_pow_4(delta));
}

typedef struct {
    const pdmc_bond *bond;
    double tip[2], direction[2], extension; // of the line
    double scale;                           // 1 / (delta_alpha R c_0)
    int capacity;
    pdmc_crossing *crossing;
} collector;

// Cuts the share [t[0], t[1]] of a bond down to where low <= start + t step <= high.
static void clip(double start, double step, double low, double high, double t[2])
{
    if (step == 0.0) {
        if (start < low || start > high) t[1] = t[0];
        return;
    }
    const double a = (low - start) / step, b = (high - start) / step;
    t[0] = fmax(t[0], fmin(a, b));
    t[1] = fmin(t[1], fmax(a, b));
}

// A bond across the line is before an end of the strip or behind it, or on it: then a half, as of its neighbours in phi,
// and not what rounding makes of it.
static double share_between_ends(double along, double extension, double tiny)
{
    if (along < -tiny || along > extension + tiny) return 0.0;
    return along < tiny || along > extension - tiny ? 0.5 : 1.0;
}

// The share of the strip that the bond crosses. In the line's frame a bond begins at p and goes by q.
static double share_of_crossings(const collector *c, const double a[2], const double b[2])
{
    const double h = c->bond->plate.grid.spacing, *d = c->direction;
    const double p[2] = {d[0] * (a[0] - c->tip[0]) + d[1] * (a[1] - c->tip[1]),
                         d[0] * (a[1] - c->tip[1]) - d[1] * (a[0] - c->tip[0])};
    const double q[2] = {d[0] * (b[0] - a[0]) + d[1] * (b[1] - a[1]), d[0] * (b[1] - a[1]) - d[1] * (b[0] - a[0])};
    const double tiny = 1e-9 * h;
    double t[2] = {0.0, 1.0}, between = 1.0;
    if (fabs(q[0]) < tiny) between = share_between_ends(p[0], c->extension, tiny);
    else clip(p[0], q[0], 0.0, c->extension, t);
    clip(p[1], q[1], -0.5 * h, 0.5 * h, t);
    return t[1] > t[0] ? between * (t[1] - t[0]) * fabs(q[1]) / h : 0.0;
}

static pdmc_status make_room(collector *c)
{
    pdmc_status status = PDMC_OK;
    pdmc_crossing old = *c->crossing, new = {.bonds = old.bonds};
    const size_t bonds = (size_t)old.bonds;
    if (old.bonds < c->capacity) return PDMC_OK;
    c->capacity = 2 * c->capacity + 64;
    PDMC_NEW(new.row, c->capacity * PDMC_BOND_ENDS);
    PDMC_NEW(new.column, c->capacity * PDMC_BOND_ENDS);
    PDMC_NEW(new.ring, c->capacity);
    if (bonds > 0) {
        memcpy(new.row, old.row, bonds * PDMC_BOND_ENDS * sizeof *new.row);
        memcpy(new.column, old.column, bonds * PDMC_BOND_ENDS * sizeof *new.column);
        memcpy(new.ring, old.ring, bonds * sizeof *new.ring);
    }
    *c->crossing = new;
    new = old;
done:
    pdmc_free(new.row);
    pdmc_free(new.column);
    pdmc_free(new.ring);
    return status;
}

static pdmc_status add_bond(collector *c, int from, int to, const pdmc_bond_neighbour *n, double share)
{
    const pdmc_status status = make_room(c);
    if (status != PDMC_OK) return status;
    const double h = c->bond->plate.grid.spacing, *correction = c->bond->plate.families.scale;
    const double stiffness = n->stiffness * 0.5 * (correction[from] + correction[to]);
    const double root = sqrt(c->scale * share * stiffness) * h;
    pdmc_crossing *crossing = c->crossing;
    double *row = &crossing->row[crossing->bonds * PDMC_BOND_ENDS];
    int *column = &crossing->column[crossing->bonds * PDMC_BOND_ENDS];
    for (int k = 0; k < 2; k++) {
        row[k] = -root * n->direction[k];
        row[2 + k] = root * n->direction[k];
        column[k] = 2 * from + k;
        column[2 + k] = 2 * to + k;
    }
    crossing->ring[crossing->bonds++] = n->shell;
    return PDMC_OK;
}

// Each bond once, from the node whose neighbour is in the second half.
static pdmc_status add_bonds_of(collector *c, int node)
{
    const pdmc_bond_plate *plate = &c->bond->plate;
    const pdmc_bond_families *families = &plate->families;
    double a[2], b[2];
    pdmc_bond_grid_node(&plate->grid, node, a);
    for (size_t k = families->start[node]; k < families->start[node + 1]; k++) {
        const int neighbour = families->neighbour[k];
        if (2 * neighbour < plate->horizon.count) continue;
        pdmc_bond_grid_node(&plate->grid, families->partner[k], b);
        const double share = share_of_crossings(c, a, b);
        if (share == 0.0) continue;
        const pdmc_status status = add_bond(c, node, families->partner[k], &plate->horizon.neighbour[neighbour], share);
        if (status != PDMC_OK) return status;
    }
    return PDMC_OK;
}

// The nodes whose bonds can reach the line: a rectangle of columns and rows.
static pdmc_status collect(collector *c)
{
    const pdmc_bond_grid *grid = &c->bond->plate.grid;
    const double reach = c->bond->problem->solver.horizon + grid->spacing;
    int first[2], last[2];
    const int most[2] = {grid->columns - 1, grid->rows - 1};
    for (int k = 0; k < 2; k++) {
        const double end = c->tip[k] + c->extension * c->direction[k];
        const double low = fmin(c->tip[k], end) - reach, high = fmax(c->tip[k], end) + reach;
        first[k] = (int)fmax(ceil((low - grid->origin[k]) / grid->spacing), 0.0);
        last[k] = (int)fmin(floor((high - grid->origin[k]) / grid->spacing), most[k]);
    }
    for (int row = first[1]; row <= last[1]; row++)
        for (int column = first[0]; column <= last[0]; column++) {
            const pdmc_status status = add_bonds_of(c, row * grid->columns + column);
            if (status != PDMC_OK) return status;
        }
    return PDMC_OK;
}

pdmc_status pdmc_bond_crossing_create(const pdmc_bond *bond, int tip, double phi, pdmc_crossing *crossing)
{
    const pdmc_problem *problem = bond->problem;
    const pdmc_crack *crack = &problem->cracks[tip / 2];
    const double *position = tip % 2 ? crack->to : crack->from, extension = problem->energy.extension;
    const double bias = pdmc_bond_crossing_bias(problem, &bond->plate.horizon, phi);
    collector c = {
        .bond = bond,
        .tip = {position[0], position[1]},
        .direction = {cos(phi), sin(phi)},
        .extension = extension,
        .scale = 1.0 / (extension * bias * pdmc_micromodulus(&problem->material, problem->solver.horizon)),
        .crossing = crossing,
    };
    *crossing = (pdmc_crossing){0};
    return collect(&c);
}
