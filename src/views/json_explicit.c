// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/explicit.h"
#include "views/json_parts.h"

static json_t *records(const pdmc_explicit_record *p)
{
    const struct {
        const char *name;
        const double *values;
    } columns[] = {
        {pdmc_is_at_rest(p) ? "load" : "time", p->time},
        {"kinetic", p->kinetic},
        {"elastic", p->elastic},
        {"contact", p->contact},
        {"fracture", p->fracture},
        {"dissipated", p->dissipated},
        {"work", p->work},
        {"mean_damage", p->mean_damage},
        {"broken", p->broken},
        {"force_error", p->compared_count > 0 ? p->force_error : NULL},
        {"residual", p->residual},
        {"relaxation_steps", p->relaxation_steps},
        {"breakages", p->breakages},
        {"fragments", p->fragments},
        {"loose_nodes", p->loose_nodes},
        {"largest_fragment", p->largest_fragment},
    };
    json_t *object = json_object(), *momentum = json_array();
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++)
        if (columns[i].values)
            pdmc_json_put(&object, columns[i].name, pdmc_json_numbers((size_t)p->record_count, columns[i].values));
    for (int i = 0; i < p->record_count; i++)
        pdmc_json_append(&momentum, pdmc_json_numbers(PDMC_AXES, &p->momentum[3 * i]));
    pdmc_json_put(&object, "momentum", momentum);
    return object;
}

static json_t *tip(const pdmc_explicit_record *p, int t)
{
    const pdmc_tip_growth g = pdmc_results_growth(p, t);
    json_t *object = json_object(), *advance = json_array(), *speed = json_array();
    pdmc_json_put(&object, "name", pdmc_json_text(p->tips[t].name));
    pdmc_json_put(&object, "position", pdmc_json_numbers(2, p->tips[t].position));
    pdmc_json_put(&object, "direction", pdmc_json_numbers(2, p->tips[t].direction));
    pdmc_json_put(&object, "growth", pdmc_json_number(g.growth));
    pdmc_json_put(&object, "begin", pdmc_json_number(g.begin));
    pdmc_json_put(&object, "end", pdmc_json_number(g.end));
    if (!pdmc_is_at_rest(p)) {
        pdmc_json_put(&object, "mean_speed", pdmc_json_number(g.mean_speed));
        pdmc_json_put(&object, "most_speed", pdmc_json_number(g.most_speed));
    }
    for (int i = 0; i < p->record_count; i++) {
        pdmc_json_append(&advance, pdmc_json_number(pdmc_of_tip(p, p->tip_advance, i, t)));
        pdmc_json_append(&speed, pdmc_json_number(pdmc_of_tip(p, p->tip_speed, i, t)));
    }
    pdmc_json_put(&object, "advance", advance);
    pdmc_json_put(&object, "speed", speed);
    return object;
}

static json_t *sphere(const pdmc_explicit_record *p, int s)
{
    json_t *object = json_object(), *centre = json_array(), *velocity = json_array(), *force = json_array();
    pdmc_json_put(&object, "name", pdmc_json_text(p->spheres[s].name));
    pdmc_json_put(&object, "radius", pdmc_json_number(p->spheres[s].radius));
    pdmc_json_put(&object, "mass", pdmc_json_number(p->spheres[s].mass));
    for (int i = 0; i < p->record_count; i++) {
        pdmc_json_append(&centre, pdmc_json_numbers(PDMC_AXES, pdmc_of_sphere(p, p->sphere_centre, i, s)));
        pdmc_json_append(&velocity, pdmc_json_numbers(PDMC_AXES, pdmc_of_sphere(p, p->sphere_velocity, i, s)));
        pdmc_json_append(&force, pdmc_json_numbers(PDMC_AXES, pdmc_of_sphere(p, p->sphere_force, i, s)));
    }
    pdmc_json_put(&object, "centre", centre);
    pdmc_json_put(&object, "velocity", velocity);
    pdmc_json_put(&object, "force", force);
    return object;
}

static json_t *condition(const pdmc_explicit_record *p, int c)
{
    json_t *object = json_object(), *force = json_array(), *displacement = json_array();
    pdmc_json_put(&object, "name", pdmc_json_text(p->conditions[c].name));
    for (int i = 0; i < p->record_count; i++) {
        pdmc_json_append(&force, pdmc_json_numbers(PDMC_AXES, pdmc_of_condition(p, p->condition_force, i, c)));
        pdmc_json_append(&displacement,
                         pdmc_json_numbers(PDMC_AXES, pdmc_of_condition(p, p->condition_displacement, i, c)));
    }
    if (pdmc_is_at_rest(p) && p->record_count > 0) {
        double largest;
        const int at = pdmc_results_largest_force(p, c, &largest);
        pdmc_json_put(&object, "largest_force", pdmc_json_number(largest));
        pdmc_json_put(&object, "largest_force_between_loads", pdmc_json_number(pdmc_results_force_between(p, c)));
        pdmc_json_put(&object, "displacement_at_largest_force",
                      pdmc_json_number(pdmc_norm_of(pdmc_of_condition(p, p->condition_displacement, at, c))));
    }
    pdmc_json_put(&object, "force", force);
    pdmc_json_put(&object, "displacement", displacement);
    return object;
}

