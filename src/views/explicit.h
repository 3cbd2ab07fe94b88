// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the views of an explicit study share: figures that are read off its records.

#include "views/views_impl.h"

/// A tip's advance or speed, a sphere's centre or velocity, a condition's force or displacement, in an array [N, count] or
/// [N, count, 3]; the broken bonds of an interface.
double pdmc_of_tip(const pdmc_explicit_record *record, const double values[], int at, int tip);
const double *pdmc_of_sphere(const pdmc_explicit_record *record, const double values[], int at, int sphere);
const double *pdmc_of_condition(const pdmc_explicit_record *record, const double values[], int at, int condition);
double pdmc_of_interface(const pdmc_explicit_record *record, const double values[], int at, int interface);

/// The largest difference between what came in, first + work, and what it has become, over the largest of the latter;
/// NaN without either.
double pdmc_explicit_balance_error(const pdmc_explicit_record *record);

/// The largest of the differences that single precision makes. @param[in] record  of a study in single precision
double pdmc_explicit_force_error(const pdmc_explicit_record *record);

/// Whether the records are of states of rest, and their times of loads.
bool pdmc_is_at_rest(const pdmc_explicit_record *record);

/// The norm of three numbers.
double pdmc_norm_of(const double x[PDMC_AXES]);

/// The number of the first node of the last snapshot in the arrays of states.
size_t pdmc_last_state(const pdmc_explicit_record *record);
