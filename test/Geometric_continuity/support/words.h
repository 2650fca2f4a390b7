// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <istream>
#include <sstream>
#include <string>
#include <vector>

// The words of a text, between blanks.
inline std::vector<std::string> words_of(const std::string& text) {
  std::istringstream is(text);
  std::vector<std::string> words;
  for (std::string word; is >> word;) words.push_back(word);
  return words;
}
