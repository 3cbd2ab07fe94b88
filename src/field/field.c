// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "base/base_impl.h"
#include "field/directions.h"
#include "field/field_impl.h"
#include "field/karhunen_loeve.h"
#include "field/lognormal.h"
#include "pdmc/random.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

/// What the terms of a lognormal field may leave out, in parts of its deviation.
static const double EXPANSION_ERROR = 1e-3;

/// Pairs of which the modes after the functionals' directions are composed; twice as many add less than 2e-5 to the variance.
static int pairs_of(int modes, int functionals)
{
    return functionals > 0 ? 2 * modes : modes;
}

enum { ERROR_SAMPLES = 256, ERROR_POINTS = 256 }; // with which the expansion's error is measured

struct pdmc_field {
    int modes;
    double size[2];
    pdmc_functions terms;     // psi
    pdmc_lognormal lognormal; // zero of a normal field, whose coefficients are z
    double retained, expansion_error;
};

static pdmc_status check_functionals(int functionals, const pdmc_field_functional functional[], const double size[2])
{
    for (int i = 0; i < functionals; i++) {
        PDMC_REQUIRE(functional[i].points >= 1, "functional %d has no points", i);
        for (int j = 0; j < functional[i].points; j++)
            PDMC_REQUIRE(isfinite(functional[i].weight[j]), "functional %d has a weight of %g", i,
                         functional[i].weight[j]);
        const pdmc_status status = pdmc_field_check_points(size, functional[i].points, functional[i].x);
        if (status) return status;
    }
    return PDMC_OK;
}

static pdmc_status check(const pdmc_field_request *request, const double size[2], int functionals,
                         const pdmc_field_functional functional[], int threads)
{
    const bool lognormal = request->distribution == PDMC_LOGNORMAL;
    PDMC_REQUIRE(lognormal || request->distribution == PDMC_NORMAL, "a field is normal or lognormal, not of kind %d",
                 (int)request->distribution);
    PDMC_REQUIRE(isfinite(request->variation) && request->variation >= 0.0, "a coefficient of variation of %g",
                 request->variation);
    PDMC_REQUIRE(!lognormal || request->variation > 0.0, "a lognormal field without variation");
    PDMC_REQUIRE(request->modes >= 1, "%d modes", request->modes);
    PDMC_REQUIRE(functionals >= 0 && functionals <= request->modes, "%d functionals with %d modes", functionals,
                 request->modes);
    for (int d = 0; d < 2; d++)
        PDMC_REQUIRE(isfinite(size[d]) && size[d] > 0.0, "a rectangle of %g by %g", size[0], size[1]);
    PDMC_REQUIRE(threads >= 1, "%d threads", threads);
    const pdmc_status status = pdmc_covariance_check(&request->covariance);
    return status ? status : check_functionals(functionals, functional, size);
}

/// The mean over the rectangle of the variance of the normal field.
static pdmc_status measure_retained(const pdmc_functions *normal, int threads, double *retained)
{
    pdmc_status status = PDMC_OK;
    const double area = normal->space.size[0] * normal->space.size[1];
    pdmc_area_rule rule = {0};
    double *value = NULL;
    PDMC_TRY(pdmc_polynomials_rule(&normal->space, &rule));
    PDMC_NEW(value, (size_t)rule.count * (size_t)normal->count);
    PDMC_TRY(pdmc_functions_at(normal, rule.count, rule.x, threads, value));
    *retained = 0.0;
    for (int i = 0; i < rule.count; i++) {
        const double *row = &value[(size_t)i * (size_t)normal->count];
        *retained += rule.weight[i] / area * cblas_ddot(normal->count, row, 1, row, 1);
    }
done:
    pdmc_free(value);
    pdmc_area_rule_clear(&rule);
    return status;
}

/// Samples z [ERROR_SAMPLES, modes] and points [ERROR_POINTS, 2], spread evenly, which no study draws.
static void draw(const pdmc_field *field, double z[], double x[])
{
    const uint64_t far = UINT64_C(1) << 63;
    const size_t modes = (size_t)field->modes;
    for (size_t s = 0; s < ERROR_SAMPLES; s++) {
        pdmc_random_uniform(0, PDMC_STREAM_FIELD, far + s, 0, modes, &z[s * modes]);
        for (size_t k = 0; k < modes; k++) z[s * modes + k] = pdmc_normal_quantile(z[s * modes + k]);
    }
    for (size_t i = 0; i < ERROR_POINTS; i++) {
        pdmc_random_uniform(0, PDMC_STREAM_FIELD, far + ERROR_SAMPLES + i, 0, 2, &x[2 * i]);
        for (size_t d = 0; d < 2; d++) x[2 * i + d] = field->size[d] * (x[2 * i + d] - 0.5);
    }
}

