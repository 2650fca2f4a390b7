#!/usr/bin/env bash
# Curves of CAD models without faces: which ends meet, the bounds at their joins, all formats,
# orders and reports; and wires that FreeCAD has made.
. "$(dirname "$0")/functions.sh"
made_by MAKE_CAD_MODELS models

# a slot: four joins of lines and arcs, whatever the order and the directions in the file
for file in slot.brep slot.step slot.igs slot_moved.brep; do
  run 0 verify models/$file --require G1
  says out "4 curves without a face; 4 joins, 0 free ends" "0 G2, 4 G1, 0 G0, 0 gaps" "every join of curves is G1 within the tolerance or a corner, proved"
  holds [ "$(grep -cE '^join of curve .*(line|circle).*: G1; gap .*, curvature jump (100|\[99.999[0-9]*, 100.0[0-9]*\]) %' out)" -eq 4 ]
  run 1 verify models/$file --require G2 --within 0.001,0.1deg,5% && says out "4 of them not G2 within the tolerance"
  run 0 verify models/$file --require G2 --within 0.001,0.1deg,101%
  run 1 verify models/$file --require C1 && says out "jumps of derivatives [79.99" "4 of them not C1 within the tolerance"
done
run 0 verify models/slot.step && says out "(circle; #" && run 0 verify models/slot_and_box.brep --require G1
says out "6 faces; edges: 12 inner" "4 curves without a face" "every edge of two sides and every knot line and every join of curves is G1"
run 2 verify models/slot_and_box.brep --require C1 && says err "C orders only of curves without faces"
run 2 verify models/slot.step --require C3 && run 2 verify models/slot.step --require F1 && says err "C0 to C2"
run 2 verify models/slot.step --require C2 --within vda-4955 && says err "needs more bounds than --within vda-4955 has; for C2"

# a kink, a corner, a gap, a free end, a place where three ends meet
run 1 verify models/kinked_wire.brep --require G1 && says out "3 joins, 2 free ends" "G0, kink; gap 0 mm, angle [0.99999" "1 gap, 0 undecided; 1 corner, 0 fading corners, 1 kink" "2 of them not G1"
says out ": gap; gap [0.1, 0.100001] mm" "G0, corner; gap "
run 0 verify models/kinked_wire.brep --require G0 --within 0.2,0.1deg && run 0 verify models/kinked_wire.brep --require G1 --within 0.2,1.1deg --kink-angle 44
run 1 verify models/kinked_wire.brep --require C0 && run 1 verify models/kinked_wire.brep --require G1 --within 0.2,0.1deg --kink-angle 50 && says out "3 joins" "2 of them"
run 2 verify models/tree.brep --require G1 && says out "ends of curves 0, 1, 2: three curves or more meet there" "not covered: 1 place" "1 place where three curves or more meet"
run 2 verify models/line.brep && says err "nothing was decided"

# knots, corners of polygons, and curves that end where they start
run 0 verify models/knots.brep --require G1 && says out "knot 0.25 of curve 1 (B-spline curve): G0, corner" "ends of curve 2 (circle): G1" "3 joins" "2 corners"
lacks out "knot 0.5 of curve 0" && run 1 verify models/knots.brep --require G2 --within 0.01,0.1deg,1% && says out "knot 0.5 of curve 0 (B-spline curve): G1" "ends of curve 2 (circle): G2"
run 0 verify models/wire.brep --require G1 && says out "ends of curve 0 (B-spline curve)"
run 0 verify models/cubics.brep --require C2 --within 0.001,0.01deg,0.01% && says out "jumps of derivatives 0 % and 0 %" "every join of curves is C2 within the tolerance, proved"

# the curvature of curves: the semicircles have the radius 5, but for rounding
for file in slot.brep slot.step slot.igs slot_moved.brep; do
  run 0 verify models/$file --min-radius 5 && says out "every curve is bent by at most the radius 5, proved" && lacks out bent_curves
  run 1 verify models/$file --max-curvature 0.1999999 --require G1 && says out "2 of them not G1 within the tolerance or a corner, or bent by at most the curvature 0.1999999"
  holds [ "$(grep -cE '^curve . \(circle.*\): curvature .* /mm, radius .*4\.9999.* mm at t = ' out)" -eq 2 ]
done
run 0 verify models/line.brep --max-curvature 0.001 && run 1 verify models/knots.brep --max-curvature 3.99 && says out "curve 0 (B-spline curve): curvature [3.9" "at t = 0.5, (1.5, 1, 0)" "1 of them not bent"
run 0 verify models/knots.brep --max-curvature 4 && run 2 verify models/slot_and_box.brep --min-radius 5 && says err "has faces"
run 1 verify models/slot.step --min-radius 6 --format sarif && says out '"ruleId":"bend"' '"startLine":' && run 1 verify models/slot.step --min-radius 6 --json && python3 - out <<'PYTHON' || holds false
import json, sys
bent = json.load(open(sys.argv[1]))["bent_curves"]
assert len(bent) == 2 and all(0.2 - 1e-9 < b["curvature"][0] <= b["curvature"][1] < 0.2 + 1e-9 for b in bent)
PYTHON

