#!/usr/bin/env bash
# blend: every strategy, numbers of both kernels, the replacement of a piece; what it writes is
# proved again.
. "$(dirname "$0")/functions.sh"

# blend by each strategy; every file that is written is proved
for strategy in c2 normal min_second near_line energy2 energy3 fair; do
  run 0 blend "$L" "$R" --strategy $strategy -o blend.g2 && says out "proved in exact arithmetic"
  run 0 verify "$L" blend.g2 "$R" --require G2
done
for strategy in c3 seq_g3 seq_f3 joint_g3 energy3_g3 energy4_g3 fair_g3 fair_f3; do
  run 0 blend "$L" "$R" --order 3 --strategy $strategy -o blend.g2 && says out "proved in exact arithmetic"
  run 0 verify "$L" blend.g2 "$R" --require F3
done
run 0 blend "$L" "$R" --strategy free --s1 -1/5 --s2 0.2 --beta 1 --eta 1 -o free.g2
run 0 blend "$L" "$R" --strategy normal --beta 1 --eta 1 -o normal.g2
holds cmp -s free.g2 normal.g2
run 0 blend "$L" "$R" --order 3 --strategy free --start 0,0,0 --end 0,0,0 -o free.g2
run 0 blend "$L" "$R" --order 3 --strategy c3 -o c3.g2
holds cmp -s free.g2 c3.g2
run 0 blend "$L" "$R" --beta 3/2 --eta 0.5 -o blend.g2
run 0 verify "$L" blend.g2 "$R" --require G2 --json && says out '"betas":["3/2",' '"betas":["2",'
run 0 blend "$L" "$R" --strategy all --plot all.svg
holds [ "$(grep -c '</svg>' all.svg)" -eq 15 ] # for each of seven: the curves and their curvature
says all.svg ">energy3, E = 33.36<" "curvature κ (1/unit) against"
run 0 blend "$L" "$R" --strategy c2,fair --plot two.svg && holds [ "$(grep -c '</svg>' two.svg)" -eq 5 ] && says out "c2 " "fair " && lacks out "energy3 "
for bad in c2, c2,best c2,free c2,all ,; do run 2 blend "$L" "$R" --strategy "$bad" -o no.g2 && says err "strategy"; done
run 0 blend "$L" "$R" && run 0 blend "$L" "$R" --strategy energy3 -o energy3.g2
run 0 blend "$L" "$R" -o default.g2
holds cmp -s default.g2 energy3.g2

# without --beta and --eta the shape is that of the chord, and where one is given the other is still
# that
run 0 blend "$L" "$R" -o automatic.g2 && says out "energy3" "beta = " "eta = "
run 0 blend "$L" "$R" --beta 1 --eta 1 -o unit.g2 && says out "beta = 1, eta = 1"
holds [ "$(cmp -s automatic.g2 unit.g2 && echo same)" = "" ]
eta=$(run 0 blend "$L" "$R"; sed -n 's/.*\(eta = [^,]*\),.*/\1/p' out)
run 0 blend "$L" "$R" --beta 3/2 && says out "beta = 1.5, $eta,"

# smooth joins are not all: a blend that leaves the neighbourhood of its chord, or turns back, is
# named
run 0 blend "$S" --replace 1 --strategy all && holds [ "$(grep -c 'warning: goes .* times the length of its chord away from its ends' out)" -eq 1 ]
holds grep -q '^near_line .*warning: goes' out
# the frame follows the others: that one leaves it, and says so
run 0 blend "$S" --replace 1 --strategy all --plot near.svg && says near.svg ">near_line, E = 2.586e+31; warning: goes 8.2"
outline() { grep -m 1 'stroke="#2f4058" stroke-width="2"' "$1"; } # the first given curve, in the same place and scale
run 0 blend "$S" --replace 1 --strategy c2,normal,fair --plot three.svg && run 0 blend "$S" --replace 1 --strategy c2,normal,near_line --plot near.svg
holds [ "$(outline three.svg)" = "$(outline near.svg)" ]
run 0 blend "$S" --replace 1 --strategy near_line --json && says out '"warning":"goes '
run 0 blend "$S" --replace 1 --json && says out '"warning":null'
run 0 blend "$L" "$R" --beta 4 --eta 4 && says out "warning: turns back"
away() { printf '100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1\n%s\n' "$1"; } # with ends that point away from each other there is no other way
away $'3 1\n2 0.5\n1 0\n0 0' >left.g2 && away $'3 0\n2 0\n1 0.5\n0 1' >right.g2
run 0 blend left.g2 right.g2 --strategy all && lacks out "warning"

# how fair the blends are: fair is the fairest
run 0 blend "$L" "$R" --strategy all && says out "fairness" "bending" "extrema" "inflections" "iteration" "->"
run 0 blend "$L" "$R" --strategy all --json
says out '"strategy":"fair","beta":"' '"start_join":{"left":0,"right":1,"c_order":' '"curvature_extrema":[' \
  '"inflections":[' '"largest_curvature":[' '"bending_energy":' '"iterations":' '"proved":true'
