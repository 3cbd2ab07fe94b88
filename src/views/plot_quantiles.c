// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/plots.h"

#include <math.h>

static const char *const colours[PDMC_QUANTILES] = {PDMC_GREEN, PDMC_BLUE, PDMC_VERMILION};

/// A bound that no order statistic reaches is not drawn: the band ends at the quantile.
static double bound(double bound, double value)
{
    return isfinite(bound) ? bound : value;
}

/// One turn of a quantile, and the band of its interval as one outline: out along the upper bound, back along the
/// lower.
static void put_turn(const pdmc_results *r, const pdmc_estimate quantiles[], size_t q, FILE *script)
{
    const int n = r->angle_count;
    fprintf(script, "$turn%zu << EOD\n", q);
    for (int k = 0; k <= n; k++)
        fprintf(script, "%.9g %.9g\n", r->angles[k % n], quantiles[(size_t)(k % n) * PDMC_QUANTILES + q].value);
    fprintf(script, "EOD\n$band%zu << EOD\n", q);
    for (int side = 0; side < 2; side++)
        for (int k = 0; k <= n; k++) {
            const int place = side ? n - k : k;
            const pdmc_estimate *e = &quantiles[(size_t)(place % n) * PDMC_QUANTILES + q];
            fprintf(script, "%.9g %.9g\n", r->angles[place % n], bound(side ? e->lower : e->upper, e->value));
        }
    fputs("EOD\n", script);
}

/// The largest radius, and a step of rings that a person would choose for it.
static double put_rings(const pdmc_results *r, const pdmc_tip *tip, const pdmc_estimate quantiles[], FILE *script)
{
    double largest = 0.0;
    for (size_t i = 0; i < (size_t)r->angle_count * PDMC_QUANTILES; i++)
        largest = fmax(largest, bound(quantiles[i].upper, fmax(0.0, quantiles[i].value)));
    if (!(largest > 0.0)) largest = 1.0;
    const double power = pow(10.0, floor(log10(largest))), leading = largest / power;
    const double step = power * (leading < 1.6 ? 0.4 : leading < 3.2 ? 0.5 : leading < 6.5 ? 1.0 : 2.0);
    const double radius = step * ceil(1.02 * largest / step);
    fprintf(script, "set rrange [0:%.9g]\nset rtics %.9g, %.9g format '' scale 0\nunset raxis\n", radius, step, step);
    // The rings are named beside the crack, where the energy is small.
    const double angle = tip->direction + 195.0 / pdmc_degrees;
    for (int i = 1; i * step < 1.001 * radius; i++)
        fprintf(script, "set label '%.4g' at first %.9g, %.9g center font ',16' textcolor '#505050' front\n", i * step,
                i * step * cos(angle), i * step * sin(angle));
    return radius;
}

/// The crack ends at the centre: a thick line behind the tip.
static void put_crack(const pdmc_tip *tip, double radius, FILE *script)
{
    const double length = 0.3 * radius;
    fprintf(script, "set arrow from first %.9g, %.9g to first 0, 0 nohead linewidth 3 linecolor 'black' front\n",
            -length * cos(tip->direction), -length * sin(tip->direction));
}

void pdmc_draw_quantiles(const pdmc_results *r, int tip, pdmc_measure measure, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    char unit[PDMC_UNIT_SIZE];
    const pdmc_estimate *quantiles = &r->statistics[measure].quantiles[pdmc_place(r, tip, 0) * PDMC_QUANTILES];
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    for (size_t q = 0; q < PDMC_QUANTILES; q++) put_turn(r, quantiles, q, script);
    fputs("set polar\nset size square\nunset border\nunset xtics\nunset ytics\n"
          "set grid polar 0.5235987755982988 linestyle 100\nset ttics 0, 30 format '%g°' font ',18'\n"
          "set key outside right top\n",
          script);
    put_crack(&r->tips[tip], put_rings(r, &r->tips[tip], quantiles, script), script);
    pdmc_figure_label(figure, "title",
                      measure == PDMC_MEASURE_BOND ? "Quantiles of the bond energy round tip "
                                                   : "Quantiles of the Griffith energy round tip ",
                      r->tips[tip].name, "");
    pdmc_figure_label(figure, "key title", measure == PDMC_MEASURE_BOND ? "G_E\u200b (" : "G (", unit, ")");
    fputs("set key title left\nplot ", script);
    for (size_t i = 0; i < PDMC_QUANTILES; i++) {
        const size_t q = PDMC_QUANTILES - 1 - i; // the outermost is named first
        fprintf(script,
                "$band%zu with filledcurves closed linecolor %s notitle, "
                "$turn%zu with lines linecolor %s linewidth 1.2 title '%g %%', ",
                q, colours[q], q, colours[q], 100.0 * pdmc_quantile_levels[q]);
    }
    fprintf(script,
            "NaN with filledcurves linecolor " PDMC_GREY " title '%g %% confidence', "
            "NaN with lines linecolor 'black' linewidth 3 title 'crack'\n",
            100.0 * r->confidence);
}
