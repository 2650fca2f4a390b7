#!/usr/bin/env bash
# verify for fonts, which are generated here: what is read, how joins are graded, which glyphs,
# reports, and broken fonts.
. "$(dirname "$0")/functions.sh"

# glyph FONT NAME COUNTS [OPTIONS...]: what --json says about a glyph, as joins corners kinks bends
# rounding G1 G2
glyph() {
  run 0 verify "$1" --json --glyphs "$2" --allow-empty "${@:4}"
  local counts
  counts=$(sed -n 's/.*"joins":\([0-9]*\),"corners":\([0-9]*\),"kinks":\([0-9]*\),"kinks_off[a-z_]*":[0-9]*,"bends":\([0-9]*\),"rounding":\([0-9]*\),"G1":\([0-9]*\),"G2":\([0-9]*\),"worst".*/\1 \2 \3 \4 \5 \6 \7/p' out)
  is "$counts" "$3" "glyph $2 of $1"
}

# TrueType: an implied point with an odd sum, contours that begin with control points, with one, and
# with control points alone; repeated points; a single point.
cat >quadratic.txt <<'END'
glyph .notdef
glyph space 32
glyph square 65
contour 0,0 300,0 300,300 0,300
glyph odd 66
contour 0,0 101,0* 200,101* 200,300 0,300
glyph begins 67
contour 101,0* 200,101* 200,300 0,300 0,0
glyph between 68
contour 101,0* 200,101* 200,300 0,300 0,1*
glyph circle 69
contour 0,1* 101,0* 200,101* 103,200*
glyph repeated 70
contour 0,0 0,0 300,0 300,0* 300,0 300,300 0,300 0,0
contour 7,7
contour 8,8 8,8 8,8*
glyph kink 71
contour 0,0 100,0 200,1 200,300 0,300
glyph kinks 72
contour 0,0 300,20 600,20 900,0 600,-500 300,-500
contour 2000,0 2100,0 2200,7* 2300,300 2000,300
glyph composite 73
component 2 10 20
component 6 1000 0
component 8 -500 -30
glyph scaled 74
component 3 0 0 0.5
glyph angles 75
contour 0,0 100,0 200,100 200,300
END
font test.ttf <quadratic.txt
glyph test.ttf space "0 0 0 0 0 0 0"
glyph test.ttf square "4 4 0 0 0 0 0"
glyph test.ttf odd "4 3 0 0 0 1 0"
glyph test.ttf begins "4 3 0 0 0 1 0"
glyph test.ttf between "4 2 0 0 0 2 0"
glyph test.ttf circle "4 0 0 0 0 4 0"
glyph test.ttf repeated "4 4 0 0 0 0 0"
glyph test.ttf kink "5 4 0 0 1 0 0"
glyph test.ttf kink "5 4 0 1 0 0 0" --off-by 0
glyph test.ttf kink "5 4 0 1 0 0 0" --off-by 0.9999
glyph test.ttf kinks "10 7 1 2 0 0 0"
glyph test.ttf kinks "10 7 0 2 1 0 0" --off-by 7
glyph test.ttf kinks "10 7 0 0 3 0 0" --off-by 20
glyph test.ttf composite "13 8 0 0 1 4 0"
glyph test.ttf scaled "4 3 0 0 0 1 0"
run 0 verify test.ttf --summary
says out "Test Regular, test.ttf" "13 glyphs (2 empty), " " joins: "
holds [ "$(wc -l <out)" -eq 2 ]
run 0 verify test.ttf --json
says out '{"glyphs":[' '{"index":1,"name":"space","joins":0,' '"name":"Test Regular","units_per_em":1000' '"not_verified":[]' '"empty":2,'
# the implied point lies between units, and no kink comes from that
run 1 verify test.ttf --json --glyphs odd --require G2
says out '"point":[150.5,50.5],"grade":"G1","angle_degrees":[0,0]' '"required":"G2","met":false'
run 0 verify test.ttf --json --glyphs odd --require G1
says out '"kinks":0' '"required":"G1","met":true' '"worst":[]'

