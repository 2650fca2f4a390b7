#!/usr/bin/env bash
# CAD models: what is read of STEP, IGES and BREP, the kinds of edges, the verdicts, reports, and
# damaged files.
. "$(dirname "$0")/functions.sh"

# Without the module the program says what is missing, and how to get it; it finds the module next
# to itself.
printf 'ISO-10303-21;\n' >any.step
cp "$program" alone
"$PWD/alone" verify any.step >out 2>err
holds [ $? -eq 2 ] && says err "any.step: STEP, IGES and BREP are read and written by an optional part of this program" "geometric-continuity-cad" "libocct-data-exchange-dev"
made_by MAKE_CAD_MODELS models
holds "$CHECK_CAD_CONVERSION" models/*

# kinds COUNTS FILE...: the kinds of edges of each file
kinds() {
  local counts=$1 file
  shift
  for file in "$@"; do run 0 verify "models/$file" --allow-empty --allow-uncovered && says out "$counts"; done
}
kinds "7 faces; edges: 15 inner, 0 seams, 0 boundary, 0 degenerate, 0 non-manifold" fillet.brep fillet.step fillet.igs
kinds "14 faces; edges: 30 inner, 0 seams, 0 boundary, 0 degenerate, 0 non-manifold" moved.brep
kinds "3 faces; edges: 2 inner, 1 seam, 0 boundary, 0 degenerate, 0 non-manifold" cylinder.brep cylinder.step prism.brep prism.step
kinds "2 faces; edges: 1 inner, 1 seam, 0 boundary, 1 degenerate, 0 non-manifold" sphere.brep cone.brep
kinds "2 faces; edges: 1 inner, 1 seam, 0 boundary, 0 degenerate, 0 non-manifold" sphere.step cone.step
kinds "1 face; edges: 0 inner, 2 seams, 0 boundary, 0 degenerate, 0 non-manifold" torus.brep torus.step periodic.brep revolution.brep offset.brep
kinds "3 faces; edges: 2 inner, 0 seams, 8 boundary, 0 degenerate, 0 non-manifold" wall.brep
kinds "3 faces; edges: 0 inner, 0 seams, 9 boundary, 0 degenerate, 1 non-manifold" three.brep
kinds "1 face; edges: 0 inner, 0 seams, 4 boundary, 0 degenerate, 0 non-manifold" bezier.brep
is_narrow 0 verify models/moved.brep --allow-empty --allow-uncovered
run 2 verify models/bezier.brep --require G1 && says err "there is no edge of two sides"

# known gaps, angles and curvatures: enclosures of the numbers in the files, which are rounded, lie
# at the known ones
encloses() { # NAME NUMBER LINE: NAME is gap, angle or jump, in the line of an edge
  checks=$((checks + 1))
  awk -v line="$3" -v name="$1" -v x="$2" 'BEGIN {
    if (!match(line, name " [^a-z%]*")) exit 1
    n = split(substr(line, RSTART + length(name) + 1, RLENGTH), ends, /[^-+.0-9e]+/)
    lower = ends[1] == "" ? ends[2] : ends[1]
    upper = ends[1] == "" ? ends[3] : ends[1]
    exit !(n > 1 && lower - 1e-9 <= x && x <= upper + 1e-9 && upper - lower <= 0.02 * upper + 0.02)
  }' && return
  failures=$((failures + 1))
  echo "$1 is not $2: $3"
}
fillet_edges() { grep -E '\((plane [0-9]+ - cylinder|cylinder [0-9]+ - plane)' out; }
for file in fillet.brep fillet.step fillet.igs moved.brep; do
  run 0 verify models/$file --require G1 && says out "every edge of two sides and every knot line is G1 within the tolerance or a corner, proved"
  holds [ "$(fillet_edges | grep -c ': G1[,;]')" -eq "$(($(fillet_edges | wc -l) / 2))" ]
  while read -r line; do # from flat to the radius 2 the curvature jumps by all of it
    encloses gap 0 "$line" && encloses angle 0 "$line" && encloses jump 100 "$line"
  done < <(fillet_edges | grep ': G1[,;]')
  while read -r line; do encloses angle 90 "$line"; done < <(grep -E 'plane [0-9]+ - plane' out)
  run 1 verify models/$file --require G2 --within 0.01,0.1deg,99% && says out "not G2 within the tolerance"
  run 0 verify models/$file --require G2 --within 0.01,0.1deg,101%
done
for file in cylinder.brep cylinder.step; do
  run 0 verify models/$file && says out "2 corners, 0 fading corners, 0 kinks" "seam: G" "inner, closed: G0, corner"
  while read -r line; do encloses angle 90 "$line"; done < <(grep '^edge.* inner' out)
  while read -r line; do encloses angle 0 "$line" && encloses jump 0 "$line"; done < <(grep '^edge.* seam' out)
done
for file in sphere.brep sphere.step; do
  run 0 verify models/$file && encloses angle 60 "$(grep '^edge.* inner' out)" && encloses jump 100 "$(grep '^edge.* inner' out)"
done
for file in cone.brep cone.step; do
  run 0 verify models/$file && encloses angle 126.86989765 "$(grep '^edge.* inner' out)" && encloses angle 0 "$(grep '^edge.* seam' out)"
done
for file in torus.brep torus.step periodic.brep revolution.brep offset.brep prism.brep; do
  run 0 verify models/$file --require G1
  while read -r line; do encloses gap 0 "$line" && encloses angle 0 "$line"; done < <(grep '^edge.* seam' out)
done
# faces that share no edges, sewn: the same edges
for file in separated.brep separated.igs; do
  run 2 verify models/$file && says out "0 inner, 0 seams, 30 boundary" "30 boundary edges lie beside others and are not compared: --sew DISTANCE joins them"
  run 0 verify models/$file --sew 0.001 --require G1
  says out "7 faces; edges: 15 inner, 0 seams, 0 boundary" "15 edges sewn by OpenCASCADE" "and every knot line is G1 within the tolerance or a corner, proved"
  holds [ "$(fillet_edges | grep -c ': G1[,;]')" -eq 2 ]
  while read -r line; do
    encloses gap 0 "$line" && encloses angle 0 "$line" && encloses jump 100 "$line"
  done < <(fillet_edges | grep ': G1[,;]')
  run 0 verify models/$file --sew 0.001 --json && says out '"sewn":15'
done
run 0 verify models/fillet.step --sew 0.001 && says out "15 inner" && holds [ "$(grep -c sewn out)" -eq 0 ]
run 0 verify models/separated.brep --sew 1e-300 && says out "15 inner" # those that coincide
for distance in 0 -1 x 1e9; do run 2 verify models/fillet.step --sew=$distance && says err "--sew"; done
run 2 verify $S --sew 0.1 && says err "only for CAD models"
# the verdict with no tolerance stands beside it
run 0 verify models/fillet.brep --json && says out '"order":"G0","shape":"corner","within":["proved","refuted","refuted"],"exact":"G0"' '"exact":15'
says out '"order":"G1","shape":"smooth","within":["proved","proved","refuted"],"exact":"gap"'
# a kink of 1 degree is none that is meant, and one of 70 degrees is a corner
run 1 verify models/wall.brep --require G1 && says out "1 of them not G1 within the tolerance" "G0, kink" "G0, corner"
encloses angle 1 "$(grep kink out | head -n 1)"
run 0 verify models/wall.brep --require G1 --kink-angle 0.9 && says out "2 corners, 0 fading corners, 0 kinks"
# that of 45 degrees which fades away is none of both, and is not taken for one that is meant
run 1 verify models/fading.brep --require G1 && says out "G0, fading corner" "0 corners, 1 fading corner, 0 kinks"
encloses angle 45 "$(grep fading out | head -n 1)"
run 0 verify models/fading.brep --require G0 && run 0 verify models/fading.brep --require G1 --kink-angle 46 --within 0.01,45.1deg
run 0 verify models/fading.brep --json && says out '"shape":"fading corner"' '"corners":0,"fading_corners":1'
# one count of what is undecided
undecided() { # ARGUMENTS...: the summary counts as many undecided edges as the classes have, and all edges are in one class
  run "$@" && holds [ "$(sed -n 's/.* \([0-9]*\) undecided.*/\1/p' out)" -eq "$(sed -n 's/^undecided: \([0-9]*\) .*/\1/p' out | awk '{ n += $1 } END { print n + 0 }')" ]
  holds [ "$(grep '^within' out | sed 's/.*: \([^;]*\);.*/\1/' | grep -oE '[0-9]+ (G|gap|und|not)' | awk '{ n += $1 } END { print n }')" -eq \
    "$(grep -E '; edges: ' out | grep -oE '[0-9]+ (inner|seam|knot)' | awk '{ n += $1 } END { print n }')" ]
}
undecided 1 verify models/wall.brep --within 0.02,1deg && says out ' 1 G0, 0 gaps, 1 undecided;'
undecided 1 verify models/fillet.brep --within 0.02,90deg --require G1 && says out ' 13 undecided;'
undecided 1 verify models/torus.brep --max-work 1
undecided 1 verify models/differing.brep && says out '0 undecided, 1 not compared;'
undecided 0 verify models/fillet.brep

