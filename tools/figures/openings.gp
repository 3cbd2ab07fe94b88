# openings.gp: of opening_*.dat in the working folder; picture and style are files.
load style
set terminal pngcairo enhanced color rounded size 1600,1400 font 'Sans,22' linewidth 2.2 pointscale 2.2
set output picture
set xrange [-0.5:0.5]
nodes(model) = system("cut -d' ' -f1 summary_".model.".dat")." nodes"
set multiplot layout 2, 1
set lmargin 10
set key at graph 0.5, 0.5 center
set ylabel 'Opening (cm)'
set xlabel 'Position along the crack (cm)'
set yrange [0:2.5]
plot 'opening_analytic.dat' with lines linestyle 1 title 'analytic, local limit, '.nodes('analytic'), \
     'opening_visible.dat' with lines linestyle 2 title 'visible, '.nodes('visible'), \
     'opening_bond.dat' with lines linestyle 3 title 'bond, '.nodes('bond')
set yrange [0:20]
set key at graph 0.5, 0.36 center
plot 'opening_analytic.dat' with lines linestyle 1 title 'analytic, local limit, '.nodes('analytic'), \
     'opening_paper_on.dat' with lines linestyle 4 title 'paper, with tip functions, '.nodes('paper_on'), \
     'opening_paper_off.dat' with lines linestyle 5 title 'paper, without tip functions, '.nodes('paper_off')
unset multiplot
