# Cost is bounded: small files with huge numbers, high degrees and odd tolerances end soon, with an
# answer or a refusal that says how to allow more.
. "$(dirname "$0")/functions.sh"

# Two bilinear surfaces with one edge, of which the rest is given.
bilinear() { printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 5e300 -7e4000\n3 1 8e-4000\n%s\n' "$1"; }
{ bilinear $'6e4000 0 -4e4000\n-8e-278 0 0'; bilinear $'-1 -9e-4000 -2e-300\n-9e-986 0 -9e-300'; } >huge.g2
bounded 60 0 verify --surfaces huge.g2
says out "0 v0 - 1 v0: G0 (crease)" "1 creases"
for tolerance in 1e308,1e308 1e308,5e-324 5e-324,1e308 0,0 0,1e-300; do
  bounded 60 0 verify --surfaces --within $tolerance huge.g2
  bounded 60 0 verify --surfaces --allow-uncovered --within $tolerance "$teapot"
done
run 2 verify --surfaces --max-work 1 huge.g2
says err "huge.g2: work_limit: patch 0 v0 - patch 1 v0" "more than 1 steps of work" "--max-work N"
holds test ! -s out
run 2 verify --surfaces --max-work 1000 --json huge.g2
holds test ! -s out

# B-splines of high order with as many inner knots.
high_order() { # ORDER
  awk -v k="$1" 'BEGIN {
    print "100 1 0 0\n2 0\n" 2 * k, k
    for (i = 0; i < k; ++i) printf "0 "
    for (i = 1; i <= k; ++i) printf "%d ", i
    for (i = 0; i < k; ++i) printf "%d ", k + 1
    print ""
    for (i = 0; i < 2 * k; ++i) print (i * 37) % 101, (i * 53) % 97
  }'
}
high_order 64 >order64.g2
bounded 30 0 verify --require G3 order64.g2
says out "64 joins"
high_order 128 >order128.g2
ulimit -S -t 5 # for each program; it takes less than half a second
bounded 120 0 verify --require G3 order128.g2
ulimit -S -t "$(ulimit -H -t)"
says out "128 joins"
answers 0 '"joins":64,"G32":64' verify --max-order 32 --json --require C32 order64.g2
run 2 verify --max-work 1000000 order64.g2
says err "order64.g2: work_limit" "--max-work N"

# This function of awk makes a fraction: random digits over as many.
fraction='
  function fraction(digits,   text, j) {
    for (j = 0; j < 2 * digits; ++j) text = text (j == digits ? "/" : "") 1 + int(9 * rand())
    return text
  }
'
# Orders up to 32 of curves with long fractions: one polynomial on both sides of a knot, so that all
# orders hold.
long_fractions() { # DIGITS
  awk -v digits="$1" "$fraction"'BEGIN {
    srand(7)
    print "100 1 0 0\n2 0\n35 34"
    for (i = 0; i < 34; ++i) printf "0 "
    printf "1 "
    for (i = 0; i < 34; ++i) printf "2 "
    print ""
    for (i = 0; i < 70; ++i) printf "%s%s", fraction(digits), i % 2 ? "\n" : " "
  }'
}
long_fractions 400 >fractions.g2
bounded 60 0 verify --max-order 32 --require C32 fractions.g2
run 2 verify --max-order 32 --max-work 100000 fractions.g2
says err "fractions.g2: " "--max-work N"

# The parabola (12 x t, 6 w t^2) until t = 0, and (12 x (t + t^2), 6 w (t + t^2)^2) from there on:
# the forms of G32 have the degree 64. Digits in pairs, so that multiplication by up to 24 has no
# carries.
parabola() { # PAIRS_OF_DIGITS
  awk -v pairs="$1" '
    function times(factor, digits, below,   number, i) {
      for (i = 1; i <= pairs; ++i) number = number sprintf("%02d", factor * substr(digits, i, 1))
      return number "/" below
    }
    BEGIN {
      srand(7)
      for (i = 0; i < pairs; ++i) {
        x = x 1 + int(4 * rand()); w = w 1 + int(4 * rand())
        below_x = below_x 11 + int(88 * rand()); below_w = below_w 11 + int(88 * rand())
      }
      print "100 1 0 0\n2 0\n3 3\n-1 -1 -1 0 0 0"
      print "-" times(12, x, below_x), times(6, w, below_w), "-" times(6, x, below_x), "0 0 0"
      print "100 1 0 0\n2 0\n5 5\n0 0 0 0 0 1 1 1 1 1\n0 0", times(3, x, below_x), "0"
      print times(8, x, below_x), times(1, w, below_w), times(15, x, below_x), times(6, w, below_w)
      print times(24, x, below_x), times(24, w, below_w)
    }'
}
parabola 20 >parabola.g2
bounded 60 0 verify --max-order 32 --require G32 parabola.g2
says out "C1 G32 F2"
run 2 verify --max-order 32 --max-work 100000 parabola.g2
says err "join 0 -> 1: work_limit" "--max-work N"
parabola 1000 >longer.g2
bounded 60 2 verify --max-order 32 longer.g2
says err "join 0 -> 1: work_limit" "--max-work N"

