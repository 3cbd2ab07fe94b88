// SPDX-License-Identifier: GPL-3.0-or-later

/// bonds STUDY: how fast the inverses are on a grid of bonds, against each other, in one run on one thread; and the whole
/// study by the reduced model.

#include "pdmc/run.h"

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

// Milliseconds a sample for its solution and its energies.
static double sample_time(pdmc_study *study, pdmc_inverse inverse, int samples)
{
    pdmc_results results;
    run(study, inverse, samples, 1, &results);
    const double seconds = results.runtime.sampling + results.runtime.energy;
    pdmc_results_clear(&results);
    return 1e3 * seconds / samples;
}

int main(int argc, char *argv[])
{
    pdmc_study study;
    pdmc_results results;
    if (argc != 2) {
        fputs("usage: bonds STUDY\n", stderr);
        return 64;
    }
    if (pdmc_study_read(argv[1], &study) != PDMC_OK) give_up();
    const int samples = study.problem.sampling.samples;
    const double direct = sample_time(&study, PDMC_INVERSE_DIRECT, 16);
    const double neumann = sample_time(&study, PDMC_INVERSE_NEUMANN, 256);
    const double krylov = sample_time(&study, PDMC_INVERSE_KRYLOV, 256);
    run(&study, PDMC_INVERSE_REDUCED, samples, 1, &results);
    const pdmc_runtime *t = &results.runtime;
    const double reduced = 1e3 * (t->sampling + t->energy) / samples;
    printf("mean solution, 1 thread   %8.3f s: %d nodes, its factorisation %.3f s\n", t->assembly + t->factorisation,
           results.solver.nodes, t->factorisation);
    printf("direct                    %8.2f ms a sample\n", direct);
    printf("Neumann, order %d          %8.2f ms, direct over it %.0f\n", study.problem.sampling.order, neumann,
           direct / neumann);
    printf("conjugate gradients       %8.2f ms, direct over it %.0f\n", krylov, direct / krylov);
    printf("reduced, %3.0f unknowns     %8.3f ms, direct over it %.0f, Neumann over it %.0f\n",
           results.accuracy.reduced_unknowns, reduced, direct / reduced, neumann / reduced);
    printf("  relative error of the largest bond energy at most %.1e, typically %.1e\n",
           results.accuracy.energy_error[PDMC_MEASURE_BOND], results.accuracy.typical_error[PDMC_MEASURE_BOND]);
    pdmc_results_clear(&results);
    for (int threads = 1; threads <= 2; threads++) {
        run(&study, PDMC_INVERSE_REDUCED, samples, threads, &results);
        printf("%d samples, all of it, %d threads  %8.2f s, of which %.2f s for the reduced model\n", samples, threads,
               results.runtime.total, results.runtime.operators);
        pdmc_results_clear(&results);
    }
    pdmc_study_clear(&study);
    return 0;
}
