// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/cracked_plate.h"

#include "bond/bond.h"

#include <gsl/gsl_math.h>
#include <string.h>

static pdmc_plate_elements *solved(const pdmc_problem *problem, int threads)
{
    pdmc_plate_elements *plate;
    CHECK_OK(pdmc_plate_elements_create(problem, threads, &plate));
    return plate;
}

static double opening(const pdmc_plate_elements *plate, double x)
{
    const double at[2] = {x, 0.0}, left[2] = {x, 1e-3}, right[2] = {x, -1e-3};
    double u[2], v[2];
    pdmc_plate_displacement(plate, at, left, u);
    pdmc_plate_displacement(plate, at, right, v);
    return u[1] - v[1];
}

// On a grid of bonds with seven spacings a horizon, which opens two percent too far: 1.951, 1.932 with half the spacing.
static double opening_of_grid(pdmc_problem problem)
{
    pdmc_bond *bond;
    double u[2], v[2];
    problem.solver = (pdmc_solver_options){.method = PDMC_METHOD_BOND,
                                           .spacing = 0.03,
                                           .horizon = problem.solver.horizon,
                                           .area = PDMC_AREA_CENTROID,
                                           .load_layer = 0.09};
    CHECK_OK(pdmc_bond_create(&problem, 1, &bond));
    CHECK_OK(pdmc_bond_displacement(bond, (double[2]){0.0, 0.0}, (double[2]){0.0, 1e-3}, u));
    CHECK_OK(pdmc_bond_displacement(bond, (double[2]){0.0, 0.0}, (double[2]){0.0, -1e-3}, v));
    pdmc_bond_destroy(&bond);
    return u[1] - v[1];
}

// The horizon is two thirds of the half crack. Cells of 1/2, 1/4 and 1/6 of it, all even in number, so that the diagonals are
// mirror images: with the second order the steps are as 3/16 to 5/144, with the first one as 1/4 to 1/12.
static void the_opening_converges_with_the_elements(void **state)
{
    (void)state;
    double got[3];
    cracked c;
    for (int k = 0; k < 3; k++) {
        describe(1.2, 1.2, 0.3, 0.2, 0.3 / (2 * k + 2), &c);
        c.problem.solver.load_layer = 0.09;
        pdmc_plate_elements *plate = solved(&c.problem, 1);
        got[k] = opening(plate, 0.0);
        CHECK_NEAR(opening(plate, 0.1), opening(plate, -0.1), 1e-10);
        pdmc_plate_elements_destroy(&plate);
    }
    const double grid = opening_of_grid(c.problem), share = (got[2] - got[1]) / (got[1] - got[0]);
    print_message("opening %.5f, %.5f, %.5f: steps as 1 to %.2f; %.5f on a grid\n", got[0], got[1], got[2], share,
                  grid);
    assert_true(share > 0.05 && share < 1.0 / 3.0);
    CHECK_NEAR(got[2] / grid, 1.0, 0.03);
}

// Discontinuous elements have more functions of the same kind, and so a little more displacement for the same load.
static void more_functions_move_more(void **state)
{
    (void)state;
    double work[3];
    for (int space = PDMC_SPACE_CONTINUOUS; space <= PDMC_SPACE_MIXED; space++) {
        cracked c;
        describe(1.2, 1.2, 0.3, 0.3, 0.15, &c);
        c.problem.solver.space = (pdmc_space_kind)space;
        pdmc_plate_elements *plate = solved(&c.problem, 1);
        work[space] = 0.0;
        for (int k = 0; k < plate->unknowns; k++) work[space] += plate->load[k] * plate->mean[k];
        CHECK_NEAR(plate->residual, 0.0, 1e-11);
        pdmc_plate_elements_destroy(&plate);
    }
    print_message("work %.5f continuous, %.5f mixed, %.5f discontinuous\n", work[0], work[2], work[1]);
    assert_true(work[0] < work[2] && work[2] < work[1] && work[1] < 1.1 * work[0]);
}

// The force of a traction on a unit of thickness, and its moment about the middle of the layer.
static void loads_are_those_of_the_tractions(void **state)
{
    (void)state;
    cracked c;
    describe(1.3, 1.1, 0.3, 0.2, 0.1, &c);
    c.problem.solver.load_layer = 0.17; // through elements
    pdmc_plate_elements *plate = solved(&c.problem, 1);
    const double one[1] = {1.0};
    double force = 0.0, lever = 0.0, sideways = 0.0, *f = pdmc_calloc((size_t)plate->unknowns, sizeof *f);
    pdmc_plate_form_multiply(&plate->form, one, plate->mean, f); // with what holds rigid motions, where no load is kept
    for (int k = 0; k < plate->space.count; k++) {
        force += fabs(f[2 * k + 1]);
        lever += f[2 * k + 1] * plate->space.x[2 * k + 1];
        sideways += fabs(f[2 * k]);
    }
    CHECK_NEAR(force, 2.0 * 1.3, 1e-10); // the residual of all nodes
    CHECK_NEAR(lever, 2.0 * 1.3 * (0.55 - 0.085), 1e-11);
    CHECK_NEAR(sideways, 0.0, 1e-10);
    pdmc_free(f);
    pdmc_plate_elements_destroy(&plate);
}

