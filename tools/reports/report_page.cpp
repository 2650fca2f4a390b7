// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "reports/report_page.h"

#include "reports/Conclusion.h"
#include "reports/words.h"

#include "report_page_text.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

namespace {

const char* const grade_names[number_of_report_grades] = {"gap",    "kink", "bend",      "rounding", "fading corner",
                                                          "corner", "G0",   "undecided", "G1",       "G2"};

// More curves are not drawn around the joins.
constexpr std::size_t most_curves = 100000;

// JSON that stands inside of HTML: no text in it ends the block.
std::string without_markup(const std::string& json) {
  std::string result;
  for (const char c : json) switch (c) {
    case '<': result += "\\u003c"; break;
    case '>': result += "\\u003e"; break;
    case '&': result += "\\u0026"; break;
    default: result += c;
    }
  return result;
}

// A text from outside as such a string, in which nothing is shown that is no text.
std::string page_string(const std::string& text) { return without_markup(json_text(GC::printable(text))); }

// The shortest decimal that is read as this number.
std::string page_number(double x, const std::string& place) {
  if (!std::isfinite(x))
    throw GC::Error(GC::Error_code::not_finite, place + ": too large to be drawn with floating-point numbers");
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}

std::string page_numbers(const std::vector<double>& numbers, const std::string& place) {
  std::string json = "[";
  for (double x : numbers) (json += json.size() == 1 ? "" : ",") += page_number(x, place);
  return json + ']';
}

// Both bounds as texts of six digits, which enclose the number as well.
std::string page_bounds(const std::optional<GC::Enclosure>& enclosure) {
  if (!enclosure) return "null";
  std::ostringstream os;
  os << *enclosure;
  const std::string text = os.str();
  if (text[0] != '[') return "[\"" + text + "\",\"" + text + "\"]";
  const std::size_t comma = text.find(", ");
  return "[\"" + text.substr(1, comma - 1) + "\",\"" + text.substr(comma + 2, text.size() - comma - 3) + "\"]";
}

// The curves of all joins, each once.
class Curve_numbers {
  std::map<const Report_curve*, std::size_t> numbers_;

public:
  std::size_t size() const { return numbers_.size(); }
  std::size_t operator()(const Report_curve& curve) { return numbers_.emplace(&curve, numbers_.size()).first->second; }
  std::vector<const Report_curve*> curves() const {
    std::vector<const Report_curve*> result(numbers_.size());
    for (const auto& [curve, number] : numbers_) result[number] = curve;
    return result;
  }
};

std::string page_marks(const std::vector<std::string>& marks) {
  std::string json;
  for (const std::string& mark : marks) json += (json.empty() ? ",\"marks\":[" : ",") + page_string(mark);
  return json.empty() ? json : json + ']';
}

std::string page_item(const Report_item& item, double extent, Curve_numbers& curves) {
  std::string json = "{\"number\":" + std::to_string(item.number) + ",\"grade\":\"" + report_grade_name(item.grade) +
                     "\",\"place\":" + page_string(item.place) + ",\"verdict\":" + page_string(item.verdict) +
                     page_marks(item.marks) + ",\"angle\":" + page_bounds(item.angle);
  if (item.left || item.curvature_jump) json += ",\"jump\":" + page_bounds(item.curvature_jump);
  if (item.left)
    json += ",\"left\":" + std::to_string(curves(*item.left)) + ",\"right\":" + std::to_string(curves(*item.right));
  else if (item.road_place)
    json += ",\"road\":" + std::to_string(item.road_place->road) +
            ",\"s\":" + page_number(item.road_place->s, item.place) +
            ",\"xy\":" + page_numbers({item.road_place->x, item.road_place->y}, item.place);
  else
    json += ",\"edge\":" + std::to_string(item.edge);
  if (item.gap) json += ",\"gap\":" + page_bounds(item.gap);
  if (item.offset) json += ",\"offset\":" + page_bounds(item.offset);
  if (item.offset && extent > 0) {
    std::ostringstream os;
    os << std::setprecision(3) << 1000 * item.severity / extent;
    json += ",\"severity\":\"" + os.str() + '"';
  }
  if (!item.point.empty()) {
    const char* separator = ",\"at\":[";
    for (const std::string& x : item.point) {
      json += separator + page_string(x);
      separator = ",";
    }
    json += ']';
  }
  if (!item.parameter.empty()) json += ",\"parameter\":" + page_string(item.parameter);
  return json + '}';
}

void write_model(std::ostream& os, const Report_model& model) {
  os << ",\n\"model\":{\"patches\":[";
  const char* separator = "\n";
  for (std::size_t i = 0; i < model.patches.size(); ++i) {
    const Report_model::Patch& p = model.patches[i];
    os << separator << "{\"m\":" << p.m << ",\"n\":" << p.n;
    if (!p.colour.empty()) os << ",\"colour\":\"" << p.colour << '"';
    os << ",\"points\":" << page_numbers(p.points, "surface " + std::to_string(i));
    for (std::size_t j = 0; j < p.triangles.size(); ++j) os << (j == 0 ? ",\"triangles\":[" : ",") << p.triangles[j];
    os << (p.triangles.empty() ? "}" : "]}");
    separator = ",\n";
  }
  os << "],\n\"edges\":[";
  separator = "\n";
  for (std::size_t i = 0; i < model.edges.size(); ++i) {
    const Report_model::Edge& e = model.edges[i];
    os << separator << "{\"grade\":\"" << e.grade << "\",\"patches\":[";
    for (std::size_t j = 0; j < e.patches.size(); ++j) os << (j == 0 ? "" : ",") << e.patches[j];
    os << "],\"points\":" << page_numbers(e.points, "edge " + std::to_string(i)) << '}';
    separator = ",\n";
  }
  os << "]}";
}

// Numbers rounded to millimetres, or to another unit.
std::string page_rounded(const std::vector<double>& numbers, const std::string& place, double unit = 1e-3) {
  std::vector<double> rounded(numbers);
  for (double& x : rounded) x = std::nearbyint(x / unit) / std::nearbyint(1 / unit);
  return page_numbers(rounded, place);
}

void write_roads(std::ostream& os, const Report_roads& roads) {
  os << ",\n\"roads\":{\"origin\":" << page_numbers({roads.x, roads.y}, "the origin") << ",\"roads\":[";
  const char* separator = "\n";
  for (const Report_roads::Road& road : roads.roads) {
    const std::string place = "road " + road.id;
    os << separator << "{\"id\":" << page_string(road.id) << ",\"s\":" << page_rounded(road.s, place)
       << ",\"x\":" << page_rounded(road.x, place) << ",\"y\":" << page_rounded(road.y, place)
       << ",\"h\":" << page_rounded(road.heading, place, 1e-5) << ",\"k\":" << page_rounded(road.curvature, place, 1e-7)
       << ",\"z\":" << page_rounded(road.elevation, place) << ",\"lanes\":[";
    for (std::size_t i = 0; i < road.lanes.size(); ++i) {
      const Report_roads::Lane& lane = road.lanes[i];
      os << (i == 0 ? "" : ",") << "{\"driving\":" << (lane.is_driving ? "true" : "false")
         << ",\"first\":" << lane.first << ",\"left\":" << page_rounded(lane.left, place)
         << ",\"right\":" << page_rounded(lane.right, place) << '}';
    }
    os << "]}";
    separator = ",\n";
  }
  os << "]}";
}

} // namespace

