#!/usr/bin/env bash
# Builds the manual in the current folder, which has the Doxyfile. Where one of the folders has the
# page geometric_continuity.html, which browser/build makes, the manual gets it, and its figures
# have links to its scenes. Usage: build_manual.sh DOXYGEN FOLDER...
set -eu
doxygen=$1
mkdir -p html
rm -f html/geometric_continuity.html
for folder in "${@:2}"; do
  [ -e html/geometric_continuity.html ] || [ ! -e "$folder/geometric_continuity.html" ] || cp "$folder/geometric_continuity.html" html/
done
{
  cat Doxyfile
  [ ! -e html/geometric_continuity.html ] || echo 'ALIASES += "play{1}=<a href=\"geometric_continuity.html#\1\">Play with it.</a>"'
} | "$doxygen" -
