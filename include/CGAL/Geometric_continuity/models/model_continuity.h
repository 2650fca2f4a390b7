// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <iterator>
#include <mutex>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The kinds of edges of a model.
enum class Model_edge_kind {
  shared,   ///< two patches have it
  boundary, ///< only one patch has it
  collapsed ///< it is a single point: all its control points are equal
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the name of a kind, as spelled in the enumeration.
inline std::string to_string(Model_edge_kind kind) {
  // unreachable: every value has a case
  switch (kind) {
  case Model_edge_kind::shared: return "shared";
  case Model_edge_kind::boundary: return "boundary";
  case Model_edge_kind::collapsed: return "collapsed";
  }
  // unreachable: every value has a case
  return "unknown";
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Writes the name of a kind.
inline std::ostream& operator<<(std::ostream& os, Model_edge_kind kind) { return os << to_string(kind); }

/// \ingroup PkgGeometricContinuitySurfaces
/// An edge of a model, with the decision if it is shared.
/// \tparam FT the field in which it was decided
template <class FT> struct Model_edge {
  Model_edge_kind kind; ///< whether there is a second patch
  std::size_t patch_a;  ///< the number of the patch, from 0 on
  Patch_edge edge_a;    ///< its edge
  /// the other patch of a shared edge; the same one where a patch closes up
  std::optional<std::size_t> patch_b;
  std::optional<Patch_edge> edge_b; ///< its edge
  // equivalent [false -> true, 1]: assigned for every edge
  bool non_manifold = false; ///< more than two patches have the edge
  /// of a shared edge, with a verdict for each span of the knots
  Spline_edge_continuity<FT> continuity;

  /// Writes the row, e.g. `0 u1 - 1 u0: G2` or `5 v0: boundary`.
  friend std::ostream& operator<<(std::ostream& os, const Model_edge& e) {
    os << e.patch_a << ' ' << e.edge_a;
    if (e.kind != Model_edge_kind::shared) return os << ": " << e.kind;
    os << " - " << *e.patch_b << ' ' << *e.edge_b << ": " << e.continuity;
    return os << (e.non_manifold ? ", non-manifold" : "");
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A knot line inside one of the surfaces of a model.
/// \tparam FT the field in which it was decided
template <class FT> struct Model_knot_line {
  std::size_t patch;  ///< the number of the surface, from 0 on
  Knot_line<FT> line; ///< the line and the decision

  /// Writes the row, e.g. `3 u = 1/2: G1 (curvature)`.
  friend std::ostream& operator<<(std::ostream& os, const Model_knot_line& l) { return os << l.patch << ' ' << l.line; }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The numbers of edges of a model that have each continuity.
struct Model_summary {
  std::size_t g2 = 0; ///< shared edges that are \f$ G^2 \f$
  std::size_t g1 = 0; ///< shared edges that are \f$ G^1 \f$ but not \f$ G^2 \f$
  std::size_t g0 = 0; ///< shared edges that are not \f$ G^1 \f$
  /// those of `g0` whose only defect is that a normal vanishes somewhere
  std::size_t vanishing_normals = 0;
  std::size_t creases = 0; ///< those of `g0` where the tangent planes differ somewhere
  /// those of `g0` where both surfaces lie on one side somewhere, and no crease is
  std::size_t folds = 0;
  std::size_t boundary = 0;  ///< edges of one patch only
  std::size_t collapsed = 0; ///< edges that are single points
  /// pairs of patches at an edge that more than two patches have; counted above, too
  std::size_t non_manifold = 0;
  /// Knot lines inside B-spline surfaces that are \f$ G^2 \f$ though the knot is multiple.
  std::size_t knot_lines_g2 = 0;
  std::size_t knot_lines_g1 = 0; ///< knot lines that are \f$ G^1 \f$ but not \f$ G^2 \f$
  std::size_t knot_lines_g0 = 0; ///< knot lines that are not \f$ G^1 \f$

  /// Writes the counts, e.g. `24 G2, 20 G1, 8 G0 (8 vanishing normals), 16 boundary, 8 collapsed`,
  /// and those of knot lines if there are any.
  friend std::ostream& operator<<(std::ostream& os, const Model_summary& s) {
    os << s.g2 << " G2, " << s.g1 << " G1, " << s.g0 << " G0";
    const char* separator = " (";
    const auto part = [&](std::size_t n, const char* what) {
      if (n == 0) return;
      os << separator << n << what;
      separator = ", ";
    };
    part(s.creases, " creases");
    part(s.folds, " folds");
    part(s.vanishing_normals, " vanishing normals");
    os << (s.g0 > 0 ? "), " : ", ") << s.boundary << " boundary, " << s.collapsed << " collapsed";
    if (s.non_manifold > 0) os << ", " << s.non_manifold << " non-manifold";
    if (s.knot_lines_g2 + s.knot_lines_g1 + s.knot_lines_g0 > 0)
      os << "; knot lines: " << s.knot_lines_g2 << " G2, " << s.knot_lines_g1 << " G1, " << s.knot_lines_g0 << " G0";
    return os;
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The decisions about all edges of a model, and about the knot lines of B-spline surfaces.
template <class FT> struct Model_continuity {
  /// by the number of the first patch, then by its edge
  std::vector<Model_edge<FT>> edges;
  /// by the number of the surface, see `knot_line_continuity()`
  std::vector<Model_knot_line<FT>> knot_lines;
  Model_summary summary; ///< the counts of edges and knot lines

  /// Returns whether all shared edges and all knot lines have at least this order.
  bool has_order(int g_order) const { return failing(g_order).empty() && failing_knot_lines(g_order).empty(); }

  /// Returns the knot lines whose order is less than `g_order`.
  std::vector<Model_knot_line<FT>> failing_knot_lines(int g_order) const {
    std::vector<Model_knot_line<FT>> result;
    for (const Model_knot_line<FT>& l : knot_lines)
      if (l.line.continuity.g_order < g_order) result.push_back(l);
    return result;
  }

  /// Returns the shared edges whose order is less than `g_order`.
  std::vector<Model_edge<FT>> failing(int g_order) const {
    std::vector<Model_edge<FT>> result;
    for (const Model_edge<FT>& e : edges)
      if (e.kind == Model_edge_kind::shared && e.continuity.g_order < g_order) result.push_back(e);
    return result;
  }

  /// Writes the summary.
  friend std::ostream& operator<<(std::ostream& os, const Model_continuity& model) { return os << model.summary; }
};

namespace internal {

// Calls work(i) for the numbers 0 <= i < n, on several cores with Parallel_tag. If some calls
// throw, the exception for the least number leaves the function, as without cores.
template <class Concurrency_tag, class Work> void for_each_number(std::size_t n, const Work& work) {
  constexpr std::size_t grain = 16;
  std::atomic<std::size_t> failing(n); // the least number for which an exception was thrown
  std::exception_ptr error;
  std::mutex mutex;
  for_each_block<Concurrency_tag>(
      n,
      [&](std::size_t begin, std::size_t end) {
        std::size_t i = begin;
        try {
          for (; i < end && i < failing; ++i) work(i);
        } catch (...) {
          const std::lock_guard<std::mutex> lock(mutex);
          if (failing < i) return;
          failing = i;
          error = std::current_exception();
        }
      },
      grain);
  if (error) std::rethrow_exception(error);
}

// Decides one edge or knot line after the other, on several cores with Parallel_tag.
template <class Concurrency_tag, class Surface, class Report> class Model_analysis {
  typedef Edge_field<typename Surface::Traits> Field;

  struct Row { // of the table of edges
    Model_edge_kind kind;
    Edge_use a, b; // b of a shared edge
    bool non_manifold;
  };

  const std::vector<const Surface*>& patches_;
  Report& report_;
  const Crease_angles angles_;
  std::size_t decided_ = 0;
  std::mutex mutex_; // for the two above
  Model_continuity<Field> model_;

public:
  Model_analysis(const std::vector<const Surface*>& patches, Report& report, Crease_angles angles)
      : patches_(patches), report_(report), angles_(angles) {}

  Model_continuity<Field> operator()() {
    for (const Surface* patch : patches_) require_space(*patch, "model_continuity");
    if constexpr (!Is_patch<Surface>::value) decide_knot_lines();
    decide_edges(Edge_groups<Surface>(patches_));
    count_edges();
    return std::move(model_);
  }

private:
  void one_more() {
    const std::lock_guard<std::mutex> lock(mutex_);
    report_(++decided_);
  }

  void decide_knot_lines() {
    std::vector<std::vector<Knot_line<Field>>> lines(patches_.size());
    for_each_number<Concurrency_tag>(patches_.size(), [&](std::size_t i) {
      name_place([&] { return "patch " + std::to_string(i); },
                 [&] { lines[i] = knot_lines(*patches_[i], [this] { one_more(); }); });
    });
    Model_summary& s = model_.summary;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (Knot_line<Field>& line : lines[i]) {
        const int order = line.continuity.g_order;
        ++(order == 2 ? s.knot_lines_g2 : order == 1 ? s.knot_lines_g1 : s.knot_lines_g0);
        model_.knot_lines.push_back({i, std::move(line)});
      }
  }

  void decide_edges(const Edge_groups<Surface>& groups) {
    std::vector<Row> rows;
    for (const Edge_use& use : groups.collapsed()) rows.push_back({Model_edge_kind::collapsed, use, use, false});
    for (const Edge_uses& uses : groups.edges()) {
      if (uses.size() == 1) rows.push_back({Model_edge_kind::boundary, uses[0], uses[0], false});
      for (std::size_t i = 1; i < uses.size(); ++i)
        rows.push_back({Model_edge_kind::shared, uses[i - 1], uses[i], uses.size() > 2});
    }
    std::sort(rows.begin(), rows.end(), [](const Row& x, const Row& y) { return x.a < y.a; });
    model_.edges.resize(rows.size());
    for_each_number<Concurrency_tag>(rows.size(), [&](std::size_t i) { decide(rows[i], model_.edges[i]); });
  }

  void decide(const Row& row, Model_edge<Field>& edge) {
    const Edge_use &a = row.a, &b = row.b;
    edge.kind = row.kind;
    edge.patch_a = a.patch;
    edge.edge_a = a.edge;
    if (row.kind != Model_edge_kind::shared) return;
    edge.patch_b = b.patch;
    edge.edge_b = b.edge;
    edge.non_manifold = row.non_manifold;
    name_place([&] { return edge_name(a.patch, a.edge) + " - " + edge_name(b.patch, b.edge); },
               [&] {
                 edge.continuity = continuity_of_same_edge(
                     *patches_[a.patch], a.edge, *patches_[b.patch], b.edge,
                     a.backwards == b.backwards ? Edge_direction::same : Edge_direction::opposite, angles_);
               });
    one_more();
  }

  void count_edges() {
    Model_summary& s = model_.summary;
    for (const Model_edge<Field>& row : model_.edges) {
      s.boundary += row.kind == Model_edge_kind::boundary;
      s.collapsed += row.kind == Model_edge_kind::collapsed;
      if (row.kind != Model_edge_kind::shared) continue;
      s.non_manifold += row.non_manifold;
      ++(row.continuity.g_order == 2 ? s.g2 : row.continuity.g_order == 1 ? s.g1 : s.g0);
      s.vanishing_normals += row.continuity.defect == Edge_defect::vanishing_normal;
      s.creases += row.continuity.defect == Edge_defect::crease;
      s.folds += row.continuity.defect == Edge_defect::fold;
    }
  }
};

// The surfaces of a range, or the surface itself, which is a range of control points.
template <class PatchRange, class = void> struct Surface_type {
  typedef std::decay_t<decltype(*std::begin(std::declval<const PatchRange&>()))> type;
};
template <class Surface> struct Surface_type<Surface, std::void_t<typename Surface::Traits>> { typedef Surface type; };
template <class PatchRange> using Surface_of = typename Surface_type<PatchRange>::type;
template <class PatchRange>
using Continuity_of_model = Model_continuity<Edge_field<typename Surface_of<PatchRange>::Traits>>;

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds all edges that the patches of a model share and decides the continuity along each of them,
/// exactly and with every kernel, see `edge_continuity()`; and along the knot lines of B-spline
/// surfaces, see `knot_line_continuity()`. Two edges are the same when the affine map of one domain
/// to the other, in either direction, makes them the same curve, whatever their degrees and knots;
/// nothing is merged within a tolerance, and an edge that meets only a part of another one is a
/// boundary edge.
///
/// Each edge of each patch is in one row: collapsed edges, which are not compared; boundary edges;
/// and shared edges with both patches, which may be the same. When more than two patches have one
/// edge, say in the order of their numbers \f$ s_1, \dots, s_k \f$, there is one row for each pair
/// \f$ s_i, s_{i+1} \f$, marked `non_manifold`, so that \f$ k-1 \f$ rows and not \f$ k(k-1)/2 \f$
/// are decided.
///
/// Each edge is recognised once, by sorting: \f$ O(n \log n) \f$ comparisons for `n` patches, of
/// the control points as they are given, and of the quotients of weights, where edges with the same
/// ends have one degree and the same knots. Then each shared edge is decided once, with integers of
/// fixed length where `edge_continuity()` takes them. The limit of the work is that for each edge,
/// to recognise and to decide it, and for each knot line.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: edges
///   and knot lines are decided on several cores, with the same result, on number types that may be
///   copied concurrently, see join_predicates.h
/// \tparam PatchRange a forward range of `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch`
///   or `Rational_bspline_surface`, or one such surface, which may close up; polynomial surfaces
///   can be converted to rational ones
/// \param patches of the model, which must outlive the call
/// \param report is called as `report(n)` with the number of shared edges and knot lines decided so
///   far, after each, by one core at a time
/// \param angles whether the largest angles are wanted along creases, too
/// \throws Error `dimension_mismatch` unless in dimension 3; `work_limit`, with the patch and the
///   edge
template <class Concurrency_tag = Sequential_tag, class PatchRange, class Report>
internal::Continuity_of_model<PatchRange> model_continuity(const PatchRange& patches, Report report,
                                                           Crease_angles angles = Crease_angles::enclosed) {
  typedef internal::Surface_of<PatchRange> Patch;
  std::vector<const Patch*> pointers;
  if constexpr (std::is_same_v<Patch, PatchRange>)
    pointers.push_back(&patches);
  else
    for (const Patch& patch : patches) pointers.push_back(&patch);
  return internal::Model_analysis<Concurrency_tag, Patch, Report>(pointers, report, angles)();
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity along all edges of a model, without reports.
/// \throws Error as the function that reports
template <class Concurrency_tag = Sequential_tag, class PatchRange>
internal::Continuity_of_model<PatchRange> model_continuity(const PatchRange& patches) {
  return model_continuity<Concurrency_tag>(patches, [](std::size_t) {});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Two boundary edges of a model that are not the same but near each other.
struct Nearly_coincident_edges {
  std::size_t patch_a;      ///< the number of the patch, from 0 on
  Patch_edge edge_a;        ///< its edge
  std::size_t patch_b;      ///< the other patch, or the same one
  Patch_edge edge_b;        ///< its edge
  Edge_order_within within; ///< how near, and what that means

  /// Writes the row, e.g. `0 u1 - 1 u0: near`.
  friend std::ostream& operator<<(std::ostream& os, const Nearly_coincident_edges& e) {
    return os << e.patch_a << ' ' << e.edge_a << " - " << e.patch_b << ' ' << e.edge_b << ": near"
              << (e.within.deviation.reversed ? ", reversed" : "");
  }
};

namespace internal {

// A boundary edge with its ends.
template <class Field, int N> struct Boundary_edge {
  typedef Coordinate_vector<Field, 3> Vector;
  typedef std::array<std::pair<double, double>, 3> Box; // that contains a point

  std::size_t patch;
  Patch_edge edge;
  std::vector<Edge_piece<Field, N>> pieces;
  Vector ends[2];
  Box boxes[2];

  Boundary_edge(std::size_t p, Patch_edge e, const Spline_edge_rows<Field, N>& rows) : patch(p), edge(e) {
    const Work_guard work("nearly_coincident_edges");
    pieces = edge_pieces<Field>(rows);
    ends[0] = point_of(pieces.front().rows.edge.front());
    ends[1] = point_of(pieces.back().rows.edge.back());
    for (int end : {0, 1})
      for (int i = 0; i < 3; ++i) boxes[end][i] = CGAL::to_interval(ends[end][i]);
  }

  static Vector point_of(const Coordinate_vector<Field, N>& p) {
    if constexpr (N == 4)
      return affine_point(p);
    else
      return p;
  }

  // Bounds of the smaller coordinate of both ends.
  double low(int i) const { return (std::min)(boxes[0][i].first, boxes[1][i].first); }
  double high(int i) const { return (std::min)(boxes[0][i].second, boxes[1][i].second); }

  // Returns whether the ends are not farther apart than the gap, in one of both directions. Boxes
  // tell nearly all that are.
  bool has_ends_near(const Boundary_edge& other, double gap, const Field& squared_gap) const {
    const auto within_gap = [&](int end, int other_end) {
      for (int i = 0; i < 3; ++i)
        if (is_beyond(boxes[end][i], other.boxes[other_end][i], gap) ||
            is_beyond(other.boxes[other_end][i], boxes[end][i], gap))
          return false;
      const Vector difference = other.ends[other_end] - ends[end];
      return !(squared_gap < dot(difference, difference));
    };
    return (within_gap(0, 0) && within_gap(1, 1)) || (within_gap(0, 1) && within_gap(1, 0));
  }

  // Returns whether the numbers of the second interval exceed those of the first by more than the
  // gap.
  static bool is_beyond(const std::pair<double, double>& x, const std::pair<double, double>& y, double gap) {
    return gap < next_below(y.first - x.second);
  }
};

// The coordinate in which the edges are spread most, as far as they are finite.
template <class Field, int N> int longest_side(const std::vector<Boundary_edge<Field, N>>& edges) {
  int longest = 0;
  double length = 0;
  for (int i = 0; i < 3; ++i) {
    const auto [least, most] = std::minmax_element(edges.begin(), edges.end(),
                                                   [i](const auto& a, const auto& b) { return a.low(i) < b.low(i); });
    if (least == edges.end() || !(length < most->low(i) - least->low(i))) continue;
    length = most->low(i) - least->low(i);
    longest = i;
  }
  return longest;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the pairs of boundary edges of a model whose gap is not refuted to be within the
/// tolerance, and their orders within the tolerance: edges that `model_continuity()` finds to
/// differ, such as those of rounded constructions. By the number of the first patch. An edge that
/// is near to several others is in several pairs.
///
/// The ends of near edges are near; so candidates are found by sorting, and for each the gap is
/// enclosed. A gap that is not small compared with the patches makes all pairs of edges candidates.
/// The limit of the work is that for each edge, and for the search, with its thousandth part more
/// for each edge.
/// \tparam PatchRange a forward range of surfaces, as for `model_continuity()`
/// \param patches of the model
/// \param model the result of `model_continuity(patches)`
/// \param tolerance for the gap and for the order 1
/// \param report is called as `report(n)` with the number of boundary edges compared so far, after
///   each
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number,
///   `not_finite` for an infinite gap, `work_limit`
template <class PatchRange, class FT, class Report>
std::vector<Nearly_coincident_edges> nearly_coincident_edges(const PatchRange& patches,
                                                             const Model_continuity<FT>& model,
                                                             const Edge_tolerance& tolerance, Report report) {
  typedef std::decay_t<decltype(*std::begin(patches))> Surface;
  typedef internal::Boundary_edge<FT, internal::row_dimension<Surface>> Edge;
  internal::check_tolerance(tolerance);
  const double gap = tolerance.gap.upper();
  internal::check_finite(gap, "nearly_coincident_edges: gap");
  const FT squared_gap = FT(gap) * FT(gap);
  std::vector<Edge> edges;
  std::size_t number = 0;
  auto row = model.edges.begin(); // by the number of the patch
  for (const auto& patch : patches) {
    for (; row != model.edges.end() && row->patch_a == number; ++row)
      if (row->kind == Model_edge_kind::boundary)
        edges.emplace_back(number, row->edge_a, spline_edge_rows(patch, row->edge_a));
    ++number;
  }
  const int side = internal::longest_side(edges);
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return a.low(side) < b.low(side); });
  const internal::Work_guard work("nearly_coincident_edges", 1 + static_cast<double>(edges.size()) / 1000);
  std::vector<Nearly_coincident_edges> result;
  for (auto i = edges.begin(); i != edges.end(); ++i) {
    for (auto j = i + 1; j != edges.end(); ++j) {
      if (gap < internal::next_below(j->low(side) - i->high(side))) break;
      if (!i->has_ends_near(*j, gap, squared_gap)) continue;
      const bool in_order = std::make_pair(i->patch, i->edge) < std::make_pair(j->patch, j->edge);
      const Edge &a = in_order ? *i : *j, &b = in_order ? *j : *i;
      const Edge_order_within within = order_within(internal::edge_deviation(a.pieces, b.pieces), tolerance);
      if (within(0) != Verdict::refuted) result.push_back({a.patch, a.edge, b.patch, b.edge, within});
    }
    report(static_cast<std::size_t>(i - edges.begin()) + 1);
  }
  std::sort(result.begin(), result.end(), [](const Nearly_coincident_edges& a, const Nearly_coincident_edges& b) {
    return std::make_pair(std::make_pair(a.patch_a, a.edge_a), std::make_pair(a.patch_b, a.edge_b)) <
           std::make_pair(std::make_pair(b.patch_a, b.edge_a), std::make_pair(b.patch_b, b.edge_b));
  });
  return result;
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the near edges of a model, without reports.
/// \throws Error as the function that reports
template <class PatchRange, class FT>
std::vector<Nearly_coincident_edges>
nearly_coincident_edges(const PatchRange& patches, const Model_continuity<FT>& model, const Edge_tolerance& tolerance) {
  return nearly_coincident_edges(patches, model, tolerance, [](std::size_t) {});
}

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
using Near_edges CGAL_DEPRECATED = Nearly_coincident_edges;
template <class... A> CGAL_DEPRECATED std::vector<Nearly_coincident_edges> near_edges(const A&... arguments) {
  return nearly_coincident_edges(arguments...);
}
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
