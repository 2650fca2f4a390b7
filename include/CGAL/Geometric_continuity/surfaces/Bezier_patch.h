// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/internal/Control_net.h>
#include <CGAL/Geometric_continuity/surfaces/internal/tensor_product_jet.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Bezier_patch.h
/// Bézier patches; and by name, for all surfaces, the four edges and the lines on which one of the
/// parameters is constant.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The edges of a rectangular patch on [a, b] x [c, d]. Each runs in the direction of its growing
/// parameter.
enum class Patch_edge {
  u0, ///< `u = a`, parametrised by `v`
  u1, ///< `u = b`, parametrised by `v`
  v0, ///< `v = c`, parametrised by `u`
  v1, ///< `v = d`, parametrised by `u`
#ifndef CGAL_NO_DEPRECATED_CODE
  /// \cond SKIP_IN_MANUAL
  U_MIN [[deprecated("the edge is Patch_edge::u0")]] = u0,
  U_MAX [[deprecated("the edge is Patch_edge::u1")]] = u1,
  V_MIN [[deprecated("the edge is Patch_edge::v0")]] = v0,
  V_MAX [[deprecated("the edge is Patch_edge::v1")]] = v1
/// \endcond
#endif
};

/// \ingroup PkgGeometricContinuitySurfaces
/// All edges, in the order of the enumeration.
constexpr std::array<Patch_edge, 4> patch_edges = {Patch_edge::u0, Patch_edge::u1, Patch_edge::v0, Patch_edge::v1};

/// \ingroup PkgGeometricContinuitySurfaces
/// Tells whether an edge is parametrised by `u`.
inline bool runs_along_u(Patch_edge edge) { return edge == Patch_edge::v0 || edge == Patch_edge::v1; }

