#!/usr/bin/env bash
# verify of drawings: kinks by element and command, and what is refused.
. "$(dirname "$0")/functions.sh"

leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
run 0 verify "$leaf" && says out "28 joins in 9 subpaths: 3 G0, 12 G1, 1 G2, 12 G3 or more" \
  'path "leaf" (line 50), subpath 1, commands 3 c - 4 c at (28.5, 6.25): G0, corner of 93.1 degrees' \
  'commands 2 c - 3 s at (37.1946, 48.6223): G1, curvature jumps' \
  'circle "dew" (line 82), repeated by use "use1" (line 97), subpath 1, commands 2 A - 3 A at (38, 47.5): G3 or more'
run 0 verify "$badge" && says out "31 joins in 8 subpaths: 14 G0, 11 G1, 6 G3 or more" \
  "the closing line is 27.7 long" "a handle is at the node" "commands 2 a - 3 z at (94, 20): G0, corner of 140.7 degrees"
run 0 verify "$leaf" --require G0 && says out "every join is G0, proved exactly"
run 1 verify "$leaf" --require G1 && says out "1 of them not G1" && run 1 verify "$leaf" --require C1 && says out "of them not C1"
run 0 verify "$badge" --require G0 && run 0 verify "$leaf" "$badge" && says out "59 joins in 17 subpaths" "badge_illustrator.svg: path \"ring\""
run 0 verify "$leaf" --max-order 1 && says out "3 G0, 25 G1 or more"
run 2 verify "$leaf" --require F3 && run 2 verify "$leaf" --closed && run 2 verify "$leaf" --surfaces
run 2 verify "$leaf" --kernel double && run 2 verify "$leaf" "$S" && says err "cannot be verified together"
if command -v python3 >/dev/null; then
  run 0 verify "$badge" --json --require G1
  holds python3 -c "import json; d = json.load(open('out')); j = d['joins']; assert len(j) == 31 and d['met'] and \
    d['summary'] == {'joins': 31, 'subpaths': 8, 'G0': 14, 'G1': 11, 'G3': 6, 'undecided': 0, 'corners': 14, 'kinks': 0, 'left_out': 0, 'rounding': 0, 'looked_through': 0} and \
    [x for x in j if x['id'] == 'banner'][2]['right_letter'] == 'l' and j[11]['left'] == 11 and j[11]['right'] == 2"
fi
svg '<path id="a&quot;b&#10;\" d="M0 0h1v1"/>'
run 0 verify drawing.svg --json && says out '"id":"a\"b\u000a\\"'
svg '<g transform="scale(0)"><path d="M0 0h1v1"/></g><rect width="100%" height="3"/><rect width="1e1mm" height="1in" ry="1"/>'
run 1 verify drawing.svg && says out "its transform is not invertible" 'width="100%" is relative' "8 joins in 1 subpath: 8 G1"
svg '<path d="M0 0h1v1h-1.001z"/>'
run 0 verify drawing.svg && says out "corner of 89.94 degrees, the closing line is 1 long" "at (-0.001, 1)"
cp drawing.svg DRAWING.SVG && cp drawing.svg drawing
run 0 verify DRAWING.SVG && run 0 verify drawing
svg '' && run 0 verify drawing.svg --allow-empty && says out "0 joins"
printf '\xff\xfe' >utf16.svg && printf '<svg><path d="M0 0h1v1"/></svg>' | sed 's/./&\x00/g' >>utf16.svg
run 0 verify utf16.svg && says out "1 join "

# what cannot be read of an element is not covered, with the place and the reason, and hides nothing
# else
left_out() { # left_out ELEMENT REASON: of the file drawing.svg one element, in line 2, is not covered
  run 1 verify drawing.svg --allow-empty --require G0 && lacks out proved && says out "$1 (line 2): not verified, $2" "not covered: 1 element, $2" "1 element not verified"
  run 0 verify drawing.svg --allow-empty --allow-uncovered
}
bad_drawing() { # bad_drawing LINE REASON: the file drawing.svg is refused
  run 2 verify drawing.svg --require G1 && says err "malformed_input: drawing.svg:$1: " "$2"
  holds [ ! -s out ]
}
svg '<path id="p" d="M0 0h1v1h1
 L1 1 2"/><path d="M0 0h1v1"/>' && left_out 'path "p"' 'd, character 19: the end where a number is expected; what follows is not read'
