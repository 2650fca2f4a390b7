// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

BOOST_AUTO_TEST_SUITE(cubic_curves)

typedef GC::Basis_matrix<FT> Matrix;
typedef GC::Bernstein_polynomial<FT> Polynomial;

// In rounded kernels coordinates, parameters and entries of matrices are multiples of 1/8 of
// modulus at most 2, or come from the given bases, with entries of modulus at most 6. A value or
// derivative up to the third has at most 200 roundings, of numbers of modulus at most 4 * 2 * 6 *
// (8 + 4 + 2 + 1) * 6; that of a changed basis has entries up to 6 times as large.
inline bool nearly_equal(const FT& x, const FT& y) { return close(x, y, FT(30000), 200); }
template <class Column_type> bool nearly_equal_columns(const Column_type& x, const Column_type& y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), nearly_equal);
}
template <class Jet_type> bool nearly_equal_jets(const Jet_type& x, const Jet_type& y) {
  for (int j = 0; j <= x.order(); ++j)
    if (!nearly_equal_columns(x[j], y[j])) return false;
  return x.order() == y.order();
}

inline Matrix matrix(const std::array<std::array<int, 4>, 4>& rows) { return GC::Basis_matrix<int>(rows).over<FT>(); }
inline const Matrix& identity() {
  static const Matrix one = matrix({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}});
  return one;
}
inline Matrix random_matrix(Random& random) {
  Matrix::Rows rows;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) rows[i][j] = random.whole();
  return Matrix(rows);
}

// f(basis) for each basis whose matrix can be inverted
template <class Function> void for_each_basis(Random& random, Function f) {
  f(GC::Hermite_basis());
  f(GC::Bezier_basis());
  f(GC::Catmull_rom_basis());
  f(GC::Cardinal_basis<FT>{exact ? random.positive_rational() + FT(1) : ratio(1, 2)});
  f(GC::Uniform_bspline_basis());
  f(GC::Matrix_basis<FT>{GC::bezier_matrix<FT>() *
                         matrix({{{1, 1, 0, 0}, {0, 1, 0, 0}, {0, 2, 1, 0}, {0, 0, -1, -1}}})});
}

template <class Traits> std::array<Column<Traits>, 4> columns(const std::array<Point<Traits>, 4>& g) {
  return {column<Traits>(g[0]), column<Traits>(g[1]), column<Traits>(g[2]), column<Traits>(g[3])};
}
template <class Traits> std::array<Column<Traits>, 4> columns(const GC::Hermite_geometry<Traits>& g) {
  return {column<Traits>(g.p1), column<Traits>(g.p4), column<Traits>(g.r1), column<Traits>(g.r4)};
}

template <class Traits> void set_geometry(std::array<Point<Traits>, 4>& g, const std::vector<Point<Traits>>& p) {
  std::copy_n(p.begin(), 4, g.begin());
}
template <class Traits> void set_geometry(GC::Hermite_geometry<Traits>& g, const std::vector<Point<Traits>>& p) {
  g = {p[0], p[1], vector<Traits>(column<Traits>(p[2])), vector<Traits>(column<Traits>(p[3]))};
}
template <class Traits, class Basis>
GC::Cubic_blended_curve<Traits, Basis> blended(const std::vector<Point<Traits>>& p, const Basis& basis) {
  typename Basis::template Geometry<Traits> geometry;
  set_geometry<Traits>(geometry, p);
  return GC::Cubic_blended_curve<Traits, Basis>(geometry, basis);
}

template <class Traits> std::vector<Point<Traits>> points(int d, std::initializer_list<Row> rows) {
  std::vector<Point<Traits>> p;
  for (const Row& row : rows) p.push_back(point<Traits>(d, row));
  return p;
}

// ---------------------------------------------------------------- matrices and blending functions

// The matrix of the slides is derived when compiling.
constexpr GC::Basis_matrix<int> constraints({{{0, 1, 0, 3}, {0, 1, 0, 2}, {0, 1, 1, 1}, {1, 1, 0, 0}}});
static_assert(constraints.inverse() ==
              GC::Basis_matrix<int>({{{2, -3, 0, 1}, {-2, 3, 0, 0}, {1, -2, 1, 0}, {1, -1, 0, 0}}}));

