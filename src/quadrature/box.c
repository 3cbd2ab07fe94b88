// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

/// int_0^atan(end/side) (depth^2 + side^2 / cos^2 t)^(3/2) dt.
static double edge_integral(double depth, double side, double end)
{
    const double foot = hypot(depth, side), far = hypot(foot, end);
    return 0.5 * side * end * far + 0.5 * side * (3.0 * depth * depth + side * side) * asinh(end / foot) +
           depth * depth * depth * atan2(depth * end, side * far);
}

/// int of the distance from the centre dA over what a plane at distance `depth` > 0 from it cuts from a ball, within the
/// rectangle [0, side[0]] x [0, side[1]] about its foot.
static double face_integral(double radius, double depth, const double side[2])
{
    if (depth >= radius) return 0.0;
    const double squared = radius * radius - depth * depth;
    double arc = 0.5 * M_PI, cubes = 0.0;
    for (int k = 0; k < 2; k++) {
        const double end = fmin(side[1 - k], sqrt(fmax(0.0, squared - side[k] * side[k])));
        if (end == 0.0) continue;
        arc -= atan2(end, side[k]);
        cubes += edge_integral(depth, side[k], end);
    }
    return (cubes + pow(radius, 3) * fmax(0.0, arc) - pow(depth, 3) * 0.5 * M_PI) / 3.0;
}

/// Half the area of the unit sphere where x > a and y > b, a^2 + b^2 < 1 (Tovchigrechko & Vakser, Protein Science 10
/// (2001) 1572, for caps whose axes are at right angles).
static double half_lens(double a, double b)
{
    const double across_a = sqrt(1.0 - a * a), across_b = sqrt(1.0 - b * b);
    return M_PI - acos(-a * b / (across_a * across_b)) - a * acos(b / across_a) - b * acos(a / across_b);
}

/// Area of the sphere within [0, side[0]] x [0, side[1]] x [0, side[2]]. Three caps have no point in common unless the
/// whole box lies within the ball.
static double sphere_area(double radius, const double side[3])
{
    double unit[3], squared = 0.0, area = 0.5 * M_PI;
    for (int k = 0; k < 3; k++) {
        unit[k] = side[k] / radius;
        squared += unit[k] * unit[k];
    }
    if (squared <= 1.0) return 0.0;
    for (int k = 0; k < 3; k++) {
        const double a = unit[k], b = unit[(k + 1) % 3];
        if (a < 1.0) area -= 0.5 * M_PI * (1.0 - a);
        if (a * a + b * b < 1.0) area += half_lens(a, b);
    }
    return fmax(0.0, area) * radius * radius;
}

/// The ball within one octant of the box, by the theorem of Gauss: div(|x| x) = 4 |x|.
static double octant_integral(double radius, const double side[3])
{
    if (side[0] <= 0.0 || side[1] <= 0.0 || side[2] <= 0.0) return 0.0;
    double flux = radius * radius * sphere_area(radius, side);
    for (int k = 0; k < 3; k++) {
        const double across[2] = {side[(k + 1) % 3], side[(k + 2) % 3]};
        flux += side[k] * face_integral(radius, side[k], across);
    }
    return flux / 4.0;
}

double pdmc_integrate_distance_in_box(double radius, const double below[3], const double above[3])
{
    double sum = 0.0;
    for (int octant = 0; octant < 8; octant++) {
        double side[3];
        for (int k = 0; k < 3; k++) side[k] = fmin(octant >> k & 1 ? above[k] : below[k], 2.0 * radius);
        sum += octant_integral(radius, side);
    }
    return sum;
}
