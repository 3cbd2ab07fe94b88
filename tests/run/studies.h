// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Small studies, run in a folder of their own.

#include "study/folder.h"

#include "pdmc/run.h"

#define ONE_CRACK "cracks = ( { name = \"c\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } ); energy = { angles = 8; };"
#define MICROMODULUS "{ quantity = \"micromodulus\"; bins = 100; variation = 0.2; }"
#define LOAD "{ quantity = \"load\"; distribution = \"normal\"; variation = 0.2; }"
#define BOTH MICROMODULUS ", " LOAD

/// A plate under tension: `top` holds the cracks and what else belongs to the study as a whole, `random` is the inside
/// of its list, `sampling` of its group.
static inline void read_study(const char *top, const char *random, const char *sampling, pdmc_study *study)
{
    char text[2048];
    snprintf(text, sizeof text,
             "plate = { width = 5.0; height = 5.0; };\n"
             "material = { youngs_modulus = 1.5; fracture_energy = 2.0; };\n%s\n"
             "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n"
             "solver = { spacing = 0.5; };\nrandom = ( %s );\nsampling = { %s };\n",
             top, random, sampling);
    CHECK_OK(read_text(text, study));
}

static inline void run_study(const char *top, const char *random, const char *sampling, const pdmc_run_options *options,
                             pdmc_results *results)
{
    pdmc_study study;
    read_study(top, random, sampling, &study);
    CHECK_OK(pdmc_run(&study, options, results));
    pdmc_study_clear(&study);
}

static inline void assert_same(const char *what, const void *a, const void *b, size_t bytes)
{
    if (memcmp(a, b, bytes) != 0) fail_msg("%s: not the same bytes", what);
}

/// The first `count` samples of both, bit by bit.
static inline void assert_same_samples(const pdmc_results *a, const pdmc_results *b, int count)
{
    const size_t n = (size_t)count * sizeof(double), tips = (size_t)a->tip_count;
    assert_int_equal(a->tip_count, b->tip_count);
    assert_int_equal(a->bin_count, b->bin_count);
    assert_true(count <= a->sample_count && count <= b->sample_count);
    assert_same("load_factor", a->load_factor, b->load_factor, n);
    assert_same("micromodulus", a->micromodulus, b->micromodulus, n * (size_t)a->bin_count);
    assert_same("effective_modulus", a->effective_modulus, b->effective_modulus, n);
    assert_same("contraction", a->contraction, b->contraction, n);
    assert_same("failure", a->failure, b->failure, (size_t)count);
    assert_same("stress_intensity", a->stress_intensity, b->stress_intensity, 2 * n * tips);
    for (int m = 0; m < PDMC_MEASURES; m++)
        assert_same(pdmc_measure_names[m], a->energy[m], b->energy[m], n * tips * (size_t)a->angle_count);
}
