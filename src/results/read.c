// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "results/h5.h"
#include "results/identity.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/// Sizes an axis by the first dataset that has it; the others must agree.
static pdmc_status read_axis(pdmc_results *results, bool known[], const pdmc_dataset *dataset, size_t i, hsize_t extent)
{
    const pdmc_dimension axis = dataset->axes[i];
    int more;
    int *field = pdmc_dimension_field(results, axis, &more);
    if (field && !known[axis]) {
        if (extent < (hsize_t)more || extent > (hsize_t)INT_MAX)
            return pdmc_raise(PDMC_ERR_DATA, "%s: %llu along \"%s\"", dataset->path, (unsigned long long)extent,
                              pdmc_dimension_label(axis));
        *field = (int)extent - more;
        known[axis] = true;
    }
    if (extent != pdmc_dimension_size(results, axis))
        return pdmc_raise(PDMC_ERR_DATA, "%s: %llu along \"%s\", where %zu are expected", dataset->path,
                          (unsigned long long)extent, pdmc_dimension_label(axis), pdmc_dimension_size(results, axis));
    return PDMC_OK;
}

static pdmc_status read_axes(hid_t object, pdmc_results *results, bool known[], const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    hsize_t extents[PDMC_MAX_RANK];
    const size_t rank = pdmc_dataset_rank(dataset);
    const hid_t space = H5Dget_space(object);
    PDMC_H5_TRY(space, PDMC_ERR_DATA, dataset->path);
    if (H5Sget_simple_extent_ndims(space) != (int)rank)
        PDMC_FAIL(PDMC_ERR_DATA, "%s: has %d axes, not %zu", dataset->path, H5Sget_simple_extent_ndims(space), rank);
    PDMC_H5_TRY(H5Sget_simple_extent_dims(space, extents, NULL), PDMC_ERR_DATA, dataset->path);
    for (size_t i = 0; i < rank; i++) PDMC_TRY(read_axis(results, known, dataset, i, extents[i]));

done:
    pdmc_h5_close(space);
    return status;
}

/// Refuses more numbers than the file can hold, so that a damaged size does not ask for all memory. Numbers stored
/// as they are take at least a byte each; what deflate can make of a byte is bounded by 1032.
static pdmc_status check_size(hid_t file, hid_t object, const pdmc_results *results, const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    hsize_t bytes = 0;
    double size = 1.0; // a product of damaged sizes may not fit an integer
    const hid_t creation = H5Dget_create_plist(object);
    PDMC_H5_TRY(creation, PDMC_ERR_DATA, dataset->path);
    PDMC_H5_TRY(H5Fget_filesize(file, &bytes), PDMC_ERR_DATA, dataset->path);
    for (size_t i = 0; i < pdmc_dataset_rank(dataset); i++)
        size *= (double)pdmc_dimension_size(results, dataset->axes[i]);
    const double packing = H5Pget_layout(creation) == H5D_CHUNKED ? 1032.0 : 1.0;
    if (size > packing * (double)bytes)
        PDMC_FAIL(PDMC_ERR_DATA, "%s: claims %.0f numbers in a file of %llu bytes", dataset->path, size,
                  (unsigned long long)bytes);

done:
    pdmc_h5_close(creation);
    return status;
}

static pdmc_status check_class(hid_t object, const pdmc_dataset *dataset)
{
    static const H5T_class_t classes[] = {
        [PDMC_KIND_REAL] = H5T_FLOAT,   [PDMC_KIND_INT] = H5T_INTEGER, [PDMC_KIND_INT64] = H5T_INTEGER,
        [PDMC_KIND_BYTE] = H5T_INTEGER, [PDMC_KIND_NAME] = H5T_STRING,
    };
    const hid_t type = H5Dget_type(object);
    const H5T_class_t found = type < 0 ? H5T_NO_CLASS : H5Tget_class(type);
    pdmc_h5_close(type);
    if (found != classes[dataset->kind]) return pdmc_raise(PDMC_ERR_DATA, "%s: holds another type", dataset->path);
    return PDMC_OK;
}

/// The array of a dataset, made by the first of its columns.
static void *array_of(pdmc_results *results, const pdmc_dataset *dataset, size_t size)
{
    void *memory = pdmc_dataset_memory(results, dataset);
    if (!memory && (memory = pdmc_calloc(size / dataset->width, dataset->stride)))
        pdmc_dataset_set_memory(results, dataset, memory);
    return memory;
}

