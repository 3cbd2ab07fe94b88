// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/load_cases.h"

#include "base/base_impl.h"

static const pdmc_uncertainty *of_side(const pdmc_problem *problem, pdmc_quantity first, int side)
{
    return pdmc_problem_uncertainty(problem, (pdmc_quantity)((int)first + side));
}

static bool is_upright(pdmc_side side)
{
    return side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT;
}

static int noise_modes(const pdmc_problem *problem, int side)
{
    const pdmc_uncertainty *noise = of_side(problem, PDMC_QUANTITY_LOAD_NOISE_LEFT, side);
    return noise ? noise->modes : 0;
}

// Appends the cases of one side; list may be NULL.
static int add_side(const pdmc_problem *problem, int side, int count, pdmc_load_case list[])
{
    const bool is_turned = of_side(problem, PDMC_QUANTITY_LOAD_DIRECTION_LEFT, side) != NULL;
    const bool is_scaled = is_turned || of_side(problem, PDMC_QUANTITY_LOAD_LEFT, side) != NULL;
    const int uniform = is_scaled + is_turned, modes = noise_modes(problem, side);
    for (int k = 0; list && k < uniform; k++)
        list[count + k] = (pdmc_load_case){k ? PDMC_LOAD_TURNED : PDMC_LOAD_SIDE, (pdmc_side)side, 0};
    for (int k = 0; list && k < modes; k++)
        list[count + uniform + k] = (pdmc_load_case){PDMC_LOAD_NOISE, (pdmc_side)side, k};
    return count + uniform + modes;
}

static int add_all(const pdmc_problem *problem, pdmc_load_case list[])
{
    int count = 1;
    if (list) list[0] = (pdmc_load_case){.kind = PDMC_LOAD_GIVEN};
    for (int side = 0; side < PDMC_SIDES; side++) count = add_side(problem, side, count, list);
    return count;
}

int pdmc_load_case_count(const pdmc_problem *problem)
{
    return add_all(problem, NULL);
}

void pdmc_load_case_list(const pdmc_problem *problem, pdmc_load_case list[])
{
    add_all(problem, list);
}

pdmc_status pdmc_load_cases_create(const pdmc_problem *problem, pdmc_load_cases *cases)
{
    pdmc_status status = PDMC_OK;
    *cases = (pdmc_load_cases){.problem = problem, .count = pdmc_load_case_count(problem)};
    PDMC_NEW(cases->list, cases->count);
    pdmc_load_case_list(problem, cases->list);
    for (int side = 0; side < PDMC_SIDES; side++) {
        const pdmc_uncertainty *noise = of_side(problem, PDMC_QUANTITY_LOAD_NOISE_LEFT, side);
        const double length = is_upright((pdmc_side)side) ? problem->plate.height : problem->plate.width;
        if (noise)
            PDMC_TRY(
                pdmc_process_create(&noise->covariance, length, noise->variation, noise->modes, &cases->noise[side]));
    }
done:
    if (status != PDMC_OK) pdmc_load_cases_clear(cases);
    return status;
}

void pdmc_load_cases_clear(pdmc_load_cases *cases)
{
    pdmc_free(cases->list);
    for (int side = 0; side < PDMC_SIDES; side++) pdmc_process_destroy(&cases->noise[side]);
    *cases = (pdmc_load_cases){0};
}

void pdmc_load_traction(const pdmc_load_cases *cases, int index, pdmc_side side, const double x[2], double traction[2])
{
    const pdmc_problem *problem = cases->problem;
    const pdmc_load_case *own = &cases->list[index];
    double t[2] = {0.0, 0.0};
    for (int l = 0; l < problem->load_count; l++)
        for (int k = 0; k < 2; k++)
            if (problem->loads[l].side == side) t[k] += problem->loads[l].traction[k];
    const bool is_here = own->kind == PDMC_LOAD_GIVEN || own->side == side, is_turned = own->kind == PDMC_LOAD_TURNED;
    double factor = is_here ? 1.0 : 0.0;
    if (is_here && own->kind == PDMC_LOAD_NOISE)
        factor = pdmc_process_mode(cases->noise[side], own->mode, x[is_upright(side)]);
    traction[0] = factor * (is_turned ? -t[1] : t[0]);
    traction[1] = factor * (is_turned ? t[0] : t[1]);
}
