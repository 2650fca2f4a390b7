#!/bin/bash
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later

# What a minimal program costs to compile, in seconds of the processor (the least of several runs) and bytes of the stripped
# object file, against a program that includes its kernel alone.
#   compile_time.sh JSON REPETITIONS COMPILER FLAGS...
set -euo pipefail
json=$1 repetitions=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C
TIMEFORMAT=%U

measure() { # FLAGS... SOURCE: sets least and bytes
  least=
  for ((i = 0; i < repetitions; ++i)); do
    local seconds
    seconds=$({ time "${compiler[@]}" "$@" -c -o "$work/object.o" 2>"$work/messages"; } 2>&1) ||
      { cat "$work/messages" >&2; exit 1; }
    least=$(printf '%s\n%s\n' "$seconds" "${least:-$seconds}" | sort -g | head -n 1)
  done
  strip -o "$work/stripped.o" "$work/object.o"
  bytes=$(stat -c %s "$work/stripped.o")
}

compiler=("$@")
separator='{"benchmarks": ['
: >"$json"
for kernel in Simple_cartesian Exact_predicates_inexact_constructions_kernel; do
  flags=()
  [ $kernel = Simple_cartesian ] || flags=(-DWITH_FILTERED_KERNEL)
  for level in -O0 -O2; do
    printf '\na minimal program, %s, %s\n' $kernel $level
    for program in kernel program; do
      measure "${flags[@]}" $level "$here/compile_time_$program.cpp"
      [ $program = program ] || { first_seconds=$least first_bytes=$bytes; }
      awk -v s="$least" -v b="$bytes" -v s1="$first_seconds" -v b1="$first_bytes" -v name=$program \
        'BEGIN { printf "%8.2f s %6.2f x %10d bytes %6.2f x  %s\n", s, s / s1, b, b / b1, name == "kernel" ? "the kernel alone" : "two curves, a blend, a join" }'
      printf '%s\n  {"name": "compile_time | %s %s | %s", "cpu_time": %s, "time_unit": "s", "stripped_bytes": %s}' \
        "$separator" $kernel $level $program "$least" "$bytes" >>"$json"
      separator=,
    done
  done
done
printf '\n]}\n' >>"$json"
