// SPDX-License-Identifier: GPL-3.0-or-later

/// What a scalar study is meshed with, and so what its domain is.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

static const pdmc_study_address at_mesh = {SECTION_ELEMENTS, -1, "mesh"}, at_file = {SECTION_ELEMENTS, -1, "file"};

static pdmc_status refuse_missing(const pdmc_study_reader *reader, const char *key)
{
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_DOMAIN, -1, key},
                             "is missing, must be a real > 0 where the mesh is not that of a file");
}

static pdmc_status check_box(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (!s->has_width) return refuse_missing(reader, "width");
    if (!s->has_height && s->dimension == 2) return refuse_missing(reader, "height");
    if (s->hole_count == 0 || s->mesh == PDMC_ELEMENTS_TRIANGLES) return PDMC_OK;
    return pdmc_study_refuse(reader, at_mesh, "\"cells\" is not allowed with holes, must be \"triangles\"");
}

static pdmc_status check_triangles(const pdmc_study_reader *reader)
{
    pdmc_scalar *s = reader->scalar;
    if (!s->has_hole_spacing) s->hole_spacing = s->spacing;
    s->has_hole_spacing = true;
    if (s->hole_spacing > s->spacing)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_ELEMENTS, -1, "hole_spacing"},
                                 "%g is not allowed, must be at most spacing = %g", s->hole_spacing, s->spacing);
    const pdmc_mesh_plate plate = pdmc_scalar_plate(s);
    if (pdmc_mesh_check_plate(&plate) == PDMC_OK) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_HOLES, -1, NULL}, "%s", pdmc_last_error());
}

// The domain is what is not in the layer.
static void measure(pdmc_scalar *s)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 3 * s->first.element_count; k++)
        for (int a = 0; a < 2 && !s->first.layer[k / 3]; a++) {
            low[a] = fmin(low[a], s->first.x[2 * s->first.corner[k] + a]);
            high[a] = fmax(high[a], s->first.x[2 * s->first.corner[k] + a]);
        }
    s->width = high[0] - low[0];
    s->height = high[1] - low[1];
}

static bool has_layer(const pdmc_mesh *mesh)
{
    return memchr(mesh->layer, 1, (size_t)mesh->element_count);
}

static pdmc_status check_layer(const pdmc_study_reader *reader)
{
    pdmc_scalar *s = reader->scalar;
    double width;
    if (!has_layer(&s->first)) {
        if (pdmc_mesh_mark_layer(&s->first, s->horizon) == PDMC_OK) return PDMC_OK;
        return pdmc_study_refuse(reader, at_file,
                                 "no element of the mesh is further from its edge than the horizon, %g", s->horizon);
    }
    const pdmc_status status = pdmc_mesh_layer_width(&s->first, &width);
    if (status != PDMC_OK) return status;
    if (isinf(width)) return pdmc_study_refuse(reader, at_file, "all elements of the mesh are in the layer");
    if (width >= s->horizon * (1.0 - 1e-9)) return PDMC_OK;
    return pdmc_study_refuse(reader, at_file, "the layer of the mesh is %g wide, must be at least kernel.horizon = %g",
                             width, s->horizon);
}

static pdmc_status read_file(const pdmc_study_reader *reader)
{
    pdmc_scalar *s = reader->scalar;
    if (s->has_width || s->has_height || s->hole_count > 0)
        return pdmc_study_refuse(reader, at_mesh,
                                 "\"file\" is not allowed with a width, a height or holes of the domain");
    char *path = pdmc_study_path(reader, at_file, s->file);
    if (!path) return PDMC_ERR_NOMEM;
    pdmc_status status = pdmc_mesh_read(path, 2, &s->first);
    pdmc_free(path);
    if (status == PDMC_OK) status = check_layer(reader);
    if (status == PDMC_OK) measure(s);
    return status;
}

pdmc_status pdmc_study_check_mesh(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->mesh != PDMC_ELEMENTS_CELLS && s->dimension == 1)
        return pdmc_study_refuse(reader, at_mesh, "triangles are for two dimensions only, must be \"cells\"");
    if (s->mesh == PDMC_ELEMENTS_FILE) return read_file(reader);
    const pdmc_status status = check_box(reader);
    return status == PDMC_OK && s->mesh == PDMC_ELEMENTS_TRIANGLES ? check_triangles(reader) : status;
}
