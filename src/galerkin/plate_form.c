// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate_form.h"

#include "base/base_impl.h"
#include "galerkin/element.h"
#include "galerkin/pattern.h"
#include "galerkin/sight.h"

#include <math.h>
#include <omp.h>
#include <string.h>

// Elements are taken block by block: their pairs are integrated in parallel, and then added to the form by all threads,
// each of which has columns of its own and goes through the pairs in the same order.
typedef struct {
    const pdmc_problem *problem;
    const pdmc_space *space;
    const pdmc_neighbours *neighbours;
    const pdmc_element_rule *outer;
    double horizon, micromodulus;
    int planes;
    pdmc_element *elements; // all of them
    double *pairs;          // of one block of elements: [pairs, BLOCKS, planes, 3]
} assembler;

// What the points of one element give with another one, as blocks of [planes, 3]: the products of its own values (i, j) at
// 3 i + j, of one of the other's with one of its own at 9 + 3 i + j, and of the other's at 18 + 3 i + j.
enum { OWN = 0, CROSS = 9, FAR = 18, BLOCKS = 27 };

static double *block_at(const assembler *a, double *pair, int kind, int i, int j)
{
    return &pair[3 * (size_t)a->planes * (size_t)(kind + PDMC_CORNERS * i + j)];
}

// The planes in which a point sees anything of an element.
typedef struct {
    int first, end;
} range;

static range seen_planes(const assembler *a, const pdmc_bond_moments moments[])
{
    range r = {0, a->planes};
    while (r.first < r.end && moments[r.first].second[0] + moments[r.first].second[2] == 0.0) r.first++;
    while (r.first < r.end && moments[r.end - 1].second[0] + moments[r.end - 1].second[2] == 0.0) r.end--;
    return r;
}

// g . third and g . fourth . h of gradients: xx, xy, yy.
static void along(const double g[2], const pdmc_bond_moments *m, double out[3])
{
    for (int k = 0; k < 3; k++) out[k] = g[0] * m->third[k] + g[1] * m->third[k + 1];
}

static double between(const double g[2], const double h[2], const pdmc_bond_moments *m, int k)
{
    return g[0] * h[0] * m->fourth[k] + (g[0] * h[1] + g[1] * h[0]) * m->fourth[k + 1] + g[1] * h[1] * m->fourth[k + 2];
}

// Within one element u' - u goes with xi.
static void add_same(const assembler *a, const pdmc_element *e, int plane, const pdmc_bond_moments *m, double weight,
                     double *pair)
{
    for (int i = 0; i < PDMC_CORNERS; i++)
        for (int j = 0; j <= i; j++) {
            double *own = block_at(a, pair, OWN, i, j) + 3 * plane;
            for (int k = 0; k < 3; k++) own[k] += weight * between(e->gradient[i], e->gradient[j], m, k);
        }
}

// u' = value'(x) + gradient' . xi, continued to the point x of the first element.
static void add_different(const assembler *a, const double near[], const double far[], const pdmc_element *other,
                          int plane, const pdmc_bond_moments *m, double weight, double *pair)
{
    double third[PDMC_CORNERS][3];
    for (int i = 0; i < PDMC_CORNERS; i++) along(other->gradient[i], m, third[i]);
    for (int i = 0; i < PDMC_CORNERS; i++)
        for (int j = 0; j < PDMC_CORNERS; j++) {
            double *own = block_at(a, pair, OWN, i, j) + 3 * plane, *cross = block_at(a, pair, CROSS, i, j) + 3 * plane;
            double *both = block_at(a, pair, FAR, i, j) + 3 * plane;
            for (int k = 0; k < 3; k++) {
                cross[k] -= weight * near[j] * (far[i] * m->second[k] + third[i][k]);
                if (j > i) continue;
                own[k] += weight * near[i] * near[j] * m->second[k];
                both[k] += weight * (far[i] * far[j] * m->second[k] + far[i] * third[j][k] + far[j] * third[i][k] +
                                     between(other->gradient[i], other->gradient[j], m, k));
            }
        }
}

static bool is_beyond(const assembler *a, const pdmc_element *other, const double x[2])
{
    const double d[2] = {other->middle[0] - x[0], other->middle[1] - x[1]}, reach = a->horizon + other->radius;
    return d[0] * d[0] + d[1] * d[1] >= reach * reach;
}

