// SPDX-License-Identifier: GPL-3.0-or-later

/// Bonds that differ: factors at nodes, and strengths that single bonds draw.

#include "pdmc/random.h"

#include "particles/bodies.h"
#include "particles/particles_impl.h"

/// The distribution of a body's strengths: a tenth of scatter, no less than 0.65.
static void fill(double strengths[])
{
    pdmc_distribution weibull;
    CHECK_OK(pdmc_distribution_by_moments(PDMC_WEIBULL, 1.0, 0.1, &weibull));
    CHECK_OK(pdmc_brittle_strengths(&weibull, strengths));
}

static void strengths_are_quantiles(void **state)
{
    (void)state;
    pdmc_distribution uniform;
    double strengths[PDMC_STRENGTH_CLASSES];
    CHECK_OK(pdmc_distribution_by_moments(PDMC_UNIFORM, 1.0, 0.2, &uniform));
    CHECK_OK(pdmc_brittle_strengths(&uniform, strengths));
    // 1 +- 0.2 sqrt(3)
    for (int k = 0; k < PDMC_STRENGTH_CLASSES; k++)
        CHECK_NEAR(strengths[k], 1.0 + 0.2 * sqrt(3.0) * (2.0 * (k + 0.5) / PDMC_STRENGTH_CLASSES - 1.0), 1e-15);
    CHECK_OK(pdmc_distribution_by_moments(PDMC_NORMAL, 1.0, 0.4, &uniform));
    CHECK_STATUS(pdmc_brittle_strengths(&uniform, strengths), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "its least is -0.3"));
}

/// Pairs of hashes fall evenly into 32 x 32 classes, those of bonds that share a node or lie side by side: chi squared of 1023
/// degrees of freedom within 5 of its standard deviations, sqrt(2046).
static void hashes_are_even(void **state)
{
    (void)state;
    enum { SIDE = 32, CELLS = 1 << 18, ROW = 512 };
    static const uint32_t with[][4] = {
        {0, 1, 0, 1},         // both halves of one hash
        {0, 1, 0, 2},         // bonds of one node
        {0, 1, 1, 2},         // bonds in a line
        {0, 1, ROW, ROW + 1}, // side by side
        {0, ROW - 2, 0, ROW + 2},
        {0, ROW + 3, 7, ROW + 9},
        {3, 70000, 3, 70001},
    };
    const pdmc_hash_key key = {3141592653u, 589793238u};
    for (size_t s = 0; s < sizeof with / sizeof *with; s++) {
        static double count[SIDE][SIDE];
        double chi_squared = 0.0;
        memset(count, 0, sizeof count);
        for (uint32_t c = 0; c < CELLS; c++) {
            const uint32_t one = pdmc_hash(c + with[s][0], c + with[s][1], &key);
            const uint32_t other = pdmc_hash(c + with[s][2], c + with[s][3], &key);
            count[one / SIDE][s == 0 ? other % SIDE : other / SIDE] += 1.0;
        }
        for (int k = 0; k < SIDE * SIDE; k++) {
            const double expected = (double)CELLS / (SIDE * SIDE), off = count[k / SIDE][k % SIDE] - expected;
            chi_squared += off * off / expected;
        }
        CHECK_NEAR(chi_squared, 1023.0, 5.0 * sqrt(2046.0));
    }
}

/// Every bond of a box stretched by s.
static void stretch_by(pdmc_particles *p, double s)
{
    for (int k = 0; k < p->nodes.node_count; k++)
        for (int a = 0; a < PDMC_AXES; a++)
            p->position[a][p->nodes.cell[k]] = (1.0 + s) * p->nodes.reference[a][p->nodes.cell[k]];
}

