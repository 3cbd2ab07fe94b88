// SPDX-License-Identifier: GPL-3.0-or-later

/// All geometric configurations of cell and sphere of section 2.4.2: which there are, and that the adaptive rule's
/// pieces fill the part inside.

#include "pdmc/horizon.h"

#include "check.h"
#include "horizon/pieces.h"
#include "horizon/reference.h"

#include <gsl/gsl_math.h>
#include <string.h>

enum { EDGES = 12, CONFIGURATIONS = 18 };

// The edges in the order of Table 2.1. V are along X, at the near (0) or far (1) end of the other axes; T and B are
// along Z or Y, in the face of the largest and of the smallest X. V1 to V4 lie between 1 and 2, 2 and 3, 3 and 4, 4 and
// 1 of either face.
static const struct {
    int along, end[3];
} edges[EDGES] = {{2, {1, 0, 0}}, {1, {1, 0, 0}}, {2, {1, 1, 0}}, {1, {1, 0, 1}}, {0, {0, 0, 0}}, {0, {0, 1, 0}},
                  {0, {0, 1, 1}}, {0, {0, 0, 1}}, {2, {0, 0, 0}}, {1, {0, 0, 0}}, {2, {0, 1, 0}}, {1, {0, 0, 1}}};

// Table 2.1, T1-4, V1-4, B1-4. Row 0 is figure 2.7, whose list of edges in the text leaves out V4, on which F lies.
static const char *const printed[CONFIGURATIONS] = {
    "xx.. .x.x ..xx", "xx.. .... xx..", "x.x. .... x.x.", "x.x. ...x ..xx", ".x.x .... .x.x", ".x.x .x.. ..xx",
    "..xx .... ..xx", "xx.. .x.. x.x.", "xx.. ...x .x.x", ".... xx.x ..xx", ".... x..x .x.x", ".... x... xx..",
    ".... xx.. x.x.", "xx.. .xxx ....", "..xx ..x. ....", "x.x. ..xx ....", ".x.x .xx. ....", ".... xxxx ...."};

static bool is_cut(const pdmc_cell *cell, double radius, int edge)
{
    double near = 0.0, far = 0.0;
    for (int a = 0; a < 3; a++) {
        const double x = edges[edge].end[a] ? cell->upper[a] : cell->lower[a];
        near += a == edges[edge].along ? cell->lower[a] * cell->lower[a] : x * x;
        far += a == edges[edge].along ? cell->upper[a] * cell->upper[a] : x * x;
    }
    return near < radius * radius && radius * radius < far;
}

/// The row of Table 2.1, or -1.
static int configuration(const pdmc_cell *cell, double radius)
{
    char pattern[] = ".... .... ....";
    for (int e = 0; e < EDGES; e++)
        if (is_cut(cell, radius, e)) pattern[e + e / 4] = 'x';
    for (int c = 0; c < CONFIGURATIONS; c++)
        if (strcmp(pattern, printed[c]) == 0) return c;
    return -1;
}

static pdmc_cell cubic(const double node[3])
{
    pdmc_cell cell;
    for (int a = 0; a < 3; a++) {
        cell.lower[a] = node[a] - 0.5;
        cell.upper[a] = node[a] + 0.5;
    }
    return cell;
}

/// The volume of the pieces, by points `n` a side: midpoints in Y, and in X those of Chebyshev, for which roots at the
/// ends are smooth.
static double fill(const pdmc_pieces *pieces, int n)
{
    double sum = 0.0;
    for (int q = 0; q < pieces->count; q++) {
        const pdmc_piece *p = &pieces->piece[q];
        for (int i = 0; i < n; i++) {
            const double angle = M_PI * (i + 0.5) / n, u = 0.5 - 0.5 * cos(angle);
            const double wide = 0.5 * M_PI / n * sin(angle);
            const double x = p->x[0] + (p->x[1] - p->x[0]) * u;
            const double from = pdmc_limit_at(&p->y[0], x), to = pdmc_limit_at(&p->y[1], x);
            for (int j = 0; j < n; j++) {
                const double y = from + (to - from) * (j + 0.5) / n;
                sum += (p->x[1] - p->x[0]) * wide * (to - from) / n * (pdmc_piece_top(pieces, p, x, y) - p->bottom);
            }
        }
    }
    return sum;
}

