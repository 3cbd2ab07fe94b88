// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Status codes and the last error.
///
/// Every fallible function returns a pdmc_status. On failure the message, a sentence with the offending value in it,
/// is kept per thread and read with pdmc_last_error(). The library never prints, exits or aborts.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PDMC_API __attribute__((visibility("default")))
#define PDMC_NODISCARD __attribute__((warn_unused_result))

#define PDMC_STATUS_LIST(X)                                                                                            \
    X(PDMC_OK, "success")                                                                                              \
    X(PDMC_ERR_ARG, "argument outside its domain")                                                                     \
    X(PDMC_ERR_CONFIG, "bad study file")                                                                               \
    X(PDMC_ERR_NO_INPUT, "no such input")                                                                              \
    X(PDMC_ERR_DATA, "bad data")                                                                                       \
    X(PDMC_ERR_CREATE, "cannot create the output")                                                                     \
    X(PDMC_ERR_IO, "input or output failed")                                                                           \
    X(PDMC_ERR_SINGULAR, "the system cannot be solved")                                                                \
    X(PDMC_ERR_INTERRUPTED, "stopped early")                                                                           \
    X(PDMC_ERR_NOMEM, "out of memory")                                                                                 \
    X(PDMC_ERR_EXTERN, "an external library failed")

#define PDMC_STATUS_NAME(name, text) name,
typedef enum { PDMC_STATUS_LIST(PDMC_STATUS_NAME) } pdmc_status;
#undef PDMC_STATUS_NAME

/// The text of a status code; never NULL.
PDMC_API const char *pdmc_status_string(pdmc_status status);

/// The message of this thread's last failure; "" if there was none. Valid until the thread's next failure.
PDMC_API const char *pdmc_last_error(void);

/// The library's version, "major.minor.patch".
PDMC_API const char *pdmc_version(void);

/// The git commit the library was built from, "" where it was not built from a checkout.
PDMC_API const char *pdmc_git_sha1(void);
