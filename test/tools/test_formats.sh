#!/usr/bin/env bash
# Reports for other programs: JSON, SARIF and JUnit's XML, validated by schemas; they say what the
# text says.
. "$(dirname "$0")/functions.sh"

# valid SCHEMA FILE: the file will be validated by the schema of this name, at the end all at once
valid() { cp "$2" "report_$((++reports))_by_$1"; }
reports=0
command -v xmllint >/dev/null || echo "skipped: XML is not validated, xmllint is missing"
valid_junit() {
  if command -v xmllint >/dev/null; then holds xmllint --noout --schema "$here/schemas/junit.xsd" "$1" 2>/dev/null; fi
}
count() { grep -o -- "$1" "$2" | wc -l; }

# formats SCHEMA CODE ERRORS WARNINGS NOTES PASSED ARGUMENTS...: all formats of this report are
# valid, have this exit code, and SARIF and JUnit have so many findings of each level, JUnit also so
# many places without one
formats() {
  local schema=$1 code=$2 errors=$3 warnings=$4 notes=$5 passed=$6
  shift 6
  run "$code" verify "$@"
  run "$code" verify "$@" --json && valid "$schema" out && mv out json
  run "$code" verify "$@" --format json && holds cmp out json
  run "$code" verify "$@" --format sarif && valid sarif out
  holds [ "$(count '"level":"error"' out)" -eq "$errors" ]
  holds [ "$(count '"level":"warning"' out)" -eq "$warnings" ]
  holds [ "$(count '"level":"note"' out)" -eq "$notes" ]
  mv out sarif
  run "$code" verify "$@" --format junit && valid_junit out
  holds [ "$(count '<failure ' out)" -eq "$errors" ]
  holds [ "$(count '<skipped ' out)" -eq "$warnings" ]
  holds [ "$(count '<system-out>' out)" -eq "$notes" ]
  holds [ "$(sed -n 's/.* assertions="\([0-9]*\)".*/\1/p' out | awk '{ n += $1 } END { print n + 0 }')" -eq "$passed" ]
  local tests=$((errors + warnings + notes + $(count ' assertions=' out)))
  says out "<testsuites name=\"geometric_continuity verify\" tests=\"$tests\" failures=\"$errors\" errors=\"0\" skipped=\"$warnings\">"
  mv out junit
}

# chains
formats chains 0 0 0 12 16 --closed "$S"
formats chains 1 24 0 0 4 --closed "$S" --require G2
formats chains 0 0 0 0 28 --closed "$S" --require G0
formats chains 1 12 0 0 16 --closed "$S" --require G1 --summary
formats chains 1 11 0 0 17 --closed "$S" --require G1 --within 0,0.02deg
formats chains 0 0 0 11 17 --closed "$S" --within 0,0.02deg
cubic $'0 0 0\n8 0 0\n16 0 0\n24 0 0' >line.g2
cubic $'24 0 0\n25 1 0\n26 2 0\n27 3 0' >diagonal.g2
cubic $'27 3 1\n28 3 1\n29 3 1\n30 4 1' >away.g2
cubic $'30 4 1\n30 4 1\n30 4 1\n30 4 1' >point.g2
formats chains 0 0 1 0 0 line.g2 diagonal.g2 --within 0,45deg --allow-undecided
formats chains 1 1 0 0 0 line.g2 diagonal.g2 --within 0,45deg && says sarif '"ruleId":"undecided"'
formats chains 1 1 0 0 0 line.g2 diagonal.g2 --within 0,45deg --require G1 && says sarif '"ruleId":"undecided"'
formats chains 0 0 0 3 0 line.g2 diagonal.g2 away.g2 point.g2
says sarif '"ruleId":"corner"' '"ruleId":"gap"' '"ruleId":"tangent"' '"uri":"line.g2","uriBaseId":"%SRCROOT%"},"region":{"startLine":8}' '"uri":"diagonal.g2"' \
  '"fullyQualifiedName":"join 1 -> 2","kind":"join"' '"text":"join 1 -> 2: the ends are 1 apart at (27, 3, 0); gap 1, tangent angle' \
  '"angle_degrees":[44.99999999' '"summary":{"joins":3,'
says junit '<testsuite name="point.g2" tests="0"' '<testcase classname="line.g2" name="join 0 -&gt; 1">' \
  '<system-out>line.g2:8: join 0 -&gt; 1: corner of 45 degrees at (24, 0, 0); gap 0, tangent angle [44.9999, 45.0001] degrees'
