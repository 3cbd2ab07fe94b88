// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/design.h"
#include "pdmc/random.h"
#include "pdmc/statistics.h"

#include "random/design_impl.h"

#include "check.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>
#include <stdlib.h>
#include <string.h>

static const pdmc_design_kind kinds[] = {PDMC_DESIGN_LATIN_HYPERCUBE, PDMC_DESIGN_SOBOL};

static pdmc_design *design_of(pdmc_design_kind kind, uint64_t seed, size_t dimension, uint64_t samples,
                              uint64_t replicates)
{
    pdmc_design *design = NULL;
    CHECK_OK(pdmc_design_create(kind, seed, dimension, samples, replicates, &design));
    return design;
}

/// @return [samples, dimension], to be freed
static double *points_of(const pdmc_design *design)
{
    double *u = malloc(design->samples * design->dimension * sizeof *u);
    for (uint64_t i = 0; i < design->samples; i++) pdmc_design_point(design, i, &u[i * design->dimension]);
    return u;
}

/// Passed by chance once in 10^5 by what is random.
static void check_chi_squared(double statistic, double freedom)
{
    const double tail = gsl_cdf_chisq_Q(statistic, freedom);
    if (!(1e-5 < tail && tail < 1.0 - 1e-5)) fail_msg("chi^2 = %g of %g degrees, tail %g", statistic, freedom, tail);
}

static void check_counts(size_t cells, const int counts[], double expected)
{
    double statistic = 0.0;
    for (size_t i = 0; i < cells; i++) statistic += gsl_pow_2(counts[i] - expected) / expected;
    check_chi_squared(statistic, (double)cells - 1.0);
}

/// Kolmogorov's distance of numbers from the uniform distribution, passed by chance once in 10^5.
static void check_uniform(size_t n, double u[])
{
    double distance = 0.0;
    gsl_sort(u, 1, n);
    for (size_t i = 0; i < n; i++)
        distance = fmax(distance, fmax(u[i] - (double)i / (double)n, (double)(i + 1) / (double)n - u[i]));
    assert_true(pdmc_statistics_kolmogorov(sqrt((double)n) * distance) > 1e-5);
}

/// Whether of the points first ... first + n - 1 of a replicate one is in each of n equal intervals of dimension j.
static bool is_stratified(const pdmc_design *design, const double u[], uint64_t replicate, size_t first, size_t n,
                          size_t j)
{
    bool *seen = calloc(n, sizeof *seen), all = true;
    for (size_t i = first; i < first + n; i++) {
        const size_t interval = (size_t)(u[(i * design->replicates + replicate) * design->dimension + j] * (double)n);
        all = all && !seen[interval];
        seen[interval] = true;
    }
    free(seen);
    return all;
}

static void each_dimension_has_a_point_in_each_interval(void **state)
{
    (void)state;
    enum { DIMENSIONS = 1200, POINTS = 64, REPLICATES = 2 };
    pdmc_design *design = design_of(PDMC_DESIGN_SOBOL, 1, DIMENSIONS, POINTS * REPLICATES, REPLICATES);
    double *u = points_of(design);
    for (size_t j = 0; j < DIMENSIONS; j++)
        for (size_t n = 1; n <= POINTS; n *= 2)
            for (size_t first = 0; first < POINTS; first += n)
                for (uint64_t r = 0; r < REPLICATES; r++) assert_true(is_stratified(design, u, r, first, n, j));
    free(u);
    pdmc_design_destroy(&design);
    static const size_t sizes[] = {1, 2, 3, 6, 37, 375, 1000};
    for (int k = 0; k < 7; k++) {
        design = design_of(PDMC_DESIGN_LATIN_HYPERCUBE, 1, 20, 3 * sizes[k], 3);
        u = points_of(design);
        for (size_t j = 0; j < 20; j++)
            for (uint64_t r = 0; r < 3; r++) assert_true(is_stratified(design, u, r, 0, sizes[k], j));
        free(u);
        pdmc_design_destroy(&design);
    }
}

