// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_XML_XML_ENTITIES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_XML_XML_ENTITIES_H

#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

// The entities that an XML file declares itself, as authoring tools do to abbreviate namespaces.
// Only those are read: no other file is opened, and where a declaration could stand in one, a
// parser must not skip the reference in silence.
class Xml_entities {
  static constexpr int max_depth = 16; // parsers descend into entities recursively

  // How deep references are nested in each entity; -1 is an entity in another file.
  std::map<std::string, int> depths_{{"amp", 0}, {"lt", 0}, {"gt", 0}, {"quot", 0}, {"apos", 0}};

  // Calls f with the name of each reference to an entity.
  template <class Action> static void for_each_reference(std::string_view text, Action f) {
    for (std::size_t begin = text.find('&'); begin != std::string_view::npos; begin = text.find('&', begin + 1)) {
      const std::size_t end = text.find_first_of("&;", begin + 1);
      if (end == std::string_view::npos) return;
      const std::string_view name = text.substr(begin + 1, end - begin - 1);
      if (text[end] == ';' && !name.empty() && name[0] != '#') f(std::string(name));
    }
  }

public:
  // Why an entity must not be referred to; nothing when it may be.
  std::optional<std::string> refusal(const std::string& name) const {
    const auto found = depths_.find(name);
    const std::string entity = "the entity " + CGAL::Geometric_continuity::quoted_token(name);
    if (found == depths_.end()) return entity + " is not declared in this file";
    if (found->second < 0) return entity + " stands in another file, which is not read";
    return std::nullopt;
  }

  // Why one of the references in a piece of the file must not be there. Zero bytes of UTF-16 are
  // left out.
  std::optional<std::string> refusal_in(std::string_view piece) const {
    std::string text(piece);
    text.erase(std::remove(text.begin(), text.end(), '\0'), text.end());
    std::optional<std::string> reason;
    for_each_reference(text, [&](const std::string& name) {
      if (!reason) reason = refusal(name);
    });
    return reason;
  }

  // Checks the text between the first two quotation marks of one kind.
  std::optional<std::string> refusal_in_quoted(std::string_view text) const {
    const std::size_t begin = text.find_first_of("'\"");
    if (begin == std::string_view::npos) return std::nullopt;
    return refusal_in(text.substr(begin, text.find(text[begin], begin + 1) - begin));
  }

  // Declares an entity of the file itself. Returns why it is refused: its references must be to
  // entities that are declared before it, so that none refers to itself.
  std::optional<std::string> declare(const std::string& name, std::string_view value) {
    std::optional<std::string> reason = refusal_in(value);
    if (reason) return *reason + ", or not before the entity " + CGAL::Geometric_continuity::quoted_token(name);
    int depth = 0;
    for_each_reference(value, [&](const std::string& other) { depth = (std::max)(depth, depths_.at(other) + 1); });
    if (depth > max_depth) return "entities are nested deeper than " + std::to_string(max_depth);
    depths_.emplace(name, depth);
    return std::nullopt;
  }

  // Declares an entity in another file.
  void declare_external(const std::string& name) { depths_.emplace(name, -1); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_XML_XML_ENTITIES_H
