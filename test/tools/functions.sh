# The tests of the program have this in common. A test is called as bash test_NAME.sh PROGRAM
# DATA_FOLDER WORK_FOLDER, and begins with
#   . "$(dirname "$0")/functions.sh"
# which moves to an empty work folder. When the test ends, its exit code tells whether a check has
# failed.
set -u
program=$1 data=$2 work=$3 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
failures=0 checks=0
finish() {
  local code=$?
  echo "$checks checks, $failures failures"
  [ $failures -eq 0 ] && [ $checks -gt 0 ] || code=1
  exit $code
}
trap finish EXIT

S=$data/lmroman10-regular_S_0.g2 L=$data/space_left.g2 R=$data/space_right.g2 teapot=$data/teapot.g2

# ends CODE COMMAND...: the exit code of the command is CODE; output and errors are kept in the
# files out and err
input=/dev/null
ends() {
  local expected=$1 code=0
  shift
  checks=$((checks + 1))
  "$@" >out 2>err <"$input" || code=$?
  [ "$code" -eq "$expected" ] && return
  failures=$((failures + 1))
  echo "exit code $code instead of $expected: $*"
  head -c 5000 out err
}
# run CODE ARGUMENTS...: as ends, of the program, which the command `limit` runs
limit=()
run() { ends "$1" "${limit[@]}" "$program" "${@:2}"; }
# bounded SECONDS CODE ARGUMENTS...: as run, in time
bounded() { local limit=(timeout "$1") && run "${@:2}"; }
# piped FILE CODE ARGUMENTS...: as run, with the file on standard input
piped() { local input=$1 && run "${@:2}"; }
# is_narrow CODE ARGUMENTS...: with 100 columns no line of the output is longer, with the same words
# as without a terminal, where one is
is_narrow() {
  run "$@" && tr -s ' \n' '\n' <out >words && holds [ -n "$(awk 'length > 100' out)" ]
  COLUMNS=100 run "$@" && holds [ -z "$(awk 'length > 100' out)" ]
  tr -s ' \n' '\n' <out | cmp -s - words || holds false
}
# says FILE TEXT...: the file contains each text
says() {
  local file=$1 text
  shift
  for text in "$@"; do
    checks=$((checks + 1))
    grep -qF -- "$text" "$file" && continue
    failures=$((failures + 1))
    echo "'$text' is missing in $file:"
    head -c 5000 "$file"
  done
}
# holds CONDITION...: the shell condition is true
holds() {
  checks=$((checks + 1))
  if ! "$@"; then
    failures=$((failures + 1))
    echo "not true: $*"
  fi
}
# lacks FILE TEXT...: the file contains none of the texts
lacks() {
  local file=$1 text
  shift
  for text in "$@"; do holds [ "$(grep -cF -- "$text" "$file")" -eq 0 ]; done
}

# is GIVEN EXPECTED WHAT: the texts are equal
is() {
  checks=$((checks + 1))
  [ "$1" = "$2" ] && return
  failures=$((failures + 1))
  echo "$3: '$1' instead of '$2'"
}
# same FILE FILE: they have the same content
same() { holds cmp -s "$1" "$2"; }
# refused TEXT ARGUMENTS...: the exit code is 2, and the error contains the text
refused() { run 2 "${@:2}" && says err "$1"; }
# answers CODE TEXT ARGUMENTS...: the exit code, and the output contains the text
answers() { run "$1" "${@:3}" && says out "$2"; }
# valid_json SCHEMA FILE: JSON as the schema says, where python3 and its jsonschema are there
valid_json() {
  python3 -c "import jsonschema" 2>/dev/null || return
  holds python3 -c 'import json, sys; from jsonschema import Draft7Validator as V
V(json.load(open(sys.argv[1]))).validate(json.load(open(sys.argv[2])))' "$here/schemas/$1.json" "$2"
}
# font FILE [AWK_OPTIONS...]: a font of the glyphs on standard input
font() { printf "$(LC_ALL=C awk "${@:2}" -f "$here/make_font.awk")" >"$1"; }
# needs_cad VARIABLE: the rest of the test is skipped where this one names no program, without
# OpenCASCADE
needs_cad() {
  [ -z "${!1-}" ] || return 0
  echo "skipped: built without OpenCASCADE"
  [ $checks -gt 0 ] || trap - EXIT
  exit 77
}
# made_by VARIABLE FOLDER ARGUMENTS...: a folder with what this program makes
made_by() { needs_cad "$1" && mkdir "$2" && (cd "$2" && "${!1}" "${@:3}") || exit 1; }

limited() { # KILOBYTES ARGUMENTS...: a run with no more memory
  (
    ulimit -v "$1"
    shift
    "$program" "$@" >out 2>err
  )
}
# Prints how many kilobytes the program needs to start, with its libraries.
memory_to_start() {
  local starts=4000
  until limited $starts --version 2>/dev/null; do starts=$((starts + 500)); done
  echo $starts
}

# Texts of the format .g2 after what they have in common: any curve, a curve of dimension 3, a cubic
# on [0, 1] by its points, a biquadratic surface with a double knot in u by its knots in v and its
# points.
curve() { printf '100 1 0 0\n%s\n' "$1"; }
spline() { curve "3 0"$'\n'"$1"; }
cubic() { spline $'4 4\n0 0 0 0 1 1 1 1\n'"$1"; }
flat() { printf '200 1 0 0\n3 0\n5 3\n0 0 0 1 1 2 2 2\n2 2\n%s\n' "$1"; }
# The file drawing.svg with these elements.
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg">\n%s</svg>\n' "$1" >drawing.svg; }
# A curve with two inner knots, of which one is double.
two_knots=$'7 4\n0 0 0 0 1 2 2 3 3 3 3\n0 0 0\n1 2 0\n2 3 1\n4 1 1\n5 0 3\n7 2 2\n8 3 0'
# Two segments whose join is undecided: the ellipse is turned by less than 1024 bits tell.
undecided_path='<path d="M0 0A5 4 1e-350 0 1 10 0v9"/>'
# A flat surface.
flat_points=$'0 0 1 1\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n4 1 0'
# laughs ROOT: XML whose text grows to 10^11 letters
laughs() {
  printf '<!DOCTYPE %s [<!ENTITY a0 "aaaaaaaaaa">' "$1"
  for i in {1..10}; do printf "<!ENTITY a$i \"%s\">" "$(printf "&a$((i - 1));%.0s" {1..10})"; done
  printf ']><%s>&a10;</%s>' "$1" "$1"
}
