#!/usr/bin/env bash
# Help of the program and of each command.
. "$(dirname "$0")/functions.sh"

narrow() { # the file out fits into a terminal of 80 columns
  holds [ -z "$(awk 'length > 80' out)" ]
}
run 0 --help && says out "blend" "extend" "verify" "plot" && narrow
for command in blend connect extend verify repair plot report tessellate; do
  run 0 $command --help && says out "usage: geometric_continuity $command" && narrow
done
run 2 && run 2 nonsense && says err "unknown command"
run 2 verify && run 2 verify --nonsense "$S" && run 2 blend "$L" && run 2 plot "$L"