BOOST_AUTO_TEST_CASE(the_matrices_of_the_bases) {
  const Matrix hermite = matrix({{{2, -3, 0, 1}, {-2, 3, 0, 0}, {1, -2, 1, 0}, {1, -1, 0, 0}}});
  const Matrix bezier = matrix({{{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}});
  BOOST_CHECK(GC::hermite_matrix<FT>() == hermite);
  BOOST_CHECK(GC::hermite_constraint_matrix<FT>().inverse() == hermite);
  BOOST_CHECK(hermite * GC::hermite_constraint_matrix<FT>() == identity());
  BOOST_CHECK(GC::bezier_matrix<FT>() == bezier);
  BOOST_CHECK(GC::hermite_from_bezier_matrix<FT>() * hermite == bezier);
  BOOST_CHECK(GC::change_of_basis(bezier, hermite) == GC::hermite_from_bezier_matrix<FT>());
  BOOST_CHECK(FT(2) * GC::catmull_rom_matrix<FT>() ==
              matrix({{{-1, 2, -1, 0}, {3, -5, 0, 2}, {-3, 4, 1, 0}, {1, -1, 0, 0}}}));
  BOOST_CHECK(GC::cardinal_matrix<FT>(FT(0)) == GC::catmull_rom_matrix<FT>());
  BOOST_CHECK(GC::bspline_matrix<FT>()(1, 1) == FT(-1));
  if constexpr (exact)
    BOOST_CHECK(FT(6) * GC::bspline_matrix<FT>() ==
                matrix({{{-1, 3, -3, 1}, {3, -6, 0, 4}, {-3, 3, 3, 1}, {1, 0, 0, 0}}}));
  if constexpr (Is_streamable<FT>::value)
    BOOST_CHECK_EQUAL(text(identity()), text(FT(1), ' ', FT(0), ' ', FT(0), ' ', FT(0), '\n', FT(0), ' ', FT(1), ' ',
                                             FT(0), ' ', FT(0), '\n', FT(0), ' ', FT(0), ' ', FT(1), ' ', FT(0), '\n',
                                             FT(0), ' ', FT(0), ' ', FT(0), ' ', FT(1), '\n'));
}

// x is a quotient of whole numbers with this denominator, or one of the two doubles next to it.
template <class T> bool is_rounded_quotient(const T& x, const T& denominator) {
  if constexpr (std::is_floating_point_v<T>) {
    const T quotient = std::round(x * denominator) / denominator;
    return std::nextafter(quotient, -1e300) <= x && x <= std::nextafter(quotient, 1e300);
  } else
    return true;
}

template <class T> void check_rounded_inverse() {
  if constexpr (std::is_floating_point_v<T>) {
    const auto diagonal = [](T x, T y) {
      return GC::Basis_matrix<T>({{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}});
    };
    for (const T& bad : {std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()})
      CHECK_ERROR(diagonal(bad, 1).inverse(), not_finite);
    const T tiny = std::numeric_limits<T>::denorm_min(), small = std::ldexp(T(1), -600);
    // the inverse overflows
    CHECK_ERROR(diagonal(tiny, 1).inverse(), not_finite);
    // the determinant rounds to 0
    BOOST_CHECK(diagonal(small, small).inverse()(0, 0) == std::ldexp(T(1), 600));
  }
}

BOOST_AUTO_TEST_CASE(inverse_of_a_matrix) {
  repeat([](Random& random) {
    const Matrix a = random_matrix(random), b = random_matrix(random);
    if (a.determinant() == FT(0)) { // small whole numbers: exact, and possible in rounded kernels
      CHECK_ERROR(a.inverse(), singular_frame);
      CHECK_ERROR(GC::change_of_basis(b, a), singular_frame);
      return;
    }
    const Matrix inverse = a.inverse(), change = GC::change_of_basis(b, a);
    if constexpr (exact) {
      BOOST_CHECK(a * inverse == identity());
      BOOST_CHECK(inverse * a == identity());
      BOOST_CHECK(change * a == b);
      BOOST_CHECK(a.determinant() * inverse.determinant() == FT(1));
      BOOST_CHECK((a * b).determinant() == a.determinant() * b.determinant());
    }
    for (int i = 0; i < 4; ++i) // the determinant of a whole matrix is whole
      for (int j = 0; j < 4; ++j) {
        BOOST_CHECK(is_rounded_quotient(inverse(i, j), a.determinant()));
        BOOST_CHECK(is_rounded_quotient(change(i, j), a.determinant()));
      }
  });
  const Matrix zero = matrix({}), twice = matrix({{{1, 2, 3, 4}, {0, 1, 0, 1}, {2, 4, 6, 8}, {1, 0, 0, 0}}});
  for (const Matrix& singular : {zero, twice, GC::cardinal_matrix<FT>(FT(1))}) {
    CHECK_ERROR(singular.inverse(), singular_frame);
    CHECK_ERROR(GC::change_of_basis(identity(), singular), singular_frame);
  }

  // one row is all but twice another
  const FT o(0), e(1);
  const Matrix near({{{e, e, o, o}, {FT(2), FT(FT(2) * next_to(e)), o, o}, {o, o, e, o}, {o, o, o, e}}});
  const Matrix inverse = near.inverse();
  BOOST_CHECK(inverse(0, 1) * FT(2) == -inverse(1, 1) * FT(2));
  BOOST_CHECK(inverse(1, 0) * FT(FT(1) - next_to(e)) == FT(1));
  check_rounded_inverse<FT>();
}

BOOST_AUTO_TEST_CASE(blending_functions) {
  repeat([](Random& random) {
    for (const Matrix& m : {GC::hermite_matrix<FT>(), GC::bezier_matrix<FT>(), GC::catmull_rom_matrix<FT>(),
                            GC::bspline_matrix<FT>(), GC::cardinal_matrix<FT>(random.whole()), random_matrix(random)}) {
      const std::vector<Polynomial> f = GC::blending_functions(m);
      BOOST_REQUIRE_EQUAL(f.size(), 4u);
      const FT t = random.number();
      for (int i = 0; i < 4; ++i)
        BOOST_CHECK(nearly_equal(f[i](t), FT(((m(i, 0) * t + m(i, 1)) * t + m(i, 2)) * t + m(i, 3))));
    }
  });
  const std::vector<Polynomial> hermite = GC::blending_functions(GC::hermite_matrix<FT>()),
                                bezier = GC::blending_functions(GC::bezier_matrix<FT>()),
                                catmull_rom = GC::blending_functions(GC::catmull_rom_matrix<FT>()),
                                bspline = GC::blending_functions<FT>(GC::Uniform_bspline_basis());
  BOOST_CHECK(bezier == GC::bernstein_polynomials<FT>(3));
  BOOST_CHECK(hermite == GC::blending_functions<FT>(GC::Hermite_basis()));
  BOOST_CHECK(!GC::is_partition_of_unity(hermite)); // only the functions of its two points are one
  BOOST_CHECK(GC::is_partition_of_unity(std::vector<Polynomial>{hermite[0], hermite[1]}));
  BOOST_CHECK(GC::is_partition_of_unity(bezier) && GC::has_convex_hull_property(bezier));
  // signs lost
  const Matrix scanned = matrix({{{1, 3, -3, 1}, {3, -6, 3, 0}, {3, 3, 0, 0}, {1, 0, 0, 0}}});
  BOOST_CHECK(!GC::is_partition_of_unity(GC::blending_functions(scanned)));
  BOOST_CHECK(GC::is_partition_of_unity(catmull_rom) && !GC::has_convex_hull_property(catmull_rom));
  BOOST_CHECK(!GC::is_nonnegative(catmull_rom[0]) && GC::is_nonnegative(catmull_rom[1]));
  // a double is not 1/6, and its sum is not 1
  BOOST_CHECK_EQUAL(GC::is_partition_of_unity(bspline), exact);
  BOOST_CHECK_EQUAL(GC::has_convex_hull_property(bspline), exact);
  for (const Polynomial& f : bspline) BOOST_CHECK(GC::is_nonnegative(f));
}

BOOST_AUTO_TEST_CASE(bernstein_polynomials) {
  for (int n = 0; n <= 7; ++n) {
    std::vector<Polynomial> b = GC::bernstein_polynomials<FT>(n);
    BOOST_REQUIRE_EQUAL(static_cast<int>(b.size()), n + 1);
    BOOST_CHECK(GC::is_partition_of_unity(b) && GC::has_convex_hull_property(b));
    for (int k = 0; k <= 4; ++k) { // multiples of 1/4: no rounding
      const FT t = ratio(k, 4);
      const std::vector<FT> values = GC::bernstein_basis(n, t);
      for (int i = 0; i <= n; ++i) BOOST_CHECK(b[i](t) == values[i]);
    }
    b[n / 2] = Polynomial{next_to(FT(1))};
    BOOST_CHECK(!GC::is_partition_of_unity(b));
  }
  BOOST_CHECK(!GC::is_partition_of_unity(std::vector<Polynomial>()));
  BOOST_CHECK(
      // 2 - 2t, -1 + 2t
      GC::is_partition_of_unity(std::vector<Polynomial>{{FT(2), FT(0)}, {FT(-1), FT(0), FT(1)}}));
  const FT o(0), e(1);
  BOOST_CHECK(GC::is_nonnegative(Polynomial{o}) && GC::is_nonnegative(Polynomial{e}));
  BOOST_CHECK(!GC::is_nonnegative(Polynomial{FT(-1)}) && !GC::is_nonnegative(Polynomial{o, FT(-1), o}));
  BOOST_CHECK(GC::is_nonnegative(Polynomial{o, e, o}));
  BOOST_CHECK(GC::is_nonnegative(Polynomial{e, FT(-1), e}));           // (2t-1)^2
  BOOST_CHECK(!GC::is_nonnegative(Polynomial{e, FT(-next_to(e)), e})); // and a little lower
}

// ---------------------------------------------------------------- one curve

TEST_WITH_RANDOM_INPUT(values_and_jets) {
  for_each_basis(random, [&](const auto& basis) {
    typedef std::decay_t<decltype(basis)> Basis;
    const auto q = blended<Traits>(random_points<Traits>(random, d, 4), basis);
    const std::array<Column<Traits>, 4> g = columns<Traits>(q.geometry());
    const Matrix m = basis.template matrix<FT>();
    BOOST_CHECK(q.domain() == std::make_pair(FT(0), FT(1)));
    BOOST_CHECK_EQUAL(q.dimension(), d);
    const FT t = random.number();
    const Jet<Traits> x = q.jet(t, 5);
    // t^3, t^2, t, 1 and its derivatives
    const FT powers[4][4] = {{FT(t * t * t), FT(t * t), t, FT(1)},
                             {FT(FT(3) * t * t), FT(FT(2) * t), FT(1), FT(0)},
                             {FT(FT(6) * t), FT(2), FT(0), FT(0)},
                             {FT(6), FT(0), FT(0), FT(0)}};
    for (int j = 0; j < 4; ++j) {
      Column<Traits> sum(d);
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) sum += FT(m(i, k) * powers[j][k]) * g[i];
      BOOST_CHECK(nearly_equal_columns(x[j], sum));
    }
    BOOST_CHECK(is_zero(x[4]) && is_zero(x[5]));
    BOOST_CHECK(column<Traits>(q(t)) == x[0]);
    BOOST_CHECK(q.template start_jet_over<FT>(3) == q.jet(FT(0), 3));
    BOOST_CHECK(q.template end_jet_over<FT>(3) == q.jet(FT(1), 3));

    const GC::Bezier_curve<Traits, 3> c = q.bezier(), slow = q.bezier(FT(1), FT(3));
    BOOST_CHECK(nearly_equal_jets(c.jet(t, 5), x));
    BOOST_CHECK(same_points<Traits>(slow, c) && slow.domain() == std::make_pair(FT(1), FT(3)));
    const GC::Cubic_blended_curve<Traits, Basis> back(slow, basis);
    for (int i = 0; i < 4; ++i) BOOST_CHECK(nearly_equal_columns(columns<Traits>(back.geometry())[i], g[i]));
  });
}

