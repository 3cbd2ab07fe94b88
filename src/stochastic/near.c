// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/near.h"

#include "base/base_impl.h"

enum { B = PDMC_BLOCK };

static int width_of(const pdmc_affine *model)
{
    return model->observed > 0 ? model->observed : model->unknowns;
}

int pdmc_near_number(const pdmc_affine *model, int place[])
{
    int count = 0;
    for (int k = 0; k < width_of(model); k++) place[k] = -1;
    for (int d = 0; d < model->tips * model->angles; d++) {
        const pdmc_crossing *crossing = &model->crossings[d];
        for (int k = 0; crossing->column && k < crossing->bonds * PDMC_BOND_ENDS; k++)
            if (place[crossing->column[k]] < 0) place[crossing->column[k]] = count++;
    }
    return count;
}

pdmc_status pdmc_near_create(const pdmc_affine *model, pdmc_near *near)
{
    pdmc_status status = PDMC_OK;
    *near = (pdmc_near){0};
    PDMC_NEW(near->place, width_of(model));
    near->count = pdmc_near_number(model, near->place);
    PDMC_NEW(near->unknown, near->count);
    PDMC_NEW(near->value, near->count * B);
    for (int k = 0; k < width_of(model); k++)
        if (near->place[k] >= 0) near->unknown[near->place[k]] = k;
done:
    return status;
}

void pdmc_near_clear(pdmc_near *near)
{
    pdmc_free(near->place);
    pdmc_free(near->unknown);
    pdmc_free(near->value);
    *near = (pdmc_near){0};
}

void pdmc_near_take(pdmc_near *near, int width, const double y[])
{
    for (int k = 0; k < near->count; k++)
        for (size_t s = 0; s < B; s++) near->value[(size_t)k * B + s] = y[s * (size_t)width + (size_t)near->unknown[k]];
}

void pdmc_near_stretch(const pdmc_near *near, const pdmc_crossing *crossing, double stretch[])
{
    for (int b = 0; b < crossing->bonds; b++) {
        const double *row = &crossing->row[b * PDMC_BOND_ENDS], *end[PDMC_BOND_ENDS];
        for (int k = 0; k < PDMC_BOND_ENDS; k++)
            end[k] = &near->value[near->place[crossing->column[b * PDMC_BOND_ENDS + k]] * B];
        for (int s = 0; s < B; s++)
            stretch[b * B + s] = row[0] * end[0][s] + row[1] * end[1][s] + row[2] * end[2][s] + row[3] * end[3][s];
    }
}
