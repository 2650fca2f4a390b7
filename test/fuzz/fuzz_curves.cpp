// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curves of .g2 files: what is read and written reads back equal, and the pieces of a spline form a
// chain.

#include "fuzz_target.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

namespace {

constexpr int max_degree = 7, max_points = 24; // of what is decided

template <class Traits> std::vector<GC::Rational_bspline_curve<Traits>> read(std::string_view text) {
  std::istringstream is{std::string(text)};
  return GC::read_g2_rational_bsplines<Traits>(is, "fuzz.g2");
}

template <class Traits> void round_trip(const std::vector<GC::Rational_bspline_curve<Traits>>& curves) {
  typedef typename Traits::FT FT;
  std::ostringstream os;
  for (const GC::Rational_bspline_curve<Traits>& curve : curves) {
    if (std::is_same_v<FT, double> && std::count(curve.weights().begin(), curve.weights().end(), FT(0)) > 0)
      return; // with infinite points the others are rounded as well
    GC::write_g2(os, curve);
  }
  if (has_long_number(os.str())) return;
  require(read<Traits>(os.str()) == curves, "curves that are written read back equal");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Exact;
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double;
  const std::string_view text = fuzz_text(data, size);
  std::vector<GC::Rational_bspline_curve<Double>> rounded;
  if (accepts([&] { rounded = read<Double>(text); })) round_trip(rounded);
  std::vector<GC::Rational_bspline_curve<Exact>> curves;
  if (!accepts([&] { curves = read<Exact>(text); })) return 0;
  round_trip(curves);
  std::vector<GC::Rational_bezier_curve<Exact>> pieces;
  for (const GC::Rational_bspline_curve<Exact>& curve : curves) {
    if (curve.degree() > max_degree || curve.number_of_points() > max_points) return 0;
    accepts([&] {
      const std::vector<GC::Curve_end_jets<Exact>> ends = curve.span_end_jets(3);
      std::size_t span = 0;
      for (const GC::Rational_bezier_curve<Exact>& piece : curve.bezier_pieces()) {
        require(ends[span].start_jet(3) == piece.start_jet(3) && ends[span].end_jet(3) == piece.end_jet(3),
                "jets of spans are those of the pieces");
        pieces.push_back(piece);
        ++span;
      }
    });
  }
  for (std::size_t i = 1; i < pieces.size(); ++i)
    accepts([&] {
      const auto join = GC::continuity(pieces[i - 1], pieces[i]);
      const bool meet = pieces[i - 1].end_jet(0).point() == pieces[i].start_jet(0).point();
      require((join.g_order >= 0) == meet, "curves join when they meet");
      require(join.c_order <= join.g_order || !join.regular, "what is C1 is G1");
    });
  return 0;
}
