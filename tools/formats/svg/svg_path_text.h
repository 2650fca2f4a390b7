// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_TEXT_H

#include "commands/repair/grid_contour.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Path data whose handles can be moved: the text stays as it is but for the numbers that must change. The grid is that of the decimals
// with the most digits behind the point among its coordinates.
class Svg_path_text {
  struct Token {
    std::size_t begin, end;
  };
  struct Command {
    char letter;                // that is in force
    std::optional<Token> given; // the letter, where it is written
    std::vector<Token> numbers;
  };
  // Where the handles of a curve stand.
  struct Origin {
    std::size_t subpath, curve, command;
    GC::Grid_vector start; // of relative coordinates
  };

  std::string text_;
  std::vector<Command> commands_;
  std::vector<Grid_contour> subpaths_;
  std::vector<Origin> origins_; // of the Bezier curves that are drawn by C, S, Q and T
  std::string refusal_;
  int decimals_ = 0;

  void split();
  void find_grid();
  void draw();
  std::string number(const Token& token) const { return text_.substr(token.begin, token.end - token.begin); }

public:
  // Takes path data that Svg_path_reader accepts.
  explicit Svg_path_text(std::string text);

  // Why its handles cannot be moved; empty when they can.
  const std::string& refusal() const { return refusal_; }

  // The subpaths with a curve, in order. Segments of no length are left out.
  const std::vector<Grid_contour>& subpaths() const { return subpaths_; }

  // The number of the command that draws a curve, from 1 on; 0 for a line or an arc.
  std::size_t command(std::size_t subpath, std::size_t curve) const;

  // A piece of text that takes the place of another one.
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };

  // Returns the edits, in order, that move the handles to where they are in these subpaths.
  std::vector<Edit> edits(const std::vector<Grid_contour>& subpaths) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_TEXT_H
