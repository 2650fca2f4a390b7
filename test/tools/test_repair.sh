#!/usr/bin/env bash
# repair: kinks become exactly smooth, nothing but the numbers that must change changes, and bad
# input leaves the target alone.
. "$(dirname "$0")/functions.sh"

leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
# path D ARGUMENTS...: repairs a drawing with this path data; the data that is written is the file d
path() {
  local d=$1 code=$2
  shift 2
  svg "<path id=\"p\" d=\"$d\"/>"
  run "$code" repair drawing.svg -o repaired.svg "$@"
  sed -n 's/.* d="\([^"]*\)".*/\1/p' repaired.svg >d
}
becomes() { is "$(cat d)" "$1" "path data"; } # becomes D: that is the data

# A real drawing: one number changes, the rest of the file is the same byte for byte.
run 0 repair "$leaf" -o leaf.svg
says out "1 kink" "0 kinks" "every join is free of kinks, proved exactly on what is written" 'path "midrib" (line 58), subpath 1, command 3, point 2: (31, 30) -> (30, 30)'
sed 's/c 0,-22 1,-40 0,-58/c 0,-22 0,-40 0,-58/' "$leaf" >expected && holds cmp -s expected leaf.svg
run 1 verify "$leaf" --require G1 && says out "1 of them not G1" && run 0 verify leaf.svg --require G1
run 0 repair leaf.svg -o again.svg && holds cmp -s leaf.svg again.svg
cp "$leaf" same.svg && run 0 repair same.svg -o same.svg && holds cmp -s same.svg leaf.svg
run 0 repair "$leaf" -o - && holds cmp -s out leaf.svg && says err "largest move: 1 unit of"
run 0 repair "$badge" -o badge.svg && holds cmp -s "$badge" badge.svg && says out "14 corners, 0 kinks, 11 G1, 6 G2"
svg "$undecided_path" && run 1 repair drawing.svg -o same.svg && says out "undecided: 1 join, an arc of a rotated ellipse" && run 0 repair drawing.svg -o same.svg --allow-undecided
run 0 repair "$badge" -o badge.svg --to G2 && says out "13.89 %" "2 are harmonised, 0 of them exactly; the largest jump of these is 0.02709 %"
sed 's/18.6-9.5,28.1-9.5S70,90.1,79.5,90.1s13.6/19.1-9.5,28.1-9.5C58.3 86.5 69.8,90.1,79.5,90.1c9 0 13.6/' "$badge" >expected
holds cmp -s expected badge.svg
# A letter on its grid.
run 1 repair "$S" -o S.g2 --closed && says out "10 kinks" "6 kinks" "curve 25, point 2: (85, -5) -> (84, -5), 1 unit" "(109, 355) -> (109, 354), 1 unit"
holds [ "$(diff "$S" S.g2 | grep -c '^<')" -gt 5 ] && holds [ "$(wc -l <"$S")" -eq "$(wc -l <S.g2)" ]
run 0 verify "$S" --closed && cp out before && run 0 verify S.g2 --closed && holds [ "$(cmp -s out before; echo $?)" -eq 1 ]
sans=$data/lmsans12-regular_S_0.g2
run 1 verify "$sans" --closed --require G1 && says out "10 of them not G1"
run 0 repair "$sans" -o S.g2 --closed && says out "before: 4 corners, 6 kinks, 8 G1, 0 G2" "after:  4 corners, 0 kinks, 14 G1, 0 G2" "every join is free of kinks, proved exactly on what is written"
says out "largest move: 1 unit of" && run 1 verify S.g2 --closed --require G1 && says out "4 of them not G1"

