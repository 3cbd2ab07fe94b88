// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "results/layout.h"

#include <math.h>
#include <string.h>

const double pdmc_quantile_levels[PDMC_QUANTILES] = {0.05, 0.50, 0.95};
const pdmc_sample_accuracy pdmc_no_accuracy = {
    NAN, NAN, {NAN, NAN}, {NAN, NAN}, NAN, {NAN, NAN}, {{NAN, NAN, NAN}, {NAN, NAN, NAN}}};

const char *const pdmc_measure_names[PDMC_MEASURES] = {
    [PDMC_MEASURE_BOND] = "bond_energy",
    [PDMC_MEASURE_GRIFFITH] = "griffith_energy",
};

const char *const pdmc_outcome_names[PDMC_OUTCOMES] = {"still", "arrested", "running", "through"};

void pdmc_results_clear(pdmc_results *results)
{
    for (size_t i = 0; i < pdmc_dataset_count; i++) {
        const pdmc_dataset *dataset = &pdmc_datasets[i];
        if (dataset->stride == 0) continue;
        pdmc_free(pdmc_dataset_memory(results, dataset));
        pdmc_dataset_set_memory(results, dataset, NULL); // several columns share an array
    }
    for (size_t i = 0; i < pdmc_attribute_count; i++) {
        char **text = pdmc_attribute_text(results, &pdmc_attributes[i]);
        if (text) pdmc_free(*text);
    }
    pdmc_free(results->pdmc_version);
    *results = (pdmc_results){0};
}

// F stands for the unit of force, L for that of length, T for that of time.
static const char *base_unit(const pdmc_results *results, char letter, const char *otherwise)
{
    switch (letter) {
    case 'F': return results->force_unit;
    case 'L': return results->length_unit;
    case 'T': return results->time_unit;
    default: return otherwise;
    }
}

void pdmc_results_unit(const pdmc_results *results, pdmc_unit unit, size_t size, char text[])
{
    static const char *const patterns[] = {
        [PDMC_UNIT_NONE] = "1",     [PDMC_UNIT_ANGLE] = "rad",    [PDMC_UNIT_TIME] = "s",
        [PDMC_UNIT_LENGTH] = "L",   [PDMC_UNIT_STRESS] = "F/L^2", [PDMC_UNIT_STRESS_INTENSITY] = "F/L^(3/2)",
        [PDMC_UNIT_ENERGY] = "F/L", [PDMC_UNIT_DENSITY] = "L/F",  [PDMC_UNIT_STUDY_TIME] = "T",
        [PDMC_UNIT_WORK] = "F L",     [PDMC_UNIT_BYTE] = "byte",   [PDMC_UNIT_VELOCITY] = "L/T",
        [PDMC_UNIT_MASS] = "F T^2/L", [PDMC_UNIT_MOMENTUM] = "F T",
        [PDMC_UNIT_FORCE] = "F",
        [PDMC_UNIT_PER_LENGTH] = "1/L",
    };
    size_t used = 0;
    for (const char *p = patterns[unit]; *p; p++) {
        const char one[2] = {*p, '\0'}, *piece = base_unit(results, *p, one);
        for (; piece && *piece && used + 1 < size; piece++) text[used++] = *piece;
    }
    if (size > 0) text[used] = '\0';
}

static pdmc_status check_counts(const pdmc_results *results, pdmc_status code)
{
    for (size_t i = 0; i < pdmc_dataset_count; i++)
        for (const pdmc_dimension *axis = pdmc_datasets[i].axes; *axis != PDMC_DIM_END; axis++) {
            int more;
            const int *count = pdmc_dimension_field((pdmc_results *)results, *axis, &more);
            if (count && *count < 0)
                return pdmc_raise(code, "%s: the axis \"%s\" counts %d", pdmc_datasets[i].path,
                                  pdmc_dimension_label(*axis), *count);
        }
    return PDMC_OK;
}

static pdmc_status check_arrays(const pdmc_results *results, pdmc_status code)
{
    for (size_t i = 0; i < pdmc_dataset_count; i++)
        if (pdmc_dataset_belongs(results, &pdmc_datasets[i]) &&
            pdmc_dataset_size(results, &pdmc_datasets[i]) > 0 && !pdmc_dataset_memory(results, &pdmc_datasets[i]))
            return pdmc_raise(code, "%s: the array is missing", pdmc_datasets[i].path);
    return PDMC_OK;
}

static pdmc_status check_choices(const pdmc_results *results, pdmc_status code)
{
    for (size_t i = 0; i < pdmc_attribute_count; i++) {
        const pdmc_attribute *attribute = &pdmc_attributes[i];
        if (attribute->kind != PDMC_ATTRIBUTE_CHOICE) continue;
        int choice;
        memcpy(&choice, (const char *)results + attribute->member, sizeof choice);
        if (choice < 0 || choice >= attribute->choice_count)
            return pdmc_raise(code, "%s = %d is none of the %d known", attribute->name, choice,
                              attribute->choice_count);
    }
    return PDMC_OK;
}

static pdmc_status check_failures(const pdmc_results *results, pdmc_status code)
{
    int failed = 0;
    for (int i = 0; i < results->sample_count; i++) {
        if (results->failure[i] > PDMC_SAMPLE_GEOMETRY)
            return pdmc_raise(code, "sample %d: unknown reason of failure %d", i, results->failure[i]);
        failed += results->failure[i] != PDMC_SAMPLE_OK;
    }
    if (failed != results->failed_count)
        return pdmc_raise(code, "%d samples are marked as failed, but %d are counted", failed, results->failed_count);
    return PDMC_OK;
}

