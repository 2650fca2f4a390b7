#!/usr/bin/env bash
# verify --summary: only the counts and what fails. And the reports do not depend on how numbers are
# written.
. "$(dirname "$0")/functions.sh"

# A chain of so many cubics, from the pieces of a uniform B-spline in hundredths: every 20th time a
# third point is moved, so that there is a jump of curvature and a kink, and an end, so that there
# is a gap. Some domains have another length. The numbers are decimals, fractions, decimals of 30
# digits, or decimals with a few of the others in between.
cat >chain.awk <<'END'
function number(x, form) { # x hundredths
  ++count
  if (form ~ /^few/) form = count % 50 != 49 ? "decimal" : form == "few fractions" ? "fraction" : "long"
  if (form == "fraction") return x % 50 == 0 ? x / 50 "/2" : x "/100"
  if (form == "long") return x sprintf("%028de-30", 0)
  return sprintf("%s%d.%02d", x < 0 ? "-" : "", (x < 0 ? -x : x) / 100, (x < 0 ? -x : x) % 100)
}
BEGIN {
  for (i = 0; i < n + 3; ++i)
    for (c = 0; c < 3; ++c) {
      random = (69069 * random + 20261122) % 2147483648 # the same everywhere, unlike rand()
      d[i, c] = 6 * (int(random / 4096) % 200 - 100) + (c == 0 ? 600 * i : 0)
    }
  for (i = 0; i < n; ++i) {
    begin = number(i % 5 == 1 ? 30 : 0, form)
    end = number(i % 5 == 1 ? 70 : i % 5 == 2 ? 300 : 100, form)
    printf "100 1 0 0\n3 0\n4 4\n%s %s %s %s %s %s %s %s\n", begin, begin, begin, begin, end, end, end, end
    for (j = 0; j < 4; ++j)
      for (c = 0; c < 3; ++c) {
        a = d[i, c]; b = d[i + 1, c]; e = d[i + 2, c]; f = d[i + 3, c]
        x = j == 0 ? (a + 4 * b + e) / 6 : j == 1 ? (2 * b + e) / 3 : j == 2 ? (b + 2 * e) / 3 : (b + 4 * e + f) / 6
        if (c == 1 && (i % 20 == 3 && j == 2 || i % 20 == 7 && j == 3)) ++x
        printf "%s%s", number(x, form), c < 2 ? " " : "\n"
      }
  }
}
END
chain() { awk -v n="$1" -v form="$2" -f chain.awk; } # chain CURVES FORM

# The report is the same for all forms of numbers; 1500 curves are more than are decided at once.
chain 1500 decimal >decimal.g2
chain 120 decimal >short.g2
for options in "" "--closed --require G1" "--require G2 --summary" "--require C2 --max-order 5" "--json" "--json --summary --require F2" \
  "--within 1e-3,1e-3,1 --require G1" "--json --within 1,1,1 --closed"; do
  code=1
  [[ $options == *--require* ]] || code=0
  run $code verify short.g2 $options && mv out decimal.txt
  for form in fraction long "few fractions" "few long"; do
    chain 120 "$form" >form.g2
    run $code verify form.g2 $options && same out decimal.txt
  done
