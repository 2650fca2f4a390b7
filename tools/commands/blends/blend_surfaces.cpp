// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/blend_surfaces.h"
#include "commands/blends/blend_strategies.h"
#include "commands/blends/two_surfaces.h"
#include "commands/models/exact_models.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/representable_blend_surfaces.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

typedef GC::Bspline_surface<GC::Traits_3<CGAL::Simple_cartesian<double>>> Double_surface;

Double_surface read_double_surface(const std::string& file) {
  Input input(file);
  return only_surface(file, GC::read_g2_bspline_surfaces<Double_surface::Traits>(input, input_name(file)));
}

// The decision about the edge of a given surface.
struct Edge_report {
  std::string file, edge, order; // in words
  bool has_order;                // that was asked for
};

template <class Surface>
Edge_report decided(int order, const std::string& file, const Surface& given, GC::Patch_edge edge, const Surface& blend,
                    GC::Patch_edge edge_of_blend) {
  Edge_report report{input_name(file), to_string(edge), "G3", true};
  if (order == 3 && GC::is_g3_edge(given, edge, blend, edge_of_blend)) return report;
  const GC::Spline_edge_continuity<Exact> verdict = GC::edge_continuity(given, edge, blend, edge_of_blend);
  std::ostringstream words;
  words << verdict;
  report.order = words.str();
  report.has_order = order == 2 && verdict.g_order >= 2;
  return report;
}
std::ostream& operator<<(std::ostream& os, const Edge_report& edge) {
  return os << edge.file << ", edge " << edge.edge << ": " << edge.order;
}

// The derivatives of the parameter across an edge, by their names.
template <class FT> std::vector<std::pair<const char*, FT>> constants(const GC::Edge_reparametrisation<FT>& shape) {
  return {{"beta", shape.beta[0]}, {"delta", shape.delta[0]}};
}
template <class Reparametrisation> auto constants(const GC::Septic_edge_reparametrisation<Reparametrisation>& shape) {
  auto named = constants(static_cast<const GC::Edge_reparametrisation<Exact>&>(shape));
  named.emplace_back("delta3", shape.delta3[0]);
  return named;
}

Exit_code report_order(std::ostream& report, int order, bool has_order) {
  report << (has_order ? "" : "not ") << 'G' << order << " along both edges"
         << (has_order ? ", proved exactly\n" : "\n");
  return has_order ? requirement_met : requirement_not_met;
}

// Where a blend may be folded. The search for folds may take long, and what it finds is no more
// than a warning: it never refuses the blend.
struct Fold {
  bool is_decided = true;
  std::optional<GC::Parameter_rectangle<double>> place;

  template <class Surface> explicit Fold(const Surface& s) {
    try {
      if (const auto fold = possible_fold(s)) {
        const auto rounded = [](const auto& range) {
          return std::make_pair(CGAL::to_double(range.first), CGAL::to_double(range.second));
        };
        place = {rounded(fold->u), rounded(fold->v)};
      }
    } catch (const GC::Error& e) {
      if (e.code() != GC::Error_code::work_limit) throw;
      is_decided = false;
    }
  }
  void warn(std::ostream& report) const {
    if (!is_decided)
      report << "warning: it may be folded, which was not decided within --max-work\n";
    else if (place)
      report << "warning: it may be folded near (" << place->u.first << ", " << place->v.first
             << "), where its normal may vanish\n";
  }
  void write_json(std::ostream& os) const {
    const auto range = [&](const std::pair<double, double>& x) {
      GC::write_number(os << '[', x.first);
      GC::write_number(os << ',', x.second);
      os << ']';
    };
    if (!is_decided) {
      os << "\"undecided\"";
    } else if (!place) {
      os << "null";
    } else {
      os << "{\"u\":";
      range(place->u);
      os << ",\"v\":";
      range(place->v);
      os << '}';
    }
  }
};

// Returns the same surface over fractions.
Exact_surface exact_surface(const Double_surface& s) {
  typedef CGAL::Exact_rational FT;
  const auto exact_knots = [](const GC::Knot_vector<double>& knots) {
    return GC::Knot_vector<FT>(knots.degree(), std::vector<FT>(knots.begin(), knots.end()));
  };
  std::vector<std::vector<Exact_surface::Point>> net(static_cast<std::size_t>(s.number_of_points_u()));
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      const Double_surface::Point& p = s.control_point(i, j);
      net[i].emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    }
  return {net, exact_knots(s.knots_u()), exact_knots(s.knots_v())};
}

