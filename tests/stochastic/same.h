// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stochastic/toy.h"

/// The bits of everything but the statistics of energies.
static inline void check_same_samples(const pdmc_results *a, const pdmc_results *b, int samples, int kept)
{
    const size_t n = (size_t)samples * sizeof(double), m = (size_t)kept * sizeof(double);
    assert_memory_equal(a->load_factor, b->load_factor, n);
    assert_memory_equal(a->effective_modulus, b->effective_modulus, n);
    assert_memory_equal(a->contraction, b->contraction, n);
    assert_memory_equal(a->sample_fracture_energy, b->sample_fracture_energy, n);
    assert_memory_equal(a->growth_given_rest, b->growth_given_rest, n);
    assert_memory_equal(a->stress_intensity, b->stress_intensity, 2 * n);
    assert_memory_equal(a->failure, b->failure, (size_t)samples);
    assert_memory_equal(a->micromodulus, b->micromodulus, m);
    for (int k = 0; k < PDMC_MEASURES; k++) {
        assert_memory_equal(a->largest_energy[k], b->largest_energy[k], n);
        assert_memory_equal(a->energy[k], b->energy[k], ANGLES * m);
    }
}

/// The bits of the statistics.
static inline void check_same_statistics(const pdmc_results *a, const pdmc_results *b)
{
    const size_t bins = (size_t)a->histogram_bins, estimates = ANGLES * sizeof(pdmc_estimate);
    for (int m = 0; m < PDMC_MEASURES; m++) {
        const pdmc_energy_statistics *x = &a->statistics[m], *y = &b->statistics[m];
        assert_memory_equal(x->mean, y->mean, estimates);
        assert_memory_equal(x->standard_deviation, y->standard_deviation, estimates);
        assert_memory_equal(x->quantiles, y->quantiles, PDMC_QUANTILES * estimates);
        assert_memory_equal(x->histogram_edges, y->histogram_edges, ANGLES * (bins + 1) * sizeof(double));
        assert_memory_equal(x->histogram_counts, y->histogram_counts, ANGLES * (bins + 2) * sizeof(int64_t));
        assert_memory_equal(x->density, y->density, bins * estimates);
    }
    assert_memory_equal(a->direction, b->direction, estimates);
    assert_memory_equal(a->probability, b->probability, sizeof(pdmc_estimate));
}
