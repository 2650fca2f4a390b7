// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/landxml/read_landxml.h"

#include "files/input.h"
#include "formats/number_fault.h"
#include "formats/xml/Xml_reader.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_rational Q;

// The frame has x to the north and y to the east: there directions that are measured clockwise from
// the north are angles from the x-axis, and what turns clockwise has a positive curvature.
struct Element {
  std::string type; // Line, Curve, Spiral
  long long line = 0;
  std::map<std::string, std::string> attributes;
  std::map<std::string, std::vector<Q>> points;  // Start, End, Center, PI
  std::map<std::string, std::string> references; // of those, to points of the file
};

// How angles are written.
enum class Angle_unit { radians, degrees, grads, degrees_minutes };

// A point of a vertical alignment at which two gradients meet, and how far the curve there reaches
// on both sides; an arc reaches as far as its radius says.
struct Profile_point {
  long long line = 0;
  std::string type;
  std::optional<Q> station, height;
  Q in = 0, out = 0;
  std::optional<Q> radius, length; // of an arc, as they are declared
  bool rounded = false;            // there are roots in `in` and `out`
};

// The elements of an alignment, or of a vertical one.
struct Alignment_text {
  std::string name;
  std::vector<Element> elements;
  std::optional<std::string> length; // as it is declared
};
struct Profile_text {
  std::string name;
  std::vector<Profile_point> points;
};

class Landxml_reader : Xml_reader {
  Rail_file result_;
  std::vector<std::string> open_; // local names
  std::string alignment_, text_;
  std::vector<Element> elements_;
  std::vector<Alignment_text> plans_;
  std::vector<Profile_text> profiles_;
  std::map<std::string, std::vector<Q>> named_points_;
  std::string point_name_;
  std::optional<std::string> declared_length_;
  std::set<std::string> skipped_;
  Angle_unit directions_ = Angle_unit::radians, angles_ = Angle_unit::radians;
  std::size_t alignments_ = 0, references_ = 0;

  static std::string local(const std::string& name) {
    const std::size_t blank = name.rfind(' ');
    return blank == std::string::npos ? name : name.substr(blank + 1);
  }
  bool is_in(const char* parent) const { return open_.size() >= 2 && open_[open_.size() - 2] == parent; }
  bool is_element() const { return is_in("CoordGeom"); }
  bool is_in_element() const { return open_.size() >= 3 && open_[open_.size() - 3] == "CoordGeom"; }
  static bool is_point(const std::string& type) {
    return type == "Start" || type == "End" || type == "Center" || type == "PI";
  }

  void start_profile_point(const std::string& type, std::map<std::string, std::string>& given) {
    Profile_point p;
    p.line = line();
    p.type = type;
    const auto length = [&](const char* name) { return given.count(name) != 0 ? number(given[name]) : Q(0); };
    if (type == "ParaCurve") p.in = p.out = Q(length("length") / 2);
    if (type == "UnsymParaCurve") {
      p.in = length("lengthIn");
      p.out = length("lengthOut");
    }
    if (type == "CircCurve") {
      if (given.count("radius") != 0) p.radius = number(given["radius"]);
      if (given.count("length") != 0) p.length = number(given["length"]);
    }
    if (type == "PVI" || type == "ParaCurve" || type == "UnsymParaCurve" || type == "CircCurve")
      profiles_.back().points.push_back(std::move(p));
  }

  Angle_unit unit(const std::string& value) const {
    std::istringstream words(value); // some write two blanks
    std::string text;
    for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    if (text == "radians") return Angle_unit::radians;
    if (text == "decimal degrees") return Angle_unit::degrees;
    if (text == "grads") return Angle_unit::grads;
    if (text == "decimal dd.mm.ss") return Angle_unit::degrees_minutes;
    refuse("the unit of angles " + GC::quoted_token(text) +
           " is none of radians, decimal degrees, grads, decimal dd.mm.ss");
  }

