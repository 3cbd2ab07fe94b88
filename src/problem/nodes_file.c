// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/nodes_file.h"

#include "base/base_impl.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    pdmc_node node;
    int line;
} entry;

typedef struct {
    const char *path;
    int dimension, line, count, room;
    entry *entries; // [room]
} list;

static pdmc_status make_room(list *l)
{
    if (l->count < l->room) return PDMC_OK;
    if (l->room > INT32_MAX / 4) return pdmc_raise(PDMC_ERR_DATA, "%s: more than %d nodes", l->path, l->room);
    entry *larger = pdmc_calloc(2 * (size_t)l->room + 1024, sizeof *larger);
    if (!larger) return PDMC_ERR_NOMEM;
    if (l->count > 0) memcpy(larger, l->entries, (size_t)l->count * sizeof *larger);
    pdmc_free(l->entries);
    l->entries = larger;
    l->room = 2 * l->room + 1024;
    return PDMC_OK;
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

static pdmc_status check_numbers(const list *l, const double numbers[])
{
    for (int k = 0; k <= l->dimension; k++)
        if (!isfinite(numbers[k]))
            return pdmc_raise(PDMC_ERR_DATA, "%s:%d: %g, must be finite", l->path, l->line, numbers[k]);
    if (!(numbers[l->dimension] > 0.0))
        return pdmc_raise(PDMC_ERR_DATA, "%s:%d: the volume is %g, must be > 0", l->path, l->line,
                          numbers[l->dimension]);
    return PDMC_OK;
}

static pdmc_status add_line(list *l, char *text)
{
    double numbers[PDMC_AXES + 1];
    text[strcspn(text, "#")] = '\0';
    const int count = read_numbers(text, l->dimension + 1, numbers);
    if (count == 0) return PDMC_OK;
    if (count != l->dimension + 1)
        return pdmc_raise(PDMC_ERR_DATA, "%s:%d: is no node, must be %s", l->path, l->line,
                          l->dimension == 2 ? "three numbers, x y volume" : "four numbers, x y z volume");
    pdmc_status status = check_numbers(l, numbers);
    if (status == PDMC_OK) status = make_room(l);
    if (status != PDMC_OK) return status;
    entry *e = &l->entries[l->count++];
    *e = (entry){.line = l->line, .node.volume = numbers[l->dimension]};
    memcpy(e->node.x, numbers, (size_t)l->dimension * sizeof *numbers);
    return PDMC_OK;
}

static pdmc_status read_lines(list *l, FILE *file)
{
    pdmc_status status = PDMC_OK;
    char *text = NULL;
    size_t size = 0;
    while (status == PDMC_OK && getline(&text, &size, file) >= 0) {
        l->line++;
        status = add_line(l, text);
    }
    free(text);
    if (status == PDMC_OK && ferror(file)) status = pdmc_raise(PDMC_ERR_NO_INPUT, "%s: %s", l->path, strerror(errno));
    if (status == PDMC_OK && l->count == 0) status = pdmc_raise(PDMC_ERR_DATA, "%s: has no node", l->path);
    return status;
}

static int by_place(const void *a, const void *b)
{
    const entry *p = a, *q = b;
    for (int k = 0; k < PDMC_AXES; k++)
        if (p->node.x[k] != q->node.x[k]) return p->node.x[k] < q->node.x[k] ? -1 : 1;
    return (p->line > q->line) - (p->line < q->line);
}

/// Sorts the entries.
static pdmc_status check_places(const list *l)
{
    qsort(l->entries, (size_t)l->count, sizeof *l->entries, by_place);
    for (int k = 1; k < l->count; k++) {
        const entry *e = &l->entries[k], *before = e - 1;
        if (memcmp(e->node.x, before->node.x, sizeof e->node.x) == 0)
            return pdmc_raise(PDMC_ERR_DATA, "%s:%d: the node is in the place of that of line %d", l->path, e->line,
                              before->line);
    }
    return PDMC_OK;
}

pdmc_status pdmc_nodes_read(const char *path, int dimension, int *count, pdmc_node **nodes)
{
    pdmc_status status = PDMC_OK;
    list l = {.path = path, .dimension = dimension};
    *count = 0;
    *nodes = NULL;
    FILE *file = fopen(path, "r");
    if (!file) PDMC_FAIL(PDMC_ERR_NO_INPUT, "%s: %s", path, strerror(errno));
    PDMC_TRY(read_lines(&l, file));
    PDMC_NEW(*nodes, l.count);
    for (int k = 0; k < l.count; k++) (*nodes)[k] = l.entries[k].node;
    PDMC_TRY(check_places(&l));
    *count = l.count;
done:
    if (status != PDMC_OK) {
        pdmc_free(*nodes);
        *nodes = NULL;
    }
    if (file) fclose(file);
    pdmc_free(l.entries);
    return status;
}
