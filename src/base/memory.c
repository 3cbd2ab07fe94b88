// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"

#include <stdlib.h>
#include <string.h>

long pdmc_alloc_countdown = -1;
int pdmc_alloc_refused;

enum { ALIGNMENT = 64 }; // a cache line, and the widest vector register

void *pdmc_calloc(size_t count, size_t size)
{
    const size_t total = count > 0 ? count : 1;
    void *pointer = NULL;
    if (pdmc_alloc_countdown == 0) {
        pdmc_alloc_refused++;
    } else if (size <= (SIZE_MAX - ALIGNMENT) / total) {
        if (pdmc_alloc_countdown > 0) pdmc_alloc_countdown--;
        const size_t bytes = (total * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        pointer = aligned_alloc(ALIGNMENT, bytes);
        if (pointer) memset(pointer, 0, bytes);
    }
    if (!pointer) pdmc_raise(PDMC_ERR_NOMEM, "out of memory: %zu elements of %zu bytes", count, size);
    return pointer;
}

char *pdmc_strdup(const char *text)
{
    const size_t length = strlen(text) + 1;
    char *copy = pdmc_calloc(length, 1);
    if (copy) memcpy(copy, text, length);
    return copy;
}

void pdmc_free(void *pointer)
{
    free(pointer);
}