// Returns the strategies of a table without those for F3, which are none for surfaces.
template <class Table> auto without_f3(const Table& strategies) {
  const auto chosen = [](const auto& s) {
    typedef typename std::decay_t<decltype(s)>::Strategy Strategy;
    if constexpr (std::is_same_v<Strategy, GC::Sequential_f3> || std::is_same_v<Strategy, GC::Fair_f3>)
      return std::make_tuple();
    else
      return std::make_tuple(s);
  };
  return std::apply([&](const auto&... s) { return std::tuple_cat(chosen(s)...); }, strategies);
}

// Those of degree 5.
const auto surface_strategies = std::tuple_cat(quintic_strategies, std::make_tuple(named<GC::Fairest>("fairest")));

// Returns the name of the strategy of --strategy, one of a table or another name.
template <class Table>
std::string strategy_name(const Command_line& line, const Table& strategies, const std::string& by_default,
                          const Arguments& others = {}) {
  Arguments names = names_of(strategies);
  names.insert(names.end(), others.begin(), others.end());
  const std::string name = line.has("strategy") ? line.choice("strategy", names) : by_default;
  if (line.files().size() != 2) throw std::invalid_argument("blend --surfaces: two files are needed; see --help");
  return name;
}

// The direction of --direction, or the nearer one.
template <class A, class B>
GC::Edge_direction direction_of(const Command_line& line, const A& a, GC::Patch_edge edge_a, const B& b,
                                GC::Patch_edge edge_b) {
  if (!line.has("direction")) return nearer_direction(a, edge_a, b, edge_b);
  return line.choice("direction", {"same", "opposite"}) == "same" ? GC::Edge_direction::same
                                                                  : GC::Edge_direction::opposite;
}

// Blends with control points that are doubles. The given surfaces are written, too, as they now
// are.
Exit_code blend_representably(const Command_line& line) {
  const std::string name = strategy_name(line, quintic_strategies, "energy3");
  const Arguments files = line.files();
  const Double_surface a = read_double_surface(files[0]), b = read_double_surface(files[1]);
  const auto [edge_a, edge_b] = given_edges(line);
  const GC::Edge_direction direction = direction_of(line, a, edge_a, b, edge_b);
  std::optional<GC::Representable_blend_surface<Double_surface>> r;
  with_named_strategy(quintic_strategies, name, [&, edge_a = edge_a, edge_b = edge_b](const auto& strategy) {
    r = GC::representable_blend(a, edge_a, b, edge_b, strategy, direction);
  });
  const Exact_surface first = exact_surface(r->first), s = exact_surface(r->blend), second = exact_surface(r->second);
  std::ostream& report = report_stream(line);
  const Edge_report at_a = decided(2, files[0], first, edge_a, s, GC::Patch_edge::v0),
                    at_b = decided(2, files[1], second, edge_b, s, GC::Patch_edge::v1);
  report << at_a << ", beta = " << r->start_join.beta << '\n' << at_b << ", beta = " << r->end_join.beta << '\n';
  const double moved = (std::max)(r->start_join.moved, r->end_join.moved);
  if (moved == 0)
    report << "nothing was moved\n";
  else
    report << "coordinates were moved by at most " << moved << '\n';
  const Exit_code code = report_order(report, 2, at_a.has_order && at_b.has_order);
  Fold(r->blend).warn(report); // doubles are cut faster than fractions
  if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      for (const Exact_surface* x : {&first, &s, &second}) GC::write_g2(os, *x);
    });
  return code;
}

// The lengths of the tangents are given, and a strategy chooses all else.
template <class Strategy> struct With_shape_parameters {
  Strategy strategy;
  GC::Shape_parameters<double> shape;
};
template <class Strategy> struct Given_shape {
  const Strategy& strategy;
  GC::Shape_parameters<double> shape;

  With_shape_parameters<Strategy> choose(const GC::Coordinate_jet<double, 0>&,
                                         const GC::Coordinate_jet<double, 0>&) const {
    return {strategy, shape};
  }
  // for the order of the strategy
  template <class Ends, class = std::enable_if_t<std::is_invocable_v<const Strategy&, const Ends&>>>
  auto operator()(const Ends& ends) const {
    return strategy(ends);
  }
};

