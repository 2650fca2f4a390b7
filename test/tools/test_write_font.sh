#!/usr/bin/env bash
# repair writes fonts by fontTools: nothing but the handles of its moves differs, and verify finds
# what repair has promised. The masters of variable fonts are mended together. Skipped without
# fontTools.
python=
for candidate in python3 /usr/bin/python3; do
  $candidate -c 'import fontTools' 2>/dev/null && python=$candidate && break
done
[ -n "$python" ] || exit 77
. "$(dirname "$0")/functions.sh"

# Compares two fonts with fontTools: prints the tables that differ and the points that have moved.
compare() {
  $python - "$@" <<'END'
import sys
from fontTools.pens.recordingPen import RecordingPen
from fontTools.ttLib import TTFont
old, new = (TTFont(name) for name in sys.argv[1:])
print("tables:", *sorted(t for t in old.reader.keys() if t != "head" and old.reader[t] != new.reader[t]))
for name in old.getGlyphOrder():
    drawn = []
    for font in (old, new):
        glyph = font["glyf"][name] if "glyf" in font else None
        pen = RecordingPen()
        if glyph is None:
            font.getGlyphSet()[name].draw(pen)
        drawn.append([[p for _, points in pen.value for p in points], [o for o, _ in pen.value]] if glyph is None else
                     [list(getattr(glyph, "coordinates", [])), list(getattr(glyph, "flags", []))])
        if glyph is not None and glyph.numberOfContours > 0:
            drawn[-1][1] += [glyph.xMin - font["hmtx"][name][1], glyph.program.getBytecode()]
    assert drawn[0][1] == drawn[1][1], name
    for p, q in zip(drawn[0][0], drawn[1][0]):
        if p != q:
            print("%s %s -> %s" % (name, tuple(p), tuple(q)))
END
}

# TrueType, with a component, and a handle that leaves the box of its glyph.
font given.ttf -v bearing=5 <<'END'
glyph .notdef
glyph base 65
contour 0,0 100,0 200,3* 300,300 0,300
glyph composed 66
component 1 400 0
glyph outside 67
contour 0,0 0,100 2,250* 300,300 300,0
END
cp given.ttf kept.ttf
run 1 verify given.ttf --require G1
run 0 repair given.ttf -o mended.ttf && says out "every join is free of kinks, proved exactly" "2 handles" && holds cmp -s given.ttf kept.ttf
run 0 verify mended.ttf --require G1 && says out "0 kinks"
compare given.ttf mended.ttf >differences && says differences "tables: glyf" "base (200, 3) -> (200, 0)" "outside (2, 250) -> (0, 250)"
holds [ "$(wc -l <differences)" -eq 3 ]
run 0 repair mended.ttf -o mended.ttf && says out "moves: 0 handles" && run 0 verify mended.ttf --require G1
for ending in otf woff; do
  run 0 repair given.ttf -o packed.$ending && run 0 verify packed.$ending --require G1
done
run 0 repair given.ttf -o moves.json && holds $python "$here/../../tools/fonttools/write_font.py" given.ttf moves.json script.ttf
holds cmp -s mended.ttf script.ttf
$python "$here/../../tools/fonttools/write_font.py" mended.ttf moves.json again.ttf 2>err && holds false
says err "there is no handle at" && holds [ ! -e again.ttf ]

# A collection: each of its fonts, and tables that they share stay shared.
$python - <<'END'
from fontTools.ttLib import TTCollection, TTFont
collection = TTCollection()
collection.fonts = [TTFont("given.ttf"), TTFont("mended.ttf"), TTFont("given.ttf")]
collection.save("given.ttc")
END
run 0 repair given.ttc -o mended.ttc && says out "kinks: 6 before, 0 after" && run 0 verify mended.ttc --require G1 && says out "0 kinks"
holds $python - <<'END'
from fontTools.ttLib import TTCollection, TTFont
fonts, mended = TTCollection("mended.ttc").fonts, TTFont("mended.ttf")
assert len(fonts) == 3
for font in fonts:
    assert all(font.reader[t] == mended.reader[t] for t in mended.reader.keys() if t != "head")
