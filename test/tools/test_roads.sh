#!/usr/bin/env bash
# verify, repair and report of road networks in OpenDRIVE. GEOMETRIC_CONTINUITY_ROADS names a folder
# in which carla/, esmini/ and qc/ hold the files .xodr of carla-simulator/opendrive-test-files,
# esmini/esmini and asam-ev/qc-opendrive, if these are to be verified as well.
. "$(dirname "$0")/functions.sh"

# network ROADS: a file with these roads; each of them on a line of its own
network() { printf '<OpenDRIVE><header revMajor="1" revMinor="7"/>\n%s\n</OpenDRIVE>\n' "$1" >roads.xodr; }
# road ID LENGTH PLAN [LINK] [PROFILES] [LANES]
road() {
  printf '<road id="%s" length="%s" junction="-1"><link>%s</link><planView>%s</planView>%s<lanes>%s</lanes></road>' \
    "$1" "$2" "${4:-}" "$3" "${5:-}" "${6:-<laneSection s=\"0\"/>}"
}
piece() { printf '<geometry s="%s" x="%s" y="%s" hdg="%s" length="%s">%s</geometry>' "$@"; }
line='<line/>'
# valid ARGUMENTS...: the report in JSON is as the schema says
valid() {
  "$program" verify --json "$@" >valid.json 2>err
  valid_json roads valid.json
}
# decides CODE PIECES TEXT...: verify of one road of these pieces
decides() {
  local code=$1 pieces=$2
  shift 2
  network "$(road 1 20 "$pieces")" && run "$code" verify roads.xodr && says out "$@"
}

# tolerances are inclusive, and numbers are the decimals
decides 0 "$(piece 0 0 0 0 10 $line)$(piece 10 10.001 0 0 10 $line)" "plan G2, gap 0.001 m, kink none, curvature equal" "every join is G1 within the tolerances, proved"
decides 1 "$(piece 0 0 0 0 10 $line)$(piece 10 10.001000000000000001 0 0 10 $line)" "plan gap" "not G1" "1 gap" "1 of them not G1"
decides 0 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 0.001 10 $line)" "plan G2, gap 0 m, kink 0.001 rad"
decides 1 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 0.0010000000000000001 10 $line)" "plan G0"
decides 0 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 12.566370614359172 10 $line)" "plan G2" "kink at most " "e-15 rad"
decides 1 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 -3.14159265358979 10 $line)" "plan G0" "kink 3.142 rad"
decides 0 "$(piece 0 0 0 0 10 $line)$(piece ' 10 ' +1.0e1 -0.00 0 10 '<arc curvature="1e-2"/>')" "plan G1, gap 0 m, kink none, curvature jump 0.01/m"
run 1 verify roads.xodr --require G2 && says out "not G2" && run 0 verify roads.xodr --require G2 --curvature 0.01
# a clothoid, which turns by 30 rad on either side; a stop; a range that is not said; a graph
decides 0 "$(piece 0 0 0 0 120 '<spiral curvStart="-0.5" curvEnd="0.5"/>')$(piece 120 -2.25538713065 -31.3635920836 0 3 '<arc curvature="0.50"/>')" "plan G2, gap 3.417e-11 m, kink none, curvature equal"
decides 0 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 0 10 '<paramPoly3 aU="0" bU="0" cU="10" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/>')" "plan undecided, gap 0 m, kink none, curvature not defined"
run 1 verify roads.xodr --require G2 && says out "undecided: 1 join, a curvature is not defined"
decides 1 "$(piece 0 0 0 0 10 '<paramPoly3 aU="0" bU="1" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0"/>')$(piece 10 10 0 0 10 $line)" \
  "pRange is missing" "arc length differs by 9 m"  "m if pRange were arcLength - a wrong length" "if pRange were arcLength: G2"
decides 0 "$(piece 0 0 0 0 5 '<poly3 a="0" b="0.75" c="0" d="0"/>')$(piece 5 4 3 0.643501108793284 10 $line)" "plan G2, gap 0 m, kink at most " "e-15 rad, curvature equal"

