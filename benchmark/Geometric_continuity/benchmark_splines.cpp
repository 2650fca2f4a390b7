// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Products of a cubic spline function and a cubic curve in space, and cubic curves elevated to
// degree 6, with 0 to 64 simple inner knots: against instructions written by hand for just that,
// and against OpenCASCADE and SISL where they were found. Results are compared before anything is
// timed.

#include "Ratio_table.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <BSplCLib.hxx>
#include <BSplCLib_EvaluatorFunction.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <sisl.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Bspline_curve<Traits> Curve;
typedef GC::Bspline_function<double> Function;
typedef Traits::Point Point;

namespace {

bool near(double x, double y) { return std::abs(x - y) <= 1e-12; }

// ---------------------------------------------------------------- input

struct Input {
  int k; // inner knots
  // all knots, four times at the ends; the coefficients of the function
  std::vector<double> knots, f;
  std::vector<std::array<double, 3>> g; // the control points of the curve
  Function function;
  Curve curve;

  Input(int k, std::mt19937 random) : Input(k, knots_with(k, random), random) {}

  int coefficients_of_degree_6() const { return 7 + 4 * k; }

private:
  static std::vector<double> knots_with(int k, std::mt19937& random) {
    std::uniform_real_distribution<double> moved(-0.3, 0.3);
    std::vector<double> knots(4, 0.0);
    for (int i = 1; i <= k; ++i) knots.push_back((i + moved(random)) / (k + 1));
    knots.insert(knots.end(), 4, 1.0);
    return knots;
  }
  static std::vector<double> numbers(int n, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> x(n);
    for (double& xi : x) xi = number(random);
    return x;
  }
  static std::vector<std::array<double, 3>> triples(int n, std::mt19937& random) {
    std::vector<std::array<double, 3>> x(n);
    for (std::array<double, 3>& xi : x) {
      const std::vector<double> y = numbers(3, random);
      std::copy(y.begin(), y.end(), xi.begin());
    }
    return x;
  }
  static std::vector<Point> points(const std::vector<std::array<double, 3>>& x) {
    std::vector<Point> p;
    for (const std::array<double, 3>& xi : x) p.push_back(Point(xi[0], xi[1], xi[2]));
    return p;
  }
  static Curve curve_of(const std::vector<Point>& p, const std::vector<double>& u) {
    return Curve(p.begin(), p.end(), GC::Knot_vector<double>(3, u));
  }
  Input(int k, const std::vector<double>& u, std::mt19937& random)
      : k(k), knots(u), f(numbers(k + 4, random)), g(triples(k + 4, random)),
        function(GC::Knot_vector<double>(3, u), f), curve(curve_of(points(g), u)) {}
};

// ---------------------------------------------------------------- by hand

// The Bernstein coefficients of a cubic on one span after the other, for simple inner knots: w
// holds the values [u,u,u], [u,u,a], [u,a,b], [a,b,c] of the blossom at the start u of a span and
// the knots a, b, c that follow.
template <int Coordinates> struct Hand_spans {
  double w[4][Coordinates], b[4][Coordinates];

  void next(double u, const double* after, bool last) {
    for (int x = 0; x < Coordinates; ++x) {
      b[0][x] = w[0][x];
      b[1][x] = w[1][x];
    }
    if (last) {
      for (int x = 0; x < Coordinates; ++x) {
        b[2][x] = w[2][x];
        b[3][x] = w[3][x];
      }
      return;
    }
    const double s = (after[0] - u) / (after[1] - u), t = (after[0] - u) / (after[2] - u);
    for (int x = 0; x < Coordinates; ++x) {
      b[2][x] = (1 - s) * w[1][x] + s * w[2][x];
      w[1][x] = (1 - t) * w[2][x] + t * w[3][x];
      b[3][x] = w[0][x] = (1 - s) * b[2][x] + s * w[1][x];
      w[2][x] = w[3][x];
    }
  }
};

// The four coefficients in degree 6 of a span between simple knots: the first one straddles the
// knot u after the knot t.
template <class Coefficient> void hand_coefficients(double t, double u, double a, Coefficient c, double (*out)[3]) {
  const double q = (t - u) / (a - u);
  for (int x = 0; x < 3; ++x) {
    const double c2 = c(2, x);
    out[0][x] = (1 - q) * c(1, x) + q * c2;
    out[1][x] = c2;
    out[2][x] = c(3, x);
    out[3][x] = c(4, x);
  }
}

template <int Coordinates, class Start, class Next, class Coefficient>
void hand_degree_6(const std::vector<double>& knots, int k, Start start, Next next, Coefficient coefficient,
                   double (*out)[3]) {
  Hand_spans<Coordinates> spans;
  for (int i = 0; i < 4; ++i) start(i, spans.w[i]);
  const auto c = [&](int i, int x) { return coefficient(spans.b, i, x); };
  const double* u = knots.data() + 3;
  for (int s = 0; s <= k; ++s) {
    spans.next(u[s], u + s + 1, s == k);
    if (s < k) next(s + 4, spans.w[3]);
    if (s == 0)
      for (int i = 0; i < 5; ++i)
        for (int x = 0; x < 3; ++x) out[i][x] = c(i, x);
    else
      hand_coefficients(u[s - 1], u[s], u[s + 1], c, out + 4 * s + 1);
  }
  for (int i = 5; i < 7; ++i)
    for (int x = 0; x < 3; ++x) out[4 * k + i][x] = c(i, x);
}

void hand_product(const Input& in, double (*out)[3]) {
  const auto take = [&in](int i, double* w) {
    for (int x = 0; x < 3; ++x) w[x] = in.g[i][x];
    w[3] = in.f[i];
  };
  hand_degree_6<4>(
      in.knots, in.k, take, take,
      [](const double(*b)[4], int i, int x) {
        static constexpr int binomial[4] = {1, 3, 3, 1}, binomial_6[7] = {1, 6, 15, 20, 15, 6, 1};
        double sum = 0;
        for (int j = std::max(0, i - 3); j <= std::min(3, i); ++j)
          sum += (binomial[j] * binomial[i - j] / double(binomial_6[i]) * b[j][3]) * b[i - j][x];
        return sum;
      },
      out);
}

void hand_elevation(const Input& in, double (*out)[3]) {
  const auto take = [&in](int i, double* w) {
    for (int x = 0; x < 3; ++x) w[x] = in.g[i][x];
  };
  hand_degree_6<3>(
      in.knots, in.k, take, take,
      [](const double(*b)[3], int i, int x) {
        static constexpr int binomial[4] = {1, 3, 3, 1}, binomial_6[7] = {1, 6, 15, 20, 15, 6, 1};
        double sum = 0;
        for (int j = std::max(0, i - 3); j <= std::min(3, i); ++j)
          sum += binomial[i - j] * binomial[j] / double(binomial_6[i]) * b[j][x];
        return sum;
      },
      out);
}

// ---------------------------------------------------------------- peers

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
class Occt_factor : public BSplCLib_EvaluatorFunction {
  const TColStd_Array1OfReal& knots_;
  std::vector<double> f_;

public:
  Occt_factor(const TColStd_Array1OfReal& knots, const std::vector<double>& f) : knots_(knots), f_(f) {}
  void Evaluate(const Standard_Integer order, const Standard_Real*, const Standard_Real t, Standard_Real& result,
                Standard_Integer& error) const override {
    Standard_Integer extrapolation[2] = {3, 3};
    BSplCLib::Eval(t, Standard_False, order, extrapolation[0], 3, knots_, 1, const_cast<double&>(f_[0]), result);
    error = 0;
  }
};

// Everything but the coefficients of the result is prepared.
struct Occt {
  TColStd_Array1OfReal flat, knots, flat_6;
  TColStd_Array1OfInteger multiplicities;
  TColgp_Array1OfPnt poles, product;
  TColStd_Array1OfReal numbers, elevated, knots_6;
  TColStd_Array1OfInteger multiplicities_6;
  Occt_factor factor;
  Handle(Geom_BSplineCurve) curve;