/// A body that is stretched evenly loses the share of its bonds that the distribution has below that stretch, by as much as chance
/// allows, and their energy; of one strength it would lose all or none.
static void bonds_break_by_their_distribution(void **state)
{
    (void)state;
    double strengths[PDMC_STRENGTH_CLASSES];
    pdmc_distribution weibull;
    CHECK_OK(pdmc_distribution_by_moments(PDMC_WEIBULL, 1.0, 0.1, &weibull));
    fill(strengths);
    const double s_0 = 0.01, at[] = {0.75, 0.9, 1.0, 1.05};
    for (int linear = 0; linear < 2; linear++) {
        for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
            specimen s;
            make_box(&s, 3, (int[]){12, 12, 12});
            s.material.critical_stretch = s_0;
            s.material.strengths = strengths;
            s.options.linear_stretch = linear;
            s.options.seed = 11;
            s.options.sample = k;
            pdmc_particles *p = create(&s);
            stretch_by(p, at[k] * s_0);
            const double elastic = pdmc_particles_sum(p).elastic;
            CHECK_OK(pdmc_particles_advance(p, 1));
            const pdmc_particles_sums after = pdmc_particles_sum(p);
            const double bonds = (double)pdmc_particles_bonds(p);
            const double share = pdmc_distribution_lower_tail(&weibull, at[k]);
            // Five standard deviations of chance, and half a class.
            const double chance = 5.0 * sqrt(share * (1.0 - share) / bonds) + 0.5 / PDMC_STRENGTH_CLASSES;
            CHECK_NEAR((double)after.broken / bonds, share, chance);
            // Bonds of every length break alike: 80 thousand with a spread of |xi| of 0.3 about its mean.
            CHECK_NEAR(after.fracture / elastic, (double)after.broken / bonds, 5.0 * 0.3 / sqrt((double)after.broken));
            CHECK_NEAR(after.fracture + after.elastic, elastic, 1e-12 * elastic);
            pdmc_particles_destroy(p);
        }
    }
}

/// A box half of which is a zone without failure, and the same without bonds inside the zone: its own box has as many.
static void zones_keep_their_bonds(void **state)
{
    (void)state;
    specimen s, half;
    make_box(&s, 3, (int[]){10, 8, 8});
    make_box(&half, 3, (int[]){5, 8, 8});
    s.material.critical_stretch = 0.01;
    s.material.strengthening = 0.25;
    const pdmc_shape zones[] = {half.body.shape, {.kind = PDMC_SHAPE_BALL, .centre = {3, 3, 3}, .radius = 1.0}};
    s.options.no_fail_count = 2;
    s.options.no_fail = zones;
    pdmc_particles *p = create(&s), *q = create(&half);
    stretch_by(p, 0.02);
    CHECK_OK(pdmc_particles_advance(p, 1));
    assert_int_equal(pdmc_particles_sum(p).broken, pdmc_particles_bonds(p) - pdmc_particles_bonds(q));
    pdmc_particles_destroy(p);
    pdmc_particles_destroy(q);
    s.options.no_fail = &(pdmc_shape){.kind = PDMC_SHAPE_BALL, .centre = {90, 0, 0}, .radius = 1.0};
    s.options.no_fail_count = 1;
    CHECK_STATUS(pdmc_particles_create(&s.options, &p), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), "no_fail[0]: holds no node");
}

/// A cube that is stretched evenly: no axis is before another, so that beta^2 is a third in the mean, whatever the fibres'
/// direction; and the step is that of a node whose sum of stiffnesses has grown by as much.
static void fibres_stiffen(void **state)
{
    (void)state;
    specimen s;
    double energy[2], step[2];
    for (int k = 0; k < 2; k++) {
        make_box(&s, 3, (int[]){8, 8, 8});
        if (k == 1) s.material.fibre_ratio = 5.5;
        for (int a = 0; a < PDMC_AXES && k == 1; a++) s.material.fibre[a] = a + 1.0;
        pdmc_particles *p = create(&s);
        stretch_by(p, 0.01);
        energy[k] = pdmc_particles_sum(p).elastic;
        step[k] = pdmc_particles_stable_step(p);
        pdmc_particles_destroy(p);
    }
    // Shears cancel: the even stretch of a cube leaves beta^2 = sum g_a^2 xi_a^2 / |xi|^2 + 2 sum g_a g_b xi_a xi_b / |xi|^2.
    CHECK_NEAR(energy[1] / energy[0], 1.0 + 4.5 / 3.0, 1e-12);
    CHECK_NEAR(step[1] / step[0], 1.0 / sqrt(1.0 + 4.5 / 3.0), 1e-14);
    s.material.fibre_ratio = -1.0;
    pdmc_particles *p;
    CHECK_STATUS(pdmc_particles_create(&s.options, &p), PDMC_ERR_ARG);
}

