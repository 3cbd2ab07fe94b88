// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/columns.h"

#include "base/base_impl.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COLUMNS = 4 };

typedef struct {
    const char *path, *noun, *form;
    int line, room;
    pdmc_columns rows;
} reading;

static pdmc_status make_room(reading *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_columns *rows = &r->rows, larger = {.columns = rows->columns, .count = rows->count};
    const size_t width = (size_t)rows->columns;
    if (rows->count < r->room) return PDMC_OK;
    if (r->room > INT32_MAX / 4) return pdmc_raise(PDMC_ERR_DATA, "%s: more than %d lines", r->path, r->room);
    r->room = 2 * r->room + 1024;
    PDMC_NEW(larger.number, (size_t)r->room * width);
    PDMC_NEW(larger.line, r->room);
    if (rows->count > 0) {
        memcpy(larger.number, rows->number, (size_t)rows->count * width * sizeof *larger.number);
        memcpy(larger.line, rows->line, (size_t)rows->count * sizeof *larger.line);
    }
    pdmc_columns_clear(rows);
    *rows = larger;
    larger = (pdmc_columns){0};
done:
    pdmc_columns_clear(&larger);
    return status;
}

/// @return how many numbers the text has, at most `most`; -1 where it has something else
static int read_numbers(char *text, int most, double numbers[])
{
    int count = 0;
    char *rest = NULL;
    for (char *word = strtok_r(text, " \t\r\n", &rest); word; word = strtok_r(NULL, " \t\r\n", &rest)) {
        char *end;
        const double number = strtod(word, &end);
        if (*end || count == most) return -1;
        numbers[count++] = number;
    }
    return count;
}

static pdmc_status add_line(reading *r, char *text)
{
    double numbers[MOST_COLUMNS];
    pdmc_columns *rows = &r->rows;
    text[strcspn(text, "#")] = '\0';
    const int count = read_numbers(text, rows->columns, numbers);
    if (count == 0) return PDMC_OK;
    if (count != rows->columns)
        return pdmc_raise(PDMC_ERR_DATA, "%s:%d: is no %s, must be %s", r->path, r->line, r->noun, r->form);
    for (int k = 0; k < count; k++)
        if (!isfinite(numbers[k]))
            return pdmc_raise(PDMC_ERR_DATA, "%s:%d: %g, must be finite", r->path, r->line, numbers[k]);
    const pdmc_status status = make_room(r);
    if (status != PDMC_OK) return status;
    memcpy(&rows->number[(size_t)rows->count * (size_t)count], numbers, (size_t)count * sizeof *numbers);
    rows->line[rows->count++] = r->line;
    return PDMC_OK;
}

static pdmc_status read_lines(reading *r, FILE *file)
{
    pdmc_status status = PDMC_OK;
    char *text = NULL;
    size_t size = 0;
    while (status == PDMC_OK && getline(&text, &size, file) >= 0) {
        r->line++;
        status = add_line(r, text);
    }
    free(text);
    if (status == PDMC_OK && ferror(file)) status = pdmc_raise(PDMC_ERR_NO_INPUT, "%s: %s", r->path, strerror(errno));
    if (status == PDMC_OK && r->rows.count == 0) status = pdmc_raise(PDMC_ERR_DATA, "%s: has no %s", r->path, r->noun);
    return status;
}

pdmc_status pdmc_columns_read(const char *path, int columns, const char *noun, const char *form, pdmc_columns *out)
{
    pdmc_status status = PDMC_OK;
    reading r = {.path = path, .noun = noun, .form = form, .rows.columns = columns};
    *out = (pdmc_columns){0};
    PDMC_REQUIRE(1 <= columns && columns <= MOST_COLUMNS, "%d columns are not from 1 to %d", columns, MOST_COLUMNS);
    FILE *file = fopen(path, "r");
    if (!file) PDMC_FAIL(PDMC_ERR_NO_INPUT, "%s: %s", path, strerror(errno));
    PDMC_TRY(read_lines(&r, file));
    *out = r.rows;
    r.rows = (pdmc_columns){0};
done:
    if (file) fclose(file);
    pdmc_columns_clear(&r.rows);
    return status;
}

void pdmc_columns_clear(pdmc_columns *columns)
{
    pdmc_free(columns->number);
    pdmc_free(columns->line);
    *columns = (pdmc_columns){0};
}