  void start(const std::string& name, const char** attributes) override {
    open_.push_back(local(name));
    if (open_.size() == 1 && open_[0] != "LandXML")
      refuse("the root element is " + GC::quoted_token(open_[0]) + ", not LandXML");
    const std::string& type = open_.back();
    std::map<std::string, std::string> given;
    for (; *attributes != nullptr; attributes += 2) given[local(attributes[0])] = attributes[1];
    if (type == "Metric" || type == "Imperial") {
      if (given.count("angularUnit") != 0) angles_ = unit(given["angularUnit"]);
      directions_ = given.count("directionUnit") != 0 ? unit(given["directionUnit"]) : angles_;
    }
    if (type == "Alignment") {
      ++alignments_;
      alignment_ = given.count("name") != 0 ? given["name"] : std::to_string(alignments_);
      declared_length_ = given.count("length") != 0 ? std::optional<std::string>(given["length"]) : std::nullopt;
    }
    if (type == "ProfAlign") profiles_.push_back({alignment_, {}});
    if (is_in("ProfAlign")) start_profile_point(type, given);
    if (type == "CgPoint") point_name_ = given["name"];
    if (is_in_element() && is_point(type) && given.count("pntRef") != 0 && !elements_.empty())
      elements_.back().references[type] = given["pntRef"];
    if (is_element()) {
      if (type == "Line" || type == "Curve" || type == "Spiral")
        elements_.push_back({type, line(), std::move(given), {}, {}});
      else if (type != "Feature") {
        skipped_.insert(type);
        elements_.push_back({type, line(), {}, {}, {}});
      }
    }
    text_.clear();
  }
  void text(std::string_view text) override { text_ += text; }
  void end() override {
    const std::string type = open_.back();
    if (is_in_element() && !elements_.empty() && is_point(type)) {
      if (text_.find_first_not_of(" \t\r\n") != std::string::npos) elements_.back().points[type] = point();
    } else if (type == "CgPoint" && text_.find_first_not_of(" \t\r\n") != std::string::npos)
      named_points_.emplace(point_name_, point());
    else if (is_in("ProfAlign") && !profiles_.back().points.empty() && profiles_.back().points.back().type == type) {
      const std::vector<Q> place = point();
      profiles_.back().points.back().station = place[0];
      profiles_.back().points.back().height = place[1];
    }
    open_.pop_back();
    if (type == "CoordGeom") {
      plans_.push_back({alignment_, std::move(elements_), std::exchange(declared_length_, std::nullopt)});
      elements_.clear();
    }
  }

  Q number(const std::string& token) const {
    try {
      return GC::parse_number<Q>(token);
    } catch (const GC::Error& e) {
      refuse(number_fault(e) + ": " + GC::quoted_token(token));
    }
  }
  std::vector<Q> point() const {
    std::istringstream words(text_);
    std::vector<Q> x;
    for (std::string word; words >> word;) x.push_back(number(word));
    if (x.size() < 2 || x.size() > 3) refuse("a point has two or three numbers, not " + std::to_string(x.size()));
    return x;
  }

  // ---- what elements say

  // An angle in radians. `rounded` becomes true where pi is needed.
  Q angle(const std::string& text, Angle_unit unit, bool& rounded) const {
    Q x = number(text);
    if (unit == Angle_unit::radians) return x;
    rounded = true;
    if (unit == Angle_unit::grads) return Q(x * long_pi() / 200);
    if (unit == Angle_unit::degrees_minutes) {
      if (!(std::fabs(CGAL::to_double(x)) < 1e9)) refuse("an angle beyond 10^9 degrees");
      const bool negative = x < 0;
      if (negative) x = Q(-x);
      const auto whole = [](const Q& y) {
        Q n(std::floor(CGAL::to_double(y)));
        if (y < n) n = Q(n - 1);
        if (!(y < Q(n + 1))) n = Q(n + 1);
        return n;
      };
      const Q degrees = whole(x), hundredths = Q((x - degrees) * 100), minutes = whole(hundredths),
              seconds = Q((hundredths - minutes) * 100);
      x = Q(degrees + minutes / 60 + seconds / 3600);
      if (negative) x = Q(-x);
    }
    return Q(x * long_pi() / 180);
  }

  struct Piece {
    std::optional<GC::Enclosed_point> start, end; // as they are declared
    std::optional<GC::Heading> start_heading, end_heading;
    std::optional<GC::Alignment_end> computed_end;
    std::optional<Q> k0, k1;
    std::optional<GC::End_curvature> root0, root1; // of a curve without a radius, whose k0 and k1 may be rounded
    bool rounded = false;
    std::string not_covered;
  };