  explicit Occt(const Input& in)
      : flat(1, in.k + 8), knots(1, in.k + 2), flat_6(1, 14 + 4 * in.k), multiplicities(1, in.k + 2),
        poles(1, in.k + 4), product(1, in.coefficients_of_degree_6()), numbers(1, 3 * (in.k + 4)),
        elevated(1, 3 * in.coefficients_of_degree_6()), knots_6(1, in.k + 2), multiplicities_6(1, in.k + 2),
        factor(flat, in.f) {
    for (int i = 0; i < in.k + 8; ++i) flat(i + 1) = in.knots[i];
    for (int i = 0; i < in.k + 2; ++i) {
      const bool end = i == 0 || i == in.k + 1;
      knots(i + 1) = in.knots[3 + i];
      multiplicities(i + 1) = end ? 4 : 1;
      multiplicities_6(i + 1) = end ? 7 : 4;
    }
    for (int i = 0, at = 1; i < in.k + 2; ++i)
      for (int j = multiplicities_6(i + 1); j > 0; --j) flat_6(at++) = knots(i + 1);
    for (int i = 0; i < in.k + 4; ++i) {
      poles(i + 1) = gp_Pnt(in.g[i][0], in.g[i][1], in.g[i][2]);
      for (int x = 0; x < 3; ++x) numbers(3 * i + x + 1) = in.g[i][x];
    }
    curve = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
  }
  void multiply() {
    Standard_Integer status = 0;
    BSplCLib::FunctionMultiply(factor, 3, flat, poles, flat_6, 6, product, status);
  }
  void elevate() {
    BSplCLib::IncreaseDegree(3, 6, Standard_False, 3, numbers, knots, multiplicities, elevated, knots_6,
                             multiplicities_6);
  }
  Handle(Geom_BSplineCurve) elevated_curve() const {
    Handle(Geom_BSplineCurve) copy = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    copy->IncreaseDegree(6);
    return copy;
  }
};
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
SISLCurve* sisl_curve(const Input& in) {
  std::vector<double> points;
  for (const std::array<double, 3>& x : in.g) points.insert(points.end(), x.begin(), x.end());
  return newCurve(in.k + 4, 4, const_cast<double*>(in.knots.data()), points.data(), 1, 3, 1);
}
SISLCurve* sisl_elevated(SISLCurve* curve) {
  SISLCurve* result = nullptr;
  int status = 0;
  s1750(curve, 7, &result, &status);
  return result;
}
#endif

// ---------------------------------------------------------------- what is timed

template <class Work> void timed(const std::string& name, Work work) {
  benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) mutable {
    for (auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
  });
}

