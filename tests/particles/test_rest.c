// SPDX-License-Identifier: GPL-3.0-or-later

/// Bodies that are brought to rest: against the stiffness of all bonds and LAPACK's solution; one bond in closed form; bonds
/// that break, the balance of energy; what cannot come to rest.

#include "particles/particles_impl.h"

#include "particles/bodies.h"

#include <lapacke.h>

enum { MOST_NODES = 108, MOST_UNKNOWNS = 3 * MOST_NODES };

static const double ramp_time[] = {0.0, 1.0};

/// A crack that ends in a body, at y = `height` from the left to x = `tip`, where no bond meets its end.
typedef struct {
    double height, tip;
} notch;

/// A box that is held in its lowest layers and is moved or pulled in its highest, each of three nodes.
typedef struct {
    specimen s;
    notch notch;
    pdmc_planar_crack crack;
    pdmc_layer_condition conditions[2];
} test_piece;

static void make_piece(test_piece *t, int dimension, const int count[], pdmc_condition_kind kind, double value)
{
    make_box(&t->s, dimension, count);
    t->notch = (notch){0.5 * (count[1] - 1), 0.5 * count[0] - 0.7};
    t->crack = (pdmc_planar_crack){
        .kind = PDMC_CRACK_SEGMENT, .from = {-1.0, t->notch.height}, .to = {t->notch.tip, t->notch.height}};
    const pdmc_history history = {2, ramp_time, ramp_time};
    t->conditions[0] = (pdmc_layer_condition){
        .kind = PDMC_CONDITION_DISPLACEMENT, .along = {true, true, dimension == 3}, .history = history};
    t->conditions[1] = (pdmc_layer_condition){
        .kind = kind, .along = {false, true, false}, .value = {0.0, value, 0.0}, .history = history};
    for (int k = 0; k < 2; k++) t->conditions[k].region = t->s.body.shape;
    t->conditions[0].region.to[1] = 2.0;
    t->conditions[1].region.from[1] = count[1] - 3.0;
    t->s.options.crack_count = 1;
    t->s.options.cracks = &t->crack;
    t->s.options.condition_count = 2;
    t->s.options.conditions = t->conditions;
}

static pdmc_rest rest_at(pdmc_particles *p, double load, double tolerance, double damping)
{
    pdmc_rest rest;
    const pdmc_rest_options options = {.tolerance = tolerance, .most_steps = 20000, .damping = damping};
    CHECK_OK(pdmc_particles_come_to_rest(p, load, &options, &rest));
    assert_true(rest.residual <= tolerance);
    CHECK_NEAR(pdmc_particles_time(p), load, 0.0);
    return rest;
}

static bool is_cut(const notch *n, const double a[3], const double b[3])
{
    if ((a[1] - n->height) * (b[1] - n->height) > 0.0) return false;
    return a[0] + (n->height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) < n->tip;
}

/// The linear answer: sum of c V^2 xi xi^T / |xi|^3 of all bonds within the horizon of 3, and unit rows where nodes are held.
static void solve_directly(const test_piece *t, int nodes, const double x[], double u[])
{
    static double k[MOST_UNKNOWNS * MOST_UNKNOWNS];
    const int dimension = t->s.options.dimension, n = dimension * nodes;
    memset(k, 0, sizeof k);
    for (int i = 0; i < nodes; i++)
        for (int j = 0; j < nodes; j++) {
            double xi[3], square = 0.0;
            for (int a = 0; a < 3; a++) xi[a] = x[3 * j + a] - x[3 * i + a], square += xi[a] * xi[a];
            if (i == j || square > 9.0 || is_cut(&t->notch, &x[3 * i], &x[3 * j])) continue;
            for (int a = 0; a < dimension; a++)
                for (int b = 0; b < dimension; b++) {
                    const double part = t->s.material.micromodulus * xi[a] * xi[b] / (square * sqrt(square));
                    k[(dimension * i + a) * n + dimension * i + b] += part;
                    k[(dimension * i + a) * n + dimension * j + b] -= part;
                }
        }
    for (int i = 0; i < n; i++) u[i] = 0.0;
    for (int c = 0; c < 2; c++) {
        const pdmc_layer_condition *condition = &t->conditions[c];
        for (int i = 0; i < nodes; i++)
            for (int a = 0; a < dimension; a++) {
                if (!condition->along[a] || x[3 * i + 1] < condition->region.from[1] ||
                    x[3 * i + 1] > condition->region.to[1])
                    continue;
                const int row = dimension * i + a;
                u[row] = condition->value[a];
                if (condition->kind == PDMC_CONDITION_FORCE) continue;
                for (int m = 0; m < n; m++) k[row * n + m] = m == row;
            }
    }
    int pivots[MOST_UNKNOWNS];
    assert_int_equal(LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, k, n, pivots, u, 1), 0);
}

