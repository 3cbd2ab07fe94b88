// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What says that a file is a result file, of which version, and how to read its numbers.

#include "pdmc/results.h"

#include <hdf5.h>

pdmc_status pdmc_identity_write(hid_t file, const pdmc_results *results);

/// Refuses a file of another kind, another major version or other quantiles; reads the version of the program.
/// @param[in] path  for the messages
pdmc_status pdmc_identity_read(hid_t file, const char *path, pdmc_results *results);
