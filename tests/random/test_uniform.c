// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "random/random_impl.h"

#include "check.h"

#include <Random123/philox.h>
#include <stdlib.h>

/// The vectors "philox4x64 10" of Random123's own tests/kat_vectors.
static void the_generator_is_philox4x64_10(void **state)
{
    (void)state;
    static const struct {
        philox4x64_ctr_t counter;
        philox4x64_key_t key;
        uint64_t want[4];
    } vectors[] = {
        {{{0, 0, 0, 0}}, {{0, 0}}, {0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}},
        {{{UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX}},
         {{UINT64_MAX, UINT64_MAX}},
         {0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}},
        {{{0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89}},
         {{0x452821e638d01377, 0xbe5466cf34e90c6c}},
         {0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}},
    };
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++) {
        const philox4x64_ctr_t got = philox4x64(vectors[i].counter, vectors[i].key);
        for (size_t j = 0; j < 4; j++) assert_int_equal(got.v[j], vectors[i].want[j]);
    }
}

/// Words from an implementation of the paper's algorithm in another language, checked against the vectors above. They
/// pin which number goes into which word of key and counter: with another order, studies of old could not be repeated.
static void key_and_counter_are_as_documented(void **state)
{
    (void)state;
    static const struct {
        uint64_t seed, stream, sample, variable, word;
    } known[] = {
        {0, 0, 0, 0, 0x16554d9eca36314c},
        {1, 1, 0, 0, 0x66387239d96c2992},
        {0, 1, 2, 3, 0xd3e50df6ac63cd54},
        {20110101, 2, 12345, 7, 0x2126ab46c518881e},
        {UINT64_MAX, 2, UINT64_MAX, UINT64_MAX, 0xbd5700674c44bef1},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        double u;
        pdmc_random_uniform(known[i].seed, (pdmc_stream)known[i].stream, known[i].sample, known[i].variable, 1, &u);
        CHECK_NEAR(u, (double)(known[i].word >> 12) * 0x1p-52 + 0x1p-53, 0.0);
    }
}

static void the_interval_is_open_and_symmetric(void **state)
{
    (void)state;
    CHECK_NEAR(pdmc_random_open_interval(0), 0x1p-53, 0.0);
    CHECK_NEAR(pdmc_random_open_interval(UINT64_MAX), 1.0 - 0x1p-53, 0.0);
    assert_true(pdmc_random_open_interval(UINT64_MAX) < 1.0);
    for (uint64_t word = 1; word != 0; word <<= 1) {
        CHECK_NEAR(pdmc_random_open_interval(~word), 1.0 - pdmc_random_open_interval(word), 0.0);
    }
}

static void any_part_of_a_study_can_be_drawn_alone(void **state)
{
    (void)state;
    enum { SAMPLES = 5, VARIABLES = 40 };
    for (uint64_t sample = 0; sample < SAMPLES; sample++) {
        double row[VARIABLES], tail[VARIABLES];
        pdmc_random_uniform(11, PDMC_STREAM_MICROMODULUS, sample, 0, VARIABLES, row);
        pdmc_random_uniform(11, PDMC_STREAM_MICROMODULUS, sample, 7, VARIABLES - 7, tail);
        for (uint64_t i = 0; i < VARIABLES; i++) {
            double alone;
            pdmc_random_uniform(11, PDMC_STREAM_MICROMODULUS, sample, i, 1, &alone);
            CHECK_NEAR(alone, row[i], 0.0);
            if (i >= 7) CHECK_NEAR(tail[i - 7], row[i], 0.0);
        }
    }
}

static void no_number_is_written_where_none_is_asked(void **state)
{
    (void)state;
    double u = 3.0;
    pdmc_random_uniform(1, PDMC_STREAM_LOAD, 0, 0, 0, &u);
    CHECK_NEAR(u, 3.0, 0.0);
}

enum { MANY = 1000000 };

static double *draw_many(uint64_t seed, pdmc_stream stream, uint64_t sample, uint64_t first)
{
    double *u = pdmc_calloc(MANY, sizeof *u);
    assert_non_null(u);
    pdmc_random_uniform(seed, stream, sample, first, MANY, u);
    return u;
}

/// The correlation of two independent uniforms has standard deviation 1 / sqrt(n); 5 of them are passed by chance once
/// in 2 million.
static void check_uncorrelated(const double u[], const double v[])
{
    double sum = 0.0;
    for (int i = 0; i < MANY; i++) sum += (u[i] - 0.5) * (v[i] - 0.5);
    CHECK_NEAR(12.0 * sum / MANY, 0.0, 5.0 / sqrt(MANY));
}

static void neighbours_are_unrelated(void **state)
{
    (void)state;
    double *u = draw_many(0, PDMC_STREAM_MICROMODULUS, 0, 0);
    double *others[] = {
        draw_many(1, PDMC_STREAM_MICROMODULUS, 0, 0), // seed
        draw_many(0, PDMC_STREAM_LOAD, 0, 0),         // stream
        draw_many(0, PDMC_STREAM_MICROMODULUS, 1, 0), // sample
        draw_many(0, PDMC_STREAM_MICROMODULUS, 0, 1), // variable
    };
    for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
        check_uncorrelated(u, others[k]);
        pdmc_free(others[k]);
    }
    pdmc_free(u);
}

/// E u^k = 1 / (k + 1), var u^k = 1 / (2k + 1) - 1 / (k + 1)^2; within 5 standard deviations of the mean of n.
static void moments_are_those_of_a_uniform(void **state)
{
    (void)state;
    double *u = draw_many(2011, PDMC_STREAM_MICROMODULUS, 3, 0);
    for (int k = 1; k <= 6; k++) {
        double sum = 0.0;
        for (int i = 0; i < MANY; i++) sum += pow(u[i], k);
        const double mean = 1.0 / (k + 1);
        const double variance = 1.0 / (2 * k + 1) - mean * mean;
        CHECK_NEAR(sum / MANY, mean, 5.0 * sqrt(variance / MANY));
    }
    pdmc_free(u);
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/// sqrt(n) D has Kolmogorov's distribution: above 2.69 with probability 2 exp(-2 2.69^2) = 1e-6, below 0.3 with
/// sqrt(2 pi) / 0.3 exp(-pi^2 / (8 0.3^2)) = 1e-5. Too even is as wrong as too uneven.
static void the_distribution_is_uniform(void **state)
{
    (void)state;
    double *u = draw_many(2011, PDMC_STREAM_LOAD, 5, 0);
    qsort(u, MANY, sizeof *u, compare);
    double distance = 0.0;
    for (int i = 0; i < MANY; i++) {
        distance = fmax(distance, fmax((i + 1.0) / MANY - u[i], u[i] - (double)i / MANY));
    }
    assert_true(sqrt(MANY) * distance < 2.69);
    assert_true(sqrt(MANY) * distance > 0.3);
    pdmc_free(u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_generator_is_philox4x64_10),
        cmocka_unit_test(key_and_counter_are_as_documented),
        cmocka_unit_test(the_interval_is_open_and_symmetric),
        cmocka_unit_test(any_part_of_a_study_can_be_drawn_alone),
        cmocka_unit_test(no_number_is_written_where_none_is_asked),
        cmocka_unit_test(neighbours_are_unrelated),
        cmocka_unit_test(moments_are_those_of_a_uniform),
        cmocka_unit_test(the_distribution_is_uniform),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
