#!/usr/bin/env bash
# What scripts rely on: output, exit codes and errors of the program.
# Usage: test_program.sh PROGRAM DATA_FOLDER WORK_FOLDER TEAPOT.g2
set -u
program=$1 data=$2 work=$3 teapot=$4
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
failures=0 checks=0

# run CODE ARGUMENTS...: the exit code is CODE; output and errors are kept in the files out and err
run() {
  local expected=$1 code=0
  shift
  checks=$((checks + 1))
  "$program" "$@" >out 2>err </dev/null || code=$?
  [ "$code" -eq "$expected" ] && return
  failures=$((failures + 1))
  echo "exit code $code instead of $expected: $*"
  head -c 5000 out err
}
# says FILE TEXT...: the file contains each text
says() {
  local file=$1 text
  shift
  for text in "$@"; do
    checks=$((checks + 1))
    grep -qF -- "$text" "$file" && continue
    failures=$((failures + 1))
    echo "'$text' is missing in $file:"
    head -c 5000 "$file"
  done
}
# holds CONDITION...: the shell condition is true
holds() {
  checks=$((checks + 1))
  if ! "$@"; then
    failures=$((failures + 1))
    echo "not true: $*"
  fi
}

S=$data/lmroman10-regular_S_0.g2 L=$data/space_left.g2 R=$data/space_right.g2

# help and usage
narrow() { # the file out fits into a terminal of 80 columns
  holds [ -z "$(awk 'length > 80' out)" ]
}
run 0 --help && says out "blend" "extend" "verify" "plot" && narrow
for command in blend connect extend verify plot tessellate; do
  run 0 $command --help && says out "usage: geometric_continuity $command" && narrow
done
run 2 && run 2 nonsense && says err "unknown command"
run 2 verify && run 2 verify --nonsense "$S" && run 2 blend "$L" && run 2 plot "$L"

# blend by each strategy; every file that is written is proved
for strategy in c2 normal min_second near_line energy2 energy3; do
  run 0 blend "$L" "$R" --strategy $strategy -o blend.g2 && says out "proved in exact arithmetic"
  run 0 verify "$L" blend.g2 "$R" --require G2
done
for strategy in c3 seq_g3 seq_f3 joint_g3 energy3_g3 energy4_g3; do
  run 0 blend "$L" "$R" --order 3 --strategy $strategy -o blend.g2 && says out "proved in exact arithmetic"
  run 0 verify "$L" blend.g2 "$R" --require F3
done
run 0 blend "$L" "$R" --strategy free --s1 -1/5 --s2 0.2 -o free.g2
run 0 blend "$L" "$R" --strategy normal -o normal.g2
holds cmp -s free.g2 normal.g2
run 0 blend "$L" "$R" --order 3 --strategy free --start 0,0,0 --end 0,0,0 -o free.g2
run 0 blend "$L" "$R" --order 3 --strategy c3 -o c3.g2
holds cmp -s free.g2 c3.g2
run 0 blend "$L" "$R" --beta 3/2 --eta 0.5 -o blend.g2
run 0 verify "$L" blend.g2 "$R" --require G2 --json && says out '"betas":["3/2",' '"betas":["2",'
run 0 blend "$L" "$R" --strategy all --plot all.svg
holds [ "$(grep -c '</svg>' all.svg)" -eq 7 ]
run 0 blend "$L" "$R" && run 0 blend "$L" "$R" --strategy energy3 -o energy3.g2
run 0 blend "$L" "$R" -o default.g2
holds cmp -s default.g2 energy3.g2

# blends in double are not exact, and the report says so
run 0 blend "$L" "$R" --kernel double -o double.g2 && says out "rounding has broken a join"
run 1 verify "$L" double.g2 "$R" --kernel double --require G2

# unless they are representable
for strategy in c2 normal min_second near_line energy2 energy3; do
  run 0 blend "$L" "$R" --representable --strategy $strategy -o chain.g2 && says out "G2" "proved in exact arithmetic"
  run 0 verify chain.g2 --require G2 && says out "2 joins"
  run 0 verify chain.g2 --require G2 --kernel double
done
run 2 blend "$L" "$R" --representable --order 3 -o no.g2 && run 2 blend "$S" --replace 1 --representable -o no.g2
printf '100 1 0 0\n3 0\n2 2\n0 0 1 1\n1 0 0\n1.0000000000000002 0 0\n' >stiff.g2
run 2 blend stiff.g2 "$R" --representable -o no.g2 && says err "not_representable"