# --max-curvature: closed forms are exact; a graph ends where its arc length does
bends() { # CODE BOUND LENGTH PIECE TEXT...
  local code=$1 bound=$2 text
  network "$(road 1 "$3" "$(piece 0 0 0 0 "$3" "$4")")"
  shift 4
  run "$code" verify roads.xodr --allow-empty --max-curvature "$bound" && says out "$@" && valid roads.xodr --allow-empty --max-curvature "$bound"
}
bends 0 0.1 10 '<spiral curvStart="-0.1" curvEnd="0.05"/>' "s = 0 (line 2): bend spiral, curvature 0.1/m at its start" "and every piece of a reference line is G1 within the tolerances, or bent by at most the curvature 0.1, proved"
bends 1 0.0999999999999999999999 10 '<spiral curvStart="-0.1" curvEnd="0.05"/>' "- not bent by at most the curvature 0.0999999999999999999999" "1 bend (1 bent too much)"
bends 0 0 10 "$line" "bend line, curvature 0/m"
# v = u^2 / 2 and v = u^2 - u, of which the vertex is reached, or not
bends 0 1 5 '<poly3 a="0" b="0" c="0.5" d="0"/>' "bend poly3, bent by at most the curvature 1"
bends 1 1.999999 0.8 '<poly3 a="0" b="-1" c="1" d="0"/>' "bend poly3, curvature 2/m at u = 0.5"
bends 0 1.7 0.4 '<poly3 a="0" b="-1" c="1" d="0"/>' "bend poly3, bent by at most the curvature 1.7"
bends 1 1.68 0.4 '<poly3 a="0" b="-1" c="1" d="0"/>' "bend poly3, curvature 1.6" "not bent by at most the curvature 1.68"
bends 1 1 4 '<paramPoly3 aU="0" bU="0" cU="1" dU="0" aV="0" bV="0" cV="0" dV="1" pRange="normalized"/>' "curvature without a bound, as in a cusp, at p = 0"
run 1 verify roads.xodr --max-curvature 1 --format sarif && says out '"ruleId":"bend"'

# profiles: steps and kinks of the elevation; a linear change of the superelevation is meant
profile() { printf '<%s s="%s" a="%s" b="%s" c="%s" d="%s"/>' "$@"; }
network "$(road 1 40 "$(piece 0 0 0 0 40 $line)" '' "<elevationProfile>$(profile elevation 0 1 0.02 0 0)$(profile elevation 10 1.2 0.02 0.001 0)$(profile elevation 20.5 1.52025 0.041 0 0)$(profile elevation 30 1.9097 0.043 0 0)$(profile elevation 50 0 0 0 0)</elevationProfile><lateralProfile>$(profile superelevation 5 0.001 0.01 0 0)</lateralProfile>")"
run 1 verify roads.xodr && says out "s = 10 (line 2): elevation no step, no kink" "s = 30 (line 2): elevation step 5e-05 m, slope jump 0.002 - a kink" \
  "s = 5 (line 2): superelevation step 0.001 rad" "starts behind the end" "before it the value is 0" "3 elevation (0 with a step, 1 with a kink)" "2 notes"
sed 's/a="1.9097"/a="1.92"/; s/revMinor="7"/revMinor="seven"/' roads.xodr >step.xodr && run 1 verify step.xodr --json && says out '"elevation":{"joins":3,"not_met":1,"steps":1,"kinks":1}'
run 1 verify step.xodr && says out "revMinor (line 1): note, header: 'seven' is not a number; no decision depends on the revision" "(1 with a step, 1 with a kink)" && valid step.xodr

