// SPDX-License-Identifier: GPL-3.0-or-later

/// Loads that vary side by side, by the collocation and by bonds: samples against plates that are solved for one load each.

#include "kansa/stiffness_form.h"
#include "pdmc/discretisation.h"
#include "run/family.h"
#include "support/drawn_block.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

typedef struct {
    pdmc_problem problem;
    pdmc_crack crack;
    pdmc_load loads[2];
    pdmc_support support;
    pdmc_uncertainty uncertainties[4];
    int tip;
} plate;

// 4 x 4 with an inclined crack, held at the bottom, so that it takes what is loaded at the other sides.
static void plate_make(plate *p, pdmc_method method)
{
    *p = (plate){.crack = {"a", {-0.5, -0.3}, {0.5, 0.3}},
                 .loads = {{PDMC_SIDE_TOP, {0.2, 1.0}}, {PDMC_SIDE_RIGHT, {0.5, 0.1}}},
                 .support = {PDMC_SIDE_BOTTOM, {true, true}, {0.0, 0.0}},
                 .tip = 1};
    p->problem =
        (pdmc_problem){.plate = {4.0, 4.0, 1.0},
                       .material = {1.0, PDMC_PLANE_STRESS, 1.0},
                       .crack_count = 1,
                       .cracks = &p->crack,
                       .load_count = 2,
                       .loads = p->loads,
                       .support_count = 1,
                       .supports = &p->support,
                       .uncertainties = p->uncertainties,
                       .solver = {.method = method, .spacing = 0.4, .horizon = 0.1},
                       .sampling = {.seed = 5, .samples = B, .order = 4},
                       .energy = {.tip_count = 1, .tips = &p->tip, .angles = 4, .extension = 0.025, .horizon = 0.1}};
    pdmc_solver_options *solver = &p->problem.solver;
    if (method == PDMC_METHOD_KANSA) {
        solver->shape = 2.4;
        solver->polynomial_degree = 3;
        solver->crack_orders = 6;
        solver->radial_points = 6;
    } else {
        solver->spacing = solver->load_layer = 0.1;
        solver->horizon = p->problem.energy.horizon = 0.3;
        solver->area = PDMC_AREA_CENTROID;
        p->problem.energy.extension = 0.2;
    }
}

static pdmc_uncertainty scalar(pdmc_quantity quantity, double location, double scale)
{
    return (pdmc_uncertainty){
        quantity,
        .law = {.kind = PDMC_NORMAL, .location = location, .scale = scale, .least = -INFINITY, .most = INFINITY}};
}

static pdmc_uncertainty noise(pdmc_side side, pdmc_covariance_kind kind, double length, int modes)
{
    return (pdmc_uncertainty){(pdmc_quantity)((int)PDMC_QUANTITY_LOAD_NOISE_LEFT + (int)side), .variation = 0.3,
                              .covariance = {.kind = kind, .length = length}, .modes = modes};
}

typedef struct {
    pdmc_discretisation plate;
    pdmc_affine model;
} solved;

static void open_model(const pdmc_problem *problem, solved *s)
{
    CHECK_OK(pdmc_discretise(problem, 1, &s->plate));
    CHECK_OK(s->plate.verbs->affine(s->plate.method, &s->model));
}

static void close_model(solved *s)
{
    pdmc_affine_clear(&s->model);
    pdmc_discretisation_clear(&s->plate);
}

static void intensities_of(const pdmc_affine *model, int l, double K[2])
{
    const int n = model->unknowns;
    for (int k = 0; k < 2; k++)
        K[k] = cblas_ddot(n, &model->stress_intensity[k * n], 1, pdmc_affine_solution(model, l), 1);
}

// K_I and K_II of a plate with this load alone.
static void solve_alone(const plate *p, pdmc_side side, double tx, double ty, double K[2])
{
    plate alone = *p;
    solved s;
    alone.loads[0] = (pdmc_load){side, {tx, ty}};
    alone.problem.loads = alone.loads;
    alone.problem.load_count = 1;
    alone.problem.uncertainty_count = 0;
    open_model(&alone.problem, &s);
    intensities_of(&s.model, 1, K);
    close_model(&s);
}

static double drawn(const pdmc_block *block, int s, pdmc_quantity quantity)
{
    return block->drawn.draw[s].value[quantity - PDMC_FIRST_SCALAR];
}

static const pdmc_method methods[2] = {PDMC_METHOD_KANSA, PDMC_METHOD_BOND};

