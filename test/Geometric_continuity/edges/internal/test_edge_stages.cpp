// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The predicates of edge_predicates.h on double coordinates, on rational numbers and on spans of
// splines: every stage is reached and agrees with the plain decision in rational numbers
// (Edge_conditions), on edges of every class.
//
// Set GEOMETRIC_CONTINUITY_EDGES for the number of edges of each class and
// GEOMETRIC_CONTINUITY_SEED for other numbers.

#include "support/net_of.h"
#include "support/random.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

BOOST_AUTO_TEST_SUITE(filtered_edges)

using GC::Patch_edge;
using GC::internal::Stage;
constexpr Patch_edge u0 = Patch_edge::u0, u1 = Patch_edge::u1, v0 = Patch_edge::v0, v1 = Patch_edge::v1;

typedef GC::Bezier_patch<Epick_3> Patch;

// Stages switched on one by one; multi-precision is always there.
struct Stages {
  unsigned used;
  std::array<long, GC::internal::number_of_stages> count{};
  bool uses(Stage s) const { return (used >> static_cast<int>(s)) & 1; }
  void decided(Stage s, bool) { ++count[static_cast<int>(s)]; }
};
constexpr unsigned stage(Stage s) { return 1u << static_cast<int>(s); }
constexpr unsigned all_stages = (1u << GC::internal::number_of_stages) - 1;
const unsigned combinations[] = {stage(Stage::comparison),
                                 stage(Stage::floating_point),
                                 stage(Stage::simple_ratio),
                                 stage(Stage::fixed_integer),
                                 0,
                                 all_stages};

struct Counter {
  // [order][stage], with all stages
  std::array<std::array<long, GC::internal::number_of_stages>, 3> stages{};
  std::array<std::array<long, 2>, 3> answers{};
  long mismatches = 0;

  long of(int order, Stage s) const { return stages[order][static_cast<int>(s)]; }
};

// ---------------------------------------------------------------- the reference

typedef GC::Edge_rows<Q> Rows;

Rows rows_of(const Patch& patch, Patch_edge edge) { return GC::edge_rows_over<Q>(patch, edge); }

GC::Coordinate_vector<Q, 3> point(Rows::Row row, const Q& t) {
  for (int n = static_cast<int>(row.size()) - 1; n > 0; --n) GC::de_casteljau_step(row, n, t);
  return row[0];
}

// The points of an edge at enough parameters to determine it.
bool same_points(const Rows::Row& a, const Rows::Row& b) {
  const int n = static_cast<int>(std::max(a.size(), b.size()));
  for (int k = 0; k <= n; ++k) {
    if (point(a, Q(k) / n) != point(b, Q(k) / n)) return false;
  }
  return true;
}

int reference(const Patch& a, Patch_edge edge_a, const Patch& b, Patch_edge edge_b) {
  const Rows x = rows_of(a, edge_a), y = rows_of(b, edge_b), z = y.reversed();
  const bool forwards = same_points(x.edge, y.edge);
  if (!forwards && !same_points(x.edge, z.edge)) return -1;
  const GC::Edge_conditions<Q> conditions(x, forwards ? y : z);
  return conditions.g2() ? 2 : conditions.g1() ? 1 : 0;
}

template <int order, class A, class B>
void check_order(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b, int truth, Counter& counter) {
  ++counter.answers[order][order <= truth];
  bool agree = true;
  for (const unsigned used : combinations) {
    Stages stages{used};
    agree = agree && GC::internal::edge_has_order<order>(a, edge_a, b, edge_b, stages) == (order <= truth);
    for (int s = 0; s + 1 < GC::internal::number_of_stages; ++s)
      agree = agree && (stages.count[s] == 0 || stages.uses(static_cast<Stage>(s)));
    if (used == all_stages)
      for (int s = 0; s < GC::internal::number_of_stages; ++s) counter.stages[order][s] += stages.count[s];
  }
  if (!agree && counter.mismatches++ < 5)
    BOOST_ERROR("order " << order << ", expected " << truth << "\n" << a << "\n" << b);
}
template <class A, class B>
void check_orders(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b, int truth, Counter& counter) {
  check_order<0>(a, edge_a, b, edge_b, truth, counter);
  check_order<1>(a, edge_a, b, edge_b, truth, counter);
  check_order<2>(a, edge_a, b, edge_b, truth, counter);
}