/// The exponential of the normal field at the points less its expansion, squared and averaged; `normal` and `term` hold psi
/// of either at the points.
static double mean_square(const pdmc_field *field, double scale, const double z[], const double xi[],
                          const double normal[], const double term[])
{
    const int modes = field->modes, terms = field->terms.count;
    double sum = 0.0;
    for (int s = 0; s < ERROR_SAMPLES; s++)
        for (int i = 0; i < ERROR_POINTS; i++) {
            const double *psi = &normal[i * modes];
            const double variance = scale * scale * cblas_ddot(modes, psi, 1, psi, 1);
            const double exact = expm1(scale * cblas_ddot(modes, &z[s * modes], 1, psi, 1) - 0.5 * variance);
            const double left = exact - cblas_ddot(terms, &xi[s * terms], 1, &term[i * terms], 1);
            sum += left * left / ((double)ERROR_SAMPLES * ERROR_POINTS);
        }
    return sum;
}

static pdmc_status measure_expansion_error(const pdmc_functions *normal, double variation, pdmc_field *field)
{
    pdmc_status status = PDMC_OK;
    double *z = NULL, *x = NULL, *xi = NULL, *normal_at = NULL, *term_at = NULL;
    PDMC_NEW(z, ERROR_SAMPLES * field->modes);
    PDMC_NEW(x, 2 * ERROR_POINTS);
    PDMC_NEW(xi, ERROR_SAMPLES * field->terms.count);
    PDMC_NEW(normal_at, ERROR_POINTS * field->modes);
    PDMC_NEW(term_at, ERROR_POINTS * field->terms.count);
    draw(field, z, x);
    PDMC_TRY(pdmc_field_coefficients(field, ERROR_SAMPLES, z, xi));
    PDMC_TRY(pdmc_functions_at(normal, ERROR_POINTS, x, 1, normal_at));
    PDMC_TRY(pdmc_functions_at(&field->terms, ERROR_POINTS, x, 1, term_at));
    field->expansion_error = sqrt(mean_square(field, sqrt(log1p(variation * variation)), z, xi, normal_at, term_at));
done:
    pdmc_free(term_at);
    pdmc_free(normal_at);
    pdmc_free(xi);
    pdmc_free(x);
    pdmc_free(z);
    return status;
}

/// psi of a normal field: the functions of variance 1 times the coefficient of variation.
static void scale_functions(double variation, pdmc_functions *functions)
{
    const size_t count = (size_t)functions->count, n = (size_t)pdmc_polynomials_count(&functions->space);
    for (size_t i = 0; i < count * n; i++) functions->coefficient[i] *= variation;
    for (size_t i = 0; i < count * (size_t)functions->directions; i++) functions->mix[i] *= variation;
}

pdmc_status pdmc_field_create(const pdmc_field_request *request, double width, double height, int functionals,
                              const pdmc_field_functional functional[], int threads, pdmc_field **field)
{
    pdmc_status status = check(request, (double[]){width, height}, functionals, functional, threads);
    if (status) return status;
    const int modes = request->modes;
    pdmc_karhunen_loeve pairs = {0};
    pdmc_functions normal = {0};
    pdmc_field *created = NULL;
    pdmc_blas_prepare();
    PDMC_NEW(created, 1);
    *created = (pdmc_field){.modes = modes, .size = {width, height}};
    PDMC_TRY(pdmc_karhunen_loeve_create(&request->covariance, width, height, modes, pairs_of(modes, functionals),
                                        threads, &pairs));
    PDMC_TRY(pdmc_directions_create(&pairs, &request->covariance, modes, functionals, functional, threads, &normal));
    PDMC_TRY(measure_retained(&normal, threads, &created->retained));
    if (request->distribution == PDMC_LOGNORMAL) {
        PDMC_TRY(pdmc_lognormal_create(&normal, request->variation, EXPANSION_ERROR * request->variation, threads,
                                       &created->terms, &created->lognormal));
        PDMC_TRY(measure_expansion_error(&normal, request->variation, created));
    } else {
        scale_functions(request->variation, &normal);
        created->terms = normal;
        normal = (pdmc_functions){0};
    }
    *field = created;
    created = NULL;
done:
    pdmc_field_destroy(&created);
    pdmc_functions_clear(&normal);
    pdmc_karhunen_loeve_clear(&pairs);
    return status;
}

void pdmc_field_destroy(pdmc_field **field)
{
    if (!*field) return;
    pdmc_functions_clear(&(*field)->terms);
    pdmc_lognormal_clear(&(*field)->lognormal);
    pdmc_free(*field);
    *field = NULL;
}

int pdmc_field_modes(const pdmc_field *field)
{
    return field->modes;
}

int pdmc_field_terms(const pdmc_field *field)
{
    return field->terms.count;
}

double pdmc_field_retained(const pdmc_field *field)
{
    return field->retained;
}

double pdmc_field_expansion_error(const pdmc_field *field)
{
    return field->expansion_error;
}

pdmc_status pdmc_field_terms_at(const pdmc_field *field, int points, const double x[], double value[])
{
    const pdmc_status status = pdmc_field_check_points(field->size, points, x);
    return status ? status : pdmc_functions_at(&field->terms, points, x, 1, value);
}

pdmc_status pdmc_field_coefficients(const pdmc_field *field, int count, const double z[], double xi[])
{
    if (field->lognormal.terms > 0) return pdmc_lognormal_coefficients(&field->lognormal, count, z, xi);
    memcpy(xi, z, sizeof *xi * (size_t)count * (size_t)field->modes);
    return PDMC_OK;
}
