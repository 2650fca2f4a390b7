// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Repair of contours: what stays, how far handles move, mirror images, and that repairing again
// changes nothing.

#define BOOST_TEST_MODULE repair_contour
#include "support/test.h"

#include "commands/repair/chain_direction.h"
#include "commands/repair/repair_contour.h"

typedef GC::Grid_vector Vector;
typedef std::vector<Vector> Points;

namespace {

const GC::Corner_threshold bound;

Grid_contour contour(const std::vector<Points>& curves, bool closed) {
  Grid_contour c;
  c.closed = closed;
  for (const Points& p : curves) c.curves.push_back({p, "", false, nullptr});
  return c;
}

// A contour with lines, quadratics and cubics about a circle, whose handles are off by some units.
Grid_contour random_contour(std::mt19937& random, double radius) {
  const int n = 3 + static_cast<int>(random() % 6);
  const double turn = 2 * std::acos(-1.) / n;
  const auto noise = [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); };
  const auto at = [&](double r, double angle) -> Vector {
    return {std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))};
  };
  std::vector<Vector> nodes;
  for (int i = 0; i < n; ++i) nodes.push_back(at(radius + 3 * noise(), i * turn));
  std::vector<Points> curves;
  for (int i = 0; i < n; ++i) {
    const Vector p = nodes[static_cast<std::size_t>(i)], q = nodes[static_cast<std::size_t>((i + 1) % n)];
    const double length = radius * (0.3 + 0.01 * (random() % 20));
    const auto handle = [&](const Vector& node, double angle) -> Vector {
      const Vector v = at(length, angle);
      return {node.x + v.x + std::llround(noise()), node.y + v.y + std::llround(noise())};
    };
    const double quarter = std::acos(-1.) / 2;
    switch (random() % 4) {
    case 0: curves.push_back({p, q}); break;
    case 1: curves.push_back({p, at(radius / std::cos(turn / 2), (i + .5) * turn), q}); break;
    default: curves.push_back({p, handle(p, i * turn + quarter), handle(q, (i + 1) * turn - quarter), q});
    }
  }
  return contour(curves, true);
}

// The image under a symmetry of the square, run through in reverse.
Grid_contour mirrored(const Grid_contour& c, int symmetry) {
  Grid_contour image = c;
  std::reverse(image.curves.begin(), image.curves.end());
  for (Grid_curve& curve : image.curves) {
    std::reverse(curve.points.begin(), curve.points.end());
    for (Vector& v : curve.points) {
      if (symmetry & 1) v.x = -v.x;
      if (symmetry & 2) v.y = -v.y;
      if (symmetry & 4) std::swap(v.x, v.y);
    }
  }
  return image;
}

bool same(const Grid_contour& x, const Grid_contour& y) {
  return std::equal(x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
                    [](const Grid_curve& c, const Grid_curve& d) { return c.points == d.points; });
}

// Three in a row, whose handles may depend on each other.
bool has_chain_of_quadratics(const Grid_contour& c) {
  const auto is_quadratic = [&](std::size_t i) { return c.curves[i % c.curves.size()].points.size() == 3; };
  for (std::size_t i = 0; i < c.curves.size(); ++i)
    if (is_quadratic(i) && is_quadratic(i + 1) && is_quadratic(i + 2)) return true;
  return false;
}

double squared(const Vector& v) { return static_cast<double>(v.x * v.x + v.y * v.y); }

} // namespace

BOOST_AUTO_TEST_CASE(nothing_is_harmed) {
  std::mt19937 random = seeded(27);
  std::size_t mended = 0, kinks = 0;
  for (int i = 0; i < 400; ++i) {
    const Grid_contour given = random_contour(random, i % 2 == 0 ? 60 : 700);
    for (const bool harmonise : {false, true}) {
      Repair_options options{bound, std::nullopt, harmonise};
      Grid_contour repaired = given;
      const Contour_repair done = repair(repaired, options);
      std::vector<std::size_t> lost;
      std::size_t left = 0;
      for (std::size_t j = 0; j < given.number_of_joins(); ++j) {
        const auto before = *grade(given, j, bound), after = *grade(repaired, j, bound);
        BOOST_CHECK(after >= (std::min)(before, GC::Visual_class::g1));
        BOOST_CHECK((before == GC::Visual_class::corner) == (after == GC::Visual_class::corner));
        kinks += before == GC::Visual_class::kink;
        mended += before == GC::Visual_class::kink && after >= GC::Visual_class::g1;
        if (before == GC::Visual_class::g2 && after == GC::Visual_class::g1) lost.push_back(j);
        left += after == GC::Visual_class::kink;
        if (after == GC::Visual_class::kink)
          BOOST_CHECK(std::any_of(done.unrepaired.begin(), done.unrepaired.end(),
                                  [&](const Unrepaired_join& u) { return u.join == j && !u.reason.empty(); }));
      }
      BOOST_CHECK(lost == done.lost);
      BOOST_CHECK(left == done.unrepaired.size());
      Grid_contour again = repaired;
      BOOST_CHECK(repair(again, options).moves.empty());
      BOOST_CHECK(same(again, repaired));
      if (harmonise) continue;
      // twice what one of the kinks next to it was off, and one unit
      for (const Handle_move& m : done.moves) {
        const std::size_t n = given.curves.size(), left = (m.curve + n - 1) % n;
        double off = 0;
        for (const std::size_t j : {left, m.curve})
          if (grade(given, j, bound) == GC::Visual_class::kink)
            off = (std::max)(
                off, segment_kink(grid_bezier(given.curves[j].points), grid_bezier(given.curves[given.next(j)].points))
                         ->handle_offset.upper);
        BOOST_CHECK(m.distance().lower <= 2 * off + 1);
      }
    }
  }
  std::cout << mended << " of " << kinks << " kinks mended\n";
  BOOST_CHECK(mended > kinks / 4);
}

