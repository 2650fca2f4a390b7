// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_BASELINE_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_BASELINE_H

#include "files/input.h"
#include "reports/Fingerprints.h"
#include "reports/Json_view.h"
#include "reports/finding.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

// The findings that are known: those of a report that `--format sarif` has written.
class Baseline {
public:
  // The record of a known defect.
  struct Known {
    // A measure: what it is of, empty if there is none, and its upper bound.
    struct Size {
      std::string quantity = {};
      double upper = std::numeric_limits<double>::infinity();
    };
    std::string place, defect; // hashes
    Finding_rule rule;
    Size measure, behind;
  };

private:
  std::vector<Known> known_;
  std::unordered_map<std::string, std::vector<std::size_t>> by_place_,
      by_defect_; // numbers, those with small measures first

  static std::string text(const std::optional<Json_view>& value) {
    return value ? std::string(value->string().value_or("")) : std::string();
  }

  static Known::Size size_of(const std::optional<Json_view>& measure) {
    Known::Size size;
    if (!measure) return size;
    size.quantity = text(measure->member("quantity"));
    if (const auto bounds = measure->member("bounds"))
      bounds->for_elements([&](const Json_view& bound) { // the last one counts; null is infinite
        size.upper = bound.number().value_or(std::numeric_limits<double>::infinity());
      });
    return size;
  }

  void add(const Json_view& result, const Json_view& prints) {
    const std::optional<Finding_rule> rule = rule_of(text(result.member("ruleId")));
    Known known{
        hash(text(prints.member(place_fingerprint))), hash(text(prints.member(defect_fingerprint))), {}, {}, {}};
    if (!rule || known.place.empty() || known.defect.empty()) return;
    known.rule = *rule;
    if (const auto properties = result.member("properties")) {
      known.measure = size_of(properties->member("measure"));
      known.behind = size_of(properties->member("behind"));
    }
    known_.push_back(std::move(known));
  }

public:
  // Reads the report. Throws Error `malformed_input` for anything else, also for a part of one, and
  // for one of an older version, by whose fingerprints nothing is known again.
  explicit Baseline(const std::string& file) {
    namespace GC = CGAL::Geometric_continuity;
    Input input(file);
    const std::string text{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
    const auto refuse = [&](const std::string& reason) {
      throw GC::Error(GC::Error_code::malformed_input, input_name(file) + ": " + reason);
    };
    const std::string no_report = "no report in the format SARIF, as --format sarif writes it";
    bool is_old = false;
    try {
      const std::optional<Json_view> runs = Json_view::of(text).member("runs");
      if (!runs) refuse(no_report);
      runs->for_elements([&](const Json_view& run) {
        const std::optional<Json_view> results = run.member("results");
        if (!results) return;
        results->for_elements([&](const Json_view& result) {
          const std::optional<Json_view> prints = result.member("partialFingerprints");
          if (!prints) return;
          is_old = is_old || (prints->member(old_fingerprint) && !prints->member(place_fingerprint));
          add(result, *prints);
        });
      });
    } catch (const GC::Error& e) {
      if (e.code() != GC::Error_code::malformed_input) throw;
      refuse(no_report);
    }
    if (is_old)
      refuse(
          "a report of an older version, whose fingerprints hold lines of files; write it again with --format sarif");
    std::stable_sort(known_.begin(), known_.end(),
                     [](const Known& x, const Known& y) { return x.measure.upper < y.measure.upper; });
    for (std::size_t i = 0; i < known_.size(); ++i) {
      by_place_[known_[i].place].push_back(i);
      by_defect_[known_[i].defect].push_back(i);
    }
  }

  // The hash of a fingerprint, without its number.
  static std::string hash(const std::string& fingerprint) { return fingerprint.substr(0, fingerprint.find(':')); }

  std::size_t size() const { return known_.size(); }
  const Known& operator[](std::size_t i) const { return known_[i]; }

  // The numbers of those with this hash.
  const std::vector<std::size_t>& at_place(const std::string& hash) const { return found(by_place_, hash); }
  const std::vector<std::size_t>& of_defect(const std::string& hash) const { return found(by_defect_, hash); }

private:
  template <class Map> static const std::vector<std::size_t>& found(const Map& map, const std::string& hash) {
    static const std::vector<std::size_t> none;
    const auto entry = map.find(hash);
    return entry == map.end() ? none : entry->second;
  }
};

// Which findings of a report are those of a baseline: each that is known is one finding. A finding
// is known if it is no worse: its rule is not, and its measure may still be what it was. First come
// those with both fingerprints; then, of what is left, those that have moved and those that have
// changed where they are. A finding that is worse at its old place is new, also if another one like
// it is gone.
class Known_findings {
  const Baseline& baseline_;
  std::vector<bool> is_used_ = std::vector<bool>(baseline_.size());
  // of the numbers with a hash
  std::unordered_map<const std::vector<std::size_t>*, std::size_t> first_unused_;

