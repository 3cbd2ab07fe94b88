// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/near.h"
#include "stochastic/reduced_impl.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

static pdmc_status copy_sparse(const pdmc_crossing *full, const int number[], pdmc_crossing *reduced)
{
    pdmc_status status = PDMC_OK;
    const size_t values = (size_t)full->bonds * PDMC_BOND_ENDS;
    PDMC_NEW(reduced->row, values);
    PDMC_NEW(reduced->column, values);
    for (size_t k = 0; k < values; k++) {
        reduced->row[k] = full->row[k];
        reduced->column[k] = number[full->column[k]];
    }
done:
    return status;
}

// Rows in the coordinates of the space.
static pdmc_status reduce_all(const pdmc_reduced_builder *b, int rows, const double row[], double reduced[])
{
    const int n = b->n, r = b->system->dimension;
    if (rows > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rows, r, n, 1.0, row, n, b->basis, n, 0.0, reduced, r);
    return pdmc_reduced_turn(b, rows, reduced);
}

// As they are where they look at what is observed.
static pdmc_status reduce_rows(const pdmc_reduced_builder *b, const pdmc_crossing *full, pdmc_crossing *reduced)
{
    pdmc_status status = PDMC_OK;
    const int observed = b->full->observed, width = observed > 0 ? observed : b->system->dimension;
    PDMC_NEW(reduced->row, (size_t)full->bonds * (size_t)width);
    if (observed > 0) memcpy(reduced->row, full->row, (size_t)full->bonds * (size_t)width * sizeof *full->row);
    else PDMC_TRY(reduce_all(b, full->bonds, full->row, reduced->row));
done:
    return status;
}

static pdmc_status reduce_crossing(const pdmc_reduced_builder *b, const pdmc_crossing *full, const int number[],
                                   pdmc_crossing *reduced)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(reduced->ring, full->bonds);
    reduced->bonds = full->bonds;
    for (int k = 0; k < full->bonds; k++) reduced->ring[k] = full->ring[k];
    PDMC_TRY(full->column ? copy_sparse(full, number, reduced) : reduce_rows(b, full, reduced));
done:
    return status;
}

// What the crossings of the full model observe, in the coordinates of the space.
static pdmc_status reduce_observed(const pdmc_reduced_builder *b, const int number[], pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, r = b->system->dimension;
    PDMC_NEW(reduced->observe, (size_t)reduced->observed * (size_t)r);
    if (b->full->observed > 0) return reduce_all(b, reduced->observed, b->full->observe, reduced->observe);
    for (int k = 0; k < n; k++)
        for (int j = 0; j < r && number[k] >= 0; j++)
            reduced->observe[(size_t)number[k] * (size_t)r + (size_t)j] = b->basis[(size_t)j * (size_t)n + (size_t)k];
    PDMC_TRY(pdmc_reduced_turn(b, reduced->observed, reduced->observe));
done:
    return status;
}

static pdmc_status reduce_crossings(const pdmc_reduced_builder *b, pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *full = b->full;
    const int directions = full->tips * full->angles;
    int *number = NULL;
    PDMC_NEW(number, full->unknowns);
    PDMC_NEW(reduced->crossings, directions);
    reduced->observed = full->observed > 0 ? full->observed : pdmc_near_number(full, number);
    PDMC_TRY(reduce_observed(b, number, reduced));
    for (int d = 0; d < directions; d++)
        PDMC_TRY(reduce_crossing(b, &full->crossings[d], number, &reduced->crossings[d]));
done:
    pdmc_free(number);
    return status;
}

// The coordinates of an answer at the mean are those of its load; nothing is prescribed but zero.
static pdmc_status reduce_vectors(const pdmc_reduced_builder *b, pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const pdmc_reduced_system *system = b->system;
    const int r = system->dimension;
    reduced->unknowns = r;
    PDMC_NEW(reduced->solution, reduced->cases * r);
    PDMC_NEW(reduced->stress_intensity, 2 * reduced->tips * r);
    for (int l = 1; l < reduced->cases; l++) {
        const int load = l == 1 ? 0 : system->sides + l - 2;
        memcpy(&reduced->solution[l * r], &system->load[load * PDMC_REDUCED_CAPACITY], (size_t)r * sizeof(double));
    }
    PDMC_TRY(reduce_all(b, 2 * reduced->tips, b->full->stress_intensity, reduced->stress_intensity));
done:
    return status;
}

