#!/usr/bin/env bash
# verify of drawings: kinks by element and command, and what is refused.
. "$(dirname "$0")/functions.sh"

leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
run 0 verify "$leaf" && says out "24 joins in 8 subpaths: 3 G0, 12 G1, 1 G2, 8 G3 or more" \
  'path "leaf" (line 50), subpath 1, commands 3 c - 4 c at (28.5, 6.25): G0, kink of 93.1 degrees' \
  'commands 2 c - 3 s at (37.1946, 48.6223): G1, curvature jumps' 'use "use1" (line 97): not verified'
run 0 verify "$badge" && says out "31 joins in 8 subpaths: 12 G0, 11 G1, 6 G3 or more, 2 undecided" \
  "the closing line is 27.7 long" "a handle is at the node" "undecided, a rotated ellipse"
run 0 verify "$leaf" --require G0 && says out "every join is G0, proved exactly"
run 1 verify "$leaf" --require G1 && says out "3 of them not G1"
run 1 verify "$badge" --require G0 && says out "2 of them not proved to be G0"
run 0 verify "$leaf" "$badge" && says out "55 joins in 16 subpaths" "badge_illustrator.svg: path \"ring\""
run 0 verify "$leaf" --max-order 1 && says out "3 G0, 21 G1 or more"
run 2 verify "$leaf" --require F3 && run 2 verify "$leaf" --closed && run 2 verify "$leaf" --surfaces
run 2 verify "$leaf" --kernel double && run 2 verify "$leaf" "$S" && says err "cannot be verified together"
if command -v python3 >/dev/null; then
  run 1 verify "$badge" --json --require G1
  holds python3 -c "import json; d = json.load(open('out')); j = d['joins']; assert len(j) == 31 and not d['met'] and \
    d['summary'] == {'joins': 31, 'subpaths': 8, 'G0': 12, 'G1': 11, 'G3': 6, 'undecided': 2} and \
    [x for x in j if x['id'] == 'banner'][2]['right_letter'] == 'l' and j[11]['left'] == 11 and j[11]['right'] == 2"
fi
svg '<path id="a&quot;b&#10;\" d="M0 0h1v1"/>'
run 0 verify drawing.svg --json && says out '"id":"a\"b\u000a\\"'
svg '<g transform="scale(0)"><path d="M0 0h1v1"/></g><rect width="100%" height="3"/><rect width="1e1mm" height="1in" ry="1"/>'
run 0 verify drawing.svg && says out "its transform is not invertible" 'width="100%" is relative' "8 joins in 1 subpath: 8 G1"
svg '<path d="M0 0h1v1h-1.001z"/>'
run 0 verify drawing.svg && says out "kink of 89.94 degrees, the closing line is 1 long" "at (-0.001, 1)"
cp drawing.svg DRAWING.SVG && cp drawing.svg drawing
run 0 verify DRAWING.SVG && run 0 verify drawing
svg '' && run 0 verify drawing.svg --require G2 && says out "0 joins"
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
svg "$(printf '<g>%.0s' {1..255})$(printf '</g>%.0s' {1..255})" && run 0 verify drawing.svg
svg "$(printf '<g>%.0s' {1..256})$(printf '</g>%.0s' {1..256})" && bad_drawing 2 "nested deeper than 256"
svg "$(printf '<g>%.0s' {1..20000})" && bad_drawing 2 "nested deeper than 256"
entities=$(for i in {1..9}; do printf '<!ENTITY e%d "%s">' "$i" "$(printf "&e$((i - 1));%.0s" {1..10})"; done)
printf '<!DOCTYPE svg [<!ENTITY e0 "x">%s]>\n<svg>&e9;</svg>' "$entities" >drawing.svg && bad_drawing 1 "the entity 'e0' is declared"
printf '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">\n<svg/>' >drawing.svg
run 0 verify drawing.svg
run 2 verify missing.svg && says err "cannot_read_file: missing.svg"
