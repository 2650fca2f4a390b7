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
  '{"file":"kink1.svg","exit_code":1,"claims":{"given":1,"decided":1,"not_met":1,"undecided":0,"not_covered":0},"asked":["--require=G1"],"version":"' \
  "\"size\":$(wc -c <kink1.svg),\"sha256\":\"$(sha256sum <kink1.svg | head -c 64)\",\"report\":{\"joins\":[" '"limits":{"seconds":60,"mebibytes":4096},"asked":["--require=G1"],' '"size":null,"sha256":null}' \
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
  answers 2 "$lines had a record before" verify --jsonl list --require G1 -o part.jsonl
  sort part.jsonl | cmp -s - all.sorted || holds false
done
run 2 verify --jsonl list --require G1 -o part.jsonl && says out "$files had a record before"
grep -v '"exit_code":2' all.jsonl >part.jsonl && grep -v '^missing\|^bad' list >good
run 1 verify --jsonl good --require G1 -o part.jsonl

# lines that are no records are told, left out, and asked again: a text, half a record, bytes of
# anything, half a record and another one
for line in 2 5; do
  for rubbish in 'kink' "$(sed -n "${line}p" all.jsonl | head -c 60)" "$(sed -n "${line}p" all.jsonl | tail -c 60)" \
    "$(sed -n "${line}p" all.jsonl | head -c 60)$(sed -n 1p all.jsonl)" $'\x01\xff{"file":' "$(sed -n "${line}p" all.jsonl | tr '{' '\001')" ''; do
    { head -n $((line - 1)) all.jsonl && printf '%s\n' "$rubbish" && tail -n +$((line + 1)) all.jsonl; } >part.jsonl
    run 2 merge part.jsonl --json && says out "{\"files\":$((files - 1))," '"cut_off":0,"corrupt":1,' && says err "part.jsonl:$line: no record, as verify --jsonl writes them; it is left out"
    run 2 verify --jsonl list --require G1 -o part.jsonl
    says out "$((files - 1)) had a record before" && says err "part.jsonl:$line: no record, as verify --jsonl writes them"
    sort part.jsonl | cmp -s - all.sorted || holds false
    run 2 merge part.jsonl --json && says out "{\"files\":$files," '"corrupt":0,'
  done
done
grep '"exit_code":0' all.jsonl >part.jsonl && echo kink >>part.jsonl && run 2 merge part.jsonl && says out '7 files'
for i in $(seq 15); do echo "$i"; done >>part.jsonl && run 2 merge part.jsonl && says err 'part.jsonl: 6 more lines are no records'
{ cat all.jsonl && echo kink && head -c 20 all.jsonl; } >part.jsonl && run 2 verify --jsonl list --require G1 -o part.jsonl && says out "$files had a record before"
cmp -s part.jsonl all.jsonl || holds false
printf '{\n "name": "something else"\n}\n' >package.json && cp package.json kept.json
run 2 verify --jsonl list -o package.json && says err 'package.json:1: no record' && holds cmp package.json kept.json