TEST_WITH_INPUTS(change_of_basis, 1) {
  const FT t = random.number();
  for_each_basis(random, [&](const auto& from) {
    const auto q = blended<Traits>(random_points<Traits>(random, d, 4), from);
    const auto there_and_back = [&](const auto& to) {
      const auto r = q.in_basis(to);
      const auto back = r.in_basis(from);
      BOOST_CHECK(nearly_equal_jets(r.jet(t, 3), q.jet(t, 3)));
      for (int i = 0; i < 4; ++i)
        BOOST_CHECK(nearly_equal_columns(columns<Traits>(back.geometry())[i], columns<Traits>(q.geometry())[i]));
    };
    there_and_back(GC::Hermite_basis());
    there_and_back(GC::Catmull_rom_basis());
    there_and_back(GC::Uniform_bspline_basis());
    CHECK_ERROR(q.in_basis(GC::Cardinal_basis<FT>{FT(1)}), singular_frame);
    CHECK_ERROR(q.in_basis(GC::Matrix_basis<FT>{matrix({})}), singular_frame);
  });
}

// End points, end derivatives and neighbours are where they should be.
TEST_WITH_RANDOM_INPUT(what_the_geometry_means) {
  const std::vector<Point<Traits>> p = random_points<Traits>(random, d, 5);
  const std::vector<Column<Traits>> c{column<Traits>(p[0]), column<Traits>(p[1]), column<Traits>(p[2]),
                                      column<Traits>(p[3]), column<Traits>(p[4])};
  const auto check = [](const Column<Traits>& x, const Column<Traits>& y) { BOOST_CHECK(nearly_equal_columns(x, y)); };
  const FT tension = random.number(), s = (FT(1) - tension) / FT(2);
  const auto cardinal = blended<Traits>(p, GC::Cardinal_basis<FT>{tension});
  check(cardinal.jet(FT(0), 1)[0], c[1]);
  check(cardinal.jet(FT(1), 1)[0], c[2]);
  check(cardinal.jet(FT(0), 1)[1], s * (c[2] - c[0]));
  check(cardinal.jet(FT(1), 1)[1], s * (c[3] - c[1]));
  const GC::Cubic_blended_curve<Traits, GC::Bezier_basis> bezier({p[0], p[1], p[2], p[3]});
  BOOST_CHECK(same_points<Traits>(bezier.bezier(), bezier.geometry()));

  for (int m = 0; m <= 3; ++m) { // lower degrees are elevated
    const Curve<Traits> low = random_curve<Traits>(random, d, m);
    const GC::Cubic_blended_curve<Traits, GC::Uniform_bspline_basis> q(low);
    BOOST_CHECK(nearly_equal_columns(column<Traits>(q(ratio(1, 2))),
                                     column<Traits>(low(FT((low.domain().first + low.domain().second) / FT(2))))));
  }
  typedef GC::Cubic_blended_curve<Traits, GC::Hermite_basis> Hermite;
  CHECK_ERROR(Hermite(random_curve<Traits>(random, d, 4)), wrong_number_of_points);
}

