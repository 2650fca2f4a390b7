#!/usr/bin/env bash
# verify --all-instances: the largest kinks of variable fonts between the masters, and what is not covered.
schemas=$(cd "$(dirname "$0")" && pwd)/schemas
. "$(dirname "$0")/functions.sh"

# valid FILE: the file is JSON as the schema says, where python3 and its jsonschema are there
valid() {
  python3 -c "import jsonschema" 2>/dev/null || return
  holds python3 -c 'import json, sys; from jsonschema import Draft7Validator as V; V(json.load(open(sys.argv[1]))).validate(json.load(open(sys.argv[2])))' \
    "$schemas/instances.json" "$1"
}
bytes() { printf '%b' "$(tr -d '\n' | sed 's/../\\x&/g')"; } # from hexadecimal digits

# An axis wght from 100 to 900 whose upper half is stretched by 'avar'. Glyph 1 has the points (0, -50), (0, 0) off the curve,
# (100, 0), (200, 0) off, (200, -50); at 900 the second moves by (0, -20) and the fourth by (200, 60): the handles at the third
# are parallel at both ends, and in between their cross product is 4000 t (1 - t). Glyph 2 is composed of others.
bytes >kink.ttf <<'HEX'
00010000000900000000000068656164000000000000009c000000366868656100000000000000d200000024686d747800000000000000f60000
00086d61787000000000000000fe000000206c6f6361000000000000011e00000010676c7966000000000000012e000000486676617200000000
000001760000002467766172000000000000019a0000003c6176617200000000000001d60000001a000000000000000000000000000000000000
03e80000000000000000000000000000000000000000000000000000000000000001000000010000000000000000000000000000000000000000
00000000000000000000000000010000000000000000000100000003000000000000000000000000000000000000000000000000000000000000
0000000000000028000000480001000000000000000000040000010001000100000000006400640000ffce003200000000ffce00ffff00000000
0000000000a10001012c000040000000000040000000000101020001000000100002000100140000000877676874006400000064000003840000
000000000001000000010000000000240003000100000024000000000000000000000018000000180001000a000da000400000824000c8848000
ec80003c840000010000000000010004c000c000000000002000100040004000
HEX
# The same outline, which moves in a region of four axes.
bytes >four.ttf <<'HEX'
00010000000800000000000068656164000000000000008c000000366868656100000000000000c200000024686d747800000000000000e60000
00066d61787000000000000000ec000000206c6f6361000000000000010c0000000c676c79660000000000000118000000286676617200000000
00000140000000606776617200000000000001a00000003e00000000000000000000000000000000000003e80000000000000000000000000000
00000000000000000000000000000000000100000001000000000000000000000000000000000000000000000000000000000000000000010000
00000000000100000002000000000000000000000000000000000000000000000000000000000000000000000000002800010000000000000000
00040000010001000100000000006400640000ffce003200000000ffce0000010000001000020004001400000008776768740064000000640000
038400000000000077647468003200000064000000c80000000000006f70737a00080000000800000090000000000000736c6e74fff600000000
00000000000000000000000100000004000000000020000200010000002000000000000000000000001e00010010000da000400040004000c000
00824000c8848000ec80003c8400
HEX
LC_ALL=C sed 's/fvar/fvax/' kink.ttf >not_variable.ttf
LC_ALL=C sed 's/gvar/gvax/' kink.ttf >other_outlines.ttf

# The largest kink is near 3 degrees, in the middle; without a requirement that is only told.
run 0 verify kink.ttf --all-instances
says out "axes: wght from 100 to 900 (100)" "3 glyphs (1 of them composed of other ones), 3 joins: 2 corners at the default" \
  "0 in no instance above 0.5 degrees" "1 above it in some instance, 0 undecided" "(100, 0)"
holds grep -qE '0 +2 +\(100, 0\) +\[3\.0[0-9], 3\.0[0-9]\] degrees +wght 566\.667 +0 +' out
run 1 verify kink.ttf --all-instances --max-kink 2.5
says out "1 of them not within 2.5 degrees, and 0 not proved to be"
run 0 verify kink.ttf --all-instances --max-kink 3.5
says out "1 in no instance above 3.5 degrees" "no instance has a kink above 3.5 degrees, proved"
run 0 verify kink.ttf --all-instances --kink-angle 3.5 --max-kink 89

