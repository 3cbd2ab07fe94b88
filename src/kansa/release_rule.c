// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/release_rule.h"

#include "base/base_impl.h"
#include "kansa/weak_rows.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { SECTORS = 8, RADII = 10, ANGLES = 10, FEW_RADII = 4, FEW_ANGLES = 5, MOST_RINGS = 16 };
static const double first_ring = 2e-3, growth = 2.0, whole = 0.42, none = 0.82; // of the room
static const double smooth = 0.25; // of the length on which the stiffness varies: few points do on smaller rings

static double distance_to_crack(const pdmc_crack *crack, const double x[2])
{
    const double along[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]};
    const double square = along[0] * along[0] + along[1] * along[1];
    const double t = ((x[0] - crack->from[0]) * along[0] + (x[1] - crack->from[1]) * along[1]) / square;
    const double share = fmin(fmax(t, 0.0), 1.0);
    return hypot(x[0] - crack->from[0] - share * along[0], x[1] - crack->from[1] - share * along[1]);
}

// What moves holds neither the other tip nor a side nor another crack.
pdmc_moving_tip pdmc_moving_tip_of(const pdmc_problem *problem, int tip)
{
    const int number = problem->energy.tips[tip];
    const pdmc_crack *crack = &problem->cracks[number / 2];
    const double *end = number % 2 ? crack->to : crack->from, *other = number % 2 ? crack->from : crack->to;
    const double along[2] = {end[0] - other[0], end[1] - other[1]}, length = hypot(along[0], along[1]);
    double room = length;
    room = fmin(room, fmin(0.5 * problem->plate.width - fabs(end[0]), 0.5 * problem->plate.height - fabs(end[1])));
    for (int c = 0; c < problem->crack_count; c++)
        if (c != number / 2) room = fmin(room, distance_to_crack(&problem->cracks[c], end));
    return (pdmc_moving_tip){{end[0], end[1]}, {along[0] / length, along[1] / length}, room, 0.1 * room, 0.4 * room};
}

double pdmc_moving_tip_velocity(const pdmc_moving_tip *tip, const double x[2], double *derivative)
{
    const double d[2] = {x[0] - tip->at[0], x[1] - tip->at[1]}, r = hypot(d[0], d[1]);
    const double width = tip->outer - tip->inner, t = (r - tip->inner) / width;
    *derivative = 0.0;
    if (t <= 0.0) return 1.0;
    if (t >= 1.0) return 0.0;
    *derivative = -6.0 * t * (1.0 - t) / width * (d[0] * tip->along[0] + d[1] * tip->along[1]) / r;
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

// 1 up to `whole`, 0 from `none` on, with two continuous derivatives.
static double share_of_rings(const pdmc_moving_tip *tip, double r)
{
    const double t = (r / tip->room - whole) / (none - whole);
    if (t <= 0.0) return 1.0;
    return t >= 1.0 ? 0.0 : 1.0 - t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
}

static void add_point(pdmc_area_rule *rule, const double x[2], double weight)
{
    if (weight == 0.0) return;
    rule->x[2 * rule->count] = x[0];
    rule->x[2 * rule->count + 1] = x[1];
    rule->weight[rule->count++] = weight;
}

// A sector of a ring; the first one begins behind the tip, at a face of its crack.
static pdmc_status add_sector(const pdmc_moving_tip *tip, double from, double to, int sector, bool is_smooth,
                              pdmc_area_rule *rule)
{
    pdmc_status status = PDMC_OK;
    double r[RADII], radial[RADII], angle[ANGLES], angular[ANGLES];
    const double width = 2.0 * M_PI / SECTORS, begin = -M_PI + sector * width;
    const int radii = is_smooth ? FEW_RADII : RADII, angles = is_smooth ? FEW_ANGLES : ANGLES;
    PDMC_TRY(pdmc_gauss_legendre(radii, from, to, r, radial));
    PDMC_TRY(pdmc_gauss_legendre(angles, begin, begin + width, angle, angular));
    for (int i = 0; i < radii; i++)
        for (int j = 0; j < angles; j++) {
            const double c = cos(angle[j]), s = sin(angle[j]), *e = tip->along;
            const double x[2] = {tip->at[0] + r[i] * (c * e[0] - s * e[1]), tip->at[1] + r[i] * (c * e[1] + s * e[0])};
            add_point(rule, x, radial[i] * angular[j] * r[i] * share_of_rings(tip, r[i]));
        }
done:
    return status;
}

pdmc_status pdmc_release_rule(const pdmc_kansa *kansa, const pdmc_moving_tip *tip, double length, pdmc_area_rule *rule)
{
    pdmc_status status = PDMC_OK;
    pdmc_area_rule plate = {0};
    *rule = (pdmc_area_rule){0};
    PDMC_TRY(pdmc_weak_rule(kansa, &plate));
    const int most = plate.count + MOST_RINGS * SECTORS * RADII * ANGLES;
    PDMC_NEW(rule->x, 2 * most);
    PDMC_NEW(rule->weight, most);
    for (int p = 0; p < plate.count; p++) {
        const double r = hypot(plate.x[2 * p] - tip->at[0], plate.x[2 * p + 1] - tip->at[1]);
        add_point(rule, &plate.x[2 * p], plate.weight[p] * (1.0 - share_of_rings(tip, r)));
    }
    double from = 0.0;
    for (double to = first_ring; from < none; to *= growth) {
        for (int s = 0; s < SECTORS; s++)
            PDMC_TRY(add_sector(tip, from * tip->room, fmin(to, none) * tip->room, s, to * tip->room < smooth * length,
                                rule));
        from = fmin(to, none);
    }
done:
    pdmc_area_rule_clear(&plate);
    return status;
}
