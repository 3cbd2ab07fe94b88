// SPDX-License-Identifier: GPL-3.0-or-later

/// What an explicit study consists of: materials, bodies, cracks, what acts on layers, spheres.

#include "study/study_impl.h"

#include "base/base_impl.h"
#include "problem/nodes_file.h"

#include <math.h>
#include <string.h>

static pdmc_study_address at(pdmc_study_section_id section, int index, const char *key)
{
    return (pdmc_study_address){section, index, key};
}

pdmc_status pdmc_study_check_names(const pdmc_study_reader *reader, pdmc_study_section_id id, const char *what)
{
    const pdmc_study_section *section = &pdmc_study_sections[id];
    const char *home = pdmc_study_home(section, reader->study), *items;
    const size_t place = pdmc_study_find_setting(id, "name")->offset;
    int count;
    memcpy(&items, home + section->items, sizeof items);
    memcpy(&count, home + section->count, sizeof count);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++) {
            const char *name = items + (size_t)i * section->size + place;
            const char *earlier = items + (size_t)j * section->size + place;
            if (strcmp(name, earlier) == 0)
                return pdmc_study_refuse(reader, at(id, i, "name"),
                                         "\"%s\" is the name of an earlier %s too, must be another", name, what);
        }
    return PDMC_OK;
}