  std::optional<std::string> attribute(const Element& e, const char* name) const {
    const auto found = e.attributes.find(name);
    if (found == e.attributes.end()) return std::nullopt;
    return found->second;
  }
  std::optional<Q> curvature(const Element& e, const char* name, const Q& sign) const {
    const auto text = attribute(e, name);
    if (!text) return std::nullopt;
    if (*text == "INF" || *text == "inf" || *text == "Infinity") return Q(0);
    const Q radius = number(*text);
    if (radius == 0) return std::nullopt;
    return Q(sign / radius);
  }
  static std::optional<GC::Heading> between(const std::vector<Q>* p, const std::vector<Q>* q) {
    if (p == nullptr || q == nullptr) return std::nullopt;
    const Q dx = Q((*q)[0] - (*p)[0]), dy = Q((*q)[1] - (*p)[1]);
    if (dx == 0 && dy == 0) return std::nullopt;
    return GC::Heading(Q(0), dx, dy);
  }

  static Q squared_distance(const std::vector<Q>& p, const std::vector<Q>& q) {
    const Q dx = Q(q[0] - p[0]), dy = Q(q[1] - p[1]);
    return Q(dx * dx + dy * dy);
  }

  // The curvature of the circle about a centre through a point: the root of a rational number.
  static std::optional<GC::End_curvature> curvature_about(const std::vector<Q>& centre, const std::vector<Q>& point,
                                                          const Q& sign) {
    const Q square = squared_distance(centre, point);
    const double size = CGAL::to_double(square);
    if (!(1e-280 < size && size < 1e280)) return std::nullopt;
    return GC::End_curvature(sign < 0 ? -1 : 1, Q(1 / square));
  }

  // Returns it as a rational number; `is_rounded` becomes true where that is only close.
  static std::optional<Q> rounded(const std::optional<GC::End_curvature>& k, bool& is_rounded) {
    if (!k || k->rational()) return k ? k->rational() : std::nullopt;
    is_rounded = true;
    const auto [sign, square] = k->sign_and_square();
    return Q(sign * (square < 1 ? Q(1 / long_root(Q(1 / square))) : long_root(square)));
  }

