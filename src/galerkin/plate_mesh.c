// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate_mesh.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <math.h>
#include <stdlib.h>

// Lines of the mesh across one axis.
typedef struct {
    int count;
    double *x; // [count]
} lines;

bool pdmc_plate_holds(const pdmc_problem *problem, pdmc_side side)
{
    bool any = false;
    for (int s = 0; s < problem->support_count; s++) {
        const pdmc_support *support = &problem->supports[s];
        any = any || (support->side == side && (support->held[0] || support->held[1]));
    }
    return any;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Where lines must be: the sides, the edges of what is beyond them, and the ends of cracks.
static pdmc_status find_marks(const pdmc_problem *problem, int axis, lines *marks)
{
    pdmc_status status = PDMC_OK;
    const double size = axis == 0 ? problem->plate.width : problem->plate.height, tiny = 1e-9 * size;
    const pdmc_side low = axis == 0 ? PDMC_SIDE_LEFT : PDMC_SIDE_BOTTOM,
                    high = axis == 0 ? PDMC_SIDE_RIGHT : PDMC_SIDE_TOP;
    int count = 0;
    PDMC_NEW(marks->x, 4 + 2 * problem->crack_count);
    marks->x[count++] = -0.5 * size;
    marks->x[count++] = 0.5 * size;
    if (pdmc_plate_holds(problem, low)) marks->x[count++] = -0.5 * size - problem->solver.horizon;
    if (pdmc_plate_holds(problem, high)) marks->x[count++] = 0.5 * size + problem->solver.horizon;
    for (int tip = 0; tip < 2 * problem->crack_count; tip++) {
        const double x = pdmc_crack_end(problem->cracks, tip)[axis];
        if (fabs(x) < 0.5 * size) marks->x[count++] = x;
    }
    qsort(marks->x, (size_t)count, sizeof *marks->x, compare);
    for (int i = 0; i < count; i++)
        if (marks->count == 0 || marks->x[i] > marks->x[marks->count - 1] + tiny)
            marks->x[marks->count++] = marks->x[i];
done:
    return status;
}

// The ends of cracks are on odd columns and even rows, where the diagonals of the cells about them do not meet. All columns and
// rows together are even, so that a plate that is its own mirror image has such a mesh.
static int cells_between(const lines *marks, int axis, int i, double spacing)
{
    const int cells = (int)ceil((marks->x[i + 1] - marks->x[i]) / spacing * (1.0 - 1e-9));
    const bool is_first = i == 0, is_last = i + 2 == marks->count;
    const int remainder = axis == 0 && is_first != is_last ? 1 : 0;
    return cells % 2 == remainder ? cells : cells + 1;
}

static pdmc_status find_lines(const pdmc_problem *problem, int axis, lines *out)
{
    pdmc_status status = PDMC_OK;
    const double spacing = problem->solver.spacing;
    lines marks = {0};
    int count = 1;
    PDMC_TRY(find_marks(problem, axis, &marks));
    for (int i = 0; i + 1 < marks.count; i++) count += cells_between(&marks, axis, i, spacing);
    PDMC_NEW(out->x, count);
    for (int i = 0; i + 1 < marks.count; i++) {
        const int cells = cells_between(&marks, axis, i, spacing);
        for (int k = 0; k < cells; k++) out->x[out->count++] = marks.x[i] + (marks.x[i + 1] - marks.x[i]) * k / cells;
    }
    out->x[out->count++] = marks.x[marks.count - 1];
done:
    pdmc_free(marks.x);
    return status;
}

// A crack goes on through the edge of the plate where its end is no tip.
static pdmc_status open_crack(const pdmc_problem *problem, int index, pdmc_mesh *mesh)
{
    const pdmc_crack *crack = &problem->cracks[index];
    const double d[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]}, length = hypot(d[0], d[1]);
    if (fmin(fabs(d[0]), fabs(d[1])) > 1e-9 * length)
        return pdmc_raise(PDMC_ERR_CONFIG, "the crack \"%s\" is not parallel to the sides of the plate", crack->name);
    double end[2][2];
    for (int k = 0; k < 2; k++) {
        const double beyond = pdmc_problem_is_tip(problem, 2 * index + k) ? 0.0 : problem->plate.width / length;
        for (int i = 0; i < 2; i++)
            end[k][i] = pdmc_crack_end(problem->cracks, 2 * index + k)[i] + (2 * k - 1) * beyond * d[i];
    }
    return pdmc_mesh_cut(mesh, end[0], end[1]);
}

static pdmc_status draw_cells(const pdmc_problem *problem, pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    lines across[2] = {{0}, {0}};
    for (int axis = 0; axis < 2; axis++) PDMC_TRY(find_lines(problem, axis, &across[axis]));
    PDMC_TRY(pdmc_mesh_rectangle(across[0].count - 1, across[0].x, across[1].count - 1, across[1].x, mesh));
    for (int c = 0; c < problem->crack_count; c++) PDMC_TRY(open_crack(problem, c, mesh));
done:
    for (int axis = 0; axis < 2; axis++) pdmc_free(across[axis].x);
    return status;
}

static pdmc_status draw_triangles(const pdmc_problem *problem, pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    pdmc_slit *slits = NULL;
    PDMC_NEW(slits, problem->crack_count);
    const pdmc_mesh_plate plate = pdmc_problem_mesh_plate(problem, slits);
    PDMC_TRY(pdmc_mesh_triangles(&plate, mesh));
done:
    pdmc_free(slits);
    return status;
}

static void mark_rough(const pdmc_problem *problem, pdmc_mesh *mesh)
{
    for (int e = 0; e < mesh->element_count; e++) {
        double middle[2] = {0.0, 0.0};
        for (int k = 3 * e; k < 3 * e + 3; k++)
            for (int i = 0; i < 2; i++) middle[i] += mesh->x[2 * (size_t)mesh->corner[k] + (size_t)i] / 3.0;
        for (int c = 0; c < problem->crack_count; c++)
            if (pdmc_point_segment_distance(middle, problem->cracks[c].from, problem->cracks[c].to) <=
                problem->solver.horizon)
                mesh->rough[e] = 1;
    }
}

pdmc_status pdmc_plate_mesh(const pdmc_problem *problem, pdmc_mesh *mesh)
{
    pdmc_mesh made = {0};
    const pdmc_status status =
        (problem->solver.mesh == PDMC_PLATE_TRIANGLES ? draw_triangles : draw_cells)(problem, &made);
    *mesh = (pdmc_mesh){0};
    if (status != PDMC_OK) {
        pdmc_mesh_clear(&made);
        return status;
    }
    mark_rough(problem, &made);
    *mesh = made;
    return PDMC_OK;
}
