// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_command.h"

#include "cli/exit_code.h"
#include "pdmc/run.h"
#include "pdmc/views.h"

#include <libgen.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>
#include <unistd.h>

static volatile sig_atomic_t interrupts;

// The first asks for the blocks under way to be finished and everything to be written; the third leaves at once.
static void on_signal(int number)
{
    interrupts = interrupts + 1;
    if (interrupts >= 3) _exit(128 + number);
}

static void catch_signals(void)
{
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

static int thread_count(const arguments *given)
{
    if (given->threads > 0) return given->threads;
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return processors > 0 ? (int)processors : 1;
}

static pdmc_status read_study(const arguments *given, pdmc_study *study)
{
    pdmc_status status = pdmc_study_read(given->input, study);
    if (status != PDMC_OK) return status;
    if (given->has_seed) study->problem.sampling.seed = given->seed;
    if (given->samples > 0) study->problem.sampling.samples = given->samples;
    if (given->has_seed || given->samples > 0) status = pdmc_study_resolve(study);
    if (status == PDMC_OK && !given->quiet) fputs(study->warnings, stderr);
    return status;
}

// "folder/name.cfg" gives "name.h5".
static void default_output(const char *study, char path[PATH_MAX])
{
    char copy[PATH_MAX];
    snprintf(copy, sizeof copy, "%s", study);
    char *name = basename(copy), *dot = strrchr(name, '.');
    if (dot && dot != name) *dot = '\0';
    snprintf(path, PATH_MAX, "%.*s.h5", PATH_MAX - 4, name);
}

// What would make the run useless is found before it starts.
static int check_output(const char *path, bool force)
{
    char copy[PATH_MAX];
    snprintf(copy, sizeof copy, "%s", path);
    const char *folder = dirname(copy);
    if (access(folder, W_OK | X_OK) != 0) {
        fprintf(stderr, "pdmc: %s: ", path);
        perror("the folder cannot be written to");
        return EX_CANTCREAT;
    }
    if (force || access(path, F_OK) != 0) return EX_OK;
    fprintf(stderr, "pdmc: %s: exists already; --force overwrites it, -o FILE writes elsewhere\n", path);
    return EX_CANTCREAT;
}

// A bar that is redrawn on a terminal, a line for each tenth elsewhere.
typedef struct {
    bool quiet, live;
    int tenth;
} progress;

static bool show_progress(void *context, int done, int total)
{
    progress *state = context;
    const int tenth = (int)(10LL * done / total);
    if (!state->quiet && state->live) {
        fprintf(stderr, "\r%d of %d samples%s", done, total, done == total ? "\n" : "");
    } else if (!state->quiet && tenth > state->tenth) {
        fprintf(stderr, "%d of %d samples\n", done, total);
    }
    state->tenth = tenth;
    return interrupts == 0;
}

static int write_results(const arguments *given, const pdmc_results *results, const char *path)
{
    const pdmc_status status = pdmc_results_write(results, path, given->force);
    if (status != PDMC_OK) return fail(status);
    if (!given->quiet) {
        if (pdmc_view_table(results, stdout) != PDMC_OK) return EX_IOERR;
        if (results->solver.condition > 1e13)
            fprintf(stderr, "pdmc: warning: condition number %.1e is past 1e13: take a smaller solver.shape\n",
                    results->solver.condition);
        fprintf(stderr, "written: %s\n", path);
    }
    if (results->status != PDMC_RUN_INTERRUPTED) return EX_OK;
    fprintf(stderr, "pdmc: interrupted after %d samples, which are saved in %s\n", results->sample_count, path);
    return EX_TEMPFAIL;
}

int run_command(const arguments *given)
{
    pdmc_study study = {0};
    pdmc_results results = {0};
    char path[PATH_MAX];
    if (given->output) snprintf(path, sizeof path, "%s", given->output);
    else default_output(given->input, path);

    const char *terminal = getenv("TERM");
    progress state = {.quiet = given->quiet,
                      .live = isatty(STDERR_FILENO) && !(terminal && strcmp(terminal, "dumb") == 0)};
    const pdmc_run_options options = {.threads = thread_count(given), .progress = show_progress, .context = &state};
    catch_signals();
    pdmc_status status = read_study(given, &study);
    int code = status == PDMC_OK ? check_output(path, given->force) : fail(status);
    if (code == EX_OK) {
        status = pdmc_run(&study, &options, &results);
        code = status == PDMC_OK ? write_results(given, &results, path) : fail(status);
    }
    pdmc_results_clear(&results);
    pdmc_study_clear(&study);
    return code;
}

int check_command(const arguments *given)
{
    pdmc_study study = {0};
    pdmc_status status = read_study(given, &study);
    if (status == PDMC_OK) status = pdmc_problem_check_equilibrium(&study.problem);
    if (status == PDMC_OK) {
        const int threads = thread_count(given);
        const pdmc_cost cost = pdmc_run_cost(&study.problem, threads);
        printf("%s\n# %d nodes, %d unknowns, %d rows; about %.0f MB and %.1f s on %d threads\n", study.resolved,
               cost.nodes, cost.unknowns, cost.rows, cost.bytes / 1e6, cost.seconds, threads);
    }
    pdmc_study_clear(&study);
    return status == PDMC_OK ? EX_OK : fail(status);
}
