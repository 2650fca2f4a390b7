// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROUNDED_SHELL_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROUNDED_SHELL_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/models/internal/Planar_solid.h>
#include <CGAL/Geometric_continuity/models/internal/Polyhedron_rounding.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

/// \file Rounded_shell.h
/// The faces, edges and vertices of a polyhedron with rounded edges.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Fills a `Rounded_polyhedron`.
template <class Result> class Rounded_shell {
  typedef typename Result::Traits Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Polyhedron_rounding<FT> Rounding;
  typedef typename Rounding::Vector Vector;
  typedef typename Rounding::Column Column;
  typedef typename Rounding::Chain Chain;
  typedef typename Rounding::Vertex_kind Kind;
  enum Side { right = 0, left = 1 }; // of a halfedge, and the value of v

  // Consecutive spans of a chain with one edge.
  struct Run {
    int first, last;
    std::size_t edge;
  };

  const Rounding& rounding_;
  Result& result_;
  std::vector<std::array<std::vector<Run>, 2>> runs_; // of each chain
  std::vector<std::pair<int, int>> span_;             // of halfedges: the chain and the span
  struct End_edge {
    std::size_t edge;
    int of; // the halfedge across whose chain it runs; another one at a mitre
  };
  std::map<int, End_edge> end_edges_; // where chains run out or break, by the halfedge that leaves
  std::vector<std::size_t> seams_, sharp_edges_;
  std::vector<int> group_; // of the points beside halfedges where they leave: 2 h + side
  std::map<int, std::size_t> vertices_;

  int opposite(int h) const { return rounding_.opposite(h); }
  int face(int h) const { return rounding_.solid.halfedges[h].face; }
  Kind kind_at(int h) const { return rounding_.kind(rounding_.source(h)); }

public:
  Rounded_shell(const Rounding& rounding, Result& result) : rounding_(rounding), result_(result) {
    unite_points();
    add_rails();
    add_ends();
    add_sharp_edges();
    for (std::size_t c = 0; c < rounding_.chains.size(); ++c) add_blend(static_cast<int>(c));
    for (std::size_t f = 0; f < rounding_.solid.faces.size(); ++f) add_face(static_cast<int>(f));
  }

private:
  static Point point(const Vector& x) { return to_point<Traits>(x); }

  int representative(int i) {
    while (group_[i] != i) i = group_[i] = group_[group_[i]];
    return i;
  }
  void unite(int i, int j) { group_[representative(i)] = representative(j); }

  // Points beside two halfedges are one unless a rail turns between them, or a chain ends there.
  void unite_points() {
    const int n = static_cast<int>(rounding_.solid.halfedges.size());
    group_.resize(2 * static_cast<std::size_t>(n));
    std::iota(group_.begin(), group_.end(), 0);
    for (int h = 0; h < n; ++h) {
      if (!rounding_.is_rounded(h)) unite(2 * h + left, 2 * h + right);
      if (!turns_at(h) && !ends_between(h)) unite(2 * h + left, 2 * rounding_.turned(h) + right);
    }
  }
  // Returns whether the rail of a chain turns on the face of h, where it leaves.
  bool turns_at(int h) const {
    return kind_at(h) == Kind::corner && h == rounding_.turned(rounding_.stem(rounding_.source(h)));
  }
  // Returns whether a chain runs out at this face.
  bool ends_between(int h) const {
    return kind_at(h) == Kind::run_out && !rounding_.is_rounded(h) && !rounding_.is_rounded(rounding_.turned(h));
  }

  // The number of the vertex beside a halfedge where it leaves.
  std::size_t vertex(int h, int side) {
    const int i = representative(2 * h + side);
    const auto [place, is_new] = vertices_.emplace(i, result_.vertices.size());
    if (is_new)
      result_.vertices.push_back(
          point(rounding_.is_rounded(h) ? rounding_.end(h).at[side == left ? 5 : 0] : rounding_.sharp_end(h)));
    return place->second;
  }
  // The vertex beside a chain, at a seam.
  std::size_t vertex_at(const Chain& chain, int seam, int side) {
    const int n = static_cast<int>(chain.halfedges.size());
    const int h = chain.halfedges[static_cast<std::size_t>(seam / 2 % n)];
    return seam % 2 == 0 ? vertex(h, side) : vertex(opposite(h), 1 - side);
  }

  FT knot(const Chain& chain, int seam) const {
    return short_number_in<FT>(chain.knots[static_cast<std::size_t>(seam)]);
  }
  Knot_vector<FT> knots(const Chain& chain, int first, int last) const {
    std::vector<typename Knot_vector<FT>::Knot> inner;
    for (int k = first + 1; k < last; ++k) inner.push_back({knot(chain, k), 3});
    return {5, knot(chain, first), knot(chain, last), inner};
  }
  // The control points of a row between two seams: three for each seam, on both sides of which the
  // second derivative is zero.
  std::vector<Point> row(const Chain& chain, std::size_t j, int first, int last) const {
    std::vector<Point> points;
    const FT two(2);
    for (int k = first; k <= last; ++k) {
      const Vector &x = chain.seams[static_cast<std::size_t>(k)].at[j],
                   &along = chain.seams[static_cast<std::size_t>(k)].along[j];
      const FT before = k == first ? FT(0) : FT(knot(chain, k) - knot(chain, k - 1)),
               after = k == last ? FT(0) : FT(knot(chain, k + 1) - knot(chain, k));
      points.push_back(point(x - before * along));
      points.push_back(point(x + FT(FT(after - before) / two) * along));
      points.push_back(point(x + after * along));
    }
    return points;
  }

  std::size_t add_edge(std::vector<Point> points, Knot_vector<FT> knots, std::size_t start, std::size_t end,
                       typename Result::Edge_kind kind) {
    result_.edges.push_back({typename Result::Curve(std::move(points), std::move(knots)), start, end, kind});
    return result_.edges.size() - 1;
  }

  void add_rails() {
    span_.assign(rounding_.solid.halfedges.size(), {-1, -1});
    for (std::size_t c = 0; c < rounding_.chains.size(); ++c) {
      const Chain& chain = rounding_.chains[c];
      for (std::size_t k = 0; k < chain.halfedges.size(); ++k)
        span_[chain.halfedges[k]] =
            span_[opposite(chain.halfedges[k])] = {static_cast<int>(c), static_cast<int>(2 * k)};
      runs_.emplace_back();
      for (int side : {right, left}) {
        std::vector<Run>& runs = runs_.back()[static_cast<std::size_t>(side)];
        // an edge for each span: systems that integrate along edges expect no inner knots
        for (int span = 0; span < chain.number_of_spans(); ++span) runs.push_back({span, span, 0});
        for (Run& run : runs)
          run.edge = add_edge(row(chain, side == left ? 5 : 0, run.first, run.last + 1),
                              knots(chain, run.first, run.last + 1), vertex_at(chain, run.first, side),
                              vertex_at(chain, run.last + 1, side), Result::Edge_kind::rail);
      }
    }
  }

  const Run& run_at(int chain, int span, int side) const {
    const std::vector<Run>& runs = runs_[static_cast<std::size_t>(chain)][static_cast<std::size_t>(side)];
    return *std::find_if(runs.begin(), runs.end(), [&](const Run& run) { return span <= run.last; });
  }
  // Returns at a corner the run of the chain that passes, by the span between its two edges.
  std::pair<int, int> corner_span(int vertex) const {
    const int a = rounding_.turned(rounding_.stem(vertex)), b = rounding_.turned(a);
    const auto [chain, at_a] = span_[a];
    const auto of_b = span_[b];
    const Chain& c = rounding_.chains[static_cast<std::size_t>(chain)];
    // it comes in along the reverse of the one that is not among its halfedges
    const bool a_goes_out = c.halfedges[static_cast<std::size_t>(at_a / 2)] == a;
    return {chain, a_goes_out ? of_b.second + 1 : at_a + 1};
  }
  bool goes_out(int h) const {
    const auto [chain, span] = span_[h];
    return rounding_.chains[static_cast<std::size_t>(chain)].halfedges[static_cast<std::size_t>(span / 2)] == h;
  }

  std::vector<Point> column(const Chain& chain, bool at_end) const {
    std::vector<Point> points;
    for (const Vector& x : (at_end ? chain.seams.back() : chain.seams.front()).at) points.push_back(point(x));
    return points;
  }

  // Edges across chains, from the right to the left side.
  void add_ends() {
    const Knot_vector<FT> unit(5, FT(0), FT(1));
    for (const Chain& chain : rounding_.chains) {
      seams_.push_back(0);
      if (chain.closed) {
        seams_.back() = add_edge(column(chain, false), unit, vertex_at(chain, 0, right), vertex_at(chain, 0, left),
                                 Result::Edge_kind::seam);
        continue;
      }
      for (bool at_end : {false, true}) {
        const int h = at_end ? opposite(chain.halfedges.back()) : chain.halfedges.front();
        if (kind_at(h) == Kind::corner) continue;
        const auto known = kind_at(h) == Kind::mitre ? end_edges_.find(mate(h)) : end_edges_.end();
        if (known != end_edges_.end()) {
          end_edges_[h] = known->second;
          continue;
        }
        const int seam = at_end ? chain.number_of_spans() : 0;
        end_edges_[h] = {add_edge(column(chain, at_end), unit, vertex_at(chain, seam, right),
                                  vertex_at(chain, seam, left),
                                  kind_at(h) == Kind::mitre ? Result::Edge_kind::mitre : Result::Edge_kind::end),
                         h};
      }
    }
  }
  // Returns at a mitre the other rounded edge.
  int mate(int h) const {
    const int x = rounding_.turned(h);
    return rounding_.is_rounded(x) ? x : rounding_.turned(x);
  }

  void add_sharp_edges() {
    const std::size_t n = rounding_.solid.halfedges.size() / 2;
    sharp_edges_.assign(n, 0);
    for (std::size_t e = 0; e < n; ++e) {
      const int h = static_cast<int>(2 * e), o = h + 1;
      if (rounding_.is_rounded(h)) continue;
      const std::size_t start = vertex(h, left), end = vertex(o, left);
      sharp_edges_[e] = add_edge({result_.vertices[start], result_.vertices[end]}, Knot_vector<FT>(1, FT(0), FT(1)),
                                 start, end, Result::Edge_kind::sharp);
    }
  }

  typedef typename Result::Blend_use Blend_use;

  // The edge at an end of a chain, as its loop passes it: with growing v where the chain ends.
  Blend_use end_use(const Chain& chain, bool at_end, std::size_t seam) const {
    const int h = at_end ? opposite(chain.halfedges.back()) : chain.halfedges.front();
    std::size_t edge = seam;
    bool agrees = true; // whether it runs with growing v
    if (!chain.closed && kind_at(h) == Kind::corner) {
      // The rail of the chain that passes, which comes in or goes out along the edge left of h.
      const auto [other, span] = corner_span(rounding_.source(h));
      const bool from_the_left = !goes_out(rounding_.turned(h));
      edge = run_at(other, span, from_the_left ? left : right).edge;
      agrees = from_the_left == at_end;
    } else if (!chain.closed) {
      const End_edge& known = end_edges_.at(h);
      edge = known.edge;
      agrees = known.of == h || goes_out(known.of) != goes_out(h);
    }
    return {{edge, agrees != at_end},
            at_end ? Patch_edge::u1 : Patch_edge::u0,
            agrees ? FT(0) : FT(1),
            agrees ? FT(1) : FT(0)};
  }

  void add_blend(int c) {
    const Chain& chain = rounding_.chains[static_cast<std::size_t>(c)];
    const int last = chain.number_of_spans();
    std::vector<std::vector<Point>> net(3 * static_cast<std::size_t>(last + 1), std::vector<Point>());
    for (std::size_t j = 0; j < 6; ++j) {
      const std::vector<Point> points = row(chain, j, 0, last);
      for (std::size_t i = 0; i < points.size(); ++i) net[i].push_back(points[i]);
    }
    std::vector<std::size_t> given;
    for (int h : chain.halfedges)
      for (int e : rounding_.solid.given_edges[rounding_.solid.halfedges[h].edge])
        given.push_back(static_cast<std::size_t>(e));
    std::vector<Blend_use> loop;
    const auto add_side = [&](const Run& run, Patch_edge side, bool reversed) {
      loop.push_back({{run.edge, reversed}, side, knot(chain, run.first), knot(chain, run.last + 1)});
    };
    const auto& runs = runs_[static_cast<std::size_t>(c)];
    for (const Run& run : runs[right]) add_side(run, Patch_edge::v0, false);
    loop.push_back(end_use(chain, true, seams_[static_cast<std::size_t>(c)]));
    for (std::size_t k = runs[left].size(); k-- > 0;) add_side(runs[left][k], Patch_edge::v1, true);
    loop.push_back(end_use(chain, false, seams_[static_cast<std::size_t>(c)]));
    result_.blends.push_back({typename Result::Surface(net, knots(chain, 0, last), Knot_vector<FT>(5, FT(0), FT(1))),
                              chain.closed, std::move(given), std::move(loop)});
  }

  typedef typename Result::Use Use;

  // Returns whether a loop runs counterclockwise around its face.
  bool is_outer(int first) const {
    const auto& solid = rounding_.solid;
    const Vector& origin = solid.points[static_cast<std::size_t>(rounding_.source(first))];
    Vector area(3);
    int h = first;
    do {
      area += cross_product(solid.points[static_cast<std::size_t>(rounding_.source(h))] - origin, solid.direction(h));
      h = solid.halfedges[h].next;
    } while (h != first);
    return FT(0) < dot(area, solid.normal(first));
  }

  void add_face(int f) {
    const auto& face_of_solid = rounding_.solid.faces[static_cast<std::size_t>(f)];
    const auto& plane = rounding_.planes[static_cast<std::size_t>(f)];
    std::vector<std::vector<Use>> loops;
    for (int first : face_of_solid.loops) {
      std::vector<Use> loop;
      // pieces of one rail follow each other
      const auto add = [&](std::size_t edge, bool reversed) {
        if (loop.empty() || loop.back().edge != edge) loop.push_back({edge, reversed});
      };
      int h = first;
      do {
        const int v = rounding_.source(h);
        if (turns_at(h)) {
          const auto [chain, span] = corner_span(v);
          const bool forward = goes_out(h);
          add(run_at(chain, span, forward ? left : right).edge, !forward);
        } else if (ends_between(h)) {
          const int rounded = rounding_.turned(rounding_.turned(h));
          const std::size_t edge = end_edges_.at(rounded).edge;
          // from the right of the edge as it leaves to the left, where its chain goes out with the
          // edge
          add(edge, !goes_out(rounded));
        }
        if (rounding_.is_rounded(h)) {
          const bool forward = goes_out(h);
          const auto [chain, span] = span_[h];
          add(run_at(chain, span, forward ? left : right).edge, !forward);
        } else
          add(sharp_edges_[static_cast<std::size_t>(h / 2)], h % 2 != 0);
        h = rounding_.solid.halfedges[h].next;
      } while (h != first);
      if (loop.size() > 1 && loop.front().edge == loop.back().edge) loop.pop_back();
      loops.push_back(std::move(loop));
      if (is_outer(first)) std::swap(loops.front(), loops.back());
    }
    result_.faces.push_back({static_cast<std::size_t>(face_of_solid.given), point(plane.origin()),
                             to_vector<Traits>(plane.x()), to_vector<Traits>(plane.y()), std::move(loops)});
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROUNDED_SHELL_H