assert fonts[0].reader.tables["glyf"].offset == fonts[2].reader.tables["glyf"].offset
END
run 2 repair given.ttc -o no.ttf && says err "a collection of fonts is written as .ttc or .otc" && run 2 repair given.ttf -o no.ttc && says err "a single font is written as .ttf"
holds [ ! -e no.ttf ] && holds [ ! -e no.ttc ]

# Cubic curves. A segment without length stays.
font given.otf -v outlines=cff <<'END'
glyph .notdef
glyph curve 65
contour 0,0 100,0 150,3* 260,100* 300,300 300,300 0,300
END
run 0 repair given.otf -o mended.otf && run 0 verify mended.otf --require G1 && says out "0 kinks"
compare given.otf mended.otf >differences && says differences "tables: CFF" "curve (150, 3) -> (150, 0)" && holds [ "$(wc -l <differences)" -eq 2 ]

# Masters: one join whose masters are smooth kinks by 5 degrees between them.
$python - <<'END'
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib.tables.TupleVariation import TupleVariation
builder = FontBuilder(1000, isTTF=True)
builder.setupGlyphOrder([".notdef", "K"])
builder.setupCharacterMap({75: "K"})
empty, pen = TTGlyphPen(None), TTGlyphPen(None)
pen.moveTo((0, 0)), pen.lineTo((120, 120)), pen.qCurveTo((240, 240), (280, 400)), pen.lineTo((0, 400)), pen.closePath()
builder.setupGlyf({".notdef": empty.glyph(), "K": pen.glyph()})
builder.setupHorizontalMetrics({".notdef": (500, 0), "K": (500, 0)})
builder.setupHorizontalHeader(), builder.setupNameTable({"familyName": "T", "styleName": "R"}), builder.setupPost()
builder.setupFvar([("wght", 400, 400, 700, "Weight")], [])
deltas = [(0, 0), (-20, -70), (160, -40), None, None, None, None, None, None]
builder.setupGvar({"K": [TupleVariation({"wght": (0, 1, 1)}, deltas)]})
builder.save("vf.ttf")
END
run 0 verify vf.ttf --require G1 && run 1 verify vf.ttf --all-instances --max-kink 0
$python -c 'from fontTools.ttLib import TTCollection, TTFont; c = TTCollection(); c.fonts = [TTFont("vf.ttf")] * 2; c.save("vf.ttc")'
run 2 repair vf.ttc -o no.ttc && says err "a collection of fonts; extract the variable fonts first" && holds [ ! -e no.ttc ]
run 0 repair vf.ttf -o vf2.ttf && says out "1 join is mended for all masters together" "135.8 units"
run 0 verify vf2.ttf --all-instances --max-kink 0 && run 0 verify vf2.ttf --require G1
compare vf.ttf vf2.ttf >differences && says differences "tables: glyf gvar" "K (240, 240) -> (336, 336)" && holds [ "$(wc -l <differences)" -eq 2 ]
run 1 repair vf.ttf -o vf3.ttf --max-move 50 && says out "not mended: glyph K, contour 0, node (120, 120): a handle would move by 135.8 units"
run 2 verify vf.ttf --all-instances --max-kink -1 && says err "--max-kink: -1 is not at least 0 and less than 90 degrees"

# CFF2: operands with deltas of two regions; a kink, and with --to G2 curvatures, which another
# reader finds equal at the masters.
$python - <<'END'
from fontTools.fontBuilder import FontBuilder
from fontTools.misc.psCharStrings import T2CharString
def operands(*values):
    program = []
    for value in values:
        program += [value] if isinstance(value, int) else [*value, 1, "blend"]
    return program
