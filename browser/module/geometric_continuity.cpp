// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// geometric_continuity.mjs calls these functions on curves and patches.

#include "Request.h"
#include "array_joins.h"
#include "call.h"
#include "commands/blends/named_strategies.h"
#include "commands/did_you_mean.h"
#include "formats/svg/read_svg_path.h"

#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/json.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

typedef GC::Traits_2<CGAL::Simple_cartesian<Exact>> Plane_traits;

// The first or the last segment of path data, where curves meet: no arc.
Module_curve Request::segment(bool is_last) {
  const std::string name(word());
  std::string data(word());
  std::replace(data.begin(), data.end(), '~', ' ');
  const std::vector<GC::Svg_subpath<Plane_traits>> paths = GC::read_svg_path<Plane_traits>(data, name);
  const auto drawn = [](const GC::Svg_subpath<Plane_traits>& path) { return !path.segments.empty(); };
  const auto first = std::find_if(paths.begin(), paths.end(), drawn);
  const auto last = std::find_if(paths.rbegin(), paths.rend(), drawn);
  if (first == paths.end()) throw GC::Error(GC::Error_code::wrong_number_of_points, name + ": the path draws nothing");
  const GC::Bezier_curve<Plane_traits>* const curve =
      is_last ? last->segments.back().bezier() : first->segments.front().bezier();
  if (curve == nullptr)
    throw GC::Error(GC::Error_code::malformed_input,
                    name + ": the " + (is_last ? "last" : "first") +
                        " segment is an arc (A) and no Bezier curve; verifySvg() decides its joins");
  std::vector<Module_traits::Point> points;
  for (const auto& p : *curve) {
    const std::vector<Exact> x{p.x(), p.y()};
    points.emplace_back(2, x.begin(), x.end());
  }
  return Module_curve(points, std::vector<Exact>(points.size(), Exact(1)));
}

namespace {

void write_exact(std::ostream& os, const Exact& x) { GC::write_number(os << '"', x), os << '"'; }

// The control points as exact numbers and as the doubles that are nearest to them.
void write_curve(std::ostream& os, const Module_curve& curve) {
  const bool rational = !curve.is_polynomial();
  for (const bool exact : {true, false}) {
    os << (exact ? "{\"control_points\":[" : ",\"points\":[");
    for (int j = 0; j <= curve.degree(); ++j) {
      const GC::Coordinates<Module_traits> x = curve.coordinates(j);
      for (int i = 0; i < x.dimension(); ++i) {
        os << (i > 0 ? "," : j > 0 ? ",[" : "[");
        if (exact)
          write_exact(os, x[i]);
        else
          GC::write_number(os, CGAL::to_double(x[i]));
      }
      os << ']';
    }
    os << ']';
  }
  if (rational) {
    os << ",\"weights\":[";
    for (int j = 0; j <= curve.degree(); ++j) write_exact(os << (j > 0 ? "," : ""), curve.weight(j));
    os << ']';
  }
  write_exact(os << ",\"domain\":[", curve.domain().first);
  write_exact(os << ',', curve.domain().second);
  os << "]}";
}

void write_join(std::ostream& os, const GC::Join_continuity<Exact>& join) { GC::write_json(os, join); }

void continuity(Request& request, std::ostream& os) {
  const int max_order = request.count();
  const Module_curve left = request.curve(), right = request.curve();
  write_join(os, GC::continuity(left, right, max_order));
}

void deviation(Request& request, std::ostream& os) {
  const Module_curve left = request.curve(), right = request.curve();
  os << '{';
  GC::write_json_members(os, GC::deviation(left, right));
  os << '}';
}

GC::Bezier_curve<Plane_traits> plane_curve(const Module_curve& curve) {
  if (curve.dimension() != 2)
    throw GC::Error(GC::Error_code::dimension_mismatch, "joinGrade: curves in the plane are expected");
  if (!curve.is_polynomial())
    throw GC::Error(GC::Error_code::malformed_input, "joinGrade: curves without weights are expected");
  std::vector<Plane_traits::Point> points;
  for (int j = 0; j <= curve.degree(); ++j) points.emplace_back(curve.coordinates(j)[0], curve.coordinates(j)[1]);
  return GC::Bezier_curve<Plane_traits>(points.begin(), points.end(), curve.domain().first, curve.domain().second);
}

void visual_class(Request& request, std::ostream& os) {
  const GC::Corner_threshold bound(request.exact());
  const auto left = plane_curve(request.curve()), right = plane_curve(request.curve());
  const std::optional<GC::Visual_class> grade = GC::visual_class(left, right, bound);
  os << "{\"grade\":";
  if (grade)
    os << '"' << *grade << '"';
  else
    os << "null";
  const std::optional<GC::Kink_size> size = GC::kink_size(left, right);
  std::optional<GC::Enclosure> degrees, offset;
  if (size) {
    degrees = GC::in_degrees(size->angle);
    offset = size->handle_offset;
  }
  GC::write_json(os << ",\"angle_degrees\":", degrees);
  GC::write_json(os << ",\"handle_offset\":", offset);
  os << '}';
}

// The user gives these options of a blend besides the strategy.
struct Blend_options {
  std::optional<Exact> beta, eta;
  std::vector<Exact> scalars; // s1, s2, or beta2, mu, beta3 of both ends

