// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/bond_moments.h"

#include "galerkin/edge.h"

#include <math.h>
#include <stdbool.h>

enum { DEGREE = 4 };

// An edge, and the monomials of degree m along it as polynomials in s: monomial[m][k] = x^(m - k) y^k.
typedef struct {
    pdmc_edge line;
    double monomial[DEGREE + 1][DEGREE + 1][DEGREE + 1];
} bond_edge;

// out = (first + step s) p, p of degree m - 1.
static void multiply(int m, double first, double step, const double p[], double out[])
{
    out[0] = first * p[0];
    for (int j = 1; j < m; j++) out[j] = first * p[j] + step * p[j - 1];
    out[m] = step * p[m - 1];
}

static void fill_monomials(bond_edge *edge)
{
    const pdmc_edge *l = &edge->line;
    edge->monomial[0][0][0] = 1.0;
    for (int m = 1; m <= DEGREE; m++) {
        for (int k = 0; k < m; k++)
            multiply(m, l->h * l->n[0], l->t[0], edge->monomial[m - 1][k], edge->monomial[m][k]);
        multiply(m, l->h * l->n[1], l->t[1], edge->monomial[m - 1][m - 1], edge->monomial[m][m]);
    }
}

// int s^k / r^3 ds along the edge, r^2 = h^2 + s^2.
static void integrate_along(double h, double from, double to, double out[DEGREE + 1])
{
    const double r[2] = {sqrt(h * h + from * from), sqrt(h * h + to * to)}, sine = to / r[1] - from / r[0];
    const double logarithm = pdmc_asinh_difference(h, from, to, r);
    out[0] = sine / (h * h);
    out[1] = 1.0 / r[0] - 1.0 / r[1];
    out[2] = logarithm - sine;
    out[3] = r[1] - r[0] - h * h * out[1];
    out[4] = 0.5 * (to * r[1] - from * r[0]) - 1.5 * h * h * logarithm + h * h * sine;
}

static void add_product(int m, double factor, double monomial[][DEGREE + 1], const double integral[], double out[])
{
    for (int k = 0; k <= m; k++) {
        double sum = 0.0;
        for (int j = 0; j <= m; j++) sum += monomial[k][j] * integral[j];
        out[k] += factor * sum;
    }
}

// The wedge up to the edge: int r^(m - 2) dr dtheta e^m with dtheta = h ds / r^2.
static void add_straight(bond_edge *edge, double from, double to, pdmc_bond_moments *m)
{
    if (from >= to) return;
    const double h = edge->line.h;
    double integral[DEGREE + 1];
    integrate_along(h, from, to, integral);
    add_product(2, h, edge->monomial[2], integral, m->second);
    add_product(3, h / 2.0, edge->monomial[3], integral, m->third);
    add_product(4, h / 3.0, edge->monomial[4], integral, m->fourth);
}

// int e_x^(m - k) e_y^k dtheta up to a direction, without the part that is the angle itself.
static void arc_to(const double e[2], double second[3], double third[4], double fourth[5])
{
    const double c = e[0], s = e[1], c2 = c * c, s2 = s * s, sine2 = 2.0 * s * c, sine4 = 2.0 * sine2 * (c2 - s2);
    second[0] = 0.25 * sine2;
    second[1] = 0.5 * s2;
    second[2] = -0.25 * sine2;
    third[0] = s - s * s2 / 3.0;
    third[1] = -c * c2 / 3.0;
    third[2] = s * s2 / 3.0;
    third[3] = -c + c * c2 / 3.0;
    fourth[0] = 0.25 * sine2 + sine4 / 32.0;
    fourth[1] = -0.25 * c2 * c2;
    fourth[2] = -sine4 / 32.0;
    fourth[3] = 0.25 * s2 * s2;
    fourth[4] = -0.25 * sine2 + sine4 / 32.0;
}

