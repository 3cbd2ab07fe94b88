// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Short-range repulsion between nodes that are not neighbours in the reference configuration (those are in forces.h).

#include "particles/bins.h"
#include "particles/nodes.h"

/// All pairs that can touch before a node has moved by half of `skin`.
typedef struct {
    double distance;                             // below which nodes repel each other, length; 0: never
    double skin;                                 // length
    double repulsion;                            // force / length^7
    double *built[PDMC_AXES];                    // [cells] positions for which the pairs were found
    double *found[PDMC_AXES], *moved[PDMC_AXES]; // [nodes] the same, and displacements
    pdmc_bins bins;
    double *range; // [bins, 2, 3] least and largest displacements in a bin
    int listed;    // nodes with partners
    int *node;     // [nodes] these nodes
    int *partners; // [nodes] of every node
    size_t *start; // [nodes + 1] of the listed nodes' partners
    size_t room;
    int *partner; // [room] nodes
    double way;   // by more than which no node has moved since the pairs were found
} pdmc_contact;

/// @param[out] contact  clear with pdmc_contact_clear(), whatever is returned
PDMC_NODISCARD pdmc_status pdmc_contact_create(const pdmc_particles_options *options, const pdmc_nodes *nodes,
                                               double repulsion, pdmc_contact *contact);
void pdmc_contact_clear(pdmc_contact *contact);

/// Tells that no node has moved by more than a distance since this or the last update was told of; INFINITY: it is not known.
void pdmc_contact_pass(pdmc_contact *contact, double distance);

/// Finds the pairs anew where a node has moved too far.
/// @param[in] position  [cells] of every axis
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_contact_update(pdmc_contact *contact, const pdmc_nodes *nodes,
                                               double *const position[PDMC_AXES], int threads);

/// Adds the repulsion to the forces. @param[out] force  [cells] of every axis
void pdmc_contact_add(const pdmc_contact *contact, const pdmc_nodes *nodes, double *const position[PDMC_AXES],
                      int threads, double *const force[PDMC_AXES]);

/// The energy of the repulsion.
double pdmc_contact_energy(const pdmc_contact *contact, const pdmc_nodes *nodes, double *const position[PDMC_AXES]);
