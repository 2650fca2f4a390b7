// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_START_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_START_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>

#include <array>
#include <cmath>

// Where the search for the fairest blend of a family starts: blends of least energy, and fair ones with less freedom.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The blend of least energy with the automatic shape, times e^a at the start and e^b at the end.
template <Blend_kind kind, int M>
typename Fair_family<kind, M>::Unknowns least_energy(const Fair_family<kind, M>& f, double a = 0, double b = 0) {
  typedef Coordinate_vector<double, M> Vector;
  const double beta = std::exp(a), eta = std::exp(b);
  const Vector origin(M);
  if constexpr (kind == Blend_kind::g2) {
    const Quintic_parameters<double> p =
        Minimal_energy<3>()(Quintic_ends<double, M>(origin, f.chord, beta * f.start.d[0], eta * f.end.d[0],
                                                    (beta * beta) * f.start.d[1], (eta * eta) * f.end.d[1]));
    return {a, 20 * p.s1, b, 20 * p.s2};
  } else {
    const std::array<Vector, 4> phi = {origin, f.start.d[0], f.start.d[1], f.start.d[2]},
                                psi = {f.chord, f.end.d[0], f.end.d[1], f.end.d[2]};
    const Septic_parameters<double> p =
        Minimal_energy_g3<4>()(Septic_ends<double, M>(phi, psi, Shape_parameters<double>(beta, eta)));
    if constexpr (kind == Blend_kind::g3)
      return {a, p.start.beta2 / beta, p.start.beta3 / beta, b, p.end.beta2 / eta, p.end.beta3 / eta};
    else
      return {a, p.start.beta2 / beta, p.start.beta3 / beta, p.start.mu / (beta * beta),
              b, p.end.beta2 / eta,    p.end.beta3 / eta,    p.end.mu / (eta * eta)};
  }
}

// G2 for G3, and G3 for F3.
constexpr Blend_kind simpler_kind(Blend_kind kind) { return kind == Blend_kind::f3 ? Blend_kind::g3 : Blend_kind::g2; }

template <Blend_kind kind, int M> Fair_family<simpler_kind(kind), M> simpler_family(const Fair_family<kind, M>& f) {
  constexpr Blend_kind simpler = simpler_kind(kind);
  const auto end = [](const Fair_end<kind, M>& e) {
    Fair_end<simpler, M> s;
    for (int k = 0; k < Fair_end<simpler, M>::order; ++k) s.d[k] = e.d[k];
    s.direction = e.direction;
    return s;
  };
  return {f.chord, end(f.start), end(f.end)};
}

// A G3 end from a G2 one, with the tangential part of its third derivative g3.
template <int M>
typename Fair_end<Blend_kind::g3, M>::Unknowns
with_more_freedom(const Fair_end<Blend_kind::g3, M>& end, const typename Fair_end<Blend_kind::g2, M>::Unknowns& x,
                  const Coordinate_vector<double, M>& g3) {
  const double e = std::exp(x[0]);
  const Coordinate_vector<double, M> u = e * end.d[0], w = (e * e) * end.d[1], z = (e * e * e) * end.d[2];
  return {x[0], x[1], dot(g3 - z - (3 * x[1]) * w, u) / dot(u, u)};
}

// The blend of this kind that is the given one of a simpler kind, or as near to it as possible.
template <int M>
typename Fair_family<Blend_kind::f3, M>::Unknowns
with_more_freedom(const Fair_family<Blend_kind::f3, M>&, const Fair_family<Blend_kind::g3, M>&,
                  const typename Fair_family<Blend_kind::g3, M>::Unknowns& x) {
  return {x[0], x[1], x[2], 3 * x[1], x[3], x[4], x[5], 3 * x[4]};
}
template <int M>
typename Fair_family<Blend_kind::g3, M>::Unknowns
with_more_freedom(const Fair_family<Blend_kind::g3, M>& f, const Fair_family<Blend_kind::g2, M>& simpler,
                  const typename Fair_family<Blend_kind::g2, M>::Unknowns& x) {
  const typename Fair_family<Blend_kind::g2, M>::Points b = simpler.points(x); // without the origin
  const auto s = with_more_freedom<M>(f.start, {x[0], x[1]}, 60. * (b[2] - 3. * b[1] + 3. * b[0])),
             e = with_more_freedom<M>(f.end, {x[2], x[3]}, 60. * (b[4] - 3. * b[3] + 3. * b[2] - b[1]));
  return {s[0], s[1], s[2], e[0], e[1], e[2]};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_START_H