// One outer point with one other element.
static void add_point(const assembler *a, int e, int point, const pdmc_sight *sight, const double x[2], int other,
                      double *pair)
{
    const pdmc_element *near = &a->elements[e], *far = &a->elements[other];
    const double *at = &a->outer->at[PDMC_CORNERS * point];
    const double weight = 0.5 * a->micromodulus * near->size * a->outer->weight[point];
    pdmc_bond_moments moments[PDMC_PLATE_PLANES];
    double corner[PDMC_CORNERS][2], value[PDMC_CORNERS];
    if (is_beyond(a, far, x)) return;
    memset(moments, 0, (size_t)a->planes * sizeof *moments);
    for (int i = 0; i < PDMC_CORNERS; i++)
        for (int d = 0; d < 2; d++) corner[i][d] = far->corner[i][d] - x[d];
    pdmc_sight_moments(sight, a->horizon, a->planes, corner, moments);
    pdmc_element_coordinates(far, 2, x, value);
    const range seen = seen_planes(a, moments);
    for (int p = seen.first; p < seen.end; p++) {
        if (other == e) add_same(a, near, p, &moments[p], weight, pair);
        else add_different(a, at, value, far, p, &moments[p], weight, pair);
    }
}

static size_t pair_size(const assembler *a)
{
    return (size_t)BLOCKS * (size_t)a->planes * 3;
}

static void integrate_element(const assembler *a, int e, double *pairs)
{
    const int64_t first = a->neighbours->start[e], last = a->neighbours->start[e + 1];
    memset(pairs, 0, (size_t)(last - first) * pair_size(a) * sizeof *pairs);
    for (int p = 0; p < a->outer->count; p++) {
        double x[2];
        pdmc_element_point(&a->elements[e], 2, &a->outer->at[PDMC_CORNERS * p], x);
        const pdmc_sight sight = pdmc_sight_from(x, a->horizon, a->problem->crack_count, a->problem->cracks);
        for (int64_t k = first; k < last; k++)
            add_point(a, e, p, &sight, x, a->neighbours->element[k], &pairs[(size_t)(k - first) * pair_size(a)]);
    }
}

// ---- adding to the form ----

// The columns of one thread: neighbours in the mesh have near columns, which should not be one thread's alone.
typedef struct {
    int first, stride;
    pdmc_plate_form *form;
} share;

static int64_t entry_of(const pdmc_plate_form *form, int row, int column)
{
    int64_t low = form->start[column], high = form->start[column + 1] - 1;
    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (form->row[middle] < row) low = middle + 1;
        else high = middle;
    }
    return low;
}

static void add(const share *s, int i, int j, double factor, const double block[])
{
    const int column = i < j ? i : j, row = i < j ? j : i, size = 3 * s->form->planes;
    if (column % s->stride != s->first) return;
    double *value = &s->form->value[(size_t)entry_of(s->form, row, column) * (size_t)size];
    for (int k = 0; k < size; k++) value[k] += factor * block[k];
}

static void add_symmetric(const assembler *a, int e, int kind, double *pair, const share *s)
{
    const int *value = &a->space->value[PDMC_CORNERS * e];
    for (int i = 0; i < PDMC_CORNERS; i++)
        for (int j = 0; j <= i; j++) add(s, value[i], value[j], 1.0, block_at(a, pair, kind, i, j));
}

// A value that both elements have stands in the product twice.
static void add_cross(const assembler *a, int e, int other, double *pair, const share *s)
{
    const int *near = &a->space->value[PDMC_CORNERS * e], *far = &a->space->value[PDMC_CORNERS * other];
    for (int i = 0; i < PDMC_CORNERS; i++)
        for (int j = 0; j < PDMC_CORNERS; j++)
            add(s, far[i], near[j], far[i] == near[j] ? 2.0 : 1.0, block_at(a, pair, CROSS, i, j));
}

static void add_element(const assembler *a, int e, double *pairs, const share *s)
{
    const pdmc_neighbours *near = a->neighbours;
    for (int64_t k = near->start[e]; k < near->start[e + 1]; k++) {
        double *pair = &pairs[(size_t)(k - near->start[e]) * pair_size(a)];
        add_symmetric(a, e, OWN, pair, s);
        if (near->element[k] == e) continue;
        add_cross(a, e, near->element[k], pair, s);
        add_symmetric(a, near->element[k], FAR, pair, s);
    }
}

