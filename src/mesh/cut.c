// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

// The segment, and how near to it a point counts as on it.
typedef struct {
    double from[2], along[2], length, tolerance;
} segment;

static double across(const segment *s, const double x[2])
{
    return s->along[0] * (x[1] - s->from[1]) - s->along[1] * (x[0] - s->from[0]);
}

static bool is_inside(const segment *s, const double x[2])
{
    const double along = s->along[0] * (x[0] - s->from[0]) + s->along[1] * (x[1] - s->from[1]);
    return fabs(across(s, x)) <= s->tolerance && along > s->tolerance && along < s->length - s->tolerance;
}

static bool is_right(const segment *s, const pdmc_mesh *mesh, int element)
{
    double sum = 0.0;
    for (int a = 0; a < 3; a++) sum += across(s, &mesh->x[2 * (size_t)mesh->corner[3 * (size_t)element + (size_t)a]]);
    return sum < 0.0;
}

// Which nodes get a twin: those inside the segment with elements on its right; twin[n] is its number, or 0.
static int number_twins(const segment *s, const pdmc_mesh *mesh, int twin[])
{
    int count = 0;
    for (int e = 0; e < mesh->element_count; e++)
        for (int a = 0; a < 3 && is_right(s, mesh, e); a++) {
            const int node = mesh->corner[3 * (size_t)e + (size_t)a];
            if (twin[node] == 0 && is_inside(s, &mesh->x[2 * (size_t)node])) twin[node] = mesh->node_count + count++;
        }
    return count;
}

pdmc_status pdmc_mesh_cut(pdmc_mesh *mesh, const double from[2], const double to[2])
{
    pdmc_status status = PDMC_OK;
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    const segment s = {{from[0], from[1]},
                       {(to[0] - from[0]) / length, (to[1] - from[1]) / length},
                       length,
                       1e-9 * pdmc_mesh_spacing(mesh)};
    int *twin = NULL;
    double *x = NULL;
    PDMC_NEW(twin, mesh->node_count);
    const int count = number_twins(&s, mesh, twin);
    PDMC_NEW(x, 2 * ((size_t)mesh->node_count + (size_t)count));
    memcpy(x, mesh->x, 2 * (size_t)mesh->node_count * sizeof *x);
    for (int n = 0; n < mesh->node_count; n++)
        if (twin[n] > 0) memcpy(&x[2 * (size_t)twin[n]], &mesh->x[2 * (size_t)n], 2 * sizeof *x);
    for (int e = 0; e < mesh->element_count; e++) {
        if (!is_right(&s, mesh, e)) continue;
        for (size_t k = 3 * (size_t)e; k < 3 * (size_t)e + 3; k++)
            if (twin[mesh->corner[k]] > 0) mesh->corner[k] = twin[mesh->corner[k]];
    }
    pdmc_free(mesh->x);
    mesh->x = x;
    mesh->node_count += count;
    x = NULL;
done:
    pdmc_free(twin);
    pdmc_free(x);
    return status;
}
