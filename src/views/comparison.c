// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/comparison.h"

#include "base/base_impl.h"
#include "views/comparison_check.h"
#include "views/table.h"

#include <gsl/gsl_math.h>
#include <libconfig.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double same_angle = 1e-9;                       // rad, between the angles of two files
static const double asked_angle = 0.01 / 57.295779513082321; // rad, between a file's angle and what a person types

const char *pdmc_compared_name(const pdmc_comparison *c, const pdmc_compared_tip *tip)
{
    return c->results[0]->tips[tip->number[0]].name;
}

double pdmc_compared_nominal(const pdmc_comparison *c, const pdmc_compared_angle *angle, int which)
{
    const pdmc_results *r = c->results[which];
    const double *bond = r->bonds == PDMC_BONDS_ALL ? r->nominal_bond_energy : r->nominal_bond_energy_tensile;
    return (c->measure == PDMC_MEASURE_BOND ? bond : r->nominal_griffith_energy)[angle->place[which]];
}

void pdmc_compared_griffith(const pdmc_comparison *c, const pdmc_compared_tip *tip, int which, double *value,
                            double *error)
{
    const pdmc_results *r = c->results[which];
    const pdmc_tip *t = &r->tips[tip->number[which]];
    const int ahead = pdmc_nearest_angle(r, t->direction);
    const double *k = t->stress_intensity, *dk = t->stress_intensity_error;
    *value = ahead < 0 ? NAN : r->nominal_griffith_energy[pdmc_place(r, tip->number[which], ahead)];
    *error = *value * 2.0 * (fabs(k[0]) * dk[0] + fabs(k[1]) * dk[1]) / (k[0] * k[0] + k[1] * k[1]);
}

int pdmc_compared_direction(const pdmc_comparison *c, const pdmc_compared_tip *tip, int which)
{
    const pdmc_results *r = c->results[which];
    const pdmc_estimate *share = &r->direction[pdmc_place(r, tip->number[which], 0)];
    int best = -1;
    for (int k = 0; k < r->angle_count; k++)
        if (best < 0 || share[k].value > share[best].value) best = k;
    return best;
}

static bool is_near(double angle, double other, double tolerance)
{
    return fabs(remainder(angle - other, 2.0 * M_PI)) <= tolerance;
}

/// The angle of the second that is this one of the first, or -1.
static int partner(const pdmc_comparison *c, int angle)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    const int other = pdmc_nearest_angle(b, a->angles[angle]);
    return other >= 0 && is_near(a->angles[angle], b->angles[other], same_angle) ? other : -1;
}

/// The angle of the first that is nearest to this one and that the second has too, or -1.
static int nearest_common(const pdmc_comparison *c, double angle)
{
    const pdmc_results *a = c->results[0];
    int best = -1;
    for (int k = 0; k < a->angle_count; k++)
        if (partner(c, k) >= 0 && (best < 0 || cos(a->angles[k] - angle) > cos(a->angles[best] - angle))) best = k;
    return best;
}

/// The common angle of the largest mean of the first, or -1.
static int strongest_common(const pdmc_comparison *c, int tip)
{
    const pdmc_results *a = c->results[0];
    const pdmc_estimate *mean = &a->statistics[c->measure].mean[pdmc_place(a, tip, 0)];
    int best = -1;
    for (int k = 0; k < a->angle_count; k++)
        if (partner(c, k) >= 0 && (best < 0 || mean[k].value > mean[best].value)) best = k;
    return best;
}

static void add_angle(const pdmc_comparison *c, pdmc_compared_tip *tip, int angle)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    pdmc_compared_angle next = {.angle = a->angles[angle]};
    next.place[0] = pdmc_place(a, tip->number[0], angle);
    next.place[1] = pdmc_place(b, tip->number[1], partner(c, angle));
    for (int k = 0; k < tip->angle_count; k++)
        if (tip->angles[k].place[0] == next.place[0]) return;
    tip->angles[tip->angle_count++] = next;
}

static pdmc_status choose_angles(const pdmc_comparison *c, const pdmc_comparison_request *request,
                                 pdmc_compared_tip *tip)
{
    pdmc_status status = PDMC_OK;
    const double ahead = c->results[0]->tips[tip->number[0]].direction;
    PDMC_NEW(tip->angles, request->angle_count + 2);
    for (int k = 0; k < request->angle_count; k++) {
        const int angle = nearest_common(c, request->angles[k]);
        if (angle < 0) break;
        const double found = c->results[0]->angles[angle];
        if (!is_near(found, request->angles[k], asked_angle))
            PDMC_FAIL(PDMC_ERR_ARG, "%g deg is no angle of both files; the nearest is %g deg",
                      request->angles[k] * pdmc_degrees, found * pdmc_degrees);
        add_angle(c, tip, angle);
    }
    if (request->angle_count > 0 || nearest_common(c, ahead) < 0) goto done;
    add_angle(c, tip, nearest_common(c, ahead));
    add_angle(c, tip, strongest_common(c, tip->number[0]));

done:
    return status;
}

