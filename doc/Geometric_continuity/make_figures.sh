#!/usr/bin/env bash
# Draws all figures of the manual and the README anew. Usage: make_figures.sh PROGRAM EXAMPLES
# DRAW_FIGURES: the path of geometric_continuity, the folder of the examples' programs, and the path
# of the program in figures/. The picture of a CAD model's report needs OpenCASCADE, the model
# linkrods.step of Debian's occt-misc and Chromium; it stays as it is where they are missing.
set -eu
program=$(realpath "$1") examples=$(realpath "$2") draw_figures=$(realpath "$3")
here=$(cd "$(dirname "$0")" && pwd)
data=$here/../../demo/Geometric_continuity/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$draw_figures" .
# road_faults.svg is drawn by road_joins, the others by the examples of their names
for example in blend_surfaces_g3 fair_blend interpolate_fair join_the_spout line_and_arc orders_of_continuity portnov_figures road_joins; do "$examples/$example" >/dev/null; done

"$program" blend "$data/hill_left.g2" "$data/hill_right.g2" --strategy normal,energy3,fair --plot first_blend.svg \
  --title "Three blends, each proved G2: the lower E, the more evenly the curvature varies" >/dev/null
"$program" blend "$data/space_left.g2" "$data/space_right.g2" --strategy all --plot space_blends.svg >/dev/null
cp "$data/lmroman10-regular_S_0.g2" as_drawn.g2
"$program" blend as_drawn.g2 --corners all --closed --distance 60 -o every_join_G2.g2 >/dev/null
"$program" plot as_drawn.g2 every_join_G2.g2 --closed --no-polygon --columns 2 --title "The letter S of Latin Modern" -o letter.svg
"$program" plot "$data/planar.g2" --alternatives --no-comb -o alternatives.svg
"$program" plot --surfaces "$data/teapot.g2" --title "The teapot: 32 bicubic patches, every edge decided exactly" -o teapot.svg
for figure in surface_blend_energy3 surface_blend_fairest; do
  strategy=${figure##*_}
  "$program" blend --surfaces "$data/bent_near.g2" "$data/bent_far.g2" --strategy "$strategy" -o blend.g2 >/dev/null
  "$program" plot --surfaces "$data/bent_near.g2" blend.g2 "$data/bent_far.g2" --title "The blend by $strategy" -o $figure.svg
done
"$program" round-edges "$data/box.g2" --set-back 2 --open --plot rounded_box.svg >/dev/null
cat >bracket.off <<'END'
OFF
12 8 18
0 0 0
40 0 0
40 10 0
10 10 0
10 40 0
0 40 0
0 0 20
40 0 20
40 10 20
10 10 20
10 40 20
0 40 20
6 5 4 3 2 1 0
6 6 7 8 9 10 11
4 0 1 7 6
4 1 2 8 7
4 2 3 9 8
4 3 4 10 9
4 4 5 11 10
4 5 0 6 11
END
"$program" round-edges bracket.off --set-back 2 --plot rounded_solid.svg >/dev/null
"$program" plot --surfaces "$data/fillet.g2" --title "Cylinder, fillet, plane" -o fillet.svg
# fair_curves.svg is drawn by the benchmark of this name, where it is built
compare_fair_curves=$(dirname "$program")/../benchmark/Geometric_continuity/compare_fair_curves
if [ -x "$compare_fair_curves" ]; then "$compare_fair_curves" fair_curves.svg >/dev/null; fi
# from_python.svg is drawn by the page "From Python", where the module is built; PYTHON is an
# interpreter with matplotlib
module=$(dirname "$program")/../python
if [ -d "$module/geometric_continuity" ]; then
  FIGURES=$work PYTHONPATH=$module GEOMETRIC_CONTINUITY_PROGRAM=$program "${PYTHON-/usr/bin/python3}" "$here/../../python/tests/test_manual.py"
fi

model=/usr/share/opencascade/data/step/linkrods.step
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -f "$model" ] && [ -n "$browser" ] && "$program" report "$model" -o linkrods.html 2>no_cad; then
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$work/profile" \
    --force-device-scale-factor=0.75 --window-size=1400,780 --virtual-time-budget=8000 --screenshot=report_of_a_cad_model.png \
    "file://$work/linkrods.html" >/dev/null 2>&1
else
  echo "report_of_a_cad_model.png stays as it is: it needs OpenCASCADE, $model and Chromium" >&2
fi

draw_solids=$(dirname "$draw_figures")/draw_solids
if [ -x "$draw_solids" ]; then
  "$draw_solids" make . | while read -r name set_back; do
    "$program" round-edges "$name.step" --set-back "$set_back" -o "${name}_rounded.step" >/dev/null
  done
  "$draw_solids" draw . rounded_solids.png
else
  echo "rounded_solids.png stays as it is: it needs OpenCASCADE" >&2
fi

for figure in *.svg *.png; do
  [ -f "$figure" ] || continue
  [ "$(wc -c <"$figure")" -lt 200000 ] || { echo "$figure has more than 200 kB" >&2 && exit 1; }
  cp "$figure" "$here/fig/"
done