  Piece piece(const Element& e) {
    Piece p;
    const auto at = [&](const char* name) -> const std::vector<Q>* {
      const auto found = e.points.find(name);
      return found == e.points.end() ? nullptr : &found->second;
    };
    const std::vector<Q>*start = at("Start"), *end = at("End"), *centre = at("Center"), *apex = at("PI");
    if (start != nullptr) p.start = GC::Enclosed_point((*start)[0], (*start)[1]);
    if (end != nullptr) p.end = GC::Enclosed_point((*end)[0], (*end)[1]);
    const auto heading = [&](const char* name) -> std::optional<GC::Heading> {
      const auto text = attribute(e, name);
      if (!text) return std::nullopt;
      return GC::Heading(angle(*text, directions_, p.rounded));
    };
    if (e.type != "Line" && e.type != "Curve" && e.type != "Spiral") {
      p.not_covered = "an element " + e.type;
      return p;
    }
    std::optional<Q> length;
    if (const auto text = attribute(e, "length")) length = number(*text);
    if (length && *length < 0) {
      p.not_covered = "a negative length";
      return p;
    }
    if (e.type == "Line") {
      p.k0 = p.k1 = Q(0);
      p.start_heading = heading("dir");
      if (!p.start_heading) p.start_heading = between(start, end);
      p.end_heading = p.start_heading;
      if (start != nullptr && p.start_heading && length)
        p.computed_end = GC::Clothoid_segment((*start)[0], (*start)[1], *p.start_heading, Q(0), Q(0), *length).end();
      return p;
    }
    const std::string rot = attribute(e, "rot").value_or("");
    if (rot != "cw" && rot != "ccw") {
      p.not_covered = "a turn " + GC::quoted_token(rot) + " that is neither cw nor ccw";
      return p;
    }
    const Q sign(rot == "cw" ? 1 : -1);
    p.start_heading = heading("dirStart");
    p.end_heading = heading("dirEnd");
    if (e.type == "Curve") {
      const auto k = curvature(e, "radius", sign);
      if (k) p.k0 = p.k1 = *k;
      // at right angles to the radius
      const auto tangent = [&](const std::vector<Q>* point) -> std::optional<GC::Heading> {
        const auto radius = between(centre, point);
        if (!radius) return std::nullopt;
        return radius->turned(Q(0), sign);
      };
      if (!p.start_heading) p.start_heading = tangent(start);
      if (!p.end_heading) p.end_heading = tangent(end);
      if (!attribute(e, "radius") && centre != nullptr) { // it is the distance from the centre
        if (start != nullptr) p.root0 = curvature_about(*centre, *start, sign);
        if (end != nullptr) p.root1 = curvature_about(*centre, *end, sign);
        p.k0 = rounded(p.root0, p.rounded);
        p.k1 = rounded(p.root1, p.rounded);
      }
      if (start != nullptr && p.start_heading && p.k0 && length)
        p.computed_end = GC::Clothoid_segment((*start)[0], (*start)[1], *p.start_heading, *p.k0, *p.k0, *length).end();
      return p;
    }
    p.k0 = curvature(e, "radiusStart", sign);
    p.k1 = curvature(e, "radiusEnd", sign);
    if (!p.start_heading) p.start_heading = between(start, apex);
    if (!p.end_heading) p.end_heading = between(apex, end);
    const std::string type = attribute(e, "spiType").value_or("clothoid");
    typedef GC::Curvature_law Law;
    const std::optional<Law> law = type == "clothoid"      ? std::optional<Law>(Law::linear())
                                   : type == "bloss"       ? std::optional<Law>(Law::bloss())
                                   : type == "cosine"      ? std::optional<Law>(Law::cosine_curve())
                                   : type == "sinusoid"    ? std::optional<Law>(Law::sine_curve())
                                   : type == "weinerBogen" ? std::optional<Law>(Law::viennese_bend())
                                                           : std::nullopt;
    if (!law)
      p.not_covered = "a spiral of the type " + GC::quoted_token(type);
    else if (start != nullptr && p.start_heading && p.k0 && p.k1 && length)
      p.computed_end =
          GC::Clothoid_segment((*start)[0], (*start)[1], *p.start_heading, Law::between(*p.k0, *p.k1, *law), *length)
              .end();
    return p;
  }

  // ---- checks

  Rail_check check(const std::string& kind, const std::string& place, const Element& e, int claimed) const {
    Rail_check c;
    c.kind = kind;
    c.curve = "Alignment " + alignment_;
    c.place = place;
    c.line = e.line;
    c.claimed = claimed;
    return c;
  }
  static std::string name(const Element& e, std::size_t i) { return e.type + " " + std::to_string(i + 1); }

  // The difference of a root and a number.
  static void set_difference(Rail_check& c, const std::string& quantity, const Q& a, const Q& square) {
    c.difference = {quantity, Q(0), false, std::nullopt};
    if (const auto root = GC::rational_square_root(square)) {
      c.difference->value = Q(a - *root);
      return;
    }
    const GC::Enclosure root_of = GC::sqrt_enclosure(square);
    if (std::isfinite(root_of.upper) && std::isfinite(CGAL::to_double(a)))
      c.difference->enclosed =
          GC::Enclosure{GC::enclosure(Q(a - Q(root_of.upper))).lower, GC::enclosure(Q(a - Q(root_of.lower))).upper};
    else {
      c.difference = std::nullopt;
      c.not_covered = "a number beyond those of floating-point numbers";
    }
  }

  // The difference of two roots, (a - b) / (sqrt(a) + sqrt(b)).
  static void set_difference_of_roots(Rail_check& c, const std::string& quantity, const Q& a, const Q& b) {
    const GC::Enclosure x = GC::sqrt_enclosure(a), y = GC::sqrt_enclosure(b);
    if (!std::isfinite(x.upper) || !std::isfinite(y.upper)) {
      c.not_covered = "a number beyond those of floating-point numbers";
      return;
    }
    c.difference = {quantity, Q(0), false, std::nullopt};
    if (a == b) return;
    const Q rise = Q(a < b ? b - a : a - b), least = Q(Q(x.lower) + Q(y.lower)), most = Q(Q(x.upper) + Q(y.upper));
    c.difference->enclosed = GC::Enclosure{GC::enclosure(Q(rise / most)).lower, GC::enclosure(Q(rise / least)).upper};
  }

