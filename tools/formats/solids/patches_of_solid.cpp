// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/patches_of_solid.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

typedef Exact_space::Point Space_point;
typedef Exact_space::Vector Space_vector;
typedef GC::Bezier_curve<Exact_space> Space_curve;
typedef GC::Bezier_patch<Exact_space> Space_patch;
typedef CGAL::Epick::Point_2 Flat_point;

template <class P> Space_point exact_space_point(const P& p) { return {Exact(p.x()), Exact(p.y()), Exact(p.z())}; }
template <class V> Space_vector exact_vector(const V& v) { return {Exact(v.x()), Exact(v.y()), Exact(v.z())}; }
GC::Knot_vector<Exact> exact_knots(const GC::Knot_vector<double>& knots) { return {knots.degree(), knots.knots()}; }

// The halves of the halves..., in order.
std::vector<Space_curve> halved(const Space_curve& curve, int times) {
  if (times == 0) return {curve};
  const auto parts = curve.split(Exact((curve.domain().first + curve.domain().second) / 2));
  std::vector<Space_curve> all = halved(parts.first, times - 1);
  for (Space_curve& c : halved(parts.second, times - 1)) all.push_back(std::move(c));
  return all;
}
void add_halved(const Space_patch& patch, int times, std::vector<Exact_surface>& surfaces) {
  if (times == 0) {
    surfaces.push_back(Exact_surface(patch));
    return;
  }
  const auto middle = [](const auto& interval) { return Exact((interval.first + interval.second) / 2); };
  const auto in_u = patch.split_u(middle(patch.domain_u()));
  for (const Space_patch& half : {in_u.first, in_u.second}) {
    const auto in_v = half.split_v(middle(half.domain_v()));
    add_halved(in_v.first, times - 1, surfaces);
    add_halved(in_v.second, times - 1, surfaces);
  }
}

// A plane face, cut into patches.
class Face_cut {
  // The parts of the boundary between two successive corners of the polygon inside: two curves.
  struct Side {
    std::array<Space_curve, 2> curves;
  };
  const Rounded_solid& solid_;
  const Rounded_solid::Face& face_;
  const int halvings_;
  const Space_point origin_;
  const Space_vector x_, y_;
  std::vector<std::vector<Side>> loops_;
  std::vector<std::vector<Flat_point>> outer_, inner_; // corners of the boundary, and inside of it

  // Nearly the parameters in the plane.
  Flat_point flat(const Space_point& p) const {
    const auto number = [](const Exact& x) { return CGAL::to_double(x); };
    const Space_vector d = p - origin_;
    const double xx = number(x_ * x_), xy = number(x_ * y_), yy = number(y_ * y_), dx = number(d * x_),
                 dy = number(d * y_), det = xx * yy - xy * xy;
    // in units of length, so that distances are nearly right
    return {(dx * yy - dy * xy) / det * std::sqrt(xx), (dy * xx - dx * xy) / det * std::sqrt(yy)};
  }
  Space_point lifted(const Flat_point& p) const {
    const double x = std::sqrt(CGAL::to_double(x_ * x_)), y = std::sqrt(CGAL::to_double(y_ * y_));
    return origin_ + Exact(p.x() / x) * x_ + Exact(p.y() / y) * y_;
  }
  static bool turns_left(const Flat_point& a, const Flat_point& b, const Flat_point& c) {
    return CGAL::orientation(a, b, c) == CGAL::LEFT_TURN;
  }

  void read_loops() {
    for (const auto& loop : face_.loops) {
      std::vector<Side> sides;
      for (const Rounded_solid::Use& use : loop) {
        const auto& c = solid_.edges[use.edge].curve;
        std::vector<Space_point> points;
        for (const auto& p : c) points.push_back(exact_space_point(p));
        const GC::Bspline_curve<Exact_space> curve(points, exact_knots(c.knots()));
        std::vector<Space_curve> pieces;
        for (const Space_curve& piece : curve.bezier_pieces())
          for (Space_curve& part : halved(piece, halvings_)) pieces.push_back(std::move(part));
        if (use.reversed) {
          std::reverse(pieces.begin(), pieces.end());
          for (Space_curve& piece : pieces) piece = piece.reverse();
        }
        for (std::size_t i = 0; i < pieces.size(); i += 2) sides.push_back({{pieces[i], pieces[i + 1]}});
      }
      loops_.push_back(std::move(sides));
    }
    for (const std::vector<Side>& loop : loops_) {
      outer_.emplace_back();
      for (const Side& side : loop) outer_.back().push_back(flat(side.curves[0].control_point(0)));
    }
  }

