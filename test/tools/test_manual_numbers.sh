#!/usr/bin/env bash
# The counts of the page "CAD Models" are those of the models that it names.
manual=$(cd "$(dirname "$0")/../../doc/Geometric_continuity" && pwd)
. "$(dirname "$0")/functions.sh"

models=/usr/share/opencascade/data
[ -d "$models" ] && [ -x "$(dirname "$program")/geometric_continuity_cad" ] || {
  echo "skipped, without OpenCASCADE and the package occt-misc"
  trap - EXIT
  exit 77
}
find "$models" -iname '*.step' -o -iname '*.iges' -o -iname '*.brep' | while read -r model; do
  # many edges are not G1, and some models have no edge of two sides
  "$program" verify "$model" --json --allow-undecided --allow-uncovered 2>err | sed "s|^|$model: |"
done >models
# MODEL KIND VERDICT for each edge and knot line: the verdict about G1
sed 's/"edge":[0-9]/\n&/g' models | awk '
  /^[^"]*: \{/ { model = $1 }
  match($0, /"kind":"[a-z ]*"/) { kind = substr($0, RSTART + 8, RLENGTH - 9); gsub(/ /, "_", kind) }
  match($0, /"within":\["[a-z]*","[a-z]*"/) { split(substr($0, RSTART, RLENGTH), word, "\""); print model, kind, word[6] }' >verdicts
sentence=$(awk '
  $2 == "knot_line" { ++knot_lines }
  $2 == "inner" || $2 == "seam" { ++edges; ++n[$3]; if (!seen[$1]++) ++models }
  END {
    printf "In the %d models of Debian\x27s package `occt-misc` that have edges of two sides, %d edges were decided within `vda-4955`, ", models, edges
    printf "with %d knot lines: %d G1, %d not, %d undecided", knot_lines, n["proved"], n["refuted"], n["undecided"]
  }' verdicts)
tr -s ' \n' '  ' <"$manual/Cad_models.txt" >page
says page "$sentence"