bool agree(const GC::Edge_continuity<Q>& x, const GC::Edge_continuity<Q>& y) {
  return x.g_order == y.g_order && x.defect == y.defect && x.reversed == y.reversed && x.coplanar == y.coplanar &&
         x.side == y.side && x.collapsed == y.collapsed && x.normal_vanishes == y.normal_vanishes;
}

// The report on two patches is the same whether or not numbers of fixed length prove that the edge
// is smooth.
void check_report(const Patch& a, Patch_edge edge_a, const Patch& b, Patch_edge edge_b, int truth) {
  typedef GC::Spline_edge_continuity<Q> Report;
  const Report e = GC::edge_continuity(a, edge_a, b, edge_b);
  BOOST_CHECK_EQUAL(e.g_order, truth);
  if (truth < 1) return;
  const Report f = GC::edge_continuity(GC::spline_edge_rows(a, edge_a), GC::spline_edge_rows(b, edge_b));
  const auto same = [](const GC::Edge_continuity<Q>& x, const GC::Edge_continuity<Q>& y) {
    return agree(x, y) && x.vanishing == y.vanishing && x.deviation->lower == y.deviation->lower &&
           x.deviation->upper == y.deviation->upper && x.deviation->begin == y.deviation->begin &&
           x.deviation->end == y.deviation->end;
  };
  BOOST_CHECK(same(e, f) && e.part_a == f.part_a && e.part_b == f.part_b && e.whole_a && e.whole_b && f.whole_a &&
              f.whole_b && e.worst == f.worst);
  BOOST_REQUIRE(e.spans.size() == 1 && f.spans.size() == 1);
  BOOST_CHECK(e.spans[0].begin == f.spans[0].begin && e.spans[0].end == f.spans[0].end &&
              same(e.spans[0].continuity, f.spans[0].continuity));
}

void check(const Patch& a, Patch_edge edge_a, const Patch& b, Patch_edge edge_b, Counter& counter) {
  const int truth = reference(a, edge_a, b, edge_b);
  if (truth > 0) {
    const auto moved = [](const Patch& s) { return s.with_domain({-1, 3}, {0.25, 7}); };
    check_report(moved(a), edge_a, moved(b), edge_b, truth);
  } else if (counter.answers[0][0] + counter.answers[0][1] < 10)
    check_report(a, edge_a, b, edge_b, truth);
  check_orders(a, edge_a, b, edge_b, truth, counter);
}

// ---------------------------------------------------------------- edges

// Power-form space curves with whole coefficients.
typedef std::vector<std::array<std::int64_t, 3>> Curve;
typedef std::vector<std::int64_t> Polynomial;

Curve operator+(const Curve& a, const Curve& b) {
  Curve c(std::max(a.size(), b.size()));
  for (int x = 0; x < 3; ++x)
    for (std::size_t k = 0; k < c.size(); ++k) c[k][x] = (k < a.size() ? a[k][x] : 0) + (k < b.size() ? b[k][x] : 0);
  return c;
}
Curve operator*(const Polynomial& p, const Curve& c) {
  Curve r(p.size() + c.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < c.size(); ++j)
      for (int x = 0; x < 3; ++x) r[i + j][x] += p[i] * c[j][x];
  return r;
}
Curve derivative(const Curve& c) {
  Curve d;
  for (std::size_t k = 1; k < c.size(); ++k) {
    const std::int64_t f = static_cast<std::int64_t>(k);
    d.push_back({f * c[k][0], f * c[k][1], f * c[k][2]});
  }
  if (d.empty()) d.push_back({0, 0, 0});
  return d;
}

class Random : public Random_integers<std::mt19937_64> {
public:
  Curve curve(int degree, int direction) { // roughly in a coordinate direction
    Curve c(degree + 1);
    for (auto& p : c)
      for (std::int64_t& x : p) x = integer(-1, 1);
    if (direction < 3) c[direction == 0 && degree > 0 ? 1 : 0][direction] += 12;
    return c;
  }
  Polynomial polynomial(int degree) {
    Polynomial p;
    for (int k = 0; k <= degree; ++k) p.push_back(integer(-2, 2));
    return p;
  }
};

// Describes two surfaces along an edge, see Edge_conditions.
struct Connection {
  int n, q1, q2; // degrees
  Curve c, t1, w1, t2, w2;