const char* report_grade_name(Report_grade grade) { return grade_names[static_cast<std::size_t>(grade)]; }

bool Report_page::has(Report_grade grade) const {
  switch (grade) {
  case Report_grade::bend:
  case Report_grade::rounding: return is_of_fonts;
  case Report_grade::fading: return is_of_cad_models;
  case Report_grade::gap:
  case Report_grade::g0:
  // their contours are closed, and all is decided
  case Report_grade::undecided: return !is_of_fonts;
  default: return true;
  }
}

bool Report_page::count(Report_grade grade, double rank, const std::string& reason) {
  ++counts_[static_cast<std::size_t>(grade)];
  if (grade == Report_grade::undecided)
    claims_.add({Claim::undecided, "join", reason});
  else
    claims_.add({Claim::met, "join"});
  Report_item item;
  item.number = ++total_;
  item.grade = grade;
  item.severity = rank;
  return items_.size() < most_ || is_worse(item, items_.front());
}

void Report_page::add(Report_item item) {
  if (items_.size() == most_) { // the front is the least bad one
    std::pop_heap(items_.begin(), items_.end(), is_worse);
    items_.pop_back();
  }
  items_.push_back(std::move(item));
  std::push_heap(items_.begin(), items_.end(), is_worse);
}

void Report_page::leave_out(const char* noun, const std::string& reason, const std::string& note, std::size_t n) {
  claims_.add({Claim::not_covered, noun, reason}, n);
  if (!note.empty()) notes.push_back(note);
}

