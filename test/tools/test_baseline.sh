#!/usr/bin/env bash
# verify --baseline: only what is new is reported, in every format, and only that makes the exit
# code 1.
. "$(dirname "$0")/functions.sh"

drawing() { # paths...
  printf '<svg xmlns="http://www.w3.org/2000/svg">\n'
  printf '<path id="%s" d="%s"/>\n' "$@"
  printf '</svg>\n'
}
kink='M0 0 L10 0 L20 0.5' smooth='M0 0 L10 0 L20 0'
drawing a "$kink" b "$smooth" >x.svg
run 1 verify x.svg --require G1 --format sarif && mv out base.sarif
lacks base.sarif baselineState

# what is known
run 0 verify x.svg --require G1 --baseline base.sarif
says out '1 of them known, from the baseline' 'nothing new is not G1'
lacks out kink:
run 0 verify x.svg --require G1 --baseline base.sarif --json
says out '{"findings":[],' '"not_met":0,"known":1,' '"met":true'
run 0 verify x.svg --require G1 --baseline base.sarif --format sarif && says out '"results":[]'
run 0 verify x.svg --require G1 --baseline base.sarif --format junit && lacks out '<failure' && says out 'failures="0"'
run 1 verify x.svg --require G1 && lacks out baseline

# where all is known nothing was decided
drawing a "$kink" >known.svg && run 1 verify known.svg --require G1 --format sarif && mv out known.sarif
run 0 verify known.svg --require G1 --baseline known.sarif --json && says out '"decided":0,"not_met":0,"known":1,' '"met":null'
run 0 verify known.svg --require G1 --baseline known.sarif --format sarif && says out '"decided":0,' '"met":null'
run 1 verify known.svg --require G1 --baseline base.sarif --json && says out '"met":false'

# what is new: another path, and one more of the same kind in a path with the same name
drawing a "$kink" b "$kink" >x.svg
run 1 verify x.svg --require G1 --baseline base.sarif
says out 'x.svg:3: error: path "b"' '[kink]' '1 of them known' '1 of them new, and not G1'
lacks out 'path "a"'
run 1 verify x.svg --require G1 --baseline base.sarif --json
says out '"rule":"kink","level":"error","file":"x.svg","line":3' '"not_met":1,"known":1' '"met":false'
run 1 verify x.svg --require G1 --baseline base.sarif --format sarif
holds [ "$(grep -c '"baselineState":"new"' out)" -eq 1 ]
says out 'filePlace/v2' 'fileDefect/v2'
mv out more.sarif
fingerprint=$(grep -o 'filePlace/v2":"[^"]*' more.sarif)
run 1 verify x.svg --require G1 --format sarif && says out "$fingerprint"
run 1 verify x.svg --require G1 --baseline base.sarif --format junit && says out 'failures="1"'

# a second defect at a place of the same name is new
one='<path id="a" d="M0 0 L10 0 L20 0.5"/>'
printf '<svg xmlns="http://www.w3.org/2000/svg">%s</svg>' "$one" >twice.svg
run 1 verify twice.svg --require G1 --format sarif && mv out twice.sarif
printf '<svg xmlns="http://www.w3.org/2000/svg">%s%s</svg>' "$one" "$one" >twice.svg
run 1 verify twice.svg --require G1 --baseline twice.sarif && says out '1 of them known' '1 of them new'

# what is open, and allowed or not, is known as well
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L20 0"/><use href="#a"/></svg>' >use.svg
run 1 verify use.svg --require G1 --format sarif && mv out use.sarif
run 0 verify use.svg --require G1 --baseline use.sarif && says out '1 of them known'
run 1 verify use.svg --require G1 --baseline base.sarif && says out 'not covered: 1 element'

# chains, fonts, models
run 1 verify --closed "$S" --require G2 --format sarif && mv out s.sarif
run 0 verify --closed "$S" --require G2 --baseline s.sarif && says out '24 of them known'
run 0 verify --closed "$S" --require G2 --baseline s.sarif --json && says out '"findings":[]' '"joins":28'
run 1 verify --closed "$S" --require G3 --baseline base.sarif
run 1 verify --surfaces "$teapot" --require G1 --format sarif && mv out teapot.sarif
run 0 verify --surfaces "$teapot" --require G1 --baseline teapot.sarif
run 0 verify --surfaces "$teapot" --require G1 --baseline teapot.sarif --json && says out '"findings":[]'

# a run without anything new, of which nothing else is left, is not empty
drawing a "$kink" >one.svg
run 1 verify one.svg --require G1 --format sarif && mv out one.sarif
run 0 verify one.svg --require G1 --baseline one.sarif

# bad baselines
run 2 verify x.svg --baseline missing.sarif && says err missing.sarif
for text in '' '{' '{}' '[]' '{"runs":[{"results":[{"partialFingerprints":' 'x' '{"runs" [] }' '{"runs":[}]'; do
  printf '%s' "$text" >bad.sarif
  run 2 verify x.svg --baseline bad.sarif && says err 'bad.sarif: no report in the format SARIF'
done
head -c -20 base.sarif >bad.sarif && run 2 verify x.svg --baseline bad.sarif
# reports of older versions, and of others
sed 's/"filePlace\/v2":\("[^"]*"\),"fileDefect\/v2":"[^"]*"/"ruleFilePlace\/v1":\1/' base.sarif >old.sarif && says old.sarif '"ruleFilePlace/v1"'
run 2 verify x.svg --require G1 --baseline old.sarif && says err 'old.sarif: a report of an older version, whose fingerprints hold lines of files; write it again with --format sarif'
sed 's/"ruleId":"kink"/"ruleId":"other"/' base.sarif >other.sarif && run 1 verify x.svg --require G1 --baseline other.sarif && says out '2 of them new'
# a measure without an upper bound, or without any, allows everything of its rule
sed 's/"bounds":\[\([^,]*\),[^]]*\]/"bounds":[\1,null]/' base.sarif >open.sarif && run 1 verify x.svg --require G1 --baseline open.sarif && says out '1 of them known'
sed 's/"bounds":\[[^]]*\]/"bounds":[0,0.001]/' base.sarif >small.sarif && run 1 verify x.svg --require G1 --baseline small.sarif && says out '2 of them new'
sed 's/,"measure":{[^}]*}//' base.sarif >none.sarif && run 1 verify x.svg --require G1 --baseline none.sarif && says out '1 of them known'
printf '%s' '{"runs":[{"results":[{"message":{"text":"\"ruleFilePlace/v1\":\"0:1\" ]}"}}, 1, null, {"partialFingerprints":3}]}, 7]}' >odd.sarif
run 1 verify x.svg --require G1 --baseline odd.sarif
run 2 verify "$S" --closed --baseline base.sarif --certificate c && says err --baseline