/// \ingroup PkgGeometricContinuitySurfaces
/// Tells whether an edge lies at the upper end of the parameter that is constant on it.
inline bool at_upper_end(Patch_edge edge) { return edge == Patch_edge::u1 || edge == Patch_edge::v1; }

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the name of an edge, as spelled in the enumeration.
inline std::string to_string(Patch_edge edge) {
  return std::string(runs_along_u(edge) ? "v" : "u") + (at_upper_end(edge) ? '1' : '0');
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Writes the name of an edge.
inline std::ostream& operator<<(std::ostream& os, Patch_edge edge) { return os << to_string(edge); }

/// \ingroup PkgGeometricContinuitySurfaces
/// The direction of the second of two edges compared with the first one.
enum class Edge_direction {
  same,    ///< forwards
  opposite ///< backwards
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The two kinds of parameter lines of a surface.
enum class Parameter_line {
  along_u, ///< `v` is constant
  along_v  ///< `u` is constant
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The two parts of a surface beside a parameter line.
enum class Line_side {
  smaller_parameters, ///< where the parameter that is constant on the line is smaller
  larger_parameters   ///< where it is larger
};

namespace internal {

template <class Traits> class Blended_columns; // of a blend, checks its points

// The parameter u as a fraction of the interval: 0 at its lower end, 1 at its upper end.
template <class FT> FT local_parameter(const FT& u, const std::pair<FT, FT>& interval) {
  return FT((u - interval.first) / (interval.second - interval.first));
}

// The knots of a Bezier curve of degree p.
template <class FT> struct Bezier_knots {
  int p;
  const std::pair<FT, FT>& domain;
  const FT& operator[](int i) const { return i <= p ? domain.first : domain.second; }
};

// The jet of order k at (u, v) of the patch of degree p x q on the rectangle `domain_u` x
// `domain_v`: first the derivatives in v of the control points of all rows, then those in u.
// coordinate(i, j, x) is the coordinate number x < d of a control point. Inside of the domain,
// floating-point code takes the weights of a spline.
template <class Traits, class Coordinate>
Surface_jet<Traits> bezier_jet(int p, int q, int d, const std::pair<typename Traits::FT, typename Traits::FT>& domain_u,
                               const std::pair<typename Traits::FT, typename Traits::FT>& domain_v,
                               const typename Traits::FT& u, const typename Traits::FT& v, int k,
                               Coordinate coordinate) {
  typedef typename Traits::FT FT;
  constexpr int N = dimension_v<Traits>,
                // all coordinates together where the compiler knows how many
      width = N == 0 ? 1 : N;
  typedef Coordinate_vector<FT, width> Block;
  typedef boost::container::small_vector<Block, 6> Blocks;
  Surface_jet<Traits> jet(d, k);
  if constexpr (std::is_floating_point_v<FT>)
    if (domain_u.first < u && u < domain_u.second && domain_v.first < v && v < domain_v.second) {
      const Derivative_table<FT> weights_u(Bezier_knots<FT>{p, domain_u}, p, p, u, k),
          weights_v(Bezier_knots<FT>{q, domain_v}, q, q, v, k);
      write_derivatives(weights_u, weights_v, coordinate, jet);
      return jet;
    }
  const FT s = local_parameter(u, domain_u), t = local_parameter(v, domain_v);
  const FT hu = FT(domain_u.second - domain_u.first), hv = FT(domain_v.second - domain_v.first);
  // equivalent [1 -> 2, 3]: memory only derivatives with respect to v
  Blocks row(q + 1), column(p + 1), rows(static_cast<std::size_t>(k + 1) * (p + 1));
  for (int x = 0; x < d; x += width) {
    for (int i = 0; i <= p; ++i) {
      for (int j = 0; j <= q; ++j)
        for (int l = 0; l < width; ++l) row[j][l] = coordinate(i, j, x + l);
      bernstein_derivatives(
          row, q, t, k, [&](int j, const Block& value) { rows[static_cast<std::size_t>(j) * (p + 1) + i] = value; });
    }
    FT scale_v(1);
    for (int j = 0; j <= k; ++j) {
      FT scale = scale_v;
      for (int i = 0; i <= p; ++i) column[i] = rows[static_cast<std::size_t>(j) * (p + 1) + i];
      bernstein_derivatives(column, p, s, k - j, [&](int i, const Block& value) {
        for (int l = 0; l < width; ++l) jet(i, j)[x + l] = value[l] / scale;
        scale *= hu;
      });
      scale_v *= hv;
    }
  }
  return jet;
}

// The rows 0 to k at an edge of degree m of a patch of degree n across it, see
// `Bezier_patch::rows()`. point(i, j) is the control point number i along the edge in the layer j,
// in `Field`, with d coordinates.
template <class Field, int N, class Point>
std::vector<std::vector<Coordinate_vector<Field, N>>> bezier_rows(int m, int n, int d, int k, Point point) {
  typedef Coordinate_vector<Field, N> Vector;
  check_count(k, "Bezier_patch: rows");
  const int last = (std::min)(k, n);
  std::vector<std::vector<Vector>> rows(k + 1, std::vector<Vector>(m + 1, Vector(d)));
  std::vector<Vector> layers(last + 1, Vector(d));
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= last; ++j) layers[j] = point(i, j);
    Field factor(1);
    for (int r = 0; r <= last; ++r) {
      rows[r][i] = factor * layers[0];
      difference_step(layers, last - r);
      factor *= Field(n - r);
    }
  }
  return rows;
}

// The net of the degree in u raised by `times`.
template <class Traits> Control_net<Traits> elevate_rows(const Control_net<Traits>& net, int times) {
  const int p = net.rows() - 1, q = net.columns() - 1;
  std::vector<typename Traits::Point> points(static_cast<std::size_t>(p + times + 1) * (q + 1), net(0, 0));
  for (int j = 0; j <= q; ++j) {
    std::vector<Coordinates<Traits>> c = net.column(j);
    c.resize(p + times + 1, Coordinates<Traits>(net.dimension()));
    for (int n = p; n < p + times; ++n) bernstein_elevate<typename Traits::FT>(c, n);
    for (int i = 0; i <= p + times; ++i) points[static_cast<std::size_t>(i) * (q + 1) + j] = to_point<Traits>(c[i]);
  }
  return Control_net<Traits>(p + times + 1, q + 1, std::move(points), "Bezier_patch");
}

// The nets of the two parts, of which the first takes the fraction t of the interval of u.
template <class Traits>
std::pair<Control_net<Traits>, Control_net<Traits>> split_rows(const Control_net<Traits>& net,
                                                               const typename Traits::FT& t) {
  const int p = net.rows() - 1, q = net.columns() - 1;
  std::vector<typename Traits::Point> left(net.begin(), net.end()), right(left);
  for (int j = 0; j <= q; ++j) {
    std::vector<Coordinates<Traits>> r = net.column(j), l(r);
    bernstein_split(r, p, t, l);
    for (int i = 0; i <= p; ++i) {
      left[static_cast<std::size_t>(i) * (q + 1) + j] = to_point<Traits>(l[i]);
      right[static_cast<std::size_t>(i) * (q + 1) + j] = to_point<Traits>(r[i]);
    }
  }
  return {Control_net<Traits>(p + 1, q + 1, std::move(left), "Bezier_patch"),
          Control_net<Traits>(p + 1, q + 1, std::move(right), "Bezier_patch")};
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// A tensor-product Bézier patch
/// \f$ S(u, v) = \sum_{i=0}^p \sum_{j=0}^q b_{ij} B_i^p\left(\frac{u-a}{b-a}\right) B_j^q\left(\frac{v-c}{d-c}\right) \f$
/// on the domain [a, b] x [c, d], by default the unit square. All derivatives are taken with
/// respect to the parameters of the domain, unless stated otherwise. The patch is a value:
/// operations return new patches. With an exact kernel they are exact.
///
/// With floating-point numbers a result that overflows is refused: all functions that compute
/// points throw `Error` with `not_finite` instead of returning infinite numbers or NaN.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \cgalModels{ParametricSurface}
template <class Traits_> class Bezier_patch : public Surface_evaluation<Bezier_patch<Traits_>, Traits_> {
  typedef Surface_evaluation<Bezier_patch<Traits_>, Traits_> Base;

public:
  using Base::N;
  using typename Base::FT;
  using typename Base::Interval;
  using typename Base::Point;
  using typename Base::Traits;

  /// A row of coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, N>>;

private:
  typedef internal::Control_net<Traits> Net;
  template <class Shape> friend class Rational_surface; // takes and gives the net as it is
  template <class T> friend class internal::Blended_columns;

  Net net_;
  Interval u_, v_;

public:
  typedef typename Net::const_iterator const_iterator; ///< an iterator over control points

  /// Constructs a patch from a control net and the domain [a, b] x [c, d]. `net[i]` is the range
  /// \f$ b_{i0}, \dots, b_{iq} \f$.
  /// \throws Error `wrong_number_of_points` for a net without points or with rows of different
  ///   lengths, `dimension_mismatch` when the points differ in dimension, `empty_domain` unless
  ///   `a < b` and `c < d`, `not_finite` for floating-point coordinates, ends of the domain or
  ///   lengths of the domain that are infinite or not a number
  template <class Points>
  explicit Bezier_patch(const Points& net, const Interval& u = unit_interval(), const Interval& v = unit_interval())
      : Bezier_patch(Net(net, "Bezier_patch"), u, v) {}
  /// Constructs a patch from a control net that is written as a list of lists, and its domain.
  /// \throws Error `wrong_number_of_points`, `dimension_mismatch`, `empty_domain` or `not_finite`
  ///   for what is no net of points or no domain
  explicit Bezier_patch(std::initializer_list<std::initializer_list<Point>> net, const Interval& u = unit_interval(),
                        const Interval& v = unit_interval())
      : Bezier_patch(Net(net, "Bezier_patch"), u, v) {}

  /// Constructs a patch of the degrees `p` and `q` from the points
  /// \f$ b_{00}, b_{01}, \dots, b_{pq} \f$, and its domain.
  /// \throws Error as the constructor from a net
  Bezier_patch(int p, int q, std::vector<Point> points, const Interval& u = unit_interval(),
               const Interval& v = unit_interval())
      : Bezier_patch(Net(p + 1, q + 1, std::move(points), "Bezier_patch"), u, v) {}

  // These refuse points that are not in rows, and degrees behind them.
  template <class Given, class = std::enable_if_t<std::is_same_v<Given, Point>>>
  explicit Bezier_patch(std::initializer_list<Given> points) : Bezier_patch(std::vector<Given>(points)) {}
  template <class... Points, class = std::enable_if_t<(std::is_same_v<Points, Point> && ...)>>
  Bezier_patch(const Point& first, const Point&, const Point&, const Points&...)
      : Bezier_patch(std::vector<Point>{first}) {}
  template <class Points> Bezier_patch(const Points&, int p, int q) : Bezier_patch(p, q, std::vector<Point>()) {
    static_assert(!std::is_same_v<Points, Points>, "Bezier_patch<Traits>(p, q, points) takes the degrees before the "
                                                   "points b_00, b_01, ..., b_pq, Bezier_patch<Traits>(net) the rows");
  }

  int degree_u() const { return net_.rows() - 1; }    ///< Returns the degree `p` in `u`.
  int degree_v() const { return net_.columns() - 1; } ///< Returns the degree `q` in `v`.
  int dimension() const { return net_.dimension(); }  ///< Returns the dimension of the space.
  Interval domain_u() const { return u_; }            ///< Returns [a, b].
  Interval domain_v() const { return v_; }            ///< Returns [c, d].

  /// Returns the control point \f$ b_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  const Point& control_point(int i, int j) const { return net_(i, j); }
  /// Returns the coordinates of \f$ b_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  Coordinates<Traits> coordinates(int i, int j) const { return net_.coordinates(i, j); }

  /// Returns the begin of \f$ b_{00}, b_{01}, \dots, b_{pq} \f$.
  const_iterator begin() const { return net_.begin(); }
  const_iterator end() const { return net_.end(); } ///< Returns the end of the control points.

  /// \name Evaluation
  /// The parameters may lie outside the domain: the polynomial is extended.
  /// @{

  /// Returns the point at (`u`, `v`). \f$ O(pq^2 + p^2) \f$
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0` at (`u`, `v`). \f$ O(pq^2 + kp^2 + pk^3) \f$
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    const Traits traits;
    const Surface_jet<Traits> jet =
        internal::bezier_jet<Traits>(degree_u(), degree_v(), dimension(), u_, v_, u, v, k, [&](int i, int j, int x) {
          return FT(traits.compute_coordinate_object()(net_(i, j), x));
        });
    internal::check_jet(jet, "Bezier_patch: jet");
    return jet;
  }

  /// @}
  /// \name Edges
  /// @{

  /// Returns the degree of an edge.
  int degree_along(Patch_edge edge) const { return runs_along_u(edge) ? degree_u() : degree_v(); }
  /// Returns the degree in the parameter that is constant on an edge.
  int degree_across(Patch_edge edge) const { return runs_along_u(edge) ? degree_v() : degree_u(); }
  /// Returns the domain of an edge.
  Interval domain(Patch_edge edge) const { return runs_along_u(edge) ? u_ : v_; }

  /// Returns the control point number `i` along the edge in the layer `j`, where layer 0 is the
  /// edge itself.
  /// \pre `0 <= i <= degree_along(edge)`, `0 <= j <= degree_across(edge)`
  const Point& control_point(Patch_edge edge, int i, int j) const {
    const int inward = at_upper_end(edge) ? degree_across(edge) - j : j;
    return runs_along_u(edge) ? control_point(i, inward) : control_point(inward, i);
  }

  /// Returns the rows 0 to `k` at an edge: the Bernstein coefficients, along the edge, of the edge
  /// and of the first `k` derivatives across it, where the patch is taken on the unit square and
  /// turned so that the edge is at `v = 0`: \f$ \frac{q!}{(q-r)!} \Delta^r b_{i0} \f$, differences
  /// into the patch. Rows beyond the degree are zero. The control points are converted to `Field`
  /// before anything is computed. \f$ O(pk^2) \f$ for an edge of degree `p`
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    return internal::bezier_rows<Field, N>(degree_along(edge), degree_across(edge), dimension(), k, [&](int i, int j) {
      return Geometric_continuity::coordinates<Traits, Field>(control_point(edge, i, j));
    });
  }

  /// Returns the patch turned so that the edge is at `v = 0` and keeps its direction.
  Bezier_patch oriented(Patch_edge edge) const {
    const Bezier_patch r = runs_along_u(edge) ? *this : swap_parameters();
    return at_upper_end(edge) ? r.reverse_v() : r;
  }

  /// @}
  /// \name Operations
  /// @{

  /// Returns the patch \f$ (u, v) \mapsto S(v, u) \f$.
  Bezier_patch swap_parameters() const { return Bezier_patch(net_.transpose(), v_, u_); }

  /// Returns the patch \f$ (u, v) \mapsto S(a + b - u, v) \f$.
  Bezier_patch reverse_u() const { return Bezier_patch(net_.reverse_rows(), u_, v_); }

  /// Returns the patch \f$ (u, v) \mapsto S(u, c + d - v) \f$.
  Bezier_patch reverse_v() const { return swap_parameters().reverse_u().swap_parameters(); }

  /// Returns a patch with the same points whose degrees are raised by `times_u` and `times_v`.
  /// \throws Error `negative_count` for a negative number, `work_limit` for a degree that would be
  ///   raised above 4096
  Bezier_patch elevate(int times_u, int times_v) const {
    internal::check_elevation(degree_u(), times_u, "Bezier_patch: elevate in u");
    internal::check_elevation(degree_v(), times_v, "Bezier_patch: elevate in v");
    const Net in_u = times_u == 0 ? net_ : internal::elevate_rows(net_, times_u);
    return Bezier_patch(times_v == 0 ? in_u : internal::elevate_rows(in_u.transpose(), times_v).transpose(), u_, v_);
  }

  /// Returns the parts on [a, u] and [u, b].
  /// \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Bezier_patch, Bezier_patch> split_u(const FT& u) const {
    if (!(u_.first < u && u < u_.second)) throw Error(Error_code::parameter_outside_domain, "Bezier_patch: split");
    const std::pair<Net, Net> parts = internal::split_rows(net_, internal::local_parameter(u, u_));
    return {Bezier_patch(parts.first, Interval(u_.first, u), v_),
            Bezier_patch(parts.second, Interval(u, u_.second), v_)};
  }

  /// Returns the parts on [c, v] and [v, d].
  /// \throws Error `parameter_outside_domain` unless `c < v < d`
  std::pair<Bezier_patch, Bezier_patch> split_v(const FT& v) const {
    const std::pair<Bezier_patch, Bezier_patch> parts = swap_parameters().split_u(v);
    return {parts.first.swap_parameters(), parts.second.swap_parameters()};
  }

  /// Returns the patch with the same control points on another domain.
  /// \throws Error `empty_domain` for a length that is not positive, `not_finite` for an end or a
  ///   length that is not finite
  Bezier_patch with_domain(const Interval& u, const Interval& v) const { return Bezier_patch(net_, u, v); }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Bezier_patch transform(const Transformation& map) const {
    return Bezier_patch(net_.transform(map, "Bezier_patch: image"), u_, v_);
  }

  /// Returns two opposite corners of the bounding box of the control points, which contains the
  /// patch.
  std::pair<Point, Point> bounding_box() const { return internal::corners_of_box<Traits>(begin(), end()); }

  /// Returns the bounding box of the control points as `Bbox_2` or `Bbox_3`, rounded outwards.
  /// Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(bounding_box()); }

  /// @}

  /// Tells whether domains, degrees and control points are equal.
  friend bool operator==(const Bezier_patch& s, const Bezier_patch& t) {
    return s.u_ == t.u_ && s.v_ == t.v_ && s.net_ == t.net_;
  }
  /// Tells whether a domain, a degree or a control point differs.
  friend bool operator!=(const Bezier_patch& s, const Bezier_patch& t) { return !(s == t); }

  /// Writes the degrees, the domain and the control net, one row \f$ b_{i0}, \dots, b_{iq} \f$ to a
  /// line.
  friend std::ostream& operator<<(std::ostream& os, const Bezier_patch& s) {
    return os << "Bezier patch of degree " << s.degree_u() << " x " << s.degree_v() << " on [" << s.u_.first << ", "
              << s.u_.second << "] x [" << s.v_.first << ", " << s.v_.second << "]:" << s.net_;
  }

private:
  struct Correct_by_construction {};
  Bezier_patch(Net net, const Interval& u, const Interval& v, Correct_by_construction)
      : net_(std::move(net)), u_(u), v_(v) {}

  static Interval unit_interval() { return Interval(FT(0), FT(1)); }

  Bezier_patch(Net net, const Interval& u, const Interval& v)
      : Bezier_patch(std::move(net), u, v, Correct_by_construction()) {
    internal::check_interval(u_, "Bezier_patch: domain in u");
    internal::check_interval(v_, "Bezier_patch: domain in v");
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a patch as a Bézier curve on the domain of the edge; its control points are
/// those of the patch along the edge. \f$ O(p) \f$ for an edge of degree `p`
template <class Traits> Bezier_curve<Traits> boundary_curve(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  const typename Bezier_patch<Traits>::Interval domain = patch.domain(edge);
  std::vector<typename Traits::Point> points;
  for (int i = 0; i <= patch.degree_along(edge); ++i) points.push_back(patch.control_point(edge, i, 0));
  return Bezier_curve<Traits>(points.begin(), points.end(), domain.first, domain.second);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H
