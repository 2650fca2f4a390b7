#!/usr/bin/env bash
# interpolate and fit: curves through and near points, what verify says of them, and points that are
# refused.
. "$(dirname "$0")/functions.sh"

printf '# five points\n0 0\n4, 3\n9;3\t# a comment\n\n9 -1\r\n2 -4/2\n' >five.txt
run 0 interpolate five.txt -o five.g2 --plot five.svg && says out "5 points, chordal parameters, 4 cubic pieces" "3 joins, C2, proved in exact arithmetic"
run 0 verify five.g2 --require C2 && says out "3 joins"
holds grep -q "<svg" five.svg
for parameters in uniform chordal centripetal; do
  run 0 interpolate five.txt --closed --parameters $parameters -o closed.g2 && says out "5 joins, C2"
  run 0 verify closed.g2 --closed --require C2
  run 0 interpolate five.txt --parameters $parameters --kernel double -o double.g2 && run 0 verify double.g2 --require C2 --kernel double
done
run 0 interpolate five.txt --json && says out '{"points":5,"closed":false,"curve":"cubic","parameters":"chordal","pieces":4,"joins":3,"c_order":2,"g_order":2}'
"$program" interpolate - -o - <five.txt >out 2>err && cmp -s out five.g2 || holds false
# fair quintics: with rounded numbers, too, where points with many digits are moved a little
for kernel in exact double; do
  run 0 interpolate five.txt --fair --kernel $kernel -o fair.g2 --plot fair.svg && says out "4 fair quintics" "3 joins, G2, proved" && lacks out moved
  run 0 verify fair.g2 --require G2 --kernel $kernel
  run 0 interpolate five.txt --fair --closed --kernel $kernel -o fair.g2 && run 0 verify fair.g2 --closed --require G2 --kernel $kernel
done
awk 'BEGIN { for (i = 0; i < 9; ++i) print cos(i * .7) * 1e3 / 3, sin(i * .7) * 1e3 / 3, i / 7 }' OFMT=%.17g >helix.txt
run 0 interpolate helix.txt --fair --kernel double -o fair.g2 && says out "moved by at most" && run 0 verify fair.g2 --require G2 --kernel double
printf '0 0\n1 2.3\n2.7 3.1\n4 0.3\n' >four.txt && run 0 interpolate four.txt --fair --kernel double -o fair4.g2 && says err "the decimals stand for doubles: verify --kernel double"
holds [ "$(grep -c / fair4.g2)" -eq 0 ] && run 1 verify fair4.g2 --require G2 && run 0 verify fair4.g2 --require G2 --kernel double
run 0 interpolate helix.txt --fair --json && says out '"curve":"fair","parameters":null,"pieces":8,"joins":7' '"g_order":2'
run 2 interpolate helix.txt --fair --parameters uniform && says err "--parameters: not with --fair"
printf '0 0 0\n1/3 1 0.5\n' >two.txt && run 0 interpolate two.txt --json && says out '"joins":0,"c_order":null'

# a bound on the curvature
run 0 interpolate five.txt --max-curvature 9 && says out "every curve is bent by at most the curvature 9, proved exactly"
run 1 interpolate five.txt --fair --min-radius 5 -o fair.g2 && says out "curves not bent by at most the radius 5; worst, curve " "curvature " && holds [ -s fair.g2 ]
run 1 interpolate five.txt --max-curvature 1/100 --json && says out '"max_curvature":"1/100","max_curvature_met":false,"bent_curves":[{"curve":0,"parameter":['

# far from the origin the control points have more digits than doubles
for i in {0..8}; do echo "$((10 ** 15 + i)).3 $((10 ** 15 + i * (8 - i))).7"; done >far.txt
run 0 fit far.txt --tolerance 1/10 --order G2 --corner 180 -o far.g2 && says out "7 joins without a corner, G2, proved" && run 0 verify far.g2 --require G2