# The numbers of all forms: relative and absolute, without separators, with exponents and decimals
# of different length.
path 'M0 0C10 0 20 2 40 0 70-4 80 0 90 0' 0 && becomes 'M0 0C10 0 20 2 40 0 70-3 80 0 90 0'
path 'm0 0c10 0 20 2 40 0 30-4 40 0 50 0' 0 && becomes 'm0 0c10 0 20 2 40 0 30-3 40 0 50 0'
path 'M0 0c1 0 2 .1 3 0s2-.1 3 0l3 .2' 1 && says out "not on this grid"
path 'M0 0c1 0 2 .5 3.0 0l3e0 0' 0 --kink-angle 40 --max-move 9 && becomes 'M0 0c1 0 2 0 3.0 0l3e0 0'
path 'M0,0 L10,0 C20,.5.2.5,30,20' 0 --kink-angle 10 && becomes 'M0,0 L10,0 C20,0 .2.5,30,20'
path 'M0,0 L10,0 C20-.5.2.5,30,20' 0 --kink-angle 10 && becomes 'M0,0 L10,0 C20 0 .2.5,30,20'
path 'M0 0L10 0C20 1 30 30 40 30S60 1 70 0L80 0' 0 --kink-angle 10 && becomes 'M0 0L10 0C20 0 30 30 40 30S60 0 70 0L80 0'
path 'M0 0 L10 0 Q20 1 30 20' 0 --kink-angle 10 && becomes 'M0 0 L10 0 Q20 0 30 20'
path 'M0 0 L10 0 Q20 1 30 20 T50 20' 1 --kink-angle 10 && says out "both nodes bind the handle"
path 'M0 0 L10 0 Q20 1 30 10 T50 20' 1 --kink-angle 6 && says out "not on this grid"
path 'M0 0 L10 0 Q20 1 29 10 L38 19' 0 --kink-angle 6 --max-move 2 && becomes 'M0 0 L10 0 Q19 0 29 10 L38 19'
path 'M0 0 L10 0 Q20 1 30 20 40 20 40 10t5-9 0 0' 0 --kink-angle 6 && says out "0 kinks"
# A shorthand whose handle moves is written in full, and what follows it stays a shorthand.
path 'M0 0C10 0 25-20 40-20s31 22 40 60 20 30 40 30' 0 --to G2 --max-move 6 && says out "curvature"
cp d one && run 0 repair repaired.svg -o again.svg --kink-angle 45 && holds cmp -s repaired.svg again.svg
# Entities and line breaks in the attribute, quotation marks of both kinds, other attributes that
# look like it.
printf '<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg" xmlns:x="u"\r\n><!-- <path d="M0 0"/> --><path x:d="M0 0C1 1 2 2 3 3" title="a > b"\r\n\td = '"'"'M0&#32;0\r\nC10,0&#x20;20,2 40,0&#10;70-4 80 0 90 0'"'"' data-d="M"/></svg>\n\n' >odd.svg
run 0 repair odd.svg -o odd2.svg && sed 's/70-4/70-3/' odd.svg >expected && holds cmp -s expected odd2.svg
printf '<!DOCTYPE svg [<!ENTITY d "M0 0C10 0 20 2 40 0 70-4 80 0 90 0"><!ENTITY e "<path d='"'M0 0C10 0 20 2 40 0 70-4 80 0 90 0'"'/>">]><svg><path d="&d;"/>&e;</svg>' >entity.svg
run 1 repair entity.svg -o entity2.svg && holds cmp -s entity.svg entity2.svg && says out "its data is given by an entity" "it stands in an entity"
# Transforms stay as they are.
svg '<g transform="matrix(2 1 0 3 5 6)"><path transform="scale(.1)" d="M0 0C10 0 20 2 40 0 70-4 80 0 90 0"/></g>'
run 0 repair drawing.svg -o repaired.svg && sed 's/70-4/70-3/' drawing.svg >expected && holds cmp -s expected repaired.svg
# Paths that are defined and not drawn are repaired as well, or named.
svg '<defs><path d="M0 0X"/><path d="M0 0C10 0 20 2 40 0 70-4 80 0 90 0"/></defs>'
run 0 repair drawing.svg -o repaired.svg --allow-uncovered && says out "'X' is not a command" "defined and not drawn: 1 kinks before, 0 after" && sed 's/70-4/70-3/' drawing.svg >expected
holds cmp -s expected repaired.svg
# a path that is repeated is repaired once, and counted where it is drawn
kink='M0 0C10 0 20 2 40 0 70-4 80 0 90 0'
svg "<use href=\"#p\" transform=\"rotate(30)\"/><defs><symbol id=\"s\" viewBox=\"0 0 9 9\"><path id=\"p\" d=\"$kink\"/></symbol></defs><use href=\"#s\" width=\"3\" height=\"4\"/>"
run 0 repair drawing.svg -o repaired.svg && sed 's/70-4/70-3/' drawing.svg >expected && holds cmp -s expected repaired.svg
says out "before: 0 corners, 2 kinks" "after:  0 corners, 0 kinks" && lacks out "defined and not drawn" && holds [ "$(grep -c moved: out)" -eq 1 ]
run 0 verify repaired.svg --require G1 && says out "2 joins in 2 subpaths"
svg "<path id=\"p\" d=\"$kink\"/><use href=\"#p\"/><use href=\"#none\"/>" && run 1 repair drawing.svg -o repaired.svg
says out "before: 0 corners, 2 kinks" "after:  0 corners, 0 kinks" 'not repaired: use (line 2): there is no element "none"'
svg '<defs><path id="p" d="M0 0L10 0L20 1"/></defs><use href="#p" transform="scale(1 .5)"/>' && run 1 repair drawing.svg -o repaired.svg && says out "after:  0 corners, 1 kink"
# one with an error is left as it is, and counted up to there
svg "<path d=\"$kink 1\"/><path d=\"$kink\"/>" && run 1 repair drawing.svg -o repaired.svg && says out "before: 0 corners, 2 kinks" "after:  0 corners, 1 kink" \
  "not repaired: path (line 2): d, character 37: the end where a number is expected; it is left as it is"
