// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/moving_least_squares.h"

#include "check.h"
#include "horizon/reference.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 7, NODES = SIDE * SIDE * SIDE, POINTS = 40 };

/// A cube of nodes, moved about by up to `scatter` spacings; in two dimensions only its first layer counts.
static int place_nodes(int dimension, double spacing, double scatter, double node[3 * NODES])
{
    const int count = dimension == 3 ? NODES : SIDE * SIDE;
    for (int i = 0; i < count; i++) {
        const int at[3] = {i % SIDE, i / SIDE % SIDE, i / SIDE / SIDE};
        for (int a = 0; a < 3; a++)
            node[3 * i + a] = a < dimension
                                  ? spacing * (at[a] + scatter * (2.0 * uniform((uint64_t)i, 20 + (uint64_t)a) - 1.0))
                                  : 0.0;
    }
    return count;
}

static void place_points(int dimension, double extent, double point[3 * POINTS])
{
    for (int p = 0; p < POINTS; p++)
        for (int a = 0; a < 3; a++)
            point[3 * p + a] = a < dimension ? extent * uniform((uint64_t)p, 30 + (uint64_t)a) : 0.0;
}

/// A quadratic polynomial and a cubic one.
static void fields(const double x[3], double value[2])
{
    value[0] = 1.0 + 2.0 * x[0] - x[1] + 0.5 * x[2] + x[0] * x[1] - 2.0 * x[1] * x[2] + 3.0 * x[2] * x[0] -
               x[0] * x[0] + 0.7 * x[1] * x[1] + 0.3 * x[2] * x[2];
    value[1] = x[0] * x[0] * x[0] + x[1] * x[1] * x[0];
}

/// The largest errors of both fields at random points, on a grid of that spacing in a cube of side 1.
static void interpolate(int dimension, double spacing, double scatter, double error[2], pdmc_shape_quality *worst)
{
    double node[3 * NODES], point[3 * POINTS], at_nodes[2 * NODES], at_points[2 * POINTS], want[2];
    const pdmc_moving_least_squares options = pdmc_moving_least_squares_default(dimension, 3.0 * spacing);
    const int count = place_nodes(dimension, spacing, scatter, node);
    place_points(dimension, (SIDE - 1) * spacing, point);
    for (int i = 0; i < count; i++) fields(&node[3 * i], &at_nodes[2 * i]);
    pdmc_shape_functions functions;
    CHECK_OK(pdmc_shape_functions_create(&options, count, node, POINTS, point, &functions));
    pdmc_shape_functions_apply(&functions, 2, at_nodes, at_points);
    error[0] = error[1] = 0.0;
    for (int p = 0; p < POINTS; p++) {
        fields(&point[3 * p], want);
        for (int f = 0; f < 2; f++) error[f] = fmax(error[f], fabs(at_points[2 * p + f] - want[f]));
    }
    *worst = functions.worst;
    pdmc_shape_functions_clear(&functions);
}

// Corners and faces included, on nodes in any place. Cubics are off by the third power of the spacing.
static void quadratics_are_reproduced(void **state)
{
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++) {
        for (int scattered = 0; scattered < 2; scattered++) {
            double coarse[2], fine[2];
            pdmc_shape_quality worst;
            interpolate(dimension, 0.1, 0.25 * scattered, coarse, &worst);
            CHECK_NEAR(coarse[0], 0.0, 1e-12);
            for (int k = 0; k < 3; k++) CHECK_NEAR(worst.consistency[k], 0.0, 1e-12);
            for (int k = 0; k < 2; k++) assert_true(10.0 < worst.condition[k] && worst.condition[k] < 1e7);
            interpolate(dimension, 0.05, 0.25 * scattered, fine, &worst);
            CHECK_NEAR(fine[1] / coarse[1], 1.0 / 8.0, 1e-6); // the same places in spacings
        }
    }
}

