// SPDX-License-Identifier: GPL-3.0-or-later

/// Bond energies by quadratic forms against the sum over bonds.

#include "kansa/plate.h"
#include "stochastic/forms.h"
#include "support/drawn_block.h"

#include <stdlib.h>
#include <string.h>

enum { B = PDMC_BLOCK, WIDTH = 5, RINGS = 3, DIRECTIONS = 4, BONDS = 30, PILOTS = 20 };

/// Rows of random numbers; the last direction has no bonds, as one back along a crack.
typedef struct {
    pdmc_affine model;
    pdmc_crossing crossing[DIRECTIONS];
    double row[DIRECTIONS][BONDS * WIDTH], ring_weight[RINGS];
    int ring[BONDS], column[1];
    double y[B * WIDTH];
    pdmc_draw draw[B];
    double numbers[B][RINGS + DIRECTIONS];
} made_up_rows;

static double random_number(void)
{
    return 2.0 * rand() / RAND_MAX - 1.0;
}

// Coordinates of these sizes, as those of a response space decrease.
static const double size[WIDTH] = {1.0, 1e-2, 1e-5, 1e-9, 1e-11};

static void make_rows(made_up_rows *m)
{
    srand(3);
    *m = (made_up_rows){0};
    m->model = (pdmc_affine){.unknowns = WIDTH,
                             .bins = 1,
                             .tips = 1,
                             .angles = DIRECTIONS,
                             .micromodulus = 3.0,
                             .rings = RINGS,
                             .ring_weight = m->ring_weight,
                             .crossings = m->crossing};
    for (int q = 0; q < RINGS; q++) m->ring_weight[q] = 0.5 + q;
    for (int b = 0; b < BONDS; b++) m->ring[b] = (b / 4) % RINGS; // rings come back
    for (int d = 0; d < DIRECTIONS; d++) {
        m->crossing[d] = (pdmc_crossing){.bonds = d < DIRECTIONS - 1 ? BONDS : 0, .row = m->row[d], .ring = m->ring};
        for (int k = 0; k < BONDS * WIDTH; k++) m->row[d][k] = random_number();
    }
    for (int s = 0; s < B; s++) {
        m->y[s * WIDTH] = 1.0 + 0.2 * random_number();
        for (int i = 1; i < WIDTH; i++) m->y[s * WIDTH + i] = size[i] * random_number();
        m->draw[s].ring_weight = m->numbers[s];
        m->draw[s].direction_modulus = &m->numbers[s][RINGS];
        for (int k = 0; k < RINGS + DIRECTIONS; k++) m->numbers[s][k] = 1.0 + 0.2 * random_number();
    }
}

static double by_bonds(const made_up_rows *m, int d, int s)
{
    double energy = 0.0;
    for (int b = 0; b < m->crossing[d].bonds; b++) {
        double stretch = 0.0;
        for (int i = 0; i < WIDTH; i++) stretch += m->row[d][b * WIDTH + i] * m->y[s * WIDTH + i];
        energy += m->draw[s].ring_weight[m->ring[b]] * stretch * stretch;
    }
    return 0.5 * m->model.micromodulus * m->draw[s].direction_modulus[d] * energy;
}

static void forms_are_the_sum_over_bonds(void **state)
{
    (void)state;
    made_up_rows m;
    pdmc_energy_forms *forms = NULL;
    double energy[DIRECTIONS * B];
    make_rows(&m);
    CHECK_OK(pdmc_energy_forms_create(&m.model, PILOTS, m.y, &forms));
    assert_non_null(forms);
    double *scratch = calloc(pdmc_energy_forms_scratch(forms), sizeof *scratch);
    pdmc_energy_forms_evaluate(forms, m.draw, m.y, scratch, energy);
    for (int s = 0; s < B; s++) {
        assert_true(pdmc_energy_forms_hold(forms, &m.y[s * WIDTH]));
        for (int d = 0; d < DIRECTIONS; d++) {
            const double exact = by_bonds(&m, d, s);
            CHECK_NEAR(energy[d * B + s], exact,
                       3e-14 * exact); // 1e-14 is left out; 45 products and their sums are rounded
        }
    }
    free(scratch);
    pdmc_energy_forms_destroy(&forms);
}

