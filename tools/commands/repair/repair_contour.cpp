// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_contour.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>
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

// The harm that moves leave behind; less is better.
struct Harm {
  std::size_t kinks = 0; // that are left next to them
  std::size_t lost = 0;  // joins that are G2 no more
  // the square of the largest distance between old and new points of the curves at equal parameters
  double change = 0;
  friend bool operator<(const Harm& x, const Harm& y) {
    return std::tie(x.kinks, x.lost, x.change) < std::tie(y.kinks, y.lost, y.change);
  }
};

class Contour_mender {
  Grid_contour& contour_;
  const Repair_options& options_;
  const Grid_contour given_ = contour_;
  Contour_repair result_;

  std::size_t next(std::size_t curve) const { return contour_.next(curve); }
  std::size_t previous(std::size_t curve) const { return (curve == 0 ? contour_.curves.size() : curve) - 1; }
  const Points& points(std::size_t curve) const { return contour_.curves[curve].points; }
  std::optional<GC::Visual_class> grade(std::size_t join) const { return ::grade(contour_, join, options_.bound); }

  // The joins at both ends of a curve.
  std::vector<std::size_t> joins_of(std::size_t curve) const {
    std::vector<std::size_t> joins;
    if (contour_.closed || curve > 0) joins.push_back(previous(curve));
    if ((contour_.closed || curve + 1 < contour_.curves.size()) && contour_.curves.size() > 1) joins.push_back(curve);
    return joins;
  }

  void leave(std::size_t join, const std::string& reason) { result_.unrepaired.push_back({join, reason}); }

  bool is_within(const Vector& from, const Vector& to, const CGAL::Exact_rational& bound) const {
    return squared_distance(from, to) <= CGAL::Exact_rational(bound * bound);
  }

  struct Move {
    std::size_t curve, point;
    Vector to;
  };
  typedef std::vector<Move> Moves;

  // Returns the moves back.
  Moves execute(const Moves& moves) {
    Moves back;
    for (const Move& m : moves)
      back.push_back({m.curve, m.point, std::exchange(contour_.curves[m.curve].points[m.point], m.to)});
    return back;
  }

  // The square of the largest value of n t (1-t)^(n-1), by which a handle of a curve of degree n
  // moves its points, times that of the move.
  double change(const Moves& moves) const {
    double most = 0;
    for (const Move& m : moves) {
      const Vector v = m.to - points(m.curve)[m.point];
      const double n = static_cast<double>(points(m.curve).size() - 1), weight = std::pow((n - 1) / n, n - 1),
                   x = static_cast<double>(v.x), y = static_cast<double>(v.y);
      most = (std::max)(most, weight * weight * (x * x + y * y));
    }
    return most;
  }

  // The state of a join next to a move, which must be kept.
  struct State {
    std::size_t join;
    std::optional<GC::Visual_class> grade;
    std::optional<GC::Kink_size> size; // of a kink
  };
  State state(std::size_t join) const {
    State s{join, grade(join), std::nullopt};
    if (s.grade == GC::Visual_class::kink && !points(join).empty() && !points(next(join)).empty())
      s.size = segment_kink(grid_bezier(points(join)), grid_bezier(points(next(join))));
    return s;
  }

  // Returns whether a join is harmed by moves from the contour that was; it has changed to this
  // state.
  bool is_harmed(const State& before, const State& after, const Moves& back) const {
    if (!before.grade) { // an arc that is not known: directions next to it stay as they are
      for (const Move& m : back) {
        const std::size_t n = points(m.curve).size() - 1;
        const bool at_end = m.curve == before.join;
        const Vector node = points(m.curve)[at_end ? n : 0], now = points(m.curve)[m.point];
        const bool next_to_node = m.point == (at_end ? n - 1 : 1);
        const Vector u = m.to - node, v = now - node;
        if (next_to_node && (cross(u, v) != 0 || dot(u, v) <= 0)) return true;
      }
      return false;
    }
    switch (*before.grade) {
    case GC::Visual_class::gap: return false;
    case GC::Visual_class::corner: return after.grade != GC::Visual_class::corner;
    case GC::Visual_class::kink:
      return after.grade < GC::Visual_class::kink ||
             (before.size && after.size &&
              (after.size->angle.upper > before.size->angle.upper ||
               after.size->handle_offset.upper > before.size->handle_offset.upper));
    default: return after.grade < GC::Visual_class::g1;
    }
  }

