#!/usr/bin/env bash
# connect: a flat ribbon, one that folds, splines, curves that do not fit.
. "$(dirname "$0")/functions.sh"

cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >c.g2
cubic $'0 1 0\n1 1 0\n2 1 0\n3 1 0' >c1.g2
cubic $'0 -1 0\n1 -1 0\n2 -1 0\n3 -1 0' >c2.g2
cubic $'0 3 0\n1 3 0\n2 3 0\n3 3 0' >c3.g2
run 0 connect c.g2 c1.g2 c2.g2 -o flat.g2 && says flat.g2 "200 1 0 0" "7 7"
run 0 verify flat.g2 --surfaces --require G1 && says out "1 G2"
run 1 connect c.g2 c1.g2 c3.g2 -o fold.g2
run 2 connect c.g2 c1.g2 c1.g2 -o no.g2 && says err "singular_frame"
run 2 connect c.g2 c1.g2 -o no.g2
spline $'6 4\n0 0 0 0 2 2 4 4 4 4\n0 0 0\n2 0 0\n4 0 3\n6 0 3\n8 0 0\n10 0 0' >c.g2
spline $'6 4\n0 0 0 0 2 2 4 4 4 4\n1 3 0\n3 4 1\n4 5 4\n6 5 4\n9 4 -1\n11 3 0' >c1.g2
spline $'6 4\n0 0 0 0 2 2 4 4 4 4\n1 -3 0\n3 -2 1\n4 -4 4\n6 -4 4\n9 -2 -1\n11 -3 0' >c2.g2
run 0 connect c.g2 c1.g2 c2.g2 -o ribbon.g2 && says ribbon.g2 "13 7" "0 0 0 0 0 0 0 2 2 2 2 2 2 4 4 4 4 4 4 4"
says out "alpha: 1 5/3 5/3 1" "first derivatives attained, twists attained" "no fold" "on [2, 4]: G1" "proved exactly"
run 0 connect c.g2 c1.g2 c2.g2 --bulge 1/2 -o ribbon.g2 && says out "beta: 1/3 1/3 5/6 1/3 1/3"
spline "$two_knots" >spline.g2
run 2 connect c.g2 c1.g2 spline.g2 -o no.g2 && says err "parameter_outside_domain"
