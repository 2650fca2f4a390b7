// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_DEFERRED_OUTPUT_H
#define GEOMETRIC_CONTINUITY_DEMO_DEFERRED_OUTPUT_H

#include <CGAL/Geometric_continuity/Error.h>

#include <array>
#include <cstdio>
#include <memory>
#include <ostream>
#include <string>

// Collects output until all input has been read and found good. It may be larger than the memory.
class Deferred_output {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;

  [[noreturn]] static void refuse() {
    throw CGAL::Geometric_continuity::Error(CGAL::Geometric_continuity::Error_code::cannot_write_file,
                                            "temporary file");
  }

public:
  Deferred_output() : file_(std::tmpfile(), std::fclose) {
    if (!file_) refuse();
  }
  void write(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) refuse();
  }

  // Copies everything that was written.
  void copy_to(std::ostream& os) {
    std::rewind(file_.get());
    std::array<char, 1 << 16> block;
    while (const std::size_t n = std::fread(block.data(), 1, block.size(), file_.get())) os.write(block.data(), n);
  }
};

#endif // GEOMETRIC_CONTINUITY_DEMO_DEFERRED_OUTPUT_H