  // Decides what moves would do: nothing where they are allowed and make the join smooth, otherwise
  // why they are not made.
  std::string objection(std::size_t join, const Moves& moves, const CGAL::Exact_rational& bound, Harm& harm) {
    std::set<std::size_t> joins;
    for (const Move& m : moves) {
      const Vector& from = given_.curves[m.curve].points[m.point];
      if (!is_within(from, m.to, bound))
        return "not on this grid: the nearest position, " + contour_.text(m.to) + ", is " +
               units(GC::sqrt_enclosure(squared_distance(from, m.to))) + " away, and the handle may move by " +
               bound_text(bound);
      for (std::size_t j : joins_of(m.curve)) joins.insert(j);
    }
    harm = {0, 0, change(moves)};
    std::vector<State> before;
    for (std::size_t j : joins) before.push_back(state(j));
    const Moves back = execute(moves);
    bool smooth = grade(join) >= GC::Visual_class::g1;
    for (const State& x : before) {
      const State after = state(x.join);
      smooth = smooth && (x.join == join || !is_harmed(x, after, back));
      harm.kinks += after.grade == GC::Visual_class::kink;
      harm.lost += x.grade == GC::Visual_class::g2 && after.grade == GC::Visual_class::g1;
    }
    execute(back);
    return smooth ? "" : "another join would be harmed";
  }

  // A proposal that would mend a kink.
  struct Proposal {
    std::size_t join;
    Moves moves = {}; // none where there is a reason
    std::string reason = {};
    CGAL::Exact_rational bound = 0; // of the moves
    Harm harm = {};
  };

  // Takes those of the moves that harm least, of equal ones the first.
  void choose(const std::vector<Moves>& choices, Proposal& proposal) {
    for (const Moves& moves : choices) {
      Harm harm;
      const std::string objection = this->objection(proposal.join, moves, proposal.bound, harm);
      if (proposal.moves.empty() && proposal.reason.empty()) proposal.reason = objection;
      if (!objection.empty() || (!proposal.moves.empty() && !(harm < proposal.harm))) continue;
      proposal.moves = moves;
      proposal.harm = harm;
      proposal.reason.clear();
    }
    if (proposal.moves.empty() && proposal.reason.empty()) proposal.reason = "no handle can move";
  }

  static std::string bound_text(const CGAL::Exact_rational& bound) { return rounded_up(CGAL::to_double(bound)); }

  // Returns whether the node between two quadratics may be left out, so that it would move with
  // their handles. A repair may make it so.
  bool may_be_left_out(std::size_t join) const {
    const Points &left = points(join), &right = points(next(join));
    return contour_.may_leave_nodes_out && left.size() == 3 && right.size() == 3 &&
           left[2] - left[1] == right[1] - right[0];
  }

  // Returns whether the handle of a curve belongs to one node.
  bool is_free(std::size_t curve) const {
    const Grid_curve& c = contour_.curves[curve];
    return !c.fixed && c.points.size() >= 4 && !is_line(c.points);
  }
  bool is_free_quadratic(std::size_t curve) const {
    const Grid_curve& c = contour_.curves[curve];
    return !c.fixed && c.points.size() == 3 && !is_line(c.points) && !may_be_left_out(previous(curve)) &&
           !may_be_left_out(curve);
  }

  bool is_movable(std::size_t curve) const { return is_free(curve) || is_free_quadratic(curve); }

  // The direction in which a curve ends or starts: that of the chord for a line. Zero where a
  // handle lies at the node, nothing where no vector of the grid has it.
  std::optional<Vector> first_difference(std::size_t curve, bool at_end) const {
    const Grid_curve& c = contour_.curves[curve];
    if (c.arc) return arc_direction(*c.arc, at_end);
    const Points& p = c.points;
    if (is_line(p)) return p.back() - p.front();
    return at_end ? p.back() - p[p.size() - 2] : p[1] - p[0];
  }

