// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H

#include <CGAL/Geometric_continuity/models/Model_edge.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_key.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Traits>
std::vector<Knot_line<Edge_field<Traits>>> knot_lines_in_model(const Bspline_surface<Traits>& surface) {
  return knot_line_continuity(surface);
}
template <class Traits> std::vector<Knot_line<Edge_field<Traits>>> knot_lines_in_model(const Bezier_patch<Traits>&) {
  return {};
}

template <class Surface> class Model_analysis {
  typedef Edge_field<typename Surface::Traits> Field;
  typedef Edge_key<typename Surface::Traits> Key;

  struct Use {
    std::size_t patch;
    Patch_edge edge;
    Key key;
  };

  const std::vector<const Surface*>& patches_;
  Model_continuity<Field> model_;

public:
  explicit Model_analysis(const std::vector<const Surface*>& patches) : patches_(patches) {}

  Model_continuity<Field> operator()() {
    std::vector<Use> uses;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      require_space(*patches_[i], "model_continuity");
      add_knot_lines(i);
      for (Patch_edge edge : patch_edges) {
        Use use{i, edge, Key(*patches_[i], edge)};
        if (use.key.single_point()) {
          add(Model_edge_kind::collapsed, use);
          ++model_.summary.collapsed;
        } else
          uses.push_back(std::move(use));
      }
    }
    std::vector<const Use*> sorted;
    for (const Use& use : uses) sorted.push_back(&use);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Use* a, const Use* b) { return a->key.compare(b->key) < 0; });
    for (auto first = sorted.begin(), last = first; first != sorted.end(); first = last) {
      while (last != sorted.end() && (*first)->key.compare((*last)->key) == 0) ++last;
      if (last - first == 1) {
        add(Model_edge_kind::boundary, **first);
        ++model_.summary.boundary;
      }
      for (auto next = first + 1; next != last; ++next) share(**(next - 1), **next, last - first > 2);
    }
    std::sort(model_.edges.begin(), model_.edges.end(), [](const Model_edge<Field>& a, const Model_edge<Field>& b) {
      return std::make_pair(a.patch_a, a.edge_a) < std::make_pair(b.patch_a, b.edge_a);
    });
    return std::move(model_);
  }

private:
  Model_edge<Field>& add(Model_edge_kind kind, const Use& a) {
    model_.edges.push_back(Model_edge<Field>{kind, a.patch, a.edge, {}, {}, false, {}});
    return model_.edges.back();
  }

  void add_knot_lines(std::size_t i) {
    Model_summary& s = model_.summary;
    for (Knot_line<Field>& line : knot_lines_in_model(*patches_[i])) {
      const int order = line.continuity.g_order;
      ++(order == 2 ? s.knot_lines_g2 : order == 1 ? s.knot_lines_g1 : s.knot_lines_g0);
      model_.knot_lines.push_back({i, std::move(line)});
    }
  }

  void share(const Use& a, const Use& b, bool non_manifold) {
    Model_edge<Field>& row = add(Model_edge_kind::shared, a);
    row.patch_b = b.patch;
    row.edge_b = b.edge;
    row.non_manifold = non_manifold;
    row.continuity = edge_continuity(*patches_[a.patch], a.edge, *patches_[b.patch], b.edge);
    Model_summary& s = model_.summary;
    s.non_manifold += non_manifold;
    ++(row.continuity.g_order == 2 ? s.g2 : row.continuity.g_order == 1 ? s.g1 : s.g0);
    if (row.continuity.defect == Edge_defect::vanishing_normal) ++s.vanishing_normals;
    if (row.continuity.defect == Edge_defect::crease) ++s.creases;
    if (row.continuity.defect == Edge_defect::fold) ++s.folds;
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
/// The edges are found by sorting: \f$ O(n \log n) \f$ comparisons for `n` patches; then each shared edge is decided once.
///
/// \tparam PatchRange a forward range of `Bezier_patch` or of `Bspline_surface`, which must outlive the call
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class PatchRange> auto model_continuity(const PatchRange& patches) {
  typedef std::decay_t<decltype(*std::begin(patches))> Patch;
  std::vector<const Patch*> pointers;
  for (const Patch& patch : patches) pointers.push_back(&patch);
  return internal::Model_analysis<Patch>(pointers)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_CONTINUITY_H
