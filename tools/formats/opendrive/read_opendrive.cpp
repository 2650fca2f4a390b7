// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/opendrive/read_opendrive.h"

#include "files/input.h"
#include "formats/number_fault.h"
#include "formats/xml/Xml_reader.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <system_error>
#include <utility>

namespace {

typedef GC::Road_number Exact_number;

// The attributes of an element.
class Attributes {
  const char** const pairs_;

public:
  explicit Attributes(const char** pairs) : pairs_(pairs) {}

  // The value without blanks around it.
  std::optional<std::string_view> find(std::string_view name) const {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2)
      if (name == pair[0]) {
        std::string_view value = pair[1];
        const std::size_t begin = value.find_first_not_of(" \t\r\n");
        if (begin == std::string_view::npos) return std::string_view();
        return value.substr(begin, value.find_last_not_of(" \t\r\n") + 1 - begin);
      }
    return std::nullopt;
  }
  std::string text(std::string_view name) const { return std::string(find(name).value_or(std::string_view())); }
};

class Opendrive_reader : public Xml_reader {
  // The elements that are read, by what stands in them.
  enum class Place {
    file,
    network,
    road,
    road_link,
    plan,
    geometry,
    elevation,
    lateral,
    lanes,
    section,
    side,
    lane,
    lane_link,
    junction,
    connection
  };

  Opendrive_file result_;
  std::vector<Place> open_;
  std::size_t skipped_ = 0; // the depth in an element that is left out
  std::size_t shapes_ = 0;  // of the geometry that is open
  bool is_in_shape_ = false;
  std::string element_; // that is read, for messages
  const Exact_number zero_ = 0;

  GC::Road& road() { return result_.network.roads.back(); }
  GC::Road_section& section() { return road().sections.back(); }
  GC::Road_lane& lane() { return section().lanes.back(); }
  GC::Road_geometry& geometry() { return road().plan.back(); }
  Opendrive_file::Geometry_text& geometry_text() { return result_.texts.back().back(); }
  GC::Road_connection& connection() { return result_.network.junctions.back().connections.back(); }

  [[noreturn]] void refuse_value(std::string_view name, std::string_view value, const std::string& reason) const {
    refuse(element_ + ", " + std::string(name) + " = " + GC::quoted_token(value) + ": " + reason);
  }

  std::string_view required(const Attributes& attributes, std::string_view name) const {
    const std::optional<std::string_view> value = attributes.find(name);
    if (!value) refuse(element_ + " has no attribute " + std::string(name));
    return *value;
  }

  Exact_number number(std::string_view name, std::string_view value) const {
    if (value.find('/') != std::string_view::npos) refuse_value(name, value, "not a decimal number");
    try {
      const Exact_number x = GC::parse_number<Exact_number>(value);
      return CGAL::is_zero(x) ? zero_ : x; // most coefficients are, and share it
    } catch (const GC::Error& e) {
      refuse_value(name, value, number_fault(e));
    }
  }
  Exact_number number(const Attributes& attributes, std::string_view name) const {
    return number(name, required(attributes, name));
  }
  Exact_number length_of(const Attributes& attributes, std::string_view name) const {
    const Exact_number x = number(attributes, name);
    if (CGAL::is_negative(x)) refuse_value(name, required(attributes, name), "a length is negative");
    return x;
  }
  std::vector<Exact_number> numbers(const Attributes& attributes, std::initializer_list<std::string_view> names) const {
    std::vector<Exact_number> result;
    for (const std::string_view name : names) result.push_back(number(attributes, name));
    return result;
  }

  int lane_number(const Attributes& attributes, std::string_view name) const {
    std::string_view digits = required(attributes, name);
    if (digits.substr(0, 1) == "+") digits.remove_prefix(1);
    int id = 0;
    const std::from_chars_result end = std::from_chars(digits.data(), digits.data() + digits.size(), id);
    constexpr int most = 1000000;
    if (end.ec != std::errc() || end.ptr != digits.data() + digits.size() || id < -most || most < id)
      refuse_value(name, digits, "not the number of a lane");
    return id;
  }

  bool truth(const Attributes& attributes, std::string_view name) const {
    const std::string_view value = attributes.find(name).value_or("false");
    if (value == "true" || value == "1") return true;
    if (value != "false" && value != "0") refuse_value(name, value, "neither true nor false");
    return false;
  }

  static std::optional<GC::Road_end> contact(const Attributes& attributes) {
    const std::string_view value = attributes.find("contactPoint").value_or("");
    if (value == "start") return GC::Road_end::start;
    if (value == "end") return GC::Road_end::end;
    return std::nullopt;
  }

  GC::Road_cubic cubic(const Attributes& attributes, std::string_view s) const {
    return {number(attributes, s),   number(attributes, "a"), number(attributes, "b"),
            number(attributes, "c"), number(attributes, "d"), line()};
  }

