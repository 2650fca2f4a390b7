// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/Instance_kinks.h"

#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace {

typedef GC::Variation_axis::FT FT;

double length(const GC::Outline_vector& v) { return std::hypot(CGAL::to_double(v[0]), CGAL::to_double(v[1])); }

GC::Enclosure angle_at(const GC::Variable_join& join, const std::vector<FT>& scalars) {
  const auto [cross, dot] = join.products(scalars);
  return GC::angle_enclosure(FT(cross * cross), dot);
}

GC::Enclosure degrees(const GC::Enclosure& angle) {
  const GC::Enclosure x = GC::in_degrees(angle);
  return {x.lower, (std::min)(x.upper, 180.)};
}

// In degrees, rounded outwards.
std::string degrees_text(const GC::Enclosure& angle) {
  const GC::Enclosure x = degrees(angle);
  if (x.upper == 180) return "at least " + std::to_string(static_cast<int>(x.lower));
  std::ostringstream os;
  os.precision(3);
  os << x;
  return os.str();
}

} // namespace

Instance_counts& Instance_counts::operator+=(const Instance_counts& other) {
  for (std::size_t Instance_counts::*count :
       {&Instance_counts::joins, &Instance_counts::corners, &Instance_counts::no_direction, &Instance_counts::proved,
        &Instance_counts::refuted, &Instance_counts::undecided, &Instance_counts::smooth, &Instance_counts::vanishes})
    this->*count += other.*count;
  return *this;
}

void judge_instances(int glyph, int part, const GC::Variable_outline& outline,
                     const std::vector<GC::Outline_join>& joins, const GC::Variable_font& font,
                     const Instance_bounds& bounds, Instance_joins& result) {
  Instance_counts& counts = result.counts;
  GC::Kink_search search;
  search.limit = bounds.limit;
  const std::vector<FT> initial(font.axes().size(), FT(0)),
      initial_scalars = GC::region_scalars(outline.regions, initial);
  for (const GC::Outline_join& place : joins) {
    const GC::Variable_join& join = place.join;
    ++counts.joins;
    const std::optional<bool> corner = GC::is_corner(join, initial_scalars, bounds.corner);
    if (!corner || *corner) {
      ++(corner ? counts.corners : counts.no_direction);
      if (!corner) result.without_length.push_back(place);
      continue;
    }
    GC::Largest_kink kink = GC::largest_kink(join, outline.regions, font.ranges(), bounds.max_kink, search);
    ++(kink.verdict == GC::Verdict::proved    ? counts.proved
       : kink.verdict == GC::Verdict::refuted ? counts.refuted
                                              : counts.undecided);
    counts.vanishes += kink.vanishes;
    if (kink.angle.upper == 0) {
      ++counts.smooth;
      continue;
    }
    const std::vector<FT> scalars = GC::region_scalars(outline.regions, kink.instance);
    const double shorter = (std::min)(length(join.incoming(scalars)), length(join.outgoing(scalars))),
                 severity = kink.angle.lower * shorter / font.units_per_em();
    const GC::Variable_point& point = outline.points[static_cast<std::size_t>(place.point)];
    result.kinks.push_back({glyph, part, place.contour, place.point, point.x, point.y, std::move(kink),
                            angle_at(join, initial_scalars), severity});
  }
}

std::vector<std::string> instance_texts(const std::vector<GC::Variation_axis>& axes, const GC::Largest_kink& kink) {
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < axes.size(); ++k)
    texts.push_back(axes[k].tag + ' ' + axis_text(axes[k], kink.instance[k]));
  return texts;
}

std::string axis_text(const GC::Variation_axis& axis, const FT& normalised) {
  return rounded(CGAL::to_double(axis.user_value(normalised)), 6);
}

std::string axes_json(const std::vector<GC::Variation_axis>& axes) {
  std::ostringstream os;
  const char* separator = "[";
  for (const GC::Variation_axis& axis : axes) {
    GC::write_json(os << std::exchange(separator, ",") << "{\"tag\":", axis.tag);
    os << ",\"minimum\":" << axis_text(axis, axis.range().lowest) << ",\"default\":" << axis_text(axis, 0)
       << ",\"maximum\":" << axis_text(axis, axis.range().highest) << '}';
  }
  return os.str() + (axes.empty() ? "[]" : "]");
}

bool shown_before(const Instance_kink& x, const Instance_kink& y) {
  const auto order = [](const Instance_kink& k) {
    return std::make_tuple(-k.severity, k.glyph, k.part, k.contour, k.point);
  };
  return order(x) < order(y);
}

