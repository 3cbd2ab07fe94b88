// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/solid.h"

#include <stdbool.h>

/// A point of another cell within the horizon of a node: the same for every node of the grid.
typedef struct {
    int shift[3];     // from the node's cell to the point's
    int point;        // of the cell
    double xi[3];     // from the node to the point
    double stiffness; // volume c / |xi|^3
} solid_bond;

typedef struct {
    int points;      // in a cell
    double (*at)[3]; // [points] from the cell's node
    int count;
    solid_bond *bond; // [count]
} solid_stencil;

/// Shape functions of all points of a cell, for every class of nodes (interpolation.c).
typedef struct {
    int nodes[3], points, reach, classes[3];
    size_t terms;
    size_t *first;   // [class, point] where its terms begin; one more at the end
    int (*shift)[3]; // [terms] from the cell's node to the one that contributes
    double *weight;  // [terms]
} solid_interpolation;

struct pdmc_solid {
    pdmc_solid_options options;
    size_t nodes;
    double micromodulus;
    solid_stencil stencil;
    solid_interpolation interpolation; // PDMC_SOLID_GAUSS only
    double *points;                    // [points of a cell, 3, nodes] where they are displaced to; the same
    pdmc_solid *cells;                 // the same body by cubic cells, whose matrix is symmetric; the same
    double *compensation;              // [nodes]
    unsigned char *prescribed;         // [nodes]
    bool loaded[PDMC_SOLID_FACES];     // whether a traction acts there
    double *traction;                  // [3, nodes]
    double *row_sum;                   // [3, nodes]
};

/// The points of a rule within the horizon of a node.
pdmc_status solid_stencil_create(const pdmc_solid_options *options, double micromodulus, solid_stencil *stencil);
void solid_stencil_clear(solid_stencil *stencil);

pdmc_status solid_interpolation_create(const pdmc_solid_options *options, const solid_stencil *stencil,
                                       solid_interpolation *interpolation);
void solid_interpolation_clear(solid_interpolation *interpolation);
void solid_interpolate(const solid_interpolation *interpolation, int threads, size_t nodes, const double u[],
                       double points[]);

/// beta_s of every node, once the stencil is there.
void solid_compensate(pdmc_solid *solid);

/// W_bdry / W_inf of an isotropic strain in closed form, beyond faces without traction.
double solid_horizon_share(const pdmc_solid *solid, const int index[3]);

/// Force densities of the loads on the faces, once the compensation is there.
pdmc_status solid_add_tractions(pdmc_solid *solid);

/// Adds the bonds' force densities, given the displacement of all cells' points, [point, 3, nodes]; sets the energies.
void solid_add_bond_forces(const pdmc_solid *solid, const double u[], const double points[], double force[],
                           double energy[]);

double solid_dot(size_t count, const double a[], const double b[]);
double solid_norm(size_t count, const double a[]);

/// The rigid motions of a body that nothing holds, orthonormal; none of one that is held.
typedef struct {
    int count;
    size_t size;
    double *mode; // [count, size]
} solid_rigid;

pdmc_status solid_rigid_create(const pdmc_solid *solid, solid_rigid *rigid);
void solid_rigid_remove(const solid_rigid *rigid, double v[]);
void solid_rigid_clear(solid_rigid *rigid);

/// Three indices of a node.
static inline void solid_indices(const pdmc_solid *solid, size_t node, int index[3])
{
    const size_t row = (size_t)solid->options.nodes[0], layer = row * (size_t)solid->options.nodes[1];
    index[0] = (int)(node % row);
    index[1] = (int)(node % layer / row);
    index[2] = (int)(node / layer);
}

static inline size_t solid_node(const pdmc_solid *solid, const int index[3])
{
    const int *n = solid->options.nodes;
    return ((size_t)index[2] * (size_t)n[1] + (size_t)index[1]) * (size_t)n[0] + (size_t)index[0];
}

static inline bool solid_inside(const pdmc_solid *solid, const int index[3], const int shift[3])
{
    for (int k = 0; k < 3; k++)
        if (index[k] + shift[k] < 0 || index[k] + shift[k] >= solid->options.nodes[k]) return false;
    return true;
}