TEST_IN_EVERY_SPACE(degenerate_geometry) {
  typedef GC::Cubic_blended_curve<Traits, GC::Hermite_basis> Hermite;
  const Point<Traits> p = point<Traits>(d, {1, 2}), q = point<Traits>(d, {3, 2});
  const Vector<Traits> zero = vector<Traits>(d, {});
  const Hermite rest({p, q, zero, zero}); // a segment, from rest to rest: p + (3t^2 - 2t^3) (q - p)
  BOOST_CHECK((rest.jet(ratio(1, 2), 2) == jet<Traits>(d, {{2, 2}, {3}, {0}})));
  BOOST_CHECK((rest.jet(FT(0), 2) == jet<Traits>(d, {{1, 2}, {0}, {12}})));
  const Hermite still({p, p, zero, zero});
  BOOST_CHECK((still.jet(ratio(1, 2), 3) == jet<Traits>(d, {{1, 2}, {0}, {0}, {0}})));
  const auto catmull_rom = blended<Traits>({p, p, p, p}, GC::Catmull_rom_basis());
  BOOST_CHECK((catmull_rom.jet(ratio(1, 4), 2) == jet<Traits>(d, {{1, 2}, {0}, {0}})));
  if constexpr (Hermite::N == 0) {
    CHECK_ERROR(Hermite({p, q, zero, vector<Traits>(d + 1, {1})}), dimension_mismatch);
    CHECK_ERROR(blended<Traits>({p, point<Traits>(d + 1, {}), q, q}, GC::Bezier_basis()), dimension_mismatch);
  }
  if constexpr (std::is_floating_point_v<typename Traits::FT>)
    for (const FT& bad : {std::numeric_limits<FT>::infinity(), std::numeric_limits<FT>::quiet_NaN()}) {
      Column<Traits> c(d);
      c[d - 1] = bad;
      CHECK_ERROR(Hermite({p, q, zero, vector<Traits>(c)}), not_finite);
      CHECK_ERROR(blended<Traits>({point<Traits>(c), p, q, q}, GC::Catmull_rom_basis()), not_finite);
    }
}

// ---------------------------------------------------------------- many points

inline GC::Closure closure(bool closed) { return closed ? GC::Closure::closed : GC::Closure::open; }

