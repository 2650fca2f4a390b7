// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "command_line.h"
#include "deferred_output.h"
#include "join_report.h"
#include "svg_drawing.h"
#include "verify_drawings.h"

#include <CGAL/Geometric_continuity/IO/json.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <map>
#include <sstream>

#include <unistd.h>

namespace {

const char* const usage = "usage: geometric_continuity verify FILE.g2... | DRAWING.svg... [OPTIONS]\n"
                          "\n"
                          "Decides the continuity of every join of the chain that all curves form in the given order. "
                          "The decision is exact for\n"
                          "the numbers of the files. C: equal derivatives; G: equal arc-length derivatives; F: equal "
                          "Frenet frame and curvatures. The inner knots of a curve are joins as well.\n"
                          "With --surfaces finds all edges that the surfaces of the files share and decides G1 and G2 "
                          "along each whole edge\n"
                          "and along the knot lines inside B-spline surfaces.\n"
                          "Of SVG drawings decides the joins of every path and basic shape, and names the element and "
                          "the commands.\n"
                          "Exit code: 0 when every join meets the requirement, 1 when one does not, 2 on bad input.\n";

// Tells on a terminal how far a long chain has come, once a second.
class Progress {
  typedef std::chrono::steady_clock Clock;
  const bool shown_ = isatty(STDERR_FILENO);
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool written_ = false;

public:
  void step(std::size_t joins) {
    if (!shown_ || joins % 256 != 0 || Clock::now() < next_) return;
    std::cerr << '\r' << joins << " joins" << std::flush;
    next_ = Clock::now() + std::chrono::seconds(1);
    written_ = true;
  }
  ~Progress() {
    if (written_) std::cerr << "\r\033[K";
  }
};

// Collects what is reported of each join.
class Chain_report {
  const bool json_;
  const int max_order_;
  const std::optional<Requirement> requirement_;
  Deferred_output out_;
  Progress progress_;
  std::size_t joins_ = 0, failing_ = 0;

public:
  Chain_report(bool json, int max_order, const std::optional<Requirement>& requirement)
      : json_(json), max_order_(max_order), requirement_(requirement) {
    out_.write(json_ ? "{\"joins\":[" : table_head());
  }

  void operator()(const GC::Chain_join<Exact_curve>& join) {
    const int left = static_cast<int>(join.left), right = static_cast<int>(join.right);
    if (requirement_ && !requirement_->met(join.continuity)) ++failing_;
    if (json_) {
      std::ostringstream s;
      s << (joins_ == 0 ? "\n " : ",\n ");
      GC::write_json(s, join.continuity, left, right);
      out_.write(s.str());
    } else
      out_.write(table_row(join.continuity, left, right, join.left_curve, join.right_curve));
    progress_.step(++joins_);
  }

  // Prints all and returns whether the requirement is met.
  bool print(std::ostream& os, const GC::Chain_summary& summary) {
    const std::map<int, std::size_t>& counts = summary.counts(GC::Continuity_kind::G);
    out_.copy_to(os);
    if (json_) {
      os << "],\n \"summary\":{\"joins\":" << joins_;
      for (const auto& [order, count] : counts)
        os << ",\"" << (order < 0 ? "gap" : 'G' + std::to_string(order)) << "\":" << count;
      if (joins_ > 0)
        os << ",\"c_order\":" << *summary.least_order(GC::Continuity_kind::C)
           << ",\"g_order\":" << *summary.least_order(GC::Continuity_kind::G)
           << ",\"f_order\":" << *summary.least_order(GC::Continuity_kind::F);
      os << '}';
      if (requirement_)
        os << ",\n \"required\":\"" << requirement_->text() << "\",\"met\":" << (failing_ == 0 ? "true" : "false");
      os << "}\n";
    } else {
      os << joins_ << (joins_ == 1 ? " join" : " joins");
      for (const auto& [order, count] : counts)
        os << (order == counts.begin()->first ? ": " : ", ") << count << ' '
           << (order < 0 ? "gap" : 'G' + std::to_string(order) + (order == max_order_ ? " or more" : ""));
      os << '\n';
      if (requirement_ && failing_ == 0) os << "every join is " << requirement_->text() << ", proved exactly\n";
      if (requirement_ && failing_ > 0) os << failing_ << " of them not " << requirement_->text() << '\n';
    }
    return failing_ == 0;
  }
};

template <class FT>
int verify(const Arguments& files, bool closed, int max_order, bool json, const std::optional<Requirement>& required) {
  Chain_report report(json, max_order, required);
  GC::Chain_analysis<Exact_curve> chain(max_order);
  Curve_stream<FT, Exact> stream(files);
  while (const std::optional<Exact_curve> curve = stream.next()) {
    if (required && chain.size() == 0) required->check_dimension(curve->dimension());
    chain.add(*curve, report);
  }
  if (chain.size() == 1 && !closed)
    throw std::invalid_argument("a single curve has no join; --closed asks for the join of its end and its start");
  if (closed) chain.close(report);
  return report.print(std::cout, chain.summary()) ? requirement_met : requirement_not_met;
}

} // namespace

int verify_command(const Arguments& arguments) {
  const Command_line line(usage, arguments, [](po::options_description_easy_init add) {
    add("surfaces", "the files hold the patches of a model");
    add("closed", "the last curve leads back to the first");
    add("max-order", po::value<int>()->default_value(3), "the highest order to decide, from 0 to 32");
    add("require", po::value<std::string>(), "the order that every join must have: C1, G2, F3, ...");
    add("json", "print JSON");
    add("kernel", po::value<std::string>()->default_value("exact"),
        "exact: the numbers as written; double: each number is first rounded to a double, then all is exact");
  });
  if (line.help()) return requirement_met;
  if (line.files().empty()) throw std::invalid_argument("verify: no file is given; see --help");
  std::optional<Requirement> required;
  if (line.has("require")) required = Requirement(line.text("require"));
  const Arguments files = line.files();
  const auto drawings = std::count_if(files.begin(), files.end(), is_svg_file);
  if (drawings != 0) {
    if (drawings != static_cast<std::ptrdiff_t>(files.size()))
      throw std::invalid_argument("drawings (.svg) and curves (.g2) cannot be verified together");
    for (const char* option : {"surfaces", "closed"})
      if (line.has(option)) throw std::invalid_argument(std::string("--") + option + ": not for drawings");
    if (line.choice("kernel", {"exact", "double"}) != "exact")
      throw std::invalid_argument("--kernel double: drawings are read exactly");
  }
  if (line.has("surfaces")) {
    if (required && (required->kind() != GC::Continuity_kind::G || required->order() > 2))
      throw std::invalid_argument("--require " + required->text() + ": along an edge G0, G1 and G2 are decided");
    return verify_surfaces(line.files(), line.has("json"),
                           required ? std::optional<int>(required->order()) : std::nullopt);
  }
  int max_order = line.integer("max-order");
  if (max_order < 0 || max_order > 32) throw std::invalid_argument("--max-order: not from 0 to 32");
  if (required) max_order = std::max(max_order, required->order());
  const bool closed = line.has("closed"), json = line.has("json");
  if (drawings != 0) return verify_drawings(files, max_order, json, required);
  return line.choice("kernel", {"exact", "double"}) == "exact"
             ? verify<Exact>(line.files(), closed, max_order, json, required)
             : verify<double>(line.files(), closed, max_order, json, required);
}
