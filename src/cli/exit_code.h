// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/base.h"

/// The exit code for a status, as in <sysexits.h>: 0 done, 64 usage, 65 bad data, 66 no input, 70 internal, 73 cannot
/// create, 74 input or output, 75 stopped early with everything saved, 78 bad study file.
int exit_code(pdmc_status status);

/// Of a study that stopped at its most samples without the precision that it asks for; everything is saved. No number of
/// <sysexits.h> means that.
enum { EXIT_SAMPLE_CAP = 3 };

/// Prints "pdmc: " and the last error to standard error and returns its exit code.
int fail(pdmc_status status);
