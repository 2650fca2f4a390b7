#!/usr/bin/env bash
# blend --corner and --corners: corners of chains and outlines are rounded; what is written is proved again.
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
# lines of length 8 are cut at 2 exactly: each cut ends a line and a blend ("2 0" is the dimension too)
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

# a spline with a kink at the triple knot 2 and a smooth knot on both sides: the chain of its Bezier curves
printf '100 1 0 0\n2 0\n9 4\n0 0 0 0 1 2 2 2 3 4 4 4 4\n0 0\n1 0\n2 2\n4 2\n5 0\n6 4\n7 5\n8 4\n9 0\n' >spline.g2
run 0 blend spline.g2 --corners all --distance 1/4 -o round_spline.g2 && says out "1 -> 2" "1 corner is rounded"
run 0 verify round_spline.g2 --require G2 && says out "4 joins"
run 0 blend spline.g2 --corner 1 --distance 1/4 -o one.g2 && holds cmp -s one.g2 round_spline.g2
run 1 verify spline.g2 --require G1

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

# bad input: nothing is written
refused() { # refused TEXT ARGUMENTS...: the error contains the text
  local text=$1
  shift
  run 2 "$@" -o no.g2 && says err "$text" && holds [ ! -e no.g2 ]
}
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

# a chain without joins ends like verify
cubic $'0 0 0\n8 0 0\n16 0 0\n24 0 0' >line.g2
run 2 verify line.g2 && says err "a single curve has no join" && mv err expected
run 2 blend line.g2 --corners all --distance 1 -o no.g2 && holds cmp -s err expected && holds [ ! -e no.g2 ]
