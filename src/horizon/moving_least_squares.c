// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/moving_least_squares.h"

#include "base/base_impl.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { MAX_TERMS = 10 };
static const double consistency_limit = 1e-6;

pdmc_moving_least_squares pdmc_moving_least_squares_default(int dimension, double support)
{
    return (pdmc_moving_least_squares){dimension, support, 1e8};
}

/// 1, x, y, z, and their products; how many.
static int powers(int dimension, const double x[3], double term[MAX_TERMS])
{
    int count = 0;
    term[count++] = 1.0;
    for (int a = 0; a < dimension; a++) term[count++] = x[a];
    for (int a = 0; a < dimension; a++)
        for (int b = a; b < dimension; b++) term[count++] = x[a] * x[b];
    return count;
}

/// Quartic spline, eq. 3.24.
static double spline(double d)
{
    return d < 1.0 ? 1.0 - d * d * (6.0 - d * (8.0 - 3.0 * d)) : 0.0;
}

/// The node from the point, over the support; its distance.
static double to_node(const pdmc_moving_least_squares *o, const double point[3], const double node[3], double x[3])
{
    double square = 0.0;
    for (int a = 0; a < o->dimension; a++) {
        x[a] = (node[a] - point[a]) / o->support;
        square += x[a] * x[a];
    }
    return sqrt(square);
}

// A point and the nodes that may contribute: those of a list, or all.
typedef struct {
    const pdmc_moving_least_squares *options;
    const double *point;
    int count;
    const int *list; // [count] of nodes, or NULL
    const double *node;
    int nearest, contributing;
} neighbourhood;

static int node_of(const neighbourhood *n, int i)
{
    return n->list ? n->list[i] : i;
}

static double reach(const neighbourhood *n, int i, double x[3])
{
    return to_node(n->options, n->point, &n->node[3 * (size_t)node_of(n, i)], x);
}

/// The moment matrix, eq. 3.28: upper triangle, row-major.
static int moments(neighbourhood *n, double matrix[MAX_TERMS * MAX_TERMS])
{
    double x[3], term[MAX_TERMS], nearest = INFINITY;
    const int terms = n->options->dimension == 3 ? 10 : 6;
    memset(matrix, 0, (size_t)(terms * terms) * sizeof *matrix);
    n->contributing = 0;
    for (int i = 0; i < n->count; i++) {
        const double d = reach(n, i, x), weight = spline(d);
        if (d < nearest) {
            nearest = d;
            n->nearest = node_of(n, i);
        }
        if (weight <= 0.0) continue;
        n->contributing++;
        powers(n->options->dimension, x, term);
        for (int k = 0; k < terms; k++)
            for (int l = k; l < terms; l++) matrix[k * terms + l] += weight * term[k] * term[l];
    }
    return terms;
}

/// Row sum and Frobenius norm of a symmetric matrix of which the upper triangle is given.
static void norms(int terms, const double matrix[], double norm[2])
{
    norm[0] = norm[1] = 0.0;
    for (int k = 0; k < terms; k++) {
        double row = 0.0;
        for (int l = 0; l < terms; l++) {
            const double entry = k <= l ? matrix[k * terms + l] : matrix[l * terms + k];
            row += fabs(entry);
            norm[1] += entry * entry;
        }
        norm[0] = fmax(norm[0], row);
    }
    norm[1] = sqrt(norm[1]);
}

static pdmc_status refuse(const neighbourhood *n, const char *why, double found)
{
    return pdmc_raise(PDMC_ERR_SINGULAR,
                      "moving least squares near node %d, at (%g, %g, %g), of %d nodes within the support %g: %s %.3g",
                      n->nearest, n->point[0], n->point[1], n->options->dimension == 3 ? n->point[2] : 0.0,
                      n->contributing, n->options->support, why, found);
}

/// Inverts the moment matrix in place, and says how well it was conditioned.
static pdmc_status invert(const neighbourhood *n, int terms, double matrix[], double condition[2])
{
    double norm[2], inverse[2];
    if (n->contributing < terms) return refuse(n, "fewer nodes than the polynomial's terms,", terms);
    norms(terms, matrix, norm);
    if (LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'U', terms, matrix, terms) != 0 ||
        LAPACKE_dpotri(LAPACK_ROW_MAJOR, 'U', terms, matrix, terms) != 0)
        return refuse(n, "the moment matrix is singular, condition above", 1e16);
    norms(terms, matrix, inverse);
    for (int k = 0; k < 2; k++) condition[k] = norm[k] * inverse[k];
    if (!(fmax(condition[0], condition[1]) <= n->options->condition_limit))
        return refuse(n, "the condition of the moment matrix is", fmax(condition[0], condition[1]));
    return PDMC_OK;
}