# JSON: of one font, and of several.
run 1 verify kink.ttf --all-instances --max-kink 2 --json
valid out
says out '"summary":{"glyphs":3,"joins":3,"corners":2,"no_direction":0,"not_covered":0,"proved":0,"refuted":1,' \
  '"verdict":"refuted","angle_degrees":[3.0' '"instance":{"wght":"1700/3"}' '"default_angle_degrees":[0,0]' '"composites":1' \
  '"axes":[{"tag":"wght","minimum":100,"default":100,"maximum":900}]' '"max_kink":"2","met":false' '"outline_point":2'
run 0 verify kink.ttf not_variable.ttf --all-instances --json
valid out
says out '{"fonts":[' '"file":"kink.ttf"' '"not_verified":[{"file":"not_variable.ttf","reason":"not covered: not a variable font"}]' \
  '"summary":{"fonts":1,"joins":3,'

# SARIF and JUnit, which test_formats.sh validates for other files.
run 1 verify kink.ttf not_variable.ttf --all-instances --max-kink 2 --format sarif
says out '"ruleId":"kink"' '"level":"error"' "largest kink [3.0" "glyph glyph00001, contour 0, point 2" "not covered: not a variable font" \
  '"instance":{"wght":"1700/3"}'
if command -v python3 >/dev/null; then holds python3 -m json.tool out /dev/null; fi
run 0 verify kink.ttf --all-instances --max-kink 4 --format sarif
lacks out '"ruleId":"kink"'
run 1 verify kink.ttf --all-instances --max-kink 2 --format junit
says out '<failure' "glyph00001"
run 1 verify kink.ttf --all-instances --max-kink 2 --format junit --worst 0
says out "1 more join not proved to stay within the bound"
if command -v xmllint >/dev/null; then holds xmllint --noout out; fi

# What is not covered is named, and is not met with --strict.
run 2 verify not_variable.ttf --all-instances
says out "not_variable.ttf: not covered: not a variable font" "no join, nothing was decided"
run 0 verify not_variable.ttf --all-instances --allow-empty
run 0 verify kink.ttf other_outlines.ttf --all-instances
says out "other_outlines.ttf: not covered: a variable font without TrueType outlines"
run 1 verify kink.ttf other_outlines.ttf --all-instances --strict
run 0 verify four.ttf --all-instances
says out "1 not covered: more than 3 axes"
run 1 verify four.ttf --all-instances --max-kink 5 --strict
mkdir fonts && cp kink.ttf not_variable.ttf fonts && printf 'wOFF' >fonts/packed.woff && head -c 300 kink.ttf >fonts/cut.ttf
run 0 verify fonts --all-instances
says out "kink.ttf" "packed.woff: not covered: a packed font (WOFF)" "not_variable.ttf: not covered" "cut.ttf: font: its table"
run 0 verify fonts --all-instances --json
valid out

# A glyph that is malformed does not hide the others.
LC_ALL=C sed 's/\x82\x40\x00\xc8/\xc2\x40\x00\xc8/' kink.ttf >unread.ttf
holds [ "$(cmp -l kink.ttf unread.ttf | wc -l)" -eq 1 ]
run 1 verify unread.ttf --all-instances --strict --allow-empty
says out "glyph glyph00001: not verified, table 'gvar', glyph 1: a run of movements is of an unknown form"
run 0 verify unread.ttf --all-instances --json --allow-empty
valid out
says out '"not_verified":[{"index":1,"name":"glyph00001","reason":"table ' '"summary":{"glyphs":2,'
run 0 verify unread.ttf --all-instances --format sarif --allow-empty
says out "glyph glyph00001" "a run of movements" '"level":"warning"'

# Bad input.
run 2 verify fonts/cut.ttf --all-instances
says err "malformed_input: fonts/cut.ttf: font: its table"
run 2 verify "$S" --all-instances
says err "--all-instances: only for fonts"
run 2 verify kink.ttf --max-kink 1
says err "--max-kink: only with --all-instances"
for angle in 0 90 -1 x; do
  run 2 verify kink.ttf --all-instances --max-kink=$angle
  says err "--max-kink: "
done
run 2 verify kink.ttf --all-instances --require G1
says err "--require: not with --all-instances"
run 2 verify kink.ttf --all-instances --glyphs nowhere
says err "nowhere"

# Damaged fonts end with a report or a reason, never in another way.
size=$(wc -c <kink.ttf) bad=0
for ((i = 0; i < size; i += 7)); do
  { head -c "$i" kink.ttf && printf '\xff' && tail -c +$((i + 2)) kink.ttf; } >damaged.ttf
  timeout 20 "$program" verify damaged.ttf --all-instances >out 2>err
  [ $? -le 2 ] || bad=$((bad + 1))
done
holds [ "$bad" -eq 0 ]
