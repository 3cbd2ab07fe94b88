// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"

/// pdmc STUDY: runs a study and writes its result file. Returns the exit code.
int run_command(const arguments *given);

/// pdmc check STUDY: prints the resolved study and its cost. Returns the exit code.
int check_command(const arguments *given);
