// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ADAPTIVE_QUADRATURE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ADAPTIVE_QUADRATURE_H

#include <CGAL/Geometric_continuity/Error.h>

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Two integrals over a curve, of functions that are not negative: its length and another one. By Gauss's quadrature on
// intervals that are halved until the halves say the same as the whole.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The integrals over all pieces. An integrand returns both functions for a parameter in [0, 1]; an infinite value is allowed.
template <class Integrand> class Adaptive_quadrature {
  typedef std::array<double, 2> Values;

  struct Part {
    std::size_t piece;
    double a, b;
    Values left, right; // the integrals over both halves
    Values error;       // how far they are from that over the whole
  };

  static constexpr double precision = 1e-8; // relative, of both integrals
  static constexpr double least = 1e-24;    // the second integral is not distinguished from 0 below this
  static constexpr double shortest_part =
      0x1p-20; // where it is still in doubt on such a part of a piece, it is infinite
  static constexpr std::size_t most_parts = 1000; // and twice as many as there are pieces

  const std::vector<Integrand>& pieces_;
  std::vector<Part> parts_;

public:
  explicit Adaptive_quadrature(const std::vector<Integrand>& pieces) : pieces_(pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) add(parts_, i, 0, 1, gauss(i, 0, 1));
  }

  // The second integral may be infinite. Throws Error `work_limit` when too many parts are needed.
  Values operator()() {
    for (;;) {
      const Values total = sums(), share = {precision * total[0] / static_cast<double>(parts_.size()),
                                            precision * total[1] / static_cast<double>(parts_.size()) + least};
      std::vector<Part> finer;
      for (const Part& part : parts_) {
        if (part.error[0] <= share[0] && part.error[1] <= share[1]) {
          finer.push_back(part);
          continue;
        }
        if (part.b - part.a < shortest_part) return {total[0], std::numeric_limits<double>::infinity()};
        const double middle = (part.a + part.b) / 2;
        add(finer, part.piece, part.a, middle, part.left);
        add(finer, part.piece, middle, part.b, part.right);
      }
      if (finer.size() == parts_.size()) return total;
      if (finer.size() > most_parts + 2 * pieces_.size()) throw Error(Error_code::work_limit, "fairness of a curve");
      parts_ = std::move(finer);
    }
  }

private:
  Values sums() const {
    Values sum{};
    for (const Part& part : parts_)
      for (int k = 0; k < 2; ++k) sum[k] += part.left[k] + part.right[k];
    return sum;
  }

  void add(std::vector<Part>& parts, std::size_t piece, double a, double b, const Values& whole) const {
    const double middle = (a + b) / 2;
    Part part{piece, a, b, gauss(piece, a, middle), gauss(piece, middle, b), {}};
    for (int k = 0; k < 2; ++k) {
      part.error[k] = std::abs(part.left[k] + part.right[k] - whole[k]);
      if (std::isnan(part.error[k])) part.error[k] = std::numeric_limits<double>::infinity();
    }
    parts.push_back(part);
  }

  Values gauss(std::size_t piece, double a, double b) const {
    typedef boost::math::quadrature::gauss<double, 10> Rule; // its nodes on one side of 0, in [-1, 1]
    const double middle = (a + b) / 2, half = (b - a) / 2;
    Values sum{};
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      for (double x : {-Rule::abscissa()[i], Rule::abscissa()[i]}) {
        const Values values = pieces_[piece](middle + half * x);
        for (int k = 0; k < 2; ++k) sum[k] += half * Rule::weights()[i] * values[k];
      }
    return sum;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ADAPTIVE_QUADRATURE_H