  // The corners inside, at a distance from those of the boundary, in the direction between both
  // sides there.
  void move_inside(double distance) {
    inner_.clear();
    for (const std::vector<Flat_point>& loop : outer_) {
      inner_.emplace_back();
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Flat_point &before = loop[(i + n - 1) % n], &here = loop[i], &after = loop[(i + 1) % n];
        const auto unit = [](const CGAL::Epick::Vector_2& v) { return v / std::sqrt(v.squared_length()); };
        const auto a = unit(here - before), b = unit(after - here), sum = unit(a + b);
        inner_.back().push_back(here + distance * CGAL::Epick::Vector_2(-sum.y(), sum.x()));
      }
    }
  }

  // Each cell between both rings is convex, with the curve outside of its inner side.
  bool cells_are_good() const {
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const std::size_t n = loops_[l].size();
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const Flat_point &p = outer_[l][i], &q = outer_[l][j], &r = inner_[l][j], &s = inner_[l][i];
        if (!turns_left(p, q, r) || !turns_left(q, r, s) || !turns_left(r, s, p) || !turns_left(s, p, q)) return false;
        for (const Space_curve& curve : loops_[l][i].curves)
          for (const Space_point& c : curve)
            if (!turns_left(r, s, flat(c))) return false;
      }
    }
    return true;
  }

  // The triangles of the polygon inside, by pairs of loop and corner: holes are joined to the outer
  // loop by two coinciding sides, and then ears are cut off. Returns false if that fails.
  typedef std::pair<std::size_t, std::size_t> Face_corner;
  std::vector<std::array<Face_corner, 3>> triangles_;
  const Flat_point& at(const Face_corner& c) const { return inner_[c.first][c.second]; }

  static bool cross(const Flat_point& a, const Flat_point& b, const Flat_point& c, const Flat_point& d) {
    const auto side = [](const Flat_point& x, const Flat_point& y, const Flat_point& z) {
      return CGAL::orientation(x, y, z);
    };
    return side(a, b, c) * side(a, b, d) != 1 && side(c, d, a) * side(c, d, b) != 1;
  }
  // A line between two corners that meets no side.
  bool is_free(const Face_corner& a, const Face_corner& b) const {
    for (std::size_t l = 0; l < inner_.size(); ++l)
      for (std::size_t i = 0; i < inner_[l].size(); ++i) {
        const Face_corner c(l, i), d(l, (i + 1) % inner_[l].size());
        if (c != a && c != b && d != a && d != b && cross(at(a), at(b), at(c), at(d))) return false;
      }
    return true;
  }
  bool join_holes(std::vector<Face_corner>& ring) const {
    std::vector<bool> joined(inner_.size(), false);
    joined[0] = true;
    for (std::size_t i = 0; i < inner_[0].size(); ++i) ring.emplace_back(0, i);
    for (std::size_t round = 1; round < inner_.size(); ++round) {
      double least = std::numeric_limits<double>::infinity();
      std::size_t place = 0;
      Face_corner to;
      for (std::size_t l = 1; l < inner_.size(); ++l)
        for (std::size_t i = 0; !joined[l] && i < inner_[l].size(); ++i)
          for (std::size_t k = 0; k < ring.size(); ++k) {
            const double d = CGAL::squared_distance(at(ring[k]), at({l, i}));
            if (d < least && is_free(ring[k], {l, i})) {
              least = d;
              place = k;
              to = {l, i};
            }
          }
      if (!std::isfinite(least)) return false;
      std::vector<Face_corner> hole;
      const std::size_t n = inner_[to.first].size();
      for (std::size_t i = 0; i <= n; ++i) hole.emplace_back(to.first, (to.second + i) % n);
      hole.push_back(ring[place]);
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(place) + 1, hole.begin(), hole.end());
      joined[to.first] = true;
    }
    return true;
  }
  bool cut_ears() {
    triangles_.clear();
    std::vector<Face_corner> ring;
    if (!join_holes(ring)) return false;
    while (ring.size() > 3) {
      const std::size_t n = ring.size();
      std::size_t best = n;
      double largest = -1; // of the least heights, so that triangles are not thin
      for (std::size_t i = 0; i < n; ++i) {
        const Face_corner &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
        if (!turns_left(at(a), at(b), at(c))) continue;
        const bool empty = std::none_of(ring.begin(), ring.end(), [&](const Face_corner& x) {
          const Flat_point& p = at(x);
          return p != at(a) && p != at(b) && p != at(c) && !CGAL::right_turn(at(a), at(b), p) &&
                 !CGAL::right_turn(at(b), at(c), p) && !CGAL::right_turn(at(c), at(a), p);
        });
        if (!empty) continue;
        const double longest = (std::max)({CGAL::squared_distance(at(a), at(b)), CGAL::squared_distance(at(b), at(c)),
                                           CGAL::squared_distance(at(c), at(a))}),
                     height = std::abs(CGAL::area(at(a), at(b), at(c))) / longest;
        if (height <= largest) continue;
        largest = height;
        best = i;
      }
      if (best == n) return false;
      triangles_.push_back({ring[(best + n - 1) % n], ring[best], ring[(best + 1) % n]});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
    }
    triangles_.push_back({ring[0], ring[1], ring[2]});
    return turns_left(at(ring[0]), at(ring[1]), at(ring[2]));
  }

  double shortest_side() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& loop : outer_)
      for (std::size_t i = 0; i < loop.size(); ++i)
        least = (std::min)(least, CGAL::squared_distance(loop[i], loop[(i + 1) % loop.size()]));
    return std::sqrt(least);
  }

