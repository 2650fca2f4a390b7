// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A tensor-product Bézier patch
/// \f$ S(u, v) = \sum_{i=0}^p \sum_{j=0}^q b_{ij} B_i^p\left(\frac{u-a}{b-a}\right) B_j^q\left(\frac{v-c}{d-c}\right) \f$ on the
/// domain [a, b] x [c, d], by default the unit square. All derivatives are taken with respect to the parameters of the
/// domain, unless stated otherwise. The patch is a value: operations return new patches. With an exact kernel they are exact.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \models ParametricSurface
template <class Traits_> class Bezier_patch {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef std::pair<FT, FT> Interval;
  static constexpr int N = dimension_v<Traits>;

  /// A row of coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, N>>;

private:
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  int p_ = 0, q_ = 0;
  std::vector<Point> points_; // b_ij at i (q+1) + j
  Interval u_, v_;

public:
  typedef typename std::vector<Point>::const_iterator const_iterator;

  /// From a control net and the domain [a, b] x [c, d]. `net[i]` is the range \f$ b_{i0}, \dots, b_{iq} \f$.
  /// \throws Error `wrong_number_of_points` for a net without points or with rows of different lengths,
  ///   `dimension_mismatch` when the points differ in dimension, `empty_domain` unless `a < b` and `c < d`, `not_finite`
  template <class Net>
  explicit Bezier_patch(const Net& net, const Interval& u = unit_interval(), const Interval& v = unit_interval())
      : u_(u), v_(v) {
    take(net);
  }
  explicit Bezier_patch(std::initializer_list<std::initializer_list<Point>> net, const Interval& u = unit_interval(),
                        const Interval& v = unit_interval())
      : u_(u), v_(v) {
    take(net);
  }

  /// The degree `p` in `u`.
  int degree_u() const { return p_; }
  /// The degree `q` in `v`.
  int degree_v() const { return q_; }
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// The control point \f$ b_{ij} \f$, `0 <= i <= degree_u()`, `0 <= j <= degree_v()`.
  const Point& control_point(int i, int j) const { return points_[i * (q_ + 1) + j]; }
  /// The coordinates of \f$ b_{ij} \f$.
  Coordinates coordinates(int i, int j) const { return Geometric_continuity::coordinates<Traits>(control_point(i, j)); }

  /// The control points \f$ b_{00}, b_{01}, \dots, b_{pq} \f$.
  const_iterator begin() const { return points_.begin(); }
  const_iterator end() const { return points_.end(); }

  /// [a, b].
  Interval domain_u() const { return u_; }
  /// [c, d].
  Interval domain_v() const { return v_; }

  /// \name Evaluation
  /// The parameters may lie outside the domain: the polynomial is extended.
  /// @{

  /// The point at (`u`, `v`). \f$ O(pq^2 + p^2) \f$
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// The jet of order `k >= 0` at (`u`, `v`). \f$ O(pq^2 + kp^2 + pk^3) \f$
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    Surface_jet<Traits> jet(dimension(), k);
    const FT s = local_parameter(u, u_), t = local_parameter(v, v_);
    const FT hu = FT(u_.second - u_.first), hv = FT(v_.second - v_.first);
    for (int x = 0; x < dimension(); ++x) {
      std::vector<std::vector<FT>> columns(k + 1, std::vector<FT>(p_ + 1)); // derivatives with respect to v
      for (int i = 0; i <= p_; ++i) {
        std::vector<FT> row = coefficients(x, i);
        bernstein_derivatives(row, q_, t, k, [&](int j, const FT& value) { columns[j][i] = value; });
      }
      FT scale_v(1);
      for (int j = 0; j <= k; ++j) {
        FT scale = scale_v;
        bernstein_derivatives(columns[j], p_, s, k - j, [&](int i, const FT& value) {
          jet(i, j)[x] = value / scale;
          scale *= hu;
        });
        scale_v *= hv;
      }
    }
    return jet;
  }

  /// The derivative of order `i` in `u` and `j` in `v`, `i + j > 0`.
  Vector partial(const FT& u, const FT& v, int i, int j) const { return jet(u, v, i + j).partial(i, j); }

  /// The normal \f$ S_u \times S_v \f$, not normalised; zero where the patch is not regular.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(jet(u, v, 1)); }

  /// The unit normal, empty where \f$ S_u \times S_v = 0 \f$; only for number types that have a square root.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  std::optional<Vector> unit_normal(const FT& u, const FT& v) const {
    return Geometric_continuity::unit_normal(jet(u, v, 1));
  }

  /// @}

  /// \name Edges
  /// @{

  /// The degree of an edge.
  int degree_along(Patch_edge edge) const { return runs_along_u(edge) ? p_ : q_; }
  /// The degree in the parameter that is constant on an edge.
  int degree_across(Patch_edge edge) const { return runs_along_u(edge) ? q_ : p_; }
  /// The domain of an edge.
  Interval domain(Patch_edge edge) const { return runs_along_u(edge) ? u_ : v_; }

  /// The control point number `i` along the edge in the layer `j`, where layer 0 is the edge itself.
  const Point& control_point(Patch_edge edge, int i, int j) const {
    const int inward = at_upper_end(edge) ? degree_across(edge) - j : j;
    return runs_along_u(edge) ? control_point(i, inward) : control_point(inward, i);
  }

  /// The edge as a curve on its part of the domain.
  Bezier_curve<Traits> boundary_curve(Patch_edge edge) const {
    std::vector<Point> points;
    for (int i = 0; i <= degree_along(edge); ++i) points.push_back(control_point(edge, i, 0));
    return Bezier_curve<Traits>(points.begin(), points.end(), domain(edge).first, domain(edge).second);
  }

  /// The rows 0 to `k` at an edge: the Bernstein coefficients, along the edge, of the edge and of the first `k` derivatives
  /// across it, where the patch is taken on the unit square and turned so that the edge is at `v = 0`:
  /// \f$ \frac{q!}{(q-r)!} \Delta^r b_{i0} \f$, differences into the patch. Rows beyond the degree are zero. The control
  /// points are converted to `Field` before anything is computed.
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    const int m = degree_along(edge), n = degree_across(edge);
    std::vector<Row<Field>> rows(k + 1, Row<Field>(m + 1, Coordinate_vector<Field, N>(dimension())));
    for (int i = 0; i <= m; ++i) {
      std::vector<Coordinate_vector<Field, N>> layers;
      for (int j = 0; j <= std::min(k, n); ++j)
        layers.push_back(Geometric_continuity::coordinates<Traits, Field>(control_point(edge, i, j)));
      Field factor(1);
      for (int r = 0; r <= std::min(k, n); ++r) {
        rows[r][i] = factor * layers[0];
        difference_step(layers, std::min(k, n) - r);
        factor *= Field(n - r);
      }
    }
    return rows;
  }

  /// The patch turned so that the edge is at `v = 0`, in its own direction or against it.
  Bezier_patch oriented(Patch_edge edge, bool backwards = false) const {
    Bezier_patch r = *this;
    if (!runs_along_u(edge)) r = r.swap_parameters();
    if (at_upper_end(edge)) r = r.reverse_v();
    return backwards ? r.reverse_u() : r;
  }

  /// @}

  /// \name Operations
  /// @{

  /// The patch \f$ (u, v) \mapsto S(v, u) \f$.
  Bezier_patch swap_parameters() const {
    std::vector<Point> points;
    for (int j = 0; j <= q_; ++j)
      for (int i = 0; i <= p_; ++i) points.push_back(control_point(i, j));
    return Bezier_patch(q_, p_, std::move(points), v_, u_);
  }

  /// The patch \f$ (u, v) \mapsto S(a + b - u, v) \f$.
  Bezier_patch reverse_u() const {
    std::vector<Point> points;
    for (int i = p_; i >= 0; --i)
      for (int j = 0; j <= q_; ++j) points.push_back(control_point(i, j));
    return Bezier_patch(p_, q_, std::move(points), u_, v_);
  }

  /// The patch \f$ (u, v) \mapsto S(u, c + d - v) \f$.
  Bezier_patch reverse_v() const { return swap_parameters().reverse_u().swap_parameters(); }

  /// The same patch with the degrees raised by `times_u >= 0` and `times_v >= 0`.
  Bezier_patch elevate(int times_u, int times_v) const {
    return elevate_u(times_u).swap_parameters().elevate_u(times_v).swap_parameters();
  }

  /// The parts on [a, u] and [u, b]. \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Bezier_patch, Bezier_patch> split_u(const FT& u) const {
    if (!(u_.first < u && u < u_.second)) throw Error(Error_code::parameter_outside_domain, "Bezier_patch::split");
    const FT t = local_parameter(u, u_);
    std::vector<Point> left(points_), right(points_);
    for (int j = 0; j <= q_; ++j) {
      std::vector<Coordinates> r = column(j), l(r);
      bernstein_split(r, p_, t, l);
      for (int i = 0; i <= p_; ++i) {
        left[i * (q_ + 1) + j] = Geometric_continuity::to_point<Traits>(l[i]);
        right[i * (q_ + 1) + j] = Geometric_continuity::to_point<Traits>(r[i]);
      }
    }
    return {Bezier_patch(p_, q_, std::move(left), Interval(u_.first, u), v_),
            Bezier_patch(p_, q_, std::move(right), Interval(u, u_.second), v_)};
  }

  /// The parts on [c, v] and [v, d]. \throws Error `parameter_outside_domain` unless `c < v < d`
  std::pair<Bezier_patch, Bezier_patch> split_v(const FT& v) const {
    const std::pair<Bezier_patch, Bezier_patch> parts = swap_parameters().split_u(v);
    return {parts.first.swap_parameters(), parts.second.swap_parameters()};
  }

  /// The same points on another domain. \throws Error `empty_domain`, `not_finite`
  Bezier_patch with_domain(const Interval& u, const Interval& v) const { return Bezier_patch(p_, q_, points_, u, v); }

  /// The image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Bezier_patch transform(const Transformation& map) const {
    Bezier_patch r = *this;
    for (Point& p : r.points_) p = map(p);
    return r;
  }

  /// Two opposite corners of the bounding box of the control points, which contains the patch.
  std::pair<Point, Point> bounding_box() const { return polygon().bounding_box(); }

  /// The bounding box of the control points as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const { return polygon().bbox(); }

  /// @}

  /// Equality of domains, degrees and control points.
  friend bool operator==(const Bezier_patch& s, const Bezier_patch& t) {
    return s.p_ == t.p_ && s.q_ == t.q_ && s.u_ == t.u_ && s.v_ == t.v_ && s.points_ == t.points_;
  }
  friend bool operator!=(const Bezier_patch& s, const Bezier_patch& t) { return !(s == t); }

  /// Writes the degrees, the domain and the control net, one row \f$ b_{i0}, \dots, b_{iq} \f$ to a line.
  friend std::ostream& operator<<(std::ostream& os, const Bezier_patch& s) {
    os << "Bezier patch of degree " << s.p_ << " x " << s.q_ << " on [" << s.u_.first << ", " << s.u_.second << "] x ["
       << s.v_.first << ", " << s.v_.second << "]:";
    for (int i = 0; i <= s.p_; ++i) {
      os << '\n';
      for (int j = 0; j <= s.q_; ++j) {
        const Coordinates p = s.coordinates(i, j);
        for (int x = 0; x < p.dimension(); ++x) os << (x > 0 ? ", " : j > 0 ? " (" : "(") << p[x];
        os << ')';
      }
    }
    return os;
  }