sed 's/70-4 80 0 90 0"/70-3 80 0 90 0"/' drawing.svg >expected && holds cmp -s expected repaired.svg
svg "<path d=\"none\"/><path d=\"$kink\"/>" && run 0 repair drawing.svg -o repaired.svg
svg '<defs><path d="M0 0L10 0L30 1"/></defs>' && run 1 repair drawing.svg -o repaired.svg && says out "defined and not drawn: 1 kinks before, 1 after" "1 of them not free of kinks"
# No lengths of the handles at a node make its curvatures agree on the grid, as their squares would
# have the ratio 1 : 2; but those of the handles at the free ends can change, too. Not so where a
# curvature is there that must stay.
{ curve $'2 0\n4 4\n0 0 0 0 1 1 1 1\n40 0\n40 180\n110 320\n240 320' && curve $'2 0\n4 4\n0 0 0 0 1 1 1 1\n240 320\n330 320\n420 250\n420 60'; } >harm.g2
run 0 repair harm.g2 --to G2 -o harm2.g2 && says out "G2 instead of 4.143 %" "largest move: 6 units" && run 0 verify harm2.g2 --require G2
run 0 repair harm2.g2 --to G2 -o harm3.g2 && holds cmp -s harm2.g2 harm3.g2
run 0 repair harm.g2 --to G2 -o harm3.g2 --max-move 5 && says out "the curvature jumps by 0.09611 % instead of 4.143 %"
{ cat harm.g2 && curve $'2 0\n4 4\n0 0 0 0 1 1 1 1\n420 60\n420 -40\n420 -90\n300 -200'; } >harm4.g2
run 0 repair harm4.g2 --to G2 -o harm3.g2 && holds grep -q '^420 250$' harm3.g2
# Bounds, corners, and what is left.
path 'M0 0C10 0 20 2 40 0 70-4 80 0 90 0' 1 --max-move 1/2 && says out "the handle may move by 0.5" "1 kink"
path 'M0 0C10 0 20 9 40 0 70-4 80 0 90 0' 0 && becomes 'M0 0C10 0 20 9 40 0 70-4 80 0 90 0' && says out "1 corner"
path 'M0 0L10 0L30 1' 1 && says out "no handle can move"
path 'M0 0C10 9 30 0 60 0L 80 1' 1 && says out "not on this grid"
# Where a handle lies at the node the control point behind it tells the tangent, and moves, unless
# that harms the join at its own node.
path 'M0 0C0 9 30 1 30 1C40 1 50 0 60 0' 0 --kink-angle 45 && becomes 'M0 0C0 7 30 1 30 1C40 -1 50 0 60 0'
path 'M0 0C0 9 30 1 30 1C30 1 40-1 60 0' 0 --kink-angle 45 && says out "0 kinks"
path 'M0 9L0 0C0 -9 30 -1 30 -1L60 -2' 1 --kink-angle 45 && says out "behind command 3 at (30, -1): another join would be harmed"
path 'M0 0C0 0 30 1 30 1L60 3' 1 && says out "no handle can move"
path 'M0 0L1 2z M1 1' 0 && says out "0 kinks"
# Where the last decimal makes no grid, handles move by whole units of a coarser one from their
# nodes, which keep all of their digits, and that is told: numbers of 17 digits, large coordinates
# with many decimals, handles longer than 2^28 units.
path 'M0 0C1.1234567890123456789 0 20 2 40 0 70-4 80 0 90 0' 0 && says out 'path "p" (line 2), subpath 1: units of 0.000001 from node to handle, because its numbers have more digits'
path 'M0 0C1e9 .000000001 20 2 40 0 70-4 80 0 90 0' 0 && says out "because a coordinate is too large for its decimals" && run 0 verify repaired.svg --require G1
d3='M0.30000000000000004,10C10.1,12.799999999999999,20.200000000000003,20.000000000000004,30.3,20.1C40.4,20.200000000000003,50.5,18.4,60.599999999999994,10'
path "$d3" 0 && says out "units of 0.000001" "0 kinks" && becomes "$(sed 's/20.200000000000003,20.000000000000004/20.2,20/; s/40.4,20.200000000000003/40.4,20.2/' <<<"$d3")" && run 0 verify repaired.svg --require G1
cp d one && run 0 repair repaired.svg -o again.svg && holds cmp -s repaired.svg again.svg
long='M10.583333333 20.372916667C214.816666667 12.435416667 223.8125 8.73125 331.75 10.583333333C439.6875 12.435416667 541.804166667 19.05 647.095833333 20.108333333'
path "$long" 0 && says out "because a handle is longer than 2^28 units; --grid takes another one" "largest move: 0.3335 units of the grid 0.00001"
becomes "$(sed 's/8.73125/8.731253333/; s/12.435416667 541/12.435413333 541/' <<<"$long")" && run 0 verify repaired.svg --require G1
# Beside a line, and between handles of no short direction, one moves to a decimal multiple.
path 'M0 0L30.1234567890123456 10.9876543210987654C60.1 21.92 80 40 100 80' 0 && run 0 verify repaired.svg --require G1
path 'M0 0C9.123456789012345 7.345678901234567 20.98765432109876 30.123456789012345 40 50.123456789012345c19.01234567890123457 19.99 30 30 50 60' 0 --kink-angle 10
run 0 verify repaired.svg --require G1
path 'M0 0L30.1234567890123456 10.9876543210987654C60.1 21.92 80 40 100 80' 1 --grid 0.01 && says out "no unit of this grid lies in the direction"
# No number gets more decimals where that would make a join of what is rounding.
path 'M0 0L30.1234567890123456 10.9876543210987654C60.1 21.92 80 40 100 80L100 80.0000000000000001L180 240' 1 && says out "no unit of this grid lies in the direction"
# --grid asks for a grid: a finer one leaves less change.
path 'M0 0C10 9 30 0 60 0L 80 1' 0 --grid 0.1 && becomes "M0 0C10 9 30 -1.5 60 0L 80 1"
path 'M0 0c10 0 20 2 40 0s40-4 50 0s20-3.3 60 0' 0 --grid 1e-2 --kink-angle 9 --max-move 900 && run 0 verify repaired.svg --require G1
path 'M0 0C10 0 20 10.4 30.2 10.4C40 10.7 50 0 60 0' 0 --grid 1 && becomes 'M0 0C10 0 20.2 10.4 30.2 10.4C40.2 10.4 50 0 60 0'
# The curvatures, too.
path 'M0.1234567890123456 0.2C10.12345678901234 0.21 20.1234 10.12345678901234 30.12345678901234 10.12345678901234C40.12345678901234 10.12345678901235 50.1234567 0.3 60.1 0.2' 0 --to G2
says out "the curvature jumps by 4.175e-06 % instead of 0.9068 %" && run 0 repair repaired.svg -o again.svg --to G2 && holds cmp -s repaired.svg again.svg
# JSON.
if command -v python3 >/dev/null; then
  path 'M0 0C10 0 20 2 40 0 70-4 80 0 90 0L170 1' 1 --json
  holds python3 -c "import json; d = json.load(open('out')); m = d['moves']; assert d['before']['kinks'] == 2 and not d['met'] and \
    m == [{'element': 'path', 'id': 'p', 'line': 2, 'subpath': 1, 'curve': 1, 'point': 1, 'from': ['70', '-4'], 'to': ['70', '-3'], \
    'units': [1, 1]}] and d['largest_move'] == [1, 1] and len(d['not_repaired']) == 1, d"
