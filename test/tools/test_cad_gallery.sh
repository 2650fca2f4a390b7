#!/usr/bin/env bash
# Defects that samples miss: three STEP files in which OpenCASCADE finds G1, and `verify` proves
# that it is not.
. "$(dirname "$0")/functions.sh"

for name in at_end between_samples in_step_with_samples; do holds [ -s "$data/defect_$name.step" ]; done
made_by MAKE_CAD_GALLERY made

# defect FILE DEGREES FROM TO: the largest angle along the one inner edge, and where it is
defect() {
  local file=$1 folder
  shift
  for folder in "$data" made; do
    holds [ "$("$SAMPLED_CONTINUITY" "$folder/$file" 0.01 | cut -d ' ' -f 2)" = G1 ]
    run 1 verify "$folder/$file" --require G1 && says out "edges: 1 inner" "G0, kink" "1 of them not G1 within the tolerance"
    run 0 verify "$folder/$file" --require G0
    run 1 verify "$folder/$file" --require G1 --json && says out '"within":["proved","refuted","refuted"]'
    holds awk -v angle="$1" -v from="$2" -v to="$3" -F '"angle_degrees":\\[|"angle_at":\\{"parameter":' '
      /"angle_at"/ {
        split($2, ends, /[],]/)
        lies = ends[1] - 1e-9 <= angle && angle <= ends[2] + 1e-9 && ends[2] - ends[1] <= 0.01 * angle && from <= $3 + 0 && $3 + 0 <= to
      }
      END { exit !lies }' out
  done
}
defect defect_at_end.step 2.862405226 99.9 100                 # arctan 0.05
defect defect_between_samples.step 2.147585428 52.4 52.6       # arctan 0.0375
defect defect_in_step_with_samples.step 1.403465833 3 97 # arctan 0.0245, halfway between two samples
