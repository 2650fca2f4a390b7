#!/usr/bin/env bash
# verify --all-instances: the largest kinks of variable fonts between the masters, what is undecided
# and what is not covered.
schemas=$(cd "$(dirname "$0")" && pwd)/schemas
. "$(dirname "$0")/functions.sh"

# valid FILE: the file is JSON as the schema says, where python3 and its jsonschema are there
valid() {
  python3 -c "import jsonschema" 2>/dev/null || return
  holds python3 -c 'import json, sys; from jsonschema import Draft7Validator as V; V(json.load(open(sys.argv[1]))).validate(json.load(open(sys.argv[2])))' \
    "$schemas/instances.json" "$1"
}
bytes() { printf '%b' "$(tr -d '\n' | sed 's/../\\x&/g')"; } # from hexadecimal digits

# An axis wght from 100 to 900 whose upper half is stretched by 'avar'. Glyph 1 has the points (0,
# -50), (0, 0) off the curve, (100, 0), (200, 0) off, (200, -50); at 900 the second moves by (0,
# -20) and the fourth by (200, 60): the handles at the third are parallel at both ends, and in
# between their cross product is 4000 t (1 - t). Glyph 2 is composed of others.
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
# A kink in a baseline is known, and a larger kink is new: the fourth point moves by (200, 70).
LC_ALL=C sed 's/\xec\x80\x00\x3c\x84/\xec\x80\x00\x46\x84/' kink.ttf >larger.ttf && holds [ "$(cmp -l kink.ttf larger.ttf | wc -l)" -eq 1 ]
kinks() { run "$1" verify known.ttf --all-instances --max-kink 2 "${@:2}"; }
cp kink.ttf known.ttf && kinks 1 --format sarif && mv out base.sarif && says base.sarif '"measure":{"quantity":"angle_degrees","bounds":['
kinks 0 --baseline base.sarif --json && says out '{"findings":[],'
cp larger.ttf known.ttf && kinks 1 --baseline base.sarif --json && says out '{"rule":"kink"' && kinks 1 --format sarif && mv out base.sarif
cp kink.ttf known.ttf && kinks 0 --baseline base.sarif
# The next font has the same outline, which moves in a region of four axes.
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
# Glyph 1 as in kink.ttf; glyph 2 is that one half as wide, glyph 3 half as wide and high; in glyph
# 4 the handle before (100, 0) has no length at 100. The same font packed as WOFF and WOFF2.
bytes >parts.ttf <<'HEX'
000100000009008000030010667661727bc56992000001c800000024676c7966348233e50000013000000056677661723d823c7e000001ec0000
0044686561642e3332560000009c000000366868656100c900ca000000d400000024686d747800c80000000001180000000c6c6f6361002b0041
000001240000000c6d6178700009000d000000f800000020706f737455d0b5bd000001880000003e000100000001000011a955805f0f3cf50003
03e8000000000000000000000000000000000000ffce00c800000000000300020000000000000001000000000000000000c80000000000c80001
00000000000000000000000000000001000100000005000500010005000100020000000000000000000000000001000100c80000000000000000
000000000000000c0016001f002b00010000ffce00c800000004000015343332156464323232ffff0000ffce0064000000460001000020004000
ffff0000ffe700640000000e00010000200000010000ffce00c80000000400001536313215646432323200000002000000000000000000000000
000000000000000000000000000000000000000500000102010301040013046b696e6b066e6172726f7705736d616c6c00000001000000100002
00010014000000087767687400640000006400000384000000000100000100000001000100000020000500000000002200000000000a000a000a
0011400080010008000b000000824000c8848002ec003c848001000800050000008000ce8688
HEX
bytes >parts.woff <<'HEX'
774f46460001000000000228000900000000023000010000000000000000000000000000000000000000000066766172000001c8000000240000
00247bc56992676c79660000015c0000003e00000056348233e567766172000001ec0000003a000000443d823c7e68656164000000e000000036
00000036c32ed7426868656100000118000000130000002400c900ca686d7478000001440000000c0000000c00c800006c6f6361000001500000
000c0000000c002b00416d6178700000012c00000018000000200009000d706f73740000019c000000290000003e55d0b5bd0001000000010000
e7b20ba85f0f3cf5000303e8000000007c259dc000000000e729f8d40000ffce00c80000000000030002000000000000789c6360648081135012
2102018c0022b9019400789c63606460606005424630666240068c0c8c0001fc001700c80000000000000000000000000000000c0016001f002b
789c63606460f87f8ee1040303030b0383a889b191684a8a9191d1ffff60f114a0b81b03508d0283030358ec39588c0f22c680aadbcc10aa1b00
602212c40000789c636062c00f581918189918991959188459b233f3b2d9f2128b8af2cb598b73137372003d4c06950000000001000000100002
00010014000000087767687400640000006400000384000000000100789c6360646060606400910a0cac0c20a00426b9c050d081a18191818381
1b28d2e4c070a2a581e90d834d0b580ca4ba81e15c5b0700965308740000
HEX
bytes >parts.woff2 <<'HEX'
774f4632000100000000011c0009000000000230000000d80001000000000000000000000000000000000000000000002f240a586d3044013602
24030c0b0c000420073e1b9801f89f07b6ad687d249418cbe503c55d3cfcb3f6ebbe11cc4f176f30194b5a8a89e53ce9276043644b9b0658ec64
5ff5f80988089c9b3c546522d08b4c7340a04322f4a0e17a7be7c20636483f20801c342141135ad1851e40545555893cf7da1cff2245b1b15128
d6276c14cc097acdd226e8350eaa9a0da8fe6c201002bd72d00f9a3469d239eb253468c6dbacf24372931f42831c2f6a5f09043b0fb74bcbed93
1ad2f43f3c0c6df81bfb4d55538254020240094a010008250002b95cc88504008490d03991441a99ee6c7ff768bfeee63bbece43
HEX
# The drawing of kink.ttf in cubic curves of CFF2, with the same legs at (100, 0), which is point 3.
bytes >cubic.otf <<'HEX'
4f54544f000700400002003043464632bd77456b0000010800000065667661727bc569920000017000000024686561642e3332560000007c0000
00366868656100c900ca000000b400000024686d747800c80000000000e0000000066d61787000025000000000d800000006706f737400030000
000000e8000000200001000000010000cf7e20a55f0f3cf5000303e8000000000000000000000000000000000000ffce00c80000000000030002
0000000000000001000000000000000000c80000000000c8000100000000000000000000000000000001000050000002000000c8000000000000
00030000000000000000000000000000000000000000000000000000000000000200050007e60c24bb119b1800000000001e00010000000c0001
0000001600010001000040004000000000000001000000000002010101248b59158b958bb3ef8b8b8b8b778b9f911008ef8b8b818b63f75cc7fb
5c4f8b8b911008000000010101048bf012000000000100000010000200010014000000087767687400640000006400000384000000000100
HEX
LC_ALL=C sed 's/fvar/fvax/' kink.ttf >not_variable.ttf
LC_ALL=C sed 's/gvar/gvax/' kink.ttf >other_outlines.ttf
# The table 'avar' of version 2.
LC_ALL=C sed 's/\x00\x01\x00\x00\x00\x00\x00\x01\x00\x04\xc0\x00/\x00\x02\x00\x00\x00\x00\x00\x01\x00\x04\xc0\x00/' kink.ttf >avar2.ttf