# lanes: renumbered where the offset jumps, split, with a sidewalk that is too wide, and with one
# that only the second names
lane() { printf '<lane id="%s" type="driving" level="%s"><link>%s</link>%s</lane>' "$1" "${4:-false}" "$2" "$3"; }
width() { printf '<width sOffset="%s" a="%s" b="0" c="0" d="0"/>' "$1" "$2"; }
to() { printf '<successor id="%s"/>' "$@"; }
from() { printf '<predecessor id="%s"/>' "$@"; }
section() { printf '<laneSection s="%s"><left>%s</left><center><lane id="0"/></center><right>%s</right></laneSection>' "$@"; }
lanes() { network "$(road 1 40 "$(piece 0 0 0 0 40 $line)" '' '' "$1")"; }
lanes "$(profile laneOffset 0 0 0 0 0)$(profile laneOffset 20 3.5 0 0 0)$(section 0 "$(lane 1 "$(to -1)" "$(width 0 3.5)")" "$(lane -1 "$(to -2)" "$(width 0 3.25)")")$(section 20 '' "$(lane -1 "$(from 1)" "$(width 0 3.5)")$(lane -2 "$(from -1)" "$(width 0 3.25)")")"
run 0 verify roads.xodr && says out "laneOffset step 3.5 m, no kink, where a lane section starts" "lane 1 to -1 (line 2): section lane borders equal" "lane -1 to -2 (line 2): section lane borders equal"
lanes "$(section 0 '' "$(lane -1 "$(to -1 -2)" "$(width 0 7)")")$(section 20 '' "$(lane -1 "$(from -1)" "$(width 0 3.5)$(width 5 3.6)")$(lane -2 "$(from -1)" "$(width 0 3.501)")$(lane -4 "$(from -1)" "$(width 0 1)")")"
run 1 verify roads.xodr && says out "lane -1 to -1 (line 2): section lane borders equal" "lane -1 to -2 (line 2): section lane borders apart by 0.001 m" \
  "s = 25, lane -1 (line 2): width step 0.1 m" "lane numbering: the lane inside of it is missing" "lane -1 to -4 (line 2): section lane back not decided"
lanes "$(section 0 '' "$(lane -1 "$(to -1)" "$(width 0 3)")$(lane -2 "$(to -2)" "$(width 0 2)")")$(section 20 '' "$(lane -1 "$(from -1)" "$(width 0 3)")$(lane -2 "$(from -2)" "$(width 0 20)")")"
run 1 verify roads.xodr && says out "lane -2 to -2 (line 2): section lane borders apart by 18 m - lanes apart" "largest gap of lanes: 18 m"
lanes "$(section 0 '' "$(lane -1 "$(to -7)" "$(width 0 3)")")$(section 20 '' "$(lane -1 '' "$(width 0 3)")")"
run 2 verify roads.xodr && says out "fault, lane link: it leads to a lane that is not there" "not covered: 1 lane link"

