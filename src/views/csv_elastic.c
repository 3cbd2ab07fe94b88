// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/csv.h"
#include "views/elastic.h"

pdmc_status pdmc_csv_line(const pdmc_results *results, FILE *stream)
{
    const pdmc_elastic_record *e = &results->elastic;
    fputs("node", stream);
    pdmc_csv_column(stream, "position", results->length_unit);
    pdmc_csv_column(stream, "displacement", results->length_unit);
    fputs(",strain\n", stream);
    for (int i = 0; i < e->line_count; i++) {
        const double numbers[] = {e->line_position[i], e->line_displacement[i], e->line_strain[i]};
        fprintf(stream, "%d", i);
        pdmc_csv_numbers(stream, sizeof numbers / sizeof numbers[0], numbers);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_solid_nodes(const pdmc_results *results, FILE *stream)
{
    const pdmc_elastic_record *e = &results->elastic;
    fputs("node", stream);
    pdmc_csv_axes(stream, "position", "", results->length_unit);
    pdmc_csv_axes(stream, "displacement", "", results->length_unit);
    fputs(",compensation\n", stream);
    for (int i = 0; i < e->node_count; i++) {
        fprintf(stream, "%d", i);
        pdmc_csv_numbers(stream, 3, &e->position[3 * i]);
        pdmc_csv_numbers(stream, 3, &e->displacement[3 * i]);
        pdmc_csv_number(stream, e->compensation[i]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_faces(const pdmc_results *results, FILE *stream)
{
    const pdmc_elastic_record *e = &results->elastic;
    fputs("face", stream);
    pdmc_csv_axes(stream, "displacement", "", results->length_unit);
    pdmc_csv_axes(stream, "force", "", results->force_unit);
    fputc('\n', stream);
    for (int face = 0; face < PDMC_SOLID_FACES; face++) {
        pdmc_csv_text(stream, pdmc_face_names[face]);
        pdmc_csv_numbers(stream, 3, &e->face_displacement[3 * face]);
        pdmc_csv_numbers(stream, 3, &e->face_force[3 * face]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_energies(const pdmc_results *results, FILE *stream)
{
    const pdmc_elastic_record *e = &results->elastic;
    char unit[PDMC_UNIT_SIZE];
    pdmc_results_unit(results, PDMC_UNIT_WORK, sizeof unit, unit);
    fputs("step", stream);
    pdmc_csv_column(stream, "time", results->time_unit);
    pdmc_csv_column(stream, "kinetic", unit);
    pdmc_csv_column(stream, "elastic", unit);
    fputc('\n', stream);
    for (int i = 0; i < e->energy_count; i++) {
        const double numbers[] = {e->time[i], e->kinetic[i], e->elastic[i]};
        fprintf(stream, "%d", i);
        pdmc_csv_numbers(stream, sizeof numbers / sizeof numbers[0], numbers);
        fputc('\n', stream);
    }
    return PDMC_OK;
}
