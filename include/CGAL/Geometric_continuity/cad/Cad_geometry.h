// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_CAD_GEOMETRY_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_CAD_GEOMETRY_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

/// \file Cad_geometry.h
/// The curves and surfaces of models that other systems have made, by the floating-point numbers
/// that these hold.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCadEdges
/// Coordinates in the space of dimension `D`.
template <int D> using Cad_point = std::array<double, D>;

/// \ingroup PkgGeometricContinuityCadEdges
/// \f$ o + t\,d \f$
template <int D> struct Cad_line { Cad_point<D> origin, direction; };

/// \ingroup PkgGeometricContinuityCadEdges
/// A conic with the axes \f$ x, y \f$ as given, which are orthogonal unit vectors up to rounding
/// only: the ellipse \f$ o + a \cos t\,x + b \sin t\,y \f$, the hyperbola
/// \f$ o + a \cosh t\,x + b \sinh t\,y \f$, or the parabola \f$ o + t^2/(4a)\,x + t\,y \f$ of the
/// focal length \f$ a \f$.
template <int D> struct Cad_conic {
  enum class Kind { ellipse, hyperbola, parabola };
  Kind kind;
  Cad_point<D> centre, x_axis, y_axis;
  double a, b; ///< the radii; of a parabola the focal length, and 0
};

/// \ingroup PkgGeometricContinuityCadEdges
/// A B-spline curve, rational if it has weights. It has as many knots as control points plus the
/// degree plus one, clamped or not; its domain is that between the knots of the numbers `degree`
/// and `points.size()`. Bézier curves are such curves.
template <int D> struct Cad_spline_curve {
  int degree;
  std::vector<double> knots;
  std::vector<Cad_point<D>> points; ///< not multiplied by the weights
  std::vector<double> weights;      ///< empty, or as many as points
};

template <int D> struct Cad_offset_curve;

/// \ingroup PkgGeometricContinuityCadEdges
/// Any curve.
template <int D> using Cad_curve = std::variant<Cad_line<D>, Cad_conic<D>, Cad_spline_curve<D>, Cad_offset_curve<D>>;

