// SPDX-License-Identifier: GPL-3.0-or-later

/// Result files of explicit studies: what is written is read, and VTK finds what its file format asks for.

#include "pdmc/results.h"

#include "check.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <hdf5.h>

static void check_columns(const pdmc_explicit_record *a, const pdmc_explicit_record *b)
{
    const struct {
        const double *a, *b;
        int count;
    } columns[] = {
        {a->time, b->time, a->record_count},
        {a->kinetic, b->kinetic, a->record_count},
        {a->elastic, b->elastic, a->record_count},
        {a->contact, b->contact, a->record_count},
        {a->fracture, b->fracture, a->record_count},
        {a->work, b->work, a->record_count},
        {a->dissipated, b->dissipated, a->record_count},
        {a->condition_force, b->condition_force, 3 * a->condition_count * a->record_count},
        {a->condition_displacement, b->condition_displacement, 3 * a->condition_count * a->record_count},
        {a->interface_broken, b->interface_broken, a->interface_count * a->record_count},
        {a->momentum, b->momentum, 3 * a->record_count},
        {a->mean_damage, b->mean_damage, a->record_count},
        {a->broken, b->broken, a->record_count},
        {a->force_error, b->force_error, a->compared_count},
        {a->fragments, b->fragments, a->record_count},
        {a->loose_nodes, b->loose_nodes, a->record_count},
        {a->largest_fragment, b->largest_fragment, a->record_count},
        {a->tip_advance, b->tip_advance, a->tip_count * a->record_count},
        {a->tip_speed, b->tip_speed, a->tip_count * a->record_count},
        {a->sphere_centre, b->sphere_centre, 3 * a->sphere_count * a->record_count},
        {a->sphere_velocity, b->sphere_velocity, 3 * a->sphere_count * a->record_count},
        {a->sphere_force, b->sphere_force, 3 * a->sphere_count * a->record_count},
        {a->node_position, b->node_position, 3 * a->node_count},
        {a->snapshot_time, b->snapshot_time, a->snapshot_count},
        {a->displacement, b->displacement, 3 * a->state_count},
        {a->velocity, b->velocity, 3 * a->state_count},
        {a->damage, b->damage, a->state_count},
    };
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++)
        assert_memory_equal(columns[i].a, columns[i].b, (size_t)columns[i].count * sizeof(double));
}

static void check_record(const pdmc_explicit_record *a, const pdmc_explicit_record *b)
{
    assert_int_equal(a->dimension, b->dimension);
    assert_memory_equal(&a->spacing, &b->spacing, 8 * sizeof(double));
    assert_memory_equal(&a->first, &b->first, sizeof a->first);
    assert_string_equal(a->kernel, b->kernel);
    assert_int_equal(a->record_count, b->record_count);
    assert_int_equal(a->compared_count, b->compared_count);
    assert_int_equal(a->tip_count, b->tip_count);
    assert_int_equal(a->sphere_count, b->sphere_count);
    assert_int_equal(a->body_count, b->body_count);
    assert_int_equal(a->interface_count, b->interface_count);
    assert_memory_equal(a->interfaces, b->interfaces, (size_t)a->interface_count * sizeof *a->interfaces);
    assert_int_equal(a->node_count, b->node_count);
    assert_int_equal(a->snapshot_count, b->snapshot_count);
    assert_int_equal(a->state_count, b->state_count);
    assert_int_equal(a->condition_count, b->condition_count);
    assert_memory_equal(a->conditions, b->conditions, (size_t)a->condition_count * sizeof *a->conditions);
    assert_int_equal(a->fragment_count, b->fragment_count);
    assert_memory_equal(a->fragment, b->fragment, (size_t)a->state_count * sizeof *a->fragment);
    assert_memory_equal(a->fragment_list, b->fragment_list, (size_t)a->fragment_count * sizeof *a->fragment_list);
    check_columns(a, b);
    assert_memory_equal(a->tips, b->tips, (size_t)a->tip_count * sizeof *a->tips);
    assert_memory_equal(a->spheres, b->spheres, (size_t)a->sphere_count * sizeof *a->spheres);
    assert_memory_equal(a->bodies, b->bodies, (size_t)a->body_count * sizeof *a->bodies);
    assert_memory_equal(a->node_body, b->node_body, (size_t)a->node_count * sizeof *a->node_body);
}

static void what_is_written_is_read(void **state)
{
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++) {
        pdmc_results a = made_up_explicit(dimension), b;
        a.status = dimension == 2 ? PDMC_RUN_COMPLETE : PDMC_RUN_NOT_FINITE;
        CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), true));
        CHECK_OK(pdmc_results_read(scratch_path("results.h5"), &b));
        assert_int_equal(b.kind, PDMC_EXPLICIT);
        assert_int_equal(b.status, a.status);
        assert_string_equal(b.time_unit, "ms");
        CHECK_NEAR(b.runtime.motion, 1.25, 0.0);
        check_record(&a.particles, &b.particles);
        pdmc_results_clear(&a);
        pdmc_results_clear(&b);
    }
    scratch_empty(scratch);
}