# joins within a tolerance
run 1 verify "$L" double.g2 "$R" --kernel double --require G2 --within 1e-12,1e-25,0
run 0 verify "$L" double.g2 "$R" --kernel double --require G2 --within 1e-9,1e-9,0 && says out "within the tolerance, proved"
run 0 verify "$L" double.g2 "$R" --kernel double --within 1e-9,1e-9,0 --json && says out '"within":["proved","proved","proved",' '"tangent_angle":['
run 0 verify --closed "$S" --within 0.004,0.1,0 && says out "order 0 proved, 1 proved, 2 refuted" "tangent angle"
for bad in 1,2 1,2,x -1,0,0 1,2,3,4,5 nan,0,0; do run 2 verify "$L" "$R" --within $bad && says err "within"; done
run 2 verify --closed "$S" --within 1,1,1 --require C1 && run 2 verify "$S" --within 1

# replacing a piece of an outline
run 0 blend "$S" --replace 1 -o S.g2
run 0 verify --closed S.g2 --json && says out '{"left":0,"right":1,"c_order":1,"g_order":2' '{"left":1,"right":2,"c_order":1,"g_order":2'
run 0 blend "$S" --replace 0 -o S.g2 && run 0 blend "$S" --replace 27 -o S.g2
run 2 blend "$S" --replace 28 -o no.g2 && run 2 blend "$S" --replace -1 -o no.g2 && run 2 blend "$L" --replace 0 -o no.g2

# verify
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

# extend: the members that are asked for, and what does not exist
run 0 extend "$L" --order curvature --c0 3 -o two.g2 && says out "C1 G2"
run 0 verify two.g2 --require G2
run 0 extend two.g2 --order torsion --beta 1/2 --c0 1 --c1 2 --c2 -1 -o three.g2 --plot three.svg
run 0 verify three.g2 --require F2 && says out "2 joins"
run 0 extend "$L" --order torsion --toward 6,1,2 -o two.g2 && run 0 verify two.g2 --require F3
run 0 extend "$L" --order tangent --toward 6,1,2 -o two.g2 && says two.g2 "6 1 2"
run 0 extend "$L" --order curvature --kernel double -o two.g2
run 2 extend "$L" --order shape -o no.g2 && run 2 extend "$L" -o no.g2 && run 2 extend "$L" --order tangent
run 2 extend "$L" --order tangent --c0 1 -o no.g2 && run 2 extend "$L" --order torsion --toward 1,2 -o no.g2
run 2 extend "$L" --order torsion --toward 1,2,3 --c0 1 -o no.g2 && run 2 extend "$L" --order tangent --beta 0 -o no.g2
printf '100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 0\n1 0\n' >line.g2
run 2 extend line.g2 --order curvature -o no.g2 && says err "wrong_number_of_points"
run 0 extend line.g2 --order tangent -o two.g2 && run 2 plot line.g2 --alternatives -o no.svg

# curves with inner knots: each knot is a join, decided exactly with both kernels
spline() { printf '100 1 0 0\n3 0\n%s\n' "$1"; }
spline $'7 4\n0 0 0 0 1 2 2 3 3 3 3\n0 0 0\n1 2 0\n2 3 1\n4 1 1\n5 0 3\n7 2 2\n8 3 0' >spline.g2
for kernel in exact double; do
  run 0 verify spline.g2 --kernel $kernel --require C1 && says out "2 joins: 1 G1, 1 G2"
  run 1 verify spline.g2 --kernel $kernel --require G2 && says out "1 of them not G2"
done
run 0 verify spline.g2 --json && says out '{"left":0,"right":1,"c_order":2' '{"left":1,"right":2,"c_order":1'
run 0 blend spline.g2 "$R" -o blend.g2 && says out "proved in exact arithmetic"
run 0 verify spline.g2 blend.g2 "$R" && says out "4 joins: 1 G1, 3 G2"
run 0 blend "$L" spline.g2 --order 3 -o blend.g2 && run 0 verify "$L" blend.g2 spline.g2 && says out "4 joins: 1 G1, 1 G2, 2 G3"
run 0 blend spline.g2 "$R" --kernel double
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

