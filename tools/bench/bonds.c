// SPDX-License-Identifier: GPL-3.0-or-later

/// bonds STUDY: how fast the inverses are on a grid of bonds, and how near to direct solutions, against each other, in one
/// run on one thread; and the whole study by the reduced model.

#include "pdmc/run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void give_up(void)
{
    fprintf(stderr, "bonds: %s\n", pdmc_last_error());
    exit(EXIT_FAILURE);
}

static void run(pdmc_study *study, pdmc_inverse inverse, int samples, int threads, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = threads};
    study->problem.sampling.inverse = inverse;
    study->problem.sampling.samples = samples;
    if (pdmc_run(study, &options, results) != PDMC_OK) give_up();
}

enum { DIRECT = 16 };

static double largest_energy(const pdmc_results *r, int sample)
{
    double largest = 0.0;
    for (int a = 0; a < r->angle_count; a++)
        largest = fmax(largest, r->energy[PDMC_MEASURE_BOND][sample * r->tip_count * r->angle_count + a]);
    return largest;
}

// Milliseconds a sample for its solution and its energies.
static double sample_time(const pdmc_results *r)
{
    return 1e3 * (r->runtime.sampling + r->runtime.energy) / r->sample_count;
}

// The largest relative error of the largest bond energy at the first tip, of the samples that were solved directly.
static double error_of(const pdmc_results *r, const pdmc_results *direct)
{
    double worst = 0.0;
    for (int s = 0; s < DIRECT; s++) worst = fmax(worst, fabs(largest_energy(r, s) / largest_energy(direct, s) - 1.0));
    return worst;
}

// Times and errors of one inverse; returns the milliseconds a sample.
static double compare(pdmc_study *study, pdmc_inverse inverse, const char *name, int samples,
                      const pdmc_results *direct)
{
    pdmc_results results;
    run(study, inverse, samples, 1, &results);
    const double time = sample_time(&results);
    printf("%-24s  %8.3f ms a sample, direct over it %5.0f, error at most %.1e\n", name, time,
           sample_time(direct) / time, error_of(&results, direct));
    if (inverse == PDMC_INVERSE_REDUCED)
        printf("  %.0f unknowns, bounds of the error at most %.1e, typically %.1e\n", results.accuracy.reduced_unknowns,
               results.accuracy.energy_error[PDMC_MEASURE_BOND], results.accuracy.typical_error[PDMC_MEASURE_BOND]);
    pdmc_results_clear(&results);
    return time;
}

int main(int argc, char *argv[])
{
    pdmc_study study;
    pdmc_results results, direct;
    if (argc != 2) {
        fputs("usage: bonds STUDY\n", stderr);
        return 64;
    }
    if (pdmc_study_read(argv[1], &study) != PDMC_OK) give_up();
    const int samples = study.problem.sampling.samples;
    run(&study, PDMC_INVERSE_DIRECT, DIRECT, 1, &direct);
    printf("mean solution             %8.3f s: %d nodes, its factorisation %.3f s\n",
           direct.runtime.assembly + direct.runtime.factorisation, direct.solver.nodes, direct.runtime.factorisation);
    printf("direct                    %8.3f ms a sample\n", sample_time(&direct));
    const double neumann = compare(&study, PDMC_INVERSE_NEUMANN, "Neumann", 256, &direct);
    compare(&study, PDMC_INVERSE_KRYLOV, "conjugate gradients", 256, &direct);
    const double reduced = compare(&study, PDMC_INVERSE_REDUCED, "reduced model", samples, &direct);
    printf("  Neumann over reduced %.0f\n", neumann / reduced);
    for (int threads = 1; threads <= 2; threads++) {
        run(&study, PDMC_INVERSE_REDUCED, samples, threads, &results);
        printf("%d samples, all of it, %d threads: %.2f s, of which %.2f s for the reduced model\n", samples, threads,
               results.runtime.total, results.runtime.operators);
        pdmc_results_clear(&results);
    }
    pdmc_results_clear(&direct);
    pdmc_study_clear(&study);
    return 0;
}
