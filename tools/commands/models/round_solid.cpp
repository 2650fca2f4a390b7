// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/round_solid.h"

#include "commands/models/exact_models.h"
#include "commands/models/model_json.h"
#include "files/output.h"
#include "formats/cad/cad_file.h"
#include "formats/cad/write_cad.h"
#include "formats/shapes/write_shapes.h"
#include "formats/solids/Rounded_outlines.h"
#include "formats/solids/patches_of_solid.h"
#include "formats/solids/shell_of_solid.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

typedef Rounded_solid::Edge_kind Edge_kind;

// The edges of a solid by the numbers of round_polyhedron(), and by their names in the file.
class Solid_edges {
  std::vector<std::vector<std::size_t>> names_; // the numbers in the file
  std::map<std::string, std::size_t> by_text_;
  std::vector<std::pair<std::size_t, std::size_t>> faces_;
  const std::function<std::string(std::size_t)>& text_;

  static std::string plain(std::string text) {
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == ':'; }), text.end());
    return text;
  }

public:
  Solid_edges(const Solid& solid, const std::function<std::string(std::size_t)>& text) : text_(text) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
    for (std::size_t f = 0; f < solid.faces.size(); ++f)
      for (const Solid::Loop& loop : solid.faces[f].loops)
        for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
          const std::size_t a = loop.vertices[i], b = loop.vertices[(i + 1) % loop.vertices.size()];
          const auto [place, is_new] = known.emplace(std::minmax(a, b), names_.size());
          if (is_new) {
            names_.emplace_back();
            faces_.emplace_back(f, f);
          }
          std::vector<std::size_t>& names = names_[place->second];
          if (std::count(names.begin(), names.end(), loop.edges[i]) == 0) names.push_back(loop.edges[i]);
          faces_[place->second].second = f;
          by_text_.emplace(plain(text(loop.edges[i])), place->second);
        }
  }
  std::size_t size() const { return names_.size(); }
  const std::vector<std::size_t>& numbers(std::size_t edge) const { return names_[edge]; }
  // As `verify` names it, e.g. "7" or "0 u0 - 1 u0".
  std::string name(std::size_t edge) const {
    std::string all;
    for (std::size_t x : names_[edge]) all += (all.empty() ? "" : " - ") + text_(x);
    return all;
  }
  const std::pair<std::size_t, std::size_t>& faces(std::size_t edge) const { return faces_[edge]; }
  std::vector<std::size_t> find(const std::string& option, const std::string& word) const {
    const auto place = by_text_.find(plain(word));
    if (place == by_text_.end())
      throw std::invalid_argument("--" + option + ": there is no edge '" + word + "'; `verify` lists the edges, e.g. " +
                                  name(0));
    std::vector<std::size_t> all; // an edge in the file may have been divided
    for (std::size_t i = 0; i < names_.size(); ++i)
      for (std::size_t x : names_[i])
        if (plain(text_(x)) == plain(word)) all.push_back(i);
    return all;
  }
};

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0, end; begin <= list.size(); begin = end + 1) {
    end = (std::min)(list.find(',', begin), list.size());
    words.push_back(list.substr(begin, end - begin));
  }
  return words;
}

double kink(const Solid& solid, const std::pair<std::size_t, std::size_t>& faces) {
  const auto normal = [&](std::size_t f) {
    const std::vector<std::size_t>& v = solid.faces[f].loops[0].vertices;
    CGAL::Simple_cartesian<double>::Vector_3 sum(0, 0, 0);
    const auto at = [&](std::size_t i) {
      const Solid::Point& p = solid.vertices[v[i % v.size()]];
      return CGAL::Simple_cartesian<double>::Point_3(CGAL::to_double(p[0]), CGAL::to_double(p[1]),
                                                     CGAL::to_double(p[2]));
    };
    for (std::size_t i = 1; i + 1 < v.size(); ++i) sum = sum + CGAL::cross_product(at(i) - at(0), at(i + 1) - at(0));
    return sum;
  };
  const auto n = normal(faces.first), m = normal(faces.second);
  const auto x = CGAL::cross_product(n, m);
  return std::atan2(std::sqrt(x * x), n * m) * 180 / M_PI;
}