static pdmc_status read_numbers(hid_t object, pdmc_results *results, const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    const size_t size = pdmc_dataset_size(results, dataset);
    const bool packed = pdmc_dataset_is_packed(dataset);
    void *numbers = NULL, *memory = array_of(results, dataset, size);
    const hid_t type = pdmc_h5_memory_type(dataset->kind);
    PDMC_H5_TRY(type, PDMC_ERR_DATA, dataset->path);
    if (memory && !packed) numbers = pdmc_calloc(size, pdmc_kind_size(dataset->kind));
    if (!memory || (!packed && !numbers)) {
        status = PDMC_ERR_NOMEM;
        goto done;
    }
    PDMC_H5_TRY(H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed ? memory : numbers), PDMC_ERR_DATA,
                dataset->path);
    if (!packed) pdmc_dataset_scatter(dataset, size, numbers, memory);

done:
    pdmc_h5_close(type);
    pdmc_free(numbers);
    return status;
}

// Whether the file has no link of the path, or none of a group on the way: HDF5 can only be asked step by step.
static bool is_missing(hid_t file, const char *path)
{
    char part[128];
    for (const char *end = strchr(path + 1, '/');; end = strchr(end + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", (int)(end ? end - path : (ptrdiff_t)strlen(path)), path);
        if (H5Lexists(file, part, H5P_DEFAULT) == 0) return true;
        if (!end) return false;
    }
}

// What a file of an earlier version does not hold is NaN; in arrays of other numbers 0.
static pdmc_status leave_out(pdmc_results *results, const pdmc_dataset *dataset)
{
    const size_t size = pdmc_dataset_size(results, dataset);
    if (dataset->stride == 0) {
        *(double *)pdmc_dataset_memory(results, dataset) = NAN;
        return PDMC_OK;
    }
    char *array = size > 0 ? array_of(results, dataset, size) : NULL;
    if (size > 0 && !array) return PDMC_ERR_NOMEM;
    const double unknown = NAN;
    for (size_t i = 0; i < size && dataset->kind == PDMC_KIND_REAL; i++)
        memcpy(&array[i / dataset->width * dataset->stride + dataset->column + i % dataset->width * sizeof unknown],
               &unknown, sizeof unknown);
    return PDMC_OK;
}

static pdmc_status read_dataset(hid_t file, pdmc_results *results, bool known[], const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    hid_t object = H5I_INVALID_HID;
    if (pdmc_dataset_may_be_missing(dataset) && is_missing(file, dataset->path)) return leave_out(results, dataset);
    PDMC_H5_TRY(object = H5Dopen2(file, dataset->path, H5P_DEFAULT), PDMC_ERR_DATA, dataset->path);
    PDMC_TRY(read_axes(object, results, known, dataset));
    PDMC_TRY(check_size(file, object, results, dataset));
    PDMC_TRY(check_class(object, dataset));
    PDMC_TRY(read_numbers(object, results, dataset));

done:
    pdmc_h5_close(object);
    return status;
}

static pdmc_status read_choice(hid_t object, const pdmc_attribute *attribute, void *member)
{
    pdmc_status status = PDMC_OK;
    char *name = NULL;
    int choice = 0;
    PDMC_TRY(pdmc_h5_read_text(object, attribute->name, &name));
    while (choice < attribute->choice_count && strcmp(name, attribute->choices[choice]) != 0) choice++;
    if (choice == attribute->choice_count) PDMC_FAIL(PDMC_ERR_DATA, "%s = \"%.64s\" is unknown", attribute->name, name);
    memcpy(member, &choice, sizeof choice);

done:
    pdmc_free(name);
    return status;
}

static pdmc_status read_member(hid_t object, pdmc_results *results, const pdmc_attribute *attribute)
{
    void *member = (char *)results + attribute->member;
    const char *name = attribute->name;
    switch (attribute->kind) {
    case PDMC_ATTRIBUTE_TEXT: return pdmc_h5_read_text(object, name, pdmc_attribute_text(results, attribute));
    case PDMC_ATTRIBUTE_DOCUMENT: return pdmc_h5_read_document(object, name, pdmc_attribute_text(results, attribute));
    case PDMC_ATTRIBUTE_REAL: return pdmc_h5_read_numbers(object, name, H5T_NATIVE_DOUBLE, 0, member);
    case PDMC_ATTRIBUTE_INT: return pdmc_h5_read_numbers(object, name, H5T_NATIVE_INT, 0, member);
    case PDMC_ATTRIBUTE_SEED: return pdmc_h5_read_numbers(object, name, H5T_NATIVE_UINT64, 0, member);
    case PDMC_ATTRIBUTE_CHOICE: return read_choice(object, attribute, member);
    }
    return pdmc_raise(PDMC_ERR_DATA, "attribute \"%s\" is of unknown kind", name);
}

static pdmc_status read_attribute(hid_t file, pdmc_results *results, const pdmc_attribute *attribute)
{
    pdmc_status status = PDMC_OK;
    const hid_t object = H5Oopen(file, attribute->object, H5P_DEFAULT);
    PDMC_H5_TRY(object, PDMC_ERR_DATA, attribute->object);
    if (pdmc_attribute_may_be_missing(attribute) && H5Aexists(object, attribute->name) == 0) {
        *pdmc_attribute_text(results, attribute) = pdmc_strdup("");
        if (!*pdmc_attribute_text(results, attribute)) status = PDMC_ERR_NOMEM;
    } else {
        PDMC_TRY(read_member(object, results, attribute));
    }

done:
    pdmc_h5_close(object);
    return status;
}

// Files of earlier versions have the energies of all samples instead.
static void find_largest(pdmc_results *results)
{
    const size_t angles = (size_t)results->angle_count;
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (size_t i = 0; i < (size_t)results->kept_count * (size_t)results->tip_count; i++)
            for (size_t a = 0; a < angles; a++)
                results->largest_energy[m][i] = fmax(results->largest_energy[m][i], results->energy[m][i * angles + a]);
}

static pdmc_status read_everything(hid_t file, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    bool known[PDMC_DIM_BOUND + 1] = {false};
    // The attributes first, since one of them is the kind of study, on which the datasets depend.
    for (size_t i = 0; i < pdmc_attribute_count; i++)
        if (pdmc_attribute_belongs(results, &pdmc_attributes[i]))
            PDMC_TRY(read_attribute(file, results, &pdmc_attributes[i]));
    for (size_t i = 0; i < pdmc_dataset_count; i++)
        if (pdmc_dataset_belongs(results, &pdmc_datasets[i]))
            PDMC_TRY(read_dataset(file, results, known, &pdmc_datasets[i]));
    PDMC_TRY(pdmc_results_check(results, PDMC_ERR_DATA));
    find_largest(results);

done:
    return status;
}

/// What HDF5 would only call "unable to open file".
static pdmc_status check_file(const char *path)
{
    struct stat properties;
    char text[128] = "unknown error";
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        strerror_r(errno, text, sizeof text);
        return pdmc_raise(PDMC_ERR_NO_INPUT, "%s: %s", path, text);
    }
    const bool regular = fstat(descriptor, &properties) == 0 && S_ISREG(properties.st_mode);
    close(descriptor);
    if (!regular) return pdmc_raise(PDMC_ERR_NO_INPUT, "%s: not a file", path);
    if (H5Fis_hdf5(path) <= 0)
        return pdmc_raise(PDMC_ERR_DATA, "%s: not an HDF5 file%s", path,
                          properties.st_size == 0 ? " (it is empty)" : "");
    return PDMC_OK;
}

static pdmc_status open_file(const char *path, hid_t *file)
{
    pdmc_status status = PDMC_OK;
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    // A result file that has its name is whole and is never written again: there is nothing to lock it against.
    PDMC_H5_TRY(H5Pset_file_locking(access, false, true), PDMC_ERR_EXTERN, path);
    *file = H5Fopen(path, H5F_ACC_RDONLY, access);
    PDMC_H5_TRY(*file, PDMC_ERR_DATA, path);

done:
    pdmc_h5_close(access);
    return status;
}

pdmc_status pdmc_results_read(const char *path, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    hid_t file = H5I_INVALID_HID;
    pdmc_h5_printing printing;
    pdmc_h5_silence(&printing);
    *results = (pdmc_results){0};
    PDMC_TRY(check_file(path));
    PDMC_TRY(open_file(path, &file));
    PDMC_TRY(pdmc_identity_read(file, path, results));
    status = read_everything(file, results);
    if (status == PDMC_ERR_DATA) pdmc_raise(status, "%s: damaged: %s", path, pdmc_last_error());

done:
    pdmc_h5_close(file);
    if (status != PDMC_OK) pdmc_results_clear(results);
    pdmc_h5_restore(&printing);
    return status;
}
