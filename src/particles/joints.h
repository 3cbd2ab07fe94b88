// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bonds between bodies: which bodies have them, and what they are.

#include "particles/laws.h"

/// Tables of pairs of bodies, [bodies, bodies + 1]: the first of each row is that of empty cells, whose body is -1. All NULL
/// where no two bodies have bonds.
typedef struct {
    int bodies;
    uint8_t *bonded;      // whether their nodes have bonds
    int *interface;       // of the options, by which they have them; -1: none
    double *micromodulus; // c
    double *fibre_excess; // as in the laws: of bonds inside a body
    double *strength;     // s_0; infinite: that of the weaker node
    double *by_nodes;     // 0 where s_0 is that of the weaker node; else infinite, what is added to that
} pdmc_joints;

/// The body of which a body is a part: its host, or itself.
int pdmc_whole_body(const pdmc_particles_options *options, int body);

/// Which of a body and its parts has its node at x.
int16_t pdmc_part_at(const pdmc_particles_options *options, int body, const double x[PDMC_AXES]);

/// @param[in]  laws    [materials]
/// @param[out] joints  clear with pdmc_joints_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_ARG where an interface names what is not there; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_joints_create(const pdmc_particles_options *options, const pdmc_brittle_law laws[],
                                              pdmc_joints *joints);
void pdmc_joints_clear(pdmc_joints *joints);

/// The row of a body in any of the tables: row[1 + other body].
static inline size_t pdmc_joints_row(const pdmc_joints *joints, int body)
{
    return (size_t)body * ((size_t)joints->bodies + 1);
}

static inline bool pdmc_joints_bond(const pdmc_joints *joints, int body, int other)
{
    return joints->bonded ? joints->bonded[pdmc_joints_row(joints, body) + (size_t)(other + 1)] : body == other;
}