static int end_of_block(const assembler *a, int begin)
{
    const int elements = a->space->mesh->element_count, at_a_time = 8 + 256 / a->planes;
    return begin + at_a_time < elements ? begin + at_a_time : elements;
}

static pdmc_status allocate(assembler *a)
{
    pdmc_status status = PDMC_OK;
    const pdmc_mesh *mesh = a->space->mesh;
    int64_t most = 0;
    for (int begin = 0; begin < mesh->element_count; begin = end_of_block(a, begin)) {
        const int64_t pairs = a->neighbours->start[end_of_block(a, begin)] - a->neighbours->start[begin];
        if (pairs > most) most = pairs;
    }
    PDMC_NEW(a->elements, mesh->element_count);
    PDMC_NEW(a->pairs, (size_t)most * pair_size(a));
    for (int e = 0; e < mesh->element_count; e++) a->elements[e] = pdmc_element_of(mesh, e);
done:
    return status;
}

static void assemble(const assembler *a, int threads, pdmc_plate_form *form)
{
    const int64_t *start = a->neighbours->start;
    for (int begin = 0; begin < a->space->mesh->element_count; begin = end_of_block(a, begin)) {
        const int end = end_of_block(a, begin);
#pragma omp parallel num_threads(threads)
        {
            const share own = {omp_get_thread_num(), omp_get_num_threads(), form};
#pragma omp for schedule(dynamic, 4)
            for (int e = begin; e < end; e++)
                integrate_element(a, e, &a->pairs[(size_t)(start[e] - start[begin]) * pair_size(a)]);
            for (int e = begin; e < end; e++)
                add_element(a, e, &a->pairs[(size_t)(start[e] - start[begin]) * pair_size(a)], &own);
        }
    }
}

static pdmc_status create_pattern(const assembler *a, pdmc_plate_form *form)
{
    pdmc_form pattern;
    pdmc_status status = pdmc_form_pattern(a->space, a->neighbours, &pattern);
    if (status != PDMC_OK) return status;
    form->count = pattern.free_count;
    form->planes = a->planes;
    form->start = pattern.start;
    form->row = pattern.row;
    pdmc_free(pattern.value);
    PDMC_NEW(form->value, (size_t)form->start[form->count] * (size_t)form->planes * 3);
done:
    return status;
}

pdmc_status pdmc_plate_form_create(const pdmc_problem *problem, const pdmc_space *space, int parts, int planes,
                                   int threads, pdmc_plate_form *form)
{
    pdmc_status status = PDMC_OK;
    const pdmc_form_rule rule = {.outer = PDMC_OUTER_GAUSS, .parts = parts};
    pdmc_element_rule outer = {0};
    pdmc_neighbours neighbours = {0};
    pdmc_plate_form made = {0};
    assembler a = {.problem = problem,
                   .space = space,
                   .neighbours = &neighbours,
                   .outer = &outer,
                   .horizon = problem->solver.horizon,
                   .micromodulus = pdmc_micromodulus(&problem->material, problem->solver.horizon),
                   .planes = planes};
    *form = made;
    PDMC_REQUIRE(1 <= planes && planes <= PDMC_PLATE_PLANES, "%d planes are not from 1 to %d", planes,
                 PDMC_PLATE_PLANES);
    PDMC_REQUIRE(problem->crack_count <= PDMC_GALERKIN_CRACKS, "%d cracks are more than %d", problem->crack_count,
                 PDMC_GALERKIN_CRACKS);
    PDMC_TRY(pdmc_element_rule_outer(2, &rule, &outer));
    PDMC_TRY(pdmc_neighbours_create(space->mesh, a.horizon, &neighbours));
    PDMC_TRY(allocate(&a));
    PDMC_TRY(create_pattern(&a, &made));
    assemble(&a, threads, &made);
    *form = made;
    made = (pdmc_plate_form){0};
done:
    pdmc_element_rule_clear(&outer);
    pdmc_neighbours_clear(&neighbours);
    pdmc_plate_form_clear(&made);
    pdmc_free(a.elements);
    pdmc_free(a.pairs);
    return status;
}

void pdmc_plate_form_clear(pdmc_plate_form *form)
{
    pdmc_free(form->start);
    pdmc_free(form->row);
    pdmc_free(form->value);
    *form = (pdmc_plate_form){0};
}
