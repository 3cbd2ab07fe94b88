// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What two results have in common, and how far they are apart there: what the table, the JSON and the pictures of a
/// comparison show.

#include "views/views_impl.h"

enum { PDMC_COMPARED = 2, PDMC_METHOD_SIZE = 64 };

/// An energy at a tip and an angle that both results have.
typedef struct {
    double angle;                    // rad
    size_t place[PDMC_COMPARED];     // in the arrays [T, A] of each
    pdmc_estimate difference, ratio; // of the means, second - first and second / first
    pdmc_distances distances;
    pdmc_pairs pairs;   // none where the samples are not pairs
    int largest_sample; // that of the largest relative difference
} pdmc_compared_angle;

/// A tip that both results have.
typedef struct {
    int number[PDMC_COMPARED]; // in each
    int angle_count;           // 0 where the energies there were not asked for
    pdmc_compared_angle *angles;
} pdmc_compared_tip;

struct pdmc_comparison {
    const pdmc_results *results[PDMC_COMPARED];
    char *labels[PDMC_COMPARED];
    char method[PDMC_COMPARED][PDMC_METHOD_SIZE]; // "kansa, analytic"; "" where the file does not tell
    pdmc_measure measure;
    bool paired;                       // sample i of both is drawn with the same random numbers
    bool same_load, same_micromodulus; // of pairs: whether these are the same in every sample
    int tip_count;
    pdmc_compared_tip *tips; // [tip_count]
    char *notes;
};

/// What a tip is called.
const char *pdmc_compared_name(const pdmc_comparison *c, const pdmc_compared_tip *tip);

/// The samples whose energies are compared, the first of those of a file: all that it keeps, of pairs what both keep.
int pdmc_compared_samples(const pdmc_comparison *c, int which);

/// The nominal energy of the measure of the comparison, with the bonds that its samples count.
double pdmc_compared_nominal(const pdmc_comparison *c, const pdmc_compared_angle *angle, int which);

/// The Griffith energy straight ahead at the mean; its error is that of K, by G ~ K_I^2 + K_II^2.
/// @param[out] value, error  NaN without angles
void pdmc_compared_griffith(const pdmc_comparison *c, const pdmc_compared_tip *tip, int which, double *value,
                            double *error);

/// The angle that the largest share of samples prefers, an index; -1 without angles.
int pdmc_compared_direction(const pdmc_comparison *c, const pdmc_compared_tip *tip, int which);
