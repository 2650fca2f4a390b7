// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_contour.h"

#include <CGAL/Geometric_continuity/extensions/align_handles.h>
#include <CGAL/Geometric_continuity/extensions/harmonise_handles.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace {

typedef GC::Grid_vector Vector;
typedef std::vector<Vector> Points;

constexpr int passes = 8; // over the joins to be harmonised: each changes the curvatures next to it

CGAL::Exact_rational exact(std::int64_t x) {
  return CGAL::Exact_rational(static_cast<double>(x)); // of at most 2^51
}

CGAL::Exact_rational squared_distance(const Vector& p, const Vector& q) {
  const CGAL::Exact_rational x = exact(p.x - q.x), y = exact(p.y - q.y);
  return CGAL::Exact_rational(x * x + y * y);
}

class Contour_mender {
  Grid_contour& contour_;
  const Repair_options& options_;
  const Grid_contour given_ = contour_;
  Contour_repair result_;

  std::size_t next(std::size_t curve) const { return curve + 1 == contour_.curves.size() ? 0 : curve + 1; }
  std::size_t previous(std::size_t curve) const { return (curve == 0 ? contour_.curves.size() : curve) - 1; }
  const Points& points(std::size_t curve) const { return contour_.curves[curve].points; }
  std::optional<GC::Join_grade> grade(std::size_t join) const { return ::grade(contour_, join, options_.bound); }

  // The joins at both ends of a curve.
  std::vector<std::size_t> joins_of(std::size_t curve) const {
    std::vector<std::size_t> joins;
    if (contour_.closed || curve > 0) joins.push_back(previous(curve));
    if (contour_.closed || curve + 1 < contour_.curves.size()) joins.push_back(curve);
    return joins;
  }

  void leave(std::size_t join, const std::string& reason) { result_.unrepaired.push_back({join, reason}); }

  bool is_within(const Vector& from, const Vector& to, const CGAL::Exact_rational& bound) const {
    return squared_distance(from, to) <= CGAL::Exact_rational(bound * bound);
  }

  // A tenth of the shorter one of these handles as they were given.
  CGAL::Exact_rational max_move(std::initializer_list<Vector> legs) const {
    if (options_.max_move) return *options_.max_move;
    double shortest = 1e300;
    for (const Vector& leg : legs) shortest = (std::min)(shortest, std::hypot(double(leg.x), double(leg.y)));
    return CGAL::Exact_rational((std::max)(1., std::floor(shortest / 10)));
  }

  struct Move {
    std::size_t curve, point;
    Vector to;
  };

  // Returns the moves back.
  std::vector<Move> execute(const std::vector<Move>& moves) {
    std::vector<Move> back;
    for (const Move& m : moves)
      back.push_back({m.curve, m.point, std::exchange(contour_.curves[m.curve].points[m.point], m.to)});
    return back;
  }

  // Moves control points unless one of them moves by more than the bound, the join does not become smooth by it, or another join is
  // smooth no more. Returns why not.
  std::string moved(std::size_t join, const std::vector<Move>& moves, const CGAL::Exact_rational& bound) {
    std::vector<std::size_t> joins;
    for (const Move& m : moves) {
      const Vector& from = given_.curves[m.curve].points[m.point];
      if (!is_within(from, m.to, bound))
        return "not on this grid: the nearest position, " + contour_.text(m.to) + ", is " +
               units(GC::root_enclosure(squared_distance(from, m.to))) + " away, and the handle may move by " +
               bound_text(bound);
      for (std::size_t j : joins_of(m.curve)) joins.push_back(j);
    }
    std::vector<std::optional<GC::Join_grade>> before;
    for (std::size_t j : joins) before.push_back(grade(j));
    const std::vector<Move> back = execute(moves);
    bool smooth = grade(join) >= GC::Join_grade::g1;
    for (std::size_t i = 0; i < joins.size(); ++i)
      smooth = smooth && (!before[i] || grade(joins[i]) >= (std::min)(*before[i], GC::Join_grade::g1));
    if (smooth) return "";
    execute(back);
    return "another join would be smooth no more";
  }

  static std::string bound_text(const CGAL::Exact_rational& bound) {
    std::ostringstream os;
    os << CGAL::to_double(bound);
    return os.str();
  }

  // Whether the handle of a curve belongs to one node.
  bool is_free(std::size_t curve) const {
    const Grid_curve& c = contour_.curves[curve];
    return !c.fixed && c.points.size() >= 4 && !is_line(c.points);
  }
  bool is_free_quadratic(std::size_t curve) const {
    const Grid_curve& c = contour_.curves[curve];
    return !c.fixed && c.points.size() == 3 && !is_line(c.points);
  }

  // The direction in which a curve ends or starts: that of the chord for a line.
  Vector leg(std::size_t curve, bool at_end) const {
    const Points& p = points(curve);
    if (is_line(p)) return p.back() - p.front();
    return at_end ? p.back() - p[p.size() - 2] : p[1] - p[0];
  }

