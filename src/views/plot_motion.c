// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/plots.h"

#include <math.h>

enum { POINTS = 4000 }; // that a picture can show; of longer histories every second, third, ... time is drawn

static int stride(const pdmc_motion_record *m)
{
    return 1 + m->time_count / POINTS;
}

static void put_axes(const pdmc_results *r, const pdmc_figure *figure)
{
    const pdmc_motion_record *m = &r->motion;
    pdmc_figure_label(figure, "xlabel", "Time (", r->time_unit, ")");
    fprintf(figure->script, "set xrange [0:%.9g]\nset key outside top center horizontal maxrows 2\n",
            m->time_count > 1 ? m->time[m->time_count - 1] : 1.0);
}

void pdmc_draw_motion_energies(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const pdmc_motion_record *m = &r->motion;
    char unit[PDMC_UNIT_SIZE];
    fputs("$energies << EOD\n", script);
    for (int i = 0; i < m->time_count; i += stride(m))
        fprintf(script, "%.9g %.9g %.9g %.9g %.9g\n", m->time[i], m->work[i], m->elastic[i], m->kinetic[i],
                m->dissipated[i]);
    fputs("EOD\n", script);
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    put_axes(r, figure);
    pdmc_figure_label(figure, "ylabel", "Energy (", unit, ")");
    fputs("plot $energies using 1:2 with lines linecolor 'black' title 'work of the load', "
          "$energies using 1:3 with lines linecolor " PDMC_BLUE " title 'elastic', "
          "$energies using 1:4 with lines linecolor " PDMC_VERMILION " title 'kinetic', "
          "$energies using 1:5 with lines linecolor " PDMC_GREEN " title 'dissipated'\n",
          script);
}

static double largest(const pdmc_motion_record *m, int probe, int component)
{
    double most = 0.0;
    for (int i = 0; i < m->time_count; i++) most = fmax(most, fabs(pdmc_probe_displacement(m, i, probe)[component]));
    return most;
}

// A component that is next to nothing is not drawn: of a plate that is pulled along y, u_x is of no interest.
static double least_shown(const pdmc_motion_record *m)
{
    double most = 0.0;
    for (int p = 0; p < m->probe_count; p++)
        for (int k = 0; k < 2; k++) most = fmax(most, largest(m, p, k));
    return 1e-2 * most;
}

static void put_displacements(const pdmc_motion_record *m, FILE *script)
{
    fputs("$displacements << EOD\n", script);
    for (int i = 0; i < m->time_count; i += stride(m)) {
        fprintf(script, "%.9g", m->time[i]);
        for (int p = 0; p < m->probe_count; p++)
            for (int k = 0; k < 2; k++) fprintf(script, " %.9g", pdmc_probe_displacement(m, i, p)[k]);
        fputc('\n', script);
    }
    fputs("EOD\n", script);
}

void pdmc_draw_motion_displacements(const pdmc_results *r, const pdmc_figure *figure)
{
    static const char *const colours[] = {PDMC_BLUE, PDMC_VERMILION, PDMC_GREEN, "'#cc79a7'", "'#e69f00'", "'#56b4e9'"};
    FILE *script = figure->script;
    const pdmc_motion_record *m = &r->motion;
    const double least = least_shown(m);
    put_displacements(m, script);
    put_axes(r, figure);
    pdmc_figure_label(figure, "ylabel", "Displacement (", r->length_unit, ")");
    fputs("plot 0 with lines linewidth 0.7 linecolor " PDMC_GREY " notitle", script);
    for (int p = 0; p < m->probe_count; p++)
        for (int k = 0; k < 2; k++) {
            if (!(largest(m, p, k) >= least)) continue;
            fprintf(script, ", $displacements using 1:%d with lines dashtype %d linecolor %s title ", 2 + 2 * p + k,
                    k == 0 ? 2 : 1, colours[(size_t)p % (sizeof colours / sizeof colours[0])]);
            pdmc_figure_text(figure, m->probes[p].name);
            fprintf(script, ".', u_%c'", "xy"[k]);
        }
    fputc('\n', script);
}
