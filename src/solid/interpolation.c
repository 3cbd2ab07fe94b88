// SPDX-License-Identifier: GPL-3.0-or-later

/// Displacements of Gauss points by moving least squares. The shape functions of a cell's points depend on how far its
/// node is from the faces, and only as far as the support reaches: they are found once for each such class of nodes.

#include "solid_impl.h"

#include "base/base_impl.h"
#include "pdmc/moving_least_squares.h"

#include <math.h>
#include <string.h>

static int class_of(const solid_interpolation *m, int axis, int index)
{
    const int n = m->nodes[axis], reach = m->reach;
    if (n <= 2 * reach || index <= reach) return index;
    return index < n - reach ? reach : 2 * reach - (n - 1 - index);
}

/// A node of a class.
static int index_of(const solid_interpolation *m, int axis, int class)
{
    const int n = m->nodes[axis], reach = m->reach;
    return n <= 2 * reach || class <= reach ? class : n - 1 - (2 * reach - class);
}

/// The nodes about a node of a class that may contribute.
static int surround(const solid_interpolation *m, double spacing, const int index[3], int (*shift)[3], double *position)
{
    int count = 0;
    for (int z = -m->reach; z <= m->reach; z++)
        for (int y = -m->reach; y <= m->reach; y++)
            for (int x = -m->reach; x <= m->reach; x++) {
                const int step[3] = {x, y, z};
                bool inside = true;
                for (int k = 0; k < 3; k++)
                    if (index[k] + step[k] < 0 || index[k] + step[k] >= m->nodes[k]) inside = false;
                if (!inside) continue;
                for (int k = 0; k < 3; k++) {
                    shift[count][k] = step[k];
                    position[3 * count + k] = step[k] * spacing;
                }
                count++;
            }
    return count;
}

/// The shape functions of one point of a class, appended to those that are there.
static pdmc_status add_point(solid_interpolation *m, const pdmc_moving_least_squares *fit, const double at[3],
                             int count, const int (*shift)[3], const double *position, double *value)
{
    const pdmc_status status = pdmc_shape_functions_at(fit, at, count, position, value, NULL);
    if (status != PDMC_OK) return status;
    for (int i = 0; i < count; i++) {
        if (value[i] == 0.0) continue;
        memcpy(m->shift[m->terms], shift[i], sizeof shift[i]);
        m->weight[m->terms++] = value[i];
    }
    return PDMC_OK;
}

pdmc_status solid_interpolation_create(const pdmc_solid_options *options, const solid_stencil *stencil,
                                       solid_interpolation *m)
{
    pdmc_status status = PDMC_OK;
    const pdmc_moving_least_squares fit = pdmc_moving_least_squares_default(3, options->support);
    int(*shift)[3] = NULL;
    double *position = NULL, *value = NULL;
    *m = (solid_interpolation){.reach = (int)floor(options->support / options->spacing + 0.5),
                               .points = stencil->points};
    const int side = 2 * m->reach + 1, block = side * side * side;
    size_t classes = 1;
    for (int k = 0; k < 3; k++) {
        m->nodes[k] = options->nodes[k];
        m->classes[k] = options->nodes[k] < side ? options->nodes[k] : side;
        classes *= (size_t)m->classes[k];
    }
    PDMC_NEW(shift, block);
    PDMC_NEW(position, 3 * block);
    PDMC_NEW(value, block);
    PDMC_NEW(m->first, classes * (size_t)m->points + 1);
    PDMC_NEW(m->shift, classes * (size_t)m->points * (size_t)block);
    PDMC_NEW(m->weight, classes * (size_t)m->points * (size_t)block);
    for (size_t c = 0; c < classes; c++) {
        const int class[3] = {(int)(c % (size_t)m->classes[0]),
                              (int)(c / (size_t)m->classes[0] % (size_t)m->classes[1]),
                              (int)(c / (size_t)m->classes[0] / (size_t)m->classes[1])};
        const int index[3] = {index_of(m, 0, class[0]), index_of(m, 1, class[1]), index_of(m, 2, class[2])};
        const int count = surround(m, options->spacing, index, shift, position);
        for (int p = 0; p < m->points; p++) {
            m->first[c * (size_t)m->points + (size_t)p] = m->terms;
            status = add_point(m, &fit, stencil->at[p], count, (const int(*)[3])shift, position, value);
            if (status != PDMC_OK)
                PDMC_FAIL(status, "Gauss point %d of node (%d, %d, %d): %s", p, index[0], index[1], index[2],
                          pdmc_last_error());
        }
    }
    m->first[classes * (size_t)m->points] = m->terms;
done:
    pdmc_free(shift);
    pdmc_free(position);
    pdmc_free(value);
    if (status != PDMC_OK) solid_interpolation_clear(m);
    return status;
}

void solid_interpolation_clear(solid_interpolation *m)
{
    pdmc_free(m->first);
    pdmc_free(m->shift);
    pdmc_free(m->weight);
    *m = (solid_interpolation){0};
}

/// One point of a run of nodes of one class, side by side.
static void add_run(const solid_interpolation *m, size_t list, size_t nodes, size_t node, int length, const double u[],
                    double out[])
{
    for (size_t k = 0; k < 3; k++) memset(&out[k * nodes + node], 0, (size_t)length * sizeof *out);
    for (size_t t = m->first[list]; t < m->first[list + 1]; t++) {
        const ptrdiff_t rows = (ptrdiff_t)m->shift[t][2] * m->nodes[1] + m->shift[t][1];
        const ptrdiff_t from = (ptrdiff_t)node + rows * m->nodes[0] + m->shift[t][0];
        const double weight = m->weight[t];
        for (size_t k = 0; k < 3; k++) {
            const double *source = u + k * nodes + from;
            double *target = out + k * nodes + node;
            for (int i = 0; i < length; i++) target[i] += weight * source[i];
        }
    }
}

static void interpolate_row(const solid_interpolation *m, size_t nodes, int line, const double u[], double points[])
{
    const int y = line % m->nodes[1], z = line / m->nodes[1];
    const size_t row = (size_t)line * (size_t)m->nodes[0];
    const int beside = (class_of(m, 2, z) * m->classes[1] + class_of(m, 1, y)) * m->classes[0];
    for (int x = 0, end; x < m->nodes[0]; x = end) {
        const int class = class_of(m, 0, x);
        for (end = x + 1; end < m->nodes[0] && class_of(m, 0, end) == class; end++) continue;
        for (int p = 0; p < m->points; p++)
            add_run(m, (size_t)(beside + class) * (size_t)m->points + (size_t)p, nodes, row + (size_t)x, end - x, u,
                    points + (size_t)p * 3 * nodes);
    }
}

void solid_interpolate(const solid_interpolation *m, int threads, size_t nodes, const double u[], double points[])
{
    const int lines = m->nodes[1] * m->nodes[2];
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int line = 0; line < lines; line++) interpolate_row(m, nodes, line, u, points);
}
