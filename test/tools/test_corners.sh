#!/usr/bin/env bash
# blend --corner and --corners: corners of chains and outlines are rounded; what is written is
# proved again.
. "$(dirname "$0")/functions.sh"

line() { printf '100 1 0 0\n2 0\n2 2\n0 0 1 1\n%s\n%s\n' "$1" "$2"; }
{ line "0 0" "8 0"; line "8 0" "8 8"; line "8 8" "0 8"; line "0 8" "0 0"; } >square.g2

# a square, closed and open
run 0 blend square.g2 --corners all --closed --distance 2 -o round.g2
says out "0 -> 1            1          2  C0 G2 F2     C0 G2 F2" "3 -> 0            7          2  C0 G2 F2     C0 G2 F2" \
  "4 corners are rounded, both joins of every blend are proved in exact arithmetic" \
  "the chain: 8 joins, C0 G2 F2 or more"
run 0 verify --closed round.g2 --require G2 && says out "8 joins"
run 0 blend square.g2 --corners all --distance 2 -o open.g2 && says out "the chain: 6 joins, C0 G2 F2 or more"
run 0 verify open.g2 --require G2
run 1 verify --closed open.g2 --require G2
run 0 blend square.g2 --corners not-g1 --closed --distance 2 -o not-g1.g2
holds cmp -s round.g2 not-g1.g2
run 2 blend square.g2 --corners kinks --closed --distance 2 && says err "'kinks' is none of all, not-g1"
holds [ "$(grep -c '^6 6$' round.g2)" -eq 4 ]
# lines of length 8 are cut at 2 exactly: each cut ends a line and a blend ("2 0" is the dimension
# too)
for point in "2 0" "6 0" "8 2" "8 6" "6 8" "2 8" "0 6" "0 2"; do
  holds [ "$(grep -cx "$point" round.g2)" -eq $([ "$point" = "2 0" ] && echo 10 || echo 2) ]
done

# one corner at a time, the last one leads back to the first curve
cp square.g2 step.g2
for corner in 0 2 4 6; do # each blend makes the chain longer by one curve
  run 0 blend step.g2 --corner $corner --distance 2 -o next.g2 && says out "1 corner is rounded, both joins"
  mv next.g2 step.g2
done
run 0 verify --closed step.g2 --require G2 && says out "8 joins"

# G3 joins
run 0 blend square.g2 --corners all --closed --order 3 --distance 2 -o g3.g2 --strategy fair_g3
says out "0 -> 1            1          2  C0 G3 F2     C0 G3 F2" "4 corners are rounded, both joins of every blend are proved"
run 0 verify --closed g3.g2 --require G3
holds [ "$(grep -c '^8 8$' g3.g2)" -eq 4 ]
run 0 blend round.g2 --corners all --closed --order 3 --distance 1/2 -o again.g2 && says out "8 corners are rounded"
run 0 verify --closed again.g2 --require G3
run 0 blend square.g2 --corner 1 --order 3 --distance 2 -o - && says err "1 corner is rounded, both joins"

# a spline with a kink at the triple knot 2 and a smooth knot on both sides: the chain of its Bezier
# curves
printf '100 1 0 0\n2 0\n9 4\n0 0 0 0 1 2 2 2 3 4 4 4 4\n0 0\n1 0\n2 2\n4 2\n5 0\n6 4\n7 5\n8 4\n9 0\n' >spline.g2
run 0 blend spline.g2 --corners all --distance 1/4 -o round_spline.g2 && says out "1 -> 2" "1 corner is rounded"
run 0 verify round_spline.g2 --require G2 && says out "4 joins"
run 0 blend spline.g2 --corner 1 --distance 1/4 -o one.g2 && holds cmp -s one.g2 round_spline.g2
run 1 verify spline.g2 --require G1

