// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_contour.h"

#include "commands/repair/decimal_text.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
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

// The vector between two points that lie beside the grid by these offsets.
Grid_offset difference(const Vector& p, const Grid_offset& p_offset, const Vector& q, const Grid_offset& q_offset) {
  return Grid_offset(exact(q.x - p.x), exact(q.y - p.y)) + (q_offset - p_offset);
}

CGAL::Exact_rational cross_product(const Grid_offset& u, const Grid_offset& v) {
  return CGAL::Exact_rational(u.x() * v.y() - u.y() * v.x());
}

std::optional<GC::Kink_size> kink_size(const Grid_contour& contour, std::size_t join) {
  const Grid_curve &left = contour.curves[join], &right = contour.curves[contour.next(join)];
  return contour.is_beside_grid ? segment_kink(exact_bezier(left), exact_bezier(right))
                                : segment_kink(grid_bezier(left.points), grid_bezier(right.points));
}

// Nothing where a handle lies at the node.
std::optional<GC::Enclosure> curvature_jump(const Grid_contour& contour, std::size_t join) {
  const Grid_curve &left = contour.curves[join], &right = contour.curves[contour.next(join)];
  return contour.is_beside_grid ? GC::deviation(exact_bezier(left), exact_bezier(right)).curvature_jump
                                : GC::deviation(grid_bezier(left.points), grid_bezier(right.points)).curvature_jump;
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
  bool is_line(std::size_t curve) const { return ::is_line(contour_.curves[curve]); }
  std::optional<GC::Visual_class> grade(std::size_t join) const { return ::grade(contour_, join, options_.bound); }

  // The joins at both ends of a curve.
  std::vector<std::size_t> joins_of(std::size_t curve) const {
    std::vector<std::size_t> joins;
    if (contour_.closed || curve > 0) joins.push_back(previous(curve));
    if ((contour_.closed || curve + 1 < contour_.curves.size()) && contour_.curves.size() > 1) joins.push_back(curve);
    return joins;
  }

  void leave(std::size_t join, const std::string& reason) { result_.unrepaired.push_back({join, reason}); }

  struct Move {
    std::size_t curve, point;
    Vector to;
    Grid_offset offset = Grid_offset(0, 0); // beside the grid
  };
  typedef std::vector<Move> Moves;

  // The control point of a curve that tells its tangent at an end: the next one, or where that lies
  // at the node the one behind it.
  std::size_t tip(std::size_t curve, bool at_end) const {
    const Grid_curve& c = contour_.curves[curve];
    const std::size_t n = c.points.size() - 1, node = at_end ? n : 0;
    const auto at = [&](std::size_t k) { return at_end ? n - k : k; };
    std::size_t k = 1;
    while (k + 1 < n && c.points[at(k)] == c.points[node] && offset(c, at(k)) == offset(c, node)) ++k;
    return at(k);
  }

  // Returns the moves back.
  Moves execute(const Moves& moves) {
    Moves back;
    for (const Move& m : moves) {
      Grid_curve& c = contour_.curves[m.curve];
      back.push_back({m.curve, m.point, std::exchange(c.points[m.point], m.to), offset(c, m.point)});
      if (!c.offsets.empty()) c.offsets[m.point] = m.offset;
    }
    return back;
  }

  // The square of the largest value of n t (1-t)^(n-1), by which a handle of a curve of degree n
  // moves its points, times that of the move.
  double change(const Moves& moves) const {
    double most = 0;
    for (const Move& m : moves) {
      const Vector v = m.to - points(m.curve)[m.point];
      const double n = static_cast<double>(points(m.curve).size() - 1), weight = std::pow((n - 1) / n, n - 1);
      double x = static_cast<double>(v.x), y = static_cast<double>(v.y);
      if (contour_.is_beside_grid) {
        const Grid_offset d = m.offset - offset(contour_.curves[m.curve], m.point);
        x += CGAL::to_double(d.x());
        y += CGAL::to_double(d.y());
      }
      most = (std::max)(most, weight * weight * (x * x + y * y));
    }
    return most;
  }

  // The state of a join next to a move, which must be kept.
  struct State {
    std::size_t join;
    std::optional<GC::Visual_class> grade;
    std::optional<GC::Kink_size> size;                 // of a kink
    std::optional<GC::Enclosure> angle = std::nullopt; // of a kink with an arc
  };
  Exact_segment drawn_segment(std::size_t curve) const {
    const Exact_segment segment = grid_segment(contour_.curves[curve]);
    return contour_.map ? segment.transform(*contour_.map) : segment;
  }
  State state(std::size_t join) const {
    State s{join, grade(join), std::nullopt};
    if (s.grade == GC::Visual_class::kink && !points(join).empty() && !points(next(join)).empty())
      s.size = kink_size(contour_, join);
    else if (s.grade == GC::Visual_class::kink)
      s.angle = segment_angle(drawn_segment(join), drawn_segment(next(join)));
    return s;
  }

  // Returns whether a join is harmed by moves from the contour that was; it has changed to this
  // state.
  bool is_harmed(const State& before, const State& after, const Moves& back) const {
    if (!before.grade) { // an arc that is not known: directions next to it stay as they are
      for (const Move& m : back) {
        const std::size_t n = points(m.curve).size() - 1;
        const bool at_end = m.curve == before.join;
        const Grid_curve& c = contour_.curves[m.curve];
        const std::size_t node = at_end ? n : 0;
        const bool next_to_node = m.point == tip(m.curve, at_end);
        const Grid_offset u = difference(c.points[node], offset(c, node), m.to, m.offset),
                          v = exact_vector(c, node, m.point);
        if (next_to_node && (cross_product(u, v) != 0 || u * v <= 0)) return true;
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
      const Grid_curve& from = given_.curves[m.curve];
      const Grid_offset move = difference(from.points[m.point], offset(from, m.point), m.to, m.offset);
      if (const CGAL::Exact_rational squared = move.squared_length(); squared > CGAL::Exact_rational(bound * bound))
        return "not on this grid: the nearest position, " + contour_.text(m.to, m.offset) + ", is " +
               units(GC::sqrt_enclosure(squared)) + " away, and the handle may move by " + bound_text(bound);
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
    return !c.fixed && c.points.size() >= 4 && !::is_line(c);
  }
  bool is_free_quadratic(std::size_t curve) const {
    const Grid_curve& c = contour_.curves[curve];
    return !c.fixed && c.points.size() == 3 && !::is_line(c) && !may_be_left_out(previous(curve)) &&
           !may_be_left_out(curve);
  }

  bool is_movable(std::size_t curve) const { return is_free(curve) || is_free_quadratic(curve); }

  // The direction in which a curve ends or starts: that of the chord for a line. Zero where all
  // handles lie at the node, nothing where no vector of the grid has it.
  std::optional<Vector> first_difference(std::size_t curve, bool at_end) const {
    const Grid_curve& c = contour_.curves[curve];
    if (c.arc) return arc_direction(*c.arc, at_end);
    const Points& p = c.points;
    if (::is_line(c)) return p.back() - p.front();
    const Vector& handle = p[tip(curve, at_end)];
    return at_end ? p.back() - handle : handle - p[0];
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
      off = kink_size(contour_, join)->handle_offset.lower;
    return CGAL::Exact_rational(2 * CGAL::Exact_rational(off) + 1);
  }

  Proposal propose(std::size_t join) {
    const std::size_t left = join, right = next(join);
    const std::optional<Vector> in = first_difference(left, true), out = first_difference(right, false);
    if (!in || !out) return {join, {}, "no point of the grid lies in the direction of the arc"};
    if (contour_.is_beside_grid) return propose_beside_grid(join, *in, *out);
    const Vector zero{0, 0};
    if (*in == zero || *out == zero) return {join, {}, "all handles lie at the node"};
    // a long vector that does not move, such as a line, may have a short direction
    const Vector a = is_short(*in) || is_movable(left) ? *in : GC::primitive(*in),
                 b = is_short(*out) || is_movable(right) ? *out : GC::primitive(*out);
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
    return {join, tip(join, true), points(join)[n] - difference, offset(contour_.curves[join], n)};
  }
  Move to_right(std::size_t join, const Vector& difference) const {
    return {next(join), tip(next(join), false), points(next(join))[0] + difference,
            offset(contour_.curves[next(join)], 0)};
  }

  // The move to a place beside the grid, which is given by the vector from a node of the curve.
  Move to_place(std::size_t curve, std::size_t point, std::size_t node, const Grid_offset& from_node) const {
    const Grid_curve& c = contour_.curves[curve];
    const auto whole = [](const Grid_fraction& x) { return on_grid(x).value_or(0); };
    const Vector near = c.points[node] + Vector{whole(from_node.x()), whole(from_node.y())};
    return {curve, point, near, exact_point(c, node) + from_node - Drawing_traits::Point(exact(near.x), exact(near.y))};
  }

  // The direction in which a curve ends or starts, which is known, with all of its digits.
  Grid_offset exact_direction(std::size_t curve, bool at_end) const {
    const Grid_curve& c = contour_.curves[curve];
    if (c.arc) {
      const Vector d = *arc_direction(*c.arc, at_end);
      return Grid_offset(exact(d.x), exact(d.y));
    }
    const std::size_t n = c.points.size() - 1;
    if (::is_line(c)) return exact_vector(c, 0, n);
    return at_end ? exact_vector(c, tip(curve, true), n) : exact_vector(c, 0, tip(curve, false));
  }

  // The multiple of a whole vector, at least itself, that is nearest to a handle.
  static Vector nearest(const Grid_offset& handle, const Vector& d) {
    const Grid_offset direction(exact(d.x), exact(d.y));
    const std::optional<std::int64_t> k =
        on_grid(CGAL::Exact_rational(handle * direction / direction.squared_length()));
    const std::int64_t most = max_grid_coordinate / (std::max)((std::abs)(d.x), (std::abs)(d.y));
    return (std::min)((std::max)(k.value_or(most), std::int64_t(1)), (std::max)(most, std::int64_t(1))) * d;
  }

  // The decimal multiple of a direction that is nearest to a handle, in steps that are no longer
  // than a unit; zero where it would be none.
  static Grid_offset along(const Grid_offset& handle, const Grid_offset& direction) {
    const double t = CGAL::to_double(CGAL::Exact_rational(handle * direction / direction.squared_length())),
                 size = (std::max)(std::abs(CGAL::to_double(direction.x())), std::abs(CGAL::to_double(direction.y())));
    const int digits = (std::max)(0, static_cast<int>(std::ceil(std::log10(size))));
    const CGAL::Exact_rational scale = power_of_ten(digits);
    const double steps = std::round(t * CGAL::to_double(scale));
    if (!(1 <= steps && steps <= static_cast<double>(max_grid_coordinate))) return Grid_offset(0, 0);
    return CGAL::Exact_rational(CGAL::Exact_rational(steps) / scale) * direction;
  }

  // A kink of nodes beside the grid. Both handles come to whole units from the node, or where none
  // of these are near enough, one to a multiple of the other one.
  Proposal propose_beside_grid(std::size_t join, const Vector& in, const Vector& out) {
    const std::size_t left = join, right = next(join), last = points(left).empty() ? 0 : points(left).size() - 1;
    const Grid_offset u = exact_direction(left, true), v = exact_direction(right, false);
    if (u == CGAL::NULL_VECTOR || v == CGAL::NULL_VECTOR) return {join, {}, "all handles lie at the node"};
    const CGAL::Exact_rational sine = cross_product(u, v);
    if (u * v < (sine < 0 ? CGAL::Exact_rational(-sine) : sine)) return {join, {}, "the angle is more than 45 degrees"};
    double off = 0;
    if (contour_.curves[left].arc || contour_.curves[right].arc)
      off = GC::sqrt_enclosure(CGAL::Exact_rational(sine * sine / (contour_.curves[left].arc ? u : v).squared_length()))
                .lower;
    else
      off = kink_size(contour_, join)->handle_offset.lower;
    Proposal proposal{
        join, {}, "", options_.max_move ? *options_.max_move : CGAL::Exact_rational(2 * CGAL::Exact_rational(off) + 1)};
    const Vector zero{0, 0};
    const bool are_short = is_short(in) && is_short(out) && in != zero && out != zero;
    std::vector<Moves> choices, longer;
    if (is_free(left) && is_free(right)) {
      if (are_short) {
        if (points(left).size() == points(right).size())
          if (std::optional<Moves> moves = symmetric(join, in, out)) choices.push_back(*std::move(moves));
        if (choices.empty() && dot(in, out) >= (std::abs)(cross(in, out))) {
          if (const std::optional<GC::Aligned_handles> handles = aligned(in, out, proposal.bound))
            choices.push_back({to_left(join, handles->left), to_right(join, handles->right)});
          choices.push_back({to_left(join, GC::align_handle(in, out)), to_right(join, out)});
          choices.push_back({to_left(join, in), to_right(join, GC::align_handle(out, in))});
          if (rank(in) < rank(out)) std::swap(choices[choices.size() - 1], choices[choices.size() - 2]);
        }
      }
      // only one of them, to a whole multiple of a short direction of the other one
      if (const std::optional<Vector> d = primitive_direction(v)) choices.push_back({to_left(join, nearest(u, *d))});
      if (const std::optional<Vector> d = primitive_direction(u)) choices.push_back({to_right(join, nearest(v, *d))});
      longer = {{to_place(left, tip(left, true), last, -along(u, v))},
                {to_place(right, tip(right, false), 0, along(v, u))}};
      if (rank(in) < rank(out)) std::swap(longer[0], longer[1]);
    } else if (is_free(left)) {
      if (const std::optional<Vector> d = primitive_direction(v)) choices.push_back({to_left(join, nearest(u, *d))});
      longer.push_back({to_place(left, tip(left, true), last, -along(u, v))});
    } else if (is_free(right)) {
      if (const std::optional<Vector> d = primitive_direction(u)) choices.push_back({to_right(join, nearest(v, *d))});
      longer.push_back({to_place(right, tip(right, false), 0, along(v, u))});
    }
    std::string reason;
    for (const bool of_right : {rank(in) < rank(out), !(rank(in) < rank(out))}) {
      const std::size_t curve = of_right ? right : left;
      if (is_free_quadratic(curve)) add_quadratic_beside_grid(join, curve, of_right ? u : v, choices, longer, reason);
    }
    if (!contour_.may_add_decimals) {
      if (choices.empty() && reason.empty() && !longer.empty()) reason = "no unit of this grid lies in the direction";
      longer.clear();
    }
    if (choices.empty() && longer.empty() && !reason.empty()) {
      proposal.reason = reason;
      return proposal;
    }
    choose(choices, proposal);
    if (proposal.moves.empty() && !longer.empty()) {
      const std::string first_reason = std::exchange(proposal.reason, "");
      choose(longer, proposal);
      if (proposal.moves.empty() && !choices.empty()) proposal.reason = first_reason;
    }
    return proposal;
  }

  // As add_quadratic(), for nodes beside the grid.
  void add_quadratic_beside_grid(std::size_t join, std::size_t curve, const Grid_offset& direction,
                                 std::vector<Moves>& choices, std::vector<Moves>& longer, std::string& reason) const {
    const bool at_end = curve == join;
    const std::size_t node = at_end ? 2 : 0;
    const Grid_curve& c = contour_.curves[curve];
    const Grid_offset handle = exact_vector(c, node, 1), forward = at_end ? -direction : direction;
    const std::size_t other_join = at_end ? previous(curve) : curve;
    const std::vector<std::size_t> joins = joins_of(curve);
    const bool has_other = std::count(joins.begin(), joins.end(), other_join) != 0 && other_join != join;
    std::optional<GC::Visual_class> there;
    if (has_other) there = grade(other_join);
    const bool bound = has_other && (!there || *there >= GC::Visual_class::g1);
    if (!bound) {
      if (const std::optional<Vector> d = primitive_direction(forward))
        choices.push_back({{curve, 1, c.points[node] + nearest(handle, *d), offset(c, node)}});
      longer.push_back({to_place(curve, 1, node, along(handle, forward))});
      if (there != GC::Visual_class::kink) return;
    }
    // node + k forward = other + t e, where e is the tangent at the other node
    Grid_offset e = exact_vector(c, 2 - node, 1);
    if (!bound) {
      const std::size_t neighbour = at_end ? previous(curve) : next(curve);
      if (!first_difference(neighbour, at_end)) return;
      e = exact_direction(neighbour, at_end);
    }
    const CGAL::Exact_rational denominator = cross_product(forward, e);
    if (denominator == 0) {
      if (bound) reason = "both nodes of a quadratic bind its handle to parallel lines";
      return;
    }
    const CGAL::Exact_rational k(cross_product(exact_vector(c, node, 2 - node), e) / denominator);
    const Grid_offset place = k * forward;
    const Grid_fraction unit = power_of_ten(-contour_.decimals);
    const Drawing_traits::Point p = exact_point(c, node) + place;
    const bool is_decimal = contour_.takes_fractions || (decimal_text(Grid_fraction(p.x() * unit)).has_value() &&
                                                         decimal_text(Grid_fraction(p.y() * unit)).has_value());
    if (k <= 0 || !is_decimal) {
      if (bound) reason = "both nodes bind the handle of a quadratic, and the only place for it is no decimal";
      return;
    }
    longer.push_back({to_place(curve, 1, node, place)});
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

  std::optional<GC::Enclosure> jump(std::size_t join) const { return curvature_jump(contour_, join); }

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
    if (points(left).size() < 3 || points(right).size() < 3 || is_line(left) || is_line(right))
      return "a line has no curvature";
    const GC::Handle_side a = side(left, true), b = side(right, false);
    const Vector zero{0, 0}, node = points(right).front();
    if (a.handle == zero || b.handle == zero) return "a handle lies at the node";
    if (!a.movable && !b.movable) return "no handle can move without harm to a join that is G2";
    const CGAL::Exact_rational bound = max_change({a.handle, b.handle});
    if (contour_.is_beside_grid) return harmonise_beside_grid(join, a, b, bound);
    std::optional<GC::Aligned_handles> handles;
    std::optional<Moves> exact; // with handles at the other ends, too
    try {
      const double squared = (std::min)(CGAL::to_double(bound * bound), 1e15);
      handles = GC::harmonise_handles(a, b, static_cast<std::int64_t>(squared));
      if (handles && !is_exact(a, b, *handles)) exact = with_far_handles(join, a, b, bound);
    } catch (const GC::Error& error) {
      return error.what();
    }
    if (!handles) return "the curvatures have different signs, or one of them is zero";
    if (exact && accept_if_better(join, *exact, bound).empty() && grade(join) == GC::Visual_class::g2) return "";
    if (handles->left == a.handle && handles->right == b.handle) return "";
    std::vector<Move> moves;
    if (a.movable) moves.push_back({left, points(left).size() - 2, node - handles->left});
    if (b.movable) moves.push_back({right, 1, node + handles->right});
    return accept_if_better(join, moves, bound);
  }

  // Returns whether handles of these lengths have one curvature: p n^2 = q m^2 for m d and n d.
  static bool is_exact(const GC::Handle_side& a, const GC::Handle_side& b, const GC::Aligned_handles& handles) {
    const Vector d = GC::primitive(handles.left);
    const auto times_square = [&](int factor, std::int64_t turn, const Vector& handle) {
      const CGAL::Exact_rational n = exact(dot(handle, d) / squared_length(d));
      return CGAL::Exact_rational(factor * exact(turn) * n * n);
    };
    return times_square((a.degree - 1) * b.degree, cross(a.second, d), handles.right) ==
           times_square((b.degree - 1) * a.degree, cross(d, b.second), handles.left);
  }

  // The handle at the other end of a cubic may move along itself where nothing depends on the
  // curvature there: at a free end, and at a corner. Returns its direction, from the node to it.
  std::optional<Vector> free_direction(std::size_t curve, bool at_end) const {
    const Points& p = points(curve);
    if (p.size() != 4 || !is_free(curve)) return std::nullopt;
    const std::size_t other = at_end ? previous(curve) : curve;
    const std::vector<std::size_t> joins = joins_of(curve);
    if (std::count(joins.begin(), joins.end(), other) != 0 && grade(other) != GC::Visual_class::corner)
      return std::nullopt;
    const Vector handle = at_end ? p[1] - p[0] : p[2] - p[3];
    if (handle == Vector{0, 0}) return std::nullopt;
    return GC::primitive(handle);
  }

  // Moves that make curvatures agree exactly where no lengths of the handles at the node do: also
  // the handles at the other ends get other lengths. Those of which the longest is shortest, then
  // their sum.
  std::optional<Moves> with_far_handles(std::size_t join, const GC::Handle_side& a, const GC::Handle_side& b,
                                        const CGAL::Exact_rational& bound) const {
    constexpr int most_steps = 12;
    const std::optional<Vector> e = free_direction(join, true), f = free_direction(next(join), false);
    const double most = (std::min)(CGAL::to_double(bound), 1e6);
    const auto steps = [&](const std::optional<Vector>& d) {
      return d ? (std::min)(most_steps, static_cast<int>(most / std::hypot(double(d->x), double(d->y)))) : 0;
    };
    const Vector zero{0, 0}, node = points(next(join)).front(), left = points(join)[points(join).size() - 3],
                             right = points(next(join))[2];
    const auto size = [](const Vector& v) { return std::hypot(double(v.x), double(v.y)); };
    std::optional<Moves> best;
    std::pair<double, double> least(most, 1e300);
    const bool turned = rank(a.handle) < rank(b.handle); // so that mirror images of equal moves are one
    const int outer = steps(turned ? f : e), inner = steps(turned ? e : f);
    for (int k = -outer; k <= outer; ++k)
      for (int l = -inner; l <= inner; ++l) {
        const int i = turned ? l : k, j = turned ? k : l;
        if (i == 0 && j == 0) continue;
        const Vector u = e ? i * *e : zero, v = f ? j * *f : zero;
        GC::Handle_side x = a, y = b;
        x.second = x.second - u;
        y.second = y.second + v;
        const std::optional<GC::Aligned_handles> handles =
            GC::harmonise_handles(x, y, static_cast<std::int64_t>(most * most));
        if (!handles || !is_exact(x, y, *handles)) continue;
        const std::array<double, 4> sizes{size(u), size(v), size(handles->left - a.handle),
                                          size(handles->right - b.handle)};
        const std::pair<double, double> cost(*std::max_element(sizes.begin(), sizes.end()),
                                             sizes[0] + sizes[1] + sizes[2] + sizes[3]);
        if (!(cost < least)) continue;
        least = cost;
        best = Moves{};
        if (u != zero) best->push_back({join, points(join).size() - 3, left + u});
        if (v != zero) best->push_back({next(join), 2, right + v});
        if (handles->left != a.handle) best->push_back({join, points(join).size() - 2, node - handles->left});
        if (handles->right != b.handle) best->push_back({next(join), 1, node + handles->right});
      }
    return best;
  }

  // Makes moves that lessen the sum of the jumps. Returns an objection to them.
  std::string accept_if_better(std::size_t join, const Moves& moves, const CGAL::Exact_rational& bound) {
    const double before = sum_of_jumps(moves);
    Harm harm;
    const std::string reason = objection(join, moves, bound, harm);
    if (!reason.empty()) return reason;
    const Moves back = execute(moves);
    if (!(sum_of_jumps(moves) < before)) execute(back); // the jumps next to it would grow by more
    return "";
  }

  // Harmonises handles beside the grid: to short decimal multiples of themselves. Of the handles l
  // and m with the curvatures p / l^2 and q / m^2 the sum of the lengths stays.
  std::string harmonise_beside_grid(std::size_t join, const GC::Handle_side& a, const GC::Handle_side& b,
                                    const CGAL::Exact_rational& bound) {
    const std::size_t left = join, right = next(join), n = points(left).size() - 1;
    const Grid_curve &x = contour_.curves[left], &y = contour_.curves[right];
    const Grid_offset u = exact_vector(x, n - 1, n), v = exact_vector(y, 0, 1);
    const auto curvature = [](const Grid_offset& handle, const CGAL::Exact_rational& turn, int degree) {
      const double size = std::sqrt(CGAL::to_double(handle.squared_length()));
      return (degree - 1.) / degree * CGAL::to_double(turn) / (size * size * size);
    };
    const double p = curvature(u, cross_product(exact_vector(x, n - 2, n), u), a.degree),
                 q = curvature(v, cross_product(v, exact_vector(y, 0, 2)), b.degree),
                 l = std::sqrt(CGAL::to_double(u.squared_length())), m = std::sqrt(CGAL::to_double(v.squared_length()));
    if (!(p * q > 0)) return "the curvatures have different signs, or one of them is zero";
    const double ratio = std::sqrt(q / p), // of the factors of the right and the left handle
        factor = !a.movable   ? 1
                 : !b.movable ? 1 / ratio
                              : (l + m) / (l + ratio * m);
    // by whole units where the direction has short steps
    const auto multiple = [](const Grid_offset& handle, double times) {
      constexpr std::int64_t short_step = 4;
      const Grid_offset wanted = CGAL::Exact_rational(times) * handle;
      const std::optional<Vector> d = primitive_direction(handle);
      if (!d || (std::max)((std::abs)(d->x), (std::abs)(d->y)) > short_step) return along(wanted, handle);
      const Vector v = nearest(wanted, *d);
      return Grid_offset(exact(v.x), exact(v.y));
    };
    Moves moves;
    if (a.movable) moves.push_back(to_place(left, n - 1, n, -multiple(u, factor)));
    if (b.movable) moves.push_back(to_place(right, 1, 0, multiple(v, a.movable ? factor * ratio : ratio)));
    return accept_if_better(join, moves, bound);
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
    const auto place_of_handle = [&](const Proposal& p) -> std::optional<std::pair<Vector, Grid_offset>> {
      for (const Move& m : p.moves)
        if (m.curve == shared) return std::pair(m.to, m.offset);
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
        leave(j, "a gap, as the next curve starts at " +
                     contour_.text(points(next(j)).front(), offset(contour_.curves[next(j)], 0)) +
                     (options_.close ? ", which is farther away than --close" : ": nodes move with --close only"));
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

  // The direction in which a curve ends or starts, rounded; nothing for ellipses whose rotation is
  // irrational.
  std::optional<std::complex<double>> rounded_direction(std::size_t curve, bool at_end) const {
    const Grid_curve& c = contour_.curves[curve];
    if (!c.arc) {
      const Grid_offset v = exact_direction(curve, at_end);
      return std::complex<double>(CGAL::to_double(v.x()), CGAL::to_double(v.y()));
    }
    if (!c.written) return std::nullopt;
    const Arc_frame frame(*c.written);
    const std::complex<double> chord = frame.from(c.arc->end() - c.arc->start());
    const double angle = frame.chord_angle(chord) * (c.written->sweep == at_end ? 1 : -1);
    return frame.to(chord * std::polar(1., angle));
  }

  // Adds those of one side whose neighbour is smooth with it, where it does not harm the join at
  // its other end.
  void add_arc_offers(std::size_t join, bool of_right, std::vector<Arc_offer>& offers) {
    const std::size_t curve = of_right ? next(join) : join, other = of_right ? join : next(join);
    const Grid_curve given = contour_.curves[curve];
    if (!given.arc || !given.written || curve == other) return;
    const std::optional<std::complex<double>> direction = rounded_direction(other, of_right);
    if (!direction || *direction == 0.) return;
    // run through from the node on
    const Drawing_traits::Point node = of_right ? given.arc->start() : given.arc->end(),
                                far = of_right ? given.arc->end() : given.arc->start();
    const Arc_frame frame(*given.written);
    const std::complex<double> tangent = frame.from(of_right ? *direction : -*direction),
                               chord = frame.from(far - node);
    const bool sweep = given.written->sweep == of_right;
    const double angle = std::arg(chord / tangent) * (sweep ? 1 : -1);
    if (!(angle > 0)) return;
    const auto offer = [&](Arc_offer o) {
      if (!is_smooth_with(join, curve, o.changed)) return false;
      for (const Arc_offer& x : offers)
        if (x.curve == o.curve && x.numbers == o.numbers) return true;
      offers.push_back(std::move(o));
      return true;
    };
    const double radius = std::abs(chord) / (2 * std::sin(angle)),
                 unit = CGAL::to_double(power_of_ten(-contour_.decimals));
    if (const std::optional<Grid_fraction> in_coordinates = short_fraction(radius * unit)) {
      Arc_offer o;
      o.curve = curve;
      o.changed = given;
      GC::Elliptical_arc_parameters<Grid_fraction>& p = *o.changed.written;
      const Grid_fraction rx = *in_coordinates * power_of_ten(contour_.decimals);
      p.ry = Grid_fraction(p.ry * rx / p.rx);
      p.rx = rx;
      o.numbers = {contour_.text(p.rx), contour_.text(p.ry)};
      o.is_decimal = is_decimal(p.rx) && is_decimal(p.ry);
      o.size = std::abs(radius / frame.radius - 1);
      set_ends(o.changed, given.arc->start(), given.arc->end());
      offer(std::move(o));
    }
    const bool is_free =
        of_right ? contour_.has_free_end && curve + 1 == contour_.curves.size() : contour_.has_free_start && curve == 0;
    if (!is_free) return;
    const auto offer_end = [&](const Drawing_traits::Point& to) {
      Arc_offer o;
      o.curve = curve;
      o.changed = given;
      o.is_on_grid = is_decimal(to.x(), contour_.decimals) && is_decimal(to.y(), contour_.decimals);
      o.moves_start = !of_right;
      o.moves_end = of_right;
      o.numbers = {contour_.text(to.x()), contour_.text(to.y())};
      o.is_decimal = is_decimal(to.x(), contour_.most_decimals) && is_decimal(to.y(), contour_.most_decimals);
      o.size = std::sqrt(CGAL::to_double((to - far).squared_length()));
      set_ends(o.changed, of_right ? node : to, of_right ? to : node);
      return offer(std::move(o));
    };
    if (const std::optional<Grid_fraction> t = short_fraction(2 * frame.radius * std::sin(angle) / std::abs(chord)))
      offer_end(node + *t * (far - node));
    // the nearest point of the grid on the ellipse
    const std::complex<double> centre =
        tangent / std::abs(tangent) * std::polar(frame.radius, sweep ? quarter : -quarter);
    const std::optional<std::int64_t> x = on_grid(far.x()), y = on_grid(far.y());
    const int widest = static_cast<int>((std::min)(100., (std::max)(3., 0.1 * frame.radius)));
    std::vector<Vector> near;
    for (int i = -widest; i <= widest && x && y; ++i)
      for (int j = -widest; j <= widest; ++j) {
        const Grid_offset v = Drawing_traits::Point(exact(*x + i), exact(*y + j)) - node;
        const double off = std::abs(frame.from(v) - centre) / frame.radius - 1;
        if (std::abs(off) < 1e-9) near.push_back({i, j});
      }
    std::stable_sort(near.begin(), near.end(),
                     [](const Vector& u, const Vector& v) { return squared_length(u) < squared_length(v); });
    for (const Vector& v : near)
      if (offer_end(Drawing_traits::Point(exact(*x + v.x), exact(*y + v.y)))) break;
  }

  static constexpr double quarter = 1.5707963267948966;

  // Lengths and angles of an ellipse, rounded, in a frame in which it is a circle.
  struct Arc_frame {
    double radius;
    std::complex<double> turn;
    double stretch; // of the second axis
    bool large;

    explicit Arc_frame(const GC::Elliptical_arc_parameters<Grid_fraction>& p)
        : radius(std::abs(CGAL::to_double(p.rx))), turn(std::polar(1., CGAL::to_double(p.rotation) * quarter / 90)),
          stretch(radius / std::abs(CGAL::to_double(p.ry))), large(p.large) {}

    std::complex<double> from(const std::complex<double>& v) const {
      const std::complex<double> w = v / turn;
      return {w.real(), w.imag() * stretch};
    }
    std::complex<double> from(const Grid_offset& v) const {
      return from(std::complex<double>(CGAL::to_double(v.x()), CGAL::to_double(v.y())));
    }
    std::complex<double> to(const std::complex<double>& v) const {
      return turn * std::complex<double>(v.real(), v.imag() / stretch);
    }
    // Between the chord and the tangents at its ends.
    double chord_angle(const std::complex<double>& chord) const {
      const double angle = std::asin((std::min)(1., std::abs(chord) / (2 * radius)));
      return large ? 2 * quarter - angle : angle;
    }
  };

  // The first convergent of a continued fraction that is as near to a positive number as rounding
  // can tell; what it stands for is proved later.
  static std::optional<Grid_fraction> short_fraction(double x) {
    constexpr double nearness = 1e-12, largest = 1e6;
    if (!(x > 0 && x < 1e12)) return std::nullopt;
    double p0 = 1, q0 = 0, p1 = std::floor(x), q1 = 1, rest = x - p1;
    while (std::abs(p1 / q1 - x) > nearness * x) {
      if (!(rest > 0)) return std::nullopt;
      const double a = std::floor(1 / rest);
      rest = 1 / rest - a;
      const double p = a * p1 + p0, q = a * q1 + q0;
      if (!(q <= largest)) return std::nullopt;
      p0 = std::exchange(p1, p);
      q0 = std::exchange(q1, q);
    }
    return Grid_fraction(Grid_fraction(p1) / Grid_fraction(q1));
  }

  bool is_decimal(const Grid_fraction& x, int most_decimals = 6) const {
    return decimal_text(Grid_fraction(x * power_of_ten(-contour_.decimals)), most_decimals).has_value();
  }

  // Makes the arc of a curve anew, as it is written.
  static void set_ends(Grid_curve& curve, const Drawing_traits::Point& start, const Drawing_traits::Point& end) {
    curve.arc.reset();
    try {
      if (start != end)
        curve.arc = std::make_shared<const Exact_segment>(
            Exact_segment{GC::Elliptical_arc<Drawing_traits>(start, end, *curve.written)});
    } catch (const GC::Error&) { // sizes that differ too much
    }
  }

  // Returns whether a join is smooth, and no other harmed, with another arc.
  bool is_smooth_with(std::size_t join, std::size_t curve, const Grid_curve& arc) {
    if (!arc.arc) return false;
    std::vector<State> before;
    for (const std::size_t j : joins_of(curve))
      if (j != join) before.push_back(state(j));
    const Grid_curve given = std::exchange(contour_.curves[curve], arc);
    bool smooth = grade(join) >= GC::Visual_class::g1;
    for (const State& x : before) {
      const State after = state(x.join);
      smooth = smooth && x.grade && !is_harmed(x, after, {}) &&
               (x.grade != GC::Visual_class::kink || after.grade != GC::Visual_class::kink || is_no_larger(x, after));
    }
    contour_.curves[curve] = given;
    return smooth;
  }

  // Returns whether a kink of an arc did not grow; known only where it has not changed.
  static bool is_no_larger(const State& before, const State& after) {
    return before.angle && after.angle && after.angle->upper <= before.angle->lower;
  }

  // The points to which both ends of a gap may move: those nearest to its middle, and the ends.
  std::vector<Drawing_traits::Point> meeting_points(const Drawing_traits::Point& p,
                                                    const Drawing_traits::Point& q) const {
    const Drawing_traits::Point middle = CGAL::midpoint(p, q);
    if (contour_.is_beside_grid) return {middle, p, q};
    std::vector<Drawing_traits::Point> result;
    const auto below = [](const Grid_fraction& x) { return std::floor(CGAL::to_double(x)); }; // of a half
    const double x = below(middle.x()), y = below(middle.y());
    for (const double i : {0., 1.})
      for (const double j : {0., 1.})
        if ((i == 0 || x != middle.x()) && (j == 0 || y != middle.y())) result.emplace_back(x + i, y + j);
    result.push_back(p);
    result.push_back(q);
    return result;
  }

  // The moves of an end of a curve to a point, with the handle that belongs to it.
  Moves moves_of_end(std::size_t curve, bool at_end, const Drawing_traits::Point& to) const {
    const Grid_curve& c = contour_.curves[curve];
    const std::size_t n = c.points.size() - 1, node = at_end ? n : 0, handle = at_end ? n - 1 : 1;
    const Grid_offset v = to - exact_point(c, node);
    if (v == CGAL::NULL_VECTOR) return {};
    Moves moves{to_place(curve, node, node, v)};
    if (is_free(curve)) moves.push_back(to_place(curve, handle, handle, v));
    return moves;
  }

  void close_gap(std::size_t join) {
    const std::size_t left = join, right = next(join);
    const Grid_curve &x = contour_.curves[left], &y = contour_.curves[right];
    const Drawing_traits::Point p = exact_point(x, x.points.size() - 1), q = exact_point(y, 0);
    std::set<std::size_t> joins;
    for (const std::size_t curve : {left, right})
      for (const std::size_t j : joins_of(curve)) joins.insert(j);
    joins.erase(join);
    std::vector<State> before;
    for (const std::size_t j : joins) before.push_back(state(j));
    typedef std::tuple<std::size_t, CGAL::Exact_rational, CGAL::Exact_rational> Cost; // harm, the moves
    std::optional<Cost> least;
    Moves best;
    for (const Drawing_traits::Point& to : meeting_points(p, q)) {
      Moves moves = moves_of_end(left, true, to);
      for (Move& m : moves_of_end(right, false, to)) moves.push_back(std::move(m));
      const Moves back = execute(moves);
      std::size_t harm = grade(join) >= GC::Visual_class::g1 ? 0 : 1;
      for (const State& s : before) harm += is_harmed(s, state(s.join), back);
      execute({back.rbegin(), back.rend()});
      const CGAL::Exact_rational a = (to - p).squared_length(), b = (to - q).squared_length();
      const Cost cost(harm, (std::max)(a, b), (std::min)(a, b));
      if (least && !(cost < *least)) continue;
      least = cost;
      best = std::move(moves);
    }
    execute(best);
  }

public:
  Contour_mender(Grid_contour& contour, const Repair_options& options) : contour_(contour), options_(options) {}

  // Closes the gaps that are no wider than this.
  std::vector<Closed_gap> close_gaps(const CGAL::Exact_rational& widest) {
    std::vector<Closed_gap> closed;
    const CGAL::Exact_rational bound = widest * power_of_ten(contour_.decimals);
    for (std::size_t j = 0; j < contour_.number_of_joins(); ++j) {
      if (!is_bezier_join(j) || grade(j) != GC::Visual_class::gap) continue;
      const Grid_curve &x = contour_.curves[j], &y = contour_.curves[next(j)];
      const CGAL::Exact_rational squared = (exact_point(y, 0) - exact_point(x, x.points.size() - 1)).squared_length();
      if (squared > CGAL::Exact_rational(bound * bound)) continue;
      close_gap(j);
      const CGAL::Exact_rational unit = power_of_ten(-contour_.decimals);
      closed.push_back({j, GC::sqrt_enclosure(CGAL::Exact_rational(squared * unit * unit))});
    }
    return closed;
  }

  // Returns how an arc at a kink would be smooth with its neighbour: with other radii of the same
  // ratio, or with another end where that is free. All are proved; first those of radii.
  std::vector<Arc_offer> arc_offers(std::size_t join) {
    std::vector<Arc_offer> offers;
    for (const bool of_right : {true, false}) add_arc_offers(join, of_right, offers);
    std::stable_sort(offers.begin(), offers.end(), [](const Arc_offer& x, const Arc_offer& y) {
      const auto rank = [](const Arc_offer& o) {
        return std::tuple(!o.is_decimal, o.moves_start || o.moves_end, !o.is_on_grid, o.size);
      };
      return rank(x) < rank(y);
    });
    return offers;
  }

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
  return std::equal(
      x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
      [](const Grid_curve& c, const Grid_curve& d) { return c.points == d.points && c.offsets == d.offsets; });
}

bool moves_within(const Grid_contour& from, const Grid_contour& to, const CGAL::Exact_rational& bound) {
  const CGAL::Exact_rational squared = CGAL::Exact_rational(bound * bound);
  for (std::size_t i = 0; i < from.curves.size(); ++i)
    for (std::size_t k = 0; k < from.curves[i].points.size(); ++k) {
      const Grid_curve &x = from.curves[i], &y = to.curves[i];
      if (squared < difference(x.points[k], offset(x, k), y.points[k], offset(y, k)).squared_length()) return false;
    }
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
      x.after = grade(result, x.join, options.bound) == GC::Visual_class::g2 ? GC::Enclosure{0, 0}
                                                                             : *curvature_jump(result, x.join);
    }
  }
  for (Curvature_jump& x : jumps) {
    x.after = x.before;
    x.reason = "the lengths of the handles find no rest within the allowed moves";
  }
  return jumps;
}

// Changes arcs of joins that were not repaired, where that is asked for and can be written, and
// notes what there is for the others.
void offer_arcs(Grid_contour& contour, const Repair_options& options, Contour_repair& result) {
  bool changed = false;
  for (Unrepaired_join& x : result.unrepaired) {
    if (grade(contour, x.join, options.bound) != GC::Visual_class::kink) continue;
    x.offers = Contour_mender(contour, options).arc_offers(x.join);
    if (!options.change_arcs || x.offers.empty() || !x.offers.front().is_decimal) continue;
    contour.curves[x.offers.front().curve] = x.offers.front().changed;
    changed = true;
  }
  if (!changed) return;
  Contour_repair again = Contour_mender(contour, options).mend();
  for (Unrepaired_join& x : again.unrepaired) x.offers = Contour_mender(contour, options).arc_offers(x.join);
  again.closed = std::move(result.closed);
  result = std::move(again);
}

// Adds what has changed of an arc.
void add_changes(const Grid_contour& contour, std::size_t i, const Grid_curve& given,
                 std::vector<Arc_change>& changes) {
  const Grid_curve& curve = contour.curves[i];
  if (!curve.arc || curve.arc == given.arc) return;
  const auto radii = [&](const Grid_curve& c) {
    std::vector<std::string> r{contour.text(c.written->rx), contour.text(c.written->ry)};
    if (r[0] == r[1]) r.pop_back();
    return r;
  };
  const auto point = [&](const Drawing_traits::Point& p) {
    return std::vector<std::string>{contour.text(p.x()), contour.text(p.y())};
  };
  if (radii(given) != radii(curve)) changes.push_back({i, "radius", radii(given), radii(curve)});
  if (given.arc->start() != curve.arc->start())
    changes.push_back({i, "start", point(given.arc->start()), point(curve.arc->start())});
  if (given.arc->end() != curve.arc->end())
    changes.push_back({i, "end", point(given.arc->end()), point(curve.arc->end())});
}

} // namespace

std::string Arc_offer::text() const {
  if (moves_start || moves_end)
    return std::string(moves_start ? "the start (" : "the end (") + numbers[0] + ", " + numbers[1] + ')';
  return numbers[0] == numbers[1] ? "the radius " + numbers[0] : "the radii " + numbers[0] + ", " + numbers[1];
}

GC::Enclosure Handle_move::distance() const {
  if (offset_from == offset_to) return GC::sqrt_enclosure(squared_distance(from, to));
  return GC::sqrt_enclosure(difference(from, offset_from, to, offset_to).squared_length());
}

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
  std::vector<Closed_gap> closed;
  if (options.close) closed = Contour_mender(contour, options).close_gaps(*options.close);
  const Grid_contour met = contour;
  Contour_repair result = Contour_mender(contour, options).mend();
  result.closed = std::move(closed);
  // A repair that was impossible before may be possible now; a given limit holds for all rounds
  // together.
  for (bool more = !same_points(contour, met) && !result.unrepaired.empty(); more;) {
    Grid_contour again = contour;
    Contour_repair next = Contour_mender(again, options).mend();
    more = next.unrepaired.size() < result.unrepaired.size() &&
           (!options.max_move || moves_within(met, again, *options.max_move));
    if (!more) break;
    contour = std::move(again);
    next.closed = std::move(result.closed);
    result = std::move(next);
  }
  if (!result.unrepaired.empty()) offer_arcs(contour, options, result);
  if (options.harmonise) {
    result.jumps = harmonised(contour, options);
    const auto is_mended = [&](const Unrepaired_join& x) { // as other handles have moved
      return grade(contour, x.join, options.bound) >= GC::Visual_class::g1;
    };
    std::vector<Unrepaired_join>& left = result.unrepaired;
    left.erase(std::remove_if(left.begin(), left.end(), is_mended), left.end());
  }
  std::set<std::size_t> touched;
  for (std::size_t i = 0; i < contour.curves.size(); ++i) add_changes(contour, i, given.curves[i], result.arcs);
  for (std::size_t i = 0; i < contour.curves.size(); ++i)
    for (std::size_t k = 0; k < contour.curves[i].points.size(); ++k) {
      const GC::Grid_vector &from = given.curves[i].points[k], &to = contour.curves[i].points[k];
      const Grid_offset offset_from = offset(given.curves[i], k), offset_to = offset(contour.curves[i], k);
      if (from == to && offset_from == offset_to) continue;
      result.moves.push_back({i, k, from, to, offset_from, offset_to});
      touched.insert(i);
      touched.insert(i == 0 ? contour.curves.size() - 1 : i - 1);
    }
  for (std::size_t j : touched)
    if (j < contour.number_of_joins() && grade(given, j, options.bound) == GC::Visual_class::g2 &&
        grade(contour, j, options.bound) == GC::Visual_class::g1)
      result.lost.push_back(j);
  return result;
}

