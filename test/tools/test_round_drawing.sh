#!/usr/bin/env bash
# blend --corners of drawings: what is rounded, what stays byte for byte, and what is left.
. "$(dirname "$0")/functions.sh"

cat >shapes.svg <<'SVG'
<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:s="http://www.w3.org/2000/svg" viewBox="0 0 200 200">
  <!-- a comment -->
  <rect x="10" y='10' width="50" height="30" class="r" fill="none"/>
  <polygon points="80,10 130,10 105,55.5" id="tri"><title>T</title></polygon>
  <polyline points="10 100 30 60 50 100 70,60" fill="none"  stroke="red" />
  <path id="p" d="m 100,100 h 40 v 40 q -20 20 -40 0 z M 10 150 C 20 120 40 120 50 150 L 10 150 Z"/>
  <circle cx="150" cy="150" r="20"/><s:polygon points="150 60 190 60 170 90"/>
  <g transform="scale(2)"><polygon points="60,80 90,80 90,95"/></g>
</svg>
SVG
run 0 blend shapes.svg --corners all --distance 5 -o round.svg
says out "21 corners of 6 elements are rounded: 17 with exactly continuous curvature, 4 with tangents that are so exactly"
run 0 verify round.svg --require G1 && says out "0 corners, 0 kinks" "8 G1, 38 G2, 4 G3 or more"
# the cuts are where they are asked for, with both handles in the corner; other attributes stay
says round.svg '<path d="M 15 10L 55 10C 60 10 60 10 60 15L 60 35C 60 40 60 40 55 40L 15 40C 10 40 10 40 10 35L 10 15C 10 10 10 10 15 10Z" class="r" fill="none"/>' \
  'id="tri"><title>T</title></path>' '<s:path d="M 155 60L' 'fill="none"  stroke="red" />' '<!-- a comment -->'
