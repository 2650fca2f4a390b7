#!/usr/bin/env bash
# The commands that the manual shows print what it shows. Each command is a line "$ ..." in a
# \verbatim block, followed by its output; "..." stands for any text that is left out, and line
# breaks may stand where the output has a space.
manual=$(cd "$(dirname "$0")/../../doc/Geometric_continuity" && pwd)
. "$(dirname "$0")/functions.sh"

PATH=$(cd "$(dirname "$program")" && pwd):$PATH
cp "$data"/*.svg "$data"/*.g2 .
for file in /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf /usr/share/fonts/truetype/inter-vf/Inter.var.ttf /usr/share/opencascade/data/step/linkrods.step; do
  [ ! -e "$file" ] || ln -s "$file" .
done
# the ribbon of the page "B-splines and Surfaces"
spline $'6 4\n0 0 0 0 2 2 4 4 4 4\n0 0 0\n2 0 0\n4 0 3\n6 0 3\n8 0 0\n10 0 0' >C.g2
spline $'6 4\n0 0 0 0 2 2 4 4 4 4\n1 3 0\n3 4 1\n4 5 4\n6 5 4\n9 4 -1\n11 3 0' >C1.g2
spline $'6 4\n0 0 0 0 2 2 4 4 4 4\n1 -3 0\n3 -2 1\n4 -4 4\n6 -4 4\n9 -2 -1\n11 -3 0' >C2.g2

# command_NUMBER and shown_NUMBER for each command
awk '
  /^\\verbatim/ { inside = 1; next }
  /^\\endverbatim/ { inside = shown = 0; next }
  inside && /^\$ / { ++n; shown = 1; print substr($0, 3) > sprintf("command_%02d", n); printf "" > sprintf("shown_%02d", n); next }
  shown { print > sprintf("shown_%02d", n) }' "$manual"/*.txt
words() { tr -s ' \n' '  ' <"$1" | sed 's/^ //; s/ $//'; }
agree() { # SHOWN OUTPUT: the parts between "..." follow each other in the output, from its start to its end
  awk -v shown="$(words "$1" | sed 's/\\/\\\\/g')" -v output="$(words "$2" | sed 's/\\/\\\\/g')" 'BEGIN {
    parts = split(shown, part, / ?\.\.\. ?/)
    if (parts == 1) exit shown != output
    for (i = 1; i <= parts; ++i) {
      at = index(output, part[i])
      if (part[i] != "" && (at == 0 || (i == 1 && at > 1))) { print "not in the output: " part[i]; exit 1 }
      if (i == parts && part[i] != "" && substr(output, length(output) - length(part[i]) + 1) != part[i]) { print "not the end: " part[i]; exit 1 }
      if (part[i] != "") output = substr(output, at + length(part[i]))
    }
  }'
}
for command in command_*; do
  text=$(cat "$command") missing=
  for word in $text; do
    case $word in
      *.step | *.ttf | *.xodr) [ -e "$word" ] || missing=$word ;;
    esac
  done
  [ -z "$missing" ] || {
    echo "skipped, there is no $missing: $text"
    continue
  }
  case $text in
    *.step*) [ -x "$(dirname "$program")/geometric_continuity_cad" ] || {
      echo "skipped, without OpenCASCADE: $text"
      continue
    } ;;
  esac
  bash -c "$text" >out 2>&1 </dev/null
  echo "$text"
  holds agree "${command/command/shown}" out
done
[ "$checks" -gt 7 ]