typedef std::vector<std::array<double, 3>> Triples;
double (*raw(Triples& x))[3] { return reinterpret_cast<double(*)[3]>(x.data()); }

void check_same(const Curve& curve, const Triples& by_hand, const std::string& what) {
  check(curve.degree() == 6 && curve.control_points().size() == by_hand.size(), what);
  for (std::size_t i = 0; i < by_hand.size(); ++i)
    for (int x = 0; x < 3; ++x) check(near(curve.control_points()[i][x], by_hand[i][x]), what);
}

void register_products(const Input& in) {
  const std::string work = "product of a function and a curve, cubic, " + std::to_string(in.k) + " inner knots | ";
  const auto result = std::make_shared<Triples>(in.coefficients_of_degree_6());
  hand_product(in, raw(*result));
  const Curve curve = product(in.function, in.curve);
  check_same(curve, *result, work);
  for (int i = 0; i <= 1000; ++i)
    for (int x = 0; x < 3; ++x)
      check(near(curve(i / 1000.0)[x], in.function(i / 1000.0) * in.curve(i / 1000.0)[x]), work);
  timed(work + "by hand", [&in, result] { hand_product(in, raw(*result)); });
  timed(work + "product()", [&in] { benchmark::DoNotOptimize(product(in.function, in.curve)); });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  const auto occt = std::make_shared<Occt>(in);
  occt->multiply();
  for (std::size_t i = 0; i < result->size(); ++i)
    for (int x = 0; x < 3; ++x)
      check(near(occt->product(static_cast<int>(i) + 1).Coord(x + 1), (*result)[i][x]), work + "OpenCASCADE");
  timed(work + "OpenCASCADE, FunctionMultiply, knots prepared", [occt] { occt->multiply(); });
#endif
}

void register_elevations(const Input& in) {
  const std::string work = "curve elevated from degree 3 to 6, " + std::to_string(in.k) + " inner knots | ";
  const auto result = std::make_shared<Triples>(in.coefficients_of_degree_6());
  hand_elevation(in, raw(*result));
  const Curve curve = in.curve.elevate(3);
  check_same(curve, *result, work);
  for (int i = 0; i <= 1000; ++i)
    for (int x = 0; x < 3; ++x) check(near(curve(i / 1000.0)[x], in.curve(i / 1000.0)[x]), work);
  timed(work + "by hand", [&in, result] { hand_elevation(in, raw(*result)); });
  timed(work + "elevate()", [&in] { benchmark::DoNotOptimize(in.curve.elevate(3)); });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  const auto occt = std::make_shared<Occt>(in);
  occt->elevate();
  const Handle(Geom_BSplineCurve) elevated = occt->elevated_curve();
  for (std::size_t i = 0; i < result->size(); ++i)
    for (int x = 0; x < 3; ++x) {
      const int at = static_cast<int>(i);
      check(near(occt->elevated(3 * at + x + 1), (*result)[i][x]), work + "OpenCASCADE");
      check(near(elevated->Pole(at + 1).Coord(x + 1), (*result)[i][x]), work + "OpenCASCADE");
    }
  timed(work + "OpenCASCADE, IncreaseDegree, memory prepared", [occt] { occt->elevate(); });
  timed(work + "OpenCASCADE, Geom_BSplineCurve", [occt] { benchmark::DoNotOptimize(occt->elevated_curve()); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  SISLCurve* const sisl = sisl_curve(in);
  SISLCurve* const raised = sisl_elevated(sisl);
  check(raised && raised->in == in.coefficients_of_degree_6(), work + "SISL");
  for (std::size_t i = 0; i < result->size(); ++i)
    for (int x = 0; x < 3; ++x) check(near(raised->ecoef[3 * i + x], (*result)[i][x]), work + "SISL");
  freeCurve(raised);
  timed(work + "SISL", [sisl] { freeCurve(sisl_elevated(sisl)); });
#endif
}

} // namespace

int main(int argc, char** argv) {
  static std::vector<Input> inputs;
  for (int k : {0, 4, 16, 64}) inputs.emplace_back(k, std::mt19937(2026));
  for (const Input& in : inputs) register_products(in);
  for (const Input& in : inputs) register_elevations(in);
  return run_benchmarks(argc, argv);
}