public:
  Face_cut(const Rounded_solid& solid, const Rounded_solid::Face& face, int halvings)
      : solid_(solid), face_(face), halvings_(halvings), origin_(exact_space_point(face.origin)),
        x_(exact_vector(face.x)), y_(exact_vector(face.y)) {
    read_loops();
  }

  // Returns whether the boundary turns to the right somewhere along a curve.
  bool has_reflex_turn() const {
    for (const auto& loop : loops_)
      for (const Side& side : loop) {
        const Space_curve &a = side.curves[0], &b = side.curves[1];
        const Flat_point p = flat(a.control_point(0)), q = flat(b.control_point(0)),
                         r = flat(b.control_point(b.degree()));
        const double length = std::sqrt(CGAL::squared_distance(p, r));
        if (CGAL::area(p, q, r) < -1e-6 * length * length) return true;
      }
    return false;
  }

  // Finds the polygon inside and its triangles; returns false where there are none.
  bool find_triangles() {
    double distance = shortest_side();
    for (int i = 0; i < 40; ++i, distance /= 2) {
      move_inside(distance / 2);
      if (cells_are_good() && cut_ears()) return true;
    }
    return false;
  }

  void add_to(std::vector<Exact_surface>& surfaces) const {
    std::vector<std::vector<Space_point>> corners;
    for (const auto& loop : inner_) {
      corners.emplace_back();
      for (const Flat_point& p : loop) corners.back().push_back(lifted(p));
    }
    const auto middle = [](const Space_point& p, const Space_point& q) { return CGAL::midpoint(p, q); };
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t i = 0; i < loops_[l].size(); ++i) {
        const Space_point &start = corners[l][i], &end = corners[l][(i + 1) % corners[l].size()];
        for (int half : {0, 1}) {
          const Space_curve& curve = loops_[l][i].curves[static_cast<std::size_t>(half)];
          const Space_point p = half == 0 ? start : middle(start, end), q = half == 0 ? middle(start, end) : end;
          std::vector<std::vector<Space_point>> net;
          for (int k = 0; k <= curve.degree(); ++k)
            net.push_back({curve.control_point(k), p + Exact(Exact(k) / Exact(curve.degree())) * (q - p)});
          surfaces.push_back(Exact_surface(Space_patch(net)));
        }
      }
    for (const std::array<Face_corner, 3>& t : triangles_) {
      const auto corner = [&](std::size_t i) { return corners[t[i % 3].first][t[i % 3].second]; };
      const Space_point centre = CGAL::centroid(corner(0), corner(1), corner(2));
      for (std::size_t i = 0; i < 3; ++i)
        surfaces.push_back( // with the control points of the ring beside it, also after rounding
            Exact_surface(
                Space_patch({{corner(i), middle(corner(i), corner(i + 2))}, {middle(corner(i), corner(i + 1)), centre}})
                    .elevate(4, 4)));
    }
  }
};

} // namespace