BOOST_AUTO_TEST_CASE(mirror_images) {
  std::mt19937 random = seeded(28);
  int contours = 0;
  for (int i = 0; i < 300; ++i) {
    const Grid_contour given = random_contour(random, i % 2 == 0 ? 60 : 700);
    if (has_chain_of_quadratics(given)) continue;
    const int symmetry = 1 + static_cast<int>(random() % 7);
    Grid_contour repaired = given, image = mirrored(given, symmetry);
    ++contours;
    repair(repaired, {bound, std::nullopt, false});
    repair(image, {bound, std::nullopt, false});
    BOOST_CHECK(same(image, mirrored(repaired, symmetry)));
  }
  BOOST_CHECK(contours > 100);
}

// The moves of two cubics are compared with all positions of both handles.
BOOST_AUTO_TEST_CASE(least_change) {
  std::mt19937 random = seeded(29);
  int mended = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector a{8 + static_cast<int>(random() % 14), static_cast<int>(random() % 9) - 4},
        b{a.x + static_cast<int>(random() % 9) - 4, a.y + static_cast<int>(random() % 3) - 1};
    const Grid_contour given =
        contour({{{-60, 30}, {-50, 20}, -1 * a, {0, 0}}, {{0, 0}, b, {50, 20}, {60, -30}}}, false);
    if (grade(given, 0, bound) != GC::Visual_class::kink) continue;
    if (a.y == -b.y && a.x == b.x) continue; // mirror images stay so
    const double off = segment_kink(grid_bezier(given.curves[0].points), grid_bezier(given.curves[1].points))
                           ->handle_offset.lower,
                 most = 2 * off + 1;
    double least = 1e300;
    const int r = static_cast<int>(most) + 1;
    for (int x = -r; x <= r; ++x)
      for (int y = -r; y <= r; ++y)
        for (int u = -r; u <= r; ++u)
          for (int v = -r; v <= r; ++v) {
            const Vector p{a.x + x, a.y + y}, q{b.x + u, b.y + v}, left{x, y}, right{u, v};
            const double larger = (std::max)(squared(left), squared(right));
            if (larger <= most * most && p.x * q.y == p.y * q.x && p.x * q.x + p.y * q.y > 0)
              least = (std::min)(least, larger);
          }
    Grid_contour repaired = given;
    const Contour_repair done = repair(repaired, {bound, std::nullopt, false});
    double larger = 0;
    for (const Handle_move& m : done.moves) larger = (std::max)(larger, squared(m.to - m.from));
    BOOST_CHECK_EQUAL(done.unrepaired.empty(), least < 1e300);
    if (done.unrepaired.empty()) BOOST_CHECK_EQUAL(larger, least);
    mended += done.unrepaired.empty();
  }
  BOOST_CHECK(mended > 100);
}

BOOST_AUTO_TEST_CASE(symmetric_handles_stay_so) {
  Grid_contour c = contour({{{-60, 0}, {-60, 20}, {-21, 50}, {0, 52}}, {{0, 52}, {21, 50}, {60, 20}, {60, 0}}}, false);
  const Contour_repair done = repair(c, {GC::Corner_threshold(12), std::nullopt, false});
  BOOST_CHECK(done.unrepaired.empty());
  BOOST_CHECK(c.curves[0].points[2] == (Vector{-21, 52}) && c.curves[1].points[1] == (Vector{21, 52}));
}

// The other end of a quadratic: as its leg gets longer, its handle would be off by more, though the
// angle would be smaller.
BOOST_AUTO_TEST_CASE(kinks_that_are_left_do_not_grow) {
  const Grid_contour given =
      contour({{{-500, 0}, {0, 0}}, {{0, 0}, {100, 7}, {200, 103}}, {{200, 103}, {10200, 10050}}}, false);
  Grid_contour repaired = given;
  const Contour_repair done = repair(repaired, {bound, std::nullopt, false});
  BOOST_CHECK(same(repaired, given));
  BOOST_TEST(done.unrepaired.size() == 2u);
  BOOST_TEST(done.unrepaired[0].reason == "another join would be harmed");
}