private:
  static Interval unit_interval() { return Interval(FT(0), FT(1)); }

  Bezier_patch(int p, int q, std::vector<Point> points, const Interval& u, const Interval& v)
      : p_(p), q_(q), points_(std::move(points)), u_(u), v_(v) {
    check();
  }

  template <class Net> void take(const Net& net) {
    for (const auto& row : net) {
      points_.insert(points_.end(), std::begin(row), std::end(row));
      const int n = static_cast<int>(std::distance(std::begin(row), std::end(row)));
      if (p_ > 0 && n != q_)
        throw Error(Error_code::wrong_number_of_points, "Bezier_patch: " + std::to_string(n) +
                                                            " control points in row " + std::to_string(p_) + " after " +
                                                            std::to_string(q_));
      q_ = n;
      ++p_;
    }
    if (points_.empty()) throw Error(Error_code::wrong_number_of_points, "Bezier_patch: no control point");
    --p_;
    --q_;
    check();
  }

  void check() const {
    for (const Interval* domain : {&u_, &v_}) {
      if (!(domain->first < domain->second)) throw Error(Error_code::empty_domain, "Bezier_patch");
      internal::check_finite(domain->first, "Bezier_patch: domain");
      internal::check_finite(domain->second, "Bezier_patch: domain");
    }
    for (int i = 0; i <= p_; ++i)
      for (int j = 0; j <= q_; ++j) {
        const Coordinates x = coordinates(i, j);
        if (x.dimension() != dimension())
          throw Error(Error_code::dimension_mismatch,
                      "Bezier_patch: control point " + std::to_string(i) + ", " + std::to_string(j));
        for (const FT& c : x) internal::check_finite(c, "Bezier_patch: control points");
      }
  }

  static FT local_parameter(const FT& u, const Interval& domain) {
    return FT((u - domain.first) / (domain.second - domain.first));
  }

  // the coordinates number x of b_i0, ..., b_iq
  std::vector<FT> coefficients(int x, int i) const {
    const Traits traits;
    std::vector<FT> c;
    for (int j = 0; j <= q_; ++j) c.push_back(FT(traits.compute_coordinate_object()(control_point(i, j), x)));
    return c;
  }

  // b_0j, ..., b_pj
  std::vector<Coordinates> column(int j) const {
    std::vector<Coordinates> c;
    for (int i = 0; i <= p_; ++i) c.push_back(coordinates(i, j));
    return c;
  }

  Bezier_patch elevate_u(int times) const {
    std::vector<Point> points((p_ + times + 1) * (q_ + 1), points_[0]);
    for (int j = 0; j <= q_; ++j) {
      std::vector<Coordinates> c = column(j);
      c.resize(p_ + times + 1, Coordinates(dimension()));
      for (int n = p_; n < p_ + times; ++n) bernstein_elevate<FT>(c, n);
      for (int i = 0; i <= p_ + times; ++i) points[i * (q_ + 1) + j] = Geometric_continuity::to_point<Traits>(c[i]);
    }
    return Bezier_patch(p_ + times, q_, std::move(points), u_, v_);
  }

  Bezier_curve<Traits> polygon() const { return Bezier_curve<Traits>(points_.begin(), points_.end()); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H
