#!/usr/bin/env bash
# verify of drawings: what is a corner, a kink or smooth, by how much handles are off, and
# --kink-angle.
. "$(dirname "$0")/functions.sh"

leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
run 0 verify "$leaf" && says out "(28.5, 6.25): G0, corner of 93.1 degrees" \
  "(28.5, 15.05): G0, kink of 3.356 degrees, a handle is off by 0.1054 (0.1109 units of the last decimal)" \
  "drawn as 2 corners, 1 kink of at most 5 degrees, 12 G1, 13 G2 or more"
run 0 verify "$leaf" --summary && says out "drawn as 2 corners, 1 kink of at most 5 degrees, 12 G1, 13 G2 or more"
run 0 verify "$leaf" --kink-angle 3.3 && says out "3 corners, 0 kinks of at most 3.3 degrees"
run 0 verify "$leaf" --kink-angle 80 && says out "1 corner, 2 kinks of at most 80 degrees" "kink of 73.5 degrees"
run 0 verify "$badge" && says out "drawn as 14 corners, 0 kinks of at most 5 degrees, 11 G1, 6 G2 or more"

# corners are meant, and what is the default may be given
svg '<path d="M0 0h10v10h-10z"/>'
run 0 verify drawing.svg --require G1 && says out "every join but the corners is G1, proved exactly"
run 1 verify drawing.svg --require C1 && says out "4 of them not C1" && run 1 verify drawing.svg --require F1 && run 0 verify drawing.svg --require G0
for file in drawing.svg "$leaf" "$badge"; do
  for order in G0 G1 G2 C1; do
    "$program" verify "$file" --require $order >given 2>&1
    given=$?
    for default in "--kink-angle 5" "--kink-angle 5.0" "--max-order 3" "--format text"; do
      # shellcheck disable=SC2086
      run $given verify "$file" --require $order $default && cat err >>out
      [ "$default" = "--kink-angle 5.0" ] && sed -i 's/5\.0 degrees/5 degrees/' out
      holds cmp -s given out
    done
  done
done
run 0 verify drawing.svg --require G2 --kink-angle 5 && run 1 verify drawing.svg --require G1 --kink-angle 90
run 1 verify "$leaf" --require G1 --kink-angle 5 && says out "1 of them not G1"
run 0 verify "$leaf" --require G1 --kink-angle 1
run 1 verify "$leaf" --require G2 --kink-angle 1 && says out "12 of them not G2"
run 0 verify "$badge" --require G1 --kink-angle 5

# angles: at the bound, and beyond the digits of floating-point numbers
angle() { # angle Y X DEGREES GRADE: between a line and one to (X, Y)
  svg "<path d=\"M-9 0H0L$2 $1\"/>"
  run 0 verify drawing.svg --kink-angle "$3" && says out "G0, $4 of "
}
angle 1 1 45 kink && angle 1 1 44.99999999999999999999 corner && angle 1.00000000000000000001 1 45 corner
angle 1 0 90 kink && angle 1 -1e-200 90 corner && angle 1 1e-200 89.99999999 corner
angle 1 -1 135 kink && angle 1 -1.0000000000000000000001 135 corner
tangent=.0874886635259240052220186694349614581194542763681082 # of 5 degrees
angle $tangent 1 5 kink && angle ${tangent}9 1 5 corner && says out "corner of 5 degrees"
angle -$tangent 1 5 kink && angle -${tangent}9 1 5 corner && angle .1 1 57/10 corner
svg '<path d="M0 0h1h-2"/>' && run 0 verify drawing.svg && says out "G0, corner of 180 degrees" "drawn as 1 corner, 0 kinks"
run 0 verify drawing.svg --require G1 --kink-angle 179

# how far a handle is off: in the drawing and in units of the last decimal that is written
svg '<path d="M0 0h30l40 .1"/>' && run 0 verify drawing.svg && says out "a handle is off by 0.075 (0.75 units of the last decimal)"
svg '<path d="M0 0h40l40 .03"/>' && run 0 verify drawing.svg && says out "a handle is off by 0.03 (3 units of the last decimal)"
for end in "4e1 3e-2" "4E+1.3e-1" "40.0 .03" "40,300e-4"; do
  svg "<path d=\"M0 0h40l$end\"/>" && run 0 verify drawing.svg && says out "a handle is off by 0.03 (3"