// The set-back of each edge, or 0; `kink(e)` is the angle of the normals. Edges without one have a
// set-back only where they are named.
template <class Find, class Kink>
std::vector<double> cuts_of(const Command_line& line, std::size_t size, const Find& find, const Kink& kink) {
  std::optional<double> all;
  std::map<std::size_t, double> some;
  for (const std::string& given : line.texts("set-back"))
    for (const std::string& word : words_of(given)) {
      const std::size_t equal = word.find('=');
      if (equal == std::string::npos)
        all = Command_line::positive_length("set-back", word);
      else
        for (std::size_t e : find("set-back", word.substr(0, equal)))
          some[e] = Command_line::positive_length("set-back", word.substr(equal + 1));
    }
  std::vector<double> cuts(size, line.has("edges") ? 0 : all.value_or(0));
  const double least = line.number<double>("min-kink", 0), greatest = line.number<double>("max-kink", 180);
  for (std::size_t e = 0; e < cuts.size(); ++e)
    if (cuts[e] > 0) {
      const double angle = kink(e);
      if (angle == 0 || angle < least || greatest < angle) cuts[e] = 0;
    }
  if (line.has("edges")) {
    if (!all && some.empty()) throw std::invalid_argument("--edges: --set-back R is needed with it");
    for (const std::string& word : words_of(line.text("edges")))
      for (std::size_t e : find("edges", word)) {
        if (!all && some.count(e) == 0)
          throw std::invalid_argument("--edges: the edge " + word + " has no set-back; give --set-back R");
        cuts[e] = all.value_or(0);
      }
  }
  for (const auto& [e, x] : some) cuts[e] = x;
  return cuts;
}

double fullness_of(const Command_line& line) {
  const std::string word = line.text("profile");
  if (word == "fair") return 0;
  double value = 0;
  try {
    value = line.number<double>("profile", 0);
  } catch (const std::exception&) { // no number is given
  }
  if (!(0 < value && value < 1))
    throw std::invalid_argument("--profile: '" + word + "' is neither fair nor a number between 0 and 1");
  return value;
}

struct Counts {
  std::size_t rails = 0, seams = 0, g2 = 0, sharp = 0, rounded = 0;
};

std::string kinds_text(const Counts& n) {
  std::string text = counted(n.rails, "rail");
  if (n.seams > 0) text += " and " + counted(n.seams, "seam");
  return text;
}

struct Result {
  Rounded_solid solid;
  std::vector<std::optional<GC::Parameter_rectangle<double>>> folds;
  std::vector<std::string> chains; // the names of the edges of each blend
  Counts counts;

  bool is_good() const {
    return counts.g2 == counts.rails + counts.seams &&
           std::none_of(folds.begin(), folds.end(), [](const auto& fold) { return fold.has_value(); });
  }
};

void write_text(std::ostream& os, const Result& r, const Solid& solid) {
  for (std::size_t i = 0; i < r.solid.blends.size(); ++i) {
    const Rounded_solid::Blend& b = r.solid.blends[i];
    os << "blend " << i << (b.closed ? ", closed" : "") << ": edge" << (b.edges.size() == 1 ? " " : "s ")
       << r.chains[i];
    if (r.folds[i])
      os << "; may be folded near (" << rounded(r.folds[i]->u.first, 4) << ", " << rounded(r.folds[i]->v.first, 4)
         << ')';
    os << '\n';
  }
  if (solid.largest_move > 0)
    os << "faces were not exactly plane: vertex " << solid.most_moved << " was moved by "
       << rounded(solid.largest_move, 3) << '\n';
  os << counted(r.solid.faces.size(), "plane face") << ", " << counted(r.counts.rounded, "edge") << " rounded by "
     << counted(r.solid.blends.size(), "blend") << ", 0 corners left open";
  if (r.counts.sharp > 0) os << "; " << counted(r.counts.sharp, "edge") << " left sharp";
  os << "\nclosed: ";
  if (r.counts.g2 == r.counts.rails + r.counts.seams)
    os << "G2 along all " << kinds_text(r.counts) << ", proved exactly\n";
  else
    os << "not G2 along " << r.counts.rails + r.counts.seams - r.counts.g2 << " of " << kinds_text(r.counts) << '\n';
}

void write_json(std::ostream& os, const Result& r, const Solid& solid) {
  os << "{\"blends\":[";
  for (std::size_t i = 0; i < r.solid.blends.size(); ++i) {
    const Rounded_solid::Blend& b = r.solid.blends[i];
    os << (i == 0 ? "\n" : ",\n") << "{\"edges\":";
    GC::write_json(os, r.chains[i]);
    os << ",\"closed\":" << boolean(b.closed) << ",\"possible_fold\":";
    if (r.folds[i])
      os << "{\"u\":[" << r.folds[i]->u.first << ',' << r.folds[i]->u.second << "],\"v\":[" << r.folds[i]->v.first
         << ',' << r.folds[i]->v.second << "]}}";
    else
      os << "null}";
  }
  os << "],\n\"open_corners\":[],\n\"summary\":{\"faces\":" << r.solid.faces.size()
     << ",\"blends\":" << r.solid.blends.size() << ",\"rounded\":" << r.counts.rounded
     << ",\"sharp\":" << r.counts.sharp << ",\"open_corners\":0,\"closed\":true,\"rails\":" << r.counts.rails
     << ",\"seams\":" << r.counts.seams << ",\"rails_and_seams_g2\":" << r.counts.g2
     << ",\"largest_move\":" << solid.largest_move << ",\"g2\":" << boolean(r.is_good()) << "}}\n";
}