# The largest kink is near 3 degrees, in the middle; without a requirement that is only told.
run 0 verify kink.ttf --all-instances
says out "axes: wght from 100 to 900 (100)" "3 glyphs (1 of them composed of other ones), 3 joins: 2 corners at the default" \
  "0 in no instance above 0.5 degrees" "1 above it in some instance, 0 undecided" "(100, 0)"
holds grep -qE '0 +2 +\(100, 0\) +\[3\.0[0-9], 3\.0[0-9]\] degrees +wght 566\.667 +0 +' out
run 1 verify kink.ttf --all-instances --max-kink 2.5
says out "1 of them not within 2.5 degrees in every instance"
run 0 verify kink.ttf --all-instances --max-kink 3.5
says out "1 in no instance above 3.5 degrees" \
  "every join that is no corner at the default instance is within 3.5 degrees in every instance, proved"
run 0 verify kink.ttf --all-instances --kink-angle 3.5 --max-kink 89

# JSON: of one font, and of several.
run 1 verify kink.ttf --all-instances --max-kink 2 --json
valid out
says out '"summary":{"glyphs":3,"joins":3,"corners":2,"no_direction":0,"not_covered":0,"proved":0,"refuted":1,' \
  '"verdict":"refuted","angle_degrees":[3.0' '"instance":{"wght":"1700/3"}' '"default_angle_degrees":[0,0]' '"composites":1' \
  '"axes":[{"tag":"wght","minimum":100,"default":100,"maximum":900}]' '"max_kink":"2","met":false' '"outline_point":2'