done
says out "(300 units of the last decimal)"
svg '<polyline points="0 0 40 0 80 .03"/>' && run 0 verify drawing.svg && says out "a handle is off by 0.03 (3 units"
svg '<path d="M0 0h40l40 3e-30"/>' && run 0 verify drawing.svg && says out "a handle is off by 3e-30" && holds [ "$(grep -c decimal out)" = 0 ]
svg '<g transform="scale(4)"><path transform="rotate(17) translate(.123456789)" d="M0 0h40l40 .03"/></g>'
run 0 verify drawing.svg && says out "a handle is off by 0.12 (3 units of the last decimal)" "kink of 0.04297 degrees"
svg '<path d="M0 0h4000c10 1 20 8 30 8" transform="scale(2 1)"/>'
run 0 verify drawing.svg && says out "kink of 2.862 degrees, a handle is off by 1 (1 unit of the last decimal)"
svg '<path d="M0 0C0 0 10 3 20 2c10-1 10-1 20 0"/>' && run 0 verify drawing.svg && says out "G1, curvature jumps"

# handles at the node, lines as cubics, segments of no length
svg '<path d="M0 0H9c0 0 5 0 9 9"/>' && run 0 verify drawing.svg --require G1
says out "a handle is at the node, drawn as G1" "drawn as 0 corners, 0 kinks of at most 5 degrees, 1 G1, 0 G2 or more"
run 0 verify drawing.svg --require G1 --kink-angle 5 && run 1 verify drawing.svg --require G2 --kink-angle 5
svg '<path d="M0 0H9c0 0 5 5 9 9"/>' && run 0 verify drawing.svg && says out "G0, corner of 45 degrees" # read as a line
svg '<path d="M0 0H9c0 0 50 1 90 90"/>' && run 0 verify drawing.svg && says out "a handle is at the node, drawn as kink of 1.146 degrees"
run 1 verify drawing.svg --require G1 --kink-angle 5 && run 0 verify drawing.svg --require G1 --kink-angle 1
svg '<path d="M0 0H9h0v1"/>' && run 0 verify drawing.svg && says out "1 join " "commands 2 H - 4 v at (9, 0): G0, corner of 90 degrees" "1 segment without length left out"
svg '<path d="M0 0C0 30 20 50 50 50l0 0C80 50 100 30 100 0"/>' && run 0 verify drawing.svg --require G2
says out "commands 2 C - 4 C at (50, 50): G2, smooth" && run 0 repair drawing.svg -o repaired.svg && holds cmp -s drawing.svg repaired.svg
says out "before: 0 corners, 0 kinks, 0 G1, 1 G2" "after:  0 corners, 0 kinks, 0 G1, 1 G2"
svg '<path d="M0 0C0 30 20 50 50 50l0 0C80 51 100 30 100 0"/>' && run 1 verify drawing.svg --require G1
run 0 repair drawing.svg -o repaired.svg && says out "1 kink" "0 kinks" && run 0 verify repaired.svg --require G1
svg '<path d="M0 0h0v0c0 0 0 0 0 0"/>' && run 2 verify drawing.svg && says out "3 segments without length left out"

