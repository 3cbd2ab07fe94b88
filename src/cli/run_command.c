// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_command.h"

#include "cli/exit_code.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "pdmc/run.h"
#include "pdmc/views.h"

#include <signal.h>
#include <stdio.h>
#include <sysexits.h>
#include <unistd.h>

static pdmc_status read_study(const arguments *given, pdmc_study *study)
{
    pdmc_status status = pdmc_study_read(given->input, study);
    if (status != PDMC_OK) return status;
    if (study->problem.kind == PDMC_DYNAMIC && (given->has_seed || given->samples > 0) && !given->quiet)
        fprintf(stderr, "pdmc: warning: a dynamic study draws no samples, their number and seed change nothing\n");
    if (given->has_seed) study->problem.sampling.seed = given->seed;
    if (given->has_seed) status = pdmc_study_resolve(study);
    if (given->samples > 0 && status == PDMC_OK) status = pdmc_study_set_samples(study, given->samples);
    if (status == PDMC_OK && !given->quiet) fputs(study->warnings, stderr);
    return status;
}

// What is printed is what the file holds. The results are safe by now: where standard output cannot take the table, main()
// says so.
static void print_results(const pdmc_results *results, const char *path)
{
    pdmc_results written = {0};
    pdmc_status status = pdmc_results_read(path, &written);
    if (status == PDMC_OK) status = pdmc_view_table(&written, stdout);
    if (status != PDMC_OK && status != PDMC_ERR_IO) fail(status);
    pdmc_results_clear(&written);
    if (results->solver.condition > 1e13)
        fprintf(stderr, "pdmc: warning: condition number %.1e is past 1e13: take a smaller solver.shape\n",
                results->solver.condition);
    fprintf(stderr, "written: %s\n", path);
}

// What a run counts.
static const char *counted(pdmc_problem_kind kind)
{
    return kind == PDMC_STATIC ? "samples" : "time steps";
}

static void tell_interruption(const pdmc_results *results, const char *path)
{
    const bool is_static = results->kind == PDMC_STATIC;
    if (results->reliability.group_count > 0)
        fprintf(stderr, "pdmc: interrupted: all %d samples are saved in %s, rare growth is not complete\n",
                results->sample_count, path);
    else
        fprintf(stderr, "pdmc: interrupted: the first %d %s are saved in %s\n",
                is_static ? results->sample_count : results->motion.time_count - 1, counted(results->kind), path);
}

static int write_results(const arguments *given, const pdmc_results *results, const char *path)
{
    const pdmc_status status = pdmc_results_write(results, path, given->force);
    if (status != PDMC_OK) return fail(status);
    if (!given->quiet) print_results(results, path);
    if (results->status == PDMC_RUN_SAMPLE_CAP) return EXIT_SAMPLE_CAP;
    if (results->status != PDMC_RUN_INTERRUPTED) return EX_OK;
    tell_interruption(results, path);
    return EX_TEMPFAIL;
}

// The system would let the run begin, and kill it when the memory is written to.
static void warn_of_memory(const pdmc_cost *cost)
{
    const double machine = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if (cost->bytes > machine)
        fprintf(stderr, "pdmc: warning: the run needs about %.0f MB of memory, this machine has %.0f MB\n",
                cost->bytes / 1e6, machine / 1e6);
}

static int run_study(const arguments *given, const pdmc_study *study, const char *path)
{
    progress state;
    pdmc_results results = {0};
    const pdmc_run_options options = {
        .threads = given->threads, .progress = progress_show, .round = progress_round, .context = &state};
    const pdmc_cost cost = pdmc_run_cost(&study->problem, options.threads);
    if (!given->quiet) warn_of_memory(&cost);
    progress_start(given->quiet, counted(study->problem.kind), &state);
    const pdmc_status status = pdmc_run(study, &options, &results);
    progress_end(&state);
    const int code = status == PDMC_OK ? write_results(given, &results, path) : fail(status);
    pdmc_results_clear(&results);
    return code;
}

int run_command(const arguments *given)
{
    pdmc_study study = {0};
    char name[PATH_MAX];
    signal(SIGPIPE, SIG_IGN); // a run is not lost because nobody reads its messages any more
    default_output(given->input, name);
    const char *path = given->output ? given->output : name;
    const pdmc_status status = read_study(given, &study);
    int code = status == PDMC_OK ? check_output(given->input, path, given->force) : fail(status);
    if (code == EX_OK) code = run_study(given, &study, path);
    pdmc_study_clear(&study);
    return code;
}

static void print_cost(const pdmc_cost *cost, int threads)
{
    const double s = cost->seconds;
    printf("# %d nodes, %d unknowns, %d rows; about %.0f MB and ", cost->nodes, cost->unknowns, cost->rows,
           cost->bytes / 1e6);
    if (s < 9.95) printf("%.1f s", s);
    else if (s < 300.0) printf("%.0f s", s);
    else if (s < 3.0 * 3600.0) printf("%.0f min", s / 60.0);
    else printf("%.0f h", s / 3600.0);
    printf(" on %d thread%s\n", threads, threads == 1 ? "" : "s");
}

int check_command(const arguments *given)
{
    pdmc_study study = {0};
    pdmc_status status = read_study(given, &study);
    if (status == PDMC_OK && study.problem.kind != PDMC_EXPLICIT)
        status = pdmc_problem_check_equilibrium(&study.problem);
    if (status == PDMC_OK) {
        const pdmc_cost cost = pdmc_run_cost(&study.problem, given->threads);
        printf("%s\n", study.resolved);
        print_cost(&cost, given->threads);
        if (!given->quiet) warn_of_memory(&cost);
    }
    pdmc_study_clear(&study);
    return status == PDMC_OK ? EX_OK : fail(status);
}