# The size of a kink: a unit in a hundred, and one in a table
run 0 verify test.ttf --json --glyphs kink --off-by 0
says out '"contour":0,"node":1,"point":[100,0],"grade":"bend","angle_degrees":[0.57293869768348' '"units":0.99995,"per_mille":0.999967' '"kinks_off_by_more_than_one_unit":0'
run 0 verify test.ttf --glyphs kink && says out "0 kinks, 1 off by rounding" && lacks out "100, 0"
run 0 verify test.ttf --glyphs kink --off-by 0
says out "kink   0        1     (100, 0)  0.573 degrees, of two lines  1 unit         1" "per mille of the em"
# the worst one first: the kink of a curve, then bends of two lines by how far they are off
run 0 verify test.ttf --json --glyphs kinks
says out '"worst":[{"contour":1,"node":1,"point":[2100,0],' '"kinks_off_by_more_than_one_unit":3'
holds [ "$(grep -o '"point":[^"]*' out | tr '\n' ' ')" = '"point":[2100,0], "point":[300,20], "point":[600,20], ' ]
run 0 verify test.ttf --json --glyphs kinks --worst 1 && holds [ "$(grep -o '"point"' out | wc -l)" -eq 1 ] && says out '"kinks":1'
run 0 verify test.ttf --worst 0 && lacks out contour && says out ", 1 kink, "
# by units, also of fonts with other ems
printf 'glyph .notdef\nglyph three 65\ncontour 0,0 100,0 200,3* 300,300 0,300\n' | font three.ttf
printf 'glyph .notdef\nglyph four 65\ncontour 0,0 100,0 200,4* 300,300 0,300\n' | font four.ttf -v em=2000
run 0 verify three.ttf four.ttf && holds [ "$(tail -n 2 out | grep -oE '[34] units +[23]' | tr -s ' ' | tr '\n' ' ')" = "4 units 2 3 units 3 " ]
# copies are shown once
answers 0 "kink and 1 more" verify test.ttf --glyphs kink,kinks,composite --off-by 0
# the angle that still is a kink, exactly
for angle in 45 45.0 45.000000000000000000000000001 90/2; do
  run 0 verify test.ttf --glyphs angles --kink-angle $angle --summary && says out "2 corners, 0 kinks, 2 bends of two lines"
done
run 0 verify test.ttf --glyphs angles --kink-angle 44.999999999999999999999999999 --summary && says out "4 corners, 0 kinks"
run 0 verify test.ttf --glyphs angles --kink-angle 179.9 --summary && says out "0 corners, 0 kinks, 4 bends of two lines"
for angle in 0 180 -5 x 5deg ""; do run 2 verify test.ttf --kink-angle "$angle" && says err "kink-angle"; done
for units in -1 x ""; do run 2 verify test.ttf --off-by "$units" && says err "off-by"; done

# A handle that is off by exactly one unit is rounding, and one that is off by little more is not.
# A bound on the curvature, in units of the font: the quadratic curve is bent by 2/(100 sqrt(2)).
printf 'glyph .notdef\nglyph bent 65\ncontour 0,0 100,0* 100,100 0,100\n' | font bent.ttf
run 0 verify bent.ttf --min-radius 70 && says out "3 curves, 0 not bent by at most the radius 70" "every curve is bent by at most the radius 70"
run 1 verify bent.ttf --max-curvature 1/71 && says out "glyph bent, contour 0, node " "the segment from there on has curvature [0.0141421, 0.0141422]" "1 not bent by at most the curvature 1/71"
run 1 verify bent.ttf --max-curvature 1/71 --json && says out '"bent_curves":[' '"glyph":"bent","contour":0,"node":' '"curves":3,"bent_curves":1' '"max_curvature":"1/71","met":false'
run 1 verify bent.ttf --max-curvature 1/71 --format sarif && says out '"ruleId":"bend"' 'not bent by at most the curvature 1/71'
run 2 verify bent.ttf --all-instances --min-radius 70 && says err "not with --all-instances"