  // The surfaces are G2; p is of degree 1 or 0, and n >= 2.
  Connection(Random& r, int degree) : n(degree), q1(pick(r)), q2(pick(r)) {
    do {
      c = r.curve(n, 0);
      t1 = r.curve(n - 1, 1);
    } while (!has_normals_at_the_ends());
    w1 = q1 > 1 ? r.curve(n - 1, 3) : Curve{{0, 0, 0}};
    const auto p = r.polynomial(r.integer(0, 1));
    connect(r, p, -r.integer(1, 3));
  }
  bool has_normals_at_the_ends() const {
    const Curve d = derivative(c);
    std::array<std::int64_t, 3> d_end{}, t_end{};
    for (int x = 0; x < 3; ++x)
      for (int k = 0; k < n; ++k) {
        d_end[x] += d[k][x];
        t_end[x] += t1[k][x];
      }
    const auto independent = [](const std::array<std::int64_t, 3>& v, const std::array<std::int64_t, 3>& w) {
      return v[0] * w[1] != v[1] * w[0] || v[0] * w[2] != v[2] * w[0] || v[1] * w[2] != v[2] * w[1];
    };
    return independent(d[0], t1[0]) && independent(d_end, t_end);
  }
  static int pick(Random& r) { return static_cast<int>(r.integer(0, 9) == 0 ? 8 : r.integer(2, 4)); }

  void connect(Random& r, const Polynomial& p, std::int64_t q) {
    const Curve d = derivative(c);
    t2 = p * d + Polynomial{q} * t1;
    Polynomial square(2 * p.size() - 1), twice;
    for (std::size_t i = 0; i < p.size(); ++i) {
      twice.push_back(2 * q * p[i]);
      for (std::size_t j = 0; j < p.size(); ++j) square[i + j] += p[i] * p[j];
    }
    w2 = square * derivative(d) + twice * derivative(t1) + Polynomial{q * q} * w1 + r.polynomial(1) * d +
         r.polynomial(1) * t1;
  }

  // The common factor of all coordinates: what Bernstein coefficients and the layers of the control
  // nets divide by.
  std::int64_t factor() const {
    std::int64_t f = 1, binomial = 1;
    for (int k = 0; k <= n; ++k) {
      f = std::lcm(f, binomial);
      binomial = binomial * (n - k) / (k + 1);
    }
    return f * q1 * std::max(q1 - 1, 1) * q2 * std::max(q2 - 1, 1);
  }

  // The Bernstein coefficients of degree n, times the factor.
  Curve bernstein(const Curve& power) const {
    Curve b(n + 1);
    for (int i = 0; i <= n; ++i)
      for (int x = 0; x < 3; ++x) {
        std::int64_t choose_i = 1, choose_n = 1; // C(i,k), C(n,k)
        for (int k = 0; k <= i && k < static_cast<int>(power.size()); ++k) {
          b[i][x] += power[k][x] * choose_i * (factor() / choose_n);
          choose_i = choose_i * (i - k) / (k + 1);
          choose_n = choose_n * (n - k) / (k + 1);
        }
      }
    return b;
  }

  // The layers of a net of degree q with the rows c, t, w, and random further layers.
  std::vector<Curve> layers(Random& r, int q, const Curve& t, const Curve& w) const {
    const Curve c0 = bernstein(c), t0 = bernstein(t), w0 = bernstein(w);
    std::vector<Curve> s(q + 1, Curve(n + 1));
    for (int j = 0; j <= q; ++j)
      for (int i = 0; i <= n; ++i)
        for (int x = 0; x < 3; ++x)
          s[j][i][x] = c0[i][x] + (j == 0   ? 0
                                   : j == 1 ? t0[i][x] / q
                                   : j == 2 ? 2 * t0[i][x] / q + w0[i][x] / (q * (q - 1))
                                            : r.integer(-1000, 1000));
    return s;
  }
};

// The layers in any of the 8 orientations, with a map of the coordinates.
template <class Map> std::pair<Patch, Patch_edge> placed(const std::vector<Curve>& layers, int orientation, Map map) {
  std::vector<std::vector<Epick_3::Point>> net;
  for (std::size_t i = 0; i < layers[0].size(); ++i) {
    net.emplace_back();
    for (const Curve& layer : layers) {
      const std::array<double, 3> p = map(layer[i]);
      net.back().emplace_back(p[0], p[1], p[2]);
    }
  }
  Patch s(net);
  if (orientation & 1) s = s.reverse_u();
  if (orientation & 2) s = s.reverse_v();
  if (orientation & 4) s = s.swap_parameters();
  return {s, orientation & 4 ? (orientation & 2 ? u1 : u0) : (orientation & 2 ? v1 : v0)};
}

