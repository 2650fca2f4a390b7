# SPDX-License-Identifier: CC0-1.0
"""Drawings: what SVG says besides curves. Beside each text stand the curves that it means, in the coordinates of the outermost element."""

from truth import Curve


def svg(content, attributes=""):
    return f'<svg xmlns="http://www.w3.org/2000/svg"{attributes}>{content}</svg>\n'


def path(d, attributes='fill="none"'):
    return svg(f'<path {attributes} d="{d}"/>')


QUARTER = "1 1 2"


def arcs(*points):
    """Quarters of ellipses, each by start, corner and end."""
    return [Curve(p, weights=QUARTER) for p in points]


def cases(suite):
    add = suite.add

    def case(name, question, why, text, chain, expect, closed=False, up_to="G2"):
        chain = [c if isinstance(c, Curve) else Curve(c) for c in chain]
        add("drawing/" + name, "drawing", question, why, chain, expect, up_to, closed=closed, files={"svg": text if text.startswith("<") else path(text)})

    # ---- Commands and numbers.
    case("more-points", "tangent", "Points after those of M are those of L.", "M0,0 1,0 2,0", ["0,0 1,0", "1,0 2,0"], "G2")
    case("relative", "tangent", "Relative commands begin where the last one ended.", "m1,1 l1,1 l2,2", ["1,1 2,2", "2,2 4,4"], "G2")
    case("horizontal-vertical", "tangent", "H and V: a right angle.", "M0,0H5V5", ["0,0 5,0", "5,0 5,5"], "G0")
    case("horizontal-back", "tangent", "h and a negative h: the line runs back.", "M0,0h5h-2", ["0,0 5,0", "5,0 3,0"], "G0")
    case("numbers-run-together", "tangent", "Numbers without separators: .5.5 is two numbers, 1-1 too.", "M.5.5L1 1 1.5+1.5", ["0.5,0.5 1,1", "1,1 1.5,1.5"], "G2")
    case("exponents", "tangent", "1e1, 1E+1 and 10 are one number.", "M0,0L1e1,1E+1L2.0e1,20", ["0,0 10,10", "10,10 20,20"], "G2")
    case("decimals-add-up", "tangent", "Three times .1 is .3 in decimals and not in doubles: a straight line.", "M.1,.2l.1,.2 .1,.2 .1,.2 .1,.2",
         ["0.1,0.2 0.2,0.4", "0.2,0.4 0.3,0.6", "0.3,0.6 0.4,0.8", "0.4,0.8 0.5,1"], "G2")
    case("decimals-return", "tangent", "Relative steps of decimals come back to the start exactly, so that Z adds no line; sums of doubles miss it by 6e-17.",
         "m0,0q.1,0 .2,.1t.1,-.2 t-.3,.1z", ["0,0 0.1,0 0.2,0.1", "0.2,0.1 0.3,0.2 0.3,-0.1", "0.3,-0.1 0.3,-0.4 0,0"], "G0", closed=True)
    case("kink-of-last-decimal", "tangent", "A handle that is off by one unit of its last decimal: a kink of 0.57 degrees.", "M0,0C1,0 2,0 3,0C4,.01 5,1 6,1",
         ["0,0 1,0 2,0 3,0", "3,0 4,0.01 5,1 6,1"], "G0")
    case("kink-in-big-coordinates", "tangent", "A kink of 1e-6 at coordinates of a map.", "M500000,4649776L500001,4649776L500002,4649776.000001",
         ["500000,4649776 500001,4649776", "500001,4649776 500002,4649776.000001"], "G0")

    # ---- Handles.
    case("smooth-cubic", "curvature", "S mirrors the handle: equal derivatives, and a jump of curvature.", "M0,1C1,0 2,0 3,0S5,1 6,1", ["0,1 1,0 2,0 3,0", "3,0 4,0 5,1 6,1"], "G1")
    case("smooth-cubic-g2", "curvature", "S, with a next handle that makes the curvature equal.", "M0,1C1,.5 2,0 3,0S5,.5 6,1", ["0,1 1,0.5 2,0 3,0", "3,0 4,0 5,0.5 6,1"], "G2")
    case("smooth-after-line", "tangent", "S after a line has no handle to mirror: its first handle is in the node, and the next one shows a kink.", "M0,0L1,0S3,1 4,1",
         ["0,0 1,0", "1,0 1,0 3,1 4,1"], "G0")
    case("smooth-after-line-g1", "tangent", "S after a line, with the next handle on the line.", "M0,0L1,0S3,0 4,1", ["0,0 1,0", "1,0 1,0 3,0 4,1"], "G1", up_to="G1")
    case("smooth-quadratic", "curvature", "T mirrors the handle of Q, here at the vertex of a parabola that turns over: an inflection.", "M0,1Q1,0 2,0T4,-1",
         ["0,1 1,0 2,0", "2,0 3,0 4,-1"], "G1")
    case("smooth-quadratic-g2", "curvature", "T mirrors the handle of Q at the vertex of one parabola.", "M0,1Q1,0 2,0T4,1", ["0,1 1,0 2,0", "2,0 3,0 4,1"], "G2")
    case("t-after-line", "tangent", "T after a line has its handle in the node: it is a line.", "M0,0L1,0T3,1", ["0,0 1,0", "1,0 1,0 3,1"], "G0")
    case("t-after-line-straight", "tangent", "T after a line, straight on.", "M0,0L1,0T3,0", ["0,0 1,0", "1,0 1,0 3,0"], "G2")
    case("quadratic-as-cubic", "curvature", "A quadratic and its other half as a cubic.", "M0,3Q3,0 6,0C8,0 10,1 12,3", ["0,3 3,0 6,0", "6,0 8,0 10,1 12,3"], "G2")
    case("retracted-both", "tangent", "C with both handles in its nodes is a line.", "M0,0C0,0 3,0 3,0L5,0", ["0,0 0,0 3,0 3,0", "3,0 5,0"], "G2")
    case("retracted-one", "tangent", "One handle in the node, the other shows the tangent.", "M0,0L3,0C3,0 5,0 6,1", ["0,0 3,0", "3,0 3,0 5,0 6,1"], "G1", up_to="G1")
    case("cusp", "tangent", "Handles on the same side of the node.", "M0,1C1,1 4,0 3,0C4,0 5,-1 6,-1", ["0,1 1,1 4,0 3,0", "3,0 4,0 5,-1 6,-1"], "G0")
    case("corner-with-handles-in-it", "curvature", "A corner that is rounded by one cubic with both handles in it: G2 with both lines.", "M-20,0H-9C0,0 0,0 0,9V20",
         ["-20,0 -9,0", "-9,0 0,0 0,0 0,9", "0,9 0,20"], "G2")

    # ---- Segments of no length.
    case("line-of-no-length", "tangent", "A line of no length between two others is left out.", "M0,0L1,0L1,0L2,0", ["0,0 1,0", "1,0 2,0"], "G2")
    case("curve-of-no-length", "tangent", "A cubic whose points are all one is left out; around it is a corner.", "M0,0L1,0C1,0 1,0 1,0L1,1", ["0,0 1,0", "1,0 1,1"], "G0")
    case("close-adds-nothing", "tangent", "Z where the path is already back adds no line: smooth there.", "M0,0C2,0 4,2 4,4C4,8 -4,8 -4,4C-4,2 -2,0 0,0Z",
         ["0,0 2,0 4,2 4,4", "4,4 4,8 -4,8 -4,4", "-4,4 -4,2 -2,0 0,0"], "G2", closed=True)

    # ---- Ends.
    case("close-with-a-corner", "tangent", "The only corner is where Z ends.", "M0,0C2,0 4,2 4,4C4,8 -4,8 -4,4Z", ["0,0 2,0 4,2 4,4", "4,4 4,8 -4,8 -4,4", "-4,4 0,0"], "G0", closed=True)
    case("filled-without-z", "tangent", "A filled path that ends at its start has a join there, here with a kink.", path("M0,0C2,0 4,2 4,4C4,8 -4,8 -4,4C-4,2 -2,-.1 0,0", ""),
         ["0,0 2,0 4,2 4,4", "4,4 4,8 -4,8 -4,4", "-4,4 -4,2 -2,-0.1 0,0"], "G0", closed=True)
    case("stroked-without-z", "tangent", "The same path without filling is open: its ends meet and are no join.", "M0,0C2,0 4,2 4,4C4,8 -4,8 -4,4C-4,2 -2,-.1 0,0",
         ["0,0 2,0 4,2 4,4", "4,4 4,8 -4,8 -4,4", "-4,4 -4,2 -2,-0.1 0,0"], "G2")
    case("goes-on-after-z", "tangent", "After Z the path goes on from the start of the subpath, as a new subpath without a join to it.", "M0,0L4,0Q8,0 8,4T0,8Q-4,8 -4,4T0,0ZL-1,5",
         ["0,0 4,0", "4,0 8,0 8,4", "8,4 8,8 0,8", "0,8 -4,8 -4,4", "-4,4 -4,0 0,0"], "G1", closed=True)
    case("ends-with-m", "tangent", "A last M draws nothing.", "M0,0L1,0L2,0M9,9", ["0,0 1,0", "1,0 2,0"], "G2")

    # ---- Arcs.
    right, left = "4,0 4,4 0,4", "0,4 -4,4 -4,0"
    case("arc-arc", "curvature", "Two arcs of one circle.", "M4,0A4,4 0 0 1 0,4A4,4 0 0 1 -4,0", arcs(right, left), "G2")
    case("line-arc", "curvature", "A line touches an arc.", "M4,-4L4,0A4,4 0 0 1 0,4", [Curve("4,-4 4,0")] + arcs(right), "G1")
    case("arc-other-sweep", "tangent", "The second arc has the other sweep: the direction turns by a right angle.", "M4,0A4,4 0 0 1 0,4A4,4 0 0 0 -4,0", arcs(right, "0,4 0,0 -4,0"), "G0")
    case("arc-large", "curvature", "The same end by the large arc: three quarters of a circle, which leave in another direction.",
         "M0,-4L4,-4A4,4 0 1 1 0,0L0,-3", [Curve("0,-4 4,-4")] + arcs("4,-4 8,-4 8,0", "8,0 8,4 4,4", "4,4 0,4 0,0") + [Curve("0,0 0,-3")], "G1")
    case("arc-s", "curvature", "Arcs of one radius that bend to different sides.", "M4,0A4,4 0 0 1 0,4A4,4 0 0 0 -4,8", arcs(right, "0,4 -4,4 -4,8"), "G1")
    case("arc-radius-0", "tangent", "An arc with a radius of 0 is a line.", "M0,0L1,0A0,5 0 0 1 2,0", ["0,0 1,0", "1,0 2,0"], "G2")
    case("arc-negative-radius", "curvature", "The sign of a radius is dropped.", "M4,0A-4,4 0 0 1 0,4A4,-4 0 0 1 -4,0", arcs(right, left), "G2")
    case("arc-grows", "curvature", "Radii that are too small grow to a half circle: here both arcs to one circle.", "M4,0A1,1 0 0 1 -4,0A4,4 0 0 1 0,-4",
         arcs(right, left, "-4,0 -4,-4 0,-4"), "G2")
    case("arc-flags-run-together", "curvature", "Flags need no separators: 014 is 0, 1 and 4.", "M0,4a4,4 0 014-4A4 4 0 014 8", arcs("0,4 0,0 4,0") + arcs("4,0 8,0 8,4", "8,4 8,8 4,8"), "G2")
    case("arc-ellipse", "curvature", "Two quarters of an ellipse.", "M8,0A8,4 0 0 1 0,4A8,4 0 0 1 -8,0", arcs("8,0 8,4 0,4", "0,4 -8,4 -8,0"), "G2")
    case("arc-ellipse-circle", "curvature", "A quarter of an ellipse and one of a circle: tangents agree, curvatures do not.", "M8,0A8,4 0 0 1 0,4A4,4 0 0 1 -4,0",
         arcs("8,0 8,4 0,4", "0,4 -4,4 -4,0"), "G1")
    case("arc-ellipse-osculates", "curvature", "A quarter of an ellipse and one of the circle with its radius of curvature, 16.", "M8,0A8,4 0 0 1 0,4A16,16 0 0 1 -16,-12",
         arcs("8,0 8,4 0,4", "0,4 -16,4 -16,-12"), "G2")
    case("arc-no-length", "tangent", "An arc that ends where it starts is left out.", "M0,0L1,0A5,5 0 0 1 1,0L2,0", ["0,0 1,0", "1,0 2,0"], "G2")
    case("arc-kink", "tangent", "A line that meets an arc at an angle of 5.71 degrees.", "M0,-.5L5,0A5,5 0 0 1 10,5", [Curve("0,-0.5 5,0")] + arcs("5,0 10,0 10,5"), "G0")
    case("arc-touches", "curvature", "A line touches an arc that is no quarter: its centre is (5, 5), since (4, 3) has the length 5.",
         "M0,0H5A5,5 0 0 1 9,2", [Curve("0,0 5,0"), Curve("5,0 7.5,0 9,2", weights="1 1 5/4")], "G1")

    # ---- Transforms: the join is where it is drawn.
    case("scaled", "tangent", "A scale of (1, 0.01) makes a corner of 45 degrees a kink of 0.57.", svg('<g transform="scale(1,.01)"><path fill="none" d="M0,0L1,0L2,1"/></g>'),
         ["0,0 1,0", "1,0 2,0.01"], "G0")
    case("matrix", "curvature", "A sheared circle is an ellipse: G2.", svg('<path fill="none" transform="matrix(1 0 .5 1 3 4)" d="M4,0A4,4 0 0 1 0,4A4,4 0 0 1 -4,0"/>'),
         arcs("7,4 9,8 5,8", "5,8 1,8 -1,4"), "G2")
    case("mirrored", "curvature", "A mirrored path turns the other way on both sides: G2 as before.", svg('<path fill="none" transform="scale(-1,1)" d="M0,1C1,.5 2,0 3,0S5,.5 6,1"/>'),
         ["0,1 -1,0.5 -2,0 -3,0", "-3,0 -4,0 -5,0.5 -6,1"], "G2")
    case("nested", "tangent", "Transforms multiply from the outermost inwards: first scaled, then moved.",
         svg('<g transform="translate(1,0)"><g transform="scale(2,1)"><path fill="none" d="M0,0L1,1L2,2.01"/></g></g>'), ["1,0 3,1", "3,1 5,2.01"], "G0")
    case("style-transform", "tangent", "A transform in the property style counts instead of the attribute.",
         svg('<path fill="none" style="transform: scale(1,.02)" d="M0,0L1,0L2,1"/>'), ["0,0 1,0", "1,0 2,0.02"], "G0")
    case("viewport", "tangent", "An inner svg with another aspect flattens a corner of 45 degrees to a kink of 1.146.",
         svg('<svg width="100" height="2" viewBox="0 0 100 100" preserveAspectRatio="none"><path fill="none" d="M0,0L10,0L20,10"/></svg>'), ["0,0 10,0", "10,0 20,0.2"], "G0")
    case("use", "tangent", "What is defined is drawn by use only, with its own transform.",
         svg('<defs><path id="a" fill="none" d="M0,0L1,0L2,1"/></defs><use href="#a" transform="scale(1,.001)"/>'), ["0,0 1,0", "1,0 2,0.001"], "G0")
    case("not-drawn", "tangent", "A corner in a clip path is not drawn.",
         svg('<defs><clipPath id="c"><path d="M0,0L1,0L1,1Z"/></clipPath></defs><path fill="none" d="M0,0L1,1L2,2"/>'), ["0,0 1,1", "1,1 2,2"], "G2")

    # ---- Shapes.
    case("circle", "curvature", "A circle: joins of its quarters, G2.", svg('<circle cx="1" cy="2" r="4"/>'), arcs("5,2 5,6 1,6", "1,6 -3,6 -3,2", "-3,2 -3,-2 1,-2", "1,-2 5,-2 5,2"), "G2",
         closed=True)
    case("ellipse", "curvature", "An ellipse: G2.", svg('<ellipse rx="4" ry="2"/>'), arcs("4,0 4,2 0,2", "0,2 -4,2 -4,0", "-4,0 -4,-2 0,-2", "0,-2 4,-2 4,0"), "G2", closed=True)
    case("rectangle", "tangent", "A rectangle has four corners.", svg('<rect width="4" height="2"/>'), ["0,0 4,0", "4,0 4,2", "4,2 0,2", "0,2 0,0"], "G0", closed=True)
    case("rounded-rectangle", "curvature", "Rounded corners: arcs that touch lines.", svg('<rect width="8" height="6" rx="2"/>'),
         [Curve("2,0 6,0")] + arcs("6,0 8,0 8,2") + [Curve("8,2 8,4")] + arcs("8,4 8,6 6,6") + [Curve("6,6 2,6")] + arcs("2,6 0,6 0,4") + [Curve("0,4 0,2")] + arcs("0,2 0,0 2,0"), "G1", closed=True)
    case("rectangle-as-ellipse", "curvature", "Radii of half the size leave no line: an ellipse, G2.", svg('<rect width="8" height="4" rx="9" ry="9"/>'),
         arcs("4,0 8,0 8,2", "8,2 8,4 4,4", "4,4 0,4 0,2", "0,2 0,0 4,0"), "G2", closed=True)
    case("polyline", "tangent", "A polyline of three collinear points.", svg('<polyline fill="none" points="0,0 1,2 3,6"/>'), ["0,0 1,2", "1,2 3,6"], "G2")
    case("polyline-filled", "tangent", "A filled polyline whose last point is the first one: its last corner is a join.", svg('<polyline points="0,0 1,0 1,1 0,0"/>'),
         ["0,0 1,0", "1,0 1,1", "1,1 0,0"], "G0", closed=True)
    case("polygon", "tangent", "A polygon closes by itself.", svg('<polygon points="0,0 4,0 4,3"/>'), ["0,0 4,0", "4,0 4,3", "4,3 0,0"], "G0", closed=True)
