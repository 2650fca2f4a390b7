#!/usr/bin/env bash
# Surfaces that reach the axis about which they are rotated: what lies within the tolerance of gaps
# around a pole belongs to the pole, and nothing else does.
models=$(cd "$(dirname "$0")/cad/data" && pwd)
. "$(dirname "$0")/functions.sh"
made_by MAKE_CAD_POLES made

# Arcs, ellipses, splines and Bézier curves that are rotated, wholly or in part, tori that touch or
# cross themselves, rounded boxes: all edges are smooth, or corners of solids.
for file in made/poles_*; do
  run 0 verify "$file" --require G1
  says out ", 0 gaps, 0 undecided; " ", 0 fading corners, 0 kinks" "every edge of two sides and every knot line is G1 within the tolerance or a corner, proved"
  case $file in
  *thirds*) says out "3 inner" "3 G1" ;;
  *rounded_box*) says out "48 inner" "48 G1" ;;
  *solid_bezier*) says out " 1 corner, 0 fading" ;;
  *solid_*) says out "6 inner" "6 corners, 0 fading" ;;
  esac
done
run 0 verify made/poles_thirds_of_spline.step made/poles_whole_spindle.igs --require G2 --within 0.02,0.1deg,5%
says out "every edge of two sides and every knot line is G2 within the tolerance or a corner, proved"
for file in tip.brep lens.igs nurbs_sphere.step whole_spindle.step; do # at others the normal is proved to vanish in a point, which is as good
  run 0 verify "made/poles_$file" && says out "; what belongs to a pole within the tolerance is left out near t = "
done
run 0 verify made/poles_tip.brep --json && says out '"poles":[[' '"undecided":0'
run 0 report made/poles_tip.brep -o page.html && says page.html "what belongs to a pole is left out near the parameter"
run 0 verify made/poles_arc.step --json && lacks out '"poles"'

# The part that is left out is no longer than the tolerance; the profile of the tip has about the
# same speed there.
range() { # GAP FILE: the length of the parameters that are left out
  run 0 verify "$2" --json --within "$1,0.1deg"
  sed -n 's/.*"poles":\[\[\([^],]*\),\([^]]*\)\].*/\1 \2/p' out | awk '{ print $2 - $1 }'
}
wide=$(range 0.02 made/poles_tip.brep) narrow=$(range 0.002 made/poles_tip.brep)
holds awk -v wide="$wide" -v narrow="$narrow" 'BEGIN { exit !(narrow > 0 && 9 * narrow < wide && wide < 11 * narrow) }'

# Without curves in parameter planes: the longitude of a pole does not matter, and that of a
# projection leads to it.
for file in made/poles_octant.step made/poles_moved_octant.step; do
  run 0 verify "$file" --json
  holds awk '/"projected":true/ {
    ++n
    if (!match($0, /"gap":\[[^]]*/)) exit 1
    split(substr($0, RSTART + 7, RLENGTH - 7), ends, ",")
    if (!(ends[2] < 1e-8)) bad = 1
  } END { exit !(n > 0 && !bad) }' out
done

# A kink along the ruling in which two cones meet, up to their common apex.
run 1 verify made/kinks_cones.step --require G1 && says out "inner: G0, kink" "angle [3, 3.0" "0 undecided"
# A kink that begins where the tolerance ends, one within it, and an angle that fades towards the
# pole.
inner() { grep '^edge.* inner: ' out; }
run 1 verify made/kinks_beside.brep --require G1 && holds [ "$(inner | grep -c 'inner: G0, kink.* angle \[1.99')" -eq 1 ]
run 1 verify made/kinks_fading.brep --require G1 && holds [ "$(inner | grep -c 'inner: G0, fading corner')" -eq 1 ]
run 1 verify made/kinks_within.brep --require G1 # of its knot lines
holds [ "$(inner | grep -c 'inner: G1.*belongs to a pole')" -eq 1 ]
run 1 verify made/kinks_within.brep --require G1 --within 0.001,0.1deg
holds [ "$(inner | grep -c 'inner: G0, kink.* angle \[1.99')" -eq 1 ]

# An edge that is a point itself: in the apex of a double cone nothing is proved, and nothing is
# left out.
run 1 verify made/kinks_hourglass.brep --require G1
says out "knot line: G0" "no normal" "undecided: 1 edge, " && lacks out "belongs to a pole"

# A side of a patch that nearly is a point is none, whatever the tolerance: next to it the normal
# turns.
for x in 8.9999999999999999e-10 8.9999999999999999e-11; do
  sed "s/@P@/$x 0 $x/g; s/@Q@/9.0000000009000001 10 $x/g" "$models/two_patches.brep" >nearly.brep
  run 1 verify nearly.brep --require G1 && says out "G0, fading corner" && lacks out "belongs to a pole"
  run 1 verify nearly.brep --require G1 --within 1,0.1deg && says out "G0, fading corner" && lacks out "belongs to a pole"
done
# Nor does a corner all along belong to the point in which it ends.
sed "s/@P@/0 0 0/g; s/@Q@/8 10 4/g" "$models/two_patches.brep" >wing.brep
run 0 verify wing.brep --require G1 && says out "G0, corner"
sed "s/@P@/0 0 0/g; s/@Q@/8 10 .4/g" "$models/two_patches.brep" >bent.brep
run 1 verify bent.brep --require G1 && says out "G0, kink" "angle [2.86"
