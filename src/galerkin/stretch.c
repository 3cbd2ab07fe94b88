// SPDX-License-Identifier: GPL-3.0-or-later

/// Pairs of elements whose bonds have a law. The difference u' - u that an outer point sees of another element is linear in
/// xi, but the force of a bond is not linear in that: so the inner integral is by points.

#include "galerkin/pair.h"

#include <math.h>

// u' - u = jump + slope.xi, continued to the outer point.
typedef struct {
    double jump, slope[2];
} difference;

// What an outer point's bonds with an element add up to: moments of their stiffness, int c r g and int c r g xi, and
// int c r^2 W.
typedef struct {
    pdmc_moments stiffness;
    double force, force_along[2], energy;
} bond_sum;

static difference difference_of(int corners, const pdmc_element *other, bool same, const double near[],
                                const double far[], double u[2][PDMC_CORNERS])
{
    difference d = {0};
    for (int a = 0; a < corners; a++) {
        if (!same) d.jump += far[a] * u[1][a] - near[a] * u[0][a];
        for (int k = 0; k < 2; k++) d.slope[k] += other->gradient[a][k] * u[1][a];
    }
    return d;
}

static bond_sum add_bonds(const pdmc_pair_rule *rule, const pdmc_bond_law *law, const pdmc_element *other,
                          const double x[2], const difference *d)
{
    bond_sum sum = {0};
    double place[2 * PDMC_INNER_POINTS], weight[PDMC_INNER_POINTS];
    pdmc_area_rule points = {.x = place, .weight = weight};
    pdmc_pair_points(rule, other, x, &points);
    for (int p = 0; p < points.count; p++) {
        const double xi[2] = {place[2 * p] - x[0], place[2 * p + 1] - x[1]}, r = sqrt(xi[0] * xi[0] + xi[1] * xi[1]);
        if (r == 0.0) continue;
        const double c = weight[p] * pdmc_scalar_kernel_at(rule->kernel, r);
        const double stretch = (d->jump + d->slope[0] * xi[0] + d->slope[1] * xi[1]) / r;
        const pdmc_law_value g = pdmc_law_at(law, stretch);
        const double force = c * r * g.force;
        pdmc_moments_add(xi, c * g.slope, &sum.stiffness);
        sum.force += force;
        for (int k = 0; k < 2; k++) sum.force_along[k] += force * xi[k];
        sum.energy += c * r * r * g.energy;
    }
    return sum;
}

// A test function of the other element is v'(x) + gradient.xi; within one element only the second part is left of
// v' - v.
static void add_force(int corners, const pdmc_element *other, bool same, const double near[], const double far[],
                      const bond_sum *sum, double weight, pdmc_pair_block *block)
{
    for (int a = 0; a < corners; a++) {
        const double *g = other->gradient[a];
        block->force[1][a] += weight * (g[0] * sum->force_along[0] + g[1] * sum->force_along[1]);
        if (same) continue;
        block->force[1][a] += weight * far[a] * sum->force;
        block->force[0][a] -= weight * near[a] * sum->force;
    }
}

void pdmc_pair_stretch(const pdmc_pair_rule *rule, const pdmc_bond_law *law, const pdmc_element *element,
                       const pdmc_element *other, bool same, double u[2][PDMC_CORNERS], pdmc_pair_block *block)
{
    const int dimension = rule->kernel->dimension, corners = dimension + 1;
    *block = (pdmc_pair_block){0};
    for (int p = 0; p < rule->outer.count; p++) {
        double x[2], far[PDMC_CORNERS];
        const double *near = &rule->outer.at[PDMC_CORNERS * p], weight = 0.5 * element->size * rule->outer.weight[p];
        pdmc_element_point(element, dimension, near, x);
        if (pdmc_pair_is_beyond(rule, other, x)) continue;
        pdmc_element_coordinates(other, dimension, x, far);
        const difference d = difference_of(corners, other, same, near, far, u);
        const bond_sum sum = add_bonds(rule, law, other, x, &d);
        pdmc_pair_add_moments(corners, element, other, same, near, far, &sum.stiffness, weight, block);
        add_force(corners, other, same, near, far, &sum, weight, block);
        block->energy += weight * sum.energy;
    }
}
