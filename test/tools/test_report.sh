#!/usr/bin/env bash
# report: what stands in the page, and that nothing of the input is more than text.
. "$(dirname "$0")/functions.sh"

# data FILE: the block of data of a page; script FILE, style FILE: what their hashes are for
data() { sed -n '/<script type="application\/json" id="data">/,/<\/script>/p' "$1" | sed '1s/^.*id="data">//; $s/<\/script>$//'; }
between() { tr '\n' '\001' <"$3" | sed "s/.*$1\(.*\)$2.*/\1/" | tr '\001' '\n'; } # BEGIN END FILE
count() { grep -oF -- "$1" "$2" | wc -l; } # TEXT FILE
has_no() { ! grep -qE -- "$1" "$2"; }      # PATTERN FILE
# page ARGUMENTS...: the page page.html and its data
page() { run 0 report "$@" -o page.html && data page.html >data.json; }
cubic_2() { printf '100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1\n%s\n' "$1"; }

# bad input leaves no page
no_page() { holds [ ! -e no.html ]; }
cp "$S" chain.g2
run 2 report -o no.html && says err "report: no file is given"
run 2 report chain.g2 && says err "report: -o REPORT.html is needed"
run 2 report chain.g2 -o no.svg && says err "no.svg: the page is HTML"
run 2 report missing.g2 -o no.html && says err "cannot_read_file: missing.g2" && no_page
run 2 report "$S" "$data/leaf_inkscape.svg" -o no.html && says err "are not shown on one page" && no_page
run 2 report "$teapot" -o no.html && says err "spline surface" && no_page
run 2 report --surfaces "$S" -o no.html && no_page
for bad in 0 50001; do run 2 report "$S" --worst $bad -o no.html && says err "--worst: $bad is not from 1 to 50000" && no_page; done
for bad in 0 180 -1 x 5deg ''; do run 2 report "$S" --kink-angle "$bad" -o no.html && says err "--kink-angle: " && no_page; done
run 2 report "$data/leaf_inkscape.svg" --closed -o no.html && says err "--closed: not for drawings"
run 2 report "$teapot" --surfaces --closed -o no.html && says err "--closed: not with --surfaces"
run 2 report "$S" --glyphs a -o no.html && says err "--glyphs: only for fonts"
run 2 report "$S" --off-by 2 -o no.html && says err "--off-by: only for fonts"
{ cubic_2 $'0 0\n1 0\n2 0\n3 0' && cubic_2 $'3 0\n4 0\n5 0\n1e400 0'; } >huge.g2
for bad in '' javascript:alert 'page.html#join' data:text/html,x; do run 2 report "$S" --page "$bad" -o no.html && says err "--page: " && no_page; done
run 2 report "$teapot" --surfaces --page page.html -o no.html && says err "--page: not with --surfaces"
run 2 report huge.g2 -o no.html && says err "not_finite" && no_page
printf '<svg>\n<path d="M0 0h1"></svg>' >broken.svg && run 2 report broken.svg -o no.html && says err "broken.svg:2: " && no_page

# grades and bounds: a handle of 100 that is off by 1, a corner, a smooth join, a jump of the
# curvature, a gap
{
  cubic_2 $'-300 0\n-200 0\n-100 0\n0 0' && cubic_2 $'0 0\n100 1\n200 10\n300 50' && cubic_2 $'300 50\n200 50\n100 60\n0 60'
  cubic_2 $'0 60\n-100 60\n-200 50\n-300 50' && cubic_2 $'-300 50\n-400 50\n-500 0\n-600 0' && cubic_2 $'-600 7\n-700 7\n-800 7\n-900 7'
} >grades.g2
page grades.g2
says data.json '"counts":{"gap":1,"kink":1,"corner":1,"G0":0,"undecided":0,"G1":1,"G2":1}'
says data.json '"angle":["0.572938","0.572939"]' '"gap":["7","7"]' '"offset":["0.99995","0.999951"]' # arctan(1/100), 1/sqrt(1.0001)
says data.json '"grade":"G1","place":"curve 3 - curve 4"' '"jump":["119.999","120.001"]' '"grade":"G2","place":"curve 2 - curve 3"'
holds [ "$(grep -o '"grade":"[a-zA-Z0-9]*"' data.json | tr -d '\n')" = \
  '"grade":"gap""grade":"kink""grade":"corner""grade":"G1""grade":"G2"' ]