says out "4 joins in 2 subpaths" && run 1 verify drawing.svg --format sarif && says out '"startLine":2'
svg '<path d="M0 0h1v1M5 5h1v1zL9 9M7 7 8"/>' && left_out path "d, character 28: the end where" && says out "4 joins in 3 subpaths"
svg '<path d="L0 0"/><path d="none"/><path d=" none "/>' && left_out path "d, character 1: the path does not begin" && says out "0 joins"
svg '<g transform="turn(3)"><path d="M0 0h1v1"/></g><path d="M0 0h1v1"/>' && left_out g "transform, character 1: 'turn' is not a transform" && says out "1 join "
svg '<circle r="-1"/><circle r="2"/>' && left_out circle "r: negative" && says out "4 joins"
svg '<rect width="2" height="3" rx="-1"/><rect/><circle/>' && left_out rect "rx: negative" && says out "0 joins"
svg '<circle r="1m"/>' && left_out circle "r, character 1: 'm' is not a unit of length"
svg '<polygon points="0 0 1 0 1 1 2"/>' && left_out polygon "points, character 14: the end" && says out "1 join in 1 subpath"
svg '<polyline points="0 0 1 0 1 1,"/>' && left_out polyline "points, character 12: a comma" && says out "1 join in 1 subpath"
svg '<rect width="9" height="4" rx="auto" ry="1"/><ellipse rx="2" ry="auto"/><ellipse ry="2"/><ellipse rx="auto"/>'
run 0 verify drawing.svg && says out "16 joins in 3 subpaths: 8 G1, 8 G3 or more"
svg '<path d="M0 0h1v1"' && bad_drawing 2 "not well-formed"
svg '<g></svg>' && bad_drawing 2 "mismatched tag"
printf '' >drawing.svg && bad_drawing 1 "no element found"
printf '\0\0\0' >drawing.svg && bad_drawing 1 "not well-formed"
printf '<html/>' >drawing.svg && bad_drawing 1 "the root element is 'html', not svg"
head -c 1500 "$leaf" >drawing.svg && bad_drawing 58 "unclosed token"
printf '100 1 0 0\n' >drawing.svg && bad_drawing 1 "syntax error"
svg "$(printf '<g>%.0s' {1..255})$(printf '</g>%.0s' {1..255})" && run 0 verify drawing.svg --allow-empty
svg "$(printf '<g>%.0s' {1..256})$(printf '</g>%.0s' {1..256})" && bad_drawing 2 "nested deeper than 256"
svg "$(printf '<g>%.0s' {1..20000})" && bad_drawing 2 "nested deeper than 256"
run 2 verify missing.svg && says err "cannot_read_file: missing.svg: No such file"
mkdir folder.svg && run 2 verify folder.svg && says err "cannot_read_file: folder.svg: Is a directory"
if [ "$(id -u)" -ne 0 ]; then
  svg '' && cp drawing.svg closed.svg && chmod 0 closed.svg
  run 2 verify closed.svg && says err "cannot_read_file: closed.svg: Permission denied"
fi

# lengths: a number, directly followed by a unit
for bad in 1junk2px "1 2px" 1, "1 px" "1%%" 1e "" "1px 2px" calc\(1px\); do
  svg "<rect/><circle r=\"$bad\"/>" && left_out circle "r, character 1: "
done
svg '<g><circle r="1e"/></g>' && left_out circle "r, character 1: 'e' is not a unit of length"
svg '<circle r="0%"/><circle r="0em"/>' && run 0 verify drawing.svg --allow-empty
svg '<circle r="1"/><circle r=" 1PX "/><circle r="1Q"/><circle r="1e1Mm"/>' && run 0 verify drawing.svg && says out "16 joins in 4 subpaths"
for relative in 1em 1ex 1% 1rem 1VW; do
  svg "<path d=\"M0 0h1v1\"/><circle r=\"$relative\"/>" && run 1 verify drawing.svg && says out "r=\"$relative\" is relative"
done

# the text in other encodings, and packed; from standard input
svg '<path id="&#252;" d="M0 0h1v1"/>'
same_as_drawing() { # same_as_drawing FILE: it is read like drawing.svg
  run 0 verify "$1" && says out 'path "ü" (line 2), subpath 1' "1 join "
  piped "$1" 0 verify - && says out 'path "ü" (line 2), subpath 1' "1 join "
}
{ printf '\xef\xbb\xbf' && cat drawing.svg; } >bom.svg && same_as_drawing bom.svg
iconv -f UTF-8 -t UTF-16LE drawing.svg | { printf '\xff\xfe' && cat; } >utf16.svg && same_as_drawing utf16.svg
iconv -f UTF-8 -t UTF-16BE drawing.svg | { printf '\xfe\xff' && cat; } >utf16.svg && same_as_drawing utf16.svg
gzip -c drawing.svg >packed.svgz && same_as_drawing packed.svgz
cp packed.svgz packed.svg && same_as_drawing packed.svg && cp packed.svgz packed && same_as_drawing packed
{ head -c 30 drawing.svg | gzip && tail -c +31 drawing.svg | gzip -1; } >packed.svg && same_as_drawing packed.svg
piped <(gzip -c drawing.svg) 0 verify - && says out "1 join " # a pipe

bad_packed() { # bad_packed REASON: packed.svg is refused
  run 2 verify packed.svg --require G1 && says err "malformed_input: packed.svg: packed by gzip, $1"
  holds [ ! -s out ]
}
head -c 40 packed.svgz >packed.svg && bad_packed "and the end is missing"
head -c -1 packed.svgz >packed.svg && bad_packed "and the end is missing"
printf '\x1f' >packed.svg && bad_packed "and the end is missing"
{ head -c -8 packed.svgz && printf '\0\0\0\0\0\0\0\0'; } >packed.svg && bad_packed "but damaged: incorrect data check"
{ cat packed.svgz && printf 'more'; } >packed.svg && bad_packed "but damaged: incorrect header check"
printf '\x1f\x8bnonsense' >packed.svg && bad_packed "but damaged: "
gzip -c </dev/null >packed.svg && run 2 verify packed.svg && says err "packed.svg:1: no element found"

# entities: those that the file declares itself
doctype='<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd"'
document() { printf '%s\n' "$@" >drawing.svg; } # document LINE...
document "$doctype>" '<svg/>' && run 0 verify drawing.svg --allow-empty
document "$doctype [" '<!ENTITY ns_svg "http://www.w3.org/2000/svg">' '<!ENTITY st0 "fill:none">' \
  '<!ENTITY corner "h1v1"> <!ENTITY path "M0 0&corner;">' ']>' \
  '<svg xmlns="&ns_svg;"><style>&st0;</style><path d="&path;&corner;" style="&st0;"/><g id="&lt;&#65;"/></svg>'
