// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/element.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <math.h>
#include <string.h>

static void fill_interval(pdmc_element *e)
{
    e->size = e->corner[1][0] - e->corner[0][0];
    e->gradient[0][0] = -1.0 / e->size;
    e->gradient[1][0] = 1.0 / e->size;
}

// The gradient of a coordinate is the normal of the opposite edge over twice the area.
static void fill_triangle(pdmc_element *e)
{
    const double(*c)[2] = (const double(*)[2])e->corner;
    const double twice = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    e->size = 0.5 * twice;
    for (int a = 0; a < 3; a++) {
        const double *from = c[(a + 1) % 3], *to = c[(a + 2) % 3];
        e->gradient[a][0] = (from[1] - to[1]) / twice;
        e->gradient[a][1] = (to[0] - from[0]) / twice;
    }
}

pdmc_element pdmc_element_of(const pdmc_mesh *mesh, int element)
{
    pdmc_element e = {0};
    const int dimension = mesh->dimension, n = dimension + 1;
    for (int a = 0; a < n; a++) {
        memcpy(e.corner[a], &mesh->x[dimension * mesh->corner[n * element + a]], (size_t)dimension * sizeof(double));
        for (int d = 0; d < dimension; d++) e.middle[d] += e.corner[a][d] / n;
    }
    for (int a = 0; a < n; a++)
        e.radius = fmax(e.radius, hypot(e.corner[a][0] - e.middle[0], e.corner[a][1] - e.middle[1]));
    if (dimension == 1) fill_interval(&e);
    else fill_triangle(&e);
    return e;
}

void pdmc_element_coordinates(const pdmc_element *element, int dimension, const double x[2], double value[PDMC_CORNERS])
{
    for (int a = 0; a <= dimension; a++) {
        const double *origin = element->corner[(a + 1) % (dimension + 1)], *g = element->gradient[a]; // where it is 0
        value[a] = g[0] * (x[0] - origin[0]) + g[1] * (x[1] - origin[1]);
    }
}

void pdmc_element_point(const pdmc_element *element, int dimension, const double at[PDMC_CORNERS], double x[2])
{
    x[0] = x[1] = 0.0;
    for (int a = 0; a <= dimension; a++)
        for (int d = 0; d < dimension; d++) x[d] += at[a] * element->corner[a][d];
}

// ---- rules ----

typedef struct {
    double at[PDMC_CORNERS], weight;
} rule_point;

// Gauss-Legendre with three points, and Simpson's rule.
static const rule_point interval_gauss[] = {
    {{0.8872983346207417, 0.1127016653792583, 0.0}, 5.0 / 18.0},
    {{0.5, 0.5, 0.0}, 8.0 / 18.0},
    {{0.1127016653792583, 0.8872983346207417, 0.0}, 5.0 / 18.0},
};
static const rule_point interval_edges[] = {
    {{1.0, 0.0, 0.0}, 1.0 / 6.0}, {{0.5, 0.5, 0.0}, 4.0 / 6.0}, {{0.0, 1.0, 0.0}, 1.0 / 6.0}};

// Radon's rule of degree 5: the middle, and points at (6 -+ sqrt 15) / 21 with weights (155 -+ sqrt 15) / 1200.
#define NEAR 0.1012865073234563
#define FAR 0.4701420641051151
#define NEAR_WEIGHT 0.1259391805448272
#define FAR_WEIGHT 0.1323941527885062
static const rule_point triangle_gauss[] = {
    {{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 0.225},    {{1.0 - 2.0 * NEAR, NEAR, NEAR}, NEAR_WEIGHT},
    {{NEAR, 1.0 - 2.0 * NEAR, NEAR}, NEAR_WEIGHT}, {{NEAR, NEAR, 1.0 - 2.0 * NEAR}, NEAR_WEIGHT},
    {{1.0 - 2.0 * FAR, FAR, FAR}, FAR_WEIGHT},     {{FAR, 1.0 - 2.0 * FAR, FAR}, FAR_WEIGHT},
    {{FAR, FAR, 1.0 - 2.0 * FAR}, FAR_WEIGHT},
};
static const rule_point triangle_edges[] = {
    {{0.5, 0.5, 0.0}, 1.0 / 3.0}, {{0.0, 0.5, 0.5}, 1.0 / 3.0}, {{0.5, 0.0, 0.5}, 1.0 / 3.0}};
#define COUNT(array) (int)(sizeof(array) / sizeof *(array))

static pdmc_status rule_allocate(int points, pdmc_element_rule *rule)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(rule->at, PDMC_CORNERS * (size_t)points);
    PDMC_NEW(rule->weight, points);
done:
    return status;
}