done
run 0 verify decimal.g2 && mv out decimal.txt
says decimal.txt "1499 joins: 75 gap, 75 G0, 75 G1, 1274 G2"
chain 1500 "few fractions" >form.g2 && run 0 verify form.g2 && same out decimal.txt
# one number only
sed '6s/^\([^ ]*\)\.\([0-9]*\) /\1\2\/100 /' short.g2 >one.g2
holds [ "$(diff short.g2 one.g2 | grep -c '^<')" -eq 1 ]
run 0 verify short.g2 --json && mv out decimal.json && run 0 verify one.g2 --json && same out decimal.json
for x in 0.5 1/2 +.50 500000000000000000000000000000e-30 5E-1 2/4; do
  { cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' && cubic "3 0 0"$'\n'"4 0 0"$'\n'"5 0 $x"$'\n'"7 1 0"; } >half.g2
  run 1 verify half.g2 --require G2 && cat out >>halves.txt && run 1 verify half.g2 --require G2 --json && cat out >>halves.txt
done
holds [ "$(sort halves.txt | uniq -c | grep -cv '^ *6 ')" -eq 0 ]

# shape parameters, in the units of the parameters
for x in 0.5 1/2 500000000000000000000000000000e-30; do
  { spline $'4 4\n0 0 0 0 .3 .3 .3 .3\n0 0 0\n1 0 0\n2 0 0\n3 0 0' && spline "4 4"$'\n'"0 0 0 0 $x $x $x $x"$'\n3 0 0\n4 0 0\n5.5 0 0\n7 1 0'; } >half.g2
  run 0 verify half.g2 --json && says out '"betas":["3/5","6/5"'
done
# zero has no sign: a straight line to the left and a parabola
for x in 1 1/1; do
  { curve $'2 0\n2 2\n0 0 1 1\n'"$x"$' 1\n0 0' && curve $'2 0\n3 3\n0 0 0 1 1 1\n0 0\n-1 -1\n-2 -3'; } >line.g2
  run 0 verify line.g2 && says out "curvature jumps from 0 to 0.1768"
done
# an angle of which few digits are known without the exact numbers
for x in -1e-160 "-1/1$(printf '%0160d' 0)"; do
  { curve $'2 0\n2 2\n0 0 1 1\n'"$x"$' 0\n0 0' && curve $'2 0\n2 2\n0 0 1 1\n0 0\n-9.928249e-162 9.883783e-162'; } >line.g2
  run 0 verify line.g2 && says out "corner of 135.1 degrees"
done

# The rows of --summary are those of the full table that fail.
run 1 verify decimal.g2 --require G2 && mv out full.txt
run 1 verify decimal.g2 --require G2 --summary && mv out summary.txt
{ head -n 1 full.txt && grep -E '^[0-9]+ -> [0-9]+ +(gap|C[0-9] G[01] )' full.txt && tail -n 2 full.txt; } >expected.txt
same summary.txt expected.txt
holds [ "$(wc -l <summary.txt)" -eq 228 ]
says summary.txt "1499 joins: 75 gap, 75 G0, 75 G1, 1274 G2" "225 of them not G2"
run 1 verify decimal.g2 --require G2 --json && mv out full.json
run 1 verify decimal.g2 --require G2 --json --summary && mv out summary.json
grep '"left"' summary.json | sed 's/[],]*$//' >rows.txt
grep -E '"g_order":(-1|0|1),"f_order".*"left"|"left".*"g_order":(-1|0|1),' full.json | sed 's/[],]*$//' >expected.txt
same rows.txt expected.txt
says summary.json '"summary":{"joins":1499,"gap":75,"G0":75,"G1":75,"G2":1274,' '"c_order":-1' '"required":"G2","met":false'
holds [ "$(grep -c '"left"' summary.json)" -eq 225 ]
if command -v python3 >/dev/null; then
  holds python3 -c 'import json
full, short = (json.load(open(name)) for name in ("full.json", "summary.json"))
assert short["joins"] == [j for j in full["joins"] if j["g_order"] < 2] and len(full["joins"]) == 1499
del full["joins"], short["joins"]
assert full == short'
fi
# A summary tells 1000 rows at most, those of the lowest order, and of one order the first ones.
run 1 verify decimal.g2 --require G3 && mv out full.txt
run 1 verify decimal.g2 --require G3 --summary && grep -E '^[0-9]+ -> ' out >rows.txt
says out "and 499 more, which a file or a pipe gets without --summary" "1499 of them not G3"
{ grep -E '^[0-9]+ -> [0-9]+ +(gap|C[0-9] G[01] )' full.txt && grep -E '^[0-9]+ -> [0-9]+ +C[0-9] G2 ' full.txt | head -n 775; } |
  sort -n >expected.txt
same rows.txt expected.txt
# whatever was decided of a join before it failed
for options in "--require G3" "--require G2 --max-order 2" "--require G1 --max-order 1" "--require G0 --max-order 0" \
  "--require C1" "--require F3" "--require G2 --kernel double" "--require C2 --closed"; do
  run 1 verify short.g2 $options && grep -E '^[0-9]+ -> ' out >full.txt
  run 1 verify short.g2 $options --summary && grep -E '^[0-9]+ -> ' out >rows.txt
  holds [ "$(grep -cvxFf full.txt rows.txt)" -eq 0 ]
  says out "$(wc -l <rows.txt) of them not"
done
# other requirements, and a tolerance that some of the kinks keep
run 1 verify decimal.g2 --require G0 --summary && holds [ "$(wc -l <out)" -eq 78 ]
run 1 verify short.g2 --require C1 && grep -cE '^[0-9]+ -> [0-9]+ +(gap|C0)' out >expected.txt
run 1 verify short.g2 --require C1 --summary && grep -c ' -> ' out >rows.txt && same rows.txt expected.txt
run 1 verify short.g2 --require G1 --within 1,1,1 --summary && says out "within the tolerance: order" "6 of them not G1 within the tolerance"
holds [ "$(grep -c ' -> ' out)" -eq 6 ] # the gaps
run 0 verify short.g2 --require G1 --within 1,1,1,1 --summary && lacks out "within the tolerance: order" " -> "

# Nothing fails: no table, and no head of one.
run 0 verify decimal.g2 --summary && holds [ "$(cat out)" = "1499 joins: 75 gap, 75 G0, 75 G1, 1274 G2" ]
run 0 verify decimal.g2 --summary --json && says out '{"joins":[],' '"G2":1274' && lacks out required '"met"' '"left"'
run 0 verify "$L" "$L" --max-order 0 --summary && lacks out join\ \ 
run 0 blend "$L" "$R" -o blend.g2
run 0 verify "$L" blend.g2 "$R" --require G2 --summary
holds [ "$(cat out)" = "$(printf '2 joins: 2 G2\nevery join is G2, proved exactly')" ]
run 0 verify "$L" blend.g2 "$R" --require G2 --summary --json && says out '{"joins":[],' '"joins":2' '"met":true'
run 2 verify "$L" --summary && says err "no join" && holds [ ! -s out ]
run 0 verify "$L" --summary --allow-empty && says out "no join, nothing was decided" && lacks out orders

# The join that closes the chain counts and fails as any other.
run 1 verify short.g2 --closed --require G2 --summary && mv out closed.txt
run 1 verify short.g2 --require G2 --summary && mv out open.txt
grep -vE '^119 -> 0 +gap' closed.txt | sed 's/^120 joins: 7 gap/119 joins: 6 gap/; s/^19 of them/18 of them/' >expected.txt
same open.txt expected.txt && says closed.txt "119 -> 0     gap" "120 joins: 7 gap" "19 of them not G2"
run 1 verify short.g2 --closed --require G2 --summary --json && says out '{"left":119,"right":0,' '"joins":120'
run 0 verify --closed "$S" --summary && holds [ "$(cat out)" = "28 joins: 12 G0, 12 G1, 4 G2; 1 with a zero tangent, 0 of them drawn as G1" ]
run 1 verify --closed "$S" --require G1 --summary && holds [ "$(grep -c ' -> ' out)" -eq 12 ]
run 1 verify --closed "$S" --require G1 --summary --kernel double && holds [ "$(grep -c ' -> ' out)" -eq 12 ]

# Several files are one chain, and standard input is one of them.
split_at() { head -n $((8 * $1)) "$2" >first.g2 && tail -n +$((8 * $1 + 1)) "$2" >second.g2; } # of eight lines are the curves
run 1 verify short.g2 --require G2 --summary && mv out whole.txt
for n in 1 23 24 119; do
  split_at $n short.g2
  run 1 verify first.g2 second.g2 --require G2 --summary && same out whole.txt
  piped first.g2 1 verify - second.g2 --require G2 --summary && same out whole.txt
  piped second.g2 1 verify first.g2 - --require G2 --summary && same out whole.txt
done
piped short.g2 1 verify - --require G2 --summary && same out whole.txt
piped short.g2 1 verify /dev/stdin --require G2 --summary && same out whole.txt
piped <(cat first.g2 second.g2) 1 verify - --require G2 --summary && same out whole.txt
piped decimal.g2 0 verify - && same out decimal.txt

# An error behind good curves: file, line and reason, and no half of a report.
wrong() { # wrong LINE REASON TEXT...: the text behind 1500 good curves, in one file, in a second one, on standard input
  local line=$1 reason=$2 options text
  shift 2
  text=$(printf '%s\n' "$@")
  { cat decimal.g2 && printf '%s\n' "$text"; } >wrong.g2
  printf '%s\n' "$text" >behind.g2
  for options in "" "--summary --require G2" "--json" "--summary --json"; do
    run 2 verify wrong.g2 $options && says err "wrong.g2:$((line + 12000)): $reason" && holds [ ! -s out ]
    run 2 verify decimal.g2 behind.g2 $options && says err "behind.g2:$line: $reason" && holds [ ! -s out ]
    piped wrong.g2 2 verify - $options && says err "standard input:$((line + 12000)): $reason" && holds [ ! -s out ]
    holds [ "$(wc -l <err)" -eq 1 ]
  done
}
good=$'100 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1'
wrong 6 "not a number: '1.2.3'" "$good" $'0 0 0\n0 1.2.3 0'
wrong 8 "zero denominator: '1/0'" "$good" $'0 0 0\n0 0 0\n0 0 0\n1 0 1/0'
wrong 5 "file ends after 1 of 4 control points" "$good" "0 0 0"
wrong 4 "the knots decrease at '-1/2'" $'100 1 0 0\n3 0\n4 4\n0 0 0 0 -1/2'
wrong 1 "200 (spline surface) where a curve (100) is expected" "200 1 0 0" # behind curves
wrong 1 "more than 4096 characters without a space" "$(printf '%05000d' 0)"
run 2 verify decimal.g2 missing.g2 --summary && says err "missing.g2" && holds [ ! -s out ]
run 2 verify decimal.g2 . --summary && says err "cannot_read_file" && holds [ ! -s out ]

# Models: only what fails.
flat "$flat_points" >flat.g2
run 1 verify --surfaces "$teapot" && mv out full.txt
run 1 verify --surfaces "$teapot" --summary && mv out summary.txt && tail -n 3 full.txt >expected.txt && same summary.txt expected.txt
run 1 verify --surfaces "$teapot" --require G1 && mv out full.txt
run 1 verify --surfaces "$teapot" --require G1 --summary && mv out summary.txt
{ grep -E ' - .*: G0' full.txt && tail -n 4 full.txt; } >expected.txt && same summary.txt expected.txt
run 0 verify --surfaces flat.g2 --summary --require G2 && holds [ "$(grep -cE 'boundary$' out)" -eq 0 ]
run 1 verify --surfaces "$teapot" --require G1 --json && mv out full.json
run 1 verify --surfaces "$teapot" --require G1 --json --summary && mv out summary.json
lacks summary.json boundary_edges collapsed_edges
if command -v python3 >/dev/null; then
  holds python3 -c 'import json
full, short = (json.load(open(name)) for name in ("full.json", "summary.json"))
assert short["edges"] == [e for e in full["edges"] if e["order"] == "G0"] and 0 < len(short["edges"]) < len(full["edges"])
assert short["summary"] == full["summary"] and short["met"] is False'
fi
# in fractions, in one, in long decimals, and in decimals that are too long for a common unit
fractions() { # the numbers of the lines behind the header, with a point, as fractions
  awk '{ for (i = 1; i <= NF; ++i) if ($i ~ /^-?[0-9]*\.[0-9]+$/) {
           s = $i; k = index(s, "."); f = substr(s, k + 1); h = substr(s, 1, k - 1) f; sub(/^-?0*/, h ~ /^-/ ? "-" : "", h)
           if (h == "" || h == "-") h = "0"
           $i = h "/1" sprintf("%0" length(f) "d", 0)
         } print }' "$1"
}
long() { awk '{ for (i = 1; i <= NF; ++i) if ($i ~ /^-?[0-9]*\.[0-9]*[1-9]$/) { s = $i; k = length(s) - index(s, "."); sub(/\./, "", s)
                                                  $i = s "00000000000000000000e-" (k + 20) } print }' "$1"; }
