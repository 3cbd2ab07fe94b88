// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the views share.

#include "pdmc/views.h"

#include <locale.h>

static const double pdmc_degrees = 57.295779513082320877; // in a radian

/// What people call a measure: "bond", "Griffith".
const char *pdmc_measure_title(pdmc_measure measure);

/// The index of the angle nearest to `angle`, whole turns apart; -1 where there are no angles.
int pdmc_nearest_angle(const pdmc_results *results, double angle);

/// Where the numbers of a tip at an angle are in an array [T, A].
size_t pdmc_place(const pdmc_results *results, int tip, int angle);

/// An angle in degrees, in (centre - 180, centre + 180].
double pdmc_degrees_around(double angle, double centre);

/// The largest difference between work and the energies that it has become, over the largest work; NaN without work.
double pdmc_balance_error(const pdmc_motion_record *motion);

/// What people call a face of a crack: "none", "left", "right".
const char *pdmc_face_name(int face);

/// The displacement of a probe, [2].
const double *pdmc_probe_displacement(const pdmc_motion_record *motion, int time, int probe);

/// Numbers with a decimal point whatever the program's locale, until pdmc_locale_restore().
typedef struct {
    locale_t plain, before;
} pdmc_locale;
pdmc_status pdmc_locale_plain(pdmc_locale *locale);
void pdmc_locale_restore(pdmc_locale *locale);

/// Makes a folder unless it is there.
pdmc_status pdmc_folder_make(const char *folder);

/// "<folder>/<name>"; free with pdmc_free(), NULL without memory.
char *pdmc_folder_path(const char *folder, const char *name);