# cubics: one in each corner of the square, with both handles there, and two where a side is bent
run 0 blend square.g2 --corners all --closed --distance 2 --cubic -o cubic.g2
says out "0 -> 1            1          2  C0 G2 F2     C0 G2 F2" "4 corners are rounded, both joins of every blend are proved" "8 joins, C0 G2 F2"
run 0 verify --closed cubic.g2 --require G2
holds [ "$(grep -c '^4 4$' cubic.g2)" -eq 4 ] && holds [ "$(grep -cx '8 8' cubic.g2)" -eq 2 ]
{ line "0 0" "8 0"; printf '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n8 0\n10 4\n8 8\n'; line "8 8" "0 8"; line "0 8" "0 0"; } >bent.g2
run 0 blend bent.g2 --corners all --closed --distance 2 --cubic -o cubic.g2 --plot cubic.svg
says out "0 -> 1         1, 2" "all joins of every blend are proved" "10 joins, C0 G2 F2" && run 0 verify --closed cubic.g2 --require G2
run 0 blend bent.g2 --corner 1 --distance 2 --cubic --json && says out '"pieces":2,"inner_join":{"left":2,"right":3,' '"strategy":"cubic"'
run 0 blend "$S" --corners not-g1 --closed --distance 15 --cubic -o cubic.g2 && run 0 verify --closed cubic.g2 --require G1
run 2 blend bent.g2 --corners all --distance 2 --cubic --strategy fair && says err "--strategy: not with --cubic"
run 2 blend bent.g2 --corners all --distance 2 --cubic --order 3 && says err "--cubic: joins of order 2 only"

# a bound on the curvature: one cubic has 1.8857, two have 0.7175, the fair quintic has 0.70991
run 0 blend square.g2 --corners all --closed --distance 2 --cubic --max-curvature 0.8 -o two.g2
says out "0 -> 1         1, 2" "every blend is bent by at most the curvature 0.8, proved exactly"
run 0 verify --closed two.g2 --require G2 --min-radius 5/4 && says out "every join and every curve is G2, or bent by at most the radius 5/4, proved exactly"
run 1 blend square.g2 --corners all --closed --distance 2 --cubic --max-curvature 0.7 -o two.g2
says out "4 blends not bent by at most the curvature 0.7, the least of cubic, two cubics; a larger --distance" "corner 0 -> 1: curvature [0.7174"
run 0 blend square.g2 --corner 0 --distance 2 --max-curvature 0.71 --json && says out '"strategy":"fair"' '"max_curvature":"71/100","max_curvature_met":true'
run 1 blend square.g2 --corner 0 --distance 2 --max-curvature 0.4 --json && says out '"max_curvature_met":false,"bent":{"curve":1,"parameter":[' '"max_curvature_met":false,'

# an outline of a letter
for which in all not-g1; do
  run 0 blend "$S" --corners $which --closed --distance 15 -o S_$which.g2 --plot S_$which.svg --title "Round S" --strategy fair
  says out "proved in exact arithmetic" && says S_$which.svg "Round S" "</svg>"
done
run 0 verify --closed S_all.g2 --require G2
run 0 verify --closed S_not-g1.g2 --require G1
run 1 verify --closed S_not-g1.g2 --require G2
run 0 blend S_all.g2 --corners all --closed --distance 15 -o again.g2 && says out "0 corners are rounded"
holds cmp -s S_all.g2 again.g2
# short curves: a quarter remains
run 0 blend "$S" --corners all --closed --distance 1e6 -o short.g2
run 0 verify --closed short.g2 --require G2

# what the program writes can be read by itself, and goes to standard output
run 0 blend square.g2 --corners all --closed --distance 2 -o - && holds cmp -s out round.g2 && says err "4 corners are rounded"

# double: not exact
run 1 blend "$S" --corners all --closed --distance 15 --kernel double -o double.g2 && says out "24 corners are rounded; decided in exact arithmetic: rounding has broken 48 of 48 joins"
run 1 verify --closed double.g2 --require G2

# space
printf '100 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 2 1\n3 0 0\n\n100 1 0 0\n3 0\n3 3\n0 0 0 2 2 2\n3 0 0\n3 2 2\n1 4 4\n' >space.g2
run 0 blend space.g2 --corner 0 --distance 1/2 -o round.g2 && run 0 verify round.g2 --require G2

