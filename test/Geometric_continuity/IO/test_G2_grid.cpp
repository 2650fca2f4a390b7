// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Surfaces as they are written: the same as those of rational numbers, and, where they become
// surfaces of integers, with the same continuity along all edges.

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>

BOOST_AUTO_TEST_SUITE(G2_grid)

typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Double;
typedef std::vector<GC::Bspline_surface<Exact_3>> Exact_surfaces;
typedef std::vector<GC::Bspline_surface<Double>> Double_surfaces;
typedef std::vector<GC::Rational_bspline_surface<Exact_3>> Rational_surfaces;

// The polynomial surfaces of a file, and the others.
struct Texts {
  std::vector<GC::G2_surface_text> texts;
  Rational_surfaces rational;
};

Texts read_texts(const std::string& file) {
  std::istringstream is(file);
  GC::G2_surface_text_reader<Exact_3> reader(is, "f.g2");
  Texts result;
  const auto add = [&](auto surface) {
    if constexpr (std::is_same_v<decltype(surface), GC::G2_surface_text>)
      result.texts.push_back(std::move(surface));
    else
      result.rational.push_back(std::move(surface));
  };
  while (reader.visit_next(add)) {
  }
  return result;
}

Exact_surfaces read_exact(const std::string& file) {
  std::istringstream is(file);
  return GC::read_g2_bspline_surfaces<Exact_3>(is, "f.g2");
}

template <class Surface> std::string written(const Surface& surface) {
  return written_by([&](std::ostream& os) { GC::write_g2(os, surface); });
}

