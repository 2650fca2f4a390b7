#!/usr/bin/env bash
# Draws the figures of the manual and the README anew. Usage: make_figures.sh PROGRAM (the path of geometric_continuity)
set -eu
program=$1
here=$(cd "$(dirname "$0")" && pwd)
data=$here/../../demo/Geometric_continuity/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$data/lmroman10-regular_S_0.g2" "$work/as_drawn.g2"
"$program" blend "$work/as_drawn.g2" --corners all --closed --distance 60 -o "$work/every_join_G2.g2" >/dev/null
"$program" plot "$work/as_drawn.g2" "$work/every_join_G2.g2" --closed --no-polygon --columns 2 \
  --title "The letter S of Latin Modern" -o "$here/fig/letter.svg"
"$program" blend "$data/space_left.g2" "$data/space_right.g2" --strategy all --plot "$here/fig/space_blends.svg" >/dev/null
"$program" plot "$data/planar.g2" --alternatives --no-comb -o "$here/fig/alternatives.svg"
"$program" plot --surfaces "$data/teapot.g2" --title "The teapot: 32 bicubic patches, every edge decided exactly" -o "$here/fig/teapot.svg"
"$program" plot --surfaces "$data/fillet.g2" --title "Cylinder, fillet, plane" -o "$here/fig/fillet.svg"
