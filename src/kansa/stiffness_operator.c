// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/stiffness_operator.h"

#include "base/base_impl.h"
#include "kansa/weak_rows.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// The points are worked on by panels, and the panels in LANES runs whose sums are added in their order: the same for any
// number of threads.
enum { B = PDMC_BLOCK, PANEL = 128, LANES = 8, STRAINS = PDMC_STRAIN_ROWS };

typedef struct {
    const pdmc_kansa_form *form;
    double *psi; // [points, terms]
} stiffness_operator;

typedef struct {
    int first, count; // points
} panel;

static const stiffness_operator *operator_of(const pdmc_affine *model)
{
    return model->discretisation;
}

static int panels_of(const pdmc_kansa_form *form)
{
    return (form->points + PANEL - 1) / PANEL;
}

static panel panel_at(const pdmc_kansa_form *form, int index)
{
    const int first = index * PANEL;
    return (panel){first, form->points - first < PANEL ? form->points - first : PANEL};
}

// M - 1 at the points of a panel in each column, [points, columns].
static void deviations(const stiffness_operator *operator, int terms, panel at, int columns, const double xi[],
                       double deviation[])
{
    memset(deviation, 0, (size_t)(at.count * columns) * sizeof *deviation);
    if (terms > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, at.count, columns, terms, 1.0,
                    &operator->psi[(size_t)at.first * (size_t)terms], terms, xi, terms, 0.0, deviation, columns);
}

// sum += strain' (M - 1) strain x over the points of a panel; room: [PANEL, 1 + STRAINS, B]
static void multiply_panel(const pdmc_affine *model, panel at, const double xi[], const double x[], double room[],
                           double sum[])
{
    const stiffness_operator *operator= operator_of(model);
    const int n = model->unknowns;
    double *deviation = room, *strain = room + PANEL * B;
    deviations(operator, model->terms, at, B, xi, deviation);
    pdmc_kansa_form_strains(operator->form, at.first, at.count, B, x, strain);
    for (int k = 0; k < STRAINS * at.count; k++)
        for (int s = 0; s < B; s++) strain[k * B + s] *= deviation[k / STRAINS * B + s];
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, B, n, STRAINS * at.count, 1.0, strain, B,
                &operator->form->strain[STRAINS * (size_t)at.first * (size_t)n], n, 1.0, sum, n);
}

static pdmc_status multiply_lane(const pdmc_affine *model, int lane, const double xi[], const double x[], double sum[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_kansa_form *form = operator_of(model)->form;
    const int panels = panels_of(form);
    double *room = NULL;
    PDMC_NEW(room, PANEL * (1 + STRAINS) * B);
    for (int p = lane * panels / LANES; p < (lane + 1) * panels / LANES; p++)
        multiply_panel(model, panel_at(form, p), xi, x, room, sum);
done:
    pdmc_free(room);
    return status;
}

static pdmc_status multiply(const pdmc_affine *model, double mean, const double xi[], const double x[], double y[])
{
    pdmc_status status = PDMC_OK;
    const size_t values = (size_t)B * (size_t)model->unknowns;
    double *sum = NULL;
    PDMC_NEW(sum, LANES * values);
#pragma omp parallel for schedule(dynamic) num_threads(operator_of(model)->form->kansa->threads)
    for (int lane = 0; lane < LANES; lane++) {
        const pdmc_status mine = multiply_lane(model, lane, xi, x, &sum[(size_t)lane * values]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_stiffness_multiply)
            status = mine;
        }
    }
    for (size_t k = 0; k < values; k++) y[k] = mean * x[k];
    for (int lane = 0; lane < LANES; lane++) cblas_daxpy((int)values, 1.0, &sum[(size_t)lane * values], 1, y, 1);
done:
    pdmc_free(sum);
    return status;
}

static pdmc_status perturb(const pdmc_affine *model, const double xi[], const double x[], double y[])
{
    return multiply(model, 0.0, xi, x, y);
}

// K_0 is the identity.
static pdmc_status precondition(const pdmc_affine *model, int count, const double r[], double z[])
{
    memcpy(z, r, (size_t)count * (size_t)model->unknowns * sizeof *z);
    return PDMC_OK;
}

static pdmc_status color(const pdmc_affine *model, const double g[], double z[])
{
    return precondition(model, B, g, z);
}

// The lower triangle of K += rows' weighted, by panels of columns.
static void add_products(const pdmc_kansa_form *form, int count, const double rows[], const double weighted[],
                         double K[])
{
    enum { COLUMNS = 64 };
    const int n = form->unknowns;
#pragma omp parallel for schedule(dynamic) num_threads(form->kansa->threads)
    for (int first = 0; first < n; first += COLUMNS)
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, n - first, n - first < COLUMNS ? n - first : COLUMNS,
                    count, 1.0, rows + first, n, weighted + first, n, 1.0, &K[(size_t)first * (size_t)(n + 1)], n);
}

