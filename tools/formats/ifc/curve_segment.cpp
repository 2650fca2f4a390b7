// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/curve_segment.h"

#include "formats/ifc/spirals.h"
#include "formats/rails/Rail_check.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ifc {

namespace {

// A part of the graph of a polynomial from one arc length to another: both parameters are
// enclosed. The frame is that in which the graph has the direction of the placement at its start.
void read_inner_part(Segment& s, const Placement& p, std::vector<Q> y, const Q& from, const Q& l, bool by_length) {
  if (!by_length) throw Not_covered{"a part of a polynomial curve from an arc length on, by a parameter"};
  y.resize(4, Q(0));
  typedef GC::Parametric_cubic::Coefficients Coefficients;
  // turned by a half turn, which is the same graph backwards: -v(-t)
  const auto turned = [](const Coefficients& v) { return Coefficients{Q(0), v[1], Q(-v[2]), v[3]}; };
  const Coefficients given = {Q(0), y[1], y[2], y[3]}, v = l < 0 ? turned(given) : given,
                     mirrored = {Q(0), Q(-v[1]), Q(-v[2]), Q(-v[3])};
  const auto at = [&](const Placement& place, const Coefficients& graph, const Q& length) {
    if (!(length < 0)) return GC::Parametric_cubic::graph(place.x, place.y, place.heading, graph, length).end();
    const auto end = [&](const GC::Heading& heading) {
      return GC::Parametric_cubic::graph(place.x, place.y, heading, turned(graph), Q(-length)).end();
    };
    GC::Alignment_end result = end(place.heading); // the slope is the same
    result.point = end(place.heading.reversed()).point;
    if (result.curvature) result.curvature = result.curvature->reversed();
    return result;
  };
  const Q start = l < 0 ? Q(-from) : from, to = Q(start + absolute(l));
  const GC::Heading frame = at({Q(0), Q(0), p.heading}, mirrored, start).heading;
  s.start = GC::Alignment_end{GC::Enclosed_point(p.x, p.y), p.heading, at(p, v, start).curvature};
  s.end = at({p.x, p.y, frame}, v, to);
  s.end->point = s.end->point + at({Q(0), Q(0), frame.reversed()}, v, start).point;
  s.end->heading = at(p, v, to).heading;
  s.turned_from = Segment::Place_on_graph{start < 0 ? turned(v) : v, absolute(start)};
  s.length = absolute(l);
}

void read_polynomial(const File& file, Segment& s, const Placement& p, const Step_value& start,
                     const Step_value& length, const Entity& segment, const Entity& curve) {
  const std::vector<Step_value> a = file.arguments(curve, 3);
  const auto coefficients = [&](std::size_t i) {
    return a.size() <= i || a[i].kind == Kind::unset ? std::vector<Q>() : file.numbers(a[i], curve);
  };
  const std::vector<Q> x = coefficients(1), z = coefficients(3);
  std::vector<Q> y = coefficients(2);
  for (const Q& c : z)
    if (c != 0) throw Not_covered{"a polynomial curve in space"};
  if (x.size() < 2 || x[0] != 0 || x[1] != 1) throw Not_covered{"a polynomial curve that is no graph"};
  for (std::size_t i = 2; i < x.size(); ++i)
    if (x[i] != 0) throw Not_covered{"a polynomial curve that is no graph"};
  while (y.size() > 4 && y.back() == 0) y.pop_back();
  if (y.size() > 4) throw Not_covered{"a polynomial curve of a degree above 3"};
  const auto is_parameter = [](const Step_value& v) { return v.kind == Kind::typed && v.text == "IFCPARAMETERVALUE"; };
  const Q from = file.number(start, segment), l = file.number(length, segment);
  const bool by_length = !is_parameter(length) && l != 0;
  if (from != 0 && !is_parameter(start)) return read_inner_part(s, p, y, from, l, by_length || l == 0);
  // in the direction of travel from the start on, where it is turned into the direction of the
  // placement
  y.resize(4, Q(0));
  std::vector<Q> v = along(y, from, Q(l < 0 ? -1 : 1));
  v[0] = 0;
  const Q forwards(l < 0 ? -1 : 1);
  const GC::Heading frame = p.heading.turned(forwards, Q(-v[1]));
  const GC::Parametric_cubic::Coefficients u = {Q(0), forwards, Q(0), Q(0)}, w = {v[0], v[1], v[2], v[3]};
  s.bend = bend_of_graph(w, absolute(l), by_length);
  if (!by_length) {
    return set_ends(s, GC::Parametric_cubic(p.x, p.y, frame, u, w, absolute(l)), absolute(l));
  }
  // backwards it is (-t, w), which turned by a half turn is a graph
  const GC::Parametric_cubic c = l < 0 ? GC::Parametric_cubic::graph(p.x, p.y, p.heading.turned(Q(1), w[1]),
                                                                     {Q(0), Q(-w[1]), Q(-w[2]), Q(-w[3])}, absolute(l))
                                       : GC::Parametric_cubic::graph(p.x, p.y, frame, w, l);
  set_ends(s, c, absolute(l));
}

// A curve in a plane, moved so that it starts at the placement.
void read_plane(const File& file, Segment& s, const Placement& p, const Step_value& start, const Step_value& length,
                const Entity& segment, const Entity& curve) {
  if (curve.type == "IFCLINE") {
    const std::vector<Step_value> a = file.arguments(curve, 2);
    const Entity& vector = file.at(file.reference(a[1], curve), curve);
    const Q magnitude = file.number(file.arguments(vector, 2)[1], vector);
    const Q l = file.measure(length, segment, [&](const Q& x) { return Q(x * magnitude); });
    s.bend = bend_between(Q(0), Q(0));
    return set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, Q(0), Q(0), absolute(l)));
  }
  if (curve.type == "IFCCIRCLE") {
    const Q radius = file.number(file.arguments(curve, 2)[1], curve);
    if (!(radius > 0)) file.refuse(curve, "a radius that is not positive");
    const Q l = file.measure(length, segment, [&](const Q& x) { return Q(x * file.radians() * radius); });
    const Q k = Q((l < 0 ? -1 : 1) / radius);
    s.bend = bend_between(k, k);
    return set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, k, k, absolute(l)));
  }
  const auto same = [](const Q& x) { return x; }; // files give parameters of spirals as lengths
  if (curve.type == "IFCPOLYNOMIALCURVE") return read_polynomial(file, s, p, start, length, segment, curve);
  const Q from = file.measure(start, segment, same), l = file.measure(length, segment, same);
  const std::optional<Parent_curvature> k = spiral(file, curve);
  if (!k) throw Not_covered{"a segment of " + curve.type};
  s.rounded = k->has_waves() && from != 0;
  const GC::Curvature_law bent = law(*k, from, l);
  if (l == 0 || only_rises_or_falls(bent)) s.bend = bend_between(bent.at_start(), bent.at_end());
  set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, bent, absolute(l)));
}

