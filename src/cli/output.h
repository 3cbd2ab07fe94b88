// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits.h>
#include <stdbool.h>

/// The name of the results of a study: "folder/name.cfg" gives "name.h5".
void default_output(const char *study, char path[PATH_MAX]);

/// Finds, before the run, what would keep its results from being written, and reports it to standard error.
/// @param[in] force  whether a file there may be overwritten
/// @return the exit code, 0 where the output can be created
int check_output(const char *study, const char *path, bool force);