// The least orders C and G of all joins. No points are constructed, so that exact predicates are
// exact also where constructions are rounded.
template <class Traits, class Basis>
std::pair<int, int> orders(const std::vector<Point<Traits>>& p, const Basis& basis, bool closed) {
  const int n = static_cast<int>(p.size());
  std::vector<GC::Cubic_blended_curve<Traits, Basis>> chain;
  for (int i = 0; i < (closed ? n : n - 3); ++i)
    chain.push_back(blended<Traits>({p[i], p[(i + 1) % n], p[(i + 2) % n], p[(i + 3) % n]}, basis));
  const GC::Chain_summary s = GC::chain_continuity(chain, 3, closure(closed));
  return {s.c_order().value(), s.g_order().value()};
}

// Returns the orders of the constructed curve, in exact kernels.
template <class C> std::pair<int, int> orders(const C& curve) {
  const GC::Chain_summary s = GC::chain_continuity(curve).summary;
  return {s.c_order().value(), s.g_order().value()};
}

TEST_WITH_RANDOM_INPUT(piecewise_curves) {
  typedef std::pair<int, int> Orders;
  for (bool closed : {false, true}) {
    const int n = random.integer(closed ? 3 : 5, 6);
    const std::vector<Point<Traits>> p = random_points<Traits>(random, d, n);
    const GC::Cardinal_basis<FT> tight{ratio(1, 4)};
    // in a closed triangle or quadrilateral the second derivative jumps by a multiple of the first:
    // G2
    const Orders cardinal(1, closed && n <= 4 ? 2 : 1);
    if constexpr (exact_predicates && cancels) {
      BOOST_CHECK((orders<Traits>(p, GC::Catmull_rom_basis(), closed) == cardinal));
      BOOST_CHECK((orders<Traits>(p, tight, closed) == cardinal));
      BOOST_CHECK((orders<Traits>(p, GC::Uniform_bspline_basis(), closed) == Orders(2, 2)));
    }
    const auto through = GC::piecewise_cubic<Traits>(p.begin(), p.end(), GC::Catmull_rom_basis(), closure(closed)),
               tighter = GC::piecewise_cubic<Traits>(p.begin(), p.end(), tight, closure(closed)),
               near = GC::piecewise_cubic<Traits>(p.begin(), p.end(), GC::Uniform_bspline_basis(), closure(closed));
    for (const auto& curve : {through, tighter, near}) {
      BOOST_CHECK_EQUAL(curve.number_of_segments(), closed ? n : n - 3);
      BOOST_CHECK_EQUAL(curve.is_closed(), closed);
      for (int i = 0; i <= curve.number_of_segments(); ++i) BOOST_CHECK(curve.knots()[i] == FT(i));
    }
    for (int i = 0; i <= through.number_of_segments(); ++i) {
      const Column<Traits> at = column<Traits>(p[(i + 1) % n]);
      BOOST_CHECK(column<Traits>(through(FT(i))) == at && column<Traits>(tighter(FT(i))) == at);
    }
    std::vector<Vector<Traits>> r;
    for (const Point<Traits>& x : random_points<Traits>(random, d, n)) r.push_back(vector<Traits>(column<Traits>(x)));
    const auto hermite = GC::piecewise_hermite<Traits>(p.begin(), p.end(), r.begin(), r.end(), closure(closed));
    BOOST_CHECK_EQUAL(hermite.number_of_segments(), closed ? n : n - 1);
    BOOST_CHECK_EQUAL(hermite.is_closed(), closed);
    for (int i = 0; i <= hermite.number_of_segments(); ++i) {
      const Column<Traits> derivative = column<Traits>(r[i % n]);
      BOOST_CHECK(column<Traits>(hermite(FT(i))) == column<Traits>(p[i % n]));
      BOOST_CHECK(
          nearly_equal_columns(hermite.left_jet(FT(i), 1)[1], i == 0 ? hermite.right_jet(FT(i), 1)[1] : derivative));
      BOOST_CHECK(nearly_equal_columns(hermite.right_jet(FT(i), 1)[1], derivative));
    }
    if constexpr (exact && cancels) {
      BOOST_CHECK(orders(through) == cardinal);
      BOOST_CHECK(orders(tighter) == cardinal);
      BOOST_CHECK(orders(near) == Orders(2, 2));
      BOOST_CHECK(orders(hermite) == Orders(1, 1));
    }
  }
}

