// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/stencil.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <float.h>
#include <gsl/gsl_math.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { USUAL = 40, DEGREE = 4 };

static const double shape = 0.7;     // psi / L; larger is more accurate, until rounding shows, at 1
static const double tip_reach = 3.0; // distance from a tip in finest spacings up to which the angle matters

typedef struct {
    const pdmc_stencil_field *field;
    const pdmc_view *from;
} viewer;

static bool is_seen(const void *context, int node)
{
    const viewer *v = context;
    const pdmc_visible_node *other = &v->field->nodes->node[node];
    return !(v->field->without_ghosts && other->edge >= 0) && pdmc_view_sees(v->field->cuts, v->from, &other->view);
}

int pdmc_stencil_owner(const pdmc_stencil_field *field, const pdmc_view *from)
{
    const viewer v = {field, from};
    int node;
    double distance;
    return pdmc_grid_nearest(&field->nodes->grid, from->x, 1, is_seen, &v, &node, &distance) ? node : -1;
}

static double radial(const pdmc_stencil *stencil, double r2)
{
    return stencil->is_cubic ? r2 * sqrt(r2) : 1.0 / sqrt(1.0 + r2 / (shape * shape));
}

// The derivative by r^2, times two.
static double radial_slope(const pdmc_stencil *stencil, double r2)
{
    if (stencil->is_cubic) return 3.0 * sqrt(r2);
    const double value = radial(stencil, r2);
    return -value * value * value / (shape * shape);
}

// power[i] = s^i
static void powers(double s, double power[DEGREE + 1])
{
    power[0] = 1.0;
    for (int i = 1; i <= DEGREE; i++) power[i] = power[i - 1] * s;
}

static void monomials(const double s[2], double p[])
{
    double x[DEGREE + 1], y[DEGREE + 1];
    powers(s[0], x);
    powers(s[1], y);
    int j = 0;
    for (int degree = 0; degree <= DEGREE; degree++)
        for (int i = 0; i <= degree; i++) p[j++] = x[degree - i] * y[i];
}

static void monomial_gradient(const double s[2], double by_x[], double by_y[])
{
    double x[DEGREE + 1], y[DEGREE + 1];
    powers(s[0], x);
    powers(s[1], y);
    int j = 0;
    for (int degree = 0; degree <= DEGREE; degree++) {
        for (int i = 0; i <= degree; i++, j++) {
            const int m = degree - i;
            by_x[j] = m > 0 ? m * x[m - 1] * y[i] : 0.0;
            by_y[j] = i > 0 ? i * x[m] * y[i - 1] : 0.0;
        }
    }
}

// Coordinates with the tip at the origin and the crack along the negative axis.
static void from_tip(const pdmc_stencil *stencil, const double x[2], double local[2])
{
    pdmc_cut_local(stencil->tip, x, local);
    local[0] = stencil->end * local[0] - stencil->tip->half_length;
    local[1] *= stencil->end;
}

static void angle_functions(double t, double f[])
{
    f[0] = cos(t);
    f[1] = sin(t);
    f[2] = t;
    f[3] = cos(2.0 * t);
    f[4] = sin(2.0 * t);
}

static void angle_gradient(const pdmc_stencil *stencil, const double x[2], double by_x[], double by_y[])
{
    double local[2];
    from_tip(stencil, x, local);
    const double t = atan2(local[1], local[0]), r2 = local[0] * local[0] + local[1] * local[1];
    const double slope[PDMC_STENCIL_ANGLES] = {-sin(t), cos(t), 1.0, -2.0 * sin(2.0 * t), 2.0 * cos(2.0 * t)};
    const double tx = -local[1] / r2, ty = local[0] / r2; // of t, in the tip's frame
    const double c = stencil->end * stencil->tip->cosine, s = stencil->end * stencil->tip->sine;
    for (int k = 0; k < PDMC_STENCIL_ANGLES; k++) {
        by_x[k] = slope[k] * (c * tx - s * ty);
        by_y[k] = slope[k] * (s * tx + c * ty);
    }
}

