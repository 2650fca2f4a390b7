#!/usr/bin/env bash
# Large inputs: what the program needs is bounded, in memory and in time, or it refuses the work at
# once.
. "$(dirname "$0")/functions.sh"
starts=$(memory_to_start)
# bounded KILOBYTES SECONDS: the runs that follow have no more memory and time
bounded() { limit=(bash -c "ulimit -v $1 || exit 99; exec timeout $2 \"\$@\"" -); }

# a chain of many curves is drawn, each join with its label
awk -v n=2000 'BEGIN { for (i = 0; i < n; ++i)
  printf "100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1\n%d 0\n%d.3 %d\n%d.7 %d\n%d 0\n", i, i, i % 9, i, i % 7, i + 1 }' >chain.g2
bounded 300000 30
run 0 plot chain.g2 -o chain.svg --title many
labels=$(grep -c '<text.*>G[0-3]</text>' chain.svg)
says chain.svg ">$((1999 - labels)) labels have no room<" && holds [ "$(grep -c '<circle.*stroke="#222222"' chain.svg)" -eq $((1999 + 2)) ]

# a spline is handed on span by span, in less memory than its numbers need: polylines, and any order
spline() { # POINTS ORDER
  awk -v n="$1" -v k="$2" 'BEGIN { printf "100 1 0 0\n2 0\n%d %d\n", n, k
    for (i = 0; i < n + k; ++i) printf("%d%s", i < k ? 0 : (i > n ? n : i) - k + 1, i % 20 == 19 ? "\n" : " ")
    for (i = 0; i < n; ++i) printf "\n%d.%03d %d.%03d", i, i * 7919 % 1000, i * 31 % 977, i % 1000
    print "" }'
}
spline 20000 2 >polyline.g2
spline 10000 5 >spline.g2
bounded $((starts + 12000)) 60
for kernel in exact double; do
  run 0 verify polyline.g2 --kernel $kernel && says out "19998 joins"
  run 0 verify spline.g2 --kernel $kernel --require C3 && says out "9995 joins: 9995 G3 or more"
done
# what is wrong is found where it is, also behind pieces that were good, and nothing is said about
# these
sed '$s/.*/1 x/' spline.g2 >bad.g2
run 2 verify bad.g2 && says err "bad.g2:10504: not a number: 'x'" && holds [ ! -s out ]
head -n -5 spline.g2 >bad.g2
run 2 verify bad.g2 && says err "bad.g2:10499: file ends after 9995 of 10000 control points" && holds [ ! -s out ]

# triangles are counted before they are made
bounded 100000 5
run 2 tessellate "$teapot" --grid 4096 -o no.off && says err "surface 0 leads to 33554432 triangles" "--max-triangles"
run 2 tessellate "$teapot" --tolerance 1e-300 -o no.off && says err "surface 0 leads to 1e+300 triangles" "--max-triangles"
run 2 tessellate "$teapot" --tolerance 1e-320 -o no.off && run 2 tessellate "$teapot" --tolerance 1e-9 -o no.off
run 2 tessellate "$teapot" --tolerance 1e-9 --kernel exact -o no.off
for bad in 0 -0 -1 nan inf 1e-400; do run 2 tessellate "$teapot" --tolerance $bad -o no.off && says err tolerance; done
for bad in 0 -1 4097 2147483648; do run 2 tessellate "$teapot" --grid $bad -o no.off && says err grid; done
for bad in 0 -1 x; do run 2 tessellate "$teapot" --max-triangles $bad -o no.off && says err max-triangles; done
run 0 tessellate "$teapot" --grid 2 --max-triangles 256 -o grid.off && says out "240 triangles"
run 2 tessellate "$teapot" --grid 2 --max-triangles 255 -o no.off && says err "surface 31 leads to 256 triangles"

# the Bezier patches of a surface
awk -v n=250 'BEGIN { knots = n " 4\n0 0 0"; for (i = 0; i < n - 2; ++i) knots = knots " " i
  knots = knots " " n - 3 " " n - 3 " " n - 3
  printf "200 1 0 0\n3 0\n%s\n%s\n", knots, knots
  for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) printf "%d %d %d\n", i, j, i * j % 11 }' >surface.g2
bounded 110000 30
run 0 tessellate surface.g2 --grid 1 -o surface.off && says out "61504 points, 122018 triangles" "988 on the boundary"
run 2 tessellate surface.g2 --grid 6 -o no.off && says err "surface 0 leads to 4392648 triangles"
holds [ ! -e no.off ]

# coordinates of all sizes: drawn in finite numbers, or refused with file and number of the curve
curves() { printf '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n0 0\n%s %s\n1 0\n' 1 1 "$1" "$1"; }
for size in 1e308 -1e308 1e-308 1e-4000; do
  curves $size >size.g2
  run 0 plot size.g2 -o size.svg && says size.svg "gap" "curvature comb"
  holds [ "$(grep -ciE 'nan|inf[^o]' size.svg)" -eq 0 ]
done
curves 1e4000 >large.g2
run 2 plot large.g2 -o no.svg && says err "large.g2" "curve 1: control point 1 is too far away"
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 %s\n' 0 1e4000 >large.g2
run 2 plot --surfaces large.g2 -o no.svg && says err "surface 1 cannot be drawn"
holds [ ! -e no.svg ]
