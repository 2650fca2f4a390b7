// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact blends: on rational numbers, against the same formulas with the operators of the number
// type and against integers by hand; and as one lazy construction, against a lazy number for each
// operation. All results are compared before anything is timed.

#include "Ratio_table.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Exact;
typedef CGAL::Exact_predicates_exact_constructions_kernel Lazy_kernel;
typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Exact_traits;
typedef GC::Traits_3<CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>> Cpp_traits;
typedef GC::Traits_3<Lazy_kernel> Lazy_traits;
template <class Traits> using Jets = std::vector<GC::Curve_jet<Traits>>;
template <class Traits> using FT_of = typename Traits::FT;

// ---------------------------------------------------------------- input

const std::size_t number_of_jets = 64;
enum Numbers { integers, doubles, decimals, fractions };
const char* const names_of_numbers[] = {"10-bit integers", "53-bit doubles", "decimals p/1000",
                                        "fractions p/q of 10 bits"};

template <class FT> FT number(Numbers kind, std::mt19937_64& engine) {
  const int p = static_cast<int>(engine() % 2001) - 1000, q = static_cast<int>(engine() % 1000) + 1;
  switch (kind) {
  case integers: return FT(p);
  case doubles: return FT(std::ldexp(static_cast<double>(static_cast<long>(engine() >> 11)) - 0x1p52, -50));
  case decimals: return FT(FT(p) / FT(1000));
  default: return FT(FT(p) / FT(q));
  }
}

template <class Traits> Jets<Traits> jets(Numbers kind) {
  std::mt19937_64 engine(2026);
  Jets<Traits> result;
  for (std::size_t n = 0; n < number_of_jets; ++n) {
    GC::Curve_jet<Traits> x(3, 3);
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i < 3; ++i) x[j][i] = number<FT_of<Traits>>(kind, engine);
    if constexpr (std::is_same_v<Traits, Lazy_traits>)
      for (int j = 0; j <= 3; ++j)
        for (int i = 0; i < 3; ++i) x[j][i].exact(); // known from the start
    result.push_back(x);
  }
  return result;
}

// ---------------------------------------------------------------- methods

template <class Traits, class Strategy>
auto by_blend(const GC::Curve_jet<Traits>& phi, const GC::Curve_jet<Traits>& psi, const Strategy& strategy) {
  return GC::blend(phi, psi, strategy, {});
}

// A strategy that keeps to the number type of the traits class: the formulas with its operators.
template <class Strategy> struct In_one_field : Strategy { typedef CGAL::Tag_false Works_in_every_field; };

template <class Traits, class Strategy>
auto by_operators(const GC::Curve_jet<Traits>& phi, const GC::Curve_jet<Traits>& psi, const Strategy&) {
  return GC::blend(phi, psi, In_one_field<Strategy>(), {});
}

#ifdef CGAL_USE_GMPXX
// Integers by hand, for Minimal_second_derivative: one denominator D for each end, and with the
// integers x, x', x'' of the jet, G = x'.x' and H = x'.x'' the points B = (5 x ± x') / (5 D), C =
// (20 G x ± (8 G ∓ H) x' + G x'') / (20 G D).
class By_hand {
  mpz_class x_[3][3], d_, g_, h_, t_;

  void end(const GC::Curve_jet<Exact_traits>& jet, int sign, std::array<GC::Coordinates<Exact_traits>, 6>& b,
           int place_of_b, int place_of_c) {
    d_ = 1;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        if (!mpz_divisible_p(d_.get_mpz_t(), jet[j][i].get_den_mpz_t()))
          mpz_lcm(d_.get_mpz_t(), d_.get_mpz_t(), jet[j][i].get_den_mpz_t());
    g_ = h_ = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        mpz_divexact(x_[j][i].get_mpz_t(), d_.get_mpz_t(), jet[j][i].get_den_mpz_t());
        x_[j][i] *= jet[j][i].get_num();
      }
      mpz_addmul(g_.get_mpz_t(), x_[1][i].get_mpz_t(), x_[1][i].get_mpz_t());
      mpz_addmul(h_.get_mpz_t(), x_[1][i].get_mpz_t(), x_[2][i].get_mpz_t());
    }
    t_ = 8 * sign * g_;
    h_ = t_ - h_; // the factor of x'
    t_ = 20 * g_;
    for (int i = 0; i < 3; ++i) {
      mpq_class& second = b[place_of_b][i];
      second.get_num() = 5 * x_[0][i];
      if (sign > 0)
        second.get_num() += x_[1][i];
      else
        second.get_num() -= x_[1][i];
      second.get_den() = 5 * d_;
      second.canonicalize();
      mpq_class& third = b[place_of_c][i];
      mpz_mul(third.get_num_mpz_t(), t_.get_mpz_t(), x_[0][i].get_mpz_t());
      mpz_addmul(third.get_num_mpz_t(), h_.get_mpz_t(), x_[1][i].get_mpz_t());
      mpz_addmul(third.get_num_mpz_t(), g_.get_mpz_t(), x_[2][i].get_mpz_t());
      mpz_mul(third.get_den_mpz_t(), t_.get_mpz_t(), d_.get_mpz_t());
      third.canonicalize();
    }
  }

public:
  GC::Quintic_blend<Exact_traits> operator()(const GC::Curve_jet<Exact_traits>& phi,
                                             const GC::Curve_jet<Exact_traits>& psi) {
    std::array<GC::Coordinates<Exact_traits>, 6> b;
    b[0] = phi[0];
    b[5] = psi[0];
    end(phi, 1, b, 1, 2);
    end(psi, -1, b, 4, 3);
    return {b, {Exact(0), Exact(0), false, false}, GC::Shape_parameters<Exact>()};
  }
};
#endif