for line in 1 2 3 10; do holds [ "$(sed -n ${line}p shapes.svg)" = "$(sed -n ${line}p round.svg)" ]; done
# in the units of the drawing: the group is scaled
says round.svg "M 62.5 80L 87.5 80C 90 80 90 80 90 82.5L 90 92.5"
# nothing to round: the same bytes
svg '<path d="M0 0 C 1 1 2 1 3 0"/><circle r="3"/><rect width="5" height="4" rx="1"/>' && cp drawing.svg same.svg
run 0 blend same.svg --corners all --distance 1 -o out.svg && says out "0 corners" && cmp -s same.svg out.svg || holds false
# small angles are kinks, which are not rounded; short sides are cut by 3/8
svg '<path d="M0 0 L10 0 L20 0.5"/><polygon points="0 0 1 0 1 1"/>'
run 0 blend drawing.svg --corners all --distance 5 -o out.svg && says out "3 corners of 1 element are rounded: 3 with exactly" && says out.svg 'd="M0 0 L10 0 L20 0.5"' "M 0.375 0L 0.625 0"
run 0 blend drawing.svg --corners all --distance 5 --kink-angle 1 -o out.svg && says out "4 corners of 2 elements are rounded"
# what is left, with the reason
svg '<path id="a" d="M0 0 L10 0 A 5 5 0 0 1 10 20 L 0 20 z M 0 0 h9 a1.5,1 0 01 4 0 v5"/><path id="b" d="M0 0 L1 1 L x"/><polygon points="0 0 9 0 9 9"/>'
run 0 blend drawing.svg --corners all --distance 1 -o out.svg && says out "5 corners of 2 elements" 'path "a" (line 2): 1 corner at an arc' 'path "b" (line 2)'
says out.svg 'L 10 0A 5 5 0 0 1 10 20L' 'L 9 0A 1.5 1 0 0 1 13 0L 13 5'
# arcs of a radius: exact in right angles, in general up to the decimals, smaller on short sides
run 0 blend shapes.svg --corners all --radius 5 -o arcs.svg && says out "21 corners of 6 elements are rounded: 17 arcs, 0 with exactly continuous curvature, 4 with tangents"
says arcs.svg '<path d="M 15 10L 55 10A 5 5 0 0 1 60 15L 60 35A 5 5 0 0 1 55 40L 15 40A 5 5 0 0 1 10 35L 10 15A 5 5 0 0 1 15 10Z" class="r"' "A 2.5 2.5 0 0 1 90 82.5"
svg '<polygon points="0 0 30 0 30 20 0 20"/><polygon points="0 0 0 20 30 20 30 0"/>' && run 0 blend drawing.svg --corners all --radius 3 -o arcs.svg && run 0 verify arcs.svg --require G1 && says out "16 G1"
says arcs.svg "A 3 3 0 0 1 30 3" "A 3 3 0 0 0 3 20"
svg '<polygon points="0 0 31 2 17 29"/><polyline points="0 0 4 0 4 4" fill="none"/>' && run 0 blend drawing.svg --corners all --radius 5 -o arcs.svg && says out "4 corners of 2 elements are rounded: 4 arcs (1 of a smaller radius on short sides)"
says arcs.svg "M 0 0L 1 0A 3 3 0 0 1 4 3" && run 0 verify arcs.svg --json
python3 - out arcs.svg <<'PYTHON' || holds false
import json, sys
angles = [j["angle_degrees"][1] for j in json.load(open(sys.argv[1]))["joins"]]
assert len(angles) == 8 and all(a < 1e-6 for a in angles), angles
assert open(sys.argv[2]).read().count("A 5 5 0 0") == 3
PYTHON
# Inkscape draws the rounded rectangle, and the arcs, inside of the sides that they touch
if command -v inkscape >/dev/null; then
  svg '<rect id="r" x="10" y="20" width="50" height="30"/><polygon id="p" points="100 100 140 100 120 60"/>'
  run 0 blend drawing.svg --corners all --radius 5 -o arcs.svg && run 0 blend drawing.svg --corners all --distance 5 -o cubics.svg
  for name in arcs cubics; do
    inkscape --query-all $name.svg >boxes 2>inkscape.log
    holds grep -qE '^r,10,20,50,30$' boxes
    # of the triangle 40 x 40 the top is cut off, by sqrt(5) - 1 radii for the arc
    [ $name = cubics ] || holds awk -F, '$1 == "p" { h = 40 - 5 * (sqrt(5) - 1); if ($5 > h - 0.01 && $5 < h + 0.01) ok = 1 } END { exit !ok }' boxes
  done
fi
# with --cubic at the same distances
run 0 blend shapes.svg --corners all --radius 5 --cubic -o cubics.svg && says out "17 with exactly continuous curvature, 4 with" && run 0 verify cubics.svg --require G1
says cubics.svg 'M 15 10L 55 10C 60 10 60 10 60 15L' && lacks cubics.svg "A 5 5"
# what is refused
run 2 blend shapes.svg --distance 5 -o out.svg && says err "--corners all is needed"
run 2 blend shapes.svg --corners not-g1 --distance 5 -o out.svg && says err "all corners of a drawing are rounded"
run 2 blend shapes.svg --corners all -o out.svg && says err "--distance is needed"
run 2 blend shapes.svg --corners all --radius 0 -o out.svg && says err "--radius: 0 is not positive"
run 2 blend shapes.svg --corners all --radius 1 --distance 1 -o out.svg && says err "one of them"
run 2 blend shapes.svg --corners all --distance 1 --cubic -o out.svg && says err "--radius asks for arcs"
run 2 blend shapes.svg --corners all --distance 0 -o out.svg && says err "--distance: 0 is not positive"
run 2 blend shapes.svg --corners all --distance 1 && says err "-o OUT.svg is needed"
run 2 blend shapes.svg --corners all --distance 1 -o out.g2 && says err "the format is .svg"
run 2 blend shapes.svg --corners all --distance 1 --strategy fair -o out.svg && says err "not for drawings"
run 2 blend "$S" --corners all --distance 1 --kink-angle 3 -o out.g2 && says err "only for drawings"