fi
# Chains: decimals with exponents, fractions, gaps, rational curves.
{ curve "2 0"$'\n4 4\n0 0 0 0 1 1 1 1\n0 0\n1e1 0\n20 2\n40 0'; curve "2 0"$'\n4 4\n0 0 0 0 1 1 1 1\n40 0 70 -.4e1 80 0 90 0'; } >chain.g2
run 0 repair chain.g2 -o chain2.g2 && says out "1 kink" "0 kinks" && run 0 verify chain2.g2 --require G1
sed 's/-.4e1/-3/' chain.g2 >expected && holds cmp -s expected chain2.g2
sed 's/^1e1 0/1\/3 0/; s/^20 2/20 1\/3/' chain.g2 >fraction.g2 && run 0 repair fraction.g2 -o fraction2.g2 --kink-angle 9
says out "chain: units of 0.000001 from node to handle, because its numbers are no decimals" && run 0 verify fraction2.g2 --require G1 && holds grep -qx "1/3 0" fraction2.g2
sed 's/^20 2/20 1\/3000000/; s/^40 0$/40 1\/3/; s/^40 0 70 -.4e1/40 1\/3 70 1\/7/' chain.g2 >fraction.g2 && run 0 repair fraction.g2 -o fraction2.g2 && run 0 verify fraction2.g2 --require G1
sed 's/^20 2/20 1e-16/; s/-.4e1/0/' chain.g2 >fine.g2 && run 0 repair fine.g2 -o fine2.g2 && says out "1 kink" "0 kinks" && sed 's/ 1e-16/ 0/' fine.g2 >expected && holds cmp -s expected fine2.g2
cubic $'0 0 0\n1 0 0\n2 1 0\n3 0 0' >space.g2 && run 2 repair space.g2 -o none.g2 && says err "only curves in the plane"
holds [ ! -e none.g2 ]
# A gap is no kink, and nothing is proved: 1, as of verify --require G1.
{ curve $'2 0\n2 2\n0 0 1 1\n0 0\n10 5' && curve $'2 0\n2 2\n0 0 1 1\n10.0001 5\n20 10'; } >gap.g2
run 1 verify gap.g2 --require G1 && run 1 repair gap.g2 -o gap2.g2 && holds cmp -s gap.g2 gap2.g2
says out "behind curve 0 at (10, 5): a gap, as the next curve starts at (10.0001, 5)" "after:  1 gap" "1 of them not free of kinks and gaps" && lacks out proved
# --close closes it, where that is nearest and harms least, up to a width.
run 0 repair gap.g2 -o gap2.g2 --close 1e-4 && sed 's/10.0001 5/10 5/' gap.g2 >expected && holds cmp -s expected gap2.g2
says out "closed: chain, behind curve 0 at (10, 5): the ends were 0.0001 apart" "moved: chain, curve 1, point 0: (10.0001, 5) -> (10, 5), 1 unit" "every join is free of kinks, proved" && lacks out "not repaired"
run 0 verify gap2.g2 --require G1 && run 0 repair gap.g2 -o gap2.g2 --close 1e-4 --json && says out '"gap":[' '"closed":[' '"largest_move":[1,1]'
run 1 repair gap.g2 -o gap2.g2 --close 9e-5 && holds cmp -s gap.g2 gap2.g2 && says out "which is farther away than --close"
# Both ends of a wider gap move to its middle, with their handles: what is smooth at other ends
# stays.
line0=$'2 0\n2 2\n0 0 1 1\n0 0\n10 0' left0=$'2 0\n4 4\n0 0 0 0 1 1 1 1\n10 0\n20 0\n27 9\n30 10' right0=$'2 0\n4 4\n0 0 0 0 1 1 1 1\n31 12\n34 13\n40 20\n50 20'
{ curve "$line0" && curve "$left0" && curve "$right0"; } >gap3.g2 && run 0 repair gap3.g2 -o gap4.g2 --close 3 && run 0 verify gap4.g2 --require G1
sed 's/^27 9$/27 10/; s/^30 10$/30 11/; s/^31 12$/30 11/; s/^34 13$/33 12/' gap3.g2 >expected && holds cmp -s expected gap4.g2
# With 17 digits: the middle has one more.
{ curve $'2 0\n3 3\n0 0 0 1 1 1\n0 0\n5 0\n10 5.0000000000000001' && curve $'2 0\n2 2\n0 0 1 1\n10 5.0000000000000004\n15 10'; } >gap3.g2 && run 0 repair gap3.g2 -o gap4.g2 --close 1e-15
says gap4.g2 "10 5.00000000000000025" && run 0 verify gap4.g2 --require G0 && lacks out gap
# Curves that run backwards are named, and reversed by --reverse.
{ curve $'2 0\n2 2\n0 0 1 1\n0 0\n10 0' && curve $'2 0\n4 4\n0 0 0 0 1 1 1 1\n20 10\n20 4\n16 0\n10 0' && curve $'2 0\n2 2\n0 0 1 1\n20 10\n20 30'; } >back.g2
run 0 verify back.g2 && says out "curve 1 runs backwards: to reverse it closes both gaps (repair --reverse)" && run 0 verify back.g2 --json --summary && says out '"backward_curves":[1]'
run 1 repair back.g2 -o back2.g2 && holds cmp -s back.g2 back2.g2 && says out "chain: curve 1 reversed would close 2 gaps; --reverse does that"
run 0 repair back.g2 -o back2.g2 --reverse && says out "reversed: curve 1" "after:  0 corners, 0 kinks, 2 G1" && lacks out "nothing is changed" && run 0 verify back2.g2 --require G1
{ curve $'2 0\n2 2\n0 0 1 1\n0 0\n10 0' && curve $'2 0\n4 4\n0 0 0 0 1 1 1 1\n10 0\n16 0\n20 4\n20 10' && curve $'2 0\n2 2\n0 0 1 1\n20 10\n20 30'; } >expected && holds cmp -s expected back2.g2
run 0 repair back2.g2 -o back3.g2 --reverse && holds cmp -s back2.g2 back3.g2 && lacks out "reversed:" && lacks out backwards && run 0 repair back.g2 -o back3.g2 --reverse --json && says out '"reversed":[' ' 1]'
# Knots that are not symmetric, and weights, are reversed, too.
{ curve $'2 0\n5 4\n0 0 0 0 1/2 2 2 2 2\n9 9\n8 8\n7 8\n1 0\n0 0' && curve $'2 1\n3 3\n0 0 0 1 1 1\n20 10 1\n20 4 2\n27 27 3'; } >back.g2
run 1 repair back.g2 -o back2.g2 --reverse && says out "reversed: curve 0" "reversed: curve 1" && run 0 verify back2.g2 --require G0
{ curve $'2 0\n5 4\n0 0 0 0 1.5 2 2 2 2\n0 0\n1 0\n7 8\n8 8\n9 9' && curve $'2 1\n3 3\n0 0 0 1 1 1\n27 27 3\n20 4 2\n20 10 1'; } >expected && holds cmp -s expected back2.g2
run 1 repair gap.g2 -o gap2.g2 --json && says out '"met":false' '"gaps":1' '"not_met":1'
run 1 repair chain.g2 --closed -o gap2.g2 && says out "0 kinks" "1 gap" "1 of them not free of kinks and gaps" # which does not lead back
run 2 repair "$teapot" -o none.g2 && run 2 repair chain.g2 -o none.svg && says err "the format is .g2"