struct Edges {
  std::vector<Curve> first, second;
};
Edges edges(Random& r, const Connection& s) { return {s.layers(r, s.q1, s.t1, s.w1), s.layers(r, s.q2, s.t2, s.w2)}; }

// Multiplies by the largest odd number that leaves all coordinates below 2^53.
void fill(Edges& e) {
  std::int64_t size = 1;
  for (const auto* layers : {&e.first, &e.second})
    for (const Curve& layer : *layers)
      for (const auto& p : layer)
        for (const std::int64_t x : p) size = std::max(size, std::abs(x));
  const std::int64_t factor = ((std::int64_t(1) << 53) / size - 1) | 1;
  if (factor <= 1) return;
  for (auto* layers : {&e.first, &e.second})
    for (Curve& layer : *layers)
      for (auto& p : layer)
        for (std::int64_t& x : p) x *= factor;
}

template <class Map> void check_edges(Random& r, const Edges& e, Map map, Counter& counter) {
  const auto a = placed(e.first, r.integer(0, 7), map), b = placed(e.second, r.integer(0, 7), map);
  check(a.first, a.second, b.first, b.second, counter);
}

std::array<double, 3> scaled(const std::array<std::int64_t, 3>& p, int x, int y, int z) {
  return {std::ldexp(double(p[0]), x), std::ldexp(double(p[1]), y), std::ldexp(double(p[2]), z)};
}
const auto as_given = [](const std::array<std::int64_t, 3>& p) { return scaled(p, 0, 0, 0); };

int edges_of_a_class() { return static_cast<int>(from_environment("GEOMETRIC_CONTINUITY_EDGES", 60)); }

void report(const char* name, const Random& r, const Counter& c) {
  std::cout << name << ", seed " << r.seed
            << ": order 1 and 2 decided by comparison, floating point, ratio, fixed integers, "
            << "multi-precision:";
  for (int order : {1, 2})
    for (long n : c.stages[order]) std::cout << ' ' << n;
  std::cout << '\n';
  BOOST_CHECK_EQUAL(c.mismatches, 0);
}

BOOST_AUTO_TEST_CASE(smooth_edges) {
  Random r;
  Counter counter, full;
  for (int i = 0; i < edges_of_a_class(); ++i) {
    const Connection s(r, 2 + i % 6);
    Edges e = edges(r, s);
    check_edges(r, e, as_given, counter);
    fill(e);
    check_edges(r, e, as_given, full);
  }
  report("smooth", r, counter);
  report("smooth with 53 bits", r, full);
  for (const Counter& c : {counter, full})
    for (int order : {1, 2}) {
      BOOST_CHECK_EQUAL(c.answers[order][1], edges_of_a_class());
      BOOST_CHECK_GT(c.of(order, Stage::simple_ratio), edges_of_a_class() / 2);
    }
}

// The surfaces agree to first order only, and differ in curvature by a little or much.
BOOST_AUTO_TEST_CASE(curvature_differs) {
  Random r;
  Counter counter;
  for (int i = 0; i < edges_of_a_class(); ++i) {
    Connection s(r, 2 + i % 6);
    s.w2[r.integer(0, static_cast<int>(s.w2.size()) - 1)][2] += i % 2 == 0 ? 1 : 100;
    Edges e = edges(r, s);
    if (i % 3 == 0) fill(e);
    check_edges(r, e, as_given, counter);
  }
  report("curvature differs", r, counter);
  BOOST_CHECK_EQUAL(counter.answers[1][1], edges_of_a_class());
  BOOST_CHECK_LT(counter.answers[2][1], edges_of_a_class() / 4);
  BOOST_CHECK_GT(counter.of(2, Stage::floating_point), 0);
}

