// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/number.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// One exact case of the format exact-cases/1: an operation, its input and its expected output. Both
// are flattened to "path value" with a leaf "path# length" for each array. A file may write an
// array in one line, as "path [1/2 [0 3] 4]".
struct Case {
  std::string id, op, kind;
  std::map<std::string, std::string> in, out;

  bool has(const std::string& path) const { return in.count(path) != 0; }

  const std::string& text(const std::string& path) const {
    const auto found = in.find(path);
    if (found == in.end()) throw std::runtime_error("the case has no input '" + path + "'");
    return found->second;
  }
  CGAL::Exact_rational number(const std::string& path) const {
    return CGAL::Geometric_continuity::parse_number<CGAL::Exact_rational>(text(path));
  }
  int integer(const std::string& path) const { return std::stoi(text(path)); }
  int length(const std::string& path) const { return integer(path + "#"); }

  std::vector<CGAL::Exact_rational> numbers(const std::string& path) const {
    std::vector<CGAL::Exact_rational> x;
    for (int i = 0; i < length(path); ++i) x.push_back(number(path + '.' + std::to_string(i)));
    return x;
  }
  std::vector<std::vector<CGAL::Exact_rational>> rows(const std::string& path) const {
    std::vector<std::vector<CGAL::Exact_rational>> x;
    for (int i = 0; i < length(path); ++i) x.push_back(numbers(path + '.' + std::to_string(i)));
    return x;
  }
};

// Adds the value of a path: a leaf, or an array with all its leaves and lengths. Returns whether
// the brackets match.
inline bool add_value(std::map<std::string, std::string>& leaves, const std::string& path, const std::string& value) {
  if (value[0] != '[') {
    leaves[path] = value;
    return true;
  }
  // the arrays around, with the number of elements so far
  std::vector<std::pair<std::string, int>> open;
  const auto next_path = [&] {
    return open.empty() ? path : open.back().first + '.' + std::to_string(open.back().second++);
  };
  for (std::size_t i = 0; i < value.size();) {
    if (i > 0 && open.empty()) return false; // the array has ended
    if (value[i] == '[') {
      const std::string inner = next_path();
      open.emplace_back(inner, 0);
      ++i;
    } else if (value[i] == ']') {
      leaves[open.back().first + '#'] = std::to_string(open.back().second);
      open.pop_back();
      ++i;
    } else if (value[i] == ' ')
      ++i;
    else {
      const std::size_t end = (std::min)(value.find_first_of("[] ", i), value.size());
      leaves[next_path()] = value.substr(i, end - i);
      i = end;
    }
  }
  return open.empty();
}

// Reads all cases of a file; a line that does not fit the format is an error with its number.
inline std::vector<Case> read_cases(const std::string& name) {
  std::ifstream file(name);
  if (!file) throw std::runtime_error(name + ": cannot be read");
  std::vector<Case> cases;
  std::string line;
  for (int n = 1; std::getline(file, line); ++n) {
    if (line.empty()) continue;
    const std::size_t space = line.find(' ');
    const std::string key = line.substr(0, space), value = space == std::string::npos ? "" : line.substr(space + 1);
    if (key == "case")
      cases.push_back(Case{value, "", "", {}, {}});
    else if (cases.empty() || space == std::string::npos)
      throw std::runtime_error(name + ':' + std::to_string(n) + ": not a line of a case: " + line);
    else if (key == "op")
      cases.back().op = value;
    else if (key == "kind")
      cases.back().kind = value;
    else if (key.compare(0, 3, "in.") != 0 && key.compare(0, 4, "out.") != 0)
      throw std::runtime_error(name + ':' + std::to_string(n) + ": unknown key " + key);
    else if (const bool is_input = key[0] == 'i';
             !add_value(is_input ? cases.back().in : cases.back().out, key.substr(is_input ? 3 : 4), value))
      throw std::runtime_error(name + ':' + std::to_string(n) + ": the brackets of the array do not match");
  }
  if (cases.empty()) throw std::runtime_error(name + ": no case");
  for (const Case& c : cases)
    if (c.out.empty()) throw std::runtime_error(name + ": case " + c.id + " expects nothing");
  return cases;
}
