// SPDX-License-Identifier: GPL-3.0-or-later

/// From an explicit problem's interfaces to bonds: c and s_0 by the formulas of the materials, and their factors in samples.

#include "pdmc/explicit.h"

#include "check.h"
#include "particles/particles_impl.h"

/// Two layers in a box and a third body beside it, of two materials.
typedef struct {
    pdmc_explicit problem;
    pdmc_explicit_material materials[2];
    pdmc_explicit_body bodies[3];
    pdmc_explicit_interface interfaces[2];
} layers;

static void make_layers(layers *l)
{
    *l = (layers){
        .materials = {{.density = 1.0, .has_youngs_modulus = true, .youngs_modulus = 3.0},
                      {.density = 2.0,
                       .has_micromodulus = true,
                       .micromodulus = 0.1,
                       .has_critical_stretch = true,
                       .critical_stretch = 0.05}},
        .bodies = {{.body = {.shape = {.to = {9, 9, 0}}}},
                   {.body = {.shape = {.from = {0, 5, 0}, .to = {9, 9, 0}}, .material = 1, .is_part = true}},
                   {.body = {.shape = {.from = {10, 0, 0}, .to = {14, 9, 0}}, .material = 0}}},
        .interfaces = {{.between = PDMC_BETWEEN_MATERIALS, .second_material = 1},
                       {.between = PDMC_BETWEEN_BODIES, .first_body = 2, .second_body = 0}},
    };
    l->problem = (pdmc_explicit){.dimension = 2,
                                 .spacing = 1.0,
                                 .horizon = 3.0,
                                 .thickness = 2.0,
                                 .safety = 0.5,
                                 .duration = 1.0,
                                 .material_count = 2,
                                 .materials = l->materials,
                                 .body_count = 3,
                                 .bodies = l->bodies,
                                 .interface_count = 2,
                                 .interfaces = l->interfaces};
}

/// What the bonds between two bodies are in a sample.
static void check_joint(const layers *l, const pdmc_explicit_sample *sample, int a, int b, double micromodulus,
                        double strength)
{
    pdmc_particles *p = NULL;
    CHECK_OK(pdmc_explicit_sample_particles(&l->problem, sample, 1, &p));
    const pdmc_joints *j = &p->variation.joints;
    for (int k = 0; k < 2; k++) {
        const size_t pair = pdmc_joints_row(j, k ? a : b) + (size_t)(1 + (k ? b : a));
        assert_true(j->bonded[pair]);
        CHECK_NEAR(j->micromodulus[pair], micromodulus, 1e-15 * micromodulus);
        if (isinf(strength)) assert_true(isinf(j->strength[pair]) && j->by_nodes[pair] == 0.0);
        else CHECK_NEAR(j->strength[pair], strength, 1e-15 * strength);
        if (isfinite(strength)) assert_true(isinf(j->by_nodes[pair]));
    }
    assert_false(pdmc_joints_bond(j, 1, 2)); // only the two that are named
    pdmc_particles_destroy(p);
}

static void interfaces_are_those_of_the_problem(void **state)
{
    (void)state;
    const double pi = 3.14159265358979323846, c = 9.0 * 3.0 / (pi * 27.0 * 2.0); // 9 E / (pi horizon^3 t)
    const double mean = 2.0 * c * 0.1 / (c + 0.1);
    pdmc_explicit_sample sample = {.load = 1.0, .velocity = 1.0, .youngs_modulus = 1.0, .fracture_energy = 1.0};
    layers l;
    make_layers(&l);
    check_joint(&l, &sample, 0, 1, mean, INFINITY);
    check_joint(&l, &sample, 0, 2, c, INFINITY);
    l.interfaces[0].bonds = (pdmc_explicit_material){.has_fracture_energy = true, .fracture_energy = 0.01};
    check_joint(&l, &sample, 1, 0, mean, sqrt(4.0 * 0.01 / (mean * 2.0 * 81.0))); // sqrt(4 G_0 / (c t horizon^4))
    l.interfaces[1].bonds = (pdmc_explicit_material){
        .has_micromodulus = true, .micromodulus = 0.3, .has_critical_stretch = true, .critical_stretch = 0.02};
    check_joint(&l, &sample, 2, 0, 0.3, 0.02);
    sample.youngs_modulus = 1.5; // what has G_0 keeps it
    check_joint(&l, &sample, 0, 1, 1.5 * mean, sqrt(4.0 * 0.01 / (1.5 * mean * 2.0 * 81.0)));
    check_joint(&l, &sample, 0, 2, 0.45, 0.02);
    sample.fracture_energy = 4.0;
    check_joint(&l, &sample, 0, 1, 1.5 * mean, 2.0 * sqrt(4.0 * 0.01 / (1.5 * mean * 2.0 * 81.0)));
    check_joint(&l, &sample, 0, 2, 0.45, 0.04);
}

/// The step that is known before the nodes are placed is no larger than that of the nodes.
static void the_step_before_is_a_bound(void **state)
{
    (void)state;
    layers l;
    make_layers(&l);
    for (int stiff = 0; stiff < 2; stiff++) {
        pdmc_particles *p = NULL;
        if (stiff) l.interfaces[1].bonds.has_micromodulus = true, l.interfaces[1].bonds.micromodulus = 5.0;
        CHECK_OK(pdmc_explicit_particles(&l.problem, 1, &p));
        assert_true(pdmc_explicit_stable_step(&l.problem) <= pdmc_particles_stable_step(p));
        pdmc_particles_destroy(p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(interfaces_are_those_of_the_problem),
                                       cmocka_unit_test(the_step_before_is_a_bound)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
