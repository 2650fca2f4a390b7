// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Two faults of published road maps, rebuilt on two short roads: a sidewalk that becomes 20 m wide
// where 2.0 was meant, and lanes that step to the side because the lane offset is forgotten where a
// lane ends. Draws the borders of the lanes, in the picture road_faults.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/models/Road_network.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef GC::Road_number Number;
const Number half = Number(1) / 2;

// Tells of lanes that do not meet; all other joins are passed over.
struct Tell {
  void operator()(const GC::Road_section_join& x) const {
    std::cout << "lane " << x.lane.id << " to " << x.to.id << ": apart by " << CGAL::to_double(x.jump()) << " m, "
              << (x.within ? "within 1 mm\n" : "not within 1 mm\n");
  }
  template <class Other> void operator()(const Other&) const {}
};

// A section with lanes on the right of the given widths, each of which goes on.
GC::Road_section section(int s, const std::vector<Number>& widths) {
  GC::Road_section result{Number(s)};
  for (const Number& width : widths) {
    GC::Road_lane lane;
    lane.id = -1 - static_cast<int>(result.lanes.size());
    lane.widths = {{Number(0), width, Number(0), Number(0), Number(0)}};
    lane.successors = {lane.id};
    result.lanes.push_back(lane);
  }
  return result;
}

// The borders of both sections, which are 30 m long.
GC::Svg_panel drawn(const char* title, const GC::Road& road) {
  GC::Svg_panel panel(title);
  for (const GC::Road_section& s : road.sections) {
    const bool is_first = s.s == Number(0);
    Number t = road.lane_offset[is_first ? 0 : road.lane_offset.size() - 1].a;
    for (std::size_t i = 0; i <= s.lanes.size(); ++i) {
      const Traits::Point from(is_first ? 0 : 30, t), to(is_first ? 30 : 60, t);
      panel.add(GC::Bezier_curve<Traits>{from, to},
                {is_first ? GC::Svg_role::given : GC::Svg_role::result, false, false, is_first ? "before" : "behind"});
      if (i < s.lanes.size()) t = Number(t - s.lanes[i].widths[0].a);
    }
  }
  return panel;
}

int main() {
  GC::Road sidewalk{"10", "-1", Number(60)}, step{"231", "-1", Number(60)};
  sidewalk.lane_offset = {{Number(0), Number(0), Number(0), Number(0), Number(0)}};
  sidewalk.sections = {section(0, {half * 7, Number(2)}), section(30, {half * 7, Number(20)})};
  step.lane_offset = {{Number(0), half, Number(0), Number(0), Number(0)},
                      {Number(30), Number(0), Number(0), Number(0), Number(0)}};
  step.sections = {section(0, {half * 7, half * 7}), section(30, {half * 7, half * 7})};
  for (const GC::Road& road : {sidewalk, step}) {
    std::cout << "road " << road.id << ":\n";
    GC::road_joins({{road}, {}}, {}, Tell());
  }
  GC::Svg_figure figure("Two faults of road maps, in plan", 1);
  figure.add(drawn("a sidewalk 20 m wide: its outer border is 18 m off", sidewalk));
  figure.add(drawn("a lane offset that is forgotten: all borders are 0.5 m off", step));
  std::ofstream("road_faults.svg") << figure;
  return 0;
}
