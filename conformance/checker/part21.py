# SPDX-License-Identifier: CC0-1.0
"""Reads the entities of an ISO 10303-21 file."""

import re
from fractions import Fraction as F

from brep import similarity
from joins import need, number

TOKEN = re.compile(r"\s*(?:('(?:[^']|'')*')|(#\d+)|(\.[A-Z_0-9]+\.)|([+-]?\d+\.?\d*(?:E[+-]?\d+)?)|([A-Z_0-9]+)|([(),$*]))")


class Model:
    def __init__(self, data):
        text = data.decode("ascii")
        need(text.startswith("ISO-10303-21;"), "not a STEP file")
        body = text[text.index("DATA;") + 5 :]
        self.entities = {}
        for label, content in re.findall(r"(#\d+)\s*=\s*(.*?);\s*\n", body, re.DOTALL):
            self.entities[label] = self.parse(content)

    def parse(self, content):
        """(NAME, arguments), or a list of those."""
        tokens = []
        at = 0
        content = content.strip()
        while at < len(content):
            found = TOKEN.match(content, at)
            need(found, f"{content[at : at + 20]!r} is no part of an entity")
            tokens.append(found)
            at = found.end()
        tokens.reverse()

        def arguments():
            result = []
            while tokens:
                found = tokens.pop()
                word = found.group().strip()
                if word == ")":
                    return result
                if word == ",":
                    continue
                if word == "(":
                    result.append(arguments())
                elif found.group(4):
                    result.append(number(word))
                elif found.group(5):
                    tokens.pop()
                    result.append((word, arguments()))
                else:
                    result.append(word)
            return result
        result = arguments()
        return result[0] if isinstance(result[0], tuple) else result[0]

    def all(self, name):
        return [e[1] for e in self.entities.values() if isinstance(e, tuple) and e[0] == name]

    def get(self, reference, *names):
        """The arguments of an entity, which must have one of these names."""
        entity = self.entities[reference]
        need(isinstance(entity, tuple) and (not names or entity[0] in names), f"{reference} is not one of {names}")
        return entity[1]

    def kind(self, reference):
        entity = self.entities[reference]
        return entity[0] if isinstance(entity, tuple) else [e[0] for e in entity]

    def point(self, reference):
        return self.get(reference, "CARTESIAN_POINT", "DIRECTION")[1]

    def mapping(self):
        """How the model is put into its product: by what, and the factor of its size and whether it is mirrored. Nothing if it is the product's own."""
        relations = [dict(e)["REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"][0] for e in self.entities.values()
                     if isinstance(e, list) and "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION" in dict(e)]
        items = [a[2] for a in self.all("MAPPED_ITEM")]
        if not items and not relations:
            return None
        need(len(items) + len(relations) == 1, "several placements")
        target = (items + relations)[0]
        if self.kind(target) == "ITEM_DEFINED_TRANSFORMATION":
            return "placement", F(1), False  # two right-handed placements
        _, _, _, x, y, _, scale, z = self.get(target, "CARTESIAN_TRANSFORMATION_OPERATOR_3D")
        factor, mirrored = similarity([self.point(a) for a in (x, y, z)])
        need(factor == 1, "axes that are no units")
        return ("mapped" if items else "part"), scale, mirrored

    @staticmethod
    def repeated(counts, values):
        return [t for t, n in zip(values, counts) for _ in range(int(n))]

    def spline_curve(self, reference):
        entity = self.entities[reference]
        if isinstance(entity, tuple):
            _, degree, points, _, _, _, counts, values, _ = self.get(reference, "B_SPLINE_CURVE_WITH_KNOTS")
            weights = None
        else:
            parts = dict(entity)
            degree, points = parts["B_SPLINE_CURVE"][:2]
            counts, values = parts["B_SPLINE_CURVE_WITH_KNOTS"][:2]
            weights = parts["RATIONAL_B_SPLINE_CURVE"][0]
        return int(degree), self.repeated(counts, values), [self.point(p) for p in points], weights

    def spline_surface(self, reference):
        """Degrees, knots, rows of points and of weights; u is the first index."""
        entity = self.entities[reference]
        if isinstance(entity, tuple):
            a = self.get(reference, "B_SPLINE_SURFACE_WITH_KNOTS")
            (p, q, rows), (m, n, u, v), weights = a[1:4], a[8:12], None
        else:
            parts = dict(entity)
            p, q, rows = parts["B_SPLINE_SURFACE"][:3]
            m, n, u, v = parts["B_SPLINE_SURFACE_WITH_KNOTS"][:4]
            weights = parts["RATIONAL_B_SPLINE_SURFACE"][0]
        return int(p), int(q), self.repeated(m, u), self.repeated(n, v), [[self.point(x) for x in row] for row in rows], weights