// The cant is a graph over the distance along. Where the parent is a spiral its curvature times
// the length of the segment is the height.
void read_cant(const File& file, Segment& s, const Placement& p, const Step_value& start, const Step_value& length,
               const Entity& segment, const Entity& curve) {
  const auto same = [](const Q& x) { return x; };
  if (curve.type == "IFCLINE" || curve.type == "IFCCIRCLE" || curve.type == "IFCPOLYNOMIALCURVE")
    return read_plane(file, s, p, start, length, segment, curve);
  const Q from = file.measure(start, segment, same), l = file.measure(length, segment, same);
  if (l == 0) return set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, Q(0), Q(0), Q(0)));
  const std::optional<Parent_curvature> k = spiral(file, curve);
  if (!k) throw Not_covered{"a segment of " + curve.type};
  std::vector<Q> h = k->part(from, l); // of the part of the length
  for (Q& x : h) x = Q(x * l);         // backwards it is turned by a half turn
  const Q size = absolute(l), cosine = from == 0 ? k->cosine : Q(0), sine = from == 0 ? k->sine : Q(0);
  // l c cos(pi w) has no slope at both ends, l s sin(2 pi w) no second derivative
  const auto end = [&](const Q& w) {
    Q value(w == 0 ? Q(0) : Q(-2 * l * cosine)), slope(2 * long_pi() * sine * size),
        second((w == 0 ? -1 : 1) * long_pi() * long_pi() * cosine * l);
    for (std::size_t j = 0; j < h.size(); ++j) {
      const int n = static_cast<int>(j);
      if (j >= 1) value = Q(value + h[j] * power(w, n));
      if (j >= 1) slope = Q(slope + n * h[j] * power(w, n - 1));
      if (j >= 2) second = Q(second + n * (n - 1) * h[j] * power(w, n - 2));
    }
    slope = Q(slope / size);
    second = Q(second / (l * l));
    const Q speed = Q(1 + slope * slope);
    return GC::Alignment_end{GC::Enclosed_point(Q(p.x + w * size), Q(p.y + value)), GC::Heading(Q(0), Q(1), slope),
                             GC::End_curvature(second < 0   ? -1
                                               : second > 0 ? 1
                                                            : 0,
                                               Q(second * second / (speed * speed * speed)))};
  };
  s.rounded = k->has_waves();
  s.rounded_points = s.rounded && from != 0;
  s.start = end(Q(0));
  s.start->heading = p.heading; // as it is given
  s.end = end(Q(1));
  s.length = size;
}

} // namespace

Segment read_curve_segment(const File& file, std::uint64_t id, const Entity& of, bool is_cant) {
  const Entity& entity = file.at(id, of);
  Segment s;
  s.id = id;
  s.line = entity.line;
  if (entity.type != "IFCCURVESEGMENT") {
    s.not_covered = "a segment that is " + entity.type + ", not IfcCurveSegment";
    return s;
  }
  const std::vector<Step_value> a = file.arguments(entity, 5);
  s.claim = std::string(a[0].text);
  try {
    const Placement p = file.placement(file.reference(a[1], entity), entity);
    const Entity& curve = file.at(file.reference(a[4], entity), entity);
    s.shape = curve.type;
    if (is_cant)
      read_cant(file, s, p, a[2], a[3], entity, curve);
    else
      read_plane(file, s, p, a[2], a[3], entity, curve);
  } catch (const Not_covered& what) {
    s.not_covered = what.reason;
  }
  return s;
}

} // namespace ifc
