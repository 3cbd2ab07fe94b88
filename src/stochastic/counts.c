// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/counts.h"

#include "base/base_impl.h"

#include <string.h>

enum { B = PDMC_BLOCK, ROOM = PDMC_COUNTED_BLOCKS * PDMC_BLOCK };

// The nominal energies, by which the tally scales its sums; those of the bonds that the samples count.
static void fill_pilots(const pdmc_results *results, double pilot[])
{
    const size_t directions = (size_t)(results->tip_count * results->angle_count);
    const double *bond =
        results->bonds == PDMC_BONDS_ALL ? results->nominal_bond_energy : results->nominal_bond_energy_tensile;
    memcpy(&pilot[PDMC_MEASURE_BOND * directions], bond, directions * sizeof *pilot);
    memcpy(&pilot[PDMC_MEASURE_GRIFFITH * directions], results->nominal_griffith_energy, directions * sizeof *pilot);
}

pdmc_status pdmc_sample_counts_create(const pdmc_results *results, pdmc_sample_counts **counts)
{
    pdmc_status status = PDMC_OK;
    pdmc_sample_counts *made = NULL;
    double *pilot = NULL;
    const size_t tips = (size_t)results->tip_count, angles = (size_t)results->angle_count;
    const size_t quantities = PDMC_MEASURES * tips * angles;
    PDMC_NEW(made, 1);
    *made = (pdmc_sample_counts){.tips = (int)tips, .angles = (int)angles, .measure = results->measure};
    PDMC_NEW(made->largest, tips * angles * angles);
    PDMC_NEW(made->energy, quantities * ROOM);
    PDMC_NEW(pilot, quantities);
    fill_pilots(results, pilot);
    if (quantities > 0) PDMC_TRY(pdmc_tally_create(quantities, 1, pilot, 0, NULL, &made->tally));
    *counts = made;
    made = NULL;
done:
    pdmc_free(pilot);
    pdmc_sample_counts_destroy(&made);
    return status;
}

void pdmc_sample_counts_destroy(pdmc_sample_counts **counts)
{
    if (!*counts) return;
    pdmc_free((*counts)->largest);
    pdmc_free((*counts)->energy);
    pdmc_tally_destroy(&(*counts)->tally);
    pdmc_free(*counts);
    *counts = NULL;
}

// The directions of the largest energy of the samples that are taken.
static void count_directions(pdmc_sample_counts *counts, const pdmc_block *block, int tip, const bool taken[B])
{
    const int angles = counts->angles;
    const double *energy =
        &(counts->measure == PDMC_MEASURE_GRIFFITH ? block->griffith : block->energy)[tip * angles * B];
    double largest[B];
    int others[B];
    pdmc_block_largest_energies(block, counts->measure, tip, largest);
    for (int s = 0; s < B; s++) others[s] = -1;
    for (int a = 0; a < angles; a++)
        for (int s = 0; s < B; s++) others[s] += pdmc_is_largest(energy[a * B + s], largest[s]);
    for (int a = 0; a < angles; a++)
        for (int s = 0; s < B; s++)
            if (taken[s] && pdmc_is_largest(energy[a * B + s], largest[s]))
                counts->largest[(tip * angles + a) * angles + others[s]]++;
}

// Copies the energies of the samples that are taken behind those that wait.
static void append(pdmc_sample_counts *counts, const pdmc_block *block, const bool taken[B])
{
    int place[B], found = 0;
    for (int s = 0; s < B; s++)
        if (taken[s]) place[found++] = s;
    for (size_t q = 0; q < PDMC_MEASURES * (size_t)(counts->tips * counts->angles); q++) {
        double *to = &counts->energy[q * ROOM + counts->waiting];
        const double *from = &block->energy[q * B];
        for (int k = 0; k < found; k++) to[k] = from[place[k]];
    }
    counts->waiting += (size_t)found;
}

void pdmc_sample_counts_add(pdmc_sample_counts *counts, const pdmc_block *block, int count, const bool wanted[])
{
    bool taken[B];
    for (int s = 0; s < B; s++) taken[s] = s < count && wanted[s] && block->failure[s] == PDMC_SAMPLE_OK;
    for (int t = 0; t < counts->tips; t++) count_directions(counts, block, t, taken);
    append(counts, block, taken);
}

pdmc_status pdmc_sample_counts_flush(pdmc_sample_counts *counts)
{
    const size_t waiting = counts->waiting;
    counts->waiting = 0;
    return counts->tally ? pdmc_tally_add(counts->tally, waiting, ROOM, counts->energy) : PDMC_OK;
}

pdmc_status pdmc_sample_counts_merge(pdmc_sample_counts *into, const pdmc_sample_counts *from)
{
    for (int k = 0; k < into->tips * into->angles * into->angles; k++) into->largest[k] += from->largest[k];
    return into->tally ? pdmc_tally_merge(into->tally, from->tally) : PDMC_OK;
}
