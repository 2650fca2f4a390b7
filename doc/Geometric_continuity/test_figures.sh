#!/usr/bin/env bash
# The figures of the manual and the README: each one that is named is there, each one that is there
# is drawn by the target `figures`, and small.
set -eu
cd "$(dirname "$0")"
failures=0
fails() {
  echo "$1"
  failures=$((failures + 1))
}
for figure in fig/*; do
  name=$(basename "$figure")
  [ "$(wc -c <"$figure")" -lt 200000 ] || fails "$name has more than 200 kB"
  # on a dark page, too, dark lines have a light background
  case $name in
    *.svg) grep -qE '<rect width="[^"]*" height="[^"]*" fill="#ffffff"/>|style="fill: #ffffff"' "$figure" || fails "$name has no background" ;;
  esac
  grep -qw "${name%.*}" make_figures.sh figures/*.cpp || fails "$name is drawn by nobody"
done
named=$(grep -ho '\\image html [a-z0-9_]*\.[a-z]*' ./*.txt | sed 's/.* //'; grep -o 'fig/[a-z0-9_]*\.[a-z]*' ../../README.md | sed 's,.*/,,')
for name in $named; do
  [ -f "fig/$name" ] || fails "$name is not there"
done
[ -n "$named" ] || fails "no figure is named"
exit $((failures > 0))