run 0 verify drawing.svg && says out "3 joins in 1 subpath"
document '<!DOCTYPE svg [<!ENTITY p "<path d='"'M0 0h1v1'"'/>">]>' '<svg>&p;&p;</svg>' && run 0 verify drawing.svg && says out "2 joins"
undeclared="the entity 'nbsp' is not declared in this file"
for begin in "<?xml version='1.0'?>" "$doctype>" '<!DOCTYPE svg [<!ENTITY other "x">]>' "$doctype"' [<!ENTITY % more "x"> %more;]>' \
  "<!DOCTYPE svg [<!ENTITY % more \"<!ENTITY nbsp ' '>\"> %more;]>"; do
  document "$begin" '<svg>' '<text>&nbsp;</text></svg>' && bad_drawing 3 "$undeclared"
  document "$begin" '<svg>' '<path d="M0 0h1&nbsp;1"/></svg>' && bad_drawing 3 "$undeclared"
  document "$begin" '<svg>' '<text x="&amp;&nbsp;"/></svg>' && bad_drawing 3 "$undeclared"
  document "$begin" '<svg><defs>' '<path d="&nbsp;"/></defs></svg>' && bad_drawing 3 "$undeclared"
done
document "$doctype [" '<!ENTITY a "&nbsp;">]>' '<svg><path d="&a;"/></svg>' && bad_drawing 2 "$undeclared"
document "$doctype [" '<!ATTLIST path d CDATA "&nbsp;">]>' '<svg><path/></svg>' && bad_drawing 2 "$undeclared"
iconv -f UTF-8 -t UTF-16 drawing.svg >utf16.svg && run 2 verify utf16.svg && says err "utf16.svg:2: $undeclared"
document "$doctype>" '<svg><path d="&nbsp;"/></svg>' && iconv -f UTF-8 -t UTF-16 drawing.svg >utf16.svg
run 2 verify utf16.svg && says err "utf16.svg:2: $undeclared"
document '<!DOCTYPE svg [<!ENTITY a "&#38;a;">]>' '<svg>&a;</svg>' && bad_drawing 1 "the entity 'a' is not declared"
# those in other files are never read
printf 'M0 0h1v1' >other.txt
for begin in '<!DOCTYPE svg [<!ENTITY x SYSTEM "other.txt">]>' "$doctype [<!ENTITY x SYSTEM 'file://$PWD/other.txt'>]>"; do
  document "$begin" '<svg><path d="&x;"/></svg>' && bad_drawing 2 "the entity 'x' stands in another file, which is not read"
  document "$begin" '<svg>' '<text>&x;</text></svg>' && bad_drawing 3 "the entity 'x' stands in another file, which is not read"
  document "$begin" '<svg><path d="M0 0h1v1"/></svg>' && run 0 verify drawing.svg && says out "1 join "
done
# and what expands to more and more text is refused
entities() { for i in {1..15}; do printf '<!ENTITY e%d "%s">' "$i" "$(printf "&e$((i - 1));%.0s" {1..10})"; done; }
little=(bash -c 'ulimit -v 1048576 && exec timeout 20 "$@"' -)
if grep -qa __asan_init "$program"; then little=(timeout 20); fi
bounded() { local limit=("${little[@]}") && run "$@"; } # bounded CODE ARGUMENTS...: run in 20 s and 1 GiB
for begin in '<!DOCTYPE svg' "$doctype"; do
  document "$begin [<!ENTITY e0 'M0 0h1v1'>$(entities)]>" '<svg>&e15;</svg>' && bounded 2 verify drawing.svg
  says err "drawing.svg:2: limit on input amplification factor"
  document "$begin [<!ENTITY e0 'M0 0h1v1'>$(entities)]>" '<svg><path d="&e15;"/></svg>' && bounded 2 verify drawing.svg
  says err "limit on input amplification factor"
done
chain() { printf '<!ENTITY e0 "x">' && seq 1 20000 | awk '{ printf "<!ENTITY e%d \"&e%d;\">", $1, $1 - 1 }'; }
document "<!DOCTYPE svg [$(chain)]>" '<svg>&e20000;</svg>' && bounded 2 verify drawing.svg && says err "entities are nested deeper than 16"
head -c 300000000 /dev/zero | tr '\0' ' ' | gzip -1 >packed.svg && bounded 2 verify packed.svg
says err "work_limit: packed.svg: more than 256 MiB when unpacked"

