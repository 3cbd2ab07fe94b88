// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/vtkhdf.h"

#include "base/base_impl.h"

enum { VTK_VERTEX = 1 };

static const char group_name[] = "/VTKHDF";

// A whole number for each element: `first` + i `step`.
typedef struct {
    const char *path;
    size_t count;
    int64_t first, step;
} sequence;

static pdmc_status write_sequence(hid_t file, const sequence *s, hid_t file_type)
{
    pdmc_status status = PDMC_OK;
    const hsize_t extent = s->count;
    hid_t space = H5I_INVALID_HID, object = H5I_INVALID_HID;
    int64_t *numbers = NULL;
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    PDMC_NEW(numbers, s->count);
    for (size_t i = 0; i < s->count; i++) numbers[i] = s->first + (int64_t)i * s->step;
    PDMC_H5_TRY(H5Pset_obj_track_times(creation, false), PDMC_ERR_EXTERN, s->path);
    PDMC_H5_TRY(space = H5Screate_simple(1, &extent, NULL), PDMC_ERR_EXTERN, s->path);
    object = H5Dcreate2(file, s->path, file_type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    PDMC_H5_TRY(object, PDMC_ERR_EXTERN, s->path);
    if (s->count > 0)
        PDMC_H5_TRY(H5Dwrite(object, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), PDMC_ERR_EXTERN,
                    s->path);
done:
    pdmc_h5_close(object);
    pdmc_h5_close(space);
    pdmc_h5_close(creation);
    pdmc_free(numbers);
    return status;
}

// The cells are written once; all steps begin at the same ones.
static pdmc_status write_sequences(hid_t file, const pdmc_explicit_record *r)
{
    pdmc_status status = PDMC_OK;
    const size_t nodes = (size_t)r->node_count, steps = (size_t)r->snapshot_count;
    const int64_t n = r->node_count;
    const sequence sequences[] = {
        {"/VTKHDF/NumberOfPoints", 1, n, 0},
        {"/VTKHDF/NumberOfCells", 1, n, 0},
        {"/VTKHDF/NumberOfConnectivityIds", 1, n, 0},
        {"/VTKHDF/Connectivity", nodes, 0, 1},
        {"/VTKHDF/Offsets", nodes + 1, 0, 1},
        {"/VTKHDF/Steps/PartOffsets", steps, 0, 0},
        {"/VTKHDF/Steps/NumberOfParts", steps, 1, 0},
        {"/VTKHDF/Steps/PointOffsets", steps, 0, 0},
        {"/VTKHDF/Steps/CellOffsets", steps, 0, 0},
        {"/VTKHDF/Steps/ConnectivityIdOffsets", steps, 0, 0},
        {"/VTKHDF/Steps/PointDataOffsets/displacement", steps, 0, n},
        {"/VTKHDF/Steps/PointDataOffsets/velocity", steps, 0, n},
        {"/VTKHDF/Steps/PointDataOffsets/damage", steps, 0, n},
        {"/VTKHDF/Steps/PointDataOffsets/fragment", steps, 0, n},
        {"/VTKHDF/Steps/PointDataOffsets/body", steps, 0, 0},
    };
    const sequence types = {"/VTKHDF/Types", nodes, VTK_VERTEX, 0};
    for (size_t i = 0; i < sizeof sequences / sizeof sequences[0]; i++)
        PDMC_TRY(write_sequence(file, &sequences[i], H5T_STD_I64LE));
    PDMC_TRY(write_sequence(file, &types, H5T_STD_U8LE));
done:
    return status;
}

static pdmc_status link_datasets(hid_t file)
{
    static const char *const links[][2] = {
        {"/explicit/nodes/position", "/VTKHDF/Points"},
        {"/explicit/nodes/body", "/VTKHDF/PointData/body"},
        {"/explicit/snapshots/displacement", "/VTKHDF/PointData/displacement"},
        {"/explicit/snapshots/velocity", "/VTKHDF/PointData/velocity"},
        {"/explicit/snapshots/damage", "/VTKHDF/PointData/damage"},
        {"/explicit/snapshots/fragment", "/VTKHDF/PointData/fragment"},
        {"/explicit/snapshots/time", "/VTKHDF/Steps/Values"},
    };
    pdmc_status status = PDMC_OK;
    for (size_t i = 0; i < sizeof links / sizeof links[0]; i++)
        PDMC_H5_TRY(H5Lcreate_hard(file, links[i][0], file, links[i][1], H5P_DEFAULT, H5P_DEFAULT), PDMC_ERR_EXTERN,
                    links[i][1]);
done:
    return status;
}

static pdmc_status create_groups(hid_t file)
{
    static const char *const names[] = {group_name, "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/Steps",
                                        "/VTKHDF/Steps/PointDataOffsets"};
    pdmc_status status = PDMC_OK;
    const hid_t creation = H5Pcreate(H5P_GROUP_CREATE);
    PDMC_H5_TRY(H5Pset_obj_track_times(creation, false), PDMC_ERR_EXTERN, group_name);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const hid_t group = H5Gcreate2(file, names[i], H5P_DEFAULT, creation, H5P_DEFAULT);
        PDMC_H5_TRY(group, PDMC_ERR_EXTERN, names[i]);
        pdmc_h5_close(group);
    }
done:
    pdmc_h5_close(creation);
    return status;
}

// VTK wants the type as a text of fixed length in ASCII.
static pdmc_status write_type(hid_t group)
{
    static const char name[] = "UnstructuredGrid";
    pdmc_status status = PDMC_OK;
    const hid_t type = H5Tcopy(H5T_C_S1);
    PDMC_H5_TRY(H5Tset_size(type, sizeof name - 1), PDMC_ERR_EXTERN, group_name);
    PDMC_H5_TRY(H5Tset_strpad(type, H5T_STR_NULLPAD), PDMC_ERR_EXTERN, group_name);
    PDMC_TRY(pdmc_h5_write_numbers(group, "Type", type, type, 0, name));
done:
    pdmc_h5_close(type);
    return status;
}

static pdmc_status write_attributes(hid_t file, const pdmc_explicit_record *r)
{
    pdmc_status status = PDMC_OK;
    const int64_t version[] = {2, 0}, steps = r->snapshot_count;
    const hid_t group = H5Gopen2(file, group_name, H5P_DEFAULT);
    const hid_t inner = H5Gopen2(file, "/VTKHDF/Steps", H5P_DEFAULT);
    PDMC_H5_TRY(group, PDMC_ERR_EXTERN, group_name);
    PDMC_H5_TRY(inner, PDMC_ERR_EXTERN, group_name);
    PDMC_TRY(pdmc_h5_write_numbers(group, "Version", H5T_STD_I64LE, H5T_NATIVE_INT64, 2, version));
    PDMC_TRY(write_type(group));
    PDMC_TRY(pdmc_h5_write_numbers(inner, "NSteps", H5T_STD_I64LE, H5T_NATIVE_INT64, 0, &steps));
done:
    pdmc_h5_close(inner);
    pdmc_h5_close(group);
    return status;
}

pdmc_status pdmc_vtkhdf_write(hid_t file, const pdmc_explicit_record *record)
{
    pdmc_status status = create_groups(file);
    if (status == PDMC_OK) status = write_attributes(file, record);
    if (status == PDMC_OK) status = write_sequences(file, record);
    if (status == PDMC_OK) status = link_datasets(file);
    return status;
}