# connect: a flat ribbon, one that folds, curves that do not fit
cubic() { printf '100 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1\n%s\n' "$1"; }
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
run 2 connect c.g2 c1.g2 spline.g2 -o no.g2 && says err "parameter_outside_domain"

# surfaces
run 0 verify "$teapot" --surfaces --json && says out '"summary":{"G2":24,"G1":20,"G0":8,"boundary":16,"collapsed":8'
run 1 verify "$teapot" --surfaces --require G1 && says out "8 of them not G1"
run 2 verify "$L" --surfaces && says err "space_left.g2:1"
run 2 verify "$teapot" --surfaces --require F1

# B-spline surfaces: a flat one with a double knot, one that continues it with other knots and a crease on the last span
flat() { printf '200 1 0 0\n3 0\n5 3\n0 0 0 1 1 2 2 2\n2 2\n%s\n' "$1"; }
flat $'0 0 1 1\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0' >low.g2
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
run 1 verify roof.g2 --surfaces --require G1 && says out "1 knot line not G1"
# surfaces within a tolerance: a crease of arctan(1/3) at one end, a kink along a knot line, a surface that is 2^-30 away
run 1 verify low.g2 high.g2 --surfaces --require G1 --within 0.321 && says out "order 0 proved, 1 refuted; gap 0, normal angle [0.321751, 0.321751]" \
  "1 of them not G1 within the tolerance"
run 0 verify low.g2 high.g2 --surfaces --require G1 --within 0.322 && says out "knot line is G1 within the tolerance, proved exactly"
run 0 verify low.g2 high.g2 --surfaces --within 0.321 --json && says out '"within":["proved","refuted"],"gap":[0,0],"normal_angle":[0.3217505543966' \
  '"near_edges":[]'
run 1 verify roof.g2 --surfaces --require G1 --within 0.5 && run 0 verify roof.g2 --surfaces --require G1 --within 1.3
flat $'1 1 2 2\n0 1 1/1073741824\n1 1 1/1073741824\n2 1 1/1073741824\n3 1 1/1073741824\n4 1 1/1073741824\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 0' >near.g2
run 0 verify low.g2 near.g2 --surfaces --require G1 --within 1e-8,1e-10 && says out "8 boundary" && holds test -z "$(grep near out)"
run 0 verify low.g2 near.g2 --surfaces --require G1 --within 1e-8,1e-9 && says out "0 v1 - 1 v0: near" "near edges: 1" \
  "within the tolerance: order 0 proved, 1 proved; gap 9.31323e-10, normal angle" "every pair of near edges"
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
printf '200 1 0 0\n3 1\n' >bad.g2 && surface_error "2: rational surfaces are not supported"
printf '200 1 0 0\n2 0\n' >bad.g2 && surface_error "2: dimension 2 where 3 is expected"
printf '' >bad.g2 && surface_error "1: no surface"

# drawings: kinks by element and command
leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
run 0 verify "$leaf" && says out "24 joins in 8 subpaths: 3 G0, 12 G1, 1 G2, 8 G3 or more" \
  'path "leaf" (line 50), subpath 1, commands 3 c - 4 c at (28.5, 6.25): G0, kink of 93.1 degrees' \
  'commands 2 c - 3 s at (37.1946, 48.6223): G1, curvature jumps' 'use "use1" (line 97): not verified'
run 0 verify "$badge" && says out "31 joins in 8 subpaths: 12 G0, 11 G1, 6 G3 or more, 2 undecided" \
  "the closing line is 27.7 long" "a handle is at the node" "undecided, a rotated ellipse"
run 0 verify "$leaf" --require G0 && says out "every join is G0, proved exactly"
run 1 verify "$leaf" --require G1 && says out "3 of them not G1"
run 1 verify "$badge" --require G0 && says out "2 of them not proved to be G0"
run 0 verify "$leaf" "$badge" && says out "55 joins in 16 subpaths" "badge_illustrator.svg: path \"ring\""
run 0 verify "$leaf" --max-order 1 && says out "3 G0, 21 G1 or more"
run 2 verify "$leaf" --require F3 && run 2 verify "$leaf" --closed && run 2 verify "$leaf" --surfaces
run 2 verify "$leaf" --kernel double && run 2 verify "$leaf" "$S" && says err "cannot be verified together"
if command -v python3 >/dev/null; then
  run 1 verify "$badge" --json --require G1
  holds python3 -c "import json; d = json.load(open('out')); j = d['joins']; assert len(j) == 31 and not d['met'] and \
    d['summary'] == {'joins': 31, 'subpaths': 8, 'G0': 12, 'G1': 11, 'G3': 6, 'undecided': 2} and \
    [x for x in j if x['id'] == 'banner'][2]['right_letter'] == 'l' and j[11]['left'] == 11 and j[11]['right'] == 2"
