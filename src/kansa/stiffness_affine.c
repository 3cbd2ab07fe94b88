// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "kansa/stiffness_operator.h"
#include "kansa/weights.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

static pdmc_status copy_vectors(const pdmc_kansa_form *form, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)form->unknowns, values = 2 * (size_t)model->tips * n;
    model->cases = form->kansa->cases;
    PDMC_NEW(model->solution, (size_t)model->cases * n);
    memcpy(model->solution, form->fixed, n * sizeof(double));
    memcpy(&model->solution[n], form->load, (size_t)form->kansa->loads.count * n * sizeof(double));
    PDMC_NEW(model->stress_intensity, values);
    memcpy(model->stress_intensity, form->intensity, values * sizeof(double));
done:
    return status;
}

static const double *tip_position(const pdmc_problem *problem, int t)
{
    const pdmc_crack *crack = &problem->cracks[problem->energy.tips[t] / 2];
    return problem->energy.tips[t] % 2 ? crack->to : crack->from;
}

// Where the energy's bonds cross; no bond does outside the plate.
static void crossing_point(const pdmc_problem *problem, int t, int angle, double x[2])
{
    const double phi = 2.0 * M_PI * angle / problem->energy.angles, *tip = tip_position(problem, t);
    const double half[2] = {0.5 * problem->plate.width, 0.5 * problem->plate.height};
    const double direction[2] = {cos(phi), sin(phi)};
    for (int k = 0; k < 2; k++) x[k] = fmin(fmax(tip[k] + problem->energy.extension * direction[k], -half[k]), half[k]);
}

static pdmc_status fill_stiffness(const pdmc_problem *problem, const pdmc_stiffness_terms *terms, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int tips = model->tips, directions = tips * model->angles;
    double *x = NULL;
    PDMC_NEW(x, 2 * (tips + directions));
    PDMC_NEW(model->tip_stiffness, tips * terms->terms);
    PDMC_NEW(model->direction_stiffness, directions * terms->terms);
    for (int t = 0; t < tips; t++) memcpy(&x[2 * t], tip_position(problem, t), 2 * sizeof *x);
    for (int d = 0; d < directions; d++)
        crossing_point(problem, d / model->angles, d % model->angles, &x[2 * (tips + d)]);
    PDMC_TRY(terms->at(terms->context, tips, x, model->tip_stiffness));
    PDMC_TRY(terms->at(terms->context, directions, &x[2 * tips], model->direction_stiffness));
done:
    pdmc_free(x);
    return status;
}

pdmc_status pdmc_kansa_form_affine(const pdmc_kansa_form *form, const pdmc_stiffness_terms *terms, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    const pdmc_energy_request *energy = &form->kansa->problem->energy;
    *model = (pdmc_affine){.tips = energy->tip_count, .angles = energy->angles, .bins = form->kansa->rings.bins};
    PDMC_TRY(pdmc_stiffness_operator_create(form, terms, model));
    PDMC_TRY(pdmc_kansa_weights(form->kansa, model));
    PDMC_TRY(copy_vectors(form, model));
    PDMC_TRY(fill_stiffness(form->kansa->problem, terms, model));
    const double made = pdmc_seconds();
    PDMC_TRY(pdmc_kansa_form_crossings(form, model));
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}

static pdmc_status field_at(const void *context, int points, const double x[], double value[])
{
    return pdmc_field_terms_at(context, points, x, value);
}

pdmc_stiffness_terms pdmc_stiffness_terms_of(const pdmc_field *field)
{
    return (pdmc_stiffness_terms){pdmc_field_terms(field), field, field_at};
}

pdmc_status pdmc_kansa_field_affine(const pdmc_kansa_form *form, const pdmc_field *field, pdmc_affine *model)
{
    const pdmc_stiffness_terms terms = pdmc_stiffness_terms_of(field);
    const pdmc_status status = pdmc_kansa_form_affine(form, &terms, model);
    if (status == PDMC_OK) model->field = field;
    return status;
}