  // The radius of a curve is the distance of its ends from its centre.
  void check_radius(const Element& e, std::size_t i) {
    const auto centre = e.points.find("Center");
    const auto text = attribute(e, "radius");
    if (e.type != "Curve" || centre == e.points.end()) return;
    const auto start = e.points.find("Start"), end = e.points.find("End");
    if (!text) { // both distances are the radius
      if (start == e.points.end() || end == e.points.end()) return;
      Rail_check c = check("radius", name(e, i) + ", Start and End", e, 0);
      set_difference_of_roots(c, "radius", squared_distance(centre->second, start->second),
                              squared_distance(centre->second, end->second));
      result_.checks.push_back(std::move(c));
      return;
    }
    for (const auto& point : {start, end}) {
      if (point == e.points.end()) continue;
      Rail_check c = check("radius", name(e, i) + ", " + point->first, e, 0);
      set_difference(c, "radius", number(*text), squared_distance(centre->second, point->second));
      result_.checks.push_back(std::move(c));
    }
  }

  // The end that is computed against the end that is declared. A line of two points says nothing
  // twice, nor does a curve of three without a length but what check_radius() compares.
  void check_end(const Element& e, std::size_t i, const Piece& p) {
    const bool has_length = attribute(e, "length").has_value();
    if (e.type == "Line" && !has_length) return;
    if (e.type == "Curve" && !has_length && p.not_covered.empty() && p.start && p.end && p.start_heading &&
        p.end_heading)
      return;
    Rail_check c = check("declared end", name(e, i), e, p.end_heading ? 1 : 0);
    if (!p.not_covered.empty())
      c.not_covered = p.not_covered;
    else if (!p.computed_end || !p.end)
      c.not_covered = "an element without what its end follows from";
    else {
      GC::Alignment_end declared = *p.computed_end;
      declared.point = *p.end;
      if (p.end_heading) declared.heading = *p.end_heading;
      c.ends = {*p.computed_end, declared};
      c.rounded = p.rounded;
    }
    result_.checks.push_back(std::move(c));
  }

  // The angle of a curve, which follows from its length and its radius.
  void check_delta(const Element& e, std::size_t i, const Piece& p) {
    const auto length = attribute(e, "length"), text = attribute(e, "delta");
    if (e.type != "Curve" || !p.k0 || !length || !text || !p.not_covered.empty()) return;
    Rail_check c = check("delta", name(e, i), e, 0);
    const Q turn = Q(*p.k0 * number(*length)), delta = angle(*text, angles_, c.rounded);
    if (p.root0 && !p.root0->rational()) c.rounded = true;
    c.difference = {"delta", Q((delta < 0 ? Q(-delta) : delta) - (turn < 0 ? Q(-turn) : turn)), true, std::nullopt};
    result_.checks.push_back(std::move(c));
  }

  // The angle and the constant of a spiral, which follow from its length and its radii.
  void check_spiral(const Element& e, std::size_t i, const Piece& p) {
    const auto length = attribute(e, "length");
    if (e.type != "Spiral" || !p.k0 || !p.k1 || !length || !p.not_covered.empty()) return;
    const Q l = number(*length);
    if (const auto text = attribute(e, "theta")) {
      Rail_check c = check("theta", name(e, i), e, 0);
      const Q turn = Q((*p.k0 + *p.k1) * l / 2);
      c.difference = {"theta", Q(angle(*text, angles_, c.rounded) - (turn < 0 ? Q(-turn) : turn)), true, std::nullopt};
      result_.checks.push_back(std::move(c));
    }
    const auto constant = attribute(e, "constant");
    const Q jump = Q(*p.k1 - *p.k0), rate = jump < 0 ? Q(-jump) : jump;
    if (!constant || rate == 0) return;
    Rail_check c = check("constant", name(e, i), e, 0);
    const Q a = number(*constant), square = Q(l / rate); // A^2 = L R
    set_difference(c, "constant", a, square);
    result_.checks.push_back(std::move(c));
  }