# Fonts: a list of moves. A node between two handles may be one that TrueType leaves out; with
# halves of units nothing moves.
font font.ttf <<'END'
glyph .notdef
glyph mended 65
contour 0,0 100,0 200,7* 300,300 0,300
glyph implied 66
contour 0,0 100,0 200,6* 300,100* 300,300 0,300
glyph halves 67
contour 0,0 100,0 200,6* 301,100* 300,300 0,300
END
cp font.ttf given.ttf && run 1 repair font.ttf -o moves.json && holds cmp -s font.ttf given.ttf
says out "4 glyphs, 3 with kinks, of which 1 is repaired" "kinks: 3 before, 2 after the moves" "2 of them not free of kinks" "1 handle, at most 7 units, in the glyph mended"
says moves.json '{"glyph":"mended","index":1,"contour":0,"point":2,"node":[100,0],"from":[200,7],"to":[200,0]}' '"contour":0,"node":[100,0],"reason":"no handle can move"'
says moves.json '{"glyph":"halves","index":3,"contour":0,"node":[100,0],"reason":"no handle can move"}' # in units of the font
# A name of anything that is no font and no JSON is refused, and nothing is written.
for name in new.pfb new.svg new.g2; do
  run 2 repair font.ttf -o $name && holds [ ! -e $name ]
  says err "--output: $name: the format is .json" "fonts are written as .ttf, .otf, .woff and .woff2"
done
# The joins are those of verify, by the same words, also in components, before and, of the font that
# the moves make, after.
cat >classes.txt <<'END'
glyph .notdef
glyph base 65
contour 0,0 100,0 200,7* 300,300 0,300
contour 500,0 600,0 700,1* 800,300 500,300
contour 900,0 1000,0 1200,9 1200,300
glyph twice 66
component 1 400 0
component 1 0 900 0.5
END
font classes.ttf <classes.txt && run 0 verify classes.ttf && cp out verified
run 0 repair classes.ttf -o moves.json && says out "3 glyphs, 2 with kinks, of which 2 are repaired" "kinks: 3 before, 0 after" "1 consist of components"
before=$(sed -n 's/^before: //p' out) && says verified "$before" && says out "3 bends of two lines" "3 off by rounding"
after=$(sed -n 's/^after:  //p' out)
sed 's/200,7/200,0/; s/700,1/700,0/' classes.txt >mended.txt && font mended.ttf <mended.txt
run 0 verify mended.ttf && says out "$after"
says moves.json '"contour":2,"node":[1000,0],"reason":"no handle can move"}' '"kinks":3,"kinks_off_by_more_than_one_unit":6,"bends":3,"rounding":3'
run 0 verify classes.ttf --off-by 20 && cp out verified
run 0 repair classes.ttf -o moves.json --off-by 20 --max-move 1/2 && says verified "$(sed -n 's/^before: //p' out)" && says out "0 kinks"
run 2 repair chain.g2 -o chain2.g2 --off-by 1 && says err "--off-by: only for fonts"
# Points are those of the table 'glyf', whatever the left side bearing is, in glyphs with components
# as well.
font bearing.ttf -v bearing=5 <classes.txt
run 0 repair classes.ttf -o moves.json && run 0 repair bearing.ttf -o bearing.json && holds cmp -s moves.json bearing.json
run 0 verify classes.ttf --json && sed 's/classes.ttf//' out >expected && run 0 verify bearing.ttf --json && sed 's/bearing.ttf//' out >given
holds cmp -s given expected
# Beside a node that is left out, at half a unit, no handle moves. A join that falls from G2 to G1
# is counted, and a glyph that cannot be read.
printf 'glyph .notdef\nglyph halves 65\ncontour 0,0 100,0 200,7* 300,100 350,201* 301,300* 200,350\n' | font halves.ttf
run 1 repair halves.ttf -o moves.json && says moves.json '"moves":[]' '"reason":"no handle can move"'
printf 'glyph .notdef\nglyph wave 65\ncontour -100,100 0,40* 200,0* 300,0 400,0* 600,40* 700,100 1100,352\n' | font wave.otf -v outlines=cff
run 0 repair wave.otf -o moves.json && says out "1 join falls from G2 to G1" && says moves.json '"from":[600,40],"to":[600,37]'
printf 'glyph .notdef\nglyph good 65\ncontour 0,0 100,0 100,100\nglyph lost 66\ncomponent 3 0 0\n' | font lost.ttf
run 1 repair lost.ttf -o moves.json && says out "not covered: 1 glyph, invalid composite glyph" && run 0 repair lost.ttf -o moves.json --allow-uncovered
head -c 100 font.ttf >cut.ttf && run 2 repair cut.ttf -o none.json && holds [ ! -e none.json ]