# findings of models are in the line of the entity, where the file has ids
sarif_lines() { # FILE PATTERN...: each line that SARIF names matches the pattern
  run 1 verify "$1" --require G1 --within 0.02,90deg --format sarif
  local n
  for n in $(grep -oE '"startLine":[0-9]+' out | grep -oE '[0-9]+' | sort -u); do sed -n "${n}p" "$1" | grep -qE "$2" || holds false; done
  holds [ "$(grep -c '"startLine"' out)" -eq "$3" ]
}
sarif_lines models/fillet.step '^#[0-9]+ = ADVANCED_FACE' 13
sarif_lines models/fillet.igs '^ *510 .*D0*[0-9]*[13579]$' 13
sarif_lines models/fillet.brep none 0
sed 's/^#\([0-9]*\) = ADVANCED_FACE(..,/\/* #\1=\n #\1 = *\/\n  #\1= ADVANCED_FACE('"'#\1 = '"',/' models/fillet.step >spread.step # not in comments and texts
sarif_lines spread.step '^  #[0-9]+= ADVANCED_FACE' 13
mkdir -p inner && (cd inner && "$program" verify ../models/fillet.brep --require G1 --within 0.02,90deg --format sarif >../out)
says out '"uri":"file:///' && lacks out SRCROOT && says out '/models/fillet.brep"}'
run 1 verify ./inner/../models/fillet.brep --require G1 --within 0.02,90deg --format sarif && says out '"uri":"models/fillet.brep","uriBaseId":"%SRCROOT%"}'