  // Gives points their coordinates that only name another point.
  void look_up(Element& e) {
    for (const auto& [type, name] : e.references) {
      const auto found = named_points_.find(name);
      if (e.points.count(type) != 0) continue;
      if (found != named_points_.end())
        e.points[type] = found->second;
      else
        ++references_;
    }
  }

  // The length of an alignment is the sum of those of its elements.
  void check_sum(const std::optional<std::string>& declared) {
    if (!declared || elements_.empty()) return;
    Q sum(-number(*declared));
    for (const Element& e : elements_) {
      const auto length = attribute(e, "length");
      if (!length) return;
      sum = Q(sum + number(*length));
    }
    Rail_check c = check("length", "whole", elements_.front(), 0);
    c.difference = {"length", sum, false, std::nullopt};
    result_.checks.push_back(std::move(c));
  }

  static std::string name(const Profile_point& p, std::size_t i) { return p.type + ' ' + std::to_string(i + 1); }

  // The gradient from one point of a profile to the next one.
  static std::optional<Q> gradient(const Profile_point& p, const Profile_point& next) {
    if (!p.station || !next.station || !(*p.station < *next.station)) return std::nullopt;
    const Q g = Q((*next.height - *p.height) / (*next.station - *p.station));
    if (!(std::fabs(CGAL::to_double(g)) < 1e140)) return std::nullopt;
    return g;
  }

  // How far an arc reaches: with the angle d between the gradients its tangents have the length
  // R tan(d / 2), which is shorter seen from above. Its length is R d, or that seen from above:
  // both are written, and the closer one counts. Returns why nothing is known.
  std::string place_arc(Profile_text& profile, std::size_t i) {
    Profile_point& p = profile.points[i];
    if (i == 0 || i + 1 == profile.points.size()) return "an arc at the end of a profile";
    const std::optional<Q> g0 = gradient(profile.points[i - 1], p), g1 = gradient(p, profile.points[i + 1]);
    if (!g0 || !g1) return "an arc between points that are not one behind the other";
    if (!p.radius || *p.radius == 0) return "an arc without a radius";
    const Q radius = *p.radius < 0 ? Q(-*p.radius) : *p.radius, root0 = long_root(Q(1 + *g0 * *g0)),
            root1 = long_root(Q(1 + *g1 * *g1)), turn = Q(*g1 < *g0 ? *g0 - *g1 : *g1 - *g0),
            tangent = Q(radius * turn / (root0 * root1 + 1 + *g0 * *g1));
    p.in = Q(tangent / root0);
    p.out = Q(tangent / root1);
    p.rounded = true;
    if (!p.length) return "";
    Element at;
    at.line = p.line;
    Rail_check c = check("arc length", name(p, i), at, 0);
    const GC::Enclosure angle = GC::Heading(Q(0), Q(1 + *g0 * *g1), turn).enclosure();
    const GC::Enclosure along{GC::enclosure(Q(*p.length - radius * Q(angle.upper))).lower,
                              GC::enclosure(Q(*p.length - radius * Q(angle.lower))).upper},
        above = GC::enclosure(Q(*p.length - p.in - p.out));
    const auto size = [](const GC::Enclosure& e) { return std::fabs(e.lower / 2 + e.upper / 2); };
    c.difference = {"arc length", Q(0), false, size(above) < size(along) ? above : along};
    c.rounded = true;
    result_.checks.push_back(std::move(c));
    return "";
  }

  // Vertical curves meet the gradients between them one behind the other.
  void check_profile(Profile_text& profile) {
    alignment_ = profile.name;
    std::vector<std::string> unknown(profile.points.size());
    for (std::size_t i = 0; i < profile.points.size(); ++i)
      if (profile.points[i].type == "CircCurve") unknown[i] = place_arc(profile, i);
    if (profile.points.size() > 1) ++result_.curves;
    for (std::size_t i = 0; i + 1 < profile.points.size(); ++i) {
      const Profile_point &p = profile.points[i], &next = profile.points[i + 1];
      Element at;
      at.line = next.line;
      Rail_check c = check("profile", name(p, i) + " - " + name(next, i + 1), at, 0);
      if (!unknown[i].empty() || !unknown[i + 1].empty())
        c.not_covered = unknown[i].empty() ? unknown[i + 1] : unknown[i];
      else if (!p.station || !next.station)
        c.not_covered = "a point of a profile without station";
      else {
        const Q overlap = Q(p.out + next.in - (*next.station - *p.station));
        c.rounded = (p.rounded || next.rounded) && overlap > Q(-1e-30);
        c.difference = {"overlap", overlap > 0 ? overlap : Q(0), false, std::nullopt};
      }
      result_.checks.push_back(std::move(c));
    }
  }