// The points of one part, whose corners are given in barycentric coordinates.
static void add_part(int count, const rule_point points[], double corner[PDMC_CORNERS][PDMC_CORNERS], double share,
                     pdmc_element_rule *rule)
{
    for (int p = 0; p < count; p++) {
        for (int a = 0; a < PDMC_CORNERS; a++)
            for (int c = 0; c < PDMC_CORNERS; c++)
                rule->at[PDMC_CORNERS * rule->count + a] += points[p].at[c] * corner[c][a];
        rule->weight[rule->count++] = share * points[p].weight;
    }
}

static void set_corner(double i, double j, int parts, double corner[PDMC_CORNERS])
{
    corner[1] = i / parts;
    corner[2] = j / parts;
    corner[0] = 1.0 - corner[1] - corner[2];
}

static void divide_interval(int count, const rule_point points[], int parts, pdmc_element_rule *rule)
{
    for (int i = 0; i < parts; i++) {
        double corner[PDMC_CORNERS][PDMC_CORNERS] = {{0}};
        for (int c = 0; c < 2; c++) set_corner(i + c, 0.0, parts, corner[c]);
        add_part(count, points, corner, 1.0 / parts, rule);
    }
}

// Rows of parts, of which every second one is upside down.
static void divide_triangle(int count, const rule_point points[], int parts, pdmc_element_rule *rule)
{
    static const int upright[3][2] = {{0, 0}, {1, 0}, {0, 1}}, turned[3][2] = {{1, 1}, {0, 1}, {1, 0}};
    for (int j = 0; j < parts; j++)
        for (int i = 0; i < 2 * (parts - j) - 1; i++) {
            double corner[PDMC_CORNERS][PDMC_CORNERS];
            for (int c = 0; c < 3; c++) {
                const int *shift = i % 2 ? turned[c] : upright[c];
                set_corner(i / 2 + shift[0], j + shift[1], parts, corner[c]);
            }
            add_part(count, points, corner, 1.0 / (parts * parts), rule);
        }
}

pdmc_status pdmc_element_rule_outer(int dimension, const pdmc_form_rule *rule, pdmc_element_rule *out)
{
    const bool edges = rule->outer == PDMC_OUTER_EDGES;
    const int parts = dimension == 1 ? rule->parts : rule->parts * rule->parts;
    *out = (pdmc_element_rule){0};
    const pdmc_status status = rule_allocate(parts * COUNT(triangle_gauss), out);
    if (status != PDMC_OK) pdmc_element_rule_clear(out);
    else if (dimension == 1) divide_interval(3, edges ? interval_edges : interval_gauss, rule->parts, out);
    else if (edges) divide_triangle(COUNT(triangle_edges), triangle_edges, rule->parts, out);
    else divide_triangle(COUNT(triangle_gauss), triangle_gauss, rule->parts, out);
    return status;
}

enum { SMOOTH = 5 };

// Collapsed at the first corner.
static void add_smooth(int dimension, const double x[SMOOTH], const double w[SMOOTH], pdmc_element_rule *rule)
{
    for (int i = 0; i < SMOOTH; i++)
        for (int j = 0; j < (dimension == 1 ? 1 : SMOOTH); j++) {
            double *at = &rule->at[PDMC_CORNERS * rule->count];
            at[0] = 1.0 - x[i];
            at[1] = dimension == 1 ? x[i] : x[i] * (1.0 - x[j]);
            at[2] = dimension == 1 ? 0.0 : x[i] * x[j];
            rule->weight[rule->count++] = dimension == 1 ? w[i] : 2.0 * x[i] * w[i] * w[j];
        }
}

pdmc_status pdmc_element_rule_smooth(int dimension, pdmc_element_rule *out)
{
    pdmc_status status = PDMC_OK;
    double x[SMOOTH], w[SMOOTH];
    *out = (pdmc_element_rule){0};
    PDMC_TRY(pdmc_gauss_legendre(SMOOTH, 0.0, 1.0, x, w));
    PDMC_TRY(rule_allocate(SMOOTH * SMOOTH, out));
    add_smooth(dimension, x, w, out);
done:
    if (status != PDMC_OK) pdmc_element_rule_clear(out);
    return status;
}

void pdmc_element_rule_clear(pdmc_element_rule *rule)
{
    pdmc_free(rule->at);
    pdmc_free(rule->weight);
    *rule = (pdmc_element_rule){0};
}
