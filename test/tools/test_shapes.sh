#!/usr/bin/env bash
# Commands write their curves in the format of the ending of --output, and others read them back.
. "$(dirname "$0")/functions.sh"

printf '0 0\n1 2\n3 3\n4 1\n' >points.txt
run 0 interpolate points.txt -o spline.g2

# drawings: the joins of lines and cubics are exactly smooth on the decimals that are written
run 0 interpolate points.txt -o spline.svg && run 0 verify spline.svg --require G1 && says out "2 joins in 1 subpath: 2 G1"
run 0 blend "$S" --corners all --distance 20 -o letter.svg && says err "23 curves of a degree above 3 are drawn by" "cubics within 0.0729463" &&
  run 0 verify letter.svg --require G1 && says out "0 corners, 0 kinks"
run 0 blend "$S" --corners all --distance 20 -o fine.svg --flatness 1/1000 && says err "within 0.001," && run 0 verify fine.svg --require G1
[ "$(grep -c ^C fine.svg)" -gt "$(grep -c ^C letter.svg)" ] || holds false
# lines of general directions, quadratics, quintics that are cubics; large and small units
for exponent in -9 0 12; do
  python3 - $exponent >scaled.g2 <<'PYTHON'
import sys
for degree, points in ((1, [(0, 0), (3, 1)]), (2, [(3, 1), (6, 2), (7, 9)]), (3, [(7, 9), (8, 16), (9, 20), (12, 20)])):
    knots = [0] * (degree + 1) + [1] * (degree + 1)
    print("100 1 0 0\n2 0\n%d %d" % (degree + 1, degree + 1), *knots)
    for p in points: print(*("%de%s" % (x, sys.argv[1]) for x in p))
PYTHON
  run 0 extend scaled.g2 --order tangent -o scaled.svg && run 0 verify scaled.svg --require G1 && says out "3 joins in 1 subpath: 3 G1"
done

# decimals that lead to the nearest doubles, or so many digits
run 0 interpolate points.txt -o decimals.g2 --decimals && says err "rounded by --decimals" && holds [ "$(grep -c / decimals.g2)" -eq 0 ]
python3 - spline.g2 decimals.g2 <<'PYTHON' || holds false
import sys
from fractions import Fraction
a, b = ([Fraction(x) for x in open(name).read().split()] for name in sys.argv[1:])
assert len(a) == len(b) and [float(x) for x in a] == [float(x) for x in b] and a != b
PYTHON
run 0 interpolate points.txt -o digits.g2 --decimals=3 && holds [ -z "$(grep -oE '[.][0-9]{4}' digits.g2)" ] && run 0 verify digits.g2 --within 0.01,1deg,5%
curve "2 0"$'\n2 2\n0 0 1 1\n0 0\n1/2 1' >half.g2 && run 0 extend half.g2 --order tangent -o halves.g2 --decimals && holds [ ! -s err ] && says halves.g2 "0.5 1"