static int degree_of(int dimension, int term)
{
    return term == 0 ? 0 : term <= dimension ? 1 : 2;
}

/// Whether the shape functions reproduce the polynomials, which are 1, 0, 0, ... at the point.
static pdmc_status check(const neighbourhood *n, int terms, const double value[], double consistency[3])
{
    double x[3], term[MAX_TERMS], sum[MAX_TERMS] = {-1.0};
    for (int i = 0; i < n->count; i++) {
        if (value[i] == 0.0) continue;
        reach(n, i, x);
        powers(n->options->dimension, x, term);
        for (int k = 0; k < terms; k++) sum[k] += value[i] * term[k];
    }
    memset(consistency, 0, 3 * sizeof *consistency);
    for (int k = 0; k < terms; k++) {
        double *worst = &consistency[degree_of(n->options->dimension, k)];
        *worst = fmax(*worst, fabs(sum[k]));
    }
    static const char *const of[] = {"a constant is off by", "a linear polynomial is off by",
                                     "a quadratic polynomial is off by"};
    for (int d = 0; d < 3; d++)
        if (!(consistency[d] <= consistency_limit)) return refuse(n, of[d], consistency[d]);
    return PDMC_OK;
}

/// With powers of x_i - x the polynomial at the point is its constant: phi_i = w_i p(x_i) A^-1 (1, 0, 0, ...).
static pdmc_status shape(neighbourhood *n, double value[], pdmc_shape_quality *quality)
{
    double matrix[MAX_TERMS * MAX_TERMS], x[3], term[MAX_TERMS];
    const int terms = moments(n, matrix);
    pdmc_status status = invert(n, terms, matrix, quality->condition);
    if (status != PDMC_OK) return status;
    for (int i = 0; i < n->count; i++) {
        const double weight = spline(reach(n, i, x));
        double sum = 0.0;
        powers(n->options->dimension, x, term);
        for (int k = 0; k < terms; k++) sum += term[k] * matrix[k];
        value[i] = weight > 0.0 ? weight * sum : 0.0;
    }
    return check(n, terms, value, quality->consistency);
}

static pdmc_status check_options(const pdmc_moving_least_squares *o)
{
    PDMC_REQUIRE(o->dimension == 2 || o->dimension == 3, "dimension = %d is neither 2 nor 3", o->dimension);
    PDMC_REQUIRE(isfinite(o->support) && o->support > 0.0, "support = %g is not > 0", o->support);
    PDMC_REQUIRE(o->condition_limit >= 1.0, "condition_limit = %g is not >= 1", o->condition_limit);
    return PDMC_OK;
}

pdmc_status pdmc_shape_functions_at(const pdmc_moving_least_squares *options, const double point[3], int node_count,
                                    const double node[], double value[], pdmc_shape_quality *quality)
{
    pdmc_shape_quality own;
    const pdmc_status status = check_options(options);
    if (status != PDMC_OK) return status;
    PDMC_REQUIRE(node_count > 0, "node_count = %d is not > 0", node_count);
    neighbourhood n = {.options = options, .point = point, .count = node_count, .node = node};
    return shape(&n, value, quality ? quality : &own);
}

// Nodes in cubes as long as the support: those of a cube and its neighbours may contribute.
typedef struct {
    const pdmc_moving_least_squares *options;
    double low[3];
    int sides[3];
    int *first; // [cubes + 1]
    int *node;  // [node_count] by cubes, ascending in each
} cubes;

static int place(const cubes *c, const double x[3], int axis)
{
    if (axis >= c->options->dimension) return 0;
    return (int)fmax(-2.0, fmin(c->sides[axis] + 1.0, floor((x[axis] - c->low[axis]) / c->options->support)));
}

static int cube_of(const cubes *c, const double x[3])
{
    return (place(c, x, 0) * c->sides[1] + place(c, x, 1)) * c->sides[2] + place(c, x, 2);
}

static pdmc_status measure(cubes *c, int count, const double node[])
{
    double total = 1.0;
    for (int a = 0; a < 3; a++) {
        double high = -INFINITY;
        c->sides[a] = 1;
        c->low[a] = INFINITY;
        for (int i = 0; i < count; i++) {
            c->low[a] = fmin(c->low[a], node[3 * (size_t)i + (size_t)a]);
            high = fmax(high, node[3 * (size_t)i + (size_t)a]);
        }
        if (a >= c->options->dimension) continue;
        const double sides = floor((high - c->low[a]) / c->options->support) + 1.0;
        total *= sides;
        PDMC_REQUIRE(total < 1e8, "support = %g is too small for the extent %g of the nodes", c->options->support,
                     high - c->low[a]);
        c->sides[a] = (int)sides;
    }
    return PDMC_OK;
}

