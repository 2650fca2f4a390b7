// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "reports/Conclusion.h"

#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <iostream>
#include <vector>

namespace {

constexpr std::size_t most_reasons = 10;

// E.g. "not covered: 61 joins, more than three axes".
std::string lines(const char* name, const Claims::Open& open) {
  std::string text;
  std::size_t lines = 0, left_out = 0;
  for (const auto& [thing, n] : open)
    if (lines++ < most_reasons)
      text +=
          name + (": " + counted(n, thing.first)) + ", " + CGAL::Geometric_continuity::printable(thing.second) + '\n';
    else
      left_out += n;
  if (left_out > 0) text += name + (": " + std::to_string(left_out)) + " more for other reasons\n";
  return text;
}

std::string json_of_open(const Claims::Open& open) {
  std::vector<std::string> reasons;
  for (const auto& [thing, n] : open)
    reasons.push_back("{\"what\":" + json_text(thing.first) + ",\"reason\":" + json_text(thing.second) +
                      ",\"count\":" + std::to_string(n) + '}');
  return json_array(reasons);
}

} // namespace

bool Conclusion::has_refused() const {
  return is_refused(claims_.undecided(), mode_.allow_undecided) ||
         is_refused(claims_.not_covered(), mode_.allow_uncovered);
}

std::string Conclusion::text() const {
  const std::size_t open = claims_.undecided() + claims_.not_covered();
  std::string text =
      lines("undecided", claims_.undecided_things()) + lines("not covered", claims_.not_covered_things());
  if (claims_.known() > 0) text += std::to_string(claims_.known()) + " of them known, from the baseline\n";
  if (is_empty())
    text += "no " + subject_.noun + ", nothing was decided\n";
  else if (!subject_.required.empty() && claims_.decided() > 0) {
    if (claims_.not_met() > 0)
      text += std::to_string(claims_.not_met()) + " of them " + (mode_.baseline ? "new, and " : "") + "not " +
              subject_.required + '\n';
    else if (is_met() && claims_.known() > 0)
      text += "nothing new is not " + subject_.required + '\n';
    else if (is_met())
      text += subject_.every + (open == 0 ? "" : " that was decided") + " is " + subject_.required + ", " +
              subject_.proof + '\n';
  }
  if (has_refused()) {
    const bool undecided = is_refused(claims_.undecided(), mode_.allow_undecided),
               uncovered = is_refused(claims_.not_covered(), mode_.allow_uncovered);
    text += std::string("not met, because not all was decided (see ") + (undecided ? "--allow-undecided" : "") +
            (undecided && uncovered ? ", " : "") + (uncovered ? "--allow-uncovered" : "") + ")\n";
  }
  return text;
}

std::string Conclusion::json() const {
  std::string text = "\"claims\":{\"given\":" + std::to_string(claims_.given()) +
                     ",\"decided\":" + std::to_string(claims_.decided()) +
                     ",\"not_met\":" + std::to_string(claims_.not_met()) +
                     (mode_.baseline ? ",\"known\":" + std::to_string(claims_.known()) : "") +
                     ",\"undecided\":" + json_of_open(claims_.undecided_things()) +
                     ",\"not_covered\":" + json_of_open(claims_.not_covered_things()) + '}';
  if (!subject_.required_in_json.empty()) text += ",\n " + subject_.required_in_json;
  const char* const met = is_empty() ? "null" : !is_met() ? "false" : claims_.decided() == 0 ? "null" : "true";
  if (!subject_.required.empty()) text += ",\"met\":" + std::string(met);
  return text;
}

int Conclusion::exit_code() const {
  if (is_empty() && !mode_.allow_empty) {
    std::cerr << "geometric_continuity: verify: there is no " << subject_.noun
              << ", so that nothing was decided; --allow-empty accepts that\n";
    return bad_input;
  }
  return is_met() ? requirement_met : requirement_not_met;
}