# links: end to end, where headings are turned by pi, and curvatures and lanes have the other
# sign; banked roads; reference lines that do not meet where lanes do
next() { printf '<%s elementType="road" elementId="%s" contactPoint="%s"/>' "$@"; }
both() { section 0 "$(lane 1 "$1" "$(width 0 3.5)")" "$(lane -1 "$2" "$(width 0 3.5)")"; }
network "$(road 1 10 "$(piece 0 0 0 0 10 '<arc curvature="0.02"/>')" "$(next successor 2 end)" '' "$(both "$(to -1)" "$(to 1)")")$(road 2 10 "$(piece 0 19.4709171154 3.94695029986 3.54159265359 10 '<arc curvature="-0.02"/>')" "$(next successor 1 end)" '' "$(both "$(to -1)" "$(to 1)")")"
run 0 verify roads.xodr && says out "road 1, end - road 2, end (line 2): link reference lines G2" "curvature equal" "road 1, end, lane 1 - road 2, end, lane -1 (line 2): road lane borders apart by at most 3." "1 link;" "2 road lane"
network "$(road 1 10 "$(piece 0 0 0 0 10 $line)" "$(next successor 2 start)" "<elevationProfile>$(profile elevation 0 0 0.1 0 0)</elevationProfile><lateralProfile>$(profile superelevation 0 0.2 0 0 0)</lateralProfile>" "$(both "$(to 1)" "$(to -1)")")$(road 2 10 "$(piece 0 10 0 0 10 $line)" "$(next predecessor 1 end)" '' "$(both "$(from 1)" "$(from -1)")")"
run 1 verify roads.xodr && says out "borders apart by 0.06977 m, in height by 1.695 m" "step 1 m" && run 1 verify roads.xodr --json && says out '"grade_jump":0.1' '"within_z":false' '"met":false'
sed 's/level="false"/level="true"/g' roads.xodr >level.xodr && run 1 verify level.xodr && says out "borders apart by 0 m, in height by 1 m"
network "$(road 1 10 "$(piece 0 0 0 0 10 $line)" '<successor elementType="junction" elementId="9"/>' '' "$(both '' '')")$(road 2 10 "$(piece 0 10 -3.5 0 10 $line)" "$(next predecessor 1 end)" '' "$(section 0 "$(lane 1 '' "$(width 0 3.5)")" '')")<junction id=\"9\"><connection id=\"0\" incomingRoad=\"1\" connectingRoad=\"2\" contactPoint=\"start\"><laneLink from=\"-1\" to=\"1\"/></connection><connection id=\"1\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"start\"/></junction>"
run 1 verify roads.xodr && says out "link reference lines gap, gap 3.5 m" "junction lane borders apart by 0 m" "its connecting road is not in the file" && run 0 verify roads.xodr --allow-uncovered
network "$(road 1 10 "$(piece 0 0 0 0 10 $line)" "$(next successor 2 start)")$(road 2 10 "$(piece 0 15 0 0 10 $line)")"
run 2 verify roads.xodr && says out "no lanes are linked, and the reference lines do not meet" "the other road does not name this one there"
valid roads.xodr
# a virtual junction: a road that branches off at s = 4 of an arc, in its direction
network "$(road 1 10 "$(piece 0 0 0 0 10 '<arc curvature="0.01"/>')" '' '' "$(both '' '')")$(road 2 10 "$(piece 0 3.99893341866 0.07998933390 0.04 10 $line)" '<predecessor elementType="road" elementId="1" elementS="4" elementDir="+"/>' '' "$(both "$(from 1)" "$(from -1)")")"
run 0 verify roads.xodr && says out "road 2, start - road 1, s = 4" "reference lines G1" "road 2, start, lane 1 - road 1, s = 4, lane 1"

# borders of lanes as curves: a lane that widens linearly has a kink, one that lies beyond the
# centre of an arc folds, and the borders of an arc have curvatures of their own
widening="$(section 0 "$(lane 1 '' "$(width 0 3)<width sOffset=\"15\" a=\"3\" b=\"0.25\" c=\"0\" d=\"0\"/>")" "$(lane -1 '' "$(width 0 4)")")"
network "$(road 1 20 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 0 10 '<arc curvature="0.1"/>')" '' '' "$widening")"
run 0 verify roads.xodr && lacks out "lane border" && run 1 verify roads.xodr --lane-borders && says out "s = 10, lane 1, left (line 2): lane border G1, gap 0 m, kink none, curvature jump 0.1429/m" \
  "s = 10, lane -1, right (line 2): lane border G1" "0.07143/m" "s = 15, lane 1, left (line 2): lane border G0" "kink 0.343 rad" "4 lane border (1 not smooth enough)" "1 of them not G1"
run 1 verify roads.xodr --lane-borders --require G2 && says out "5 of them not G2" && run 1 verify roads.xodr --lane-borders --json && says out '"kind":"lane border","road":"1","s":15,"lane":1,"to":1,"side":"left"'
sed 's/a="3"/a="11"/g' roads.xodr >fold.xodr && run 0 verify fold.xodr && run 1 verify fold.xodr --lane-borders && says out "s = 10, lane 1, left border (line 2): fault, lane border: the lane folds"
valid --lane-borders fold.xodr && valid --lane-borders roads.xodr
run 2 verify "$S" --lane-borders && says err "only for road networks"

