// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/forms.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

static const double negligible = 1e-14; // share of an energy that may be left out
static const double margin = 4.0;       // of the samples over the pilots

// What the forms are made from.
typedef struct {
    const pdmc_affine *model;
    int width, directions, rings;
    double *complete; // [directions, rings, width, width] A_dq, both triangles
    double *mean;     // [rings] g_q at the mean c(r)
    double *least;    // [directions] the least sum_q g_q y' A_dq y / |y|^2 of the pilots
    double *weight;   // [width, width] the most that a pair adds to any direction, over its energy; i <= j
    size_t *order;    // [width, width] of ascending weights
} maker;

static int width_of(const pdmc_affine *model)
{
    return model->observed > 0 ? model->observed : model->unknowns;
}

// The rows of a direction are read once for a sample, its forms too.
static bool is_worthwhile(const pdmc_affine *model)
{
    const int directions = model->tips * model->angles, width = width_of(model);
    double bonds = 0.0;
    for (int d = 0; d < directions; d++) {
        if (model->crossings[d].column) return false;
        bonds += model->crossings[d].bonds;
    }
    return bonds > 0.0 && 0.5 * directions * model->rings * (width + 1.0) <= bonds;
}

static pdmc_status maker_create(const pdmc_affine *model, maker *m)
{
    pdmc_status status = PDMC_OK;
    *m = (maker){model, width_of(model), model->tips * model->angles, model->rings, NULL, NULL, NULL, NULL, NULL};
    const size_t square = (size_t)m->width * (size_t)m->width;
    PDMC_NEW(m->complete, (size_t)(m->directions * m->rings) * square);
    PDMC_NEW(m->mean, m->rings);
    PDMC_NEW(m->least, m->directions);
    PDMC_NEW(m->weight, square);
    PDMC_NEW(m->order, square);
done:
    return status;
}

static void maker_clear(maker *m)
{
    pdmc_free(m->complete);
    pdmc_free(m->mean);
    pdmc_free(m->least);
    pdmc_free(m->weight);
    pdmc_free(m->order);
}

static double *form_of(const maker *m, int direction, int ring)
{
    return &m->complete[(size_t)(direction * m->rings + ring) * (size_t)m->width * (size_t)m->width];
}

// Runs of bonds of one ring at once.
static void sum_products(maker *m, int direction)
{
    const pdmc_crossing *crossing = &m->model->crossings[direction];
    const int n = m->width;
    for (int first = 0, next; first < crossing->bonds; first = next) {
        const int ring = crossing->ring[first];
        for (next = first; next < crossing->bonds && crossing->ring[next] == ring;) next++;
        const double *row = &crossing->row[(size_t)first * (size_t)n];
        cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, next - first, 1.0, row, n, row, n, 1.0,
                    form_of(m, direction, ring), n);
    }
}

static void find_mean(maker *m)
{
    for (int b = 0; b < m->model->bins; b++)
        for (int q = 0; q < m->rings; q++) m->mean[q] += m->model->ring_weight[b * m->rings + q];
}

// sum_q g_q y' A_dq y at the mean c(r)
static double energy_at_mean(const maker *m, int direction, const double y[])
{
    double energy = 0.0;
    for (int q = 0; q < m->rings; q++) {
        const double *form = form_of(m, direction, q);
        for (int i = 0; i < m->width; i++)
            energy += m->mean[q] * y[i] * cblas_ddot(m->width, &form[i * m->width], 1, y, 1);
    }
    return energy;
}

static void find_least(maker *m, int pilots, const double y[])
{
    for (int d = 0; d < m->directions; d++) {
        m->least[d] = INFINITY;
        for (int p = 0; p < pilots; p++) {
            const double *one = &y[(size_t)p * (size_t)m->width], norm = cblas_dnrm2(m->width, one, 1);
            if (norm > 0.0) m->least[d] = fmin(m->least[d], energy_at_mean(m, d, one) / (norm * norm));
        }
    }
}

static void find_most(int width, int pilots, const double y[], double most[])
{
    for (int p = 0; p < pilots; p++) {
        const double *one = &y[(size_t)p * (size_t)width], norm = cblas_dnrm2(width, one, 1);
        for (int i = 0; i < width && norm > 0.0; i++) most[i] = fmax(most[i], margin * fabs(one[i]) / norm);
    }
}

// A direction without bonds has no say; one whose pilots have no energy needs every pair.
static double weight_of(const maker *m, int i, int j, const double most[])
{
    double largest = 0.0;
    for (int d = 0; d < m->directions; d++) {
        double sum = 0.0;
        for (int q = 0; q < m->rings; q++) sum += fabs(m->mean[q] * form_of(m, d, q)[i * m->width + j]);
        if (sum > 0.0 && !(m->least[d] > 0.0)) return INFINITY;
        if (sum > 0.0) largest = fmax(largest, (i == j ? 1.0 : 2.0) * sum * most[i] * most[j] / m->least[d]);
    }
    return largest;
}

