// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/whole_file.h"

#include "base/base_impl.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

pdmc_status pdmc_raise_errno(const char *path, int error)
{
    char text[128];
    switch (error) {
    case ENOENT:
    case ENOTDIR: return pdmc_raise(PDMC_ERR_CREATE, "%s: no such folder", path);
    case EACCES:
    case EPERM: return pdmc_raise(PDMC_ERR_CREATE, "%s: no permission to write in this folder", path);
    case EROFS: return pdmc_raise(PDMC_ERR_CREATE, "%s: the file system is read-only", path);
    case EISDIR: return pdmc_raise(PDMC_ERR_CREATE, "%s: is a folder", path);
    case EEXIST: return pdmc_raise(PDMC_ERR_CREATE, "%s: exists already; --force overwrites it", path);
    case ENOSPC: return pdmc_raise(PDMC_ERR_IO, "%s: the disk is full; nothing was written", path);
    case EDQUOT: return pdmc_raise(PDMC_ERR_IO, "%s: the disk quota is used up; nothing was written", path);
    case EFBIG:
        return pdmc_raise(PDMC_ERR_IO, "%s: larger than files may be here (ulimit -f); nothing was written", path);
    default: break;
    }
    if (strerror_r(error, text, sizeof text) != 0) snprintf(text, sizeof text, "error %d", error);
    return pdmc_raise(PDMC_ERR_IO, "%s: %s; nothing was written", path, text);
}

static pdmc_status refuse_target(const char *path, bool overwrite)
{
    struct stat target;
    if (stat(path, &target) != 0) return PDMC_OK;
    if (S_ISDIR(target.st_mode)) return pdmc_raise_errno(path, EISDIR);
    return overwrite ? PDMC_OK : pdmc_raise_errno(path, EEXIST);
}

static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

/// Not mkstemp(), which would withhold the file from everybody but its owner whatever the umask.
static int open_temporary(const char *path, size_t size, char temporary[])
{
    const size_t folder = folder_length(path);
    int descriptor = -1;
    for (int i = 0; descriptor < 0 && i < 1000; i++) {
        snprintf(temporary, size, "%.*s.%s.pdmc-%ld-%d", (int)folder, path, path + folder, (long)getpid(), i);
        descriptor = open(temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno != EEXIST) break;
    }
    return descriptor;
}

pdmc_status pdmc_whole_file_open(const char *path, bool overwrite, pdmc_whole_file *file)
{
    pdmc_status status = PDMC_OK;
    char *temporary = NULL;
    *file = (pdmc_whole_file){.descriptor = -1};
    PDMC_REQUIRE(path[0] != '\0', "the name of the file is empty");
    PDMC_TRY(refuse_target(path, overwrite));

    const size_t size = strlen(path) + 64;
    PDMC_NEW(temporary, size);
    if (!(file->path = pdmc_strdup(path))) {
        status = PDMC_ERR_NOMEM;
        goto done;
    }
    file->descriptor = open_temporary(path, size, temporary);
    if (file->descriptor < 0) {
        status = pdmc_raise_errno(path, errno);
        goto done;
    }
    file->temporary = temporary;
    temporary = NULL;

done:
    pdmc_free(temporary);
    return status;
}

pdmc_status pdmc_whole_file_write(pdmc_whole_file *file, size_t size, const void *bytes)
{
    const char *next = bytes;
    while (size > 0) {
        const ssize_t written = write(file->descriptor, next, size);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return pdmc_raise_errno(file->path, errno);
        next += written;
        size -= (size_t)written;
    }
    return PDMC_OK;
}

/// For file systems without hard links: the name is claimed by an empty file, which fails where it exists.
static int claim_and_rename(const pdmc_whole_file *file)
{
    const int claim = open(file->path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (claim < 0) return -1;
    close(claim);
    return rename(file->temporary, file->path);
}

/// rename() would replace a file that appeared meanwhile; link() does not.
static int appear_as_new(const pdmc_whole_file *file)
{
    if (link(file->temporary, file->path) == 0) return unlink(file->temporary);
    if (errno == EEXIST) return -1;
    return claim_and_rename(file);
}

/// A failure is ignored: the file is whole and has its name, and some file systems refuse to sync folders.
static void sync_folder(const char *path, char folder[])
{
    const size_t length = folder_length(path);
    snprintf(folder, length + 2, "%.*s", length > 0 ? (int)length : 1, length > 0 ? path : ".");
    const int descriptor = open(folder, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

pdmc_status pdmc_whole_file_appear(pdmc_whole_file *file, bool overwrite)
{
    if (fsync(file->descriptor) != 0) return pdmc_raise_errno(file->path, errno);
    const int failed = overwrite ? rename(file->temporary, file->path) : appear_as_new(file);
    if (failed) return pdmc_raise_errno(file->path, errno);
    sync_folder(file->path, file->temporary); // the name of the temporary is free to be written over
    pdmc_free(file->temporary);
    file->temporary = NULL;
    return PDMC_OK;
}

void pdmc_whole_file_discard(pdmc_whole_file *file)
{
    if (file->path && file->descriptor >= 0) close(file->descriptor);
    if (file->temporary) unlink(file->temporary);
    pdmc_free(file->temporary);
    pdmc_free(file->path);
    *file = (pdmc_whole_file){0};
}
