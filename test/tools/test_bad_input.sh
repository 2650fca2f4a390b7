#!/usr/bin/env bash
# Bad input: a message with file, line and reason, exit code 2, and no output.
. "$(dirname "$0")/functions.sh"

bad() { # bad REASON: the file bad.g2 is refused
  run 2 verify bad.g2 "$L" && says err "bad.g2" "$1"
  run 2 blend bad.g2 "$R" -o no.g2 --plot no.svg && says err "bad.g2"
  holds [ ! -e no.g2 -a ! -e no.svg ]
}
bad_curve() { curve "$2" >bad.g2 && bad "$1"; } # bad_curve REASON TEXT: that is refused
printf '' >bad.g2
bad "bad.g2:1"
bad_curve "3 of 4" $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2'
bad_curve "bad.g2:6" $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 nan 1\n2 2 2\n3 3 3'
bad_curve "bad.g2:6" $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 inf 1\n2 2 2\n3 3 3'
bad_curve "bad.g2:6" $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1/0 1\n2 2 2\n3 3 3'
bad_curve "bad.g2:6" $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1e999999999 1\n2 2 2\n3 3 3'
bad_curve "bad.g2:3" $'3 0\n4000000000 4\n0 0 0 0 1 1 1 1\n0 0 0'
bad_curve "bad.g2:2" $'3 2\n4 4\n0 0 0 0 1 1 1 1\n0 0 0'
bad_curve "bad.g2:9" $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4'
printf '\0\0\0\377\376' >bad.g2
bad "bad.g2:1"
printf '200 1 0 0\n' >bad.g2
bad "200"
run 2 verify missing.g2 "$L" && says err "missing.g2"
run 2 verify "$L" "$S" && says err "dimension"
run 2 blend "$L" "$S" -o no.g2 && says err "dimension_mismatch"
run 2 blend "$L" "$R" --beta 0 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --eta -1 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --beta two -o no.g2 && says err "--beta"
run 2 blend "$L" "$R" --strategy free -o no.g2 && run 2 blend "$L" "$R" --strategy best -o no.g2 && says err "energy3"
run 2 blend "$L" "$R" --order 4 -o no.g2 && run 2 blend "$L" "$R" --kernel quad -o no.g2
curve $'3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 1 1\n1 1 1' >cusp.g2
run 2 blend cusp.g2 "$R" -o no.g2 && says err "zero_tangent: blend: end of the first curve"
run 2 blend "$L" "$R" -o missing/no.g2 && says err "missing/no.g2"
echo old >old.g2
run 2 blend cusp.g2 "$R" -o old.g2
holds [ "$(cat old.g2)" = old ]
holds [ ! -e no.g2 ]

# Formats that a command does not read are named, by the name of the file and by what it begins
# with, with the nearest way.
refused() { # FILE COMMAND TEXT...: the error names the file and has these texts, and nothing of the reader of .g2
  local file=$1 command=$2
  shift 2
  run 2 $command "$file" && says err "$file" "$@" && lacks err "where an integer"
}
foreign() { # FILE TEXT...: no command reads it
  local file=$1 command
  shift
  for command in verify "report -o no.html" "repair -o no.g2" "plot -o no.svg" "tessellate -o no.stl" "extend --order curvature -o no.g2" \
    "round-edges --set-back 1" "fit -o no.g2" "interpolate -o no.g2"; do
    refused "$file" "$command" "which is not read" " ${command%% *} reads " "$@"
  done
}
mkdir formats && cd formats
: >part.dxf && : >part.DXF && : >Font.glyphs && : >Part.FCStd && : >part.stl && : >data.json && : >part.step.gz && : >a.ufoz
: >A.designspace && : >picture.png && : >page.pdf && : >part.sldprt && mkdir Font.ufo Font.glyphspackage
foreign part.dxf DXF "export it as SVG" "spline_pieces() reads the splines of ezdxf"
foreign Part.FCStd FreeCAD "export it as STEP"
foreign part.step.gz "a packed CAD model" gunzip
foreign a.ufoz "a UFO" "fontmake -u" "adapters.sources"
refused Font.ufo "report -o no.html" "a UFO, which is not read" "fontmake -u" "adapters.sources"
# sources of fonts go to the Python module, which reads them where it is installed
export GEOMETRIC_CONTINUITY_PYTHON=/nowhere/python3
for file in Font.ufo Font.glyphs A.designspace; do
  refused $file verify "install it (python/install) with ufoLib2 and glyphsLib" "make a font of it with fontmake"
