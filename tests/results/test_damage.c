// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/results.h"

#include "check.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <hdf5.h>

/// HDF5 1.10 itself forgets memory where it gives up on a damaged file.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libhdf5";
}

/// It also asks for what a damaged length says, and takes no for an answer.
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "allocator_may_return_null=1";
}

static char *whole;
static size_t whole_size;

static int write_whole(void **state)
{
    if (scratch_make(state) != 0) return -1;
    pdmc_results results = made_up_results(made_up_small);
    const pdmc_status status = pdmc_results_write(&results, scratch_path("whole.h5"), false);
    pdmc_results_clear(&results);
    whole = scratch_read(scratch_path("whole.h5"), &whole_size);
    return status == PDMC_OK && whole ? 0 : -1;
}

static int forget_whole(void **state)
{
    free(whole);
    return scratch_remove(state);
}

/// Reads a file that must be refused with one line that has `text` in it, leaving nothing behind.
static void check_refused(const char *path, pdmc_status want, const char *text)
{
    const pdmc_results zero = {0};
    pdmc_results results;
    CHECK_STATUS(pdmc_results_read(path, &results), want);
    assert_memory_equal(&results, &zero, sizeof zero);
    if (!strstr(pdmc_last_error(), text)) fail_msg("\"%s\" does not say \"%s\"", pdmc_last_error(), text);
    assert_null(strchr(pdmc_last_error(), '\n'));
}

static void a_truncated_file_is_refused_at_every_length(void **state)
{
    (void)state;
    const char *path = scratch_path("part.h5");
    for (size_t length = 0; length < whole_size; length += length < 4096 ? 61 : 499) {
        scratch_write(path, length, whole);
        check_refused(path, PDMC_ERR_DATA, path);
    }
    scratch_write(path, whole_size - 1, whole);
    check_refused(path, PDMC_ERR_DATA, "truncated");
}

static void what_is_no_result_file_is_refused(void **state)
{
    (void)state;
    const char *path = scratch_path("other.h5");
    check_refused(scratch_path("none.h5"), PDMC_ERR_NO_INPUT, "No such file");
    check_refused(scratch, PDMC_ERR_NO_INPUT, "not a file");
    scratch_write(path, 0, "");
    check_refused(path, PDMC_ERR_DATA, "it is empty");
    scratch_write(path, 5, "hello");
    check_refused(path, PDMC_ERR_DATA, "not an HDF5 file");
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(file);
    check_refused(path, PDMC_ERR_DATA, "not a result file of pdmc");
}

/// A copy of the whole file, open for harm.
static hid_t open_copy(const char *path)
{
    scratch_write(path, whole_size, whole);
    return H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
}

static void another_version_is_refused(void **state)
{
    (void)state;
    const char *path = scratch_path("version.h5");
    hid_t file = open_copy(path), version = H5Aopen(file, "version", H5P_DEFAULT);
    H5Awrite(version, H5T_NATIVE_INT, (const int[]){1, 7});
    H5Aclose(version);
    H5Fclose(file);
    pdmc_results results;
    CHECK_OK(pdmc_results_read(path, &results)); // a later minor version only adds
    pdmc_results_clear(&results);

    file = open_copy(path), version = H5Aopen(file, "version", H5P_DEFAULT);
    H5Awrite(version, H5T_NATIVE_INT, (const int[]){2, 0});
    H5Aclose(version);
    H5Fclose(file);
    check_refused(path, PDMC_ERR_DATA, "version 2.0; this pdmc reads version 1");
}

