// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/whole_file.h"

#include "check.h"
#include "pdmc/results.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <errno.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

int __real_link(const char *from, const char *to);
int __wrap_link(const char *from, const char *to);
int __real_fsync(int descriptor);
int __wrap_fsync(int descriptor);

static int link_error, sync_error; // errno of every call, 0 for the real call

int __wrap_link(const char *from, const char *to)
{
    if (link_error == 0) return __real_link(from, to);
    errno = link_error;
    return -1;
}

int __wrap_fsync(int descriptor)
{
    if (sync_error == 0) return __real_fsync(descriptor);
    errno = sync_error;
    return -1;
}

static pdmc_results results;

static int make_results(void **state)
{
    results = made_up_results(made_up_small);
    return scratch_make(state);
}

static int clear_results(void **state)
{
    pdmc_results_clear(&results);
    return scratch_remove(state);
}

static void check_write(const char *path, bool overwrite, pdmc_status want, const char *text)
{
    CHECK_STATUS(pdmc_results_write(&results, path, overwrite), want);
    if (want != PDMC_OK && !strstr(pdmc_last_error(), text))
        fail_msg("\"%s\" does not say \"%s\"", pdmc_last_error(), text);
}

static void an_existing_file_is_kept_unless_asked(void **state)
{
    (void)state;
    const char *path = scratch_path("results.h5");
    size_t size;
    scratch_write(path, 4, "mine");
    check_write(path, false, PDMC_ERR_CREATE, "exists already; --force overwrites it");
    char *bytes = scratch_read(path, &size);
    assert_string_equal(bytes, "mine");
    free(bytes);
    check_write(path, true, PDMC_OK, "");
    assert_int_equal(scratch_empty(scratch), 1);
}

/// Between the first look and the end of the writing somebody else takes the name.
static void a_file_that_appears_meanwhile_is_kept(void **state)
{
    (void)state;
    const int errors[] = {0, EPERM}; // with hard links and without
    for (int i = 0; i < 2; i++) {
        pdmc_whole_file file;
        size_t size;
        CHECK_OK(pdmc_whole_file_open(scratch_path("results.h5"), false, &file));
        scratch_write(scratch_path("results.h5"), 4, "mine");
        link_error = errors[i];
        CHECK_STATUS(pdmc_whole_file_appear(&file, false), PDMC_ERR_CREATE);
        link_error = 0;
        pdmc_whole_file_discard(&file);
        char *bytes = scratch_read(scratch_path("results.h5"), &size);
        assert_string_equal(bytes, "mine");
        free(bytes);
        assert_int_equal(scratch_empty(scratch), 1);
    }
}

static void file_systems_without_links_will_do(void **state)
{
    (void)state;
    pdmc_results back;
    link_error = EPERM;
    check_write(scratch_path("results.h5"), false, PDMC_OK, "");
    link_error = 0;
    CHECK_OK(pdmc_results_read(scratch_path("results.h5"), &back));
    pdmc_results_clear(&back);
    assert_int_equal(scratch_empty(scratch), 1);
}

static void a_failed_sync_leaves_nothing(void **state)
{
    (void)state;
    sync_error = EIO;
    check_write(scratch_path("results.h5"), true, PDMC_ERR_IO, "Input/output error");
    sync_error = 0;
    assert_int_equal(scratch_empty(scratch), 0);
}

static void the_reason_is_named(void **state)
{
    (void)state;
    check_write(scratch_path("none/results.h5"), false, PDMC_ERR_CREATE, "no such folder");
    check_write(scratch, true, PDMC_ERR_CREATE, "is a folder");
    check_write("", false, PDMC_ERR_ARG, "empty");
    check_write("/proc/results.h5", false, PDMC_ERR_CREATE, "/proc/results.h5");
    if (geteuid() != 0) check_write("/results.h5", false, PDMC_ERR_CREATE, "no permission");
    CHECK_STATUS(pdmc_raise_errno("x", EACCES), PDMC_ERR_CREATE);
    CHECK_STATUS(pdmc_raise_errno("x", EROFS), PDMC_ERR_CREATE);
    CHECK_STATUS(pdmc_raise_errno("x", ENOSPC), PDMC_ERR_IO);
    assert_non_null(strstr(pdmc_last_error(), "the disk is full"));
    CHECK_STATUS(pdmc_raise_errno("x", EDQUOT), PDMC_ERR_IO);
    CHECK_STATUS(pdmc_raise_errno("x", 123456), PDMC_ERR_IO);
    assert_int_equal(scratch_empty(scratch), 0);
}

/// A limit on the size of files fails writes as a full disk does, at each length in turn.
static void a_full_disk_leaves_nothing(void **state)
{
    (void)state;
    struct rlimit before;
    struct stat properties;
    const char *path = scratch_path("results.h5");
    check_write(path, true, PDMC_OK, "");
    assert_int_equal(stat(path, &properties), 0);
    scratch_empty(scratch);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before);
    for (rlim_t limit = 0; limit < (rlim_t)properties.st_size; limit += 1009) {
        const struct rlimit now = {limit, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &now);
        const pdmc_status status = pdmc_results_write(&results, path, limit % 2 == 0);
        setrlimit(RLIMIT_FSIZE, &before);
        if (status != PDMC_ERR_IO || !strstr(pdmc_last_error(), "larger than files may be"))
            fail_msg("limit %llu: %s", (unsigned long long)limit, pdmc_last_error());
        assert_int_equal(scratch_empty(scratch), 0);
    }
    check_write(path, false, PDMC_OK, "");
    scratch_empty(scratch);
}

static void the_umask_decides_who_may_read(void **state)
{
    (void)state;
    struct stat properties;
    const mode_t before = umask(027);
    check_write(scratch_path("results.h5"), false, PDMC_OK, "");
    umask(before);
    assert_int_equal(stat(scratch_path("results.h5"), &properties), 0);
    assert_int_equal(properties.st_mode & 0777, 0640);
    scratch_empty(scratch);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_existing_file_is_kept_unless_asked),
        cmocka_unit_test(a_file_that_appears_meanwhile_is_kept),
        cmocka_unit_test(file_systems_without_links_will_do),
        cmocka_unit_test(a_failed_sync_leaves_nothing),
        cmocka_unit_test(the_reason_is_named),
        cmocka_unit_test(a_full_disk_leaves_nothing),
        cmocka_unit_test(the_umask_decides_who_may_read),
    };
    return cmocka_run_group_tests(tests, make_results, clear_results);
}