Result rounded_planes(const Command_line& line, const Solid& solid, const Solid_edges& edges,
                      const std::vector<double>& cuts) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const Solid::Point& p : solid.vertices)
    points.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  std::vector<std::vector<std::vector<int>>> faces;
  for (const Solid::Face& face : solid.faces) {
    faces.emplace_back();
    for (const Solid::Loop& loop : face.loops) faces.back().emplace_back(loop.vertices.begin(), loop.vertices.end());
  }
  GC::Polyhedron_rounding_options options;
  options.fullness = fullness_of(line);
  options.edge_name = [&](std::size_t e) { return "edge " + edges.name(e); };
  Result r{GC::round_polyhedron(
               points, faces, [&](std::size_t e) { return cuts[e]; }, options),
           {},
           {},
           {}};
  const std::vector<int> orders = GC::edge_orders(r.solid);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const Edge_kind kind = r.solid.edges[i].kind;
    r.counts.rails += kind == Edge_kind::rail;
    r.counts.seams += kind == Edge_kind::seam;
    r.counts.sharp += kind == Edge_kind::sharp;
    r.counts.g2 += (kind == Edge_kind::rail || kind == Edge_kind::seam) && orders[i] == 2;
  }
  for (const Rounded_solid::Blend& b : r.solid.blends) {
    r.folds.push_back(GC::possible_fold(b.surface));
    std::string chain;
    for (std::size_t e : b.edges) chain += (chain.empty() ? "" : ", ") + edges.name(e);
    r.chains.push_back(chain);
    r.counts.rounded += b.edges.size();
  }
  return r;
}

// The edges of a solid with outlines, by their numbers in the file.
class Outlined_edges {
  std::vector<double> kinks_; // 0 where two walls join smoothly

public:
  Outlined_edges(const Outlined_solid& solid, const Solid_edges& straight) : kinks_(solid.given.edges.size(), 0) {
    for (const Outlined_solid::Outline& outline : solid.outlines)
      for (std::size_t i = 0; i < outline.rims.size(); ++i) {
        const Outlined_solid::Rim& next = outline.rims[(i + 1) % outline.rims.size()];
        kinks_[solid.edge_of(outline.rims[i])] = 90;
        const auto [s, t] = solid.tangents(outline.rims[i], next);
        const auto across = cross_product(s, t);
        const double angle = std::atan2(std::sqrt(dot(across, across)), dot(s, t)) * 180 / M_PI;
        if (angle > Rounded_outlines::smooth_degrees) kinks_[solid.first_side(next)] = angle;
      }
    for (std::size_t e = 0; e < straight.size(); ++e)
      for (std::size_t x : straight.numbers(e)) kinks_[x] = (std::max)(kink(solid.polyhedron, straight.faces(e)), 1e-9);
  }
  std::vector<std::size_t> find(const std::string& option, const std::string& word) const {
    const bool is_number = !word.empty() && word.size() < 10 && word.find_first_not_of("0123456789") == word.npos;
    const std::size_t e = is_number ? std::stoul(word) : kinks_.size();
    if (!(e < kinks_.size()))
      throw std::invalid_argument("--" + option + ": there is no edge '" + word +
                                  "'; `verify` lists the edges, e.g. 0");
    if (kinks_[e] == 0)
      throw std::invalid_argument("--" + option + ": edge " + word + " is smooth: there is nothing to round");
    return {e};
  }
  std::size_t size() const { return kinks_.size(); }
  double kink_of(std::size_t e) const { return kinks_[e]; }
};

// A solid with outlines, of which the polyhedron is rounded as one without.
struct Outlined_result {
  const Result& planes;
  const Rounded_outlines& outlines;
  std::vector<std::optional<GC::Parameter_rectangle<double>>> folds; // of the blends of outlines
  std::size_t sharp = 0, exact = 0;
  double off = 0;

  std::size_t rails() const { return planes.counts.rails + planes.counts.seams + 2 * outlines.blends().size(); }
  std::size_t proved() const { return planes.counts.g2 + exact; }
  bool is_good(double size) const {
    return planes.is_good() && off <= 1e-12 * size &&
           std::none_of(folds.begin(), folds.end(), [](const auto& fold) { return fold.has_value(); });
  }
};

