// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/views.h"

#include "check.h"
#include "pdmc/statistics.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_sort.h>
#include <sys/stat.h>

static char *exported(const char *name)
{
    char path[512];
    size_t size;
    snprintf(path, sizeof path, "%s/csv/%s", scratch, name);
    char *text = scratch_read(path, &size);
    if (!text) fail_msg("%s was not written", path);
    return text;
}

/// Every line has as many fields as the first; none of the made-up texts is quoted.
static void check_table(const char *name, const char *header, int rows)
{
    char *text = exported(name);
    int count = 0, commas = -1;
    if (strncmp(text, header, strlen(header)) != 0)
        fail_msg("%s begins with %.*s", name, (int)strcspn(text, "\n"), text);
    for (const char *line = text; *line; line += strcspn(line, "\n") + 1, count++) {
        int here = 0;
        for (const char *c = line; *c != '\n'; c++) here += *c == ',';
        if (commas < 0) commas = here;
        if (here != commas) fail_msg("%s: line %d has %d fields, not %d", name, count + 1, here + 1, commas + 1);
    }
    if (count != rows + 1) fail_msg("%s has %d rows, not %d", name, count - 1, rows);
    free(text);
}

static void every_number_has_its_row(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_small);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    check_table(
        "pdf.csv",
        "tip,measure,angle[rad],bin_lower[N/cm],bin_upper[N/cm],density[cm/N],density_lower[cm/N],"
        "density_upper[cm/N],count,smooth_density[cm/N],smooth_density_lower[cm/N],smooth_density_upper[cm/N]\n",
        2 * 2 * 8 * 6);
    check_table("quantiles.csv", "tip,measure,angle[rad],statistic,value[N/cm],lower[N/cm],upper[N/cm]\n",
                2 * 2 * 8 * 5 + 2 * 8); // and the means with a control
    check_table("direction.csv", "tip,measure,angle[rad],probability,lower,upper\n", 2 * 8);
    check_table("samples.csv",
                "sample,failure,load_factor,effective_modulus,contraction,center.from.K_I[N/cm^(3/2)],"
                "center.from.K_II[N/cm^(3/2)],center.from.bond_energy_max[N/cm],center.from.griffith_energy_max[N/cm],"
                "center.from.fracture_energy[N/cm],center.to.K_I",
                40);
    check_table("energy_samples.csv", "sample,tip,angle[rad],bond_energy[N/cm],griffith_energy[N/cm]\n", 40 * 2 * 8);
    check_table("faces.csv", "crack,x[cm],y[cm],left_x[cm],left_y[cm],right_x[cm],right_y[cm]\n",
                r.crack_count * r.field.face_points);
    char *faces = exported("faces.csv"), row[256];
    snprintf(row, sizeof row, "\n0,%.17g,%.17g,%.17g,", r.field.face_position[2], r.field.face_position[3],
             r.field.face_displacement[4]);
    assert_non_null(strstr(faces, row));
    free(faces);
    pdmc_results_clear(&r);
    assert_int_equal(scratch_empty(scratch_path("csv")), 6);
    scratch_empty(scratch);
}

static void energies_are_of_the_samples_that_are_kept(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_small);
    r.kept_count = 7;
    r.sample_fracture_energy[2 * 39 + 1] = 0.25;
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    check_table("samples.csv", "sample,failure,", 40);
    check_table("energy_samples.csv", "sample,tip,", 7 * 2 * 8);
    char *samples = exported("samples.csv"), number[80];
    snprintf(number, sizeof number, ",%.17g,%.17g\n", r.largest_energy[PDMC_MEASURE_GRIFFITH][2 * 39 + 1], 0.25);
    assert_non_null(strstr(samples, number)); // of the last sample, which is not kept
    free(samples);
    pdmc_results_clear(&r);
    scratch_empty(scratch_path("csv"));
    scratch_empty(scratch);
}

/// The sum of the kernels, one for each sample that is kept and one for its image in 0.
static double summed_kernels(const pdmc_results *r, double at)
{
    const int stride = r->tip_count * r->angle_count;
    double x[64], sum = 0.0;
    size_t count = 0;
    for (int s = 0; s < r->kept_count; s++)
        if (r->failure[s] == PDMC_SAMPLE_OK) x[count++] = r->energy[PDMC_MEASURE_BOND][s * stride];
    gsl_sort(x, 1, count);
    const double h = pdmc_statistics_bandwidth(count, x);
    for (size_t i = 0; i < count; i++) sum += gsl_ran_gaussian_pdf(at - x[i], h) + gsl_ran_gaussian_pdf(at + x[i], h);
    return sum / (double)count;
}

