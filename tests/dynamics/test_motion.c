// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/plate.h"

#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

// A spring of stiffness 1 and mass 1.
static pdmc_status spring_solve(const void *method, const double predicted[], double factor, double x[])
{
    const double kappa = *(const double *)method;
    x[0] = (kappa * predicted[0] + factor) / (kappa + 1.0);
    return PDMC_OK;
}

static double spring_product(const void *method, const double x[], const double y[])
{
    (void)method;
    return x[0] * y[0];
}

static double spring_work(const void *method, const double x[])
{
    (void)method;
    return x[0];
}

static void spring_keep(void *method)
{
    (void)method;
}

typedef struct {
    double error, balance;
    double damping;
} record;

// u(t) of x'' + d x' + x = t on [0, ..]: a ramp, so that the start is smooth.
static bool compare_spring(void *context, const pdmc_motion_state *s)
{
    record *r = context;
    const double d = r->damping, w = sqrt(1.0 - 0.25 * d * d), t = s->time;
    const double c = d, e = (0.5 * d * d - 1.0) / w;
    const double exact = t - d + exp(-0.5 * d * t) * (c * cos(w * t) + e * sin(w * t));
    r->error = fmax(r->error, fabs(s->x[0] - exact));
    r->balance = fmax(r->balance, fabs(s->work - s->kinetic - s->elastic - s->dissipated));
    return true;
}

// Second order in the step, with and without damping; the energy balances to rounding at any step.
static void the_integrator_is_of_second_order(void **state)
{
    (void)state;
    const double time[2] = {0.0, 100.0}, factor[2] = {0.0, 100.0};
    for (int k = 0; k < 2; k++) {
        record r[2];
        for (int i = 0; i < 2; i++) {
            const int steps = i ? 200 : 100;
            const pdmc_motion_options options = {1.0, k * 0.3, 10.0 / steps, steps, {2, time, factor}};
            double inertia = pdmc_motion_inertia(&options);
            const pdmc_motion_model model = {1,           spring_solve, spring_product, spring_product,
                                             spring_work, spring_keep,  &inertia};
            r[i] = (record){.damping = k * 0.3};
            CHECK_OK(pdmc_motion_run(&model, &options, compare_spring, &r[i]));
        }
        CHECK_NEAR(log2(r[0].error / r[1].error), 2.0, 0.1);
        for (int i = 0; i < 2; i++) CHECK_NEAR(r[i].balance, 0.0, 1e-10); // of a work of some 50, after 200 steps
    }
}

static void a_history_is_linear_between_its_points(void **state)
{
    (void)state;
    const double time[3] = {1.0, 2.0, 4.0}, factor[3] = {0.0, 1.0, -1.0};
    const pdmc_history h = {3, time, factor};
    const double at[6] = {0.0, 1.0, 1.25, 2.0, 3.0, 9.0}, want[6] = {0.0, 0.0, 0.25, 1.0, 0.0, -1.0};
    for (int i = 0; i < 6; i++) CHECK_NEAR(pdmc_history_at(&h, at[i]), want[i], 1e-15);
}

static void bad_options_are_refused(void **state)
{
    (void)state;
    const double time = 0.0, factor = 1.0;
    const pdmc_motion_model model = {0};
    pdmc_motion_options options = {1.0, 0.0, 0.0, 1, {1, &time, &factor}};
    CHECK_STATUS(pdmc_motion_run(&model, &options, NULL, NULL), PDMC_ERR_ARG);
    options.step = 0.1;
    options.damping = -1.0;
    CHECK_STATUS(pdmc_motion_run(&model, &options, NULL, NULL), PDMC_ERR_ARG);
    options.damping = 0.0;
    options.density = 0.0;
    CHECK_STATUS(pdmc_motion_run(&model, &options, NULL, NULL), PDMC_ERR_ARG);
}

// A bar along y between smooth walls, so that it is a plane wave of speed sqrt(3 mu / rho), held below and pulled
// above by a pulse. d'Alembert: v(y, t) = sum of the images of w(s) = int f / (rho c) dt, odd at the held end, even at
// the loaded one.
typedef struct {
    double speed, impedance, length, duration; // of wave, of bar, of pulse
    double *row;
    int unknowns;
    double error, largest, balance, work;
} bar;

static double pulse(double t, double duration)
{
    return t <= 0.0 || t >= duration ? 0.0 : pow(sin(pi * t / duration), 4);
}

// int_0^t of the pulse.
static double pulse_integral(double t, double duration)
{
    const double s = fmin(fmax(t, 0.0), duration), k = 2.0 * pi / duration;
    return 0.375 * s - 0.5 * sin(k * s) / k + 0.125 * sin(2.0 * k * s) / (2.0 * k);
}

static double exact_displacement(const bar *b, double y, double t) // y from the held end
{
    double sum = 0.0;
    for (int k = 0; k < 8; k++) {
        const double sign = k % 2 ? -1.0 : 1.0;
        sum += sign * (pulse_integral(t - ((2 * k + 1) * b->length - y) / b->speed, b->duration) -
                       pulse_integral(t - ((2 * k + 1) * b->length + y) / b->speed, b->duration));
    }
    return sum / b->impedance;
}