# Constructions with long numbers.
random_curve() { # ORDER DIGITS SEED
  awk -v k="$1" -v digits="$2" -v seed="$3" "$fraction"'BEGIN {
    srand(seed)
    print "100 1 0 0\n2 0\n" k, k
    for (i = 0; i < 2 * k; ++i) printf "%d ", (i >= k)
    print ""
    for (i = 0; i < 2 * k; ++i) printf "%s%s", fraction(digits), i % 2 ? "\n" : " "
  }'
}
random_curve 128 2 1 >short.g2
bounded 60 0 extend short.g2 --order curvature -o extended.g2
run 2 extend short.g2 --order curvature --max-work 1000 -o none.g2
says err "short.g2: work_limit: extend" "--max-work N"
random_curve 128 2000 1 >long.g2
bounded 60 2 extend long.g2 --order curvature -o none.g2
random_curve 4 3 1 >left.g2
random_curve 4 3 2 >right.g2
bounded 60 0 blend left.g2 right.g2
run 2 blend left.g2 right.g2 --max-work 1000
says err "left.g2: work_limit" "--max-work N"
random_curve 4 2000 1 >long_left.g2
random_curve 4 2000 2 >long_right.g2
bounded 60 2 blend long_left.g2 long_right.g2 --max-work 4000000000 -o none.g2
says err "work_limit" "--max-work N"
bounded 60 2 blend long_left.g2 long_right.g2 --order 3 --max-work 100000000 -o none.g2
says err "work_limit: blend: more than 100000000 steps" "--max-work N"
refused "--max-work: not with --corner" blend left.g2 --corner 0 --distance 1 --max-work 1000
run 2 blend left.g2 right.g2 --order 3 --max-work 10000
says err "left.g2: work_limit" "--max-work N"
run 2 extend short.g2 --order curvature --toward 3,4 --max-work 1000000 -o none.g2
says err "short.g2: work_limit: extend: more than 1000000 steps" "--max-work N"
bounded 60 2 extend short.g2 --order curvature --toward 3,4 -o none.g2
run 0 extend left.g2 --order curvature --toward 3,4 --max-work 1000000 -o extended.g2
random_curve 16 3 1 >sixteen.g2
run 2 extend sixteen.g2 --order curvature --toward 3,4 --max-work 12500000 -o none.g2 # the equations and their solution count
run 0 extend sixteen.g2 --order curvature --toward 3,4 --max-work 20000000 -o extended.g2
for y in 0 1 -1; do cubic "0 $y 0"$'\n'"1 $y 0"$'\n'"2 $y 0"$'\n'"3 $y 0" >"line$y.g2"; done
run 0 connect line0.g2 line1.g2 line-1.g2 -o ribbon.g2
run 2 connect line0.g2 line1.g2 line-1.g2 --max-work 100 -o none.g2
says err "line0.g2, ...: work_limit: connect_g1" "--max-work N"
run 2 verify left.g2 right.g2 --within 1,1,1 --max-work 100
says err "join 0 -> 1: work_limit: " "--max-work N"
holds test ! -e none.g2

# Orders up to 32 of rational curves with long fractions: their jets count.
rational() { # DIGITS [GAP]
  awk -v digits="$1" -v gap="${2:-0}" "$fraction"'
    BEGIN {
      srand(3)
      for (i = 0; i <= 21; ++i) point[i] = fraction(digits) " " fraction(digits) " " fraction(digits)
      for (first = 0; first <= 10 + gap; first += 10 + gap) {
        print "100 1 0 0\n2 1\n11 11\n0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 1 1 1 1 1 1 1"
        for (i = 0; i <= 10; ++i) print point[first + i]
      }
    }'
}
rational 4 >rational.g2
run 0 verify --max-order 32 rational.g2
rational 1000 >rational.g2
bounded 10 2 verify --max-order 32 --max-work 1000000 rational.g2
says err "work_limit" "more than 1000000 steps" "--max-work N"
rational 200 1 >gap.g2 # the quotients cost most, and there is nothing to decide
bounded 30 2 verify --max-order 32 --max-work 100000000 gap.g2
says err "gap.g2: work_limit: derivatives of a spline: more than 100000000 steps" "--max-work N"

