// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include "base/base_impl.h"

#include <stdlib.h>
#include <string.h>

pdmc_status pdmc_study_text_open(pdmc_study_text *text)
{
    text->out = open_memstream(&text->bytes, &text->size);
    return text->out ? PDMC_OK : pdmc_raise(PDMC_ERR_NOMEM, "out of memory: a text of the study");
}

pdmc_status pdmc_study_text_close(pdmc_study_text *text)
{
    const bool lost = ferror(text->out);
    const bool closed = fclose(text->out) == 0;
    text->out = NULL;
    return closed && !lost ? PDMC_OK : pdmc_raise(PDMC_ERR_NOMEM, "out of memory: a text of the study");
}

pdmc_status pdmc_study_text_copy(const pdmc_study_text *text, char **copy)
{
    *copy = pdmc_strdup(text->bytes);
    return *copy ? PDMC_OK : PDMC_ERR_NOMEM;
}

void pdmc_study_text_drop(pdmc_study_text *text)
{
    if (text->out) fclose(text->out);
    free(text->bytes);
    *text = (pdmc_study_text){0};
}

void pdmc_study_print_real(FILE *out, double x)
{
    char digits[40];
    for (int precision = 15; precision <= 17; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, x);
        if (strtod(digits, NULL) == x) break;
    }
    const bool whole = strspn(digits, "-0123456789") == strlen(digits);
    fprintf(out, whole ? "%s.0" : "%s", digits);
}
