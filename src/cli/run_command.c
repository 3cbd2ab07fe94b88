// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_command.h"

#include "cli/exit_code.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "pdmc/run.h"
#include "pdmc/views.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <sysexits.h>
#include <unistd.h>

static bool draws_samples(const pdmc_study *study)
{
    const bool is_random = study->problem.uncertainty_count > 0;
    return study->problem.kind == PDMC_STATIC || (pdmc_is_of_bodies(study->problem.kind) && is_random);
}

static const char *named(pdmc_problem_kind kind)
{
    static const char *const names[] = {
        [PDMC_STATIC] = "a static",
        [PDMC_DYNAMIC] = "a dynamic",
        [PDMC_EXPLICIT] = "this explicit",
        [PDMC_QUASI_STATIC] = "this quasi-static",
        [PDMC_SCALAR] = "a scalar",
        [PDMC_ELASTIC] = "an elastic",
        [PDMC_QUADRATURE] = "a quadrature",
    };
    return names[kind];
}

static pdmc_status read_study(const arguments *given, pdmc_study *study)
{
    pdmc_status status = pdmc_study_read(given->input, study);
    if (status != PDMC_OK) return status;
    if (!draws_samples(study) && (given->has_seed || given->samples > 0) && !given->quiet)
        fprintf(stderr, "pdmc: warning: %s study draws no samples, their number and seed change nothing\n",
                named(study->problem.kind));
    if (given->has_seed) study->problem.sampling.seed = given->seed;
    if (given->has_seed) status = pdmc_study_resolve(study);
    if (given->samples > 0 && status == PDMC_OK && draws_samples(study))
        status = pdmc_study_set_samples(study, given->samples);
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
static const char *counted(pdmc_problem_kind kind, bool draws)
{
    if (kind == PDMC_QUADRATURE) return "measurements";
    if (draws) return "samples";
    if (kind == PDMC_SCALAR) return "levels";
    if (kind == PDMC_ELASTIC) return "bodies";
    return kind == PDMC_QUASI_STATIC ? "loads" : "time steps";
}

// An explicit study with random quantities moves once at its means before it counts samples.
static bool has_samples(const pdmc_results *results)
{
    return results->kind == PDMC_STATIC || results->ensemble.sample_count > 0;
}

// How many of them there are.
static int count_done(const pdmc_results *results)
{
    switch (results->kind) {
    case PDMC_STATIC: return results->sample_count;
    case PDMC_DYNAMIC: return results->motion.time_count - 1;
    case PDMC_SCALAR: return results->scalar.level_count;
    case PDMC_ELASTIC: return 1;
    case PDMC_QUASI_STATIC:
        return has_samples(results) ? results->ensemble.sample_count : results->particles.record_count - 1;
    case PDMC_EXPLICIT:
        return has_samples(results) ? results->ensemble.sample_count : (int)results->particles.steps;
    case PDMC_QUADRATURE: break;
    }
    return results->quadrature.rule_count * results->quadrature.ratio_count;
}

static void tell_interruption(const pdmc_results *results, const char *path)
{
    if (results->reliability.group_count > 0)
        fprintf(stderr, "pdmc: interrupted: all %d samples are saved in %s, rare growth is not complete\n",
                results->sample_count, path);
    else
        fprintf(stderr, "pdmc: interrupted: the first %d %s are saved in %s\n", count_done(results),
                counted(results->kind, has_samples(results)), path);
}

static int tell_stop(const pdmc_results *results, const char *path)
{
    fprintf(stderr, "pdmc: %s; the %s until then are saved in %s\n", results->particles.stop,
            results->kind == PDMC_QUASI_STATIC ? "loads" : "steps", path);
    return EX_DATAERR;
}

static int write_results(const arguments *given, const pdmc_results *results, const char *path)
{
    const pdmc_status status = pdmc_results_write(results, path, given->force);
    if (status != PDMC_OK) return fail(status);
    if (!given->quiet) print_results(results, path);
    if (results->status == PDMC_RUN_SAMPLE_CAP) return EXIT_SAMPLE_CAP;
    if (results->status == PDMC_RUN_NOT_FINITE || results->status == PDMC_RUN_NO_REST) return tell_stop(results, path);
    if (results->status != PDMC_RUN_INTERRUPTED) return EX_OK;
    tell_interruption(results, path);
    return EX_TEMPFAIL;
}

// The system would let the run begin, and kill it when the memory is written to.
static void warn_of_memory(double bytes)
{
    const double machine = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if (bytes > machine)
        fprintf(stderr, "pdmc: warning: the run needs about %.0f MB of memory, this machine has %.0f MB\n", bytes / 1e6,
                machine / 1e6);
}

static double bytes_of(const pdmc_study *study, int threads)
{
    if (study->problem.kind == PDMC_SCALAR)
        return pdmc_scalar_cost_of(&study->scalar, study->scalar.levels - 1, threads).bytes;
    if (study->problem.kind == PDMC_ELASTIC) return pdmc_elastic_cost_of(&study->elastic, threads).bytes;
    if (pdmc_is_of_bodies(study->problem.kind)) return pdmc_run_ensemble_cost(study, threads).bytes;
    if (study->problem.kind == PDMC_QUADRATURE) return pdmc_run_quadrature_bytes(&study->quadrature);
    return pdmc_run_cost(&study->problem, threads).bytes;
}

static int run_study(const arguments *given, const pdmc_study *study, const char *path)
{
    progress state;
    pdmc_results results = {0};
    const pdmc_run_options options = {
        .threads = given->threads, .progress = progress_show, .round = progress_round, .context = &state};
    if (!given->quiet) warn_of_memory(bytes_of(study, options.threads));
    progress_start(given->quiet, counted(study->problem.kind, draws_samples(study)), &state);
    const pdmc_status status = pdmc_run(study, &options, &results);
    progress_end(&state);
    const int code = status == PDMC_OK ? write_results(given, &results, path) : fail(pdmc_study_place(study, status));
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

static void print_seconds(double s)
{
    if (s < 9.95) printf("%.1f s", s);
    else if (s < 300.0) printf("%.0f s", s);
    else if (s < 3.0 * 3600.0) printf("%.0f min", s / 60.0);
    else printf("%.0f h", s / 3600.0);
}

static void print_cost_and_threads(double bytes, double seconds, int threads)
{
    printf("; about %.0f MB and ", bytes / 1e6);
    print_seconds(seconds);
    printf(" on %d thread%s", threads, threads == 1 ? "" : "s");
}

static pdmc_status check_plate(const pdmc_study *study, int threads)
{
    const pdmc_status status = pdmc_problem_check_equilibrium(&study->problem);
    if (status != PDMC_OK) return status;
    const pdmc_cost cost = pdmc_run_cost(&study->problem, threads);
    printf("%s\n# %d nodes, %d unknowns, %d rows", study->resolved, cost.nodes, cost.unknowns, cost.rows);
    print_cost_and_threads(cost.bytes, cost.seconds, threads);
    if (cost.most_seconds > cost.seconds) {
        printf(", up to ");
        print_seconds(cost.most_seconds);
        printf(" for the most samples");
    }
    putchar('\n');
    return PDMC_OK;
}

static void print_steps(const pdmc_explicit *motion, const pdmc_particles *particles)
{
    const double step = pdmc_particles_step_size(particles);
    if (motion->load_steps > 0) printf("%d loads, where no bond breaks; more where some do", motion->load_steps);
    else
        printf("%.0f steps of %.4g, stable up to %.4g", ceil(motion->duration / step * (1.0 - 1e-9)), step,
               pdmc_particles_stable_step(particles));
}

// What the engine would refuse is found by placing the nodes.
static pdmc_status check_explicit(const pdmc_study *study, int threads)
{
    const pdmc_explicit_cost cost = pdmc_run_ensemble_cost(study, threads);
    pdmc_particles *particles = NULL;
    const pdmc_status status = pdmc_explicit_particles(&study->motion, threads, &particles);
    if (status != PDMC_OK) return status;
    printf("%s\n# %d nodes, %.0f bonds, ", study->resolved, pdmc_particles_count(particles),
           (double)pdmc_particles_bonds(particles));
    print_steps(&study->motion, particles);
    if (draws_samples(study)) printf(", %d samples", study->problem.sampling.samples);
    print_cost_and_threads(cost.bytes, cost.seconds, threads);
    putchar('\n');
    pdmc_particles_destroy(particles);
    return PDMC_OK;
}

static pdmc_status check_quadrature(const pdmc_study *study, int threads)
{
    (void)threads;
    printf("%s\n# %d rules at %d spacings, about %.0f MB\n", study->resolved, PDMC_HORIZON_RULES,
           study->quadrature.ratio_count, pdmc_run_quadrature_bytes(&study->quadrature) / 1e6);
    return PDMC_OK;
}

static pdmc_status check_scalar(const pdmc_study *study, int threads)
{
    const pdmc_scalar *scalar = &study->scalar;
    const pdmc_scalar_cost last = pdmc_scalar_cost_of(scalar, scalar->levels - 1, threads);
    double seconds = 0.0;
    for (int level = 0; level < scalar->levels; level++) seconds += pdmc_scalar_cost_of(scalar, level, threads).seconds;
    printf("%s\n# %d levels, the last one of about %.3g elements and %.2g entries", study->resolved, scalar->levels,
           last.elements, last.entries);
    print_cost_and_threads(last.bytes, seconds, threads);
    return PDMC_OK;
}

static pdmc_status check_elastic(const pdmc_study *study, int threads)
{
    const pdmc_elastic_cost cost = pdmc_elastic_cost_of(&study->elastic, threads);
    printf("%s\n# %.0f nodes with about %.0f bonds each", study->resolved, cost.nodes, cost.bonds);
    print_cost_and_threads(cost.bytes, cost.seconds, threads);
    return PDMC_OK;
}

static pdmc_status check_study(const pdmc_study *study, int threads)
{
    switch (study->problem.kind) {
    case PDMC_EXPLICIT:
    case PDMC_QUASI_STATIC: return check_explicit(study, threads);
    case PDMC_SCALAR: return check_scalar(study, threads);
    case PDMC_ELASTIC: return check_elastic(study, threads);
    case PDMC_QUADRATURE: return check_quadrature(study, threads);
    case PDMC_STATIC:
    case PDMC_DYNAMIC: break;
    }
    return check_plate(study, threads);
}

int check_command(const arguments *given)
{
    pdmc_study study = {0};
    pdmc_status status = read_study(given, &study);
    if (status == PDMC_OK) status = pdmc_study_place(&study, check_study(&study, given->threads));
    if (status == PDMC_OK && !given->quiet) warn_of_memory(bytes_of(&study, given->threads));
    pdmc_study_clear(&study);
    return status == PDMC_OK ? EX_OK : fail(status);
}