// Held below and moved above: the middle moves by half, and sides that are free to do so come nearer to each other.
static void supports_hold_and_move(void **state)
{
    (void)state;
    cracked c;
    describe(1.0, 1.4, 0.2, 0.2, 0.1, &c);
    c.problem.crack_count = 0;
    c.problem.load_count = 0;
    c.problem.support_count = 2;
    c.supports[0] = (pdmc_support){PDMC_SIDE_BOTTOM, {true, true}, {0.0, 0.0}};
    c.supports[1] = (pdmc_support){PDMC_SIDE_TOP, {false, true}, {0.0, 0.01}};
    pdmc_plate_elements *plate = solved(&c.problem, 1);
    double u[2];
    const double places[3][2] = {{0.2, -0.75}, {0.2, 0.75}, {0.5, 0.0}};
    pdmc_plate_displacement(plate, places[0], places[0], u);
    assert_true(u[0] == 0.0 && u[1] == 0.0);
    pdmc_plate_displacement(plate, places[1], places[1], u);
    CHECK_NEAR(u[1], 0.01, 1e-16);
    pdmc_plate_displacement(plate, places[2], places[2], u);
    CHECK_NEAR(u[1], 0.005, 0.0005);
    assert_true(u[0] < 0.0);
    CHECK_NEAR(u[0], -0.5 * 0.01 / 1.4 / 3.0, 0.2 * 0.01 / 3.0 * 0.5 / 1.4 + 0.0003); // nu = 1/3, held below
    pdmc_plate_elements_destroy(&plate);
}

// Williams' field of a tip, put into the nodes: its factors come back, to the error of averaged gradients.
static void intensities_are_those_of_the_field(void **state)
{
    (void)state;
    cracked c;
    describe(1.8, 1.6, 0.5, 0.08, 0.05, &c);
    pdmc_plate_elements *plate = solved(&c.problem, 1);
    const size_t n = (size_t)plate->unknowns;
    double *row = pdmc_calloc(2 * n, sizeof *row);
    CHECK_OK(pdmc_plate_intensity_rows(plate, 1, row, &row[n]));
    for (int mode = 0; mode < 2; mode++) {
        double sum[2] = {0.0, 0.0};
        for (int k = 0; k < plate->mesh.element_count; k++) { // every value, from an element that has it
            const pdmc_mesh *mesh = &plate->mesh;
            double middle = 0.0;
            for (int a = 3 * k; a < 3 * k + 3; a++) middle += mesh->x[2 * mesh->corner[a] + 1] / 3.0;
            for (int a = 3 * k; a < 3 * k + 3; a++) {
                const double *x = &mesh->x[2 * mesh->corner[a]], dx = x[0] - 0.5, r = hypot(dx, x[1]);
                double theta = atan2(x[1], dx);
                if (dx < 0.0 && x[1] == 0.0) theta = middle > 0.0 ? M_PI : -M_PI;
                const double ch = cos(0.5 * theta), sh = sin(0.5 * theta), ct = cos(theta), mu = 0.375;
                const double scale = sqrt(r / (2.0 * M_PI)) / (2.0 * mu); // kappa = 2
                const double u[2] = {mode == 0 ? ch * (2.0 - ct) : sh * (4.0 + ct),
                                     mode == 0 ? sh * (2.0 - ct) : -ch * ct};
                for (int i = 0; i < 2; i++) plate->mean[2 * plate->space.value[a] + i] = scale * u[i];
            }
        }
        for (size_t k = 0; k < n; k++)
            for (size_t m = 0; m < 2; m++) sum[m] += row[m * n + k] * plate->mean[k];
        print_message("mode %d: K_I = %.5f, K_II = %.5f\n", mode + 1, sum[0], sum[1]);
        CHECK_NEAR(sum[mode], 1.0, 3e-3);
        CHECK_NEAR(sum[1 - mode], 0.0, 3e-3);
    }
    pdmc_free(row);
    pdmc_plate_elements_destroy(&plate);
}

// K(xi) x = F solved by itself, against the model: x + sum_m xi_m M_m x is the answer at the mean.
static void the_model_knows_every_answer(void **state)
{
    (void)state;
    cracked c;
    pdmc_affine model;
    describe(1.2, 1.2, 0.3, 0.3, 0.15, &c);
    c.problem.uncertainty_count = 1;
    pdmc_plate_elements *plate = solved(&c.problem, 1);
    CHECK_OK(pdmc_plate_affine(plate, &model));
    assert_int_equal(model.terms, 3);
    const int r = model.unknowns;
    const double scale[2] = {1.0, 1.0};
    double xi[PDMC_BLOCK * 3] = {0.3, -0.2, 0.25, 0.4, 0.4, 0.4};
    double *x = pdmc_calloc(PDMC_BLOCK * (size_t)r, sizeof *x), *y = pdmc_calloc(PDMC_BLOCK * (size_t)r, sizeof *y);
    for (int s = 0; s < 2; s++) CHECK_OK(model.verbs->solve(&model, &xi[3 * s], scale, &x[s * r]));
    CHECK_OK(model.verbs->perturb(&model, xi, x, y));
    const double *mean = pdmc_affine_solution(&model, 1);
    double size = 0.0;
    for (int k = 0; k < r; k++) size = fmax(size, fabs(mean[k]));
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < r; k++) CHECK_NEAR(x[s * r + k] + y[s * r + k], mean[k], 1e-5 * size);
    for (int k = 0; k < r; k++) CHECK_NEAR(1.4 * x[r + k], mean[k], 1e-11 * size); // all bins alike
    pdmc_free(x);
    pdmc_free(y);
    pdmc_affine_clear(&model);
    pdmc_plate_elements_destroy(&plate);
}