static void weigh_pairs(maker *m, const double most[])
{
    const int n = m->width;
    for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++) m->weight[i * n + j] = weight_of(m, i, j, most);
    gsl_sort_index(m->order, m->weight, 1, (size_t)n * (size_t)n);
}

// Drops the lightest until they would add too much; what is below the diagonal weighs nothing and goes first.
static void choose_pairs(const maker *m, pdmc_energy_forms *forms)
{
    const int n = m->width, all = n * n;
    int dropped = 0;
    for (double sum = 0.0; dropped < all && (sum += m->weight[m->order[dropped]]) <= negligible;) dropped++;
    for (int k = dropped; k < all; k++) {
        forms->first[forms->pairs] = (int)m->order[k] / n;
        forms->second[forms->pairs++] = (int)m->order[k] % n;
    }
}

static void fill_forms(const maker *m, pdmc_energy_forms *forms)
{
    const int features = forms->pairs * m->rings;
    for (int d = 0; d < m->directions; d++)
        for (int p = 0; p < forms->pairs; p++)
            for (int q = 0; q < m->rings; q++) {
                const int i = forms->first[p], j = forms->second[p];
                forms->form[(size_t)d * (size_t)features + (size_t)(p * m->rings + q)] =
                    (i == j ? 1.0 : 2.0) * form_of(m, d, q)[i * m->width + j];
            }
}

pdmc_status pdmc_energy_forms_create(const pdmc_affine *model, int pilots, const double y[], pdmc_energy_forms **forms)
{
    pdmc_status status = PDMC_OK;
    maker m = {0};
    pdmc_energy_forms *made = NULL;
    *forms = NULL;
    if (!is_worthwhile(model)) return PDMC_OK;
    PDMC_TRY(maker_create(model, &m));
    PDMC_NEW(made, 1);
    *made = (pdmc_energy_forms){
        .width = m.width, .directions = m.directions, .rings = m.rings, .micromodulus = model->micromodulus};
    PDMC_NEW(made->first, m.width * m.width);
    PDMC_NEW(made->second, m.width * m.width);
    PDMC_NEW(made->most, m.width);
    find_mean(&m);
    for (int d = 0; d < m.directions; d++) sum_products(&m, d);
    find_least(&m, pilots, y);
    find_most(m.width, pilots, y, made->most);
    weigh_pairs(&m, made->most);
    choose_pairs(&m, made);
    PDMC_NEW(made->form, (size_t)m.directions * (size_t)(made->pairs * m.rings));
    fill_forms(&m, made);
    *forms = made;
    made = NULL;
done:
    maker_clear(&m);
    pdmc_energy_forms_destroy(&made);
    return status;
}

void pdmc_energy_forms_destroy(pdmc_energy_forms **forms)
{
    if (!*forms) return;
    pdmc_free((*forms)->first);
    pdmc_free((*forms)->second);
    pdmc_free((*forms)->most);
    pdmc_free((*forms)->form);
    pdmc_free(*forms);
    *forms = NULL;
}

size_t pdmc_energy_forms_scratch(const pdmc_energy_forms *forms)
{
    return (size_t)B * (size_t)(forms->width + forms->rings + forms->pairs * forms->rings);
}

bool pdmc_energy_forms_hold(const pdmc_energy_forms *forms, const double y[])
{
    const double norm = cblas_dnrm2(forms->width, y, 1);
    bool hold = true;
    for (int i = 0; i < forms->width; i++) hold = hold && fabs(y[i]) <= forms->most[i] * norm;
    return hold;
}

// feature: [pairs, rings, B] g_q y_i y_j;  side: [width, B] y;  weight: [rings, B] g
static void fill_features(const pdmc_energy_forms *forms, const double side[], const double weight[], double feature[])
{
    for (int p = 0; p < forms->pairs; p++) {
        const double *a = &side[forms->first[p] * B], *b = &side[forms->second[p] * B];
        double product[B];
        for (int s = 0; s < B; s++) product[s] = a[s] * b[s];
        for (int q = 0; q < forms->rings; q++)
            for (int s = 0; s < B; s++) feature[(p * forms->rings + q) * B + s] = weight[q * B + s] * product[s];
    }
}

void pdmc_energy_forms_evaluate(const pdmc_energy_forms *forms, const pdmc_draw draw[], const double y[],
                                double scratch[], double energy[])
{
    const int features = forms->pairs * forms->rings;
    double *side = scratch, *weight = &side[forms->width * B], *feature = &weight[forms->rings * B];
    for (int s = 0; s < B; s++) {
        for (int i = 0; i < forms->width; i++) side[i * B + s] = y[s * forms->width + i];
        for (int q = 0; q < forms->rings; q++) weight[q * B + s] = draw[s].ring_weight[q];
    }
    fill_features(forms, side, weight, feature);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, forms->directions, B, features, 0.5 * forms->micromodulus,
                forms->form, features, feature, B, 0.0, energy, B);
    for (int d = 0; d < forms->directions; d++)
        for (int s = 0; s < B; s++) energy[d * B + s] *= draw[s].direction_modulus[d];
}