// The values at a point of the polynomials and of the functions of the angle.
static void other_functions(const pdmc_stencil *stencil, const pdmc_view *view, double value[])
{
    const double s[2] = {(view->x[0] - stencil->centre[0]) / stencil->radius,
                         (view->x[1] - stencil->centre[1]) / stencil->radius};
    monomials(s, value);
    if (!stencil->tip) return;
    double local[2];
    from_tip(stencil, view->x, local);
    // a face is at +-pi; which, rounding must not decide
    const double t = view->side == 0 ? atan2(local[1], local[0]) : view->side * stencil->end * M_PI;
    angle_functions(t, value + PDMC_STENCIL_MONOMIALS);
}

static void find_tip(const pdmc_stencil_field *field, pdmc_stencil *stencil)
{
    double nearest = tip_reach * field->nodes->finest;
    for (int t = 0; t < 2 * field->cuts->count; t++) {
        const pdmc_cut *cut = &field->cuts->cut[t / 2];
        const int end = t % 2 ? 1 : -1;
        double tip[2];
        if (!cut->has_tip[t % 2]) continue;
        pdmc_cut_global(cut, end * cut->half_length, 0.0, tip);
        const double distance = hypot(tip[0] - stencil->centre[0], tip[1] - stencil->centre[1]);
        if (distance >= nearest) continue;
        nearest = distance;
        stencil->tip = cut;
        stencil->end = end;
    }
}

static pdmc_status find_nodes(const pdmc_stencil_field *field, int node, pdmc_stencil *stencil)
{
    const pdmc_visible_node *nodes = field->nodes->node;
    const viewer v = {field, &nodes[node].view};
    const int wanted = stencil->tip ? PDMC_STENCIL_NODES : USUAL;
    double distance[PDMC_STENCIL_NODES];
    stencil->count =
        pdmc_grid_nearest(&field->nodes->grid, stencil->centre, wanted, is_seen, &v, stencil->node, distance);
    if (stencil->count < wanted)
        return pdmc_raise(PDMC_ERR_SINGULAR,
                          "a node at (%g, %g) sees only %d of the %d nodes that it needs: take a smaller spacing",
                          stencil->centre[0], stencil->centre[1], stencil->count, wanted);
    stencil->radius = sqrt(distance[stencil->count - 1]);
    stencil->functions = stencil->count + PDMC_STENCIL_MONOMIALS + (stencil->tip ? PDMC_STENCIL_ANGLES : 0);
    for (int k = 0; k < 2 * stencil->count; k++)
        stencil->place[k] = (nodes[stencil->node[k / 2]].view.x[k % 2] - stencil->centre[k % 2]) / stencil->radius;
    return PDMC_OK;
}

// The symmetric matrix of the conditions at the nodes and the side conditions, [functions, functions].
static void fill_matrix(const pdmc_stencil_field *field, const pdmc_stencil *stencil, double matrix[])
{
    const int n = stencil->count, m = stencil->functions;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            const double dx = stencil->place[2 * i] - stencil->place[2 * j];
            const double dy = stencil->place[2 * i + 1] - stencil->place[2 * j + 1];
            matrix[i * m + j] = radial(stencil, dx * dx + dy * dy);
        }
        other_functions(stencil, &field->nodes->node[stencil->node[i]].view, &matrix[i * m + n]);
        for (int j = n; j < m; j++) matrix[j * m + i] = matrix[i * m + j];
    }
}

static pdmc_status invert(int m, double matrix[])
{
    lapack_int pivot[PDMC_STENCIL_FUNCTIONS];
    int info = LAPACKE_dgetrf(LAPACK_ROW_MAJOR, m, m, matrix, m, pivot);
    if (info == 0) info = LAPACKE_dgetri(LAPACK_ROW_MAJOR, m, matrix, m, pivot);
    if (info > 0) return pdmc_raise(PDMC_ERR_SINGULAR, "the nodes of a stencil do not determine its polynomial");
    return info == 0 ? PDMC_OK : pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dgetri returned %d", info);
}

