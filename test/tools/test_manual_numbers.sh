#!/usr/bin/env bash
# The counts of the page "CAD Models" are those of the models that it names, and of OpenCASCADE's
# samples of them.
manual=$(cd "$(dirname "$0")/../../doc/Geometric_continuity" && pwd)
. "$(dirname "$0")/functions.sh"

models=/usr/share/opencascade/data
[ -d "$models" ] && [ -x "$(dirname "$program")/geometric_continuity_cad" ] || {
  echo "skipped, without OpenCASCADE and the package occt-misc"
  trap - EXIT
  exit 77
}
find "$models" -iname '*.step' -o -iname '*.iges' -o -iname '*.brep' >files
while read -r model; do
  # many edges are not G1, and some models have no edge of two sides
  "$program" verify "$model" --json --allow-undecided --allow-uncovered 2>err | sed "s|^|$model: |"
done <files >models
while read -r model; do
  "$SAMPLED_CONTINUITY" "$model" 0.1 2>err | sed "s|^|$model |"
done <files >sampled
# MODEL EDGE KIND VERDICT for each edge and knot line: the verdict about G1
sed 's/"edge":[0-9]/\n&/g' models | awk '
  /^[^"]*: \{/ { model = $1; sub(/:$/, "", model) }
  match($0, /"edge":[0-9]+/) { edge = substr($0, RSTART + 7, RLENGTH - 7) }
  match($0, /"kind":"[a-z ]*"/) { kind = substr($0, RSTART + 8, RLENGTH - 9); gsub(/ /, "_", kind) }
  match($0, /"within":\["[a-z]*","[a-z]*"/) { split(substr($0, RSTART, RLENGTH), word, "\""); print model, edge, kind, word[6] }' >verdicts
sentence=$(awk '
  $3 == "knot_line" { ++knot_lines }
  $3 == "inner" || $3 == "seam" { ++edges; ++n[$4]; if (!seen[$1]++) ++models }
  END {
    printf "In the %d models of Debian\x27s package `occt-misc` that have edges of two sides, %d edges were decided within `vda-4955`, ", models, edges
    printf "with %d knot lines: %d are G1, %d are not, and %d are undecided", knot_lines, n["proved"], n["refuted"], n["undecided"]
  }' verdicts)
tr -s ' \n' '  ' <"$manual/Cad_models.txt" >page
says page "$sentence"

# rows of the table: | OPENCASCADE | PROVED | EDGES |
awk '
  BEGIN { word["proved"] = "G1"; word["refuted"] = "not G1"; word["undecided"] = "undecided" }
  NR == FNR { sampled[$1, $2] = $3 == "G1" ? "G1" : "not G1"; next }
  $3 == "inner" || $3 == "seam" { if (sampled[$1, $2] != word[$4]) { ++n["| " sampled[$1, $2] " | " word[$4] " | "]; ++all } }
  END { for (row in n) print row n[row] " |"; print "differs for " all + 0 " edges" }' sampled verdicts >rows
holds [ "$(wc -l <rows)" -eq 5 ]
while read -r row; do says page "$row"; done <rows

# sewn FILE: its edges of two sides, and how many are G1
sewn() {
  "$program" verify "$models/iges/$1" --sew 0.01 --summary --allow-undecided --allow-uncovered 2>err |
    awk '/edges: [0-9]* inner/ { sub(/.*edges: /, ""); edges = $1 } match($0, /: [0-9]+ G2, [0-9]+ G1/) { split(substr($0, RSTART, RLENGTH), n, " "); g1 = n[2] + n[4] }
      END { print edges, g1 }'
}
read -r edges g1 < <(sewn bearing.iges)
read -r edges_of_hammer _ < <(sewn hammer.iges)
says page "\`bearing.iges\` of \`occt-misc\` has $edges edges of two sides, $g1 of them G1, and \`hammer.iges\` $edges_of_hammer."
