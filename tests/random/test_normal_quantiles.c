// SPDX-License-Identifier: GPL-3.0-or-later

/// Many normal quantiles at once against GSL's one by one, which has the same algorithm: to the bit where neither is contracted
/// to FMA, and to a few units in the last place elsewhere.

#include "check.h"

#include "pdmc/random.h"

#include <float.h>

static void check(size_t count, const double u[])
{
    double z[300];
    for (size_t i = 0; i < count; i++) z[i] = u[i];
    pdmc_normal_quantiles(count, z);
    for (size_t i = 0; i < count; i++) {
        const double one = pdmc_normal_quantile(u[i]);
        CHECK_NEAR(z[i], one, 8 * DBL_EPSILON * fabs(one));
    }
}

static void many_are_as_one_by_one(void **state)
{
    (void)state;
    double u[300];
    for (size_t count = 0; count < 300; count += 23)
        for (uint64_t sample = 0; sample < 500; sample++) {
            pdmc_random_uniform(7, PDMC_STREAM_LOAD, sample, 0, count, u);
            check(count, u);
        }
}

// The tails, where they meet the middle, and the middle itself.
static void ends_and_joints(void **state)
{
    (void)state;
    const double u[] = {0x1p-53,       1e-10,           0.075 - 0x1p-53, 0.075,           0.075 + 0x1p-53, 0.5,
                        0.5 + 0x1p-53, 0.925 - 0x1p-53, 0.925,           0.925 + 0x1p-53, 1.0 - 0x1p-53};
    check(sizeof u / sizeof u[0], u);
    double half = 0.5;
    pdmc_normal_quantiles(1, &half);
    CHECK_NEAR(half, 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_are_as_one_by_one),
        cmocka_unit_test(ends_and_joints),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
