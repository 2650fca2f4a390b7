#!/usr/bin/env bash
# verify --all-instances: the largest kinks of variable fonts between the masters, what is undecided
# and what is not covered.
. "$(dirname "$0")/functions.sh"
fonts=$here/data # as hexadecimal digits

bytes() { printf '%b' "$(tr -d '\n' | sed 's/../\\x&/g')"; }

# An axis wght from 100 to 900 whose upper half is stretched by 'avar'. Glyph 1 has the points
# (0, -50), (0, 0) off the curve, (100, 0), (200, 0) off, (200, -50); at 900 the second moves by
# (0, -20) and the fourth by (200, 60): the handles at the third are parallel at both ends, and in
# between their cross product is 4000 t (1 - t). Glyph 2 is composed of others.
bytes <"$fonts/kink_ttf.hex" >kink.ttf
# Kinks of a baseline are known, and a larger one is new: the fourth point moves by (200, 70).
LC_ALL=C sed 's/\xec\x80\x00\x3c\x84/\xec\x80\x00\x46\x84/' kink.ttf >larger.ttf && holds [ "$(cmp -l kink.ttf larger.ttf | wc -l)" -eq 1 ]
kinks() { run "$1" verify known.ttf --all-instances --max-kink 2 "${@:2}"; }
cp kink.ttf known.ttf && kinks 1 --format sarif && mv out base.sarif && says base.sarif '"measure":{"quantity":"angle_degrees","bounds":['
kinks 0 --baseline base.sarif --json && says out '{"findings":[],'
cp larger.ttf known.ttf && kinks 1 --baseline base.sarif --json && says out '{"rule":"kink"' && kinks 1 --format sarif && mv out base.sarif
cp kink.ttf known.ttf && kinks 0 --baseline base.sarif
# This is the same outline, which moves in a region of four axes.
bytes <"$fonts/four_ttf.hex" >four.ttf
# Glyph 1 as in kink.ttf; glyph 2 is that one half as wide, glyph 3 half as wide and high; in glyph
# 4 the handle before (100, 0) has no length at 100. The same font packed as WOFF and WOFF2.
bytes <"$fonts/parts_ttf.hex" >parts.ttf
bytes <"$fonts/parts_woff.hex" >parts.woff
bytes <"$fonts/parts_woff2.hex" >parts.woff2
# The drawing of kink.ttf in cubic curves of CFF2, with the same legs at (100, 0), which is point 3.
bytes <"$fonts/cubic_otf.hex" >cubic.otf
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
valid_json instances out
says out '"summary":{"glyphs":3,"joins":3,"corners":2,"no_direction":0,"not_covered":0,"proved":0,"refuted":1,' \
  '"verdict":"refuted","angle_degrees":[3.0' '"instance":{"wght":"1700/3"}' '"default_angle_degrees":[0,0]' '"composites":1' \
  '"axes":[{"tag":"wght","minimum":100,"default":100,"maximum":900}]' '"max_kink":"2","met":false' '"outline_point":2'
run 1 verify kink.ttf not_variable.ttf --all-instances --json
valid_json instances out
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
valid_json instances out
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
  answers 1 "$font" verify kink.ttf "${font%%:*}" --all-instances
  run 0 verify kink.ttf "${font%%:*}" --all-instances --max-kink 4 --allow-uncovered
done
mkdir fonts && cp kink.ttf not_variable.ttf fonts && printf 'wOFF' >fonts/packed.woff && head -c 300 kink.ttf >fonts/cut.ttf
run 1 verify fonts --all-instances
says out "kink.ttf" "packed.woff: not covered, " "not_variable.ttf: not covered" "cut.ttf: not covered, font: its table"
run 0 verify fonts --all-instances --allow-uncovered --json
valid_json instances out

# A glyph that is malformed does not hide the others.
LC_ALL=C sed 's/\x82\x40\x00\xc8/\xc2\x40\x00\xc8/' kink.ttf >unread.ttf
holds [ "$(cmp -l kink.ttf unread.ttf | wc -l)" -eq 1 ]
run 1 verify unread.ttf --all-instances --allow-empty
says out "glyph glyph00001: not covered, table 'gvar', glyph 1: a run of movements is of an unknown form"
run 0 verify unread.ttf --all-instances --json --allow-empty --allow-uncovered
valid_json instances out
says out '"not_verified":[{"index":1,"name":"glyph00001","reason":"table ' '"summary":{"glyphs":2,'
run 0 verify unread.ttf --all-instances --format sarif --allow-empty --allow-uncovered
says out "glyph glyph00001" "a run of movements" '"level":"warning"'

# Bad input.
refused "malformed_input: fonts/cut.ttf: font: its table" verify fonts/cut.ttf --all-instances
refused "--all-instances: only for fonts" verify "$S" --all-instances
refused "--max-kink: only for fonts" verify "$S" --max-kink 1
for angle in 90 -1 x; do
  refused "--max-kink: " verify kink.ttf --all-instances --max-kink=$angle
done
refused "--require: not with --all-instances" verify kink.ttf --all-instances --require G1
refused "--off-by: not with --all-instances" verify kink.ttf --all-instances --off-by 2
refused "nowhere" verify kink.ttf --all-instances --glyphs nowhere

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
