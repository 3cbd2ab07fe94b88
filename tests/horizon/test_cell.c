// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/horizon.h"

#include "check.h"
#include "horizon/reference.h"

#include <float.h>
#include <gsl/gsl_math.h>

static double extent(int dimension, const pdmc_cell *cell)
{
    double product = 1.0;
    for (int a = 0; a < dimension; a++) product *= cell->upper[a] - cell->lower[a];
    return product;
}

/// A cell of random sides round a random point near the unit sphere.
static pdmc_cell random_cell(int dimension, uint64_t draw, double size)
{
    pdmc_cell cell = {0};
    double direction[3], square = 0.0;
    for (int a = 0; a < dimension; a++) {
        direction[a] = 2.0 * uniform(draw, (uint64_t)a) - 1.0;
        square += direction[a] * direction[a];
    }
    const double r = 1.0 + size * (2.0 * uniform(draw, 3) - 1.0);
    for (int a = 0; a < dimension; a++) {
        const double middle = direction[a] / sqrt(square) * r;
        cell.lower[a] = middle - size * uniform(draw, 4 + (uint64_t)a);
        cell.upper[a] = middle + size * uniform(draw, 7 + (uint64_t)a);
    }
    return cell;
}

/// The length of the part inside of a line along z.
static double column(const pdmc_cell *cell, double x, double y)
{
    const double left = 1.0 - x * x - y * y;
    if (left <= 0.0) return 0.0;
    return fmax(0.0, fmin(cell->upper[2], sqrt(left)) - fmax(cell->lower[2], -sqrt(left)));
}

// Columns know nothing of faces and arcs. Their sum is off by the columns that an edge of the sphere meets, a share of
// 1 / SIDE, to the power 3 / 2: the largest of 12 was 3e-6 of the cell.
static void volumes_are_those_of_columns(void **state)
{
    (void)state;
    enum { SIDE = 400 };
    for (uint64_t draw = 0; draw < 12; draw++) {
        const pdmc_cell cell = random_cell(3, draw, 0.5);
        const double step[] = {(cell.upper[0] - cell.lower[0]) / SIDE, (cell.upper[1] - cell.lower[1]) / SIDE};
        double sum = 0.0, centroid[3];
        for (int i = 0; i < SIDE * SIDE; i++)
            sum +=
                column(&cell, cell.lower[0] + step[0] * (i / SIDE + 0.5), cell.lower[1] + step[1] * (i % SIDE + 0.5));
        CHECK_NEAR(pdmc_cell_in_sphere(3, &cell, 1.0, centroid), sum * step[0] * step[1], 1e-5 * extent(3, &cell));
    }
}

/// Of volume and first moments of a cell against those of its two parts, over those of the cell.
static void split_errors(int dimension, uint64_t draw, double size, double *volume_error, double *moment_error)
{
    pdmc_cell cell = random_cell(dimension, draw, size), parts[2] = {cell, cell};
    const int axis = (int)(draw % (uint64_t)dimension);
    const double share = uniform(draw, 10);
    const double cut = cell.lower[axis] + share * (cell.upper[axis] - cell.lower[axis]);
    parts[0].upper[axis] = parts[1].lower[axis] = cut;
    double c[3], part[3], volume = pdmc_cell_in_sphere(dimension, &cell, 1.0, c), moment[3];
    assert_true(volume <= extent(dimension, &cell) * (1.0 + 1e-13) && volume >= 0.0);
    for (int a = 0; a < 3; a++) moment[a] = volume * c[a];
    for (int i = 0; i < 2; i++) {
        const double v = pdmc_cell_in_sphere(dimension, &parts[i], 1.0, part);
        volume -= v;
        for (int a = 0; a < 3; a++) moment[a] -= v * part[a];
    }
    *volume_error = fabs(volume) / extent(dimension, &cell);
    *moment_error = fmax(fabs(moment[0]), fmax(fabs(moment[1]), fabs(moment[2]))) / extent(dimension, &cell);
}