builder = FontBuilder(1000, isTTF=False)
builder.setupGlyphOrder([".notdef", "o", "k"])
builder.setupCharacterMap({111: "o", 107: "k"})
builder.setupNameTable({"familyName": "T", "styleName": "R"})
builder.setupHorizontalMetrics({".notdef": (500, 0), "o": (700, 0), "k": (700, 0)})
builder.setupHorizontalHeader(), builder.setupPost()
builder.setupFvar([("wght", 400, 400, 700, "Weight"), ("wdth", 50, 100, 100, "Width")], [])
# (40, 0) (40, 180) (110, 320) (240, 320) (330, 320) (420, 250) (420, 60), and two more masters
o = operands(40, 0) + ["rmoveto"] + operands(0, 180, (70, 5, 20), (140, 0, 8), (130, 11, -7), 0) + ["rrcurveto"]
o += operands((90, 12, -3), 0, (90, 2, 10), (-70, 0, -4), 0, (-190, 0, 30)) + ["rrcurveto", -380, 0, "rlineto"]
k = operands(0, 0) + ["rmoveto"] + operands(0, 100, 60, (97, 40, 3), (140, -30, 20), (3, 24, 0)) + ["rrcurveto"]
k += operands((90, 10, -9), (2, 20, 0), 70, -90, 40, (-112, -4, 6)) + ["rrcurveto"]
strings = {name: T2CharString(program=program) for name, program in ((".notdef", []), ("o", o), ("k", k))}
builder.setupCFF2(strings, regions=[{"wght": (0, 1, 1)}, {"wdth": (-1, -1, 0)}])
builder.save("cff2.otf")
END
run 1 verify cff2.otf --all-instances --max-kink 0
run 0 repair cff2.otf -o cff2_g1.otf && says out "1 join is mended for all masters together" && run 0 verify cff2_g1.otf --all-instances --max-kink 0
run 0 repair cff2.otf --to G2 -o cff2_g2.otf && says out "1 join is mended for all masters together" "curvatures: 2 jumps of up to"
run 0 verify cff2_g2.otf --all-instances --max-kink 0 && run 0 repair cff2_g2.otf --to G2 -o cff2_again.otf && holds cmp -s cff2_g2.otf cff2_again.otf
run 1 repair cff2.otf -o cff2_no.otf --max-move 1/2 && says out "not mended: glyph k, contour 0, node (200, 200)"
compare cff2.otf cff2_g1.otf >differences && says differences "tables: CFF2" && says differences "k (" && holds [ "$(wc -l <differences)" -le 3 ]
holds $python - <<'END'
from fontTools.pens.recordingPen import RecordingPen
from fontTools.ttLib import TTFont
def jumps(name, at):
    """The relative jumps of the curvature in the middle of the first two curves of both glyphs, as fontTools draws them."""
    found = []
    for glyph in "ok":
        pen = RecordingPen()
        TTFont(name).getGlyphSet(location=at)[glyph].draw(pen)
        (_, p), (_, q) = [x for x in pen.value if x[0] == "curveTo"][:2]
        a, b = complex(*p[2]) - complex(*p[1]), complex(*q[0]) - complex(*p[2])
        u, v = complex(*p[2]) - complex(*p[0]), complex(*q[1]) - complex(*p[2])
        assert abs((a.conjugate() * b).imag) < 1e-9 * abs(a * b) or name == "cff2.otf"
        x, y = (u.conjugate() * a).imag / abs(a) ** 3, (b.conjugate() * v).imag / abs(b) ** 3
        found.append(abs(x - y) / max(abs(x), abs(y)))
    return found
for at in ({}, {"wght": 700}, {"wdth": 50}):
    before, after = jumps("cff2_g1.otf", at), jumps("cff2_g2.otf", at)
    assert (before[0] > 0.02 or "wdth" in at) and after[0] < 0.005, (at, before, after)
for at in ({"wght": 531}, {"wght": 600, "wdth": 61}):
    assert jumps("cff2_g2.otf", at)[0] < 0.02, at
END
run 0 repair vf.ttf --to G2 -o vf4.ttf && says out "1 join is mended for all masters together" "curvatures: no jump before, no jump after" && holds cmp -s vf2.ttf vf4.ttf

# Without fontTools there is a way.
GEOMETRIC_CONTINUITY_PYTHON=/nowhere/python3 run 2 repair given.ttf -o none.ttf && holds [ ! -e none.ttf ]
says err "python3-fonttools" "GEOMETRIC_CONTINUITY_PYTHON" "repair given.ttf -o MOVES.json" "write_font.py given.ttf MOVES.json RESULT.ttf"

# Sources of fonts, where the Python module is installed; otherwise one sentence.
mkdir -p Font.ufo
GEOMETRIC_CONTINUITY_PYTHON=/nowhere/python3 run 2 verify Font.ufo && says err "Font.ufo: sources of fonts are read by the Python module" "ufoLib2"
run 2 verify Font.ufo --glyphs a && says err "--glyphs=a: not for sources of fonts"
run 2 repair Font.ufo -o Font.glyphs && says err "the format is .ufo"
