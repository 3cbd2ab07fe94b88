# What the pictures share; as pdmc draws.
set encoding utf8
set minussign
set border 3 linewidth 1.2
set tics nomirror out scale 0.8
set style line 100 linecolor '#d8d8d8' linewidth 0.7
set grid back linestyle 100
set key Left reverse samplen 2.4 spacing 1.25
set style line 1 linecolor '#0072b2' linewidth 1.6 pointtype 7            # analytic
set style line 2 linecolor '#d55e00' linewidth 1.6 pointtype 5 dashtype 2 # visible
set style line 3 linecolor '#009e73' linewidth 1.6 pointtype 9 dashtype 4 # bond
set style line 4 linecolor '#808080' linewidth 1.2 pointtype 4            # paper, tip functions on
set style line 5 linecolor '#cc79a7' linewidth 1.2 pointtype 6            # paper, tip functions off