std::vector<Exact_surface> patches_of_solid(const Rounded_solid& solid) {
  // Where a boundary turns to the right, the polygon inside has a corner in the middle of the turn,
  // and more of them where the turn is wide: halves lie nearer to their chords.
  std::vector<Face_cut> cuts;
  const auto finds_all = [&](int halvings) {
    cuts.clear();
    for (const Rounded_solid::Face& face : solid.faces) {
      cuts.emplace_back(solid, face, halvings);
      if (!cuts.back().find_triangles() || (halvings == 1 && cuts.back().has_reflex_turn())) return false;
    }
    return true;
  };
  int halvings = 1;
  while (!finds_all(halvings))
    if (++halvings > 5) throw std::runtime_error("no patches are found for a plane face; write it to a CAD model");
  std::vector<Exact_surface> surfaces;
  for (const Face_cut& cut : cuts) cut.add_to(surfaces);
  for (const Rounded_solid::Blend& blend : solid.blends) {
    const auto& s = blend.surface;
    std::vector<std::vector<Space_point>> net(static_cast<std::size_t>(s.number_of_points_u()));
    for (int i = 0; i < s.number_of_points_u(); ++i)
      for (int j = 0; j < s.number_of_points_v(); ++j)
        net[static_cast<std::size_t>(i)].push_back(exact_space_point(s.control_point(i, j)));
    for (const Space_patch& patch :
         Exact_surface(net, exact_knots(s.knots_u()), exact_knots(s.knots_v())).bezier_patches())
      add_halved(patch, halvings, surfaces);
  }
  return surfaces;
}

