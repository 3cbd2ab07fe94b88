// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the objects of JSON are made of. Whatever is NULL for want of memory makes the object that takes it fail, and
/// with it the whole.

#include "views/views_impl.h"

#include <jansson.h>

/// Sets a key; an object without it becomes NULL.
void pdmc_json_put(json_t **object, const char *key, json_t *value);

/// Adds to an array, which without it becomes NULL.
void pdmc_json_append(json_t **array, json_t *value);

/// JSON has no NaN and no infinity: these are null.
json_t *pdmc_json_number(double x);
json_t *pdmc_json_numbers(size_t count, const double x[]);

/// A text that is not UTF-8 loses what is not ASCII.
json_t *pdmc_json_text(const char *bytes);

/// JSON's integers are signed; a seed beyond them is written as text rather than changed.
json_t *pdmc_json_seed(uint64_t seed);

/// Value, lower and upper.
json_t *pdmc_json_estimate(const pdmc_estimate *estimate);

/// What was found of rare growth.
json_t *pdmc_json_reliability(const pdmc_reliability_results *reliability);

/// What an explicit study has recorded.
json_t *pdmc_json_explicit(const pdmc_explicit_record *record);

/// ... and what its samples say.
json_t *pdmc_json_ensemble(const pdmc_results *r);
/// The rest of an elastic study.
json_t *pdmc_json_elastic(const pdmc_elastic_record *record);

/// The levels of a scalar study.
json_t *pdmc_json_scalar(const pdmc_scalar_record *record);
/// What a study of quadrature has measured.
json_t *pdmc_json_quadrature(const pdmc_quadrature_record *record);

/// Seconds, threads and memory.
json_t *pdmc_json_runtime(const pdmc_runtime *t);

/// What the numbers are measured in.
json_t *pdmc_json_units(const pdmc_results *r);

/// Prints an object on one line and frees it; NULL is what memory did not reach for.
pdmc_status pdmc_json_print(json_t *object, FILE *stream);
