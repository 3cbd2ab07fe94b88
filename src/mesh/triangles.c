// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/gmsh.h"
#include "mesh/mesh_impl.h"
#include "pdmc/geometry.h"

#include <math.h>
#include <string.h>

static pdmc_status check_lengths(const pdmc_mesh_plate *p)
{
    const double lengths[] = {p->width, p->height, p->spacing, p->fine_spacing};
    for (int i = 0; i < 4; i++)
        PDMC_REQUIRE(lengths[i] > 0.0 && isfinite(lengths[i]), "a length of %g is not > 0", lengths[i]);
    PDMC_REQUIRE(p->layer >= 0.0 && p->near >= 0.0, "a distance of %g is not >= 0", fmin(p->layer, p->near));
    PDMC_REQUIRE(p->hole_count <= PDMC_GMSH_MOST_HOLES, "%d holes are more than %d", p->hole_count,
                 PDMC_GMSH_MOST_HOLES);
    PDMC_REQUIRE(p->slit_count <= PDMC_GMSH_MOST_SLITS, "%d cracks are more than %d", p->slit_count,
                 PDMC_GMSH_MOST_SLITS);
    PDMC_REQUIRE(p->layer == 0.0 || p->slit_count == 0,
                 "%d cracks in a plate with a layer of %g: it may have one or the other", p->slit_count, p->layer);
    return PDMC_OK;
}

static pdmc_status check_hole(const pdmc_mesh_plate *p, int i)
{
    const pdmc_hole *h = &p->holes[i];
    const double x = fabs(h->centre[0]) + h->radius, y = fabs(h->centre[1]) + h->radius;
    PDMC_REQUIRE(h->radius > 0.0, "the radius of a hole, %g, is not > 0", h->radius);
    PDMC_REQUIRE(x < 0.5 * p->width && y < 0.5 * p->height, "the hole round (%g, %g) is not inside the plate",
                 h->centre[0], h->centre[1]);
    for (int j = 0; j < i; j++)
        PDMC_REQUIRE(pdmc_mesh_distance(2, h->centre, p->holes[j].centre) > h->radius + p->holes[j].radius,
                     "the holes round (%g, %g) and (%g, %g) are not apart", p->holes[j].centre[0],
                     p->holes[j].centre[1], h->centre[0], h->centre[1]);
    return PDMC_OK;
}

static bool is_in_plate(const pdmc_mesh_plate *p, const double x[2])
{
    return fabs(x[0]) <= 0.5 * p->width && fabs(x[1]) <= 0.5 * p->height;
}

static pdmc_status check_slit(const pdmc_mesh_plate *p, int i)
{
    const pdmc_slit *s = &p->slits[i];
    PDMC_REQUIRE(pdmc_mesh_distance(2, s->from, s->to) > 0.0, "a crack has no length");
    PDMC_REQUIRE(is_in_plate(p, s->from) && is_in_plate(p, s->to),
                 "the crack from (%g, %g) to (%g, %g) is not inside the plate", s->from[0], s->from[1], s->to[0],
                 s->to[1]);
    for (int j = 0; j < i; j++)
        PDMC_REQUIRE(!pdmc_segments_cross(s->from, s->to, p->slits[j].from, p->slits[j].to),
                     "the cracks from (%g, %g) and (%g, %g) meet", p->slits[j].from[0], p->slits[j].from[1], s->from[0],
                     s->from[1]);
    for (int j = 0; j < p->hole_count; j++)
        PDMC_REQUIRE(pdmc_point_segment_distance(p->holes[j].centre, s->from, s->to) > p->holes[j].radius,
                     "the crack from (%g, %g) meets the hole round (%g, %g)", s->from[0], s->from[1],
                     p->holes[j].centre[0], p->holes[j].centre[1]);
    return PDMC_OK;
}

pdmc_status pdmc_mesh_check_plate(const pdmc_mesh_plate *plate)
{
    pdmc_status status = check_lengths(plate);
    for (int i = 0; i < plate->hole_count && status == PDMC_OK; i++) status = check_hole(plate, i);
    for (int i = 0; i < plate->slit_count && status == PDMC_OK; i++) status = check_slit(plate, i);
    return status;
}

// A mesh is opened at its edge by what ends beyond it.
static void move_out(const pdmc_mesh_plate *p, const double from[2], double end[2])
{
    const bool is_at_edge =
        0.5 * p->width - fabs(end[0]) <= 1e-9 * p->width || 0.5 * p->height - fabs(end[1]) <= 1e-9 * p->height;
    for (int a = 0; a < 2 && is_at_edge; a++) end[a] += end[a] - from[a];
}

static pdmc_status open_slit(const pdmc_mesh_plate *plate, const pdmc_slit *slit, pdmc_mesh *mesh)
{
    pdmc_slit s = *slit;
    move_out(plate, slit->to, s.from);
    move_out(plate, slit->from, s.to);
    return pdmc_mesh_cut(mesh, s.from, s.to);
}

pdmc_status pdmc_mesh_triangles(const pdmc_mesh_plate *plate, pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    pdmc_gmsh gmsh;
    pdmc_gmsh_mesh drawn = {0};
    pdmc_mesh made = {0};
    *mesh = made;
    if ((status = pdmc_mesh_check_plate(plate)) != PDMC_OK || (status = pdmc_gmsh_load(&gmsh)) != PDMC_OK)
        return status;
    bool is_drawn;
#pragma omp critical(pdmc_gmsh) // which is one for the whole process
    is_drawn = gmsh.plate(plate, &drawn);
    if (!is_drawn) PDMC_FAIL(PDMC_ERR_EXTERN, "Gmsh: %s", drawn.message);
    PDMC_TRY(pdmc_gmsh_convert(&drawn, "the plate", &made));
    for (int i = 0; i < plate->slit_count; i++) PDMC_TRY(open_slit(plate, &plate->slits[i], &made));
    *mesh = made;
    made = (pdmc_mesh){0};
done:
    gmsh.clear(&drawn);
    pdmc_mesh_clear(&made);
    return status;
}

pdmc_status pdmc_mesh_generator(char generator[PDMC_GENERATOR_SIZE])
{
    pdmc_gmsh gmsh;
    pdmc_gmsh_mesh none = {0};
    bool is_known;
    const pdmc_status status = pdmc_gmsh_load(&gmsh);
    if (status != PDMC_OK) return status;
#pragma omp critical(pdmc_gmsh)
    is_known = gmsh.version(&none);
    if (!is_known) return pdmc_raise(PDMC_ERR_EXTERN, "Gmsh: %s", none.message);
    memcpy(generator, none.version, sizeof none.version);
    return PDMC_OK;
}
