// SPDX-License-Identifier: GPL-3.0-or-later

/// The cost of a collocation: its factorisation, and samples in the space of its responses.

#include "run/cost_impl.h"

#include "pdmc/fracture.h"

#include <math.h>

// What a thread of a 2023 server core (AMD EPYC, OpenBLAS 0.3.21) needs, measured on studies/center_crack with spacings
// of 0.5, 0.25 and 0.125, with all rings and without, and with direct solves.
static const double seconds_per_flop = 1.0 / 30e9;  // of Householder QR
static const double seconds_per_row_value = 15e-9;  // of the basis on a ring: values of a row of the operator
static const double seconds_per_bond_value = 5e-9;  // of the basis at the two ends of a bond
static const double seconds_per_word_value = 16e-9; // of a ring's operator, in the making of the response space
static const double seconds_per_bond = 0.4e-9, seconds_per_bond_direction = 0.027e-9; // of a sample
static const double seconds_per_draw = 5e-6;                                          // of a sample, with its solution
static const double seconds_per_form = 10e-9, seconds_per_tallied_value = 8e-9;       // of a sample in a direction
static const double seconds_per_distribution = 1.7e-3;                                // intervals of a histogram
static const double seconds_per_sorted_value = 25e-9;                                 // times log2 of their number
static const double seconds_per_byte = 5e-9;                                          // of the result file
static const double seconds_per_step_value = 3e-9;                                    // of a matrix, in a time step
static const double bytes_of_program = 15e6;

static const double area_points = 25.0;   // of the weak form's rule, to a node: 14 to 38 for plates of 121 to 676 nodes
static const double response_size = 28.0; // dimension of the response space, as measured

// The collocation, as counted in src/kansa/points.c, with all points of the rings round the cracks.
typedef struct {
    double nodes, unknowns, interior, rows;
} sizes;

static sizes count(const pdmc_problem *problem, double spacing)
{
    const pdmc_solver_options *options = &problem->solver;
    const double nx = fmax(1.0, round(problem->plate.width / spacing));
    const double ny = fmax(1.0, round(problem->plate.height / spacing));
    const double monomials = 0.5 * (options->polynomial_degree + 1) * (options->polynomial_degree + 2);
    const double cracks = problem->crack_count;
    sizes s = {.nodes = (nx + 1.0) * (ny + 1.0)};
    s.unknowns = 2.0 * ((nx + 3.0) * (ny + 3.0) + monomials) + 4.0 * options->crack_orders * cracks;
    s.interior = 2.0 * (s.nodes + 192.0 * cracks);
    s.rows = s.interior + 2.0 * (4.0 * (nx + ny + 4.0) + 80.0 * cracks) + 2.0 * monomials;
    return s;
}

// How often what is done.
typedef struct {
    sizes fine, coarse;                            // coarse: the second solution, by which the errors are estimated
    double bonds;                                  // that cross a line of growth
    double rings;                                  // on which the operator is assembled
    double terms;                                  // rings with a random coefficient
    double directions, dimension, samples, solved; // solved: samples with a solution of their own, by direct solves
    double plates;                                 // samples with a plate of their own
    double steps;                                  // of time, in a dynamic study
    double threads;
    double tips, kept; // kept: samples of which the file has every energy
    bool has_forms;
} amounts;

static amounts count_all(const pdmc_problem *problem, int threads)
{
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    amounts a = {.threads = threads, .rings = problem->solver.radial_points, .samples = problem->sampling.samples};
    a.fine = count(problem, problem->solver.spacing);
    a.coarse = count(problem, 1.25 * problem->solver.spacing);
    a.steps = problem->kind == PDMC_DYNAMIC ? pdmc_problem_steps(problem) : 0.0;
    a.bonds = PDMC_CROSSING_BONDS * (problem->energy.line == PDMC_LINE_SEGMENT ? PDMC_LINE_POINTS : 1);
    a.terms = noise ? a.rings : 0.0;
    a.tips = problem->energy.tip_count;
    a.kept = problem->kind == PDMC_STATIC ? pdmc_problem_kept(problem) : 0.0;
    a.has_forms = problem->energy.bonds == PDMC_BONDS_ALL && problem->sampling.inverse != PDMC_INVERSE_DIRECT;
    a.directions = problem->energy.tip_count * (double)problem->energy.angles;
    a.dimension = noise ? response_size : 2.0;
    a.plates = pdmc_problem_moves_cracks(problem) ? a.samples : 0.0;
    a.solved = noise && problem->sampling.inverse == PDMC_INVERSE_DIRECT ? a.samples : 0.0;
    return a;
}

// QR of the mean system, on one thread, after its assembly on all.
static double seconds_to_solve(const amounts *a, const sizes *s)
{
    const double values = a->rings * s->interior * s->unknowns, n = s->unknowns;
    return seconds_per_row_value * values / a->threads + seconds_per_flop * n * n * (4.0 * s->rows - 4.0 / 3.0 * n);
}