  void repair_kink(std::size_t join) {
    const std::size_t left = join, right = next(join);
    const Vector zero{0, 0}, node = points(right).front(), a = leg(left, true), b = leg(right, false);
    if (a == zero || b == zero) return leave(join, "a handle lies at the node");
    for (const Vector& v : {a, b})
      if ((std::max)((std::abs)(v.x), (std::abs)(v.y)) > GC::max_leg)
        return leave(join, "a handle is longer than 2^28 units of the grid");
    const std::size_t end = points(left).size() - 2;
    std::string reason;
    if (is_free(left) && is_free(right)) {
      const std::optional<GC::Aligned_handles> legs = GC::align_handles(a, b);
      if (!legs) return leave(join, "the angle is more than 45 degrees");
      reason = moved(join, {{left, end, node - legs->left}, {right, 1, node + legs->right}}, max_move({a, b}));
    } else if (is_free(left))
      reason = moved(join, {{left, end, node - GC::align_handle(a, b)}}, max_move({a}));
    else if (is_free(right))
      reason = moved(join, {{right, 1, node + GC::align_handle(b, a)}}, max_move({b}));
    else if (is_free_quadratic(left))
      reason = repair_quadratic(join, left, b);
    else if (is_free_quadratic(right))
      reason = repair_quadratic(join, right, a);
    else
      reason = "no handle can move";
    if (!reason.empty()) leave(join, reason);
  }

  // The handle of a quadratic belongs to both of its nodes: it moves along its leg at the other node if the join there is smooth.
  std::string repair_quadratic(std::size_t join, std::size_t curve, const Vector& direction) {
    const bool at_end = curve == join;
    const Points& p = points(curve);
    const Vector &node = at_end ? p[2] : p[0], &other = at_end ? p[0] : p[2], handle = p[1];
    const std::size_t other_join = at_end ? previous(curve) : curve;
    const std::vector<std::size_t> joins = joins_of(curve);
    const bool bound = std::count(joins.begin(), joins.end(), other_join) != 0 && other_join != join &&
                       grade(other_join) >= GC::Join_grade::g1;
    const Vector leg = at_end ? node - handle : handle - node, d = GC::primitive(direction);
    const auto at = [&](std::int64_t k) { return at_end ? node - k * d : node + k * d; };
    const CGAL::Exact_rational most = max_move({leg, other - handle});
    if (!bound)
      return moved(join, {{curve, 1, at_end ? node - GC::align_handle(leg, d) : node + GC::align_handle(leg, d)}},
                   most);
    // node -+ k d = other + t e
    const Vector e = handle - other, to_other = at_end ? node - other : other - node;
    const CGAL::Exact_rational numerator = CGAL::Exact_rational(exact(to_other.x) * exact(e.y) -
                                                                exact(to_other.y) * exact(e.x)),
                               denominator = CGAL::Exact_rational(exact(d.x) * exact(e.y) - exact(d.y) * exact(e.x));
    if (denominator == 0) return "both nodes of a quadratic bind its handle to parallel lines";
    const CGAL::Exact_rational k = CGAL::Exact_rational(numerator / denominator);
    const double rounded = std::round(CGAL::to_double(k));
    if (!(1 <= rounded && rounded < double(GC::max_leg)) || CGAL::Exact_rational(rounded) != k)
      return "both nodes bind the handle of a quadratic, and the only place for it is not on this grid";
    return moved(join, {{curve, 1, at(static_cast<std::int64_t>(rounded))}}, most);
  }

  // The side of a node for harmonising. A handle of a cubic moves the curvature at the other end, too: it stays where that is G2.
  GC::Handle_side side(std::size_t curve, bool at_end) const {
    const Points& p = points(curve);
    const std::size_t n = p.size() - 1;
    const std::size_t other = at_end ? previous(curve) : curve;
    const std::vector<std::size_t> joins = joins_of(curve);
    const bool keeps =
        n == 3 && std::count(joins.begin(), joins.end(), other) != 0 && grade(other) == GC::Join_grade::g2;
    return {at_end ? p[n] - p[n - 1] : p[1] - p[0], at_end ? p[n] - p[n - 2] : p[2] - p[0], static_cast<int>(n),
            is_free(curve) && !keeps};
  }

  // Nothing where a handle lies at the node.
  std::optional<GC::Enclosure> jump(std::size_t join) const {
    return GC::deviation(grid_bezier(points(join)), grid_bezier(points(next(join)))).curvature_jump;
  }

