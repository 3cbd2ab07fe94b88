// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/explicit.h"

#include <math.h>

double pdmc_of_tip(const pdmc_explicit_record *record, const double values[], int at, int tip)
{
    return values[(size_t)at * (size_t)record->tip_count + (size_t)tip];
}

const double *pdmc_of_sphere(const pdmc_explicit_record *record, const double values[], int at, int sphere)
{
    return &values[3 * ((size_t)at * (size_t)record->sphere_count + (size_t)sphere)];
}

const double *pdmc_of_condition(const pdmc_explicit_record *record, const double values[], int at, int condition)
{
    return &values[3 * ((size_t)at * (size_t)record->condition_count + (size_t)condition)];
}

double pdmc_of_interface(const pdmc_explicit_record *record, const double values[], int at, int interface)
{
    return values[(size_t)at * (size_t)record->interface_count + (size_t)interface];
}

double pdmc_explicit_balance_error(const pdmc_explicit_record *r)
{
    double error = 0.0, largest = 0.0;
    for (int i = 0; i < r->record_count; i++) {
        const double become = r->kinetic[i] + r->elastic[i] + r->fracture[i] + r->contact[i] + r->dissipated[i];
        error = fmax(error, fabs(r->first + r->work[i] - become));
        largest = fmax(largest, become);
    }
    return largest > 0.0 ? error / largest : NAN;
}

double pdmc_explicit_force_error(const pdmc_explicit_record *r)
{
    double error = 0.0;
    for (int i = 0; i < r->compared_count; i++) error = fmax(error, r->force_error[i]);
    return error;
}

bool pdmc_is_at_rest(const pdmc_explicit_record *record)
{
    return record->residual != NULL;
}

double pdmc_norm_of(const double x[PDMC_AXES])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

size_t pdmc_last_state(const pdmc_explicit_record *record)
{
    return record->snapshot_count > 0 ? (size_t)(record->snapshot_count - 1) * (size_t)record->node_count : 0;
}