static void check_samples(const pdmc_ensemble_results *a, const pdmc_ensemble_results *b)
{
    enum { S = 4, T = 2, X = 3, B = 5, Q = PDMC_QUANTILES };
    const struct {
        const void *a, *b;
        size_t bytes;
    } columns[] = {
        {a->failure, b->failure, S},
        {a->load, b->load, S * sizeof(double)},
        {a->velocity, b->velocity, S * sizeof(double)},
        {a->youngs_modulus, b->youngs_modulus, S * sizeof(double)},
        {a->fracture_energy, b->fracture_energy, S * sizeof(double)},
        {a->fracture, b->fracture, S * sizeof(double)},
        {a->outcome, b->outcome, S * T},
        {a->growth, b->growth, S * T * sizeof(double)},
        {a->begin, b->begin, S * T * sizeof(double)},
        {a->mean_speed, b->mean_speed, S * T * sizeof(double)},
        {a->most_speed, b->most_speed, S * T * sizeof(double)},
        {a->end, b->end, 2 * S * T * sizeof(double)},
        {a->station, b->station, X * sizeof(double)},
        {a->path, b->path, S * T * X * sizeof(double)},
        {a->share, b->share, T * PDMC_OUTCOMES * sizeof(pdmc_estimate)},
        {a->mean_growth, b->mean_growth, T * sizeof(pdmc_estimate)},
        {a->deviation, b->deviation, T * sizeof(pdmc_estimate)},
        {a->growth_quantiles, b->growth_quantiles, T * Q * sizeof(pdmc_estimate)},
        {a->growth_edges, b->growth_edges, T * (B + 1) * sizeof(double)},
        {a->growth_counts, b->growth_counts, T * (B + 2) * sizeof(int64_t)},
        {a->growth_density, b->growth_density, T * B * sizeof(pdmc_estimate)},
        {a->path_samples, b->path_samples, T * X * sizeof(double)},
        {a->path_mean, b->path_mean, T * X * sizeof(pdmc_estimate)},
        {a->path_quantiles, b->path_quantiles, T * X * Q * sizeof(pdmc_estimate)},
    };
    assert_int_equal(b->sample_count, S);
    assert_int_equal(b->failed_count, 1);
    assert_int_equal(b->tip_count, T);
    assert_int_equal(b->station_count, X);
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++)
        if (memcmp(columns[i].a, columns[i].b, columns[i].bytes) != 0) fail_msg("column %zu", i);
}

static void samples_are_kept(void **state)
{
    (void)state;
    pdmc_results a = made_up_explicit(2), b;
    made_up_samples(&a);
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), true));
    CHECK_OK(pdmc_results_read(scratch_path("results.h5"), &b));
    assert_int_equal(b.histogram_bins, 5);
    check_samples(&a.ensemble, &b.ensemble);
    scratch_empty(scratch);
    a.ensemble.outcome[3] = PDMC_OUTCOMES;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), true), PDMC_ERR_ARG);
    a.ensemble.outcome[3] = 0;
    a.ensemble.failed_count = 2;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), true), PDMC_ERR_ARG);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
    scratch_empty(scratch);
}

static void an_early_stop_may_leave_nothing(void **state)
{
    (void)state;
    pdmc_results a = made_up_explicit(2), b;
    pdmc_explicit_record *p = &a.particles;
    p->record_count = p->tip_count = p->sphere_count = p->snapshot_count = p->state_count = 0;
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), true));
    CHECK_OK(pdmc_results_read(scratch_path("results.h5"), &b));
    assert_int_equal(b.particles.record_count, 0);
    assert_int_equal(b.particles.node_count, 32);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
    scratch_empty(scratch);
}

static void states_must_be_whole_snapshots(void **state)
{
    (void)state;
    pdmc_results a = made_up_explicit(2);
    a.particles.state_count--;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), true), PDMC_ERR_ARG);
    a.particles.state_count++;
    a.particles.node_body[7] = a.particles.body_count;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), true), PDMC_ERR_ARG);
    a.particles.node_body[7] = 0;
    a.particles.fragment[7] = a.particles.node_count;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), true), PDMC_ERR_ARG);
    a.particles.fragment[7] = a.particles.fragment_count; // may be at another time
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), true));
    scratch_empty(scratch);
    a.particles.fragment[a.particles.state_count - 7] = a.particles.fragment_count;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), true), PDMC_ERR_ARG);
    pdmc_results_clear(&a);
    assert_int_equal(scratch_empty(scratch), 0);
}

// ---- what the VTKHDF specification, version 2, says of an unstructured grid with time steps ----

