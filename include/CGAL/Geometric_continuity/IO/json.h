// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_JSON_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_JSON_H

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/order_within.h>

#include <cmath>
#include <optional>
#include <ostream>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

inline void write_json(std::ostream& os, const char* key, const std::optional<bool>& flag) {
  os << ",\"" << key << "\":" << (!flag ? "null" : *flag ? "true" : "false");
}

// The members of the object, without braces, so that others may follow.
template <class FT> void write_json_members(std::ostream& os, const Join_continuity<FT>& join, int left, int right) {
  const std::vector<FT> betas = join.betas();
  os << "\"left\":" << left << ",\"right\":" << right << ",\"c_order\":" << join.c_order
     << ",\"g_order\":" << join.g_order << ",\"f_order\":" << join.f_order << ",\"betas\":[";
  for (std::size_t i = 0; i < betas.size(); ++i) {
    os << (i == 0 ? "\"" : ",\"");
    write_number(os, betas[i]);
    os << '"';
  }
  os << "],\"regular\":" << (join.regular ? "true" : "false");
  write_json(os, "tangent_equal", join.tangent_equal);
  write_json(os, "curvature_equal", join.curvature_equal);
  write_json(os, "curvature_vector_equal", join.curvature_vector_equal);
  write_json(os, "torsion_equal", join.torsion_equal);
}

inline void write_json(std::ostream& os, const char* key, const std::optional<Enclosure>& e) {
  os << ",\"" << key << "\":";
  if (!e) {
    os << "null";
    return;
  }
  os << '[';
  write_number(os, e->lower);
  os << ',';
  if (std::isfinite(e->upper))
    write_number(os, e->upper);
  else
    os << "null";
  os << ']';
}

// The members of the object, without braces.
inline void write_json_members(std::ostream& os, const Order_within& within) {
  os << "\"within\":[";
  for (int order = 0; order <= 3; ++order) os << (order == 0 ? "\"" : ",\"") << within(order) << '"';
  os << ']';
  write_json(os, "gap", within.deviation.gap);
  write_json(os, "tangent_angle", within.deviation.tangent_angle);
  write_json(os, "curvature_jump", within.deviation.curvature_jump);
  write_json(os, "torsion_jump", within.deviation.torsion_jump);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Writes what was decided about the join of the curves number `left` and `right` as a JSON object
/// `{"left":…,"right":…,"c_order":…,"g_order":…,"f_order":…,"betas":["p/q",…],"regular":…,"tangent_equal":…,
/// "curvature_equal":…,"curvature_vector_equal":…,"torsion_equal":…}`. Exact numbers are strings; a gap between the end
/// points is `c_order` -1; what is undefined is null.
template <class FT> void write_json(std::ostream& os, const Join_continuity<FT>& join, int left, int right) {
  os << '{';
  internal::write_json_members(os, join, left, right);
  os << '}';
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the verdicts for the orders 0 to 3 and the enclosures of a deviation as a JSON object
/// `{"within":["proved",…],"gap":[…,…],"tangent_angle":[…,…],"curvature_jump":[…,…],"torsion_jump":[…,…]}`. What is
/// undefined is null, and so is an infinite upper bound.
inline void write_json(std::ostream& os, const Order_within& within) {
  os << '{';
  internal::write_json_members(os, within);
  os << '}';
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_JSON_H