printf 'glyph .notdef\nglyph one 65\ncontour 0,0 100,0 150,1* 300,300 0,300\nglyph more 66\ncontour 0,0 200,0 250,2* 300,300 0,300\n' | font rounding.ttf
glyph rounding.ttf one "4 3 0 0 1 0 0"
glyph rounding.ttf one "4 3 1 0 0 0 0" --off-by 0.99999999999999999999
glyph rounding.ttf more "4 3 1 0 0 0 0"
glyph rounding.ttf more "4 3 1 0 0 0 0" --off-by 1.99999999999999999999
glyph rounding.ttf more "4 3 0 0 1 0 0" --off-by 2
says out '"kinks_off_by_more_than_one_unit":0'
run 0 verify rounding.ttf --glyphs one --require G1 && run 1 verify rounding.ttf --glyphs one --require G1 --off-by 0
run 1 verify rounding.ttf --require G1 && says out "1 of them not G1" && run 0 verify rounding.ttf --require G1 --off-by 2
says out "every join but corners, bends of two lines and what is off by at most 2 units is G1, proved exactly"
# by the word of variable fonts: 2.2906 degrees
run 0 verify rounding.ttf --max-kink 2.3 && says out "is within 2.3 degrees, proved exactly"
run 1 verify rounding.ttf --max-kink 2.29 --json && says out '"max_kink":"2.29","met":false'
run 2 verify test.ttf --max-kink 90 && says err "--max-kink: 90 is not at least 0 and less than 90 degrees"

# Cubic curves: two halves of one, G2 inside; handles at nodes; a line as a curve; a curve that ends
# as it began.
cat >cubic.txt <<'END'
glyph .notdef
glyph halves 65
contour 0,0 40,80* 100,120* 160,120 220,120* 280,80* 320,0
glyph retracted 66
contour -100,-100 0,0 0,0* 100,100* 200,100 0,-300
glyph line 67
contour 0,0 0,0* 90,0* 100,0 150,0* 300,0* 300,0 300,200
glyph loop 68
contour 0,0 300,0* 0,300* 0,0
glyph cusp 69
contour 0,0 100,0* 200,0* 300,0 200,0* 100,-50* 0,-100
END
for options in "" "-v container=woff" "-v names=no"; do
  font test.otf -v outlines=cff $options <cubic.txt
  glyph test.otf halves "3 2 0 0 0 0 1"
  glyph test.otf retracted "4 3 0 0 0 1 0"
  glyph test.otf line "4 3 0 0 0 0 1"
  glyph test.otf loop "1 1 0 0 0 0 0"
  glyph test.otf cusp "3 3 0 0 0 0 0"
done

# Containers and names
font test.ttc -v container=ttc <quadratic.txt && font test.woff -v container=woff <quadratic.txt && font nameless.ttf -v names=no <quadratic.txt
run 0 verify test.ttf --json --summary && grep -o '"summary":.*' out >expected.txt
run 0 verify test.woff --json --summary && grep -o '"summary":.*' out >is.txt && same is.txt expected.txt
run 0 verify nameless.ttf --json --glyphs A && says out '"index":2,"name":"glyph00002"'
run 0 verify nameless.ttf --json --glyphs glyph00002 && says out '"index":2,'
run 0 verify test.ttc && says out "test.ttc, font 0" "test.ttc, font 1" "2 fonts, 26 glyphs"
run 0 verify test.ttc --json --summary
says out '{"fonts":[' '{"file":"test.ttc","font":0,"glyphs":[]' '{"file":"test.ttc","font":1,"glyphs":[]' '"summary":{"fonts":2,"glyphs":26,'
# what a file is, its first bytes tell as well
cp test.ttf letters && run 0 verify letters --glyphs A && says out "4 corners"
piped test.otf 0 verify - --glyphs A && says out "standard input" "1 glyph, 3 joins"