# transforms: products stay short
repeat() { printf "$1%.0s" $(seq "$2"); } # repeat TEXT TIMES
right_angle='<path d="M0 0h1v1"/>'
svg "<g transform=\"$(repeat 'rotate(1)' 4000)\">$right_angle</g>" && bounded 0 verify drawing.svg && says out "at (0.766044, 0.642788)"
svg "<g transform=\"rotate(40)\">$right_angle</g>" && run 0 verify drawing.svg && says out "at (0.766044, 0.642788)"
svg "$(repeat '<g transform="rotate(1)">' 200)$right_angle$(repeat '</g>' 200)" && bounded 0 verify drawing.svg
says out "at (-0.939693, -0.34202)" "corner of 90 degrees"
svg "<g transform=\"$(repeat 'rotate(1 1 1)rotate(1 2 1)' 2000)\">$right_angle</g>" && bounded 0 verify drawing.svg && says out "corner of 90 degrees"
svg "<g transform=\"$(repeat 'translate(1 -1)' 20000)\">$right_angle</g>" && bounded 0 verify drawing.svg && says out "at (20001, -20000)"
svg "<g transform=\"$(repeat 'skewX(1)skewX(-1)' 10000)\">$right_angle</g>" && bounded 0 verify drawing.svg && says out "1 G0"
many=$(printf '1%.0s' $(seq 4090))
for list in "scale($many)" "matrix($many 0 0 1 0 0)" "rotate(1 $many 1)" "translate(1e-4000)"; do
  svg "$(repeat "<g transform=\"$list\">" 200)$right_angle$(repeat '</g>' 200)" && bounded 1 verify drawing.svg --allow-empty
  says out "g (line 2): not verified, transform, character" "number of more than 1280 bits"
done
svg "$(repeat '<g transform="scale(1e-300)">' 3)$right_angle</g></g></g>" && left_out g "transform, with the groups around: Svg_transform: numbers of more than 1024 bits"
svg "$(repeat '<g transform="scale(.1234567890123456789)">' 200)$right_angle$(repeat '</g>' 200)" && bounded 0 verify drawing.svg

# path data with numbers of any size
svg "<path d=\"M0 0$(repeat ' 1e380 1e-380' 4000)\"/>" && bounded 0 verify drawing.svg --allow-empty
svg "<path d=\"M0 0l$(repeat ' 1e300 1e-300 1e-300 1e300' 20000)\"/>" && bounded 1 verify drawing.svg --allow-empty && says out "a coordinate of more than 1280 bits"
svg "<path d=\"M0 0$(repeat 'a1e300 1e-300 0 0 1 1e-300 1e30' 20000)\"/>" && bounded 1 verify drawing.svg --allow-empty && says out "the sizes of an arc differ too much"
svg "<path d=\"M0 0$(repeat 'a3.5 7 0 0 1 1 1' 4000)\"/>" && bounded 0 verify drawing.svg
svg '<ellipse rx="1e300" ry="1e-300"/>' && left_out ellipse "the sizes of an arc differ too much"

# viewports of inner svg elements, in the coordinates of the outermost one, without its own
kink='<path d="M0 5L5 5L10 6"/>' # a corner of 11.31 degrees, and stretched by 10 a kink of 1.146 degrees
is_at() { run 0 verify drawing.svg && says out "$@"; } # is_at TEXT...: so says verify of drawing.svg
outer() { printf '<svg xmlns="http://www.w3.org/2000/svg" %s>\n%s</svg>\n' "$1" "$2" >drawing.svg; } # outer ATTRIBUTES CONTENT
outer 'viewBox="0 0 1000 1000" width="100" height="100"' "<svg width=\"1000\" height=\"100\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"none\">$kink</svg>"
is_at "at (500, 50): G0, kink of 1.146 degrees, a handle is off by 9.998 (0.9806 units of the last decimal)" && run 1 verify drawing.svg --require G1
outer 'preserveAspectRatio="none" viewBox="0 0 1 9"' "$kink" && is_at "at (5, 5): G0, corner of 11.31 degrees"
svg "<svg x=\"7\" y=\"1in\">$kink</svg>" && is_at "at (12, 101)"
svg "<svg x=\"1\" y=\"2\" width=\"30\" height=\"20\" viewBox=\"5 5 10 10\">$kink</svg>" && is_at "at (6, 2): G0, corner of 11.31" # xMidYMid meet
for ratio in "xMinYMin meet: (0, 0)" "xMaxYMid: (10, 0)" "xMidYMid slice: (0, -5)" "xMinYMax slice: (0, -10)" "xMinYMin slice: (0, 0)" "xMaxYMax meet: (10, 0)"; do
  svg "<svg width=\"30\" height=\"20\" viewBox=\"5 5 10 10\" preserveAspectRatio=\"${ratio%:*}\">$kink</svg>" && is_at "at ${ratio#*: }: G0, corner of 11.31"
done
svg "<svg width=\"30\" height=\"20\" viewBox=\"5 5 10 10\" preserveAspectRatio=\" none \">$kink</svg>" && is_at "at (0, 0): G0, corner of 7.595 degrees"
svg "<g transform=\"scale(2)\"><svg transform=\"scale(3)\" x=\"1\" viewBox=\"0 0 2 2\" width=\"1\" height=\"1\"><svg y=\"4\">$kink</svg></svg></g>" && is_at "at (21, 27)"
for content in '<svg viewBox="0 0 1 1">%s</svg>:the size of its viewport is not known here' '<svg width="50%%">%s</svg>:width="50%" is relative' \
  '<svg width="0">%s</svg>:it is not drawn, because its viewport has no area' '<svg width="1" height="1" viewBox="0 0 1 0">%s</svg>:it is not drawn, because its view box' \
  '<svg width="1" height="1" viewBox="0 0 1">%s</svg>:viewBox, character 6' '<svg width="1" height="1" viewBox="0 0 -1 2">%s</svg>:viewBox, character 5: negative' \
  '<svg width="1" height="1" viewBox="0 0 1 1" preserveAspectRatio="xMidYmid">%s</svg>:preserveAspectRatio, character' '<svg width="-1">%s</svg>:width: negative' \
  '<svg preserveAspectRatio="defer xMinYMin" width="1" height="1" viewBox="0 0 1 1">%s</svg>:preserveAspectRatio, character'; do
  # shellcheck disable=SC2059
  svg "$(printf "${content%%:*}" "$kink")" && left_out svg "${content#*:}" && says out "0 joins"