template <class Blend> void evaluate_exactly(const Blend& gamma) {
  for (int j = 0; j <= gamma.degree(); ++j)
    for (int i = 0; i < 3; ++i) gamma.control_point(j).cartesian(i).exact();
}

// ---------------------------------------------------------------- answers, then times

template <class Blend> void compare(const Blend& one, const Blend& other) {
  for (int j = 0; j <= one.degree(); ++j)
    if (one.control_point(j) != other.control_point(j)) {
      std::cerr << "the results differ\n";
      std::exit(1);
    }
}

template <class Traits, class Function> void add(const std::string& title, const Jets<Traits>& x, Function function) {
  benchmark::RegisterBenchmark(title.c_str(), [=](benchmark::State& state) mutable {
    std::size_t n = 0;
    for (auto _ : state) {
      function(x[n % x.size()], x[(n + 1) % x.size()]);
      ++n;
    }
  });
}

template <class Traits, class Strategy>
void add_methods(const std::string& work, const std::string& type, const Jets<Traits>& x, const Strategy& strategy) {
  typedef GC::Curve_jet<Traits> Jet;
  for (std::size_t n = 0; n < x.size(); ++n)
    compare(by_blend(x[n], x[(n + 1) % x.size()], strategy), by_operators(x[n], x[(n + 1) % x.size()], strategy));
  const auto blend = [=](const Jet& phi, const Jet& psi) { return by_blend(phi, psi, strategy); };
  const auto operators = [=](const Jet& phi, const Jet& psi) { return by_operators(phi, psi, strategy); };
  if constexpr (std::is_same_v<Traits, Lazy_traits>) {
    add(work + "blend(), EPECK, constructed", x, blend);
    add(work + "operators, EPECK, constructed", x, operators);
    add(work + "blend(), EPECK, evaluated exactly", x,
        [=](const Jet& phi, const Jet& psi) { evaluate_exactly(blend(phi, psi)); });
    add(work + "operators, EPECK, evaluated exactly", x,
        [=](const Jet& phi, const Jet& psi) { evaluate_exactly(operators(phi, psi)); });
  } else {
    add(work + "blend(), " + type, x,
        [=](const Jet& phi, const Jet& psi) { benchmark::DoNotOptimize(blend(phi, psi)); });
    add(work + "operators, " + type, x,
        [=](const Jet& phi, const Jet& psi) { benchmark::DoNotOptimize(operators(phi, psi)); });
  }
}

template <class Strategy> void add_strategy(const std::string& name, const Strategy& strategy) {
  for (const Numbers kind : {integers, doubles, decimals, fractions}) {
    const std::string work = name + ", " + names_of_numbers[kind] + " | ";
#ifdef CGAL_USE_GMPXX
    if constexpr (std::is_same_v<Strategy, GC::Minimal_second_derivative>) {
      const Jets<Exact_traits> x = jets<Exact_traits>(kind);
      By_hand hand;
      for (std::size_t n = 0; n + 1 < x.size(); ++n) compare(hand(x[n], x[n + 1]), by_blend(x[n], x[n + 1], strategy));
      add(work + "mpz by hand", x,
          [hand](const auto& phi, const auto& psi) mutable { benchmark::DoNotOptimize(hand(phi, psi)); });
    }
#endif
    add_methods(work, "Exact_rational", jets<Exact_traits>(kind), strategy);
    add_methods(work, "cpp_rational", jets<Cpp_traits>(kind), strategy);
    add_methods(work, "EPECK", jets<Lazy_traits>(kind), strategy);
  }
}

// Measures the time to get the jets of curves.
void add_curves() {
  typedef GC::Bezier_curve<Exact_traits, 5> Curve;
  std::mt19937_64 engine(5);
  std::vector<Curve> curves;
  for (std::size_t n = 0; n < number_of_jets; ++n) {
    std::vector<Exact_traits::Point> p;
    for (int j = 0; j <= 5; ++j) {
      const Exact x = number<Exact>(doubles, engine), y = number<Exact>(doubles, engine),
                  z = number<Exact>(doubles, engine);
      p.emplace_back(x, y, z);
    }
    curves.emplace_back(p.begin(), p.end());
  }
  const std::string work = "two curves of degree 5, Minimal_energy<3>, 53-bit doubles | ";
  benchmark::RegisterBenchmark((work + "blend() of the curves").c_str(), [=](benchmark::State& state) {
    std::size_t n = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(GC::blend(curves[n % curves.size()], curves[(n + 1) % curves.size()]));
      ++n;
    }
  });
  benchmark::RegisterBenchmark((work + "their jets alone").c_str(), [=](benchmark::State& state) {
    std::size_t n = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(curves[n % curves.size()].jet(Exact(1), 2));
      benchmark::DoNotOptimize(curves[(n + 1) % curves.size()].jet(Exact(0), 2));
      ++n;
    }
  });
}

int main(int argc, char** argv) {
  add_strategy("Minimal_second_derivative", GC::Minimal_second_derivative());
  add_strategy("Matching_second_derivative", GC::Matching_second_derivative());
  add_strategy("Near_line", GC::Near_line());
  add_strategy("Minimal_energy<2>", GC::Minimal_energy<2>());
  add_strategy("Minimal_energy<3>", GC::Minimal_energy<3>());
  add_strategy("Sequential_f3", GC::Sequential_f3());
  add_curves();
  return run_benchmarks(argc, argv);
}
