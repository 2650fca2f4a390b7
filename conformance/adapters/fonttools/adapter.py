# SPDX-License-Identifier: CC0-1.0
"""fontTools: GuessSmoothPointPen, by which outlines become points that are marked as smooth."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from answers import Unsupported, claim, serve  # noqa: E402
from fontTools.pens.pointPen import AbstractPointPen, GuessSmoothPointPen, SegmentToPointPen  # noqa: E402
from fontTools.pens.recordingPen import DecomposingRecordingPen  # noqa: E402
from fontTools.ttLib import TTFont  # noqa: E402


class Marks(AbstractPointPen):
    """The contours, as lists of (segment type, smooth)."""

    def __init__(self):
        self.contours = []

    def beginPath(self, identifier=None, **kwargs):
        self.contours.append([])

    def endPath(self):
        pass

    def addPoint(self, pt, segmentType=None, smooth=False, name=None, identifier=None, **kwargs):
        self.contours[-1].append((segmentType, smooth))

    def addComponent(self, *arguments, **kwargs):
        raise Unsupported("components")


def marks(font):
    glyphs = font.getGlyphSet()
    flat = DecomposingRecordingPen(glyphs)
    glyphs[font.getBestCmap()[65]].draw(flat)
    pen = Marks()
    flat.replay(SegmentToPointPen(GuessSmoothPointPen(pen)))
    return pen.contours


def decide(file, order, within):
    if within:
        raise Unsupported("tolerances")
    font = TTFont(file)
    if "fvar" in font:
        raise Unsupported("all instances of a variable font")
    smooth = True
    for contour in marks(font):
        for i, (kind, is_smooth) in enumerate(contour):
            after = contour[(i + 1) % len(contour)][0]
            if kind is None:
                continue
            if kind == "line" and after is not None:
                raise Unsupported("points between two lines, which the pen leaves alone")
            smooth = smooth and is_smooth
    return claim("G1+" if smooth else "G0", {"angle_radians": "0.05"})


serve(decide)