/// With linear stretch to the tolerance, times what the stiffness' condition may make of it; in full the difference falls with
/// the load.
static void rest_is_the_solution_of_the_stiffness(void **state)
{
    (void)state;
    const struct {
        int dimension, count[3];
        pdmc_condition_kind kind;
        bool linear;
        double value, tolerance;
    } cases[] = {
        {2, {10, 10, 1}, PDMC_CONDITION_DISPLACEMENT, true, 0.1, 1e-7},
        {2, {9, 12, 1}, PDMC_CONDITION_FORCE, true, 0.001, 1e-7},
        {3, {3, 10, 3}, PDMC_CONDITION_FORCE, true, 0.001, 1e-7},
        {2, {10, 10, 1}, PDMC_CONDITION_DISPLACEMENT, false, 1e-6, 1e-5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        test_piece t;
        double x[3 * MOST_NODES], u[3 * MOST_NODES], wanted[MOST_UNKNOWNS], error = 0.0, most = 0.0;
        make_piece(&t, cases[i].dimension, cases[i].count, cases[i].kind, cases[i].value);
        t.s.options.linear_stretch = cases[i].linear;
        pdmc_particles *p = create(&t.s);
        const int n = pdmc_particles_count(p);
        const pdmc_rest rest = rest_at(p, 1.0, 1e-9, -1.0);
        pdmc_particles_reference(p, x, NULL);
        pdmc_particles_state(p, u, NULL, NULL);
        solve_directly(&t, n, x, wanted);
        for (int k = 0; k < n; k++)
            for (int a = 0; a < cases[i].dimension; a++) {
                const double value = wanted[k * cases[i].dimension + a];
                error = fmax(error, fabs(u[3 * k + a] - value));
                most = fmax(most, fabs(value));
            }
        print_message("  %d nodes: %d steps, off by %.1e of the largest displacement\n", n, rest.steps, error / most);
        CHECK_NEAR(error / most, 0.0, cases[i].tolerance);
        pdmc_particles_destroy(p);
    }
}

/// What is prescribed is balanced by the reaction, and half of its work is elastic.
static void reactions_balance_forces(void **state)
{
    (void)state;
    test_piece t;
    double force[6], displacement[6];
    make_piece(&t, 2, (int[]){9, 12, 1}, PDMC_CONDITION_FORCE, 0.001);
    t.s.options.linear_stretch = true;
    pdmc_particles *p = create(&t.s);
    for (int k = 0; k <= 2; k++) rest_at(p, 0.5 * k, 1e-8, -1.0);
    pdmc_particles_conditions(p, force, displacement);
    const pdmc_particles_sums sums = pdmc_particles_sum(p);
    CHECK_NEAR(force[4], 27 * 0.001, 1e-15);
    CHECK_NEAR(force[1], -force[4], 1e-7 * force[4]);
    CHECK_NEAR(sums.work, 0.5 * force[4] * displacement[4], 1e-7 * sums.work);
    CHECK_NEAR(sums.elastic, sums.work, 1e-6 * sums.work);
    CHECK_NEAR(sums.kinetic + sums.fracture + sums.dissipated, 0.0, 0.0);
    pdmc_particles_destroy(p);
}

/// Underwood's damping needs no guess: it takes at most a few steps more than the best of constant dampings, and far fewer
/// than those that are a factor of four off.
static void adaptive_damping_is_near_the_best(void **state)
{
    (void)state;
    int steps[5], best = 1 << 30;
    test_piece t;
    make_piece(&t, 2, (int[]){16, 16, 1}, PDMC_CONDITION_DISPLACEMENT, 0.1);
    for (int k = 0; k < 5; k++) {
        pdmc_particles *p = create(&t.s);
        steps[k] = rest_at(p, 1.0, 1e-6, k == 0 ? -1.0 : 1.28 / (1 << k)).steps;
        if (k > 0 && steps[k] < best) best = steps[k];
        print_message("  damping %s %.3f: %d steps\n", k == 0 ? "adaptive" : "", k == 0 ? NAN : 1.28 / (1 << k),
                      steps[k]);
        pdmc_particles_destroy(p);
    }
    assert_true(steps[0] <= 1.2 * best);
    assert_true(2 * steps[0] < steps[1]);
}

/// A bond between two nodes: F = c V^2 s up to s_0 = 0.02, and nothing after; its energy is c V^2 s^2 / 2 at the load at which
/// it broke.
static void one_bond_in_closed_form(void **state)
{
    (void)state;
    specimen s;
    make_box(&s, 2, (int[]){2, 1, 1});
    s.material.critical_stretch = 0.02;
    const double c = s.material.micromodulus;
    pdmc_layer_condition ends[2] = {{.kind = PDMC_CONDITION_DISPLACEMENT, .along = {true, true, false}},
                                    {.kind = PDMC_CONDITION_DISPLACEMENT,
                                     .region = {.kind = PDMC_SHAPE_BOX, .from = {1, 0, 0}, .to = {1, 0, 0}},
                                     .along = {true, true, false},
                                     .value = {0.05, 0.0, 0.0},
                                     .history = {2, ramp_time, ramp_time}}};
    s.options.condition_count = 2;
    s.options.conditions = ends;
    pdmc_particles *p = create(&s);
    for (int k = 0; k <= 10; k++) {
        double force[6], displacement[6];
        const pdmc_rest rest = rest_at(p, 0.1 * k, 1e-6, -1.0);
        const double stretch = 0.005 * k;
        const bool whole = k < 5; // s_0 is exceeded at 0.025, and not at 0.02, but for rounding
        if (k == 4) continue;
        pdmc_particles_conditions(p, force, displacement);
        const pdmc_particles_sums sums = pdmc_particles_sum(p);
        CHECK_NEAR(displacement[3], stretch, 1e-15);
        CHECK_NEAR(force[3], whole ? c * stretch : 0.0, 1e-14 * c);
        CHECK_NEAR(force[0], -force[3], 1e-14 * c);
        CHECK_NEAR(sums.elastic, whole ? 0.5 * c * stretch * stretch : 0.0, 1e-15 * c);
        if (k == 5 && rest.breakages == 1) CHECK_NEAR(sums.fracture, 0.5 * c * 0.025 * 0.025, 1e-15 * c);
        if (k > 5) assert_int_equal(sums.broken, 1);
        CHECK_NEAR(sums.elastic + sums.fracture + sums.dissipated, sums.work, 1e-14 * c);
    }
    pdmc_particles_destroy(p);
}

typedef struct {
    double balance; // over the work
    pdmc_particles_sums sums;
    int breakages;
} torn;

static torn tear(int loads, double strengthening, int threads, double u[])
{
    torn result = {0};
    test_piece t;
    make_piece(&t, 2, (int[]){20, 20, 1}, PDMC_CONDITION_DISPLACEMENT, 0.2);
    t.s.options.volume_rule = PDMC_VOLUME_PARTIAL;
    t.s.options.threads = threads;
    t.s.material.critical_stretch = 0.02;
    t.s.material.strengthening = strengthening;
    pdmc_particles *p = create(&t.s);
    for (int k = 0; k <= loads; k++) {
        result.breakages += rest_at(p, (double)k / loads, 1e-6, -1.0).breakages;
        result.sums = pdmc_particles_sum(p);
        const pdmc_particles_sums *e = &result.sums;
        result.balance = fmax(result.balance, fabs(e->elastic + e->fracture + e->dissipated - e->work));
    }
    result.balance /= result.sums.work;
    if (u) pdmc_particles_state(p, u, NULL, NULL);
    pdmc_particles_find_bond_forces(p, false); // nothing breaks any more
    CHECK_NEAR(pdmc_particles_sum(p).fracture, result.sums.fracture, 0.0);
    pdmc_particles_destroy(p);
    return result;
}

/// A notched plate that is torn apart. What is off in the balance is the trapezoidal rule's: of the second order in the loads.
static void tearing_keeps_the_balance(void **state)
{
    (void)state;
    const torn coarse = tear(4, 0.0, 1, NULL), fine = tear(8, 0.0, 1, NULL);
    print_message("  4 loads: %d breakages, %d bonds, balance %.1e; 8 loads: %d, %d, %.1e\n", coarse.breakages,
                  (int)coarse.sums.broken, coarse.balance, fine.breakages, (int)fine.sums.broken, fine.balance);
    assert_true(coarse.breakages > 5 && fine.breakages > 5);
    assert_true(fine.sums.dissipated > 0.0 && fine.sums.fracture > 0.1 * fine.sums.work);
    assert_true(coarse.balance < 1e-3);
    CHECK_NEAR(fine.balance / coarse.balance, 0.25, 0.1);
}

static void threads_change_no_bit(void **state)
{
    (void)state;
    double u[3][3 * 400];
    torn result[3];
    for (int k = 0; k < 3; k++) result[k] = tear(3, 0.25, k + 1, u[k]);
    for (int k = 1; k < 3; k++) {
        assert_memory_equal(u[0], u[k], sizeof u[0]);
        assert_memory_equal(&result[0], &result[k], sizeof result[0]);
    }
}

static bool stop(void *context, int steps)
{
    *(int *)context = steps;
    return steps < 40;
}

/// Too few steps, a node without bonds under a force, an interruption, and what has no rest.
static void what_does_not_come_to_rest_is_said(void **state)
{
    (void)state;
    test_piece t;
    pdmc_rest rest;
    int steps = 0;
    make_piece(&t, 2, (int[]){10, 10, 1}, PDMC_CONDITION_DISPLACEMENT, 0.1);
    pdmc_rest_options options = {.tolerance = 1e-6, .most_steps = 5, .damping = -1.0};
    pdmc_particles *p = create(&t.s);
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 0.5, &options, &rest), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "load 0.5: not at rest after 5 steps of relaxation, the residual is "));
    assert_true(rest.residual > 1e-6 && rest.steps == 5);
    options =
        (pdmc_rest_options){.tolerance = 1e-6, .most_steps = 5000, .damping = -1.0, .go_on = stop, .context = &steps};
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 0.5, &options, &rest), PDMC_ERR_INTERRUPTED);
    assert_in_range(steps, 40, 60);
    options.tolerance = 0.0;
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 0.5, &options, &rest), PDMC_ERR_ARG);
    options.tolerance = 1e-6;
    CHECK_OK(pdmc_particles_advance(p, 1));
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 0.5, &options, &rest), PDMC_ERR_ARG);
    pdmc_particles_destroy(p);

    specimen s;
    make_box(&s, 2, (int[]){1, 1, 1});
    pdmc_layer_condition pull = {.kind = PDMC_CONDITION_FORCE, .along = {true}, .value = {1.0}};
    s.options.condition_count = 1;
    s.options.conditions = &pull;
    p = create(&s);
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 1.0, &options, &rest), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "a force acts on a node that no bond holds"));
    pdmc_particles_destroy(p);
    make_box(&s, 2, (int[]){4, 1, 1});
    pull.value[0] = 1e200; // of which the square is no number any more, and all would be 0 beside it
    pull.region.from[0] = pull.region.to[0] = 3.0;
    pull.history = (pdmc_history){2, ramp_time, ramp_time};
    s.options.condition_count = 1;
    s.options.conditions = &pull;
    p = create(&s);
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 1.0, &options, &rest), PDMC_ERR_SINGULAR);
    assert_string_equal(pdmc_last_error(), "load 1: the force on the node at (3, 0, 0) is too large or not a number");
    pdmc_particles_destroy(p);
    pull.kind = PDMC_CONDITION_VELOCITY;
    pull.value[0] = 1.0;
    p = create(&s);
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 1.0, &options, &rest), PDMC_ERR_ARG);
    pdmc_particles_destroy(p);
    s.options.condition_count = 0;
    s.options.precision = PDMC_PRECISION_SINGLE;
    p = create(&s);
    CHECK_STATUS(pdmc_particles_come_to_rest(p, 1.0, &options, &rest), PDMC_ERR_ARG);
    pdmc_particles_destroy(p);
}