# JSON and DXF hold the doubles: curves, rational ones, surfaces
check() { # check FILE.g2 FILE.json FILE.dxf: the same numbers
  python3 - "$@" <<'PYTHON' || holds false
import json, sys
from fractions import Fraction
words = iter(open(sys.argv[1]).read().split())
number = lambda: Fraction(next(words))
shapes = json.load(open(sys.argv[2]))["shapes"]
pairs = [line.strip() for line in open(sys.argv[3])] if len(sys.argv) > 3 else None
splines = [] # of the drawing: lists of (code, value)
for code, value in zip(pairs[::2], pairs[1::2]) if pairs else ():
    if code == "0": splines.append([])
    splines[-1].append((code, value))
splines = [s for s in splines if s[0][1] == "SPLINE"]
for k, shape in enumerate(shapes):
    surface = next(words) == "200"
    for _ in range(3): next(words)
    dimension, rational = int(next(words)), next(words) == "1"
    knots, size = [], []
    for _ in range(1 + surface):
        n, order = int(next(words)), int(next(words))
        size.append(n)
        knots.append([float(number()) for _ in range(n + order)])
    rows = [[number() for _ in range(dimension + rational)] for _ in range(size[0] * (size[1] if surface else 1))]
    weights = [float(r[-1]) if rational else 1.0 for r in rows]
    points = [[float(x / (r[-1] if rational else 1)) for x in r[:dimension]] for r in rows]
    flat = [p for j in range(size[1]) for p in (row[j] for row in shape["points"])] if surface else shape["points"]
    assert shape["kind"] == ("surface" if surface else "curve") and flat == points
    assert (shape["knots"] if surface else [shape["knots"]]) == knots
    if rational:
        w = shape["weights"]
        assert ([row[j] for j in range(size[1]) for row in w] if surface else w) == weights
    if pairs:
        values = lambda code: [float(v) for c, v in splines[k] if c == code]
        assert values("40") == knots[0] and values("41") == (weights if rational else [])
        assert list(zip(values("10"), values("20"), values("30"))) == [tuple((p + [0.0])[:3]) for p in points]
assert next(words, None) is None and len(shapes) > 0
PYTHON
}
for ending in json dxf; do run 0 interpolate points.txt -o spline.$ending && run 0 blend "$L" "$R" -o blend.$ending; done
run 0 blend "$L" "$R" -o blend.g2 && check blend.g2 blend.json blend.dxf && check spline.g2 spline.json spline.dxf
curve "2 1"$'\n3 3\n0 0 0 1 1 1\n1 0 1\n1 1 1\n0 2 2' >arc.g2
for ending in g2 json dxf; do run 0 extend arc.g2 --order curvature -o arcs.$ending; done
check arcs.g2 arcs.json arcs.dxf && says arcs.dxf "AC1015"
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n0 0 0\n4 0 1\n0 1 1\n4 1/3 0\n0 3 0\n4 3 1\n' >a.g2
printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n0 8 0\n5 8 1\n0 9.5 1\n4 9 0\n0 11 0\n4 12 1\n' >b.g2
for ending in g2 json; do run 0 blend --surfaces a.g2 b.g2 -o surface.$ending; done
check surface.g2 surface.json
/usr/bin/python3 - spline.dxf arcs.dxf blend.dxf <<'PYTHON' || holds false
import sys
try:
    import ezdxf
except ImportError:
    sys.exit(0)
import json
for name in sys.argv[1:]:
    drawing = ezdxf.readfile(name)
    assert not drawing.audit().errors
    shapes = json.load(open(name.replace(".dxf", ".json")))["shapes"]
    splines = list(drawing.modelspace())
    assert len(splines) == len(shapes)
    for e, shape in zip(splines, shapes):
        assert e.dxftype() == "SPLINE" and e.dxf.degree == shape["degree"] and list(e.knots) == shape["knots"]
        assert [tuple(p) for p in e.control_points] == [tuple((p + [0.0])[:3]) for p in shape["points"]]
        assert list(e.weights) == shape.get("weights", [])
        tool = e.construction_tool()
        first = shape["points"][0]
        assert max(abs(x - y) for x, y in zip(tool.point(0), first)) <= 1e-12 * max(map(abs, first + [1]))
PYTHON

# Inkscape draws the curves of a drawing where they are: their bounding boxes, but for the width of
# the pen
if command -v inkscape >/dev/null; then
  run 0 blend "$S" --corners all --distance 20 -o letter.json
  for name in spline letter; do
    inkscape --query-all $name.svg >boxes 2>inkscape.log
    python3 - $name.svg $name.json boxes <<'PYTHON' || holds false
import json, re, sys
shapes = json.load(open(sys.argv[2]))["shapes"]
def points(s): # of the Bezier curves between simple knots of multiplicity degree, or of cubics by de Boor
    p, u, c = s["degree"], s["knots"], s["points"]
    for i in range(p, len(c)):
        for step in range(65):
            if u[i] == u[i + 1]: continue
            t = u[i] + (u[i + 1] - u[i]) * step / 64
            d = [list(c[j]) for j in range(i - p, i + 1)]
            for r in range(1, p + 1):
                for j in range(p, r - 1, -1):
                    a = (t - u[j + i - p]) / (u[j + 1 + i - r] - u[j + i - p])
                    d[j] = [(1 - a) * x + a * y for x, y in zip(d[j - 1], d[j])]
            yield d[p]
