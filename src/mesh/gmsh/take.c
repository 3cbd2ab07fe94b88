// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh/session.h"

#include <gmshc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLE = 2, TETRAHEDRON = 4 }; // Gmsh's numbers

// The elements of an entity that are of one type.
typedef struct {
    int *types;
    size_t **tags, **nodes;
    size_t *tag_counts, *node_counts;
    size_t type_count, tag_lists, node_lists;
} elements;

static void elements_clear(elements *e)
{
    for (size_t i = 0; i < e->tag_lists; i++) gmshFree(e->tags[i]);
    for (size_t i = 0; i < e->node_lists; i++) gmshFree(e->nodes[i]);
    gmshFree(e->types);
    gmshFree(e->tags);
    gmshFree(e->nodes);
    gmshFree(e->tag_counts);
    gmshFree(e->node_counts);
    *e = (elements){0};
}

// Of all entities of the dimension where `entity` is -1.
static bool get_elements(int dimension, int entity, elements *e)
{
    GMSH_TRY(gmshModelMeshGetElements(&e->types, &e->type_count, &e->tags, &e->tag_counts, &e->tag_lists, &e->nodes,
                                      &e->node_counts, &e->node_lists, dimension, entity, &error));
    return true;
done:
    return false;
}

static bool refuse_type(int type, size_t count, pdmc_gmsh_mesh *mesh)
{
    char *name = NULL;
    double *corners = NULL;
    size_t corner_count = 0;
    int dimension = 0, order = 0, nodes = 0, primary_nodes = 0;
    GMSH_TRY(gmshModelMeshGetElementProperties(type, &name, &dimension, &order, &nodes, &corners, &corner_count,
                                               &primary_nodes, &error));
    snprintf(mesh->message, sizeof mesh->message, "has %zu elements of the kind \"%s\", must have %s only", count, name,
             mesh->dimension == 2 ? "\"Triangle 3\"" : "\"Tetrahedron 4\"");
done:
    gmshFree(name);
    gmshFree(corners);
    return false;
}

static bool check_types(const elements *e, pdmc_gmsh_mesh *mesh)
{
    const int wanted = mesh->dimension == 3 ? TETRAHEDRON : TRIANGLE;
    for (size_t i = 0; i < e->type_count; i++)
        if (e->types[i] != wanted) return refuse_type(e->types[i], e->tag_counts[i], mesh);
    return true;
}

// The highest dimension that has elements, and room for them.
static bool take_size(pdmc_gmsh_mesh *mesh)
{
    for (mesh->dimension = 3; mesh->dimension >= 2; mesh->dimension--) {
        elements e = {0};
        bool is_right = get_elements(mesh->dimension, -1, &e) && check_types(&e, mesh);
        mesh->element_count = is_right && e.type_count > 0 ? e.tag_counts[0] : 0;
        elements_clear(&e);
        if (!is_right || mesh->element_count > 0) return is_right;
    }
    snprintf(mesh->message, sizeof mesh->message, "has no triangle and no tetrahedron");
    return false;
}

static bool allocate(size_t count, size_t size, void **memory, pdmc_gmsh_mesh *mesh)
{
    *memory = calloc(count > 0 ? count : 1, size);
    if (!*memory) snprintf(mesh->message, sizeof mesh->message, "no memory for %zu of %zu bytes", count, size);
    return *memory;
}

// The nodes in the order of their tags, and the number of each tag.
static bool take_nodes(pdmc_gmsh_mesh *mesh, size_t **number)
{
    size_t *tags = NULL, tag_count = 0, x_count = 0, parameter_count = 0, largest = 0;
    double *x = NULL, *parameters = NULL;
    bool is_done = false;
    GMSH_TRY(
        gmshModelMeshGetNodes(&tags, &tag_count, &x, &x_count, &parameters, &parameter_count, -1, -1, 0, 0, &error));
    for (size_t i = 0; i < tag_count; i++) largest = tags[i] > largest ? tags[i] : largest;
    if (!allocate(largest + 1, sizeof **number, (void **)number, mesh)) goto done;
    if (!allocate(3 * tag_count, sizeof *mesh->x, (void **)&mesh->x, mesh)) goto done;
    for (size_t i = 0; i < tag_count; i++) (*number)[tags[i]] = i + 1;
    for (size_t tag = 0; tag <= largest; tag++) {
        if ((*number)[tag] == 0) continue;
        memcpy(&mesh->x[3 * mesh->node_count], &x[3 * ((*number)[tag] - 1)], 3 * sizeof *x);
        (*number)[tag] = mesh->node_count++;
    }
    is_done = true;
done:
    gmshFree(tags);
    gmshFree(x);
    gmshFree(parameters);
    return is_done;
}

static bool is_in_layer(int dimension, int entity, pdmc_gmsh_mesh *mesh)
{
    int *groups = NULL;
    size_t count = 0;
    bool is_in = false;
    GMSH_TRY(gmshModelGetPhysicalGroupsForEntity(dimension, entity, &groups, &count, &error));
    for (size_t i = 0; i < count; i++) {
        char *name = NULL;
        GMSH_TRY(gmshModelGetPhysicalName(dimension, groups[i], &name, &error));
        is_in = is_in || strcmp(name, "layer") == 0;
        gmshFree(name);
    }
done:
    gmshFree(groups);
    mesh->has_layer = mesh->has_layer || is_in;
    return is_in;
}

static bool take_entity(int entity, const size_t number[], size_t *element, pdmc_gmsh_mesh *mesh)
{
    const size_t corners = (size_t)mesh->dimension + 1;
    elements e = {0};
    if (!get_elements(mesh->dimension, entity, &e)) return false;
    const size_t count = e.type_count > 0 ? e.tag_counts[0] : 0;
    const bool in_layer = count > 0 && is_in_layer(mesh->dimension, entity, mesh);
    for (size_t i = 0; i < corners * count; i++) mesh->corner[corners * *element + i] = number[e.nodes[0][i]];
    for (size_t i = 0; i < count; i++) mesh->layer[(*element)++] = in_layer;
    elements_clear(&e);
    return true;
}

bool pdmc_gmsh_take(pdmc_gmsh_mesh *mesh)
{
    int *entities = NULL;
    size_t *number = NULL, count = 0, element = 0;
    bool is_done = take_size(mesh) && take_nodes(mesh, &number) &&
                   allocate(mesh->element_count * ((size_t)mesh->dimension + 1), sizeof *mesh->corner,
                            (void **)&mesh->corner, mesh) &&
                   allocate(mesh->element_count, sizeof *mesh->layer, (void **)&mesh->layer, mesh);
    if (!is_done) goto done;
    is_done = false;
    GMSH_TRY(gmshModelGetEntities(&entities, &count, mesh->dimension, &error)); // pairs of a dimension and a tag
    is_done = true;
    for (size_t i = 1; i < count && is_done; i += 2) is_done = take_entity(entities[i], number, &element, mesh);
done:
    gmshFree(entities);
    free(number);
    return is_done;
}
