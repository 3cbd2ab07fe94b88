// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a view writes: into a stream, and as pictures.

#include "pdmc/views.h"

#include "check.h"
#include "results/scratch.h"

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

static inline void expect_line(const char *text, const char *line)
{
    if (!strstr(text, line)) fail_msg("\"%s\" is not in\n%s", line, text);
}

/// Draws, and looks that there are just these pictures, each as PNG and as SVG. Skips the test where nothing draws.
static inline void check_drawn(const pdmc_results *results, int count, const char *const names[])
{
    static const char *const endings[] = {"png", "svg"};
    if (system("gnuplot --version >/dev/null 2>&1") != 0) skip();
    CHECK_OK(pdmc_view_plot(results, scratch_path("plots")));
    for (int i = 0; i < 2 * count; i++) {
        size_t size = 0;
        char path[64];
        snprintf(path, sizeof path, "plots/%s.%s", names[i / 2], endings[i % 2]);
        char *bytes = scratch_read(scratch_path(path), &size);
        if (!bytes || size < 1000) fail_msg("%s is missing or empty", path);
        free(bytes);
    }
    assert_int_equal(scratch_empty(scratch_path("plots")), 2 * count);
    scratch_empty(scratch);
}

/// A stream that takes nothing, as a full disk.
static inline void check_full(view *show, const pdmc_results *results)
{
    FILE *full = fopen("/dev/full", "w");
    if (!full) skip();
    CHECK_STATUS(show(results, full), PDMC_ERR_IO);
    fclose(full);
}
