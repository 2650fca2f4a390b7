#!/usr/bin/env bash
# blend --surfaces: patches, splines with inner knots, rational surfaces, every edge, and what is
# refused. That the written surface is G2 is decided by verify.
. "$(dirname "$0")/functions.sh"

# proved A B ARGUMENTS...: the blend is G2 with both, as verify reads all three
proved() {
  run 0 blend --surfaces "$@" -o blend.g2 && says out "G2 along both edges, proved exactly"
  run 0 verify --surfaces "$1" blend.g2 "$2" --require G2 && says out "2 G2"
}

# bilinear in u, quadratic in v; the second one is 5 away
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n0 0 0\n4 0 1\n0 1 1\n4 1/3 0\n0 3 0\n4 3 1\n' >a.g2
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n0 8 0\n5 8 1\n0 9.5 1\n4 9 0\n0 11 0\n4 12 1\n' >b.g2
proved a.g2 b.g2
says blend.g2 "6 6"
run 0 blend --surfaces a.g2 b.g2 && says out "a.g2, edge v1: G2, beta = " "b.g2, edge v0: G2, beta = "
for strategy in fairest c2 normal min_second near_line energy2 energy3 fair; do proved a.g2 b.g2 --strategy $strategy; done
proved a.g2 b.g2 --edges v1,u0
proved a.g2 b.g2 --edges u1,v0
proved a.g2 b.g2 --edges u0,u1

# a spline over a knot at 1/3, on another domain
printf '200 1 0 0\n3 0\n5 4\n2 2 2 2 3 5 5 5 5\n2 2\n0 0 1 1\n0 9 0\n1 8 0\n2 8 1\n3 9 2\n5 9 0\n0 12 0\n1 12 0\n2 12 1\n3 12 2\n5 12 0\n' >spline.g2
proved a.g2 spline.g2
says blend.g2 "1/3"
proved spline.g2 a.g2 --edges v0,v1

# a quarter of a cylinder: rational
printf '200 1 0 0\n3 1\n3 3\n0 0 0 1 1 1\n2 2\n0 0 1 1\n0 0 9 1\n9 0 9 1\n18 0 0 2\n0 -5 9 1\n9 -5 9 1\n18 -10 0 2\n' >cylinder.g2
proved cylinder.g2 a.g2 --edges v0,v0
says blend.g2 "200 1 0 0" "3 1"
proved a.g2 cylinder.g2

# all weights are positive, and steep: the default and others
printf '200 1 0 0\n3 1\n2 2\n-1/2 -1/2 1/2 1/2\n4 4\n-2 -2 -2 -2 6 6 6 6\n0 -32 4 8\n125/4 -20 5/4 5\n0 -55/4 -5/4 5\n48 -20 -2 8\n0 -5/4 1/4 1\n23/4 -5/4 1/4 1\n0 1/4 1/4 1\n25 0 0 4\n' >steep.g2
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 6 0\n6 6 0\n0 10 0\n6 10 0\n' >opposite.g2
for strategy in fairest energy3 fair; do proved steep.g2 opposite.g2 --strategy $strategy; done
# a denominator that given numbers make negative, next to an edge with a negative weight: the pair
# and the place
printf '200 1 0 0\n3 1\n3 3\n0 0 0 1 1 1\n2 2\n0 0 1 1\n0 0 0 1\n2 0 0 1\n6 0 0 1\n0 3 0 1\n-3/8 -3/8 0 -1/8\n6 3 0 1\n' >negative.g2
refused "negative.g2 and opposite.g2: blend: its denominator is not positive near (u, v) = (" blend --surfaces negative.g2 opposite.g2 --strategy free --delta 99,0

# the report as JSON; numbers that are given, and a direction
run 0 blend --surfaces a.g2 b.g2 --json && says out '{"strategy":"fairest","order":2,"direction":"same","edges":[' \
  '{"file":"a.g2","edge":"v1","order":"G2","proved":true,"beta":"' '],"proved":true,"fold":null,"fairness":'
run 0 blend --surfaces a.g2 b.g2 --direction opposite --json && says out '"direction":"opposite"'
proved a.g2 b.g2 --strategy free --beta 1/3 --eta 0.7 --delta 2/7,-1
run 0 blend --surfaces a.g2 b.g2 --strategy free --beta 1/3 --eta 0.7 --delta 2/7,-1
says out "a.g2, edge v1: G2, beta = 1/3, delta = 2/7" "b.g2, edge v0: G2, beta = 7/10, delta = -1"
run 0 blend --surfaces a.g2 b.g2 --strategy energy3 --beta 5 --order 2 && says out "edge v1: G2, beta = 5,"
refused "fairest chooses them" blend --surfaces a.g2 b.g2 --beta 5
refused "--delta: only with --strategy free" blend --surfaces a.g2 b.g2 --strategy fair --delta 1,2
refused "--delta: two numbers are needed" blend --surfaces a.g2 b.g2 --strategy free --delta 1
refused "--eta: it must be positive" blend --surfaces a.g2 b.g2 --strategy c2 --eta 0
refused "--direction: 'up' is none of same, opposite" blend --surfaces a.g2 b.g2 --direction up

