// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/assembly.h"

#include "base/base_impl.h"

#include <omp.h>

enum { ELEMENTS_AT_A_TIME = 256 };

static bool is_needed(const pdmc_assembly *a, int e, int other)
{
    const pdmc_mesh *mesh = a->space->mesh;
    return !(mesh->layer[e] && mesh->layer[other]) && (other >= e || pdmc_pair_is_ordered(&a->rule));
}

// ---- pairs ----

typedef struct {
    const pdmc_bond_law *law; // NULL for linear bonds
    const double *u;
} bonds;

static void values_of(const pdmc_assembly *a, int e, const double u[], double value[PDMC_CORNERS])
{
    const int n = a->space->mesh->dimension + 1;
    for (int i = 0; i < n; i++) value[i] = u[a->space->value[n * e + i]];
}

static void integrate_element(const pdmc_assembly *a, const bonds *b, int e, pdmc_pair_block blocks[])
{
    const pdmc_neighbours *near = &a->neighbours;
    double u[2][PDMC_CORNERS] = {{0}};
    if (b->law) values_of(a, e, b->u, u[0]);
    for (int64_t k = near->start[e]; k < near->start[e + 1]; k++) {
        const int other = near->element[k];
        pdmc_pair_block *block = &blocks[k - near->start[e]];
        if (!is_needed(a, e, other)) continue;
        if (b->law) values_of(a, other, b->u, u[1]);
        if (b->law) pdmc_pair_stretch(&a->rule, b->law, &a->elements[e], &a->elements[other], e == other, u, block);
        else pdmc_pair_integrate(&a->rule, &a->elements[e], &a->elements[other], e == other, block);
    }
}

// ---- adding ----

// The columns of one thread: neighbours in the mesh have near columns, which should not be one thread's alone.
typedef struct {
    int first, stride;
    const pdmc_assembled *sum;
} share;

static void add(const share *s, int i, int j, double value)
{
    if ((i < j ? i : j) % s->stride == s->first) pdmc_form_add(s->sum->form, i, j, value);
}

static void add_symmetric(const pdmc_assembly *a, int e, double block[PDMC_CORNERS][PDMC_CORNERS], const share *s)
{
    const int n = a->space->mesh->dimension + 1, *value = &a->space->value[n * e];
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) add(s, value[i], value[j], block[i][j]);
}

// A value that both elements have stands in the product twice.
static void add_cross(const pdmc_assembly *a, int e, int other, double block[PDMC_CORNERS][PDMC_CORNERS],
                      const share *s)
{
    const int n = a->space->mesh->dimension + 1;
    const int *near = &a->space->value[n * e], *far = &a->space->value[n * other];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) add(s, far[i], near[j], (far[i] == near[j] ? 2.0 : 1.0) * block[i][j]);
}

static void add_element(const pdmc_assembly *a, int e, const pdmc_pair_block blocks[], const share *s)
{
    const pdmc_neighbours *near = &a->neighbours;
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

static void add_force(const pdmc_assembly *a, int e, const double force[PDMC_CORNERS], double sum[])
{
    const int n = a->space->mesh->dimension + 1, *value = &a->space->value[n * e];
    for (int i = 0; i < n; i++)
        if (value[i] < a->space->free_count) sum[value[i]] += force[i];
}

// By one thread, as there is little to add.
static void add_forces(const pdmc_assembly *a, int e, const pdmc_pair_block blocks[], const pdmc_assembled *sum)
{
    const pdmc_neighbours *near = &a->neighbours;
    for (int64_t k = near->start[e]; k < near->start[e + 1]; k++) {
        const int other = near->element[k];
        const pdmc_pair_block *block = &blocks[k - near->start[e]];
        if (!is_needed(a, e, other)) continue;
        if (sum->energy) *sum->energy += block->energy;
        if (!sum->force) continue;
        add_force(a, e, block->force[0], sum->force);
        add_force(a, other, block->force[1], sum->force);
    }
}

static int end_of_block(const pdmc_assembly *a, int begin)
{
    const int elements = a->space->mesh->element_count;
    return begin + ELEMENTS_AT_A_TIME < elements ? begin + ELEMENTS_AT_A_TIME : elements;
}

// Elements are taken block by block: their pairs are integrated in parallel, and then added to the form by all threads,
// each of which has columns of its own and goes through the pairs in the same order.
void pdmc_assembly_add(const pdmc_assembly *a, const pdmc_bond_law *law, const double u[], const pdmc_assembled *sum)
{
    const int64_t *start = a->neighbours.start;
    const bonds b = {law, u};
    for (int begin = 0; begin < a->space->mesh->element_count; begin = end_of_block(a, begin)) {
        const int end = end_of_block(a, begin);
#pragma omp parallel num_threads(a->threads)
        {
            const share own = {omp_get_thread_num(), omp_get_num_threads(), sum};
#pragma omp for schedule(dynamic, 8)
            for (int e = begin; e < end; e++) integrate_element(a, &b, e, &a->blocks[start[e] - start[begin]]);
            for (int e = begin; e < end && sum->form; e++)
                add_element(a, e, &a->blocks[start[e] - start[begin]], &own);
        }
        for (int e = begin; e < end && law; e++) add_forces(a, e, &a->blocks[start[e] - start[begin]], sum);
    }
}

// ---- life ----

static pdmc_status allocate(pdmc_assembly *a)
{
    pdmc_status status = PDMC_OK;
    const pdmc_mesh *mesh = a->space->mesh;
    int64_t most = 0;
    for (int begin = 0; begin < mesh->element_count; begin = end_of_block(a, begin)) {
        const int64_t pairs = a->neighbours.start[end_of_block(a, begin)] - a->neighbours.start[begin];
        if (pairs > most) most = pairs;
    }
    PDMC_NEW(a->elements, mesh->element_count);
    PDMC_NEW(a->blocks, most);
    for (int e = 0; e < mesh->element_count; e++) a->elements[e] = pdmc_element_of(mesh, e);
done:
    return status;
}

pdmc_status pdmc_assembly_create(const pdmc_space *space, const pdmc_scalar_kernel *kernel, const pdmc_form_rule *rule,
                                 int threads, pdmc_assembly *assembly)
{
    pdmc_status status = PDMC_OK;
    pdmc_assembly made = {.space = space, .threads = threads};
    *assembly = (pdmc_assembly){0};
    PDMC_REQUIRE(kernel->dimension == space->mesh->dimension, "a kernel of %d dimensions for a mesh of %d",
                 kernel->dimension, space->mesh->dimension);
    PDMC_TRY(pdmc_pair_rule_create(kernel, rule, &made.rule));
    PDMC_TRY(pdmc_neighbours_create(space->mesh, kernel->horizon, &made.neighbours));
    PDMC_TRY(allocate(&made));
    *assembly = made;
    made = (pdmc_assembly){0};
done:
    pdmc_assembly_clear(&made);
    return status;
}

void pdmc_assembly_clear(pdmc_assembly *assembly)
{
    pdmc_pair_rule_clear(&assembly->rule);
    pdmc_neighbours_clear(&assembly->neighbours);
    pdmc_free(assembly->elements);
    pdmc_free(assembly->blocks);
    *assembly = (pdmc_assembly){0};
}