// Round-off is that of a radius which is off by some epsilon: its surface in the cell, size^2, over the cell, size^3.
// The largest of 30000 cells was 2.1 and 3.5 epsilon / size.
static void a_cell_is_the_sum_of_its_parts(void **state)
{
    (void)state;
    for (uint64_t draw = 0; draw < 30000; draw++) {
        const double size = pow(0.01, uniform(draw, 11));
        double volume, moment;
        split_errors(2 + (int)(draw / 4 % 2), draw, size, &volume, &moment);
        CHECK_NEAR(volume, 0.0, 16.0 * DBL_EPSILON / size);
        CHECK_NEAR(moment, 0.0, 32.0 * DBL_EPSILON / size);
    }
}

// The whole sphere and disc, and their second moments through the centroids as the cells become small.
static void a_grid_fills_the_sphere(void **state)
{
    (void)state;
    const double whole[] = {M_PI, 4.0 / 3.0 * M_PI};
    for (int dimension = 2; dimension <= 3; dimension++) {
        for (int ratio = 1; ratio <= 12; ratio++) {
            const pdmc_horizon_options o =
                pdmc_horizon_options_default(PDMC_RULE_EXACT, dimension, 1.0, 1.0 / (ratio + 0.3));
            pdmc_horizon_rule rule;
            CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
            CHECK_NEAR(pdmc_horizon_rule_volume(&rule) / whole[dimension - 2], 1.0, 1e-14);
            pdmc_horizon_rule_clear(&rule);
        }
    }
}

// A cap of height h: pi h^2 (3 - h) / 3, its centroid 3 (2 - h)^2 / (4 (3 - h)) from the centre.
static void a_cap_has_its_volume_and_centroid(void **state)
{
    (void)state;
    for (double h = 0.5; h > 1e-7; h *= 0.25) {
        for (int axis = 0; axis < 3; axis++) {
            pdmc_cell cell = {{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}};
            cell.upper[axis] = -(1.0 - h);
            const double depth = 1.0 + cell.upper[axis]; // h as it came to be represented
            double centroid[3];
            const double volume = pdmc_cell_in_sphere(3, &cell, 1.0, centroid);
            CHECK_NEAR(volume / (M_PI * depth * depth * (3.0 - depth) / 3.0), 1.0, 16.0 * DBL_EPSILON / depth);
            CHECK_NEAR(centroid[axis], -3.0 * (2.0 - depth) * (2.0 - depth) / (4.0 * (3.0 - depth)),
                       16.0 * DBL_EPSILON / depth);
            CHECK_NEAR(centroid[(axis + 1) % 3], 0.0, 16.0 * DBL_EPSILON);
        }
    }
}

// Inside, outside, and touching in a point; sizes go with the third power.
static void cells_that_are_not_cut(void **state)
{
    (void)state;
    const pdmc_cell inner = {{-0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}}, touching = {{1.0, -0.2, -0.2}, {1.5, 0.2, 0.2}};
    double centroid[3];
    CHECK_NEAR(pdmc_cell_in_sphere(3, &inner, 1.0, centroid), 0.3 * 0.2 * 0.3, 1e-17);
    CHECK_NEAR(centroid[2], 0.45, 1e-16);
    assert_true(pdmc_cell_in_sphere(3, &touching, 1.0, centroid) == 0.0);
    CHECK_NEAR(centroid[0], 1.25, 0.0);
    const pdmc_cell cut = random_cell(3, 7, 0.3);
    pdmc_cell large = cut;
    for (int a = 0; a < 3; a++) {
        large.lower[a] *= 1024.0;
        large.upper[a] *= 1024.0;
    }
    assert_true(pdmc_cell_in_sphere(3, &large, 1024.0, centroid) ==
                pow(1024.0, 3.0) * pdmc_cell_in_sphere(3, &cut, 1.0, centroid));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_are_those_of_columns), cmocka_unit_test(a_cell_is_the_sum_of_its_parts),
        cmocka_unit_test(a_grid_fills_the_sphere),      cmocka_unit_test(a_cap_has_its_volume_and_centroid),
        cmocka_unit_test(cells_that_are_not_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
