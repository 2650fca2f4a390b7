// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/write_font.h"

#include "files/Temporary_file.h"
#include "files/call_python.h"
#include "font_script_text.h"

#include <CGAL/Geometric_continuity/Error.h>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include <unistd.h>

namespace GC = CGAL::Geometric_continuity;

namespace {

// A file that is there as long as this object, for a program that reads it.
class Passed_file {
  const std::string name_;
  GC::Temporary_file file_;

public:
  explicit Passed_file(const std::string& text)
      : name_("a temporary file"), file_(std::filesystem::temp_directory_path().string(), 0600, name_) {
    for (std::size_t written = 0; written < text.size();) {
      const ssize_t n = ::write(file_.descriptor(), text.data() + written, text.size() - written);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) GC::refuse_to_write(name_, errno);
      written += static_cast<std::size_t>(n);
    }
  }
  std::string path() const { return file_.path(); }
};

Written_font run_script(const std::vector<std::string>& arguments, const std::string& file, const std::string& call) {
  std::optional<Process_end> end = call_python(font_script, arguments);
  if (!end)
    throw std::runtime_error("--output: fontTools writes fonts, and no python3 has it; install it (Debian: apt install "
                             "python3-fonttools; pip install fonttools), or name a Python that has it by "
                             "GEOMETRIC_CONTINUITY_PYTHON; or call " +
                             call);
  if (!has_ended_with(*end, 0))
    throw GC::Error(GC::Error_code::malformed_input, file + ": fontTools does not write it: " + last_message(*end));
  return {std::move(end->output), std::move(end->errors)};
}

} // namespace

Written_font font_with_moves(const std::string& bytes, const std::string& moves, const std::string& ending,
                             const std::string& file) {
  const Passed_file font(bytes), list(moves);
  return run_script({font.path(), list.path(), '-' + ending}, file,
                    "geometric_continuity repair " + file +
                        " -o MOVES.json, and where there is a Python with "
                        "fontTools, python3 write_font.py " +
                        file + " MOVES.json RESULT" + ending);
}

Written_font font_with_mended_masters(const std::string& bytes, const std::vector<std::string>& options,
                                      const std::string& ending, const std::string& file) {
  const Passed_file font(bytes);
  std::vector<std::string> arguments{font.path(), "--masters"};
  std::string call = "python3 write_font.py " + file + " --masters ";
  for (const std::string& option : options) {
    arguments.push_back(option);
    call += option + ' ';
  }
  arguments.push_back('-' + ending);
  return run_script(arguments, file, call + "RESULT" + ending + " where there is one");
}
