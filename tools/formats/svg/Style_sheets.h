// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_STYLE_SHEETS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_STYLE_SHEETS_H

#include "formats/svg/Style_declarations.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// An element as the selectors of a style sheet see it.
struct Styled_element {
  std::string_view name, id, classes;
};

// The effect of a property on the outline of an element.
enum class Style_effect { none, shape, place, place_of_transform, animation };

// The name of a property without the prefix that browsers read as if it were not there.
inline std::string_view unprefixed(std::string_view property) {
  for (const std::string_view prefix : {"-webkit-", "-moz-"})
    if (property.substr(0, prefix.size()) == prefix) return property.substr(prefix.size());
  return property;
}

// Returns what a property, a name in small letters, does to elements of this name.
inline Style_effect style_effect(std::string_view property, std::string_view element) {
  const auto is_one_of = [](std::string_view x, std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), x) != list.end();
  };
  property = unprefixed(property);
  if (property == "d") return element == "path" ? Style_effect::shape : Style_effect::none;
  if (is_one_of(property, {"cx", "cy"}))
    return is_one_of(element, {"circle", "ellipse"}) ? Style_effect::shape : Style_effect::none;
  if (property == "r") return element == "circle" ? Style_effect::shape : Style_effect::none;
  if (is_one_of(property, {"rx", "ry"}))
    return is_one_of(element, {"rect", "ellipse"}) ? Style_effect::shape : Style_effect::none;
  if (is_one_of(property, {"x", "y", "width", "height"}))
    return is_one_of(element, {"rect", "svg", "use", "symbol"}) ? Style_effect::shape : Style_effect::none;
  if (is_one_of(property, {"transform-origin", "transform-box"})) return Style_effect::place_of_transform;
  if (is_one_of(property, {"animation", "animation-name"})) return Style_effect::animation;
  const bool has_escape = property.find('\\') != std::string_view::npos;
  return has_escape || is_one_of(property,
                                 {"transform", "translate", "rotate", "scale", "offset", "offset-path", "zoom", "all"})
             ? Style_effect::place
             : Style_effect::none;
}

// The style sheets of a drawing, as far as they may change outlines: which elements a rule may be
// for, and what it sets. Selectors that depend on more than names, ids and classes, or on the
// device, may match.
class Style_sheets {
  enum class Relation { descendant, child, other };
  struct Step {
    std::string type; // empty for any
    std::vector<std::string> ids, classes;
    Relation to_previous = Relation::descendant;
    bool never = false; // while nobody points at the drawing
  };
  typedef std::vector<Step> Selector;
  struct Rule {
    std::vector<Selector> selectors;
    std::vector<Style_declaration> declarations;
    long long line;            // of the sheet
    bool is_important = false; // something in it may be
  };
  static constexpr std::size_t most_rules = 1000; // each of which is compared with each element

  std::vector<Rule> rules_, fills_; // that may change outlines, and that may fill
  bool any_element_ = false, any_filled_ = false, moving_keyframes_ = false;
  long long first_line_ = 0; // of the first sheet with a rule

  static bool is_name_character(char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' || c == '_' ||
           (c & 0x80) != 0;
  }