  static bool is_short(const Vector& v) {
    return (std::max)((std::abs)(v.x), (std::abs)(v.y)) <= GC::max_handle_coordinate;
  }

  // How far a handle may move for a kink between these handles: twice what it is off and one unit.
  CGAL::Exact_rational max_move(std::size_t join, const Vector& a, const Vector& b) const {
    if (options_.max_move) return *options_.max_move;
    const Grid_curve &left = contour_.curves[join], &right = contour_.curves[next(join)];
    double off = 0;
    if (left.arc || right.arc) { // the distance of the tip of the handle from the tangent
      const CGAL::Exact_rational c = exact(cross(a, b));
      const Vector& tangent = left.arc ? a : b;
      off = GC::sqrt_enclosure(CGAL::Exact_rational(c * c / exact(squared_length(tangent)))).lower;
    } else
      off = segment_kink(grid_bezier(left.points), grid_bezier(right.points))->handle_offset.lower;
    return CGAL::Exact_rational(2 * CGAL::Exact_rational(off) + 1);
  }

  Proposal propose(std::size_t join) {
    const std::size_t left = join, right = next(join);
    const std::optional<Vector> in = first_difference(left, true), out = first_difference(right, false);
    if (!in || !out) return {join, {}, "no point of the grid lies in the direction of the arc"};
    const Vector zero{0, 0}, a = *in, b = *out;
    if (a == zero || b == zero) return {join, {}, "a handle lies at the node"};
    if (!is_short(a) || !is_short(b)) return {join, {}, "a handle is longer than 2^28 units of the grid"};
    if (dot(a, b) < (std::abs)(cross(a, b))) return {join, {}, "the angle is more than 45 degrees"};
    Proposal proposal{join, {}, "", max_move(join, a, b)};
    std::vector<Moves> choices;
    const std::size_t degree = points(left).size();
    const bool are_alike = is_movable(left) && is_movable(right) && degree == points(right).size();
    if (const std::optional<Moves> moves = are_alike ? symmetric(join, a, b) : std::nullopt) {
      choose({*moves}, proposal);
      return proposal;
    }
    if (is_free(left) && is_free(right)) {
      if (const std::optional<GC::Aligned_handles> handles = aligned(a, b, proposal.bound))
        choices.push_back({to_left(join, handles->left), to_right(join, handles->right)});
      choices.push_back({to_left(join, GC::align_handle(a, b))});
      choices.push_back({to_right(join, GC::align_handle(b, a))});
      if (rank(a) < rank(b)) std::swap(choices[choices.size() - 1], choices[choices.size() - 2]);
    } else if (is_free(left))
      choices = {{to_left(join, GC::align_handle(a, b))}};
    else if (is_free(right))
      choices = {{to_right(join, GC::align_handle(b, a))}};
    std::string reason;
    const bool right_first = rank(a) < rank(b);
    for (const bool of_right : {right_first, !right_first}) {
      const std::size_t curve = of_right ? right : left;
      if (is_free_quadratic(curve)) add_quadratic(join, curve, of_right ? a : b, choices, reason);
    }
    if (choices.empty() && !reason.empty())
      proposal.reason = reason;
    else
      choose(choices, proposal);
    return proposal;
  }

  // Returns numbers that distinguish handles that are no mirror images of each other, whichever way
  // the contour is run through.
  static std::pair<std::int64_t, std::int64_t> rank(const Vector& v) {
    return {squared_length(v), (std::max)((std::abs)(v.x), (std::abs)(v.y))};
  }

  Move to_left(std::size_t join, const Vector& difference) const {
    const std::size_t n = points(join).size() - 1;
    return {join, n - 1, points(join)[n] - difference};
  }
  Move to_right(std::size_t join, const Vector& difference) const {
    return {next(join), 1, points(next(join))[0] + difference};
  }

