// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/read_ifc.h"

#include "files/input.h"
#include "files/output.h"
#include "formats/ifc/Step_file.h"
#include "formats/ifc/Vertical_clothoid.h"

#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_rational Q;
typedef Step_file::Entity Entity;
typedef Step_value::Kind Kind;

// Thrown for a segment that cannot be decided, with the reason.
struct Not_covered {
  std::string reason;
};

Q power(const Q& x, int n) {
  Q result(1);
  for (; n > 0; --n) result = Q(result * x);
  return result;
}
Q absolute(const Q& x) { return x < 0 ? Q(-x) : x; }

// p(a + l w) as a polynomial of w.
std::vector<Q> along(std::vector<Q> p, const Q& a, const Q& l) {
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    for (std::size_t j = p.size() - 1; j-- > i;) p[j] = Q(p[j] + a * p[j + 1]);
  Q factor(1);
  for (Q& x : p) {
    x = Q(x * factor);
    factor = Q(factor * l);
  }
  return p;
}

// Adds c cos(pi frequency (a + w direction)), or c times the sine, as a polynomial of w in [0, 1]:
// the series of Taylor around 1/2, with an error below 10^-60 c.
void add_wave(std::vector<Q>& p, const Q& c, bool is_sine, int frequency, const Q& a, int direction) {
  if (c == 0) return;
  constexpr int terms = 74; // pi^terms / terms! < 10^-70
  Q turn = Q(frequency * (a + Q(direction) / 2) - (is_sine ? Q(1) / 2 : Q(0)));
  const double size = CGAL::to_double(turn);
  if (!(-1e15 < size && size < 1e15)) throw Not_covered{"a wave that begins beyond 10^15 of its lengths"};
  turn = Q(turn - 2 * Q(std::floor((size + 1) / 2)));
  const Q angle = shortened(Q(long_pi() * turn)), square = Q(angle * angle);
  Q cosine(1), sine = angle, even(1), odd = angle;
  for (int k = 2; k <= terms; k += 2) {
    even = shortened(Q(-even * square / ((k - 1) * k)));
    odd = shortened(Q(-odd * square / (k * (k + 1))));
    cosine = Q(cosine + even);
    sine = Q(sine + odd);
  }
  const Q derivatives[] = {cosine, Q(-sine), Q(-cosine), sine};
  const Q rate = Q(frequency * direction * long_pi());
  std::vector<Q> wave;
  Q factor = c;
  for (int j = 0; j < terms; ++j) {
    wave.push_back(shortened(Q(factor * derivatives[j % 4])));
    factor = shortened(Q(factor * rate / (j + 1)));
  }
  wave = along(std::move(wave), Q(Q(-1) / 2), Q(1));
  if (p.size() < wave.size()) p.resize(wave.size(), Q(0));
  for (std::size_t j = 0; j < wave.size(); ++j) p[j] = Q(p[j] + wave[j]);
}

// The curvature of a parent curve as a function of its length: a polynomial, and waves over the
// whole length of a segment.
struct Parent_curvature {
  std::vector<Q> polynomial;
  Q cosine = 0, sine = 0; // of pi w and 2 pi w

  bool has_waves() const { return cosine != 0 || sine != 0; }

  // From `start` over `length`, as a polynomial of the part of it, but for waves that begin there.
  std::vector<Q> part(const Q& start, const Q& length) const {
    std::vector<Q> p = along(polynomial, start, length);
    if (!has_waves() || start == 0) return p;
    if (length == 0) throw Not_covered{"a cosine or sine spiral without a length"};
    const Q a = Q(start / absolute(length));
    add_wave(p, cosine, false, 1, a, length < 0 ? -1 : 1);
    add_wave(p, sine, true, 2, a, length < 0 ? -1 : 1);
    return p;
  }
};

struct Segment {
  std::uint64_t id = 0;
  long long line = 0;
  std::string claim; // the Transition
  std::string shape; // the type of its curve
  std::optional<GC::Alignment_end> start, end;
  std::optional<Q> length; // 0 or more, where it is known
  bool rounded = false;    // directions and curvatures have pi or roots in them
  bool rounded_points = false;
  // The heading of the end is measured from the direction of a graph at an arc length.
  struct Place_on_graph {
    GC::Parametric_cubic::Coefficients graph;
    Q length;
  };
  std::optional<Place_on_graph> turned_from;
  std::optional<GC::Road_geometry> bend; // a piece with the same curvatures
  std::string not_covered;
};

