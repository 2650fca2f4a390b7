#!/usr/bin/env bash
# Compiles and runs the blocks of C++ of the manual that are no snippets of examples, and reads the
# curve that it shows in the format .g2. Usage: test_blocks.sh COMPILER SOURCE_FOLDER
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$2/doc/Geometric_continuity"
awk -v work="$work" '/^\\code\{\.cpp\}/ { file = work "/" FILENAME "." ++n[FILENAME]; next } /^\\endcode/ { file = "" } file { print > file }' *.txt
awk '/^\\endverbatim/ { inside = 0 } inside { print } /^\\verbatim/ { getline; inside = /^100 1 0 0/; if (inside) print }' Input_and_output.txt >"$work/curve.g2"
[ "$(ls "$work" | grep -c '\.txt\.')" -eq 5 ] || { echo "not five blocks:" && ls "$work" && exit 1; }
cat >"$work/main.cpp" <<'CPP'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/G2_span_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Simple_cartesian.h>
#include <fstream>
#include <iostream>
#include <sstream>
namespace GC = CGAL::Geometric_continuity;
#include "Blends.txt.1"
template <class Traits> using Curve = GC::Bezier_curve<Traits>;
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Exact_traits;
typedef Exact_traits::FT FT;
typedef Exact_traits::Point Point;
template <class Traits> Curve<Traits> given(int i) {
  typedef typename Traits::Point P;
  if (i == 1) return {P(0, 0, 0), P(1, 0, 0), P(2, 2, 0), P(3, 2, 1)};
  return {P(7, 1, 0), P(8, 2, 2), P(9, 1, 1), P(11, 0, 3)};
}
int main() {
  const Curve<Exact_traits> curve = given<Exact_traits>(1), next = given<Exact_traits>(2);
  const GC::Quintic_blend<Exact_traits> reach = GC::blend(curve, next, Long_reach());
  std::cout << GC::continuity(curve, reach) << '\n';
  {
    typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
    const Curve<Traits> phi = given<Traits>(1), psi = given<Traits>(2);
#include "Blends.txt.2"
    std::cout << '\n';
  }
  {
    std::stringstream file;
    GC::write_g2(file, curve);
    GC::write_g2(file, Curve<Exact_traits>(reach.begin(), reach.end()));
    GC::write_g2(file, next);
    GC::Chain_summary summary;
#include "Input_and_output.txt.1"
    std::cout << summary << '\n';
  }
  const Point wished(4, 2, 2), point = GC::curvature_alternatives(curve, FT(1)).point_at(FT(5));
#include "Segmented_curves.txt.1"
  std::cout << "C_0 = " << *c0 << '\n';
  {
#include "Roads_and_rails.txt.1"
  }
  std::ifstream shown("curve.g2");
  std::cout << GC::read_g2_curves<GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>>>(shown)[0].control_point(1) << '\n';
}
CPP
"$1" -std=c++17 -I"$2/include" "$work/main.cpp" -lgmp -lmpfr -o "$work/blocks"
cd "$work"
./blocks | tee out
lines=0
while read -r line; do
  lines=$((lines + 1))
  sed -n "${lines}p" out | grep -q "$line" || { echo "not in line $lines: $line" && exit 1; }
done <<'END'
^C. G2 F2
^C0 G2 F2.* C0 G2 F2.*C0 G
^2 joins, C0 G2 F2
^C_0 = 5$
^0 0 0 2$
^1/3 2$
END
