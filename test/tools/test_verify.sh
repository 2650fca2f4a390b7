#!/usr/bin/env bash
# verify of chains: orders, requirements, tolerances, inner knots.
. "$(dirname "$0")/functions.sh"

run 0 blend "$L" "$R" -o blend.g2
run 1 blend "$L" "$R" --kernel double -o double.g2

# joins within a tolerance
run 1 verify "$L" double.g2 "$R" --kernel double --require G2 --within 1e-12,1e-25,0
run 0 verify "$L" double.g2 "$R" --kernel double --require G2 --within 1e-9,1e-9,0 && says out "within the tolerance, proved"
run 0 verify "$L" double.g2 "$R" --kernel double --within 1e-9,1e-9,0 --json && says out '"within":["proved","proved","proved",' '"tangent_angle":['
run 0 verify --closed "$S" --within 0.004,0.1,0 && says out "order 0 proved, 1 proved, 2 refuted" "tangent angle"
# a kink of straight lines: there is no torsion to compare
{ spline $'2 2\n0 0 1 1\n0 0 0\n1 0 0'; spline $'2 2\n0 0 1 1\n1 0 0\n2 1e-3 0'; } >kink.g2
run 1 verify kink.g2 --within 1,1,1 && says out "2 proved, 3 undecided" "undecided: 1 join, the tolerance lies between the bounds" \
  "not met, because not all was decided (see --allow-undecided)"
run 0 verify kink.g2 --within 1,1,1 --allow-undecided && says out "undecided: 1 join" && lacks out "not met" "proved exactly"
run 1 verify kink.g2 --within 1,1,1 --allow-uncovered --json && says out '"claims":{"given":1,"decided":0,"not_met":0,"undecided":[{"what":"join",'
run 1 verify kink.g2 --within 1,1,1 --require F3
run 0 verify kink.g2 --within 1,1,1 --require F2 && says out "F2 within the tolerance, proved"
for bad in 1,2 1,2,x -1,0,0 1,2,3,4,5 nan,0,0; do run 2 verify "$L" "$R" --within $bad && says err "within"; done
run 2 verify --closed "$S" --within 1,1,1 --require C3 && says err "C up to 2 are decided" && run 2 verify "$S" --within 1
# C orders: the relative jump of the first derivatives is 1/1000, that of the second ones 1
{ curve "2 0"$'\n3 3\n0 0 0 1 1 1\n0 0\n1 0\n2 0'; curve "2 0"$'\n3 3\n0 0 0 1 1 1\n2 0\n3 0.001\n4 0.001'; } >nearly.g2
run 0 verify nearly.g2 --require C1 --within 0,0.001rad,1% && run 1 verify nearly.g2 --require C1 --within 0,0.0009rad,1% && says out "not C1 within the tolerance"
run 1 verify nearly.g2 --require C2 --within 0,0.001rad,1% && run 0 verify nearly.g2 --require C2 --within 0,0.001rad,100% && says out "C2 within the tolerance, proved"

# a bound on the curvature: of a parabola 2, of a cusp none, and of a line 0
printf '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n-1 1\n0 -1\n1 1\n' >parabola.g2
run 0 verify parabola.g2 --max-curvature 2 && says out "0 joins; 1 curve" "every curve is bent by at most the curvature 2, proved exactly"
run 1 verify parabola.g2 --min-radius 0.500001 && says out "curve 0: curvature 2, radius 0.5 at the parameter 0.5" "1 of them not bent by at most the radius 0.500001"
run 1 verify parabola.g2 --max-curvature 1 --json && says out '"bent_curves":[' '{"curve":0,"parameter":[0.5,0.5],"curvature":[2,2]}' '"max_curvature":"1","met":false'
printf '100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1\n1 1\n2 2\n1 2\n2 1\n' >cusp.g2
run 1 verify parabola.g2 cusp.g2 --max-curvature 1e9 --kernel double && says out "curve 1: curvature without a bound, as in a cusp, at the parameter 0.5" "1 of them not"
run 1 verify parabola.g2 cusp.g2 --max-curvature 2 --require G1 --json && says out '{"curve":1,"parameter":[0.5,0.5],"curvature":null}' '"required":"G1","max_curvature":"2","met":false'
run 1 verify --closed "$S" --max-curvature 1 && says out "curve 25: curvature without a bound, as in a cusp, at the parameter 0" "1 of them not" # a handle of length 0
run 2 verify - --max-curvature 1 && says err "standard input"
for bad in -1 x; do run 2 verify parabola.g2 --max-curvature $bad && says err "--max-curvature"; done
run 2 verify parabola.g2 --min-radius 0 && says err "not a positive length"
run 2 verify parabola.g2 --min-radius 1 --max-curvature 1 && says err "one of them"
run 2 verify --surfaces "$teapot" --max-curvature 1 && says err "--max-curvature: not with --surfaces"

