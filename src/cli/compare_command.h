// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"

/// pdmc compare A B: prints two results side by side, and draws their densities. Returns the exit code.
int compare_command(const arguments *given);