run 0 verify models/fading.brep --format sarif && says out '"ruleId":"corner"' '"level":"note"'
run 0 verify models/wall.brep --require G0 && run 0 verify models/wall.brep --require G1 --within 0.01,1.1deg
run 1 verify models/wall.brep --require G1 --summary && holds [ "$(grep -c '^edge' out)" -eq 1 ]
run 2 verify models/wall.brep --kink-angle 0 && says err "--kink-angle"

# reports for programs
run 1 verify models/wall.brep models/three.brep --require G1 --json
says out '{"edges":[' '"file":"models/wall.brep","edge":0,"faces":[' '"kind":"inner"' '"kind":"boundary"' '"kind":"non-manifold"' \
  '"order":null' '"order":"G0","shape":"kink","within":["proved","refuted","refuted"]' '"gap":[' '"angle_degrees":[' \
  '"curvature_percent":[' '"angle_at":{"parameter":' '"summary":{"faces":6,"inner":2,"seam":0,"boundary":17,"non_manifold":1' \
  '"length_unit":"mm"' '"tolerance":"vda-4955"' '"required":"G1","met":false'
run 1 verify models/differing.brep --format json && says out '"reason":"curves of different parameters","deviation":null,"gap":null,"angle_degrees":null'
run 1 verify models/wall.brep models/three.brep --require G1 --format sarif
says out '"ruleId":"kink"' '"level":"error"' 'non-manifold' '"not-verified"' && holds [ "$(grep -c '"level":"warning"' out)" -eq 0 ]
run 1 verify models/wall.brep models/three.brep --require G1 --format sarif --allow-uncovered && says out '"level":"warning"'
run 1 verify models/wall.brep --require G1 --format junit && says out '<failure' 'not G1 within the tolerance' 'models/wall.brep'
run 0 verify models/wall.brep --format sarif && says out '"level":"note"'

# lines inside of faces: of a crease only what lies in the face counts, and where G2 is asked for,
# lines where the curvature may jump
run 1 verify models/trimmed.brep --require G1
says out "2 knot lines inside of faces" "knot line: G0, kink; " "angle [31.25" && lacks out "angle [4"
run 2 verify models/bending.brep --require G1 && lacks out "knot line"
run 1 verify models/bending.brep --require G2 --within 0.02,0.1deg,5%
says out "1 knot line inside of faces" "knot line: G1; " "curvature jump [99.99" "1 of them not G2"