formats chains 1 3 0 0 0 line.g2 diagonal.g2 away.g2 point.g2 --require C1
says junit '<failure type="gap" message="not C1, the ends are 1 apart at (27, 3, 0); gap 1,'
printf '\n\n' | cat - line.g2 diagonal.g2 >both.g2 && formats chains 0 0 0 1 0 both.g2 && says sarif '"startLine":10}'
cubic $'24 0 0\n25 0 0\n26 0 0\n27 0 0' >slower.g2 # smooth, but not in the parameter
formats chains 1 1 0 0 0 line.g2 slower.g2 --require C1 && says sarif '"ruleId":"derivative"'
formats chains 1 2 0 0 0 "$L" "$R" "$L" --require G0
printf '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n-1 1\n0 -1\n1 1\n' >parabola.g2 # which has the curvature 2
formats chains 1 1 0 0 0 parabola.g2 --max-curvature 1.75 && says sarif '"ruleId":"bend"' '"startLine":7}' \
  '"text":"curve 0: not bent by at most the curvature 1.75: curvature 2, radius 0.5 at the parameter 0.5"' && says junit '<failure type="bend"'
formats chains 0 0 0 0 1 parabola.g2 --min-radius 1/2

# drawings
printf '<svg xmlns="http://www.w3.org/2000/svg"><path id="p" d="M-1 1 Q 0 -1 1 1 A 1 1 0 0 1 2 2 A 4 1 30 0 1 3 3"/></svg>\n' >bent.svg
formats drawings 1 2 0 0 3 bent.svg --max-curvature 1.75 && says sarif '"ruleId":"bend"' '"ruleId":"not-verified"' 'whose curvature is known for rational numbers only'
formats drawings 0 0 1 0 4 bent.svg --max-curvature 2 --allow-uncovered
leaf=$data/leaf_inkscape.svg badge=$data/badge_illustrator.svg
formats drawings 0 0 0 1 27 "$leaf"
formats drawings 1 14 0 0 14 "$leaf" --require C1 && says sarif '"ruleId":"corner"' '"startLine":' \
  '"fullyQualifiedName":"path \"leaf\" (line 50), subpath 1, commands 3 c - 4 c"'
says junit 'name="path &quot;leaf&quot; (line 50), subpath 1, commands 3 c - 4 c">' 'message="not C1, G0, corner of 93.1'
formats drawings 1 1 0 0 27 "$leaf" --require G1
formats drawings 0 0 0 0 31 "$badge"
formats drawings 0 0 0 1 58 "$badge" "$leaf"
svg '<path d="M0 0h1v1"/><use href="#none"/>'
formats drawings 1 2 0 0 0 drawing.svg --require C1 && says sarif '"ruleId":"not-verified"' && says junit '<failure type="not-verified" message="not verified, '
formats drawings 0 0 1 0 1 drawing.svg --allow-uncovered
svg '<path d="M0 0h1v1"/><path id="almost" d="M0 0h10l10 .1"/>'
formats drawings 0 0 0 1 1 drawing.svg
formats drawings 1 1 0 0 1 drawing.svg --require G1 --kink-angle 5 && says sarif '"ruleId":"kink"' 'path \"almost\" (line 2)'

# surfaces
formats surfaces 0 0 8 8 44 --surfaces "$teapot" --allow-uncovered
formats surfaces 1 36 0 0 24 --surfaces "$teapot" --require G2 && says sarif '"ruleId":"tangent"' '"ruleId":"curvature"' '"kind":"edge"'
holds [ "$(count '"startLine":' sarif)" -eq 36 ]
formats surfaces 1 16 0 0 44 --surfaces "$teapot" --require G1
flat "$flat_points" >low.g2
flat $'1 1 2 2\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 1/3' >high.g2
formats surfaces 1 2 0 0 1 --surfaces low.g2 high.g2 --require G2 && says sarif '"uri":"low.g2","uriBaseId":"%SRCROOT%"},"region":{"startLine":2}}' '"uri":"high.g2","uriBaseId":"%SRCROOT%"},"region":{"startLine":2}}' '"patch 0 v1 - patch 1 v0"' '"patch 1 u = 1","kind":"knot line"'
formats surfaces 0 0 0 1 2 --surfaces low.g2 high.g2 --within 0.1,18deg && says junit '<testsuite name="high.g2" tests="1"'
formats surfaces 0 0 0 0 3 --surfaces low.g2 high.g2 --within 0.1,18.5deg
flat $'1 1 2 2\n0 1 1/1024\n1 1 1/1024\n2 1 1/1024\n3 1 1/1024\n4 1 1/1024\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 0' >near.g2
formats surfaces 1 1 0 0 2 --surfaces low.g2 near.g2 --within 0.001,0.01deg --require G1 && says sarif '"kind":"near edges"'

