// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "visible/point.h"

#include <gsl/gsl_math.h>
#include <math.h>

pdmc_solver_report pdmc_visible_report(const pdmc_visible *visible)
{
    const int size = visible->unknowns + visible->motions;
    return (pdmc_solver_report){
        .nodes = visible->nodes.count,
        .unknowns = size,
        .rows = size,
        .rank = size,
        .condition = 1.0 / visible->factor.reciprocal_condition,
        .residual = visible->residual,
        .horizon = visible->problem->solver.horizon,
        .spacing = visible->nodes.finest,
    };
}

void pdmc_visible_runtime(const pdmc_visible *visible, double *assembly, double *factorisation)
{
    *assembly = visible->assembly_seconds;
    *factorisation = visible->factorisation_seconds;
}

static pdmc_status mean_at(pdmc_disc_sum *sum, const double x[2], const double anchor[2], double u[2])
{
    const pdmc_visible *visible = sum->visible;
    const pdmc_view view = pdmc_view_at(&visible->cuts, x, anchor);
    pdmc_block_row row;
    const pdmc_status status = pdmc_visible_point(sum, &view, &row, u);
    if (status == PDMC_OK) pdmc_block_row_apply(&row, visible->mean, u);
    pdmc_block_row_clear(&row);
    return status;
}

pdmc_status pdmc_visible_displacement(const pdmc_visible *visible, const double x[2], const double anchor[2],
                                      double u[2])
{
    pdmc_disc_sum sum;
    pdmc_status status = pdmc_disc_sum_create(visible, 1, true, &sum);
    if (status == PDMC_OK) status = mean_at(&sum, x, anchor, u);
    pdmc_disc_sum_clear(&sum);
    return status;
}

enum { FACE_POINTS = 101 };

static pdmc_status fill_face(pdmc_disc_sum *sum, int c, pdmc_displacement_field *field)
{
    const pdmc_cut *cut = &sum->visible->cuts.cut[c];
    const double middle = 0.5 * (cut->low + cut->high), a = 0.5 * (cut->high - cut->low);
    for (int i = 0; i < FACE_POINTS; i++) {
        // a tip itself has two values
        const double along = middle - a * cos(M_PI * i / (FACE_POINTS - 1)) * (1.0 - 1e-6);
        const size_t at = (size_t)(c * FACE_POINTS + i);
        double *x = &field->face_position[2 * at];
        pdmc_cut_global(cut, along, 0.0, x);
        for (int face = 0; face < 2; face++) {
            double anchor[2];
            pdmc_cut_global(cut, along, (face == 0 ? 1e-3 : -1e-3) * a, anchor);
            const pdmc_status status = mean_at(sum, x, anchor, &field->face_displacement[4 * at + 2 * (size_t)face]);
            if (status != PDMC_OK) return status;
        }
    }
    return PDMC_OK;
}

// The nodes of the plate, without ghosts.
static void fill_nodes(const pdmc_visible *visible, pdmc_displacement_field *field)
{
    for (int i = 0; i < visible->nodes.count; i++) {
        const pdmc_visible_node *node = &visible->nodes.node[i];
        if (node->edge >= 0) continue;
        for (int k = 0; k < 2; k++) {
            field->node_position[2 * field->node_count + k] = node->view.x[k];
            field->node_displacement[2 * field->node_count + k] = visible->mean[2 * i + k];
        }
        field->node_count++;
    }
}

pdmc_status pdmc_visible_field(const pdmc_visible *visible, pdmc_displacement_field *field)
{
    pdmc_status status = PDMC_OK;
    const int cracks = visible->cuts.count;
    pdmc_disc_sum sum = {0};
    *field = (pdmc_displacement_field){.face_points = FACE_POINTS};
    PDMC_TRY(pdmc_disc_sum_create(visible, 1, true, &sum));
    PDMC_NEW(field->node_position, visible->unknowns);
    PDMC_NEW(field->node_displacement, visible->unknowns);
    PDMC_NEW(field->face_position, 2 * FACE_POINTS * cracks);
    PDMC_NEW(field->face_displacement, 4 * FACE_POINTS * cracks);
    fill_nodes(visible, field);
    for (int c = 0; c < cracks; c++) PDMC_TRY(fill_face(&sum, c, field));
done:
    pdmc_disc_sum_clear(&sum);
    if (status != PDMC_OK) {
        pdmc_free(field->node_position);
        pdmc_free(field->node_displacement);
        pdmc_free(field->face_position);
        pdmc_free(field->face_displacement);
        *field = (pdmc_displacement_field){0};
    }
    return status;
}
