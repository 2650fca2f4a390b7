// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/Wall_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

typedef Wall_axis::Vector Wall_vector;

Wall_vector turned_about(const Wall_vector& v, const Wall_vector& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * cross_product(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
}

Wall_curve::Spline spline_of_edge(const Cad_solid::Edge& edge) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const std::array<double, 3>& p : edge.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<double> weights = edge.weights;
  if (weights.empty()) weights.assign(points.size(), 1);
  return {points.begin(), points.end(), weights.begin(), weights.end(),
          GC::Knot_vector<double>(edge.degree, edge.knots)};
}

} // namespace

Wall_axis::Wall_axis(const Vector& direction) : direction_(1 / wall_norm(direction) * direction) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(direction_[(k + 1) % 3]) < 1e-12 && std::abs(direction_[(k + 2) % 3]) < 1e-12) {
      number_ = k;
      direction_ = Vector(3);
      direction_[k] = 1;
    }
}

std::array<double, 3> point_of_edge(const Cad_solid& solid, const Cad_solid::Edge& edge, double part) {
  Wall_vector p(3);
  if (edge.kind == "circle") {
    const Wall_vector centre = wall_vector(edge.centre);
    p = centre +
        turned_about(wall_vector(solid.vertices[edge.ends[0]]) - centre, wall_vector(edge.axis), part * edge.angle);
  } else if (edge.kind == "line")
    p = (1 - part) * wall_vector(solid.vertices[edge.ends[0]]) + part * wall_vector(solid.vertices[edge.ends[1]]);
  else {
    const Wall_curve::Spline spline = spline_of_edge(edge);
    const auto [begin, end] = spline.domain();
    const auto q = spline(part == 1 ? end : begin + part * (end - begin));
    return {q.x(), q.y(), q.z()};
  }
  return {p[0], p[1], p[2]};
}

void Wall_curve::set(int degree, std::vector<double> knots, const std::vector<Vector>& points,
                     std::vector<double> weights) {
  std::vector<Traits::Point> p;
  for (const Vector& x : points) p.emplace_back(x[0], x[1], x[2]);
  if (weights.empty()) weights.assign(p.size(), 1);
  spline_.emplace(p.begin(), p.end(), weights.begin(), weights.end(),
                  GC::Knot_vector<double>(degree, std::move(knots)));
}

Wall_curve::Wall_curve(const Cad_solid::Edge& edge, const Wall_axis& axis, const Vector& from, const Vector& to)
    : axis_(axis), kind_(edge.kind == "line"     ? Kind::line
                         : edge.kind == "circle" ? Kind::circle
                                                 : Kind::spline),
      centre_(3) {
  if (kind_ == Kind::line)
    set(1, {0, 0, 1, 1}, {from, to}, {});
  else if (kind_ == Kind::circle) {
    centre_ = axis.flat(wall_vector(edge.centre));
    left_turn_ = dot(axis.direction(), wall_vector(edge.axis)) > 0;
    make_arc(from, to, edge.angle);
  } else {
    std::vector<Vector> points;
    for (const std::array<double, 3>& p : edge.points) points.push_back(axis.flat(wall_vector(p)));
    points.front() = from;
    points.back() = to;
    set(edge.degree, edge.knots, points, edge.weights);
  }
}

// Pieces of at most a right angle. Where they are right angles and even in number, they have the
// weights 1, 1, 2, with which a quarter of a circle is exact, in turns from both ends; so the
// derivative is continuous, as it is with equal weights at both ends.
void Wall_curve::make_arc(const Vector& from, const Vector& to, double angle) {
  const double right_angle = std::acos(0.), little = 1e-9;
  const int n = (std::max)(1, static_cast<int>(std::ceil(angle / right_angle - little)));
  const double step = angle / n;
  const bool right = std::abs(step - right_angle) < little, exact = right && n % 2 == 0;
  const Vector turn = (left_turn_ ? 1. : -1.) * axis_.direction();
  radius_ = (wall_norm(from - centre_) + wall_norm(to - centre_)) / 2;
  std::vector<Vector> points{from};
  std::vector<double> weights{1}, knots{0, 0, 0};
  Vector v = from - centre_;
  for (int i = 0; i < n; ++i) {
    const Vector next = i + 1 == n ? to - centre_ : right ? cross_product(turn, v) : turned_about(v, turn, step);
    points.push_back(centre_ + (right ? v + next : 1 / (1 + std::cos(step)) * (v + next)));
    points.push_back(i + 1 == n ? to : centre_ + next);
    weights.push_back(exact ? 1 : right ? std::sqrt(0.5) : std::cos(step / 2));
    weights.push_back(exact && i % 2 == 0 ? 2 : 1);
    knots.insert(knots.end(), i + 1 == n ? 3 : 2, i + 1);
    v = next;
  }
  set(2, std::move(knots), points, std::move(weights));
}

