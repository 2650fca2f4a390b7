// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_MODEL_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_MODEL_CONTINUITY_H

#include <CGAL/Geometric_continuity/internal/Decision_ring.h>
#include <CGAL/Geometric_continuity/surfaces/patch_continuity.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// What an edge of a model is.
enum class Model_edge_kind {
  shared,   ///< two patches have it
  boundary, ///< only one patch has it
  collapsed ///< it is a single point: all its control points are equal
};

/// \ingroup PkgGeometricContinuitySurfaces
inline std::string to_string(Model_edge_kind kind) {
  switch (kind) {
  case Model_edge_kind::shared: return "shared";
  case Model_edge_kind::boundary: return "boundary";
  case Model_edge_kind::collapsed: return "collapsed";
  }
  return "unknown";
}

inline std::ostream& operator<<(std::ostream& os, Model_edge_kind kind) { return os << to_string(kind); }

/// \ingroup PkgGeometricContinuitySurfaces
/// An edge of a model, with the decision if it is shared.
/// \tparam FT the field in which it was decided
template <class FT> struct Model_edge {
  Model_edge_kind kind;
  std::size_t patch_a;                ///< the number of the patch, from 0 on
  Patch_edge edge_a;                  ///< its edge
  std::optional<std::size_t> patch_b; ///< the other patch of a shared edge; the same one where a patch closes up
  std::optional<Patch_edge> edge_b;   ///< its edge
  bool non_manifold = false;          ///< more than two patches have the edge
  Edge_continuity<FT> continuity;     ///< of a shared edge

  /// Writes the row, e.g. `0 u1 - 1 u0: G2` or `5 v0: boundary`.
  friend std::ostream& operator<<(std::ostream& os, const Model_edge& e) {
    os << e.patch_a << ' ' << e.edge_a;
    if (e.kind != Model_edge_kind::shared) return os << ": " << e.kind;
    os << " - " << *e.patch_b << ' ' << *e.edge_b << ": " << e.continuity;
    return os << (e.non_manifold ? ", non-manifold" : "");
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// How many edges of a model have which continuity.
struct Model_summary {
  std::size_t g2 = 0;                ///< shared edges that are \f$ G^2 \f$
  std::size_t g1 = 0;                ///< shared edges that are \f$ G^1 \f$ but not \f$ G^2 \f$
  std::size_t g0 = 0;                ///< shared edges that are not \f$ G^1 \f$
  std::size_t vanishing_normals = 0; ///< those of `g0` whose only defect is that a normal vanishes somewhere
  std::size_t creases = 0;           ///< those of `g0` where the tangent planes differ somewhere
  std::size_t folds = 0;             ///< the others of `g0`
  std::size_t boundary = 0;          ///< edges of one patch only
  std::size_t collapsed = 0;         ///< edges that are single points
  std::size_t non_manifold = 0; ///< pairs of patches at an edge that more than two patches have; counted above, too

  /// Writes the counts, e.g. `24 G2, 20 G1, 8 G0 (8 vanishing normals), 16 boundary, 8 collapsed`.
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
    return os;
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// What was decided about all edges of a model.
template <class FT> struct Model_continuity {
  std::vector<Model_edge<FT>> edges; ///< by the number of the first patch, then by its edge
  Model_summary summary;

  /// The shared edges whose order is less.
  std::vector<Model_edge<FT>> failing(int g_order) const {
    std::vector<Model_edge<FT>> result;
    for (const Model_edge<FT>& e : edges)
      if (e.kind == Model_edge_kind::shared && e.continuity.g_order < g_order) result.push_back(e);
    return result;
  }
};

namespace internal {

// A sequence of numbers that two edges have in common if and only if they are the same polynomial curve, run through in
// either direction, whatever their degrees: the coefficients of the powers of the parameter, up to the last that is not
// zero, in the direction that makes the sequence smaller. They are found without divisions.
template <class Traits> class Edge_key {
  typedef Edge_field<Traits> Field;
  typedef typename Exact_number<Field>::type Exact; // compared often, evaluated once
  std::vector<Exact> numbers_;

public:
  Edge_key(const Bezier_patch<Traits>& patch, Patch_edge edge) {
    auto row = patch.template rows<Field>(edge, 0)[0];
    numbers_ = powers(row);
    std::reverse(row.begin(), row.end());
    std::vector<Exact> backwards = powers(std::move(row));
    if (backwards < numbers_) numbers_.swap(backwards);
  }

  bool single_point() const { return numbers_.size() == 3; }

  // Negative, zero or positive.
  int compare(const Edge_key& other) const {
    const std::size_t n = std::min(numbers_.size(), other.numbers_.size());
    for (std::size_t i = 0; i < n; ++i) {
      if (numbers_[i] < other.numbers_[i]) return -1;
      if (other.numbers_[i] < numbers_[i]) return 1;
    }
    return numbers_.size() < other.numbers_.size() ? -1 : numbers_.size() > other.numbers_.size() ? 1 : 0;
  }

private:
  template <class Row> static std::vector<Exact> powers(Row row) {
    const int n = static_cast<int>(row.size()) - 1;
    const std::vector<Exact> binomials = binomial_coefficients<Exact>(n);
    std::vector<Exact> a;
    for (int k = 0; k <= n; ++k) {
      for (int i = 0; i < 3; ++i) a.push_back(Exact(binomials[k] * Exact_number<Field>::of(row[0][i])));
      difference_step(row, n - k);
    }
    while (a.size() > 3 && a[a.size() - 1] == Exact(0) && a[a.size() - 2] == Exact(0) && a[a.size() - 3] == Exact(0))
      a.resize(a.size() - 3);
    return a;
  }
};

template <class Traits> class Model_analysis {
  typedef Edge_field<Traits> Field;
  typedef Edge_key<Traits> Key;

  struct Use {
    std::size_t patch;
    Patch_edge edge;
    Key key;
  };

  const std::vector<const Bezier_patch<Traits>*>& patches_;
  Model_continuity<Field> model_;

public:
  explicit Model_analysis(const std::vector<const Bezier_patch<Traits>*>& patches) : patches_(patches) {}

  Model_continuity<Field> operator()() {
    std::vector<Use> uses;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      for (Patch_edge edge : patch_edges) {
        require_space(*patches_[i], "continuity_of_model");
        Use use{i, edge, Key(*patches_[i], edge)};
        if (use.key.single_point()) {
          add(Model_edge_kind::collapsed, use);
          ++model_.summary.collapsed;
        } else
          uses.push_back(std::move(use));
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
/// kernel, see `edge_continuity()`. Two edges are the same when their points and their parametrisations are, in either
/// direction and after exact elevation to one degree; nothing is merged within a tolerance, and an edge that meets only a
/// part of another one is a boundary edge.
///
/// Each edge of each patch is in one row: collapsed edges, which are not compared; boundary edges; and shared edges with
/// both patches, which may be the same. When more than two patches have one edge, say in the order of their numbers
/// \f$ s_1, \dots, s_k \f$, there is one row for each pair \f$ s_i, s_{i+1} \f$, marked `non_manifold`, so that \f$ k-1 \f$
/// rows and not \f$ k(k-1)/2 \f$ are decided.
///
/// The edges are found by sorting: \f$ O(n \log n) \f$ comparisons for `n` patches; then each shared edge is decided once.
///
/// \tparam PatchRange a forward range of `Bezier_patch`, which must outlive the call
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class PatchRange> auto continuity_of_model(const PatchRange& patches) {
  typedef std::decay_t<decltype(*std::begin(patches))> Patch;
  std::vector<const Patch*> pointers;
  for (const Patch& patch : patches) pointers.push_back(&patch);
  return internal::Model_analysis<typename Patch::Traits>(pointers)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_MODEL_CONTINUITY_H