static pdmc_status sort_into_cubes(cubes *c, int count, const double node[])
{
    pdmc_status status = PDMC_OK;
    int *next = NULL;
    PDMC_TRY(measure(c, count, node));
    const int total = c->sides[0] * c->sides[1] * c->sides[2];
    PDMC_NEW(c->first, total + 1);
    PDMC_NEW(c->node, count);
    PDMC_NEW(next, total);
    for (int i = 0; i < count; i++) c->first[cube_of(c, &node[3 * (size_t)i]) + 1]++;
    for (int k = 0; k < total; k++) c->first[k + 1] += c->first[k];
    memcpy(next, c->first, (size_t)total * sizeof *next);
    for (int i = 0; i < count; i++) c->node[next[cube_of(c, &node[3 * (size_t)i])]++] = i;
done:
    pdmc_free(next);
    return status;
}

static void insert(int node, int list[], int *count)
{
    int at = (*count)++;
    for (; at > 0 && list[at - 1] > node; at--) list[at] = list[at - 1];
    list[at] = node;
}

/// The nodes within the support of a point, ascending; `list` may be NULL to count them.
static int find(const cubes *c, const double node[], const double point[3], int list[])
{
    int count = 0, middle[3], from[3], to[3];
    double x[3];
    for (int a = 0; a < 3; a++) {
        middle[a] = place(c, point, a);
        from[a] = middle[a] > 0 ? middle[a] - 1 : 0;
        to[a] = middle[a] + 1 < c->sides[a] ? middle[a] + 1 : c->sides[a] - 1;
    }
    for (int i = from[0]; i <= to[0]; i++) {
        for (int j = from[1]; j <= to[1]; j++) {
            const int row = (i * c->sides[1] + j) * c->sides[2];
            if (from[2] > to[2]) continue;
            for (int k = c->first[row + from[2]]; k < c->first[row + to[2] + 1]; k++) {
                if (!(spline(to_node(c->options, point, &node[3 * (size_t)c->node[k]], x)) > 0.0)) continue;
                if (list) insert(c->node[k], list, &count);
                else count++;
            }
        }
    }
    return count;
}

static void keep_worst(pdmc_shape_quality *worst, const pdmc_shape_quality *quality)
{
    for (int k = 0; k < 2; k++) worst->condition[k] = fmax(worst->condition[k], quality->condition[k]);
    for (int k = 0; k < 3; k++) worst->consistency[k] = fmax(worst->consistency[k], quality->consistency[k]);
}

pdmc_status pdmc_shape_functions_create(const pdmc_moving_least_squares *options, int node_count, const double node[],
                                        int point_count, const double point[], pdmc_shape_functions *functions)
{
    *functions = (pdmc_shape_functions){0};
    cubes c = {.options = options};
    pdmc_status status = check_options(options);
    if (status != PDMC_OK) return status;
    PDMC_REQUIRE(node_count > 0 && point_count >= 0, "node_count = %d, point_count = %d", node_count, point_count);
    pdmc_blas_prepare();
    PDMC_TRY(sort_into_cubes(&c, node_count, node));
    PDMC_NEW(functions->first, point_count + 1);
    for (int p = 0; p < point_count; p++)
        functions->first[p + 1] = functions->first[p] + find(&c, node, &point[3 * (size_t)p], NULL);
    PDMC_NEW(functions->node, functions->first[point_count]);
    PDMC_NEW(functions->value, functions->first[point_count]);
    functions->point_count = point_count;
    for (int p = 0; p < point_count; p++) {
        pdmc_shape_quality quality;
        const int64_t at = functions->first[p];
        neighbourhood n = {options, &point[3 * (size_t)p], 0, &functions->node[at], node, 0, 0};
        n.count = find(&c, node, n.point, &functions->node[at]);
        PDMC_TRY(shape(&n, &functions->value[at], &quality));
        keep_worst(&functions->worst, &quality);
    }
done:
    pdmc_free(c.first);
    pdmc_free(c.node);
    if (status != PDMC_OK) pdmc_shape_functions_clear(functions);
    return status;
}

void pdmc_shape_functions_clear(pdmc_shape_functions *functions)
{
    pdmc_free(functions->first);
    pdmc_free(functions->node);
    pdmc_free(functions->value);
    *functions = (pdmc_shape_functions){0};
}

void pdmc_shape_functions_apply(const pdmc_shape_functions *functions, int components, const double at_nodes[],
                                double at_points[])
{
    for (int p = 0; p < functions->point_count; p++) {
        double *out = &at_points[(size_t)components * (size_t)p];
        memset(out, 0, (size_t)components * sizeof *out);
        for (int64_t i = functions->first[p]; i < functions->first[p + 1]; i++) {
            const double *in = &at_nodes[(size_t)components * (size_t)functions->node[i]];
            for (int c = 0; c < components; c++) out[c] += functions->value[i] * in[c];
        }
    }
}
