#!/usr/bin/env bash
# plot: pictures of curves and of surfaces.
. "$(dirname "$0")/functions.sh"

# surfaces
run 0 plot --surfaces "$teapot" -o teapot.svg --title 'A <pot>' && says teapot.svg "isophotes" "edge, G1" "boundary" "A &lt;pot&gt;"
holds [ "$(wc -c <teapot.svg)" -lt 1500000 ]
flat "$flat_points" >flat.g2
flat $'1 1 2 2\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n4 2 0' >beside.g2
run 0 plot --surfaces flat.g2 beside.g2 --shaded --view 30,60 -o flat.svg && says flat.svg "edge, G2"
for bad in 30 30,x 30,91 ,; do run 2 plot --surfaces "$teapot" --view "$bad" -o no.svg; done
run 2 plot --surfaces "$teapot" --shaded --isophotes -o no.svg && run 2 plot --surfaces "$L" -o no.svg

# curves
run 0 plot "$data/planar.g2" --alternatives -o alternatives.svg && says alternatives.svg "construction"
run 0 plot "$S" "$L" -o both.svg --title 'A < B & "C"' && says both.svg "A &lt; B &amp;"
run 0 plot "$S" --closed --no-comb --no-polygon --columns 1 -o S.svg
holds [ ! -e no.svg ]
