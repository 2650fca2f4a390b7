// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_FORMS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_FORMS_H

#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The two forms of blends, with which one text computes both in a field that is not that of the traits class:
//   ends(x, y, shape): what a strategy reads, from the derivatives of the two curves
//   inner_points(e, p): the control points but the first and the last
//   transform<To>(p, f): the parameters f(s) for each scalar s of p, in order
struct Quintic_form {
  static constexpr int order = 2;
  static constexpr std::size_t inner = 4;
  template <class FT> using Parameters = Quintic_parameters<FT>;
  template <class FT, int N> using Jet = std::array<Coordinate_vector<FT, N>, order + 1>;

  template <class FT, int N>
  static Quintic_ends<FT, N> ends(const Jet<FT, N>& x, const Jet<FT, N>& y, const Shape_parameters<FT>& shape) {
    const FT &beta = shape.beta, &eta = shape.eta;
    return {x[0], y[0], beta * x[1], eta * y[1], FT(beta * beta) * x[2], FT(eta * eta) * y[2]};
  }
  template <class FT, int N>
  static std::array<Coordinate_vector<FT, N>, inner> inner_points(const Quintic_ends<FT, N>& e,
                                                                  const Quintic_parameters<FT>& p) {
    return {e.b1(), e.c1(p.s1), e.c2(p.s2), e.b2()};
  }
  template <class To, class FT, class Function>
  static Quintic_parameters<To> transform(const Quintic_parameters<FT>& p, const Function& f) {
    return {f(p.s1), f(p.s2), p.fallback_start, p.fallback_end};
  }
};

struct Septic_form {
  static constexpr int order = 3;
  static constexpr std::size_t inner = 6;
  template <class FT> using Parameters = Septic_parameters<FT>;
  template <class FT, int N> using Jet = std::array<Coordinate_vector<FT, N>, order + 1>;

  template <class FT, int N>
  static Septic_ends<FT, N> ends(const Jet<FT, N>& x, const Jet<FT, N>& y, const Shape_parameters<FT>& shape) {
    return {{x[0], x[1], x[2], x[3], shape.beta, 1}, {y[0], y[1], y[2], y[3], shape.eta, -1}};
  }
  template <class FT, int N>
  static std::array<Coordinate_vector<FT, N>, inner> inner_points(const Septic_ends<FT, N>& e,
                                                                  const Septic_parameters<FT>& p) {
    const std::array<Coordinate_vector<FT, N>, 8> b = e.control_points(p);
    return {b[1], b[2], b[3], b[4], b[5], b[6]};
  }
  template <class To, class FT, class Function>
  static Septic_parameters<To> transform(const Septic_parameters<FT>& p, const Function& f) {
    return {{f(p.start.beta2), f(p.start.mu), f(p.start.beta3)},
            {f(p.end.beta2), f(p.end.mu), f(p.end.beta3)},
            p.fallback_start,
            p.fallback_end};
  }
};

// The strategies of the package, which may be called in such a field. A strategy of the user is called with the number type
// of the traits class and no other.
template <class Strategy> constexpr bool works_in_every_field = false;
template <> inline constexpr bool works_in_every_field<Matching_second_derivative> = true;
template <> inline constexpr bool works_in_every_field<Normal_offset> = true;
template <> inline constexpr bool works_in_every_field<Minimal_second_derivative> = true;
template <> inline constexpr bool works_in_every_field<Near_line> = true;
template <int k> constexpr bool works_in_every_field<Minimal_energy<k>> = true;
template <class FT> constexpr bool works_in_every_field<Given_parameters<FT>> = true;
template <> inline constexpr bool works_in_every_field<Matching_third_derivative> = true;
template <> inline constexpr bool works_in_every_field<Sequential_g3> = true;
template <> inline constexpr bool works_in_every_field<Sequential_f3> = true;
template <> inline constexpr bool works_in_every_field<Joint_g3> = true;
template <int k> constexpr bool works_in_every_field<Minimal_energy_g3<k>> = true;
template <class FT> constexpr bool works_in_every_field<Given_end_parameters<FT>> = true;

// The control points of a blend, and what its strategy chose.
template <class Form, class FT, int N> struct Control_points_of_blend {
  std::array<Coordinate_vector<FT, N>, Form::inner + 2> points;
  typename Form::template Parameters<FT> parameters;
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_FORMS_H
