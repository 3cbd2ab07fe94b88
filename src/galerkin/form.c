// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/pair.h"
#include "galerkin/pattern.h"

#include <math.h>
#include <omp.h>

enum { ELEMENTS_AT_A_TIME = 256 };

// Elements are taken block by block: their pairs are integrated in parallel, and then added to the form by all threads,
// each of which has columns of its own and goes through the pairs in the same order.
typedef struct {
    const pdmc_space *space;
    const pdmc_neighbours *neighbours;
    const pdmc_pair_rule *rule;
    pdmc_element *elements;  // all of them
    pdmc_pair_block *blocks; // of the pairs of one block of elements
} assembler;

static bool is_needed(const assembler *a, int e, int other)
{
    const pdmc_mesh *mesh = a->space->mesh;
    return !(mesh->layer[e] && mesh->layer[other]) && (other >= e || pdmc_pair_is_ordered(a->rule));
}

static void integrate_element(const assembler *a, int e, pdmc_pair_block blocks[])
{
    const pdmc_neighbours *near = a->neighbours;
    for (int64_t k = near->start[e]; k < near->start[e + 1]; k++) {
        const int other = near->element[k];
        if (is_needed(a, e, other))
            pdmc_pair_integrate(a->rule, &a->elements[e], &a->elements[other], e == other, &blocks[k - near->start[e]]);
    }
}

// The columns of one thread: neighbours in the mesh have near columns, which should not be one thread's alone.
typedef struct {
    int first, stride;
    pdmc_form *form;
} share;

static void add(const share *s, int i, int j, double value)
{
    if ((i < j ? i : j) % s->stride == s->first) pdmc_form_add(s->form, i, j, value);
}

static void add_symmetric(const assembler *a, int e, double block[PDMC_CORNERS][PDMC_CORNERS], const share *s)
{
    const int n = a->space->mesh->dimension + 1, *value = &a->space->value[n * e];
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) add(s, value[i], value[j], block[i][j]);
}

// A value that both elements have stands in the product twice.
static void add_cross(const assembler *a, int e, int other, double block[PDMC_CORNERS][PDMC_CORNERS], const share *s)
{
    const int n = a->space->mesh->dimension + 1;
    const int *near = &a->space->value[n * e], *far = &a->space->value[n * other];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) add(s, far[i], near[j], (far[i] == near[j] ? 2.0 : 1.0) * block[i][j]);
}

static void add_element(const assembler *a, int e, const pdmc_pair_block blocks[], const share *s)
{
    const pdmc_neighbours *near = a->neighbours;
    pdmc_pair_block sum = {0};
    for (int64_t k = near->start[e]; k < near->start[e + 1]; k++) {
        const int other = near->element[k];
        if (!is_needed(a, e, other)) continue;
        pdmc_pair_block block = blocks[k - near->start[e]];
        for (int i = 0; i < PDMC_CORNERS; i++)
            for (int j = 0; j < PDMC_CORNERS; j++) sum.own[i][j] += block.own[i][j];
        if (other == e) continue;
        add_cross(a, e, other, block.cross, s);
        add_symmetric(a, other, block.far, s);
    }
    add_symmetric(a, e, sum.own, s);
}

static int end_of_block(const assembler *a, int begin)
{
    const int elements = a->space->mesh->element_count;
    return begin + ELEMENTS_AT_A_TIME < elements ? begin + ELEMENTS_AT_A_TIME : elements;
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
    PDMC_NEW(a->blocks, most);
    for (int e = 0; e < mesh->element_count; e++) a->elements[e] = pdmc_element_of(mesh, e);
done:
    return status;
}

static void assemble(const assembler *a, int threads, pdmc_form *form)
{
    const int64_t *start = a->neighbours->start;
    for (int begin = 0; begin < a->space->mesh->element_count; begin = end_of_block(a, begin)) {
        const int end = end_of_block(a, begin);
#pragma omp parallel num_threads(threads)
        {
            const share own = {omp_get_thread_num(), omp_get_num_threads(), form};
#pragma omp for schedule(dynamic, 8)
            for (int e = begin; e < end; e++) integrate_element(a, e, &a->blocks[start[e] - start[begin]]);
            for (int e = begin; e < end; e++) add_element(a, e, &a->blocks[start[e] - start[begin]], &own);
        }
    }
}

pdmc_status pdmc_form_peridynamic(const pdmc_space *space, const pdmc_scalar_kernel *kernel, const pdmc_form_rule *rule,
                                  int threads, pdmc_form *form)
{
    pdmc_status status = PDMC_OK;
    pdmc_pair_rule pairs = {0};
    pdmc_neighbours neighbours = {0};
    assembler a = {.space = space, .neighbours = &neighbours, .rule = &pairs};
    *form = (pdmc_form){0};
    PDMC_REQUIRE(kernel->dimension == space->mesh->dimension, "a kernel of %d dimensions for a mesh of %d",
                 kernel->dimension, space->mesh->dimension);
    PDMC_TRY(pdmc_pair_rule_create(kernel, rule, &pairs));
    PDMC_TRY(pdmc_neighbours_create(space->mesh, kernel->horizon, &neighbours));
    PDMC_TRY(allocate(&a));
    PDMC_TRY(pdmc_form_pattern(space, &neighbours, form));
    assemble(&a, threads, form);
done:
    pdmc_pair_rule_clear(&pairs);
    pdmc_neighbours_clear(&neighbours);
    pdmc_free(a.elements);
    pdmc_free(a.blocks);
    return status;
}

// ---- forms within elements ----

typedef double local_product(const pdmc_element *element, int corners, int a, int b);

static double mass_product(const pdmc_element *element, int corners, int a, int b)
{
    return element->size * (a == b ? 2.0 : 1.0) / (corners * (corners + 1.0));
}

static double gradient_product(const pdmc_element *element, int corners, int a, int b)
{
    (void)corners;
    const double *g = element->gradient[a], *h = element->gradient[b];
    return element->size * (g[0] * h[0] + g[1] * h[1]);
}

static pdmc_status form_local(const pdmc_space *space, local_product *product, pdmc_form *form)
{
    pdmc_status status = PDMC_OK;
    const pdmc_mesh *mesh = space->mesh;
    const int n = mesh->dimension + 1;
    pdmc_neighbours selves = {0};
    *form = (pdmc_form){0};
    PDMC_TRY(pdmc_neighbours_create(mesh, 0.0, &selves));
    PDMC_TRY(pdmc_form_pattern(space, &selves, form));
    for (int e = 0; e < mesh->element_count; e++) {
        const pdmc_element element = pdmc_element_of(mesh, e);
        const int *value = &space->value[n * e];
        for (int a = 0; a < n && !mesh->layer[e]; a++)
            for (int b = 0; b <= a; b++) pdmc_form_add(form, value[a], value[b], product(&element, n, a, b));
    }
done:
    pdmc_neighbours_clear(&selves);
    return status;
}

pdmc_status pdmc_form_mass(const pdmc_space *space, pdmc_form *form)
{
    return form_local(space, mass_product, form);
}

pdmc_status pdmc_form_gradient(const pdmc_space *space, pdmc_form *form)
{
    return form_local(space, gradient_product, form);
}