  // The curvatures of all spirals that are read only rise or only fall.
  void add_piece(const Element& e, std::size_t i, const Piece& p) {
    Rail_piece piece{"horizontal", "Alignment " + alignment_, name(e, i), e.line, e.type};
    piece.rounded = p.rounded;
    const std::optional<Q> k0 = e.type == "Line" ? Q(0) : p.k0, k1 = e.type == "Line" ? Q(0) : p.k1;
    if (!p.not_covered.empty())
      piece.not_covered = p.not_covered;
    else if (!k0 || !k1)
      piece.not_covered = "an element without a radius";
    else {
      piece.geometry.emplace();
      piece.geometry->shape = GC::Road_shape::spiral;
      piece.geometry->parameters = {*k0, *k1};
    }
    result_.pieces.push_back(std::move(piece));
  }

  void decide(Alignment_text& plan) {
    alignment_ = plan.name;
    elements_ = std::move(plan.elements);
    for (Element& e : elements_) look_up(e);
    if (!elements_.empty()) ++result_.curves;
    std::optional<Piece> before;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const Element& e = elements_[i];
      Piece p = piece(e);
      if (before) {
        const Element& last = elements_[i - 1];
        const std::optional<GC::Heading> left = before->end_heading, right = p.start_heading;
        Rail_check c = check("horizontal", name(last, i - 1) + " - " + name(e, i), last, left && right ? 1 : 0);
        const auto curvature = [](const std::optional<GC::End_curvature>& root, const std::optional<Q>& k) {
          return root ? root : k ? std::optional<GC::End_curvature>(GC::End_curvature(*k)) : std::nullopt;
        };
        if (before->end && p.start) {
          const GC::Heading heading = left && right ? *left : GC::Heading();
          c.ends = {GC::Alignment_end{*before->end, heading, curvature(before->root1, before->k1)},
                    GC::Alignment_end{*p.start, left && right ? *right : heading, curvature(p.root0, p.k0)}};
          c.rounded = before->rounded || p.rounded;
        } else
          c.not_covered = "an element without start or end";
        result_.checks.push_back(std::move(c));
      }
      add_piece(e, i, p);
      check_end(e, i, p);
      check_spiral(e, i, p);
      check_delta(e, i, p);
      check_radius(e, i);
      before = std::move(p);
    }
    check_sum(plan.length);
  }

public:
  explicit Landxml_reader(const std::string& name) : Xml_reader(name) {}

  Rail_file rails(std::istream& stream) {
    read(stream);
    result_.precision = Q(Q(1) / 1000);
    for (Alignment_text& plan : plans_) decide(plan);
    for (Profile_text& profile : profiles_) check_profile(profile);
    if (references_ > 0)
      result_.notes.push_back("points without coordinates, of which there are " + std::to_string(references_) +
                              ", name none that is in the file");
    for (const std::string& type : skipped_) result_.notes.push_back("elements " + type + " are not decided");
    return std::move(result_);
  }
};

} // namespace

Rail_file read_landxml(std::istream& stream, const std::string& name) { return Landxml_reader(name).rails(stream); }

Rail_file read_landxml(const std::string& file) {
  Input stream(file);
  return read_landxml(stream, input_name(file));
}

bool begins_as_landxml(std::string_view text) {
  for (std::size_t i = text.find("LandXML"); i != std::string_view::npos; i = text.find("LandXML", i + 1))
    if (i > 0 && (text[i - 1] == '<' || text[i - 1] == ':')) return true; // not in a DOCTYPE
  return false;
}

bool is_landxml_file(const std::string& file) {
  const std::string beginning = beginning_of_text(file);
  if (begins_as_landxml(beginning)) return true;
  const bool is_xml = beginning.rfind("<?xml", 0) == 0 || beginning.rfind("<!", 0) == 0;
  return is_xml && begins_as_landxml(Input(file).beginning(4096));
}
