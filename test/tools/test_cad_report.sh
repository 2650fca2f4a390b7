#!/usr/bin/env bash
# The page of `report` for CAD models: its edges, the faces that are drawn, options, and the page in
# a browser.
. "$(dirname "$0")/functions.sh"
mirrored=$here/cad/data/mirrored.brep

# Without the module the program says what is missing, and writes no page.
printf 'ISO-10303-21;\n' >any.step
cp "$program" alone
"$PWD/alone" report any.step -o any.html >out 2>err
holds [ $? -eq 2 ] && says err "any.step: STEP, IGES and BREP are read and written by an optional part of this program" "libocct-data-exchange-dev"
holds [ ! -e any.html ]
made_by MAKE_CAD_MODELS models "$mirrored"

# counts PAGE TEXT...: how many edges have which grade
counts() { says "$1" "\"counts\":{$2}"; }
# drawn PAGE FACES ITEMS EDGES: so many faces with triangles, cards, and edges of the model
drawn() {
  holds [ "$(grep -c '"triangles":\[[0-9]' "$1")" -eq "$2" ]
  holds [ "$(grep -c '"number":[0-9]*,"grade"' "$1")" -eq "$3" ]
  holds [ "$(sed -n '/^"edges":\[/,$p' "$1" | grep -c '"grade":"[^"]*","patches":\[')" -eq "$4" ]
}
for file in fillet.brep fillet.step fillet.igs; do
  run 0 report models/$file -o page.html && holds [ ! -s err ]
  counts page.html '"gap":0,"kink":0,"fading corner":0,"corner":13,"G0":0,"undecided":0,"G1":2,"G2":0'
  drawn page.html 7 15 15
  says page.html "Continuity of $file" '7 faces, 15 edges of two sides within vda-4955, and G2 within a curvature jump of 0.1%; lengths in mm' '"notes":[]' '"dimension":3'
done
# each card: bounds of all three, and the point and the parameter of the worst
holds [ "$(grep -cE '"number":.*"angle":\["[^"]*","[^"]*"\],"jump":.*"edge":[0-9]+,"gap":\[.*"at":\["[^"]*","[^"]*","[^"]*"\],"parameter":"' page.html)" -eq 15 ]
says page.html '"grade":"G1","place":"edge ' '"verdict":"G0, corner"' '- cylinder'
run 0 report models/wall.brep -o page.html && drawn page.html 3 2 10
counts page.html '"gap":0,"kink":1,"fading corner":0,"corner":1,"G0":0,"undecided":0,"G1":0,"G2":0'
says page.html '"grade":"boundary"' '"verdict":"G0, kink, exactly G0"'
holds [ "$(grep -n '"number":' page.html | head -n 1 | grep -c '"grade":"kink"')" -eq 1 ] # the worst first
holds grep -qE '"grade":"kink".*"angle":\["(1|0\.99999[0-9]*)","1(\.0*[0-9]*)?"\]' page.html
run 0 report models/wall.brep -o page.html --kink-angle 0.9
counts page.html '"gap":0,"kink":0,"fading corner":0,"corner":2,"G0":0,"undecided":0,"G1":0,"G2":0'
run 0 report models/wall.brep -o page.html --within 0.01,1.1deg --worst 1
counts page.html '"gap":0,"kink":0,"fading corner":0,"corner":1,"G0":0,"undecided":0,"G1":0,"G2":1' # both are flat
says page.html 'within 0.01,1.1deg, and G2 within a curvature jump of 0.1%; lengths in mm' 'The page shows the worst 1 of 2' && says err "the worst 1 of 2"
run 0 report models/fillet.step -o page.html --within 0.01,0.1deg,101%
counts page.html '"gap":0,"kink":0,"fading corner":0,"corner":13,"G0":0,"undecided":0,"G1":0,"G2":2'
run 0 report models/fading.brep -o page.html && says page.html '"fading corner":1,"corner":0' '"grade":"fading corner"' '"verdict":"G0, fading corner'
run 0 report models/separated.brep -o page.html --sew 0.001 && says page.html '15 edges sewn by OpenCASCADE of two boundary edges'
counts page.html '"gap":0,"kink":0,"fading corner":0,"corner":13,"G0":0,"undecided":0,"G1":2,"G2":0'
run 2 report models/separated.brep -o page.html --sew 0 && says err "--sew"
# edges that gape, and the order of the worst
run 0 report models/apart.brep -o page.html --sew 0.1 && says page.html '"grade":"gap"' '"verdict":"gap"'
counts page.html '"gap":2,"kink":0,"fading corner":0,"corner":0,"G0":0,"undecided":0,"G1":0,"G2":0'
holds [ "$(grep '"number":' page.html | sed 's/.*"gap":\["0.0\([0-9]\).*/\1/' | tr '\n' ' ')" = "4 2 " ] # from 0.05 and 0.03 rounded down
run 0 report models/kinks.brep -o page.html && counts page.html '"gap":0,"kink":2,"fading corner":0,"corner":0,"G0":0,"undecided":0,"G1":0,"G2":0'
holds [ "$(grep '"number":' page.html | sed 's/.*"angle":\["\([0-9]\).*/\1/' | tr '\n' ' ')" = "3 0 " ] # the lower ends, the last one rounded down from 1

# seams, poles, several faces at an edge, what cannot be compared, and no edge of two sides
run 0 report models/sphere.brep -o page.html && drawn page.html 2 2 2
run 0 report models/torus.step -o page.html && drawn page.html 1 2 2
run 0 report models/torus.brep -o page.html --max-work 1
says page.html '"undecided":2,"G1":0,"G2":0}' # for which the work did not suffice
# faces without curves in their parameter planes, which are divided after healing
run 0 report models/sphere.step -o page.html && drawn page.html 2 2 2
run 0 report models/prism.step -o page.html && drawn page.html 3 3 3
run 0 report models/three.brep -o page.html && drawn page.html 3 0 10
says page.html '1 edge of three faces or more: drawn as boundary, not decided.' \
  '"not_covered":[{"what":"edge","reason":"three faces or more meet there","count":1}]'
run 0 report "$(dirname "$mirrored")/infinite.step" -o page.html --time-limit 20
says page.html '"not_covered":[{"what":"face","reason":"a number that is not finite","count":1}]' 'not covered: face 1: a number that is not finite'
run 0 report models/differing.brep -o page.html && says page.html '"grade":"undecided"' '"verdict":"curves of different parameters","angle":null'
run 0 report models/bezier.brep -o page.html && drawn page.html 1 0 4
run 0 report models/wire.brep -o page.html && drawn page.html 0 1 2
run 0 report models/slot_and_box.brep -o page.html && drawn page.html 6 16 20
says page.html '"place":"join of curve 0 (line) and curve 3 (circle)"' '6 faces, 12 edges of two sides and 4 joins of curves within' '4 curves without a face: 4 joins, 0 free ends.'

# an undecided edge says why, and fading corners come before those that are meant
run 0 report models/torus.brep -o page.html --max-work 1
says page.html ': the work did not suffice, see --max-work"' '"undecided":[{"what":"join","reason":"the work did not suffice, see --max-work","count":2}]'
run 0 report models/wall.brep -o page.html --within 0.02,1deg && says page.html '"verdict":"G0, exactly G0: the tolerance lies between the bounds"'
run 0 report models/fillet.brep models/fading.brep -o page.html && says page.html '"kink":0,"fading corner":1,"corner":13'
holds [ "$(grep '"number":' page.html | head -n 1 | grep -c 'models/fading.brep: .*"verdict":"G0, fading corner')" -eq 1 ]
run 0 report models/fillet.brep models/fading.brep -o page.html --worst 1 && holds [ "$(grep -c '"grade":"fading corner","place"' page.html)" -eq 1 ]

# what is to be done where no edge is compared
run 0 report models/separated.brep -o page.html
says page.html '"empty":"There is no edge of two sides, but 30 boundary edges: --sew DISTANCE joins boundary edges that coincide."'
run 0 report models/line.brep -o page.html && says page.html '"empty":"There is no edge of two sides, but 1 curve without a face: the ends of its curves are free: no two of them meet."'
run 2 verify models/line.brep && says out '1 curve without a face; 0 joins, 2 free ends' 'the ends of its curves are free' && run 0 verify models/line.brep --allow-empty

# two files that lie in the same place are drawn apart, as the page shows them at first
cp models/fillet.brep same.brep
run 0 report models/fillet.brep same.brep models/wire.brep -o page.html && says page.html '3 files, which are drawn beside each other' && drawn page.html 14 31 32
if command -v python3 >/dev/null; then
  holds python3 - page.html <<'PYTHON'
import json, math, sys
page = open(sys.argv[1]).read()
model = json.loads(page.split('id="data">')[1].split("</script>")[0])["model"]
azimuth, elevation = -math.pi / 3, 0.4
right = (-math.sin(azimuth), math.cos(azimuth), 0)
def range_of(patches):
    x = [sum(r * c for r, c in zip(right, p["points"][i:i + 3])) for p in patches for i in range(0, len(p["points"]), 3)]
    return min(x), max(x)
first, second = range_of(model["patches"][:7]), range_of(model["patches"][7:])
sys.exit(not first[1] < second[0])
PYTHON
fi

# a face on which OpenCASCADE does not come to an end is left white, and named, and nothing else is
# lost
run 0 report models/slow.step -o page.html --time-limit 20 && drawn page.html 6 13 15
says page.html '1 face cannot be drawn.' 'left white: dividing it into triangles does not end within 2 seconds of processor time.'
holds grep -qE "Face [0-9]+ \(revolution; #[0-9]+\) is left white" page.html

# faces that cannot be divided into triangles: the others are drawn, and no edge is lost
for file in crossed.brep infinite.brep; do
  run 0 report models/$file -o page.html && says page.html '1 face cannot be drawn.' ' is left white: it '
  holds [ "$(grep -c '"number":[0-9]*,"grade"' page.html)" -eq 15 ]
  holds [ "$(grep -c '"triangles":\[[0-9]' page.html)" -ge 7 ]
done
# of many triangles those of the first faces; the numbers that are drawn have seven digits
run 0 report models/tori.brep -o page.html && says page.html ' faces not drawn: there are too many triangles.'
holds [ "$(sed -n 's/.*"triangles":\[\([0-9][^]]*\)\].*/\1/p' page.html | tr ',' '\n' | wc -l)" -le 120000 ]
holds [ "$(grep -c '"triangles":\[[0-9]' page.html)" -ge 4 ]
run 0 report models/fillet.brep -o page.html
holds [ "$(grep '"triangles":\[[0-9]' page.html | grep -oE '\.[0-9]+' | awk '{ print length($0) - 1 }' | sort -n | tail -n 1)" -eq 5 ]

# a spline with many knots is drawn soon, and with a bounded number of triangles
bounded 30 0 report models/rough.brep -o page.html
holds [ "$(sed -n 's/.*"triangles":\[\([0-9][^]]*\)\].*/\1/p' page.html | tr ',' '\n' | wc -l)" -le 45000 ] && drawn page.html 1 0 4

# ids, names and colours of the file: the text of a face, a colour of a face and one of the solid
# that has it
face=$(sed -n 's/^#\([0-9]*\) = ADVANCED_FACE(.*/\1/p' models/fillet.step | head -n 1)
other=$(sed -n 's/^#\([0-9]*\) = ADVANCED_FACE(.*/\1/p' models/fillet.step | sed -n 2p)
solid=$(sed -n 's/^#\([0-9]*\) = MANIFOLD_SOLID_BREP(.*/\1/p' models/fillet.step | head -n 1)
styled() { # NUMBER ENTITY COLOUR
  local n=$1
  echo "#$n=STYLED_ITEM('',(#$((n + 1))),#$2);#$((n + 1))=PRESENTATION_STYLE_ASSIGNMENT((#$((n + 2))));"
  echo "#$((n + 2))=SURFACE_STYLE_USAGE(.BOTH.,#$((n + 3)));#$((n + 3))=SURFACE_SIDE_STYLE('',(#$((n + 4))));"
  echo "#$((n + 4))=SURFACE_STYLE_FILL_AREA(#$((n + 5)));#$((n + 5))=FILL_AREA_STYLE('',(#$((n + 6))));"
  echo "#$((n + 6))=FILL_AREA_STYLE_COLOUR('',#$((n + 7)));#$((n + 7))=COLOUR_RGB('',$3);"
}
context=$(sed -n "s/^#[0-9]* = ADVANCED_BREP_SHAPE_REPRESENTATION.*,#\([0-9]*\));.*/\1/p" models/fillet.step | head -n 1)
{
  sed "s/^#$face = ADVANCED_FACE('',/#$face = ADVANCED_FACE('lid <b>',/; s/^#$other = ADVANCED_FACE('',/#$other = ADVANCED_FACE('NONE',/" \
    models/fillet.step | sed '$d' | sed '$d'
  styled 90010 $face '1.,0.5,0.' && styled 90020 $solid '0.,0.,1.'
  echo "#90030=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#90010,#90020),#$context);"
  echo 'ENDSEC;' && echo 'END-ISO-10303-21;'
} >labels.step
run 0 report labels.step -o page.html && drawn page.html 7 15 15
says page.html "#$face \\\"lid \\u003cb\\u003e\\\"" "#$other" '"numbered":false'
holds [ "$(grep -c '"place":.*NONE' page.html)" -eq 0 ]
holds [ "$(grep -c '"colour":"#0000ff"' page.html)" -eq 6 ] && holds [ "$(grep -c '"colour":"#[^0].*"points"' page.html)" -eq 1 ]
run 0 report labels.step -o page.html --sew 0.001 && says page.html "#$face" '"colour":"#0000ff"'
sed 's/CYLINDRICAL_SURFACE(/CYLINDRIC_SURFACE(/' models/fillet.step >lost.step # a face that cannot be read
run 0 report lost.step -o page.html && says page.html '{"what":"element","reason":"cannot be read","count":2}' '{"what":"shell","reason":"is said to be closed, and is not","count":1}'
run 0 verify labels.step && says out "#$face \"lid <b>\""
run 0 verify models/fillet.igs && holds [ "$(grep -c '^edge.*; D[0-9]*, D[0-9]*)' out)" -eq 15 ]
run 0 verify models/fillet.brep && holds [ "$(grep -c '^edge [0-9]* ([^)]*;' out)" -eq 0 ]

# an assembly: what is equal is decided once, counted and named for each placed part
run 0 verify models/cylinder.brep --json && grep -oE '"(gap|angle_degrees|curvature_percent)":\[[^]]*\]' out | sort -u >one.txt
run 0 verify models/fillet.brep --json && grep -oE '"(gap|angle_degrees|curvature_percent)":\[[^]]*\]' out | sort -u >>one.txt
for file in assembly.brep assembly.step; do
  run 0 report models/$file -o page.html && drawn page.html 80 168 168
  says page.html '12 placed parts, 2 different: what is equal is decided once.'
  run 0 verify models/$file && says out '12 placed parts, 2 different: what is equal is decided once' '80 faces; edges: 167 inner, 1 seam'
  holds [ "$(sed -n 's/^edge.*) of \(.*\) \(inner\|seam\).*/\1/p' out | sort | uniq -c | awk '{ print $1 }' | sort | uniq -c | tr -s ' \n' ' ')" = " 11 15 1 3 " ]
  run 0 verify models/$file --json && says out '"placed_parts":12,"different_parts":2,"compared":18,'
done
run 0 verify models/assembly.brep --json
grep -oE '"(gap|angle_degrees|curvature_percent)":\[[^]]*\]' out | sort -u >all.txt
holds cmp -s <(sort -u one.txt) all.txt
# the place of the largest angle is moved with the part
holds [ "$(grep -o '"angle_at":{[^}]*}' out | sort -u | wc -l)" -ge 80 ]
# also where a face is placed in its part
run 0 verify models/again.brep --json && says out '"inner":2,' '"compared":1,'
# what differs in the part of a line that it has, in the surface of a side, or in which side is out,
# is not equal
run 0 verify models/pairs.brep --json && says out '"inner":6,' '"compared":6,'
run 0 verify models/pairs.brep && says out "2 G2, 0 G1, 4 G0" "2 corners" "2 inside out"

# bounds near zero are readable, and what is projected is marked
run 0 report models/sphere.step -o page.html && says page.html '"marks":["projected"'
run 0 report models/prism.step -o page.html && says page.html '1 face drawn after OpenCASCADE has healed the boundary' '"marks":["healed drawing"]'
run 0 report models/fillet.brep -o page.html
holds [ "$(grep -oE '"edge":[0-9]+' page.html | grep -oE '[0-9]+' | tr '\n' ' ')" = "$(seq 0 14 | tr '\n' ' ')" ] # of the drawing, in the order of the list
holds [ "$(grep -oE '"(gap|angle|jump)":\[[^]]*\]' page.html | grep -cE 'e-[1-9][0-9]')" -eq 0 ] && says page.html '"1e-09"'

# several files, and names that are no markup
odd='<script>alert(1)<\script>&".brep'
cp models/wall.brep "$odd"
run 0 report "$odd" models/cone.brep -o page.html && drawn page.html 5 4 12
says page.html '\u003cscript\u003ealert(1)' 'models/cone.brep: edge '
holds [ "$(grep -cF 'alert(1)' page.html)" -eq "$(grep -cF '\u003cscript\u003ealert(1)' page.html)" ]

# what is refused, and what cannot be read: no page
rm -f page.html
for option in --surfaces --closed --glyphs=a; do run 2 report models/wall.brep -o page.html $option; done
run 2 report models/wall.brep -o page.html --within 0.01,0.1deg,1%,0.1 && says err "GAP,ANGLEdeg,CURVATURE%"
run 2 report models/wall.brep -o page.html --within class-x && run 2 report models/wall.brep -o page.html --kink-angle 0
run 2 report $S -o page.html --within 1,1deg && says err "--within" "only for CAD models"
run 2 report models/wall.brep $S -o page.html && says err "cannot be read together"
run 2 report models/wall.brep -o page.svg
head -c 2000 models/fillet.step >cut.step
run 2 report cut.step -o page.html && says err "cut.step: not a complete STEP file"
run 2 report models/wall.brep cut.step -o page.html
sed '/^Surfaces/{n;n;s/^7 /9 /}' models/prism.brep >crash.brep
run 2 report crash.brep -o page.html && says err "crash.brep: the library that reads it crashes: the file is damaged"
holds [ ! -e page.html ]

# huge numbers, and no numbers: soon an error or a page, and in it numbers only
sed 's/-4\.44089[0-9]*E-16/-4.4E716/' models/fillet.step >huge.step
sed 's/^1 0 /1 nan /' models/fillet.brep >odd.brep
sed 's/^1 10 /1 1e30 /' models/fillet.brep >large.brep
for file in huge.step odd.brep large.brep; do
  rm -f page.html
  timeout 20 "$program" report $file -o page.html >out 2>err
  code=$?
  holds [ $code -eq 2 -o $code -eq 0 ] && holds [ $((code == 0)) -eq "$(ls page.html 2>/dev/null | wc -l)" ]
  [ $code -ne 0 ] || holds [ "$(sed -n '/id="data"/,/<script>/p' page.html | grep -ciE '[[,:](-?nan|-?inf)')" -eq 0 ]
done

# verify draws nothing: the edges are the same
run 0 verify models/fillet.step --json && says out '"edge":14'

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "no page is opened: there is no Chromium"
  exit
}
run 0 report models/moved.brep models/wall.brep "$odd" -o page.html
{ sed "s|script-src '[^']*'|script-src 'unsafe-inline'|" page.html && cat <<END; } >asked.html
<pre id="answers"></pre>
<script>
const inked = (canvas) => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.filter((x, i) => i % 4 === 3 && x > 0).length;
const canvas = document.querySelector('#model canvas');
drawModel(canvas, model, { camera, frame: model.frame, patches: model.all, chosen: 0, fill: true });
byId('answers').textContent = 'inked ' + (inked(canvas) > 2000) + [...document.querySelectorAll('.join canvas')].every((c) => inked(c) > 1000) +
  ', facets ' + model.patches.every((p) => p.facets.length > 0 && p.facets.length < 5000 && p.facets.every((f) => f.corners.length === 3));
</script>
END
timeout 60 "$browser" --headless --no-sandbox --disable-gpu --disable-extensions --no-first-run --user-data-dir="$PWD/profile" \
  --host-resolver-rules='MAP * ~NOTFOUND' --window-size=1400,950 --enable-logging=stderr --virtual-time-budget=5000 --dump-dom \
  "file://$PWD/asked.html" >dom 2>log </dev/null
holds [ $? -eq 0 ] && holds [ "$(grep -c CONSOLE log)" -eq 0 ]
says dom 'inked truetrue, facets true' 'aria-setsize="34"' 'class="with-model"' 'Curvature jump' '<small>parameter '
rm -rf profile
