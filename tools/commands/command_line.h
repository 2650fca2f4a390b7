// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_COMMAND_LINE_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_COMMAND_LINE_H

#include "commands/commands.h"
#include "commands/did_you_mean.h"
#include "files/input.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <typeinfo>
#include <vector>

namespace po = boost::program_options;

// The arguments of one command: named options and files. Prints the help itself when it is asked
// for.
class Command_line {
  po::options_description options_;
  po::variables_map values_;

public:
  // Parses the arguments of a command.
  Command_line(const Command& command, const Arguments& arguments) : options_(options_of(command)) {
    po::options_description all;
    all.add(options_).add_options()("file", po::value<Arguments>());
    po::positional_options_description positional;
    positional.add("file", -1);
    namespace style = po::command_line_style;
    try {
      po::store(po::command_line_parser(arguments)
                    .options(all)
                    .positional(positional)
                    .style(style::unix_style & ~style::allow_guessing)
                    .run(),
                values_);
    } catch (const po::unknown_option& e) {
      throw std::invalid_argument(std::string(e.what()) + did_you_mean(e.get_option_name(), option_names(options_)));
    }
    if (help()) std::cout << command.usage << '\n' << options_;
    const Arguments names = files();
    if (std::count_if(names.begin(), names.end(), is_standard_input) > 1)
      throw std::invalid_argument("standard input is to be read twice");
  }

  // The options of a command, with their descriptions.
  static po::options_description options_of(const Command& command) {
    po::options_description options("options");
    command.describe(options.add_options()("help,h", "print this text"));
    return options;
  }

  // Their names, e.g. "--help".
  static Arguments option_names(const po::options_description& options) {
    Arguments names;
    for (const auto& option : options.options()) names.push_back("--" + option->long_name());
    return names;
  }

  // Returns whether the help was printed, so that nothing else is to be done.
  bool help() const { return values_.count("help") != 0; }

  // Returns whether an option is given; its default value does not count.
  bool has(const std::string& option) const { return values_.count(option) != 0 && !values_[option].defaulted(); }

  // Refuses options that have no meaning here, with the reason, e.g. "not with --surfaces".
  void refuse(const Arguments& options, const std::string& reason) const {
    for (const std::string& option : options)
      if (has(option)) throw std::invalid_argument("--" + option + ": " + reason);
  }

  // The arguments that are no options.
  Arguments files() const { return has("file") ? values_["file"].as<Arguments>() : Arguments(); }

  // The options that are given, but not these, as arguments for another call.
  Arguments given_options(const Arguments& without) const {
    Arguments options;
    for (const auto& [name, value] : values_) {
      if (value.defaulted() || name == "file" || std::count(without.begin(), without.end(), name) != 0) continue;
      if (value.value().type() == typeid(int))
        options.push_back("--" + name + '=' + std::to_string(value.as<int>()));
      else if (const std::string& text = value.as<std::string>(); !text.empty())
        options.push_back("--" + name + '=' + text);
      else
        options.push_back("--" + name);
    }
    return options;
  }

  // The value of an option, or its default value; empty when there is none.
  std::string text(const std::string& option) const {
    return values_.count(option) != 0 ? values_[option].as<std::string>() : "";
  }

  // The values of an option that may be given several times.
  Arguments texts(const std::string& option) const {
    return values_.count(option) != 0 ? values_[option].as<Arguments>() : Arguments();
  }

  int integer(const std::string& option) const { return values_[option].as<int>(); }

  // The value of an option that must not lie outside of these bounds.
  int integer(const std::string& option, int low, int high) const {
    const int value = integer(option);
    if (value < low || high < value)
      throw std::invalid_argument("--" + option + ": " + std::to_string(value) + " is not from " + std::to_string(low) +
                                  " to " + std::to_string(high));
    return value;
  }

  // The number that an option gives, or `otherwise` when it is not given.
  template <class FT> FT number(const std::string& option, const FT& otherwise) const {
    return has(option) ? parsed<FT>(option, text(option)) : otherwise;
  }

  // A length, rounded, that is a value of an option.
  static double positive_length(const std::string& option, const std::string& word) {
    const double value = parsed<double>(option, word);
    if (!(value > 0 && value < 1e9))
      throw std::invalid_argument("--" + option + ": '" + word + "' is not a positive length");
    return value;
  }
  // The length that an option gives, if it is given, rounded.
  std::optional<double> length(const std::string& option) const {
    if (!has(option)) return std::nullopt;
    return positive_length(option, text(option));
  }

  // The seconds that an option gives, or `otherwise` when it is not given.
  double seconds(const std::string& option, double otherwise) const {
    const double value = number(option, otherwise);
    if (!(value > 0 && value < 1e6))
      throw std::invalid_argument("--" + option + ": '" + text(option) + "' is not a positive number of seconds");
    return value;
  }

  // The numbers that an option gives, separated by commas.
  template <class FT> std::vector<FT> numbers(const std::string& option) const {
    const std::string words = text(option);
    std::vector<FT> result;
    for (std::size_t begin = 0, end; begin <= words.size(); begin = end + 1) {
      end = (std::min)(words.find(',', begin), words.size());
      result.push_back(parsed<FT>(option, words.substr(begin, end - begin)));
    }
    return result;
  }

  // Returns the value of --max-work, or the default of the library.
  CGAL::Geometric_continuity::Work_limit work_limit() const {
    if (!has("max-work")) return {};
    const std::string word = text("max-work");
    std::uint64_t steps = 0;
    const std::from_chars_result end = std::from_chars(word.data(), word.data() + word.size(), steps);
    if (end.ec != std::errc() || end.ptr != word.data() + word.size() || steps == 0)
      throw std::invalid_argument("--max-work: '" + word + "' is not a number of steps, such as 4000000000");
    return CGAL::Geometric_continuity::Work_limit(steps);
  }

  // The value of an option that must be one of the given words.
  std::string choice(const std::string& option, const Arguments& words) const {
    const std::string word = text(option);
    std::string known;
    for (const std::string& w : words) {
      if (w == word) return word;
      known += (known.empty() ? "" : ", ") + w;
    }
    throw std::invalid_argument("--" + option + ": '" + word + "' is none of " + known + did_you_mean(word, words));
  }

private:
  template <class FT> static FT parsed(const std::string& option, const std::string& word) {
    try {
      return CGAL::Geometric_continuity::parse_number<FT>(word);
    } catch (const std::exception& e) {
      throw std::invalid_argument("--" + option + ": " + e.what());
    }
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_COMMAND_LINE_H
