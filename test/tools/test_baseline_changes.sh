#!/usr/bin/env bash
# verify --baseline when files change: what is unchanged, moved, or better is known; what is worse,
# or more, is new. Drawings, fonts, variable fonts, chains, surfaces and CAD models, also those of
# the system where there are some.
. "$(dirname "$0")/functions.sh"

# base ARGUMENTS...: a report on these is the baseline, with so many findings
base() {
  checks=$((checks + 1))
  "$program" verify "$@" --format sarif >base.sarif 2>err
  findings=$(grep -c '"ruleId"' base.sarif)
}
# known ARGUMENTS...: all that is found is known
known() {
  run 0 verify "$@" --baseline base.sarif --json && says out '{"findings":[],'
}
# new N TEXT ARGUMENTS...: so many findings are new, and are these
new() {
  local n=$1 text=$2
  shift 2
  run 1 verify "$@" --baseline base.sarif --json && says out "$text"
  holds [ "$(grep -c '{"rule":' out)" -eq "$n" ]
}

# --- gaps: what turns behind one is new, and what cannot be read for another reason
gap() { { curve $'2 0\n2 2\n0 0 1 1\n0 0\n10 0'; curve $'2 0\n2 2\n0 0 1 1\n10.0001 0\n20 '"$1"; } >gap.g2; }
gap 0 && base gap.g2 --require G1 && known gap.g2 --require G1
gap 5 && new 1 '"rule":"gap"' gap.g2 --require G1
printf '<svg xmlns="http://www.w3.org/2000/svg"><path id="p" d="%s"/></svg>' "M0 0L1 1L2 2f" >x.svg && base x.svg && known x.svg --allow-uncovered
printf '<svg xmlns="http://www.w3.org/2000/svg"><path id="p" d="%s"/></svg>' "M0 0fL1 1L2 2" >x.svg && new 1 '"rule":"not-verified"' x.svg --allow-empty

# --- drawings: with ids and without, in groups, some that cannot be read
drawing() { printf '<svg xmlns="http://www.w3.org/2000/svg">\n%s\n</svg>\n' "$*" >x.svg; }
small='M0 0L100 0L200 1' large='M0 0L100 0L200 8' # 0.57 and 4.57 degrees
named="<path id=\"a\" d=\"$small\"/>" unnamed="<path d=\"$small\"/>" use='<use href="#none"/>'
others="<g><path d=\"M0 0L100 0L200 3M5 5L105 5L205 9\"/><path d=\"M0 0C1 0 2 1 3 1C4 1 5 1.1 6 2\"/></g>$use<path d=\"M9 9A5 5 0 0 1 14 14L14.2 19\"/>"
for elements in "$named$others" "$unnamed$others" "$others$unnamed"; do
  for require in G1 G2; do
    drawing "$elements" && base x.svg --require $require && holds [ "$findings" -ge 5 ]
    known x.svg --require $require
    known ./x.svg --require $require && known "$PWD/../$(basename "$PWD")/x.svg" --require $require
    drawing "<!-- a comment"$'\n\n'"of lines -->$elements" && known x.svg --require $require
    drawing "<path d=\"M0 0h1v1z\"/><g/>$elements" && known x.svg --require $require
    drawing "<path d=\"M0 0h1v1z\"/><g transform=\"translate(3.25,-7)\">$elements</g>" && known x.svg --require $require
    drawing "$elements<path d=\"M0 0h1v1z\"/>" && known x.svg --require $require
    drawing "${elements//0L100/0 L 100}" && known x.svg --require $require
    drawing "${elements/$small/M20 30L120 30L220 31}" && known x.svg --require $require # moved in its data
    drawing "${elements/$small/M0 0L100 0L200 .5}" && known x.svg --require $require     # better
    drawing "${elements/$small/M0 0h1}" && known x.svg --require $require
    drawing "${elements/$small/$large}" && new 1 '[4.5739' x.svg --require $require
    drawing "<path d=\"M0 0h1v1z\"/>${elements/$small/$large}" && new 1 '[4.5739' x.svg --require $require
    drawing "<path d=\"M0 0L100 0L200 4\"/>$elements" && new 1 '[2.2906' x.svg --require $require
    drawing "$elements<path d=\"M0 0L100 0L200 1\"/>" && new 1 '[0.5729' x.svg --require $require # one more of a kind
    drawing "$elements<use href=\"#another\" id=\"new\"/>" && new 1 '"rule":"not-verified"' x.svg --require $require
  done