Wall_vector Wall_curve::point(double u) const {
  const Traits::Point p = (*spline_)(u);
  return wall_vector({p.x(), p.y(), p.z()});
}

Wall_vector Wall_curve::tangent(double u) const {
  const auto d = spline_->jet(u, 1).derivative(1);
  const Vector t = wall_vector({d.x(), d.y(), d.z()});
  return 1 / wall_norm(t) * t;
}

std::vector<double> Wall_curve::samples(int of_each_span) const {
  std::vector<double> result;
  const GC::Knot_vector<double>& knots = spline_->knots();
  for (const int s : knots.spans())
    for (int k = 0; k < of_each_span; ++k) result.push_back(knots[s] + k * (knots[s + 1] - knots[s]) / of_each_span);
  result.push_back(domain().second);
  return result;
}

std::optional<Wall_curve::Kink> Wall_curve::kink(double degrees) const {
  for (const auto& knot : spline_->knots().inner_knots()) {
    if (knot.multiplicity < spline_->degree()) continue;
    const auto a = spline_->left_jet(knot.value, 1).derivative(1), b = spline_->right_jet(knot.value, 1).derivative(1);
    const Vector s = wall_vector({a.x(), a.y(), a.z()}), t = wall_vector({b.x(), b.y(), b.z()});
    const double angle = std::atan2(wall_norm(cross_product(s, t)), dot(s, t)) * 180 / M_PI;
    if (angle > degrees) return Kink{angle, point(knot.value)};
  }
  return std::nullopt;
}

std::optional<Wall_curve::Radius> Wall_curve::least_radius(int side) const {
  std::optional<Radius> result;
  if (kind_ == Kind::circle && (side > 0) == left_turn_) return Radius{radius_, point(domain().first)};
  if (kind_ != Kind::spline) return result;
  for (const double u : samples(32)) {
    const auto jet = spline_->jet(u, 2);
    const auto a = jet.derivative(1), b = jet.derivative(2);
    const Vector d = wall_vector({a.x(), a.y(), a.z()}), dd = wall_vector({b.x(), b.y(), b.z()});
    const double bend = side * dot(axis_.direction(), cross_product(d, dd)), speed = wall_norm(d);
    if (bend <= 0) continue;
    const double radius = speed * speed * speed / bend;
    if (!result || radius < result->radius) result = Radius{radius, point(u)};
  }
  return result;
}

