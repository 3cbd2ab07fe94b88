// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/elastic.h"
#include "views/table.h"

const char *const pdmc_face_names[PDMC_SOLID_FACES] = {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};

static void print_rest(const pdmc_results *r, FILE *stream)
{
    const pdmc_elastic_record *e = &r->elastic;
    char n[3][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE], unit[PDMC_UNIT_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    if (e->energy_count > 0) {
        const int last = e->energy_count - 1;
        fprintf(stream, "  %d steps of %s %.20s; kinetic energy %s, elastic %s %.20s at the end\n", e->iterations,
                pdmc_brief(n[0], e->step), pdmc_one_line(text, r->time_unit), pdmc_brief(n[1], e->kinetic[last]),
                pdmc_brief(n[2], e->elastic[last]), unit);
        return;
    }
    fprintf(stream, "  at rest after %d iterations, residual %s; elastic energy %s %.20s\n", e->iterations,
            pdmc_brief(n[0], e->residual), pdmc_brief(n[1], e->energy), unit);
}

static void print_faces(const pdmc_results *r, FILE *stream)
{
    const pdmc_elastic_record *e = &r->elastic;
    char n[6][PDMC_BRIEF_SIZE], text[2][PDMC_LINE_SIZE];
    fprintf(stream, "\nfaces, %.20s and %.20s %16s %32s\n", pdmc_one_line(text[0], r->length_unit),
            pdmc_one_line(text[1], r->force_unit), "mean displacement", "force on it");
    for (int face = 0; face < PDMC_SOLID_FACES; face++) {
        const double *u = &e->face_displacement[3 * face], *f = &e->face_force[3 * face];
        fprintf(stream, "  %-8s %11s %11s %11s %12s %11s %11s\n", pdmc_face_names[face], pdmc_brief(n[0], u[0]),
                pdmc_brief(n[1], u[1]), pdmc_brief(n[2], u[2]), pdmc_brief(n[3], f[0]), pdmc_brief(n[4], f[1]),
                pdmc_brief(n[5], f[2]));
    }
}

static void print_line(const pdmc_results *r, FILE *stream)
{
    const pdmc_elastic_record *e = &r->elastic;
    char n[3][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    fprintf(stream, "\nalong %c through the middle, %.20s; strain to the node before\n", "xyz"[e->axis],
            pdmc_one_line(text, r->length_unit));
    fprintf(stream, "  %12s %14s %12s\n", "position", "displacement", "strain");
    for (int i = e->line_count / 2; i < e->line_count; i++)
        fprintf(stream, "  %12s %14s %12s\n", pdmc_brief(n[0], e->line_position[i]),
                pdmc_brief(n[1], e->line_displacement[i]), pdmc_brief(n[2], e->line_strain[i]));
}

void pdmc_table_elastic(const pdmc_results *r, FILE *stream)
{
    const pdmc_elastic_record *e = &r->elastic;
    char n[2][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    fprintf(stream, "  %d nodes in space, spacing %s, horizon %s %.20s\n", e->node_count, pdmc_brief(n[0], e->spacing),
            pdmc_brief(n[1], e->horizon), pdmc_one_line(text, r->length_unit));
    print_rest(r, stream);
    print_faces(r, stream);
    print_line(r, stream);
    fprintf(stream, "\nkept     %d nodes, %d energies\n", e->node_count, e->energy_count);
    fprintf(stream, "seconds  body %.2f, rest %.2f, output %.2f\n", r->runtime.assembly, r->runtime.motion,
            r->runtime.output);
}