// One coordinate of a control point moved by a unit in the last place, in each layer.
BOOST_AUTO_TEST_CASE(one_unit_in_the_last_place) {
  Random r;
  std::array<Counter, 3> counters;
  for (int i = 0; i < edges_of_a_class(); ++i)
    for (int layer = 0; layer < 3; ++layer) {
      const Connection s(r, 2 + i % 6);
      Edges e = edges(r, s);
      fill(e);
      e.second[layer][r.integer(0, s.n)][layer == 0 ? 0 : 2] += r.integer(0, 1) == 0 ? 1 : -1;
      check_edges(r, e, as_given, counters[layer]);
    }
  for (int layer = 0; layer < 3; ++layer) {
    report("one unit", r, counters[layer]);
    BOOST_CHECK_EQUAL(counters[layer].answers[layer][1], 0);
    if (layer > 0) BOOST_CHECK_EQUAL(counters[layer].answers[layer - 1][1], edges_of_a_class());
    if (layer > 0)
      BOOST_CHECK_GT(counters[layer].of(layer, layer == 1 ? Stage::fixed_integer : Stage::simple_ratio),
                     edges_of_a_class() / 2);
  }
  BOOST_CHECK_EQUAL(counters[0].of(1, Stage::comparison), edges_of_a_class());
}

BOOST_AUTO_TEST_CASE(grossly_off) {
  Random r;
  Counter counter;
  for (int i = 0; i < edges_of_a_class(); ++i) {
    const Connection s(r, 2 + i % 6);
    Edges e = edges(r, s);
    const std::int64_t size = std::int64_t(1) << (i % 2 == 0 ? 20 : 53);
    for (auto* layers : {&e.first, &e.second})
      for (std::size_t j = i % 3 == 0 ? 0 : 1; j < layers->size(); ++j)
        for (auto& p : (*layers)[j])
          for (std::int64_t& x : p)
            x = r.integer(0, 3) == 0 ? (r.integer(0, 1) ? size : -size) : r.integer(-size, size);
    if (i % 3 == 0) e.second[0] = e.first[0];
    check_edges(r, e, as_given, counter);
  }
  report("grossly off", r, counter);
  BOOST_CHECK_EQUAL(counter.answers[1][1], 0);
  BOOST_CHECK_GT(counter.of(1, Stage::floating_point), edges_of_a_class() * 9 / 10);
}

// Scaled by powers of two, the same for all coordinates or not; smoothness along an edge does not
// change under affine maps.
BOOST_AUTO_TEST_CASE(tiny_huge_and_mixed) {
  Random r;
  Counter uniform, tiny_huge, mixed;
  for (int i = 0; i < edges_of_a_class(); ++i) {
    Connection s(r, 2 + i % 4);
    if (i % 2 == 1) s.w2[0][2] += 1;
    if (i % 4 == 3) s.t2[0][2] += 1;
    const Edges e = edges(r, s);
    const int k = r.integer(-350, 400);
    check_edges(
        r, e, [&](const auto& p) { return scaled(p, k, k, k); }, uniform);
    const int extreme = r.integer(0, 1) ? 950 : -1060;
    check_edges(
        r, e, [&](const auto& p) { return scaled(p, extreme, extreme, extreme); }, tiny_huge);
    const int x = r.integer(-200, 200), y = r.integer(-200, 200), z = r.integer(-1060, 600);
    check_edges(
        r, e, [&](const auto& p) { return scaled(p, x, y, z); }, mixed);
  }
  report("scaled", r, uniform);
  report("tiny and huge", r, tiny_huge);
  report("mixed exponents", r, mixed);
  for (const Counter& c : {uniform, tiny_huge, mixed}) {
    BOOST_CHECK_GE(c.answers[1][1], edges_of_a_class() * 3 / 4);
    BOOST_CHECK_GE(c.answers[2][1], edges_of_a_class() / 2);
  }
  BOOST_CHECK_EQUAL(tiny_huge.of(1, Stage::comparison) + tiny_huge.of(1, Stage::multiprecision), edges_of_a_class());
  BOOST_CHECK_GT(mixed.of(1, Stage::multiprecision), 0);
}

