// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"
#include "discretisation/interaction.h"

#include <gsl/gsl_math.h>

typedef struct {
    pdmc_problem problem;
    pdmc_crack cracks[2];
    double K[2], T; // of the field round the tip
    int tip;
} cracked;

static void make(cracked *c, pdmc_assumption assumption, int tip)
{
    *c = (cracked){.cracks = {{"crack", {0.1, -0.2}, {0.9, 0.4}}}, .K = {1.3, -0.7}, .T = 2.5, .tip = tip};
    c->problem = (pdmc_problem){
        .plate = {6.0, 4.0, 1.0}, .material = {3.0, assumption, 1.0}, .crack_count = 1, .cracks = c->cracks};
}

// Williams' displacements at a tip, those of T, and a rotation; x and u in the plate's frame.
static void williams(const cracked *c, const double x[2], double u[2])
{
    const pdmc_material *material = &c->problem.material;
    const bool is_stress = material->assumption == PDMC_PLANE_STRESS;
    const double nu = is_stress ? 1.0 / 3.0 : 0.25, E = material->youngs_modulus, mu = 0.5 * E / (1.0 + nu);
    const double kappa = is_stress ? (3.0 - nu) / (1.0 + nu) : 3.0 - 4.0 * nu;
    const pdmc_tip_frame f = pdmc_tip_frame_of(&c->problem, c->tip);
    const double dx = x[0] - f.position[0], dy = x[1] - f.position[1];
    const double p[2] = {f.cosine * dx + f.sine * dy, f.cosine * dy - f.sine * dx};
    const double t = atan2(p[1], p[0]), s = sin(0.5 * t), k = cos(0.5 * t);
    const double scale = sqrt(hypot(p[0], p[1]) / (2.0 * M_PI)) / (2.0 * mu);
    const double E1 = is_stress ? E : E / (1.0 - nu * nu), nu1 = is_stress ? nu : nu / (1.0 - nu);
    const double local[2] = {
        scale * (c->K[0] * k * (kappa - 1.0 + 2.0 * s * s) + c->K[1] * s * (kappa + 1.0 + 2.0 * k * k)) +
            c->T / E1 * p[0] - 0.3 * p[1],
        scale * (c->K[0] * s * (kappa + 1.0 - 2.0 * k * k) - c->K[1] * k * (kappa - 1.0 - 2.0 * s * s)) -
            nu1 * c->T / E1 * p[1] + 0.3 * p[0]};
    u[0] = f.cosine * local[0] - f.sine * local[1];
    u[1] = f.sine * local[0] + f.cosine * local[1];
}

// The field as two nodes, u of the first and v of the second being 1: their weights are the field's derivatives.
static pdmc_status gradient_of_field(const void *method, const double x[2], int *count, int node[], double by_x[],
                                     double by_y[])
{
    const double h = 1e-4;
    for (int d = 0; d < 2; d++) {
        double ahead[2], behind[2], x_ahead[2] = {x[0], x[1]}, x_behind[2] = {x[0], x[1]};
        x_ahead[d] += h;
        x_behind[d] -= h;
        williams(method, x_ahead, ahead);
        williams(method, x_behind, behind);
        for (int i = 0; i < 2; i++) (d == 0 ? by_x : by_y)[i] = (ahead[i] - behind[i]) / (2.0 * h);
    }
    for (int i = 0; i < 2; i++) node[i] = i;
    *count = 2;
    return PDMC_OK;
}

// At either tip of an inclined crack, in both plane assumptions, on any circle; T and a rotation do not matter.
static void williams_field_has_its_factors(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        cracked c;
        double row[2][4] = {{0.0}};
        make(&c, i & 1 ? PDMC_PLANE_STRAIN : PDMC_PLANE_STRESS, i >> 1 & 1);
        const pdmc_gradient_functional functional = {2, &c, gradient_of_field};
        CHECK_OK(pdmc_interaction_rows(&c.problem, c.tip, i < 4 ? 0.2 : 0.7, &functional, row[0], row[1]));
        for (int k = 0; k < 2; k++) CHECK_NEAR(row[k][0] + row[k][3], c.K[k], 1e-6); // h^2 of the differences
    }
}

// 0.8 of the way to the crack's other end, to a side, to another crack; or what was wanted.
static void the_circle_is_clear_of_everything(void **state)
{
    (void)state;
    cracked c;
    make(&c, PDMC_PLANE_STRESS, 1);
    CHECK_NEAR(pdmc_interaction_radius(&c.problem, 1, 0.3), 0.3, 1e-15);
    CHECK_NEAR(pdmc_interaction_radius(&c.problem, 1, 9.0), 0.8, 1e-15); // the crack's length is 1
    c.problem.plate.height = 2.2;
    CHECK_NEAR(pdmc_interaction_radius(&c.problem, 1, 9.0), 0.8 * 0.7, 1e-15);
    c.problem.crack_count = 2;
    c.cracks[1] = (pdmc_crack){"other", {1.4, 0.0}, {1.4, 1.0}};
    CHECK_NEAR(pdmc_interaction_radius(&c.problem, 1, 9.0), 0.8 * 0.5, 1e-15);
}

static pdmc_status no_gradient(const void *method, const double x[2], int *count, int node[], double by_x[],
                               double by_y[])
{
    (void)method, (void)x, (void)count, (void)node, (void)by_x, (void)by_y;
    return PDMC_ERR_SINGULAR;
}

static void failures_are_reported(void **state)
{
    (void)state;
    cracked c;
    double row[2][4] = {{0.0}};
    make(&c, PDMC_PLANE_STRESS, 0);
    const pdmc_gradient_functional fails = {2, &c, no_gradient}, functional = {2, &c, gradient_of_field};
    CHECK_STATUS(pdmc_interaction_rows(&c.problem, 0, 0.2, &fails, row[0], row[1]), PDMC_ERR_SINGULAR);
    CHECK_FAILS_CLEANLY(pdmc_interaction_rows(&c.problem, 0, 0.2, &functional, row[0], row[1]), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(williams_field_has_its_factors),
        cmocka_unit_test(the_circle_is_clear_of_everything),
        cmocka_unit_test(failures_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
