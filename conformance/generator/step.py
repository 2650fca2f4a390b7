# SPDX-License-Identifier: CC0-1.0
"""Plain text of ISO 10303-21: no more than these cases need. The numbers are the exact decimals."""

from truth import Curve, determinant, exact, is_decimal, text


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

    def __init__(self, name, unit="mm", uncertainty="0.000001", frame=None):
        self.lines, self.name, self.frame = [], name, frame
        self.mirrored = frame is not None and determinant(*frame[0]) < 0
        context = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{context})")
        self.application, self.design = context, None
        self.mechanical = self.add(f"PRODUCT_CONTEXT('',{context},'mechanical')")
        self.definition, self.shape = self.product(name)
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

    def product(self, name):
        product = self.add(f"PRODUCT('{name}','{name}','',({self.mechanical}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        self.design = self.design or self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{self.application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{self.design})")
        return definition, self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")

    def turned(self, v):
        """By the frame: rows of a rotation."""
        return [sum(a * b for a, b in zip(row, v)) for row in self.frame[0]] if self.frame and len(v) == 3 else v

    def point(self, p):
        p = self.turned(p)
        if self.frame and len(p) == 3:
            p = [a + b for a, b in zip(p, self.frame[1])]
        return self.add(f"CARTESIAN_POINT('',{reals(p)})")

    def direction(self, v):
        return self.add(f"DIRECTION('',{reals(self.turned(v))})")

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

    def operator(self, columns, origin, scale):
        """It may mirror and scale, as the standard says: its three axes are given, and need not be right-handed."""
        x, y, z = (self.direction(c) for c in columns)
        return self.add(f"CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',{x},{y},{self.point(origin)},{real(scale)},{z})")

    def finish(self, kind, items, placed=None):
        """`placed` is how the model is put into its product: (mapped, part or placement; axes, origin, scale)."""
        self.frame = None
        origin = self.placement([0, 0, 0], [0, 0, 1], [1, 0, 0])
        representation = self.add(f"{kind}('',({','.join([origin] + items)}),{self.context})")
        if placed and placed[0] == "mapped":
            source = self.add(f"REPRESENTATION_MAP({origin},{representation})")
            item = self.add(f"MAPPED_ITEM('',{source},{self.operator(*placed[1:])})")
            representation = self.add(f"SHAPE_REPRESENTATION('',({origin},{item}),{self.context})")
        elif placed:
            part, shape = self.product("part")
            self.add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{representation})")
            if placed[0] == "part":
                target, operator = [], self.operator(*placed[1:])
            else:
                columns, place, _ = placed[1:]
                target = [self.placement(place, columns[2], columns[0])]
                operator = self.add(f"ITEM_DEFINED_TRANSFORMATION('','',{origin},{target[0]})")
            whole = self.placement([0, 0, 0], [0, 0, 1], [1, 0, 0])
            assembly = self.add(f"SHAPE_REPRESENTATION('',({','.join([whole] + target)}),{self.context})")
            usage = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','part','',{self.definition},{part},$)")
            use = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{usage})")
            relation = self.add(f"( REPRESENTATION_RELATIONSHIP('','',{representation},{assembly}) "
                                f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({operator}) SHAPE_REPRESENTATION_RELATIONSHIP() )")
            self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{use})")
            representation = assembly
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


class Arc:
    """A part of a circle, counter-clockwise about its axis."""

    def __init__(self, centre, axis, radius, start, end):
        self.centre, self.axis, self.radius, self.points = centre, axis, radius, [start, end]

    def keys(self):
        ends = tuple(map(tuple, self.points))
        return (*ends, tuple(self.centre), tuple(self.axis)), (*ends[::-1], tuple(self.centre), tuple(-x for x in self.axis))