// A piece whose curvature goes from one number to another, and only rises or falls.
GC::Road_geometry bend_between(const Q& k0, const Q& k1) {
  GC::Road_geometry g;
  g.shape = k0 == k1 ? (k0 == 0 ? GC::Road_shape::line : GC::Road_shape::arc) : GC::Road_shape::spiral;
  if (k0 != k1)
    g.parameters = {k0, k1};
  else if (k0 != 0)
    g.parameters = {k0};
  return g;
}

// Returns whether a curvature only rises or only falls, by the signs of the coefficients of its
// derivative in Bernstein's form, and by the wave in it.
bool only_rises_or_falls(const GC::Curvature_law& law) {
  const std::size_t n = law.polynomial.empty() ? 0 : law.polynomial.size() - 1;
  if (law.cosine != 0) return n == 0 && law.sine == 0 && law.sine_over_turn == 0;
  const Q wave = Q(2 * long_pi() * law.sine + law.sine_over_turn);
  if (wave != 0) return n == 1 && absolute(wave) <= absolute(law.polynomial[1]);
  bool rises = true, falls = true;
  for (std::size_t i = 0; i < n; ++i) { // b_i = sum of C(i, j) / C(n - 1, j) (j + 1) p_(j + 1)
    Q b(0), ratio(1);
    for (std::size_t j = 0; j <= i; ++j) {
      b = Q(b + ratio * static_cast<int>(j + 1) * law.polynomial[j + 1]);
      if (j < i) ratio = Q(ratio * static_cast<int>(i - j) / static_cast<int>(n - 1 - j));
    }
    rises = rises && !(b < 0);
    falls = falls && !(b > 0);
  }
  return rises || falls;
}

class Ifc_reader {
  const Step_file file_;
  Rail_file result_;
  Q radians_ = 1; // of the unit of angles

  const Entity& at(std::uint64_t id, const Entity& from) const { return file_.entity(id, from.line); }

  static std::string hash(std::uint64_t id) { return "#" + std::to_string(id); }

  std::optional<Q> optional_number(const Step_value& value, const Entity& of) const {
    if (value.kind == Kind::unset) return std::nullopt;
    return file_.number(value, of);
  }

  // ---- points and directions

  std::vector<Q> coordinates(std::uint64_t id, const Entity& from) const {
    const Entity& point = at(id, from);
    std::vector<Q> x = file_.numbers(file_.arguments(point, 1)[0], point);
    if (x.size() < 2) file_.refuse(point, "fewer than two coordinates");
    return x;
  }

  struct Placement {
    Q x, y;
    GC::Heading heading;
  };
  Placement placement(std::uint64_t id, const Entity& from) const {
    const Entity& p = at(id, from);
    const bool in_space = p.type == "IFCAXIS2PLACEMENT3D";
    if (!in_space && p.type != "IFCAXIS2PLACEMENT2D") throw Not_covered{"a placement by " + p.type};
    const std::vector<Step_value> a = file_.arguments(p, in_space ? 3 : 2);
    const std::vector<Q> location = coordinates(file_.reference(a[0], p), p);
    const Step_value& direction = a[in_space ? 2 : 1];
    if (direction.kind == Kind::unset) return {location[0], location[1], GC::Heading()};
    const std::vector<Q> d = coordinates(file_.reference(direction, p), p);
    if (d[0] == 0 && d[1] == 0) throw Not_covered{"a direction of zero"};
    return {location[0], location[1], GC::Heading(Q(0), d[0], d[1])};
  }

  // ---- parent curves

  // A measure of length, or of a parameter that `length_of` makes a length.
  template <class Length_of> Q measure(const Step_value& value, const Entity& of, Length_of length_of) const {
    const Q x = file_.number(value, of);
    return value.kind == Kind::typed && value.text == "IFCPARAMETERVALUE" ? length_of(x) : x;
  }

  // Adds the term sign(A) s^m / |A|^(m + 1) of a spiral with the constant A.
  static void add_term(std::vector<Q>& p, std::size_t m, const std::optional<Q>& a) {
    if (!a) return;
    if (*a == 0) throw Not_covered{"a spiral with a constant of zero"};
    const int n = static_cast<int>(m) + 1;
    Q term = Q(1 / power(absolute(*a), n));
    if (*a < 0) term = Q(-term);
    if (p.size() <= m) p.resize(m + 1, Q(0));
    p[m] = Q(p[m] + term);
  }