box = list(zip(*(p for s in shapes for p in points(s))))
text = open(sys.argv[1]).read()
pen = float(re.search('stroke-width="([^"]*)"', text).group(1))
left, top, width, height = map(float, re.search('viewBox="([^"]*)"', text).group(1).split())
found = [list(map(float, line.split(",")[1:])) for line in open(sys.argv[3]) if line.startswith("path")]
x0, y0 = min(f[0] for f in found), min(f[1] for f in found)
x1, y1 = max(f[0] + f[2] for f in found), max(f[1] + f[3] for f in found)
for a, b in ((x0 + left, min(box[0])), (x1 + left, max(box[0])), (-y1 - top, min(box[1])), (-y0 - top, max(box[1]))):
    assert abs(a - b) <= pen + 1e-3 * width, (found, box)
PYTHON
  done
fi

# CAD models hold the doubles, too, as FreeCAD reads them
cad() { # cad FILE.json FILE.step...
  /usr/bin/python3 - "$@" <<'PYTHON' || holds false
import json, re, sys
sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
shapes = json.load(open(sys.argv[1]))["shapes"]
try:
    import FreeCAD, Part
except ImportError:
    FreeCAD = None
for name in sys.argv[2:]:
    if FreeCAD is None: # the coordinates that are written
        numbers = set(map(float, re.findall(r"[-+]?[0-9.]+(?:E[-+]?[0-9]+)?", open(name).read())))
        assert all(x in numbers for s in shapes if s["kind"] == "curve" for p in s["points"] for x in p)
        continue
    model = Part.Shape()
    model.read(name)
    assert model.isValid()
    parts = [f.Surface for f in model.Faces] or [e.Curve for e in model.Edges]
    assert len(parts) == len(shapes)
    for part, shape in zip(parts, shapes):
        surface = shape["kind"] == "surface"
        flat = lambda knots, times: [k for k, n in zip(knots, times) for _ in range(n)]
        if surface:
            assert [part.UDegree, part.VDegree] == shape["degree"] and shape["knots"] == [
                flat(part.getUKnots(), part.getUMultiplicities()), flat(part.getVKnots(), part.getVMultiplicities())]
        else:
            assert part.Degree == shape["degree"] and flat(part.getKnots(), part.getMultiplicities()) == shape["knots"]
        poles = [[list(p) for p in row] for row in part.getPoles()] if surface else [list(p) for p in part.getPoles()]
        assert poles == [(p + [0.0])[:3] for p in shape["points"]] if not surface else poles == shape["points"]
        if "weights" in shape: assert part.getWeights() == shape["weights"]
PYTHON
}
if "$program" interpolate points.txt -o spline.step >out 2>err; then
  for ending in brep stp; do
    run 0 interpolate points.txt -o spline.$ending && run 0 blend "$L" "$R" -o blend.$ending
    run 0 extend arc.g2 --order curvature -o arcs.$ending && run 0 blend --surfaces a.g2 b.g2 -o surface.$ending
  done
  cad spline.json spline.step spline.brep spline.stp && cad blend.json blend.stp blend.brep
  cad arcs.json arcs.stp arcs.brep && cad surface.json surface.stp surface.brep
  run 0 blend "$S" --corners all --distance 20 -o letter.brep && run 0 blend "$S" --corners all --distance 20 -o letter.json && cad letter.json letter.brep
else
  says err "are read and written by an optional part of this program"
fi

# what does not fit
run 2 interpolate points.txt -o out.igs && says err "the format is .g2, not .igs"
run 2 interpolate points.txt -o out.svg --decimals && says err "only with --output to a file .g2"
run 2 interpolate points.txt -o out.g2 --decimals=x && says err "a number of digits up to 300"
run 2 interpolate points.txt -o out.g2 --flatness 1 && says err "only with --output to a file .svg"
run 2 extend arc.g2 --order curvature -o out.svg && says err "no rational curves"
run 2 blend "$L" "$R" -o out.svg && says err "curves in the plane" && holds [ ! -e out.svg ]
