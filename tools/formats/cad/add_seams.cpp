// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/add_seams.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

typedef std::vector<Shell_model::Use> Loop;

// A parameter of a surface: its number, 0 for u and 1 for v, and its domain.
struct Direction {
  std::size_t number;
  double begin, end;

  Direction(const Shell_model::Surface& s, std::size_t number) : number(number) {
    const std::vector<double>& knots = number == 0 ? s.knots_u : s.knots_v;
    const auto degree = static_cast<std::size_t>(number == 0 ? s.degree_u : s.degree_v);
    begin = knots[degree];
    end = knots[knots.size() - degree - 1];
  }
  bool near(double x, double y) const { return std::abs(x - y) <= 1e-9 * (end - begin); }
};

const std::array<double, 2>& first(const Shell_model::Use& use) {
  return use.reversed ? use.curve.points.back() : use.curve.points.front();
}
const std::array<double, 2>& last(const Shell_model::Use& use) {
  return use.reversed ? use.curve.points.front() : use.curve.points.back();
}

// Returns how far a loop runs in a direction: the length of the domain or its negative for a rail,
// 0 for a loop that comes back in the parameters.
double length(const Loop& loop, const Direction& s) {
  double sum = 0;
  for (const Shell_model::Use& use : loop) sum += last(use)[s.number] - first(use)[s.number];
  return sum;
}

std::vector<std::array<double, 3>> points_at_begin(const Shell_model::Surface& surface, const Direction& s) {
  if (s.number == 0) return surface.points.front();
  std::vector<std::array<double, 3>> points;
  for (const auto& row : surface.points) points.push_back(row.front());
  return points;
}
std::vector<std::array<double, 3>> points_at_end(const Shell_model::Surface& surface, const Direction& s) {
  if (s.number == 0) return surface.points.back();
  std::vector<std::array<double, 3>> points;
  for (const auto& row : surface.points) points.push_back(row.back());
  return points;
}

// Begins a rail where the direction does, or ends if the rail runs backwards. Returns false if it
// has no vertex there.
bool begin_at_seam(Loop& loop, const Direction& s) {
  const double begin = length(loop, s) > 0 ? s.begin : s.end;
  const auto use = std::find_if(loop.begin(), loop.end(),
                                [&](const Shell_model::Use& u) { return s.near(first(u)[s.number], begin); });
  if (use == loop.end()) return false;
  std::rotate(loop.begin(), use, loop.end());
  return true;
}

class Seam_builder {
  Shell_model& model_;
  std::size_t number_;
  Shell_model::Face& face_;

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error("face " + std::to_string(number_) + (face_.name.empty() ? "" : " (" + face_.name + ")") +
                             ": " + reason);
  }

  int first_vertex(const Shell_model::Use& use) const {
    const Shell_model::Edge& edge = model_.edges[static_cast<std::size_t>(use.edge)];
    return use.reversed ? edge.end : edge.start;
  }

  // The use of the seam where the closed direction s has this value.
  Shell_model::Use use_of_seam(bool reversed, const Direction& s, const Direction& t, double at) const {
    std::array<double, 2> low{}, high{};
    low[s.number] = high[s.number] = at;
    low[t.number] = t.begin;
    high[t.number] = t.end;
    return {static_cast<int>(model_.edges.size()), reversed, {1, {t.begin, t.begin, t.end, t.end}, {low, high}}};
  }

public:
  Seam_builder(Shell_model& model, std::size_t number) : model_(model), number_(number), face_(model.faces[number]) {}

  void add(const Direction& s, const Direction& t) {
    // Counterclockwise round the parameters: v of the loop that runs along u is the lower one.
    Loop low = face_.loops[0], high = face_.loops[1];
    if ((length(low, s) > 0) != (s.number == 0)) low.swap(high);
    if (points_at_begin(face_.surface, s) != points_at_end(face_.surface, s))
      fail("its loops run round a surface that is not closed");
    if (!begin_at_seam(low, s) || !begin_at_seam(high, s))
      fail("a loop has no vertex where the closed direction of the surface begins");
    for (const auto& [loop, at] : {std::pair<const Loop&, double>(low, t.begin), {high, t.end}})
      for (const Shell_model::Use& use : loop)
        for (const std::array<double, 2>& uv : use.curve.points)
          if (!t.near(uv[t.number], at)) fail("a loop runs round inside of the surface, not along its end");
    const Shell_model::Surface& surface = face_.surface;
    const Shell_model::Spline_curve curve{t.number == 0 ? surface.degree_u : surface.degree_v,
                                          t.number == 0 ? surface.knots_u : surface.knots_v,
                                          points_at_begin(surface, s)};
    const bool runs_forward = length(low, s) > 0;
    const Shell_model::Edge seam{curve, first_vertex(low[0]), first_vertex(high[0])};
    low.push_back(use_of_seam(false, s, t, runs_forward ? s.end : s.begin));
    low.insert(low.end(), high.begin(), high.end());
    low.push_back(use_of_seam(true, s, t, runs_forward ? s.begin : s.end));
    model_.edges.push_back(seam);
    face_.loops = {std::move(low)};
  }
};

} // namespace

void add_seams(Shell_model& model) {
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const Shell_model::Face& face = model.faces[i];
    if (face.surface.plane || face.loops.size() != 2) continue;
    const std::array<Direction, 2> directions{Direction(face.surface, 0), Direction(face.surface, 1)};
    for (std::size_t s = 0; s < 2; ++s) {
      const double a = length(face.loops[0], directions[s]), b = length(face.loops[1], directions[s]);
      if (directions[s].near(a + b, 0) && directions[s].near(std::abs(a), directions[s].end - directions[s].begin)) {
        Seam_builder(model, i).add(directions[s], directions[1 - s]);
        break;
      }
    }
  }
}
