// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H

#include <CGAL/Geometric_continuity/models/Model_edge.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Surface, class Report>
std::vector<Knot_line<Edge_field<typename Surface::Traits>>> knot_lines_in_model(const Surface& surface,
                                                                                 Work_limit limit, Report report) {
  if constexpr (Is_patch<Surface>::value)
    return {};
  else
    return knot_lines(surface, limit, report);
}

template <class Surface, class Report> class Model_analysis {
  typedef Edge_field<typename Surface::Traits> Field;

  const std::vector<const Surface*>& patches_;
  const Work_limit limit_;
  Report& report_;
  std::size_t decided_ = 0;
  Model_continuity<Field> model_;

public:
  Model_analysis(const std::vector<const Surface*>& patches, Work_limit limit, Report& report)
      : patches_(patches), limit_(limit), report_(report) {}

  Model_continuity<Field> operator()() {
    for (const Surface* patch : patches_) require_space(*patch, "model_continuity");
    for (std::size_t i = 0; i < patches_.size(); ++i) add_knot_lines(i);
    const Edge_groups<Surface> groups(patches_, limit_);
    for (const Edge_use& use : groups.collapsed()) add(Model_edge_kind::collapsed, use);
    for (const Edge_uses& uses : groups.edges()) {
      if (uses.size() == 1) add(Model_edge_kind::boundary, uses[0]);
      for (std::size_t i = 1; i < uses.size(); ++i) share(uses[i - 1], uses[i], uses.size() > 2);
    }
    std::sort(model_.edges.begin(), model_.edges.end(), [](const Model_edge<Field>& a, const Model_edge<Field>& b) {
      return std::make_pair(a.patch_a, a.edge_a) < std::make_pair(b.patch_a, b.edge_a);
    });
    count_edges();
    return std::move(model_);
  }

private:
  Model_edge<Field>& add(Model_edge_kind kind, const Edge_use& a) {
    model_.edges.push_back(Model_edge<Field>{kind, a.patch, a.edge, {}, {}, false, {}});
    return model_.edges.back();
  }

  void add_knot_lines(std::size_t i) {
    Model_summary& s = model_.summary;
    std::vector<Knot_line<Field>> lines;
    name_work_limit([&] { return "patch " + std::to_string(i); },
                    [&] { lines = knot_lines_in_model(*patches_[i], limit_, [this] { report_(++decided_); }); });
    for (Knot_line<Field>& line : lines) {
      const int order = line.continuity.g_order;
      ++(order == 2 ? s.knot_lines_g2 : order == 1 ? s.knot_lines_g1 : s.knot_lines_g0);
      model_.knot_lines.push_back({i, std::move(line)});
    }
  }

  void share(const Edge_use& a, const Edge_use& b, bool non_manifold) {
    Model_edge<Field>& row = add(Model_edge_kind::shared, a);
    row.patch_b = b.patch;
    row.edge_b = b.edge;
    row.non_manifold = non_manifold;
    name_work_limit([&] { return edge_name(a.patch, a.edge) + " - " + edge_name(b.patch, b.edge); },
                    [&] {
                      row.continuity = continuity_of_same_edge(
                          *patches_[a.patch], a.edge, *patches_[b.patch], b.edge,
                          a.backwards == b.backwards ? Edge_direction::same : Edge_direction::opposite, limit_);
                    });
    report_(++decided_);
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
/// given where edges with the same ends have one degree and the same knots. Then each shared edge is decided once, smooth
/// edges with integers of fixed length where `edge_continuity()` takes them.
///
/// \tparam PatchRange a forward range of `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`; polynomial surfaces can be converted to rational ones
/// \param patches of the model, which must outlive the call
/// \param limit the work that is allowed for each edge, to recognise and to decide it, and for each knot line
/// \param report is called as `report(n)` with the number of shared edges and knot lines decided so far, after each
/// \throws Error `dimension_mismatch` unless in dimension 3; `work_limit`, with the patch and the edge
template <class PatchRange, class Report>
auto model_continuity(const PatchRange& patches, Work_limit limit, Report report) {
  typedef std::decay_t<decltype(*std::begin(patches))> Patch;
  std::vector<const Patch*> pointers;
  for (const Patch& patch : patches) pointers.push_back(&patch);
  return internal::Model_analysis<Patch, Report>(pointers, limit, report)();
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity along all edges of a model, without reports.
/// \throws Error as the function that reports
template <class PatchRange> auto model_continuity(const PatchRange& patches, Work_limit limit = Work_limit()) {
  return model_continuity(patches, limit, [](std::size_t) {});
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