# a record answers the question that was asked, of the same version about the same content, and no
# other one
ask() { # KNOWN OPTIONS...: so many records answer
  local known=$1
  shift
  cp asked.jsonl again.jsonl && checks=$((checks + 1))
  "$program" verify --jsonl few -o again.jsonl "$@" >out 2>err
  says out "; $known had a record before"
}
cp kink1.svg changing.svg && printf 'kink1.svg\nsmooth 1.svg\nchanging.svg\nmissing.g2\n' >few
"$program" verify --jsonl few --require G1 --within 0.50,1deg,5% -o asked.jsonl >out 2>err # no answer of drawings
ask 4 --require G1 --within 1/2,1.0deg,5%
ask 0 --require G1 --within 0.5,1deg
rm asked.jsonl && run 2 verify --jsonl few --require G1 --kink-angle 5 -o asked.jsonl && lacks asked.jsonl kink-angle
says asked.jsonl '"asked":["--require=G1"]'
ask 4 --require G1
ask 4 --require G1 --kink-angle 5.0 --max-order 3 --jobs 1
ask 0 --require G3
ask 0 --require C1
ask 0
ask 0 --require G1 --kink-angle 4
ask 0 --require G1 --allow-uncovered
ask 4 --require G1 --time-limit 50
ask 3 --require G1 --time-limit 70
ask 3 --require G1 --memory-limit 5000
printf '%s' "$smooth" >changing.svg
ask 3 --require G1 && says again.jsonl '{"file":"changing.svg","exit_code":0'
run 2 merge again.jsonl && says out '4 files: 2 with exit code 0, 1 with 1, 1 without an answer' 'asked: --require=G1, version ' # the later record
run 2 merge asked.jsonl again.jsonl && says err 'another record of the file "changing.svg": the file has changed, its sha256 is ' ' (asked.jsonl:' ' and "'
cp "smooth 1.svg" missing.g2 && ask 2 --require G1 && rm missing.g2
printf '%s' "$kink" >changing.svg
sed -i 's/"version":"[^"]*"/"version":"0.1"/' asked.jsonl && ask 0 --require G1 && run 2 merge again.jsonl && says out '4 files'
tail -n 4 again.jsonl >new.jsonl && run 2 merge asked.jsonl new.jsonl && says err ': they are of the versions 0.1 (asked.jsonl:'
sed -i 's/"asked":[^,]*,"version":"0.1",//' asked.jsonl && ask 0 --require G1 # as old versions have written them
run 2 merge asked.jsonl && says out '4 files' 'asked: a question that is not told'
run 2 merge asked.jsonl new.jsonl && says err 'asked were a question that is not told (asked.jsonl:'
run 1 verify --jsonl good --require C1 -o c1.jsonl && grep -v '"exit_code":2' all.jsonl >g1.jsonl
run 2 merge g1.jsonl c1.jsonl && says err 'asked were --require=G1 (g1.jsonl:' ') and --require=C1 (c1.jsonl:' 'add up each question for itself'
cat g1.jsonl c1.jsonl >both.jsonl && run 2 merge both.jsonl && says err 'another record of the file' '--require=G1 (both.jsonl:'
grep kink1 g1.jsonl >one.jsonl && grep kink2 c1.jsonl >other.jsonl && run 1 merge one.jsonl other.jsonl --json
says out '"questions":[{"asked":["--require=G1"],"version":"' '{"asked":["--require=C1"],"version":"'
printf 'kink1.svg\n' >few && rm asked.jsonl
"$program" verify kink1.svg --format sarif >base.sarif && run 0 verify --jsonl few --require G1 --baseline base.sarif -o asked.jsonl
cp base.sarif same.sarif && ask 1 --require G1 --baseline same.sarif
"$program" verify kink2.svg --format sarif >base.sarif && ask 0 --require G1 --baseline base.sarif
run 2 verify --jsonl few --baseline missing.sarif -o asked.jsonl && says err 'missing.sarif'

# a folder may hold anything, and is asked again
mkdir -p folder && echo folder >few && "$program" verify --jsonl few -o folder.jsonl >/dev/null 2>&1
run 2 verify --jsonl few -o folder.jsonl && says out '; 0 had a record before'

# the hash is that of sha256sum, whatever the length
for size in 0 1 55 56 63 64 65 119 120 65535 65536 65537 200000; do seq 100000 | head -c $size >size$size.g2 && echo size$size.g2; done >sizes
run 2 verify --jsonl sizes -o sizes.jsonl
while read -r file; do says sizes.jsonl "\"size\":$(wc -c <"$file"),\"sha256\":\"$(sha256sum <"$file" | head -c 64)\""; done <sizes

# names that are not UTF-8 have their own records
for name in $'n\xe8.svg' $'n\xe9.svg' $'n\xef\xbf\xbd.svg' 'n\ud83d\ude00.svg' $'n\xf0\x9f\x98\x80.svg'; do printf '%s' "$kink" >"$name" && printf '%s\n' "$name"; done >names
head -n 1 names >first && run 1 verify --jsonl first --require G1 -o names.jsonl
run 1 verify --jsonl names --require G1 -o names.jsonl
says out '5 files: 0 with exit code 0, 5 with 1, 0 without an answer; 1 had a record before'
says names.jsonl $'{"file":"n\xef\xbf\xbd.svg","name_bytes":"6ee82e737667","exit_code":1' $'{"file":"n\xef\xbf\xbd.svg","name_bytes":"6ee92e737667",' \
  $'{"file":"n\xef\xbf\xbd.svg","exit_code":1'