# lines whose lengths are rational are cut exactly, also where R is no double, and others as well as
# a double can
rectangle() { # rectangle X Y ANGLED: sides of X and Y along the axes, or along (3, 4) and (-4, 3)
  if [ "$3" = no ]; then line "0 0" "$1 0" && line "$1 0" "$1 $2" && line "$1 $2" "0 $2" && line "0 $2" "0 0"; else
    line "0 0" "$((3 * $1)) $((4 * $1))" && line "$((3 * $1)) $((4 * $1))" "$((3 * $1 - 4 * $2)) $((4 * $1 + 3 * $2))"
    line "$((3 * $1 - 4 * $2)) $((4 * $1 + 3 * $2))" "$((-4 * $2)) $((3 * $2))" && line "$((-4 * $2)) $((3 * $2))" "0 0"
  fi
}
rectangle 80 50 no >rectangle.g2 && run 0 blend rectangle.g2 --corners all --closed --distance 12 -o round.g2
holds [ "$(grep -c '         12  C0 G2 F2     C0 G2 F2$' out)" = 4 ]
for point in "12 0" "68 0" "80 12" "80 38" "68 50" "12 50" "0 38" "0 12"; do holds [ "$(grep -cx "$point" round.g2)" = 2 ]; done
# all corners alike: the tangents of each blend are equally long, along the sides of 80 and of 50
if command -v python3 >/dev/null; then
  run 0 blend rectangle.g2 --corners all --closed --distance 12 -o - && cp out all.g2
  holds python3 -c "
from fractions import Fraction
lines = [line.split() for line in open('all.g2')]
nets = [[[Fraction(x) for x in p] for p in lines[i + 2 : i + 8]] for i, line in enumerate(lines) if line == ['6', '6']]
square = lambda p, q: sum((x - y) ** 2 for x, y in zip(p, q))
assert len(nets) == 4 and len({tuple(square(n[j], n[5]) for j in range(6)) for n in nets}) == 1, nets
assert all(square(n[0], n[j]) == square(n[5], n[5 - j]) for n in nets for j in range(6)), nets"
fi
run 0 blend rectangle.g2 --corners all --closed --distance 1/7 -o round.g2 && holds [ "$(grep -cx '1/7 0' round.g2)" = 2 ]
run 0 blend rectangle.g2 --corners all --closed --distance 0.1 --json -o round.g2 && holds [ "$(grep -cx '1/10 0\|0.1 0' round.g2)" = 2 ]
rectangle 16 10 yes >turned.g2 && run 0 blend turned.g2 --corners all --closed --distance 12 -o round.g2 # sides of 80 and 50
says round.g2 "36/5 48/5" && holds [ "$(grep -c '         12  C0 G2 F2     C0 G2 F2$' out)" = 4 ]
{ line "0 0" "1 1" && line "1 1" "2 0" && line "2 0" "1 -1" && line "1 -1" "0 0"; } >diamond.g2 # sides of sqrt(2)
run 0 blend diamond.g2 --corners all --closed --distance 1/2 -o round.g2 --json
json_holds() { command -v python3 >/dev/null || return 0; holds python3 -c "import json; d = json.load(open('out')); c = d['corners']; $1"; }
json_holds "assert len({tuple(x[s]) for x in c for s in ('left_distance', 'right_distance')}) == 1
for x in c: low, high = x['left_distance']; assert .5 - 1e-15 < low <= .5 + 1e-15 and high - low < 1e-15, x"
# a line that is written as a cubic or as a rational line, and a domain of its own
{ printf '100 1 0 0\n2 0\n4 4\n3 3 3 3 5 5 5 5\n0 0\n20 0\n40 0\n60 0\n' && printf '100 1 0 0\n2 1\n2 2\n0 0 1 1\n60 0 1\n60 60 2\n'; } >lines.g2
run 0 blend lines.g2 --corner 0 --distance 7 -o round.g2 && says out "          7  " && holds [ "$(grep -c '^53 0$' round.g2)" = 2 ]
# of curves the true lengths are told, in guaranteed bounds that differ from R
{ line "-9 0" "0 0" && curve $'2 0\n3 3\n0 0 0 1 1 1\n0 0\n0 6\n6 9'; } >bent.g2
run 0 blend bent.g2 --corner 0 --distance 3 -o round.g2 --json
says out '"left_distance":[3,3]' '"proved":true' '"chain":{"joins":2,"g_order":2}'
json_holds "low, high = c[0]['right_distance']; assert low < high < low + 1e-5 and (high < 3 or 3 < low) and 2.997 < low < 3.003"
run 0 blend bent.g2 --corner 0 --distance 3 -o round.g2 && says out "3 and " && lacks out "        3  C0"
run 1 blend "$S" --corners all --closed --distance 15 --kernel double --json && says out '"proved":false'
run 0 blend square.g2 --corner 0 --distance 1 --json -o - && says err '"corners":[' # where the curves go to standard output