/// The first two dimensions are a (0, 2)-sequence: of 2^m points from a multiple of 2^m, each box of 2^-k by 2^(k - m)
/// has one.
static void the_first_two_dimensions_are_a_net(void **state)
{
    (void)state;
    enum { M = 9, POINTS = 1 << M, REPLICATES = 3 };
    pdmc_design *design = design_of(PDMC_DESIGN_SOBOL, 2, 2, 2 * POINTS * REPLICATES, REPLICATES);
    double *u = points_of(design);
    for (int k = 0; k <= M; k++) {
        bool seen[2 * REPLICATES][POINTS] = {{false}};
        for (size_t i = 0; i < design->samples; i++) {
            const size_t net = i % REPLICATES + (i / REPLICATES < POINTS ? 0 : REPLICATES);
            const size_t box = ((size_t)ldexp(u[2 * i], k) << (M - k)) + (size_t)ldexp(u[2 * i + 1], M - k);
            assert_false(seen[net][box]);
            seen[net][box] = true;
        }
    }
    free(u);
    pdmc_design_destroy(&design);
}

/// Point n of GSL's sequence belongs to the Gray code of n, n ^ n >> 1; its 30 digits are ours without scrambling.
static void the_first_forty_dimensions_are_those_of_gsl(void **state)
{
    (void)state;
    enum { DIMENSIONS = 40, POINTS = 1 << 15 };
    static uint32_t directions[DIMENSIONS][PDMC_SOBOL_DIGITS];
    CHECK_OK(pdmc_sobol_directions(DIMENSIONS, directions[0]));
    gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, DIMENSIONS);
    for (uint32_t n = 1; n < POINTS; n++) {
        double want[DIMENSIONS];
        gsl_qrng_get(sequence, want);
        for (int j = 0; j < DIMENSIONS; j++) {
            uint32_t digits = 0;
            for (uint32_t gray = n ^ n >> 1, k = 0; gray; gray >>= 1, k++)
                if (gray & 1) digits ^= directions[j][k];
            CHECK_NEAR((digits >> 2) * 0x1p-30, want[j], 0.0);
        }
    }
    gsl_qrng_free(sequence);
}

/// Of degree s there are phi(2^s - 1) / s primitive polynomials, phi by its definition.
static void the_primitive_polynomials_are_as_many_as_there_are(void **state)
{
    (void)state;
    for (int s = 1; s <= 12; s++) {
        const uint32_t order = (UINT32_C(1) << s) - 1;
        uint32_t coprime = 0, found = 0;
        for (uint32_t a = 1; a <= order; a++) {
            uint32_t x = a, y = order;
            while (y) {
                const uint32_t rest = x % y;
                x = y;
                y = rest;
            }
            coprime += x == 1;
        }
        for (uint32_t p = order + 1; p <= 2 * order + 1; p++) found += pdmc_polynomial_is_primitive(p);
        assert_int_equal(found * (uint32_t)s, coprime);
    }
}

static void a_permutation_takes_each_index_once(void **state)
{
    (void)state;
    bool seen[3000];
    for (uint64_t n = 1; n <= 3000; n += 1 + n / 20) {
        memset(seen, 0, sizeof seen);
        for (uint64_t i = 0; i < n; i++) {
            const uint64_t image = pdmc_random_permutation(7, 1, 2, n, i);
            assert_true(image < n && !seen[image]);
            seen[image] = true;
        }
    }
}

/// All 24 permutations of four are as likely; of more, each pair of images of two indices, and each order of four.
static void permutations_are_uniform(void **state)
{
    (void)state;
    enum { DRAWS = 24000 };
    int counts[24 * 24];
    static const uint64_t sizes[] = {4, 5, 6, 9, 16, 24};
    for (int k = 0; k < 6; k++) {
        const uint64_t n = sizes[k];
        int pairs[24 * 24] = {0};
        memset(counts, 0, sizeof counts);
        for (uint64_t draw = 0; draw < DRAWS; draw++) {
            uint64_t image[4], order = 0;
            for (uint64_t i = 0; i < 4; i++) image[i] = pdmc_random_permutation(3, draw, 5, n, i);
            for (int i = 1; i < 4; i++) // the number of the order, by Lehmer's code
                for (int j = 0; j < i; j++) order += (image[j] > image[i]) * (i == 1 ? 1U : i == 2 ? 2U : 6U);
            counts[order]++;
            const uint64_t second = image[3] - (image[3] > image[0]);
            pairs[image[0] * (n - 1) + second]++;
        }
        check_counts(24, counts, DRAWS / 24.0);
        check_counts(n * (n - 1), pairs, DRAWS / (double)(n * (n - 1)));
    }
}

