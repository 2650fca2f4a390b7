// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Asks is_g1_join(), is_g2_join() and is_g3_join() of all joins of a corpus whose coordinates are
// doubles; count_stages.h counts what decides.
//   count_stages fonts FONT_OR_FOLDER...
//   count_stages drawings FILE.svg...   their joins of Bezier curves; the doubles nearest to the
//                                       coordinates in the drawing
//   count_stages blends                 of random curves, rounded to doubles: G2 up to rounding
//   count_stages representable_blends   of the same curves

#include "formats/font/Font_face.h"
#include "formats/font/font_files.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef std::vector<std::string> Words;

// Asks the questions about joins.
class Questions {
  std::size_t joins_ = 0;

public:
  std::size_t joins() const { return joins_; }

  template <class Curve> void ask(const Curve& left, const Curve& right) {
    ++joins_;
    GC::is_g1_join(left, right);
    GC::is_g2_join(left, right);
    GC::is_g3_join(left, right);
  }
};

typedef GC::Bezier_curve<GC::Traits_2<Kernel>> Plane_curve;

void ask_fonts(const Words& names, Questions& questions) {
  std::vector<Unread_file> not_read;
  Glyph_outline outline;
  const auto curve = [&outline](const Glyph_segment& s) {
    std::vector<Kernel::Point_2> points;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(s.degree); ++i)
      points.emplace_back(std::ldexp(static_cast<double>(s.points[i].x), -outline.shift()),
                          std::ldexp(static_cast<double>(s.points[i].y), -outline.shift()));
    return Plane_curve(points.begin(), points.end());
  };
  for (const Font_file& file : font_files(names, not_read)) {
    const std::string bytes = read_bytes(file.name);
    for (int i = 0, fonts = 1; i < fonts; ++i) try {
        const Font_face font(bytes, i);
        fonts = font.fonts_of_file();
        for (int glyph = 0; glyph < font.glyphs(); ++glyph) try {
            font.read(glyph, outline);
            for (std::size_t contour = 0; contour < outline.contours(); ++contour) {
              Plane_curve left = curve(*(outline.end(contour) - 1));
              for (const Glyph_segment* s = outline.begin(contour); s != outline.end(contour); ++s) {
                const Plane_curve right = curve(*s);
                questions.ask(left, right);
                left = right;
              }
            }
          } catch (const Font_error&) {
          }
      } catch (const Font_error&) {
      }
  }
}

double nearest(const CGAL::Exact_rational& q) {
  typedef CGAL::Exact_rational FT;
  const double x = CGAL::to_double(q), infinity = std::numeric_limits<double>::infinity();
  if (FT(x) == q) return x;
  const double y = std::nextafter(x, FT(x) < q ? infinity : -infinity);
  return CGAL::abs(FT(q - FT(y))) < CGAL::abs(FT(q - FT(x))) ? y : x;
}

class Drawing_questions : public Drawing_handler {
  Questions& questions_;

public:
  explicit Drawing_questions(Questions& questions) : questions_(questions) {}

  void subpath(const Drawing_element&, int, const Drawing_subpath& path) override {
    std::vector<std::optional<Plane_curve>> curves;
    for (const auto& segment : path.segments) {
      curves.emplace_back();
      if (!segment.bezier()) continue;
      std::vector<Kernel::Point_2> points;
      for (const auto& p : *segment.bezier()) points.emplace_back(nearest(p.x()), nearest(p.y()));
      curves.back().emplace(points.begin(), points.end());
    }
    for (std::size_t i = 0; i < path.joins(); ++i) {
      const std::optional<Plane_curve>&left = curves[i], &right = curves[(i + 1) % curves.size()];
      if (left && right) questions_.ask(*left, *right);
    }
  }
  void not_read(const Drawing_element&, const std::string&) override {}
};

void ask_drawings(const Words& files, Questions& questions) {
  Drawing_questions handler(questions);
  for (const std::string& file : files) try {
      read_svg_drawing(file, handler);
    } catch (const GC::Error& error) {
      std::cerr << error.what() << '\n';
    }
}

// Blends of cubics in the plane or in space.
template <class Traits> class Random_blends {
  typedef GC::Bezier_curve<Traits> Curve;
  enum Numbers { integers, decimals, doubles };
  std::mt19937_64 engine_{2026};

  double number(Numbers kind) {
    const double p = static_cast<double>(engine_() % 2001) - 1000;
    switch (kind) {
    case integers: return p;
    case decimals: return p / 100;
    default: return std::ldexp(static_cast<double>(static_cast<long>(engine_() >> 11)) - 0x1p52, -50);
    }
  }
  Curve cubic(Numbers kind) {
    std::vector<typename Traits::Point> points;
    for (int j = 0; j <= 3; ++j) {
      GC::Coordinates<Traits> x(GC::dimension_v<Traits>);
      for (int i = 0; i < x.dimension(); ++i) x[i] = number(kind);
      points.push_back(GC::to_point<Traits>(x));
    }
    return Curve(points.begin(), points.end());
  }

public:
  void ask(bool representable, Questions& questions) {
    for (Numbers kind : {integers, decimals, doubles})
      for (int i = 0; i < 10000; ++i) {
        const Curve phi = cubic(kind), psi = cubic(kind);
        if (representable) {
          const auto blend = GC::representable_blend(phi, psi);
          const Curve curve(blend.begin(), blend.end());
          questions.ask(blend.phi, curve);
          questions.ask(curve, blend.psi);
        } else {
          const auto blend = GC::blend(phi, psi);
          const Curve curve(blend.begin(), blend.end());
          questions.ask(phi, curve);
          questions.ask(curve, psi);
        }
      }
  }
};

int main(int argc, char** argv) {
  try {
    Words words(argv + 1, argv + argc);
    if (words.empty()) throw std::invalid_argument("usage: count_stages CORPUS [FILE...]");
    const std::string corpus = words[0];
    words.erase(words.begin());
    Questions questions;
    if (corpus == "fonts")
      ask_fonts(words, questions);
    else if (corpus == "drawings")
      ask_drawings(words, questions);
    else if (corpus == "blends" || corpus == "representable_blends") {
      Random_blends<GC::Traits_2<Kernel>>().ask(corpus != "blends", questions);
      Random_blends<GC::Traits_3<Kernel>>().ask(corpus != "blends", questions);
    } else
      throw std::invalid_argument("unknown corpus: " + corpus);
    std::cout << questions.joins() << " joins\n";
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "count_stages: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