# Which glyphs
run 0 verify test.ttf --glyphs A-C,U+0044-U+0045,square,#7 --json --summary && says out '"glyphs":6,'
run 0 verify test.ttf --glyphs '#0-#99999' --json --summary && says out '"glyphs":13,'
run 0 verify test.ttf --glyphs U+0-U+10FFFF --json --summary && says out '"glyphs":12,'
run 2 verify test.ttf --glyphs A,nothing,U+00E9,é,#13 && says err "no font has 'nothing', 'U+00E9', 'é', '#13'" && holds [ ! -s out ]
for glyphs in "" "A,,B" "U+" "U+110000" "U+41-" "U+42-U+41" "B-A" "#" "#x" "#5-#4" "#1-2" "U+41x"; do
  run 2 verify test.ttf --glyphs "$glyphs" && says err glyphs
done
run 1 verify test.ttf test.otf --glyphs square,halves --summary && says out "not in this font: halves" "not in this font: square"
says out "not met, because not all was decided (see --allow-uncovered)"
run 0 verify test.ttf test.otf --glyphs square,halves --summary --allow-uncovered

# Requirements
run 1 verify test.ttf --require G1 --summary && says out "1 of them not G1" "kink of"
run 1 verify test.ttf --require G1 --summary --json && holds [ "$(grep -c '"index"' out)" -eq 1 ] && says out '"met":false'
run 1 verify test.ttf --require G2 && says out "of them not G2" "none, G1"
run 0 verify test.ttf --glyphs square,circle --require G1 && says out " is G1, proved exactly"
run 0 verify test.otf --glyphs halves --require G2 && says out " is G2, proved exactly"
for order in G0 G3 C1 F2 X; do run 2 verify test.ttf --require $order; done
run 2 verify test.ttf --glyphs space && says err "there is no join"
run 0 verify test.ttf --glyphs space --allow-empty && says out "no join, nothing was decided"
for option in --surfaces --closed "--within 1,1,1" "--kernel double" "--max-order 2" "--max-work 9"; do
  run 2 verify test.ttf $option && says err "not for fonts"
done
for option in "--glyphs a" "--worst 3"; do run 2 verify "$S" $option && says err "only for fonts"; done
run 2 verify test.ttf "$S" && says err "cannot be verified together"
run 2 verify test.ttf missing.ttf && says err "missing.ttf" && holds [ ! -s out ]