/// Over many seeds each point is uniform, and points of two replicates, two dimensions or two seeds are independent.
static void points_are_uniform_and_replicates_independent(void **state)
{
    (void)state;
    enum { SEEDS = 20000, PAIRS = 4 };
    static double a[PAIRS][SEEDS], b[PAIRS][SEEDS];
    for (int k = 0; k < 2; k++) {
        for (uint64_t seed = 0; seed < SEEDS; seed++) {
            double u[3][2];
            pdmc_design *design = design_of(kinds[k], seed, 2, 8, 2);
            for (uint64_t i = 0; i < 3; i++)
                pdmc_design_point(design, i, u[i]); // 0 and 2 of one replicate, 1 of the other
            pdmc_design_destroy(&design);
            a[0][seed] = u[0][0], b[0][seed] = u[1][0];               // replicates
            a[1][seed] = u[0][0], b[1][seed] = u[0][1];               // dimensions
            a[2][seed] = u[2][0], b[2][seed] = u[2][1];               // dimensions, of another point
            a[3][seed] = u[0][1], b[3][(seed + 1) % SEEDS] = u[0][1]; // seeds
        }
        for (int pair = 0; pair < PAIRS; pair++) {
            int boxes[64] = {0};
            for (int i = 0; i < SEEDS; i++) boxes[(int)(8.0 * a[pair][i]) * 8 + (int)(8.0 * b[pair][i])]++;
            check_counts(64, boxes, SEEDS / 64.0);
            check_uniform(SEEDS, a[pair]);
            check_uniform(SEEDS, b[pair]);
        }
    }
}

/// In one dimension both designs are one uniform point in each of n intervals, independently: the variance of the mean
/// of u is 1 / (12 n^3). Only complete scrambling, down to all digits, has it.
static void one_dimension_is_a_stratified_sample(void **state)
{
    (void)state;
    enum { POINTS = 32, REPLICATES = 4000 };
    for (int k = 0; k < 2; k++) {
        pdmc_design *design = design_of(kinds[k], 4, 1, POINTS * REPLICATES, REPLICATES);
        double *u = points_of(design), squares = 0.0;
        for (int r = 0; r < REPLICATES; r++) {
            const double error = gsl_stats_mean(&u[r], REPLICATES, POINTS) - 0.5;
            squares += error * error * 12.0 * gsl_pow_3(POINTS);
        }
        check_chi_squared(squares, REPLICATES); // the mean of 32 is normal to 1e-2 in its kurtosis
        for (int i = 0; i < POINTS * REPLICATES; i++) u[i] = fmod(u[i] * POINTS, 1.0);
        check_uniform(POINTS * REPLICATES, u); // within the intervals
        for (int i = 0; i < POINTS * REPLICATES; i++) u[i] = fmod(u[i] * 0x1p27, 1.0);
        check_uniform(POINTS * REPLICATES, u); // and past the 32 digits of Sobol' sequences
        free(u);
        pdmc_design_destroy(&design);
    }
}

static double smooth(const double u[6])
{
    double product = 1.0;
    for (int j = 0; j < 6; j++) product *= 1.0 + (exp(u[j]) - (M_E - 1.0)) / (1.0 + j);
    return product; // 1 in the mean
}

static double additive(const double u[6])
{
    double sum = 1.0;
    for (int j = 0; j < 6; j++) sum += exp(u[j]) - (M_E - 1.0);
    return sum;
}

/// The root mean square of the error of a replicate's mean.
static double error_of(pdmc_design_kind kind, size_t points, double (*f)(const double[6]))
{
    enum { REPLICATES = 100 };
    double squares = 0.0, mean[REPLICATES] = {0.0}, u[6];
    pdmc_design *design =
        kind == PDMC_DESIGN_MONTE_CARLO ? NULL : design_of(kind, 5, 6, points * REPLICATES, REPLICATES);
    for (size_t i = 0; i < points * REPLICATES; i++) {
        if (design) pdmc_design_point(design, i, u);
        else pdmc_random_uniform(5, PDMC_STREAM_LOAD, i, 0, 6, u);
        mean[i % REPLICATES] += f(u) / (double)points;
    }
    for (int r = 0; r < REPLICATES; r++) squares += gsl_pow_2(mean[r] - 1.0) / REPLICATES;
    pdmc_design_destroy(&design);
    return sqrt(squares);
}

