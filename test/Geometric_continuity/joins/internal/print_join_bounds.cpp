// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes the bounds of the rounding errors of the filter for joins as theorems for Gappa, a prover of such bounds: the forms are those
// of Join_equations, evaluated on a number type that keeps what is computed, and the bounds those of Join_filter.
//
// Usage: print_join_bounds FOLDER [FACTOR] writes FOLDER/NAME.g for each form, each way of rounding, and both ends of the range of the
// filter; with a factor below 1 theorems that are too good to be true.

#include <CGAL/Geometric_continuity/joins/internal/Join_input.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Geometric_continuity::internal;

// What is computed, as definitions of Gappa: r for the rounded value, e for the exact one.
class Term {
  struct Node {
    std::string definitions, hypotheses;
    int left, right; // the nodes of which these speak, or -1
  };
  static std::vector<Node> nodes;
  int node_;

  static std::string name(char kind, int node) { return kind + std::to_string(node); }

public:
  Term(const Node& node) : node_(static_cast<int>(nodes.size())) { nodes.push_back(node); }

  // A number that is rounded to at most 2^exponent in absolute value: before, it is larger by less than the factor 1 + 2^-51.
  static Term rounded_once(int exponent) {
    const std::string i = std::to_string(nodes.size()), bound = "2251799813685249b" + std::to_string(exponent - 51);
    return Node{"r" + i + " = rnd(e" + i + ");\n", "|e" + i + "| in [0, " + bound + "]", -1, -1};
  }
  // A number from 0 to 1 that is known up to an error.
  static Term factor(const std::string& error) {
    const std::string i = std::to_string(nodes.size());
    return Node{{}, "e" + i + " in [0, 1] /\\ |r" + i + " - e" + i + "| in [0, " + error + "]", -1, -1};
  }
  // A whole number as factor, in units of itself.
  static Term whole_factor() {
    const std::string i = std::to_string(nodes.size());
    return Node{"r" + i + " = e" + i + ";\n", "e" + i + " in [0, 1]", -1, -1};
  }

  friend Term operator+(const Term& x, const Term& y) { return operation(x, '+', y); }
  friend Term operator-(const Term& x, const Term& y) { return operation(x, '-', y); }
  friend Term operator*(const Term& x, const Term& y) { return operation(x, '*', y); }

  // The theorem that the error is at most `error` and the value at most 2^1000: no overflow.
  std::string theorem(const std::string& rounding, const std::string& error) const {
    std::set<int> needed;
    std::vector<int> open{node_};
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      if (i < 0 || !needed.insert(i).second) continue;
      open.push_back(nodes[static_cast<std::size_t>(i)].left);
      open.push_back(nodes[static_cast<std::size_t>(i)].right);
    }
    std::string definitions = "@rnd = float<ieee_64, " + rounding + ">;\n", hypotheses;
    for (const int i : needed) {
      const Node& node = nodes[static_cast<std::size_t>(i)];
      definitions += node.definitions;
      if (!node.hypotheses.empty()) hypotheses += (hypotheses.empty() ? "  " : " /\\\n  ") + node.hypotheses;
    }
    return definitions + "{\n" + hypotheses + "\n->\n  |" + name('r', node_) + " - " + name('e', node_) + "| in [0, " +
           error + "] /\\ |" + name('r', node_) + "| in [0, 1b1000]\n}\n";
  }

private:
  static Term operation(const Term& x, char sign, const Term& y) {
    const std::string i = std::to_string(nodes.size());
    const auto both = [&](char kind) { return name(kind, x.node_) + ' ' + sign + ' ' + name(kind, y.node_); };
    return Node{"r" + i + " = rnd(" + both('r') + ");\ne" + i + " = " + both('e') + ";\n", {}, x.node_, y.node_};
  }
};
std::vector<Term::Node> Term::nodes;

const char* name_of(Join_question form) {
  constexpr const char* names[] = {"c0", "c1", "c2", "c3", "g1", "g2", "g3", "f3", "curvature_vector", "torsion"};
  return names[static_cast<int>(form)];
}

