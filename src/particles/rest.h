// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What bodies that are brought to rest, load by load, remember of the states before.

#include "pdmc/particles.h"

typedef struct {
    int count;          // states of rest so far
    double load[2];     // of the last one and the one before it
    double *at_rest[2]; // [unknowns] positions then; NULL before the first
    double *external;   // [unknowns] prescribed forces, and reactions where positions are prescribed, at the last one
    double *sphere_start, *sphere_centre,
        *sphere_force; // [spheres, 3] at load 0; at the last one, with the nodes' force
    double largest;    // norm of the external forces so far
    double dissipated; // where bonds broke: what a motion would have carried away
} pdmc_rest_memory;

void pdmc_rest_clear(pdmc_rest_memory *memory);