/// Replaces a dataset by one of zeros with other extents.
static void replace(hid_t file, const char *name, hid_t type, int rank, const hsize_t extents[])
{
    H5Ldelete(file, name, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(rank, extents, NULL);
    const hid_t object = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dclose(object);
    H5Sclose(space);
}

static void contradictions_are_refused(void **state)
{
    (void)state;
    const char *path = scratch_path("contradiction.h5");
    const struct {
        const char *name;
        hid_t type;
        int rank;
        hsize_t extents[4];
        const char *message;
    } cases[] = {
        {"/samples/failure", H5T_STD_U8LE, 1, {39}, "/samples/failure: 39 along \"sample\", where 40 are expected"},
        {"/samples/failure", H5T_STD_U8LE, 1, {40}, "0 samples are marked as failed, but 2 are counted"},
        {"/samples/load_factor", H5T_IEEE_F64LE, 1, {1u << 30}, "claims 1073741824 numbers"},
        {"/samples/load_factor", H5T_IEEE_F64LE, 1, {(hsize_t)1 << 40}, "along \"sample\""},
        {"/samples/load_factor", H5T_IEEE_F64LE, 2, {40, 1}, "has 2 axes, not 1"},
        {"/samples/load_factor", H5T_STD_I32LE, 1, {40}, "holds another type"},
        {"/statistics/bond_energy/density_interval", H5T_IEEE_F64LE, 4, {2, 8, 6, 3}, "3 along \"lower, upper\""},
        {"/statistics/bond_energy/histogram_edges", H5T_IEEE_F64LE, 3, {2, 8, 0}, "0 along \"edge\""},
        {"/field/face_displacement", H5T_IEEE_F64LE, 4, {1, 41, 1, 2}, "1 along \"left, right face\""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const hid_t file = open_copy(path);
        replace(file, cases[i].name, cases[i].type, cases[i].rank, cases[i].extents);
        H5Fclose(file);
        check_refused(path, PDMC_ERR_DATA, cases[i].message);
    }
}

static void missing_parts_are_named(void **state)
{
    (void)state;
    const char *path = scratch_path("missing.h5");
    hid_t file = open_copy(path);
    H5Ldelete(file, "/tips/position", H5P_DEFAULT);
    H5Fclose(file);
    check_refused(path, PDMC_ERR_DATA, "/tips/position");
    file = open_copy(path);
    H5Adelete(file, "seed");
    H5Fclose(file);
    check_refused(path, PDMC_ERR_DATA, "seed");
    file = open_copy(path);
    H5Adelete_by_name(file, "/plate", "measure", H5P_DEFAULT);
    H5Fclose(file);
    check_refused(path, PDMC_ERR_DATA, "measure");
}

static void an_older_file_without_memory_and_accuracy_is_read(void **state)
{
    (void)state;
    const char *path = scratch_path("older.h5");
    pdmc_results results;
    const hid_t file = open_copy(path);
    H5Ldelete(file, "/runtime/peak_memory", H5P_DEFAULT);
    H5Adelete(file, "mesh_generator");
    H5Ldelete(file, "/solver/samples", H5P_DEFAULT);
    H5Fclose(file);
    CHECK_OK(pdmc_results_read(path, &results));
    assert_true(isnan(results.accuracy.iteration_residual));
    assert_true(isnan(results.accuracy.mean_error[PDMC_MEASURE_BOND]));
    assert_true(isnan(results.accuracy.quantile_error[PDMC_MEASURE_GRIFFITH][PDMC_QUANTILES - 1]));
    assert_true(isnan(results.runtime.peak_memory));
    assert_string_equal(results.mesh_generator, "");
    CHECK_NEAR(results.runtime.total, 6.7, 0.0);
    pdmc_results_clear(&results);
}

// Before there were kept samples, the file had every energy of all; what is largest is found again.
static void an_older_file_has_all_energies(void **state)
{
    (void)state;
    const char *path = scratch_path("older.h5"), *const later[] = {"largest_bond_energy", "largest_griffith_energy",
                                                                   "growth_given_rest", "tip_fracture_energy",
                                                                   "solver"};
    pdmc_results now, results;
    hid_t file = open_copy(path);
    H5Fclose(file);
    CHECK_OK(pdmc_results_read(path, &now));
    file = open_copy(path);
    const hid_t samples = H5Gopen2(file, "/samples", H5P_DEFAULT);
    for (size_t i = 0; i < sizeof later / sizeof later[0]; i++) H5Ldelete(samples, later[i], H5P_DEFAULT);
    H5Gclose(samples);
    H5Fclose(file);
    CHECK_OK(pdmc_results_read(path, &results));
    assert_int_equal(results.kept_count, now.sample_count);
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (int i = 0; i < now.sample_count * now.tip_count; i++) {
            const double a = results.largest_energy[m][i], b = now.largest_energy[m][i];
            assert_true(a == b || (isnan(a) && isnan(b)));
        }
    assert_true(isnan(results.growth_given_rest[0]) && isnan(results.sample_fracture_energy[0]));
    assert_int_equal(results.sample_solver[0], PDMC_SOLVED_AS_ASKED);
    pdmc_results_clear(&results);
    pdmc_results_clear(&now);
}

/// Damaged bytes may pass unseen where they are numbers; they must never crash, and a refusal must be a clean one.
static void damaged_bytes_never_crash(void **state)
{
    (void)state;
    const char *path = scratch_path("damaged.h5");
    char *bytes = malloc(whole_size);
    for (size_t at = 0; at < whole_size; at += 131) {
        memcpy(bytes, whole, whole_size);
        bytes[at] = (char)(bytes[at] ^ 0x5a);
        scratch_write(path, whole_size, bytes);
        pdmc_results results;
        const pdmc_status status = pdmc_results_read(path, &results);
        if (status != PDMC_OK && status != PDMC_ERR_DATA) fail_msg("byte %zu: %s", at, pdmc_last_error());
        pdmc_results_clear(&results);
    }
    free(bytes);
}

static void a_compressed_copy_is_read(void **state)
{
    (void)state;
    if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0) skip();
    const char *path = scratch_path("compressed.h5");
    const hsize_t extents[] = {40}, chunk[] = {8};
    const hid_t file = open_copy(path), creation = H5Pcreate(H5P_DATASET_CREATE),
                space = H5Screate_simple(1, extents, NULL);
    const double ones[40] = {[7] = 1.0};
    H5Ldelete(file, "/samples/load_factor", H5P_DEFAULT);
    H5Pset_chunk(creation, 1, chunk);
    H5Pset_deflate(creation, 9);
    const hid_t object =
        H5Dcreate2(file, "/samples/load_factor", H5T_IEEE_F64BE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    H5Dwrite(object, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, ones);
    H5Dclose(object);
    H5Sclose(space);
    H5Pclose(creation);
    H5Fclose(file);
    pdmc_results results;
    CHECK_OK(pdmc_results_read(path, &results));
    CHECK_NEAR(results.load_factor[7], 1.0, 0.0);
    pdmc_results_clear(&results);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_truncated_file_is_refused_at_every_length),
        cmocka_unit_test(what_is_no_result_file_is_refused),
        cmocka_unit_test(another_version_is_refused),
        cmocka_unit_test(contradictions_are_refused),
        cmocka_unit_test(missing_parts_are_named),
        cmocka_unit_test(an_older_file_without_memory_and_accuracy_is_read),
        cmocka_unit_test(an_older_file_has_all_energies),
        cmocka_unit_test(damaged_bytes_never_crash),
        cmocka_unit_test(a_compressed_copy_is_read),
    };
    return cmocka_run_group_tests(tests, write_whole, forget_whole);
}