/// Full and linear stretch differ by the second order of the displacement, their energies so by the third.
static void linear_stretch_is_the_first_order(void **state)
{
    (void)state;
    double difference[2];
    for (int k = 0; k < 2; k++) {
        double energy[2];
        for (int linear = 0; linear < 2; linear++) {
            unsigned seed = 9;
            specimen s;
            make_box(&s, 3, (int[]){7, 6, 5});
            s.options.linear_stretch = linear;
            pdmc_particles *p = create(&s);
            for (int n = 0; n < p->nodes.node_count; n++)
                for (int a = 0; a < PDMC_AXES; a++)
                    p->position[a][p->nodes.cell[n]] += (k == 0 ? 1e-3 : 5e-4) * scatter(&seed);
            energy[linear] = pdmc_particles_sum(p).elastic;
            pdmc_particles_destroy(p);
        }
        difference[k] = energy[0] - energy[1];
        assert_true(fabs(difference[k]) < 1e-2 * energy[0] && difference[k] != 0.0);
    }
    CHECK_NEAR(difference[0] / difference[1], 8.0, 0.1); // the fourth order is 1e-3 of the third
}

/// A block with a notch that is torn apart, its bonds all different.
static void tear(const pdmc_particles_options *changes, int threads, double values[], pdmc_particles_sums *sums)
{
    specimen s;
    const int count[] = {24, 12, 6};
    make_box(&s, 3, count);
    s.material.critical_stretch = 0.02;
    s.material.strengthening = 0.25;
    s.material.strengths = changes->materials ? changes->materials->strengths : NULL;
    s.options.factor_count = changes->factor_count;
    s.options.stiffness_factors = changes->stiffness_factors;
    s.options.strength_factors = changes->strength_factors;
    s.options.seed = changes->seed;
    s.options.sample = changes->sample;
    s.options.threads = threads;
    s.options.step = 0.1;
    if (changes->horizon > 0.0) s.material.micromodulus *= 2.0, s.material.critical_stretch *= 2.0;
    const pdmc_layer_condition ends[] = {
        {.kind = PDMC_CONDITION_FORCE, .region = {.to = {2, 11, 5}}, .along = {true}, .value = {-0.03}},
        {.kind = PDMC_CONDITION_FORCE,
         .region = {.from = {21, 0, 0}, .to = {23, 11, 5}},
         .along = {true},
         .value = {0.03}},
    };
    s.options.condition_count = 2;
    s.options.conditions = ends;
    pdmc_particles *p = create(&s);
    CHECK_OK(pdmc_particles_advance(p, 180));
    pdmc_particles_state(p, values, NULL, &values[3 * count[0] * count[1] * count[2]]);
    *sums = pdmc_particles_sum(p);
    pdmc_particles_destroy(p);
}

enum { NODES = 24 * 12 * 6 };

static void a_draw_is_that_of_its_seed_and_sample(void **state)
{
    (void)state;
    static double values[5][4 * NODES], factors[2][NODES], strengths[PDMC_STRENGTH_CLASSES];
    pdmc_particles_sums sums[5];
    unsigned seed = 3;
    fill(strengths);
    for (int k = 0; k < 2 * NODES; k++) factors[k / NODES][k % NODES] = 1.0 + 0.2 * scatter(&seed);
    pdmc_particles_options changes = {.materials = &(pdmc_brittle_material){.strengths = strengths},
                                      .factor_count = NODES,
                                      .stiffness_factors = factors[0],
                                      .strength_factors = factors[1],
                                      .seed = 5};
    for (int k = 0; k < 3; k++) tear(&changes, k + 1, values[k], &sums[k]);
    changes.sample = 1;
    tear(&changes, 1, values[3], &sums[3]);
    changes.sample = 0;
    changes.seed = 6;
    tear(&changes, 1, values[4], &sums[4]);
    assert_true(sums[0].broken > 2000);
    for (int k = 1; k < 3; k++) {
        assert_memory_equal(values[0], values[k], sizeof values[0]);
        assert_memory_equal(&sums[0], &sums[k], sizeof sums[0]);
    }
    for (int k = 3; k < 5; k++) assert_memory_not_equal(values[0], values[k], sizeof values[0]);
    assert_memory_not_equal(values[3], values[4], sizeof values[3]);
}

