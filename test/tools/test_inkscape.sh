#!/usr/bin/env bash
# The extension of Inkscape: as Inkscape calls it, and by Inkscape itself without a screen. Skipped
# without python3.
extension=$(realpath "$(dirname "$0")/../../tools/inkscape")
command -v python3 >/dev/null || exit 77
. "$(dirname "$0")/functions.sh"
export GEOMETRIC_CONTINUITY_PROGRAM=$program

echo '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><!-- kept --><path id="roof" d="M 0,0 H 10 C 20,0.5 30,4 30,20 V 30"/></svg>' >kink.svg
run 1 verify kink.svg --require G1 && says out "1 kink"
holds python3 "$extension/geometric_continuity.py" --id=roof --kink_angle=5 --to=G1 kink.svg >smooth.svg
says smooth.svg '<!-- kept --><path id="roof" d="M 0,0 H 10 C 20,0.0 30,4 30,20 V 30"/>'
run 0 verify smooth.svg --require G1
holds python3 "$extension/geometric_continuity.py" --kink_angle=2 --to=G1 kink.svg >same.svg && holds cmp kink.svg same.svg
echo '<svg xmlns="http://www.w3.org/2000/svg"><rect width="8" height="6"/></svg>' >rectangle.svg
holds python3 "$extension/geometric_continuity.py" --kink_angle=5 --distance=1 rectangle.svg >round.svg && says round.svg 'M 1 0L 7 0C 8 0 8 0 8 1L 8 5'
run 0 verify round.svg --require G2
holds python3 "$extension/geometric_continuity.py" --kink_angle=5 --distance=1 --arcs=true rectangle.svg >arcs.svg && says arcs.svg 'M 1 0L 7 0A 1 1 0 0 1 8 1L 8 5'
holds python3 "$extension/geometric_continuity.py" --kink_angle=5 --distance=1 --arcs=false rectangle.svg | cmp -s - round.svg
echo '<svg' >bad.svg
python3 "$extension/geometric_continuity.py" bad.svg >none.svg 2>refused && holds false
says refused "malformed_input" && holds [ ! -s none.svg ]
GEOMETRIC_CONTINUITY_PROGRAM=/nowhere/program python3 "$extension/geometric_continuity.py" kink.svg >none.svg 2>refused && holds false
says refused "is not installed"

if command -v inkscape >/dev/null && command -v xvfb-run >/dev/null; then
  mkdir -p profile/extensions && cp "$extension"/* profile/extensions
  INKSCAPE_PROFILE_DIR=$PWD/profile timeout 60 xvfb-run -a inkscape --with-gui --batch-process \
    --actions="select-by-id:roof;geometric-continuity.smooth-kinks.noprefs;export-filename:saved.svg;export-plain-svg;export-do" kink.svg >inkscape.log 2>&1
  run 0 verify saved.svg --require G1 && says saved.svg 'C 20,0.0 30,4 30,20'
fi
