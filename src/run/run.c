// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/run.h"

#include "base/base_impl.h"
#include "pdmc/discretisation.h"
#include "run/coarser.h"
#include "run/control.h"
#include "run/elastic.h"
#include "run/ensemble.h"
#include "run/family.h"
#include "run/motion.h"
#include "run/quadrature.h"
#include "run/scalar.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <sys/resource.h>
#include <time.h>

enum { HISTOGRAM_BINS = 60, BINS_OF_FEW = 10 }; // the latter of explicit studies, whose samples are dear


static pdmc_status copy_text(const char *from, char **to)
{
    *to = pdmc_strdup(from);
    return *to ? PDMC_OK : PDMC_ERR_NOMEM;
}

static pdmc_status stamp_date(char **text)
{
    char date[32];
    struct tm utc;
    const time_t now = time(NULL);
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&now, &utc));
    return copy_text(date, text);
}

static pdmc_status describe_mesh(const pdmc_study *study, pdmc_results *results)
{
    const pdmc_solver_options *solver = &study->problem.solver;
    char generator[PDMC_GENERATOR_SIZE];
    if (solver->method != PDMC_METHOD_GALERKIN || solver->mesh != PDMC_PLATE_TRIANGLES)
        return copy_text(study->motion.mesh_generator, &results->mesh_generator);
    const pdmc_status status = pdmc_mesh_generator(generator);
    return status == PDMC_OK ? copy_text(generator, &results->mesh_generator) : status;
}

static pdmc_status describe_study(const pdmc_study *study, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = &study->problem;
    PDMC_TRY(copy_text(problem->title, &results->title));
    PDMC_TRY(copy_text(problem->length_unit, &results->length_unit));
    PDMC_TRY(copy_text(problem->force_unit, &results->force_unit));
    PDMC_TRY(copy_text(problem->time_unit, &results->time_unit));
    PDMC_TRY(copy_text(study->input, &results->input));
    PDMC_TRY(copy_text(study->resolved, &results->resolved));
    PDMC_TRY(copy_text(pdmc_version(), &results->pdmc_version));
    PDMC_TRY(copy_text(pdmc_git_sha1(), &results->git_sha1));
    PDMC_TRY(describe_mesh(study, results));
    PDMC_TRY(stamp_date(&results->date_and_time));
    results->kind = problem->kind;
    results->seed = problem->sampling.seed;
    results->status = PDMC_RUN_COMPLETE;
    results->confidence = 0.95;
    results->plate_width = problem->plate.width;
    results->plate_height = problem->plate.height;
    results->fracture_energy = problem->material.fracture_energy;
    results->extension = problem->energy.extension;
    results->energy_horizon = problem->energy.horizon;
    results->measure = problem->energy.measure;
    results->bonds = problem->energy.bonds;
    results->replicates = problem->sampling.design == PDMC_DESIGN_MONTE_CARLO ? 0 : problem->sampling.replicates;
    if (problem->kind == PDMC_STATIC) results->histogram_bins = HISTOGRAM_BINS;
    if (pdmc_is_of_bodies(problem->kind) && problem->uncertainty_count > 0) results->histogram_bins = BINS_OF_FEW;
done:
    return status;
}

static pdmc_status describe_geometry(const pdmc_problem *problem, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(results->cracks, 4 * problem->crack_count);
    PDMC_NEW(results->angles, problem->energy.angles);
    results->crack_count = problem->crack_count;
    results->angle_count = problem->energy.angles;
    for (int c = 0; c < problem->crack_count; c++) {
        for (int k = 0; k < 2; k++) {
            results->cracks[4 * c + k] = problem->cracks[c].from[k];
            results->cracks[4 * c + 2 + k] = problem->cracks[c].to[k];
        }
    }
    for (int a = 0; a < problem->energy.angles; a++) results->angles[a] = 2.0 * M_PI * a / problem->energy.angles;
done:
    return status;
}

// The plate and, to estimate errors by, a coarser one: a residual does not bound the error of K, their difference does so far.
typedef struct {
    pdmc_problem coarse; // which the coarser plate looks at
    pdmc_discretisation plate, coarser;
    bool has_coarser;
} plates;

static void plates_clear(plates *p)
{
    pdmc_discretisation_clear(&p->plate);
    pdmc_discretisation_clear(&p->coarser);
}

// Grids of bonds side by side, since their factorisation takes one thread; a collocation shares its own work among all.
static pdmc_status discretise(const pdmc_problem *problem, int threads, plates *p)
{
    p->coarse = *problem;
    p->has_coarser = problem->energy.tip_count > 0 && pdmc_make_coarser(&p->coarse);
    const int sides = p->has_coarser && threads > 1 && problem->solver.method == PDMC_METHOD_BOND ? 2 : 1;
    pdmc_status status = PDMC_OK, other = PDMC_OK;
    char message[512] = ""; // errors are kept for the thread that met them
    pdmc_blas_prepare();    // what is set inside a parallel region does not come out of it
#pragma omp parallel num_threads(sides)
    {
        if (omp_get_thread_num() == 0) status = pdmc_discretise(problem, threads, &p->plate);
        if (omp_get_thread_num() == sides - 1 && p->has_coarser && (sides == 2 || status == PDMC_OK)) {
            other = pdmc_discretise(&p->coarse, threads, &p->coarser);
            if (other != PDMC_OK) snprintf(message, sizeof message, "%s", pdmc_last_error());
        }
    }
    if (status != PDMC_OK || other == PDMC_OK) return status;
    return pdmc_raise(other, "%s", message);
}

