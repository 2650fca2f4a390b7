#!/usr/bin/env bash
# Builds the manual in the current folder, which has the Doxyfile, with its search. Where one of the
# folders has the page geometric_continuity.html, which browser/build makes, the manual gets it, and
# its figures have links to its scenes. Usage: build_manual.sh DOXYGEN FOLDER...
set -eu
doxygen=$1
texts=$(cd "$(dirname "$0")" && pwd)
mkdir -p html
find html -maxdepth 1 -type f -delete # pages of what is no longer there
for folder in "${@:2}"; do
  [ -e html/geometric_continuity.html ] || [ ! -e "$folder/geometric_continuity.html" ] || cp "$folder/geometric_continuity.html" html/
done
{
  cat Doxyfile
  [ ! -e html/geometric_continuity.html ] || echo 'ALIASES += "play{1}=<a href=\"geometric_continuity.html#\1\">Play with it.</a>"'
} | "$doxygen" -

# Doxygen makes a paragraph of the first sentence of a page, which it takes as a brief description.
sed -i -z 's,\(<div class="textblock"><p >[^\n]*\)</p>\n<p >,\1 ,' html/Geometric_continuity_[A-Z]*.html

# Chapters, the reference and examples can be searched, but not lists of names and sources.
cd html
ls index.html Geometric_continuity_*.html class*.html struct*.html group__*.html citelist.html | grep -v -e '-members\.html' -e '^classes\.html' |
  xargs awk -f "$texts/search_index.awk" >search_index.js
cp "$texts/search.js" .
find . -maxdepth 1 -name '*.html' ! -name geometric_continuity.html -exec sed -i 's,^</head>,<script src="search.js" defer></script>\n&,' {} +
