#!/usr/bin/env bash
# verify in the units of designers: gaps in units of the coordinates, angles in degrees, curvature
# in percent; tolerances in them, presets.
. "$(dirname "$0")/functions.sh"

# a kink of arctan(1/8), one of exactly 45 degrees, circles whose curvatures are 1 and 1/2 where
# they touch, a gap of 1/2
cubic $'0 0 0\n8 0 0\n16 0 0\n24 0 0' >line.g2
cubic $'24 0 0\n32 1 0\n40 2 0\n48 3 0' >kink.g2
cubic $'24 0 0\n25 1 0\n26 2 0\n27 3 0' >diagonal.g2
parabola() { curve "2 0"$'\n3 3\n0 0 0 1 1 1\n'"$1"; }
parabola $'-1 1\n-1/2 0\n0 0' >bent.g2 && parabola $'0 0\n1 0\n2 2' >flatter.g2
cubic $'24 0 1/2\n25 0 1/2\n26 0 1/2\n27 0 1/2' >away.g2

orders() { # orders VERDICTS ARGUMENTS...: the line of the tolerance begins with these verdicts
  local verdicts=$1
  shift
  run 0 verify "$@" --allow-undecided && says out "within the tolerance: order $verdicts; gap"
}
orders "0 proved, 1 proved" line.g2 kink.g2 --within 0,7.1251deg && says out "gap 0, tangent angle [7.12501, 7.12502] degrees, curvature jump 0%"
orders "0 proved, 1 refuted" line.g2 kink.g2 --within 0,7.125deg
orders "0 proved, 1 proved" line.g2 kink.g2 --within 0,0.12436rad
orders "0 proved, 1 refuted" line.g2 kink.g2 --within 0,0.12435rad
run 0 verify line.g2 kink.g2 --require G1 --within 0,7.1251deg && says out "every join is G1 within the tolerance"
run 1 verify line.g2 kink.g2 --require G1 --within 0,7.125deg
# a bound that is exactly the angle is never taken for smaller or larger
orders "0 proved, 1 undecided" line.g2 diagonal.g2 --within 0,45deg && says out "undecided: 1 join"
orders "0 proved, 1 proved" line.g2 diagonal.g2 --within 0,45.00000000000001deg
orders "0 proved, 1 refuted" line.g2 diagonal.g2 --within 0,44.99999999999999deg
run 1 verify line.g2 diagonal.g2 --within 0,45deg && run 0 verify line.g2 diagonal.g2 --within 0,45deg --allow-undecided
orders "0 proved, 1 proved, 2 proved" bent.g2 flatter.g2 --within 0,0deg,50% && says out "curvature jump 50%"
orders "0 proved, 1 proved, 2 refuted" bent.g2 flatter.g2 --within 0,0deg,49.99999999999999%
orders "0 proved, 1 proved, 2 refuted" bent.g2 flatter.g2 --within 0,0rad,1/3%
orders "0 proved, 1 proved" line.g2 away.g2 --within 0.5,0deg && orders "0 refuted, 1 refuted" line.g2 away.g2 --within 0.4999,0deg
orders "0 proved, 1 proved, 2 proved, 3 proved" "$L" "$L" --within 100,180deg,200%,1e9
# orders that were not asked for are not undecided
run 0 verify line.g2 kink.g2 --within 0,10deg,2% && run 1 verify line.g2 kink.g2 --within 1,1,1
# numbers without units are what they were
run 1 verify line.g2 kink.g2 --within 0.12436,0,0 && says out "order 0 proved, 1 proved, 2 proved, 3 undecided"

# presets stand for what the help says
while read -r name bounds; do
  run 0 verify line.g2 kink.g2 --within "$name" && mv out preset && run 0 verify line.g2 kink.g2 --within "$bounds" && holds cmp out preset
  run 0 verify --surfaces "$teapot" --within "$name" --allow-uncovered && run 0 verify --help && holds grep -q "$name" out && holds grep -q "$bounds" out
done <<'PRESETS'
class-a 0.01,0.1deg
class-b 0.02,0.2deg
class-c 0.05,0.5deg
vda-4955 0.02,0.1deg
mil-std-31000a 0.01,2deg
PRESETS

