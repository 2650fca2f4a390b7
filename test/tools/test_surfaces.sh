#!/usr/bin/env bash
# verify --surfaces: edges and knot lines, exact and within a tolerance.
. "$(dirname "$0")/functions.sh"

# Bezier patches
run 0 verify "$teapot" --surfaces --allow-uncovered --json && says out '"summary":{"G2":24,"G1":20,"G0":8,"boundary":16,"collapsed":8'
run 1 verify "$teapot" --surfaces --require G1 && says out "8 of them not G1"
run 2 verify "$L" --surfaces && says err "space_left.g2:1"
run 2 verify "$teapot" --surfaces --require F1

# B-spline surfaces: a flat one with a double knot, one that continues it with other knots and a
# crease on the last span
flat "$flat_points" >low.g2
flat $'1 1 2 2\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 1/3' >high.g2
run 0 verify low.g2 --surfaces --require G2 && says out "0 u = 1: G2" "every shared edge and every knot line is G2"
run 1 verify low.g2 high.g2 --surfaces --require G1 && says out "0 v1 - 1 v0: G0 (crease)" "worst of 2 spans on [1, 2]" \
  "knot lines: 1 G2, 1 G1, 0 G0" "1 of them not G1"
run 1 verify low.g2 high.g2 --surfaces --require G2 --json && says out '"met":false' '"edge_b":"v0","order":"G0","reason":"crease"' \
  '"spans":[{"begin":"0","end":"1","order":"G2"' '{"begin":"1","end":"2","order":"G0"' \
  '"knot_lines":[' '{"patch":1,"direction":"u","knot":"1","multiplicity":2,"order":"G1"' '"boundary":6'
if command -v python3 >/dev/null; then
  holds python3 -c "import json; d = json.load(open('out')); assert len(d['edges'][0]['spans']) == 2 and len(d['knot_lines']) == 2"
fi
flat $'0 0 1 1\n0 0 0\n1 0 0\n2 0 1\n3 0 0\n4 0 0\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0' >roof.g2
run 1 verify roof.g2 --surfaces --require G1 && says out "1 of them not G1"
# surfaces within a tolerance: a crease of arctan(1/3) at one end, a kink along a knot line, a
# surface that is 2^-30 away
run 1 verify low.g2 high.g2 --surfaces --require G1 --within 0.321 && says out "order 0 proved, 1 refuted; gap 0, normal angle [18.4349, 18.435] degrees" \
  "1 of them not G1 within the tolerance"
run 0 verify low.g2 high.g2 --surfaces --require G1 --within 0.322 && says out "knot line is G1 within the tolerance, proved exactly"
run 0 verify low.g2 high.g2 --surfaces --within 0.321 --json && says out '"within":["proved","refuted"],"gap":[0,0],"normal_angle":[0.3217505543966' \
  '"near_edges":[]'
# a tolerance inside of the bounds
bound=$(sed -n 's/.*"within":\["proved","refuted"\],"gap":\[0,0\],"normal_angle":\[\([0-9.]*\),.*/\1/p' out | head -n 1)
run 1 verify low.g2 high.g2 --surfaces --within "$bound" && says out "1 undecided" "undecided: 1 edge, the tolerance lies between the bounds" \
  "not met, because not all was decided (see --allow-undecided)"
run 0 verify low.g2 high.g2 --surfaces --within "$bound" --allow-undecided && lacks out "not met"
run 1 verify low.g2 high.g2 --surfaces --within "$bound" --json && run 0 verify low.g2 high.g2 --surfaces --within "$bound" --require G0
run 1 verify roof.g2 --surfaces --require G1 --within 0.5 && run 0 verify roof.g2 --surfaces --require G1 --within 1.3
flat $'1 1 2 2\n0 1 1/1073741824\n1 1 1/1073741824\n2 1 1/1073741824\n3 1 1/1073741824\n4 1 1/1073741824\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 0' >near.g2
run 0 verify low.g2 near.g2 --surfaces --require G1 --within 1e-8,1e-10 && says out "8 boundary" && holds test -z "$(grep near out)"
run 0 verify low.g2 near.g2 --surfaces --require G1 --within 1e-8,1e-9 && says out "0 v1 - 1 v0: near" "near edges: 1" \
  "within the tolerance: order 0 proved, 1 proved; gap [9.31322e-10, 9.31323e-10], normal angle" "every pair of near edges"
run 1 verify low.g2 near.g2 --surfaces --require G1 --within 1e-10,1e-9 && says out "1 of them not G1 within the tolerance"
run 0 verify low.g2 near.g2 --surfaces --require G0 --within 0,1e-9 --json && says out '"near_edges":[' '"patch_a":0,"edge_a":"v1","patch_b":1,"edge_b":"v0","reversed":false,"within":["proved","refuted"],"gap":[9.31322574615478' '"met":true'
if command -v python3 >/dev/null; then
  holds python3 -c "import json; assert len(json.load(open('out'))['near_edges']) == 1"
fi
for bad in 1,2,3 x -1 1,-1 nan ''; do run 2 verify low.g2 --surfaces --within "$bad" && says err "within"; done
run 2 verify low.g2 --surfaces --within 1 --require G2 && says err "G0 and G1 are decided"
surface_error() { # surface_error REASON: the file bad.g2 is refused after a good one
  run 2 verify low.g2 bad.g2 --surfaces && says err "bad.g2:$1"
}
flat $'0 0 1 1\n0 0 0\n1 nan 0' >bad.g2 && surface_error "8: not a number: 'nan'"
flat $'0 0 1 1\n0 0 0\n1 0 1/0' >bad.g2 && surface_error "8: zero denominator"
flat $'0 0 1 1\n0 0 0\n1 0 0' >bad.g2 && surface_error "8: file ends after 2 of 10 control points"
flat $'0 0 1 -1' >bad.g2 && surface_error "6: the knots in v decrease at '-1'"
printf '200 1 0 0\n3 0\n5 3\n0 0 0 1 1 1 1 2' >bad.g2 && surface_error "4: knot 7 of 8 in u is repeated more than 3 times"
printf '200 1 0 0\n3 0\n2 3\n' >bad.g2 && surface_error "3: 2 control points and order 3 in u"
printf '200 1 0 0\n3 2\n' >bad.g2 && surface_error "2: the rational flag is '2'"
printf '200 1 0 0\n2 0\n' >bad.g2 && surface_error "2: dimension 2 where 3 is expected"
printf '' >bad.g2 && surface_error "1: no surface"
