// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/blend_report.h"

#include "commands/chains/decided_join.h"
#include "files/terminal.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <vector>

namespace {

// Returns whether what costs more than the limit is left out.
bool is_left_out(const GC::Error& e, bool limited) { return !limited && e.code() == GC::Error_code::work_limit; }

// Empty where there are none, and where they are left out.
std::optional<GC::Curvature_extrema> extrema(const Exact_curve& curve, bool limited) {
  try {
    return GC::curvature_extrema(curve);
  } catch (const GC::Error& e) {
    if (e.code() != GC::Error_code::zero_tangent && !is_left_out(e, limited)) throw;
    return std::nullopt;
  }
}

std::string six_digits(double x) { return std::isinf(x) ? "infinite" : rounded(x, 6); }

// The energies of a blend, as they stand in the table.
std::array<std::string, 2> energies(const Blend_report& r, int order, bool limited) {
  std::array<std::string, 2> result{"-", "-"};
  try {
    const GC::Work_scope scope(GC::Work_scope::limit_of_each(), "the energies of a blend");
    for (int k = 0; k < 2; ++k) result[k] = six_digits(CGAL::to_double(r.curve.polynomial()->energy(order + k)));
  } catch (const GC::Error& e) {
    if (!is_left_out(e, limited)) throw;
  }
  return result;
}

// Why a curve is hardly what is wanted, however smooth its joins are: it goes far away from its
// chord, or turns back. Empty otherwise. Samples are enough for a warning.
std::string warning_of(const Exact_curve& curve) {
  constexpr int samples = 128;
  constexpr double far = 4; // chords
  const int n = curve.degree(), dimension = curve.dimension();
  typedef std::vector<double> Vector;
  std::vector<Vector> points;
  for (int j = 0; j <= n; ++j) {
    points.emplace_back();
    for (int i = 0; i < dimension; ++i) points.back().push_back(CGAL::to_double(curve.coordinates(j)[i]));
  }
  const auto difference = [](Vector a, const Vector& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
  };
  const auto product = [](const Vector& a, const Vector& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
  };
  const Vector chord = difference(points.back(), points.front());
  const double length = std::sqrt(product(chord, chord));
  if (!(length > 0)) return ""; // closed
  const bool ends_forwards =
      product(difference(points[1], points[0]), chord) >= 0 &&
      product(difference(points[static_cast<std::size_t>(n)], points[static_cast<std::size_t>(n) - 1]), chord) >= 0;
  double farthest = 0;
  bool turns_back = false;
  Vector last = points[0];
  for (int k = 1; k <= samples; ++k) {
    std::vector<Vector> row = points; // de Casteljau
    for (int r = n; r > 0; --r)
      for (std::size_t j = 0; j < static_cast<std::size_t>(r); ++j)
        for (std::size_t i = 0; i < row[j].size(); ++i) row[j][i] += (row[j + 1][i] - row[j][i]) * k / samples;
    const auto distance = [&](const Vector& p) {
      const Vector d = difference(row[0], p);
      return std::sqrt(product(d, d)) / length;
    };
    farthest = (std::max)(farthest, (std::min)(distance(points.front()), distance(points.back())));
    turns_back = turns_back || product(difference(row[0], last), chord) < 0;
    last = row[0];
  }
  if (!(farthest <= far)) return "goes " + rounded(farthest, 2) + " times the length of its chord away from its ends";
  return turns_back && ends_forwards ? "turns back" : "";
}

// The widths of the columns of a table, of which the first three are words.
typedef std::array<std::string, 10> Row;
std::array<std::size_t, 10> widths_of(const std::vector<Row>& rows) {
  std::array<std::size_t, 10> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = (std::max)(widths[i], row[i].size());
  return widths;
}

// Writes a row and what is said behind it, in lines of its own where it does not fit into so many
// columns as are available.
void write_row(std::ostream& os, const Row& columns, const std::array<std::size_t, 10>& widths, const std::string& rest,
               std::size_t available) {
  std::ostringstream line;
  for (std::size_t i = 0; i < columns.size(); ++i)
    line << (i == 0 ? "" : " ") << (i < 3 ? std::left : std::right) << std::setw(static_cast<int>(widths[i]))
         << columns[i];
  const bool fits = line.str().size() + 2 + rest.size() <= available;
  os << within_columns(line.str() + (rest.empty() ? "" : fits ? "  " : "\n    ") + rest + '\n', available);
}

// A number that is written without loss; null if it is infinite.
void write_value(std::ostream& os, double x) {
  if (std::isinf(x))
    os << "null";
  else
    GC::write_number(os, x);
}

void write_members(std::ostream& os, const GC::Curvature_at& x) {
  GC::write_json(os << "\"parameter\":", x.parameter);
  GC::write_json(os << ",\"curvature\":", x.curvature);
}

void write_members(std::ostream& os, const std::optional<GC::Curvature_extrema>& curvature) {
  if (!curvature) {
    os << R"("curvature_extrema":null,"inflections":null,"least_curvature":null,"greatest_curvature":null,)"
       << R"("largest_curvature":null)";
    return;
  }
  const char* separator = "";
  os << "\"curvature_extrema\":[";
  for (const GC::Curvature_extremum& x : curvature->extrema) {
    write_members(os << separator << '{', x);
    os << ",\"maximum\":" << (x.maximum ? "true" : "false") << '}';
    separator = ",";
  }
  separator = "";
  os << "],\"inflections\":[";
  for (const GC::Enclosure& x : curvature->inflections) {
    GC::write_json(os << separator, x);
    separator = ",";
  }
  write_members(os << "],\"least_curvature\":{", curvature->least);
  write_members(os << "},\"greatest_curvature\":{", curvature->greatest);
  GC::write_json(os << "},\"largest_curvature\":", curvature->largest());
}

void write_members(std::ostream& os, const GC::Fair_report& search) {
  os << "\"iterations\":" << search.iterations << ",\"fairness_before\":";
  write_value(os, search.automatic_fairness);
  write_value(os << ",\"fairness_after\":", search.fairness);
  os << ",\"converged\":" << (search.converged ? "true" : "false");
}

} // namespace

