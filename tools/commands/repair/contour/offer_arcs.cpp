// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/offer_arcs.h"

#include "commands/repair/contour/Movable_contour.h"
#include "commands/repair/contour/mend_kinks.h"
#include "commands/repair/decimal_text.h"
#include "commands/repair/grid_vectors.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace {

constexpr double quarter = 1.5707963267948966;

// Lengths and angles of an ellipse, rounded, in a frame in which it is a circle.
struct Arc_frame {
  double radius;
  std::complex<double> turn;
  double stretch; // of the second axis
  bool large;

  explicit Arc_frame(const GC::Elliptical_arc_parameters<Grid_fraction>& p)
      : radius(std::abs(CGAL::to_double(p.rx))), turn(std::polar(1., CGAL::to_double(p.rotation) * quarter / 90)),
        stretch(radius / std::abs(CGAL::to_double(p.ry))), large(p.large) {}

  std::complex<double> from(const std::complex<double>& v) const {
    const std::complex<double> w = v / turn;
    return {w.real(), w.imag() * stretch};
  }
  std::complex<double> from(const Grid_offset& v) const {
    return from(std::complex<double>(CGAL::to_double(v.x()), CGAL::to_double(v.y())));
  }
  std::complex<double> to(const std::complex<double>& v) const {
    return turn * std::complex<double>(v.real(), v.imag() / stretch);
  }
  // Between the chord and the tangents at its ends.
  double chord_angle(const std::complex<double>& chord) const {
    const double angle = std::asin((std::min)(1., std::abs(chord) / (2 * radius)));
    return large ? 2 * quarter - angle : angle;
  }
};

// The first convergent of a continued fraction that is as near to a positive number as rounding
// can tell; what it stands for is proved later.
std::optional<Grid_fraction> short_fraction(double x) {
  constexpr double nearness = 1e-12, largest = 1e6;
  if (!(x > 0 && x < 1e12)) return std::nullopt;
  double p0 = 1, q0 = 0, p1 = std::floor(x), q1 = 1, rest = x - p1;
  while (std::abs(p1 / q1 - x) > nearness * x) {
    if (!(rest > 0)) return std::nullopt;
    const double a = std::floor(1 / rest);
    rest = 1 / rest - a;
    const double p = a * p1 + p0, q = a * q1 + q0;
    if (!(q <= largest)) return std::nullopt;
    p0 = std::exchange(p1, p);
    q0 = std::exchange(q1, q);
  }
  return Grid_fraction(Grid_fraction(p1) / Grid_fraction(q1));
}

// Returns whether a number is a decimal in coordinates.
bool is_decimal(const Movable_contour& contour, const Grid_fraction& x, int most_decimals = 6) {
  return decimal_text(Grid_fraction(x * power_of_ten(-contour.now().decimals)), most_decimals).has_value();
}

// Makes the arc of a curve anew, as it is written.
void set_ends(Grid_curve& curve, const Drawing_traits::Point& start, const Drawing_traits::Point& end) {
  curve.arc.reset();
  try {
    if (start != end)
      curve.arc = std::make_shared<const Exact_segment>(
          Exact_segment{GC::Elliptical_arc<Drawing_traits>(start, end, *curve.written)});
  } catch (const GC::Error&) { // sizes that differ too much
  }
}

// The direction in which a curve ends or starts, rounded; nothing for ellipses whose rotation is
// irrational.
std::optional<std::complex<double>> rounded_direction(const Movable_contour& contour, std::size_t curve, bool at_end) {
  const Grid_curve& c = contour.curve(curve);
  if (!c.arc) {
    const Grid_offset v = contour.exact_direction(curve, at_end);
    return std::complex<double>(CGAL::to_double(v.x()), CGAL::to_double(v.y()));
  }
  if (!c.written) return std::nullopt;
  const Arc_frame frame(*c.written);
  const std::complex<double> chord = frame.from(c.arc->end() - c.arc->start());
  const double angle = frame.chord_angle(chord) * (c.written->sweep == at_end ? 1 : -1);
  return frame.to(chord * std::polar(1., angle));
}

// Returns whether a kink of an arc did not grow; known only where it has not changed.
bool is_no_larger(const Join_state& before, const Join_state& after) {
  return before.angle && after.angle && after.angle->upper <= before.angle->lower;
}

// Returns whether a join is smooth, and no other harmed, with another arc.
bool is_smooth_with(Movable_contour& contour, std::size_t join, std::size_t curve, const Grid_curve& arc) {
  if (!arc.arc) return false;
  std::set<std::size_t> joins = contour.joins_of(curve);
  joins.erase(join);
  const std::vector<Join_state> before = contour.states(joins);
  const Grid_curve given = contour.replace(curve, arc);
  bool smooth = contour.grade(join) >= GC::Visual_class::g1;
  for (const Join_state& x : before) {
    const Join_state after = contour.state(x.join);
    smooth = smooth && x.grade && !contour.is_harmed(x, after, {}) &&
             (x.grade != GC::Visual_class::kink || after.grade != GC::Visual_class::kink || is_no_larger(x, after));
  }
  contour.replace(curve, given);
  return smooth;
}

