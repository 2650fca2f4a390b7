// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/Model_surfaces.h"
#include "commands/models/model_certificate.h"
#include "files/progress.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace {

// Returns f(surfaces) for those in the units of the files, which are over fractions.
template <class Variant, class Function> auto visit_exact(const Variant& surfaces, const Function& f) {
  const auto* const polynomial = std::get_if<1>(&surfaces);
  return polynomial != nullptr ? f(*polynomial) : f(std::get<2>(surfaces));
}

template <class Surface>
void append(std::vector<double>& numbers, const Surface& s, const typename Surface::FT& u,
            const typename Surface::FT& v) {
  const typename Surface::Point p = s(u, v);
  for (int i = 0; i < 3; ++i) numbers.push_back(CGAL::to_double(p[i]));
}

// The number i of n + 1 parameters.
template <class FT> FT parameter(const std::pair<FT, FT>& domain, int i, int n) {
  if (i == n) return domain.second;
  return FT(domain.first + (domain.second - domain.first) * FT(i) / FT(n));
}

// The line where u, or v, is constant.
template <class Surface>
std::vector<double> line(const Surface& s, bool constant_u, const typename Surface::FT& parameter_across) {
  typedef typename Surface::FT FT;
  const std::size_t spans = (constant_u ? s.knots_v() : s.knots_u()).spans().size();
  const int n = static_cast<int>((std::min)(spans * 16, std::size_t(400)));
  std::vector<double> points;
  for (int i = 0; i <= n; ++i) {
    const FT t = parameter(constant_u ? s.domain_v() : s.domain_u(), i, n);
    append(points, s, constant_u ? parameter_across : t, constant_u ? t : parameter_across);
  }
  return points;
}

} // namespace

Model_surfaces::Model_surfaces(const std::vector<std::string>& files, Units units) {
  Surface_texts<Exact_space> texts = read_surface_texts<Exact_space>(files);
  places_ = texts.places();
  if (units == Units::any) {
    GC::G2_grid grid;
    std::vector<Double_surface> surfaces;
    if (texts.on_grid(grid, surfaces)) {
      for (int e = grid.exponent_of_knots(); e < 0; ++e) parameter_unit_ /= Exact(10);
      surfaces_ = std::move(surfaces);
      return;
    }
  }
  texts.model().visit([&](const auto& surfaces) { surfaces_ = surfaces; });
}

std::size_t Model_surfaces::size() const {
  return std::visit([](const auto& surfaces) { return surfaces.size(); }, surfaces_);
}

GC::Model_continuity<Exact> Model_surfaces::continuity(GC::Crease_angles angles) const {
  Progress progress("edges and knot lines");
  return std::visit(
      [&](const auto& surfaces) {
        return GC::model_continuity<CGAL::Parallel_if_available_tag>(
            surfaces, [&](std::size_t n) { progress.step(n); }, angles);
      },
      surfaces_);
}

Within Model_surfaces::order_within(const Line& line, const GC::Edge_tolerance& tolerance) const {
  return visit_exact(
      surfaces_, [&](const auto& surfaces) { return GC::order_within(surfaces[line.patch], line.line, tolerance); });
}

std::vector<GC::Nearly_coincident_edges>
Model_surfaces::nearly_coincident_edges(const GC::Model_continuity<Exact>& model,
                                        const GC::Edge_tolerance& tolerance) const {
  Progress progress("boundary edges");
  const auto part = [&](std::size_t n) { return double(n) / double(model.summary.boundary); };
  return visit_exact(surfaces_, [&](const auto& surfaces) {
    return GC::nearly_coincident_edges(surfaces, model, tolerance,
                                       [&](std::size_t n) { progress.step(n, [&] { return part(n); }); });
  });
}

void Model_surfaces::write_certificate(std::ostream& os, const std::vector<std::string>& files,
                                       const GC::Model_continuity<Exact>& model) const {
  visit_exact(surfaces_, [&](const auto& surfaces) { write_model_certificate(os, files, surfaces, model); });
}

std::vector<std::array<double, 3>> Model_surfaces::net(std::size_t surface) const {
  return std::visit(
      [&](const auto& surfaces) {
        typedef typename std::decay_t<decltype(surfaces)>::value_type Surface;
        std::vector<std::array<double, 3>> points;
        const auto coordinates = [](const auto& p) { return GC::coordinates<typename Surface::Traits>(p); };
        const Surface& s = surfaces[surface];
        for (const auto& p : s) {
          const auto x = coordinates(p), first = coordinates(*s.begin());
          points.emplace_back();
          for (int c = 0; c < 3; ++c) points.back()[c] = CGAL::to_double(typename Surface::FT(x[c] - first[c]));
        }
        return points;
      },
      surfaces_);
}

std::array<std::size_t, 2> Model_surfaces::spans(std::size_t surface) const {
  return std::visit(
      [&](const auto& surfaces) {
        const auto& s = surfaces[surface];
        return std::array<std::size_t, 2>{s.knots_u().spans().size(), s.knots_v().spans().size()};
      },
      surfaces_);
}

std::vector<double> Model_surfaces::grid(std::size_t surface, int m, int n) const {
  return std::visit(
      [&](const auto& surfaces) {
        const auto& s = surfaces[surface];
        std::vector<double> points;
        for (int j = 0; j <= n; ++j)
          for (int i = 0; i <= m; ++i) append(points, s, parameter(s.domain_u(), i, m), parameter(s.domain_v(), j, n));
        return points;
      },
      surfaces_);
}

std::vector<double> Model_surfaces::edge(std::size_t surface, GC::Patch_edge edge) const {
  return std::visit(
      [&](const auto& surfaces) {
        const auto& s = surfaces[surface];
        const bool along_u = runs_along_u(edge);
        const auto across = along_u ? s.domain_v() : s.domain_u();
        return line(s, !along_u, at_upper_end(edge) ? across.second : across.first);
      },
      surfaces_);
}

std::vector<double> Model_surfaces::knot_line(const Line& knot_line) const {
  return std::visit(
      [&](const auto& surfaces) {
        typedef typename std::decay_t<decltype(surfaces)>::value_type::FT FT;
        const FT knot = FT(CGAL::to_double(knot_line.line.knot)); // as it is drawn
        return line(surfaces[knot_line.patch], knot_line.line.constant_u, knot);
      },
      surfaces_);
}