fi
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg">\n%s</svg>\n' "$1" >drawing.svg; }
svg '<path id="a&quot;b&#10;\" d="M0 0h1v1"/>'
run 0 verify drawing.svg --json && says out '"id":"a\"b\u000a\\"'
svg '<g transform="scale(0)"><path d="M0 0h1v1"/></g><rect width="100%" height="3"/><rect width="1e1mm" height="1in" ry="1"/>'
run 0 verify drawing.svg && says out "its transform is not invertible" 'width="100%" is relative' "8 joins in 1 subpath: 8 G1"
svg '<path d="M0 0h1v1h-1.001z"/>'
run 0 verify drawing.svg && says out "kink of 89.94 degrees, the closing line is 1 long" "at (-0.001, 1)"
cp drawing.svg DRAWING.SVG && cp drawing.svg drawing
run 0 verify DRAWING.SVG && run 0 verify drawing
svg '' && run 0 verify drawing.svg --require G2 && says out "0 joins"
printf '\xff\xfe' >utf16.svg && printf '<svg><path d="M0 0h1v1"/></svg>' | sed 's/./&\x00/g' >>utf16.svg
run 0 verify utf16.svg && says out "1 join "

bad_drawing() { # bad_drawing LINE REASON: the file drawing.svg is refused
  run 2 verify drawing.svg --require G1 && says err "malformed_input: drawing.svg:$1: " "$2"
  holds [ ! -s out ]
}
svg '<path d="M0 0h1v1"/><path id="p"
 d="M0 0L1 1 2"/>' && bad_drawing 2 'path "p", d, character 11: the end where a number is expected'
svg '<g transform="turn(3)"/>' && bad_drawing 2 "g, transform, character 1: 'turn' is not a transform"
svg '<circle r="-1"/>' && bad_drawing 2 "circle, r: negative"
svg '<circle r="1m"/>' && bad_drawing 2 "circle, r, character 1: 'm' is not a unit of length"
svg '<polygon points="1 2 3"/>' && bad_drawing 2 "polygon, points, character 6"
svg '<path d="M0 0h1v1"' && bad_drawing 2 "not well-formed"
svg '<g></svg>' && bad_drawing 2 "mismatched tag"
printf '' >drawing.svg && bad_drawing 1 "no element found"
printf '\0\0\0' >drawing.svg && bad_drawing 1 "not well-formed"
printf '<html/>' >drawing.svg && bad_drawing 1 "the root element is 'html', not svg"
head -c 1500 "$leaf" >drawing.svg && bad_drawing 58 "unclosed token"
printf '100 1 0 0\n' >drawing.svg && bad_drawing 1 "syntax error"
svg "$(printf '<g>%.0s' {1..255})$(printf '</g>%.0s' {1..255})" && run 0 verify drawing.svg
svg "$(printf '<g>%.0s' {1..256})$(printf '</g>%.0s' {1..256})" && bad_drawing 2 "nested deeper than 256"
svg "$(printf '<g>%.0s' {1..20000})" && bad_drawing 2 "nested deeper than 256"
entities=$(for i in {1..9}; do printf '<!ENTITY e%d "%s">' "$i" "$(printf "&e$((i - 1));%.0s" {1..10})"; done)
printf '<!DOCTYPE svg [<!ENTITY e0 "x">%s]>\n<svg>&e9;</svg>' "$entities" >drawing.svg && bad_drawing 1 "the entity 'e0' is declared"
printf '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">\n<svg/>' >drawing.svg
run 0 verify drawing.svg
run 2 verify missing.svg && says err "cannot_read_file: missing.svg"