/// Errors of 100 replicates are known to 7 %: over a factor of 256 in n that is 0.02 in an exponent.
static void errors_fall_faster_than_those_of_monte_carlo(void **state)
{
    (void)state;
    const double rate =
        log(error_of(PDMC_DESIGN_SOBOL, 16, smooth) / error_of(PDMC_DESIGN_SOBOL, 4096, smooth)) / log(256.0);
    const double plain = error_of(PDMC_DESIGN_MONTE_CARLO, 256, additive);
    const double latin = error_of(PDMC_DESIGN_LATIN_HYPERCUBE, 256, additive);
    print_message("Sobol': n^-%.2f; additive, Latin hypercube / Monte Carlo: %.4f\n", rate, latin / plain);
    assert_true(rate > 1.2);
    CHECK_NEAR(latin / plain, 0.0, 2.0 / 256.0); // its error is that within the intervals, n^-3/2
    CHECK_NEAR(error_of(PDMC_DESIGN_LATIN_HYPERCUBE, 256, smooth) / error_of(PDMC_DESIGN_MONTE_CARLO, 256, smooth), 0.0,
               0.5);
}

static void a_point_depends_on_its_index_alone(void **state)
{
    (void)state;
    enum { SAMPLES = 256, DIMENSIONS = 45 };
    double u[DIMENSIONS], v[DIMENSIONS];
    for (int k = 0; k < 2; k++) {
        pdmc_design *design = design_of(kinds[k], 6, DIMENSIONS, SAMPLES, 16);
        pdmc_design *narrow = design_of(kinds[k], 6, DIMENSIONS - 3, SAMPLES, 16);
        pdmc_design *longer = design_of(PDMC_DESIGN_SOBOL, 6, DIMENSIONS, 3 * SAMPLES + 5, 16);
        double *points = points_of(design);
        for (uint64_t i = SAMPLES; i-- > 0;) {
            pdmc_design_point(design, i, u);
            assert_memory_equal(u, &points[i * DIMENSIONS], sizeof u);
            pdmc_design_point(narrow, i, v);
            assert_memory_equal(u, v, (DIMENSIONS - 3) * sizeof *u);
            pdmc_design_point(longer, i, v);
            if (kinds[k] == PDMC_DESIGN_SOBOL) assert_memory_equal(u, v, sizeof u);
            for (int j = 0; j < DIMENSIONS; j++) {
                const double odd = ldexp(u[j], 53);
                assert_true(0.0 < u[j] && u[j] < 1.0 && odd == floor(odd) && fmod(odd, 2.0) == 1.0);
            }
        }
        free(points);
        pdmc_design_destroy(&longer);
        pdmc_design_destroy(&narrow);
        pdmc_design_destroy(&design);
    }
}

/// Subtracts the pivot of each bit from a row, and keeps what is left as a pivot; false where nothing is.
static bool add_row(uint32_t pivots[32], uint32_t row)
{
    for (int bit = 31; bit >= 0 && row; bit--) {
        if (!(row >> bit & 1)) continue;
        if (!pivots[bit]) {
            pivots[bit] = row;
            return true;
        }
        row ^= pivots[bit];
    }
    return false;
}

/// The least t for which 2^m points in two dimensions are a (t, m, 2)-net: any k_1 + k_2 = m - t first rows of the two
/// matrices are independent.
static int net_parameter(const uint32_t a[], const uint32_t b[], int m)
{
    int independent = m;
    for (int rows = 0; rows <= m; rows++) {
        uint32_t pivots[32] = {0};
        int count = 0;
        bool more = true;
        for (int i = 0; i < m && more; i++) {
            uint32_t row = 0;
            for (int k = 0; k < m; k++) row |= ((i < rows ? a[k] >> (31 - i) : b[k] >> (31 - i + rows)) & 1) << k;
            more = add_row(pivots, row);
            count += more;
        }
        if (count < independent) independent = count;
    }
    return m - independent;
}

