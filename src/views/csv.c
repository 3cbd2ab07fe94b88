// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/csv.h"

#include <string.h>

void pdmc_csv_text(FILE *stream, const char *text)
{
    const bool quoted = strpbrk(text, ",\"\r\n") != NULL;
    if (quoted) fputc('"', stream);
    for (const char *c = text; *c; c++) {
        if (*c == '"') fputc('"', stream);
        fputc(*c, stream);
    }
    if (quoted) fputc('"', stream);
}

void pdmc_csv_column(FILE *stream, const char *name, const char *unit)
{
    char column[PDMC_UNIT_SIZE + PDMC_NAME_SIZE + 48];
    snprintf(column, sizeof column, "%s[%s]", name, unit);
    fputc(',', stream);
    pdmc_csv_text(stream, column);
}

void pdmc_csv_axes(FILE *stream, const char *name, const char *what, const char *unit)
{
    char column[PDMC_LONG_NAME_SIZE + 16];
    for (int k = 0; k < 3; k++) {
        snprintf(column, sizeof column, "%s%s.%c", name, what, "xyz"[k]);
        pdmc_csv_column(stream, column, unit);
    }
}

void pdmc_csv_number(FILE *stream, double x)
{
    fprintf(stream, ",%.17g", x);
}

void pdmc_csv_numbers(FILE *stream, int count, const double x[])
{
    for (int i = 0; i < count; i++) pdmc_csv_number(stream, x[i]);
}