/// \ingroup PkgGeometricContinuityCadEdges
/// In the plane \f$ c + d\,(c'_y, -c'_x) / |c'| \f$; in space
/// \f$ c + d\,(c' \times r) / |c' \times r| \f$ for a reference direction.
template <int D> struct Cad_offset_curve {
  std::shared_ptr<const Cad_curve<D>> basis;
  double distance;
  Cad_point<D> reference;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// A point and three axes as given, which are orthogonal unit vectors up to rounding only.
struct Cad_frame {
  Cad_point<3> origin, x_axis, y_axis, z_axis;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// A surface that rotates a curve about an axis of its frame, by numbers. With
/// \f$ R = \cos u\,x + \sin u\,y \f$: plane \f$ o + u\,x + v\,y \f$, cylinder
/// \f$ o + r\,R + v\,z \f$, cone \f$ o + (r + v \sin\alpha) R + v \cos\alpha\,z \f$, sphere
/// \f$ o + r \cos v\,R + r \sin v\,z \f$, torus \f$ o + (r + q \cos v) R + q \sin v\,z \f$.
struct Cad_elementary_surface {
  enum class Kind { plane, cylinder, cone, sphere, torus };
  Kind kind;
  Cad_frame frame;
  double radius = 0; ///< \f$ r \f$
  /// the angle \f$ \alpha \f$ of a cone in radians, the small radius \f$ q \f$ of a torus
  double other = 0;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// A B-spline surface, rational if it has weights; knots as in `Cad_spline_curve`. The point of the
/// indices `i` in \f$ u \f$ and `j` in \f$ v \f$ is `points[i * v_points + j]`.
struct Cad_spline_surface {
  int u_degree, v_degree;
  std::vector<double> u_knots, v_knots;
  std::vector<Cad_point<3>> points;
  std::vector<double> weights;

  int v_points() const { return static_cast<int>(v_knots.size()) - v_degree - 1; }
};

/// \ingroup PkgGeometricContinuityCadEdges
/// \f$ c(u) + v\,d \f$
struct Cad_extrusion {
  Cad_curve<3> profile;
  Cad_point<3> direction;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// The curve \f$ c(v) \f$, rotated by the angle \f$ u \f$ about the axis through `origin` in the
/// direction \f$ d \f$, a unit vector up to rounding: with \f$ w = c - o \f$ the point
/// \f$ o + (w \cdot d)\,d + \cos u\,(w - (w \cdot d)\,d) + \sin u\,(d \times w) \f$.
struct Cad_revolution {
  Cad_curve<3> profile;
  Cad_point<3> origin, direction;
};

struct Cad_offset_surface;

/// \ingroup PkgGeometricContinuityCadEdges
/// Any surface.
using Cad_surface =
    std::variant<Cad_elementary_surface, Cad_spline_surface, Cad_extrusion, Cad_revolution, Cad_offset_surface>;

/// \ingroup PkgGeometricContinuityCadEdges
/// \f$ S + d\,N / |N| \f$ with \f$ N = S_u \times S_v \f$
struct Cad_offset_surface {
  std::shared_ptr<const Cad_surface> basis;
  double distance;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// The map \f$ x \mapsto M x + t \f$ by its rows \f$ (M, t) \f$: a placement.
typedef std::array<std::array<double, 4>, 3> Cad_placement;

/// \ingroup PkgGeometricContinuityCadEdges
/// One side of an edge: the surface of a face, where it is placed, and the edge as a curve in its
/// parameter plane. The edge is the image \f$ P(S(c(t))) \f$ of the interval of both sides.
struct Edge_side {
  std::shared_ptr<const Cad_surface> surface;
  std::shared_ptr<const Cad_curve<2>> curve;
  Cad_placement placement;
  /// the normal of the face is that of the surface times -1 (a mirror in the placement is not
  /// counted)
  bool reversed;
  /// On which side of the curve the face lies in the parameter plane: 1 left of it (where the
  /// normal (-c'_y, c'_x) points), -1 right of it, 0 not known. It matters where the curve runs
  /// along a knot line on which the surface is not smooth.
  int face_side = 0;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// An edge as a curve in space, \f$ P(C(t)) \f$ at the parameters of its sides.
struct Edge_curve {
  std::shared_ptr<const Cad_curve<3>> curve;
  Cad_placement placement;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// An end of an edge that is a curve in space, such as one of a wire, or a side of a knot inside.
struct Edge_end {
  Edge_curve curve;
  double parameter;      ///< the parameter of the end
  bool reversed = false; ///< whether the edge runs against its parameter
};

/// \ingroup PkgGeometricContinuityCadEdges
/// A parameter line on which the formula of a surface changes, so that it may have a crease there.
struct Surface_knot_line {
  bool constant_u; ///< the knot is one of `u`, and `v` varies on the line; otherwise the reverse
  double knot;     ///< the constant parameter
};

namespace internal {

// The knots over which a parameter runs, if it is that of a spline: of a curve, of a profile, or of
// what an offset has been taken.
struct Spline_parameter {
  const std::vector<double>* knots = nullptr; // null for other parameters
  int degree = 0;
  int offsets = 0; // so many have been taken: each is less smooth by an order

  explicit operator bool() const { return knots != nullptr; }
  double first() const { return (*knots)[static_cast<std::size_t>(degree)]; }
  double last() const { return (*knots)[knots->size() - static_cast<std::size_t>(degree) - 1]; }

  // Calls f(knot, multiplicity) for each knot inside of the domain.
  template <class Function> void for_each_inner_knot(const Function& f) const {
    if (!knots) return;
    const auto end = knots->end() - degree - 1;
    for (auto i = std::upper_bound(knots->begin() + degree + 1, end, first()); i < end && *i < last();) {
      const auto next = std::upper_bound(i, end, *i);
      f(*i, static_cast<int>(next - i));
      i = next;
    }
  }
};

template <int D> Spline_parameter spline_parameter(const Cad_curve<D>& curve) {
  if (const auto* spline = std::get_if<Cad_spline_curve<D>>(&curve)) return {&spline->knots, spline->degree, 0};
  const auto* offset = std::get_if<Cad_offset_curve<D>>(&curve);
  if (!offset) return {};
  Spline_parameter of_basis = spline_parameter(*offset->basis);
  ++of_basis.offsets;
  return of_basis;
}
// Both parameters of a surface, u and v.
inline std::array<Spline_parameter, 2> spline_parameters(const Cad_surface& surface) {
  std::array<Spline_parameter, 2> of;
  if (const auto* s = std::get_if<Cad_spline_surface>(&surface)) {
    of[0] = {&s->u_knots, s->u_degree, 0};
    of[1] = {&s->v_knots, s->v_degree, 0};
  }
  if (const auto* extrusion = std::get_if<Cad_extrusion>(&surface)) of[0] = spline_parameter(extrusion->profile);
  if (const auto* revolution = std::get_if<Cad_revolution>(&surface)) of[1] = spline_parameter(revolution->profile);
  if (const auto* offset = std::get_if<Cad_offset_surface>(&surface)) {
    of = spline_parameters(*offset->basis);
    for (Spline_parameter& x : of) ++x.offsets;
  }
  return of;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCadEdges
/// Returns the knots inside of the domain of a curve where it need not be `order` times
/// continuously differentiable: of a multiplicity greater than the degree minus `order`, of offsets
/// one less.
/// \pre the numbers of the spline fit
inline std::vector<double> curve_knots(const Cad_curve<3>& curve, int order) {
  std::vector<double> knots;
  const internal::Spline_parameter x = internal::spline_parameter(curve);
  x.for_each_inner_knot([&](double knot, int multiplicity) {
    if (multiplicity > x.degree - order - x.offsets) knots.push_back(knot);
  });
  return knots;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Returns the lines inside of the domain of a surface where it need not be `order` times
/// continuously differentiable: at inner knots of a multiplicity greater than the degree minus
/// `order`, of offsets one less; first those of `u` and then those of `v`. The two sides of such a
/// line are two `Edge_side`s of one surface and one curve, with `Edge_side::face_side` 1 and -1.
/// \pre the numbers of the splines fit
inline std::vector<Surface_knot_line> surface_knot_lines(const Cad_surface& surface, int order) {
  std::vector<Surface_knot_line> lines;
  const std::array<internal::Spline_parameter, 2> parameters = internal::spline_parameters(surface);
  for (const bool constant_u : {true, false}) {
    const internal::Spline_parameter& x = parameters[constant_u ? 0 : 1];
    x.for_each_inner_knot([&](double knot, int multiplicity) {
      if (multiplicity > x.degree - order - x.offsets) lines.push_back({constant_u, knot});
    });
  }
  return lines;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_CAD_GEOMETRY_H
