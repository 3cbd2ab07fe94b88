// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/identity.h"

#include "base/base_impl.h"
#include "results/h5.h"

#include <stdio.h>
#include <string.h>

static const char filetype[] = "pdmc-results";
enum { VERSION_MAJOR = 1, VERSION_MINOR = 2 }; // of the layout: the major one changes when old readers would fail
enum { VERSION_TEXT = 48 };                    // characters of "major.minor.patch"

static pdmc_status write_integers(hid_t file, const char *name, size_t count, const int numbers[])
{
    return pdmc_h5_write_numbers(file, name, H5T_STD_I32LE, H5T_NATIVE_INT, count, numbers);
}

static pdmc_status write_levels(hid_t file)
{
    pdmc_status status = PDMC_OK;
    const hid_t group = H5Gopen2(file, "/statistics", H5P_DEFAULT);
    PDMC_H5_TRY(group, PDMC_ERR_EXTERN, "/statistics");
    PDMC_TRY(pdmc_h5_write_numbers(group, "quantile_levels", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, PDMC_QUANTILES,
                                   pdmc_quantile_levels));

done:
    pdmc_h5_close(group);
    return status;
}

pdmc_status pdmc_identity_write(hid_t file, const pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const int layout[] = {VERSION_MAJOR, VERSION_MINOR}, ranks = 1;
    int program[3] = {0};
    if (results->pdmc_version) sscanf(results->pdmc_version, "%d.%d.%d", &program[0], &program[1], &program[2]);
    PDMC_TRY(pdmc_h5_write_text(file, "filetype", filetype));
    PDMC_TRY(write_integers(file, "version", 2, layout));
    PDMC_TRY(write_integers(file, "pdmc_version", 3, program));
    PDMC_TRY(pdmc_h5_write_text(file, "rng", "Philox4x64-10"));
    PDMC_TRY(write_integers(file, "ranks", 0, &ranks));
    if (pdmc_is_of_plate(results->kind)) PDMC_TRY(write_levels(file));

done:
    return status;
}

static pdmc_status check_filetype(hid_t file, const char *path)
{
    pdmc_status status = PDMC_OK;
    char *found = NULL;
    if (H5Aexists(file, "filetype") <= 0)
        PDMC_FAIL(PDMC_ERR_DATA, "%s: an HDF5 file, but not a result file of pdmc", path);
    PDMC_TRY(pdmc_h5_read_text(file, "filetype", &found));
    if (strcmp(found, filetype) != 0)
        PDMC_FAIL(PDMC_ERR_DATA, "%s: an HDF5 file of type \"%.64s\", not \"%s\"", path, found, filetype);

done:
    pdmc_free(found);
    return status;
}

static pdmc_status check_levels(hid_t file, const char *path)
{
    pdmc_status status = PDMC_OK;
    double levels[PDMC_QUANTILES];
    const hid_t group = H5Gopen2(file, "/statistics", H5P_DEFAULT);
    PDMC_H5_TRY(group, PDMC_ERR_DATA, path);
    PDMC_TRY(pdmc_h5_read_numbers(group, "quantile_levels", H5T_NATIVE_DOUBLE, PDMC_QUANTILES, levels));
    for (int q = 0; q < PDMC_QUANTILES; q++)
        if (levels[q] != pdmc_quantile_levels[q])
            PDMC_FAIL(PDMC_ERR_DATA, "%s: has the quantile %g where %g is expected", path, levels[q],
                      pdmc_quantile_levels[q]);

done:
    pdmc_h5_close(group);
    return status;
}

pdmc_status pdmc_identity_read(hid_t file, const char *path, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    int layout[2], program[3];
    PDMC_TRY(check_filetype(file, path));
    PDMC_TRY(pdmc_h5_read_numbers(file, "version", H5T_NATIVE_INT, 2, layout));
    if (layout[0] != VERSION_MAJOR)
        PDMC_FAIL(PDMC_ERR_DATA, "%s: a result file of version %d.%d; this pdmc reads version %d", path, layout[0],
                  layout[1], VERSION_MAJOR);
    const bool is_of_plate =
        H5Lexists(file, "/explicit", H5P_DEFAULT) <= 0 && H5Lexists(file, "/scalar", H5P_DEFAULT) <= 0 &&
                             H5Lexists(file, "/elastic", H5P_DEFAULT) <= 0 &&
                             H5Lexists(file, "/quadrature", H5P_DEFAULT) <= 0;
    if (is_of_plate) PDMC_TRY(check_levels(file, path)); // others have no quantiles
    PDMC_TRY(pdmc_h5_read_numbers(file, "pdmc_version", H5T_NATIVE_INT, 3, program));
    PDMC_NEW(results->pdmc_version, VERSION_TEXT);
    snprintf(results->pdmc_version, VERSION_TEXT, "%d.%d.%d", program[0], program[1], program[2]);

done:
    return status;
}