# Arcs are joins like others: they stay smooth, and the handle that meets one moves to its tangent.
path 'M0 10A10 10 0 0 0 10 0Q10 -30 42 -60L82 -100' 0 && becomes 'M0 10A10 10 0 0 0 10 0Q10 -28 42 -60L82 -100'
says out "2 units" && run 0 verify repaired.svg --require G1 && says out "0 kinks"
path 'M0 0A10 10 0 0 1 10 10C9 20 15 40 30 40' 0 --kink-angle 6 && becomes 'M0 0A10 10 0 0 1 10 10C10 20 15 40 30 40'
path 'M0 0A10 10 0 0 0 10 -10C9 -20 15 -40 30 -40' 0 --kink-angle 6 && becomes 'M0 0A10 10 0 0 0 10 -10C10 -20 15 -40 30 -40'
path 'M0 0A10 10 0 0 1 -10 10C-20 9 -40 15 -40 30' 0 --kink-angle 6 && becomes 'M0 0A10 10 0 0 1 -10 10C-20 10 -40 15 -40 30'
path 'M0 0A10 10 0 0 1 10 10C8 30 15 40 30 40' 0 --kink-angle 6 && becomes 'M0 0A10 10 0 0 1 10 10C10 30 15 40 30 40'
path 'M0 0A10 10 0 0 1 10 10Q10 30 30 40' 0 && becomes 'M0 0A10 10 0 0 1 10 10Q10 30 30 40' && says out "0 kinks, 1 G1"
path 'M0 0A5 5 0 0 1 1 0C2 1 9 9 20 1' 1 --kink-angle 45 && says out "no point of the grid lies in the direction of the arc"
path 'M0 0A5 5 0 0 1 1 0Q2 0.2 3 0.2L9 0.3' 1 --kink-angle 6 # what is beside an irrational tangent keeps its grade
path 'M0 0A3 4 30 0 1 5 5Q6 9 30 40L40 51' 1 && becomes 'M0 0A3 4 30 0 1 5 5Q6 9 30 40L40 51' # which stays a corner beside a rotated ellipse
says out "not on this grid" "before: 1 corner, 1 kink"
path 'M0 0A5 4 1e-350 0 1 10 0Q10 9 20 30L29 51' 1 && becomes 'M0 0A5 4 1e-350 0 1 10 0Q10 9 20 30L29 51' # no direction changes beside what is undecided
says out "both nodes bind the handle of a quadratic" "undecided: 1 join, an arc of a rotated ellipse"
# Other radii and ends of arcs with which a kink vanishes are told, and --arcs takes the first that
# is a short decimal.
arcs='M 10 30 A 20 20 0 0 1 46 30 A 25 25 0 0 0 90 30'
path "$arcs" 1 && becomes "$arcs" && says out "behind command 2: no point of the grid lies in the direction of the arc; smooth with the end (91, 30) of command 3, or with the start (10.8, 30) of command 2, or with the radius 220/9 of command 3, which is no short decimal, or with the radius 225/11 of command 2, which is no short decimal; --arcs takes the first"
path "$arcs" 1 --json && says out '"smooth_with":[{"curve":1,"end":["91","30"],"is_decimal":true},{"curve":0,"start":["10.8","30"],"is_decimal":true},{"curve":1,"radii":["220/9","220/9"],"is_decimal":false}'
path "$arcs" 0 --arcs && becomes "${arcs/90 30/91 30}" && says out 'changed: path "p" (line 2), subpath 1, command 3, end: (90, 30) -> (91, 30)' && run 0 verify repaired.svg --require G1
path "${arcs}m5 5h1" 0 --arcs && becomes "M 10.8 30 A 20 20 0 0 1 46 30 A 25 25 0 0 0 90 30m5 5h1" && run 0 verify repaired.svg --require G1 # what follows does not move
path 'M10 30a20 20 0 0136 0a25 25 0 0044 0m5 5h1' 0 --arcs && becomes 'M10.8 30a20 20 0 01 35.2 0a25 25 0 0044 0m5 5h1'
path "${arcs}L 99 9" 0 --arcs --kink-angle 3 && becomes "M 10.8 30 A 20 20 0 0 1 46 30 A 25 25 0 0 0 90 30L 99 9"
path 'M 10 50 L 40 50 A 15 15 0 0 1 54 58' 0 --arcs && becomes 'M 10 50 L 40 50 A 16.25 16.25 0 0 1 54 58' && says out "command 3, radius: 15 -> 16.25" && run 0 verify repaired.svg --require G1
path 'M 10 50 L 40 50 A 15 15 0 0 1 54 58' 0 --arcs --json && says out '"what":"radius","from":["15"],"to":["16.25"]' '"moves":[]'
path 'M0 0H40A21 21 0 0 1 60 20V60' 0 --arcs && becomes 'M0 0H40A20 20 0 0 1 60 20V60' && says out "2 kinks" "0 kinks"
path 'M0 0H40A21 42 0 0 1 60 40V60' 0 --arcs --kink-angle 9 && becomes 'M0 0H40A20 40 0 0 1 60 40V60' # of the same ratio
path 'M0 0H40A20 20 0 0 1 60 20L61 60' 1 --arcs && becomes 'M0 0H40A20 20 0 0 1 60 20L61 60' && lacks out "smooth with" # a smooth join stays
for option in --arcs "--arcs --to G2"; do
  svg '<path transform="scale(2 1)" d="M0 0H40A21 21 0 0 1 60 20V60"/>' && run 0 repair drawing.svg -o repaired.svg $option --kink-angle 9 && says repaired.svg 'd="M0 0H40A20 20 0 0 1 60 20V60"'
