// SPDX-License-Identifier: GPL-3.0-or-later

/// Bonds with a law: their force, its derivative and its energy against each other and against linear bonds; rest by Newton's
/// method, and motion.

#include "galerkin/wave.h"

#include <gsl/gsl_deriv.h>
#include <gsl/gsl_integration.h>
#include <string.h>

static const pdmc_form_rule points = {PDMC_OUTER_GAUSS, PDMC_INNER_POLYNOMIAL, 1};
static const pdmc_bond_law laws[] = {
    {PDMC_LAW_LINEAR, 0.0}, {PDMC_LAW_SATURATING, 4.0}, {PDMC_LAW_STIFFENING, 4.0}, {PDMC_LAW_SOFTENING, 12.0}};
enum { LAWS = sizeof laws / sizeof laws[0] };

static double force_at(double s, void *law)
{
    return pdmc_law_at(law, s).force;
}

static double energy_at(double s, void *law)
{
    return pdmc_law_at(law, s).energy;
}

static void slopes_and_energies_belong_to_the_force(void **state)
{
    (void)state;
    for (int k = 0; k < LAWS; k++)
        for (double s = -9.0; s < 9.5; s += 1.5) {
            pdmc_bond_law law = laws[k];
            gsl_function force = {force_at, &law}, energy = {energy_at, &law};
            double got, error;
            gsl_deriv_central(&force, s, 1e-2, &got, &error);
            CHECK_NEAR(pdmc_law_at(&law, s).slope, got, 2.0 * error + 1e-10);
            gsl_deriv_central(&energy, s, 1e-2, &got, &error);
            CHECK_NEAR(pdmc_law_at(&law, s).force, got, 2.0 * error + 1e-10);
            CHECK_NEAR(pdmc_law_at(&law, -s).force, -pdmc_law_at(&law, s).force, 0.0);
        }
    const pdmc_bond_law tiny = {PDMC_LAW_SATURATING, 1e-3};
    CHECK_NEAR(pdmc_law_at(&tiny, 5.0).force, 1e-3, 0.0);
    CHECK_NEAR(pdmc_law_at(&tiny, 5.0).energy, 1e-3 * (5.0 - 1e-3 * log(2.0)), 1e-15);
    CHECK_NEAR(pdmc_law_at(&laws[3], 12.0 / sqrt(2.0)).slope, 0.0, 1e-15);
}

// ---- the operator ----

// -lambda u where bonds are linear.
static void linear_bonds_have_the_operator_of_the_dispersion(void **state)
{
    (void)state;
    const double weight[2] = {1.0, 3.0}, x[2] = {0.2, -0.1};
    for (int dimension = 1; dimension <= 2; dimension++)
        for (double power = 0.0; power < 2.0; power += 0.6)
            for (int bins = 1; bins <= 2; bins++) {
                const wave w = {2, {3.0, dimension == 1 ? 0.0 : 4.0}, 0.7, 1.0};
                pdmc_scalar_kernel kernel;
                pdmc_area_rule half;
                double lambda;
                CHECK_OK(pdmc_scalar_kernel_create(dimension, 0.4, power, bins, weight, &kernel));
                CHECK_OK(pdmc_scalar_dispersion(&kernel, dimension == 1 ? 3.0 : 5.0, &lambda));
                CHECK_OK(pdmc_horizon_points(&kernel, &half));
                CHECK_NEAR(pdmc_law_operator(&half, &laws[0], wave_at, &w, x), -lambda * wave_at(&w, x), 1e-11 * lambda);
                pdmc_area_rule_clear(&half);
            }
}

typedef struct {
    const pdmc_bond_law *law;
    const pdmc_scalar_kernel *kernel;
    wave w;
    double x[2], direction[2];
} line_of_bonds;

static double bond_ahead(double r, void *context)
{
    const line_of_bonds *l = context;
    const double there[2] = {l->x[0] + r * l->direction[0], l->x[1] + r * l->direction[1]};
    const double area = l->kernel->dimension == 1 ? 1.0 : r;
    return area * pdmc_scalar_kernel_at(l->kernel, r) * r *
           pdmc_law_at(l->law, (wave_at(&l->w, there) - wave_at(&l->w, l->x)) / r).force;
}

