// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh/session.h"

#include <gmshc.h>
#include <math.h>
#include <stdlib.h>

enum { MOST_LOOPS = PDMC_GMSH_MOST_HOLES + 1, MOST_MOUTHS = 2 * PDMC_GMSH_MOST_SLITS };

// What is drawn of the plate. After a failure nothing more is.
typedef struct {
    const pdmc_mesh_plate *plate;
    int failed;
    int body[MOST_LOOPS], body_count;   // loops round the body: its sides, then its holes
    int layer[MOST_LOOPS], layer_count; // surfaces
    int (*slit)[2];                     // [slits] points
} drawing;

static int draw_point(drawing *d, double x, double y)
{
    return d->failed ? 0 : gmshModelGeoAddPoint(x, y, 0.0, 0.0, -1, &d->failed);
}

static int draw_line(drawing *d, int from, int to)
{
    return d->failed ? 0 : gmshModelGeoAddLine(from, to, -1, &d->failed);
}

static int draw_loop(drawing *d, int curves[], int count)
{
    return d->failed ? 0 : gmshModelGeoAddCurveLoop(curves, (size_t)count, -1, 0, &d->failed);
}

// Within the first loop and outside the others.
static int draw_surface(drawing *d, int loops[], int count)
{
    return d->failed ? 0 : gmshModelGeoAddPlaneSurface(loops, (size_t)count, -1, &d->failed);
}

static int draw_circle(drawing *d, const double centre[2], double radius)
{
    static const double direction[4][2] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    const int middle = draw_point(d, centre[0], centre[1]);
    int point[4], arc[4];
    for (int k = 0; k < 4; k++)
        point[k] = draw_point(d, centre[0] + radius * direction[k][0], centre[1] + radius * direction[k][1]);
    for (int k = 0; k < 4 && !d->failed; k++)
        arc[k] = gmshModelGeoAddCircleArc(point[k], middle, point[(k + 1) % 4], -1, 0.0, 0.0, 0.0, &d->failed);
    return draw_loop(d, arc, 4);
}

// The middle of a chord lies inside the circle, so that the inner edge of the layer must be further in by as much.
static void draw_hole(drawing *d, const pdmc_hole *hole)
{
    const double chord = d->plate->fine_spacing, sagitta = chord * chord / (8.0 * hole->radius);
    const double inner = hole->radius - d->plate->layer - 2.0 * sagitta;
    int loops[2] = {draw_circle(d, hole->centre, hole->radius)};
    d->body[d->body_count++] = loops[0];
    if (d->plate->layer == 0.0) return;
    const bool is_ring = inner > 0.5 * chord;
    if (is_ring) loops[1] = draw_circle(d, hole->centre, inner);
    d->layer[d->layer_count++] = draw_surface(d, loops, is_ring ? 2 : 1);
}

static int by_place(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return (p[0] > q[0]) - (p[0] < q[0]);
}

// The points at which cracks run through a side: how far along it, and which end of which crack.
static int find_mouths(const pdmc_mesh_plate *plate, const double from[2], const double to[2],
                       double mouths[MOST_MOUTHS][3])
{
    int count = 0;
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    for (int s = 0; s < plate->slit_count; s++)
        for (int end = 0; end < 2; end++) {
            const double *at = end == 0 ? plate->slits[s].from : plate->slits[s].to;
            const double along[2] = {at[0] - from[0], at[1] - from[1]};
            const double across = along[0] * (to[1] - from[1]) - along[1] * (to[0] - from[0]);
            if (fabs(across) > 1e-9 * length * length) continue;
            mouths[count][0] = hypot(along[0], along[1]);
            mouths[count][1] = s;
            mouths[count++][2] = end;
        }
    qsort(mouths, (size_t)count, sizeof *mouths, by_place);
    return count;
}

static int draw_sides(drawing *d)
{
    const double x = 0.5 * d->plate->width, y = 0.5 * d->plate->height;
    const double corner[5][2] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}, {-x, -y}};
    double mouths[MOST_MOUTHS][3];
    int lines[2 * MOST_MOUTHS + 4], count = 0, point[5];
    for (int k = 0; k < 4; k++) point[k] = draw_point(d, corner[k][0], corner[k][1]);
    point[4] = point[0];
    for (int k = 0; k < 4; k++) {
        int from = point[k];
        const int cuts = find_mouths(d->plate, corner[k], corner[k + 1], mouths);
        for (int i = 0; i < cuts; i++) {
            const pdmc_slit *slit = &d->plate->slits[(int)mouths[i][1]];
            const double *at = mouths[i][2] == 0.0 ? slit->from : slit->to;
            const int mouth = draw_point(d, at[0], at[1]);
            d->slit[(int)mouths[i][1]][(int)mouths[i][2]] = mouth;
            lines[count++] = draw_line(d, from, mouth);
            from = mouth;
        }
        lines[count++] = draw_line(d, from, point[k + 1]);
    }
    return draw_loop(d, lines, count);
}

