// SPDX-License-Identifier: GPL-3.0-or-later

/// Stress intensity factors of a random field by the reduced model, against direct solutions.

#include "kansa/stiff_plate.h"
#include "stochastic/reduced.h"
#include "support/drawn_block.h"

#include <math.h>

enum { B = PDMC_BLOCK, TIPS = 2, ROWS = 2 * TIPS };

typedef struct {
    stiff_plate s;
    pdmc_field *field;
    pdmc_affine model;
    drawn_block drawn; // samples that no reduced model is made with
    const double *xi;
    double exact[B * ROWS]; // row . x
} random_plate;

static void random_plate_make(random_plate *p)
{
    const pdmc_covariance covariance = {PDMC_COVARIANCE_EXPONENTIAL, 1.0, 0.0};
    const pdmc_field_request request = {covariance, PDMC_NORMAL, 0.15, 20};
    const double scale[2] = {0.0, 1.0};
    p->field = NULL;
    stiff_plate_make(&p->s, 6, 0.3, 2);
    p->s.p.uncertainties[0] = (pdmc_uncertainty){
        .quantity = PDMC_QUANTITY_STIFFNESS, .variation = 0.15, .covariance = covariance, .modes = 20};
    CHECK_OK(pdmc_field_create(&request, 5.0, 5.0, TIPS, pdmc_kansa_field_sensitivity(p->s.form), 2, &p->field));
    CHECK_OK(pdmc_kansa_field_affine(p->s.form, p->field, &p->model));
    p->xi = drawn_block_begin(&p->drawn, &p->s.p.problem, &p->model, B)->drawn.xi;
    const int n = p->model.unknowns;
    double *x = new_values((size_t)n);
    for (int s = 0; s < B; s++) {
        CHECK_OK(p->model.verbs->solve(&p->model, &p->xi[s * p->model.terms], scale, x));
        for (int k = 0; k < ROWS; k++) p->exact[s * ROWS + k] = inner(n, &p->model.stress_intensity[k * n], x);
    }
    free(x);
}

static void random_plate_clear(random_plate *p)
{
    drawn_block_end(&p->drawn);
    pdmc_affine_clear(&p->model);
    pdmc_field_destroy(&p->field);
    stiff_plate_clear(&p->s);
}

// Two bounds of norms, each too large by some 2 for its probes, and the angle of Cauchy and Schwarz between two errors that
// have little to do with each other: the root mean square over the samples is some 40 times the error. By the
// norms of the rows instead of the second error it would be in the thousands.
static void intensities_are_bounded(void **state)
{
    (void)state;
    const double tolerances[2] = {1e-1, 1e-2};
    random_plate p;
    random_plate_make(&p);
    int unknowns = 0;
    for (int i = 0; i < 2; i++) {
        const double intensity[TIPS] = {tolerances[i], tolerances[i]};
        const pdmc_reduced_goal goal = {.intensity = intensity};
        pdmc_affine reduced;
        pdmc_reduced_bound bound = {.intensity = new_values(B * ROWS)};
        double errors = 0.0, bounds = 0.0, norms = 0.0, worst = 0.0;
        CHECK_OK(pdmc_reduced_create(&p.drawn.variables, &goal, 2, &reduced));
        const int r = reduced.unknowns;
        double *y = new_values((size_t)(B * r));
        CHECK_OK(pdmc_reduced_solve(&reduced, p.xi, NULL, y, &bound));
        for (int k = 0; k < B * ROWS; k++) {
            const int s = k / ROWS;
            const double error = fabs(p.exact[k] - inner(r, &reduced.stress_intensity[k % ROWS * r], &y[s * r]));
            if (!isfinite(bound.error[s])) continue;
            assert_true(error <= bound.intensity[k]);
            errors += error * error;
            bounds += bound.intensity[k] * bound.intensity[k];
            norms += pow(reduced.intensity_bound[k % ROWS] * bound.error[s], 2) / bound.coercivity[s];
            worst = fmax(worst, bound.intensity[k]);
        }
        printf("  tolerance %g: %d of %d unknowns, largest bound %.1e; bound %.1f times the error, by norms of rows "
               "%.1f\n",
               tolerances[i], r, p.model.unknowns, worst, sqrt(bounds / errors), sqrt(norms / errors));
        assert_true(r > unknowns && r < p.model.unknowns);
        assert_true(worst < 3.0 * tolerances[i]);
        assert_true(bounds < 150.0 * 150.0 * errors);
        assert_true(bounds < 0.1 * 0.1 * norms);
        unknowns = r;
        free(y);
        free(bound.intensity);
        pdmc_affine_clear(&reduced);
    }
    random_plate_clear(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intensities_are_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
