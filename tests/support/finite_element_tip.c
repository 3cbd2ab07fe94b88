// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/finite_element_impl.h"

#include <complex.h>
#include <math.h>

/// What the integrals ask of one Gauss point. Symmetric tensors are [xx, yy, xy].
typedef struct {
    double z[2]; // from the tip, in its frame: x ahead
    double area;
    double modulus, modulus_slope;  // M and M,1
    double strain[3], stress[3];    // of the tip's frame as of the plate's: they differ by half a turn
    double slope[2];                // u,1
    double weight, weight_slope[2]; // q and its gradient
} point;

/// The homogeneous field of a tip with K = 1 in one mode.
typedef struct {
    double stress[3], stress_slope[3]; // sigma and sigma,1
    double slope[2];                   // 2 mu u,1
} tip_field;

typedef double integrand(const finite_element_solution *s, const point *p, const void *context);

static double contract(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + 2.0 * a[2] * b[2];
}

// (sigma . n)_i v_i
static double traction_times(const double stress[3], const double n[2], const double v[2])
{
    return (stress[0] * n[0] + stress[2] * n[1]) * v[0] + (stress[2] * n[0] + stress[1] * n[1]) * v[1];
}

// 1 at the tip and 0 from the sides of the square on, with continuous slopes.
static double domain_weight(const double z[2], double radius)
{
    double q = 1.0;
    for (int d = 0; d < 2; d++) {
        const double s = fmin(fabs(z[d]) / radius, 1.0), inside = 1.0 - s * s;
        q *= inside * inside;
    }
    return q;
}

static double direction_of(int tip)
{
    return tip ? 1.0 : -1.0;
}

// q at the nodes of an element; false if it vanishes there.
static bool weigh_nodes(const finite_element_solution *s, const finite_element *element, int tip, double radius,
                        double q[SHAPES])
{
    double largest = 0.0;
    for (int k = 0; k < SHAPES; k++) {
        double x[2];
        finite_element_node(&s->mesh, element->node[k], x);
        q[k] = domain_weight((double[]){x[0] - s->plate.tip[tip], x[1]}, radius);
        largest = fmax(largest, q[k]);
    }
    return largest > 0.0;
}

static point point_at(const finite_element_solution *s, const finite_element *element, int gauss, int tip,
                      const double q[SHAPES])
{
    point p = {0};
    double local[2], gradient[2][2] = {{0}}; // u_i,j
    const double ahead = direction_of(tip);
    p.area = finite_element_gauss(element, gauss, local);
    const finite_element_shapes shapes = finite_element_shapes_at(element, local);
    for (int k = 0; k < SHAPES; k++) {
        const double M = s->modulus[element->node[k]], *u = &s->displacement[2 * element->node[k]];
        p.modulus += shapes.value[k] * M;
        p.modulus_slope += ahead * shapes.slope[k][0] * M;
        p.weight += shapes.value[k] * q[k];
        for (int d = 0; d < 2; d++) {
            p.weight_slope[d] += ahead * shapes.slope[k][d] * q[k];
            for (int i = 0; i < 2; i++) gradient[i][d] += shapes.slope[k][d] * u[i];
        }
    }
    for (int d = 0; d < 2; d++) {
        p.z[d] = ahead * (element->centre[d] + element->half[d] * local[d] - (d ? 0.0 : s->plate.tip[tip]));
        p.slope[d] = gradient[d][0];
        p.strain[d] = gradient[d][d];
    }
    p.strain[2] = 0.5 * (gradient[0][1] + gradient[1][0]);
    const double trace = p.strain[0] + p.strain[1];
    for (int k = 0; k < 3; k++) p.stress[k] = p.modulus * s->mu * (2.0 * p.strain[k] + (k < 2 ? trace : 0.0));
    return p;
}

