// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The numbers in which a model is given, and the cores that decide it, make no difference:
// decimals, and the same model in whole numbers that are doubles, are decided alike, edge by edge.

#include "support/limited.h"
#include "support/net_of.h"
#include "support/random.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>

BOOST_AUTO_TEST_SUITE(parallel_models)

typedef Random_integers<> Random;

// The control points of a bicubic surface in whole numbers, those of a spline in its Bezier form:
// point (i, j) belongs to the patches i / 3 and j / 3. Some inner points are lifted, or lie next to
// an edge on the wrong side of it, and some rows collapse.
struct Grid_of_points {
  int n; // n x n patches
  std::vector<std::vector<std::vector<int>>> p;

  Grid_of_points(int n, Random& random) : n(n), p(3 * n + 1, std::vector<std::vector<int>>(3 * n + 1)) {
    const int m = n + 3, sixths[4][4] = {{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}};
    std::vector<std::vector<std::vector<int>>> spline(m, std::vector<std::vector<int>>(m));
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j)
        spline[i][j] = {10000 * i + random.integer(0, 3000), 10000 * j + random.integer(0, 3000),
                        random.integer(-9999, 9999)};
    for (int i = 0; i <= 3 * n; ++i)
      for (int j = 0; j <= 3 * n; ++j) {
        const int a = i == 3 * n ? n - 1 : i / 3, b = j == 3 * n ? n - 1 : j / 3;
        p[i][j].assign(3, 0);
        for (int k = 0; k < 4; ++k)
          for (int l = 0; l < 4; ++l)
            for (int x = 0; x < 3; ++x)
              p[i][j][x] += sixths[i - 3 * a][k] * sixths[j - 3 * b][l] * spline[a + k][b + l][x];
      }
    for (int k = 0; k < n * n / 4; ++k) {
      const int i = 3 * random.integer(0, n - 1), j = 3 * random.integer(0, n - 1);
      if (k % 3 == 0)
        p[i + 1][j + 1][2] += 36 * random.integer(1, 5000); // two creases
      else if (k % 3 == 1)
        p[i + 1][j + 2][0] += 36 * 60000; // folds, or angles that are not acute
      else
        for (int l = 1; l <= 3; ++l) p[i][j + l] = p[i][j]; // a collapsed edge
    }
  }
};

// The decimal x 10^-6, or x itself as a double.
template <class Traits> typename Traits::FT number(int x) {
  if constexpr (std::is_same_v<Traits, Exact_3>)
    return Q(x) / Q(1000000);
  else
    return x;
}

template <class Traits> typename Traits::Point point(const std::vector<int>& x) {
  return typename Traits::Point(number<Traits>(x[0]), number<Traits>(x[1]), number<Traits>(x[2]));
}

// The patch (i, j), possibly turned.
template <class Traits> auto net(const Grid_of_points& grid, int i, int j) {
  return net_of(4, 4, [&](int k, int l) {
    const int turn = (i + 2 * j) % 3, a = turn == 1 ? 3 - k : k, b = turn == 2 ? 3 - l : l;
    return point<Traits>(grid.p[3 * i + a][3 * j + b]);
  });
}

template <class FT> GC::Knot_vector<FT> unit_knots() { return GC::Knot_vector<FT>(3, FT(0), FT(1)); }

// The surfaces that f(i, j) makes of each patch, or of each so many in a row.
template <class F> auto surfaces(const Grid_of_points& grid, F f, int length = 1) {
  std::vector<decltype(f(0, 0))> result;
  for (int i = 0; i + length <= grid.n; i += length)
    for (int j = 0; j < grid.n; ++j) result.push_back(f(i, j));
  return result;
}