done
# A filled path has a join where it ends at its start, which is mended like others; a stroked path
# has none.
ring='M50 10C72 10 90 28 90 50C90 72 72 90 50 90C28 90 10 72 10 50C10 28 28 11 50 10'
path "$ring" 0 && becomes "${ring/28 11/28 10}" && says out "0 corners, 1 kink" "0 corners, 0 kinks, 0 G1, 4 G2" && run 0 verify repaired.svg --require G1
for drawing in "<g style=\"fill:none\"><path d=\"$ring\"/></g>" "<defs><path fill=\"none\" d=\"$ring\"/></defs>"; do
  svg "$drawing" && run 0 repair drawing.svg -o repaired.svg && holds cmp -s drawing.svg repaired.svg
done
svg "<defs><path id=\"r\" d=\"$ring\"/></defs><use href=\"#r\" x=\"5\"/>" && run 0 repair drawing.svg -o repaired.svg && says repaired.svg "${ring/28 11/28 10}" && run 0 verify repaired.svg --require G1
# Segments that are rounding are looked through, as verify does, and stay as they are.
rounding='M20 60c0-5.523 4.477-10 10-10s10 4.477 10 10-4.477 10-10 10-10-4.477-10-10.001Z'
path "$rounding" 0 && becomes "$rounding" && says out "0 corners, 0 kinks, 1 G1, 3 G2"
path 'M0 0C10 0 40 0 50 0H50.00V.01C60 .51 100 3 100 9' 1 && says out "1 kink" \
  'not repaired: path "p" (line 2), subpath 1, behind command 2: a segment that is rounding' "a segment that is rounding lies between the curves"