// The largest error of 24 points a side was 7e-4 of a cell.
static void check_filled(const pdmc_cell *cell, double radius)
{
    enum { STEPS = 24 };
    pdmc_pieces pieces;
    double centroid[3];
    pdmc_pieces_of(3, cell, radius, &pieces);
    CHECK_NEAR(fill(&pieces, STEPS), pdmc_cell_in_sphere(3, cell, radius, centroid), 1e-3);
}

// Nodes off the axes, in the first octant or between two axes: cells are met in every of the 18 ways, and in no other.
static void every_configuration_of_type_two_is_filled(void **state)
{
    (void)state;
    int met[CONFIGURATIONS] = {0};
    for (uint64_t draw = 0; draw < 6000; draw++) {
        double node[3], square = 0.0;
        for (int a = 0; a < 3; a++) {
            node[a] = floor(5.0 * uniform(draw, (uint64_t)a)) + 0.5; // cells do not cross the planes of the axes
            square += node[a] * node[a];
        }
        const double radius = sqrt(square) + 1.7 * (uniform(draw, 3) - 0.5);
        const pdmc_cell cell = cubic(node);
        double centroid[3];
        const double volume = pdmc_cell_in_sphere(3, &cell, radius, centroid);
        if (volume <= 0.0 || volume >= 1.0) continue;
        const int c = configuration(&cell, radius);
        assert_in_range(c, 0, CONFIGURATIONS - 1);
        if (met[c]++ < 30) check_filled(&cell, radius);
    }
    for (int c = 0; c < CONFIGURATIONS; c++)
        if (met[c] == 0) fail_msg("configuration %d was not met", c);
}

// The node on an axis: the sphere comes in through the face (1), through its edges (2), and out at the back (3).
// Between the printed bounds of 2 there are the circles that cut the near face's corners off.
static void every_subtype_of_type_one_is_filled(void **state)
{
    (void)state;
    int met[4] = {0};
    for (uint64_t draw = 0; draw < 400; draw++) {
        double node[3] = {0.0, 0.0, 0.0};
        const int axis = (int)(3.0 * uniform(draw, 0));
        const double along = 1.0 + floor(4.0 * uniform(draw, 1));
        node[axis] = uniform(draw, 2) < 0.5 ? -along : along;
        const double near = along - 0.5, far = along + 0.5, radius = near + 1.4 * uniform(draw, 3);
        if (radius * radius >= far * far + 0.5) continue;
        met[radius * radius < near * near + 0.25  ? 0
            : radius * radius < near * near + 0.5 ? 1
            : radius <= far                       ? 2
                                                  : 3]++;
        const pdmc_cell cell = cubic(node);
        check_filled(&cell, radius);
    }
    for (int s = 0; s < 4; s++) assert_true(met[s] > 10);
}

// Nodes between two axes and anywhere else: cells that cross planes of the axes.
static void cells_anywhere_are_filled(void **state)
{
    (void)state;
    for (uint64_t draw = 0; draw < 600; draw++) {
        double node[3];
        for (int a = 0; a < 3; a++) node[a] = 6.0 * (uniform(draw, (uint64_t)a) - 0.5);
        const double radius = 0.6 + 3.0 * uniform(draw, 3);
        const pdmc_cell cell = cubic(node);
        bool is_round_centre = true;
        for (int a = 0; a < 3; a++) is_round_centre &= fabs(node[a]) < 0.5;
        if (!is_round_centre) check_filled(&cell, radius);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_configuration_of_type_two_is_filled),
        cmocka_unit_test(every_subtype_of_type_one_is_filled),
        cmocka_unit_test(cells_anywhere_are_filled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
