#!/usr/bin/env bash
# verify --jsonl: one record for each file, whatever files do, and merge.
. "$(dirname "$0")/functions.sh"

kink='<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L20 0.5"/></svg>'
smooth='<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L20 0"/></svg>'
for i in 1 2 3 4 5 6; do printf '%s' "$smooth" >"smooth $i.svg" && printf '%s' "$kink" >"kink$i.svg"; done
printf '%s' "$kink" >-dash.svg
printf 'no drawing' >bad.g2
mkfifo pipe.g2
odd=$'odd\001"\\name.svg' && printf '%s' "$smooth" >"$odd"
ls -- *.svg >list
{
  printf '%s\r\n' "$S"
  printf '\nmissing.g2\nbad.g2\nkink1.svg\n'
} >>list
files=$(($(grep -c . list) - 1))

run 2 verify --jsonl list --require G1 -o all.jsonl
says out "$files files: 7 with exit code 0, 8 with 1, 2 without an answer; 0 had a record before"
holds [ "$(wc -l <all.jsonl)" -eq "$files" ]
says all.jsonl '{"file":"missing.g2","exit_code":2,"error":{"code":"cannot_read_file","message":"missing.g2: No such file' \
  '{"file":"bad.g2","exit_code":2,"error":{"code":"malformed_input","message":"bad.g2:1: ' \
  '{"file":"kink1.svg","exit_code":1,"claims":{"given":1,"decided":1,"not_met":1,"undecided":0,"not_covered":0},"report":{"joins":[' \
  '{"file":"-dash.svg","exit_code":1,' '{"file":"odd\u0001\"\\name.svg","exit_code":0,' '{"file":"smooth 6.svg","exit_code":0,'
if command -v python3 >/dev/null; then holds python3 -c 'import json, sys
for line in open("all.jsonl"): json.loads(line)'; fi
run 1 verify kink2.svg --require G1 --json
tr -d '\n' <out >report && holds grep -qF "\"report\":$(cat report)}" all.jsonl

# it is the same on one core, and to standard output, from standard input
run 2 verify --jsonl list --require G1 -o one.jsonl --jobs 1
sort all.jsonl >all.sorted && sort one.jsonl >one.sorted && holds cmp all.sorted one.sorted
checks=$((checks + 1))
"$program" verify --jsonl - --require G1 <list >piped.jsonl 2>err
sort piped.jsonl | cmp -s - all.sorted || holds false
says err "$files files:"

# a run goes on where it was interrupted, also in the middle of a line
for lines in 0 3 "$((files - 1))"; do
  head -n "$lines" all.jsonl >part.jsonl
  [ "$lines" -eq 0 ] || sed -n "$((lines + 1))p" all.jsonl | head -c 40 >>part.jsonl
  run 2 verify --jsonl list --require G1 -o part.jsonl
  says out "$lines had a record before"
  sort part.jsonl | cmp -s - all.sorted || holds false
done
run 2 verify --jsonl list --require G1 -o part.jsonl && says out "$files had a record before"
grep -v '"exit_code":2' all.jsonl >part.jsonl && grep -v '^missing\|^bad' list >good
run 1 verify --jsonl good --require G1 -o part.jsonl
echo 'kink' >>part.jsonl && run 2 verify --jsonl list -o part.jsonl && says err "part.jsonl:$((files - 1)): no record"

# killed in the middle of the work
for i in $(seq 200); do cp kink1.svg "copy$i.svg" && echo "copy$i.svg"; done >copies
"$program" verify --jsonl copies -o killed.jsonl >/dev/null 2>&1 &
while [ ! -s killed.jsonl ]; do sleep 0.01; done
kill -9 $! && wait $! 2>/dev/null
holds [ "$(wc -l <killed.jsonl)" -lt 200 ]
run 0 verify --jsonl copies -o killed.jsonl
run 0 verify --jsonl copies -o whole.jsonl
holds [ "$(sort killed.jsonl | cksum)" = "$(sort whole.jsonl | cksum)" ]

# limits
echo pipe.g2 >slow && echo kink1.svg >>slow
run 2 verify --jsonl slow --time-limit 0.5 -o slow.jsonl
says slow.jsonl '{"file":"pipe.g2","exit_code":2,"error":{"code":"time_limit","message":"not decided within 5 seconds, 10 times the limit of --time-limit' '{"file":"kink1.svg"'
echo kink1.svg >soon && run 2 verify --jsonl soon --time-limit 0.0005 -o soon.jsonl # shorter than the program takes to begin
says soon.jsonl '"code":"time_limit","message":"not decided within 0.00'
echo "$S" >large
run 2 verify --jsonl large --memory-limit 16 -o large.jsonl && holds [ "$(wc -l <large.jsonl)" -eq 1 ]

# two runs do not write one file
echo pipe.g2 >slow
"$program" verify --jsonl slow --time-limit 5 -o locked.jsonl >/dev/null 2>&1 &
while [ ! -e locked.jsonl ]; do sleep 0.01; done
sleep 0.2
run 2 verify --jsonl list -o locked.jsonl && says err 'another process writes records there'
kill $! && wait $! 2>/dev/null

# merge
run 2 merge all.jsonl
says out "$files files: 7 with exit code 0, 8 with 1, 2 without an answer" '"kink1.svg": 1 not met, 0 open, of 1' '"bad.g2": no answer' \
  'given 41, decided 41, not met 19, undecided 0, not covered 0'
run 2 merge all.jsonl one.jsonl --json
says out "{\"files\":$files,\"exit_codes\":{\"0\":7,\"1\":8,\"2\":2},\"cut_off\":0," '"claims":{"given":41,"decided":41,"not_met":19,"undecided":0,"not_covered":0}'
grep '"exit_code":0' all.jsonl >good.jsonl && run 0 merge good.jsonl
grep -v '"exit_code":2' all.jsonl >good.jsonl && run 1 merge good.jsonl
head -c -1 good.jsonl >cut.jsonl && run 2 merge cut.jsonl && says err 'cut.jsonl: the last line is cut off' && says out "$((files - 3)) files"
sed 's/"not_met":1,/"not_met":0,/' good.jsonl >other.jsonl && run 2 merge good.jsonl other.jsonl && says err 'another record of the file'
echo '{"file":"x","exit_code":7}' >bad.jsonl && run 2 merge bad.jsonl && says err 'bad.jsonl:1: no record'
: >empty.jsonl && run 2 merge empty.jsonl && says err 'there is no record'
run 2 merge && run 2 merge missing.jsonl

# refused
run 2 verify --jsonl list "$S" && says err 'the files are those of the list'
run 2 verify --jsonl missing && says err missing
run 2 verify --jsonl empty.jsonl && says err 'names no file'
run 2 verify --jsonl list --json && says err --json
run 2 verify "$S" -o x && says err 'only with --jsonl'
run 2 verify --jsonl list --memory-limit 1 && says err --memory-limit
run 2 verify --jsonl list -o missing/x.jsonl && says err missing/x.jsonl
run 2 verify --jsonl list -o /dev/full && says err /dev/full
