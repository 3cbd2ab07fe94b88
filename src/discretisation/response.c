// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/response.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { MOST_DIRECTIONS = 1000 };

// State of the collection; vectors are stored one after another, [count, unknowns].
typedef struct {
    const pdmc_response_operator *operator;
    double negligible; // size of a direction that is left out
    int capacity;      // of directions, and of candidates
    double *fresh;     // [capacity, unknowns] directions of the last generation, times their size
    double *next;      // [capacity, unknowns] those of the next one, so far
    double *found;     // [capacity, unknowns] candidates
    double *overlap;   // [capacity, capacity]
    double *tau;       // [capacity]
    int *pivot;        // [capacity]
} collection;

static pdmc_status collection_create(const pdmc_response_operator *operator, int starts, collection *c)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t) operator->unknowns;
    *c = (collection){.operator= operator, .negligible = operator->tolerance * operator->norm };
    c->capacity = operator->unknowns<MOST_DIRECTIONS ? operator->unknowns : MOST_DIRECTIONS;
    if (c->capacity < starts) c->capacity = starts;
    if (c->capacity < operator->terms) c->capacity = operator->terms;
    PDMC_NEW(c->fresh, (size_t)c->capacity * n);
    PDMC_NEW(c->next, (size_t)c->capacity * n);
    PDMC_NEW(c->found, (size_t)c->capacity * n);
    PDMC_NEW(c->overlap, (size_t)c->capacity * (size_t)c->capacity);
    PDMC_NEW(c->tau, c->capacity);
    PDMC_NEW(c->pivot, c->capacity);
done:
    return status;
}

static void collection_clear(collection *c)
{
    pdmc_free(c->fresh);
    pdmc_free(c->next);
    pdmc_free(c->found);
    pdmc_free(c->overlap);
    pdmc_free(c->tau);
    pdmc_free(c->pivot);
}

// v -= basis^T basis v
static void project_out(collection *c, const pdmc_response *response, int count, double v[])
{
    const int n = c->operator->unknowns, r = response->dimension;
    if (r == 0 || count == 0) return;
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, r, count, n, 1.0, response->basis, n, v, n, 0.0, c->overlap,
                r);
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, count, r, -1.0, response->basis, n, c->overlap, r, 1.0, v,
                n);
}

// Adds the directions of `count` candidates in c->found that are new, and leaves them, with their size, in c->next behind
// the `waiting` ones that are there.
static pdmc_status append(collection *c, pdmc_response *response, int count, int waiting, int *added)
{
    const int n = c->operator->unknowns, width = count < n ? count : n;
    for (int pass = 0; pass < 2; pass++) project_out(c, response, count, c->found); // twice is enough (Kahan)
    memset(c->pivot, 0, (size_t)count * sizeof *c->pivot);
    int info = LAPACKE_dgeqp3(LAPACK_COL_MAJOR, n, count, c->found, n, c->pivot, c->tau);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dgeqp3 returned %d", info);
    *added = 0;
    double *size = c->overlap;
    while (*added < width && response->dimension + *added < c->capacity) {
        size[*added] = fabs(c->found[(size_t)*added * (size_t)(n + 1)]);
        if (!(size[*added] > c->negligible)) break;
        ++*added;
    }
    if (*added == 0) return PDMC_OK;
    info = LAPACKE_dorgqr(LAPACK_COL_MAJOR, n, *added, *added, c->found, n, c->tau);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dorgqr returned %d", info);
    const size_t values = (size_t)*added * (size_t)n;
    memcpy(&response->basis[(size_t)response->dimension * (size_t)n], c->found, values * sizeof(double));
    double *next = &c->next[(size_t)waiting * (size_t)n];
    memcpy(next, c->found, values * sizeof(double));
    for (int k = 0; k < *added; k++) cblas_dscal(n, size[k], &next[(size_t)k * (size_t)n], 1);
    response->dimension += *added;
    return PDMC_OK;
}

