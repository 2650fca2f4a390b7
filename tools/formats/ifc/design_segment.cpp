// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/design_segment.h"

#include "formats/ifc/Vertical_clothoid.h"
#include "formats/ifc/spirals.h"
#include "formats/rails/Rail_check.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ifc {

namespace {

// A vertical arc by its horizontal length: between the angles a and b the radius is
// length / (sin b - sin a), and the chord rises by tan((a + b) / 2).
void set_arc_of_length(Segment& s, const Q& x, const Q& height, const Q& g0, const Q& g1, const Q& length) {
  if (length == 0) throw Not_covered{"a vertical arc without a radius and a length"};
  const auto is_finite = [](const Q& g) { return std::fabs(CGAL::to_double(g)) < 1e140; };
  if (!is_finite(g0) || !is_finite(g1)) throw Not_covered{"a gradient beyond 10^140"};
  const Q root0 = long_root(Q(1 + g0 * g0)), root1 = long_root(Q(1 + g1 * g1)),
          rise = Q((g0 * root1 + g1 * root0) / (root0 + root1));
  const GC::End_curvature curvature{Q((g1 / root1 - g0 / root0) / length)};
  s.start = GC::Alignment_end{GC::Enclosed_point(x, height), GC::Heading(Q(0), Q(1), g0), curvature};
  s.end = GC::Alignment_end{GC::Enclosed_point(Q(x + length), Q(height + length * rise)), GC::Heading(Q(0), Q(1), g1),
                            curvature};
  s.length = length;
  s.rounded = s.rounded_points = true;
}

// A segment beside a vertical clothoid is nothing, straight or curved.
enum class Neighbour { none, gradient, curve };

Neighbour neighbour(const File& file, const Entity* e) {
  if (e == nullptr || e->type != "IFCALIGNMENTVERTICALSEGMENT") return Neighbour::none;
  const std::vector<Step_value> a = file.arguments(*e, 9);
  if (file.optional_number(a[3], *e).value_or(Q(0)) == 0) return Neighbour::none;
  const std::string_view type = a[8].text;
  if (type == "CONSTANTGRADIENT") return Neighbour::gradient;
  return type == "PARABOLICARC" || type == "CIRCULARARC" || type == "CLOTHOID" ? Neighbour::curve : Neighbour::none;
}

// IFC does not say at which end a vertical clothoid is straight. A transition leads from a
// gradient into a curve, or from a curve to a gradient.
bool is_straight_at_start(const File& file, const Entity* before, const Entity* after) {
  const Neighbour left = neighbour(file, before), right = neighbour(file, after);
  if (left == right)
    throw Not_covered{"a vertical clothoid " +
                      std::string(left == Neighbour::gradient ? "between two gradients"
                                  : left == Neighbour::curve  ? "between two curves"
                                                              : "without neighbours") +
                      ", so that nothing tells at which end it is straight"};
  return left == Neighbour::gradient || right == Neighbour::curve;
}

void set_clothoid(Segment& s, const Q& x, const Q& height, const Q& g0, const Q& g1, const Q& length, const Q& radius,
                  bool is_straight_at_start) {
  if (g0 == g1) throw Not_covered{"a vertical clothoid between equal gradients"};
  const auto is_low = [](const Q& g) { return std::fabs(CGAL::to_double(g)) < 1e9; };
  if (!is_low(g0) || !is_low(g1)) throw Not_covered{"a gradient beyond 10^9"};
  const Vertical_clothoid c(g0, g1, is_straight_at_start, radius == 0 ? std::nullopt : std::optional<Q>(radius),
                            length);
  const GC::End_curvature straight, bent(c.curvature);
  s.start = GC::Alignment_end{GC::Enclosed_point(x, height), GC::Heading(Q(0), Q(1), g0),
                              is_straight_at_start ? straight : bent};
  s.end = GC::Alignment_end{GC::Enclosed_point(Q(x + c.distance), Q(height + c.rise)), GC::Heading(Q(0), Q(1), g1),
                            is_straight_at_start ? bent : straight};
  s.length = length;
  s.rounded = s.rounded_points = true;
}

} // namespace

