// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_COMMAND_LINE_H
#define GEOMETRIC_CONTINUITY_DEMO_COMMAND_LINE_H

#include "commands.h"

#include <CGAL/Geometric_continuity/IO/number.h>

#include <boost/program_options.hpp>

#include <iostream>
#include <stdexcept>

namespace po = boost::program_options;

// The arguments of one command: named options and files. Answers --help itself.
class Command_line {
  po::options_description options_;
  po::variables_map values_;

public:
  // `describe` adds the options of the command.
  template <class Describe>
  Command_line(const std::string& usage, const Arguments& arguments, Describe describe) : options_("options") {
    describe(options_.add_options()("help,h", "print this text"));
    po::options_description all;
    all.add(options_).add_options()("file", po::value<Arguments>());
    po::positional_options_description positional;
    positional.add("file", -1);
    namespace style = po::command_line_style;
    po::store(po::command_line_parser(arguments)
                  .options(all)
                  .positional(positional)
                  .style(style::unix_style & ~style::allow_guessing)
                  .run(),
              values_);
    if (values_.count("help")) std::cout << usage << '\n' << options_;
  }

  bool help() const { return values_.count("help") != 0; }
  bool has(const std::string& option) const { return values_.count(option) != 0; }
  Arguments files() const { return has("file") ? values_["file"].as<Arguments>() : Arguments(); }
  std::string text(const std::string& option) const { return values_[option].as<std::string>(); }
  int integer(const std::string& option) const { return values_[option].as<int>(); }

  // An exact number; `otherwise` when the option is not given.
  template <class FT> FT number(const std::string& option, const FT& otherwise) const {
    if (!has(option)) return otherwise;
    try {
      return CGAL::Geometric_continuity::parse_number<FT>(text(option));
    } catch (const std::exception& e) {
      throw std::invalid_argument("--" + option + ": " + e.what());
    }
  }

  // One of the given words.
  std::string choice(const std::string& option, const Arguments& words) const {
    const std::string word = text(option);
    std::string known;
    for (const std::string& w : words) {
      if (w == word) return word;
      known += (known.empty() ? "" : ", ") + w;
    }
    throw std::invalid_argument("--" + option + ": '" + word + "' is none of " + known);
  }
};

#endif // GEOMETRIC_CONTINUITY_DEMO_COMMAND_LINE_H
