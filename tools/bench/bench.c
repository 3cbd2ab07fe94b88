// SPDX-License-Identifier: GPL-3.0-or-later

/// bench STUDY: how fast the parts of a study are, against what the machine can do and against one another, in one run.
/// Times are medians of five; only the ratios mean anything from one machine to the next.

#include "pdmc/discretisation.h"
#include "pdmc/run.h"

#include <cblas.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { REPEATS = 5 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double time[REPEATS])
{
    qsort(time, REPEATS, sizeof *time, ascending);
    return time[REPEATS / 2];
}

static void give_up(void)
{
    fprintf(stderr, "bench: %s\n", pdmc_last_error());
    exit(EXIT_FAILURE);
}

// Flops a second of a square matrix product on one thread: the limit of everything dense.
static double product_rate(int n)
{
    double time[REPEATS];
    const size_t size = (size_t)n * (size_t)n;
    double *a = calloc(3 * size, sizeof *a);
    if (!a) exit(EXIT_FAILURE);
    for (size_t i = 0; i < 2 * size; i++) a[i] = 1.0 / (double)(1 + i % 17);
    openblas_set_num_threads(1);
    for (int k = 0; k < REPEATS; k++) {
        const double start = now();
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, a, n, a + size, n, 0.0, a + 2 * size, n);
        time[k] = now() - start;
    }
    free(a);
    return 2.0 * pow(n, 3) / median(time);
}

// The mean solution on some threads: seconds in all, and of the factorisation.
static double mean_solution(const pdmc_problem *problem, int threads, double *factorisation, pdmc_solver_report *report)
{
    double time[REPEATS], factor[REPEATS], assembly;
    for (int k = 0; k < REPEATS; k++) {
        pdmc_discretisation plate;
        const double start = now();
        if (pdmc_discretise(problem, threads, &plate) != PDMC_OK) give_up();
        time[k] = now() - start;
        plate.verbs->runtime(plate.method, &assembly, &factor[k]);
        *report = plate.verbs->report(plate.method);
        pdmc_discretisation_clear(&plate);
    }
    *factorisation = median(factor);
    return median(time);
}

// Samples a second, of the solutions alone and with their energies.
static double sample_rate(pdmc_study *study, pdmc_inverse inverse, int samples, double *with_energies)
{
    const pdmc_run_options options = {.threads = 1};
    pdmc_results results;
    study->problem.sampling.inverse = inverse;
    study->problem.sampling.samples = samples;
    if (pdmc_run(study, &options, &results) != PDMC_OK) give_up();
    const double sampling = results.runtime.sampling;
    *with_energies = samples / (sampling + results.runtime.energy);
    pdmc_results_clear(&results);
    return samples / sampling;
}

// Flops of a sample in the projected model: the terms of the expansion, and the energies of all directions as quadratic forms
// of every pair of unknowns.
static double projected_flops(const pdmc_problem *problem)
{
    pdmc_discretisation plate;
    pdmc_affine model = {0};
    if (pdmc_discretise(problem, 1, &plate) != PDMC_OK || plate.verbs->affine(plate.method, &model) != PDMC_OK)
        give_up();
    const double n = model.unknowns, directions = model.tips * model.angles;
    const double flops = 2.0 * problem->sampling.order * model.terms * n * n + directions * model.rings * n * (n + 1.0);
    pdmc_affine_clear(&model);
    pdmc_discretisation_clear(&plate);
    return flops;
}

// The whole study with very many samples, of which the file would have the first; against the product's rate on all threads.
static void many_samples(pdmc_study *study, int samples, int threads, double rate)
{
    const pdmc_run_options options = {.threads = threads};
    pdmc_results results;
    study->problem.sampling.inverse = PDMC_INVERSE_NEUMANN;
    study->problem.sampling.samples = samples;
    const double limit = projected_flops(&study->problem) * samples / (threads * rate);
    if (pdmc_run(study, &options, &results) != PDMC_OK) give_up();
    const double seconds = results.runtime.total;
    printf(
        "%d samples, %d thread%s %8.2f s for the whole study, %.0f samples/s, %.0f %% of the projected model's limit\n",
        samples, threads, threads > 1 ? "s" : " ", seconds, samples / seconds, 100.0 * limit / seconds);
    pdmc_results_clear(&results);
}

int main(int argc, char *argv[])
{
    pdmc_study study;
    pdmc_solver_report report;
    double factorisation, with_energies, direct_with_energies;
    if (argc != 2) {
        fputs("usage: bench STUDY\n", stderr);
        return 64;
    }
    if (pdmc_study_read(argv[1], &study) != PDMC_OK) give_up();
    const double one = mean_solution(&study.problem, 1, &factorisation, &report);
    const double m = report.rows, n = report.unknowns, rate = product_rate(report.unknowns);
    const double work = 4.0 * m * n * n - 4.0 / 3.0 * n * n * n; // of Q R and of forming Q
    printf("matrix product            %8.1f Gflop/s on one thread\n", rate / 1e9);
    printf("mean solution, 1 thread   %8.3f s: %d nodes, %d unknowns\n", one, report.nodes, report.unknowns);
    printf("  its factorisation       %8.3f s, %.0f %% of the product's rate\n", factorisation,
           100.0 * work / factorisation / rate);
    const double two = mean_solution(&study.problem, 2, &factorisation, &report);
    printf("mean solution, 2 threads  %8.3f s, %.2f times one thread\n", two, one / two);

    const double expanded = sample_rate(&study, PDMC_INVERSE_NEUMANN, 6000, &with_energies);
    const double direct = sample_rate(&study, PDMC_INVERSE_DIRECT, 64, &direct_with_energies);
    printf("Neumann, 1 thread         %8.0f samples/s, %.0f with their energies\n", expanded, with_energies);
    printf("direct, 1 thread          %8.1f samples/s, %.0f %% of the product's rate\n", direct,
           100.0 * direct * (2.0 * m * n * n - 2.0 / 3.0 * n * n * n) / rate);
    printf("Neumann over direct       %8.0f times, %.0f with energies\n", expanded / direct,
           with_energies / direct_with_energies);
    for (int threads = 1; threads <= 2; threads++) many_samples(&study, 1000000, threads, rate);
    pdmc_study_clear(&study);
    return 0;
}
