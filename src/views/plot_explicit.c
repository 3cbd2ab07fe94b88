// SPDX-License-Identifier: GPL-3.0-or-later

/// Pictures of an explicit study: energies and tips over time, and how large the pieces are.

#include "base/base_impl.h"
#include "views/explicit.h"
#include "views/plots.h"

#include <math.h>

enum { POINTS = 4000 }; // that a picture can show; of more records every second, third, ... one is drawn

static int stride(const pdmc_explicit_record *p)
{
    return 1 + p->record_count / POINTS;
}

static void put_time_axis(const pdmc_results *r, const pdmc_figure *figure)
{
    const pdmc_explicit_record *p = &r->particles;
    if (pdmc_is_at_rest(p)) pdmc_figure_label(figure, "xlabel", "Load", "", "");
    else pdmc_figure_label(figure, "xlabel", "Time (", r->time_unit, ")");
    fprintf(figure->script, "set xrange [0:%.9g]\nset rmargin 9\nset key outside top center horizontal maxrows 2\n",
            p->record_count > 1 ? p->time[p->record_count - 1] : 1.0);
}

void pdmc_draw_explicit_energies(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const pdmc_explicit_record *p = &r->particles;
    char unit[PDMC_UNIT_SIZE];
    fputs("$energies << EOD\n", script);
    for (int i = 0; i < p->record_count; i += stride(p))
        fprintf(script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", p->time[i], p->first + p->work[i], p->elastic[i],
                p->kinetic[i], p->fracture[i], p->contact[i], p->dissipated[i]);
    fputs("EOD\n", script);
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    put_time_axis(r, figure);
    pdmc_figure_label(figure, "ylabel", "Energy (", unit, ")");
    fputs("plot $energies using 1:2 with lines linecolor 'black' title 'first + work', "
          "$energies using 1:3 with lines linecolor " PDMC_BLUE " title 'elastic', "
          "$energies using 1:4 with lines linecolor " PDMC_VERMILION " title 'kinetic', "
          "$energies using 1:5 with lines linecolor " PDMC_GREEN " title 'fracture', "
          "$energies using 1:6 with lines linecolor " PDMC_GREY " title 'contact'",
          script);
    if (p->record_count > 0 && p->dissipated[p->record_count - 1] != 0.0)
        fputs(", $energies using 1:7 with lines linecolor '#e69f00' title 'dissipated'", script);
    fputc('\n', script);
}

// Whether any of a condition's nodes has moved at the end, on the mean.
static bool moves(const pdmc_explicit_record *p, int condition)
{
    return p->record_count > 0 &&
           pdmc_norm_of(pdmc_of_condition(p, p->condition_displacement, p->record_count - 1, condition)) > 0.0;
}

static void put_forces_of_conditions(const pdmc_explicit_record *p, FILE *script)
{
    for (int c = 0; c < p->condition_count; c++) {
        fprintf(script, "$condition%d << EOD\n", c);
        for (int i = 0; i < p->record_count; i += stride(p))
            fprintf(script, "%.9g %.9g\n", pdmc_norm_of(pdmc_of_condition(p, p->condition_displacement, i, c)),
                    pdmc_norm_of(pdmc_of_condition(p, p->condition_force, i, c)));
        fputs("EOD\n", script);
    }
}

// By the way of the centre.
static void put_forces_of_spheres(const pdmc_explicit_record *p, FILE *script)
{
    for (int s = 0; s < p->sphere_count; s++) {
        const double *first = pdmc_of_sphere(p, p->sphere_centre, 0, s);
        fprintf(script, "$sphere%d << EOD\n", s);
        for (int i = 0; i < p->record_count; i += stride(p)) {
            const double *now = pdmc_of_sphere(p, p->sphere_centre, i, s);
            const double way[PDMC_AXES] = {now[0] - first[0], now[1] - first[1], now[2] - first[2]};
            fprintf(script, "%.9g %.9g\n", pdmc_norm_of(way), pdmc_norm_of(pdmc_of_sphere(p, p->sphere_force, i, s)));
        }
        fputs("EOD\n", script);
    }
}

