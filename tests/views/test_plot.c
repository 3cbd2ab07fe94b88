// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/views.h"

#include "check.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <sys/stat.h>

static char path_before[4096];

static int keep_path(void **state)
{
    snprintf(path_before, sizeof path_before, "%s", getenv("PATH"));
    return scratch_make(state);
}

static void skip_without_gnuplot(void)
{
    if (system("gnuplot --version >/dev/null 2>&1") != 0) skip();
}

/// Lets a shell script be gnuplot.
static void pretend(const char *script)
{
    char command[256];
    snprintf(command, sizeof command, "#!/bin/sh\n%s\n", script);
    scratch_write(scratch_path("gnuplot"), strlen(command), command);
    chmod(scratch_path("gnuplot"), 0755);
    setenv("PATH", scratch, 1);
}

static void check_picture(const char *stem)
{
    static const unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    char name[128];
    size_t size = 0;
    snprintf(name, sizeof name, "plots/%s.png", stem);
    char *bytes = scratch_read(scratch_path(name), &size);
    if (!bytes || size < 1000) fail_msg("%s is missing or empty", name);
    assert_memory_equal(bytes, signature, sizeof signature);
    const unsigned char *width = (const unsigned char *)bytes + 16; // of the header chunk, big-endian
    assert_true((width[2] << 8) + width[3] >= 1200);
    free(bytes);
    snprintf(name, sizeof name, "plots/%s.svg", stem);
    bytes = scratch_read(scratch_path(name), &size);
    if (!bytes || !strstr(bytes, "</svg>")) fail_msg("%s is missing or cut", name);
    free(bytes);
}

static void every_picture_is_drawn(void **state)
{
    (void)state;
    static const char *const stems[] = {
        "pdf_center.from_bond_energy",     "quantiles_center.from_bond_energy",     "direction_center.from",
        "pdf_center.from_griffith_energy", "quantiles_center.from_griffith_energy", "direction_center.to",
        "pdf_center.to_bond_energy",       "quantiles_center.to_bond_energy",       "micromodulus",
        "pdf_center.to_griffith_energy",   "quantiles_center.to_griffith_energy",   "plate",
    };
    skip_without_gnuplot();
    pdmc_results results = made_up_results(made_up_small);
    CHECK_OK(pdmc_view_plot(&results, scratch_path("plots")));
    for (size_t i = 0; i < sizeof stems / sizeof stems[0]; i++) check_picture(stems[i]);
    assert_int_equal(scratch_empty(scratch_path("plots")), 2 * sizeof stems / sizeof stems[0]);
    scratch_empty(scratch);
    pdmc_results_clear(&results);
}

static void a_motion_is_drawn(void **state)
{
    (void)state;
    skip_without_gnuplot();
    pdmc_results results = made_up_results(made_up_motion);
    strcpy(results.motion.probes[0].name, "it's_{a}");
    CHECK_OK(pdmc_view_plot(&results, scratch_path("plots")));
    check_picture("motion_energies");
    check_picture("motion_displacements");
    assert_int_equal(scratch_empty(scratch_path("plots")), 6); // and the plate
    scratch_empty(scratch);
    pdmc_results_clear(&results);
}

static void odd_results_are_drawn(void **state)
{
    (void)state;
    const made_up_size sizes[] = {
        {0},
        {.times = 1, .probes = 1},
        {.cracks = 1, .angles = 1, .samples = 2, .failed = 2, .histogram_bins = 1},
        {.cracks = 1, .angles = 3, .samples = 1, .radial_bins = 1, .histogram_bins = 0},
    };
    skip_without_gnuplot();
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        pdmc_results results = made_up_results(sizes[i]);
        CHECK_OK(pdmc_view_plot(&results, scratch_path("plots")));
        check_picture("plate");
        pdmc_results_clear(&results);
        scratch_empty(scratch);
    }
}

/// A result file may come from anybody, and gnuplot can run commands.
static void texts_are_not_commands(void **state)
{
    (void)state;
    skip_without_gnuplot();
    pdmc_results results = made_up_results(made_up_small);
    char title[512];
    snprintf(title, sizeof title,
             "'\nsystem('touch %s/harm')\n!touch %s/harm\n`touch %s/harm` $(touch %s/harm) {^_@&~\\", scratch, scratch,
             scratch, scratch);
    pdmc_free(results.title);
    results.title = pdmc_strdup(title);
    strcpy(results.tips[0].name, "../../it's_{a}\ntip");
    CHECK_OK(pdmc_view_plot(&results, scratch_path("it's")));
    assert_int_not_equal(access(scratch_path("harm"), F_OK), 0);
    assert_int_equal(access(scratch_path("it's/direction_.._.._it's_{a}_tip.png"), F_OK), 0);
    assert_int_equal(scratch_empty(scratch), 1);
    CHECK_STATUS(pdmc_view_plot(&results, scratch_path("a\nb")), PDMC_ERR_CREATE);
    scratch_empty(scratch);
    pdmc_results_clear(&results);
}

static void a_missing_gnuplot_is_named(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    setenv("PATH", scratch, 1);
    CHECK_STATUS(pdmc_view_plot(&results, scratch_path("plots")), PDMC_ERR_EXTERN);
    setenv("PATH", path_before, 1);
    assert_string_equal(pdmc_last_error(), "gnuplot not found: install gnuplot-nox");
    assert_int_equal(scratch_empty(scratch_path("plots")), 0);
    pdmc_results_clear(&results);
    scratch_empty(scratch);
}

static void a_failing_gnuplot_leaves_nothing(void **state)
{
    (void)state;
    const struct {
        const char *script, *message;
    } cases[] = {
        {"echo first >&2; echo '  line 3: no such terminal' >&2; echo >&2; exit 2", "no such terminal"},
        {"exit 0", "empty"},
        {"kill -9 $$", "no message"},
    };
    pdmc_results results = made_up_results(made_up_small);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        pretend(cases[i].script);
        const pdmc_status status = pdmc_view_plot(&results, scratch_path("plots"));
        setenv("PATH", path_before, 1);
        if (status != PDMC_ERR_EXTERN || !strstr(pdmc_last_error(), cases[i].message))
            fail_msg("%s", pdmc_last_error());
        assert_int_equal(scratch_empty(scratch_path("plots")), 0);
    }
    pdmc_results_clear(&results);
    scratch_empty(scratch);
}

static void refused_memory_is_reported(void **state)
{
    (void)state;
    pdmc_results results = made_up_results((made_up_size){0});
    skip_without_gnuplot();
    CHECK_FAILS_CLEANLY(pdmc_view_plot(&results, scratch_path("plots")), (void)0);
    assert_int_equal(scratch_empty(scratch_path("plots")), 2);
    pdmc_results_clear(&results);
    scratch_empty(scratch);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_picture_is_drawn),     cmocka_unit_test(odd_results_are_drawn),
        cmocka_unit_test(texts_are_not_commands),     cmocka_unit_test(a_motion_is_drawn),
        cmocka_unit_test(a_missing_gnuplot_is_named), cmocka_unit_test(a_failing_gnuplot_leaves_nothing),
        cmocka_unit_test(refused_memory_is_reported),
    };
    return cmocka_run_group_tests(tests, keep_path, scratch_remove);
}