// The constants of --beta, --eta and --delta. With --strategy free all are given: 1, 1 and 0, 0
// unless the options say otherwise.
struct Given_constants {
  std::optional<Exact> beta, eta;
  std::vector<Exact> delta;

  explicit Given_constants(const Command_line& line) {
    if (line.text("strategy") == "free") {
      beta = eta = Exact(1);
      delta = {Exact(0), Exact(0)};
    }
    if (line.has("beta")) beta = line.number("beta", Exact());
    if (line.has("eta")) eta = line.number("eta", Exact());
    if (!line.has("delta")) return;
    delta = line.numbers<Exact>("delta");
    if (delta.size() != 2) throw std::invalid_argument("--delta: two numbers are needed, at A and at B");
  }
  template <class Shape> void set(Shape& shape) const {
    if (beta) shape.start.beta = {*beta};
    if (eta) shape.end.beta = {*eta};
    if (delta.empty()) return;
    shape.start.delta = {delta[0]};
    shape.end.delta = {delta[1]};
  }
};

// Strategies for given numbers delta, of degree 5 and 7.
struct Given_quintic_delta {
  double start, end; // divided by beta
  explicit Given_quintic_delta(const Given_constants& given)
      : start(CGAL::to_double(Exact(given.delta[0] / *given.beta))),
        end(CGAL::to_double(Exact(given.delta[1] / *given.eta))) {}
  GC::Quintic_parameters<double> operator()(const GC::Quintic_ends<double, 0>& e) const {
    return {(start + e.tangential1) / 20, (end + e.tangential2) / 20};
  }
};
struct Given_septic_delta {
  double start, end;
  explicit Given_septic_delta(const Given_constants& given)
      : start(CGAL::to_double(given.delta[0])), end(CGAL::to_double(given.delta[1])) {}
  GC::Septic_parameters<double> operator()(const GC::Septic_ends<double, 0>&) const {
    GC::Septic_parameters<double> p;
    p.start.beta2 = start;
    p.end.beta2 = end;
    return p;
  }
};

// Names the files of surfaces whose blend has no denominator that is positive.
template <class Function> auto named_pair(const Arguments& files, const Function& blend) {
  try {
    return blend();
  } catch (const GC::Error& e) {
    if (e.code() != GC::Error_code::zero_weight) throw;
    const std::string text = e.what(), code = "zero_weight: ";
    throw GC::Error(e.code(), input_name(files[0]) + " and " + input_name(files[1]) + ": " + text.substr(code.size()));
  }
}

void write_json(std::ostream& os, const Edge_report& edge, const std::vector<std::pair<const char*, Exact>>& shape) {
  GC::write_json(os << "{\"file\":", edge.file);
  GC::write_json(os << ",\"edge\":", edge.edge);
  GC::write_json(os << ",\"order\":", edge.order);
  os << ",\"proved\":" << (edge.has_order ? "true" : "false");
  for (const auto& [name, value] : shape) {
    GC::write_number(os << ",\"" << name << "\":\"", value);
    os << '"';
  }
  os << '}';
}