// K = 1 + strain' (M - 1) strain
static pdmc_status assemble(const pdmc_affine *model, const double xi[], double K[])
{
    pdmc_status status = PDMC_OK;
    const stiffness_operator *operator= operator_of(model);
    const size_t n = (size_t)model->unknowns;
    double *weighted = NULL, deviation[PANEL];
    PDMC_NEW(weighted, PANEL * STRAINS * n);
    for (size_t k = 0; k < n; k++) K[k * (n + 1)] = 1.0;
    for (int p = 0; p < panels_of(operator->form); p++) {
        const panel at = panel_at(operator->form, p);
        const double *strain = &operator->form->strain[STRAINS * (size_t)at.first * n];
        deviations(operator, model->terms, at, 1, xi, deviation);
        for (int k = 0; k < STRAINS * at.count; k++)
            for (size_t i = 0; i < n; i++)
                weighted[(size_t)k * n + i] = deviation[k / STRAINS] * strain[(size_t)k * n + i];
        add_products(operator->form, STRAINS * at.count, strain, weighted, K);
    }
done:
    pdmc_free(weighted);
    return status;
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const int n = model->unknowns;
    double *K = NULL;
    PDMC_NEW(K, (size_t)n * (size_t)n);
    PDMC_TRY(assemble(model, xi, K));
    cblas_dgemv(CblasRowMajor, CblasTrans, model->cases, n, 1.0, model->solution, n, scale, 1, 0.0, x, 1);
    const int info = LAPACKE_dposv(LAPACK_COL_MAJOR, 'L', n, 1, K, n, x, n);
    if (info > 0) PDMC_FAIL(PDMC_ERR_SINGULAR, "the sample's stiffness is not positive definite");
    if (info < 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dposv returned %d", info);
done:
    pdmc_free(K);
    return status;
}

// The strains of some vectors at all points, [points, STRAINS, count].
static void all_strains(const pdmc_kansa_form *form, int count, const double v[], double strain[])
{
#pragma omp parallel for schedule(dynamic) num_threads(form->kansa->threads)
    for (int p = 0; p < panels_of(form); p++) {
        const panel at = panel_at(form, p);
        pdmc_kansa_form_strains(form, at.first, at.count, count, v,
                                &strain[STRAINS * (size_t)at.first * (size_t)count]);
    }
}

// Row i of every term's matrix: sum over the points of psi times the energy of u_i with each v_j. energy: [PANEL, v_count]
static void project_one(const pdmc_affine *model, int i, int u_count, const double u[], int v_count, const double v[],
                        double energy[], double out[])
{
    const stiffness_operator *operator= operator_of(model);
    const int terms = model->terms;
    for (int p = 0; p < panels_of(operator->form); p++) {
        const panel at = panel_at(operator->form, p);
        memset(energy, 0, (size_t)(at.count * v_count) * sizeof *energy);
        for (int k = 0; k < STRAINS * at.count; k++) {
            const size_t row = STRAINS * (size_t)at.first + (size_t)k;
            cblas_daxpy(v_count, u[row * (size_t)u_count + (size_t)i], &v[row * (size_t)v_count], 1,
                        &energy[k / STRAINS * v_count], 1);
        }
        cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, terms, v_count, at.count, 1.0,
                    &operator->psi[(size_t)at.first * (size_t)terms], terms, energy, v_count, p > 0 ? 1.0 : 0.0,
                    &out[(size_t)i * (size_t)v_count], u_count * v_count);
    }
}

static pdmc_status project(const pdmc_affine *model, int u_count, const double u[], int v_count, const double v[],
                           double out[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_kansa_form *form = operator_of(model)->form;
    const size_t rows = STRAINS * (size_t)form->points;
    double *u_strain = NULL, *v_strain = NULL;
    PDMC_NEW(u_strain, rows * (size_t)u_count);
    PDMC_NEW(v_strain, rows * (size_t)v_count);
    all_strains(form, u_count, u, u_strain);
    all_strains(form, v_count, v, v_strain);
#pragma omp parallel for schedule(dynamic) num_threads(form->kansa->threads)
    for (int i = 0; i < u_count; i++) {
        double *energy = pdmc_calloc((size_t)(PANEL * v_count), sizeof *energy);
        if (energy) {
            project_one(model, i, u_count, u_strain, v_count, v_strain, energy, out);
        } else {
#pragma omp critical(pdmc_stiffness_project)
            status = PDMC_ERR_NOMEM;
        }
        pdmc_free(energy);
    }
done:
    pdmc_free(u_strain);
    pdmc_free(v_strain);
    return status;
}

// K(xi) - alpha K_0 is a sum over the points of M - alpha times squares, and 1 - alpha times what does not scale.
static pdmc_status coercivity(const pdmc_affine *model, const double xi[], double alpha[B])
{
    pdmc_status status = PDMC_OK;
    const stiffness_operator *operator= operator_of(model);
    double *deviation = NULL;
    PDMC_NEW(deviation, PANEL * B);
    for (int s = 0; s < B; s++) alpha[s] = 1.0;
    for (int p = 0; p < panels_of(operator->form); p++) {
        const panel at = panel_at(operator->form, p);
        deviations(operator, model->terms, at, B, xi, deviation);
        for (int k = 0; k < at.count; k++)
            for (int s = 0; s < B; s++) alpha[s] = fmin(alpha[s], 1.0 + deviation[k * B + s]);
    }
done:
    pdmc_free(deviation);
    return status;
}

static void destroy(void *discretisation)
{
    stiffness_operator *operator= discretisation;
    pdmc_free(operator->psi);
    pdmc_free(operator);
}

pdmc_status pdmc_stiffness_operator_create(const pdmc_kansa_form *form, const pdmc_stiffness_terms *terms,
                                           pdmc_affine *model)
{
    static const pdmc_affine_verbs verbs = {.perturb = perturb,
                                            .solve = solve,
                                            .multiply = multiply,
                                            .precondition = precondition,
                                            .color = color,
                                            .project = project,
                                            .coercivity = coercivity,
                                            .destroy = destroy};
    pdmc_status status = PDMC_OK;
    stiffness_operator *made = NULL;
    PDMC_NEW(made, 1);
    model->discretisation = made;
    model->verbs = &verbs;
    model->unknowns = form->unknowns;
    model->terms = terms->terms;
    made->form = form;
    PDMC_NEW(made->psi, (size_t)form->points * (size_t)terms->terms);
    PDMC_TRY(terms->at(terms->context, form->points, form->x, made->psi));
done:
    return status;
}
