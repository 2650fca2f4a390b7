// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/Drawn_join.h"
#include "commands/chains/decided_join.h"
#include "commands/chains/join_report.h"
#include "commands/work_limit.h"
#include "files/progress.h"
#include "formats/g2_text/curves.h"
#include "reports/report_joins.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

// A curve of a chain as it is needed for the joins at both of its ends.
struct Chain_piece {
  std::size_t number;
  Exact_curve curve;
  std::optional<Plane_curve> plane; // the same, when it is polynomial and in the plane
  std::shared_ptr<const Report_curve> drawn;
  std::string file;

  Chain_piece(std::size_t number, const Exact_curve& curve, const std::string& file)
      : number(number), curve(curve), file(file) {
    if (curve.dimension() == 2 && curve.is_polynomial()) {
      std::vector<Drawing_traits::Point> points;
      for (int i = 0; i <= curve.degree(); ++i) points.emplace_back(curve.coordinates(i)[0], curve.coordinates(i)[1]);
      plane.emplace(points.begin(), points.end());
    }
  }

  // An infinite control point is none of the curve with a higher degree.
  const std::shared_ptr<const Report_curve>& drawing() {
    if (!drawn) {
      Exact_curve c = curve;
      const auto is_positive = [](const Exact& w) { return w > 0; };
      while (!std::all_of(c.weights().begin(), c.weights().end(), is_positive) && c.degree() < 128) c = c.elevate();
      Report_curve rounded = *drawn_curve(c, 0);
      if (!c.is_polynomial())
        for (const Exact& w : c.weights()) rounded.weights.push_back(CGAL::to_double(w));
      drawn = std::make_shared<const Report_curve>(std::move(rounded));
    }
    return drawn;
  }
};

typedef GC::Coordinate_vector<Exact, 0> Exact_vector;

// The grade and the measures of any join; where a tangent is zero, that of the drawn curves.
Report_item measured_exactly(const Exact_curve& left, const Exact_curve& right, const Report_demand& demand) {
  Report_item item;
  const Join join = decided_join(left, right, 2);
  const GC::Join_deviation d = GC::deviation(left, right);
  item.gap = d.gap;
  if (d.tangent_angle) item.angle = GC::in_degrees(*d.tangent_angle);
  const std::optional<Drawn_join> drawn =
      drawn_join(join, left.end_jet((std::max)(left.degree(), 1)), right.start_jet((std::max)(right.degree(), 1)),
                 demand.corner_threshold);
  if (drawn) item.angle = GC::in_degrees(drawn->angle);
  if (join.c_order < 0) {
    item.grade = Report_grade::gap;
    item.severity = d.gap.upper;
  } else if (!join.regular && !drawn)
    item.grade = Report_grade::undecided;
  else if (drawn ? drawn->is_smooth() : *join.tangent_equal) {
    item.grade = join.g_order < 2 ? Report_grade::g1 : Report_grade::g2;
    if (d.curvature_jump) item.curvature_jump = GC::in_percent(*d.curvature_jump);
    item.severity = item.curvature_jump ? item.curvature_jump->upper : 0;
  } else {
    const bool is_corner = drawn ? drawn->grade == GC::Visual_class::corner
                                 : exceeds(demand.corner_threshold, left.end_jet(1)[1], right.start_jet(1)[1]);
    item.grade = is_corner ? Report_grade::corner : Report_grade::kink;
    const auto distance = [](const Exact_curve& c, int i, int j) {
      const Exact_vector v = c.coordinates(j) - c.coordinates(i);
      return GC::sqrt_enclosure(Exact(dot(v, v))).upper;
    };
    const double handle = (std::min)(distance(left, left.degree() - 1, left.degree()), distance(right, 0, 1));
    item.severity = (drawn ? drawn->angle : *d.tangent_angle).upper * handle;
  }
  item.verdict = item.grade == Report_grade::undecided ? "a curve has no direction" : report_words(item.grade, false);
  for (int i = 0; i < right.dimension(); ++i)
    item.point.push_back(rounded(CGAL::to_double(right.coordinates(0)[i]), 9));
  return item;
}

void show_join(Chain_piece& left, Chain_piece& right, bool several_files,
               const std::shared_ptr<Report_outline>& outline, const Report_demand& demand, Report_page& page) {
  const auto place = [&] {
    return (several_files ? right.file + ": " : "") + "curve " + std::to_string(left.number) + " - curve " +
           std::to_string(right.number);
  };
  within_work_limit(
      [&] { return right.file + ": join " + std::to_string(left.number) + " -> " + std::to_string(right.number); },
      [&] {
        Report_item item = left.plane && right.plane ? measured_join(*left.plane, *right.plane, demand)
                                                     : measured_exactly(left.curve, right.curve, demand);
        if (!page.count(item.grade, item.severity)) return;
        item.number = page.total();
        item.place = place();
        item.verdict = orders(decided_join(left.curve, right.curve, 3)) + ": " + item.verdict;
        item.left = left.drawing();
        item.right = right.drawing();
        item.outline = outline;
        page.add(std::move(item));
      });
}

} // namespace

void report_chain(const Arguments& files, const Report_demand& demand, Report_page& page) {
  Curve_stream<GC::G2_piece_reader<Program_traits<Exact>>> stream(files);
  Progress progress("joins");
  std::unique_ptr<Chain_piece> first, last;
  const auto outline = std::make_shared<Report_outline>();
  std::size_t size = 0;
  for (std::optional<Exact_curve> curve; stream.next(curve); ++size) {
    auto piece = std::make_unique<Chain_piece>(size, *curve, stream.file());
    page.dimension = curve->dimension();
    page.include(piece->drawing()->points);
    if (size < most_curves_of_outline)
      outline->push_back(piece->drawing());
    else
      outline->clear();
    if (last) show_join(*last, *piece, files.size() > 1, outline, demand, page);
    if (size == 0) {
      first = std::make_unique<Chain_piece>(*piece);
    }
    last = std::move(piece);
    progress.step(page.total(), [&] { return stream.part_read(); });
  }
  if (demand.closed && first) show_join(*last, size > 1 ? *first : *last, files.size() > 1, outline, demand, page);
  page.summary = counted(page.total(), "join") + " of a chain of " + counted(size, "curve");
  page.finish();
}
