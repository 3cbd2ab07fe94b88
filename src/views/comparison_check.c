// SPDX-License-Identifier: GPL-3.0-or-later

/// Whether two results can be compared, and what one should know who compares them.

#include "views/comparison_check.h"
#include "base/base_impl.h"
#include "views/table.h"

#include <string.h>

static const char *named(pdmc_problem_kind kind)
{
    static const char *const names[] = {
        [PDMC_EXPLICIT] = "an explicit", [PDMC_QUASI_STATIC] = "a quasi-static", [PDMC_SCALAR] = "a scalar",
        [PDMC_ELASTIC] = "an elastic",
        [PDMC_QUADRATURE] = "a quadrature"};
    return names[kind];
}

static const char *kind_name(const pdmc_results *r)
{
    return r->kind == PDMC_DYNAMIC ? "dynamic" : "static";
}

static pdmc_status check_unit(const pdmc_comparison *c, const char *what, const char *first, const char *second)
{
    if (strcmp(first, second) == 0) return PDMC_OK;
    return pdmc_raise(PDMC_ERR_DATA, "%s and %s have different units of %s, %.40s and %.40s", c->labels[0],
                      c->labels[1], what, first, second);
}

pdmc_status pdmc_comparison_check(const pdmc_comparison *c)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    for (int i = 0; i < PDMC_COMPARED; i++)
        if (!pdmc_is_of_plate(c->results[i]->kind))
            return pdmc_raise(PDMC_ERR_DATA, "%s is of %s study, which is not compared yet", c->labels[i],
                              named(c->results[i]->kind));
    if (a->kind != b->kind)
        return pdmc_raise(PDMC_ERR_DATA, "%s is of a %s study and %s of a %s one", c->labels[0], kind_name(a),
                          c->labels[1], kind_name(b));
    pdmc_status status = check_unit(c, "length", a->length_unit, b->length_unit);
    if (status == PDMC_OK) status = check_unit(c, "force", a->force_unit, b->force_unit);
    if (status == PDMC_OK && a->kind == PDMC_DYNAMIC) status = check_unit(c, "time", a->time_unit, b->time_unit);
    return status;
}

static void remark_number(FILE *notes, const char *name, double a, double b, const char *unit, const char *what)
{
    if (a != b) fprintf(notes, "%s is %.6g and %.6g %.20s: %s\n", name, a, b, unit, what);
}

// What else the distributions depend on, besides the method.
static void remark_problem(const pdmc_comparison *c, FILE *notes)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    char unit[PDMC_UNIT_SIZE];
    pdmc_results_unit(a, PDMC_UNIT_ENERGY, sizeof unit, unit);
    remark_number(notes, "G_c", a->fracture_energy, b->fracture_energy, unit, "P(G > G_c) differs with it");
    if (a->measure != b->measure)
        fprintf(notes, "P(G > G_c) and the direction are of the %s and of the %s energy\n",
                pdmc_measure_title(a->measure), pdmc_measure_title(b->measure));
    remark_number(notes, "the plate's width", a->plate_width, b->plate_width, a->length_unit, "other plates");
    remark_number(notes, "the plate's height", a->plate_height, b->plate_height, a->length_unit, "other plates");
    if (c->measure != PDMC_MEASURE_BOND) return;
    remark_number(notes, "the extension", a->extension, b->extension, a->length_unit, "bond energies depend on it");
    remark_number(notes, "the horizon of the energy", a->energy_horizon, b->energy_horizon, a->length_unit,
                  "bond energies depend on it");
    if (a->bonds != b->bonds)
        fputs("bond energies count all bonds in one of the files, and bonds in tension only in the other\n", notes);
}

static void remark_kept(const pdmc_comparison *c, FILE *notes)
{
    for (int i = 0; i < PDMC_COMPARED; i++)
        if (pdmc_compared_samples(c, i) < c->results[i]->sample_count)
            fprintf(notes, "energies are compared of the first %d of the %d samples of %s\n", pdmc_compared_samples(c, i),
                    c->results[i]->sample_count, c->labels[i]);
}

static void remark_samples(const pdmc_comparison *c, FILE *notes)
{
    const pdmc_results *a = c->results[0], *b = c->results[1];
    if (a->sample_count == 0 || b->sample_count == 0)
        fprintf(notes, "%s has no samples\n", c->labels[a->sample_count == 0 ? 0 : 1]);
    else if (a->seed == b->seed && !c->paired)
        fputs("the same seed, but different numbers of samples: taken as independent, so that p and intervals of "
              "differences are too large\n",
              notes);
    else if (c->paired && !c->same_load && !c->same_micromodulus)
        fputs("the same seed, but other load factors and another stiffness\n", notes);
}

void pdmc_comparison_remark(const pdmc_comparison *c, FILE *notes)
{
    if (c->results[0]->kind == PDMC_DYNAMIC) {
        fputs("dynamic studies have no samples, and their motions are not compared\n", notes);
        return;
    }
    remark_problem(c, notes);
    remark_samples(c, notes);
    remark_kept(c, notes);
}