static size_t read_integers(hid_t file, const char *path, int64_t numbers[256])
{
    const hid_t object = H5Dopen2(file, path, H5P_DEFAULT);
    assert_true(object >= 0);
    const hid_t space = H5Dget_space(object);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    assert_int_equal(H5Sget_simple_extent_ndims(space), 1);
    assert_in_range(count, 0, 256);
    assert_true(H5Dread(object, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0);
    H5Sclose(space);
    H5Dclose(object);
    return (size_t)count;
}

static void check_integers(hid_t file, const char *path, size_t count, int64_t first, int64_t step)
{
    int64_t numbers[256];
    assert_int_equal(read_integers(file, path, numbers), count);
    for (size_t i = 0; i < count; i++) assert_int_equal(numbers[i], first + (int64_t)i * step);
}

static void check_attribute(hid_t file, const char *group, const char *name, size_t count, const int64_t want[])
{
    int64_t got[2] = {-1, -1};
    const hid_t attribute = H5Aopen_by_name(file, group, name, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(attribute >= 0);
    assert_true(H5Aread(attribute, H5T_NATIVE_INT64, got) >= 0);
    for (size_t i = 0; i < count; i++) assert_int_equal(got[i], want[i]);
    H5Aclose(attribute);
}

static void check_type(hid_t file)
{
    char text[17] = "";
    const hid_t attribute = H5Aopen_by_name(file, "/VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT);
    assert_true(attribute >= 0);
    const hid_t type = H5Aget_type(attribute);
    assert_int_equal(H5Tget_cset(type), H5T_CSET_ASCII);
    assert_int_equal(H5Tis_variable_str(type), 0);
    assert_int_equal(H5Tget_size(type), 16);
    assert_true(H5Aread(attribute, type, text) >= 0);
    assert_string_equal(text, "UnstructuredGrid");
    H5Tclose(type);
    H5Aclose(attribute);
}

static void check_rows(hid_t file, const char *path, int rank, hsize_t rows, hsize_t columns)
{
    hsize_t extents[2] = {0, 0};
    const hid_t object = H5Dopen2(file, path, H5P_DEFAULT);
    assert_true(object >= 0);
    const hid_t space = H5Dget_space(object);
    assert_int_equal(H5Sget_simple_extent_ndims(space), rank);
    H5Sget_simple_extent_dims(space, extents, NULL);
    assert_int_equal(extents[0], rows);
    if (rank == 2) assert_int_equal(extents[1], columns);
    H5Sclose(space);
    H5Dclose(object);
}

static void vtk_finds_vertices_and_steps(void **state)
{
    (void)state;
    const size_t nodes = 96, steps = 3;
    pdmc_results a = made_up_explicit(3);
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.vtkhdf"), true));
    const hid_t file = H5Fopen(scratch_path("results.vtkhdf"), H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_true(file >= 0);
    check_type(file);
    check_attribute(file, "/VTKHDF", "Version", 2, (const int64_t[]){2, 0});
    check_attribute(file, "/VTKHDF/Steps", "NSteps", 1, (const int64_t[]){3});
    check_integers(file, "/VTKHDF/NumberOfPoints", 1, 96, 0);
    check_integers(file, "/VTKHDF/NumberOfCells", 1, 96, 0);
    check_integers(file, "/VTKHDF/NumberOfConnectivityIds", 1, 96, 0);
    check_integers(file, "/VTKHDF/Connectivity", nodes, 0, 1);
    check_integers(file, "/VTKHDF/Offsets", nodes + 1, 0, 1);
    check_integers(file, "/VTKHDF/Types", nodes, 1, 0); // VTK_VERTEX
    check_integers(file, "/VTKHDF/Steps/NumberOfParts", steps, 1, 0);
    static const char *const at_the_start[] = {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets",
                                               "PointDataOffsets/body"};
    static const char *const one_after_another[] = {"displacement", "velocity", "damage"};
    char path[128];
    for (size_t i = 0; i < 5; i++) {
        snprintf(path, sizeof path, "/VTKHDF/Steps/%s", at_the_start[i]);
        check_integers(file, path, steps, 0, 0);
    }
    for (size_t i = 0; i < 3; i++) {
        snprintf(path, sizeof path, "/VTKHDF/Steps/PointDataOffsets/%s", one_after_another[i]);
        check_integers(file, path, steps, 0, 96);
        snprintf(path, sizeof path, "/VTKHDF/PointData/%s", one_after_another[i]);
        check_rows(file, path, i == 2 ? 1 : 2, nodes * steps, 3);
    }
    check_rows(file, "/VTKHDF/PointData/body", 1, nodes, 0);
    check_rows(file, "/VTKHDF/Points", 2, nodes, 3);
    check_rows(file, "/VTKHDF/Steps/Values", 1, steps, 0);
    H5Fclose(file);
    pdmc_results_clear(&a);
    scratch_empty(scratch);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),         cmocka_unit_test(samples_are_kept),
        cmocka_unit_test(an_early_stop_may_leave_nothing), cmocka_unit_test(states_must_be_whole_snapshots),
        cmocka_unit_test(vtk_finds_vertices_and_steps),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
