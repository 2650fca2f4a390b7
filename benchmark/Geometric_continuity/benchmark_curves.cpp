// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Jets and curvature with torsion in double: one at a time and in batches, against instructions
// written by hand and against OpenCASCADE, SISL and Eigen where they were found. Results are
// compared before anything is timed.

#include "Ratio_table.h"
#include "by_hand.h"
#include "measure.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <GeomAdaptor_Curve.hxx>
#include <GeomLProp_CLProps.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <sisl.h>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
#include <unsupported/Eigen/Splines>
#endif

#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits, 5> Quintic;

namespace {

// ---------------------------------------------------------------- input

struct Input {
  std::vector<double> parameters;
  std::array<Point, 6> points;
  Quintic curve;
  GC::Jet_arrays<double, 3, 3> jets;

  static std::array<Point, 6> random_points(std::mt19937& random) {
    std::array<Point, 6> p;
    for (Point& x : p) x = random_point(random);
    return p;
  }
  static Point random_point(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    const double x = number(random), y = number(random), z = number(random);
    return Point(x, y, z);
  }
  explicit Input(std::mt19937 random) : points(random_points(random)), curve(points.begin(), points.end()) {
    for (std::size_t l = 0; l < n; ++l) parameters.push_back(l / double(n - 1));
    GC::evaluate(curve, parameters.data(), n, jets);
  }
};

const Input& input() {
  static const Input in{std::mt19937(2026)};
  return in;
}

// ---------------------------------------------------------------- peers

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
Handle(Geom_BezierCurve) occt_curve() {
  TColgp_Array1OfPnt poles(1, 6);
  for (int j = 0; j < 6; ++j)
    poles.SetValue(j + 1, gp_Pnt(input().points[j].x(), input().points[j].y(), input().points[j].z()));
  return new Geom_BezierCurve(poles);
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
SISLCurve* sisl_curve() {
  static double knots[] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  static double points[18];
  for (int j = 0; j < 18; ++j) points[j] = input().points[j / 3][j % 3];
  static SISLCurve* const curve = newCurve(6, 6, knots, points, 1, 3, 1);
  return curve;
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
typedef Eigen::Spline<double, 3, 5> Eigen_curve;
Eigen_curve eigen_curve() {
  Eigen_curve::KnotVectorType knots(12);
  knots << 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1;
  Eigen_curve::ControlPointVectorType points(3, 6);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 3; ++i) points(i, j) = input().points[j][i];
  return Eigen_curve(knots, points);
}
#endif

// ---------------------------------------------------------------- what is timed

void register_jets() {
  const Input& in = input();
  static const by_hand::Quintic hand(in.points, 0, 1);
  static const by_hand::Powers powers(hand);
  static const GC::Bezier_curve<Traits> dynamic(in.curve);
  static const GC::Jet_polynomials<double, 3, 5, 3> polynomials(in.curve);
  static GC::Jet_arrays<double, 3, 3> batch(n);
  const auto hand_batch = [&in] {
    powers.batch(in.parameters.data(), n, batch.array(0, 0), batch.array(0, 1) - batch.array(0, 0));
  };
  hand_batch();
  for (std::size_t l = 0; l < n; ++l) {
    const double u = in.parameters[l];
    const by_hand::Jet x = by_hand::jet(hand, u), prepared = powers(u);
    const GC::Curve_jet<Traits> jet = in.curve.jet(u, 3), dynamic_jet = dynamic.jet(u, 3);
    const GC::Coordinate_jet<double, 3> polynomial_jet = polynomials.jet(u);
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i < 3; ++i) {
        check(near(x.d[j][i], prepared.d[j][i]) && near(x.d[j][i], batch.array(j, i)[l]), "jet by hand");
        check(near(x.d[j][i], jet[j][i]) && near(x.d[j][i], dynamic_jet[j][i]), "jet");
        check(near(x.d[j][i], polynomial_jet[j][i]) && near(x.d[j][i], in.jets.array(j, i)[l]), "prepared jet");
      }
  }

  one_by_one("jets of order 3, degree 5 | by hand", [&in](std::size_t l) {
    const by_hand::Jet jet = by_hand::jet(hand, in.parameters[l]);
    benchmark::DoNotOptimize(jet);
  });
  one_by_one("jets of order 3, degree 5 | by hand, prepared powers", [&in](std::size_t l) {
    const by_hand::Jet jet = powers(in.parameters[l]);
    benchmark::DoNotOptimize(jet);
  });
  one_by_one("jets of order 3, degree 5 | Bezier_curve<Traits, 5>", [&in](std::size_t l) {
    const GC::Curve_jet<Traits> jet = in.curve.jet(in.parameters[l], 3);
    benchmark::DoNotOptimize(jet);
  });
  one_by_one("jets of order 3, degree 5 | Jet_polynomials, prepared", [&in](std::size_t l) {
    const GC::Coordinate_jet<double, 3> jet = polynomials.jet(in.parameters[l]);
    benchmark::DoNotOptimize(jet);
  });
  one_by_one("jets of order 3, degree 5 | Bezier_curve<Traits>", [&in](std::size_t l) {
    const GC::Curve_jet<Traits> jet = dynamic.jet(in.parameters[l], 3);
    benchmark::DoNotOptimize(jet);
  });
  at_once("jets of order 3, degree 5 | by hand, prepared powers, batch", n, hand_batch);
  at_once("jets of order 3, degree 5 | evaluate(), batch", n,
          [&in] { GC::evaluate(in.curve, in.parameters.data(), n, batch); });
}

void register_jets_of_peers() {
  [[maybe_unused]] const Input& in = input();
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static const Handle(Geom_BezierCurve) occt = occt_curve();
  static const GeomAdaptor_Curve adaptor(occt);
  for (std::size_t l = 0; l < n; ++l) {
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    adaptor.D3(in.parameters[l], p, d1, d2, d3);
    check(near(p.X(), in.jets.array(0, 0)[l]) && near(d1.Y(), in.jets.array(1, 1)[l]) &&
              near(d3.Z(), in.jets.array(3, 2)[l]),
          "jet of OpenCASCADE");
  }
  one_by_one("jets of order 3, degree 5 | OpenCASCADE, adaptor (prepared)", [&in](std::size_t l) {
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    adaptor.D3(in.parameters[l], p, d1, d2, d3);
    benchmark::DoNotOptimize(d3);
  });
  one_by_one("jets of order 3, degree 5 | OpenCASCADE, Geom_BezierCurve", [&in](std::size_t l) {
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    occt->D3(in.parameters[l], p, d1, d2, d3);
    benchmark::DoNotOptimize(d3);
  });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  static double out[12];
  const auto sisl = [&in](std::size_t l) {
    int left = 0, status = 0;
    s1221(sisl_curve(), 3, in.parameters[l], &left, out, &status);
    benchmark::DoNotOptimize(out);
  };
  for (std::size_t l = 0; l + 1 < n; ++l) {
    sisl(l);
    for (int i = 0; i < 12; ++i) check(near(out[i], in.jets.array(i / 3, i % 3)[l]), "jet of SISL");
  }
  one_by_one("jets of order 3, degree 5 | SISL", sisl);
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
  static const Eigen_curve eigen = eigen_curve();
  for (std::size_t l = 0; l < n; ++l) {
    const auto jet = eigen.derivatives<3>(in.parameters[l]);
    for (int i = 0; i < 12; ++i) check(near(jet(i % 3, i / 3), in.jets.array(i / 3, i % 3)[l]), "jet of Eigen");
  }
  one_by_one("jets of order 3, degree 5 | Eigen", [&in](std::size_t l) {
    const auto jet = eigen.derivatives<3>(in.parameters[l]);
    benchmark::DoNotOptimize(jet);
  });
#endif
}

void register_curvatures() {
  const Input& in = input();
  static std::vector<double> kappa(n), tau(n);
  const auto by_hand = [&in] {
    by_hand::curvature_and_torsion(in.jets.array(1, 0), in.jets.array(1, 1) - in.jets.array(1, 0), n, kappa.data(),
                                   tau.data());
  };
  by_hand();
  const std::vector<double> hand_kappa = kappa, hand_tau = tau;
  GC::curvature_and_torsion(in.jets, kappa.data(), tau.data());
  for (std::size_t l = 0; l < n; ++l)
    check(near(kappa[l], hand_kappa[l]) && near(tau[l], hand_tau[l]), "curvature and torsion");
  at_once("curvature and torsion of jets | by hand, batch", n, by_hand);
  at_once("curvature and torsion of jets | curvature_and_torsion(), batch", n,
          [&in] { GC::curvature_and_torsion(in.jets, kappa.data(), tau.data()); });
  static GC::Jet_arrays<double, 3, 3> jets;
  at_once("curvature and torsion of jets | evaluate() and curvature_and_torsion(), batch, with the jet", n, [&in] {
    GC::evaluate(in.curve, in.parameters.data(), n, jets);
    GC::curvature_and_torsion(jets, kappa.data(), tau.data());
  });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static GeomLProp_CLProps properties(occt_curve(), 3, 1e-12);
  for (std::size_t l = 0; l < n; ++l) {
    properties.SetParameter(in.parameters[l]);
    check(near(properties.Curvature(), hand_kappa[l]), "curvature of OpenCASCADE");
  }
  one_by_one("curvature and torsion of jets | OpenCASCADE, CLProps, curvature only, with the jet",
             [&in](std::size_t l) {
               properties.SetParameter(in.parameters[l]);
               benchmark::DoNotOptimize(properties.Curvature());
             });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  const auto sisl = [&in] { // SISL gives the radius' inverse and the torsion, both with the jet
    int status = 0;
    double* const parameters = const_cast<double*>(in.parameters.data());
    s2550(sisl_curve(), parameters, static_cast<int>(n), kappa.data(), &status);
    s2553(sisl_curve(), parameters, static_cast<int>(n), tau.data(), &status);
  };
  sisl();
  for (std::size_t l = 0; l + 1 < n; ++l)
    check(near(kappa[l], hand_kappa[l]) && near(tau[l], hand_tau[l]), "curvature and torsion of SISL");
  at_once("curvature and torsion of jets | SISL, s2550 and s2553, with the jet", n, sisl);
#endif
}

} // namespace

int main(int argc, char** argv) {
  register_jets();
  register_jets_of_peers();
  register_curvatures();
  return run_benchmarks(argc, argv);
}