// An arc at a kink, run through from the node on, and the direction of its neighbour there.
struct Arc_at_kink {
  std::size_t join, curve;
  bool of_right;
  Grid_curve given;
  Drawing_traits::Point node, far;
  Arc_frame frame;
  std::complex<double> tangent, chord; // in the frame
  bool sweep;
  double angle; // from the tangent to the chord
};

// Returns the arc of one side of a kink; nothing where there is none that could be smooth.
std::optional<Arc_at_kink> arc_at_kink(const Movable_contour& contour, std::size_t join, bool of_right) {
  const std::size_t curve = of_right ? contour.next(join) : join, other = of_right ? join : contour.next(join);
  const Grid_curve& given = contour.curve(curve);
  if (!given.arc || !given.written || curve == other) return std::nullopt;
  const std::optional<std::complex<double>> direction = rounded_direction(contour, other, of_right);
  if (!direction || *direction == 0.) return std::nullopt;
  const Drawing_traits::Point node = of_right ? given.arc->start() : given.arc->end(),
                              far = of_right ? given.arc->end() : given.arc->start();
  const Arc_frame frame(*given.written);
  const std::complex<double> tangent = frame.from(of_right ? *direction : -*direction), chord = frame.from(far - node);
  const bool sweep = given.written->sweep == of_right;
  const double angle = std::arg(chord / tangent) * (sweep ? 1 : -1);
  if (!(angle > 0)) return std::nullopt;
  return Arc_at_kink{join, curve, of_right, given, node, far, frame, tangent, chord, sweep, angle};
}

// Adds an offer where it makes the join smooth and does not harm the one at its other end. Returns
// whether it does.
bool add_offer(Movable_contour& contour, std::size_t join, Arc_offer offer, std::vector<Arc_offer>& offers) {
  if (!is_smooth_with(contour, join, offer.curve, offer.changed)) return false;
  for (const Arc_offer& x : offers)
    if (x.curve == offer.curve && x.numbers == offer.numbers) return true;
  offers.push_back(std::move(offer));
  return true;
}

// Adds the radii of the same ratio with which an arc is smooth.
void offer_radii(Movable_contour& contour, const Arc_at_kink& arc, std::vector<Arc_offer>& offers) {
  const int decimals = contour.now().decimals;
  const double radius = std::abs(arc.chord) / (2 * std::sin(arc.angle)),
               unit = CGAL::to_double(power_of_ten(-decimals));
  const std::optional<Grid_fraction> in_coordinates = short_fraction(radius * unit);
  if (!in_coordinates) return;
  Arc_offer o;
  o.curve = arc.curve;
  o.changed = arc.given;
  GC::Elliptical_arc_parameters<Grid_fraction>& p = *o.changed.written;
  const Grid_fraction rx = *in_coordinates * power_of_ten(decimals);
  p.ry = Grid_fraction(p.ry * rx / p.rx);
  p.rx = rx;
  o.numbers = {contour.now().text(p.rx), contour.now().text(p.ry)};
  o.is_decimal = is_decimal(contour, p.rx) && is_decimal(contour, p.ry);
  o.size = std::abs(radius / arc.frame.radius - 1);
  set_ends(o.changed, arc.given.arc->start(), arc.given.arc->end());
  add_offer(contour, arc.join, std::move(o), offers);
}

// Adds another end of an arc. Returns whether it is smooth with that.
bool offer_end(Movable_contour& contour, const Arc_at_kink& arc, const Drawing_traits::Point& to,
               std::vector<Arc_offer>& offers) {
  const Grid_contour& now = contour.now();
  const auto are_decimal = [&](int most_decimals) {
    return is_decimal(contour, to.x(), most_decimals) && is_decimal(contour, to.y(), most_decimals);
  };
  Arc_offer o;
  o.curve = arc.curve;
  o.changed = arc.given;
  o.is_on_grid = are_decimal(now.decimals);
  o.moves_start = !arc.of_right;
  o.moves_end = arc.of_right;
  o.numbers = {now.text(to.x()), now.text(to.y())};
  o.is_decimal = are_decimal(now.most_decimals);
  o.size = std::sqrt(CGAL::to_double((to - arc.far).squared_length()));
  set_ends(o.changed, arc.of_right ? arc.node : to, arc.of_right ? to : arc.node);
  return add_offer(contour, arc.join, std::move(o), offers);
}