static void put_curve(const pdmc_figure *figure, int curve, const char *data, int number, const char *name)
{
    fprintf(figure->script, "%s $%s%d with linespoints pointtype 7 pointsize 0.6 dashtype %d title ",
            curve > 0 ? "," : "plot", data, number, number % 2 + 1);
    pdmc_figure_text(figure, name);
}

void pdmc_draw_load_displacement(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const pdmc_explicit_record *p = &r->particles;
    int curves = 0;
    put_forces_of_conditions(p, script);
    put_forces_of_spheres(p, script);
    pdmc_figure_label(figure, "xlabel", "Displacement (", r->length_unit, ")");
    pdmc_figure_label(figure, "ylabel", "Force (", r->force_unit, ")");
    fputs("set xrange [0:*]\nset yrange [0:*]\nset key outside top center horizontal\n", script);
    for (int c = 0; c < p->condition_count; c++)
        if (moves(p, c)) put_curve(figure, curves++, "condition", c, p->conditions[c].name);
    for (int s = 0; s < p->sphere_count; s++) put_curve(figure, curves++, "sphere", s, p->spheres[s].name);
    fputs(curves == 0 ? "plot NaN notitle\n" : "\n", script);
}

void pdmc_draw_explicit_tips(const pdmc_results *r, const pdmc_figure *figure)
{
    static const char *const colours[] = {PDMC_BLUE, PDMC_VERMILION, PDMC_GREEN, "'#cc79a7'", "'#e69f00'", "'#56b4e9'"};
    const size_t colour_count = sizeof colours / sizeof colours[0];
    FILE *script = figure->script;
    const pdmc_explicit_record *p = &r->particles;
    fputs("$tips << EOD\n", script);
    for (int i = 0; i < p->record_count; i += stride(p)) {
        fprintf(script, "%.9g", p->time[i]);
        for (int t = 0; t < p->tip_count; t++) fprintf(script, " %.9g", pdmc_of_tip(p, p->tip_advance, i, t));
        fputc('\n', script);
    }
    fputs("EOD\n", script);
    put_time_axis(r, figure);
    pdmc_figure_label(figure, "ylabel", "Growth (", r->length_unit, ")");
    for (int t = 0; t < p->tip_count; t++) { // of two tips that grow alike, both are seen
        fprintf(script, "%s $tips using 1:%d with lines dashtype %d linecolor %s title ", t == 0 ? "plot" : ",", t + 2,
                t % 2 + 1, colours[(size_t)t % colour_count]);
        pdmc_figure_text(figure, p->tips[t].name);
    }
    fputc('\n', script);
}

/// Of equal pieces one point: how many are at least as heavy.
static void put_masses(const pdmc_explicit_record *p, FILE *script)
{
    fputs("$masses << EOD\n", script);
    for (int i = p->fragment_count - 1; i >= 0; i--)
        if (i + 1 == p->fragment_count || p->fragment_list[i].mass > p->fragment_list[i + 1].mass)
            fprintf(script, "%.9g %d\n", p->fragment_list[i].mass, i + 1);
    fputs("EOD\n", script);
}

void pdmc_draw_explicit_masses(const pdmc_results *r, const pdmc_figure *figure)
{
    const pdmc_explicit_record *p = &r->particles;
    char unit[PDMC_UNIT_SIZE];
    put_masses(p, figure->script);
    pdmc_results_unit(r, PDMC_UNIT_MASS, sizeof unit, unit);
    pdmc_figure_label(figure, "xlabel", "Mass (", unit, ")");
    fprintf(figure->script,
            "set ylabel 'Pieces that are at least as heavy'\nset logscale xy\nset format xy '10^{%%T}'\n"
            "set xrange [%.9g:%.9g]\nset yrange [0.7:%.9g]\n"
            "plot $masses using 1:2 with linespoints pointtype 7 linecolor " PDMC_BLUE " notitle\n",
            0.5 * p->fragment_list[p->fragment_count - 1].mass, 2.0 * p->fragment_list[0].mass,
            1.5 * p->fragment_count);
}