page grades.g2 --kink-angle 0.57 && says data.json '"kink":0,"corner":2'
page grades.g2 --closed && says data.json '"gap":2' '"place":"curve 5 - curve 0"'
page grades.g2 --worst 2 && says err "the page shows the worst 2 of 5; --worst N shows more"
says data.json '"gap":1,"kink":1,"corner":1' "The page shows the worst 2 of 5; 3 are left out."
holds [ "$(grep -c '"number":' data.json)" -eq 2 ]
# the worst of many kinks, which come in any order: handles of 10 that are off by 1, 2, 3 and so on
order="3 9 1 7 5 8 2 6 4"
for k in $order; do cubic_2 $'0 0\n10 0\n20 0\n30 0' && cubic_2 "30 0"$'\n'"130 $k"$'\n230 0\n0 0'; done >many.g2
numbers() { grep -o '"number":[0-9]*,"grade":"kink"' data.json | tr -dc '0-9\n' | tr '\n' ' '; }
expected() { for k in 9 8 7 6 5 4 3 2 1; do echo $order | tr ' ' '\n' | grep -n $k; done | sed 's/:.*//' | awk '{ print 2 * $1 - 1 }' | head -n "$1" | tr '\n' ' '; }
page many.g2 --kink-angle 9 && holds [ "$(numbers)" = "$(expected 9)" ]
page many.g2 --kink-angle 9 --worst 4 && holds [ "$(numbers)" = "$(expected 4)" ] && holds [ "$(grep -c '"number":' data.json)" -eq 4 ]
run 0 report grades.g2 -o - && cp out standard.html && run 0 report grades.g2 -o page.html && holds cmp -s standard.html page.html
holds [ ! -s err ]

# in space, and rational curves
page "$L" --closed && says data.json '"dimension":3'
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >space.g2 && cubic $'3 0 0\n4 0 0.01\n5 1 1\n6 3 3' >>space.g2
page space.g2 && says data.json '"grade":"kink"' '"angle":["0.572938","0.572939"]'
page space.g2 --kink-angle 0.5729386976834859 && says data.json '"grade":"corner"' # less than arctan(1/100), by less than 10^-15
page space.g2 --kink-angle 0.5729386976834860 && says data.json '"grade":"kink"'
printf '100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n1 0 1\n1 1 1\n0 2 2\n100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n0 1 1\n-1 1 1\n-2 0 2\n' >circle.g2
page circle.g2 && says data.json '"grade":"G2"' '"weights":[1,1,2]'
printf '100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n1 0 1\n0 1 0\n-1 0 1\n100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n-1 0 1\n0 -1 0\n1 0 1\n' >halves.g2
page halves.g2 && says data.json '"points":[1,0,1,2,-1,2,-1,0],"weights":[1,0.333' # an infinite control point, with the degree 3
{ cubic_2 $'0 0\n1 0\n2 0\n3 0' && cubic_2 $'3 0\n3 0\n4 1\n5 5'; } >retracted.g2
page retracted.g2 && says data.json '"grade":"corner"' '"angle":["44.9999","45.0001"]' # the first leg that is not zero
{ cubic_2 $'0 0\n1 0\n2 0\n3 0' && cubic_2 $'3 0\n3 0\n4 0\n5 5'; } >retracted.g2
page retracted.g2 && says data.json '"grade":"G1"' "one tangent, and a handle lies on the node"

# the same decisions as those of verify
summary_of_teapot="24 G2, 20 G1, 8 G0 (8 vanishing normals), 16 boundary, 8 collapsed"
page --surfaces "$teapot" && says data.json '"G0":8,"undecided":0,"G1":20,"G2":24' "$summary_of_teapot"
run 0 verify --surfaces "$teapot" --allow-undecided --allow-uncovered && says out "$summary_of_teapot"
flat "$flat_points" >flat.g2
flat $'0 0 1 1\n4 0 0\n5 0 0.01\n6 0 0\n7 0 0\n8 0 0\n4 1 0\n5 1 0.01\n6 1 0\n7 1 0\n8 1 0' >kink.g2
page --surfaces flat.g2 kink.g2 && says data.json '"grade":"kink","place":"surface 0, edge u1 - surface 1, edge u0"' '"angle":["0.572938","0.572939"]'
page --surfaces flat.g2 kink.g2 --kink-angle 0.5 && says data.json '"grade":"corner","place":"surface 0, edge u1 - surface 1, edge u0"'
page --surfaces flat.g2 kink.g2 --kink-angle 0.57293869768348593 # which lies between the bounds
says data.json '"undecided":2' '"verdict":"G0, the tangent planes differ: the largest angle of a kink lies between the bounds"' \
  '"undecided":[{"what":"join","reason":"the largest angle of a kink lies between the bounds","count":2}]'
