#!/bin/bash
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later

# Measures the compilation of minimal programs, in seconds of the processor (the least of several
# runs) and bytes of the stripped object file, against a program that includes its kernel alone.
#   compile_time.sh JSON REPETITIONS COMPILER FLAGS...
set -euo pipefail
json=$1 repetitions=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C
TIMEFORMAT=%U

seconds_to_compile() { # FLAGS... SOURCE: leaves $work/object.o
  { time "${compiler[@]}" "$@" -c -o "$work/object.o" 2>"$work/messages"; } 2>&1 || { cat "$work/messages" >&2; exit 1; }
}

compiler=("$@")
separator='{"benchmarks": ['
: >"$json"
for kernel in Simple_cartesian Exact_predicates_inexact_constructions_kernel; do
  flags=()
  [ $kernel = Simple_cartesian ] || flags=(-DWITH_FILTERED_KERNEL)
  for level in -O0 -O2; do
    printf '\na minimal program, %s, %s\n' $kernel $level
    declare -A seconds=() bytes=()
    for ((i = 0; i < repetitions; ++i)); do # in turns, so that a machine that becomes slower does so for both
      for program in kernel predicate program; do
        now=$(seconds_to_compile "${flags[@]}" $level "$here/compile_time_$program.cpp")
        seconds[$program]=$(printf '%s\n%s\n' "$now" "${seconds[$program]:-$now}" | sort -g | head -n 1)
        strip -o "$work/stripped.o" "$work/object.o"
        bytes[$program]=$(stat -c %s "$work/stripped.o")
      done
    done
    for program in kernel predicate program; do
      awk -v s="${seconds[$program]}" -v b="${bytes[$program]}" -v s1="${seconds[kernel]}" -v b1="${bytes[kernel]}" \
        -v name=$program \
        'BEGIN {
          what["kernel"] = "the kernel alone"; what["predicate"] = "two curves, is_g2_join()"; what["program"] = "two curves, a blend, continuity()"
          printf "%8.2f s %6.2f x %10d bytes %6.2f x  %s\n", s, s / s1, b, b / b1, what[name]
        }'
      printf '%s\n  {"name": "compile_time | %s %s | %s", "cpu_time": %s, "time_unit": "s", "stripped_bytes": %s}' \
        "$separator" $kernel $level $program "${seconds[$program]}" "${bytes[$program]}" >>"$json"
      separator=,
    done
  done
done
printf '\n]}\n' >>"$json"