# Handles move no farther than twice what the kink is off and one unit.
path 'M0 0C20 0 60 30 100 30C143 30 180 31 200 60L300 206' 1 && says out "the handle may move by"
# Shapes are counted like paths, and named; an angle is what is drawn.
svg '<polygon points="0 0 100 0 200 1 200 200"/>' && run 1 repair drawing.svg -o repaired.svg
says out 'polygon (line 2), behind command 2: no handle can move' "before: 3 corners, 1 kink" "after:  3 corners, 1 kink" && run 1 verify drawing.svg --require G1
svg '<path transform="scale(1 .1)" d="M0 0L100 0C120 8 200 60 300 60"/>' && run 1 verify drawing.svg --require G1 && says out "1 kink"
run 1 repair drawing.svg -o repaired.svg --max-move 1 && says out "after:  0 corners, 1 kink"
run 0 repair drawing.svg -o repaired.svg --max-move 9 && run 0 verify repaired.svg --require G1 && says out "0 kinks"
# Among several moves the one that changes the curves least is taken, measured by how far a handle
# moves their points; a move that leaves fewer kinks comes first.
path 'M0 0Q19 9 38 8Q77 8 89 0' 0 && becomes 'M0 0Q19 8 38 8Q77 8 89 0'
path 'M0 0C9 6 21 -4 32 10Q42 25 52 11Q79 -28 84 -12' 1 && becomes 'M0 0C9 6 22 -5 32 10Q42 25 52 11Q79 -28 84 -12'
path 'M0 0L32 1Q93 5 102 19Q110 33 116 53' 1 && becomes 'M0 0L32 1Q93 5 102 19Q111 33 116 53'
# Mirror images stay mirror images, also where two moves are equally good, and where neighbours
# share the handle of a quadratic.
path 'M0 0C6 2 18 10 37 -1C56 -11 66 -4 75 -5' 0 && becomes 'M0 0C6 2 18 9 37 -1C56 -11 66 -4 75 -5'
path 'M0 0C2 6 10 18 -1 37C-11 56 -4 66 -5 75' 0 && becomes 'M0 0C2 6 9 18 -1 37C-11 56 -4 66 -5 75'
path 'M75 5C66 4 56 11 37 1C18 -10 6 -2 0 0' 0 && becomes 'M75 5C66 4 56 11 37 1C18 -9 6 -2 0 0'
path 'M0 0C38 -3 38 -10 48 -28Q66 -65 82 -72Q115 -86 126 -90Q138 -94 145 -113' 1 && becomes "$(sed -n 's/.* d="\([^"]*\)".*/\1/p' drawing.svg)"
# A corner stays a corner, and a join that falls from G2 to G1 is told.
path 'M0 9L10 0Q20 1 30 20L40 40' 0 --kink-angle 6 --max-move 20 && says out "1 corner" && run 0 verify repaired.svg --require G1 --kink-angle 6 && says out "1 corner"
path 'M0 0C10 0 20 10 30 10C40 10 50 0 60 0C70 0 80 11 90 10' 0
path 'M-10 10C0 10 20 10 30 0C40-10 60-10 70-10C80-10 100-9 110-9' 0 && says out "0 kinks"
wave='M-100 100C0 40 200 0 300 0C400 0 600 40 700 100'
path "${wave}L1100 352" 0 && becomes 'M-100 100C0 40 200 0 300 0C400 0 600 37 700 100L1100 352'
says out 'path "p" (line 2), subpath 1, behind command 2 at (300, 0): G2 before, now G1'
path "${wave}L1100 352" 0 --json && says out '"before":"G2","after":"G1"'
path "${wave}C800 163 1000 300 1100 400" 0 && becomes "${wave}C800 160 1000 300 1100 400" && lacks out "G2 before"
path "${wave}C800 160 900 290 950 400" 0 --to G2 && lacks out "G2 before" && holds [ "$(cut -c 1-${#wave} d)" = "$wave" ] && says out "1 are harmonised"
# Handles are harmonised by a tenth of the shorter one.
path 'M0 0Q20 5 30 18C57 57 63 67 80 50' 0 --to G2 && becomes 'M0 0Q21 5 30 18C57 57 63 67 80 50'
# The curvature beside an arc is harmonised at the other end of a curve.
path 'M0 0A100 100 0 0 1 100 100C100 200 150 400 300 400C450 400 600 195 600 0' 0 --to G2 && says out "1 are harmonised"
run 0 verify repaired.svg --require G1
# --to G2 is idempotent.
for d in 'M0 0C10 0 25-20 40-20s31 22 40 60 20 30 40 30' 'M0 0C30 0 50 20 50 50S80 110 100 100 150 60 150 30 120-30 90-30 40-40 0 0z' \
  'M100 0C100 53 57 99 3 100S-96 55-100 0-60-97 0-100 100-51 100 0z'; do
  svg "<path d=\"$d\"/>" && "$program" repair drawing.svg -o once.svg --to G2 >out 2>err
  "$program" repair once.svg -o twice.svg --to G2 >out 2>err
  holds cmp -s once.svg twice.svg && lacks out "moved:"
done
# The grid of a path stays what it is when the number with the most decimals moves.
path 'M0 0c10 0 20 2 40 0 30-3.01 40 0 50 0' 0 --max-move 100 && becomes 'M0 0c10 0 20 2 40 0 30-3.00 40 0 50 0'
# A drawing with very many subpaths takes a time and memory in proportion.
{ printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="' && yes 'M0 0h1v1z' | head -n 50000 | tr -d '\n' && printf '"/></svg>\n'; } >many.svg
if ! grep -qa __asan_init "$program"; then
  (ulimit -v 400000 && exec timeout 60 "$program" repair many.svg -o many2.svg >out 2>err)
  holds [ $? -eq 0 ] && holds cmp -s many.svg many2.svg && says out "before: 150000 corners"
  sed 's/M0 0h1v1z"/M0 0h1v1zM0 0L100 0L200 1"/' many.svg >kink.svg # which is looked for a repair
  (ulimit -v 400000 && exec timeout 60 "$program" repair kink.svg -o many2.svg >out 2>err)
  holds [ $? -eq 1 ] && holds cmp -s kink.svg many2.svg && says out "no handle can move"
fi

# Bad input and bad targets: nothing is lost.
refused() { # refused REASON ARGUMENTS...
  local reason=$1
  shift
  echo kept >target
  run 2 repair "$@" -o target && says err "$reason"
  holds [ "$(cat target)" = kept ] && holds [ ! -s out ]
}
printf '<svg><path d="M0 0l1 1"/>' >cut.svg && refused "no element found" cut.svg
refused "No such file" missing.svg
gzip -c "$leaf" >packed.svg && refused "packed by gzip; unpack it first" packed.svg
printf '\xff\xfe' >utf16.svg && printf '<svg><path d="M0 0h1v1"/></svg>' | sed 's/./&\x00/g' >>utf16.svg && refused "UTF-16" utf16.svg
refused "--kink-angle" "$leaf" --kink-angle 0
refused "--kink-angle" "$leaf" --kink-angle 46
refused "--kink-angle" "$leaf" --kink-angle x
refused "--max-move" "$leaf" --max-move -1
refused "--to" "$leaf" --to G3
refused "--closed" "$leaf" --closed
refused "--close" "$leaf" --close 1
refused "--reverse" "$leaf" --reverse
refused "--arcs: only for drawings" gap.g2 --arcs
refused "--close" gap.g2 --close 0
refused "is no power of ten such as 0.001" "$leaf" --grid 0.5
refused "--grid: not with fonts" font.ttf --grid 1
run 2 repair "$leaf" && says err "-o FILE is needed" && run 2 repair -o x && run 2 repair "$leaf" "$badge" -o x
run 2 repair "$leaf" -o no/folder.svg && says err "no/folder.svg"
if [ "$(id -u)" -ne 0 ]; then
  mkdir closed && cp "$leaf" closed/leaf.svg && chmod 555 closed
  run 2 repair closed/leaf.svg -o closed/leaf.svg && holds cmp -s "$leaf" closed/leaf.svg
  chmod 755 closed
fi
run 0 repair --help && says out "usage: geometric_continuity repair"

# The report names the curves that stay as they are.
run 0 repair "$leaf" -o once.svg --to G2 && lacks out "nothing is changed"
run 0 repair once.svg -o twice.svg --to G2 && says out "nothing is changed: no handle moves" && holds cmp -s once.svg twice.svg