fractions "$teapot" >form.g2 && holds [ "$(grep -c / form.g2)" -gt 100 ]
for options in "" "--require G1 --summary" "--json" "--require G1 --json --summary"; do
  run 1 verify --surfaces "$teapot" $options && mv out decimal.txt
  run 1 verify --surfaces form.g2 $options && same out decimal.txt
  long "$teapot" >long.g2 && run 1 verify --surfaces long.g2 $options && same out decimal.txt
done
inner=$(flat "$flat_points" | sed 's/^0 0 0 1 1 2 2 2$/0 0 0 .1 .1 .3 .3 .3/')
printf '%s\n' "$inner" >decimal.g2 && printf '%s\n' "${inner//.1/1/10}" >form.g2
for options in "" --json; do
  run 0 verify --surfaces decimal.g2 $options && says out 1/10 && mv out decimal.txt && run 0 verify --surfaces form.g2 $options && same out decimal.txt
done
for x in 9007199254740993 9.1234567890123456 1e-17 1234567890123456789 1e300; do
  printf '200 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0\n1 0 0\n0 1 0\n%s 1 0\n' $x >far.g2
  run 0 verify --surfaces far.g2 --allow-empty && says out "4 boundary"
done
for knots in "0 0 1e-20 1e-20" "0 0 1e20 1e20" "9007199254740992 9007199254740992 9007199254740993 9007199254740993"; do
  printf '200 1 0 0\n3 0\n2 2\n%s\n2 2\n0 0 1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n' "$knots" >far.g2
  run 0 verify --surfaces far.g2 --allow-empty && says out "4 boundary"
done
{ cat "$teapot" && printf '200 1 0 0\n3 0\n2 2\n0 x 1 1\n'; } >wrong.g2
run 2 verify --surfaces wrong.g2 --summary && says err "wrong.g2:$(wc -l <wrong.g2): not a number: 'x'" && holds [ ! -s out ]