// Rounding times the condition of the least squares, 1e11, of which half the digits are lost, and of the bonds' matrix, 1e4.
static const double rounding[2] = {1e-7, 1e-10};

// The answer to f times a turned load is f times those to its components.
static void samples_are_superpositions(void **state)
{
    (void)state;
    for (int m = 0; m < 2; m++) {
        plate p;
        solved s;
        drawn_block samples;
        double top_x[2], top_y[2], right[2], variance[2] = {0.0, 0.0};
        plate_make(&p, methods[m]);
        p.uncertainties[0] = scalar(PDMC_QUANTITY_LOAD, 1.1, 0.1);
        p.uncertainties[1] = scalar(PDMC_QUANTITY_LOAD_TOP, 1.0, 0.3);
        p.uncertainties[2] = scalar(PDMC_QUANTITY_LOAD_RIGHT, 0.9, 0.4);
        p.uncertainties[3] = scalar(PDMC_QUANTITY_LOAD_DIRECTION_TOP, 5.0, 20.0);
        p.problem.uncertainty_count = 4;
        solve_alone(&p, PDMC_SIDE_TOP, 1.0, 0.0, top_x);
        solve_alone(&p, PDMC_SIDE_TOP, 0.0, 1.0, top_y);
        solve_alone(&p, PDMC_SIDE_RIGHT, 0.5, 0.1, right);
        open_model(&p.problem, &s);
        assert_int_equal(s.model.cases, 5); // held, given, the right side, the top, the top turned
        pdmc_block *block = drawn_block_begin(&samples, &p.problem, &s.model, B);
        CHECK_OK(pdmc_block_solve(block, B));
        pdmc_block_energies(block, PDMC_BONDS_ALL);
        for (int c = 0; c < B; c++) {
            const double load = drawn(block, c, PDMC_QUANTITY_LOAD), f = drawn(block, c, PDMC_QUANTITY_LOAD_TOP);
            const double theta = M_PI / 180.0 * drawn(block, c, PDMC_QUANTITY_LOAD_DIRECTION_TOP);
            const double tx = 0.2 * cos(theta) - sin(theta), ty = 0.2 * sin(theta) + cos(theta);
            for (int k = 0; k < 2; k++) {
                const double other = drawn(block, c, PDMC_QUANTITY_LOAD_RIGHT) * right[k];
                const double K = load * (f * (tx * top_x[k] + ty * top_y[k]) + other);
                CHECK_NEAR(block->intensity[k * B + c], K, rounding[m] * top_y[0]);
                variance[k] += K * K / B;
            }
        }
        assert_true(variance[0] > 0.0 && variance[1] > 0.0);
        drawn_block_end(&samples);
        close_model(&s);
    }
}

// The variance of K under noise is the double integral of the covariance and the influence of the traction on K, both
// here found without modes: for bonds from the answers of the single nodes' rows, which the symmetric matrix gives.
static void noise_has_the_variance_of_the_double_integral(void **state)
{
    (void)state;
    plate p;
    solved s;
    double sum = 0.0, integral = 0.0;
    plate_make(&p, PDMC_METHOD_BOND);
    p.uncertainties[0] = noise(PDMC_SIDE_TOP, PDMC_COVARIANCE_GAUSSIAN, 0.8, 25);
    p.problem.uncertainty_count = 1;
    open_model(&p.problem, &s);
    const pdmc_affine *model = &s.model;
    const int n = model->unknowns, columns = 40, first = n - 2 * columns;
    assert_int_equal(model->cases, 2 + 25);
    for (int l = 2; l < model->cases; l++) {
        double K[2];
        intensities_of(model, l, K);
        sum += K[0] * K[0];
    }
    double *row = pdmc_calloc((size_t)n, sizeof *row), *adjoint = pdmc_calloc((size_t)n, sizeof *row);
    memcpy(row, model->stress_intensity, (size_t)n * sizeof *row);
    CHECK_OK(model->verbs->precondition(model, 1, row, adjoint));
    const double spacing = p.problem.solver.spacing, length = p.uncertainties[0].covariance.length;
    for (int i = 0; i < columns; i++)
        for (int j = 0; j < columns; j++) {
            const double *a = &adjoint[first + 2 * i], *b = &adjoint[first + 2 * j];
            const double covariance = gsl_pow_2(0.3) * exp(-gsl_pow_2(spacing * (i - j) / length));
            integral += covariance * gsl_pow_2(spacing) * (0.2 * a[0] + a[1]) * (0.2 * b[0] + b[1]);
        }
    CHECK_NEAR(sum / integral, 1.0, 1e-6); // of the modes that are left out, and of the tail of the others
    assert_true(integral > 0.0);
    pdmc_free(row);
    pdmc_free(adjoint);
    close_model(&s);
}

