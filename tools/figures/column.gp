# column.gp: of column_<faces>_<layers>_<compensation>.dat in the working folder; picture and style are files.
load style
set terminal pngcairo enhanced color rounded size 1800,1500 font 'Sans,20' linewidth 2 pointscale 1.4
set output picture
set multiplot layout 3, 2
set xrange [0:40]
set yrange [0.4:1.8]
set key top left
do for [layers = 1:3] {
    do for [faces in 'ends all'] {
        set title (faces eq 'ends' ? 'ends held' : 'all faces held').', '.layers.(layers == 1 ? ' layer' : ' layers')
        if (layers == 3) { set xlabel 'y (h)' } else { unset xlabel }
        set ylabel 'Strain over 10^{-4}'
        plot 'column_'.faces.'_'.layers.'_none.dat' using 1:3 with linespoints linestyle 2 title 'as they are', \
             'column_'.faces.'_'.layers.'_sum.dat' using 1:3 with linespoints linestyle 1 title 'compensated'
    }
}
unset multiplot
