// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/plots.h"

#include <math.h>

/// Half the range of angles that holds every direction that was ever the likeliest, degrees from straight ahead.
static double half_range(const pdmc_results *r, int tip)
{
    const double centre = r->tips[tip].direction * pdmc_degrees;
    double half = 30.0;
    for (int k = 0; k < r->angle_count; k++)
        if (r->direction[pdmc_place(r, tip, k)].value > 0.0)
            half = fmax(half, fabs(pdmc_degrees_around(r->angles[k], r->tips[tip].direction) - centre) + 15.0);
    return fmin(half, 180.0);
}

void pdmc_draw_direction(const pdmc_results *r, int tip, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const double ahead = r->tips[tip].direction, centre = ahead * pdmc_degrees, half = half_range(r, tip);
    fputs("$share << EOD\n", script);
    for (int k = 0; k < r->angle_count; k++) {
        const pdmc_estimate *p = &r->direction[pdmc_place(r, tip, k)];
        fprintf(script, "%.9g %.9g %.9g %.9g\n", pdmc_degrees_around(r->angles[k], ahead), p->value, p->lower,
                p->upper);
    }
    fputs("EOD\n", script);
    pdmc_figure_label(figure, "title", "Direction of growth at tip ", r->tips[tip].name, "");
    fprintf(script, "set xlabel 'Angle φ from the x axis (degrees)'\n");
    fprintf(script, "set ylabel 'Probability that the %s energy is largest'\n", pdmc_measure_title(r->measure));
    fprintf(script, "set xrange [%.9g:%.9g]\nset yrange [0:*<1.05]\nset grid noxtics\nset xtics %g\n", centre - half,
            centre + half,
            half > 90.0   ? 45.0
            : half > 45.0 ? 15.0
                          : 10.0);
    fputs("set style fill solid 0.45 border\nset errorbars 0.5 linecolor 'black' linewidth 1\n", script);
    pdmc_figure_mark(figure, centre);
    fprintf(script, "plot $share using 1:($2>0?$2:NaN):3:4:(%.9g) with boxerrorbars linecolor " PDMC_BLUE,
            0.8 * 360.0 / r->angle_count);
    fprintf(script, " title 'share of %d samples'", r->sample_count - r->failed_count);
    // gnuplot draws the whiskers with the boxes; this is their line of the legend
    fputs(", $share using 1:(NaN):3:4 with yerrorbars pointtype 7 pointsize 0.15 linewidth 1 linecolor 'black'",
          script);
    fprintf(script, " title '%g %% confidence'", 100.0 * r->confidence);
    fputs(", NaN with lines dashtype 2 linewidth 0.9 linecolor " PDMC_GREY " title 'straight ahead'\n", script);
}
