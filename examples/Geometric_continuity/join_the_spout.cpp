// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The spout of the Utah teapot runs into the body, but has no edge in common with it. A loop is cut
// out of the four patches of the body around that place, exactly; the spout is trimmed back; and
// eight blends lead from the one to the other.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/cut_back.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/svg_surfaces.h>

#include <fstream>
#include <iostream>
#include <optional>
#include <vector>

#ifndef GEOMETRIC_CONTINUITY_DATA // the folder of the data, which the build defines
#define GEOMETRIC_CONTINUITY_DATA "."
#endif

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef GC::Bezier_patch<Traits> Patch;
typedef GC::Side_of_blend<Patch, Patch> Side;
typedef GC::Bernstein_polynomial<FT> Polynomial;
constexpr GC::Patch_edge u0 = GC::Patch_edge::u0, u1 = GC::Patch_edge::u1, v0 = GC::Patch_edge::v0,
                         v1 = GC::Patch_edge::v1;

// From an edge of the body to the edge v0 of the spout, with an automatic shape, leaning to one
// side the more the farther along the edge; sides that are given are kept, and the derivatives
// across them.
Patch blend(const Patch& body, GC::Patch_edge edge, const Patch& spout, const FT& lean,
            const std::optional<Side>& at_start = {}, const std::optional<Side>& at_end = {}) {
  const GC::Edge_direction direction = nearer_direction(body, edge, spout, v0);
  auto shape = automatic_surface_shape(body, edge, spout, v0, GC::Minimal_energy<3>(), direction);
  shape.start.alpha = {0, lean * shape.start.beta[0]};
  shape.start.alpha2 = {0, lean * shape.start.delta[0]};
  shape = GC::surface_shape_with_sides(body, edge, spout, v0, direction, shape, at_start, at_end);
  return GC::blend(body, edge, spout, v0, shape, direction);
}

// In the plane y = 0, to which the teapot is symmetric.
Patch mirrored(const Patch& s) {
  std::vector<Traits::Point> points;
  for (const Traits::Point& p : s) points.emplace_back(p.x(), -p.y(), p.z());
  return Patch(s.degree_u(), s.degree_v(), points, s.domain_u(), s.domain_v());
}

int main() {
  std::ifstream stream(GEOMETRIC_CONTINUITY_DATA "/teapot.g2");
  const std::vector<Patch> teapot = GC::read_g2_surfaces<Traits>(stream, "teapot.g2");
  // the body where y < 0, with the corner (2, 0, 0.9) in common
  const Patch &above = teapot[4], &below = teapot[8];

  bool as_expected = mirrored(above) == teapot[7].reverse_u() && mirrored(below) == teapot[11].reverse_u() &&
                     mirrored(teapot[16]) == teapot[17].reverse_u();

  // The loop around the corner, in both patches: up to (1/6, 1/3) from it by y = 1/2 - 6 x^2, from
  // there on by x = 1/4 - 3/4 y^2.
  const FT x = FT(1) / 6, y = FT(1) / 3;
  const Polynomial height{FT(1) / 2, FT(1) / 2, y}, width{FT(1) / 4, FT(1) / 4, x}, rising{x, FT(1) / 4, FT(1) / 4};
  const Patch top = cut_back(above.split_u(x).first, v1, height),
              upper = cut_back(above.split_v(1 - y).second, u0, rising),
              lower = cut_back(below.split_v(y).first, u0, width),
              bottom = cut_back(below.split_u(x).first, v0, height);

  const Patch spout = cut_back(teapot[16], v0, FT(1) / 4);
  const auto halves = spout.split_u(FT(1) / 2);
  const auto of_top = halves.first.split_u(FT(1) / 4), of_bottom = halves.second.split_u(FT(3) / 4);

  const Patch first = blend(top, v1, of_top.first, -x), last = blend(bottom, v0, of_bottom.second, -x),
              second = blend(upper, u0, of_top.second, 0, Side(first, u1)),
              third = blend(lower, u0, of_bottom.first, 0, Side(second, u1), Side(last, u1));

  // the blends, then what they join, with the rest of both patches
  std::vector<Patch> model = {first, second, third, last, top, upper, lower, bottom};
  for (const auto& parts : {of_top, of_bottom}) model.insert(model.end(), {parts.first, parts.second});
  model.push_back(above.split_u(x).second.split_v(1 - y).first);
  model.push_back(below.split_u(x).second.split_v(y).second);
  const std::size_t half = model.size();
  for (std::size_t i = 0; i < half; ++i) model.push_back(mirrored(model[i]));
  int with_others[3] = {}, with_each_other[3] = {}; // of G0, G1, G2
  for (const auto& edge : GC::model_continuity(model).edges) {
    if (edge.kind != GC::Model_edge_kind::shared) continue;
    const bool a = edge.patch_a % half < 4, b = *edge.patch_b % half < 4; // whether they are blends
    if (a || b) ++(a && b ? with_each_other : with_others)[edge.continuity.g_order];
  }
  as_expected = with_others[2] == 16 && with_each_other[2] == 2 && with_each_other[1] == 6 && as_expected;
  bool folded = false;
  for (const Patch& s : {first, second, third, last}) folded = possible_fold(s) || folded;
  std::cout << "8 blends" << (folded ? ", may be folded" : ", not folded")
            << "\nwith body and spout: " << with_others[2] << " edges, G2\nwith each other: " << with_each_other[2]
            << " in the plane of symmetry, G2; " << with_each_other[1] << " others, G1\n";

  for (std::size_t i = 0; i < teapot.size(); ++i)
    if (i != 4 && i != 7 && i != 8 && i != 11 && i != 16 && i != 17) model.push_back(teapot[i]);
  std::ofstream picture("join_the_spout.svg");
  GC::Svg_surface_style style;
  style.azimuth = -30;
  GC::write_svg_surfaces(picture, model, style);
  return as_expected && !folded ? 0 : 1;
}