// Of 15 pairs those of a small and a small coordinate are without effect: 1e-5 times 1e-9 still matters by its bound, with four
// times either, 1e-5 times 1e-11 does not.
static void pairs_that_do_not_matter_are_left_out(void **state)
{
    (void)state;
    made_up_rows m;
    pdmc_energy_forms *forms = NULL;
    bool found[WIDTH][WIDTH] = {{false}};
    make_rows(&m);
    CHECK_OK(pdmc_energy_forms_create(&m.model, PILOTS, m.y, &forms));
    for (int p = 0; p < forms->pairs; p++) found[forms->first[p]][forms->second[p]] = true;
    for (int i = 0; i < WIDTH; i++)
        for (int j = i; j < WIDTH; j++) {
            if (size[i] * size[j] > 1e-13) assert_true(found[i][j]);
            if (size[i] * size[j] < 1e-17) assert_false(found[i][j]);
        }
    pdmc_energy_forms_destroy(&forms);
}

static void a_sample_of_another_kind_is_told(void **state)
{
    (void)state;
    made_up_rows m;
    pdmc_energy_forms *forms = NULL;
    double y[WIDTH] = {1.0, 1e-2, 1e-5, 1e-9, 1e-11};
    make_rows(&m);
    CHECK_OK(pdmc_energy_forms_create(&m.model, PILOTS, m.y, &forms));
    assert_true(pdmc_energy_forms_hold(forms, y));
    y[3] = 1e-8;
    assert_false(pdmc_energy_forms_hold(forms, y));
    y[3] = NAN;
    assert_false(pdmc_energy_forms_hold(forms, y));
    pdmc_energy_forms_destroy(&forms);
}

static void there_are_none_without_gain(void **state)
{
    (void)state;
    made_up_rows m;
    pdmc_energy_forms *forms = NULL;
    make_rows(&m);
    for (int d = 0; d < DIRECTIONS; d++) m.crossing[d].bonds /= 3; // fewer than the pairs of each ring
    CHECK_OK(pdmc_energy_forms_create(&m.model, PILOTS, m.y, &forms));
    assert_null(forms);
    make_rows(&m);
    m.crossing[0].column = m.column;
    CHECK_OK(pdmc_energy_forms_create(&m.model, PILOTS, m.y, &forms));
    assert_null(forms);
}

static void make_noisy(plate *p)
{
    plate_make_cracked(p, 1.0, 0.3, 8);
    p->uncertainties[0] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = 10, .variation = 0.2};
    p->problem.uncertainty_count = 1;
}

// The samples of a study, and one that is none of it: it is summed bond by bond, to the bit as without forms.
static void a_block_may_use_them(void **state)
{
    (void)state;
    plate p;
    pdmc_kansa *kansa = NULL;
    pdmc_affine model;
    pdmc_energy_forms *forms = NULL;
    drawn_block bonds, formed;
    double worst = 0.0;
    make_noisy(&p);
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 2, &kansa));
    CHECK_OK(pdmc_kansa_affine(kansa, &model));
    pdmc_block *a = drawn_block_begin(&bonds, &p.problem, &model, B),
               *b = drawn_block_begin(&formed, &p.problem, &model, B);
    CHECK_OK(pdmc_block_make_forms(b, &forms));
    assert_non_null(forms);
    CHECK_OK(pdmc_block_use_forms(b, forms));
    pdmc_block *const both[] = {a, b};
    for (int k = 0; k < 2; k++) {
        CHECK_OK(pdmc_block_draw(both[k], 0, B));
        CHECK_OK(pdmc_block_solve(both[k], B));
        both[k]->x[7 * model.unknowns + model.unknowns - 1] += 0.1 * both[k]->x[7 * model.unknowns];
        pdmc_block_energies(both[k], PDMC_BONDS_ALL);
    }
    for (int d = 0; d < model.tips * model.angles; d++)
        for (int s = 0; s < B; s++) {
            const double exact = a->energy[d * B + s], found = b->energy[d * B + s];
            if (s == 7) assert_memory_equal(&exact, &found, sizeof exact);
            if (exact > 0.0) worst = fmax(worst, fabs(found / exact - 1.0));
            else CHECK_NEAR(found, 0.0, 0.0);
        }
    printf("  %d unknowns, %d pairs: energies differ by %.1e from the sum over bonds\n", model.unknowns, forms->pairs,
           worst);
    assert_true(worst < 1e-13);
    pdmc_energy_forms_destroy(&forms);
    drawn_block_end(&bonds);
    drawn_block_end(&formed);
    pdmc_affine_clear(&model);
    pdmc_kansa_destroy(&kansa);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forms_are_the_sum_over_bonds),
        cmocka_unit_test(pairs_that_do_not_matter_are_left_out),
        cmocka_unit_test(a_sample_of_another_kind_is_told),
        cmocka_unit_test(there_are_none_without_gain),
        cmocka_unit_test(a_block_may_use_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