// ... and sampling finds it: of N normal samples the variance has the standard error sqrt(2 / N). The side's factor is of its
// noise as well.
static void sampled_noise_has_the_variance_of_its_modes(void **state)
{
    (void)state;
    enum { BLOCKS = 32 };
    plate p;
    solved s;
    drawn_block samples;
    const double factor = 2.0;
    double sum = 0.0, given[2], top[2], squares = 0.0;
    plate_make(&p, PDMC_METHOD_KANSA);
    p.uncertainties[0] = noise(PDMC_SIDE_TOP, PDMC_COVARIANCE_EXPONENTIAL, 2.0, 10);
    p.uncertainties[1] = scalar(PDMC_QUANTITY_LOAD_TOP, factor, 0.0);
    p.problem.uncertainty_count = 2;
    open_model(&p.problem, &s);
    intensities_of(&s.model, 1, given);
    intensities_of(&s.model, 2, top);
    const double mean = given[0] + (factor - 1.0) * top[0];
    for (int l = 3; l < s.model.cases; l++) {
        double K[2];
        intensities_of(&s.model, l, K);
        sum += gsl_pow_2(factor * K[0]);
    }
    pdmc_block *block = drawn_block_begin(&samples, &p.problem, &s.model, B);
    for (int b = 0; b < BLOCKS; b++) {
        CHECK_OK(pdmc_block_draw(block, b * B, B));
        CHECK_OK(pdmc_block_solve(block, B));
        pdmc_block_energies(block, PDMC_BONDS_ALL);
        for (int c = 0; c < B; c++) squares += gsl_pow_2(block->intensity[c] - mean) / (BLOCKS * B);
    }
    CHECK_NEAR(squares / sum, 1.0, 4.0 * sqrt(2.0 / (BLOCKS * B)));
    drawn_block_end(&samples);
    close_model(&s);
}

// Correlation over far more than the side: the first mode is a factor on its load, the others are next to nothing.
static void long_noise_is_a_factor_of_its_side(void **state)
{
    (void)state;
    for (int m = 0; m < 2; m++) {
        plate p;
        solved s;
        double top[2], K[2];
        plate_make(&p, methods[m]);
        p.uncertainties[0] = noise(PDMC_SIDE_TOP, PDMC_COVARIANCE_GAUSSIAN, 1e4, 2);
        p.problem.uncertainty_count = 1;
        solve_alone(&p, PDMC_SIDE_TOP, 0.2, 1.0, top);
        open_model(&p.problem, &s);
        intensities_of(&s.model, 2, K);
        // 1 - C is 1.6e-7 at the side's length
        for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], 0.3 * top[k], fmax(1e-6, rounding[m]) * fabs(top[0]));
        intensities_of(&s.model, 3, K);
        for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], 0.0, 1e-3 * fabs(top[0]));
        close_model(&s);
    }
}

// With c(r) random, too: a sample that expands, or iterates, against its own factorisation, with all its loads.
static void every_inverse_has_all_loads(void **state)
{
    (void)state;
    for (int m = 0; m < 2; m++) {
        plate p;
        solved s;
        drawn_block samples;
        double direct[2 * B];
        plate_make(&p, methods[m]);
        p.uncertainties[0] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = 10, .variation = 0.1};
        p.uncertainties[1] = scalar(PDMC_QUANTITY_LOAD_DIRECTION_RIGHT, 0.0, 30.0);
        p.uncertainties[2] = noise(PDMC_SIDE_TOP, PDMC_COVARIANCE_GAUSSIAN, 1.0, 3);
        p.problem.uncertainty_count = 3;
        p.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
        p.problem.sampling.tolerance = 1e-10;
        p.problem.sampling.order = 8;
        open_model(&p.problem, &s);
        pdmc_block *block = drawn_block_begin(&samples, &p.problem, &s.model, B);
        const pdmc_inverse inverses[3] = {PDMC_INVERSE_DIRECT, PDMC_INVERSE_NEUMANN, PDMC_INVERSE_KRYLOV};
        for (int i = 0; i < (methods[m] == PDMC_METHOD_BOND ? 3 : 2); i++) {
            CHECK_OK(pdmc_block_solve_by(block, inverses[i], 4));
            pdmc_block_energies(block, PDMC_BONDS_ALL);
            // order 8 of an expansion that contracts by a tenth; the least squares leave 1e-5 between the two (README)
            for (int k = 0; k < 2; k++)
                for (int c = 0; c < 4; c++)
                    if (i == 0) direct[k * B + c] = block->intensity[k * B + c];
                    else CHECK_NEAR(block->intensity[k * B + c], direct[k * B + c], 1e-4 * fabs(direct[c]));
        }
        drawn_block_end(&samples);
        close_model(&s);
    }
}

