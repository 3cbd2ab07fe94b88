// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/plots.h"

void pdmc_draw_micromodulus(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    fputs("$bins << EOD\n", script);
    for (int b = 0; b < r->bin_count; b++) {
        fprintf(script, "%.9g %.9g\n", (double)b / r->bin_count, r->micromodulus[b]);
        fprintf(script, "%.9g %.9g\n", (b + 1.0) / r->bin_count, r->micromodulus[b]);
    }
    fputs("EOD\nset title 'One realisation of the micromodulus (sample 0)'\n"
          "set xlabel 'Length of the bond r / δ'\nset ylabel 'c(r) / c_0'\nset xrange [0:1]\n"
          "set key top right\nset offsets 0, 0, graph 0.12, graph 0.04\n",
          script);
    fprintf(script,
            "plot $bins with lines linecolor " PDMC_BLUE " linewidth 1 title '%d bins', "
            "1 with lines dashtype 2 linewidth 1 linecolor " PDMC_GREY " title 'mean'\n",
            r->bin_count);
}
