// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "base/base_impl.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { CELLS = 32 }; // a direction

struct pdmc_field {
    pdmc_field_request request;
    double *node;   // [CELLS^2, 2]
    double *factor; // [CELLS^2, modes] from covariances with the nodes to psi
};

static double covariance_of(const pdmc_field *field, const double x[2], const double y[2])
{
    return pdmc_covariance_at(&field->request.covariance, hypot(x[0] - y[0], x[1] - y[1]));
}

static pdmc_status decompose(pdmc_field *field, double area)
{
    pdmc_status status = PDMC_OK;
    const int nodes = CELLS * CELLS, modes = field->request.modes;
    double *matrix = NULL, *value = NULL;
    PDMC_NEW(matrix, nodes * nodes);
    PDMC_NEW(value, nodes);
    for (int i = 0; i < nodes; i++)
        for (int j = 0; j < nodes; j++)
            matrix[i * nodes + j] = covariance_of(field, &field->node[2 * i], &field->node[2 * j]);
    const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', nodes, matrix, nodes, value);
    if (info) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyevd returned %d", info);
    (void)area;
    for (int k = 0; k < modes; k++) {
        const double *vector = &matrix[(nodes - 1 - k) * nodes], lambda = value[nodes - 1 - k];
        for (int i = 0; i < nodes; i++)
            field->factor[i * modes + k] = lambda > 0.0 ? field->request.variation * vector[i] / sqrt(lambda) : 0.0;
    }
done:
    pdmc_free(matrix);
    pdmc_free(value);
    return status;
}

pdmc_status pdmc_field_create(const pdmc_field_request *request, double width, double height, int functionals,
                              const pdmc_field_functional functional[], int threads, pdmc_field **field)
{
    PDMC_REQUIRE(request->distribution == PDMC_NORMAL, "no lognormal fields yet");
    PDMC_REQUIRE(request->modes >= 1 && request->modes <= CELLS * CELLS, "modes = %d", request->modes);
    pdmc_status status = PDMC_OK;
    pdmc_field *created = NULL;
    (void)functionals, (void)functional, (void)threads;
    PDMC_NEW(created, 1);
    created->request = *request;
    PDMC_NEW(created->node, 2 * CELLS * CELLS);
    PDMC_NEW(created->factor, CELLS * CELLS * request->modes);
    for (int i = 0; i < CELLS * CELLS; i++) {
        created->node[2 * i] = width * ((i % CELLS + 0.5) / CELLS - 0.5);
        created->node[2 * i + 1] = height * ((i / CELLS + 0.5) / CELLS - 0.5);
    }
    PDMC_TRY(decompose(created, width * height));
    *field = created;
    created = NULL;
done:
    pdmc_field_destroy(&created);
    return status;
}

void pdmc_field_destroy(pdmc_field **field)
{
    if (!*field) return;
    pdmc_free((*field)->node);
    pdmc_free((*field)->factor);
    pdmc_free(*field);
    *field = NULL;
}

int pdmc_field_modes(const pdmc_field *field)
{
    return field->request.modes;
}

int pdmc_field_terms(const pdmc_field *field)
{
    return field->request.modes;
}

double pdmc_field_retained(const pdmc_field *field)
{
    (void)field;
    return NAN;
}

double pdmc_field_expansion_error(const pdmc_field *field)
{
    (void)field;
    return 0.0;
}

pdmc_status pdmc_field_terms_at(const pdmc_field *field, int points, const double x[], double value[])
{
    const int modes = field->request.modes;
    memset(value, 0, sizeof *value * (size_t)points * (size_t)modes);
    for (int i = 0; i < points; i++)
        for (int j = 0; j < CELLS * CELLS; j++) {
            const double covariance = covariance_of(field, &x[2 * i], &field->node[2 * j]);
            for (int k = 0; k < modes; k++) value[i * modes + k] += covariance * field->factor[j * modes + k];
        }
    return PDMC_OK;
}

pdmc_status pdmc_field_coefficients(const pdmc_field *field, int count, const double z[], double xi[])
{
    memcpy(xi, z, sizeof *xi * (size_t)count * (size_t)field->request.modes);
    return PDMC_OK;
}