Blend_report::Blend_report(const std::string& strategy, const Exact_curve& gamma, const Exact_curve& phi,
                           const Exact_curve& psi, const Exact& beta, const Exact& eta, const std::string& parameters,
                           const std::optional<GC::Fair_report>& search, bool limited)
    : strategy(strategy), curve(gamma), start(decided_join(phi, gamma, 3)), end(decided_join(gamma, psi, 3)),
      beta(beta), eta(eta), parameters(parameters), fairness(GC::fairness(gamma)),
      bending_energy(GC::bending_energy(gamma)), curvature(extrema(gamma, limited)), search(search),
      warning(warning_of(gamma)) {}

std::size_t Blend_report::broken_joins(int order) const {
  const bool smooth = order == 2 || curve.dimension() < 3;
  const auto is_broken = [&](const Join& join) { return smooth ? join.g_order < 2 : join.f_order < 3; };
  return std::size_t(is_broken(start)) + std::size_t(is_broken(end));
}

void write_table(std::ostream& os, const std::vector<Blend_report>& reports, int order, bool limited) {
  std::vector<Row> rows = {{"strategy", "start", "end", order == 2 ? "|x''|^2" : "|x'''|^2",
                            order == 2 ? "|x'''|^2" : "|x''''|^2", "fairness", "bending", "extrema", "inflections",
                            "curvature"}};
  std::vector<std::string> rest = {"parameters"};
  std::size_t broken = 0;
  for (const Blend_report& r : reports) {
    broken += r.broken_joins(order);
    const std::optional<GC::Curvature_extrema>& c = r.curvature;
    const std::array<std::string, 2> energy = energies(r, order, limited);
    rows.push_back({r.strategy, orders(r.start), orders(r.end), energy[0], energy[1], six_digits(r.fairness),
                    six_digits(r.bending_energy), c ? std::to_string(c->extrema.size()) : "-",
                    c ? std::to_string(c->inflections.size()) : "-", c ? six_digits(c->largest().upper) : "-"});
    rest.push_back(r.parameters + (r.warning.empty() ? "" : "  warning: " + r.warning));
  }
  const std::array<std::size_t, 10> widths = widths_of(rows);
  const std::size_t available = output_columns();
  for (std::size_t i = 0; i < rows.size(); ++i) write_row(os, rows[i], widths, rest[i], available);
  os << (broken == 0 ? "both joins of every blend are proved in exact arithmetic"
                     : "decided in exact arithmetic: " + broken_joins(broken, 2 * reports.size()))
     << '\n';
}

void write_choice(std::ostream& os, const std::vector<Blend_report>& reports, const Curvature_bound& bound,
                  const std::string& taken) {
  std::string names;
  const Blend_report* least = nullptr;
  const auto largest = [](const Blend_report& r) { return r.curvature->largest().upper; };
  for (const Blend_report& r : reports) {
    if (*r.is_within) names += (names.empty() ? "" : ", ") + r.strategy;
    if (r.curvature && (least == nullptr || largest(r) < largest(*least))) least = &r;
  }
  if (!names.empty())
    os << bound.words << ", proved exactly: " << names
       << (taken.empty() ? "" : "; the fairest, " + taken + ", is taken") << '\n';
  else if (least == nullptr)
    os << "none is " << bound.words << "; every one has a cusp\n";
  else
    os << "none is " << bound.words << "; the least curvature is " << six_digits(largest(*least)) << ", the radius "
       << six_digits(1 / largest(*least)) << ", of " << least->strategy << '\n';
}

void write_json(std::ostream& os, const std::vector<Blend_report>& reports, int order,
                const std::optional<Curvature_bound>& bound) {
  os << "{\"blends\":[";
  const char* separator = "\n";
  for (const Blend_report& r : reports) {
    GC::write_json(os << separator << "{\"strategy\":", r.strategy);
    GC::write_number(os << ",\"beta\":\"", r.beta);
    GC::write_number(os << "\",\"eta\":\"", r.eta);
    GC::write_json(os << "\",\"start_join\":", r.start, 0, 1);
    GC::write_json(os << ",\"end_join\":", r.end, 1, 2);
    os << ",\"proved\":" << (r.is_proved(order) ? "true" : "false") << ",\"warning\":";
    if (r.warning.empty())
      os << "null";
    else
      GC::write_json(os, r.warning);
    os << ",\"fairness\":";
    write_value(os, r.fairness);
    write_value(os << ",\"bending_energy\":", r.bending_energy);
    write_members(os << ',', r.curvature);
    if (r.search) write_members(os << ',', *r.search);
    if (r.is_within) os << ",\"max_curvature_met\":" << (*r.is_within ? "true" : "false");
    os << '}';
    separator = ",\n";
  }
  os << "\n]";
  if (bound)
    os << ",\n"
       << json_member(*bound) << ",\"max_curvature_met\":"
       << (std::any_of(reports.begin(), reports.end(), [](const Blend_report& r) { return *r.is_within; }) ? "true"
                                                                                                           : "false");
  os << "}\n";
}
