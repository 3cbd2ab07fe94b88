// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/csv.h"

#include "views/explicit.h"

enum { COLUMN_SIZE = PDMC_LONG_NAME_SIZE + 16 };

static void put_header(const pdmc_results *r, FILE *stream)
{
    static const char *const energies[] = {"kinetic", "elastic", "fracture", "contact", "dissipated", "work"};
    const pdmc_explicit_record *p = &r->particles;
    char unit[PDMC_UNIT_SIZE], velocity[PDMC_UNIT_SIZE], column[COLUMN_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    fprintf(stream, "record");
    if (pdmc_is_at_rest(p)) fputs(",load", stream);
    else pdmc_csv_column(stream, "time", r->time_unit);
    for (size_t i = 0; i < sizeof energies / sizeof energies[0]; i++) pdmc_csv_column(stream, energies[i], unit);
    pdmc_results_unit(r, PDMC_UNIT_MOMENTUM, sizeof unit, unit);
    pdmc_csv_axes(stream, "momentum", "", unit);
    fputs(",mean_damage,broken,fragments,loose_nodes", stream);
    pdmc_results_unit(r, PDMC_UNIT_MASS, sizeof unit, unit);
    pdmc_csv_column(stream, "largest_fragment", unit);
    pdmc_results_unit(r, PDMC_UNIT_VELOCITY, sizeof velocity, velocity);
    for (int t = 0; t < p->tip_count; t++) {
        snprintf(column, sizeof column, "%s.advance", p->tips[t].name);
        pdmc_csv_column(stream, column, r->length_unit);
        snprintf(column, sizeof column, "%s.speed", p->tips[t].name);
        pdmc_csv_column(stream, column, velocity);
    }
    for (int s = 0; s < p->sphere_count; s++) {
        pdmc_csv_axes(stream, p->spheres[s].name, ".centre", r->length_unit);
        pdmc_csv_axes(stream, p->spheres[s].name, ".velocity", velocity);
        pdmc_csv_axes(stream, p->spheres[s].name, ".force", r->force_unit);
    }
    for (int c = 0; c < p->condition_count; c++) {
        pdmc_csv_axes(stream, p->conditions[c].name, ".force", r->force_unit);
        pdmc_csv_axes(stream, p->conditions[c].name, ".displacement", r->length_unit);
    }
    for (int k = 0; k < p->interface_count; k++) {
        snprintf(column, sizeof column, "%s.broken", p->interfaces[k].name);
        fputc(',', stream);
        pdmc_csv_text(stream, column);
    }
    if (pdmc_is_at_rest(p)) fputs(",residual,relaxation_steps,breakages", stream);
    if (p->compared_count > 0) fputs(",force_error", stream);
    fputc('\n', stream);
}

pdmc_status pdmc_csv_records(const pdmc_results *results, FILE *stream)
{
    const pdmc_explicit_record *p = &results->particles;
    put_header(results, stream);
    for (int i = 0; i < p->record_count; i++) {
        const double numbers[] = {p->time[i],    p->kinetic[i],    p->elastic[i], p->fracture[i],
                                  p->contact[i], p->dissipated[i], p->work[i]};
        fprintf(stream, "%d", i);
        pdmc_csv_numbers(stream, sizeof numbers / sizeof numbers[0], numbers);
        pdmc_csv_numbers(stream, PDMC_AXES, &p->momentum[3 * i]);
        pdmc_csv_number(stream, p->mean_damage[i]);
        pdmc_csv_number(stream, p->broken[i]);
        pdmc_csv_number(stream, p->fragments[i]);
        pdmc_csv_number(stream, p->loose_nodes[i]);
        pdmc_csv_number(stream, p->largest_fragment[i]);
        for (int t = 0; t < p->tip_count; t++) {
            pdmc_csv_number(stream, pdmc_of_tip(p, p->tip_advance, i, t));
            pdmc_csv_number(stream, pdmc_of_tip(p, p->tip_speed, i, t));
        }
        for (int s = 0; s < p->sphere_count; s++) {
            pdmc_csv_numbers(stream, PDMC_AXES, pdmc_of_sphere(p, p->sphere_centre, i, s));
            pdmc_csv_numbers(stream, PDMC_AXES, pdmc_of_sphere(p, p->sphere_velocity, i, s));
            pdmc_csv_numbers(stream, PDMC_AXES, pdmc_of_sphere(p, p->sphere_force, i, s));
        }
        for (int c = 0; c < p->condition_count; c++) {
            pdmc_csv_numbers(stream, PDMC_AXES, pdmc_of_condition(p, p->condition_force, i, c));
            pdmc_csv_numbers(stream, PDMC_AXES, pdmc_of_condition(p, p->condition_displacement, i, c));
        }
        for (int k = 0; k < p->interface_count; k++)
            pdmc_csv_number(stream, pdmc_of_interface(p, p->interface_broken, i, k));
        const double *const of_rest[] = {p->residual, p->relaxation_steps, p->breakages};
        for (int k = 0; k < 3 && pdmc_is_at_rest(p); k++) pdmc_csv_number(stream, of_rest[k][i]);
        if (p->compared_count > 0) pdmc_csv_number(stream, p->force_error[i]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_nodes(const pdmc_results *results, FILE *stream)
{
    const pdmc_explicit_record *p = &results->particles;
    const size_t first = pdmc_last_state(p);
    char velocity[PDMC_UNIT_SIZE];
    pdmc_results_unit(results, PDMC_UNIT_VELOCITY, sizeof velocity, velocity);
    fprintf(stream, "body");
    pdmc_csv_axes(stream, "position", "", results->length_unit);
    pdmc_csv_axes(stream, "displacement", "", results->length_unit);
    pdmc_csv_axes(stream, "velocity", "", velocity);
    fputs(",damage,fragment\n", stream);
    for (size_t i = 0; p->snapshot_count > 0 && i < (size_t)p->node_count; i++) {
        pdmc_csv_text(stream, p->bodies[p->node_body[i]].name);
        pdmc_csv_numbers(stream, PDMC_AXES, &p->node_position[3 * i]);
        pdmc_csv_numbers(stream, PDMC_AXES, &p->displacement[3 * (first + i)]);
        pdmc_csv_numbers(stream, PDMC_AXES, &p->velocity[3 * (first + i)]);
        pdmc_csv_number(stream, p->damage[first + i]);
        fprintf(stream, ",%d\n", p->fragment[first + i]);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_fragments(const pdmc_results *results, FILE *stream)
{
    const pdmc_explicit_record *p = &results->particles;
    char unit[PDMC_UNIT_SIZE];
    pdmc_results_unit(results, PDMC_UNIT_MASS, sizeof unit, unit);
    fputs("fragment,nodes", stream);
    pdmc_csv_column(stream, "mass", unit);
    pdmc_csv_axes(stream, "centre", "", results->length_unit);
    pdmc_results_unit(results, PDMC_UNIT_VELOCITY, sizeof unit, unit);
    pdmc_csv_axes(stream, "velocity", "", unit);
    fputc('\n', stream);
    for (int i = 0; i < p->fragment_count; i++) {
        const pdmc_fragment *f = &p->fragment_list[i];
        fprintf(stream, "%d,%d", i, f->nodes);
        pdmc_csv_number(stream, f->mass);
        pdmc_csv_numbers(stream, PDMC_AXES, f->centre);
        pdmc_csv_numbers(stream, PDMC_AXES, f->velocity);
        fputc('\n', stream);
    }
    return PDMC_OK;
}