# what the digits explain: numbers of 9 digits, and the same gap among numbers of 12
digits() { decides 1 "$(piece 0 691234.568 5334567.89 -1.234 80 '<spiral curvStart="0" curvEnd="-0.008"/>')$(piece 80 691252.741"$1" 5334490.35 -1.554 40 '<arc curvature="-0.008"/>')" "plan gap"; }
digits '' && says out "gap 0.004672 m, kink none, curvature equal; 9 digits explain it - not G1" && digits 001 && lacks out "explain"
run 1 verify roads.xodr --json && says out '"explained_by_digits":{"gap":false,"kink":true}'
# 17 digits, of which floating-point numbers do not tell that they are enough; one digit is wrong
for x in 30.086345998524268:true 30.086345998524298:false; do
  decides 0 "$(piece 0 0 0 1.213270991791975 85.97151986439353 $line)$(piece 85.97151986439353 ${x%:*} 80.535172516428459 1.213270991791975 10 $line)"
  run 0 verify roads.xodr --json && says out "\"explained_by_digits\":{\"gap\":${x#*:},\"kink\":true}"
done

# what cannot be read, with its line
bad() { run 2 verify roads.xodr && says err "roads.xodr:$1: " "$2"; }
for x in nan inf 1,5; do network "$(road 1 20 "$(piece 0 "$x" 0 0 10 $line)")" && bad 2 "x = '$x': not a number"; done
network "$(road 1 20 "$(piece 0 1/3 0 0 10 $line)")" && bad 2 "x = '1/3': not a decimal number"
network "$(road 1 20 "$(piece 0 '' 0 0 10 $line)")" && bad 2 "x = '': empty number"
network "$(road 1 20 "$(piece 0 1e5000 0 0 10 $line)")" && bad 2 "x = '1e5000': decimal exponent beyond 4096"
network "$(road 1 20 "$(piece 0 0 0 0 10 "$line$line")")" && bad 2 "a geometry has 2 shapes"
network "$(road 1 20 "$(piece 0 0 0 0 -10 $line)")" && bad 2 "a length is negative"
network '<road id="1"/>' && bad 2 "road has no attribute length"
printf '<OpenDRIVE>\n<road id="1" length' >roads.xodr && bad 2 "unclosed token"
printf '<html/>' >roads.xodr && bad 1 "not OpenDRIVE"
printf '<!DOCTYPE x [<!ENTITY a SYSTEM "b">]><OpenDRIVE>&a;</OpenDRIVE>' >roads.xodr && bad 1 "stands in another file"
laughs OpenDRIVE >roads.xodr && bad 1 "limit on input amplification"
{ printf '<OpenDRIVE>'; printf '<a>%.0s' {1..300}; } >roads.xodr && bad 1 "nested deeper than 256"
# numbers beyond those of floating-point numbers
network "$(road 1 40 "$(piece 0 0 0 0 40 $line)" '' "<elevationProfile>$(profile elevation 0 0 0 0 0)$(profile elevation 10 0 1e400 0 0)</elevationProfile>")"
run 1 verify roads.xodr && says out "no step, slope jump more than 1.798e+308 - a kink" && valid roads.xodr && says valid.json '"slope_jump":null'
decides 2 "$(piece 0 0 0 0 10 $line)$(piece 10 1e400 0 1e400 10 $line)" "its numbers are too large"
decides 2 "$(piece 0 0 0 0 10 '<arc curvature="1e9"/>')$(piece 10 10 0 0 10 $line)" "turns by more than 20000 radians" "not covered: 1 plan"
network "$(road 1 20 "$(piece 0 0 0 0 10 $line)$(piece 10 10 0 0 10 $line)")" && cp roads.xodr plain.txt
run 2 verify roads.xodr --surfaces && says err "--surfaces: not for road networks" && run 2 verify roads.xodr --require C1 && says err "G0, G1 and G2"
run 2 verify roads.xodr --gap -1 && says err "--gap: -1 is negative" && run 2 verify "$S" --gap 1 && says err "only for road networks"
run 2 verify roads.xodr "$S" && says err "cannot be verified together" && run 2 blend roads.xodr && says err "a road network: verify, report and repair read it"
run 0 verify plain.txt && says out "1 plan join"