// The numbers of the edges of an outline.
std::string outline_text(const Outlined_solid& solid, std::size_t outline) {
  std::string text;
  for (const Outlined_solid::Rim& rim : solid.outlines[outline].rims)
    text += (text.empty() ? "" : ", ") + std::to_string(solid.edge_of(rim));
  return text;
}

void write_text(std::ostream& os, const Outlined_result& r, const Outlined_solid& solid) {
  for (std::size_t i = 0; i < r.planes.solid.blends.size(); ++i)
    os << "blend " << i << (r.planes.solid.blends[i].closed ? ", closed" : "") << ": edges " << r.planes.chains[i]
       << (r.planes.folds[i] ? "; may be folded" : "") << '\n';
  const std::vector<Rounded_outlines::Blend>& blends = r.outlines.blends();
  for (std::size_t i = 0; i < blends.size(); ++i) {
    if (i == 0 || blends[i].outline != blends[i - 1].outline)
      os << (solid.outlines[blends[i].outline].is_convex ? "convex" : "concave") << " outline: edges "
         << outline_text(solid, blends[i].outline) << '\n';
    if (r.folds[i])
      os << "the blend of edge " << blends[i].edge << " may be folded near (" << rounded(r.folds[i]->u.first, 4) << ", "
         << rounded(r.folds[i]->v.first, 4) << ")\n";
  }
  if (solid.polyhedron.largest_move > 0)
    os << "faces were not exactly plane: vertex " << solid.polyhedron.most_moved << " was moved by "
       << rounded(solid.polyhedron.largest_move, 3) << '\n';
  if (r.outlines.error() > 0)
    os << "set-backs of splines in planes are right to " << rounded(100 * r.outlines.error(), 2) << " %\n";
  os << counted(solid.caps.size() + r.planes.solid.faces.size(), "plane face") << " and "
     << counted(solid.walls.size(), "wall") << ", " << counted(r.planes.counts.rounded + blends.size(), "edge")
     << " rounded by " << counted(r.planes.solid.blends.size() + blends.size(), "blend") << ", 0 corners left open";
  if (r.outlines.mitres() > 0) os << "; " << counted(r.outlines.mitres(), "mitre");
  if (r.sharp > 0) os << "; " << counted(r.sharp, "edge") << " left sharp";
  os << "\nclosed: ";
  if (r.proved() == r.rails())
    os << "G2 along all " << counted(r.rails(), "rail") << ", proved exactly\n";
  else
    os << "G2 along " << r.proved() << " of " << counted(r.rails(), "rail") << " exactly, and along the others up to "
       << rounded(r.off, 3) << '\n';
}

void write_json(std::ostream& os, const Outlined_result& r, const Outlined_solid& solid) {
  os << "{\"blends\":[";
  const char* separator = "\n";
  const auto write = [&](const std::string& edges, bool closed, const auto& fold) {
    os << separator << "{\"edges\":";
    GC::write_json(os, edges);
    os << ",\"closed\":" << boolean(closed) << ",\"possible_fold\":";
    if (fold)
      os << "{\"u\":[" << fold->u.first << ',' << fold->u.second << "],\"v\":[" << fold->v.first << ','
         << fold->v.second << "]}}";
    else
      os << "null}";
    separator = ",\n";
  };
  for (std::size_t i = 0; i < r.planes.solid.blends.size(); ++i)
    write(r.planes.chains[i], r.planes.solid.blends[i].closed, r.planes.folds[i]);
  const std::vector<Rounded_outlines::Blend>& blends = r.outlines.blends();
  for (std::size_t i = 0; i < blends.size(); ++i)
    write(std::to_string(blends[i].edge), solid.outlines[blends[i].outline].rims.size() == 1, r.folds[i]);
  os << "],\n\"open_corners\":[],\n\"summary\":{\"faces\":" << solid.caps.size() + r.planes.solid.faces.size()
     << ",\"walls\":" << solid.walls.size() << ",\"blends\":" << r.planes.solid.blends.size() + blends.size()
     << ",\"rounded\":" << r.planes.counts.rounded + blends.size() << ",\"sharp\":" << r.sharp
     << ",\"mitres\":" << r.outlines.mitres()
     << ",\"open_corners\":0,\"closed\":true,\"rails\":" << r.planes.counts.rails + 2 * blends.size()
     << ",\"seams\":" << r.planes.counts.seams << ",\"rails_and_seams_g2\":" << r.proved() << ",\"off\":" << r.off
     << ",\"set_back_error\":" << r.outlines.error() << ",\"largest_move\":" << solid.polyhedron.largest_move
     << ",\"g2\":" << boolean(r.is_good(solid.size)) << "}}\n";
}

} // namespace