# surfaces: a crease of arctan(1/3) at one end
flat "$flat_points" >low.g2
flat $'1 1 2 2\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 1/3' >high.g2
run 0 verify --surfaces low.g2 high.g2 --require G1 --within 0,18.435deg && says out "angle <= 18.435 degrees" "normal angle [18.4349, 18.435] degrees"
run 1 verify --surfaces low.g2 high.g2 --require G1 --within 0,18.434deg

# refused TEXT ARGUMENTS...: exit code 2, and the error says that
refused() { run 2 verify "${@:2}" && says err "$1" && holds [ ! -s out ]; }
refused "item 2, '0.01': an angle with its unit, deg or rad, is expected" line.g2 kink.g2 --within 0.1,0.01,2%
refused "item 3, '2': a jump of the curvature in % is expected" line.g2 kink.g2 --within 0.1,0.01deg,2
refused "item 3, '2deg': a jump of the curvature in % is expected" line.g2 kink.g2 --within 0.1,0.01deg,2deg
refused "item 1, '1deg': a gap, which is in the units of the coordinates, has no unit" line.g2 kink.g2 --within 1deg,1
refused "item 1, '1mm': " line.g2 kink.g2 --within 1mm,1deg
refused "item 2, '-1deg': a tolerance is negative" line.g2 kink.g2 --within 0,-1deg
refused "item 2, 'x1deg': " line.g2 kink.g2 --within 0,x1deg
refused "item 1, '': " line.g2 kink.g2 --within ,1deg
refused "item 4, '1%': a torsion, which is in 1/length, has no unit" line.g2 kink.g2 --within 0,1deg,1%,1%
refused "item 5, '1': at most 4 bounds" line.g2 kink.g2 --within 0,1deg,1%,1,1
refused "'class-d' is neither a number nor one of class-a, class-b" line.g2 kink.g2 --within class-d
refused "item 3, '2%': along an edge the gap and the angle have a tolerance" --surfaces low.g2 --within 0,1deg,2%
refused "a tolerance is negative" line.g2 kink.g2 --within -1,0,0

# JSON: degrees and percent enclose the radians and ratios beside them, and are narrow
if command -v python3 >/dev/null; then
  cat >units.py <<'PYTHON'
import json, sys
from fractions import Fraction
pi = Fraction(314159265358979323846264338327950288419716939937510, 10**50)
report = json.load(open(sys.argv[1]))
checks = 0
def encloses(outer, inner, factor):
    global checks
    if inner is None:
        assert outer is None
        return
    for x in map(Fraction, inner):
        assert Fraction(outer[0]) <= x * factor * (1 + Fraction(1, 10**15)) and x * factor * (1 - Fraction(1, 10**15)) <= Fraction(outer[1])
    low, high = Fraction(inner[0]) * factor, Fraction(inner[1]) * factor
    assert Fraction(outer[0]) <= low and (high <= Fraction(outer[1]) or outer[1] == 180)
    assert high - low + abs(high) * Fraction(1, 10**15) >= Fraction(outer[1]) - Fraction(outer[0])
    checks += 1
for x in report.get("joins", []) + report.get("edges", []) + report.get("knot_lines", []):
    encloses(x["angle_degrees"], x.get("tangent_angle", x.get("normal_angle")), 180 / pi)
    if "curvature_jump" in x:
        encloses(x["curvature_percent"], x["curvature_jump"], 100)
    if "angle_at_most" in x:
        bound = Fraction(x["angle_at_most"]) * 180 / pi
        assert bound <= Fraction(x["angle_at_most_degrees"]) or x["angle_at_most_degrees"] == 180
        checks += 1
print(checks, "enclosures")
sys.exit(checks == 0)
PYTHON
  for files in "--closed $S" "line.g2 kink.g2" "line.g2 diagonal.g2" "--surfaces low.g2 high.g2" "--surfaces $teapot"; do
    run 0 verify $files --within 0.01,0.1deg --allow-uncovered --json && holds python3 units.py out
  done
fi
