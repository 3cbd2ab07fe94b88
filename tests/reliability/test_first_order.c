// SPDX-License-Identifier: GPL-3.0-or-later
#include "reliability/limit_states.h"

#include <math.h>

static const double betas[] = {2.33, 3.72, 4.75};
static const int dimensions[] = {2, 10, 60};

static pdmc_first_order find(known_state *state, const double *start)
{
    const pdmc_limit_state limit = as_limit_state(state);
    pdmc_first_order_options options = pdmc_first_order_options_default();
    pdmc_first_order point;
    options.start = start;
    CHECK_OK(pdmc_first_order_find(&limit, &options, &point));
    assert_int_equal(point.evaluations, state->evaluations);
    return point;
}

/// One step: differences of a linear function are exact but for rounding, some 1e-16 |z| / 0.05.
static void a_plane_is_found_at_once(void **state)
{
    (void)state;
    for (int k = 0; k < 9; k++) {
        const int n = dimensions[k / 3];
        const double beta = betas[k % 3], squares = n * (n + 1.0) * (2.0 * n + 1.0) / 6.0;
        known_state plane_state = {.dimension = n, .g = plane, .parameter = {beta}};
        pdmc_first_order point = find(&plane_state, NULL);
        assert_true(point.converged);
        CHECK_NEAR(point.index, beta, 1e-10);
        CHECK_NEAR(point.probability, gsl_cdf_ugaussian_Q(beta), 1e-9 * gsl_cdf_ugaussian_Q(beta) * beta);
        CHECK_NEAR(point.residual, 0.0, 1e-10);
        for (int i = 0; i < n; i++) {
            CHECK_NEAR(point.importance[i], (i + 1.0) * (i + 1.0) / squares, 1e-10);
            CHECK_NEAR(point.z[i], beta * (i + 1.0) / sqrt(squares), 1e-10);
        }
        assert_true(point.evaluations <= 2 * (2 * n + 1) + 12);
        pdmc_first_order_clear(&point);
    }
}

static void the_index_is_negative_where_the_origin_is_in_the_event(void **state)
{
    (void)state;
    known_state inside = {.dimension = 3, .g = plane, .parameter = {-1.5}};
    pdmc_first_order point = find(&inside, NULL);
    CHECK_NEAR(point.index, -1.5, 1e-10);
    CHECK_NEAR(point.probability, gsl_cdf_ugaussian_P(1.5), 1e-10);
    pdmc_first_order_clear(&point);
}

/// The surface is a plane in z, though g is not linear: 2 s_L z_1 - s_c z_2 = log of the medians' ratio.
static void griffith_has_its_closed_form(void **state)
{
    (void)state;
    static const double probabilities[] = {1e-2, 1e-4, 1e-6};
    for (int k = 0; k < 3; k++) {
        known_state lognormal = griffith_at(probabilities[k]);
        pdmc_first_order point = find(&lognormal, NULL);
        assert_true(point.converged);
        CHECK_NEAR(point.index, gsl_cdf_ugaussian_Qinv(probabilities[k]), 1e-4); // the tolerance of the search
        // Central differences of exp(0.2 z) and exp(0.15 z) are off by h^2 s^2 / 6 < 2e-5 of themselves, the normal's
        // direction by as much, and it is within the tolerance / beta < 5e-5 of the surface's.
        CHECK_NEAR(point.importance[0], 0.04 / 0.0625, 1e-4);
        pdmc_first_order_clear(&point);
    }
}

/// The nearest point of a parabola that bends away is its vertex, that of a sphere anywhere on it; the gradient of the sphere
/// vanishes at the origin.
static void curved_surfaces(void **state)
{
    (void)state;
    known_state away = {.dimension = 10, .g = parabola, .parameter = {3.0, -0.3}};
    known_state towards = {.dimension = 10, .g = parabola, .parameter = {3.0, 0.2}};
    known_state sphere = {.dimension = 5, .g = outside_sphere, .parameter = {4.0}};
    known_state *states[] = {&away, &towards, &sphere};
    for (int k = 0; k < 3; k++) {
        pdmc_first_order point = find(states[k], NULL);
        assert_true(point.converged);
        CHECK_NEAR(point.index, states[k]->parameter[0], 1e-4);
        pdmc_first_order_clear(&point);
    }
}