static pdmc_status check_material(const pdmc_study_reader *reader, int index)
{
    const pdmc_explicit_material *m = &reader->motion->materials[index];
    const int moduli = m->has_youngs_modulus + m->has_bulk_modulus + m->has_micromodulus;
    const pdmc_study_address address = at(SECTION_PARTICLE_MATERIALS, index, NULL);
    if (moduli != 1)
        return pdmc_study_refuse(reader, address,
                                 "\"%s\" has %d moduli, must have one of youngs_modulus, bulk_modulus, micromodulus",
                                 m->name, moduli);
    const bool has_fibres = m->fibre[0] != 0.0 || m->fibre[1] != 0.0 || m->fibre[2] != 0.0;
    if (m->fibre_ratio != 1.0 && !has_fibres)
        return pdmc_study_refuse(reader, at(SECTION_PARTICLE_MATERIALS, index, "fibre_ratio"),
                                 "is given without a direction, must have `fibre` beside it");
    if (m->has_fracture_energy && m->has_critical_stretch)
        return pdmc_study_refuse(reader, address,
                                 "\"%s\" has a fracture_energy and a critical_stretch, must have one or none", m->name);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_particle_materials(const pdmc_study_reader *reader)
{
    pdmc_status status = pdmc_study_check_names(reader, SECTION_PARTICLE_MATERIALS, "material");
    if (reader->motion->material_count == 0)
        return pdmc_study_refuse(reader, at(SECTION_PARTICLE_MATERIALS, -1, NULL), "no material, must be one at least");
    for (int i = 0; i < reader->motion->material_count && status == PDMC_OK; i++) status = check_material(reader, i);
    return status;
}

static pdmc_status check_box(const pdmc_study_reader *reader, pdmc_study_address address, const pdmc_shape *shape)
{
    for (int k = 0; k < reader->motion->dimension; k++)
        if (!(shape->from[k] <= shape->to[k]))
            return pdmc_study_refuse(reader, address, "%g in %c is below from, %g, must be at least that", shape->to[k],
                                     "xyz"[k], shape -> from[k]);
    return PDMC_OK;
}

static pdmc_status check_cylinder(const pdmc_study_reader *reader, pdmc_study_address address, const pdmc_shape *shape)
{
    int along = 0;
    for (int k = 0; k < reader->motion->dimension; k++) along += shape->from[k] != shape->to[k];
    if (along == 1) return PDMC_OK;
    return pdmc_study_refuse(reader, address, "differs from `from` in %d coordinates, must differ in one", along);
}

static pdmc_status check_shape(const pdmc_study_reader *reader, pdmc_study_section_id section, int index,
                               const pdmc_shape *shape)
{
    const pdmc_study_address to = at(section, index, "to");
    if (shape->kind == PDMC_SHAPE_BOX) return check_box(reader, to, shape);
    if (shape->kind == PDMC_SHAPE_BALL) return PDMC_OK;
    if (reader->motion->dimension == 2)
        return pdmc_study_refuse(reader, at(section, index, "shape"),
                                 "\"cylinder\" is not allowed in two dimensions, must be \"box\" or \"ball\"");
    return check_cylinder(reader, to, shape);
}

static pdmc_status read_nodes(const pdmc_study_reader *reader, int index)
{
    pdmc_explicit *motion = reader->motion;
    pdmc_explicit_body *body = &motion->bodies[index];
    const double depth = motion->dimension == 2 ? motion->thickness : 1.0;
    int *const count = &body->body.node_count;
    pdmc_node *nodes = NULL;
    char *path = pdmc_study_path(reader, at(SECTION_BODIES, index, "file"), body->file);
    if (!path) return PDMC_ERR_NOMEM;
    const pdmc_status status =
        body->body.shape.kind == PDMC_SHAPE_NODES
            ? pdmc_nodes_read(path, motion->dimension, count, &nodes)
            : pdmc_nodes_of_mesh(path, motion->dimension, body->volumes, depth, motion->mesh_generator, count, &nodes);
    body->body.nodes = nodes;
    pdmc_free(path);
    return status;
}

static pdmc_status check_size(const pdmc_study_reader *reader)
{
    const double node_limit = 2e8;
    const pdmc_explicit *motion = reader->motion;
    double nodes = 0.0;
    for (int i = 0; i < motion->body_count; i++) nodes += pdmc_explicit_nodes(motion, &motion->bodies[i].body);
    if (nodes <= node_limit) return PDMC_OK;
    return pdmc_study_refuse(reader, at(SECTION_PARTICLE_GRID, -1, "spacing"),
                             "%g gives the bodies %.3g nodes, must be at most %.3g", motion->spacing, nodes,
                             node_limit);
}

static double length(const double x[PDMC_AXES])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

// A part has its host's nodes, and begins with its velocity.
static pdmc_status check_part(const pdmc_study_reader *reader, int index)
{
    const pdmc_body *body = &reader->motion->bodies[index].body;
    const pdmc_body *host = &reader->motion->bodies[body->host].body;
    if (body->host == index || host->is_part)
        return pdmc_study_refuse(reader, at(SECTION_BODIES, index, "inside"),
                                 "\"%s\" is not allowed, must be an earlier body that is not inside another", host->name);
    if (pdmc_shape_has_nodes(body->shape.kind))
        return pdmc_study_refuse(reader, at(SECTION_BODIES, index, "shape"),
                                 "\"%s\" is not allowed inside another body, whose nodes it has",
                                 body->shape.kind == PDMC_SHAPE_NODES ? "nodes" : "mesh");
    if (length(body->velocity) > 0.0)
        return pdmc_study_refuse(reader, at(SECTION_BODIES, index, "velocity"),
                                 "is given inside another body, must be left to that");
    return PDMC_OK;
}

pdmc_status pdmc_study_check_bodies(const pdmc_study_reader *reader)
{
    const pdmc_explicit *motion = reader->motion;
    pdmc_status status = pdmc_study_check_names(reader, SECTION_BODIES, "body");
    if (motion->body_count == 0)
        return pdmc_study_refuse(reader, at(SECTION_BODIES, -1, NULL), "no body, must be one at least");
    for (int i = 0; i < motion->body_count && status == PDMC_OK; i++)
        status = motion->bodies[i].file ? read_nodes(reader, i)
                                        : check_shape(reader, SECTION_BODIES, i, &motion->bodies[i].body.shape);
    for (int i = 0; i < motion->body_count && status == PDMC_OK; i++)
        if (motion->bodies[i].body.is_part) status = check_part(reader, i);
    return status == PDMC_OK ? check_size(reader) : status;
}

// Sides along one line make no rectangle.
static bool spans(const double a[PDMC_AXES], const double b[PDMC_AXES])
{
    const double cross[PDMC_AXES] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return length(cross) > 1e-9 * length(a) * length(b);
}

static pdmc_status check_crack(const pdmc_study_reader *reader, int index)
{
    const pdmc_planar_crack *crack = &reader->motion->cracks[index];
    if (crack->kind == PDMC_CRACK_SEGMENT) {
        if (crack->from[0] != crack->to[0] || crack->from[1] != crack->to[1]) return PDMC_OK;
        return pdmc_study_refuse(reader, at(SECTION_PLANAR_CRACKS, index, "to"), "is where from is, must be elsewhere");
    }
    if (reader->motion->dimension == 2)
        return pdmc_study_refuse(reader, at(SECTION_PLANAR_CRACKS, index, "shape"),
                                 "must be \"segment\" in two dimensions");
    if (crack->kind == PDMC_CRACK_DISC && !(length(crack->normal) > 0.0))
        return pdmc_study_refuse(reader, at(SECTION_PLANAR_CRACKS, index, "normal"), "is zero, must have a direction");
    if (crack->kind == PDMC_CRACK_RECTANGLE && !spans(crack->side[0], crack->side[1]))
        return pdmc_study_refuse(reader, at(SECTION_PLANAR_CRACKS, index, "second_side"),
                                 "makes no rectangle with first_side, must have another direction");
    return PDMC_OK;
}

pdmc_status pdmc_study_check_planar_cracks(const pdmc_study_reader *reader)
{
    pdmc_status status = pdmc_study_check_names(reader, SECTION_PLANAR_CRACKS, "crack");
    for (int i = 0; i < reader->motion->crack_count && status == PDMC_OK; i++) status = check_crack(reader, i);
    return status;
}

static pdmc_status check_factors(const pdmc_study_reader *reader, int index)
{
    const pdmc_explicit_condition *condition = &reader->motion->conditions[index];
    const pdmc_history *history = &condition->layer.history;
    if (history->count != condition->factor_count)
        return pdmc_study_refuse(reader, at(SECTION_CONDITIONS, index, "factors"),
                                 "%d factors are given at %d times, must be as many", condition->factor_count,
                                 history->count);
    for (int i = 1; i < history->count; i++)
        if (history->time[i] < history->time[i - 1])
            return pdmc_study_refuse(reader, at(SECTION_CONDITIONS, index, "times"), "%g stands behind %g, must ascend",
                                     history->time[i], history->time[i - 1]);
    return PDMC_OK;
}

// What grows along an axis is of a component that is prescribed.
static pdmc_status check_gradients(const pdmc_study_reader *reader, int index)
{
    static const char *const keys[PDMC_AXES] = {"x_gradient", "y_gradient", "z_gradient"};
    const pdmc_layer_condition *layer = &reader->motion->conditions[index].layer;
    for (int a = 0; a < PDMC_AXES; a++)
        if (!layer->along[a] && length(layer->gradient[a]) > 0.0)
            return pdmc_study_refuse(reader, at(SECTION_CONDITIONS, index, keys[a]),
                                     "is given without %c, must have it, 0 for instance", "xyz"[a]);
    return PDMC_OK;
}

static pdmc_status check_condition(const pdmc_study_reader *reader, int index)
{
    const pdmc_layer_condition *layer = &reader->motion->conditions[index].layer;
    if (!layer->along[0] && !layer->along[1] && !layer->along[2])
        return pdmc_study_refuse(reader, at(SECTION_CONDITIONS, index, NULL),
                                 "prescribes nothing, must have x or y or z");
    if (layer->along[2] && reader->motion->dimension == 2)
        return pdmc_study_refuse(reader, at(SECTION_CONDITIONS, index, "z"),
                                 "is not allowed in two dimensions, must be x or y");
    pdmc_status status = check_gradients(reader, index);
    if (status == PDMC_OK) status = check_shape(reader, SECTION_CONDITIONS, index, &layer->region);
    return status == PDMC_OK ? check_factors(reader, index) : status;
}

pdmc_status pdmc_study_check_conditions(const pdmc_study_reader *reader)
{
    pdmc_status status = pdmc_study_check_names(reader, SECTION_CONDITIONS, "condition");
    for (int i = 0; i < reader->motion->condition_count && status == PDMC_OK; i++) status = check_condition(reader, i);
    return status;
}

pdmc_status pdmc_study_check_spheres(const pdmc_study_reader *reader)
{
    return pdmc_study_check_names(reader, SECTION_SPHERES, "sphere");
}

pdmc_status pdmc_study_check_no_fail(const pdmc_study_reader *reader)
{
    const pdmc_explicit *motion = reader->motion;
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < motion->no_fail_count && status == PDMC_OK; i++)
        status = check_shape(reader, SECTION_NO_FAIL, i, &motion->no_fail[i]);
    return status;
}