/// How far pairs of dimensions are from the best net, t = 0: of 2^10 points, of GSL's dimensions and those beyond.
static void pairs_of_dimensions(void **state)
{
    (void)state;
    enum { DIMENSIONS = 1100, M = 10, GROUPS = 4, MOST = 10 };
    static const size_t first[GROUPS + 1] = {0, 10, 40, 200, DIMENSIONS};
    double mean[GROUPS], worse[GROUPS];
    int largest[GROUPS] = {0};
    uint32_t(*c)[PDMC_SOBOL_DIGITS] = malloc(DIMENSIONS * sizeof *c);
    CHECK_OK(pdmc_sobol_directions(DIMENSIONS, c[0]));
    for (int g = 0; g < GROUPS; g++) {
        size_t pairs = 0;
        mean[g] = worse[g] = 0.0;
        for (size_t j = first[g]; j < first[g + 1]; j++) {
            for (size_t i = first[g]; i < j; i += 1 + (first[g + 1] - first[g]) / 100, pairs++) {
                const int t = net_parameter(c[i], c[j], M);
                mean[g] += t;
                worse[g] += t > 6;
                if (t > largest[g]) largest[g] = t;
            }
        }
        mean[g] /= (double)pairs;
        worse[g] /= (double)pairs;
        print_message("dimensions %4zu to %4zu: t of 2^%d points %.2f in the mean, above 6 in %.2f %%, at most %d\n",
                      first[g] + 1, first[g + 1], M, mean[g], 100.0 * worse[g], largest[g]);
    }
    free(c);
    // Random initial numbers do about as well as published ones past the first ten dimensions.
    for (int g = 2; g < GROUPS; g++) assert_true(mean[g] < mean[1] + 0.25 && worse[g] < worse[1] + 0.01);
    assert_true(mean[0] < mean[1]);
}

static void what_is_no_design_is_refused(void **state)
{
    (void)state;
    pdmc_design *design = NULL;
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_MONTE_CARLO, 1, 2, 32, 16, &design), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_LATIN_HYPERCUBE, 1, 2, 33, 16, &design), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_SOBOL, 1, 0, 32, 16, &design), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_SOBOL, 1, 2, 0, 16, &design), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_SOBOL, 1, 2, 32, 0, &design), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_SOBOL, 1, 2, (UINT64_C(1) << 32) + 1, 1, &design), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_design_create(PDMC_DESIGN_SOBOL, 1, PDMC_DESIGN_SOBOL_DIMENSIONS + 1, 32, 16, &design),
                 PDMC_ERR_ARG);
    assert_null(design);
    pdmc_design_destroy(&design);
    pdmc_design_destroy(NULL);
    for (int k = 0; k < 2; k++)
        CHECK_FAILS_CLEANLY(pdmc_design_create(kinds[k], 1, 50, 32, 16, &design), pdmc_design_destroy(&design));
}

/// The last of 2^32 points and the last dimension of all, whose polynomial is of degree 18.
static void the_largest_sequence_has_all_its_dimensions(void **state)
{
    (void)state;
    const uint64_t samples = UINT64_C(1) << 32;
    double *u = malloc(PDMC_DESIGN_SOBOL_DIMENSIONS * sizeof *u);
    pdmc_design *design = design_of(PDMC_DESIGN_SOBOL, 1, PDMC_DESIGN_SOBOL_DIMENSIONS, samples, 1);
    const uint32_t *last = &design->directions[(PDMC_DESIGN_SOBOL_DIMENSIONS - 1) * PDMC_SOBOL_DIGITS];
    for (int k = 0; k < PDMC_SOBOL_DIGITS; k++) assert_true((last[k] << k) == UINT32_C(1) << 31);
    pdmc_design_point(design, samples - 1, u);
    check_uniform(PDMC_DESIGN_SOBOL_DIMENSIONS, u);
    pdmc_design_destroy(&design);
    free(u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_dimension_has_a_point_in_each_interval),
        cmocka_unit_test(the_first_two_dimensions_are_a_net),
        cmocka_unit_test(the_first_forty_dimensions_are_those_of_gsl),
        cmocka_unit_test(the_primitive_polynomials_are_as_many_as_there_are),
        cmocka_unit_test(a_permutation_takes_each_index_once),
        cmocka_unit_test(permutations_are_uniform),
        cmocka_unit_test(points_are_uniform_and_replicates_independent),
        cmocka_unit_test(one_dimension_is_a_stratified_sample),
        cmocka_unit_test(errors_fall_faster_than_those_of_monte_carlo),
        cmocka_unit_test(a_point_depends_on_its_index_alone),
        cmocka_unit_test(pairs_of_dimensions),
        cmocka_unit_test(what_is_no_design_is_refused),
        cmocka_unit_test(the_largest_sequence_has_all_its_dimensions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