  GC::Road_link road_link(const Attributes& attributes) const {
    GC::Road_link link;
    const std::string type = attributes.text("elementType");
    link.target = type == "road"       ? GC::Road_link::Target::road
                  : type == "junction" ? GC::Road_link::Target::junction
                                       : GC::Road_link::Target::other;
    link.id = attributes.text("elementId");
    link.contact = contact(attributes);
    if (attributes.find("elementS")) link.at = number(attributes, "elementS");
    link.is_against = attributes.text("elementDir") == "-";
    link.line = line();
    return link;
  }

  // How many digits of a number count: all between the first and the last that is not 0.
  static int significant_digits(std::string_view text) {
    int digits = 0, zeros = 0;
    for (const char c : text) {
      if (c == 'e' || c == 'E') break;
      if (c < '0' || '9' < c) continue;
      if (c == '0') {
        zeros += digits > 0;
        continue;
      }
      digits += zeros + 1;
      zeros = 0;
    }
    return digits;
  }

  // Versions do not differ in what is read of them.
  void read_header(const Attributes& attributes) {
    result_.header_line = line();
    for (const char* const name : {"revMajor", "revMinor"}) {
      const std::optional<std::string_view> value = attributes.find(name);
      if (value && (value->empty() || value->find_first_not_of("0123456789") != std::string_view::npos))
        result_.odd_revision.emplace_back(name, *value);
    }
  }

  void start_road(const Attributes& attributes) {
    GC::Road& road = result_.network.roads.emplace_back();
    road.id = required(attributes, "id");
    road.junction = attributes.text("junction");
    road.length = length_of(attributes, "length");
    road.line = line();
    result_.texts.emplace_back();
  }

  void start_geometry(const Attributes& attributes) {
    GC::Road_geometry& g = road().plan.emplace_back();
    g.s = number(attributes, "s");
    g.x = number(attributes, "x");
    g.y = number(attributes, "y");
    g.heading = number(attributes, "hdg");
    g.length = length_of(attributes, "length");
    g.line = line();
    for (const char* const name : {"x", "y", "hdg"})
      result_.digits = (std::max)(result_.digits, significant_digits(required(attributes, name)));
    result_.texts.back().push_back({byte(), byte() + length(), 0, 0, 0});
    shapes_ = 0;
  }

  // Reads the shape of a geometry.
  void start_shape(std::string_view name, const Attributes& attributes) {
    if (name == "line")
      geometry().shape = GC::Road_shape::line;
    else if (name == "arc") {
      geometry().shape = GC::Road_shape::arc;
      geometry().parameters = numbers(attributes, {"curvature"});
    } else if (name == "spiral") {
      geometry().shape = GC::Road_shape::spiral;
      geometry().parameters = numbers(attributes, {"curvStart", "curvEnd"});
    } else if (name == "poly3") {
      geometry().shape = GC::Road_shape::poly3;
      geometry().parameters = numbers(attributes, {"a", "b", "c", "d"});
    } else if (name == "paramPoly3") {
      geometry().shape = GC::Road_shape::param_poly3;
      geometry().parameters = numbers(attributes, {"aU", "bU", "cU", "dU", "aV", "bV", "cV", "dV"});
      const std::optional<std::string_view> range = attributes.find("pRange");
      if (range && *range != "normalized" && *range != "arcLength")
        refuse_value("pRange", *range, "neither normalized nor arcLength");
      geometry().range = !range                  ? GC::Road_parameter_range::missing
                         : *range == "arcLength" ? GC::Road_parameter_range::arc_length
                                                 : GC::Road_parameter_range::normalized;
    } else
      return;
    ++shapes_;
    geometry_text().shape_begin = byte();
    geometry_text().shape_end = byte() + length();
    is_in_shape_ = true;
  }

  void start_section(const Attributes& attributes) {
    GC::Road_section& s = road().sections.emplace_back();
    s.s = number(attributes, "s");
    s.is_single_side = truth(attributes, "singleSide");
    s.line = line();
  }

  void start_lane(const Attributes& attributes) {
    GC::Road_lane& l = section().lanes.emplace_back();
    l.id = lane_number(attributes, "id");
    l.type = attributes.text("type");
    l.is_level = truth(attributes, "level");
    l.line = line();
  }

  void start_junction(const Attributes& attributes) {
    GC::Road_junction& j = result_.network.junctions.emplace_back();
    j.id = required(attributes, "id");
    j.type = attributes.text("type");
    j.line = line();
  }

  void start_connection(const Attributes& attributes) {
    GC::Road_connection& c = result_.network.junctions.back().connections.emplace_back();
    c.id = attributes.text("id");
    c.incoming = attributes.text("incomingRoad");
    c.is_direct = attributes.find("linkedRoad").has_value();
    c.connecting = attributes.text(c.is_direct ? "linkedRoad" : "connectingRoad");
    c.contact = contact(attributes);
    c.line = line();
  }

