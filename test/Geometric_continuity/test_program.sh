#!/usr/bin/env bash
# What scripts rely on: output, exit codes and errors of the program.
# Usage: test_program.sh PROGRAM DATA_FOLDER WORK_FOLDER TEAPOT.g2
set -u
program=$1 data=$2 work=$3 teapot=$4
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
failures=0 checks=0

# run CODE ARGUMENTS...: the exit code is CODE; output and errors are kept in the files out and err
run() {
  local expected=$1 code=0
  shift
  checks=$((checks + 1))
  "$program" "$@" >out 2>err </dev/null || code=$?
  [ "$code" -eq "$expected" ] && return
  failures=$((failures + 1))
  echo "exit code $code instead of $expected: $*"
  cat out err
}
# says FILE TEXT...: the file contains each text
says() {
  local file=$1 text
  shift
  for text in "$@"; do
    checks=$((checks + 1))
    grep -qF -- "$text" "$file" && continue
    failures=$((failures + 1))
    echo "'$text' is missing in $file:"
    cat "$file"
  done
}
# holds CONDITION...: the shell condition is true
holds() {
  checks=$((checks + 1))
  if ! "$@"; then
    failures=$((failures + 1))
    echo "not true: $*"
  fi
}

S=$data/lmroman10-regular_S_0.g2 L=$data/space_left.g2 R=$data/space_right.g2

# help and usage
run 0 --help && says out "blend" "extend" "verify" "plot"
for command in blend connect extend verify plot; do run 0 $command --help && says out "usage: geometric_continuity $command"; done
run 2 && run 2 nonsense && says err "unknown command"
run 2 verify && run 2 verify --nonsense "$S" && run 2 blend "$L" && run 2 plot "$L"

# blend by each strategy; every file that is written is proved
for strategy in c2 normal min_second near_line energy2 energy3; do
  run 0 blend "$L" "$R" --strategy $strategy -o blend.g2 && says out "proved in exact arithmetic"
  run 0 verify "$L" blend.g2 "$R" --require G2
done
for strategy in c3 seq_g3 seq_f3 joint_g3 energy3_g3 energy4_g3; do
  run 0 blend "$L" "$R" --order 3 --strategy $strategy -o blend.g2 && says out "proved in exact arithmetic"
  run 0 verify "$L" blend.g2 "$R" --require F3
done
run 0 blend "$L" "$R" --strategy free --s1 -1/5 --s2 0.2 -o free.g2
run 0 blend "$L" "$R" --strategy normal -o normal.g2
holds cmp -s free.g2 normal.g2
run 0 blend "$L" "$R" --order 3 --strategy free --start 0,0,0 --end 0,0,0 -o free.g2
run 0 blend "$L" "$R" --order 3 --strategy c3 -o c3.g2
holds cmp -s free.g2 c3.g2
run 0 blend "$L" "$R" --beta 3/2 --eta 0.5 -o blend.g2
run 0 verify "$L" blend.g2 "$R" --require G2 --json && says out '"betas":["3/2",' '"betas":["2",'
run 0 blend "$L" "$R" --strategy all --plot all.svg
holds [ "$(grep -c '</svg>' all.svg)" -eq 7 ]
run 0 blend "$L" "$R" && run 0 blend "$L" "$R" --strategy energy3 -o energy3.g2
run 0 blend "$L" "$R" -o default.g2
holds cmp -s default.g2 energy3.g2

# blends in double are not exact, and the report says so
run 0 blend "$L" "$R" --kernel double -o double.g2 && says out "rounding has broken a join"
run 1 verify "$L" double.g2 "$R" --kernel double --require G2

# replacing a piece of an outline
run 0 blend "$S" --replace 1 -o S.g2
run 0 verify --closed S.g2 --json && says out '{"left":0,"right":1,"c_order":1,"g_order":2' '{"left":1,"right":2,"c_order":1,"g_order":2'
run 0 blend "$S" --replace 0 -o S.g2 && run 0 blend "$S" --replace 27 -o S.g2
run 2 blend "$S" --replace 28 -o no.g2 && run 2 blend "$S" --replace -1 -o no.g2 && run 2 blend "$L" --replace 0 -o no.g2

# verify
run 0 verify --closed "$S" && says out "28 joins: 12 G0, 12 G1, 4 G2" "kink of 0.2217 degrees" "zero tangent at the start" \
  "curvature jumps from"
run 0 verify --closed "$S" --require C0 && run 1 verify --closed "$S" --require G1 && run 1 verify "$L" "$R" --require C0
run 1 verify "$L" "$R" --json --require C0 && says out '"c_order":-1,"g_order":-1,"f_order":-1,"betas":[]' '"met":false'
run 0 verify "$L" blend.g2 "$R" --max-order 0 && run 0 verify "$L" blend.g2 "$R" --max-order 9
run 2 verify "$L" blend.g2 "$R" --max-order 33 && run 2 verify "$L" blend.g2 "$R" --max-order two
for bad in G X2 G2x g2 2 "" G99; do run 2 verify --closed "$S" --require "$bad" && says err "--require"; done
run 2 verify --closed "$S" --require F3 && says err "at most the dimension"
run 2 verify "$L" && says err "no join"
if command -v python3 >/dev/null; then
  run 0 verify --closed "$S" --json
  holds python3 -c "import json; d = json.load(open('out')); assert len(d['joins']) == 28 and d['joins'][27]['right'] == 0"
fi