// The wedge up to a circle.
static void add_arc(const bond_edge *edge, double radius, double from, double to, pdmc_bond_moments *m)
{
    if (from >= to) return;
    double e[2][2], second[2][3], third[2][4], fourth[2][5];
    pdmc_edge_direction(&edge->line, from, e[0]);
    pdmc_edge_direction(&edge->line, to, e[1]);
    for (int k = 0; k < 2; k++) arc_to(e[k], second[k], third[k], fourth[k]);
    const double angle = pdmc_turn(e[0], e[1]), of_second[3] = {0.5, 0.0, 0.5};
    const double of_fourth[5] = {0.375, 0.0, 0.125, 0.0, 0.375};
    const double factor[3] = {radius, radius * radius / 2.0, radius * radius * radius / 3.0};
    for (int k = 0; k < 3; k++) m->second[k] += factor[0] * (of_second[k] * angle + second[1][k] - second[0][k]);
    for (int k = 0; k < 4; k++) m->third[k] += factor[1] * (third[1][k] - third[0][k]);
    for (int k = 0; k < 5; k++) m->fourth[k] += factor[2] * (of_fourth[k] * angle + fourth[1][k] - fourth[0][k]);
}

// The part within a radius.
static pdmc_bond_moments moments_within(double radius, int edges, bond_edge edge[])
{
    pdmc_bond_moments m = {0};
    for (int i = 0; i < edges; i++) {
        const pdmc_edge *l = &edge[i].line;
        const double half = pdmc_half_chord(radius, fabs(l->h));
        add_straight(&edge[i], fmax(l->from, -half), fmin(l->to, half), &m);
        add_arc(&edge[i], radius, l->from, fmin(l->to, -half), &m);
        add_arc(&edge[i], radius, fmax(l->from, half), l->to, &m);
    }
    return m;
}

static void add_difference(const pdmc_bond_moments *a, const pdmc_bond_moments *b, pdmc_bond_moments *out)
{
    for (int k = 0; k < 3; k++) out->second[k] += a->second[k] - b->second[k];
    for (int k = 0; k < 4; k++) out->third[k] += a->third[k] - b->third[k];
    for (int k = 0; k < 5; k++) out->fourth[k] += a->fourth[k] - b->fourth[k];
}

// Of the origin from the nearest point of an edge.
static double distance_of(const pdmc_edge *l)
{
    const double s = fmin(fmax(0.0, l->from), l->to);
    return sqrt(l->h * l->h + s * s);
}

// The edges whose wedges are not empty; none where the disc lies beyond one of them.
static int find_edges(double horizon, int corners, double corner[][2], bond_edge edge[])
{
    int edges = 0;
    for (int i = 0; i < corners; i++) {
        edge[edges].line = pdmc_edge_of(corner[i], corner[(i + 1) % corners]);
        if (edge[edges].line.h <= -horizon) return 0;
        if (edge[edges].line.h != 0.0) edges++;
    }
    return edges;
}

void pdmc_polygon_bond_moments(double horizon, int bins, int corners, double corner[][2], pdmc_bond_moments moments[])
{
    bond_edge edge[PDMC_POLYGON_CORNERS];
    const int edges = find_edges(horizon, corners, corner, edge);
    double nearest = INFINITY, farthest = 0.0;
    bool is_inside = true;
    for (int i = 0; i < edges; i++) {
        const pdmc_edge *l = &edge[i].line;
        fill_monomials(&edge[i]);
        nearest = fmin(nearest, distance_of(l));
        farthest = fmax(farthest, sqrt(l->h * l->h + fmax(l->from * l->from, l->to * l->to)));
        is_inside = is_inside && l->h > 0.0;
    }
    if (is_inside) nearest = 0.0;
    pdmc_bond_moments inner = {0};
    double reached = 0.0; // all of the polygon is counted once that is the farthest corner
    for (int bin = 0; bin < bins && reached < farthest; bin++) {
        reached = horizon * (bin + 1) / bins;
        if (reached <= nearest) continue;
        const pdmc_bond_moments outer = moments_within(reached, edges, edge);
        add_difference(&outer, &inner, &moments[bin]);
        inner = outer;
    }
}
