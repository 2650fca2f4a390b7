# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Glyphs of fontTools, drawn with a pen: `pen = Join_pen(glyph_set); glyph_set["S"].draw(pen); pen.kinks()`, or with one that takes points
as they are stored: `pen = Join_point_pen(glyph_set); glyph_set["S"].drawPoints(pen)`."""

from __future__ import annotations

from typing import List

from fontTools.pens.basePen import BasePen
from fontTools.pens.pointPen import AbstractPointPen
from fontTools.pens.transformPen import TransformPointPen

from .outlines import Kink, Point, joins, kinks


class _Contours:
    """The contours that a pen has kept."""

    name: str
    contours: List[List[Point]]

    def joins(self):
        """Yields the number of the contour and each of its joins."""
        for number, contour in enumerate(self.contours):
            for join in joins(contour):
                yield number, join

    def kinks(self, kink_angle=5) -> List[Kink]:
        """Returns the kinks of all contours."""
        return [k for number, c in enumerate(self.contours) for k in kinks(c, kink_angle, self.name, number)]


class Join_pen(_Contours, BasePen):
    """A pen that keeps contours as they are drawn, components included. Coordinates are read exactly as the pen gets them."""

    def __init__(self, glyphSet=None, name: str = ""):
        super().__init__(glyphSet)
        self.name = name
        self.contours = []

    def _moveTo(self, pt):
        self.contours.append([Point(*pt, "move")])

    def _lineTo(self, pt):
        self.contours[-1].append(Point(*pt, "line"))

    def _curveToOne(self, pt1, pt2, pt3):
        self.contours[-1] += [Point(*pt1, None), Point(*pt2, None), Point(*pt3, "curve")]

    def _qCurveToOne(self, pt1, pt2):
        self.contours[-1] += [Point(*pt1, None), Point(*pt2, "qcurve")]

    def _closePath(self):
        contour = self.contours[-1]
        first, last = contour[0], contour[-1]
        if len(contour) > 1 and (first.x, first.y) == (last.x, last.y):
            contour[0] = last
            del contour[-1]
        else:
            first.type = "line"


class Join_point_pen(_Contours, AbstractPointPen):
    """A point pen that keeps contours as they are stored, so that the numbers of nodes are those of the glyph; components are drawn by the
    glyph set."""

    def __init__(self, glyphSet=None, name: str = ""):
        self.glyphSet = {} if glyphSet is None else glyphSet
        self.name = name
        self.contours = []

    def beginPath(self, identifier=None, **kwargs):
        self.contours.append([])

    def addPoint(self, pt, segmentType=None, smooth=False, name=None, identifier=None, **kwargs):
        self.contours[-1].append(Point(*pt, segmentType))

    def endPath(self):
        pass

    def addComponent(self, baseGlyphName, transformation, identifier=None, **kwargs):
        self.glyphSet[baseGlyphName].drawPoints(TransformPointPen(self, transformation))


def font_kinks(font, kink_angle=5) -> List[Kink]:
    """Returns the kinks of all glyphs of a `fontTools.ttLib.TTFont`."""
    glyphs, found = font.getGlyphSet(), []
    for name in glyphs.keys():
        pen = Join_pen(glyphs, name)
        glyphs[name].draw(pen)
        found += pen.kinks(kink_angle)
    return found