static double direction_at(double angle, void *context)
{
    line_of_bonds l = *(line_of_bonds *)context;
    gsl_function f = {bond_ahead, &l};
    double sum, error;
    size_t evaluations;
    l.direction[0] = cos(angle);
    l.direction[1] = sin(angle);
    gsl_integration_qng(&f, 0.0, l.kernel->horizon, 1e-12, 1e-12, &sum, &error, &evaluations);
    return sum;
}

// ... and where they are not, that of GSL's adaptive rules.
static void the_operator_is_that_of_adaptive_rules(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int k = 1; k < LAWS; k++) {
            pdmc_scalar_kernel kernel;
            pdmc_area_rule half;
            line_of_bonds l = {&laws[k], &kernel, {2, {3.0, dimension == 1 ? 0.0 : 4.0}, 0.7, 1.0}, {0.2, -0.1}, {0}};
            gsl_function f = {direction_at, &l};
            gsl_integration_workspace *work = gsl_integration_workspace_alloc(200);
            double want, error;
            CHECK_OK(pdmc_scalar_kernel_create(dimension, 0.4, 1.0, 1, NULL, &kernel));
            want = direction_at(0.0, &l) + direction_at(M_PI, &l);
            if (dimension == 2)
                gsl_integration_qag(&f, 0.0, 2.0 * M_PI, 1e-10, 1e-10, 200, GSL_INTEG_GAUSS21, work, &want, &error);
            CHECK_OK(pdmc_horizon_points(&kernel, &half));
            CHECK_NEAR(pdmc_law_operator(&half, &laws[k], wave_at, &l.w, l.x), want, 1e-9);
            pdmc_area_rule_clear(&half);
            gsl_integration_workspace_free(work);
        }
}

// ---- forces ----

typedef struct {
    setting at;
    pdmc_law_bonds *bonds;
    double *u, *force; // [count], the wave; [free_count]
    wave w;
} stretched;

static void stretched_create(const steady *s, const pdmc_bond_law *law, int threads, stretched *out)
{
    *out = (stretched){.w = wave_of(s->dimension)};
    setting_create(s, &out->at);
    const size_t n = (size_t)out->at.space.count, d = (size_t)s->dimension;
    CHECK_OK(pdmc_law_bonds_create(&out->at.space, &out->at.kernel, law, &s->rule, threads, &out->bonds));
    out->u = pdmc_calloc(n, sizeof *out->u);
    out->force = pdmc_calloc(n, sizeof *out->force);
    for (size_t i = 0; i < n; i++) out->u[i] = wave_at(&out->w, &out->at.space.x[d * i]);
}

static void stretched_clear(stretched *s)
{
    pdmc_law_bonds_destroy(&s->bonds);
    pdmc_free(s->u);
    pdmc_free(s->force);
    setting_clear(&s->at);
}

// The same sums in another order.
static void linear_bonds_have_the_forces_of_the_form(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++) {
        const steady s = {dimension, 6, 0.21, 1.0, PDMC_SPACE_DISCONTINUOUS, points};
        stretched b;
        pdmc_form form;
        double energy;
        stretched_create(&s, &laws[0], 2, &b);
        CHECK_OK(pdmc_form_peridynamic(&b.at.space, &b.at.kernel, &points, 1, &form));
        double *want = pdmc_calloc((size_t)b.at.space.count, sizeof *want);
        pdmc_form_multiply(&form, b.u, want);
        pdmc_law_bonds_force(b.bonds, b.u, b.force, &energy);
        for (int i = 0; i < b.at.space.free_count; i++) CHECK_NEAR(b.force[i], want[i], 1e-11);
        pdmc_free(want);
        pdmc_form_clear(&form);
        stretched_clear(&b);
    }
}

