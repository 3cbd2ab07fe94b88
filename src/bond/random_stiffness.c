// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/random_stiffness.h"

#include "bond/release.h"

#include <math.h>

// Of the correlation length, on which the stiffness hardly varies: the nodes of such a square are one point of a functional,
// whose direction costs as many covariances at each node as it has points.
static const double share = 0.1;

// The nearest point of the plate.
static void place(const pdmc_bond *bond, int node, double x[2])
{
    const pdmc_plate *plate = &bond->problem->plate;
    const double half[2] = {0.5 * plate->width, 0.5 * plate->height};
    pdmc_bond_grid_node(&bond->plate.grid, node, x);
    for (int k = 0; k < 2; k++) x[k] = fmin(fmax(x[k], -half[k]), half[k]);
}

// The squares of nodes, whose points all functionals share.
typedef struct {
    int side, columns, count;
    double *x; // [count, 2] the middle of the places of each square's nodes
} squares;

static int square_of(const pdmc_bond_grid *grid, const squares *all, int node)
{
    return node / grid->columns / all->side * all->columns + node % grid->columns / all->side;
}

static pdmc_status squares_create(const pdmc_bond *bond, double length, squares *all)
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond_grid *grid = &bond->plate.grid;
    int *nodes = NULL;
    all->side = (int)fmax(share * length / grid->spacing, 1.0);
    all->columns = (grid->columns + all->side - 1) / all->side;
    all->count = all->columns * ((grid->rows + all->side - 1) / all->side);
    PDMC_NEW(all->x, 2 * all->count);
    PDMC_NEW(nodes, all->count);
    for (int node = 0; node < grid->nodes; node++) {
        const int at = square_of(grid, all, node);
        double x[2];
        place(bond, node, x);
        nodes[at]++;
        for (int k = 0; k < 2; k++) all->x[2 * at + k] += (x[k] - all->x[2 * at + k]) / nodes[at];
    }
done:
    pdmc_free(nodes);
    return status;
}

static pdmc_status gather(const pdmc_bond *bond, const squares *all, const double release[],
                          pdmc_field_functional *functional)
{
    pdmc_status status = PDMC_OK;
    double *weight = NULL;
    PDMC_NEW(weight, all->count);
    for (int node = 0; node < bond->plate.grid.nodes; node++)
        weight[square_of(&bond->plate.grid, all, node)] += release[node];
    *functional = (pdmc_field_functional){all->count, all->x, weight};
done:
    return status;
}

static pdmc_status create_field(const pdmc_bond *bond, const pdmc_uncertainty *u, pdmc_bond_random_stiffness *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_plate *plate = &bond->problem->plate;
    const int tips = bond->problem->energy.tip_count;
    const size_t nodes = (size_t)bond->plate.grid.nodes;
    const pdmc_field_request request = {u->covariance, u->distribution, u->variation, u->modes};
    pdmc_field_functional *functional = NULL;
    squares all = {0};
    PDMC_TRY(squares_create(bond, u->covariance.length, &all));
    PDMC_NEW(functional, tips);
    PDMC_NEW(out->stiffness.release, (size_t)tips * nodes);
    for (int t = 0; t < tips; t++) {
        double *release = &out->stiffness.release[(size_t)t * nodes];
        PDMC_TRY(pdmc_bond_release(bond, bond->problem->energy.tips[t], release));
        PDMC_TRY(gather(bond, &all, release, &functional[t]));
    }
    PDMC_TRY(pdmc_field_create(&request, plate->width, plate->height, tips, functional, bond->threads, &out->field));
done:
    for (int t = 0; functional && t < tips; t++) pdmc_free((double *)functional[t].weight);
    pdmc_free(functional);
    pdmc_free(all.x);
    return status;
}

// By runs of nodes, side by side where there are threads.
static pdmc_status evaluate(const pdmc_bond *bond, pdmc_bond_random_stiffness *out)
{
    enum { RUN = 64 };
    pdmc_status status = PDMC_OK;
    const int nodes = bond->plate.grid.nodes, terms = pdmc_field_terms(out->field);
    out->stiffness.terms = terms;
    PDMC_NEW(out->stiffness.value, (size_t)nodes * (size_t)terms);
#pragma omp parallel for schedule(dynamic) num_threads(bond->threads)
    for (int first = 0; first < nodes; first += RUN) {
        double x[2 * RUN];
        const int count = nodes - first < RUN ? nodes - first : RUN;
        for (int k = 0; k < count; k++) place(bond, first + k, &x[2 * k]);
        const pdmc_status mine =
            pdmc_field_terms_at(out->field, count, x, &out->stiffness.value[(size_t)first * (size_t)terms]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_bond_random_stiffness)
            status = mine;
        }
    }
done:
    return status;
}

pdmc_status pdmc_bond_random_stiffness_create(const pdmc_bond *bond, pdmc_bond_random_stiffness *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *stiffness = pdmc_problem_uncertainty(bond->problem, PDMC_QUANTITY_STIFFNESS);
    *out = (pdmc_bond_random_stiffness){0};
    if (!stiffness) return PDMC_OK;
    PDMC_TRY(create_field(bond, stiffness, out));
    PDMC_TRY(evaluate(bond, out));
done:
    if (status != PDMC_OK) pdmc_bond_random_stiffness_clear(out);
    return status;
}

void pdmc_bond_random_stiffness_clear(pdmc_bond_random_stiffness *random)
{
    pdmc_field_destroy(&random->field);
    pdmc_free(random->stiffness.value);
    pdmc_free(random->stiffness.release);
    *random = (pdmc_bond_random_stiffness){0};
}
