// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_DIVIDED_DIFFERENCES_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_DIVIDED_DIFFERENCES_H

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class Ring> Ring exact_quotient(const Ring& x, const Ring& y) { return Ring(CGAL::integral_division(x, y)); }

// The divided differences c_i = n_i / d_i of rational numbers in place, without a greatest common divisor of long numbers:
// those of the next order are (c_i - c_{i-1}) / l_i. Fractions are not cancelled, but the quotients d_i / d_{i-1} = a_i / b_i
// of neighbours are kept and cancelled, which are much shorter than the d_i: the least common denominator of two neighbours is
// d_i b_i, and n_i b_i - n_{i-1} a_i stands over it.
template <class FT> class Divided_differences {
  typedef typename Common_denominator<FT>::Ring Ring;
  struct Entry {
    Ring n, d;
    Ring a = Ring(1), b = Ring(1);
    Ring factor = Ring(1); // of d in the last round
  };
  std::vector<Entry> c_;
  Work_meter& work_;

public:
  Divided_differences(const std::vector<FT>& c, Work_meter& work) : work_(work) {
    for (const FT& x : c) {
      Entry e;
      e.d = Common_denominator<FT>::denominator_of(x);
      e.n = Common_denominator<FT>(e.d).numerator(x);
      if (!c_.empty()) set_quotient(e, e.d, c_.back().d);
      c_.push_back(std::move(e));
    }
  }

  FT operator[](int i) const { return FT(FT(c_[i].n) / FT(c_[i].d)); }

  // The next order for the indices from `first` on. Those with length(i) = 0 are left out.
  template <class Length> void next(int first, Length length) {
    for (std::size_t i = first; i < c_.size(); ++i) {
      const Ring l = length(static_cast<int>(i));
      c_[i].factor = l == Ring(0) ? Ring(1) : Ring(c_[i].b * l);
    }
    for (std::size_t i = c_.size() - 1; i >= static_cast<std::size_t>(first); --i) {
      Entry &x = c_[i], &left = c_[i - 1];
      if (length(static_cast<int>(i)) != Ring(0)) {
        work_.charge_products(3, number_words(x.d), number_words(x.factor));
        x.n = Ring(x.n * x.b - left.n * x.a);
        x.d *= x.factor;
      }
      if (i > static_cast<std::size_t>(first)) set_quotient(x, Ring(x.a * x.factor), Ring(x.b * left.factor));
    }
  }

private:
  void set_quotient(Entry& x, const Ring& a, const Ring& b) {
    const Ring common(CGAL::gcd(a, b));
    x.a = exact_quotient(a, common);
    x.b = exact_quotient(b, common);
    work_.charge_divisors(1, number_words(a), number_words(b));
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_DIVIDED_DIFFERENCES_H
