// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/relaxation.h"

#include "check.h"

#include <gsl/gsl_math.h>
#include <limits.h>
#include <string.h>

enum { CHAIN = 40 };

/// Springs of stiffness 1 in a row, the first held, the last pulled by 1: u_i = i.
static pdmc_status chain(void *context, const double x[], double force[])
{
    (void)context;
    for (int i = 0; i < CHAIN; i++) {
        const double left = i ? x[i] - x[i - 1] : 0.0, right = i + 1 < CHAIN ? x[i + 1] - x[i] : 1.0;
        force[i] = right - left;
    }
    return PDMC_OK;
}

static void chain_masses(double mass[CHAIN])
{
    for (int i = 0; i < CHAIN; i++) mass[i] = 0.25 * 1.21 * 4.0; // the row's sum is 4; a step of 1.1 is stable too
    mass[0] = INFINITY;
}

static int steps_with(double damping)
{
    double mass[CHAIN], x[CHAIN] = {0.0};
    chain_masses(mass);
    const pdmc_relaxation_model model = {CHAIN, chain, NULL, mass};
    const pdmc_relaxation_options options = {1.0, 1e-9, 20000, damping};
    pdmc_relaxation_state state;
    CHECK_OK(pdmc_relax(&model, &options, x, NULL, NULL, &state));
    for (int i = 0; i < CHAIN; i++) CHECK_NEAR(x[i], i, 1e-9 * CHAIN * CHAIN); // |K^-1| < n^2
    assert_true(state.residual <= 1e-9);
    return state.steps;
}

/// Adaptive damping needs no guess: fewer steps than with any constant damping, of which the best is tried for about the
/// one that is critical for the lowest mode, c = 2 w with w^2 = 4 sin^2(pi / 4 / (n - 1/2)) / m.
static void adapts(void **state)
{
    (void)state;
    const double critical = 2.0 * 2.0 * sin(M_PI / 4.0 / (CHAIN - 0.5)) / sqrt(1.21);
    const int adaptive = steps_with(-1.0);
    int best = INT_MAX;
    for (double factor = 0.7; factor < 1.3; factor += 0.04) best = (int)fmin(best, steps_with(factor * critical));
    print_message("steps: adaptive %d, best constant %d\n", adaptive, best);
    assert_true(adaptive < best);
}

static pdmc_status stiff_spring(void *context, const double x[], double force[])
{
    force[0] = *(double *)context * (1.0 - x[0]);
    return PDMC_OK;
}

/// A mass is stable up to a stiffness of 4 times itself, also where every other step swings back and the motion begins anew.
static void stiffest_mode(void **unused)
{
    (void)unused;
    double mass = 1.0, stiffness = 3.9, x = 0.0;
    const pdmc_relaxation_model model = {1, stiff_spring, &stiffness, &mass};
    const pdmc_relaxation_options options = {1.0, 1e-9, 1000, -1.0};
    pdmc_relaxation_state state;
    CHECK_OK(pdmc_relax(&model, &options, &x, NULL, NULL, &state));
    CHECK_NEAR(x, 1.0, 1e-9);
}

static bool stop_at_five(void *context, const pdmc_relaxation_state *state)
{
    *(int *)context = state->steps;
    return state->steps < 5;
}

static void failures(void **unused)
{
    (void)unused;
    double mass[CHAIN], x[CHAIN] = {0.0};
    chain_masses(mass);
    const pdmc_relaxation_model model = {CHAIN, chain, NULL, mass};
    pdmc_relaxation_options options = {1.0, 1e-9, 10, -1.0};
    pdmc_relaxation_state state;
    CHECK_STATUS(pdmc_relax(&model, &options, x, NULL, NULL, &state), PDMC_ERR_SINGULAR);
    assert_int_equal(state.steps, 10);
    assert_non_null(strstr(pdmc_last_error(), "after 10 steps"));
    int seen = 0;
    CHECK_STATUS(pdmc_relax(&model, &options, x, stop_at_five, &seen, &state), PDMC_ERR_INTERRUPTED);
    assert_int_equal(seen, 5);
    options.tolerance = 0.0;
    CHECK_STATUS(pdmc_relax(&model, &options, x, NULL, NULL, &state), PDMC_ERR_ARG);
    options = (pdmc_relaxation_options){1.0, 1e-9, 20000, -1.0};
    for (int i = 0; i < CHAIN; i++) mass[i] *= 0.2; // below Gerschgorin's: the motion grows
    CHECK_STATUS(pdmc_relax(&model, &options, x, NULL, NULL, &state), PDMC_ERR_SINGULAR);
    mass[3] = 0.0;
    CHECK_STATUS(pdmc_relax(&model, &options, x, NULL, NULL, &state), PDMC_ERR_ARG);
}

static void memory(void **unused)
{
    (void)unused;
    double mass[CHAIN], x[CHAIN] = {0.0};
    chain_masses(mass);
    const pdmc_relaxation_model model = {CHAIN, chain, NULL, mass};
    const pdmc_relaxation_options options = {1.0, 1e-3, 20000, -1.0};
    pdmc_relaxation_state state;
    CHECK_FAILS_CLEANLY(pdmc_relax(&model, &options, x, NULL, NULL, &state), );
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(adapts), cmocka_unit_test(stiffest_mode),
                                       cmocka_unit_test(failures), cmocka_unit_test(memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