  explicit Blend_options(Request& request) : beta(request.optional_exact()), eta(request.optional_exact()) {
    for (int n = request.count(); n > 0; --n) scalars.push_back(request.exact());
  }
  void check(std::size_t n, const char* what) const {
    if (scalars.size() != n)
      throw GC::Error(GC::Error_code::malformed_input,
                      std::string("blend: ") + (n == 0 ? "this strategy takes no parameters" : what));
  }
};

// Calls f(strategy) with the strategy of a name, one of those of
// `geometric_continuity blend --strategy`.
template <class Function> void with_strategy(std::string_view name, const Blend_options& options, Function f) {
  const std::vector<Exact>& x = options.scalars;
  if (name == "free") {
    options.check(2, "the strategy \"free\" needs the parameters s1 and s2");
    return f(GC::Given_parameters<Exact>{x[0], x[1]});
  }
  if (name == "free3") {
    options.check(6, "the strategy \"free3\" needs the parameters start and end, three numbers beta2, mu, beta3 each");
    return f(GC::Given_end_parameters<Exact>{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}});
  }
  options.check(0, "");
  if (with_named_strategy(quintic_strategies, name, f) || with_named_strategy(septic_strategies, name, f)) return;
  std::vector<std::string> names = names_of(quintic_strategies);
  for (const std::string& septic : names_of(septic_strategies)) names.push_back(septic);
  names.insert(names.end(), {"free", "free3"});
  std::string message = "there is no strategy \"" + std::string(name) + '"' + did_you_mean(std::string(name), names);
  message += message.back() == '?' ? " There are" : "; there are";
  for (const std::string& known : names) message += (known == names.front() ? " " : ", ") + known;
  throw GC::Error(GC::Error_code::malformed_input, "blend: " + message);
}

void write_finite(std::ostream& os, double x) {
  if (std::isfinite(x))
    GC::write_number(os, x);
  else
    os << "null";
}

void write_parameters(std::ostream& os, const GC::Quintic_parameters<Exact>& p) {
  write_exact(os << "{\"s1\":", p.s1);
  write_exact(os << ",\"s2\":", p.s2);
  os << '}';
}
void write_parameters(std::ostream& os, const GC::Septic_parameters<Exact>& p) {
  const char* name = "{\"start\":";
  for (const GC::Septic_end_parameters<Exact>* end : {&p.start, &p.end}) {
    write_exact(os << name << "{\"beta2\":", end->beta2);
    write_exact(os << ",\"mu\":", end->mu);
    write_exact(os << ",\"beta3\":", end->beta3);
    os << '}';
    name = ",\"end\":";
  }
  os << '}';
}