static double integrate(const finite_element_solution *s, int tip, double radius, integrand *f, const void *context)
{
    double sum = 0.0, q[SHAPES];
    for (int row = 0; row < s->mesh.cells[1]; row++)
        for (int column = 0; column < s->mesh.cells[0]; column++) {
            const finite_element element = finite_element_at(&s->mesh, column, row);
            if (!weigh_nodes(s, &element, tip, radius, q)) continue;
            for (int g = 0; g < GAUSS_POINTS; g++) {
                const point p = point_at(s, &element, g, tip, q);
                sum += p.area * f(s, &p, context);
            }
        }
    return sum;
}

static double energy_momentum(const finite_element_solution *s, const point *p, const void *context)
{
    (void)s;
    (void)context;
    const double energy = 0.5 * contract(p->stress, p->strain);
    return traction_times(p->stress, p->weight_slope, p->slope) - energy * p->weight_slope[0] -
           energy * p->modulus_slope / p->modulus * p->weight;
}

double finite_element_energy_release_rate(const finite_element_solution *solution, int tip, double radius)
{
    return integrate(solution, tip, radius, energy_momentum, NULL);
}

// Westergaard's function Z = 1 / sqrt(2 pi z) and its derivatives; kappa = 2 as lambda = mu in the plane.
static tip_field tip_field_at(int mode, const double x[2])
{
    const double complex z = CMPLX(x[0], x[1]), Z = 1.0 / csqrt(2.0 * acos(-1.0) * z);
    const double complex first = -0.5 * Z / z, second = -1.5 * first / z;
    const double y = x[1], kappa = 2.0;
    if (mode == 0)
        return (tip_field){
            .stress = {creal(Z) - y * cimag(first), creal(Z) + y * cimag(first), -y * creal(first)},
            .stress_slope = {creal(first) - y * cimag(second), creal(first) + y * cimag(second), -y * creal(second)},
            .slope = {0.5 * (kappa - 1.0) * creal(Z) - y * cimag(first),
                      0.5 * (kappa + 1.0) * cimag(Z) - y * creal(first)},
        };
    return (tip_field){
        .stress = {2.0 * cimag(Z) + y * creal(first), -y * creal(first), creal(Z) - y * cimag(first)},
        .stress_slope = {2.0 * cimag(first) + y * creal(second), -y * creal(second), creal(first) - y * cimag(second)},
        .slope = {0.5 * (kappa + 1.0) * cimag(Z) + y * creal(first),
                  -0.5 * (kappa - 1.0) * creal(Z) - y * cimag(first)},
    };
}

typedef struct {
    int mode;
    double tip_modulus; // M at the tip
} interaction;

static double interaction_energy(const finite_element_solution *s, const point *p, const void *context)
{
    const interaction *with = context;
    const tip_field second = tip_field_at(with->mode, p->z);
    const double scale = 0.5 / (s->mu * with->tip_modulus),
                 slope[2] = {scale * second.slope[0], scale * second.slope[1]};
    return traction_times(p->stress, p->weight_slope, slope) +
           traction_times(second.stress, p->weight_slope, p->slope) -
           contract(second.stress, p->strain) * p->weight_slope[0] -
           (1.0 - p->modulus / with->tip_modulus) * contract(p->strain, second.stress_slope) * p->weight;
}

static double modulus_at_tip(const finite_element_solution *s, int tip)
{
    const finite_element ahead = finite_element_at(&s->mesh, s->mesh.tip[tip] / 2 - 1 + tip, s->mesh.middle / 2);
    return s->modulus[ahead.node[tip ? 0 : 2]];
}

// The integral is 2 K / E', and E' = 8/3 mu.
void finite_element_stress_intensity(const finite_element_solution *solution, int tip, double radius, double K[2])
{
    for (int mode = 0; mode < 2; mode++) {
        const interaction with = {mode, modulus_at_tip(solution, tip)};
        const double plane_modulus = 8.0 / 3.0 * solution->mu * with.tip_modulus;
        K[mode] = 0.5 * plane_modulus * integrate(solution, tip, radius, interaction_energy, &with);
    }
}