// Along a direction d: F(u + h d) - F(u - h d) over 2 h, by two h extrapolated; and the energy likewise.
static void forces_are_derivatives_of_the_energy_and_tangents_of_the_forces(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int k = 1; k < LAWS; k++) {
            const steady s = {dimension, 5, 0.31, 1.0, PDMC_SPACE_MIXED, points};
            stretched b;
            pdmc_form tangent;
            stretched_create(&s, &laws[k], 1, &b);
            const int n = b.at.space.free_count;
            double *d = pdmc_calloc((size_t)b.at.space.count, sizeof *d), *want = pdmc_calloc((size_t)n, sizeof *want);
            double *slope = pdmc_calloc((size_t)n, sizeof *slope), energy, work = 0.0, force = 0.0;
            for (int i = 0; i < n; i++) d[i] = (i * 7 % 11) / 11.0 - 0.5;
            CHECK_OK(pdmc_law_bonds_tangent(b.bonds, b.u, &tangent));
            pdmc_form_multiply(&tangent, d, want);
            pdmc_law_bonds_force(b.bonds, b.u, b.force, &energy);
            for (int i = 0; i < n; i++) force += b.force[i] * d[i];
            for (int which = 0; which < 4; which++) { // weights 4/3 and -1/3 of the steps h and 2 h
                const double h = (which / 2 ? 2e-3 : 1e-3) * (which % 2 ? -1.0 : 1.0);
                const double weight = (which / 2 ? -1.0 / 3.0 : 4.0 / 3.0) / (2.0 * h);
                for (int i = 0; i < n; i++) b.u[i] += h * d[i];
                pdmc_law_bonds_force(b.bonds, b.u, b.force, &energy);
                for (int i = 0; i < n; i++) b.u[i] -= h * d[i];
                for (int i = 0; i < n; i++) slope[i] += weight * b.force[i];
                work += weight * energy;
            }
            CHECK_NEAR(work, force, 1e-7 * fabs(force));
            for (int i = 0; i < n; i++) CHECK_NEAR(slope[i], want[i], 1e-6);
            pdmc_free(d);
            pdmc_free(want);
            pdmc_free(slope);
            pdmc_form_clear(&tangent);
            stretched_clear(&b);
        }
}

static void bonds_have_the_same_bits_on_any_number_of_threads(void **state)
{
    (void)state;
    const steady s = {2, 12, 0.2, 1.0, PDMC_SPACE_MIXED, points};
    stretched one, three;
    double energy[2];
    stretched_create(&s, &laws[1], 1, &one);
    stretched_create(&s, &laws[1], 3, &three);
    pdmc_law_bonds_force(one.bonds, one.u, one.force, &energy[0]);
    pdmc_law_bonds_force(three.bonds, three.u, three.force, &energy[1]);
    assert_memory_equal(one.force, three.force, (size_t)one.at.space.free_count * sizeof *one.force);
    assert_memory_equal(&energy[0], &energy[1], sizeof energy[0]);
    stretched_clear(&one);
    stretched_clear(&three);
}

// ---- rest ----

typedef struct {
    const pdmc_area_rule *half;
    const pdmc_bond_law *law;
    wave w;
    int dimension;
} source;

static double source_at(const void *context, const double x[])
{
    const source *s = context;
    return -pdmc_law_operator(s->half, s->law, wave_at, &s->w, (double[2]){x[0], s->dimension == 1 ? 0.0 : x[1]});
}

// Solves for the wave whose body force is that of the operator.
static pdmc_status solve_wave(stretched *b, const steady *s, const pdmc_bond_law *law, pdmc_newton *newton)
{
    pdmc_area_rule half;
    CHECK_OK(pdmc_horizon_points(&b->at.kernel, &half));
    const source force = {&half, law, b->w, s->dimension};
    CHECK_OK(pdmc_space_load(&b->at.space, source_at, &force, b->force));
    pdmc_area_rule_clear(&half);
    return pdmc_law_bonds_solve(b->bonds, b->force, b->u, newton);
}

static double law_error(const steady *s, const pdmc_bond_law *law, pdmc_newton *newton)
{
    stretched b;
    double error;
    stretched_create(s, law, 2, &b);
    CHECK_OK(solve_wave(&b, s, law, newton));
    CHECK_OK(pdmc_space_distance(&b.at.space, b.u, wave_at, &b.w, &error));
    stretched_clear(&b);
    return error;
}