# what cannot be compared is named, is not covered, and meets nothing unless that is allowed
run 1 verify models/differing.brep && says out "not covered: 1 edge, curves of different parameters"
run 0 verify models/differing.brep --allow-uncovered && run 1 verify models/differing.brep --allow-undecided
run 1 verify models/differing.brep --require G0 && says out "not met, because not all was decided (see --allow-uncovered)"
holds [ "$(grep -c 'is G0' out)" -eq 0 ]
run 0 verify models/differing.brep --require G0 --allow-uncovered && says out "every edge of two sides and every knot line that was decided is G0 within the tolerance, proved"
run 2 verify models/three.brep && run 1 verify models/three.brep --allow-empty
says out "not covered: 1 edge, three faces or more share it" "not met, because not all was decided"
run 0 verify models/three.brep --allow-empty --allow-uncovered

# so is a face that could not be read: the others are decided, but not all is proved
sed 's/CYLINDRICAL_SURFACE(/CYLINDRIC_SURFACE(/' models/fillet.step >lost.step
run 1 verify lost.step --require G1 && says out "6 faces" "CYLINDRIC_SURFACE: of no known type" "ADVANCED_FACE: no shape has it" "not covered: 2 elements, it cannot be read" "not met, because"
holds [ "$(grep -c ', proved' out)" -eq 0 ]
run 1 verify lost.step --require G1 --json && says out '"met":false' '"not_covered":[{"what":"element"'
run 0 verify lost.step --require G1 --allow-uncovered && says out "that was decided is G1"

# options and names
cp models/fillet.step UPPER.STP
run 0 verify UPPER.STP && says out "7 faces"
run 2 verify models/fillet.step $S && says err "cannot be read together"
for option in --surfaces --closed --kernel=double --max-order=2 --max-work=x --worst=3; do
  run 2 verify models/fillet.step $option
done
run 2 verify models/fillet.step --require C1 && says err "of CAD models G0, G1 and G2 are decided" "models/fillet.step has faces"
run 2 verify models/fillet.step --require G3 && run 2 verify models/fillet.step --require F1
run 2 verify models/fillet.step --require G2 --within vda-4955 && says err "--require G2: needs more bounds than --within vda-4955"
run 1 verify models/fillet.step --require G2 && says out "within 0.02,0.1deg,5% (lengths in mm)"
run 2 verify models/fillet.step --require G1 --within 0.1
run 2 verify models/fillet.step --within 0.01,0.1deg,1%,0.1 && says err "GAP,ANGLEdeg,CURVATURE%"
run 2 verify models/fillet.step --within 0.01,0.1 && run 2 verify models/fillet.step --within class-x

# damaged files: an error with the reason
size=$(wc -c <models/fillet.step)
for part in 1 20 50 90 99; do
  head -c $((size * part / 100)) models/fillet.step >cut.step
  run 2 verify cut.step && says err "cut.step: not a complete STEP file" && holds [ ! -s out ]
done
size=$(wc -c <models/fillet.brep)
for part in 1 20 50 90; do
  head -c $((size * part / 100)) models/fillet.brep >cut.brep
  run 2 verify cut.brep && says err "cut.brep: "
done
size=$(wc -c <models/fillet.igs)
for part in 1 20; do
  head -c $((size * part / 100)) models/fillet.igs >cut.igs
  run 2 verify cut.igs && says err "cut.igs: "
done
awk 'BEGIN { srand(1); for (i = 0; i < 5000; ++i) printf "%c", 1 + int(255 * rand()) }' >junk
for extension in step stp iges igs brep brp; do
  cp junk "junk.$extension" && run 2 verify "junk.$extension" && says err "junk.$extension: "
  : >"empty.$extension" && run 2 verify "empty.$extension" && says err "empty.$extension: "
  run 2 verify "none.$extension" && says err "none.$extension: No such file"
done
# a library that crashes does not end the program by a signal: an extrusion of a curve of no kind
sed '/^Surfaces/{n;n;s/^7 /9 /}' models/prism.brep >crash.brep
run 2 verify crash.brep && says err "crash.brep: the library that reads it crashes: the file is damaged"
# huge numbers, and no numbers
sed 's/-4\.44089[0-9]*E-16/-4.4E716/' models/fillet.step >huge.step
sed 's/^1 0 /1 nan /' models/fillet.brep >odd.brep
for file in huge.step odd.brep; do
  "$program" verify $file --json --allow-uncovered >out 2>err
  holds [ $? -ne 1 ] && holds [ "$(grep -ciE '\bnan\b|-?inf\b' out)" -eq 0 ]
done