// The crack models of the collocation that are slower, at their coarsest.
static void choose_crack_model(plate *p, pdmc_crack_model crack_model)
{
    pdmc_solver_options *solver = &p->problem.solver;
    solver->crack_model = crack_model;
    solver->refinement = 2;
    solver->edge_layer = 0.1;
    if (crack_model == PDMC_CRACKS_VISIBLE) solver->horizon = p->problem.energy.horizon = 0.28;
    if (crack_model == PDMC_CRACKS_PAPER) solver->horizon = 0.5, solver->shape = 0.1;
}

static void add_two(plate *p)
{
    p->uncertainties[0] = scalar(PDMC_QUANTITY_LOAD_DIRECTION_TOP, 0.0, 10.0);
    p->uncertainties[1] = noise(PDMC_SIDE_RIGHT, PDMC_COVARIANCE_GAUSSIAN, 1e4, 1);
    p->problem.uncertainty_count = 2;
}

// Their cases one by one: what the answer to a turned load is, and to noise that is long.
static void every_crack_model_has_the_cases(void **state)
{
    (void)state;
    for (int which = PDMC_CRACKS_PAPER; which <= PDMC_CRACKS_VISIBLE; which++) {
        plate p;
        solved s;
        double turned[2], given[2], top[2], K[2];
        plate_make(&p, PDMC_METHOD_KANSA);
        choose_crack_model(&p, (pdmc_crack_model)which);
        solve_alone(&p, PDMC_SIDE_TOP, -1.0, 0.2, turned);
        add_two(&p);
        open_model(&p.problem, &s);
        assert_int_equal(s.model.cases, 5); // held, given, noise on the right side, the top, the top turned
        intensities_of(&s.model, 4, K);
        for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], turned[k], 1e-6 * fabs(turned[0]));
        intensities_of(&s.model, 1, given);
        intensities_of(&s.model, 3, top);
        intensities_of(&s.model, 2, K);
        for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], 0.3 * (given[k] - top[k]), 1e-6 * fabs(turned[0]));
        close_model(&s);
    }
}

// K of a case in the weak form, where K_0 is the identity.
static void weak_intensities(const pdmc_problem *problem, int index, double K[2])
{
    pdmc_kansa *kansa = NULL;
    pdmc_kansa_form *form = NULL;
    CHECK_OK(pdmc_kansa_create(problem, NULL, 1, &kansa));
    CHECK_OK(pdmc_kansa_form_create(kansa, &form));
    const int n = form->unknowns;
    for (int k = 0; k < 2; k++)
        K[k] = cblas_ddot(n, &form->intensity[k * n], 1, &form->load[(size_t)index * (size_t)n], 1);
    pdmc_kansa_form_destroy(&form);
    pdmc_kansa_destroy(&kansa);
}

static void the_weak_form_has_the_cases(void **state)
{
    (void)state;
    plate p, alone;
    double want[2], K[2];
    plate_make(&alone, PDMC_METHOD_KANSA);
    alone.loads[0] = (pdmc_load){PDMC_SIDE_TOP, {-1.0, 0.2}};
    alone.problem.load_count = 1;
    weak_intensities(&alone.problem, 0, want);
    plate_make(&p, PDMC_METHOD_KANSA);
    add_two(&p);
    weak_intensities(&p.problem, 3, K);
    for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], want[k], 1e-6 * fabs(want[0]));
    alone.loads[0] = p.loads[1];
    weak_intensities(&alone.problem, 0, want);
    weak_intensities(&p.problem, 1, K);
    for (int k = 0; k < 2; k++) CHECK_NEAR(K[k], 0.3 * want[k], 1e-6 * fabs(want[0]));
}

