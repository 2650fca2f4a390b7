// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/curvature_bound.h"

#include "commands/chains/plane_curvature.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>

#include <algorithm>
#include <sstream>

void demand_curvature(Report_subject& subject, const Curvature_bound& bound) {
  const bool is_alone = subject.required.empty();
  subject.noun = "curve";
  subject.every = is_alone ? "every curve" : subject.every + " and every curve";
  subject.required += (is_alone ? "" : ", or ") + bound.words;
  subject.required_in_json += (is_alone ? "" : ",") + json_member(bound);
}

std::string json_member(const Curvature_bound& bound) {
  std::ostringstream os;
  GC::write_number(os << "\"max_curvature\":\"", bound.curvature);
  return os.str() + '"';
}

std::optional<GC::Curvature_excess> curvature_excess(const Exact_curve& curve, const Curvature_bound& bound) {
  if (const auto polynomial = curve.polynomial()) return GC::curvature_excess(*polynomial, bound.curvature);
  return GC::curvature_excess(curve, bound.curvature);
}

std::optional<GC::Curvature_excess>
curvature_excess(const GC::Bezier_curve<GC::Traits_2<CGAL::Simple_cartesian<Exact>>>& curve,
                 const Curvature_bound& bound) {
  return GC::curvature_excess(curve, bound.curvature);
}

GC::Enclosure size_of(const GC::Curvature_excess& excess) {
  const GC::Enclosure& k = excess.curvature;
  return k.upper <= 0 ? GC::Enclosure{-k.upper, -k.lower} : GC::Enclosure{(std::max)(k.lower, 0.), k.upper};
}

std::string to_string(const GC::Curvature_excess& excess) {
  std::ostringstream os;
  const GC::Enclosure k = size_of(excess);
  if (excess.unbounded)
    os << "curvature without a bound, as in a cusp,";
  else
    os << "curvature " << k << ", radius " << GC::Enclosure{1 / k.upper, 1 / k.lower};
  os << " at the parameter " << excess.parameter;
  return os.str();
}

void write_json_members(std::ostream& os, const GC::Curvature_excess& excess) {
  GC::write_json(os << "\"parameter\":", excess.parameter);
  os << ",\"curvature\":";
  if (excess.unbounded)
    os << "null";
  else
    GC::write_json(os, excess.curvature);
}

Bent_curves bent_curves(const std::string& text, const Curvature_bound& bound) {
  Bent_curves bent;
  std::istringstream is(text);
  GC::G2_piece_reader<Program_traits<Exact>> reader(is, "what is written");
  std::size_t number = 0;
  for (; const std::optional<Exact_curve> curve = reader.next(); ++number)
    if (const std::optional<GC::Curvature_excess> excess = curvature_excess(*curve, bound))
      bent.curves.push_back({number, *excess});
  return bent;
}

void write_text(std::ostream& os, const Bent_curves& bent, const Curvature_bound& bound) {
  if (bent.is_met()) {
    os << "every curve is " << bound.words << ", proved exactly\n";
    return;
  }
  const auto worst = std::max_element(bent.curves.begin(), bent.curves.end(),
                                      [](const Bent_curves::Curve& x, const Bent_curves::Curve& y) {
                                        return size_of(x.excess).upper < size_of(y.excess).upper;
                                      });
  os << counted(bent.curves.size(), "curve") << " not " << bound.words << "; worst, curve " << worst->number << ": "
     << to_string(worst->excess) << '\n';
}

void write_json_member(std::ostream& os, const Bent_curves& bent, const Curvature_bound& bound) {
  os << ',' << json_member(bound) << ",\"max_curvature_met\":" << (bent.is_met() ? "true" : "false")
     << ",\"bent_curves\":[";
  for (const Bent_curves::Curve& c : bent.curves) {
    os << (&c == &bent.curves.front() ? "" : ",") << "{\"curve\":" << c.number << ',';
    write_json_members(os, c.excess);
    os << '}';
  }
  os << ']';
}