template <class Blend> void write_report(std::ostream&, const Blend&) {}
template <class Blend, class Report> void write_report(std::ostream& os, const GC::Shaped_blend<Blend, Report>& blend) {
  os << ",\"report\":{\"iterations\":" << blend.report.iterations;
  write_finite(os << ",\"automatic_fairness\":", blend.report.automatic_fairness);
  write_finite(os << ",\"fairness\":", blend.report.fairness);
  os << ",\"converged\":" << (blend.report.converged ? "true" : "false") << '}';
}

template <class Blend>
void write_blend(std::ostream& os, const Module_curve& phi, const Blend& gamma, const Module_curve& psi) {
  const Module_curve curve(gamma);
  write_curve(os << "\"curve\":", curve);
  write_exact(os << ",\"shape\":{\"beta\":", gamma.shape.beta);
  write_exact(os << ",\"eta\":", gamma.shape.eta);
  write_parameters(os << "},\"parameters\":", gamma.parameters);
  os << ",\"fallback_start\":" << (gamma.parameters.fallback_start ? "true" : "false")
     << ",\"fallback_end\":" << (gamma.parameters.fallback_end ? "true" : "false");
  write_join(os << ",\"start_join\":", GC::continuity(phi, curve, 3));
  write_join(os << ",\"end_join\":", GC::continuity(curve, psi, 3));
  write_finite(os << ",\"fairness\":", GC::fairness(curve));
  write_report(os, gamma);
}

void blend(Request& request, std::ostream& os) {
  const std::string name(request.word());
  const Blend_options options(request);
  const Module_curve phi = request.curve(), psi = request.curve();
  os << "{\"strategy\":";
  GC::write_json(os, name);
  os << ',';
  with_strategy(name, options, [&](const auto& strategy) {
    if (!options.beta && !options.eta) return write_blend(os, phi, GC::blend(phi, psi, strategy), psi);
    GC::Shape_parameters<Exact> shape;
    if (!options.beta || !options.eta) shape = GC::automatic_shape(phi.end_jet(1), psi.start_jet(1));
    if (options.beta) shape.beta = *options.beta;
    if (options.eta) shape.eta = *options.eta;
    write_blend(os, phi, GC::blend(phi, psi, strategy, shape), psi);
  });
  os << '}';
}

// Cubics are curves, whose joins are decided, too.
void write_blend(std::ostream& os, const Module_curve& phi, const GC::Composite_bezier_curve<Module_traits>& gamma,
                 const Module_curve& psi) {
  std::vector<Module_curve> curves;
  for (const auto& segment : gamma.segments()) curves.emplace_back(segment);
  os << "\"curves\":[";
  for (const Module_curve& c : curves) write_curve(os << (&c == &curves.front() ? "" : ","), c);
  write_join(os << "],\"start_join\":", GC::continuity(phi, curves.front(), 3));
  if (curves.size() > 1) write_join(os << ",\"inner_join\":", GC::continuity(curves[0], curves[1], 3));
  write_join(os << ",\"end_join\":", GC::continuity(curves.back(), psi, 3));
  write_finite(os << ",\"fairness\":", GC::fairness(gamma));
}

void round_corner(Request& request, std::ostream& os) {
  const std::string name(request.word());
  const Blend_options options(request);
  const double distance = request.rounded();
  const Module_curve left = request.curve(), right = request.curve();
  const auto round = [&](const auto& strategy) {
    const auto corner = GC::round_corner(left, right, distance, strategy);
    write_curve(os << "{\"left\":", corner.left);
    write_curve(os << ",\"right\":", corner.right);
    write_exact(os << ",\"left_cut\":", corner.left_cut);
    write_exact(os << ",\"right_cut\":", corner.right_cut);
    os << ",\"blend\":{\"strategy\":";
    GC::write_json(os, name);
    write_blend(os << ',', corner.left, corner.blend, corner.right);
    os << "}}";
  };
  if (name == "cubic" || name == "two_cubics")
    round(GC::Cubics{name == "cubic"});
  else
    with_strategy(name, options, round);
}

