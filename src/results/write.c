// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "results/h5.h"
#include "results/identity.h"
#include "results/vtkhdf.h"
#include "results/whole_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static pdmc_status describe(hid_t object, const pdmc_results *results, const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    char unit[PDMC_UNIT_SIZE];
    const char *labels[PDMC_MAX_RANK];
    const size_t rank = pdmc_dataset_rank(dataset);
    for (size_t i = 0; i < rank; i++) labels[i] = pdmc_dimension_label(dataset->axes[i]);
    pdmc_results_unit(results, dataset->unit, sizeof unit, unit);
    PDMC_TRY(pdmc_h5_write_text(object, "units", unit));
    PDMC_TRY(pdmc_h5_write_text(object, "description", dataset->description));
    // The name under which HDF5's own dimension scales keep the labels, so that its tools show them.
    if (rank > 0) PDMC_TRY(pdmc_h5_write_labels(object, "DIMENSION_LABELS", rank, labels));

done:
    return status;
}

// Creates the folders on a path that are not there yet, without the times that would make equal files differ.
static void create_folders(hid_t file, const char *path)
{
    const hid_t creation = H5Pcreate(H5P_GROUP_CREATE);
    char part[128];
    H5Pset_obj_track_times(creation, false);
    for (const char *end = strchr(path + 1, '/'); end; end = strchr(end + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", (int)(end - path), path);
        if (H5Lexists(file, part, H5P_DEFAULT) == 0)
            pdmc_h5_close(H5Gcreate2(file, part, H5P_DEFAULT, creation, H5P_DEFAULT));
    }
    pdmc_h5_close(creation);
}

/// Creates a dataset with the folders on its path; a failure of theirs is a failure of its own.
static hid_t create_dataset(hid_t file, const pdmc_results *results, const pdmc_dataset *dataset, hid_t type)
{
    hsize_t extents[PDMC_MAX_RANK];
    const size_t rank = pdmc_dataset_rank(dataset);
    for (size_t i = 0; i < rank; i++) extents[i] = pdmc_dimension_size(results, dataset->axes[i]);
    const hid_t space = rank > 0 ? H5Screate_simple((int)rank, extents, NULL) : H5Screate(H5S_SCALAR);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    hid_t object = H5I_INVALID_HID;
    create_folders(file, dataset->path);
    if (space >= 0 && H5Pset_obj_track_times(creation, 0) >= 0)
        object = H5Dcreate2(file, dataset->path, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    pdmc_h5_close(creation);
    pdmc_h5_close(space);
    return object;
}

static pdmc_status write_numbers(hid_t object, const pdmc_results *results, const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    void *packed = NULL;
    const void *numbers = pdmc_dataset_memory(results, dataset);
    const size_t size = pdmc_dataset_size(results, dataset);
    const hid_t type = pdmc_h5_memory_type(dataset->kind);
    PDMC_H5_TRY(type, PDMC_ERR_EXTERN, dataset->path);
    if (size > 0 && !pdmc_dataset_is_packed(dataset)) {
        packed = pdmc_calloc(size, pdmc_kind_size(dataset->kind));
        if (!packed) {
            status = PDMC_ERR_NOMEM;
            goto done;
        }
        pdmc_dataset_gather(dataset, size, numbers, packed);
        numbers = packed;
    }
    if (size > 0)
        PDMC_H5_TRY(H5Dwrite(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), PDMC_ERR_EXTERN, dataset->path);

done:
    pdmc_h5_close(type);
    pdmc_free(packed);
    return status;
}

static pdmc_status write_dataset(hid_t file, const pdmc_results *results, const pdmc_dataset *dataset)
{
    pdmc_status status = PDMC_OK;
    hid_t object = H5I_INVALID_HID;
    const hid_t type = pdmc_h5_file_type(dataset->kind);
    PDMC_H5_TRY(type, PDMC_ERR_EXTERN, dataset->path);
    PDMC_H5_TRY(object = create_dataset(file, results, dataset, type), PDMC_ERR_EXTERN, dataset->path);
    PDMC_TRY(write_numbers(object, results, dataset));
    PDMC_TRY(describe(object, results, dataset));

done:
    pdmc_h5_close(object);
    pdmc_h5_close(type);
    return status;
}

static pdmc_status write_choice(hid_t object, const pdmc_attribute *attribute, const void *member)
{
    int choice;
    memcpy(&choice, member, sizeof choice);
    return pdmc_h5_write_text(object, attribute->name, attribute->choices[choice]);
}

static pdmc_status write_member(hid_t object, const pdmc_results *results, const pdmc_attribute *attribute)
{
    const void *member = (const char *)results + attribute->member;
    char *const *place = pdmc_attribute_text((pdmc_results *)results, attribute);
    const char *name = attribute->name, *text = place && *place ? *place : "";
    switch (attribute->kind) {
    case PDMC_ATTRIBUTE_TEXT: return pdmc_h5_write_text(object, name, text);
    case PDMC_ATTRIBUTE_DOCUMENT: return pdmc_h5_write_document(object, name, text);
    case PDMC_ATTRIBUTE_REAL: return pdmc_h5_write_numbers(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 0, member);
    case PDMC_ATTRIBUTE_INT: return pdmc_h5_write_numbers(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, 0, member);
    case PDMC_ATTRIBUTE_SEED: return pdmc_h5_write_numbers(object, name, H5T_STD_U64LE, H5T_NATIVE_UINT64, 0, member);
    case PDMC_ATTRIBUTE_CHOICE: return write_choice(object, attribute, member);
    }
    return pdmc_raise(PDMC_ERR_ARG, "attribute \"%s\" is of unknown kind", name);
}

static pdmc_status write_attribute(hid_t file, const pdmc_results *results, const pdmc_attribute *attribute)
{
    pdmc_status status = PDMC_OK;
    const hid_t object = H5Oopen(file, attribute->object, H5P_DEFAULT);
    PDMC_H5_TRY(object, PDMC_ERR_EXTERN, attribute->object);
    PDMC_TRY(write_member(object, results, attribute));

done:
    pdmc_h5_close(object);
    return status;
}

/// The time that the file's making has taken can be known only when the rest of it is made.
static pdmc_status write_output_time(hid_t file, double seconds)
{
    pdmc_status status = PDMC_OK;
    const hid_t object = H5Dopen2(file, "/runtime/output", H5P_DEFAULT);
    PDMC_H5_TRY(object, PDMC_ERR_EXTERN, "/runtime/output");
    PDMC_H5_TRY(H5Dwrite(object, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &seconds), PDMC_ERR_EXTERN,
                "/runtime/output");

done:
    pdmc_h5_close(object);
    return status;
}

static pdmc_status write_everything(hid_t file, const pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    for (size_t i = 0; i < pdmc_dataset_count; i++)
        if (pdmc_dataset_belongs(results, &pdmc_datasets[i])) PDMC_TRY(write_dataset(file, results, &pdmc_datasets[i]));
    for (size_t i = 0; i < pdmc_attribute_count; i++)
        if (pdmc_attribute_belongs(results, &pdmc_attributes[i]))
            PDMC_TRY(write_attribute(file, results, &pdmc_attributes[i]));
    PDMC_TRY(pdmc_identity_write(file, results));
    if (pdmc_is_of_bodies(results->kind)) PDMC_TRY(pdmc_vtkhdf_write(file, &results->particles));
    if (isnan(results->runtime.output)) PDMC_TRY(write_output_time(file, pdmc_seconds() - start));

done:
    return status;
}

/// The bytes of a file that is in memory; they are HDF5's until the file is closed.
static pdmc_status file_image(hid_t file, const char *path, const void **image, size_t *size)
{
    void *handle = NULL;
    if (H5Fflush(file, H5F_SCOPE_GLOBAL) < 0) return pdmc_h5_raise(PDMC_ERR_EXTERN, path);
    const ssize_t bytes = H5Fget_file_image(file, NULL, 0);
    // The handle of the core driver is the place of its pointer to the image.
    if (bytes <= 0 || H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0) return pdmc_h5_raise(PDMC_ERR_EXTERN, path);
    *image = *(void **)handle;
    *size = (size_t)bytes;
    return PDMC_OK;
}

/// HDF5 makes the file in memory and we put it on the disk: when the disk is full, HDF5 1.10 cannot close what it
/// wrote, and crashes at the end of the process.
static pdmc_status write_hdf5(const pdmc_results *results, pdmc_whole_file *whole)
{
    enum { GROWTH = 1 << 20 }; // bytes by which the image grows
    pdmc_status status = PDMC_OK;
    const void *image = NULL;
    size_t size = 0;
    hid_t file = H5I_INVALID_HID;
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS), creation = H5Pcreate(H5P_FILE_CREATE);
    PDMC_H5_TRY(H5Pset_fapl_core(access, GROWTH, false), PDMC_ERR_EXTERN, whole->path);
    // The format of HDF5 1.8 has checksums of all that describes the data: damage there is refused, where readers of the
    // older one can crash. That of 1.10 would mark the image as open for writing.
    PDMC_H5_TRY(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), PDMC_ERR_EXTERN, whole->path);
    PDMC_H5_TRY(H5Pset_obj_track_times(creation, false), PDMC_ERR_EXTERN, whole->path);
    file = H5Fcreate(whole->temporary, H5F_ACC_TRUNC, creation, access);
    PDMC_H5_TRY(file, PDMC_ERR_EXTERN, whole->path);
    PDMC_TRY(write_everything(file, results));
    PDMC_TRY(file_image(file, whole->path, &image, &size));
    PDMC_TRY(pdmc_whole_file_write(whole, size, image));

done:
    pdmc_h5_close(file);
    pdmc_h5_close(creation);
    pdmc_h5_close(access);
    return status;
}

pdmc_status pdmc_results_write(const pdmc_results *results, const char *path, bool overwrite)
{
    pdmc_status status = PDMC_OK;
    pdmc_whole_file whole = {0};
    pdmc_h5_printing printing;
    pdmc_h5_silence(&printing);
    PDMC_TRY(pdmc_results_check(results, PDMC_ERR_ARG));
    PDMC_TRY(pdmc_whole_file_open(path, overwrite, &whole));
    PDMC_TRY(write_hdf5(results, &whole));
    PDMC_TRY(pdmc_whole_file_appear(&whole, overwrite));

done:
    pdmc_whole_file_discard(&whole);
    pdmc_h5_restore(&printing);
    return status;
}