int pdmc_compared_samples(const pdmc_comparison *c, int which)
{
    const int own = c->results[which]->kept_count, other = c->results[1 - which]->kept_count;
    return c->paired && other < own ? other : own;
}

/// The energies of the samples that did not fail, of pairs in neither of the two.
static size_t gather(const pdmc_comparison *c, const pdmc_compared_angle *angle, int which, double x[])
{
    const pdmc_results *r = c->results[which], *other = c->results[1 - which];
    const size_t stride = pdmc_place(r, r->tip_count, 0);
    size_t count = 0;
    for (size_t s = 0; s < (size_t)pdmc_compared_samples(c, which); s++)
        if (r->failure[s] == PDMC_SAMPLE_OK && (!c->paired || other->failure[s] == PDMC_SAMPLE_OK))
            x[count++] = r->energy[c->measure][s * stride + angle->place[which]];
    return count;
}

/// The sample that is number `count` of those that both have.
static int sample_number(const pdmc_comparison *c, size_t count)
{
    int s = 0;
    for (;; s++) {
        const bool is_whole =
            c->results[0]->failure[s] == PDMC_SAMPLE_OK && c->results[1]->failure[s] == PDMC_SAMPLE_OK;
        if (is_whole && count-- == 0) return s;
    }
}

static pdmc_status compare_angle(const pdmc_comparison *c, pdmc_compared_angle *angle)
{
    pdmc_status status = PDMC_OK;
    const double confidence = c->results[0]->confidence;
    double *x[PDMC_COMPARED] = {NULL, NULL};
    size_t n[PDMC_COMPARED];
    for (int i = 0; i < PDMC_COMPARED; i++) {
        PDMC_NEW(x[i], pdmc_compared_samples(c, i));
        n[i] = gather(c, angle, i, x[i]);
    }
    pdmc_statistics_means(n[0], x[0], n[1], x[1], c->paired, confidence, &angle->difference, &angle->ratio);
    PDMC_TRY(pdmc_statistics_distances(n[0], x[0], n[1], x[1], c->paired, confidence, &angle->distances));
    if (!c->paired) goto done;
    PDMC_TRY(pdmc_statistics_pairs(n[0], x[0], x[1], confidence, &angle->pairs));
    if (n[0] > 0) angle->largest_sample = sample_number(c, angle->pairs.largest_at);

done:
    for (int i = 0; i < PDMC_COMPARED; i++) pdmc_free(x[i]);
    return status;
}

static pdmc_status compare_tip(const pdmc_comparison *c, const pdmc_comparison_request *request, pdmc_compared_tip *tip)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(choose_angles(c, request, tip));
    for (int k = 0; k < tip->angle_count; k++) PDMC_TRY(compare_angle(c, &tip->angles[k]));

done:
    return status;
}

static int find_tip(const pdmc_results *r, const char *name)
{
    for (int t = 0; t < r->tip_count; t++)
        if (strcmp(r->tips[t].name, name) == 0) return t;
    return -1;
}

static void list_tips(const pdmc_results *r, size_t size, char text[])
{
    char name[PDMC_LINE_SIZE];
    size_t used = 0;
    snprintf(text, size, "no tips");
    for (int t = 0; t < r->tip_count && used < size; t++)
        used += (size_t)snprintf(&text[used], size - used, "%s%s", t ? ", " : "", pdmc_one_line(name, r->tips[t].name));
}

static void note_tip(const pdmc_comparison *c, int which, const pdmc_tip *tip, FILE *notes)
{
    char name[PDMC_LINE_SIZE];
    fprintf(notes, "the tip %s is in %s only\n", pdmc_one_line(name, tip->name), c->labels[which]);
}

/// Tips go by their names; those that only one of the files has are told of.
static pdmc_status match_tips(pdmc_comparison *c, FILE *notes)
{
    pdmc_status status = PDMC_OK;
    const pdmc_results *a = c->results[0], *b = c->results[1];
    char text[PDMC_COMPARED][200];
    PDMC_NEW(c->tips, a->tip_count);
    for (int t = 0; t < a->tip_count; t++) {
        const int other = find_tip(b, a->tips[t].name);
        if (other >= 0) c->tips[c->tip_count++] = (pdmc_compared_tip){.number = {t, other}};
        else note_tip(c, 0, &a->tips[t], notes);
    }
    for (int t = 0; t < b->tip_count; t++)
        if (find_tip(a, b->tips[t].name) < 0) note_tip(c, 1, &b->tips[t], notes);
    if (c->tip_count > 0 || a->kind == PDMC_DYNAMIC) goto done;
    for (int i = 0; i < PDMC_COMPARED; i++) list_tips(c->results[i], sizeof text[i], text[i]);
    PDMC_FAIL(PDMC_ERR_DATA, "%s and %s have no tip in common: %s; %s", c->labels[0], c->labels[1], text[0], text[1]);

done:
    return status;
}

