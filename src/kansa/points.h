// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Where the equations are collocated.

#include "kansa/basis.h"

/// A point of the plate where the peridynamic equation is asked for.
typedef struct {
    double x[2];
    double spacing;   // local distance of points; turns force / volume into a stress
    double clearance; // distance to the nearest tip, infinite without cracks
} pdmc_interior_point;

/// A point of a side or of a crack's face, where traction or displacement is prescribed.
typedef struct {
    double x[2], anchor[2]; // the anchor lies on the point's own side of the crack
    double normal[2];       // outward
    double weight;          // sqrt(1 - t^2) on a face, where tractions of single fields grow as its inverse
    int side;               // pdmc_side, or -1 on a crack's face
} pdmc_boundary_point;

typedef struct {
    int interior_count, boundary_count;
    pdmc_interior_point *interior; // [interior_count]
    pdmc_boundary_point *boundary; // [boundary_count], sides first
    int side_count;                // how many of them lie on sides
    int columns, rows;             // of the grid of nodes
    double spacing[2];
} pdmc_collocation;

/// The centres of the multiquadrics: the grid of nodes and one ring of ghost nodes outside.
PDMC_NODISCARD pdmc_status pdmc_kansa_nodes(const pdmc_problem *problem, double spacing, pdmc_basis *basis);

/// Collocation points: the nodes, confocal rings around each crack, points on the sides and on the faces. Points within
/// 1.5 horizons of a tip are left out (rows there ruin K: -86 % was measured), as are points on a crack.
PDMC_NODISCARD pdmc_status pdmc_collocation_create(const pdmc_problem *problem, double spacing, const pdmc_basis *basis,
                                                   pdmc_collocation *points);
void pdmc_collocation_clear(pdmc_collocation *points);
