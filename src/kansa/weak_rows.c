// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/weak_rows.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum { PANEL = 64 }; // rows or columns of a task, the same for any number of threads

// Three rows whose squares add to sigma : epsilon = (3 s_x^2 - 2 s_x s_y + 3 s_y^2) / (8 mu) + tau^2 / mu (lambda =
// mu).
static void strain_rows(pdmc_row_builder *builder, const double x[2], double weight, double scratch[], double row[])
{
    const int n = builder->basis->unknowns;
    const double mu = builder->basis->shear_modulus, along[2] = {1.0, 0.0}, across[2] = {0.0, 1.0};
    const double a = sqrt(3.0 * weight / (8.0 * mu)), b = sqrt(weight / (3.0 * mu)), c = sqrt(weight / mu);
    double *sx = row, *tau = row + 2 * n, *sy = row + n;
    pdmc_traction_rows(builder, x, x, along, sx, tau);
    pdmc_traction_rows(builder, x, x, across, scratch, sy);
    for (int k = 0; k < n; k++) {
        sx[k] = a * (sx[k] - sy[k] / 3.0);
        sy[k] *= b;
        tau[k] *= c;
    }
}

static void displacement_rows(pdmc_row_builder *builder, const double x[2], double weight, double row[])
{
    const int n = builder->basis->unknowns;
    pdmc_displacement_rows(builder, x, x, row, row + n);
    cblas_dscal(2 * n, sqrt(weight), row, 1);
}

void pdmc_weak_add_gram(const pdmc_kansa *kansa, int count, const double rows[], double gram[])
{
    const int n = kansa->unknowns;
#pragma omp parallel for schedule(dynamic) num_threads(kansa->threads)
    for (int first = 0; first < n; first += PANEL)
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, n, n - first < PANEL ? n - first : PANEL, count, 1.0, rows,
                    n, rows + first, n, 1.0, &gram[(size_t)first * (size_t)n], n);
}

static void whiten(const pdmc_kansa *kansa, int count, double rows[])
{
#pragma omp parallel for schedule(dynamic) num_threads(kansa->threads)
    for (int first = 0; first < count; first += PANEL)
        pdmc_kansa_whiten(kansa, count - first < PANEL ? count - first : PANEL,
                          &rows[(size_t)first * (size_t)kansa->unknowns]);
}

static pdmc_status fill_rows(const pdmc_kansa *kansa, const pdmc_area_rule *rule, int first, int count, double strain[],
                             double displacement[])
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
#pragma omp parallel num_threads(kansa->threads)
    {
        pdmc_row_builder builder;
        double *scratch = pdmc_calloc(n, sizeof *scratch);
        pdmc_status mine = pdmc_row_builder_create(&kansa->basis, &builder);
        if (!scratch) mine = PDMC_ERR_NOMEM;
#pragma omp for schedule(dynamic, 8)
        for (int i = 0; i < count; i++) {
            if (mine != PDMC_OK) continue;
            const double *x = &rule->x[2 * (first + i)], weight = rule->weight[first + i];
            strain_rows(&builder, x, weight, scratch, &strain[PDMC_STRAIN_ROWS * (size_t)i * n]);
            if (displacement)
                displacement_rows(&builder, x, weight, &displacement[PDMC_DISPLACEMENT_ROWS * (size_t)i * n]);
        }
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_weak_form)
            status = mine;
        }
        pdmc_row_builder_clear(&builder);
        pdmc_free(scratch);
    }
    return status;
}

pdmc_status pdmc_weak_fill_rows(const pdmc_kansa *kansa, const pdmc_area_rule *rule, int first, int count,
                                double strain[], double displacement[])
{
    const pdmc_status status = fill_rows(kansa, rule, first, count, strain, displacement);
    if (status != PDMC_OK) return status;
    whiten(kansa, PDMC_STRAIN_ROWS * count, strain);
    if (displacement) whiten(kansa, PDMC_DISPLACEMENT_ROWS * count, displacement);
    return PDMC_OK;
}

pdmc_status pdmc_weak_rule(const pdmc_kansa *kansa, pdmc_area_rule *rule)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = kansa->problem;
    double *segment = NULL;
    PDMC_NEW(segment, 4 * problem->crack_count);
    for (int c = 0; c < problem->crack_count; c++) {
        memcpy(&segment[4 * c], problem->cracks[c].from, 2 * sizeof(double));
        memcpy(&segment[4 * c + 2], problem->cracks[c].to, 2 * sizeof(double));
    }
    // Sums of radial functions vary from node to node, whatever their shape: about seven points to a node. A quarter
    // of that leaves fields without energy, and waves that stand still.
    PDMC_TRY(pdmc_area_rule_create(problem->plate.width, problem->plate.height, problem->crack_count, segment,
                                   3.0 * kansa->spacing, rule));
done:
    pdmc_free(segment);
    return status;
}