static pdmc_status rest_once(const specimen *s, pdmc_particles **p)
{
    const pdmc_rest_options options = {.tolerance = 1e-3, .most_steps = 1000, .damping = -1.0};
    pdmc_rest rest;
    const pdmc_status status = pdmc_particles_create(&s->options, p);
    return status == PDMC_OK ? pdmc_particles_come_to_rest(*p, 1.0, &options, &rest) : status;
}

static pdmc_status rest_or_drop(const specimen *s, pdmc_particles **p)
{
    const pdmc_status status = rest_once(s, p);
    if (status != PDMC_OK) pdmc_particles_destroy(*p);
    return status;
}

static void no_memory_is_said(void **state)
{
    (void)state;
    test_piece t;
    pdmc_particles *p = NULL;
    make_piece(&t, 2, (int[]){4, 7, 1}, PDMC_CONDITION_DISPLACEMENT, 0.01);
    t.s.options.crack_count = 0;
    CHECK_FAILS_CLEANLY(rest_or_drop(&t.s, &p), pdmc_particles_destroy(p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rest_is_the_solution_of_the_stiffness),
        cmocka_unit_test(reactions_balance_forces),
        cmocka_unit_test(adaptive_damping_is_near_the_best),
        cmocka_unit_test(one_bond_in_closed_form),
        cmocka_unit_test(tearing_keeps_the_balance),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(what_does_not_come_to_rest_is_said),
        cmocka_unit_test(no_memory_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
