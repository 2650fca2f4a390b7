// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "join_report.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>

namespace {

typedef GC::Curve_jet<Program_traits<Exact>> Jet;

std::string four_digits(double x) { return rounded(x, 4); }

// The square root, for reports only.
double root(const Exact& square) { return std::sqrt(CGAL::to_double(square)); }

std::string curvature(const Jet& jet) {
  if (jet.dimension() != 2) return four_digits(root(*GC::curvature_squared(jet)));
  const GC::Signed_square<Exact> k = *GC::signed_curvature(jet);
  return four_digits(k.sign * root(k.square));
}

// "from x to y", or the size of the jump when it does not show in the rounded numbers.
std::string jump(const std::string& from, const std::string& to, double size) {
  return from != to ? "from " + from + " to " + to : "by " + four_digits(size) + " at " + from;
}

// The angle between the tangents in degrees. The sine comes from an exact square, so that the tiny kinks that designers
// look for keep their digits.
double kink(const Jet& left, const Jet& right) {
  const Exact xx = dot(left[1], left[1]), yy = dot(right[1], right[1]), xy = dot(left[1], right[1]);
  const Exact sine_squared = (xx * yy - xy * xy) / (xx * yy), cosine_squared = xy * xy / (xx * yy);
  const double degrees = 180 / std::acos(-1.0);
  const double angle = std::atan2(root(sine_squared), root(cosine_squared)) * degrees;
  return xy < 0 ? 180 - angle : angle;
}

} // namespace

std::string rounded(double x, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
}

int Conclusion::exit_code(const Report_mode& mode, const std::string& what) const {
  if (decided == 0 && !mode.allow_empty) {
    std::cerr << "geometric_continuity: verify: there is no " << what
              << ", so that nothing was decided; --allow-empty accepts that\n";
    return bad_input;
  }
  return met(mode) ? requirement_met : requirement_not_met;
}

Requirement::Requirement(const std::string& text) : order_(-1) {
  const std::size_t kind = std::string("CGF").find(text.substr(0, 1));
  const std::string digits = text.substr((std::min<std::size_t>)(1, text.size()));
  if (!text.empty() && kind != std::string::npos && !digits.empty() && digits.size() <= 2 &&
      digits.find_first_not_of("0123456789") == std::string::npos) {
    kind_ = static_cast<GC::Continuity_kind>(kind);
    order_ = std::stoi(digits);
  }
  if (order_ < 0 || order_ > 32)
    throw std::invalid_argument("--require: '" + text + "' is not C, G or F with an order from 0 to 32, such as G2");
}

void Requirement::check_dimension(int dimension) const {
  if (kind_ == GC::Continuity_kind::F && order_ > dimension)
    throw std::invalid_argument("--require " + text() + ": the F order is at most the dimension, which is " +
                                std::to_string(dimension));
}

std::string Requirement::text() const { return "CGF"[static_cast<int>(kind_)] + std::to_string(order_); }

std::string orders(const Join& join) {
  if (join.c_order < 0) return "gap";
  return 'C' + std::to_string(join.c_order) + " G" + std::to_string(join.g_order) + " F" + std::to_string(join.f_order);
}

std::string remark(const Join& join, const Jet& x, const Jet& y) {
  if (join.c_order < 0) {
    const GC::Coordinate_vector<Exact, 0> d = y[0] - x[0];
    return "the ends are " + four_digits(root(dot(d, d))) + " apart";
  }
  if (!join.regular) {
    const bool left_zero = is_zero(x[1]), right_zero = is_zero(y[1]);
    return std::string("zero tangent ") + (left_zero && right_zero ? "on both sides"
                                           : left_zero             ? "at the end of the left curve"
                                                                   : "at the start of the right curve");
  }
  if (!*join.tangent_equal) {
    const double angle = kink(x, y);
    return angle == 180 ? "cusp: the curve turns back" : "kink of " + four_digits(angle) + " degrees";
  }
  if (!*join.curvature_vector_equal) {
    if (*join.curvature_equal) return "equal curvature " + curvature(x) + ", but the curve bends another way";
    const Program_traits<Exact>::Vector d = *GC::curvature_vector(x) - *GC::curvature_vector(y);
    return "curvature jumps " + jump(curvature(x), curvature(y), root(d.squared_length()));
  }
  if (join.torsion_equal && !*join.torsion_equal) {
    const double tx = CGAL::to_double(*GC::torsion(x)), ty = CGAL::to_double(*GC::torsion(y));
    return "torsion jumps " + jump(four_digits(tx), four_digits(ty), std::abs(tx - ty));
  }
  return "smooth";
}

std::string table_head() { return "join         orders      point                     remark\n"; }

std::string table_row(const Join& join, int left, int right, const Jet& left_jet, const Jet& right_jet) {
  std::string point = "(";
  const GC::Coordinate_vector<Exact, 0>& x = left_jet[0];
  for (int i = 0; i < x.dimension(); ++i) point += (i == 0 ? "" : ", ") + four_digits(CGAL::to_double(x[i]));
  const std::string columns[] = {std::to_string(left) + " -> " + std::to_string(right), orders(join), point + ')'};
  const std::size_t widths[] = {12, 11, 25};
  std::string row;
  for (int i = 0; i < 3; ++i)
    row += columns[i] + std::string(columns[i].size() < widths[i] ? widths[i] - columns[i].size() + 1 : 1, ' ');
  return row + remark(join, left_jet, right_jet) + '\n';
}
