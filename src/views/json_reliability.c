// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/json_parts.h"

static json_t *record(const pdmc_reliability_record *r)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "method", pdmc_json_text(r->name));
    pdmc_json_put(&object, "probability", pdmc_json_estimate(&r->found.probability));
    pdmc_json_put(&object, "index", pdmc_json_estimate(&r->found.index));
    pdmc_json_put(&object, "coefficient_of_variation", pdmc_json_number(r->found.variation));
    pdmc_json_put(&object, "effective_samples", pdmc_json_number(r->found.effective_samples));
    pdmc_json_put(&object, "largest_share", pdmc_json_number(r->found.largest_share));
    pdmc_json_put(&object, "evaluations", pdmc_json_number(r->evaluations));
    pdmc_json_put(&object, "failed", pdmc_json_number(r->failed));
    pdmc_json_put(&object, "complete", json_boolean(r->complete));
    return object;
}

static json_t *quantity(const pdmc_reliability_group *group)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "name", pdmc_json_text(group->name));
    pdmc_json_put(&object, "variables", json_integer(group->variables));
    pdmc_json_put(&object, "importance", pdmc_json_number(group->importance));
    pdmc_json_put(&object, "first_index", pdmc_json_estimate(&group->first));
    pdmc_json_put(&object, "total_index", pdmc_json_estimate(&group->total));
    return object;
}

json_t *pdmc_json_reliability(const pdmc_reliability_results *r)
{
    json_t *object = json_object(), *first_order = json_object(), *methods = json_array(), *quantities = json_array();
    pdmc_json_put(&first_order, "probability", pdmc_json_number(r->first_order_probability));
    pdmc_json_put(&first_order, "index", pdmc_json_number(r->first_order_index));
    pdmc_json_put(&first_order, "evaluations", pdmc_json_number(r->first_order_evaluations));
    pdmc_json_put(&first_order, "design_point", pdmc_json_numbers((size_t)r->variable_count, r->design_point));
    for (int i = 0; i < r->record_count; i++) pdmc_json_append(&methods, record(&r->records[i]));
    for (int g = 0; g < r->group_count; g++) pdmc_json_append(&quantities, quantity(&r->groups[g]));
    pdmc_json_put(&object, "first_order", first_order);
    pdmc_json_put(&object, "methods", methods);
    pdmc_json_put(&object, "quantities", quantities);
    pdmc_json_put(&object, "solved_in_full", pdmc_json_number(r->solved_in_full));
    return object;
}