# bad input: nothing is written
# refused TEXT ARGUMENTS...: the error contains the text, and no file is written
refused() { run 2 "${@:2}" -o no.g2 && says err "$1" && holds [ ! -e no.g2 ]; }
{ line "-1e400 0" "0 0"; line "0 0" "0 1e400"; } >large.g2
refused "large.g2: not_finite" blend large.g2 --corner 0 --distance 1
refused "" blend large.g2 --corner 0 --distance 1 --plot large.svg && holds [ ! -e large.svg ]
{ line "0 0" "8 0"; line "8 0" "0 0"; } >back.g2
refused "the curves turn back on one line" blend back.g2 --corner 0 --distance 1
refused "--distance is needed" blend square.g2 --corner 0
refused "--corner and --corners: one of them" blend square.g2 --corner 0 --corners all --distance 1
refused "--corner: 4 is not from 0 to 3" blend square.g2 --corner 4 --distance 1
refused "--corner: -1 is not from 0 to 3" blend square.g2 --corner -1 --distance 1
refused "--corners: 'some' is none of all, not-g1" blend square.g2 --corners some --distance 1
refused "--distance: only with --corner or --corners" blend "$L" "$R" --distance 1
refused "--closed: only with --corner or --corners" blend "$L" "$R" --closed
refused "--closed: only with --corners" blend square.g2 --corner 0 --distance 1 --closed
refused "--replace: not with --corner or --corners" blend square.g2 --corner 0 --distance 1 --replace 1
refused "--beta: not with --corner or --corners" blend square.g2 --corners all --distance 1 --beta 1
refused "--strategy: 'c2' is none of fair" blend square.g2 --corner 0 --distance 1 --strategy c2
refused "--strategy: 'fair' is none of fair_g3" blend square.g2 --corner 0 --distance 1 --order 3 --strategy fair
refused "--order: 4 is not from 2 to 3" blend square.g2 --corner 0 --distance 1 --order 4
refused "one file is needed" blend "$L" "$R" --corner 0 --distance 1
refused "square.g2: parameter_outside_domain: round_corner: the distance 8 is not less than the length 8 of the left curve" \
  blend square.g2 --corner 0 --distance 8
for distance in 0 -1; do refused "parameter_outside_domain" blend square.g2 --corners all --distance $distance; done
for distance in x inf 1e400; do refused "distance" blend square.g2 --corners all --distance $distance; done
head -n 6 square.g2 >one.g2
refused "--corner: at least 2 curves are needed" blend one.g2 --corner 0 --distance 1
{ line "0 0" "8 0"; line "8 1" "8 8"; } >gap.g2
refused "gap.g2: curves_do_not_meet" blend gap.g2 --corner 0 --distance 1
refused "gap.g2: curves_do_not_meet: round_corners: join after curve 0" blend gap.g2 --corners all --distance 1
refused "curves_do_not_meet: round_corners: join after curve 0" blend one.g2 --corners all --closed --distance 1

# where a circle of a radius touches: R in right angles, half of it for the turn of cosine 3/5;
# joins without a turn stay
run 0 blend square.g2 --corners all --closed --radius 3/2 -o by_radius.g2 && cp out report && run 0 blend square.g2 --corners all --closed --distance 3/2 -o by_distance.g2
holds cmp -s by_radius.g2 by_distance.g2 && holds cmp -s out report
{ line "0 0" "5 0"; line "5 0" "10 0"; line "10 0" "16 8"; } >turn.g2
run 0 blend turn.g2 --corners all --radius 2 --json -o turned.g2 && says out '"join":1,' '"left_distance":[1,1],"right_distance":[1,1]' && lacks out '"join":0'
run 0 blend turn.g2 --corner 1 --radius 2 --cubic -o cubic.g2 && run 0 verify cubic.g2 --require G2
run 1 blend turn.g2 --corners all --radius 2 --kernel double -o turned.g2 && says out "1 -> 2"
refused "--distance and --radius: one of them" blend square.g2 --corner 0 --distance 1 --radius 1
refused "--radius: only with --corner or --corners" blend "$L" "$R" --radius 1
refused "parameter_outside_domain" blend square.g2 --corners all --radius 0
refused "turn back" blend back.g2 --corner 0 --radius 1

# a chain without joins ends like verify
cubic $'0 0 0\n8 0 0\n16 0 0\n24 0 0' >line.g2
run 2 verify line.g2 && says err "a single curve has no join" && mv err expected
run 2 blend line.g2 --corners all --distance 1 -o no.g2 && holds cmp -s err expected && holds [ ! -e no.g2 ]
