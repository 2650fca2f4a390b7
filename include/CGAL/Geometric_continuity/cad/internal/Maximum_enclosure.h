// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_MAXIMUM_ENCLOSURE_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_MAXIMUM_ENCLOSURE_H

#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// \file Maximum_enclosure.h
/// The largest value of a function on a range of parameters by branch and bound: always the part
/// with the largest upper bound is halved.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Bounds of a function on a range, and a parameter where it is at least `lower`.
struct Bounds_on_range {
  double lower, upper, parameter;
  bool defined;       // otherwise nothing is known
  bool noisy = false; // at that parameter alone the bounds are not much closer
  bool knots = false; // a surface may have a knot line within the range
  double least = 0;   // a lower bound on the whole range
};

// When bounds are narrow enough, see `Edge_precision`: by a function that rises, such as the root
// of a square.
struct Largest_options {
  double relative, floor;
  double (*measure)(double);
  int ranges;      // the most that are evaluated, and eight for each of those to begin with
  int most_ranges; // but not more than these

  bool narrow(double lower, double upper) const {
    const double y = measure(upper);
    // unreachable: by rounding only, of squares next to the largest number
    return y <= floor || (std::isfinite(y) && y - measure(lower) <= relative * y);
  }
};

// Ranges in order, those that touch as one.
inline std::vector<std::pair<double, double>> united(std::vector<std::pair<double, double>> ranges) {
  std::sort(ranges.begin(), ranges.end());
  std::vector<std::pair<double, double>> result;
  for (const std::pair<double, double>& r : ranges)
    if (!result.empty() && r.first <= result.back().second)
      result.back().second = (std::max)(result.back().second, r.second);
    else
      result.push_back(r);
  return result;
}

class Maximum_enclosure {
  struct Part : Range { // of the parameter
    double bound;       // from above, of the function
    bool defined, knots;
    int idle; // so many halvings in succession have gained little: rounding errors prevail
    bool operator<(const Part& other) const {
      return bound != other.bound ? bound < other.bound : length() < other.length();
    }
  };
  Largest_first<Part> parts_;
  double settled_ = 0; // the largest bound of parts that are not halved any more

public:
  double lower = 0, upper = 0, parameter;
  double upper_at;      // in the middle of the part with the largest bound
  bool defined = false; // somewhere
  int evaluated = 0;
  // more ranges were needed than may be evaluated
  bool exhausted = false;
  std::vector<std::pair<double, double>> undefined;  // points where the function is not defined
  std::vector<std::pair<double, double>> unresolved; // where nothing is known

  // Encloses the maximum on the ranges between successive numbers of `ends`. Parts where the
  // function is not defined are halved until they are tiny, and in them it is proved that it is
  // not: is_undefined(from, to). So are those with knot lines, unless the bounds are narrow with
  // them: where a surface itself is not smooth, which of its pieces meets which of the other is not
  // known.
  template <class Evaluate, class Is_undefined>
  Maximum_enclosure(const std::vector<double>& ends, const Largest_options& options, const Evaluate& evaluate,
                    const Is_undefined& is_undefined)
      : parameter(ends.front()), upper_at(ends.front()) {
    const double length = ends.back() - ends.front();
    const int ranges = static_cast<int>(
        (std::min)(double(options.most_ranges), double(options.ranges) + 8 * static_cast<double>(ends.size())));
    // parts where it is proved that the function is not defined begin there
    std::vector<double> points;
    const auto add = [&](double from, double to, const Part* parent) {
      const Bounds_on_range b = evaluate(from, to);
      ++evaluated;
      if (b.defined && (!defined || lower < b.lower)) {
        lower = b.lower;
        parameter = b.parameter;
      }
      defined = defined || b.defined;
      Part part{{from, to},
                // unreachable: an error of the package itself: a bound that is not a number
                b.defined && b.upper >= 0 ? b.upper : (std::numeric_limits<double>::infinity)(),
                b.defined,
                b.knots,
                0};
      if (parent && part.defined) { // the bound of one where it is not defined is infinite
        part.bound = (std::min)(part.bound, parent->bound);
        part.idle = b.noisy && part.bound - lower > 0.9 * (parent->bound - lower) ? parent->idle + 1 : 0;
      }
      parts_.add(part);
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if (evaluated < ranges)
        add(ends[i], ends[i + 1], nullptr);
      else {
        unresolved.emplace_back(ends[i], ends.back());
        break;
      }
    if (ends.size() == 1) add(ends[0], ends[0], nullptr);
    const double tiny = length * 0x1p-20, crossing = length * 0x1p-36;
    int undefined_halvings = 0;
    const auto examine = [&](const Part& part) {
      if (part.defined && (part.bound <= settled_ || options.narrow(lower, part.bound))) return After_part::stop;
      if (evaluated >= ranges) return After_part::stop;
      if (part.knots && part.length() <= crossing) {
        undefined.emplace_back(part.lower, part.upper);
        points.push_back(part.lower);
        return After_part::drop;
      }
      if (!part.defined && (!part.is_divisible() || part.length() <= tiny)) {
        const bool is_point = is_undefined(part.lower, part.upper);
        if (is_point || !part.is_divisible() || part.length() <= length * 0x1p-48 || undefined_halvings >= ranges / 8) {
          undefined.emplace_back(part.lower, part.upper);
          if (is_point) points.push_back(part.lower);
          return After_part::drop;
        }
      } else if (!part.defined && undefined_halvings >= ranges / 8) {
        undefined.emplace_back(part.lower, part.upper);
        exhausted = true;
        return After_part::drop;
      }
      if (!part.is_divisible() || part.idle >= 6) {
        raise(settled_, part);
        return After_part::drop;
      }
      undefined_halvings += !part.defined;
      return After_part::divide;
    };
    subdivide(parts_, examine, [&](const Part& part) {
      add(part.lower, part.middle(), &part);
      add(part.middle(), part.upper, &part);
    });
    upper = settled_;
    for (const Part& part : parts_)
      if (part.defined)
        raise(upper, part);
      else
        undefined.emplace_back(part.lower, part.upper);
    upper = (std::max)(upper, lower);
    exhausted = exhausted || evaluated >= ranges;
    divide_undefined(points, length * 0x1p-18);
  }

private:
  void raise(double& bound, const Part& part) {
    if (!(bound < part.bound)) return;
    bound = part.bound;
    upper_at = part.middle();
  }

  // Ranges are points when they are as short as these, and hold a point where it is proved that the
  // function is not defined.
  void divide_undefined(const std::vector<double>& points, double longest) {
    std::vector<std::pair<double, double>> all;
    all.swap(undefined);
    for (const auto& [begin, end] : united(std::move(all))) {
      const auto in_range = [&, first = begin, last = end](double t) { return first <= t && t <= last; };
      const bool is_point = end - begin <= longest && std::any_of(points.begin(), points.end(), in_range);
      (is_point ? undefined : unresolved).emplace_back(begin, end);
    }
    unresolved = united(std::move(unresolved));
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_MAXIMUM_ENCLOSURE_H
