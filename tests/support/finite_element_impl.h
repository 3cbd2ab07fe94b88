// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"
#include "support/finite_element.h"

enum { SHAPES = 9, GAUSS_POINTS = 16 };

/// Rectangles between grid lines. Nodes lie on a lattice of these lines and those midway between them; the nodes of the
/// upper face come after all others.
typedef struct {
    int cells[2];    // [axis]
    double *line[2]; // [axis][2 cells + 1] of the lattice
    int tip[2];      // lattice column of each tip
    int middle;      // lattice row of the crack
    int nodes;
    double radius; // half the side of the graded squares
} finite_element_mesh;

/// Of one element: its rectangle and its nodes, row by row.
typedef struct {
    double centre[2], half[2];
    int node[SHAPES];
} finite_element;

/// Shape functions at one point of an element.
typedef struct {
    double value[SHAPES], slope[SHAPES][2]; // by x and y
} finite_element_shapes;

struct finite_element_solution {
    finite_element_plate plate;
    finite_element_mesh mesh;
    double mu;            // = lambda, of M = 1
    double *modulus;      // [nodes] M
    double *displacement; // [nodes, 2]
    double potential_energy;
};

PDMC_NODISCARD pdmc_status finite_element_mesh_create(const finite_element_plate *plate, finite_element_mesh *mesh);
void finite_element_mesh_clear(finite_element_mesh *mesh);

/// The element in a column and a row of the grid.
finite_element finite_element_at(const finite_element_mesh *mesh, int column, int row);

/// The lattice point of a node, also of one on the upper face.
void finite_element_node(const finite_element_mesh *mesh, int node, double x[2]);

/// @param[in]  local  in [-1, 1]^2
finite_element_shapes finite_element_shapes_at(const finite_element *element, const double local[2]);

/// Gauss point k of 4 x 4.
/// @param[out] local   in [-1, 1]^2
/// @return its share of the element's area
double finite_element_gauss(const finite_element *element, int k, double local[2]);