static void rest_converges_with_the_second_order(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int k = 1; k < LAWS; k++) {
            enum { TIMES = 2 };
            steady s = {dimension, dimension == 1 ? 10 : 3, 0.23, 1.0, (pdmc_space_kind)(k - 1), points};
            pdmc_newton newton;
            const double first = law_error(&s, &laws[k], &newton);
            double last = first;
            print_message("  %dD law %d: %.2e", dimension, laws[k].kind, first);
            for (int i = 0; i < (dimension == 1 ? TIMES : 1); i++) {
                s.cells *= 2;
                last = law_error(&s, &laws[k], &newton);
                print_message(" %.2e", last);
            }
            const double rate = log2(first / last) / (dimension == 1 ? TIMES : 1);
            print_message(", mean rate %.2f, %d iterations\n", rate, newton.iterations);
            CHECK_NEAR(rate, 2.0, 0.3);
        }
}

// The residual goes with the square of the one before.
static void newtons_method_converges_quadratically(void **state)
{
    (void)state;
    for (int k = 1; k < LAWS; k++) {
        const steady s = {1, 40, 0.13, 1.0, PDMC_SPACE_CONTINUOUS, points};
        pdmc_newton newton;
        law_error(&s, &laws[k], &newton);
        int last = newton.iterations;
        while (newton.residual[last] < 1e-12) last--; // what is left is rounding
        const double *r = &newton.residual[last - 2], order = log(r[2] / r[1]) / log(r[1] / r[0]);
        print_message("  law %d: %.1e %.1e %.1e, order %.2f; %d iterations, %d halvings\n", laws[k].kind, r[0], r[1],
                      r[2], order, newton.iterations, newton.halvings);
        CHECK_NEAR(order, 2.0, 0.35);
    }
}

// Bonds that all but reach the force that they never exceed: between the last stretches that they can bear and those that
// they cannot, whole steps go too far, and halves of them still lessen the residual.
static void no_step_lengthens_the_residual(void **state)
{
    (void)state;
    const steady s = {1, 40, 0.13, 1.0, PDMC_SPACE_CONTINUOUS, points};
    const pdmc_bond_law law = {PDMC_LAW_SATURATING, 0.7};
    stretched b;
    pdmc_newton newton;
    stretched_create(&s, &law, 1, &b);
    CHECK_STATUS(solve_wave(&b, &s, &law, &newton), PDMC_ERR_SINGULAR);
    print_message("  %d iterations, %d halvings, %.1e left\n", newton.iterations, newton.halvings,
                  newton.residual[newton.iterations]);
    assert_true(newton.halvings > 0);
    for (int i = 0; i < newton.iterations; i++) assert_true(newton.residual[i + 1] < newton.residual[i]);
    stretched_clear(&b);
}

// A load under which linear bonds have a multiple of the stretch at which softening ones give way, and more force than
// saturating ones can have.
static void bonds_that_give_way_are_reported(void **state)
{
    (void)state;
    const steady s = {1, 12, 0.21, 1.0, PDMC_SPACE_CONTINUOUS, points};
    const pdmc_bond_law weak = {PDMC_LAW_SOFTENING, 0.7}, bounded = {PDMC_LAW_SATURATING, 0.7};
    for (int k = 0; k < 2; k++) {
        stretched b;
        pdmc_newton newton;
        stretched_create(&s, k ? &bounded : &weak, 1, &b);
        memset(b.u, 0, (size_t)b.at.space.count * sizeof *b.u);
        for (int i = 0; i < b.at.space.free_count; i++) b.force[i] = 8.0 / s.cells;
        CHECK_STATUS(pdmc_law_bonds_solve(b.bonds, b.force, b.u, &newton), PDMC_ERR_SINGULAR);
        assert_non_null(strstr(pdmc_last_error(), "iteration"));
        stretched_clear(&b);
    }
}

// ---- motion ----