// The norms of the stress intensities' rows in the energy of K_0^-1.
static pdmc_status bound_intensities(pdmc_reduced_builder *b, pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *full = b->full;
    const int n = b->n, rows = 2 * full->tips;
    PDMC_NEW(reduced->intensity_bound, rows);
    for (int first = 0; first < rows; first += B) {
        const int count = rows - first < B ? rows - first : B;
        const double *row = &full->stress_intensity[(size_t)first * (size_t)n];
        PDMC_TRY(full->verbs->precondition(full, count, row, b->product));
        for (int k = 0; k < count; k++)
            reduced->intensity_bound[first + k] =
                sqrt(cblas_ddot(n, &row[(size_t)k * (size_t)n], 1, &b->product[(size_t)k * (size_t)n], 1));
    }
done:
    return status;
}

pdmc_status pdmc_reduced_create(const pdmc_variables *variables, const pdmc_reduced_goal *goal, int threads,
                                pdmc_affine *reduced)
{
    static const pdmc_affine_verbs verbs = {.destroy = pdmc_reduced_system_destroy};
    pdmc_status status = PDMC_OK;
    const pdmc_affine *full = variables->model;
    pdmc_reduced_builder b = {.variables = variables, .full = full, .threads = threads, .n = full->unknowns};
    *reduced = (pdmc_affine){0};
    PDMC_TRY(pdmc_reduced_builder_create(goal, &b));
    PDMC_TRY(pdmc_reduced_build(goal, &b));
    // Draws take their weights from the full model.
    *reduced = (pdmc_affine){.cases = full->cases,
                             .terms = full->terms,
                             .radial_terms = full->radial_terms,
                             .rings = full->rings,
                             .tips = full->tips,
                             .angles = full->angles,
                             .micromodulus = full->micromodulus,
                             .crossing_bound = full->crossing_bound,
                             .verbs = &verbs};
    PDMC_TRY(reduce_vectors(&b, reduced));
    PDMC_TRY(reduce_crossings(&b, reduced));
    PDMC_TRY(bound_intensities(&b, reduced));
    reduced->discretisation = b.system;
    b.system = NULL;
done:
    pdmc_reduced_builder_clear(&b);
    if (status != PDMC_OK) pdmc_affine_clear(reduced);
    return status;
}

// |row . e| by the errors of the adjoint problems where there are some, and by the rows' norms.
static void bound_rows(const pdmc_affine *reduced, int sides, const double error[], double alpha, double bound[])
{
    for (int k = 0; k < 2 * reduced->tips; k++) {
        bound[k] = error[0] * reduced->intensity_bound[k] / sqrt(alpha);
        if (sides > 1) bound[k] = fmin(bound[k], error[0] * error[1 + k]);
        if (!isfinite(error[0])) bound[k] = INFINITY;
    }
}

pdmc_status pdmc_reduced_solve(const pdmc_affine *reduced, const double xi[], const double share[], double x[],
                               pdmc_reduced_bound *bound)
{
    pdmc_status status = PDMC_OK;
    const pdmc_reduced_system *system = reduced->discretisation;
    const int r = system->dimension, sides = system->sides;
    double *y = NULL, *error = NULL;
    PDMC_NEW(y, B * sides * r);
    PDMC_NEW(error, B * sides);
    PDMC_TRY(pdmc_reduced_system_solve(system, xi, share, y, error, bound->coercivity));
    for (int s = 0; s < B; s++) {
        memcpy(&x[s * r], &y[s * sides * r], (size_t)r * sizeof *x);
        bound->error[s] = error[s * sides];
        bound_rows(reduced, sides, &error[s * sides], bound->coercivity[s], &bound->intensity[s * 2 * reduced->tips]);
    }
done:
    pdmc_free(y);
    pdmc_free(error);
    return status;
}