# Folders: all fonts in them, each once, and what is broken is named
mkdir -p fonts/deep/er fonts/empty none
cp test.ttf fonts/B.TTF && cp test.otf fonts/deep/er/a.otf && cp test.woff fonts/deep/c.Woff && cp "$S" fonts/curves.g2
head -c 400 test.ttf >fonts/deep/broken.ttf && ln -s ../../B.TTF fonts/deep/er/link.ttf && ln -s .. fonts/deep/loop
run 0 verify fonts --summary --allow-uncovered
says out "B.TTF" "deep/er/a.otf" "deep/c.Woff" "fonts/deep/broken.ttf: not verified, " "3 fonts, " "; 1 not verified"
lacks out link.ttf curves
run 1 verify fonts --summary
run 0 verify fonts --json --allow-uncovered && says out '{"fonts":[' '{"file":"fonts/deep/broken.ttf","reason":"' '"summary":{"fonts":3,'
run 2 verify none && says err "cannot_read_file: none: Is a directory, and no name in it ends with .ttf"
run 2 verify fonts/deep/broken.ttf && says err "malformed_input: fonts/deep/broken.ttf: " && holds [ ! -s out ]
mkdir broken && cp fonts/deep/broken.ttf broken
run 2 verify broken --json && says out '{"fonts":[' '"fonts":0' && says err "no join"
# Other formats: as many findings of each level as the text has rows and lines of what is not
# verified
count() { grep -o -- "$1" "$2" | wc -l; }
findings() { # findings CODE ERRORS WARNINGS NOTES ARGUMENTS...
  local code=$1 errors=$2 warnings=$3 notes=$4
  shift 4
  run "$code" verify "$@" --format sarif && cp out "sarif_$((++reports)).json"
  holds [ "$(count '"level":"error"' out) $(count '"level":"warning"' out) $(count '"level":"note"' out)" = "$errors $warnings $notes" ]
  run "$code" verify "$@" --format junit
  holds [ "$(count '<failure ' out) $(count '<skipped ' out) $(count '<system-out>' out)" = "$errors $warnings $notes" ]
  if command -v xmllint >/dev/null; then holds xmllint --noout --schema "$here/schemas/junit.xsd" out 2>/dev/null; fi
}
reports=0
findings 0 0 0 3 test.ttf
says out 'name="test.ttf"' "glyph kinks, contour 0, node 1: bend of two lines of 3.81 degrees at (300, 20), off by 20 units"
says out "glyph kinks, contour 1, node 1: kink of 4 degrees at (2100, 0), a handle is off by 7 units"
run 0 verify test.ttf --format sarif && holds [ "$(count '"region":{"startLine":1}' out)" -eq 3 ] # which a font has for viewers
run 0 verify test.ttf --glyphs kink,kinks,composite --off-by 0 --format sarif && says out '"claims":{"given":28,"decided":28,'
findings 1 1 0 2 test.ttf --require G1
findings 1 2 0 0 test.ttf --require G2 --worst 1
says out "more joins not G2; --worst N tells N of them"
findings 0 0 1 6 fonts --allow-uncovered
findings 1 1 0 6 fonts
findings 0 0 2 0 --allow-uncovered test.ttf test.otf --glyphs square,halves
says out 'name="glyph square"' "not verified, not in this font"
findings 0 0 0 6 test.ttc
says out "font 1, glyph kinks"

if command -v python3 >/dev/null; then
  for arguments in fonts test.ttf test.ttc "test.ttf --require G2" "fonts --summary --require G1" "broken --allow-empty" "test.ttf test.otf --glyphs square,halves"; do
    reports=$((reports + 1))
    "$program" verify $arguments --json >"json_$reports.json" 2>err
    holds python3 -c 'import json, sys
d = json.load(open(sys.argv[1]))
fonts = d.get("fonts", [d])
for f in fonts:
  for g in f["glyphs"] + [f["summary"]]:
    assert g["joins"] == g["corners"] + g["kinks"] + g["bends"] + g["rounding"] + g["G1"] + g["G2"]
  for g in f["glyphs"]:
    for w in g["worst"]:
      assert w["angle_degrees"][0] <= w["angle_degrees"][1]
assert d["summary"]["joins"] == sum(f["summary"]["joins"] for f in fonts)' "json_$reports.json"
  done
  if python3 -c "import jsonschema" 2>/dev/null; then
    holds python3 -c 'import glob, json, sys
from jsonschema import Draft7Validator
def validate(names, schema):
  for name in glob.glob(names):
    for error in Draft7Validator(json.load(open(sys.argv[1] + schema))).iter_errors(json.load(open(name))):
      sys.exit("%s: %s %s" % (name, list(error.absolute_path), error.message[:500]))
validate("json_*.json", "/schemas/fonts.json")
validate("sarif_*.json", "/schemas/sarif.json")' "$here"
  else
    echo "skipped: JSON is not validated, python3-jsonschema is missing"
  fi
fi

# Names from outside are not taken for lines or markup
printf 'glyph .notdef\nglyph a"\\<b 65\ncontour 0,0 100,0 200,1 200,300\n' | font names.ttf -v family='<script>"&'
run 0 verify names.ttf --json && says out '"name":"a\"\\<b"' '"name":"<script>\"& Regular"'

