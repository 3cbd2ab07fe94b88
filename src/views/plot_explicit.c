// SPDX-License-Identifier: GPL-3.0-or-later

/// Pictures of an explicit study: energies and tips over time, and the damage in the reference configuration.

#include "base/base_impl.h"
#include "views/explicit.h"
#include "views/plots.h"

#include <math.h>

enum { FLAT = 6 };      // times as wide as high
enum { POINTS = 4000 }; // that a picture can show; of more records every second, third, ... one is drawn

static int stride(const pdmc_explicit_record *p)
{
    return 1 + p->record_count / POINTS;
}

static void put_time_axis(const pdmc_results *r, const pdmc_figure *figure)
{
    const pdmc_explicit_record *p = &r->particles;
    pdmc_figure_label(figure, "xlabel", "Time (", r->time_unit, ")");
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
        fprintf(script, "%.9g %.9g %.9g %.9g %.9g %.9g\n", p->time[i], p->first + p->work[i], p->elastic[i],
                p->kinetic[i], p->fracture[i], p->contact[i]);
    fputs("EOD\n", script);
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    put_time_axis(r, figure);
    pdmc_figure_label(figure, "ylabel", "Energy (", unit, ")");
    fputs("plot $energies using 1:2 with lines linecolor 'black' title 'first + work', "
          "$energies using 1:3 with lines linecolor " PDMC_BLUE " title 'elastic', "
          "$energies using 1:4 with lines linecolor " PDMC_VERMILION " title 'kinetic', "
          "$energies using 1:5 with lines linecolor " PDMC_GREEN " title 'fracture', "
          "$energies using 1:6 with lines linecolor " PDMC_GREY " title 'contact'\n",
          script);
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

/// Damage on a part of the grid: values [rows, columns], NaN where there is no node.
typedef struct {
    double origin[2]; // of the first value
    size_t columns, rows;
    double *values;
} raster;

static void find_bounds(const pdmc_explicit_record *p, double least[PDMC_AXES], double most[PDMC_AXES])
{
    for (int k = 0; k < PDMC_AXES; k++) least[k] = INFINITY, most[k] = -INFINITY;
    for (size_t i = 0; i < 3 * (size_t)p->node_count; i++) {
        least[i % 3] = fmin(least[i % 3], p->node_position[i]);
        most[i % 3] = fmax(most[i % 3], p->node_position[i]);
    }
}

/// The damage of the nodes in the plane of the axes `across` and `up`. Of nodes that lie behind each other the last one
/// is seen, which is the highest in z; with `through` >= 0 only those in the middle along that axis.
static pdmc_status make_raster(const pdmc_explicit_record *p, int across, int up, int through, raster *image)
{
    pdmc_status status = PDMC_OK;
    const double h = p->spacing;
    const size_t first = pdmc_last_state(p);
    double least[PDMC_AXES], most[PDMC_AXES];
    find_bounds(p, least, most);
    *image = (raster){.origin = {least[across], least[up]},
                      .columns = 1 + (size_t)lround((most[across] - least[across]) / h),
                      .rows = 1 + (size_t)lround((most[up] - least[up]) / h)};
    PDMC_NEW(image->values, image->columns * image->rows);
    for (size_t i = 0; i < image->columns * image->rows; i++) image->values[i] = NAN;
    const long middle = through < 0 ? 0 : lround(0.5 * (most[through] - least[through]) / h - 0.25);
    for (size_t i = 0; i < (size_t)p->node_count; i++) {
        const double *x = &p->node_position[3 * i];
        if (through >= 0 && lround((x[through] - least[through]) / h) != middle) continue;
        const size_t column = (size_t)lround((x[across] - least[across]) / h);
        const size_t row = (size_t)lround((x[up] - least[up]) / h);
        image->values[row * image->columns + column] = p->damage[first + i];
    }
done:
    return status;
}

static void put_raster(const raster *image, const char *name, FILE *script)
{
    fprintf(script, "$%s << EOD\n", name);
    for (size_t i = 0; i < image->columns * image->rows; i++) {
        if (isnan(image->values[i])) fputs("NaN", script);
        else fprintf(script, "%.3f", image->values[i]);
        fputc((i + 1) % image->columns ? ' ' : '\n', script);
    }
    fputs("EOD\n", script);
}

static pdmc_status draw_plane(const pdmc_results *r, const char *name, int across, int up, int through,
                              const char *title, const pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    raster image = {0};
    const char before[2][5] = {{"xyz"[across], ' ', '('}, {"xyz"[up], ' ', '('}};
    PDMC_TRY(make_raster(&r->particles, across, up, through, &image));
    put_raster(&image, name, figure->script);
    if (image.columns > FLAT * image.rows) // where tics up would run into each other
        fprintf(figure->script, "set ytics (%.9g, %.9g)\n", image.origin[1],
                image.origin[1] + (double)(image.rows - 1) * r->particles.spacing);
    pdmc_figure_label(figure, "xlabel", before[0], r->length_unit, ")");
    pdmc_figure_label(figure, "ylabel", before[1], r->length_unit, ")");
    fprintf(figure->script,
            "set title '%s'\nplot $%s matrix using (%.9g+$1*%.9g):(%.9g+$2*%.9g):3 with image notitle\n", title, name,
            image.origin[0], r->particles.spacing, image.origin[1], r->particles.spacing);
done:
    pdmc_free(image.values);
    return status;
}

pdmc_status pdmc_draw_explicit_damage(const pdmc_results *r, pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    FILE *script = figure->script;
    fputs(
        "set size ratio -1\nunset grid\nset autoscale fix\nset cbrange [0:1]\nset cblabel 'Damage'\n"
        "set datafile missing 'NaN'\n"
        "set style fill solid noborder\n"
        "set palette defined (0 '#e8e8e8', 0.15 '#56b4e9', 0.35 '#0072b2', 0.5 '#e69f00', 0.75 '#d55e00', 1 'black')\n",
        script);
    if (r->particles.dimension == 2) return draw_plane(r, "plan", 0, 1, -1, "", figure);
    figure->height = 1800;
    fputs("set multiplot layout 2,1\nset tics font ',16'\n", script);
    PDMC_TRY(draw_plane(r, "top", 0, 1, -1, "from above", figure));
    fputs("unset colorbox\n", script);
    PDMC_TRY(draw_plane(r, "section", 0, 2, 1, "section through the middle", figure));
    fputs("unset multiplot\n", script);
done:
    return status;
}
