// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The words in which sections and settings are written: bits of choices, and where values are kept.

#include "study/study_impl.h"

#define ONLY(quantity) (1U << (quantity))
#define IN_ELASTIC(field) offsetof(pdmc_elastic, field)
#define OF(kind) .kinds = ONLY(kind)
