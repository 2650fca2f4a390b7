// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

// A leaf of the output depends on one of these, which decides how it can be compared when numbers
// are rounded.
enum class Source {
  construction, // a number computed from the input
  predicate,    // a decision on the input as given
  consequence   // a decision on constructed numbers
};

// One computed leaf of the output.
struct Leaf {
  Source source = Source::construction;
  std::string text;                           // for flags, names and null
  std::optional<CGAL::Exact_rational> number; // the value, exact for exact fields and for doubles
  std::optional<CGAL::Interval_nt<>> enclosure;
};

// The computed output of one case. Values are given as functions, so that a decision that interval
// arithmetic cannot take leaves out only the leaf that needs it.
class Report {
public:
  typedef std::map<std::string, Leaf> Leaves;
  const Leaves& leaves() const { return leaves_; }

  template <class Function> void construction(const std::string& path, Function f) {
    add(path, Source::construction, f);
  }
  template <class Function> void predicate(const std::string& path, Function f) { add(path, Source::predicate, f); }
  template <class Function> void consequence(const std::string& path, Function f) { add(path, Source::consequence, f); }
  template <class Function> void add(const std::string& path, Source s, Function f) {
    try {
      put(path, s, f());
    } catch (const CGAL::Uncertain_conversion_exception&) {
    }
  }

private:
  // leaves of a value by its type: numbers, flags, names, optional values (null) and ranges
  void put(const std::string& path, Source s, bool x) { leaf(path, s).text = x ? "true" : "false"; }
  void put(const std::string& path, Source s, const std::string& x) { leaf(path, s).text = x; }
  void put(const std::string& path, Source s, int x) { leaf(path, s).number = CGAL::Exact_rational(x); }
  void put(const std::string& path, Source s, double x) { leaf(path, s).number = CGAL::Exact_rational(x); }
  void put(const std::string& path, Source s, const CGAL::Interval_nt<>& x) { leaf(path, s).enclosure = x; }
  template <class T> void put(const std::string& path, Source s, const std::optional<T>& x) {
    if (x)
      put(path, s, *x);
    else
      leaf(path, s).text = "null";
  }
  template <class T> void put(const std::string& path, Source s, const std::vector<T>& x) {
    leaf(path + '#', s).number = CGAL::Exact_rational(static_cast<int>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) put(path + '.' + std::to_string(i), s, T(x[i]));
  }
  template <class FT> auto put(const std::string& path, Source s, const FT& x) -> decltype(x.exact(), void()) {
    leaf(path, s).number = x.exact();
  }
  void put(const std::string& path, Source s, const CGAL::Exact_rational& x) { leaf(path, s).number = x; }

  Leaves leaves_;

  Leaf& leaf(const std::string& path, Source s) {
    Leaf& l = leaves_[path];
    l.source = s;
    return l;
  }
};