// Points that coincide are no error, and the analysis says what it does to the curve. Zero
// derivatives and whole coordinates: no rounding decides here.
TEST_IN_EVERY_SPACE(piecewise_degenerate) {
  typedef std::pair<int, int> Orders;
  const GC::Catmull_rom_basis catmull_rom;
  const GC::Uniform_bspline_basis bspline;
  if constexpr (exact_predicates) {
    // zero derivative at (1,2), (3,1)
    const auto there_and_back = points<Traits>(d, {{0}, {1, 2}, {0}, {3, 1}});
    BOOST_CHECK((orders<Traits>(there_and_back, catmull_rom, true) == Orders(1, 0)));
    const auto doubled = points<Traits>(d, {{0}, {1, 2}, {1, 2}, {4, 1}, {3, 5}});
    BOOST_CHECK((orders<Traits>(doubled, catmull_rom, true) == Orders(1, 1)));
    const auto one_place = points<Traits>(d, {{3, 1}, {3, 1}, {3, 1}, {3, 1}});
    BOOST_CHECK((orders<Traits>(one_place, catmull_rom, true) == Orders(3, 0)));
    BOOST_CHECK((orders<Traits>(one_place, bspline, true) == Orders(3, 0)));
    // a corner at (1,2)
    const auto tripled = points<Traits>(d, {{0}, {1, 2}, {1, 2}, {1, 2}, {4, 1}, {5}});
    BOOST_CHECK((orders<Traits>(tripled, bspline, false) == Orders(2, 0)));
    const auto collinear = points<Traits>(d, {{0}, {1, 1}, {3, 3}, {4, 4}, {9, 9}});
    // a line, whatever its speed
    BOOST_CHECK(orders<Traits>(collinear, catmull_rom, false).second == 3);
  }
  const auto line = points<Traits>(d, {{0}, {6}, {12}, {18}, {24}});
  const auto steady = GC::piecewise_cubic<Traits>(line.begin(), line.end(), catmull_rom);
  BOOST_CHECK(same_points<Traits>(steady, points<Traits>(d, {{6}, {8}, {10}, {12}, {14}, {16}, {18}})) || !exact);
  BOOST_CHECK(nearly_equal_columns(column<Traits>(steady(ratio(1, 2))), column<Traits>(d, {9})));

  const std::vector<Vector<Traits>> r{vector<Traits>(d, {0, 3}), vector<Traits>(d, {}), vector<Traits>(d, {3})};
  const auto rest =
      GC::piecewise_hermite<Traits>(line.begin(), line.begin() + 3, r.begin(), r.end(), GC::Closure::closed);
  const auto joins = GC::chain_continuity(rest).joins;
  BOOST_REQUIRE_EQUAL(joins.size(), 3u);
  if constexpr (exact || exact_predicates) {           // divisions by 3 are exact here
    BOOST_CHECK_EQUAL(joins[0].continuity.c_order, 1); // the zero derivative
    BOOST_CHECK_EQUAL(joins[0].continuity.g_order, 0);
    BOOST_CHECK(!joins[0].continuity.regular);
    BOOST_CHECK_EQUAL(joins[1].continuity.c_order, 1);
    BOOST_CHECK(joins[1].continuity.g_order >= 1 && joins[1].continuity.regular);
  }

  for (int n = 0; n <= 3; ++n) {
    if (n < 3)
      CHECK_ERROR(GC::piecewise_cubic<Traits>(line.begin(), line.begin() + n, bspline, GC::Closure::closed),
                  wrong_number_of_points);
    CHECK_ERROR(GC::piecewise_cubic<Traits>(line.begin(), line.begin() + n, catmull_rom), wrong_number_of_points);
    if (n < 2)
      for (bool closed : {false, true})
        CHECK_ERROR(
            GC::piecewise_hermite<Traits>(line.begin(), line.begin() + n, r.begin(), r.begin() + n, closure(closed)),
            wrong_number_of_points);
    else if (n != 3)
      CHECK_ERROR(GC::piecewise_hermite<Traits>(line.begin(), line.begin() + n, r.begin(), r.end()),
                  wrong_number_of_points);
  }
  CHECK_ERROR(GC::piecewise_cubic<Traits>(line.begin(), line.end(), GC::Bezier_basis()), curves_do_not_meet);
}

// ---------------------------------------------------------------- properties of Bezier curves

// Returns whether p is in a triangle of the points, for points in the plane: Caratheodory's
// theorem.
template <class Traits> bool in_some_triangle(const std::vector<Column<Traits>>& q, const Column<Traits>& p) {
  const auto turn = [](const Column<Traits>& a, const Column<Traits>& b, const Column<Traits>& c) {
    const FT x = (b[0] - a[0]) * (c[1] - a[1]), y = (b[1] - a[1]) * (c[0] - a[0]);
    return y < x ? 1 : x < y ? -1 : 0;
  };
  const auto between = [](const FT& x, const FT& y, const FT& z) { return !(y < x && y < z) && !(x < y && z < y); };
  for (const Column<Traits>& a : q)
    for (const Column<Traits>& b : q) {
      if (turn(a, b, p) == 0 && between(a[0], p[0], b[0]) && between(a[1], p[1], b[1])) return true;
      for (const Column<Traits>& c : q)
        if (turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0) return true;
    }
  return false;
}

