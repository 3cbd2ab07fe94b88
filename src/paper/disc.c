// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/disc.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

// Gauss points of a panel, which is a quarter of the disc or less: K of polynomials up to degree 4 to rounding, and
// Legendre polynomials of degree 10 in the radius times a smooth field.
enum { ANGLES = 8, LENGTHS = 10 };
enum { PARTS_OF_PLATE = 4 + 4 + 8, PARTS_OF_CRACK = 4 };

pdmc_status pdmc_paper_disc_create(const pdmc_problem *problem, double horizon, pdmc_paper_disc *disc)
{
    pdmc_status status = PDMC_OK;
    const int parts = PARTS_OF_PLATE + PARTS_OF_CRACK * problem->crack_count + 1;
    *disc = (pdmc_paper_disc){.problem = problem, .horizon = horizon, .most_bonds = parts * ANGLES * LENGTHS};
    PDMC_NEW(disc->part, parts);
    PDMC_NEW(disc->bond, disc->most_bonds);
done:
    if (status != PDMC_OK) pdmc_paper_disc_clear(disc);
    return status;
}

void pdmc_paper_disc_clear(pdmc_paper_disc *disc)
{
    pdmc_free(disc->part);
    pdmc_free(disc->bond);
    *disc = (pdmc_paper_disc){0};
}

// Distance along the ray from x to the segment, infinite where it misses.
static double distance_to_crack(const pdmc_crack *crack, const double x[2], const double e[2])
{
    const double along[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]};
    const double start[2] = {crack->from[0] - x[0], crack->from[1] - x[1]};
    const double cross = e[0] * along[1] - e[1] * along[0];
    if (cross == 0.0) return INFINITY;
    const double distance = (start[0] * along[1] - start[1] * along[0]) / cross;
    const double share = (start[0] * e[1] - start[1] * e[0]) / cross;
    return distance >= 0.0 && 0.0 <= share && share <= 1.0 ? distance : INFINITY;
}

double pdmc_paper_reach(const pdmc_problem *problem, double horizon, const double x[2], const double direction[2])
{
    const double half[2] = {0.5 * problem->plate.width, 0.5 * problem->plate.height};
    double reach = horizon;
    for (int k = 0; k < 2; k++) {
        if (direction[k] == 0.0) continue;
        const double edge = copysign(half[k], direction[k]);
        reach = fmin(reach, fmax((edge - x[k]) / direction[k], 0.0));
    }
    for (int c = 0; c < problem->crack_count; c++)
        reach = fmin(reach, distance_to_crack(&problem->cracks[c], x, direction));
    return reach;
}

static void add_part(pdmc_paper_disc *disc, int *parts, double dx, double dy)
{
    const double theta = atan2(dy, dx);
    disc->part[(*parts)++] = theta < 0.0 ? theta + 2.0 * M_PI : theta;
}

// The two points of the circle on the line through x + (px, py) along the unit vector (tx, ty), where they lie between
// `from` and `to` along it.
static void add_circle_crossings(pdmc_paper_disc *disc, int *parts, const double p[2], const double t[2], double length)
{
    const double along = p[0] * t[0] + p[1] * t[1], off2 = p[0] * p[0] + p[1] * p[1] - along * along;
    if (!(off2 < disc->horizon * disc->horizon)) return;
    const double half = sqrt(disc->horizon * disc->horizon - off2);
    for (int sign = -1; sign <= 1; sign += 2) {
        const double s = sign * half - along;
        if (0.0 < s && s < length) add_part(disc, parts, p[0] + s * t[0], p[1] + s * t[1]);
    }
}

static void add_segment(pdmc_paper_disc *disc, int *parts, const double x[2], const double from[2], const double to[2])
{
    const double p[2] = {from[0] - x[0], from[1] - x[1]}, d[2] = {to[0] - from[0], to[1] - from[1]};
    const double length = hypot(d[0], d[1]), t[2] = {d[0] / length, d[1] / length};
    add_circle_crossings(disc, parts, p, t, length);
}

static void add_plate(pdmc_paper_disc *disc, int *parts, const double x[2])
{
    const double w = 0.5 * disc->problem->plate.width, h = 0.5 * disc->problem->plate.height;
    const double corner[4][2] = {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
    for (int k = 0; k < 4; k++) {
        add_part(disc, parts, corner[k][0] - x[0], corner[k][1] - x[1]);
        add_segment(disc, parts, x, corner[k], corner[(k + 1) % 4]);
    }
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The directions that part the panels, ascending, from 0 to 2 pi.
static int find_parts(pdmc_paper_disc *disc, const double x[2])
{
    int parts = 0;
    for (int quarter = 0; quarter <= 3; quarter++) disc->part[parts++] = 0.5 * M_PI * quarter;
    add_plate(disc, &parts, x);
    for (int c = 0; c < disc->problem->crack_count; c++) {
        const pdmc_crack *crack = &disc->problem->cracks[c];
        add_part(disc, &parts, crack->from[0] - x[0], crack->from[1] - x[1]);
        add_part(disc, &parts, crack->to[0] - x[0], crack->to[1] - x[1]);
        add_segment(disc, &parts, x, crack->from, crack->to);
    }
    disc->part[parts++] = 2.0 * M_PI;
    qsort(disc->part, (size_t)parts, sizeof *disc->part, ascending);
    return parts;
}

static void add_ray(pdmc_paper_disc *disc, const double x[2], double theta, double weight, const double r[],
                    const double w[])
{
    const double direction[2] = {cos(theta), sin(theta)};
    const double reach = pdmc_paper_reach(disc->problem, disc->horizon, x, direction);
    if (reach == 0.0) return;
    for (int i = 0; i < LENGTHS; i++)
        disc->bond[disc->count++] =
            (pdmc_paper_bond){reach * r[i], {direction[0], direction[1]}, weight * reach * w[i]};
}

pdmc_status pdmc_paper_disc_cut(pdmc_paper_disc *disc, const double x[2])
{
    double r[LENGTHS], w[LENGTHS], theta[ANGLES], weight[ANGLES];
    pdmc_status status = pdmc_gauss_legendre(LENGTHS, 0.0, 1.0, r, w);
    const int parts = find_parts(disc, x);
    disc->count = 0;
    for (int p = 0; p + 1 < parts && status == PDMC_OK; p++) {
        if (disc->part[p + 1] - disc->part[p] < 1e-12) continue;
        status = pdmc_gauss_legendre(ANGLES, disc->part[p], disc->part[p + 1], theta, weight);
        for (int j = 0; j < ANGLES && status == PDMC_OK; j++) add_ray(disc, x, theta[j], weight[j], r, w);
    }
    return status;
}