void read_horizontal_design(const File& file, Segment& s, const Entity& e) {
  const std::vector<Step_value> a = file.arguments(e, 9);
  const auto number = [&](std::size_t i) { return file.optional_number(a[i], e).value_or(Q(0)); };
  const auto curvature = [](const Q& radius) { return radius == 0 ? Q(0) : Q(1 / radius); };
  const std::vector<Q> p = file.coordinates(file.reference(a[2], e), e);
  const GC::Heading heading(Q(number(3) * file.radians()));
  const Q k0 = curvature(number(4)), k1 = curvature(number(5)), length = number(6);
  const std::string_view type = a[8].text;
  s.shape = std::string(type);
  if (length < 0) throw Not_covered{"a negative length"};
  if (type == "LINE" || type == "CIRCULARARC" || type == "CLOTHOID") {
    if (k0 != k1 && type != "CLOTHOID") throw Not_covered{"radii that differ, and no transition"};
    s.bend = bend_between(k0, k1);
    return set_ends(s, GC::Clothoid_segment(p[0], p[1], heading, k0, k1, length));
  }
  if (type == "CUBIC") {
    // y = x^3 / (6 R L) from the end that is straight, where x goes over the length; if that is
    // the second end, y = b ((x - L)^3 + L^3) with b = -1 / (6 R L)
    if (length == 0 || (k0 != 0 && k1 != 0)) throw Not_covered{"a cubic without a straight end"};
    const Q b = Q((k0 == 0 ? k1 : Q(-k0)) / (6 * length)), slope = k0 == 0 ? Q(0) : Q(3 * b * length * length),
            second = k0 == 0 ? Q(0) : Q(-3 * b * length);
    const GC::Parametric_cubic c(p[0], p[1], heading.turned(Q(1), Q(-slope)), {Q(0), Q(1), Q(0), Q(0)},
                                 {Q(0), slope, second, b}, length);
    s.bend = bend_of_graph({Q(0), slope, second, b}, length, false);
    return set_ends(s, c, length);
  }
  typedef GC::Curvature_law Law;
  std::optional<Law> law;
  if (type == "BLOSSCURVE") law = Law::bloss();
  if (type == "COSINECURVE") law = Law::cosine_curve();
  if (type == "SINECURVE") law = Law::sine_curve();
  if (type == "VIENNESEBEND") law = Law::viennese_bend();
  if (law || type == "HELMERTCURVE") s.bend = bend_between(k0, k1); // all of them only rise or fall
  if (type == "HELMERTCURVE") {                                     // two halves: 2 w^2, then 1 - 2 (1 - w)^2
    const Q middle = Q((k0 + k1) / 2), half = Q(length / 2);
    const GC::Clothoid_segment first(p[0], p[1], heading, Law::between(k0, middle, {{Q(0), Q(0), Q(1)}}), half);
    const GC::Clothoid_segment second(Q(0), Q(0), first.end_heading(), Law::between(middle, k1, {{Q(0), Q(2), Q(-1)}}),
                                      half);
    s.start = first.start();
    s.end = second.end();
    s.end->point = first.end_point() + second.end_point();
    s.length = length;
    return;
  }
  if (!law) throw Not_covered{"a segment of the type " + std::string(type)};
  return set_ends(s, GC::Clothoid_segment(p[0], p[1], heading, Law::between(k0, k1, *law), length));
}

void read_vertical_design(const File& file, Segment& s, const Entity& e, const Entity* before, const Entity* after) {
  const std::vector<Step_value> a = file.arguments(e, 9);
  const auto number = [&](std::size_t i) { return file.optional_number(a[i], e).value_or(Q(0)); };
  const Q x = number(2), length = number(3), height = number(4), g0 = number(5), g1 = number(6);
  const std::string_view type = a[8].text;
  if (length < 0) throw Not_covered{"a negative length"};
  if (type == "CIRCULARARC") { // by its radius, from one gradient to the other
    const Q radius = absolute(number(7));
    if (g0 == g1) throw Not_covered{"a vertical arc between equal gradients"};
    if (radius == 0) return set_arc_of_length(s, x, height, g0, g1, length);
    const Q r = g0 < g1 ? radius : Q(-radius);
    const GC::Heading from(Q(0), Q(1), g0), to(Q(0), Q(1), g1);
    const GC::Enclosed_point begin(x, height);
    const GC::End_curvature curvature{Q(1 / r)};
    s.start = GC::Alignment_end{begin, from, curvature};
    s.end = GC::Alignment_end{begin.moved(from, Q(0), r).moved(to, Q(0), Q(-r)), to, curvature}; // round the centre
    s.length = length;
    return;
  }
  if (type == "CLOTHOID" && length != 0)
    return set_clothoid(s, x, height, g0, g1, length, number(7), is_straight_at_start(file, before, after));
  const bool is_bent = type == "PARABOLICARC" || type == "CLOTHOID"; // a clothoid without a length
  if (!is_bent && (type != "CONSTANTGRADIENT" || g0 != g1))
    throw Not_covered{"a vertical segment of the type " + std::string(type) +
                      (type == "CONSTANTGRADIENT" ? " with two gradients" : "")};
  if (length == 0) {
    s.start = s.end =
        GC::Alignment_end{GC::Enclosed_point(x, height), GC::Heading(Q(0), Q(1), g0), GC::End_curvature()};
    if (is_bent) s.end->curvature = s.start->curvature = std::nullopt;
    s.length = length;
    return;
  }
  const GC::Parametric_cubic c(x, height, GC::Heading(), {Q(0), Q(1), Q(0), Q(0)},
                               {Q(0), g0, is_bent ? Q((g1 - g0) / (2 * length)) : Q(0), Q(0)}, length);
  set_ends(s, c, length);
}

} // namespace ifc
