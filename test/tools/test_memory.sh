#!/usr/bin/env bash
# Little memory and a small stack: the program ends with an exit code of its own, never by a signal,
# and leaves no files.
. "$(dirname "$0")/functions.sh"

numbers() { # COUNT DIGITS: fractions of that many random digits, the same ones in each run
  awk -v n="$1" -v digits="$2" 'BEGIN {
    srand(7)
    for (i = 0; i < n; ++i) {
      s = ""
      for (j = 0; j < digits; ++j) s = s (1 + int(9 * rand()))
      print s "/" substr(s, 2) 7
    }
  }'
}
repeat() { printf "$2%.0s" $(seq "$1"); }

fractions() { # ORDER DIGITS: two curves in the plane, with such coordinates
  for i in 1 2; do
    printf '100 1 0 0\n2 0\n%d %d\n%s%s\n' "$1" "$1" "$(repeat "$1" '0 ')" "$(repeat "$1" '1 ')"
    printf '%d %d\n%s\n%d %d\n' $i $i "$(numbers $((2 * $1 - 4)) "$2")" $((i + 1)) $((i + 1))
  done
}
fractions 24 1900 >huge.g2
fractions 12 600 >large.g2
fractions 12 100 >medium.g2
{
  printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0'
  for i in $(seq 1000); do printf 'c1 2 %d 4 5 %d' $i $i; done
  printf '"/></svg>\n'
} >drawing.svg
{
  printf '100 1 0 0\n2 0\n600 2\n0'
  seq -s ' ' 0 599 | sed 's/^/ /; s/$/ 599/'
  seq 1 600 | sed 's/$/ 1/'
} >long.g2
run 0 verify huge.g2 && run 0 verify large.g2 && run 0 verify drawing.svg

# Limits of memory between what the program needs to start and what it needs to finish.
starts=$(memory_to_start)
memory() { # ARGUMENTS...
  local suffices=$starts code=0 refusals=0
  until limited $suffices "$@" || [ $suffices -gt 400000 ]; do suffices=$((suffices + suffices / 4)); done
  for i in 0 1 2 3 4 5 6 7 8 9; do
    checks=$((checks + 1)) code=0
    limited $((starts + (suffices - starts) * i / 10)) "$@" || code=$?
    [ $code -eq 0 ] && continue
    refusals=$((refusals + 1))
    [ $code -eq 2 ] && grep -q "out of memory" err && continue
    failures=$((failures + 1))
    echo "exit code $code with $((starts + (suffices - starts) * i / 10)) kB: $*"
    head -c 1000 err
  done
  echo "$refusals of 10 limits from $starts to $suffices kB refused: $*"
  holds [ -z "$(find . -name '.geometric_continuity*')" ]
}
memory verify huge.g2
memory verify large.g2 huge.g2 --within 1,1,1
memory verify --allow-uncovered --surfaces "$teapot" "$teapot" "$teapot" "$teapot"
memory verify drawing.svg
memory plot long.g2 --no-comb -o plot.svg
memory plot --surfaces "$teapot" -o plot.svg
memory tessellate "$teapot" --grid 20 -o mesh.off
memory blend medium.g2 medium.g2 -o blend.g2
memory extend large.g2 --order curvature -o blend.g2

# A stack of 256 kB, at the limits of depth: groups in groups, curves of the highest order.
nested=$(repeat 254 '<g transform="scale(2)">')$(printf '<path d="M0 0h1v1"/>')$(repeat 254 '</g>')
svg "$nested"
order=128
for i in 1 2; do
  printf '100 1 0 0\n3 0\n%d %d\n%s%s\n' $order $order "$(repeat $order '0 ')" "$(repeat $order '1 ')"
  for j in $(seq 0 127); do echo "$((i * 127 + j)) $((j * j % 7 * (j > 2 && j < 125))) $((j % 5 * (j > 2 && j < 125)))"; done
done >order.g2
sed -n 1,132p order.g2 >left.g2
sed '1,132d' order.g2 >right.g2
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >c.g2
cubic $'0 1 0\n1 1 0\n2 1 0\n3 1 0' >c1.g2
cubic $'0 -1 0\n1 -1 0\n2 -1 0\n3 -1 0' >c2.g2
stack() { # ARGUMENTS...: the exit code is 0 or 1
  (ulimit -s 256 && timeout 60 "$program" "$@" >out 2>err)
  local code=$?
  [ $code -le 1 ] || head -c 1000 err
  holds [ "$((code <= 1)) $*" = "1 $*" ]
}
stack verify drawing.svg --json
stack verify order.g2 && stack verify order.g2 --kernel double && stack verify large.g2 --within 1,1,1
stack verify --surfaces "$teapot" --within 1,1
stack plot order.g2 -o plot.svg && stack plot --surfaces "$teapot" -o plot.svg && stack plot "$data/planar.g2" --alternatives -o plot.svg
stack tessellate "$teapot" -o mesh.off && stack tessellate "$teapot" --kernel exact -o mesh.off
stack connect c.g2 c1.g2 c2.g2 -o ribbon.g2
stack blend left.g2 right.g2 -o blend.g2 && stack blend left.g2 right.g2 --order 3 -o blend.g2
stack blend "$L" "$R" --strategy all --plot plot.svg && stack extend left.g2 --order torsion -o blend.g2