done
# a jump of the curvature that grows, and one that becomes a kink
jump() { drawing "<path d=\"M0 0C1 0 2 1 3 1C4 1 5 $1 6 2\"/>"; }
jump 1.1 && base x.svg --require G2 && holds [ "$findings" -eq 1 ] && says base.sarif '"measure":{"quantity":"curvature_jump","bounds":['
jump 1.05 && known x.svg --require G2
jump 1.2 && new 1 '"rule":"curvature"' x.svg --require G2
drawing '<path d="M0 0C1 0 2 1 3 1C4 1.01 5 1.1 6 2"/>' && new 1 '"rule":"kink"' x.svg --require G2
# repeated elements are those of their use elements
uses() { drawing "<defs><path id=\"p\" d=\"$small\"/></defs>${1-}<use href=\"#p\" id=\"u\"/><use href=\"#p\" y=\"5\"/>"; }
uses && base x.svg --require G1 && holds [ "$findings" -eq 2 ] && known x.svg --require G1
uses $'\n\n<path d="M0 0h1"/>' && known x.svg --require G1
uses '<use href="#p" y="9"/>' && new 1 '"rule":"kink"' x.svg --require G1

# --- fonts: as many findings as there are kinks, more than --worst shows, equal ones as well
glyphs() { # SLOPE DX BEFORE: the glyphs, the last one with this kink, moved, behind others
  printf 'glyph .notdef\n'
  printf '%s' "${3-}"
  for i in $(seq 3 14) 14 14; do
    echo "glyph g$i$((++glyph))"
    echo "contour $((0 + $2)),0 $((20 + $2)),-90* $((50 + $2)),-100* $((100 + $2)),0 $((150 + $2)),$((100 + i))* $((180 + $2)),90* $((200 + $2)),0 $((200 + $2)),200 $((0 + $2)),200"
  done
  echo "glyph last"
  echo "contour $((0 + $2)),0 $((20 + $2)),-90* $((50 + $2)),-100* $((100 + $2)),0 $((150 + $2)),$1* $((180 + $2)),90* $((200 + $2)),0 $((200 + $2)),200 $((0 + $2)),200"
}
kinks() { local glyph=0 && glyphs "$@"; }
for names in yes no; do
  for outlines in glyf cff; do
    options="-v names=$names -v outlines=$outlines"
    kinks 95 0 | font x.ttf $options && base x.ttf --require G1
    holds [ "$findings" -eq "$(grep -o '"kinks":[0-9]*' base.sarif | head -n 1 | grep -o '[0-9]*')" ] && holds [ "$findings" -gt 10 ]
    lacks base.sarif 'more like this'
    known x.ttf --require G1 && known "$PWD/x.ttf" --require G1
    run 0 verify x.ttf --require G1 --baseline base.sarif && says out "$findings of them known" 'nothing new is not G1'
    kinks 95 30 | font x.ttf $options && known x.ttf --require G1
    kinks 95 0 $'glyph first 65\ncontour 0,0 100,0 100,100\n' | font x.ttf $options && known x.ttf --require G1
    kinks 95 30 $'glyph first 65\ncontour 0,0 100,0 100,100\n' | font x.ttf $options && known x.ttf --require G1
    kinks 96 0 | font x.ttf $options && known x.ttf --require G1
    kinks 94 0 | font x.ttf $options && new 1 'contour 0, node ' x.ttf --require G1
    kinks 94 0 $'glyph first 65\ncontour 0,0 100,0 100,100\n' | font x.ttf $options && new 1 'contour 0, node ' x.ttf --require G1
  done
