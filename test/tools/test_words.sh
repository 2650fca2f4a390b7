#!/usr/bin/env bash
# Reports say nothing that was not proved, in bounds that hold and in texts that are valid whatever
# names files and elements have; long work shows that it goes on.
. "$(dirname "$0")/functions.sh"


# Nothing to decide is no success, unless it is allowed; and it is never said to be proved.
nothing() { # nothing WHAT ARGUMENTS...
  local what=$1
  shift
  run 2 verify "$@" && says out "no $what, nothing was decided" && says err "there is no $what" "--allow-empty" && lacks out proved
  run 0 verify "$@" --allow-empty --allow-uncovered && says out "no $what, nothing was decided" && lacks out proved
  holds [ ! -s err ]
}
patch=$'200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0'
svg '' && nothing join drawing.svg && nothing join drawing.svg --require G2
printf '<svg/>' >drawing.svg && nothing join drawing.svg --require G0
svg '<text>letters</text><image/>' && nothing join drawing.svg --require G0
svg '<use/><rect width="1%"/><path d="M0 0"/>' && nothing join drawing.svg --require G0 && says out "; 2 elements not verified"
printf '%s\n' "$patch" >patch.g2 && nothing "shared edge" --surfaces patch.g2 && nothing "shared edge" --surfaces patch.g2 --require G0
nothing "shared edge" --surfaces patch.g2 --require G0 --within 1,1e-9
run 2 verify "$L" --require G0 && says err "no join"
run 0 verify "$L" --require G0 --allow-empty && says out "no join, nothing was decided" && lacks out proved
for options in "" "--allow-empty --allow-uncovered"; do
  [ -z "$options" ] && code=2 || code=0
  run $code verify drawing.svg --require G2 --json $options && says out '"joins":0' '"met":null'
  run $code verify --surfaces patch.g2 --require G1 --json $options && says out '"edges":[]' '"met":null'
done
run 0 verify --closed "$L" && run 1 verify --closed "$L" --require C0 && lacks out "nothing was decided"

# Things that are not covered or undecided are named, and the requirement is not met unless an
# option allows them.
round='<path d="M0 0h1 2z"/>' # three lines, two of them in one direction
svg "$round<use/>"
run 1 verify drawing.svg --require G0 && says out "not covered: 1 element, it does not say which element it repeats" && lacks out "proved"
says out "not met, because not all was decided (see --allow-uncovered)"
run 0 verify drawing.svg --require G0 --allow-uncovered && says out "that was decided is G0, proved exactly" && lacks out "not met"
run 1 verify drawing.svg && run 1 verify drawing.svg --require G0 --json && says out '"met":false'
run 0 verify drawing.svg --require G0 --json --allow-uncovered && says out '"met":true'
svg "$round" && run 0 verify drawing.svg --require G0 && lacks out "not covered" "not met"
svg '<use/>' && run 2 verify drawing.svg && run 1 verify drawing.svg --allow-empty && run 0 verify drawing.svg --allow-empty --allow-uncovered
# an ellipse that is turned by too little
svg "$undecided_path" && run 1 verify drawing.svg && says out "undecided: 1 join" && run 0 verify drawing.svg --allow-undecided
run 1 verify drawing.svg --require G0 && says out "undecided: 1 join" && lacks out "proved"
# edges of surfaces that are points
run 1 verify --surfaces "$teapot" --require G0 && lacks out "proved" && says out "not covered: 8 collapsed edges, single points, where" \
  "not met, because not all was decided (see --allow-uncovered)"
run 0 verify --surfaces "$teapot" --require G0 --allow-uncovered && says out "every shared edge that was decided is G0, proved exactly" && lacks out "not met"
run 1 verify --surfaces "$teapot" && run 0 verify --surfaces "$teapot" --allow-uncovered
flat "$flat_points" >flat.g2 && run 0 verify --surfaces flat.g2 --require G2
run 0 verify --closed "$L"

# Printed bounds enclose those of JSON, which are written without loss.
if command -v python3 >/dev/null; then
  cat >bounds.py <<'END'
import decimal, json, re, sys
from fractions import Fraction
text, report = open(sys.argv[1]).read(), json.load(open(sys.argv[2]), parse_float=str, parse_int=str)
names = {"gap": "gap", "curvature jump": "curvature_percent", "torsion jump": "torsion_jump",
         "normal angle" if "edges" in report else "tangent angle": "angle_degrees"}
exact = lambda word: Fraction(decimal.Decimal(word))
decided = [x for key in ("joins", "edges", "knot_lines", "near_edges") for x in report.get(key, [])]
checks = 0
lines = re.findall("within the tolerance: order.*; (gap.*)", text)
assert len(lines) == len(decided), (len(lines), len(decided))
for line, x in zip(lines, decided):
    for name, key in names.items():
        found = re.search(name + r" (?:\[([^],]*), ([^]]*)\]|([^ ,%]*))", line)
        if not found:
            assert x.get(key) is None, (line, key)
            continue
        low, high = found.group(1) or found.group(3), found.group(2) or found.group(3)
        for bound in x[key]:
            assert exact(low) <= exact(bound) <= exact(high), (line, x)
            assert exact(low) <= Fraction(float(bound)) <= exact(high), (line, x)
            checks += 1
angles = re.findall(r"(?<=angle <= )[-+.e0-9]+", text)
bounds = [x["angle_at_most_degrees"] for x in decided if float(x.get("angle_at_most", 0)) > 0]
assert len(angles) == len(bounds), (angles, bounds)
assert not bounds or max(map(len, bounds)) > 14, bounds # not rounded to the precision of the stream
for angle, bound in zip(angles, bounds):
    assert exact(angle) >= Fraction(float(bound)), (angle, bound)
    checks += 1