# a half circle, closed by its diameter
awk 'BEGIN { for (i = 0; i <= 400; ++i) { t = i / 200 - 1; print -200 * t / (1 + t * t), 100 * (1 - t * t) / (1 + t * t) } }' >half.txt
run 0 fit half.txt --tolerance 1/100 --closed -o half.g2 --plot half.svg && says out "401 points" "2 corners" "proved in exact arithmetic"
run 0 verify half.g2 --summary
run 0 fit half.txt --tolerance 0.01 -o half.g2 && says out ", 0 corners" "G1 or more" && run 0 verify half.g2 --require G1
run 0 fit half.txt --tolerance 0.01 --min-radius 90 && says out "every curve is bent by at most the radius 90"
run 1 fit half.txt --tolerance 0.01 --min-radius 101 --json && says out '"max_curvature":"1/101","max_curvature_met":false'
run 0 fit half.txt --tolerance 0.001 --order G2 -o half.g2 && says out "quintic" && run 0 verify half.g2 --require G2
run 0 fit half.txt --tolerance 0.01 --closed --corner 100 --order G2 -o half.g2 && says out ", 0 corners"
run 0 verify half.g2 --closed --require G2
run 0 fit half.txt --tolerance 0.01 --closed --json && says out '"points":401,"closed":true,"order":"G1"' '"tolerance":"0.01","distance":0.00' '"corners":[0,' '"g_order":'
if command -v python3 >/dev/null; then
  holds python3 -c 'import json, sys; r = json.load(open("out")); sys.exit(not (r["pieces"] == len(r["vertices"]) - 1 and r["distance"] <= 0.01))'
  # the distance, from the control points of the file alone
  holds python3 - half.g2 half.txt <<'CHECK'
import sys
from fractions import Fraction
words = open(sys.argv[1]).read().split()
pieces = []
while words:
    dimension, n, degree = int(words[4]), int(words[6]), int(words[7]) - 1
    numbers = [float(Fraction(w)) for w in words[8 + n + degree + 1:8 + n + degree + 1 + n * dimension]]
    pieces.append([numbers[i * dimension:(i + 1) * dimension] for i in range(n)])
    words = words[8 + n + degree + 1 + n * dimension:]
def point(b, t):
    while len(b) > 1: b = [[(1 - t) * x + t * y for x, y in zip(p, q)] for p, q in zip(b, b[1:])]
    return b[0]
worst = 0
for b in pieces:
    for i in range(201):
        x, y = point(b, i / 200)
        worst = max(worst, min(abs((x * x + y * y) ** .5 - 100), abs(y))) # from the circle and the diameter
sys.exit(not (1e-4 < worst < 0.0101 + 100 * (1 - .99998)))
CHECK
fi

printf '0 0\n4 0\n5 3\n2 5\n-1 3\n' >pentagon.txt
run 0 fit pentagon.txt --closed --tolerance 1e-9 -o pentagon.g2 && says out "5 cubic curves, 5 corners"
run 0 fit pentagon.txt --closed --tolerance 1e-9 --corner 90 --order G2 -o pentagon.g2 && run 0 verify pentagon.g2 --closed --require G2

# errors: file, line, reason
run 2 fit half.txt && says err "--tolerance is needed" && run 2 fit --tolerance 1 && run 2 interpolate && run 2 interpolate five.txt half.txt
for tolerance in 0 -1 nan 1e-30 one; do run 2 fit half.txt --tolerance $tolerance; done
run 2 fit half.txt --tolerance 1 --order G3 && says err "'G3' is none of G1, G2"
run 2 fit half.txt --tolerance 1 --corner 200 && says err "half.txt: parameter_outside_domain"
run 2 interpolate five.txt --parameters chordial && says err "did you mean 'chordal'?"
printf '0 0\n1 nan\n' >nan.txt && printf '0 0\n1 1\n\n1 2 3\n' >mixed.txt && printf '1 1\n1 1\n' >one.txt && : >none.txt
for command in interpolate "fit --tolerance 1"; do
  run 2 $command nan.txt && says err "malformed_input: nan.txt:2: not a number: 'nan'"
  run 2 $command mixed.txt && says err "mixed.txt:4: 3 coordinates, and 2 before"
  run 2 $command one.txt && says err "one.txt: "
  run 2 $command none.txt && says err "none.txt: wrong_number_of_points"
  run 2 $command missing.txt && says err "missing.txt: No such file or directory"
  run 2 $command five.txt -o no.pdf && holds [ ! -e no.pdf ]
done
awk 'BEGIN { srand(1); for (i = 0; i < 3000; ++i) print int(1e9 * rand()) "/" 1 + int(1e9 * rand()), i }' >long.txt
run 2 interpolate long.txt --max-work 1000000 && says err "long.txt: work_limit" "--max-work N allows N steps"
