# SPDX-License-Identifier: CC0-1.0
"""Plain text of ISO 10303-21: no more than these cases need. The numbers are the exact decimals."""

from truth import Curve, exact, is_decimal, text


def real(q):
    q = exact(q)
    assert is_decimal(q), q
    mantissa, _, exponent = text(q).partition("e")
    return mantissa + ("" if "." in mantissa else ".") + (f"E{exponent}" if exponent else "")


def reals(v):
    return "(" + ",".join(real(x) for x in v) + ")"


def refs(ids):
    return "(" + ",".join(ids) + ")"


def multiplicities(knots):
    values = sorted(set(knots))
    return "(" + ",".join(str(knots.count(t)) for t in values) + ")," + reals(values)


class Step:
    """A file that grows by entities; each is named by its number, as #12."""

    UNITS = {"mm": "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )", "m": "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.) )",
             "um": "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MICRO.,.METRE.) )", "cm": "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.CENTI.,.METRE.) )"}

    def __init__(self, name, unit="mm", uncertainty="0.000001"):
        self.lines, self.name = [], name
        context = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{context})")
        mechanical = self.add(f"PRODUCT_CONTEXT('',{context},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({mechanical}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        design = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{context},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
        self.shape = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        if unit == "inch":
            size = self.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{self.add(self.UNITS['mm'])})")
            dimensions = self.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            length = self.add(f"( CONVERSION_BASED_UNIT('INCH',{size}) LENGTH_UNIT() NAMED_UNIT({dimensions}) )")
        else:
            length = self.add(self.UNITS[unit])
        angle = self.add("( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) )")
        solid = self.add("( NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT() )")
        accuracy = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({real(uncertainty)}),{length},'distance_accuracy_value','confusion accuracy')")
        self.context = self.add(f"( GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy})) "
                                f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid})) REPRESENTATION_CONTEXT('','3D') )")
        self.plane_context = None

    def add(self, entity):
        self.lines.append(entity)
        return f"#{len(self.lines)}"

    def point(self, p):
        return self.add(f"CARTESIAN_POINT('',{reals(p)})")

    def direction(self, v):
        return self.add(f"DIRECTION('',{reals(v)})")

    def placement(self, origin, axis, reference):
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(origin)},{self.direction(axis)},{self.direction(reference)})")

    def line(self, p, v, length="1"):
        vector = self.add(f"VECTOR('',{self.direction(v)},{real(length)})")
        return self.add(f"LINE('',{self.point(p)},{vector})")

    def spline(self, curve):
        """A truth.Curve, of any dimension."""
        points = refs([self.point(p) for p in curve.points])
        head, knots = f"{curve.degree},{points},.UNSPECIFIED.,.F.,.F.", multiplicities(curve.knots)
        if curve.weights:
            return self.add(f"( BOUNDED_CURVE() B_SPLINE_CURVE({head}) B_SPLINE_CURVE_WITH_KNOTS({knots},.UNSPECIFIED.) CURVE() "
                            f"GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE({reals(curve.weights)}) REPRESENTATION_ITEM('') )")
        return self.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{head},{knots},.UNSPECIFIED.)")

    def pcurve(self, surface, curve):
        """A curve in the parameters of a surface."""
        if not self.plane_context:
            self.plane_context = self.add("( GEOMETRIC_REPRESENTATION_CONTEXT(2) PARAMETRIC_REPRESENTATION_CONTEXT() REPRESENTATION_CONTEXT('2D SPACE','') )")
        definition = self.add(f"DEFINITIONAL_REPRESENTATION('',({curve}),{self.plane_context})")
        return self.add(f"PCURVE('',{surface},{definition})")

    def finish(self, kind, items):
        origin = self.placement([0, 0, 0], [0, 0, 1], [1, 0, 0])
        representation = self.add(f"{kind}('',({','.join([origin] + items)}),{self.context})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({self.shape},{representation})")
        body = "\n".join(f"#{i}={line};" for i, line in enumerate(self.lines, 1))
        return ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                f"FILE_NAME('{self.name}','2026-01-01T00:00:00',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
                f"{body}\nENDSEC;\nEND-ISO-10303-21;\n")


def curves(name, chain):
    """Curves one after the other, as a set."""
    step = Step(name)
    flat = []
    for c in chain:
        points = [p + [0] * (3 - len(p)) for p in c.points]
        flat.append(step.spline(Curve(points, c.knots, c.weights, c.degree)))
    step_set = step.add(f"GEOMETRIC_CURVE_SET('',{refs(flat)})")
    return step.finish("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", [step_set])
