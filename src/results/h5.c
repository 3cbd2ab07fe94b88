// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/h5.h"

#include "base/base_impl.h"

#include <stdio.h>
#include <string.h>

void pdmc_h5_silence(pdmc_h5_printing *before)
{
    H5Eget_auto2(H5E_DEFAULT, &before->function, &before->data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
}

void pdmc_h5_restore(const pdmc_h5_printing *before)
{
    H5Eset_auto2(H5E_DEFAULT, before->function, before->data);
}

enum { MESSAGE_SIZE = 512 };

static herr_t copy_innermost(unsigned depth, const H5E_error2_t *error, void *message)
{
    if (depth == 0) snprintf(message, MESSAGE_SIZE, "%s", error->desc);
    return 0;
}

static void innermost_message(char message[MESSAGE_SIZE])
{
    snprintf(message, MESSAGE_SIZE, "unknown failure of HDF5");
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, copy_innermost, message);
    for (char *c = message; *c; c++)
        if (*c == '\n') *c = ' ';
}

pdmc_status pdmc_h5_raise(pdmc_status status, const char *what)
{
    char message[MESSAGE_SIZE];
    innermost_message(message);
    const char *advice = strstr(message, "lock file")
                             ? "; on file systems without locks set HDF5_USE_FILE_LOCKING=FALSE in the environment, "
                               "which lets HDF5 open files without locking them"
                             : "";
    return pdmc_raise(status, "%s: %s%s", what, message, advice);
}

void pdmc_h5_close(hid_t id)
{
    if (id >= 0) H5Idec_ref(id);
}

static hid_t text_type(size_t size)
{
    const hid_t type = H5Tcopy(H5T_C_S1);
    if (type >= 0 && (H5Tset_size(type, size) < 0 || H5Tset_cset(type, H5T_CSET_UTF8) < 0)) {
        H5Tclose(type);
        return H5I_INVALID_HID;
    }
    return type;
}

hid_t pdmc_h5_memory_type(pdmc_kind kind)
{
    if (kind == PDMC_KIND_NAME) return text_type(pdmc_kind_size(kind));
    const hid_t types[] = {
        [PDMC_KIND_REAL] = H5T_NATIVE_DOUBLE,
        [PDMC_KIND_INT] = H5T_NATIVE_INT,
        [PDMC_KIND_INT64] = H5T_NATIVE_INT64,
        [PDMC_KIND_BYTE] = H5T_NATIVE_UINT8,
    };
    return H5Tcopy(types[kind]);
}

hid_t pdmc_h5_file_type(pdmc_kind kind)
{
    if (kind == PDMC_KIND_NAME) return text_type(pdmc_kind_size(kind));
    const hid_t types[] = {
        [PDMC_KIND_REAL] = H5T_IEEE_F64LE,
        [PDMC_KIND_INT] = H5T_STD_I32LE,
        [PDMC_KIND_INT64] = H5T_STD_I64LE,
        [PDMC_KIND_BYTE] = H5T_STD_U8LE,
    };
    return H5Tcopy(types[kind]);
}

pdmc_status pdmc_h5_write_numbers(hid_t object, const char *name, hid_t file_type, hid_t memory_type, size_t count,
                                  const void *numbers)
{
    pdmc_status status = PDMC_OK;
    const hsize_t extent = count;
    hid_t attribute = H5I_INVALID_HID;
    const hid_t space = count > 0 ? H5Screate_simple(1, &extent, NULL) : H5Screate(H5S_SCALAR);
    PDMC_H5_TRY(space, PDMC_ERR_EXTERN, name);
    PDMC_H5_TRY(attribute = H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT), PDMC_ERR_EXTERN,
                name);
    PDMC_H5_TRY(H5Awrite(attribute, memory_type, numbers), PDMC_ERR_EXTERN, name);

done:
    pdmc_h5_close(attribute);
    pdmc_h5_close(space);
    return status;
}

pdmc_status pdmc_h5_write_labels(hid_t object, const char *name, size_t count, const char *const labels[])
{
    pdmc_status status = PDMC_OK;
    const hid_t type = text_type(H5T_VARIABLE);
    PDMC_H5_TRY(type, PDMC_ERR_EXTERN, name);
    PDMC_TRY(pdmc_h5_write_numbers(object, name, type, type, count, labels));

done:
    pdmc_h5_close(type);
    return status;
}

pdmc_status pdmc_h5_write_text(hid_t object, const char *name, const char *text)
{
    pdmc_status status = PDMC_OK;
    const hid_t type = text_type(strlen(text) + 1);
    PDMC_H5_TRY(type, PDMC_ERR_EXTERN, name);
    PDMC_TRY(pdmc_h5_write_numbers(object, name, type, type, 0, text));

done:
    pdmc_h5_close(type);
    return status;
}