// Differences up to 2^exponent.
template <int N> Differences<Term, N> differences(bool from_legs, int exponent) {
  const auto leg = [&](int k) { return Term::rounded_once(exponent - k); };
  const auto difference = [&](int k) -> Term {
    if (k == 0 || !from_legs) return leg(0);
    if (k == 1) return leg(1) - leg(1);
    return (leg(2) - leg(2)) - (leg(2) - leg(2));
  };
  const auto vector = [&](int k) -> std::array<Term, N> {
    if constexpr (N == 2)
      return {difference(k), difference(k)};
    else
      return {difference(k), difference(k), difference(k)};
  };
  return {vector(0), vector(1), vector(2)};
}

// Writes a theorem for each form whose value it is asked about.
class Theorems {
  const std::string prefix_;
  const Join_rounding rounding_;
  const int exponent_;
  int count_ = 0;

public:
  static double factor;

  Theorems(std::string prefix, const Join_rounding& rounding, int exponent)
      : prefix_(std::move(prefix)), rounding_(rounding), exponent_(exponent) {}

  static constexpr bool exact = false, pivot_is_first = false;
  bool operator()(Join_question form, const Term& x) {
    // Half of the margin that Join_rounding adds is left for what the filter computes.
    const double error = factor * rounding_.error[static_cast<int>(form)] * (1 - 0x1p-21);
    int exponent;
    const double digits = std::frexp(error, &exponent);
    const std::string bound = std::to_string(static_cast<long long>(std::ldexp(digits, 53))) + "b" +
                              std::to_string(exponent - 53 + exponent_ * form_degree(form));
    for (const char* rounding : {"ne", "up", "dn", "zr"}) {
      const std::string path = prefix_ + name_of(form) + '_' + std::to_string(count_) + '_' + rounding + ".g";
      std::ofstream os(path);
      os << x.theorem(rounding, bound);
      if (!os.flush()) {
        std::cerr << path << ": cannot write\n";
        std::exit(1);
      }
    }
    ++count_;
    return true;
  }
};

double Theorems::factor = 1;

template <int N, class Weights>
void geometric(const std::string& prefix, const Weights& w, bool from_legs, const Join_rounding& rounding,
               int exponent) {
  const Differences<Term, N> a = differences<N>(from_legs, exponent), b = differences<N>(from_legs, exponent);
  Theorems theorems(prefix, rounding, exponent);
  const Join_equations<Term, N, Weights, Theorems> equations(a, b, w, theorems);
  (void)equations.tangents_parallel();
  (void)equations.g2(equations.ratio());
  (void)equations.g3(equations.ratio());
  (void)equations.curvature_vectors_equal();
  if constexpr (N == 3) {
    (void)equations.f3(equations.ratio());
    (void)equations.torsions_equal();
  }
}

template <int N> void all(const std::string& folder, int exponent) {
  const std::string prefix = folder + "/" + (N == 2 ? "plane" : "space") + (exponent < 0 ? "_small_" : "_large_");
  const auto whole = [] { return Term::whole_factor(); };
  const auto rounded = [] { return Term::factor("16b-52"); };
  geometric<N>(prefix, Join_weights<Term>{whole(), whole(), whole(), whole(), whole()}, true, Join_rounding(),
               exponent);
  geometric<N>(
      prefix + "weighted_",
      Rational_join_weights<Join_question::g3, Term>{rounded(), rounded(), rounded(), rounded(), rounded(), rounded()},
      false, Rounding_of_weighted_ends::value(), exponent);

  const Differences<Term, N> a = differences<N>(true, exponent), b = differences<N>(true, exponent);
  const Parametric_join_weights<Term> w{whole(), whole(), whole(), whole(), whole(), whole()};
  Theorems theorems(prefix, Join_rounding(), exponent);
  const Join_equations<Term, N, Parametric_join_weights<Term>, Theorems> parametric(a, b, w, theorems);
  (void)parametric.template derivatives_equal<1>();
  (void)parametric.template derivatives_equal<2>();
  (void)parametric.template derivatives_equal<3>();
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: print_join_bounds FOLDER [FACTOR]\n";
    return 2;
  }
  if (argc == 3) Theorems::factor = std::atof(argv[2]);
  for (const int exponent : {-100, 100}) { // the range of Join_filter; between them values are scaled by powers of two
    all<2>(argv[1], exponent);
    all<3>(argv[1], exponent);
  }
}
