// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DID_YOU_MEAN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DID_YOU_MEAN_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

// Returns how many letters must be inserted, deleted, changed or exchanged with their neighbour to
// get from one word to the other: the distance of Damerau and Levenshtein, without changes of a
// pair that was exchanged.
inline std::size_t spelling_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = (std::min)({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = (std::min)(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

// Returns e.g. "; did you mean 'blend'?" for the word that is spelled most nearly, and nothing if
// none is.
inline std::string did_you_mean(const std::string& word, const std::vector<std::string>& words) {
  const std::size_t longest = 40; // no word is as long
  if (word.empty() || word.size() > longest || words.empty()) return "";
  const auto nearest = std::min_element(words.begin(), words.end(), [&](const std::string& a, const std::string& b) {
    return spelling_distance(word, a) < spelling_distance(word, b);
  });
  return spelling_distance(word, *nearest) <= (std::max<std::size_t>)(1, word.size() / 3)
             ? "; did you mean '" + *nearest + "'?"
             : "";
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DID_YOU_MEAN_H