static bool compare_bar(void *context, const pdmc_motion_state *s)
{
    bar *b = context;
    for (int i = 0; i < 5; i++) {
        double v = 0.0;
        for (int j = 0; j < b->unknowns; j++) v += b->row[(2 * i + 1) * b->unknowns + j] * s->x[j];
        const double exact = exact_displacement(b, 0.2 * (i + 1) * b->length, s->time);
        b->error = fmax(b->error, fabs(v - exact));
        b->largest = fmax(b->largest, fabs(exact));
    }
    b->balance = fmax(b->balance, fabs(s->work - s->kinetic - s->elastic));
    b->work = fmax(b->work, fabs(s->work));
    return true;
}

static void run_bar(int cells, int steps, bar *b)
{
    enum { SAMPLES = 401 };
    static double time[SAMPLES], factor[SAMPLES];
    plate p;
    pdmc_kansa *kansa = NULL;
    pdmc_motion_model model;
    plate_make(&p, 1.0, cells, 0.02);
    const double mu = 0.375, duration = 1.0, total = 3.0;
    *b = (bar){.speed = sqrt(3.0 * mu), .length = 1.0, .duration = duration};
    b->impedance = b->speed; // rho c with rho = 1
    p.supports[0] = (pdmc_support){PDMC_SIDE_LEFT, {true, false}, {0, 0}};
    p.supports[1] = (pdmc_support){PDMC_SIDE_RIGHT, {true, false}, {0, 0}};
    p.supports[2] = (pdmc_support){PDMC_SIDE_BOTTOM, {false, true}, {0, 0}};
    p.problem.support_count = 3;
    plate_load(&p, PDMC_SIDE_TOP, 0.0, 1.0);
    for (int i = 0; i < SAMPLES; i++) {
        time[i] = total * i / (SAMPLES - 1);
        factor[i] = pulse(time[i], duration);
    }
    const pdmc_motion_options options = {1.0, 0.0, total / steps, steps, {SAMPLES, time, factor}};
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 2, &kansa));
    CHECK_OK(pdmc_kansa_motion(kansa, pdmc_motion_inertia(&options), &model));
    b->unknowns = model.unknowns;
    b->row = calloc(10 * (size_t)model.unknowns, sizeof *b->row);
    assert_non_null(b->row);
    for (int i = 0; i < 5; i++) {
        const double x[2] = {0.1, 0.2 * (i + 1) - 0.5};
        CHECK_OK(pdmc_kansa_motion_rows(kansa, x, x, &b->row[2 * i * model.unknowns]));
    }
    CHECK_OK(pdmc_motion_run(&model, &options, compare_bar, b));
    free(b->row);
    pdmc_motion_model_clear(&model);
    pdmc_kansa_destroy(&kansa);
}

static void a_wave_in_a_bar_follows_dalembert(void **state)
{
    (void)state;
    bar b[3];
    for (int i = 0; i < 3; i++) {
        run_bar(12, 40 << i, &b[i]);
        printf(
            "  wave in a bar, step %.4f: displacement off by %.2e of the largest, energy balance by %.1e of the work\n",
            3.0 / (40 << i), b[i].error / b[i].largest, b[i].balance / b[i].work);
    }
    for (int i = 0; i < 2; i++) CHECK_NEAR(log2(b[i].error / b[i + 1].error), 2.0, 0.3);
    for (int i = 0; i < 3; i++) assert_true(b[i].balance < 1e-7 * b[i].work); // rounding, at the condition of the basis
}

// A cracked plate that is pulled suddenly and damped comes to rest at the static displacement.
typedef struct {
    double *row;
    int unknowns;
    double last[2];
} probe;

static bool keep_last(void *context, const pdmc_motion_state *s)
{
    probe *p = context;
    for (int k = 0; k < 2; k++) {
        p->last[k] = 0.0;
        for (int j = 0; j < p->unknowns; j++) p->last[k] += p->row[k * p->unknowns + j] * s->x[j];
    }
    return true;
}

static void a_damped_plate_settles_at_the_static_displacement(void **state)
{
    (void)state;
    plate p;
    pdmc_kansa *kansa = NULL;
    pdmc_motion_model model;
    plate_make_cracked(&p, 0.5, 0.3, 16);
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 2, &kansa));
    const double time = 0.0, factor = 1.0;
    const pdmc_motion_options options = {1.0, 0.8, 0.25, 300, {1, &time, &factor}};
    CHECK_OK(pdmc_kansa_motion(kansa, pdmc_motion_inertia(&options), &model));
    probe b = {.unknowns = model.unknowns, .row = calloc(2 * (size_t)model.unknowns, sizeof(double))};
    assert_non_null(b.row);
    const double x[2] = {0.0, 0.0}, above[2] = {-0.01, 0.03};
    double static_displacement[2];
    CHECK_OK(pdmc_kansa_motion_rows(kansa, x, above, b.row));
    CHECK_OK(pdmc_kansa_displacement(kansa, x, above, static_displacement));
    CHECK_OK(pdmc_motion_run(&model, &options, keep_last, &b));
    printf("  a damped plate: face of the crack at %.6f, static %.6f\n", b.last[1], static_displacement[1]);
    CHECK_NEAR(b.last[1] / static_displacement[1], 1.0, 1e-3);
    free(b.row);
    pdmc_motion_model_clear(&model);
    pdmc_kansa_destroy(&kansa);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_history_is_linear_between_its_points),
        cmocka_unit_test(bad_options_are_refused),
        cmocka_unit_test(the_integrator_is_of_second_order),
        cmocka_unit_test(a_wave_in_a_bar_follows_dalembert),
        cmocka_unit_test(a_damped_plate_settles_at_the_static_displacement),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
