// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CLAIMS_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CLAIMS_H

#include <cstddef>
#include <map>
#include <string>
#include <utility>

// Exactly one of these holds for each thing that was given: a join, an edge, a glyph, a face, a
// file. The first two are decided. Where nothing is required, a decided thing is met.
enum class Claim { met, not_met, undecided, not_covered };

// A thing that was given and what can be said of it, with the reason where it is not decided.
struct Given {
  Claim claim;
  const char* noun; // what it is, e.g. "join"
  // why it is undecided or not covered, e.g. "the tolerance lies between the bounds"
  std::string reason = {};
};

// How many things are in each class.
class Claims {
public:
  // The things that are not decided: the number of things of a noun for a reason.
  typedef std::map<std::pair<std::string, std::string>, std::size_t> Open;

private:
  std::size_t met_ = 0, not_met_ = 0, known_ = 0;
  Open undecided_, not_covered_;

  static std::size_t sum(const Open& open) {
    std::size_t n = 0;
    for (const auto& entry : open) n += entry.second;
    return n;
  }

public:
  void add(const Given& given, std::size_t n = 1) {
    switch (given.claim) {
    case Claim::met: met_ += n; return;
    case Claim::not_met: not_met_ += n; return;
    case Claim::undecided: undecided_[{given.noun, given.reason}] += n; return;
    case Claim::not_covered: not_covered_[{given.noun, given.reason}] += n; return;
    }
  }

  // A thing that has been added to its class is in the baseline, and is no longer in this class.
  void know(const Given& given) {
    const auto take = [&](Open& open) {
      const auto entry = open.find({given.noun, given.reason});
      if (--entry->second == 0) open.erase(entry);
    };
    switch (given.claim) {
    case Claim::met: return; // a note
    case Claim::not_met: --not_met_; break;
    case Claim::undecided: take(undecided_); break;
    case Claim::not_covered: take(not_covered_); break;
    }
    ++known_;
  }

  std::size_t known() const { return known_; }
  std::size_t met() const { return met_; }
  std::size_t not_met() const { return not_met_; }
  std::size_t decided() const { return met_ + not_met_; }
  std::size_t undecided() const { return sum(undecided_); }
  std::size_t not_covered() const { return sum(not_covered_); }
  std::size_t given() const { return decided() + undecided() + not_covered() + known_; }

  const Open& undecided_things() const { return undecided_; }
  const Open& not_covered_things() const { return not_covered_; }

  Claims& operator+=(const Claims& x) {
    met_ += x.met_;
    not_met_ += x.not_met_;
    known_ += x.known_;
    for (const auto& [thing, n] : x.undecided_) undecided_[thing] += n;
    for (const auto& [thing, n] : x.not_covered_) not_covered_[thing] += n;
    return *this;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CLAIMS_H
