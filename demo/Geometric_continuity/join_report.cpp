// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "join_report.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace {

typedef GC::Curve_jet<Program_traits<Exact>> Jet;

constexpr double degrees = 57.29577951308232; // of a radian

// A column of a table.
std::string padded(std::string text, std::size_t width) {
  text.append(text.size() < width ? width - text.size() + 1 : 1, ' ');
  return text;
}

std::string four_digits(double x) { return rounded(x, 4); }

// The square root, for reports only.
double root(const Exact& square) { return std::sqrt(CGAL::to_double(square)); }

// The rounded numbers of a remark, from exact jets.
class Exact_numbers {
  const Jet &x_, &y_;

public:
  Exact_numbers(const Jet& left, const Jet& right) : x_(left), y_(right) {}

  bool left_is_zero() const { return is_zero(x_[1]); }
  bool right_is_zero() const { return is_zero(y_[1]); }

  std::string coordinate(int i) const { return four_digits(CGAL::to_double(x_[0][i])); }

  std::string gap() const {
    const GC::Coordinate_vector<Exact, 0> d = y_[0] - x_[0];
    return four_digits(root(dot(d, d)));
  }

  // The angle between the tangents in degrees. The sine comes from an exact square, so that the tiny kinks that designers
  // look for keep their digits.
  std::string angle() const {
    const Exact xx = dot(x_[1], x_[1]), yy = dot(y_[1], y_[1]), xy = dot(x_[1], y_[1]);
    const Exact sine_squared = (xx * yy - xy * xy) / (xx * yy), cosine_squared = xy * xy / (xx * yy);
    const double angle = std::atan2(root(sine_squared), root(cosine_squared)) * degrees;
    return four_digits(xy < 0 ? 180 - angle : angle);
  }

  bool is_cusp() const {
    const Exact xx = dot(x_[1], x_[1]), yy = dot(y_[1], y_[1]), xy = dot(x_[1], y_[1]);
    return xy < 0 && xx * yy == xy * xy;
  }

  std::string left_curvature() const { return curvature(x_); }
  std::string right_curvature() const { return curvature(y_); }
  std::string curvature_jump() const {
    const Program_traits<Exact>::Vector d = *GC::curvature_vector(x_) - *GC::curvature_vector(y_);
    return four_digits(root(d.squared_length()));
  }

  std::string left_torsion() const { return four_digits(CGAL::to_double(*GC::torsion(x_))); }
  std::string right_torsion() const { return four_digits(CGAL::to_double(*GC::torsion(y_))); }
  std::string torsion_jump() const {
    return four_digits(std::abs(CGAL::to_double(*GC::torsion(x_)) - CGAL::to_double(*GC::torsion(y_))));
  }

private:
  static std::string curvature(const Jet& jet) {
    if (jet.dimension() != 2) return four_digits(root(*GC::curvature_squared(jet)));
    const GC::Signed_square<Exact> k = *GC::signed_curvature(jet);
    return four_digits(k.sign * root(k.square));
  }
};

typedef CGAL::Interval_nt<false> Interval;

// The same from enclosures of the jets. A number is certain if all numbers of its enclosure are rounded to the same text.
template <int N> class Enclosed_numbers {
  typedef GC::Coordinate_jet<Interval, N> Enclosed_jet;
  typedef GC::Coordinate_vector<Interval, N> Vector;
  const Enclosed_jet &x_, &y_;
  mutable bool certain_ = true;

public:
  Enclosed_numbers(const Enclosed_jet& left, const Enclosed_jet& right) : x_(left), y_(right) {}

  // Whether all numbers so far are what Exact_numbers says.
  bool certain() const { return certain_; }

  bool left_is_zero() const { return vanishes(x_[1]); }
  bool right_is_zero() const { return vanishes(y_[1]); }
  std::string coordinate(int i) const { return text(x_[0][i]); }
  std::string gap() const { return text(length(Vector(y_[0] - x_[0]))); }

  std::string angle() const {
    const Interval sine = length(cross(x_[1], y_[1])), cosine = dot(x_[1], y_[1]);
    const double least = (std::max)(0.0, sine.inf()), largest = sine.sup(); // 0 without a sign
    // the angle falls with the cosine; with the sine it grows up to a right angle, and falls beyond
    const double low = std::atan2(cosine.sup() < 0 ? largest : least, cosine.sup()),
                 high = std::atan2(cosine.inf() < 0 ? least : largest, cosine.inf());
    const double rounding = 1e-14; // of atan2() in any rounding mode
    return text(Interval(low * degrees * (1 - rounding), high * degrees * (1 + rounding)));
  }

  bool is_cusp() const {
    if (!(length(cross(x_[1], y_[1])).inf() > 0)) certain_ = false;
    return false;
  }

  std::string left_curvature() const { return text(curvature(x_)); }
  std::string right_curvature() const { return text(curvature(y_)); }
  std::string curvature_jump() const { return text(length(Vector(curvature_vector(x_) - curvature_vector(y_)))); }

  std::string left_torsion() const { return text(torsion(x_)); }
  std::string right_torsion() const { return text(torsion(y_)); }
  std::string torsion_jump() const { return text(CGAL::abs(Interval(torsion(x_) - torsion(y_)))); }

private:
  std::string text(const Interval& x) const {
    const std::string low = four_digits(x.inf());
    if (x.inf() != x.sup() && low != four_digits(x.sup())) certain_ = false;
    return low;
  }

  bool vanishes(const Vector& v) const {
    bool zero = true;
    for (const Interval& x : v) zero = zero && x.inf() == 0 && x.sup() == 0;
    return zero;
  }

  static Interval square_of(const Vector& v) {
    Interval sum(0);
    for (const Interval& x : v) sum += CGAL::square(x);
    return sum;
  }
  static Interval length(const Vector& v) { return CGAL::sqrt(square_of(v)); }
  static Interval length(const Interval& x) { return CGAL::abs(x); }

  // A number in the plane, a vector in space.
  static auto cross(const Vector& a, const Vector& b) {
    const auto minor = [&](int i, int j) { return Interval(a[i] * b[j] - a[j] * b[i]); };
    if constexpr (N == 2)
      return minor(0, 1);
    else {
      Vector c(3);
      for (int i = 0; i < 3; ++i) c[i] = minor((i + 1) % 3, (i + 2) % 3);
      return c;
    }
  }

  static Interval curvature(const Enclosed_jet& jet) {
    const Interval g = square_of(jet[1]), cubed = g * CGAL::sqrt(g);
    if constexpr (N == 2)
      return cross(jet[1], jet[2]) / cubed;
    else
      return length(cross(jet[1], jet[2])) / cubed;
  }
  static Vector curvature_vector(const Enclosed_jet& jet) {
    const Interval g = square_of(jet[1]), h = dot(jet[1], jet[2]), gg = CGAL::square(g);
    Vector k(N);
    for (int i = 0; i < N; ++i) k[i] = (g * jet[2][i] - h * jet[1][i]) / gg;
    return k;
  }
  static Interval torsion(const Enclosed_jet& jet) {
    if constexpr (N == 2)
      return Interval(0);
    else {
      const Vector n = cross(jet[1], jet[2]);
      return dot(n, jet[3]) / square_of(n);
    }
  }
};

