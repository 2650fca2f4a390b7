#!/usr/bin/env bash
# verify of drawings: kinks by element and command, and what is refused.
. "$(dirname "$0")/functions.sh"

leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
run 1 verify "$leaf" && says out "24 joins in 8 subpaths: 3 G0, 12 G1, 1 G2, 8 G3 or more" \
  'path "leaf" (line 50), subpath 1, commands 3 c - 4 c at (28.5, 6.25): G0, corner of 93.1 degrees' \
  'commands 2 c - 3 s at (37.1946, 48.6223): G1, curvature jumps' 'use "use1" (line 97): not verified'
run 1 verify "$badge" && says out "31 joins in 8 subpaths: 12 G0, 11 G1, 6 G3 or more, 2 undecided" \
  "the closing line is 27.7 long" "a handle is at the node" "undecided, a rotated ellipse"
says out "undecided: 2 joins, a rotated ellipse" "not met, because not all was decided (see --allow-undecided)"
run 1 verify "$leaf" --require G0 && says out "not covered: 1 element, the element that it repeats is not followed" "see --allow-uncovered"
run 0 verify "$leaf" --require G0 --allow-uncovered && says out "every join that was decided is G0, proved exactly"
run 1 verify "$leaf" --require G1 && says out "1 of them not G1" && run 1 verify "$leaf" --require C1 && says out "of them not C1"
run 1 verify "$badge" --require G0 && run 0 verify "$badge" --require G0 --allow-undecided
run 1 verify "$leaf" "$badge" --allow-undecided && run 0 verify "$leaf" "$badge" --allow-undecided --allow-uncovered && says out "55 joins in 16 subpaths" "badge_illustrator.svg: path \"ring\""
run 0 verify "$leaf" --max-order 1 --allow-uncovered && says out "3 G0, 21 G1 or more"
run 2 verify "$leaf" --require F3 && run 2 verify "$leaf" --closed && run 2 verify "$leaf" --surfaces
run 2 verify "$leaf" --kernel double && run 2 verify "$leaf" "$S" && says err "cannot be verified together"
if command -v python3 >/dev/null; then
  run 1 verify "$badge" --json --require G1
  holds python3 -c "import json; d = json.load(open('out')); j = d['joins']; assert len(j) == 31 and not d['met'] and \
    d['summary'] == {'joins': 31, 'subpaths': 8, 'G0': 12, 'G1': 11, 'G3': 6, 'undecided': 2, 'corners': 12, 'kinks': 0, 'left_out': 0} and \
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

bad_drawing() { # bad_drawing LINE REASON: the file drawing.svg is refused
  run 2 verify drawing.svg --require G1 && says err "malformed_input: drawing.svg:$1: " "$2"
  holds [ ! -s out ]
}
svg '<path d="M0 0h1v1"/><path id="p"
 d="M0 0L1 1 2"/>' && bad_drawing 2 'path "p", d, character 11: the end where a number is expected'
svg '<g transform="turn(3)"/>' && bad_drawing 2 "g, transform, character 1: 'turn' is not a transform"
svg '<circle r="-1"/>' && bad_drawing 2 "circle, r: negative"
svg '<circle r="1m"/>' && bad_drawing 2 "circle, r, character 1: 'm' is not a unit of length"
svg '<polygon points="1 2 3"/>' && bad_drawing 2 "polygon, points, character 6"
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
  svg "<rect/><circle r=\"$bad\"/>" && bad_drawing 2 "circle, r, character 1: "
done
svg '<g><circle r="1e"/></g>' && bad_drawing 2 "'e' is not a unit of length"
svg '<circle r="1"/><circle r=" 1PX "/><circle r="1Q"/><circle r="1e1Mm"/>' && run 0 verify drawing.svg && says out "16 joins in 4 subpaths"
for relative in 1em 1ex 1% 1rem 1VW; do
  svg "<path d=\"M0 0h1v1\"/><circle r=\"$relative\"/>" && run 1 verify drawing.svg && says out "r=\"$relative\" is relative"
done

# the text in other encodings, and packed; from standard input
svg '<path id="&#252;" d="M0 0h1v1"/>'
run_with() { # run_with FILE CODE ARGUMENTS...: with the file on standard input
  local file=$1 real=$program
  shift
  printf '#!/bin/sh\nexec "%s" "$@" <"%s"\n' "$real" "$file" >run_with.sh && chmod +x run_with.sh
  program=./run_with.sh
  run "$@"
  program=$real
}
same_as_drawing() { # same_as_drawing FILE: it is read like drawing.svg
  run 0 verify "$1" && says out 'path "ü" (line 2), subpath 1' "1 join "
  run_with "$1" 0 verify - && says out 'path "ü" (line 2), subpath 1' "1 join "
}
{ printf '\xef\xbb\xbf' && cat drawing.svg; } >bom.svg && same_as_drawing bom.svg
iconv -f UTF-8 -t UTF-16LE drawing.svg | { printf '\xff\xfe' && cat; } >utf16.svg && same_as_drawing utf16.svg
iconv -f UTF-8 -t UTF-16BE drawing.svg | { printf '\xfe\xff' && cat; } >utf16.svg && same_as_drawing utf16.svg
gzip -c drawing.svg >packed.svgz && same_as_drawing packed.svgz
cp packed.svgz packed.svg && same_as_drawing packed.svg && cp packed.svgz packed && same_as_drawing packed
{ head -c 30 drawing.svg | gzip && tail -c +31 drawing.svg | gzip -1; } >packed.svg && same_as_drawing packed.svg
run_with <(gzip -c drawing.svg) 0 verify - && says out "1 join " # a pipe


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
bounded() { # bounded CODE ARGUMENTS...: run in 20 s and 1 GiB
  local real=$program
  cat >bounded.sh <<END
#!/usr/bin/env bash
$limit_memory
exec timeout 20 "$real" "\$@"
END
  chmod +x bounded.sh
  program=./bounded.sh
  run "$@"
  program=$real
}
limit_memory="ulimit -v 1048576"
grep -qa __asan_init "$program" && limit_memory=
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
  svg "$(repeat "<g transform=\"$list\">" 200)$right_angle$(repeat '</g>' 200)" && bounded 2 verify drawing.svg
  says err "drawing.svg:2: g, transform, character" "number of more than 1280 bits"
done
svg "$(repeat '<g transform="scale(1e-300)">' 3)$right_angle</g></g></g>" && run 2 verify drawing.svg
says err "work_limit: drawing.svg:2: g, transform, with the groups around: Svg_transform: numbers of more than 1024 bits"
svg "$(repeat '<g transform="scale(.1234567890123456789)">' 200)$right_angle$(repeat '</g>' 200)" && bounded 0 verify drawing.svg

# path data with numbers of any size
svg "<path d=\"M0 0$(repeat ' 1e380 1e-380' 4000)\"/>" && bounded 0 verify drawing.svg --allow-empty
svg "<path d=\"M0 0l$(repeat ' 1e300 1e-300 1e-300 1e300' 20000)\"/>" && bounded 2 verify drawing.svg && says err "a coordinate of more than 1280 bits"
svg "<path d=\"M0 0$(repeat 'a1e300 1e-300 0 0 1 1e-300 1e30' 20000)\"/>" && bounded 2 verify drawing.svg && says err "the sizes of an arc differ too much"
svg "<path d=\"M0 0$(repeat 'a3.5 7 0 0 1 1 1' 4000)\"/>" && bounded 0 verify drawing.svg
svg '<ellipse rx="1e300" ry="1e-300"/>' && run 2 verify drawing.svg && says err "work_limit: drawing.svg:2: ellipse: the sizes of an arc differ too much"
