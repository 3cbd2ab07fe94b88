// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The layout of a result file: one table of arrays and one of attributes, from which it is written, read and freed.

#include "pdmc/results.h"

typedef enum { PDMC_KIND_REAL, PDMC_KIND_INT, PDMC_KIND_INT64, PDMC_KIND_BYTE, PDMC_KIND_NAME } pdmc_kind;

/// What an axis of an array counts. The sizes of the first ones are fields of the results, the others are fixed.
typedef enum {
    PDMC_DIM_END, // ends a list of axes
    PDMC_DIM_CRACK,
    PDMC_DIM_TIP,
    PDMC_DIM_ANGLE,
    PDMC_DIM_SAMPLE,
    PDMC_DIM_KEPT,
    PDMC_DIM_RADIAL_BIN,
    PDMC_DIM_NODE,
    PDMC_DIM_FACE_POINT,
    PDMC_DIM_EDGE,
    PDMC_DIM_BIN,
    PDMC_DIM_BIN_AND_OUTSIDE,
    PDMC_DIM_TIME,
    PDMC_DIM_PROBE,
    PDMC_DIM_METHOD,
    PDMC_DIM_GROUP,
    PDMC_DIM_VARIABLE,
    PDMC_DIM_RECORD,
    PDMC_DIM_COMPARED,
    PDMC_DIM_FOLLOWED_TIP,
    PDMC_DIM_SPHERE,
    PDMC_DIM_CONDITION,
    PDMC_DIM_INTERFACE,
    PDMC_DIM_BODY,
    PDMC_DIM_PARTICLE,
    PDMC_DIM_SNAPSHOT,
    PDMC_DIM_STATE,
    PDMC_DIM_FRAGMENT,
    PDMC_DIM_DRAW,
    PDMC_DIM_DRAWN_TIP,
    PDMC_DIM_DRAWN_CONDITION,
    PDMC_DIM_STATION,
    PDMC_DIM_OUTCOME,
    PDMC_DIM_LEVEL,
    PDMC_DIM_VALUE,
    PDMC_DIM_SOLID_NODE,
    PDMC_DIM_LINE,
    PDMC_DIM_SOLID_FACE,
    PDMC_DIM_STEP,
    PDMC_DIM_RULE,
    PDMC_DIM_RATIO,
    PDMC_DIM_STRESS_STATE,
    PDMC_DIM_CONTROLLED_TIP,
    PDMC_DIM_QUANTILE,
    PDMC_DIM_COORDINATE,
    PDMC_DIM_AXIS,
    PDMC_DIM_END_POINT,
    PDMC_DIM_MODE,
    PDMC_DIM_FACE,
    PDMC_DIM_BOUND,
} pdmc_dimension;

enum { PDMC_MAX_RANK = 4 };

/// One dataset of the file: a whole array of the results, or one column of an array of structures.
typedef struct {
    const char *path, *description;
    pdmc_kind kind;
    pdmc_unit unit;
    size_t member; // offset in the results: of the array's pointer, or of the number itself
    size_t stride; // bytes from one structure of the array to the next; 0 for a number that is no array
    size_t column; // offset of the column in the structure
    size_t width;  // numbers of the column in one structure
    pdmc_dimension axes[PDMC_MAX_RANK + 1];
} pdmc_dataset;

typedef enum {
    PDMC_ATTRIBUTE_TEXT,
    PDMC_ATTRIBUTE_DOCUMENT, // a text too long for an attribute, and so a dataset
    PDMC_ATTRIBUTE_REAL,
    PDMC_ATTRIBUTE_INT,
    PDMC_ATTRIBUTE_SEED,
    PDMC_ATTRIBUTE_CHOICE,
} pdmc_attribute_kind;

/// One attribute of the file that is a field of the results.
typedef struct {
    const char *object, *name;
    pdmc_attribute_kind kind;
    size_t member;              // offset in the results
    const char *const *choices; // of a choice: the name of each value of the enumeration
    int choice_count;
} pdmc_attribute;

extern const pdmc_dataset pdmc_datasets[];
extern const size_t pdmc_dataset_count;
extern const pdmc_attribute pdmc_attributes[];
extern const size_t pdmc_attribute_count;

const char *pdmc_dimension_label(pdmc_dimension dimension);

/// The field that counts this axis, or NULL where its size is fixed; the axis is longer than the field by `*more`.
int *pdmc_dimension_field(pdmc_results *results, pdmc_dimension dimension, int *more);

/// Size of an axis.
size_t pdmc_dimension_size(const pdmc_results *results, pdmc_dimension dimension);

/// Whether the file of these results has the dataset, or the attribute: only a dynamic study has a motion, and an explicit
/// or a scalar one has nothing of a plate.
bool pdmc_dataset_belongs(const pdmc_results *results, const pdmc_dataset *dataset);
bool pdmc_attribute_belongs(const pdmc_results *results, const pdmc_attribute *attribute);

/// Whether files of an earlier minor version are without this number, which is then NaN.
bool pdmc_dataset_may_be_missing(const pdmc_dataset *dataset);

/// The same of a text, which is then "".
bool pdmc_attribute_may_be_missing(const pdmc_attribute *attribute);

size_t pdmc_dataset_rank(const pdmc_dataset *dataset);

/// How many numbers a dataset holds.
size_t pdmc_dataset_size(const pdmc_results *results, const pdmc_dataset *dataset);

/// Bytes of one number in memory.
size_t pdmc_kind_size(pdmc_kind kind);

/// Whether the numbers lie in memory as in the file, without gaps.
bool pdmc_dataset_is_packed(const pdmc_dataset *dataset);

/// Where the first structure of a dataset is; NULL where the array is missing.
void *pdmc_dataset_memory(const pdmc_results *results, const pdmc_dataset *dataset);

/// Lets the results own an array; for datasets that are arrays.
void pdmc_dataset_set_memory(pdmc_results *results, const pdmc_dataset *dataset, void *memory);

/// Copies a column between its structures and packed numbers.
void pdmc_dataset_gather(const pdmc_dataset *dataset, size_t size, const void *structures, void *packed);
void pdmc_dataset_scatter(const pdmc_dataset *dataset, size_t size, const void *packed, void *structures);

/// A text of the results by its attribute; NULL where the attribute is no text.
char **pdmc_attribute_text(pdmc_results *results, const pdmc_attribute *attribute);

/// Whether the counts, names and choices are possible and agree with one another. A failure has the status `code`.
pdmc_status pdmc_results_check(const pdmc_results *results, pdmc_status code);
