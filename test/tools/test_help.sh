#!/usr/bin/env bash
# Help of the program and of each command.
. "$(dirname "$0")/functions.sh"

narrow() { # the file out fits into a terminal of 80 columns
  holds [ -z "$(awk 'length > 80' out)" ]
}
run 0 --help && says out "blend" "extend" "verify" "plot" && narrow
for command in blend connect match extend interpolate fit verify repair plot report tessellate round-edges; do
  run 0 $command --help && says out "usage: geometric_continuity $command" "Exit code: 0 " && narrow
  holds [ "$(sed -n '/^examples:/,$p' out | grep -c "^  geometric_continuity $command ")" -eq 2 ] # two of them
done

# Each strategy that may be chosen is explained.
run 2 blend "$L" "$R" --strategy none && strategies=$(sed 's/.*none of //; s/, all.*//; s/,//g' err)
run 2 blend "$L" "$R" --order 3 --strategy none && strategies="$strategies $(sed 's/.*none of //; s/, all.*//; s/,//g' err)"
holds [ "$(wc -w <<<"$strategies")" -eq 17 ]
run 0 blend --help && for strategy in $strategies; do holds grep -qE "^  ([a-z0-9_]+, )?$strategy(,|  )" out; done
run 0 extend --help && lacks out "C0" # which is an order

# Misspelled words.
run 2 blnd && says err "unknown command 'blnd'; did you mean 'blend'?" && lacks err usage
run 2 nonsense && says err usage && lacks err "did you mean"
run 2 verify --clsoed "$S" && says err "unrecognised option '--clsoed'; did you mean '--closed'?"
run 2 verify --nonsense "$S" && lacks err "did you mean"
run 2 blend "$L" "$R" --strategy fiar && says err "'fiar' is none of c2, normal," "; did you mean 'fair'?"
# The strategies are listed where there is none of a name, in a list, for the other order, and where
# the name is missing.
run 2 blend --strategy help && says err "'help' is none of c2, normal, min_second, near_line, energy2, energy3, fair, free, all"
run 2 blend --strategy help --order 3 && says err "'help' is none of c3, seq_g3, seq_f3, joint_g3, energy3_g3, energy4_g3, fair_g3, fair_f3, free, all"
run 2 blend --surfaces --strategy help && says err "'help' is none of c2, normal, min_second, near_line, energy2, energy3, fair, fairest, free"
run 2 blend --surfaces --strategy help --order 3 && says err "'help' is none of c3, seq_g3, joint_g3, energy3_g3, energy4_g3, fair_g3, free"
run 2 blend --corners all --distance 1 --strategy help && says err "'help' is none of fair"
run 2 blend "$L" "$R" --strategy c2,help && says err "'help' is none of those that can be compared, which are c2, normal," ", fair"
for strategy in seq_g3 c2,seq_g3; do
  run 2 blend "$L" "$R" --strategy $strategy && says err "'seq_g3' is one of --order 3; here there are c2, normal," ", fair"
done
run 2 blend "$L" "$R" --strategy && says err "'--strategy' is missing; it is one of c2, normal," ", fair_f3, free, all"
run 2 verify "$L" --format && says err "'--format' is missing; it is one of text, json, sarif, junit"
run 2 verify "$L" --max-order && says err "'--max-order' is missing" && lacks err "it is one of"
run 2 repair "$S" -o no.g2 --to g2 && says err "'g2' is none of G1, G2; did you mean 'G2'?"

# These files are read as curves, and contain surfaces.
for command in verify "report -o no.html" "plot -o no.svg"; do
  run 2 $command "$teapot" && says err "teapot.g2:1: 200 (spline surface)" "; surfaces are read with --surfaces"
done
run 2 verify "$S" "$teapot" && says err "teapot.g2:1: " "--surfaces"

# The output is no wider than the terminal.
for order in 2 3; do is_narrow 0 blend "$L" "$R" --order $order --strategy all; done
is_narrow 0 verify "$S" --closed --within 1,1deg,1%
is_narrow 1 verify --surfaces "$teapot" --within 1,1deg

# The manual page and the completion of bash have all commands and options.
run 0 --man-page && mv out page.1 && run 0 --bash-completion && mv out completion
for command in blend connect match extend interpolate fit verify repair plot report tessellate round-edges; do
  says page.1 "geometric_continuity ${command//-/\\-}"
  run 0 $command --help
  for option in $(grep -oE '^  (-[a-z] \[ )?--[a-z0-9-]+' out | grep -oE '\-\-[a-z0-9-]+'); do
    says page.1 ".B ${option//-/\\-}" && says completion "$option"
  done
done
holds bash -n completion
completed() { # WORDS...: what bash offers for the last of them
  bash -c '. ./completion; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _geometric_continuity; echo "${COMPREPLY[*]}"' - "$@"
}
holds [ "$(completed geometric_continuity ver)" = verify ]
holds [ "$(completed geometric_continuity verify --max-k)" = --max-kink ]
holds [ "$(completed geometric_continuity blend --strategy fair_)" = "fair_g3 fair_f3" ]
touch only.g2 && holds [ "$(completed geometric_continuity verify onl)" = only.g2 ]
# The completions of zsh and fish are made of the same texts. Functions that print their arguments
# take the place of zsh's own ones.
completions=$(dirname "$0")/../../tools/completions
"$completions" zsh "$program" >_zsh && "$completions" fish "$program" >completion.fish
for command in blend connect match extend interpolate fit verify merge repair plot report tessellate round-edges; do
  says _zsh "  '$command:" && says completion.fish "-f -a $command -d"
  run 0 $command --help
  for option in $(grep -oE '^  (-[a-z] \[ )?--[a-z0-9-]+' out | grep -oE '\-\-[a-z0-9-]+'); do
    holds [ "$(sed -n "/^$command)/,/;;/p" _zsh | grep -c -- "'$option\[")" -eq 1 ]
    holds [ "$(grep -cE -- "_from $command' -l ${option#--} " completion.fish)" -eq 1 ]
  done
done
if command -v zsh >/dev/null; then
  completed() { # the number of the word to complete, and words
    zsh -fc '_arguments() { print -rl -- "$@" }; _describe() { print -rl -- "${(P@)2}" }; here() { . ./_zsh }
             CURRENT=$1; shift; words=("$@"); here' - "$@" >out
  }
  completed 2 geometric_continuity ver && says out "verify:decide the continuity of every join" && lacks out "kink-angle"
  completed 3 geometric_continuity verify --max-k && says out "--max-kink[" && lacks out "--strategy"
  completed 4 geometric_continuity blend --strategy fa && says out ":strategy:(c2 " " fair_f3 "
fi
if command -v fish >/dev/null; then
  completed() { fish --no-config -c '. ./completion.fish; complete -C $argv[1]' "$1" | cut -f 1 | sort | paste -sd " "; }
  holds [ "$(completed "geometric_continuity ver")" = verify ]
  holds [ "$(completed "geometric_continuity verify --max-k")" = --max-kink ]
  holds [ "$(completed "geometric_continuity blend --strategy fair_")" = "fair_f3 fair_g3" ]
fi
if command -v groff >/dev/null; then
  groff -man -Tascii -ww page.1 2>warnings | sed 's/.\x08//g' >page.txt
  holds [ ! -s warnings ] && says page.txt "SYNOPSIS" "blend A.g2 B.g2"
fi
run 2 && run 2 nonsense && says err "unknown command"
run 2 verify && run 2 verify --nonsense "$S" && run 2 blend "$L" && run 2 plot "$L"