// Adds the ends with which an arc is smooth, where its end is free: that on its chord, and the
// nearest point of the grid on the ellipse.
void offer_ends(Movable_contour& contour, const Arc_at_kink& arc, std::vector<Arc_offer>& offers) {
  const Grid_contour& now = contour.now();
  const bool is_free =
      arc.of_right ? now.has_free_end && arc.curve + 1 == now.curves.size() : now.has_free_start && arc.curve == 0;
  if (!is_free) return;
  const double radius = arc.frame.radius;
  if (const std::optional<Grid_fraction> t = short_fraction(2 * radius * std::sin(arc.angle) / std::abs(arc.chord)))
    offer_end(contour, arc, arc.node + *t * (arc.far - arc.node), offers);
  const std::complex<double> centre =
      arc.tangent / std::abs(arc.tangent) * std::polar(radius, arc.sweep ? quarter : -quarter);
  const std::optional<std::int64_t> x = on_grid(arc.far.x()), y = on_grid(arc.far.y());
  const int widest = static_cast<int>((std::min)(100., (std::max)(3., 0.1 * radius)));
  std::vector<GC::Grid_vector> near;
  for (int i = -widest; i <= widest && x && y; ++i)
    for (int j = -widest; j <= widest; ++j) {
      const Grid_offset v = Drawing_traits::Point(exact_number(*x + i), exact_number(*y + j)) - arc.node;
      const double off = std::abs(arc.frame.from(v) - centre) / radius - 1;
      if (std::abs(off) < 1e-9) near.push_back({i, j});
    }
  std::stable_sort(near.begin(), near.end(), [](const GC::Grid_vector& u, const GC::Grid_vector& v) {
    return squared_length(u) < squared_length(v);
  });
  for (const GC::Grid_vector& v : near)
    if (offer_end(contour, arc, Drawing_traits::Point(exact_number(*x + v.x), exact_number(*y + v.y)), offers)) break;
}

// Returns how an arc at a kink would be smooth with its neighbour: with other radii of the same
// ratio, or with another end where that is free. All are proved; first those of radii.
std::vector<Arc_offer> arc_offers(Movable_contour& contour, std::size_t join) {
  std::vector<Arc_offer> offers;
  for (const bool of_right : {true, false})
    if (const std::optional<Arc_at_kink> arc = arc_at_kink(contour, join, of_right)) {
      offer_radii(contour, *arc, offers);
      offer_ends(contour, *arc, offers);
    }
  std::stable_sort(offers.begin(), offers.end(), [](const Arc_offer& x, const Arc_offer& y) {
    const auto rank = [](const Arc_offer& o) {
      return std::tuple(!o.is_decimal, o.moves_start || o.moves_end, !o.is_on_grid, o.size);
    };
    return rank(x) < rank(y);
  });
  return offers;
}

// Adds what has changed of an arc.
void add_changes(const Grid_contour& contour, std::size_t i, const Grid_curve& given,
                 std::vector<Arc_change>& changes) {
  const Grid_curve& curve = contour.curves[i];
  if (!curve.arc || curve.arc == given.arc) return;
  const auto radii = [&](const Grid_curve& c) {
    std::vector<std::string> r{contour.text(c.written->rx), contour.text(c.written->ry)};
    if (r[0] == r[1]) r.pop_back();
    return r;
  };
  const auto point = [&](const Drawing_traits::Point& p) {
    return std::vector<std::string>{contour.text(p.x()), contour.text(p.y())};
  };
  if (radii(given) != radii(curve)) changes.push_back({i, "radius", radii(given), radii(curve)});
  if (given.arc->start() != curve.arc->start())
    changes.push_back({i, "start", point(given.arc->start()), point(curve.arc->start())});
  if (given.arc->end() != curve.arc->end())
    changes.push_back({i, "end", point(given.arc->end()), point(curve.arc->end())});
}

} // namespace

void offer_arcs(Grid_contour& given, const Repair_options& options, Contour_repair& result) {
  Movable_contour contour(given, options);
  bool changed = false;
  for (Unrepaired_join& x : result.unrepaired) {
    if (contour.grade(x.join) != GC::Visual_class::kink) continue;
    x.offers = arc_offers(contour, x.join);
    if (!options.change_arcs || x.offers.empty() || !x.offers.front().is_decimal) continue;
    contour.replace(x.offers.front().curve, x.offers.front().changed);
    changed = true;
  }
  if (!changed) return;
  result = mend_kinks(given, options);
  for (Unrepaired_join& x : result.unrepaired) x.offers = arc_offers(contour, x.join);
}

std::vector<Arc_change> arc_changes(const Grid_contour& given, const Grid_contour& contour) {
  std::vector<Arc_change> changes;
  for (std::size_t i = 0; i < contour.curves.size(); ++i) add_changes(contour, i, given.curves[i], changes);
  return changes;
}