// Samples that lie together are one to the kernel, which costs 2e-3 of the density at most: measured 1e-4.
static void smooth_densities_are_of_the_samples_that_are_kept(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_small);
    for (int kept = 20; kept <= 40; kept += 20) {
        r.kept_count = kept;
        CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
        char *text = exported("pdf.csv"), *row = strchr(text, '\n') + 1;
        for (int b = 0; b < r.histogram_bins; b++, row = strchr(row, '\n') + 1) {
            double edge[2], smooth[3];
            const int fields = sscanf(row, "center.from,bond_energy,%*f,%lf,%lf,%*f,%*f,%*f,%*d,%lf,%lf,%lf", &edge[0],
                                      &edge[1], &smooth[0], &smooth[1], &smooth[2]);
            assert_int_equal(fields, 5);
            const double expected = summed_kernels(&r, 0.5 * (edge[0] + edge[1]));
            CHECK_NEAR(smooth[0], expected, 2e-3 * expected);
            assert_true(smooth[1] < smooth[0] && smooth[0] < smooth[2]);
        }
        assert_null(strstr(text, ",nan,nan,nan\n"));
        free(text);
    }
    r.kept_count = r.failed_count; // none that has an energy
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    char *text = exported("pdf.csv");
    assert_non_null(strstr(text, ",nan,nan,nan\n"));
    free(text);
    pdmc_results_clear(&r);
    scratch_empty(scratch_path("csv"));
    scratch_empty(scratch);
}

static void a_motion_has_a_row_for_each_time(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_motion);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    check_table(
        "motion.csv",
        "time[ms],load_factor,kinetic[N cm],elastic[N cm],dissipated[N cm],work[N cm],probe1.x[cm],probe1.y[cm],"
        "probe2.x[cm],probe2.y[cm]\n",
        201);
    pdmc_results_clear(&r);
    assert_int_equal(scratch_empty(scratch_path("csv")), 1);
    scratch_empty(scratch);
}

static void numbers_survive_exactly(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_small);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    char *text = exported("samples.csv"), *end;
    const char *row = strstr(text, "\n7,none,");
    assert_non_null(row);
    CHECK_NEAR(strtod(row + strlen("\n7,none,"), &end), r.load_factor[7], 0.0);
    CHECK_NEAR(strtod(end + 1, &end), r.effective_modulus[7], 0.0);
    assert_non_null(strstr(text, "\n0,diverged,"));
    free(text);
    pdmc_results_clear(&r);
    scratch_empty(scratch);
}

static void commas_and_quotes_are_quoted(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_small);
    strcpy(r.tips[0].name, "a,\"b\"");
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    char *text = exported("direction.csv");
    assert_non_null(strstr(text, "\n\"a,\"\"b\"\"\",griffith_energy,"));
    free(text);
    pdmc_results_clear(&r);
    scratch_empty(scratch);
}

static void too_many_energies_are_left_to_the_file(void **state)
{
    (void)state;
    pdmc_results r = made_up_results((made_up_size){.cracks = 2, .angles = 2, .samples = 125001, .histogram_bins = 1});
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    assert_int_not_equal(access(scratch_path("csv/energy_samples.csv"), F_OK), 0);
    pdmc_results_clear(&r);
    scratch_empty(scratch);
}

static void odd_results_are_exported(void **state)
{
    (void)state;
    pdmc_results r = made_up_results((made_up_size){0});
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    check_table("samples.csv", "sample,failure,load_factor,effective_modulus,contraction\n", 0);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv"))); // a second time, over the first
    CHECK_FAILS_CLEANLY(pdmc_view_export(&r, scratch_path("csv")), (void)0);
    assert_int_equal(scratch_empty(scratch_path("csv")), 6);
    pdmc_results_clear(&r);
    scratch_empty(scratch);
}

static void a_bad_folder_is_named(void **state)
{
    (void)state;
    pdmc_results r = made_up_results(made_up_small);
    CHECK_STATUS(pdmc_view_export(&r, scratch_path("none/csv")), PDMC_ERR_CREATE);
    assert_non_null(strstr(pdmc_last_error(), "no such folder"));
    scratch_write(scratch_path("file"), 1, "x");
    CHECK_STATUS(pdmc_view_export(&r, scratch_path("file")), PDMC_ERR_CREATE);
    assert_non_null(strstr(pdmc_last_error(), "not a folder"));
    assert_int_equal(mkdir(scratch_path("csv"), 0777), 0);
    assert_int_equal(mkdir(scratch_path("csv/pdf.csv"), 0777), 0);
    CHECK_STATUS(pdmc_view_export(&r, scratch_path("csv")), PDMC_ERR_CREATE);
    pdmc_results_clear(&r);
    scratch_empty(scratch);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_has_its_row),
        cmocka_unit_test(numbers_survive_exactly),
        cmocka_unit_test(commas_and_quotes_are_quoted),
        cmocka_unit_test(too_many_energies_are_left_to_the_file),
        cmocka_unit_test(odd_results_are_exported),
        cmocka_unit_test(a_bad_folder_is_named),
        cmocka_unit_test(energies_are_of_the_samples_that_are_kept),
        cmocka_unit_test(smooth_densities_are_of_the_samples_that_are_kept),
        cmocka_unit_test(a_motion_has_a_row_for_each_time),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
