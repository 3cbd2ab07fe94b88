// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/cell.h"

#include "check.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>

static const double side = 0.7;

// A number in [0, 1) from a fixed sequence.
static double draw(void)
{
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

// Cells round an origin that lies anywhere in its cell, the corners and the middle included.
static void the_cells_of_a_grid_make_a_disc(void **state)
{
    (void)state;
    const double offset[4] = {0.0, 0.5, 0.123, 0.9999999};
    for (int k = 0; k < 4 * 60; k++) {
        const int size = k / 4 + 1;
        const double radius = size * (k % 4 == 3 ? 0.5 : 0.2113) * side, shift = offset[k % 4];
        const int reach = (int)(radius / side) + 2;
        pdmc_cell_part sum = {0};
        for (int i = -reach; i <= reach; i++) {
            for (int j = -reach; j <= reach; j++) {
                const double middle[2] = {(i + shift) * side, (j + 0.5 * shift) * side};
                const pdmc_cell_part part = pdmc_cell_in_disc(middle, side, radius);
                sum.area += part.area;
                for (int d = 0; d < 2; d++) sum.moment[d] += part.moment[d];
            }
        }
        CHECK_NEAR(sum.area / (M_PI * radius * radius), 1.0, 1e-13);
        for (int d = 0; d < 2; d++) CHECK_NEAR(sum.moment[d] / pow(radius, 3), 0.0, 1e-13);
    }
}

// Random cells of which most are cut, the origin inside one in four.
static void draw_cell(double middle[2], double *radius)
{
    const double size = draw() < 0.5 ? 1.0 : 30.0;
    *radius = size * draw();
    for (int i = 0; i < 2; i++) middle[i] = size * (2.0 * draw() - 1.0);
    const double scale = (*radius + 0.8 * side * (2.0 * draw() - 1.0)) / hypot(middle[0], middle[1]);
    for (int i = 0; i < 2; i++) middle[i] *= scale;
}

static void parts_of_a_split_cell_add_up(void **state)
{
    (void)state;
    int cut = 0;
    for (int k = 0; k < 200000; k++) {
        double middle[2], radius;
        draw_cell(middle, &radius);
        const pdmc_cell_part whole = pdmc_cell_in_disc(middle, side, radius);
        pdmc_cell_part sum = {0};
        for (int q = 0; q < 4; q++) {
            const double right = q & 1 ? 0.25 : -0.25, up = q & 2 ? 0.25 : -0.25;
            const double quarter[2] = {middle[0] + right * side, middle[1] + up * side};
            const pdmc_cell_part part = pdmc_cell_in_disc(quarter, 0.5 * side, radius);
            sum.area += part.area;
            for (int d = 0; d < 2; d++) sum.moment[d] += part.moment[d];
        }
        cut += whole.area > 0.0 && whole.area < side * side * (1.0 - 1e-14);
        CHECK_NEAR(sum.area, whole.area, 1e-13 * side * side);
        for (int d = 0; d < 2; d++) CHECK_NEAR(sum.moment[d], whole.moment[d], 1e-13 * side * side * (radius + side));
    }
    assert_true(cut > 100000);
}

typedef struct {
    double middle[2], radius;
    int power; // 0 for the area, 1 for the moment
} strip;

// The length of the cell's part in the disc at x, and its moment about the y axis.
static double at_abscissa(double x, void *context)
{
    const strip *s = context;
    const double y = sqrt(fmax(s->radius * s->radius - x * x, 0.0));
    const double low = fmax(s->middle[1] - 0.5 * side, -y), high = fmin(s->middle[1] + 0.5 * side, y);
    return fmax(high - low, 0.0) * (s->power ? x : 1.0);
}

static int ascending(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

// Piece by piece between the abscissae where the circle begins, ends and meets an edge.
static double integrate(strip *s, int power, gsl_integration_workspace *space)
{
    enum { BREAKS = 8 };
    const double low = s->middle[0] - 0.5 * side, high = s->middle[0] + 0.5 * side, r = s->radius;
    const double bottom = s->middle[1] - 0.5 * side, top = s->middle[1] + 0.5 * side;
    const double chord[2] = {sqrt(fmax(r * r - bottom * bottom, 0.0)), sqrt(fmax(r * r - top * top, 0.0))};
    double x[BREAKS] = {low, high, -r, r, -chord[0], chord[0], -chord[1], chord[1]}, sum = 0.0;
    gsl_function f = {at_abscissa, s};
    s->power = power;
    for (int k = 0; k < BREAKS; k++) x[k] = fmin(fmax(x[k], low), high);
    qsort(x, BREAKS, sizeof *x, ascending);
    for (int k = 0; k + 1 < BREAKS; k++) {
        double value = 0.0, error;
        gsl_integration_qags(&f, x[k], x[k + 1], 1e-11, 1e-11, 2000, space, &value, &error);
        sum += value;
    }
    return sum;
}

static void quadrature_agrees(void **state)
{
    (void)state;
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); // of rounding, which the comparison would show
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(2000);
    for (int k = 0; k < 3000; k++) {
        strip s;
        draw_cell(s.middle, &s.radius);
        const pdmc_cell_part part = pdmc_cell_in_disc(s.middle, side, s.radius);
        CHECK_NEAR(part.area, integrate(&s, 0, space), 1e-10);
        CHECK_NEAR(part.moment[0], integrate(&s, 1, space), 1e-10 * (1.0 + s.radius));
    }
    gsl_integration_workspace_free(space);
    gsl_set_error_handler(handler);
}

static double area(double x, double y, double radius)
{
    const double middle[2] = {x, y};
    return pdmc_cell_in_disc(middle, 1.0, radius).area;
}

static void arcs_through_corners_and_along_edges(void **state)
{
    (void)state;
    CHECK_NEAR(area(2.5, 3.5, 5.0), 1.0, 1e-15);           // the far corner (3, 4) on the circle
    CHECK_NEAR(area(3.5, 4.5, 5.0), 0.0, 0.0);             // the near one
    CHECK_NEAR(area(5.5, 0.0, 5.0), 0.0, 0.0);             // an edge touches it
    CHECK_NEAR(area(0.0, 0.0, 0.5), 0.25 * M_PI, 1e-15);   // all edges touch it from outside
    CHECK_NEAR(area(0.0, 0.0, 0.1), 0.01 * M_PI, 1e-16);   // wholly inside the cell
    CHECK_NEAR(area(0.5, 0.5, 0.1), 0.0025 * M_PI, 1e-16); // the origin at a corner
    CHECK_NEAR(area(0.5, 0.0, 0.1), 0.005 * M_PI, 1e-16);  // and on an edge
    CHECK_NEAR(area(0.0, 0.0, M_SQRT1_2), 1.0, 1e-15);     // all corners on the circle
    CHECK_NEAR(area(0.0, 0.0, 0.0), 0.0, 0.0);
    // a hair's breadth beyond an edge from within: all but a segment of (2 eps)^(3/2) 2/3 r^2
    CHECK_NEAR(area(0.2, 0.0, 0.3 + 1e-10), M_PI * 0.09, 1e-9);
    CHECK_NEAR(area(0.0, 0.0, 0.5 + 1e-10), M_PI * 0.25, 1e-9);
    // the corners of a whole quadrant of cells on or within an ulp of the circle
    for (int i = 1; i <= 40; i++) {
        for (int j = 1; j <= 40; j++) {
            const double radius = hypot(i, j), inside = area(i - 0.5, j - 0.5, radius);
            CHECK_NEAR(inside, 1.0, 1e-14);
            CHECK_NEAR(area(i - 0.5, j - 0.5, nextafter(radius, 0.0)), 1.0, 1e-14);
            CHECK_NEAR(area(i - 0.5, j - 0.5, nextafter(radius, 100.0)), 1.0, 1e-14);
            CHECK_NEAR(area(i + 0.5, j + 0.5, nextafter(radius, 100.0)), 0.0, 1e-14);
        }
    }
}

// Cells whose side is no binary fraction, with a corner within four ulps of the circle: the arc round it may come out
// with a negative angle, which is not one of almost the whole circle.
static void arcs_round_corners_are_short(void **state)
{
    (void)state;
    for (int k = 0; k < 60 * 60 * 5 * 4; k++) {
        const int i = k / 20 % 60 + 1, j = k / 1200 + 1;
        const double middle[2] = {(i + (k & 1 ? 0.5 : -0.5)) * side, (j + (k & 2 ? 0.5 : -0.5)) * side};
        double radius = hypot(i * side, j * side);
        for (int ulp = 0; ulp < k / 4 % 5; ulp++) radius = nextafter(radius, k % 3 ? 1e9 : 0.0);
        const double part = pdmc_cell_in_disc(middle, side, radius).area / (side * side);
        assert_true(part >= -1e-14 && part <= 1.0 + 1e-13);
    }
}

static void the_part_grows_with_the_disc(void **state)
{
    (void)state;
    for (int k = 0; k < 200; k++) {
        double middle[2], unused, before = 0.0;
        draw_cell(middle, &unused);
        const double start = fmax(hypot(middle[0], middle[1]) - side, 0.0);
        for (int i = 0; i <= 2000; i++) {
            const double now = pdmc_cell_in_disc(middle, side, start + 2.0 * side * i / 2000).area;
            assert_true(now >= before - 1e-14 * side * side);
            before = now;
        }
        CHECK_NEAR(before, side * side, 1e-14);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cells_of_a_grid_make_a_disc),
        cmocka_unit_test(parts_of_a_split_cell_add_up),
        cmocka_unit_test(quadrature_agrees),
        cmocka_unit_test(arcs_through_corners_and_along_edges),
        cmocka_unit_test(arcs_round_corners_are_short),
        cmocka_unit_test(the_part_grows_with_the_disc),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