# Hostile fonts end, and in good time: cut off, with changed bytes, with endless components, also
# where the table of their places is said to be shorter than it is, which FreeType corrects
mkdir cut
for file in test.ttf test.otf test.ttc test.woff; do
  size=$(wc -c <$file)
  for ((n = 0; n < size; n += 13)); do head -c $n $file >cut/$n-$file; done
done
random=20261122
for ((i = 0; i < 400; ++i)); do
  files=(test.ttf test.otf test.ttc test.woff)
  file=${files[i % 4]}
  cp $file cut/changed-$i-$file
  for ((k = 0; k < 1 + i % 3; ++k)); do
    random=$(((69069 * random + 1) % 2147483648))
    printf "\\$(printf %03o $((random / 4096 % 256)))" |
      dd of=cut/changed-$i-$file bs=1 seek=$((random / 65536 % $(wc -c <$file))) conv=notrunc status=none
  done
done
bounded 60 0 verify cut --summary --allow-uncovered && says out "not verified"
holds [ "$(grep -c 'not verified, ' out)" -gt 50 ]
awk 'BEGIN {
  print "glyph .notdef\nglyph leaf"
  for (i = 2; i < 60; ++i) print "glyph g" i "\ncomponent " i - 1 " 0 0\ncomponent " i - 1 " 5 0"
  print "glyph self\ncomponent 60 0 0\nglyph good\ncomponent 62 0 0\nglyph square\ncontour 0,0 9,0 9,9"
}' | font endless.ttf
bounded 20 0 verify endless.ttf --json --allow-uncovered && mv out out_endless
says out_endless '"reason":"more components than any letter needs"' '"name":"good","joins":3,' '"name":"g9",'
cp endless.ttf short.ttf
loca=$(grep -abom1 loca short.ttf) && loca=${loca%%:*}
printf '\0\0\0\1' | dd of=short.ttf bs=1 seek=$((loca + 12)) conv=notrunc status=none
bounded 20 0 verify short.ttf --json --allow-uncovered
same <(sed 's/short.ttf/endless.ttf/' out) out_endless
printf 'glyph .notdef\nglyph lost\ncomponent 2 0 0\n' | font lost.ttf
run 0 verify lost.ttf --allow-empty --allow-uncovered && says out "glyph lost: not verified, invalid composite glyph"
run 1 verify lost.ttf --allow-empty && says out "not covered: 1 glyph, invalid composite glyph"

# Fractions of a unit, which FreeType cuts off: a join that is smooth with them, one that is not,
# and one at a size that no double of a product has
cat >fractions.txt <<'END'
glyph .notdef
glyph smooth 65
contour 0,0 20,-80* 69.25,-10.25* 100,0 112.75,4.25* 150,80* 100,200
glyph kink 66
contour 0,0 20,-80* 70,-10* 100,0 112.75,4.75* 150,80* 100,200
glyph curvature 67
contour 0.5,0 40.25,80.5* 100.25,120.25* 160.5,120.25 220.75,120.25* 280.75,80.5* 320.5,0
END
font fractions.otf -v outlines=cff <fractions.txt
glyph fractions.otf smooth "3 2 0 0 0 1 0"
glyph fractions.otf kink "3 2 0 0 1 0 0"
glyph fractions.otf kink "3 2 1 0 0 0 0" --off-by 0
glyph fractions.otf curvature "3 2 0 0 0 0 1"
answers 0 '"point":[100,0],"grade":"kink",' verify fractions.otf --json --glyphs kink --off-by 0
run 1 repair fractions.otf -o moves.json && says out "fractions of a unit"