  // Reads one selector. Conditions that are not read may be true.
  static Selector selector(std::string_view text) {
    static const std::initializer_list<std::string_view> states{"hover",   "active",        "focus",        "visited",
                                                                "checked", "focus-visible", "focus-within", "target"};
    Selector steps(1);
    Relation relation = Relation::descendant;
    bool is_new = false;
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      const auto name_behind = [&](std::size_t begin) {
        std::size_t end = begin;
        while (end < text.size() && is_name_character(text[end])) ++end;
        i = end;
        return std::string(text.substr(begin, end - begin));
      };
      if (c == ' ' || c == '>' || c == '+' || c == '~') {
        is_new = true;
        if (c != ' ') relation = c == '>' ? Relation::child : Relation::other;
        ++i;
        continue;
      }
      if (is_new) {
        steps.emplace_back();
        steps.back().to_previous = std::exchange(relation, Relation::descendant);
        is_new = false;
      }
      Step& step = steps.back();
      if (c == '*')
        ++i;
      else if (c == '#')
        step.ids.push_back(name_behind(i + 1));
      else if (c == '.')
        step.classes.push_back(name_behind(i + 1));
      else if (is_name_character(c))
        step.type = name_behind(i);
      else if (c == ':') {
        const bool is_element = text.substr(i, 2) == "::";
        const std::string name = name_behind(i + (is_element ? 2 : 1));
        const bool has_argument = i < text.size() && text[i] == '(';
        if (is_element || (!has_argument && std::find(states.begin(), states.end(), name) != states.end()))
          step.never = true;
        if (has_argument) {
          Style_text rest(text.substr(i));
          char end;
          rest.take_until(" >+~#.:*", end);
          i = end == '\0' ? text.size() : text.size() - rest.rest().size() - 1;
        }
      } else
        return Selector(1); // any element
    }
    return steps;
  }

  static bool has_class(std::string_view classes, std::string_view name) {
    for (std::size_t i = classes.find(name); i != std::string_view::npos; i = classes.find(name, i + 1)) {
      const std::size_t end = i + name.size();
      const auto is_space = [&](std::size_t k) {
        return std::string_view(" \t\r\n\f").find(classes[k]) != std::string_view::npos;
      };
      if ((i == 0 || is_space(i - 1)) && (end == classes.size() || is_space(end))) return true;
    }
    return false;
  }

  static bool may_match(const Step& step, const Styled_element& x) {
    if (step.never || (!step.type.empty() && step.type != x.name)) return false;
    const bool ids = std::all_of(step.ids.begin(), step.ids.end(), [&](const std::string& id) { return id == x.id; });
    return ids && std::all_of(step.classes.begin(), step.classes.end(),
                              [&](const std::string& name) { return has_class(x.classes, name); });
  }

  // Returns whether a selector may be for the last element of a path from the root on.
  static bool may_match(const Selector& steps, const std::vector<Styled_element>& path) {
    if (!may_match(steps.back(), path.back())) return false;
    std::vector<bool> before; // whether the steps so far may be for each element of the path
    for (const Step& step : steps) {
      std::vector<bool> here(path.size());
      bool above = false; // whether the step before may be for one of the elements above
      for (std::size_t i = 0; i < path.size(); ++i) {
        const bool linked = before.empty() || step.to_previous == Relation::other ||
                            (step.to_previous == Relation::child ? i > 0 && before[i - 1] : above);
        here[i] = linked && may_match(step, path[i]);
        above = above || (!before.empty() && before[i]);
      }
      before = std::move(here);
    }
    return before.back();
  }

  void add_rule(std::string_view selectors, std::string_view block, long long line) {
    Rule rule{{}, {}, line, block.find('!') != std::string_view::npos};
    bool fills = false;
    for (Style_declaration& d : style_declarations(block)) {
      fills = fills || (d.name == "fill" && d.value != "none");
      for (const char* element : {"path", "circle", "rect"})
        if (style_effect(d.name, element) != Style_effect::none) {
          rule.declarations.push_back(std::move(d));
          break;
        }
    }
    if (rule.declarations.empty() && !fills) return;
    std::string text(selectors);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r' || c == '\f'; }, ' ');
    for (Style_text rest(text); !rest.at_end();) {
      char end;
      rule.selectors.push_back(selector(Style_text::trimmed(rest.take_until(",", end))));
    }
    if (fills) {
      any_filled_ = any_filled_ || fills_.size() == most_rules;
      if (!any_filled_) fills_.push_back(rule);
    }
    if (rule.declarations.empty()) return;
    if (first_line_ == 0) first_line_ = line;
    any_element_ = any_element_ || rules_.size() == most_rules;
    if (!any_element_) rules_.push_back(std::move(rule));
  }

  void add_keyframes(std::string_view block) {
    for (Style_text rest(block); !rest.at_end();) {
      char end;
      rest.take_until("{", end);
      for (const Style_declaration& d : style_declarations(rest.take_block()))
        for (const char* element : {"path", "circle", "rect"})
          moving_keyframes_ = moving_keyframes_ || style_effect(d.name, element) != Style_effect::none;
    }
  }

  void add_blocks(std::string_view text, long long line) {
    for (Style_text rest(text); !rest.at_end();) {
      char end;
      const std::string_view before = Style_text::trimmed(rest.take_until("{;}", end));
      if (end == ';' && before.substr(0, 7) == "@import") imports.push_back(line);
      if (end != '{') continue;
      const std::string_view block = rest.take_block();
      if (before.find("keyframes") != std::string_view::npos && before[0] == '@')
        add_keyframes(block);
      else if (!before.empty() && before[0] == '@')
        add_blocks(block, line);                            // in which the rules may hold
      else if (block.find('{') != std::string_view::npos) { // nested rules
        add_rule("*", block, line);
        add_blocks(block, line);
      } else
        add_rule(before, block, line);
    }
  }

public:
  std::vector<long long> imports; // the lines of the sheets that import others

  // Adds the text of a sheet that begins on this line.
  void add(std::string_view text, long long line) {
    std::string sheet = Style_text::without_comments(text);
    for (const std::string mark : {"<!--", "-->"})
      for (std::size_t i; (i = sheet.find(mark)) != std::string::npos;) sheet.replace(i, mark.size(), mark.size(), ' ');
    add_blocks(sheet, line);
  }

  // Returns whether a declaration changes the outline of an element: of its own style, or of one of
  // the sheets. The outermost element, of which the size changes nothing, has no name.
  bool changes(const Style_declaration& d, std::string_view element, bool has_transform) const {
    const bool is_neutral = d.value == "none" || d.value == "initial" || d.value == "unset";
    switch (style_effect(d.name, element)) {
    case Style_effect::none: return false;
    case Style_effect::shape: return true;
    case Style_effect::place: return has_transform || !is_neutral;
    case Style_effect::place_of_transform: return has_transform;
    case Style_effect::animation: return moving_keyframes_ && !is_neutral;
    }
    return false;
  }

  bool is_empty() const { return first_line_ == 0; }

  // Returns whether a rule may fill the last element of a path from the root on; where its own
  // style says something else, an important rule.
  bool may_fill(const std::vector<Styled_element>& path, bool has_style) const {
    return any_filled_ || std::any_of(fills_.begin(), fills_.end(), [&](const Rule& rule) {
             return (!has_style || rule.is_important) &&
                    std::any_of(rule.selectors.begin(), rule.selectors.end(),
                                [&](const Selector& s) { return may_match(s, path); });
           });
  }
  bool has_fills() const { return any_filled_ || !fills_.empty(); }

  // Says which rule may change the outline of the last element of a path from the root on; nothing
  // where none does.
  std::optional<std::string> change(const std::vector<Styled_element>& path, bool has_transform) const {
    const auto text = [](long long line, const std::string& what) {
      return "the style sheet in line " + std::to_string(line) + " may set " + what;
    };
    if (any_element_) return text(first_line_, "more than is read, by too many rules");
    for (const Rule& rule : rules_)
      for (const Style_declaration& d : rule.declarations)
        if (changes(d, path.size() == 1 ? std::string_view() : path.back().name,
                    has_transform)) // the size of all does not
          for (const Selector& s : rule.selectors)
            if (may_match(s, path)) return text(rule.line, "its '" + d.name + "'");
    return std::nullopt;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_STYLE_SHEETS_H