done
svg "<svg style=\"width:1px\">$kink</svg>" && left_out svg "style, width is not read"
# percentages, where the viewport is known
outer 'viewBox="0 0 200 100"' '<rect x="10%" y="10%" width="50%" height="50%" rx="5%"/>' && is_at "at (30, 10)" "at (120, 20)"
outer 'width="1in" height="96"' '<circle r="50%"/>' && is_at "at (0, 48)"
outer 'width="7" height="1"' '<circle r="10%"/>' && is_at "at (0, 0.5)" # the diagonal
outer 'width="3" height="1"' '<circle r="10%"/>' && left_out circle 'r="10%" is relative'
outer 'width="100%" height="96"' '<rect width="10%" height="10%"/>' && left_out rect 'width="10%" is relative'
outer 'viewBox="0 0 200 100"' "<svg height=\"40\" viewBox=\"0 0 20 1\" preserveAspectRatio=\"none\">$kink<line x2=\"50%\"/></svg>" && is_at "at (50, 200): G0, corner of 38.66"

# transforms in styles, before the attribute
style() { svg "<path transform=\"scale(0)\" style=\"$1\" d=\"M0 5L5 5L10 6\"/>"; } # style DECLARATIONS
is_styled() { style "transform:$1" && is_at "$2"; }
is_styled "scale(10,1)" "at (50, 5): G0, kink of 1.146 degrees"
while IFS=: read -r transform place; do is_styled "$transform" "at ($place): "; done <<'END'
none:5, 5
translate(1px):6, 5
translate(1mm, -1pc) translateY(1px):8.77953, -10
TRANSLATEX(3px) scale(2):13, 10
scale(50%, 200%) scaleX(2) scaleY(.5):5, 5
rotate(90deg):-5, 5
rotate(100grad):-5, 5
rotate(.25turn):-5, 5
rotate(1.5707963267948966rad):-5, 5
rotate(0):5, 5
rotate(45deg)rotate(45deg):-5, 5
matrix(1, 2, 3, 4, 5, 6):25, 36
skew(45deg):10, 5
skewX(45deg) skewY(0):10, 5
skew(0, -0.125turn):5, 0
END
for bad in "translate(1)" "translate(1px 2px)" "rotate(45)" "translate(1em)" "translate(50%)" "translate(calc(1px + 2px))" "rotate3d(1,1,1,45deg)" "perspective(2px)" \
  "scale(2" "scale()" "matrix(1,2,3,4,5)" "turn(1deg)" "scale(2),scale(2)" "inherit" "var(--t)" "skewX(90deg)" "rotate(2e9deg)"; do
  style "fill:red;transform:$bad" && left_out path "style, transform" && says out "0 joins"
done
for property in "d:path('M0 0h1')" -moz-transform:scale\(2\) rotate:30deg translate:1px scale:2 "offset-path:path('M0 0h9')" zoom:2 all:unset "tr\\61nsform:scale(2)"; do style "transform:none;$property" && left_out path "style, ${property%%:*} is not read"; done
style "transform:none;-webkit-transform:scale(2) !important;text-transform:none;/*transform:none*/fill:url('a;transform:none')" && is_at "at (10, 10)"
svg '<path transform="scale(2)" style="transform:unset" d="M0 5L5 5L10 6"/>' && is_at "at (5, 5)"
svg '<rect width="1" height="1" rx="9" style="width:4PX;height:1in;rx:auto;x:.5mm"/>' && is_at "at (5.88976, 0): G0" "4 G0"
svg '<rect width="1" height="1" style="width:4"/>' && left_out rect "style, width: '4' has no unit"
svg '<circle r="1" style="r:2px;cx:3px"/>' && is_at "at (3, 2)"
svg '<g style="d:none;r:4px;width:1em"><path style="d:none;r:1em" d="M0 0h1v1"/></g>' && run 0 verify drawing.svg --allow-empty && says out "0 joins"
style "-moz-transform-origin:0 0" && left_out path "style, -moz-transform-origin is not read"
svg '<path style="-moz-transform-origin:0 0;transform-origin:1em;offset:none" d="M0 5L5 5L10 6"/>' && is_at "at (5, 5)"
outer 'style="width:24px;height:100%;x:3" viewBox="0 0 10 10"' '<rect width="50%" height="1"/>' && is_at "at (5, 0)"
outer 'style="width:24px" width="10" height="10"' '<rect width="50%" height="1"/>' && left_out rect 'width="50%" is relative'
outer 'style="transform:scale(2)" transform="scale(3)"' "$kink" && is_at "at (10, 10)"
# their origins
outer 'viewBox="1 2 40 20"' '<path style="transform:rotate(90deg);transform-origin:center" d="M0 5L5 5L10 6"/>' && is_at "at (25, -5)"
for origin in "1px 1px:-3, 5" "0 5px:0, 10" "left bottom:15, 25" "top right:35, -35" "100%:45, -25" "10% 10% 0:1, 3"; do
  outer 'viewBox="1 2 40 20"' "<path transform=\"rotate(90)\" style=\"transform-origin:${origin%:*}\" d=\"M0 5L5 5L10 6\"/>" && is_at "at (${origin#*:})"