# formats, with the line of the element; a baseline
printf '<OpenDRIVE>\n<road id="7" length="20"><planView>\n%s\n%s\n</planView></road></OpenDRIVE>\n' "$(piece 0 0 0 0 10 $line)" "$(piece 10 10.5 0 0.2 10 $line)" >bad.xodr
run 1 verify bad.xodr --format sarif && says out '"ruleId":"gap"' '"startLine":4' 'road 7, s = 10: plan gap' && cp out known.sarif
run 1 verify bad.xodr --format junit && says out '<failure type="gap"' && run 0 verify bad.xodr --baseline known.sarif && says out "1 of them known"
run 1 verify bad.xodr --json && says out '"kind":"plan","road":"7","s":10,"s_error":0,"gap":[0.5,0.5],"kink":[' '"g0":false,"g1":false,"g2":true' '"order":"gap"' '"required":"G1","met":false'

valid bad.xodr level.xodr fold.xodr

# repair: the end is free, the start is, neither is; all other bytes stay, and again nothing changes
arc='<arc curvature="0.01"/>'
pieces="$(piece 0 0 0 0.3 20 $line)$(piece 20 19.11 5.908 0.302 30 "$arc<userData code=\"a\"/>")"
network "$(road 1 50 "$pieces")" && run 0 repair roads.xodr -o free.xodr && says out "moved to the end before" "1 start moved" "not met before: 1 plan; after: none"
run 0 verify free.xodr --gap 1e-12 --kink 1e-12 && holds [ "$(sed 's/x="[^"]*" y="[^"]*" hdg="[^"]*"//g' free.xodr)" = "$(sed 's/x="[^"]*" y="[^"]*" hdg="[^"]*"//g' roads.xodr)" ]
network "$(road 1 50 "$pieces" "$(next successor 2 start)")" && run 0 repair roads.xodr -o start.xodr && says out "the piece before moved there" && says start.xodr 'x="19.11" y="5.908" hdg="0.302"'
network "$(road 1 50 "$pieces" "$(next predecessor 3 end)$(next successor 2 start)")" && run 0 repair roads.xodr -o fixed.xodr && says out "the piece behind becomes three clothoids, G2 proved"
holds [ "$(grep -o '<spiral' fixed.xodr | wc -l)" -eq 3 ] && says fixed.xodr '<userData code="a"/>' && run 1 verify fixed.xodr --gap 1e-11 --kink 1e-11 && says out "3 plan joins: 2 G2, 1 G1, 0 G0, 0 gaps"
run 0 repair fixed.xodr -o again.xodr --json && says out '"repaired":[]' && holds cmp fixed.xodr again.xodr
run 1 repair roads.xodr -o far.xodr --max-move 0.001 && says out "farther apart than may be moved" && holds cmp roads.xodr far.xodr
run 2 repair roads.xodr -o far.xodr --to G2 && says err "G1 only"

# the page
run 0 report bad.xodr -o page.html && says page.html '"roads":{"origin":[0,0]' '"grade":"gap","place":"road 7, s = 10"' '"road":0,"s":10,"xy":['

# roads that others have published
folder=${GEOMETRIC_CONTINUITY_ROADS:-}
if [ -n "$folder" ]; then
  run 1 verify --summary $(find -L "$folder/carla" -name '*.xodr') && says out "geometries: 4545 line, 1915 arc, 0 spiral" "5113 plan joins" "19 gaps" \
    "5705 elevation (4 with a step, 2 with a kink)" "3589 section lane (7 apart), 3379 road lane (53 apart)" "2038 links" "largest gap of lanes: 18 m"
  run 1 verify --summary $(find -L "$folder/esmini" -name '*.xodr') && says out "479 line, 189 arc, 377 spiral, 0 poly3, 115 paramPoly3" "661 plan joins" " 0 gaps" "115 length (2 wrong)" "542 links"
  counts=""
  for name in many_invalid simple_valid junction_invalid_conn_smoothness junction_valid_conn_smoothness multiple_successor_invalid multiple_successor_valid lane_gap_example_issue_119; do
    "$program" verify --gap 0.01 --allow-empty "$(find -L "$folder/qc" -name $name.xodr)" >out
    counts="$counts $(grep -cE ' (plan|section lane|road lane|junction lane) .* - (not G1|lanes apart)$' out)"
  done
  holds [ "$counts" = " 24 0 2 0 1 0 0" ]
fi
