// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/plots.h"

#include <math.h>

/// A factor of 1, 2 or 5 times a power of ten that makes the largest displacement at most 8 % of the plate.
static double displacement_scale(const pdmc_results *r)
{
    double largest = 0.0;
    for (size_t i = 0; i < 2 * (size_t)r->field.node_count; i++)
        if (isfinite(r->field.node_displacement[i])) largest = fmax(largest, fabs(r->field.node_displacement[i]));
    for (size_t i = 0; i < 4 * (size_t)r->crack_count * (size_t)r->field.face_points; i++)
        if (isfinite(r->field.face_displacement[i])) largest = fmax(largest, fabs(r->field.face_displacement[i]));
    const double ideal = 0.08 * fmax(r->plate_width, r->plate_height) / largest;
    if (!isfinite(ideal) || !(ideal > 0.0)) return 1.0;
    const double power = pow(10.0, floor(log10(ideal))), leading = ideal / power;
    return power * (leading < 2.0 ? 1.0 : leading < 5.0 ? 2.0 : 5.0);
}

static void put_nodes(const pdmc_displacement_field *field, double scale, FILE *script)
{
    fputs("$nodes << EOD\n", script);
    for (size_t i = 0; i < (size_t)field->node_count; i++) {
        const double *x = &field->node_position[2 * i], *u = &field->node_displacement[2 * i];
        fprintf(script, "%.9g %.9g %.9g %.9g\n", x[0], x[1], x[0] + scale * u[0], x[1] + scale * u[1]);
    }
    fputs("EOD\n", script);
}

static void put_cracks(const pdmc_results *r, FILE *script)
{
    fputs("$cracks << EOD\n", script);
    for (size_t c = 0; c < (size_t)r->crack_count; c++) {
        const double *crack = &r->cracks[4 * c];
        fprintf(script, "%.9g %.9g\n%.9g %.9g\n\n", crack[0], crack[1], crack[2], crack[3]);
    }
    fputs("EOD\n", script);
}

/// The outline of each opened crack: along the left face and back along the right one.
static void put_faces(const pdmc_results *r, double scale, FILE *script)
{
    const size_t n = (size_t)r->field.face_points;
    fputs("$faces << EOD\n", script);
    for (size_t c = 0; c < (size_t)r->crack_count; c++) {
        for (size_t i = 0; i < 2 * n; i++) {
            const size_t side = i / n, at = c * n + (side ? 2 * n - 1 - i : i);
            const double *x = &r->field.face_position[2 * at];
            const double *u = &r->field.face_displacement[4 * at + 2 * side];
            fprintf(script, "%.9g %.9g\n", x[0] + scale * u[0], x[1] + scale * u[1]);
        }
        fputs("\n", script);
    }
    fputs("EOD\n", script);
}

static void put_outline(const pdmc_results *r, FILE *script)
{
    const double x = 0.5 * r->plate_width, y = 0.5 * r->plate_height;
    fprintf(script, "$plate << EOD\n%.9g %.9g\n%.9g %.9g\n%.9g %.9g\n%.9g %.9g\n%.9g %.9g\nEOD\n", -x, -y, x, -y, x, y,
            -x, y, -x, -y);
}

void pdmc_draw_plate(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const double scale = displacement_scale(r);
    put_outline(r, script);
    put_nodes(&r->field, scale, script);
    put_cracks(r, script);
    put_faces(r, scale, script);
    pdmc_figure_label(figure, "title", "", r->title, "");
    pdmc_figure_label(figure, "xlabel", "x (", r->length_unit, ")");
    pdmc_figure_label(figure, "ylabel", "y (", r->length_unit, ")");
    fprintf(script, "set size ratio -1\nset autoscale fix\nset key outside right top\nset offsets graph 0.03, graph "
                    "0.03, graph 0.03, graph 0.03\n"
                    "plot $plate with lines linecolor 'black' linewidth 1 title 'plate'");
    if (r->field.node_count > 0)
        fprintf(script,
                ", $nodes using 1:2 with points pointtype 7 pointsize 0.26 linecolor '#b8b8b8' title 'nodes', "
                "$nodes using 3:4 with points pointtype 7 pointsize 0.36 linecolor " PDMC_BLUE
                " title 'displaced × %g'",
                scale);
    if (r->crack_count > 0) {
        fprintf(script, ", $cracks with lines linecolor 'black' linewidth 2.5 title 'crack'");
        if (r->field.face_points > 0)
            fprintf(script,
                    ", $faces with filledcurves closed fillcolor " PDMC_VERMILION
                    " fillstyle transparent solid 0.4 border linecolor " PDMC_VERMILION " title 'opened × %g'",
                    scale);
    }
    fputc('\n', script);
}