// Operators of the random terms, and the rows of the energies.
static double seconds_to_model(const amounts *a)
{
    const double n = a->fine.unknowns;
    const double whitened = a->solved > 0.0 ? seconds_per_flop * a->terms * a->fine.interior * n * n / a->threads : 0.0;
    return whitened + seconds_per_word_value * a->terms * n * a->fine.rows +
           seconds_per_bond_value * a->directions * a->bonds * n / a->threads;
}

static double seconds_of_energies(const amounts *a)
{
    return a->directions * a->bonds * (seconds_per_bond + a->dimension * seconds_per_bond_direction);
}

// Where all bonds count and samples are not solved by themselves, by quadratic forms.
static double seconds_of_a_sample(const amounts *a)
{
    const double counted = PDMC_MEASURES * a->directions * (a->kept < a->samples ? seconds_per_tallied_value : 0.0);
    const double energies = a->has_forms ? a->directions * seconds_per_form : seconds_of_energies(a);
    return seconds_per_draw + energies + counted;
}

// Each on one thread, and in a block of its own.
static double seconds_for_plates(const amounts *a)
{
    amounts alone = *a;
    alone.threads = 1.0;
    const double each = seconds_to_solve(&alone, &alone.fine) + seconds_to_model(&alone);
    return a->plates * (each + PDMC_BLOCK * seconds_of_energies(a)) / a->threads;
}

// Blocks are shared out whole.
static double seconds_to_sample(const amounts *a)
{
    const double n = a->fine.unknowns;
    const double solve = a->solved > 0.0 ? seconds_per_flop * n * n * (2.0 * a->fine.rows - 2.0 / 3.0 * n) : 0.0;
    const double blocks = ceil(a->samples / PDMC_BLOCK), rounds = ceil(blocks / a->threads);
    return fmin(rounds * PDMC_BLOCK, a->samples) * (solve + seconds_of_a_sample(a));
}

// Three rows of the strain and two of the displacement at each point, whitened and squared; then steps on one thread.
static double seconds_to_move(const amounts *a)
{
    const double n = a->fine.unknowns, rows = 5.0 * area_points * a->fine.nodes;
    if (a->steps == 0.0) return 0.0;
    return seconds_per_flop * 3.0 * rows * n * n / a->threads + seconds_per_step_value * a->steps * n * n;
}

static double seconds_to_summarise(const amounts *a)
{
    const double sorted = a->kept < a->samples ? 0.0 : a->samples * log2(1.0 + a->samples);
    return PDMC_MEASURES * a->directions * (seconds_per_distribution + seconds_per_sorted_value * sorted) / a->threads;
}

static double bytes_of_results(const amounts *a, double bins, double probes)
{
    const double scalars = 5.0 + 7.0 * a->tips;
    return 8.0 * a->steps * (6.0 + 2.0 * probes) +
           8.0 * (a->samples * scalars + a->kept * (PDMC_MEASURES * a->directions + bins));
}

static double seconds_in_all(const amounts *a, double file)
{
    const double errors = a->directions > 0.0 ? seconds_to_solve(a, &a->coarse) : 0.0;
    return seconds_to_solve(a, &a->fine) + errors + seconds_to_model(a) + seconds_to_sample(a) + seconds_for_plates(a) +
           seconds_to_move(a) + seconds_to_summarise(a) + seconds_per_byte * file;
}

// Rings, Q and R.
static double numbers_kept(const amounts *a, const sizes *s)
{
    return s->unknowns * (a->rings * s->interior + s->rows + s->unknowns);
}

// The largest of these moments: both solutions at once, the samples or the time steps, and the result file, which is
// made in memory when everything else has gone.
static double bytes_at_most(const amounts *a, double file)
{
    const double n = a->fine.unknowns;
    const double coarse = a->directions > 0.0 ? numbers_kept(a, &a->coarse) + a->coarse.rows * a->coarse.unknowns : 0.0;
    const double direct = a->solved > 0.0 ? n * (a->terms * a->fine.interior + a->threads * a->fine.rows) : 0.0;
    const double crossings = a->directions * a->bonds * a->dimension + a->threads * a->bonds * n;
    const double solving = 8.0 * fmax(coarse, n * a->fine.rows), sampling = 8.0 * (direct + crossings) + file;
    const double plates = a->plates > 0.0 ? a->threads * 8.0 * (numbers_kept(a, &a->fine) + n * a->fine.rows) : 0.0;
    const double moving = a->steps > 0.0 ? 8.0 * 3.0 * n * n + file : 0.0; // mass, stiffness, and the factor of a step
    return bytes_of_program +
           fmax(2.0 * file, 8.0 * numbers_kept(a, &a->fine) + fmax(moving, fmax(solving, sampling + plates)));
}

pdmc_cost pdmc_collocation_cost(const pdmc_problem *problem, int threads)
{
    const amounts a = count_all(problem, threads);
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    const double file = bytes_of_results(&a, noise ? noise->bins : 0.0, problem->probe_count);
    return (pdmc_cost){
        .nodes = (int)a.fine.nodes,
        .unknowns = (int)a.fine.unknowns,
        .rows = (int)a.fine.rows,
        .bytes = bytes_at_most(&a, file),
        .seconds = seconds_in_all(&a, file),
    };
}
