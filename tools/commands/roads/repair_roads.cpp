// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/roads/repair_roads.h"

#include "commands/roads/Road_claims.h"
#include "formats/opendrive/read_opendrive.h"
#include "reports/Conclusion.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/blends/clothoid_blend.h>
#include <CGAL/Geometric_continuity/models/Road_network.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef GC::Road_number Number;

constexpr double full_turn = 2 * 3.14159265358979324;

// A number as it is written into the file: the shortest decimal of the closest floating-point
// number.
std::string decimal_of(double x) {
  char text[40];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}
std::string decimal_of(const GC::Enclosure& x) { return decimal_of(x.lower / 2 + x.upper / 2); }

// A change of the text: the bytes from `begin` to `end` are replaced.
struct Text_change {
  std::size_t begin, end;
  std::string text;
};

class Road_repairer {
  const std::string& text_;
  const Road_repair& repair_;
  const Opendrive_file file_;
  std::vector<Text_change> changes_;
  std::set<std::pair<std::string, GC::Road_end>> named_; // ends to which something leads

public:
  // Repairs that were made and joins that were left, as lines and as JSON objects.
  struct Line {
    std::string text, json;
  };
  std::vector<Line> done, left;
  std::size_t moved = 0, blended = 0;

  Road_repairer(const std::string& text, const std::string& name, const Road_repair& repair)
      : text_(text), repair_(repair), file_(read(text, name)) {
    for (const GC::Road& road : file_.network.roads)
      for (const GC::Road_link* const link : {&road.predecessor, &road.successor})
        if (link->target == GC::Road_link::Target::road) {
          if (link->contact) named_.emplace(link->id, *link->contact);
          if (link->at) name_both(link->id);
        }
    for (const GC::Road_junction& junction : file_.network.junctions)
      for (const GC::Road_connection& c : junction.connections) {
        name_both(c.incoming);
        if (c.contact) named_.emplace(c.connecting, *c.contact);
      }
  }

  static Opendrive_file read(const std::string& text, const std::string& name) {
    std::istringstream stream(text);
    return read_opendrive(stream, name);
  }

  const GC::Road_network& network() const { return file_.network; }

  std::string result() {
    for (std::size_t i = 0; i < file_.network.roads.size(); ++i) repair(i);
    std::sort(changes_.begin(), changes_.end(),
              [](const Text_change& x, const Text_change& y) { return x.begin < y.begin; });
    std::string result;
    std::size_t begin = 0;
    for (const Text_change& change : changes_) {
      result.append(text_, begin, change.begin - begin);
      result += change.text;
      begin = change.end;
    }
    return result.append(text_, begin, std::string::npos);
  }

private:
  void name_both(const std::string& id) {
    named_.emplace(id, GC::Road_end::start);
    named_.emplace(id, GC::Road_end::end);
  }

  static Number exact(double x) {
    if (!std::isfinite(x)) throw GC::Error(GC::Error_code::not_finite, "a number beyond floating-point numbers");
    return Number(x);
  }

  // A piece of a road with the numbers that it gets.
  struct Piece {
    GC::Road_geometry geometry;
    bool is_moved = false, is_blended = false;
    std::string blend; // the elements that replace it
  };

  static GC::Alignment_end end(const GC::Road_geometry& g, bool at_end) {
    return GC::alignment_end(g, at_end ? GC::Road_end::end : GC::Road_end::start);
  }

  // The difference of two directions that are nearly equal, rounded.
  static double turn(const GC::Heading& from, const GC::Heading& to) {
    const GC::Enclosure a = from.enclosure(), b = to.enclosure();
    const Number difference = Number(to.angle() - from.angle());
    const bool is_rational = from.is_exact() && to.is_exact() && from.vector() == std::pair<Number, Number>(1, 0) &&
                             to.vector() == std::pair<Number, Number>(1, 0);
    const double x = is_rational ? CGAL::to_double(difference) : (b.lower + b.upper) / 2 - (a.lower + a.upper) / 2;
    return std::remainder(x, full_turn);
  }

