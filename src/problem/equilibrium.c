// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/problem.h"

#include "base/base_impl.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

// A rigid motion is (t_x, t_y, omega L) with L the plate's size: u = t_x - omega y, v = t_y + omega x.
static double size_of(const pdmc_plate *plate)
{
    return fmax(plate->width, plate->height);
}

// Ends of a side as multiples of half the plate's width and height.
static const double side_ends[4][2][2] = {
    [PDMC_SIDE_LEFT] = {{-1, -1}, {-1, 1}},
    [PDMC_SIDE_RIGHT] = {{1, -1}, {1, 1}},
    [PDMC_SIDE_BOTTOM] = {{-1, -1}, {1, -1}},
    [PDMC_SIDE_TOP] = {{-1, 1}, {1, 1}},
};

static void side_end(const pdmc_plate *plate, pdmc_side side, int end, double x[2])
{
    x[0] = 0.5 * plate->width * side_ends[side][end][0];
    x[1] = 0.5 * plate->height * side_ends[side][end][1];
}

// Adds the outer product of the rigid modes' displacement, one component at one end of a held side.
static void add_constraint(const pdmc_plate *plate, const double x[2], int component, double gram[9])
{
    const double size = size_of(plate);
    const double row[3] = {component == 0, component == 1, (component == 0 ? -x[1] : x[0]) / size};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) gram[3 * i + j] += row[i] * row[j];
}

pdmc_status pdmc_problem_free_motions(const pdmc_problem *problem, int *count, double motions[3][3])
{
    double gram[9] = {0}, eigenvalue[3];
    for (int s = 0; s < problem->support_count; s++) {
        for (int k = 0; k < 4; k++) {
            const int component = k / 2, end = k % 2;
            if (!problem->supports[s].held[component]) continue;
            double x[2];
            side_end(&problem->plate, problem->supports[s].side, end, x);
            add_constraint(&problem->plate, x, component, gram);
        }
    }
    const int info = LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', 3, gram, 3, eigenvalue);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dsyev returned %d", info);
    *count = 0;
    while (*count < 3 && eigenvalue[*count] < 1e-12) {
        memcpy(motions[*count], &gram[3 * *count], 3 * sizeof(double));
        motions[*count][2] /= size_of(&problem->plate);
        ++*count;
    }
    return PDMC_OK;
}

static pdmc_status check_given_loads(const pdmc_problem *problem)
{
    int count;
    double motions[3][3];
    const pdmc_status status = pdmc_problem_free_motions(problem, &count, motions);
    if (status != PDMC_OK) return status;
    double force[3] = {0}, magnitude = 0.0; // resultant and moment about the centre, per unit thickness
    for (int l = 0; l < problem->load_count; l++) {
        const pdmc_load *load = &problem->loads[l];
        double a[2], b[2];
        side_end(&problem->plate, load->side, 0, a);
        side_end(&problem->plate, load->side, 1, b);
        const double length = hypot(b[0] - a[0], b[1] - a[1]);
        const double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]);
        const double fx = length * load->traction[0], fy = length * load->traction[1];
        force[0] += fx;
        force[1] += fy;
        force[2] += x * fy - y * fx;
        magnitude += hypot(fx, fy);
    }
    for (int k = 0; k < count; k++) {
        double work = 0.0;
        for (int i = 0; i < 3; i++) work += motions[k][i] * force[i];
        if (fabs(work) > 1e-9 * magnitude)
            return pdmc_raise(
                PDMC_ERR_CONFIG,
                "the loads are not in equilibrium, resultant (%g, %g) and moment %g a unit of thickness act on a "
                "plate that is free to follow; balance the tractions or hold a side by supports",
                force[0], force[1], force[2]);
    }
    return PDMC_OK;
}

// The work of a traction on a side in a rigid motion at one point of it, per length.
static double power_at(const double x[2], const double motion[3], const double traction[2])
{
    return (motion[0] - motion[2] * x[1]) * traction[0] + (motion[1] + motion[2] * x[0]) * traction[1];
}