// Both ways to read the surfaces of a file, none of which has weights.
Exact_surfaces read_both_ways(const std::string& file) {
  const Exact_surfaces expected = read_exact(file);
  const Texts texts = read_texts(file);
  BOOST_CHECK(texts.rational.empty());
  BOOST_REQUIRE_EQUAL(texts.texts.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    BOOST_CHECK_EQUAL(written(texts.texts[i].surface<Exact_3>()), written(expected[i]));
  return expected;
}

// The surfaces on a grid.
bool bring_on_grid(const std::string& file, GC::G2_grid& grid, Double_surfaces& surfaces) {
  const Texts texts = read_texts(file);
  for (const GC::G2_surface_text& text : texts.texts) grid.include(text);
  return grid.append(texts.texts, surfaces);
}

Q power_of_ten(int exponent) { return GC::parse_number<Q>("1e" + std::to_string(exponent)); }

// Returns whether the grid surface times the units is the exact one.
bool is_scaled(const GC::Bspline_surface<Double>& surface, const GC::Bspline_surface<Exact_3>& exact,
               const GC::G2_grid& grid) {
  const Q length = power_of_ten(grid.exponent_of_coordinates()), parameter = power_of_ten(grid.exponent_of_knots());
  const auto same = [&](const GC::Knot_vector<double>& x, const GC::Knot_vector<Q>& y) {
    bool same = x.degree() == y.degree() && x.size() == y.size();
    for (int i = 0; same && i < y.size(); ++i) same = Q(x[i]) * parameter == y[i];
    return same;
  };
  if (!same(surface.knots_u(), exact.knots_u()) || !same(surface.knots_v(), exact.knots_v())) return false;
  for (int i = 0; i < exact.number_of_points_u(); ++i)
    for (int j = 0; j < exact.number_of_points_v(); ++j)
      for (int k = 0; k < 3; ++k)
        if (Q(surface.coordinates(i, j)[k]) * length != exact.coordinates(i, j)[k]) return false;
  return true;
}

// All that is decided about a model, but where.
template <class Surfaces> std::string decided(const Surfaces& surfaces) {
  std::ostringstream s;
  const auto model = GC::model_continuity(surfaces);
  for (const auto& e : model.edges) {
    s << e.patch_a << ' ' << e.edge_a << ' ' << e.kind;
    if (e.patch_b)
      s << " - " << *e.patch_b << ' ' << *e.edge_b << " G" << e.continuity.g_order << ' ' << e.continuity.defect;
    s << (e.non_manifold ? " non-manifold\n" : "\n");
  }
  for (const auto& l : model.knot_lines)
    s << l.patch << " knot line G" << l.line.continuity.g_order << ' ' << l.line.continuity.defect << '\n';
  s << model.summary << '\n';
  return s.str();
}

// A model with the same answers on the grid, and as many edges of each order: "G2 G1 G0 boundary".
void check_model(const std::string& file, const std::string& expected_counts) {
  const Exact_surfaces exact = read_both_ways(file);
  GC::G2_grid grid;
  Double_surfaces surfaces;
  BOOST_REQUIRE(bring_on_grid(file, grid, surfaces));
  BOOST_REQUIRE_EQUAL(surfaces.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) BOOST_CHECK(is_scaled(surfaces[i], exact[i], grid));
  BOOST_CHECK_EQUAL(decided(surfaces), decided(exact));
  const GC::Model_summary s = GC::model_continuity(surfaces).summary;
  std::ostringstream counts;
  counts << s.g2 << ' ' << s.g1 << ' ' << s.g0 << ' ' << s.boundary;
  BOOST_CHECK_EQUAL(counts.str(), expected_counts);
}

const std::string header = "200 1 0 0\n3 0\n";

// A surface of order 2 in both directions with these knots.
std::string flat(const std::string& u, const std::string& v, const std::string& points = "0 0 0 1 0 0 0 1 0 1 1 0") {
  return header + "2 2\n" + u + "\n2 2\n" + v + '\n' + points + '\n';
}

// A surface of order 3 in u and 2 in v, from (x, y, z) by these three rows of two points (x, y) at
// y = 0 and 1: a profile.
std::string profile(const std::string& knots, const std::vector<std::pair<std::string, std::string>>& points) {
  std::string file = header + std::to_string(points.size()) + " 3\n" + knots + "\n2 2\n0 0 .7 .7\n";
  for (const char* y : {"0", "0.30"})
    for (const auto& [x, z] : points) file += x + ' ' + y + ' ' + z + '\n';
  return file;
}

BOOST_AUTO_TEST_CASE(read_as_exact_surfaces) {
  std::mt19937 random = seeded(20261122);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto number = [&]() -> std::string {
    const std::string x = (below(2) == 0 ? "-" : "") + std::to_string(below(100000));
    switch (below(8)) {
    case 0: return x + "/7";
    case 1: return x + ".000000000000000000000001";
    case 2: return x + "e-3";
    case 3: return x;
    default: return x + '.' + std::to_string(below(1000));
    }
  };
  std::string file;
  for (int k = 0; k < 30; ++k) {
    file += header;
    int size[2];
    for (int& points : size) {
      const int order = 1 + below(4);
      points = order + below(3);
      file += std::to_string(points) + ' ' + std::to_string(order) + '\n';
      for (int i = 0; i < points + order; ++i)
        file += std::to_string(i < order    ? 0
                               : i < points ? i - order + 1
                                            : points - order + 1) +
                (k % 2 == 0 ? ".1 " : "/3 ");
      file += '\n';
    }
    for (int i = 0; i < 3 * size[0] * size[1]; ++i) file += number() + (i % 3 == 2 ? '\n' : ' ');
  }
  BOOST_CHECK_EQUAL(read_both_ways(file).size(), 30);
}

// On the grid numbers are integers, exactly.
BOOST_AUTO_TEST_CASE(units) {
  const std::string file = flat("0.1 0.1 0.30 0.30", "-1 -1 .5 .5", "0.125 -3 1e3 1 0 0 0 1 0 1 1.50 0") +
                           flat("0 0 1 1", "0 0 0.001 0.001", "1 1e-1 -0 2 2 2 3 3 3 4 4 4");
  GC::G2_grid grid;
  Double_surfaces surfaces;
  BOOST_REQUIRE(bring_on_grid(file, grid, surfaces));
  BOOST_CHECK_EQUAL(grid.exponent_of_coordinates(), -3);
  BOOST_CHECK_EQUAL(grid.exponent_of_knots(), -3);
  BOOST_REQUIRE_EQUAL(surfaces.size(), 2);
  BOOST_CHECK_EQUAL(surfaces[0].coordinates(0, 0)[0], 125);
  BOOST_CHECK_EQUAL(surfaces[0].coordinates(0, 0)[2], 1e6);
  BOOST_CHECK_EQUAL(surfaces[0].knots_u()[3], 300);
  BOOST_CHECK_EQUAL(surfaces[1].coordinates(0, 0)[1], 100);
  BOOST_CHECK_EQUAL(surfaces[1].knots_v()[3], 1);
  const Exact_surfaces exact = read_exact(file);
  for (int i = 0; i < 2; ++i) BOOST_CHECK(is_scaled(surfaces[i], exact[i], grid));
  // they are appended
  BOOST_CHECK(bring_on_grid(flat("0 0 1 1", "0 0 1 1"), grid, surfaces));
  BOOST_CHECK_EQUAL(surfaces.size(), 3);
  BOOST_CHECK_EQUAL(surfaces[2].knots_v()[3], 1000); // in the units of all
  // integers stay as they are, and large ones are doubles
  GC::G2_grid integers;
  surfaces.clear();
  BOOST_CHECK(bring_on_grid(flat("0 0 9007199254740992 9007199254740992", "-9007199254740992 -9007199254740992 1e1 1e1",
                                 "9007199254740992 -9007199254740992 1e15 1 0 0 0 1 0 1 1 0"),
                            integers, surfaces));
  BOOST_CHECK_EQUAL(integers.exponent_of_coordinates(), 0);
  BOOST_CHECK_EQUAL(integers.exponent_of_knots(), 0);
  BOOST_CHECK_EQUAL(surfaces[0].coordinates(0, 0)[1], -9007199254740992.0);
}

// Numbers of which one is no integer below the limit: nothing is appended, whatever knots would
// become of it.
BOOST_AUTO_TEST_CASE(not_on_a_grid) {
  const std::string knots = "0 0 1 1", good = flat(knots, knots);
  const auto with = [&](const std::string& x) { return flat(knots, knots, x + " 0 0 1 0 0 0 1 0 1 1 0"); };
  for (const std::string& file :
       {with("9007199254740993"), with("-9007199254740993"), with("1/2"), with("4/2"), with("1234567890123456789"),
        with(".1234567890123456789"), with("1e-16"), with("1e4096"), with("1e-4096"), with("900719925474099.3"),
        flat("0 0 1/2 1/2", knots), flat(knots, "0 0 1/2 1/2"),
        flat("0 0 1 1", "0 0 9007199254740993 9007199254740993"),
        // knots that would be equal as doubles or as integers of 64 bits
        flat("9007199254740992 9007199254740992 9007199254740993 9007199254740993", knots),
        flat("0 0 1e-20 1e-20", knots), flat(knots, "0 0 1e-20 1e-20"), flat("0 0 1e20 1e20", knots),
        flat("-1e18 -1e18 1e18 1e18", "0 0 .5 .5"), flat("1e18 1e18 2e18 2e18", "1 1 2 2")}) {
    for (const std::string& whole : {file, good + file, file + good}) {
      read_both_ways(whole);
      GC::G2_grid grid;
      Double_surfaces surfaces(read_exact(good).size(),
                               GC::Bspline_surface<Double>({{{0, 0, 0}}}, {0, {0, 1}}, {0, {0, 1}}));
      bool appended = true;
      BOOST_CHECK_EQUAL(error_of([&] { appended = bring_on_grid(whole, grid, surfaces); }), "no error");
      BOOST_CHECK_MESSAGE(!appended, whole);
      BOOST_CHECK_EQUAL(surfaces.size(), 1);
    }
  }
}

// Orders along edges, where coordinates and knots are no doubles.
BOOST_AUTO_TEST_CASE(orders_of_models) {
  typedef std::vector<std::pair<std::string, std::string>> Points;
  const std::string first = "0.1 0.1 0.1 0.2 0.2 0.2", second = "0.2 0.2 0.2 0.3 0.3 0.3";
  const std::string left = profile(first, {{"0", "0"}, {"0.1", "0"}, {"0.2", "0.1"}});
  // z - 0.1 = x - 0.2 is the tangent; the second differences are (0, 0.1)
  const Points same_curvature = {{"0.2", "0.1"}, {".3", "0.2"}, {"0.4", "0.4"}},
               other_curvature = {{"0.20", "0.1"}, {"0.3", "0.20"}, {"0.4", "0.3"}},
               nearly = {{"0.2", "0.1"}, {"0.3", "0.20000000000001"}, {"0.4", "0.4"}},
               crease = {{"0.2", "1e-1"}, {"0.3", "0.1"}, {"0.4", "0.4"}},
               gap = {{"0.2", "0.10000000000001"}, {"0.3", "0.2"}, {"0.4", "0.4"}};
  check_model(left + profile(second, same_curvature), "1 0 0 6");
  check_model(left + profile(second, other_curvature), "0 1 0 6");
  check_model(left + profile(second, nearly), "0 0 1 6");
  check_model(left + profile(second, crease), "0 0 1 6");
  check_model(left + profile(second, gap), "0 0 0 8");
  // one surface with a knot of one coordinate less, and with a multiple knot
  check_model(profile("0.1 0.1 0.1 0.2 0.3 0.3 0.3", {{"0", "0"}, {"0.1", "0"}, {"0.3", "0.2"}, {"0.4", "0.4"}}),
              "0 0 0 4");
  const std::string doubled = "0.1 0.1 0.1 0.2 0.2 0.3 0.3 0.3";
  check_model(profile(doubled, {{"0", "0"}, {"0.1", "0"}, {"0.2", "0.1"}, {"0.3", "0.2"}, {"0.4", "0.3"}}), "0 0 0 4");
  check_model(profile(doubled, {{"0", "0"}, {"0.1", "0"}, {"0.2", "0.1"}, {"0.3", "0.1"}, {"0.4", "0.3"}}), "0 0 0 4");
  // edges with inner knots, equal up to the units of the parameters: 0.1, 0.2, 0.4 and 1, 2, 4
  const std::string points = "0 0 0\n0.1 0 0.3\n0.2 0.1 0\n", knots = "0 0 .1 .1";
  const auto strip = [](const std::string& v, const char* y0, const char* y1, const char* z1) {
    std::string file = header + "2 2\n" + v + "\n3 2\n";
    file += "0.1 0.1 0.2 0.4 0.4\n";
    for (const char* x : {"0", "0.1", "0.3"})
      file += std::string(x) + ' ' + y0 + " 0\n" + x + ' ' + y1 + ' ' + z1 + '\n';
    return file;
  };
  check_model(strip(knots, "0", ".1", "0") + strip(knots, ".1", ".3", "0"), "1 0 0 6");
  check_model(strip(knots, "0", ".1", "0") + strip("0 0 .3 .3", "-.1", "0", "0"), "1 0 0 6");
}

// Random models of bilinear and biquadratic patches: a net that is one polynomial surface, with
// some points moved.
BOOST_AUTO_TEST_CASE(random_models) {
  std::mt19937 random = seeded(20261122);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int k = 0; k < 6; ++k) {
    constexpr int n = 3; // patches in a row
    int moved[2 * n + 1][2 * n + 1] = {};
    for (int i = 0; i < 2 * k; ++i) moved[below(2 * n + 1)][below(2 * n + 1)] = below(3) - 1;
    std::string file;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        file += header;
        for (int c : {a, b})
          file += "3 3\n" + std::string(c == a ? "0 0 0 .1 .1 .1" : "0.1 0.1 0.1 0.3 0.3 0.3") + '\n';
        for (int j = 2 * b; j <= 2 * b + 2; ++j)
          for (int i = 2 * a; i <= 2 * a + 2; ++i) // x^2 + x y, times 0.01, by its blossom
            file += "0." + std::to_string(i) + " 0." + std::to_string(j) + ' ' +
                    std::to_string(i / 2 * ((i + 1) / 2) * 4 + i * j + moved[i][j]) + "e-2\n";
      }
    const Exact_surfaces exact = read_both_ways(file);
    GC::G2_grid grid;
    Double_surfaces surfaces;
    BOOST_REQUIRE(bring_on_grid(file, grid, surfaces));
    BOOST_CHECK_EQUAL(decided(surfaces), decided(exact));
  }
}