  // Moves a piece so that its start lies at an end.
  void move_start(Piece& piece, const GC::Alignment_end& to) {
    GC::Road_geometry& g = piece.geometry;
    const double by = turn(end(g, false).heading, to.heading);
    if (by != 0) g.heading = exact(std::strtod(decimal_of(CGAL::to_double(g.heading) + by).c_str(), nullptr));
    place(piece, to.point, false);
  }

  // Moves a piece so that its end lies at a start.
  void move_end(Piece& piece, const GC::Alignment_end& to) {
    GC::Road_geometry& g = piece.geometry;
    const double by = turn(end(g, true).heading, to.heading);
    if (by != 0) g.heading = exact(CGAL::to_double(g.heading) + by);
    place(piece, to.point, true);
  }

  static void place(Piece& piece, const GC::Enclosed_point& to, bool at_end) {
    GC::Road_geometry& g = piece.geometry;
    g.x = g.y = Number(0);
    const std::array<GC::Enclosure, 2> there = to.enclosure(), here = end(g, at_end).point.enclosure();
    const auto middle = [](const GC::Enclosure& x) { return Number((exact(x.lower) + exact(x.upper)) / 2); };
    g.x = exact(CGAL::to_double(Number(middle(there[0]) - middle(here[0]))));
    g.y = exact(CGAL::to_double(Number(middle(there[1]) - middle(here[1]))));
    piece.is_moved = true;
  }

  GC::Alignment_join join(const Piece& before, const Piece& after) const {
    return GC::alignment_join(end(before.geometry, true), end(after.geometry, false), repair_.demand.tolerance);
  }
  static bool is_met(const GC::Alignment_join& join) {
    return join.g0 == GC::Verdict::proved && join.g1 == GC::Verdict::proved;
  }
  bool is_near(const GC::Alignment_join& join) const {
    return join.gap.upper <= repair_.max_move && join.kink.upper <= repair_.max_kink;
  }

  void tell(std::vector<Line>& lines, const GC::Road& road, const GC::Road_geometry& g, const GC::Alignment_join& join,
            const std::string& what) const {
    const std::string s = road_words::decimal(g.s);
    lines.push_back({"road " + road.id + ", s = " + s + (g.line > 0 ? " (line " + std::to_string(g.line) + ")" : "") +
                         ": gap " + road_words::size(join.gap, " m") + ", kink " + road_words::size(join.kink, " rad") +
                         ": " + what,
                     "{\"road\":" + json_text(road.id) + ",\"s\":" + s + ",\"line\":" + std::to_string(g.line) +
                         ",\"gap\":" + road_words::json(join.gap) + ",\"kink\":" + road_words::json(join.kink) +
                         ",\"what\":" + json_text(what) + '}'});
  }

  bool is_free(const GC::Road& road, GC::Road_end end) const {
    const GC::Road_link& link = end == GC::Road_end::start ? road.predecessor : road.successor;
    return link.target == GC::Road_link::Target::none && named_.count({road.id, end}) == 0;
  }

