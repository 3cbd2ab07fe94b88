// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"

#include <string.h>

static void a_message_may_quote_the_previous_one(void **state)
{
    (void)state;
    assert_int_equal(pdmc_raise(PDMC_ERR_ARG, "n = %d", 3), PDMC_ERR_ARG);
    assert_int_equal(pdmc_raise(PDMC_ERR_DATA, "reading: %s", pdmc_last_error()), PDMC_ERR_DATA);
    assert_string_equal(pdmc_last_error(), "reading: n = 3");
}

static void every_status_has_a_text(void **state)
{
    (void)state;
    assert_string_equal(pdmc_status_string(PDMC_OK), "success");
    assert_string_equal(pdmc_status_string(PDMC_ERR_EXTERN), "an external library failed");
    assert_string_equal(pdmc_status_string((pdmc_status)1000), "unknown status");
}

static pdmc_status two_allocations(void)
{
    pdmc_status status = PDMC_OK;
    double *a = NULL, *b = NULL;
    PDMC_NEW(a, 3);
    PDMC_NEW(b, 0);
    assert_int_equal((uintptr_t)a % 64, 0);
    assert_true(a[0] == 0.0 && a[2] == 0.0);
done:
    pdmc_free(a);
    pdmc_free(b);
    return status;
}

static void a_refused_allocation_is_reported(void **state)
{
    (void)state;
    CHECK_FAILS_CLEANLY(two_allocations(), (void)0);
    assert_null(pdmc_calloc(SIZE_MAX / 2, 8));
    assert_non_null(strstr(pdmc_last_error(), "out of memory"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_message_may_quote_the_previous_one),
        cmocka_unit_test(every_status_has_a_text),
        cmocka_unit_test(a_refused_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
