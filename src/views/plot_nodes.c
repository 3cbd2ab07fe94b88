// SPDX-License-Identifier: GPL-3.0-or-later

/// Pictures of what the nodes of an explicit study have in its last snapshot, in the reference configuration.

#include "base/base_impl.h"
#include "views/explicit.h"
#include "views/plots.h"

#include <math.h>

enum { FLAT = 6 }; // times as wide as high

/// Values on a part of the grid [rows, columns], NaN where there is no node.
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

/// The values of the nodes in the plane of the axes `across` and `up`. Of nodes that lie behind each other the last one
/// is seen, which is the highest in z; with `through` >= 0 only those in the middle along that axis.
static pdmc_status make_raster(const pdmc_explicit_record *p, const double value[], int across, int up, int through,
                               raster *image)
{
    pdmc_status status = PDMC_OK;
    const double h = p->spacing;
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
        image->values[row * image->columns + column] = value[i];
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

static pdmc_status draw_plane(const pdmc_results *r, const double value[], const char *name, int across, int up,
                              int through, const char *title, const pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    raster image = {0};
    const char before[2][5] = {{"xyz"[across], ' ', '('}, {"xyz"[up], ' ', '('}};
    PDMC_TRY(make_raster(&r->particles, value, across, up, through, &image));
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

/// The plane, or from above and a section through the middle.
static pdmc_status draw_planes(const pdmc_results *r, const double value[], pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    FILE *script = figure->script;
    fputs("set size ratio -1\nunset grid\nset autoscale fix\nset datafile missing 'NaN'\n"
          "set style fill solid noborder\n",
          script);
    if (r->particles.dimension == 2) return draw_plane(r, value, "plan", 0, 1, -1, "", figure);
    figure->height = 1800;
    fputs("set multiplot layout 2,1\nset tics font ',16'\n", script);
    PDMC_TRY(draw_plane(r, value, "top", 0, 1, -1, "from above", figure));
    fputs("unset colorbox\n", script);
    PDMC_TRY(draw_plane(r, value, "section", 0, 2, 1, "section through the middle", figure));
    fputs("unset multiplot\n", script);
done:
    return status;
}

pdmc_status pdmc_draw_explicit_damage(const pdmc_results *r, pdmc_figure *figure)
{
    fputs(
        "set cbrange [0:1]\nset cblabel 'Damage'\n"
        "set palette defined (0 '#e8e8e8', 0.15 '#56b4e9', 0.35 '#0072b2', 0.5 '#e69f00', 0.75 '#d55e00', 1 'black')\n",
        figure->script);
    return draw_planes(r, &r->particles.damage[pdmc_last_state(&r->particles)], figure);
}

/// The colours of the largest piece, of single nodes, and in turn of all others.
enum { LARGEST, SINGLE, OTHERS, PALETTE = 9 };

static double colour_of(const pdmc_explicit_record *p, int piece)
{
    if (piece == 0) return LARGEST;
    return p->fragment_list[piece].nodes == 1 ? SINGLE : OTHERS + piece % (PALETTE - OTHERS);
}

pdmc_status pdmc_draw_explicit_fragments(const pdmc_results *r, pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    const pdmc_explicit_record *p = &r->particles;
    const size_t first = pdmc_last_state(p);
    double *colour = NULL;
    PDMC_NEW(colour, p->node_count);
    for (int i = 0; i < p->node_count; i++) colour[i] = colour_of(p, p->fragment[first + (size_t)i]);
    fprintf(
        figure->script,
        "unset colorbox\nset cbrange [0:%d]\nset palette maxcolors %d\n"
        "set palette defined (0 '#d0d0d0', 1 'black', 2 '#0072b2', 3 '#d55e00', 4 '#009e73', 5 '#cc79a7', 6 '#e69f00', "
        "7 '#56b4e9', 8 '#f0e442')\n",
        PALETTE - 1, PALETTE);
    PDMC_TRY(draw_planes(r, colour, figure));
done:
    pdmc_free(colour);
    return status;
}