run 1 verify kink.ttf not_variable.ttf --all-instances --json
valid out
says out '{"fonts":[' '"file":"kink.ttf"' '"not_verified":[{"file":"not_variable.ttf","reason":"not a variable font"}]' \
  '"summary":{"fonts":1,"joins":3,' '"claims":{"given":4,"decided":3,"not_met":0,"undecided":[],' \
  '"not_covered":[{"what":"font","reason":"not a variable font","count":1}]}'
run 0 verify kink.ttf kink.ttf --all-instances --max-kink 4 --allow-uncovered --json
says out '"claims":{"given":3,"decided":3,"not_met":0,"undecided":[],"not_covered":[]},' '"max_kink":"4","met":true'

# SARIF and JUnit, which test_formats.sh validates for other files.
run 1 verify kink.ttf not_variable.ttf --all-instances --max-kink 2 --format sarif
says out '"ruleId":"kink"' '"level":"error"' "largest kink \\\\[3.0" "glyph glyph00001, contour 0, point 2" "not covered, not a variable font" \
  '"instance":{"wght":"1700/3"}'
if command -v python3 >/dev/null; then holds python3 -m json.tool out /dev/null; fi
run 0 verify kink.ttf --all-instances --max-kink 4 --format sarif
lacks out '"ruleId":"kink"'
run 1 verify kink.ttf --all-instances --max-kink 2 --format junit
says out '<failure' "glyph00001"
if command -v xmllint >/dev/null; then holds xmllint --noout out; fi

# Outlines of CFF2, and packed fonts.
run 0 verify cubic.otf --json && says out '"joins":3,"corners":2,"kinks":0,' # the default instance
run 0 verify cubic.otf --all-instances --max-kink 3.5
run 1 verify cubic.otf --all-instances --max-kink 2.5
says out "3 joins: 2 corners at the default" "(100, 0)  [3.0"
holds grep -qE '0 +3 +\(100, 0\) +\[3\.0' out
run 1 verify parts.ttf --all-instances
grep -v parts.ttf out >unpacked
for file in parts.woff parts.woff2; do # WOFF2 where FreeType has brotli
  "$program" verify $file --all-instances >out 2>err
  code=$?
  if [ $file = parts.woff2 ] && grep -q "unimplemented feature" err; then continue; fi
  holds [ $code -eq 1 ]
  says out "$file"
  grep -v "$file" out >packed
  holds cmp -s packed unpacked
done

# A part that is stretched has other angles; one of the same shape has those of the glyph that it
# is, also when only the composite glyph is asked for. A handle of no length at the default instance
# is in no class that is decided.
says unpacked "5 glyphs (2 of them composed of other ones), 9 joins: 6 corners" "2 above it" "narrow, part kink" "[5.8" \
  "not covered: 1 join, a handle has no length at the default instance"
run 1 verify parts.ttf --all-instances --glyphs narrow --max-kink 5
run 0 verify parts.ttf --all-instances --glyphs narrow --max-kink 7
run 1 verify parts.ttf --all-instances --glyphs small --max-kink 2
run 0 verify parts.ttf --all-instances --glyphs small --max-kink 4
run 1 verify parts.ttf --all-instances --max-kink 10
says out "not met, because not all was decided (see --allow-uncovered)"
lacks out "proved"
run 0 verify parts.ttf --all-instances --max-kink 10 --allow-uncovered
says out "every join that is no corner at the default instance that was decided is within 10 degrees in every instance, proved"
run 1 verify parts.ttf --all-instances --max-kink 10 --json
valid out
says out '"part":"kink"' '"met":false' '"not_covered":[{"what":"join","reason":"a handle has no length at the default instance","count":1}]'

