// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#define _XOPEN_SOURCE 700 // nftw(); so this header comes first

/// A folder of their own for the tests that write study files; the names in messages are then short.

#include "check.h"
#include "pdmc/study.h"

#include <ftw.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int enter_folder(void **state)
{
    static char name[] = "/tmp/pdmc_study_XXXXXX";
    if (!mkdtemp(name) || chdir(name) != 0) return -1;
    *state = name;
    return 0;
}

static int remove_entry(const char *path, const struct stat *status, int type, struct FTW *place)
{
    (void)status, (void)type, (void)place;
    return remove(path);
}

static int leave_folder(void **state)
{
    return chdir("/") == 0 ? nftw(*state, remove_entry, 8, FTW_DEPTH | FTW_PHYS) : -1;
}

static inline void write_bytes(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static inline void write_text(const char *path, const char *text)
{
    write_bytes(path, text, strlen(text));
}

static inline pdmc_status read_text(const char *text, pdmc_study *study)
{
    write_text("study.cfg", text);
    return pdmc_study_read("study.cfg", study);
}

/// Line by line what a study is made of, so that a test can replace one line and know its number.
enum {
    LINE_UNITS,
    LINE_PLATE,
    LINE_MATERIAL,
    LINE_CRACKS,
    LINE_LOADS,
    LINE_SUPPORTS,
    LINE_SOLVER,
    LINE_RANDOM,
    LINE_SAMPLING,
    LINE_ENERGY,
    LINE_TOP,
    LINES
};

static inline pdmc_status read_with(int line, const char *replacement, pdmc_study *study)
{
    const char *lines[LINES] = {
        [LINE_UNITS] = "units = { length = \"mm\"; force = \"N\"; };",
        [LINE_PLATE] = "plate = { width = 6.0; height = 4.0; };",
        [LINE_MATERIAL] = "material = { youngs_modulus = 2.0; fracture_energy = 0.5; };",
        [LINE_CRACKS] = "cracks = ( { name = \"a\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );",
        [LINE_LOADS] =
            "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );",
        [LINE_SUPPORTS] = "",
        [LINE_SOLVER] = "",
        [LINE_RANDOM] = "",
        [LINE_SAMPLING] = "",
        [LINE_ENERGY] = "",
        [LINE_TOP] = "",
    };
    lines[line] = replacement;
    char text[2048] = "";
    for (int i = 0; i < LINES; i++) {
        strcat(text, lines[i]);
        strcat(text, "\n");
    }
    return read_text(text, study);
}