// More bins than planes: each plane has all of its bins, and the effective modulus stays.
static void bins_share_the_planes(void **state)
{
    (void)state;
    cracked c;
    pdmc_affine model;
    describe(1.0, 1.0, 0.25, 0.25, 0.25, &c);
    c.problem.uncertainty_count = 1;
    c.noise.bins = 37;
    c.problem.energy.tip_count = 0;
    pdmc_plate_elements *plate = solved(&c.problem, 1);
    CHECK_OK(pdmc_plate_affine(plate, &model));
    assert_int_equal(model.terms, PDMC_PLATE_PLANES);
    double modulus = 0.0;
    for (int m = 0; m < model.terms; m++) {
        double sum = 0.0;
        for (int b = 0; b < model.bins; b++) sum += model.term_weight[b * model.terms + m];
        CHECK_NEAR(sum, 1.0, 1e-13);
    }
    for (int b = 0; b < model.bins; b++) { // what a bin does to the planes is what it does to the modulus
        double sum = 0.0;
        for (int m = 0; m < model.terms; m++)
            sum += model.term_weight[b * model.terms + m] *
                   (gsl_pow_3((m + 1.0) / model.terms) - gsl_pow_3((double)m / model.terms));
        CHECK_NEAR(sum, model.modulus_weight[b], 1e-14);
        modulus += model.modulus_weight[b];
    }
    CHECK_NEAR(modulus, 1.0, 1e-13);
    pdmc_affine_clear(&model);
    pdmc_plate_elements_destroy(&plate);
}

static int triangles_at(const pdmc_mesh *mesh, const double x[2])
{
    int count = 0;
    for (int k = 0; k < 3 * mesh->element_count; k++) {
        const double *corner = &mesh->x[2 * mesh->corner[k]];
        count += hypot(corner[0] - x[0], corner[1] - x[1]) < 1e-9;
    }
    return count;
}

// One triangle in each of the four cells about a tip: with diagonals that meet there, two. In any number of cells, of a crack
// along x, along y, and from a side, and beyond sides that are held.
static void diagonals_do_not_meet_at_tips(void **state)
{
    (void)state;
    const double cracks[3][4] = {{-0.3, 0.0, 0.3, 0.0}, {0.1, -0.2, 0.1, 0.3}, {-0.7, 0.1, 0.2, 0.1}};
    for (int k = 0; k < 12; k++) {
        cracked c;
        pdmc_mesh mesh;
        describe(1.2, 1.2, 0.3, 0.3, 0.3 / (2 + k / 3), &c);
        memcpy(c.crack.from, cracks[k % 3], sizeof c.crack.from);
        memcpy(c.crack.to, cracks[k % 3] + 2, sizeof c.crack.to);
        if (k % 2) c.supports[c.problem.support_count++] = (pdmc_support){.side = PDMC_SIDE_LEFT, .held = {true, true}};
        CHECK_OK(pdmc_plate_mesh(&c.problem, &mesh));
        assert_int_equal(triangles_at(&mesh, c.crack.to), 4);
        if (k % 3 < 2) assert_int_equal(triangles_at(&mesh, c.crack.from), 4);
        pdmc_mesh_clear(&mesh);
    }
}

static pdmc_status make_all(const pdmc_problem *problem)
{
    pdmc_plate_elements *plate = NULL;
    pdmc_affine model;
    pdmc_status status = pdmc_plate_elements_create(problem, 1, &plate);
    if (status == PDMC_OK) status = pdmc_plate_affine(plate, &model);
    if (status == PDMC_OK) pdmc_affine_clear(&model);
    pdmc_plate_elements_destroy(&plate);
    return status;
}

static void memory_that_runs_out_is_said(void **state)
{
    (void)state;
    cracked c;
    describe(0.6, 0.6, 0.15, 0.15, 0.15, &c);
    c.problem.uncertainty_count = 1;
    CHECK_FAILS_CLEANLY(make_all(&c.problem), );
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_opening_converges_with_the_elements),
        cmocka_unit_test(more_functions_move_more),
        cmocka_unit_test(loads_are_those_of_the_tractions),
        cmocka_unit_test(supports_hold_and_move),
        cmocka_unit_test(intensities_are_those_of_the_field),
        cmocka_unit_test(the_model_knows_every_answer),
        cmocka_unit_test(bins_share_the_planes),
        cmocka_unit_test(diagonals_do_not_meet_at_tips),
        cmocka_unit_test(memory_that_runs_out_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