static pdmc_status estimate_errors(const pdmc_problem *problem, const plates *p, pdmc_results *results)
{
    for (int t = 0; t < results->tip_count; t++) {
        pdmc_tip *tip = &results->tips[t], other = {.stress_intensity = {NAN, NAN}, .t_stress = NAN};
        const pdmc_discretisation *coarser = &p->coarser;
        const pdmc_status status =
            p->has_coarser ? coarser->verbs->tip(coarser->method, problem->energy.tips[t], &other) : PDMC_OK;
        if (status != PDMC_OK) return status;
        for (int k = 0; k < 2; k++)
            tip->stress_intensity_error[k] = fabs(tip->stress_intensity[k] - other.stress_intensity[k]);
        tip->t_stress_error = fabs(tip->t_stress - other.t_stress);
    }
    return PDMC_OK;
}

static pdmc_status describe_solution(const pdmc_problem *problem, const plates *p, int threads, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const pdmc_discretisation *plate = &p->plate;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    results->bin_count = noise ? noise->bins : 0;
    PDMC_NEW(results->tips, problem->energy.tip_count);
    results->tip_count = problem->energy.tip_count;
    for (int t = 0; t < results->tip_count; t++)
        PDMC_TRY(plate->verbs->tip(plate->method, problem->energy.tips[t], &results->tips[t]));
    PDMC_TRY(estimate_errors(problem, p, results));
    results->solver = plate->verbs->report(plate->method);
    PDMC_TRY(plate->verbs->field(plate->method, &results->field));
    plate->verbs->runtime(plate->method, &results->runtime.assembly, &results->runtime.factorisation);
    results->runtime.threads = threads;
done:
    return status;
}

// Whether to go on, before there are samples or steps to save.
static pdmc_status ask(const pdmc_problem *problem, const pdmc_run_options *options)
{
    const bool is_static = problem->kind == PDMC_STATIC;
    const int total = is_static ? problem->sampling.samples : pdmc_problem_steps(problem);
    if (!options->progress || options->progress(options->context, 0, total)) return PDMC_OK;
    return pdmc_raise(PDMC_ERR_INTERRUPTED, "stopped before the first %s: there is nothing to save",
                      is_static ? "samples" : "time step");
}

static pdmc_status run_samples(const pdmc_problem *problem, const pdmc_discretisation *plate,
                               const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_affine model = {0};
    const pdmc_affine_family family = pdmc_plate_family(problem, options->threads);
    pdmc_sample_counts *counts = NULL;
    PDMC_TRY(plate->verbs->affine(plate->method, &model));
    if (pdmc_problem_moves_cracks(problem)) model.family = &family;
    PDMC_TRY(ask(problem, options));
    results->runtime.operators = model.operator_seconds;
    results->runtime.energy_rows = model.energy_seconds;
    PDMC_TRY(pdmc_monte_carlo(problem, &model, options, results, &counts));
    const double sampled = pdmc_seconds();
    PDMC_TRY(pdmc_summarise(options, counts, results));
    results->runtime.statistics = pdmc_seconds() - sampled;
    if (problem->control.samples > 0 && results->status != PDMC_RUN_INTERRUPTED)
        PDMC_TRY(pdmc_run_control(problem, options, results));
done:
    pdmc_sample_counts_destroy(&counts);
    pdmc_affine_clear(&model);
    return status;
}

// The system counts it for the process as a whole, in kB.
static double peak_memory(void)
{
    struct rusage usage;
    return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024.0 * (double)usage.ru_maxrss : NAN;
}

static pdmc_status run_plate(const pdmc_problem *problem, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    plates p = {0};
    PDMC_TRY(describe_geometry(problem, results));
    PDMC_TRY(ask(problem, options));
    PDMC_TRY(discretise(problem, options->threads, &p));
    PDMC_TRY(ask(problem, options));
    PDMC_TRY(describe_solution(problem, &p, options->threads, results));
    PDMC_TRY(ask(problem, options));
    PDMC_TRY((problem->kind == PDMC_STATIC ? run_samples : pdmc_run_motion)(problem, &p.plate, options, results));
done:
    plates_clear(&p);
    return status;
}

pdmc_status pdmc_run(const pdmc_study *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = &study->problem;
    const double start = pdmc_seconds();
    *results = (pdmc_results){.accuracy = pdmc_no_accuracy};
    PDMC_TRY(describe_study(study, results));
    if (pdmc_is_of_bodies(problem->kind)) PDMC_TRY(pdmc_run_ensemble(study, options, results));
    else if (problem->kind == PDMC_ELASTIC) PDMC_TRY(pdmc_run_elastic(&study->elastic, options, results));
    else if (problem->kind == PDMC_SCALAR) PDMC_TRY(pdmc_run_scalar(&study->scalar, options, results));
    else if (problem->kind == PDMC_QUADRATURE) PDMC_TRY(pdmc_run_quadrature(&study->quadrature, options, results));
    else PDMC_TRY(run_plate(problem, options, results));
    results->runtime.total = pdmc_seconds() - start;
    results->runtime.output = NAN; // measured where the file is made
    results->runtime.peak_memory = peak_memory();
done:
    if (status != PDMC_OK) pdmc_results_clear(results);
    return status;
}
