// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/elastic.h"
#include "views/json_parts.h"

json_t *pdmc_json_elastic(const pdmc_elastic_record *e)
{
    json_t *object = json_object(), *faces = json_object(), *line = json_object();
    for (int face = 0; face < PDMC_SOLID_FACES; face++) {
        json_t *one = json_object();
        pdmc_json_put(&one, "displacement", pdmc_json_numbers(3, &e->face_displacement[3 * face]));
        pdmc_json_put(&one, "force", pdmc_json_numbers(3, &e->face_force[3 * face]));
        pdmc_json_put(&faces, pdmc_face_names[face], one);
    }
    pdmc_json_put(&line, "position", pdmc_json_numbers((size_t)e->line_count, e->line_position));
    pdmc_json_put(&line, "displacement", pdmc_json_numbers((size_t)e->line_count, e->line_displacement));
    pdmc_json_put(&line, "strain", pdmc_json_numbers((size_t)e->line_count, e->line_strain));
    pdmc_json_put(&object, "nodes", json_integer(e->node_count));
    pdmc_json_put(&object, "iterations", json_integer(e->iterations));
    pdmc_json_put(&object, "residual", pdmc_json_number(e->residual));
    pdmc_json_put(&object, "elastic_energy", pdmc_json_number(e->energy));
    pdmc_json_put(&object, "faces", faces);
    pdmc_json_put(&object, "line", line);
    pdmc_json_put(&object, "kinetic", pdmc_json_numbers((size_t)e->energy_count, e->kinetic));
    pdmc_json_put(&object, "elastic", pdmc_json_numbers((size_t)e->energy_count, e->elastic));
    return object;
}