done
svg '<path transform="rotate(90)" transform-origin="1 1" d="M0 5L5 5L10 6"/>' && is_at "at (-3, 5)"
svg '<path transform="rotate(90)" transform-origin="center" d="M0 5L5 5L10 6"/>' && left_out path "transform-origin: '50%' is relative"
svg '<path style="transform-origin:center;transform-box:fill-box" d="M0 5L5 5L10 6"/>' && is_at "at (5, 5)"
svg '<path style="transform-origin:0 0;transform-box:fill-box" transform="rotate(90)" d="M0 5L5 5L10 6"/>' && left_out path "transform-box: fill-box is not read"

# style sheets and animations that may change an element
sheet() { svg "<g class=\"a b\"><path id=\"p\" class=\"c\" d=\"M0 5L5 5L10 6\"/></g><style>$1</style>"; } # it stands behind what it is for
for rule in "path{transform:scale(2)}" "#p {fill:red; transform : none}" ".c,x{rotate:1deg}" ".a .c{d:none}" ".a>path{d:none}" "svg > g .c{scale:2}" "*{d:none}" "path[d]{d:none}" \
  "path:not(:hover){d:none}" "g + path{d:none}" "@media print{.c{d:none}}" "@layer x{@supports (d:none){path{d:none}}}" ".b{fill:red;> .c{d:none}}" "/*{*/.c/**/{d:none}" \
  "<![CDATA[.c{d:none}]]>" "@keyframes k{to{d:none}} .c{animation:1s k}" "g.b path#p.c{-webkit-transform:scale(2)}" "@font-face{src:url('}')} .c{d:none}"; do
  sheet "$rule"
  case $rule in "#p"*) is_at "1 join " ;; *) left_out 'path "p"' "the style sheet in line 2 may set its '" && says out "0 joins" ;; esac
done
sheet ".a{transform:scale(2)}" && left_out g "the style sheet in line 2 may set its 'transform'" && says out "0 joins"
for rule in "circle{r:1px}" ".x{transform:scale(2)}" "path:hover{transform:scale(2)}" ".c .a{d:none}" "a>.c{d:none}" "path{r:1px;width:2px;fill:red}" ".cc{d:none}" "path{transform-origin:center}" \
  "path{transform:none}" "@keyframes k{to{fill:red}} .c{animation:1s k}" ".c{fill:url('a{d:none}')}" "svg{width:10px}" "/* .c{d:none} */" ".c{transition:d 1s}"; do
  sheet "$rule" && is_at "1 join "
done
svg '<path transform="scale(2)" d="M0 5L5 5L10 6"/><style>*{transform-box:fill-box}</style>' && left_out path "the style sheet in line 2 may set its 'transform-box'"
for rule in "@import url(a.css);" "@import 'a.css'; .x{fill:red}"; do sheet "$rule" && left_out style "a style sheet in another file may change elements" && says out "1 join "; done
printf '<?xml version="1.0"?>\n<?xml-stylesheet href="a.css"?><svg>%s</svg>' "$kink" >drawing.svg && left_out xml-stylesheet "a style sheet in another file"
for animation in '<animate attributeName="d"/>' '<animateTransform/>' '<animateMotion/>' '<set attributeName="transform"/>'; do
  svg "<path d=\"M0 0h1v1\">$animation</path>" && left_out path "it is animated in line 2" && says out "0 joins"
  svg "<animate href=\"#g\" attributeName=\"transform\"/><g id=\"g\">$kink</g>" && left_out 'g "g"' "it is animated in line 2"
done
svg '<path d="M0 0h1v1"><animate attributeName="fill"/><set attributeName="opacity"/></path>' && is_at "1 join "

# use: what is repeated is decided where it is drawn
xlink() { printf '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink">\n%s</svg>\n' "$1" >drawing.svg; }
xlink "<use id=\"u\" xlink:href=\"#k\" x=\"100\" transform=\"scale(10,1)\"/>
<defs><path id=\"k\" d=\"M0 5L5 5L10 6\"/></defs>" && is_at 'path "k" (line 3), repeated by use "u" (line 2), subpath 1, commands 2 L - 3 L at (1050, 5): G0, kink of 1.146' "1 join in 1 subpath"
run 0 verify drawing.svg --json && says out '"id":"k","line":3,"repeated_by":"use \"u\" (line 2)"'
svg "<clipPath id=\"c\"><path id=\"k\" d=\"M0 5L5 5L10 6\"/></clipPath><use href=\" #k \"/><use href=\"#k\" y=\"1\"/>" && is_at "at (5, 5)" "at (5, 6)" "2 joins in 2 subpaths"
svg "<g id=\"g\" transform=\"scale(2)\"><path id=\"k\" d=\"M0 5L5 5L10 6\"/><use id=\"v\" href=\"#k\" x=\"1\"/></g><use id=\"w\" href=\"#g\" y=\"1\"/>"
is_at "at (10, 10)" "at (12, 10)" "at (10, 11)" "at (12, 11)" 'repeated by use "v" (line 2) in use "w" (line 2)' "4 joins in 4 subpaths"
symbol="<symbol id=\"s\" viewBox=\"0 0 10 10\">$kink</symbol>"
svg "$symbol<use href=\"#s\" x=\"1\" y=\"2\" width=\"30\" height=\"20\"/>" && is_at "at (16, 12): G0, corner of 11.31"
svg "${symbol/symbol/symbol preserveAspectRatio=\"none\"}<use href=\"#s\" width=\"100\" height=\"10\"/>" && is_at "at (50, 5): G0, kink of 1.146"
svg "${symbol/symbol/symbol width=\"20\" height=\"20\"}<use href=\"#s\" width=\"40\"/>" && is_at "at (20, 10)"
outer 'viewBox="0 0 40 20"' "$symbol<use href=\"#s\"/>" && is_at "at (20, 10)"
svg "$symbol<use href=\"#s\"/>" && run 1 verify drawing.svg --allow-empty
says out 'symbol "s" (line 2), repeated by use (line 2): not verified, the size of its viewport is not known here'
svg "<svg id=\"v\" x=\"1\" width=\"10\" height=\"10\" viewBox=\"0 0 10 10\">$kink</svg><use href=\"#v\" width=\"100\" height=\"100\"/>" && is_at "at (6, 5)" "at (51, 50)"
for bad in 'href="#none":there is no element "none" in this file to repeat' 'href="other.svg#a":the element that it repeats stands in another file' ':it does not say which' \
  'href="":the element that it repeats stands in another' 'href="#c":it repeats a clipPath, which is not drawn' 'href="#k" x="1q2":x, character 1' 'href="#k" x="5%":x="5%" is relative'; do
  svg "<clipPath id=\"c\"><path id=\"k\" d=\"M0 5L5 5L10 6\"/></clipPath><use ${bad%%:*}/>" && left_out use "${bad#*:}"
