// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_sources.h"

#include "commands/kink_options.h"
#include "files/call_python.h"
#include "files/output.h"
#include "formats/input_formats.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <stdexcept>

namespace {

// Calls the function `main` of the module with the arguments of the program.
const char* const source_script = R"(import sys
try:
    from geometric_continuity.adapters.sources import main
except ImportError:
    sys.exit(3)
sys.exit(main(sys.argv[1:]))
)";

int call_module(const Arguments& arguments, const std::string& file) {
  const std::optional<Process_end> end = call_python(source_script, arguments);
  if (!end)
    throw std::runtime_error(file + ": sources of fonts are read by the Python module geometric_continuity, which no "
                                    "python3 has; install it (python/install) with ufoLib2 and glyphsLib (Debian: "
                                    "python3-ufolib2 python3-glyphslib), or name a Python that has it by "
                                    "GEOMETRIC_CONTINUITY_PYTHON; or make a font of it with fontmake");
  std::cout << end->output;
  for (const int code : {0, 1})
    if (has_ended_with(*end, code)) return code;
  throw std::runtime_error(file + ": " + last_message(*end));
}

// A name that begins with - is no option.
std::string as_argument(const std::string& file) { return file[0] == '-' ? "./" + file : file; }

} // namespace

int verify_font_sources(const Command_line& line) {
  const Arguments files = line.files();
  if (!std::all_of(files.begin(), files.end(), is_font_source))
    throw std::invalid_argument(
        "sources of fonts (.ufo, .glyphs, .designspace) cannot be verified together with others");
  const Arguments taken{"file", "require", "kink-angle", "json", "allow-undecided", "allow-uncovered"};
  const Arguments given = line.given_options(taken);
  if (!given.empty()) throw std::invalid_argument(given.front() + ": not for sources of fonts");
  corner_threshold(line); // refuses other angles
  Arguments arguments{"verify"};
  for (const std::string name : {"require", "kink-angle"})
    if (line.has(name)) arguments.insert(arguments.end(), {"--" + name, line.text(name)});
  if (line.has("json")) arguments.push_back("--json");
  for (const std::string& file : files) arguments.push_back(as_argument(file));
  return call_module(arguments, files[0]);
}

int repair_font_source(const Command_line& line) {
  line.refuse({"closed", "json", "off-by"}, "not for sources of fonts");
  const std::string file = line.files()[0], output = line.text("output");
  std::string name = file;
  name.erase(name.find_last_not_of('/') + 1);
  if (extension(output) != extension(name))
    throw std::invalid_argument("--output: " + output + ": the format is " + extension(name) + ", as of " + file);
  Arguments arguments{"repair", "--to", line.choice("to", {"G1", "G2"}), "--kink-angle", line.text("kink-angle")};
  if (line.has("max-move")) arguments.insert(arguments.end(), {"--max-move", line.text("max-move")});
  arguments.insert(arguments.end(), {as_argument(file), as_argument(output)});
  return call_module(arguments, file);
}