// Blends two surfaces with a shape that choose_shape(a, edge_a, b, edge_b, direction) returns.
template <class Surface, class Choose_shape>
Exit_code blend_with_shape(const Command_line& line, const std::string& strategy, const Surface& a, const Surface& b,
                           const Choose_shape& choose_shape) {
  const Arguments files = line.files();
  const auto [edge_a, edge_b] = given_edges(line);
  const GC::Edge_direction direction = direction_of(line, a, edge_a, b, edge_b);
  auto shape = choose_shape(a, edge_a, b, edge_b, direction);
  const Given_constants given(line);
  given.set(shape);
  const Surface s = named_pair(
      files, [&, edge_a = edge_a, edge_b = edge_b] { return GC::blend(a, edge_a, b, edge_b, shape, direction); });
  const int order = line.integer("order");
  const Edge_report at_a = decided(order, files[0], a, edge_a, s, GC::Patch_edge::v0),
                    at_b = decided(order, files[1], b, edge_b, s, GC::Patch_edge::v1);
  const bool is_proved = at_a.has_order && at_b.has_order;
  const auto start = constants(shape.start), end = constants(shape.end);
  const Fold fold(s);
  std::ostream& report = report_stream(line);
  if (line.has("json")) {
    GC::write_json(report << "{\"strategy\":", strategy);
    report << ",\"order\":" << order << ",\"direction\":\""
           << (direction == GC::Edge_direction::same ? "same" : "opposite") << "\",\"edges\":[\n";
    write_json(report, at_a, start);
    write_json(report << ",\n", at_b, end);
    report << "\n],\"proved\":" << (is_proved ? "true" : "false") << ",\"fold\":";
    fold.write_json(report);
    report << ",\"fairness\":";
    if (const double e = mean_fairness(s); std::isfinite(e))
      GC::write_number(report, e);
    else
      report << "null";
    report << "}\n";
  } else {
    for (const auto& [edge, shape_at] : {std::tie(at_a, start), std::tie(at_b, end)}) {
      report << edge;
      for (const auto& [name, value] : shape_at) report << ", " << name << " = " << value;
      report << '\n';
    }
    report_order(report, order, is_proved);
    fold.warn(report);
  }
  if (line.has("output")) write_shapes(line, [&](std::ostream& os) { GC::write_g2(os, s); });
  return is_proved ? requirement_met : requirement_not_met;
}

// Blends by the strategy of --strategy, one of a table, or by `Free` with the given constants.
template <class Free, class Table>
Exit_code blend_by_name(const Command_line& line, const Table& strategies, const std::string& by_default) {
  const std::string name = strategy_name(line, strategies, by_default, {"free"});
  const Given_constants given(line);
  const bool is_free = name == "free", has_beta = given.beta || given.eta;
  if (!is_free) line.refuse({"delta"}, "only with --strategy free, which takes --beta and --eta, too");
  if (name == "fairest" && has_beta)
    throw std::invalid_argument(
        "--beta, --eta: fairest chooses them; name another --strategy, such as energy3 or free");
  for (const char* option : {"beta", "eta"})
    if (line.has(option) && !(Exact(0) < line.number(option, Exact())))
      throw std::invalid_argument("--" + std::string(option) + ": it must be positive");
  const auto choose_shape = [&](const auto& a, GC::Patch_edge edge_a, const auto& b, GC::Patch_edge edge_b,
                                GC::Edge_direction direction) {
    typedef std::decay_t<decltype(a)> Surface;
    // All strategies of a table choose shapes of one type.
    GC::Chosen_surface_shape<Surface, Surface, Free> shape;
    const auto choose = [&](const auto& strategy) {
      shape = automatic_surface_shape(a, edge_a, b, edge_b, strategy, direction);
    };
    const auto choose_with_shape = [&](const auto& strategy) {
      typedef std::decay_t<decltype(strategy)> Strategy;
      choose(strategy);
      if constexpr (!std::is_same_v<Strategy, GC::Fairest>)
        choose(Given_shape<Strategy>{strategy,
                                     {CGAL::to_double(given.beta ? *given.beta : shape.start.beta[0]),
                                      CGAL::to_double(given.eta ? *given.eta : shape.end.beta[0])}});
    };
    if (is_free)
      choose_with_shape(Free(given));
    else if (has_beta)
      with_named_strategy(strategies, name, choose_with_shape);
    else
      with_named_strategy(strategies, name, choose);
    return shape;
  };
  return read_both_surfaces(line.files()).visit([&](const auto& surfaces) {
    return blend_with_shape(line, name, surfaces[0], surfaces[1], choose_shape);
  });
}

} // namespace

Exit_code blend_surfaces(const Command_line& line) {
  const GC::Work_scope each(line.work_limit());
  const int order = line.integer("order", 2, 3);
  if (line.has("representable")) {
    if (order == 3) throw std::invalid_argument("--representable: blends of order 2 only");
    line.refuse({"beta", "eta", "delta", "json"}, "not with --surfaces --representable");
    return blend_representably(line);
  }
  return order == 2 ? blend_by_name<Given_quintic_delta>(line, surface_strategies, "fairest")
                    : blend_by_name<Given_septic_delta>(line, without_f3(septic_strategies), "energy4_g3");
}