/// z_1 - b + z_1^2 z_2 / 10 has no symmetry: the point is compared with the least |z| over the surface's z_2.
static double skew_surface(const double parameter[], int n, const double z[])
{
    (void)n;
    return z[0] - parameter[0] + 0.1 * z[0] * z[0] * z[1];
}

static void a_surface_without_symmetry(void **state)
{
    (void)state;
    double nearest = INFINITY;
    for (int k = 0; k < 4000000; k++) { // z_2 of a given z_1
        const double x = 0.5 + 1e-6 * k, y = (3.0 - x) / (0.1 * x * x);
        nearest = fmin(nearest, sqrt(x * x + y * y));
    }
    known_state skew = {.dimension = 2, .g = skew_surface, .parameter = {3.0}};
    pdmc_first_order point = find(&skew, NULL);
    assert_true(point.converged);
    CHECK_NEAR(point.index, nearest, 1e-4);
    pdmc_first_order_clear(&point);
}

/// An error of g of 1e-6 turns the normal by less than 1e-6 sqrt(n) / h, and the point with it.
static void a_little_noise_does_no_harm(void **state)
{
    (void)state;
    known_state noisy = {.dimension = 10, .g = plane, .parameter = {3.72}, .noise = 1e-6};
    pdmc_first_order point = find(&noisy, NULL);
    assert_true(point.converged);
    CHECK_NEAR(point.index, 3.72, 1e-4);
    pdmc_first_order_clear(&point);
}

/// Like the plane, and NaN in a ball on the way there and in a half-space far from it.
static double plane_with_holes(const double parameter[], int n, const double z[])
{
    double square = 0.0;
    for (int i = 0; i < n; i++) square += z[i] * z[i];
    if ((square > 1.0 && square < 4.0) || z[0] < -0.01) return NAN;
    return plane(parameter, n, z);
}

static void unsolved_points_are_stepped_over(void **state)
{
    (void)state;
    known_state holes = {.dimension = 3, .g = plane_with_holes, .parameter = {3.0}};
    pdmc_first_order point = find(&holes, NULL);
    assert_true(point.converged);
    CHECK_NEAR(point.index, 3.0, 1e-8);
    pdmc_first_order_clear(&point);
}

static double flat(const double parameter[], int n, const double z[])
{
    (void)n;
    (void)z;
    return parameter[0];
}

static double never(const double parameter[], int n, const double z[])
{
    (void)n;
    return tanh(z[0]) - parameter[0];
}

static void what_cannot_be_reached_is_not_converged(void **state)
{
    (void)state;
    known_state states[] = {{.dimension = 4, .g = flat, .parameter = {-1.0}},
                            {.dimension = 4, .g = flat, .parameter = {NAN}},
                            {.dimension = 4, .g = never, .parameter = {2.0}},
                            {.dimension = 4, .g = outside_sphere, .parameter = {NAN}}};
    for (int k = 0; k < 4; k++) {
        pdmc_first_order point = find(&states[k], NULL);
        assert_false(point.converged);
        assert_true(isnan(point.index) && isnan(point.probability) && isnan(point.importance[0]));
        assert_true(isfinite(point.z[0]));
        pdmc_first_order_clear(&point);
    }
}

/// From either side, the design point of that side.
static void other_points_are_found_from_other_starts(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const double start[] = {0.5 * side, 0.2, 0.0};
        known_state two = {.dimension = 3, .g = two_planes, .parameter = {3.0}};
        pdmc_first_order point = find(&two, start);
        CHECK_NEAR(point.z[0], 3.0 * side, 1e-8);
        CHECK_NEAR(point.index, 3.0, 1e-8);
        pdmc_first_order_clear(&point);
    }
}

static pdmc_first_order find_other(known_state *state, int count, const pdmc_first_order known[])
{
    const pdmc_limit_state limit = as_limit_state(state);
    const pdmc_first_order_options options = pdmc_first_order_options_default();
    const long before = state->evaluations;
    pdmc_first_order point;
    CHECK_OK(pdmc_first_order_find_other(&limit, &options, count, known, &point));
    assert_int_equal(point.evaluations, state->evaluations - before);
    return point;
}