print(checks, "bounds")
sys.exit(checks < int(sys.argv[3]))
END
  enclose() { # enclose LEAST ARGUMENTS...: at least LEAST printed bounds enclose
    local least=$1
    shift
    run 0 verify "$@" && mv out bounds.txt && run 0 verify "$@" --json && holds python3 bounds.py bounds.txt out "$least"
  }
  enclose 150 --closed "$S" --within 0.004,0.1,0
  "$program" blend "$L" "$R" --kernel double -o rough.g2 >out
  enclose 8 "$L" rough.g2 "$R" --within 1e-9,1e-9,0,1e-9
  enclose 12 "$L" "$R" "$L" "$R" --within 1,1,1
  enclose 200 --surfaces "$teapot" --allow-uncovered --within 0.1,1e-3
  flat $'1 1 2 2\n0 1 1/999999999\n1 1 0\n2 1 0\n3 1 1/7\n4 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 1/3' >near.g2
  enclose 10 --surfaces flat.g2 near.g2 --within 1,1
fi

# Names cannot make the output invalid, nor look like a line of it, nor command a terminal.
name=$'a\xff\xed\xa0\x80 \xef\xbf\xbe\n\x1b[31m'
visible='a\xff\xed\xa0\x80 '$'\xef\xbf\xbe''\n\x1b[31m'
plain() { # plain FILE LINES: it has so many lines, and no control characters, neither of one byte nor of two
  holds [ "$(wc -l <"$1")" -eq "$2" ]
  holds [ "$(tr -d '\n' <"$1" | LC_ALL=C grep -cP '[\x00-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xaa-\xae]')" -eq 0 ]
}
for file in "$name.g2" "$name.svg"; do
  run 2 verify "$file" && plain err 1 && says err "$visible"
  printf 'x' >"$file" && run 2 verify "$file" "$file" && plain err 1 && says err "$visible"
done
run 2 "$name" && says err "$visible" && run 2 verify "--$name" "$L" && plain err 1
element='<path d="M0 0h1v1" id="p&#10;every join is G9&#x9b;31m&#x202e;&#xfffe;"/>'
svg "${element/&#xfffe;/}<use id=\"u&#10;3 joins\"/>" && cp drawing.svg "$name.svg"
run 1 verify "$name.svg" drawing.svg && plain out 7
says out "$visible.svg: path \"p\\nevery join is G9\\u009b31m\\u202e\" (line 2)" 'use "u\n3 joins"'
svg "$element" && run 2 verify drawing.svg # a character that XML does not allow
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >"$name.g2"
run 0 plot "$name.g2" -o title.svg --title "$name<&>" && run 0 verify title.svg --allow-empty
if command -v python3 >/dev/null; then
  holds python3 -c "import xml.dom.minidom as m; m.parse('title.svg')"
  run 1 verify "$name.svg" "$name.svg" --json
  holds python3 -c "import json; d = json.loads(open('out', 'rb').read().decode('utf-8')); j = d['joins']; assert len(j) == 2 and \
    j[0]['file'] == 'a' + 4 * '\ufffd' + ' \ufffe\n\x1b[31m.svg' and j[0]['id'] == 'p\nevery join is G9\x9b31m\u202e'"
fi

# Work that takes longer than a second shows its speed, on a terminal only, and erases that at the
# end. The input is a pipe that keeps the program waiting.
slowly() { # slowly FILE FIRST SECOND: a pipe with both texts, the second later
  rm -f "$1" && mkfifo "$1"
  { cat "$2" && sleep 1.2 && cat "$3"; } >"$1" &
}
shown() { # shown PATTERN COMMAND: what the command writes to a terminal as errors has the pattern, and is erased
  script -qec "{ $2; } >out" terminal >/dev/null </dev/null
  holds [ "$(grep -cP "\r\x1b\[K$1.*\r\x1b\[K$" terminal)" -gt 0 ]
  lacks out "/s"
}
for i in {1..300}; do cubic "$i 0 0"$'\n'"$i 1 0"$'\n'"$((i + 1)) 1 0"$'\n'"$((i + 1)) 0 0"; done >many.g2
for i in {1..300}; do printf '%s\n' "$patch"; done >patches.g2
svg "$round" && sed '$d' drawing.svg >first.svg && sed 1d drawing.svg >second.svg
for i in {1..20}; do cat many.g2; done >long.g2
verify=$(printf '%q verify' "$program")
if command -v script >/dev/null && script -qec true terminal >/dev/null </dev/null; then
  slowly pipe.g2 many.g2 many.g2 && shown '\d+ joins, \d+(\.\d)?/s' "$verify pipe.g2"
  slowly pipe.g2 patches.g2 patches.g2 && shown '\d+ surfaces read, \d+(\.\d)?/s' "$verify --surfaces pipe.g2"
  slowly pipe.svg first.svg second.svg && shown '\d joins, \d+(\.\d)?/s' "$verify pipe.svg"
  # of a file it is known what is left; the program is stopped for a while, so that it takes long
  # enough
  shown '\d+ joins, \d+(\.\d)?/s, \d+ s left' "$verify long.g2 --within 1,1,1 & sleep 0.1; kill -STOP \$!; sleep 1.1; kill -CONT \$!; wait"
fi
slowly pipe.g2 many.g2 many.g2 && run 0 verify pipe.g2 && holds [ ! -s err ]
