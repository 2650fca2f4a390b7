// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_CONTINUITY_H

#include <CGAL/Geometric_continuity/IO/svg/Svg_segment.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Sqrt_extension.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The jet at one end of a segment in a field that has the root of the arc's radicand; that of a curve needs no root.
template <class Field, class Traits>
Coordinate_jet<Field, 2> svg_jet(const Svg_segment<Traits>& segment, bool at_end, int order, const Field& root) {
  typedef typename Traits::FT FT;
  if (const Svg_arc<Traits>* arc = segment.arc())
    return at_end ? arc->template end_jet_over<Field>(order, root) : arc->template start_jet_over<Field>(order, root);
  const Coordinate_jet<FT, 2> rational = at_end ? segment.bezier()->end_jet(order) : segment.bezier()->start_jet(order);
  Coordinate_jet<Field, 2> jet(2, order);
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i < 2; ++i) jet[j][i] = Field(rational[j][i]);
  return jet;
}

// The root that a segment needs.
template <class Traits> typename Traits::FT svg_radicand(const Svg_segment<Traits>& segment) {
  typedef typename Traits::FT FT;
  return segment.arc() ? segment.arc()->radicand() : FT(0);
}

// The decision in a field extended by one or two square roots, without the betas that are not in FT.
template <class FT, class Field> Join_continuity<FT> drop_irrational_betas(const Join_continuity<Field>& join) {
  Join_continuity<FT> r;
  r.c_order = join.c_order;
  r.g_order = join.g_order;
  r.f_order = join.f_order;
  r.regular = join.regular;
  r.tangent_equal = join.tangent_equal;
  r.curvature_equal = join.curvature_equal;
  r.curvature_vector_equal = join.curvature_vector_equal;
  return r;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Decides the continuity of the join between the end of `left` and the start of `right`, which are segments of SVG
/// paths, up to order `max_order`; empty when it cannot be decided because one of them is an arc whose derivatives are
/// not known.
///
/// Arcs are taken with respect to the eccentric angle; only the C order and the shape parameters depend on that. Where
/// the centre of an arc is not rational, the decision is made in the field extended by its square root, exactly, and no
/// shape parameters are given. In `double` it is plain floating point.
template <class Traits>
std::optional<Join_continuity<typename Traits::FT>> continuity(const Svg_segment<Traits>& left,
                                                               const Svg_segment<Traits>& right, int max_order = 3) {
  typedef typename Traits::FT FT;
  const auto known = [](const Svg_segment<Traits>& s) { return !s.arc() || s.arc()->is_known(); };
  if (!known(left) || !known(right)) return std::nullopt;
  const int order = std::max(max_order, 3); // curvature is reported for every max_order
  const auto decide = [&](const auto& left_root, const auto& right_root) {
    typedef std::decay_t<decltype(left_root)> Field;
    const Coordinate_jet<Field, 2> x = internal::svg_jet<Field>(left, true, order, left_root),
                                   y = internal::svg_jet<Field>(right, false, order, right_root);
    return internal::Join_decision<Field, 2>(x, y, max_order)();
  };
  const FT d = internal::svg_radicand(left), e = internal::svg_radicand(right);
  const std::optional<FT> p = rational_square_root(d), q = rational_square_root(e);
  if constexpr (std::is_floating_point_v<FT>)
    return decide(*p, *q);
  else {
    if (p && q) return decide(*p, *q);
    typedef Sqrt_extension<FT, FT> Field;    // a + b sqrt(d)
    typedef Sqrt_extension<Field, FT> Tower; // a + b sqrt(e), also when one root lies in the field of the other
    const Tower left_root(p ? Field(*p) : Field(FT(0), FT(1), d));
    const Tower right_root = q ? Tower(Field(*q)) : Tower(Field(FT(0)), Field(FT(1)), e);
    return internal::drop_irrational_betas<FT>(decide(left_root, right_root));
  }
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_CONTINUITY_H
