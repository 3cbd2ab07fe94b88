// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/base.h"

/// Records a message for pdmc_last_error() and returns `status`, so that it can be returned in turn.
pdmc_status pdmc_raise(pdmc_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Before anything is owned: returns PDMC_ERR_ARG with the message unless the condition holds.
#define PDMC_REQUIRE(condition, ...)                                                                                   \
    do {                                                                                                               \
        if (!(condition)) return pdmc_raise(PDMC_ERR_ARG, __VA_ARGS__);                                                \
    } while (0)

/// Records the message and jumps to the function's one exit, `done:`, which frees and returns `status`.
#define PDMC_FAIL(code, ...)                                                                                           \
    do {                                                                                                               \
        status = pdmc_raise((code), __VA_ARGS__);                                                                      \
        goto done;                                                                                                     \
    } while (0)

/// Jumps to `done:` if the call failed.
#define PDMC_TRY(call)                                                                                                 \
    do {                                                                                                               \
        if ((status = (call)) != PDMC_OK) goto done;                                                                   \
    } while (0)

/// Zeroed memory for `count` elements, aligned to 64 bytes, or NULL with the failure recorded (count = 0 gives one
/// element). Free with pdmc_free().
void *pdmc_calloc(size_t count, size_t size);

/// As pdmc_calloc(), jumping to `done:` with PDMC_ERR_NOMEM where there is no memory.
#define PDMC_NEW(pointer, count)                                                                                       \
    do {                                                                                                               \
        (pointer) = pdmc_calloc((size_t)(count), sizeof *(pointer));                                                   \
        if (!(pointer)) {                                                                                              \
            status = PDMC_ERR_NOMEM;                                                                                   \
            goto done;                                                                                                 \
        }                                                                                                              \
    } while (0)

/// A copy of a string, or NULL with the failure recorded. Free with pdmc_free().
char *pdmc_strdup(const char *text);

/// NULL is allowed.
void pdmc_free(void *pointer);

extern long pdmc_alloc_countdown; // tests only: allocations left before refusal, < 0 for no limit
extern int pdmc_alloc_refused;    // tests only: how many were refused

/// Makes OpenBLAS run on the calling thread alone. Its results can change with its number of threads, and its threads
/// fight with ours: it is called from our own parallel loops, over blocks whose shape does not depend on the number of
/// threads. Process-wide, and harmless to repeat; but OpenBLAS asks
/// OpenMP for the number, so that omp_get_max_threads() is 1 from here on and must not be set to another, and a call inside
/// a parallel region holds to its end only.
void pdmc_blas_prepare(void);

/// Before a function: versions of it for processors with longer vectors, chosen when the library is loaded, as in
/// PDMC_VECTORS("avx512f"). They do the same operations in the same order, without contraction, so that the results do not
/// depend on which one runs.
#if defined(__x86_64__) && defined(__gnu_linux__)
#define PDMC_VECTORS(...) __attribute__((target_clones("default", __VA_ARGS__)))
#else
#define PDMC_VECTORS(...)
#endif

/// Seconds of a clock that only runs forward.
double pdmc_seconds(void);
