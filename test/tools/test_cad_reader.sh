#!/usr/bin/env bash
# The process that reads CAD models: its limits, its bad ends, and what becomes of it when the
# program ends.
infinite=$(realpath "$(dirname "$0")")/cad/data/infinite.step # a coordinate is inf
. "$(dirname "$0")/functions.sh"

reader=$(dirname "$(realpath "$program")")/geometric_continuity_cad
made_by MAKE_CAD_MODELS models

# with SCRIPT ARGUMENTS...: the program with this script in place of its reader, which is called
# $reader in it
with() {
  mkdir -p fake && cp "$program" fake/geometric_continuity
  printf '#!/usr/bin/env bash\nreader=%q\n%s\n' "$reader" "$1" >fake/geometric_continuity_cad && chmod +x fake/geometric_continuity_cad
  shift
  fake/geometric_continuity "$@" >out 2>err </dev/null
}
# fails TEXT SCRIPT: the program says that it cannot read the file, for this reason, and writes
# nothing
fails() {
  with "$2" report models/fillet.step -o page.html --time-limit 5
  holds [ $? -eq 2 ] && says err "models/fillet.step: $1" && holds [ ! -s out ] && holds [ ! -e page.html ]
}

# the model is what the reader answers
run 0 verify models/fillet.step --json && mv out expected.json
with 'exec "$reader" "$@"' verify models/fillet.step --json
holds [ $? -eq 0 ] && holds cmp -s out expected.json

# crashes, no answer, half an answer, more than an answer, that of another build
fails 'the library that reads it crashes: the file is damaged' 'kill -SEGV $$'
fails 'the library that reads it crashes: the file is damaged' '"$reader" "$@"; kill -ABRT $$'
fails 'the library that reads it fails: the file is damaged' 'exit 0'
fails 'the library that reads it fails: the file is damaged' '"$reader" "$@" | head -c 64'
fails 'the program and its part that reads CAD models are not of one build' 'yes garbage | head -c 100000'
for bytes in 65 66 100 1000 5000; do
  fails 'damaged bytes of a model' '"$reader" "$@" | head -c '$bytes
done
fails 'damaged bytes of a model' '"$reader" "$@"; echo more'
# the time of the processor, with that of a process which it starts and of one that has ended
fails 'not read within 5 seconds of processor time, the limit of --time-limit' 'while :; do :; done'
fails 'not read within 5 seconds of processor time, the limit of --time-limit' '(ulimit -t 10; while :; do :; done); :'
fails 'not read within 5 seconds of processor time, the limit of --time-limit' 'exec >&-; while :; do (for ((i = 0; i < 100000; ++i)); do :; done); done'
# what waits is no limit but for ten times as long
with 'sleep 2; exec "$reader" "$@"' verify models/fillet.step --time-limit 1 --json
holds [ $? -eq 0 ] && holds cmp -s out expected.json
for script in 'exec sleep 1000' 'exec >&-; exec sleep 1000'; do
  with "$script" verify models/fillet.step --time-limit 0.3
  holds [ $? -eq 2 ] && says err 'models/fillet.step: not read within 3 seconds, 10 times the limit of --time-limit'
done
sed '/^Surfaces/{n;n;s/^7 /9 /}' models/prism.brep >crash.brep # an extrusion of a curve of no kind
run 2 verify crash.brep && says err "crash.brep: the library that reads it crashes: the file is damaged" && holds [ ! -s out ]

# the time, also of OpenCASCADE itself: it waits for a file into which nobody writes
mkfifo blocked.step
waits='exec "$reader" "${@/models\/fillet.step/blocked.step}"'
with "$waits" verify models/fillet.step --time-limit 0.5
holds [ $? -eq 2 ] && says err "models/fillet.step: not read within 5 seconds, 10 times the limit of --time-limit" && holds [ ! -s out ]
with "$waits" verify models/fillet.brep models/fillet.step --time-limit 1 --json
holds [ $? -eq 2 ] && holds [ ! -s out ]
run 2 verify models/fillet.step --time-limit 0.0001
for bad in 0 -1 x nan 1e9 ''; do run 2 verify models/fillet.step --time-limit="$bad" && says err "--time-limit"; done
run 2 verify $S --time-limit 1 && says err "--time-limit: only for CAD models"

# A number that is not finite is found before OpenCASCADE computes with it, which would not end.
run 1 verify "$infinite" --time-limit 20 && says out "a number that is not finite" "not covered: 1 face, a number that is not finite"

# the memory: what is asked for does not fit
with 'ulimit -v 60000; exec "$reader" "$@"' verify models/fillet.step
holds [ $? -eq 2 ] && says err "models/fillet.step: "

# the reader limits itself, to what the program allows for a file of this size
with 'printf "%s\n" "$@" >asked; exec "$reader" "$@"' verify models/fillet.step
allowed=$(sed -n 3p asked) && holds [ "$allowed" -gt 2147483648 ] && holds [ "$allowed" -lt 2200000000 ]
with 'exec "$reader" "$1" "$2" 0' verify models/fillet.step
holds [ $? -eq 2 ] && says err "models/fillet.step: not read with 20" " MB of memory, which are allowed for a file of this size: it is damaged"
with 'head -c $(($3 + 1)) /dev/zero' verify models/fillet.step
holds [ $? -eq 2 ] && says err "the library that reads it does not end: the file is damaged"

# the reader ends with the program, however that ends
with "$waits" verify models/fillet.step --time-limit 0.1
for signal in KILL TERM; do
  fake/geometric_continuity verify models/fillet.step --time-limit 100 >out 2>err &
  process=$!
  child=""
  for ((i = 0; i < 100; ++i)); do
    child=$(cat /proc/"$process"/task/*/children 2>/dev/null)
    [ -n "$child" ] && break
    sleep 0.1
  done
  holds [ -n "$child" ]
  sleep 0.3
  kill -$signal $process
  wait $process 2>/dev/null
  for ((i = 0; i < 50; ++i)); do
    [ -d "/proc/${child% }" ] || break
    sleep 0.1
  done
  holds [ ! -d "/proc/${child% }" ]
done