# reports for programs
run 1 verify models/kinked_wire.brep --require G1 --json && python3 - out <<'PYTHON' || holds false
import json, sys
report = json.load(open(sys.argv[1]))
joins = report["joins"]
assert [j["shape"] for j in joins] == ["kink", "corner", "gap"] and [j["order"] for j in joins] == ["G0", "G0", "gap"]
assert joins[0]["curves"] == [0, 1] and joins[0]["angle_degrees"][0] <= 1 <= joins[0]["angle_degrees"][1] and joins[0]["point"] == [10, 0, 0]
assert joins[0]["within"] == ["proved", "refuted", "refuted"] and joins[2]["gap"][0] < 0.1 + 1e-9
s = report["summary"]
assert (s["curves"], s["joins"], s["free_ends"], s["branchings"], s["kinks"], s["corners"], s["gap"]) == (4, 3, 2, 0, 1, 1, 1)
PYTHON
run 1 verify models/kinked_wire.brep --require G1 --format sarif && says out '"ruleId":"kink"' '"ruleId":"gap"' 'join of curve 0 (line) and curve 1 (line)'
run 1 verify models/kinked_wire.brep --require G1 --format junit && says out '<failure'
run 1 verify models/slot.step --require G2 --within 0.001,0.1deg,5% --format sarif && says out '"startLine":'
for n in $(grep -oE '"startLine":[0-9]+' out | grep -oE '[0-9]+' | sort -u); do sed -n "${n}p" models/slot.step | grep -qE '^#[0-9]+ = TRIMMED_CURVE' || holds false; done

# 60 wires of FreeCAD, with kinks that are known
/usr/bin/python3 - <<'PYTHON' || exit
import json, random, sys
sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
try:
    import FreeCAD, Part
except ImportError:
    sys.exit(0)
from FreeCAD import Rotation, Vector
random.seed(24)
angles = [0, 0, 0.01, 0.5, 2, 40]
def edge(kind, p, t, n):
    """an edge that starts in p with the tangent t, bent to n"""
    if kind == 0: return Part.LineSegment(p, p + t * random.uniform(5, 60)).toShape()
    if kind == 1:
        r = random.uniform(1, 100)
        curve = Part.Circle(p + n * r, t.cross(n), r)
    elif kind == 2:
        centre = p + n * random.uniform(6, 60)
        curve = Part.Ellipse(p, centre + t * random.uniform(2, 5), centre)
    else:
        s, d = Part.BSplineCurve(), random.uniform(2, 30)
        s.buildFromPolesMultsKnots([p, p + t * d, p + t * 2 * d + n * d, p + t * 3 * d + n * 2 * d, p + n * 3 * d], [4, 1, 4], [0, 1, 2], False, 3)
        return s.toShape()
    u = curve.parameter(p)
    return Part.Arc(curve, u, u + random.uniform(0.3, 2)).toShape()
known = []
for i in range(60):
    turned = Rotation(Vector(*(random.uniform(-1, 1) for _ in range(3))), random.uniform(0, 360))
    p, t, n = (turned.multVec(Vector(*v)) for v in ((50, 20, 9), (1, 0, 0), (0, 1, 0)))
    first = edge(i % 4, p, t * -1, n)
    angle = random.choice(angles)
    kink = Rotation(n.cross(t), angle)
    wire = Part.Wire([first, edge(i // 4 % 4, p, kink.multVec(t), kink.multVec(n))])
    wire.exportBrep("wire%d.brep" % i)
    wire.exportStep("wire%d.step" % i)
    known.append(angle)
json.dump(known, open("known.json", "w"))
PYTHON
if [ -e known.json ]; then
  "$program" verify wire?.brep wire??.brep wire?.step wire??.step --within 0.001,0.001deg --json >out 2>err
  python3 - out <<'PYTHON' || holds false
import json, re, sys
known, checked = json.load(open("known.json")), 0
for join in json.load(open(sys.argv[1]))["joins"]:
    angle, (low, high) = known[int(re.findall("[0-9]+", join["file"])[0])], join["angle_degrees"]
    assert low - 1e-7 <= angle <= high + 1e-7 and high - low < 1e-7, (join, angle)
    assert join["shape"] == ("smooth" if angle == 0 else "kink" if angle < 5 else "corner"), (join, angle)
    checked += 1
assert checked == 120
PYTHON
fi