BOOST_AUTO_TEST_CASE(degenerate_edges) {
  Random r;
  Counter counter;
  for (int i = 0; i < edges_of_a_class(); ++i) {
    Connection s(r, 2 + i % 4);
    switch (i % 6) {
    case 0: // a fold
      s.connect(r, r.polynomial(1), 2);
      break;
    case 1: // a normal that vanishes at an end, or inside
      s.t1 = Polynomial{0, 1} * r.curve(s.n - 1, 1);
      s.connect(r, {1}, -1);
      break;
    case 2:
      s.t2 = Polynomial{1, -2} * r.curve(s.n - 1, 1);
      s.t1 = s.t2;
      break;
    case 3: // no normal
      s.t2 = derivative(s.c);
      break;
    case 4: // a single point
      s.c = {{5, 6, 7}};
      break;
    case 5: // bilinear
      s.n = 1;
      s.q1 = s.q2 = 1;
      s.c = {{0, 0, 0}, {4, 1, 0}};
      s.t1 = {{0, 3, 1}, {1, 0, 0}};
      s.t2 = {{1, -3, -1}, {-1, 0, 0}};
      s.w1 = s.w2 = {{0, 0, 0}};
    }
    check_edges(r, edges(r, s), as_given, counter);
  }
  report("degenerate", r, counter);
  BOOST_CHECK_GT(counter.of(1, Stage::multiprecision), 0);
  BOOST_CHECK_GT(counter.of(1, Stage::comparison), 0);
}

// Degrees that differ along the edge, or are too large for integers of fixed length, and surfaces
// that are not patches.
BOOST_AUTO_TEST_CASE(other_degrees) {
  Random r;
  Counter counter;
  for (int i = 0; i < edges_of_a_class() / 4; ++i) {
    const Connection s(r, 3), large(r, 8);
    Edges e = edges(r, s);
    for (auto* layers : {&e.first, &e.second})
      for (Curve& layer : *layers)
        for (auto& p : layer)
          for (std::int64_t& x : p) x *= 4; // elevation to degree 4 divides by it
    const auto a = placed(e.first, 0, as_given), b = placed(e.second, 0, as_given);
    const Patch quartic = b.first.elevate(1, 0);
    check(a.first, v0, quartic, v0, counter);
    check(quartic, v0, a.first, v0, counter);
    check(a.first.elevate(1, 0), v0, quartic, v0, counter);
    check_edges(r, edges(r, large), as_given, counter);
    const GC::Bspline_surface<Epick_3> spline(a.first);
    BOOST_CHECK(GC::is_g2_edge(spline, v0, quartic, v0) && GC::is_g1_edge(quartic, v0, spline, v0) &&
                GC::is_g0_edge(spline, v0, spline, v0) && !GC::is_g1_edge(spline, v0, spline, v0));
    BOOST_CHECK(GC::is_g2_edge(a.first, v0, b.first, v0) && GC::is_g1_edge(a.first, v0, b.first, v0) &&
                GC::is_g0_edge(a.first, v0, b.first, v0));
    BOOST_CHECK(!GC::is_g0_edge(a.first, u0, b.first, v0) && !GC::is_g1_edge(a.first, v0, a.first, v0));
    // a part of an edge is not the edge
    BOOST_CHECK(!GC::is_g0_edge(a.first, v0, b.first.split_u(0.5).first, v0));
  }
  report("other degrees", r, counter);
  BOOST_CHECK_EQUAL(counter.answers[2][0], 0);
  BOOST_CHECK_GT(counter.of(2, Stage::multiprecision), 0);
}