# extend: the members that are asked for, and what does not exist
run 0 extend "$L" --order curvature --c0 3 -o two.g2 && says out "C1 G2"
run 0 verify two.g2 --require G2
run 0 extend two.g2 --order torsion --beta 1/2 --c0 1 --c1 2 --c2 -1 -o three.g2 --plot three.svg
run 0 verify three.g2 --require F2 && says out "2 joins"
run 0 extend "$L" --order torsion --toward 6,1,2 -o two.g2 && run 0 verify two.g2 --require F3
run 0 extend "$L" --order tangent --toward 6,1,2 -o two.g2 && says two.g2 "6 1 2"
run 0 extend "$L" --order curvature --kernel double -o two.g2
run 2 extend "$L" --order shape -o no.g2 && run 2 extend "$L" -o no.g2 && run 2 extend "$L" --order tangent
run 2 extend "$L" --order tangent --c0 1 -o no.g2 && run 2 extend "$L" --order torsion --toward 1,2 -o no.g2
run 2 extend "$L" --order torsion --toward 1,2,3 --c0 1 -o no.g2 && run 2 extend "$L" --order tangent --beta 0 -o no.g2
printf '100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 0\n1 0\n' >line.g2
run 2 extend line.g2 --order curvature -o no.g2 && says err "wrong_number_of_points"
run 0 extend line.g2 --order tangent -o two.g2 && run 2 plot line.g2 --alternatives -o no.svg

# connect: a flat ribbon, one that folds, curves that do not fit
cubic() { printf '100 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1\n%s\n' "$1"; }
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >c.g2
cubic $'0 1 0\n1 1 0\n2 1 0\n3 1 0' >c1.g2
cubic $'0 -1 0\n1 -1 0\n2 -1 0\n3 -1 0' >c2.g2
cubic $'0 3 0\n1 3 0\n2 3 0\n3 3 0' >c3.g2
run 0 connect c.g2 c1.g2 c2.g2 -o ribbon.g2 && says ribbon.g2 "200 1 0 0" "7 7"
run 0 verify ribbon.g2 --surfaces --require G1 && says out "1 G2"
run 1 connect c.g2 c1.g2 c3.g2 -o fold.g2
run 2 connect c.g2 c1.g2 c1.g2 -o no.g2 && says err "singular_frame"
run 2 connect c.g2 c1.g2 -o no.g2

# surfaces
run 0 verify "$teapot" --surfaces --json && says out '"summary":{"G2":24,"G1":20,"G0":8,"boundary":16,"collapsed":8'
run 1 verify "$teapot" --surfaces --require G1 && says out "8 of them not G1"
run 2 verify "$L" --surfaces && says err "space_left.g2:1"
run 2 verify "$teapot" --surfaces --require F1

# pictures
run 0 plot "$data/planar.g2" --alternatives -o alternatives.svg && says alternatives.svg "construction"
run 0 plot "$S" "$L" -o both.svg --title 'A < B & "C"' && says both.svg "A &lt; B &amp;"
run 0 plot "$S" --closed --no-comb --no-polygon --columns 1 -o S.svg
holds [ ! -e no.g2 ]

# bad input: a message with file, line and reason, exit code 2, and no output
bad() { # bad REASON: the file bad.g2 is refused
  run 2 verify bad.g2 "$L" && says err "bad.g2" "$1"
  run 2 blend bad.g2 "$R" -o no.g2 --plot no.svg && says err "bad.g2"
  holds [ ! -e no.g2 -a ! -e no.svg ]
}
curve() { printf '100 1 0 0\n%s\n' "$1"; }
printf '' >bad.g2
bad "bad.g2:1"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2' >bad.g2
bad "3 of 4"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 nan 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 inf 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1/0 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1e999999999 1\n2 2 2\n3 3 3' >bad.g2
bad "bad.g2:6"
curve $'3 0\n4000000000 4\n0 0 0 0 1 1 1 1\n0 0 0' >bad.g2
bad "bad.g2:3"
curve $'3 1\n4 4\n0 0 0 0 1 1 1 1\n0 0 0' >bad.g2
bad "bad.g2:2"
curve $'3 0\n4 4\n0 0 0 0 1 1 1 1\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4' >bad.g2
bad "bad.g2:9"
printf '\0\0\0\377\376' >bad.g2
bad "bad.g2:1"
printf '200 1 0 0\n' >bad.g2
bad "200"
run 2 verify missing.g2 "$L" && says err "missing.g2"
run 2 verify "$L" "$S" && says err "dimension"
run 2 blend "$L" "$S" -o no.g2 && says err "dimension_mismatch"
run 2 blend "$L" "$R" --beta 0 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --eta -1 -o no.g2 && says err "nonpositive_beta"
run 2 blend "$L" "$R" --beta two -o no.g2 && says err "--beta"
run 2 blend "$L" "$R" --strategy free -o no.g2 && run 2 blend "$L" "$R" --strategy best -o no.g2 && says err "energy3"
run 2 blend "$L" "$R" --order 4 -o no.g2 && run 2 blend "$L" "$R" --kernel quad -o no.g2
curve $'3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 1 1\n1 1 1' >cusp.g2
run 2 blend cusp.g2 "$R" -o no.g2 && says err "zero_tangent: blend: end of the first curve"
run 2 blend "$L" "$R" -o missing/no.g2 && says err "missing/no.g2"
echo old >old.g2
run 2 blend cusp.g2 "$R" -o old.g2
holds [ "$(cat old.g2)" = old ]
holds [ ! -e no.g2 ]

echo "$checks checks, $failures failures"
[ $failures -eq 0 ]