// With unit and origin the condition stays as it is.
static void units_and_origins_do_not_matter(void **state)
{
    (void)state;
    double node[3 * NODES], far[3 * NODES], value[NODES], other[NODES];
    const double point[3] = {0.31, 0.27, 0.3}, far_point[3] = {1000.0 * 0.31 + 4096.0, 270.0, 300.0 - 512.0};
    const int count = place_nodes(3, 0.1, 0.2, node);
    for (int i = 0; i < 3 * count; i++) far[i] = 1000.0 * node[i] + (i % 3 == 0 ? 4096.0 : i % 3 == 2 ? -512.0 : 0.0);
    const pdmc_moving_least_squares options = pdmc_moving_least_squares_default(3, 0.3);
    const pdmc_moving_least_squares far_options = pdmc_moving_least_squares_default(3, 300.0);
    pdmc_shape_quality quality, far_quality;
    CHECK_OK(pdmc_shape_functions_at(&options, point, count, node, value, &quality));
    CHECK_OK(pdmc_shape_functions_at(&far_options, far_point, count, far, other, &far_quality));
    for (int i = 0; i < count; i++) CHECK_NEAR(other[i], value[i], 1e-10);
    for (int k = 0; k < 2; k++) CHECK_NEAR(far_quality.condition[k] / quality.condition[k], 1.0, 1e-9);
}

// The same at one point from all nodes and from those that a search finds; nodes ascend.
static void the_search_finds_all_nodes(void **state)
{
    (void)state;
    double node[3 * NODES], point[3 * POINTS], value[NODES];
    const pdmc_moving_least_squares options = pdmc_moving_least_squares_default(3, 0.3);
    const int count = place_nodes(3, 0.1, 0.2, node);
    pdmc_shape_functions functions;
    place_points(3, 0.6, point);
    CHECK_OK(pdmc_shape_functions_create(&options, count, node, POINTS, point, &functions));
    for (int p = 0; p < POINTS; p++) {
        int64_t at = functions.first[p];
        CHECK_OK(pdmc_shape_functions_at(&options, &point[3 * p], count, node, value, NULL));
        for (int i = 0; i < count; i++) {
            if (value[i] == 0.0) continue;
            assert_int_equal(functions.node[at], i);
            CHECK_NEAR(functions.value[at++], value[i], 0.0);
        }
        assert_true(at == functions.first[p + 1]);
    }
    pdmc_shape_functions_clear(&functions);
}