BOOST_AUTO_TEST_CASE(not_finite) {
  const auto patch = [](double z) {
    return Patch(
        {{Epick_3::Point(0, 0, 0), Epick_3::Point(0, 1, z)}, {Epick_3::Point(1, 0, 0), Epick_3::Point(1, 1, 0)}});
  };
  for (double z : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_ERROR(GC::is_g1_edge(patch(0), v0, patch(z), v0), not_finite);
  // the stages of fixed length leave to others what surfaces refuse
  GC::internal::Edge_layers x, y;
  BOOST_REQUIRE((GC::internal::edge_layers(patch(0), v0, patch(1), v0, 2, x, y)));
  Stages all{all_stages}, none{0};
  BOOST_CHECK(GC::internal::decide_on_same_edge<0>(x, y, all) == true);
  BOOST_CHECK(!GC::internal::decide_on_same_edge<0>(x, y, none));
  for (double z : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    GC::internal::Edge_layers bad = y;
    bad.p[1][0][2] = z;
    BOOST_CHECK(GC::internal::size_of(y) == 1 && std::isinf(GC::internal::size_of(bad)));
    BOOST_CHECK(!GC::internal::decide_on_same_edge<0>(x, bad, all) &&
                !GC::internal::decide_on_same_edge<0>(bad, x, all));
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
    GC::internal::Edge_ladder good(x, y), ladder(x, bad);
    BOOST_CHECK(good.on_grid() != nullptr && ladder.on_grid() == nullptr);
#endif
  }
}

// T2 = (gamma C' + beta T1) / alpha with numbers each of which is short, but not over one
// denominator: 7000 over 7.
BOOST_AUTO_TEST_CASE(ratios_that_become_long) {
  const auto patch = [](double length, const std::array<double, 2>& start, const std::array<double, 2>& end) {
    return Patch({{Epick_3::Point(0, 0, 0), Epick_3::Point(start[0], start[1], 0)},
                  {Epick_3::Point(length, 0, 0), Epick_3::Point(length + end[0], end[1], 0)}});
  };
  struct Case {
    double length, a;
    std::array<double, 2> start, end;
  };
  for (const Case& c : {Case{7, 1, {1, -1000}, {1, -1000}}, Case{1, 7, {1000, -1}, {0, -1}},
                        Case{1, 7, {0, -1}, {1000, -1}}, Case{1, 1, {2, -1}, {3, -1}}}) {
    const Patch a = patch(c.length, {0, c.a}, {0, c.a}), b = patch(c.length, c.start, c.end);
    BOOST_CHECK(GC::is_g1_edge(a, v0, b, v0) && GC::is_g2_edge(a, v0, b, v0)); // in one plane
    GC::internal::Edge_layers x, y;
    BOOST_REQUIRE((GC::internal::edge_layers(a, v0, b, v0, 2, x, y)));
    Stages ratio{stage(Stage::simple_ratio)};
    BOOST_CHECK_EQUAL(GC::internal::decide_on_same_edge<2>(x, y, ratio).has_value(), c.length == 1 && c.a == 1);
  }
}

// Second differences much larger than the first ones, which rounded numbers do not judge.
BOOST_AUTO_TEST_CASE(steep_second_layers) {
  const auto patch = [](double y, double z) {
    return Patch({{Epick_3::Point(0, 0, 0), Epick_3::Point(0, y, 0), Epick_3::Point(0, 2 * y, z)},
                  {Epick_3::Point(1, 0, 0), Epick_3::Point(1, y, 0), Epick_3::Point(1, 2 * y, z)}});
  };
  for (const double z : {0x1p99, 0x1p101, 0x1p300}) {
    BOOST_CHECK(GC::is_g1_edge(patch(1, 0), v0, patch(-1, z), v0) &&
                !GC::is_g2_edge(patch(1, 0), v0, patch(-1, z), v0));
    BOOST_CHECK(GC::is_g2_edge(patch(1, z), v0, patch(-1, z), v0));
  }
  // what has not the order 2 has not the order 3, which needs more numbers
  const auto spline = [&](double y, double z) { return GC::Bspline_surface<Epick_3>(patch(y, z)).insert_u(0.5); };
  BOOST_CHECK(!GC::is_g3_edge(patch(1, 0), v0, patch(-1, 1), v0) &&
              !GC::is_g3_edge(spline(1, 0), v0, spline(-1, 1), v0));
  BOOST_CHECK(GC::is_g3_edge(patch(1, 0), v0, patch(-1, 0), v0) && GC::is_g3_edge(spline(1, 0), v0, spline(-1, 0), v0));
}

// ------------------------------------------------------ rational numbers, and the spans of splines

typedef GC::Bezier_patch<Exact_3> Rational_patch;
typedef GC::Bspline_surface<Exact_3> Rational_spline;

// With coordinates divided by a whole number.
Rational_patch rational(const Patch& s, int divisor) {
  return surface_exactly<Exact_3>(s).transform([&](const Exact_3::Point& p) {
    return Exact_3::Point(Q(p.x() / divisor), Q(p.y() / divisor), Q(p.z() / divisor));
  });
}

// Over inner knots that change nothing, here those in the direction of the edge.
Rational_spline with_knots(const Rational_patch& s, Patch_edge edge, const std::vector<Q>& knots) {
  Rational_spline r(s);
  for (const Q& t : knots) r = runs_along_u(edge) ? r.insert_u(t) : r.insert_v(t);
  return runs_along_u(edge) ? r.insert_v(Q(1) / 2) : r.insert_u(Q(1) / 2);
}

// The report and the predicates on the same edge, in other numbers and over other knots, against
// `truth`, which the rational road has found: that for rows, which has no stages. A single point is
// of the order 0 in any parametrisation.
template <class Surface_a, class Surface_b>
void check_surfaces(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                    const GC::Edge_continuity<Q>& truth, Counter& counter) {
  const auto report = GC::edge_continuity(a, edge_a, b, edge_b);
  check_orders(a, edge_a, b, edge_b, truth.g_order, counter);
  if (truth.g_order >= 0 && !truth.collapsed) {
    const bool same = agree(report, truth) && report.whole_a && report.whole_b &&
                      (!truth.deviation || truth.deviation->upper != Q(0) || report.deviation->upper == Q(0));
    counter.mismatches += !same;
    BOOST_CHECK_MESSAGE(same, report << " instead of " << truth);
  }
}

void check_numbers_and_knots(const Patch& a, Patch_edge edge_a, const Patch& b, Patch_edge edge_b, Counter& rationals,
                             Counter& spans) {
  const GC::Edge_continuity<Q> truth = edge_continuity(rows_of(a, edge_a), rows_of(b, edge_b));
  check_surfaces(rational(a, 6), edge_a, rational(b, 6), edge_b, truth, rationals);
  // knots at equal places of the curve where the second edge runs backwards or not
  const std::vector<Q> halves{Q(1) / 2}, quarters{Q(1) / 4, Q(1) / 2, Q(3) / 4};
  const Rational_spline x = with_knots(rational(a, 1), edge_a, halves),
                        y = with_knots(rational(b, 1), edge_b, quarters);
  check_surfaces(x, edge_a, y, edge_b, truth, spans);
  check_surfaces(x, edge_a, rational(b, 1), edge_b, truth, spans);
}

BOOST_AUTO_TEST_CASE(rational_numbers_and_spans, *boost::unit_test::label("long")) {
  Random r;
  Counter rationals, spans, doubles, rough;
  for (int i = 0; i < edges_of_a_class(); ++i) {
    Connection s(r, 2 + i % 3);
    if (i % 3 == 1) s.w2[0][2] += 1; // order 1
    if (i % 6 == 2) s.t2[0][2] += 1; // a crease
    const Edges e = edges(r, s);
    const auto a = placed(e.first, r.integer(0, 7), as_given), b = placed(e.second, r.integer(0, 7), as_given);
    check_numbers_and_knots(a.first, a.second, b.first, b.second, rationals, spans);
    if (i % 4 == 0) { // the same splines on doubles, which represent them
      const auto c = placed(e.first, 0, as_given), d = placed(e.second, 0, as_given);
      const GC::Edge_continuity<Q> truth = edge_continuity(rows_of(c.first, v0), rows_of(d.first, v0));
      const auto spline = [](const Patch& patch) {
        return surface_exactly<Epick_3>(with_knots(rational(patch, 1), v0, {Q(1) / 2}));
      };
      check_surfaces(spline(c.first), v0, spline(d.first), v0, truth, doubles);
    }
    // off by one unit of coordinates of 53 bits, without a normal, a single point
    Edges off = edges(r, s);
    if (i % 3 == 0) {
      fill(off);
      off.second[i % 2 + 1][r.integer(0, s.n)][2] += 1;
    } else {
      if (i % 3 == 1) {
        s.t1 = Polynomial{0, 1} * r.curve(s.n - 1, 1);
        s.connect(r, {1}, -1);
      } else
        s.c = {{5, 6, 7}};
      off = edges(r, s);
    }
    const auto p = placed(off.first, 0, as_given), q = placed(off.second, r.integer(0, 7), as_given);
    check_numbers_and_knots(p.first, p.second, q.first, q.second, rough, rough);
  }
  report("rational numbers", r, rationals);
  report("spans of splines", r, spans);
  report("spans of splines on doubles", r, doubles);
  report("rough rational edges", r, rough);
  for (const Counter& c : {rationals, spans, doubles})
    for (int order : {1, 2}) {
      BOOST_CHECK_GT(c.of(order, Stage::simple_ratio), c.answers[order][1] / 2);
      BOOST_CHECK_GT(c.of(order, Stage::floating_point), 0);
      BOOST_CHECK_GT(c.answers[order][0], 0);
    }
  BOOST_CHECK_GT(rough.of(1, Stage::multiprecision), 0);
}

BOOST_AUTO_TEST_SUITE_END()