// "from x to y", or the size of the jump when it does not show in the rounded numbers.
template <class Size> std::string jump(const std::string& from, const std::string& to, Size size) {
  return from != to ? "from " + from + " to " + to : "by " + size() + " at " + from;
}

template <class Numbers> std::string remark_of(const Join& join, const Numbers& numbers) {
  if (join.c_order < 0) return "the ends are " + numbers.gap() + " apart";
  if (!join.regular) {
    const bool left_zero = numbers.left_is_zero(), right_zero = numbers.right_is_zero();
    return std::string("zero tangent ") + (left_zero && right_zero ? "on both sides"
                                           : left_zero             ? "at the end of the left curve"
                                                                   : "at the start of the right curve");
  }
  if (!*join.tangent_equal)
    return numbers.is_cusp() ? "cusp: the curve turns back" : "kink of " + numbers.angle() + " degrees";
  if (!*join.curvature_vector_equal) {
    if (*join.curvature_equal)
      return "equal curvature " + numbers.left_curvature() + ", but the curve bends another way";
    return "curvature jumps " +
           jump(numbers.left_curvature(), numbers.right_curvature(), [&] { return numbers.curvature_jump(); });
  }
  if (join.torsion_equal && !*join.torsion_equal)
    return "torsion jumps " +
           jump(numbers.left_torsion(), numbers.right_torsion(), [&] { return numbers.torsion_jump(); });
  return "smooth";
}

template <class Numbers> Join_words words_of(const Join& join, int dimension, const Numbers& numbers) {
  Join_words words{"(", remark_of(join, numbers)};
  for (int i = 0; i < dimension; ++i) (words.point += i == 0 ? "" : ", ") += numbers.coordinate(i);
  words.point += ')';
  return words;
}

} // namespace

std::string rounded(double x, int digits) {
  char text[64]; // as printf() does with %g, but zero has no sign
  return std::string(text,
                     std::to_chars(text, text + sizeof text, x == 0 ? 0.0 : x, std::chars_format::general, digits).ptr);
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

std::string remark(const Join& join, const Jet& left, const Jet& right) {
  return remark_of(join, Exact_numbers(left, right));
}

std::optional<std::string> remark(const Join& join, const GC::Coordinate_jet<Interval, 2>& left,
                                  const GC::Coordinate_jet<Interval, 2>& right) {
  const Enclosed_numbers<2> numbers(left, right);
  const std::string text = remark_of(join, numbers);
  return numbers.certain() ? std::optional<std::string>(text) : std::nullopt;
}

template <class Span> Join_words join_words(const Join& join, const Span& left, const Span& right) {
  Join_words words;
  bool certain = false;
  Span::visit_enclosures(left, right, [&](const auto& x, const auto& y) {
    const Enclosed_numbers numbers(x, y);
    words = words_of(join, x.dimension(), numbers);
    certain = numbers.certain();
  });
  if (certain) return words;
  const Jet x = left.jets().end_jet(3), y = right.jets().start_jet(3);
  return words_of(join, x.dimension(), Exact_numbers(x, y));
}

std::string table_head() { return "join         orders      point                     remark\n"; }

template <class Span>
void append_table_row(std::string& table, const Join& join, std::size_t left, std::size_t right, const Span& left_span,
                      const Span& right_span) {
  table += padded(std::to_string(left) + " -> " + std::to_string(right), 12);
  table += padded(orders(join), 11);
  Join_words words = join_words(join, left_span, right_span);
  table += padded(std::move(words.point), 25);
  (table += words.remark) += '\n';
}

template Join_words join_words(const Join&, const Program_span<GC::Text_number>&, const Program_span<GC::Text_number>&);
template Join_words join_words(const Join&, const Program_span<double>&, const Program_span<double>&);
template void append_table_row(std::string&, const Join&, std::size_t, std::size_t,
                               const Program_span<GC::Text_number>&, const Program_span<GC::Text_number>&);
template void append_table_row(std::string&, const Join&, std::size_t, std::size_t, const Program_span<double>&,
                               const Program_span<double>&);
