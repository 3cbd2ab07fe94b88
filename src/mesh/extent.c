// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_impl.h"

#include <math.h>
#include <string.h>

pdmc_simplex pdmc_mesh_simplex(const pdmc_mesh *mesh, int element)
{
    const size_t d = (size_t)mesh->dimension;
    const int *node = &mesh->corner[(size_t)element * (d + 1)];
    pdmc_simplex s = {.dimension = mesh->dimension};
    for (size_t k = 0; k <= d; k++) memcpy(s.corner[k], &mesh->x[d * (size_t)node[k]], d * sizeof *mesh->x);
    return s;
}

double pdmc_simplex_extent(const pdmc_simplex *s)
{
    double e[PDMC_MESH_AXES][PDMC_MESH_AXES];
    for (int k = 0; k < s->dimension; k++)
        for (int a = 0; a < s->dimension; a++) e[k][a] = s->corner[k + 1][a] - s->corner[0][a];
    if (s->dimension == 1) return e[0][0];
    if (s->dimension == 2) return 0.5 * (e[0][0] * e[1][1] - e[0][1] * e[1][0]);
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) + e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6.0;
}

double pdmc_mesh_distance(int dimension, const double a[], const double b[])
{
    double square = 0.0;
    for (int k = 0; k < dimension; k++) square += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(square);
}

double pdmc_simplex_diameter(const pdmc_simplex *s)
{
    double longest = 0.0;
    for (int i = 0; i <= s->dimension; i++)
        for (int j = 0; j < i; j++)
            longest = fmax(longest, pdmc_mesh_distance(s->dimension, s->corner[i], s->corner[j]));
    return longest;
}

void pdmc_simplex_middle(const pdmc_simplex *s, double middle[])
{
    for (int a = 0; a < s->dimension; a++) {
        middle[a] = 0.0;
        for (int k = 0; k <= s->dimension; k++) middle[a] += s->corner[k][a] / (s->dimension + 1);
    }
}

double pdmc_mesh_extent(const pdmc_mesh *mesh, int element)
{
    const pdmc_simplex s = pdmc_mesh_simplex(mesh, element);
    return pdmc_simplex_extent(&s);
}
