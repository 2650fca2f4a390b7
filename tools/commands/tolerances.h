// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_TOLERANCES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_TOLERANCES_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// The value of --within: the bounds, and the order up to which they go. Orders without a bound must
// hold exactly.
struct Tolerances {
  CGAL::Geometric_continuity::Join_tolerance joins;
  int order = 0;

  CGAL::Geometric_continuity::Edge_tolerance edges() const { return {joins.tangent_angle, joins.gap}; }
};

namespace tolerances {

namespace GC = CGAL::Geometric_continuity;

// Rules that are published. For the curvature they give no number, or one that is measured in
// another way, so G2 must hold exactly.
struct Preset {
  const char *name, *bounds;
};
constexpr Preset presets[] = {
    // Three classes of the surfaces of a car's body: https://grabcad.com/questions/
    // what-is-the-difference-between-class-a-b-and-c-surfaces-in-surface-design
    {"class-a", "0.01,0.1deg"},
    {"class-b", "0.02,0.2deg"},
    {"class-c", "0.05,0.5deg"},
    // The criteria G-CU-LG, G-SU-LG, G-CU-NT and G-SU-NT of VDA 4955, as PTC Creo's
    // GeomIntegrityCHECK sets them:
    // https://support.ptc.com/help/creo/creo_pma/usascii/model_analysis/modelcheck/
    // GeomIntegrityCHECK_Configuration_Options_and_The.html
    {"vda-4955", "0.02,0.1deg"},
    // MIL-STD-31000A, appendix C, design: table 1 of J. Comput. Inf. Sci. Eng. 16(2), 2016,
    // doi:10.1115/1.4032697
    {"mil-std-31000a", "0.01,2deg"}};

// A number, and the unit behind it: "deg", "rad", "%", or none.
class Item {
  std::string text_, place_;
  std::string unit_;

public:
  Item(std::string text, std::size_t number)
      : text_(std::move(text)), place_("--within: item " + std::to_string(number) + ", '" + text_ + "': ") {
    for (const char* const unit : {"deg", "rad", "%"}) {
      const std::string word = unit;
      if (text_.size() > word.size() && text_.compare(text_.size() - word.size(), word.size(), word) == 0) unit_ = word;
    }
  }

  const std::string& unit() const { return unit_; }

  [[noreturn]] void refuse(const std::string& reason) const { throw std::invalid_argument(place_ + reason); }

  CGAL::Exact_rational number() const {
    CGAL::Exact_rational x;
    try {
      x = GC::parse_number<CGAL::Exact_rational>(text_.substr(0, text_.size() - unit_.size()));
    } catch (const std::exception& e) {
      refuse(e.what());
    }
    if (x < 0) refuse("a tolerance is negative");
    return x;
  }

  // A length, in the units of the coordinates, or a torsion.
  GC::Bound plain(const std::string& what) const {
    if (!unit_.empty()) refuse(what + " has no unit");
    return GC::enclosure(number());
  }

  GC::Bound angle() const {
    if (unit_ != "deg" && unit_ != "rad") refuse("an angle with its unit, deg or rad, is expected");
    return unit_ == "deg" ? GC::in_radians(number()) : GC::enclosure(number());
  }

  // Reads the bound of a curvature.
  GC::Bound ratio() const {
    if (unit_ != "%") refuse("a jump of the curvature in % is expected");
    return GC::enclosure(CGAL::Exact_rational(number() / 100));
  }
};

// Returns the bounds of a preset, and any other text as it is.
inline std::string bounds_of(const std::string& words) {
  for (const Preset& preset : presets)
    if (words == preset.name) return preset.bounds;
  return words;
}

inline std::vector<Item> items(const std::string& words) {
  std::vector<Item> result;
  for (std::size_t begin = 0, end; begin <= words.size(); begin = end + 1) {
    end = (std::min)(words.find(',', begin), words.size());
    result.emplace_back(words.substr(begin, end - begin), result.size() + 1);
  }
  return result;
}

// GAP,ANGLE,CURVATURE,TORSION, of which as many as `most` may be given.
inline Tolerances with_units(const std::vector<Item>& x, std::size_t most) {
  if (x.size() > most) x[most].refuse("at most " + std::to_string(most) + " bounds are expected here");
  Tolerances t;
  t.order = static_cast<int>(x.size()) - 1;
  t.joins.gap = x[0].plain("a gap, which is in the units of the coordinates,");
  if (x.size() > 1) t.joins.tangent_angle = x[1].angle();
  if (x.size() > 2) t.joins.curvature_jump = x[2].ratio();
  if (x.size() > 3) t.joins.torsion_jump = x[3].plain("a torsion, which is in 1/length,");
  return t;
}

// ANGLE,CURVATURE,TORSION or ANGLE, and then possibly GAP, in radians.
inline Tolerances without_units(const std::vector<Item>& x, bool of_edges) {
  const std::size_t least = of_edges ? 1 : 3;
  if (x.size() != least && x.size() != least + 1)
    throw std::invalid_argument(std::string("--within: ") +
                                (of_edges ? "an angle is" : "an angle, a relative curvature and a torsion are") +
                                " needed, and possibly a gap; or, with units, " +
                                (of_edges ? "GAP,ANGLEdeg" : "GAP,ANGLEdeg,CURVATURE%,TORSION"));
  Tolerances t;
  t.order = static_cast<int>(least);
  t.joins.tangent_angle = x[0].plain("");
  if (!of_edges) {
    t.joins.curvature_jump = x[1].plain("");
    t.joins.torsion_jump = x[2].plain("");
  }
  if (x.size() > least) t.joins.gap = x[least].plain("");
  return t;
}

// Returns the presets' names, separated by commas.
inline std::string preset_names() {
  std::string names;
  for (const Preset& preset : presets) (names += names.empty() ? "" : ", ") += preset.name;
  return names;
}

} // namespace tolerances

// Reads what --within gives: the name of a preset, GAP,ANGLE,CURVATURE,TORSION with units, or
// numbers without. Throws std::invalid_argument with the item that is wrong.
inline Tolerances parse_tolerances(const std::string& given, bool of_edges) {
  namespace T = tolerances;
  const std::string words = T::bounds_of(given);
  if (!words.empty() && std::isalpha(static_cast<unsigned char>(words[0])) && words.find(',') == std::string::npos)
    throw std::invalid_argument("--within: '" + words + "' is neither a number nor one of " + T::preset_names());
  const std::vector<T::Item> items = T::items(words);
  if (std::all_of(items.begin(), items.end(), [](const T::Item& x) { return x.unit().empty(); }))
    return T::without_units(items, of_edges);
  if (of_edges && items.size() == 3)
    items[2].refuse("along an edge the gap and the angle have a tolerance; G2 is decided exactly");
  return T::with_units(items, of_edges ? 2 : 4);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_TOLERANCES_H
