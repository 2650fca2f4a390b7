// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "Request.h"
#include "call.h"

#include "commands/chains/verify_chain.h"
#include "commands/commands.h"
#include "commands/drawings/verify_drawings.h"
#include "commands/repair/repair_drawing.h"
#include "formats/svg/Unpacked_bytes.h"
#include "memory_file.h"

#include <algorithm>
#include <iostream>
#include <sstream>

// What geometric_continuity.mjs calls of files: the commands `verify` and `repair` of the program, which print their JSON on standard output.
// The text of the file follows the options.

namespace {

// While it exists standard output is this stream.
class Captured_output {
  std::streambuf* const before_;

public:
  explicit Captured_output(std::ostream& os) : before_(std::cout.rdbuf(os.rdbuf())) {}
  Captured_output(const Captured_output&) = delete;
  Captured_output& operator=(const Captured_output&) = delete;
  ~Captured_output() { std::cout.rdbuf(before_); }
};

// A report of nothing is a report.
Report_mode json_mode() {
  Report_mode mode;
  mode.format = Report_format::json;
  mode.allow_empty = true;
  return mode;
}

std::optional<Requirement> requirement(Request& request) {
  const std::string text(request.word());
  return text == "-" ? std::nullopt : std::optional<Requirement>(text);
}

void verify_svg(Request& request, std::ostream& os) {
  const int max_order = request.count();
  const std::optional<Requirement> required = requirement(request);
  const Exact degrees = request.exact();
  std::ostringstream degrees_text;
  GC::write_number(degrees_text, degrees);
  const Kink_rule kinks{degrees_text.str(), GC::Kink_bound(degrees)};
  const Memory_file file("drawing.svg", request.text());
  const Captured_output output(os);
  verify_drawings({file.name()}, required ? (std::max)(max_order, required->order()) : max_order, json_mode(), required,
                  kinks);
}

void repair_svg(Request& request, std::ostream& os) {
  Repair_options options;
  options.bound = GC::Kink_bound(request.exact());
  options.max_move = request.optional_exact();
  options.harmonise = request.count() != 0;
  const std::string name = "drawing.svg", text = request.text();
  if (!text.empty() && Unpacked_bytes::may_begin(text[0]))
    throw GC::Error(GC::Error_code::malformed_input, name + ": packed by gzip; unpack it first");
  Repair_report report(json_mode());
  const std::string svg = repaired_drawing(text, name, options, report);
  GC::write_json(os << "{\"svg\":", svg);
  report.print(os << ",\"report\":", name);
  os << '}';
}

void verify_g2(Request& request, std::ostream& os) {
  const int max_order = request.count();
  const std::optional<Requirement> required = requirement(request);
  const bool closed = request.count() != 0, surfaces = request.count() != 0;
  const Memory_file file("curves.g2", request.text());
  const Captured_output output(os);
  if (surfaces) {
    if (required && (required->kind() != GC::Continuity_kind::G || required->order() > 2))
      throw GC::Error(GC::Error_code::malformed_input, "verifyG2: along an edge G0, G1 and G2 are decided");
    verify_surfaces({file.name()}, json_mode(), required ? std::optional<int>(required->order()) : std::nullopt,
                    std::nullopt);
  } else
    verify_chain(
        {file.name()}, false, closed, json_mode(),
        {required ? (std::max)(max_order, required->order()) : max_order, required, std::nullopt, GC::Kink_bound()});
}

} // namespace

const std::vector<Module_function> module_functions = {
    {"verifySvg", verify_svg}, {"repairSvg", repair_svg}, {"verifyG2", verify_g2}};