  // Handles that are mirror images of each other stay so: on a line of the grid at a right angle to
  // the axis. Nothing for other handles.
  std::optional<Moves> symmetric(std::size_t join, const Vector& a, const Vector& b) const {
    for (const Vector& d : {Vector{1, 0}, Vector{0, 1}, Vector{1, 1}, Vector{1, -1}}) {
      if (cross(d, a) != -cross(d, b) || dot(d, a) != dot(d, b)) continue;
      const Vector direction = dot(d, a) < 0 ? -1 * d : d;
      const Vector difference = GC::align_handle(a, direction);
      return Moves{to_left(join, difference), to_right(join, difference)};
    }
    return std::nullopt;
  }

  // align_handles() in coordinates in which mirror images are one: in the first octant with the
  // longer difference first, seen from there to the left. So their handles move to mirror images,
  // also where several positions are equally near.
  static std::optional<GC::Aligned_handles> aligned(const Vector& a, const Vector& b,
                                                    const CGAL::Exact_rational& most) {
    const bool turned = rank(a) < rank(b);
    const Vector &first = turned ? b : a, &second = turned ? a : b;
    for (const bool swap : {false, true})
      for (const std::int64_t sx : {1, -1})
        for (const std::int64_t sy : {1, -1}) {
          const auto image = [&](const Vector& v) -> Vector {
            return swap ? Vector{sy * v.y, sx * v.x} : Vector{sx * v.x, sy * v.y};
          };
          const auto preimage = [&](const Vector& v) -> Vector {
            return swap ? Vector{sx * v.y, sy * v.x} : Vector{sx * v.x, sy * v.y};
          };
          const Vector u = image(first), v = image(second);
          const bool on_axis = u.y == 0 || u.x == u.y;
          if (u.y < 0 || u.x < u.y || (on_axis && cross(u, v) < 0) || (u.y == 0 && u.x <= 0)) continue;
          const double squared = (std::min)(CGAL::to_double(most * most), 1e18);
          const std::optional<GC::Aligned_handles> handles =
              GC::align_handles(u, v, static_cast<std::int64_t>(squared));
          if (!handles) return std::nullopt;
          const Vector x = preimage(handles->left), y = preimage(handles->right);
          return turned ? GC::Aligned_handles{y, x} : GC::Aligned_handles{x, y};
        }
    return std::nullopt;
  }

  // The handle of a quadratic belongs to both of its nodes: it moves to where the tangents at both
  // intersect, or, where the other join is not to be smooth, along that at this node.
  void add_quadratic(std::size_t join, std::size_t curve, const Vector& direction, std::vector<Moves>& choices,
                     std::string& reason) const {
    const bool at_end = curve == join;
    const Points& p = points(curve);
    const Vector &node = at_end ? p[2] : p[0], &other = at_end ? p[0] : p[2], handle = p[1];
    const std::size_t other_join = at_end ? previous(curve) : curve;
    const std::vector<std::size_t> joins = joins_of(curve);
    std::optional<GC::Visual_class> there;
    const bool has_other = std::count(joins.begin(), joins.end(), other_join) != 0 && other_join != join;
    if (has_other) there = grade(other_join);
    const bool bound = has_other && (!there || *there >= GC::Visual_class::g1);
    const Vector difference = at_end ? node - handle : handle - node, d = GC::primitive(direction);
    if (!bound) {
      const Vector nearest = GC::align_handle(difference, d);
      choices.push_back({{curve, 1, at_end ? node - nearest : node + nearest}});
      if (there != GC::Visual_class::kink) return;
    }
    // node -+ k d = other + t e, where e is the tangent at the other node
    Vector e = handle - other;
    if (!bound) {
      const std::optional<Vector> neighbour =
          at_end ? first_difference(previous(curve), true) : first_difference(next(curve), false);
      if (!neighbour || *neighbour == Vector{0, 0}) return;
      e = at_end ? *neighbour : -1 * *neighbour;
    }
    const Vector to_other = at_end ? node - other : other - node;
    const CGAL::Exact_rational denominator = CGAL::Exact_rational(exact(d.x) * exact(e.y) - exact(d.y) * exact(e.x));
    if (denominator == 0) {
      if (bound) reason = "both nodes of a quadratic bind its handle to parallel lines";
      return;
    }
    const CGAL::Exact_rational k = CGAL::Exact_rational(
        CGAL::Exact_rational(exact(to_other.x) * exact(e.y) - exact(to_other.y) * exact(e.x)) / denominator);
    const double rounded = std::round(CGAL::to_double(k));
    if (!(1 <= rounded && rounded < double(GC::max_handle_coordinate)) || CGAL::Exact_rational(rounded) != k) {
      if (bound) reason = "both nodes bind the handle of a quadratic, and the only place for it is not on this grid";
      return;
    }
    const std::int64_t steps = static_cast<std::int64_t>(rounded);
    choices.push_back({{curve, 1, at_end ? node - steps * d : node + steps * d}});
  }