static json_t *interface(const pdmc_explicit_record *p, int k)
{
    json_t *object = json_object(), *broken = json_array();
    pdmc_json_put(&object, "name", pdmc_json_text(p->interfaces[k].name));
    pdmc_json_put(&object, "bonds", pdmc_json_number(p->interfaces[k].bonds));
    for (int i = 0; i < p->record_count; i++)
        pdmc_json_append(&broken, pdmc_json_number(pdmc_of_interface(p, p->interface_broken, i, k)));
    pdmc_json_put(&object, "broken", broken);
    return object;
}

static json_t *last(const pdmc_explicit_record *p)
{
    const int i = p->record_count - 1;
    json_t *object = json_object();
    if (i < 0) return object;
    pdmc_json_put(&object, "time", pdmc_json_number(p->time[i]));
    pdmc_json_put(&object, "fracture", pdmc_json_number(p->fracture[i]));
    pdmc_json_put(&object, "mean_damage", pdmc_json_number(p->mean_damage[i]));
    pdmc_json_put(&object, "broken", pdmc_json_number(p->broken[i]));
    pdmc_json_put(&object, "fragments", pdmc_json_number(p->fragments[i]));
    pdmc_json_put(&object, "loose_nodes", pdmc_json_number(p->loose_nodes[i]));
    pdmc_json_put(&object, "largest_fragment", pdmc_json_number(p->largest_fragment[i]));
    return object;
}

static json_t *fragment(const pdmc_fragment *f)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "nodes", json_integer(f->nodes));
    pdmc_json_put(&object, "mass", pdmc_json_number(f->mass));
    pdmc_json_put(&object, "centre", pdmc_json_numbers(PDMC_AXES, f->centre));
    pdmc_json_put(&object, "velocity", pdmc_json_numbers(PDMC_AXES, f->velocity));
    return object;
}

// Single nodes are counted, not listed: there may be as many as nodes.
static json_t *fragments(const pdmc_explicit_record *p)
{
    json_t *list = json_array();
    for (int i = 0; i < p->fragment_count; i++)
        if (p->fragment_list[i].nodes > 1) pdmc_json_append(&list, fragment(&p->fragment_list[i]));
    return list;
}

json_t *pdmc_json_explicit(const pdmc_explicit_record *p)
{
    json_t *object = json_object(), *tips = json_array(), *spheres = json_array(), *conditions = json_array();
    json_t *interfaces = json_array();
    pdmc_json_put(&object, "dimension", json_integer(p->dimension));
    pdmc_json_put(&object, "nodes", json_integer(p->node_count));
    pdmc_json_put(&object, "bonds", pdmc_json_number(p->bonds));
    pdmc_json_put(&object, "spacing", pdmc_json_number(p->spacing));
    pdmc_json_put(&object, "horizon", pdmc_json_number(p->horizon));
    pdmc_json_put(&object, "step", pdmc_json_number(p->step));
    pdmc_json_put(&object, "stable_step", pdmc_json_number(p->stable_step));
    pdmc_json_put(&object, "steps", pdmc_json_number(p->steps));
    pdmc_json_put(&object, "kernel", pdmc_json_text(p->kernel));
    pdmc_json_put(&object, "precision", pdmc_json_text(p->compared_count > 0 ? "single" : "double"));
    if (p->compared_count > 0) pdmc_json_put(&object, "force_error", pdmc_json_number(pdmc_explicit_force_error(p)));
    pdmc_json_put(&object, "first_kinetic", pdmc_json_number(p->first));
    pdmc_json_put(&object, "balance_error", pdmc_json_number(pdmc_explicit_balance_error(p)));
    pdmc_json_put(&object, "last", last(p));
    for (int t = 0; t < p->tip_count; t++) pdmc_json_append(&tips, tip(p, t));
    for (int s = 0; s < p->sphere_count; s++) pdmc_json_append(&spheres, sphere(p, s));
    for (int c = 0; c < p->condition_count; c++) pdmc_json_append(&conditions, condition(p, c));
    for (int k = 0; k < p->interface_count; k++) pdmc_json_append(&interfaces, interface(p, k));
    pdmc_json_put(&object, "tips", tips);
    pdmc_json_put(&object, "spheres", spheres);
    pdmc_json_put(&object, "conditions", conditions);
    pdmc_json_put(&object, "interfaces", interfaces);
    pdmc_json_put(&object, "fragments", fragments(p));
    pdmc_json_put(&object, "records", records(p));
    pdmc_json_put(&object, "snapshot_times", pdmc_json_numbers((size_t)p->snapshot_count, p->snapshot_time));
    return object;
}