pdmc_status pdmc_h5_write_document(hid_t group, const char *name, const char *text)
{
    pdmc_status status = PDMC_OK;
    hid_t dataset = H5I_INVALID_HID;
    const hid_t type = text_type(strlen(text) + 1), space = H5Screate(H5S_SCALAR),
                creation = H5Pcreate(H5P_DATASET_CREATE);
    PDMC_H5_TRY(H5Pset_obj_track_times(creation, false), PDMC_ERR_EXTERN, name);
    dataset = H5Dcreate2(group, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    PDMC_H5_TRY(dataset, PDMC_ERR_EXTERN, name);
    PDMC_H5_TRY(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text), PDMC_ERR_EXTERN, name);

done:
    pdmc_h5_close(dataset);
    pdmc_h5_close(creation);
    pdmc_h5_close(space);
    pdmc_h5_close(type);
    return status;
}

/// Opens an attribute of exactly `count` elements.
static pdmc_status open_attribute(hid_t object, const char *name, size_t count, hid_t *attribute)
{
    *attribute = H5Aopen(object, name, H5P_DEFAULT);
    if (*attribute < 0) return pdmc_h5_raise(PDMC_ERR_DATA, name);
    const hid_t space = H5Aget_space(*attribute);
    const hssize_t points = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
    pdmc_h5_close(space);
    if (points != (hssize_t)count)
        return pdmc_raise(PDMC_ERR_DATA, "attribute \"%s\" has %lld elements, not %zu", name, (long long)points, count);
    return PDMC_OK;
}

pdmc_status pdmc_h5_read_numbers(hid_t object, const char *name, hid_t memory_type, size_t count, void *numbers)
{
    pdmc_status status = PDMC_OK;
    hid_t attribute = H5I_INVALID_HID;
    PDMC_TRY(open_attribute(object, name, count > 0 ? count : 1, &attribute));
    PDMC_H5_TRY(H5Aread(attribute, memory_type, numbers), PDMC_ERR_DATA, name);

done:
    pdmc_h5_close(attribute);
    return status;
}

/// Memory for a text of this type. Texts of variable length are not ours, and lie where HDF5 1.10 crashes on damage.
static pdmc_status allocate_text(hid_t type, const char *name, char **text)
{
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
        return pdmc_raise(PDMC_ERR_DATA, "\"%s\" is not a text of fixed length", name);
    *text = pdmc_calloc(H5Tget_size(type) + 1, 1);
    return *text ? PDMC_OK : PDMC_ERR_NOMEM;
}

static void forget_text(char **text)
{
    pdmc_free(*text);
    *text = NULL;
}

// The type in memory is the file's own, as HDF5 does not convert between character sets.

pdmc_status pdmc_h5_read_text(hid_t object, const char *name, char **text)
{
    pdmc_status status = PDMC_OK;
    hid_t attribute = H5I_INVALID_HID, type = H5I_INVALID_HID;
    *text = NULL;
    PDMC_TRY(open_attribute(object, name, 1, &attribute));
    PDMC_H5_TRY(type = H5Aget_type(attribute), PDMC_ERR_DATA, name);
    PDMC_TRY(allocate_text(type, name, text));
    PDMC_H5_TRY(H5Aread(attribute, type, *text), PDMC_ERR_DATA, name);

done:
    pdmc_h5_close(type);
    pdmc_h5_close(attribute);
    if (status != PDMC_OK) forget_text(text);
    return status;
}

pdmc_status pdmc_h5_read_document(hid_t group, const char *name, char **text)
{
    pdmc_status status = PDMC_OK;
    hid_t type = H5I_INVALID_HID, space = H5I_INVALID_HID;
    *text = NULL;
    const hid_t dataset = H5Dopen2(group, name, H5P_DEFAULT);
    PDMC_H5_TRY(dataset, PDMC_ERR_DATA, name);
    PDMC_H5_TRY(space = H5Dget_space(dataset), PDMC_ERR_DATA, name);
    PDMC_H5_TRY(type = H5Dget_type(dataset), PDMC_ERR_DATA, name);
    if (H5Sget_simple_extent_npoints(space) != 1) PDMC_FAIL(PDMC_ERR_DATA, "\"%s\" is not one text", name);
    PDMC_TRY(allocate_text(type, name, text));
    PDMC_H5_TRY(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, *text), PDMC_ERR_DATA, name);

done:
    pdmc_h5_close(type);
    pdmc_h5_close(space);
    pdmc_h5_close(dataset);
    if (status != PDMC_OK) forget_text(text);
    return status;
}