// K of a block of samples with factor, direction and noise.
static void solve_block(const pdmc_problem *problem, const pdmc_affine_family *family, int threads, int count,
                        double K[2 * B])
{
    solved s;
    drawn_block samples;
    CHECK_OK(pdmc_discretise(problem, threads, &s.plate));
    CHECK_OK(s.plate.verbs->affine(s.plate.method, &s.model));
    s.model.family = family;
    pdmc_block *block = drawn_block_begin(&samples, problem, &s.model, count);
    CHECK_OK(pdmc_block_solve(block, count));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int c = 0; c < count; c++) assert_int_equal(block->failure[c], PDMC_SAMPLE_OK);
    memcpy(K, block->intensity, 2 * B * sizeof *K);
    drawn_block_end(&samples);
    close_model(&s);
}

static void make_varied(plate *p, pdmc_method method)
{
    plate_make(p, method);
    p->uncertainties[0] = scalar(PDMC_QUANTITY_LOAD_TOP, 1.0, 0.2);
    p->uncertainties[1] = scalar(PDMC_QUANTITY_LOAD_DIRECTION_RIGHT, 0.0, 20.0);
    p->uncertainties[2] = noise(PDMC_SIDE_TOP, PDMC_COVARIANCE_EXPONENTIAL, 1.0, 6);
    p->problem.uncertainty_count = 3;
}

static void threads_change_no_bit(void **state)
{
    (void)state;
    for (int m = 0; m < 2; m++) {
        plate p;
        double one[2 * B], three[2 * B];
        make_varied(&p, methods[m]);
        solve_block(&p.problem, NULL, 1, B, one);
        solve_block(&p.problem, NULL, 3, B, three);
        assert_memory_equal(one, three, sizeof one);
    }
}

// A crack that moves by nothing gives every sample a plate of its own, with the same loads.
static void plates_of_their_own_have_all_loads(void **state)
{
    (void)state;
    enum { COUNT = 3 };
    plate p;
    double fixed[2 * B], own[2 * B];
    make_varied(&p, PDMC_METHOD_KANSA);
    solve_block(&p.problem, NULL, 1, COUNT, fixed);
    p.uncertainties[3] = scalar(PDMC_QUANTITY_CRACK_X, 0.0, 0.0);
    p.problem.uncertainty_count = 4;
    const pdmc_affine_family family = pdmc_plate_family(&p.problem, 1);
    solve_block(&p.problem, &family, 1, COUNT, own);
    for (int k = 0; k < 2; k++)
        for (int c = 0; c < COUNT; c++) CHECK_NEAR(own[k * B + c], fixed[k * B + c], rounding[0] * fixed[c]);
}

// A reduced model of bonds under loads that combine five cases, of which one is the sum of two others: within its bounds
// of samples that are solved directly, and the bounds as small as was asked for.
static void the_reduced_model_has_all_loads(void **state)
{
    (void)state;
    enum { DIRECT = 8 };
    plate p;
    solved s;
    drawn_block samples;
    pdmc_affine reduced;
    pdmc_block *small = NULL;
    double K[2 * B], worst = 0.0, largest = 0.0;
    plate_make(&p, PDMC_METHOD_BOND);
    p.uncertainties[0] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = 10, .variation = 0.1};
    p.uncertainties[1] = scalar(PDMC_QUANTITY_LOAD_TOP, 1.0, 0.3);
    p.uncertainties[2] = scalar(PDMC_QUANTITY_LOAD_RIGHT, 1.0, 0.5);
    p.uncertainties[3] = noise(PDMC_SIDE_TOP, PDMC_COVARIANCE_EXPONENTIAL, 1.0, 3);
    p.problem.uncertainty_count = 4;
    open_model(&p.problem, &s);
    pdmc_block *block = drawn_block_begin(&samples, &p.problem, &s.model, B);
    CHECK_OK(pdmc_block_solve_by(block, PDMC_INVERSE_DIRECT, DIRECT));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    memcpy(K, block->intensity, sizeof K);
    const double tolerance = 2e-3;
    const pdmc_reduced_goal goal = {.error = tolerance, .intensity = &tolerance};
    CHECK_OK(pdmc_reduced_create(&samples.variables, &goal, 1, &reduced));
    CHECK_OK(pdmc_block_create(&samples.variables, &reduced, &small));
    CHECK_OK(pdmc_block_draw(small, 0, B));
    CHECK_OK(pdmc_block_solve_by(small, PDMC_INVERSE_REDUCED, B));
    pdmc_block_energies(small, PDMC_BONDS_ALL);
    for (int c = 0; c < DIRECT; c++)
        for (int k = 0; k < 2; k++) {
            const double error = fabs(small->intensity[k * B + c] - K[k * B + c]);
            assert_true(error <= small->bound.intensity[2 * c + k]);
            worst = fmax(worst, error);
            largest = fmax(largest, small->bound.intensity[2 * c + k]);
        }
    print_message("  %d of %d unknowns, errors of K up to %.1e, bounds up to %.1e\n", reduced.unknowns,
                  s.model.unknowns, worst, largest);
    assert_true(largest < 2.0 * tolerance); // training samples meet the tolerance, others may be somewhat worse
    pdmc_block_destroy(&small);
    pdmc_affine_clear(&reduced);
    drawn_block_end(&samples);
    close_model(&s);
}