# orders and requirements
run 0 verify --closed "$S" && says out "28 joins: 12 G0, 12 G1, 4 G2" "kink of 0.2217 degrees" "zero tangent at the start" \
  "curvature jumps from"
run 0 verify --closed "$S" --require C0 && run 1 verify --closed "$S" --require G1 && run 1 verify "$L" "$R" --require C0
run 1 verify "$L" "$R" --json --require C0 && says out '"c_order":-1,"g_order":-1,"f_order":-1,"betas":[]' '"met":false'
run 0 verify "$L" blend.g2 "$R" --max-order 0 && run 0 verify "$L" blend.g2 "$R" --max-order 9
run 2 verify "$L" blend.g2 "$R" --max-order 33 && run 2 verify "$L" blend.g2 "$R" --max-order two
for bad in G X2 G2x g2 2 "" G99; do run 2 verify --closed "$S" --require "$bad" && says err "--require"; done
run 2 verify --closed "$S" --require F3 && says err "at most the dimension"
run 2 verify "$L" && says err "no join"
if command -v python3 >/dev/null; then
  run 0 verify --closed "$S" --json
  holds python3 -c "import json; d = json.load(open('out')); assert len(d['joins']) == 28 and d['joins'][27]['right'] == 0"
fi

# handles of length 0: the unit tangents decide, as in drawings. A zero tangent at an end that is
# drawn as a line, as a kink, as a corner, as a cusp
handles() { # the points of a cubic that ends in (0, 164), and of the curve that starts there
  { curve $'2 0\n4 4\n0 0 0 0 1 1 1 1\n'"$1"; curve $'2 0\n'"$2"; } >zh.g2
}
line=$'2 2\n0 0 1 1\n0 164\n0 200' lines=$'50 0\n0 160\n0 164\n0 164'
handles "$lines" "$line"
run 0 verify zh.g2 && says out "zero tangent at the end of the left curve, drawn as G1" "1 join: 1 G0; 1 with a zero tangent, 1 of them drawn as G1"
run 0 verify zh.g2 --require G1 && says out "every join is G1, proved exactly" && run 0 verify zh.g2 --require F1 --summary
run 1 verify zh.g2 --require G2 && run 1 verify zh.g2 --require C1 && run 0 verify zh.g2 --json && says out '"regular":false' '"drawn":"G1","drawn_angle_degrees":[0,0]' \
  '"zero_tangent":1,"drawn_g1":1'