  void repair(std::size_t number) {
    const GC::Road& road = file_.network.roads[number];
    std::vector<Piece> pieces;
    for (const GC::Road_geometry& g : road.plan) pieces.push_back({g, false, false, {}});
    const auto is_before = [](const Piece& x, const Piece& y) { return x.geometry.s < y.geometry.s; };
    if (!std::is_sorted(pieces.begin(), pieces.end(), is_before)) return;
    const bool backwards = !is_free(road, GC::Road_end::end) && is_free(road, GC::Road_end::start);
    for (std::size_t k = 1; k < pieces.size(); ++k) repair(road, pieces, backwards ? pieces.size() - k : k);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].is_blended)
        replace(number, i, pieces[i]);
      else if (pieces[i].is_moved)
        rewrite(number, i, pieces[i].geometry);
  }

  void repair(const GC::Road& road, std::vector<Piece>& pieces, std::size_t i) {
    if (pieces[i - 1].is_blended || pieces[i].is_blended) return; // the blend leads there
    try {
      const GC::Alignment_join found = join(pieces[i - 1], pieces[i]);
      if (is_met(found)) return;
      const GC::Road_geometry& g = pieces[i].geometry;
      if (!is_near(found)) return tell(left, road, g, found, "left, farther apart than may be moved");
      if (is_free(road, GC::Road_end::end)) {
        for (std::size_t k = i; k < pieces.size(); ++k)
          if (k == i || !is_met(join(pieces[k - 1], pieces[k])))
            move_start(pieces[k], end(pieces[k - 1].geometry, true));
          else
            break;
        ++moved;
        return tell(done, road, g, found, "moved to the end before");
      }
      if (is_free(road, GC::Road_end::start)) {
        for (std::size_t k = i; k-- > 0;)
          if (k + 1 == i || !is_met(join(pieces[k], pieces[k + 1])))
            move_end(pieces[k], end(pieces[k + 1].geometry, false));
          else
            break;
        ++moved;
        return tell(done, road, g, found, "the piece before moved there");
      }
      blend(road, pieces, i, found);
    } catch (const GC::Error& e) {
      left.push_back({"road " + road.id + ", s = " + road_words::decimal(pieces[i].geometry.s) + ": left, " + e.what(),
                      "{\"road\":" + json_text(road.id) + ",\"s\":" + road_words::decimal(pieces[i].geometry.s) +
                          ",\"what\":" + json_text(std::string(e.what())) + '}'});
    }
  }

  // Both ends of the road are fixed: the longer one of the two pieces becomes three clothoids.
  void blend(const GC::Road& road, std::vector<Piece>& pieces, std::size_t i, const GC::Alignment_join& found) {
    const auto may_change = [](const Piece& p) {
      return !GC::is_polynomial(p.geometry) && !p.is_blended && !p.is_moved;
    };
    const bool before = may_change(pieces[i - 1]), after = may_change(pieces[i]);
    const bool takes_before = before && (!after || pieces[i].geometry.length < pieces[i - 1].geometry.length);
    if (!before && !after) return tell(left, road, pieces[i].geometry, found, "left, no piece can be blended there");
    Piece& piece = pieces[takes_before ? i - 1 : i];
    const GC::Clothoid_segment whole = GC::clothoid_segment(piece.geometry, piece.geometry.length);
    GC::Alignment_end from = whole.start(), to = whole.end();
    if (takes_before) { // its own curvatures, so that it changes as little as may be
      const GC::Alignment_end next = end(pieces[i].geometry, false);
      to.point = next.point;
      to.heading = next.heading;
    } else {
      const GC::Alignment_end last = end(pieces[i - 1].geometry, true);
      from.point = last.point;
      from.heading = last.heading;
      if (i + 1 < pieces.size() && is_near(join(piece, pieces[i + 1]))) { // which closes that gap, too
        const GC::Alignment_end next = end(pieces[i + 1].geometry, false);
        to.point = next.point;
        to.heading = next.heading;
      }
    }
    const GC::Clothoid_blend blend = GC::clothoid_blend(from, to);
    Number length(0);
    for (const GC::Clothoid_segment& s : blend.segments) length = Number(length + s.length());
    const double longer = CGAL::to_double(Number(length - piece.geometry.length));
    if (std::fabs(longer) > 2 * found.gap.upper + found.kink.upper * CGAL::to_double(piece.geometry.length) + 1e-6)
      return tell(left, road, pieces[i].geometry, found,
                  "left, a blend would change the length by " + rounded(longer, 4) + " m");
    for (const GC::Alignment_join& j : blend.joins)
      if (!(j.gap.upper <= 1e-9 && j.kink.upper <= 1e-9))
        return tell(left, road, pieces[i].geometry, found, "left, a blend does not meet the ends");
    piece.is_blended = true;
    piece.blend = elements(piece.geometry, blend);
    ++blended;
    tell(done, road, pieces[i].geometry, found,
         std::string(takes_before ? "the piece before" : "the piece behind") +
             " becomes three clothoids, G2 proved; its length changes by " + rounded(longer, 3) + " m");
  }

  // The numbers of a blend, as they are written.
  static std::string elements(const GC::Road_geometry& g, const GC::Clothoid_blend& blend) {
    std::string text;
    Number s = g.s;
    for (std::size_t i = 0; i < 3; ++i) {
      const GC::Clothoid_segment& c = blend.segments[i];
      const std::array<GC::Enclosure, 2> p = c.start_point().enclosure();
      const GC::Enclosure h = c.start_heading().enclosure();
      const double turns = std::nearbyint((CGAL::to_double(g.heading) - h.lower) / full_turn); // as the file counts
      text += "s=\"" + road_words::decimal(s) + "\" x=\"" + decimal_of(p[0]) + "\" y=\"" + decimal_of(p[1]) +
              "\" hdg=\"" + decimal_of({h.lower + turns * full_turn, h.upper + turns * full_turn}) + "\" length=\"" +
              road_words::decimal(c.length()) + "\"|<spiral curvStart=\"" + road_words::decimal(c.start_curvature()) +
              "\" curvEnd=\"" + road_words::decimal(c.end_curvature()) + "\"/>|";
      s = Number(s + c.length());
    }
    return text;
  }

  // The value of an attribute in the tag of a geometry.
  std::pair<std::size_t, std::size_t> value(const Opendrive_file::Geometry_text& place, const std::string& name) const {
    std::size_t i = place.begin;
    while (i < place.tag_end) {
      i = text_.find_first_of(" \t\r\n", i);
      i = text_.find_first_not_of(" \t\r\n", i);
      if (i == std::string::npos || i >= place.tag_end) break;
      const std::size_t equals = text_.find('=', i), quote = text_.find_first_of("'\"", equals),
                        close = text_.find(text_[quote], quote + 1);
      const std::string key = text_.substr(i, text_.find_first_of(" \t\r\n=", i) - i);
      if (key == name) return {quote + 1, close};
      i = close + 1;
    }
    throw std::logic_error("a geometry without " + name);
  }

  void set(const Opendrive_file::Geometry_text& place, const std::string& name, const std::string& number) {
    const auto [begin, end] = value(place, name);
    const auto parsed = [](const std::string& digits) {
      const std::size_t first = digits.find_first_not_of(" \t\r\n"), last = digits.find_last_not_of(" \t\r\n");
      return GC::parse_number<Number>(digits.substr(first, last + 1 - first));
    };
    if (parsed(text_.substr(begin, end - begin)) != parsed(number)) changes_.push_back({begin, end, number});
  }

  // Writes where a piece has moved to.
  void rewrite(std::size_t road, std::size_t i, const GC::Road_geometry& g) {
    const Opendrive_file::Geometry_text& place = file_.texts[road][i];
    set(place, "x", road_words::decimal(g.x));
    set(place, "y", road_words::decimal(g.y));
    set(place, "hdg", road_words::decimal(g.heading));
  }

  // Writes three clothoids in place of a piece: the first one into its element, the others behind
  // it.
  void replace(std::size_t road, std::size_t i, const Piece& piece) {
    const Opendrive_file::Geometry_text& place = file_.texts[road][i];
    std::vector<std::string> parts;
    for (std::size_t begin = 0, bar; (bar = piece.blend.find('|', begin)) != std::string::npos; begin = bar + 1)
      parts.push_back(piece.blend.substr(begin, bar - begin));
    std::istringstream first(parts[0]);
    for (std::string word; first >> word;) {
      const std::size_t equals = word.find('=');
      const std::string name = word.substr(0, equals);
      if (name != "s") set(place, name, word.substr(equals + 2, word.size() - equals - 3));
    }
    const std::string tag =
                          text_.substr(place.begin + 1, text_.find_first_of(" \t\r\n", place.begin) - place.begin - 1),
                      prefix = tag.substr(0, tag.find(':') == std::string::npos ? 0 : tag.find(':') + 1);
    const auto shape = [&](std::string text) { return text.insert(1, prefix); };
    changes_.push_back({place.shape_begin, place.shape_end, shape(parts[1])});
    const std::size_t line = text_.find_last_not_of(" \t", place.begin - 1);
    const std::string space =
        line != std::string::npos && text_[line] == '\n' ? text_.substr(line, place.begin - line) : std::string();
    std::string more;
    for (std::size_t k = 2; k < 6; k += 2)
      more += space + '<' + tag + ' ' + parts[k] + '>' + shape(parts[k + 1]) + "</" + tag + '>';
    changes_.push_back({place.end, place.end, more});
  }
};

