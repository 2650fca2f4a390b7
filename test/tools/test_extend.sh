#!/usr/bin/env bash
# extend: the members of the families that are asked for, and what does not exist.
. "$(dirname "$0")/functions.sh"

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
# what is decided is what is written: verify agrees for every curve, whether rounding has broken its
# join or not
holding=0 broken=0
for seed in $(seq 1 30); do
  awk -v seed="$seed" 'BEGIN {
    srand(seed)
    print "100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1"
    for (i = 0; i < 4; ++i) print int(1800 * rand() - 900) / (seed % 2 ? 100 : 64), int(1800 * rand() - 900) / (seed % 2 ? 100 : 64)
  }' >curve.g2
  for beta in 1 0.1 0.3 1/1024; do
    code=0
    "$program" extend curve.g2 --order tangent --beta $beta --kernel double -o two.g2 >out 2>err || code=$?
    run "$code" verify two.g2 --require G1
    if [ "$code" -eq 0 ]; then holding=$((holding + 1)); else broken=$((broken + 1)); fi
  done
done
holds [ "$holding" -ge 10 ]
holds [ "$broken" -ge 10 ]
# rounding breaks a join: the file is written all the same
run 1 extend "$L" --order torsion --beta 1/3 --kernel double -o broken.g2 && says out "rounding has broken the join"
run 1 verify broken.g2 --require G2 && run 0 extend "$L" --order torsion --beta 1/3 -o exact.g2 && says out "the join is proved"