// Near a tip the functions of the angle and the others are nearly dependent on the nodes.
static pdmc_status pseudo_invert(int m, double matrix[])
{
    pdmc_status status = PDMC_OK;
    double *vector = NULL, *value = NULL;
    PDMC_NEW(vector, m * m);
    PDMC_NEW(value, m);
    memcpy(vector, matrix, (size_t)m * (size_t)m * sizeof *matrix);
    const int info = LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', m, vector, m, value);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyev returned %d", info);
    const double least = 1e-13 * fmax(fabs(value[0]), fabs(value[m - 1]));
    memset(matrix, 0, (size_t)m * (size_t)m * sizeof *matrix);
    for (int k = 0; k < m; k++)
        if (fabs(value[k]) > least)
            cblas_dger(CblasRowMajor, m, m, 1.0 / value[k], &vector[k * m], 1, &vector[k * m], 1, matrix, m);
done:
    pdmc_free(vector);
    pdmc_free(value);
    return status;
}

pdmc_status pdmc_stencil_create(const pdmc_stencil_field *field, int node, pdmc_stencil *stencil)
{
    pdmc_status status = PDMC_OK;
    double *matrix = NULL;
    const double *x = field->nodes->node[node].view.x;
    *stencil = (pdmc_stencil){.centre = {x[0], x[1]}, .is_cubic = field->is_cubic};
    find_tip(field, stencil);
    PDMC_TRY(find_nodes(field, node, stencil));
    const int n = stencil->count, m = stencil->functions;
    PDMC_NEW(matrix, m * m);
    PDMC_NEW(stencil->weights, n * m);
    fill_matrix(field, stencil, matrix);
    PDMC_TRY(stencil->tip ? pseudo_invert(m, matrix) : invert(m, matrix));
    memcpy(stencil->weights, matrix, (size_t)n * (size_t)m * sizeof *matrix);
done:
    pdmc_free(matrix);
    if (status != PDMC_OK) pdmc_stencil_clear(stencil);
    return status;
}

void pdmc_stencil_clear(pdmc_stencil *stencil)
{
    pdmc_free(stencil->weights);
    *stencil = (pdmc_stencil){0};
}

static void apply(const pdmc_stencil *stencil, const double value[], double weight[])
{
    const int n = stencil->count, m = stencil->functions;
    cblas_dgemv(CblasRowMajor, CblasNoTrans, n, m, 1.0, stencil->weights, m, value, 1, 0.0, weight, 1);
}

void pdmc_stencil_evaluate(const pdmc_stencil *stencil, const double x[2], double weight[PDMC_STENCIL_NODES])
{
    const double sx = (x[0] - stencil->centre[0]) / stencil->radius, sy = (x[1] - stencil->centre[1]) / stencil->radius;
    const pdmc_view view = {{x[0], x[1]}, -1, 0};
    double value[PDMC_STENCIL_FUNCTIONS];
    for (int k = 0; k < stencil->count; k++) {
        const double dx = sx - stencil->place[2 * k], dy = sy - stencil->place[2 * k + 1];
        value[k] = radial(stencil, dx * dx + dy * dy);
    }
    other_functions(stencil, &view, value + stencil->count);
    apply(stencil, value, weight);
}

void pdmc_stencil_gradient(const pdmc_stencil *stencil, const double x[2], double by_x[PDMC_STENCIL_NODES],
                           double by_y[PDMC_STENCIL_NODES])
{
    const double L = stencil->radius, s[2] = {(x[0] - stencil->centre[0]) / L, (x[1] - stencil->centre[1]) / L};
    double value_x[PDMC_STENCIL_FUNCTIONS], value_y[PDMC_STENCIL_FUNCTIONS];
    for (int k = 0; k < stencil->count; k++) {
        const double dx = s[0] - stencil->place[2 * k], dy = s[1] - stencil->place[2 * k + 1];
        const double slope = radial_slope(stencil, dx * dx + dy * dy) / L;
        value_x[k] = slope * dx;
        value_y[k] = slope * dy;
    }
    const int first = stencil->count, angles = first + PDMC_STENCIL_MONOMIALS;
    monomial_gradient(s, value_x + first, value_y + first);
    for (int j = first; j < angles; j++) {
        value_x[j] /= L;
        value_y[j] /= L;
    }
    if (stencil->tip) angle_gradient(stencil, x, value_x + angles, value_y + angles);
    apply(stencil, value_x, by_x);
    apply(stencil, value_y, by_y);
}