done
kinks 95 0 | font x.ttf && base x.ttf --require G2 && known x.ttf --require G2 && says base.sarif '"quantity":"curvature_jump"'
run 2 verify x.ttf --require G2 --baseline base.sarif --worst 5 && says err '--baseline: not with --worst'
run 1 verify x.ttf --require G1 --format sarif --worst 3 && says out 'more joins not G1; --worst N tells N of them' # where that is asked for
run 1 verify x.ttf --require G1 --format junit && holds [ "$(grep -c '<failure' out)" -eq 15 ]
mkdir -p fonts && cp x.ttf fonts/one.ttf && cp x.ttf fonts/two.ttf && base fonts --require G1 && known fonts --require G1
kinks 93 0 | font x.ttf && cp x.ttf fonts/two.ttf && new 1 'fonts/two.ttf' fonts --require G1

# --- chains
chain() { # SLOPE [FIRST]: a line that turns by a kink, another kink, and a gap behind the first curve
  { printf '%s' "${2-}" && cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' && cubic $'3 0 0\n13 '"$1"$' 0\n23 0 0\n33 1 0' &&
    cubic $'33 1 0\n43 2.5 0\n53 3 0\n63 3 0' && cubic $'63 3 0.25\n64 3 0.25\n65 3 0.25\n66 3 0.25'; } >x.g2
}
first="$(cubic $'-3 0 0\n-2 0 0\n-1 0 0\n0 0 0')"$'\n'
chain 0.5 && base x.g2 --require G1 && holds [ "$findings" -eq 3 ] && known x.g2 --require G1 && known ./x.g2 --require G1
says base.sarif '"quantity":"gap","bounds":[0.25,0.25]' '"quantity":"angle_degrees"'
chain 0.5 "$first" && known x.g2 --require G1
chain 0.5 $'\n\n' && known x.g2 --require G1
chain 0.4 && known x.g2 --require G1
chain 0.6 && new 1 '"rule":"kink"' x.g2 --require G1
chain 0.6 "$first" && new 1 '"place":"join 1 -> 2"' x.g2 --require G1
cubic $'-3 0 0\n-2 0 0\n-1 0 0\n0 0 0' >before.g2 && chain 0.5 && known before.g2 x.g2 --require G1
chain 0.5 && sed -i 's/0.25$/0.26/' x.g2 && new 1 '"rule":"gap"' x.g2 --require G1
chain 0.5 && base x.g2 --require G2 && known x.g2 --require G2
retracted() { { printf '%s' "${2-}" && cubic $'0 0 0\n1 0 0\n3 0 0\n3 0 0' && cubic $'3 0 0\n3 0 0\n4 '"$1"$' 0\n6 1 0'; } >x.g2; }
retracted 0.05 && base x.g2 --require G1 && holds [ "$findings" -eq 1 ] && known x.g2 --require G1
retracted 0.04 && known x.g2 --require G1
retracted 0.05 "$first" && known x.g2 --require G1
retracted 0.06 && new 1 '"rule":"kink"' x.g2 --require G1

# --- surfaces
surfaces() { # HEIGHT DX [FIRST]
  { printf '%s' "${3-}" && flat $'0 0 1 1\n'"$(points 0 "$2")" && flat $'1 1 2 2\n'"$(points 1 "$2" "$1")"; } >x.g2
}
points() { for j in 0 1; do for i in 0 1 2 3 4; do echo "$((i + $2)).5 $((j + $1)) $([ "$1$j" = 11 ] && echo "${3-0}" || echo 0)"; done; done; }
patch="$(flat $'5 5 6 6\n50 0 0\n51 0 0\n52 0 0\n53 0 0\n54 0 0\n50 1 0\n51 1 0\n52 1 0\n53 1 0\n54 1 0')"$'\n'
surfaces 0.05 0 && base --surfaces x.g2 --require G1 && holds [ "$findings" -eq 1 ] && says base.sarif '"quantity":"angle_degrees","bounds":[2.86'
known --surfaces x.g2 --require G1
surfaces 0.05 7 && known --surfaces x.g2 --require G1
surfaces 0.05 0 "$patch" && known --surfaces x.g2 --require G1
surfaces 0.05 7 "$patch" && known --surfaces x.g2 --require G1
surfaces 0.04 0 && known --surfaces x.g2 --require G1
surfaces 0.06 0 && new 1 '"rule":"kink"' --surfaces x.g2 --require G1
surfaces 0.06 0 "$patch" && new 1 '"rule":"kink"' --surfaces x.g2 --require G1
surfaces 0.05 0 && base --surfaces x.g2 --require G1 --within 0.001,0.01deg && known --surfaces x.g2 --require G1 --within 0.001,0.01deg
base --surfaces "$teapot" --require G2 && known --surfaces "$teapot" --require G2