// The 27 nodes of a cube about the point: by symmetry the matrix is one of 1, x^2, y^2, z^2, whose inverse has a closed
// form, beside six numbers.
static void norms_are_those_of_the_matrix(void **state)
{
    (void)state;
    double node[3 * 27], value[27];
    const pdmc_moving_least_squares options = pdmc_moving_least_squares_default(3, 2.0);
    const double point[3] = {0.0, 0.0, 0.0};
    double s0 = 0.0, s2 = 0.0, s4 = 0.0, s22 = 0.0; // sums of w, w x^2, w x^4, w x^2 y^2
    for (int i = 0; i < 27; i++) {
        const double x[3] = {i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
        const double d = 0.5 * sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        const double w = d < 1.0 ? 1.0 - 6.0 * d * d + 8.0 * d * d * d - 3.0 * d * d * d * d : 0.0;
        memcpy(&node[3 * i], x, sizeof x);
        s0 += w;
        s2 += 0.25 * w * x[0] * x[0];
        s4 += 0.0625 * w * pow(x[0], 4.0);
        s22 += 0.0625 * w * x[0] * x[0] * x[1] * x[1];
    }
    // Inverse of [s0, s2 1'; s2 1, (s4 - s22) I + s22 1 1']: with t = s4 + 2 s22 and D = s0 t - 3 s2^2,
    // corner t / D, border -s2 / D, block I / (s4 - s22) + k 1 1'.
    const double t = s4 + 2.0 * s22, determinant = s0 * t - 3.0 * s2 * s2, gap = s4 - s22;
    const double k = (s0 / determinant - 1.0 / gap) / 3.0;
    const double norm[2] = {
        fmax(fmax(s0 + 3.0 * s2, s2 + s4 + 2.0 * s22), fmax(s2, s22)),
        sqrt(s0 * s0 + 6.0 * s2 * s2 + 3.0 * s4 * s4 + 6.0 * s22 * s22 + 3.0 * s2 * s2 + 3.0 * s22 * s22)};
    const double corner = t / determinant, border = s2 / determinant, diagonal = 1.0 / gap + k;
    const double row[2] = {corner + 3.0 * border, border + fabs(diagonal) + 2.0 * fabs(k)};
    const double inverse[2] = {fmax(fmax(row[0], row[1]), fmax(1.0 / s2, 1.0 / s22)),
                               sqrt(corner * corner + 6.0 * border * border + 3.0 * diagonal * diagonal + 6.0 * k * k +
                                    3.0 / (s2 * s2) + 3.0 / (s22 * s22))};
    pdmc_shape_quality quality;
    CHECK_OK(pdmc_shape_functions_at(&options, point, 27, node, value, &quality));
    for (int n = 0; n < 2; n++) CHECK_NEAR(quality.condition[n] / (norm[n] * inverse[n]), 1.0, 1e-12);
}

static void what_is_refused_names_the_node(void **state)
{
    (void)state;
    double node[3 * NODES], value[NODES];
    const int count = place_nodes(3, 0.1, 0.0, node);
    const double point[3] = {0.21, 0.2, 0.2}, outside[3] = {2.0, 0.2, 0.2};
    pdmc_moving_least_squares options = pdmc_moving_least_squares_default(3, 0.11);
    const int nearest = 2 + SIDE * 2 + SIDE * SIDE * 2;
    char name[64];
    snprintf(name, sizeof name, "near node %d, at (0.21, 0.2, 0.2), of 6 nodes", nearest);
    CHECK_STATUS(pdmc_shape_functions_at(&options, point, count, node, value, NULL), PDMC_ERR_SINGULAR);
    if (!strstr(pdmc_last_error(), name)) fail_msg("%s", pdmc_last_error());
    options.support = 0.3;
    CHECK_STATUS(pdmc_shape_functions_at(&options, outside, count, node, value, NULL), PDMC_ERR_SINGULAR);
    options.condition_limit = 10.0;
    CHECK_STATUS(pdmc_shape_functions_at(&options, point, count, node, value, NULL), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "condition"));
    // Nodes that are all but in one plane beside the point, and no limit of the condition: the polynomials are not reproduced.
    options.condition_limit = INFINITY;
    for (int i = 0; i < count; i++) node[3 * i + 2] = 0.25 + 1e-5 * node[3 * i + 2];
    CHECK_STATUS(pdmc_shape_functions_at(&options, point, count, node, value, NULL), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "a constant is off by"));
    options.support = 0.0;
    CHECK_STATUS(pdmc_shape_functions_at(&options, point, count, node, value, NULL), PDMC_ERR_ARG);
    options = pdmc_moving_least_squares_default(1, 0.3);
    CHECK_STATUS(pdmc_shape_functions_at(&options, point, count, node, value, NULL), PDMC_ERR_ARG);
    options = pdmc_moving_least_squares_default(3, 0.3);
    CHECK_STATUS(pdmc_shape_functions_at(&options, point, 0, node, value, NULL), PDMC_ERR_ARG);
}

static void memory_that_is_refused(void **state)
{
    (void)state;
    double node[3 * NODES];
    const int count = place_nodes(3, 0.1, 0.0, node);
    const double point[3] = {0.21, 0.2, 0.2};
    const pdmc_moving_least_squares options = pdmc_moving_least_squares_default(3, 0.3);
    pdmc_shape_functions functions;
    CHECK_FAILS_CLEANLY(pdmc_shape_functions_create(&options, count, node, 1, point, &functions),
                        pdmc_shape_functions_clear(&functions));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quadratics_are_reproduced),      cmocka_unit_test(units_and_origins_do_not_matter),
        cmocka_unit_test(the_search_finds_all_nodes),     cmocka_unit_test(norms_are_those_of_the_matrix),
        cmocka_unit_test(what_is_refused_names_the_node), cmocka_unit_test(memory_that_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