# triangles and pictures of surfaces
run 0 tessellate "$teapot" --tolerance 0.1 -o teapot.off && says out "978 points, 1888 triangles" "64 on the boundary"
says teapot.off "978 1888 0"
run 0 tessellate "$teapot" --tolerance 1/10 --kernel exact -o exact.off && says out "978 points, 1888 triangles"
for format in ply obj stl; do run 0 tessellate "$teapot" --grid 2 -o "teapot.$format"; done
says teapot.ply "element face 240" && says teapot.stl "endsolid" && holds [ "$(grep -c '^f ' teapot.obj)" -eq 240 ]
run 0 tessellate flat.g2 -o flat.off && says out "2 surfaces"
run 2 tessellate "$teapot" -o no.vtk && says err ".off, .obj, .ply or .stl"
for bad in 0 -1 nan 1e-12 x; do run 2 tessellate "$teapot" --tolerance "$bad" -o no.off; done
for bad in 0 -3 100000 x; do run 2 tessellate "$teapot" --grid "$bad" -o no.off; done
run 2 tessellate "$teapot" --grid 2 --tolerance 1 -o no.off && run 2 tessellate "$teapot" && run 2 tessellate -o no.off
run 2 tessellate "$L" -o no.off && says err "space_left.g2:1"
run 0 plot --surfaces "$teapot" -o teapot.svg --title 'A <pot>' && says teapot.svg "isophotes" "edge, G1" "boundary" "A &lt;pot&gt;"
holds [ "$(wc -c <teapot.svg)" -lt 1500000 ]
run 0 plot --surfaces flat.g2 --shaded --view 30,60 -o flat.svg && says flat.svg "edge, G2"
for bad in 30 30,x 30,91 ,; do run 2 plot --surfaces "$teapot" --view "$bad" -o no.svg; done
run 2 plot --surfaces "$teapot" --shaded --isophotes -o no.svg && run 2 plot --surfaces "$L" -o no.svg
holds [ ! -e no.off -a ! -e no.vtk ]

# pictures
run 0 plot "$data/planar.g2" --alternatives -o alternatives.svg && says alternatives.svg "construction"
run 0 plot "$S" "$L" -o both.svg --title 'A < B & "C"' && says both.svg "A &lt; B &amp;"
run 0 plot "$S" --closed --no-comb --no-polygon --columns 1 -o S.svg
holds [ ! -e no.g2 ]

# bad input: a message with file, line and reason, exit code 2, and no output
bad() { # bad REASON: the file bad.g2 is refused
  run 2 verify bad.g2 "$L" && says err "bad.g2" "$1"
  run 2 blend bad.g2 "$R" -o no.g2 --plot no.svg && says err "bad.g2"
  holds [ ! -e no.g2 -a ! -e no.svg ]
}
curve() { printf '100 1 0 0\n%s\n' "$1"; }
printf '' >bad.g2
bad "bad.g2:1"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2' >bad.g2
bad "3 of 4"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 nan 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 inf 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1/0 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1e999999999 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4000000000 4\n0 0 0 0 1 1 1 1\n0 0 0' >bad.g2
bad "bad.g2:3"
curve $'3 1\n4 4\n0 0 0 0 1 1 1 1\n0 0 0' >bad.g2
bad "bad.g2:2"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4' >bad.g2
bad "bad.g2:9"
printf '\0\0\0\377\376' >bad.g2
bad "bad.g2:1"
printf '200 1 0 0\n' >bad.g2
bad "200"
run 2 verify missing.g2 "$L" && says err "missing.g2"
run 2 verify "$L" "$S" && says err "dimension"
run 2 blend "$L" "$S" -o no.g2 && says err "dimension_mismatch"
run 2 blend "$L" "$R" --beta 0 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --eta -1 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --beta two -o no.g2 && says err "--beta"
run 2 blend "$L" "$R" --strategy free -o no.g2 && run 2 blend "$L" "$R" --strategy best -o no.g2 && says err "energy3"
run 2 blend "$L" "$R" --order 4 -o no.g2 && run 2 blend "$L" "$R" --kernel quad -o no.g2
curve $'3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 1 1\n1 1 1' >cusp.g2
run 2 blend cusp.g2 "$R" -o no.g2 && says err "zero_tangent: blend: end of the first curve"
run 2 blend "$L" "$R" -o missing/no.g2 && says err "missing/no.g2"
echo old >old.g2
run 2 blend cusp.g2 "$R" -o old.g2
holds [ "$(cat old.g2)" = old ]
holds [ ! -e no.g2 ]

echo "$checks checks, $failures failures"
[ $failures -eq 0 ]
