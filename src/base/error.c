// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"

#include <stdarg.h>
#include <stdio.h>

static _Thread_local char last_error[1024];

pdmc_status pdmc_raise(pdmc_status status, const char *format, ...)
{
    // Through a buffer of its own, since the arguments may point into the previous message.
    char message[sizeof last_error];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    snprintf(last_error, sizeof last_error, "%s", message);
    return status;
}

const char *pdmc_last_error(void)
{
    return last_error;
}

const char *pdmc_status_string(pdmc_status status)
{
#define PDMC_STATUS_TEXT(name, text) [name] = text,
    static const char *const texts[] = {PDMC_STATUS_LIST(PDMC_STATUS_TEXT)};
#undef PDMC_STATUS_TEXT
    const size_t count = sizeof texts / sizeof texts[0];
    return (size_t)status < count ? texts[status] : "unknown status";
}

const char *pdmc_version(void)
{
    return PDMC_VERSION;
}

const char *pdmc_git_sha1(void)
{
    return PDMC_GIT_SHA1;
}
