// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include "base/base_impl.h"

#include <string.h>

char *pdmc_study_path(const pdmc_study_reader *reader, pdmc_study_address address, const char *name)
{
    int line;
    const config_setting_t *setting = pdmc_study_locate(reader, address);
    const char *file = pdmc_study_source_place(reader->source, config_setting_source_line(setting), &line);
    const char *slash = *name == '/' ? NULL : strrchr(file, '/');
    const size_t folder = slash ? (size_t)(slash - file) + 1 : 0;
    char *path = pdmc_calloc(folder + strlen(name) + 1, 1);
    if (!path) return NULL;
    memcpy(path, file, folder);
    memcpy(&path[folder], name, strlen(name));
    return path;
}