  // The curvature of a spiral; nothing for other curves.
  std::optional<Parent_curvature> spiral(const Entity& curve) const {
    std::vector<std::pair<std::size_t, std::size_t>> terms; // of the argument, the power
    if (curve.type == "IFCCLOTHOID") terms = {{1, 1}};
    if (curve.type == "IFCSECONDORDERPOLYNOMIALSPIRAL") terms = {{1, 2}, {2, 1}, {3, 0}};
    if (curve.type == "IFCTHIRDORDERPOLYNOMIALSPIRAL") terms = {{1, 3}, {2, 2}, {3, 1}, {4, 0}};
    if (curve.type == "IFCSEVENTHORDERPOLYNOMIALSPIRAL")
      terms = {{1, 7}, {2, 6}, {3, 5}, {4, 4}, {5, 3}, {6, 2}, {7, 1}, {8, 0}};
    if (curve.type == "IFCCOSINESPIRAL") terms = {{2, 0}};
    if (curve.type == "IFCSINESPIRAL") terms = {{2, 1}, {3, 0}};
    if (terms.empty()) return std::nullopt;
    const std::vector<Step_value> a = file_.arguments(curve, terms.back().first + 1);
    Parent_curvature k;
    for (const auto& [argument, m] : terms) add_term(k.polynomial, m, optional_number(a[argument], curve));
    const bool is_cosine = curve.type == "IFCCOSINESPIRAL";
    if (is_cosine || curve.type == "IFCSINESPIRAL") {
      const Q term = file_.number(a[1], curve);
      if (term == 0) throw Not_covered{"a spiral with a constant of zero"};
      (is_cosine ? k.cosine : k.sine) = Q(1 / term);
    }
    return k;
  }

  // The law of the curvature of a segment from `start` over `length`, in the direction of travel.
  static GC::Curvature_law law(const Parent_curvature& k, const Q& start, const Q& length) {
    const Q sign(length < 0 ? -1 : 1);
    GC::Curvature_law law;
    law.polynomial = k.part(start, length);
    for (Q& p : law.polynomial) p = Q(p * sign);
    if (start == 0) {
      law.cosine = Q(k.cosine * sign);
      law.sine = k.sine; // the sine changes its sign as well
    }
    return law;
  }

  static void set_ends(Segment& s, const GC::Clothoid_segment& c) {
    s.start = c.start();
    s.end = c.end();
    s.length = c.length();
  }

