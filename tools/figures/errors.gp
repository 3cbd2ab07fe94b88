# errors.gp: of error_*.dat in the working folder; picture and style are files.
load style
set terminal pngcairo enhanced color rounded size 1600,1100 font 'Sans,22' linewidth 2.2 pointscale 2.2
set output picture
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'Nodes'
set ylabel 'Error of the opening of the middle (%)'
set key outside top center horizontal maxrows 3
set xrange [50:100000]
local = 2.1140
nonlocal = 1.026 * local
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.25 behind \
    fillcolor '#f0f0f0' fillstyle solid noborder
set label 1 'shaded: within the 0.25 % to which the reference for a finite horizon is known' \
    at graph 0.98, graph 0.04 right textcolor '#606060' font ',18'
error(u, reference) = abs(u / reference - 1) * 100
plot 'error_analytic.dat' using 1:(error($3, local)) with linespoints linestyle 1 title 'analytic', \
     'error_visible.dat' using 1:(error($3, nonlocal)) with linespoints linestyle 2 title 'visible', \
     'error_bond.dat' using 1:(error($3, nonlocal)) with linespoints linestyle 3 title 'bond', \
     'error_paper_on.dat' using 1:(error($3, nonlocal)) with linespoints linestyle 4 \
         title 'paper, with tip functions', \
     'error_paper_off.dat' using 1:(error($3, nonlocal)) with linespoints linestyle 5 \
         title 'paper, without tip functions'