// The largest distance from rest after many steps, started 1e-8 from it with some of every mode.
static double excursion(stretched *b, const pdmc_form *mass, const double rest[], double step, int steps)
{
    double most = 0.0, drift;
    const int n = b->at.space.count, free_count = b->at.space.free_count;
    double *u = pdmc_calloc((size_t)n, sizeof *u);
    for (int i = 0; i < n; i++) u[i] = rest[i] + (i < free_count ? 1e-8 * ((i * 7 % 11) / 11.0 - 0.5) : 0.0);
    CHECK_OK(pdmc_law_bonds_march(b->bonds, mass, b->force, step, steps, u, &drift));
    for (int i = 0; i < free_count; i++) most = fmax(most, isnan(u[i]) ? INFINITY : fabs(u[i] - rest[i]));
    pdmc_free(u);
    return most;
}

// The limit is that of the tangent where the body is: of bonds that have stiffened, far below that of linear ones.
static void the_stable_step_is_that_of_the_tangent(void **state)
{
    (void)state;
    const steady s = {1, 12, 0.2, 1.0, PDMC_SPACE_CONTINUOUS, points};
    for (int k = 1; k < LAWS; k++) {
        stretched b;
        pdmc_form tangent, linear, mass;
        pdmc_newton newton;
        double largest[2], error;
        stretched_create(&s, &laws[k], 1, &b);
        CHECK_OK(solve_wave(&b, &s, &laws[k], &newton));
        CHECK_OK(pdmc_form_mass(&b.at.space, &mass));
        CHECK_OK(pdmc_law_bonds_tangent(b.bonds, b.u, &tangent));
        CHECK_OK(pdmc_form_peridynamic(&b.at.space, &b.at.kernel, &points, 1, &linear));
        CHECK_OK(pdmc_form_largest_eigenvalue(&tangent, &mass, &largest[0], &error));
        CHECK_OK(pdmc_form_largest_eigenvalue(&linear, &mass, &largest[1], &error));
        const double step = pdmc_stable_step(largest[0]);
        print_message("  law %d: stable step %.4g, of linear bonds %.4g\n", laws[k].kind, step,
                      pdmc_stable_step(largest[1]));
        assert_true(excursion(&b, &mass, b.u, 0.99 * step, 300) < 1e-6); // 1e-8 and its share of the modes
        assert_true(excursion(&b, &mass, b.u, 1.02 * step, 300) > 1e-3); // e^(0.4 steps) in its mode
        if (laws[k].kind == PDMC_LAW_STIFFENING) {
            assert_true(step < 0.9 * pdmc_stable_step(largest[1]));
            assert_true(excursion(&b, &mass, b.u, 0.99 * pdmc_stable_step(largest[1]), 300) > 1e-3);
        }
        pdmc_form_clear(&tangent);
        pdmc_form_clear(&linear);
        pdmc_form_clear(&mass);
        stretched_clear(&b);
    }
}

// A body that is released: half the step, a quarter of the drift; and the same bits as the linear form where bonds are.
static void energy_is_kept_to_the_second_order_in_the_step(void **state)
{
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        const steady s = {1, 16, 0.2, 1.0, PDMC_SPACE_CONTINUOUS, points};
        double drift[2];
        for (int fine = 0; fine < 2; fine++) {
            stretched b;
            pdmc_form mass;
            stretched_create(&s, &laws[k], 1, &b);
            CHECK_OK(pdmc_form_mass(&b.at.space, &mass));
            for (int i = b.at.space.free_count; i < b.at.space.count; i++) b.u[i] = 0.0;
            for (int i = 0; i < b.at.space.free_count; i++) b.u[i] = gsl_pow_2(cos(M_PI * b.at.space.x[i]));
            CHECK_OK(pdmc_law_bonds_march(b.bonds, &mass, b.force, fine ? 0.01 : 0.02, fine ? 100 : 50, b.u, &drift[fine]));
            pdmc_form_clear(&mass);
            stretched_clear(&b);
        }
        print_message("  law %d: drift %.2e, %.2e\n", laws[k].kind, drift[0], drift[1]);
        CHECK_NEAR(log2(drift[0] / drift[1]), 2.0, 0.2);
        assert_true(drift[1] < 0.01);
    }
}

