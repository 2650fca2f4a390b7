// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Path data, transforms, lengths and points of SVG. A text is a list of transforms and, behind a
// line break, path data, whose orders of continuity are the same after the transforms. It is read
// as all the others, too.

#include "fuzz_target.h"

#include "formats/svg/Svg_transform.h"
#include "formats/svg/read_svg_path.h"
#include "formats/svg/svg_shapes.h"
#include <CGAL/Geometric_continuity/joins/path_continuity.h>

typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Exact;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Double;
typedef GC::Svg_subpath<Exact> Subpath;

namespace {

constexpr std::size_t max_joins = 16; // that are decided twice

void check(const Subpath& path) {
  for (std::size_t i = 1; i < path.segments.size(); ++i)
    require(path.segments[i - 1].end() == path.segments[i].start(), "a segment starts where the one before it ends");
  if (path.closed && !path.segments.empty())
    require(path.segments.back().end() == path.segments.front().start(), "a closed subpath ends where it starts");
}

void check_orders(const Subpath& path, const GC::Svg_transform<Exact>& map) {
  const Subpath image = path.transform(map);
  check(image);
  for (std::size_t i = 1; i < (std::min)(path.segments.size(), max_joins); ++i) {
    const auto join = GC::continuity(path.segments[i - 1], path.segments[i]);
    const auto join_of_images = GC::continuity(image.segments[i - 1], image.segments[i]);
    require(join.has_value() == join_of_images.has_value(), "a join is decided in all coordinates or in none");
    if (join)
      require(join->c_order == join_of_images->c_order && join->g_order == join_of_images->g_order &&
                  join->f_order == join_of_images->f_order,
              "no order of continuity depends on the coordinates");
  }
}

// Commands and numbers stand where the reader says, from the first character to the last one.
void check_places(std::string_view text) {
  GC::Svg_path_places places;
  GC::Svg_path_reader<Double> reader(text, "path data", &places);
  while (const auto subpath = reader.next())
    for (const auto& segment : subpath->segments) {
      const GC::Svg_command& command = places.commands[static_cast<std::size_t>(segment.command - 1)];
      require(segment.place == command.begin && segment.letter == command.letter, "a segment knows its command");
    }
  std::size_t end = 0;
  for (const GC::Text_range& range : places.numbers) {
    require(end <= range.begin && range.begin < range.end && range.end <= text.size(), "numbers follow each other");
    end = range.end;
    GC::parse_number<CGAL::Exact_rational>(text.substr(range.begin, range.end - range.begin));
  }
}

template <class Traits> void read_everything(std::string_view text) {
  accepts([&] { GC::read_svg_path<Traits>(text); });
  accepts([&] { GC::parse_svg_transform<Traits>(text); });
  accepts([&] { GC::read_svg_polyline<Traits>(text); });
  accepts([&] { GC::read_svg_polygon<Traits>(text); });
  accepts([&] { GC::parse_svg_length<typename Traits::FT>(text); });
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz_text(data, size);
  read_everything<Exact>(text);
  read_everything<Double>(text);
  accepts([&] { check_places(text); });
  const std::size_t end = (std::min)(text.find('\n'), text.size());
  accepts([&] {
    const GC::Svg_transform<Exact> map = GC::parse_svg_transform<Exact>(text.substr(0, end));
    for (const Subpath& path : GC::read_svg_path<Exact>(text.substr(end))) {
      check(path);
      if (map.determinant() != 0) check_orders(path, map);
    }
  });
  return 0;
}