static pdmc_status compare_named_tips(const pdmc_comparison *c, const pdmc_comparison_request *request)
{
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < request->tip_count; i++) {
        pdmc_compared_tip *tip = NULL;
        for (int t = 0; t < c->tip_count; t++)
            if (strcmp(pdmc_compared_name(c, &c->tips[t]), request->tips[i]) == 0) tip = &c->tips[t];
        if (!tip) PDMC_FAIL(PDMC_ERR_ARG, "%.80s is no tip of both files", request->tips[i]);
        if (tip->angles) continue; // named twice
        PDMC_TRY(compare_tip(c, request, tip));
    }
    if (request->tip_count == 0 && c->tip_count > 0) PDMC_TRY(compare_tip(c, request, &c->tips[0]));

done:
    return status;
}

/// The same in every one of the samples; of no values, not.
static bool same_values(int samples, const double a[], const double b[], int width_a, int width_b)
{
    if (width_a != width_b || width_a == 0 || samples == 0) return false;
    return memcmp(a, b, (size_t)samples * (size_t)width_a * sizeof *a) == 0;
}

/// Samples of equal seeds are drawn with the same random numbers, whatever is drawn from them: they are pairs.
static void find_pairs(pdmc_comparison *c)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    c->paired = a->seed == b->seed && a->sample_count == b->sample_count && a->sample_count > 0;
    c->same_load = c->paired && same_values(a->sample_count, a->load_factor, b->load_factor, 1, 1);
    c->same_micromodulus =
        c->paired && (a->bin_count == 0 && b->bin_count == 0
                          ? true
                          : same_values(pdmc_compared_samples(c, 0), a->micromodulus, b->micromodulus, a->bin_count,
                                         b->bin_count));
}

static void note_angles(const pdmc_comparison *c, FILE *notes)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    int common = 0;
    for (int k = 0; k < a->angle_count; k++) common += partner(c, k) >= 0;
    if (common == a->angle_count && common == b->angle_count) return;
    fprintf(notes, "%d and %d angles: energies are compared at the %d that both have\n", a->angle_count, b->angle_count,
            common);
}

/// From the resolved study. It has no need to include files, and what has may not be from us.
static void find_method(const pdmc_results *r, char text[PDMC_METHOD_SIZE])
{
    config_t study;
    const char *method = NULL, *crack_model = NULL;
    if (!r->resolved || strstr(r->resolved, "@include")) return;
    config_init(&study);
    if (config_read_string(&study, r->resolved) && config_lookup_string(&study, "solver.method", &method)) {
        config_lookup_string(&study, "solver.crack_model", &crack_model);
        snprintf(text, PDMC_METHOD_SIZE, "%s%s%s", method, crack_model ? ", " : "", crack_model ? crack_model : "");
    }
    config_destroy(&study);
}

static pdmc_status compare(const pdmc_comparison_request *request, pdmc_comparison *c, FILE *notes)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(pdmc_comparison_check(c));
    PDMC_TRY(match_tips(c, notes));
    find_pairs(c);
    note_angles(c, notes);
    pdmc_comparison_remark(c, notes);
    for (int i = 0; i < PDMC_COMPARED; i++) find_method(c->results[i], c->method[i]);
    PDMC_TRY(compare_named_tips(c, request));

done:
    return status;
}

pdmc_status pdmc_comparison_create(const pdmc_results *first, const pdmc_results *second,
                                   const pdmc_comparison_request *request, pdmc_comparison **comparison)
{
    pdmc_status status = PDMC_OK;
    pdmc_comparison *c = NULL;
    size_t size;
    FILE *notes = NULL;
    PDMC_NEW(c, 1);
    *c = (pdmc_comparison){.results = {first, second}};
    c->measure = request->has_measure ? request->measure : first->measure;
    for (int i = 0; i < PDMC_COMPARED; i++)
        if (!(c->labels[i] = pdmc_strdup(request->labels[i]))) PDMC_FAIL(PDMC_ERR_NOMEM, "out of memory");
    notes = open_memstream(&c->notes, &size);
    if (!notes) PDMC_FAIL(PDMC_ERR_NOMEM, "out of memory for the notes of a comparison");
    PDMC_TRY(compare(request, c, notes));

done:
    if (notes && fclose(notes) != 0 && status == PDMC_OK)
        status = pdmc_raise(PDMC_ERR_NOMEM, "out of memory for the notes of a comparison");
    if (status != PDMC_OK) pdmc_comparison_destroy(&c);
    else *comparison = c;
    return status;
}

const char *pdmc_comparison_notes(const pdmc_comparison *comparison)
{
    return comparison->notes;
}

void pdmc_comparison_destroy(pdmc_comparison **comparison)
{
    pdmc_comparison *c = *comparison;
    if (!c) return;
    for (int i = 0; i < PDMC_COMPARED; i++) pdmc_free(c->labels[i]);
    for (int t = 0; t < c->tip_count; t++) pdmc_free(c->tips[t].angles);
    pdmc_free(c->tips);
    free(c->notes); // the stream's own
    pdmc_free(c);
    *comparison = NULL;
}