# --- CAD models, where they are read: with other numbers of entities, at another place, with a
# larger kink
cp "$data/defect_at_end.step" x.step
if "$program" verify x.step >out 2>err || ! grep -q 'optional part' err; then
  moved() { awk 'match($0, /CARTESIAN_POINT\(.*,\([-0-9.E]+,[-0-9.E]+,/) { i = index($0, ",(") + 2; n = index(substr($0, i), ",")
    $0 = substr($0, 1, i - 1) sprintf("%.6f", substr($0, i, n - 1) + 12.5) substr($0, i + n - 1) } { print }' "$@"; }
  renumbered() { awk '{ text = ""; while (match($0, /#[0-9]+/)) { text = text substr($0, 1, RSTART) (substr($0, RSTART + 1, RLENGTH - 1) + 1000)
    $0 = substr($0, RSTART + RLENGTH) } print text $0 }' "$@"; }
  for model in defect_at_end defect_between_samples; do
    file=$data/$model.step
    for require in "G1" "G2 --within 0.001,0.01deg,1%"; do
      cp "$file" x.step && base x.step --require $require && holds [ "$findings" -ge 1 ] && known x.step --require $require
      renumbered "$file" >x.step && holds [ "$(cmp -s "$file" x.step && echo same)" = "" ] && known x.step --require $require
      moved "$file" >x.step && holds [ "$(cmp -s "$file" x.step && echo same)" = "" ] && known x.step --require $require
      moved "$file" | renumbered >x.step && known x.step --require $require
    done
  done
  file=$data/defect_at_end.step
  cp "$file" x.step && base x.step --require G1 && says base.sarif '"quantity":"angle_degrees","bounds":[2.86'
  sed 's/10\.,0\.5)/10.,0.4)/' "$file" >x.step && known x.step --require G1
  sed 's/10\.,0\.5)/10.,0.8)/' "$file" >x.step && new 1 '"rule":"kink"' x.step --require G1
  renumbered x.step >y.step && mv y.step x.step && new 1 '"rule":"kink"' x.step --require G1
  # edges of no face, each of which is not covered
  if [ -n "${MAKE_CAD_MODELS-}" ]; then
    mkdir models && (cd models && "$MAKE_CAD_MODELS") || exit 1
    for model in wall kinks trimmed tori differing pairs fading; do
      base models/$model.brep --require G2 --within 0.001,0.01deg,1% && holds [ "$findings" -ge 1 ] && known models/$model.brep --require G2 --within 0.001,0.01deg,1%
    done
  fi
else
  echo "skipped: built without OpenCASCADE"
fi

# --- fonts and drawings of the system
tried=0
for font in /usr/share/fonts/truetype/*/*.ttf /usr/share/texmf/fonts/opentype/public/lm/lmroman10-regular.otf; do
  [ -e "$font" ] && [ $tried -lt 5 ] && [ "$(wc -c <"$font")" -lt 300000 ] || continue
  base "$font" --require G1 --allow-uncovered && [ "$findings" -gt 10 ] || continue
  tried=$((tried + 1)) && known "$font" --require G1 --allow-uncovered
done
tried=0
while read -r icon; do
  [ $tried -lt 40 ] || break
  cp "$icon" x.svg && base x.svg --require G1 && [ "$findings" -gt 0 ] || continue
  tried=$((tried + 1)) && known x.svg --require G1
  sed '0,/<svg/s//<!-- a\n comment -->\n<svg/' "$icon" >x.svg && known x.svg --require G1
  sed 's/<\/svg>/<path d="M0 0L100 0L200 4"\/><\/svg>/' "$icon" >x.svg && grep -q 'M0 0L100 0L200 4' x.svg && new 1 '"rule":"kink"' x.svg --require G1
done < <(find -L /usr/share/icons /usr/share/pixmaps -name '*.svg' -size -20k 2>/dev/null | LC_ALL=C sort)
[ $tried -gt 0 ] || echo "skipped: no drawings are installed"