// The splines with the knots and weights of the curve that are the normals at the Greville
// abscissae: a system with a band, which needs no pivots.
std::vector<Wall_vector> Wall_curve::normals() const {
  const GC::Knot_vector<double>& knots = spline_->knots();
  const int p = spline_->degree(), n = spline_->number_of_points();
  std::vector<std::vector<double>> rows;
  std::vector<Vector> result;
  for (int i = 0; i < n; ++i) {
    const double u = i == 0 ? domain().first : i + 1 == n ? domain().second : knots.greville_abscissa(i);
    const int span = i + 1 == n ? knots.left_span(u) : knots.span(u);
    std::vector<double> basis(1, 1); // of the degree so far
    for (int q = 1; q <= p; ++q) {
      std::vector<double> next(static_cast<std::size_t>(q) + 1, 0);
      for (int k = 0; k < q; ++k) {
        const double low = knots[span - q + 1 + k], high = knots[span + 1 + k], part = (u - low) / (high - low);
        next[static_cast<std::size_t>(k)] += (1 - part) * basis[static_cast<std::size_t>(k)];
        next[static_cast<std::size_t>(k) + 1] += part * basis[static_cast<std::size_t>(k)];
      }
      basis = std::move(next);
    }
    std::vector<double> row(static_cast<std::size_t>(n), 0);
    double sum = 0;
    for (int k = 0; k <= p; ++k) {
      const int j = span - p + k;
      row[static_cast<std::size_t>(j)] = basis[static_cast<std::size_t>(k)] * spline_->weight(j);
      sum += row[static_cast<std::size_t>(j)];
    }
    rows.push_back(std::move(row));
    result.push_back(sum * normal(u));
  }
  const auto at = [&](int i, int j) -> double& {
    return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (int i = 0; i < n; ++i)
    for (int r = i + 1; r < (std::min)(n, i + p + 1); ++r) {
      const double factor = at(r, i) / at(i, i);
      if (factor == 0) continue;
      for (int j = i; j < (std::min)(n, i + 2 * p + 1); ++j) at(r, j) -= factor * at(i, j);
      result[static_cast<std::size_t>(r)] -= factor * result[static_cast<std::size_t>(i)];
    }
  for (int i = n - 1; i >= 0; --i) {
    for (int j = i + 1; j < (std::min)(n, i + 2 * p + 1); ++j)
      result[static_cast<std::size_t>(i)] -= at(i, j) * result[static_cast<std::size_t>(j)];
    result[static_cast<std::size_t>(i)] /= at(i, i);
  }
  // Where the curve may have no second derivative, the first one of the field is along its tangent,
  // as that of the normals is: so rails are G1 where the curve is.
  const auto lead = [&](int k, int to) {
    const Traits::Point &a = spline_->control_point(k), &b = spline_->control_point(to);
    const Vector c = wall_vector({b.x() - a.x(), b.y() - a.y(), b.z() - a.z()});
    Vector& n = result[static_cast<std::size_t>(to)];
    n = result[static_cast<std::size_t>(k)] + dot(n - result[static_cast<std::size_t>(k)], c) / dot(c, c) * c;
  };
  lead(0, 1);
  lead(n - 1, n - 2);
  for (const auto& knot : knots.inner_knots())
    if (knot.multiplicity >= p) {
      const int k = knots.left_span(knot.value); // the point at the knot
      lead(k, k - 1);
      lead(k, k + 1);
    }
  return result;
}

double Wall_curve::largest_error(const std::vector<Vector>& directions) const {
  std::vector<Traits::Point> points;
  for (const Vector& x : directions) points.emplace_back(x[0], x[1], x[2]);
  const Spline field(points.begin(), points.end(), spline_->weights().begin(), spline_->weights().end(),
                     spline_->knots());
  double error = 0;
  for (const double u : samples(8)) {
    const Traits::Point n = field(u);
    error = (std::max)(error, std::abs(dot(wall_vector({n.x(), n.y(), n.z()}), normal(u)) - 1));
  }
  return error;
}

void Wall_curve::refine() {
  if (kind_ != Kind::spline) return;
  while ((error_ = largest_error(normals())) > 1e-3 && spline_->number_of_points() < 500) {
    const GC::Knot_vector<double> knots = spline_->knots();
    for (const int s : knots.spans()) spline_ = spline_->insert((knots[s] + knots[s + 1]) / 2);
  }
}

std::vector<Wall_vector> Wall_curve::rail(double distance, int side, const std::array<Vector, 2>& directions) const {
  std::vector<Vector> result;
  if (kind_ == Kind::spline) {
    const std::vector<Vector> field = normals();
    for (int i = 0; i < spline_->number_of_points(); ++i) {
      const Traits::Point& c = spline_->control_point(i);
      result.push_back(wall_vector({c.x(), c.y(), c.z()}) + side * distance * field[static_cast<std::size_t>(i)]);
    }
  } else
    for (int i = 0; i < spline_->number_of_points(); ++i) {
      const Traits::Point& c = spline_->control_point(i);
      const double part = (side > 0) == left_turn_ ? distance / radius_ : -distance / radius_;
      result.push_back(wall_vector({c.x(), c.y(), c.z()}) + part * (centre_ - wall_vector({c.x(), c.y(), c.z()})));
    }
  const auto end = [&](const Traits::Point& c, const Vector& n) {
    return wall_vector({c.x(), c.y(), c.z()}) + distance * n;
  };
  result.front() = end(*spline_->begin(), directions[0]);
  result.back() = end(spline_->control_point(spline_->number_of_points() - 1), directions[1]);
  return result;
}

Wall_curve::Spline spline_like(const Wall_curve::Spline& curve, const std::vector<Wall_curve::Vector>& points) {
  std::vector<Wall_curve::Traits::Point> p;
  for (const Wall_curve::Vector& x : points) p.emplace_back(x[0], x[1], x[2]);
  return {p.begin(), p.end(), curve.weights().begin(), curve.weights().end(), curve.knots()};
}

std::array<Wall_curve::Vector, 2> vectors_in_plane(const Wall_curve::Vector& normal) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal[k]) < std::abs(normal[least])) least = k;
  Wall_curve::Vector x(3);
  x[least] = 1;
  x -= dot(x, normal) * normal;
  x = 1 / wall_norm(x) * x;
  return {x, cross_product(normal, x)};
}
