// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_JSON_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_JSON_H

/// \file IO/json.h
/// Verdicts on joins as JSON. `write_json()` writes a value: a text, a flag, an enclosure, or an
/// object for the decision about a join. `write_json_members()` writes the members of such an
/// object without the braces, so that a program can add members of its own. Exact numbers are
/// strings, and undefined values are null. Each function writes its text at once, or nothing when
/// it throws; the locale, the width and the flags of the stream are ignored.

#include <CGAL/Geometric_continuity/IO/internal/utf8.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

inline std::string json_text(std::string_view text) {
  constexpr char hex[] = "0123456789abcdef";
  std::string json = "\"";
  for_each_utf8_character(text, [&](const Utf8_character& c) {
    if (c.code < 0x20)
      json += {'\\', 'u', '0', '0', hex[c.code / 16], hex[c.code % 16]};
    else {
      if (c.code == '"' || c.code == '\\') json += '\\';
      json += c.well_formed ? c.bytes : replacement_bytes;
    }
  });
  return json + '"';
}

inline std::string json_text(const std::optional<bool>& flag) { return !flag ? "null" : *flag ? "true" : "false"; }

inline std::string json_text(const std::optional<Enclosure>& e) {
  if (!e) return "null";
  const bool unbounded = e->upper > 0 && std::isinf(e->upper);
  return '[' + number_text(e->lower) + ',' + (unbounded ? std::string("null") : number_text(e->upper)) + ']';
}

template <class FT> std::string json_members(const Join_continuity<FT>& join, int left, int right) {
  std::string json;
  json.reserve(256);
  const auto number = [&json](const char* name, int x) {
    char text[16];
    (json += name).append(text, std::to_chars(text, text + sizeof text, x).ptr);
  };
  number("\"left\":", left);
  number(",\"right\":", right);
  number(",\"c_order\":", join.c_order);
  number(",\"g_order\":", join.g_order);
  number(",\"f_order\":", join.f_order);
  json += ",\"betas\":[";
  const char* separator = "\"";
  for (const FT& beta : join.betas()) {
    (json += separator) += number_text(beta);
    json += '"';
    separator = ",\"";
  }
  (json += "],\"regular\":") += json_text(std::optional<bool>(join.regular));
  (json += ",\"tangent_equal\":") += json_text(join.tangent_equal);
  (json += ",\"curvature_equal\":") += json_text(join.curvature_equal);
  (json += ",\"curvature_vector_equal\":") += json_text(join.curvature_vector_equal);
  (json += ",\"torsion_equal\":") += json_text(join.torsion_equal);
  return json;
}

inline std::string json_members(const Join_deviation& d) {
  std::optional<Enclosure> degrees, percent;
  if (d.tangent_angle) degrees = in_degrees(*d.tangent_angle);
  if (d.curvature_jump) percent = in_percent(*d.curvature_jump);
  return "\"gap\":" + json_text(std::optional<Enclosure>(d.gap)) + ",\"tangent_angle\":" + json_text(d.tangent_angle) +
         ",\"curvature_jump\":" + json_text(d.curvature_jump) + ",\"torsion_jump\":" + json_text(d.torsion_jump) +
         ",\"angle_degrees\":" + json_text(degrees) + ",\"curvature_percent\":" + json_text(percent);
}

inline std::string json_members(const Order_within& within) {
  std::string json = "\"within\":[";
  for (int order = 0; order <= 3; ++order) json += (order == 0 ? "\"" : ",\"") + to_string(within(order)) + '"';
  return json + "]," + json_members(within.deviation);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Writes a text as a JSON string, in quotes and with escapes for quotes, backslashes and control
/// characters. The text is expected in UTF-8; what is not becomes U+FFFD, one for each longest part
/// that could begin a character.
inline void write_json(std::ostream& os, std::string_view text) { internal::write_text(os, internal::json_text(text)); }

/// \ingroup PkgGeometricContinuityIO
/// Writes a text that ends with a null character as a JSON string.
inline void write_json(std::ostream& os, const char* text) { write_json(os, std::string_view(text)); }

/// \ingroup PkgGeometricContinuityIO
/// Writes a flag as `true`, `false` or, when it is empty, `null`.
inline void write_json(std::ostream& os, const std::optional<bool>& flag) {
  internal::write_text(os, internal::json_text(flag));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes an enclosure as `[lower,upper]`, without loss, or `null` when it is empty. An infinite
/// upper bound is `null`.
/// \throws Error `not_finite` for a bound that is not a number, and for an infinite lower bound
inline void write_json(std::ostream& os, const std::optional<Enclosure>& enclosure) {
  internal::write_text(os, internal::json_text(enclosure));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the members of the JSON object of `write_json(os, join, left, right)`, without braces.
/// \throws Error as `write_number()` does for the shape parameters
template <class FT>
void write_json_members(std::ostream& os, const Join_continuity<FT>& join, int left = 0, int right = 1) {
  internal::write_text(os, internal::json_members(join, left, right));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the members of the JSON object of `write_json(os, within)`, without braces.
/// \throws Error `not_finite` for an enclosure with a bound that is not a number
inline void write_json_members(std::ostream& os, const Order_within& within) {
  internal::write_text(os, internal::json_members(within));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the enclosures of a deviation as the members of a JSON object, without braces: those of
/// `write_json(os, within)` behind the verdicts.
/// \throws Error `not_finite` for an enclosure with a bound that is not a number
inline void write_json_members(std::ostream& os, const Join_deviation& deviation) {
  internal::write_text(os, internal::json_members(deviation));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the decision about the join of the curves number `left` and `right`, of two curves 0 and
/// 1, as a JSON object
/// `{"left":…,"right":…,"c_order":…,"g_order":…,"f_order":…,"betas":["p/q",…],"regular":…,"tangent_equal":…,
/// "curvature_equal":…,"curvature_vector_equal":…,"torsion_equal":…}`. A gap between the end points
/// is `c_order` -1.
/// \throws Error as `write_number()` does for the shape parameters
template <class FT> void write_json(std::ostream& os, const Join_continuity<FT>& join, int left = 0, int right = 1) {
  internal::write_text(os, '{' + internal::json_members(join, left, right) + '}');
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the verdicts for the orders 0 to 3 and the enclosures of a deviation as a JSON object
/// `{"within":["proved",…],"gap":[…,…],"tangent_angle":[…,…],"curvature_jump":[…,…],"torsion_jump":[…,…],
/// "angle_degrees":[…,…],"curvature_percent":[…,…]}`, where `tangent_angle` is in radians and
/// `curvature_jump` a ratio.
/// \throws Error `not_finite` for an enclosure with a bound that is not a number
inline void write_json(std::ostream& os, const Order_within& within) {
  internal::write_text(os, '{' + internal::json_members(within) + '}');
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_JSON_H