void curvature_excess(Request& request, std::ostream& os) {
  const Exact bound = request.exact();
  const std::optional<GC::Curvature_excess> excess = GC::curvature_excess(request.curve(), bound);
  if (!excess) {
    os << "null";
    return;
  }
  GC::write_json(os << "{\"parameter\":", excess->parameter);
  os << ",\"curvature\":";
  if (excess->unbounded)
    os << "null";
  else
    GC::write_json(os, excess->curvature);
  os << '}';
}

void write_edge(std::ostream& os, const GC::Edge_continuity<Exact>& e) {
  os << "\"g_order\":" << e.g_order << ",\"defect\":\"" << e.defect << "\",\"side\":\"" << e.side
     << "\",\"reversed\":" << (e.reversed ? "true" : "false") << ",\"coplanar\":" << (e.coplanar ? "true" : "false")
     << ",\"collapsed\":" << (e.collapsed ? "true" : "false")
     << ",\"normal_vanishes\":" << (e.normal_vanishes ? "true" : "false") << ",\"largest_angle_degrees\":";
  if (e.deviation) {
    const double angle = e.deviation->largest_angle();
    GC::write_number(os, GC::in_degrees({angle, angle}).upper);
  } else
    os << "null";
}

void edge_continuity(Request& request, std::ostream& os) {
  const GC::Patch_edge edge_a = request.edge(), edge_b = request.edge();
  const Module_patch a = request.patch(), b = request.patch();
  const GC::Spline_edge_continuity<Exact> edge = GC::edge_continuity(a, edge_a, b, edge_b);
  write_edge(os << '{', edge);
  os << ",\"whole_a\":" << (edge.whole_a ? "true" : "false") << ",\"whole_b\":" << (edge.whole_b ? "true" : "false")
     << ",\"is_g3\":" << (edge.g_order >= 2 && GC::is_g3_edge(a, edge_a, b, edge_b) ? "true" : "false") << '}';
}

GC::Grid_vector grid_vector(Request& request) {
  const double x = request.rounded(), y = request.rounded(), largest = static_cast<double>(GC::max_handle_coordinate);
  for (const double c : {x, y})
    if (!(std::abs(c) <= largest) || c != std::floor(c))
      throw GC::Error(GC::Error_code::malformed_input, "alignHandles: integers of at most 2^28 are expected");
  return {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
}

void align_handles(Request& request, std::ostream& os) {
  const GC::Grid_vector left = grid_vector(request), right = grid_vector(request);
  const double move = request.rounded(), most = 0x1p60;
  if (!(move >= 0))
    throw GC::Error(GC::Error_code::unreachable_tolerance, "alignHandles: the largest move is negative");
  const std::optional<GC::Aligned_handles> aligned =
      GC::align_handles(left, right, static_cast<std::int64_t>((std::min)(std::floor(move * move), most)));
  if (!aligned)
    os << "null";
  else
    os << "{\"left\":[" << aligned->left.x << ',' << aligned->left.y << "],\"right\":[" << aligned->right.x << ','
       << aligned->right.y << "]}";
}

} // namespace

const std::vector<Module_function> module_functions = {
    {"continuity", continuity},      {"deviation", deviation},
    {"joinGrade", visual_class},     {"blend", blend},
    {"roundCorner", round_corner},   {"edgeContinuity", edge_continuity},
    {"alignHandles", align_handles}, {"curvatureExcess", curvature_excess},
};

// The joins of a chain at which an order does not hold. Returns how many there are; -1 where the
// answer is an error.
extern "C" int gc_failing_joins(const double* points, std::size_t curves, int degree, int dimension, int question,
                                int closed) {
  int n = -1;
  set_answer([&] {
    n = static_cast<int>(failing_joins(points, curves, degree, dimension, question, closed != 0).size());
    return std::string();
  });
  return n;
}
extern "C" const std::uint32_t* gc_failing() { return last_failing_joins().data(); }