  // The sum over all joins of the curves that moves change. As only what lessens it is accepted, the sum over all joins decreases.
  double sum_of_jumps(const std::vector<Move>& moves) const {
    std::set<std::size_t> joins;
    for (const Move& m : moves)
      for (std::size_t j : joins_of(m.curve)) joins.insert(j);
    double sum = 0;
    for (std::size_t j : joins)
      if (grade(j) == GC::Join_grade::g1)
        if (const std::optional<GC::Enclosure> x = jump(j)) sum += x->upper;
    return sum;
  }

  // Returns why the curvatures cannot be made to agree better.
  std::string harmonise(std::size_t join) {
    const std::size_t left = join, right = next(join);
    if (points(left).size() < 3 || points(right).size() < 3 || is_line(points(left)) || is_line(points(right)))
      return "a line has no curvature";
    const GC::Handle_side a = side(left, true), b = side(right, false);
    const Vector zero{0, 0}, node = points(right).front();
    if (a.leg == zero || b.leg == zero) return "a handle lies at the node";
    if (!a.movable && !b.movable) return "no handle can move without harm to a join that is G2";
    const CGAL::Exact_rational bound = max_move({a.leg, b.leg});
    std::optional<GC::Aligned_handles> legs;
    try {
      const double squared = (std::min)(CGAL::to_double(bound * bound), 1e15);
      legs = GC::harmonise_handles(a, b, static_cast<std::int64_t>(squared));
    } catch (const GC::Error& error) {
      return error.what();
    }
    if (!legs) return "the curvatures have different signs, or one of them is zero";
    if (legs->left == a.leg && legs->right == b.leg) return "";
    std::vector<Move> moves;
    if (a.movable) moves.push_back({left, points(left).size() - 2, node - legs->left});
    if (b.movable) moves.push_back({right, 1, node + legs->right});
    const double before = sum_of_jumps(moves);
    std::vector<Move> back;
    for (const Move& m : moves) back.push_back({m.curve, m.point, points(m.curve)[m.point]});
    const std::string reason = moved(join, moves, bound);
    if (!reason.empty() || sum_of_jumps(moves) < before) return reason;
    execute(back);
    return ""; // the jumps next to it would grow by more
  }

  // Returns how many kinks are left.
  std::size_t repair_kinks() {
    result_ = Contour_repair();
    for (std::size_t j = 0; j < contour_.number_of_joins(); ++j) {
      const std::optional<GC::Join_grade> g = grade(j);
      if (!g) {
        const Grid_curve &left = contour_.curves[j], &right = contour_.curves[next(j)];
        const std::string& reason = left.reason.empty() ? right.reason : left.reason;
        ++result_.undecided[reason.empty() ? "a curve has no length" : reason];
      } else if (*g == GC::Join_grade::kink)
        repair_kink(j);
    }
    return result_.unrepaired.size();
  }

  void harmonise_all() {
    std::vector<Curvature_jump> jumps;
    for (std::size_t j = 0; j < contour_.number_of_joins(); ++j)
      if (grade(j) == GC::Join_grade::g1)
        if (const std::optional<GC::Enclosure> before = jump(j)) jumps.push_back({j, *before, *before, ""});
    for (int pass = 0; pass < passes; ++pass)
      for (Curvature_jump& x : jumps)
        if (grade(x.join) == GC::Join_grade::g1) x.reason = harmonise(x.join);
    for (Curvature_jump& x : jumps) {
      x.after = grade(x.join) == GC::Join_grade::g2 ? GC::Enclosure{0, 0} : *jump(x.join);
      if (x.after.upper == 0) x.reason.clear();
    }
    result_.jumps = std::move(jumps);
  }

public:
  Contour_mender(Grid_contour& contour, const Repair_options& options) : contour_(contour), options_(options) {}

  Contour_repair repair() {
    std::size_t left = repair_kinks();
    for (std::size_t before = left + 1; left != 0 && left < before;) { // one repair may make room for another
      before = left;
      left = repair_kinks();
    }
    if (options_.harmonise) harmonise_all();
    for (std::size_t i = 0; i < contour_.curves.size(); ++i)
      for (std::size_t k = 0; k < points(i).size(); ++k)
        if (points(i)[k] != given_.curves[i].points[k])
          result_.moves.push_back({i, k, given_.curves[i].points[k], points(i)[k]});
    return result_;
  }
};

} // namespace

GC::Enclosure Handle_move::distance() const { return GC::root_enclosure(squared_distance(from, to)); }

std::string rounded_up(double x) {
  std::ostringstream os;
  os.precision(4);
  os << GC::Enclosure{x, x}; // is rounded outwards
  const std::string text = os.str();
  const std::size_t comma = text.find(", ");
  return comma == std::string::npos ? text : text.substr(comma + 2, text.size() - comma - 3);
}

std::string units(const GC::Enclosure& distance) {
  const std::string number = rounded_up(distance.upper);
  return number + (number == "1" ? " unit" : " units");
}

Contour_repair repair(Grid_contour& contour, const Repair_options& options) {
  return Contour_mender(contour, options).repair();
}