/// Twice the factors are twice the constants, to the bit.
static void factors_are_those_of_the_constants(void **state)
{
    (void)state;
    static double values[2][4 * NODES], twice[NODES];
    pdmc_particles_sums sums[2];
    for (int k = 0; k < NODES; k++) twice[k] = 2.0;
    const pdmc_particles_options factors = {
        .factor_count = NODES, .stiffness_factors = twice, .strength_factors = twice};
    tear(&factors, 1, values[0], &sums[0]);
    tear(&(pdmc_particles_options){.horizon = 1.0}, 1, values[1], &sums[1]);
    assert_true(sums[0].broken > 1000);
    assert_memory_equal(values[0], values[1], sizeof values[0]);
    assert_int_equal(sums[0].broken, sums[1].broken);
    CHECK_NEAR(sums[0].elastic, sums[1].elastic, 1e-13 * sums[0].elastic);
    CHECK_NEAR(sums[0].fracture, sums[1].fracture, 1e-13 * sums[0].fracture);
}

/// By definition, over the bonds of the stiffest node, which is in the middle.
static void the_step_is_that_of_the_stiffest_node(void **state)
{
    (void)state;
    specimen s;
    double factors[9 * 9 * 9], sum = 0.0;
    make_box(&s, 3, (int[]){9, 9, 9});
    for (int k = 0; k < 729; k++) factors[k] = k == 364 ? 3.0 : 1.0;
    s.options.factor_count = 729;
    s.options.stiffness_factors = factors;
    for (int x = -3; x <= 3; x++)
        for (int y = -3; y <= 3; y++)
            for (int z = -3; z <= 3; z++) {
                const int square = x * x + y * y + z * z;
                if (square > 0 && square <= 9) sum += 2.0 * s.material.micromodulus / sqrt(square);
            }
    pdmc_particles *p = create(&s);
    CHECK_NEAR(pdmc_particles_stable_step(p), sqrt(2.0 / sum), 1e-14);
    pdmc_particles_destroy(p);
}

static void factors_that_cannot_be(void **state)
{
    (void)state;
    specimen s;
    double factors[] = {1, 1, 1, 1, 1, 0, 1, 1};
    pdmc_particles *p;
    make_box(&s, 3, (int[]){2, 2, 2});
    s.options.factor_count = 7;
    s.options.strength_factors = factors;
    CHECK_STATUS(pdmc_particles_create(&s.options, &p), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), "strength_factors: 7, there are 8 nodes");
    s.options.factor_count = 8;
    CHECK_STATUS(pdmc_particles_create(&s.options, &p), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), "strength_factors[5]: 0, needs to be > 0");
    factors[5] = 1.0;
    s.options.stiffness_factors = factors;
    double strengths[PDMC_STRENGTH_CLASSES];
    fill(strengths);
    s.material.strengths = strengths;
    s.options.no_fail_count = 1;
    s.options.no_fail = &s.body.shape;
    CHECK_FAILS_CLEANLY(pdmc_particles_create(&s.options, &p), pdmc_particles_destroy(p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strengths_are_quantiles),
        cmocka_unit_test(hashes_are_even),
        cmocka_unit_test(bonds_break_by_their_distribution),
        cmocka_unit_test(zones_keep_their_bonds),
        cmocka_unit_test(fibres_stiffen),
        cmocka_unit_test(linear_stretch_is_the_first_order),
        cmocka_unit_test(a_draw_is_that_of_its_seed_and_sample),
        cmocka_unit_test(factors_are_those_of_the_constants),
        cmocka_unit_test(the_step_is_that_of_the_stiffest_node),
        cmocka_unit_test(factors_that_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