struct Patches {
  template <class Traits> static auto model(const Grid_of_points& grid, Random&) {
    return surfaces(grid, [&](int i, int j) { return GC::Bezier_patch<Traits>(net<Traits>(grid, i, j)); });
  }
};
struct Surfaces_without_inner_knots {
  template <class Traits, class FT = typename Traits::FT> static auto model(const Grid_of_points& grid, Random&) {
    return surfaces(grid, [&](int i, int j) {
      return GC::Bspline_surface<Traits>(net<Traits>(grid, i, j), unit_knots<FT>(), unit_knots<FT>());
    });
  }
};
// Strips of several patches, over triple knots.
struct Surfaces_with_inner_knots {
  template <class Traits, class FT = typename Traits::FT> static auto model(const Grid_of_points& grid, Random&) {
    const int length = 2;
    const auto strip = [&](int i, int j) {
      return GC::Bspline_surface<Traits>(
          net_of(3 * length + 1, 4, [&](int k, int l) { return point<Traits>(grid.p[3 * i + k][3 * j + l]); }),
          GC::Knot_vector<FT>(3, FT(0), FT(length), {{FT(1), 3}}), unit_knots<FT>());
    };
    return surfaces(grid, strip, length);
  }
};
// All weights of a patch are equal, but not those of two of them.
struct Rational_patches_with_equal_weights {
  template <class Traits, class FT = typename Traits::FT>
  static auto model(const Grid_of_points& grid, Random& random) {
    return surfaces(grid, [&](int i, int j) {
      const FT weight(random.integer(1, 9));
      return GC::Rational_bezier_patch<Traits>(net<Traits>(grid, i, j), net_of(4, 4, [&](int, int) { return weight; }));
    });
  }
};
// Weights that are symmetric in each patch, times a number for each patch; a few differ from those
// of their neighbours.
struct Rational_surfaces {
  template <class Traits, class FT = typename Traits::FT>
  static auto model(const Grid_of_points& grid, Random& random) {
    return surfaces(grid, [&](int i, int j) {
      const int factor = random.integer(1, 9), inner = random.integer(0, 9) == 0 ? 3 : 2;
      const auto weight = [&](int k, int l) { return FT(factor * (k % 3 == 0 ? 1 : inner) * (l % 3 == 0 ? 1 : 3)); };
      return GC::Rational_bspline_surface<Traits>(net<Traits>(grid, i, j), net_of(4, 4, weight), unit_knots<FT>(),
                                                  unit_knots<FT>());
    });
  }
};
typedef boost::mpl::list<Patches, Surfaces_without_inner_knots, Surfaces_with_inner_knots,
                         Rational_patches_with_equal_weights, Rational_surfaces>
    Classes;

void print(std::ostream& os, const GC::Edge_continuity<Q>& e) {
  os << e << ' ' << e.coplanar << e.side << e.collapsed << e.normal_vanishes;
  if (e.vanishing) os << " vanishing in " << e.vanishing->first << ' ' << e.vanishing->second;
  if (e.deviation)
    os << " deviation " << e.deviation->lower << ' ' << e.deviation->upper << " in " << e.deviation->begin << ' '
       << e.deviation->end;
}
void print(std::ostream& os, const GC::Spline_edge_continuity<Q>& e) {
  print(os, static_cast<const GC::Edge_continuity<Q>&>(e));
  os << " worst " << e.worst << ", " << e.part_a.first << ' ' << e.part_a.second << ' ' << e.part_b.first << ' '
     << e.part_b.second << ' ' << e.whole_a << e.whole_b;
  for (const GC::Edge_span<Q>& span : e.spans) {
    os << "; " << span.begin << ' ' << span.end << ' ';
    print(os, span.continuity);
  }
}

// All that has been decided, in lines.
std::vector<std::string> lines(const GC::Model_continuity<Q>& model) {
  std::vector<std::string> result;
  const auto add = [&](const auto& row, const GC::Spline_edge_continuity<Q>& e) {
    std::ostringstream os;
    os << row << " | ";
    print(os, e);
    result.push_back(os.str());
  };
  for (const auto& edge : model.edges) add(edge, edge.continuity);
  for (const auto& line : model.knot_lines) add(line, line.line.continuity);
  result.push_back(text(model.summary));
  return result;
}

void check_equal(const std::vector<std::string>& x, const std::vector<std::string>& y, unsigned seed) {
  BOOST_REQUIRE_EQUAL(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    BOOST_CHECK_MESSAGE(x[i] == y[i], "seed " << seed << "\n" << x[i] << "\n" << y[i]);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(decimals_and_doubles, Class, Classes) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    const Grid_of_points grid(6, random);
    Random weights(seed), same_weights(seed);
    const auto decimals = Class::template model<Exact_3>(grid, weights);
    const auto doubles = Class::template model<Epick_3>(grid, same_weights);
    const GC::Model_continuity<Q> expected = GC::model_continuity(decimals);
    BOOST_CHECK(expected.summary.g2 > 0 && expected.summary.creases > 0 && expected.summary.collapsed > 0);
    const std::vector<std::string> text = lines(expected);
    check_equal(text, lines(GC::model_continuity(doubles)), seed);
    std::size_t last = 0, wrong = 0;
    check_equal(text,
                lines(GC::model_continuity<CGAL::Parallel_if_available_tag>(
                    doubles, [&](std::size_t n) { wrong += n != ++last; })),
                seed);
    BOOST_CHECK_EQUAL(wrong, 0);
    const GC::Model_summary& s = expected.summary;
    BOOST_CHECK_EQUAL(last, s.g2 + s.g1 + s.g0 + s.knot_lines_g2 + s.knot_lines_g1 + s.knot_lines_g0);
    check_equal(text, lines(GC::model_continuity<CGAL::Parallel_if_available_tag>(decimals)), seed);
  }
}