  // A curve in a plane, moved so that it starts at the placement.
  void read_plane(Segment& s, const Placement& p, const Step_value& start, const Step_value& length,
                  const Entity& segment, const Entity& curve) const {
    if (curve.type == "IFCLINE") {
      const std::vector<Step_value> a = file_.arguments(curve, 2);
      const Entity& vector = at(file_.reference(a[1], curve), curve);
      const Q magnitude = file_.number(file_.arguments(vector, 2)[1], vector);
      const Q l = measure(length, segment, [&](const Q& x) { return Q(x * magnitude); });
      s.bend = bend_between(Q(0), Q(0));
      return set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, Q(0), Q(0), absolute(l)));
    }
    if (curve.type == "IFCCIRCLE") {
      const Q radius = file_.number(file_.arguments(curve, 2)[1], curve);
      if (!(radius > 0)) file_.refuse(curve, "a radius that is not positive");
      const Q l = measure(length, segment, [&](const Q& x) { return Q(x * radians_ * radius); });
      const Q k = Q((l < 0 ? -1 : 1) / radius);
      s.bend = bend_between(k, k);
      return set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, k, k, absolute(l)));
    }
    const auto same = [](const Q& x) { return x; }; // files give parameters of spirals as lengths
    if (curve.type == "IFCPOLYNOMIALCURVE") return read_polynomial(s, p, start, length, segment, curve);
    const Q from = measure(start, segment, same), l = measure(length, segment, same);
    const std::optional<Parent_curvature> k = spiral(curve);
    if (!k) throw Not_covered{"a segment of " + curve.type};
    s.rounded = k->has_waves() && from != 0;
    const GC::Curvature_law bent = law(*k, from, l);
    if (l == 0 || only_rises_or_falls(bent)) s.bend = bend_between(bent.at_start(), bent.at_end());
    set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, bent, absolute(l)));
  }

  // A graph over a distance, or of a length.
  static GC::Road_geometry bend_of_graph(const GC::Parametric_cubic::Coefficients& v, const Q& size, bool by_length) {
    GC::Road_geometry g;
    g.length = size;
    g.parameters.assign(v.begin(), v.end());
    g.shape = by_length ? GC::Road_shape::poly3 : GC::Road_shape::param_poly3;
    g.range = GC::Road_parameter_range::arc_length;
    if (!by_length) g.parameters.insert(g.parameters.begin(), {Q(0), Q(1), Q(0), Q(0)});
    return g;
  }

  void read_polynomial(Segment& s, const Placement& p, const Step_value& start, const Step_value& length,
                       const Entity& segment, const Entity& curve) const {
    const std::vector<Step_value> a = file_.arguments(curve, 3);
    const auto coefficients = [&](std::size_t i) {
      return a.size() <= i || a[i].kind == Kind::unset ? std::vector<Q>() : file_.numbers(a[i], curve);
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
    const auto is_parameter = [](const Step_value& v) {
      return v.kind == Kind::typed && v.text == "IFCPARAMETERVALUE";
    };
    const Q from = file_.number(start, segment), l = file_.number(length, segment);
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
      const GC::Parametric_cubic c(p.x, p.y, frame, u, w, absolute(l));
      s.start = c.start();
      s.end = c.end();
      s.length = absolute(l);
      return;
    }
    // backwards it is (-t, w), which turned by a half turn is a graph
    const GC::Parametric_cubic c = l < 0
                                       ? GC::Parametric_cubic::graph(p.x, p.y, p.heading.turned(Q(1), w[1]),
                                                                     {Q(0), Q(-w[1]), Q(-w[2]), Q(-w[3])}, absolute(l))
                                       : GC::Parametric_cubic::graph(p.x, p.y, frame, w, l);
    s.start = c.start();
    s.end = c.end();
    s.length = absolute(l);
  }

  // A part of the graph of a polynomial from one arc length to another: both parameters are
  // enclosed. The frame is that in which the graph has the direction of the placement at its start.
  void read_inner_part(Segment& s, const Placement& p, std::vector<Q> y, const Q& from, const Q& l,
                       bool by_length) const {
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

  // The cant is a graph over the distance along. Where the parent is a spiral its curvature times
  // the length of the segment is the height.
  void read_cant(Segment& s, const Placement& p, const Step_value& start, const Step_value& length,
                 const Entity& segment, const Entity& curve) const {
    const auto same = [](const Q& x) { return x; };
    if (curve.type == "IFCLINE" || curve.type == "IFCCIRCLE" || curve.type == "IFCPOLYNOMIALCURVE")
      return read_plane(s, p, start, length, segment, curve);
    const Q from = measure(start, segment, same), l = measure(length, segment, same);
    if (l == 0) return set_ends(s, GC::Clothoid_segment(p.x, p.y, p.heading, Q(0), Q(0), Q(0)));
    const std::optional<Parent_curvature> k = spiral(curve);
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

  // ---- curves of segments

  Segment read_segment(std::uint64_t id, const Entity& of, bool is_cant) const {
    const Entity& entity = at(id, of);
    Segment s;
    s.id = id;
    s.line = entity.line;
    if (entity.type != "IFCCURVESEGMENT") {
      s.not_covered = "a segment that is " + entity.type + ", not IfcCurveSegment";
      return s;
    }
    const std::vector<Step_value> a = file_.arguments(entity, 5);
    s.claim = std::string(a[0].text);
    try {
      const Placement p = placement(file_.reference(a[1], entity), entity);
      const Entity& curve = at(file_.reference(a[4], entity), entity);
      s.shape = curve.type;
      if (is_cant)
        read_cant(s, p, a[2], a[3], entity, curve);
      else
        read_plane(s, p, a[2], a[3], entity, curve);
    } catch (const Not_covered& what) {
      s.not_covered = what.reason;
    }
    return s;
  }

  void add_piece(const std::string& kind, const std::string& curve, const Segment& s) {
    Rail_piece piece{kind, curve, hash(s.id), s.line, s.shape, s.bend, s.rounded, s.not_covered};
    if (!s.bend && s.not_covered.empty()) piece.not_covered = "a curvature that does not only rise or only fall";
    result_.pieces.push_back(std::move(piece));
  }

  static void set_rounded(Rail_check& check, const Segment& before, const Segment& next) {
    check.rounded = check.rounded_curvature = before.rounded || next.rounded;
    check.rounded_points = before.rounded_points || next.rounded_points;
  }

  static int order_of(const std::string& claim) {
    if (claim == "CONTINUOUS") return 0;
    if (claim == "CONTSAMEGRADIENT") return 1;
    return claim == "CONTSAMEGRADIENTSAMECURVATURE" ? 2 : -1;
  }

  void read_curve(std::uint64_t id, const Entity& curve) {
    const std::vector<Step_value> a = file_.arguments(curve, 2);
    const bool is_cant = curve.type == "IFCSEGMENTEDREFERENCECURVE";
    const std::string kind = is_cant ? "cant" : curve.type == "IFCGRADIENTCURVE" ? "vertical" : "horizontal";
    const std::vector<std::uint64_t> ids = file_.references(a[0], curve);
    bool has_segments = kind != "horizontal"; // other composite curves are no alignments
    for (const std::uint64_t segment : ids) has_segments = has_segments || at(segment, curve).type == "IFCCURVESEGMENT";
    if (!has_segments) {
      ++plain_curves_;
      return;
    }
    ++result_.curves;
    std::optional<Segment> before;
    for (const std::uint64_t segment_id : ids) {
      Segment next = read_segment(segment_id, curve, is_cant);
      if (kind == "horizontal") add_piece(kind, curve.type + " " + hash(id), next);
      if (before) {
        Rail_check check;
        check.kind = kind;
        check.curve = curve.type + " " + hash(id);
        check.place = hash(before->id) + " - " + hash(next.id);
        check.line = before->line;
        check.claim = before->claim;
        check.claimed = order_of(before->claim);
        check.length = before->length;
        if (!before->not_covered.empty() || !next.not_covered.empty())
          check.not_covered = !before->not_covered.empty() ? before->not_covered : next.not_covered;
        else {
          check.ends = {*before->end, *next.start};
          if (const auto& place = before->turned_from) // so that both are
            check.ends->right.heading =
                GC::Parametric_cubic::graph(Q(0), Q(0), next.start->heading, place->graph, place->length).end().heading;
        }
        set_rounded(check, *before, next);
        result_.checks.push_back(std::move(check));
      }
      before = std::move(next);
    }
  }
  std::size_t plain_curves_ = 0;

  // ---- the design

  // The segments of a layer, in the order of their nesting.
  typedef std::map<std::uint64_t, std::vector<std::uint64_t>> Nesting;
  Nesting nesting() const {
    Nesting result;
    for (const std::uint64_t id : file_.ids()) {
      const Entity& e = file_.entity(id);
      if (e.type != "IFCRELNESTS") continue;
      const std::vector<Step_value> a = file_.arguments(e, 6);
      std::vector<std::uint64_t>& parts = result[file_.reference(a[4], e)];
      for (const std::uint64_t part : file_.references(a[5], e)) parts.push_back(part);
    }
    return result;
  }

  // A vertical arc by its horizontal length: between the angles a and b the radius is
  // length / (sin b - sin a), and the chord rises by tan((a + b) / 2).
  static void set_arc_of_length(Segment& s, const Q& x, const Q& height, const Q& g0, const Q& g1, const Q& length) {
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

  Neighbour neighbour(const Entity* e) const {
    if (e == nullptr || e->type != "IFCALIGNMENTVERTICALSEGMENT") return Neighbour::none;
    const std::vector<Step_value> a = file_.arguments(*e, 9);
    if (optional_number(a[3], *e).value_or(Q(0)) == 0) return Neighbour::none;
    const std::string_view type = a[8].text;
    if (type == "CONSTANTGRADIENT") return Neighbour::gradient;
    return type == "PARABOLICARC" || type == "CIRCULARARC" || type == "CLOTHOID" ? Neighbour::curve : Neighbour::none;
  }

  // IFC does not say at which end a vertical clothoid is straight. A transition leads from a
  // gradient into a curve, or from a curve to a gradient.
  bool is_straight_at_start(const Entity* before, const Entity* after) const {
    const Neighbour left = neighbour(before), right = neighbour(after);
    if (left == right)
      throw Not_covered{"a vertical clothoid " +
                        std::string(left == Neighbour::gradient ? "between two gradients"
                                    : left == Neighbour::curve  ? "between two curves"
                                                                : "without neighbours") +
                        ", so that nothing tells at which end it is straight"};
    return left == Neighbour::gradient || right == Neighbour::curve;
  }

  static void set_clothoid(Segment& s, const Q& x, const Q& height, const Q& g0, const Q& g1, const Q& length,
                           const Q& radius, bool is_straight_at_start) {
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

  // A segment of the horizontal or the vertical layer, between two others, which may be missing.
  void read_design(Segment& s, const Entity& e, const std::string& layer, const Entity* before,
                   const Entity* after) const {
    const bool horizontal = layer == "design horizontal";
    const std::vector<Step_value> a = file_.arguments(e, 9);
    const auto number = [&](std::size_t i) { return optional_number(a[i], e).value_or(Q(0)); };
    const auto curvature = [](const Q& radius) { return radius == 0 ? Q(0) : Q(1 / radius); };
    if (horizontal) {
      const std::vector<Q> p = coordinates(file_.reference(a[2], e), e);
      const GC::Heading heading(Q(number(3) * radians_));
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
        s.start = c.start();
        s.end = c.end();
        s.length = length;
        return;
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
        const GC::Clothoid_segment second(Q(0), Q(0), first.end_heading(),
                                          Law::between(middle, k1, {{Q(0), Q(2), Q(-1)}}), half);
        s.start = first.start();
        s.end = second.end();
        s.end->point = first.end_point() + second.end_point();
        s.length = length;
        return;
      }
      if (!law) throw Not_covered{"a segment of the type " + std::string(type)};
      return set_ends(s, GC::Clothoid_segment(p[0], p[1], heading, Law::between(k0, k1, *law), length));
    }
    // the vertical layer: height over distance
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
      return set_clothoid(s, x, height, g0, g1, length, number(7), is_straight_at_start(before, after));
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
    s.start = c.start();
    s.end = c.end();
    s.length = length;
  }

  // The cant: both rails over the distance, which differ by less than a length.
  void add_cant(const Entity& e, const Entity& next, std::uint64_t id, std::uint64_t next_id,
                const std::string& curve) {
    const std::vector<Step_value> a = file_.arguments(e, 9), b = file_.arguments(next, 9);
    const auto number = [&](const std::vector<Step_value>& values, std::size_t i, const Entity& of) {
      return optional_number(values[i], of);
    };
    const auto end_or_start = [&](std::size_t i) { // of the first segment: the start where there is no end
      const std::optional<Q> end = number(a, i, e);
      return end ? *end : number(a, i - 1, e).value_or(Q(0));
    };
    const Q distance = Q(number(a, 2, e).value_or(Q(0)) + number(a, 3, e).value_or(Q(0)));
    for (const auto& [quantity, value] :
         {std::pair("distance", Q(number(b, 2, next).value_or(Q(0)) - distance)),
          std::pair("left cant", Q(number(b, 4, next).value_or(Q(0)) - end_or_start(5))),
          std::pair("right cant", Q(number(b, 6, next).value_or(Q(0)) - end_or_start(7)))}) {
      Rail_check check;
      check.kind = "design cant";
      check.curve = curve;
      check.place = hash(id) + " - " + hash(next_id) + ", " + quantity;
      check.line = e.line;
      check.claimed = 0;
      check.difference = {quantity, value, false, std::nullopt};
      result_.checks.push_back(std::move(check));
    }
  }

  void read_layer(std::uint64_t id, const Entity& layer, const Nesting& nesting) {
    const auto nested = nesting.find(id);
    if (nested == nesting.end()) return;
    const std::string kind = layer.type == "IFCALIGNMENTHORIZONTAL" ? "design horizontal"
                             : layer.type == "IFCALIGNMENTVERTICAL" ? "design vertical"
                                                                    : "design cant";
    const std::string curve = layer.type + " " + hash(id);
    ++result_.curves;
    std::vector<std::pair<std::uint64_t, const Entity*>> designs;
    for (const std::uint64_t part : nested->second) {
      const Entity& segment = at(part, layer);
      if (segment.type != "IFCALIGNMENTSEGMENT") continue;
      const std::vector<Step_value> a = file_.arguments(segment, 8);
      if (a[7].kind == Kind::reference) designs.emplace_back(a[7].reference, &at(a[7].reference, segment));
    }
    std::optional<Segment> before;
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const Entity *const entity_before = i > 0 ? designs[i - 1].second : nullptr, *const entity_after =
                                                                                       i + 1 < designs.size()
                                                                                           ? designs[i + 1].second
                                                                                           : nullptr;
      const Entity& design = *designs[i].second;
      Segment next;
      next.id = designs[i].first;
      next.line = design.line;
      if (design.type != layer.type + "SEGMENT")
        next.not_covered = "a segment that is " + design.type;
      else if (kind != "design cant")
        try {
          read_design(next, design, kind, entity_before, entity_after);
        } catch (const Not_covered& what) {
          next.not_covered = what.reason;
        }
      if (kind == "design horizontal") add_piece(kind, curve, next);
      if (before && kind == "design cant" && next.not_covered.empty() && before->not_covered.empty())
        add_cant(*entity_before, design, before->id, next.id, curve);
      else if (before) {
        Rail_check check;
        check.kind = kind;
        check.curve = curve;
        check.place = hash(before->id) + " - " + hash(next.id);
        check.line = before->line;
        check.claimed = 0;
        check.length = before->length;
        set_rounded(check, *before, next);
        if (before->end && next.start)
          check.ends = {*before->end, *next.start};
        else
          check.not_covered = before->not_covered.empty() ? next.not_covered : before->not_covered;
        result_.checks.push_back(std::move(check));
      }
      before = std::move(next);
    }
  }

  // ---- units

  void read_units() {
    const std::set<std::uint64_t> assigned = assigned_units();
    for (const std::uint64_t id : file_.ids()) {
      const Entity& e = file_.entity(id);
      if (e.type == "IFCGEOMETRICREPRESENTATIONCONTEXT") {
        const std::vector<Step_value> a = file_.arguments(e, 4);
        const std::optional<Q> precision = optional_number(a[3], e);
        if (precision && *precision > 0 && (!result_.precision || *result_.precision < *precision))
          result_.precision = precision;
      }
      if (e.type == "IFCCONVERSIONBASEDUNIT") {
        const std::vector<Step_value> a = file_.arguments(e, 4);
        if (a[1].kind != Kind::word || a[1].text != "PLANEANGLEUNIT") continue;
        if (assigned.count(id) == 0) continue;
        const Entity& factor = at(file_.reference(a[3], e), e);
        radians_ = file_.number(file_.arguments(factor, 2)[0], factor);
      }
    }
  }
  std::set<std::uint64_t> assigned_units() const {
    std::set<std::uint64_t> units;
    for (const std::uint64_t id : file_.ids()) {
      const Entity& e = file_.entity(id);
      if (e.type != "IFCUNITASSIGNMENT") continue;
      for (const std::uint64_t x : file_.references(file_.arguments(e, 1)[0], e)) units.insert(x);
    }
    return units;
  }

public:
  Ifc_reader(std::istream& stream, const std::string& name) : file_(stream, name) {
    if (file_.schema().substr(0, 3) != "IFC")
      throw GC::Error(GC::Error_code::malformed_input, name + ": the schema '" + file_.schema() + "' is none of IFC");
    read_units();
    const Nesting nests = nesting();
    for (const std::uint64_t id : file_.ids()) {
      const Entity& e = file_.entity(id);
      if (e.type == "IFCCOMPOSITECURVE" || e.type == "IFCGRADIENTCURVE" || e.type == "IFCSEGMENTEDREFERENCECURVE")
        read_curve(id, e);
      if (e.type == "IFCALIGNMENTHORIZONTAL" || e.type == "IFCALIGNMENTVERTICAL" || e.type == "IFCALIGNMENTCANT")
        read_layer(id, e, nests);
    }
    if (plain_curves_ > 0)
      result_.notes.push_back(std::to_string(plain_curves_) +
                              " composite curves without IfcCurveSegment are no alignments");
  }
  Rail_file result() && { return std::move(result_); }
};

} // namespace

Rail_file read_ifc(std::istream& stream, const std::string& name) { return Ifc_reader(stream, name).result(); }

Rail_file read_ifc(const std::string& file) {
  Input stream(file);
  return read_ifc(stream, input_name(file));
}

bool is_ifc_file(const std::string& file) {
  if (!is_standard_input(file)) {
    const std::string ending = extension(file);
    if (ending == ".ifc") return true;
    if (!ending.empty()) return false;
  }
  return beginning_of_text(file).find("ISO-10303-21") != std::string::npos &&
         begins_as_ifc(Input(file).beginning(8192)); // behind the names of authors and programs
}