fairness() { sed -n "s/.*\"strategy\":\"$1\".*\"fairness\":\([^,]*\),.*/\1/p" out; }
for strategy in c2 normal min_second near_line energy2 energy3; do
  holds awk -v "x=$(fairness fair)" -v "y=$(fairness $strategy)" 'BEGIN { exit !(0 < x && x <= y) }'
done
run 0 blend "$L" "$R" --order 3 --strategy all --json && says out '"strategy":"fair_g3"' '"strategy":"fair_f3"'
run 0 blend "$L" "$R" --strategy fair --beta 1 --eta 1 && says out "beta = 1, eta = 1"
run 0 blend "$L" "$R" --strategy fair --representable -o chain.g2 && says out "proved in exact arithmetic"
run 0 verify chain.g2 --require G2 --kernel double
run 0 blend "$S" --replace 1 --strategy fair -o S.g2 --plot S.svg
run 0 verify --closed S.g2 --json
says out '{"left":0,"right":1,"c_order":0,"g_order":2' '{"left":1,"right":2,"c_order":0,"g_order":2'
for i in 0 1 27; do # the rest of the chain stays as it is
  run 0 blend "$S" --replace $i --strategy fair -o S.g2
  holds [ "$(grep -cx '6 6' S.g2)" -eq 1 ] && holds [ "$(grep -c '^100 ' S.g2)" -eq 28 ]
  run 0 blend S.g2 --replace $i --order 3 --strategy fair_g3 -o S3.g2 && run 0 verify --closed S3.g2 --json
  says out "{\"left\":$i,\"right\":$(((i + 1) % 28)),\"c_order\":0,\"g_order\":3"
  says out "{\"left\":$(((i + 27) % 28)),\"right\":$i,\"c_order\":0,\"g_order\":3"
done
run 1 blend "$L" "$R" --strategy fair --kernel double && says out "fair " "iteration"
# next to a curvature of 10^6 nothing is fair: a curve that stays near, G2 nevertheless, and the
# report says so
printf '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n-2 0\n-1 0\n0 1\n' >calm.g2
printf '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n2 1\n2 3/2\n500002 2\n' >curl.g2
run 0 blend calm.g2 curl.g2 --strategy fair -o near.g2 && says out "(not converged)" "C0 G2"
run 0 verify calm.g2 near.g2 curl.g2 --require G2
holds awk '{ for (i = 1; i <= NF && NR > 4; ++i) { split($i, a, "/"); x = a[1] / (a[2] ? a[2] : 1); if (x * x > 9) exit 1 } }' near.g2

# blends in double are not exact, and the report says so
run 1 blend "$L" "$R" --kernel double -o double.g2 && says out "decided in exact arithmetic: rounding has broken 2 of 2 joins"
run 1 verify "$L" double.g2 "$R" --kernel double --require G2

# unless they are representable
for strategy in c2 normal min_second near_line energy2 energy3; do
  run 0 blend "$L" "$R" --representable --strategy $strategy -o chain.g2 && says out "G2" "proved in exact arithmetic"
  run 0 verify chain.g2 --require G2 && says out "2 joins"
  run 0 verify chain.g2 --require G2 --kernel double
done
run 2 blend "$L" "$R" --representable --order 3 -o no.g2 && run 2 blend "$S" --replace 1 --representable -o no.g2
printf '100 1 0 0\n3 0\n2 2\n0 0 1 1\n1 0 0\n1.0000000000000002 0 0\n' >stiff.g2
run 2 blend stiff.g2 "$R" --representable -o no.g2 && says err "not_representable"

# a bound on the curvature chooses among the strategies, or the least is named
run 0 blend "$L" "$R" --max-curvature 100 -o bounded.g2 && says out "bent by at most the curvature 100, proved exactly: " "; the fairest, fair, is taken"
run 0 verify "$L" bounded.g2 "$R" --require G2 && run 0 verify bounded.g2 --max-curvature 100
rm -f none.g2 && run 1 blend "$L" "$R" --min-radius 1000 -o none.g2 && says out "none is bent by at most the radius 1000; the least curvature is " ", the radius " ", of "
holds [ ! -e none.g2 ]
run 1 blend "$L" "$R" --strategy c2,fair --max-curvature 1/1000 --json && says out '"max_curvature":"1/1000","max_curvature_met":false'
run 0 blend "$S" --replace 1 --max-curvature 1 -o S.g2 && run 0 verify --closed S.g2

# replacing a piece of an outline
run 0 blend "$S" --replace 1 --beta 1 --eta 1 -o S.g2
run 0 verify --closed S.g2 --json && says out '{"left":0,"right":1,"c_order":1,"g_order":2' '{"left":1,"right":2,"c_order":1,"g_order":2'
run 0 blend "$S" --replace 0 -o S.g2 && run 0 blend "$S" --replace 27 -o S.g2
run 2 blend "$S" --replace 28 -o no.g2 && run 2 blend "$S" --replace -1 -o no.g2 && run 2 blend "$L" --replace 0 -o no.g2
