#!/usr/bin/env bash
# blend: every strategy, numbers of both kernels, the replacement of a piece; what it writes is proved again.
. "$(dirname "$0")/functions.sh"

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
run 1 blend "$L" "$R" --kernel double -o double.g2 && says out "rounding has broken a join"
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

# replacing a piece of an outline
run 0 blend "$S" --replace 1 -o S.g2
run 0 verify --closed S.g2 --json && says out '{"left":0,"right":1,"c_order":1,"g_order":2' '{"left":1,"right":2,"c_order":1,"g_order":2'
run 0 blend "$S" --replace 0 -o S.g2 && run 0 blend "$S" --replace 27 -o S.g2
run 2 blend "$S" --replace 28 -o no.g2 && run 2 blend "$S" --replace -1 -o no.g2 && run 2 blend "$L" --replace 0 -o no.g2