// The march of linear bonds is that of the form: the same sums in another order.
static void linear_bonds_move_as_the_form_does(void **state)
{
    (void)state;
    const steady s = {1, 12, 0.2, 1.0, PDMC_SPACE_CONTINUOUS, points};
    stretched b;
    pdmc_form form, mass;
    double drift;
    stretched_create(&s, &laws[0], 1, &b);
    const size_t n = (size_t)b.at.space.count;
    double *v = pdmc_calloc(n, sizeof *v);
    memcpy(v, b.u, n * sizeof *v);
    for (int i = 0; i < b.at.space.free_count; i++) b.force[i] = 0.1 * (i % 3);
    CHECK_OK(pdmc_form_peridynamic(&b.at.space, &b.at.kernel, &points, 1, &form));
    CHECK_OK(pdmc_form_mass(&b.at.space, &mass));
    CHECK_OK(pdmc_form_march(&form, &mass, (int)n, b.force, 0.02, 40, 0.0, v));
    CHECK_OK(pdmc_law_bonds_march(b.bonds, &mass, b.force, 0.02, 40, b.u, &drift));
    for (size_t i = 0; i < n; i++) CHECK_NEAR(b.u[i], v[i], 1e-11);
    pdmc_free(v);
    pdmc_form_clear(&form);
    pdmc_form_clear(&mass);
    stretched_clear(&b);
}

static pdmc_status make_and_solve(const setting *at)
{
    pdmc_status status = PDMC_OK;
    pdmc_law_bonds *bonds = NULL;
    pdmc_area_rule half = {0};
    pdmc_form mass = {0};
    pdmc_newton newton;
    double u[32] = {0}, load[32] = {0}, drift;
    u[at->space.count - 1] = 1.0;
    PDMC_TRY(pdmc_horizon_points(&at->kernel, &half));
    PDMC_TRY(pdmc_law_bonds_create(&at->space, &at->kernel, &laws[1], &points, 1, &bonds));
    PDMC_TRY(pdmc_law_bonds_solve(bonds, load, u, &newton));
    PDMC_TRY(pdmc_form_mass(&at->space, &mass));
    PDMC_TRY(pdmc_law_bonds_march(bonds, &mass, load, 0.01, 1, u, &drift));
done:
    pdmc_area_rule_clear(&half);
    pdmc_law_bonds_destroy(&bonds);
    pdmc_form_clear(&mass);
    return status;
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    const steady s = {1, 4, 0.3, 1.0, PDMC_SPACE_CONTINUOUS, points};
    const pdmc_form_rule exact = {PDMC_OUTER_EXACT, PDMC_INNER_POLYNOMIAL, 1}, inner = {PDMC_OUTER_GAUSS, 0, 1};
    const pdmc_bond_law none = {PDMC_LAW_SATURATING, 0.0};
    setting at;
    pdmc_law_bonds *bonds;
    setting_create(&s, &at);
    CHECK_STATUS(pdmc_law_bonds_create(&at.space, &at.kernel, &laws[1], &exact, 1, &bonds), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_law_bonds_create(&at.space, &at.kernel, &laws[1], &inner, 1, &bonds), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_law_bonds_create(&at.space, &at.kernel, &none, &points, 1, &bonds), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(make_and_solve(&at), );
    setting_clear(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_and_energies_belong_to_the_force),
        cmocka_unit_test(linear_bonds_have_the_operator_of_the_dispersion),
        cmocka_unit_test(the_operator_is_that_of_adaptive_rules),
        cmocka_unit_test(linear_bonds_have_the_forces_of_the_form),
        cmocka_unit_test(forces_are_derivatives_of_the_energy_and_tangents_of_the_forces),
        cmocka_unit_test(bonds_have_the_same_bits_on_any_number_of_threads),
        cmocka_unit_test(rest_converges_with_the_second_order),
        cmocka_unit_test(newtons_method_converges_quadratically),
        cmocka_unit_test(no_step_lengthens_the_residual),
        cmocka_unit_test(bonds_that_give_way_are_reported),
        cmocka_unit_test(the_stable_step_is_that_of_the_tangent),
        cmocka_unit_test(energy_is_kept_to_the_second_order_in_the_step),
        cmocka_unit_test(linear_bonds_move_as_the_form_does),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