static void draw_frame(drawing *d, int sides)
{
    const double x = 0.5 * d->plate->width + d->plate->layer, y = 0.5 * d->plate->height + d->plate->layer;
    const double corner[4][2] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    int point[4], line[4];
    for (int k = 0; k < 4; k++) point[k] = draw_point(d, corner[k][0], corner[k][1]);
    for (int k = 0; k < 4; k++) line[k] = draw_line(d, point[k], point[(k + 1) % 4]);
    d->layer[d->layer_count++] = draw_surface(d, (int[2]){draw_loop(d, line, 4), sides}, 2);
}

static int draw_slit(drawing *d, int s)
{
    const double *ends[2] = {d->plate->slits[s].from, d->plate->slits[s].to};
    for (int end = 0; end < 2; end++)
        if (d->slit[s][end] == 0) d->slit[s][end] = draw_point(d, ends[end][0], ends[end][1]);
    return draw_line(d, d->slit[s][0], d->slit[s][1]);
}

static void draw_slits(drawing *d, int lines[])
{
    for (int s = 0; s < d->plate->slit_count; s++) lines[s] = draw_slit(d, s);
}

static void name_layer(drawing *d)
{
    if (d->layer_count == 0 || d->failed) return;
    const int group = gmshModelAddPhysicalGroup(2, d->layer, (size_t)d->layer_count, -1, &d->failed);
    if (!d->failed) gmshModelSetPhysicalName(2, group, "layer", &d->failed);
}

static double distance_to_slit(const pdmc_slit *slit, double x, double y)
{
    const double d[2] = {slit->to[0] - slit->from[0], slit->to[1] - slit->from[1]};
    const double along = ((x - slit->from[0]) * d[0] + (y - slit->from[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
    const double t = fmin(fmax(along, 0.0), 1.0);
    return hypot(x - slit->from[0] - t * d[0], y - slit->from[1] - t * d[1]);
}

// The length of edges at a point.
static double size_at(int dimension, int entity, double x, double y, double z, void *context)
{
    (void)dimension, (void)entity, (void)z;
    const pdmc_mesh_plate *plate = context;
    double distance = INFINITY;
    for (int i = 0; i < plate->hole_count; i++) {
        const pdmc_hole *hole = &plate->holes[i];
        distance = fmin(distance, fabs(hypot(x - hole->centre[0], y - hole->centre[1]) - hole->radius));
    }
    for (int i = 0; i < plate->slit_count; i++) distance = fmin(distance, distance_to_slit(&plate->slits[i], x, y));
    return fmin(plate->spacing, plate->fine_spacing + 0.25 * fmax(0.0, distance - plate->near));
}

static bool draw(const pdmc_mesh_plate *plate, drawing *d, int lines[])
{
    const int sides = draw_sides(d);
    d->body[d->body_count++] = sides;
    if (plate->layer > 0.0) draw_frame(d, sides);
    for (int i = 0; i < plate->hole_count; i++) draw_hole(d, &plate->holes[i]);
    draw_slits(d, lines);
    const int body = draw_surface(d, d->body, d->body_count);
    if (!d->failed) gmshModelGeoSynchronize(&d->failed);
    if (!d->failed && plate->slit_count > 0)
        gmshModelMeshEmbed(1, lines, (size_t)plate->slit_count, 2, body, &d->failed);
    name_layer(d);
    return !d->failed;
}

static bool generate(const pdmc_mesh_plate *plate)
{
    GMSH_TRY(gmshModelMeshSetSizeCallback(size_at, (void *)plate, &error));
    GMSH_TRY(gmshModelMeshGenerate(2, &error));
    return true;
done:
    return false;
}

bool pdmc_gmsh_plate(const pdmc_mesh_plate *plate, pdmc_gmsh_mesh *mesh)
{
    int threads;
    drawing *d = calloc(1, sizeof *d);
    int *lines = calloc((size_t)plate->slit_count + 1, sizeof *lines);
    if (d) d->slit = calloc((size_t)plate->slit_count + 1, sizeof *d->slit);
    if (d) d->plate = plate;
    bool is_done = pdmc_gmsh_begin(mesh, &threads) && d && d->slit && lines && draw(plate, d, lines) &&
                   generate(plate) && pdmc_gmsh_take(mesh);
    is_done = pdmc_gmsh_end(is_done, threads, mesh);
    if (d) free(d->slit);
    free(d);
    free(lines);
    return is_done;
}
