// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/program_texts.h"
#include "files/cores.h"
#include "files/standard_streams.h"
#include "files/sudden_end.h"
#include "formats/input_formats.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const program_usage = R"(usage: geometric_continuity COMMAND [ARGUMENTS]

  blend A.g2 B.g2           blend the end of A into the start of B, and prove
                            both joins
  connect C.g2 C1.g2 C2.g2  make two surfaces that meet with G1 continuity along
                            a cubic spline
  match A.g2 B.g2           change a surface near an edge so that it continues
                            another one with G1, G2 or G3
  extend A.g2               append a segment with continuous tangent, curvature
                            or torsion
  interpolate POINTS        lead a curve through points, with continuous
                            curvature
  fit POINTS                make few smooth curves near a polyline, and prove
                            their distance
  verify FILE.g2...         decide the continuity of every join of a chain, of a
                            drawing (.svg), a toolpath (.ngc), a font, or roads
                            and rails (.xodr, .ifc), exactly, and enclose that
                            of every edge of a CAD model (.step, .iges)
  merge RECORDS...          add up what verify --jsonl has written of many files
  repair FILE -o FILE       make kinks of a drawing, a chain or a font exactly
                            smooth, on its own grid, and join roads
  plot FILE.g2...           draw curves, control polygons and curvature combs,
                            or surfaces
  report FILE... -o OUT.html
                            show the joins of chains, drawings, fonts, models or
                            roads, the worst first, on a page
  tessellate MODEL.g2...    write triangles for surfaces, without cracks, as
                            OFF, PLY, OBJ or STL
  round-edges MODEL...      replace the sharp edges of a solid or a model by
                            surfaces with continuous curvature, and prove it

A curve with inner knots is taken as the chain of its Bezier curves, so that
its knots are joins. The name - is standard input, and standard output.
geometric_continuity COMMAND --help explains a command; --version tells the
version. --man-page and --bash-completion write what an installation has: the
manual page geometric_continuity(1), and a script that completes commands,
options and strategies.
Exit code: 0 when the requirement is met, 1 when it is not, 2 on bad input and
when the output cannot be written.
)";

using CGAL::Geometric_continuity::printable;

const std::vector<const Command*> commands = {
    &blend_command,  &connect_command,    &match_command,      &extend_command, &interpolate_command,
    &fit_command,    &verify_command,     &merge_command,      &repair_command, &plot_command,
    &report_command, &tessellate_command, &round_edges_command};

// Parses the arguments. Where the value of an option is missing that is one of some words, the
// error lists them.
Command_line parsed(const Command& command, const Arguments& arguments) try {
  return Command_line(command, arguments);
} catch (const po::invalid_command_line_syntax& e) {
  const auto words = option_words();
  std::string option = e.get_option_name(), known;
  const auto entry = words.find(option.erase(0, option.find_first_not_of('-')));
  if (entry == words.end()) throw;
  for (const std::string& word : entry->second) known += (known.empty() ? "; it is one of " : ", ") + word;
  throw std::invalid_argument(e.what() + known);
}

int run(const std::string& name, const Arguments& arguments) {
  Arguments names;
  for (const Command* command : commands) {
    if (command->name == name) {
      const Command_line line = parsed(*command, arguments);
      if (line.help()) return requirement_met;
      check_input_formats(name, line.files());
      return command->run(line);
    }
    names.push_back(command->name);
  }
  std::cerr << "geometric_continuity: unknown command '" << printable(name) << "'" << did_you_mean(name, names) << '\n';
  if (did_you_mean(name, names).empty()) std::cerr << program_usage;
  return bad_input;
}

int run(const Arguments& arguments) {
  if (arguments.empty()) {
    std::cerr << program_usage;
    return bad_input;
  }
  if (arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "help") {
    std::cout << program_usage;
    return requirement_met;
  }
  if (arguments[0] == "--man-page") {
    write_manual_page(std::cout, program_usage, commands);
    return requirement_met;
  }
  if (arguments[0] == "--bash-completion") {
    write_bash_completion(std::cout, commands);
    return requirement_met;
  }
  if (arguments[0] == "--version") {
    std::cout << "geometric_continuity " << GEOMETRIC_CONTINUITY_VERSION << '\n';
    return requirement_met;
  }
  try {
    [[maybe_unused]] const Cores cores;
    return run(arguments[0], Arguments(arguments.begin() + 1, arguments.end()));
  } catch (const std::bad_alloc&) { // more than any system could give
    std::cerr << "geometric_continuity: out of memory\n";
  } catch (const std::exception& e) {
    std::cerr << "geometric_continuity: " << printable(e.what()) << '\n';
  }
  return bad_input;
}

} // namespace

int main(int argc, char* argv[]) {
  occupy_standard_descriptors();
  take_stack();
  end_when_memory_runs_out();
  clean_up_at_signals();
  Standard_output output;
  return output.finish(run(Arguments(argv + (argc > 0 ? 1 : 0), argv + argc)));
}