// Appends what is new in the images of `count` directions under every operator.
static pdmc_status append_images(collection *c, pdmc_response *response, int count, const double direction[],
                                 int waiting, int *added)
{
    const pdmc_response_operator *operator= c->operator;
    const size_t n = (size_t) operator->unknowns;
    for (int q = 0; q < operator->terms; q++) {
        double *out = &c->found[(size_t)(q * count) * n];
        const pdmc_status status = operator->apply(operator->context, q, count, direction, out);
        if (status != PDMC_OK) return status;
        cblas_dscal(count * (int)n, operator->size[q], out, 1);
    }
    return append(c, response, count * operator->terms, waiting, added);
}

static void turn_generation(collection *c)
{
    double *last = c->fresh;
    c->fresh = c->next;
    c->next = last;
}

// The next generation, from the `count` directions of the last one.
static pdmc_status extend(collection *c, pdmc_response *response, int count, int *added)
{
    const int n = c->operator->unknowns, most = c->capacity / c->operator->terms; // whose images there is room for
    *added = 0;
    turn_generation(c);
    for (int first = 0; first < count && response->dimension < n; first += most) {
        const int batch = count - first < most ? count - first : most;
        int found;
        const pdmc_status status =
            append_images(c, response, batch, &c->fresh[(size_t)first * (size_t)n], *added, &found);
        if (status != PDMC_OK) return status;
        *added += found;
        if (response->dimension == c->capacity && c->capacity < n)
            return pdmc_raise(PDMC_ERR_SINGULAR,
                              "the answers to the uncertain micromodulus span more than %d directions: take a smaller "
                              "variation",
                              response->dimension);
    }
    return PDMC_OK;
}

static pdmc_status fill_images(collection *c, pdmc_response *response)
{
    pdmc_status status = PDMC_OK;
    const pdmc_response_operator *operator= c->operator;
    const int n = operator->unknowns, r = response->dimension;
    PDMC_NEW(response->image, (size_t) operator->terms *(size_t) r * (size_t)r);
    for (int q = 0; q < operator->terms; q++) {
        PDMC_TRY(operator->apply(operator->context, q, r, response->basis, c->found));
        cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, r, r, n, 1.0, response->basis, n, c->found, n, 0.0,
                    &response->image[(size_t)q * (size_t)r * (size_t)r], r);
    }
done:
    return status;
}

pdmc_status pdmc_response_create(const pdmc_response_operator *operator, int starts, double start[],
                                 pdmc_response *response)
{
    pdmc_status status = PDMC_OK;
    collection c = {0};
    int added;
    *response = (pdmc_response){0};
    PDMC_TRY(collection_create(operator, starts, &c));
    PDMC_NEW(response->basis, (size_t)c.capacity * (size_t) operator->unknowns);
    memcpy(c.found, start, (size_t)starts * (size_t) operator->unknowns * sizeof * start);
    PDMC_TRY(append(&c, response, starts, 0, &added));
    while (added > 0 && operator->terms> 0) PDMC_TRY(extend(&c, response, added, &added));
    PDMC_TRY(fill_images(&c, response));
done:
    collection_clear(&c);
    if (status != PDMC_OK) pdmc_response_clear(response);
    return status;
}

void pdmc_response_clear(pdmc_response *response)
{
    pdmc_free(response->basis);
    pdmc_free(response->image);
    *response = (pdmc_response){0};
}

pdmc_status pdmc_response_perturb(const pdmc_response *response, int terms, int count, const double xi[],
                                  const double x[], double y[])
{
    pdmc_status status = PDMC_OK;
    const int r = response->dimension;
    double *stack = NULL; // [count, terms, dimension]
    PDMC_NEW(stack, count * terms * r);
    for (int s = 0; s < count; s++)
        for (int q = 0; q < terms; q++) cblas_daxpy(r, xi[s * terms + q], &x[s * r], 1, &stack[(s * terms + q) * r], 1);
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, r, count, terms * r, 1.0, response->image, r, stack,
                terms * r, 0.0, y, r);
done:
    pdmc_free(stack);
    return status;
}
