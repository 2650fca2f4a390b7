#!/usr/bin/env bash
# The README is true: its commands work as they stand, in the top folder of a clone after demo/run,
# its numbers are those of the program, its lines of C++ are those of an example that is run, and
# its links lead somewhere. Its block of Python is run by python/tests/test_manual.py.
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$(dirname "$0")/functions.sh"
readme=$top/README.md
tr -s ' \n' '  ' <"$readme" >flat

mkdir -p build/tools demo/Geometric_continuity
ln -s "$data" demo/Geometric_continuity/data
cad=$(dirname "$program")/geometric_continuity_cad
ln -s "$program" build/tools/geometric_continuity
[ ! -x "$cad" ] || ln -s "$cad" build/tools/
block() { sed -n '/^```'"$1"'$/,/^```$/{/^```/d;p}' "$readme"; }
block bash | grep '^build/tools/' >commands
commands=0
while read -r command; do
  case $command in
    *.step*) [ -x "$cad" ] || continue ;;
  esac
  expected=0 code=0
  case $command in
    *"# exit code 1"*) expected=1 ;;
  esac
  bash -c "$command" >out 2>&1 </dev/null || code=$?
  holds [ "$code" -eq "$expected" ] || { echo "exit code $code: $command"; cat out; }
  case $command in
    *" verify "*.svg*) says out "$(grep -o 'kink of [0-9.]* degrees, which is found' flat | sed 's/,.*//')" ;;
  esac
  for file in $(grep -oE -- '(-o|--plot) [^ ]+' <<<"$command" | sed 's/.* //'); do holds [ -s "$file" ]; done
  commands=$((commands + 1))
done <commands
holds [ $commands -ge 7 ]

# the first picture
run 0 blend "$data/hill_left.g2" "$data/hill_right.g2" --strategy normal,energy3,fair
says out "both joins of every blend are proved" && says flat "three curves that lead from one hill to the other. All joins are proved to be G2"
holds [ "$(awk '/C0 G2 F2/ { print $10, $1 }' out | sort -g | head -n 1 | sed 's/.* //')" = fair ]
# the second one: the letter, as a chain and as a font
sans=$data/lmsans12-regular_S_0.g2
run 1 verify "$sans" --closed --require G1
says flat "$(grep -o 'kink of [0-9.]*' out | sort -k3 -g | awk -v joins="$(sed -n 's/^\([0-9]*\) joins:.*/\1/p' out)" '
  { angle[NR] = $3 }
  END { split("one two three four five six seven", word); printf "of the %d joins of the letter S in Latin Modern Sans, %s turn by %.2f to %.2f degrees", joins, word[NR], angle[1], angle[NR] }')"
run 0 repair "$sans" --closed -o S.g2 && says out "0 kinks" "largest move: 1 unit" "every join is free of kinks, proved exactly" && says flat "moves of handles by one unit of the grid that make all six exactly smooth"
font=/usr/share/texmf/fonts/opentype/public/lm/lmsans12-regular.otf
if [ -e "$font" ]; then
  run 0 verify "$font" --glyphs S && says out "18 joins: 4 corners, 2 kinks, 4 off by rounding" && says flat "two are kinks, four are no more than rounding"
  if command -v fontforge >/dev/null && [ -e "$top/tools/fontforge/apply_moves.py" ]; then
    run 1 repair "$font" -o moves.json # other letters have kinks that no handle can mend
    holds fontforge -script "$top/tools/fontforge/apply_moves.py" "$font" moves.json mended.otf >applied 2>&1
    run 0 verify mended.otf --glyphs S && says out "18 joins: 4 corners, 0 kinks, 14 G1"
  fi
fi

# The lines of C++ stand in the example in this order, and print what its test expects.
example=$top/examples/Geometric_continuity
block cpp >lines
holds [ "$(wc -l <lines)" -eq 4 ]
sed 's/^ *//' "$example/start_blend.cpp" | grep -A3 -xF -- "$(head -n 1 lines)" | cmp - lines || holds false
says flat "$(echo $(cat "$example/expected/start_blend.txt"))"
says "$top/CMakeLists.txt" "find_package(CGAL 5.5 REQUIRED)" && says flat "CGAL 5.5 or newer"
block cmake >cmake.block
holds cmp -s cmake.block <(sed -n '/^find_package/,/^\\endverbatim/{/^\\/d;p}' "$top/doc/Geometric_continuity/Geometric_continuity.txt")
for link in $(grep -oE '\]\([^)#]+\)' "$readme" | tr -d '])('); do holds [ -e "$top/$link" ]; done