  // Reads an element, and returns what its elements are, or nothing if they are left out.
  std::optional<Place> open(Place place, std::string_view name, const Attributes& attributes) {
    switch (place) {
    case Place::file: result_.root = name; return Place::network;
    case Place::network:
      if (name == "header") read_header(attributes);
      if (name == "road") return start_road(attributes), Place::road;
      if (name == "junction") return start_junction(attributes), Place::junction;
      break;
    case Place::road:
      if (name == "link") return Place::road_link;
      if (name == "planView") return Place::plan;
      if (name == "elevationProfile") return Place::elevation;
      if (name == "lateralProfile") return Place::lateral;
      if (name == "lanes") return Place::lanes;
      break;
    case Place::road_link:
      if (name == "predecessor") road().predecessor = road_link(attributes);
      if (name == "successor") road().successor = road_link(attributes);
      break;
    case Place::plan:
      if (name == "geometry") return start_geometry(attributes), Place::geometry;
      break;
    case Place::geometry: start_shape(name, attributes); break;
    case Place::elevation:
      if (name == "elevation") road().elevation.push_back(cubic(attributes, "s"));
      break;
    case Place::lateral:
      if (name == "superelevation") road().superelevation.push_back(cubic(attributes, "s"));
      if (name == "crossfall" || name == "shape" || name == "crossSectionSurface") road().other_heights = name;
      break;
    case Place::lanes:
      if (name == "laneOffset") road().lane_offset.push_back(cubic(attributes, "s"));
      if (name == "laneSection") return start_section(attributes), Place::section;
      break;
    case Place::section:
      if (name == "left" || name == "right" || name == "center") return Place::side;
      break;
    case Place::side:
      if (name == "lane") return start_lane(attributes), Place::lane;
      break;
    case Place::lane:
      if (name == "link") return Place::lane_link;
      if (name == "width") lane().widths.push_back(cubic(attributes, "sOffset"));
      if (name == "border") lane().borders.push_back(cubic(attributes, "sOffset"));
      if (name == "height") lane().has_height = true;
      break;
    case Place::lane_link:
      if (name == "predecessor") lane().predecessors.push_back(lane_number(attributes, "id"));
      if (name == "successor") lane().successors.push_back(lane_number(attributes, "id"));
      break;
    case Place::junction:
      if (name == "connection") return start_connection(attributes), Place::connection;
      break;
    case Place::connection:
      if (name != "laneLink") break;
      connection().lanes.emplace_back(lane_number(attributes, "from"), lane_number(attributes, "to"));
      if (attributes.find("overlapZone")) connection().has_overlap = true;
      break;
    }
    return std::nullopt;
  }

  void start(const std::string& full_name, const char** pairs) override {
    if (skipped_ > 0) {
      ++skipped_;
      return;
    }
    const std::size_t blank = full_name.rfind(' ');
    element_ = blank == std::string::npos ? full_name : full_name.substr(blank + 1);
    const Place place = open_.empty() ? Place::file : open_.back();
    if (const std::optional<Place> inner = open(place, element_, Attributes(pairs)))
      open_.push_back(*inner);
    else
      skipped_ = 1;
  }

  void end() override {
    if (skipped_ > 0) {
      --skipped_;
      if (skipped_ == 0 && std::exchange(is_in_shape_, false))
        geometry_text().shape_end = (std::max)(geometry_text().shape_end, byte() + length()); // it may have an end tag
      return;
    }
    if (open_.back() == Place::geometry) geometry_text().end = byte() + length();
    if (open_.back() == Place::geometry && shapes_ != 1)
      refuse("a geometry has " + std::to_string(shapes_) +
             " shapes; it needs exactly one of line, arc, spiral, poly3 and paramPoly3");
    if (open_.back() == Place::network && result_.root != "OpenDRIVE" && result_.network.roads.empty())
      refuse("the root element is " + GC::quoted_token(result_.root) + ", not OpenDRIVE, and there is no road in it");
    open_.pop_back();
  }

public:
  explicit Opendrive_reader(const std::string& file) : Xml_reader(file) {}

  Opendrive_file roads(std::istream& stream) {
    read(stream);
    return std::move(result_);
  }
};

} // namespace

Opendrive_file read_opendrive(std::istream& stream, const std::string& name) {
  return Opendrive_reader(name).roads(stream);
}

Opendrive_file read_opendrive(const std::string& file) {
  Input input(file);
  return read_opendrive(input, input_name(file));
}

bool begins_as_opendrive(std::string_view text) {
  const std::size_t root = text.find("OpenDRIVE");
  return root != std::string_view::npos && root > 0 && (text[root - 1] == '<' || text[root - 1] == ':') &&
         text.find("<svg") > root;
}

bool is_road_file(const std::string& file) {
  std::string name = file;
  if (name.size() > 3 && name.compare(name.size() - 3, 3, ".gz") == 0) name.resize(name.size() - 3);
  std::string ending = name.substr((std::min)(name.rfind('.'), name.size()));
  for (char& c : ending)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".xodr" || begins_as_opendrive(beginning_of_text(file));
}
