# Draws the drift of every form of paper 003 by pixel: marks are the searched worst cases, lines their bounds.
#   build/release/bin/quad_table --growth build/growth.dat
#   gnuplot -e "data='build/growth.dat'; picture='docs/images/growth.svg'" scripts/growth.gp
set terminal svg size 900,560 font 'sans,13' background '#ffffff'
set output picture
set logscale xy
set xrange [1.8:6000]
set xtics (2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
set format y '%g'
set mytics 1
set grid lc '#dddddd' lw 0.5
set xlabel 'pixel of the row, t'
set ylabel 'drift, codes (26 fraction bits)'
set key top left reverse Left
set label '1/2 code' at 2500,0.65 textcolor '#888888' font ',11'
plot 0.5 with lines lc '#888888' lw 1.5 notitle, \
  data using 1:3 with lines lc '#0b3d66' lw 1 notitle, \
  '' using 1:2 with points lc '#0b3d66' pt 6 ps 1.1 title '(2), (9)', \
  '' using 1:4 with points lc '#e69f00' pt 1 ps 0.7 title '(3)', \
  '' using 1:6 with points lc '#009e73' pt 4 ps 0.8 title '(5)', \
  '' using 1:9 with lines lc '#56b4e9' lw 1 notitle, \
  '' using 1:8 with points lc '#56b4e9' pt 2 ps 0.7 title '(7)', \
  '' using 1:11 with lines lc '#d55e00' lw 1 notitle, \
  '' using 1:10 with points lc '#d55e00' pt 7 ps 0.6 title '(8)', \
  '' using 1:12 with points lc '#cc79a7' pt 8 ps 0.8 title 'two registers, A', \
  '' using 1:15 with lines lc '#777777' lw 1 notitle, \
  '' using 1:14 with points lc '#777777' pt 7 ps 0.4 title 'two registers, 2A'