class Shell(Step):
    """Faces that share edges and vertices where their curves and points are equal."""

    def __init__(self, name, unit="mm", uncertainty="0.000001", frame=None):
        super().__init__(name, unit, uncertainty, frame)
        self.vertices, self.edges, self.faces = {}, {}, []

    def spline_surface(self, s):
        rows = "(" + ",".join(refs([self.point(p) for p in row]) for row in s.points) + ")"
        head = f"{s.degrees[0]},{s.degrees[1]},{rows},.UNSPECIFIED.,.F.,.F.,.F."
        counts = lambda t: "(" + ",".join(str(t.count(x)) for x in sorted(set(t))) + ")"
        knots = f"{counts(s.u)},{counts(s.v)},{reals(sorted(set(s.u)))},{reals(sorted(set(s.v)))}"
        if s.weights:
            weights = "(" + ",".join(reals(row) for row in s.weights) + ")"
            return self.add(f"( BOUNDED_SURFACE() B_SPLINE_SURFACE({head}) B_SPLINE_SURFACE_WITH_KNOTS({knots},.UNSPECIFIED.) GEOMETRIC_REPRESENTATION_ITEM() "
                            f"RATIONAL_B_SPLINE_SURFACE({weights}) REPRESENTATION_ITEM('') SURFACE() )")
        return self.add(f"B_SPLINE_SURFACE_WITH_KNOTS('',{head},{knots},.UNSPECIFIED.)")

    def vertex(self, p):
        key = tuple(p)
        if key not in self.vertices:
            self.vertices[key] = self.add(f"VERTEX_POINT('',{self.point(p)})")
        return self.vertices[key]

    def curve_of(self, c):
        """A line where it is one."""
        if isinstance(c, Arc):
            reference = [(a - b) / c.radius for a, b in zip(c.points[0], c.centre)]
            axis = [-x for x in c.axis] if self.mirrored else c.axis  # in a mirror it runs the other way
            return self.add(f"CIRCLE('',{self.placement(c.centre, axis, reference)},{real(c.radius)})")
        if c.degree == 1 and len(c.points) == 2:
            d = [b - a for a, b in zip(*c.points)]
            return self.line(c.points[0], d)
        return self.spline(c)

    def face(self, surface, sides, same_sense=True, turns=False, inward=False):
        """`sides` are (curve, is it run forward, its image in the parameters or None). The normal of a surface that `turns` is a product of its
        derivatives: in a mirror it points to the other side. A face that looks `inward` is the other side of its surface, to which `sides` belong."""
        loop = []
        for c, forward, image in sides:
            key, backwards = c.keys()
            same = key in self.edges or backwards not in self.edges
            if key not in self.edges and same:
                self.edges[key] = {"curve": self.spline(c) if image else self.curve_of(c), "images": [], "ends": (self.vertex(c.points[0]), self.vertex(c.points[-1]))}
                self.edges[key]["id"] = f"@{len(self.edges)}@"
            edge = self.edges[key if same else backwards]
            if image:
                edge["images"].append((surface, image if same else image.reversed()))
            loop.append(self.add(f"ORIENTED_EDGE('',*,*,{edge['id']},{'.T.' if forward == same else '.F.'})"))
        edges = self.add(f"EDGE_LOOP('',{refs(loop)})")
        bound = self.add(f"FACE_OUTER_BOUND('',{edges},{'.F.' if self.mirrored != inward else '.T.'})")
        same_sense = (same_sense != (turns and self.mirrored)) != inward
        self.faces.append(self.add(f"ADVANCED_FACE('',({bound}),{surface},{'.T.' if same_sense else '.F.'})"))

    def close(self, placed=None):
        names = {}
        for edge in self.edges.values():
            curve = edge["curve"]
            if edge["images"]:
                images = [self.pcurve(surface, self.spline(image)) for surface, image in edge["images"]]
                kind = "SEAM_CURVE" if len({s for s, _ in edge["images"]}) == 1 and len(images) == 2 else "SURFACE_CURVE"
                curve = self.add(f"{kind}('',{curve},{refs(images)},.CURVE_3D.)")
            names[edge["id"]] = self.add(f"EDGE_CURVE('',{edge['ends'][0]},{edge['ends'][1]},{curve},.T.)")
        for key, name in names.items():
            self.lines = [line.replace(key, name) for line in self.lines]
        shell = self.add(f"OPEN_SHELL('',{refs(self.faces)})")
        model = self.add(f"SHELL_BASED_SURFACE_MODEL('',({shell}))")
        return self.finish("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", [model], placed)