  // The side of a node for harmonising. A handle of a cubic moves the curvature at the other end,
  // too: it stays where that is G2.
  GC::Handle_side side(std::size_t curve, bool at_end) const {
    const Points& p = points(curve);
    const std::size_t n = p.size() - 1;
    const std::size_t other = at_end ? previous(curve) : curve;
    const std::vector<std::size_t> joins = joins_of(curve);
    const bool keeps =
        n == 3 && std::count(joins.begin(), joins.end(), other) != 0 && grade(other) == GC::Visual_class::g2;
    return {at_end ? p[n] - p[n - 1] : p[1] - p[0], at_end ? p[n] - p[n - 2] : p[2] - p[0], static_cast<int>(n),
            is_free(curve) && !keeps};
  }

  // Nothing where a handle lies at the node.
  std::optional<GC::Enclosure> jump(std::size_t join) const {
    return GC::deviation(grid_bezier(points(join)), grid_bezier(points(next(join)))).curvature_jump;
  }

  // The sum over all joins of the curves that moves change; of those with an arc there is none. As
  // only what lessens it is accepted, the sum over all joins decreases.
  double sum_of_jumps(const std::vector<Move>& moves) const {
    std::set<std::size_t> joins;
    for (const Move& m : moves)
      for (std::size_t j : joins_of(m.curve)) joins.insert(j);
    double sum = 0;
    for (std::size_t j : joins)
      if (is_bezier_join(j) && grade(j) == GC::Visual_class::g1)
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
    if (a.handle == zero || b.handle == zero) return "a handle lies at the node";
    if (!a.movable && !b.movable) return "no handle can move without harm to a join that is G2";
    const CGAL::Exact_rational bound = max_change({a.handle, b.handle});
    std::optional<GC::Aligned_handles> handles;
    try {
      const double squared = (std::min)(CGAL::to_double(bound * bound), 1e15);
      handles = GC::harmonise_handles(a, b, static_cast<std::int64_t>(squared));
    } catch (const GC::Error& error) {
      return error.what();
    }
    if (!handles) return "the curvatures have different signs, or one of them is zero";
    if (handles->left == a.handle && handles->right == b.handle) return "";
    std::vector<Move> moves;
    if (a.movable) moves.push_back({left, points(left).size() - 2, node - handles->left});
    if (b.movable) moves.push_back({right, 1, node + handles->right});
    const double before = sum_of_jumps(moves);
    std::vector<Move> back;
    for (const Move& m : moves) back.push_back({m.curve, m.point, points(m.curve)[m.point]});
    Harm harm;
    const std::string reason = objection(join, moves, bound, harm);
    if (!reason.empty()) return reason;
    execute(moves);
    if (sum_of_jumps(moves) < before) return "";
    execute(back);
    return ""; // the jumps next to it would grow by more
  }

  // A tenth of the shorter one of these handles as they were given.
  CGAL::Exact_rational max_change(std::initializer_list<Vector> handles) const {
    if (options_.max_move) return *options_.max_move;
    double shortest = 1e300;
    for (const Vector& difference : handles)
      shortest = (std::min)(shortest, std::hypot(double(difference.x), double(difference.y)));
    return CGAL::Exact_rational((std::max)(1., std::floor(shortest / 10)));
  }