namespace {

// The corners of a surface with the sides that lead from one to the next, counterclockwise as seen
// from the tip of its normal; nothing unless it is plane with straight sides.
struct Patch_corners {
  std::vector<Space_point> points;
  std::vector<std::size_t> sides;
};
std::optional<Patch_corners> corners_of(const Exact_surface& s) {
  const int m = s.number_of_points_u() - 1, n = s.number_of_points_v() - 1;
  if (!s.knots_u().is_clamped() || !s.knots_v().is_clamped()) return std::nullopt;
  const Space_point p[] = {s.control_point(0, 0), s.control_point(m, 0), s.control_point(m, n), s.control_point(0, n)};
  const std::size_t side[] = {2, 1, 3, 0}; // of u0, u1, v0 and v1
  Patch_corners corners;
  for (std::size_t i = 0; i < 4; ++i)
    if (p[i] != p[(i + 1) % 4]) {
      corners.points.push_back(p[i]);
      corners.sides.push_back(side[i]);
    }
  if (corners.points.size() < 3) return std::nullopt;
  const Space_vector normal = CGAL::cross_product(p[2] - p[0], p[3] - p[1]);
  for (const Space_point& q : s)
    if (normal * (q - p[0]) != 0) return std::nullopt;
  const auto straight = [&](int i, int j, int di, int dj, int count) {
    const Space_point a = s.control_point(i, j), b = s.control_point(i + count * di, j + count * dj);
    for (int k = 0; k <= count; ++k) {
      const Space_point q = s.control_point(i + k * di, j + k * dj);
      if (CGAL::cross_product(q - a, b - a) != CGAL::NULL_VECTOR || (q - a) * (b - q) < 0) return false;
    }
    return true;
  };
  if (!straight(0, 0, 1, 0, m) || !straight(m, 0, 0, 1, n) || !straight(0, n, 1, 0, m) || !straight(0, 0, 0, 1, n))
    return std::nullopt;
  return corners;
}

bool lies_between(const Space_point& a, const Space_point& x, const Space_point& b) {
  return CGAL::cross_product(x - a, b - a) == CGAL::NULL_VECTOR && (x - a) * (b - x) > 0;
}

// Turns faces so that they pass each edge in both directions. Returns false if an edge has not two
// faces, or they cannot be turned.
bool orient(Solid& solid) {
  typedef std::pair<std::size_t, std::size_t> Ends;
  std::map<Ends, std::vector<std::pair<std::size_t, bool>>> faces; // with whether they pass it backwards
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const Solid::Loop& loop = solid.faces[f].loops[0];
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const std::size_t a = loop.vertices[i], b = loop.vertices[(i + 1) % loop.vertices.size()];
      faces[std::minmax(a, b)].emplace_back(f, b < a);
    }
  }
  std::vector<std::vector<std::pair<std::size_t, bool>>> neighbours(solid.faces.size()); // with whether both agree
  for (const auto& edge : faces) {
    const auto& sides = edge.second;
    if (sides.size() != 2) return false;
    const bool agree = sides[0].second != sides[1].second;
    neighbours[sides[0].first].emplace_back(sides[1].first, agree);
    neighbours[sides[1].first].emplace_back(sides[0].first, agree);
  }
  std::vector<int> turned(solid.faces.size(), -1);
  for (std::size_t first = 0; first < turned.size(); ++first) {
    if (turned[first] >= 0) continue;
    turned[first] = 0;
    std::vector<std::size_t> part{first};
    for (std::size_t k = 0; k < part.size(); ++k)
      for (const auto& [face, agree] : neighbours[part[k]]) {
        const int expected = agree ? turned[part[k]] : 1 - turned[part[k]];
        if (turned[face] < 0) {
          turned[face] = expected;
          part.push_back(face);
        } else if (turned[face] != expected)
          return false;
      }
    Exact volume(0);
    for (std::size_t f : part) {
      const std::vector<std::size_t>& v = solid.faces[f].loops[0].vertices;
      const auto at = [&](std::size_t i) { return solid.vertices[v[i]]; };
      for (std::size_t i = 1; i + 1 < v.size(); ++i)
        volume += Exact(turned[f] ? -1 : 1) * CGAL::determinant(at(0)[0], at(0)[1], at(0)[2], at(i)[0], at(i)[1],
                                                                at(i)[2], at(i + 1)[0], at(i + 1)[1], at(i + 1)[2]);
    }
    for (std::size_t f : part) {
      if ((turned[f] == 1) == (volume > 0)) { // outside out
        Solid::Loop& loop = solid.faces[f].loops[0];
        std::reverse(loop.vertices.begin(), loop.vertices.end());
        std::reverse(loop.edges.begin(), loop.edges.end());
        std::rotate(loop.edges.begin(), loop.edges.begin() + 1, loop.edges.end());
      }
    }
  }
  return true;
}

} // namespace

std::optional<Solid> solid_of_patches(const std::vector<Exact_surface>& surfaces) {
  Solid solid;
  std::vector<Patch_corners> all;
  std::map<Space_point, std::size_t> number;
  for (const Exact_surface& s : surfaces) {
    const std::optional<Patch_corners> corners = corners_of(s);
    if (!corners) return std::nullopt;
    for (const Space_point& p : corners->points)
      if (number.emplace(p, solid.vertices.size()).second) solid.vertices.push_back({p.x(), p.y(), p.z()});
    all.push_back(*corners);
  }
  for (std::size_t patch = 0; patch < all.size(); ++patch) {
    const Patch_corners& c = all[patch];
    Solid::Loop loop;
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const Space_point &a = c.points[i], &b = c.points[(i + 1) % c.points.size()];
      // other corners on this side, in their order
      std::vector<std::pair<Exact, std::size_t>> between;
      const auto first = number.lower_bound((std::min)(a, b)), last = number.upper_bound((std::max)(a, b));
      for (auto p = first; p != last; ++p)
        if (lies_between(a, p->first, b)) between.emplace_back(Exact((p->first - a) * (b - a)), p->second);
      std::sort(between.begin(), between.end());
      loop.vertices.push_back(number.at(a));
      for (const auto& x : between) loop.vertices.push_back(x.second);
      loop.edges.resize(loop.vertices.size(), 4 * patch + c.sides[i]);
    }
    solid.faces.push_back({{std::move(loop)}, ""});
  }
  if (solid.faces.empty() || !orient(solid)) return std::nullopt;
  return solid;
}
