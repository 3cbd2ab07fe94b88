// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the views of an elastic study share.

#include "views/views_impl.h"

#include "pdmc/solid.h"

extern const char *const pdmc_face_names[PDMC_SOLID_FACES];