page "$data/leaf_inkscape.svg" && says data.json '"down":true' 'circle \"dew\" (line 82), repeated by use \"use1\" (line 97)'
svg '<use href="#none"/><path d="M0 0h1v1"/>' && page drawing.svg && says data.json 'use (line 2): not verified' \
  '"not_covered":[{"what":"element","reason":"there is no element \"none\" in this file to repeat","count":1}]' "; 1 not covered"
page "$data/leaf_inkscape.svg"

run 0 verify "$data/leaf_inkscape.svg" --allow-undecided --allow-uncovered && says out "drawn as 2 corners, 1 kink of at most 5 degrees, 12 G1, 13 G2 or more"
says data.json '"counts":{"gap":0,"kink":1,"corner":2,"G0":0,"undecided":0,"G1":12,"G2":13}'
svg "$undecided_path" && page drawing.svg && says data.json "a rotated ellipse, whose tangent differs by too little" '"undecided":1' '"angle":["0","3.39184e-151"]'
page "$data/badge_illustrator.svg" && says data.json '"undecided":0'
svg '<path d="M0 0h1a1 1 0 0 1 2 0M0 5h20a1000 10 0 0 1 10 10"/>' && page drawing.svg # a half circle, and a large arc that is flat
says data.json '"grade":"corner","place":"path (line 2), subpath 1, commands 2 h - 3 a"' '"angle":["89.9999","90.0001"]'

