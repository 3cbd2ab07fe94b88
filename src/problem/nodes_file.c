// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/nodes_file.h"

#include "base/base_impl.h"
#include "problem/columns.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    pdmc_node node;
    int line;
} entry;

static int by_place(const void *a, const void *b)
{
    const entry *p = a, *q = b;
    for (int k = 0; k < PDMC_AXES; k++)
        if (p->node.x[k] != q->node.x[k]) return p->node.x[k] < q->node.x[k] ? -1 : 1;
    return (p->line > q->line) - (p->line < q->line);
}

/// Sorts the entries.
static pdmc_status check_places(const char *path, int count, entry entries[])
{
    qsort(entries, (size_t)count, sizeof *entries, by_place);
    for (int k = 1; k < count; k++) {
        const entry *e = &entries[k], *before = e - 1;
        if (memcmp(e->node.x, before->node.x, sizeof e->node.x) == 0)
            return pdmc_raise(PDMC_ERR_DATA, "%s:%d: the node is in the place of that of line %d", path, e->line,
                              before->line);
    }
    return PDMC_OK;
}

pdmc_status pdmc_nodes_read(const char *path, int dimension, int *count, pdmc_node **nodes)
{
    pdmc_status status = PDMC_OK;
    pdmc_columns lines = {0};
    entry *entries = NULL;
    pdmc_node *made = NULL;
    *count = 0;
    *nodes = NULL;
    PDMC_TRY(pdmc_columns_read(path, dimension + 1, "node",
                               dimension == 2 ? "three numbers, x y volume" : "four numbers, x y z volume", &lines));
    PDMC_NEW(entries, lines.count);
    PDMC_NEW(made, lines.count);
    for (int k = 0; k < lines.count; k++) {
        const double *numbers = &lines.number[(size_t)k * (size_t)lines.columns];
        if (!(numbers[dimension] > 0.0))
            PDMC_FAIL(PDMC_ERR_DATA, "%s:%d: the volume is %g, must be > 0", path, lines.line[k], numbers[dimension]);
        made[k].volume = numbers[dimension];
        memcpy(made[k].x, numbers, (size_t)dimension * sizeof *numbers);
        entries[k] = (entry){made[k], lines.line[k]};
    }
    PDMC_TRY(check_places(path, lines.count, entries));
    *count = lines.count;
    *nodes = made;
    made = NULL;
done:
    pdmc_free(made);
    pdmc_free(entries);
    pdmc_columns_clear(&lines);
    return status;
}