done
unset GEOMETRIC_CONTINUITY_PYTHON
for file in "part.DXF DXF" "Font.glyphspackage fontmake -g" "part.stl triangles have no curvature" \
  "data.json JSON" "a.ufoz UFO" "picture.png pixels" "page.pdf export it as SVG" "part.sldprt export it as STEP"; do
  refused "${file%% *}" verify "${file#* }" "which is not read" "verify reads curves and surfaces (.g2), drawings (.svg, .svgz), fonts (" \
    "CAD models (.step, .stp, .iges, .igs, .brep, .brp)"
done
# by content, also of standard input
printf '  0\r\nSECTION\r\n  2\r\nHEADER\r\n' >dxf && printf ' {"a":1}' >json
printf '{\n.appVersion = "3208";\n' >glyphs && printf 'solid part\n facet normal 0 0 1\n' >stl && printf 'PK\3\4....Document.xml' >freecad
printf '<?xml version="1.0"?>\n<glyph name="a" format="2">\n' >glif && printf '<?xml version="1.0"?>\n<designspace format="4.1">' >designspace
printf 'ISO-10303-21;\nHEADER;\n' >step && gzip -c step >packed && printf '100 1 0 0\n' | gzip -c >packed_curves
printf '%72sS      1\n%72sG      1\n' '' '' >iges && printf '\nCASCADE Topology V1, (c) Matra-Datavision\n' >brep
for file in "dxf DXF" "json JSON" "glyphs Glyphs" "stl mesh" "freecad FreeCAD" "glif UFO" "designspace designspace" \
  "packed packed CAD model" "packed_curves packed" "step call it *.step" "iges call it *.iges" "brep call it *.brep"; do
  refused "${file%% *}" verify "${file#* }" "verify reads "
done
piped dxf 2 verify - && says err "standard input: DXF, which is not read"
echo hello >words.txt && refused words.txt verify "no format that is read; verify reads"
# a folder of sources, and none of fonts
mkdir -p sources/Bold.ufo && refused sources verify "sources/Bold.ufo: a UFO"
mkdir empty && refused empty verify "no name in it ends with .ttf"
# what another command reads
: >model.step && cp "$data/leaf_inkscape.svg" drawing && : >font.ttf
for command in blend connect match extend plot tessellate repair fit interpolate; do
  refused model.step "$command -o no.g2" "a CAD model: verify and report read it" "$command reads "
done
refused model.step "plot -o no.svg" "report draws it"
refused drawing "plot -o no.svg" "a drawing: verify, report, repair and blend read it"
refused font.ttf "tessellate -o no.off" "a font: verify, report and repair read it"
cp "$S" chain.g2 && refused chain.g2 fit "curves or surfaces (.g2)" "fit reads points"
# what is read as before: points in a table, a packed drawing, curves without an ending and after
# others
printf '0,0\n1,1\n2,0\n' >table.csv && run 0 interpolate table.csv
gzip -c "$data/leaf_inkscape.svg" >drawing.svg.gz && run 0 verify drawing.svg.gz --allow-uncovered
cp "$S" curves && run 0 verify --closed curves && cp "$S" other.backup.txt && run 0 verify --closed other.backup.txt
run 2 verify missing.dxf && says err "cannot_read_file: missing.dxf"
holds [ ! -e no.g2 -a ! -e no.svg -a ! -e no.html ]
