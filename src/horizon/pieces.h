// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The part of a cell inside the sphere as iterated integrals with limits in closed form, X outermost and Z innermost
/// (section 2.4.2). Z is the axis along which the cell lies farthest out, so that the sphere is a graph over X and Y.
/// In the plane there is no Y.

#include "pdmc/horizon.h"

/// A limit of Y: a plane, or the circle in which a plane Z = const meets the sphere.
typedef struct {
    double value; // of the plane; or the circle's radius squared
    int half;     // which half of the circle, 1 or -1; 0 for a plane
} pdmc_limit;

typedef struct {
    double x[2];
    pdmc_limit y[2];
    double bottom, top; // top: where the piece does not end at the sphere
    bool is_curved;     // it does
} pdmc_piece;

// Up to 12 places on X where circles and planes meet, three parts of Y between two of them.
enum { PDMC_MAX_PIECES = 13 * 3 };

typedef struct {
    int dimension;
    double radius;
    int axis[3];    // that X, Y and Z are along
    double turn[3]; // their directions, 1 or -1
    int count;
    pdmc_piece piece[PDMC_MAX_PIECES];
} pdmc_pieces;

/// A cell that the sphere cuts does not have Z = 0 inside.
void pdmc_pieces_of(int dimension, const pdmc_cell *cell, double radius, pdmc_pieces *pieces);

double pdmc_limit_at(const pdmc_limit *limit, double x);
double pdmc_piece_top(const pdmc_pieces *pieces, const pdmc_piece *piece, double x, double y);