// The handle behind the first node gets shorter, and then leads to the second one, whose own handle
// lies at it, in the right direction.
BOOST_AUTO_TEST_CASE(kinks_that_harmonising_mends_are_not_left) {
  Grid_contour c = contour({{{146, 301}, {146, 199}, {169, 29}, {231, 29}},
                            {{231, 29}, {290, 29}, {288, 168}, {288, 168}},
                            {{288, 168}, {288, 188}, {301, 189}, {310, 189}}},
                           false);
  BOOST_CHECK(grade(c, 1, bound) == GC::Visual_class::kink);
  const Contour_repair done = repair(c, {bound, std::nullopt, true});
  BOOST_CHECK(grade(c, 1, bound) >= GC::Visual_class::g1);
  BOOST_CHECK(done.unrepaired.empty());
}

// Numbers of 17 digits: handles that may get more decimals are mended wherever one of them is free,
// nodes stay, and what is mended stays as it is.
BOOST_AUTO_TEST_CASE(beside_the_grid) {
  std::mt19937 random = seeded(30);
  std::uniform_real_distribution<double> noise(-1e-3, 1e-3), any(-1, 1);
  std::size_t kinks = 0;
  for (int i = 0; i < 60; ++i) {
    typedef Drawing_traits::Point Point;
    std::vector<std::vector<Point>> curves;
    double x = any(random), y = any(random), angle = 3 * any(random);
    const auto point = [](double u, double v) { return Point(Grid_fraction(u), Grid_fraction(v)); };
    for (int k = 0; k < 6; ++k) {
      std::vector<Point> p{point(x, y)};
      const auto step = [&](double turn) {
        x += std::cos(angle + turn);
        y += std::sin(angle + turn);
        p.push_back(point(x, y));
      };
      const double turn = any(random) / 2;
      step(k == 0 ? 0 : noise(random));
      if (k != 3) { // a line
        step(turn / 2);
        step(turn);
        angle += turn;
      }
      curves.push_back(p);
    }
    Grid_contour given;
    given.decimals = coarser_decimals({curves.front().front(), curves.back().back()}, longest_beside_grid({bound}));
    given.is_beside_grid = given.may_add_decimals = true;
    for (const auto& p : curves) given.curves.push_back(curve_beside_grid(p, given.decimals));
    Grid_contour repaired = given;
    const Contour_repair done = repair(repaired, {bound});
    BOOST_CHECK(done.unrepaired.empty());
    for (std::size_t j = 0; j < given.number_of_joins(); ++j) {
      kinks += grade(given, j, bound) == GC::Visual_class::kink;
      BOOST_CHECK(grade(repaired, j, bound) >= GC::Visual_class::g1);
    }
    for (std::size_t c = 0; c < curves.size(); ++c)
      for (const std::size_t k : {std::size_t(0), curves[c].size() - 1}) {
        const Point p = exact_point(repaired.curves[c], k), q = curves[c][k];
        const Grid_fraction unit = power_of_ten(given.decimals);
        BOOST_CHECK(p.x() == q.x() * unit && p.y() == q.y() * unit);
      }
    for (const Handle_move& m : done.moves) BOOST_CHECK(m.point == 1 || m.point == 2);
    BOOST_CHECK(repair(repaired, {bound}).moves.empty());
  }
  BOOST_TEST(kinks > 200u);
}

// The fewest reversals that leave the fewest gaps, compared with all of them.
BOOST_AUTO_TEST_CASE(fewest_reversals) {
  std::mt19937 random = seeded(31);
  for (int i = 0; i < 300; ++i) {
    const std::size_t n = 1 + random() % 7;
    const bool closed = random() % 2 != 0;
    const auto node = [&] { return Drawing_traits::Point(static_cast<int>(random() % 3), 0); };
    std::vector<Curve_ends> curves;
    for (std::size_t k = 0; k < n; ++k) curves.push_back({node(), node()});
    const auto gaps = [&](unsigned reversed) {
      std::size_t count = 0;
      for (std::size_t k = 0; k + 1 < n || (closed && k < n); ++k) {
        const std::size_t next = (k + 1) % n;
        count += curves[k][(reversed >> k & 1) != 0 ? 0 : 1] != curves[next][(reversed >> next & 1) != 0 ? 1 : 0];
      }
      return count;
    };
    std::pair<std::size_t, std::size_t> least(gaps(0), 0);
    for (unsigned r = 0; r < 1u << n; ++r) {
      std::size_t count = 0;
      for (std::size_t k = 0; k < n; ++k) count += r >> k & 1;
      least = (std::min)(least, std::pair(gaps(r), count));
    }
    const Chain_reversal found = find_reversal(curves, closed, 0);
    unsigned reversed = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < n; ++k)
      if (found.curves[k]) {
        reversed |= 1u << k;
        ++count;
      }
    BOOST_TEST(found.gaps_before == gaps(0));
    BOOST_TEST(found.gaps_after == gaps(reversed));
    BOOST_CHECK(std::pair(found.gaps_after, count) == least);
  }
}