static pdmc_status check_draws(const pdmc_results *results, pdmc_status code)
{
    const pdmc_ensemble_results *e = &results->ensemble;
    int failed = 0;
    if (e->tip_count != 0 && e->tip_count != results->particles.tip_count)
        return pdmc_raise(code, "%d of %d tips have samples", e->tip_count, results->particles.tip_count);
    for (int i = 0; i < e->sample_count; i++) {
        if (e->failure[i] > PDMC_SAMPLE_GEOMETRY)
            return pdmc_raise(code, "sample %d: unknown reason of failure %d", i, e->failure[i]);
        failed += e->failure[i] != PDMC_SAMPLE_OK;
    }
    for (int i = 0; i < e->sample_count * e->tip_count; i++)
        if (e->outcome[i] >= PDMC_OUTCOMES) return pdmc_raise(code, "tip %d of all: unknown outcome %d", i, e->outcome[i]);
    if (failed == e->failed_count) return PDMC_OK;
    return pdmc_raise(code, "%d samples are marked as failed, but %d are counted", failed, e->failed_count);
}

static pdmc_status check_kept(const pdmc_results *results, pdmc_status code)
{
    if (results->kept_count > results->sample_count)
        return pdmc_raise(code, "%d of %d samples are kept", results->kept_count, results->sample_count);
    return PDMC_OK;
}

static pdmc_status check_control(const pdmc_results *results, pdmc_status code)
{
    const int tips = results->control.tip_count;
    if (tips != 0 && tips != results->tip_count)
        return pdmc_raise(code, "%d of %d tips have a control", tips, results->tip_count);
    return PDMC_OK;
}

static pdmc_status check_names(const pdmc_results *results, pdmc_status code)
{
    for (int i = 0; i < results->tip_count; i++)
        if (!memchr(results->tips[i].name, '\0', sizeof results->tips[i].name))
            return pdmc_raise(code, "the name of tip %d has no end", i);
    for (int i = 0; i < results->motion.probe_count; i++)
        if (!memchr(results->motion.probes[i].name, '\0', sizeof results->motion.probes[i].name))
            return pdmc_raise(code, "the name of probe %d has no end", i);
    return PDMC_OK;
}

static bool has_no_end(const char name[PDMC_LONG_NAME_SIZE])
{
    return !memchr(name, '\0', PDMC_LONG_NAME_SIZE);
}

static pdmc_status check_particle_names(const pdmc_results *results, pdmc_status code)
{
    const pdmc_explicit_record *p = &results->particles;
    int without = 0;
    for (int i = 0; i < p->tip_count; i++) without += has_no_end(p->tips[i].name);
    for (int i = 0; i < p->sphere_count; i++) without += has_no_end(p->spheres[i].name);
    for (int i = 0; i < p->body_count; i++) without += has_no_end(p->bodies[i].name);
    for (int i = 0; i < p->condition_count; i++) without += has_no_end(p->conditions[i].name);
    for (int i = 0; i < p->interface_count; i++) without += has_no_end(p->interfaces[i].name);
    for (int i = 0; i < results->quadrature.rule_count; i++) without += has_no_end(results->quadrature.rules[i].name);
    return without == 0
               ? PDMC_OK
               : pdmc_raise(code, "%d names of tips, spheres, bodies, conditions, interfaces or rules have no end", without);
}

static pdmc_status check_states(const pdmc_results *results, pdmc_status code)
{
    const pdmc_explicit_record *p = &results->particles;
    if ((int64_t)p->snapshot_count * p->node_count != p->state_count)
        return pdmc_raise(code, "%d states of %d nodes are not %d snapshots", p->state_count, p->node_count,
                          p->snapshot_count);
    for (int i = 0; i < p->node_count; i++)
        if (p->node_body[i] < 0 || p->node_body[i] >= p->body_count)
            return pdmc_raise(code, "node %d is of body %d, of %d", i, p->node_body[i], p->body_count);
    for (int i = 0; i < p->state_count; i++)
        if (p->fragment[i] < 0 || p->fragment[i] >= p->node_count)
            return pdmc_raise(code, "state %d is of piece %d, of %d nodes", i, p->fragment[i], p->node_count);
    const int *last = p->snapshot_count > 0 ? &p->fragment[p->state_count - p->node_count] : NULL;
    for (int i = 0; last && i < p->node_count; i++)
        if (last[i] >= p->fragment_count)
            return pdmc_raise(code, "node %d is of piece %d at the end, of %d", i, last[i], p->fragment_count);
    return PDMC_OK;
}

static pdmc_status check_faces(const pdmc_results *results, pdmc_status code)
{
    for (int i = 0; i < results->motion.probe_count; i++)
        if (results->motion.probes[i].face < PDMC_FACE_NONE || results->motion.probes[i].face > PDMC_FACE_RIGHT)
            return pdmc_raise(code, "probe %d: unknown face %d", i, results->motion.probes[i].face);
    return PDMC_OK;
}

pdmc_status pdmc_results_check(const pdmc_results *results, pdmc_status code)
{
    pdmc_status (*const checks[])(const pdmc_results *, pdmc_status) = {check_counts,   check_arrays, check_choices,
                                                                        check_failures, check_kept,   check_names, check_faces,
                                                                        check_particle_names, check_draws, check_states,   check_control};
    for (size_t i = 0; i < sizeof checks / sizeof checks[0]; i++) {
        const pdmc_status status = checks[i](results, code);
        if (status != PDMC_OK) return status;
    }
    return PDMC_OK;
}