# order 3: decided here; verify decides up to G2
smooth() { # smooth A B ARGUMENTS...
  run 0 blend --surfaces "$@" --order 3 -o blend.g2 && says out "G3 along both edges, proved exactly" "delta3 = "
  run 0 verify --surfaces "$1" blend.g2 "$2" --require G2 && says out "2 G2"
}
smooth a.g2 b.g2
says blend.g2 "8 8"
run 0 blend --surfaces a.g2 b.g2 --order 3 && says out "a.g2, edge v1: G3, beta = " "b.g2, edge v0: G3, beta = "
for strategy in c3 seq_g3 joint_g3 energy3_g3 energy4_g3 fair_g3; do smooth a.g2 b.g2 --strategy $strategy; done
smooth a.g2 spline.g2 --edges u1,v0
smooth cylinder.g2 a.g2 --edges v0,v0
smooth steep.g2 opposite.g2
run 0 blend --surfaces a.g2 b.g2 --order 3 --strategy free --delta 1,2 --json && says out '"beta":"1","delta":"1","delta3":"0"'
refused "--strategy" blend --surfaces a.g2 b.g2 --order 3 --strategy seq_f3
refused "--strategy" blend --surfaces a.g2 b.g2 --order 3 --strategy fair
refused "--strategy" blend --surfaces a.g2 b.g2 --strategy fair_g3

# a fold is named: both edges are left in the direction away from the other one
lacks out warning
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n4 0 0\n0 4 0\n4 4 0\n' >flat.g2
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 6 0\n4 6 0\n0 9 0\n4 9 0\n' >next.g2
run 0 blend --surfaces flat.g2 next.g2 && lacks out warning
run 0 blend --surfaces flat.g2 next.g2 --edges v0,v1 && says out "G2 along both edges" "warning: it may be folded near ("
# where that is not decided, the blend is written nevertheless
run 0 blend --surfaces a.g2 cylinder.g2 --max-work 3000000 -o blend.g2 && says out "G2 along both edges" "warning: it may be folded, which was not decided within --max-work"
# a normal that vanishes at a point of the edge
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n4 1 0\n0 1 0\n4 1 0\n' >point.g2
run 1 blend --surfaces point.g2 next.g2 && says out "vanishing_normal" "not G2 along both edges"

# decided by arithmetic of its own, for random pairs
if command -v python3 >/dev/null; then
  holds python3 "$here/check_surface_blends.py" "$program" 4 >checked
  says checked "4 pairs, 0 wrong"
  holds python3 "$here/check_surface_blends.py" "$program" 1 2 3 >checked
  says checked "1 pairs, 0 wrong"
fi

# control points that are doubles; what was moved is written, too
run 0 blend --surfaces flat.g2 next.g2 --representable -o blend.g2 && says out "G2 along both edges, proved exactly" "nothing was moved"
run 0 verify --surfaces blend.g2 --require G2 && says out "2 G2"
sed 's/4 0 0/4.1 0.7 1e-16/' flat.g2 >moved.g2
run 0 blend --surfaces moved.g2 next.g2 --edges v0,v1 --representable --strategy fair -o blend.g2 && says out "coordinates were moved by at most "
run 0 verify --surfaces blend.g2 --require G2 && says out "2 G2"
refused "not_representable" blend --surfaces a.g2 spline.g2 --representable
refused "cylinder.g2" blend --surfaces cylinder.g2 a.g2 --representable
refused "--representable: blends of order 2 only" blend --surfaces a.g2 b.g2 --representable --order 3

# what is refused
refused "two files are needed" blend --surfaces a.g2
refused "two files are needed" blend --surfaces a.g2 b.g2 spline.g2
refused "'v2' is none of u0, u1, v0, v1" blend --surfaces a.g2 b.g2 --edges v1,v2
refused "two names are needed" blend --surfaces a.g2 b.g2 --edges v1
refused "--edges: only with --surfaces" blend "$L" "$R" --edges v1,v0
for option in "--s1 1" "--replace 1" "--kernel double" "--plot no.svg"; do
  refused "${option%% *}: not with --surfaces" blend --surfaces a.g2 b.g2 $option
done
cat a.g2 b.g2 >both.g2
refused "both.g2: 2 surfaces where one is expected" blend --surfaces both.g2 b.g2
refused "$(basename "$L")" blend --surfaces "$L" b.g2
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n4 0 1\n0 1 1\n0 1 1\n' >pole.g2
refused "zero_tangent" blend --surfaces pole.g2 b.g2 -o no.g2
holds [ ! -e no.g2 ]