# the rules and their numbers agree
if command -v python3 >/dev/null; then
  run 1 verify --surfaces "$teapot" --require G2 --format sarif
  holds python3 -c "import json; r = json.load(open('out'))['runs'][0]; rules = r['tool']['driver']['rules']; assert len(rules) == 11 and \
    all(rules[x['ruleIndex']]['id'] == x['ruleId'] for x in r['results']) and not r['properties']['met'] and \
    all(x['properties']['order'] in x['message']['text'] for x in r['results'] if x['ruleId'] != 'not-verified')"
fi

# names from outside: quotes, markup, control characters, bytes that are not UTF-8, what a URI or
# XML does not allow
name=$'a b%\x01\xff\xef\xbf\xbe<&"{0}:#?.g2'
cp "$S" "$name" && formats chains 1 12 0 0 16 --closed "$name" --require G1
says sarif '"uri":"a%20b%25%01%FF%EF%BF%BE%3C%26%22%7B0%7D%3A%23%3F.g2"'
says junit '<testsuite name="a b%\x01\xff'$'\xef\xbf\xbd''&lt;&amp;&quot;{0}:#?.g2"'
svg '<path id="&lt;/failure&gt;{0}]]&gt;&#10;&amp;" d="M0 0h1v1"/>'
formats drawings 1 1 0 0 0 drawing.svg --require C1 && says junit '&lt;/failure&gt;{0}]]&gt;' && says sarif '</failure>{{0}}\\]\\]>'
run 1 verify "$PWD/drawing.svg" --require C1 --format sarif && valid sarif out && says out '"uri":"drawing.svg","uriBaseId":"%SRCROOT%"'
mkdir -p sub && cd sub && run 1 verify "$PWD/../drawing.svg" --require C1 --format sarif && says out '"uri":"file:///'
run 1 verify ../drawing.svg --require C1 --format sarif && says out "\"uri\":\"file://$(cd .. && pwd)/drawing.svg\"}" && lacks out SRCROOT
run 1 verify ../sub/../drawing.svg ./../sub/../drawing.svg --require C1 --format sarif && lacks out SRCROOT '..'
cd ..
run 1 verify ./sub/../drawing.svg --require C1 --format sarif && says out '"uri":"drawing.svg","uriBaseId":"%SRCROOT%"'
# a defect keeps its fingerprint when its numbers change; another place has another one
prints() { run 1 verify drawing.svg --require C1 --format sarif && grep -o '"filePlace[^,}]*' out; }
svg '<path d="M0 0h1v1h1"/>' && prints >one && svg '<path d="M0 0h2v3h2"/>' && prints >other
holds cmp -s one other && holds [ "$(sort -u one | wc -l)" -eq 2 ]

# nothing to report, and nothing at all
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >alone.g2
formats chains 0 0 0 0 0 alone.g2 --allow-empty && says junit '<testsuite name="alone.g2" tests="0"'
for format in sarif junit; do
  run 2 verify missing.g2 --format $format && holds [ ! -s out ]
  run 2 verify alone.g2 --format $format && holds [ ! -s out ]
  printf 'x' >bad.g2 && run 2 verify --closed "$S" bad.g2 --format $format && holds [ ! -s out ]
done
run 2 verify "$S" --format xml && says err "--format: 'xml' is none of text, json, sarif, junit"
run 2 verify "$S" --json --format sarif && says err "--json: not with --format sarif"

# more findings than are kept in memory: 6000 kinks
for i in {0..5999}; do printf '100 1 0 0\n2 0\n2 2\n0 0 1 1\n%d %d\n%d %d\n' $i $((i % 2)) $((i + 1)) $(((i + 1) % 2)); done >zigzag.g2
formats chains 1 5999 0 0 0 zigzag.g2 --require G1 && holds [ "$(wc -c <sarif)" -gt 4500000 ]

if command -v python3 >/dev/null && python3 -c "import jsonschema" 2>/dev/null; then
  cat >valid.py <<'PYTHON'
import glob, json, sys
from jsonschema import Draft7Validator
failures = 0
for name in glob.glob("report_*_by_*"):
    with open(sys.argv[1] + "/" + name.split("_by_")[1] + ".json") as schema, open(name, encoding="utf-8") as report:
        for error in list(Draft7Validator(json.load(schema)).iter_errors(json.load(report)))[:3]:
            print(name, list(error.absolute_path), error.message[:500])
            failures += 1
for name in glob.glob(sys.argv[1] + "/*.json"):
    with open(name) as schema:
        Draft7Validator.check_schema(json.load(schema))
sys.exit(failures > 0)
PYTHON
  holds python3 valid.py "$here/schemas"
else
  echo "skipped: JSON is not validated, python3-jsonschema is missing"
fi
