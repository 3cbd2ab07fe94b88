// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A file that appears under its name only when it is whole: written under a temporary name in the same folder, synced,
/// then renamed. Whatever fails or is killed, the name holds the old file or the new one, never a part.

#include "pdmc/base.h"

typedef struct {
    char *path;
    char *temporary; // ".<name>.pdmc-<process>-<number>" in the folder of path; NULL once the file has appeared
    int descriptor;  // of the temporary file, open for writing
} pdmc_whole_file;

/// Makes the temporary file.
/// @param[in]  overwrite  false: a file that exists is refused, now and when it is to appear
/// @param[out] file       to be discarded, also after a failure
pdmc_status pdmc_whole_file_open(const char *path, bool overwrite, pdmc_whole_file *file);

/// Writes bytes at the end of the temporary file.
pdmc_status pdmc_whole_file_write(pdmc_whole_file *file, size_t size, const void *bytes);

/// Syncs the temporary file and lets it appear.
pdmc_status pdmc_whole_file_appear(pdmc_whole_file *file, bool overwrite);

/// Frees everything, and removes the temporary file unless it has appeared. A zeroed file is allowed.
void pdmc_whole_file_discard(pdmc_whole_file *file);

/// Records why a file cannot be written, from errno's value. Without permission, folder or a free name the status is
/// PDMC_ERR_CREATE, else PDMC_ERR_IO.
pdmc_status pdmc_raise_errno(const char *path, int error);