  // Returns whether a proposal waits for that of a join next to it, with which it shares the handle
  // of a quadratic: what harms less comes first, and of what is equal nothing unless both agree on
  // the handle.
  bool waits(const Proposal& x, const Proposal& y) const {
    const std::size_t shared = next(x.join) == y.join ? y.join : x.join;
    if (x.join == y.join || points(shared).size() != 3 || y.moves.empty() || x.harm < y.harm) return false;
    if (y.harm < x.harm) return true;
    const auto place_of_handle = [&](const Proposal& p) -> std::optional<Vector> {
      for (const Move& m : p.moves)
        if (m.curve == shared) return m.to;
      return std::nullopt;
    };
    return place_of_handle(x) != place_of_handle(y);
  }

  // Mends what the proposals say, unless they contradict each other. Returns whether a kink was
  // mended.
  bool mend(const std::vector<Proposal>& proposals) {
    const auto at = [&](std::size_t join) {
      const auto found = std::lower_bound(proposals.begin(), proposals.end(), join,
                                          [](const Proposal& p, std::size_t j) { return p.join < j; });
      return found != proposals.end() && found->join == join ? &*found : nullptr;
    };
    bool any = false;
    for (const Proposal& p : proposals) {
      const Proposal *const before = at(previous(p.join)), *const after = at(next(p.join));
      if (p.moves.empty() || (before && waits(p, *before)) || (after && waits(p, *after))) continue;
      Harm harm;
      if (grade(p.join) != GC::Visual_class::kink || !objection(p.join, p.moves, p.bound, harm).empty()) continue;
      execute(p.moves);
      any = true;
    }
    return any;
  }

  void repair_kinks() {
    std::vector<Proposal> proposals;
    do {
      proposals.clear();
      for (std::size_t j = 0; j < contour_.number_of_joins(); ++j)
        if (grade(j) == GC::Visual_class::kink) proposals.push_back(propose(j));
    } while (mend(proposals)); // one repair may make room for another
    for (const Proposal& p : proposals)
      leave(p.join, p.reason.empty() ? "the handle would have to move to two places" : p.reason);
    for (std::size_t j = 0; j < contour_.number_of_joins(); ++j)
      if (grade(j) == GC::Visual_class::gap)
        leave(j,
              "a gap, as the next curve starts at " + contour_.text(points(next(j)).front()) + ": nodes do not move");
  }

  void count_undecided() {
    for (std::size_t j = 0; j < contour_.number_of_joins(); ++j)
      if (!grade(j)) {
        const Grid_curve &left = contour_.curves[j], &right = contour_.curves[next(j)];
        const std::string& reason = left.reason.empty() ? right.reason : left.reason;
        ++result_.undecided[reason.empty() ? "a curve has no length" : reason];
      }
  }

  void harmonise_all() {
    std::vector<Curvature_jump> jumps;
    for (std::size_t j = 0; j < contour_.number_of_joins(); ++j)
      if (is_bezier_join(j) && grade(j) == GC::Visual_class::g1)
        if (const std::optional<GC::Enclosure> before = jump(j)) jumps.push_back({j, *before, *before, ""});
    for (int pass = 0; pass < passes; ++pass)
      for (Curvature_jump& x : jumps)
        if (grade(x.join) == GC::Visual_class::g1) x.reason = harmonise(x.join);
    for (Curvature_jump& x : jumps) {
      x.after = grade(x.join) == GC::Visual_class::g2 ? GC::Enclosure{0, 0} : *jump(x.join);
      if (x.after.upper == 0) x.reason.clear();
    }
    result_.jumps = std::move(jumps);
  }

  bool is_bezier_join(std::size_t join) const { return !points(join).empty() && !points(next(join)).empty(); }

public:
  Contour_mender(Grid_contour& contour, const Repair_options& options) : contour_(contour), options_(options) {}

  // Makes the kinks smooth.
  Contour_repair mend() {
    repair_kinks();
    count_undecided();
    return std::move(result_);
  }