run 1 verify --jsonl names --require G1 -o names.jsonl && says out '5 had a record before'
run 1 merge names.jsonl && says out '5 files' $'"n\xef\xbf\xbd.svg" (bytes 6ee82e737667): 1 not met'
run 1 merge names.jsonl --json && says out '"name_bytes":"6ee92e737667","exit_code":1'
if command -v python3 >/dev/null; then # as other programs write the same record
  holds python3 -c 'import json
with open("python.jsonl", "w") as out:
  for line in open("names.jsonl"): print(json.dumps(json.loads(line), separators=(",", ":")), file=out)'
  run 1 verify --jsonl names --require G1 -o python.jsonl && says out '5 had a record before'
fi
sed 's/6ee8/6ez8/' names.jsonl >bad.jsonl && run 2 merge bad.jsonl && says err 'bad.jsonl:1: no record'

# killed in the middle of the work
for i in $(seq 100); do cp kink1.svg "copy$i.svg" && echo "copy$i.svg"; done >copies
"$program" verify --jsonl copies -o killed.jsonl >/dev/null 2>&1 &
while [ ! -s killed.jsonl ]; do sleep 0.01; done
kill -9 $! && wait $! 2>/dev/null
holds [ "$(wc -l <killed.jsonl)" -lt 100 ]
run 0 verify --jsonl copies -o killed.jsonl
run 0 verify --jsonl copies -o whole.jsonl
holds [ "$(sort killed.jsonl | cksum)" = "$(sort whole.jsonl | cksum)" ]

# limits
echo pipe.g2 >slow && echo kink1.svg >>slow
run 2 verify --jsonl slow --time-limit 0.2 -o slow.jsonl
says slow.jsonl '{"file":"pipe.g2","exit_code":2,"error":{"code":"time_limit","message":"not decided within 2 seconds, 10 times the limit of --time-limit' '{"file":"kink1.svg"'
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
says out "{\"files\":$files,\"exit_codes\":{\"0\":7,\"1\":8,\"2\":2},\"cut_off\":0,\"corrupt\":0," '"claims":{"given":41,"decided":41,"not_met":19,"undecided":0,"not_covered":0}'
grep '"exit_code":0' all.jsonl >good.jsonl && run 0 merge good.jsonl
grep -v '"exit_code":2' all.jsonl >good.jsonl && run 1 merge good.jsonl
head -c -1 good.jsonl >cut.jsonl && run 2 merge cut.jsonl && says err 'cut.jsonl: the last line is cut off' && says out "$((files - 3)) files"
sed 's/"not_met":1,/"not_met":0,/' good.jsonl >other.jsonl && run 2 merge good.jsonl other.jsonl && says err 'another record of the file'
echo '{"file":"x","exit_code":7}' >bad.jsonl && run 2 merge bad.jsonl && says err 'bad.jsonl:1: no record'
: >empty.jsonl && run 2 merge empty.jsonl && says err 'there is no record'
run 2 merge && run 2 merge missing.jsonl

# a road network
line='<geometry s="%d" x="%s" y="0" hdg="0" length="10"><line/></geometry>'
printf "<OpenDRIVE><road id=\"1\" length=\"20\"><planView>$line$line</planView></road></OpenDRIVE>" 0 0 10 10.5 >gap.xodr
echo gap.xodr >roads && run 1 verify --jsonl roads --gap 0.1 && says out '"met":false'

# refused
run 2 verify --jsonl list "$S" && says err 'the files are those of the list'
run 2 verify --jsonl missing && says err missing
run 2 verify --jsonl first --require G --output refused.jsonl && says err "G" && run 2 verify --jsonl first --within 1,x && says err "--within: item 2, 'x'"
run 2 verify --jsonl first --kink-angle x -o refused.jsonl && says refused.jsonl '"message":"--kink-angle: ' '"asked":["--kink-angle=x"]'
run 2 verify --jsonl empty.jsonl && says err 'names no file'
# names that end with a null character, as find -print0 writes them
printf '%s\0' kink1.svg missing.svg >null && run 2 verify --jsonl null -o null.jsonl && says null.jsonl '{"file":"kink1.svg"' '{"file":"missing.svg"' && lacks null.jsonl u0000
run 2 verify --jsonl list --json && says err --json
run 2 verify "$S" -o x && says err 'only with --jsonl'
run 2 verify --jsonl list --memory-limit 1 && says err --memory-limit
run 2 verify --jsonl list -o missing/x.jsonl && says err missing/x.jsonl
run 2 verify --jsonl list -o /dev/full && says err /dev/full