# The place of a component that is scaled
printf 'glyph .notdef\nglyph rough 65\ncontour 0,0 30,10* 90,30 210,66* 300,300\nglyph placed 66\ncomponent 1 50 20 0.5\n' | font placed.ttf
run 0 verify placed.ttf --json --glyphs placed --off-by 0 && says out '"point":[95,35],"grade":"kink"'
# of one that is moved before it is scaled, which FreeType would round, and the left side bearing
# moves nothing
nested='glyph .notdef\nglyph rough 65\ncontour 0,0 30,10* 90,30 210,66* 300,300\nglyph moved 66\ncomponent 1 51 20\nglyph nested 67\ncomponent 2 0 0 0.5\n'
for bearing in "" 7; do
  printf "$nested" | font nested.ttf -v bearing=$bearing
  run 0 verify nested.ttf --json --glyphs rough,moved,nested --off-by 0
  says out '"point":[90,30],"grade":"kink"' '"point":[141,50],"grade":"kink"' '"point":[70.5,25],"grade":"kink"'
done

# of one whose place is scaled as well, and of one with a point that is put on another one, also in
# a component
cat >attached.txt <<'END'
glyph .notdef
glyph rough 65
contour 0,0 30,10* 90,30 210,66* 300,300
glyph wide 66
component 1:scaled 51 20 0.5
glyph attached 67
component 1 7 0
attached 1 4 2
glyph halved 68
component 3 100 0 0.5
attached 1 7 2 -0.5
glyph lost 69
component 1 0 0
attached 1 5 0
glyph missing 70
component 1 0 0
attached 1 4 5
glyph empty 71
attached 0 3 3
END
font attached.ttf <attached.txt
node() { # node GLYPH CONTOUR POINT
  run 0 verify attached.ttf --json --glyphs "$1" --off-by 0 --allow-uncovered && says out "\"contour\":$2,\"node\":1,\"point\":[$3],\"grade\":\"kink\""
}
node wide 0 70.5,25
node attached 0 97,30
node attached 1 307,300
node halved 0 148.5,15
node halved 1 253.5,150
node halved 2 253.5,150
run 0 verify attached.ttf --json --allow-uncovered
says out '"name":"lost","reason":"invalid composite glyph"' '"name":"missing","reason":"invalid composite glyph"'
lacks out '"name":"empty","reason"'

# Scaled components are graded as the exact points that they have, and named
cat >scaled.txt <<'END'
glyph .notdef
glyph smooth 65
contour 0,0 3,1* 9,3 27,9* 40,40
glyph scaled 66
component 1 0 0 0.3
glyph twice 67
component 2 7 0 0.3
component 1 100 0
glyph mirrored 68
component 1 0 0 -0.7
glyph rough 69
contour 0,0 30,10* 90,30 210,66* 300,300
glyph small 70
component 5 0 0 0.9
END
font scaled.ttf <scaled.txt
glyph scaled.ttf smooth "3 2 0 0 0 1 0"
glyph scaled.ttf scaled "3 2 0 0 0 1 0"
glyph scaled.ttf twice "6 4 0 0 0 2 0"
glyph scaled.ttf mirrored "3 2 0 0 0 1 0"
run 0 verify scaled.ttf --json --glyphs small && says out '"grade":"kink",' '"component":"rough"'
run 0 verify scaled.ttf --glyphs small && says out "small, component rough"

# A file that unpacks to more than any font needs is refused, without using the memory for it.
if command -v python3 >/dev/null; then
  python3 -c 'import struct, sys, zlib
size = 600 << 20
packer = zlib.compressobj(9)
packed = b"".join(packer.compress(bytes(1 << 20)) for i in range(600)) + packer.flush()
packed += bytes(-len(packed) % 4)
head = struct.pack(">4sIIHHIHHIIIII", b"wOFF", 0x10000, 64 + len(packed), 1, 0, 28 + size, 1, 0, 0, 0, 0, 0, 0)
table = struct.pack(">4sIIII", b"glyf", 64, len(packed), size, 0)
open("bomb.woff", "wb").write(head + table + packed)'
  if grep -qa __asan_init "$program"; then # reserves more memory than any limit
    "$program" verify bomb.woff >out 2>err && failures=$((failures + 1))
  elif limited $(($(memory_to_start) + 300000)) verify bomb.woff; then
    failures=$((failures + 1))
  fi
  says err "bomb.woff: more than 256 MiB when unpacked"
fi