// Of two planes the second, and no third; of a plane by itself none, for the price of a gradient. A surface that bends leads
// back to its only point.
static void other_points_are_looked_for_along_the_axes(void **state)
{
    (void)state;
    pdmc_first_order known[3];
    known_state two = {.dimension = 3, .g = two_planes, .parameter = {3.0}};
    known_state one = {.dimension = 10, .g = plane, .parameter = {3.0}};
    known_state bent = {.dimension = 2, .g = parabola, .parameter = {3.0, 0.3}};
    known[0] = find(&two, NULL);
    known[1] = find_other(&two, 1, known);
    known[2] = find_other(&two, 2, known);
    assert_true(known[1].converged && !known[2].converged);
    CHECK_NEAR(known[0].slope, 1.0, 1e-10);
    CHECK_NEAR(known[1].z[0], -known[0].z[0], 1e-8);
    assert_int_equal(known[2].evaluations, 2 * 3);
    for (int k = 0; k < 3; k++) pdmc_first_order_clear(&known[k]);
    known_state *const alone[] = {&one, &bent};
    for (int k = 0; k < 2; k++) {
        known[0] = find(alone[k], NULL);
        known[1] = find_other(alone[k], 1, known);
        assert_false(known[1].converged);
        assert_true(k == 0 ? known[1].evaluations == 2 * 10 : known[1].evaluations > 2 * 2);
        pdmc_first_order_clear(&known[0]);
        pdmc_first_order_clear(&known[1]);
    }
}

// Only a point with the event beyond it has a plane to compare with.
static void other_points_need_one_that_is_known(void **state)
{
    (void)state;
    known_state inside = {.dimension = 3, .g = plane, .parameter = {-1.5}};
    const pdmc_limit_state limit = as_limit_state(&inside);
    const pdmc_first_order_options options = pdmc_first_order_options_default();
    pdmc_first_order known = find(&inside, NULL), other;
    CHECK_STATUS(pdmc_first_order_find_other(&limit, &options, 1, &known, &other), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_first_order_find_other(&limit, &options, 0, &known, &other), PDMC_ERR_ARG);
    pdmc_first_order_clear(&known);
}

static void points_do_not_depend_on_how_g_is_evaluated(void **state)
{
    (void)state;
    known_state lognormal = griffith_at(1e-4);
    pdmc_first_order want = find(&lognormal, NULL);
    for (int k = ONE_BY_ONE; k <= IN_THREADS; k++) {
        known_state again = griffith_at(1e-4);
        again.manner = (manner)k;
        pdmc_first_order got = find(&again, NULL);
        assert_memory_equal(got.z, want.z, 2 * sizeof(double));
        assert_true(got.index == want.index && got.evaluations == want.evaluations);
        pdmc_first_order_clear(&got);
    }
    pdmc_first_order_clear(&want);
}

static pdmc_status broken(void *context, int count, const double z[], double g[])
{
    (void)context;
    (void)count;
    (void)z;
    (void)g;
    return pdmc_raise(PDMC_ERR_SINGULAR, "broken");
}

static pdmc_status find_and_clear_on_failure(const pdmc_limit_state *limit, pdmc_first_order *point)
{
    const pdmc_first_order_options options = pdmc_first_order_options_default();
    const pdmc_status status = pdmc_first_order_find(limit, &options, point);
    if (status != PDMC_OK) pdmc_first_order_clear(point);
    return status;
}

static void errors_are_reported(void **state)
{
    (void)state;
    known_state lognormal = griffith_at(1e-4);
    pdmc_limit_state limit = as_limit_state(&lognormal);
    pdmc_first_order point;
    CHECK_FAILS_CLEANLY(find_and_clear_on_failure(&limit, &point), pdmc_first_order_clear(&point));
    limit.evaluate = broken;
    CHECK_STATUS(find_and_clear_on_failure(&limit, &point), PDMC_ERR_SINGULAR);
    limit.dimension = 0;
    CHECK_STATUS(find_and_clear_on_failure(&limit, &point), PDMC_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_is_found_at_once),
        cmocka_unit_test(the_index_is_negative_where_the_origin_is_in_the_event),
        cmocka_unit_test(griffith_has_its_closed_form),
        cmocka_unit_test(curved_surfaces),
        cmocka_unit_test(a_surface_without_symmetry),
        cmocka_unit_test(a_little_noise_does_no_harm),
        cmocka_unit_test(unsolved_points_are_stepped_over),
        cmocka_unit_test(what_cannot_be_reached_is_not_converged),
        cmocka_unit_test(other_points_are_found_from_other_starts),
        cmocka_unit_test(other_points_are_looked_for_along_the_axes),
        cmocka_unit_test(other_points_need_one_that_is_known),
        cmocka_unit_test(points_do_not_depend_on_how_g_is_evaluated),
        cmocka_unit_test(errors_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