void Report_page::include(const std::vector<double>& points) {
  const std::size_t d = static_cast<std::size_t>(dimension);
  if (low_.empty() && points.size() >= d)
    low_ = high_ = std::vector<double>(points.begin(), points.begin() + dimension);
  for (std::size_t i = 0; i < points.size(); ++i) {
    low_[i % d] = (std::min)(low_[i % d], points[i]);
    high_[i % d] = (std::max)(high_[i % d], points[i]);
  }
}

double Report_page::extent() const {
  if (is_of_fonts) return 1;
  double sum = 0;
  for (std::size_t i = 0; i < low_.size(); ++i) sum += (high_[i] - low_[i]) * (high_[i] - low_[i]);
  return std::sqrt(sum);
}

void Report_page::finish() {
  std::sort_heap(items_.begin(), items_.end(), is_worse);
  if (left_out() > 0)
    notes.insert(notes.begin(), "The page shows the worst " + std::to_string(items_.size()) + " of " +
                                    std::to_string(total_) + "; " + std::to_string(left_out()) + " are left out.");
}

void Report_page::number_edges() {
  for (std::size_t i = 0; i < items_.size(); ++i) items_[i].edge = i;
}

void Report_page::write(std::ostream& os) const {
  std::string classes;
  if (claims_.undecided() > 0) classes += "; " + std::to_string(claims_.undecided()) + " undecided";
  if (claims_.not_covered() > 0) classes += "; " + std::to_string(claims_.not_covered()) + " not covered";
  const Report_mode mode;
  const Report_subject subject{"join", "every join"};
  os << page_before_data << "{\"title\":" << page_string(title) << ",\"summary\":" << page_string(summary + classes)
     << ",\n"
     << without_markup(Conclusion(claims_, mode, subject).json()) << ",\n\"notes\":[";
  for (std::size_t i = 0; i < notes.size(); ++i) os << (i == 0 ? "\n" : ",\n") << page_string(notes[i]);
  os << "],\n\"dimension\":" << dimension << ",\"down\":" << (down ? "true" : "false") << ",\"whole\":\""
     << (is_of_fonts ? "em" : "whole") << "\",\"numbered\":" << (is_numbered ? "true" : "false")
     << ",\"empty\":" << page_string(empty) << ",\"page\":" << page_string(join_page) << ",\"total\":" << total_
     << ",\"counts\":{";
  const char* separator = "\"";
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (has(static_cast<Report_grade>(i)))
      os << std::exchange(separator, ",\"") << grade_names[i] << "\":" << counts_[i];
  os << "},\n\"joins\":[";
  Curve_numbers curves;
  separator = "\n";
  for (const Report_item& item : items_) {
    os << separator << page_item(item, extent(), curves);
    separator = ",\n";
  }
  for (const Report_item& item : items_)
    if (item.outline && curves.size() + item.outline->size() <= most_curves)
      for (const std::shared_ptr<const Report_curve>& curve : *item.outline) curves(*curve);
  os << "],\n\"curves\":[";
  separator = "\n";
  for (const Report_curve* curve : curves.curves()) {
    os << separator << "{\"group\":" << curve->group << ",\"points\":" << page_numbers(curve->points, "a curve");
    if (!curve->weights.empty()) os << ",\"weights\":" << page_numbers(curve->weights, "a curve");
    if (!join_page.empty() && !curve->link.points.empty())
      os << ",\"link\":{\"points\":\"" << curve->link.points << "\",\"weights\":\"" << curve->link.weights
         << "\",\"domain\":\"" << curve->link.domain << "\"}";
    os << '}';
    separator = ",\n";
  }
  os << ']';
  if (model) write_model(os, *model);
  if (roads) write_roads(os, *roads);
  os << '}' << page_behind_data;
}
