// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A folder of a test's own, and what is left in it.

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char scratch[] = "/tmp/pdmc-test-XXXXXX";

static inline int scratch_make(void **state)
{
    (void)state;
    return mkdtemp(scratch) ? 0 : -1;
}

/// The path of a file in the folder; the last eight stay valid.
static inline const char *scratch_path(const char *name)
{
    static char paths[8][512];
    static int next;
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", scratch, name);
    return path;
}

/// Removes the files in a folder and says how many there were.
static inline int scratch_empty(const char *folder)
{
    int count = 0;
    DIR *entries = opendir(folder);
    for (struct dirent *entry; entries && (entry = readdir(entries));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        char path[1024];
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (unlink(path) != 0) {
            scratch_empty(path);
            rmdir(path);
        }
        count++;
    }
    if (entries) closedir(entries);
    return count;
}

static inline int scratch_remove(void **state)
{
    (void)state;
    scratch_empty(scratch);
    return rmdir(scratch);
}

/// The bytes of a file, with a zero behind them; free with free().
static inline char *scratch_read(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file) return NULL;
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *bytes = malloc(*size + 1);
    if (bytes && fread(bytes, 1, *size, file) != *size) *size = 0;
    if (bytes) bytes[*size] = '\0';
    fclose(file);
    return bytes;
}

static inline void scratch_write(const char *path, size_t size, const char bytes[])
{
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(bytes, 1, size, file) != size) abort();
    fclose(file);
}