BOOST_AUTO_TEST_CASE(rational_surfaces) {
  const std::string rational =
                        "200 1 0 0\n3 1\n2 2\n0 0 .1 .1\n2 2\n0 0 1 1\n0 0 0 1\n2 0 0 2\n0 .5 0 .5\n1/3 1/3 0 1/3\n",
                    good = flat("0 0 1 1", "0 0 1 1");
  const std::string file = good + rational + good;
  const Texts texts = read_texts(file);
  BOOST_CHECK_EQUAL(texts.texts.size(), 2);
  BOOST_REQUIRE_EQUAL(texts.rational.size(), 1);
  std::istringstream is(file);
  const Rational_surfaces expected = GC::read_g2_rational_bspline_surfaces<Exact_3>(is, "f.g2");
  BOOST_REQUIRE_EQUAL(expected.size(), 3);
  BOOST_CHECK_EQUAL(written(texts.rational[0]), written(expected[1]));
}

// With file, line and reason, as by the reader of exact surfaces.
BOOST_AUTO_TEST_CASE(errors) {
  const std::string good = flat("0 0 .1 .1", "0 0 1 1"), rational = "200 1 0 0\n3 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n";
  const auto refused = [](const std::string& file, const std::string& error) {
    BOOST_CHECK_EQUAL(error_of([&] { read_texts(file); }), "malformed_input: f.g2:" + error);
    std::istringstream is(file);
    BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_rational_bspline_surfaces<Exact_3>(is, "f.g2"); }),
                      "malformed_input: f.g2:" + error);
  };
  refused("", "1: no surface");
  refused("100 1 0 0\n", "1: 100 (spline curve) where a surface (200) is expected");
  refused(good + flat("0 0 1 1", "0 0 1 1", "0 0 0 1 0 0\n0 1 x"), "15: not a number: 'x'");
  refused(flat("0 0 1 1", "0 0 1 1", "0 0 0\n1 0 0\n0 1 1/0"), "9: zero denominator: '1/0'");
  refused(flat("0 0 1 1", "0 0 1 1", "0 0 0\n1 0 0\n"), "8: file ends after 2 of 4 control points");
  refused(good + flat("0 0 1e-1 1e-2", "0 0 1 1"), "11: the knots in u decrease at '1e-2'");
  refused(good + flat("0 0 .1 .1", "0 .1 1e-1 0.10"), "13: knot 2 of 4 in v is equal to knot 3: empty domain");
  refused(flat("0 0 1/3 2/6", "0.50 1/2 5e-1 1"), "6: knot 2 of 4 in v is equal to knot 3: empty domain");
  refused(good + rational + "0 0 0 1\n2 0 0 2\n0 1 0 0\n1 1 0 1\n",
          "17: zero_weight: Rational_bspline_surface: weights");
  std::istringstream bad("200");
  bad.setstate(std::ios_base::badbit);
  CHECK_ERROR((GC::G2_surface_text_reader<Exact_3>(bad, "f.g2")), cannot_read_file);
}

BOOST_AUTO_TEST_SUITE_END()
