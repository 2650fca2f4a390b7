// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Drawings: the whole reader of the program, also of packed ones.

#include "fuzz_target.h"

#include "formats/svg/svg_drawing.h"

namespace {

struct Checking_handler : Drawing_handler {
  void subpath(const Drawing_element& element, int number, const Drawing_subpath& subpath) override {
    require(!subpath.segments.empty() || subpath.left_out > 0, "a subpath that is drawn has segments");
    require(element.line > 0 && number > 0, "lines and subpaths are numbered from 1");
    for (std::size_t i = 1; i < subpath.segments.size(); ++i)
      require(subpath.segments[i - 1].end() == subpath.segments[i].start(),
              "a segment starts where the one before it ends");
  }
  void not_read(const Drawing_element&, const std::string& reason) override {
    require(!reason.empty(), "what is not read has a reason");
  }
};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream stream{std::string(fuzz_text(data, size))};
  Checking_handler handler;
  accepts([&] { read_svg_drawing(stream, "fuzz.svg", handler); });
  return 0;
}