done
svg '<g id="a"><use id="u" href="#a"/></g>' && left_out 'use "u"' "it repeats itself"
svg '<defs><g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g></defs><use id="u" href="#a"/>' && run 1 verify drawing.svg --allow-empty && says out "it repeats itself"
svg '<path id="k" d="M0 0h1v1L2 3 4"/><use href="#k"/>' && run 1 verify drawing.svg && says out "2 elements not verified" "4 joins"
# and what is repeated again and again is limited
laughs() { for i in $(seq 1 "$1"); do printf '<g id="e%d">' "$i" && repeat "<use href=\"#e$((i - 1))\"/>" "$2" && printf '</g>'; done; } # laughs LEVELS TIMES
svg "<defs><path id=\"e0\" d=\"M0 0h1v1\"/>$(laughs 20 10)</defs><use href=\"#e20\"/>" && bounded 1 verify drawing.svg --summary
says out "MiB of elements, and ten times the drawing, would be repeated" "not met, because"
svg "<defs><path id=\"e0\" d=\"M0 0h1v1\"/>$(laughs 300 1)</defs><use href=\"#e300\"/>" && bounded 1 verify drawing.svg --allow-empty
says out "elements are nested deeper than 256, with those that are repeated"
svg "<path id=\"k\" d=\"M0 0h1v1\"/>$(repeat '<use href="#k"/>' 3000)" && bounded 0 verify drawing.svg --summary && says out "3001 joins"

# what is filled has a join where it ends at its start, with Z or without it
ring='d="M50 10C72 10 90 28 90 50C90 72 72 90 50 90C28 90 10 72 10 50C10 28 28 11 50 10"'
filled() { # filled DRAWING: it has a kink where the ring ends
  svg "$1" && run 1 verify drawing.svg --require G1
  says out "4 joins in 1 subpath: 1 G0, 3 G2" "commands 5 C - 2 C at (50, 10): G0, kink of 2.603 degrees" "1 of them not G1"
}
stroked() { svg "$1" && run 0 verify drawing.svg --require G1 && says out "3 joins in 1 subpath: 3 G2"; } # it ends there
filled "<path $ring/>" && filled "<path fill=\"black\" $ring/>" && filled "<path fill=\"url(#a)\" stroke=\"red\" $ring/>" && filled "<path $ring style=\"fill: red\" fill=\"none\"/>"
stroked "<path fill=\"none\" $ring/>" && stroked "<path style=\"stroke:red;fill : none !important\" $ring/>" && stroked "<path fill=\"transparent\" $ring/>"
filled "<g fill=\"none\"><path fill=\"red\" $ring/></g>" && filled "<g fill=\"red\"><path fill=\"inherit\" $ring/></g>"
stroked "<g fill=\"none\"><g><path $ring/></g></g>" && stroked "<g style=\"fill:none\"><path fill=\"inherit\" $ring/></g>"
# what a rule of a style sheet may fill counts as filled
filled "<style>.a{fill:red}</style><path fill=\"none\" class=\"a\" $ring/>" && filled "<style>path{fill:red !important}</style><path style=\"fill:none\" $ring/>"
stroked "<style>path{fill:red}</style><path style=\"fill:none\" $ring/>" && stroked "<style>.a{fill:none}</style><path fill=\"none\" class=\"a\" $ring/>"
filled "<style>g .a{fill:red}</style><g fill=\"none\"><path class=\"a\" fill=\"none\" $ring/></g>" && stroked "<style>g .a{fill:red}</style><path class=\"a\" fill=\"none\" $ring/>"
filled "<style>.a{fill:red}</style><g fill=\"none\"><path class=\"a\" $ring/></g>" && stroked "<style>.a{fill:red}</style><path fill=\"none\" $ring/>"
svg "<defs><path id=\"r\" $ring/></defs><use href=\"#r\"/><use href=\"#r\" fill=\"none\"/>" && run 1 verify drawing.svg --require G1 && says out "7 joins in 2 subpaths" "1 of them not G1"
svg '<polyline points="0 0 9 0 9 9 0 0"/><polyline fill="none" points="0 0 9 0 9 9 0 0"/><line x2="3"/>' && run 0 verify drawing.svg && says out "5 joins in 3 subpaths"
svg "<path ${ring%0\"}1\"/>" && run 0 verify drawing.svg && says out "3 joins in 1 subpath" # it does not end there
svg '<path d="M0 0C9 0 0 9 0 0"/><path fill="none" d="M0 0C9 0 0 9 0 0"/>' && run 0 verify drawing.svg && says out "1 join in 2 subpaths"