static void what_would_not_balance_is_refused(void **state)
{
    (void)state;
    static const struct {
        pdmc_quantity quantity;
        bool holds_x, holds_y, is_refused;
    } cases[] = {
        {PDMC_QUANTITY_LOAD_TOP, false, false, true}, // the plate is free
        {PDMC_QUANTITY_LOAD_TOP, false, true, false}, // the bottom takes the force, the plate slides in x alone
        {PDMC_QUANTITY_LOAD_DIRECTION_TOP, false, true, true}, // which a turned load would make it do
        {PDMC_QUANTITY_LOAD_DIRECTION_TOP, true, true, false}, //
        {PDMC_QUANTITY_LOAD_NOISE_TOP, false, true, false},    //
        {PDMC_QUANTITY_LOAD_NOISE_TOP, false, false, true},    //
        {PDMC_QUANTITY_LOAD_LEFT, true, true, true},           // which is not loaded
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        plate p;
        plate_make(&p, PDMC_METHOD_KANSA);
        p.loads[0] = (pdmc_load){PDMC_SIDE_TOP, {0.0, 1.0}};
        p.loads[1] = (pdmc_load){PDMC_SIDE_BOTTOM, {0.0, -1.0}};
        p.problem.load_count = cases[c].holds_y ? 1 : 2;
        p.support = (pdmc_support){PDMC_SIDE_BOTTOM, {cases[c].holds_x, cases[c].holds_y}, {0.0, 0.0}};
        p.problem.support_count = cases[c].holds_y;
        p.uncertainties[0] = (pdmc_uncertainty){.quantity = cases[c].quantity};
        p.problem.uncertainty_count = 1;
        CHECK_STATUS(pdmc_problem_check_equilibrium(&p.problem), cases[c].is_refused ? PDMC_ERR_CONFIG : PDMC_OK);
    }
}

// A plate that can only turn about its lower left corner, pulled through it: a factor on the load does no work, noise does.
static void noise_turns_what_its_mean_does_not(void **state)
{
    (void)state;
    plate p;
    pdmc_support supports[2] = {{PDMC_SIDE_BOTTOM, {true, false}, {0.0, 0.0}},
                                {PDMC_SIDE_LEFT, {false, true}, {0.0, 0.0}}};
    plate_make(&p, PDMC_METHOD_KANSA);
    p.loads[0] = (pdmc_load){PDMC_SIDE_RIGHT, {4.0, 2.0}};
    p.problem.load_count = 1;
    p.problem.supports = supports;
    p.problem.support_count = 2;
    CHECK_OK(pdmc_problem_check_random_load(&p.problem, PDMC_QUANTITY_LOAD_RIGHT));
    CHECK_STATUS(pdmc_problem_check_random_load(&p.problem, PDMC_QUANTITY_LOAD_NOISE_RIGHT), PDMC_ERR_CONFIG);
    CHECK_STATUS(pdmc_problem_check_random_load(&p.problem, PDMC_QUANTITY_LOAD_DIRECTION_RIGHT), PDMC_ERR_CONFIG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_are_superpositions),
        cmocka_unit_test(noise_has_the_variance_of_the_double_integral),
        cmocka_unit_test(sampled_noise_has_the_variance_of_its_modes),
        cmocka_unit_test(long_noise_is_a_factor_of_its_side),
        cmocka_unit_test(every_inverse_has_all_loads),
        cmocka_unit_test(every_crack_model_has_the_cases),
        cmocka_unit_test(the_weak_form_has_the_cases),
        cmocka_unit_test(the_reduced_model_has_all_loads),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(plates_of_their_own_have_all_loads),
        cmocka_unit_test(what_would_not_balance_is_refused),
        cmocka_unit_test(noise_turns_what_its_mean_does_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
