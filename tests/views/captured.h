// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a view writes into a stream.

#include "pdmc/views.h"

#include "check.h"

#include <stdlib.h>

typedef pdmc_status view(const pdmc_results *results, FILE *stream);

/// Free with free().
static inline char *captured(view *show, const pdmc_results *results)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(show(results, stream));
    fclose(stream);
    return text;
}

/// A stream that takes nothing, as a full disk.
static inline void check_full(view *show, const pdmc_results *results)
{
    FILE *full = fopen("/dev/full", "w");
    if (!full) skip();
    CHECK_STATUS(show(results, full), PDMC_ERR_IO);
    fclose(full);
}