# More than three axes. Beyond the work that is allowed a join is undecided, and that is never
# called proved.
run 0 verify four.ttf --all-instances --max-kink 3.5
says out "1 in no instance above 3.5 degrees" "0 undecided" "every join that is no corner"
run 1 verify four.ttf --all-instances --max-kink 2.5
run 1 verify four.ttf --all-instances --max-kink 3.06 --max-work 1
says out "1 undecided" "undecided: 1 join, the bounds of the largest kink lie on both sides of 3.06 degrees" "--allow-undecided"
lacks out "proved"
run 1 verify four.ttf --all-instances --max-kink 3.06 --max-work 1 --format sarif
says out '"ruleId":"undecided"' '"level":"error"'
run 0 verify four.ttf --all-instances --max-kink 3.06 --max-work 1 --allow-undecided

# Things that are not covered are named.
run 2 verify not_variable.ttf --all-instances
says out "not_variable.ttf: not covered, not a variable font" "no join, nothing was decided"
run 0 verify not_variable.ttf --all-instances --allow-empty --allow-uncovered
for font in "other_outlines.ttf: not covered, a variable font without TrueType or CFF2 outlines" \
  "avar2.ttf: not covered, the table 'avar' of version 2"; do
  run 1 verify kink.ttf "${font%%:*}" --all-instances
  says out "$font"
  run 0 verify kink.ttf "${font%%:*}" --all-instances --max-kink 4 --allow-uncovered
done
mkdir fonts && cp kink.ttf not_variable.ttf fonts && printf 'wOFF' >fonts/packed.woff && head -c 300 kink.ttf >fonts/cut.ttf
run 1 verify fonts --all-instances
says out "kink.ttf" "packed.woff: not covered, " "not_variable.ttf: not covered" "cut.ttf: not covered, font: its table"
run 0 verify fonts --all-instances --allow-uncovered --json
valid out

# A glyph that is malformed does not hide the others.
LC_ALL=C sed 's/\x82\x40\x00\xc8/\xc2\x40\x00\xc8/' kink.ttf >unread.ttf
holds [ "$(cmp -l kink.ttf unread.ttf | wc -l)" -eq 1 ]
run 1 verify unread.ttf --all-instances --allow-empty
says out "glyph glyph00001: not covered, table 'gvar', glyph 1: a run of movements is of an unknown form"
run 0 verify unread.ttf --all-instances --json --allow-empty --allow-uncovered
valid out
says out '"not_verified":[{"index":1,"name":"glyph00001","reason":"table ' '"summary":{"glyphs":2,'
run 0 verify unread.ttf --all-instances --format sarif --allow-empty --allow-uncovered
says out "glyph glyph00001" "a run of movements" '"level":"warning"'

# Bad input.
run 2 verify fonts/cut.ttf --all-instances
says err "malformed_input: fonts/cut.ttf: font: its table"
run 2 verify "$S" --all-instances
says err "--all-instances: only for fonts"
run 2 verify "$S" --max-kink 1
says err "--max-kink: only for fonts"
for angle in 0 90 -1 x; do
  run 2 verify kink.ttf --all-instances --max-kink=$angle
  says err "--max-kink: "
done
run 2 verify kink.ttf --all-instances --require G1
says err "--require: not with --all-instances"
run 2 verify kink.ttf --all-instances --off-by 2
says err "--off-by: not with --all-instances"
run 2 verify kink.ttf --all-instances --glyphs nowhere
says err "nowhere"

# Damaged fonts end with a report or a reason, never in another way.
bad=0
for font in kink.ttf cubic.otf parts.woff2; do
  size=$(wc -c <$font)
  for ((i = 0; i < size; i += 7)); do
    { head -c "$i" $font && printf '\xff' && tail -c +$((i + 2)) $font; } >damaged.ttf
    timeout 20 "$program" verify damaged.ttf --all-instances >out 2>err
    [ $? -le 2 ] || bad=$((bad + 1))
  done
done
holds [ "$bad" -eq 0 ]