BOOST_AUTO_TEST_CASE(convex_hull) {
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    for (int m = 0; m <= 6; ++m) {
      const Curve<Traits> c = random_curve<Traits>(random, d, m);
      const FT u = c.domain().first + ratio(random.integer(0, 4), 4) * (c.domain().second - c.domain().first);
      // no rounding up to degree 3
      if (exact || m <= 3) BOOST_CHECK(GC::is_in_convex_hull(c, c(u)));
      for (int j = 0; j <= m; ++j) BOOST_CHECK(GC::is_in_convex_hull(c, c.control_point(j)));

      // the weights prove what they say
      const auto weights = GC::convex_hull_weights(c, c.control_point(m / 2));
      BOOST_REQUIRE(weights && static_cast<int>(weights->size()) == m + 1);
      typedef typename std::decay_t<decltype(*weights)>::value_type Field;
      int positive = 0;
      Field one(0);
      for (const Field& w : *weights) {
        BOOST_CHECK(!(w < Field(0)));
        positive += Field(0) < w;
        one += w;
      }
      BOOST_CHECK(one == Field(1) && positive <= d + 1);
      for (int i = 0; i < d; ++i) {
        Field x(0);
        for (int j = 0; j <= m; ++j) x += (*weights)[j] * in_field<Field>(c.coordinates(j)[i]);
        BOOST_CHECK(x == in_field<Field>(c.coordinates(m / 2)[i]));
      }

      // beyond a coordinate, even by the least amount
      Column<Traits> outside = column<Traits>(c.bounding_box().second);
      outside[d - 1] = next_to(outside[d - 1]);
      BOOST_CHECK(!GC::is_in_convex_hull(c, point<Traits>(outside)));
    }
    // few places, so that many points coincide or are collinear; in space on a plane
    std::vector<Point<Traits>> p;
    std::vector<Column<Traits>> q;
    const auto lattice_point = [&] {
      const int x = random.integer(0, 3), y = random.integer(0, 3);
      return column<Traits>(d, {x, y, x - 2 * y, x + y, 1 - x});
    };
    for (int j = random.integer(1, 6); j > 0; --j) {
      q.push_back(lattice_point());
      p.push_back(point<Traits>(q.back()));
    }
    const Curve<Traits> flat(p.begin(), p.end());
    for (int j = 0; j < 8; ++j) {
      Column<Traits> x = lattice_point();
      BOOST_CHECK_EQUAL(GC::is_in_convex_hull(flat, point<Traits>(x)), in_some_triangle<Traits>(q, x));
      x[d - 1] = d > 2 ? next_to(x[d - 1]) : FT(4);
      BOOST_CHECK(!GC::is_in_convex_hull(flat, point<Traits>(x)));
    }
  });
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    const Curve<Traits> triangle = curve<Traits>(d, {{0, 0}, {4, 0}, {0, 4}});
    BOOST_CHECK(GC::is_in_convex_hull(triangle, point<Traits>(d, {2, 2}))); // on an edge
    Column<Traits> x = column<Traits>(d, {2, 2});
    x[0] = next_to(x[0]);
    BOOST_CHECK(!GC::is_in_convex_hull(triangle, point<Traits>(x)));
    // t = 2
    BOOST_CHECK(!GC::is_in_convex_hull(curve<Traits>(d, {{0, 0}, {1, 0}, {2, 0}}), point<Traits>(d, {4, 0})));
    if constexpr (Curve<Traits>::N == 0)
      CHECK_ERROR(GC::is_in_convex_hull(triangle, point<Traits>(d + 1, {1})), dimension_mismatch);
    if constexpr (std::is_floating_point_v<typename Traits::FT>) {
      x[0] = std::numeric_limits<FT>::quiet_NaN();
      CHECK_ERROR(GC::is_in_convex_hull(triangle, point<Traits>(x)), not_finite);
    }
  });
}

TEST_IN_EVERY_SPACE(end_tangents) {
  const auto is = [&](const std::optional<Vector<Traits>>& v, Row x) {
    return v && column<Traits>(*v) == column<Traits>(d, x);
  };
  const Curve<Traits> c = curve<Traits>(d, {{0, 0}, {1, 2}, {4, 2}, {5, 0}}, 0, 3);
  BOOST_CHECK(is(GC::start_tangent(c), {1, 2}) && is(GC::end_tangent(c), {1, -2}));
  const Curve<Traits> doubled = curve<Traits>(d, {{1, 1}, {1, 1}, {4, 2}, {1, 1}, {1, 1}, {1, 1}});
  BOOST_CHECK(is(GC::start_tangent(doubled), {3, 1}) && is(GC::end_tangent(doubled), {-3, -1}));
  // the direction is that of the first derivative that does not vanish
  BOOST_CHECK(is_zero(doubled.start_jet(2)[1]) && doubled.start_jet(2)[2] == FT(20) * column<Traits>(d, {3, 1}));
  BOOST_CHECK((!GC::start_tangent(curve<Traits>(d, {{1, 1}})) && !GC::end_tangent(curve<Traits>(d, {{1, 1}}))));
  BOOST_CHECK(!GC::start_tangent(curve<Traits>(d, {{1, 1}, {1, 1}, {1, 1}})));
  BOOST_CHECK(!GC::end_tangent(curve<Traits>(d, {{1, 1}, {1, 1}, {1, 1}})));
}

