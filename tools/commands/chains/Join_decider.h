// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_JOIN_DECIDER_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_JOIN_DECIDER_H

#include "commands/chains/Chain_report.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/joins/Span_join.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

// A join of a chain: the numbers of the spans, and where the left one ends.
struct Join_place {
  std::size_t left, right;
  const std::string& file;
  long long line;      // 0 where it was not asked for
  std::size_t in_file; // the number of the left span among those of its file, from 0 on
};

// Decides the joins of spans and writes the rows of a report, or its findings.
template <class Span> class Join_decider {
  typedef GC::Span_join<Span> Ends;
  const Join_demand& demand_;
  const Report_mode mode_;

public:
  Join_decider(const Report_mode& mode, const Join_demand& demand) : demand_(demand), mode_(mode) {}

  void operator()(const Join_place& place, const Span& left, const Span& right, Decided_joins& joins) const {
    std::optional<GC::Order_within> within;
    if (demand_.tolerance) within = GC::order_within(left.jets(), right.jets(), demand_.tolerance->joins);
    const bool only_orders = mode_.summary || mode_.has_findings();
    const Ends ends(left, right);
    Join join = only_orders ? ends.orders(demand_.max_order) : ends.continuity(demand_.max_order);
    // is a tangent zero?
    if (only_orders && join.g_order == 0) ends.complete(join, demand_.max_order);
    joins.summary.add(join);
    const Drawn drawn = this->drawn(join, left, right);
    if (drawn) joins.drawn.add(*drawn);
    if (join.c_order < 0) {
      const Closing_reversal reversal = closing_reversal(ends);
      if (reversal.left || reversal.right) joins.gaps.push_back({place.left, place.right, reversal});
    }
    if (mode_.certificate != nullptr) joins.certificates.push_back(certificate(place, join, left, right));
    const bool is_open = demand_.max_order > 0 && lacks_direction(join, drawn, left, right);
    Claim claim = this->claim(join, drawn, within, left, right);
    if (claim == Claim::not_met && is_open && is_about_tangents()) claim = Claim::undecided;
    const bool fails = claim != Claim::met, is_noted = this->is_noted(join, drawn, within);
    if (mode_.has_findings() && (fails || is_noted)) ends.complete(join, demand_.max_order);
    joins.part.add(place.file, {claim, "join", is_open ? too_few_derivatives : "the tolerance lies between the bounds"},
                   is_noted, [&] { return finding(place, join, drawn, ends, within, claim); });
    if (mode_.has_findings() || (mode_.summary && !fails)) return;
    if (mode_.summary) {
      const auto row = [&] {
        ends.complete(join, demand_.max_order);
        std::string text;
        append_row(text, place, join, drawn, ends, within, joins.stream);
        return text;
      };
      if (mode_.format == Report_format::json)
        joins.part.failing_rows += row();
      else
        joins.worst.add(order(join), place.left, row);
    } else {
      std::string& rows = joins.part.rows;
      const std::size_t begin = rows.size();
      append_row(rows, place, join, drawn, ends, within, joins.stream);
      if (fails && mode_.format == Report_format::text)
        joins.worst.add(order(join), place.left, [&] { return rows.substr(begin); });
    }
  }

private:
  typedef std::optional<Drawn_join> Drawn;
  static constexpr const char* too_few_derivatives = "all derivatives that are read are zero, see --max-order";

  // Returns the order by which joins that fail are better or worse.
  int order(const Join& join) const {
    return GC::order_of(join, demand_.order ? demand_.order->kind() : GC::Continuity_kind::G);
  }

  bool is_about_tangents() const {
    return demand_.order && demand_.order->kind() != GC::Continuity_kind::C && demand_.order->order() == 1;
  }

  // Most joins need no jets.
  Drawn drawn(const Join& join, const Span& left, const Span& right) const {
    if (join.g_order != 0 || join.regular) return std::nullopt;
    const auto &x = left.jets(), &y = right.jets();
    return drawn_join(join, x.end_jet(x.order()), y.start_jet(y.order()), demand_.corner_threshold);
  }

  std::string certificate(const Join_place& place, const Join& join, const Span& left, const Span& right) const {
    const int k = demand_.max_order;
    return "\"left\":" + std::to_string(place.left) + ",\"right\":" + std::to_string(place.right) + ',' +
           certificate_members(GC::join_certificate(left.jets().template end_jet_over<Exact>(k),
                                                    right.jets().template start_jet_over<Exact>(k), join, k));
  }

  // Returns whether a curve of a higher degree than the jets have orders has no direction in these.
  static bool lacks_direction(const Join& join, const Drawn& drawn, const Span& left, const Span& right) {
    if (join.g_order != 0 || join.regular || drawn) return false;
    const int order = left.jets().order();
    return (left.degree() > order && !direction(left.jets().end_jet(order), GC::Curve_end::end)) ||
           (right.degree() > order && !direction(right.jets().start_jet(order), GC::Curve_end::start));
  }

  // Returns the claim of the requirement, exactly or within the tolerance; where nothing is
  // required, of all orders within the tolerance. Where a tangent is zero, the tangent of the drawn
  // curves counts.
  Claim claim(const Join& join, const Drawn& drawn, const std::optional<GC::Order_within>& within, const Span& left,
              const Span& right) const {
    if (!demand_.order) return within && has_undecided_order(*within) ? Claim::undecided : Claim::met;
    if (demand_.order->met(join)) return Claim::met;
    if (drawn && is_about_tangents() && drawn->is_smooth()) return Claim::met;
    if (!within) return Claim::not_met;
    const bool is_c = demand_.order->kind() == GC::Continuity_kind::C;
    const GC::Verdict verdict =
        is_c ? GC::is_c_within(left.jets(), right.jets(), demand_.order->order(), demand_.tolerance->joins)
        : drawn && is_about_tangents() ? GC::at_most(drawn->angle, demand_.tolerance->joins.tangent_angle)
                                       : (*within)(demand_.order->order());
    return verdict == GC::Verdict::proved      ? Claim::met
           : verdict == GC::Verdict::undecided ? Claim::undecided
                                               : Claim::not_met;
  }

  bool has_undecided_order(const GC::Order_within& within) const {
    return std::count(within.verdicts.begin(), within.verdicts.begin() + demand_.tolerance->order + 1,
                      GC::Verdict::undecided) > 0;
  }

  // Returns whether a join is worth a note where nothing is required: a gap or a kink.
  bool is_noted(const Join& join, const Drawn& drawn, const std::optional<GC::Order_within>& within) const {
    const int smooth = (std::min)(demand_.max_order, 1);
    return !demand_.order && !(drawn && drawn->is_smooth()) && join.g_order < smooth &&
           !(within && (*within)(smooth) == GC::Verdict::proved);
  }

  void append_row(std::string& rows, const Join_place& place, const Join& join, const Drawn& drawn, const Ends& ends,
                  const std::optional<GC::Order_within>& within, std::ostringstream& stream) const {
    if (mode_.format == Report_format::json)
      append_json_row(rows, place, join, drawn, within, stream);
    else
      append_text_row(rows, place, join, drawn, ends, within);
  }

  static void append_json_row(std::string& rows, const Join_place& place, const Join& join, const Drawn& drawn,
                              const std::optional<GC::Order_within>& within, std::ostringstream& s) {
    s.str("");
    s << ",\n {";
    GC::write_json_members(s, join, static_cast<int>(place.left), static_cast<int>(place.right));
    if (drawn) write_json_members(s, *drawn);
    if (within) {
      s << ',';
      GC::write_json_members(s, *within);
    }
    s << '}';
    rows += s.str();
  }

  Join_words words(const Join& join, const Drawn& drawn, const Ends& ends) const {
    Join_words words = join_words(join, ends, demand_.corner_threshold);
    if (drawn) words.remark += drawn->text();
    return words;
  }

  void append_text_row(std::string& rows, const Join_place& place, const Join& join, const Drawn& drawn,
                       const Ends& ends, const std::optional<GC::Order_within>& within) const {
    append_table_row(rows, join, place.left, place.right, words(join, drawn, ends));
    if (!within) return;
    std::ostringstream s;
    s << "             within the tolerance: order";
    for (int order = 0; order <= demand_.tolerance->order; ++order)
      s << (order > 0 ? ", " : " ") << order << ' ' << (*within)(order);
    s << "; " << within->deviation << '\n';
    rows += s.str();
  }

  Finding_rule rule(const Join& join, const Drawn& drawn, const Span& left, const Span& right) const {
    if (join.c_order < 0) return Finding_rule::gap;
    if (drawn && !drawn->is_smooth())
      return drawn->grade == GC::Visual_class::corner ? Finding_rule::corner : Finding_rule::kink;
    if (!join.regular) return Finding_rule::tangent;
    if (!*join.tangent_equal)
      return exceeds(demand_.corner_threshold, left.jets().end_jet(1)[1], right.jets().start_jet(1)[1])
                 ? Finding_rule::corner
                 : Finding_rule::kink;
    return *join.curvature_vector_equal ? Finding_rule::derivative : Finding_rule::curvature;
  }

  Finding finding(const Join_place& place, const Join& join, const Drawn& drawn, const Ends& ends,
                  const std::optional<GC::Order_within>& within, Claim claim) const {
    const Span &left = ends.left(), &right = ends.right();
    const GC::Join_deviation deviation = within ? within->deviation : GC::deviation(left.jets(), right.jets());
    Finding f;
    f.file = place.file;
    f.line = place.line;
    f.kind = "join";
    f.place = "join " + std::to_string(place.left) + " -> " + std::to_string(place.right);
    f.rule = claim == Claim::undecided ? Finding_rule::undecided : rule(join, drawn, left, right);
    const Join_words words = this->words(join, drawn, ends);
    std::ostringstream message, properties;
    if (claim == Claim::not_met)
      message << "not " << demand_.order->text() << (within ? " within the tolerance" : "") << ", ";
    else if (claim == Claim::undecided)
      message << (within ? "an order is undecided within the tolerance, " : "undecided, ");
    message << words.remark << " at " << words.point << "; " << deviation;
    f.message = message.str();
    GC::write_json_members(properties, join, static_cast<int>(place.left), static_cast<int>(place.right));
    if (drawn) write_json_members(properties, *drawn);
    GC::write_json_members(properties << ',', deviation);
    f.properties = properties.str();
    f.object = "join";
    f.spot = std::to_string(place.in_file);
    f.shape = shape(
        f.rule == Finding_rule::gap || (!drawn && (f.rule == Finding_rule::corner || f.rule == Finding_rule::kink)) ? 1
                                                                                                                    : 3,
        left, right);
    f.measure = measure(f.rule, drawn, deviation);
    if (f.rule == Finding_rule::gap && deviation.tangent_angle)
      f.behind = Measure{"angle_degrees", GC::in_degrees(*deviation.tangent_angle)};
    return f;
  }

  static std::optional<Measure> measure(Finding_rule rule, const Drawn& drawn, const GC::Join_deviation& d) {
    switch (rule) {
    case Finding_rule::gap: return Measure{"gap", d.gap};
    case Finding_rule::corner:
    case Finding_rule::kink:
      if (drawn) return Measure{"angle_degrees", GC::in_degrees(drawn->angle)};
      if (d.tangent_angle) return Measure{"angle_degrees", GC::in_degrees(*d.tangent_angle)};
      break;
    case Finding_rule::curvature:
      if (d.curvature_jump) return Measure{"curvature_jump", *d.curvature_jump};
      break;
    case Finding_rule::derivative:
      if (d.torsion_jump) return Measure{"torsion_jump", *d.torsion_jump};
      break;
    case Finding_rule::tangent:
    case Finding_rule::bend:
    case Finding_rule::undecided:
    case Finding_rule::not_verified:
    case Finding_rule::rounding:
    case Finding_rule::length: break;
    }
    return std::nullopt;
  }

  // Describes the defect by the position of the ends relative to each other, not by their place,
  // and by so many first derivatives on both sides.
  static std::string shape(int derivatives, const Span& left, const Span& right) {
    const auto x = left.jets().template end_jet_over<Exact>(3), y = right.jets().template start_jet_over<Exact>(3);
    std::ostringstream os;
    for (int c = 0; c < x.dimension(); ++c) {
      os << Exact(y[0][c] - x[0][c]);
      for (int j = 1; j <= derivatives; ++j) os << ' ' << x[j][c] << ' ' << y[j][c];
      os << ';';
    }
    return os.str();
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_JOIN_DECIDER_H
