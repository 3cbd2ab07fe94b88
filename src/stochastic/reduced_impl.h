// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"
#include "stochastic/reduced.h"

enum {
    PDMC_PROBES = PDMC_BLOCK,
    PDMC_TRAINING = 4 * PDMC_BLOCK, // samples of a round
    PDMC_REDUCED_CAPACITY = 6 * PDMC_BLOCK,
    PDMC_REDUCED_TRIANGLE = PDMC_REDUCED_CAPACITY * (PDMC_REDUCED_CAPACITY + 1) / 2,
};

/// What a reduced model solves with; r is its dimension, the capacity that of what grows. The right-hand sides are the load
/// and, where the stress intensities have bounds of their own, their rows. Term 0 is the mean.
typedef struct {
    const pdmc_affine *full;
    int dimension, terms, sides;
    int added;            // cases of the loads beyond the given ones, whose rows stand behind those of the sides
    bool is_ordered;      // whether the first vectors are those that samples need most
    double goal;          // of the error, where there are no intensities
    double *intensity;    // [tips] goal, or NULL
    double *matrix;       // [1 + terms, triangle] v_i' K_m v_j, i <= j, by columns; the identity for m = 0
    double *load;         // [sides + added, capacity] V' F
    double *probe_matrix; // [1 + terms, capacity, PDMC_PROBES] z_k' K_m v_j
    double *probe_load;   // [sides + added, PDMC_PROBES] z_k' F
    double quantile;      // of chi-square with PDMC_PROBES degrees of freedom, at the probability of a failing bound
} pdmc_reduced_system;

/// Where the part of column j begins in a triangle that is packed by columns.
static inline size_t pdmc_triangle_column(size_t j)
{
    return j * (j + 1) / 2;
}

PDMC_NODISCARD pdmc_status pdmc_reduced_system_create(const pdmc_affine *full, const pdmc_reduced_goal *goal,
                                                      pdmc_reduced_system **system);
void pdmc_reduced_system_destroy(void *system);

/// The share of the goal that the bounds of a sample have.
/// @param[in] error  [sides]
double pdmc_reduced_share(const pdmc_reduced_system *system, const double error[]);

/// Solves a block for all right-hand sides. In an ordered basis a sample takes three eighths of the vectors, and more, an
/// eighth at a time, until its bounds meet the goal or it has them all: the other coordinates are 0.
/// @param[in]  xi     [PDMC_BLOCK, terms]
/// @param[in]  share  [PDMC_BLOCK, added] of the added cases in the load; NULL: none
/// @param[out] y      [PDMC_BLOCK, sides, dimension]
/// @param[out] error  [PDMC_BLOCK, sides] bounds of sqrt(e' K(xi) e); infinite where K(xi) is not known to be positive
/// @param[out] alpha  [PDMC_BLOCK] of K(xi) >= alpha K_0
/// @return PDMC_OK, PDMC_ERR_NOMEM, or the failure of the model's verb
PDMC_NODISCARD pdmc_status pdmc_reduced_system_solve(const pdmc_reduced_system *system, const double xi[],
                                                     const double share[], double y[], double error[],
                                                     double alpha[PDMC_BLOCK]);

/// What a basis is made with. Vectors are [count, unknowns]; B = PDMC_BLOCK.
typedef struct {
    const pdmc_variables *variables;
    const pdmc_affine *full;
    int threads, n;
    pdmc_reduced_system *system;
    double *probe, *basis;   // [PDMC_PROBES] and, right behind, [PDMC_REDUCED_CAPACITY] V
    double *direction;       // [dimension, dimension] Q, by rows, that order the basis as Q V
    double *load;            // [sides + added] F
    double *block, *product; // [B] new vectors and K_0 times them
    double *overlap;         // [B, PDMC_REDUCED_CAPACITY]
    double *training;        // [PDMC_TRAINING, terms] xi of the training samples
    double *training_share;  // [PDMC_TRAINING, added] of the added cases in their loads
    double *xi;              // [B, terms] of the block's columns
    double *none;            // [B, terms] zero
    double *allowed;         // [sides] error of each right-hand side, of which directions are scaled
} pdmc_reduced_builder;

PDMC_NODISCARD pdmc_status pdmc_reduced_builder_create(const pdmc_reduced_goal *goal, pdmc_reduced_builder *b);
void pdmc_reduced_builder_clear(pdmc_reduced_builder *b);

/// Turns the system to the principal directions of the training samples' answers, the largest first, in shares of the
/// errors that are allowed (proper orthogonal decomposition; Quarteroni, Manzoni & Negri, Reduced Basis Methods, 2016,
/// section 6.3): the space stays the same, and most samples need its first part alone. The long vectors of the basis stay
/// as they are.
/// @param[in] y  [PDMC_TRAINING, sides, dimension] answers
PDMC_NODISCARD pdmc_status pdmc_reduced_order(pdmc_reduced_builder *b, const double y[]);

/// What rows give of the vectors of the basis becomes what they give of the directions.
/// @param x  [rows, dimension]
PDMC_NODISCARD pdmc_status pdmc_reduced_turn(const pdmc_reduced_builder *b, int rows, double x[]);

/// Makes the basis and the system, until the bounds of the training samples' errors meet the goal.
PDMC_NODISCARD pdmc_status pdmc_reduced_build(const pdmc_reduced_goal *goal, pdmc_reduced_builder *b);