// Counts the claims about a network that are not met, by kind, and classes those of plan joins.
struct Claim_counter {
  const Road_claims say;
  std::map<std::string, std::size_t>& counts;
  Claims& claims;
  void operator()(const GC::Road_remark&) const {}
  template <class Join> void operator()(const Join& join) const {
    const Road_claim claim = say(join);
    counts[claim.kind] += claim.given.claim == Claim::not_met;
    if (claim.kind == "plan") claims.add(claim.given);
  }
};

std::map<std::string, std::size_t> not_met(const GC::Road_network& network, const Road_demand& demand, Claims& claims) {
  std::map<std::string, std::size_t> counts;
  GC::road_joins(network, demand.tolerance, Claim_counter{Road_claims(demand), counts, claims});
  return counts;
}

std::string counts_text(const std::map<std::string, std::size_t>& counts) {
  std::string text;
  for (const auto& [kind, n] : counts)
    if (n > 0) text += (text.empty() ? "" : ", ") + std::to_string(n) + ' ' + kind;
  return text.empty() ? "none" : text;
}

std::string counts_json(const std::map<std::string, std::size_t>& counts) {
  std::string text;
  for (const auto& [kind, n] : counts)
    if (n > 0) text += (text.empty() ? "" : ",") + json_text(kind) + ':' + std::to_string(n);
  return '{' + text + '}';
}