  // Makes the curvatures of smooth joins agree.
  std::vector<Curvature_jump> harmonise() {
    harmonise_all();
    return std::move(result_.jumps);
  }
};

bool same_points(const Grid_contour& x, const Grid_contour& y) {
  return std::equal(x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
                    [](const Grid_curve& c, const Grid_curve& d) { return c.points == d.points; });
}

bool moves_within(const Grid_contour& from, const Grid_contour& to, const CGAL::Exact_rational& bound) {
  const CGAL::Exact_rational squared = CGAL::Exact_rational(bound * bound);
  for (std::size_t i = 0; i < from.curves.size(); ++i)
    for (std::size_t k = 0; k < from.curves[i].points.size(); ++k)
      if (squared < squared_distance(from.curves[i].points[k], to.curves[i].points[k])) return false;
  return true;
}

// Makes the curvatures agree such that doing it again would change nothing. Where handles would go
// on and on, beyond how far they may, they all stay.
std::vector<Curvature_jump> harmonised(Grid_contour& contour, const Repair_options& options) {
  constexpr int most_rounds = 16;
  Grid_contour result = contour;
  std::vector<Curvature_jump> jumps = Contour_mender(result, options).harmonise();
  Grid_contour again = result;
  for (int round = 0; round < most_rounds; ++round) {
    Contour_mender(again, options).mend();
    Contour_mender(again, options).harmonise();
    if (same_points(again, result)) {
      contour = result;
      return jumps;
    }
    if (options.max_move && !moves_within(contour, again, *options.max_move)) break;
    result = again;
    for (Curvature_jump& x : jumps) {
      const std::size_t next = result.next(x.join);
      x.after = grade(result, x.join, options.bound) == GC::Visual_class::g2
                    ? GC::Enclosure{0, 0}
                    : *GC::deviation(grid_bezier(result.curves[x.join].points), grid_bezier(result.curves[next].points))
                           .curvature_jump;
    }
  }
  for (Curvature_jump& x : jumps) {
    x.after = x.before;
    x.reason = "the lengths of the handles find no rest within the allowed moves";
  }
  return jumps;
}

} // namespace

GC::Enclosure Handle_move::distance() const { return GC::sqrt_enclosure(squared_distance(from, to)); }

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
  const Grid_contour given = contour;
  Contour_repair result = Contour_mender(contour, options).mend();
  // A repair that was impossible before may be possible now; a given limit holds for all rounds
  // together.
  for (bool more = !same_points(contour, given) && !result.unrepaired.empty(); more;) {
    Grid_contour again = contour;
    Contour_repair next = Contour_mender(again, options).mend();
    more = next.unrepaired.size() < result.unrepaired.size() &&
           (!options.max_move || moves_within(given, again, *options.max_move));
    if (!more) break;
    contour = std::move(again);
    result = std::move(next);
  }
  if (options.harmonise) {
    result.jumps = harmonised(contour, options);
    const auto is_mended = [&](const Unrepaired_join& x) { // as other handles have moved
      return grade(contour, x.join, options.bound) >= GC::Visual_class::g1;
    };
    std::vector<Unrepaired_join>& left = result.unrepaired;
    left.erase(std::remove_if(left.begin(), left.end(), is_mended), left.end());
  }
  std::set<std::size_t> touched;
  for (std::size_t i = 0; i < contour.curves.size(); ++i)
    for (std::size_t k = 0; k < contour.curves[i].points.size(); ++k) {
      const GC::Grid_vector &from = given.curves[i].points[k], &to = contour.curves[i].points[k];
      if (from == to) continue;
      result.moves.push_back({i, k, from, to});
      touched.insert(i);
      touched.insert(i == 0 ? contour.curves.size() - 1 : i - 1);
    }
  for (std::size_t j : touched)
    if (j < contour.number_of_joins() && grade(given, j, options.bound) == GC::Visual_class::g2 &&
        grade(contour, j, options.bound) == GC::Visual_class::g1)
      result.lost.push_back(j);
  return result;
}
