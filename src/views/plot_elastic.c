// SPDX-License-Identifier: GPL-3.0-or-later

/// Pictures of an elastic study: displacement and strain along the body, and energies over time.

#include "views/elastic.h"
#include "views/plots.h"

static void put_line(const pdmc_results *r, const pdmc_figure *figure, const double values[])
{
    const pdmc_elastic_record *e = &r->elastic;
    fputs("set datafile missing 'nan'\n$line << EOD\n", figure->script);
    for (int i = 0; i < e->line_count; i++) fprintf(figure->script, "%.9g %.9g\n", e->line_position[i], values[i]);
    fputs("EOD\n", figure->script);
    pdmc_figure_label(figure, "xlabel", e->axis == 0 ? "x (" : e->axis == 1 ? "y (" : "z (", r->length_unit, ")");
    fputs("set format y '%g'\n", figure->script);
}

void pdmc_draw_elastic_displacement(const pdmc_results *r, const pdmc_figure *figure)
{
    put_line(r, figure, r->elastic.line_displacement);
    pdmc_figure_label(figure, "ylabel", "Displacement along the body (", r->length_unit, ")");
    fputs("plot $line with linespoints pointtype 7 pointsize 0.6 linecolor " PDMC_BLUE " notitle\n", figure->script);
}

void pdmc_draw_elastic_strain(const pdmc_results *r, const pdmc_figure *figure)
{
    put_line(r, figure, r->elastic.line_strain);
    fputs("set ylabel 'Strain along the body, to the node before'\n"
          "plot $line with linespoints pointtype 7 pointsize 0.6 linecolor " PDMC_BLUE " notitle\n",
          figure->script);
}

void pdmc_draw_elastic_energies(const pdmc_results *r, const pdmc_figure *figure)
{
    const pdmc_elastic_record *e = &r->elastic;
    FILE *script = figure->script;
    char unit[PDMC_UNIT_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    fputs("$energies << EOD\n", script);
    for (int i = 0; i < e->energy_count; i++) fprintf(script, "%d %.9g %.9g\n", i, e->kinetic[i], e->elastic[i]);
    fputs("EOD\nset xlabel 'Step'\n", script);
    pdmc_figure_label(figure, "ylabel", "Energy (", unit, ")");
    fputs("plot $energies using 1:2 with lines linewidth 2 linecolor " PDMC_VERMILION " title 'kinetic', "
          "$energies using 1:3 with lines linewidth 2 linecolor " PDMC_BLUE " title 'elastic'\n",
          script);
}