int round_solid(const Command_line& line, const Solid& solid,
                const std::function<std::string(std::size_t)>& edge_text) {
  const Solid_edges edges(solid, edge_text);
  const std::vector<double> cuts = cuts_of(
      line, edges.size(), [&](const char* option, const std::string& word) { return edges.find(option, word); },
      [&](std::size_t e) {
        return line.has("min-kink") || line.has("max-kink") ? (std::max)(kink(solid, edges.faces(e)), 1e-9) : 90;
      });
  const Result r = rounded_planes(line, solid, edges, cuts);
  const std::string ending =
      line.has("output") && !has_no_format(line.text("output")) ? extension(line.text("output")) : "";
  std::vector<Exact_surface> patches;
  if (line.has("plot") || (line.has("output") && !cad_format(ending))) patches = patches_of_solid(r.solid);
  std::ostream& report = report_stream(line);
  if (line.has("json"))
    write_json(report, r, solid);
  else
    write_text(report, r, solid);
  if (cad_format(ending)) {
    std::vector<std::string> face_names, blend_names;
    for (const Rounded_solid::Face& f : r.solid.faces) face_names.push_back(solid.faces[f.face].name);
    for (const std::string& chain : r.chains) blend_names.push_back("blend of " + chain);
    Shell_model shell;
    add_edges_of_solid(r.solid, shell);
    add_faces_of_solid(r.solid, face_names, blend_names, shell);
    write_output(line.text("output"), [&](std::ostream& os) { write_cad(os, shell, ending); });
  } else if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      for (const Exact_surface& s : patches) GC::write_g2(os, s);
    });
  if (line.has("plot"))
    write_output(line.text("plot"), [&](std::ostream& os) { draw_surfaces(os, patches, GC::Svg_surface_style()); });
  return r.is_good() ? requirement_met : requirement_not_met;
}

int round_outlined_solid(const Command_line& line, const Outlined_solid& solid) {
  line.refuse({"plot"}, "only with solids of plane faces with straight edges");
  const std::string ending =
      line.has("output") && !has_no_format(line.text("output")) ? extension(line.text("output")) : "";
  if (line.has("output") && !cad_format(ending))
    throw std::invalid_argument("-o: " + line.text("output") +
                                ": a solid with walls is written to a CAD model, .step or .brep");
  const std::function<std::string(std::size_t)> text = [](std::size_t e) { return std::to_string(e); };
  const Solid_edges straight(solid.polyhedron, text);
  const Outlined_edges edges(solid, straight);
  const std::vector<double> cuts = cuts_of(
      line, edges.size(), [&](const char* option, const std::string& word) { return edges.find(option, word); },
      [&](std::size_t e) { return edges.kink_of(e); });
  std::vector<double> straight_cuts;
  for (std::size_t e = 0; e < straight.size(); ++e) straight_cuts.push_back(cuts[straight.numbers(e)[0]]);
  Result planes{};
  if (straight.size() > 0) planes = rounded_planes(line, solid.polyhedron, straight, straight_cuts);
  const Rounded_outlines outlines(solid, cuts, fullness_of(line), straight.size() > 0 ? &planes.solid : nullptr);
  Outlined_result r{planes, outlines, {}};
  for (const Rounded_outlines::Blend& b : outlines.blends()) {
    r.folds.push_back(GC::possible_fold(b.surface));
    r.exact += std::size_t(b.exact_at_wall) + std::size_t(b.exact_in_plane);
    r.off = (std::max)(r.off, b.off);
  }
  r.sharp = r.planes.counts.sharp;
  for (const Outlined_solid::Outline& outline : solid.outlines)
    for (const Outlined_solid::Rim& rim : outline.rims) r.sharp += cuts[solid.edge_of(rim)] == 0;
  std::ostream& report = report_stream(line);
  if (line.has("json"))
    write_json(report, r, solid);
  else
    write_text(report, r, solid);
  if (line.has("output")) {
    std::vector<std::string> face_names, blend_names;
    for (const Rounded_solid::Face& f : r.planes.solid.faces) face_names.push_back(solid.polyhedron.faces[f.face].name);
    for (const std::string& chain : r.planes.chains) blend_names.push_back("blend of " + chain);
    const Shell_model shell = outlines.shell(face_names, blend_names);
    write_output(line.text("output"), [&](std::ostream& os) { write_cad(os, shell, ending); });
  }
  return r.is_good(solid.size) ? requirement_met : requirement_not_met;
}
