// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <unistd.h>

void default_output(const char *study, char path[PATH_MAX])
{
    const char *slash = strrchr(study, '/'), *name = slash ? slash + 1 : study, *dot = strrchr(name, '.');
    const size_t length = dot && dot != name ? (size_t)(dot - name) : strlen(name);
    snprintf(path, PATH_MAX, "%.*s.h5", (int)length, name);
}

static int refuse(const char *path, const char *what, const char *why)
{
    fprintf(stderr, "pdmc: %s: %s%s%s\n", path, what, *why ? ": " : "", why);
    return EX_CANTCREAT;
}

static int check_existing(const struct stat *target, const char *study, const char *path, bool force)
{
    struct stat source;
    if (S_ISDIR(target->st_mode)) return refuse(path, "is a folder, not a file", "");
    if (!S_ISREG(target->st_mode)) return refuse(path, "is a device or the like, not a file", "");
    if (stat(study, &source) == 0 && source.st_dev == target->st_dev && source.st_ino == target->st_ino)
        return refuse(path, "is the study itself; -o FILE writes elsewhere", "");
    return force ? EX_OK : refuse(path, "exists already; --force overwrites it, -o FILE writes elsewhere", "");
}

// Only a file that was created shows that one can be: root passes every test of permissions, /proc takes no files. Its
// name is as long as that of the temporary file by which results are written.
static int try_to_create(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const size_t size = strlen(path) + 32;
    char *probe = malloc(size);
    if (!probe) return refuse(path, "out of memory", "");
    snprintf(probe, size, "%.*s.%s.pdmc-XXXXXXXXXX", (int)(name - path), path, name);
    const int descriptor = mkstemp(probe), error = errno;
    if (descriptor >= 0) {
        close(descriptor);
        unlink(probe);
    }
    free(probe);
    if (descriptor >= 0) return EX_OK;
    return refuse(path, "cannot be created",
                  error == ENOENT ? "there is no such folder, or it takes no files" : strerror(error));
}

int check_output(const char *study, const char *path, bool force)
{
    struct stat target;
    const size_t length = strlen(path);
    if (length > 0 && path[length - 1] == '/') return refuse(path, "is the name of a folder, not of a file", "");
    const int code = stat(path, &target) == 0 ? check_existing(&target, study, path, force) : EX_OK;
    return code == EX_OK ? try_to_create(path) : code;
}