BOOST_AUTO_TEST_CASE(crossings) {
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    const Point<Traits> origin = point<Traits>(d, {7});
    const Vector<Traits> up = vector<Traits>(d, {0, 1});
    // a curve with these distances from the x-axis
    const auto count = [&](std::initializer_list<int> heights) {
      std::vector<Point<Traits>> p;
      for (int y : heights) p.push_back(point<Traits>(d, {static_cast<int>(p.size()), y, y}));
      return GC::count_crossings(Curve<Traits>(p.begin(), p.end()), origin, up);
    };
    const auto is = [](const std::optional<GC::Crossings>& c, int polygon, int curve, int contacts) {
      return c && c->polygon == polygon && c->curve == curve && c->contacts == contacts && c->diminished();
    };
    BOOST_CHECK(is(count({1}), 0, 0, 0));
    BOOST_CHECK(is(count({-1, 1}), 1, 1, 1));
    BOOST_CHECK(is(count({1, 2, 3}), 0, 0, 0));
    BOOST_CHECK(is(count({1, -1, 1}), 2, 0, 2));     // touches: (2t-1)^2
    BOOST_CHECK(is(count({2, -1, 2}), 2, 0, 0));     // stays above
    BOOST_CHECK(is(count({1, -2, 1}), 2, 2, 2));     // dips below
    BOOST_CHECK(is(count({-1, 1, -1, 1}), 3, 1, 3)); // (2t-1)^3
    BOOST_CHECK(is(count({-1, 6, -6, 1}), 3, 3, 3));
    BOOST_CHECK(is(count({1, 0, 0, 1}), 0, 0, 0)); // points on the axis do not count
    BOOST_CHECK(is(count({1, 0, 0, -1}), 1, 1, 1));
    BOOST_CHECK(is(count({0, -1, 1, 0}), 1, 1, 1)); // the ends on the axis do not count
    BOOST_CHECK(is(count({0, 0, 1}), 0, 0, 0));
    BOOST_CHECK(!count({0}) && !count({0, 0, 0})); // in the axis
    CHECK_ERROR(GC::count_crossings(curve<Traits>(d, {{0}, {1}}), origin, vector<Traits>(d, {})), zero_direction);
    if constexpr (Curve<Traits>::N == 0) {
      CHECK_ERROR(GC::count_crossings(curve<Traits>(d, {{0}, {1}}), origin, vector<Traits>(d + 1, {1})),
                  dimension_mismatch);
      CHECK_ERROR(GC::count_crossings(curve<Traits>(d, {{0}, {1}}), point<Traits>(d - 1, {1}), up), dimension_mismatch);
    }
  });
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    const int m = random.integer(1, cancels ? 6 : 3);
    const Curve<Traits> c = random_curve<Traits>(random, d, m);
    const std::vector<Point<Traits>> p = random_points<Traits>(random, d, 2, &Random::whole);
    const Column<Traits> normal = column<Traits>(p[1]);
    if (is_zero(normal)) return;
    const std::optional<GC::Crossings> count = GC::count_crossings(c, p[0], vector<Traits>(normal));
    if (!count) return;
    BOOST_CHECK(count->diminished());
    BOOST_CHECK_EQUAL((count->contacts - count->curve) % 2, 0);
    const FT first = dot(column<Traits>(c.control_point(0)) - column<Traits>(p[0]), normal),
             last = dot(column<Traits>(c.control_point(m)) - column<Traits>(p[0]), normal);
    if (first == FT(0) || last == FT(0)) return;
    BOOST_CHECK_EQUAL(count->curve % 2 == 1, (first < FT(0)) != (last < FT(0)));
    BOOST_CHECK_EQUAL((count->polygon - count->contacts) % 2, 0); // Descartes
  });
}

// A control point repeated j times more pulls the curve: its weight grows.
TEST_IN_EVERY_SPACE(pulled_curves) {
  const Curve<Traits> c = curve<Traits>(d, {{0, 0}, {2, 4}, {4, 0}}, 0, 2);
  FT last(0);
  for (int times = 0; times <= 6; ++times) {
    const Curve<Traits> pulled = GC::repeat_control_point(c, 1, times);
    BOOST_CHECK_EQUAL(pulled.degree(), 2 + times);
    BOOST_CHECK(pulled.domain() == c.domain());
    for (int j = 0; j <= 2 + times; ++j)
      BOOST_CHECK(column<Traits>(pulled.control_point(j)) == c.coordinates(j == 0 ? 0 : j == 2 + times ? 2 : 1));
    const FT height = column<Traits>(pulled(FT(1)))[1]; // 4 times the weight 1 - 2/2^m
    BOOST_CHECK(height == FT(4) * (FT(1) - ratio(2, 4 << times)) && last < height);
    last = height;
  }
  BOOST_CHECK(column<Traits>(GC::repeat_control_point(c, 0).control_point(1)) == c.coordinates(0));
  BOOST_CHECK(column<Traits>(GC::repeat_control_point(c, 2).control_point(2)) == c.coordinates(2));
  for (int i : {-1, 3}) CHECK_ERROR(GC::repeat_control_point(c, i), wrong_number_of_points);
  CHECK_ERROR(GC::repeat_control_point(c, 1, -1), negative_count);
}

TEST_IN_EVERY_SPACE(closed_curves) {
  typedef GC::Closing Closing;
  const auto closing = [d](std::initializer_list<Row> rows) { return GC::closing(curve<Traits>(d, rows)); };
  BOOST_CHECK(closing({{0, 0}, {1, 2}, {3, 0}}) == Closing::open);
  BOOST_CHECK(closing({{0, 0}, {2, 0}, {1, 1}, {-1, 0}, {0, 0}}) == Closing::smooth);
  // collinear, and not smooth
  BOOST_CHECK(closing({{0, 0}, {2, 0}, {1, 1}, {1, 0}, {0, 0}}) == Closing::cusp);
  BOOST_CHECK(closing({{0, 0}, {2, 0}, {1, 1}, {0, 0}}) == Closing::corner);
  BOOST_CHECK(closing({{0, 0}, {0, 0}, {1, 1}, {-1, 0}, {0, 0}}) == Closing::singular);
  BOOST_CHECK(closing({{0, 0}, {1, 1}, {0, 0}, {0, 0}}) == Closing::singular);
  BOOST_CHECK(closing({{1, 2}}) == Closing::singular);
  BOOST_CHECK(closing({{1, 2}, {1, 2}}) == Closing::singular);
  const auto c = curve<Traits>(d, {{0, 0}, {2, 0}, {1, 1}, {-1, 0}, {0, 0}});
  BOOST_CHECK_GE(GC::continuity(c, c).g_order, 1);
}

BOOST_AUTO_TEST_SUITE_END()