  static int rank(Finding_rule rule) {
    switch (rule) {
    case Finding_rule::rounding: return 0;
    case Finding_rule::undecided: return 1;
    case Finding_rule::derivative: return 2;
    case Finding_rule::curvature:
    case Finding_rule::bend: return 3;
    case Finding_rule::kink: return 4;
    case Finding_rule::corner: return 5;
    case Finding_rule::tangent: return 6;
    case Finding_rule::gap:
    case Finding_rule::length:
    case Finding_rule::not_verified: break;
    }
    return 7;
  }

  // Moved things are rounded again, so this factor is no difference.
  static constexpr double rounding = 1 + 1e-9;

  static bool is_no_larger(const std::optional<Measure>& measure, const Baseline::Known::Size& known) {
    return !measure || known.quantity != measure->quantity || measure->bounds.lower <= known.upper * rounding;
  }

  // A thing that cannot be read is known if the reason is the same: other things may hide behind
  // another reason.
  static bool is_no_worse(const Finding& f, const Baseline::Known& known) {
    if (f.rule == Finding_rule::not_verified || known.rule == Finding_rule::not_verified)
      return f.rule == known.rule && known.defect == defect(f);
    return rank(f.rule) <= rank(known.rule) && is_no_larger(f.measure, known.measure) &&
           is_no_larger(f.behind, known.behind);
  }

  // Takes the first one that fits, which has the smallest measure of those, so that others are left
  // for what is larger.
  template <class Condition> bool take(const Finding& f, const std::vector<std::size_t>& numbers, Condition fits) {
    std::size_t& first = first_unused_[&numbers];
    while (first < numbers.size() && is_used_[numbers[first]]) ++first;
    for (std::size_t k = first; k < numbers.size(); ++k) {
      const std::size_t i = numbers[k];
      if (is_used_[i] || !fits(baseline_[i]) || !is_no_worse(f, baseline_[i])) continue;
      is_used_[i] = true;
      return true;
    }
    return false;
  }

  static std::string place(const Finding& f) { return Baseline::hash(f.fingerprints.place); }
  static std::string defect(const Finding& f) { return Baseline::hash(f.fingerprints.defect); }
  static bool any(const Baseline::Known&) { return true; }

public:
  explicit Known_findings(const Baseline& baseline) : baseline_(baseline) {}

  // Returns whether it is known where it is.
  bool take_unmoved(const Finding& f) {
    const std::string hash = defect(f);
    return take(f, baseline_.at_place(place(f)), [&](const Baseline::Known& known) { return known.defect == hash; });
  }

  // Returns whether it was better where it is, after all that is known has been taken there.
  bool is_worse_there(const Finding& f) const {
    const std::string hash = defect(f);
    const std::vector<std::size_t>& numbers = baseline_.at_place(place(f));
    return std::any_of(numbers.begin(), numbers.end(),
                       [&](std::size_t i) { return !is_used_[i] && baseline_[i].defect == hash; });
  }

  // Returns whether it is known from another place.
  bool take_moved(const Finding& f) { return take(f, baseline_.of_defect(defect(f)), any); }

  // Returns whether another defect is known there.
  bool take_changed(const Finding& f) { return take(f, baseline_.at_place(place(f)), any); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_BASELINE_H
