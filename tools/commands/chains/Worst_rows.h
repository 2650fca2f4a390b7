// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_WORST_ROWS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_WORST_ROWS_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

// The rows of joins that fail, at most 1000 of them: those of the lowest order, and of one order
// those that come first. All joins are counted.
class Worst_rows {
  static constexpr std::size_t most = 1000;
  typedef std::pair<std::size_t, std::string> Row; // the number of the join in its chain, and the text
  std::map<int, std::vector<Row>> rows_;           // by order, each in the order of the chain
  std::size_t count_ = 0;
  int end_ = (std::numeric_limits<int>::max)();

public:
  Worst_rows() = default;

  // Joins of the order `end` and higher orders are only counted.
  explicit Worst_rows(int end) : end_(end) {}

  // Returns the lowest order of which no join that comes later has a row in text().
  int end() const {
    std::size_t n = 0;
    for (const auto& [order, rows] : rows_)
      if ((n += rows.size()) >= most) return order;
    return (std::numeric_limits<int>::max)();
  }

  // Adds a join of this order and number. make() returns its row; it is not called for a join that
  // will have none.
  template <class Make> void add(int order, std::size_t join, Make make) {
    ++count_;
    if (order >= end_) return;
    std::vector<Row>& rows = rows_[order];
    if (rows.size() < most) rows.emplace_back(join, make());
  }

  // Adds those of joins that come later in the chain.
  Worst_rows& operator+=(const Worst_rows& later) {
    count_ += later.count_;
    for (const auto& [order, added] : later.rows_) {
      std::vector<Row>& rows = rows_[order];
      rows.insert(rows.end(), added.begin(), added.begin() + (std::min)(added.size(), most - rows.size()));
    }
    return *this;
  }

  // Returns how many joins have no row in text().
  std::size_t omitted() const { return count_ > most ? count_ - most : 0; }

  // Returns the rows in the order of the chain.
  std::string text() const {
    std::vector<Row> told;
    for (const auto& order_and_rows : rows_) {
      const std::vector<Row>& rows = order_and_rows.second;
      told.insert(told.end(), rows.begin(), rows.begin() + (std::min)(rows.size(), most - told.size()));
    }
    std::sort(told.begin(), told.end());
    std::string text;
    for (const Row& row : told) text += row.second;
    return text;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_WORST_ROWS_H