# arcs, with square roots
svg '<path d="M0 0A5 5 0 0 1 1 0L9 9"/>' && run 0 verify drawing.svg && says out "corner of 42.63 degrees"
svg '<path d="M0 0a1 1 0 0 1 1 1a1 1 0 0 1 -1 1"/>' && run 0 verify drawing.svg && says out "G3 or more" "1 G2 or more"
svg '<path d="M0 0a5 5 0 0 1 2 1a7 7 0 0 0 2 1"/>' && run 0 verify drawing.svg && says out "G0, kink of 3.73 degrees" "1 kink of"
holds [ "$(grep -c handle out)" = 0 ]
run 0 verify drawing.svg --kink-angle 3.7304 && says out "kink of 3.73" && run 0 verify drawing.svg --kink-angle 3.7303 && says out "corner of 3.73"
# a sixth of a circle and its chord: 30 degrees exactly
svg '<path d="M1 0H0A1 1 0 0 1 1 0"/>' && run 0 verify drawing.svg --kink-angle 150 && says out "kink of 150 degrees"
run 0 verify drawing.svg --kink-angle 149.9999999999999999999999 && says out "corner of 150 degrees"
svg '<path d="M0 0H1A1 1 0 0 1 2 0"/>' && run 0 verify drawing.svg --kink-angle 30 && says out "kink of 30 degrees"
run 0 verify drawing.svg --kink-angle 29.9999999999999999999999 && says out "corner of 30 degrees"

# JSON
if command -v python3 >/dev/null; then
  svg '<path d="M0 0h30l40 .1v9"/><path d="M0 0A5 4 1e-350 0 1 10 0v9v9c0 1 1 2 9 2"/>' && run 1 verify drawing.svg --json
  holds python3 -c "
import json, math
d = json.load(open('out'))
j, s = d['joins'], d['summary']
assert [x['grade'] for x in j] == ['kink', 'corner', None, 'G2', 'G1'], j
low, high = j[0]['angle_degrees']
assert low <= math.degrees(math.atan2(.1, 40)) <= high and high - low < 1e-14
low, high = j[0]['handle_offset']
assert .075 - 1e-6 < low <= high < .075
assert j[2]['angle_degrees'][0] == 0 < j[2]['angle_degrees'][1] < 1e-150 and j[3]['angle_degrees'] == [0, 0] and 'handle_offset' not in j[1]
assert [x['g_order'] for x in j] == [0, 0, None, 3, 1] and s['corners'] == s['kinks'] == 1, s"
fi

refused() { run 2 verify "$leaf" "${@:2}" && says err "$1" && holds [ ! -s out ]; } # refused REASON OPTIONS...
for bad in 0 180 -1 1e9; do refused "--kink-angle: $bad is not between 0 and 180 degrees" --kink-angle=$bad; done
for bad in x 5deg nan; do refused "--kink-angle: " --kink-angle="$bad"; done
run 2 verify "$teapot" --surfaces --kink-angle 5 && says err "--kink-angle: not with --surfaces"

# Chains: the same angle tells a kink from a corner, with the same grades as repair and report; each
# join is asked for.
{ curve $'2 0\n2 2\n0 0 1 1\n0 0\n1 0' && curve $'2 0\n2 2\n0 0 1 1\n1 0\n2 0.08' && curve $'2 0\n2 2\n0 0 1 1\n2 0.08\n2 1'; } >chain.g2
run 0 verify chain.g2 && says out "kink of 4.574 degrees" "corner of 85.43 degrees" && mv out usual
run 0 verify chain.g2 --kink-angle 5 && holds cmp -s out usual
run 0 verify chain.g2 --kink-angle 4.57 && says out "corner of 4.574 degrees" "corner of 85.43 degrees"
run 0 verify chain.g2 --kink-angle 90 && says out "kink of 4.574 degrees" "kink of 85.43 degrees"
for angle in 4 5 90; do run 1 verify chain.g2 --kink-angle $angle --require G1 && says out "2 of them not G1"; done
run 1 verify chain.g2 --require G1 --format sarif && says out '"ruleId":"kink"' '"ruleId":"corner"'
curve $'3 0\n2 2\n0 0 1 1\n0 0 0\n1 1 1' >space.g2
for end in "2 2 2.25 kink" "2 2 2.5 corner"; do # angles of 5.768 and 11.42 degrees in space
  read -r x y z name <<<"$end"
  { cat space.g2 && curve $'3 0\n2 2\n0 0 1 1\n1 1 1\n'"$x $y $z"; } >two.g2
  run 0 verify two.g2 --kink-angle 9 && says out "$name of "
done
