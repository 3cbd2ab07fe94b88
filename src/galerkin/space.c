// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/galerkin.h"

#include "base/base_impl.h"

#include <string.h>

// Values before they are numbered: those of the nodes, then those of the corners of each element.
enum { UNUSED, FREE, PRESCRIBED };

static bool is_own(const pdmc_mesh *mesh, pdmc_space_kind kind, int element)
{
    return kind == PDMC_SPACE_DISCONTINUOUS || (kind == PDMC_SPACE_MIXED && mesh->rough[element]);
}

static void find_values(const pdmc_mesh *mesh, pdmc_space_kind kind, int value[], uint8_t state[])
{
    const int n = mesh->dimension + 1;
    for (int e = 0; e < mesh->element_count; e++)
        for (int k = n * e; k < n * (e + 1); k++) {
            value[k] = is_own(mesh, kind, e) ? mesh->node_count + k : mesh->corner[k];
            if (mesh->layer[e]) state[value[k]] = PRESCRIBED;
            else if (state[value[k]] == UNUSED) state[value[k]] = FREE;
        }
}

static int number_values(int count, const uint8_t state[], uint8_t which, int first, int number[])
{
    for (int i = 0; i < count; i++)
        if (state[i] == which) number[i] = first++;
    return first;
}

static void place_values(pdmc_space *space)
{
    const pdmc_mesh *mesh = space->mesh;
    const size_t d = (size_t)mesh->dimension;
    for (size_t k = 0; k < (size_t)mesh->element_count * (d + 1); k++)
        memcpy(&space->x[d * (size_t)space->value[k]], &mesh->x[d * (size_t)mesh->corner[k]], d * sizeof *space->x);
}

pdmc_status pdmc_space_create(const pdmc_mesh *mesh, pdmc_space_kind kind, pdmc_space *space)
{
    pdmc_status status = PDMC_OK;
    const int corners = mesh->element_count * (mesh->dimension + 1), candidates = mesh->node_count + corners;
    pdmc_space made = {.mesh = mesh};
    uint8_t *state = NULL;
    int *number = NULL;
    *space = (pdmc_space){0};
    PDMC_NEW(state, candidates);
    PDMC_NEW(number, candidates);
    PDMC_NEW(made.value, corners);
    find_values(mesh, kind, made.value, state);
    made.free_count = number_values(candidates, state, FREE, 0, number);
    made.count = number_values(candidates, state, PRESCRIBED, made.free_count, number);
    if (made.free_count == 0) PDMC_FAIL(PDMC_ERR_ARG, "no value of the field is free: the mesh is too coarse");
    for (int k = 0; k < corners; k++) made.value[k] = number[made.value[k]];
    PDMC_NEW(made.x, (size_t)made.count * (size_t)mesh->dimension);
    place_values(&made);
    *space = made;
    made = (pdmc_space){0};
done:
    pdmc_free(state);
    pdmc_free(number);
    pdmc_space_clear(&made);
    return status;
}

void pdmc_space_clear(pdmc_space *space)
{
    pdmc_free(space->value);
    pdmc_free(space->x);
    *space = (pdmc_space){0};
}