std::int64_t longest_beside_grid(const Repair_options& options) {
  return options.harmonise ? GC::max_harmonised_coordinate / 2 : GC::max_handle_coordinate / 2;
}

std::string needs_coarser_grid(const Grid_contour& contour, const Repair_options& options) {
  const auto is_longer = [](const Vector& v, std::int64_t bound) {
    return (std::max)((std::abs)(v.x), (std::abs)(v.y)) > bound;
  };
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j) {
    const std::optional<GC::Visual_class> grade = ::grade(contour, j, options.bound);
    const bool harmonises = options.harmonise && grade == GC::Visual_class::g1;
    if (grade != GC::Visual_class::kink && !harmonises) continue;
    for (const bool at_end : {true, false}) {
      const Grid_curve& c = contour.curves[at_end ? j : contour.next(j)];
      if (c.points.empty()) continue;
      const std::size_t n = c.points.size() - 1;
      if (is_line(c)) {
        if (!harmonises && is_longer(GC::primitive(c.points[n] - c.points[0]), GC::max_handle_coordinate))
          return "the direction of a line is longer than 2^28 units";
        continue;
      }
      const auto vector = [&](std::size_t k) {
        return at_end ? c.points[n] - c.points[n - k] : c.points[k] - c.points[0];
      };
      if (is_longer(vector(1), GC::max_handle_coordinate)) return "a handle is longer than 2^28 units";
      if (harmonises &&
          (is_longer(vector(1), GC::max_harmonised_coordinate) || is_longer(vector(2), GC::max_harmonised_coordinate)))
        return "a handle is longer than 2^25 units, too long for curvatures";
    }
  }
  return "";
}
