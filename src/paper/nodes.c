// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/nodes.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <math.h>

static const double aside = 1e-6; // of the spacing

static int cells(double length, double spacing)
{
    const int count = (int)lround(length / spacing);
    return count > 1 ? count : 1;
}

static const pdmc_crack *crack_through(const pdmc_problem *problem, const double x[2])
{
    for (int c = 0; c < problem->crack_count; c++) {
        const pdmc_crack *crack = &problem->cracks[c];
        if (pdmc_point_segment_distance(x, crack->from, crack->to) <= aside * problem->solver.spacing) return crack;
    }
    return NULL;
}

static void add(pdmc_paper_nodes *nodes, double x, double y)
{
    nodes->x[2 * nodes->count] = x;
    nodes->x[2 * nodes->count + 1] = y;
    nodes->count++;
}

static void add_node(const pdmc_problem *problem, const double x[2], pdmc_paper_nodes *nodes)
{
    const pdmc_crack *crack = crack_through(problem, x);
    if (!crack) {
        add(nodes, x[0], x[1]);
        return;
    }
    const double d[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]};
    const double step = 2.0 * aside * problem->solver.spacing / hypot(d[0], d[1]);
    add(nodes, x[0] - step * d[1], x[1] + step * d[0]);
    add(nodes, x[0] + step * d[1], x[1] - step * d[0]);
}

pdmc_status pdmc_paper_nodes_create(const pdmc_problem *problem, pdmc_paper_nodes *nodes)
{
    pdmc_status status = PDMC_OK;
    const pdmc_plate *plate = &problem->plate;
    const int nx = cells(plate->width, problem->solver.spacing), ny = cells(plate->height, problem->solver.spacing);
    *nodes = (pdmc_paper_nodes){0};
    PDMC_NEW(nodes->x, 2 * 2 * (nx + 1) * (ny + 1));
    for (int j = 0; j <= ny; j++) {
        for (int i = 0; i <= nx; i++) {
            const double x[2] = {((double)i / nx - 0.5) * plate->width, ((double)j / ny - 0.5) * plate->height};
            add_node(problem, x, nodes);
        }
    }
done:
    return status;
}

void pdmc_paper_nodes_clear(pdmc_paper_nodes *nodes)
{
    pdmc_free(nodes->x);
    *nodes = (pdmc_paper_nodes){0};
}

bool pdmc_paper_on_side(const pdmc_plate *plate, pdmc_side side, const double x[2])
{
    const double w = 0.5 * plate->width, h = 0.5 * plate->height;
    switch (side) {
    case PDMC_SIDE_LEFT: return x[0] <= -w * (1.0 - 1e-12);
    case PDMC_SIDE_RIGHT: return x[0] >= w * (1.0 - 1e-12);
    case PDMC_SIDE_BOTTOM: return x[1] <= -h * (1.0 - 1e-12);
    case PDMC_SIDE_TOP: return x[1] >= h * (1.0 - 1e-12);
    }
    return false;
}