# fonts: in parts of an em, and by glyphs
cat >glyphs.txt <<'END'
glyph .notdef
glyph <script>alert(1)</script> 65
contour 0,0 100,0 200,1 200,300 0,300
glyph smooth 66
contour 0,1* 101,0* 200,101* 103,200*
glyph off 67
contour 0,0 300,20 600,20 900,0 600,-500 300,-500
contour 2000,0 2100,0 2200,7* 2300,300 2000,300
contour 3000,0 3100,0 3200,5* 3300,300 3000,300
contour 4000,0 4100,0 4150,1* 4300,300 4000,300
glyph both 68
component 3 0 10
component 1 5000 0
END
font test.ttf <glyphs.txt
page test.ttf && says data.json '"whole":"em"' '"counts":{"kink":4,"bend":4,"rounding":4,"corner":34,"G1":4,"G2":0}'
says data.json '"grade":"rounding","place":"glyph \u003cscript\u003ealert(1)\u003c/script\u003e, contour 0, node 1"' '"severity":"1"'
says data.json '"angle":["0.572938","0.572939"]' '"summary":"1 font, 5 glyphs (1 empty), 50 joins: 34 corners, 4 kinks, 4 bends of two lines, 4 off by rounding, 4 G1, 0 G2 or more"'
says data.json '"place":"glyph both, in its component off, contour 1, node 1"'
# the worst first, by units, curves before lines
page test.ttf --glyphs off
holds [ "$(grep -o '"grade":"[a-z]*","place":"glyph off, contour [0-9], node [0-9]"' data.json | sed 's/.*":"\(.*\)","place":"glyph off, contour \(.\), node \(.\)"/\1 \2 \3/' | head -5 | tr '\n' ,)" = \
  "kink 1 1,kink 2 1,bend 0 1,bend 0 2,rounding 3 1," ]
font fine.ttf -v em=2048 -v family=Fine <glyphs.txt # parts of the em are half as large
page test.ttf fine.ttf --glyphs off
holds [ "$(grep -o '"place":"[A-Za-z ]*: glyph off, contour [12], node 1"' data.json | cut -d'"' -f4 | tr '\n' ';')" = \
  "Test Regular: glyph off, contour 1, node 1;Fine Regular: glyph off, contour 1, node 1;Test Regular: glyph off, contour 2, node 1;Fine Regular: glyph off, contour 2, node 1;" ]
# the words, counts and classes of verify on the same fonts
same_counts() { # CODE ARGUMENTS...
  page "${@:2}" && run "$1" verify "${@:2}" --json --allow-empty
  checks=$((checks + 1))
  local verified shown
  verified=$(tr -d '\n' <out | sed 's/.*"summary":{//; s/}.*//' |
    sed 's/.*"joins":\([0-9]*\),"corners":\([0-9]*\),"kinks":\([0-9]*\),"kinks_off[a-z_]*":[0-9]*,"bends":\([0-9]*\),"rounding":\([0-9]*\),"G1":\([0-9]*\),"G2":\([0-9]*\)$/\1 \3 \4 \5 \2 \6 \7/')
  shown=$(sed -n 's/.*"total":\([0-9]*\),"counts":{"kink":\([0-9]*\),"bend":\([0-9]*\),"rounding":\([0-9]*\),"corner":\([0-9]*\),"G1":\([0-9]*\),"G2":\([0-9]*\)}.*/\1 \2 \3 \4 \5 \6 \7/p' data.json)
  if [ -z "$shown" ] || [ "$verified" != "$shown" ] || [ "$(grep -o '"claims":.*' data.json | tr -d ',')" != "$(grep -o '"claims":.*]}' out | tr -d ',')" ]; then
    failures=$((failures + 1))
    echo "report ${*:2}: $shown, verify: $verified"
    grep -h '"claims"' data.json out
  fi
  run "$1" verify "${@:2}" --allow-empty --worst 0
  says data.json "$(grep -o '[0-9]* glyphs\?[ ,].* joins\?.*' out | sed 's/; .*//' | tail -1)" # of all fonts
}
mkdir fonts && cp test.ttf fonts && head -c 300 test.ttf >fonts/broken.ttf
font fonts/other.woff -v outlines=cff -v container=woff <glyphs.txt
font fonts/test.ttc -v container=ttc <glyphs.txt
printf 'glyph .notdef\nglyph alone\ncontour 0,0 9,0 9,9' | font alone.ttf
for options in "" "--off-by 0" "--off-by 0.9999" "--off-by 6" "--off-by 100" "--kink-angle 3" "--glyphs A-C" "--glyphs off,both"; do
  same_counts 0 test.ttf $options
  same_counts 1 fonts $options
done
same_counts 1 test.ttf alone.ttf --glyphs smooth,alone
for bad in -1 x ''; do run 2 report test.ttf --off-by "$bad" -o no.html && says err "--off-by: " && no_page; done
page test.ttf --glyphs smooth && says data.json '"kink":0,"bend":0,"rounding":0,"corner":0,"G1":4,"G2":0}'
run 2 report test.ttf --glyphs none -o no.html && says err "none" && no_page
head -c 300 test.ttf >broken.ttf && run 2 report broken.ttf -o no.html && says err "malformed_input: broken.ttf" && no_page

# texts are texts: names, titles, files
evil='</script><script>alert(1)</script><!--'
name='<img src=x onerror=alert(1)>&.svg'
escaped='&lt;/script>&lt;script>alert(1)&lt;/script>&lt;!--&amp;&#x2028;&#x2029;&#x202e;&quot;'
svg "<path id=\"$escaped\" d=\"M0 0h100C200 1 300 10 300 50\"/><use id=\"$escaped\"/>"
cp drawing.svg "$name"
page "$name" --title "$evil"$'\n\u2028\xff'
says data.json '"title":"\u003c/script\u003e\u003cscript\u003ealert(1)\u003c/script\u003e\u003c!--\\n\\u2028'
says data.json 'path \"\u003c/script\u003e\u003cscript\u003ealert(1)\u003c/script\u003e\u003c!--\u0026\\u2028\\u2029\\u202e\"'
holds has_no '[<>&]' data.json
holds [ "$(count '<script' page.html)" -eq 2 ] && holds [ "$(count '</script' page.html)" -eq 2 ]
holds has_no 'alert\(1\)<' page.html
page "$name" drawing.svg && says data.json '"place":"\u003cimg src=x onerror=alert(1)\u003e\u0026.svg: path'
if command -v python3 >/dev/null; then
  for arguments in "grades.g2" "circle.g2" "--surfaces $teapot" "$data/leaf_inkscape.svg" "drawing.svg" "test.ttf"; do
    page $arguments
    holds python3 -c 'import json,sys; d = json.load(open("data.json")); n = len(d["curves"])
assert all("edge" in j and j["edge"] < len(d["model"]["edges"]) or j["left"] < n and j["right"] < n for j in d["joins"])
assert len(d["joins"]) == d["total"] == sum(d["counts"].values())'
  done
fi

# the page needs nothing else, and executes nothing else
page "$data/leaf_inkscape.svg"
holds has_no '(src|href) *=|https?:|url\(|@import|fetch\(|XMLHttpRequest|WebSocket|innerHTML|eval\(' page.html
says page.html "default-src 'none'"
hash() { # TEXT: SHA-256 in base 64, as policies have it
  printf '%b' "$(printf '%s' "$1" | sha256sum | cut -c1-64 | sed 's/../\\x&/g')" | base64
}
holds has_no 'sha256-[^A-Za-z0-9+/=]' page.html
end=$'\n'x # command substitutions drop line ends
script=$(between '<script>' '<\/script>' page.html && echo x) style=$(between '<style>' '<\/style>' page.html && echo x)
says page.html "script-src 'sha256-$(hash "${script%$end}"$'\n')'" "style-src 'sha256-$(hash "${style%$end}"$'\n')'"
holds [ "$(wc -c <page.html)" -lt 100000 ]
