// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

// Bounds of rounding errors as theorems for Gappa, a prover of such bounds: a form is evaluated on
// a number type that keeps what is computed.

// Records the computation as definitions of Gappa: r for the rounded value, e for the exact one.
class Gappa_term {
  struct Node {
    std::string definitions, hypotheses;
    int left, right; // the nodes of which these speak, or -1
  };
  inline static std::vector<Node> nodes;
  int node_;

  static std::string name(char kind, int node) { return kind + std::to_string(node); }

public:
  Gappa_term(const Node& node) : node_(static_cast<int>(nodes.size())) { nodes.push_back(node); }

  // A number that is rounded to at most 2^exponent in absolute value: before, it is larger by less
  // than the factor 1 + 2^-51.
  static Gappa_term rounded_once(int exponent) {
    const std::string i = std::to_string(nodes.size()), bound = "2251799813685249b" + std::to_string(exponent - 51);
    return Node{"r" + i + " = rnd(e" + i + ");\n", "|e" + i + "| in [0, " + bound + "]", -1, -1};
  }
  // A number from 0 to 1 that is known up to an error.
  static Gappa_term factor(const std::string& error) {
    const std::string i = std::to_string(nodes.size());
    return Node{{}, "e" + i + " in [0, 1] /\\ |r" + i + " - e" + i + "| in [0, " + error + "]", -1, -1};
  }
  // A whole number as factor, in units of itself.
  static Gappa_term whole_factor() {
    const std::string i = std::to_string(nodes.size());
    return Node{"r" + i + " = e" + i + ";\n", "e" + i + " in [0, 1]", -1, -1};
  }

  friend Gappa_term operator+(const Gappa_term& x, const Gappa_term& y) { return operation(x, '+', y); }
  friend Gappa_term operator-(const Gappa_term& x, const Gappa_term& y) { return operation(x, '-', y); }
  friend Gappa_term operator*(const Gappa_term& x, const Gappa_term& y) { return operation(x, '*', y); }

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
  static Gappa_term operation(const Gappa_term& x, char sign, const Gappa_term& y) {
    const std::string i = std::to_string(nodes.size());
    const auto both = [&](char kind) { return name(kind, x.node_) + ' ' + sign + ' ' + name(kind, y.node_); };
    return Node{"r" + i + " = rnd(" + both('r') + ");\ne" + i + " = " + both('e') + ";\n", {}, x.node_, y.node_};
  }
};

// Writes PREFIX_ROUNDING.g for each way of rounding: the theorem that the error of a form is at
// most error * 2^exponent, and that its value does not overflow.
inline void write_theorems(const std::string& prefix, const Gappa_term& form, double error, int exponent) {
  int e;
  const double digits = std::frexp(error, &e);
  const std::string bound =
      std::to_string(static_cast<long long>(std::ldexp(digits, 53))) + "b" + std::to_string(e - 53 + exponent);
  for (const char* rounding : {"ne", "up", "dn", "zr"}) {
    const std::string path = prefix + '_' + rounding + ".g";
    std::ofstream os(path);
    os << form.theorem(rounding, bound);
    if (!os.flush()) {
      std::cerr << path << ": cannot write\n";
      std::exit(1);
    }
  }
}

// The arguments of a program that writes theorems: FOLDER [FACTOR], where a factor below 1 makes
// them too good to be true.
struct Theorem_arguments {
  std::string folder;
  double factor = 1;

  Theorem_arguments(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
      std::cerr << "usage: " << argv[0] << " FOLDER [FACTOR]\n";
      std::exit(2);
    }
    folder = argv[1];
    if (argc == 3) factor = std::atof(argv[2]);
  }
};
