// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A comparison of the rules for integrals over the horizon on one problem whose answer is known. Plain data in the
/// study's own units; see pdmc/horizon.h for the rules.

#include "pdmc/horizon.h"

typedef enum { PDMC_INTEGRAL_VOLUME, PDMC_INTEGRAL_STRESS } pdmc_integral;
typedef enum { PDMC_BOND_STRETCH_FULL, PDMC_BOND_STRETCH_LINEAR } pdmc_bond_stretch;
enum { PDMC_STRESS_COMPONENTS = 6 }; // xx, yy, zz, yz, zx, xy

typedef struct {
    pdmc_integral integral;
    int dimension;              // 2, in plane stress, or 3
    double horizon;             // length
    int ratio_count;            // a study that was read has two at least
    double *ratios;             // [ratio_count] horizon / spacing
    double accuracy, threshold; // of the adaptive rule
    int start, most;
    int extrapolates;                                      // 0 or 1
    double youngs_modulus, stress[PDMC_STRESS_COMPONENTS]; // force / length^2, of an infinite body
    pdmc_profile profile;
    pdmc_bond_stretch stretch;
} pdmc_horizon_study;

/// Frees what the study owns and sets it to zero; a zeroed one is allowed.
PDMC_API void pdmc_horizon_study_clear(pdmc_horizon_study *study);

/// The rules that are compared, by name: cubic cells, Gauss points 2, 3 and 4 a side, exact volumes, and the adaptive
/// rule.
enum { PDMC_HORIZON_RULES = 6 };
PDMC_API extern const char *const pdmc_horizon_rule_names[PDMC_HORIZON_RULES];

/// How a rule is made for one of the spacings.
PDMC_API pdmc_horizon_options pdmc_horizon_study_options(const pdmc_horizon_study *study, int rule, double ratio);

/// What a rule gives at one spacing.
typedef struct {
    double error;     // of the volume, over it; or the largest of a component of the stress, over the largest component
    double points;    // of the horizon, or of the half of it beyond a plane (eq. 2.52 and 2.56)
    double distance;  // average between these points, length
    double stress[9]; // NaN of a volume
} pdmc_horizon_outcome;

/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_horizon_study_measure(const pdmc_horizon_study *study, int rule, double ratio,
                                                               pdmc_horizon_outcome *outcome);

/// The stress of the infinite body, [3, 3].
PDMC_API void pdmc_horizon_study_stress(const pdmc_horizon_study *study, double stress[9]);
