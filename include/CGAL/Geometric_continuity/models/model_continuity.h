// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H

#include <CGAL/Geometric_continuity/internal/for_each_block.h>
#include <CGAL/Geometric_continuity/models/Model_edge.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <iterator>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Calls work(i) for the numbers 0 <= i < n, on several cores with Parallel_tag. If some calls throw, the exception for the least
// number leaves the function, as without cores.
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
  std::size_t decided_ = 0;
  std::mutex mutex_; // for the two above
  Model_continuity<Field> model_;

public:
  Model_analysis(const std::vector<const Surface*>& patches, Report& report) : patches_(patches), report_(report) {}

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
      name_work_limit([&] { return "patch " + std::to_string(i); },
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
    name_work_limit([&] { return edge_name(a.patch, a.edge) + " - " + edge_name(b.patch, b.edge); },
                    [&] {
                      edge.continuity = continuity_of_same_edge(*patches_[a.patch], a.edge, *patches_[b.patch], b.edge,
                                                                a.backwards == b.backwards ? Edge_direction::same
                                                                                           : Edge_direction::opposite);
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

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds all edges that the patches of a model share and decides the continuity along each of them, exactly and with every
/// kernel, see `edge_continuity()`; and along the knot lines of B-spline surfaces, see `knot_line_continuity()`. Two edges
/// are the same when the affine map of one domain to the other, in either direction, makes them the same curve, whatever their
/// degrees and knots; nothing is merged within a tolerance, and an edge that meets only a part of another one is a boundary
/// edge.
///
/// Each edge of each patch is in one row: collapsed edges, which are not compared; boundary edges; and shared edges with
/// both patches, which may be the same. When more than two patches have one edge, say in the order of their numbers
/// \f$ s_1, \dots, s_k \f$, there is one row for each pair \f$ s_i, s_{i+1} \f$, marked `non_manifold`, so that \f$ k-1 \f$
/// rows and not \f$ k(k-1)/2 \f$ are decided.
///
/// Each edge is recognised once, by sorting: \f$ O(n \log n) \f$ comparisons for `n` patches, of the control points as they are
/// given, and of the quotients of weights, where edges with the same ends have one degree and the same knots. Then each shared
/// edge is decided once, with integers of fixed length where `edge_continuity()` takes them. The limit of the work is that for each
/// edge, to recognise and to decide it, and for each knot line.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: edges and knot lines are decided on
///   several cores, with the same result, on number types that may be copied concurrently, see failing_joins.h
/// \tparam PatchRange a forward range of `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`; polynomial surfaces can be converted to rational ones
/// \param patches of the model, which must outlive the call
/// \param report is called as `report(n)` with the number of shared edges and knot lines decided so far, after each,
///   by one core at a time
/// \throws Error `dimension_mismatch` unless in dimension 3; `work_limit`, with the patch and the edge
template <class Concurrency_tag = Sequential_tag, class PatchRange, class Report>
auto model_continuity(const PatchRange& patches, Report report) {
  typedef std::decay_t<decltype(*std::begin(patches))> Patch;
  std::vector<const Patch*> pointers;
  for (const Patch& patch : patches) pointers.push_back(&patch);
  return internal::Model_analysis<Concurrency_tag, Patch, Report>(pointers, report)();
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity along all edges of a model, without reports.
/// \throws Error as the function that reports
template <class Concurrency_tag = Sequential_tag, class PatchRange> auto model_continuity(const PatchRange& patches) {
  return model_continuity<Concurrency_tag>(patches, [](std::size_t) {});
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