std::string array_of(const std::vector<Road_repairer::Line>& lines) {
  std::vector<std::string> objects;
  for (const Road_repairer::Line& line : lines) objects.push_back("\n " + line.json);
  return json_array(objects);
}

} // namespace

std::string repaired_roads(const std::string& text, const std::string& name, const Road_repair& repair,
                           const Report_mode& mode, std::ostream& os, int& exit_code) {
  if (text.find('\0') != std::string::npos)
    throw GC::Error(GC::Error_code::malformed_input, name + ": not in UTF-8; write it so first, e.g. with iconv");
  Road_repairer repairer(text, name, repair);
  Claims before_claims, claims;
  const auto before = not_met(repairer.network(), repair.demand, before_claims);
  const std::string result = repairer.result();
  const Opendrive_file again = Road_repairer::read(result, name);
  const auto after = not_met(again.network, repair.demand, claims);
  const Report_subject subject{"join", "every join of reference lines", "free of gaps and kinks",
                               {},     "proved on what is written",     {}};
  const Conclusion end(claims, mode, subject);
  if (mode.format == Report_format::json) {
    os << "{\"repaired\":" << array_of(repairer.done) << ",\n \"left\":" << array_of(repairer.left)
       << ",\n \"not_met_before\":" << counts_json(before) << ",\"not_met_after\":" << counts_json(after)
       << ",\n \"summary\":{\"joins\":" << claims.given() << ",\"moved\":" << repairer.moved
       << ",\"blended\":" << repairer.blended << "},\n " << end.json() << "}\n";
  } else {
    for (const auto& line : repairer.done) os << GC::printable(line.text) << '\n';
    for (const auto& line : repairer.left) os << GC::printable(line.text) << '\n';
    os << counted(repairer.moved, "start") << " moved, " << counted(repairer.blended, "piece")
       << " replaced by clothoids\n"
       << "not met before: " << counts_text(before) << "; after: " << counts_text(after) << '\n'
       << end.text();
  }
  exit_code = end.exit_code();
  return result;
}