# segments no longer than the rounding of a path are looked through: what they make is no corner
closed='M20 60c0-5.523 4.477-10 10-10s10 4.477 10 10-4.477 10-10 10-10-4.477-10-10.001Z'
svg "<path d=\"$closed\"/>" && run 0 verify drawing.svg --require G1
says out "4 joins in 1 subpath: 1 G1, 3 G2" "commands 5 s - 2 c at (20, 59.999): G1" "rounding: 1 segment is looked through, no longer than one unit of the last decimal" \
  "drawn as 0 corners, 0 kinks" "rounding at 1 join: 1 segment looked through" "every join but the corners, with rounding looked through, is G1, proved exactly"
run 0 verify drawing.svg --json && says out '"looked_through":1' '"rounding":1,"looked_through":1}'
run 0 verify drawing.svg --format sarif && says out '"ruleId":"rounding"' '"level":"note"'
to_and_fro='M0 50C0 30 20 10 50 10L50.001 10L50 10C80 10 100 30 100 50'
svg "<path d=\"$to_and_fro\"/>" && run 0 verify drawing.svg --require G2 && says out "1 join in 1 subpath" "2 segments are looked through" "drawn as 0 corners, 0 kinks of at most 5 degrees, 0 G1, 1 G2"
svg '<path d="M0 90C0 70 20 50 50 50L50.001 50C80 50 100 70 100 90"/>' && run 0 verify drawing.svg --require G1 && says out "1 join in 1 subpath" "1 segment is looked through"
svg '<polygon points="0 0 90.5 0 90.5 90.5 90.4 90.5 0 90.5"/>' && run 0 verify drawing.svg && says out "5 joins in 1 subpath" # on the way, and a corner
# the kink of the neighbours counts, in the coordinates of the element
svg '<g transform="rotate(30) scale(5 7)"><path d="M0 0H50.00V.01L100 3"/></g>' && run 1 verify drawing.svg --require G1
says out "G0, kink of 4.786 degrees" "rounding: 1 segment is looked through" "1 of them not G1"
svg '<path d="M0 0H50.000V.01L100 3"/>' && run 0 verify drawing.svg --require G1 && says out "drawn as 2 corners" && lacks out rounding # which is ten units
svg '<path d="M0 0H50v1H100v1h90"/>' && run 0 verify drawing.svg && says out "drawn as 4 corners" && lacks out rounding # steps that are drawn
svg '<path d="M0 0H90v1H0z"/>' && run 0 verify drawing.svg && says out "drawn as 4 corners" && lacks out rounding # a cap turns one way
svg '<path d="M0 0H50.0C50.1 0 50.1 0 50.1 .1V90"/>' && run 0 verify drawing.svg && says out "2 joins" "drawn as 0 corners" && lacks out rounding # and so does a curve
svg '<path d="M0 0H.1V.1H0Z"/><path d="M0 0h.1"/><path d="M9 0h-.1z"/>' && run 0 verify drawing.svg && says out "6 joins" && lacks out rounding # nothing else is there
svg '<path d="M0 0h90l-.1 0"/>' && run 0 verify drawing.svg && says out "drawn as 1 corner" && lacks out rounding # it has no neighbour behind it
svg "<path d=\"$closed\"/><path d=\"$to_and_fro\"/>" && run 0 verify drawing.svg --certificate certificate && holds [ "$(wc -l <certificate)" -eq 10 ] # of all segments

# arcs of rotated ellipses: where tangents differ, by how much; where they agree
rotated() { svg "<path fill=\"none\" d=\"$1\"/>" && run "$2" verify drawing.svg --require G1; } # rotated D CODE
rotated 'M0 0A2 1 30 0 1 4 2A2 1 30 0 1 0 0Z' 0 && says out "2 joins in 1 subpath: 2 G3 or more"
rotated 'M0 0A9 4 30 0 1 4 2A9 4 30 0 0 8 4' 0 && says out ": 1 G1" "equal curvature 0.05023, but the curve bends another way"
rotated 'M0 0A5 4 30 0 1 5 5L9 9' 0 && says out "1 G0" "drawn as 1 corner"
rotated 'M-9 0L0 0A7 4 44.999 0 1 33 65H9' 1 && says out "2 of them not G1" "kink of 0.0006945 degrees"
rotated 'M-9 0L0 0A7 4 45 0 1 33 65H9' 0 && says out "2 G1"
svg "$undecided_path" && run 1 verify drawing.svg --require G0 && lacks out proved
says out "undecided, a rotated ellipse, whose tangent differs by too little to be told, or not at all: by 3.392e-151 degrees at most" \
  "undecided: 1 join, a rotated ellipse" "not met, because not all was decided (see --allow-undecided)"
run 0 verify drawing.svg --allow-undecided --json && says out '"g_order":null' '"angle_degrees":[0,3.39'
