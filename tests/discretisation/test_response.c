// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"
#include "discretisation/response.h"

#include <string.h>

// Two operators on R^30: q = 0 shifts by one place and scales, q = 1 is twice the identity on the first ten places. The
// words on e_0 of a size s a step fall as s^k, and end at the tolerance.
enum { N = 30 };

static pdmc_status apply(void *context, int term, int count, const double v[], double out[])
{
    (void)context;
    for (int k = 0; k < count; k++)
        for (int i = 0; i < N; i++)
            out[k * N + i] = term == 0 ? (i ? v[k * N + i - 1] : 0.0) : (i < 10 ? 2.0 * v[k * N + i] : 0.0);
    return PDMC_OK;
}

static void make(double size, pdmc_response *response)
{
    const double sizes[2] = {size, size};
    double start[N] = {1.0};
    const pdmc_response_operator operator= {N, 2, sizes, 1.0, 1e-13, apply, NULL};
    CHECK_OK(pdmc_response_create(&operator, 1, start, response));
}

// 1e-13 is reached after 13 shifts of size 0.1 and after 7 of size 0.01; a large size fills the whole space.
static void words_are_collected_until_they_are_negligible(void **state)
{
    (void)state;
    const double sizes[3] = {0.0101, 0.101, 0.9};
    const int dimension[3] = {7, 14, N};
    for (int k = 0; k < 3; k++) {
        pdmc_response response;
        make(sizes[k], &response);
        assert_int_equal(response.dimension, dimension[k]);
        for (int i = 0; i < response.dimension; i++) {
            for (int j = 0; j <= i; j++) {
                double product = 0.0;
                for (int m = 0; m < N; m++) product += response.basis[i * N + m] * response.basis[j * N + m];
                CHECK_NEAR(product, i == j, 1e-14);
            }
        }
        pdmc_response_clear(&response);
    }
}

// In the space, sum_q xi_q M_q x is what it is outside, up to what leaves the space.
static void products_in_the_space_are_those_of_the_operators(void **state)
{
    (void)state;
    pdmc_response response;
    make(0.101, &response);
    const int r = response.dimension;
    double x[2 * N] = {0}, y[2 * N], full[N] = {0}, image[2][N];
    const double xi[4] = {0.3, -0.2, 0.1, 0.4};
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < 8; i++) x[s * r + i] = i + s; // words of the first eight orders: one shift stays inside
    CHECK_OK(pdmc_response_perturb(&response, 2, 2, xi, x, y));
    for (int s = 0; s < 2; s++) {
        memset(full, 0, sizeof full);
        for (int i = 0; i < r; i++)
            for (int m = 0; m < N; m++) full[m] += x[s * r + i] * response.basis[i * N + m];
        for (int q = 0; q < 2; q++) assert_int_equal(apply(NULL, q, 1, full, image[q]), PDMC_OK);
        for (int m = 0; m < N; m++) {
            double inside = 0.0;
            for (int i = 0; i < r; i++) inside += y[s * r + i] * response.basis[i * N + m];
            CHECK_NEAR(inside, xi[2 * s] * image[0][m] + xi[2 * s + 1] * image[1][m], 1e-13);
        }
    }
    pdmc_response_clear(&response);
}

static void without_operators_it_is_the_span_of_the_start(void **state)
{
    (void)state;
    double start[3 * N] = {0};
    start[0] = 1.0;
    start[N] = 2.0;
    start[2 * N + 5] = 1e-3;
    const pdmc_response_operator operator= {N, 0, NULL, 1.0, 1e-13, apply, NULL};
    pdmc_response response;
    CHECK_OK(pdmc_response_create(&operator, 3, start, &response));
    assert_int_equal(response.dimension, 2);
    pdmc_response_clear(&response);
}

static pdmc_status create_again(pdmc_response *response)
{
    const double sizes[2] = {0.1, 0.1};
    double start[N] = {1.0};
    const pdmc_response_operator operator= {N, 2, sizes, 1.0, 1e-13, apply, NULL};
    return pdmc_response_create(&operator, 1, start, response);
}

static void refused_allocations_are_reported(void **state)
{
    (void)state;
    pdmc_response response;
    CHECK_FAILS_CLEANLY(create_again(&response), pdmc_response_clear(&response));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_are_collected_until_they_are_negligible),
        cmocka_unit_test(products_in_the_space_are_those_of_the_operators),
        cmocka_unit_test(without_operators_it_is_the_span_of_the_start),
        cmocka_unit_test(refused_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