run 0 verify zh.g2 --format sarif && lacks out ruleId
handles $'50 0\n-.125 160.5\n0 164\n0 164' "$line"
run 0 verify zh.g2 && says out "drawn as kink of 2.045 degrees" "1 with a zero tangent, 0 of them drawn as G1" && run 1 verify zh.g2 --require G1
run 0 verify zh.g2 --format sarif && says out '"ruleId":"kink"' && run 1 verify zh.g2 --require G1 --kink-angle 2 --format sarif && says out '"ruleId":"corner"'
run 0 verify zh.g2 --require G1 --within 0.04,0,0 && run 1 verify zh.g2 --require G1 --within 0.03,0,0
handles $'50 0\n-.125 160.5\n0 164\n0 164' $'4 4\n0 0 0 0 1 1 1 1\n0 164\n0 164\n3 190\n0 200'
run 0 verify zh.g2 && says out "zero tangent on both sides, drawn as kink of 4.537 degrees"
handles "$lines" $'2 2\n0 0 1 1\n0 164\n0 100'
run 0 verify zh.g2 && says out "drawn as corner of 180 degrees" && run 1 verify zh.g2 --require G1
handles $'0 50\n0 164\n0 164\n0 164' "$line" # the third derivative tells
run 0 verify zh.g2 --require G1 && says out "drawn as G1"
handles $'0 164\n0 164\n0 164\n0 164' "$line"
run 1 verify zh.g2 --require G1 && says out "zero tangent at the end of the left curve" && lacks out "drawn"
# three derivatives that are zero, and a fourth one that is read with a higher order
{ curve $'2 0\n5 5\n0 0 0 0 0 1 1 1 1 1\n0 0\n0 164\n0 164\n0 164\n0 164'; curve $'2 0\n'"$line"; } >zh.g2
run 1 verify zh.g2 --require G1 && says out "undecided: 1 join, all derivatives that are read are zero, see --max-order" && run 0 verify zh.g2 --require G1 --allow-undecided
run 0 verify zh.g2 --require G1 --max-order 4 && says out "drawn as G1"
{ spline $'4 4\n0 0 0 0 1 1 1 1\n50 0 0\n0 160 0\n0 164 0\n0 164 0'; spline $'2 2\n0 0 1 1\n0 164 0\n0 200 1'; } >zh.g2 # in space
run 0 verify zh.g2 && says out "drawn as kink of 1.591 degrees"
{ spline $'4 4\n0 0 0 0 1 1 1 1\n50 0 0\n0 160 0\n0 164 0\n0 164 0'; spline $'2 2\n0 0 1 1\n0 164 0\n0 200 0'; } >zh.g2
run 0 verify zh.g2 --require G1

# curves with inner knots: each knot is a join, decided exactly with both kernels
spline "$two_knots" >spline.g2
for kernel in exact double; do
  run 0 verify spline.g2 --kernel $kernel --require C1 && says out "2 joins: 1 G1, 1 G2"
  run 1 verify spline.g2 --kernel $kernel --require G2 && says out "1 of them not G2"
done
run 0 verify spline.g2 --json && says out '{"left":0,"right":1,"c_order":2' '{"left":1,"right":2,"c_order":1'
run 0 blend spline.g2 "$R" -o blend.g2 && says out "proved in exact arithmetic"
run 0 verify spline.g2 blend.g2 "$R" && says out "4 joins: 1 G1, 3 G2"
run 0 blend "$L" spline.g2 --order 3 -o blend.g2 && run 0 verify "$L" blend.g2 spline.g2 && says out "4 joins: 1 G1, 1 G2, 2 G3"
run 1 blend spline.g2 "$R" --kernel double
run 0 extend spline.g2 --order torsion --c0 3 --c2 0 --plot three.svg -o three.g2 && run 0 verify three.g2 --json
says out '{"left":2,"right":3,"c_order":1,"g_order":2,"f_order":3'
holds [ "$(grep -c '^100 ' three.g2)" -eq 4 ]
run 0 plot spline.g2 -o spline.svg && says spline.svg ">G1<" ">G2<"
spline $'7 4\n-3 -2 -1 0 1 2 3 4 5 6 7\n0 0 0\n4 0 1\n4 4 0\n0 4 1\n0 0 0\n4 0 1\n4 4 0' >round.g2
run 0 verify --closed round.g2 --require C2 && says out "4 joins"
run 0 blend round.g2 --replace 1 -o replaced.g2 && run 0 verify --closed replaced.g2 --require G2
run 2 blend round.g2 --replace 4 -o no.g2
spline $'4 2\n0 0 1 1 3 3\n0 0 0\n1 0 0\n1 1 0\n2 1 0' >jump.g2
run 1 verify jump.g2 --require C0 && says out "1 gap"
spline $'4 2\n0 0 1 .5 3 3\n0 0 0\n1 0 0\n1 1 0\n2 1 0' >bad.g2
run 2 verify bad.g2 && says err "bad.g2:4" "the knots decrease"

# a curve that runs backwards
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >forwards.g2 && cubic $'6 1 0\n5 0 0\n4 0 0\n3 0 0' >backwards.g2 && cubic $'6 1 0\n7 2 0\n8 2 0\n9 2 0' >on.g2
run 0 verify forwards.g2 backwards.g2 on.g2 && says out "apart; it closes when the right curve is reversed" "apart; it closes when the left curve is reversed"