// Whether a traction on a side does no work on the free motions: in all, or for noise along it at every point. A motion is
// linear along the side, so that its ends and the mean of both say it.
static pdmc_status check_balance(const pdmc_problem *problem, pdmc_side side, const double traction[2], bool is_noise)
{
    int count;
    double motion[3][3], end[2][2];
    const pdmc_status status = pdmc_problem_free_motions(problem, &count, motion);
    const double negligible = 1e-9 * hypot(traction[0], traction[1]);
    for (int e = 0; e < 2; e++) side_end(&problem->plate, side, e, end[e]);
    for (int m = 0; m < count && status == PDMC_OK; m++) {
        const double power[2] = {power_at(end[0], motion[m], traction), power_at(end[1], motion[m], traction)};
        const double worst = is_noise ? fmax(fabs(power[0]), fabs(power[1])) : 0.5 * fabs(power[0] + power[1]);
        if (worst > negligible)
            return pdmc_raise(PDMC_ERR_CONFIG, "changes the load of one side of a plate that is free to follow, so that "
                                               "samples are not in equilibrium; hold the plate by supports");
    }
    return status;
}

static const pdmc_load *load_of(const pdmc_problem *problem, pdmc_side side)
{
    for (int l = 0; l < problem->load_count; l++) {
        const pdmc_load *load = &problem->loads[l];
        if (load->side == side && (load->traction[0] != 0.0 || load->traction[1] != 0.0)) return load;
    }
    return NULL;
}

// A load that is turned acts in both directions, of which none may be held.
static pdmc_status check_turned(const pdmc_problem *problem, const pdmc_load *load)
{
    if (pdmc_problem_uncertainty(problem, (pdmc_quantity)(PDMC_QUANTITY_LOAD_NOISE_LEFT + (int)load->side)))
        return pdmc_raise(PDMC_ERR_CONFIG, "turns a load that has noise along its side, one of the two must go");
    for (int s = 0; s < problem->support_count; s++)
        if (problem->supports[s].side == load->side)
            return pdmc_raise(PDMC_ERR_CONFIG, "turns a load into a direction in which a support holds the side");
    const double turned[2] = {-load->traction[1], load->traction[0]};
    return check_balance(problem, load->side, turned, false);
}

pdmc_status pdmc_problem_check_random_load(const pdmc_problem *problem, pdmc_quantity quantity)
{
    const bool is_noise = pdmc_is_of_sides(quantity, PDMC_QUANTITY_LOAD_NOISE_LEFT);
    const bool is_turned = pdmc_is_of_sides(quantity, PDMC_QUANTITY_LOAD_DIRECTION_LEFT);
    if (!is_noise && !is_turned && !pdmc_is_of_sides(quantity, PDMC_QUANTITY_LOAD_LEFT)) return PDMC_OK;
    const pdmc_quantity first = is_noise    ? PDMC_QUANTITY_LOAD_NOISE_LEFT
                                : is_turned ? PDMC_QUANTITY_LOAD_DIRECTION_LEFT
                                            : PDMC_QUANTITY_LOAD_LEFT;
    const pdmc_load *load = load_of(problem, (pdmc_side)(quantity - first));
    if (!load) return pdmc_raise(PDMC_ERR_CONFIG, "is of a side without a load, must be of one that has a traction");
    const pdmc_status status = check_balance(problem, load->side, load->traction, is_noise);
    return status == PDMC_OK && is_turned ? check_turned(problem, load) : status;
}

pdmc_status pdmc_problem_check_equilibrium(const pdmc_problem *problem)
{
    pdmc_status status = check_given_loads(problem);
    for (int k = 0; k < problem->uncertainty_count && status == PDMC_OK; k++)
        status = pdmc_problem_check_random_load(problem, problem->uncertainties[k].quantity);
    return status;
}