# The default takes some seconds also where the numbers are short: two rational patches of the
# degrees 39 and 2 with one-digit numbers that meet with one tangent plane, so that the zeros of a
# polynomial of degree 234 are separated.
awk 'BEGIN {
  srand(5)
  for (i = 0; i < 40; ++i)
    for (k = 0; k < 4; ++k) {
      edge[i, k] = int(9 * rand()) - 4 + (k == 3) * 7
      near[i, k] = k == 3 ? edge[i, k] : int(9 * rand()) - 4
      far[1, i, k] = int(9 * rand()) - 4 + (k == 3) * 7
      far[2, i, k] = int(9 * rand()) - 4 + (k == 3) * 7
    }
  for (side = 1; side <= 2; ++side) {
    print "200 1 0 0\n3 1\n40 40"
    for (i = 0; i < 80; ++i) printf "%d ", (i >= 40)
    print "\n3 3\n0 0 0 1 1 1"
    for (j = 0; j < 3; ++j)
      for (i = 0; i < 40; ++i) {
        for (k = 0; k < 4; ++k) {
          row = side == 1 ? j : 2 - j # from far to the edge
          x = row == 0 ? far[side, i, k] : row == 2 ? edge[i, k] : side == 1 ? near[i, k] : 2 * edge[i, k] - near[i, k]
          printf "%d ", x
        }
        print ""
      }
  }
}' >rational_patches.g2
ulimit -S -t 10 # for each program; it takes about three seconds, and took thirteen
bounded 120 2 verify --surfaces rational_patches.g2
ulimit -S -t "$(ulimit -H -t)"
says err "patch 0 v1 - patch 1 v0: edge_continuity: more than 4000000000 steps" "--max-work N"

# Triangles in exact numbers.
awk "$fraction"'BEGIN {
  srand(9)
  print "200 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n3 3\n0 0 0 1 1 1"
  for (i = 0; i < 27; ++i) printf "%s%s", fraction(2000), i % 3 == 2 ? "\n" : " "
}' >long_patch.g2
run 2 tessellate --kernel exact --max-work 1000000 long_patch.g2 -o none.off
says err "work_limit: tessellate: more than 1000000 steps" "--max-work"
bounded 60 2 tessellate --kernel exact --grid 512 long_patch.g2 -o none.off
run 2 tessellate --max-work 1 long_patch.g2 -o patch.off && says err "--max-work: only with --kernel exact"
run 0 tessellate long_patch.g2 -o patch.off
run 0 tessellate --kernel exact --grid 4 long_patch.g2 -o patch.off
awk 'BEGIN {
  srand(9)
  print "200 1 0 0\n3 0\n128 128"
  for (i = 0; i < 256; ++i) printf "%d ", (i >= 128)
  print "\n2 2\n0 0 1 1"
  for (i = 0; i < 256; ++i) printf "%d/%d %d/%d %d/%d\n", 999 * rand(), 1 + 998 * rand(), 999 * rand(), 1 + 998 * rand(), 999 * rand(), 1 + 998 * rand()
}' >high_patch.g2
bounded 60 2 tessellate --kernel exact --tolerance 1 high_patch.g2 -o none.off
says err "work_limit: tessellate: more than 4000000000 steps"
run 2 tessellate --kernel exact --max-work 10000000 --grid 64 high_patch.g2 -o none.off
run 2 tessellate --kernel exact --max-work 4100000 --grid 4 high_patch.g2 -o none.off # weights, sums and quotients count
run 0 tessellate --kernel exact --max-work 5000000 --grid 4 high_patch.g2 -o patch.off
holds test ! -e none.off

# The option.
for word in 0 -1 x 1e9 1.5 "" 99999999999999999999999; do
  refused "--max-work: '$word'" verify --max-work "$word" "$S"
  refused "--max-work: '$word'" blend left.g2 right.g2 --max-work "$word"
done
run 0 verify --max-work 18446744073709551615 "$S"
run 0 verify --surfaces --allow-uncovered --max-work 100000000 "$teapot"
