#!/usr/bin/env bash
# Output is written as a whole or refused with the reason: standard output, reports that are longer
# than the memory for them, files that are replaced, signals.
. "$(dirname "$0")/functions.sh"

to_full_device() { "$program" "$@" >/dev/full; }
to_closed_output() { "$program" "$@" >&-; }
no_temporary_files() { [ -z "$(find . -name '.geometric_continuity*')" ]; }

# standard output: every command
cubic $'0 0 0\n1 0 0\n2 0 0\n3 0 0' >c.g2
cubic $'0 1 0\n1 1 0\n2 1 0\n3 1 0' >c1.g2
cubic $'0 -1 0\n1 -1 0\n2 -1 0\n3 -1 0' >c2.g2
all_commands() { # CHECK ARGUMENTS...
  "$@" --help && "$@" --version && "$@" verify --closed "$L" && "$@" verify --closed "$L" --json
  "$@" verify --surfaces "$teapot" && "$@" verify "$data/leaf_inkscape.svg" && "$@" blend "$L" "$R"
  "$@" extend "$L" --order curvature -o out.g2 && "$@" connect c.g2 c1.g2 c2.g2 -o out.g2
  "$@" tessellate "$teapot" --grid 2 -o out.off && "$@" blend "$L" "$R" -o - && "$@" plot "$S" -o -
  "$@" tessellate "$teapot" --grid 9 -o - --format ply && "$@" plot --surfaces "$teapot" -o -
  "$@" report "$S" -o -
  for command in blend connect extend report verify plot tessellate; do "$@" $command --help; done
}
to_full() { ends 2 to_full_device "$@" && says err "cannot_write_file: standard output: No space left on device"; }
to_closed() { ends 2 to_closed_output "$@" && says err "cannot_write_file: standard output: Bad file descriptor"; }
if [ -e /dev/full ]; then
  all_commands to_full
  run 2 blend "$L" "$R" -o /dev/full && says err "cannot_write_file: /dev/full: No space left on device"
fi
all_commands to_closed
closed_input() { "$program" verify - <&-; }
ends 2 closed_input && says err "cannot_read_file: standard input: Bad file descriptor"
all_closed() { "$program" blend "$L" "$R" -o all_closed.g2 <&- >&- 2>&-; } # no file takes the place of a standard stream
run 0 blend "$L" "$R" -o good.g2
ends 2 all_closed && holds cmp -s good.g2 all_closed.g2

# a reader that has seen enough: no message
{
  printf '100 1 0 0\n2 0\n30000 2\n0'
  seq -s ' ' 0 29999 | sed 's/^/ /; s/$/ 29999/'
  seq 1 30000 | sed 's/$/ 1/'
} >long.g2
"$program" verify long.g2 --json 2>err | head -c 100 >/dev/null
holds [ "${PIPESTATUS[0]}" -eq 141 -a ! -s err ]

# a long report waits in a temporary file
spool() { # LIMIT FOLDER ARGUMENTS...
  (
    ulimit -f "$1"
    export TMPDIR=$2
    shift 2
    "$program" "$@"
  )
}
mkdir spool
ends 0 spool unlimited spool verify --closed "$L" && ends 0 spool unlimited missing verify --closed "$L" # short
ends 0 spool unlimited "$PWD/spool" verify long.g2 --json && holds [ "$(grep -c '"left":' out)" -eq 29998 ]
holds [ -z "$(ls -A spool)" ]
says out '"summary":{"joins":29998,'
ends 2 spool unlimited missing verify long.g2 --json
says err "cannot_write_file: temporary file missing/geometric_continuity_" "No such file or directory" && holds [ ! -s out ]
ends 2 spool 1000 spool verify long.g2 --json
says err "cannot_write_file: temporary file spool/geometric_continuity_" "File too large" && holds [ ! -s out ]
holds [ -z "$(ls -A spool)" ]

# the file of the result: links, mode, full disks
echo old >old.g2 && chmod 640 old.g2 && ln -s old.g2 link.g2 && ln -s new.g2 dangling.g2
run 0 blend "$L" "$R" -o link.g2 && holds cmp -s old.g2 good.g2
holds [ -L link.g2 -a "$(stat -c %a old.g2)" = 640 ]
run 0 blend "$L" "$R" -o dangling.g2 && holds cmp -s new.g2 good.g2 && holds [ -L dangling.g2 ]
echo old >old.off
limited() { (ulimit -f 4 && "$program" "$@"); }
ends 2 limited tessellate "$teapot" --grid 20 -o old.off && says err "cannot_write_file: old.off: File too large"
holds [ "$(cat old.off)" = old ] && holds no_temporary_files
run 0 blend "$L" "$R" -o /dev/null && run 0 plot "$S" -o /dev/null
run 2 blend "$L" "$R" -o . && says err "Is a directory"
run 0 extend c.g2 --order tangent -o c.g2 && holds [ "$(grep -c '^100 ' c.g2)" -eq 2 ] # the input is replaced

# standard input and output in every format
run 0 blend "$L" "$R" -o - && says err "both joins" && holds cmp -s out good.g2
piped good.g2 0 verify "$L" - "$R" --require G2 && says out "every join is G2"
piped "$L" 0 blend - "$R" -o dash.g2 && same dash.g2 good.g2
piped "$teapot" 0 verify - --surfaces --allow-uncovered && says out "24 G2"
run 0 tessellate "$teapot" --grid 2 -o teapot.obj && run 0 tessellate "$teapot" --grid 2 --format obj -o - && says err "240 triangles"
holds cmp -s out teapot.obj
run 0 plot "$S" -o S.svg && run 0 plot "$S" -o - && holds cmp -s out S.svg
run 2 verify - - && says err "standard input is to be read twice"
run 2 verify - && says err "standard input:1: no curve"
holds [ ! -e ./- ]

# signals: the old file stays, the temporary one goes, the status is that of the signal
set -m
for signal in INT TERM HUP; do
  echo old >signal.off
  for _ in 1 2 3 4 5; do # until the signal finds the program writing
    "$program" tessellate "$teapot" --grid 100 -o signal.off >out 2>err &
    while no_temporary_files && kill -0 $! 2>/dev/null; do :; done
    kill -$signal $! 2>/dev/null
    wait $!
    code=$?
    [ $code -ne 0 ] && break
  done 2>/dev/null
  holds [ $code -eq $((128 + $(kill -l $signal))) -a "$(cat signal.off)" = old ] && holds no_temporary_files
done