std::string counts_text(const Instance_counts& counts, const std::string& max_kink) {
  std::string text = counted(counts.joins, "join") + ": " + counted(counts.corners, "corner") +
                     " at the default instance, " + std::to_string(counts.proved) + " in no instance above " +
                     max_kink + " degrees (" + std::to_string(counts.smooth) + " smooth in every instance), " +
                     std::to_string(counts.refuted) + " above it in some instance, " +
                     std::to_string(counts.undecided) + " undecided";
  if (counts.no_direction != 0)
    text += ", " + std::to_string(counts.no_direction) + " with a handle of no length at the default instance";
  return text;
}

std::string counts_json(const Instance_counts& counts) {
  std::string json;
  for (const auto& [name, count] : {std::pair<const char*, std::size_t>("joins", counts.joins),
                                    {"corners", counts.corners},
                                    {"no_direction", counts.no_direction},
                                    {"not_covered", counts.no_direction}, // of all joins
                                    {"proved", counts.proved},
                                    {"refuted", counts.refuted},
                                    {"undecided", counts.undecided},
                                    {"smooth", counts.smooth},
                                    {"vanishing_handles", counts.vanishes}})
    json += std::string(json.empty() ? "\"" : ",\"") + name + "\":" + std::to_string(count);
  return json;
}

std::string kinks_table(const std::vector<Instance_kink>& kinks, const std::string& indentation) {
  if (kinks.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"glyph", "contour", "point", "at", "largest kink", "at the instance",
                                              "by default", "per mille of the em", "font"}};
  for (const Instance_kink& kink : kinks) {
    std::string instance;
    for (const std::string& value : kink.instance) instance += (instance.empty() ? "" : ", ") + value;
    rows.push_back({kink.glyph_name + (kink.part_name.empty() ? "" : ", part " + kink.part_name),
                    std::to_string(kink.contour), std::to_string(kink.point),
                    '(' + rounded(kink.x, 6) + ", " + rounded(kink.y, 6) + ')',
                    degrees_text(kink.kink.angle) + " degrees" + (kink.kink.vanishes ? ", a handle vanishes" : ""),
                    instance, degrees_text(kink.initial_angle), rounded(1000 * kink.severity, 3), kink.font_name});
  }
  const std::size_t columns = rows[0].size() - (kinks[0].font_name.empty() ? 1 : 0);
  std::vector<std::size_t> widths(columns, 0);
  for (std::vector<std::string>& cells : rows)
    for (std::size_t i = 0; i < columns; ++i) {
      cells[i] = GC::printable(cells[i]);
      widths[i] = (std::max)(widths[i], cells[i].size());
    }
  std::string text;
  for (const std::vector<std::string>& cells : rows) {
    text += indentation;
    for (std::size_t i = 0; i < columns; ++i) text += cells[i] + std::string(widths[i] - cells[i].size() + 2, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string kink_json(const Instance_kink& kink, const std::vector<GC::Variation_axis>& axes) {
  std::ostringstream os;
  os << "\"contour\":" << kink.contour << ",\"outline_point\":" << kink.point << ",\"point\":[" << rounded(kink.x, 9)
     << ',' << rounded(kink.y, 9) << "],\"verdict\":\"" << kink.kink.verdict << "\",\"angle_degrees\":";
  GC::write_json(os, std::optional<GC::Enclosure>(degrees(kink.kink.angle)));
  os << ",\"instance\":{";
  for (std::size_t k = 0; k < axes.size(); ++k) {
    os << (k == 0 ? "" : ",");
    GC::write_json(os, axes[k].tag);
    GC::write_number(os << ":\"", axes[k].user_value(kink.kink.instance[k]));
    os << '"';
  }
  os << "},\"default_angle_degrees\":";
  GC::write_json(os, std::optional<GC::Enclosure>(degrees(kink.initial_angle)));
  os << ",\"vanishing_handle\":" << (kink.kink.vanishes ? "true" : "false")
     << ",\"per_mille\":" << rounded(1000 * kink.severity, 6);
  if (!kink.part_name.empty()) GC::write_json(os << ",\"part\":", kink.part_name);
  return os.str();
}

std::string kinks_json(const std::vector<Instance_kink>& kinks, const std::vector<GC::Variation_axis>& axes) {
  std::string json;
  for (const Instance_kink& kink : kinks) json += (json.empty() ? "{" : ",{") + kink_json(kink, axes) + '}';
  return '[' + json + ']';
}

std::string kink_text(const Instance_kink& kink) {
  std::string text = "largest kink " + degrees_text(kink.kink.angle) + " degrees at";
  for (const std::string& value : kink.instance) text += ' ' + value;
  return text + ", by default " + degrees_text(kink.initial_angle) + " degrees, " + rounded(1000 * kink.severity, 3) +
         " per mille of the em";
}