// One spline over simple knots, cut into surfaces with the same knots, some of them turned, over
// other domains, with other speeds across their edges, or lifted: in fixed length all spans of an
// edge are decided at once, or none.
BOOST_AUTO_TEST_CASE(splines_over_simple_knots) {
  typedef GC::Bspline_surface<Exact_3> Surface;
  typedef GC::Knot_vector<Q> Knots;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    Random random(seed);
    const int parts = 4, spans = 3;
    const auto knots = [](int first, int last) {
      std::vector<Q> u(4, Q(first));
      for (int k = first + 1; k < last; ++k) u.emplace_back(k);
      u.insert(u.end(), 4, Q(last));
      return Knots(3, u);
    };
    const Knots all = knots(0, parts * spans);
    const int m = all.number_of_coefficients();
    Surface whole(net_of(m, m,
                         [&](int i, int j) {
                           const int x = 100 * i + random.integer(0, 30), y = 100 * j + random.integer(0, 30);
                           return Exact_3::Point(1296 * x, 1296 * y, 1296 * random.integer(0, 50));
                         }),
                  all, all);
    for (int k = 1; k < parts; ++k) whole = whole.insert_u(Q(spans * k), 2).insert_v(Q(spans * k), 2);
    std::vector<Surface> exact;
    std::vector<GC::Bspline_surface<Epick_3>> doubles;
    const int step = spans + 2; // six control points in each direction
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const int kind = (i + 2 * j) % 5;
        const auto part = net_of(step + 1, step + 1, [&](int k, int l) {
          const Exact_3::Point x = whole.control_point(step * i + k, step * j + l);
          const bool inside = 0 < l && l < step, lifted = inside && 0 < k && k < step && kind == 4,
                     only_g1 = inside && k == 2 && kind == 3;
          return lifted || only_g1 ? Exact_3::Point(x.x(), x.y(), Q(x.z() + 36)) : x;
        });
        const int factor = kind == 2 ? 2 : 1;
        const auto own_knots = [&](int a) {
          std::vector<Q> u;
          for (const Q& x : knots(spans * a, spans * a + spans)) u.push_back(Q(x * factor));
          return Knots(3, u);
        };
        Surface s(part, own_knots(i), own_knots(j));
        if (kind == 1) s = s.reverse_u();
        if (kind == 2) s = s.swap_parameters().reverse_v();
        exact.push_back(s);
        doubles.push_back(surface_exactly<Epick_3>(s));
      }
    const GC::Model_continuity<Q> expected = GC::model_continuity(exact);
    BOOST_TEST_MESSAGE(expected.summary);
    BOOST_CHECK(expected.summary.g2 > 5 && expected.summary.g1 > 0 && expected.summary.creases > 5);
    check_equal(lines(expected), lines(GC::model_continuity(doubles)), seed);
    check_equal(lines(expected), lines(GC::model_continuity<CGAL::Parallel_if_available_tag>(doubles)), seed);
  }
}

// Edges with the same control points are the same if their weights are, up to a factor.
BOOST_AUTO_TEST_CASE(weights_of_edges) {
  typedef GC::Rational_bezier_patch<Epick_3> Patch;
  const auto patch = [](int side, std::vector<double> weights) {
    return Patch(net_of(3, 2, [&](int i, int j) { return Epick_3::Point(i, j * side, j == 0 ? i * i : i); }),
                 net_of(3, 2, [&](int i, int j) { return j == 0 ? weights[i] : 1; }));
  };
  const auto shared = [&](const std::vector<double>& a, const std::vector<double>& b, bool turned) {
    const Patch p = patch(1, a), q = patch(-1, b);
    const auto model = GC::model_continuity(std::vector<Patch>{p, turned ? q.reverse_u() : q});
    return model.summary.g0 + model.summary.g1 + model.summary.g2;
  };
  for (bool turned : {false, true}) {
    BOOST_CHECK_EQUAL(shared({1, 2, 4}, {3, 6, 12}, turned), 1);
    BOOST_CHECK_EQUAL(shared({1, 2, 4}, {1, 2, 5}, turned), 0);
    BOOST_CHECK_EQUAL(shared({1, 2, 1}, {1, 1, 1}, turned), 0);
    BOOST_CHECK_EQUAL(shared({1, 1, 1}, {7, 7, 7}, turned), 1);
    BOOST_CHECK_EQUAL(shared({1, 0, 1}, {3, 0, 3}, turned), 1); // nothing but keys decides
  }
}

// The first edge that is refused is named, whatever was done first.
BOOST_AUTO_TEST_CASE(errors_on_several_cores) {
  Random random(2026);
  const Grid_of_points grid(8, random);
  const auto model = Patches::model<Exact_3>(grid, random);
  const auto message = [&](auto tag) {
    return error_of([&] { limited(GC::Work_limit(1), [&] { return GC::model_continuity<decltype(tag)>(model); }); });
  };
  const std::string expected = message(CGAL::Sequential_tag());
  BOOST_CHECK(contains(expected, "work_limit"));
  for (int i = 0; i < 20; ++i) BOOST_CHECK_EQUAL(message(CGAL::Parallel_if_available_tag()), expected);
}

BOOST_AUTO_TEST_SUITE_END()
